!> Schema of a deck: the kinds of groups, keys and values. The tables themselves are in dg_deck_keys; checking, conversion of units
!> and documentation all read the same tables.
module dg_deck_schema
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_unit_kind, only: unit_factor, unit_label, unit_none
   use dg_units, only: si_units, unit_system_type
   use dg_text, only: to_text, joined
   implicit none
   private
   public :: group_rule_type, key_rule_type, range_text, hold_in_range, legal_range, rule_place, split_words, listed
   public :: group_keys_type, add_group, group_place
   public :: kind_text, kind_real, kind_integer, kind_logical
   public :: name_length

   integer, parameter :: kind_text = 1
   integer, parameter :: kind_real = 2
   integer, parameter :: kind_integer = 3
   integer, parameter :: kind_logical = 4

   !> Part of the end of a range by which a number may be beyond it [-]: --convert writes numbers to 1e-7.
   real(wp), parameter :: range_round_off = 2.0e-7_wp

   integer, parameter :: name_length = 32
   integer, parameter :: words_length = 120

   type :: group_rule_type
      character(name_length) :: name = ''
      logical :: repeatable = .false.
      logical :: required = .false.
      logical :: own_cases = .false.         !< it has load cases of its own: a deck with it needs no &load_case
      integer :: most = 100000               !< groups of this name that a deck may have, where they are repeatable
      character(words_length) :: meaning = ''
   end type group_rule_type

   type :: key_rule_type
      character(name_length) :: group = ''
      character(name_length) :: key = ''
      integer :: kind = kind_real
      integer :: unit = unit_none
      logical :: array = .false.
      logical :: required = .false.
      character(24) :: default = ''          !< as in a deck with SI units; '': none
      real(wp) :: low = missing              !< least legal value, in deck units of SI
      real(wp) :: high = missing             !< greatest legal value, in deck units of SI
      logical :: open = .false.              !< the least value itself is not legal
      character(words_length) :: choices = ''!< legal names, blanks between them; '': any text
      character(words_length) :: meaning = ''
   end type key_rule_type

   !> Significant digits of a bound in a message: a rounded bound is easier to read than 15 digits of feet.
   integer, parameter :: bound_digits = 5

   !> A group with its keys.
   type :: group_keys_type
      type(group_rule_type) :: rule
      type(key_rule_type), allocatable :: keys(:)
   end type group_keys_type

contains

   !> Add a group to those that a deck may have.
   subroutine add_group(groups, rule, keys)
      type(group_keys_type), allocatable, intent(inout) :: groups(:)
      type(group_rule_type), intent(in) :: rule
      type(key_rule_type), intent(in) :: keys(:)
      type(group_keys_type), allocatable :: longer(:)
      integer :: n
      n = size(groups)
      allocate (longer(n + 1))
      longer(:n) = groups
      longer(n + 1)%rule = rule
      allocate (longer(n + 1)%keys, source=keys)
      call move_alloc(longer, groups)
   end subroutine add_group

   !> Place of a group among those that a deck may have, 0 for an unknown name.
   pure function group_place(groups, name) result(place)
      type(group_keys_type), intent(in) :: groups(:)
      character(*), intent(in) :: name
      integer :: place
      do place = 1, size(groups)
         if (groups(place)%rule%name == name) return
      end do
      place = 0
   end function group_place

   !> Place of a key in a table of rules, 0 for an unknown name.
   pure function rule_place(rules, key) result(place)
      type(key_rule_type), intent(in) :: rules(:)
      character(*), intent(in) :: key
      integer :: place
      do place = 1, size(rules)
         if (rules(place)%key == key) return
      end do
      place = 0
   end function rule_place

   !> Legal range of a key in words, in the deck's units: '> 0 mm', '0 to 180 deg'.
   pure function range_text(rule, units) result(text)
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units  !< of the deck
      character(:), allocatable :: text
      real(wp) :: scale
      logical :: has_low, has_high
      scale = unit_factor(si_units(), rule%unit)/unit_factor(units, rule%unit)
      has_low = .not. is_missing(rule%low)
      has_high = .not. is_missing(rule%high)
      text = ''
      if (has_low .and. has_high .and. .not. rule%open) then
         text = to_text(rule%low*scale, bound_digits)//' to '//to_text(rule%high*scale, bound_digits)
      else
         if (has_low .and. rule%open) text = '> '//to_text(rule%low*scale, bound_digits)
         if (has_low .and. .not. rule%open) text = '>= '//to_text(rule%low*scale, bound_digits)
         if (has_low .and. has_high) text = text//' and '
         if (has_high) text = text//'<= '//to_text(rule%high*scale, bound_digits)
      end if
      if (text /= '' .and. rule%unit /= unit_none) text = text//' '//unit_label(units, rule%unit)
   end function range_text

   !> Check that a number is in the range of its key. A number beyond it by the round-off of a conversion becomes the end of the
   !> range.
   pure subroutine hold_in_range(rule, number, holds)
      type(key_rule_type), intent(in) :: rule
      real(wp), intent(inout) :: number            !< [SI]
      logical, intent(out) :: holds
      real(wp) :: scale
      scale = unit_factor(si_units(), rule%unit)
      holds = .true.
      if (.not. is_missing(rule%low)) then
         if (rule%open) holds = number/scale > rule%low
         if (.not. holds) return
         if (number/scale < rule%low) then
            holds = rule%low - number/scale <= range_round_off*abs(rule%low)
            if (holds) number = rule%low*scale
            return
         end if
      end if
      if (is_missing(rule%high)) return
      if (number/scale > rule%high) then
         holds = number/scale - rule%high <= range_round_off*abs(rule%high)
         if (holds) number = rule%high*scale
      end if
   end subroutine hold_in_range

   !> Least and greatest legal value of a key [SI].
   pure function legal_range(rule) result(range)
      type(key_rule_type), intent(in) :: rule
      real(wp) :: range(2)
      range = [-huge(1.0_wp), huge(1.0_wp)]
      if (.not. is_missing(rule%low)) range(1) = rule%low*unit_factor(si_units(), rule%unit)
      if (.not. is_missing(rule%high)) range(2) = rule%high*unit_factor(si_units(), rule%unit)
   end function legal_range

   !> The words of a text with blanks between them.
   pure subroutine split_words(text, words)
      character(*), intent(in) :: text
      character(name_length), allocatable, intent(out) :: words(:)
      integer :: at, length, n, pass
      do pass = 1, 2             ! first count, then take
         n = 0
         at = 1
         do while (at <= len_trim(text))
            length = index(text(at:)//' ', ' ') - 1
            if (length > 0) then
               n = n + 1
               if (pass == 2) words(n) = text(at:at + length - 1)
            end if
            at = at + length + 1
         end do
         if (pass == 1) allocate (words(n))
      end do
   end subroutine split_words

   !> The words of a text as a list with commas.
   pure function listed(text) result(list)
      character(*), intent(in) :: text
      character(:), allocatable :: list
      character(name_length), allocatable :: words(:)
      call split_words(text, words)
      list = joined(words, ', ')
   end function listed
end module dg_deck_schema

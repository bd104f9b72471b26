!> Advice on numbers of a deck that are written as people write them: 8-1/2, 5", 135 ksi; or in a unit of another name: psi, lbf.
module dg_value_advice
   use dg_deck_number, only: read_fraction, read_real
   use dg_deck_schema, only: hold_in_range, key_rule_type, kind_real, kind_text
   use dg_kinds, only: wp
   use dg_text, only: lower_case, to_text
   use dg_unit_kind, only: smaller_unit, unit_factor, unit_label, unit_none
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: unit_advice, value_advice

   !> Significant digits of a number that is advised.
   integer, parameter :: digits_told = 7
   integer, parameter :: longest_name = 20
   character(*), parameter :: digits = '0123456789'

contains

   !> What to write for a text that is no number, with '; ' before it; '' where nothing is known.
   pure function value_advice(text, rule, units) result(advice)
      character(*), intent(in) :: text             !< as in the deck; several values with blanks between them
      type(key_rule_type), intent(in) :: rule      !< of the key
      type(unit_system_type), intent(in) :: units  !< of the deck
      character(:), allocatable :: advice
      real(wp) :: number
      logical :: legal
      integer :: length
      advice = ''
      if (rule%kind == kind_text) return
      call read_fraction(without_mark(text), number, legal)
      if (legal) then
         advice = '; write '//to_text(number, digits_told)
         return
      end if
      ! a number with its unit behind
      length = verify(text, digits//'.+-') - 1
      if (length < 1) return
      call read_real(text(:length), number, legal)
      if (.not. legal .or. verify(text(length + 1:length + 1), ' ''"#%') > 0 .and. &
          scan(lower_case(text(length + 1:length + 1)), 'abcdefghijklmnopqrstuvwxyz') == 0) return
      advice = '; write the number alone'
      if (rule%unit /= unit_none) advice = advice//'; its unit is '//trim(unit_label(units, rule%unit))
   end function value_advice

   !> What to write for a number out of its range that would be legal in a smaller unit.
   pure function unit_advice(text, rule, units) result(advice)
      character(*), intent(in) :: text
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: advice
      character(longest_name) :: smaller
      real(wp) :: number, held, of_them
      logical :: legal
      advice = ''
      if (rule%kind /= kind_real) return
      call smaller_unit(units, rule%unit, smaller, of_them)
      if (smaller == '') return
      call read_real(text, number, legal)
      if (.not. legal) return
      number = number/of_them
      held = number*unit_factor(units, rule%unit)
      call hold_in_range(rule, held, legal)
      if (legal) advice = '; '//text//' '//trim(smaller)//' is written '//to_text(number, digits_told)
   end function unit_advice

   !> A text without a mark of inches at its end, in quotes or as a word.
   pure function without_mark(text) result(bare)
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      integer :: last
      last = len_trim(text)
      if (last > 2) then
         if (lower_case(text(last - 1:last)) == 'in') last = len_trim(text(:last - 2))
      end if
      if (last > 1) then
         if (scan(text(last:last), '"''') == 1) last = len_trim(text(:last - 1))
      end if
      bare = text(:last)
   end function without_mark
end module dg_value_advice

!> A setting of a record that has changed, in words, in the units of the deck.
module dg_told_setting
   use dg_kinds, only: wp
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: key_rule_type, rule_place
   use dg_text, only: to_text
   use dg_unit_kind, only: unit_angle, unit_factor, unit_label, unit_length, unit_none, unit_rotation, unit_speed
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: told

   !> Digits of a number in another unit than that of the record: its round-off is not shown.
   integer, parameter :: digits = 8

contains

   !> `key was ... and is ...`. Numbers of a record are SI; those of a known quantity are told in the deck's units.
   pure function told(key, then, now, units) result(words)
      character(*), intent(in) :: key                         !< as dg_model_text writes it
      character(*), intent(in) :: then, now                   !< values as text
      type(unit_system_type), intent(in), optional :: units   !< not there: as in the record
      character(:), allocatable :: words
      character(:), allocatable :: label
      real(wp) :: factor, before, after
      integer :: cut, status, unit
      words = key//' was '//then//' and is '//now
      if (.not. present(units)) return
      cut = index(key, ' ', back=.true.)
      unit = unit_of(key(cut + 1:))
      if (unit == unit_none) return
      read (then, *, iostat=status) before
      if (status /= 0) return
      read (now, *, iostat=status) after
      if (status /= 0) return
      factor = unit_factor(units, unit)
      label = unit_label(units, unit)
      ! a unit stands behind a comma in some keys
      words = key
      if (cut > 2 .and. scan(key(cut + 1:), '/') + index(' m rad ', ' '//key(cut + 1:)//' ') > 0) words = key(:cut - 2)
      words = words//' was '//to_text(before/factor, digits)//' '//label//' and is '//to_text(after/factor, digits)//' '//label
   end function told

   !> The unit that a deck has for a quantity: that of its key. None where the record's own is the deck's.
   pure function unit_of(word) result(unit)
      character(*), intent(in) :: word                        !< the last of a key
      integer :: unit
      character(*), parameter :: groups(6) = [character(11) :: 'hole', 'fluid', 'component', 'centralizer', 'boundary', 'load_case']
      type(key_rule_type), allocatable :: rules(:)
      integer :: i, k
      select case (word)
      case ('m'); unit = unit_length
      case ('rad'); unit = unit_angle
      case ('rad/s'); unit = unit_rotation
      case ('m/s'); unit = unit_speed
      case default; unit = unit_none
      end select
      do i = 1, size(groups)
         rules = keys_of(trim(groups(i)))
         k = rule_place(rules, word)
         if (k > 0) unit = rules(k)%unit
      end do
   end function unit_of
end module dg_told_setting

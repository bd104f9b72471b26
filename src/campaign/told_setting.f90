!> A setting of a record that has changed, in words, in the units of the deck.
module dg_told_setting
   use dg_kinds, only: wp
   use dg_text, only: to_text
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
      integer :: cut, status
      words = key//' was '//then//' and is '//now
      if (.not. present(units)) return
      cut = index(key, ' ', back=.true.)
      call find_unit(units, key(cut + 1:), factor, label)
      if (label == '') return
      read (then, *, iostat=status) before
      if (status /= 0) return
      read (now, *, iostat=status) after
      if (status /= 0) return
      ! a unit stands behind a comma in some keys
      words = key
      if (cut > 2 .and. scan(key(cut + 1:), '/') + index(' m rad ', ' '//key(cut + 1:)//' ') > 0) words = key(:cut - 2)
      words = words//' was '//to_text(before/factor, digits)//' '//label//' and is '//to_text(after/factor, digits)//' '//label
   end function told

   !> The deck's unit of a quantity: what a word of the record stands for; label '' where it has none, or the record's own.
   pure subroutine find_unit(units, word, factor, label)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: word                        !< the last of a key
      real(wp), intent(out) :: factor                         !< SI value of the unit
      character(:), allocatable, intent(out) :: label
      logical :: field
      field = units%name == 'field'
      factor = 1.0_wp
      label = ''
      select case (word)
      case ('wob', 'restoring_force', 'running_force')
         factor = units%force
         label = trim(merge('klbf', 'kN  ', field))
      case ('tob')
         factor = units%moment
         label = trim(merge('kft.lbf', 'kN.m   ', field))
      case ('diameter', 'od', 'id', 'joint_od', 'rated_hole', 'mud_sheath')
         factor = units%diameter
         label = merge('in', 'mm', field)
      case ('md_top', 'md_bottom', 'above_bit', 'length', 'joint_length', 'joint_spacing', 'spacing', 'first', &
            'bend_position', 'm')
         factor = units%length
         label = trim(merge('ft', 'm ', field))
      case ('mass')
         factor = units%mass_per_length
         label = trim(merge('lbm/ft', 'kg/m  ', field))
      case ('density')
         factor = units%density
         label = trim(merge('lbm/gal', 'kg/m3  ', field))
      case ('youngs')
         factor = units%modulus
         label = trim(merge('1e6 psi', 'GPa    ', field))
      case ('wall_stiffness')
         factor = units%wall_stiffness
         label = trim(merge('klbf/ft2', 'kN/m2   ', field))
      case ('bend', 'rad')
         factor = units%angle
         label = 'deg'
      case ('rad/s')
         factor = units%rotation_speed
         label = 'rpm'
      case ('m/s')
         factor = units%trip_speed
         label = trim(merge('ft/s', 'm/s ', field))
      case default
      end select
   end subroutine find_unit
end module dg_told_setting

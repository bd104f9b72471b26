!> The system of units that a deck is written in, by its hole diameters and mud weights. A deck read in another one gives
!> many faults, and advice on each of them leads astray.
module dg_meant_units
   use dg_deck_number, only: read_real
   use dg_deck_text, only: group_type
   use dg_error, only: add_fault, error_list_type
   use dg_kinds, only: wp
   use dg_quantity, only: system_field, system_metric, system_name, system_si
   use dg_text, only: to_text
   use dg_unit_kind, only: unit_density, unit_diameter, unit_force, unit_label, unit_length
   use dg_units, only: system_of, unit_system_type
   implicit none
   private
   public :: check_units, deepest_model

   !> Hole diameters in inches and in millimetres. Slim holes of 37 mm and more are cored in air, tubing of 41 mm holds gas.
   real(wp), parameter :: inches(2) = [3.0_wp, 36.5_wp], millimetres(2) = [50.0_wp, 1300.0_wp]
   !> Deeper than any hole of a laboratory, whose holes may have 10 mm and be filled with air [m].
   real(wp), parameter :: deepest_model = 100.0_wp
   !> Mud weights in lbm/gal, sg and kg/m3. Oil has 0.78 sg.
   real(wp), parameter :: pounds(2) = [5.0_wp, 24.0_wp], gravities(2) = [0.7_wp, 2.8_wp], kilograms(2) = [700.0_wp, 2800.0_wp]

contains

   !> Check that all hole diameters and mud weights are not those of another system than the deck's.
   subroutine check_units(path, groups, units, known, faults)
      character(*), intent(in) :: path
      type(group_type), intent(in) :: groups(:)
      type(unit_system_type), intent(in) :: units
      logical, intent(inout) :: known           !< false if they are
      type(error_list_type), intent(inout) :: faults
      type(unit_system_type) :: meant
      real(wp), allocatable :: diameters(:), densities(:)
      integer :: i, line, system
      logical :: millimetric
      allocate (diameters, source=numbers_of(groups, 'hole', 'diameter'))
      allocate (densities, source=numbers_of(groups, 'fluid', 'density'))
      densities = pack(densities, densities > 0.0_wp)
      if (min(size(diameters), size(densities)) == 0) return
      if (.not. any(numbers_of(groups, 'hole', 'md_bottom') > deepest_model)) return
      millimetric = units%system == system_si
      system = 0
      if (millimetric .and. within(diameters, inches) .and. within(densities, pounds)) system = system_field
      if (millimetric .and. within(diameters, inches) .and. within(densities, gravities)) system = system_metric
      if (.not. millimetric .and. within(diameters, millimetres) .and. within(densities, kilograms)) system = system_si
      if (system == 0) return
      known = .false.
      meant = system_of(system)
      line = 1
      do i = size(groups), 1, -1
         if (groups(i)%name == 'job') line = groups(i)%line
      end do
      call add_fault(faults, path, line, 'group &job: the deck is read in units '//trim(units%name)//', its numbers look like '// &
         trim(system_name(system))//': a hole of '//to_text(diameters(1))//' '//unit_label(meant, unit_diameter)//', mud of '// &
         to_text(densities(1))//' '//unit_label(meant, unit_density)//". Write units = '"//trim(system_name(system))// &
         "' in &job. Depths are then in "//unit_label(meant, unit_length)//', forces in '//unit_label(meant, unit_force))
   end subroutine check_units

   !> True if all numbers are within a range.
   pure function within(numbers, range) result(are)
      real(wp), intent(in) :: numbers(:), range(2)
      logical :: are
      are = all(numbers >= range(1) .and. numbers <= range(2))
   end function within

   !> The first number of a key in each of its groups; one that cannot be read is left out.
   pure function numbers_of(groups, name, key) result(numbers)
      type(group_type), intent(in) :: groups(:)
      character(*), intent(in) :: name, key
      real(wp), allocatable :: numbers(:)
      real(wp) :: number
      logical :: legal
      integer :: i, k
      allocate (numbers(0))
      do i = 1, size(groups)
         if (groups(i)%name /= name) cycle
         do k = 1, size(groups(i)%entries)
            associate (entry => groups(i)%entries(k))
               if (entry%key /= key .or. size(entry%values) == 0) cycle
               call read_real(entry%values(1)%text, number, legal)
               if (legal) numbers = [numbers, number]
            end associate
         end do
      end do
   end function numbers_of
end module dg_meant_units

!> The system of units that a deck is written in, by its hole diameters, mud weights and pipe. A deck read in another one gives
!> many faults, and advice on each of them leads astray.
module dg_meant_units
   use dg_component, only: tube_area
   use dg_constants, only: inch, steel_density
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
   real(wp), parameter :: inches(2) = [3.0_wp, 36.5_wp], millimetres(2) = [50.0_wp, 1550.0_wp]
   !> Widest conductor, whose hole may stand above those [in].
   real(wp), parameter :: widest_conductor = 60.0_wp
   !> Deeper than any hole of a laboratory, whose holes may have 10 mm and be filled with air [m].
   real(wp), parameter :: deepest_model = 100.0_wp
   !> Mud weights in lbm/gal, sg and kg/m3. Oil has 0.78 sg.
   real(wp), parameter :: pounds(2) = [5.0_wp, 24.0_wp], gravities(2) = [0.7_wp, 2.8_wp], kilograms(2) = [700.0_wp, 2800.0_wp]
   !> Densest gas over the lightest mud of those ranges [-]. Methane at 700 bar has 250 kg/m3.
   real(wp), parameter :: densest_gas = 0.4_wp
   !> Mass of pipe in kg/m over that of a steel tube of its diameters [-]: as a number of kg/m and of lbm/ft. Tool joints add
   !> up to a half, and 1 kg/m is 0.672 lbm/ft.
   real(wp), parameter :: mass_metric(2) = [1.12_wp, 1.65_wp], mass_field(2) = [0.62_wp, 0.86_wp]
   !> Distance of tool joints in m and ft, yield strength in bar and ksi.
   real(wp), parameter :: spacing_metric(2) = [8.0_wp, 15.0_wp], spacing_field(2) = [26.0_wp, 50.0_wp]
   real(wp), parameter :: yield_metric(2) = [1500.0_wp, 12500.0_wp], yield_field(2) = [22.0_wp, 182.0_wp]
   !> Young's modulus from aluminium to steel in GPa and 1e6 psi, pump pressure while drilling in bar and psi.
   real(wp), parameter :: youngs_metric(2) = [60.0_wp, 260.0_wp], youngs_field(2) = [8.0_wp, 38.0_wp]
   real(wp), parameter :: pump_metric(2) = [50.0_wp, 450.0_wp], pump_field(2) = [700.0_wp, 7500.0_wp]

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
      allocate (diameters, source=numbers_of(groups, 'hole', 'diameter'))
      allocate (densities, source=numbers_of(groups, 'fluid', 'density'))
      densities = pack(densities, densities > 0.0_wp)
      if (min(size(diameters), size(densities)) == 0) return
      if (.not. any([numbers_of(groups, 'hole', 'md_bottom'), numbers_of(groups, 'load_case', 'bit_depth'), &
                     numbers_of(groups, 'trajectory', 'md')] > deepest_model)) return
      system = system_meant(units%system, groups, diameters, densities)
      if (system == units%system) return
      known = .false.
      meant = system_of(system)
      line = 1
      do i = size(groups), 1, -1
         if (groups(i)%name == 'job') line = groups(i)%line
      end do
      call add_fault(faults, path, line, 'group &job: the deck is read in units '//trim(units%name)//', its numbers look like '// &
         trim(system_name(system))//': a hole of '//to_text(diameters(1))//' '//unit_label(meant, unit_diameter)//', mud of '// &
         to_text(maxval(densities))//' '//unit_label(meant, unit_density)//". Write units = '"//trim(system_name(system))// &
         "' in &job. Depths are then in "//unit_label(meant, unit_length)//', forces in '//unit_label(meant, unit_force))
   end subroutine check_units

   !> The system of units that the numbers of a deck look like; that of the deck where they may be right. Field and metric
   !> have holes in inches, and mud may be in another unit alone: there the pipe decides.
   pure function system_meant(read_in, groups, diameters, densities) result(system)
      integer, intent(in) :: read_in
      type(group_type), intent(in) :: groups(:)
      real(wp), intent(in) :: diameters(:), densities(:)     !< as written
      integer :: system
      logical :: in_inches
      system = read_in
      in_inches = any(within(diameters, inches)) .and. all(within(diameters, [inches(1), widest_conductor]))
      select case (read_in)
      case (system_si)
         if (in_inches .and. are_muds(densities, pounds)) system = system_field
         if (in_inches .and. are_muds(densities, gravities)) system = system_metric
      case default
         if (all(within(diameters, millimetres)) .and. are_muds(densities, kilograms)) system = system_si
         if (.not. in_inches) return
         if (are_muds(densities, merge(gravities, pounds, read_in == system_field))) then
            if (system_of_pipe(groups) /= 0) system = system_of_pipe(groups)
         end if
      end select
   end function system_meant

   !> The system, field or metric, that all numbers of pipe and pump which tell are in; 0 where none does, or they differ.
   pure function system_of_pipe(groups) result(system)
      type(group_type), intent(in) :: groups(:)
      integer :: system
      real(wp), allocatable :: od(:), id(:), mass(:)
      logical :: metric, field
      integer :: i
      metric = .false.
      field = .false.
      do i = 1, size(groups)
         od = numbers_of(groups(i:i), 'component', 'od')
         id = numbers_of(groups(i:i), 'component', 'id')
         mass = numbers_of(groups(i:i), 'component', 'mass')
         ! one whose density is given is not of steel
         if (min(size(od), size(id), size(mass)) > 0 .and. size(numbers_of(groups(i:i), 'component', 'density')) == 0) &
            call note_systems(mass/(steel_density*tube_area(od(1)*inch, id(1)*inch)), mass_metric, mass_field, metric, field)
      end do
      call note_systems(numbers_of(groups, 'component', 'joint_spacing'), spacing_metric, spacing_field, metric, field)
      call note_systems(numbers_of(groups, 'component', 'yield'), yield_metric, yield_field, metric, field)
      call note_systems(numbers_of(groups, 'component', 'youngs'), youngs_metric, youngs_field, metric, field)
      call note_systems(numbers_of(groups, 'load_case', 'pump_pressure'), pump_metric, pump_field, metric, field)
      system = 0
      if (metric .and. .not. field) system = system_metric
      if (field .and. .not. metric) system = system_field
   end function system_of_pipe

   !> Notes where numbers are within the range of a system.
   pure subroutine note_systems(numbers, in_metric, in_field, metric, field)
      real(wp), intent(in) :: numbers(:), in_metric(2), in_field(2)
      logical, intent(inout) :: metric, field
      metric = metric .or. any(within(numbers, in_metric))
      field = field .or. any(within(numbers, in_field))
   end subroutine note_systems

   !> True if one number at least is a mud weight of a range, and the others are gas.
   pure function are_muds(densities, range) result(are)
      real(wp), intent(in) :: densities(:), range(2)
      logical :: are
      are = any(within(densities, range)) .and. all(within(densities, range) .or. densities <= densest_gas*range(1))
   end function are_muds

   !> True for a number within a range.
   pure function within(numbers, range) result(is)
      real(wp), intent(in) :: numbers(:), range(2)
      logical :: is(size(numbers))
      is = numbers >= range(1) .and. numbers <= range(2)
   end function within

   !> The numbers of a key in all groups of a name; those that cannot be read are left out.
   pure function numbers_of(groups, name, key) result(numbers)
      type(group_type), intent(in) :: groups(:)
      character(*), intent(in) :: name, key
      real(wp), allocatable :: numbers(:)
      logical, allocatable :: legal(:)
      integer :: i, j, k, n
      allocate (numbers(count_of(groups, name, key)))
      allocate (legal(size(numbers)))
      n = 0
      do i = 1, size(groups)
         if (groups(i)%name /= name) cycle
         do k = 1, size(groups(i)%entries)
            associate (entry => groups(i)%entries(k))
               if (entry%key /= key) cycle
               do j = 1, size(entry%values)
                  n = n + 1
                  call read_real(entry%values(j)%text, numbers(n), legal(n))
               end do
            end associate
         end do
      end do
      numbers = pack(numbers, legal)
   end function numbers_of

   !> Number of values of a key in all groups of a name.
   pure function count_of(groups, name, key) result(number)
      type(group_type), intent(in) :: groups(:)
      character(*), intent(in) :: name, key
      integer :: number
      integer :: i, k
      number = 0
      do i = 1, size(groups)
         if (groups(i)%name /= name) cycle
         do k = 1, size(groups(i)%entries)
            if (groups(i)%entries(k)%key == key) number = number + size(groups(i)%entries(k)%values)
         end do
      end do
   end function count_of
end module dg_meant_units

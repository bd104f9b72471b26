!> Ranges of the numbers of a model. They are those of the table of keys (dg_deck_keys), which a deck's reading also uses. They
!> exclude numbers that cannot be meant, as a diameter in millimetres, not unusual ones.
module dg_range_check
   use dg_centralizer, only: centralizer_type
   use dg_component, only: component_type, visit_forces, visit_ratings
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: hold_in_range, key_rule_type, range_text
   use dg_fatigue_curve, only: fatigue_curve_name, fatigue_curve_type, fatigue_own
   use dg_fluid, only: collar_closed, collar_none, collar_open_below, fluid_type
   use dg_hole_section, only: hole_section_type, visit_hole
   use dg_key_visitor, only: key_visitor_type
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_count, visit_case
   use dg_missing, only: is_mark, is_shown
   use dg_error, only: add_part_fault, error_list_type
   use dg_numerics, only: fidelity_name, gap_location_count, numerics_type, solver_name, visit_numerics
   use dg_rig, only: rig_type, visit_rig
   use dg_text, only: joined, to_text
   use dg_unit_kind, only: in_units, unit_none
   use dg_units, only: base_units
   implicit none
   private
   public :: ranges_type, set_ranges, check_range, is_zero
   public :: check_section_ranges, check_component_ranges, check_centralizer_ranges, check_fluid_ranges, check_case_ranges, &
             check_numerics_ranges, check_numerics, check_rig_ranges

   !> Digits of a number that is out of range.
   integer, parameter :: digits = 9

   !> Ranges of a group's numbers, and the part to which the numbers belong.
   type :: ranges_type
      character(12) :: part                          !< name of the group
      integer :: place = 0                           !< number of the part among those of its kind; 0: there is one
      type(key_rule_type), allocatable :: rules(:)
   end type ranges_type

   !> Checks the ranges of the numbers that it visits.
   type, extends(key_visitor_type) :: range_checker_type
      type(ranges_type) :: ranges
      type(error_list_type), pointer :: found => null()
   contains
      procedure :: number => check_visited
   end type range_checker_type

contains

   !> Check a number of the visited part.
   subroutine check_visited(self, key, value)
      class(range_checker_type), intent(inout) :: self
      character(*), intent(in) :: key
      real(wp), intent(inout) :: value              !< not changed
      if (key == 'rpm') then
         call check_range(self%ranges, key, value, self%found, called='angular_speed')
      else
         call check_range(self%ranges, key, value, self%found)
      end if
   end subroutine check_visited

   !> Set the ranges of the group `part`.
   subroutine set_ranges(part, place, ranges)
      character(*), intent(in) :: part              !< name of a group, and of one of its keys
      integer, intent(in) :: place
      type(ranges_type), intent(out) :: ranges
      ranges%part = part
      ranges%place = place
      allocate (ranges%rules, source=keys_of(part))
   end subroutine set_ranges

   !> Check one number against the ranges of its group.
   subroutine check_range(ranges, key, number, found, called)
      type(ranges_type), intent(in) :: ranges
      character(*), intent(in) :: key
      real(wp), intent(in) :: number                !< [SI]
      type(error_list_type), intent(inout) :: found
      character(*), intent(in), optional :: called  !< name of the number in its type, if it is not the key
      real(wp) :: held
      integer :: k
      logical :: holds
      character(:), allocatable :: needed, range, name, fault
      name = key
      if (present(called)) name = called
      do k = 1, size(ranges%rules)
         if (ranges%rules(k)%key == key) exit
      end do
      if (k > size(ranges%rules)) then
         call add_part_fault(found, ranges%part, ranges%place, key, name//' has no rule among the keys of &'//trim(ranges%part))
         return
      end if
      associate (rule => ranges%rules(k))
         ! checked by its bits first, as comparing a NaN may be trapped
         holds = is_shown(number)
         if (holds) then
            held = number
            call hold_in_range(rule, held, holds)
            if (holds) return
         end if
         needed = '; needs a number'
         range = range_text(rule, base_units())
         if (range /= '') needed = needed//', '//range
         if (.not. is_shown(number)) then
            fault = ' is not a finite number'
         else if (rule%unit == unit_none) then
            fault = ' = '//to_text(number, digits)//' is out of range'
         else
            fault = ' = '//in_units(base_units(), rule%unit, number, digits)//' is out of range'
         end if
      end associate
      call add_part_fault(found, ranges%part, ranges%place, key, name//fault//needed)
   end subroutine check_range

   !> Check a number that may be missing.
   subroutine check_where_there(ranges, key, number, found)
      type(ranges_type), intent(in) :: ranges
      character(*), intent(in) :: key
      real(wp), intent(in) :: number
      type(error_list_type), intent(inout) :: found
      if (.not. is_mark(number)) call check_range(ranges, key, number, found)
   end subroutine check_where_there

   !> Report numbers of a hole section outside the ranges of dg_deck_keys. `place` is its number.
   subroutine check_section_ranges(hole, place, found)
      type(hole_section_type), intent(in) :: hole
      integer, intent(in) :: place
      type(error_list_type), intent(inout), target :: found
      type(range_checker_type) :: checker
      type(hole_section_type) :: visited
      visited = hole
      checker%found => found
      call set_ranges('hole', place, checker%ranges)
      call visit_hole(visited, checker)
   end subroutine check_section_ranges

   !> Check a component in the same way.
   subroutine check_component_ranges(component, place, found)
      type(component_type), intent(in) :: component
      integer, intent(in) :: place
      type(error_list_type), intent(inout), target :: found
      type(range_checker_type) :: checker
      type(component_type) :: visited
      visited = component
      checker%found => found
      call set_ranges('component', place, checker%ranges)
      call visit_forces(visited, checker)
      call visit_ratings(visited, checker)
      call check_fatigue_ranges(checker%ranges, '', component%fatigue, found)
      call check_fatigue_ranges(checker%ranges, 'joint_', component%joint_fatigue, found)
   end subroutine check_component_ranges

   !> Check a fatigue curve of a component in the same way.
   subroutine check_fatigue_ranges(ranges, prefix, fatigue, found)
      type(ranges_type), intent(in) :: ranges
      character(*), intent(in) :: prefix                !< prefix of its keys: 'joint_' of connections, '' of the body
      type(fatigue_curve_type), intent(in) :: fatigue
      type(error_list_type), intent(inout) :: found
      if (fatigue%curve < 1 .or. fatigue%curve > size(fatigue_curve_name)) call add_part_fault(found, ranges%part, ranges%place, &
         prefix//'fatigue_curve', 'curve = '//to_text(fatigue%curve)//' is not a valid fatigue curve')
      if (fatigue%curve == fatigue_own) call check_range(ranges, prefix//'fatigue_limit', fatigue%limit, found)
      call check_range(ranges, 'tensile_strength', fatigue%tensile, found)
      call check_range(ranges, 'fatigue_share', fatigue%share, found)
      call check_range(ranges, prefix//'fatigue_exponent', fatigue%exponent, found)
      call check_range(ranges, prefix//'fatigue_turns', fatigue%turns, found)
   end subroutine check_fatigue_ranges

   !> Check the centralizers of a component in the same way.
   subroutine check_centralizer_ranges(centralizer, place, found)
      type(centralizer_type), intent(in) :: centralizer    !< that is present
      integer, intent(in) :: place
      type(error_list_type), intent(inout) :: found
      type(ranges_type) :: ranges
      call set_ranges('centralizer', place, ranges)
      call check_range(ranges, 'od', centralizer%od, found)
      call check_range(ranges, 'spacing', centralizer%spacing, found)
      call check_range(ranges, 'first', centralizer%first, found)
      if (centralizer%bow) then
         call check_range(ranges, 'restoring_force', centralizer%restoring_force, found)
         call check_range(ranges, 'rated_hole', centralizer%rated_hole, found)
         call check_range(ranges, 'running_force', centralizer%running_force, found)
      end if
      call check_where_there(ranges, 'friction_axial', centralizer%friction_axial, found)
      call check_where_there(ranges, 'friction_rotary', centralizer%friction_rotary, found)
   end subroutine check_centralizer_ranges

   !> Check a fluid in the same way.
   subroutine check_fluid_ranges(fluid, place, found)
      type(fluid_type), intent(in) :: fluid
      integer, intent(in) :: place
      type(error_list_type), intent(inout) :: found
      type(ranges_type) :: ranges
      call set_ranges('fluid', place, ranges)
      call check_range(ranges, 'density', fluid%density, found)
      call check_range(ranges, 'md_top', fluid%md_top, found)
      if (.not. is_zero(fluid%above_bit)) call check_range(ranges, 'above_bit', fluid%above_bit, found)
      call check_range(ranges, 'surface_pressure', fluid%surface_pressure, found)
      if (.not. any(fluid%collar == [collar_none, collar_closed, collar_open_below])) &
         call add_part_fault(found, 'fluid', place, 'float_collar', 'collar = '//to_text(fluid%collar)//' is not a valid collar')
   end subroutine check_fluid_ranges

   !> Check a load case in the same way.
   subroutine check_case_ranges(load_case, found)
      type(load_case_type), intent(in) :: load_case
      type(error_list_type), intent(inout), target :: found
      type(range_checker_type) :: checker
      type(load_case_type) :: visited
      if (load_case%operation < 1 .or. load_case%operation > operation_count) call add_part_fault(found, 'load_case', 0, &
         'operation', 'operation = '//to_text(load_case%operation)//' is not a valid operation; needs a number from 1 to '// &
         to_text(operation_count))
      visited = load_case
      checker%found => found
      call set_ranges('load_case', 0, checker%ranges)
      call visit_case(visited, checker)
   end subroutine check_case_ranges

   !> Check the settings of the solver in the same way.
   subroutine check_numerics_ranges(numerics, found)
      type(numerics_type), intent(in) :: numerics
      type(error_list_type), intent(inout), target :: found
      type(range_checker_type) :: checker
      type(numerics_type) :: visited
      if (numerics%unknown_fidelity /= '') call add_part_fault(found, 'solver', 0, 'fidelity', 'settings_of('// &
         trim(numerics%unknown_fidelity)//') is unknown; legal: '//joined(fidelity_name, ', '))
      visited = numerics
      checker%found => found
      call set_ranges('solver', 0, checker%ranges)
      call visit_numerics(visited, checker)
      call check_choice('gap_location', numerics%gap_location, gap_location_count)
      call check_choice('linear_solver', numerics%linear_solver, size(solver_name))
   contains
      subroutine check_choice(key, number, highest)
         character(*), intent(in) :: key
         integer, intent(in) :: number, highest
         if (number >= 1 .and. number <= highest) return
         call add_part_fault(found, 'solver', 0, key, key//' = '//to_text(number)//' is not valid; '// &
                             'needs a number from 1 to '//to_text(highest))
      end subroutine check_choice
   end subroutine check_numerics_ranges

   !> Check that a free gap yields more than a wall, and an elastic wall at least as much as a rigid one. Contact must begin
   !> before the wall is rigid.
   subroutine check_numerics(numerics, found)
      type(numerics_type), intent(in) :: numerics
      type(error_list_type), intent(inout) :: found
      if (numerics%gk_min >= numerics%gk_contact) call fault('gk_min', 'gk_min must be smaller than gk_contact')
      if (numerics%gk_contact > numerics%gk_max) call fault('gk_max', 'gk_max must be at least gk_contact')
      if (numerics%eps_n0 >= numerics%eps_nmax) call fault('eps_n0', 'eps_n0 must be smaller than eps_nmax')
   contains
      subroutine fault(key, message)
         character(*), intent(in) :: key, message
         call add_part_fault(found, 'solver', 0, key, message)
      end subroutine fault
   end subroutine check_numerics

   !> Report numbers of the rig outside the ranges.
   subroutine check_rig_ranges(rig, found)
      type(rig_type), intent(in) :: rig
      type(error_list_type), intent(inout), target :: found
      type(range_checker_type) :: checker
      type(rig_type) :: visited
      visited = rig
      checker%found => found
      call set_ranges('rig', 0, checker%ranges)
      call visit_rig(visited, checker)
   end subroutine check_rig_ranges

   !> True if a number is 0; false for a NaN.
   pure function is_zero(number) result(yes)
      real(wp), intent(in) :: number
      logical :: yes
      yes = is_shown(number)
      if (yes) yes = abs(number) <= 0.0_wp
   end function is_zero
end module dg_range_check

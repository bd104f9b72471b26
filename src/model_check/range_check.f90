!> Ranges of the numbers of a model. They are those of the table of keys (dg_deck_keys), which a deck's reading goes by, too:
!> they keep out what cannot be meant, as a diameter in millimetres, not what is unusual.
module dg_range_check
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_centralizer, only: centralizer_type
   use dg_component, only: component_type
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: hold_in_range, key_rule_type, range_text
   use dg_fluid, only: collar_closed, collar_none, collar_open_below, fluid_type
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_count, optional_real
   use dg_missing, only: is_missing, is_shown, missing
   use dg_model_fault, only: model_faults_type, note_fault
   use dg_numerics, only: gap_location_count, numerics_type, solver_name
   use dg_rig, only: rig_type
   use dg_text, only: to_text
   use dg_unit_kind, only: unit_factor, unit_label, unit_none
   use dg_units, only: si_units, unit_system_type
   implicit none
   private
   public :: check_number, is_zero, check_section_ranges, check_component_ranges, check_centralizer_ranges, check_fluid_ranges, &
             check_case_ranges, check_numerics_ranges, check_rig_ranges

   !> Digits of a number that is out of range, and a wall left by wear that no class has less of.
   integer, parameter :: digits = 9
   real(wp), parameter :: thinnest = 0.1_wp
   integer(int64), parameter :: no_bits = 0_int64

contains

   !> One number against the range of its key.
   subroutine check_number(part, place, key, number, units, found, called)
      character(*), intent(in) :: part              !< name of a group, and of one of its keys
      integer, intent(in) :: place
      character(*), intent(in) :: key
      real(wp), intent(in) :: number                !< [SI]
      type(unit_system_type), intent(in) :: units   !< of messages
      type(model_faults_type), intent(inout) :: found
      character(*), intent(in), optional :: called  !< name of the number in its type, where that is not the key
      type(key_rule_type), allocatable :: rules(:)
      allocate (rules, source=keys_of(part))
      call check_by(rules, part, place, key, number, units, found, called)
   end subroutine check_number

   !> The same where the rules of the group are at hand.
   subroutine check_by(rules, part, place, key, number, units, found, called)
      type(key_rule_type), intent(in) :: rules(:)
      character(*), intent(in) :: part
      integer, intent(in) :: place
      character(*), intent(in) :: key
      real(wp), intent(in) :: number
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      character(*), intent(in), optional :: called  !< name of the number in its type, where that is not the key
      real(wp) :: held
      integer :: k
      logical :: holds
      character(:), allocatable :: needed, range, name
      name = key
      if (present(called)) name = called
      do k = 1, size(rules)
         if (rules(k)%key /= key) cycle
         ! by its bits first: to compare a NaN is an operation that may be trapped
         holds = is_shown(number)
         if (holds) then
            held = number
            call hold_in_range(rules(k), si_units(), held, holds)
            if (holds) return
         end if
         range = range_text(rules(k), units, si_units())
         needed = '; needs a number'
         if (range /= '') needed = needed//', '//range
         if (.not. is_shown(number)) then
            call note_fault(found, part, place, key, name//' is not a finite number'//needed)
         else if (rules(k)%unit == unit_none) then
            call note_fault(found, part, place, key, name//' = '//to_text(number, digits)//' is out of range'//needed)
         else
            call note_fault(found, part, place, key, name//' = '//to_text(number/unit_factor(units, rules(k)%unit), digits)// &
                            ' '//unit_label(units, rules(k)%unit)//' is out of range'//needed)
         end if
         return
      end do
   end subroutine check_by

   subroutine check_section_ranges(hole, place, units, found)
      type(hole_section_type), intent(in) :: hole
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      type(key_rule_type), allocatable :: rules(:)
      allocate (rules, source=keys_of('hole'))
      call check('md_top', hole%md_top)
      call check('md_bottom', hole%md_bottom)
      call check('diameter', hole%diameter)
      call check('friction_axial', hole%friction_axial)
      call check('friction_rotary', hole%friction_rotary)
      call check('wall_stiffness', hole%wall_stiffness)
      call check('mud_sheath', hole%mud_sheath)
   contains
      subroutine check(key, number)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number
         call check_by(rules, 'hole', place, key, number, units, found)
      end subroutine check
   end subroutine check_section_ranges

   subroutine check_component_ranges(component, place, units, found)
      type(component_type), intent(in) :: component
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      type(key_rule_type), allocatable :: rules(:)
      allocate (rules, source=keys_of('component'))
      call check('length', component%length)
      call check('od', component%od)
      call check('id', component%id)
      call check('mass', component%mass)
      call check('density', component%density)
      call check('youngs', component%youngs)
      call check('poisson', component%poisson)
      call check('joint_od', component%joint_od)
      call check('joint_length', component%joint_length)
      call check('joint_spacing', component%joint_spacing)
      call check('yield', component%yield)
      call check('makeup_torque', component%makeup_torque)
      call check('joint_torsion', component%joint_torsion)
      call check_own('friction_axial', component%friction_axial)
      call check_own('friction_rotary', component%friction_rotary)
      call check_by(rules, 'component', place, 'friction_scale_axial', component%scale_axial, units, found, 'scale_axial')
      call check_by(rules, 'component', place, 'friction_scale_rotary', component%scale_rotary, units, found, 'scale_rotary')
      call check('bend', component%bend)
      call check('bend_position', component%bend_position)
      if (is_shown(component%wall_left)) then
         if (component%wall_left >= thinnest .and. component%wall_left <= 1.0_wp) return
      end if
      call note_fault(found, 'component', place, 'wall_left', 'wall_left is the part of the wall that wear has left; needs a '// &
                      'number, '//to_text(thinnest)//' to 1')
   contains
      subroutine check(key, number)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number
         call check_by(rules, 'component', place, key, number, units, found)
      end subroutine check

      !> A number that may be missing.
      subroutine check_own(key, number)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number
         if (.not. is_absent(number)) call check(key, number)
      end subroutine check_own
   end subroutine check_component_ranges

   subroutine check_centralizer_ranges(centralizer, place, units, found)
      type(centralizer_type), intent(in) :: centralizer    !< that is present
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      type(key_rule_type), allocatable :: rules(:)
      allocate (rules, source=keys_of('centralizer'))
      call check('od', centralizer%od)
      call check('spacing', centralizer%spacing)
      call check('first', centralizer%first)
      if (centralizer%bow) then
         call check('restoring_force', centralizer%restoring_force)
         call check('rated_hole', centralizer%rated_hole)
         call check('running_force', centralizer%running_force)
      end if
      if (.not. is_absent(centralizer%friction_axial)) call check('friction_axial', centralizer%friction_axial)
      if (.not. is_absent(centralizer%friction_rotary)) call check('friction_rotary', centralizer%friction_rotary)
   contains
      subroutine check(key, number)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number
         call check_by(rules, 'centralizer', place, key, number, units, found)
      end subroutine check
   end subroutine check_centralizer_ranges

   subroutine check_fluid_ranges(fluid, place, units, found)
      type(fluid_type), intent(in) :: fluid
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      call check_number('fluid', place, 'density', fluid%density, units, found)
      call check_number('fluid', place, 'md_top', fluid%md_top, units, found)
      if (.not. is_zero(fluid%above_bit)) call check_number('fluid', place, 'above_bit', fluid%above_bit, units, found)
      if (.not. any(fluid%collar == [collar_none, collar_closed, collar_open_below])) &
         call note_fault(found, 'fluid', place, 'float_collar', 'collar = '//to_text(fluid%collar)//' is no number of a collar')
   end subroutine check_fluid_ranges

   subroutine check_case_ranges(load_case, place, units, found)
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      type(key_rule_type), allocatable :: rules(:)
      allocate (rules, source=keys_of('load_case'))
      if (load_case%operation < 1 .or. load_case%operation > operation_count) call note_fault(found, 'load_case', place, &
         'operation', 'operation = '//to_text(load_case%operation)//' is no number of an operation; needs one from 1 to '// &
         to_text(operation_count))
      call check('bit_depth', load_case%bit_depth)
      call check('wob', load_case%wob)
      call check('tob', load_case%tob)
      call check_by(rules, 'load_case', place, 'rpm', load_case%angular_speed, units, found, 'angular_speed')
      call check('trip_speed', load_case%trip_speed)
      call check('toolface', load_case%toolface)
      call check('pump_pressure', load_case%pump_pressure)
      call check_optional('friction_axial', load_case%friction_axial)
      call check_optional('friction_rotary', load_case%friction_rotary)
      call check_optional('measured_hookload', load_case%measured_hookload)
      call check_optional('measured_torque', load_case%measured_torque)
      call check_optional('reference_hookload', load_case%reference_hookload)
   contains
      subroutine check(key, number)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number
         call check_by(rules, 'load_case', place, key, number, units, found)
      end subroutine check

      subroutine check_optional(key, number)
         character(*), intent(in) :: key
         type(optional_real), intent(in) :: number
         if (number%present) call check(key, number%value)
      end subroutine check_optional
   end subroutine check_case_ranges

   subroutine check_numerics_ranges(numerics, units, found)
      type(numerics_type), intent(in) :: numerics
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      type(key_rule_type), allocatable :: rules(:)
      allocate (rules, source=keys_of('solver'))
      call check('element_length', numerics%element_length)
      call check('tolerance', numerics%tolerance)
      call check('max_iterations', real(numerics%max_iterations, wp))
      call check('load_steps', real(numerics%load_steps, wp))
      call check('gk_min', numerics%gk_min)
      call check('gk_contact', numerics%gk_contact)
      call check('gk_max', numerics%gk_max)
      call check('eps_n0', numerics%eps_n0)
      call check('eps_nmax', numerics%eps_nmax)
      call check('r_n0', numerics%r_n0)
      call check('relocation', numerics%relocation)
      call check('step_limit', numerics%step_limit)
      call check('imperfection', numerics%imperfection)
      call check_choice('gap_location', numerics%gap_location, gap_location_count)
      call check_choice('linear_solver', numerics%linear_solver, size(solver_name))
   contains
      subroutine check(key, number)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number
         call check_by(rules, 'solver', 0, key, number, units, found)
      end subroutine check

      subroutine check_choice(key, number, highest)
         character(*), intent(in) :: key
         integer, intent(in) :: number, highest
         if (number >= 1 .and. number <= highest) return
         call note_fault(found, 'solver', 0, key, key//' = '//to_text(number)//' is none of its numbers; needs one from 1 to '// &
                         to_text(highest))
      end subroutine check_choice
   end subroutine check_numerics_ranges

   subroutine check_rig_ranges(rig, units, found)
      type(rig_type), intent(in) :: rig
      type(unit_system_type), intent(in) :: units
      type(model_faults_type), intent(inout) :: found
      call check_number('rig', 0, 'block_weight', rig%block_weight, units, found)
      call check_number('rig', 0, 'lines', real(rig%lines, wp), units, found)
      call check_number('rig', 0, 'sheave_efficiency', rig%sheave_efficiency, units, found)
      if (rig%max_hookload%present) call check_number('rig', 0, 'max_hookload', rig%max_hookload%value, units, found)
      if (rig%max_torque%present) call check_number('rig', 0, 'max_torque', rig%max_torque%value, units, found)
   end subroutine check_rig_ranges

   !> Whether a number is the mark of one that is not there; false for a NaN.
   pure function is_absent(number) result(yes)
      real(wp), intent(in) :: number
      logical :: yes
      yes = transfer(number, no_bits) == transfer(missing, no_bits)
   end function is_absent

   !> Whether a number is 0; false for a NaN.
   pure function is_zero(number) result(yes)
      real(wp), intent(in) :: number
      logical :: yes
      yes = is_shown(number)
      if (yes) yes = abs(number) <= 0.0_wp
   end function is_zero
end module dg_range_check

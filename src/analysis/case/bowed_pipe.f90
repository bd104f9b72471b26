!> Friction that smeared tool joints leave out: buckled pipe bows out to the wall between its joints.
module dg_bowed_pipe
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers
   use dg_component, only: has_joints
   use dg_model, only: model_type, string_index
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_static_result, only: add_message
   use dg_trajectory, only: top_md
   use dg_unit_kind, only: in_units, unit_force, unit_moment
   implicit none
   private
   public :: note_bowed_pipe, rubs_between_joints

   !> What smeared joints leave out, by the soft string.
   type :: left_out_type
      real(wp) :: hookload = 0.0_wp     !< [N]
      real(wp) :: torque = 0.0_wp       !< at surface [N.m]
      real(wp) :: weight = 0.0_wp       !< of the string [N]
      real(wp) :: all_torque = 0.0_wp   !< at surface, with smeared joints [N.m]
      logical :: locks_anyway = .false. !< the string locks up with smeared joints, too
      logical :: locks = .false.        !< the string locks up with joints one by one
   end type left_out_type

   !> Friction that is left out, over weight or over torque, above which it counts [-]. Beams find up to fifty times as much as
   !> the soft string, so that little is enough.
   real(wp), parameter :: noticeable = 1.0e-3_wp
   !> Part of the message.
   character(*), parameter :: left_out = 'Smeared tool joints leave out the friction of buckled pipe between them'
   !> Digits of a force or torque in a message.
   integer, parameter :: shown = 2

contains

   !> True where smeared joints leave out some of hook load or torque, or change the load at which the string locks up. Joints are
   !> then to be solved one by one.
   pure function rubs_between_joints(model, case_index) result(rubs)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical :: rubs
      type(left_out_type) :: less
      rubs = smears_joints(model, case_index)
      if (.not. rubs) return
      call find_left_out(model, case_index, less)
      rubs = less%locks .or. less%hookload > noticeable*less%weight .or. less%torque > noticeable*less%all_torque
   end function rubs_between_joints

   !> Add a message where joints one by one would change the hook load or the torque of a compressed string. The soft string
   !> tells by how much, as it knows both (coil_clearance). Above the weight of the string its change is no number to use.
   subroutine note_bowed_pipe(model, case_index, tried, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: tried               !< joints one by one found no equilibrium
      type(case_result_type), intent(inout) :: result
      type(left_out_type) :: less
      character(:), allocatable :: text
      if (.not. has_numbers(result%status) .or. .not. smears_joints(model, case_index)) return
      call find_left_out(model, case_index, less)
      if (less%locks_anyway) return
      if (less%locks .or. less%hookload > less%weight) then
         result%left_out_friction = huge(1.0_wp)
         text = '. The string may lock up by it'
      else if (less%hookload > noticeable*less%weight) then
         result%left_out_friction = less%hookload
         text = ', roughly '//in_units(model%units, unit_force, less%hookload, shown)//' of hook load, by beams often more'
      else if (less%torque > noticeable*less%all_torque) then
         text = ', roughly '//in_units(model%units, unit_moment, less%torque, shown)//' of torque'
      else
         return
      end if
      if (tried) then
         text = text//'. With joints one by one no equilibrium was found'
      else
         text = text//". Set tool_joints = 'discrete' in &solver"
      end if
      call add_message(result, left_out//text)
   end subroutine note_bowed_pipe

   !> True if the string of a load case has tool joints that are smeared.
   pure function smears_joints(model, case_index) result(smears)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical :: smears
      smears = .not. model%numerics%discrete_joints
      if (smears) smears = any(has_joints(model%strings(string_index(model%strings, model%cases(case_index)%string))%components))
   end function smears_joints

   !> Find what smeared joints leave out.
   pure subroutine find_left_out(model, case_index, left_out)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(left_out_type), intent(out) :: left_out
      type(model_type) :: either
      type(soft_totals_type) :: totals, totals_apart
      real(wp) :: smeared(2), loads(2)
      either = model
      either%numerics%discrete_joints = .true.
      call find_loads(either, case_index, loads, totals_apart)
      either%numerics%discrete_joints = .false.
      either%numerics%joints_by_need = .false.
      call find_loads(either, case_index, smeared, totals)
      left_out = left_out_type(abs(loads(1) - smeared(1)), abs(loads(2) - smeared(2)), totals%weight, abs(smeared(2)), &
                               totals%runaway, totals_apart%runaway)
   end subroutine find_left_out

   !> Hook load and torque at surface of the soft string with the friction of buckling [N, N.m].
   pure subroutine find_loads(model, case_index, loads, totals)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(out) :: loads(2)
      type(soft_totals_type), intent(out) :: totals
      real(wp) :: axial(1), torque(1)
      call soft_string_at(model, case_index, [top_md(model%trajectory)], axial, torque, totals=totals, &
                          other=other_loads_type(coiled=.true.))
      loads = [axial(1), torque(1)]
   end subroutine find_loads
end module dg_bowed_pipe

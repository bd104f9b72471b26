!> Message on friction that smeared tool joints leave out: buckled pipe bows out to the wall between its joints.
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
   public :: note_bowed_pipe

   !> Friction that is left out, over hook load or weight, or over torque, above which there is a message [-].
   real(wp), parameter :: noticeable = 0.01_wp
   !> Friction that is left out, over weight, above which answers consider it [-].
   real(wp), parameter :: considered = 1.0e-3_wp
   !> Parts of the message.
   character(*), parameter :: left_out = 'Smeared tool joints leave out the friction of buckled pipe between them', &
                              advice = ". Set tool_joints = 'discrete' in &solver"
   !> Digits of a force or torque in a message.
   integer, parameter :: shown = 2

contains

   !> Add a message where joints one by one would change the hook load or the torque of a compressed string. The soft string
   !> tells by how much, as it knows both (coil_clearance). Above the weight of the string its change is no number to use.
   subroutine note_bowed_pipe(model, case_index, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(inout) :: result
      type(model_type) :: apart
      type(soft_totals_type) :: totals, totals_apart
      real(wp) :: smeared(2), change(2)       ! of hook load and torque at surface [N, N.m]
      if (model%numerics%discrete_joints .or. .not. has_numbers(result%status)) return
      if (.not. any(has_joints(model%strings(string_index(model%strings, model%cases(case_index)%string))%components))) return
      call find_loads(model, case_index, smeared, totals)
      if (totals%runaway) return
      apart = model
      apart%numerics%discrete_joints = .true.
      call find_loads(apart, case_index, change, totals_apart)
      change = abs(change - smeared)
      if (change(1) > considered*totals%weight) result%left_out_friction = change(1)
      if (totals_apart%runaway .or. change(1) > totals%weight) then
         result%left_out_friction = huge(1.0_wp)
         call add_message(result, left_out//'. The string may lock up by it'//advice)
      else if (change(1) > noticeable*max(abs(result%hookload), totals%weight)) then
         call add_message(result, left_out//', roughly '//in_units(model%units, unit_force, change(1), shown)// &
                          ' of hook load, by beams often more'//advice)
      else if (change(2) > noticeable*abs(smeared(2))) then
         call add_message(result, left_out//', roughly '//in_units(model%units, unit_moment, change(2), shown)// &
                          ' of torque'//advice)
      end if
   end subroutine note_bowed_pipe

   !> Hook load and torque at surface of the soft string with the friction of buckling [N, N.m].
   subroutine find_loads(model, case_index, loads, totals)
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

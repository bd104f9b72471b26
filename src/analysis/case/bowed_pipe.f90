!> Message on friction that smeared tool joints leave out: pipe in a helix bows out to the wall between its joints.
module dg_bowed_pipe
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers
   use dg_component, only: has_joints
   use dg_model, only: model_type, string_index
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_static_result, only: add_message
   use dg_trajectory, only: top_md
   use dg_unit_kind, only: in_units, unit_force
   implicit none
   private
   public :: note_bowed_pipe

   !> Friction that is left out, over hook load or weight, above which there is a message [-].
   real(wp), parameter :: noticeable = 0.01_wp
   !> Parts of the message.
   character(*), parameter :: left_out = 'Buckled pipe touches the hole between its tool joints, too. Smeared joints leave '// &
                                         'out the friction there'
   character(*), parameter :: advice = "Set tool_joints = 'discrete'"
   !> Digits of a force in a message.
   integer, parameter :: shown = 2

contains

   !> Add a message where joints one by one would change the hook load of a helically buckled string. The soft string tells by
   !> how much, as it knows both (coil_clearance). A change above the weight of the string means that it cannot be pushed there.
   subroutine note_bowed_pipe(model, case_index, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(inout) :: result
      type(model_type) :: apart
      type(soft_totals_type) :: totals, totals_apart
      real(wp) :: smeared, change
      if (model%numerics%discrete_joints .or. .not. has_numbers(result%status)) return
      if (.not. any(has_joints(model%strings(string_index(model%strings, model%cases(case_index)%string))%components))) return
      call find_hookload(model, case_index, smeared, totals)
      if (totals%runaway) return
      apart = model
      apart%numerics%discrete_joints = .true.
      call find_hookload(apart, case_index, change, totals_apart)
      change = abs(change - smeared)
      if (totals_apart%runaway .or. change > totals%weight) then
         call add_message(result, left_out//'. The string may lock up by that friction. '//advice)
      else if (change > noticeable*max(abs(result%hookload), totals%weight)) then
         call add_message(result, left_out//', '//in_units(model%units, unit_force, change, shown)//' of hook load by the soft '// &
                          'string, often more by beams. '//advice)
      end if
   end subroutine note_bowed_pipe

   !> Hook load of the soft string with the friction of buckling [N].
   subroutine find_hookload(model, case_index, hookload, totals)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(out) :: hookload
      type(soft_totals_type), intent(out) :: totals
      real(wp) :: axial(1), torque(1)
      call soft_string_at(model, case_index, [top_md(model%trajectory)], axial, torque, totals=totals, &
                          other=other_loads_type(coiled=.true.))
      hookload = axial(1)
   end subroutine find_hookload
end module dg_bowed_pipe

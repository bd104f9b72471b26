!> Pipe between tool joints, which smeared joints keep off the wall. Joints one by one let compressed pipe bow out to the wall.
!> Its friction is larger then, and buckling shortens it more.
module dg_bowed_pipe
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers
   use dg_load_case, only: block_way
   use dg_length_change, only: asks_for_length
   use dg_model, only: model_type, smears_joints
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_static_result, only: add_message
   use dg_trajectory, only: top_md
   use dg_unit_kind, only: in_units, unit_force, unit_length, unit_moment
   implicit none
   private
   public :: bows_between_joints, note_bowed_pipe, with_joints_apart

   !> What smeared joints leave out, by the soft string.
   type :: left_out_type
      real(wp) :: hookload = 0.0_wp     !< [N]
      real(wp) :: torque = 0.0_wp       !< at surface [N.m]
      real(wp) :: weight = 0.0_wp       !< of the string [N]
      real(wp) :: all_torque = 0.0_wp   !< at surface, with smeared joints [N.m]
      real(wp) :: length = 0.0_wp       !< that buckling takes up [m]
      real(wp) :: bowed = 0.0_wp        !< length of pipe that bows out between its joints [m]
      logical :: locks_anyway = .false. !< the string locks up with smeared joints, too
      logical :: locks = .false.        !< the string locks up with joints one by one
   end type left_out_type

   !> Length of pipe that bows out, above which its friction counts: about one joint [m]. Beams find up to a tenth of the hook
   !> load where the soft string finds nothing. It knows no bow below the load at which the whole string buckles.
   real(wp), parameter :: noticeable_bow = 10.0_wp
   !> Friction that is left out, over weight or over torque, above which a message has its number [-]. Below, beams may still
   !> find `hidden` of the weight.
   real(wp), parameter :: noticeable = 1.0e-3_wp, hidden = 0.1_wp
   !> Length that is left out, above which it counts [m]. Seals in a packer are placed to some centimetres.
   real(wp), parameter :: noticeable_length = 0.01_wp
   !> Part of the message.
   character(*), parameter :: left_out = 'Smeared tool joints leave out the friction of buckled pipe between them'
   !> Digits of a force or torque in a message.
   integer, parameter :: shown = 2

contains

   !> True where pipe bows out between its joints: it is compressed by more than the Euler load of its length between them.
   !> Smeared joints then leave out friction, and length that its buckling takes up. Joints are to be solved one by one.
   pure function bows_between_joints(model, case_index) result(bows)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical :: bows
      real(wp) :: loads(2)
      type(soft_totals_type) :: totals
      bows = smears_joints(model, case_index)
      if (.not. bows) return
      call find_loads(with_joints_apart(model), case_index, loads, totals)
      bows = totals%bowed > noticeable_bow
   end function bows_between_joints

   !> Add a message where joints one by one would change the length, the hook load or the torque of a compressed string. The
   !> soft string tells by how much, as it knows both (coil_clearance). Above the weight of the string its change is no number
   !> to use.
   subroutine note_bowed_pipe(model, case_index, tried, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: tried               !< joints one by one found no equilibrium
      type(case_result_type), intent(inout) :: result
      type(left_out_type) :: less
      character(:), allocatable :: text, cure
      if (.not. has_numbers(result%status) .or. .not. smears_joints(model, case_index)) return
      call find_left_out(model, case_index, less)
      if (less%locks_anyway) return
      cure = ". Set tool_joints = 'discrete' in &solver"
      if (tried) cure = '. With joints one by one no equilibrium was found'
      if (less%length > noticeable_length .and. asks_for_length(model, model%cases(case_index))) &
         call add_message(result, 'Smeared tool joints hold buckled pipe off the wall: its buckling shortens it by roughly '// &
                          in_units(model%units, unit_length, less%length, shown)//' more'//cure)
      if (less%locks .or. less%hookload > less%weight) then
         result%left_out_friction = huge(1.0_wp)
         text = '. The string may lock up by it'
      else if (less%hookload > noticeable*less%weight) then
         result%left_out_friction = less%hookload
         text = ', roughly '//in_units(model%units, unit_force, less%hookload, shown)//' of hook load, by beams often more'
      else if (less%torque > noticeable*less%all_torque) then
         text = ', roughly '//in_units(model%units, unit_moment, less%torque, shown)//' of torque'
      else if (less%bowed > noticeable_bow) then
         if (block_way(model%cases(case_index)%operation) < 0) result%left_out_friction = hidden*less%weight
         text = '. It may be a tenth of the weight'
      else
         return
      end if
      call add_message(result, left_out//text//cure)
   end subroutine note_bowed_pipe

   !> Find what smeared joints leave out.
   pure subroutine find_left_out(model, case_index, left_out)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(left_out_type), intent(out) :: left_out
      type(model_type) :: together
      type(soft_totals_type) :: totals, totals_apart
      real(wp) :: smeared(2), loads(2)
      call find_loads(with_joints_apart(model), case_index, loads, totals_apart)
      together = model
      together%numerics%discrete_joints = .false.
      together%numerics%joints_by_need = .false.
      call find_loads(together, case_index, smeared, totals)
      left_out = left_out_type(abs(loads(1) - smeared(1)), abs(loads(2) - smeared(2)), abs(totals%weight), abs(smeared(2)), &
                               totals_apart%coil - totals%coil, totals_apart%bowed, totals%runaway, totals_apart%runaway)
   end subroutine find_left_out

   !> The model with its tool joints one by one.
   pure function with_joints_apart(model) result(apart)
      type(model_type), intent(in) :: model
      type(model_type) :: apart
      apart = model
      apart%numerics%discrete_joints = .true.
   end function with_joints_apart

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

!> Loads at surface of a string that does not go down, or up, by itself, if it were turned. Torque on bit beyond the top drive.
module dg_turning_loads
   use dg_kinds, only: wp
   use dg_component, only: is_coiled_tubing
   use dg_drillstring, only: component_tops, topmost
   use dg_fluid_pressure, only: surface_push
   use dg_load_case, only: operation_rotary_drilling, rotates
   use dg_missing, only: given
   use dg_model, only: model_type, string_index
   use dg_pipe_strength, only: torsional_strength
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_trajectory, only: top_md
   use dg_utilisation, only: has_rating, limit_joint_torsion, limit_makeup, limit_top_drive, limit_torsion
   use dg_verdict, only: answer_no, verdict_type
   implicit none
   private
   public :: find_turning_loads, judge_bit_torque

   !> Least hook load over the weight or contact force of a string that is more than round-off [-].
   real(wp), parameter :: least_hookload = 1.0e-6_wp

contains

   !> Find hook load and torque of the soft string if the string were turned. All friction is around the hole then, that of
   !> helical buckling too. They are absent if the hook load would still be below zero. They are absent if the torque is more
   !> than the top drive, a connection or a body carries. They are absent for coiled tubing and a string in a packer.
   pure subroutine find_turning_loads(model, case_index, verdict)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(verdict_type), intent(inout) :: verdict
      type(model_type) :: turned
      type(soft_totals_type) :: totals
      real(wp), allocatable :: md(:), axial(:), torque(:)
      integer :: i, parts
      if (model%boundary%packer_bore > 0.0_wp) return      ! a packer does not turn
      turned = model
      turned%cases(case_index)%operation = operation_rotary_drilling
      associate (bit => model%cases(case_index)%bit_depth, top => top_md(model%trajectory), &
                 string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         allocate (md, source=bit - component_tops(string, bit - top))
         parts = topmost(bit - md)
         md = max(top, md(:parts))
         allocate (axial(parts), torque(parts))
         call soft_string_at(turned, case_index, md(parts:1:-1), axial, torque, totals=totals, &
                             other=other_loads_type(coiled=.true.))
         axial(1) = axial(1) - surface_push(model, case_index)        ! hook load
         if (totals%runaway .or. .not. axial(1) > least_hookload*max(abs(totals%weight), totals%normal_force)) return
         if (model%rig%max_torque%present) then
            if (abs(torque(1)) > model%rig%max_torque%value) return
         end if
         do i = 1, parts
            if (is_coiled_tubing(string%components(i))) return
            associate (part => string%components(i), load => abs(torque(parts + 1 - i)))
               if (has_rating(part, limit_makeup) .and. load > part%makeup_torque) return
               if (has_rating(part, limit_joint_torsion) .and. load > part%joint_torsion) return
               if (has_rating(part, limit_torsion) .and. load > torsional_strength(part)) return
            end associate
         end do
      end associate
      verdict%turning_hookload = given(axial(1))
      verdict%turning_torque = given(abs(torque(1)))
   end subroutine find_turning_loads

   !> Judge a rotating case without a solution. It is impossible if torque on bit alone is more than the top drive has, as
   !> friction adds to it.
   pure subroutine judge_bit_torque(model, case_index, verdict)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(verdict_type), intent(inout) :: verdict
      associate (load_case => model%cases(case_index), most => model%rig%max_torque)
         if (.not. (most%present .and. rotates(load_case%operation))) return
         if (.not. load_case%tob > most%value) return
         verdict%answer = answer_no
         verdict%limit = limit_top_drive
         verdict%used = given(load_case%tob/most%value)
         verdict%load = given(load_case%tob)
         verdict%allowed = most
         verdict%alone = .true.
      end associate
   end subroutine judge_bit_torque
end module dg_turning_loads

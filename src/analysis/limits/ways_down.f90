!> What brings a string down that its weight does not: less weight on bit, a shallower bit, less friction, or rotation.
module dg_ways_down
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_component, only: is_coiled_tubing
   use dg_drillstring, only: component_tops, topmost
   use dg_fluid_pressure, only: surface_push
   use dg_load_case, only: operation_rotary_drilling
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type, string_index
   use dg_pipe_strength, only: torsional_strength
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_trajectory, only: top_md
   use dg_utilisation, only: has_rating, limit_joint_torsion, limit_makeup, limit_torsion
   use dg_verdict, only: limit_lock_up, limit_string_weight, slow_turning, verdict_type
   use dg_weight_on_bit, only: find_reach, friction_by_beams, matching_friction, weight_that_arrives
   implicit none
   private
   public :: find_turning_loads, find_ways_down

   !> Least hook load over the weight or contact force of a string that is more than round-off [-].
   real(wp), parameter :: least_hookload = 1.0e-6_wp

contains

   !> Find weight on bit, bit depth and friction with which string weight and push are just enough, by the soft string. Its
   !> friction includes helical buckling. A factor on that friction gives the hook load of the beams. It comes from the case without
   !> weight on bit, if that was solved, else from the case itself. If beams have found the depth, it is theirs.
   pure subroutine find_ways_down(model, result, verdict)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(verdict_type), intent(inout) :: verdict
      real(wp) :: scale, part
      associate (wob => model%cases(result%case_index)%wob, bare => result%without_load, i => result%case_index)
         scale = friction_by_beams(model, result)
         if (bare%status == result_converged) then
            verdict%excess_without_load = -bare%hookload - model%rig%max_push
            verdict%limit_without_load = merge(limit_string_weight, 0, verdict%excess_without_load > 0.0_wp)
         else if (bare%status == result_locked_up) then
            verdict%limit_without_load = limit_lock_up
         end if
         if (wob > 0.0_wp .and. .not. verdict%most_wob%present) verdict%most_wob = given(weight_that_arrives(model, result))
         if (verdict%also > 0) return       ! weight is not the only shortage
         verdict%reach = result%weight_limits%reach
         if (.not. verdict%reach%present) call find_reach(model, i, verdict%reach, scale)
         part = matching_friction(model, i, wob, -model%rig%max_push)/scale
         if (result%weight_limits%friction%present) part = result%weight_limits%friction%value
         verdict%possible_friction = optional_real(part > 0.0_wp .and. part < 1.0_wp, part)
         call find_turning_speed(model, i, verdict)
      end associate
   end subroutine find_ways_down

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

   !> Find the speed along the hole at which a string at `slow_turning` has that part of its drag with which its weight is enough.
   !> Friction acts against the velocity of the pipe's surface, so its part along the hole is v/sqrt(v^2 + (omega r)^2). The
   !> radius is that of the thinnest component. It is absent under weight on bit, which moves little.
   pure subroutine find_turning_speed(model, case_index, verdict)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(verdict_type), intent(inout) :: verdict      !< with the possible friction
      if (.not. (verdict%turning_hookload%present .and. verdict%possible_friction%present)) return
      associate (load_case => model%cases(case_index), part => verdict%possible_friction%value)
         if (load_case%wob > 0.0_wp) return
         associate (parts => model%strings(string_index(model%strings, load_case%string))%components)
            verdict%turning_speed = given(part/sqrt(1.0_wp - part**2)*slow_turning*0.5_wp*minval(max(parts%od, parts%joint_od)))
         end associate
      end associate
   end subroutine find_turning_speed
end module dg_ways_down

!> Weight that reaches the bit, by the soft string: a search with beams would cost a hundred solutions.
module dg_weight_on_bit
   use dg_kinds, only: wp
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_component, only: axial_stiffness
   use dg_depth_search, only: depth_search_type, new_depth_search, next_depth, take_value
   use dg_load_case, only: block_way, rotates
   use dg_job, only: model_mcge
   use dg_missing, only: given, is_missing, optional_real
   use dg_fluid_pressure, only: surface_push
   use dg_model, only: model_type, string_index
   use dg_soft_string_loads, only: bearable_strain, other_loads_type, soft_string_at, soft_totals_type
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: friction_by_beams, weight_that_arrives, most_load_at_bit, most_weight_on_bit, locks_up, find_reach, matching_friction

   !> Accuracy of a load over its bracket [-].
   real(wp), parameter :: tolerance = 1.0e-11_wp
   !> Most doublings until there is a bracket. The first step is 1 kN, or the hook load without weight on bit, which friction
   !> reduces. The last step is more than any string weighs.
   integer, parameter :: doublings = 30
   real(wp), parameter :: first_guess = 1.0e3_wp
   !> Accuracy of a depth over the bit's depth [-].
   real(wp), parameter :: depth_tolerance = 1.0e-5_wp
   !> Part of the load by a push that string weight brings, above which friction limits both [-].
   real(wp), parameter :: by_friction = 0.5_wp
   !> Range of the factors of friction, and their accuracy [-].
   real(wp), parameter :: scales(2) = [0.1_wp, 4.0_wp], scale_tolerance = 1.0e-4_wp

contains

   !> Largest weight on bit by string weight and `max_push` of the rig [N]. Friction includes helical buckling, and the factor of
   !> beams over the soft string. For a string that locks up it is at most the load by beams. Where friction and not weight
   !> limits it, it is less than that of the soft string in the ratio of both loads. If beams have found it, it is theirs.
   pure function weight_that_arrives(model, result) result(most)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      real(wp) :: most, pushed, without
      most = result%weight_limits%wob%value
      if (result%weight_limits%wob%present) return
      most = most_weight_on_bit(model, result%case_index, coiled=.true., pushed=.false., &
                                friction_scale=friction_by_beams(model, result))
      if (result%status == result_converged .and. result%without_load%status == result_converged) then
         without = most_weight_on_bit(model, result%case_index, coiled=.true., pushed=.false., &
                                      friction_scale=result%without_load%friction_scale)
         ! the factor grows in proportion to weight on bit, and the load falls in proportion to the factor
         if (without > most) most = without/(1.0_wp + (without - most)/model%cases(result%case_index)%wob)
      end if
      if (result%status /= result_locked_up .or. is_missing(result%lock_up_load)) return
      pushed = most_load_at_bit(model, result%case_index, coiled=.true., pushed=.true., &
                                friction_scale=result%without_load%friction_scale)
      if (most > by_friction*pushed) most = most*min(result%lock_up_load/pushed, 1.0_wp)
      most = min(most, max(result%lock_up_load, 0.0_wp))
   end function weight_that_arrives

   !> Factor on all friction of the soft string, helical buckling included, with which it has the hook load of beams [-]. It is
   !> that of the limit that beams have found. Else it is that of the case itself where a string slides down, else of the case
   !> without weight on bit. It is 1 if none is known.
   pure function friction_by_beams(model, result) result(scale)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      real(wp) :: scale
      scale = result%weight_limits%friction_scale%value
      if (result%weight_limits%friction_scale%present) return
      scale = result%without_load%friction_scale
      associate (load_case => model%cases(result%case_index))
         if (result%status /= result_converged .or. result%model /= model_mcge .or. block_way(load_case%operation) >= 0 .or. &
             rotates(load_case%operation)) return
         scale = matching_friction(model, result%case_index, load_case%wob, result%hookload)
      end associate
      if (.not. scale > 0.0_wp) scale = 1.0_wp
   end function friction_by_beams

   !> Greatest weight on bit [N] that leaves a hook load >= 0; 0 if not found. With `pushed` it is the greatest one by a
   !> push at the top that the pipe carries. With `coiled`, friction includes helical buckling, and the hook load may be below
   !> zero by `max_push` of the rig. Without that friction nothing limits a push.
   pure function most_weight_on_bit(model, case_index, coiled, pushed, friction_scale) result(wob)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: coiled, pushed
      real(wp), intent(in), optional :: friction_scale   !< on all friction [-]; absent: 1
      real(wp) :: wob
      wob = 0.0_wp
      if (left_of(model, case_index, 0.0_wp, coiled, pushed, friction_scale) >= 0.0_wp) &
         wob = most_load_at_bit(model, case_index, coiled, pushed, friction_scale)
   end function most_weight_on_bit

   !> The same load [N]. If no weight reaches the bit, it is minus the pull at the bit that brings the string down. It is 0 if
   !> the search finds neither.
   pure function most_load_at_bit(model, case_index, coiled, pushed, friction_scale) result(load)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: coiled, pushed
      real(wp), intent(in), optional :: friction_scale   !< on all friction [-]; absent: 1
      real(wp) :: load
      type(bracket_type) :: bracket
      real(wp) :: left, here, other, value, narrowness, step
      integer :: i
      load = 0.0_wp
      here = 0.0_wp
      left = left_of(model, case_index, here, coiled, pushed, friction_scale)
      step = max(left, first_guess)
      if (left < 0.0_wp) step = -step
      do i = 1, doublings
         other = step
         value = left_of(model, case_index, other, coiled, pushed, friction_scale)
         if ((value < 0.0_wp) .neqv. (left < 0.0_wp)) exit
         here = other
         left = value
         step = 2.0_wp*step
      end do
      if (i > doublings) then
         if (here > 0.0_wp) load = here
         return
      end if
      if (here < other) then
         bracket = new_bracket(here, left, other, value)
      else
         bracket = new_bracket(other, value, here, left)
      end if
      narrowness = tolerance*abs(other)
      do while (.not. is_narrow(bracket, narrowness))
         load = next_try(bracket, narrowness)
         call narrow(bracket, load, left_of(model, case_index, load, coiled, pushed, friction_scale))
      end do
      load = bracket%low
   end function most_load_at_bit

   !> True if the string of a load case is lowered and its own weight and `max_push` do not bring it down. Friction includes helical
   !> buckling.
   pure function locks_up(model, case_index) result(locks)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical :: locks
      locks = block_way(model%cases(case_index)%operation) < 0
      if (locks) locks = left_of(model, case_index, model%cases(case_index)%wob, coiled=.true., pushed=.false.) < 0.0_wp
   end function locks_up

   !> Greatest bit depth at which a string that is lowered has its weight on bit by its own weight and `max_push` [m]. Friction
   !> includes helical buckling. It is 0 if no depth of the search is possible. It is absent if the depth of the load case is
   !> possible, and for a string that is pulled.
   pure subroutine find_reach(model, case_index, reach, friction_scale)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(optional_real), intent(out) :: reach
      real(wp), intent(in), optional :: friction_scale   !< on all friction [-]; absent: 1
      type(model_type) :: probe
      type(depth_search_type) :: search
      real(wp) :: left
      if (block_way(model%cases(case_index)%operation) >= 0) return
      probe = model
      associate (load_case => model%cases(case_index), depth => probe%cases(case_index)%bit_depth)
         left = left_of(model, case_index, load_case%wob, coiled=.true., pushed=.false., friction_scale=friction_scale)
         if (left >= 0.0_wp) return
         search = new_depth_search(load_case%bit_depth, depth_tolerance*load_case%bit_depth)
         do while (search%goes_on)
            depth = next_depth(search)
            call take_value(search, depth, left_of(probe, case_index, load_case%wob, coiled=.true., pushed=.false., &
                                                   friction_scale=friction_scale))
         end do
      end associate
      reach = given(search%greatest)
   end subroutine find_reach

   !> Factor of all friction with which a weight on bit leaves a hook load of a string that goes down. Friction includes
   !> helical buckling. It is 0 if there is no such factor between a tenth and four.
   pure function matching_friction(model, case_index, wob, hookload) result(scale)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: wob, hookload   !< [N]
      real(wp) :: scale                       !< [-]
      type(bracket_type) :: bracket
      real(wp) :: more(2)
      integer :: i
      scale = 0.0_wp
      do i = 1, 2
         more(i) = more_than_asked(scales(i))
      end do
      if (more(1) < 0.0_wp .or. more(2) >= 0.0_wp) return
      bracket = new_bracket(scales(1), more(1), scales(2), more(2))
      do while (.not. is_narrow(bracket, scale_tolerance))
         scale = next_try(bracket, scale_tolerance)
         call narrow(bracket, scale, more_than_asked(scale))
      end do
      scale = bracket%low

   contains

      !> Hook load less the wanted one [N].
      pure function more_than_asked(factor) result(more)
         real(wp), intent(in) :: factor   !< [-]
         real(wp) :: more
         more = left_of(model, case_index, wob, coiled=.true., pushed=.false., friction_scale=factor) &
                - model%rig%max_push - hookload
      end function more_than_asked
   end function matching_friction

   !> Axial force that gives the weakest component of a load case's string a strain of bearable_strain [N].
   pure function bearable_force(model, case_index) result(force)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp) :: force
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         force = bearable_strain*minval(axial_stiffness(string%components))
      end associate
   end function bearable_force

   !> Hook load that a weight on bit [N] leaves [N], < 0 if it does not reach the bit. With `coiled`, `max_push` of the rig is
   !> added. With `pushed` it is the strain that is left to bearable_strain, as a force.
   pure function left_of(model, case_index, wob, coiled, pushed, friction_scale) result(left)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: wob
      logical, intent(in) :: coiled, pushed
      real(wp), intent(in), optional :: friction_scale
      real(wp) :: left
      type(soft_totals_type) :: totals
      type(other_loads_type) :: other
      real(wp) :: axial(1), torque(1)
      other = other_loads_type(coiled=coiled, wob=given(wob))
      if (present(friction_scale)) other%friction_scale = friction_scale
      call soft_string_at(model, case_index, [top_md(model%trajectory)], axial, torque, totals=totals, other=other)
      left = axial(1) - surface_push(model, case_index)
      if (coiled) left = left + model%rig%max_push
      if (pushed) left = bearable_force(model, case_index)*(1.0_wp - totals%strain/bearable_strain)
      if (totals%runaway) left = min(left, -1.0_wp)
   end function left_of
end module dg_weight_on_bit

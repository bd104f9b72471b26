!> Greatest bit depth at which strengths, slips and rig bear a load case that is too much for one of them.
!>
!> The soft string gives the loads at other depths. A factor for each limit gives the use that the result has at its own depth.
module dg_limit_reach
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type
   use dg_depth_search, only: depth_search_type, new_depth_search, next_depth, take_value
   use dg_job, only: model_mcge, model_soft
   use dg_load_case, only: rotates
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_profile_rows, only: lay_rows
   use dg_soft_string, only: set_profile, set_totals, subdivided
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_string_piece, only: breakpoints
   use dg_string_weight, only: passed_weight, too_much
   use dg_trajectory, only: top_md
   use dg_utilisation, only: find_utilisation, limit_count, utilisation_type
   implicit none
   private
   public :: find_limit_reach

   !> Accuracy of the depth over the depth of the bit [-].
   real(wp), parameter :: depth_tolerance = 1.0e-4_wp

contains

   !> Find the depth [m]. It is 0 if no depth of the search is possible, and absent if the soft string locks up at the depth of
   !> the result.
   pure subroutine find_limit_reach(model, result, utilisation, reach)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result             !< converged, with a profile
      type(utilisation_type), intent(in) :: utilisation        !< of the result
      type(optional_real), intent(out) :: reach
      type(depth_search_type) :: search
      real(wp) :: used(limit_count), ratio(limit_count), top, span, depth, left
      top = top_md(model%trajectory)
      span = model%cases(result%case_index)%bit_depth - top
      call find_uses(model, result, top + span, used)
      if (minval(used) >= too_much) return
      ratio = 1.0_wp
      where (used > 0.0_wp .and. utilisation%used%present .and. utilisation%used%value > 0.0_wp) &
         ratio = utilisation%used%value/used
      left = 1.0_wp - maxval(ratio*used)
      if (left >= 0.0_wp) return
      search = new_depth_search(span, depth_tolerance*span)
      do while (search%goes_on)
         depth = next_depth(search)
         call take_value(search, depth, left_at(depth))
      end do
      reach = given(0.0_wp)
      if (search%greatest > 0.0_wp) reach = given(top + search%greatest)

   contains

      !> One minus the use of the limit that is used most, with the bit at a depth below the top [-].
      pure function left_at(depth) result(left)
         real(wp), intent(in) :: depth   !< [m]
         real(wp) :: left
         real(wp) :: there(limit_count)
         call find_uses(model, result, top + depth, there)
         left = 1.0_wp - maxval(ratio*there)
      end function left_at
   end subroutine find_limit_reach

   !> Find the uses of all limits by the soft string with the bit at a depth. They are 0 for limits that are not known, and
   !> `too_much` if string weight is not enough.
   pure subroutine find_uses(given_model, result, bit_depth, used)
      type(model_type), intent(in) :: given_model
      type(case_result_type), intent(in) :: result   !< its load case and method count
      real(wp), intent(in) :: bit_depth              !< [m]
      real(wp), intent(out) :: used(limit_count)     !< [-]
      type(model_type) :: model
      type(case_result_type) :: soft
      type(along_string_type) :: along
      type(utilisation_type) :: utilisation
      type(soft_totals_type) :: totals
      real(wp), allocatable :: md(:), axial(:), torque(:), contact(:, :)
      integer, allocatable :: from(:), side(:)
      model = given_model
      associate (case_index => result%case_index)
         model%cases(case_index)%bit_depth = bit_depth
         md = subdivided(breakpoints(model, case_index), model%numerics%element_length)
         call lay_rows(model, case_index, md, from, side)
         md = md(from)
         allocate (axial(size(md)), torque(size(md)), contact(3, size(md)))
         call soft_string_at(model, case_index, md, axial, torque, contact, totals=totals, &
                             other=other_loads_type(coiled=result%model /= model_soft .and. &
                                                    .not. rotates(model%cases(case_index)%operation), &
                                                    climbs=result%model == model_mcge))
         used = too_much
         if (totals%runaway) return
         call set_totals(model, case_index, md, axial, torque, totals, soft)
         soft%model = model_soft
         call set_profile(model, case_index, md, side, axial, torque, contact, soft)
         call find_along_string(model, soft, along)
         call find_utilisation(model, soft, along, utilisation)
         if (passed_weight(model, model_soft, case_index, soft%hookload, maxval(abs(axial))) > 0) return
         used = merge(utilisation%used%value, 0.0_wp, utilisation%used%present)
      end associate
   end subroutine find_uses
end module dg_limit_reach

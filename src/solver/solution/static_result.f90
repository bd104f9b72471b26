!> Result of an analysis by beams with contact gap elements.
module dg_static_result
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_case_result, only: add_sentence, case_result_type, is_pushed, iteration_type, push_needed, result_converged, &
                             result_not_converged
   use dg_gap_survey, only: node_offset
   use dg_gap_table, only: count_states
   use dg_fluid_pressure, only: needed_push, surface_push
   use dg_job, only: model_mcge
   use dg_mesh, only: mesh_type, widest_beside
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_no_equilibrium, only: add_place, no_stable
   use dg_numerics, only: default_wall, gap_location_name, numerics_type
   use dg_outcome, only: outcome_converged, outcome_outside, outcome_singular
   use dg_outside_hole, only: measure_outside, outside_message, outside_place, outside_type
   use dg_recovery, only: buoyed_axial_weight, check_equilibrium, recover_bit, recover_gaps
   use dg_rounding, only: rounded_up
   use dg_solution, only: solution_type
   use dg_text, only: either, to_text
   use dg_trajectory, only: inclination_of, position_at, top_md
   use dg_unit_kind, only: in_units, unit_force, unit_length, unit_moment, unit_wall
   use dg_units, only: unit_system_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: add_message, add_outside, add_remarks, fill_result, look_outside, warn_of_range, &
             warn_of_points, warn_of_slope, warn_of_contact

   !> Results affected when gaps are not at the place asked for. The figure is from GP1. Its side forces with gaps at x0 or at
   !> nodes of 5 m elements differ by up to 12 % from those of 0.5 m.
   character(*), parameter :: touched = 'allow 10 % on side force and tilt of the bit, and on bending moments between contacts'
   !> Length of the elements that are advised over the longest present one [-], and the shortest that are advised [m].
   real(wp), parameter :: advised = 0.1_wp, shortest_advised = 0.5_wp
   !> A result is rejected if the unbalanced force over the weight exceeds this [-]. Sound results have 1e-12 to 1e-6, at any
   !> stiffness of the wall.
   real(wp), parameter :: most_out_of_balance = 1.0e-4_wp
   !> Largest sum of forces with which walls pull the string, over the weight [-]: the default of r_n0 in 10 000 gaps.
   real(wp), parameter :: most_pulled = 1.0e-5_wp
   !> Largest unbalanced force over the weight of a string in equilibrium, stable or not [-].
   real(wp), parameter :: in_balance = 1.0e-8_wp
   !> Least difference of contact forces, over the whole, that a message reports [-].
   real(wp), parameter :: unlike = 3.0e-3_wp
   !> Part of the contact that goes where walls yield a little more, from which a message says so [-]. Stiffness of a wall that is
   !> as good as rigid, and of sandstone [N/m2].
   real(wp), parameter :: yields = 0.05_wp, nearly_rigid = 0.9_wp*default_wall, sandstone = 1.0e10_wp
   !> A message names a part of the string only if it is shorter than this part of it [-].
   real(wp), parameter :: nearly_all = 0.9_wp
   !> A message reports another hook load that differs by more than `worth_telling` of the largest axial force [-]. It reports
   !> another largest moment that differs by more than `moments_worth_telling` of it [-].
   real(wp), parameter :: worth_telling = 5.0e-3_wp, moments_worth_telling = 0.02_wp
   !> Error of the moments over their difference to another equilibrium of a coil [-]. Two equilibria are seldom both ends of
   !> the range.
   real(wp), parameter :: beyond_both = 2.0_wp
   !> Contact over weight and bit load that counts where a rotating string does not stay on one side [-].
   real(wp), parameter :: little_contact = 0.02_wp
   !> Contact force and moment too small to be compared [N, N.m].
   real(wp), parameter :: least_contact = 10.0_wp, least_moment = 1.0e-3_wp
   !> Digits in a message.
   integer, parameter :: shown = 4, shown_range = 3, shown_depth = 6, shown_residual = 3, shown_clearances = 2

contains

   !> Fill the result of the last state, converged or not, without its profile (recover_profile).
   subroutine fill_result(model, case_index, solution, outcome, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(solution_type), intent(in) :: solution
      integer, intent(in) :: outcome
      type(case_result_type), intent(out) :: result
      type(iteration_type) :: last
      type(outside_type) :: outside
      real(wp) :: position(3), tangent(3), worst, side_force, side_clock
      integer :: place
      logical :: whirls
      associate (mesh => solution%mesh, gaps => solution%gaps, equations => solution%equations, work => solution%work)
         result%case_index = case_index
         result%model = model_mcge
         last = equations%history(equations%iterations + 1)
         result%message = ''
         whirls = any(work%sideways < 1.0_wp .and. mesh%friction_around > 0.0_wp)
         select case (outcome)
         case (outcome_converged)
            result%status = result_converged
            if (whirls) call warn_of_whirling(model%units, mesh, work, equations%force_scale, result)
         case (outcome_outside)
            call look_outside(model, mesh, work, worst, place)
            result%status = result_not_converged
            result%message = 'No equilibrium found within the hole: the string lies outside by '// &
               to_text(worst, shown_clearances)//' clearances between two contact points, at '
            call add_place(model, case_index, mesh%md(place), result%message)
         case (outcome_singular)
            result%status = result_not_converged
            result%message = 'No unique equilibrium: the string can move freely, most at '
            call add_place(model, case_index, equations%unbalanced_md, result%message)
         case default
            result%status = result_not_converged
            if (last%residual_force < in_balance*equations%force_scale) then
               result%message = no_stable//': the string is in balance, but the least push would move it away'
            else
               result%message = 'No equilibrium found: at the end '// &
                  in_units(model%units, unit_force, last%residual_force, shown_residual)//' were out of balance at '
               call add_place(model, case_index, equations%unbalanced_md, result%message)
            end if
            if (last%flips > 0) result%message = result%message//', and '//to_text(last%flips)// &
               either(' gap', ' gaps', last%flips == 1)//' kept opening or closing'
         end select
         call position_at(model%trajectory, mesh%md(mesh%nodes), position, tangent)
         result%inclination = inclination_of(tangent)
         result%hookload = work%hookload - surface_push(model, case_index)
         ! the top of a part of a string may be pushed by the string above it
         if (outcome == outcome_converged .and. &
             is_pushed(model%rig%max_push - needed_push(model, case_index, result%hookload), work%axial) .and. &
             .not. top_md(model%trajectory) > 0.0_wp) call add_message(result, push_needed)
         if (outcome == outcome_converged .and. any(abs(work%held) > 0.0_wp)) &
            call add_message(result, 'Drag may be up to 0.13 % too low: a little friction was taken to keep the coils of the '// &
                             'buckled string from turning round the hole')
         if (outcome == outcome_converged .and. equations%gaps_taken_back) &
            call add_message(result, 'Contact points are not exactly where the string lies deepest: '//touched)
         if (outcome == outcome_converged) then
            call measure_outside(model%trajectory, mesh, work, outside)
            if (outside%elements > 0) call add_outside(model%units, outside, result)
         end if
         result%friction = buoyed_axial_weight(mesh) - work%weight_on_bit - work%hookload
         result%weight_on_bit = work%weight_on_bit
         result%torque = work%top_torque
         result%normal_force = sum(work%normal, work%normal > 0.0_wp)     ! thresholds let some gaps pull a little
         result%iterations = equations%iterations
         result%elements = mesh%elements
         result%states = count_states(gaps)
         result%flips = sum(gaps%flips)
         result%moves = sum(gaps%moves)
         call check_equilibrium(mesh, gaps, work, result%equilibrium_force, result%equilibrium_moment)
         if (outcome == outcome_converged) &
            call judge_balance(model%units, equations%force_scale, work%normal, whirls, result)
         call recover_gaps(mesh, gaps, work, result%gaps)
         call recover_bit(model%trajectory, mesh, work, side_force, side_clock, result%bit_tilt, result%bit_tilt_clock)
         if (model%boundary%bit_centred) then
            result%bit_side_force = side_force
            result%bit_side_clock = side_clock
         end if
         result%history = equations%history(:equations%iterations + 1)
      end associate
   end subroutine fill_result

   !> Warn of a rotating string that does not stay on one side of the hole, with its length and the resulting error. The
   !> warning is only given if torque at surface or the sum of contact forces changes noticeably. That sum counts if it is some
   !> percents of weight and bit load. On a side that is held, friction m*R sideways carries a part of the load w. The contact
   !> force is then R = w/sqrt(1 + m^2), and presses the wall at an angle atan(m) from the load. Without that friction it is w.
   pure subroutine warn_of_whirling(units, mesh, work, force_scale, result)
      type(unit_system_type), intent(in) :: units
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(in) :: force_scale       !< weight and bit load [N]
      type(case_result_type), intent(inout) :: result
      real(wp) :: high(mesh%elements), pressed(mesh%elements), length, by_contact, by_torque
      high = 1.0_wp - sqrt((1.0_wp + (work%sideways*mesh%friction_around)**2)/(1.0_wp + mesh%friction_around**2))
      pressed = max(work%normal, 0.0_wp)
      by_contact = sum(high*pressed)/max(sum(pressed), little_contact*force_scale)
      by_torque = sum(high*pressed*mesh%friction_around*mesh%radius)/max(abs(work%top_torque), least_moment)
      if (max(by_contact, by_torque) < unlike) return
      length = sum(mesh%length, mask=work%sideways < 1.0_wp .and. mesh%friction_around > 0.0_wp .and. work%axial < 0.0_wp)
      call add_message(result, 'Over '//in_units(units, unit_length, length, shown_range)// &
                       ' the rotating string does not stay on one side of the hole. Sideways friction is left out there: '// &
                       'contact force up to '//to_text(rounded_up(100.0_wp*maxval(high), shown_clearances), &
                       shown_clearances)//' % too high, torque at surface '// &
                       to_text(rounded_up(100.0_wp*by_torque, shown_clearances), shown_clearances)//' %. In bends and '// &
                       'at pads the side of contact is off by up to '// &
                       to_text(anint(atan(maxval(mesh%friction_around, mask=high*pressed > 0.0_wp))/degree))//' deg')
   end subroutine warn_of_whirling

   !> Reject a converged result if its forces are out of balance, or if walls pull. For a rotating string that does not stay on
   !> one side of the hole, balance is not checked: see warn_of_whirling.
   pure subroutine judge_balance(units, force_scale, normal, whirls, result)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: force_scale       !< weight and bit load [N]
      real(wp), intent(in) :: normal(:)         !< contact forces, negative where the wall pulls [N]
      logical, intent(in) :: whirls
      type(case_result_type), intent(inout) :: result
      type(numerics_type) :: usual
      real(wp) :: pulling, part
      pulling = -sum(normal, normal < 0.0_wp)
      part = result%equilibrium_force/force_scale
      if (whirls) part = 0.0_wp
      if (.not. (part > most_out_of_balance .or. pulling > max(most_pulled, part)*force_scale)) return
      result%status = result_not_converged
      if (part > most_out_of_balance) then
         result%message = 'Forces are '//in_units(units, unit_force, result%equilibrium_force, shown)// &
                          ' out of balance, '//to_text(100.0_wp*part, shown_clearances)//' % of weight and bit load'
      else
         result%message = 'Walls pull the string with '//in_units(units, unit_force, pulling, shown)// &
                          ' in all, as gaps open from r_n0 on. Set r_n0 to '// &
                          in_units(units, unit_force, usual%r_n0, shown)//', its default'
      end if
   end subroutine judge_balance

   !> Adds a warning to those of a result.
   pure subroutine add_message(result, text)
      type(case_result_type), intent(inout) :: result
      character(*), intent(in) :: text
      call add_sentence(result%message, text)
   end subroutine add_message

   !> Report another equilibrium of a helically buckled string, and let the error of the moments cover it.
   pure subroutine warn_of_range(units, other, mirrored, result)
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(in) :: other
      logical, intent(in) :: mirrored                   !< true: started from the mirror image; false: from the low side of the hole
      type(case_result_type), intent(inout) :: result
      character(:), allocatable :: text
      real(wp) :: largest, moment, other_moment
      if (other%status /= result_converged) then
         call add_message(result, 'A helically buckled string can be at rest at several hook loads. Two other starts '// &
                          'found no solution, so the range of hook load and moments is unknown')
         return
      end if
      text = ''
      largest = max(abs(result%hookload), maxval(abs(result%profile%axial)))
      if (abs(other%hookload - result%hookload) > worth_telling*largest) &
         text = ' the hook load is '//in_units(units, unit_force, other%hookload, shown)
      if (.not. (is_missing(result%moment_error) .or. is_missing(other%moment_error))) then
         moment = maxval(result%profile%bending)
         other_moment = maxval(other%profile%bending)
         result%moment_error = max(result%moment_error, beyond_both*abs(other_moment - moment) &
                                                        /max(moment, 1.0e-3_wp*other_moment, least_moment))
         if (abs(other_moment - moment) > moments_worth_telling*moment) then
            if (text /= '') text = text//' and'
            text = text//' the largest bending moment is '//in_units(units, unit_moment, other_moment, shown)
         end if
      end if
      if (text /= '') call add_message(result, 'A helically buckled string can be at rest at several hook loads. From '// &
                                       'another start, '// &
                                       either('with coils that turn the other way,', 'on the low side of the hole,', &
                                              mirrored)//text)
   end subroutine warn_of_range

   !> Warn of parts of the string that slope too much against the hole for the beam that gives the moments.
   pure subroutine warn_of_slope(units, md, longest, result)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: md(2)                     !< beginning and end of such elements [m]
      real(wp), intent(in) :: longest                   !< longest element of the analysis [m]
      type(case_result_type), intent(inout) :: result
      call add_message(result, 'Bending moments and stresses may be off by tens of per cent between '// &
                       in_units(units, unit_length, md(1), shown_depth)//' and '// &
                       in_units(units, unit_length, md(2), shown_depth)//'. The string slopes by more than a tenth '// &
                       'against its hole there, and they are those of elements of up to '// &
                       in_units(units, unit_length, longest, shown)//'. A smaller element_length makes them better')
   end subroutine warn_of_slope

   !> Warn if the contact force of the beam that gives the moments differs from the analysis. In a helically buckled string the
   !> beam is wrong. Hook loads then agree within 1e-3 on elements of any length even where it differs by 30 %. Otherwise both
   !> may be wrong.
   pure subroutine warn_of_contact(units, result)
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(inout) :: result
      real(wp) :: share
      character(:), allocatable :: place, percents
      associate (found => result%unlike_contact, md => result%profile%md)
         if (.not. found%by_analysis > least_contact) return
         share = max(abs(found%by_beam - found%by_analysis)/found%by_analysis, found%share)
         if (.not. share > unlike) return
         result%unlike_contact%warned = share
         if (is_pressed_at_points(result) .and. share < found%yielding) return
         place = ''
         if (found%md(2) - found%md(1) < nearly_all*(md(size(md)) - md(1))) place = ', mostly between '// &
            in_units(units, unit_length, found%md(1), shown_depth)//' and '//in_units(units, unit_length, found%md(2), shown_depth)
         percents = to_text(rounded_up(100.0_wp*share, shown_clearances), shown_clearances)//' %'
         call add_message(result, 'Contact force uncertain by '//percents//place//': its sum is '// &
                          in_units(units, unit_force, found%by_analysis, shown)//' by the usual elements, '// &
                          in_units(units, unit_force, found%by_beam, shown)//' by shorter ones. '// &
                          either('Side forces and moments'//either('', ' there', place == ''), 'Drag', result%coiled)// &
                          ' may be off by as much')
      end associate
   end subroutine warn_of_contact

   !> True if a good part of the contact is at points of a wall that is as good as rigid.
   pure function is_pressed_at_points(result) result(is)
      type(case_result_type), intent(in) :: result
      logical :: is
      associate (found => result%unlike_contact)
         is = .not. result%coiled .and. found%yielding >= yields .and. found%wall >= nearly_rigid .and. &
              found%by_beam >= least_contact
      end associate
   end function is_pressed_at_points

   !> Warn of contact at points of a wall that is as good as rigid. Rock yields there, which makes contact smaller.
   pure subroutine warn_of_points(units, result)
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(inout) :: result
      associate (found => result%unlike_contact)
         if (.not. is_pressed_at_points(result)) return
         call add_message(result, 'The string presses a rigid wall at single points, most at '// &
                          in_units(units, unit_length, found%point, shown_depth)//'. Rock yields there, so contact force and '// &
                          'drag are smaller by '//to_text(rounded_up(100.0_wp*found%yielding, shown_clearances), &
                          shown_clearances)//' % or more. Moments and side forces change, too. Set wall_stiffness of the hole, '// &
                          in_units(units, unit_wall, sandstone, shown)//' for sandstone')
      end associate
   end subroutine warn_of_points

   !> Add remarks on the course of the solution. Shorter elements are not advised for helically buckled strings, which often
   !> keep such contact points on them.
   subroutine add_remarks(units, mesh, asked, numerics, result)
      type(unit_system_type), intent(in) :: units
      type(mesh_type), intent(in) :: mesh
      type(numerics_type), intent(in) :: asked, numerics     !< settings of the deck, and of the last attempt
      type(case_result_type), intent(inout) :: result
      if (result%status == result_converged .and. numerics%gap_location /= asked%gap_location) &
         call add_message(result, "Converged only with gap_location = '"//trim(gap_location_name(numerics%gap_location))// &
                          "'. Allow 1 % on hook load, torque and contact force, and "//touched)
      if (index(result%message, touched) == 0 .or. result%coiled) return
      if (advised*maxval(mesh%length) > shortest_advised) call add_message(result, 'An element_length of '// &
         in_units(units, unit_length, advised*maxval(mesh%length), shown_clearances)// &
         ' gives most strings contact points where they lie deepest')
   end subroutine add_remarks

   !> Warn of a string that is outside its hole.
   pure subroutine add_outside(units, outside, result)
      type(unit_system_type), intent(in) :: units
      type(outside_type), intent(in) :: outside
      type(case_result_type), intent(inout) :: result
      character(:), allocatable :: text
      if (index(result%message, outside_place) > 0) return
      call outside_message(units, outside, text)
      call add_message(result, text)
   end subroutine add_outside

   !> Largest distance of a node outside the hole, over the clearance [-], and that node. Between two gaps the string does not
   !> feel the wall. If a node is outside by a good part of the clearance, the solution is not valid. Where a gap beside the
   !> node presses into the wall, the hole counts as wider by that.
   pure subroutine look_outside(model, mesh, work, worst, place)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      real(wp), intent(out) :: worst   !< offset over clearance, less one; < 0 inside [-]
      integer, intent(out) :: place
      real(wp) :: gap(3), tangent(3), outside, wide
      integer :: n, beside(2)
      worst = -1.0_wp
      place = 1
      do n = 1, mesh%nodes
         call node_offset(model%trajectory, mesh, work, n, gap, tangent)
         beside = [max(n - 1, 1), min(n, mesh%elements)]
         wide = widest_beside(mesh, n)
         outside = (sqrt(gap(1)**2 + gap(2)**2 + gap(3)**2) &
                    - max(wide, maxval(work%displacement(beside), mask=work%normal(beside) > 0.0_wp)))/wide
         if (outside <= worst) cycle
         worst = outside
         place = n
      end do
   end subroutine look_outside
end module dg_static_result

!> Results of a string as a whole: stretch, twist, neutral points, and margins to its limits.
module dg_whole_string
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_buckled_shape, only: find_buckled_shape, span_of
   use dg_buckling_limits, only: buckling_helical, buckling_none, buckling_sinusoidal
   use dg_case_result, only: case_result_type
   use dg_casing_wear, only: find_casing_wear, groove_type, worst_groove
   use dg_component, only: axial_stiffness, bending_stiffness, contact_diameter, room_of, torsional_stiffness, worn_od
   use dg_drillstring, only: component_at, component_tops
   use dg_fatigue, only: fatigue_type, find_fatigue
   use dg_job, only: model_mcge
   use dg_length_change, only: asks_for_length, find_length_change, length_change_type
   use dg_line_load, only: largest_mean
   use dg_load_case, only: block_way
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: is_straightened, model_type, string_index
   use dg_pipe_stress, only: tension_capacity
   use dg_profile, only: piece_depths
   use dg_soft_string_loads, only: other_loads_type, soft_string_at
   use dg_trajectory, only: top_md
   use dg_utilisation, only: as_much, utilisation_type
   use dg_verdict, only: verdict_type
   use dg_weight_on_bit, only: most_weight_on_bit, weight_that_arrives
   implicit none
   private
   public :: whole_string_type, find_whole_string, neutral_points_of

   type :: whole_string_type
      real(wp) :: stretch = 0.0_wp                  !< of the effective axial force, longer > 0 [m]
      real(wp) :: pressure_stretch = 0.0_wp         !< by the pressures inside and outside, longer > 0 [m]
      real(wp) :: windup = 0.0_wp                   !< turn of the top against the bit [rad]
      real(wp), allocatable :: neutral_points(:)    !< depths where the effective axial force changes sign [m]
      type(optional_real) :: least_safety           !< least safety factor [-]
      type(optional_real) :: least_safety_md        !< its depth [m]
      type(optional_real) :: least_envelope_margin  !< of the tension-torque envelope [-]
      type(optional_real) :: overpull_margin        !< pull that may be added until a limit by yield anywhere, bending included [N]
      type(optional_real) :: buckling_margin        !< least, < 0 where the string is buckled [N]
      type(optional_real) :: buckling_margin_md     !< its depth [m]
      integer :: buckling = buckling_none           !< worst state along the string
      real(wp) :: sinusoidal_length = 0.0_wp        !< above the sinusoidal, below the helical limit [m]
      real(wp) :: helical_length = 0.0_wp           !< above the helical limit [m]
      type(optional_real) :: buckled_span(2)        !< first and last depth above the sinusoidal limit [m]
      real(wp) :: bending = 0.0_wp                  !< largest moment [N.m]
      real(wp) :: bending_md = 0.0_wp               !< its depth [m]
      type(optional_real) :: bending_error          !< error of moments, over the largest one [-]
      type(optional_real) :: contact_difference     !< of two analyses in the part where they differ most [-]
      real(wp) :: von_mises = 0.0_wp                !< largest stress [Pa]
      type(optional_real) :: von_mises_error        !< error of that stress by bending_error, over it [-]
      real(wp) :: side_force = 0.0_wp               !< largest mean over the length of a joint of pipe [N/m]
      real(wp) :: side_force_md = 0.0_wp            !< its depth [m]
      type(optional_real) :: wob_buckling           !< weight on bit at which buckling begins anywhere [N]
      type(optional_real) :: wob_no_hookload        !< weight on bit at zero hook load [N]
      type(optional_real) :: wob_lockup             !< with friction of helical buckling and max_push of the rig [N]
      type(optional_real) :: wob_yield              !< at which a compressed part yields, if less than wob_lockup [N]
      integer :: shape = buckling_none              !< worst state by beams, gap elements only
      real(wp) :: snaking_length = 0.0_wp           !< length in sinusoidal buckling by beams [m]
      real(wp) :: coiled_length = 0.0_wp            !< length in helical buckling by beams [m]
      real(wp) :: coil_turns = 0.0_wp               !< turns of the coils [-]
      type(optional_real) :: shape_span(2)          !< first and last depth that is buckled by beams [m]
      type(optional_real) :: stability_margin       !< as the result has it [-]
      type(optional_real) :: bit_side_force         !< of the bit on the formation, gap elements with the bit held only [N]
      type(optional_real) :: bit_side_clock         !< its direction [rad]
      type(optional_real) :: bit_tilt               !< angle between bit and hole, gap elements only [rad]
      type(optional_real) :: bit_tilt_clock         !< its direction [rad]
      type(optional_real) :: sag_correction         !< to be added to the inclination that the survey sensor reads [rad]
      type(optional_real) :: sensor_md              !< where the sensor is [m]
      type(length_change_type) :: length_change     !< of the string, in its parts [m]
      type(optional_real) :: packer_force           !< of the string on its packer without pressures, down > 0 [N]
      type(groove_type) :: groove                   !< groove in casing with the least wall left
      type(fatigue_type) :: fatigue                 !< of the body with the most fatigue
      type(fatigue_type) :: joint_fatigue           !< of the connection with the most fatigue
      type(optional_real) :: yield_left             !< least along the string, if it is warm, over that of the deck [-]
      type(optional_real) :: yield_left_md          !< its depth [m]
      type(optional_real) :: rig_limit              !< load that the rig may carry [N]
      type(optional_real) :: rig_margin             !< rig_limit - hook load - block weight [N]
      type(optional_real) :: makeup_margin          !< least make-up torque - torque [N.m]
      type(optional_real) :: makeup_margin_md       !< its depth [m]
      type(optional_real) :: least_standoff         !< of the body, gap elements only [-]
      type(optional_real) :: least_standoff_md      !< its depth [m]
      type(utilisation_type) :: utilisation         !< of strengths, set by find_utilisation
      type(verdict_type) :: verdict                 !< set by find_verdict
   end type whole_string_type

   !> Axial force that counts as zero, over the largest in the string [-]. Round-off at an unloaded bit makes no neutral point.
   real(wp), parameter :: no_force = 1.0e-9_wp
   !> Accuracy of a weight on bit over the bracket [-].
   real(wp), parameter :: tolerance = 1.0e-11_wp
   !> Margin of a string that nothing makes yield [N].
   real(wp), parameter :: endless = 1.0e15_wp

contains

   !> Find all of it, from a result and its columns along the string. Weights on bit are those of a soft string with the
   !> friction of this case, whatever the model. With beams they would cost a hundred solutions. The first two neglect the
   !> contact force by buckling. They are absent for operations that pull.
   pure subroutine find_whole_string(model, result, along, whole)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(whole_string_type), intent(out) :: whole
      type(groove_type), allocatable :: grooves(:)
      type(fatigue_type), allocatable :: parts(:)
      real(wp) :: length, coiled
      integer :: i
      associate (profile => result%profile)
         call add_deformation(model, result, along, whole)
         if (asks_for_length(model, model%cases(result%case_index))) &
            call find_length_change(model, result, along, whole%length_change)
         allocate (whole%neutral_points, source=neutral_points_of(profile%md, profile%axial))
         call least_of(along%safety_factor, profile%md, whole%least_safety, whole%least_safety_md)
         if (any(along%yield_left < 1.0_wp)) call least_of(along%yield_left, profile%md, whole%yield_left, whole%yield_left_md)
         call least_of(along%envelope_margin, profile%md, whole%least_envelope_margin)
         call least_of(along%overpull, profile%md, whole%overpull_margin)
         call least_of(along%buckling_margin, profile%md, whole%buckling_margin, whole%buckling_margin_md)
         call least_of(along%standoff, profile%md, whole%least_standoff, whole%least_standoff_md)
         whole%buckling = maxval(along%buckling)
         whole%buckled_span = span_of(along%buckling > buckling_none, profile%md)
         do i = 2, size(profile%md)
            length = profile%md(i) - profile%md(i - 1)
            coiled = length*share_beyond(along%helical(i - 1:i), profile%axial(i - 1:i))
            whole%helical_length = whole%helical_length + coiled
            whole%sinusoidal_length = whole%sinusoidal_length + &
                                      max(length*share_beyond(along%sinusoidal(i - 1:i), profile%axial(i - 1:i)) - coiled, 0.0_wp)
         end do
         i = maxloc(profile%bending, dim=1)
         whole%bending = profile%bending(i)
         whole%bending_md = profile%md(i)
         call copy_number(result%moment_error, whole%bending_error)
         if (whole%bending_error%present) whole%contact_difference = given(result%unlike_contact%share)
         i = maxloc(along%von_mises, dim=1)
         whole%von_mises = along%von_mises(i)
         if (whole%bending_error%present .and. whole%von_mises > 0.0_wp) whole%von_mises_error = &
            given(whole%bending_error%value*whole%bending*along%per_moment(i)/whole%von_mises)
         call largest_mean(profile%md, profile%side_force, along%pipe_joint, whole%side_force, i)
         whole%side_force_md = profile%md(i)
      end associate
      whole%packer_force = optional_real(model%boundary%packer_bore > 0.0_wp, model%cases(result%case_index)%wob)
      if (result%model == model_mcge) call add_shape(model, result, along, whole)
      call find_casing_wear(model, result, grooves)
      whole%groove = worst_groove(grooves)
      call find_fatigue(model, result, along, parts)
      do i = size(parts), 1, -1     ! the worst one last
         if (parts(i)%joint) whole%joint_fatigue = parts(i)
         if (.not. parts(i)%joint) whole%fatigue = parts(i)
      end do
      call copy_number(result%stability_margin, whole%stability_margin)
      if (.not. is_straightened(model, model%cases(result%case_index))) then     ! one that turns has a mean over its tool faces
         call copy_number(result%bit_side_force, whole%bit_side_force)
         call copy_number(result%bit_side_clock, whole%bit_side_clock)
         call copy_number(result%bit_tilt, whole%bit_tilt)
         call copy_number(result%bit_tilt_clock, whole%bit_tilt_clock)
      end if
      call copy_number(result%sag_correction, whole%sag_correction)
      call copy_number(result%sensor_md, whole%sensor_md)
      call add_margins(model, result, whole)
      call add_weights_on_bit(model, result, along, whole)
   end subroutine find_whole_string

   !> Part of the string between two rows with compression above a limit, by a straight line [-]; 0 without a limit.
   pure function share_beyond(limit, axial) result(share)
      real(wp), intent(in) :: limit(2)   !< compression, may be missing [N]
      real(wp), intent(in) :: axial(2)   !< tension > 0 [N]
      real(wp) :: share, beyond(2)
      share = 0.0_wp
      if (any(is_missing(limit))) return
      beyond = -axial - limit
      if (.not. any(beyond > 0.0_wp)) return
      share = maxval(beyond)/(maxval(beyond) - min(minval(beyond), 0.0_wp))
   end function share_beyond

   !> Convert a number that may be missing to one that may be absent.
   elemental subroutine copy_number(number, optional)
      real(wp), intent(in) :: number
      type(optional_real), intent(out) :: optional
      if (.not. is_missing(number)) optional = given(number)
   end subroutine copy_number

   !> Stretch and wind-up: integrals over the string of T/(EA), M/(GJ) and, for the pressures, -(1 - 2 nu) p/E. By Hooke's law
   !> with axial, hoop and radial stress p = (p_o A_o - p_i A_i)/A, where T is the effective force. A pressure on all sides has
   !> p equal to it. Trapezoids between rows; no component ends between two rows.
   pure subroutine add_deformation(model, result, along, whole)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(whole_string_type), intent(inout) :: whole
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, length, pressure
      integer :: i, string
      string = string_index(model%strings, model%cases(result%case_index)%string)
      bit = model%cases(result%case_index)%bit_depth
      allocate (tops, source=component_tops(model%strings(string), bit - top_md(model%trajectory)))
      associate (profile => result%profile)
         do i = 2, size(profile%md)
            length = profile%md(i) - profile%md(i - 1)
            associate (part => model%strings(string)%components(component_at(tops, &
                       bit - 0.5_wp*(profile%md(i - 1) + profile%md(i)))))
               pressure = 0.5_wp*(along%pressure(i - 1) + along%pressure(i)) - 0.5_wp*part%id**2/((part%od - part%id)* &
                          (part%od + part%id))*sum(along%inside_pressure(i - 1:i) - along%pressure(i - 1:i))
               whole%stretch = whole%stretch + 0.5_wp*length*sum(profile%axial(i - 1:i))/axial_stiffness(part)
               whole%windup = whole%windup + 0.5_wp*length*sum(profile%torque(i - 1:i))/torsional_stiffness(part)
               whole%pressure_stretch = whole%pressure_stretch - length*(1.0_wp - 2.0_wp*part%poisson)*pressure/part%youngs
            end associate
         end do
      end associate
   end subroutine add_deformation

   !> Depths [m] at which a force changes its sign, from the top down, linear between rows.
   pure function neutral_points_of(md, force) result(points)
      real(wp), intent(in) :: md(:)      !< [m]
      real(wp), intent(in) :: force(:)   !< [N]
      real(wp), allocatable :: points(:)
      real(wp) :: least
      integer :: i, last
      allocate (points(0))
      least = no_force*maxval(abs(force))
      last = 0
      do i = 1, size(md)
         if (abs(force(i)) <= least) cycle
         if (last > 0) then
            if ((force(i) > 0.0_wp) .neqv. (force(last) > 0.0_wp)) &
               points = [points, md(last) + (md(i) - md(last))*force(last)/(force(last) - force(i))]
         end if
         last = i
      end do
   end function neutral_points_of

   !> Least of numbers that may be missing, and its depth [m].
   pure subroutine least_of(numbers, md, least, least_md)
      real(wp), intent(in) :: numbers(:)
      real(wp), intent(in) :: md(:)
      type(optional_real), intent(out) :: least
      type(optional_real), intent(out), optional :: least_md
      integer :: i
      if (all(is_missing(numbers))) return
      i = minloc(numbers, mask=.not. is_missing(numbers), dim=1)
      least = given(numbers(i))
      if (present(least_md)) least_md = given(md(i))
   end subroutine least_of

   !> Add the buckled shape by beams.
   pure subroutine add_shape(model, result, along, whole)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(whole_string_type), intent(inout) :: whole
      real(wp), allocatable :: tops(:), ei(:)
      integer :: shape(size(result%profile%md)), i
      real(wp) :: length, bit, depths(size(result%profile%md))
      bit = model%cases(result%case_index)%bit_depth
      associate (profile => result%profile, string => model%strings(string_index(model%strings, &
                                                                                 model%cases(result%case_index)%string)))
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         depths = piece_depths(profile)
         allocate (ei, source=[(bending_stiffness(string%components(component_at(tops, bit - depths(i)))), &
                                i=1, size(profile%md))])
         call find_buckled_shape(profile%md, profile%axial, &
                                 profile%displacement/room_of(0.5_wp*(along%hole_diameter - along%od)), profile%clock, ei, &
                                 along%sinusoidal, shape, whole%coil_turns)
         whole%shape = maxval(shape)
         whole%shape_span = span_of(shape > buckling_none, profile%md)
         do i = 2, size(shape)
            length = profile%md(i) - profile%md(i - 1)
            if (minval(shape(i - 1:i)) == buckling_sinusoidal) whole%snaking_length = whole%snaking_length + length
            if (minval(shape(i - 1:i)) == buckling_helical) whole%coiled_length = whole%coiled_length + length
         end do
      end associate
   end subroutine add_shape

   !> Hook load against the rig, and torque against make-up torque. Where two components meet each has a row, so that the
   !> weaker connection counts.
   pure subroutine add_margins(model, result, whole)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(whole_string_type), intent(inout) :: whole
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, margin, depths(size(result%profile%md))
      integer :: i, string
      whole%rig_limit = model%rig%max_hookload
      if (whole%rig_limit%present) &
         whole%rig_margin = given(whole%rig_limit%value - model%rig%block_weight - result%hookload)
      string = string_index(model%strings, model%cases(result%case_index)%string)
      bit = model%cases(result%case_index)%bit_depth
      allocate (tops, source=component_tops(model%strings(string), bit - top_md(model%trajectory)))
      depths = piece_depths(result%profile)
      do i = 1, size(result%profile%md)
         associate (part => model%strings(string)%components(component_at(tops, bit - depths(i))))
            if (.not. part%makeup_torque > 0.0_wp) cycle
            margin = part%makeup_torque - abs(result%profile%torque(i))
            if (whole%makeup_margin%present .and. margin >= whole%makeup_margin%value - as_much*part%makeup_torque) cycle
         end associate
         whole%makeup_margin = given(margin)
         whole%makeup_margin_md = given(result%profile%md(i))
      end do
   end subroutine add_margins

   !> Weights on bit at which the string begins to buckle, and at zero hook load. They are roots, as more weight on bit lowers
   !> the axial force everywhere.
   pure subroutine add_weights_on_bit(model, result, along, whole)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(whole_string_type), intent(inout) :: whole
      type(bracket_type) :: bracket
      real(wp) :: high, at_none, at_high, narrowness, wob
      integer :: k, lowest
      k = result%case_index
      if (block_way(model%cases(k)%operation) > 0) return
      lowest = findloc(is_missing(along%onset), .false., dim=1, back=.true.)     ! a bit that fills its hole has no limit
      if (lowest > 0) then
         high = along%onset(lowest)
         at_high = least_margin(model, k, result%profile%md, along%onset, high)
         do while (at_high > 0.0_wp)     ! the compression there is the weight on bit less the weight below
            high = 2.0_wp*high
            at_high = least_margin(model, k, result%profile%md, along%onset, high)
         end do
         at_none = least_margin(model, k, result%profile%md, along%onset, 0.0_wp)
         if (at_none < 0.0_wp) high = 0.0_wp
         if (at_none >= 0.0_wp .and. at_high < 0.0_wp) then
            bracket = new_bracket(0.0_wp, at_none, high, at_high)
            narrowness = tolerance*high
            do while (.not. is_narrow(bracket, narrowness))
               wob = next_try(bracket, narrowness)
               call narrow(bracket, wob, least_margin(model, k, result%profile%md, along%onset, wob))
            end do
            high = bracket%high
         end if
         whole%wob_buckling = given(high)
      end if
      whole%wob_no_hookload = given(most_weight_on_bit(model, k, coiled=.false., pushed=.false.))
      whole%wob_lockup = given(weight_that_arrives(model, result))
      high = whole%wob_lockup%value
      at_high = margin_to_yield(model, result, along, high)
      if (at_high >= 0.0_wp) return
      at_none = margin_to_yield(model, result, along, 0.0_wp)
      whole%wob_yield = given(0.0_wp)
      if (at_none < 0.0_wp) return
      bracket = new_bracket(0.0_wp, at_none, high, at_high)
      narrowness = tolerance*high
      do while (.not. is_narrow(bracket, narrowness))
         wob = next_try(bracket, narrowness)
         call narrow(bracket, wob, margin_to_yield(model, result, along, wob))
      end do
      whole%wob_yield = given(bracket%high)
   end subroutine add_weights_on_bit

   !> Compression that may be added before a compressed part yields under a weight on bit [N]. It is < 0 if one yields, and
   !> `endless` if none is compressed. The moment is that of the result, or EI times the hole's curvature where the result is
   !> beyond a buckling limit. Above its helical limit c F/2 is added (Lubinski, Althouse & Logan 1962).
   pure function margin_to_yield(model, result, along, wob) result(margin)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      real(wp), intent(in) :: wob                !< [N]
      real(wp) :: margin
      real(wp), dimension(size(result%profile%md)) :: axial, torque, depths
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, moment
      integer :: i, place
      margin = endless
      bit = model%cases(result%case_index)%bit_depth
      call soft_string_at(model, result%case_index, result%profile%md, axial, torque, &
                          other=other_loads_type(coiled=.true., wob=given(wob)))
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         depths = piece_depths(result%profile)
         do i = 1, size(axial)
            if (axial(i) >= 0.0_wp) cycle
            place = component_at(tops, bit - depths(i))
            associate (part => string%components(place))
               if (.not. part%yield > 0.0_wp) cycle
               moment = result%profile%bending(i)
               if (along%buckling(i) /= buckling_none) moment = bending_stiffness(part)*along%curvature(i)
               if (-axial(i) > max(along%helical(i), 0.0_wp) .and. .not. is_missing(along%helical(i))) moment = moment - &
                  0.25_wp*(along%hole_diameter(i) - contact_diameter(part, bit - tops(place)))*axial(i)
               margin = min(margin, axial(i) + tension_capacity(worn_od(part), part%id, torque(i), moment, &
                                                                along%inside_pressure(i) - along%pressure(i), &
                                                                along%yield_left(i)*part%yield))
            end associate
         end do
      end associate
   end function margin_to_yield

   !> Least of axial force plus allowed compression over some depths, for a weight on bit [N].
   pure function least_margin(model, case_index, md, allowed, wob) result(margin)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)              !< [m]
      real(wp), intent(in) :: allowed(:)         !< compression, may be missing [N]
      real(wp), intent(in) :: wob                !< [N]
      real(wp) :: margin
      real(wp) :: axial(size(md)), torque(size(md))
      call soft_string_at(model, case_index, md, axial, torque, other=other_loads_type(wob=given(wob)))
      margin = minval(axial + max(allowed, 0.0_wp), mask=.not. is_missing(allowed))
   end function least_margin
end module dg_whole_string

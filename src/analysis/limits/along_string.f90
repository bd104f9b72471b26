!> Results along the string: pressures, true axial force, stresses, safety factors, buckling limits. They follow from the
!> profile of any model and the data of string, hole and mud.
!>
!> Pressures are hydrostatic (dg_fluid_pressure). A row has one component, hole section and pair of fluids: those on its side
!> (dg_profile). Where two bends meet at a row without a side, the lower buckling limits are used.
module dg_along_string
   use dg_kinds, only: wp
   use dg_buckling_limits, only: buckled_state, buckling_none, curved_limit, helical_high, helical_limit, helical_low, &
                                 lubinski_first, vertical_unit
   use dg_case_result, only: case_result_type, contact_joint
   use dg_component, only: bending_stiffness, component_type, contact_diameter, has_joints, &
                           joint_bore, tube_inertia, worn_od
   use dg_drillstring, only: component_at, component_tops, pipe_joint
   use dg_fluid, only: side_inside, side_outside
   use dg_fluid_pressure, only: fluid_column_type, new_fluid_column, pressure_at, weight_at
   use dg_hole_section, only: hole_section_at
   use dg_job, only: model_mcge
   use dg_joint_bending, only: joint_magnification, pulled_magnification
   use dg_line_load, only: force_between
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_pipe_stress, only: pipe_stress, pipe_stress_type, true_axial
   use dg_pipe_strength, only: tensile_strength, yield_left
   use dg_profile, only: between_ends, piece_depths, side_above, side_below
   use dg_pull_margin, only: pull_margin
   use dg_trajectory, only: arc_at, point_on_arc, top_md
   implicit none
   private
   public :: along_string_type, find_along_string, new_along_string, body_bending

   !> Columns with one value a row of the profile, `missing` where there is no value. That holds for safety factors without a
   !> yield strength, and buckling limits of a weightless string in a straight hole. It also holds for columns of tool joints
   !> without joints.
   type :: along_string_type
      real(wp), allocatable :: pressure(:)          !< of the fluid outside [Pa]
      real(wp), allocatable :: inside_pressure(:)   !< of the fluid inside [Pa]
      real(wp), allocatable :: true_axial(:)        !< axial force in the wall, tension > 0 [N]
      real(wp), allocatable :: axial_stress(:)      !< of the true axial force [Pa]
      real(wp), allocatable :: bending_stress(:)    !< amplitude at the outer surface [Pa]
      real(wp), allocatable :: per_moment(:)        !< bending stress over moment there [1/m3]
      real(wp), allocatable :: torsional_stress(:)  !< at the outer surface [Pa]
      real(wp), allocatable :: hoop_stress(:)       !< at the inner surface [Pa]
      real(wp), allocatable :: von_mises(:)         !< largest in the section [Pa]
      real(wp), allocatable :: jointed_von_mises(:) !< largest with the bending next to tool joints or between them [Pa]
      real(wp), allocatable :: yield_left(:)        !< yield strength at the local temperature over that of the deck [-]
      real(wp), allocatable :: safety_factor(:)     !< yield strength at the local temperature over von_mises [-]
      real(wp), allocatable :: envelope_margin(:)   !< part of the tension-torque envelope left, bending included [-]
      real(wp), allocatable :: overpull(:)          !< tension that may be added here until a limit by yield, bending included [N]
      real(wp), allocatable :: bending_range(:)     !< range of stress in a turn of the string; 0 if it does not turn [Pa]
      real(wp), allocatable :: magnification(:)     !< magnification of bending between single tool joints [-]
      real(wp), allocatable :: jointed_bending(:)   !< bending stress of the body next to tool joints or between them [Pa]
      real(wp), allocatable :: joint_bending(:)     !< bending stress outside a tool joint, if one stands here [Pa]
      real(wp), allocatable :: joint_von_mises(:)   !< largest stress in a tool joint, if one stands here [Pa]
      real(wp), allocatable :: joint_side_force(:)  !< contact force of a tool joint [N]
      real(wp), allocatable :: sinusoidal(:)        !< compression at sinusoidal buckling, in the present position [N]
      real(wp), allocatable :: onset(:)             !< least such compression, as it increases from zero [N]
      real(wp), allocatable :: helical(:)           !< compression at helical buckling, the lower published limit [N]
      real(wp), allocatable :: helical_upper(:)     !< the upper published limit [N]
      real(wp), allocatable :: buckling_margin(:)   !< compression left before sinusoidal buckling [N]
      integer, allocatable :: buckling(:)           !< buckling_none, buckling_sinusoidal, buckling_helical
      real(wp), allocatable :: curvature(:)         !< of the hole, the larger where two bends meet [1/m]
      real(wp), allocatable :: od(:)                !< of the body [m]
      real(wp), allocatable :: hole_diameter(:)     !< of the hole [m]
      real(wp), allocatable :: standoff(:)          !< of the body: least annular distance over that of a centred body [-]
      real(wp) :: pipe_joint = 0.0_wp               !< length of a joint of pipe, for side forces [m]
   end type along_string_type

   !> Half the distance between two places in the bend above a row and in the bend below it [m].
   real(wp), parameter :: hair = 1.0e-6_wp

contains

   !> Compute all columns, one value a row of `result%profile`. Only the overpull takes the design factors.
   pure subroutine find_along_string(model, result, along)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(out) :: along
      real(wp), allocatable :: tops(:)
      type(fluid_column_type) :: outside, inside
      real(wp) :: bit, weight, curvature, moment, depths(size(result%profile%md))
      integer :: i, k, n, string, part, hole, first, last, arc(2)
      logical :: apart, solved      ! joint by joint; bending between contacts
      apart = model%numerics%discrete_joints .and. result%model == model_mcge
      n = size(result%profile%md)
      depths = piece_depths(result%profile)
      along = new_along_string(n)
      string = string_index(model%strings, model%cases(result%case_index)%string)
      bit = model%cases(result%case_index)%bit_depth
      allocate (tops, source=component_tops(model%strings(string), bit - top_md(model%trajectory)))
      along%pipe_joint = pipe_joint(model%strings(string), tops)
      call new_fluid_column(model, model%cases(result%case_index), side_outside, outside)
      call new_fluid_column(model, model%cases(result%case_index), side_inside, inside)
      associate (profile => result%profile, components => model%strings(string)%components)
         arc = 1
         do i = 1, n
            part = component_at(tops, bit - depths(i))
            hole = hole_section_at(model%holes, depths(i))
            ! two bends may meet at a row without a side
            first = merge(2, 1, profile%side(i) == side_below)
            last = merge(1, 2, profile%side(i) == side_above)
            do k = first, last
               arc(k) = arc_at(model%trajectory, min(max(profile%md(i) + merge(-hair, hair, k == 1), &
                                                         top_md(model%trajectory)), bit), near=arc(k))
            end do
            weight = weight_at(components(part), model, model%cases(result%case_index), depths(i))
            solved = apart .or. (components(part)%centralizer%present .and. result%model == model_mcge)
            along%pressure(i) = pressure_at(outside, depths(i), profile%tvd(i))
            along%inside_pressure(i) = pressure_at(inside, depths(i), profile%tvd(i))
            along%hole_diameter(i) = model%holes(hole)%diameter
            along%yield_left(i) = yield_left(components(part), warmth(i))
            curvature = curvature_at(model, profile%md(i), arc(first))
            moment = profile%bending(i)
            if (.not. solved) moment = moment_between(components(part), profile%axial(i), moment, &
                                                      max(curvature, curvature_at(model, profile%md(i), arc(last))))
            call set_stress(i, components(part), profile%axial(i), profile%torque(i), profile%bending(i), moment, along)
            call set_joint(i, components(part), profile%axial(i), profile%torque(i), profile%bending(i), moment, curvature, &
                           solved, along)
            do k = first, last
               if (k == first .or. arc(2) /= arc(1)) &
                  call lower_limits(model, i, profile%md(i), -profile%axial(i), components(part), weight, &
                                    0.5_wp*(model%holes(hole)%diameter - contact_diameter(components(part), bit - tops(part))), &
                                    arc(k), along)
            end do
            if (result%model == model_mcge) along%standoff(i) = standoff_of(components(part)%od, model%holes(hole)%diameter, &
                                                                            profile%displacement(i))
            if (rotates(model%cases(result%case_index)%operation)) along%bending_range(i) = 2.0_wp*along%bending_stress(i)
            if (.not. is_missing(along%sinusoidal(i))) then
               along%buckling_margin(i) = along%sinusoidal(i) + profile%axial(i)
               along%buckling(i) = buckled_state(-profile%axial(i), along%sinusoidal(i), along%helical(i))
            end if
            if (components(part)%yield > 0.0_wp) along%overpull(i) = min( &
               along%yield_left(i)*tensile_strength(components(part))/model%design%tension - profile%axial(i), &
               pull_margin(components(part), along%yield_left(i)*components(part)%yield/model%design%von_mises, profile%axial(i), &
                           profile%torque(i), profile%bending(i), along%curvature(i), solved, &
                           along%buckling(i) /= buckling_none, along%inside_pressure(i) - along%pressure(i)))
         end do
      end associate
      if (.not. apart) call set_joint_loads(model%strings(string)%components, tops, bit, result, along)
      if (apart .and. allocated(result%contacts)) call set_joint_forces(result, along)

   contains

      !> Temperature above ambient at a row [K].
      pure function warmth(row) result(warmer)
         integer, intent(in) :: row
         real(wp) :: warmer
         associate (load_case => model%cases(result%case_index))
            warmer = between_ends(result%profile, row, load_case%above_ambient_top, load_case%above_ambient_bottom)
         end associate
      end function warmth
   end subroutine find_along_string

   !> Bending stress of the body at a row [Pa], next to tool joints where only these touch.
   pure function body_bending(along, row) result(stress)
      type(along_string_type), intent(in) :: along
      integer, intent(in) :: row
      real(wp) :: stress
      stress = along%bending_stress(row)
      if (.not. is_missing(along%jointed_bending(row))) stress = along%jointed_bending(row)
   end function body_bending

   !> Contact forces of tool joints whose pipe lies on the wall as a whole. Each carries the force on one joint_spacing of its
   !> component, half of it above and half below. That length ends with the component. In a shorter component it is the whole
   !> component.
   pure subroutine set_joint_loads(components, tops, bit, result, along)
      type(component_type), intent(in) :: components(:)
      real(wp), intent(in) :: tops(:)    !< from component_tops [m]
      real(wp), intent(in) :: bit        !< [m]
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(inout) :: along
      real(wp), dimension(size(result%profile%md)) :: depths, upper, lower, force
      real(wp) :: above, below, length
      logical :: bears(size(depths))
      integer :: i, part
      depths = piece_depths(result%profile)
      do i = 1, size(depths)
         part = component_at(tops, bit - depths(i))
         above = max(bit - tops(part), result%profile%md(1))
         below = bit
         if (part > 1) below = bit - tops(part - 1)
         length = min(components(part)%joint_spacing, below - above)
         upper(i) = min(max(result%profile%md(i) - 0.5_wp*length, above), below - length)
         lower(i) = upper(i) + length
         bears(i) = has_joints(components(part)) .and. &
                    .not. (components(part)%centralizer%present .and. result%model == model_mcge)
      end do
      force = force_between(result%profile%md, result%profile%side_force, upper, lower)
      where (bears) along%joint_side_force = force
   end subroutine set_joint_loads

   !> Contact forces of tool joints that were solved one by one, each at the row nearest to it, and 0 at other rows with
   !> joints.
   pure subroutine set_joint_forces(result, along)
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(inout) :: along
      integer :: i, row
      where (.not. is_missing(along%magnification)) along%joint_side_force = 0.0_wp
      do i = 1, size(result%contacts)
         if (result%contacts(i)%kind /= contact_joint) cycle
         row = minloc(abs(result%profile%md - result%contacts(i)%md), dim=1, mask=.not. is_missing(along%magnification))
         if (row > 0) along%joint_side_force(row) = max(along%joint_side_force(row), result%contacts(i)%force)
      end do
   end subroutine set_joint_forces

   !> Largest moment next to tool joints, or between them, of a string that was not solved joint by joint [N.m]. It is the
   !> larger of its own moment and that of the hole's curvature, plus the magnification there. In tension the body's contact
   !> with the wall is included. In compression beyond the closed form it is its own moment.
   elemental function moment_between(part, axial, moment, curvature) result(largest)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial       !< effective [N]
      real(wp), intent(in) :: moment      !< own moment, >= 0 [N.m]
      real(wp), intent(in) :: curvature   !< of the hole [1/m]
      real(wp) :: largest
      real(wp) :: factor
      largest = moment
      if (.not. (has_joints(part) .and. curvature > 0.0_wp)) return
      associate (ei => bending_stiffness(part), half => 0.5_wp*part%joint_spacing, off => 0.5_wp*(part%joint_od - part%od))
         if (axial > 0.0_wp) then
            factor = pulled_magnification(axial, ei, half, curvature, off)
         else
            factor = joint_magnification(axial, ei, half, curvature, off)
         end if
         if (.not. is_missing(factor)) largest = max(moment, ei*curvature) + ei*curvature*(factor - 1.0_wp)
      end associate
   end function moment_between

   !> Stresses at row `i`. Its pressures and yield strength must be set.
   pure subroutine set_stress(i, part, axial, torque, moment, largest, along)
      integer, intent(in) :: i
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial     !< effective [N]
      real(wp), intent(in) :: torque    !< [N.m]
      real(wp), intent(in) :: moment    !< [N.m]
      real(wp), intent(in) :: largest   !< moment next to tool joints or between them [N.m]
      type(along_string_type), intent(inout) :: along
      type(pipe_stress_type) :: stress, between
      real(wp) :: od, yield
      od = worn_od(part)
      along%od(i) = part%od
      along%true_axial(i) = true_axial(axial, od, part%id, along%pressure(i), along%inside_pressure(i))
      stress = pipe_stress(od, part%id, along%true_axial(i), torque, moment, along%pressure(i), along%inside_pressure(i))
      along%axial_stress(i) = stress%axial
      along%bending_stress(i) = stress%bending
      along%per_moment(i) = 0.5_wp*od/tube_inertia(od, part%id)
      along%torsional_stress(i) = stress%torsional
      along%hoop_stress(i) = stress%hoop
      along%von_mises(i) = stress%von_mises
      along%jointed_von_mises(i) = stress%von_mises
      if (largest > moment) then
         between = pipe_stress(od, part%id, along%true_axial(i), torque, largest, along%pressure(i), along%inside_pressure(i))
         along%jointed_von_mises(i) = between%von_mises
      end if
      if (.not. part%yield > 0.0_wp) return
      yield = along%yield_left(i)*part%yield
      ! A string without any load has no factor.
      if (stress%von_mises > epsilon(1.0_wp)*yield) along%safety_factor(i) = yield/stress%von_mises
      along%envelope_margin(i) = 1.0_wp - stress%von_mises/yield
   end subroutine set_stress

   !> Bending between tool joints and stress in them at row `i`, for a component with joints. In compression bending is largest
   !> between joints, so that a joint has the mean one. The magnification is that without contact of the body.
   pure subroutine set_joint(i, part, axial, torque, moment, largest, curvature, apart, along)
      integer, intent(in) :: i
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial, torque, moment   !< [N, N.m, N.m]
      real(wp), intent(in) :: largest                 !< moment next to tool joints or between them [N.m]
      real(wp), intent(in) :: curvature               !< of the hole [1/m]
      logical, intent(in) :: apart                    !< true if joints were solved one by one
      type(along_string_type), intent(inout) :: along
      type(pipe_stress_type) :: stress
      real(wp) :: factor, force
      if (.not. has_joints(part)) return
      factor = 1.0_wp
      if (.not. apart) factor = joint_magnification(axial, bending_stiffness(part), 0.5_wp*part%joint_spacing, curvature, &
                                                    0.5_wp*(part%joint_od - part%od))
      if (.not. is_missing(factor)) then
         along%magnification(i) = factor
         along%jointed_bending(i) = largest*along%per_moment(i)
      end if
      force = true_axial(axial, part%joint_od, joint_bore(part), along%pressure(i), along%inside_pressure(i))
      stress = pipe_stress(part%joint_od, joint_bore(part), force, torque, merge(largest, moment, axial > 0.0_wp), &
                           along%pressure(i), along%inside_pressure(i))
      along%joint_bending(i) = stress%bending
      along%joint_von_mises(i) = stress%von_mises
   end subroutine set_joint

   !> Curvature of one arc [1/m]. The depth is needed for a spline, whose curvature varies.
   pure function curvature_at(model, md, arc) result(curvature)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: md     !< [m]
      integer, intent(in) :: arc
      real(wp) :: curvature
      real(wp) :: position(3), tangent(3), bend(3)
      call point_on_arc(model%trajectory%arcs(arc), md - model%trajectory%arcs(arc)%md, position, tangent, bend)
      curvature = norm2(bend)
   end function curvature_at

   !> Standoff of a body [-], as in API 10D-2: 1 where it is centred, 0 where it touches, missing where it fills its hole.
   pure function standoff_of(od, diameter, displacement) result(standoff)
      real(wp), intent(in) :: od, diameter   !< of body and hole [m]
      real(wp), intent(in) :: displacement   !< of the string from the hole axis [m]
      real(wp) :: standoff
      standoff = missing
      if (diameter > od) standoff = max(1.0_wp - displacement/(0.5_wp*(diameter - od)), 0.0_wp)
   end function standoff_of

   !> Buckling limits at row `i` in one of the bends that meet there. The lower ones are kept.
   pure subroutine lower_limits(model, i, md, compression, part, weight, clearance, arc, along)
      type(model_type), intent(in) :: model
      integer, intent(in) :: i
      real(wp), intent(in) :: md        !< [m]
      real(wp), intent(in) :: compression   !< [N]
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: weight    !< buoyed [N/m]
      real(wp), intent(in) :: clearance !< (D - d)/2 [m]
      integer, intent(in) :: arc        !< arc of the trajectory
      type(along_string_type), intent(inout) :: along
      real(wp), parameter :: down(3) = [0.0_wp, 0.0_wp, 1.0_wp]
      real(wp) :: position(3), tangent(3), curvature(3), ei, across(3), inclined, vertical
      call point_on_arc(model%trajectory%arcs(arc), md - model%trajectory%arcs(arc)%md, position, tangent, curvature)
      along%curvature(i) = max(along%curvature(i), norm2(curvature))
      if (.not. clearance > 0.0_wp) return
      ei = bending_stiffness(part)
      across = weight*(down - tangent(3)*tangent)
      inclined = curved_limit(ei, across, curvature, clearance, compression)
      vertical = vertical_unit(ei, weight*tangent(3))
      if (.not. max(inclined, vertical) > 0.0_wp) return
      call keep_least(along%sinusoidal(i), max(inclined, lubinski_first*vertical))
      call keep_least(along%onset(i), max(curved_limit(ei, across, curvature, clearance), lubinski_first*vertical))
      call keep_least(along%helical(i), helical_limit(inclined, vertical, helical_low))
      call keep_least(along%helical_upper(i), helical_limit(inclined, vertical, helical_high))
   end subroutine lower_limits

   !> The smaller of a number that may be missing and a given one.
   pure subroutine keep_least(number, candidate)
      real(wp), intent(inout) :: number
      real(wp), intent(in) :: candidate
      if (is_missing(number)) then
         number = candidate
      else
         number = min(number, candidate)
      end if
   end subroutine keep_least

   !> Columns of `n` rows, all zero or missing.
   pure function new_along_string(n) result(along)
      integer, intent(in) :: n
      type(along_string_type) :: along
      allocate (along%pressure(n), along%inside_pressure(n), along%true_axial(n), &
                along%axial_stress(n), along%bending_stress(n), along%per_moment(n), &
                along%torsional_stress(n), along%hoop_stress(n), along%von_mises(n), along%jointed_von_mises(n), &
                along%bending_range(n), along%curvature(n), along%od(n), along%hole_diameter(n), source=0.0_wp)
      allocate (along%safety_factor(n), along%envelope_margin(n), along%overpull(n), along%sinusoidal(n), along%onset(n), &
                along%helical(n), along%helical_upper(n), along%buckling_margin(n), along%magnification(n), &
                along%jointed_bending(n), along%joint_bending(n), along%joint_von_mises(n), along%joint_side_force(n), &
                along%standoff(n), source=missing)
      allocate (along%yield_left(n), source=1.0_wp)
      allocate (along%buckling(n), source=buckling_none)
   end function new_along_string
end module dg_along_string

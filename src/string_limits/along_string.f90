!> What an engineer reads off along the string, from the profile of any model and the data of string, hole and mud:
!> pressures, true axial force, stresses, safety factors, buckling limits. One place for all models.
!>
!> Pressures are those of the fluids at rest (dg_fluid_pressure).
!> Where two components, hole sections or bends meet, both sides are looked at: stresses are those of the
!> more highly used side, buckling limits the lower ones.
module dg_along_string
   use dg_kinds, only: wp
   use dg_buckling_limits, only: buckled_state, buckling_none, curved_limit, helical_high, helical_limit, helical_low, &
                                 lubinski_first, vertical_unit
   use dg_case_result, only: case_result_type, contact_joint
   use dg_component, only: bending_stiffness, buoyed_weight, component_type, contact_diameter, has_joints, &
                           tube_inertia, worn_od
   use dg_drillstring, only: component_at, component_tops
   use dg_fluid, only: density_at, side_inside, side_outside
   use dg_fluid_pressure, only: fluid_column_type, new_fluid_column, pressure_at
   use dg_hole_section, only: hole_section_at
   use dg_job, only: model_mcge, model_soft
   use dg_joint_bending, only: joint_magnification
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_pipe_stress, only: pipe_stress, pipe_stress_type, true_axial
   use dg_pull_margin, only: pull_margin
   use dg_trajectory, only: arc_at, point_on_arc, top_md
   implicit none
   private
   public :: along_string_type, find_along_string, new_along_string

   !> One value a row of the profile. `missing` where there is none: safety factors without a yield strength, buckling
   !> limits of a weightless string in a straight hole, what belongs to tool joints
   !> without them.
   type :: along_string_type
      real(wp), allocatable :: pressure(:)          !< of the fluid outside [Pa]
      real(wp), allocatable :: inside_pressure(:)   !< of the fluid inside; at a closed collar, below it [Pa]
      real(wp), allocatable :: inside_above(:)      !< the same, above the collar [Pa]
      real(wp), allocatable :: true_axial(:)        !< axial force in the wall, tension > 0 [N]
      real(wp), allocatable :: axial_stress(:)      !< of the true axial force [Pa]
      real(wp), allocatable :: bending_stress(:)    !< amplitude at the outer surface [Pa]
      real(wp), allocatable :: per_moment(:)        !< bending stress that a unit moment makes there [1/m3]
      real(wp), allocatable :: torsional_stress(:)  !< at the outer surface [Pa]
      real(wp), allocatable :: hoop_stress(:)       !< at the inner surface [Pa]
      real(wp), allocatable :: von_mises(:)         !< largest in the section [Pa]
      real(wp), allocatable :: safety_factor(:)     !< yield strength over von_mises [-]
      real(wp), allocatable :: envelope_margin(:)   !< part of the tension-torque envelope left, bending included [-]
      real(wp), allocatable :: overpull(:)          !< tension that may be added here, bending included [N]
      real(wp), allocatable :: bending_range(:)     !< of stress in a turn of the string; 0 where it does not turn [Pa]
      real(wp), allocatable :: magnification(:)     !< of bending between tool joints that touch alone [-]
      real(wp), allocatable :: jointed_bending(:)   !< bending stress of the body that goes with it [Pa]
      real(wp), allocatable :: joint_von_mises(:)   !< largest stress in a tool joint, if one stands here [Pa]
      real(wp), allocatable :: joint_side_force(:)  !< contact force of a tool joint [N]
      real(wp), allocatable :: sinusoidal(:)        !< compression at sinusoidal buckling, as the string now lies [N]
      real(wp), allocatable :: onset(:)             !< the least such compression, from none upwards [N]
      real(wp), allocatable :: helical(:)           !< at helical buckling, the lower published limit [N]
      real(wp), allocatable :: helical_upper(:)     !< the same, the upper one [N]
      real(wp), allocatable :: buckling_margin(:)   !< compression left before sinusoidal buckling [N]
      integer, allocatable :: buckling(:)           !< buckling_none, buckling_sinusoidal, buckling_helical
      real(wp), allocatable :: curvature(:)         !< of the hole, the larger of both sides [1/m]
      real(wp), allocatable :: od(:)                !< of the body of the stressed side [m]
      real(wp), allocatable :: hole_diameter(:)     !< the smaller of both sides [m]
      real(wp), allocatable :: standoff(:)          !< of the body, least annular distance over that of a centred one [-]
   end type along_string_type

   !> Half the distance between what counts as above and below a row [m].
   real(wp), parameter :: hair = 1.0e-6_wp
   !> Difference of pressures at one place that is round-off of depths [Pa].
   real(wp), parameter :: no_pressure = 1.0_wp

contains

   !> All columns, one value a row of `result%profile`.
   pure subroutine find_along_string(model, result, along)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(out) :: along
      real(wp), allocatable :: tops(:)
      type(fluid_column_type) :: outside, inside
      real(wp) :: bit, depth, moment(2), pressure(2), weight(2)
      integer :: i, n, side, string, owner, part(2), hole(2), arc(2)
      logical :: apart, solved(2)   ! joint by joint; bending between contacts, on either side
      apart = model%numerics%discrete_joints .and. result%model == model_mcge
      n = size(result%profile%md)
      along = new_along_string(n)
      string = string_index(model%strings, model%cases(result%case_index)%string)
      bit = model%cases(result%case_index)%bit_depth
      allocate (tops, source=component_tops(model%strings(string), bit - top_md(model%trajectory)))
      call new_fluid_column(model, model%cases(result%case_index), side_outside, outside)
      call new_fluid_column(model, model%cases(result%case_index), side_inside, inside)
      associate (profile => result%profile, components => model%strings(string)%components)
         arc = 1
         do i = 1, n
            do side = 1, 2
               depth = min(max(profile%md(i) + merge(-hair, hair, side == 1), top_md(model%trajectory)), bit)
               part(side) = component_at(tops, bit - depth)
               hole(side) = hole_section_at(model%holes, depth)
               arc(side) = arc_at(model%trajectory, depth, near=arc(side))
               pressure(side) = pressure_at(inside, depth, profile%tvd(i))
               weight(side) = buoyed_weight(components(part(side)), density_at(model%mud, side_outside, depth, bit), &
                                            density_at(model%mud, side_inside, depth, bit), model%gravity)
               solved(side) = apart .or. (components(part(side))%centralizer%present .and. result%model == model_mcge)
            end do
            along%pressure(i) = pressure_at(outside, depth, profile%tvd(i))
            along%inside_above(i) = pressure(1)
            along%inside_pressure(i) = pressure(2)
            along%hole_diameter(i) = minval(model%holes(hole)%diameter)
            owner = component_at(tops, bit - profile%md(i))
            do side = 1, 2
               ! A stiff string carries one moment across a joint. That of a soft one is the curvature of the hole times
               ! the stiffness of the component at the row: each side has its own.
               moment(side) = profile%bending(i)
               if (result%model == model_soft) moment(side) = moment(side)*bending_stiffness(components(part(side)))/ &
                  bending_stiffness(components(owner))
               if (side == 1 .or. part(2) /= part(1) .or. abs(pressure(2) - pressure(1)) > no_pressure) then
                  call put_stress(i, components(part(side)), profile%axial(i), profile%torque(i), moment(side), pressure(side), &
                                  along)
                  call put_joint(i, components(part(side)), profile%axial(i), profile%torque(i), moment(side), pressure(side), &
                                 curvature_at(model, profile%md(i), arc(side)), solved(side), along)
                  if (has_joints(components(part(side))) .and. .not. solved(side)) call keep_most(along%joint_side_force(i), &
                     profile%side_force(i)*components(part(side))%joint_spacing)
               end if
               if (side == 1 .or. part(2) /= part(1) .or. hole(2) /= hole(1) .or. arc(2) /= arc(1) .or. &
                   abs(weight(2) - weight(1)) > 0.0_wp) &
                  call put_limits(model, i, profile%md(i), -profile%axial(i), components(part(side)), weight(side), &
                                  0.5_wp*(model%holes(hole(side))%diameter - &
                                          contact_diameter(components(part(side)), bit - tops(part(side)))), arc(side), along)
               if (result%model == model_mcge) call put_standoff(i, components(part(side))%od, &
                                                                 model%holes(hole(side))%diameter, profile%displacement(i), along)
            end do
            if (rotates(model%cases(result%case_index)%operation)) along%bending_range(i) = 2.0_wp*along%bending_stress(i)
            if (.not. is_missing(along%sinusoidal(i))) then
               along%buckling_margin(i) = along%sinusoidal(i) + profile%axial(i)
               along%buckling(i) = buckled_state(-profile%axial(i), along%sinusoidal(i), along%helical(i))
            end if
            do side = 1, 2
               if (components(part(side))%yield > 0.0_wp) call keep_least(along%overpull(i), &
                  pull_margin(components(part(side)), profile%axial(i), profile%torque(i), moment(side), along%curvature(i), &
                              solved(side), along%buckling(i) /= buckling_none, pressure(side) - along%pressure(i)))
            end do
         end do
      end associate
      if (apart .and. allocated(result%contacts)) call put_joint_forces(result, along)
   end subroutine find_along_string

   !> Contact forces of tool joints that were solved one by one, each at the row nearest to it; 0 at other rows with joints.
   pure subroutine put_joint_forces(result, along)
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(inout) :: along
      integer :: i, row
      where (.not. is_missing(along%magnification)) along%joint_side_force = 0.0_wp
      do i = 1, size(result%contacts)
         if (result%contacts(i)%kind /= contact_joint) cycle
         row = minloc(abs(result%profile%md - result%contacts(i)%md), dim=1)
         call keep_most(along%joint_side_force(row), result%contacts(i)%force)
      end do
   end subroutine put_joint_forces

   !> Stresses at row `i` on one side of it; kept where this side is used more highly than the one before.
   pure subroutine put_stress(i, part, axial, torque, moment, inside, along)
      integer, intent(in) :: i
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial    !< effective [N]
      real(wp), intent(in) :: torque   !< [N.m]
      real(wp), intent(in) :: moment   !< [N.m]
      real(wp), intent(in) :: inside   !< pressure [Pa]
      type(along_string_type), intent(inout) :: along
      type(pipe_stress_type) :: stress
      real(wp) :: force, factor, od
      logical :: second, worse
      od = worn_od(part)
      force = true_axial(axial, od, part%id, along%pressure(i), inside)
      stress = pipe_stress(od, part%id, force, torque, moment, along%pressure(i), inside)
      second = along%od(i) > 0.0_wp
      factor = missing
      ! A string under no load at all has no factor.
      if (part%yield > 0.0_wp .and. stress%von_mises > epsilon(1.0_wp)*part%yield) factor = part%yield/stress%von_mises
      worse = .not. second .or. stress%von_mises > along%von_mises(i)
      if (second .and. .not. is_missing(factor) .and. .not. is_missing(along%safety_factor(i))) &
         worse = factor < along%safety_factor(i)
      if (worse) then
         along%od(i) = part%od
         along%true_axial(i) = force
         along%axial_stress(i) = stress%axial
         along%bending_stress(i) = stress%bending
         along%per_moment(i) = 0.5_wp*od/tube_inertia(od, part%id)
         along%torsional_stress(i) = stress%torsional
         along%hoop_stress(i) = stress%hoop
         along%von_mises(i) = stress%von_mises
         if (.not. is_missing(factor)) along%safety_factor(i) = factor
      else if (is_missing(along%safety_factor(i))) then
         along%safety_factor(i) = factor
      end if
      if (.not. part%yield > 0.0_wp) return
      call keep_least(along%envelope_margin(i), 1.0_wp - stress%von_mises/part%yield)
   end subroutine put_stress

   !> Bending between tool joints and stress in them at row `i`, for a component that has some; kept where larger than on the other
   !> side. A model that solved joint by joint has its magnification in its moments. The joint's bore is taken to be the
   !> pipe's, which is on the safe side. In compression bending is largest between joints, so that a joint has the mean one.
   pure subroutine put_joint(i, part, axial, torque, moment, inside, curvature, apart, along)
      integer, intent(in) :: i
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial, torque, moment   !< [N, N.m, N.m]
      real(wp), intent(in) :: inside                  !< pressure [Pa]
      real(wp), intent(in) :: curvature               !< of the hole [1/m]
      logical, intent(in) :: apart                    !< whether joints were solved one by one
      type(along_string_type), intent(inout) :: along
      type(pipe_stress_type) :: stress
      real(wp) :: factor, force
      if (.not. has_joints(part)) return
      factor = 1.0_wp
      if (.not. apart) factor = joint_magnification(axial, bending_stiffness(part), 0.5_wp*part%joint_spacing, curvature, &
                                                    0.5_wp*(part%joint_od - part%od))
      if (.not. is_missing(factor)) then
         call keep_most(along%magnification(i), factor)
         call keep_most(along%jointed_bending(i), factor*abs(moment)*0.5_wp*worn_od(part)/tube_inertia(worn_od(part), part%id))
      end if
      if (axial < 0.0_wp) factor = 1.0_wp
      force = true_axial(axial, part%joint_od, part%id, along%pressure(i), inside)
      stress = pipe_stress(part%joint_od, part%id, force, torque, factor*moment, along%pressure(i), inside)
      call keep_most(along%joint_von_mises(i), stress%von_mises)
   end subroutine put_joint

   !> Curvature of one arc [1/m]; the depth serves a spline, whose curvature varies.
   pure function curvature_at(model, md, arc) result(curvature)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: md     !< [m]
      integer, intent(in) :: arc
      real(wp) :: curvature
      real(wp) :: position(3), tangent(3), bend(3)
      call point_on_arc(model%trajectory%arcs(arc), md - model%trajectory%arcs(arc)%md, position, tangent, bend)
      curvature = norm2(bend)
   end function curvature_at

   !> Standoff of the body at row `i` on one side of it, as API 10D-2 has it: 1 where it is centred, 0 where it touches; kept where
   !> less than on the other side.
   pure subroutine put_standoff(i, od, diameter, displacement, along)
      integer, intent(in) :: i
      real(wp), intent(in) :: od, diameter   !< of body and hole [m]
      real(wp), intent(in) :: displacement   !< of the string off the hole axis [m]
      type(along_string_type), intent(inout) :: along
      if (diameter > od) call keep_least(along%standoff(i), max(1.0_wp - displacement/(0.5_wp*(diameter - od)), 0.0_wp))
   end subroutine put_standoff

   !> Buckling limits at row `i` on one side of it; kept where lower than the one before.
   pure subroutine put_limits(model, i, md, compression, part, weight, clearance, arc, along)
      type(model_type), intent(in) :: model
      integer, intent(in) :: i
      real(wp), intent(in) :: md        !< [m]
      real(wp), intent(in) :: compression   !< [N]
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: weight    !< buoyed [N/m]
      real(wp), intent(in) :: clearance !< (D - d)/2 [m]
      integer, intent(in) :: arc        !< of the trajectory
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
   end subroutine put_limits

   !> The smaller of a number that may be missing and one that is there.
   pure subroutine keep_least(number, candidate)
      real(wp), intent(inout) :: number
      real(wp), intent(in) :: candidate
      if (is_missing(number)) then
         number = candidate
      else
         number = min(number, candidate)
      end if
   end subroutine keep_least

   !> The larger of a number that may be missing and one that is there.
   pure subroutine keep_most(number, candidate)
      real(wp), intent(inout) :: number
      real(wp), intent(in) :: candidate
      if (is_missing(number)) then
         number = candidate
      else
         number = max(number, candidate)
      end if
   end subroutine keep_most

   !> Columns of `n` rows, all zero or missing.
   pure function new_along_string(n) result(along)
      integer, intent(in) :: n
      type(along_string_type) :: along
      allocate (along%pressure(n), along%inside_pressure(n), along%inside_above(n), along%true_axial(n), &
                along%axial_stress(n), along%bending_stress(n), along%per_moment(n), &
                along%torsional_stress(n), along%hoop_stress(n), along%von_mises(n), along%bending_range(n), &
                along%curvature(n), along%od(n), along%hole_diameter(n), source=0.0_wp)
      allocate (along%safety_factor(n), along%envelope_margin(n), along%overpull(n), along%sinusoidal(n), along%onset(n), &
                along%helical(n), along%helical_upper(n), along%buckling_margin(n), along%magnification(n), &
                along%jointed_bending(n), along%joint_von_mises(n), along%joint_side_force(n), along%standoff(n), source=missing)
      allocate (along%buckling(n), source=buckling_none)
   end function new_along_string
end module dg_along_string

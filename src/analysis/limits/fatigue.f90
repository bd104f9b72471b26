!> Fatigue of a string that turns: body and connections of each component at their place of greatest bending for their tension,
!> the worst one first.
!>
!> The stress alternates once a turn, with the amplitude of bending of the body. Next to single tool joints it is larger
!> (dg_joint_bending). The permitted stress depends on the tension (dg_fatigue_curve). The largest dogleg in which the pipe may
!> turn at that tension is by Lubinski (1961), Maximum permissible dog-legs in rotary boreholes, J. Pet. Technol. 13(2):
!>
!>   c = s_b/(E D/2) tanh(KL)/(KL),    K^2 = T/(E I), L half the distance of tool joints.
!>
!> Connections take the moment of the body beside them, in tension the largest. Their stress is at the outside of the tool
!> joint, with the bore of the pipe. Without tool joints it is the stress of the body. The user gives their curve, and make-up
!> sets the mean stress.
!>
!> Damage is turns over turns to failure, as if the same piece of pipe were at the worst place all the time.
module dg_fatigue
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, body_bending
   use dg_case_result, only: case_result_type
   use dg_component, only: bending_stiffness, component_type, has_joints, joint_bore, tube_area, tube_inertia, worn_od
   use dg_constants, only: pi
   use dg_drillstring, only: component_at, component_tops
   use dg_fatigue_curve, only: fatigue_curve_type, fatigue_none, permitted_amplitude, turns_to_failure
   use dg_joint_bending, only: joint_magnification
   use dg_load_case, only: load_case_type, rotates
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: missing
   use dg_model, only: model_type, string_index
   use dg_profile, only: piece_depths
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: fatigue_type, hour, find_fatigue, asks_for_fatigue, permitted_dogleg

   !> Body or connections of a component at their place of greatest fatigue.
   type :: fatigue_type
      logical :: present = .false.
      integer :: part = 0                  !< number of the component
      logical :: joint = .false.           !< true: its connections; false: its body
      real(wp) :: md = 0.0_wp              !< [m]
      real(wp) :: tension = 0.0_wp         !< stress of the effective axial force [Pa]
      real(wp) :: amplitude = 0.0_wp       !< of the bending stress [Pa]
      real(wp) :: permitted = 0.0_wp       !< amplitude with endless life [Pa]
      real(wp) :: used = 0.0_wp            !< amplitude over that [-]
      real(wp) :: turns = missing          !< until failure [-]; missing: endless, or not known
      real(wp) :: damage = missing         !< part of its life that the hours of the case use [-]; missing: not known
      real(wp) :: curvature = 0.0_wp       !< of the hole [1/m]
      real(wp) :: dogleg = missing         !< the largest that its tension permits [1/m]; missing: not known
   end type fatigue_type

   real(wp), parameter :: hour = 3600.0_wp   !< [s]

contains

   !> True if a load case fatigues its string and the deck has a curve for a component.
   pure function asks_for_fatigue(model, load_case) result(asks)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: asks
      asks = .false.
      if (.not. rotates(load_case%operation)) return
      associate (parts => model%strings(string_index(model%strings, load_case%string))%components)
         asks = any(parts%fatigue%curve /= fatigue_none) .or. any(parts%joint_fatigue%curve /= fatigue_none)
      end associate
   end function asks_for_fatigue

   !> Bodies and connections with a fatigue curve in the hole, the worst one first.
   pure subroutine find_fatigue(model, result, along, parts)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(fatigue_type), allocatable, intent(out) :: parts(:)
      real(wp), allocatable :: tops(:), used(:)
      logical, allocatable :: known(:)     ! a copy: plain arrays pass without a temporary
      real(wp) :: bit, depths(size(result%profile%md))
      integer :: i, number
      allocate (parts(0))
      associate (load_case => model%cases(result%case_index), profile => result%profile)
         if (.not. asks_for_fatigue(model, load_case)) return
         associate (string => model%strings(string_index(model%strings, load_case%string)))
            bit = load_case%bit_depth
            allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
            depths = piece_depths(profile)
            deallocate (parts)
            allocate (parts(2*size(tops)))
            do i = 1, size(depths)
               number = component_at(tops, bit - depths(i))
               associate (part => string%components(number))
                  if (part%fatigue%curve /= fatigue_none) call keep_worst(load_case, profile%md(i), &
                     body_row(number, part, profile%axial(i), along, i), part%fatigue, parts(number))
                  if (part%joint_fatigue%curve /= fatigue_none) call keep_worst(load_case, profile%md(i), &
                     joint_row(number, part, profile%axial(i), along, i), part%joint_fatigue, parts(size(tops) + number))
               end associate
            end do
         end associate
      end associate
      allocate (known(size(parts)))
      known = parts%present
      parts = pack(parts, known)
      allocate (used(size(parts)))
      used(:) = -parts%used
      parts = parts(sorted_places(used))
   end subroutine find_fatigue

   !> Keep a row that uses more than the worst so far, with its turns to failure.
   pure subroutine keep_worst(load_case, md, row, curve, worst)
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: md                 !< [m]
      type(fatigue_type), intent(in) :: row
      type(fatigue_curve_type), intent(in) :: curve
      type(fatigue_type), intent(inout) :: worst
      real(wp) :: turns
      if (worst%present .and. row%used <= worst%used) return
      worst = row
      worst%md = md
      turns = turns_to_failure(curve, row%amplitude, row%permitted)
      if (turns > 0.0_wp) worst%turns = turns
      if (turns > 0.0_wp .and. load_case%hours > 0.0_wp .and. load_case%angular_speed > 0.0_wp) &
         worst%damage = load_case%hours*hour*load_case%angular_speed/(2.0_wp*pi)/turns
      if (row%used <= 1.0_wp .and. load_case%hours > 0.0_wp) worst%damage = 0.0_wp
   end subroutine keep_worst

   !> Stresses of the body at a row, and the permitted ones.
   pure function body_row(number, part, axial, along, i) result(row)
      integer, intent(in) :: number                      !< of the component
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial                      !< effective [N]
      type(along_string_type), intent(in) :: along
      integer, intent(in) :: i
      type(fatigue_type) :: row
      row = new_row(number, axial/tube_area(worn_od(part), part%id), body_bending(along, i), part%fatigue, along%curvature(i))
      row%dogleg = permitted_dogleg(part, axial)
   end function body_row

   !> Stresses of the connections at a row, and the permitted ones.
   pure function joint_row(number, part, axial, along, i) result(row)
      integer, intent(in) :: number                      !< of the component
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial                      !< effective [N]
      type(along_string_type), intent(in) :: along
      integer, intent(in) :: i
      type(fatigue_type) :: row
      real(wp) :: od, bore, amplitude, factor, stiffer
      od = worn_od(part)
      bore = part%id
      amplitude = along%bending_stress(i)
      factor = 1.0_wp
      stiffer = 1.0_wp
      if (has_joints(part)) then
         od = part%joint_od
         bore = joint_bore(part)
         amplitude = along%joint_bending(i)
         if (axial > 0.0_wp) &
            factor = joint_magnification(axial, bending_stiffness(part), 0.5_wp*part%joint_spacing, 0.0_wp, 0.0_wp)
         stiffer = tube_inertia(od, bore)/tube_inertia(part%od, part%id)
      end if
      row = new_row(number, axial/tube_area(od, bore), amplitude, part%joint_fatigue, along%curvature(i))
      row%joint = .true.
      row%dogleg = row%permitted*stiffer/(0.5_wp*part%youngs*od*factor)
   end function joint_row

   !> Stresses of body or connections at a row, against those of their curve.
   pure function new_row(number, tension, amplitude, curve, curvature) result(row)
      integer, intent(in) :: number                      !< of the component
      real(wp), intent(in) :: tension, amplitude         !< [Pa]
      type(fatigue_curve_type), intent(in) :: curve
      real(wp), intent(in) :: curvature                  !< of the hole [1/m]
      type(fatigue_type) :: row
      row%present = .true.
      row%part = number
      row%tension = tension
      row%amplitude = amplitude
      row%permitted = permitted_amplitude(curve, tension)
      row%used = amplitude/row%permitted
      row%curvature = curvature
   end function new_row

   !> Largest dogleg in which the body of a component may turn without end at a tension [1/m]. Missing for jointed pipe in
   !> compression, whose body bends between its joints.
   pure function permitted_dogleg(part, axial) result(dogleg)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial            !< effective [N]
      real(wp) :: dogleg
      real(wp) :: factor
      dogleg = missing
      factor = 1.0_wp
      if (has_joints(part)) then
         if (axial < 0.0_wp) return
         factor = joint_magnification(axial, bending_stiffness(part), 0.5_wp*part%joint_spacing, 0.0_wp, 0.0_wp)
      end if
      dogleg = permitted_amplitude(part%fatigue, axial/tube_area(worn_od(part), part%id))/ &
               (0.5_wp*part%youngs*worn_od(part)*factor)
   end function permitted_dogleg
end module dg_fatigue

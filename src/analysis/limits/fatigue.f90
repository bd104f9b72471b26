!> Fatigue of a string that turns: each component where it is bent hardest for its tension, the worst one first.
!>
!> The stress goes round once a turn, with the amplitude of bending of the body; between tool joints that touch alone it is larger
!> next to them (dg_joint_bending). What it may be depends on the tension (dg_fatigue_curve). The largest dogleg in which the pipe
!> may turn at that tension is that of Lubinski (1961), Maximum permissible dog-legs in rotary boreholes, J. Pet. Technol. 13(2):
!>
!>   c = s_b/(E D/2) tanh(KL)/(KL),    K^2 = T/(E I), L half the distance of tool joints.
!>
!> Damage is turns over turns until failure, as if the same piece of pipe stood at the worst place all the time. Threads of tool
!> joints and of collars have curves of their own, which no deck gives; they are left out.
module dg_fatigue
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_component, only: bending_stiffness, component_type, has_joints, tube_area, worn_od
   use dg_constants, only: pi
   use dg_drillstring, only: component_at, component_tops
   use dg_fatigue_curve, only: fatigue_none, permitted_amplitude, turns_to_failure
   use dg_joint_bending, only: joint_magnification
   use dg_load_case, only: load_case_type, rotates
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_profile, only: piece_depths
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: fatigue_type, find_fatigue, asks_for_fatigue, permitted_dogleg

   !> A component where it is tired most.
   type :: fatigue_type
      logical :: present = .false.
      integer :: part = 0                  !< number of the component
      real(wp) :: md = 0.0_wp              !< [m]
      real(wp) :: tension = 0.0_wp         !< stress of the effective axial force [Pa]
      real(wp) :: amplitude = 0.0_wp       !< of the bending stress [Pa]
      real(wp) :: permitted = 0.0_wp       !< amplitude borne without end [Pa]
      real(wp) :: used = 0.0_wp            !< amplitude over that [-]
      real(wp) :: turns = missing          !< until failure [-]; missing: endless, or not known
      real(wp) :: damage = missing         !< part of its life that the hours of the case take [-]; missing: not known
      real(wp) :: curvature = 0.0_wp       !< of the hole [1/m]
      real(wp) :: dogleg = missing         !< the largest that its tension permits [1/m]; missing: not known
   end type fatigue_type

   real(wp), parameter :: hour = 3600.0_wp   ! s

contains

   !> Whether a load case tires its string, and the deck has a curve for a part of it.
   pure function asks_for_fatigue(model, load_case) result(asks)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: asks
      asks = rotates(load_case%operation)
      if (asks) asks = any(model%strings(string_index(model%strings, load_case%string))%components%fatigue%curve /= fatigue_none)
   end function asks_for_fatigue

   !> Components with a curve that are in the hole, the worst one first.
   pure subroutine find_fatigue(model, result, along, parts)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(fatigue_type), allocatable, intent(out) :: parts(:)
      type(fatigue_type) :: row
      real(wp), allocatable :: tops(:), used(:)
      logical, allocatable :: known(:)     ! a copy: plain arrays pass without a temporary
      real(wp) :: bit, depths(size(result%profile%md))
      integer :: i, part
      allocate (parts(0))
      associate (load_case => model%cases(result%case_index), profile => result%profile)
         if (.not. asks_for_fatigue(model, load_case)) return
         associate (string => model%strings(string_index(model%strings, load_case%string)))
            bit = load_case%bit_depth
            allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
            depths = piece_depths(profile)
            deallocate (parts)
            allocate (parts(size(tops)))
            do i = 1, size(depths)
               part = component_at(tops, bit - depths(i))
               if (string%components(part)%fatigue%curve == fatigue_none) cycle
               call find_row(string%components(part), profile%axial(i), along%bending_stress(i), along%jointed_bending(i), &
                             along%curvature(i), row)
               row%part = part
               row%md = profile%md(i)
               if (.not. is_missing(row%turns) .and. load_case%hours > 0.0_wp) &
                  row%damage = load_case%hours*hour*load_case%angular_speed/(2.0_wp*pi)/row%turns
               if (row%used <= 1.0_wp .and. load_case%hours > 0.0_wp) row%damage = 0.0_wp
               if (.not. parts(part)%present .or. row%used > parts(part)%used) parts(part) = row
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

   !> Stresses at a row, and what its component bears there.
   pure subroutine find_row(part, axial, bending, jointed, curvature, row)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial            !< effective [N]
      real(wp), intent(in) :: bending          !< amplitude by the moment [Pa]
      real(wp), intent(in) :: jointed          !< next to tool joints that touch alone; missing where not known [Pa]
      real(wp), intent(in) :: curvature        !< of the hole [1/m]
      type(fatigue_type), intent(out) :: row
      real(wp) :: turns
      row%present = .true.
      row%tension = axial/tube_area(worn_od(part), part%id)
      row%amplitude = bending
      if (.not. is_missing(jointed)) row%amplitude = jointed
      row%permitted = permitted_amplitude(part%fatigue, row%tension)
      row%used = row%amplitude/row%permitted
      turns = turns_to_failure(part%fatigue, row%amplitude, row%permitted)
      if (turns > 0.0_wp) row%turns = turns
      row%curvature = curvature
      row%dogleg = permitted_dogleg(part, axial)
   end subroutine find_row

   !> Largest dogleg in which a component may turn without end at a tension [1/m]; in compression, where the body of jointed pipe
   !> bends between its joints, missing.
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

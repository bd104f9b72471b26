!> Margin to yield of a place of the string under pull.
!>
!> Yield is by von Mises' stress with bending. A pull changes the moment. A taut string follows the hole, so that its moment is
!> at least EI times the hole's curvature. Any excess, at stabilizers and ends of bends, is assumed to stay. A buckled string
!> is straightened by the pull. Between single tool joints the moment grows with tension (dg_joint_bending).
module dg_pull_margin
   use dg_kinds, only: wp
   use dg_component, only: bending_stiffness, component_type, has_joints, worn_od
   use dg_joint_bending, only: pulled_magnification
   use dg_pipe_stress, only: tension_capacity
   implicit none
   private
   public :: pull_margin

   !> Number of halvings of the pull, which give it to 1e-9.
   integer, parameter :: halvings = 30

contains

   !> Tension that may be added at one place [N]. Negative where the place yields already: the excess of compression or
   !> tension.
   pure function pull_margin(part, yield, axial, torque, moment, curvature, apart, buckled, difference) result(margin)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: yield              !< strength at the temperature there, > 0 [Pa]
      real(wp), intent(in) :: axial              !< effective [N]
      real(wp), intent(in) :: torque             !< [N.m]
      real(wp), intent(in) :: moment             !< present moment, >= 0 [N.m]
      real(wp), intent(in) :: curvature          !< of the hole [1/m]
      logical, intent(in) :: apart               !< true if joints were solved one by one
      logical, intent(in) :: buckled
      real(wp), intent(in) :: difference         !< difference of pressures, inside - outside [Pa]
      real(wp) :: margin
      real(wp) :: low, high, middle
      integer :: i
      margin = tension_capacity(worn_od(part), part%id, torque, moment, difference, yield) - abs(axial)
      if (margin < 0.0_wp) return
      high = tension_capacity(worn_od(part), part%id, torque, moment_at(axial), difference, yield)
      margin = high - axial
      if (.not. (apart .and. has_joints(part))) return
      low = min(axial, high)
      do i = 1, halvings
         middle = 0.5_wp*(low + high)
         if (tension_capacity(worn_od(part), part%id, torque, moment_at(middle), difference, yield) > middle) then
            low = middle
         else
            high = middle
         end if
      end do
      margin = low - axial

   contains

      !> Moment under a tension [N].
      pure function moment_at(tension) result(pulled)
         real(wp), intent(in) :: tension
         real(wp) :: pulled
         pulled = bending_stiffness(part)*curvature
         if (apart .and. has_joints(part)) pulled = pulled*pulled_magnification(tension, bending_stiffness(part), &
            0.5_wp*part%joint_spacing, curvature, 0.5_wp*(part%joint_od - part%od))
         if (.not. buckled) pulled = max(pulled, moment)
      end function moment_at
   end function pull_margin
end module dg_pull_margin

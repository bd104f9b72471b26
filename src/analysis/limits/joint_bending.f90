!> Magnified bending of a pipe that touches only at its tool joints: Paslay & Cernocky 1991 (SPE 22547).
!>
!> Joints 2 L apart hold the pipe in a hole of curvature 1/R. Between them it is free to bend. With k = sqrt(|T|/EI) and x from
!> mid-span, its moment is EI/R times kL cosh(kx)/sinh(kL) in tension. In compression it is EI/R times kL cos(kx)/sin(kL). It
!> is largest next to the joint, kL/tanh(kL), or at mid-span, kL/sin(kL). The body reaches the wall once its distance from the
!> line of the joints is their stand-off. In tension that is at the inside of the bend. In compression it is at the outside, at
!> a distance L/(kR) tan(kL/2) - L^2/(2R). In tension the moment is below the closed form from there on, so that this stays a
!> bound. In compression no simple formula is known, and none is given.
!>
!> With the body's contact the moment at a joint in tension also has a closed form. The same paper has no contact, contact at
!> mid-span, and contact along a length. The body's distance v from a line that follows the hole at the joints obeys EI
!> v'''' - T v'' = T/R. At the joint v = v' = 0. At the wall, at x = a, v is the stand-off and v' = 0. With a = L it touches at
!> a point. If the moment there would exceed EI/R, it lies on the wall from an a < L on, at which v'' = 0.
!>
!> All this holds for joints without length. One of length l touches with both edges in tension. The moment is then kL/(tanh(k(L -
!> l/2)) + tanh(kl/2)): by 4 to 10 % less in usual pipe that is pulled hard. Beams with joints one by one find that.
module dg_joint_bending
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_missing, only: missing
   implicit none
   private
   public :: joint_magnification, pulled_magnification

   !> Value of kL below which the first term of the series gives the factor to 1e-9 [-].
   real(wp), parameter :: small = 1.0e-2_wp
   !> Number of halvings of the length from the joint to the wall.
   integer, parameter :: halvings = 50

contains

   !> Largest bending moment between joints over the mean one by the hole's curvature [-]. Missing in compression beyond the
   !> range of the closed form.
   elemental function joint_magnification(axial, ei, half_span, curvature, stand_off) result(factor)
      real(wp), intent(in) :: axial       !< effective, tension > 0 [N]
      real(wp), intent(in) :: ei          !< of the body, > 0 [N.m2]
      real(wp), intent(in) :: half_span   !< L, half the distance between joints [m]
      real(wp), intent(in) :: curvature   !< of the hole, >= 0 [1/m]
      real(wp), intent(in) :: stand_off   !< of the body from the line of the joints [m]
      real(wp) :: factor
      real(wp) :: kl
      kl = half_span*sqrt(abs(axial)/ei)
      if (axial >= 0.0_wp) then
         factor = 1.0_wp + kl**2/3.0_wp
         if (kl > small) factor = kl/tanh(kl)
         return
      end if
      factor = 1.0_wp + kl**2/6.0_wp
      if (kl <= small) return
      factor = missing
      if (kl >= pi) return
      if (curvature*half_span**2*(tan(0.5_wp*kl)/kl - 0.5_wp) > stand_off) return
      factor = kl/sin(kl)
   end function joint_magnification

   !> Bending moment at a joint over the mean one of a pipe in tension, with contact of the body [-].
   elemental function pulled_magnification(axial, ei, half_span, curvature, stand_off) result(factor)
      real(wp), intent(in) :: axial       !< effective, >= 0 [N]
      real(wp), intent(in) :: ei          !< of the body, > 0 [N.m2]
      real(wp), intent(in) :: half_span   !< [m]
      real(wp), intent(in) :: curvature   !< of the hole, >= 0 [1/m]
      real(wp), intent(in) :: stand_off   !< of the body from the line of the joints, >= 0 [m]
      real(wp) :: factor
      real(wp) :: kl, low, high, middle, share, at_wall
      integer :: i
      kl = half_span*sqrt(max(axial, 0.0_wp)/ei)
      factor = joint_magnification(max(axial, 0.0_wp), ei, half_span, curvature, stand_off)
      if (kl <= small) return
      ! distance of the body from the line of the joints at mid-span, in units of L^2/R
      share = 0.5_wp - tanh(0.5_wp*kl)/kl
      if (curvature*half_span**2*share <= stand_off) return
      share = stand_off/(curvature*half_span**2)
      call span_to_wall(kl, kl, share, factor, at_wall)
      if (at_wall <= 1.0_wp) return
      low = small
      high = kl
      do i = 1, halvings
         middle = 0.5_wp*(low + high)
         call span_to_wall(middle, kl, share, factor, at_wall)
         if (at_wall > 1.0_wp) then
            high = middle
         else
            low = middle
         end if
      end do
   end function pulled_magnification

   !> Moments over the mean one of a span from a joint to the wall, which it reaches parallel to the hole at x = a. The span
   !> has v = P exp(-kx) + Q exp(-k(a - x)) + C + D x - x^2/(2R).
   elemental subroutine span_to_wall(ka, kl, share, at_joint, at_wall)
      real(wp), intent(in) :: ka         !< > 0 [-]
      real(wp), intent(in) :: kl         !< [-]
      real(wp), intent(in) :: share      !< stand-off over L^2/R [-]
      real(wp), intent(out) :: at_joint  !< [-]
      real(wp), intent(out) :: at_wall   !< [-]
      real(wp) :: decay, both, p
      decay = exp(-ka)
      both = ka/(1.0_wp - decay)      ! k^2 R (P + Q): parallel at both ends
      p = (share*kl**2 + 0.5_wp*ka**2 - both*(1.0_wp - decay - ka*decay))/(ka*(1.0_wp + decay) - 2.0_wp*(1.0_wp - decay))
      at_joint = p + (both - p)*decay
      at_wall = p*decay + both - p
   end subroutine span_to_wall
end module dg_joint_bending

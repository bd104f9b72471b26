!> What bending adds where a pipe touches at its tool joints alone: Paslay & Cernocky 1991 (SPE 22547).
!>
!> Joints 2 L apart hold the pipe in a hole of curvature 1/R and leave it straight to bend between. With k = sqrt(|T|/EI) its
!> moment is EI/R times kL cosh(kx)/sinh(kL) in tension, kL cos(kx)/sin(kL) in compression, x from mid-span: largest
!> next to the joint, kL/tanh(kL), or at mid-span, kL/sin(kL). The body comes to the wall once it leaves the line of the joints by
!> their stand-off: in tension towards the inside of the bend, in compression towards the outside by L/(kR) tan(kL/2) -
!> L^2/(2R). In tension the moment is below the closed form from there on, so that this stays a bound; in compression nothing
!> simple is known, and none is given.
module dg_joint_bending
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_missing, only: missing
   implicit none
   private
   public :: joint_magnification

   !> kL below which the first term of the series is the factor to 1e-9 [-].
   real(wp), parameter :: small = 1.0e-2_wp

contains

   !> Largest bending moment between joints over the mean one, that of the hole's curvature [-]; missing in compression beyond
   !> what the closed form holds for.
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
end module dg_joint_bending

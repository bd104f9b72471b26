!> A long string in sinusoidal buckling about the low side of its hole, above the sinusoidal limit F_s and below the helical
!> one.
!>
!> Its angle from the low side is taken as theta = A sin(k x). The unit of x is (EI c/n)^(1/4), with n the side load per
!> length. With b = F/F_s the energy per length, in units of n c,
!>   E = <(theta''^2 + theta'^4)/2 - b theta'^2 + 1 - cos(theta)>,
!> is least in k and A where k^4 = 2 J_1(A)/A and b = k^2 (1 + 3 A^2/4). The contact force is then the mean of
!>   N/n = cos(theta) + 2 b theta'^2 - theta'^4 + 3 theta''^2 + 4 theta' theta'''
!> For a helix it is the c F^2/(4 EI) of Mitchell (1988).
module dg_sinusoidal_shape
   use dg_kinds, only: wp
   implicit none
   private
   public :: sinusoidal_swing, sinusoidal_wave, sinusoidal_contact

   !> Coefficients of b - 1 = first A^2 - second A^4, without terms in A^6.
   real(wp), parameter :: first = 11.0_wp/16.0_wp, second = 3.0_wp/64.0_wp
   !> Coefficient of A^2 in b and in the contact force.
   real(wp), parameter :: steep = 0.75_wp

contains

   !> Swing A to either side [rad] as a function of b, 0 up to b = 1. Mitchell's (1997) fit to his solutions is 5 % larger at
   !> b = 1.05 and 7 % smaller at 1.4.
   elemental function sinusoidal_swing(b) result(swing)
      real(wp), intent(in) :: b    !< compression over the sinusoidal limit [-]
      real(wp) :: swing
      swing = sqrt((first - sqrt(max(first**2 - 4.0_wp*second*max(b - 1.0_wp, 0.0_wp), 0.0_wp)))/(2.0_wp*second))
   end function sinusoidal_swing

   !> Wave number k over (n/(EI c))^(1/4) [-].
   elemental function sinusoidal_wave(swing) result(wave)
      real(wp), intent(in) :: swing   !< A, > 0 [rad]
      real(wp) :: wave
      wave = (2.0_wp*bessel_j1(swing)/swing)**0.25_wp
   end function sinusoidal_wave

   !> Mean contact force over n [-]: J_0(A) + A J_1(A) (1 + 3 A^2/4).
   elemental function sinusoidal_contact(swing) result(contact)
      real(wp), intent(in) :: swing   !< A [rad]
      real(wp) :: contact
      contact = bessel_j0(swing) + swing*bessel_j1(swing)*(1.0_wp + steep*swing**2)
   end function sinusoidal_contact
end module dg_sinusoidal_shape

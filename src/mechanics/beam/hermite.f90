!> Cubic Hermite shape functions of the beam element: N of Eqs. 1, 2 and 6 of the paper.
!>
!> The string's axis within an element is r(xi) = N_1 x_i + N_2 d_i + N_3 x_j + N_4 d_j with nodal positions x
!> [m] and directors d [-], xi = x/L from 0 to 1. N_2 and N_4 carry the element's length [m].
module dg_hermite
   use dg_kinds, only: wp
   implicit none
   private
   public :: hermite_value, hermite_slope, hermite_line_load

contains

   !> N(4) at xi for an element of length [m].
   pure function hermite_value(xi, length) result(n)
      real(wp), intent(in) :: xi       !< x/L, 0 to 1 [-]
      real(wp), intent(in) :: length   !< L [m]
      real(wp) :: n(4)
      real(wp) :: rest
      rest = 1.0_wp - xi
      n(1) = rest*rest*(1.0_wp + 2.0_wp*xi)
      n(2) = rest*rest*xi*length
      n(3) = xi*xi*(1.0_wp + 2.0_wp*rest)
      n(4) = -xi*xi*rest*length
   end function hermite_value

   !> dN/dx(4) at xi [1/m, -, 1/m, -].
   pure function hermite_slope(xi, length) result(n)
      real(wp), intent(in) :: xi       !< x/L, 0 to 1 [-]
      real(wp), intent(in) :: length   !< L [m]
      real(wp) :: n(4)
      real(wp) :: rest
      rest = 1.0_wp - xi
      n(1) = -6.0_wp*xi*rest/length
      n(2) = rest*(1.0_wp - 3.0_wp*xi)
      n(3) = -n(1)
      n(4) = -xi*(3.0_wp*rest - 1.0_wp)
   end function hermite_slope

   !> Integral of N over the element [m, m2, m, m2]: equivalent nodal loads F_e of a unit line load.
   pure function hermite_line_load(length) result(n)
      real(wp), intent(in) :: length   !< L [m]
      real(wp) :: n(4)
      n = [0.5_wp*length, length**2/12.0_wp, 0.5_wp*length, -length**2/12.0_wp]
   end function hermite_line_load
end module dg_hermite

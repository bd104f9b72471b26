!> Products of vectors in space.
module dg_vector
   use dg_kinds, only: wp
   implicit none
   private
   public :: cross, outer, skew

contains

   !> a x b.
   pure function cross(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function cross

   !> Matrix a b^T.
   pure function outer(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3, 3)
      c(:, 1) = a*b(1)
      c(:, 2) = a*b(2)
      c(:, 3) = a*b(3)
   end function outer

   !> Matrix S(a) with S(a) b = a x b.
   pure function skew(a) result(s)
      real(wp), intent(in) :: a(3)
      real(wp) :: s(3, 3)
      s(:, 1) = [0.0_wp, a(3), -a(2)]
      s(:, 2) = [-a(3), 0.0_wp, a(1)]
      s(:, 3) = [a(2), -a(1), 0.0_wp]
   end function skew
end module dg_vector

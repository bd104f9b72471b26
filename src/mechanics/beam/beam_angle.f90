!> Scalar function of the angle between a nodal director and the element's chord.
module dg_beam_angle
   use dg_kinds, only: wp
   implicit none
   private
   public :: angle_ratios, angle_ratio_alone, angle_ratio_once

   !> The series is used below this u = 1 - cos(alpha). Its eight terms leave an error of (u/2)**8 = 1e-16. The closed forms
   !> lose digits as u goes to zero. Above this limit their second derivative is good to 1e-11.
   real(wp), parameter :: series_limit = 0.02_wp
   integer, parameter :: series_terms = 8
   !> Below this u, an angle of 1 deg, a few terms leave an error (u/2)**5 < 1e-20.
   real(wp), parameter :: small = 2.0e-4_wp
   !> Least square of the sine, for an element that an extreme step has folded back on itself. Such a state is never kept, but
   !> its numbers must stay in range. Quantities that depend on it grow at most as the fifth power of its root.
   real(wp), parameter :: folded = 1.0e-20_wp
   !> n!/(2n+1)!!: alpha/sin(alpha) = sum c_n u**n.
   real(wp), parameter :: c(0:series_terms) = [1.0_wp, 1.0_wp/3.0_wp, 2.0_wp/15.0_wp, 2.0_wp/35.0_wp, 8.0_wp/315.0_wp, &
      8.0_wp/693.0_wp, 16.0_wp/3003.0_wp, 16.0_wp/6435.0_wp, 128.0_wp/109395.0_wp]

contains

   !> g = alpha/sin(alpha) with its first and second derivative by cosine = cos(alpha), of n angles below 180 deg. Regular at
   !> alpha = 0, also where round-off puts the cosine a little above one.
   pure subroutine angle_ratios(n, cosine, g, dg, ddg)
      integer, intent(in) :: n
      real(wp), intent(in) :: cosine(n)              !< cos(alpha) [-]
      real(wp), intent(out) :: g(n), dg(n), ddg(n)   !< g, dg/dcos, d2g/dcos2 [-]
      real(wp) :: u
      integer :: k
      do k = 1, n
         u = 1.0_wp - cosine(k)
         g(k) = c(0) + u*(c(1) + u*(c(2) + u*(c(3) + u*c(4))))
         dg(k) = -(c(1) + u*(2.0_wp*c(2) + u*(3.0_wp*c(3) + u*(4.0_wp*c(4) + u*(5.0_wp*c(5))))))
         ddg(k) = 2.0_wp*c(2) + u*(6.0_wp*c(3) + u*(12.0_wp*c(4) + u*(20.0_wp*c(5) + u*(30.0_wp*c(6)))))
      end do
      do k = 1, n
         if (.not. 1.0_wp - cosine(k) < small) call angle_ratio(cosine(k), g(k), dg(k), ddg(k))
      end do
   end subroutine angle_ratios

   !> g and both derivatives of one angle that is not small.
   pure subroutine angle_ratio(cosine, g, dg, ddg)
      real(wp), intent(in) :: cosine
      real(wp), intent(out) :: g, dg, ddg
      real(wp) :: u, sine_square
      integer :: n
      u = 1.0_wp - cosine
      if (u < series_limit) then
         g = c(series_terms)
         dg = 0.0_wp
         ddg = 0.0_wp
         do n = series_terms - 1, 0, -1     ! Horner, with both derivatives carried along
            ddg = ddg*u + 2.0_wp*dg
            dg = dg*u + g
            g = g*u + c(n)
         end do
         dg = -dg                            ! d/dcos = -d/du
      else
         sine_square = max(u*(1.0_wp + cosine), folded)
         g = acos(max(cosine, -1.0_wp))/sqrt(sine_square)
         dg = (g*cosine - 1.0_wp)/sine_square
         ddg = (3.0_wp*cosine*dg + g)/sine_square
      end if
   end subroutine angle_ratio

   !> g of angle_ratios alone.
   pure function angle_ratio_alone(cosine) result(g)
      real(wp), intent(in) :: cosine   !< cos(alpha) [-]
      real(wp) :: g                    !< [-]
      real(wp) :: u, dg, ddg
      u = 1.0_wp - cosine
      if (u < small) then
         g = c(0) + u*(c(1) + u*(c(2) + u*(c(3) + u*c(4))))
      else
         call angle_ratio(cosine, g, dg, ddg)
      end if
   end function angle_ratio_alone

   !> g of angle_ratios and its first derivative.
   pure subroutine angle_ratio_once(cosine, g, dg)
      real(wp), intent(in) :: cosine   !< cos(alpha) [-]
      real(wp), intent(out) :: g, dg   !< g, dg/dcos [-]
      real(wp) :: u, ddg
      u = 1.0_wp - cosine
      if (u < small) then
         g = c(0) + u*(c(1) + u*(c(2) + u*(c(3) + u*c(4))))
         dg = -(c(1) + u*(2.0_wp*c(2) + u*(3.0_wp*c(3) + u*(4.0_wp*c(4) + u*(5.0_wp*c(5))))))
      else
         call angle_ratio(cosine, g, dg, ddg)
      end if
   end subroutine angle_ratio_once
end module dg_beam_angle

!> The span of a string between an end held in the middle of the hole and the wall on which it lies.
!>
!> A beam under axial compression F and a side load n towards the wall, EI y'''' + F y'' = n, with y = y'' = 0 at the end and
!> y = c, y' = y'' = 0 where it meets the wall. In units of the clearance c and of the length l = (EI c/n)^(1/4), with
!> k^2 = F/sqrt(EI n/c), where g = cos(k (x - X/2))/cos(k X/2):
!>   X tan(k X/2)/k^3 - X^2/(2 k^2) = 1                            the length X of the span
!>   y = (g - 1)/k^4 + (tan(k X/2)/k^3 - X/k^2) x + x^2/(2 k^2)    its shape
!> and the same with hyperbolic functions of a string in tension. Without axial force X = 24^(1/4).
module dg_end_span
   use dg_constants, only: pi
   use dg_kinds, only: wp
   implicit none
   private
   public :: lift_end, span_length, span_shape

   !> Square of a wave number that counts as no axial force [-]: 1/k^4 would eat the digits of a smaller one.
   real(wp), parameter :: least_square = 1.0e-3_wp
   !> A span longer than this part of the string is left alone: it would meet the other end's.
   real(wp), parameter :: most_of_string = 0.5_wp
   !> Halvings in the search of X: to round-off.
   integer, parameter :: halvings = 50

contains

   !> Lifts a string laid against the wall off it next to an end in the middle of the hole: offset [m] and slope [-] across the
   !> hole (2,nodes), the nodes being `away` [m] from that end; `sense` is 1 where depth grows away from it, -1 where it falls.
   pure subroutine lift_end(away, sense, compression, ei, side_load, clearance, offset, slope)
      real(wp), intent(in) :: away(:)
      integer, intent(in) :: sense
      real(wp), intent(in) :: compression   !< F, < 0 in tension [N]
      real(wp), intent(in) :: ei, side_load, clearance   !< at the end [N.m2, N/m, m]
      real(wp), intent(inout) :: offset(:, :), slope(:, :)
      real(wp) :: unit, square, length, height, rise
      integer :: i
      if (.not. side_load > 0.0_wp) return
      unit = (ei*clearance/side_load)**0.25_wp
      square = compression/sqrt(ei*side_load/clearance)
      length = span_length(square)
      if (length*unit > most_of_string*maxval(away)) return
      do i = 1, size(away)
         if (away(i) >= length*unit) cycle
         call span_shape(square, length, away(i)/unit, height, rise)
         slope(:, i) = height*slope(:, i) + sense*rise/unit*offset(:, i)
         offset(:, i) = height*offset(:, i)
      end do
   end subroutine lift_end

   !> Length X of the span [-] by the square k^2 of its wave number, < 0 in tension.
   pure function span_length(square) result(length)
      real(wp), intent(in) :: square
      real(wp) :: length
      real(wp) :: k, low, high, missing
      integer :: i
      k = wave_number(square)
      low = 0.0_wp
      high = pi/k
      if (square < 0.0_wp) high = 1.0_wp/k + sqrt(1.0_wp/k**2 + 2.0_wp*k**2)
      do i = 1, halvings
         length = 0.5_wp*(low + high)
         if (square < 0.0_wp) then
            missing = 1.0_wp - length**2/(2.0_wp*k**2) + length*tanh(0.5_wp*k*length)/k**3
         else
            missing = 1.0_wp + length**2/(2.0_wp*k**2) - length*tan(0.5_wp*k*length)/k**3
         end if
         if (missing > 0.0_wp) then
            low = length
         else
            high = length
         end if
      end do
   end function span_length

   !> Height y and its derivative by x [-] at x from the end.
   pure subroutine span_shape(square, length, x, height, rise)
      real(wp), intent(in) :: square
      real(wp), intent(in) :: length     !< X of span_length
      real(wp), intent(in) :: x
      real(wp), intent(out) :: height, rise
      real(wp) :: k, g, dg, linear, near, far
      k = wave_number(square)
      if (square < 0.0_wp) then
         near = exp(-k*x)
         far = exp(-k*(length - x))
         g = (near + far)/(1.0_wp + exp(-k*length))
         dg = k*(far - near)/(1.0_wp + exp(-k*length))
         linear = length/k**2 - tanh(0.5_wp*k*length)/k**3
         height = (g - 1.0_wp)/k**4 + linear*x - x**2/(2.0_wp*k**2)
         rise = dg/k**4 + linear - x/k**2
      else
         g = cos(k*(x - 0.5_wp*length))/cos(0.5_wp*k*length)
         dg = -k*sin(k*(x - 0.5_wp*length))/cos(0.5_wp*k*length)
         linear = tan(0.5_wp*k*length)/k**3 - length/k**2
         height = (g - 1.0_wp)/k**4 + linear*x + x**2/(2.0_wp*k**2)
         rise = dg/k**4 + linear + x/k**2
      end if
   end subroutine span_shape

   pure function wave_number(square) result(k)
      real(wp), intent(in) :: square
      real(wp) :: k
      k = sqrt(max(abs(square), least_square))
   end function wave_number
end module dg_end_span

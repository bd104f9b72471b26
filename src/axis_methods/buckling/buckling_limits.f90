!> Compressive forces at which a string in a hole buckles, by published closed forms. All forces here are effective and
!> positive in compression. Torque, tool joints and friction are neglected.
!>
!> - Dawson & Paslay 1984 (SPE 11167): a string on the low side of an inclined hole buckles into a sine at 2 sqrt(EI n/c). The
!>   side load n per length presses it against the wall. In a straight hole n = w sin(theta).
!> - In a bend the compression itself presses the string to the wall or lifts it off (He & Kyllingstad 1995, SPE 25370). Then n
!>   = |w_across - F k| with the curvature vector k of the hole, and F is a root of F = 2 sqrt(EI n(F)/c).
!> - In a vertical hole there is no side load. There the weight of the string itself carries it up to Lubinski's (1950) 1.94
!>   (EI w^2)^(1/3). That load is at the end of the compressed part with the greatest compression. It is for a string of 8
!>   (EI/w)^(1/3). Longer ones buckle earlier, towards 1.02 for infinite length. The limit is the larger of the two. Without
!>   the second every near-vertical hole would raise an alarm.
!> - Helical: published limits are between 1.41 and 2.83 times the sinusoidal one. Two are given: sqrt(2) times (Chen, Lin &
!>   Cheatham 1990, from energy) and 2 sqrt(2) - 1 times (Wu & Juvkam-Wold 1993, while loading). In a vertical hole the limit
!>   is 5.55 (EI w^2)^(1/3) (Wu & Juvkam-Wold 1993).
module dg_buckling_limits
   use dg_kinds, only: wp
   use dg_named_states, only: buckling_helical, buckling_none, buckling_sinusoidal
   implicit none
   private
   public :: sinusoidal_limit, curved_limit, least_curved_limit, vertical_unit, helical_limit, buckled_state
   public :: helical_low, helical_high, lubinski_first
   public :: buckling_none, buckling_sinusoidal, buckling_helical

   real(wp), parameter :: helical_low = sqrt(2.0_wp)                 !< over the sinusoidal limit (Chen et al.)
   real(wp), parameter :: helical_high = 2.0_wp*sqrt(2.0_wp) - 1.0_wp !< the same (Wu & Juvkam-Wold)
   real(wp), parameter :: lubinski_first = 1.94_wp                   !< Lubinski 1950, in units of (EI w^2)^(1/3)
   real(wp), parameter :: vertical_helical = 5.55_wp                 !< Wu & Juvkam-Wold 1993, in the same units

   !> Difference of two squares, over their sum, that is beyond round-off (a dozen roundings are some 1e-15) [-].
   real(wp), parameter :: square_round_off = 1.0e-13_wp
   !> Halvings of an interval, down to round-off, also for roots at a hundredth of it.
   integer, parameter :: halvings = 60

contains

   !> Limit of Dawson & Paslay in a straight hole [N].
   elemental function sinusoidal_limit(ei, across, clearance) result(force)
      real(wp), intent(in) :: ei          !< bending stiffness [N.m2]
      real(wp), intent(in) :: across      !< weight across the hole, w sin(theta), >= 0 [N/m]
      real(wp), intent(in) :: clearance   !< (D - d)/2, > 0 [m]
      real(wp) :: force
      force = 2.0_wp*sqrt(ei*across/clearance)
   end function sinusoidal_limit

   !> The same limit in a bend [N]: least F > 0 with F^2 c/(4 EI) = |w_across - F k|. It is 0 where neither weight nor
   !> curvature presses the string to the wall. It is at most the root for a string pressed to the wall by all of the
   !> curvature, that of a quadratic.
   !>
   !> In a drop there may be three roots. Between the first two the compression lifts the string off the low side. Beyond them
   !> it presses the string to the high side, where it buckles at the third. For a given compression beyond the second root the
   !> result is the third root. Otherwise it is the first one.
   pure function curved_limit(ei, across, curvature, clearance, compression) result(force)
      real(wp), intent(in) :: ei             !< bending stiffness [N.m2]
      real(wp), intent(in) :: across(3)      !< weight across the hole, a vector [N/m]
      real(wp), intent(in) :: curvature(3)   !< of the hole axis, dt/ds with t down the hole [1/m]
      real(wp), intent(in) :: clearance      !< > 0 [m]
      real(wp), intent(in), optional :: compression   !< present compression [N]; absent: the first root
      real(wp) :: force
      real(wp) :: share, weight, bend, highest, inflection, peak, trough, squares(3)
      share = 0.25_wp*clearance/ei
      weight = norm2(across)
      bend = norm2(curvature)
      squares = [dot_product(across, across), dot_product(across, curvature), dot_product(curvature, curvature)]
      highest = 0.5_wp*(bend + sqrt(bend**2 + 4.0_wp*share*weight))/share
      force = highest
      if (bend <= 0.0_wp .or. weight <= 0.0_wp) return
      ! excess(F) = (F^2 c/(4 EI))^2 - |w_across - F k|^2. Let its slope be positive at 0 and negative at its point of
      ! inflection. Then it rises from F = 0 to a peak and falls to a trough. It has three roots if the peak is above zero and
      ! the trough below it. Otherwise it has one.
      inflection = bend/(sqrt(6.0_wp)*share)
      if (squares(2) <= 0.0_wp .or. half_slope(inflection) >= 0.0_wp) then
         force = root_between(0.0_wp, highest)
         return
      end if
      ! the slope is positive up to F = (w.k)/k^2 and negative at one and a half times that
      peak = squares(2)/squares(3)
      peak = turning_point(peak, min(1.5_wp*peak, inflection))
      trough = turning_point(highest, inflection)
      if (.not. reached(peak)) then
         force = root_between(trough, highest)
         return
      end if
      force = root_between(0.0_wp, peak)
      if (.not. present(compression) .or. reached(trough)) return
      if (compression > trough .or. (compression > peak .and. .not. reached(compression))) force = root_between(trough, highest)

   contains

      !> True if F^2 c/(4 EI) is at least |w_across - F k|. Squares decide in a tenth of the time, unless round-off matters.
      pure function reached(f) result(is)
         real(wp), intent(in) :: f
         logical :: is
         real(wp) :: left, sum
         left = (share*f**2)**2
         sum = squares(1) + f**2*squares(3)
         if (abs(left - sum + 2.0_wp*f*squares(2)) > square_round_off*(left + sum)) then
            is = left > sum - 2.0_wp*f*squares(2)
         else
            is = share*f**2 - norm2(across - f*curvature) >= 0.0_wp
         end if
      end function reached

      !> Half the derivative of the excess by F.
      pure function half_slope(f) result(slope)
         real(wp), intent(in) :: f
         real(wp) :: slope
         slope = 2.0_wp*share**2*f**3 - squares(3)*f + squares(2)
      end function half_slope

      !> Turning point of the excess, between a place where it rises and one where it falls [N].
      pure function turning_point(rises, falls) result(f)
         real(wp), intent(in) :: rises, falls
         real(wp) :: f, up, down
         integer :: i
         up = rises
         down = falls
         do i = 1, halvings
            f = 0.5_wp*(up + down)
            if (half_slope(f) > 0.0_wp) then
               up = f
            else
               down = f
            end if
         end do
      end function turning_point

      !> Place where the limit is reached, between a place where it is not and one where it is [N]. Newton's steps are used. A
      !> step that leaves the interval, or is not shorter than half the one before, is replaced by halving.
      pure function root_between(below, above) result(f)
         real(wp), intent(in) :: below, above
         real(wp) :: f, low, high, presses(3), pressed, excess, slope, next, step
         integer :: i
         low = below
         high = above
         f = above
         step = high - low
         do i = 1, halvings
            presses = across - f*curvature
            pressed = sqrt(presses(1)**2 + presses(2)**2 + presses(3)**2)
            excess = share*f**2 - pressed
            if (excess >= 0.0_wp) then
               high = f
            else
               low = f
            end if
            slope = 2.0_wp*share*f
            if (pressed > 0.0_wp) slope = slope + (squares(2) - f*squares(3))/pressed
            if (abs(excess) <= 2.0_wp*epsilon(f)*f*abs(slope)) exit
            next = 0.5_wp*(low + high)
            if (abs(excess) < 0.5_wp*step*abs(slope)) then
               if (f - excess/slope > low .and. f - excess/slope < high) next = f - excess/slope
            end if
            step = abs(next - f)
            f = next
            if (step <= epsilon(f)*f) exit
         end do
      end function root_between
   end function curved_limit

   !> Lower bound of curved_limit [N], for a quick check. It is the limit of a string lifted off by all of the curvature. In a
   !> straight hole it is the limit itself.
   pure function least_curved_limit(ei, across, curvature, clearance) result(force)
      real(wp), intent(in) :: ei, across(3), curvature(3), clearance   !< as in curved_limit [N.m2, N/m, 1/m, m]
      real(wp) :: force
      real(wp) :: weight, bend
      weight = norm2(across)
      bend = norm2(curvature)
      force = 0.0_wp
      if (weight > 0.0_wp) force = 2.0_wp*weight/(bend + sqrt(bend**2 + clearance/ei*weight))
   end function least_curved_limit

   !> Unit of force of a heavy vertical string [N], (EI w^2)^(1/3). A string that floats, or stands on its upper end, has its
   !> greatest compression there. It is the same string upside down.
   elemental function vertical_unit(ei, weight) result(force)
      real(wp), intent(in) :: ei       !< bending stiffness [N.m2]
      real(wp), intent(in) :: weight   !< along the hole, w cos(theta), of either sign [N/m]
      real(wp) :: force
      force = 0.0_wp
      if (abs(weight) > 0.0_wp) force = (ei*weight**2)**(1.0_wp/3.0_wp)
   end function vertical_unit

   !> Helical limit [N] by one of the two factors: the larger one of the inclined and the vertical hole.
   elemental function helical_limit(sinusoidal, vertical, factor) result(force)
      real(wp), intent(in) :: sinusoidal  !< limit by curved_limit [N]
      real(wp), intent(in) :: vertical    !< unit by vertical_unit [N]
      real(wp), intent(in) :: factor      !< helical_low or helical_high [-]
      real(wp) :: force
      force = max(factor*sinusoidal, vertical_helical*vertical)
   end function helical_limit

   !> Buckling state of a string under `compression` [N] by its limits [N]. A limit of 0 is absent.
   elemental function buckled_state(compression, sinusoidal, helical) result(state)
      real(wp), intent(in) :: compression, sinusoidal, helical   !< >= 0 [N]
      integer :: state
      state = buckling_none
      if (.not. sinusoidal > 0.0_wp) return
      if (compression > sinusoidal) state = buckling_sinusoidal
      if (compression > helical) state = buckling_helical
   end function buckled_state
end module dg_buckling_limits

!> Fatigue of pipe that turns in a bend: the bending stress with endless life under a tension, and the number of turns above
!> it.
!>
!> The curves E75 and S135 are those of API RP 7G, 16th ed., A.11 (Lubinski 1961). Stresses are in psi, and s_t is the buoyed
!> tension per area:
!>
!>   E75    s_b = 19500 - 10/67 s_t - 0.6/670^2 (s_t - 33500)^2
!>   S135   s_b = 20000 (1 - s_t/145000)
!>
!> An own curve has an amplitude without tension and Goodman's line to the tensile strength. All curves hold for a number of
!> turns. At larger amplitudes the turns to failure fall with the amplitude to the power -m, m the exponent of a test (Basquin).
module dg_fatigue_curve
   use dg_kinds, only: wp
   use dg_constants, only: psi
   implicit none
   private
   public :: fatigue_curve_type, permitted_amplitude, turns_to_failure
   public :: fatigue_none, fatigue_e75, fatigue_s135, fatigue_own, fatigue_curve_name

   integer, parameter :: fatigue_none = 1, fatigue_e75 = 2, fatigue_s135 = 3, fatigue_own = 4
   !> Names in decks, in the order of the numbers above.
   character(*), parameter :: fatigue_curve_name(4) = [character(4) :: 'none', 'E75', 'S135', 'own']

   !> Least permitted amplitude [Pa], for a pipe under more tension than its curve covers.
   real(wp), parameter :: least = 100.0_wp*psi

   type :: fatigue_curve_type
      integer :: curve = fatigue_none
      real(wp) :: limit = 0.0_wp       !< amplitude of an own curve with endless life, without tension [Pa]
      real(wp) :: tensile = 0.0_wp     !< tensile strength of an own curve [Pa]; 0: tension has no effect
      real(wp) :: share = 1.0_wp       !< part of the amplitude in corrosive mud [-]
      real(wp) :: exponent = 0.0_wp    !< m [-]; 0: not known
      real(wp) :: turns = 1.0e6_wp     !< number of turns at which the limit begins [-]
   end type fatigue_curve_type

contains

   !> Amplitude of bending stress with endless life [Pa].
   elemental function permitted_amplitude(curve, tension) result(amplitude)
      type(fatigue_curve_type), intent(in) :: curve    !< not fatigue_none
      real(wp), intent(in) :: tension                  !< effective, per area of steel; compression counts as zero [Pa]
      real(wp) :: amplitude
      real(wp) :: pulled
      pulled = max(tension, 0.0_wp)/psi
      select case (curve%curve)
      case (fatigue_e75)
         amplitude = psi*(19500.0_wp - 10.0_wp/67.0_wp*pulled - 0.6_wp*((pulled - 33500.0_wp)/670.0_wp)**2)
      case (fatigue_s135)
         amplitude = psi*20000.0_wp*(1.0_wp - pulled/145000.0_wp)
      case default
         amplitude = curve%limit
         if (curve%tensile > 0.0_wp) amplitude = amplitude*(1.0_wp - pulled*psi/curve%tensile)
      end select
      amplitude = max(curve%share*amplitude, least)
   end function permitted_amplitude

   !> Turns to failure, at least one [-]; 0 for an amplitude with endless life, or without a known exponent.
   elemental function turns_to_failure(curve, amplitude, permitted) result(turns)
      type(fatigue_curve_type), intent(in) :: curve
      real(wp), intent(in) :: amplitude, permitted     !< [Pa]
      real(wp) :: turns
      turns = 0.0_wp
      if (amplitude > permitted .and. curve%exponent > 0.0_wp) &
         turns = max(curve%turns*(permitted/amplitude)**curve%exponent, 1.0_wp)
   end function turns_to_failure
end module dg_fatigue_curve

!> Strengths of the body of a pipe against single loads, as API rates it: tension, torsion, burst, collapse, slips.
!>
!> For worn pipe they are those of the worn section (API RP 7G: wear outside, the bore stays). Collapse follows API Bulletin
!> 5C3 (API TR 5C3, ISO 10400), whose formulas are fits to tests on steel, in psi.
module dg_pipe_strength
   use dg_kinds, only: wp
   use dg_constants, only: psi
   use dg_component, only: component_type, is_worn, tube_area, tube_inertia, worn_od
   implicit none
   private
   public :: yield_left, warmed
   public :: tensile_strength, torsional_strength, burst_strength, collapse_strength, collapses_as_steel, slip_share

   !> Guaranteed wall of new pipe over the nominal one (API Spec 5CT, 5D).
   real(wp), parameter :: mill_wall = 0.875_wp
   !> Shear strength over yield strength, as API rounds von Mises' 1/sqrt(3).
   real(wp), parameter :: shear_share = 0.577_wp
   !> Range of yield strengths of the collapse fits [psi]: that of API's grades. Below, collapse is assumed to fall with the
   !> strength. Above, it stays.
   real(wp), parameter :: weakest_fit = 24.0e3_wp, strongest_fit = 150.0e3_wp
   !> Factor of the elastic collapse of steel [psi].
   real(wp), parameter :: elastic = 46.95e6_wp
   !> Least part of the yield strength at any temperature [-]. The straight line is meant for a loss of some per cent.
   real(wp), parameter :: least_left = 0.01_wp
   !> Least Young's modulus of steel [Pa].
   real(wp), parameter :: least_steel = 180.0e9_wp

contains

   !> Part of the yield strength of a component that is left at a temperature [-]. It falls in a straight line.
   elemental function yield_left(part, warmer) result(left)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: warmer    !< temperature above ambient [K]
      real(wp) :: left
      left = max(1.0_wp - part%yield_loss*max(warmer, 0.0_wp), least_left)
   end function yield_left

   !> A component with the strength of body and connections that is left.
   pure function warmed(part, left) result(warm)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: left      !< part of the yield strength [-]
      type(component_type) :: warm
      warm = part
      warm%yield = left*part%yield
      warm%joint_torsion = left*part%joint_torsion
   end function warmed

   !> Tension at which the body yields [N].
   elemental function tensile_strength(part) result(force)
      type(component_type), intent(in) :: part   !< with a yield strength
      real(wp) :: force
      force = part%yield*tube_area(worn_od(part), part%id)
   end function tensile_strength

   !> Torque at which the body yields outside [N.m]: 0.577 Y 2J/D (API RP 7G, A.9.1).
   elemental function torsional_strength(part) result(torque)
      type(component_type), intent(in) :: part
      real(wp) :: torque
      torque = shear_share*part%yield*4.0_wp*tube_inertia(worn_od(part), part%id)/worn_od(part)
   end function torsional_strength

   !> Pressure inside over that outside at which the body yields [Pa], by Barlow's 2 Y t/D. New pipe has 7/8 of the wall. Worn
   !> pipe has the wall left, over the nominal diameter (API RP 7G).
   elemental function burst_strength(part) result(pressure)
      type(component_type), intent(in) :: part
      real(wp) :: pressure
      real(wp) :: share
      share = mill_wall
      if (is_worn(part)) share = part%wall_left
      pressure = part%yield*share*(part%od - part%id)/part%od
   end function burst_strength

   !> True if the collapse formulas, fits to tests on steel, apply to this component.
   elemental function collapses_as_steel(part) result(steel)
      type(component_type), intent(in) :: part
      logical :: steel
      steel = part%youngs >= least_steel
   end function collapses_as_steel

   !> Pressure outside over that inside at which the body collapses [Pa]. Tension reduces the strength: Y_a = Y (sqrt(1 - 3/4
   !> s^2) - s/2), s = stress/Y (API Bulletin 5C3, 2.1.5). It is 0 if the body yields by tension alone.
   elemental function collapse_strength(part, axial_stress) result(pressure)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: axial_stress   !< axial stress plus the pressure inside; compression counts as zero [Pa]
      real(wp) :: pressure
      real(wp) :: share, strength, od
      share = min(max(axial_stress, 0.0_wp)/part%yield, 1.0_wp)
      strength = part%yield*max(sqrt(1.0_wp - 0.75_wp*share**2) - 0.5_wp*share, 0.0_wp)/psi
      od = worn_od(part)
      pressure = psi*collapse_fit(2.0_wp*od/(od - part%id), min(max(strength, weakest_fit), strongest_fit))* &
         min(strength/weakest_fit, 1.0_wp)
   end function collapse_strength

   !> Collapse of steel pipe without tension [psi], in four ranges of slenderness: yield, plastic, transition, elastic (API
   !> Bulletin 5C3, 2.1.1 to 2.1.4).
   elemental function collapse_fit(slenderness, yield) result(pressure)
      real(wp), intent(in) :: slenderness   !< diameter over wall, >= 2 [-]
      real(wp), intent(in) :: yield         !< [psi]
      real(wp) :: pressure
      real(wp) :: a, b, c, f, g, ratio, share
      a = 2.8762_wp + 0.10679e-5_wp*yield + 0.21301e-10_wp*yield**2 - 0.53132e-16_wp*yield**3
      b = 0.026233_wp + 0.50609e-6_wp*yield
      c = -465.93_wp + 0.030867_wp*yield - 0.10483e-7_wp*yield**2 + 0.36989e-13_wp*yield**3
      ratio = b/a
      share = 3.0_wp*ratio/(2.0_wp + ratio)
      f = elastic*share**3/(yield*(share - ratio)*(1.0_wp - share)**2)
      g = f*ratio
      if (slenderness <= (sqrt((a - 2.0_wp)**2 + 8.0_wp*(b + c/yield)) + a - 2.0_wp)/(2.0_wp*(b + c/yield))) then
         pressure = 2.0_wp*yield*(slenderness - 1.0_wp)/slenderness**2
      else if (slenderness <= yield*(a - f)/(c + yield*(b - g))) then
         pressure = yield*(a/slenderness - b) - c
      else if (slenderness <= 1.0_wp/share) then
         pressure = yield*(f/slenderness - g)
      else
         pressure = elastic/(slenderness*(slenderness - 1.0_wp)**2)
      end if
   end function collapse_fit

   !> Part of the tensile strength that is left in slips [-]. The slips press on the pipe with `lateral` times the load, spread
   !> over their length. Its bore yields at 1/sqrt(1 + x + x^2) of the strength, x = D K/(2 L) (Reinhold & Spiri 1959).
   elemental function slip_share(od, lateral, length) result(share)
      real(wp), intent(in) :: od        !< [m]
      real(wp), intent(in) :: lateral   !< K, lateral over axial load [-]
      real(wp), intent(in) :: length    !< of the slips, > 0 [m]
      real(wp) :: share
      real(wp) :: x
      x = 0.5_wp*od*lateral/length
      share = 1.0_wp/sqrt(1.0_wp + x + x**2)
   end function slip_share
end module dg_pipe_strength

!> Stresses in the wall of a pipe under axial force, torque, bending and pressure.
!>
!> The pipe is a thick-walled elastic cylinder (Lame 1852; Timoshenko & Goodier, Theory of Elasticity, art. 28). Its stresses
!> are largest at one of four places of the section. They are at the inner or outer surface, on the tensile or the compressive
!> side of the bend. Von Mises' equivalent stress (1913) is the largest of the four. Shear force is neglected. Its stress
!> vanishes where bending is largest and is small in a slender drillstring.
module dg_pipe_stress
   use dg_kinds, only: wp
   use dg_component, only: tube_area, tube_inertia
   implicit none
   private
   public :: pipe_stress_type, pipe_stress, lame_hoop, lame_radial, von_mises, true_axial, tension_capacity

   type :: pipe_stress_type
      real(wp) :: axial = 0.0_wp      !< of the true axial force, tension > 0 [Pa]
      real(wp) :: bending = 0.0_wp    !< amplitude at the outer surface, >= 0 [Pa]
      real(wp) :: torsional = 0.0_wp  !< shear stress at the outer surface, >= 0 [Pa]
      real(wp) :: hoop = 0.0_wp       !< at the inner surface, tension > 0 [Pa]
      real(wp) :: von_mises = 0.0_wp  !< largest in the section [Pa]
   end type pipe_stress_type

contains

   !> True axial force in the wall [N] from the effective one: T = T_e - (p_o A_o - p_i A_i). The effective force is that of a
   !> string weighed in mud. A strain gauge on the wall would measure the true one.
   elemental function true_axial(effective, od, id, outside, inside) result(force)
      real(wp), intent(in) :: effective         !< tension > 0 [N]
      real(wp), intent(in) :: od, id            !< [m]
      real(wp), intent(in) :: outside, inside   !< pressures [Pa]
      real(wp) :: force
      force = effective - (outside*tube_area(od, 0.0_wp) - inside*tube_area(id, 0.0_wp))
   end function true_axial

   !> Hoop stress [Pa] in a cylinder under pressure (Lame). A solid bar (id = 0) has the outside pressure everywhere.
   elemental function lame_hoop(od, id, outside, inside, diameter) result(stress)
      real(wp), intent(in) :: od, id            !< [m]
      real(wp), intent(in) :: outside, inside   !< pressures [Pa]
      real(wp), intent(in) :: diameter          !< diameter of the place, id to od, > 0 [m]
      real(wp) :: stress
      stress = lame_mean(od, id, outside, inside) + lame_swing(od, id, outside, inside)/diameter**2
   end function lame_hoop

   !> Radial stress [Pa] in a cylinder under pressure (Lame): minus the pressure at either surface.
   elemental function lame_radial(od, id, outside, inside, diameter) result(stress)
      real(wp), intent(in) :: od, id            !< [m]
      real(wp), intent(in) :: outside, inside   !< pressures [Pa]
      real(wp), intent(in) :: diameter          !< diameter of the place, id to od, > 0 [m]
      real(wp) :: stress
      stress = lame_mean(od, id, outside, inside) - lame_swing(od, id, outside, inside)/diameter**2
   end function lame_radial

   !> Constant term of Lame's stresses, (p_i r_i^2 - p_o r_o^2)/(r_o^2 - r_i^2) [Pa].
   elemental function lame_mean(od, id, outside, inside) result(stress)
      real(wp), intent(in) :: od, id, outside, inside
      real(wp) :: stress
      stress = (inside*id**2 - outside*od**2)/((od - id)*(od + id))
   end function lame_mean

   !> Factor of the term with the diameter, 4 (p_i - p_o) r_i^2 r_o^2/(r_o^2 - r_i^2) [Pa.m2].
   elemental function lame_swing(od, id, outside, inside) result(swing)
      real(wp), intent(in) :: od, id, outside, inside
      real(wp) :: swing
      swing = (inside - outside)*id**2*od**2/((od - id)*(od + id))
   end function lame_swing

   !> Von Mises' equivalent of three normal stresses at right angles and one shear stress [Pa].
   elemental function von_mises(axial, hoop, radial, shear) result(stress)
      real(wp), intent(in) :: axial, hoop, radial, shear
      real(wp) :: stress
      stress = sqrt(0.5_wp*((axial - hoop)**2 + (hoop - radial)**2 + (radial - axial)**2) + 3.0_wp*shear**2)
   end function von_mises

   !> Compute all stresses in a section.
   elemental function pipe_stress(od, id, axial, torque, bending, outside, inside) result(stress)
      real(wp), intent(in) :: od, id            !< od > id >= 0 [m]
      real(wp), intent(in) :: axial             !< TRUE axial force, tension > 0 [N]
      real(wp), intent(in) :: torque            !< [N.m]
      real(wp), intent(in) :: bending           !< resultant moment, >= 0 [N.m]
      real(wp), intent(in) :: outside, inside   !< pressures [Pa]
      type(pipe_stress_type) :: stress
      real(wp) :: inertia, diameter, hoop, radial, bent, shear
      integer :: surface
      inertia = tube_inertia(od, id)
      stress%axial = axial/tube_area(od, id)
      stress%bending = abs(bending)*0.5_wp*od/inertia
      stress%torsional = abs(torque)*0.25_wp*od/inertia   ! polar moment 2 I
      ! A solid bar has no inner surface. Its axis has neither bending nor torsion.
      diameter = id
      if (.not. id > 0.0_wp) diameter = od
      stress%hoop = lame_hoop(od, id, outside, inside, diameter)
      stress%von_mises = 0.0_wp
      do surface = 1, 2
         if (surface == 2) diameter = od
         hoop = lame_hoop(od, id, outside, inside, diameter)
         radial = lame_radial(od, id, outside, inside, diameter)
         bent = stress%bending*diameter/od
         shear = stress%torsional*diameter/od
         stress%von_mises = max(stress%von_mises, von_mises(stress%axial + bent, hoop, radial, shear), &
                                von_mises(stress%axial - bent, hoop, radial, shear))
      end do
   end function pipe_stress

   !> Effective tension [N] at which a pipe under torque, bending and pressure yields. With the effective force in place of the
   !> true one, axial stress counts from the mean of hoop and radial stress (Lame). Von Mises' stress is then
   !>     sqrt((T/A + sigma_b)^2 + 3 tau^2 + 3 S^2),   S = (p_i - p_o) r_i^2 r_o^2/((r_o^2 - r_i^2) r^2).
   !> Only the difference of pressures counts, and one pressure on both sides does not lead to yield. S is largest at the inner
   !> surface, bending and torque at the outer one. The weaker surface counts. The tension is negative if torque, bending and
   !> pressure make the pipe yield without tension. Without bending and pressure it is the tension-torque envelope of API RP 7G
   !> (appendix A.9), there written as torque over tension.
   elemental function tension_capacity(od, id, torque, bending, difference, yield) result(tension)
      real(wp), intent(in) :: od, id      !< [m]
      real(wp), intent(in) :: torque      !< [N.m]
      real(wp), intent(in) :: bending     !< moment [N.m]
      real(wp), intent(in) :: difference  !< of pressures, inside - outside [Pa]
      real(wp), intent(in) :: yield       !< strength [Pa]
      real(wp) :: tension
      real(wp) :: shear, bent, swing
      bent = abs(bending)*0.5_wp*od/tube_inertia(od, id)
      shear = abs(torque)*0.25_wp*od/tube_inertia(od, id)
      swing = lame_swing(od, id, 0.0_wp, difference)
      tension = sqrt(max(yield**2 - 3.0_wp*shear**2 - 3.0_wp*(swing/od**2)**2, 0.0_wp)) - bent
      if (id > 0.0_wp) tension = min(tension, sqrt(max(yield**2 - 3.0_wp*(shear*id/od)**2 - 3.0_wp*(swing/id**2)**2, 0.0_wp)) &
                                              - bent*id/od)
      tension = tube_area(od, id)*tension
   end function tension_capacity
end module dg_pipe_stress

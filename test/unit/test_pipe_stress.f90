!> Stresses in the wall of a pipe against closed forms.
module dg_test_pipe_stress
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_component, only: tube_area, tube_inertia
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_pipe_stress, only: lame_hoop, lame_radial, pipe_stress, pipe_stress_type, tension_capacity, &
                             true_axial, von_mises
   implicit none
   private
   public :: pipe_stress_suite

   real(wp), parameter :: od = 0.127_wp, id = 0.1086_wp
   !> Some roundings of a double.
   real(wp), parameter :: rounding = 1.0e-13_wp

contains

   function pipe_stress_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('pipe_stress')
      call suite%addTest(TestMethod('lame', test_lame))
      call suite%addTest(TestMethod('thin_wall', test_thin_wall))
      call suite%addTest(TestMethod('von_mises', test_von_mises))
      call suite%addTest(TestMethod('one_load_at_a_time', test_one_load))
      call suite%addTest(TestMethod('inner_surface_governs', test_inner_surface))
      call suite%addTest(TestMethod('even_pressure_does_no_harm', test_even_pressure))
      call suite%addTest(TestMethod('true_axial_force', test_true_axial))
      call suite%addTest(TestMethod('tension_torque_envelope', test_envelope))
      call suite%addTest(TestMethod('solid_bar', test_solid_bar))
   end function pipe_stress_suite

   !> Outer radius twice the inner one, pressure p inside: hoop 5 p/3 inside, 2 p/3 outside, radial -p and 0.
   !> The same outside: hoop -8 p/3 inside, -5 p/3 outside.
   subroutine test_lame()
      call assertRelativelyEqual(5.0_wp/3.0_wp, lame_hoop(2.0_wp, 1.0_wp, 0.0_wp, 1.0_wp, 1.0_wp), rounding)
      call assertRelativelyEqual(2.0_wp/3.0_wp, lame_hoop(2.0_wp, 1.0_wp, 0.0_wp, 1.0_wp, 2.0_wp), rounding)
      call assertRelativelyEqual(-1.0_wp, lame_radial(2.0_wp, 1.0_wp, 0.0_wp, 1.0_wp, 1.0_wp), rounding)
      call assertEqual(0.0_wp, lame_radial(2.0_wp, 1.0_wp, 0.0_wp, 1.0_wp, 2.0_wp), rounding)
      call assertRelativelyEqual(-8.0_wp/3.0_wp, lame_hoop(2.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, 1.0_wp), rounding)
      call assertRelativelyEqual(-5.0_wp/3.0_wp, lame_hoop(2.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, 2.0_wp), rounding)
      call assertRelativelyEqual(-1.0_wp, lame_radial(2.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, 2.0_wp), rounding)
   end subroutine test_lame

   !> p d/(2 t) (Barlow), which a wall of a thousandth meets to a thousandth.
   subroutine test_thin_wall()
      real(wp), parameter :: diameter = 1.0_wp, wall = 1.0e-3_wp, thin = 2.0e-3_wp
      call assertRelativelyEqual(diameter/(2.0_wp*wall), &
                                 lame_hoop(diameter + wall, diameter - wall, 0.0_wp, 1.0_wp, diameter), thin)
   end subroutine test_thin_wall

   !> Uniaxial: itself. Pure shear: sqrt(3). Even pressure: nothing. Equal biaxial: itself.
   subroutine test_von_mises()
      call assertRelativelyEqual(3.0_wp, von_mises(3.0_wp, 0.0_wp, 0.0_wp, 0.0_wp), rounding)
      call assertRelativelyEqual(sqrt(3.0_wp), von_mises(0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp), rounding)
      call assertEqual(0.0_wp, von_mises(-2.0_wp, -2.0_wp, -2.0_wp, 0.0_wp))
      call assertRelativelyEqual(2.0_wp, von_mises(2.0_wp, 2.0_wp, 0.0_wp, 0.0_wp), rounding)
      call assertRelativelyEqual(5.0_wp, von_mises(4.0_wp, 0.0_wp, 0.0_wp, sqrt(3.0_wp)), rounding)
   end subroutine test_von_mises

   !> T/A; M r/I; M_t r/(2 I). With all of them the tensile side is worse: sqrt((T/A + M r/I)^2 + 3 tau^2).
   subroutine test_one_load()
      type(pipe_stress_type) :: stress
      real(wp) :: area, inertia, axial, bent, shear
      area = tube_area(od, id)
      inertia = tube_inertia(od, id)
      stress = pipe_stress(od, id, 500.0e3_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp)
      axial = 500.0e3_wp/area
      call assertRelativelyEqual(axial, stress%axial, rounding)
      call assertRelativelyEqual(axial, stress%von_mises, rounding)
      stress = pipe_stress(od, id, 0.0_wp, 0.0_wp, 10.0e3_wp, 0.0_wp, 0.0_wp)
      bent = 10.0e3_wp*0.0635_wp/inertia
      call assertRelativelyEqual(bent, stress%bending, rounding)
      call assertRelativelyEqual(bent, stress%von_mises, rounding)
      stress = pipe_stress(od, id, 0.0_wp, -20.0e3_wp, 0.0_wp, 0.0_wp, 0.0_wp)
      shear = 20.0e3_wp*0.0635_wp/(2.0_wp*inertia)
      call assertRelativelyEqual(shear, stress%torsional, rounding)
      call assertRelativelyEqual(sqrt(3.0_wp)*shear, stress%von_mises, rounding)
      stress = pipe_stress(od, id, -500.0e3_wp, 20.0e3_wp, 10.0e3_wp, 0.0_wp, 0.0_wp)
      call assertRelativelyEqual(sqrt((axial + bent)**2 + 3.0_wp*shear**2), stress%von_mises, rounding, &
                                 message='the compressive side is worse under compression')
   end subroutine test_one_load

   !> Pressure inside alone, ends free: hoop h and radial -p at the inner surface, sqrt(h^2 + h p + p^2).
   subroutine test_inner_surface()
      type(pipe_stress_type) :: stress
      real(wp), parameter :: p = 50.0e6_wp
      real(wp) :: hoop
      stress = pipe_stress(od, id, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, p)
      hoop = p*(od**2 + id**2)/(od**2 - id**2)
      call assertRelativelyEqual(hoop, stress%hoop, rounding)
      call assertRelativelyEqual(sqrt(hoop**2 + hoop*p + p**2), stress%von_mises, rounding)
   end subroutine test_inner_surface

   !> Mud at one pressure inside and outside adds nothing to von Mises' stress of the EFFECTIVE force.
   subroutine test_even_pressure()
      type(pipe_stress_type) :: stress
      real(wp), parameter :: p = 40.0e6_wp, effective = 300.0e3_wp
      stress = pipe_stress(od, id, true_axial(effective, od, id, p, p), 0.0_wp, 0.0_wp, p, p)
      call assertRelativelyEqual(-p, stress%hoop, rounding)
      call assertRelativelyEqual(effective/tube_area(od, id), stress%von_mises, rounding)
      call assertRelativelyEqual(effective/tube_area(od, id) - p, stress%axial, rounding)
   end subroutine test_even_pressure

   !> An open tube hanging in mud, at its lower end: effective force 0, true force -p A.
   subroutine test_true_axial()
      call assertRelativelyEqual(-1.0e7_wp*tube_area(od, id), true_axial(0.0_wp, od, id, 1.0e7_wp, 1.0e7_wp), rounding)
      call assertRelativelyEqual(2.0e5_wp + 1.0e7_wp*0.25_wp*pi*id**2, true_axial(2.0e5_wp, od, id, 0.0_wp, 1.0e7_wp), rounding, &
                                 message='pressure inside alone pulls')
   end subroutine test_true_axial

   !> No torque: A Y. Torque of first yield (tau = Y/sqrt(3)): nothing. Under the capacity von Mises' stress is the yield strength,
   !> with bending, too.
   subroutine test_envelope()
      real(wp), parameter :: yield = 931.0e6_wp
      real(wp), parameter :: moment = 10.0e3_wp
      type(pipe_stress_type) :: stress
      real(wp) :: torque, tension
      call assertRelativelyEqual(yield*tube_area(od, id), tension_capacity(od, id, 0.0_wp, 0.0_wp, 0.0_wp, yield), rounding)
      torque = yield/sqrt(3.0_wp)*2.0_wp*tube_inertia(od, id)/0.0635_wp
      call assertEqual(0.0_wp, tension_capacity(od, id, torque*(1.0_wp + rounding), 0.0_wp, 0.0_wp, yield), 1.0_wp, &
                       message='within 1 N')
      call assertEqual(0.0_wp, tension_capacity(od, id, 2.0_wp*torque, 0.0_wp, 0.0_wp, yield))
      tension = tension_capacity(od, id, 0.6_wp*torque, 0.0_wp, 0.0_wp, yield)
      call assertRelativelyEqual(0.8_wp*yield*tube_area(od, id), tension, rounding, message='3, 4, 5')
      tension = tension_capacity(od, id, 0.6_wp*torque, moment, 0.0_wp, yield)
      stress = pipe_stress(od, id, tension, 0.6_wp*torque, moment, 0.0_wp, 0.0_wp)
      call assertRelativelyEqual(yield, stress%von_mises, rounding, message='bending too')
      tension = tension_capacity(od, id, 0.3_wp*torque, 0.5_wp*moment, 60.0e6_wp, yield)
      stress = pipe_stress(od, id, true_axial(tension, od, id, 30.0e6_wp, 90.0e6_wp), 0.3_wp*torque, 0.5_wp*moment, 30.0e6_wp, &
                           90.0e6_wp)
      call assertRelativelyEqual(yield, stress%von_mises, rounding, message='pressure inside')
      tension = tension_capacity(od, id, 0.0_wp, 0.0_wp, -60.0e6_wp, yield)
      stress = pipe_stress(od, id, true_axial(tension, od, id, 90.0e6_wp, 30.0e6_wp), 0.0_wp, 0.0_wp, 90.0e6_wp, 30.0e6_wp)
      call assertRelativelyEqual(yield, stress%von_mises, rounding, message='pressure outside')
      call assertTrue(tension_capacity(od, id, 0.0_wp, 2.0_wp*yield*tube_inertia(od, id)/(0.5_wp*od), 0.0_wp, yield) < 0.0_wp, &
                      message='bending alone')
   end subroutine test_envelope

   subroutine test_solid_bar()
      type(pipe_stress_type) :: stress
      stress = pipe_stress(0.1_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 2.0e7_wp, 2.0e7_wp)
      call assertRelativelyEqual(-2.0e7_wp, stress%hoop, rounding)
      call assertRelativelyEqual(2.0e7_wp, stress%von_mises, rounding, message='squeezed on its side alone')
   end subroutine test_solid_bar
end module dg_test_pipe_stress

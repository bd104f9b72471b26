!> Buckled shape of a string from prescribed angles: straight along the low side, sinusoidal, helical, changing sides with the hole.
module dg_test_buckled_shape
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_buckled_shape, only: find_buckled_shape
   use dg_buckling_limits, only: buckling_helical, buckling_none, buckling_sinusoidal
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: buckled_shape_suite

   integer, parameter :: n = 101
   !> Half a wave pi sqrt(2 EI/F) is pi*sqrt(2e6/2e5) = 9.9 m.
   real(wp), parameter :: ei = 1.0e6_wp, force = 2.0e5_wp, wave_number = 0.3_wp

contains

   function buckled_shape_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('buckled_shape')
      call suite%addTest(TestMethod('shapes', test_shapes))
      call suite%addTest(TestMethod('half_and_half', test_half_and_half))
   end function buckled_shape_suite

   pure function depths() result(md)
      real(wp) :: md(n)
      integer :: i
      md = [(real(i - 1, wp), i=1, n)]
   end function depths

   subroutine look(clock, axial, off, shape, turns, critical)
      real(wp), intent(in) :: clock(n), axial, off
      real(wp), intent(in), optional :: critical      !< else a third of the force [N]
      integer, intent(out) :: shape(n)
      real(wp), intent(out) :: turns
      real(wp) :: limit
      integer :: i
      limit = force/3.0_wp
      if (present(critical)) limit = critical
      call find_buckled_shape(depths(), [(axial, i=1, n)], [(off, i=1, n)], modulo(clock, 2.0_wp*pi), [(ei, i=1, n)], &
                              [(limit, i=1, n)], shape, turns)
   end subroutine look

   subroutine test_shapes()
      real(wp), parameter :: slow = 0.02_wp
      real(wp) :: turns, md(n)
      integer :: shape(n)
      md = depths()
      call look(0.0_wp*md + pi, -force, 1.0_wp, shape, turns)
      call assertEqual(buckling_none, maxval(shape), message='on the low side')
      call look(pi + 0.5_wp*sin(wave_number*md), -force, 1.0_wp, shape, turns)
      call assertEqual(buckling_sinusoidal, minval(shape), message='snakes all along')
      call assertEqual(buckling_sinusoidal, maxval(shape), message='and no more')
      call assertEqual(0.0_wp, turns, message='no turns')
      call look(pi + 0.5_wp*sin(slow*md), -force, 1.0_wp, shape, turns)
      call assertEqual(buckling_none, maxval(shape), message='sways with the hole')
      call look(wave_number*md, -force, 1.0_wp, shape, turns)
      call assertEqual(buckling_helical, minval(shape), message='coils all along')
      call assertEqual(wave_number*100.0_wp/(2.0_wp*pi), turns, 1.0e-12_wp, message='turns')
      call look(-wave_number*md, -force, 1.0_wp, shape, turns)
      call assertEqual(buckling_helical, minval(shape), message='coils left-handed')
      call look(pi + 0.5_wp*sin(wave_number*md), -force, 1.0_wp, shape, turns, critical=1.1_wp*force)
      call assertEqual(buckling_none, maxval(shape), message='follows a crooked hole')
      call look(wave_number*md, -force, 1.0_wp, shape, turns, critical=1.1_wp*force)
      call assertEqual(buckling_none, maxval(shape), message='follows a hole that winds')
      call assertEqual(0.0_wp, turns, message='no turns')
      call look(pi + 0.5_wp*sin(wave_number*md), -force, 1.0_wp, shape, turns, critical=missing)
      call assertEqual(buckling_sinusoidal, maxval(shape), message='nothing holds it')
      call look(wave_number*md, force, 1.0_wp, shape, turns)
      call assertEqual(buckling_none, maxval(shape), message='in tension')
      call look(wave_number*md, -force, 0.1_wp, shape, turns)
      call assertEqual(buckling_none, maxval(shape), message='next to the axis')
   end subroutine test_shapes

   !> A string that coils over its first half, then lies.
   subroutine test_half_and_half()
      real(wp) :: turns, md(n)
      integer :: shape(n)
      md = depths()
      call look(wave_number*min(md, 50.0_wp), -force, 1.0_wp, shape, turns)
      call assertEqual(wave_number*50.0_wp/(2.0_wp*pi), turns, 1.0e-12_wp, message='turns')
      call assertEqual(buckling_helical, minval(shape(:50)), message='the coil')
      call assertEqual(buckling_none, maxval(shape(53:)), message='string that lies is no part of the coil')
      call look(0.1_wp*wave_number*md, -force, 1.0_wp, shape, turns)
      call assertEqual(0.0_wp, turns, message='goes round slowly: half a turn')
      call look(0.25_wp*wave_number*md, -force, 1.0_wp, shape, turns)
      call assertEqual(buckling_none, maxval(shape), message='goes round once in four pitches')
   end subroutine test_half_and_half
end module dg_test_buckled_shape

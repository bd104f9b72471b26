!> The snake of least energy, its energy and contact force integrated by numbers along a wave.
module dg_test_sinusoidal_shape
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_sinusoidal_shape, only: sinusoidal_contact, sinusoidal_swing, sinusoidal_wave
   implicit none
   private
   public :: sinusoidal_shape_suite

   integer, parameter :: places = 400
   real(wp), parameter :: ratio(4) = [1.02_wp, 1.1_wp, 1.25_wp, 1.4_wp]

contains

   function sinusoidal_shape_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('sinusoidal_shape')
      call suite%addTest(TestMethod('least_energy', test_least_energy))
      call suite%addTest(TestMethod('contact', test_contact))
   end function sinusoidal_shape_suite

   !> Mean energy per length of theta = A sin(k x), over n c, or with `force` the mean contact force over n.
   pure function mean_along(b, swing, wave, force) result(mean)
      real(wp), intent(in) :: b, swing, wave
      logical, intent(in) :: force
      real(wp) :: mean
      real(wp) :: t(0:3), x
      integer :: i
      mean = 0.0_wp
      do i = 1, places
         x = 2.0_wp*pi*i/places
         t = swing*[sin(x), wave*cos(x), -wave**2*sin(x), -wave**3*cos(x)]
         if (force) then
            mean = mean + cos(t(0)) + 2.0_wp*b*t(1)**2 - t(1)**4 + 3.0_wp*t(2)**2 + 4.0_wp*t(1)*t(3)
         else
            mean = mean + 0.5_wp*(t(2)**2 + t(1)**4) - b*t(1)**2 + 1.0_wp - cos(t(0))
         end if
      end do
      mean = mean/places
   end function mean_along

   !> Error of A and k: the energy's slope by differences over its curvature. The swing leaves out terms in A^6.
   subroutine test_least_energy()
      real(wp), parameter :: step = 1.0e-3_wp
      real(wp) :: a, k, energy(-1:1)
      integer :: i, j
      do i = 1, size(ratio)
         a = sinusoidal_swing(ratio(i))
         k = sinusoidal_wave(a)
         do j = -1, 1
            energy(j) = mean_along(ratio(i), a, k + j*step, force=.false.)
         end do
         call assertEqual(0.0_wp, 0.5_wp*step*(energy(1) - energy(-1))/(energy(1) - 2.0_wp*energy(0) + energy(-1)), 2.0e-3_wp, &
                          message='wave number')
         do j = -1, 1
            energy(j) = mean_along(ratio(i), a + j*step, k, force=.false.)
         end do
         call assertEqual(0.0_wp, 0.5_wp*step*(energy(1) - energy(-1))/(energy(1) - 2.0_wp*energy(0) + energy(-1)), 0.01_wp*a, &
                          message='swing')
      end do
      call assertEqual(0.0_wp, sinusoidal_swing(0.9_wp), 1.0e-12_wp, message='below the onset')
   end subroutine test_least_energy

   !> The mean of the force along the wave is the closed form, with the b that belongs to the swing.
   subroutine test_contact()
      real(wp) :: a, k
      integer :: i
      do i = 1, size(ratio)
         a = sinusoidal_swing(ratio(i))
         k = sinusoidal_wave(a)
         call assertEqual(mean_along(k**2*(1.0_wp + 0.75_wp*a**2), a, k, force=.true.), sinusoidal_contact(a), 1.0e-12_wp, &
                          message='contact')
      end do
      call assertEqual(1.0_wp, sinusoidal_contact(0.0_wp), 1.0e-15_wp, message='lying')
   end subroutine test_contact
end module dg_test_sinusoidal_shape

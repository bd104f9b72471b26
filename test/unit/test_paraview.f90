!> Where the string is drawn in space, and how finely the hole.
module dg_test_paraview
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_constants, only: degree, pi
   use dg_kinds, only: wp
   use dg_paraview_file, only: string_offsets, tube_rows
   use dg_profile, only: new_profile, profile_type, side_above, side_below
   implicit none
   private
   public :: paraview_suite

   real(wp), parameter :: rounding = 1.0e-15_wp

contains

   function paraview_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('paraview')
      call suite%addTest(TestMethod('offsets', test_offsets))
      call suite%addTest(TestMethod('rings_where_needed', test_rings))
   end function paraview_suite

   !> Vertical: the clock counts from north over east. Horizontal to the north: 180 deg is down, 90 deg to the east. At 30 deg
   !> to the east: the high side is up by sin(30) and to the east by cos(30).
   subroutine test_offsets()
      type(profile_type) :: profile
      real(wp) :: offset(3, 4)
      profile = new_profile(4)
      profile%displacement = 0.02_wp
      profile%inclination = [0.0_wp, 90.0_wp, 90.0_wp, 30.0_wp]*degree
      profile%azimuth = [0.0_wp, 0.0_wp, 0.0_wp, 90.0_wp]*degree
      profile%clock = [0.5_wp*pi, pi, 0.5_wp*pi, 0.0_wp]
      offset = string_offsets(profile)
      call assertEqual([0.0_wp, 0.02_wp, 0.0_wp], offset(:, 1), rounding, message='vertical')
      call assertEqual([0.0_wp, 0.0_wp, 0.02_wp], offset(:, 2), rounding, message='low side')
      call assertEqual([0.0_wp, 0.02_wp, 0.0_wp], offset(:, 3), rounding, message='right')
      call assertEqual(0.02_wp*[0.0_wp, cos(30.0_wp*degree), -sin(30.0_wp*degree)], offset(:, 4), rounding, message='high side')
   end subroutine test_offsets

   !> Straight: the ends alone. A wider hole: a ring on either side of the step. A bend: rings at both ends of what turns.
   !> Two rows at a depth: two rings where the hole is wider, one where the string alone changes.
   subroutine test_rings()
      type(profile_type) :: profile
      integer, allocatable :: rows(:)
      profile = new_profile(6)
      allocate (rows, source=tube_rows(profile, spread(0.2_wp, 1, 6)))
      call assertEqual([1, 6], rows)
      deallocate (rows)
      allocate (rows, source=tube_rows(profile, [0.3_wp, 0.3_wp, 0.3_wp, 0.2_wp, 0.2_wp, 0.2_wp]))
      call assertEqual([1, 3, 4, 6], rows)
      profile%inclination = [0.0_wp, 0.0_wp, 0.0_wp, 5.0_wp, 5.0_wp, 5.0_wp]*degree
      deallocate (rows)
      allocate (rows, source=tube_rows(profile, spread(0.2_wp, 1, 6)))
      call assertEqual([1, 3, 4, 6], rows)
      profile%side(3:4) = [side_above, side_below]
      profile%inclination = [0.0_wp, 0.0_wp, 5.0_wp, 5.0_wp, 10.0_wp, 10.0_wp]*degree
      deallocate (rows)
      allocate (rows, source=tube_rows(profile, spread(0.2_wp, 1, 6)))
      call assertEqual([1, 2, 3, 5, 6], rows)
      deallocate (rows)
      allocate (rows, source=tube_rows(profile, [0.3_wp, 0.3_wp, 0.3_wp, 0.2_wp, 0.2_wp, 0.2_wp]))
      call assertEqual([1, 2, 3, 4, 5, 6], rows)
   end subroutine test_rings
end module dg_test_paraview

!> Another program's results beside ours: kinds of hole, where a difference arises, what is left out.
module dg_test_legacy
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_hole_interval, only: hole_intervals, interval_at, interval_build, interval_drop, interval_hold, interval_turn, &
      interval_type, interval_vertical
   use dg_kinds, only: wp
   use dg_legacy_comparison, only: comparison_type, compare_with_legacy, legacy_table_type, quantity_axial, &
                                   quantity_side_force, quantity_torque
   use dg_legacy_file, only: unit_value
   use dg_profile, only: new_profile, profile_type, side_above, side_below
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory, trajectory_type
   implicit none
   private
   public :: legacy_suite

   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   function legacy_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('legacy')
      call suite%addTest(TestMethod('kinds_of_hole', test_kinds))
      call suite%addTest(TestMethod('difference_located', test_located))
      call suite%addTest(TestMethod('agreement_and_rows_outside', test_agreement))
      call suite%addTest(TestMethod('units', test_units))
   end function legacy_suite

   subroutine s_well(trajectory)
      type(trajectory_type), intent(out) :: trajectory
      type(error_type), allocatable :: error
      call new_trajectory(trajectory, [0.0_wp, 500.0_wp, 1000.0_wp, 1500.0_wp, 1800.0_wp, 2000.0_wp, 2500.0_wp], &
                          [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp, 40.0_wp, 20.0_wp, 20.0_wp]*degree, &
                          [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 30.0_wp, 30.0_wp, 30.0_wp]*degree, &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
   end subroutine s_well

   subroutine test_kinds()
      type(trajectory_type) :: trajectory
      type(interval_type), allocatable :: intervals(:)
      call s_well(trajectory)
      allocate (intervals, source=hole_intervals(trajectory, 2400.0_wp))
      call assertEqual([interval_vertical, interval_build, interval_hold, interval_turn, interval_drop, interval_hold], &
                       intervals%kind)
      call assertEqual([0.0_wp, 500.0_wp, 1000.0_wp, 1500.0_wp, 1800.0_wp, 2000.0_wp], intervals%md_top, round_off)
      call assertEqual(2400.0_wp, intervals(6)%md_bottom, message='ends at the bit')
      call assertEqual(2, interval_at(intervals, 500.0_wp), message='at a joint the lower one')
      call assertEqual(1, interval_at(intervals, -1.0_wp), message='above all')
   end subroutine test_kinds

   !> Ours is zero but for a scale; theirs grows by 10 over the drop and stays: made there, seen all the way up.
   subroutine test_located()
      type(trajectory_type) :: trajectory
      type(legacy_table_type) :: table
      type(profile_type) :: profile
      type(comparison_type) :: comparison
      integer :: i
      call s_well(trajectory)
      profile = new_profile(26)
      profile%md = [(100.0_wp*real(i, wp), i=0, 25)]
      profile%axial = 2500.0_wp - profile%md
      profile%side_force = 1.0_wp
      table%md = profile%md
      table%has = .true.
      allocate (table%values(26, 3))
      table%values(:, 1) = profile%axial + min(10.0_wp, max(0.0_wp, 10.0_wp*(2000.0_wp - table%md)/200.0_wp))
      table%values(:, 2) = merge(-4.0_wp, 0.0_wp, table%md <= 1400.0_wp)
      table%values(:, 3) = profile%side_force + merge(0.5_wp, 0.0_wp, table%md > 550.0_wp .and. table%md < 950.0_wp)
      call compare_with_legacy(table, profile, trajectory, comparison)
      associate (axial => comparison%parting(quantity_axial))
         call assertFalse(axial%agrees)
         call assertEqual(interval_drop, comparison%intervals(axial%worst)%kind, message='made in the drop')
         call assertRelativelyEqual(1.0_wp, axial%share, round_off, message='and nowhere else')
         call assertEqual(10.0_wp, axial%largest, round_off, message='largest')
         call assertEqual(2000.0_wp, axial%parting_md, round_off, message='last depth of agreement')
         call assertEqual((19.0_wp*10.0_wp + 5.0_wp)/26.0_wp, axial%mean, round_off, message='mean')
      end associate
      associate (torque => comparison%parting(quantity_torque))
         call assertEqual(interval_hold, comparison%intervals(torque%worst)%kind, message='torque made in the hold')
         call assertEqual(-4.0_wp, torque%largest, round_off, message='torque, sign')
         call assertEqual(1500.0_wp, torque%parting_md, round_off, message='torque, where')
      end associate
      associate (side => comparison%parting(quantity_side_force))
         call assertEqual(interval_build, comparison%intervals(side%worst)%kind, message='side force in the build')
         call assertEqual(200.0_wp, side%growth(side%worst), round_off, message='its integral')
      end associate
      ! as much apart at the bit: another weight on bit, of which no section is the cause
      table%values(:, 1) = profile%axial + 100.0_wp
      call compare_with_legacy(table, profile, trajectory, comparison)
      associate (axial => comparison%parting(quantity_axial))
         call assertEqual(0, axial%worst, message='there at the lowest depth')
         call assertEqual(1.0_wp, axial%share, round_off, message='all of it')
         call assertEqual(100.0_wp, axial%at_bottom, round_off, message='so much')
      end associate
   end subroutine test_located

   subroutine test_agreement()
      type(trajectory_type) :: trajectory
      type(legacy_table_type) :: table
      type(profile_type) :: profile
      type(comparison_type) :: comparison
      integer :: i
      call s_well(trajectory)
      profile = new_profile(2)
      profile%md = [0.0_wp, 2000.0_wp]
      profile%axial = [1000.0_wp, 0.0_wp]
      table%md = [500.0_wp, 1000.0_wp, 2100.0_wp]
      table%has = [.true., .false., .false.]
      allocate (table%values(3, 3), source=0.0_wp)
      table%values(:, 1) = [750.1_wp, 500.0_wp, 7.0_wp]
      call compare_with_legacy(table, profile, trajectory, comparison)
      call assertEqual(1, comparison%outside, message='below the bit')
      call assertEqual([750.0_wp, 500.0_wp], comparison%ours(:, 1), round_off, message='interpolated')
      call assertTrue(comparison%parting(quantity_axial)%agrees, message='0.1 of 750')
      call assertFalse(comparison%parting(quantity_torque)%present)
      ! where something changes ours of the lower side is compared, to round-off of depths
      profile = new_profile(4)
      profile%md = [0.0_wp, 1000.0_wp, 1000.0_wp, 2000.0_wp]
      profile%side(2:3) = [side_above, side_below]
      profile%axial = [1000.0_wp, 500.0_wp, 200.0_wp, 0.0_wp]
      do i = -1, 1
         table%md = [500.0_wp, 1000.0_wp + i*1.0e-9_wp, 2100.0_wp]
         call compare_with_legacy(table, profile, trajectory, comparison)
         call assertEqual([750.0_wp, 200.0_wp], comparison%ours(:, 1), round_off, message='lower side')
      end do
      table%md = table%md + 5000.0_wp
      call compare_with_legacy(table, profile, trajectory, comparison)
      call assertEqual(3, comparison%outside, message='all outside')
      call assertEqual(0, size(comparison%md))
   end subroutine test_agreement

   !> NIST: lbf 4.4482216152605 N, ft 0.3048 m.
   subroutine test_units()
      call assertRelativelyEqual(0.3048_wp, unit_value(1, 'ft'), round_off)
      call assertRelativelyEqual(4.4482216152605_wp, unit_value(2, 'lbf'), round_off)
      call assertRelativelyEqual(1.0_wp, unit_value(2, 'N'), round_off)
      call assertRelativelyEqual(1355.8179483314004_wp, unit_value(3, 'kft.lbf'), round_off)
      call assertRelativelyEqual(14.593902937206364_wp, unit_value(4, 'lbf/ft'), round_off)
      call assertEqual(0.0_wp, unit_value(2, 'ft'), message='no unit of force')
   end subroutine test_units
end module dg_test_legacy

!> Curves along the string on the page: peaks that stay, side force on a joint, long curves.
module dg_test_page_curves
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, new_along_string
   use dg_case_result, only: case_result_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_page_curves, only: accuracy_type, curve_series, profile_curves, share_type
   use dg_page_thinning, only: finest, kept_values, thin_curve, thinned_type
   use dg_profile, only: new_profile, profile_type
   use dg_series, only: series_list_type
   use dg_test_report_sample, only: sample_results
   use dg_text, only: text_type
   use dg_units, only: si_units
   implicit none
   private
   public :: page_curves_suite

   integer, parameter :: n = 200

contains

   function page_curves_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('page_curves')
      call suite%addTest(TestMethod('peaks', test_peaks))
      call suite%addTest(TestMethod('side_force_on_joint', test_joint))
      call suite%addTest(TestMethod('longest_curve', test_longest))
   end function page_curves_suite

   pure function depths() result(md)
      real(wp) :: md(n)
      integer :: i
      md = [(real(i, wp), i=1, n)]
   end function depths

   !> Largest and least value stay exact where the tolerance is greater than their height.
   subroutine test_peaks()
      type(thinned_type) :: curve
      real(wp) :: values(n), found(n), points(n)
      logical :: kept(n)
      integer :: i, above, below
      values = sin(0.05_wp*depths())
      values(77) = 1.01_wp
      values(10) = missing
      kept = kept_values(depths(), values, 0.5_wp)
      call assertTrue(kept(77) .and. kept(minloc(values, dim=1, mask=.not. is_missing(values))))
      call assertTrue(count(kept) < 20, message='few')
      values(10) = 0.5_wp
      curve%name = 'axial'
      curve%values = values
      call thin_curve(curve, depths(), 1.0_wp, 0.1_wp)
      ! as curves.js reads them
      points = (curve%scale%first + nint(values/curve%scale%step - curve%scale%first))*curve%scale%step
      do i = 1, n
         above = findloc(curve%kept(:i), .true., dim=1, back=.true.)
         below = i - 1 + findloc(curve%kept(i:), .true., dim=1)
         found(i) = points(above)
         if (below > above) found(i) = found(i) + real(i - above, wp)/real(below - above, wp)*(points(below) - points(above))
      end do
      call assertEqual(1.01_wp, maxval(found), 1.0e-12_wp)
      call assertTrue(all(abs(found - values) <= curve%band*1.001_wp), message='others')
   end subroutine test_peaks

   !> Side force on a joint is that on the length of this string's joints: half the length at double the load gives the same curve.
   subroutine test_joint()
      type(case_result_type), allocatable :: results(:)
      type(along_string_type) :: along
      type(series_list_type) :: list
      type(text_type), allocatable :: texts(:), again(:)
      type(text_type) :: rows
      type(accuracy_type), allocatable :: accuracy(:)
      allocate (results, source=sample_results())
      along = new_along_string(2)
      along%pipe_joint = 10.0_wp
      results(1)%profile%md = [0.0_wp, 2.0e4_wp]
      results(1)%profile%side_force = [100.0_wp, 300.0_wp]
      list = curve_series(results(1)%profile, along)
      associate (joint => list%count)
         allocate (texts(joint), again(joint), accuracy(joint))
         call profile_curves(results(1)%profile, along, si_units(), share_type(), texts, accuracy, rows)
         along%pipe_joint = 5.0_wp
         call profile_curves(results(1)%profile, along, si_units(), share_type(), again, accuracy, rows)
         call assertTrue(again(joint)%text /= texts(joint)%text, message='half the length, half the force')
         results(1)%profile%side_force = [200.0_wp, 600.0_wp]
         call profile_curves(results(1)%profile, along, si_units(), share_type(), again, accuracy, rows)
         call assertEqual(texts(joint)%text, again(joint)%text)
      end associate
   end subroutine test_joint

   !> Where room is short the curve that oscillates is thinned more and says how far it is off. The smooth one keeps the finest
   !> tolerance.
   subroutine test_longest()
      type(profile_type) :: profile
      type(along_string_type) :: along
      type(series_list_type) :: list
      type(text_type), allocatable :: texts(:)
      type(text_type) :: rows
      type(accuracy_type), allocatable :: accuracy(:)
      integer :: i, axial, bending
      profile = new_profile(n)
      along = new_along_string(n)
      profile%md = depths()
      profile%axial = 1.0e3_wp*depths()
      profile%bending = 1.0e3_wp*sin(0.7_wp*depths())
      list = curve_series(profile, along)
      do i = 1, list%count
         if (list%items(i)%column%name == 'axial') axial = i
         if (list%items(i)%column%name == 'bending') bending = i
      end do
      allocate (texts(list%count), accuracy(list%count))
      call profile_curves(profile, along, si_units(), share_type(letters=100.0_wp), texts, accuracy, rows)
      call assertTrue(accuracy(axial)%within <= finest)
      call assertTrue(accuracy(bending)%within > finest .and. accuracy(bending)%band > finest*2.0_wp)
   end subroutine test_longest
end module dg_test_page_curves

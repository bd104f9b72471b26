!> Curves along the string on the page: peaks that stay, values between points, curves that are written by others.
module dg_test_page_curves
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, new_along_string
   use dg_case_result, only: case_result_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_page_curves, only: accuracy_type, curve_series, profile_curves, share_type
   use dg_page_relations, only: part_for_others, rows_for_others, write_by_first, write_by_others, written_type
   use dg_page_thinning, only: finest, kept_values, line_at, read_at, thin_curve, thinned_type
   use dg_profile, only: new_profile, profile_type
   use dg_series, only: series_list_type
   use dg_test_report_sample, only: sample_results
   use dg_text, only: text_type
   use dg_units, only: si_units
   implicit none
   private
   public :: page_curves_suite

   integer, parameter :: n = 200, starts(2) = [1, 101]

contains

   function page_curves_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('page_curves')
      call suite%addTest(TestMethod('peaks', test_peaks))
      call suite%addTest(TestMethod('between_points', test_between))
      call suite%addTest(TestMethod('by_parts', test_parts))
      call suite%addTest(TestMethod('by_two', test_two))
      call suite%addTest(TestMethod('by_first', test_first))
      call suite%addTest(TestMethod('side_force_on_joint', test_joint))
      call suite%addTest(TestMethod('longest_curve', test_longest))
   end function page_curves_suite

   pure function depths() result(md)
      real(wp) :: md(n)
      integer :: i
      md = [(real(i, wp), i=1, n)]
   end function depths

   !> A curve of 200 rows that is thinned and read.
   pure function thinned(name, values, within) result(curve)
      character(*), intent(in) :: name
      real(wp), intent(in) :: values(:), within
      type(thinned_type) :: curve
      curve%name = name
      curve%values = values
      call thin_curve(curve, depths(), [starts, starts(2) - 1], 1.0_wp, within)
      curve%own = .true.
      curve%read = read_at(curve, depths(), depths())
   end function thinned

   !> Largest and least value stay exact where the tolerance is greater than their height.
   subroutine test_peaks()
      type(thinned_type) :: curve
      real(wp) :: values(n)
      logical :: kept(n)
      values = sin(0.05_wp*depths())
      values(77) = 1.01_wp
      values(10) = missing
      kept = kept_values(depths(), values, 0.5_wp, [integer ::])
      call assertTrue(kept(77) .and. kept(minloc(values, dim=1, mask=.not. is_missing(values))))
      call assertTrue(count(kept) < 20, message='few')
      values(10) = 0.5_wp
      curve = thinned('axial', values, 0.1_wp)
      call assertEqual(1.01_wp, maxval(curve%read), 1.0e-12_wp)
      call assertTrue(all(abs(curve%read - values) <= curve%band*1.001_wp), message='others')
   end subroutine test_peaks

   !> Two rows at one depth are a jump, the upper side first. There is no value between a row and one without value.
   subroutine test_between()
      real(wp) :: values(6)
      values = line_at([1.0_wp, 2.0_wp, 2.0_wp, 4.0_wp], [0.0_wp, 1.0_wp, 5.0_wp, missing], &
                       [1.0_wp, 1.5_wp, 2.0_wp, 2.0_wp, 3.0_wp, 4.0_wp])
      call assertEqual([0.0_wp, 0.5_wp, 1.0_wp, 5.0_wp], values(:4), 1.0e-12_wp)
      call assertTrue(all(is_missing(values(5:))))
   end subroutine test_between

   !> Side force on a joint is that on the length of this string's joints: half the length at double the load gives the same curve.
   subroutine test_joint()
      type(case_result_type), allocatable :: results(:)
      type(along_string_type) :: along
      type(series_list_type) :: list
      type(written_type) :: first
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
         call profile_curves(results(1)%profile, along, si_units(), share_type(), first, texts, accuracy, rows)
         along%pipe_joint = 5.0_wp
         call profile_curves(results(1)%profile, along, si_units(), share_type(), first, again, accuracy, rows)
         call assertTrue(again(joint)%text /= texts(joint)%text, message='half the length, half the force')
         results(1)%profile%side_force = [200.0_wp, 600.0_wp]
         call profile_curves(results(1)%profile, along, si_units(), share_type(), first, again, accuracy, rows)
         call assertEqual(texts(joint)%text, again(joint)%text)
      end associate
   end subroutine test_joint

   !> Where room is short the curve that oscillates is thinned more and says how far it is off. The smooth one keeps the finest
   !> tolerance.
   subroutine test_longest()
      type(profile_type) :: profile
      type(along_string_type) :: along
      type(series_list_type) :: list
      type(written_type) :: first
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
      call profile_curves(profile, along, si_units(), share_type(letters=100.0_wp), first, texts, accuracy, rows)
      call assertTrue(accuracy(axial)%within <= finest)
      call assertTrue(accuracy(bending)%within > finest .and. accuracy(bending)%band > finest*2.0_wp)
   end subroutine test_longest

   !> A stress is written by its moment: its peaks, then points, factor and addend of each component. The moment is close enough for
   !> it. One that does not go with the moment stays alone.
   subroutine test_parts()
      type(thinned_type) :: curves(2)
      character(:), allocatable :: text
      real(wp) :: moment(n), stress(n), within
      moment = 2.0_wp + sin(depths())
      stress = 10.0_wp*moment
      stress(101:) = 30.0_wp*moment(101:)
      curves(1)%name = 'bending'
      curves(1)%values = moment
      curves(2) = thinned('bending_stress', stress, finest)
      curves(2)%own = .false.
      call assertTrue(any(rows_for_others(curves, 1, starts) == maxloc(stress, dim=1)), message='its peak is kept')
      curves(1) = thinned('bending', moment, finest*part_for_others(curves, 1, starts))
      text = ''
      within = finest
      call write_by_others(curves, 2, depths(), starts, .false., text, within)
      call assertEqual('["bending",', text(:11))
      call assertTrue(index(text, ',100,10,') > 0 .and. index(text, ',100,30,') > 0, message=text)
      call assertTrue(all(abs(curves(2)%read - stress) <= curves(2)%band))
      call assertEqual(maxval(stress), maxval(curves(2)%read), 1.0e-12_wp)
      stress(50) = 31.0_wp
      curves(2) = thinned('bending_stress', stress, finest)
      text = ''
      call write_by_others(curves, 2, depths(), starts, .false., text, within)
      call assertEqual('', text, message='one value beside')
   end subroutine test_parts

   !> A margin is the sum of two curves, with its least and its largest value. Where these are coarse it says how far it is off.
   subroutine test_two()
      type(thinned_type) :: curves(3)
      character(:), allocatable :: text
      real(wp) :: margin(n), within
      curves(1) = thinned('axial', -depths(), 0.01_wp)
      curves(2) = thinned('sinusoidal_load', 300.0_wp + 50.0_wp*sin(0.7_wp*depths()), 0.01_wp)
      margin = curves(1)%values + curves(2)%values
      curves(3) = thinned('buckling_margin', margin, 0.003_wp)
      curves(3)%own = .false.
      text = ''
      within = 0.003_wp
      call write_by_others(curves, 3, depths(), starts, .false., text, within)
      call assertEqual('', text, message='not close enough')
      call write_by_others(curves, 3, depths(), starts, .true., text, within)
      call assertEqual('["axial","sinusoidal_load",', text(:27))
      call assertTrue(within > 0.003_wp .and. within <= 0.009_wp)
      call assertEqual([minval(margin), maxval(margin)], [minval(curves(3)%read), maxval(curves(3)%read)], 1.0e-9_wp)
      call assertTrue(all(abs(curves(3)%read - margin) <= curves(3)%band*1.001_wp))
   end subroutine test_two

   !> A curve of the hole is that of the profile that is written first; one with another peak is not.
   subroutine test_first()
      type(thinned_type) :: curve
      type(written_type) :: first
      character(:), allocatable :: text
      real(wp) :: values(n), within
      values = sin(0.05_wp*depths())
      first%md = depths()
      first%curves = [thinned('dogleg', values, finest)]
      first%place = 4
      curve = thinned('dogleg', values, finest)
      first%curves(1)%band = 3.0_wp*curve%band
      first%curves(1)%within = 3.0_wp*finest
      within = finest
      text = ''
      call write_by_first(first, curve, depths(), text, within)
      call assertEqual('4', text)
      call assertTrue(abs(within - 3.0_wp*finest) < 1.0e-9_wp, message='as exact as the first one')
      first%curves(1)%values(7) = 2.0_wp
      text = ''
      call write_by_first(first, curve, depths(), text, within)
      call assertEqual('', text)
   end subroutine test_first
end module dg_test_page_curves

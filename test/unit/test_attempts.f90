!> Settings of the attempts at a case.
module dg_test_attempts
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_numerics, only: gap_at_extremum, gap_at_nodes, numerics_type, settings_of_attempt
   implicit none
   private
   public :: attempts_suite

contains

   function attempts_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('attempts')
      call suite%addTest(TestMethod('longer_by_max_iterations', test_longer))
      call suite%addTest(TestMethod('what_differs', test_what_differs))
   end function attempts_suite

   !> With twice the usual max_iterations an attempt may be, and stall, twice as long. With half of it none is shorter.
   subroutine test_longer()
      type(numerics_type) :: usual, twice, half, settings
      integer :: i
      twice%max_iterations = 2*usual%max_iterations
      half%max_iterations = usual%max_iterations/2
      do i = 1, size(usual%tuning%attempt)
         settings = settings_of_attempt(twice, i, .false.)
         call assertEqual(2*usual%tuning%attempt(i)%longest, settings%max_iterations)
         call assertEqual(2*usual%tuning%longest_stall, settings%tuning%longest_stall)
         settings = settings_of_attempt(half, i, .false.)
         call assertEqual(usual%tuning%attempt(i)%longest, settings%max_iterations)
         call assertEqual(usual%tuning%longest_stall, settings%tuning%longest_stall)
      end do
      settings = settings_of_attempt(twice, 1, .true.)
      call assertEqual(2*usual%tuning%coiled_longest, settings%max_iterations, message='a string in helical buckling')
   end subroutine test_longer

   !> The third attempt has its gaps at the other place, the fourth takes longer steps.
   subroutine test_what_differs()
      type(numerics_type) :: usual, settings
      settings = settings_of_attempt(usual, 3, .false.)
      call assertEqual(gap_at_extremum, usual%gap_location)
      call assertEqual(gap_at_nodes, settings%gap_location)
      settings = settings_of_attempt(usual, 4, .false.)
      call assertEqual(gap_at_extremum, settings%gap_location)
      call assertTrue(settings%step_limit > usual%step_limit)
      call assertEqual(usual%tuning%attempt(4)%reach, settings%step_limit/usual%step_limit, tolerance=1.0e-12_wp)
   end subroutine test_what_differs
end module dg_test_attempts

!> The asserts themselves: each must raise where it should, or no other test means anything.
module dg_test_asserts
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64
   use funit, only: anyExceptions, assertAll, assertAny, assertEqual, assertExceptionRaised, assertFail, assertFalse, &
      assertGreaterThan, assertGreaterThanOrEqual, assertIsFinite, assertIsNaN, assertLessThan, assertLessThanOrEqual, &
      assertNotEqual, assertRelativelyEqual, assertTrue, catch, SourceLocation, TestMethod, TestSuite, throw
   use dg_kinds, only: wp
   implicit none
   private
   public :: asserts_suite

contains

   function asserts_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('asserts')
      call suite%addTest(TestMethod('hold', test_hold))
      call suite%addTest(TestMethod('raise', test_raise))
      call suite%addTest(TestMethod('raise_on_arrays', test_raise_on_arrays))
      call suite%addTest(TestMethod('nan_equals_nothing', test_nan_equals_nothing))
      call suite%addTest(TestMethod('tear_down_runs_last', raise_in_advance, setUp=nothing, tearDown=forget))
      call suite%addTest(TestMethod('suites_nest', test_suites_nest))
   end function asserts_suite

   subroutine test_hold()
      real(wp), parameter :: matrix(2, 2) = reshape([1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp], [2, 2])
      call assertEqual(1.0_wp, 1.0_wp)
      call assertEqual(1, 1.0_wp)
      call assertEqual(1.0, 1.0)
      call assertEqual(1.0_wp, 1.0_wp + 1.0e-9_wp, 1.0e-8_wp)
      call assertEqual(2.0_wp, [2.0_wp, 2.0_wp])
      call assertEqual([1.0_wp, 2.0_wp], [1.0_wp, 2.0_wp], message='rank 1')
      call assertEqual(matrix, matrix, 0.0_wp, location=SourceLocation('here', 1))
      call assertEqual([1, 2], [1, 2])
      call assertEqual(1, 1_int64)
      call assertEqual('a', 'a  ')
      call assertEqual(.true., .true.)
      call assertRelativelyEqual(1.0e6_wp, 1.0e6_wp + 1.0_wp, 1.1e-6_wp)
      call assertNotEqual(1.0_wp, 2.0_wp)
      call assertNotEqual(1, 2)
      call assertLessThan(1.0_wp, 2.0_wp)
      call assertLessThanOrEqual(2.0_wp, 2.0_wp)
      call assertGreaterThan(2, 1)
      call assertGreaterThanOrEqual(2, 2)
      call assertTrue([.true., .true.])
      call assertFalse(.false.)
      call assertAny([.true., .false.])
      call assertIsFinite(1.0_wp)
   end subroutine test_hold

   subroutine test_raise()
      call assertEqual(1.0_wp, 1.1_wp, 0.01_wp)
      call raised('real')
      call assertEqual(1, 2)
      call raised('integer')
      call assertEqual('a', 'b')
      call raised('string')
      call assertEqual(.true., .false.)
      call raised('logical')
      call assertRelativelyEqual(1.0_wp, 1.1_wp, 0.01_wp)
      call raised('relative')
      call assertRelativelyEqual(0.0_wp, 0.0_wp, 1.0_wp)
      call raised('relative to zero')
      call assertNotEqual(1.0_wp, 1.0_wp)
      call raised('not equal')
      call assertLessThan(2.0_wp, 2.0_wp)
      call raised('less')
      call assertLessThanOrEqual(3, 2)
      call raised('less or equal')
      call assertGreaterThan(2.0_wp, 2.0_wp)
      call raised('greater')
      call assertGreaterThanOrEqual(1.0_wp, 2.0_wp)
      call raised('greater or equal')
      call assertTrue(.false.)
      call raised('true')
      call assertFalse(.true.)
      call raised('false')
      call assertAll([.true., .false.])
      call raised('all')
      call assertAny([.false., .false.])
      call raised('any')
      call assertIsNaN(1.0_wp)
      call raised('NaN')
      call assertFail('on purpose')
      call assertExceptionRaised('on purpose')
   end subroutine test_raise

   subroutine test_raise_on_arrays()
      call assertEqual([1.0_wp, 2.0_wp], [1.0_wp, 2.5_wp], 0.1_wp)
      call raised('element')
      call assertEqual([1.0_wp, 2.0_wp], [1.0_wp, 2.0_wp, 3.0_wp])
      call raised('shape')
      call assertEqual(1.0_wp, reshape([1.0_wp, 1.0_wp, 1.0_wp, 2.0_wp], [2, 2]))
      call raised('rank 2')
      call assertEqual([1, 2], [1, 3])
      call raised('integers')
   end subroutine test_raise_on_arrays

   subroutine test_nan_equals_nothing()
      real(wp) :: nan
      nan = ieee_value(1.0_wp, ieee_quiet_nan)
      call assertIsNaN(nan)
      call assertEqual(nan, nan, 1.0_wp)
      call raised('NaN with NaN')
      call assertEqual(1.0_wp, nan, 1.0_wp)
      call raised('one with NaN')
      call assertIsFinite(nan)
      call raised('finite')
   end subroutine test_nan_equals_nothing

   subroutine raise_in_advance()
      call throw('in advance')
   end subroutine raise_in_advance

   !> Runs after the test that raises; without it that test fails.
   subroutine forget()
      call assertTrue(catch('in advance'), message='tearDown runs after the test')
   end subroutine forget

   subroutine nothing()
   end subroutine nothing

   subroutine test_suites_nest()
      type(TestSuite) :: inner, outer
      inner = TestSuite('inner')
      outer = TestSuite('outer')
      call inner%addTest(TestMethod('a', nothing))
      call inner%addTest(TestMethod('b', nothing))
      call outer%addTest(inner)
      call outer%addTest(TestMethod('c', nothing))
      call assertEqual(3, outer%countTestCases())
      call assertEqual('outer', outer%getName())
   end subroutine test_suites_nest

   !> The assert before has raised exactly once; forgets it.
   subroutine raised(what)
      character(*), intent(in) :: what
      logical :: found
      found = catch()
      if (.not. found) then
         call assertFail('did not raise: '//what)
         return
      end if
      if (anyExceptions()) call assertFail('raised twice or before: '//what)
   end subroutine raised
end module dg_test_asserts

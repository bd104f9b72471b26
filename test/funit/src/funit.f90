!> The one module that tests use. It offers the part of pFUnit's interface that they need, under the same
!> names and with the same argument order, so that the same sources compile against either.
module funit
   use funit_exception, only: SourceLocation, throw, catch, anyExceptions
   use funit_suite, only: Test, TestMethod, TestSuite
   use funit_runner, only: run
   use funit_assert, only: assertTrue, assertFalse, assertAll, assertAny, assertNone, assertNotAll, assertFail, &
      assertExceptionRaised, assertSameShape
   use funit_assert_real, only: assertEqual, assertNotEqual, assertRelativelyEqual, assertLessThan, &
      assertLessThanOrEqual, assertGreaterThan, assertGreaterThanOrEqual, assertIsFinite, assertIsInfinite, &
      assertIsNaN, assertIsNotNaN
   use funit_assert_discrete, only: assertEqual, assertNotEqual, assertLessThan, assertLessThanOrEqual, &
      assertGreaterThan, assertGreaterThanOrEqual
   implicit none
   private
   public :: SourceLocation, throw, catch, anyExceptions
   public :: Test, TestMethod, TestSuite, run
   public :: assertTrue, assertFalse, assertAll, assertAny, assertNone, assertNotAll, assertFail
   public :: assertExceptionRaised, assertSameShape
   public :: assertEqual, assertNotEqual, assertRelativelyEqual
   public :: assertLessThan, assertLessThanOrEqual, assertGreaterThan, assertGreaterThanOrEqual
   public :: assertIsFinite, assertIsInfinite, assertIsNaN, assertIsNotNaN
end module funit

!> Asserts on conditions, shapes and failures.
module funit_assert
   use funit_exception, only: SourceLocation, throw, catch
   implicit none
   private
   public :: assertTrue, assertFalse, assertAll, assertAny, assertNone, assertNotAll, assertFail
   public :: assertExceptionRaised, assertSameShape

   interface assertTrue
      module procedure assert_true, assert_true_all
   end interface assertTrue

   interface assertFalse
      module procedure assert_false, assert_false_all
   end interface assertFalse

   interface assertExceptionRaised
      module procedure assert_exception_any, assert_exception_message
   end interface assertExceptionRaised

contains

   !> A condition must hold.
   subroutine require(condition, what, message, location)
      logical, intent(in) :: condition
      character(*), intent(in) :: what
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (condition) return
      if (present(message)) then
         call throw(message//': '//what, location)
      else
         call throw(what, location)
      end if
   end subroutine require

   subroutine assert_true(condition, message, location)
      logical, intent(in) :: condition
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(condition, 'not true', message, location)
   end subroutine assert_true

   subroutine assert_true_all(condition, message, location)
      logical, intent(in) :: condition(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(all(condition), 'not all true', message, location)
   end subroutine assert_true_all

   subroutine assert_false(condition, message, location)
      logical, intent(in) :: condition
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(.not. condition, 'not false', message, location)
   end subroutine assert_false

   subroutine assert_false_all(condition, message, location)
      logical, intent(in) :: condition(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(.not. any(condition), 'not all false', message, location)
   end subroutine assert_false_all

   subroutine assertAll(conditions, message, location)
      logical, intent(in) :: conditions(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(all(conditions), 'not all true', message, location)
   end subroutine assertAll

   subroutine assertAny(conditions, message, location)
      logical, intent(in) :: conditions(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(any(conditions), 'none true', message, location)
   end subroutine assertAny

   subroutine assertNone(conditions, message, location)
      logical, intent(in) :: conditions(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(.not. any(conditions), 'some true', message, location)
   end subroutine assertNone

   subroutine assertNotAll(conditions, message, location)
      logical, intent(in) :: conditions(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call require(.not. all(conditions), 'all true', message, location)
   end subroutine assertNotAll

   subroutine assertFail(message, location)
      character(*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location
      call throw(message, location)
   end subroutine assertFail

   subroutine assertSameShape(shapeA, shapeB, message, location)
      integer, intent(in) :: shapeA(:)
      integer, intent(in) :: shapeB(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: same
      same = size(shapeA) == size(shapeB)
      if (same) same = all(shapeA == shapeB)
      call require(same, 'shapes differ', message, location)
   end subroutine assertSameShape

   subroutine assert_exception_any(location)
      type(SourceLocation), intent(in), optional :: location
      call require(catch(), 'no failure was raised', location=location)
   end subroutine assert_exception_any

   subroutine assert_exception_message(message, location)
      character(*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location
      call require(catch(message), 'not raised: '//message, location=location)
   end subroutine assert_exception_message
end module funit_assert

!> Asserts on integers, logicals and strings.
module funit_assert_discrete
   use, intrinsic :: iso_fortran_env, only: int64
   use funit_exception, only: SourceLocation, throw
   use funit_text, only: complaint, position_text, text_of
   implicit none
   private
   public :: assertEqual, assertNotEqual
   public :: assertLessThan, assertLessThanOrEqual, assertGreaterThan, assertGreaterThanOrEqual

   interface assertEqual
      module procedure equal_integer_0_0, equal_integer_0_1, equal_integer_1_1, equal_integer_0_2, &
         equal_integer_2_2, equal_long_0_0, equal_long_0_1, equal_long_1_1, equal_long_0_2, &
         equal_long_2_2, equal_mixed_0_0, equal_mixed_0_1, equal_mixed_1_1, equal_mixed_0_2, &
         equal_mixed_2_2, equal_logical_0_0, equal_logical_0_1, equal_logical_1_1, equal_string
   end interface assertEqual

   interface assertNotEqual
      module procedure not_equal_integer
   end interface assertNotEqual

   interface assertLessThan
      module procedure less_integer
   end interface assertLessThan

   interface assertLessThanOrEqual
      module procedure less_or_equal_integer
   end interface assertLessThanOrEqual

   interface assertGreaterThan
      module procedure greater_integer
   end interface assertGreaterThan

   interface assertGreaterThanOrEqual
      module procedure greater_or_equal_integer
   end interface assertGreaterThanOrEqual

contains

   subroutine check_equal(expected, actual, expected_shape, actual_shape, message, location)
      integer(int64), intent(in) :: expected(:)
      integer(int64), intent(in) :: actual(:)
      integer, intent(in) :: expected_shape(:)
      integer, intent(in) :: actual_shape(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      integer(int64) :: wanted
      integer :: k
      if (.not. conforming(expected_shape, actual_shape, message, location)) return
      do k = 1, size(actual)
         wanted = expected(min(k, size(expected)))
         if (wanted /= actual(k)) call throw(complaint(text_of(wanted), text_of(actual(k)), text_of(actual(k) - wanted), &
                                                       position_text(k, actual_shape), message), location)
      end do
   end subroutine check_equal

   subroutine check_logical(expected, actual, expected_shape, actual_shape, message, location)
      logical, intent(in) :: expected(:)
      logical, intent(in) :: actual(:)
      integer, intent(in) :: expected_shape(:)
      integer, intent(in) :: actual_shape(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: wanted
      integer :: k
      if (.not. conforming(expected_shape, actual_shape, message, location)) return
      do k = 1, size(actual)
         wanted = expected(min(k, size(expected)))
         if (wanted .neqv. actual(k)) call throw(complaint(text_of(wanted), text_of(actual(k)), '', &
                                                           position_text(k, actual_shape), message), location)
      end do
   end subroutine check_logical

   !> A scalar conforms with everything.
   logical function conforming(expected_shape, actual_shape, message, location)
      integer, intent(in) :: expected_shape(:)
      integer, intent(in) :: actual_shape(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      conforming = size(expected_shape) == 0
      if (size(expected_shape) == size(actual_shape)) conforming = all(expected_shape == actual_shape)
      if (.not. conforming) call throw(complaint('equal shapes', 'different shapes', '', '', message), location)
   end function conforming

   subroutine equal_integer_0_0(expected, actual, message, location)
      integer, intent(in) :: expected
      integer, intent(in) :: actual
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int([actual], int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_integer_0_0

   subroutine equal_integer_0_1(expected, actual, message, location)
      integer, intent(in) :: expected
      integer, intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int(actual, int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_integer_0_1

   subroutine equal_integer_1_1(expected, actual, message, location)
      integer, intent(in) :: expected(:)
      integer, intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int(expected, int64), int(actual, int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_integer_1_1

   subroutine equal_integer_0_2(expected, actual, message, location)
      integer, intent(in) :: expected
      integer, intent(in) :: actual(:, :)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int(reshape(actual, [size(actual)]), int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_integer_0_2

   subroutine equal_integer_2_2(expected, actual, message, location)
      integer, intent(in) :: expected(:, :)
      integer, intent(in) :: actual(:, :)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int(reshape(expected, [size(expected)]), int64), int(reshape(actual, [size(actual)]), int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_integer_2_2

   subroutine equal_long_0_0(expected, actual, message, location)
      integer(int64), intent(in) :: expected
      integer(int64), intent(in) :: actual
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int([actual], int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_long_0_0

   subroutine equal_long_0_1(expected, actual, message, location)
      integer(int64), intent(in) :: expected
      integer(int64), intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int(actual, int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_long_0_1

   subroutine equal_long_1_1(expected, actual, message, location)
      integer(int64), intent(in) :: expected(:)
      integer(int64), intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int(expected, int64), int(actual, int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_long_1_1

   subroutine equal_long_0_2(expected, actual, message, location)
      integer(int64), intent(in) :: expected
      integer(int64), intent(in) :: actual(:, :)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int(reshape(actual, [size(actual)]), int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_long_0_2

   subroutine equal_long_2_2(expected, actual, message, location)
      integer(int64), intent(in) :: expected(:, :)
      integer(int64), intent(in) :: actual(:, :)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int(reshape(expected, [size(expected)]), int64), int(reshape(actual, [size(actual)]), int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_long_2_2

   subroutine equal_mixed_0_0(expected, actual, message, location)
      integer, intent(in) :: expected
      integer(int64), intent(in) :: actual
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int([actual], int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_mixed_0_0

   subroutine equal_mixed_0_1(expected, actual, message, location)
      integer, intent(in) :: expected
      integer(int64), intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int(actual, int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_mixed_0_1

   subroutine equal_mixed_1_1(expected, actual, message, location)
      integer, intent(in) :: expected(:)
      integer(int64), intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int(expected, int64), int(actual, int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_mixed_1_1

   subroutine equal_mixed_0_2(expected, actual, message, location)
      integer, intent(in) :: expected
      integer(int64), intent(in) :: actual(:, :)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int([expected], int64), int(reshape(actual, [size(actual)]), int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_mixed_0_2

   subroutine equal_mixed_2_2(expected, actual, message, location)
      integer, intent(in) :: expected(:, :)
      integer(int64), intent(in) :: actual(:, :)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(int(reshape(expected, [size(expected)]), int64), int(reshape(actual, [size(actual)]), int64), &
                       shape(expected), shape(actual), message, location)
   end subroutine equal_mixed_2_2

   subroutine equal_logical_0_0(expected, actual, message, location)
      logical, intent(in) :: expected
      logical, intent(in) :: actual
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_logical([expected], [actual], shape(expected), shape(actual), message, location)
   end subroutine equal_logical_0_0

   subroutine equal_logical_0_1(expected, actual, message, location)
      logical, intent(in) :: expected
      logical, intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_logical([expected], actual, shape(expected), shape(actual), message, location)
   end subroutine equal_logical_0_1

   subroutine equal_logical_1_1(expected, actual, message, location)
      logical, intent(in) :: expected(:)
      logical, intent(in) :: actual(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_logical(expected, actual, shape(expected), shape(actual), message, location)
   end subroutine equal_logical_1_1

   !> Trailing blanks do not count, as in Fortran's own comparison.
   subroutine equal_string(expected, found, message, location)
      character(*), intent(in) :: expected
      character(*), intent(in) :: found
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (expected /= found) call throw(complaint(expected, found, '', '', message), location)
   end subroutine equal_string

   subroutine not_equal_integer(lhs, rhs, message, location)
      integer, intent(in) :: lhs
      integer, intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. lhs /= rhs) call throw(complaint(text_of(int(lhs, int64))//' not equal '//text_of(int(rhs, int64)), &
                                               'not so', '', '', message), location)
   end subroutine not_equal_integer

   subroutine less_integer(lhs, rhs, message, location)
      integer, intent(in) :: lhs
      integer, intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. lhs < rhs) call throw(complaint(text_of(int(lhs, int64))//' < '//text_of(int(rhs, int64)), &
                                               'not so', '', '', message), location)
   end subroutine less_integer

   subroutine less_or_equal_integer(lhs, rhs, message, location)
      integer, intent(in) :: lhs
      integer, intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. lhs <= rhs) call throw(complaint(text_of(int(lhs, int64))//' <= '//text_of(int(rhs, int64)), &
                                               'not so', '', '', message), location)
   end subroutine less_or_equal_integer

   subroutine greater_integer(lhs, rhs, message, location)
      integer, intent(in) :: lhs
      integer, intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. lhs > rhs) call throw(complaint(text_of(int(lhs, int64))//' > '//text_of(int(rhs, int64)), &
                                               'not so', '', '', message), location)
   end subroutine greater_integer

   subroutine greater_or_equal_integer(lhs, rhs, message, location)
      integer, intent(in) :: lhs
      integer, intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. lhs >= rhs) call throw(complaint(text_of(int(lhs, int64))//' >= '//text_of(int(rhs, int64)), &
                                               'not so', '', '', message), location)
   end subroutine greater_or_equal_integer
end module funit_assert_discrete

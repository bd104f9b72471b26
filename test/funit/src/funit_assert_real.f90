!> Asserts on reals. `expected` may be a scalar for an array `actual`. Tolerances are absolute, and without
!> one numbers must be the same; NaN equals nothing. NaN is sought out before any comparison, so that asserts
!> do not trap where floating-point traps are on.
module funit_assert_real
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use, intrinsic :: iso_fortran_env, only: real32, real64
   use funit_deviation, only: note_deviation
   use funit_exception, only: SourceLocation, throw
   use funit_text, only: complaint, position_text, text_of
   implicit none
   private
   public :: assertEqual, assertNotEqual, assertRelativelyEqual
   public :: assertLessThan, assertLessThanOrEqual, assertGreaterThan, assertGreaterThanOrEqual
   public :: assertIsFinite, assertIsInfinite, assertIsNaN, assertIsNotNaN

   interface assertEqual
      module procedure equal_real64_0_0, equal_real64_0_1, equal_real64_1_1, equal_real64_0_2, equal_real64_2_2, &
         equal_default_0_0, equal_default_0_1, equal_default_0_2, equal_real32_0_0, &
         equal_single_0_0, equal_single_0_1, equal_single_0_2
   end interface assertEqual

   interface assertRelativelyEqual
      module procedure relative_real64_0_0, relative_real64_0_1, relative_real64_1_1, relative_real64_0_2, &
         relative_real64_2_2
   end interface assertRelativelyEqual

   interface assertNotEqual
      module procedure not_equal_real
   end interface assertNotEqual

   interface assertLessThan
      module procedure less_real
   end interface assertLessThan

   interface assertLessThanOrEqual
      module procedure less_or_equal_real
   end interface assertLessThanOrEqual

   interface assertGreaterThan
      module procedure greater_real
   end interface assertGreaterThan

   interface assertGreaterThanOrEqual
      module procedure greater_or_equal_real
   end interface assertGreaterThanOrEqual

   interface assertIsFinite
      module procedure finite_0, finite_1
   end interface assertIsFinite

   interface assertIsInfinite
      module procedure infinite_0, infinite_1
   end interface assertIsInfinite

   interface assertIsNaN
      module procedure nan_0, nan_1
   end interface assertIsNaN

   interface assertIsNotNaN
      module procedure not_nan_0, not_nan_1
   end interface assertIsNotNaN

contains

   !> Every element within an absolute tolerance of its expected one (one expected serves all).
   subroutine check_equal(expected, actual, expected_shape, actual_shape, tolerance, message, location)
      real(real64), intent(in) :: expected(:)
      real(real64), intent(in) :: actual(:)
      integer, intent(in) :: expected_shape(:)
      integer, intent(in) :: actual_shape(:)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      real(real64) :: limit
      integer :: k
      limit = 0.0_real64
      if (present(tolerance)) limit = tolerance
      if (.not. conforming(expected_shape, actual_shape, message, location)) return
      do k = 1, size(actual)
         call check_one(expected(min(k, size(expected))), actual(k), limit, position_text(k, actual_shape), message, location)
      end do
   end subroutine check_equal

   !> Every element within tolerance times |expected|; an expected zero is a failure.
   subroutine check_relative(expected, actual, expected_shape, actual_shape, tolerance, message, location)
      real(real64), intent(in) :: expected(:)
      real(real64), intent(in) :: actual(:)
      integer, intent(in) :: expected_shape(:)
      integer, intent(in) :: actual_shape(:)
      real(real64), intent(in) :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      real(real64) :: wanted
      integer :: k
      if (.not. conforming(expected_shape, actual_shape, message, location)) return
      do k = 1, size(actual)
         wanted = expected(min(k, size(expected)))
         if (.not. abs(wanted) > 0.0_real64) then
            call throw(complaint('not zero, for a relative comparison', text_of(wanted), '', '', message), location)
            return
         end if
         call check_one(wanted, actual(k), tolerance*abs(wanted), position_text(k, actual_shape), message, location)
      end do
   end subroutine check_relative

   subroutine check_one(expected, actual, limit, place, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual
      real(real64), intent(in) :: limit
      character(*), intent(in) :: place
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. (ieee_is_finite(expected) .and. ieee_is_finite(actual))) then
         if (.not. (ieee_is_nan(expected) .or. ieee_is_nan(actual))) then
            if (.not. (expected < actual .or. expected > actual)) return
         end if
         call throw(complaint(text_of(expected), text_of(actual), '', place, message), location)
         return
      end if
      call note_deviation(expected, actual, limit)
      if (abs(actual - expected) > limit) then
         call throw(complaint(text_of(expected), text_of(actual), text_of(actual - expected), &
                              place//' (tolerance '//text_of(limit)//')', message), location)
      end if
   end subroutine check_one

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

   subroutine equal_real64_0_0(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([expected], [actual], shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_real64_0_0

   subroutine equal_real64_0_1(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual(:)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([expected], actual, shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_real64_0_1

   subroutine equal_real64_1_1(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected(:)
      real(real64), intent(in) :: actual(:)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(expected, actual, shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_real64_1_1

   subroutine equal_real64_0_2(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual(:, :)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([expected], reshape(actual, [size(actual)]), &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_real64_0_2

   subroutine equal_real64_2_2(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected(:, :)
      real(real64), intent(in) :: actual(:, :)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal(reshape(expected, [size(expected)]), reshape(actual, [size(actual)]), &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_real64_2_2

   subroutine equal_default_0_0(expected, actual, tolerance, message, location)
      integer, intent(in) :: expected
      real(real64), intent(in) :: actual
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([real(expected, real64)], [actual], &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_default_0_0

   subroutine equal_default_0_1(expected, actual, tolerance, message, location)
      integer, intent(in) :: expected
      real(real64), intent(in) :: actual(:)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([real(expected, real64)], actual, &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_default_0_1

   subroutine equal_default_0_2(expected, actual, tolerance, message, location)
      integer, intent(in) :: expected
      real(real64), intent(in) :: actual(:, :)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([real(expected, real64)], reshape(actual, [size(actual)]), &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_default_0_2

   subroutine equal_real32_0_0(expected, actual, tolerance, message, location)
      real(real32), intent(in) :: expected
      real(real32), intent(in) :: actual
      real(real32), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      real(real64) :: limit
      limit = 0.0_real64
      if (present(tolerance)) limit = real(tolerance, real64)
      call check_equal([real(expected, real64)], [real(actual, real64)], &
                       shape(expected), shape(actual), limit, message, location)
   end subroutine equal_real32_0_0

   subroutine relative_real64_0_0(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual
      real(real64), intent(in) :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_relative([expected], [actual], &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine relative_real64_0_0

   subroutine relative_real64_0_1(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual(:)
      real(real64), intent(in) :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_relative([expected], actual, &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine relative_real64_0_1

   subroutine relative_real64_1_1(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected(:)
      real(real64), intent(in) :: actual(:)
      real(real64), intent(in) :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_relative(expected, actual, shape(expected), shape(actual), tolerance, message, location)
   end subroutine relative_real64_1_1

   subroutine relative_real64_0_2(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual(:, :)
      real(real64), intent(in) :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_relative([expected], reshape(actual, [size(actual)]), &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine relative_real64_0_2

   subroutine relative_real64_2_2(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected(:, :)
      real(real64), intent(in) :: actual(:, :)
      real(real64), intent(in) :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_relative(reshape(expected, [size(expected)]), reshape(actual, [size(actual)]), &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine relative_real64_2_2

   subroutine equal_single_0_0(expected, actual, tolerance, message, location)
      real(real32), intent(in) :: expected
      real(real64), intent(in) :: actual
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([real(expected, real64)], [actual], &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_single_0_0

   subroutine equal_single_0_1(expected, actual, tolerance, message, location)
      real(real32), intent(in) :: expected
      real(real64), intent(in) :: actual(:)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([real(expected, real64)], actual, &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_single_0_1

   subroutine equal_single_0_2(expected, actual, tolerance, message, location)
      real(real32), intent(in) :: expected
      real(real64), intent(in) :: actual(:, :)
      real(real64), intent(in), optional :: tolerance
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      call check_equal([real(expected, real64)], reshape(actual, [size(actual)]), &
                       shape(expected), shape(actual), tolerance, message, location)
   end subroutine equal_single_0_2

   subroutine not_equal_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs
      real(real64), intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: holds
      holds = .not. (ieee_is_nan(lhs) .or. ieee_is_nan(rhs))
      if (holds) holds = lhs < rhs .or. lhs > rhs
      if (.not. holds) call throw(complaint(text_of(lhs)//' not equal '//text_of(rhs), 'not so', '', '', message), location)
   end subroutine not_equal_real

   subroutine less_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs
      real(real64), intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: holds
      holds = .not. (ieee_is_nan(lhs) .or. ieee_is_nan(rhs))
      if (holds) holds = lhs < rhs
      if (.not. holds) call throw(complaint(text_of(lhs)//' < '//text_of(rhs), 'not so', '', '', message), location)
   end subroutine less_real

   subroutine less_or_equal_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs
      real(real64), intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: holds
      holds = .not. (ieee_is_nan(lhs) .or. ieee_is_nan(rhs))
      if (holds) holds = lhs <= rhs
      if (.not. holds) call throw(complaint(text_of(lhs)//' <= '//text_of(rhs), 'not so', '', '', message), location)
   end subroutine less_or_equal_real

   subroutine greater_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs
      real(real64), intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: holds
      holds = .not. (ieee_is_nan(lhs) .or. ieee_is_nan(rhs))
      if (holds) holds = lhs > rhs
      if (.not. holds) call throw(complaint(text_of(lhs)//' > '//text_of(rhs), 'not so', '', '', message), location)
   end subroutine greater_real

   subroutine greater_or_equal_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs
      real(real64), intent(in) :: rhs
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      logical :: holds
      holds = .not. (ieee_is_nan(lhs) .or. ieee_is_nan(rhs))
      if (holds) holds = lhs >= rhs
      if (.not. holds) call throw(complaint(text_of(lhs)//' >= '//text_of(rhs), 'not so', '', '', message), location)
   end subroutine greater_or_equal_real

   subroutine finite_0(x, message, location)
      real(real64), intent(in) :: x
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. ieee_is_finite(x)) call throw(complaint('finite', text_of(x), '', '', message), location)
   end subroutine finite_0

   subroutine finite_1(x, message, location)
      real(real64), intent(in) :: x(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. all(ieee_is_finite(x))) call throw(complaint('finite', 'some element is not', '', '', message), location)
   end subroutine finite_1

   subroutine infinite_0(x, message, location)
      real(real64), intent(in) :: x
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (ieee_is_finite(x) .or. ieee_is_nan(x)) call throw(complaint('infinite', text_of(x), '', '', message), location)
   end subroutine infinite_0

   subroutine infinite_1(x, message, location)
      real(real64), intent(in) :: x(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (any(ieee_is_finite(x) .or. ieee_is_nan(x))) &
         call throw(complaint('infinite', 'some element is not', '', '', message), location)
   end subroutine infinite_1

   subroutine nan_0(x, message, location)
      real(real64), intent(in) :: x
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. ieee_is_nan(x)) call throw(complaint('NaN', text_of(x), '', '', message), location)
   end subroutine nan_0

   subroutine nan_1(x, message, location)
      real(real64), intent(in) :: x(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (.not. all(ieee_is_nan(x))) call throw(complaint('NaN', 'some element is not', '', '', message), location)
   end subroutine nan_1

   subroutine not_nan_0(x, message, location)
      real(real64), intent(in) :: x
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (ieee_is_nan(x)) call throw(complaint('not NaN', text_of(x), '', '', message), location)
   end subroutine not_nan_0

   subroutine not_nan_1(x, message, location)
      real(real64), intent(in) :: x(:)
      character(*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      if (any(ieee_is_nan(x))) call throw(complaint('not NaN', 'some element is not', '', '', message), location)
   end subroutine not_nan_1
end module funit_assert_real

!> Failures of the running test. Asserts throw and return: a test goes on after a failed assert.
!> The list is module state because asserts, as in pFUnit, get no handle of the test that they belong to.
module funit_exception
   implicit none
   private
   public :: SourceLocation, Exception, throw, catch, anyExceptions, pop_exceptions

   type :: SourceLocation
      character(255) :: fileName = '<unknown file>'
      integer :: lineNumber = -1
   end type SourceLocation

   type :: Exception
      character(:), allocatable :: message
      type(SourceLocation) :: location
   end type Exception

   interface catch
      module procedure catch_any, catch_message
   end interface catch

   type(Exception), allocatable :: pending(:)

contains

   !> Records a failure.
   subroutine throw(message, location)
      character(*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location
      type(Exception), allocatable :: longer(:)
      integer :: n
      n = 0
      if (allocated(pending)) n = size(pending)
      allocate (longer(n + 1))
      if (n > 0) longer(:n) = pending
      longer(n + 1)%message = message
      if (present(location)) longer(n + 1)%location = location
      call move_alloc(longer, pending)
   end subroutine throw

   !> True if a failure is recorded.
   logical function anyExceptions()
      anyExceptions = .false.
      if (allocated(pending)) anyExceptions = size(pending) > 0
   end function anyExceptions

   !> Removes the latest failure; false where there is none.
   logical function catch_any(preserve) result(found)
      logical, intent(in), optional :: preserve
      found = anyExceptions()
      if (found .and. .not. kept(preserve)) call remove(size(pending))
   end function catch_any

   !> Removes the first failure of that message; false where there is none.
   logical function catch_message(message, preserve) result(found)
      character(*), intent(in) :: message
      logical, intent(in), optional :: preserve
      integer :: i
      found = .false.
      if (.not. allocated(pending)) return
      do i = 1, size(pending)
         if (pending(i)%message == message) then
            found = .true.
            if (.not. kept(preserve)) call remove(i)
            return
         end if
      end do
   end function catch_message

   !> Hands over all failures and leaves none.
   subroutine pop_exceptions(exceptions)
      type(Exception), allocatable, intent(out) :: exceptions(:)
      if (allocated(pending)) then
         call move_alloc(pending, exceptions)
      else
         allocate (exceptions(0))
      end if
   end subroutine pop_exceptions

   logical function kept(preserve)
      logical, intent(in), optional :: preserve
      kept = .false.
      if (present(preserve)) kept = preserve
   end function kept

   subroutine remove(index)
      integer, intent(in) :: index
      type(Exception), allocatable :: shorter(:)
      integer :: n
      n = size(pending)
      allocate (shorter(n - 1))
      shorter(:index - 1) = pending(:index - 1)
      shorter(index:) = pending(index + 1:)
      call move_alloc(shorter, pending)
   end subroutine remove
end module funit_exception

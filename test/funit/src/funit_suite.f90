!> Tests and suites. A suite keeps its tests as one flat list with full names; adding a suite to a suite
!> puts the outer name, where there is one, before the inner names.
module funit_suite
   implicit none
   private
   public :: Test, TestMethod, TestSuite, test_procedure

   abstract interface
      subroutine test_procedure()
         implicit none
      end subroutine test_procedure
   end interface

   type, abstract :: Test
      character(:), allocatable :: name
   contains
      procedure :: getName
      procedure :: setName
   end type Test

   !> One test: a procedure, with what runs before and after it.
   type, extends(Test) :: TestMethod
      procedure(test_procedure), nopass, pointer :: method => null()
      procedure(test_procedure), nopass, pointer :: setUp => null()
      procedure(test_procedure), nopass, pointer :: tearDown => null()
   end type TestMethod

   type, extends(Test) :: TestSuite
      type(TestMethod), allocatable :: methods(:)
   contains
      procedure :: addTest
      procedure :: getNumTests => countTestCases
      procedure :: countTestCases
   end type TestSuite

   interface TestMethod
      module procedure new_test_method
   end interface TestMethod

   interface TestSuite
      module procedure new_test_suite
   end interface TestSuite

contains

   function new_test_method(name, method, setUp, tearDown) result(new)
      character(*), intent(in) :: name
      procedure(test_procedure) :: method
      procedure(test_procedure), optional :: setUp
      procedure(test_procedure), optional :: tearDown
      type(TestMethod) :: new
      new%name = name
      new%method => method
      if (present(setUp)) new%setUp => setUp
      if (present(tearDown)) new%tearDown => tearDown
   end function new_test_method

   function new_test_suite(name) result(new)
      character(*), intent(in), optional :: name
      type(TestSuite) :: new
      new%name = ''
      if (present(name)) new%name = name
      allocate (new%methods(0))
   end function new_test_suite

   function getName(this) result(name)
      class(Test), intent(in) :: this
      character(:), allocatable :: name
      name = this%name
   end function getName

   subroutine setName(this, name)
      class(Test), intent(inout) :: this
      character(*), intent(in) :: name
      this%name = name
   end subroutine setName

   integer function countTestCases(this)
      class(TestSuite), intent(in) :: this
      countTestCases = size(this%methods)
   end function countTestCases

   !> Adds a copy of a test, or of all tests of another suite.
   subroutine addTest(this, aTest)
      class(TestSuite), intent(inout) :: this
      class(Test), intent(in) :: aTest
      type(TestMethod), allocatable :: longer(:)
      integer :: i, n
      n = size(this%methods)
      select type (aTest)
      type is (TestMethod)
         allocate (longer(n + 1))
         longer(n + 1) = aTest
      type is (TestSuite)
         allocate (longer(n + size(aTest%methods)))
         do i = 1, size(aTest%methods)
            longer(n + i) = aTest%methods(i)
         end do
      class default
         allocate (longer(n))
      end select
      do i = 1, n
         longer(i) = this%methods(i)
      end do
      if (this%name /= '') then
         do i = n + 1, size(longer)
            longer(i)%name = this%name//'.'//longer(i)%name
         end do
      end if
      call move_alloc(longer, this%methods)
   end subroutine addTest
end module funit_suite

!> Tests of single procedures and types. Every test module of this folder is registered here.
program unit
   use funit, only: run
   implicit none
   if (.not. run(load_tests)) error stop 1

contains

   function load_tests() result(suite)
      use funit, only: TestSuite
      use dg_test_asserts, only: asserts_suite
      use dg_test_units, only: units_suite
      type(TestSuite) :: suite
      suite = TestSuite('unit')
      call suite%addTest(asserts_suite())
      call suite%addTest(units_suite())
   end function load_tests
end program unit

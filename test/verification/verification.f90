!> Tests against closed forms and published answers. Every test module of this folder is registered here.
program verification
   use funit, only: run
   implicit none
   if (.not. run(load_tests)) error stop 1

contains

   function load_tests() result(suite)
      use funit, only: TestSuite
      use dg_test_soft_wells, only: soft_wells_suite
      use dg_test_tangent, only: tangent_suite
      type(TestSuite) :: suite
      suite = TestSuite('verification')
      call suite%addTest(soft_wells_suite())
      call suite%addTest(tangent_suite())
   end function load_tests
end program verification

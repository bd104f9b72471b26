!> Tests of single procedures and types. Every test module of this folder is registered here.
program unit
   use funit, only: run
   implicit none
   if (.not. run(load_tests)) error stop 1

contains

   function load_tests() result(suite)
      use funit, only: TestSuite
      use dg_test_asserts, only: asserts_suite
      use dg_test_component, only: component_suite
      use dg_test_deck_model, only: deck_model_suite
      use dg_test_deck_text, only: deck_text_suite
      use dg_test_drillstring, only: drillstring_suite
      use dg_test_hole_section, only: hole_section_suite
      use dg_test_load_case, only: load_case_suite
      use dg_test_report_cells, only: report_cells_suite
      use dg_test_report_files, only: report_files_suite
      use dg_test_report_table, only: report_table_suite
      use dg_test_units, only: units_suite
      use dg_test_trajectory, only: trajectory_suite
      use dg_test_soft_string, only: soft_string_suite
      type(TestSuite) :: suite
      suite = TestSuite('unit')
      call suite%addTest(asserts_suite())
      call suite%addTest(component_suite())
      call suite%addTest(deck_model_suite())
      call suite%addTest(deck_text_suite())
      call suite%addTest(drillstring_suite())
      call suite%addTest(hole_section_suite())
      call suite%addTest(load_case_suite())
      call suite%addTest(report_cells_suite())
      call suite%addTest(report_files_suite())
      call suite%addTest(report_table_suite())
      call suite%addTest(units_suite())
      call suite%addTest(trajectory_suite())
      call suite%addTest(soft_string_suite())
   end function load_tests
end program unit

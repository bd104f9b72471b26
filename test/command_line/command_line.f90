!> Tests of the built program: decks in, exit status and files out. Every test module of this folder is registered here.
program command_line
   use funit, only: run
   use dg_place, only: enter_root
   use dg_program_run, only: settle_program
   implicit none
   call settle_program()
   call enter_root()
   if (.not. run(load_tests)) error stop 1

contains

   function load_tests() result(suite)
      use funit, only: TestSuite
      use dg_test_actions, only: actions_suite
      use dg_test_bad_decks, only: bad_decks_suite
      use dg_test_bent_runs, only: bent_runs_suite
      use dg_test_bounds, only: bounds_suite
      use dg_test_can_be_done, only: can_be_done_suite
      use dg_test_output_folder, only: output_folder_suite
      use dg_test_standard_output, only: standard_output_suite
      use dg_test_odd_decks, only: odd_decks_suite
      use dg_test_printed_figures, only: printed_figures_suite
      use dg_test_program, only: program_suite
      use dg_test_legacy_runs, only: legacy_runs_suite
      use dg_test_import_runs, only: import_runs_suite
      use dg_test_interruption, only: interruption_suite
      use dg_test_threads, only: threads_suite
      use dg_test_study_runs, only: study_runs_suite
      use dg_test_again_runs, only: again_runs_suite
      use dg_test_part_runs, only: part_runs_suite
      use dg_test_sweep_runs, only: sweep_runs_suite
      use dg_test_calibration_runs, only: calibration_runs_suite
      use dg_test_changed_keys, only: changed_keys_suite
      use dg_test_opened_runs, only: opened_runs_suite
      use dg_test_path_runs, only: path_runs_suite
      use dg_test_survey_runs, only: survey_runs_suite
      use dg_test_rig_runs, only: rig_runs_suite
      use dg_test_applied_friction, only: applied_friction_suite
      use dg_test_followed_advice, only: followed_advice_suite
      use dg_test_followed_faults, only: followed_faults_suite
      use dg_test_followed_keys, only: followed_keys_suite
      use dg_test_followed_studies, only: followed_studies_suite
      use dg_test_followed_surveys, only: followed_surveys_suite
      use dg_test_followed_units, only: followed_units_suite
      use dg_test_uncertainty_runs, only: uncertainty_runs_suite
      use dg_test_ways_down, only: ways_down_suite
      use dg_test_picture_drawing, only: picture_drawing_suite
      use dg_test_picture_runs, only: picture_runs_suite
      use dg_test_stuck_runs, only: stuck_runs_suite
      use dg_test_expected_messages, only: expected_messages_suite
      use dg_test_hints, only: hints_suite
      use dg_test_running_in, only: running_in_suite
      use dg_test_unusual_decks, only: unusual_decks_suite
      use dg_test_unusual_tools, only: unusual_tools_suite
      type(TestSuite) :: suite
      suite = TestSuite('command_line')
      call suite%addTest(actions_suite())
      call suite%addTest(bad_decks_suite())
      call suite%addTest(bounds_suite())
      call suite%addTest(expected_messages_suite())
      call suite%addTest(hints_suite())
      call suite%addTest(odd_decks_suite())
      call suite%addTest(running_in_suite())
      call suite%addTest(unusual_decks_suite())
      call suite%addTest(unusual_tools_suite())
      call suite%addTest(program_suite())
      call suite%addTest(can_be_done_suite())
      call suite%addTest(printed_figures_suite())
      call suite%addTest(followed_faults_suite())
      call suite%addTest(followed_keys_suite())
      call suite%addTest(followed_studies_suite())
      call suite%addTest(followed_surveys_suite())
      call suite%addTest(followed_units_suite())
      call suite%addTest(followed_advice_suite())
      call suite%addTest(output_folder_suite())
      call suite%addTest(standard_output_suite())
      call suite%addTest(legacy_runs_suite())
      call suite%addTest(threads_suite())
      call suite%addTest(import_runs_suite())
      call suite%addTest(interruption_suite())
      call suite%addTest(study_runs_suite())
      call suite%addTest(sweep_runs_suite())
      call suite%addTest(changed_keys_suite())
      call suite%addTest(opened_runs_suite())
      call suite%addTest(part_runs_suite())
      call suite%addTest(again_runs_suite())
      call suite%addTest(calibration_runs_suite())
      call suite%addTest(rig_runs_suite())
      call suite%addTest(bent_runs_suite())
      call suite%addTest(ways_down_suite())
      call suite%addTest(path_runs_suite())
      call suite%addTest(survey_runs_suite())
      call suite%addTest(applied_friction_suite())
      call suite%addTest(uncertainty_runs_suite())
      call suite%addTest(stuck_runs_suite())
      call suite%addTest(picture_drawing_suite())
      call suite%addTest(picture_runs_suite())
   end function load_tests
end program command_line

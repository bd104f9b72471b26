!> Tests of single procedures and types. Every test module of this folder is registered here.
program unit
   use funit, only: run
   use dg_place, only: enter_root
   implicit none
   call enter_root()
   if (.not. run(load_tests)) error stop 1

contains

   function load_tests() result(suite)
      use funit, only: TestSuite
      use dg_test_asserts, only: asserts_suite
      use dg_test_bracket, only: bracket_suite
      use dg_test_catalogue, only: catalogue_suite
      use dg_test_component, only: component_suite
      use dg_test_deck_model, only: deck_model_suite
      use dg_test_deck_text, only: deck_text_suite
      use dg_test_drillstring, only: drillstring_suite
      use dg_test_hole_section, only: hole_section_suite
      use dg_test_library, only: library_suite
      use dg_test_library_faults, only: library_faults_suite
      use dg_test_load_case, only: load_case_suite
      use dg_test_output_names, only: output_names_suite
      use dg_test_rig, only: rig_suite
      use dg_test_report_cells, only: report_cells_suite
      use dg_test_report_files, only: report_files_suite
      use dg_test_report_table, only: report_table_suite
      use dg_test_round_wall, only: round_wall_suite
      use dg_test_run_outcome, only: run_outcome_suite
      use dg_test_survey_file, only: survey_file_suite
      use dg_test_survey_heading, only: survey_heading_suite
      use dg_test_witsml_survey, only: witsml_survey_suite
      use dg_test_units, only: units_suite
      use dg_test_closest_point, only: closest_point_suite
      use dg_test_tortuosity, only: tortuosity_suite
      use dg_test_trajectory, only: trajectory_suite
      use dg_test_soft_string, only: soft_string_suite
      use dg_test_attempts, only: attempts_suite
      use dg_test_beam_angle, only: beam_angle_suite
      use dg_test_beam_element, only: beam_element_suite
      use dg_test_block_matrix, only: block_matrix_suite
      use dg_test_outside_hole, only: outside_hole_suite
      use dg_test_symmetric_solver, only: symmetric_solver_suite
      use dg_test_director, only: director_suite
      use dg_test_fidelity_errors, only: fidelity_errors_suite
      use dg_test_fluid, only: fluid_suite
      use dg_test_gap_contact, only: gap_contact_suite
      use dg_test_gap_element, only: gap_element_suite
      use dg_test_gap_location, only: gap_location_suite
      use dg_test_gap_state, only: gap_state_suite
      use dg_test_gap_table, only: gap_table_suite
      use dg_test_hermite, only: hermite_suite
      use dg_test_merge_sort, only: merge_sort_suite
      use dg_test_mesh, only: mesh_suite
      use dg_test_sinusoidal_shape, only: sinusoidal_shape_suite
      use dg_test_curvature_change, only: curvature_change_suite
      use dg_test_model_table, only: model_table_suite
      use dg_test_legacy, only: legacy_suite
      use dg_test_depth_curve, only: depth_curve_suite
      use dg_test_line_load, only: line_load_suite
      use dg_test_page_curves, only: page_curves_suite
   use dg_test_page_figures, only: page_figures_suite
      use dg_test_pictures, only: pictures_suite
      use dg_test_pipe_stress, only: pipe_stress_suite
      use dg_test_buckled_shape, only: buckled_shape_suite
      use dg_test_buckling_limits, only: buckling_limits_suite
      use dg_test_contact_edges, only: contact_edges_suite
      use dg_test_string_limits, only: string_limits_suite
      use dg_test_joint_bending, only: joint_bending_suite
      use dg_test_paraview, only: paraview_suite
      use dg_test_study, only: study_suite
      use dg_test_part_list, only: part_list_suite
      use dg_test_sweep, only: sweep_suite
      use dg_test_calibration, only: calibration_suite
      use dg_test_calibration_coverage, only: calibration_coverage_suite
      use dg_test_prediction, only: prediction_suite
      use dg_test_ten_digits, only: ten_digits_suite
      use dg_test_verdict, only: verdict_suite
      use dg_test_verdict_text, only: verdict_text_suite
      use dg_test_uncertainty, only: uncertainty_suite
      use dg_test_stuck_string, only: stuck_string_suite
      use dg_test_strength, only: strength_suite
      use dg_test_connection_rating, only: connection_rating_suite
      use dg_test_zero_crossing, only: zero_crossing_suite
      type(TestSuite) :: suite
      suite = TestSuite('unit')
      call suite%addTest(asserts_suite())
      call suite%addTest(bracket_suite())
      call suite%addTest(catalogue_suite())
      call suite%addTest(component_suite())
      call suite%addTest(deck_model_suite())
      call suite%addTest(deck_text_suite())
      call suite%addTest(drillstring_suite())
      call suite%addTest(fidelity_errors_suite())
      call suite%addTest(fluid_suite())
      call suite%addTest(hole_section_suite())
      call suite%addTest(library_suite())
      call suite%addTest(library_faults_suite())
      call suite%addTest(load_case_suite())
      call suite%addTest(output_names_suite())
      call suite%addTest(rig_suite())
      call suite%addTest(report_cells_suite())
      call suite%addTest(report_files_suite())
      call suite%addTest(report_table_suite())
      call suite%addTest(round_wall_suite())
      call suite%addTest(run_outcome_suite())
      call suite%addTest(zero_crossing_suite())
      call suite%addTest(survey_file_suite())
      call suite%addTest(survey_heading_suite())
      call suite%addTest(witsml_survey_suite())
      call suite%addTest(ten_digits_suite())
      call suite%addTest(units_suite())
      call suite%addTest(trajectory_suite())
      call suite%addTest(tortuosity_suite())
      call suite%addTest(closest_point_suite())
      call suite%addTest(soft_string_suite())
      call suite%addTest(attempts_suite())
      call suite%addTest(beam_angle_suite())
      call suite%addTest(beam_element_suite())
      call suite%addTest(block_matrix_suite())
      call suite%addTest(outside_hole_suite())
      call suite%addTest(symmetric_solver_suite())
      call suite%addTest(director_suite())
      call suite%addTest(gap_contact_suite())
      call suite%addTest(gap_element_suite())
      call suite%addTest(gap_location_suite())
      call suite%addTest(gap_state_suite())
      call suite%addTest(gap_table_suite())
      call suite%addTest(hermite_suite())
      call suite%addTest(merge_sort_suite())
      call suite%addTest(mesh_suite())
      call suite%addTest(sinusoidal_shape_suite())
      call suite%addTest(curvature_change_suite())
      call suite%addTest(model_table_suite())
      call suite%addTest(legacy_suite())
      call suite%addTest(depth_curve_suite())
      call suite%addTest(line_load_suite())
      call suite%addTest(page_curves_suite())
      call suite%addTest(page_figures_suite())
      call suite%addTest(pictures_suite())
      call suite%addTest(pipe_stress_suite())
      call suite%addTest(buckled_shape_suite())
      call suite%addTest(buckling_limits_suite())
      call suite%addTest(contact_edges_suite())
      call suite%addTest(string_limits_suite())
      call suite%addTest(joint_bending_suite())
      call suite%addTest(paraview_suite())
      call suite%addTest(study_suite())
      call suite%addTest(sweep_suite())
      call suite%addTest(part_list_suite())
      call suite%addTest(calibration_suite())
      call suite%addTest(calibration_coverage_suite())
      call suite%addTest(prediction_suite())
      call suite%addTest(uncertainty_suite())
      call suite%addTest(stuck_string_suite())
      call suite%addTest(strength_suite())
      call suite%addTest(connection_rating_suite())
      call suite%addTest(verdict_suite())
      call suite%addTest(verdict_text_suite())
   end function load_tests
end program unit

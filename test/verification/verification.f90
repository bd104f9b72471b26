!> Tests against closed forms and published answers. Every test module of this folder is registered here.
program verification
   use funit, only: run
   use dg_place, only: enter_root
   implicit none
   call enter_root()
   if (.not. run(load_tests)) error stop 1

contains

   function load_tests() result(suite)
      use funit, only: TestSuite
      use dg_test_soft_wells, only: soft_wells_suite
      use dg_test_tangent, only: tangent_suite
      use dg_test_fidelity, only: fidelity_suite
      use dg_test_weight_limits, only: weight_limits_suite
      use dg_test_fit_coverage, only: fit_coverage_suite
      use dg_test_bends, only: bends_suite
      use dg_test_straight_holes, only: straight_holes_suite
      use dg_test_centralizers, only: centralizers_suite
      use dg_test_component_friction, only: component_friction_suite
      use dg_test_opened_tools, only: opened_tools_suite
      use dg_test_beams, only: beams_suite
      use dg_test_supports, only: supports_suite
      use dg_test_contacts, only: contacts_suite
      use dg_test_contact_wells, only: contact_wells_suite
      use dg_test_stiff_wells, only: stiff_wells_suite
      use dg_test_bent_housing, only: bent_housing_suite
      use dg_test_bit_side_force, only: bit_side_force_suite
      use dg_test_buckling, only: buckling_suite
      use dg_test_buckled_start, only: buckled_start_suite
      use dg_test_loss_of_definiteness, only: loss_of_definiteness_suite
      use dg_test_tool_joints, only: tool_joints_suite
      use dg_test_mixed_elements, only: mixed_elements_suite
      use dg_test_operations, only: operations_suite
      use dg_test_assemblies, only: assemblies_suite
      use dg_test_hard_cases, only: hard_cases_suite
      use dg_test_lone_contacts, only: lone_contacts_suite
      use dg_test_contact_sums, only: contact_sums_suite
      use dg_test_sag_correction, only: sag_correction_suite
      use dg_test_published_turns, only: published_turns_suite
      use dg_test_eccentric_blades, only: eccentric_blades_suite
      use dg_test_pads, only: pads_suite
      use dg_test_casing_wear, only: casing_wear_suite
      use dg_test_fatigue, only: fatigue_suite
      use dg_test_length_change, only: length_change_suite
      use dg_test_whirling, only: whirling_suite
      use dg_test_moments, only: moments_suite
      use dg_test_columns, only: columns_suite
      use dg_test_margins, only: margins_suite
      use dg_test_both_sides, only: both_sides_suite
      use dg_test_boundary_layers, only: boundary_layers_suite
      use dg_test_fluids, only: fluids_suite
      use dg_test_extremes, only: extremes_suite
      use dg_test_extreme_pairs, only: extreme_pairs_suite
      type(TestSuite) :: suite
      suite = TestSuite('verification')
      call suite%addTest(soft_wells_suite())
      call suite%addTest(tangent_suite())
      call suite%addTest(fidelity_suite())
      call suite%addTest(weight_limits_suite())
      call suite%addTest(fit_coverage_suite())
      call suite%addTest(bends_suite())
      call suite%addTest(straight_holes_suite())
      call suite%addTest(component_friction_suite())
      call suite%addTest(opened_tools_suite())
      call suite%addTest(centralizers_suite())
      call suite%addTest(beams_suite())
      call suite%addTest(supports_suite())
      call suite%addTest(contacts_suite())
      call suite%addTest(contact_wells_suite())
      call suite%addTest(stiff_wells_suite())
      call suite%addTest(bent_housing_suite())
      call suite%addTest(bit_side_force_suite())
      call suite%addTest(buckling_suite())
      call suite%addTest(buckled_start_suite())
      call suite%addTest(loss_of_definiteness_suite())
      call suite%addTest(tool_joints_suite())
      call suite%addTest(mixed_elements_suite())
      call suite%addTest(operations_suite())
      call suite%addTest(assemblies_suite())
      call suite%addTest(hard_cases_suite())
      call suite%addTest(lone_contacts_suite())
      call suite%addTest(contact_sums_suite())
      call suite%addTest(sag_correction_suite())
      call suite%addTest(published_turns_suite())
      call suite%addTest(eccentric_blades_suite())
      call suite%addTest(pads_suite())
      call suite%addTest(casing_wear_suite())
      call suite%addTest(fatigue_suite())
      call suite%addTest(length_change_suite())
      call suite%addTest(whirling_suite())
      call suite%addTest(moments_suite())
      call suite%addTest(columns_suite())
      call suite%addTest(margins_suite())
      call suite%addTest(both_sides_suite())
      call suite%addTest(boundary_layers_suite())
      call suite%addTest(fluids_suite())
      call suite%addTest(extremes_suite())
      call suite%addTest(extreme_pairs_suite())
   end function load_tests
end program verification

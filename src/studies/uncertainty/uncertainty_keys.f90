!> The group &uncertainty of a deck and its keys.
module dg_uncertainty_keys
   use dg_kinds, only: wp
   use dg_deck_keys, only: deepest, strongest, roughest, heaviest
   use dg_deck_schema, only: group_rule_type, key_rule_type, kind_integer, kind_text
   use dg_unit_kind, only: unit_angle, unit_density, unit_force, unit_length, unit_moment, unit_rotation, unit_speed
   implicit none
   private
   public :: uncertainty_rule, uncertainty_keys

   type(group_rule_type), parameter :: uncertainty_rule = &
      group_rule_type('uncertainty', repeatable=.true., own_cases=.true., &
                      meaning='P10, P50 and P90 of hook load and torque for uncertain friction, mud, survey and gauges')

   type(key_rule_type), parameter :: uncertainty_keys(*) = [ &
      key_rule_type('uncertainty', 'name', kind_text, meaning='unique; letters, digits and _ - . +; default its number'), &
      key_rule_type('uncertainty', 'operations', kind_text, array=.true., choices='*', &
         meaning='default trip_out, trip_in, rotate_off_bottom'), &
      key_rule_type('uncertainty', 'bit_depth_from', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='first bit depth; at surface itself nothing is solved'), &
      key_rule_type('uncertainty', 'bit_depth_to', unit=unit_length, low=0.0_wp, open=.true., high=deepest, &
         meaning='last bit depth; default the end of survey or hole'), &
      key_rule_type('uncertainty', 'bit_depth_step', unit=unit_length, low=0.0_wp, open=.true., high=deepest, default='30', &
         meaning='distance between bit depths; the last one is always solved'), &
      key_rule_type('uncertainty', 'friction', low=0.0_wp, high=roughest, &
         meaning='friction factor of the whole hole, axial and rotary; default those of the hole sections'), &
      key_rule_type('uncertainty', 'string', kind_text, default='main', meaning='name of the drillstring'), &
      key_rule_type('uncertainty', 'wob', unit=unit_force, array=.true., low=-strongest, high=strongest, default='0', &
         meaning='weight on bit, one for all operations or one for each; > 0 pushes the bit, < 0 pulls it'), &
      key_rule_type('uncertainty', 'tob', unit=unit_moment, array=.true., low=0.0_wp, high=strongest, default='0', &
         meaning='torque on bit, one for all operations or one for each'), &
      key_rule_type('uncertainty', 'model', kind_text, array=.true., choices='mcge soft rigid mixed', &
         meaning='one or several models; default those of &job'), &
      key_rule_type('uncertainty', 'rpm', unit=unit_rotation, array=.true., low=0.0_wp, high=1.0e4_wp, default='0', &
         meaning='rotation speed, for ream and backream; one for all operations or one for each'), &
      key_rule_type('uncertainty', 'trip_speed', unit=unit_speed, array=.true., low=0.0_wp, high=100.0_wp, default='0', &
         meaning='axial speed of the string, for ream and backream; one for all operations or one for each'), &
      key_rule_type('uncertainty', 'samples', kind_integer, default='1000', low=2.0_wp, high=1.0e6_wp, &
         meaning='number of random samples'), &
      key_rule_type('uncertainty', 'seed', kind_integer, default='1', low=0.0_wp, high=1.0e9_wp, &
         meaning='start of the random numbers: the same seed gives the same results'), &
      key_rule_type('uncertainty', 'friction_deviation', low=0.0_wp, high=roughest, default='0', &
         meaning='standard deviation of the friction factors of all hole sections'), &
      key_rule_type('uncertainty', 'friction_correlation', low=0.0_wp, high=1.0_wp, default='1', &
         meaning='correlation of two hole sections: 1 one error for the whole hole, 0 an error for each section'), &
      key_rule_type('uncertainty', 'friction_deviations', array=.true., low=0.0_wp, high=roughest, &
         meaning='in place of friction_deviation: one for each hole section, in the order of the deck'), &
      key_rule_type('uncertainty', 'friction_correlations', array=.true., low=-1.0_wp, high=1.0_wp, &
         meaning='in place of friction_correlation: of sections 1 and 2, 1 and 3, ..., 2 and 3, ...'), &
      key_rule_type('uncertainty', 'friction_parameter', kind_text, default='friction', &
         choices='friction friction_axial friction_rotary', meaning='friction factors that are uncertain: both together, '// &
         'axial or rotary'), &
      key_rule_type('uncertainty', 'friction_from', kind_text, &
         meaning='name of a &calibrate with apply = .true., which gives deviations and correlations'), &
      key_rule_type('uncertainty', 'density_deviation', unit=unit_density, low=0.0_wp, high=heaviest, default='0', &
         meaning='standard deviation of the heaviest fluid; all other fluids vary in proportion'), &
      key_rule_type('uncertainty', 'inclination_deviation', unit=unit_angle, low=0.0_wp, high=30.0_wp, default='0', &
         meaning='standard deviation of the inclination of a station'), &
      key_rule_type('uncertainty', 'azimuth_deviation', unit=unit_angle, low=0.0_wp, high=30.0_wp, default='0', &
         meaning='standard deviation of the azimuth of a station'), &
      key_rule_type('uncertainty', 'survey_errors', kind_text, default='random', choices='random systematic', &
         meaning='random: an error for each station; systematic: the same error for all'), &
      key_rule_type('uncertainty', 'hookload_deviation', unit=unit_force, low=0.0_wp, high=strongest, default='0', &
         meaning='standard deviation of the hook load gauge; results are then readings of the gauge'), &
      key_rule_type('uncertainty', 'torque_deviation', unit=unit_moment, low=0.0_wp, high=strongest, default='0', &
         meaning='standard deviation of the torque gauge')]
end module dg_uncertainty_keys

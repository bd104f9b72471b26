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
                      meaning='quantiles of hook load and torque against depth, where well, mud and gauges are not known for sure')

   type(key_rule_type), parameter :: uncertainty_keys(*) = [ &
      key_rule_type('uncertainty', 'name', kind_text, meaning='unique; letters, digits and _ - . +; default its number'), &
      key_rule_type('uncertainty', 'operations', kind_text, array=.true., choices='*', &
         meaning='what is done to the string; default trip_out, trip_in, rotate_off_bottom'), &
      key_rule_type('uncertainty', 'bit_depth_from', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='first measured depth of the bit; at surface itself there is nothing to solve'), &
      key_rule_type('uncertainty', 'bit_depth_to', unit=unit_length, low=0.0_wp, open=.true., high=deepest, &
         meaning='last one; default the end of survey or hole'), &
      key_rule_type('uncertainty', 'bit_depth_step', unit=unit_length, low=0.0_wp, open=.true., high=deepest, default='30', &
         meaning='from one to the next; the last one is always solved'), &
      key_rule_type('uncertainty', 'friction', low=0.0_wp, high=roughest, &
         meaning='coefficient, axial and rotary, all along the hole; default those of the hole sections'), &
      key_rule_type('uncertainty', 'string', kind_text, default='main', meaning='name of the drillstring'), &
      key_rule_type('uncertainty', 'wob', unit=unit_force, array=.true., low=-strongest, high=strongest, default='0', &
         meaning='weight on bit, one of all operations or one of each; > 0 pushes the bit, < 0 pulls it'), &
      key_rule_type('uncertainty', 'tob', unit=unit_moment, array=.true., low=0.0_wp, high=strongest, default='0', &
         meaning='torque on bit, one of all operations or one of each'), &
      key_rule_type('uncertainty', 'model', kind_text, array=.true., choices='mcge soft rigid mixed', &
         meaning='one or several; default the models of &job'), &
      key_rule_type('uncertainty', 'rpm', unit=unit_rotation, array=.true., low=0.0_wp, high=1.0e4_wp, default='0', &
         meaning='rotation speed, for ream and backream; one or one of each operation'), &
      key_rule_type('uncertainty', 'trip_speed', unit=unit_speed, array=.true., low=0.0_wp, high=100.0_wp, default='0', &
         meaning='axial speed of the string, for ream and backream; one or one of each operation'), &
      key_rule_type('uncertainty', 'samples', kind_integer, default='1000', low=2.0_wp, high=1.0e6_wp, &
         meaning='number of random samples'), &
      key_rule_type('uncertainty', 'seed', kind_integer, default='1', low=0.0_wp, high=1.0e9_wp, &
         meaning='of the random numbers: the same seed gives the same results'), &
      key_rule_type('uncertainty', 'friction_deviation', low=0.0_wp, high=roughest, default='0', &
         meaning='standard deviation of the coefficients of all hole sections'), &
      key_rule_type('uncertainty', 'friction_correlation', low=0.0_wp, high=1.0_wp, default='1', &
         meaning='of two hole sections: 1 one error for the whole hole, 0 each section on its own'), &
      key_rule_type('uncertainty', 'friction_deviations', array=.true., low=0.0_wp, high=roughest, &
         meaning='in place of friction_deviation, one for each hole section, in the order of the deck'), &
      key_rule_type('uncertainty', 'friction_correlations', array=.true., low=-1.0_wp, high=1.0_wp, &
         meaning='in place of friction_correlation: of sections 1 and 2, 1 and 3, ..., 2 and 3, ...'), &
      key_rule_type('uncertainty', 'friction_parameter', kind_text, default='friction', &
         choices='friction friction_axial friction_rotary', meaning='which coefficients that is for: both alike, or one'), &
      key_rule_type('uncertainty', 'friction_from', kind_text, &
         meaning='name of a &calibrate with apply = .true.: deviations and correlations that it finds'), &
      key_rule_type('uncertainty', 'density_deviation', unit=unit_density, low=0.0_wp, high=heaviest, default='0', &
         meaning='standard deviation of the mud density'), &
      key_rule_type('uncertainty', 'inclination_deviation', unit=unit_angle, low=0.0_wp, high=30.0_wp, default='0', &
         meaning='standard deviation of the inclination of a station'), &
      key_rule_type('uncertainty', 'azimuth_deviation', unit=unit_angle, low=0.0_wp, high=30.0_wp, default='0', &
         meaning='standard deviation of the azimuth of a station'), &
      key_rule_type('uncertainty', 'survey_errors', kind_text, default='random', choices='random systematic', &
         meaning='each station is off on its own, or all alike'), &
      key_rule_type('uncertainty', 'hookload_deviation', unit=unit_force, low=0.0_wp, high=strongest, default='0', &
         meaning='standard deviation of the hook load gauge: quantiles are then those of what it shows'), &
      key_rule_type('uncertainty', 'torque_deviation', unit=unit_moment, low=0.0_wp, high=strongest, default='0', &
         meaning='standard deviation of the torque gauge')]
end module dg_uncertainty_keys

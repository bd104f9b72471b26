!> The group &sweep of a deck and its keys.
module dg_sweep_keys
   use dg_kinds, only: wp
   use dg_deck_keys, only: deepest, strongest, roughest
   use dg_deck_schema, only: group_rule_type, key_rule_type, kind_text
   use dg_unit_kind, only: unit_force, unit_length, unit_moment, unit_rotation, unit_speed
   implicit none
   private
   public :: sweep_rule, sweep_keys

   type(group_rule_type), parameter :: sweep_rule = &
      group_rule_type('sweep', repeatable=.true., own_cases=.true., &
                      meaning='hook load and torque against depth')

   type(key_rule_type), parameter :: sweep_keys(*) = [ &
      key_rule_type('sweep', 'name', kind_text, meaning='unique; letters, digits and _ - . +; default its number'), &
      key_rule_type('sweep', 'operations', kind_text, array=.true., choices='*', &
         meaning='default trip_out, trip_in, rotate_off_bottom'), &
      key_rule_type('sweep', 'bit_depth_from', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='first bit depth; at surface itself nothing is solved'), &
      key_rule_type('sweep', 'bit_depth_to', unit=unit_length, low=0.0_wp, open=.true., high=deepest, &
         meaning='last bit depth; default the end of survey or hole'), &
      key_rule_type('sweep', 'bit_depth_step', unit=unit_length, low=0.0_wp, open=.true., high=deepest, default='30', &
         meaning='distance between bit depths; the last one is always solved'), &
      key_rule_type('sweep', 'frictions', array=.true., low=0.0_wp, high=roughest, &
         meaning='friction factors of the whole hole, axial and rotary; default those of the hole sections'), &
      key_rule_type('sweep', 'string', kind_text, default='main', meaning='name of the drillstring'), &
      key_rule_type('sweep', 'wob', unit=unit_force, array=.true., low=-strongest, high=strongest, default='0', &
         meaning='weight on bit, one for all operations or one for each; > 0 pushes the bit, < 0 pulls it'), &
      key_rule_type('sweep', 'tob', unit=unit_moment, array=.true., low=0.0_wp, high=strongest, default='0', &
         meaning='torque on bit, one for all operations or one for each'), &
      key_rule_type('sweep', 'model', kind_text, array=.true., choices='mcge soft rigid mixed', &
         meaning='one or several models; default those of &job'), &
      key_rule_type('sweep', 'rpm', unit=unit_rotation, array=.true., low=0.0_wp, high=1.0e4_wp, default='0', &
         meaning='rotation speed, for ream and backream; one for all operations or one for each'), &
      key_rule_type('sweep', 'trip_speed', unit=unit_speed, array=.true., low=0.0_wp, high=100.0_wp, default='0', &
         meaning='axial speed of the string, for ream and backream; one for all operations or one for each'), &
      key_rule_type('sweep', 'measured_depths', unit=unit_length, array=.true., low=0.0_wp, open=.true., high=deepest, &
         meaning='bit depths of measurements for comparison; those of load cases are added'), &
      key_rule_type('sweep', 'measured_operations', kind_text, array=.true., choices='*', &
         meaning='operation of each measurement, or one for all'), &
      key_rule_type('sweep', 'measured_hookloads', unit=unit_force, array=.true., low=0.0_wp, high=strongest, &
         meaning='hook load of each measurement; 0: not measured'), &
      key_rule_type('sweep', 'measured_torques', unit=unit_moment, array=.true., low=0.0_wp, high=strongest, &
         meaning='torque of each measurement; 0: not measured'), &
      key_rule_type('sweep', 'frictions_cased', array=.true., low=0.0_wp, high=roughest, &
         meaning='in place of frictions: friction factors of cased sections, one for each of frictions_open'), &
      key_rule_type('sweep', 'frictions_open', array=.true., low=0.0_wp, high=roughest, &
         meaning='friction factors of the other hole sections')]
end module dg_sweep_keys

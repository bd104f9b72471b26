!> The group &calibrate of a deck and its keys.
module dg_calibrate_keys
   use dg_kinds, only: wp
   use dg_deck_keys, only: deepest, strongest
   use dg_deck_schema, only: group_rule_type, key_rule_type, kind_logical, kind_text
   use dg_unit_kind, only: unit_force, unit_length, unit_moment
   implicit none
   private
   public :: calibrate_rule, calibrate_keys

   type(group_rule_type), parameter :: calibrate_rule = &
      group_rule_type('calibrate', repeatable=.true., &
                      meaning='friction factors from measured hook load and torque')

   type(key_rule_type), parameter :: calibrate_keys(*) = [ &
      key_rule_type('calibrate', 'name', kind_text, meaning='unique; default its number'), &
      key_rule_type('calibrate', 'cases', kind_text, array=.true., &
         meaning='names of load cases; default all with measured_hookload or measured_torque, except cases held by a packer'), &
      key_rule_type('calibrate', 'parameter', kind_text, default='friction', &
         choices='friction friction_axial friction_rotary sticking free_point', meaning='the unknown'), &
      key_rule_type('calibrate', 'holes', kind_text, array=.true., &
         meaning='names of hole sections whose friction factor is fitted; default all'), &
      key_rule_type('calibrate', 'separate', kind_text, array=.true., choices='none holes operations depths', &
         meaning='one factor for all (none), or one for each of these; default holes'), &
      key_rule_type('calibrate', 'offset', kind_text, default='none', choices='none one depths', &
         meaning='also find the error of block_weight: one for all, or one per bit depth; '// &
         'added to it before sheave friction acts'), &
      key_rule_type('calibrate', 'model', kind_text, array=.true., choices='mcge soft rigid mixed', &
         meaning='one or several models; default soft'), &
      key_rule_type('calibrate', 'hookload_deviation', unit=unit_force, low=0.0_wp, open=.true., high=strongest, &
         meaning='standard deviation of a measured hook load; default: from the residuals'), &
      key_rule_type('calibrate', 'torque_deviation', unit=unit_moment, low=0.0_wp, open=.true., high=strongest, &
         meaning='standard deviation of a measured torque; default: from the residuals'), &
      key_rule_type('calibrate', 'sticking_depth', unit=unit_length, low=0.0_wp, open=.true., high=deepest, &
         meaning='measured depth of a stuck point or key seat; needed by sticking'), &
      key_rule_type('calibrate', 'stretch', unit=unit_length, low=0.0_wp, open=.true., high=1.0e3_wp, &
         meaning='stretch at surface between two pulls; needed by free_point'), &
      key_rule_type('calibrate', 'apply', kind_logical, default='.false.', &
         meaning='use the result in the rest of the run; with &rig, the one offset is added to block_weight'), &
      key_rule_type('calibrate', 'predict', kind_text, array=.true., &
         meaning='names of load cases to predict; their measurements are not fitted')]
end module dg_calibrate_keys

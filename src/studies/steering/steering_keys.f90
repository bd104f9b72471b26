!> The group &steering of a deck and its keys.
module dg_steering_keys
   use dg_kinds, only: wp
   use dg_deck_schema, only: group_rule_type, key_rule_type, kind_text
   use dg_unit_kind, only: unit_angle, unit_curvature, unit_diameter, unit_length
   implicit none
   private
   public :: steering_rule, steering_keys

   type(group_rule_type), parameter :: steering_rule = &
      group_rule_type('steering', &
                      meaning='bit side force, bit tilt, build rate and turn rate')

   type(key_rule_type), parameter :: steering_keys(*) = [ &
      key_rule_type('steering', 'cases', kind_text, array=.true., meaning='names of load cases; default all'), &
      key_rule_type('steering', 'toolfaces', unit=unit_angle, array=.true., low=-360.0_wp, high=360.0_wp, &
         meaning='toolfaces at which each case is solved; default the toolface of the case'), &
      key_rule_type('steering', 'length', unit=unit_length, low=10.0_wp, high=1.0e3_wp, default='150', &
         meaning='length of string above the bit that is solved'), &
      key_rule_type('steering', 'side_cutting', low=0.0_wp, open=.true., high=100.0_wp, &
         meaning='rate of side cutting divided by rate of face cutting; default: the curvature with zero side force'), &
      key_rule_type('steering', 'hole_enlargement', unit=unit_diameter, low=0.0_wp, high=200.0_wp, default='0', &
         meaning='enlargement of the hole diameter above the bit'), &
      key_rule_type('steering', 'measured_dogleg', unit=unit_curvature, array=.true., low=-60.0_wp, high=60.0_wp, &
         meaning='dogleg measured in a slide, towards the toolface; one, or one per case; finds the side_cutting for it')]
end module dg_steering_keys

!> The group &study of a deck and its keys.
module dg_study_keys
   use dg_kinds, only: wp
   use dg_deck_keys, only: stiffest, round_off
   use dg_deck_schema, only: group_rule_type, key_rule_type, kind_text
   use dg_unit_kind, only: unit_length, unit_wall
   implicit none
   private
   public :: study_rule, study_keys

   type(group_rule_type), parameter :: study_rule = &
      group_rule_type('study', &
                      meaning='accuracy and cost of every combination of the lists')

   type(key_rule_type), parameter :: study_keys(*) = [ &
      key_rule_type('study', 'cases', kind_text, array=.true., meaning='names of load cases; default all'), &
      key_rule_type('study', 'models', kind_text, array=.true., choices='mcge soft rigid mixed', &
         meaning='models; default those of &job; soft, rigid and mixed vary with element_lengths only'), &
      key_rule_type('study', 'element_lengths', unit=unit_length, array=.true., low=0.01_wp, high=1.0e3_wp, &
         meaning='longest elements; default that of &solver'), &
      key_rule_type('study', 'tolerances', array=.true., low=round_off, high=0.1_wp, meaning='default that of &solver'), &
      key_rule_type('study', 'wall_stiffnesses', unit=unit_wall, array=.true., low=0.0_wp, open=.true., high=stiffest, &
         meaning='wall stiffness of every hole section, gk_max in proportion; default as in &hole and &solver'), &
      key_rule_type('study', 'gap_locations', kind_text, array=.true., choices='extremum nodes', &
         meaning='default that of &solver'), &
      key_rule_type('study', 'linear_solvers', kind_text, array=.true., choices='block banded sparse', &
         meaning='default that of &solver'), &
      key_rule_type('study', 'fidelities', kind_text, array=.true., choices='auto fast standard reference', &
         meaning='fidelities to compare, in addition to element_lengths')]
end module dg_study_keys

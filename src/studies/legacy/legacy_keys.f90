!> The group &legacy of a deck and its keys.
module dg_legacy_keys
   use dg_kinds, only: wp
   use dg_deck_schema, only: group_rule_type, key_rule_type, kind_integer, kind_text
   use dg_quantity, only: deck_systems
   implicit none
   private
   public :: legacy_rule, legacy_keys

   type(group_rule_type), parameter :: legacy_rule = &
      group_rule_type('legacy', repeatable=.true., &
                      meaning='comparison with a table of another program')

   type(key_rule_type), parameter :: legacy_keys(*) = [ &
      key_rule_type('legacy', 'label', kind_text, required=.true., meaning='unique; letters, digits and _ - . +'), &
      key_rule_type('legacy', 'file', kind_text, required=.true., meaning='table of results; path relative to the deck'), &
      key_rule_type('legacy', 'case', kind_text, required=.true., meaning='name of the load case to compare with'), &
      key_rule_type('legacy', 'units', kind_text, choices=deck_systems, meaning='unit system of the file; default that of the '// &
      'deck'), &
      key_rule_type('legacy', 'skip', kind_integer, default='0', low=0.0_wp, high=1.0e6_wp, &
         meaning='number of lines above the headings'), &
      key_rule_type('legacy', 'md', kind_text, default='md', &
         meaning='column of measured depth: heading, number of the column, or first and last character ''1:10'''), &
      key_rule_type('legacy', 'axial', kind_text, &
         meaning='column of effective (buoyed) axial force, tension positive; default axial'), &
      key_rule_type('legacy', 'torque', kind_text, meaning='column of torque; default torque'), &
      key_rule_type('legacy', 'side_force', kind_text, meaning='column of contact force per length; default side_force'), &
      key_rule_type('legacy', 'md_unit', kind_text, meaning='unit of md, where not that of units: m, ft'), &
      key_rule_type('legacy', 'axial_unit', kind_text, meaning='unit of axial: N, daN, kN, kdaN, t, lbf, klbf, kip'), &
      key_rule_type('legacy', 'torque_unit', kind_text, meaning='unit of torque: N.m, kN.m, ft.lbf, kft.lbf'), &
      key_rule_type('legacy', 'side_force_unit', kind_text, meaning='unit of side_force: N/m, kN/m, kdaN/m, lbf/ft, klbf/ft')]
end module dg_legacy_keys

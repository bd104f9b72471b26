!> What a component has beside pipe: a bent housing, pads, a survey sensor, a fatigue curve.
module dg_deck_tools
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, real_of, text_of
   use dg_component, only: component_type
   use dg_fatigue_curve, only: fatigue_curve_name, fatigue_curve_type, fatigue_own
   use dg_fault_list, only: fault_list_type
   use dg_kinds, only: wp
   implicit none
   private
   public :: draft_tools

contains

   !> Takes them from a group. A bend and pads say where they are.
   subroutine draft_tools(group, part, faults)
      type(checked_group_type), intent(in) :: group
      type(component_type), intent(inout) :: part
      type(fault_list_type), intent(inout) :: faults
      part%sensor = real_of(group, 'sensor', part%sensor)
      part%bend = real_of(group, 'bend', part%bend)
      part%bend_position = real_of(group, 'bend_position', part%bend_position)
      if (part%bend > 0.0_wp .and. .not. is_given(group, 'bend_position')) &
         call group_fault(group, 'bend', 'bend needs bend_position, its distance above the lower end of the component', faults)
      part%pad_force = real_of(group, 'pad_force', part%pad_force)
      part%pad_clock = real_of(group, 'pad_clock', part%pad_clock)
      part%pad_position = real_of(group, 'pad_position', part%pad_position)
      if (part%pad_force > 0.0_wp .and. .not. is_given(group, 'pad_position')) &
         call group_fault(group, 'pad_force', 'pad_force needs pad_position, its distance above the lower end of the '// &
                          'component', faults)
      call draft_fatigue(group, part%fatigue)
      if (part%fatigue%curve == fatigue_own .and. .not. is_given(group, 'fatigue_limit')) &
         call group_fault(group, 'fatigue_curve', "fatigue_curve = 'own' needs fatigue_limit", faults)
      if (part%fatigue%curve /= fatigue_own .and. is_sound(group, 'fatigue_limit')) &
         call group_fault(group, 'fatigue_limit', "fatigue_limit needs fatigue_curve = 'own'", faults)
   end subroutine draft_tools

   !> A fatigue curve by name, or an own one.
   subroutine draft_fatigue(group, fatigue)
      type(checked_group_type), intent(in) :: group
      type(fatigue_curve_type), intent(inout) :: fatigue
      if (is_sound(group, 'fatigue_curve')) &
         fatigue%curve = findloc(fatigue_curve_name == text_of(group, 'fatigue_curve', 'none'), .true., dim=1)
      fatigue%limit = real_of(group, 'fatigue_limit', fatigue%limit)
      fatigue%tensile = real_of(group, 'tensile_strength', fatigue%tensile)
      fatigue%share = real_of(group, 'fatigue_share', fatigue%share)
      fatigue%exponent = real_of(group, 'fatigue_exponent', fatigue%exponent)
      fatigue%turns = real_of(group, 'fatigue_turns', fatigue%turns)
   end subroutine draft_fatigue
end module dg_deck_tools

!> limits.csv: limits of the string as a whole, one row per case and model.
module dg_limits_file
   use dg_findings, only: findings_type, name_of
   use dg_named_states, only: buckling_name
   use dg_case_result, only: case_result_type, has_numbers, result_status_name
   use dg_column, only: field_absent, add, add_filled, quantity_angle, quantity_curvature, quantity_force, &
                        quantity_length, quantity_line_load, quantity_moment, quantity_none, quantity_percent, &
                        quantity_pressure, quantity_stress, quantity_text, quantity_turns, quantity_width, row_type
   use dg_comparison, only: in_percent, percent_of
   use dg_csv_table, only: add_row, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: model_name
   use dg_length_change, only: total_change
   use dg_missing, only: given, is_missing, optional_real
   use dg_utilisation, only: governing_name, limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse, &
                             limit_joint_compression, limit_joint_dogleg, limit_joint_tension, limit_joint_torsion, &
                             limit_makeup, limit_rig, limit_slips, limit_tension, limit_top_drive, limit_torsion, &
                             limit_von_mises
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: write_limits, limits_row

contains

   !> Writes limits.csv to `path`: a row a result, empty but for its status where that did not converge.
   subroutine write_limits(path, found, error)
      character(*), intent(in) :: path
      type(findings_type), intent(in) :: found
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      integer :: i
      do i = 1, size(found%results)
         call add_row(table, limits_row(name_of(found, i), found%results(i), found%wholes(i)), found%job%units)
      end do
      call write_table(table, path, error)
   end subroutine write_limits

   !> A result in the columns of limits.csv. New columns are put at the end only.
   pure function limits_row(name, result, whole) result(row)
      character(*), intent(in) :: name    !< of the load case
      type(case_result_type), intent(in) :: result
      type(whole_string_type), intent(in) :: whole
      type(row_type) :: row
      call add(row, 'case', quantity_text, 'name of the load case', name)
      call add(row, 'model', quantity_text, 'name of the model', model_name(result%model))
      call add(row, 'status', quantity_text, &
               'as in summary.csv; not_converged: the other columns are empty', &
               result_status_name(result%status))
      call add_margins(row, whole)
      call add_shape(row, whole)
      call add_used(row, whole)
      call add_changes(row, whole)
      call add_ratings(row, whole)
      if (.not. has_numbers(result%status)) row%fields(4:)%kind = field_absent
   end function limits_row

   !> Stretch, strength, buckling by formula, rig and connections.
   pure subroutine add_margins(row, whole)
      type(row_type), intent(inout) :: row
      type(whole_string_type), intent(in) :: whole
      type(optional_real) :: first_neutral, last_neutral
      integer :: points
      points = 0
      if (allocated(whole%neutral_points)) points = size(whole%neutral_points)
      if (points > 0) then
         first_neutral = given(whole%neutral_points(1))
         last_neutral = given(whole%neutral_points(points))
      end if
      call add(row, 'stretch', quantity_length, 'stretch of the string by effective axial force', whole%stretch)
      call add(row, 'pressure_stretch', quantity_length, &
               'stretch of the string by pressure inside and outside, not in stretch', whole%pressure_stretch)
      call add(row, 'windup', quantity_turns, 'twist of the string: turns of the top against the bit', whole%windup)
      call add(row, 'neutral_points', quantity_none, 'number of neutral points: effective axial force changes sign', points)
      call add(row, 'neutral_top', quantity_length, 'depth of the uppermost neutral point', first_neutral)
      call add(row, 'neutral_bottom', quantity_length, 'depth of the lowest neutral point', last_neutral)
      call add(row, 'least_safety_factor', quantity_none, 'least safety factor along the string, yield over von Mises stress; '// &
               'without bending between tool joints; empty without yield', whole%least_safety)
      call add(row, 'least_safety_md', quantity_length, 'measured depth of this value', whole%least_safety_md)
      call add(row, 'least_envelope_margin', quantity_none, &
               'least envelope_margin along the string', whole%least_envelope_margin)
      call add(row, 'overpull_margin', quantity_force, &
               'pull that may be added at the top until von Mises stress or tension reaches its limit, design factors '// &
               'included, if all of it reached the weakest place; without bending between tool joints; negative: passed '// &
               'already', whole%overpull_margin)
      call add(row, 'buckling', quantity_text, &
               'worst state along the string: none, sinusoidal or helical', buckling_name(whole%buckling))
      call add(row, 'buckling_margin', quantity_force, &
               'least buckling_margin along the string; negative: buckled', whole%buckling_margin)
      call add(row, 'buckling_margin_md', quantity_length, 'measured depth of this value', whole%buckling_margin_md)
      call add(row, 'sinusoidal_length', quantity_length, &
               'length of sinusoidal buckling, by published loads', whole%sinusoidal_length)
      call add(row, 'helical_length', quantity_length, &
               'length of helical buckling, by the lower published load', whole%helical_length)
      call add(row, 'largest_side_force', quantity_line_load, &
               'largest mean over a joint of pipe (joint_spacing of the longest component with joints, else 9.5 m)', &
               whole%side_force)
      call add(row, 'largest_side_force_md', quantity_length, &
               'depth of the row with the most side force within that length', whole%side_force_md)
      call add(row, 'wob_buckling', quantity_force, &
               'weight on bit at which buckling begins (soft string); 0: buckles without WOB; empty for operations that pull', &
               whole%wob_buckling)
      call add(row, 'wob_no_hookload', quantity_force, &
               'weight on bit at zero hook load (soft string, without friction of helical buckling)', whole%wob_no_hookload)
      call add(row, 'rig_limit', quantity_force, 'max_hookload of &rig, or rig_limit of &job', whole%rig_limit)
      call add(row, 'rig_margin', quantity_force, 'rig_limit - hook load - block_weight of &rig', whole%rig_margin)
      call add(row, 'makeup_margin', quantity_moment, &
               'make-up torque - torque, least along the string; empty without make-up torque', whole%makeup_margin)
      call add(row, 'makeup_margin_md', quantity_length, 'measured depth of this value', whole%makeup_margin_md)
      call add(row, 'wob_lockup', quantity_force, &
               'weight on bit at zero hook load, with friction of helical buckling and max_push of &rig: by beams where a '// &
               'buckled string slides near it, else with all friction times the factor that gives the hook load of mcge', &
               whole%wob_lockup)
   end subroutine add_margins

   !> Add results of gap elements: buckled shape, bit, bending.
   pure subroutine add_shape(row, whole)
      type(row_type), intent(inout) :: row
      type(whole_string_type), intent(in) :: whole
      call add(row, 'shape', quantity_text, &
               'buckled shape found by mcge: none, sinusoidal or helical', buckling_name(whole%shape))
      call add(row, 'snaking_length', quantity_length, 'sinusoidally buckled length', whole%snaking_length)
      call add(row, 'coiled_length', quantity_length, 'helically buckled length', whole%coiled_length)
      call add(row, 'coil_turns', quantity_none, 'turns of the helix', whole%coil_turns)
      call add(row, 'stability_margin', quantity_none, &
               'part by which compression may grow until the shape changes, 1 if more; 0: a buckled shape that can shift '// &
               'along the hole; empty: too little compression', whole%stability_margin)
      call add(row, 'bit_side_force', quantity_force, &
               'side force of the bit on the formation; mcge, or mixed with elements at the bit; for a centred bit; empty for '// &
               'a bent housing that turns, see &steering', &
               whole%bit_side_force)
      call add(row, 'bit_side_clock', quantity_angle, 'direction of bit_side_force, as clock in the profiles', whole%bit_side_clock)
      call add(row, 'bit_tilt', quantity_angle, 'angle between bit and hole axis; models as for bit_side_force', whole%bit_tilt)
      call add(row, 'bit_tilt_clock', quantity_angle, 'direction in which the bit points', whole%bit_tilt_clock)
      call add(row, 'largest_bending', quantity_moment, 'largest bending moment along the string', whole%bending)
      call add(row, 'largest_bending_md', quantity_length, 'measured depth of this value', whole%bending_md)
      call add(row, 'bending_error', quantity_percent, &
               'estimated error of bending moments in percent of the largest: difference of two recoveries or two meshes, '// &
               'plus 0.5 %; empty if not solved on shorter elements', in_percent(whole%bending_error))
      call add(row, 'largest_von_mises', quantity_stress, &
               'largest von Mises stress along the string, without bending between tool joints', whole%von_mises)
      call add(row, 'von_mises_error', quantity_percent, &
               'estimated error of largest_von_mises, from bending_error', in_percent(whole%von_mises_error))
      call add(row, 'wob_yield', quantity_force, &
               'weight on bit at which a compressed part of the string yields, bending and helical buckling included; empty '// &
               'if it locks up first', whole%wob_yield)
      call add(row, 'least_standoff', quantity_percent, &
               'least standoff of the body along the string; mcge only', in_percent(whole%least_standoff))
      call add(row, 'least_standoff_md', quantity_length, 'measured depth of this value', whole%least_standoff_md)
   end subroutine add_shape

   !> Add the utilisation of each strength, and the largest.
   pure subroutine add_used(row, whole)
      type(row_type), intent(inout) :: row
      type(whole_string_type), intent(in) :: whole
      type(optional_real) :: used(size(whole%utilisation%used)), governing_used, governing_md
      used = in_percent(whole%utilisation%used)
      if (whole%utilisation%governing > 0) then
         governing_used = used(whole%utilisation%governing)
         governing_md = whole%utilisation%md(whole%utilisation%governing)
      end if
      call add(row, 'used_von_mises', quantity_percent, &
               'von Mises stress, with bending between tool joints, in percent of yield. Columns used_...: largest along '// &
               'the string, design factors included, empty if the strength is not known', used(limit_von_mises))
      call add(row, 'used_tension', quantity_percent, 'tension in percent of the tensile strength of the body', used(limit_tension))
      call add(row, 'used_torsion', quantity_percent, &
               'torque in percent of the torsional strength of the body', used(limit_torsion))
      call add(row, 'used_joint_torsion', quantity_percent, 'torque in percent of joint_torsion', used(limit_joint_torsion))
      call add(row, 'used_makeup', quantity_percent, 'torque in percent of the make-up torque', used(limit_makeup))
      call add(row, 'used_burst', quantity_percent, 'burst pressure in percent of the burst strength', used(limit_burst))
      call add(row, 'used_collapse', quantity_percent, &
               'collapse pressure in percent of the collapse strength under tension', used(limit_collapse))
      call add(row, 'used_slips', quantity_percent, &
               'hook load and weight on bit in percent of the load that crushes the pipe in slips; not with a pull at the '// &
               'bit', used(limit_slips))
      call add(row, 'used_rig', quantity_percent, 'hook load with block in percent of the limit of the rig', used(limit_rig))
      call add_filled(row, 'governing_limit', quantity_text, &
                      'most used of these limits', governing_name(whole%utilisation))
      call add(row, 'governing_utilisation', quantity_percent, 'used part of governing_limit', governing_used)
      call add(row, 'governing_md', quantity_length, 'measured depth of this value', governing_md)
      call add(row, 'contact_difference', quantity_percent, &
               'uncertainty of contact force, in percent of normal_force: largest difference over a part of the string '// &
               'between long elements (hook load) and short ones (moments)', &
               in_percent(whole%contact_difference))
      call add(row, 'used_top_drive', quantity_percent, &
               'torque at the top of a rotating string in percent of max_torque of &rig', used(limit_top_drive))
      call add(row, 'sag_correction', quantity_angle, &
               'add this to the inclination of the survey sensor to get that of the hole; positive: the sensor reads too '// &
               'little; mcge with sensor', whole%sag_correction)
   end subroutine add_used

   !> Change of length, wear of casing, fatigue.
   pure subroutine add_changes(row, whole)
      type(row_type), intent(inout) :: row
      type(whole_string_type), intent(in) :: whole
      associate (change => whole%length_change, groove => whole%groove, fatigue => whole%fatigue)
         call add(row, 'length_change_force', quantity_length, &
                  'change of length by true axial force (Hooke). All changes: longer is positive; against the case of '// &
                  'length_reference, else against the string before it was run; empty if not asked for', &
                  optional_real(change%present, change%force))
         call add(row, 'length_change_pressure', quantity_length, &
                  'change of length by ballooning', optional_real(change%present, change%pressure))
         call add(row, 'length_change_buckling', quantity_length, &
                  'change of length by buckling', optional_real(change%present, change%buckling))
         call add(row, 'length_change_temperature', quantity_length, &
                  'change of length by temperature', optional_real(change%present, change%temperature))
         call add(row, 'length_change', quantity_length, &
                  'sum of the four changes of length', optional_real(change%present, total_change(change)))
         call add(row, 'packer_force', quantity_force, &
                  'force of the string on its packer without pressure; weight set down is positive; if packer_hold holds the '// &
                  'string', whole%packer_force)
         call add(row, 'casing_wear', quantity_width, &
                  'depth of the worst groove in the casing. Columns casing_...: for rotating cases with hours and wear_factor', &
                  optional_real(groove%present, groove%depth))
         call add(row, 'casing_wear_md', quantity_length, 'measured depth of this value', optional_real(groove%present, groove%md))
         call add(row, 'casing_wall_left', quantity_percent, &
                  'remaining wall at that depth, of the new wall', in_percent(optional_real(groove%present, groove%wall_left)))
         call add(row, 'casing_burst_left', quantity_pressure, &
                  'burst strength at that depth (Barlow, 7/8 of the remaining wall)', &
                  optional_real(groove%present .and. .not. is_missing(groove%burst), groove%burst))
         call add(row, 'casing_collapse_left', quantity_pressure, &
                  'collapse strength at that depth without tension (API 5C3)', &
                  optional_real(groove%present .and. .not. is_missing(groove%collapse), groove%collapse))
         call add(row, 'fatigue_used', quantity_percent, &
                  'bending stress in percent of the endurance limit of the body under its tension, largest along the string. '// &
                  'Columns fatigue_...: for rotating cases with fatigue_curve', &
                  in_percent(optional_real(fatigue%present, fatigue%used)))
         call add(row, 'fatigue_md', quantity_length, 'measured depth of this value', optional_real(fatigue%present, fatigue%md))
         call add(row, 'fatigue_turns', quantity_none, &
                  'turns until failure at that depth; empty below the endurance limit, or without fatigue_exponent', fatigue%turns)
         call add(row, 'fatigue_damage', quantity_percent, &
                  'part of the life at that depth used by the hours of rotation', percent_of(fatigue%damage))
         call add(row, 'fatigue_dogleg', quantity_curvature, &
                  'largest dogleg at that depth for rotation without fatigue under the tension there (Lubinski 1961)', &
                  fatigue%dogleg)
      end associate
   end subroutine add_changes

   !> Yield strength by temperature; ratings and fatigue of the connections.
   pure subroutine add_ratings(row, whole)
      type(row_type), intent(inout) :: row
      type(whole_string_type), intent(in) :: whole
      type(optional_real) :: used(size(whole%utilisation%used))
      used = in_percent(whole%utilisation%used)
      call add(row, 'yield_left', quantity_percent, &
               'yield strength in percent of that at ambient temperature, least along the string; empty if the string is not '// &
               'warmer', &
               in_percent(whole%yield_left))
      call add(row, 'used_joint_tension', quantity_percent, &
               'largest tensile stress, bending included, in percent of the tensile strength of connections; needs '// &
               'tension_efficiency', used(limit_joint_tension))
      call add(row, 'used_joint_compression', quantity_percent, 'largest compressive stress, bending included, in percent of '// &
               'the compressive strength of connections; needs compression_efficiency', used(limit_joint_compression))
      call add(row, 'used_joint_burst', quantity_percent, &
               'burst pressure in percent of the burst strength of connections', used(limit_joint_burst))
      call add(row, 'used_joint_collapse', quantity_percent, &
               'collapse pressure in percent of the collapse strength of connections under tension', used(limit_joint_collapse))
      call add(row, 'used_joint_dogleg', quantity_percent, &
               'curvature of the pipe in percent of joint_dogleg', used(limit_joint_dogleg))
      associate (fatigue => whole%joint_fatigue)
         call add(row, 'joint_fatigue_used', quantity_percent, &
                  'bending stress in percent of the endurance limit of connections, largest along the string. Columns '// &
                  'joint_fatigue_...: for rotating cases with joint_fatigue_limit', &
                  in_percent(optional_real(fatigue%present, fatigue%used)))
         call add(row, 'joint_fatigue_md', quantity_length, &
                  'measured depth of this value', optional_real(fatigue%present, fatigue%md))
         call add(row, 'joint_fatigue_turns', quantity_none, 'turns until failure at that depth', fatigue%turns)
         call add(row, 'joint_fatigue_damage', quantity_percent, &
                  'part of the life at that depth used by the hours of rotation', percent_of(fatigue%damage))
         call add(row, 'joint_fatigue_dogleg', quantity_curvature, &
                  'largest dogleg at that depth for rotation without fatigue of the connection', fatigue%dogleg)
      end associate
      call add(row, 'shape_from', quantity_length, 'first depth that is buckled by mcge', whole%shape_span(1))
      call add(row, 'shape_to', quantity_length, 'last depth that is buckled by mcge', whole%shape_span(2))
   end subroutine add_ratings
end module dg_limits_file

!> limits.csv: what limits the string as a whole, one row a case and model.
module dg_limits_file
   use dg_named_states, only: buckling_name
   use dg_case_result, only: case_result_type, has_numbers, result_status_name
   use dg_column, only: column_type, field_list_type, put, put_none, quantity_angle, quantity_curvature, quantity_force, &
                        quantity_length, quantity_line_load, quantity_moment, quantity_none, quantity_percent, &
                        quantity_pressure, quantity_stress, quantity_text, quantity_turns, quantity_width
   use dg_comparison, only: in_percent
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: job_type, model_name
   use dg_length_change, only: total_change
   use dg_load_case, only: optional_real
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_utilisation, only: governing_name, limit_rig, limit_top_drive
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: write_limits, limits_columns, limits_fields

   !> New ones are added at the end only.
   type(column_type), parameter :: limits_columns(75) = [ &
      column_type('case', quantity_text, 'name of the load case'), &
      column_type('model', quantity_text, 'name of the model'), &
      column_type('status', quantity_text, 'as in summary.csv: only converged is a solution; not_converged: all that follows '// &
         'is empty'), &
      column_type('stretch', quantity_length, 'of the string by the effective axial force'), &
      column_type('pressure_stretch', quantity_length, 'of the string by the pressures inside and outside, not in stretch'), &
      column_type('windup', quantity_turns, 'turn of the top against the bit'), &
      column_type('neutral_points', quantity_none, 'places where the effective axial force changes sign'), &
      column_type('neutral_top', quantity_length, 'depth of the uppermost of them'), &
      column_type('neutral_bottom', quantity_length, 'depth of the lowest'), &
      column_type('least_safety_factor', quantity_none, 'along the string; empty where no yield is given'), &
      column_type('least_safety_md', quantity_length, 'where'), &
      column_type('least_envelope_margin', quantity_none, 'of the tension-torque envelope, bending included, along the string'), &
      column_type('overpull_margin', quantity_force, 'pull that may be added at the top before von Mises'' stress '// &
         'reaches yield, bending included, if all of it arrived at the weakest place; negative where it yields already'), &
      column_type('buckling', quantity_text, 'worst state along the string: none, sinusoidal or helical'), &
      column_type('buckling_margin', quantity_force, 'least along the string; negative where it is buckled'), &
      column_type('buckling_margin_md', quantity_length, 'where'), &
      column_type('sinusoidal_length', quantity_length, 'of string buckled into a sine'), &
      column_type('helical_length', quantity_length, 'of string beyond the lower helical limit'), &
      column_type('largest_side_force', quantity_line_load, 'along the string'), &
      column_type('largest_side_force_md', quantity_length, 'where'), &
      column_type('wob_buckling', quantity_force, 'weight on bit at which the string begins to buckle somewhere (soft string); '// &
         '0: it does without any; empty for operations that pull'), &
      column_type('wob_no_hookload', quantity_force, 'weight on bit that leaves no hook load (soft string, friction of '// &
         'buckled string left out: a bound of the lock-up load)'), &
      column_type('rig_limit', quantity_force, 'as in the deck'), &
      column_type('rig_margin', quantity_force, 'rig_limit - hook load - block_weight of &rig'), &
      column_type('makeup_margin', quantity_moment, 'least make-up torque of a connection - torque there; empty where none '// &
         'is given'), &
      column_type('makeup_margin_md', quantity_length, 'where'), &
      column_type('wob_lockup', quantity_force, 'as wob_no_hookload, with the friction of a coiled string: about the most '// &
         'that reaches the bit without a push'), &
      column_type('shape', quantity_text, 'what the string was found to do by mcge: none, sinusoidal (it snakes) or helical'), &
      column_type('snaking_length', quantity_length, 'of string found to snake'), &
      column_type('coiled_length', quantity_length, 'of string found to coil'), &
      column_type('coil_turns', quantity_none, 'turns of its coils'), &
      column_type('stability_margin', quantity_none, 'part by which compression could still grow before the string leaves its '// &
         'shape; 1 stands for more, 0 for a snake or coil that could be shifted freely, empty where it is not compressed enough'), &
      column_type('bit_side_force', quantity_force, 'across the hole, of the bit on the formation; mcge, or mixed with '// &
         'elements at the bit, where the bit is centred'), &
      column_type('bit_side_clock', quantity_angle, 'where to, as clock in the profiles'), &
      column_type('bit_tilt', quantity_angle, 'between bit and hole axis; the same models'), &
      column_type('bit_tilt_clock', quantity_angle, 'where the bit points'), &
      column_type('largest_bending', quantity_moment, 'moment along the string'), &
      column_type('largest_bending_md', quantity_length, 'where'), &
      column_type('bending_error', quantity_percent, 'how far moments may be off, of the largest: what two recoveries or two '// &
         'meshes differ by, and half a per cent; empty where they were not looked at closely'), &
      column_type('largest_von_mises', quantity_stress, 'equivalent stress along the string'), &
      column_type('von_mises_error', quantity_percent, 'how far it may be off for that'), &
      column_type('wob_yield', quantity_force, 'weight on bit at which a compressed part of the string yields, bending and '// &
         'coils included; empty where it is locked up before'), &
      column_type('least_standoff', quantity_percent, 'of the body, along the string; mcge alone'), &
      column_type('least_standoff_md', quantity_length, 'where'), &
      column_type('used_von_mises', quantity_percent, 'of the yield strength by von Mises'' stress, with its design factor; '// &
         'this and those that follow: most along the string, empty where the strength is not known'), &
      column_type('used_tension', quantity_percent, 'of the tensile strength of the body'), &
      column_type('used_torsion', quantity_percent, 'of the torsional strength of the body'), &
      column_type('used_joint_torsion', quantity_percent, 'of the torque at which a connection yields'), &
      column_type('used_makeup', quantity_percent, 'of the make-up torque'), &
      column_type('used_burst', quantity_percent, 'of the burst strength'), &
      column_type('used_collapse', quantity_percent, 'of the collapse strength under the tension there'), &
      column_type('used_slips', quantity_percent, 'of what slips may hold without crushing the pipe, by the hook load'), &
      column_type('used_rig', quantity_percent, 'of rig_limit, by hook load and block_weight of &rig'), &
      column_type('governing_limit', quantity_text, 'the one of these that is used most'), &
      column_type('governing_utilisation', quantity_percent, 'how much of it'), &
      column_type('governing_md', quantity_length, 'where'), &
      column_type('contact_difference', quantity_percent, 'by how much the contact force of a part of the string differs '// &
         'between the long elements of hook load and the short ones of moments, of the contact force of the whole '// &
         'string; the largest of all parts'), &
      column_type('used_top_drive', quantity_percent, 'of max_torque of &rig, by the torque at the top of a string that turns'), &
      column_type('sag_correction', quantity_angle, 'to be added to the inclination that the survey sensor reads, so that it '// &
         'is that of the hole axis; positive where the sensor reads too little; mcge with sensor'), &
      column_type('length_change_force', quantity_length, 'by the true axial force (Hooke). All changes of length: longer is '// &
         'positive. Against the case of length_reference, else the string before it was run. Empty where not asked for'), &
      column_type('length_change_pressure', quantity_length, 'by ballooning'), &
      column_type('length_change_buckling', quantity_length, 'by the buckled shape'), &
      column_type('length_change_temperature', quantity_length, 'by the change of temperature'), &
      column_type('length_change', quantity_length, 'sum of the four'), &
      column_type('packer_force', quantity_force, 'of the string on its packer, beside that of the pressures: weight set '// &
         'down is positive; found where packer_hold holds the string'), &
      column_type('casing_wear', quantity_width, 'depth of the groove in casing that leaves the least part of its wall; this '// &
         'and those that follow: in cases that turn for hours, where wear_factor is given'), &
      column_type('casing_wear_md', quantity_length, 'where'), &
      column_type('casing_wall_left', quantity_percent, 'there, of the wall as it was new'), &
      column_type('casing_burst_left', quantity_pressure, 'burst strength there (Barlow, 7/8 of the wall left)'), &
      column_type('casing_collapse_left', quantity_pressure, 'collapse strength there without tension (API 5C3)'), &
      column_type('fatigue_used', quantity_percent, 'of the bending amplitude that the body bears without end at its tension, '// &
         'most along the string; this and those that follow: in cases that turn, where fatigue_curve is given'), &
      column_type('fatigue_md', quantity_length, 'where'), &
      column_type('fatigue_turns', quantity_none, 'until failure there; empty where endless, or without fatigue_exponent'), &
      column_type('fatigue_damage', quantity_percent, 'part of the life there that hours of rotation take'), &
      column_type('fatigue_dogleg', quantity_curvature, 'largest dogleg in which the pipe there may turn without end at its '// &
         'tension (Lubinski 1961)')]

contains

   !> Writes limits.csv to `path`: a row a result, empty but for its status where that did not converge.
   subroutine write_limits(path, job, model, results, wholes, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)   !< as many
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call begin_table(table, limits_columns, job%units)
      do i = 1, size(results)
         call limits_fields(model%cases(results(i)%case_index)%name, results(i), wholes(i), row)
         call add_row(table, row)
      end do
      call write_table(table, path, error)
   end subroutine write_limits

   !> Values of one result in the order of the columns.
   pure subroutine limits_fields(name, result, whole, row)
      character(*), intent(in) :: name    !< of the load case
      type(case_result_type), intent(in) :: result
      type(whole_string_type), intent(in) :: whole
      type(field_list_type), intent(out) :: row
      integer :: points, i
      points = 0
      if (allocated(whole%neutral_points)) points = size(whole%neutral_points)
      call put(row, name)
      call put(row, trim(model_name(result%model)))
      call put(row, trim(result_status_name(result%status)))
      if (.not. has_numbers(result%status)) then
         do while (row%count < size(limits_columns))
            call put_none(row)
         end do
         return
      end if
      call put(row, whole%stretch)
      call put(row, whole%pressure_stretch)
      call put(row, whole%windup)
      call put(row, points)
      if (points > 0) then
         call put(row, whole%neutral_points(1))
         call put(row, whole%neutral_points(points))
      else
         call put_none(row)
         call put_none(row)
      end if
      call put(row, whole%least_safety)
      call put(row, whole%least_safety_md)
      call put(row, whole%least_envelope_margin)
      call put(row, whole%overpull_margin)
      call put(row, trim(buckling_name(whole%buckling)))
      call put(row, whole%buckling_margin)
      call put(row, whole%buckling_margin_md)
      call put(row, whole%sinusoidal_length)
      call put(row, whole%helical_length)
      call put(row, whole%side_force)
      call put(row, whole%side_force_md)
      call put(row, whole%wob_buckling)
      call put(row, whole%wob_no_hookload)
      call put(row, whole%rig_limit)
      call put(row, whole%rig_margin)
      call put(row, whole%makeup_margin)
      call put(row, whole%makeup_margin_md)
      call put(row, whole%wob_lockup)
      call put(row, trim(buckling_name(whole%shape)))
      call put(row, whole%snaking_length)
      call put(row, whole%coiled_length)
      call put(row, whole%coil_turns)
      call put(row, whole%stability_margin)
      call put(row, whole%bit_side_force)
      call put(row, whole%bit_side_clock)
      call put(row, whole%bit_tilt)
      call put(row, whole%bit_tilt_clock)
      call put(row, whole%bending)
      call put(row, whole%bending_md)
      call put(row, in_percent(whole%bending_error))
      call put(row, whole%von_mises)
      call put(row, in_percent(whole%von_mises_error))
      call put(row, whole%wob_yield)
      call put(row, in_percent(whole%least_standoff))
      call put(row, whole%least_standoff_md)
      associate (most => whole%utilisation)
         do i = 1, limit_rig
            call put(row, in_percent(most%used(i)))
         end do
         if (most%governing > 0) then
            call put(row, trim(governing_name(most)))
            call put(row, in_percent(most%used(most%governing)))
            call put(row, most%md(most%governing))
         else
            do i = 1, 3
               call put_none(row)
            end do
         end if
      end associate
      call put(row, in_percent(whole%contact_difference))
      call put(row, in_percent(whole%utilisation%used(limit_top_drive)))
      call put(row, whole%sag_correction)
      associate (change => whole%length_change)
         call put(row, optional_real(change%present, change%force))
         call put(row, optional_real(change%present, change%pressure))
         call put(row, optional_real(change%present, change%buckling))
         call put(row, optional_real(change%present, change%temperature))
         call put(row, optional_real(change%present, total_change(change)))
      end associate
      call put(row, whole%packer_force)
      associate (groove => whole%groove)
         call put(row, optional_real(groove%present, groove%depth))
         call put(row, optional_real(groove%present, groove%md))
         call put(row, in_percent(optional_real(groove%present, groove%wall_left)))
         call put(row, optional_real(groove%present .and. .not. is_missing(groove%burst), groove%burst))
         call put(row, optional_real(groove%present .and. .not. is_missing(groove%collapse), groove%collapse))
      end associate
      associate (fatigue => whole%fatigue)
         call put(row, in_percent(optional_real(fatigue%present, fatigue%used)))
         call put(row, optional_real(fatigue%present, fatigue%md))
         call put(row, optional_real(.not. is_missing(fatigue%turns), fatigue%turns))
         call put(row, in_percent(optional_real(.not. is_missing(fatigue%damage), fatigue%damage)))
         call put(row, optional_real(.not. is_missing(fatigue%dogleg), fatigue%dogleg))
      end associate
   end subroutine limits_fields
end module dg_limits_file

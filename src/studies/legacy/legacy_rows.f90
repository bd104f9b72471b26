!> legacy_<label>.csv: another program's results beside ours, one row a model and depth.
module dg_legacy_rows
   use dg_column, only: put, quantity_force, quantity_length, quantity_line_load, quantity_moment, quantity_text, &
                        row_type
   use dg_comparison, only: difference
   use dg_hole_interval, only: interval_at, interval_name
   use dg_job, only: model_name
   use dg_kinds, only: wp
   use dg_legacy_comparison, only: comparison_type, quantity_axial, quantity_side_force, quantity_torque
   use dg_missing, only: missing
   implicit none
   private
   public :: legacy_row, row_of_depth

contains

   !> A depth of a comparison in the columns of the file.
   pure function row_of_depth(case_name, model, comparison, number) result(row)
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      type(comparison_type), intent(in) :: comparison
      integer, intent(in) :: number                       !< of the depth
      type(row_type) :: row
      associate (md => comparison%md(number), intervals => comparison%intervals)
         row = legacy_row(case_name, model, md, interval_name(intervals(interval_at(intervals, md))%kind), &
                          comparison%ours(number, :), &
                          merge(comparison%theirs(number, :), missing, comparison%parting%present))
      end associate
   end function row_of_depth

   !> A row of the file.
   pure function legacy_row(case_name, model, md, hole, ours, theirs) result(row)
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      real(wp), intent(in) :: md                          !< [m]
      character(*), intent(in) :: hole                    !< kind of hole there
      real(wp), intent(in) :: ours(:), theirs(:)          !< by quantity; theirs missing where the table has none [N, N.m, N/m]
      type(row_type) :: row
      call put(row, 'case', quantity_text, 'name of the load case', case_name)
      call put(row, 'model', quantity_text, 'as in summary.csv', model_name(model))
      call put(row, 'md', quantity_length, 'measured depth, of the other program''s row', md)
      call put(row, 'hole', quantity_text, &
               'kind of hole there: vertical (to 1 deg), build, hold, drop, turn (0.25 deg/30 m and less is held)', hole)
      call put(row, 'axial', quantity_force, 'our axial force, between the depths of our profile', ours(quantity_axial))
      call put(row, 'legacy_axial', quantity_force, 'the other program''s', theirs(quantity_axial))
      call put(row, 'axial_difference', quantity_force, '', difference(theirs(quantity_axial), ours(quantity_axial)))
      call put(row, 'torque', quantity_moment, 'our torque', ours(quantity_torque))
      call put(row, 'legacy_torque', quantity_moment, 'the other program''s', theirs(quantity_torque))
      call put(row, 'torque_difference', quantity_moment, '', difference(theirs(quantity_torque), ours(quantity_torque)))
      call put(row, 'side_force', quantity_line_load, 'our normal contact force per length', ours(quantity_side_force))
      call put(row, 'legacy_side_force', quantity_line_load, 'the other program''s', theirs(quantity_side_force))
      call put(row, 'side_force_difference', quantity_line_load, &
               '', difference(theirs(quantity_side_force), ours(quantity_side_force)))
   end function legacy_row
end module dg_legacy_rows

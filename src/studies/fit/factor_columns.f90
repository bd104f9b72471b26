!> Columns of calibration.csv, which has rows of all that is found from measurements.
module dg_factor_columns
   use dg_column, only: column_type, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_text
   use dg_csv_table, only: begin_table, csv_table_type, is_begun
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: factor_columns, factor_file, begin_factors

   character(*), parameter :: factor_file = 'calibration.csv'

   !> New ones are added at the end only: others rely on the names and the order.
   type(column_type), parameter :: factor_columns(30) = [ &
      column_type('calibration', quantity_text, 'its name'), &
      column_type('model', quantity_text, 'as in summary.csv'), &
      column_type('parameter', quantity_text, &
         'friction, friction_axial, friction_rotary, hookload_offset, sticking or free_point'), &
      column_type('hole', quantity_text, 'hole section that it is for; empty: all named'), &
      column_type('operation', quantity_text, 'operation that it is for; empty: all'), &
      column_type('bit_depth', quantity_length, 'depth of the bit that it is for; empty: all'), &
      column_type('start', quantity_none, 'the factor as the deck has it (mean over cases and sections)'), &
      column_type('value', quantity_none, 'the factor that fits best'), &
      column_type('lower', quantity_none, 'lower end of its 95 % confidence interval; empty: not known'), &
      column_type('upper', quantity_none, 'upper end'), &
      column_type('deviation', quantity_none, 'standard deviation'), &
      column_type('verdict', quantity_text, &
         'found, at_bound (0 or 2; sticking: too little torque), not_felt (data do not depend on it), not_separated '// &
         '(data tell only a mixture), no_fit, no_solution; below_bit: the string is free'), &
      column_type('scatter', quantity_none, &
         'of all residuals over standard deviations (of the deck, else 2 % of the mean); about 1 where these are right'), &
      column_type('message', quantity_text, 'why there is no fit'), &
      column_type('offset', quantity_force, 'what the gauge shows beyond string and block, in rows of a hookload_offset'), &
      column_type('offset_lower', quantity_force, 'lower end of its 95 % confidence interval'), &
      column_type('offset_upper', quantity_force, 'upper end'), &
      column_type('case', quantity_text, 'load case, in rows of sticking and free_point (its second pull)'), &
      column_type('depth', quantity_length, 'of the stuck point, as given (sticking) or found with friction (free_point)'), &
      column_type('depth_frictionless', quantity_length, 'free point by the usual formula, without friction'), &
      column_type('tension_above', quantity_force, 'in the string just above the stuck point'), &
      column_type('tension_below', quantity_force, 'there if nothing stuck'), &
      column_type('resistance', quantity_force, 'above less below: > 0 holds the string down, < 0 up'), &
      column_type('resistance_interval', quantity_force, 'half its 95 % interval, from hookload_deviation alone'), &
      column_type('torque_above', quantity_moment, 'in the string just above the stuck point'), &
      column_type('torque_below', quantity_moment, 'there if nothing stuck'), &
      column_type('torque_resistance', quantity_moment, 'above less below'), &
      column_type('applied', quantity_none, 'the factor that the rest of the run used; empty: that of the deck'), &
      column_type('hookload_deviation', quantity_force, 'standard deviation of hook loads by the residuals'), &
      column_type('torque_deviation', quantity_moment, 'of torques')]

contains

   !> Begins the table where it is not begun.
   subroutine begin_factors(table, units)
      type(csv_table_type), intent(inout) :: table
      type(unit_system_type), intent(in) :: units
      if (.not. is_begun(table)) call begin_table(table, factor_columns, units)
   end subroutine begin_factors
end module dg_factor_columns

!> Columns of calibration.csv, which has rows of all that is found from measurements.
module dg_factor_columns
   use dg_column, only: put_none, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_text, row_type
   implicit none
   private
   public :: factor_row, factor_file

   character(*), parameter :: factor_file = 'calibration.csv'

contains

   !> A row without values. New columns are put at the end only: others rely on the names and the order.
   pure function factor_row() result(row)
      type(row_type) :: row
      call put_none(row, 'calibration', quantity_text, 'its name')
      call put_none(row, 'model', quantity_text, 'as in summary.csv')
      call put_none(row, 'parameter', quantity_text, &
                    'friction, friction_axial, friction_rotary, hookload_offset, sticking or free_point')
      call put_none(row, 'hole', quantity_text, 'hole section that it is for; empty: all named')
      call put_none(row, 'operation', quantity_text, 'operation that it is for; empty: all')
      call put_none(row, 'bit_depth', quantity_length, 'depth of the bit that it is for; empty: all')
      call put_none(row, 'start', quantity_none, 'the factor as the deck has it (mean over cases and sections)')
      call put_none(row, 'value', quantity_none, 'the factor that fits best')
      call put_none(row, 'lower', quantity_none, 'lower end of its 95 % confidence interval; empty: not known')
      call put_none(row, 'upper', quantity_none, 'upper end')
      call put_none(row, 'deviation', quantity_none, 'standard deviation')
      call put_none(row, 'verdict', quantity_text, &
                    'found, at_bound (0 or 2; sticking: too little torque), not_felt (data do not depend on it), '// &
                    'not_separated (data tell only a mixture), no_fit, no_solution; below_bit: the string is free')
      call put_none(row, 'scatter', quantity_none, &
                    'of all residuals over standard deviations (of the deck, else 2 % of the mean); about 1 where these '// &
                    'are right')
      call put_none(row, 'message', quantity_text, 'why there is no fit')
      call put_none(row, 'offset', quantity_force, 'what the gauge shows beyond string and block, in rows of a hookload_offset')
      call put_none(row, 'offset_lower', quantity_force, 'lower end of its 95 % confidence interval')
      call put_none(row, 'offset_upper', quantity_force, 'upper end')
      call put_none(row, 'case', quantity_text, 'load case, in rows of sticking and free_point (its second pull)')
      call put_none(row, 'depth', quantity_length, &
                    'of the stuck point, as given (sticking) or found with friction (free_point)')
      call put_none(row, 'depth_frictionless', quantity_length, 'free point by the usual formula, without friction')
      call put_none(row, 'tension_above', quantity_force, 'in the string just above the stuck point')
      call put_none(row, 'tension_below', quantity_force, 'there if nothing stuck')
      call put_none(row, 'resistance', quantity_force, 'above less below: > 0 holds the string down, < 0 up')
      call put_none(row, 'resistance_interval', quantity_force, 'half its 95 % interval, from hookload_deviation alone')
      call put_none(row, 'torque_above', quantity_moment, 'in the string just above the stuck point')
      call put_none(row, 'torque_below', quantity_moment, 'there if nothing stuck')
      call put_none(row, 'torque_resistance', quantity_moment, 'above less below')
      call put_none(row, 'applied', quantity_none, 'the factor that the rest of the run used; empty: that of the deck')
      call put_none(row, 'hookload_deviation', quantity_force, 'standard deviation of hook loads by the residuals')
      call put_none(row, 'torque_deviation', quantity_moment, 'of torques')
   end function factor_row
end module dg_factor_columns

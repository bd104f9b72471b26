!> Columns of calibration.csv, which has rows of all that is found from measurements.
module dg_factor_columns
   use dg_column, only: add, quantity_force, quantity_length, quantity_moment, quantity_none, quantity_text, row_type
   use dg_comparison, only: difference
   use dg_kinds, only: wp
   use dg_missing, only: missing, optional_real
   implicit none
   private
   public :: estimate_type, found_type, held_type, factor_row, factor_file

   character(*), parameter :: factor_file = 'calibration.csv'

   !> A number found by least squares; missing where it is not known.
   type :: estimate_type
      real(wp) :: value = missing
      real(wp) :: half_width = missing       !< of its 95 % confidence interval
      real(wp) :: deviation = missing
   end type estimate_type

   !> Forces and depth of the place that holds a string; missing where unknown.
   type :: held_type
      real(wp) :: depth = missing, depth_frictionless = missing      !< [m]
      real(wp) :: tension_above = missing, tension_below = missing   !< [N]
      real(wp) :: half_width = missing                               !< of the interval of their difference [N]
      real(wp) :: torque_above = missing, torque_below = missing     !< [N.m]
   end type held_type

   !> A row of the file in SI units; what is not set is an empty field.
   type :: found_type
      character(:), allocatable :: calibration, model, parameter, hole, operation, load_case, verdict, message
      type(optional_real) :: bit_depth
      real(wp) :: start = missing, applied = missing, scatter = missing
      type(estimate_type) :: factor, offset
      type(held_type) :: held
      real(wp) :: hookload_deviation = missing, torque_deviation = missing
   end type found_type

contains

   !> A row. New columns are put at the end only: others rely on the names and the order.
   pure function factor_row(found) result(row)
      type(found_type), intent(in) :: found
      type(row_type) :: row
      call add(row, 'calibration', quantity_text, 'its name', found%calibration)
      call add(row, 'model', quantity_text, 'as in summary.csv', found%model)
      call add(row, 'parameter', quantity_text, &
               'friction, friction_axial, friction_rotary, hookload_offset, sticking or free_point', found%parameter)
      call add(row, 'hole', quantity_text, 'hole section of the factor; empty: all named', found%hole)
      call add(row, 'operation', quantity_text, 'operation of the factor; empty: all', found%operation)
      call add(row, 'bit_depth', quantity_length, 'bit depth of the factor; empty: all', found%bit_depth)
      call add(row, 'start', quantity_none, 'factor in the deck (mean over cases and sections)', found%start)
      call add(row, 'value', quantity_none, 'best fit', found%factor%value)
      call add(row, 'lower', quantity_none, &
               'lower end of its 95 % confidence interval; empty: not known', lower_end(found%factor))
      call add(row, 'upper', quantity_none, 'upper end', upper_end(found%factor))
      call add(row, 'deviation', quantity_none, 'standard deviation', found%factor%deviation)
      call add(row, 'verdict', quantity_text, &
               'found, at_bound (0 or 2; sticking: too little torque), not_felt (not determined by the data), '// &
               'not_separated (only a combination is determined), no_fit, no_solution; '// &
               'below_bit: the string is free', found%verdict)
      call add(row, 'scatter', quantity_none, &
               'scatter of residuals divided by standard deviations (of the deck, else 2 % of the mean); about 1 if these are '// &
               'right', found%scatter)
      call add(row, 'message', quantity_text, 'reason of a missing fit', found%message)
      call add(row, 'offset', quantity_force, &
               'reading of the gauge in excess of string and block, in rows of hookload_offset', found%offset%value)
      call add(row, 'offset_lower', quantity_force, 'lower end of its 95 % confidence interval', lower_end(found%offset))
      call add(row, 'offset_upper', quantity_force, 'upper end', upper_end(found%offset))
      call add(row, 'case', quantity_text, &
               'load case, in rows of sticking and free_point (its second pull)', found%load_case)
      call add(row, 'depth', quantity_length, &
               'depth of the stuck point, as given (sticking) or found with friction (free_point)', found%held%depth)
      call add(row, 'depth_frictionless', quantity_length, &
               'free point by the usual formula, without friction', found%held%depth_frictionless)
      call add(row, 'tension_above', quantity_force, 'in the string just above the stuck point', found%held%tension_above)
      call add(row, 'tension_below', quantity_force, 'the same in a free string', found%held%tension_below)
      call add(row, 'resistance', quantity_force, &
               'above less below: > 0 holds the string down, < 0 up', &
               difference(found%held%tension_above, found%held%tension_below))
      call add(row, 'resistance_interval', quantity_force, &
               'half its 95 % interval, from hookload_deviation alone', found%held%half_width)
      call add(row, 'torque_above', quantity_moment, 'in the string just above the stuck point', found%held%torque_above)
      call add(row, 'torque_below', quantity_moment, 'the same in a free string', found%held%torque_below)
      call add(row, 'torque_resistance', quantity_moment, &
               'above less below', difference(found%held%torque_above, found%held%torque_below))
      call add(row, 'applied', quantity_none, &
               'factor used in the rest of the run; empty: that of the deck', found%applied)
      call add(row, 'hookload_deviation', quantity_force, &
               'standard deviation of hook loads by the residuals', found%hookload_deviation)
      call add(row, 'torque_deviation', quantity_moment, 'standard deviation of torques by the residuals', found%torque_deviation)
   end function factor_row

   pure function lower_end(estimate) result(lower)
      type(estimate_type), intent(in) :: estimate
      real(wp) :: lower
      lower = difference(estimate%value, estimate%half_width)
   end function lower_end

   pure function upper_end(estimate) result(upper)
      type(estimate_type), intent(in) :: estimate
      real(wp) :: upper
      upper = difference(estimate%value, difference(0.0_wp, estimate%half_width))
   end function upper_end
end module dg_factor_columns

!> Measured values at the rig beside those of a sweep, and the friction factor that would give them.
module dg_measured_table
   use dg_kinds, only: wp
   use dg_comparison, only: as_measured
   use dg_case_result, only: has_numbers, result_converged
   use dg_job, only: model_name
   use dg_load_case, only: operation_label
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: given, optional_real
   use dg_number_text, only: fixed_cell, page_width
   use dg_sweep, only: point_number, point_type, sweep_type
   use dg_sweep_result, only: sweep_result_type
   use dg_text, only: append_text, text_type, to_text
   use dg_text_table, only: add_cell, add_right, append_table, end_row, text_table_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: append_measured, cell_width, factor_text, factor_width, fitting_friction, quantity_hookload, quantity_torque

   !> Quantity of a table or a row; also its number of digits behind the point.
   integer, parameter :: quantity_hookload = 1, quantity_torque = 2
   integer, parameter :: depth_width = 10
   !> Least width of a column. The last place holds the mark of a point without solution.
   integer, parameter :: cell_width = 9
   integer, parameter :: name_width = 24
   integer, parameter :: label_width = 18

contains

   !> Append measured values, the values of every friction factor there, and the factor that would give the measured ones.
   pure subroutine append_measured(lines, units, sweep, points, model)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      integer, parameter :: most_factors = 5, gap = 2      ! blanks behind a number that words follow
      type(text_table_type) :: table
      integer :: i, shown, room
      if (size(sweep%measured) == 0) return
      room = page_width - name_width - depth_width - gap - label_width - (cell_width + 1) - cell_width
      shown = min(size(sweep%frictions), most_factors, room/factor_width(sweep))
      call append_text(lines, '')
      call append_text(lines, 'Measured, and calculated by '//trim(model_name(sweep%models(model)))//' at friction factors')
      do i = 1, size(sweep%measured)
         if (sweep%measured(i)%hookload%present) &
            call add_row(table, units, sweep, points, model, i, quantity_hookload, shown)
         if (sweep%measured(i)%torque%present) &
            call add_row(table, units, sweep, points, model, i, quantity_torque, shown)
      end do
      call append_table(lines, table)
      if (can_fit(sweep)) call append_text(lines, 'Fits: friction factor that gives the measured value, between those of the sweep')
   end subroutine append_measured

   !> Add what was measured at a point.
   pure subroutine add_row(table, units, sweep, points, model, number, quantity, shown)
      type(text_table_type), intent(inout) :: table
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      integer, intent(in) :: number    !< of the measured point
      integer, intent(in) :: quantity
      integer, intent(in) :: shown     !< friction factors in the row
      character(cell_width - 1) :: cell
      type(point_type) :: point
      real(wp) :: values(size(sweep%frictions)), unit, one
      logical :: solved(size(sweep%frictions))
      type(optional_real) :: measured
      integer :: f
      one = 1.0_wp
      associate (told => sweep%measured(number))
         measured = told%hookload
         unit = units%force
         if (quantity == quantity_torque) measured = told%torque
         if (quantity == quantity_torque) unit = units%moment
         call add_cell(table, 'Load case', name_width, told%name)
         call add_cell(table, 'Bit depth', depth_width, told%bit_depth, units%length, 1)
         call add_cell(table, 'Operation', label_width, operation_label(told%operation))
         call add_cell(table, 'Measured', cell_width + 1, measured, unit, quantity)
         point = point_type(model, findloc(sweep%operations, told%operation, dim=1), 1, &
                            minloc(abs(sweep%depths - told%bit_depth), dim=1))
      end associate
      do f = 1, size(values)
         point%friction = f
         associate (found => points(point_number(sweep, point)))
            values(f) = as_measured(found%hookload, found%weight_indicator)
            if (quantity == quantity_torque) values(f) = found%torque
            solved(f) = found%status == result_converged
            cell = fixed_cell(optional_real(has_numbers(found%status), values(f)), unit, len(cell), quantity)
            if (f <= shown) call add_right(table, factor_text(sweep, f)//' ', factor_width(sweep), &
                                           cell//merge(' ', '!', solved(f)))
         end associate
      end do
      if (can_fit(sweep)) call add_cell(table, 'Fits', cell_width, &
                                        fitting_friction(sweep%frictions, values, solved, measured%value), one, 3)
      call end_row(table, '')
   end subroutine add_row

   !> True where measured values may lie between those of two friction factors: not of pairs, nor of the friction of the hole.
   pure function can_fit(sweep) result(can)
      type(sweep_type), intent(in) :: sweep
      logical :: can
      can = size(sweep%frictions) > 1 .and. all(sweep%frictions%present) .and. .not. allocated(sweep%frictions_cased)
   end function can_fit

   !> Friction factor at which values known at some factors reach a measured one, by straight lines between neighbours;
   !> absent where the measured value lies outside.
   pure function fitting_friction(frictions, values, solved, measured) result(friction)
      type(optional_real), intent(in) :: frictions(:)
      real(wp), intent(in) :: values(:)        !< at these factors
      logical, intent(in) :: solved(:)         !< whether they are solutions
      real(wp), intent(in) :: measured
      type(optional_real) :: friction
      integer :: order(size(frictions)), i
      if (.not. all(frictions%present)) return
      order = sorted_places(frictions%value)
      do i = 2, size(order)
         associate (a => values(order(i - 1)), b => values(order(i)), from => frictions(order(i - 1))%value, &
                    to => frictions(order(i))%value)
            if (.not. (solved(order(i - 1)) .and. solved(order(i)))) cycle
            if ((measured - a)*(measured - b) > 0.0_wp .or. .not. abs(b - a) > 0.0_wp) cycle
            friction = given(from + (to - from)*(measured - a)/(b - a))
            return
         end associate
      end do
   end function fitting_friction

   !> Width of a column below a friction factor, which has a blank before it and one behind it.
   pure function factor_width(sweep) result(width)
      type(sweep_type), intent(in) :: sweep
      integer :: width
      integer :: f
      width = cell_width
      do f = 1, size(sweep%frictions)
         width = max(width, len(factor_text(sweep, f)) + 2)
      end do
   end function factor_width

   !> A friction factor; of cased and open hole in a form that fits, as .2/.35.
   pure function factor_text(sweep, number) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number
      character(:), allocatable :: text
      integer, parameter :: digits = 4
      text = '&hole'
      if (sweep%frictions(number)%present) text = to_text(sweep%frictions(number)%value, digits)
      if (allocated(sweep%frictions_cased)) &
         text = without_zero(to_text(sweep%frictions_cased(number), digits))//'/'//without_zero(text)
   contains
      pure function without_zero(long) result(short)
         character(*), intent(in) :: long
         character(:), allocatable :: short
         short = long
         if (index(long, '0.') == 1) short = long(2:)
      end function without_zero
   end function factor_text
end module dg_measured_table

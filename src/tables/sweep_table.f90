!> The broomstick in print: hook load and torque against bit depth, a column for each operation and friction factor, and
!> what was measured beside what was calculated. Every line fits 120 columns.
module dg_sweep_table
   use dg_kinds, only: wp
   use dg_comparison, only: as_measured
   use dg_case_result, only: result_converged, result_not_converged
   use dg_job, only: model_name
   use dg_load_case, only: given, operation_label, optional_real, rotates
   use dg_missing, only: is_missing
   use dg_number_text, only: fixed_cell, left_aligned, right_aligned
   use dg_sweep, only: at_operation, point_at, point_number, point_type, sweep_type
   use dg_sweep_result, only: sweep_result_type
   use dg_text, only: append_text, text_type, to_text
   use dg_unit_kind, only: unit_label, unit_moment
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: sweep_table, fitting_friction

   integer, parameter :: depth_width = 10
   integer, parameter :: cell_width = 9       ! the last place holds the mark of a point without solution
   integer, parameter :: most_columns = 12
   integer, parameter :: name_width = 24
   integer, parameter :: label_width = 18
   !> Rows of a table: a page shows the shape of a curve, the file has every depth.
   integer, parameter :: most_rows = 25
   !> Points without solution that are listed.
   integer, parameter :: most_lost = 10
   integer, parameter :: hookload = 1, torque = 2, depth_digits = 7

contains

   !> All tables of a sweep.
   pure function sweep_table(units, sweep, points) result(lines)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)   !< in the order of their numbers
      type(text_type), allocatable :: lines(:)
      type(point_type), allocatable :: curves(:)
      integer :: m, quantity, first
      allocate (lines(0))
      do m = 1, size(sweep%models)
         do quantity = hookload, torque
            curves = curves_of(sweep, m, quantity)
            do first = 1, size(curves), most_columns
               call append_curves(lines, units, sweep, points, quantity, curves(first:min(first + most_columns - 1, size(curves))))
            end do
         end do
         call append_limits(lines, units, sweep, points, m)
         call append_measured(lines, units, sweep, points, m)
      end do
      if (any(points%status /= result_converged)) call append_text(lines, '! no solution')
      call append_lost(lines, units, sweep, points)
   end function sweep_table

   !> The first points that did not converge, and how many there are.
   pure subroutine append_lost(lines, units, sweep, points)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, parameter :: number_width = 9, model_width = 7
      character(:), allocatable :: rule
      type(point_type) :: point
      integer :: i, lost, shown
      lost = count(points%status == result_not_converged)
      if (lost == 0) return
      rule = repeat('-', number_width + 2 + model_width + label_width + 2*depth_width)
      call append_text(lines, '')
      call append_text(lines, to_text(lost)//' of '//to_text(size(points))//' points did not converge; the file says why')
      call append_text(lines, rule)
      call append_text(lines, right_aligned('Point', number_width)//'  '//left_aligned('Model', model_width)// &
                       left_aligned('Operation', label_width)//right_aligned('Friction', depth_width)// &
                       right_aligned('Depth, '//trim(units%length_label), depth_width))
      call append_text(lines, rule)
      shown = 0
      do i = 1, size(points)
         if (points(i)%status /= result_not_converged) cycle
         if (shown == most_lost) exit
         shown = shown + 1
         point = point_at(sweep, i)
         call append_text(lines, right_aligned(to_text(i), number_width)//'  '// &
                          left_aligned(trim(model_name(sweep%models(point%model))), model_width)// &
                          left_aligned(trim(operation_label(sweep%operations(point%operation))), label_width)// &
                          right_aligned(factor_text(sweep, point%friction), depth_width)// &
                          fixed_cell(sweep%depths(point%depth)/units%length, depth_width, 1))
      end do
      call append_text(lines, rule)
      if (shown < lost) call append_text(lines, to_text(shown)//' of '//to_text(lost)//'; the file has them all')
   end subroutine append_lost

   !> First points of the curves that have something to show: torque where the string turns or the bit has some.
   pure function curves_of(sweep, model, quantity) result(curves)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: model, quantity
      type(point_type), allocatable :: curves(:)
      integer :: o, f
      allocate (curves(0))
      do o = 1, size(sweep%operations)
         if (quantity == torque .and. .not. (rotates(sweep%operations(o)) .or. at_operation(sweep%tob, o) > 0.0_wp)) cycle
         do f = 1, size(sweep%frictions)
            curves = [curves, point_type(model, o, f, 1)]
         end do
      end do
   end function curves_of

   !> One table: a row a depth, a column a curve.
   pure subroutine append_curves(lines, units, sweep, points, quantity, curves)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: quantity
      type(point_type), intent(in) :: curves(:)
      character(:), allocatable :: head, factors, row, rule
      type(point_type) :: point
      integer :: i, k, n, row_count
      call append_text(lines, '')
      call append_text(lines, 'Sweep '//sweep%name//', model '//trim(model_name(sweep%models(curves(1)%model)))//': '// &
                       quantity_text(units, quantity, any(.not. is_missing(points%weight_indicator)))//' at friction factors')
      head = right_aligned('Bit depth', depth_width)
      factors = right_aligned(trim(units%length_label), depth_width)
      i = 1
      do while (i <= size(curves))
         n = count(curves%operation == curves(i)%operation)
         head = head//operation_head(trim(operation_label(sweep%operations(curves(i)%operation))), n)
         i = i + n
      end do
      do k = 1, size(curves)
         factors = factors//right_aligned(factor_text(sweep, curves(k)%friction), cell_width - 1)//' '
      end do
      rule = repeat('-', max(len_trim(head), len(factors)))
      call append_text(lines, rule)
      call append_text(lines, trim(head))
      call append_text(lines, trim(factors))
      call append_text(lines, rule)
      n = size(sweep%depths)
      row_count = min(n, most_rows)
      do i = 1, row_count
         row = ''
         do k = 1, size(curves)
            point = curves(k)
            point%depth = ceiling(real(i, wp)*real(n, wp)/real(row_count, wp))
            if (k == 1) row = fixed_cell(sweep%depths(point%depth)/units%length, depth_width, 1)
            associate (found => points(point_number(sweep, point)))
               if (quantity == torque) then
                  row = row//fixed_cell(found%torque/units%moment, cell_width - 1, 2)
               else
                  row = row//fixed_cell(as_measured(found%hookload, found%weight_indicator)/units%force, cell_width - 1, 1)
               end if
               row = row//merge(' ', '!', found%status == result_converged)
            end associate
         end do
         call append_text(lines, trim(row))
      end do
      call append_text(lines, rule)
      if (row_count < n) call append_text(lines, to_text(row_count)//' of '//to_text(n)//' depths; the file has them all')
   end subroutine append_curves

   !> Name of an operation above its `n` columns: its first word where there is one column.
   pure function operation_head(label, n) result(head)
      character(*), intent(in) :: label
      integer, intent(in) :: n
      character(n*cell_width) :: head
      if (n > 1) then
         ! one behind it is left free
         head = left_aligned(repeat(' ', min(2, max(0, len(head) - 1 - len(label))))//label, len(head))
      else
         head = right_aligned(label(:index(label//' ', ' ') - 1), cell_width - 1)
      end if
   end function operation_head

   !> What was measured, what every friction factor gives there, and the factor that would give it.
   pure subroutine append_measured(lines, units, sweep, points, model)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      integer, parameter :: most_factors = 5
      character(:), allocatable :: head, rule
      integer :: i, f, shown
      shown = min(size(sweep%frictions), most_factors)
      if (size(sweep%measured) == 0) return
      call append_text(lines, '')
      call append_text(lines, 'Measured, and calculated by '//trim(model_name(sweep%models(model)))//' at friction factors')
      head = left_aligned('Load case', name_width)//right_aligned('Bit depth', depth_width)//'  '// &
         left_aligned('Operation', label_width)//right_aligned('Measured', cell_width + 1)
      do f = 1, shown
         head = head//right_aligned(factor_text(sweep, f), cell_width - 1)//' '
      end do
      head = head//right_aligned('Fits', cell_width)
      rule = repeat('-', len(head))
      call append_text(lines, rule)
      call append_text(lines, head)
      call append_text(lines, rule)
      do i = 1, size(sweep%measured)
         if (sweep%measured(i)%hookload%present) &
            call append_text(lines, measured_row(units, sweep, points, model, i, hookload, shown))
         if (sweep%measured(i)%torque%present) &
            call append_text(lines, measured_row(units, sweep, points, model, i, torque, shown))
      end do
      call append_text(lines, rule)
      call append_text(lines, 'Fits: friction factor that gives the measured value, between those of the sweep')
   end subroutine append_measured

   pure function measured_row(units, sweep, points, model, number, quantity, shown) result(row)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      integer, intent(in) :: number    !< of the measured point
      integer, intent(in) :: quantity
      integer, intent(in) :: shown     !< friction factors in the row
      character(:), allocatable :: row
      type(point_type) :: point
      real(wp) :: values(size(sweep%frictions)), unit, one
      logical :: solved(size(sweep%frictions))
      type(optional_real) :: measured
      integer :: f
      one = 1.0_wp
      associate (told => sweep%measured(number))
         measured = told%hookload
         unit = units%force
         if (quantity == torque) measured = told%torque
         if (quantity == torque) unit = units%moment
         row = left_aligned(told%name, name_width)//fixed_cell(told%bit_depth/units%length, depth_width, 1)//'  '// &
            left_aligned(trim(operation_label(told%operation)), label_width)//fixed_cell(measured, unit, cell_width + 1, quantity)
         point = point_type(model, findloc_of(sweep%operations, told%operation), 1, depth_of(sweep, told%bit_depth))
      end associate
      do f = 1, size(values)
         point%friction = f
         associate (found => points(point_number(sweep, point)))
            values(f) = as_measured(found%hookload, found%weight_indicator)
            if (quantity == torque) values(f) = found%torque
            solved(f) = found%status == result_converged
            if (f <= shown) row = row//fixed_cell(values(f)/unit, cell_width - 1, quantity)// &
               merge(' ', '!', found%status == result_converged)
         end associate
      end do
      if (allocated(sweep%frictions_cased)) return     ! no one factor
      row = row//fixed_cell(fitting_friction(sweep%frictions, values, solved, measured%value), one, cell_width, 3)
   end function measured_row

   !> Friction factor at which values known at some factors reach a measured one, by straight lines between neighbours;
   !> absent where the measured value lies outside.
   pure function fitting_friction(frictions, values, solved, measured) result(friction)
      type(optional_real), intent(in) :: frictions(:)
      real(wp), intent(in) :: values(:)        !< at these factors
      logical, intent(in) :: solved(:)         !< whether they are solutions
      real(wp), intent(in) :: measured
      type(optional_real) :: friction
      integer :: order(size(frictions)), i, j, moving
      if (.not. all(frictions%present)) return
      order = [(i, i=1, size(order))]
      do i = 2, size(order)
         do j = i, 2, -1
            if (frictions(order(j - 1))%value <= frictions(order(j))%value) exit
            moving = order(j)
            order(j) = order(j - 1)
            order(j - 1) = moving
         end do
      end do
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

   !> Place of a number in a list.
   pure function findloc_of(list, number) result(place)
      integer, intent(in) :: list(:), number
      integer :: place
      do place = 1, size(list) - 1
         if (list(place) == number) return
      end do
      place = size(list)
   end function findloc_of

   !> Place of the depth nearest to one that is among them [m].
   pure function depth_of(sweep, depth) result(place)
      type(sweep_type), intent(in) :: sweep
      real(wp), intent(in) :: depth
      integer :: place
      place = minloc(abs(sweep%depths - depth), dim=1)
   end function depth_of

   !> A friction factor; of cased and open hole in a form that fits, as .2/.35.
   pure function factor_text(sweep, number) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number
      character(:), allocatable :: text
      integer, parameter :: digits = 4, few_digits = 2
      text = 'hole'
      if (sweep%frictions(number)%present) text = to_text(sweep%frictions(number)%value, digits)
      if (allocated(sweep%frictions_cased)) text = without_zero(to_text(sweep%frictions_cased(number), few_digits))//'/'// &
         without_zero(to_text(sweep%frictions(number)%value, few_digits))
   contains
      pure function without_zero(long) result(short)
         character(*), intent(in) :: long
         character(:), allocatable :: short
         short = long
         if (index(long, '0.') == 1) short = long(2:)
      end function without_zero
   end function factor_text

   !> From which depth on a curve is beyond a limit of the rig, yields, or goes down no more by its weight.
   pure subroutine append_limits(lines, units, sweep, points, model)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      real(wp) :: margins(size(sweep%depths))
      integer :: o, f, first, last
      type(point_type) :: point
      do o = 1, size(sweep%operations)
         do f = 1, size(sweep%frictions)
            point = point_type(model, o, f, 1)
            first = point_number(sweep, point)
            last = first + size(sweep%depths) - 1
            margins = points(first:last)%rig_margin
            call tell(lines, 'Beyond max_hookload of the rig', beyond(margins))
            margins = points(first:last)%torque_margin
            call tell(lines, 'Beyond max_torque of the rig', beyond(margins))
            margins = points(first:last)%overpull_margin
            call tell(lines, 'Beyond yield', beyond(margins))
            call tell(lines, 'Must be pushed at surface', points(first:last)%status == result_converged .and. &
                      points(first:last)%hookload < 0.0_wp)
         end do
      end do
   contains
      elemental function beyond(margin)
         real(wp), intent(in) :: margin
         logical :: beyond
         beyond = .not. is_missing(margin) .and. margin < 0.0_wp
      end function beyond

      pure subroutine tell(page, what, there)
         type(text_type), allocatable, intent(inout) :: page(:)
         character(*), intent(in) :: what
         logical, intent(in) :: there(:)     !< at each depth
         if (.not. any(there)) return
         call append_text(page, what//': '//trim(operation_label(sweep%operations(o)))//' at '// &
                          factor_text(sweep, f)//' with the bit at '// &
                          to_text(sweep%depths(findloc(there, .true., dim=1))/units%length, depth_digits)//' '// &
                          trim(units%length_label))
      end subroutine tell
   end subroutine append_limits

   pure function quantity_text(units, quantity, indicated) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      logical, intent(in) :: indicated     !< as the rig shows it
      character(:), allocatable :: text
      text = 'hook load, '//trim(units%force_label)
      if (indicated) text = 'hook load as the rig shows it, '//trim(units%force_label)
      if (quantity == torque) text = 'torque, '//unit_label(units, unit_moment)
   end function quantity_text
end module dg_sweep_table

!> The broomstick in print: hook load and torque against bit depth, a column for each operation and friction factor.
!> Every line fits 120 columns.
module dg_sweep_table
   use dg_kinds, only: wp
   use dg_comparison, only: as_measured
   use dg_case_result, only: has_numbers, result_converged, result_not_converged
   use dg_job, only: model_name
   use dg_load_case, only: moves_axially, operation_label, rotates
   use dg_measured_table, only: append_measured, cell_width, factor_text, factor_width, quantity_hookload, quantity_torque
   use dg_missing, only: is_missing, optional_real
   use dg_number_text, only: fixed_cell, left_aligned, page_width, right_aligned
   use dg_sweep, only: at_operation, point_at, point_number, point_type, shown_depths, sweep_type
   use dg_sweep_result, only: answer_of, sweep_result_type
   use dg_sweep_sentences, only: append_answers, append_warned
   use dg_text, only: append_text, either, text_type, to_text
   use dg_text_table, only: add_cell, add_right, append_table, end_row, text_table_type
   use dg_unit_kind, only: unit_label, unit_moment
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_yes
   use dg_verdict_text, only: mark_meaning, row_mark
   implicit none
   private
   public :: sweep_table

   integer, parameter :: depth_width = 10
   integer, parameter :: label_width = 18
   !> Points without solution that are listed.
   integer, parameter :: most_lost = 10
   !> Digits behind the point.
   integer, parameter :: hookload_digits = 1, torque_digits = 2

   !> A column of a table.
   type :: curve_type
      type(point_type) :: point            !< its first
      logical :: any_friction = .false.    !< it stands for all friction factors
   end type curve_type

contains

   !> All tables of a sweep.
   pure function sweep_table(units, sweep, points) result(lines)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)   !< in the order of their numbers
      type(text_type), allocatable :: lines(:)
      type(curve_type), allocatable :: curves(:)
      integer :: m, quantity, first, width, most
      allocate (lines(0))
      width = column_width(sweep)
      most = (page_width - depth_width)/width
      do m = 1, size(sweep%models)
         do quantity = quantity_hookload, quantity_torque
            curves = curves_of(units, sweep, points, m, quantity)
            do first = 1, size(curves), most
               call append_curves(lines, units, sweep, points, quantity, width, &
                                  curves(first:min(first + most - 1, size(curves))))
            end do
         end do
         call append_answers(lines, units, sweep, points, m)
         call append_measured(lines, units, sweep, points, m)
      end do
      if (any(answer_of(points) /= answer_yes)) call append_text(lines, mark_meaning// &
         either('. Hook load without the block decides', '', any(.not. is_missing(points%weight_indicator))))
      do m = 1, size(sweep%models)
         call append_warned(lines, units, sweep, points, m)
      end do
      call append_lost(lines, units, sweep, points)
   end function sweep_table

   !> The first points that did not converge, and how many there are.
   pure subroutine append_lost(lines, units, sweep, points)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, parameter :: number_width = 9, model_width = 7
      type(text_table_type) :: table
      type(point_type) :: point
      integer :: i, lost, shown
      lost = count(points%status == result_not_converged)
      if (lost == 0) return
      call append_text(lines, '')
      call append_text(lines, to_text(lost)//' of '//to_text(size(points))//' points did not converge; the file says why')
      shown = 0
      do i = 1, size(points)
         if (points(i)%status /= result_not_converged) cycle
         if (shown == most_lost) exit
         shown = shown + 1
         point = point_at(sweep, i)
         call add_cell(table, 'Point', number_width, i)
         call add_cell(table, 'Model', model_width, model_name(sweep%models(point%model)))
         call add_cell(table, 'Operation', label_width, operation_label(sweep%operations(point%operation)))
         call add_right(table, 'Friction', max(depth_width, factor_width(sweep)), factor_text(sweep, point%friction))
         call add_cell(table, 'Depth, '//trim(units%length_label), depth_width, sweep%depths(point%depth), units%length, 1)
         call end_row(table, '')
      end do
      call append_table(lines, table)
      if (shown < lost) call append_text(lines, to_text(shown)//' of '//to_text(lost)//'; the CSV file has all')
   end subroutine append_lost

   !> Curves with values. Torque is one if the string turns or the bit has some. Hook loads of a string that turns without
   !> moving do not depend on friction, and are one curve for all factors.
   pure function curves_of(units, sweep, points, model, quantity) result(curves)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model, quantity
      type(curve_type), allocatable :: curves(:)
      logical :: once
      integer :: o, f
      allocate (curves(0))
      do o = 1, size(sweep%operations)
         if (quantity == quantity_torque .and. .not. (rotates(sweep%operations(o)) .or. at_operation(sweep%tob, o) > 0.0_wp)) cycle
         once = .false.
         if (quantity == quantity_hookload .and. size(sweep%frictions) > 1 .and. .not. moves_axially(sweep%operations(o))) &
            once = all_alike(units, sweep, points, model, o)
         do f = 1, merge(1, size(sweep%frictions), once)
            curves = [curves, curve_type(point_type(model, o, f, 1), once)]
         end do
      end do
   end function curves_of

   !> True if the hook loads of an operation are shown with the same digits at all friction factors, and all are solutions.
   pure function all_alike(units, sweep, points, model, operation) result(alike)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model, operation
      logical :: alike
      real(wp) :: one, other
      integer :: d, f
      alike = .false.
      do d = 1, size(sweep%depths)
         do f = 1, size(sweep%frictions)
            associate (found => points(point_number(sweep, point_type(model, operation, f, d))))
               if (found%status /= result_converged) return
               other = anint(as_measured(found%hookload, found%weight_indicator)/units%force*10.0_wp**hookload_digits)
            end associate
            if (f == 1) one = other
            if (abs(other - one) > 0.5_wp) return
         end do
      end do
      alike = .true.
   end function all_alike

   !> One table: a row a depth, a column a curve.
   pure subroutine append_curves(lines, units, sweep, points, quantity, width, curves)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: quantity
      integer, intent(in) :: width             !< of a column
      type(curve_type), intent(in) :: curves(:)
      type(text_table_type) :: table
      type(text_type) :: heads(size(curves))
      character(cell_width - 1) :: cell
      type(point_type) :: point
      integer, allocatable :: depths(:)
      integer :: i, k
      call append_text(lines, '')
      call append_text(lines, 'Sweep '//sweep%name//', model '//trim(model_name(sweep%models(curves(1)%point%model)))//': '// &
                       quantity_text(units, quantity, any(.not. is_missing(points%weight_indicator)))//' at friction factors'// &
                       either(' cased/open', '', index(factor_text(sweep, 1), '/') > 0))
      heads = curve_heads(sweep, curves, width)
      allocate (depths, source=shown_depths(sweep))
      do i = 1, size(depths)
         call add_cell(table, 'Bit depth|'//trim(units%length_label), depth_width, sweep%depths(depths(i)), units%length, 1)
         do k = 1, size(curves)
            point = curves(k)%point
            point%depth = depths(i)
            associate (found => points(point_number(sweep, point)))
               if (quantity == quantity_torque) then
                  cell = fixed_cell(optional_real(has_numbers(found%status), found%torque), units%moment, len(cell), torque_digits)
               else
                  cell = fixed_cell(optional_real(has_numbers(found%status), &
                                                  as_measured(found%hookload, found%weight_indicator)), &
                                    units%force, len(cell), hookload_digits)
               end if
               call add_right(table, heads(k)%text, width, cell//merge(' ', row_mark, answer_of(found) == answer_yes))
            end associate
         end do
         call end_row(table, '')
      end do
      call append_table(lines, table)
      if (size(depths) < size(sweep%depths)) call append_text(lines, to_text(size(depths))//' of '//to_text(size(sweep%depths))// &
                                                              ' depths; the CSV file has all')
   end subroutine append_curves

   !> Width of a column: friction factor and first word of an operation have a blank before them.
   pure function column_width(sweep) result(width)
      type(sweep_type), intent(in) :: sweep
      integer :: width
      integer :: o
      width = factor_width(sweep)
      do o = 1, size(sweep%operations)
         width = max(width, len(first_word(operation_label(sweep%operations(o)))) + 1)
      end do
   end function column_width

   !> Heads of curves: a part of the name of the operation, which stands over all its curves, above the friction factor.
   pure function curve_heads(sweep, curves, width) result(heads)
      type(sweep_type), intent(in) :: sweep
      type(curve_type), intent(in) :: curves(:)
      integer, intent(in) :: width             !< of a column
      type(text_type) :: heads(size(curves))
      character(:), allocatable :: names, factor
      integer :: k
      names = ''
      do k = 1, size(curves)
         if (len(names) < k*width) names = names// &
            operation_head(trim(operation_label(sweep%operations(curves(k)%point%operation))), &
                           count(curves%point%operation == curves(k)%point%operation), width)
         factor = 'any'
         if (.not. curves(k)%any_friction) factor = factor_text(sweep, curves(k)%point%friction)
         heads(k)%text = names((k - 1)*width + 1:k*width)//'|'//factor//' '
      end do
   end function curve_heads

   !> Name of an operation above its `n` columns: its first word where there is one column. A blank stands before it.
   pure function operation_head(label, n, width) result(head)
      character(*), intent(in) :: label
      integer, intent(in) :: n
      integer, intent(in) :: width             !< of a column
      character(n*width) :: head
      if (n > 1) then
         ! one behind it is left free
         head = left_aligned(repeat(' ', max(1, min(2, len(head) - 1 - len(label))))//label, len(head))
      else
         head = right_aligned(first_word(label), max(width - 1, len(first_word(label)) + 1))
      end if
   end function operation_head

   pure function first_word(label) result(word)
      character(*), intent(in) :: label
      character(:), allocatable :: word
      word = label(:index(label//' ', ' ') - 1)
   end function first_word

   pure function quantity_text(units, quantity, indicated) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      logical, intent(in) :: indicated     !< as the rig shows it
      character(:), allocatable :: text
      text = 'hook load, '//trim(units%force_label)
      if (indicated) text = 'weight indicator (hook load with block and sheaves), '//trim(units%force_label)
      if (quantity == quantity_torque) text = 'torque, '//unit_label(units, unit_moment)
   end function quantity_text
end module dg_sweep_table

!> Strings that are held, in print: resistances at a stuck point, free points. Every line fits 120 columns.
module dg_sticking_table
   use dg_kinds, only: wp
   use dg_comparison, only: difference
   use dg_job, only: model_name
   use dg_load_case, only: operation_label
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_number_text, only: left_aligned, fixed_text
   use dg_sticking, only: find_free_point, sticking_at_bound, sticking_below_bit, sticking_no_solution, &
                           sticking_result_type, sticking_type
   use dg_text, only: append_text, text_type, to_text
   use dg_text_table, only: add_cell, add_instead, append_table, end_row, text_table_type
   use dg_unit_kind, only: in_units, unit_label, unit_length, unit_moment
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: sticking_table

   integer, parameter :: name_width = 20, model_width = 7, label_width = 18, cell_width = 10, interval_width = 8
   integer, parameter :: depth_digits = 7, stretch_digits = 4

contains

   !> Lines of the table of a string that is held, all models.
   function sticking_table(units, model, sticking, results) result(lines)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: results(:)
      type(text_type), allocatable :: lines(:)
      allocate (lines(0))
      call append_text(lines, '')
      if (sticking%kind == find_free_point) then
         call append_free_points(lines, units, model, sticking, results)
      else
         call append_resistances(lines, units, model, sticking, results)
      end if
   end function sticking_table

   subroutine append_resistances(lines, units, model, sticking, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: results(:)
      type(text_table_type) :: table
      integer :: i
      call append_text(lines, 'Sticking '//sticking%name//': resistance at '// &
                       in_units(units, unit_length, sticking%depth, depth_digits)// &
                       ', from measured hook load and torque; in '//trim(units%force_label)//' and '// &
                       unit_label(units, unit_moment))
      do i = 1, size(results)
         associate (found => results(i), case => model%cases(results(i)%case_index))
            call add_cell(table, 'Load case', name_width, case%name)
            call add_cell(table, 'Model', model_width, model_name(found%model))
            call add_cell(table, 'Operation', label_width, operation_label(case%operation))
            if (found%status == sticking_no_solution) call add_instead(table, 'no solution')
            call add_cell(table, 'Measured', cell_width, case%measured_hookload, units%force, 1)
            call add_cell(table, 'Free', cell_width, found%free_hookload, units%force, 1)
            call add_cell(table, 'Above', cell_width, found%tension_above, units%force, 1)
            call add_cell(table, 'Below', cell_width, found%tension_below, units%force, 1)
            call add_cell(table, 'Resists', cell_width, difference(found%tension_above, found%tension_below), units%force, 1)
            call add_cell(table, '+-', interval_width, found%half_width, units%force, 1)
            call add_cell(table, 'Torque', cell_width, difference(found%torque_above, found%torque_below), units%moment, 2)
            call end_row(table, merge(' !', '  ', found%status == sticking_at_bound))
         end associate
      end do
      call append_table(lines, table)
      call append_text(lines, 'Free: hook load of a free string. Above: tension just above the point. Below: tension there '// &
                       'in a free string.')
      call append_text(lines, 'Resists: Above - Below; > 0 holds the string down, < 0 up. '// &
                       '+-: 95 % interval from the error of the gauge alone.')
      if (any(results%status == sticking_at_bound)) call append_text(lines, &
         '! less torque was measured than friction above the point takes. Lower the friction around the hole')
   end subroutine append_resistances

   subroutine append_free_points(lines, units, model, sticking, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(sticking_type), intent(in) :: sticking
      type(sticking_result_type), intent(in) :: results(:)
      character(*), parameter :: below_bit = 'below the bit: the whole string stretches less than measured'
      character(:), allocatable :: text
      integer :: i
      associate (first => model%cases(sticking%cases(1)), second => model%cases(sticking%cases(2)))
         call append_text(lines, 'Free point '//sticking%name//': stretch '// &
            in_units(units, unit_length, sticking%stretch, stretch_digits)//' from '// &
            shown(first%measured_hookload%value)//' to '//shown(second%measured_hookload%value)//' '// &
            trim(units%force_label)//', string of '//in_units(units, unit_length, second%bit_depth, depth_digits))
         call append_text(lines, '  without friction, by sections:  '//point(results(1)%depth_without_friction))
         do i = 1, size(results)
            text = 'no solution'
            if (results(i)%status == sticking_below_bit) text = below_bit
            if (.not. is_missing(results(i)%depth)) text = point(results(i)%depth)//', tension there '// &
               shown(results(i)%tension_above)//' '//trim(units%force_label)//' at the second pull'
            call append_text(lines, '  with friction, model '//left_aligned(trim(model_name(results(i)%model))//':', 10)//' '//text)
         end do
      end associate
   contains
      function point(depth) result(words)
         real(wp), intent(in) :: depth
         character(:), allocatable :: words
         words = to_text(anint(10.0_wp*depth/units%length)/10.0_wp, depth_digits)//' '//trim(units%length_label)
         if (depth > model%cases(sticking%cases(2))%bit_depth) words = below_bit
      end function point

      function shown(value) result(words)
         real(wp), intent(in) :: value
         character(:), allocatable :: words
         words = fixed_text(value/units%force, 1)
      end function shown
   end subroutine append_free_points
end module dg_sticking_table

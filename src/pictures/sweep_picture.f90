!> The broomstick: hook load, and torque where anything turns, against bit depth, from sweep_<name>.csv. An operation is a
!> colour, a friction factor a dash; what was measured is laid over it.
module dg_sweep_picture
   use dg_kinds, only: wp
   use dg_broomstick_panels, only: add_limits, draw_broomstick, start_broomstick
   use dg_column, only: column_header, column_named
   use dg_gnuplot_script, only: add_series, colour_black, dash_of, marked_line_style, results_file, series_type
   use dg_job, only: model_name
   use dg_load_case, only: operation_label, operation_name, rotates
   use dg_rig, only: rig_type
   use dg_sweep, only: at_operation, sweep_type
   use dg_sweep_file, only: sweep_columns
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: sweep_script

   integer, parameter :: digits = 8
   !> Marks of measured points: open forms, one an operation.
   integer, parameter :: open_marks(8) = [6, 4, 8, 12, 10, 14, 2, 1]

contains

   !> One model's curves.
   subroutine sweep_script(name, units, sweep, model, rig, lines)
      character(*), intent(in) :: name      !< of the picture
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: model          !< number of the model
      type(rig_type), intent(in) :: rig     !< where it is given hook loads are as it shows them
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: key(:), hookload(:), torque(:)
      integer :: i, k
      call start_broomstick(lines, name)
      call append_text(lines, 'pick(operation, is_friction, value) = stringcolumn(''model'') eq '''//trim(model_name(model))// &
                       ''' && stringcolumn(''operation'') eq operation && is_friction && stringcolumn(''status'') eq '// &
                       '''converged'' ? value : NaN')
      do i = 1, size(sweep%operations)
         call add_series(key, 'NaN', marked_line_style(i, 1, 2.2_wp, dash_of(1)), &
                         trim(operation_label(sweep%operations(i))))
         if (any(sweep%measured%operation == sweep%operations(i))) &
            call add_series(key, 'NaN', measured_look(i), trim(operation_label(sweep%operations(i)))//', measured')
      end do
      do k = 1, size(sweep%frictions)
         call add_series(key, 'NaN', "with lines lw 1.5 dt "//dash_of(k)//" lc rgb '"//colour_black//"'", &
                         friction_label(sweep, k))
      end do
      hookload = curves(trim(merge('weight_indicator', 'hookload        ', rig%given)), 'measured_hookload', .false.)
      torque = curves('torque', 'measured_torque', .true.)
      call add_limits(key, hookload, torque, units, rig, sweep, results_file('sweep_'//sweep%name), &
                      column_header(column_named(sweep_columns, 'bit_depth'), units))
      call draw_broomstick(lines, 'Sweep '//sweep%name//', model '//trim(model_name(model)), key, units, maxval(sweep%depths), &
                           hookload, torque, rig%given)

   contains

      !> The curves of one panel; `turning`: only operations that have torque.
      pure function curves(column, measured, turning) result(series)
         character(*), intent(in) :: column, measured
         logical, intent(in) :: turning
         type(series_type), allocatable :: series(:)
         integer :: operation, friction
         allocate (series(0))
         do operation = 1, size(sweep%operations)
            if (turning .and. .not. (rotates(sweep%operations(operation)) .or. &
                                     abs(at_operation(sweep%tob, operation)) > 0.0_wp)) cycle
            do friction = 1, size(sweep%frictions)
               call add_series(series, curve(operation, friction_test(sweep, friction), column), &
                               marked_line_style(operation, size(sweep%depths), 1.6_wp, dash_of(friction)), '')
            end do
            if (any(sweep%measured%operation == sweep%operations(operation))) call add_series(series, &
               curve(operation, friction_test(sweep, 1), measured), measured_look(operation), '')
         end do
      end function curves

      pure function curve(operation, test, column) result(using)
         integer, intent(in) :: operation
         character(*), intent(in) :: test, column
         character(:), allocatable :: using
         using = results_file('sweep_'//sweep%name)//" using (pick('"//trim(operation_name(sweep%operations(operation)))//"', "// &
            test//", column('"//column_header(column_named(sweep_columns, column), units)//"'))):(column('"// &
            column_header(column_named(sweep_columns, 'bit_depth'), units)//"'))"
      end function curve
   end subroutine sweep_script

   pure function measured_look(operation) result(look)
      integer, intent(in) :: operation
      character(:), allocatable :: look
      look = 'with points pt '//to_text(open_marks(1 + mod(operation - 1, size(open_marks))))//" ps 1.2 lw 1.6 lc rgb '"// &
         colour_black//"'"
   end function measured_look

   pure function friction_label(sweep, number) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number      !< of the friction factor
      character(:), allocatable :: text
      text = 'friction of the hole'
      if (sweep%frictions(number)%present) text = 'friction '//to_text(sweep%frictions(number)%value, digits)
      if (allocated(sweep%frictions_cased)) text = text//', cased '//to_text(sweep%frictions_cased(number), digits)
   end function friction_label

   !> Whether a row of the file has that friction factor, in gnuplot's words.
   pure function friction_test(sweep, number) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number      !< of the friction factor
      character(:), allocatable :: text
      text = "stringcolumn('friction') eq ''"
      ! the file has ten digits
      if (sweep%frictions(number)%present) text = "abs(column('friction') - "//to_text(sweep%frictions(number)%value)//') < 1e-9'
      if (allocated(sweep%frictions_cased)) text = '('//text//" && abs(column('friction_cased') - "// &
         to_text(sweep%frictions_cased(number))//') < 1e-9)'
   end function friction_test
end module dg_sweep_picture

!> The broomstick: hook load, and torque where anything turns, against bit depth, from sweep_<name>.csv. An operation is a
!> colour, a friction factor a dash; what was measured is laid over it.
module dg_sweep_picture
   use dg_kinds, only: wp
   use dg_broomstick_panels, only: add_limits, broomstick_limits_type, draw_broomstick, locked_look, measured_look, start_broomstick
   use dg_case_result, only: result_locked_up, result_status_name
   use dg_column, only: column_header, column_named
   use dg_gnuplot_script, only: add_series, colour_black, dash_of, marked_line_style, results_file, series_type, style_count
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_name
   use dg_load_case, only: block_way, operation_label, operation_name, rotates
   use dg_rig, only: indicated_load, rig_type
   use dg_sweep, only: at_operation, point_number, point_type, sweep_type
   use dg_sweep_file, only: sweep_columns
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_name, answer_no
   implicit none
   private
   public :: sweep_script

   integer, parameter :: digits = 8
   !> Of a limit, as that of the rig, but dotted: it bends with depth.
   character(*), parameter :: yield_look = "with lines lw 2.2 dt (2,3) lc rgb '#c00000'"

contains

   !> One model's curves.
   subroutine sweep_script(name, units, sweep, model, rig, holes, yields, lines)
      character(*), intent(in) :: name      !< of the picture
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: model          !< number of the model
      type(rig_type), intent(in) :: rig     !< where it is given hook loads are as it shows them
      type(hole_section_type), intent(in) :: holes(:)
      logical, intent(in) :: yields         !< the file has pulls that may be added before anything yields
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: key(:), hookload(:), torque(:)
      type(broomstick_limits_type) :: limits
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
      call append_text(lines, "stuck(operation, is_friction, value) = stringcolumn('model') eq '"//trim(model_name(model))// &
                       "' && stringcolumn('operation') eq operation && is_friction && stringcolumn('can_be_done') eq '"// &
                       trim(answer_name(answer_no))//"' ? value : NaN")
      call add_series(key, 'NaN', locked_look(style_count), 'cannot be done')
      if (yields) call add_series(key, 'NaN', yield_look, 'yield in the string, '// &
                                  trim(operation_label(sweep%operations(pulling(sweep))))//', '// &
                                  friction_label(sweep, size(sweep%frictions)))
      hookload = curves(trim(merge('weight_indicator', 'hookload        ', rig%given)), 'measured_hookload', .false.)
      torque = curves('torque', 'measured_torque', .true.)
      ! other factors put it a hair's breadth beside
      if (yields) call add_series(hookload, yield_curve(pulling(sweep), size(sweep%frictions)), &
                                  yield_look, '')
      call add_limits(hookload, torque, limits, units, rig, sweep, results_file('sweep_'//sweep%name), &
                      column_header(column_named(sweep_columns, 'bit_depth'), units))
      call draw_broomstick(lines, 'Sweep '//sweep%name//', model '//trim(model_name(model)), key, units, holes, &
                           sweep, hookload, torque, limits)

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
               call add_series(series, curve(operation, friction, column), &
                               marked_line_style(operation, size(sweep%depths), 1.6_wp, dash_of(friction)), '')
               if (.not. turning) call add_series(series, impossible(operation, friction), locked_look(operation), '')
            end do
            if (any(sweep%measured%operation == sweep%operations(operation))) call add_series(series, &
               curve(operation, 1, measured), measured_look(operation), '')
         end do
      end function curves

      !> Depths at which it cannot be done: at the hook load, and at an empty hook where the string locks up.
      pure function impossible(operation, friction) result(using)
         integer, intent(in) :: operation, friction
         character(:), allocatable :: using
         real(wp) :: slack
         slack = 0.0_wp
         if (rig%given) slack = indicated_load(rig, sweep%operations(operation), 0.0_wp)
         using = rows_of(sweep, model, operation, friction)//" using (stuck('"// &
            trim(operation_name(sweep%operations(operation)))//"', "//friction_test(sweep, friction)// &
            ", stringcolumn('status') eq '"//trim(result_status_name(result_locked_up))//"' ? "// &
            to_text(slack/units%force, digits)//" : column('"//column_header(column_named(sweep_columns, &
            trim(merge('weight_indicator', 'hookload        ', rig%given))), units)//"'))):(column('"// &
            column_header(column_named(sweep_columns, 'bit_depth'), units)//"'))"
      end function impossible

      !> Hook load at which the string yields, as the panel shows hook loads.
      pure function yield_curve(operation, friction) result(using)
         integer, intent(in) :: operation, friction
         character(:), allocatable :: using
         real(wp) :: empty, slope
         real(wp), parameter :: unit_load = 1.0e6_wp      ! what a rig shows is linear in the hook load
         empty = 0.0_wp
         slope = 1.0_wp
         if (rig%given) then
            empty = indicated_load(rig, sweep%operations(operation), 0.0_wp)
            slope = (indicated_load(rig, sweep%operations(operation), unit_load) - empty)/unit_load
         end if
         using = rows_of(sweep, model, operation, friction)//" using (pick('"// &
            trim(operation_name(sweep%operations(operation)))//"', "// &
            friction_test(sweep, friction)//', '//to_text(empty/units%force, digits)//' + '//to_text(slope, digits)// &
            "*(column('"//column_header(column_named(sweep_columns, 'hookload'), units)//"') + column('"// &
            column_header(column_named(sweep_columns, 'overpull_margin'), units)//"')))):(column('"// &
            column_header(column_named(sweep_columns, 'bit_depth'), units)//"'))"
      end function yield_curve

      pure function curve(operation, friction, column) result(using)
         integer, intent(in) :: operation, friction
         character(*), intent(in) :: column
         character(:), allocatable :: using
         using = rows_of(sweep, model, operation, friction)//" using (pick('"// &
            trim(operation_name(sweep%operations(operation)))//"', "// &
            friction_test(sweep, friction)//", column('"//column_header(column_named(sweep_columns, column), units)// &
            "'))):(column('"//column_header(column_named(sweep_columns, 'bit_depth'), units)//"'))"
      end function curve
   end subroutine sweep_script

   !> The file, and the rows of a curve in it: gnuplot looks at each row of a file for each curve, and 1,300 rows for 22 curves took
   !> it longer than all the rest of the picture.
   pure function rows_of(sweep, model, operation, friction) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: model          !< number of the model
      integer, intent(in) :: operation, friction      !< numbers of them in the sweep
      character(:), allocatable :: text
      integer :: first
      first = point_number(sweep, point_type(findloc(sweep%models, model, dim=1), operation, friction, 1))
      text = results_file('sweep_'//sweep%name)//' every ::'//to_text(first - 1)//'::'//to_text(first + size(sweep%depths) - 2)
   end function rows_of

   !> The operation of a sweep whose overpull is shown: the first that pulls, else the first.
   pure function pulling(sweep) result(operation)
      type(sweep_type), intent(in) :: sweep
      integer :: operation      !< number of it in the sweep
      operation = max(1, findloc(block_way(sweep%operations) > 0, .true., dim=1))
   end function pulling

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

!> Picture of another program's results beside ours, from legacy_<label>.csv: each quantity that it has, and the difference.
module dg_legacy_picture
   use dg_kinds, only: wp
   use dg_column, only: column_header, column_named, column_type, unit_text
   use dg_depth_panels, only: name_no_sections, panel_place_type, put_sections
   use dg_gnuplot_script, only: add_series, colour_measured, end_script, legend, line_style, panel, plot, results_file, &
                                series_type, start_script
   use dg_hole_section, only: hole_section_type
   use dg_job, only: job_type, model_name
   use dg_legacy_rows, only: legacy_columns
   use dg_legacy_table, only: legacy_table_type, quantity_count, quantity_name
   use dg_text, only: append_text, text_type, to_text
   implicit none
   private
   public :: legacy_script

   integer, parameter :: digits = 8
   integer, parameter :: width = 1120, height = 580
   !> What each quantity is called on its axis.
   character(*), parameter :: axis_name(quantity_count) = [character(21) :: 'effective axial force', 'torque', 'side force']

contains

   !> Script of the picture of another program's table beside our results of its case.
   pure subroutine legacy_script(name, job, table, case_name, holes, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(legacy_table_type), intent(in) :: table
      character(*), intent(in) :: case_name
      type(hole_section_type), intent(in) :: holes(:)
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      real(wp), parameter :: left = 0.075_wp, right = 0.985_wp, gap = 0.025_wp, bottom = 0.125_wp, top = 0.84_wp, &
                             legend_top = 0.92_wp
      real(wp) :: wide, start
      character(:), allocatable :: label
      type(column_type) :: shown
      integer :: k, m, quantity
      call start_script(lines, name, width, height)
      call append_text(lines, "ours(model, value) = stringcolumn('model') eq model ? value : NaN")
      do m = 1, size(job%models)
         call add_series(series, 'NaN', line_style(m), trim(model_name(job%models(m))))
      end do
      call add_series(series, 'NaN', theirs(), table%label)
      call legend(lines, 'Case '//case_name//' beside '//table%label, series, top, legend_top)
      call append_text(lines, 'set yrange ['//to_text(maxval(table%md)/job%units%length, digits)//':0]')
      wide = (right - left + gap)/real(2*count(table%has), wp) - gap
      start = left
      call put_sections(lines, holes, job%units, maxval(table%md), &
                        panel_place_type(left, left + wide, bottom, top, width, height), .true.)
      label = 'measured depth ['//trim(job%units%length_label)//']'
      do quantity = 1, quantity_count
         if (.not. table%has(quantity)) cycle
         shown = column_named(legacy_columns, trim(quantity_name(quantity)))
         do k = 1, 2
            deallocate (series)
            do m = 1, size(job%models)
               call add_series(series, curve("ours('"//trim(model_name(job%models(m)))//"', "// &
                                             value(trim(quantity_name(quantity))//trim(ending(k)))//')'), line_style(m), '')
            end do
            if (k == 1) call add_series(series, curve("ours('"//trim(model_name(job%models(1)))//"', "// &
                                                      value('legacy_'//trim(quantity_name(quantity)))//')'), theirs(), '')
            call panel(lines, start, start + wide, bottom, top, trim(axis_name(quantity))//trim(axis_ending(k))//' ['// &
                       unit_text(shown%quantity, job%units)//']', label)
            call plot(lines, series, may_lack=.true.)
            if (label /= '') call name_no_sections(lines)
            label = ''
            start = start + wide + gap
         end do
      end do
      call end_script(lines)

   contains

      pure function ending(k) result(text)
         integer, intent(in) :: k
         character(11) :: text
         text = merge('_difference', '           ', k == 2)
      end function ending

      pure function axis_ending(k) result(text)
         integer, intent(in) :: k
         character(19) :: text
         text = merge(', theirs less ours ', '                   ', k == 2)
      end function axis_ending

      pure function curve(expression) result(using)
         character(*), intent(in) :: expression
         character(:), allocatable :: using
         using = results_file('legacy_'//table%label)//' using ('//expression//'):('//value('md')//')'
      end function curve

      pure function value(column) result(text)
         character(*), intent(in) :: column
         character(:), allocatable :: text
         text = "column('"//column_header(column_named(legacy_columns, column), job%units)//"')"
      end function value
   end subroutine legacy_script

   pure function theirs() result(look)
      character(:), allocatable :: look
      look = "with linespoints pt 6 ps 0.6 lw 1.0 dt (3,3) lc rgb '"//colour_measured//"'"
   end function theirs
end module dg_legacy_picture

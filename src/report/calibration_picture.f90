!> What a calibration found, from calibration.csv and calibration_data.csv: friction factors with their 95 % intervals beside
!> those of the deck, and the error of every load case before and after.
module dg_calibration_picture
   use dg_kinds, only: wp
   use dg_calibration, only: calibration_type
   use dg_calibration_table, only: unknown_text
   use dg_gnuplot_script, only: add_series, colour_grey, colour_of, end_script, legend, panel, plot, series_type, spelled, &
                                start_script
   use dg_job, only: job_type, model_name
   use dg_model, only: model_type
   use dg_text, only: append_text, text_type, to_text
   implicit none
   private
   public :: calibration_script

   integer, parameter :: digits = 8
   integer, parameter :: width = 1120, height = 560

contains

   subroutine calibration_script(name, job, model, calibration, number, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      integer, intent(in) :: number         !< of the model that was calibrated
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      real(wp), parameter :: left(2) = [0.21_wp, 0.67_wp], right(2) = [0.55_wp, 0.985_wp], bottom = 0.125_wp, top = 0.84_wp, &
                             legend_top = 0.92_wp
      character(*), parameter :: factors = "'../calibration.csv'", data = "'../calibration_data.csv'"
      character(:), allocatable :: deck, found, interval, factor_tics, case_tics
      integer :: i, rows
      deck = "with points pt 6 ps 1.1 lw 1.4 lc rgb '"//colour_grey//"'"
      found = "with points pt 7 ps 0.9 lc rgb '"//colour_of(1)//"'"
      interval = "with xerrorbars pt 0 lw 1.4 lc rgb '"//colour_of(1)//"'"
      rows = 0
      factor_tics = ''
      do i = 1, size(calibration%unknowns)
         if (calibration%unknowns(i)%is_offset) cycle
         rows = rows + 1
         factor_tics = factor_tics//merge('  ', ', ', rows == 1)//spelled(unknown_text(job%units, model, &
                       calibration%unknowns(i)))//' '//to_text(rows)
      end do
      case_tics = ''
      do i = 1, size(calibration%data)
         case_tics = case_tics//merge('  ', ', ', i == 1)// &
            spelled(model%cases(calibration%cases(calibration%data(i)%case))%name)//' '//to_text(i)
      end do
      call start_script(lines, name, width, height)
      call append_text(lines, "mine(x) = stringcolumn('calibration') eq '"//calibration%name//"' && stringcolumn('model') eq '"// &
                       trim(model_name(number))//"'")
      call append_text(lines, "factor(value) = mine(0) && strlen(stringcolumn('value')) > 0 ? (n = n + 1, value) : NaN")
      call append_text(lines, 'only(value) = mine(0) ? value : NaN')
      call append_text(lines, 'datum(value) = mine(0) ? (n = n + 1, value) : NaN')
      call add_series(series, 'NaN', deck, 'before')
      call add_series(series, 'NaN', found, 'after')
      call add_series(series, 'NaN', "with lines lw 1.4 lc rgb '"//colour_of(1)//"'", '95 % interval')
      call legend(lines, 'Calibration '//calibration%name//', model '//trim(model_name(number)), series, top, legend_top)
      deallocate (series)
      call add_series(series, 'n = 0, '//factors//" using (factor(column('start'))):(n)", deck, '')
      call add_series(series, 'n = 0, '//factors//" using (factor(column('value'))):(n)", found, '')
      call add_series(series, 'n = 0, '//factors//" using (factor(column('value'))):(n):(only(column('lower'))):"// &
                      "(only(column('upper')))", &
                      interval, '')
      call panel(lines, left(1), right(1), bottom, top, 'friction factor', ' ')
      call draw(rows, factor_tics)
      deallocate (series)
      call add_series(series, 'n = 0, '//data//" using (datum(column('before_error_pct'))):(n)", deck, '')
      call add_series(series, 'n = 0, '//data//" using (datum(column('after_error_pct'))):(n)", found, '')
      call panel(lines, left(2), right(2), bottom, top, 'error against measurement [%]', ' ')
      call append_text(lines, 'set xrange [0:*]')
      call draw(size(calibration%data), case_tics)
      call end_script(lines)

   contains

      !> The curves over so many named rows, the first on top.
      subroutine draw(rows, tics)
         integer, intent(in) :: rows
         character(*), intent(in) :: tics
         call append_text(lines, 'set yrange ['//to_text(real(rows, wp) + 0.6_wp, digits)//':0.4]; set ytics ('//tics// &
                          '); unset ylabel')
         call plot(lines, series)
      end subroutine draw
   end subroutine calibration_script
end module dg_calibration_picture

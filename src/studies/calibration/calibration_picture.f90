!> What a calibration found, from calibration.csv and calibration_data.csv: friction factors with their 95 % intervals beside
!> those of the deck, the gauge's offsets where they were looked for, and the error of every load case before and after.
module dg_calibration_picture
   use dg_kinds, only: wp
   use dg_calibration, only: calibration_type, unknown_type
   use dg_calibration_table, only: unknown_text
   use dg_column, only: column_header, column_named
   use dg_factor_columns, only: factor_columns
   use dg_gnuplot_script, only: add_series, colour_grey, colour_of, end_script, legend, panel, plot, results_file, row_tics, &
                                series_type, start_script
   use dg_job, only: model_name
   use dg_model, only: model_type
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: calibration_script

   integer, parameter :: digits = 8
   integer, parameter :: width = 1120, height = 560

contains

   !> One calibration with one of its models.
   subroutine calibration_script(name, units, model, calibrations, number, place, lines)
      character(*), intent(in) :: name      !< of the picture
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibrations(:)
      integer, intent(in) :: number         !< of the calibration in the deck
      integer, intent(in) :: place          !< of the model in the calibration's
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      real(wp), parameter :: left(2) = [0.21_wp, 0.67_wp], right(2) = [0.55_wp, 0.985_wp], bottom = 0.125_wp, top = 0.84_wp, &
                             legend_top = 0.92_wp
      !> Height of an axis with its labels, between two panels.
      real(wp), parameter :: axis_height = 0.13_wp
      character(:), allocatable :: factors, data, deck, found, interval
      type(calibration_type) :: calibration
      type(text_type), allocatable :: names(:)
      real(wp) :: middle, share
      integer, allocatable :: rows_of_factors(:), rows_of_data(:)   !< a calibration, by one model
      integer :: i, rows, offsets
      calibration = calibrations(number)
      factors = results_file('calibration')
      data = results_file('calibration_data')
      deck = "with points pt 6 ps 1.1 lw 1.4 lc rgb '"//colour_grey//"'"
      found = "with points pt 7 ps 0.9 lc rgb '"//colour_of(1)//"'"
      interval = "with xerrorbars pt 0 lw 1.4 lc rgb '"//colour_of(1)//"'"
      allocate (names(size(calibration%data)))
      do i = 1, size(calibration%data)
         names(i)%text = model%cases(calibration%cases(calibration%data(i)%case))%name
      end do
      call start_script(lines, name, width, height)
      ! rows by their numbers, gnuplot's column 0: a name may be one that it does not read back as it is
      rows_of_factors = [(size(calibrations(i)%unknowns), i=1, size(calibrations))]
      rows_of_data = [(size(calibrations(i)%data), i=1, size(calibrations))]
      call append_text(lines, 'mine(x) = '//is_mine(rows_of_factors))
      call append_text(lines, 'row(name, value) = mine(0) && strlen(stringcolumn(name)) > 0 ? (n = n + 1, value) : NaN')
      call append_text(lines, 'only(value) = mine(0) ? value : NaN')
      call append_text(lines, 'datum(value) = '//is_mine(rows_of_data)//' ? (n = n + 1, value) : NaN')
      call add_series(series, 'NaN', deck, 'before')
      call add_series(series, 'NaN', found, 'after')
      call add_series(series, 'NaN', "with lines lw 1.4 lc rgb '"//colour_of(1)//"'", '95 % interval')
      call legend(lines, 'Calibration '//calibration%name//', model '//trim(model_name(calibration%models(place))), series, &
                  top, legend_top)
      ! friction above, offsets of the gauge below, each with the height that its rows ask for
      offsets = count(calibration%unknowns%is_offset)
      middle = bottom
      if (offsets > 0) then
         share = real(offsets, wp)/real(size(calibration%unknowns), wp)
         middle = bottom + share*(top - bottom - axis_height) + axis_height
      end if
      call draw_factors('friction factor', .false., 'value', 'lower', 'upper', middle, top)
      if (offsets > 0) call draw_factors('offset of the gauge ['//trim(units%force_label)//']', .true., heading('offset'), &
                                         heading('offset_lower'), heading('offset_upper'), bottom, middle - axis_height)
      deallocate (series)
      call add_series(series, 'n = 0, '//data//" using (datum(column('before_error_pct'))):(n)", deck, '')
      call add_series(series, 'n = 0, '//data//" using (datum(column('after_error_pct'))):(n)", found, '')
      call panel(lines, left(2), right(2), bottom, top, 'error against measurement [%]', ' ')
      call append_text(lines, 'set xrange [0:*]')
      call draw(size(calibration%data), row_tics(names, left(2) - right(1), width))
      call end_script(lines)

   contains

      !> Whether a row is one of this calibration and model, in gnuplot's words.
      pure function is_mine(rows) result(text)
         integer, intent(in) :: rows(:)      !< of each calibration by one model
         character(:), allocatable :: text
         integer :: before, k
         before = (place - 1)*rows(number)
         do k = 1, number - 1
            before = before + size(calibrations(k)%models)*rows(k)
         end do
         text = 'column(0) >= '//to_text(before)//' && column(0) < '//to_text(before + rows(number))
      end function is_mine

      !> Factors of one kind, their intervals and, of friction, what the deck has.
      subroutine draw_factors(label, is_offset, value, lower, upper, low, high)
         character(*), intent(in) :: label
         logical, intent(in) :: is_offset
         character(*), intent(in) :: value, lower, upper   !< columns
         real(wp), intent(in) :: low, high                 !< ends of the panel
         type(unknown_type) :: unknown
         type(text_type) :: factors_shown(size(calibration%unknowns))
         character(:), allocatable :: using
         if (allocated(series)) deallocate (series)
         rows = 0
         do i = 1, size(calibration%unknowns)
            unknown = calibration%unknowns(i)
            if (unknown%is_offset .neqv. is_offset) cycle
            unknown%is_offset = .false.    ! the axis says so
            rows = rows + 1
            factors_shown(rows)%text = unknown_text(units, model, unknown)
         end do
         if (rows == 0) return
         using = 'n = 0, '//factors//" using (row('"//value//"', column('"
         if (.not. is_offset) call add_series(series, using//"start'))):(n)", deck, '')
         call add_series(series, using//value//"'))):(n)", found, '')
         call add_series(series, using//value//"'))):(n):(only(column('"//lower//"'))):(only(column('"//upper//"')))", interval, '')
         call panel(lines, left(1), right(1), low, high, label, ' ')
         call draw(rows, row_tics(factors_shown(:rows), left(1), width))
      end subroutine draw_factors

      !> Heading of a column of calibration.csv.
      pure function heading(column) result(text)
         character(*), intent(in) :: column
         character(:), allocatable :: text
         text = column_header(column_named(factor_columns, column), units)
      end function heading

      !> The curves over so many named rows, the first on top.
      subroutine draw(rows, tics)
         integer, intent(in) :: rows
         character(*), intent(in) :: tics
         call append_text(lines, 'set yrange ['//to_text(real(rows, wp) + 0.6_wp, digits)//':0.4]; set ytics ('//tics// &
                          '); unset ylabel')
         call plot(lines, series, may_lack=.true.)
      end subroutine draw
   end subroutine calibration_script
end module dg_calibration_picture

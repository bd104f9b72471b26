!> Picture of a calibration's results. It shows friction factors with their 95 % intervals beside those of the deck. It also
!> shows offsets of the gauge if they were unknowns, and the error of every load case before and after.
module dg_calibration_picture
   use dg_kinds, only: wp
   use dg_calibration, only: calibration_type, torque_datum, unknown_type
   use dg_calibration_result, only: calibration_result_type
   use dg_calibration_table, only: unknown_text
   use dg_chart, only: add_curve, add_key, add_points, add_rows, chart_type, new_chart
   use dg_comparison, only: percent_error
   use dg_curve_look, only: colour_grey, colour_of
   use dg_job, only: model_name
   use dg_least_squares, only: fit_done
   use dg_missing, only: given, is_missing, missing, optional_real
   use dg_quantity, only: quantity_force, quantity_none, quantity_percent
   use dg_model, only: model_type
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: calibration_chart

   integer, parameter :: before = 1, after = 2, interval = 3
   character(*), parameter :: deck_look = "with points pt 6 ps 1.1 lw 1.4 lc rgb '"//colour_grey//"'"

contains

   !> One calibration with one of its models.
   function calibration_chart(name, units, model, calibration, found) result(chart)
      character(*), intent(in) :: name      !< of the picture
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      type(calibration_result_type), intent(in) :: found
      type(chart_type) :: chart
      real(wp), parameter :: left(2) = [0.21_wp, 0.67_wp], right(2) = [0.55_wp, 0.985_wp], bottom = 0.125_wp, top = 0.84_wp
      !> Height of an axis with its labels, between two panels.
      real(wp), parameter :: axis_height = 0.13_wp
      character(:), allocatable :: found_look
      type(text_type) :: names(size(calibration%data))
      real(wp) :: middle, share
      integer :: i, n, offsets
      found_look = "with points pt 7 ps 0.9 lc rgb '"//colour_of(1)//"'"
      chart = new_chart(name, 'Calibration '//calibration%name//', model '//trim(model_name(found%model)), units, 560, &
                        [top, 0.92_wp])
      ! entries of the legend: before, after, interval
      call add_key(chart, deck_look, 'before')
      call add_key(chart, found_look, 'after')
      call add_key(chart, "with lines lw 1.4 lc rgb '"//colour_of(1)//"'", '95 % interval')
      ! friction above, offsets of the gauge below, each with the height that its rows ask for
      offsets = count(calibration%unknowns%is_offset)
      middle = bottom
      if (offsets > 0) then
         share = real(offsets, wp)/real(size(calibration%unknowns), wp)
         middle = bottom + share*(top - bottom - axis_height) + axis_height
      end if
      call add_factors('friction factor', quantity_none, 1.0_wp, middle, top)
      call add_factors('offset of the gauge', quantity_force, units%force, bottom, middle - axis_height)
      n = size(names)
      do i = 1, n
         names(i)%text = model%cases(calibration%cases(calibration%data(i)%case))%name
         if (calibration%data(i)%kind == torque_datum) names(i)%text = names(i)%text//', torque'
      end do
      call add_rows(chart, [left(2), right(2), bottom, top], 'error against measurement', quantity_percent, names, &
                    left(2) - right(1))
      chart%panels(size(chart%panels))%x%ends(1) = 0.0_wp
      call add_errors(found%before, deck_look, before)
      if (found%fit%status == fit_done) call add_errors(found%fit%values, found_look, after)

   contains

      !> Factors of one kind, their intervals and, of friction, what the deck has.
      subroutine add_factors(label, quantity, unit, low, high)
         character(*), intent(in) :: label
         integer, intent(in) :: quantity                   !< a force: of offsets
         real(wp), intent(in) :: unit
         real(wp), intent(in) :: low, high                 !< ends of the panel
         type(text_type) :: shown(count(calibration%unknowns%is_offset .eqv. quantity == quantity_force))
         integer :: rows(size(shown))
         real(wp) :: bars(4, size(shown))
         type(unknown_type) :: unknown
         if (size(shown) == 0) return
         rows = pack([(i, i=1, size(calibration%unknowns))], calibration%unknowns%is_offset .eqv. quantity == quantity_force)
         do i = 1, size(rows)
            unknown = calibration%unknowns(rows(i))
            unknown%is_offset = .false.    ! the axis says so
            shown(i)%text = unknown_text(units, model, unknown)
         end do
         call add_rows(chart, [left(1), right(1), low, high], label, quantity, shown, left(1))
         bars(2, :) = [(real(i, wp), i=1, size(rows))]
         if (quantity == quantity_none) call add_curve(chart, found%start(rows), bars(2, :), deck_look, '', [before])
         associate (values => found%fit%unknowns(rows), half => found%statistics%half_width(rows))
            call add_curve(chart, values/unit, bars(2, :), found_look, '', [after])
            bars(1, :) = values/unit
            bars(3, :) = (values - half)/unit
            bars(4, :) = (values + half)/unit
            call add_points(chart, bars(:, pack([(i, i=1, size(rows))], .not. is_missing(half))), &
                            "with xerrorbars pt 0 lw 1.4 lc rgb '"//colour_of(1)//"'", [interval])
         end associate
      end subroutine add_factors

      !> Errors of what was calculated against what was measured.
      subroutine add_errors(calculated, look, key)
         real(wp), intent(in) :: calculated(:)
         character(*), intent(in) :: look
         integer, intent(in) :: key                        !< entry of the legend
         type(optional_real) :: errors(n)
         errors = percent_error(calculated, given(calibration%data%measured))
         call add_curve(chart, merge(errors%value, missing, errors%present), &
                        [(real(i, wp), i=1, n)], look, '', [key])
      end subroutine add_errors
   end function calibration_chart
end module dg_calibration_picture

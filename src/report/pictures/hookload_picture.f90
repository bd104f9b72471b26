!> Picture of a whole run: hook load of every case by every model, with measurement and reference. Beside it are the error
!> against measurement, and torque if any case has one.
module dg_hookload_picture
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged
   use dg_chart, only: add_curve, add_key, add_rows, beside, chart_type, key_of, new_chart, panel_type
   use dg_findings, only: are_marked, findings_type
   use dg_quantity, only: quantity_force, quantity_moment, quantity_percent
   use dg_comparison, only: as_measured, percent_error
   use dg_curve_look, only: colour_black, colour_white, letter_width, mark_style
   use dg_job, only: model_name
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing, optional_real
   use dg_rig, only: indicated_load
   use dg_text, only: either, text_type
   use dg_verdict_text, only: mark_meaning, row_mark
   implicit none
   private
   public :: hookload_chart

   integer, parameter :: width = 1120
   !> Heights [px]: of a case by one model, of each further model, of title and legend, of the axis below.
   integer, parameter :: row_height = 26, model_height = 6, head_height = 84, foot_height = 62
   !> Part of a case's height in which the marks of its models stand one below the other: they would hide each other in a row.
   real(wp), parameter :: spread = 0.6_wp
   !> Largest part of the picture that names of cases may take.
   real(wp), parameter :: most_names = 0.3_wp
   character(*), parameter :: measured_look = "with points pt 2 ps 1.1 lw 1.6 lc rgb '"//colour_black//"'", &
                              reference_look = "with points pt 6 ps 1.3 lw 1.2 lc rgb '"//colour_black//"'", &
                              no_look = "with lines lc rgb '"//colour_white//"'"

contains

   !> Make the chart of all hook loads with measured ones.
   function hookload_chart(found) result(chart)
      type(findings_type), intent(in) :: found
      type(chart_type) :: chart
      type(text_type) :: names(size(found%model%cases))
      !> By case and model, as they are shown.
      real(wp), dimension(size(found%model%cases), size(found%job%models)) :: hookload, error, torque
      logical :: marked(size(found%results))
      type(optional_real) :: loads(size(found%model%cases))
      real(wp) :: left, bottom, top, height
      logical :: with_error, with_torque
      integer :: i, n, panels, longest, height_px
      n = size(found%model%cases)
      marked = are_marked(found)
      height_px = head_height + foot_height + (row_height + model_height*(size(found%job%models) - 1))*n
      height = real(height_px, wp)
      call find_values(found, hookload, error, torque)
      with_error = any(.not. is_missing(error))
      with_torque = any(.not. is_missing(torque))
      panels = 1 + count([with_error, with_torque])
      longest = 0
      do i = 1, n
         names(i)%text = found%model%cases(i)%name
         names(i)%text = names(i)%text//mark_of(found%results%model, marked, found%results%case_index == i)
         longest = max(longest, len(names(i)%text))
      end do
      left = min(most_names, letter_width*real(longest + 2, wp)/real(width, wp))
      bottom = real(foot_height, wp)/height
      top = 1.0_wp - real(head_height, wp)/height
      chart = new_chart('hookload', 'Hook load of all cases', found%job%units, height_px, &
                        [top + 8.0_wp/height, 1.0_wp - 40.0_wp/height])
      call add_rows(chart, place(), either('hook load as the rig shows it', 'hook load', &
                                           found%model%rig%given), quantity_force, names, left)
      chart%panels(1)%air(1) = 0.04_wp         ! no mark on the frame
      do i = 1, size(found%job%models)
         call add_marks(hookload(:, i), i, trim(model_name(found%job%models(i))))
      end do
      loads = found%model%cases%measured_hookload
      if (any(loads%present)) call add_given(loads, found%job%units%force, measured_look, 'measured')
      loads = found%model%cases%reference_hookload
      if (found%model%rig%given) loads%value = indicated_load(found%model%rig, found%model%cases%operation, loads%value)
      if (any(loads%present)) call add_given(loads, found%job%units%force, reference_look, 'reference')
      call widen(chart%panels(1))
      if (any(found%results%status /= result_converged)) call add_key(chart, no_look, 'cases without a solution are left out')
      if (any(marked)) call add_key(chart, no_look, mark_meaning// &
                                     either(' (with the name of a model: by that model alone)', '', named()))
      if (with_error) then
         call add_rows(chart, place(), 'error against measurement', quantity_percent, names, 0.0_wp)
         do i = 1, size(found%job%models)
            call add_marks(error(:, i), i, '')
         end do
         chart%panels(2)%x%ends(1) = 0.0_wp
         chart%panels(2)%air(1) = 0.04_wp
      end if
      if (with_torque) then
         call add_rows(chart, place(), 'torque at the top', quantity_moment, names, 0.0_wp)
         do i = 1, size(found%job%models)
            call add_marks(torque(:, i), i, '')
         end do
         if (any(found%model%cases%measured_torque%present)) &
            call add_given(found%model%cases%measured_torque, found%job%units%moment, measured_look, '')
         chart%panels(panels)%x%ends(1) = 0.0_wp
         chart%panels(panels)%air(1) = 0.04_wp
      end if

   contains

      !> True if a mark is of some models only.
      pure function named()
         logical :: named
         named = any([(any(marked .and. found%results%case_index == i) .and. &
                       any(.not. marked .and. found%results%case_index == i), i=1, n)])
      end function named

      !> Of the next panel.
      pure function place()
         real(wp) :: place(4)
         place = beside(size(chart%panels) + 1, panels, [left, 0.96_wp + 0.005_wp*panels, bottom, top], 0.025_wp)
      end function place

      !> Marks of one of `job%models`, beside the lines of the cases.
      subroutine add_marks(values, number, name)
         real(wp), intent(in) :: values(:)
         integer, intent(in) :: number
         character(*), intent(in) :: name
         real(wp) :: beside_line
         beside_line = spread*(real(number, wp)/real(size(found%job%models) + 1, wp) - 0.5_wp)
         call add_curve(chart, values, [(real(i, wp) + beside_line, i=1, n)], mark_style(number, 0.8_wp), name, &
                        key_of(chart, trim(model_name(found%job%models(number)))))
      end subroutine add_marks

      !> Marks of what the deck gives, on the lines of the cases.
      subroutine add_given(values, unit, look, name)
         type(optional_real), intent(in) :: values(:)
         real(wp), intent(in) :: unit
         character(*), intent(in) :: look, name
         call add_curve(chart, merge(values%value/unit, missing, values%present), [(real(i, wp), i=1, n)], look, name, &
                        key_of(chart, 'measured'))
      end subroutine add_given
   end function hookload_chart

   !> Mark of a load case. Where only some models say no, their names follow.
   pure function mark_of(models, marked, mine) result(text)
      integer, intent(in) :: models(:)                  !< of all results
      logical, intent(in) :: marked(:), mine(:)         !< as many: say no, are of the load case
      character(:), allocatable :: text
      integer :: i
      text = ''
      if (.not. any(marked .and. mine)) return
      text = ' '//row_mark
      if (all(marked .or. .not. mine)) return
      do i = 1, size(models)
         if (marked(i) .and. mine(i)) text = text//' '//trim(model_name(models(i)))
      end do
   end function mark_of

   !> Widen the horizontal axis of a panel whose marks are close together: models that agree would seem to be far apart.
   pure subroutine widen(panel)
      type(panel_type), intent(inout) :: panel
      !> Least length of the axis over the greatest value [-].
      real(wp), parameter :: least = 0.02_wp
      real(wp) :: low, high
      integer :: i
      low = huge(low)
      high = -huge(high)
      do i = 1, size(panel%curves)
         associate (x => panel%curves(i)%points(1, :))
            low = min(low, minval(x, mask=.not. is_missing(x)))
            high = max(high, maxval(x, mask=.not. is_missing(x)))
         end associate
      end do
      if (high < low .or. high - low >= least*max(abs(low), abs(high))) return
      panel%x%ends = 0.5_wp*(low + high) + 0.5_wp*least*max(abs(low), abs(high))*[-1.0_wp, 1.0_wp]
   end subroutine widen

   !> Hook load, error and torque of each case by each model, as they are shown; `missing` without a solution.
   pure subroutine find_values(found, hookload, error, torque)
      type(findings_type), intent(in) :: found
      real(wp), intent(out) :: hookload(:, :), error(:, :), torque(:, :)
      type(optional_real) :: percent
      real(wp) :: shown
      integer :: i, k
      hookload = missing
      error = missing
      torque = missing
      do i = 1, size(found%results)
         if (found%results(i)%status /= result_converged) cycle
         k = findloc(found%job%models, found%results(i)%model, dim=1)
         associate (number => found%results(i)%case_index)
            shown = as_measured(found%results(i)%hookload, found%results(i)%weight_indicator)
            hookload(number, k) = shown/found%job%units%force
            percent = percent_error(shown, found%model%cases(number)%measured_hookload)
            if (percent%present) error(number, k) = percent%value
            if (rotates(found%model%cases(number)%operation) .or. abs(found%model%cases(number)%tob) > 0.0_wp) &
               torque(number, k) = found%results(i)%torque/found%job%units%moment
         end associate
      end do
   end subroutine find_values
end module dg_hookload_picture

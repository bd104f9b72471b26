!> Pictures of one load case: the well with the contact of the string, and what the string carries against depth.
!> They draw from the profile files beside them.
module dg_case_pictures
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: column_header, column_named, column_type, unit_size, unit_text
   use dg_gnuplot_script, only: add_series, colour_black, colour_grey, end_script, legend, limit_dash, line_style, mark_style, &
                                panel, plot, results_file, series_type, start_script, x_range
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, operation_label, rotates
   use dg_missing, only: is_missing
   use dg_profile_columns, only: profile_columns, profile_values
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: path_script, forces_script

   integer, parameter :: digits = 8
   !> Most marks of a kind in a panel: more make a band and a large file, and tell no more.
   integer, parameter :: most_marks = 300
   !> Most points of a line: more than pixels on paper, and a page of many cases can still be mailed.
   integer, parameter :: most_points = 3000
   !> Size of the pictures [px], and the parts of their height that hold panels and legend.
   integer, parameter :: width = 1120, height = 580
   real(wp), parameter :: panel_bottom = 0.125_wp, panel_top = 0.84_wp, legend_top = 0.92_wp

contains

   !> Vertical section and plan, neither distorted, with the state of contact along the string. `result` has a profile.
   subroutine path_script(name, job, load_case, result, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      real(wp), allocatable :: section(:)
      real(wp) :: azimuth, scale
      !> Panels side by side, or one above the other for wells much wider than deep: places in parts of the picture.
      real(wp), parameter :: wide_well = 2.0_wp
      real(wp) :: left(2), bottom(2), wide, tall, legend_bottom, title
      integer :: pixels
      character(:), allocatable :: data, across, unit
      integer :: n
      associate (profile => result%profile)
         n = size(profile%md)
         azimuth = 0.0_wp
         if (hypot(profile%north(n), profile%east(n)) > 0.0_wp) azimuth = atan2(profile%east(n), profile%north(n))
         allocate (section, source=cos(azimuth)*profile%north + sin(azimuth)*profile%east)
         data = results_file('profile_'//load_case%name//'_'//trim(model_name(result%model)))
         unit = ' ['//trim(job%units%length_label)//']'
         across = '(('//to_text(cos(azimuth), digits)//')*'//value('north')//'+('//to_text(sin(azimuth), digits)//')*'// &
            value('east')//')'
         if (maxval(section) - minval(section) > wide_well*(maxval(profile%tvd) - minval(profile%tvd))) then
            pixels = 760
            left = 0.075_wp
            wide = 0.91_wp
            bottom = [0.55_wp, 0.09_wp]
            tall = 0.34_wp
            legend_bottom = 0.895_wp
            title = 0.945_wp
         else
            pixels = height
            left = [0.075_wp, 0.575_wp]
            wide = 0.41_wp
            bottom = panel_bottom
            tall = panel_top - panel_bottom
            legend_bottom = panel_top
            title = legend_top
         end if
         call start_script(lines, name, width, pixels)
         call append_text(lines, "touches(state, value) = stringcolumn('gap_state') eq state ? value : NaN")
         call add_curves(across, value('tvd'))
         call legend(lines, case_title(job%units, load_case)//', model '//trim(model_name(result%model)), series, &
                     legend_bottom, title)
         scale = per_pixel(section, profile%tvd)
         call panel(lines, left(1), left(1) + wide, bottom(1), bottom(1) + tall, 'vertical section along azimuth '// &
                    to_text(real(nint(modulo(azimuth/job%units%angle, 360.0_wp)), wp))//' deg'//unit, &
                    'true vertical depth'//unit)
         call append_text(lines, 'set xrange ['//window(section, wide*width, .false.)//']; set yrange ['// &
                          window(profile%tvd, tall*pixels, .true.)//']')
         call plot(lines, series)
         call add_curves(value('east'), value('north'))
         ! the plan of a vertical hole is a point: a hundredth of its depth shows that
         scale = max(per_pixel(profile%east, profile%north), 0.01_wp*profile%md(n)/(wide*width))
         call panel(lines, left(2), left(2) + wide, bottom(2), bottom(2) + tall, 'east'//unit, 'north'//unit)
         call append_text(lines, 'set xrange ['//window(profile%east, wide*width, .false.)//']; set yrange ['// &
                          window(profile%north, tall*pixels, .false.)//']')
         call plot(lines, series)
         call end_script(lines)
      end associate

   contains

      !> The hole, and marks where the string touches.
      subroutine add_curves(x, y)
         character(*), intent(in) :: x, y
         character(:), allocatable :: thinned
         if (allocated(series)) deallocate (series)
         thinned = thinning(n, most_marks)
         call add_series(series, data//' using ('//x//'):('//y//')'//thinning(n, most_points), &
                         "with lines lw 1.5 lc rgb '"//colour_grey//"'", &
                         'hole; no mark: string free')
         call add_series(series, data//" using (touches('elastic', "//x//')):('//y//')'//thinned, mark_style(1, 0.4_wp), &
                         'elastic contact')
         call add_series(series, data//" using (touches('rigid', "//x//')):('//y//')'//thinned, mark_style(2, 0.6_wp), &
                         'rigid contact')
      end subroutine add_curves

      pure function value(column) result(text)
         character(*), intent(in) :: column
         character(:), allocatable :: text
         text = file_value(column, job%units)
      end function value

      !> Metres a pixel at which both directions fit a panel.
      pure function per_pixel(x, y) result(metres)
         real(wp), intent(in) :: x(:), y(:)
         real(wp) :: metres
         real(wp), parameter :: air = 1.1_wp
         metres = air*max((maxval(x) - minval(x))/(wide*width), &
                          (maxval(y) - minval(y))/(tall*pixels))
      end function per_pixel

      !> Range of an axis of so many pixels, in the deck's units: values in its middle, a depth from a little above the first on.
      pure function window(values, pixels_there, is_depth) result(text)
         real(wp), intent(in) :: values(:), pixels_there
         logical, intent(in) :: is_depth
         character(:), allocatable :: text
         real(wp) :: first, last
         real(wp), parameter :: little = 0.05_wp
         first = 0.5_wp*(minval(values) + maxval(values)) - 0.5_wp*scale*pixels_there
         if (is_depth) first = minval(values) - little*scale*pixels_there
         last = first + scale*pixels_there
         if (is_depth) then
            text = to_text(last/job%units%length, digits)//':'//to_text(first/job%units%length, digits)
         else
            text = to_text(first/job%units%length, digits)//':'//to_text(last/job%units%length, digits)
         end if
      end function window
   end subroutine path_script

   !> Axial force with buckling limits, torque (bending moment where there is no torque), side force and clock angle of
   !> all models of a case, against depth. All `results` have profiles.
   subroutine forces_script(name, job, load_case, results, alongs, left_out, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: results(:)      !< of the case, one a model
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      character(*), intent(in) :: left_out                  !< models without a solution; '': none
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      character(:), allocatable :: title
      real(wp) :: least, most   !< ends of the axis of force, in the deck's units
      logical :: limits_show    !< on it
      real(wp), parameter :: left(4) = [0.075_wp, 0.315_wp, 0.545_wp, 0.775_wp], wide = 0.21_wp
      !> Steps between tics: their labels have four letters' room each.
      integer, parameter :: intervals = 5
      call start_script(lines, name, width, height)
      call append_text(lines, 'from_270(angle) = angle > 270 ? angle - 360 : angle')
      call find_axial_range()
      call add_axial()
      title = case_title(job%units, load_case)
      if (left_out /= '') title = title//'; no solution:'//left_out
      call legend(lines, title, series, panel_top, legend_top)
      call append_text(lines, 'set yrange ['//to_text(load_case%bit_depth/job%units%length, digits)//':0]')
      call panel(lines, left(1), left(1) + wide, panel_bottom, panel_top, axis('effective axial force', 'axial'), &
                 axis('measured depth', 'md'))
      call x_range(lines, least, most, intervals)
      call plot(lines, series)
      if (rotates(load_case%operation) .or. abs(load_case%tob) > 0.0_wp) then
         call draw_curves(left(2), 'torque', 'torque')
      else
         call draw_curves(left(2), 'bending moment', 'bending')
      end if
      call draw_curves(left(3), 'side force', 'side_force')
      call add_clock()
      call panel(lines, left(4), left(4) + wide, panel_bottom, panel_top, 'clock angle of contact [deg]', '')
      ! cut open at 270 deg, not at the high side: a string that lies there is one curve
      call append_text(lines, 'set xrange [-90:270]; set xtics ("270" -90, "0 high" 0, "90" 90, "180 low" 180, "270" 270)')
      call plot(lines, series)
      call end_script(lines)

   contains

      subroutine add_axial()
         integer :: k
         character(:), allocatable :: data
         if (allocated(series)) deallocate (series)
         do k = 1, size(results)
            call add_series(series, curve(k, value('axial')), line_style(k), trim(model_name(results(k)%model)))
         end do
         data = "with lines lw 1.2 dt "//limit_dash//" lc rgb '"
         if (limits_show) then
            call add_series(series, curve(1, '-'//value('sinusoidal_load')), data//colour_black//"'", 'sinusoidal buckling')
            call add_series(series, curve(1, '-'//value('helical_load')), data//colour_grey//"'", 'helical buckling, lower limit')
         else
            call add_series(series, 'NaN', data//colour_black//"'", 'buckling limits lie beyond the axis')
         end if
      end subroutine add_axial

      subroutine draw_curves(start, label, column)
         real(wp), intent(in) :: start
         character(*), intent(in) :: label, column
         real(wp), allocatable :: values(:)
         real(wp) :: low, high, unit
         real(wp), parameter :: air = 1.05_wp
         integer :: k
         if (allocated(series)) deallocate (series)
         low = 0.0_wp
         high = 0.0_wp
         unit = unit_size(quantity_of(column), job%units)
         do k = 1, size(results)
            call add_series(series, curve(k, value(column)), line_style(k), '')
            if (allocated(values)) deallocate (values)
            allocate (values(size(results(k)%profile%md)))
            call profile_values(column, results(k)%profile, alongs(k), values)
            low = min(low, minval(values)*air/unit)
            high = max(high, maxval(values)*air/unit)
         end do
         call panel(lines, start, start + wide, panel_bottom, panel_top, axis(label, column), '')
         call x_range(lines, low, high, intervals)
         call plot(lines, series)
      end subroutine draw_curves

      subroutine add_clock()
         integer :: k
         if (allocated(series)) deallocate (series)
         ! the first model on top, those below it larger, so that all can be seen
         do k = size(results), 1, -1
            call add_series(series, curve(k, "stringcolumn('gap_state') eq 'free' ? NaN : from_270("//value('clock')//')')// &
                            thinning(size(results(k)%profile%md), most_marks), mark_style(k, 0.2_wp + 0.12_wp*k), '')
         end do
      end subroutine add_clock

      !> A column of a model's profile against depth.
      pure function curve(k, expression) result(using)
         integer, intent(in) :: k
         character(*), intent(in) :: expression
         character(:), allocatable :: using
         using = results_file('profile_'//load_case%name//'_'//trim(model_name(results(k)%model)))//' using ('//expression// &
            '):('//value('md')//')'
         if (index(expression, 'gap_state') == 0) using = using//thinning(size(results(k)%profile%md), most_points)
      end function curve

      pure function value(column) result(text)
         character(*), intent(in) :: column
         character(:), allocatable :: text
         text = file_value(column, job%units)
      end function value

      pure function axis(label, column) result(text)
         character(*), intent(in) :: label, column
         character(:), allocatable :: text
         text = label//' ['//unit_text(quantity_of(column), job%units)//']'
      end function axis

      !> The axial forces, and those limits that matter, as far as they do not crush them: where the string is nearest to
      !> buckling, and the least one where it is compressed.
      subroutine find_axial_range()
         real(wp) :: air, lowest, limit
         integer :: k, i
         !> Part of the forces' own range that limits may add to it.
         real(wp), parameter :: share = 0.5_wp
         lowest = 0.0_wp
         most = 0.0_wp
         do k = 1, size(results)
            lowest = min(lowest, minval(results(k)%profile%axial))
            most = max(most, maxval(results(k)%profile%axial))
         end do
         air = max(most - lowest, job%units%force)
         least = lowest
         limits_show = .false.
         do k = 1, size(results)
            associate (along => alongs(k), known => .not. is_missing(alongs(k)%sinusoidal))
               if (.not. any(known)) cycle
               limit = along%sinusoidal(minloc(along%buckling_margin, mask=known, dim=1))
               do i = 1, 2
                  if (-limit > lowest - share*air) least = min(least, -limit)
                  limit = minval(along%sinusoidal, mask=known .and. results(k)%profile%axial < 0.0_wp)
               end do
               limits_show = limits_show .or. -minval(along%sinusoidal, mask=known) >= least
            end associate
         end do
         if (least < 0.0_wp) least = least - 0.15_wp*air
         least = least/job%units%force
         most = (most + 0.05_wp*air)/job%units%force
      end subroutine find_axial_range
   end subroutine forces_script

   !> What a picture of a case is called.
   pure function case_title(units, load_case) result(title)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      character(:), allocatable :: title
      integer, parameter :: few = 6
      title = load_case%name//': '//trim(operation_label(load_case%operation))//' at '// &
         to_text(load_case%bit_depth/units%length, few)//' '//trim(units%length_label)
      if (abs(load_case%wob) > 0.0_wp) title = title//', weight on bit '//to_text(load_case%wob/units%force, few)//' '// &
         trim(units%force_label)
   end function case_title

   !> A column of a profile file in a gnuplot expression.
   pure function file_value(column, units) result(text)
      character(*), intent(in) :: column
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      text = "column('"//column_header(column_named(profile_columns, column), units)//"')"
   end function file_value

   pure function quantity_of(column) result(quantity)
      character(*), intent(in) :: column
      integer :: quantity
      type(column_type) :: found
      found = column_named(profile_columns, column)
      quantity = found%quantity
   end function quantity_of

   !> Draws every so many of `n` points, so that no more than `most` are drawn; '' draws all.
   pure function thinning(n, most) result(text)
      integer, intent(in) :: n, most
      character(:), allocatable :: text
      text = ''
      if (n > most) text = ' every '//to_text((n + most - 1)/most)
   end function thinning
end module dg_case_pictures

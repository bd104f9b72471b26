!> Picture of one load case: the well with the contact of the string, drawn from the profile file beside it.
module dg_path_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_column, only: column_header, column_named
   use dg_depth_panels, only: add_points
   use dg_drillstring, only: component_tops
   use dg_gnuplot_script, only: add_series, colour_black, colour_grey, cut_text, end_script, legend, letter_width, mark_style, &
                                panel, plot, results_file, series_type, spelled, start_script
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, operation_label
   use dg_model, only: model_type, string_index
   use dg_profile_columns, only: profile_columns
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: path_script, case_title

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
   subroutine path_script(name, job, model, result, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      real(wp), allocatable :: section(:), shoes(:), joins(:)   ! [m]; of hole sections and components the depth
      real(wp) :: azimuth, scale
      real(wp) :: taken(2, 40)     ! places of names
      integer :: names
      !> Panels side by side, or one above the other for wells much wider than deep: places in parts of the picture.
      real(wp), parameter :: wide_well = 2.0_wp
      real(wp) :: left(2), bottom(2), wide, tall, legend_bottom, title
      integer :: pixels
      character(:), allocatable :: data, across, unit
      integer :: n
      associate (profile => result%profile, load_case => model%cases(result%case_index))
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
         call add_places()
         call append_text(lines, "touches(state, value) = stringcolumn('gap_state') eq state ? value : NaN")
         call add_curves(across, value('tvd'))
         call add_marks(1)
         call legend(lines, case_title(job%units, load_case)//', model '//trim(model_name(result%model)), series, &
                     legend_bottom, title)
         scale = per_pixel(section, profile%tvd)
         call panel(lines, left(1), left(1) + wide, bottom(1), bottom(1) + tall, 'vertical section along azimuth '// &
                    to_text(real(nint(modulo(azimuth/job%units%angle, 360.0_wp)), wp))//' deg'//unit, &
                    'true vertical depth'//unit)
         call append_text(lines, 'set xrange ['//window(section, wide*width, .false.)//']; set yrange ['// &
                          window(profile%tvd, tall*pixels, .true.)//']')
         call name_places()
         call plot(lines, series)
         call append_text(lines, 'unset label')
         call add_curves(value('east'), value('north'))
         call add_marks(3)
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

      !> Blocks of points: where hole sections end above the bit and where parts of the string begin, in section and plan.
      subroutine add_places()
         real(wp), allocatable :: tops(:)
         integer :: i, k
         associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)), &
                    bit => model%cases(result%case_index)%bit_depth, md => result%profile%md)
            allocate (tops, source=[(model%holes(i)%md_bottom, i=1, size(model%holes))])   ! a component as an argument is a copy
            allocate (shoes, source=pack(tops, tops < bit .and. tops > md(1)))
            deallocate (tops)
            allocate (tops, source=component_tops(string, bit - md(1)))
            allocate (joins, source=pack(bit - tops, bit - tops > md(1)))
            do k = 1, 3, 2
               call add_points(lines, '$shoe'//to_text(k), [(across_at(shoes(i), k), i=1, size(shoes))]/job%units%length, &
                               [(down_at(shoes(i), k), i=1, size(shoes))]/job%units%length)
               call add_points(lines, '$join'//to_text(k), [(across_at(joins(i), k), i=1, size(joins))]/job%units%length, &
                               [(down_at(joins(i), k), i=1, size(joins))]/job%units%length)
            end do
         end associate
      end subroutine add_places

      subroutine add_marks(view)
         integer, intent(in) :: view      !< 1: vertical section; 3: plan
         character(*), parameter :: shoe = "with points pt 9 ps 1.0 lc rgb '"//colour_black//"'", &
                                    join = "with points pt 1 ps 1.0 lw 1.6 lc rgb '"//colour_black//"'"
         if (size(shoes) > 0) call add_series(series, '$shoe'//to_text(view)//' using 1:2', shoe, 'hole section ends')
         if (size(joins) > 0) call add_series(series, '$join'//to_text(view)//' using 1:2', join, 'part of the string begins')
      end subroutine add_marks

      !> Names in the vertical section: of hole sections to the left of the hole, of parts to its right. Where they would lie over
      !> each other the upper of two stays.
      subroutine name_places()
         integer :: i
         names = 0
         do i = 1, size(model%holes) - 1
            if (any(abs(shoes - model%holes(i)%md_bottom) <= 0.0_wp)) call put_name(model%holes(i)%name//', '// &
               to_text(model%holes(i)%md_bottom/job%units%length, 6)//' '//trim(job%units%length_label), &
               model%holes(i)%md_bottom, 'right offset -1.2,-0.8')
         end do
         names = 0
         associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
            do i = size(joins), 1, -1
               call put_name(string%components(i)%name, joins(i), 'left offset 0.8,0.8')
            end do
         end associate
      end subroutine name_places

      subroutine put_name(text, md, where_to)
         character(*), intent(in) :: text, where_to
         real(wp), intent(in) :: md
         real(wp) :: at(2)
         real(wp), parameter :: row = 14.0_wp          ! height of a name [px]
         integer, parameter :: longest = 28            ! letters
         at = [across_at(md, 1), down_at(md, 1)]
         if (names == size(taken, 2)) return
         if (any(abs(taken(1, :names) - at(1)) < longest*letter_width*scale .and. &
                 abs(taken(2, :names) - at(2)) < row*scale)) return
         names = names + 1
         taken(:, names) = at
         call append_text(lines, 'set label '//spelled(cut_text(text, longest))//' at first '// &
                          to_text(at(1)/job%units%length, digits)//', first '//to_text(at(2)/job%units%length, digits)//' '// &
                          where_to//" font ',10'")
      end subroutine put_name

      !> What stands to the right in a view, at a depth [m].
      pure function across_at(md, view) result(place)
         real(wp), intent(in) :: md
         integer, intent(in) :: view
         real(wp) :: place
         if (view == 1) then
            place = value_at(section, md)
         else
            place = value_at(result%profile%east, md)
         end if
      end function across_at

      pure function down_at(md, view) result(place)
         real(wp), intent(in) :: md
         integer, intent(in) :: view
         real(wp) :: place
         if (view == 1) then
            place = value_at(result%profile%tvd, md)
         else
            place = value_at(result%profile%north, md)
         end if
      end function down_at

      pure function value_at(values, md) result(found)
         real(wp), intent(in) :: values(:), md
         real(wp) :: found, share
         integer :: i
         associate (depth => result%profile%md)
            i = 2
            do while (i < size(depth))
               if (depth(i) >= md) exit
               i = i + 1
            end do
            share = 1.0_wp
            if (depth(i) > depth(i - 1)) share = (md - depth(i - 1))/(depth(i) - depth(i - 1))
            found = values(i - 1) + share*(values(i) - values(i - 1))
         end associate
      end function value_at

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

   !> Draws every so many of `n` points, so that no more than `most` are drawn; '' draws all.
   pure function thinning(n, most) result(text)
      integer, intent(in) :: n, most
      character(:), allocatable :: text
      text = ''
      if (n > most) text = ' every '//to_text((n + most - 1)/most)
   end function thinning
end module dg_path_picture

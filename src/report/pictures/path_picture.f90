!> Picture of one load case: the well with its casing and the contact of the string, drawn from the profile file beside it.
module dg_path_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_column, only: column_header, column_named
   use dg_depth_panels, only: add_points
   use dg_drillstring, only: component_tops
   use dg_gnuplot_script, only: add_series, colour_black, colour_grey, cut_text, end_script, legend, letter_width, mark_style, &
                                panel, plot, results_file, series_type, spelled, start_script
   use dg_hole_section, only: hole_section_type
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, operation_label
   use dg_missing, only: missing
   use dg_model, only: model_type, string_index
   use dg_profile, only: profile_type
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
   !> Width of the picture [px].
   integer, parameter :: width = 1120
   !> The two views of a well.
   integer, parameter :: section = 1, plan = 2
   character(*), parameter :: view_mark(2) = ['1', '2']

   !> Both views of a well, and where they stand in the picture.
   type :: views_type
      real(wp), allocatable :: md(:)          !< rows of the profile [m]
      real(wp), allocatable :: place(:, :, :) !< (2,n,view): to the right and up or down in a view [m]
      real(wp) :: azimuth = 0.0_wp            !< of the vertical section [rad]
      real(wp) :: scale(2) = 0.0_wp           !< of a view [m/px]
      integer :: height = 580                 !< of the picture [px]
      real(wp) :: left(2) = [0.075_wp, 0.575_wp], bottom(2) = 0.125_wp     !< of the panels, in parts of the picture
      real(wp) :: wide = 0.41_wp, tall = 0.715_wp                          !< of both
      real(wp) :: legend_bottom = 0.84_wp, title = 0.92_wp
   end type views_type

contains

   !> Vertical section and plan, neither distorted, with the state of contact along the string. `result` has a profile.
   subroutine path_script(name, job, model, result, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      type(views_type) :: views
      real(wp), allocatable :: shoes(:), joins(:)   ! depths of hole sections' ends and of parts of the string [m]
      character(:), allocatable :: unit, data, across
      associate (load_case => model%cases(result%case_index), units => job%units)
         unit = ' ['//trim(units%length_label)//']'
         data = results_file('profile_'//load_case%name//'_'//trim(model_name(result%model)))
         call lay_out(result%profile, views)
         across = '(('//to_text(cos(views%azimuth), digits)//')*'//file_value('north', units)//'+('// &
                  to_text(sin(views%azimuth), digits)//')*'//file_value('east', units)//')'
         call find_places(model, load_case, views%md(1), shoes, joins)
         call start_script(lines, name, width, views%height)
         call add_places(lines, units, model%holes, views, shoes, joins)
         call append_text(lines, "touches(state, value) = stringcolumn('gap_state') eq state ? value : NaN")
         call add_curves(series, data, across, file_value('tvd', units), size(views%md))
         call add_marks(series, section, size(shoes), size(joins), any(model%holes%cased))
         call legend(lines, case_title(units, load_case)//', model '//trim(model_name(result%model)), series, &
                     views%legend_bottom, views%title)
         call open_panel(lines, units, views, section, 'vertical section along azimuth '// &
                         to_text(real(nint(modulo(views%azimuth/units%angle, 360.0_wp)), wp))//' deg'//unit, &
                         'true vertical depth'//unit)
         call name_places(lines, units, model, load_case, views, joins)
         call plot(lines, series)
         call append_text(lines, 'unset label')
         deallocate (series)
         call add_curves(series, data, file_value('east', units), file_value('north', units), size(views%md))
         call add_marks(series, plan, size(shoes), size(joins), .false.)
         call open_panel(lines, units, views, plan, 'east'//unit, 'north'//unit)
         call plot(lines, series)
         call end_script(lines)
      end associate
   end subroutine path_script

   !> Both views of a profile. Panels stand side by side, or one above the other for wells much wider than deep.
   pure subroutine lay_out(profile, views)
      type(profile_type), intent(in) :: profile
      type(views_type), intent(out) :: views
      real(wp), parameter :: wide_well = 2.0_wp, air = 1.1_wp
      !> The plan of a vertical hole is a point: a hundredth of its depth shows that.
      real(wp), parameter :: least_plan = 0.01_wp
      real(wp) :: extent(2, 2)
      integer :: n, view
      n = size(profile%md)
      views%md = profile%md
      if (hypot(profile%north(n), profile%east(n)) > 0.0_wp) views%azimuth = atan2(profile%east(n), profile%north(n))
      allocate (views%place(2, n, 2))
      views%place(1, :, section) = cos(views%azimuth)*profile%north + sin(views%azimuth)*profile%east
      views%place(2, :, section) = profile%tvd
      views%place(1, :, plan) = profile%east
      views%place(2, :, plan) = profile%north
      do view = 1, 2
         extent(:, view) = maxval(views%place(:, :, view), dim=2) - minval(views%place(:, :, view), dim=2)
      end do
      if (extent(1, section) > wide_well*extent(2, section)) then
         views%height = 760
         views%left = 0.075_wp
         views%bottom = [0.55_wp, 0.09_wp]
         views%wide = 0.91_wp
         views%tall = 0.34_wp
         views%legend_bottom = 0.895_wp
         views%title = 0.945_wp
      end if
      do view = 1, 2
         views%scale(view) = air*max(extent(1, view)/(views%wide*width), extent(2, view)/(views%tall*views%height))
      end do
      views%scale(plan) = max(views%scale(plan), least_plan*profile%md(n)/(views%wide*width))
   end subroutine lay_out

   !> Depths of hole sections' ends above the bit and of the upper ends of components, below the top of the string [m].
   pure subroutine find_places(model, load_case, top, shoes, joins)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: top
      real(wp), allocatable, intent(out) :: shoes(:), joins(:)
      real(wp), allocatable :: tops(:)
      integer :: i
      associate (string => model%strings(string_index(model%strings, load_case%string)), bit => load_case%bit_depth)
         allocate (tops, source=[(model%holes(i)%md_bottom, i=1, size(model%holes))])   ! a component as an argument is a copy
         allocate (shoes, source=pack(tops, tops < bit .and. tops > top))
         deallocate (tops)
         allocate (tops, source=component_tops(string, bit - top))
         allocate (joins, source=pack(bit - tops, bit - tops > top))
      end associate
   end subroutine find_places

   !> Blocks of points in both views: ends of hole sections, where parts of the string begin; walls of cased sections in the first.
   pure subroutine add_places(lines, units, holes, views, shoes, joins)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(hole_section_type), intent(in) :: holes(:)
      type(views_type), intent(in) :: views
      real(wp), intent(in) :: shoes(:), joins(:)
      real(wp) :: there(2, max(size(shoes), size(joins)))
      integer :: view, i
      do view = 1, 2
         do i = 1, size(shoes)
            there(:, i) = place_at(views, view, shoes(i))/units%length
         end do
         call add_points(lines, '$shoe'//view_mark(view), there(1, :size(shoes)), there(2, :size(shoes)))
         do i = 1, size(joins)
            there(:, i) = place_at(views, view, joins(i))/units%length
         end do
         call add_points(lines, '$join'//view_mark(view), there(1, :size(joins)), there(2, :size(joins)))
      end do
      if (any(holes%cased)) call add_walls(lines, units, holes, views)
   end subroutine add_places

   !> Walls of cased sections in the vertical section, out of scale: the narrowest hole is some pixels wide, others in proportion.
   pure subroutine add_walls(lines, units, holes, views)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(hole_section_type), intent(in) :: holes(:)
      type(views_type), intent(in) :: views
      real(wp), parameter :: narrowest = 3.0_wp     !< half the width of the narrowest hole [px]
      integer, parameter :: parts = 60              !< of a wall
      real(wp) :: wall(2, (parts + 2)*2*count(holes%cased)), point(2), along(2), step, half, top, bottom
      integer :: i, k, n, side
      n = 0
      do i = 1, size(holes)
         if (.not. holes(i)%cased) cycle
         top = max(holes(i)%md_top, views%md(1))
         bottom = min(holes(i)%md_bottom, views%md(size(views%md)))
         if (.not. bottom > top) cycle
         half = narrowest*views%scale(section)*holes(i)%diameter/minval(holes%diameter)
         step = (bottom - top)/parts
         do side = -1, 1, 2
            do k = 0, parts
               point = place_at(views, section, top + k*step)
               along = place_at(views, section, min(top + (k + 0.5_wp)*step, bottom)) - &
                       place_at(views, section, max(top + (k - 0.5_wp)*step, top))
               along = along/max(norm2(along), tiny(step))
               n = n + 1
               wall(:, n) = (point + side*half*[along(2), -along(1)])/units%length
            end do
            n = n + 1
            wall(:, n) = missing         ! the line breaks
            wall(2, n) = wall(2, n - 1)
         end do
      end do
      call add_points(lines, '$wall', wall(1, :n), wall(2, :n))
   end subroutine add_walls

   !> The hole, and marks where the string touches.
   pure subroutine add_curves(series, data, x, y, n)
      type(series_type), allocatable, intent(inout) :: series(:)
      character(*), intent(in) :: data      !< the profile file
      character(*), intent(in) :: x, y      !< what stands to the right and up in the panel
      integer, intent(in) :: n              !< rows of the file
      character(:), allocatable :: thinned
      thinned = thinning(n, most_marks)
      call add_series(series, data//' using ('//x//'):('//y//')'//thinning(n, most_points), &
                      "with lines lw 1.5 lc rgb '"//colour_grey//"'", 'hole; no mark: string free')
      call add_series(series, data//" using (touches('elastic', "//x//')):('//y//')'//thinned, mark_style(1, 0.4_wp), &
                      'elastic contact')
      call add_series(series, data//" using (touches('rigid', "//x//')):('//y//')'//thinned, mark_style(2, 0.6_wp), &
                      'rigid contact')
   end subroutine add_curves

   pure subroutine add_marks(series, view, shoes, joins, cased)
      type(series_type), allocatable, intent(inout) :: series(:)
      integer, intent(in) :: view
      integer, intent(in) :: shoes, joins   !< so many
      logical, intent(in) :: cased          !< there are walls
      character(*), parameter :: shoe = "with points pt 9 ps 1.0 lc rgb '"//colour_black//"'", &
                                 join = "with points pt 1 ps 1.0 lw 1.6 lc rgb '"//colour_black//"'", &
                                 wall = "with lines lw 1.4 lc rgb '"//colour_black//"'"
      if (cased) call add_series(series, '$wall using 1:2', wall, 'casing (widths not to scale)')
      if (shoes > 0) call add_series(series, '$shoe'//view_mark(view)//' using 1:2', shoe, 'hole section ends')
      if (joins > 0) call add_series(series, '$join'//view_mark(view)//' using 1:2', join, 'part of the string begins')
   end subroutine add_marks

   !> A panel with its axes: values in its middle, true vertical depth from a little above the first on downwards.
   pure subroutine open_panel(lines, units, views, view, x_label, y_label)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(views_type), intent(in) :: views
      integer, intent(in) :: view
      character(*), intent(in) :: x_label, y_label
      real(wp), parameter :: little = 0.05_wp
      real(wp) :: size_there(2), first(2), last(2)
      size_there = views%scale(view)*[views%wide*width, views%tall*views%height]
      first = 0.5_wp*(minval(views%place(:, :, view), dim=2) + maxval(views%place(:, :, view), dim=2) - size_there)
      if (view == section) first(2) = minval(views%place(2, :, view)) - little*size_there(2)
      last = (first + size_there)/units%length
      first = first/units%length
      call panel(lines, views%left(view), views%left(view) + views%wide, views%bottom(view), views%bottom(view) + views%tall, &
                 x_label, y_label)
      if (view == section) then
         call append_text(lines, 'set xrange ['//window(first(1), last(1))//']; set yrange ['//window(last(2), first(2))//']')
      else
         call append_text(lines, 'set xrange ['//window(first(1), last(1))//']; set yrange ['//window(first(2), last(2))//']')
      end if
   contains
      pure function window(from, to) result(text)
         real(wp), intent(in) :: from, to
         character(:), allocatable :: text
         text = to_text(from, digits)//':'//to_text(to, digits)
      end function window
   end subroutine open_panel

   !> Names in the vertical section: of hole sections to the left of the hole, of parts to its right. Where they would lie over
   !> each other the upper of two stays.
   subroutine name_places(lines, units, model, load_case, views, joins)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(views_type), intent(in) :: views
      real(wp), intent(in) :: joins(:)
      real(wp) :: taken(2, size(model%holes) + size(joins))
      integer :: i, names
      names = 0
      do i = 1, size(model%holes) - 1
         associate (md => model%holes(i)%md_bottom)
            if (md >= load_case%bit_depth .or. md <= views%md(1)) cycle
            call put_name(model%holes(i)%name//', '//to_text(md/units%length, 6)//' '//trim(units%length_label), &
                          place_at(views, section, md), 'right offset -1.2,-0.8')
         end associate
      end do
      names = 0
      associate (string => model%strings(string_index(model%strings, load_case%string)))
         do i = size(joins), 1, -1
            call put_name(string%components(i)%name, place_at(views, section, joins(i)), 'left offset 0.8,0.8')
         end do
      end associate
   contains
      subroutine put_name(text, at, where_to)
         character(*), intent(in) :: text, where_to
         real(wp), intent(in) :: at(2)
         real(wp), parameter :: row = 14.0_wp          ! height of a name [px]
         integer, parameter :: longest = 28            ! letters
         if (any(abs(taken(1, :names) - at(1)) < longest*letter_width*views%scale(section) .and. &
                 abs(taken(2, :names) - at(2)) < row*views%scale(section))) return
         names = names + 1
         taken(:, names) = at
         call append_text(lines, 'set label '//spelled(cut_text(text, longest))//' at first '// &
                          to_text(at(1)/units%length, digits)//', first '//to_text(at(2)/units%length, digits)//' '// &
                          where_to//" font ',10'")
      end subroutine put_name
   end subroutine name_places

   !> Where a depth [m] stands in a view [m].
   pure function place_at(views, view, md) result(place)
      type(views_type), intent(in) :: views
      integer, intent(in) :: view
      real(wp), intent(in) :: md
      real(wp) :: place(2), share
      integer :: i
      i = 2
      do while (i < size(views%md))
         if (views%md(i) >= md) exit
         i = i + 1
      end do
      share = 1.0_wp
      if (views%md(i) > views%md(i - 1)) share = (md - views%md(i - 1))/(views%md(i) - views%md(i - 1))
      place = views%place(:, i - 1, view) + share*(views%place(:, i, view) - views%place(:, i - 1, view))
   end function place_at

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

!> Picture of one load case: the well with its casing and the contact of the string.
module dg_path_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_chart, only: add_curve, add_label, add_panel, chart_type, new_chart
   use dg_curve_look, only: colour_black, colour_grey, letter_width, mark_style
   use dg_drillstring, only: component_tops
   use dg_hole_section, only: hole_section_type
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, operation_label
   use dg_missing, only: missing
   use dg_model, only: model_type, string_index
   use dg_profile, only: profile_type, state_elastic, state_rigid
   use dg_readable, only: cut_text
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_force, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: path_chart, case_title

   !> Most marks of a kind in a panel: more make a band and a large file, and tell no more.
   integer, parameter :: most_marks = 300
   !> Most points of a line: more than pixels on paper, and a page of many cases can still be mailed.
   integer, parameter :: most_points = 3000
   !> Width of the picture [px].
   integer, parameter :: width = 1120
   !> The two views of a well.
   integer, parameter :: section = 1, plan = 2

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
   function path_chart(job, model, result) result(chart)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(chart_type) :: chart
      type(views_type) :: views
      real(wp), allocatable :: shoes(:), joins(:)   ! depths of hole sections' ends and of parts of the string [m]
      character(:), allocatable :: unit
      associate (load_case => model%cases(result%case_index), units => job%units)
         unit = ' ['//trim(units%length_label)//']'
         call lay_out(result%profile, views)
         call find_places(model, load_case, views%md(1), shoes, joins)
         chart = new_chart('path_'//load_case%name, case_title(units, load_case)//', model '//trim(model_name(result%model)), &
                           units, views%height, [views%legend_bottom, views%title])
         call open_panel(chart, views, section, 'vertical section along azimuth '// &
                         to_text(real(nint(modulo(views%azimuth/units%angle, 360.0_wp)), wp))//' deg'//unit, &
                         'true vertical depth'//unit)
         call add_curves(chart, views, section, result%profile%gap_state, shoes, joins, model%holes)
         call name_places(chart, model, load_case, views, joins)
         call open_panel(chart, views, plan, 'east'//unit, 'north'//unit)
         call add_curves(chart, views, plan, result%profile%gap_state, shoes, joins, model%holes)
      end associate
   end function path_chart

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

   !> The hole, marks where the string touches, where hole sections end and parts of the string begin; walls of cased sections in
   !> the vertical section. What the legend names is in this one.
   subroutine add_curves(chart, views, view, states, shoes, joins, holes)
      type(chart_type), intent(inout) :: chart
      type(views_type), intent(in) :: views
      integer, intent(in) :: view
      integer, intent(in) :: states(:)             !< of contact, as many as rows of the profile
      real(wp), intent(in) :: shoes(:), joins(:)   !< [m]
      type(hole_section_type), intent(in) :: holes(:)
      integer :: i, n
      n = size(states)
      call add(views%place(:, ::step(most_points), view), "with lines lw 1.5 lc rgb '"//colour_grey//"'", &
               'hole; no mark: string free')
      associate (rows => [(i, i=1, n, step(most_marks))])
         call add(views%place(:, pack(rows, states(rows) == state_elastic), view), mark_style(1, 0.4_wp), 'elastic contact')
         call add(views%place(:, pack(rows, states(rows) == state_rigid), view), mark_style(2, 0.6_wp), 'rigid contact')
      end associate
      if (any(holes%cased) .and. view == section) call add(walls(views, holes), "with lines lw 1.4 lc rgb '"//colour_black//"'", &
                                                           'casing (widths not to scale)')
      call add(places_at(views, view, shoes), "with points pt 9 ps 1.0 lc rgb '"//colour_black//"'", 'hole section ends')
      call add(places_at(views, view, joins), "with points pt 1 ps 1.0 lw 1.6 lc rgb '"//colour_black//"'", &
               'part of the string begins')
   contains
      !> Of so many points each so-manyeth is drawn.
      pure integer function step(most)
         integer, intent(in) :: most
         step = (n + most - 1)/most
      end function step

      subroutine add(places, look, name)
         real(wp), intent(in) :: places(:, :)      !< [m]
         character(*), intent(in) :: look, name
         real(wp) :: shown(2, size(places, 2))
         if (size(places) == 0 .and. index(name, 'contact') == 0) return
         shown = missing
         where (places > missing) shown = places/chart%units%length
         call add_curve(chart, shown(1, :), shown(2, :), look, trim(merge(name, repeat(' ', len(name)), view == section)))
      end subroutine add
   end subroutine add_curves

   !> Walls of cased sections in the vertical section, out of scale: the narrowest hole is some pixels wide, others in proportion.
   pure function walls(views, holes) result(wall)
      type(views_type), intent(in) :: views
      type(hole_section_type), intent(in) :: holes(:)
      real(wp), allocatable :: wall(:, :)           !< [m]; `missing` breaks the line
      real(wp), parameter :: narrowest = 3.0_wp     !< half the width of the narrowest hole [px]
      integer, parameter :: parts = 60              !< of a wall
      real(wp) :: along(2), step, half, top, bottom
      integer :: i, k, n, side
      allocate (wall(2, (parts + 2)*2*count(holes%cased)))
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
               along = place_at(views, section, min(top + (k + 0.5_wp)*step, bottom)) - &
                       place_at(views, section, max(top + (k - 0.5_wp)*step, top))
               along = along/max(norm2(along), tiny(step))
               n = n + 1
               wall(:, n) = place_at(views, section, top + k*step) + side*half*[along(2), -along(1)]
            end do
            n = n + 1
            wall(:, n) = missing
         end do
      end do
      wall = wall(:, :n)
   end function walls

   !> A panel with its axes: values in its middle, true vertical depth from a little above the first on downwards.
   pure subroutine open_panel(chart, views, view, x_label, y_label)
      type(chart_type), intent(inout) :: chart
      type(views_type), intent(in) :: views
      integer, intent(in) :: view
      character(*), intent(in) :: x_label, y_label
      real(wp), parameter :: little = 0.05_wp
      real(wp) :: size_there(2), ends(2, 2)
      size_there = views%scale(view)*[views%wide*width, views%tall*views%height]
      ends(:, 1) = 0.5_wp*(minval(views%place(:, :, view), dim=2) + maxval(views%place(:, :, view), dim=2) - size_there)
      if (view == section) ends(2, 1) = minval(views%place(2, :, view)) - little*size_there(2)
      ends(:, 2) = ends(:, 1) + size_there
      if (view == section) ends(2, :) = ends(2, 2:1:-1)
      call add_panel(chart, [views%left(view), views%left(view) + views%wide, views%bottom(view), &
                             views%bottom(view) + views%tall], x_label, y_label)
      chart%panels(view)%x%ends = ends(1, :)/chart%units%length
      chart%panels(view)%y%ends = ends(2, :)/chart%units%length
   end subroutine open_panel

   !> Names in the vertical section: of hole sections to the left of the hole, of parts to its right. Where they would lie over
   !> each other the upper of two stays.
   subroutine name_places(chart, model, load_case, views, joins)
      type(chart_type), intent(inout) :: chart
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(views_type), intent(in) :: views
      real(wp), intent(in) :: joins(:)
      real(wp) :: taken(2, size(model%holes) + size(joins))
      integer :: i, names
      names = 0
      do i = 1, size(model%holes) - 1
         associate (md => model%holes(i)%md_bottom, units => chart%units)
            if (md >= load_case%bit_depth .or. md <= views%md(1)) cycle
            call add_name(model%holes(i)%name//', '//in_units(units, unit_length, md, 6), &
                          place_at(views, section, md), 'right offset -1.2,-0.8')
         end associate
      end do
      names = 0
      associate (string => model%strings(string_index(model%strings, load_case%string)))
         do i = size(joins), 1, -1
            call add_name(string%components(i)%name, place_at(views, section, joins(i)), 'left offset 0.8,0.8')
         end do
      end associate
   contains
      subroutine add_name(text, at, where_to)
         character(*), intent(in) :: text, where_to
         real(wp), intent(in) :: at(2)
         real(wp), parameter :: row = 14.0_wp          ! height of a name [px]
         integer, parameter :: longest = 28            ! letters
         if (any(abs(taken(1, :names) - at(1)) < longest*letter_width*views%scale(section) .and. &
                 abs(taken(2, :names) - at(2)) < row*views%scale(section))) return
         names = names + 1
         taken(:, names) = at
         call add_label(chart, cut_text(text, longest), at/chart%units%length, where_to//" font ',10'", [.false., .false.])
      end subroutine add_name
   end subroutine name_places

   !> Where depths [m] stand in a view [m], a place a column.
   pure function places_at(views, view, md) result(places)
      type(views_type), intent(in) :: views
      integer, intent(in) :: view
      real(wp), intent(in) :: md(:)
      real(wp) :: places(2, size(md))
      integer :: i
      do i = 1, size(md)
         places(:, i) = place_at(views, view, md(i))
      end do
   end function places_at

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

   !> Title of a picture of a case.
   pure function case_title(units, load_case) result(title)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      character(:), allocatable :: title
      integer, parameter :: few = 6
      title = load_case%name//': '//trim(operation_label(load_case%operation))//' at '// &
         in_units(units, unit_length, load_case%bit_depth, few)
      if (abs(load_case%wob) > 0.0_wp) title = title//', weight on bit '//in_units(units, unit_force, load_case%wob, few)
   end function case_title
end module dg_path_picture

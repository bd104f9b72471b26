!> Picture of the loads of the string of one load case against depth, by all models. Panels: axial force with buckling limits;
!> torque or bending moment; side force on the length of a joint; place of the string in the hole.
module dg_forces_picture
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_chart, only: add_curve, add_depth_curve, add_depth_panel, add_key, add_points, beside, chart_type, fit_range, new_chart, &
                       set_depth
   use dg_quantity, only: quantity_angle, quantity_force, quantity_length, quantity_moment
   use dg_curve_look, only: colour_black, colour_grey, colour_of, limit_dash, line_style, mark_style
   use dg_depth_curve, only: kept_points, least_around, lone_angles
   use dg_job, only: job_type, model_name
   use dg_line_load, only: force_on_length
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_path_picture, only: case_title
   use dg_profile, only: profile_type, side_above, state_free
   use dg_text, only: either, to_text
   use dg_unit_kind, only: in_units
   implicit none
   private
   public :: forces_chart

   !> Most marks in a panel: more make a band.
   integer, parameter :: most_marks = 300
   !> Left, right, bottom and top of the panels, and the gap between them, in parts of the picture.
   real(wp), parameter :: all_panels(4) = [0.075_wp, 0.985_wp, 0.125_wp, 0.82_wp], gap = 0.03_wp
   !> Most places along the string at which side forces are shown.
   integer, parameter :: most_places = 1000

contains

   !> All `results` have profiles.
   function forces_chart(job, model, results, alongs, left_out) result(chart)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)      !< of one case, one a model
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      character(*), intent(in) :: left_out                  !< models without a solution; '': none
      type(chart_type) :: chart
      character(:), allocatable :: title
      integer :: k
      associate (load_case => model%cases(results(1)%case_index), units => job%units)
         title = case_title(units, load_case)
         if (left_out /= '') title = title//'; no solution:'//left_out
         chart = new_chart('forces_'//load_case%name, title, units, 580, [0.83_wp, 0.92_wp])
         call set_depth(chart, 'measured depth', [0.0_wp, load_case%bit_depth], model%holes, place(1), .false.)
         call add_axial(chart, results, alongs)
         if (rotates(load_case%operation) .or. abs(load_case%tob) > 0.0_wp) then
            call add_depth_panel(chart, place(2), 'torque', quantity_moment)
            do k = 1, size(results)
               call add(results(k)%profile%torque)
            end do
         else
            call add_depth_panel(chart, place(2), 'bending moment', quantity_moment)
            do k = 1, size(results)
               call add(results(k)%profile%bending)
            end do
         end if
         call fit_range(chart)
         call add_side_force(chart, results, alongs(1)%pipe_joint)
         call add_clock(chart, results)
      end associate
   contains
      subroutine add(moments)
         real(wp), intent(in) :: moments(:)
         call add_depth_curve(chart, results(k)%profile%md, moments, job%units%moment, line_style(k), '', colour_of(k))
      end subroutine add
   end function forces_chart

   pure function place(number)
      integer, intent(in) :: number      !< of the panel
      real(wp) :: place(4)
      place = beside(number, 4, all_panels, gap)
   end function place

   subroutine add_axial(chart, results, alongs)
      type(chart_type), intent(inout) :: chart
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)
      real(wp) :: ends(2)
      integer :: k, shown
      call add_depth_panel(chart, place(1), 'effective axial force', quantity_force)
      do k = 1, size(results)
         call add_depth_curve(chart, results(k)%profile%md, results(k)%profile%axial, chart%units%force, line_style(k), &
                              trim(model_name(results(k)%model)), '')
      end do
      call axial_range(results, alongs, chart%units%force, ends(1), ends(2), shown)
      call fit_range(chart, ends)
      associate (look => 'with lines lw 1.2 dt '//limit_dash//" lc rgb '", md => results(1)%profile%md)
         if (shown > 0) then
            call add_limit(chart, md, alongs(1)%sinusoidal, ends(1), look//colour_black//"'", 'sinusoidal buckling')
            call add_limit(chart, md, alongs(1)%helical, ends(1), look//colour_grey//"'", 'helical buckling, lower limit')
         end if
         call add_arrows(chart, md, alongs(1)%sinusoidal, ends, shown > 0)
      end associate
   end subroutine add_axial

   !> Add a buckling limit as compression. If it jumps from station to station, the least one near each depth is shown, which
   !> is where the string is nearest to it. Values beyond the axis are left out.
   subroutine add_limit(chart, md, limit, least, look, name)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: md(:), limit(:)   !< as many
      real(wp), intent(in) :: least             !< end of the axis, in the deck's units
      character(*), intent(in) :: look, name
      real(wp) :: values(size(limit)), width
      integer, parameter :: most_kept = 60
      !> Part of the depth within which the least limit counts.
      real(wp), parameter :: near = 1.0_wp/30.0_wp
      character(:), allocatable :: note
      note = ''
      values = limit
      associate (units => chart%units)
         if (count(kept_points(md, values, 0.01_wp*abs(least)*units%force)) > most_kept) then
            width = near*chart%depth%y%ends(1)
            values = least_around(md, limit, width*units%length)
            note = ', least within '//to_text(width, 2)//' '//trim(units%length_label)
         end if
         where (is_missing(values))
            values = missing
         else where (-values < least*units%force)
            values = missing
         else where
            values = -values
         end where
         call add_depth_curve(chart, md, values, units%force, look, name//note, '')
      end associate
   end subroutine add_limit

   !> Add arrows at the edge of the axis where the sinusoidal limit is beyond it.
   subroutine add_arrows(chart, md, limit, ends, some_shown)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: md(:), limit(:)   !< as many
      real(wp), intent(in) :: ends(2)           !< of the axis, in the deck's units
      logical, intent(in) :: some_shown         !< a limit is on the axis somewhere
      integer, parameter :: many = 24
      real(wp), parameter :: share = 0.05_wp
      real(wp) :: arrows(4, many), across       ! from where, and how far
      logical :: beyond(many)
      integer :: i, row
      across = share*(ends(2) - ends(1))
      do i = 1, many
         arrows(:, i) = [ends(1) + across, (real(i, wp) - 0.5_wp)/many*chart%depth%y%ends(1), -across, 0.0_wp]
         row = minloc(abs(md - arrows(2, i)*chart%units%length), dim=1)
         beyond(i) = .not. is_missing(limit(row)) .and. -limit(row) < ends(1)*chart%units%force
      end do
      if (.not. any(beyond)) return
      call add_points(chart, arrows(:, pack([(i, i=1, many)], beyond)), &
                      "with vectors head filled size screen 0.006,20 lw 1 lc rgb '"//colour_grey//"'")
      call add_key(chart, "with lines lw 1 lc rgb '"//colour_grey//"'", &
                   either('arrow: limit beyond the axis', 'arrow: buckling limits lie beyond the axis', some_shown))
   end subroutine add_arrows

   !> Side force on the length of a joint of pipe: the load of a single joint. Forces of stabilizers and edges are then
   !> comparable.
   subroutine add_side_force(chart, results, joint)
      type(chart_type), intent(inout) :: chart
      type(case_result_type), intent(in) :: results(:)
      real(wp), intent(in) :: joint            !< that length [m]
      real(wp) :: length
      integer :: k, i, n
      associate (units => chart%units)
         call add_depth_panel(chart, place(3), 'side force on '//in_units(units, quantity_length, joint, 3), quantity_force)
         do k = 1, size(results)
            associate (profile => results(k)%profile)
               length = chart%depth%y%ends(1)*units%length - profile%md(1)
               n = max(2, min(most_places, ceiling(length/(joint/16.0_wp))))
               associate (places => profile%md(1) + length*[(real(i, wp)/n, i=0, n)])
                  call add_depth_curve(chart, places, force_on_length(profile%md, profile%side_force, joint, places), &
                                       units%force, line_style(k), '', colour_of(k))
               end associate
            end associate
         end do
      end associate
      call fit_range(chart)
   end subroutine add_side_force

   !> Where the string touches. The first model is on top, those below it larger, so that all can be seen.
   subroutine add_clock(chart, results)
      type(chart_type), intent(inout) :: chart
      type(case_result_type), intent(in) :: results(:)
      integer :: k
      call add_depth_panel(chart, place(4), 'clock angle of contact', quantity_angle)
      associate (axis => chart%panels(4)%x)
         axis%ends = [-90.0_wp, 270.0_wp]
         axis%tics = '("" -90, "0 high" 0, "90" 90, "180 low" 180, "270" 270)'
      end associate
      do k = size(results), 1, -1
         call add_contact(chart, results(k)%profile, mark_style(k, 0.2_wp + 0.12_wp*k))
      end do
   end subroutine add_clock

   !> Clock angles of one model, cut open at 270 deg, not at the high side: a string that lies there is one curve.
   subroutine add_contact(chart, profile, look)
      type(chart_type), intent(inout) :: chart
      type(profile_type), intent(in) :: profile
      character(*), intent(in) :: look
      logical :: shown(count(profile%side /= side_above))
      integer :: rows(size(shown))     ! one a depth
      real(wp), allocatable :: angles(:)
      integer :: i, n
      rows = pack([(i, i=1, size(profile%side))], profile%side /= side_above)
      shown = profile%gap_state(rows) /= state_free
      shown = shown .and. .not. lone_angles(profile%clock(rows), shown)
      n = (count(shown) + most_marks - 1)/most_marks
      if (n > 1) shown = shown .and. [(modulo(i, n) == 0, i=1, size(shown))]
      angles = pack(profile%clock(rows), shown)/chart%units%angle
      where (angles > 270.0_wp) angles = angles - 360.0_wp
      call add_curve(chart, angles, pack(profile%md(rows), shown)/chart%units%length, look, '')
   end subroutine add_contact

   !> Range of the axial forces and of the limits that matter, if these leave the forces visible. They matter where the string
   !> is nearest to buckling, and at the least limit where it is compressed.
   pure subroutine axial_range(results, alongs, unit, least, most, shown)
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)
      real(wp), intent(in) :: unit               !< of force [N]
      real(wp), intent(out) :: least, most       !< ends of the axis, in that unit
      integer, intent(out) :: shown              !< rows of the first result whose limit is on it
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
      air = max(most - lowest, unit)
      least = lowest
      do k = 1, size(results)
         associate (along => alongs(k), known => .not. is_missing(alongs(k)%sinusoidal))
            if (.not. any(known)) cycle
            limit = along%sinusoidal(minloc(along%buckling_margin, mask=known, dim=1))
            do i = 1, 2
               if (-limit > lowest - share*air) least = min(least, -limit)
               limit = minval(along%sinusoidal, mask=known .and. results(k)%profile%axial < 0.0_wp)
            end do
         end associate
      end do
      if (least < 0.0_wp) least = least - 0.15_wp*air
      shown = count(.not. is_missing(alongs(1)%sinusoidal) .and. -alongs(1)%sinusoidal >= least)
      least = least/unit
      most = (most + 0.05_wp*air)/unit
   end subroutine axial_range
end module dg_forces_picture

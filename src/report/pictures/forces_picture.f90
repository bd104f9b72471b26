!> What the string of one load case carries against depth, by all models: axial force with buckling limits, torque or bending
!> moment, side force on the length of a joint, and where the string lies.
module dg_forces_picture
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: quantity_force, quantity_moment, unit_text
   use dg_component, only: has_joints
   use dg_depth_curve, only: force_on_length, kept_points, least_around, lone_angles
   use dg_depth_panels, only: add_curve, add_points, band_look, curve_type, draw_panel, name_no_sections, panel_place_type, &
                              put_sections, range_of_curves
   use dg_drillstring, only: component_tops, drillstring_type
   use dg_gnuplot_script, only: add_series, colour_black, colour_grey, colour_of, end_script, legend, limit_dash, line_style, &
                                mark_style, panel, plot, series_type, start_script
   use dg_job, only: job_type, model_name
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_path_picture, only: case_title
   use dg_profile, only: side_above, state_free
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: forces_script

   integer, parameter :: digits = 8
   !> Most marks in a panel: more make a band, and tell no more.
   integer, parameter :: most_marks = 300
   !> Size of the picture [px], and the parts of its height that hold panels and legend.
   integer, parameter :: width = 1120, height = 580
   real(wp), parameter :: bottom = 0.125_wp, top = 0.82_wp, legend_top = 0.92_wp
   real(wp), parameter :: left(4) = [0.075_wp, 0.31_wp, 0.545_wp, 0.78_wp], wide = 0.205_wp
   !> Most places along the string at which side forces are shown.
   integer, parameter :: most_places = 1000

   !> The picture while it is made.
   type :: sheet_type
      type(unit_system_type) :: units
      real(wp) :: deepest = 0.0_wp                !< end of the depth axis [m]
      type(text_type), allocatable :: body(:)     !< commands of the panels
      type(series_type), allocatable :: key(:)    !< what the legend names
      logical :: banded = .false.                 !< a curve is drawn as a band
   end type sheet_type

contains

   !> All `results` have profiles.
   subroutine forces_script(name, job, model, results, alongs, left_out, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)      !< of one case, one a model
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      character(*), intent(in) :: left_out                  !< models without a solution; '': none
      type(text_type), allocatable, intent(out) :: lines(:)
      type(sheet_type) :: sheet
      character(:), allocatable :: title
      associate (load_case => model%cases(results(1)%case_index))
         sheet%units = job%units
         sheet%deepest = load_case%bit_depth
         allocate (sheet%body(0), sheet%key(0))
         call append_text(sheet%body, 'set yrange ['//to_text(sheet%deepest/job%units%length, digits)//':0]')
         call put_sections(sheet%body, model%holes, job%units, sheet%deepest, place(1), .false.)
         call draw_axial(sheet, results, alongs)
         call name_no_sections(sheet%body)
         if (rotates(load_case%operation) .or. abs(load_case%tob) > 0.0_wp) then
            call draw_moments(sheet, results, 2, 'torque', .true.)
         else
            call draw_moments(sheet, results, 2, 'bending moment', .false.)
         end if
         call draw_side_force(sheet, results, &
                              joint_length(model%strings(string_index(model%strings, load_case%string)), &
                                           sheet%deepest - results(1)%profile%md(1)))
         if (sheet%banded) call add_series(sheet%key, 'NaN', band_look(colour_of(1)), 'least to greatest, mean as line')
         call draw_clock(sheet, results)
         title = case_title(job%units, load_case)
         if (left_out /= '') title = title//'; no solution:'//left_out
         call start_script(lines, name, width, height)
         call legend(lines, title, sheet%key, top + 0.01_wp, legend_top)
         lines = [lines, sheet%body]
         call end_script(lines)
      end associate
   end subroutine forces_script

   pure function place(number) result(where_it_is)
      integer, intent(in) :: number
      type(panel_place_type) :: where_it_is
      where_it_is = panel_place_type(left(number), left(number) + wide, bottom, top, width, height)
   end function place

   !> A panel of curves; the label of depth stands beside the first one.
   subroutine draw_curves(sheet, number, label, curves, ends, others)
      type(sheet_type), intent(inout) :: sheet
      integer, intent(in) :: number                        !< of the panel
      character(*), intent(in) :: label
      type(curve_type), intent(in) :: curves(:)
      real(wp), intent(in) :: ends(2)                      !< of the axis, in the deck's units
      type(series_type), intent(in), optional :: others(:) !< beside the curves
      type(text_type) :: labels(2)
      logical :: banded
      labels(1)%text = label
      labels(2)%text = ''
      if (number == 1) labels(2)%text = 'measured depth ['//trim(sheet%units%length_label)//']'
      call draw_panel(sheet%body, place(number), labels, curves, ends(1), ends(2), banded, others)
      sheet%banded = sheet%banded .or. banded
   end subroutine draw_curves

   subroutine draw_axial(sheet, results, alongs)
      type(sheet_type), intent(inout) :: sheet
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)
      type(curve_type), allocatable :: curves(:)
      type(series_type), allocatable :: arrows(:)
      real(wp) :: ends(2)
      integer :: k, shown
      do k = 1, size(results)
         call add_curve(curves, results(k)%profile%md, sheet%units%length, results(k)%profile%axial, sheet%units%force, &
                        line_style(k), '')
         call add_series(sheet%key, 'NaN', line_style(k), trim(model_name(results(k)%model)))
      end do
      call axial_range(results, alongs, sheet%units%force, ends(1), ends(2), shown)
      allocate (arrows(0))
      associate (look => "with lines lw 1.2 dt "//limit_dash//" lc rgb '", md => results(1)%profile%md)
         if (shown > 0) then
            call add_limit(sheet, curves, md, alongs(1)%sinusoidal, ends(1), look//colour_black//"'", 'sinusoidal buckling')
            call add_limit(sheet, curves, md, alongs(1)%helical, ends(1), look//colour_grey//"'", 'helical buckling, lower limit')
         end if
         call add_arrows(sheet, arrows, md, alongs(1)%sinusoidal, ends, shown > 0)
      end associate
      call draw_curves(sheet, 1, 'effective axial force ['//unit_text(quantity_force, sheet%units)//']', curves, ends, arrows)
   end subroutine draw_axial

   !> A buckling limit as compression. One that jumps from station to station is the least one near each depth, so that it can be
   !> seen where the string comes nearest to it. What lies beyond the axis is left out.
   subroutine add_limit(sheet, curves, md, limit, least, look, label)
      type(sheet_type), intent(inout) :: sheet
      type(curve_type), allocatable, intent(inout) :: curves(:)
      real(wp), intent(in) :: md(:), limit(:)   !< as many
      real(wp), intent(in) :: least             !< end of the axis, in the deck's units
      character(*), intent(in) :: look, label
      real(wp) :: values(size(limit))
      integer, parameter :: most_kept = 60
      !> Part of the depth within which the least limit counts.
      real(wp), parameter :: near = 1.0_wp/30.0_wp
      character(:), allocatable :: note
      note = ''
      values = limit
      associate (units => sheet%units)
         if (count(kept_points(md, values, 0.01_wp*abs(least)*units%force)) > most_kept) then
            values = least_around(md, limit, near*sheet%deepest)
            note = ', least within '//to_text(near*sheet%deepest/units%length, 2)//' '//trim(units%length_label)
         end if
         where (is_missing(values))
            values = missing
         else where (-values < least*units%force)
            values = missing
         else where
            values = -values
         end where
         call add_curve(curves, md, units%length, values, units%force, look, '')
      end associate
      call add_series(sheet%key, 'NaN', look, label//note)
   end subroutine add_limit

   !> Arrows at the edge of the axis beyond which the sinusoidal limit lies.
   subroutine add_arrows(sheet, arrows, md, limit, ends, some_shown)
      type(sheet_type), intent(inout) :: sheet
      type(series_type), allocatable, intent(inout) :: arrows(:)
      real(wp), intent(in) :: md(:), limit(:)   !< as many
      real(wp), intent(in) :: ends(2)           !< of the axis, in the deck's units
      logical, intent(in) :: some_shown         !< a limit is on the axis somewhere
      integer, parameter :: many = 24
      real(wp), parameter :: share = 0.05_wp
      character(*), parameter :: look = "with vectors head filled size screen 0.006,20 lw 1 lc rgb '"//colour_grey//"'"
      real(wp) :: depths(many), across
      logical :: beyond(many)
      integer :: i, row
      do i = 1, many
         depths(i) = (real(i, wp) - 0.5_wp)/many*sheet%deepest
         row = minloc(abs(md - depths(i)), dim=1)
         beyond(i) = .not. is_missing(limit(row)) .and. -limit(row) < ends(1)*sheet%units%force
      end do
      if (.not. any(beyond)) return
      depths = depths/sheet%units%length
      across = share*(ends(2) - ends(1))
      call add_points(sheet%body, '$beyond', spread(ends(1) + across, 1, count(beyond)), pack(depths, beyond))
      call add_series(arrows, '$beyond using 1:2:('//to_text(-across, digits)//'):(0)', look, '')
      call add_series(sheet%key, 'NaN with lines lc rgb ''#ffffff'' notitle, NaN', "with lines lw 1 lc rgb '"//colour_grey//"'", &
                      trim(merge('arrow: limit beyond the axis                 ', &
                                 'arrow: buckling limits lie beyond the axis   ', some_shown)))
   end subroutine add_arrows

   subroutine draw_moments(sheet, results, number, label, is_torque)
      type(sheet_type), intent(inout) :: sheet
      type(case_result_type), intent(in) :: results(:)
      integer, intent(in) :: number
      character(*), intent(in) :: label
      logical, intent(in) :: is_torque
      type(curve_type), allocatable :: curves(:)
      real(wp) :: ends(2)
      integer :: k
      do k = 1, size(results)
         associate (profile => results(k)%profile, units => sheet%units)
            if (is_torque) then
               call add_curve(curves, profile%md, units%length, profile%torque, units%moment, line_style(k), colour_of(k))
            else
               call add_curve(curves, profile%md, units%length, profile%bending, units%moment, line_style(k), colour_of(k))
            end if
         end associate
      end do
      call range_of_curves(curves, ends(1), ends(2))
      call draw_curves(sheet, number, label//' ['//unit_text(quantity_moment, sheet%units)//']', curves, ends)
   end subroutine draw_moments

   !> On the length of a joint of pipe: what a joint carries that touches alone, and what stabilisers and edges press with,
   !> in numbers that can be compared.
   subroutine draw_side_force(sheet, results, joint)
      type(sheet_type), intent(inout) :: sheet
      type(case_result_type), intent(in) :: results(:)
      real(wp), intent(in) :: joint            !< that length [m]
      type(curve_type), allocatable :: curves(:)
      real(wp), allocatable :: places(:)
      real(wp) :: ends(2), first
      integer :: k, i, n
      associate (units => sheet%units, deepest => sheet%deepest)
         do k = 1, size(results)
            associate (profile => results(k)%profile)
               first = profile%md(1)
               n = max(2, min(most_places, ceiling((deepest - first)/(joint/16.0_wp))))
               if (allocated(places)) deallocate (places)
               allocate (places, source=first + (deepest - first)*[(real(i, wp)/n, i=0, n)])
               call add_curve(curves, places, units%length, force_on_length(profile%md, profile%side_force, joint, places), &
                              units%force, line_style(k), colour_of(k))
            end associate
         end do
         call range_of_curves(curves, ends(1), ends(2))
         call draw_curves(sheet, 3, 'side force on '//to_text(joint/units%length, 3)//' '//trim(units%length_label)//' ['// &
                          unit_text(quantity_force, units)//']', curves, ends)
      end associate
   end subroutine draw_side_force

   subroutine draw_clock(sheet, results)
      type(sheet_type), intent(inout) :: sheet
      type(case_result_type), intent(in) :: results(:)
      type(series_type), allocatable :: series(:)
      integer :: k, i, n
      logical, allocatable :: shown(:)
      real(wp), allocatable :: angles(:)
      integer, allocatable :: rows(:)     ! one a depth
      allocate (series(0))
      ! the first model on top, those below it larger, so that all can be seen
      do k = size(results), 1, -1
         associate (profile => results(k)%profile, block => '$clock'//to_text(k))
            if (allocated(shown)) deallocate (shown, angles)
            rows = pack([(i, i=1, size(profile%side))], profile%side /= side_above)
            allocate (shown, source=profile%gap_state(rows) /= state_free)
            shown = shown .and. .not. lone_angles(profile%clock(rows), shown)
            n = (count(shown) + most_marks - 1)/most_marks
            if (n > 1) shown = shown .and. [(modulo(i, n) == 0, i=1, size(shown))]
            allocate (angles, source=pack(profile%clock(rows), shown)/sheet%units%angle)
            ! cut open at 270 deg, not at the high side: a string that lies there is one curve
            where (angles > 270.0_wp) angles = angles - 360.0_wp
            call add_points(sheet%body, block, angles, pack(profile%md(rows), shown)/sheet%units%length)
            call add_series(series, block//' using 1:2', mark_style(k, 0.2_wp + 0.12_wp*k), '')
         end associate
      end do
      associate (there => place(4))
         call panel(sheet%body, there%left, there%right, there%bottom, there%top, 'clock angle of contact [deg]', '')
      end associate
      call append_text(sheet%body, 'set xrange [-90:270]; set xtics ("" -90, "0 high" 0, "90" 90, "180 low" 180, "270" 270)')
      call plot(sheet%body, series, may_lack=.true.)
   end subroutine draw_clock

   !> Length of a joint of that component with joints which makes most of the string; of pipe of range 2 where none has any [m].
   pure function joint_length(string, length) result(joint)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: length         !< of the string in the hole [m]
      real(wp) :: joint
      real(wp), parameter :: usual = 9.5_wp
      real(wp) :: tops(size(string%components)), lengths(size(string%components))
      integer :: longest
      tops = component_tops(string, length)
      lengths(1) = tops(1)
      lengths(2:) = tops(2:) - tops(:size(tops) - 1)
      longest = maxloc(lengths, mask=has_joints(string%components), dim=1)
      joint = usual
      if (longest > 0) joint = string%components(longest)%joint_spacing
   end function joint_length

   !> The axial forces, and those limits that matter, as far as they do not crush them: where the string is nearest to
   !> buckling, and the least one where it is compressed.
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

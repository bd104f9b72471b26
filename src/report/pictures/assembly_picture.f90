!> The lowest part of the string as it lies in its hole: seen from the side, with hole, body, blades and what it presses the wall
!> with; below it its bending moment and how far it is off the axis of the hole. Across the hole all is drawn larger.
module dg_assembly_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_column, only: quantity_moment, quantity_width, unit_text
   use dg_component, only: contact_diameter, has_blades, has_joints
   use dg_depth_panels, only: add_points
   use dg_drillstring, only: all_centralizer_ends, component_at, component_tops, drillstring_type, joint_ends
   use dg_gnuplot_script, only: add_series, colour_of, cut_text, dash_of, end_script, legend, panel, plot, series_type, spelled, &
                                start_script, y_range
   use dg_hole_section, only: hole_section_at, hole_section_type
   use dg_job, only: job_type, model_name
   use dg_missing, only: is_missing
   use dg_model, only: model_type, string_index
   use dg_path_picture, only: case_title
   use dg_profile, only: profile_type
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: assembly_script, shown_length

   integer, parameter :: digits = 8
   integer, parameter :: width = 1120, height = 700   !< [px]
   real(wp), parameter :: left = 0.085_wp, right = 0.985_wp
   !> Ends of the three panels, from the top down, and of the legend, in parts of the height.
   real(wp), parameter :: bottoms(3) = [0.50_wp, 0.295_wp, 0.09_wp], tops(3) = [0.86_wp, 0.475_wp, 0.27_wp], legend_top = 0.94_wp
   !> Length of string that is drawn [m]: bit, motor and two or three stabilisers.
   real(wp), parameter :: shown_length = 40.0_wp
   !> Room above and below the hole, of its diameter [-]: for the forces.
   real(wp), parameter :: air = 0.45_wp
   !> Contacts with less than this part of the greatest force have no number [-].
   real(wp), parameter :: least_told = 0.02_wp
   !> Points at which the body is drawn between places where its diameter changes.
   integer, parameter :: places = 161
   character(*), parameter :: body_look = "with filledcurves closed fs solid border lc rgb '#333333' fc rgb '#b9c4cc'", &
                              blade_look = "with filledcurves closed fs solid border lc rgb '#333333' fc rgb '#56707f'"

   !> The picture while it is made.
   type :: sheet_type
      type(unit_system_type) :: units
      real(wp) :: bit = 0.0_wp                    !< measured depth of the bit [m]
      real(wp) :: shown = 0.0_wp                  !< length of string that is drawn [m]
      type(text_type), allocatable :: body(:)     !< commands of the panels
      type(series_type), allocatable :: key(:)    !< what the legend names
      type(series_type), allocatable :: series(:) !< of the panel that is being made
      real(wp) :: ends(2) = 0.0_wp                !< of its axis, in the deck's units
   end type sheet_type

contains

   !> `result` has a profile with the place of the string in the hole.
   subroutine assembly_script(name, job, model, result, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(text_type), allocatable, intent(out) :: lines(:)
      type(sheet_type) :: sheet
      sheet%units = job%units
      sheet%bit = model%cases(result%case_index)%bit_depth
      sheet%shown = min(shown_length, sheet%bit - result%profile%md(1))
      allocate (sheet%key(0), sheet%body(0))
      call draw_view(sheet, model%holes, model%strings(string_index(model%strings, model%cases(result%case_index)%string)), result)
      call draw_moment(sheet, result%profile)
      call draw_offset(sheet, result%profile)
      call start_script(lines, name, width, height)
      call legend(lines, case_title(job%units, model%cases(result%case_index))//', model '// &
                  trim(model_name(result%model))//bit_text(job%units, result), sheet%key, tops(1) + 0.02_wp, legend_top)
      lines = [lines, sheet%body]
      call end_script(lines)
   end subroutine assembly_script

   !> What the bit does.
   pure function bit_text(units, result) result(text)
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(in) :: result
      character(:), allocatable :: text
      integer, parameter :: few = 3
      text = ''
      if (.not. is_missing(result%bit_side_force)) then
         text = text//'; bit presses '//to_text(result%bit_side_force/units%force, few)//' '//trim(units%force_label)
         if (.not. is_missing(result%bit_side_clock)) text = text//' at '// &
            to_text(real(nint(result%bit_side_clock/units%angle), wp))//' deg'
      end if
      if (.not. is_missing(result%bit_tilt)) then
         text = text//', tilts '//to_text(result%bit_tilt/units%angle, few)//' deg'
         if (.not. is_missing(result%bit_tilt_clock)) text = text//' at '// &
            to_text(real(nint(result%bit_tilt_clock/units%angle), wp))//' deg'
      end if
   end function bit_text

   !> Seen from the side, the high side up: distance above the bit against offset, the bit at the right.
   subroutine draw_view(sheet, holes, string, result)
      type(sheet_type), intent(inout) :: sheet
      type(hole_section_type), intent(in) :: holes(:)
      type(drillstring_type), intent(in) :: string
      type(case_result_type), intent(in) :: result
      character(*), parameter :: wall = "with lines lw 2.5 lc rgb '#8c6d46'"
      real(wp) :: x(places), axis(places), half
      integer :: i
      if (allocated(sheet%series)) deallocate (sheet%series)
      allocate (sheet%series(0))
      x = sheet%shown*[(real(i, wp)/(places - 1), i=0, places - 1)]
      do i = 1, places
         axis(i) = 0.5_wp*holes(hole_section_at(holes, sheet%bit - x(i)))%diameter
      end do
      half = maxval(axis)
      associate (along => sheet%units%length, across => sheet%units%diameter)
         call add_points(sheet%body, '$high', x/along, axis/across)
         call add_points(sheet%body, '$low', x/along, -axis/across)
         call append_text(sheet%body, 'unset arrow; unset label; unset object')
         call add_string(sheet, holes, string, result%profile, half)
         call add_series(sheet%series, '$high using 1:2', wall, '')
         call add_series(sheet%series, '$low using 1:2', wall, '')
         call add_series(sheet%series, '0', "with lines lw 0.8 dt (12,4,2,4) lc rgb '#777777'", '')
         call add_contacts(sheet, result, half)
         call add_series(sheet%key, 'NaN', wall, 'wall of the hole')
         call add_series(sheet%key, 'NaN', body_look, 'body')
         call add_series(sheet%key, 'NaN', blade_look, 'blades, joints, centralisers')
         call add_series(sheet%key, 'NaN', "with lines lw 2.5 lc rgb '"//colour_of(2)//"'", 'contact, force in '// &
                         trim(sheet%units%force_label))
         call panel(sheet%body, left, right, bottoms(1), tops(1), '', side_label(result%inclination)//' ['// &
                    unit_text(quantity_width, sheet%units)//']')
         call append_text(sheet%body, "set xrange ["//to_text(sheet%shown/along, digits)//":0]; set format x ''; set yrange ["// &
                          to_text(-half*(1.0_wp + 2.0_wp*air)/across, digits)//':'// &
                          to_text(half*(1.0_wp + 2.0_wp*air)/across, digits)//']; set ytics autofreq')
      end associate
      call plot(sheet%body, sheet%series)
      call append_text(sheet%body, 'unset arrow; unset label')
   end subroutine draw_view

   !> The string from the bit up, with its names; what is bent is drawn bent.
   subroutine add_string(sheet, holes, string, profile, half)
      type(sheet_type), intent(inout) :: sheet
      type(hole_section_type), intent(in) :: holes(:)
      type(drillstring_type), intent(in) :: string
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: half             !< of the widest hole [m]
      real(wp), allocatable :: part_tops(:), joints(:), rings(:)
      real(wp) :: ends(2), free_from, touching
      integer :: i, k
      allocate (part_tops, source=component_tops(string, sheet%bit - profile%md(1)))
      free_from = 0.0_wp
      do k = 1, size(string%components)
         associate (part => string%components(k))
            ends = [0.0_wp, part_tops(k)]
            if (k > 1) ends(1) = part_tops(k - 1)
            if (ends(1) >= sheet%shown .or. ends(2) <= ends(1)) cycle
            touching = contact_diameter(part, sheet%bit - part_tops(k))
            ends(2) = min(ends(2), sheet%shown)
            call add_piece(sheet, profile, '$body'//to_text(k), ends, 0.5_wp*part%od, body_look)
            if (has_blades(part) .or. (touching > part%od .and. .not. has_joints(part))) &
               call add_piece(sheet, profile, '$blade'//to_text(k), ends, 0.5_wp*touching, blade_look)
            call name_part(sheet, part%name, ends, half, free_from)
         end associate
      end do
      allocate (joints, source=joint_ends(string, part_tops))
      allocate (rings, source=all_centralizer_ends(string, part_tops))
      do i = 1, size(rings) - 1, 2
         if (rings(i) >= sheet%shown .or. rings(i + 1) <= rings(i)) cycle
         k = component_at(part_tops, 0.5_wp*(rings(i) + rings(i + 1)))
         call add_piece(sheet, profile, '$ring'//to_text(i), [rings(i), min(rings(i + 1), sheet%shown)], &
                        0.5_wp*min(string%components(k)%centralizer%od, &
                                   holes(hole_section_at(holes, sheet%bit - rings(i)))%diameter), blade_look)
      end do
      do i = 1, size(joints) - 1, 2
         if (joints(i) >= sheet%shown .or. joints(i + 1) <= joints(i)) cycle
         k = component_at(part_tops, 0.5_wp*(joints(i) + joints(i + 1)))
         call add_piece(sheet, profile, '$joint'//to_text(i), [joints(i), min(joints(i + 1), sheet%shown)], &
                        0.5_wp*string%components(k)%joint_od, blade_look)
      end do
   end subroutine add_string

   !> What the axis across is called: a vertical hole has no high side.
   pure function side_label(inclination) result(text)
      real(wp), intent(in) :: inclination    !< at the bit [rad]
      character(:), allocatable :: text
      real(wp), parameter :: vertical = 1.0e-3_wp
      text = 'low to high side'
      if (inclination < vertical) text = 'south to north'
   end function side_label

   !> A piece of the string between two distances above the bit, as an outline that follows its axis.
   subroutine add_piece(sheet, profile, block, ends, radius, look)
      type(sheet_type), intent(inout) :: sheet
      type(profile_type), intent(in) :: profile
      character(*), intent(in) :: block
      real(wp), intent(in) :: ends(2), radius    !< [m]
      character(*), intent(in) :: look
      integer, parameter :: most = 40
      real(wp) :: x(most), middle(most)
      integer :: i, n
      n = max(2, min(most, 1 + ceiling((ends(2) - ends(1))/0.25_wp)))
      x(:n) = ends(1) + (ends(2) - ends(1))*[(real(i, wp)/(n - 1), i=0, n - 1)]
      do i = 1, n
         middle(i) = offset_at(profile, sheet%bit - x(i))
      end do
      call add_points(sheet%body, block, [x(:n), x(n:1:-1)]/sheet%units%length, &
                      [middle(:n) + radius, middle(n:1:-1) - radius]/sheet%units%diameter)
      call add_series(sheet%series, block//' using 1:2', look, '')
   end subroutine add_piece

   !> Towards the high side, of the string's axis off that of the hole [m].
   pure function offset_at(profile, md) result(offset)
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: md      !< [m]
      real(wp) :: offset, share
      integer :: i
      do i = 2, size(profile%md) - 1
         if (profile%md(i) >= md) exit
      end do
      i = min(i, size(profile%md))
      share = 1.0_wp
      if (profile%md(i) > profile%md(i - 1)) share = (md - profile%md(i - 1))/(profile%md(i) - profile%md(i - 1))
      offset = (1.0_wp - share)*profile%displacement(i - 1)*cos(profile%clock(i - 1)) + &
               share*profile%displacement(i)*cos(profile%clock(i))
   end function offset_at

   !> The name of a part above the hole; of one too short for it below, where the part below it has left room.
   subroutine name_part(sheet, name, ends, half, free_from)
      type(sheet_type), intent(inout) :: sheet
      character(*), intent(in) :: name
      real(wp), intent(in) :: ends(2), half
      real(wp), intent(inout) :: free_from      !< distance above the bit from which on names below the hole have room [m]
      real(wp), parameter :: small_letter = 6.0_wp
      real(wp) :: letter, height_of_name, middle, half_name
      integer :: most
      letter = small_letter*sheet%shown/((right - left)*width)
      height_of_name = half*(1.0_wp + 1.65_wp*air)
      middle = 0.5_wp*sum(ends)
      most = int((ends(2) - ends(1))/letter)
      if (len(name) > most) then
         height_of_name = -height_of_name
         half_name = 0.5_wp*letter*len(name)
         most = len(name)
         if (middle + half_name < free_from .or. free_from + 2.0_wp*half_name > sheet%shown) return
         middle = max(middle, free_from + half_name)
         free_from = middle + half_name + 2.0_wp*letter
      end if
      call append_text(sheet%body, 'set label '//spelled(cut_text(name, most))//' at first '// &
                       to_text(middle/sheet%units%length, digits)//', first '// &
                       to_text(height_of_name/sheet%units%diameter, digits)//" center font ',9' textcolor rgb '#333333'")
   end subroutine name_part

   !> Arrows where the wall presses, with their forces; on the side on which it does, seen from here.
   subroutine add_contacts(sheet, result, half)
      type(sheet_type), intent(inout) :: sheet
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: half
      real(wp) :: greatest, side, x
      integer :: i
      character(:), allocatable :: at
      if (.not. allocated(result%contacts)) return
      greatest = 0.0_wp
      do i = 1, size(result%contacts)
         if (sheet%bit - result%contacts(i)%md <= sheet%shown) greatest = max(greatest, result%contacts(i)%force)
      end do
      do i = 1, size(result%contacts)
         associate (contact => result%contacts(i), across => sheet%units%diameter)
            x = sheet%bit - contact%md
            if (x > sheet%shown .or. contact%force < least_told*greatest .or. .not. contact%force > 0.0_wp) cycle
            side = sign(1.0_wp, cos(contact%clock))
            at = to_text(max(x, 0.0_wp)/sheet%units%length, digits)//', first '
            call append_text(sheet%body, 'set arrow from first '//at//to_text(side*half*(1.0_wp + 1.1_wp*air)/across, digits)// &
                             ' to first '//at//to_text(side*half/across, digits)//" head filled size screen 0.008,20 lw 2.5 "// &
                             "lc rgb '"//colour_of(2)//"' front")
            call append_text(sheet%body, 'set label '//spelled(to_text(contact%force/sheet%units%force, 3))//' at first '//at// &
                             to_text(side*half*(1.0_wp + 0.7_wp*air)/across, digits)// &
                             " right offset -0.6,0 font ',10' textcolor rgb '"//colour_of(2)//"' front")
         end associate
      end do
   end subroutine add_contacts

   subroutine draw_moment(sheet, profile)
      type(sheet_type), intent(inout) :: sheet
      type(profile_type), intent(in) :: profile
      call start_row(sheet)
      call add_row(sheet, profile%md, '$moment', profile%bending/sheet%units%moment, 1)
      call draw_row(sheet, 2, 'moment ['//unit_text(quantity_moment, sheet%units)//']', '')
   end subroutine draw_moment

   !> Off the axis, towards the high side and to the right of it.
   subroutine draw_offset(sheet, profile)
      type(sheet_type), intent(inout) :: sheet
      type(profile_type), intent(in) :: profile
      call start_row(sheet)
      call add_row(sheet, profile%md, '$up', profile%displacement*cos(profile%clock)/sheet%units%diameter, 1)
      call add_row(sheet, profile%md, '$right', profile%displacement*sin(profile%clock)/sheet%units%diameter, 2)
      call add_series(sheet%key, 'NaN', row_look(1), 'moment; offset to the high side')
      call add_series(sheet%key, 'NaN', row_look(2), 'offset to the right')
      call draw_row(sheet, 3, 'offset ['//unit_text(quantity_width, sheet%units)//']', &
                    'distance above the bit ['//trim(sheet%units%length_label)//']')
   end subroutine draw_offset

   subroutine start_row(sheet)
      type(sheet_type), intent(inout) :: sheet
      if (allocated(sheet%series)) deallocate (sheet%series)
      allocate (sheet%series(0))
      sheet%ends = 0.0_wp
   end subroutine start_row

   subroutine add_row(sheet, md, block, values, number)
      type(sheet_type), intent(inout) :: sheet
      real(wp), intent(in) :: md(:)            !< [m]
      character(*), intent(in) :: block
      real(wp), intent(in) :: values(:)        !< as many, in the deck's units
      integer, intent(in) :: number
      logical :: near(size(values))
      near = sheet%bit - md <= sheet%shown
      sheet%ends(1) = min(sheet%ends(1), minval(values, mask=near))
      sheet%ends(2) = max(sheet%ends(2), maxval(values, mask=near))
      call add_points(sheet%body, block, (sheet%bit - pack(md, near))/sheet%units%length, pack(values, near))
      call add_series(sheet%series, block//' using 1:2', row_look(number), '')
   end subroutine add_row

   pure function row_look(number) result(look)
      integer, intent(in) :: number
      character(:), allocatable :: look
      look = "with lines lw 1.8 lc rgb '"//colour_of(number)//"' dt "//dash_of(number)
   end function row_look

   subroutine draw_row(sheet, number, label, x_label)
      type(sheet_type), intent(inout) :: sheet
      integer, intent(in) :: number
      character(*), intent(in) :: label, x_label
      call panel(sheet%body, left, right, bottoms(number), tops(number), x_label, label)
      call append_text(sheet%body, 'set xrange ['//to_text(sheet%shown/sheet%units%length, digits)//':0]')
      call y_range(sheet%body, sheet%ends(1), sheet%ends(2))
      if (x_label == '') then
         call append_text(sheet%body, "set format x ''")
      else
         call append_text(sheet%body, "set format x '% h'")
      end if
      call plot(sheet%body, sheet%series)
   end subroutine draw_row
end module dg_assembly_picture

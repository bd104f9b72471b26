!> The lowest part of the string as it lies in its hole: seen from the side, with hole, body, blades and what it presses the wall
!> with; below it its bending moment and how far it is off the axis of the hole. Across the hole all is drawn larger.
module dg_assembly_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_column, only: quantity_moment, quantity_width, unit_text
   use dg_component, only: component_type, has_blades, has_joints
   use dg_depth_panels, only: add_points
   use dg_drillstring, only: all_centralizer_ends, component_at, component_tops, joint_ends
   use dg_gnuplot_script, only: add_series, colour_black, colour_of, cut_text, dash_of, end_script, legend, panel, &
                                plot, series_type, spelled, start_script, y_range
   use dg_hole_section, only: hole_section_at
   use dg_job, only: job_type, model_name
   use dg_missing, only: is_missing
   use dg_model, only: model_type, string_index
   use dg_path_picture, only: case_title
   use dg_text, only: append_text, text_type, to_text
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

contains

   !> `result` has a profile with the place of the string in the hole.
   subroutine assembly_script(name, job, model, result, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: key(:), series(:)
      type(text_type), allocatable :: body(:)
      real(wp), allocatable :: part_tops(:)
      real(wp) :: bit, shown, across, along
      real(wp) :: low, high       ! ends of a row's axis, in the deck's units
      real(wp) :: free_from       ! distance above the bit from which on names below the hole have room [m]
      bit = model%cases(result%case_index)%bit_depth
      across = job%units%diameter
      along = job%units%length
      shown = min(shown_length, bit - result%profile%md(1))
      allocate (key(0), body(0))
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         allocate (part_tops, source=component_tops(string, bit - result%profile%md(1)))
         call draw_view(string%components)
      end associate
      call draw_moment()
      call draw_offset()
      call start_script(lines, name, width, height)
      call legend(lines, case_title(job%units, model%cases(result%case_index))//', model '// &
                  trim(model_name(result%model))//bit_text(), key, tops(1) + 0.02_wp, legend_top)
      lines = [lines, body]
      call end_script(lines)

   contains

      !> What the bit does.
      pure function bit_text() result(text)
         character(:), allocatable :: text
         integer, parameter :: few = 3
         text = ''
         if (.not. is_missing(result%bit_side_force)) then
            text = text//'; bit presses '//to_text(result%bit_side_force/job%units%force, few)//' '//trim(job%units%force_label)
            if (.not. is_missing(result%bit_side_clock)) text = text//' at '// &
               to_text(real(nint(result%bit_side_clock/job%units%angle), wp))//' deg'
         end if
         if (.not. is_missing(result%bit_tilt)) then
            text = text//', tilts '//to_text(result%bit_tilt/job%units%angle, few)//' deg'
            if (.not. is_missing(result%bit_tilt_clock)) text = text//' at '// &
               to_text(real(nint(result%bit_tilt_clock/job%units%angle), wp))//' deg'
         end if
      end function bit_text

      !> Seen from the side, the high side up: distance above the bit against offset, the bit at the right.
      subroutine draw_view(components)
         type(component_type), intent(in) :: components(:)
         character(*), parameter :: wall = "with lines lw 2.5 lc rgb '#8c6d46'"
         real(wp) :: x(places), axis(places), radius, ends(2), half
         real(wp), allocatable :: joints(:), rings(:)
         integer :: i, k, hole
         allocate (series(0))
         x = shown*[(real(i, wp)/(places - 1), i=0, places - 1)]
         half = 0.0_wp
         do i = 1, places
            hole = hole_section_at(model%holes, bit - x(i))
            axis(i) = 0.5_wp*model%holes(hole)%diameter
         end do
         half = maxval(axis)
         call add_points(body, '$high', x/along, axis/across)
         call add_points(body, '$low', x/along, -axis/across)
         call append_text(body, 'unset arrow; unset label; unset object')
         free_from = 0.0_wp
         ! bodies from the bit up; what is bent is drawn bent
         do k = 1, size(components)
            ends = [0.0_wp, part_tops(k)]
            if (k > 1) ends(1) = part_tops(k - 1)
            if (ends(1) >= shown .or. ends(2) <= ends(1)) cycle
            ends(2) = min(ends(2), shown)
            radius = 0.5_wp*components(k)%od
            call add_piece('$body'//to_text(k), ends, radius, fill('#b9c4cc'))
            if (has_blades(components(k)) .or. (components(k)%joint_od > components(k)%od .and. .not. has_joints(components(k)))) &
               call add_piece('$blade'//to_text(k), ends, 0.5_wp*components(k)%joint_od, fill('#56707f'))
            call name_part(components(k), ends, half)
         end do
         associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
            allocate (joints, source=joint_ends(string, part_tops))
            allocate (rings, source=all_centralizer_ends(string, part_tops))
         end associate
         do i = 1, size(rings) - 1, 2
            if (rings(i) >= shown .or. rings(i + 1) <= rings(i)) cycle
            k = component_at(part_tops, 0.5_wp*(rings(i) + rings(i + 1)))
            hole = hole_section_at(model%holes, bit - rings(i))
            call add_piece('$ring'//to_text(i), [rings(i), min(rings(i + 1), shown)], &
                           0.5_wp*min(components(k)%centralizer%od, model%holes(hole)%diameter), fill('#56707f'))
         end do
         do i = 1, size(joints) - 1, 2
            if (joints(i) >= shown .or. joints(i + 1) <= joints(i)) cycle
            k = component_at(part_tops, 0.5_wp*(joints(i) + joints(i + 1)))
            call add_piece('$joint'//to_text(i), [joints(i), min(joints(i + 1), shown)], 0.5_wp*components(k)%joint_od, &
                           fill('#56707f'))
         end do
         call add_series(series, '$high using 1:2', wall, '')
         call add_series(series, '$low using 1:2', wall, '')
         call add_series(series, '0', "with lines lw 0.8 dt (12,4,2,4) lc rgb '#777777'", '')
         call add_contacts(half)
         call add_series(key, 'NaN', wall, 'wall of the hole')
         call add_series(key, 'NaN', fill('#b9c4cc'), 'body')
         call add_series(key, 'NaN', fill('#56707f'), 'blades, joints, centralisers')
         call add_series(key, 'NaN', "with lines lw 2.5 lc rgb '"//colour_of(2)//"'", 'contact, force in '// &
                         trim(job%units%force_label))
         call panel(body, left, right, bottoms(1), tops(1), '', side_label()//' ['//unit_text(quantity_width, job%units)//']')
         call append_text(body, "set xrange ["//to_text(shown/along, digits)//":0]; set format x ''; set yrange ["// &
                          to_text(-half*(1.0_wp + 2.0_wp*air)/across, digits)//':'// &
                          to_text(half*(1.0_wp + 2.0_wp*air)/across, digits)//']; set ytics autofreq')
         call plot(body, series)
         call append_text(body, 'unset arrow; unset label')
      end subroutine draw_view

      !> What the axis across is called: a vertical hole has no high side.
      pure function side_label() result(text)
         character(:), allocatable :: text
         real(wp), parameter :: vertical = 1.0e-3_wp
         text = 'low to high side'
         if (result%inclination < vertical) text = 'south to north'
      end function side_label

      pure function fill(colour) result(look)
         character(*), intent(in) :: colour
         character(:), allocatable :: look
         look = "with filledcurves closed fs solid border lc rgb '#333333' fc rgb '"//colour//"'"
      end function fill

      !> A piece of the string between two distances above the bit, as an outline that follows its axis.
      subroutine add_piece(block, ends, radius, look)
         character(*), intent(in) :: block
         real(wp), intent(in) :: ends(2), radius    !< [m]
         character(*), intent(in) :: look
         integer, parameter :: most = 40
         real(wp) :: x(most), middle(most)
         integer :: i, n
         n = max(2, min(most, 1 + ceiling((ends(2) - ends(1))/0.25_wp)))
         x(:n) = ends(1) + (ends(2) - ends(1))*[(real(i, wp)/(n - 1), i=0, n - 1)]
         do i = 1, n
            middle(i) = offset_at(bit - x(i))
         end do
         call add_points(body, block, [x(:n), x(n:1:-1)]/along, [middle(:n) + radius, middle(n:1:-1) - radius]/across)
         call add_series(series, block//' using 1:2', look, '')
      end subroutine add_piece

      !> Towards the high side, of the string's axis off that of the hole [m].
      pure function offset_at(md) result(offset)
         real(wp), intent(in) :: md      !< [m]
         real(wp) :: offset, share
         integer :: i
         associate (profile => result%profile)
            do i = 2, size(profile%md) - 1
               if (profile%md(i) >= md) exit
            end do
            i = min(i, size(profile%md))
            share = 1.0_wp
            if (profile%md(i) > profile%md(i - 1)) share = (md - profile%md(i - 1))/(profile%md(i) - profile%md(i - 1))
            offset = (1.0_wp - share)*profile%displacement(i - 1)*cos(profile%clock(i - 1)) + &
                     share*profile%displacement(i)*cos(profile%clock(i))
         end associate
      end function offset_at

      !> The name of a part above the hole; of one too short for it below, where the part below it has left room.
      subroutine name_part(part, ends, half)
         type(component_type), intent(in) :: part
         real(wp), intent(in) :: ends(2), half
         real(wp), parameter :: small_letter = 6.0_wp
         real(wp) :: letter, height_of_name, middle, half_name
         integer :: most
         letter = small_letter*shown/((right - left)*width)
         height_of_name = half*(1.0_wp + 1.65_wp*air)
         middle = 0.5_wp*sum(ends)
         most = int((ends(2) - ends(1))/letter)
         if (len(part%name) > most) then
            height_of_name = -height_of_name
            half_name = 0.5_wp*letter*len(part%name)
            most = len(part%name)
            if (middle + half_name < free_from .or. free_from + 2.0_wp*half_name > shown) return
            middle = max(middle, free_from + half_name)
            free_from = middle + half_name + 2.0_wp*letter
         end if
         call append_text(body, 'set label '//spelled(cut_text(part%name, most))//' at first '//to_text(middle/along, digits)// &
                          ', first '//to_text(height_of_name/across, digits)//" center font ',9' textcolor rgb '#333333'")
      end subroutine name_part

      !> Arrows where the wall presses, with their forces; on the side on which it does, seen from here.
      subroutine add_contacts(half)
         real(wp), intent(in) :: half
         real(wp) :: greatest, side, x
         integer :: i
         character(:), allocatable :: at
         if (.not. allocated(result%contacts)) return
         greatest = 0.0_wp
         do i = 1, size(result%contacts)
            if (bit - result%contacts(i)%md <= shown) greatest = max(greatest, result%contacts(i)%force)
         end do
         do i = 1, size(result%contacts)
            associate (contact => result%contacts(i))
               x = bit - contact%md
               if (x > shown .or. contact%force < least_told*greatest .or. .not. contact%force > 0.0_wp) cycle
               side = sign(1.0_wp, cos(contact%clock))
               at = to_text(max(x, 0.0_wp)/along, digits)//', first '
               call append_text(body, 'set arrow from first '//at//to_text(side*half*(1.0_wp + 1.1_wp*air)/across, digits)// &
                                ' to first '//at//to_text(side*half/across, digits)//" head filled size screen 0.008,20 lw 2.5 "// &
                                "lc rgb '"//colour_of(2)//"' front")
               call append_text(body, 'set label '//spelled(to_text(contact%force/job%units%force, 3))//' at first '//at// &
                                to_text(side*half*(1.0_wp + 0.7_wp*air)/across, digits)// &
                                " right offset -0.6,0 font ',10' textcolor rgb '"//colour_of(2)//"' front")
            end associate
         end do
      end subroutine add_contacts

      subroutine draw_moment()
         call start_row()
         call add_row('$moment', result%profile%bending, job%units%moment, 1)
         call draw_row(2, 'moment ['//unit_text(quantity_moment, job%units)//']', '')
      end subroutine draw_moment

      !> Off the axis, towards the high side and to the right of it.
      subroutine draw_offset()
         call start_row()
         call add_row('$up', result%profile%displacement*cos(result%profile%clock), across, 1)
         call add_row('$right', result%profile%displacement*sin(result%profile%clock), across, 2)
         call add_series(key, 'NaN', row_look(1), 'moment; offset to the high side')
         call add_series(key, 'NaN', row_look(2), 'offset to the right')
         call draw_row(3, 'offset ['//unit_text(quantity_width, job%units)//']', &
                       'distance above the bit ['//trim(job%units%length_label)//']')
      end subroutine draw_offset

      subroutine start_row()
         if (allocated(series)) deallocate (series)
         allocate (series(0))
         low = 0.0_wp
         high = 0.0_wp
      end subroutine start_row

      subroutine add_row(block, values, unit, number)
         character(*), intent(in) :: block
         real(wp), intent(in) :: values(:), unit
         integer, intent(in) :: number
         logical :: near(size(values))
         near = bit - result%profile%md <= shown
         low = min(low, minval(values/unit, mask=near))
         high = max(high, maxval(values/unit, mask=near))
         call add_points(body, block, (bit - pack(result%profile%md, near))/along, pack(values, near)/unit)
         call add_series(series, block//' using 1:2', row_look(number), '')
      end subroutine add_row

      pure function row_look(number) result(look)
         integer, intent(in) :: number
         character(:), allocatable :: look
         look = "with lines lw 1.8 lc rgb '"//colour_of(number)//"' dt "//dash_of(number)
      end function row_look

      subroutine draw_row(number, label, x_label)
         integer, intent(in) :: number
         character(*), intent(in) :: label, x_label
         call panel(body, left, right, bottoms(number), tops(number), x_label, label)
         call append_text(body, 'set xrange ['//to_text(shown/along, digits)//':0]')
         call y_range(body, low, high)
         if (x_label == '') then
            call append_text(body, "set format x ''")
         else
            call append_text(body, "set format x '% h'")
         end if
         call plot(body, series)
      end subroutine draw_row
   end subroutine assembly_script
end module dg_assembly_picture

!> Picture of the lowest part of the string in its hole. Seen from the side: hole, body, blades and contact forces. Below:
!> bending moment and distance from the axis of the hole. Dimensions across the hole are enlarged.
module dg_assembly_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_chart, only: add_curve, add_key, add_label, add_panel, add_points, chart_type, new_chart, round_step
   use dg_readable, only: cut_text
   use dg_quantity, only: quantity_force, quantity_moment, quantity_width
   use dg_component, only: contact_diameter, has_blades, has_joints
   use dg_curve_look, only: colour_of, line_style
   use dg_drillstring, only: all_centralizer_ends, component_at, component_tops, drillstring_type, joint_ends
   use dg_hole_section, only: hole_section_at, hole_section_type
   use dg_job, only: job_type, model_name
   use dg_missing, only: is_missing
   use dg_model, only: is_straightened, model_type, string_index
   use dg_path_picture, only: case_title
   use dg_profile, only: profile_type
   use dg_text, only: either, to_text
   use dg_units, only: unit_system_type
   use dg_unit_kind, only: in_units, unit_label
   use dg_zero_crossing, only: add_zeros
   implicit none
   private
   public :: assembly_chart, shown_length

   !> Places of the three panels from the top down, in parts of the picture.
   real(wp), parameter :: places(4, 3) = reshape([0.085_wp, 0.985_wp, 0.50_wp, 0.86_wp, 0.085_wp, 0.985_wp, 0.295_wp, 0.475_wp, &
                                                  0.085_wp, 0.985_wp, 0.09_wp, 0.27_wp], [4, 3])
   !> Length of string that is drawn [m]: bit, motor and two or three stabilizers.
   real(wp), parameter :: shown_length = 40.0_wp
   !> Room above and below the hole, of its diameter [-]: for the forces.
   real(wp), parameter :: air = 0.45_wp
   !> Contacts with less than this part of the greatest force have no number [-].
   real(wp), parameter :: least_told = 0.02_wp
   !> Points at which the body is drawn between places where its diameter changes.
   integer, parameter :: many = 161
   character(*), parameter :: body_look = "with filledcurves closed fs solid border lc rgb '#333333' fc rgb '#b9c4cc'", &
                              blade_look = "with filledcurves closed fs solid border lc rgb '#333333' fc rgb '#56707f'"

   !> The part of hole and string that the picture shows.
   type :: view_type
      type(hole_section_type), allocatable :: holes(:)
      type(profile_type) :: profile
      real(wp) :: bit = 0.0_wp       !< measured depth of the bit [m]
      real(wp) :: shown = 0.0_wp     !< length of string that is drawn [m]
      real(wp) :: half = 0.0_wp      !< of the widest hole [m]
   end type view_type

contains

   !> `result` has a profile with the place of the string in the hole.
   function assembly_chart(job, model, result) result(chart)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(chart_type) :: chart
      type(view_type) :: view
      real(wp), allocatable :: md(:), moment(:)
      character(:), allocatable :: text
      associate (load_case => model%cases(result%case_index), units => job%units, profile => result%profile)
         text = '; without its bend, as it turns'
         if (.not. is_straightened(model, load_case)) text = bit_text(units, result)
         chart = new_chart('assembly_'//load_case%name, case_title(units, load_case)//', model '// &
                           trim(model_name(result%model))//text, units, 700, [places(4, 1) + 0.02_wp, 0.94_wp])
         view%holes = model%holes
         view%profile = profile
         view%bit = load_case%bit_depth
         view%shown = min(shown_length, view%bit - profile%md(1))
         call add_view(chart, view, model%strings(string_index(model%strings, load_case%string)), result)
         md = profile%md
         moment = profile%bending
         if (.not. any(is_missing(profile%shear))) call add_zeros(md, moment, profile%shear)
         call add_low_panel(chart, view, md, 'moment ['//unit_label(units, quantity_moment)//']', '', &
                            reshape(moment/units%moment, [size(md), 1]))
         call add_low_panel(chart, view, profile%md, 'offset ['//unit_label(units, quantity_width)//']', &
                            'distance above the bit ['//trim(units%length_label)//']', &
                            reshape([profile%displacement*cos(profile%clock), profile%displacement*sin(profile%clock)]/ &
                                    units%diameter, [size(profile%md), 2]))
         call add_key(chart, line_style(1), 'moment; offset to the high side')
         call add_key(chart, line_style(2), 'offset to the right')
      end associate
   end function assembly_chart

   !> Action of the bit, in words.
   pure function bit_text(units, result) result(text)
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(in) :: result
      character(:), allocatable :: text
      integer, parameter :: few = 3
      text = ''
      if (.not. is_missing(result%bit_side_force)) then
         text = text//'; bit presses '//in_units(units, quantity_force, result%bit_side_force, few)
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
   subroutine add_view(chart, view, string, result)
      type(chart_type), intent(inout) :: chart
      type(view_type), intent(inout) :: view
      type(drillstring_type), intent(in) :: string
      type(case_result_type), intent(in) :: result
      real(wp), parameter :: vertical = 1.0e-3_wp       ! a hole that has no high side [rad]
      character(*), parameter :: wall = "with lines lw 2.5 lc rgb '#8c6d46'"
      real(wp) :: x(many), axis(many)
      integer :: i
      x = view%shown*[(real(i, wp)/(many - 1), i=0, many - 1)]
      do i = 1, many
         axis(i) = 0.5_wp*view%holes(hole_section_at(view%holes, view%bit - x(i)))%diameter
      end do
      view%half = maxval(axis)
      associate (along => chart%units%length, across => chart%units%diameter)
         call add_panel(chart, places(:, 1), '', either('south to north', 'low to high side', result%inclination < vertical)// &
                        ' ['//unit_label(chart%units, quantity_width)//']')
         call add_string(chart, view, string)
         call add_curve(chart, x/along, axis/across, wall, 'wall of the hole')
         call add_curve(chart, x/along, -axis/across, wall, '')
         call add_curve(chart, [0.0_wp, view%shown]/along, [0.0_wp, 0.0_wp], "with lines lw 0.8 dt (12,4,2,4) lc rgb '#777777'", '')
         call add_key(chart, body_look, 'body')
         call add_key(chart, blade_look, 'blades, joints, centralizers')
         call add_key(chart, "with lines lw 2.5 lc rgb '"//colour_of(2)//"'", 'contact, force in '//trim(chart%units%force_label))
         call add_contacts(chart, view, result)
         associate (panel => chart%panels(1))
            panel%x%ends = [view%shown, 0.0_wp]/along
            panel%x%numbered = .false.
            panel%y%ends = [-1.0_wp, 1.0_wp]*view%half*(1.0_wp + 2.0_wp*air)/across
         end associate
      end associate
   end subroutine add_view

   !> The string from the bit up, with its names; what is bent is drawn bent.
   subroutine add_string(chart, view, string)
      type(chart_type), intent(inout) :: chart
      type(view_type), intent(in) :: view
      type(drillstring_type), intent(in) :: string
      real(wp), allocatable :: part_tops(:), joints(:), rings(:)
      real(wp) :: ends(2), free_from, touching
      integer :: i, k
      allocate (part_tops, source=component_tops(string, view%bit - view%profile%md(1)))
      free_from = 0.0_wp
      do k = 1, size(string%components)
         associate (part => string%components(k))
            ends = [0.0_wp, part_tops(k)]
            if (k > 1) ends(1) = part_tops(k - 1)
            if (ends(1) >= view%shown .or. ends(2) <= ends(1)) cycle
            touching = contact_diameter(part, view%bit - part_tops(k))
            call add_piece(chart, view, ends, part%od, body_look)
            if (has_blades(part) .or. (touching > part%od .and. .not. has_joints(part))) &
               call add_piece(chart, view, ends, touching, blade_look)
            call name_part(chart, view, part%name, [ends(1), min(ends(2), view%shown)], free_from)
         end associate
      end do
      allocate (joints, source=joint_ends(string, part_tops))
      allocate (rings, source=all_centralizer_ends(string, part_tops))
      do i = 1, size(rings) - 1, 2
         k = component_at(part_tops, 0.5_wp*(rings(i) + rings(i + 1)))
         call add_piece(chart, view, rings(i:i + 1), min(string%components(k)%centralizer%od, &
                        view%holes(hole_section_at(view%holes, view%bit - rings(i)))%diameter), blade_look)
      end do
      do i = 1, size(joints) - 1, 2
         k = component_at(part_tops, 0.5_wp*(joints(i) + joints(i + 1)))
         call add_piece(chart, view, joints(i:i + 1), string%components(k)%joint_od, blade_look)
      end do
   end subroutine add_string

   !> A piece of the string between two distances above the bit, as an outline that follows its axis.
   subroutine add_piece(chart, view, ends, diameter, look)
      type(chart_type), intent(inout) :: chart
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: ends(2), diameter    !< [m]
      character(*), intent(in) :: look
      integer, parameter :: most = 40
      real(wp) :: x(most), middle(most), length
      integer :: i, n
      if (ends(1) >= view%shown .or. ends(2) <= ends(1)) return
      length = min(ends(2), view%shown) - ends(1)
      n = max(2, min(most, 1 + ceiling(length/0.25_wp)))
      x(:n) = ends(1) + length*[(real(i, wp)/(n - 1), i=0, n - 1)]
      do i = 1, n
         middle(i) = offset_at(view%profile, view%bit - x(i))
      end do
      call add_curve(chart, [x(:n), x(n:1:-1)]/chart%units%length, &
                     [middle(:n) + 0.5_wp*diameter, middle(n:1:-1) - 0.5_wp*diameter]/chart%units%diameter, look, '')
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
   subroutine name_part(chart, view, name, ends, free_from)
      type(chart_type), intent(inout) :: chart
      type(view_type), intent(in) :: view
      character(*), intent(in) :: name
      real(wp), intent(in) :: ends(2)
      real(wp), intent(inout) :: free_from      !< distance above the bit from which on names below the hole have room [m]
      real(wp), parameter :: small_letter = 6.0_wp
      real(wp) :: letter, height_of_name, middle, half_name
      integer :: most
      letter = small_letter*view%shown/((places(2, 1) - places(1, 1))*chart%width)
      height_of_name = view%half*(1.0_wp + 1.65_wp*air)
      middle = 0.5_wp*sum(ends)
      most = int((ends(2) - ends(1))/letter)
      if (len(name) > most) then
         height_of_name = -height_of_name
         half_name = 0.5_wp*letter*len(name)
         most = len(name)
         if (middle + half_name < free_from .or. free_from + 2.0_wp*half_name > view%shown) return
         middle = max(min(middle, view%shown - half_name), free_from + half_name)
         free_from = middle + half_name + 2.0_wp*letter
      end if
      call add_label(chart, cut_text(name, most), [middle/chart%units%length, height_of_name/chart%units%diameter], &
                    "center font ',9' textcolor rgb '#333333'", [.false., .false.])
   end subroutine name_part

   !> Add arrows at the contact points, on the side of the wall. Their forces are beside them. Lesser ones are left out if they
   !> would cover another.
   subroutine add_contacts(chart, view, result)
      type(chart_type), intent(inout) :: chart
      type(view_type), intent(in) :: view
      type(case_result_type), intent(in) :: result
      real(wp), parameter :: number_width = 40.0_wp      ! with its distance to the arrow [px]
      real(wp) :: greatest, side, x, wide
      character(:), allocatable :: look
      logical :: hides
      integer :: i
      if (.not. allocated(result%contacts)) return
      wide = number_width*view%shown/((places(2, 1) - places(1, 1))*chart%width)
      greatest = maxval(result%contacts%force, mask=view%bit - result%contacts%md <= view%shown)
      do i = 1, size(result%contacts)
         associate (contact => result%contacts(i), along => chart%units%length, across => chart%units%diameter)
            x = max(view%bit - contact%md, 0.0_wp)/along
            if (view%bit - contact%md > view%shown .or. contact%force < least_told*greatest .or. .not. contact%force > 0.0_wp) cycle
            side = sign(view%half/across, cos(contact%clock))
            call add_points(chart, reshape([x, side*(1.0_wp + 1.1_wp*air), 0.0_wp, -side*1.1_wp*air], [4, 1]), &
                            "with vectors head filled size screen 0.008,20 lw 2.5 lc rgb '"//colour_of(2)//"'")
            hides = any(abs(result%contacts%md - contact%md) < wide .and. result%contacts%force > contact%force .and. &
                        cos(result%contacts%clock)*side > 0.0_wp)
            if (hides) cycle
            look = either('right offset -0.6,0', 'left offset 0.6,0', view%bit - contact%md < view%shown - wide)
            call add_label(chart, to_text(contact%force/chart%units%force, 3), [x, side*(1.0_wp + 0.7_wp*air)], &
                           look//" font ',10' textcolor rgb '"//colour_of(2)//"' front", [.false., .false.])
         end associate
      end do
   end subroutine add_contacts

   !> A low panel of curves along the string, as they are shown: all and 0 lie in it with some air, about four steps apart.
   subroutine add_low_panel(chart, view, md, label, x_label, values)
      type(chart_type), intent(inout) :: chart
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: md(:)             !< [m]
      character(*), intent(in) :: label, x_label
      real(wp), intent(in) :: values(:, :)      !< at each depth, a curve a column
      real(wp), parameter :: spare = 0.08_wp, steps = 4.0_wp
      integer, parameter :: digits = 8
      logical :: near(size(values, 1))
      real(wp) :: low, high
      integer :: k
      near = view%bit - md <= view%shown
      low = min(0.0_wp, minval(values, mask=spread(near, 2, size(values, 2))))
      high = max(0.0_wp, maxval(values, mask=spread(near, 2, size(values, 2))))
      call add_panel(chart, places(:, size(chart%panels) + 1), x_label, label)
      do k = 1, size(values, 2)
         call add_curve(chart, (view%bit - pack(md, near))/chart%units%length, pack(values(:, k), near), &
                        line_style(k), '')
      end do
      associate (panel => chart%panels(size(chart%panels)))
         panel%x%ends = [view%shown/chart%units%length, 0.0_wp]
         panel%x%numbered = x_label /= ''
         panel%y%ends = [-1.0_wp, 1.0_wp]
         panel%y%tics = '1'
         if (.not. high - low > tiny(low)) return
         panel%y%ends = [low, high] + spare*(high - low)*[-1.0_wp, 1.0_wp]
         panel%y%tics = to_text(round_step((high - low)/steps), digits)
      end associate
   end subroutine add_low_panel
end module dg_assembly_picture

!> Numbers of a deck that are legal and far from what is usual: mostly another unit, or something left out. Each has one note: what
!> is unusual, where, what is usual.
module dg_unusual_input
   use dg_kinds, only: wp
   use dg_component, only: component_type, has_joints, is_bit, is_pipe, opens
   use dg_constants, only: degree, pi
   use dg_contact_friction, only: axial_friction
   use dg_deck_draft, only: draft_hole_type, draft_type, lowest_of, string_use_type
   use dg_load_case, only: block_way, operation_name, operation_rotate_off_bottom, operation_static, rotates
   use dg_minimum_curvature, only: dogleg_between
   use dg_survey, only: tangent_of
   use dg_text, only: append_text, lower_case, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_curvature, unit_diameter, unit_force, unit_label, unit_length, unit_mass, unit_moment
   use dg_usual_range, only: note_range, usual_block, usual_density, usual_friction, usual_hookload, usual_joint_torsion, &
                             usual_makeup, usual_pump, usual_rpm, usual_tob, usual_top_drive, usual_trip_speed, usual_wob, &
                             usual_yield
   implicit none
   private
   public :: note_unusual, holes_in_inches, inches_meant

   !> Longest pipe that stands at a bit below collars [m].
   real(wp), parameter :: longest_bha_pipe = 100.0_wp
   !> Longest solid bar among drill tools [m].
   real(wp), parameter :: longest_bar = 5.0_wp
   !> Widest hole that is drilled, 36, as a number of inches that is read as one of millimetres [m].
   real(wp), parameter :: widest_of_inches = 36.5e-3_wp
   !> Deeper than any hole of a laboratory [m].
   real(wp), parameter :: deepest_model = 100.0_wp
   !> Advice on a deck with such holes.
   character(*), parameter :: inches_meant = "are these inches? Write units = 'metric' or 'field' in &job"
   !> Largest usual dogleg of a hole of 8 1/2 in [rad/m]. It goes with 1 over the cube of the diameter. Medium radius in 8 1/2 in:
   !> 16 to 20 deg/30 m, short radius in 6 in: 60.
   real(wp), parameter :: usual_dogleg = 24.0_wp*degree/30.0_wp, usual_hole = 0.2159_wp, least_dogleg = 20.0_wp*degree/30.0_wp
   !> Inclination that changes slowly by much between two stations, or falls by more than it does in planned wells: a mistyped
   !> angle, or a station left out [rad, rad/m].
   real(wp), parameter :: long_build = 30.0_wp*degree, slow_build = 1.0_wp*degree/30.0_wp, long_drop = 60.0_wp*degree
   !> Angle to both neighbours from which a station that points another way is a slip [rad].
   real(wp), parameter :: spike = 25.0_wp*degree
   !> Inclinations of a survey in radians: the largest is near pi/2, or smaller than 1.6 deg while the survey builds and holds.
   real(wp), parameter :: largest_radian = 1.6_wp*degree, least_radian = 0.5_wp*degree, near_right_angle = 0.005_wp*degree
   !> A string that is longer than the hole by more than this [m].
   real(wp), parameter :: above_surface = 1.0_wp
   integer, parameter :: few_digits = 3, digits = 4, depth_digits = 6

contains

   !> Adds a note for each matter.
   subroutine note_unusual(draft, uses, fitted, notes)
      type(draft_type), intent(in) :: draft
      type(string_use_type), intent(in) :: uses(:)     !< of strings, beside those of load cases
      logical, intent(in) :: fitted       !< a study of the deck finds the friction
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, k, before
      call note_inclinations(draft, notes)
      before = size(notes)
      call note_doglegs(draft, notes)
      if (size(notes) == before) call note_steps(draft, notes)
      if (size(draft%fluids) == 0) call append_text(notes, 'There is no &fluid: the string is weighed in air. Mud takes '// &
                                                    'about 15 % off its weight')
      do i = 1, size(draft%fluids)
         associate (fluid => draft%fluids(i)%fluid)
            call note_range(draft%units, 'group &fluid', usual_density, fluid%density, notes)
            if (fluid%md_top >= draft%stations%md(size(draft%stations%md))) call append_text(notes, 'group &fluid: md_top = '// &
               in_units(draft%units, unit_length, fluid%md_top, depth_digits)//' is below the hole, so that this fluid '// &
               'is nowhere. Give the depth where it begins')
         end associate
      end do
      if (.not. fitted) call note_friction(draft, notes)
      do i = 1, size(draft%holes)
         call note_hole_friction(draft, draft%holes(i), notes)
      end do
      do i = 1, size(uses)
         do k = 1, size(uses(i)%wob)
            call note_range(draft%units, 'group &'//uses(i)%group, usual_wob, uses(i)%wob(k), notes)
         end do
         do k = 1, size(uses(i)%tob)
            call note_range(draft%units, 'group &'//uses(i)%group, usual_tob, uses(i)%tob(k), notes)
         end do
      end do
      do i = 1, size(draft%components)
         call note_component(i)
      end do
      call note_order(draft, notes)
      call note_length(draft, notes)
      call note_range(draft%units, 'group &rig', usual_block, draft%rig%block_weight, notes)
      if (draft%rig%max_hookload%present) call note_range(draft%units, 'group &rig', usual_hookload, draft%rig%max_hookload%value, &
                                                          notes)
      if (draft%rig%max_torque%present) &
         call note_range(draft%units, 'group &rig', usual_top_drive, draft%rig%max_torque%value, notes)
      do i = 1, size(draft%cases)
         associate (load_case => draft%cases(i)%load_case, what => trim(draft%cases(i)%what)//' ')
            call note_range(draft%units, what//quoted(load_case%name), usual_wob, load_case%wob, notes)
            call note_range(draft%units, what//quoted(load_case%name), usual_tob, load_case%tob, notes)
            if (load_case%angular_speed > 0.0_wp) &
               call note_range(draft%units, what//quoted(load_case%name), usual_rpm, load_case%angular_speed, notes)
            call note_range(draft%units, what//quoted(load_case%name), usual_trip_speed, load_case%trip_speed, notes)
            if (load_case%wob > 0.0_wp .and. (block_way(load_case%operation) > 0 .or. &
                                              load_case%operation == operation_rotate_off_bottom)) &
               call append_text(notes, what//quoted(load_case%name)//': wob = '// &
               in_units(draft%units, unit_force, load_case%wob, digits)//' pushes the bit in '// &
               trim(operation_name(load_case%operation))//'. An overpull is a wob below 0')
            if (load_case%pump_pressure > 0.0_wp) &
               call note_range(draft%units, what//quoted(load_case%name), usual_pump, load_case%pump_pressure, notes)
         end associate
      end do

   contains

      !> Yield strength, and a bar where a pipe was meant.
      subroutine note_component(number)
         integer, intent(in) :: number
         associate (item => draft%components(number), part => draft%components(number)%component, units => draft%units)
            if (part%yield > 0.0_wp) &
               call note_range(draft%units, part_text(number), usual_yield, part%yield, notes)
            call note_range(units, part_text(number), usual_makeup, part%makeup_torque, notes)
            call note_range(units, part_text(number), usual_joint_torsion, part%joint_torsion, notes)
            if (part%joint_torsion > 0.0_wp .and. part%makeup_torque > part%joint_torsion) call append_text(notes, &
               part_text(number)//': makeup_torque is above joint_torsion, '// &
               in_units(units, unit_moment, part%joint_torsion, digits)//': its joints would yield in make-up')
            if (part%id > 0.0_wp .or. item%mass_given .or. (part%length > 0.0_wp .and. part%length <= longest_bar)) return
            if (index(lower_case(part%kind), 'rod') > 0) return
            call append_text(notes, part_text(number)//' is a solid bar of '// &
                             in_units(units, unit_mass, part%mass, digits)// &
                             ', as it has no id and no mass. Give the inside diameter')
         end associate
      end subroutine note_component

      function part_text(number) result(text)
         integer, intent(in) :: number
         character(:), allocatable :: text
         text = 'group &component in line '//to_text(draft%components(number)%line)//': '// &
                quoted(draft%components(number)%component%name)
      end function part_text
   end subroutine note_unusual

   !> True if all hole diameters in millimetres are too small for a well, and the hole is deeper than a laboratory model.
   pure function holes_in_inches(draft) result(inches)
      type(draft_type), intent(in) :: draft
      logical :: inches
      inches = .false.
      if (size(draft%holes) == 0 .or. unit_label(draft%units, unit_diameter) /= 'mm') return
      if (.not. (draft%has_stations .and. all(draft%holes%sound))) return
      inches = all(draft%holes%section%diameter < widest_of_inches) .and. &
               draft%stations%md(size(draft%stations%md)) > deepest_model
   end function holes_in_inches

   !> Inclinations that look like radians.
   subroutine note_inclinations(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: largest
      logical :: builds, one_way
      associate (inclination => draft%stations%inclination, azimuth => draft%stations%azimuth)
         largest = maxval(inclination)
         if (largest > largest_radian .or. largest < least_radian) return
         builds = all(inclination(2:) >= inclination(:size(inclination) - 1))
         one_way = maxval(azimuth, mask=inclination > 0.0_wp) - minval(azimuth, mask=inclination > 0.0_wp) < least_radian
         if (.not. (abs(largest - 0.5_wp*pi*degree) < near_right_angle .or. (builds .and. one_way))) return
         call append_text(notes, 'group &trajectory: the largest inclination is '//to_text(largest/degree, digits)// &
                          ' deg. Are the inclinations in radians? They are read as degrees')
      end associate
   end subroutine note_inclinations

   !> The sharpest dogleg, where it is sharp for its hole, and stations that point another way than both neighbours.
   subroutine note_doglegs(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: angles(size(draft%stations%md)), dogleg, worst, limit, usual_here
      integer :: i, place
      associate (stations => draft%stations, units => draft%units)
         angles(1) = 0.0_wp
         worst = 1.0_wp
         place = 0
         do i = 2, size(stations%md)
            angles(i) = between(i - 1, i)
            dogleg = angles(i)/(stations%md(i) - stations%md(i - 1))
            limit = max(least_dogleg, usual_dogleg*(usual_hole/diameter_at(stations%md(i)))**3)
            if (dogleg <= worst*limit) cycle
            worst = dogleg/limit
            usual_here = limit
            place = i
         end do
         if (place > 0) call append_text(notes, 'group &trajectory: the dogleg is '// &
            in_units(units, unit_curvature, worst*usual_here, digits)//' at '// &
            in_units(units, unit_length, stations%md(place), depth_digits)//'. Usual in a hole of '// &
            in_units(units, unit_diameter, diameter_at(stations%md(place)), digits)//' is at most '// &
            to_text(usual_here/units%curvature, few_digits)// &
            '. Check depths, angles and their units')
         place = 0
         worst = 0.5_wp
         do i = 2, size(stations%md) - 1
            if (min(angles(i), angles(i + 1)) <= spike) cycle
            dogleg = between(i - 1, i + 1)/min(angles(i), angles(i + 1))
            if (dogleg >= worst) cycle
            worst = dogleg
            place = i
         end do
         if (place > 0) call append_text(notes, 'group &trajectory: inclination goes from '//degrees(place - 1)//' to '// &
            degrees(place)//' and back to '//degrees(place + 1)//' deg at '// &
            in_units(units, unit_length, stations%md(place), depth_digits)//'. Is that station mistyped?')
      end associate
   contains
      !> Angle between the directions of two stations [rad].
      function between(one, other) result(angle)
         integer, intent(in) :: one, other
         real(wp) :: angle
         associate (stations => draft%stations)
            angle = dogleg_between(tangent_of(stations%inclination(one), stations%azimuth(one)), &
                                   tangent_of(stations%inclination(other), stations%azimuth(other)))
         end associate
      end function between

      !> Diameter of the hole at a depth [m].
      pure function diameter_at(md) result(diameter)
         real(wp), intent(in) :: md      !< [m]
         real(wp) :: diameter
         integer :: k
         do k = size(draft%holes), 2, -1
            if (draft%holes(k)%section%md_top < md) exit
         end do
         diameter = draft%holes(k)%section%diameter
      end function diameter_at

      function degrees(station) result(text)
         integer, intent(in) :: station
         character(:), allocatable :: text
         text = to_text(draft%stations%inclination(station)/degree, digits)
      end function degrees
   end subroutine note_doglegs

   !> The largest change of inclination between two stations that is hardly meant.
   subroutine note_steps(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: step, length, worst
      integer :: i, place
      place = 0
      worst = long_build
      associate (stations => draft%stations, units => draft%units)
         do i = 2, size(stations%md)
            step = stations%inclination(i) - stations%inclination(i - 1)
            if (abs(step) <= worst .or. &
                (abs(step) >= slow_build*(stations%md(i) - stations%md(i - 1)) .and. step > -long_drop)) cycle
            worst = abs(step)
            place = i
         end do
         if (place == 0) return
         length = stations%md(place) - stations%md(place - 1)
         call append_text(notes, 'group &trajectory: inclination goes from '// &
            to_text(stations%inclination(place - 1)/degree, digits)//' to '// &
            to_text(stations%inclination(place)/degree, digits)//' deg over '// &
            in_units(units, unit_length, length, digits)//' without a station between, down to '// &
            in_units(units, unit_length, stations%md(place), depth_digits)//'. Is one of them mistyped or missing?')
      end associate
   end subroutine note_steps

   !> Hole sections without any friction that a moving case relies on.
   subroutine note_friction(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, k
      do k = 1, size(draft%cases)
         if (draft%cases(k)%load_case%operation == operation_static .or. &
             draft%cases(k)%load_case%friction_axial%present) cycle
         do i = 1, size(draft%holes)
            associate (hole => draft%holes(i))
               if (hole%friction_given .or. axial_friction(hole%section, draft%cases(k)%load_case%operation) > 0.0_wp .or. &
                   hole%section%md_top >= draft%cases(k)%load_case%bit_depth) cycle
               call append_text(notes, 'group &hole in line '//to_text(hole%line)//': '//quoted(hole%section%name)// &
                                ' has no friction. Drag and torque there are zero. Give friction')
            end associate
         end do
         return
      end do
   end subroutine note_friction

   !> Friction that is far from what was measured anywhere, and a section that lets a string turn without any.
   subroutine note_hole_friction(draft, hole, notes)
      type(draft_type), intent(in) :: draft
      type(draft_hole_type), intent(in) :: hole
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: what
      what = 'group &hole in line '//to_text(hole%line)//': '//quoted(hole%section%name)
      associate (axial => hole%section%friction_axial, rotary => hole%section%friction_rotary)
         if (axial > 0.0_wp) call note_range(draft%units, what, usual_friction, axial, notes)
         if (rotary > 0.0_wp .and. abs(rotary - axial) > 0.0_wp) call note_range(draft%units, what, usual_friction, rotary, notes)
         if (axial > 0.0_wp .and. .not. rotary > 0.0_wp .and. any(rotates(draft%cases%load_case%operation))) &
            call append_text(notes, what//' has no friction_rotary, so that torque there is zero. Give it, or friction for both')
      end associate
   end subroutine note_hole_friction

   !> A bit above other components of its string, or drill pipe at the bit below collars: the string is listed from the top.
   subroutine note_order(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components))
      integer :: i, k
      lowest = lowest_of(draft)
      do i = 2, size(draft%components)
         associate (item => draft%components(i))
            if (.not. is_bit(item%component) .or. opens(item%component) .or. lowest(i) == i) cycle
            call append_text(notes, 'group &component in line '//to_text(item%line)//': bit '//quoted(item%component%name)// &
                             ' stands above '//quoted(draft%components(lowest(i))%component%name)// &
                             '. List components from the bit upwards')
         end associate
      end do
      do i = 1, size(draft%components)
         if (.not. is_long_pipe(draft%components(i)%component)) cycle
         if (any(lowest(:i - 1) == lowest(i) .and. .not. is_bit(draft%components(:i - 1)%component))) cycle
         do k = i + 1, size(draft%components)
            if (lowest(k) /= lowest(i) .or. index(lower_case(draft%components(k)%component%kind), 'collar') == 0) cycle
            call append_text(notes, 'group &component in line '//to_text(draft%components(i)%line)//': drill pipe '// &
                             quoted(draft%components(i)%component%name)//' stands at the bit, collars '// &
                             quoted(draft%components(k)%component%name)//' above it. List components from the bit upwards')
            exit
         end do
      end do

   contains

      elemental function is_long_pipe(part) result(is)
         type(component_type), intent(in) :: part
         logical :: is
         is = has_joints(part) .and. is_pipe(part) .and. part%length > longest_bha_pipe
      end function is_long_pipe
   end subroutine note_order

   !> A string longer than the hole, whose last component has a length.
   subroutine note_length(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components))
      real(wp) :: length, depth
      integer :: i
      depth = draft%stations%md(size(draft%stations%md))
      lowest = lowest_of(draft)
      do i = 1, size(draft%components)
         if (any(lowest(i + 1:) == lowest(i)) .or. .not. draft%components(i)%component%length > 0.0_wp) cycle
         length = sum(draft%components%component%length, mask=lowest == lowest(i))
         if (length <= depth + above_surface) cycle
         call append_text(notes, 'String '//quoted(draft%components(i)%string)//' is '// &
                          in_units(draft%units, unit_length, length, depth_digits)//' long, the hole ends at '// &
                          in_units(draft%units, unit_length, depth, depth_digits)// &
                          '. What stands above surface is left out. Leave out the length of the last component')
      end do
   end subroutine note_length
end module dg_unusual_input

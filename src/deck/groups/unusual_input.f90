!> Numbers of a deck that are legal and far from what is usual: mostly another unit, or something left out. Each has one note: what
!> is unusual, where, what is usual.
module dg_unusual_input
   use dg_kinds, only: wp
   use dg_component, only: is_bit, opens
   use dg_constants, only: degree, pi
   use dg_contact_friction, only: axial_friction
   use dg_deck_draft, only: draft_type, lowest_of
   use dg_load_case, only: operation_static
   use dg_minimum_curvature, only: dogleg_between
   use dg_survey, only: tangent_of
   use dg_text, only: append_text, lower_case, quoted, text_type, to_text
   use dg_unit_kind, only: heaviest_mud, in_units, unit_curvature, unit_diameter, unit_force, unit_label, unit_length, unit_mass, &
                           unit_moment, unit_pressure, unit_stress
   implicit none
   private
   public :: note_unusual, holes_in_inches, inches_meant

   !> Usual range of a key.
   type :: usual_type
      character(13) :: key
      integer :: unit
      real(wp) :: low, high        !< [SI]
      character(72) :: source
   end type usual_type

   integer, parameter :: usual_yield = 1, usual_wob = 2, usual_tob = 3, usual_density = 4, usual_pump = 5, &
                         usual_block = 6, usual_top_drive = 7
   type(usual_type), parameter :: usual(7) = [ &
      usual_type('yield', unit_stress, 150.0e6_wp, 1250.0e6_wp, 'API 5CT H40 to proprietary 180 ksi; aluminium pipe 325 MPa'), &
      usual_type('wob', unit_force, -3.0e6_wp, 700.0e3_wp, 'heavy rock bits of 26 in, 150 klbf; overpull of large rigs'), &
      usual_type('tob', unit_moment, 0.0_wp, 100.0e3_wp, 'reamers in soft rock; strongest top drives 130 kN.m'), &
      usual_type('density', 0, 0.0_wp, heaviest_mud, 'heaviest kill mud 22.5 lbm/gal'), &
      usual_type('pump_pressure', unit_pressure, 0.35e6_wp, 105.0e6_wp, &
                 'stimulation pumps 15,000 psi; less than 50 psi was meant as ksi'), &
      usual_type('block_weight', unit_force, 0.0_wp, 1.5e6_wp, 'block, compensator and top drive of 1,250 t rigs: 120 t'), &
      usual_type('max_torque', unit_moment, 0.0_wp, 200.0e3_wp, 'strongest top drives 130 kN.m')]

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
   subroutine note_unusual(draft, fitted, notes)
      type(draft_type), intent(in) :: draft
      logical, intent(in) :: fitted       !< a study of the deck finds the friction
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, before
      call note_inclinations(draft, notes)
      before = size(notes)
      call note_doglegs(draft, notes)
      if (size(notes) == before) call note_steps(draft, notes)
      if (size(draft%fluids) == 0) call append_text(notes, 'There is no &fluid: the string is weighed in air. Mud takes '// &
                                                    'about 15 % off its weight')
      do i = 1, size(draft%fluids)
         call note_range('group &fluid', usual_density, draft%fluids(i)%fluid%density)
      end do
      if (.not. fitted) call note_friction(draft, notes)
      do i = 1, size(draft%components)
         call note_component(i)
      end do
      call note_order(draft, notes)
      call note_length(draft, notes)
      call note_range('group &rig', usual_block, draft%rig%block_weight)
      if (draft%rig%max_torque%present) call note_range('group &rig', usual_top_drive, draft%rig%max_torque%value)
      do i = 1, size(draft%cases)
         associate (load_case => draft%cases(i)%load_case, what => trim(draft%cases(i)%what)//' ')
            call note_range(what//quoted(load_case%name), usual_wob, load_case%wob)
            call note_range(what//quoted(load_case%name), usual_tob, load_case%tob)
            if (load_case%pump_pressure > 0.0_wp) &
               call note_range(what//quoted(load_case%name), usual_pump, load_case%pump_pressure)
         end associate
      end do

   contains

      !> Yield strength, and a bar where a pipe was meant.
      subroutine note_component(number)
         integer, intent(in) :: number
         associate (item => draft%components(number), part => draft%components(number)%component, units => draft%units)
            if (part%yield > 0.0_wp) &
               call note_range('group &component in line '//to_text(item%line)//': '//quoted(part%name), usual_yield, part%yield)
            if (part%id > 0.0_wp .or. item%mass_given .or. (part%length > 0.0_wp .and. part%length <= longest_bar)) return
            if (index(lower_case(part%kind), 'rod') > 0) return
            call append_text(notes, 'group &component in line '//to_text(item%line)//': '//quoted(part%name)// &
                             ' is a solid bar of '//trim(in_units(units, unit_mass, part%mass, digits))// &
                             ', as it has no id and no mass. Give the inside diameter')
         end associate
      end subroutine note_component

      !> A value out of its usual range.
      subroutine note_range(what, number, value)
         character(*), intent(in) :: what
         integer, intent(in) :: number       !< of the range
         real(wp), intent(in) :: value       !< [SI]
         character(:), allocatable :: range
         associate (low => usual(number)%low, high => usual(number)%high)
            if (value >= low .and. value <= high) return
            range = 'at least '//value_text(number, low)
            if (value > high) range = 'at most '//value_text(number, high)
         end associate
         call append_text(notes, what//': '//trim(usual(number)%key)//' = '//value_text(number, value)//' is unusual. Usual is '// &
                          range//'. Check the unit')
      end subroutine note_range

      !> A value in the units of the deck, with its unit where the range has one.
      function value_text(number, value) result(text)
         integer, intent(in) :: number       !< of the range
         real(wp), intent(in) :: value       !< [SI]
         character(:), allocatable :: text
         text = to_text(value/draft%units%density, digits)
         if (number /= usual_density) text = trim(in_units(draft%units, usual(number)%unit, value, digits))
      end function value_text
   end subroutine note_unusual

   !> True if all hole diameters in millimetres are too small for a well, and the hole is deeper than a laboratory model.
   pure function holes_in_inches(draft) result(inches)
      type(draft_type), intent(in) :: draft
      logical :: inches
      inches = .false.
      if (size(draft%holes) == 0 .or. trim(unit_label(draft%units, unit_diameter)) /= 'mm') return
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
            trim(in_units(units, unit_curvature, worst*usual_here, digits))//' at '// &
            trim(in_units(units, unit_length, stations%md(place), depth_digits))//'. Usual in a hole of '// &
            trim(in_units(units, unit_diameter, diameter_at(stations%md(place)), digits))//' is at most '// &
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
            trim(in_units(units, unit_length, stations%md(place), depth_digits))//'. Is that station mistyped?')
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
            trim(in_units(units, unit_length, length, digits))//' without a station between, down to '// &
            trim(in_units(units, unit_length, stations%md(place), depth_digits))//'. Is one of them mistyped or missing?')
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

   !> A bit above other components of its string: the string is listed from the top.
   subroutine note_order(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components))
      integer :: i
      lowest = lowest_of(draft)
      do i = 2, size(draft%components)
         associate (item => draft%components(i))
            if (.not. is_bit(item%component) .or. opens(item%component) .or. lowest(i) == i) cycle
            call append_text(notes, 'group &component in line '//to_text(item%line)//': bit '//quoted(item%component%name)// &
                             ' stands above '//quoted(draft%components(lowest(i))%component%name)// &
                             '. List components from the bit upwards')
         end associate
      end do
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
                          trim(in_units(draft%units, unit_length, length, depth_digits))//' long, the hole ends at '// &
                          trim(in_units(draft%units, unit_length, depth, depth_digits))// &
                          '. What stands above surface is left out. Leave out the length of the last component')
      end do
   end subroutine note_length
end module dg_unusual_input

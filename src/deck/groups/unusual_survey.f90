!> Notes on legal but unusual surveys: angles in radians, columns swapped, mistyped stations. Each has one note.
module dg_unusual_survey
   use dg_kinds, only: wp
   use dg_constants, only: degree, foot, pi
   use dg_deck_draft, only: diameter_at, draft_type
   use dg_merge_sort, only: sorted_places
   use dg_minimum_curvature, only: dogleg_between
   use dg_survey, only: tangent_of, turn_between
   use dg_survey_file, only: station_list_type
   use dg_text, only: append_text, either, text_type, to_text
   use dg_unit_kind, only: at_most, in_units, unit_curvature, unit_diameter, unit_length
   implicit none
   private
   public :: note_survey

   !> Largest usual dogleg of a hole of 8 1/2 in [rad/m]. It goes with 1 over the cube of the diameter. Medium radius in 8 1/2 in:
   !> 16 to 20 deg/30 m, short radius in 6 in: 60.
   real(wp), parameter :: usual_dogleg = 24.0_wp*degree/30.0_wp, usual_hole = 0.2159_wp, least_dogleg = 20.0_wp*degree/30.0_wp
   !> Inclination that changes slowly by much between two stations, or falls by more than in planned wells [rad, rad/m]. It is
   !> a mistyped angle, or a missing station.
   real(wp), parameter :: long_build = 30.0_wp*degree, slow_build = 0.6_wp*degree/30.0_wp, long_drop = 60.0_wp*degree
   !> Least number of stations of a measured hole. An interval that lacks stations is longer than so many median ones, and turns
   !> by more than an angle [rad].
   integer, parameter :: least_surveyed = 20
   real(wp), parameter :: long_gap = 10.0_wp, least_over_gap = 15.0_wp*degree
   !> Angle to both neighbours from which a station that points another way is a slip [rad].
   real(wp), parameter :: spike = 25.0_wp*degree
   !> The same between close stations, with both doglegs above a rate: 54 for 45. Motors and rotary steerables do not turn back
   !> from one station to the next by as much [rad, rad/m].
   real(wp), parameter :: close_spike = 3.0_wp*degree, spike_rate = 5.0_wp*degree/30.0_wp
   !> Inclinations of a survey in radians: the largest is near pi/2, or smaller than 1.6 deg while the survey builds and holds.
   real(wp), parameter :: largest_radian = 1.6_wp*degree, least_radian = 0.5_wp*degree, near_right_angle = 0.005_wp*degree
   !> Largest inclination of a survey with few inclined stations that may be in radians: a plumb hole has one of half a degree.
   real(wp), parameter :: least_of_few = 1.3_wp*degree
   integer, parameter :: few = 3
   !> Largest inclination of a survey in radians, read as degrees, where its azimuths are below 2 pi, too [rad].
   real(wp), parameter :: largest_of_both = 1.8_wp*degree
   !> Azimuths in radians of stations inclined by more than this turn one way by more than that [rad]: by 11 deg, read as 0.2 deg.
   !> Numbers with one decimal are degrees, as people write them.
   real(wp), parameter :: azimuth_told = 5.0_wp*degree, least_turn = 0.2_wp*degree, one_decimal = 0.1_wp*degree, &
                          round_off = 1.0e-6_wp*degree
   !> Numbers of two decimals, those of radians with three, and 5 deg in radians [-].
   real(wp), parameter :: two_decimals = 0.01_wp, three_decimals = 0.6e-3_wp, five = 5.0_wp*degree
   !> Azimuths that differ by less are alike [rad].
   real(wp), parameter :: alike = 0.01_wp*degree
   !> Azimuth that turns by more between two stations, both of which are inclined by more: a mistyped azimuth [rad].
   real(wp), parameter :: long_turn = 100.0_wp*degree, inclined = 10.0_wp*degree
   !> Thresholds of swapped columns [m, rad]. The hole is inclined at surface by more than `slant`. It keeps its inclination
   !> within `kept` until half of the turn, or begins with more than a slant rig drills. Its azimuth begins at zero, stays below
   !> `lying` and changes by more than `bent`, like an inclination.
   real(wp), parameter :: surface = 10.0_wp, slant = 5.0_wp*degree, kept = 5.0_wp*degree, steepest_rig = 50.0_wp*degree
   real(wp), parameter :: zero = 0.5_wp*degree, lying = 120.0_wp*degree, bent = 15.0_wp*degree
   !> A hole that is level at surface goes down by more than this [rad]. Holes from a mine stay nearly level, crossings begin
   !> below 85 deg.
   real(wp), parameter :: plunge = 30.0_wp*degree
   integer, parameter :: few_digits = 3, digits = 4, depth_digits = 6

contains

   !> Adds a note for each matter of the survey.
   subroutine note_survey(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: before
      call note_inclinations(draft, notes)
      before = size(notes)
      call note_azimuths(draft, notes)
      call note_swapped(draft, notes)
      call note_level(draft, notes)
      call note_doglegs(draft, notes)
      call note_spikes(draft, notes)
      if (size(notes) == before) call note_gap(draft, notes)
      if (size(notes) == before) call note_steps(draft, notes)
      if (size(notes) == before) call note_turns(draft, notes)
   end subroutine note_survey

   !> Inclinations that look like radians.
   subroutine note_inclinations(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: largest
      logical :: builds, one_way
      associate (inclination => draft%plan%inclination, azimuth => draft%plan%azimuth)
         largest = maxval(inclination)
         if (largest > largest_of_both .or. largest < least_radian) return
         if (.not. azimuths_in_radians(pack(azimuth, inclination > 0.0_wp))) then
            if (largest > largest_radian .or. (largest < least_of_few .and. count(inclination > 0.0_wp) < few .and. &
                .not. all(are_converted(pack(inclination, inclination > 0.0_wp))))) return
            builds = all(inclination(2:) >= inclination(:size(inclination) - 1))
            one_way = maxval(azimuth, mask=inclination > 0.0_wp) - minval(azimuth, mask=inclination > 0.0_wp) < least_radian
            one_way = one_way .and. (all(modulo(azimuth, 2.0_wp*pi) <= 2.0_wp*pi*degree) .or. &
                                     all(are_converted(pack(inclination, inclination > 0.0_wp))))
            if (.not. (abs(largest - 0.5_wp*pi*degree) < near_right_angle .or. (builds .and. one_way))) return
         end if
         call append_text(notes, 'group &trajectory: the largest inclination is '//to_text(largest/degree, digits)// &
                          ' deg. Are the inclinations in radians? They are read as degrees')
      end associate
   end subroutine note_inclinations

   !> True for an inclination that is a multiple of 5 deg in radians with three decimals at least: 1.047 for 60.
   elemental function are_converted(inclination) result(are)
      real(wp), intent(in) :: inclination     !< as read [rad]
      logical :: are
      associate (number => inclination/degree)
         are = abs(number - two_decimals*anint(number/two_decimals)) > round_off .and. &
               abs(number - five*anint(number/five)) < three_decimals
      end associate
   end function are_converted

   !> Azimuths that look like radians while inclinations do not: within a full turn they grow or fall from station to station. Those
   !> of a hole to the north in degrees go up and down, or stay.
   subroutine note_azimuths(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp), allocatable :: azimuth(:)
      integer :: n
      associate (inclination => draft%plan%inclination)
         if (maxval(inclination) <= 2.0_wp*pi*degree) return
         azimuth = pack(modulo(draft%plan%azimuth, 2.0_wp*pi), inclination > azimuth_told)
         n = size(azimuth)
         if (n < few .or. maxval(azimuth) > 2.0_wp*pi*degree .or. abs(azimuth(n) - azimuth(1)) < least_turn) return
         if (any((azimuth(2:) - azimuth(:n - 1))*(azimuth(n) - azimuth(1)) < 0.0_wp)) return
         if (all(abs(azimuth - one_decimal*anint(azimuth/one_decimal)) < round_off)) return
         call append_text(notes, 'group &trajectory: azimuth goes from '//to_text(azimuth(1)/degree, digits)//' to '// &
                          to_text(azimuth(n)/degree, digits)//' deg. Is it in radians? It is read as degrees. In a file write '// &
                          'its unit into the heading: Azi (rad)')
      end associate
   end subroutine note_azimuths

   !> True if azimuths read as degrees change and look like radians: all from 0 to 2 pi, or all from -pi to pi. Those of a hole that
   !> is nearly vertical and was measured go all around.
   pure function azimuths_in_radians(azimuth) result(are)
      real(wp), intent(in) :: azimuth(:)      !< of stations that are inclined [rad]
      logical :: are
      real(wp) :: around(size(azimuth)), signed(size(azimuth))
      around = modulo(azimuth, 2.0_wp*pi)
      signed = turn_between(azimuth, 0.0_wp)
      are = .false.
      if (size(azimuth) < 2) return
      if (maxval(signed) - minval(signed) < alike) return
      are = all(around <= 2.0_wp*pi*degree) .or. all(abs(signed) <= pi*degree)
   end function azimuths_in_radians

   !> Inclination in the place of azimuth, and the other way round.
   subroutine note_swapped(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: azimuth(size(draft%plan%md))
      integer :: half
      azimuth = modulo(draft%plan%azimuth, 2.0_wp*pi)
      half = findloc(azimuth >= 0.5_wp*maxval(azimuth), .true., dim=1)
      associate (inclination => draft%plan%inclination)
         if (draft%plan%md(1) > surface .or. azimuth(1) > zero) return
         if (.not. maxval(inclination) > 0.0_wp .and. maxval(azimuth) > bent .and. maxval(azimuth) < lying) &
            call append_text(notes, 'group &trajectory: all inclinations are 0, and the azimuth goes from 0 to '// &
                             to_text(maxval(azimuth)/degree, digits)//' deg. Are inc and azi swapped?')
         if (minval(inclination) < slant) return
         if (maxval(inclination(:half)) - minval(inclination(:half)) > kept .and. inclination(1) < steepest_rig) return
         if (maxval(azimuth) > lying .or. maxval(azimuth) < bent) return
         call append_text(notes, 'group &trajectory: the hole is inclined by '//to_text(inclination(1)/degree, digits)// &
                          ' deg from surface on, and its azimuth goes from 0 to '//to_text(maxval(azimuth)/degree, digits)// &
                          ' deg. Are inc and azi swapped?')
      end associate
   end subroutine note_swapped

   !> Inclination from the horizontal: the hole is level at surface and goes down deeper.
   subroutine note_level(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp), parameter :: level = 0.5_wp*pi
      associate (inclination => draft%plan%inclination)
         if (draft%plan%md(1) > surface .or. abs(inclination(1) - level) > zero) return
         if (maxval(inclination) > level + zero .or. minval(inclination) > level - plunge) return
         call append_text(notes, 'group &trajectory: the hole is level at surface, inc = '// &
                          to_text(inclination(1)/degree, digits)//' deg, and goes down deeper, inc = '// &
                          to_text(minval(inclination)/degree, digits)//' deg. Is inc counted from the horizontal? '// &
                          'Then write 90 - inc')
      end associate
   end subroutine note_level

   !> The sharpest dogleg, where it is sharp for its hole.
   subroutine note_doglegs(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: dogleg, worst, limit, usual_here
      integer :: i, place
      associate (stations => draft%stations, units => draft%units)
         worst = 1.0_wp
         place = 0
         do i = 2, size(stations%md)
            dogleg = angle_between(stations, i - 1, i)/(stations%md(i) - stations%md(i - 1))
            limit = max(least_dogleg, usual_dogleg*(usual_hole/diameter_at(draft, stations%md(i)))**3)
            if (dogleg <= worst*limit) cycle
            worst = dogleg/limit
            usual_here = limit
            place = i
         end do
         if (place > 0) call append_text(notes, either('group &tortuosity', 'group &trajectory', draft%tortuous)// &
            ': the dogleg is '// &
            in_units(units, unit_curvature, worst*usual_here, digits)//' at '// &
            in_units(units, unit_length, stations%md(place), depth_digits)//'. Usual in a hole of '// &
            in_units(units, unit_diameter, diameter_at(draft, stations%md(place)), digits)//' is at most '// &
            in_units(units, unit_curvature, at_most(units, unit_curvature, usual_here, few_digits), few_digits)// &
            either('. Check amplitude and period', '. Check depths, angles and their units', draft%tortuous)// &
            either(': are depths in m? 1 m is '//to_text(1.0_wp/foot, digits)//' ft', '', &
                   abs(units%length - foot) < spacing(foot) .and. worst*foot <= 1.0_wp))
      end associate
   end subroutine note_doglegs

   !> The station that points most another way than both neighbours.
   subroutine note_spikes(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: angles(size(draft%plan%md)), share, least
      logical :: turns
      integer :: i, place
      associate (stations => draft%plan)
         angles(1) = 0.0_wp
         do i = 2, size(angles)
            angles(i) = angle_between(stations, i - 1, i)
         end do
         place = 0
         least = 0.5_wp
         do i = 2, size(stations%md) - 1
            if (min(angles(i), angles(i + 1)) <= merge(close_spike, spike, &
               angles(i) > spike_rate*(stations%md(i) - stations%md(i - 1)) .and. &
               angles(i + 1) > spike_rate*(stations%md(i + 1) - stations%md(i)))) cycle
            share = angle_between(stations, i - 1, i + 1)/min(angles(i), angles(i + 1))
            if (share >= least) cycle
            least = share
            place = i
         end do
         if (place == 0) return
         turns = abs(turn_between(stations%azimuth(place), stations%azimuth(place - 1))) > &
                 abs(stations%inclination(place) - stations%inclination(place - 1))
         call append_text(notes, 'group &trajectory: '//either('azimuth', 'inclination', turns)//' goes from '// &
            degrees(place - 1)//' to '//degrees(place)//' and back to '//degrees(place + 1)//' deg at '// &
            in_units(draft%units, unit_length, stations%md(place), depth_digits)//'. Is that station mistyped?')
      end associate
   contains
      function degrees(station) result(text)
         integer, intent(in) :: station
         character(:), allocatable :: text
         text = to_text(draft%plan%inclination(station)/degree, digits)
         if (turns) text = to_text(draft%plan%azimuth(station)/degree, digits)
      end function degrees
   end subroutine note_spikes

   !> Angle between the directions of two stations [rad].
   function angle_between(stations, one, other) result(angle)
      type(station_list_type), intent(in) :: stations
      integer, intent(in) :: one, other
      real(wp) :: angle
      angle = dogleg_between(tangent_of(stations%inclination(one), stations%azimuth(one)), &
                             tangent_of(stations%inclination(other), stations%azimuth(other)))
   end function angle_between

   !> The interval without stations over which the hole turns most, in a survey whose other stations are close.
   subroutine note_gap(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: median, turn, worst
      integer :: i, n, place
      associate (stations => draft%plan, units => draft%units)
         n = size(stations%md)
         if (n < least_surveyed) return
         median = median_of(stations%md(2:) - stations%md(:n - 1))
         worst = least_over_gap
         place = 0
         do i = 2, n
            if (stations%md(i) - stations%md(i - 1) <= long_gap*median) cycle
            turn = angle_between(stations, i - 1, i)
            if (turn <= worst) cycle
            worst = turn
            place = i
         end do
         if (place == 0) return
         call append_text(notes, 'group &trajectory: no station between '// &
            to_text(stations%md(place - 1)/units%length, depth_digits)//' and '// &
            in_units(units, unit_length, stations%md(place), depth_digits)//', where the hole turns by '// &
            to_text(worst/degree, digits)//' deg: are stations missing?')
      end associate
   end subroutine note_gap

   !> The middle one of some lengths [m].
   pure function median_of(lengths) result(median)
      real(wp), intent(in) :: lengths(:)
      real(wp) :: median
      integer :: order(size(lengths))
      order = sorted_places(lengths)
      median = lengths(order((size(lengths) + 1)/2))
   end function median_of

   !> The largest change of inclination between two stations, where it is slow or a drop: a slip, most likely.
   subroutine note_steps(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: step, length, worst
      integer :: i, place
      place = 0
      worst = long_build
      associate (stations => draft%plan, units => draft%units)
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

   !> The largest change of azimuth between two inclined stations, where it is too large to be meant.
   subroutine note_turns(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: turn, worst
      integer :: i, place
      place = 0
      worst = long_turn
      associate (stations => draft%plan, units => draft%units)
         do i = 2, size(stations%md)
            turn = abs(turn_between(stations%azimuth(i), stations%azimuth(i - 1)))
            if (turn <= worst .or. minval(stations%inclination(i - 1:i)) < inclined) cycle
            worst = turn
            place = i
         end do
         if (place == 0) return
         call append_text(notes, 'group &trajectory: azimuth goes from '// &
            to_text(stations%azimuth(place - 1)/degree, digits)//' to '//to_text(stations%azimuth(place)/degree, digits)// &
            ' deg over '//in_units(units, unit_length, stations%md(place) - stations%md(place - 1), digits)// &
            ', down to '//in_units(units, unit_length, stations%md(place), depth_digits)//'. Is an azimuth mistyped?')
      end associate
   end subroutine note_turns
end module dg_unusual_survey

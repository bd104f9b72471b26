!> The stations of a deck: from &trajectory itself or from the survey file that it names, with those of the parent hole.
module dg_deck_survey
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, line_of, reals_of, text_of
   use dg_constants, only: degree
   use dg_deck_keys, only: key_place, keys_of
   use dg_deck_schema, only: hold_in_range, key_rule_type, range_text
   use dg_error, only: add_fault, error_at, error_list_type, error_type, place_of
   use dg_file_lines, only: beside
   use dg_listed_positions, only: position_words
   use dg_minimum_curvature, only: dogleg_between
   use dg_shown_size, only: depth_words
   use dg_survey, only: tangent_of
   use dg_survey_check, only: begins_below, begins_vertical, check_station_order, at_surface, sharpest_tie
   use dg_survey_file, only: column_names_type, read_survey_file, station_list_type
   use dg_survey_heading, only: column_name
   use dg_text, only: append_text, text_type, to_text
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory, position_at, trajectory_type
   use dg_unit_kind, only: in_units, unit_curvature, unit_factor, unit_length
   use dg_units, only: unit_system, unit_system_type
   implicit none
   private
   public :: read_stations

   !> Inclination that counts as vertical where azimuths are missing [rad].
   real(wp), parameter :: vertical = 1.0e-12_wp
   !> Digits of a depth in a message.
   integer, parameter :: depth_digits = 9, few_digits = 4
   character(*), parameter :: absent = ' is missing; give md, inc and azi, or a survey_file'

   !> Angle between a parent and the first station of its sidetrack from which on they hardly belong together [rad].
   real(wp), parameter :: apart = 1.0_wp*degree
   integer, parameter :: angle_digits = 3
   !> Stations of a file that are out of range one by one.
   integer, parameter :: most_single = 3

contains

   !> Read the stations of the group &trajectory, in SI units. `sound` is true if new_trajectory can use them. Every fault is
   !> noted. `notes` receives messages on the survey files, `warnings` those on positions that differ.
   subroutine read_stations(group, units, stations, sound, notes, warnings, faults)
      type(checked_group_type), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(text_type), allocatable, intent(inout) :: notes(:), warnings(:)
      type(error_list_type), intent(inout) :: faults
      character(*), parameter :: of_files(4) = [character(12) :: 'md_column', 'inc_column', 'azi_column', 'survey_well']
      integer :: i
      sound = .false.
      if (is_given(group, 'survey_file') .and. is_given(group, 'md')) then
         call group_fault(group, 'survey_file', 'both survey_file and md are given; keep one', faults)
         return
      end if
      if (is_given(group, 'survey_file')) then
         call read_table(group, 'survey_file', units, stations, sound, faults)
      else
         do i = 1, size(of_files)
            if (.not. is_given(group, trim(of_files(i)))) cycle
            call group_fault(group, trim(of_files(i)), trim(of_files(i))//' has no meaning without survey_file. Leave it out', &
                             faults)
            return
         end do
         call read_arrays(group, stations, sound, faults)
      end if
      if (sound) call check_stations(group, units, stations, sound, faults)
      if (sound .and. is_given(group, 'survey_file')) call note_file(stations, units, notes, warnings)
      if (sound .and. is_given(group, 'parent_file')) &
         call add_parent(group, units, stations, sound, notes, warnings, faults)
      if (sound) call check_begin(group, units, stations, sound, faults)
   end subroutine read_stations

   !> Reads the table that a key names. Headings that the deck names are those of the survey; the parent's may be others.
   subroutine read_table(group, key, units, stations, sound, faults)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key                  !< survey_file or parent_file
      type(unit_system_type), intent(in) :: units
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      type(unit_system_type) :: file_units
      type(column_names_type) :: names
      type(error_list_type) :: unused
      integer :: column
      sound = .false.
      if (.not. is_sound(group, key)) return
      if (text_of(group, key, '') == '') then
         call group_fault(group, key, key//' is empty'//merge('; g', '. G', key == 'survey_file')// &
                          'ive a path relative to the deck', faults)
         return
      end if
      file_units = units
      if (is_given(group, 'survey_units')) file_units = unit_system(text_of(group, 'survey_units', ''))
      do column = 1, 3
         names%names(column) = trim(adjustl(text_of(group, trim(column_name(column))//'_column', '')))
      end do
      names%well = trim(adjustl(text_of(group, 'survey_well', '')))
      if (key == 'survey_file') then
         call read_named(faults)
      else
         call read_named(unused)
         if (sound) return
         names = column_names_type()
         call read_named(faults)
      end if

   contains

      subroutine read_named(found)
         type(error_list_type), intent(inout) :: found
         call read_survey_file(beside(group%path, text_of(group, key, '')), file_units, stations, sound, found, &
                               is_given(group, 'survey_units'), &
                               error_at(group%path, line_of(group, key), 'group &trajectory: '//key), names)
      end subroutine read_named
   end subroutine read_table

   !> Columns read, rows skipped, columns chosen and positions compared, of a file that was read.
   subroutine note_file(stations, units, notes, warnings)
      type(station_list_type), intent(in) :: stations
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:), warnings(:)
      character(:), allocatable :: positions
      logical :: doubtful
      call position_words(stations, units, positions, doubtful)
      if (stations%has_azimuth) call append_text(notes, 'survey '//stations%file//': '//to_text(size(stations%md))// &
                                                 ' stations,'//stations%headings)
      if (stations%skipped /= '') call append_text(notes, 'survey '//stations%file//': '//stations%skipped)
      if (stations%columns /= '') call append_text(notes, 'survey '//stations%file//': '//stations%columns)
      if (positions == '') return
      if (doubtful) then
         call append_text(warnings, 'survey '//stations%file//': '//positions)
      else
         call append_text(notes, 'survey '//stations%file//': '//positions)
      end if
   end subroutine note_file

   !> Add the stations of the parent above those of the survey.
   subroutine add_parent(group, units, stations, sound, notes, warnings, faults)
      type(checked_group_type), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(station_list_type), intent(inout) :: stations
      logical, intent(inout) :: sound
      type(text_type), allocatable, intent(inout) :: notes(:), warnings(:)
      type(error_list_type), intent(inout) :: faults
      type(station_list_type) :: parent
      character(:), allocatable :: failure, words
      call read_table(group, 'parent_file', units, parent, sound, faults)
      if (sound) call check_stations(group, units, parent, sound, faults)
      if (.not. sound) return
      call note_file(parent, units, notes, warnings)
      call join_parent(parent, units, stations, words, failure)
      sound = failure == ''
      if (.not. sound) call group_fault(group, 'parent_file', failure, faults)
      if (sound) call append_text(notes, 'group &trajectory: '//words)
   end subroutine add_parent

   !> Refuses a survey that begins inclined below surface without tie_on or parent_file.
   subroutine check_begin(group, units, stations, sound, faults)
      type(checked_group_type), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(station_list_type), intent(in) :: stations
      logical, intent(inout) :: sound
      type(error_list_type), intent(inout) :: faults
      character(:), allocatable :: message
      if (.not. begins_below(stations%md(1)) .or. begins_vertical(stations%inclination(1))) return
      if (text_of(group, 'tie_on', 'none') /= 'none') return
      message = 'the first station is at '//in_units(units, unit_length, stations%md(1), depth_digits)// &
                ' and inclined by '//to_text(stations%inclination(1)/degree, few_digits)// &
                ' deg. The hole above it is not known. '// &
                "For a sidetrack give parent_file = 'FILE', the survey of the hole that it leaves. "// &
                "For a slant well or a river crossing give tie_on = 'straight', the direction of the first station up to "// &
                "surface. For a hole that is vertical at surface give tie_on = 'vertical', which makes "// &
                in_units(units, unit_curvature, stations%inclination(1)/stations%md(1), few_digits)// &
                ' above the first station'
      call station_fault(group, stations, 1, message, sound, faults)
   end subroutine check_begin

   !> True where stations come from a file, false where the deck lists them.
   pure function of_file(group, stations) result(are)
      type(checked_group_type), intent(in) :: group
      type(station_list_type), intent(in) :: stations
      logical :: are
      are = stations%file /= group%path
   end function of_file

   !> A fault of one station, where it stands; what is read is then not sound.
   subroutine station_fault(group, stations, place, message, sound, faults)
      type(checked_group_type), intent(in) :: group
      type(station_list_type), intent(in) :: stations
      integer, intent(in) :: place
      character(*), intent(in) :: message
      logical, intent(inout) :: sound
      type(error_list_type), intent(inout) :: faults
      character(:), allocatable :: head
      head = 'group &trajectory: '
      if (of_file(group, stations)) head = 'survey: '
      call add_fault(faults, stations%file, stations%lines(place), head//message)
      sound = .false.
   end subroutine station_fault

   !> The stations that the group itself lists.
   subroutine read_arrays(group, stations, sound, faults)
      type(checked_group_type), intent(in) :: group
      type(station_list_type), intent(inout) :: stations
      logical, intent(out) :: sound
      type(error_list_type), intent(inout) :: faults
      stations%file = group%path
      stations%md = reals_of(group, 'md')
      stations%inclination = reals_of(group, 'inc')
      stations%azimuth = reals_of(group, 'azi')
      sound = .true.
      call check_given('md')
      call check_given('inc')
      if (is_given(group, 'azi')) call check_given('azi')
      if (.not. sound) return
      stations%has_azimuth = is_given(group, 'azi')
      call check_size('inc', size(stations%inclination))
      if (.not. stations%has_azimuth) stations%azimuth = 0.0_wp*stations%md
      call check_size('azi', size(stations%azimuth))
      stations%lines = spread(line_of(group, 'md'), 1, size(stations%md))

   contains

      subroutine check_given(key)
         character(*), intent(in) :: key
         sound = sound .and. is_sound(group, key)
         if (.not. is_given(group, key)) call group_fault(group, '', 'key '//key//absent, faults)
      end subroutine check_given

      subroutine check_size(key, found)
         character(*), intent(in) :: key
         integer, intent(in) :: found
         if (found == size(stations%md)) return
         call group_fault(group, key, key//' has '//to_text(found)//' values, md has '//to_text(size(stations%md))// &
                          '; give one for each station', faults)
         sound = .false.
      end subroutine check_size
   end subroutine read_arrays

   !> Check that stations of the deck or of its survey file are a path: two or more, from surface down, in range, with azimuths.
   subroutine check_stations(group, units, stations, sound, faults)
      type(checked_group_type), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(station_list_type), intent(in) :: stations
      logical, intent(inout) :: sound
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      integer :: i, n
      n = size(stations%md)
      sound = n >= 2
      if (.not. sound .and. of_file(group, stations)) then
         call add_fault(faults, stations%file, 0, 'survey: '//to_text(n)//' station(s); at least two are needed')
      else if (.not. sound) then
         call group_fault(group, 'md', 'md holds '//to_text(n)//' station; at least two are needed', faults)
      end if
      if (.not. sound) return
      call check_station_order(stations%md, units, found)
      do i = 1, found%count
         call station_fault(group, stations, place_of(found%items(i)), found%items(i)%message, sound, faults)
      end do
      if (of_file(group, stations)) then         ! the table of keys has checked the deck's own numbers
         call check_range('md', stations%md)
         call check_range('inc', stations%inclination)
         call check_range('azi', stations%azimuth)
      end if
      if (.not. sound .or. stations%has_azimuth .or. all(stations%inclination <= vertical)) return
      sound = .false.
      if (of_file(group, stations)) then
         call station_fault(group, stations, 1, 'the hole is inclined, but '//stations%headings, sound, faults)
      else
         call group_fault(group, '', 'key azi'//absent, faults)
      end if

   contains

      !> Stations of a file have the ranges of those in the deck. Many out of range have one message, with the first.
      subroutine check_range(key, values)
         character(*), intent(in) :: key
         real(wp), intent(in) :: values(:)      !< [SI]
         type(key_rule_type) :: rules(size(keys_of(group%name)))
         type(key_rule_type) :: rule
         character(:), allocatable :: others
         real(wp) :: held
         integer :: k, wrong
         logical :: holds(size(values))
         rules = keys_of(group%name)
         rule = rules(key_place(group%name, key))
         do k = 1, size(values)
            held = values(k)
            call hold_in_range(rule, held, holds(k))
         end do
         wrong = count(.not. holds)
         others = ''
         if (wrong > most_single) others = '. So are '//to_text(wrong - 1)//' more stations. Do the columns stand below their '// &
                                           'headings?'
         do k = 1, size(values)
            if (holds(k)) cycle
            call station_fault(group, stations, k, key//' = '//to_text(values(k)/unit_factor(units, rule%unit), depth_digits)// &
                               ' is out of range; needs a number, '//range_text(rule, units)//others, sound, faults)
            if (others /= '') exit
         end do
      end subroutine check_range
   end subroutine check_stations

   !> Put the stations of a parent above the first one of a survey before these. `words` state their number, and the turn of
   !> the hole between the two. `failure` is '', or the reason why no stations were joined.
   subroutine join_parent(parent, units, stations, words, failure)
      type(station_list_type), intent(in) :: parent      !< without fault
      type(unit_system_type), intent(in) :: units        !< of the words
      type(station_list_type), intent(inout) :: stations !< without fault
      character(:), allocatable, intent(out) :: words, failure
      real(wp) :: first, turn, off
      integer :: n
      failure = ''
      words = ''
      first = stations%md(1)
      n = count(parent%md < first - at_surface)
      if (n == 0) then
         failure = 'the survey begins at '//depth_words(units, first)// &
                   ', and parent_file has no station above. Leave parent_file out'
         return
      end if
      turn = dogleg_between(tangent_of(parent%inclination(n), parent%azimuth(n)), &
                            tangent_of(stations%inclination(1), stations%azimuth(1)))
      words = to_text(n)//' stations of parent_file are taken, down to '//depth_words(units, parent%md(n))// &
              '. From there to the first one of the survey, at '//depth_words(units, first)// &
              ', the hole turns by '//to_text(turn/degree, angle_digits)//' deg, '// &
              in_units(units, unit_curvature, turn/(first - parent%md(n)), few_digits)
      off = angle_to_parent()
      if (off > apart) words = words//'. There the parent points '//to_text(off/degree, angle_digits)// &
                               ' deg away from the first station'
      if (off > apart .or. turn > sharpest_tie*(first - parent%md(n))) words = words// &
         '. Warning: check that both surveys count depth from the same datum and azimuth from the same north'
      stations%md = [parent%md(:n), stations%md]
      stations%inclination = [parent%inclination(:n), stations%inclination]
      stations%azimuth = [parent%azimuth(:n), stations%azimuth]
      stations%lines = [spread(stations%lines(1), 1, n), stations%lines]

   contains

      !> Angle between the parent and the first station at its depth; 0 where the parent ends above [rad].
      function angle_to_parent() result(angle)
         real(wp) :: angle
         type(trajectory_type) :: path
         type(error_type), allocatable :: error
         real(wp) :: position(3), tangent(3)
         angle = 0.0_wp
         if (parent%md(size(parent%md)) < first) return
         call new_trajectory(path, parent%md, parent%inclination, parent%azimuth, interpolation_minimum_curvature, error)
         if (allocated(error)) return
         call position_at(path, first, position, tangent)
         angle = dogleg_between(tangent, tangent_of(stations%inclination(1), stations%azimuth(1)))
      end function angle_to_parent
   end subroutine join_parent
end module dg_deck_survey

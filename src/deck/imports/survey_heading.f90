!> Meaning of the heading of a column in a survey table: the quantity, how certain it is, the unit.
module dg_survey_heading
   use dg_readable, only: spaced
   use dg_survey_words, only: role_along, role_angle, role_axis, role_azi, role_corrected, role_datum, role_depth, role_direction, &
      role_drift, role_east, role_grid, role_inc, role_letter, role_magnetic, role_map, role_md, role_measured, role_minutes, &
      role_neutral, role_north, role_of, role_other, role_plan, role_sea, role_station, role_total, role_true, role_tvd, &
      role_unit, role_unknown, role_vertical, words_of
   use dg_text, only: lower_case, text_type
   implicit none
   private
   public :: heading_type, read_heading, is_heading_text
   public :: column_md, column_inc, column_azi, column_name, no_column, loose_rank

   integer, parameter :: no_column = 0, column_md = 1, column_inc = 2, column_azi = 3, column_tvd = 4, column_north = 5, &
                         column_east = 6
   character(*), parameter :: column_name(6) = [character(5) :: 'md', 'inc', 'azi', 'tvd', 'north', 'east']
   !> Ranks of headings: the lowest is taken. From `loose_rank` on the quantity is only likely. A heading that names it surely
   !> has priority. Ranks of an azimuth give its north.
   integer, parameter :: plain_rank = 1, modified_rank = 2, drift_rank = 3, loose_rank = 10, plan_rank = 5
   integer, parameter :: north_rank(5) = [1, 2, 3, 4, 6]     ! grid, corrected, true, none named, magnetic
   integer, parameter :: grid_north = 1, corrected_north = 2, true_north = 3, no_north = 4, magnetic_north = 5

   !> Parts of words that tell the quantity in brackets, too: (TVD), (true), (planned).
   integer, parameter :: quantity_roles(*) = [role_md, role_measured, role_along, role_tvd, role_vertical, role_true, role_grid, &
      role_corrected, role_magnetic, role_sea, role_plan, role_inc, role_azi]

   type :: heading_type
      integer :: column = no_column             !< the quantity
      integer :: rank = 0                       !< low where the heading is a usual one
      logical :: minutes = .false.              !< minutes of an angle
      logical :: speaks(3) = .false.            !< words of md, inc, azi stand in it, whatever it is
      character(:), allocatable :: text         !< as it stands in the file
      character(:), allocatable :: name         !< small letters without unit
      character(:), allocatable :: unit         !< small letters; '': none
   end type heading_type

contains

   !> Quantity and unit of a heading, whose words may come from several lines of the file.
   subroutine read_heading(text, heading)
      character(*), intent(in) :: text
      type(heading_type), intent(out) :: heading
      type(text_type), allocatable :: words(:), bracket_words(:)
      integer, allocatable :: roles(:)
      character(:), allocatable :: name, inside, rest
      integer :: i
      heading%text = trim(adjustl(text))
      call part_brackets(feet_spelt(text), name, inside)
      call words_of(name, words)
      call words_of(inside, bracket_words)
      allocate (roles(size(words)))
      do i = 1, size(words)
         roles(i) = role_of(words(i)%text)
      end do
      if (size(words) > 1) then
         if (words(1)%text == 'm' .and. roles(min(2, size(roles))) == role_depth) roles(1) = role_measured    ! M. Depth
      end if
      heading%unit = ''
      call split_unit_words(words, roles, heading%unit)
      rest = unit_text(inside)
      if (rest /= '') heading%unit = trim(adjustl(heading%unit//' '//rest))
      heading%name = ''
      do i = 1, size(words)
         heading%name = heading%name//words(i)%text
      end do
      do i = 1, size(bracket_words)
         if (any(role_of(bracket_words(i)%text) == quantity_roles)) roles = [roles, role_of(bracket_words(i)%text)]
      end do
      call classify(roles, words, index(lower_case(text), 'from') > 0, heading)
   end subroutine read_heading

   !> A text with the mark of feet at its end, or before its last bracket, as a word: MD', MD ('). Quotes around a text stay.
   pure function feet_spelt(text) result(spelt)
      character(*), intent(in) :: text
      character(:), allocatable :: spelt
      character(*), parameter :: mark = ''''
      !> Prime and right quotation mark in UTF-8.
      character(3), parameter :: other_marks(2) = [char(226)//char(128)//char(178), char(226)//char(128)//char(153)]
      integer :: last, length, i
      spelt = text
      last = verify(text, ' )]}', back=.true.)
      if (last < 2 .or. index(adjustl(text), mark) == 1) return
      length = merge(1, 0, text(last:last) == mark)
      do i = 1, size(other_marks)
         if (last > 3) then
            if (text(last - 2:last) == other_marks(i)) length = 3
         end if
      end do
      if (length > 0) spelt = text(:last - length)//' ft'//text(last + 1:)
   end function feet_spelt

   !> True if all words of a text are words of headings, and one of them names a quantity, or a north without a unit. Such a line
   !> belongs to the header.
   pure function is_heading_text(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      type(text_type), allocatable :: words(:)
      character(:), allocatable :: name, inside
      integer :: i, role
      logical :: quantity, north, unit
      call part_brackets(text, name, inside)
      call words_of(name, words)
      is = .true.
      quantity = .false.
      north = .false.
      unit = .false.
      do i = 1, size(words)
         role = role_of(words(i)%text)
         is = is .and. role /= role_unknown
         select case (role)
         case (role_unit)
            unit = .true.
         case (role_true, role_grid, role_magnetic)
            north = .true.
         case (role_datum, role_letter, role_sea)
            continue
         case default
            quantity = .true.
         end select
      end do
      is = is .and. (quantity .or. (north .and. .not. unit))
   end function is_heading_text

   !> The text outside of brackets, and what they hold. A sign in brackets, as in N(+)/S(-), is no unit.
   pure subroutine part_brackets(text, outside, inside)
      character(*), intent(in) :: text
      character(:), allocatable, intent(out) :: outside, inside
      integer :: i, depth
      outside = ''
      inside = ''
      depth = 0
      do i = 1, len(text)
         if (scan(text(i:i), '([{') == 1) then
            depth = depth + 1
            if (depth == 1) outside = outside//' '
            if (depth == 1 .and. inside /= '') inside = inside//' '
         else if (scan(text(i:i), ')]}') == 1) then
            depth = max(depth - 1, 0)
         else if (depth > 0) then
            if (scan(text(i:i), '+') == 0) inside = inside//text(i:i)
         else
            outside = outside//text(i:i)
         end if
      end do
      inside = spaced(trim(adjustl(lower_case(inside))))
      if (inside == '-') inside = ''
   end subroutine part_brackets

   !> The text in brackets without words that are no part of a unit: (corr), (planned).
   pure function unit_text(inside) result(unit)
      character(*), intent(in) :: inside
      character(:), allocatable :: unit
      character(:), allocatable :: word
      integer :: first, last
      unit = ''
      first = 1
      do while (first <= len(inside))
         last = first + index(inside(first:)//' ', ' ') - 2
         word = inside(first:last)
         first = last + 2
         if (word == '') cycle
         if (any(role_of(word) == [role_corrected, role_magnetic, role_plan, role_measured, role_along, role_md, role_depth, &
                                   role_inc, role_drift, role_azi, role_direction, role_angle, role_vertical, role_neutral])) cycle
         if (unit /= '') unit = unit//' '
         unit = unit//word
      end do
   end function unit_text

   !> Takes a unit at the end of the words of a heading away from them: 'md ft rkb', 'incl deg'.
   pure subroutine split_unit_words(words, roles, unit)
      type(text_type), allocatable, intent(inout) :: words(:)
      integer, allocatable, intent(inout) :: roles(:)
      character(:), allocatable, intent(inout) :: unit
      integer, allocatable :: kept(:)      ! what the words behind the unit say of the quantity
      integer :: first, i
      first = 0
      do i = size(words), 2, -1
         if (roles(i) == role_unit) first = i
         if (.not. any(roles(i) == [role_unit, role_datum, role_sea, role_true, role_grid, role_magnetic, role_letter, role_md, &
                                    role_tvd])) exit
      end do
      if (first == 0) return
      do i = first, size(words)
         if (i > first) unit = unit//' '
         unit = unit//words(i)%text
      end do
      words = words(:first - 1)
      kept = pack(roles(first:), roles(first:) == role_md .or. roles(first:) == role_tvd .or. roles(first:) == role_sea)
      roles = [roles(:first - 1), kept]
   end subroutine split_unit_words

   !> The quantity that words name; none where one of them is unknown, of another quantity, or against the others.
   subroutine classify(roles, words, from_vertical, heading)
      integer, intent(in) :: roles(:)
      type(text_type), intent(in) :: words(:)
      logical, intent(in) :: from_vertical         !< the heading says from where something counts
      type(heading_type), intent(inout) :: heading
      if (size(roles) == 0) return
      if (has(role_inc) .or. has(role_azi) .or. has(role_drift) .or. has(role_direction) .or. has(role_angle)) &
         heading%minutes = has(role_minutes)
      heading%speaks = [has(role_md) .or. (has(role_measured) .and. has(role_depth)), has(role_inc), has(role_azi)]
      call find_position(roles, words, heading)
      if (heading%column /= no_column) return
      if (any(roles == role_unknown) .or. has(role_other) .or. has(role_minutes) .or. has(role_map) .or. has(role_axis) .or. &
          has(role_east) .or. has(role_unit)) return
      if (has(role_azi) .or. has(role_direction)) then
         call name_azimuth()
      else if (has(role_inc) .or. has(role_drift) .or. has(role_angle)) then
         call name_inclination()
      else
         call name_depth()
      end if
      if (heading%column /= no_column .and. has(role_plan)) heading%rank = heading%rank + plan_rank

   contains

      pure function has(role)
         integer, intent(in) :: role
         logical :: has
         has = any(roles == role)
      end function has

      subroutine name_azimuth()
         integer :: north
         if (has(role_inc) .or. has(role_md) .or. has(role_depth) .or. has(role_tvd) .or. has(role_vertical) .or. has(role_sea)) &
            return
         heading%column = column_azi
         north = no_north
         if (has(role_magnetic) .or. any_word(words, 'm')) north = magnetic_north
         if (has(role_true) .or. any_word(words, 't')) north = true_north
         if (has(role_corrected)) north = corrected_north
         if (has(role_grid) .or. any_word(words, 'g')) north = grid_north
         heading%rank = north_rank(north)
         if (north == no_north .and. .not. has(role_azi)) heading%rank = heading%rank + 1
      end subroutine name_azimuth

      subroutine name_inclination()
         if (has(role_md) .or. has(role_depth) .or. has(role_tvd) .or. has(role_sea) .or. has(role_magnetic) .or. &
             has(role_north) .or. has(role_letter) .or. has(role_grid) .or. has(role_total)) return
         if (has(role_vertical) .and. .not. from_vertical) return
         heading%column = column_inc
         heading%rank = modified_rank
         if (size(roles) == 1) heading%rank = plain_rank
         if (.not. has(role_inc)) heading%rank = drift_rank
         if (.not. has(role_inc) .and. .not. has(role_drift) .and. .not. any_word(words, 'hole')) heading%rank = loose_rank
      end subroutine name_inclination

      subroutine name_depth()
         logical :: deep
         if (has(role_grid) .or. has(role_magnetic) .or. has(role_north) .or. has(role_letter)) return
         deep = has(role_tvd) .or. has(role_vertical) .or. (has(role_true) .and. has(role_depth))
         if (deep) then
            if (has(role_md) .or. has(role_along) .or. has(role_measured) .or. has(role_sea)) return
            if (has(role_tvd) .or. has(role_depth)) heading%column = column_tvd
            heading%rank = size(roles)
         else if (has(role_true)) then
            return
         else if (has(role_md) .or. has(role_along) .or. (has(role_measured) .and. has(role_depth))) then
            heading%column = column_md
            heading%rank = modified_rank
            if (size(roles) == 1 .or. (size(roles) == 2 .and. has(role_measured))) heading%rank = plain_rank
         else if (has(role_depth) .and. .not. has(role_sea)) then
            heading%column = column_md
            heading%rank = loose_rank + 1
            if (has(role_station)) heading%rank = loose_rank
            if (has(role_total) .or. any_word(words, 'hole')) heading%rank = loose_rank + 2
         end if
      end subroutine name_depth
   end subroutine classify

   !> True if a word stands in a heading.
   pure function any_word(words, word)
      type(text_type), intent(in) :: words(:)
      character(*), intent(in) :: word
      logical :: any_word
      integer :: i
      any_word = any([(words(i)%text == word, i=1, size(words))])
   end function any_word

   !> Positions to the north and east: '+N/-S', 'N-S', 'Northing', 'DY', 'Y offset'.
   pure subroutine find_position(roles, words, heading)
      integer, intent(in) :: roles(:)
      type(text_type), intent(in) :: words(:)
      type(heading_type), intent(inout) :: heading
      logical :: north, east, other
      integer :: i
      north = .false.
      east = .false.
      other = .false.
      heading%rank = 1
      do i = 1, size(words)
         select case (roles(i))
         case (role_north, role_east)
            north = north .or. roles(i) == role_north
            east = east .or. roles(i) == role_east
         case (role_map)
            north = north .or. words(i)%text(1:1) == 'n'
            east = east .or. words(i)%text(1:1) == 'e'
            heading%rank = heading%rank + 2
         case (role_axis)
            north = north .or. words(i)%text == 'dy'
            east = east .or. words(i)%text == 'dx'
         case (role_letter)
            north = north .or. scan(words(i)%text, 'nsy') == 1
            east = east .or. scan(words(i)%text, 'ewx') == 1
            other = other .or. scan(words(i)%text, 'tg') == 1
            ! x and y alone may be anything
            if (scan(words(i)%text, 'xy') == 1 .and. .not. (any_word(words, 'offset') .or. any_word(words, 'displacement'))) &
               other = .true.
         case (role_other)
            other = other .or. .not. any(words(i)%text == [character(12) :: 'local', 'offset', 'coord', 'coordinate', 'coords', &
                                                           'displacement', 'disp', 'distance', 'dist', 'rectangular', 'departure'])
         case (role_unit, role_neutral)
            continue
         case default
            other = .true.
         end select
      end do
      if (other .or. (north .eqv. east)) then
         heading%rank = 0
      else
         heading%column = merge(column_north, column_east, north)
      end if
   end subroutine find_position
end module dg_survey_heading

!> Reads stations from a table: CSV (comma or semicolon) or blanks, with a header that names md, inc, azi in
!> any order and letter case. Other columns are ignored, # starts a comment.
module dg_survey_file
   use dg_kinds, only: wp
   use dg_deck_number, only: read_real
   use dg_deck_schema, only: unit_length, unit_angle, unit_label
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_file_lines, only: read_lines
   use dg_text, only: text_type, append_text, lower_case, quoted, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: station_list_type, read_survey_file
   ! Rows and headings, which other tables share.
   public :: blank_brackets, close_brackets, split_fields, split_unit, without_comment

   !> Stations as read, with the place of each for messages. SI units.
   type :: station_list_type
      character(:), allocatable :: file          !< that holds them
      logical :: has_azimuth = .false.
      real(wp), allocatable :: md(:)             !< [m]
      real(wp), allocatable :: inclination(:)    !< [rad]
      real(wp), allocatable :: azimuth(:)        !< [rad]; zero where the table has none
      integer, allocatable :: lines(:)           !< of each station in its file
   end type station_list_type

   integer, parameter :: column_md = 1, column_inc = 2, column_azi = 3
   character(*), parameter :: column_name(3) = ['md ', 'inc', 'azi']
   !> Other headings for the same, as surveys use them.
   character(*), parameter :: column_alias(3) = [character(14) :: 'measured_depth', 'inclination', 'azimuth']
   character(*), parameter :: tab = achar(9)

contains

   !> Reads the table `path`; stations without fault only where `sound`.
   subroutine read_survey_file(path, units, stations, sound, faults)
      character(*), intent(in) :: path
      type(unit_system_type), intent(in) :: units     !< of the numbers
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(fault_list_type), intent(inout) :: faults
      type(text_type), allocatable :: lines(:), fields(:)
      character(:), allocatable :: failure, text
      character :: separator
      integer :: place(3), line, n, column
      real(wp) :: numbers(3)
      logical :: has_header, legal

      stations%file = path
      sound = .false.
      call read_lines(path, lines, failure)
      if (failure /= '') then
         call add_fault(faults, path, 0, 'survey file '//failure)
         return
      end if
      allocate (stations%md(size(lines)), stations%inclination(size(lines)), stations%azimuth(size(lines)), &
                stations%lines(size(lines)))
      has_header = .false.
      sound = .true.
      n = 0
      do line = 1, size(lines)
         text = without_comment(lines(line)%text)
         if (text == '') cycle
         if (.not. has_header) then
            has_header = .true.
            call read_header(path, line, text, units, separator, place, legal, faults)
            if (.not. legal) then
               sound = .false.
               return
            end if
            cycle
         end if
         call split_fields(text, separator, fields)
         numbers = 0.0_wp
         do column = 1, 3
            if (place(column) == 0) cycle
            if (place(column) > size(fields)) then
               call fault('no value for '//trim(column_name(column))//': the row has '//to_text(size(fields))// &
                          ' columns, the header puts it in column '//to_text(place(column)))
            else
               call read_real(fields(place(column))%text, numbers(column), legal)
               if (.not. legal) call fault(trim(column_name(column))//' = '//quoted(fields(place(column))%text)// &
                                           ' is no number')
            end if
         end do
         n = n + 1
         stations%md(n) = numbers(column_md)*units%length
         stations%inclination(n) = numbers(column_inc)*units%angle
         stations%azimuth(n) = numbers(column_azi)*units%angle
         stations%lines(n) = line
      end do
      if (.not. has_header) call add_fault(faults, path, 0, 'survey file is empty; it needs a header naming md, inc, azi')
      sound = sound .and. has_header
      stations%has_azimuth = has_header
      if (has_header) stations%has_azimuth = place(column_azi) > 0
      stations%md = stations%md(:n)
      stations%inclination = stations%inclination(:n)
      stations%azimuth = stations%azimuth(:n)
      stations%lines = stations%lines(:n)

   contains

      subroutine fault(message)
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, path, line, 'survey: '//message)
      end subroutine fault
   end subroutine read_survey_file

   !> Finds the separator and the columns of a header. Units in brackets that contradict the deck's are a
   !> fault, others are ignored.
   subroutine read_header(path, line, text, units, separator, place, legal, faults)
      character(*), intent(in) :: path
      integer, intent(in) :: line
      character(*), intent(in) :: text
      type(unit_system_type), intent(in) :: units
      character, intent(out) :: separator
      integer, intent(out) :: place(3)       !< column of md, inc, azi; 0: none
      logical, intent(out) :: legal
      type(fault_list_type), intent(inout) :: faults
      type(text_type), allocatable :: fields(:)
      character(:), allocatable :: name, unit, bare
      integer :: i, column

      separator = ' '
      bare = blank_brackets(text)
      if (index(bare, tab) > 0) separator = tab
      if (index(bare, ',') > 0) separator = ','
      if (index(bare, ';') > 0) separator = ';'
      place = 0
      legal = .true.
      call split_fields(close_brackets(text), separator, fields)
      do i = 1, size(fields)
         call split_unit(fields(i)%text, name, unit)
         do column = 1, 3
            if (name /= column_name(column) .and. name /= column_alias(column)) cycle
            if (place(column) > 0) then
               call fault('the header names '//trim(column_name(column))//' twice; keep one')
            else if (contradicts(column, unit, units)) then
               call fault('the header gives '//trim(column_name(column))//' in '//unit//', the deck has '// &
                          unit_label(units, merge(unit_length, unit_angle, column == column_md))// &
                          '; convert the table or change units in &job')
            end if
            place(column) = i
         end do
      end do
      if (place(column_md) == 0) call fault('the header names no md; it needs md, inc, azi')
      if (place(column_inc) == 0) call fault('the header names no inc; it needs md, inc, azi')

   contains

      subroutine fault(message)
         character(*), intent(in) :: message
         legal = .false.
         call add_fault(faults, path, line, 'survey: '//message)
      end subroutine fault
   end subroutine read_header

   !> Name and bracketed unit of a heading, both lower case: 'MD (m)' gives md and m.
   pure subroutine split_unit(heading, name, unit)
      character(*), intent(in) :: heading
      character(:), allocatable, intent(out) :: name, unit
      integer :: bracket
      bracket = scan(heading, '([')
      if (bracket == 0) then
         name = trim(adjustl(lower_case(heading)))
         unit = ''
      else
         name = trim(adjustl(lower_case(heading(:bracket - 1))))
         unit = trim(adjustl(lower_case(heading(bracket + 1:))))
         if (len(unit) > 0) then
            if (scan(unit(len(unit):), ')]') == 1) unit = trim(unit(:len(unit) - 1))
         end if
      end if
   end subroutine split_unit

   !> Whether a unit of a heading is one we know and not the deck's.
   pure function contradicts(column, unit, units) result(is)
      integer, intent(in) :: column
      character(*), intent(in) :: unit
      type(unit_system_type), intent(in) :: units
      logical :: is
      is = .false.
      if (column == column_md) then
         select case (unit)
         case ('ft', 'feet', 'foot'); is = units%name /= 'field'
         case ('m', 'meter', 'metre', 'meters', 'metres'); is = units%name == 'field'
         case default
         end select
      else
         is = unit == 'rad' .or. unit == 'radian' .or. unit == 'radians'
      end if
   end function contradicts

   !> The text with brackets and what they hold made blank.
   pure function blank_brackets(text) result(bare)
      character(*), intent(in) :: text
      character(len(text)) :: bare
      integer :: i, depth
      depth = 0
      bare = text
      do i = 1, len(text)
         if (scan(text(i:i), '([') == 1) depth = depth + 1
         if (depth > 0) bare(i:i) = ' '
         if (scan(text(i:i), ')]') == 1) depth = max(depth - 1, 0)
      end do
   end function blank_brackets

   !> The text without blanks before and inside brackets, so that 'MD (m)' is one field.
   pure function close_brackets(text) result(tight)
      character(*), intent(in) :: text
      character(:), allocatable :: tight
      integer :: i, depth
      depth = 0
      tight = ''
      do i = 1, len(text)
         if (scan(text(i:i), '([') == 1) then
            depth = depth + 1
            tight = trim(tight)
         end if
         if (depth == 0 .or. scan(text(i:i), ' '//tab) == 0) tight = tight//text(i:i)
         if (scan(text(i:i), ')]') == 1) depth = max(depth - 1, 0)
      end do
   end function close_brackets

   !> A line without its comment, tabs at its ends and blanks.
   pure function without_comment(line) result(text)
      character(*), intent(in) :: line
      character(:), allocatable :: text
      integer :: last
      last = index(line, '#') - 1
      if (last < 0) last = len(line)
      text = line(:last)
      if (verify(text, ' '//tab//',;') == 0) text = ''    ! a row of empty cells, as spreadsheets leave them
   end function without_comment

   !> Fields of a row, quotes around them dropped; blanks and tabs together are one separator. Where ;
   !> separates, a comma is a decimal point.
   pure subroutine split_fields(text, separator, fields)
      character(*), intent(in) :: text
      character, intent(in) :: separator
      type(text_type), allocatable, intent(out) :: fields(:)
      character(len(text)) :: row
      character(:), allocatable :: field
      integer :: i, first
      row = text
      do i = 1, len(row)
         if (row(i:i) == tab .and. separator /= tab) row(i:i) = ' '
         if (row(i:i) == ',' .and. separator == ';') row(i:i) = '.'
      end do
      allocate (fields(0))
      first = 1
      do i = 1, len(row) + 1
         if (i <= len(row)) then
            if (row(i:i) /= separator) cycle
         end if
         field = trim(adjustl(row(first:i - 1)))
         first = i + 1
         if (len(field) >= 2) then
            if (scan(field(1:1), '"''') == 1 .and. field(len(field):) == field(1:1)) field = field(2:len(field) - 1)
         end if
         if (field /= '' .or. separator /= ' ') call append_text(fields, field)
      end do
   end subroutine split_fields
end module dg_survey_file

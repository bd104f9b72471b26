!> Reads stations from a table as other programs export it: CSV (comma or semicolon), tabs or blanks, decimal comma, headings in
!> any order with or without units, lines above the header, a row of units below it; or a LAS file.
module dg_survey_file
   use dg_kinds, only: wp
   use dg_deck_number, only: read_real
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_file_lines, only: read_lines
   use dg_las_file, only: is_las, las_table
   use dg_table_text, only: angle_unit, close_brackets, find_separator, length_unit, other_unit, split_fields, split_heading, &
                            split_unit, without_comment
   use dg_text, only: text_type, lower_case, quoted, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: station_list_type, read_survey_file

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
   !> Other headings for the same, without blanks and marks, as programs write them.
   character(*), parameter :: md_names(11) = [character(13) :: 'md', 'measureddepth', 'measdepth', 'mdepth', 'mdrkb', 'mdrt', &
      'mdkb', 'mdbrt', 'depthmd', 'ahdepth', 'ahd']
   character(*), parameter :: inc_names(6) = [character(13) :: 'inc', 'inclination', 'incl', 'inclin', 'deviation', 'devi']
   character(*), parameter :: azi_names(13) = [character(13) :: 'azi', 'azimuth', 'azim', 'azm', 'hazi', 'az', 'azimuthtn', &
      'azimuthgn', 'azimuthtrue', 'azimuthgrid', 'azitrue', 'azigrid', 'gridazimuth']
   !> Curves of LAS files that have other names there: the index curve is the measured depth.
   character(*), parameter :: las_md_names(2) = [character(13) :: 'dept', 'depth']
   character(*), parameter :: las_inc_names(1) = [character(13) :: 'dev']
   !> Lines among which the header is looked for: titles above it are few.
   integer, parameter :: header_lines = 200

   !> Columns of a table and the SI values of their units.
   type :: layout_type
      character :: separator = ' '
      integer :: place(3) = 0                    !< column of md, inc, azi; 0: none
      real(wp) :: factor(3) = 1.0_wp
      integer :: first_row = 0                   !< line below the header
      character(:), allocatable :: null          !< what stands for no value; '': nothing
      character(:), allocatable :: foreign       !< a column whose unit is none that is converted here, for a message; '': none
   end type layout_type

contains

   !> Reads the table `path`; stations without fault only where `sound`.
   subroutine read_survey_file(path, units, stations, sound, faults)
      character(*), intent(in) :: path
      type(unit_system_type), intent(in) :: units     !< of numbers whose heading names no unit
      type(station_list_type), intent(out) :: stations
      logical, intent(out) :: sound
      type(fault_list_type), intent(inout) :: faults
      type(text_type), allocatable :: lines(:), fields(:)
      type(layout_type) :: layout
      character(:), allocatable :: failure, text
      integer :: line, n, column
      real(wp) :: numbers(3)
      logical :: legal

      stations%file = path
      sound = .false.
      call read_lines(path, lines, failure)
      allocate (stations%md(size(lines)), stations%inclination(size(lines)), stations%azimuth(size(lines)), &
                stations%lines(size(lines)))
      n = 0
      if (failure == '') then
         call find_layout(path, lines, units, layout, sound, faults)
      else
         call add_fault(faults, path, 0, 'survey file '//failure)
      end if
      if (sound) then
         do line = layout%first_row, size(lines)
            text = without_comment(lines(line)%text)
            if (text == '') cycle
            call split_fields(text, layout%separator, fields)
            if (line == layout%first_row .or. n == 0) then
               if (is_unit_row(fields, layout)) then
                  call take_units(layout, fields)
                  if (layout%foreign /= '') call fault(layout%foreign)
                  cycle
               end if
            end if
            numbers = 0.0_wp
            if (is_null(fields, layout)) cycle
            do column = 1, 3
               if (layout%place(column) == 0) cycle
               if (layout%place(column) > size(fields)) then
                  call fault('no value for '//trim(column_name(column))//': the row has '//to_text(size(fields))// &
                             ' columns, the header puts it in column '//to_text(layout%place(column)))
               else
                  call read_real(fields(layout%place(column))%text, numbers(column), legal)
                  if (.not. legal) call fault(trim(column_name(column))//' = '// &
                                              quoted(fields(layout%place(column))%text)//' is no number')
               end if
            end do
            n = n + 1
            stations%md(n) = numbers(column_md)*layout%factor(column_md)
            stations%inclination(n) = numbers(column_inc)*layout%factor(column_inc)
            stations%azimuth(n) = numbers(column_azi)*layout%factor(column_azi)
            stations%lines(n) = line
         end do
         stations%has_azimuth = layout%place(column_azi) > 0
      end if
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

   !> Finds header and columns. The header is the first line that names md and inc; where none does the first line is told to be
   !> a bad one.
   subroutine find_layout(path, lines, units, layout, sound, faults)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(out) :: layout
      logical, intent(out) :: sound
      type(fault_list_type), intent(inout) :: faults
      type(text_type), allocatable :: fields(:), names(:), las_units(:)
      character(:), allocatable :: failure, text
      integer :: line, first
      logical :: found
      sound = .false.
      layout%null = ''
      layout%foreign = ''
      if (is_las(lines)) then
         call las_table(lines, names, las_units, layout%first_row, layout%null, failure)
         if (failure /= '') then
            call add_fault(faults, path, 0, 'survey: the LAS file '//failure)
            return
         end if
         call match_columns(names, las_units, .true., units, layout)
         sound = .true.
         first = layout%first_row - 1
         if (layout%place(column_md) == 0) call fault('the curves name no md (DEPT, DEPTH, MD)')
         if (layout%place(column_inc) == 0) call fault('the curves name no inc (INCL, INC, DEVI, DEV)')
         if (layout%foreign /= '') call fault(layout%foreign)
         return
      end if
      first = 0
      found = .false.
      do line = 1, min(size(lines), header_lines)
         text = without_comment(lines(line)%text)
         if (text == '') cycle
         if (first == 0) first = line
         call take_header(line)
         found = all(layout%place(:column_inc) > 0)
         if (found) exit
      end do
      if (first == 0) then
         call add_fault(faults, path, 0, 'survey file is empty; it needs a header naming md, inc, azi')
         return
      end if
      sound = .true.
      if (found) then
         call check_once(line)
         if (layout%foreign /= '') call fault(layout%foreign)
         return
      end if
      line = first
      call take_header(line)
      if (layout%place(column_md) == 0) call fault('the header names no md; it needs md, inc, azi')
      if (layout%place(column_inc) == 0) call fault('the header names no inc; it needs md, inc, azi')

   contains

      subroutine take_header(number)
         integer, intent(in) :: number
         character(:), allocatable :: header, name, unit
         type(text_type), allocatable :: bracketed(:)
         integer :: i
         header = joined_names(close_brackets(without_comment(lines(number)%text)))
         layout%separator = find_separator(header)
         call split_fields(header, layout%separator, fields)
         allocate (names(size(fields)), bracketed(size(fields)))
         do i = 1, size(fields)
            call split_heading(fields(i)%text, name, unit)
            names(i)%text = name
            bracketed(i)%text = unit
         end do
         call match_columns(names, bracketed, .false., units, layout)
         layout%first_row = number + 1
         deallocate (names)
      end subroutine take_header

      !> Whether the header names a column twice by its own name.
      subroutine check_once(number)
         integer, intent(in) :: number
         character(:), allocatable :: name, unit
         integer :: i, column, times
         line = number
         do column = 1, 3
            times = 0
            do i = 1, size(fields)
               call split_unit(fields(i)%text, name, unit)
               if (name == column_name(column)) times = times + 1
            end do
            if (times > 1) call fault('the header names '//trim(column_name(column))//' twice; keep one')
         end do
      end subroutine check_once

      subroutine fault(message)
         character(*), intent(in) :: message
         sound = .false.
         call add_fault(faults, path, merge(first, line, is_las(lines)), 'survey: '//message)
      end subroutine fault
   end subroutine find_layout

   !> Columns by their headings: the plain name goes before others, the first before later ones.
   pure subroutine match_columns(names, unit_names, las, units, layout)
      type(text_type), intent(in) :: names(:), unit_names(:)
      logical, intent(in) :: las
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      integer :: i, column
      logical :: is
      layout%place = 0
      layout%factor = [units%length, units%angle, units%angle]
      layout%foreign = ''
      do column = 1, 3
         do i = size(names), 1, -1
            select case (column)
            case (column_md)
               is = any(md_names == names(i)%text) .or. (las .and. any(las_md_names == names(i)%text))
            case (column_inc)
               is = any(inc_names == names(i)%text) .or. (las .and. any(las_inc_names == names(i)%text))
            case default
               is = any(azi_names == names(i)%text)
            end select
            if (is) layout%place(column) = i
         end do
         do i = size(names), 1, -1
            if (names(i)%text == column_name(column)) layout%place(column) = i
         end do
         if (layout%place(column) > 0) call take_unit(layout, column, unit_names(layout%place(column))%text)
      end do
   end subroutine match_columns

   !> Sets the unit of a column, if it is one that we know ('MD (RKB)' names none); one that is not converted is kept for a fault.
   pure subroutine take_unit(layout, column, name)
      type(layout_type), intent(inout) :: layout
      integer, intent(in) :: column
      character(*), intent(in) :: name
      real(wp) :: value
      logical :: foreign
      foreign = other_unit(name)
      if (column == column_md) then
         value = length_unit(name)
         foreign = foreign .or. angle_unit(name) > 0.0_wp
      else
         value = angle_unit(name)
         foreign = foreign .or. length_unit(name) > 0.0_wp
      end if
      if (value > 0.0_wp) layout%factor(column) = value
      if (foreign .and. layout%foreign == '') layout%foreign = trim(column_name(column))//' in '//quoted(name)// &
         '; convert it: md in m, ft or usft, angles in deg or rad'
   end subroutine take_unit

   !> Whether a row holds the units of the columns: (m), ft, ...
   pure function is_unit_row(fields, layout) result(is)
      type(text_type), intent(in) :: fields(:)
      type(layout_type), intent(in) :: layout
      logical :: is
      is = layout%place(column_md) <= size(fields)
      if (is) is = length_unit(bare_unit(fields(layout%place(column_md))%text)) > 0.0_wp
   end function is_unit_row

   pure subroutine take_units(layout, fields)
      type(layout_type), intent(inout) :: layout
      type(text_type), intent(in) :: fields(:)
      integer :: column
      do column = 1, 3
         if (layout%place(column) > 0 .and. layout%place(column) <= size(fields)) &
            call take_unit(layout, column, bare_unit(fields(layout%place(column))%text))
      end do
   end subroutine take_units

   !> A unit without brackets, in small letters.
   pure function bare_unit(text) result(unit)
      character(*), intent(in) :: text
      character(:), allocatable :: unit
      integer :: i
      unit = ''
      do i = 1, len(text)
         if (scan(text(i:i), '()[] ') == 0) unit = unit//lower_case(text(i:i))
      end do
   end function bare_unit

   !> Whether a row has no station: its depth or its inclination is what stands for no value.
   pure function is_null(fields, layout) result(is)
      type(text_type), intent(in) :: fields(:)
      type(layout_type), intent(in) :: layout
      logical :: is
      real(wp) :: null, number
      logical :: legal
      integer :: column
      is = .false.
      if (layout%null == '') return
      call read_real(layout%null, null, legal)
      do column = column_md, column_inc
         if (.not. legal .or. layout%place(column) > size(fields)) return
         call read_real(fields(layout%place(column))%text, number, legal)
         if (legal .and. abs(number - null) <= spacing(null)) is = .true.
      end do
   end function is_null

   !> A header whose names of two words are one, so that blanks may separate its fields.
   pure function joined_names(header) result(joined)
      character(*), intent(in) :: header
      character(:), allocatable :: joined
      integer :: at
      joined = header
      at = index(lower_case(header), 'measured depth')
      if (at > 0) joined = header(:at + len('measured') - 1)//'_'//header(at + len('measured '):)
   end function joined_names
end module dg_survey_file

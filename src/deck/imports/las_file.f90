!> LAS files (Log ASCII Standard 1.2, 2.0, and 3.0 with the old names of sections; Canadian Well Logging Society): curves with
!> units, data in columns.
module dg_las_file
   use dg_text, only: append_text, lower_case, text_type
   use dg_table_text, only: split_fields
   implicit none
   private
   public :: is_las, las_table

contains

   !> True if lines are those of a LAS file: the first line with content opens a section of version.
   pure function is_las(lines) result(is)
      type(text_type), intent(in) :: lines(:)
      logical :: is
      integer :: i
      is = .false.
      do i = 1, size(lines)
         if (lines(i)%text == '' .or. index(adjustl(lines(i)%text), '#') == 1) cycle
         is = index(adjustl(lower_case(lines(i)%text)), '~v') == 1
         return
      end do
   end function is_las

   !> Mnemonics and units of the curves, separator and first line of the data, and the number for no value ('' if none is
   !> named). An index curve without a unit has that of the depth at which the log starts. `failure` is '', or the reason why
   !> the file cannot be read.
   pure subroutine las_table(lines, names, units, separator, first_row, null, failure)
      type(text_type), intent(in) :: lines(:)
      type(text_type), allocatable, intent(out) :: names(:), units(:)
      character, intent(out) :: separator
      integer, intent(out) :: first_row
      character(:), allocatable, intent(out) :: null, failure
      character :: section
      character(:), allocatable :: name, unit, value, start_unit
      integer :: i
      allocate (names(0), units(0))
      separator = ' '
      start_unit = ''
      section = ' '
      first_row = size(lines) + 1
      null = ''
      failure = 'has no section ~A with data'
      do i = 1, size(lines)
         associate (text => lines(i)%text)
            if (text == '' .or. index(adjustl(text), '#') == 1) cycle
            if (index(adjustl(text), '~') == 1) then
               section = section_of(text)
               if (section == 'a') then
                  first_row = i + 1
                  failure = ''
                  exit
               end if
               cycle
            end if
            call split_line(text, name, unit, value)
         end associate
         select case (section)
         case ('v')
            if (value == '') value = unit         ! WRAP.YES without the blank
            if (name == 'wrap' .and. index(value, 'y') == 1) then
               failure = 'has wrapped rows (WRAP. YES); export it without'
               return
            end if
            if (name == 'dlm') then
               if (index(value, 'comma') == 1) separator = ','
               if (index(value, 'tab') == 1) separator = achar(9)
            end if
         case ('w')
            if (name == 'null') null = value
            if (name == 'null' .and. value == '') null = unit
            if (name == 'strt') start_unit = unit
         case ('c')
            call append_text(names, name)
            call append_text(units, unit)
         case default
         end select
      end do
      if (failure == '' .and. size(names) == 0) failure = 'has no section ~C with curves'
      if (size(units) > 0) then
         if (units(1)%text == '') units(1)%text = start_unit
      end if
   end subroutine las_table

   pure function section_of(text) result(letter)
      character(*), intent(in) :: text
      character :: letter
      character(len(text)) :: lower
      lower = adjustl(lower_case(text))
      letter = ' '
      if (len(text) > 1) letter = lower(2:2)
   end function section_of

   !> Parts of 'MNEM.UNIT  value : description', small letters.
   pure subroutine split_line(text, name, unit, value)
      character(*), intent(in) :: text
      character(:), allocatable, intent(out) :: name, unit, value
      character(:), allocatable :: rest
      type(text_type), allocatable :: words(:)
      integer :: point, colon, blank
      point = index(text, '.')
      name = trim(adjustl(lower_case(text(:max(point - 1, 0)))))
      rest = lower_case(text(point + 1:))
      colon = index(rest, ':', back=.true.)
      if (colon > 0) rest = rest(:colon - 1)
      blank = scan(rest//' ', ' '//achar(9))
      unit = rest(:blank - 1)
      call split_fields(rest(min(blank, len(rest) + 1):), ' ', words)
      value = ''
      if (size(words) > 0) value = words(1)%text
   end subroutine split_line
end module dg_las_file

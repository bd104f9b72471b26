!> The deck of an imported case. A comment marks each value that the files lack or that was guessed.
module dg_case_deck
   use dg_constants, only: degree
   use dg_imported_case, only: imported_case_type, imported_hole_type, imported_part_type, lined_up
   use dg_kinds, only: wp
   use dg_printable, only: printable
   use dg_text, only: append_text, either, letter_end, plain_utf8, text_type, to_text
   use dg_units, only: unit_system_type
   use dg_version, only: program_name, program_version
   implicit none
   private
   public :: case_deck

   !> Defaults in SI for values that the files do not have: friction, mud, drill pipe.
   real(wp), parameter :: friction_cased = 0.25_wp, friction_open = 0.30_wp, mud = 1200.0_wp
   real(wp), parameter :: roughest = 2.0_wp        ! of a deck
   real(wp), parameter :: pipe_od = 0.127_wp, pipe_id = 0.1086_wp, part_length = 9.144_wp
   !> Width of a hole that is not known over that of the widest part [-]; wider than any hole [m].
   real(wp), parameter :: wider = 1.2_wp, widest = 100.0_wp
   integer, parameter :: digits = 8, a_line = 6, longest_name = 60, longest_comment = 240, remark_column = 40

contains

   !> Lines of the deck.
   subroutine case_deck(case, units, lines)
      type(imported_case_type), intent(in) :: case
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(out) :: lines(:)
      type(imported_hole_type), allocatable :: holes(:)
      type(text_type), allocatable :: notes(:)
      real(wp) :: bottom
      allocate (lines(0), notes(0))
      call lined_up(case%holes, units, holes, notes)
      call append_text(lines, '! Made by '//program_name//' '//program_version//' --import from '//comment(case%source))
      call append_text(lines, '! Look for MISSING and GUESSED: values that the files do not have.')
      call append_text(lines, '')
      call append_text(lines, '&job')
      call write_text(lines, 'title', case%well)
      call write_key(lines, 'units', "'"//trim(units%name)//"'", '')
      call append_text(lines, '/')
      call write_survey(case, units, lines)
      bottom = case%md(size(case%md))
      call append_text(lines, '')
      call write_notes(lines, [case%hole_notes, notes])
      call write_holes(case, holes, units, bottom, lines)
      call append_text(lines, '')
      call write_notes(lines, case%fluid_notes)
      call append_text(lines, '&fluid')
      if (case%density > 0.0_wp) then
         call write_number(lines, 'density', case%density/units%density, '')
      else
         call write_number(lines, 'density', mud/units%density, 'GUESSED: no density of the mud in the files')
      end if
      call append_text(lines, '/')
      call write_string(case, holes, units, lines)
      call write_cases(case, units, bottom, lines)
   end subroutine case_deck

   !> The stations as arrays.
   subroutine write_survey(case, units, lines)
      type(imported_case_type), intent(in) :: case
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: lines(:)
      call append_text(lines, '')
      call write_notes(lines, case%survey_notes)
      call append_text(lines, '&trajectory')
      call write_array('md', case%md/units%length)
      call write_array('inc', case%inclination/degree)
      call write_array('azi', case%azimuth/degree)
      if (case%md(1) > 0.0_wp .and. case%inclination(1) > 0.0_wp) &
         call write_key(lines, 'tie_on', "'vertical'", 'GUESSED: hole above the first station is MISSING; a sidetrack needs '// &
                        'the survey of its parent')
      call append_text(lines, '/')

   contains

      subroutine write_array(key, values)
         character(*), intent(in) :: key
         real(wp), intent(in) :: values(:)
         character(:), allocatable :: line
         integer :: i
         line = '  '//key//' = '
         do i = 1, size(values)
            line = line//to_text(values(i), digits)
            if (i < size(values)) line = line//', '
            if (mod(i, a_line) > 0 .and. i < size(values)) cycle
            call append_text(lines, trim(line))
            line = '    '
         end do
      end subroutine write_array
   end subroutine write_survey

   !> Sections of the hole, down to the last station at most.
   subroutine write_holes(case, holes, units, bottom, lines)
      type(imported_case_type), intent(in) :: case
      type(imported_hole_type), intent(in) :: holes(:)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(inout) :: bottom            !< of the survey, then of survey and hole [m]
      type(text_type), allocatable, intent(inout) :: lines(:)
      real(wp) :: diameter
      integer :: i
      if (size(holes) == 0) then
         diameter = wider*max(pipe_od, maxval([0.0_wp, case%parts%od, case%parts%joint_od]))
         call append_text(lines, '! MISSING: sections of the hole, casing')
         call append_text(lines, '&hole')
         call write_number(lines, 'diameter', diameter/units%diameter, 'GUESSED: 1.2 times the widest part')
         call write_number(lines, 'friction', friction_open, 'GUESSED')
         call append_text(lines, '/')
         return
      end if
      do i = 1, size(holes)
         associate (hole => holes(i))
            if (hole%top >= bottom) exit
            call append_text(lines, '&hole')
            call write_text(lines, 'name', hole%name)
            call write_number(lines, 'md_top', hole%top/units%length, '')
            call write_number(lines, 'md_bottom', min(bottom, hole%bottom)/units%length, &
                              either('end of the survey', '', hole%bottom > bottom))
            call write_number(lines, 'diameter', hole%diameter/units%diameter, hole%remark)
            if (hole%friction > 0.0_wp .and. hole%friction <= roughest) then
               call write_number(lines, 'friction', hole%friction, '')
            else
               call write_number(lines, 'friction', merge(friction_cased, friction_open, hole%cased), 'GUESSED')
            end if
            if (hole%cased) call write_key(lines, 'cased', '.true.', '')
            call append_text(lines, '/')
         end associate
      end do
      bottom = min(bottom, holes(size(holes))%bottom)
   end subroutine write_holes

   !> Components from the bit upwards.
   subroutine write_string(case, holes, units, lines)
      type(imported_case_type), intent(in) :: case
      type(imported_hole_type), intent(in) :: holes(:)
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: lines(:)
      integer :: i
      call append_text(lines, '')
      call write_notes(lines, case%string_notes)
      if (size(case%parts) == 0) then
         call append_text(lines, '! MISSING: the string')
         call append_text(lines, '&component')
         call write_number(lines, 'od', pipe_od/units%diameter, 'GUESSED')
         call write_number(lines, 'id', pipe_id/units%diameter, 'GUESSED')
         call append_text(lines, '/')
      end if
      do i = 1, size(case%parts)
         call write_part(fitted(case%parts(i), minval([widest, holes%diameter])), i == size(case%parts), units, lines)
      end do
   end subroutine write_string

   !> A bit that is wider than the hole gets the hole's diameter, as 216 mm in a hole of 8 1/2 in. Any other component becomes
   !> 1 mm narrower. A remark says so.
   function fitted(given, narrowest) result(part)
      type(imported_part_type), intent(in) :: given
      real(wp), intent(in) :: narrowest            !< diameter of the hole [m]
      type(imported_part_type) :: part
      real(wp), parameter :: play = 1.0e-3_wp      ! m
      real(wp) :: width, limit
      part = given
      width = max(part%od, part%joint_od)
      limit = narrowest
      if (part%kind /= 'bit' .and. width >= narrowest) limit = narrowest - play
      if (width <= limit) return
      part%remark = 'GUESSED: '//either('1 mm narrower than the hole', 'as wide as the hole', limit < narrowest)// &
                    '. The file has '//to_text((width - limit)*1.0e3_wp, 3)//' mm more; a tool that opens has opened_od'
      part%od = min(part%od, limit)
      part%joint_od = min(part%joint_od, limit)
   end function fitted

   subroutine write_part(part, uppermost, units, lines)
      type(imported_part_type), intent(in) :: part
      logical, intent(in) :: uppermost
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: lines(:)
      if (part%remark /= '') call append_text(lines, '! '//comment(part%remark))
      call append_text(lines, '&component')
      call write_text(lines, 'name', part%name)
      if (part%kind /= '') then
         call write_text(lines, 'kind', part%kind)
      else
         call write_text(lines, 'kind', 'collar', 'GUESSED: not known by its name')
      end if
      if (uppermost) then
         call write_number(lines, 'length', 0.0_wp, 'to surface; the file: '//to_text(part%length/units%length, digits))
      else
         call write_known('length', part%length, units%length, part_length, 'GUESSED: MISSING in the file')
      end if
      call write_known('od', part%od, units%diameter, max(pipe_od, part%id*wider), 'GUESSED: MISSING in the file')
      call write_known('id', merge(part%id, 0.0_wp, part%id < part%od .or. part%od <= 0.0_wp), units%diameter, 0.0_wp, &
                       'GUESSED: solid; the file: '//to_text(part%id/units%diameter, digits))
      call write_known('mass', part%mass, units%mass_per_length)
      if (part%mass <= 0.0_wp) call append_text(lines, '  ! mass MISSING: that of a steel tube of od and id')
      if (part%kind == 'stabilizer') then
         call write_known('joint_od', part%joint_od, units%diameter, max(part%od, pipe_od), &
                          'GUESSED: diameter of the blades is MISSING')
      else
         call write_known('joint_od', part%joint_od, units%diameter)
         if (part%joint_od <= 0.0_wp .and. (part%kind == 'drillpipe' .or. part%kind == 'hwdp')) &
            call append_text(lines, '  ! joint_od MISSING: the tool joints as wide as the body')
      end if
      call write_known('joint_id', part%joint_id, units%diameter)
      call write_known('joint_length', part%joint_length, units%length)
      call write_known('yield', part%yield, units%stress)
      call write_known('makeup_torque', part%makeup_torque, units%moment)
      call write_known('bend', part%bend, degree)
      if (part%bend > 0.0_wp) call write_known('bend_position', part%bend_position, units%length, 0.0_wp, 'MISSING: 0')
      call append_text(lines, '/')

   contains

      !> Write a number of the files, or a guess; without a guess no line.
      subroutine write_known(key, number, unit, guess, remark)
         character(*), intent(in) :: key
         real(wp), intent(in) :: number, unit               !< [SI]
         real(wp), intent(in), optional :: guess            !< [SI]
         character(*), intent(in), optional :: remark       !< on the guess
         if (number > 0.0_wp) then
            call write_number(lines, key, number/unit, '')
         else if (present(guess)) then
            call write_number(lines, key, guess/unit, remark)
         end if
      end subroutine write_known
   end subroutine write_part

   !> Three operations at the depth of the string.
   subroutine write_cases(case, units, bottom, lines)
      type(imported_case_type), intent(in) :: case
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: bottom               !< of survey and hole [m]
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), parameter :: operations(3) = [character(19) :: 'pick_up', 'slack_off', 'rotating_off_bottom']
      real(wp) :: depth
      integer :: i
      depth = bottom
      call append_text(lines, '')
      if (case%bit_depth > 0.0_wp .and. case%bit_depth <= bottom) then
         depth = case%bit_depth
         call append_text(lines, '! GUESSED: operations. The bit depth is that of the string in the files.')
      else
         call append_text(lines, '! GUESSED: operations, and the end of survey and hole as bit depth')
      end if
      do i = 1, size(operations)
         call append_text(lines, '&load_case name = '''//trim(operations(i))//''', operation = '''//trim(operations(i))// &
                          ''', bit_depth = '//to_text(depth/units%length, digits)//' /')
      end do
   end subroutine write_cases

   !> "  key = value", with a remark where there is one.
   subroutine write_key(lines, key, value, remark)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: key, value, remark
      character(:), allocatable :: line
      line = '  '//key//' = '//value
      if (remark /= '') line = line//repeat(' ', max(1, remark_column - len(line)))//'! '//comment(remark)
      call append_text(lines, line)
   end subroutine write_key

   subroutine write_number(lines, key, number, remark)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: key, remark
      real(wp), intent(in) :: number
      call write_key(lines, key, to_text(number, digits), remark)
   end subroutine write_number

   !> A text of the files as one of a deck; none where it is empty.
   subroutine write_text(lines, key, text, remark)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: key, text
      character(*), intent(in), optional :: remark
      character(:), allocatable :: plain, value
      integer :: i
      plain = comment(text, longest_name)
      plain = plain(verify(plain//'x', ' =+-@'):)
      if (plain == '') return
      value = ''
      do i = 1, len_trim(plain)
         value = value//plain(i:i)
         if (plain(i:i) == '''') value = value//''''
      end do
      if (present(remark)) then
         call write_key(lines, key, ''''//value//'''', remark)
      else
         call write_key(lines, key, ''''//value//'''', '')
      end if
   end subroutine write_text

   subroutine write_notes(lines, notes)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(text_type), intent(in) :: notes(:)
      integer :: i
      do i = 1, size(notes)
         call append_text(lines, '! '//comment(notes(i)%text))
      end do
   end subroutine write_notes

   !> A text in one line of UTF-8, cut to a readable length between two letters.
   pure function comment(text, most) result(plain)
      character(*), intent(in) :: text
      integer, intent(in), optional :: most        !< bytes
      character(:), allocatable :: plain
      character(len(text)) :: whole
      integer :: last, next, longest
      longest = longest_comment
      if (present(most)) longest = most
      whole = printable(plain_utf8(text), '')
      last = 0
      do while (last < len_trim(whole))
         next = letter_end(whole, last + 1)
         if (next > longest .or. next == 0) exit
         last = next
      end do
      plain = whole(:last)
   end function comment
end module dg_case_deck

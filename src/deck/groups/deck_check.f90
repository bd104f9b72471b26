!> Checks of the parts of a deck against each other, as for any model (src/scene/rules). Faults have the lines of the deck.
!> Holes must cover the depths of the cases, strings must reach surface and pass the hole, and names must be unique. Only parts
!> that are legal in themselves are checked, so that one slip gives one message.
module dg_deck_check
   use dg_kinds, only: wp
   use dg_case_check, only: check_passage, hole_question, pipe_question, check_reach, check_string_length, check_string_name
   use dg_component, only: component_type
   use dg_deck_draft, only: draft_case_type, draft_type, find_case, lowest_of, sections_of
   use dg_error, only: add_fault, clear_errors, error_list_type, is_listed, key_of, other_of, other_place_of, part_of, &
      place_of, whole_message
   use dg_hole_check, only: check_section, depth_round_off, join_sections
   use dg_hole_section, only: hole_section_type
   use dg_merge_sort, only: first_equal, sorted_places
   use dg_model, only: hold_free, hold_landed
   use dg_opening_check, only: set_opened_depth
   use dg_shown_size, only: depth_words, diameter_digits, diameter_words
   use dg_string_check, only: check_in_string
   use dg_unusual_input, only: holes_in_inches, inches_meant
   use dg_text, only: lower_case, name_shown, quoted, text_type, to_text
   implicit none
   private
   public :: close_holes, check_draft, check_case, report_faults

   !> Words of check_passage, up to the case, of check_in_string and of check_reach.
   character(*), parameter :: passes_not = 'does not pass', case_mark = ') in ', sinks_not = ' floats: '
   character(*), parameter :: reaches_not = ' lies below the '

contains

   !> Sort the hole sections by depth, set defaults of open ends and check that they abut from surface on.
   subroutine close_holes(draft, faults)
      type(draft_type), intent(inout) :: draft
      type(error_list_type), intent(inout) :: faults
      real(wp) :: tops(size(draft%holes))
      type(hole_section_type) :: sections(size(draft%holes))
      type(error_list_type) :: found, in_itself
      integer :: i, n

      n = size(draft%holes)
      do i = 1, n
         associate (hole => draft%holes(i))
            if (.not. hole%sound) cycle
            if (.not. hole%has_top .and. i > 1) then
               hole%section%md_top = draft%holes(i - 1)%section%md_bottom
               hole%sound = draft%holes(i - 1)%sound
               if (.not. hole%sound) cycle
            end if
            if (.not. hole%has_bottom) then
               if (i == n) then
                  hole%section%md_bottom = hole%section%md_top
                  if (.not. draft%has_stations) hole%sound = .false.
                  if (draft%has_stations) hole%section%md_bottom = draft%stations%md(size(draft%stations%md))
               else if (draft%holes(i + 1)%has_top .and. draft%holes(i + 1)%sound) then
                  hole%section%md_bottom = draft%holes(i + 1)%section%md_top
               else
                  hole%sound = .false.
                  if (draft%holes(i + 1)%sound) call fault(hole%line, 'key md_bottom is missing, and the next section has '// &
                                                           'no md_top; give one of them')
                  draft%holes(i + 1)%sound = .false.
                  cycle
               end if
            end if
            if (.not. hole%sound) cycle
            if (.not. hole%section%md_bottom > hole%section%md_top) call check_default_ends(i)
            if (.not. hole%sound) cycle
            call check_section(hole%section, i, draft%units, in_itself)
            hole%sound = in_itself%count == 0
            call report_faults(draft, in_itself, faults)
         end associate
      end do
      if (n == 0 .or. .not. all(draft%holes%sound)) return
      tops = draft%holes%section%md_top
      if (any(tops(2:) < tops(:n - 1))) draft%holes = draft%holes(sorted_places(tops))
      sections = sections_of(draft)
      call join_sections(sections, draft%units, found)
      do i = 1, n
         draft%holes(i)%section%md_top = sections(i)%md_top
      end do
      do i = 1, found%count
         if (place_of(found%items(i)) > 1) draft%holes(place_of(found%items(i)))%sound = .false.
      end do
      call report_faults(draft, found, faults)

   contains

      !> Report a section that ends above its beginning where one of the two follows from another section or the survey. The
      !> depth that is written is named.
      subroutine check_default_ends(number)
         integer, intent(in) :: number      !< of the section
         character(:), allocatable :: ends
         associate (hole => draft%holes(number))
            if (hole%has_top .eqv. hole%has_bottom) return
            ends = 'the last station, '
            if (hole%has_bottom) ends = 'md_bottom of the next section (line '//to_text(hole%line)//'), '
            ends = ' = '//depth_words(draft%units, hole%section%md_top)//' is not above '//ends// &
                   depth_words(draft%units, hole%section%md_bottom)
            hole%sound = .false.
            if (hole%has_top) call fault(hole%line_top, 'md_top'//ends)
            if (hole%has_bottom) call fault(draft%holes(number - 1)%line_bottom, 'md_bottom'//ends)
         end associate
      end subroutine check_default_ends

      subroutine fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, draft%path, line, 'group &hole: '//message)
      end subroutine fault
   end subroutine close_holes

   !> All checks across groups; `draft` is as it comes from close_holes.
   subroutine check_draft(draft, faults)
      type(draft_type), intent(inout) :: draft
      type(error_list_type), intent(inout) :: faults
      type(draft_case_type) :: item
      type(text_type) :: names(size(draft%cases))
      integer :: first(size(draft%cases))
      integer :: i
      if (holes_in_inches(draft)) call add_fault(faults, draft%path, draft%holes(1)%line, 'group &hole: diameter = '// &
         diameter_words(draft%units, draft%holes(1)%section%diameter, diameter_digits)//': '//inches_meant)
      call check_strings(draft, faults)
      call set_openings(draft, faults)
      do i = 1, size(names)
         names(i)%text = lower_case(draft%cases(i)%load_case%name)
      end do
      first = first_equal(names)
      do i = 1, size(draft%cases)
         if (first(i) < i .and. names(i)%text /= '') call add_fault(faults, draft%path, draft%cases(i)%line_name, &
            'group &load_case: name '//quoted(draft%cases(i)%load_case%name)//' is taken by the case in line '// &
            to_text(draft%cases(first(i))%line)//'; names must be unique, letter case aside')
         if (.not. draft%cases(i)%sound) cycle
         item = draft%cases(i)
         call check_case(draft, item, faults)
         if (item%length_reference /= '') call find_reference(draft, item, faults)
         draft%cases(i) = item
      end do
   end subroutine check_draft

   !> Find the load case from which a change of length counts. It must be another one, with the same string at the same depth,
   !> that counts from no other. For a packer that holds the string its load is found from it.
   subroutine find_reference(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(inout) :: item
      type(error_list_type), intent(inout) :: faults
      character(:), allocatable :: head
      integer :: k
      head = 'group &load_case: length_reference '//quoted(item%length_reference)
      call find_case(draft, 'load_case', item%line_reference, item%length_reference, k, faults)
      if (k == 0) then
         item%sound = .false.
         return
      end if
      item%load_case%length_reference = k
      associate (other => draft%cases(k), own => item%load_case)
         if (.not. other%sound) then
            item%sound = .false.
         else if (other%length_reference /= '') then
            call fault(item%line_reference, head//' has a length_reference itself; name a case without one')
         else if (other%load_case%string /= own%string .or. abs(other%load_case%bit_depth - own%bit_depth) > &
                  depth_round_off*own%bit_depth) then
            call fault(item%line_reference, head//' has another string or bit_depth; it must have the same')
         else if (draft%boundary%packer_hold == hold_landed .and. other%load_case%wob < 0.0_wp) then
            call fault(item%line_reference, head//' pulls its string off the landing by wob < 0; give that case wob = 0 or '// &
                       'more, or packer_hold = ''fixed''')
         end if
      end associate
      if (draft%boundary%packer_hold /= hold_free .and. item%line_wob > 0) call fault(item%line_wob, &
         'group &load_case: wob follows from packer_hold in a case with length_reference; leave wob out')
   contains
      subroutine fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, draft%path, line, message)
         item%sound = .false.
      end subroutine fault
   end subroutine find_reference

   !> Survey and holes reach the bit of a case, its string exists, reaches surface and passes the hole.
   subroutine check_case(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(inout) :: item
      type(error_list_type), intent(inout) :: faults
      call check_depth(draft, item, faults)
      call check_string(draft, item, faults)
   end subroutine check_case

   !> Components: lengths, and that they sink in the mud.
   subroutine check_strings(draft, faults)
      type(draft_type), intent(in) :: draft
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      integer, dimension(size(draft%components)) :: lowest, uppermost
      real(wp) :: heaviest
      integer :: i, k
      lowest = lowest_of(draft)
      do i = 1, size(lowest)
         uppermost(lowest(i)) = i
         do k = 1, i - 1
            if (lowest(k) == lowest(i) .or. lower_case(draft%components(k)%string) /= lower_case(draft%components(i)%string)) cycle
            call add_fault(faults, draft%path, draft%components(i)%line, 'group &component: string = '// &
                           quoted(draft%components(i)%string)//' differs from '//quoted(draft%components(k)%string)// &
                           ' in line '//to_text(draft%components(k)%line)//' by capitals only; write one of them')
            exit
         end do
      end do
      heaviest = 0.0_wp
      if (size(draft%fluids) > 0) heaviest = maxval(draft%fluids%fluid%density)
      do i = 1, size(draft%components)
         associate (item => draft%components(i))
            if (.not. item%sound) cycle
            call check_in_string(item%component, i, item%string, uppermost(lowest(i)) == i, draft%units, found, heaviest)
         end associate
      end do
      call report_faults(draft, found, faults)
   end subroutine check_strings

   !> Gives tools that open their depth, by the hole.
   subroutine set_openings(draft, faults)
      type(draft_type), intent(inout) :: draft
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      type(hole_section_type) :: sections(size(draft%holes))
      integer :: i
      if (.not. all(draft%holes%sound)) return
      sections = sections_of(draft)
      do i = 1, size(draft%components)
         if (.not. draft%components(i)%sound) cycle
         call set_opened_depth(draft%components(i)%component, i, sections, found)
         draft%components(i)%sound = found%count == 0
         call report_faults(draft, found, faults)
      end do
   end subroutine set_openings

   !> Survey and holes reach the bit.
   subroutine check_depth(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(inout) :: item
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      real(wp) :: last
      last = huge(last)
      if (draft%has_stations) last = draft%stations%md(size(draft%stations%md))
      call reach('survey', last)
      if (all(draft%holes%sound) .and. size(draft%holes) > 0) then
         ! a hole as deep as the survey adds nothing
         associate (bottom => draft%holes(size(draft%holes))%section%md_bottom)
            if (bottom < last) call reach('lowest hole section', bottom)
         end associate
      end if
      if (found%count > 0) item%sound = .false.
      call report_faults(draft, found, faults, item)
   contains
      subroutine reach(what, bottom)
         character(*), intent(in) :: what
         real(wp), intent(in) :: bottom
         call check_reach(item%load_case%bit_depth, trim(item%depth_key), what, bottom, draft%units, found)
      end subroutine reach
   end subroutine check_depth

   !> The string of a case exists, reaches surface and passes the hole.
   subroutine check_string(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(in) :: item
      type(error_list_type), intent(inout) :: faults
      type(error_list_type) :: found
      integer, allocatable :: parts(:)
      type(component_type), allocatable :: string(:)
      integer :: k, n

      associate (case => item%load_case)
         if (size(draft%components) == 0) return     ! reported already
         allocate (parts(size(draft%components)))
         n = 0
         do k = 1, size(draft%components)
            if (draft%components(k)%string == '' .and. .not. draft%components(k)%sound) return     ! it may belong to any string
            if (draft%components(k)%string /= case%string) cycle
            n = n + 1
            parts(n) = k
         end do
         if (n == 0) then
            call check_string_name(case%string, string_names(draft), found)
            call report_faults(draft, found, faults, item)
            return
         end if
         parts = parts(:n)
         if (.not. all(draft%components(parts)%sound)) return
         allocate (string(size(parts)))
         do k = 1, size(parts)
            string(k) = draft%components(parts(k))%component
         end do
         call check_string_length(string, parts(size(parts)), case, trim(item%depth_key), draft%units, found)
         call report_faults(draft, found, faults, item)
         if (.not. all(draft%holes%sound)) return
         call check_passage(string, parts, sections_of(draft), case%bit_depth, trim(item%what)//' '//quoted(case%name), &
                            draft%units, found)
         call report_faults(draft, found, faults, item)
      end associate
   end subroutine check_string

   !> Report faults of the model's checks, with the lines of the deck, and empty the list.
   subroutine report_faults(draft, found, faults, item)
      type(draft_type), intent(in) :: draft
      type(error_list_type), intent(inout) :: found
      type(error_list_type), intent(inout) :: faults
      type(draft_case_type), intent(in), optional :: item   !< the load case, or what stands for one
      character(:), allocatable :: words, group
      integer :: i, line
      do i = 1, found%count
         associate (fault => found%items(i))
            line = line_of_part(draft, part_of(fault), place_of(fault), key_of(fault))
            group = trim(part_of(fault))
            if (present(item) .and. part_of(fault) == 'load_case') then
               group = trim(item%group)
               line = merge(item%line_string, item%line_depth, key_of(fault) == 'string')
            end if
            call whole_message(fault, 'line '//to_text(line_of_part(draft, other_of(fault), other_place_of(fault), '')), words)
            ! one case is enough to show that a component is too wide for a hole section, one component that the mud is too heavy
            if (index(words, passes_not) > 0) then
               if (is_listed(faults, words(:index(words, case_mark) + len(case_mark) - 1), line)) cycle
            end if
            if (index(words, sinks_not) > 0 .and. is_listed(faults, sinks_not)) cycle
            ! cases at the same depth
            if (index(words, reaches_not) > 0 .and. is_listed(faults, words)) cycle
            if (index(words, passes_not) > 0 .and. is_listed(faults, inches_meant)) cycle
            ! a hole in another unit is too narrow for all
            if (index(words, hole_question) > 0) then
               if (is_listed(faults, words(index(words, passes_not):index(words, case_mark)))) cycle
            end if
            ! components in another unit are too wide for all holes
            if (index(words, pipe_question) > 0 .and. is_listed(faults, pipe_question)) cycle
            call add_fault(faults, draft%path, line, 'group &'//group//': '//words)
         end associate
      end do
      call clear_errors(found)
   end subroutine report_faults

   !> Line of a quantity of a part; key '': of its group.
   pure function line_of_part(draft, part, place, key) result(line)
      type(draft_type), intent(in) :: draft
      character(*), intent(in) :: part, key
      integer, intent(in) :: place
      integer :: line
      line = 0
      select case (part)
      case ('hole')
         line = draft%holes(place)%line
         if (key == 'md_top') line = draft%holes(place)%line_top
         if (key == 'md_bottom') line = draft%holes(place)%line_bottom
      case ('component')
         line = draft%components(place)%line
         if (key == 'length') line = draft%components(place)%line_length
         if (key == 'od') line = draft%components(place)%line_diameter
         if (key == 'opened_od') line = draft%components(place)%line_opened
         if (key == 'density') line = draft%components(place)%line_density
      case ('centralizer')
         line = draft%components(place)%line_centralizer
      case ('fluid')
         line = draft%fluids(place)%line
      case default
      end select
   end function line_of_part

   !> Names of the strings, each once.
   pure function string_names(draft) result(names)
      type(draft_type), intent(in) :: draft
      character(name_shown), allocatable :: names(:)
      integer :: lowest(size(draft%components))
      integer :: i
      lowest = lowest_of(draft)
      allocate (names(0))
      do i = 1, size(lowest)
         if (lowest(i) == i) names = [character(name_shown) :: names, draft%components(i)%string]
      end do
   end function string_names
end module dg_deck_check

!> Finds the header of a survey table, on one, two or three lines, and the columns that it names.
module dg_survey_header
   use dg_survey_cells, only: count_numbers, part_phrases
   use dg_survey_columns, only: choose_columns, column_names_type, layout_type, no_extent
   use dg_survey_heading, only: column_inc, heading_type, is_heading_text, read_heading
   use dg_survey_stack, only: stack_by_count, stack_by_place
   use dg_survey_words, only: role_along, role_corrected, role_magnetic, role_md, role_measured, role_of, role_plan, role_sea, &
                              role_tvd, role_vertical, words_of
   use dg_table_text, only: content_length, find_separator, split_row
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: find_header

   !> Lines among which the header is looked for: titles above it are few.
   integer, parameter :: header_lines = 200
   !> Lines of a header beside its units.
   integer, parameter :: most_lines = 4, usual_lines = 3

contains

   !> Find header, columns and their units. `line` is the last one of the header. If no line names md and inc (those that the
   !> deck names, or others) `found` is false. The layout is then that of the line most like a header.
   subroutine find_header(lines, names, units, layout, line, found)
      type(text_type), intent(in) :: lines(:)     !< marks of comments taken off where the header stands in one
      type(column_names_type), intent(in) :: names
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      integer, intent(out) :: line                !< 0: the file is empty
      logical, intent(out) :: found
      type(layout_type) :: trial
      integer :: last, bottom, count, first_line, best, likely
      found = .false.
      line = 0
      best = -1
      do last = 1, min(size(lines), header_lines)
         if (content_length(lines(last)%text) == 0) cycle
         if (line == 0) line = last
         do count = 1, usual_lines
            first_line = last - count + 1
            if (first_line < 1) exit
            if (.not. is_header_line(lines(first_line)%text)) exit
            call read_block(lines, first_line, last, names, units, trial)
            if (count == 1) then
               likely = score(trial)
               if (likely > best) then
                  best = likely
                  layout = trial
                  line = last
               end if
            end if
            if (.not. is_complete(trial)) cycle
            bottom = last
            call extend(lines, names, units, first_line, bottom, trial)
            if (.not. is_complete(trial)) then
               layout = trial
               line = bottom
               best = huge(best)
               cycle
            end if
            layout = trial
            layout%first_header = first_line
            line = bottom
            found = .true.
            return
         end do
      end do
      if (best < 0 .and. line > 0) call read_block(lines, line, line, names, units, layout)
      layout%first_header = line
   end subroutine find_header

   !> True if a line may belong to a header: it holds letters.
   pure function is_header_line(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      integer :: i
      associate (content => text(:content_length(text)))
         is = scan(content, 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ') > 0 .or. &
              any([(iachar(content(i:i)) > 127, i=1, len(content))])
      end associate
   end function is_header_line

   pure function is_complete(layout) result(complete)
      type(layout_type), intent(in) :: layout
      logical :: complete
      complete = all(layout%place(:column_inc) > 0)
   end function is_complete

   !> Likeness of a line to the header: columns that it names count most, the others little.
   pure function score(layout) result(likely)
      type(layout_type), intent(in) :: layout
      integer :: likely
      integer, parameter :: known = 100, most = 50
      likely = known*(count(layout%place > 0)) + min(layout%width, most)
   end function score

   !> Adds lines above and below that hold nothing but words of headings.
   subroutine extend(lines, names, units, first_line, last, layout)
      type(text_type), intent(in) :: lines(:)
      type(column_names_type), intent(in) :: names
      type(unit_system_type), intent(in) :: units
      integer, intent(inout) :: first_line, last
      type(layout_type), intent(inout) :: layout
      type(layout_type) :: same
      integer :: first_before, last_before
      first_before = first_line
      last_before = last
      do while (first_line > 1 .and. last - first_line + 1 < most_lines)
         if (.not. belongs(lines(first_line - 1)%text)) exit
         first_line = first_line - 1
      end do
      do while (last < size(lines) .and. last - first_line + 1 < most_lines)
         if (.not. belongs(lines(last + 1)%text)) exit
         call read_block(lines, last + 1, last + 1, names, units, same)
         if (is_complete(same)) exit        ! the header again
         last = last + 1
      end do
      if (first_line == first_before .and. last == last_before) return
      call read_block(lines, first_line, last, names, units, layout)
   end subroutine extend

   !> True if a line beside the header is a part of it. A phrase that stands alone must name a quantity; otherwise it is a title.
   pure function belongs(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      type(text_type), allocatable :: row(:), words(:)
      character :: separator
      integer :: i, filled, length
      is = .false.
      length = content_length(text)
      if (length == 0) return
      if (.not. is_heading_text(text(:length))) return
      separator = find_separator(text(:length))
      if (separator == ' ') then
         call part_phrases(text(:length), row)
      else
         call split_row(text(:length), separator, row)
      end if
      filled = 0
      do i = 1, size(row)
         if (row(i)%text /= '') filled = filled + 1
      end do
      is = filled >= 2
      if (is) return
      call words_of(text(:length), words)
      do i = 1, size(words)
         is = is .or. any(role_of(words(i)%text) == [role_along, role_corrected, role_magnetic, role_md, role_measured, role_plan, &
                                                     role_sea, role_tvd, role_vertical])
      end do
   end function belongs

   !> Columns by the lines of a header. Where several separators stand in it, the one between names that we know counts.
   subroutine read_block(lines, first_line, last, names, units, layout)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line, last
      type(column_names_type), intent(in) :: names
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      type(text_type), allocatable :: texts(:)
      type(heading_type), allocatable :: headings(:)
      character :: separator
      character, parameter :: tab = achar(9)
      integer :: attempt, i, data_line
      data_line = next_data(lines, last + 1)
      separator = find_separator(lines(last)%text(:content_length(lines(last)%text)))
      do attempt = 1, 3
         layout%wide = .false.
         layout%separator = separator
         layout%extent = no_extent
         if (separator == ' ') then
            call stack_by_place(lines, first_line, last, data_line, layout, texts)
         else
            call stack_by_count(lines, first_line, last, separator, texts)
            if (data_line > 0) call find_row_separator(lines(data_line)%text, size(texts), layout%separator)
         end if
         if (allocated(headings)) deallocate (headings)
         allocate (headings(size(texts)))
         do i = 1, size(texts)
            call read_heading(texts(i)%text, headings(i))
         end do
         call choose_columns(headings, names, units, layout)
         if (is_complete(layout) .or. separator == ' ') exit
         ! commas inside of headings
         if (separator /= tab .and. index(lines(last)%text, tab) > 0) then
            separator = tab
         else if (data_line > 0) then
            if (index(lines(data_line)%text, separator) > 0) exit
            separator = ' '
         else
            exit
         end if
      end do
   end subroutine read_block

   !> The next line that holds two numbers or more; 0 where none is near.
   pure function next_data(lines, first_line) result(line)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line
      integer :: line
      integer, parameter :: near = 40
      do line = first_line, min(size(lines), first_line + near)
         if (count_numbers(lines(line)%text) >= 2) return
      end do
      line = 0
   end function next_data

   !> Rows between blanks below a header between commas.
   pure subroutine find_row_separator(text, width, separator)
      character(*), intent(in) :: text
      integer, intent(in) :: width
      character, intent(inout) :: separator
      type(text_type), allocatable :: row(:)
      integer :: length
      length = content_length(text)
      if (separator == ' ' .or. index(text(:length), separator) > 0) return
      call split_row(text(:length), ' ', row)
      if (size(row) == width .and. width > 1) separator = ' '
   end subroutine find_row_separator
end module dg_survey_header

!> Finds the header of a survey table, on one, two or three lines, and the columns that it names.
module dg_survey_header
   use dg_survey_cells, only: count_numbers, find_extents, part_phrases
   use dg_survey_columns, only: choose_columns, column_names_type, layout_type
   use dg_survey_heading, only: column_inc, heading_type, is_heading_text, read_heading
   use dg_survey_words, only: role_along, role_corrected, role_magnetic, role_md, role_measured, role_of, role_plan, role_sea, &
                              role_tvd, role_vertical, words_of
   use dg_table_text, only: close_brackets, content_length, find_separator, row_type, split_row
   use dg_text, only: append_text, text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: find_header

   !> Lines among which the header is looked for: titles above it are few.
   integer, parameter :: header_lines = 200
   !> Lines of a header beside its units.
   integer, parameter :: most_lines = 4, usual_lines = 3

contains

   !> Header, columns and their units. `line` is the last one of the header. Where no line names md and inc (those that the deck
   !> names, or others) `found` is false, and the layout is that of the line that looks most like a header.
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
               if (score(trial) >= best) layout = trial
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

   !> Whether a line may belong to a header: it holds letters.
   pure function is_header_line(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      integer :: length, i
      length = content_length(text)
      is = .false.
      do i = 1, length
         is = is .or. scan(text(i:i), 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ') == 1 .or. iachar(text(i:i)) > 127
      end do
   end function is_header_line

   pure function is_complete(layout) result(complete)
      type(layout_type), intent(in) :: layout
      logical :: complete
      complete = all(layout%place(:column_inc) > 0)
   end function is_complete

   !> How much a line looks like the header: columns that it names, the others by little.
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

   !> Whether a line beside the header is a part of it. A phrase that stands alone must tell a quantity: else it is a title.
   pure function belongs(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      type(row_type) :: row
      type(text_type), allocatable :: words(:)
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
      do i = 1, row%count
         if (row%last(i) >= row%first(i)) filled = filled + 1
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
         if (allocated(layout%extent)) deallocate (layout%extent)
         allocate (layout%extent(2, 0))
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

   !> The row below the header by which its columns are counted: one with as many fields as the header has words, or phrases; else
   !> the longest that holds nothing but numbers; else the next.
   subroutine find_example(lines, first_line, words, phrases, line)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line           !< the next row; 0: none
      integer, intent(in) :: words, phrases       !< of the header, on one line; 0: on several
      integer, intent(out) :: line
      type(row_type) :: row
      integer, parameter :: most = 200
      integer :: i, length, best, rank, best_rank
      line = first_line
      if (first_line == 0) return
      best = 0
      best_rank = 0
      do i = first_line, min(size(lines), first_line + most)
         if (count_numbers(lines(i)%text) < 2) cycle
         length = content_length(lines(i)%text)
         call split_row(lines(i)%text(:length), ' ', row)
         rank = 0
         if (count_numbers(lines(i)%text) == row%count) rank = 1
         if (row%count == phrases) rank = 2
         if (row%count == words) rank = 3
         if (rank < best_rank .or. (rank == best_rank .and. (row%count <= best .or. rank == 0))) cycle
         best_rank = rank
         best = row%count
         line = i
      end do
   end subroutine find_example

   !> Rows between blanks below a header between commas.
   pure subroutine find_row_separator(text, width, separator)
      character(*), intent(in) :: text
      integer, intent(in) :: width
      character, intent(inout) :: separator
      type(row_type) :: row
      integer :: length
      length = content_length(text)
      if (separator == ' ' .or. index(text(:length), separator) > 0) return
      call split_row(text(:length), ' ', row)
      if (row%count == width .and. width > 1) separator = ' '
   end subroutine find_row_separator

   !> Headings of several lines, put together cell by cell.
   pure subroutine stack_by_count(lines, first_line, last, separator, texts)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line, last
      character, intent(in) :: separator
      type(text_type), allocatable, intent(out) :: texts(:)
      type(row_type) :: row
      integer :: line, i, length
      allocate (texts(0))
      do line = first_line, last
         length = content_length(lines(line)%text)
         call split_row(lines(line)%text(:length), separator, row)
         do i = size(texts) + 1, row%count
            call append_text(texts, '')
         end do
         do i = 1, row%count
            call put_beside(texts(i)%text, row%text(row%first(i):row%last(i)))
         end do
      end do
   end subroutine stack_by_count

   pure subroutine put_beside(text, more)
      character(:), allocatable, intent(inout) :: text
      character(*), intent(in) :: more
      if (text /= '' .and. more /= '') then
         text = text//' '//more
      else
         text = text//more
      end if
   end subroutine put_beside

   !> Headings between blanks. By their number where it is that of the row below, with blanks inside of names where two blanks
   !> separate them; else by the place of each word above the numbers.
   subroutine stack_by_place(lines, first_line, last, next_line, layout, texts)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line, last, next_line
      type(layout_type), intent(inout) :: layout
      type(text_type), allocatable, intent(out) :: texts(:)
      type(row_type) :: words, phrases, row, wide_row
      character(:), allocatable :: header, data_text
      integer :: i, data_line
      header = close_brackets(lines(last)%text(:content_length(lines(last)%text)))
      call split_row(header, ' ', words)
      call part_phrases(header, phrases)
      if (first_line == last) then
         call find_example(lines, next_line, words%count, phrases%count, data_line)
      else
         call find_example(lines, next_line, 0, 0, data_line)
      end if
      data_text = ''
      if (data_line > 0) data_text = lines(data_line)%text(:content_length(lines(data_line)%text))
      call split_row(data_text, ' ', row)
      call part_phrases(data_text, wide_row)
      if (data_line > 0) call find_extents(lines, data_line, row%count, layout%extent)
      if (first_line == last) then
         if (words%count == row%count .or. data_line == 0) then
            call take(words)
            return
         else if (phrases%count == row%count) then
            call take(phrases)
            return
         else if (phrases%count == wide_row%count .and. phrases%count > 1) then
            layout%wide = .true.
            deallocate (layout%extent)
            allocate (layout%extent(2, 0))
            call take(phrases)
            return
         end if
      end if
      if (size(layout%extent, 2) == 0 .or. (first_line == last .and. phrases%count < row%count .and. words%count < row%count)) then
         call take(words)
         return
      end if
      allocate (texts(row%count))
      do i = 1, row%count
         texts(i)%text = ''
      end do
      do i = first_line, last
         call put_above(lines(i)%text(:content_length(lines(i)%text)), layout%extent, texts)
      end do

   contains

      subroutine take(fields)
         type(row_type), intent(in) :: fields
         integer :: k
         allocate (texts(fields%count))
         do k = 1, fields%count
            texts(k)%text = fields%text(fields%first(k):fields%last(k))
         end do
         if (fields%count /= size(layout%extent, 2)) then
            deallocate (layout%extent)
            allocate (layout%extent(2, 0))
         end if
      end subroutine take
   end subroutine stack_by_place

   !> Puts each word of a line, brackets with what they hold as one, to the column above which it stands.
   pure subroutine put_above(text, extent, texts)
      character(*), intent(in) :: text
      integer, intent(in) :: extent(:, :)
      type(text_type), intent(inout) :: texts(:)
      integer :: first, last, depth, k, best, apart, nearest
      first = 1
      do while (first <= len(text))
         if (text(first:first) == ' ') then
            first = first + 1
            cycle
         end if
         depth = 0
         last = first
         do while (last <= len(text))
            if (scan(text(last:last), '([') == 1) depth = depth + 1
            if (scan(text(last:last), ')]') == 1) depth = max(depth - 1, 0)
            if (text(last:last) == ' ' .and. depth == 0) exit
            last = last + 1
         end do
         last = last - 1
         best = 1
         nearest = huge(nearest)
         do k = 1, size(extent, 2)
            ! negative where word and column overlap; middles decide between columns that overlap as much
            apart = max(extent(1, k) - last, first - extent(2, k))
            if (apart < 0) apart = -100*(min(last, extent(2, k)) - max(first, extent(1, k)) + 1)
            apart = 1000*apart + abs(first + last - extent(1, k) - extent(2, k))
            if (apart < nearest) best = k
            nearest = min(nearest, apart)
         end do
         call put_beside(texts(best)%text, text(first:last))
         first = last + 1
      end do
   end subroutine put_above
end module dg_survey_header

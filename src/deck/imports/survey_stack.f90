!> Headings of a survey table, put together from the lines of its header.
module dg_survey_stack
   use dg_survey_cells, only: count_numbers, find_extents, part_phrases
   use dg_survey_columns, only: layout_type, no_extent
   use dg_survey_words, only: role_along, role_angle, role_azi, role_corrected, role_datum, role_direction, role_drift, role_grid, &
      role_magnetic, role_measured, role_neutral, role_of, role_plan, role_station, role_total, role_true, role_unit, &
      role_unknown, role_vertical, words_of
   use dg_table_text, only: close_brackets, content_length, split_row
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: stack_by_count, stack_by_place

contains

   !> Find the row below the header whose columns are counted. It has as many fields as the header has words, or phrases. Else
   !> it is the longest with numbers only, else the next.
   subroutine find_example(lines, first_line, words, phrases, line)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line           !< the next row; 0: none
      integer, intent(in) :: words, phrases       !< of the header, on one line; 0: on several
      integer, intent(out) :: line
      type(text_type), allocatable :: row(:)
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
         if (count_numbers(lines(i)%text) == size(row)) rank = 1
         if (size(row) == phrases) rank = 2
         if (size(row) == words) rank = 3
         if (rank < best_rank .or. (rank == best_rank .and. (size(row) <= best .or. rank == 0))) cycle
         best_rank = rank
         best = size(row)
         line = i
      end do
   end subroutine find_example

   !> Headings of several lines, put together cell by cell.
   pure subroutine stack_by_count(lines, first_line, last, separator, texts)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line, last
      character, intent(in) :: separator
      type(text_type), allocatable, intent(out) :: texts(:)
      type(text_type), allocatable :: row(:)
      integer :: line, i, length
      allocate (texts(0))
      do line = first_line, last
         length = content_length(lines(line)%text)
         call split_row(lines(line)%text(:length), separator, row)
         do i = size(texts) + 1, size(row)
            call append_text(texts, '')
         end do
         do i = 1, size(row)
            call place_beside(texts(i)%text, row(i)%text)
         end do
      end do
   end subroutine stack_by_count

   pure subroutine place_beside(text, more)
      character(:), allocatable, intent(inout) :: text
      character(*), intent(in) :: more
      if (text /= '' .and. more /= '') then
         text = text//' '//more
      else
         text = text//more
      end if
   end subroutine place_beside

   !> Stack headings between blanks. If their number is that of the row below, they are taken in order, with blanks inside of
   !> names if two blanks separate them. Else each word goes by its place above the numbers.
   subroutine stack_by_place(lines, first_line, last, next_line, layout, texts)
      type(text_type), intent(in) :: lines(:)
      integer, intent(in) :: first_line, last, next_line
      type(layout_type), intent(inout) :: layout
      type(text_type), allocatable, intent(out) :: texts(:)
      type(text_type), allocatable :: words(:), phrases(:), row(:), wide_row(:)
      character(:), allocatable :: header, data_text
      integer :: i, data_line
      header = close_brackets(lines(last)%text(:content_length(lines(last)%text)), joint=.true.)
      call split_row(header, ' ', words)
      call part_phrases(header, phrases)
      if (first_line == last) then
         call find_example(lines, next_line, size(words), size(phrases), data_line)
      else
         call find_example(lines, next_line, 0, 0, data_line)
      end if
      data_text = ''
      if (data_line > 0) data_text = lines(data_line)%text(:content_length(lines(data_line)%text))
      call split_row(data_text, ' ', row)
      call part_phrases(data_text, wide_row)
      if (data_line > 0) call find_extents(lines, data_line, size(row), layout%extent)
      if (first_line == last) then
         if (size(words) == size(row) .or. data_line == 0) then
            call set_texts(words)
            return
         else if (size(phrases) == size(row)) then
            call set_texts(phrases)
            return
         end if
         call join_words(words)
         if (size(words) == size(row)) then
            call set_texts(words)
            return
         end if
         call split_row(header, ' ', words)
         if (size(phrases) == size(wide_row) .and. size(phrases) > 1) then
            layout%wide = .true.
            layout%extent = no_extent
            call set_texts(phrases)
            return
         end if
      end if
      if (size(layout%extent, 2) == 0 .or. (first_line == last .and. size(phrases) < size(row) .and. size(words) < size(row))) then
         call set_texts(words)
         return
      end if
      allocate (texts(size(row)))
      do i = 1, size(row)
         texts(i)%text = ''
      end do
      do i = first_line, last
         call place_above(lines(i)%text(:content_length(lines(i)%text)), layout%extent, texts)
      end do
      ! single blanks everywhere and a column without heading: the header does not stand above the numbers
      if (first_line == last .and. size(phrases) == 1 .and. any([(texts(i)%text == '', i=1, size(texts))])) call set_texts(words)

   contains

      subroutine set_texts(fields)
         type(text_type), intent(in) :: fields(:)
         texts = fields
         if (size(fields) /= size(layout%extent, 2)) then
            layout%extent = no_extent
         end if
      end subroutine set_texts
   end subroutine stack_by_place

   !> Joins words that make one heading: Measured Depth, Hole Angle, Inc deg.
   subroutine join_words(words)
      type(text_type), allocatable, intent(inout) :: words(:)
      integer, parameter :: modifiers(*) = [role_measured, role_along, role_vertical, role_true, role_grid, role_corrected, &
                                            role_magnetic, role_total, role_station, role_neutral, role_plan]
      character(:), allocatable :: text, word
      type(text_type), allocatable :: parts(:)
      integer :: role, before, i
      text = ''
      before = role_unknown
      do i = 1, size(words)
         word = words(i)%text
         call words_of(word, parts)
         role = role_unknown
         if (size(parts) == 1) role = role_of(parts(1)%text)
         if (scan(word(1:1), '([') == 1) role = role_unit
         if (i > 1 .and. (any(before == modifiers) .or. any(role == [role_unit, role_angle, role_datum]) .or. &
                          (before == role_drift .and. any(role == [role_azi, role_direction])))) then
            text = text//' '//word
         else
            text = text//achar(9)//word
         end if
         before = role
      end do
      call split_row(text(2:), achar(9), words)
   end subroutine join_words

   !> Puts each word of a line, brackets with what they hold as one, to the column above which it stands.
   pure subroutine place_above(text, extent, texts)
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
         call place_beside(texts(best)%text, text(first:last))
         first = last + 1
      end do
   end subroutine place_above
end module dg_survey_stack

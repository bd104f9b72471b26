!> Lists of parts as a user writes them: `3,7-9/40` are parts 3, 7, 8 and 9 of 40.
module dg_part_list
   use dg_text, only: quoted, to_text
   implicit none
   private
   public :: is_count, read_part_list, part_list_text

   !> Most digits of a number of parts.
   integer, parameter :: longest_count = 4

contains

   !> True if a text is a whole number of 1 to 9999.
   pure function is_count(text) result(is)
      character(*), intent(in) :: text
      logical :: is
      is = len(text) >= 1 .and. len(text) <= longest_count .and. verify(text, '0123456789') == 0 .and. verify(text, '0') > 0
   end function is_count

   !> Reads `list/n`: numbers and ranges of 1 to n between commas, each part once. `chosen` has them in ascending order. `failure`
   !> is '' or says what is wrong; then nothing is chosen.
   pure subroutine read_part_list(text, chosen, parts, failure)
      character(*), intent(in) :: text
      integer, allocatable, intent(out) :: chosen(:)
      integer, intent(out) :: parts
      character(:), allocatable, intent(out) :: failure
      logical, allocatable :: is_chosen(:)
      integer :: slash, first, last, i
      allocate (chosen(0))
      parts = 0
      failure = ''
      slash = index(text, '/')
      if (slash == 0) then
         failure = 'it has no /'
      else if (.not. is_count(text(slash + 1:))) then
         failure = quoted(text(slash + 1:))//' is not a number of parts, 1 to 9999'
      end if
      if (failure /= '') return
      read (text(slash + 1:), *) parts
      allocate (is_chosen(parts), source=.false.)
      first = 1
      do while (first <= slash)
         last = first - 2 + scan(text(first:slash), ',/')
         call choose(text(first:last), is_chosen, failure)
         if (failure /= '') return
         first = last + 2
      end do
      chosen = pack([(i, i=1, parts)], is_chosen)
   end subroutine read_part_list

   !> Adds the parts of one number or range.
   pure subroutine choose(text, is_chosen, failure)
      character(*), intent(in) :: text
      logical, intent(inout) :: is_chosen(:)
      character(:), allocatable, intent(inout) :: failure
      integer :: dash, from, to, i
      dash = index(text, '-')
      if (dash == 0) dash = len(text) + 1
      from = 0
      to = 0
      if (is_count(text(:dash - 1))) read (text(:dash - 1), *) from
      if (is_count(text(dash + 1:))) read (text(dash + 1:), *) to
      if (dash > len(text)) to = from
      if (text == '') then
         failure = 'a number lacks'
      else if (from == 0 .or. to == 0) then
         failure = quoted(text)//' is neither a number nor a range'
      else if (from > to) then
         failure = text//' runs backwards'
      else if (to > size(is_chosen)) then
         failure = 'there is no part '//to_text(to)//' of '//to_text(size(is_chosen))
      else
         do i = from, to
            if (is_chosen(i)) then
               failure = 'part '//to_text(i)//' is there twice'
               return
            end if
            is_chosen(i) = .true.
         end do
      end if
   end subroutine choose

   !> Ascending numbers as read_part_list and job arrays of Slurm take them: `3,7-9`; '' of none.
   pure function part_list_text(numbers) result(text)
      integer, intent(in) :: numbers(:)
      character(:), allocatable :: text
      integer :: first, last
      text = ''
      first = 1
      do while (first <= size(numbers))
         last = first
         do while (last < size(numbers))
            if (numbers(last + 1) /= numbers(last) + 1) exit
            last = last + 1
         end do
         if (first > 1) text = text//','
         text = text//to_text(numbers(first))
         if (last > first) text = text//'-'//to_text(numbers(last))
         first = last + 1
      end do
   end function part_list_text
end module dg_part_list

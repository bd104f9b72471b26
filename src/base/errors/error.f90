!> Errors are values: where something is wrong, and a message that says what, how much, and what to do. A class tells the
!> main program its exit status. No procedure below the main program stops.
module dg_error
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   use dg_printable, only: printable
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: error_type, raise, join_error
   public :: status_ok, status_failure, status_bad_input, status_not_converged
   public :: error_list_type, add_fault, add_part_fault, add_unreadable, clear_errors, error_at, is_listed
   public :: part_of, place_of, key_of, other_of, other_place_of, whole_message
   public :: error_text, error_lines, joined_errors, first_errors

   !> Exit statuses of the program (contract of the command line).
   integer, parameter :: status_ok = 0            !< everything asked for was solved
   integer, parameter :: status_failure = 1       !< anything not below: disk full, out of memory
   integer, parameter :: status_bad_input = 2     !< bad command line, deck or data file
   integer, parameter :: status_not_converged = 3 !< at least one case did not converge

   !> A rule knows the part of a model that is wrong; who asked the rule knows the line of a deck, or a program's component.
   type :: error_type
      private
      integer, public :: status = status_failure            !< one of the statuses above
      character(:), allocatable, public :: message          !< what, how much, what to do; where, if nothing below says it
      character(:), allocatable :: where                    !< file, or component of a program's parts
      integer :: line = 0                                   !< of the file; 0: the file as a whole
      ! Of rules alone. Texts have no values here: with -finit-derived gfortran 12 writes a .mod file of them that it cannot read.
      character(12) :: part                                 !< the part that is wrong: the name of its group in a deck
      integer :: place = 0                                  !< of the part among those of its kind; 0: there is one
      character(32) :: key                                  !< which of its quantities: the key in a deck
      character(12) :: other                                !< kind of another part that the message names; '': none
      integer :: other_place = 0                            !< of the other part
      character(:), allocatable :: rest                     !< of the message, behind the name of the other part
   end type error_type

   type :: error_list_type
      integer :: noted = 0                      !< with those that are not kept
      integer :: count = 0
      type(error_type), allocatable :: items(:) !< the first `count` are meant
   end type error_list_type

   integer, parameter :: first_capacity = 8
   !> Errors that a list keeps. An input with more is hardly what it was taken for.
   integer, parameter :: most_errors = 1000
   !> More than a file has lines.
   real(wp), parameter :: beyond_lines = 1.0e9_wp

contains

   !> Raises an error of class `status` with the whole `message`.
   pure subroutine raise(error, status, message)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: status
      character(*), intent(in) :: message
      allocate (error)
      error%status = status
      error%message = message
   end subroutine raise

   !> Joins the message of another error, if there is one, to an error that may be there.
   pure subroutine join_error(error, other)
      type(error_type), allocatable, intent(inout) :: error
      type(error_type), allocatable, intent(in) :: other
      if (.not. allocated(other)) return
      if (allocated(error)) then
         error%message = error%message//'; '//other%message
      else
         error = other
      end if
   end subroutine join_error

   !> Adds an error that stands in a line of a file, or in a component of a program's parts (`line` = 0).
   pure subroutine add_fault(list, where, line, message)
      type(error_list_type), intent(inout) :: list
      character(*), intent(in) :: where
      integer, intent(in) :: line
      character(*), intent(in) :: message
      list%noted = list%noted + 1
      if (list%count == most_errors) return
      call make_room(list)
      list%items(list%count) = error_at(where, line, message)
      if (list%count == most_errors) list%items(list%count)%message = 'too many faults; the first are told'
   end subroutine add_fault

   !> Adds what a rule finds wrong with a part of a model. A message that names another part goes on in `rest` behind its name;
   !> `other`, `other_place` and `rest` go together.
   pure subroutine add_part_fault(list, part, place, key, message, other, other_place, rest)
      type(error_list_type), intent(inout) :: list
      character(*), intent(in) :: part
      integer, intent(in) :: place
      character(*), intent(in) :: key, message
      character(*), intent(in), optional :: other
      integer, intent(in), optional :: other_place
      character(*), intent(in), optional :: rest
      list%noted = list%noted + 1
      if (list%count == most_errors) return
      call make_room(list)
      associate (error => list%items(list%count))
         error%status = status_bad_input
         error%message = message
         error%part = part
         error%place = place
         error%key = key
         error%other = ''
         if (present(other)) error%other = other
         if (present(other_place)) error%other_place = other_place
         if (present(rest)) error%rest = rest
      end associate
   end subroutine add_part_fault

   !> Empties a list.
   pure subroutine clear_errors(list)
      type(error_list_type), intent(inout) :: list
      list%noted = 0
      list%count = 0
   end subroutine clear_errors

   !> Makes room for one error more, and counts it; it is as new.
   pure subroutine make_room(list)
      type(error_list_type), intent(inout) :: list
      type(error_type), allocatable :: longer(:)
      type(error_type) :: new
      if (.not. allocated(list%items)) allocate (list%items(first_capacity))
      if (list%count == size(list%items)) then
         allocate (longer(2*list%count))
         longer(:list%count) = list%items
         call move_alloc(longer, list%items)
      end if
      list%count = list%count + 1
      list%items(list%count) = new
   end subroutine make_room

   !> An error of its own, outside any list. (gfortran 12 loses texts that a structure constructor takes from components.)
   pure function error_at(where, line, message) result(error)
      character(*), intent(in) :: where
      integer, intent(in) :: line
      character(*), intent(in) :: message
      type(error_type) :: error
      error%status = status_bad_input
      error%where = where
      error%line = line
      error%message = message
   end function error_at

   !> Adds that a file cannot be read: where the deck names it, if somebody tells (`asked`: its file, line, group and key).
   pure subroutine add_unreadable(list, path, failure, asked)
      type(error_list_type), intent(inout) :: list
      character(*), intent(in) :: path
      character(*), intent(in) :: failure               !< what keeps it from being read
      type(error_type), intent(in), optional :: asked
      if (present(asked)) then
         call add_fault(list, asked%where, asked%line, asked%message//': '//path//': '//failure)
      else
         call add_fault(list, path, 0, failure)
      end if
   end subroutine add_unreadable

   !> Kind of the part that a rule finds wrong: the name of its group in a deck.
   pure function part_of(error) result(part)
      type(error_type), intent(in) :: error
      character(len(error%part)) :: part
      part = error%part
   end function part_of

   !> Number of this part among those of its kind; 0: there is one.
   pure function place_of(error) result(place)
      type(error_type), intent(in) :: error
      integer :: place
      place = error%place
   end function place_of

   !> Quantity of this part: the key in a deck.
   pure function key_of(error) result(key)
      type(error_type), intent(in) :: error
      character(:), allocatable :: key
      key = trim(error%key)
   end function key_of

   !> Kind of another part that the message of a rule names; '': none.
   pure function other_of(error) result(other)
      type(error_type), intent(in) :: error
      character(len(error%other)) :: other
      other = error%other
   end function other_of

   !> Number of the other part.
   pure function other_place_of(error) result(place)
      type(error_type), intent(in) :: error
      integer :: place
      place = error%other_place
   end function other_place_of

   !> The message of a rule with `mention`, the caller's name of the other part: 'line 12', 'holes(2)'.
   pure subroutine whole_message(error, mention, message)
      type(error_type), intent(in) :: error
      character(*), intent(in) :: mention
      character(:), allocatable, intent(out) :: message
      message = error%message
      if (allocated(error%rest)) message = message//mention//error%rest
   end subroutine whole_message

   !> True where a message of a list has `piece` in it.
   pure function is_listed(list, piece, line) result(yes)
      type(error_list_type), intent(in) :: list
      character(*), intent(in) :: piece
      integer, intent(in), optional :: line    !< of the error; absent: any
      logical :: yes
      integer :: i
      yes = .false.
      do i = 1, list%count
         if (present(line)) then
            if (list%items(i)%line /= line) cycle
         end if
         if (index(list%items(i)%message, piece) > 0) yes = .true.
      end do
   end function is_listed

   !> The places of the errors in the order of their lines, file after file.
   pure function sorted_errors(list) result(order)
      type(error_list_type), intent(in) :: list
      integer, allocatable :: order(:)
      real(wp) :: place(list%count)
      integer :: i, j
      ! files in the order in which they first came up, and lines in them
      do i = 1, list%count
         do j = 1, i
            if (list%items(j)%where == list%items(i)%where) exit
         end do
         place(i) = j*beyond_lines + list%items(i)%line
      end do
      order = sorted_places(place)
   end function sorted_errors

   !> The errors in their order in the files, a line each, as a terminal may show them.
   pure function error_lines(list) result(lines)
      type(error_list_type), intent(in) :: list
      type(text_type), allocatable :: lines(:)
      integer :: order(list%count)
      integer :: i
      order = sorted_errors(list)
      allocate (lines(list%count))
      do i = 1, list%count
         lines(i)%text = printable(error_text(list%items(order(i))), '')
      end do
   end function error_lines

   !> The errors in their order in the files, a line each.
   pure function joined_errors(list) result(text)
      type(error_list_type), intent(in) :: list
      character(:), allocatable :: text
      integer :: order(list%count)
      integer :: i
      text = ''
      order = sorted_errors(list)
      do i = 1, list%count
         if (i > 1) text = text//new_line('a')
         text = text//error_text(list%items(order(i)))
      end do
   end function joined_errors

   !> The errors that were added first, a line each, and the number of the others.
   pure function first_errors(list, most, lead) result(text)
      type(error_list_type), intent(in) :: list
      integer, intent(in) :: most               !< errors that are shown
      character(*), intent(in) :: lead          !< begins each line
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, min(most, list%count)
         if (i > 1) text = text//new_line('a')
         text = text//lead//error_text(list%items(i))
      end do
      if (list%noted > most) text = text//new_line('a')//lead//'and '//to_text(list%noted - most)//' more'
   end function first_errors

   !> WHERE:LINE: message.
   pure function error_text(error) result(text)
      type(error_type), intent(in) :: error
      character(:), allocatable :: text
      text = error%where//':'
      if (error%line > 0) text = text//to_text(error%line)//':'
      text = text//' '//error%message
   end function error_text
end module dg_error

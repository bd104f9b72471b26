!> Lines of a text as it grows.
module dg_line_list
   use dg_text, only: text_type
   implicit none
   private
   public :: line_list_type, add_line, move_lines

   !> The first `count` of `lines` are there. Room doubles, for pictures have tens of thousands of lines.
   type :: line_list_type
      integer :: count = 0
      type(text_type), allocatable :: lines(:)
   end type line_list_type

   integer, parameter :: first_capacity = 64

contains

   !> Add a line at the end.
   pure subroutine add_line(list, text)
      type(line_list_type), intent(inout) :: list
      character(*), intent(in) :: text
      type(text_type), allocatable :: longer(:)
      integer :: i
      if (.not. allocated(list%lines)) allocate (list%lines(first_capacity))
      if (list%count == size(list%lines)) then
         allocate (longer(2*list%count))
         do i = 1, list%count
            call move_alloc(list%lines(i)%text, longer(i)%text)
         end do
         call move_alloc(longer, list%lines)
      end if
      list%count = list%count + 1
      list%lines(list%count)%text = text
   end subroutine add_line

   !> Moves the lines into an array of their number; the list is empty afterwards.
   pure subroutine move_lines(list, lines)
      type(line_list_type), intent(inout) :: list
      type(text_type), allocatable, intent(out) :: lines(:)
      integer :: i
      allocate (lines(list%count))
      do i = 1, list%count
         call move_alloc(list%lines(i)%text, lines(i)%text)
      end do
      list%count = 0
   end subroutine move_lines
end module dg_line_list

!> Faults of the input, gathered so that one run tells them all.
module dg_fault_list
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   use dg_printable, only: printable
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: fault_type, fault_list_type, add_fault, add_unreadable, fault_at, sorted_faults, fault_text, fault_lines

   type :: fault_type
      character(:), allocatable :: file     !< as the user knows it
      integer :: line = 0                   !< 0: the file as a whole
      character(:), allocatable :: message
   end type fault_type

   type :: fault_list_type
      integer :: noted = 0                      !< with those that are left untold
      integer :: count = 0
      type(fault_type), allocatable :: items(:) !< the first `count` are meant
   end type fault_list_type

   integer, parameter :: first_capacity = 16
   !> A deck with more faults than this is no deck; the rest is left untold.
   integer, parameter :: most_faults = 1000
   !> More than a file has lines.
   real(wp), parameter :: beyond_lines = 1.0e9_wp

contains

   !> Notes one fault.
   pure subroutine add_fault(list, file, line, message)
      type(fault_list_type), intent(inout) :: list
      character(*), intent(in) :: file
      integer, intent(in) :: line
      character(*), intent(in) :: message
      type(fault_type), allocatable :: longer(:)
      list%noted = list%noted + 1
      if (list%count == most_faults) return
      if (.not. allocated(list%items)) allocate (list%items(first_capacity))
      if (list%count == size(list%items)) then
         allocate (longer(2*list%count))
         longer(:list%count) = list%items
         call move_alloc(longer, list%items)
      end if
      list%count = list%count + 1
      list%items(list%count)%file = file
      list%items(list%count)%line = line
      list%items(list%count)%message = message
      if (list%count == most_faults) list%items(list%count)%message = 'too many faults; the first are told'
   end subroutine add_fault

   !> A fault of its own, outside any list. (gfortran 12 loses texts that a structure constructor takes from components.)
   pure function fault_at(file, line, message) result(fault)
      character(*), intent(in) :: file
      integer, intent(in) :: line
      character(*), intent(in) :: message
      type(fault_type) :: fault
      fault%file = file
      fault%line = line
      fault%message = message
   end function fault_at

   !> Notes that a file cannot be read: where the deck names it, if somebody tells (`asked`: its file, line, group and key).
   pure subroutine add_unreadable(list, path, failure, asked)
      type(fault_list_type), intent(inout) :: list
      character(*), intent(in) :: path
      character(*), intent(in) :: failure               !< what keeps it from being read
      type(fault_type), intent(in), optional :: asked
      if (present(asked)) then
         call add_fault(list, asked%file, asked%line, asked%message//': '//path//': '//failure)
      else
         call add_fault(list, path, 0, failure)
      end if
   end subroutine add_unreadable

   !> The faults in the order of their lines, file after file.
   pure function sorted_faults(list) result(faults)
      type(fault_list_type), intent(in) :: list
      type(fault_type), allocatable :: faults(:)
      real(wp) :: place(list%count)
      integer :: i, j
      ! files in the order in which they first came up, and lines in them
      do i = 1, list%count
         do j = 1, i
            if (list%items(j)%file == list%items(i)%file) exit
         end do
         place(i) = j*beyond_lines + list%items(i)%line
      end do
      faults = list%items(sorted_places(place))
   end function sorted_faults

   !> The faults in their order in the files, a line each, as a terminal may show them.
   pure function fault_lines(list) result(lines)
      type(fault_list_type), intent(in) :: list
      type(text_type), allocatable :: lines(:)
      type(fault_type), allocatable :: sorted(:)
      integer :: i
      allocate (sorted, source=sorted_faults(list))
      allocate (lines(size(sorted)))
      do i = 1, size(sorted)
         lines(i)%text = printable(fault_text(sorted(i)), '')
      end do
   end function fault_lines

   !> FILE:LINE: message.
   pure function fault_text(fault) result(text)
      type(fault_type), intent(in) :: fault
      character(:), allocatable :: text
      text = fault%file//':'
      if (fault%line > 0) text = text//to_text(fault%line)//':'
      text = text//' '//fault%message
   end function fault_text
end module dg_fault_list

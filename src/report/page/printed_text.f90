!> Texts that a run keeps for its page: printed tables of which report.html has no other form, and the outcome of its solutions.
module dg_printed_text
   use dg_printable, only: printable
   use dg_run_outcome, only: outcome_type
   use dg_standard_output, only: write_line
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: printed_text_type, print_line, print_lines, print_and_keep

   type :: printed_text_type
      type(text_type), allocatable :: lines(:)   !< in order
      type(outcome_type) :: outcome
   end type printed_text_type

contains

   !> One line to standard output. Names and titles in it may hold what commands a terminal: that does not reach it.
   subroutine print_line(line)
      character(*), intent(in) :: line
      call write_line(printable(line, ''))
   end subroutine print_line

   !> Lines to standard output.
   subroutine print_lines(lines)
      type(text_type), intent(in) :: lines(:)
      integer :: i
      do i = 1, size(lines)
         call print_line(lines(i)%text)
      end do
   end subroutine print_lines

   !> Prints lines and appends them to what is kept.
   subroutine print_and_keep(printed, lines)
      type(printed_text_type), intent(inout) :: printed
      type(text_type), intent(in) :: lines(:)
      integer :: i
      call print_lines(lines)
      if (.not. allocated(printed%lines)) allocate (printed%lines(0))
      do i = 1, size(lines)
         call append_text(printed%lines, lines(i)%text)
      end do
   end subroutine print_and_keep
end module dg_printed_text

!> Messages of the program on standard error.
module dg_diagnostic
   use, intrinsic :: iso_fortran_env, only: error_unit
   use dg_printable, only: printable
   use dg_text, only: text_type
   use dg_version, only: program_name
   implicit none
   private
   public :: report_line, report_lines

contains

   !> A line of its own, with the program's name before it; a message may have more lines.
   subroutine report_line(message)
      character(*), intent(in) :: message
      call write_line(program_name//': '//printable(message, new_line('a')))
   end subroutine report_line

   !> Lines as they are.
   subroutine report_lines(lines)
      type(text_type), intent(in) :: lines(:)
      integer :: i
      do i = 1, size(lines)
         call write_line(lines(i)%text)
      end do
   end subroutine report_lines

   !> Writes a line at once: who follows a log file must not wait for a full buffer. A line that nobody can read is not an error:
   !> the exit status tells, too.
   subroutine write_line(line)
      character(*), intent(in) :: line
      integer :: status
      write (error_unit, '(a)', iostat=status) line
      if (status == 0) flush (error_unit, iostat=status)
      if (status /= 0) return
   end subroutine write_line
end module dg_diagnostic

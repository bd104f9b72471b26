!> Rows of the CSV files that a run left, and numbers of what it printed, for tests that look into them.
module dg_result_rows
   use funit, only: assertEqual
   use dg_file_lines, only: read_lines
   use dg_kinds, only: wp
   use dg_program_run, only: unwrapped
   use dg_text, only: text_type
   implicit none
   private
   public :: lines_of, field, number, value_after

contains

   !> The lines of a file. One that cannot be read fails the test and has empty lines, so that the test comes to its end.
   function lines_of(path) result(lines)
      character(*), intent(in) :: path
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      integer, parameter :: enough = 200     ! more than any test asks for by number
      integer :: i
      call read_lines(path, lines, failure)
      call assertEqual('', failure, message=path)
      if (failure == '') return
      deallocate (lines)
      allocate (lines(enough))
      do i = 1, enough
         lines(i)%text = ''
      end do
   end function lines_of

   !> One field of a row, counted from 1.
   pure function field(line, place) result(text)
      character(*), intent(in) :: line
      integer, intent(in) :: place
      character(:), allocatable :: text
      integer :: i, first
      first = 1
      do i = 1, place - 1
         first = first + index(line(first:), ',')
      end do
      text = line(first:first + index(line(first:)//',', ',') - 2)
   end function field

   !> The number in a field; anything else there fails the test.
   function number(line, place) result(value)
      character(*), intent(in) :: line
      integer, intent(in) :: place
      real(wp) :: value
      character(:), allocatable :: text
      integer :: status
      value = 0.0_wp
      text = field(line, place)
      status = 1
      if (text /= '') read (text, *, iostat=status) value
      call assertEqual(0, status, message='a number in '//line)
   end function number

   !> The number behind words of an output; 0 where they are absent, which fails the test.
   function value_after(output, words) result(value)
      character(*), intent(in) :: output, words
      real(wp) :: value
      character(:), allocatable :: text
      integer :: place, status
      value = 0.0_wp
      allocate (text, source=unwrapped(output))
      place = index(text, words)
      status = 1
      if (place > 0) read (text(place + len(words):), *, iostat=status) value
      call assertEqual(0, status, message=words//' in '//output)
   end function value_after
end module dg_result_rows

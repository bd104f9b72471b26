!> Runs of a whole program, and the numbers that they leave.
module dg_bench_runs
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_child_process, only: child_type, end_child, find_program, start_child, wait_for_child
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: delete_file
   use dg_kinds, only: wp
   use dg_table_text, only: split_fields
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: column_of, folder, out, program_beside, since, time_run

   character(*), parameter :: folder = 'build/bench_program', out = folder//'/out'
   !> A run that takes longer than that is none [s].
   real(wp), parameter :: patience = 600.0_wp

contains

   !> The program that was built with this one; '' where there is none.
   function program_beside() result(path)
      character(:), allocatable :: path
      character(4096) :: own
      logical :: is
      integer :: last
      call get_command_argument(0, own)
      last = index(own, '/', back=.true.)
      if (last == 0) then
         path = find_program('drillgap')
         return
      end if
      path = own(:last)//'drillgap'
      inquire (file=path, exist=is)
      if (is) return
      path = own(:last)//'../app/drillgap'     ! where fpm builds it
      inquire (file=path, exist=is)
      if (.not. is) path = ''
   end function program_beside

   !> Runs a deck quietly on one thread; wall time [s].
   subroutine time_run(program, deck, seconds)
      character(*), intent(in) :: program, deck
      real(wp), intent(out) :: seconds
      type(child_type) :: child
      type(text_type), allocatable :: arguments(:)
      type(error_type), allocatable :: error
      integer(int64) :: start
      call append_text(arguments, deck)
      call append_text(arguments, '--quiet')
      call append_text(arguments, '--threads')
      call append_text(arguments, '1')
      call append_text(arguments, '--output')
      call append_text(arguments, out)
      call delete_file(out//'/summary.csv')
      call system_clock(start)
      call start_child(child, program, arguments, '.', folder//'/told', [character(1) ::], error)
      if (.not. allocated(error)) call wait_for_child(child, patience)
      call end_child(child)
      seconds = since(start)
   end subroutine time_run

   function since(start) result(seconds)
      integer(int64), intent(in) :: start
      real(wp) :: seconds
      integer(int64) :: finish, rate
      call system_clock(finish, rate)
      seconds = real(finish - start, wp)/real(rate, wp)
   end function since

   !> Numbers of a column of a CSV file; empty fields are left out. No numbers where there is no such file or column.
   function column_of(path, name) result(values)
      character(*), intent(in) :: path, name
      real(wp), allocatable :: values(:)
      type(text_type), allocatable :: lines(:), heads(:), fields(:)
      character(:), allocatable :: failure
      real(wp) :: value
      integer :: i, place, status
      allocate (lines(0), values(0))
      call read_lines(path, lines, failure)
      if (size(lines) == 0) return
      call split_fields(lines(1)%text, ',', heads)
      do place = 1, size(heads)
         if (heads(place)%text == name) exit
      end do
      if (place > size(heads)) return
      do i = 2, size(lines)
         call split_fields(lines(i)%text, ',', fields)
         if (size(fields) < place) cycle
         read (fields(place)%text, *, iostat=status) value
         if (status == 0) values = [values, value]
      end do
   end function column_of
end module dg_bench_runs

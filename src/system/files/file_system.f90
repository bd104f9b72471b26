!> Files that appear whole or not at all. They are written under another name in the same folder, then renamed. POSIX rename
!> replaces in one step, and replaces a link instead of following it.
module dg_file_system
   use, intrinsic :: iso_c_binding, only: c_char, c_int
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_c_calls, only: c_getpid
   use dg_error, only: error_type, raise, status_failure
   use dg_file_identity, only: identity_of_link, identity_type
   use dg_system_reason, only: reason_of_failed_write, system_reason
   use dg_text, only: c_text, text_type
   implicit none
   private
   public :: write_text_file, append_lines, rename_file, delete_file, unfinished_name, finished_name, unfinished_suffix

   !> Put behind a file's name while it is being written, with `.PROCESS-TICKS` between: no two writers have one name.
   character(*), parameter :: unfinished_suffix = '.unfinished'
   character(*), parameter :: digits = '0123456789'
   !> Names that are tried until one is free.
   integer, parameter :: tries = 100

   interface
      function c_rename(from, to) result(status) bind(c, name='rename')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: from(*), to(*)
         integer(c_int) :: status
      end function c_rename

      ! not C's remove, which removes folders, too
      function c_unlink(path) result(status) bind(c, name='unlink')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: status
      end function c_unlink
   end interface

contains

   !> Write `lines` as the whole content of the file `path`. On any error (no such folder, no right to write, disk full) a file
   !> of that name stays, and no unfinished file is left.
   subroutine write_text_file(path, lines, error)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: unfinished
      character(256) :: reason
      integer :: unit, status, closing, i
      integer(int64) :: expected, found
      type(identity_type) :: there
      reason = ''
      do i = 1, tries
         unfinished = unfinished_name(path)
         ! 'new': neither a file that is there nor what a link leads to is written over (O_EXCL)
         open (newunit=unit, file=unfinished, action='write', status='new', iostat=status, iomsg=reason)
         if (status == 0) exit
         there = identity_of_link(unfinished)
         if (.not. there%exists) exit
      end do
      if (status /= 0) then
         call raise(error, status_failure, 'cannot write '//path//': '//system_words(reason))
         return
      end if
      expected = 0
      do i = 1, size(lines)
         write (unit, '(a)', iostat=status, iomsg=reason) lines(i)%text
         if (status /= 0) exit
         expected = expected + len(lines(i)%text) + len(new_line('a'))
      end do
      close (unit, iostat=closing)
      ! A full disk cuts the file and raises no status (seen with gfortran 12): the size tells.
      inquire (file=unfinished, size=found)
      if (status /= 0 .or. closing /= 0 .or. found /= expected) then
         if (reason == '') reason = reason_of_failed_write(unfinished)
         call delete_file(unfinished)
         call raise(error, status_failure, 'writing '//path//' failed: '//system_words(reason))
         return
      end if
      call rename_file(unfinished, path, error)
      if (allocated(error)) call delete_file(unfinished)
   end subroutine write_text_file

   !> Append `lines` at the end of a file that is there and no link. `failure` is '' or the system's reason; then some of them may
   !> stand there.
   subroutine append_lines(path, lines, failure)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      character(:), allocatable, intent(out) :: failure
      integer :: unit, status, closing, i
      type(identity_type) :: there
      failure = ''
      there = identity_of_link(path)
      if (there%is_link) then
         failure = 'it is a link'
         return
      end if
      open (newunit=unit, file=path, status='old', position='append', action='write', iostat=status)
      if (status == 0) then
         do i = 1, size(lines)
            write (unit, '(a)', iostat=status) lines(i)%text
            if (status /= 0) exit
         end do
         close (unit, iostat=closing)
         if (status == 0) status = closing
      end if
      if (status == 0) return
      failure = reason_of_failed_write(path)
      if (failure == '') failure = 'it failed once'
   end subroutine append_lines

   !> Another name for a file in the same folder while it is being written, other than any given before.
   function unfinished_name(path) result(name)
      character(*), intent(in) :: path
      character(:), allocatable :: name
      character(24) :: process, ticks
      integer(int64) :: now
      call system_clock(now)
      write (process, '(i0)') c_getpid()
      write (ticks, '(i0)') now
      name = path//'.'//trim(process)//'-'//trim(ticks)//unfinished_suffix
   end function unfinished_name

   !> The name that a file was to have; '' where `name` is none of an unfinished file.
   pure function finished_name(name) result(finished)
      character(*), intent(in) :: name
      character(:), allocatable :: finished
      integer :: last, dash, dot
      finished = ''
      last = len(name) - len(unfinished_suffix)
      if (last < 1) return
      if (name(last + 1:) /= unfinished_suffix) return
      dash = index(name(:last), '-', back=.true.)
      dot = index(name(:last), '.', back=.true.)
      if (dot < 2 .or. dash < dot + 2 .or. dash == last) return
      if (verify(name(dot + 1:dash - 1), digits) > 0 .or. verify(name(dash + 1:last), digits) > 0) return
      finished = name(:dot - 1)
   end function finished_name

   !> The run-time library's reason without the path that it repeats. Without a reason the file was shorter at its end than the
   !> data written.
   pure function system_words(reason) result(words)
      character(*), intent(in) :: reason
      character(:), allocatable :: words
      words = trim(adjustl(reason(index(reason, ': ', back=.true.) + 1:)))
      if (words == '') words = 'the file is cut short'
   end function system_words

   !> Gives a file another name, replacing a file of that name.
   subroutine rename_file(from, to, error)
      character(*), intent(in) :: from
      character(*), intent(in) :: to
      type(error_type), allocatable, intent(out) :: error
      if (c_rename(c_text(from), c_text(to)) /= 0) &
         call raise(error, status_failure, 'cannot rename '//from//' to '//to//': '//system_reason())
   end subroutine rename_file

   !> Removes a file; nothing happens where there is none.
   subroutine delete_file(path)
      character(*), intent(in) :: path
      integer(c_int) :: status
      status = c_unlink(c_text(path))
      if (status /= 0) return ! absent, or not ours to remove: nothing that a caller could do about it
   end subroutine delete_file
end module dg_file_system

!> Holds a folder for one run, so that no two write their results into it side by side.
!>
!> The kernel holds the lock, which ends with the process in any case. It is on a file in the folder. A whole run locks all of
!> it. A part of a divided run locks one byte of its own, so that parts share the folder. Such locks (POSIX, lockf) work over
!> NFS, and are not inherited by child processes. They are lost when this process closes any descriptor of the file, so that no
!> other code may open it. The lines of the file name the holder of the folder.
module dg_folder_lock
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_int, c_long, c_null_char, c_null_ptr, c_ptr, c_size_t
   use dg_c_calls, only: c_fopen, c_fclose, c_errno_location, c_getpid, c_write
   use dg_error, only: error_type, raise, status_failure
   use dg_file_identity, only: identity_of, identity_of_link, identity_of_open, identity_type, is_same_file
   use dg_file_lines, only: read_lines
   use dg_file_system, only: delete_file
   use dg_folder, only: refuse_writing
   use dg_text, only: c_text, text_type, to_text
   implicit none
   private
   public :: folder_lock_type, lock_name, lock_folder, release_folder

   !> Name of the file, in the folder.
   character(*), parameter :: lock_name = 'drillgap.lock'

   type :: folder_lock_type
      private
      type(c_ptr) :: file = c_null_ptr
      character(:), allocatable :: path
   end type folder_lock_type

   !> F_TLOCK of unistd.h (locks or says that somebody else has), SEEK_SET of stdio.h.
   integer(c_int), parameter :: try_lock = 2_c_int, from_start = 0_c_int
   !> Errors of lockf where another process holds the lock (EACCES, EAGAIN of Linux).
   integer(c_int), parameter :: held_by_other(2) = [13_c_int, 11_c_int]
   !> All bytes of a file, however long it gets.
   integer(c_long), parameter :: whole_file = 0_c_long
   !> Parts of a division have bytes of their own: more than the most parts (9999) lie between divisions.
   integer(c_long), parameter :: bytes_of_division = 10000_c_long
   !> A run that is about to end gives the folder free within this many tries, that long apart [us]. One that has just begun has
   !> entered its name in the file by the last of most_tries.
   integer, parameter :: tries = 10, most_tries = 50
   integer(c_int), parameter :: pause = 20000_c_int
   integer, parameter :: longest_host = 256
   !> In the line of a holder: `process 123 on HOST since TIME, WHAT`.
   character(*), parameter :: of_process = 'process ', of_host = ' on ', of_time = ' since '

   interface
      function c_fileno(file) result(descriptor) bind(c, name='fileno')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: file
         integer(c_int) :: descriptor
      end function c_fileno

      function c_ftruncate(descriptor, length) result(status) bind(c, name='ftruncate')
         import :: c_int, c_long
         implicit none
         integer(c_int), value :: descriptor
         integer(c_long), value :: length
         integer(c_int) :: status
      end function c_ftruncate

      function c_lseek(descriptor, offset, whence) result(place) bind(c, name='lseek')
         import :: c_int, c_long
         implicit none
         integer(c_int), value :: descriptor
         integer(c_long), value :: offset
         integer(c_int), value :: whence
         integer(c_long) :: place
      end function c_lseek

      function c_lockf(descriptor, command, length) result(status) bind(c, name='lockf')
         import :: c_int, c_long
         implicit none
         integer(c_int), value :: descriptor, command
         integer(c_long), value :: length
         integer(c_int) :: status
      end function c_lockf

      function c_usleep(microseconds) result(status) bind(c, name='usleep')
         import :: c_int
         implicit none
         integer(c_int), value :: microseconds
         integer(c_int) :: status
      end function c_usleep

      function c_gethostname(name, length) result(status) bind(c, name='gethostname')
         import :: c_char, c_int, c_size_t
         implicit none
         character(kind=c_char), intent(out) :: name(*)
         integer(c_size_t), value :: length
         integer(c_int) :: status
      end function c_gethostname
   end interface

contains

   !> Takes the folder, which is there, for a whole run (`parts` = 0) or for one part of a divided one. An error (failure) where
   !> another run has it: it says who. `note` is '' or says that the file system knows no locks; the folder is then taken
   !> all the same.
   subroutine lock_folder(folder, part, parts, lock, note, error)
      character(*), intent(in) :: folder
      integer, intent(in) :: part, parts
      type(folder_lock_type), intent(out) :: lock
      character(:), allocatable, intent(out) :: note
      type(error_type), allocatable, intent(out) :: error
      integer(c_long) :: offset, length
      type(identity_type) :: there
      integer(c_int) :: number, status
      character(:), allocatable :: who
      integer :: attempt
      note = ''
      who = ''
      lock%path = folder//'/'//lock_name
      offset = 0_c_long
      length = whole_file
      if (parts > 0) then
         offset = parts*bytes_of_division + part
         length = 1_c_long
      end if
      do attempt = 1, most_tries
         there = identity_of_link(lock%path)
         if (there%exists .and. .not. there%is_regular) then
            call raise(error, status_failure, 'cannot lock the output folder: '//lock%path//' is not a file; remove it')
            return
         end if
         lock%file = c_fopen(c_text(lock%path), c_text('a+e'))       ! 'e': not for child processes
         if (.not. c_associated(lock%file)) then
            if (there%exists) then
               call raise(error, status_failure, 'cannot lock the output folder '//folder//': '//lock_name//' there cannot be '// &
                          'opened for writing; where no run is under way, remove it')
            else
               call refuse_writing(folder, error)
            end if
            return
         end if
         call lock_bytes(lock%file, offset, length, number)
         if (number == 0) then
            ! the run before may have removed the file after it was opened here
            if (is_same_file(identity_of_open(c_fileno(lock%file)), identity_of_link(lock%path))) then
               call sign(lock%file, part, parts)
               return
            end if
         else if (.not. any(number == held_by_other)) then
            note = 'note: the file system of '//folder//' knows no locks; see to it that no other run writes there'
            call close_file(lock)
            call delete_file(lock%path)
            return
         end if
         call close_file(lock)
         if (attempt >= tries) who = holders(lock%path, part, parts)
         if (who /= '') exit
         status = c_usleep(pause)
         if (status /= 0) cycle          ! woken by a signal
      end do
      if (who == '') who = 'one that has just begun or ended'
      call raise(error, status_failure, 'the output folder '//folder//' is in use by another run: '//who// &
                 '; wait for its end, or give another folder by --output')
   end subroutine lock_folder

   !> Gives the folder free. The last one removes the file.
   subroutine release_folder(lock)
      type(folder_lock_type), intent(inout) :: lock
      integer(c_int) :: number
      if (.not. c_associated(lock%file)) return
      call lock_bytes(lock%file, 0_c_long, whole_file, number)       ! all of it: nobody else is there, nobody comes
      if (number == 0) then
         if (is_same_file(identity_of_open(c_fileno(lock%file)), identity_of_link(lock%path))) call delete_file(lock%path)
      end if
      call close_file(lock)
   end subroutine release_folder

   !> Locks bytes of a file; `number` is 0 or the error's (errno).
   subroutine lock_bytes(file, offset, length, number)
      use, intrinsic :: iso_c_binding, only: c_f_pointer
      type(c_ptr), intent(in) :: file
      integer(c_long), intent(in) :: offset, length
      integer(c_int), intent(out) :: number
      integer(c_int), pointer :: told
      integer(c_long) :: place
      number = 0_c_int
      place = c_lseek(c_fileno(file), offset, from_start)
      if (place == offset) then
         if (c_lockf(c_fileno(file), try_lock, length) == 0_c_int) return
      end if
      call c_f_pointer(c_errno_location(), told)
      number = told
   end subroutine lock_bytes

   !> Says in the file who holds the folder. What dead runs have left there goes as soon as nobody else is there.
   subroutine sign(file, part, parts)
      type(c_ptr), intent(in) :: file
      integer, intent(in) :: part, parts
      character(:), allocatable :: line
      character(8) :: day
      character(6) :: time
      integer(c_long) :: written
      integer(c_int) :: status
      if (parts == 0) status = c_ftruncate(c_fileno(file), 0_c_long)
      call date_and_time(date=day, time=time)
      line = of_process//to_text(int(c_getpid()))//of_host//host()//of_time//day(:4)//'-'//day(5:6)//'-'//day(7:8)//' '// &
         time(:2)//':'//time(3:4)//':'//time(5:6)//mark_of(part, parts)//new_line('a')
      written = c_write(c_fileno(file), line, int(len(line), c_size_t))     ! at its end, as it was opened
      if (written < len(line)) return          ! the lock holds without
   end subroutine sign

   pure function mark_of(part, parts) result(mark)
      integer, intent(in) :: part, parts
      character(:), allocatable :: mark
      mark = ''
      if (parts > 0) mark = ', part '//to_text(part)//' of '//to_text(parts)
   end function mark_of

   !> Who is in the way, as their lines say: those whose process is no more are left out; '' where there is no line.
   function holders(path, part, parts) result(text)
      character(*), intent(in) :: path
      integer, intent(in) :: part, parts
      character(:), allocatable :: text
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      integer :: i
      logical :: in_the_way
      call read_lines(path, lines, failure)
      text = ''
      do i = 1, size(lines)
         associate (line => lines(i)%text)
            if (index(line, of_process) /= 1) cycle
            in_the_way = parts == 0 .or. index(line, ', part ') == 0
            if (.not. in_the_way) in_the_way = index(line//';', mark_of(part, parts)//';') > 0
            if (.not. in_the_way .or. is_gone(line)) cycle
            if (text /= '') text = text//'; '
            text = text//line
         end associate
      end do
   end function holders

   !> True if a line is that of a process of this machine that has ended.
   function is_gone(line) result(gone)
      character(*), intent(in) :: line
      logical :: gone
      type(identity_type) :: process
      integer :: at
      at = index(line, of_host)
      gone = .false.
      if (at <= len(of_process) .or. index(line, of_host//host()//of_time) == 0) return
      if (verify(line(len(of_process) + 1:at - 1), '0123456789') /= 0) return
      process = identity_of('/proc/'//line(len(of_process) + 1:at - 1))
      gone = .not. process%exists
   end function is_gone

   !> Name of this machine.
   function host() result(name)
      character(:), allocatable :: name
      character(kind=c_char) :: chars(longest_host)
      integer :: length
      name = ''
      chars = c_null_char
      if (c_gethostname(chars, int(longest_host - 1, c_size_t)) /= 0_c_int) return
      length = findloc(chars, c_null_char, dim=1) - 1
      name = transfer(chars(:length), repeat(' ', length))
   end function host

   subroutine close_file(lock)
      type(folder_lock_type), intent(inout) :: lock
      integer(c_int) :: status
      status = c_fclose(lock%file)
      lock%file = c_null_ptr
      if (status /= 0) return            ! nothing was left in its buffer
   end subroutine close_file
end module dg_folder_lock

!> Reads a text file into lines, or the first bytes of any file.
module dg_file_lines
   use, intrinsic :: iso_fortran_env, only: int64, iostat_end
   use dg_file_identity, only: identity_of, identity_type
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: read_lines, file_begin, folder_of, beside

   character(*), parameter :: carriage_return = achar(13), line_feed = achar(10)
   !> Mark that some editors put before a text in UTF-8.
   character(*), parameter :: byte_order_mark = char(239)//char(187)//char(191)
   !> First bytes of UTF-16, which spreadsheets write as 'Unicode text'.
   character(*), parameter :: wide_little = char(255)//char(254), wide_big = char(254)//char(255)
   !> Names of what the shell has opened for the program: `drillgap /dev/stdin`, `drillgap <(make_deck)`.
   character(*), parameter :: standard_input = '/dev/stdin', open_files = '/dev/fd/'
   integer, parameter :: first_capacity = 256
   !> Of a file that is read in pieces [bytes].
   integer, parameter :: block_length = 65536
   !> More is no text that somebody wrote: a device, a picture, a table without line ends.
   integer, parameter :: longest_line = 100000, most_lines = 5000000

contains

   !> All lines of a file, without line ends (LF, CR LF or CR). Where that fails `lines` is empty and `failure`
   !> says why; else `failure` is ''. A pipe or a device is refused, because to read it can wait without end.
   subroutine read_lines(path, lines, failure, piped)
      character(*), intent(in) :: path
      type(text_type), allocatable, intent(out) :: lines(:)
      character(:), allocatable, intent(out) :: failure
      logical, intent(in), optional :: piped   !< a pipe that the shell has opened is read (open_files)
      integer(int64) :: bytes
      integer :: count

      failure = ''
      allocate (lines(first_capacity))
      count = 0
      call check_kind(path, piped, failure)
      bytes = 0
      if (failure == '') inquire (file=path, size=bytes)
      if (failure == '') call read_blocks(path, bytes, lines, count, failure)
      if (failure /= '') count = 0
      call resize(lines, count)
      if (count > 0) then
         if (index(lines(1)%text, byte_order_mark) == 1) lines(1)%text = lines(1)%text(len(byte_order_mark) + 1:)
         if (index(lines(1)%text, wide_little) == 1 .or. index(lines(1)%text, wide_big) == 1) then
            failure = 'cannot be read (its text is UTF-16; save it as UTF-8)'
            call resize(lines, 0)
         end if
      end if
   end subroutine read_lines

   !> The first bytes of a file, at most `most`; '' where it is empty, no file, or cannot be read. Pipes and devices are not read.
   function file_begin(path, most) result(begin)
      character(*), intent(in) :: path
      integer, intent(in) :: most
      character(:), allocatable :: begin
      type(identity_type) :: found
      integer(int64) :: bytes
      integer :: unit, status
      begin = ''
      found = identity_of(path)
      if (.not. (found%exists .and. found%is_regular)) return
      inquire (file=path, size=bytes)
      if (bytes <= 0) return
      open (newunit=unit, file=path, status='old', action='read', access='stream', form='unformatted', iostat=status)
      if (status /= 0) return
      begin = repeat(' ', int(min(bytes, int(most, int64))))
      read (unit, iostat=status) begin
      close (unit)
      if (status /= 0) begin = ''
   end function file_begin

   !> Refuses what is no file. A path that leads nowhere is left to `open`, which knows the reason.
   subroutine check_kind(path, piped, failure)
      character(*), intent(in) :: path
      logical, intent(in), optional :: piped
      character(:), allocatable, intent(inout) :: failure
      type(identity_type) :: found
      found = identity_of(path)
      if (.not. found%exists .or. found%is_regular) return
      if (found%is_folder) then
         failure = 'cannot be read (it is a folder)'
      else if (found%is_pipe) then
         if (present(piped)) then
            if (piped .and. (path == standard_input .or. index(path, open_files) == 1)) return
         end if
         failure = 'cannot be read (it is a pipe; give a file)'
      else
         failure = 'cannot be read (it is a device; give a file)'
      end if
   end subroutine check_kind

   !> A file of known size in large pieces; one without, as a pipe or a file of /proc, letter by letter to its end.
   subroutine read_blocks(path, bytes, lines, count, failure)
      character(*), intent(in) :: path
      integer(int64), intent(in) :: bytes         !< its size; 0: not known
      type(text_type), allocatable, intent(inout) :: lines(:)
      integer, intent(inout) :: count
      character(:), allocatable, intent(inout) :: failure
      character(block_length) :: piece
      character(:), allocatable :: begun          ! a line that goes on in the next piece
      character(256) :: message
      integer(int64) :: done
      integer :: unit, status, length, first, i
      logical :: after_return
      open (newunit=unit, file=path, status='old', action='read', access='stream', form='unformatted', iostat=status, &
            iomsg=message)
      if (status /= 0) then
         failure = 'cannot be opened ('//reason(message)//')'
         return
      end if
      begun = ''
      after_return = .false.
      done = 0
      do while ((bytes <= 0 .or. done < bytes) .and. failure == '')
         length = 1
         if (bytes > 0) length = int(min(int(block_length, int64), bytes - done))
         read (unit, iostat=status, iomsg=message) piece(:length)
         if (bytes <= 0 .and. status == iostat_end) exit
         if (status /= 0) then
            failure = 'cannot be read ('//reason(message)//')'
            exit
         end if
         done = done + length
         first = 1
         do i = 1, length
            if (piece(i:i) /= line_feed .and. piece(i:i) /= carriage_return) cycle
            if (after_return .and. piece(i:i) == line_feed .and. i == first) then
               first = i + 1       ! the second half of CR LF
               after_return = .false.
               cycle
            end if
            if (len(begun) == 0) then
               call add_line(piece(first:i - 1), lines, count, failure)
            else
               call add_line(begun//piece(first:i - 1), lines, count, failure)
               begun = ''
            end if
            if (failure /= '') exit
            first = i + 1
            after_return = piece(i:i) == carriage_return
         end do
         if (failure /= '') exit
         if (first <= length) then
            begun = begun//piece(first:length)
            after_return = .false.
         end if
         if (len(begun) > longest_line) call add_line(begun, lines, count, failure)
      end do
      if (failure == '' .and. len(begun) > 0) call add_line(begun, lines, count, failure)
      close (unit)
   end subroutine read_blocks

   !> Add one more line to the others, unless it or their number is beyond all measure.
   subroutine add_line(line, lines, count, failure)
      character(*), intent(in) :: line
      type(text_type), allocatable, intent(inout) :: lines(:)
      integer, intent(inout) :: count
      character(:), allocatable, intent(inout) :: failure
      if (len(line) > longest_line) then
         failure = 'cannot be read (line '//to_text(count + 1)//' has more than '//to_text(longest_line)//' characters)'
      else if (count == most_lines) then
         failure = 'cannot be read (more than '//to_text(most_lines)//' lines)'
      end if
      if (failure /= '') return
      if (count == size(lines)) call resize(lines, 2*count)
      count = count + 1
      lines(count)%text = line
   end subroutine add_line

   !> Gives a list another length; the texts are moved, not copied.
   subroutine resize(lines, length)
      type(text_type), allocatable, intent(inout) :: lines(:)
      integer, intent(in) :: length
      type(text_type), allocatable :: other(:)
      integer :: i
      if (size(lines) == length) return
      allocate (other(length))
      do i = 1, min(length, size(lines))
         call move_alloc(lines(i)%text, other(i)%text)
      end do
      call move_alloc(other, lines)
   end subroutine resize

   !> Reason of a failure by the processor's message, without the path that it repeats.
   pure function reason(message) result(text)
      character(*), intent(in) :: message
      character(:), allocatable :: text
      integer :: colon
      colon = index(message, ': ', back=.true.)
      text = trim(message(colon + merge(2, 1, colon > 0):))
   end function reason

   !> Folder part of a path, with its slash; '' where there is none.
   pure function folder_of(path) result(folder)
      character(*), intent(in) :: path
      character(:), allocatable :: folder
      folder = path(:index(path, '/', back=.true.))
   end function folder_of

   !> `name` as seen from the folder of the file `path`; an absolute name stays as it is.
   pure function beside(path, name) result(full)
      character(*), intent(in) :: path
      character(*), intent(in) :: name
      character(:), allocatable :: full
      full = name
      if (index(name, '/') /= 1) full = folder_of(path)//name
   end function beside
end module dg_file_lines

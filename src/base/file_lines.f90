!> Reads a text file into lines.
module dg_file_lines
   use, intrinsic :: iso_fortran_env, only: iostat_end, iostat_eor
   use dg_folder, only: is_folder
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: read_lines, folder_of, beside

   character(*), parameter :: carriage_return = achar(13)
   !> Mark that some editors put before a text in UTF-8.
   character(*), parameter :: byte_order_mark = char(239)//char(187)//char(191)
   !> First bytes of UTF-16, which spreadsheets write as 'Unicode text'.
   character(*), parameter :: wide_little = char(255)//char(254), wide_big = char(254)//char(255)
   integer, parameter :: first_capacity = 256
   integer, parameter :: chunk_length = 512
   !> More is no text that somebody wrote: a device, a picture, a table without line ends.
   integer, parameter :: longest_line = 100000, most_lines = 5000000

contains

   !> All lines of a file, without line ends (LF or CR LF). Where that fails `lines` is empty and `failure`
   !> says why; else `failure` is ''.
   subroutine read_lines(path, lines, failure)
      character(*), intent(in) :: path
      type(text_type), allocatable, intent(out) :: lines(:)
      character(:), allocatable, intent(out) :: failure
      type(text_type), allocatable :: longer(:)
      character(:), allocatable :: line
      character(256) :: message
      integer :: unit, status, count, i
      logical :: last

      failure = ''
      allocate (lines(first_capacity))
      count = 0
      if (is_folder(path)) then
         failure = 'cannot be read (it is a folder)'
         lines = lines(:0)
         return
      end if
      open (newunit=unit, file=path, status='old', action='read', form='formatted', iostat=status, iomsg=message)
      if (status /= 0) then
         failure = 'cannot be opened ('//reason(message)//')'
         lines = lines(:0)
         return
      end if
      do
         call read_line(unit, line, last, status, message)
         if (status /= 0) then
            failure = 'cannot be read ('//reason(message)//')'
            exit
         end if
         if (last .and. len(line) == 0) exit
         if (len(line) > longest_line) then
            failure = 'cannot be read (line '//to_text(count + 1)//' has more than '//to_text(longest_line)//' characters)'
         else if (count == most_lines) then
            failure = 'cannot be read (more than '//to_text(most_lines)//' lines)'
         end if
         if (failure /= '') exit
         if (count == size(lines)) then
            allocate (longer(2*count))
            do i = 1, count
               call move_alloc(lines(i)%text, longer(i)%text)
            end do
            call move_alloc(longer, lines)
         end if
         count = count + 1
         call move_alloc(line, lines(count)%text)
         if (last) exit
      end do
      close (unit)
      if (failure /= '') count = 0
      lines = lines(:count)
      if (count > 0) then
         if (index(lines(1)%text, byte_order_mark) == 1) lines(1)%text = lines(1)%text(len(byte_order_mark) + 1:)
         if (index(lines(1)%text, wide_little) == 1 .or. index(lines(1)%text, wide_big) == 1) then
            failure = 'cannot be read (its text is UTF-16; save it as UTF-8)'
            lines = lines(:0)
         end if
      end if
   end subroutine read_lines

   !> One line of any length; `last` where the file ends with it.
   subroutine read_line(unit, line, last, status, message)
      integer, intent(in) :: unit
      character(:), allocatable, intent(out) :: line
      logical, intent(out) :: last
      integer, intent(out) :: status      !< 0, or the processor's number of an error other than the end
      character(*), intent(inout) :: message
      character(chunk_length) :: chunk
      integer :: length
      line = ''
      last = .false.
      do
         length = 0
         read (unit, '(a)', advance='no', size=length, iostat=status, iomsg=message) chunk
         line = line//chunk(:length)
         if (status == iostat_eor .or. len(line) > longest_line) exit
         if (status == iostat_end) then
            last = .true.
            exit
         end if
         if (status /= 0) return
      end do
      status = 0
      if (len(line) > 0) then
         if (line(len(line):) == carriage_return) line = line(:len(line) - 1)
      end if
   end subroutine read_line

   !> What the processor says of a failure, without the path that it repeats.
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

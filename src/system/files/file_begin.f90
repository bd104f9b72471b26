!> The first bytes of a file, whatever it holds.
module dg_file_begin
   use dg_file_identity, only: identity_of, identity_type
   implicit none
   private
   public :: file_begin

contains

   !> The first bytes of a file, at most `most`; '' where it is empty, no file, or cannot be read. Pipes and devices are not read.
   function file_begin(path, most) result(begin)
      character(*), intent(in) :: path
      integer, intent(in) :: most
      character(:), allocatable :: begin
      type(identity_type) :: found
      integer :: unit, status, length
      begin = ''
      found = identity_of(path)
      if (.not. (found%exists .and. found%is_regular)) return
      inquire (file=path, size=length)
      if (length <= 0) return
      open (newunit=unit, file=path, status='old', action='read', access='stream', form='unformatted', iostat=status)
      if (status /= 0) return
      begin = repeat(' ', min(length, most))
      read (unit, iostat=status) begin
      close (unit)
      if (status /= 0) begin = ''
   end function file_begin
end module dg_file_begin

!> Which file a path leads to, as the system knows it: two paths may name one file, by links or by '..'.
module dg_file_identity
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int16_t, c_int32_t, c_int64_t, c_long, c_null_char, c_size_t
   use dg_text, only: c_text
   implicit none
   private
   public :: identity_type, identity_of, identity_of_link, identity_of_open, is_same_file, link_target

   type :: identity_type
      logical :: exists = .false.
      logical :: is_regular = .false.        !< a file: no folder, device, pipe, link
      logical :: is_folder = .false.
      logical :: is_pipe = .false.           !< with a name in a folder or without
      logical :: is_link = .false.           !< symbolic
      integer(c_int64_t) :: inode = 0
      integer(c_int32_t) :: device(2) = 0    !< major and minor number
   end type identity_type

   !> struct statx of Linux, the same on all its processors (statx(2)). Of stat(2) every one has its own.
   type, bind(c) :: statx_type
      integer(c_int32_t) :: mask, block_size
      integer(c_int64_t) :: attributes
      integer(c_int32_t) :: links, user, group
      integer(c_int16_t) :: mode, unused
      integer(c_int64_t) :: inode, size, blocks, attributes_mask
      integer(c_int64_t) :: times(8)
      integer(c_int32_t) :: special_major, special_minor, major, minor
      integer(c_int64_t) :: rest(14)
   end type statx_type

   !> AT_FDCWD, AT_SYMLINK_NOFOLLOW and AT_EMPTY_PATH of fcntl.h; STATX_TYPE + STATX_INO of linux/stat.h.
   integer(c_int), parameter :: from_here = -100_c_int, not_through_links = 256_c_int, of_descriptor = 4096_c_int
   integer(c_int), parameter :: type_and_inode = 257_c_int
   !> Kinds of files in the mode (S_IFMT, S_IFREG, S_IFDIR, S_IFLNK, S_IFIFO of sys/stat.h).
   integer, parameter :: kind_mask = 61440, kind_regular = 32768, kind_folder = 16384, kind_link = 40960, kind_pipe = 4096

   !> Longest path of Linux (PATH_MAX).
   integer, parameter :: longest_path = 4096

   interface
      function c_statx(descriptor, path, flags, mask, found) result(status) bind(c, name='statx')
         import :: c_char, c_int, statx_type
         implicit none
         integer(c_int), value :: descriptor
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: flags, mask
         type(statx_type), intent(out) :: found
         integer(c_int) :: status
      end function c_statx

      function c_readlink(path, target, room) result(length) bind(c, name='readlink')
         import :: c_char, c_long, c_size_t
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         character(kind=c_char), intent(out) :: target(*)
         integer(c_size_t), value :: room
         integer(c_long) :: length
      end function c_readlink
   end interface

contains

   !> The file to which a path leads, through links. Blanks at the end of a path do not count, as in `open`.
   function identity_of(path) result(identity)
      character(*), intent(in) :: path
      type(identity_type) :: identity
      identity = asked(from_here, c_text(trim(path)), 0_c_int)
   end function identity_of

   !> Identity of a path itself: of the link where it is one.
   function identity_of_link(path) result(identity)
      character(*), intent(in) :: path
      type(identity_type) :: identity
      identity = asked(from_here, c_text(trim(path)), not_through_links)
   end function identity_of_link

   !> The file behind a descriptor; none where that is closed.
   function identity_of_open(descriptor) result(identity)
      integer(c_int), intent(in) :: descriptor
      type(identity_type) :: identity
      identity = asked(descriptor, [c_null_char], of_descriptor)
   end function identity_of_open

   function asked(descriptor, path, flags) result(identity)
      integer(c_int), intent(in) :: descriptor
      character(kind=c_char), intent(in) :: path(:)
      integer(c_int), intent(in) :: flags
      type(identity_type) :: identity
      type(statx_type) :: found
      integer :: kind_of_file
      identity%exists = c_statx(descriptor, path, flags, type_and_inode, found) == 0_c_int
      if (.not. identity%exists) return
      kind_of_file = iand(int(found%mode), kind_mask)
      identity%is_regular = kind_of_file == kind_regular
      identity%is_folder = kind_of_file == kind_folder
      identity%is_link = kind_of_file == kind_link
      identity%is_pipe = kind_of_file == kind_pipe
      identity%inode = found%inode
      identity%device = [found%major, found%minor]
   end function asked

   !> Where a link leads, as it has it; '' where `path` is no link.
   function link_target(path) result(target)
      character(*), intent(in) :: path
      character(:), allocatable :: target
      character(kind=c_char) :: chars(longest_path)
      integer :: length
      length = max(0, int(c_readlink(c_text(trim(path)), chars, int(longest_path, c_size_t))))
      target = transfer(chars(:length), repeat(' ', length))
   end function link_target

   !> True if both exist and are one file.
   elemental function is_same_file(one, other) result(is)
      type(identity_type), intent(in) :: one, other
      logical :: is
      is = one%exists .and. other%exists .and. one%inode == other%inode .and. one%device(1) == other%device(1) .and. &
           one%device(2) == other%device(2)
   end function is_same_file
end module dg_file_identity

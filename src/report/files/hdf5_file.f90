!> An HDF5 file as it is written: groups, columns of numbers, attributes. The only module that uses HDF5's library.
!>
!> Errors are sticky: after the first one nothing more is done, and closing the file reports the first failure. A file is
!> written under another name and takes its own when it is complete.
module dg_hdf5_file
   use, intrinsic :: iso_c_binding, only: c_char, c_loc, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   use hdf5, only: h5_integer_kind, h5_real_kind, h5aclose_f, h5acreate_f, h5awrite_f, h5close_f, h5dcreate_f, &
                   h5dont_atexit_f, &
                   h5dwrite_f, h5eset_auto_f, h5f_acc_excl_f, h5f_libver_latest_f, h5f_libver_v18_f, h5fclose_f, &
                   h5fcreate_f, h5fflush_f, h5f_scope_local_f, h5gcreate_f, h5kind_to_type, &
                   h5oclose_f, h5oopen_f, h5open_f, h5p_crt_order_indexed_f, h5p_crt_order_tracked_f, h5p_dataset_create_f, &
                   h5p_file_access_f, h5p_group_create_f, h5pclose_f, h5pcreate_f, h5pset_chunk_f, h5pset_deflate_f, &
                   h5pset_libver_bounds_f, h5pset_link_creation_order_f, h5pset_shuffle_f, h5s_scalar_f, h5sclose_f, &
                   h5screate_f, h5screate_simple_f, h5t_cset_utf8_f, h5t_fortran_s1, h5t_ieee_f64le, h5t_std_i32le, &
                   h5t_std_i64le, h5t_std_u8le, h5t_string, h5tclose_f, h5tcopy_f, &
                   h5tset_cset_f, h5tset_size_f, hid_t, hsize_t, size_t
   use dg_error, only: error_type, raise, status_failure
   use dg_file_system, only: delete_file, rename_file, unfinished_name
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_system_reason, only: reason_of_failed_write
   use dg_text, only: c_text
   implicit none
   private
   public :: hdf5_file_type, create_hdf5, close_hdf5, make_group, write_data, write_bytes, write_attribute, write_ascii

   type :: hdf5_file_type
      private
      integer(hid_t) :: id = -1
      character(:), allocatable :: path        !< name that it is to have
      character(:), allocatable :: unfinished  !< name that it has as long as it is written
      character(:), allocatable :: failure     !< what failed first; '' while all is well
      ! The open object: repeated searches for it cost more than an attribute.
      integer(hid_t) :: object = -1            !< group or dataset that is open; < 0: none
      character(:), allocatable :: object_path !< its path
      integer(hid_t) :: text = -1              !< type of a text in UTF-8 of any length
   end type hdf5_file_type

   !> Write numbers as a dataset at a path, of rank 1, or 2 with the rows of the file as second dimension here. Numbers
   !> that are missing become NaN.
   interface write_data
      module procedure write_reals, write_vectors, write_integers, write_long_integers
   end interface write_data

   !> Write an attribute on the group or dataset at a path.
   interface write_attribute
      module procedure attribute_text, attribute_real, attribute_integer, attribute_reals, attribute_integers
   end interface write_attribute

   !> Up to so many numbers a dataset is stored as it is: to compress 64 kB costs more than it saves.
   integer, parameter :: most_plain = 8192
   !> Rows of a chunk: 128 kB of numbers.
   integer, parameter :: chunk_rows = 16384
   !> Of deflate, 1 to 9: more costs much and gains little.
   integer, parameter :: deflate_level = 4
   !> Mark of a missing number: a quiet NaN (IEEE 754).
   real(wp), parameter :: not_a_number = transfer(int(z'7FF8000000000000', int64), 1.0_wp)

contains

   !> Begin a file. A failure is reported by close_hdf5.
   subroutine create_hdf5(file, path)
      type(hdf5_file_type), intent(out) :: file
      character(*), intent(in) :: path
      integer(hid_t) :: access
      integer :: status
      file%path = path
      file%unfinished = unfinished_name(path)
      file%failure = ''
      call h5dont_atexit_f(status)           ! after a file that failed its clean-up at the end of the program crashes (1.10)
      call h5open_f(status)
      call check(file, status, 'starting the HDF5 library')
      if (file%failure /= '') return
      call h5eset_auto_f(0, status)          ! its own messages mean nothing to a user
      call h5pcreate_f(h5p_file_access_f, access, status)
      call check(file, status, 'file access')
      ! From format 1.8 on attributes may be longer than 64 kB: a deck is one.
      call h5pset_libver_bounds_f(access, h5f_libver_v18_f, h5f_libver_latest_f, status)
      call check(file, status, 'file format')
      call h5fcreate_f(file%unfinished, h5f_acc_excl_f, file%id, status, access_prp=access)
      call check(file, status, 'creating the file')
      if (file%failure /= '') file%id = -1
      call h5pclose_f(access, status)
      call h5tcopy_f(h5t_string, file%text, status)
      call h5tset_cset_f(file%text, h5t_cset_utf8_f, status)
   end subroutine create_hdf5

   !> Close a file and give it its name. After any error a file of that name stays, and no unfinished file is left.
   subroutine close_hdf5(file, error)
      type(hdf5_file_type), intent(inout) :: file
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: reason
      integer :: status
      call leave_object(file)
      if (file%text >= 0) call h5tclose_f(file%text, status)
      if (file%id >= 0) then
         call h5fflush_f(file%id, h5f_scope_local_f, status)
         call check(file, status, 'writing to disk')
         call h5fclose_f(file%id, status)
         call check(file, status, 'closing the file')
         file%id = -1
      end if
      call h5close_f(status)
      if (file%failure == '') then
         call rename_file(file%unfinished, file%path, error)
      else
         reason = reason_of_failed_write(file%unfinished)
         if (reason /= '') reason = ': '//reason
         call raise(error, status_failure, 'cannot write '//file%path//': '//file%failure//' failed'//reason)
      end if
      if (allocated(error)) call delete_file(file%unfinished)
   end subroutine close_hdf5

   !> Makes a group; the one above it must be there. Its members keep the order in which they come.
   subroutine make_group(file, group)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      integer(hid_t) :: id, properties
      integer :: status
      if (file%failure /= '') return
      call h5pcreate_f(h5p_group_create_f, properties, status)
      call h5pset_link_creation_order_f(properties, ior(h5p_crt_order_tracked_f, h5p_crt_order_indexed_f), status)
      call h5gcreate_f(file%id, group, id, status, gcpl_id=properties)
      call check(file, status, 'group '//group)
      if (status == 0) call stay_at(file, group, id)
      call h5pclose_f(properties, status)
   end subroutine make_group

   subroutine write_reals(file, path, values, unit)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      real(wp), intent(in) :: values(:)
      real(wp), intent(in), optional :: unit     !< SI value of the unit of the numbers in the file
      real(wp), allocatable, target :: buffer(:)
      allocate (buffer, source=values)
      if (present(unit)) buffer = values/unit
      where (is_missing(values)) buffer = not_a_number
      call write_buffer(file, path, [size(values, kind=hsize_t)], h5t_ieee_f64le, h5kind_to_type(wp, h5_real_kind), &
                        c_loc(buffer))
   end subroutine write_reals

   subroutine write_vectors(file, path, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      real(wp), intent(in), contiguous, target :: values(:, :)
      call write_buffer(file, path, shape(values, kind=hsize_t), h5t_ieee_f64le, h5kind_to_type(wp, h5_real_kind), &
                        c_loc(values))
   end subroutine write_vectors

   subroutine write_integers(file, path, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      integer, intent(in), contiguous, target :: values(:)
      call write_buffer(file, path, [size(values, kind=hsize_t)], h5t_std_i32le, &
                        h5kind_to_type(kind(values), h5_integer_kind), c_loc(values))
   end subroutine write_integers

   subroutine write_long_integers(file, path, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      integer(int64), intent(in), contiguous, target :: values(:)
      call write_buffer(file, path, [size(values, kind=hsize_t)], h5t_std_i64le, &
                        h5kind_to_type(kind(values), h5_integer_kind), c_loc(values))
   end subroutine write_long_integers

   !> Numbers from 0 to 255 as a dataset of bytes.
   subroutine write_bytes(file, path, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      integer, intent(in), contiguous, target :: values(:)
      call write_buffer(file, path, [size(values, kind=hsize_t)], h5t_std_u8le, &
                        h5kind_to_type(kind(values), h5_integer_kind), c_loc(values))
   end subroutine write_bytes

   !> A dataset from memory; chunked and compressed where it is large.
   subroutine write_buffer(file, path, dims, file_type, memory_type, address)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      integer(hsize_t), intent(in) :: dims(:)      !< the last is the number of rows
      integer(hid_t), intent(in) :: file_type, memory_type
      type(c_ptr), intent(in) :: address
      integer(hid_t) :: space, properties, id
      integer(hsize_t) :: chunk(size(dims))
      integer :: status
      if (file%failure /= '') return
      call h5screate_simple_f(size(dims), dims, space, status)
      call h5pcreate_f(h5p_dataset_create_f, properties, status)
      if (product(dims) > most_plain) then
         chunk = dims
         chunk(size(dims)) = min(dims(size(dims)), int(chunk_rows, hsize_t))
         call h5pset_chunk_f(properties, size(chunk), chunk, status)
         call h5pset_shuffle_f(properties, status)
         call h5pset_deflate_f(properties, deflate_level, status)
      end if
      call h5dcreate_f(file%id, path, file_type, space, id, status, dcpl_id=properties)
      call check(file, status, 'dataset '//path)
      if (status == 0) then
         if (all(dims > 0)) call h5dwrite_f(id, memory_type, address, status)
         call check(file, status, 'dataset '//path)
         call stay_at(file, path, id)
      end if
      call h5pclose_f(properties, status)
      call h5sclose_f(space, status)
   end subroutine write_buffer

   !> Text in UTF-8, of any length.
   subroutine attribute_text(file, object, name, text)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name, text
      character(kind=c_char), allocatable, target :: buffer(:)
      type(c_ptr), target :: pointer(1)
      if (file%failure /= '') return
      allocate (buffer, source=c_text(text))
      pointer(1) = c_loc(buffer)
      call attribute_buffer(file, object, name, [integer(hsize_t) ::], file%text, file%text, c_loc(pointer))
   end subroutine attribute_text

   !> Text in ASCII, of fixed length, as VTK's format asks for.
   subroutine write_ascii(file, object, name, text)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name, text
      character(kind=c_char), allocatable, target :: buffer(:)
      integer(hid_t) :: type
      integer :: status
      if (file%failure /= '') return
      allocate (buffer, source=c_text(text))       ! the null behind it is not written
      call h5tcopy_f(h5t_fortran_s1, type, status)
      call h5tset_size_f(type, int(len(text), size_t), status)
      call attribute_buffer(file, object, name, [integer(hsize_t) ::], type, type, c_loc(buffer))
      call h5tclose_f(type, status)
   end subroutine write_ascii

   subroutine attribute_real(file, object, name, value)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name
      real(wp), intent(in) :: value
      real(wp), target :: buffer(1)
      buffer = value
      call attribute_buffer(file, object, name, [integer(hsize_t) ::], h5t_ieee_f64le, h5kind_to_type(wp, h5_real_kind), &
                            c_loc(buffer))
   end subroutine attribute_real

   subroutine attribute_reals(file, object, name, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name
      real(wp), intent(in), contiguous, target :: values(:)
      call attribute_buffer(file, object, name, [size(values, kind=hsize_t)], h5t_ieee_f64le, &
                            h5kind_to_type(wp, h5_real_kind), c_loc(values))
   end subroutine attribute_reals

   subroutine attribute_integer(file, object, name, value)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name
      integer, intent(in) :: value
      integer, target :: buffer(1)
      buffer = value
      call attribute_buffer(file, object, name, [integer(hsize_t) ::], h5t_std_i32le, &
                            h5kind_to_type(kind(value), h5_integer_kind), c_loc(buffer))
   end subroutine attribute_integer

   subroutine attribute_integers(file, object, name, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name
      integer, intent(in), contiguous, target :: values(:)
      call attribute_buffer(file, object, name, [size(values, kind=hsize_t)], h5t_std_i64le, &
                            h5kind_to_type(kind(values), h5_integer_kind), c_loc(values))
   end subroutine attribute_integers

   !> An attribute from memory; a scalar where `dims` is empty.
   subroutine attribute_buffer(file, object, name, dims, file_type, memory_type, address)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: object, name
      integer(hsize_t), intent(in) :: dims(:)
      integer(hid_t), intent(in) :: file_type, memory_type
      type(c_ptr), intent(in) :: address
      integer(hid_t) :: space, id, owner
      integer :: status
      if (file%failure /= '') return
      if (file%object < 0 .or. file%object_path /= object) then
         call h5oopen_f(file%id, object, owner, status)
         call check(file, status, 'attribute '//name//' of '//object)
         if (status /= 0) return
         call stay_at(file, object, owner)
      end if
      if (size(dims) == 0) then
         call h5screate_f(h5s_scalar_f, space, status)
      else
         call h5screate_simple_f(size(dims), dims, space, status)
      end if
      call h5acreate_f(file%object, name, file_type, space, id, status)
      call check(file, status, 'attribute '//name//' of '//object)
      if (status == 0) then
         if (all(dims > 0)) call h5awrite_f(id, memory_type, address, status)
         call check(file, status, 'attribute '//name//' of '//object)
         call h5aclose_f(id, status)
      end if
      call h5sclose_f(space, status)
   end subroutine attribute_buffer

   !> Keeps an object open for what is written to it next; the one before is closed.
   subroutine stay_at(file, path, object)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: path
      integer(hid_t), intent(in) :: object
      call leave_object(file)
      file%object = object
      file%object_path = path
   end subroutine stay_at

   !> Closes the object that is open.
   subroutine leave_object(file)
      type(hdf5_file_type), intent(inout) :: file
      integer :: status
      if (file%object < 0) return
      call h5oclose_f(file%object, status)
      call check(file, status, 'writing '//file%object_path)
      file%object = -1
   end subroutine leave_object

   !> Notes the first thing that failed.
   subroutine check(file, status, what)
      type(hdf5_file_type), intent(inout) :: file
      integer, intent(in) :: status
      character(*), intent(in) :: what
      if (status < 0 .and. file%failure == '') file%failure = what
   end subroutine check
end module dg_hdf5_file

!> The numbers behind a picture: some rows of them for a table, and the file that has all.
module dg_picture_data
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: column_named, column_type, field_list_type, put, put_none
   use dg_contacts_file, only: contact_columns, contact_fields
   use dg_missing, only: is_missing
   use dg_profile_columns, only: profile_columns, profile_values
   implicit none
   private
   public :: picture_data_type, file_data, rows_along, rows_of_contacts

   type :: picture_data_type
      character(:), allocatable :: file                 !< of results
      type(column_type), allocatable :: columns(:)      !< of the rows
      type(field_list_type), allocatable :: rows(:)
   end type picture_data_type

   !> About so many depths of a table are evenly apart.
   integer, parameter :: usual_rows = 20

contains

   !> Of a picture whose table would be long: the file alone.
   pure function file_data(file) result(data)
      character(*), intent(in) :: file
      type(picture_data_type) :: data
      data%file = file
      allocate (data%columns(0), data%rows(0))
   end function file_data

   !> Columns of a profile at depths that are about evenly apart, and where any of them is largest or least.
   pure function rows_along(file, names, result, along) result(data)
      character(*), intent(in) :: file
      character(*), intent(in) :: names(:)              !< of columns of profile_columns, md first
      type(case_result_type), intent(in) :: result      !< with a profile
      type(along_string_type), intent(in) :: along
      type(picture_data_type) :: data
      real(wp) :: values(size(result%profile%md), size(names))
      logical :: shown(size(result%profile%md))
      integer :: i, j, n
      data%file = file
      n = size(result%profile%md)
      shown = .false.
      do i = 0, usual_rows
         shown(minloc(abs(result%profile%md - (result%profile%md(1) + (result%profile%md(n) - result%profile%md(1))*i/ &
                                               usual_rows)), dim=1)) = .true.
      end do
      allocate (data%columns(size(names)))
      do j = 1, size(names)
         data%columns(j) = column_named(profile_columns, trim(names(j)))
         call profile_values(trim(names(j)), result%profile, along, values(:, j))
         associate (known => .not. is_missing(values(:, j)))
            if (.not. any(known)) cycle
            shown(minloc(values(:, j), mask=known, dim=1)) = .true.
            shown(maxloc(values(:, j), mask=known, dim=1)) = .true.
         end associate
      end do
      allocate (data%rows(count(shown)))
      n = 0
      do i = 1, size(shown)
         if (.not. shown(i)) cycle
         n = n + 1
         do j = 1, size(names)
            if (is_missing(values(i, j))) then
               call put_none(data%rows(n))
            else
               call put(data%rows(n), values(i, j))
            end if
         end do
      end do
   end function rows_along

   !> The contacts below a depth [m].
   pure function rows_of_contacts(file, result, from) result(data)
      character(*), intent(in) :: file
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: from
      type(picture_data_type) :: data
      integer :: i, n
      data = file_data(file)
      if (.not. allocated(result%contacts)) return
      data%columns = contact_columns
      deallocate (data%rows)
      allocate (data%rows(count(result%contacts%md >= from)))
      n = 0
      do i = 1, size(result%contacts)
         if (result%contacts(i)%md < from) cycle
         n = n + 1
         call contact_fields(result%contacts(i), data%rows(n))
      end do
   end function rows_of_contacts
end module dg_picture_data

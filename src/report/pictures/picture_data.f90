!> The numbers behind a picture: some rows of them for a table, and the file that has all.
module dg_picture_data
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: row_type
   use dg_solution_series, only: contact_series
   use dg_missing, only: is_missing
   use dg_profile_file, only: profile_series
   use dg_series, only: row_of, series_list_type, series_of
   implicit none
   private
   public :: picture_data_type, picked_rows, rows_along, rows_of_contacts

   type :: picture_data_type
      character(:), allocatable :: file                 !< of results
      type(row_type), allocatable :: rows(:)
      integer :: every = 1                              !< rows of the file a row here
   end type picture_data_type

   !> About so many depths of a table are evenly apart.
   integer, parameter :: usual_rows = 20
   !> Most rows of a table: more make a long page, and nobody reads them there.
   integer, parameter :: most_rows = 200

contains

   !> Begin the numbers of a picture. `rows` are the wanted rows of the file, some two hundred of them, evenly apart. The
   !> caller fills data%rows with them.
   pure subroutine picked_rows(file, wanted, data, rows)
      character(*), intent(in) :: file                  !< in the output folder
      logical, intent(in) :: wanted(:)                  !< rows of the file
      type(picture_data_type), intent(out) :: data
      integer, allocatable, intent(out) :: rows(:)
      integer :: i
      data%file = file
      data%every = max(1, (count(wanted) + most_rows - 1)/most_rows)
      rows = pack([(i, i=1, size(wanted))], wanted)
      rows = rows(::data%every)
      allocate (data%rows(size(rows)))
   end subroutine picked_rows

   !> Columns of a profile at depths that are about evenly apart, and where any of them is largest or least.
   function rows_along(file, names, result, along) result(data)
      character(*), intent(in) :: file
      character(*), intent(in) :: names(:)              !< of columns of a profile, md first
      type(case_result_type), intent(in) :: result      !< with a profile
      type(along_string_type), intent(in) :: along
      type(picture_data_type) :: data
      type(series_list_type) :: whole, list
      logical :: shown(size(result%profile%md))
      integer :: i, j, n
      n = size(result%profile%md)
      shown = .false.
      do i = 0, usual_rows
         shown(minloc(abs(result%profile%md - (result%profile%md(1) + (result%profile%md(n) - result%profile%md(1))*i/ &
                                               usual_rows)), dim=1)) = .true.
      end do
      whole = profile_series(result%profile, along)
      list%count = size(names)
      allocate (list%items(size(names)))
      do j = 1, size(names)
         list%items(j) = series_of(whole, trim(names(j)))
         associate (values => list%items(j)%numbers, known => .not. is_missing(list%items(j)%numbers))
            if (.not. any(known)) cycle
            shown(minloc(values, mask=known, dim=1)) = .true.
            shown(maxloc(values, mask=known, dim=1)) = .true.
         end associate
      end do
      data = shown_rows(file, list, shown)
   end function rows_along

   !> The contacts below a depth [m].
   pure function rows_of_contacts(file, result, from) result(data)
      character(*), intent(in) :: file
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: from
      type(picture_data_type) :: data
      if (allocated(result%contacts)) then
         data = shown_rows(file, contact_series(result%contacts), result%contacts%md >= from)
      else
         data%file = file
         allocate (data%rows(0))
      end if
   end function rows_of_contacts

   !> Those rows of a list of columns.
   pure function shown_rows(file, list, shown) result(data)
      character(*), intent(in) :: file
      type(series_list_type), intent(in) :: list
      logical, intent(in) :: shown(:)
      type(picture_data_type) :: data
      integer :: i, n
      data%file = file
      allocate (data%rows(count(shown)))
      n = 0
      do i = 1, size(shown)
         if (.not. shown(i)) cycle
         n = n + 1
         data%rows(n) = row_of(list, i)
      end do
   end function shown_rows
end module dg_picture_data

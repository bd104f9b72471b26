!> view_<case>_<model>.hdf and hole_<case>_<model>.hdf: string and hole in space, for ParaView (5.11 or later) or VTK (9.2 or
!> later).
!>
!> VTK's own HDF5 format by its documentation, version 1.0: one unstructured grid a file, which every reader since supports.
!> The string is a line through its places, with every column along the string that has values on its points. It is one line
!> from change to change of component, hole section or fluid, so that no line has two points at one place. The hole is a tube.
!> Points are (east, north, up) in the deck's unit of length, so that up is up on the screen. The offset of the string from the
!> hole axis is a vector beside them, which 'Warp By Vector' magnifies.
module dg_paraview_file
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_column, only: column_header
   use dg_constants, only: pi
   use dg_error, only: error_type
   use dg_hdf5_file, only: close_hdf5, create_hdf5, hdf5_file_type, make_group, write_ascii, write_attribute, write_bytes, &
                           write_data
   use dg_job, only: job_type
   use dg_missing, only: is_missing
   use dg_profile, only: profile_type, side_below
   use dg_profile_file, only: profile_series
   use dg_series, only: series_list_type
   use dg_trajectory, only: high_side, tangent_of
   use dg_vector, only: cross
   use dg_unit_kind, only: unit_factor
   implicit none
   private
   public :: write_string_view, write_hole_view, string_offsets, tube_rows

   character(*), parameter :: root = '/VTKHDF', fields = root//'/PointData'
   integer, parameter :: format_version(2) = [1, 0]
   !> Corners of a section of the tube.
   integer, parameter :: sides = 24
   !> Largest turn of the hole between two rings of the tube [rad].
   real(wp), parameter :: ring_angle = 0.02_wp
   !> VTK's numbers of kinds of cells.
   integer, parameter :: line_cell = 4, strip_cell = 6

contains

   !> Writes the string of one result to `path`, as lines with their fields.
   subroutine write_string_view(path, job, profile, along, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(error_type), allocatable, intent(out) :: error
      type(hdf5_file_type) :: file
      type(series_list_type) :: list
      real(wp) :: offset(3, size(profile%md))
      integer(int64) :: i
      integer :: j, n
      n = size(profile%md)
      offset = string_offsets(profile)
      call begin_grid(file, path, to_screen(axis_of(profile) + offset)/job%units%length)
      call write_cells(file, line_cell, [0_int64, pack([(i, i=0_int64, n - 1_int64)], profile%side == side_below), int(n, int64)], &
                       [(i, i=0_int64, n - 1_int64)])
      list = profile_series(profile, along)
      do j = 1, list%count
         associate (series => list%items(j), column => list%items(j)%column)
            if (allocated(series%states)) then
               call write_data(file, fields//'/'//trim(column%name), series%states)
            else if (.not. all(is_missing(series%numbers))) then
               call write_data(file, fields//'/'//column_header(column, job%units), series%numbers, &
                               unit=unit_factor(job%units, column%quantity))
            end if
         end associate
      end do
      call write_data(file, fields//'/offset_'//trim(job%units%length_label), to_screen(offset)/job%units%length)
      call close_hdf5(file, error)
   end subroutine write_string_view

   !> Writes the hole of one result to `path`, as a tube of triangle strips, one a side, with the measured depth on its points.
   subroutine write_hole_view(path, job, profile, along, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(error_type), allocatable, intent(out) :: error
      type(hdf5_file_type) :: file
      integer, allocatable :: rows(:)
      real(wp), allocatable :: points(:, :), md(:)
      integer(int64), allocatable :: corners(:)
      real(wp) :: axis(3, size(profile%md)), high(3), right(3), cosine(sides), sine(sides)
      integer(int64) :: i
      integer :: j, k, n
      allocate (rows, source=tube_rows(profile, along%hole_diameter))
      axis = axis_of(profile)
      n = size(rows)
      cosine = cos([(2.0_wp*pi*(j - 1)/sides, j=1, sides)])
      sine = sin([(2.0_wp*pi*(j - 1)/sides, j=1, sides)])
      allocate (points(3, sides*n), md(sides*n), corners(2*sides*n))
      do k = 1, n
         call across(profile, rows(k), high, right)
         do j = 1, sides
            points(:, (k - 1)*sides + j) = axis(:, rows(k)) + &
                                           0.5_wp*along%hole_diameter(rows(k))*(cosine(j)*high + sine(j)*right)
            md((k - 1)*sides + j) = profile%md(rows(k))
            corners(2*n*(j - 1) + 2*k - 1) = int(k - 1, int64)*sides + j - 1
            corners(2*n*(j - 1) + 2*k) = int(k - 1, int64)*sides + mod(j, sides)
         end do
      end do
      call begin_grid(file, path, to_screen(points)/job%units%length)
      call write_cells(file, strip_cell, [(2*n*i, i=0_int64, int(sides, int64))], corners)
      call write_data(file, fields//'/md_'//trim(job%units%length_label), md, unit=job%units%length)
      call close_hdf5(file, error)
   end subroutine write_hole_view

   !> Begins a file with head and points of its grid, and the room for its fields.
   subroutine begin_grid(file, path, points)
      type(hdf5_file_type), intent(out) :: file
      character(*), intent(in) :: path
      real(wp), intent(in) :: points(:, :)
      call create_hdf5(file, path)
      call make_group(file, root)
      call write_attribute(file, root, 'Version', format_version)
      call write_ascii(file, root, 'Type', 'UnstructuredGrid')
      call write_data(file, root//'/NumberOfPoints', [size(points, 2, kind=int64)])
      call write_data(file, root//'/Points', points)
      call make_group(file, fields)
   end subroutine begin_grid

   !> The cells of a grid, all of one kind.
   subroutine write_cells(file, kind_of_cells, offsets, connectivity)
      type(hdf5_file_type), intent(inout) :: file
      integer, intent(in) :: kind_of_cells            !< line_cell, strip_cell
      integer(int64), intent(in) :: offsets(:)        !< of each cell in `connectivity`, from 0, and their end
      integer(int64), intent(in) :: connectivity(:)   !< numbers of points, from 0
      integer :: kinds(size(offsets) - 1)
      kinds = kind_of_cells
      call write_data(file, root//'/NumberOfCells', [size(kinds, kind=int64)])
      call write_data(file, root//'/NumberOfConnectivityIds', [size(connectivity, kind=int64)])
      call write_bytes(file, root//'/Types', kinds)
      call write_data(file, root//'/Offsets', offsets)
      call write_data(file, root//'/Connectivity', connectivity)
   end subroutine write_cells

   !> Points of the hole axis, north-east-down [m].
   pure function axis_of(profile) result(axis)
      type(profile_type), intent(in) :: profile
      real(wp) :: axis(3, size(profile%md))
      axis(1, :) = profile%north
      axis(2, :) = profile%east
      axis(3, :) = profile%tvd
   end function axis_of

   !> Offset of the string from the hole axis, north-east-down [m]: displacement at the clock angle (convention 4).
   pure function string_offsets(profile) result(offset)
      type(profile_type), intent(in) :: profile
      real(wp) :: offset(3, size(profile%md))
      real(wp) :: high(3), right(3)
      integer :: i
      do i = 1, size(profile%md)
         call across(profile, i, high, right)
         offset(:, i) = profile%displacement(i)*(cos(profile%clock(i))*high + sin(profile%clock(i))*right)
      end do
   end function string_offsets

   !> Unit vectors across the hole at a row: to the high side (north where vertical), and to its right looking down.
   pure subroutine across(profile, row, high, right)
      type(profile_type), intent(in) :: profile
      integer, intent(in) :: row
      real(wp), intent(out) :: high(3), right(3)
      real(wp) :: tangent(3)
      tangent = tangent_of(profile%inclination(row), profile%azimuth(row))
      high = high_side(tangent)
      right = cross(tangent, high)
   end subroutine across

   !> Rows at which the tube has a ring: ends, changes of diameter, and as often as the hole turns. Of two rows at one depth both
   !> have one where the diameter changes.
   pure function tube_rows(profile, diameter) result(rows)
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: diameter(:)    !< of the hole at each row [m]
      integer, allocatable :: rows(:)
      real(wp) :: last(3), here(3)
      logical :: kept(size(diameter))
      integer :: i
      kept = .false.
      last = tangent_of(profile%inclination(1), profile%azimuth(1))
      do i = 2, size(diameter)
         here = tangent_of(profile%inclination(i), profile%azimuth(i))
         if (abs(diameter(i) - diameter(i - 1)) > 0.0_wp) kept(i - 1:i) = .true.
         if (norm2(here - last) > ring_angle) kept(i - 1:i) = .true.
         if (kept(i)) last = here
      end do
      do i = 2, size(diameter)
         if (kept(i - 1) .and. profile%side(i) == side_below .and. .not. abs(diameter(i) - diameter(i - 1)) > 0.0_wp) &
            kept(i) = .false.
      end do
      kept(1) = .true.
      kept(size(kept)) = .true.
      rows = pack([(i, i=1, size(kept))], kept)
   end function tube_rows

   !> North-east-down to east-north-up.
   pure function to_screen(points) result(turned)
      real(wp), intent(in) :: points(:, :)
      real(wp) :: turned(size(points, 1), size(points, 2))
      turned(1, :) = points(2, :)
      turned(2, :) = points(1, :)
      turned(3, :) = -points(3, :)
   end function to_screen
end module dg_paraview_file

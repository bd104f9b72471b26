!> view_<case>_<model>.vtkhdf: string and hole in space, for ParaView (5.12 or later) or VTK (9.3 or later).
!>
!> VTK's own HDF5 format, version 2.1, as its documentation has it: a partitioned data set collection of two blocks of
!> type PolyData. `string` is one line through the places where the string lies, with every column along the string
!> that has values on its points; `hole` is a tube. Points are (east, north, up) in the deck's unit of length, so that up
!> is up on the screen. The offset of the string from the hole axis is kept as a vector beside them: 'Warp By Vector'
!> magnifies it.
module dg_paraview_file
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: column_header, quantity_text, unit_size
   use dg_constants, only: pi
   use dg_error, only: error_type
   use dg_hdf5_file, only: close_hdf5, create_hdf5, hdf5_file_type, make_group, make_link, write_ascii, write_attribute, &
                           write_data
   use dg_job, only: job_type
   use dg_missing, only: is_missing
   use dg_profile, only: profile_type
   use dg_profile_columns, only: profile_codes, profile_columns, profile_values
   use dg_trajectory, only: high_side, tangent_of
   use dg_vector, only: cross
   implicit none
   private
   public :: write_paraview, string_offsets, tube_rows

   character(*), parameter :: root = '/VTKHDF'
   integer, parameter :: format_version(2) = [2, 1]
   !> Corners of a section of the tube.
   integer, parameter :: sides = 24
   !> A ring of the tube may stand no farther along than this turn of the hole [rad].
   real(wp), parameter :: ring_angle = 0.02_wp
   character(*), parameter :: cell_kinds(4) = [character(8) :: 'Vertices', 'Lines', 'Polygons', 'Strips']

contains

   !> Writes one result to `path`.
   subroutine write_paraview(path, job, result, along, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(error_type), allocatable, intent(out) :: error
      type(hdf5_file_type) :: file
      call create_hdf5(file, path)
      call make_group(file, root)
      call write_attribute(file, root, 'Version', format_version)
      call write_ascii(file, root, 'Type', 'PartitionedDataSetCollection')
      call put_string(file, root//'/string', job, result%profile, along)
      call put_hole(file, root//'/hole', job, result%profile, along)
      call make_group(file, root//'/Assembly')
      call make_link(file, root//'/Assembly/string', root//'/string')
      call make_link(file, root//'/Assembly/hole', root//'/hole')
      call close_hdf5(file, error)
   end subroutine write_paraview

   !> The string as one line, with its fields.
   subroutine put_string(file, group, job, profile, along)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(job_type), intent(in) :: job
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      real(wp) :: offset(3, size(profile%md)), values(size(profile%md))
      integer :: codes(size(profile%md))
      integer(int64) :: i
      integer :: j, n
      n = size(profile%md)
      offset = string_offsets(profile)
      call put_block(file, group, 0, to_screen(axis_of(profile) + offset)/job%units%length)
      call put_cells(file, group, 'Lines', [0_int64, int(n, int64)], [(i, i=0_int64, n - 1_int64)])
      call make_group(file, group//'/PointData')
      do j = 1, size(profile_columns)
         associate (column => profile_columns(j))
            if (column%quantity == quantity_text) then
               call profile_codes(trim(column%name), profile, along, codes)
               call write_data(file, group//'/PointData/'//trim(column%name), codes)
            else
               call profile_values(trim(column%name), profile, along, values)
               if (.not. all(is_missing(values))) &
                  call write_data(file, group//'/PointData/'//column_header(column, job%units), values, &
                                  unit=unit_size(column%quantity, job%units))
            end if
         end associate
      end do
      call write_data(file, group//'/PointData/offset_'//trim(job%units%length_label), to_screen(offset)/job%units%length)
   end subroutine put_string

   !> The hole as a tube of triangle strips, one a side, with the measured depth on its points.
   subroutine put_hole(file, group, job, profile, along)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(job_type), intent(in) :: job
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
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
      call put_block(file, group, 1, to_screen(points)/job%units%length)
      call put_cells(file, group, 'Strips', [(2*n*i, i=0_int64, int(sides, int64))], corners)
      call make_group(file, group//'/PointData')
      call write_data(file, group//'/PointData/'//column_header(profile_columns(1), job%units), md, unit=job%units%length)
   end subroutine put_hole

   !> Head and points of a block, with empty lists of every kind of cell but the one that put_cells gives.
   subroutine put_block(file, group, number, points)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      integer, intent(in) :: number            !< of the block, from 0
      real(wp), intent(in) :: points(:, :)
      call make_group(file, group)
      call write_attribute(file, group, 'Version', format_version)
      call write_ascii(file, group, 'Type', 'PolyData')
      call write_attribute(file, group, 'Index', number)
      call write_data(file, group//'/NumberOfPoints', [size(points, 2, kind=int64)])
      call write_data(file, group//'/Points', points)
   end subroutine put_block

   !> The cells of a block, all of one kind.
   subroutine put_cells(file, group, kind_of_cells, offsets, connectivity)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      character(*), intent(in) :: kind_of_cells
      integer(int64), intent(in) :: offsets(:)        !< of each cell in `connectivity`, from 0, and their end
      integer(int64), intent(in) :: connectivity(:)   !< numbers of points, from 0
      character(:), allocatable :: cells
      integer :: i
      do i = 1, size(cell_kinds)
         cells = group//'/'//trim(cell_kinds(i))
         call make_group(file, cells)
         if (cell_kinds(i) == kind_of_cells) then
            call write_data(file, cells//'/NumberOfCells', [size(offsets, kind=int64) - 1])
            call write_data(file, cells//'/NumberOfConnectivityIds', [size(connectivity, kind=int64)])
            call write_data(file, cells//'/Offsets', offsets)
            call write_data(file, cells//'/Connectivity', connectivity)
         else
            call write_data(file, cells//'/NumberOfCells', [0_int64])
            call write_data(file, cells//'/NumberOfConnectivityIds', [0_int64])
            call write_data(file, cells//'/Offsets', [0_int64])
            call write_data(file, cells//'/Connectivity', [integer(int64) ::])
         end if
      end do
   end subroutine put_cells

   !> Points of the hole axis, north-east-down [m].
   pure function axis_of(profile) result(axis)
      type(profile_type), intent(in) :: profile
      real(wp) :: axis(3, size(profile%md))
      axis(1, :) = profile%north
      axis(2, :) = profile%east
      axis(3, :) = profile%tvd
   end function axis_of

   !> Where the string lies off the hole axis, north-east-down [m]: displacement at the clock angle (convention 4).
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

   !> Rows at which the tube has a ring: ends, changes of diameter, and as often as the hole turns.
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

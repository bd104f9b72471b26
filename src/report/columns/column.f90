!> Columns of result files: each is named, given its kind of quantity and described once, and every writer (CSV, HDF5,
!> ParaView) and the check of output/README.md go by that.
module dg_column
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_missing, only: is_missing
   use dg_number_text, only: csv_number, csv_text, put_csv_number
   use dg_load_case, only: optional_real
   use dg_ten_digits, only: longest_number
   use dg_unit_kind, only: unit_curvature, unit_label, unit_moment, unit_wall
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: column_type, field_type, field_list_type, column_header, column_named, unit_text, unit_size
   public :: csv_header, csv_row, put_csv_value, put, put_none
   public :: quantity_none, quantity_text, quantity_length, quantity_width, quantity_angle, quantity_force, quantity_moment, &
             quantity_line_load, quantity_stress, quantity_percent, quantity_turns, quantity_curvature, quantity_time, quantity_wall
   public :: field_absent, field_text, field_integer, field_real

   integer, parameter :: quantity_none = 0       !< a number without unit
   integer, parameter :: quantity_text = 1       !< a text, or a number that stands for one
   integer, parameter :: quantity_length = 2     !< along the hole, or of a position
   integer, parameter :: quantity_width = 3      !< a diameter or a lateral displacement
   integer, parameter :: quantity_angle = 4
   integer, parameter :: quantity_force = 5
   integer, parameter :: quantity_moment = 6
   integer, parameter :: quantity_line_load = 7  !< force per length
   integer, parameter :: quantity_stress = 8     !< stress and pressure
   integer, parameter :: quantity_percent = 9
   integer, parameter :: quantity_turns = 10     !< an angle of many turns
   integer, parameter :: quantity_curvature = 11
   integer, parameter :: quantity_time = 12      !< seconds in both unit systems, not named in the header
   integer, parameter :: quantity_wall = 13      !< stiffness of a wall: force per length and penetration

   type :: column_type
      character(24) :: name = ''
      integer :: quantity = quantity_none
      character(200) :: meaning = ''
   end type column_type

   integer, parameter :: field_absent = 0
   integer, parameter :: field_text = 1
   integer, parameter :: field_integer = 2
   integer, parameter :: field_real = 3

   !> One value of a row of a table; numbers in SI units.
   type :: field_type
      integer :: kind = field_absent
      integer :: integer_value = 0
      real(wp) :: real_value = 0.0_wp
      character(:), allocatable :: text
   end type field_type

   !> A row of a table as it is filled, in the order of its columns.
   type :: field_list_type
      integer :: count = 0
      type(field_type), allocatable :: fields(:)
   end type field_list_type

   !> Puts the next value of a row.
   interface put
      module procedure put_none, put_real, put_integer, put_text, put_optional
   end interface put

contains

   !> Name of a column with its unit, as in the header of a CSV file.
   pure function column_header(column, units) result(header)
      type(column_type), intent(in) :: column
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: header
      header = trim(column%name)
      select case (column%quantity)
      case (quantity_length); header = header//'_'//trim(units%length_label)
      case (quantity_width); header = header//'_'//trim(units%diameter_label)
      case (quantity_angle); header = header//'_deg'
      case (quantity_force); header = header//'_'//trim(units%force_label)
      case (quantity_moment); header = header//'_'//trim(units%moment_label)
      case (quantity_line_load); header = header//'_'//trim(units%force_per_length_label)
      case (quantity_stress); header = header//'_'//trim(units%stress_label)
      case (quantity_percent); header = header//'_pct'
      case (quantity_turns); header = header//'_turns'
      case (quantity_curvature); header = header//'_'//trim(units%curvature_label)
      case (quantity_wall); header = header//'_'//trim(units%wall_stiffness_label)
      case default
      end select
   end function column_header

   !> The column of that name; one without quantity where there is none.
   pure function column_named(columns, name) result(column)
      type(column_type), intent(in) :: columns(:)
      character(*), intent(in) :: name
      type(column_type) :: column
      integer :: i
      column%name = name
      do i = size(columns), 1, -1
         if (columns(i)%name == name) column = columns(i)
      end do
   end function column_named

   !> Unit of a quantity as readers write it; '' where there is none.
   pure function unit_text(quantity, units) result(text)
      integer, intent(in) :: quantity
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      logical :: field
      field = units%name == 'field'
      select case (quantity)
      case (quantity_length); text = trim(units%length_label)
      case (quantity_width); text = trim(units%diameter_label)
      case (quantity_angle); text = 'deg'
      case (quantity_force); text = trim(units%force_label)
      case (quantity_moment); text = unit_label(units, unit_moment)
      case (quantity_line_load); text = 'kN/m'
         if (field) text = 'klbf/ft'
      case (quantity_wall); text = unit_label(units, unit_wall)
      case (quantity_stress); text = trim(units%stress_label)
      case (quantity_percent); text = '%'
      case (quantity_turns); text = 'turns'
      case (quantity_curvature); text = unit_label(units, unit_curvature)
      case (quantity_time); text = 's'
      case default; text = ''
      end select
   end function unit_text

   !> SI value of one unit of a quantity.
   pure function unit_size(quantity, units) result(size)
      integer, intent(in) :: quantity
      type(unit_system_type), intent(in) :: units
      real(wp) :: size
      select case (quantity)
      case (quantity_length); size = units%length
      case (quantity_width); size = units%diameter
      case (quantity_angle); size = units%angle
      case (quantity_force); size = units%force
      case (quantity_moment); size = units%moment
      case (quantity_line_load); size = units%force_per_length
      case (quantity_stress); size = units%stress
      case (quantity_turns); size = 2.0_wp*pi
      case (quantity_curvature); size = units%curvature
      case (quantity_wall); size = units%wall_stiffness
      case default; size = 1.0_wp
      end select
   end function unit_size

   !> The header of a CSV file.
   pure function csv_header(columns, units) result(line)
      type(column_type), intent(in) :: columns(:)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: line
      integer :: i
      line = column_header(columns(1), units)
      do i = 2, size(columns)
         line = line//','//column_header(columns(i), units)
      end do
   end function csv_header

   !> One row of a CSV file; `fields` hold as many values as there are columns.
   pure function csv_row(columns, units, fields) result(line)
      type(column_type), intent(in) :: columns(:)
      type(unit_system_type), intent(in) :: units
      type(field_type), intent(in) :: fields(:)
      character(:), allocatable :: line
      character(longest_number) :: number
      integer :: i, filled
      line = ''
      do i = 1, size(columns)
         if (i > 1) line = line//','
         select case (fields(i)%kind)
         case (field_text); line = line//csv_text(fields(i)%text)
         case (field_integer); line = line//csv_number(fields(i)%integer_value)
         case (field_real)
            filled = 0
            call put_csv_value(number, filled, fields(i)%real_value, unit_size(columns(i)%quantity, units))
            line = line//number(:filled)
         case default
         end select
      end do
   end function csv_row

   !> Puts a number in SI units over the SI value of its unit behind the letters that a row has so far; nothing where it is missing
   !> or beyond all numbers.
   pure subroutine put_csv_value(row, filled, value, unit)
      character(*), intent(inout) :: row      !< with room for `longest_number` letters
      integer, intent(inout) :: filled        !< letters so far
      real(wp), intent(in) :: value, unit
      if (.not. is_missing(value)) call put_csv_number(row, filled, value/unit)
   end subroutine put_csv_value

   !> A number that is not there.
   pure subroutine put_none(row)
      type(field_list_type), intent(inout) :: row
      type(field_type), allocatable :: larger(:)
      integer :: i
      if (.not. allocated(row%fields)) allocate (row%fields(32))
      if (row%count == size(row%fields)) then
         allocate (larger(2*row%count))
         do i = 1, row%count
            larger(i) = row%fields(i)
         end do
         call move_alloc(larger, row%fields)
      end if
      row%count = row%count + 1
      row%fields(row%count)%kind = field_absent   ! a row may be filled again
   end subroutine put_none

   pure subroutine put_real(row, value)
      type(field_list_type), intent(inout) :: row
      real(wp), intent(in) :: value     !< in SI units
      call put_none(row)
      row%fields(row%count)%kind = field_real
      row%fields(row%count)%real_value = value
   end subroutine put_real

   pure subroutine put_integer(row, value)
      type(field_list_type), intent(inout) :: row
      integer, intent(in) :: value
      call put_none(row)
      row%fields(row%count)%kind = field_integer
      row%fields(row%count)%integer_value = value
   end subroutine put_integer

   pure subroutine put_text(row, text)
      type(field_list_type), intent(inout) :: row
      character(*), intent(in) :: text
      call put_none(row)
      row%fields(row%count)%kind = field_text
      row%fields(row%count)%text = text
   end subroutine put_text

   pure subroutine put_optional(row, number)
      type(field_list_type), intent(inout) :: row
      type(optional_real), intent(in) :: number     !< in SI units
      if (number%present) then
         call put_real(row, number%value)
      else
         call put_none(row)
      end if
   end subroutine put_optional
end module dg_column

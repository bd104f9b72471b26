!> Columns of result files: each is named, given its kind of quantity and described once, and every writer (CSV, HDF5,
!> ParaView) and the check of output/README.md go by that.
module dg_column
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_number_text, only: csv_number, csv_text, put_csv_number
   use dg_load_case, only: optional_real
   use dg_ten_digits, only: longest_number
   use dg_quantity, only: quantity_angle, quantity_curvature, quantity_force, quantity_length, quantity_line_load, &
      quantity_moment, quantity_none, quantity_percent, quantity_pressure, quantity_stress, quantity_text, quantity_time, &
      quantity_turns, quantity_wall, quantity_width, unit_type
   use dg_unit_kind, only: unit_factor, unit_label
   use dg_units, only: unit_in, unit_system_type
   implicit none
   private
   public :: column_type, field_type, field_list_type, column_header, column_named, unit_text, unit_size
   public :: csv_header, csv_row, put_csv_value, put, put_none
   public :: quantity_none, quantity_text, quantity_length, quantity_width, quantity_angle, quantity_force, quantity_moment, &
             quantity_line_load, quantity_stress, quantity_pressure, quantity_percent, quantity_turns, quantity_curvature, &
             quantity_time, quantity_wall
   public :: field_absent, field_text, field_integer, field_real

   type :: column_type
      character(32) :: name = ''
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
      type(unit_type) :: unit
      unit = unit_in(units, column%quantity)
      header = trim(column%name)
      if (unit%suffix /= '') header = header//'_'//trim(unit%suffix)
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
      text = unit_label(units, quantity)
   end function unit_text

   !> SI value of one unit of a quantity.
   pure function unit_size(quantity, units) result(size)
      integer, intent(in) :: quantity
      type(unit_system_type), intent(in) :: units
      real(wp) :: size
      size = unit_factor(units, quantity)
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

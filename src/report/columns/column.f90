!> Columns of result files. One statement puts a column into a row: name, quantity, meaning and value. Every writer (CSV, HDF5,
!> Table 1, page) and the check of output/README.md use these rows.
module dg_column
   use, intrinsic :: iso_fortran_env, only: error_unit
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, optional_real
   use dg_number_text, only: csv_text, append_csv_number
   use dg_ten_digits, only: longest_number
   use dg_quantity, only: quantity_angle, quantity_curvature, quantity_force, quantity_length, quantity_line_load, &
      quantity_moment, quantity_none, quantity_percent, quantity_pressure, quantity_stress, quantity_text, quantity_time, &
      quantity_turns, quantity_wall, quantity_width, unit_type
   use dg_text, only: to_text
   use dg_unit_kind, only: unit_factor
   use dg_units, only: unit_in, unit_system_type
   implicit none
   private
   public :: column_type, field_type, row_type, column_header, fields_of, unknown_column
   public :: csv_header, csv_row, add, add_filled
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

   !> A column and its value in one row; numbers in SI units.
   type :: field_type
      type(column_type) :: column
      integer :: kind = field_absent
      integer :: integer_value = 0
      real(wp) :: real_value = 0.0_wp
      character(:), allocatable :: text
   end type field_type

   !> A row of a table in the order of its columns.
   type :: row_type
      integer :: count = 0
      type(field_type), allocatable :: fields(:)     !< with room for more
   end type row_type

   !> Adds the next column to a row, with its value.
   interface add
      module procedure add_real, add_integer, add_text, add_optional
   end interface add

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

   !> Place of the first column of that name. An unknown name ends the program: it is a fault in the sources.
   function place_of(row, name) result(place)
      type(row_type), intent(in) :: row
      character(*), intent(in) :: name
      integer :: place
      place = findloc(row%fields(:row%count)%column%name == name, .true., dim=1)
      if (place == 0) call unknown_column(name)
   end function place_of

   !> A row of the columns of those names. The program ends if one is unknown.
   function fields_of(row, names) result(shown)
      type(row_type), intent(in) :: row
      character(*), intent(in) :: names(:)
      type(row_type) :: shown
      integer :: i
      shown%count = size(names)
      allocate (shown%fields(size(names)))
      do i = 1, size(names)
         shown%fields(i) = row%fields(place_of(row, names(i)))
      end do
   end function fields_of

   !> End the program: a wanted column is in no table.
   subroutine unknown_column(name)
      character(*), intent(in) :: name
      write (error_unit, '(a)') 'no column has the name '//trim(name)
      error stop 1
   end subroutine unknown_column

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

   !> One row of a CSV file.
   pure function csv_row(row, units) result(line)
      type(row_type), intent(in) :: row
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: line
      character(longest_number) :: number
      integer :: i, filled
      line = ''
      do i = 1, row%count
         associate (field => row%fields(i))
            if (i > 1) line = line//','
            select case (field%kind)
            case (field_text); line = line//csv_text(field%text)
            case (field_integer); line = line//to_text(field%integer_value)
            case (field_real)
               filled = 0
               if (.not. is_missing(field%real_value)) call append_csv_number(number, filled, &
                  field%real_value/unit_factor(units, field%column%quantity))
               line = line//number(:filled)
            case default
            end select
         end associate
      end do
   end function csv_row

   !> A column without a value.
   pure subroutine add_none(row, name, quantity, meaning)
      type(row_type), intent(inout) :: row
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      type(field_type), allocatable :: longer(:)
      integer :: i
      if (.not. allocated(row%fields)) allocate (row%fields(32))
      if (row%count == size(row%fields)) then
         allocate (longer(2*row%count))
         do i = 1, row%count
            longer(i) = row%fields(i)
         end do
         call move_alloc(longer, row%fields)
      end if
      row%count = row%count + 1
      row%fields(row%count)%column = column_type(name, quantity, meaning)
   end subroutine add_none

   pure subroutine add_real(row, name, quantity, meaning, value)
      type(row_type), intent(inout) :: row
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      real(wp), intent(in) :: value     !< in SI units, missing where there is none
      call add_optional(row, name, quantity, meaning, optional_real(.not. is_missing(value), value))
   end subroutine add_real

   pure subroutine add_optional(row, name, quantity, meaning, value)
      type(row_type), intent(inout) :: row
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      type(optional_real), intent(in) :: value     !< in SI units
      call add_none(row, name, quantity, meaning)
      if (.not. value%present) return
      row%fields(row%count)%kind = field_real
      row%fields(row%count)%real_value = value%value
   end subroutine add_optional

   pure subroutine add_integer(row, name, quantity, meaning, value)
      type(row_type), intent(inout) :: row
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      integer, intent(in) :: value
      call add_none(row, name, quantity, meaning)
      row%fields(row%count)%kind = field_integer
      row%fields(row%count)%integer_value = value
   end subroutine add_integer

   !> A text, without blanks behind it; no value where it is not allocated.
   pure subroutine add_text(row, name, quantity, meaning, value)
      type(row_type), intent(inout) :: row
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      character(*), intent(in), optional :: value
      call add_none(row, name, quantity, meaning)
      if (.not. present(value)) return
      row%fields(row%count)%kind = field_text
      row%fields(row%count)%text = trim(value)
   end subroutine add_text

   !> A text, or no value where it is ''.
   pure subroutine add_filled(row, name, quantity, meaning, value)
      type(row_type), intent(inout) :: row
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      character(*), intent(in) :: value
      if (value == '') then
         call add_none(row, name, quantity, meaning)
      else
         call add_text(row, name, quantity, meaning, value)
      end if
   end subroutine add_filled
end module dg_column

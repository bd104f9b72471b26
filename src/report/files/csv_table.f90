!> A CSV file as it is filled: the header, then row after row.
module dg_csv_table
   use dg_column, only: column_type, csv_header, csv_row, field_list_type
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_line_list, only: add_line, line_list_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: csv_table_type, begin_table, is_begun, add_row, write_table

   type :: csv_table_type
      private
      type(column_type), allocatable :: columns(:)
      type(unit_system_type) :: units
      type(line_list_type) :: text
   end type csv_table_type

contains

   !> A table without rows.
   pure subroutine begin_table(table, columns, units)
      type(csv_table_type), intent(out) :: table
      type(column_type), intent(in) :: columns(:)
      type(unit_system_type), intent(in) :: units
      allocate (table%columns, source=columns)
      table%units = units
      call add_line(table%text, csv_header(columns, units))
   end subroutine begin_table

   !> Whether a table has its header.
   pure function is_begun(table) result(begun)
      type(csv_table_type), intent(in) :: table
      logical :: begun
      begun = allocated(table%columns)
   end function is_begun

   !> Puts a row at the end: as many values as there are columns, in their order, in SI units.
   pure subroutine add_row(table, row)
      type(csv_table_type), intent(inout) :: table
      type(field_list_type), intent(in) :: row
      call add_line(table%text, csv_row(table%columns, table%units, row%fields))
   end subroutine add_row

   !> Writes a table to a file. Fails where the file cannot be written.
   subroutine write_table(table, path, error)
      type(csv_table_type), intent(in) :: table
      character(*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      call write_text_file(path, table%text%lines(:table%text%count), error)
   end subroutine write_table
end module dg_csv_table

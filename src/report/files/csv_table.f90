!> CSV files: row after row, or columns with all their values.
module dg_csv_table
   use dg_column, only: csv_header, csv_row, row_type
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_line_list, only: add_line, line_list_type
   use dg_series, only: row_of, series_list_type, value_count
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: csv_table_type, begin_table, is_begun, add_row, write_table, write_series

   !> A file as it is filled: the header, then row after row.
   type :: csv_table_type
      private
      type(line_list_type) :: text
   end type csv_table_type

contains

   !> Gives a table the header of such rows, where it has none.
   pure subroutine begin_table(table, row, units)
      type(csv_table_type), intent(inout) :: table
      type(row_type), intent(in) :: row
      type(unit_system_type), intent(in) :: units
      if (.not. is_begun(table)) call add_line(table%text, csv_header(row%fields(:row%count)%column, units))
   end subroutine begin_table

   !> True if a table has its header.
   pure function is_begun(table) result(begun)
      type(csv_table_type), intent(in) :: table
      logical :: begun
      begun = table%text%count > 0
   end function is_begun

   !> Add a row at the end, below the header of the first one.
   pure subroutine add_row(table, row, units)
      type(csv_table_type), intent(inout) :: table
      type(row_type), intent(in) :: row
      type(unit_system_type), intent(in) :: units
      call begin_table(table, row, units)
      call add_line(table%text, csv_row(row, units))
   end subroutine add_row

   !> Writes a table to a file. Fails where the file cannot be written.
   subroutine write_table(table, path, error)
      type(csv_table_type), intent(in) :: table
      character(*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      call write_text_file(path, table%text%lines(:table%text%count), error)
   end subroutine write_table

   !> Writes columns with as many values each to a file. Fails where the file cannot be written.
   subroutine write_series(list, path, units, error)
      type(series_list_type), intent(in) :: list
      character(*), intent(in) :: path
      type(unit_system_type), intent(in) :: units
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: lines(0:value_count(list))
      integer :: i
      lines(0)%text = csv_header(list%items(:list%count)%column, units)
      do i = 1, ubound(lines, 1)
         lines(i)%text = csv_row(row_of(list, i), units)
      end do
      call write_text_file(path, lines, error)
   end subroutine write_series
end module dg_csv_table

!> contacts_<case>_<model>.csv: the concentrated contacts of a string, one row each.
module dg_contacts_file
   use dg_case_result, only: case_result_type, contact_name, contact_point_type
   use dg_column, only: column_type, field_list_type, put, quantity_angle, quantity_force, quantity_length, &
                        quantity_text
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_job, only: job_type
   implicit none
   private
   public :: write_contacts, contact_columns, contact_fields

   !> New ones are added at the end only.
   type(column_type), parameter :: contact_columns(5) = [ &
      column_type('md', quantity_length, 'measured depth of the centroid of the force, of the point before loading'), &
      column_type('force', quantity_force, 'across the hole, of the string on what it touches; of an edge: '// &
         'beyond what weight and tension in a bend press to the wall there'), &
      column_type('length', quantity_length, 'over which it acts; 0 for bit and top'), &
      column_type('clock', quantity_angle, 'where to, as clock in the profiles'), &
      column_type('kind', quantity_text, 'tool joint, stabilizer, centralizer, edge, bit or top')]

contains

   !> Writes the concentrated contacts of `result` to `path`: only the header where there are none.
   subroutine write_contacts(path, job, result, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call begin_table(table, contact_columns, job%units)
      if (allocated(result%contacts)) then
         do i = 1, size(result%contacts)
            call contact_fields(result%contacts(i), row)
            call add_row(table, row)
         end do
      end if
      call write_table(table, path, error)
   end subroutine write_contacts

   !> Values of one contact in the order of the columns.
   pure subroutine contact_fields(contact, row)
      type(contact_point_type), intent(in) :: contact
      type(field_list_type), intent(out) :: row
      call put(row, contact%md)
      call put(row, contact%force)
      call put(row, contact%length)
      call put(row, contact%clock)
      call put(row, trim(contact_name(contact%kind)))
   end subroutine contact_fields
end module dg_contacts_file

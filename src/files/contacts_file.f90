!> contacts_<case>_<model>.csv: the concentrated contacts of a string, one row each.
module dg_contacts_file
   use dg_case_result, only: case_result_type, contact_name, contact_point_type
   use dg_column, only: column_type, csv_header, csv_row, field_list_type, put, quantity_angle, quantity_force, quantity_length, &
                        quantity_text
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type
   use dg_text, only: text_type
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
      type(text_type), allocatable :: lines(:)
      type(field_list_type) :: row
      integer :: i, n
      n = 0
      if (allocated(result%contacts)) n = size(result%contacts)
      allocate (lines(0:n))
      lines(0)%text = csv_header(contact_columns, job%units)
      do i = 1, n
         call contact_fields(result%contacts(i), row)
         lines(i)%text = csv_row(contact_columns, job%units, row%fields)
      end do
      call write_text_file(path, lines, error)
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

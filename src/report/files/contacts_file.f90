!> contacts_<case>_<model>.csv: the concentrated contacts of a string, one row each.
module dg_contacts_file
   use dg_case_result, only: contact_name, contact_point_type
   use dg_column, only: quantity_angle, quantity_force, quantity_length, quantity_text
   use dg_series, only: put, series_list_type
   implicit none
   private
   public :: contact_series

contains

   !> Contacts by column. New columns are put at the end only.
   pure function contact_series(contacts) result(list)
      type(contact_point_type), intent(in) :: contacts(:)
      type(series_list_type) :: list
      call put(list, 'md', quantity_length, 'measured depth of the centroid of the force, of the point before loading', contacts%md)
      call put(list, 'force', quantity_force, &
               'across the hole, of the string on what it touches; of an edge: beyond what weight and tension in a bend '// &
               'press to the wall there', contacts%force)
      call put(list, 'length', quantity_length, 'over which it acts; 0 for bit and top', contacts%length)
      call put(list, 'clock', quantity_angle, 'where to, as clock in the profiles', contacts%clock)
      call put(list, 'kind', quantity_text, &
               'tool joint, stabilizer, centralizer, edge, bit or top', contacts%kind - 1, contact_name)
   end function contact_series
end module dg_contacts_file

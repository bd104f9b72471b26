!> fatigue_<case>_<model>.csv: components of a string that turns, the one that is tired most first.
module dg_fatigue_file
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: column_type, field_list_type, put, quantity_curvature, quantity_length, quantity_none, quantity_percent, &
                        quantity_stress, quantity_text
   use dg_comparison, only: in_percent, known
   use dg_csv_table, only: add_row, begin_table, csv_table_type, write_table
   use dg_error, only: error_type
   use dg_fatigue, only: fatigue_type, find_fatigue
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_load_case, only: optional_real
   use dg_missing, only: is_missing
   use dg_model, only: model_type, string_index
   implicit none
   private
   public :: write_fatigue

   !> New ones are added at the end only.
   type(column_type), parameter :: fatigue_columns(10) = [ &
      column_type('component', quantity_text, 'its name'), &
      column_type('md', quantity_length, 'where it is bent hardest for its tension'), &
      column_type('tension', quantity_stress, 'of the effective axial force'), &
      column_type('amplitude', quantity_stress, 'of the bending stress of the body, largest between tool joints'), &
      column_type('permitted', quantity_stress, 'amplitude that it bears without end at that tension'), &
      column_type('used', quantity_percent, 'amplitude over permitted'), &
      column_type('turns', quantity_none, 'until failure; empty where endless, or where fatigue_exponent is not given'), &
      column_type('damage', quantity_percent, 'part of its life that hours of rotation take at that place; empty without hours'), &
      column_type('dogleg', quantity_curvature, 'of the hole there'), &
      column_type('permitted_dogleg', quantity_curvature, 'largest dogleg in which it may turn without end at that tension')]

contains

   !> Writes what a string that turns makes of its components to `path`.
   subroutine write_fatigue(path, job, model, result, along, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(error_type), allocatable, intent(out) :: error
      type(fatigue_type), allocatable :: parts(:)
      type(csv_table_type) :: table
      type(field_list_type) :: row
      integer :: i
      call find_fatigue(model, result, along, parts)
      call begin_table(table, fatigue_columns, job%units)
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         do i = 1, size(parts)
            call fatigue_fields(string%components(parts(i)%part)%name, parts(i), row)
            call add_row(table, row)
         end do
      end associate
      call write_table(table, path, error)
   end subroutine write_fatigue

   !> Values of one component in the order of the columns.
   pure subroutine fatigue_fields(name, part, row)
      character(*), intent(in) :: name
      type(fatigue_type), intent(in) :: part
      type(field_list_type), intent(out) :: row
      call put(row, name)
      call put(row, part%md)
      call put(row, part%tension)
      call put(row, part%amplitude)
      call put(row, part%permitted)
      call put(row, 100.0_wp*part%used)
      call put(row, optional_real(.not. is_missing(part%turns), part%turns))
      call put(row, in_percent(known(part%damage)))
      call put(row, part%curvature)
      call put(row, optional_real(.not. is_missing(part%dogleg), part%dogleg))
   end subroutine fatigue_fields
end module dg_fatigue_file

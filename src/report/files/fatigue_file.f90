!> fatigue_<case>_<model>.csv: components of a string that turns, the one that is tired most first.
module dg_fatigue_file
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: quantity_curvature, quantity_length, quantity_none, quantity_percent, quantity_stress, quantity_text
   use dg_comparison, only: percent_of
   use dg_csv_table, only: write_series
   use dg_error, only: error_type
   use dg_fatigue, only: fatigue_type, find_fatigue
   use dg_job, only: job_type
   use dg_model, only: model_type, string_index
   use dg_series, only: put, series_list_type
   use dg_text, only: text_type
   implicit none
   private
   public :: write_fatigue

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
      type(text_type), allocatable :: names(:)
      integer :: i
      call find_fatigue(model, result, along, parts)
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         allocate (names(size(string%components)))
         do i = 1, size(names)
            names(i)%text = string%components(i)%name
         end do
      end associate
      call write_series(fatigue_series(parts, names), path, job%units, error)
   end subroutine write_fatigue

   !> Components by column. New columns are put at the end only.
   pure function fatigue_series(parts, names) result(list)
      type(fatigue_type), intent(in) :: parts(:)
      type(text_type), intent(in) :: names(:)     !< of components
      type(series_list_type) :: list
      call put(list, 'component', quantity_text, 'its name', parts%part - 1, names)
      call put(list, 'md', quantity_length, 'where it is bent hardest for its tension', parts%md)
      call put(list, 'tension', quantity_stress, 'of the effective axial force', parts%tension)
      call put(list, 'amplitude', quantity_stress, &
               'of the bending stress of the body, largest between tool joints', parts%amplitude)
      call put(list, 'permitted', quantity_stress, 'amplitude that it bears without end at that tension', parts%permitted)
      call put(list, 'used', quantity_percent, 'amplitude over permitted', percent_of(parts%used))
      call put(list, 'turns', quantity_none, &
               'until failure; empty where endless, or where fatigue_exponent is not given', parts%turns)
      call put(list, 'damage', quantity_percent, &
               'part of its life that hours of rotation take at that place; empty without hours', percent_of(parts%damage))
      call put(list, 'dogleg', quantity_curvature, 'of the hole there', parts%curvature)
      call put(list, 'permitted_dogleg', quantity_curvature, &
               'largest dogleg in which it may turn without end at that tension', parts%dogleg)
   end function fatigue_series
end module dg_fatigue_file

!> casing_wear_<case>_<model>.csv: what a string that turns wears off the casing, one row a depth.
module dg_casing_wear_file
   use dg_case_result, only: case_result_type
   use dg_casing_wear, only: find_casing_wear, groove_type
   use dg_column, only: quantity_length, quantity_line_load, quantity_percent, quantity_pressure, quantity_text, quantity_width
   use dg_comparison, only: percent_of
   use dg_csv_table, only: write_series
   use dg_error, only: error_type
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_series, only: put, series_list_type
   use dg_text, only: text_type
   implicit none
   private
   public :: write_casing_wear

contains

   !> Writes the wear of the casing by `result` to `path`.
   subroutine write_casing_wear(path, job, model, result, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      type(groove_type), allocatable :: grooves(:)
      type(text_type) :: names(size(model%holes))
      integer :: i
      call find_casing_wear(model, result, grooves)
      do i = 1, size(names)
         names(i)%text = model%holes(i)%name
      end do
      call write_series(wear_series(grooves, names), path, job%units, error)
   end subroutine write_casing_wear

   !> Grooves by column. New columns are put at the end only.
   pure function wear_series(grooves, names) result(list)
      type(groove_type), intent(in) :: grooves(:)
      type(text_type), intent(in) :: names(:)      !< of hole sections
      type(series_list_type) :: list
      call put(list, 'md', quantity_length, 'measured depth', grooves%md)
      call put(list, 'hole', quantity_text, 'name of the hole section', grooves%hole - 1, names)
      call put(list, 'side_force', quantity_line_load, 'mean over the distance of two tool joints', grooves%side_force)
      call put(list, 'groove', quantity_width, 'depth of the groove', grooves%depth)
      call put(list, 'wall_left', quantity_percent, 'of the wall as it was new', percent_of(grooves%wall_left))
      call put(list, 'burst_left', quantity_pressure, 'burst strength left; empty where casing_yield is not given', grooves%burst)
      call put(list, 'collapse_left', quantity_pressure, 'collapse strength left, without tension', grooves%collapse)
   end function wear_series
end module dg_casing_wear_file

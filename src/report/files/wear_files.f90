!> Effects of rotation. casing_wear_<case>_<model>.csv has one row per depth. fatigue_<case>_<model>.csv has the components of the
!> string, the most fatigued first.
module dg_wear_files
   use dg_case_result, only: case_result_type
   use dg_casing_wear, only: find_casing_wear, groove_type
   use dg_column, only: quantity_length, quantity_line_load, quantity_percent, quantity_pressure, quantity_text, &
                        quantity_width, quantity_curvature, quantity_none, quantity_stress
   use dg_comparison, only: percent_of
   use dg_csv_table, only: write_series
   use dg_error, only: error_type
   use dg_job, only: job_type
   use dg_model, only: model_type, string_index
   use dg_series, only: add, series_list_type
   use dg_text, only: text_type
   use dg_along_string, only: along_string_type
   use dg_fatigue, only: fatigue_type, find_fatigue
   implicit none
   private
   public :: write_casing_wear, write_fatigue

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
      call add(list, 'md', quantity_length, 'measured depth', grooves%md)
      call add(list, 'hole', quantity_text, 'name of the hole section', grooves%hole - 1, names)
      call add(list, 'side_force', quantity_line_load, &
               'mean side force on the length from one tool joint to the next', grooves%side_force)
      call add(list, 'groove', quantity_width, 'depth of the groove', grooves%depth)
      call add(list, 'wall_left', quantity_percent, 'remaining wall, of the new wall', percent_of(grooves%wall_left))
      call add(list, 'burst_left', quantity_pressure, 'burst strength left; empty where casing_yield is not given', grooves%burst)
      call add(list, 'collapse_left', quantity_pressure, 'collapse strength left, without tension', grooves%collapse)
   end function wear_series

   !> Write the fatigue of the components of a string that turns to `path`.
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
      type(text_type) :: sections(2)
      sections(1)%text = 'body'
      sections(2)%text = 'joint'
      call add(list, 'component', quantity_text, 'its name', parts%part - 1, names)
      call add(list, 'md', quantity_length, 'depth where bending is largest against the permitted bending', parts%md)
      call add(list, 'tension', quantity_stress, 'stress of the effective axial force', parts%tension)
      call add(list, 'amplitude', quantity_stress, &
               'amplitude of the bending stress; of the body the largest between tool joints', parts%amplitude)
      call add(list, 'permitted', quantity_stress, 'endurance limit at that tension', parts%permitted)
      call add(list, 'used', quantity_percent, 'amplitude in percent of permitted', percent_of(parts%used))
      call add(list, 'turns', quantity_none, &
               'turns until failure; empty below the endurance limit, or without fatigue_exponent', parts%turns)
      call add(list, 'damage', quantity_percent, &
               'part of its life used by the hours of rotation; empty without hours', percent_of(parts%damage))
      call add(list, 'dogleg', quantity_curvature, 'dogleg of the hole at this depth', parts%curvature)
      call add(list, 'permitted_dogleg', quantity_curvature, &
               'largest dogleg for rotation without fatigue at that tension', parts%dogleg)
      call add(list, 'section', quantity_text, &
               'body, or joint: connections, with the stress at their outside', merge(1, 0, parts%joint), sections)
   end function fatigue_series
end module dg_wear_files

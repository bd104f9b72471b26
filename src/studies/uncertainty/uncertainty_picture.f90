!> What uncertain data make of hook load and torque against bit depth, from uncertainty_<name>.csv: half of the samples lie below
!> the middle line, a tenth beyond each of the outer ones; what was measured is laid over it.
module dg_uncertainty_picture
   use dg_kinds, only: wp
   use dg_broomstick_panels, only: add_limits, add_measured, broomstick_limits_type, draw_broomstick, start_broomstick
   use dg_column, only: column_header, column_named
   use dg_gnuplot_script, only: add_series, colour_of, dash_of, marked_line_style, results_file, series_type
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_name
   use dg_load_case, only: operation_label, operation_name, rotates
   use dg_rig, only: rig_type
   use dg_sweep, only: at_operation, sweep_type
   use dg_text, only: append_text, text_type
   use dg_uncertainty_file, only: uncertainty_columns
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: uncertainty_script

   character(*), parameter :: quantile(3) = [character(4) :: '_p10', '_p50', '_p90']

contains

   !> One model's curves.
   subroutine uncertainty_script(name, units, range, model, rig, holes, lines)
      character(*), intent(in) :: name      !< of the picture
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: range !< operations and depths
      integer, intent(in) :: model          !< number of the model
      type(rig_type), intent(in) :: rig     !< where it is given hook loads are as it shows them
      type(hole_section_type), intent(in) :: holes(:)
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: key(:), hookload(:), torque(:)
      type(broomstick_limits_type) :: limits
      integer :: i
      call start_broomstick(lines, name)
      call append_text(lines, "pick(operation, value) = stringcolumn('model') eq '"//trim(model_name(model))// &
                       "' && stringcolumn('operation') eq operation ? value : NaN")
      do i = 1, size(range%operations)
         call add_series(key, 'NaN', look(i, 2, 1), trim(operation_label(range%operations(i)))//', P50')
         call add_series(key, 'NaN', look(i, 1, 1), 'P10 and P90')
      end do
      hookload = curves(trim(merge('weight_indicator', 'hookload        ', rig%given)), .false.)
      torque = curves('torque', .true.)
      call add_measured(lines, key, hookload, torque, units, range)
      call add_limits(hookload, torque, limits, units, rig, range, results_file('uncertainty_'//range%name), &
                      column_header(column_named(uncertainty_columns, 'bit_depth'), units))
      call draw_broomstick(lines, 'Uncertainty '//range%name//', model '//trim(model_name(model)), key, units, holes, &
                           range, hookload, torque, limits)

   contains

      !> The curves of one panel; `turning`: only operations that have torque.
      pure function curves(column, turning) result(series)
         character(*), intent(in) :: column
         logical, intent(in) :: turning
         type(series_type), allocatable :: series(:)
         integer :: operation, k
         allocate (series(0))
         do operation = 1, size(range%operations)
            if (turning .and. .not. (rotates(range%operations(operation)) .or. &
                                     abs(at_operation(range%tob, operation)) > 0.0_wp)) cycle
            do k = 1, size(quantile)
               call add_series(series, curve(operation, column//quantile(k)), look(operation, k, size(range%depths)), '')
            end do
         end do
      end function curves

      pure function curve(operation, column) result(using)
         integer, intent(in) :: operation
         character(*), intent(in) :: column
         character(:), allocatable :: using
         using = results_file('uncertainty_'//range%name)//" using (pick('"//trim(operation_name(range%operations(operation)))// &
            "', column('"//column_header(column_named(uncertainty_columns, column), units)//"'))):(column('"// &
            column_header(column_named(uncertainty_columns, 'bit_depth'), units)//"'))"
      end function curve
   end subroutine uncertainty_script

   !> Look of an operation's quantile over so many depths: the middle one whole, with marks, the outer ones dashed.
   pure function look(operation, k, depths) result(text)
      integer, intent(in) :: operation, k, depths
      character(:), allocatable :: text
      if (k == 2) then
         text = marked_line_style(operation, depths, 2.0_wp, dash_of(1))
      else
         text = "with lines lw 1.3 dt (8,4) lc rgb '"//colour_of(operation)//"'"
      end if
   end function look
end module dg_uncertainty_picture

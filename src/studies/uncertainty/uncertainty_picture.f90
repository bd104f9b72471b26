!> Hook load and torque of uncertain data against bit depth. Half of the samples lie below the middle line, a tenth beyond each of
!> the outer ones. Measured values are drawn on top.
module dg_uncertainty_picture
   use dg_kinds, only: wp
   use dg_broomstick_panels, only: add_broomstick_panel, add_measured, add_rig_limits, begin_broomstick, measured_look, &
                                   measured_name, panel_count, turns
   use dg_chart, only: add_key, add_points, chart_type
   use dg_curve_look, only: colour_of, dash_of, marked_line_style
   use dg_job, only: model_name
   use dg_load_case, only: operation_label
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_sample_statistics, only: p10, p50, p90, point_statistics_type
   use dg_sweep, only: point_number, point_type, sweep_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: uncertainty_chart

   character(*), parameter :: quantile_names(p10:p90) = ['P10', 'P50', 'P90']

contains

   !> One model's curves; hook loads as the rig shows them where it is given.
   function uncertainty_chart(units, range, place, model, statistics) result(chart)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: range !< operations and depths
      integer, intent(in) :: place          !< of the model in the range
      type(model_type), intent(in) :: model
      type(point_statistics_type), intent(in) :: statistics(:)      !< of all points
      type(chart_type) :: chart
      character(:), allocatable :: name
      integer :: i, panel
      name = trim(model_name(range%models(place)))
      call begin_broomstick(chart, 'uncertainty_'//range%name//'_'//name, 'Uncertainty '//range%name//', model '//name, units, &
                            range, model%holes)
      do i = 1, size(range%operations)
         call add_key(chart, look(i, p50, 1), trim(operation_label(range%operations(i)))//', P50')
         call add_key(chart, look(i, p10, 1), 'P10 and P90')       ! entry 2 i
      end do
      do i = 1, size(range%operations)
         if (any(range%measured%operation == range%operations(i))) &
            call add_key(chart, measured_look(i), measured_name(range%operations(i)))
      end do
      do panel = 1, panel_count(range)
         call add_broomstick_panel(chart, range, model%rig)
         do i = 1, size(range%operations)
            call add_quantiles(i)
         end do
         call add_measured(chart, range)
         call add_rig_limits(chart, range, model%rig)
      end do

   contains

      !> Quantiles of an operation.
      subroutine add_quantiles(operation)
         integer, intent(in) :: operation      !< its place in the range
         real(wp) :: values(size(range%depths))
         integer :: k, first
         if (panel == 2 .and. .not. turns(range, operation)) return
         first = point_number(range, point_type(place, operation, 1, 1))
         do k = p10, p90
            associate (these => statistics(first:first + size(values) - 1))
               if (panel == 2) then
                  values = these%torque%quantiles(k)
               else if (model%rig%given) then
                  values = these%weight_indicator%quantiles(k)
               else
                  values = these%hookload%quantiles(k)
               end if
            end associate
            where (.not. is_missing(values)) values = values/merge(units%moment, units%force, panel == 2)
            call add_points(chart, transpose(reshape([values, range%depths/units%length], [size(values), 2])), &
                            look(operation, k, size(range%depths)), [2*operation - merge(1, 0, k == p50)], &
                            trim(operation_label(range%operations(operation)))//', '//quantile_names(k))
         end do
      end subroutine add_quantiles
   end function uncertainty_chart

   !> Look of an operation's quantile over so many depths: the middle one whole, with marks, the outer ones dashed.
   pure function look(operation, k, depths) result(text)
      integer, intent(in) :: operation, k, depths
      character(:), allocatable :: text
      if (k == p50) then
         text = marked_line_style(operation, depths, 2.0_wp, dash_of(1))
      else
         text = "with lines lw 1.3 dt (8,4) lc rgb '"//colour_of(operation)//"'"
      end if
   end function look
end module dg_uncertainty_picture

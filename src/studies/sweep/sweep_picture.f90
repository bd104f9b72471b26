!> The broomstick: hook load, and torque where anything turns, against bit depth. An operation is a colour, a friction factor a
!> dash; what was measured is laid over it.
module dg_sweep_picture
   use dg_kinds, only: wp
   use dg_broomstick_panels, only: add_broomstick_panel, add_measured, add_rig_limits, begin_broomstick, measured_look, &
                                   measured_name, panel_count, turns
   use dg_case_result, only: result_converged
   use dg_chart, only: add_curve, add_key, chart_type, curve_type, fit_range, key_of
   use dg_comparison, only: as_measured
   use dg_curve_look, only: colour_black, colour_of, dash_of, marked_line_style, style_count
   use dg_job, only: model_name
   use dg_load_case, only: block_way, operation_label
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_rig, only: indicated_load
   use dg_sweep, only: point_number, point_type, sweep_type
   use dg_sweep_result, only: answer_of, sweep_result_type
   use dg_sweep_sentences, only: friction_text
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_no
   implicit none
   private
   public :: sweep_chart

   integer, parameter :: few = 3
   character(*), parameter :: impossible_name = 'cannot be done', edge_name = 'locked up, or value outside the chart'

contains

   !> One model's curves; hook loads as the rig shows them where it is given.
   function sweep_chart(units, sweep, place, model, points) result(chart)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: place          !< of the model in the sweep
      type(model_type), intent(in) :: model
      type(sweep_result_type), intent(in) :: points(:)      !< of all models
      type(chart_type) :: chart
      character(:), allocatable :: name
      real(wp) :: lowest
      integer :: i, k, n
      n = size(sweep%depths)
      lowest = lowest_shown(sweep, points(first(1, 1):first(1, 1) + n*size(sweep%operations)*size(sweep%frictions) - 1))
      name = trim(model_name(sweep%models(place)))
      call begin_broomstick(chart, 'sweep_'//sweep%name//'_'//name, 'Sweep '//sweep%name//', model '//name, units, sweep, &
                            model%holes)
      do i = 1, size(sweep%operations)
         call add_key(chart, marked_line_style(i, 1, 2.2_wp, dash_of(1)), trim(operation_label(sweep%operations(i))))
         if (any(sweep%measured%operation == sweep%operations(i))) &
            call add_key(chart, measured_look(i), measured_name(sweep%operations(i)))
      end do
      do k = 1, size(sweep%frictions)
         call add_key(chart, 'with lines lw 1.5 dt '//dash_of(k)//" lc rgb '"//colour_black//"'", friction_text(sweep, k))
      end do
      call add_key(chart, impossible_look(style_count), impossible_name)
      call add_broomstick_panel(chart, sweep, model%rig)
      do i = 1, size(sweep%operations)
         do k = 1, size(sweep%frictions)
            call add_hookloads(chart, sweep, i, k, points(first(i, k):first(i, k) + n - 1), lowest)
         end do
      end do
      call add_measured(chart, sweep)
      call add_rig_limits(chart, sweep, model%rig)
      ! by the first operation that pulls, else one that does not go down; other factors put it a hair's breadth beside
      i = maxloc(block_way(sweep%operations), dim=1)
      k = size(sweep%frictions)
      if (block_way(sweep%operations(i)) >= 0) &
         call add_yield(chart, sweep, model, i, k, points(first(i, k):first(i, k) + n - 1))
      call fit_hookloads(chart)
      if (panel_count(sweep) == 1) return
      call add_broomstick_panel(chart, sweep, model%rig)
      do i = 1, size(sweep%operations)
         do k = 1, size(sweep%frictions)
            if (.not. turns(sweep, i)) cycle
            associate (these => points(first(i, k):first(i, k) + n - 1))
               call add_curve(chart, merge(these%torque/units%moment, missing, these%status == result_converged), &
                              sweep%depths/units%length, marked_line_style(i, n, 1.6_wp, dash_of(k)), '', &
                              keys_of(chart, sweep, i, k))
            end associate
         end do
      end do
      call add_measured(chart, sweep)
      call add_rig_limits(chart, sweep, model%rig)

   contains

      !> Number of the first point of an operation with a friction factor.
      pure integer function first(operation, friction)
         integer, intent(in) :: operation, friction
         first = point_number(sweep, point_type(place, operation, friction, 1))
      end function first
   end function sweep_chart

   !> Least hook load that is drawn [N]: as far below zero as the greatest is above, if one is. Much push would hide the others.
   pure function lowest_shown(sweep, points) result(lowest)
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:) !< of the model
      real(wp) :: lowest
      real(wp) :: most
      most = max(maxval(as_measured(points%hookload, points%weight_indicator), mask=points%status == result_converged), &
                 maxval(sweep%measured%hookload%value, mask=sweep%measured%hookload%present))
      lowest = -huge(lowest)
      if (most > 0.0_wp) lowest = -most
   end function lowest_shown

   !> Add hook loads of an operation with a friction factor, and marks where it is impossible. The mark is at the hook load. If
   !> no hook load is drawn, the mark stands at the edge.
   subroutine add_hookloads(chart, sweep, operation, friction, points, lowest)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: operation, friction       !< places in the sweep
      type(sweep_result_type), intent(in) :: points(:) !< over all depths
      real(wp), intent(in) :: lowest                   !< least hook load that is drawn [N]
      real(wp) :: loads(size(points))
      logical :: drawn(size(points)), impossible(size(points))
      loads = as_measured(points%hookload, points%weight_indicator)
      drawn = points%status == result_converged .and. loads >= lowest
      impossible = answer_of(points) == answer_no
      loads = loads/chart%units%force
      associate (depths => sweep%depths/chart%units%length, keys => keys_of(chart, sweep, operation, friction))
         call add_curve(chart, merge(loads, missing, drawn), depths, &
                        marked_line_style(operation, size(depths), 1.6_wp, dash_of(friction)), '', keys)
         call add_marks(impossible .and. drawn, impossible_look(operation), impossible_name)
         if (.not. any(impossible .and. .not. drawn)) return
         if (size(key_of(chart, edge_name)) == 0) call add_key(chart, edge_look(style_count), edge_name)
         call add_marks(impossible .and. .not. drawn, edge_look(operation), edge_name)
         associate (panel => chart%panels(size(chart%panels)))
            panel%curves(size(panel%curves))%sets_axis = .false.
            panel%curves(size(panel%curves))%at_edge = .true.
         end associate
      end associate
   contains
      subroutine add_marks(there, look, name)
         logical, intent(in) :: there(:)
         character(*), intent(in) :: look, name
         call add_curve(chart, pack(loads, there), pack(sweep%depths/chart%units%length, there), look, '', &
                        [keys_of(chart, sweep, operation, friction), key_of(chart, name)])
      end subroutine add_marks
   end subroutine add_hookloads

   !> Set the axis of hook loads by the curves that set it, and marks without a hook load on its lower end.
   pure subroutine fit_hookloads(chart)
      type(chart_type), intent(inout) :: chart
      real(wp), parameter :: air = 0.05_wp, inside = 0.004_wp    ! gnuplot leaves out marks beyond the end
      real(wp) :: ends(2)
      integer :: i
      ends = range_of(chart%panels(size(chart%panels))%curves)
      call fit_range(chart, given=ends + [-air, air]*max(ends(2) - ends(1), 1.0_wp))
      associate (panel => chart%panels(size(chart%panels)))
         do i = 1, size(panel%curves)
            if (panel%curves(i)%at_edge) panel%curves(i)%points(1, :) = (1.0_wp - inside)*panel%x%ends(1) + inside*panel%x%ends(2)
         end do
      end associate
   end subroutine fit_hookloads

   !> Least and greatest value of the curves that set the axis; 0 if they have none.
   pure function range_of(curves) result(ends)
      type(curve_type), intent(in) :: curves(:)
      real(wp) :: ends(2)
      integer :: i
      ends = [huge(ends), -huge(ends)]
      do i = 1, size(curves)
         associate (values => curves(i)%points(1, :))
            if (curves(i)%sets_axis) ends = [min(ends(1), minval(values, mask=.not. is_missing(values))), &
                                             max(ends(2), maxval(values, mask=.not. is_missing(values)))]
         end associate
      end do
      if (ends(2) < ends(1)) ends = 0.0_wp
   end function range_of

   !> Hook loads at which the string yields, as the panel shows hook loads, where a yield strength is known. Its look is that of a
   !> limit of the rig, but dotted: it bends with depth. Far from all other curves it does not set the axis.
   subroutine add_yield(chart, sweep, model, operation, friction, points)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      type(model_type), intent(in) :: model
      integer, intent(in) :: operation, friction       !< places in the sweep
      type(sweep_result_type), intent(in) :: points(:) !< over all depths
      real(wp), parameter :: far = 1.5_wp              ! from zero, of the others' distance [-]
      character(:), allocatable :: name
      real(wp) :: loads(size(points)), ends(2), least
      if (all(is_missing(points%overpull_margin))) return
      loads = points%hookload + points%overpull_margin
      if (model%rig%given) loads = indicated_load(model%rig, sweep%operations(operation), loads)
      where (points%status /= result_converged .or. is_missing(points%overpull_margin))
         loads = missing
      else where
         loads = loads/chart%units%force
      end where
      if (all(is_missing(loads))) return
      least = minval(loads, mask=.not. is_missing(loads))
      ends = range_of(chart%panels(size(chart%panels))%curves)
      name = 'pipe yields at this hook load'
      if (least > far*ends(2)) name = 'pipe yields at a hook load of '//to_text(least, few)//' '//trim(chart%units%force_label)
      name = name//' ('//trim(operation_label(sweep%operations(operation)))//', '//friction_text(sweep, friction)//')'
      call add_curve(chart, loads, sweep%depths/chart%units%length, "with lines lw 2.2 dt (2,3) lc rgb '#c00000'", name)
      associate (panel => chart%panels(size(chart%panels)))
         panel%curves(size(panel%curves))%sets_axis = maxval(loads, mask=.not. is_missing(loads)) <= far*ends(2)
      end associate
   end subroutine add_yield

   !> Entries of the legend that a curve belongs to: its operation and its friction factor.
   pure function keys_of(chart, sweep, operation, friction) result(keys)
      type(chart_type), intent(in) :: chart
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: operation, friction       !< places in the sweep
      integer, allocatable :: keys(:)
      keys = [key_of(chart, trim(operation_label(sweep%operations(operation)))), key_of(chart, friction_text(sweep, friction))]
   end function keys_of

   !> Look of marks where an operation cannot be done.
   pure function impossible_look(operation) result(look)
      integer, intent(in) :: operation     !< number of it in the picture
      character(:), allocatable :: look
      look = "with points pt 2 ps 1.4 lw 2 lc rgb '"//colour_of(operation)//"'"
   end function impossible_look

   !> Look of marks at the edge, where a hook load is not drawn.
   pure function edge_look(operation) result(look)
      integer, intent(in) :: operation     !< number of it in the picture
      character(:), allocatable :: look
      look = "with points pt 3 ps 1.4 lw 2 lc rgb '"//colour_of(operation)//"'"
   end function edge_look
end module dg_sweep_picture

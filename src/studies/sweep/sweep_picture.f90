!> The broomstick: hook load, and torque where anything turns, against bit depth. An operation is a colour, a friction factor a
!> dash; what was measured is laid over it.
module dg_sweep_picture
   use dg_kinds, only: wp
   use dg_broomstick_panels, only: add_broomstick_panel, add_measured, add_rig_limits, begin_broomstick, measured_look, &
                                   measured_name, panel_count, turns
   use dg_case_result, only: result_converged, result_locked_up
   use dg_chart, only: add_curve, add_key, chart_type, key_of
   use dg_comparison, only: as_measured
   use dg_curve_look, only: colour_black, colour_of, dash_of, marked_line_style, style_count
   use dg_job, only: model_name
   use dg_load_case, only: block_way, operation_label
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_rig, only: indicated_load
   use dg_sweep, only: point_number, point_type, sweep_type
   use dg_sweep_result, only: answer_of, sweep_result_type
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_no
   implicit none
   private
   public :: sweep_chart

   integer, parameter :: digits = 8
   character(*), parameter :: impossible_name = 'cannot be done'

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
      integer :: i, k, n
      n = size(sweep%depths)
      name = trim(model_name(sweep%models(place)))
      call begin_broomstick(chart, 'sweep_'//sweep%name//'_'//name, 'Sweep '//sweep%name//', model '//name, units, sweep, &
                            model%holes)
      do i = 1, size(sweep%operations)
         call add_key(chart, marked_line_style(i, 1, 2.2_wp, dash_of(1)), trim(operation_label(sweep%operations(i))))
         if (any(sweep%measured%operation == sweep%operations(i))) &
            call add_key(chart, measured_look(i), measured_name(sweep%operations(i)))
      end do
      do k = 1, size(sweep%frictions)
         call add_key(chart, 'with lines lw 1.5 dt '//dash_of(k)//" lc rgb '"//colour_black//"'", friction_label(sweep, k))
      end do
      call add_key(chart, locked_look(style_count), impossible_name)
      call add_broomstick_panel(chart, sweep, model%rig)
      do i = 1, size(sweep%operations)
         do k = 1, size(sweep%frictions)
            call add_hookloads(chart, sweep, model, i, k, points(first(i, k):first(i, k) + n - 1))
         end do
      end do
      ! by the first operation that pulls; other factors put it a hair's breadth beside
      i = max(1, findloc(block_way(sweep%operations) > 0, .true., dim=1))
      k = size(sweep%frictions)
      call add_yield(chart, sweep, model, i, k, points(first(i, k):first(i, k) + n - 1))
      call add_measured(chart, sweep)
      call add_rig_limits(chart, sweep, model%rig)
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

   !> Add hook loads of an operation with a friction factor, and marks where it is impossible. The mark is at the hook load, or
   !> at zero hook load if the string locks up.
   subroutine add_hookloads(chart, sweep, model, operation, friction, points)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      type(model_type), intent(in) :: model
      integer, intent(in) :: operation, friction       !< places in the sweep
      type(sweep_result_type), intent(in) :: points(:) !< over all depths
      real(wp) :: loads(size(points)), slack
      loads = as_measured(points%hookload, points%weight_indicator)/chart%units%force
      associate (depths => sweep%depths/chart%units%length, impossible => answer_of(points) == answer_no)
         call add_curve(chart, merge(loads, missing, points%status == result_converged), depths, &
                        marked_line_style(operation, size(depths), 1.6_wp, dash_of(friction)), '', &
                        keys_of(chart, sweep, operation, friction))
         slack = 0.0_wp
         if (model%rig%given) slack = indicated_load(model%rig, sweep%operations(operation), 0.0_wp)/chart%units%force
         where (points%status == result_locked_up) loads = slack
         call add_curve(chart, pack(loads, impossible), pack(depths, impossible), locked_look(operation), '', &
                        [keys_of(chart, sweep, operation, friction), key_of(chart, impossible_name)])
      end associate
   end subroutine add_hookloads

   !> Hook loads at which the string yields, as the panel shows hook loads, where a yield strength is known. Its look is that of a
   !> limit of the rig, but dotted: it bends with depth.
   subroutine add_yield(chart, sweep, model, operation, friction, points)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      type(model_type), intent(in) :: model
      integer, intent(in) :: operation, friction       !< places in the sweep
      type(sweep_result_type), intent(in) :: points(:) !< over all depths
      real(wp) :: loads(size(points))
      if (all(is_missing(points%overpull_margin))) return
      loads = points%hookload + points%overpull_margin
      if (model%rig%given) loads = indicated_load(model%rig, sweep%operations(operation), loads)
      where (points%status /= result_converged .or. is_missing(points%overpull_margin))
         loads = missing
      else where
         loads = loads/chart%units%force
      end where
      call add_curve(chart, loads, sweep%depths/chart%units%length, "with lines lw 2.2 dt (2,3) lc rgb '#c00000'", &
                     'limit of the string, '//trim(operation_label(sweep%operations(operation)))//', '// &
                     friction_label(sweep, friction))
   end subroutine add_yield

   !> Entries of the legend that a curve belongs to: its operation and its friction factor.
   pure function keys_of(chart, sweep, operation, friction) result(keys)
      type(chart_type), intent(in) :: chart
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: operation, friction       !< places in the sweep
      integer, allocatable :: keys(:)
      keys = [key_of(chart, trim(operation_label(sweep%operations(operation)))), key_of(chart, friction_label(sweep, friction))]
   end function keys_of

   !> Look of marks where an operation cannot be done.
   pure function locked_look(operation) result(look)
      integer, intent(in) :: operation     !< number of it in the picture
      character(:), allocatable :: look
      look = "with points pt 2 ps 1.4 lw 2 lc rgb '"//colour_of(operation)//"'"
   end function locked_look

   pure function friction_label(sweep, number) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number      !< of the friction factor
      character(:), allocatable :: text
      text = 'friction of &hole'
      if (.not. sweep%frictions(number)%present) return
      text = 'friction '
      if (allocated(sweep%frictions_cased)) text = text//to_text(sweep%frictions_cased(number), digits)//' cased, open '
      text = text//to_text(sweep%frictions(number)%value, digits)
   end function friction_label
end module dg_sweep_picture

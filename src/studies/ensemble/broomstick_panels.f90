!> The two panels of a broomstick: hook load against bit depth, and torque beside it where anything turns; what limits both and what
!> was measured.
module dg_broomstick_panels
   use dg_kinds, only: wp
   use dg_chart, only: add_curve, add_depth_panel, add_label, add_points, beside, chart_type, key_of, new_chart, set_depth
   use dg_quantity, only: quantity_force, quantity_moment
   use dg_curve_look, only: colour_black
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: operation_label, rotates
   use dg_rig, only: indicated_load, rig_type
   use dg_sweep, only: at_operation, sweep_type
   use dg_text, only: either, to_text
   use dg_units, only: unit_system_type
   use dg_unit_kind, only: unit_label
   implicit none
   private
   public :: begin_broomstick, add_broomstick_panel, add_measured, add_rig_limits, measured_look, measured_name, &
             panel_count, turns

   !> Of limits: none of the curves is so wide and red.
   character(*), parameter :: limit_look = "lw 2.5 lc rgb '#c00000'"
   !> Limits closer than this are one line [-].
   real(wp), parameter :: same_load = 1.0e-6_wp

contains

   !> A broomstick without panels.
   subroutine begin_broomstick(chart, name, title, units, sweep, holes)
      type(chart_type), intent(out) :: chart
      character(*), intent(in) :: name, title
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(hole_section_type), intent(in) :: holes(:)
      chart = new_chart(name, title, units, 640, [0.80_wp, 0.93_wp])
      call set_depth(chart, 'measured depth of the bit', &
                     [minval([sweep%depths, sweep%measured%bit_depth]), maxval(sweep%depths)], holes, place(1, sweep), .true.)
   end subroutine begin_broomstick

   pure function place(number, sweep)
      integer, intent(in) :: number      !< of the panel
      type(sweep_type), intent(in) :: sweep
      real(wp) :: place(4)
      place = beside(number, panel_count(sweep), [0.075_wp, 0.985_wp, 0.115_wp, 0.80_wp], 0.035_wp)
   end function place

   !> Panels: one of hook loads, another of torque where any operation has torque.
   pure function panel_count(sweep)
      type(sweep_type), intent(in) :: sweep
      integer :: panel_count
      integer :: i
      panel_count = merge(2, 1, any([(turns(sweep, i), i=1, size(sweep%operations))]))
   end function panel_count

   !> True if an operation has torque at the top.
   pure function turns(sweep, operation)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: operation      !< its place in the sweep
      logical :: turns
      turns = rotates(sweep%operations(operation)) .or. abs(at_operation(sweep%tob, operation)) > 0.0_wp
   end function turns

   !> The panel of hook loads, then that of torque.
   subroutine add_broomstick_panel(chart, sweep, rig)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      type(rig_type), intent(in) :: rig
      associate (number => size(chart%panels) + 1)
         if (number == 1) then
            call add_depth_panel(chart, place(1, sweep), either('hook load as the rig shows it', &
                                                                'hook load', rig%given), quantity_force)
         else
            call add_depth_panel(chart, place(2, sweep), 'torque at the top', quantity_moment)
         end if
      end associate
   end subroutine add_broomstick_panel

   !> Add measured values, in either panel.
   subroutine add_measured(chart, sweep)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      integer :: i
      do i = 1, size(sweep%operations)
         associate (there => sweep%measured%operation == sweep%operations(i))
            if (size(chart%panels) == 1) then
               call add(sweep%measured%hookload%value/chart%units%force, there .and. sweep%measured%hookload%present)
            else
               call add(sweep%measured%torque%value/chart%units%moment, there .and. sweep%measured%torque%present)
            end if
         end associate
      end do
   contains
      subroutine add(values, there)
         real(wp), intent(in) :: values(:)
         logical, intent(in) :: there(:)
         if (any(there)) call add_curve(chart, pack(values, there), pack(sweep%measured%bit_depth/chart%units%length, there), &
                                        measured_look(i), '', key_of(chart, measured_name(sweep%operations(i))))
      end subroutine add
   end subroutine add_measured

   !> Entry of the legend of measured points of an operation.
   pure function measured_name(operation) result(name)
      integer, intent(in) :: operation     !< its number
      character(:), allocatable :: name
      name = trim(operation_label(operation))//', measured'
   end function measured_name

   !> Look of measured points: open forms, one an operation.
   pure function measured_look(operation) result(look)
      integer, intent(in) :: operation     !< number of it in the picture
      character(:), allocatable :: look
      integer, parameter :: open_marks(8) = [6, 4, 8, 12, 10, 14, 2, 1]
      look = 'with points pt '//to_text(open_marks(1 + mod(operation - 1, size(open_marks))))//" ps 1.2 lw 1.6 lc rgb '"// &
         colour_black//"'"
   end function measured_look

   !> A line at what the rig may carry, as it shows it, or at what it may turn with, where the deck tells that. Sheaves that rub
   !> show the same load otherwise going up and going down: a line for each, named by the operations that have it.
   subroutine add_rig_limits(chart, sweep, rig)
      type(chart_type), intent(inout) :: chart
      type(sweep_type), intent(in) :: sweep
      type(rig_type), intent(in) :: rig
      real(wp) :: shown(size(sweep%operations))
      logical :: same(size(sweep%operations))
      character(:), allocatable :: operations
      integer :: i, k
      if (size(chart%panels) == 2) then
         if (rig%max_torque%present) call add_limit(chart, rig%max_torque%value/chart%units%moment, &
                                                    unit_label(chart%units, quantity_moment), '')
         return
      end if
      if (.not. rig%max_hookload%present) return
      shown = indicated_load(rig, sweep%operations, rig%max_hookload%value - rig%block_weight)
      do i = 1, size(shown)
         same = abs(shown - shown(i)) <= same_load*abs(shown(i))
         if (any(same(:i - 1))) cycle
         operations = ''
         do k = i, size(shown)
            if (same(k) .and. .not. all(same)) operations = operations//', '//trim(operation_label(sweep%operations(k)))
         end do
         call add_limit(chart, shown(i)/chart%units%force, trim(chart%units%force_label), operations)
      end do
   end subroutine add_rig_limits

   !> A line from top to bottom with its name along it.
   subroutine add_limit(chart, limit, unit, operations)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: limit          !< as it is shown
      character(*), intent(in) :: unit
      character(*), intent(in) :: operations !< each after a comma; '': all
      character(*), parameter :: name = 'limit of the rig'
      integer, parameter :: few = 4
      call add_points(chart, reshape([limit, chart%depth%y%ends(2), limit, chart%depth%y%ends(1)], [2, 2]), &
                      'with lines '//limit_look, name=name//operations)
      call add_label(chart, name//', '//to_text(limit, few)//' '//unit//operations, [limit, 0.98_wp], &
                    "right rotate by 90 offset -1.2,0 font ',10' textcolor rgb '#c00000'", [.false., .true.])
   end subroutine add_limit
end module dg_broomstick_panels

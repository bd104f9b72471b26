!> The two panels of a broomstick: hook load against bit depth, and torque beside it where anything turns; what limits both and what
!> was measured.
module dg_broomstick_panels
   use dg_kinds, only: wp
   use dg_column, only: quantity_force, quantity_moment, unit_text
   use dg_depth_panels, only: add_points, panel_place_type, put_sections
   use dg_gnuplot_script, only: add_series, colour_measured, colour_of, end_script, legend, panel, plot, series_type, spelled, &
                                start_script
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: operation_label
   use dg_rig, only: indicated_load, rig_type
   use dg_sweep, only: sweep_type
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: broomstick_limits_type, start_broomstick, draw_broomstick, add_limits, add_measured, measured_look, &
             locked_look

   integer, parameter :: digits = 8
   !> Of limits: none of the curves is so wide and red.
   character(*), parameter :: limit_look = "with lines lw 2.5 dt solid lc rgb '#c00000'"
   !> Limits closer than this are one line [-].
   real(wp), parameter :: same_load = 1.0e-6_wp
   integer, parameter :: width = 1120, height = 640   !< [px]
   !> Places, in parts of the picture.
   real(wp), parameter :: left = 0.075_wp, right = 0.985_wp, gap = 0.035_wp, bottom = 0.115_wp, top = 0.80_wp, legend_top = 0.93_wp

   !> Commands that draw limits with their names, and what hook loads are.
   type :: broomstick_limits_type
      character(:), allocatable :: hookload, torque  !< of each panel
      logical :: indicated = .false.                 !< hook loads as the rig shows them
   end type broomstick_limits_type

contains

   !> First lines of the script; functions that its curves use may follow.
   pure subroutine start_broomstick(lines, name)
      type(text_type), allocatable, intent(out) :: lines(:)
      character(*), intent(in) :: name      !< of the picture
      call start_script(lines, name, width, height)
   end subroutine start_broomstick

   !> A line at what the rig may carry, as it shows it, and at what it may turn with, where the deck tells that. Sheaves that rub
   !> show the same load otherwise going up and going down: a line for each, named by the operations that have it. `names` are
   !> commands that put names beside the lines, of hook loads and of torque.
   pure subroutine add_limits(hookload, torque, names, units, rig, sweep, file, depth)
      type(series_type), allocatable, intent(inout) :: hookload(:), torque(:)
      type(broomstick_limits_type), intent(out) :: names
      type(unit_system_type), intent(in) :: units
      type(rig_type), intent(in) :: rig
      type(sweep_type), intent(in) :: sweep
      character(*), intent(in) :: file       !< of the curves, as gnuplot names it
      character(*), intent(in) :: depth      !< header of its bit depth
      real(wp) :: shown(size(sweep%operations)), limit
      logical :: same(size(sweep%operations))
      character(:), allocatable :: operations
      integer :: i, k
      names%indicated = rig%given
      names%hookload = ''
      names%torque = ''
      if (rig%max_hookload%present) then
         shown = indicated_load(rig, sweep%operations, rig%max_hookload%value - rig%block_weight)
         do i = 1, size(shown)
            same = abs(shown - shown(i)) <= same_load*abs(shown(i))
            if (any(same(:i - 1))) cycle
            operations = ''
            do k = i, size(shown)
               if (same(k)) operations = operations//', '//trim(operation_label(sweep%operations(k)))
            end do
            if (all(same)) operations = ''
            limit = shown(i)/units%force
            call add_series(hookload, upright(limit), limit_look, '')
            names%hookload = names%hookload//limit_name(limit, units%force_label, operations)
         end do
      end if
      if (rig%max_torque%present .and. size(torque) > 0) then
         limit = rig%max_torque%value/units%moment
         call add_series(torque, upright(limit), limit_look, '')
         names%torque = limit_name(limit, unit_text(quantity_moment, units), '')
      end if
   contains
      !> A point at each depth of the file.
      pure function upright(limit) result(using)
         real(wp), intent(in) :: limit
         character(:), allocatable :: using
         using = file//' using ('//to_text(limit, digits)//"):(column('"//depth//"'))"
      end function upright
   end subroutine add_limits

   !> A line from top to bottom with its name along it.
   pure function limit_name(limit, unit, operations) result(commands)
      real(wp), intent(in) :: limit          !< in that unit
      character(*), intent(in) :: unit, operations
      character(:), allocatable :: commands
      integer, parameter :: few = 4
      commands = 'set label '//spelled('limit of the rig, '//to_text(limit, few)//' '//trim(unit)//operations)//' at first '// &
         to_text(limit, digits)//", graph 0.98 right rotate by 90 offset -1.2,0 font ',10' textcolor rgb '#c00000'; "// &
         'set arrow from first '//to_text(limit, digits)//', graph 0 to first '//to_text(limit, digits)// &
         ", graph 1 nohead lw 2.5 lc rgb '#c00000'; "
   end function limit_name

   !> Marks where an operation cannot be done.
   pure function locked_look(operation) result(look)
      integer, intent(in) :: operation     !< number of it in the picture
      character(:), allocatable :: look
      look = "with points pt 2 ps 1.4 lw 2 lc rgb '"//colour_of(operation)//"'"
   end function locked_look

   !> Look of measured points: open forms, one an operation.
   pure function measured_look(operation) result(look)
      integer, intent(in) :: operation     !< number of it in the picture
      character(:), allocatable :: look
      integer, parameter :: open_marks(8) = [6, 4, 8, 12, 10, 14, 2, 1]
      look = 'with points pt '//to_text(open_marks(1 + mod(operation - 1, size(open_marks))))//" ps 1.2 lw 1.6 lc rgb '"// &
         colour_measured//"'"
   end function measured_look

   !> What was measured, as points that stand in the script: for files that have no columns for it.
   pure subroutine add_measured(lines, key, hookload, torque, units, sweep)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(series_type), allocatable, intent(inout) :: key(:), hookload(:), torque(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      real(wp) :: depths(size(sweep%measured))
      logical :: mine(size(sweep%measured))
      integer :: i
      depths = sweep%measured%bit_depth/units%length
      do i = 1, size(sweep%operations)
         mine = sweep%measured%operation == sweep%operations(i)
         if (.not. any(mine)) cycle
         call add_series(key, 'NaN', measured_look(i), trim(operation_label(sweep%operations(i)))//', measured')
         associate (block => '$load'//to_text(i), there => mine .and. sweep%measured%hookload%present)
            call add_points(lines, block, pack(sweep%measured%hookload%value/units%force, there), pack(depths, there))
            if (any(there)) call add_series(hookload, block//' using 1:2', measured_look(i), '')
         end associate
         associate (block => '$torque'//to_text(i), there => mine .and. sweep%measured%torque%present)
            call add_points(lines, block, pack(sweep%measured%torque%value/units%moment, there), pack(depths, there))
            if (any(there)) call add_series(torque, block//' using 1:2', measured_look(i), '')
         end associate
      end do
   end subroutine add_measured

   !> Title, legend, both panels and the end of the script.
   pure subroutine draw_broomstick(lines, title, key, units, holes, sweep, hookload, torque, limits)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: title
      type(series_type), intent(in) :: key(:)        !< what the legend names
      type(unit_system_type), intent(in) :: units
      type(hole_section_type), intent(in) :: holes(:)
      type(sweep_type), intent(in) :: sweep
      type(series_type), intent(in) :: hookload(:)   !< curves of the left panel
      type(series_type), intent(in) :: torque(:)     !< of the right one; none: there is no such panel
      type(broomstick_limits_type), intent(in) :: limits
      real(wp) :: wide
      character(:), allocatable :: label
      call legend(lines, title, key, top, legend_top)
      call append_text(lines, 'set yrange ['//to_text(maxval(sweep%depths)/units%length, digits)//':0]')
      wide = right - left
      if (size(torque) > 0) wide = 0.5_wp*(right - left - gap)
      label = 'hook load'
      if (limits%indicated) label = 'hook load as the rig shows it'
      call panel(lines, left, left + wide, bottom, top, label//' ['//unit_text(quantity_force, units)//']', &
                 'bit depth ['//trim(units%length_label)//']')
      call put_sections(lines, holes, units, maxval(sweep%depths), &
                        panel_place_type(left, left + wide, bottom, top, width, height), .true.)
      call append_text(lines, limits%hookload)
      call plot(lines, hookload, may_lack=.true.)
      if (size(torque) > 0) then
         call append_text(lines, 'unset label; unset arrow')
         call put_sections(lines, holes, units, maxval(sweep%depths), &
                           panel_place_type(right - wide, right, bottom, top, width, height), .true.)
         call append_text(lines, 'unset label; '//limits%torque)
         call panel(lines, right - wide, right, bottom, top, 'torque at the top ['//unit_text(quantity_moment, units)//']', '')
         call plot(lines, torque, may_lack=.true.)
      end if
      call end_script(lines)
   end subroutine draw_broomstick
end module dg_broomstick_panels

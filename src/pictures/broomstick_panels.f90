!> The two panels of a broomstick: hook load against bit depth, and torque beside it where anything turns.
module dg_broomstick_panels
   use dg_kinds, only: wp
   use dg_column, only: quantity_force, quantity_moment, unit_text
   use dg_gnuplot_script, only: add_series, end_script, legend, panel, plot, series_type, start_script
   use dg_rig, only: indicated_load, rig_type
   use dg_sweep, only: sweep_type
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: start_broomstick, draw_broomstick, add_limits

   integer, parameter :: digits = 8
   !> Of limits: none of the curves is so wide and red.
   character(*), parameter :: limit_look = "with lines lw 2.5 dt solid lc rgb '#c00000'"
   !> Limits closer than this are one line [-].
   real(wp), parameter :: same_load = 1.0e-6_wp
   integer, parameter :: width = 1120, height = 640   !< [px]
   !> Places, in parts of the picture.
   real(wp), parameter :: left = 0.075_wp, right = 0.985_wp, gap = 0.035_wp, bottom = 0.115_wp, top = 0.80_wp, legend_top = 0.93_wp

contains

   !> First lines of the script; functions that its curves use may follow.
   pure subroutine start_broomstick(lines, name)
      type(text_type), allocatable, intent(out) :: lines(:)
      character(*), intent(in) :: name      !< of the picture
      call start_script(lines, name, width, height)
   end subroutine start_broomstick

   !> A line at what the rig may carry, as it shows it, and at what it may turn with, where the deck tells that. Sheaves that rub
   !> show the same load otherwise going up and going down: a line for each.
   pure subroutine add_limits(key, hookload, torque, units, rig, sweep, file, depth)
      type(series_type), allocatable, intent(inout) :: key(:), hookload(:), torque(:)
      type(unit_system_type), intent(in) :: units
      type(rig_type), intent(in) :: rig
      type(sweep_type), intent(in) :: sweep
      character(*), intent(in) :: file       !< of the curves, as gnuplot names it
      character(*), intent(in) :: depth      !< header of its bit depth
      real(wp) :: shown(size(sweep%operations))
      logical :: any_limit
      integer :: i
      any_limit = rig%max_hookload%present .or. (rig%max_torque%present .and. size(torque) > 0)
      if (any_limit) call add_series(key, 'NaN', limit_look, 'limit of the rig')
      if (rig%max_hookload%present) then
         shown = indicated_load(rig, sweep%operations, rig%max_hookload%value - rig%block_weight)
         do i = 1, size(shown)
            if (any(abs(shown(:i - 1) - shown(i)) <= same_load*abs(shown(i)))) cycle
            call add_series(hookload, upright(shown(i)/units%force), limit_look, '')
         end do
      end if
      if (rig%max_torque%present .and. size(torque) > 0) &
         call add_series(torque, upright(rig%max_torque%value/units%moment), limit_look, '')
   contains
      !> A point at each depth of the file.
      pure function upright(limit) result(using)
         real(wp), intent(in) :: limit
         character(:), allocatable :: using
         using = file//' using ('//to_text(limit, digits)//"):(column('"//depth//"'))"
      end function upright
   end subroutine add_limits

   !> Title, legend, both panels and the end of the script.
   pure subroutine draw_broomstick(lines, title, key, units, deepest, hookload, torque, indicated)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: title
      type(series_type), intent(in) :: key(:)        !< what the legend names
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: deepest                !< end of the axis [m]
      type(series_type), intent(in) :: hookload(:)   !< curves of the left panel
      type(series_type), intent(in) :: torque(:)     !< of the right one; none: there is no such panel
      logical, intent(in) :: indicated               !< hook loads as the rig shows them
      real(wp) :: wide
      character(:), allocatable :: label
      call legend(lines, title, key, top, legend_top)
      call append_text(lines, 'set yrange ['//to_text(deepest/units%length, digits)//':0]')
      wide = right - left
      if (size(torque) > 0) wide = 0.5_wp*(right - left - gap)
      label = 'hook load'
      if (indicated) label = 'hook load as the rig shows it'
      call panel(lines, left, left + wide, bottom, top, label//' ['//unit_text(quantity_force, units)//']', &
                 'bit depth ['//trim(units%length_label)//']')
      call plot(lines, hookload, may_lack=.true.)
      if (size(torque) > 0) then
         call panel(lines, right - wide, right, bottom, top, 'torque at the top ['//unit_text(quantity_moment, units)//']', '')
         call plot(lines, torque, may_lack=.true.)
      end if
      call end_script(lines)
   end subroutine draw_broomstick
end module dg_broomstick_panels

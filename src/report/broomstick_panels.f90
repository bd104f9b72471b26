!> The two panels of a broomstick: hook load against bit depth, and torque beside it where anything turns.
module dg_broomstick_panels
   use dg_kinds, only: wp
   use dg_column, only: quantity_force, quantity_moment, unit_text
   use dg_gnuplot_script, only: end_script, legend, panel, plot, series_type, start_script
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: start_broomstick, draw_broomstick

   integer, parameter :: digits = 8
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

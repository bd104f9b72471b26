!> Places where the models with the string on the hole axis (soft, rigid, mixed) leave their range.
module dg_string_range
   use dg_kinds, only: wp
   use dg_buckling_limits, only: curved_limit, helical_limit, helical_low, least_curved_limit, vertical_unit
   use dg_case_result, only: add_sentence, is_pushed, push_needed
   use dg_fluid_pressure, only: needed_push
   use dg_model, only: model_type
   use dg_string_piece, only: layout_of, layout_type, piece_above, piece_type
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_trajectory, only: point_on_arc
   implicit none
   private
   public :: range_warning

   !> Digits of depths and loads in a warning.
   integer, parameter :: shown = 4

contains

   !> '' if the string can follow the hole, else the quantity out of range, its depth and excess.
   pure subroutine range_warning(model, case_index, md, axial, hookload, warning)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)       !< [m]
      real(wp), intent(in) :: axial(:)    !< tension > 0 [N]
      real(wp), intent(in) :: hookload    !< [N]
      character(:), allocatable, intent(out) :: warning
      type(layout_type) :: layout
      type(piece_type) :: piece
      real(wp) :: share, worst, worst_md
      integer :: i
      layout = layout_of(model, case_index)
      warning = ''
      worst = 1.0_wp
      worst_md = 0.0_wp
      do i = 2, size(md)
         if (axial(i) >= 0.0_wp) cycle
         piece = piece_above(model, layout, md(i), 1.0_wp)
         share = share_of_helical(piece, md(i), -axial(i))
         if (share <= worst) cycle
         worst = share
         worst_md = md(i)
      end do
      if (worst > 1.0_wp) warning = 'Compression is '//to_text(worst, shown)//' times the helical buckling load at '// &
         in_units(model%units, unit_length, worst_md, shown)// &
         ', outside the range of this model. Contact there is too low. Use model mcge'
      if (is_pushed(model%rig%max_push - needed_push(model, case_index, hookload), axial)) &
         call add_sentence(warning, push_needed)
   end subroutine range_warning

   !> Compression over the lower helical limit of dg_buckling_limits at a depth [-]; 0 below that limit, or without a limit.
   pure function share_of_helical(piece, md, compression) result(share)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: md           !< [m]
      real(wp), intent(in) :: compression  !< > 0 [N]
      real(wp) :: share
      real(wp), dimension(3) :: position, tangent, bend, across
      real(wp) :: vertical, limit
      share = 0.0_wp
      if (.not. piece%clearance > 0.0_wp) return   ! no clearance to buckle
      call point_on_arc(piece%arc, md - piece%arc%md, position, tangent, bend)
      across = -piece%weight*tangent(3)*tangent
      across(3) = across(3) + piece%weight
      vertical = vertical_unit(piece%stiffness, piece%weight*tangent(3))
      limit = helical_limit(least_curved_limit(piece%stiffness, across, bend, piece%clearance), vertical, helical_low)
      if (compression <= limit) return
      limit = helical_limit(curved_limit(piece%stiffness, across, bend, piece%clearance, compression), vertical, &
                            helical_low)
      if (limit > 0.0_wp .and. compression > limit) share = compression/limit
   end function share_of_helical
end module dg_string_range

!> Where the models that lay the string on the hole axis (soft, rigid, mixed) leave their range.
module dg_string_range
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_soft_string_loads, only: at_offset, piece_above, piece_type
   use dg_text, only: to_text
   implicit none
   private
   public :: range_warning, helical_load

   !> Digits of depths and loads in a warning.
   integer, parameter :: shown = 4

contains

   !> '' where the string can follow the hole, else what is out of range, where and by how much.
   pure function range_warning(model, case_index, md, axial) result(warning)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)       !< [m]
      real(wp), intent(in) :: axial(:)    !< tension > 0 [N]
      character(:), allocatable :: warning
      type(piece_type) :: piece
      real(wp), dimension(3) :: position, across, bend
      real(wp) :: share, worst, worst_md
      integer :: i
      warning = ''
      worst = 1.0_wp
      worst_md = 0.0_wp
      do i = 2, size(md)
         if (axial(i) >= 0.0_wp) cycle
         piece = piece_above(model, case_index, md(i), 1.0_wp)
         call at_offset(piece, md(i) - piece%arc%md, position, across, bend)
         share = -axial(i)/helical_load(piece, norm2(axial(i)*bend + across))
         if (share <= worst) cycle
         worst = share
         worst_md = md(i)
      end do
      if (worst > 1.0_wp) warning = 'outside the range of this model: compression is '//to_text(worst, shown)// &
         ' times the helical buckling load at '//to_text(worst_md/1.0_wp, shown)//' m; contact there is underrated, use mcge'
      if (axial(1) < 0.0_wp) then
         if (warning /= '') warning = warning//'; '
         warning = warning//'the weight of the string does not overcome friction and bit load: '// &
                   'the string would have to be pushed at surface'
      end if
   end function range_warning

   !> Axial load at which a string lies as a helix [N]: 2 sqrt(2) sqrt(E I q/c) on the wall (Chen, Lin & Cheatham
   !> 1990, q the side load of weight and bend), 5.55 (E I w^2)^(1/3) in a vertical hole (Wu, Juvkam-Wold & Lu 1993);
   !> the greater of the two.
   pure function helical_load(piece, side) result(load)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: side      !< q [N/m]
      real(wp) :: load
      real(wp), parameter :: least_clearance = 1.0e-6_wp   ! [m] none at all never buckles
      real(wp), parameter :: vertical_factor = 5.55_wp
      load = 2.0_wp*sqrt(2.0_wp*piece%stiffness*side/max(piece%clearance, least_clearance))
      load = max(load, vertical_factor*(piece%stiffness*piece%weight**2)**(1.0_wp/3.0_wp), tiny(1.0_wp))
   end function helical_load
end module dg_string_range

!> Equilibrium of the beam by which an analysis' string is bent again (dg_bending_profile), near where the string lies.
module dg_bending_equilibrium
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, length_of
   use dg_bending_layout, only: lying_type
   use dg_bending_nodes, only: shape_at
   use dg_bending_solution, only: solve_bending
   use dg_mesh, only: mesh_type
   implicit none
   private
   public :: solve_anchored, settle_firmly, is_near

   !> Largest distance of the beam from the string of the analysis, over the clearance [-]. Next to an instability, as of a free
   !> end under a large load, the beam may find another equilibrium; that is not taken.
   real(wp), parameter :: farthest = 0.8_wp
   !> Clearance that counts at least for that distance [m]: on short elements a bit or blade with less room may lie on its other
   !> side.
   real(wp), parameter :: least_room = 2.0e-3_wp
   !> Stiffness of walls over their own, one after the other, where no equilibrium is found against their own [-].
   real(wp), parameter :: soft_walls(3) = [1.0e-3_wp, 1.0e-2_wp, 1.0e-1_wp]
   !> Change of moments by the last step, over the largest [-], where the string is to be as it is: next to a stiff wall 0.2 % of a
   !> moment is a tenth of the bit's side force.
   real(wp), parameter :: firmly = 1.0e-6_wp

contains

   !> Equilibrium by itself or, in a second attempt, held by springs where the analysis has the string. Where none is found the
   !> string is bent against softer walls first: against stiff ones Newton's steps open and close one contact after the other.
   subroutine solve_anchored(mesh, lying, beam, y, settled, found)
      type(mesh_type), intent(in) :: mesh
      type(lying_type), intent(in) :: lying
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)
      real(wp), intent(in) :: settled
      logical, intent(out) :: found
      type(bending_beam_type) :: softer
      real(wp) :: start(size(y, 1), size(y, 2))
      integer :: i
      start = y
      call solve_once(mesh, lying, beam, y, settled, found)
      if (found) return
      y = start
      softer = beam
      do i = 1, size(soft_walls)
         softer%element%law%contact = soft_walls(i)*beam%element%law%contact
         softer%element%law%maximum = soft_walls(i)*beam%element%law%maximum
         softer%point_law%contact = soft_walls(i)*beam%point_law%contact
         softer%point_law%maximum = soft_walls(i)*beam%point_law%maximum
         call solve_once(mesh, lying, softer, y, settled, found)
      end do
      call solve_once(mesh, lying, beam, y, settled, found)
   end subroutine solve_anchored

   !> Goes on from an equilibrium until nothing changes. Where that finds no end, as at some walls of 1e9 kN/m2, the shape stays.
   subroutine settle_firmly(mesh, lying, beam, y)
      type(mesh_type), intent(in) :: mesh
      type(lying_type), intent(in) :: lying
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)
      real(wp) :: closer(size(y, 1), size(y, 2))
      logical :: found
      closer = y
      call solve_once(mesh, lying, beam, closer, firmly, found)
      if (found) y = closer
   end subroutine settle_firmly

   !> Equilibrium against the walls as they are.
   subroutine solve_once(mesh, lying, beam, y, settled, found)
      type(mesh_type), intent(in) :: mesh
      type(lying_type), intent(in) :: lying
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)
      real(wp), intent(in) :: settled
      logical, intent(out) :: found
      if (lying%anchored) then
         call solve_bending(beam, y, settled, found, anchor=shape_at(mesh%md, lying%y, beam%md))
      else
         call solve_bending(beam, y, settled, found)
      end if
   end subroutine solve_once

   !> Whether the beam is at the string of the analysis: at the nodes of the mesh where that is compressed. In tension a string has
   !> one equilibrium, unless friction or a large torque make another.
   pure function is_near(mesh, lying, nodes, y) result(is)
      type(mesh_type), intent(in) :: mesh
      type(lying_type), intent(in) :: lying
      real(wp), intent(in) :: nodes(:), y(:, :)     !< of the beam, the mesh's nodes among them (n), (4,n) [m, -]
      logical :: is
      integer :: m, n, e
      is = .true.
      m = 1
      do n = 1, size(nodes)
         if (nodes(n) < mesh%md(m)) cycle
         e = min(m, mesh%elements)
         if (lying%axial(m) < 0.0_wp) is = is .and. length_of(y(1:2, n) - lying%y(1:2, m)) <= &
                                           farthest*max(least_room, maxval(mesh%clearance(max(m - 1, 1):e)))
         m = min(m + 1, mesh%nodes)
      end do
   end function is_near
end module dg_bending_equilibrium

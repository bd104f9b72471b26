!> Equilibrium of the beam that gives the moments (dg_bending_profile), near the string of the analysis.
module dg_bending_equilibrium
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, bent_type, contact_sum, find_forces, length_of
   use dg_bending_layout, only: solved_string_type
   use dg_bending_nodes, only: shape_at
   use dg_bending_rows, only: alike
   use dg_bending_solution, only: solve_bending
   use dg_mesh, only: mesh_type
   use dg_moved_walls, only: firmer, misplacement, move_walls
   implicit none
   private
   public :: solve_anchored, settle_firmly, is_near

   !> Largest distance of the beam from the string of the analysis, over the clearance [-]. Next to an instability, as of a
   !> free end under a large load, the beam may find another equilibrium. That one is rejected.
   real(wp), parameter :: farthest = 0.8_wp
   !> Smallest clearance used for that distance [m]. On short elements a bit or blade with less clearance may lie on the other
   !> side.
   real(wp), parameter :: least_room = 2.0e-3_wp
   !> Change of moments by the last step, over the largest moment [-], for the final iteration. Next to a stiff wall 0.2 % of a
   !> moment is a tenth of the bit's side force.
   real(wp), parameter :: firmly = 1.0e-6_wp
   !> Largest distance of a wall from its place, over the clearance [-], and most steps towards it.
   real(wp), parameter :: in_place = 1.0e-3_wp
   integer, parameter :: most_steps = 8

contains

   !> Find the equilibrium of the beam. Where `solved%anchored`, springs hold it at the string of the analysis. Walls have the
   !> limited stiffness of Newton's steps.
   subroutine solve_anchored(mesh, solved, beam, y, settled, found)
      type(mesh_type), intent(in) :: mesh
      type(solved_string_type), intent(in) :: solved
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)   !< offsets and slopes, on return at equilibrium (4,n) [m, -]
      real(wp), intent(in) :: settled                  !< as in solve_bending [-]
      logical, intent(out) :: found
      if (solved%anchored) then
         call solve_bending(beam, y, settled, found, anchor=shape_at(mesh%md, solved%y, beam%md))
      else
         call solve_bending(beam, y, settled, found)
      end if
   end subroutine solve_anchored

   !> Iterate from an equilibrium until nothing changes, against walls of true stiffness. They are moved again until the string
   !> presses them at their true place. Where an iteration does not converge, the shape before it stays.
   subroutine settle_firmly(mesh, solved, beam, y)
      type(mesh_type), intent(in) :: mesh
      type(solved_string_type), intent(in) :: solved
      type(bending_beam_type), intent(inout) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)   !< offsets and slopes (4,n) [m, -]
      type(bending_beam_type) :: next
      type(bent_type) :: bent
      real(wp) :: closer(size(y, 1), size(y, 2))
      logical :: found
      integer :: step
      call find_forces(beam, y, bent)
      beam%pressed_softly = contact_sum(bent)
      next = beam
      closer = y
      do step = 1, most_steps
         call move_walls(solved%firm*firmer**(step - 1), bent, next)
         call solve_anchored(mesh, solved, next, closer, firmly, found)
         if (.not. found) return
         y = closer
         beam = next
         call find_forces(beam, y, bent)
         if (misplacement(bent, beam) < in_place) return
      end do
   end subroutine settle_firmly

   !> True if the beam is near the string of the analysis, at those nodes of the mesh where the string is compressed.
   !> - In tension a string has one equilibrium, unless friction or a large torque make another.
   !> - Next to a free end in a vertical hole no load decides on which side the string lies. A beam anywhere in the hole with
   !>   the same moment is accepted there.
   pure function is_near(mesh, solved, nodes, y, moments) result(is)
      type(mesh_type), intent(in) :: mesh
      type(solved_string_type), intent(in) :: solved
      real(wp), intent(in) :: nodes(:), y(:, :)     !< of the beam, the mesh's nodes among them (n), (4,n) [m, -]
      real(wp), intent(in) :: moments(:)            !< at its nodes (n) [N.m]
      logical :: is
      integer :: m, n, e
      is = .true.
      m = 1
      do n = 1, size(nodes)
         if (nodes(n) < mesh%md(m)) cycle
         e = min(m, mesh%elements)
         if (solved%axial(m) < 0.0_wp) is = is .and. (length_of(y(1:2, n) - solved%y(1:2, m)) <= &
                                           farthest*max(least_room, maxval(mesh%clearance(max(m - 1, 1):e))) .or. &
                                           abs(moments(n) - solved%bending(m)) <= alike*maxval(moments))
         m = min(m + 1, mesh%nodes)
      end do
   end function is_near
end module dg_bending_equilibrium

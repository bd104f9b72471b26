!> The start as a bent beam. The line of the soft string becomes the line of a beam under the soft string's axial force and
!> torque.
!>
!> The soft string touches the wall in every section of the hole, whatever force would bend it there. As a beam its line may
!> start with meganewtons out of balance, and does not show which gaps are open. That happens next to stabilizers, at changes
!> of clearance, and where a survey is noisy. The beam of dg_bending_beam on the nodes of the mesh finds a better line at a
!> tenth of the cost of the whole equations. Axial force and torque are known, so that only contact is unknown. Without
!> friction and compression the solution is the minimum of a convex energy. Springs hold compressed parts near their first
!> position. They are as stiff as the compression makes these parts unstable, as a start need not settle how they buckle.
module dg_bent_start
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, set_elements
   use dg_bending_solution, only: solve_bending
   use dg_gap_state, only: gap_law_type
   use dg_hardened_walls, only: solve_with_hardened_walls
   use dg_mesh, only: is_vertical, mesh_type
   use dg_model, only: model_type
   use dg_moved_walls, only: firm, soften_walls
   use dg_trajectory, only: arc_at, frame_on_arc
   implicit none
   private
   public :: bend_start, new_start_beam, pressing_of_bend

   !> Change of moments over the largest one at which a start is good enough [-], and at which it is settled. The places of the
   !> gaps of a settled start do not depend on the way there. A compressed string, which springs hold near its first position,
   !> is not settled.
   real(wp), parameter :: near = 1.0e-3_wp, settled = 1.0e-5_wp

   !> Stiffness that holds a string hanging free in a vertical hole, over EI/L^3 of its whole length [-]. Only strings with a
   !> bent housing, pads or eccentric blades have it. Without it such a string might be anywhere in the hole.
   real(wp), parameter :: loose = 1.0e-3_wp

contains

   !> Make the beam on the nodes of the mesh under the soft string's forces, without its walls.
   pure subroutine new_start_beam(model, mesh, axial, torque, along, around, beam)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:), torque(:)   !< by node, axial > 0 in tension [N, N.m]
      real(wp), intent(in) :: along(:), around(:)   !< coefficients of friction along and around the hole, by element [-]
      type(bending_beam_type), intent(out) :: beam
      real(wp), parameter :: down(3) = [0.0_wp, 0.0_wp, 1.0_wp]
      real(wp) :: t(3, 2), n_1(3, 2), n_2(3, 2), turn(3)
      integer :: e, n, arc
      n = mesh%nodes
      beam%md = mesh%md
      beam%place = mesh%md
      beam%axial = axial
      allocate (beam%down(2, n), beam%owner(n - 1), beam%curvature(2, n - 1), beam%element(n - 1))
      allocate (beam%held(n), beam%centred(n), source=.false.)
      allocate (beam%bend(2, n - 1), source=0.0_wp)
      if (allocated(mesh%push)) allocate (beam%push(2, n - 1))
      allocate (beam%viscous(n), source=0.0_wp)
      allocate (beam%point(0), beam%point_owner(0), beam%point_law(0), beam%point_press(0), beam%point_moved(0))
      beam%torque = 0.5_wp*(torque(:n - 1) + torque(2:))
      beam%weight = mesh%weight
      beam%element%section = mesh%section
      beam%element%lever = mesh%radius*along
      beam%element%around = around
      do e = 1, n - 1
         beam%place(e + 1) = beam%place(e) + mesh%length(e)*(1.0_wp + 0.5_wp*(axial(e) + axial(e + 1))/mesh%section(e)%ea)
         beam%owner(e) = e
         beam%viscous(e:e + 1) = beam%viscous(e:e + 1) &
                                 + min(axial(e), axial(e + 1), 0.0_wp)**2/(4.0_wp*mesh%section(e)%ei)*0.5_wp*mesh%length(e)
      end do
      if (is_forced(mesh)) &
         beam%viscous = beam%viscous + loose*mesh%section(n - 1)%ei/(mesh%md(n) - mesh%md(1))**3
      arc = 1
      do e = 1, n
         arc = arc_at(model%trajectory, beam%place(e), near=arc)
         t(:, 1) = t(:, 2)
         n_1(:, 1) = n_1(:, 2)
         n_2(:, 1) = n_2(:, 2)
         call frame_on_arc(model%trajectory%arcs(arc), beam%place(e) - model%trajectory%arcs(arc)%md, t(:, 2), n_1(:, 2), n_2(:, 2))
         beam%down(:, e) = [dot_product(down, n_1(:, 2)), dot_product(down, n_2(:, 2))]
         if (e == 1) cycle
         turn = 0.5_wp*(t(:, 2) - t(:, 1))/mesh%length(e - 1)
         if (allocated(mesh%bend)) beam%bend(:, e - 1) = [dot_product(mesh%bend(:, e - 1), n_1(:, 1)), &
                                                          dot_product(mesh%bend(:, e - 1), n_2(:, 1))]/mesh%length(e - 1)
         if (allocated(mesh%push)) beam%push(:, e - 1) = [dot_product(mesh%push(:, e - 1), n_1(:, 1)), &
                                                          dot_product(mesh%push(:, e - 1), n_2(:, 1))]
         if (allocated(mesh%blade)) beam%element(e - 1)%blade = [dot_product(mesh%blade(:, e - 1), n_1(:, 1)), &
                                                                 dot_product(mesh%blade(:, e - 1), n_2(:, 1))]
         beam%curvature(:, e - 1) = [dot_product(turn, n_1(:, 1) + n_1(:, 2)), dot_product(turn, n_2(:, 1) + n_2(:, 2))]
      end do
      beam%centred(1) = model%boundary%top_centred
      beam%centred(n) = model%boundary%bit_centred
      call set_elements(beam)
   end subroutine new_start_beam

   !> Bend offsets and slopes y(4,nodes) [m, -] against walls of a given stiffness, and compute the contact forces. y is in the
   !> frames of the hole at the nodes. If the beam finds no equilibrium, `found` is false and y stays. A string in tension has
   !> one equilibrium: walls are hardened from soft to their own stiffness. A compressed string may be buckled, and would lose
   !> its coils on soft walls. It is bent against its own walls first.
   pure subroutine bend_start(mesh, wall, begin, beam, y, pressed, found)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: wall(:)               !< stiffness per length, by element [N/m2]
      real(wp), intent(in) :: begin                 !< stiffness of walls that y has been bent against, 0: none [N/m2]
      type(bending_beam_type), intent(inout) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)   !< offsets and slopes (4,nodes) [m, -]
      real(wp), intent(out) :: pressed(:, :)        !< contact forces at `contact_xi` of the elements (2,e) [N]
      logical, intent(out) :: found
      real(wp) :: bent(4, mesh%nodes), closer(4, mesh%nodes), settling(size(pressed, 1), size(pressed, 2))
      logical :: compressed, closed
      integer :: e
      do e = 1, mesh%elements
         beam%element(e)%law = gap_law_type(clearance=mesh%opening(e), contact=wall(e), maximum=wall(e), eps_nmax=1.0_wp)
      end do
      call soften_walls(huge(1.0_wp), firm, beam)
      bent = y
      found = .false.
      compressed = any(beam%viscous > 0.0_wp)
      if (compressed) call solve_bending(beam, bent, near, found, anchor=y, pressed=pressed)
      if (.not. found) call solve_with_hardened_walls(beam, begin, bent, near, found, anchor=y, pressed=pressed)
      if (.not. found) return
      closer = bent
      closed = .false.
      if (.not. compressed) call solve_bending(beam, closer, settled, closed, anchor=y, pressed=settling)
      y = bent
      if (.not. closed) return
      y = closer
      pressed = settling
   end subroutine bend_start

   !> Largest contact load over its clearance by a bent housing, pads or eccentric blades in a vertical hole [N/m2], else 0.
   !> The soft string knows no other contact there. `force` are the contact forces of the start, by element [N].
   pure function pressing_of_bend(mesh, force) result(pressing)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: force(:)   !< >= 0 [N]
      real(wp) :: pressing
      pressing = 0.0_wp
      if (is_forced(mesh) .and. is_vertical(mesh)) pressing = maxval(force/(mesh%length*mesh%clearance))
   end function pressing_of_bend

   !> True if a tool of the string presses it against the wall without weight: a bent housing, pads or eccentric blades.
   pure function is_forced(mesh) result(is)
      type(mesh_type), intent(in) :: mesh
      logical :: is
      is = allocated(mesh%bend) .or. allocated(mesh%push) .or. allocated(mesh%blade)
   end function is_forced
end module dg_bent_start

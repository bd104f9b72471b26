!> A rotating string that is compressed near its buckling load whirls: its steady state under friction, and the torques in it.
!>
!> Friction makes a rotating string climb on the side of the hole where its weight presses it. Circumferential friction m R is
!> then balanced by the weight. A buckled string has no such side. When it turns as a whole by d theta about the hole, friction
!> does the work m R |f| d theta per metre. That work has one sign everywhere. No other force does work then, so there is no
!> equilibrium. Its bends whirl around the hole until they roll or slide without that force. This steady state is found,
!> without inertia, by leaving m R out of the lateral forces. Friction's torque m r R stays, as the surface feels it, and axial
!> friction stays. The share of m R that acts sideways falls from one to zero between `whirls_from` and `whirls_all` of the
!> helical load.
!>
!> The torques on such a string at bit, wall and top must then do no work either as it turns. Torque M_t inside an element does
!> work by its end moments (dg_beam_element) on d_i and d_j. If all tangents d turn by d theta about t, that work is
!>   M_t (d_i x d_j)/(1 + d_i.d_j) . (t x d_i + t x d_j) d theta = M_t (t.d_i - t.d_j) d theta.
!> At node n the torque jumps by the torque m_n that is applied there, and all m_n sum to 0. The sum over the elements is
!> therefore
!>   - sum m_n (1 - t.d_n) d theta.
!> A torque that is applied about d or about t leaves that unbalanced. It is balanced by semi-tangential torques, about
!>   (t + d)/(1 + t.d).
!> Their work is that of one more element whose lower tangent is t. Its end moment on d, m (d x t)/(1 + t.d), does the work + m
!> (1 - t.d) d theta. With it the string is at a minimum of an energy at given contact forces. The tangent of the torques is
!> then symmetric in sum. Where no part is compressed near buckling, torques act about the string's own axis.
module dg_whirling
   use dg_kinds, only: wp
   use dg_beam_element, only: torque_force, torque_tangent
   use dg_block_matrix, only: block_matrix_type
   use dg_helical_load, only: helical_load, least_helical_load
   use dg_mesh, only: mesh_type, upright
   use dg_model, only: model_type
   use dg_scatter, only: element_type, part_energy, part_of, part_rest
   use dg_soft_string_loads, only: other_loads_type, soft_string_at
   use dg_vector, only: outer
   use dg_workspace, only: dof_twist
   implicit none
   private
   public :: find_sideways, turning_type, add_turning, turning_moment, add_end_torque, end_moment

   !> Compression over the helical load above which a rotating string's friction acts less sideways, and above which not any
   !> more [-]. A string buckles sinusoidally from 0.71 = 1/sqrt(2) on, in bends and next to stabilizers earlier.
   real(wp), parameter :: whirls_from = 0.4_wp, whirls_all = 0.72_wp

   !> Torque of friction at a gap.
   type :: turning_type
      real(wp) :: lever = 0.0_wp          !< torque over contact force, m r; 0: no torque [m]
      real(wp) :: share(2) = 0.0_wp       !< part of each node in it [-]
      real(wp) :: shape(4) = 0.0_wp       !< N at the gap
      real(wp) :: force = 0.0_wp          !< contact force of the friction [N]
      real(wp) :: stiffness = 0.0_wp      !< its derivative by |f| [N/m]
      real(wp) :: outward(3) = 0.0_wp     !< f/|f|
      real(wp) :: tangent(3) = 0.0_wp     !< t of the hole axis at the foot
      real(wp) :: bend(3) = 0.0_wp        !< derivative of t by the point's move along t [1/m]
   end type turning_type

contains

   !> Share of friction around the string that acts sideways, by element [-]. It is below 1 where the soft string is compressed
   !> near buckling. It is 0 under any compression where the side load is too small to raise the buckling load. No coil is held to
   !> a side there. In an exactly vertical part it is 0 all along if any of that part is compressed. If it is below 1
   !> anywhere, torques at bit and top act semi-tangentially. For a string that slides without turning, which has no such
   !> friction, it has no other effect. A torque about the string's own axis at a free bit would drive the string around for
   !> ever. A shaft without friction keeps that torque: it buckles as Greenhill's (1883).
   pure subroutine find_sideways(model, case_index, mesh, compressed, sideways)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: compressed        !< largest compression of the soft string over its helical load [-]
      real(wp), intent(out) :: sideways(:)      !< 0 to 1 (e) [-]
      real(wp) :: axial(mesh%nodes), torque(mesh%nodes), contact(3, mesh%nodes), side, load, ratio
      logical :: vertical(mesh%nodes)
      logical :: hangs                          ! buckles as in a vertical hole
      integer :: e
      sideways = 1.0_wp
      vertical = mesh%frame(3, 1, :) > upright
      if (.not. (compressed > whirls_from .or. (compressed > 0.0_wp .and. any(vertical)))) return
      call soft_string_at(model, case_index, mesh%md, axial, torque, contact, other=other_loads_type(coiled=.true.))
      do e = 1, mesh%elements
         side = min(norm2(contact(:, e)), norm2(contact(:, e + 1)))
         load = helical_load(mesh%section(e)%ei, side, mesh%weight(e), mesh%clearance(e))
         hangs = .not. load > least_helical_load(mesh%section(e)%ei, mesh%weight(e))
         if (.not. (mesh%friction_around(e) > 0.0_wp .or. abs(mesh%friction_along(e)) > 0.0_wp .or. hangs)) cycle
         ratio = -min(axial(e), axial(e + 1), 0.0_wp)/load
         sideways(e) = min(1.0_wp, max(0.0_wp, (whirls_all - ratio)/(whirls_all - whirls_from)))
         if (hangs .and. ratio > 0.0_wp) sideways(e) = 0.0_wp
      end do
      call free_vertical_stretches(vertical, axial, mesh%friction_around, sideways)
   end subroutine find_sideways

   !> Set sideways friction to zero in vertical parts of the hole with compression in them.
   pure subroutine free_vertical_stretches(vertical, axial, rotary, sideways)
      logical, intent(in) :: vertical(:)        !< of the hole, at the nodes
      real(wp), intent(in) :: axial(:)          !< of the soft string, at the nodes, tension > 0 [N]
      real(wp), intent(in) :: rotary(:)         !< circumferential friction factor, by element [-]
      real(wp), intent(inout) :: sideways(:)
      integer :: first, last
      first = 1
      do while (first < size(vertical))
         last = first
         do while (last < size(vertical))
            if (.not. (vertical(last) .and. vertical(last + 1))) exit
            last = last + 1
         end do
         if (last > first .and. any(axial(first:last) < 0.0_wp)) &
            where (rotary(first:last - 1) > 0.0_wp) sideways(first:last - 1) = 0.0_wp
         first = last + 1
      end do
   end subroutine free_vertical_stretches

   !> Add the torque of friction on both nodes of an element. It is subtracted from their torque residuals. Its moments on the
   !> directors d, and the wanted part of its tangent, are added to the element.
   pure subroutine add_turning(turning, d, element)
      type(turning_type), intent(in) :: turning
      real(wp), intent(in) :: d(:, :)   !< directors of both nodes (3,2) [-]
      type(element_type), intent(inout) :: element
      real(wp) :: torque, by_d(3, 3), by_t(3, 3), by_torque(3), by_point(3, 3), turn(3)
      integer :: a, b, first
      do a = 1, 2
         first = 6*a - 2
         torque = -turning%lever*turning%force*turning%share(a)
         element%twisting(a) = element%twisting(a) - torque
         element%force(first:first + 2) = element%force(first:first + 2) + torque_force(torque, d(:, a), turning%tangent)
         if (.not. element%tangent) cycle
         call torque_tangent(torque, d(:, a), turning%tangent, by_d, by_t, by_torque)
         element%k(first:first + 2, first:first + 2) = element%k(first:first + 2, first:first + 2) + part_of(by_d, element%part)
         if (element%part == part_energy) cycle
         turn = (turning%lever*turning%stiffness*turning%share(a))*turning%outward       ! minus the derivative of torque by the
                                                                                         ! point
         by_point = outer(matmul(by_t, turning%bend), turning%tangent) - outer(by_torque, turn)
         do b = 1, 4
            element%k(first:first + 2, 3*b - 2:3*b) = element%k(first:first + 2, 3*b - 2:3*b) + turning%shape(b)*by_point
            element%twist_row(a, 3*b - 2:3*b) = element%twist_row(a, 3*b - 2:3*b) + turning%shape(b)*turn
         end do
      end do
   end subroutine add_turning

   !> Vector of that torque on the string [N.m].
   pure function turning_moment(turning, d) result(moment)
      type(turning_type), intent(in) :: turning
      real(wp), intent(in) :: d(:, :)   !< directors of both nodes (3,2) [-]
      real(wp) :: moment(3)
      integer :: a
      moment = 0.0_wp
      do a = 1, 2
         moment = moment + end_moment(-turning%lever*turning%force*turning%share(a), d(:, a), turning%tangent)
      end do
   end function turning_moment

   !> Vector of a semi-tangential torque [N.m].
   pure function end_moment(torque, d, t) result(moment)
      real(wp), intent(in) :: torque, d(3), t(3)   !< about t downwards [N.m], director [-], tangent of the hole [-]
      real(wp) :: moment(3)
      moment = (torque/(1.0_wp + dot_product(t, d)))*(t + d)
   end function end_moment

   !> Add a torque on an end node of the string. Its moment on the director is added to `force`, and the wanted part of its
   !> tangent to the matrix. The torque at the top is a reaction, and changes as the residual of the twist there. Its
   !> derivative is that row of the matrix, which must not have been held yet.
   pure subroutine add_end_torque(mesh, node, torque, gradient, d, part, wanted, force, matrix)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      real(wp), intent(in) :: torque              !< on the string, about its axis downwards [N.m]
      real(wp), intent(in) :: gradient(3, 2)      !< derivative of the director by its slopes [-]
      real(wp), intent(in) :: d(3)                !< director [-]
      integer, intent(in) :: part                 !< part of the tangent; part_rest: no force is added
      logical, intent(in) :: wanted               !< true if the tangent is wanted
      real(wp), intent(inout) :: force(3)         !< on the director [N.m]
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: by_d(3, 3), by_t(3, 3), by_torque(3), turn(2), row(6), stiffness
      integer, parameter :: slopes(2) = [5, 6]
      integer :: i
      if (part /= part_rest) force = force + torque_force(torque, d, mesh%frame(:, 1, node))
      if (.not. wanted) return
      call torque_tangent(torque, d, mesh%frame(:, 1, node), by_d, by_t, by_torque)
      matrix%diagonal(slopes, slopes, node) = matrix%diagonal(slopes, slopes, node) &
                                              + matmul(transpose(gradient), matmul(part_of(by_d, part), gradient))
      if (part == part_energy .or. node > 1) return
      turn = matmul(by_torque, gradient)
      row = matrix%upper(dof_twist, :, 1)
      stiffness = mesh%section(1)%gj/mesh%length(1)
      if (part == part_rest) row(dof_twist) = row(dof_twist) - stiffness     ! stiffness that is in the energy's part
      do i = 1, 2
         matrix%diagonal(slopes(i), :, 1) = matrix%diagonal(slopes(i), :, 1) + turn(i)*matrix%diagonal(dof_twist, :, 1)
         matrix%upper(slopes(i), :, 1) = matrix%upper(slopes(i), :, 1) + turn(i)*row
      end do
   end subroutine add_end_torque
end module dg_whirling

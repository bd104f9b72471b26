!> A string in its hole as a slender beam, bent under an axial force and a torque that are known.
!>
!> The analysis of a case has elements that are longer than the bending length sqrt(EI/T). It finds axial force, torque and the sum
!> of contact to a ten-thousandth, but not the bending moment between the places where its elements touch. This beam finds that
!> moment, on shorter elements. The unknowns of a node are the offset y = (y_1, y_2) of the string off the hole axis, along n_1 and
!> n_2 of the frame of the hole (convention 3), and its slope y' by measured depth. The string is in equilibrium when for every
!> small displacement v across the hole
!>
!>   integral of  EI (k + y'').v'' - M_t t x (k + y'').v' + T y'.v' - (T k + w).v + R n.v + m R (t x n).v + r a R n.v'  = 0.
!>
!>   EI  bending stiffness [N.m2]                       R    contact force on the string per metre, where |y| > c [N/m]
!>   k   curvature of the hole axis [1/m]               n    y/|y|: outwards
!>   T   axial force, tension positive [N]              m    coefficient of friction around the hole (convention 13) [-]
!>   M_t torque (convention 9) [N.m]                    a    coefficient of friction along the hole (convention 13) [-]
!>   w   buoyed weight across the hole [N/m]            r    radius of contact [m]
!>
!> An end that is not held carries neither moment nor force across the hole. Slopes y', and |k| c, are small against one. The small
!> force around the hole that belongs to the friction of a sliding string (F_tau of dg_gap_contact) is left out.
!> These are the equations of a beam-column in the frame of the hole: contact after Eqs. 4 to 6 of Liu, Ding & Zhang (2002), the
!> rest after their Eqs. 9 to 12 with squares of y left out.
module dg_bending_beam
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_gap_state, only: contact_force, gap_law_type, state_elastic, state_rigid
   use dg_hermite, only: hermite_bend, hermite_slope, hermite_value
   implicit none
   private
   public :: bending_beam_type, node_unknowns, contact_places, contact_xi
   public :: set_linear_part, add_contact, element_forces, contact_forces, point_forces, moment_within, moment_of_offsets

   !> Unknowns of a node: y_1, y_2 [m], their slopes [-].
   integer, parameter :: node_unknowns = 4
   !> Places of an element at which the wall is felt. A node has two unknowns in a plane, offset and slope; more places than two
   !> would leave a string that lies on the wall no freedom to bend along it.
   integer, parameter :: contact_places = 2
   real(wp), parameter :: third = 1.0_wp/sqrt(3.0_wp)
   real(wp), parameter :: contact_xi(contact_places) = [0.5_wp*(1.0_wp - third), 0.5_wp*(1.0_wp + third)]
   !> Gauss points and weights of the other integrals: exact for polynomials up to the fifth degree.
   real(wp), parameter :: outer = sqrt(0.6_wp)
   real(wp), parameter :: gauss_xi(3) = [0.5_wp*(1.0_wp - outer), 0.5_wp, 0.5_wp*(1.0_wp + outer)]
   real(wp), parameter :: gauss_weight(3) = [5.0_wp, 8.0_wp, 5.0_wp]/18.0_wp

   !> The beam: n nodes from the top down, element e between nodes e and e + 1.
   type :: bending_beam_type
      real(wp), allocatable :: md(:)            !< depth of the nodes along the string, before loading [m]
      real(wp), allocatable :: place(:)         !< measured depth of the hole where a node now is [m]
      real(wp), allocatable :: axial(:)         !< T at the nodes [N]
      real(wp), allocatable :: weight(:, :)     !< buoyed weight across the hole, per length, at the nodes (2,n) [N/m]
      real(wp), allocatable :: viscous(:)       !< stiffness that holds a compressed string during the iteration, at the nodes [N/m]
      logical, allocatable :: held(:)           !< nodes whose offset and slope stay as they are
      logical, allocatable :: centred(:)        !< nodes whose offset stays as it is
      integer, allocatable :: owner(:)          !< element of the analysis in which an element of the beam lies
      real(wp), allocatable :: curvature(:, :)  !< k of the hole, by element (2,e) [1/m]
      real(wp), allocatable :: torque(:)        !< M_t by element [N.m]
      real(wp), allocatable :: ei(:)            !< [N.m2]
      type(gap_law_type), allocatable :: law(:) !< of a metre of wall, by element (stiffnesses in N/m2)
      real(wp), allocatable :: radius(:)        !< radius of contact r, by element [m]
      real(wp), allocatable :: along(:)         !< friction coefficient a, by element [-]
      real(wp), allocatable :: around(:)        !< friction coefficient m, by element [-]
      ! contacts of tool joints, each at one node, from the top down
      integer, allocatable :: point(:)             !< node
      integer, allocatable :: point_owner(:)       !< element of the analysis in which it lies
      type(gap_law_type), allocatable :: point_law(:)  !< of the whole contact (stiffnesses in N/m)
   end type bending_beam_type

contains

   !> Matrix and load of everything but contact: residual = matrix y - load.
   pure subroutine set_linear_part(beam, matrix, load)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(out) :: matrix     !< 4 unknowns a node
      real(wp), intent(out) :: load(:, :)                !< (4,n) [N, N.m]
      real(wp) :: k(8, 8), f(8)
      integer :: e, n
      n = size(beam%md)
      matrix = new_block_matrix(n, node_unknowns)
      load = 0.0_wp
      do e = 1, n - 1
         call linear_element(beam, e, k, f)
         matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + k(:4, :4)
         matrix%diagonal(:, :, e + 1) = matrix%diagonal(:, :, e + 1) + k(5:, 5:)
         matrix%upper(:, :, e) = k(:4, 5:)
         matrix%lower(:, :, e) = k(5:, :4)
         load(:, e) = load(:, e) + f(:4)
         load(:, e + 1) = load(:, e + 1) + f(5:)
      end do
   end subroutine set_linear_part

   !> Matrix k and load f of one element but for contact, in the order (y_1, y_2, y_1', y_2') of its upper, then its lower node
   !> [N/m, N, N.m].
   pure subroutine linear_element(beam, e, k, f)
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: e
      real(wp), intent(out) :: k(8, 8), f(8)
      real(wp) :: length, weight, tension, across(2), value(4), slope(4), bend(4), bent(4, 4), tight(4, 4), turned(4, 4)
      integer :: g, i, j
      integer, parameter :: first(4) = [1, 3, 5, 7]      ! of y_1; those of y_2 follow them
      length = beam%md(e + 1) - beam%md(e)
      bent = 0.0_wp
      tight = 0.0_wp
      turned = 0.0_wp
      f = 0.0_wp
      do g = 1, size(gauss_xi)
         weight = gauss_weight(g)*length
         value = hermite_value(gauss_xi(g), length)
         slope = hermite_slope(gauss_xi(g), length)
         bend = hermite_bend(gauss_xi(g), length)
         tension = (1.0_wp - gauss_xi(g))*beam%axial(e) + gauss_xi(g)*beam%axial(e + 1)
         across = (1.0_wp - gauss_xi(g))*beam%weight(:, e) + gauss_xi(g)*beam%weight(:, e + 1) + tension*beam%curvature(:, e)
         do j = 1, 4
            do i = 1, 4
               bent(i, j) = bent(i, j) + weight*beam%ei(e)*bend(i)*bend(j)
               tight(i, j) = tight(i, j) + weight*tension*slope(i)*slope(j)
               turned(i, j) = turned(i, j) - weight*beam%torque(e)*slope(i)*bend(j)
            end do
         end do
         do i = 1, 4
            f(first(i)) = f(first(i)) + weight*(value(i)*across(1) - beam%ei(e)*bend(i)*beam%curvature(1, e) &
                                                - beam%torque(e)*slope(i)*beam%curvature(2, e))
            f(first(i) + 1) = f(first(i) + 1) + weight*(value(i)*across(2) - beam%ei(e)*bend(i)*beam%curvature(2, e) &
                                                        + beam%torque(e)*slope(i)*beam%curvature(1, e))
         end do
      end do
      k = 0.0_wp
      do j = 1, 4
         do i = 1, 4
            k(first(i), first(j)) = bent(i, j) + tight(i, j)
            k(first(i) + 1, first(j) + 1) = bent(i, j) + tight(i, j)
            k(first(i), first(j) + 1) = -turned(i, j)          ! t x (a_1, a_2) = (-a_2, a_1)
            k(first(i) + 1, first(j)) = turned(i, j)
         end do
      end do
   end subroutine linear_element

   !> Adds what contact makes at the shape y to a residual and its matrix.
   pure subroutine add_contact(beam, y, residual, matrix)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)                    !< (4,n) [m, -]
      real(wp), intent(inout) :: residual(:, :)          !< (4,n) [N, N.m]
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: f(8), k(8, 8), force, by_across(2, 2), by_couple(2, 2)
      logical :: touches
      integer :: e, n, p
      do e = 1, size(beam%md) - 1
         do p = 1, contact_places
            call contact_element(beam, e, p, y, f, touches, k)
            if (.not. touches) cycle
            residual(:, e) = residual(:, e) + f(:4)
            residual(:, e + 1) = residual(:, e + 1) + f(5:)
            matrix%diagonal(:, :, e) = matrix%diagonal(:, :, e) + k(:4, :4)
            matrix%diagonal(:, :, e + 1) = matrix%diagonal(:, :, e + 1) + k(5:, 5:)
            matrix%upper(:, :, e) = matrix%upper(:, :, e) + k(:4, 5:)
            matrix%lower(:, :, e) = matrix%lower(:, :, e) + k(5:, :4)
         end do
      end do
      do p = 1, size(beam%point)
         n = beam%point(p)
         if (.not. norm2(y(1:2, n)) > beam%point_law(p)%clearance) cycle
         e = min(n, size(beam%ei))
         call wall_action(beam%point_law(p), y(1:2, n), beam%along(e)*beam%radius(e), beam%around(e), force, f(1:2), f(3:4), &
                          by_across, by_couple)
         residual(:, n) = residual(:, n) + f(:4)
         matrix%diagonal(1:2, 1:2, n) = matrix%diagonal(1:2, 1:2, n) + by_across
         matrix%diagonal(3:4, 1:2, n) = matrix%diagonal(3:4, 1:2, n) + by_couple
      end do
   end subroutine add_contact

   !> What contact at one place of an element adds to the residual of its eight unknowns [N, N.m], and the derivative of that where
   !> it is asked for. Where `touches` is false neither is set.
   pure subroutine contact_element(beam, e, p, y, f, touches, k)
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: e, p
      real(wp), intent(in) :: y(:, :)
      real(wp), intent(out) :: f(8)
      logical, intent(out) :: touches
      real(wp), intent(out), optional :: k(8, 8)
      real(wp) :: length, value(4), slope(4), offset(2), force, across(2), couple(2), by_across(2, 2), by_couple(2, 2), weight
      integer :: i, j, a, b
      length = beam%md(e + 1) - beam%md(e)
      value = hermite_value(contact_xi(p), length)
      offset = offset_by(value, y(:, e:e + 1))
      touches = offset(1)**2 + offset(2)**2 > beam%law(e)%clearance**2
      if (.not. touches) return
      call wall_action(beam%law(e), offset, beam%along(e)*beam%radius(e), beam%around(e), force, across, couple, &
                       by_across, by_couple)
      slope = hermite_slope(contact_xi(p), length)
      weight = length/contact_places
      do i = 1, 4
         a = 2*i - 1
         f(a:a + 1) = weight*(value(i)*across + slope(i)*couple)
      end do
      if (.not. present(k)) return
      do j = 1, 4
         b = 2*j - 1
         do i = 1, 4
            a = 2*i - 1
            k(a:a + 1, b:b + 1) = (weight*value(j)*value(i))*by_across + (weight*value(j)*slope(i))*by_couple
         end do
      end do
   end subroutine contact_element

   !> Offset of a point of an element by the values of the shape functions there, or its derivative by theirs.
   pure function offset_by(shape, y) result(offset)
      real(wp), intent(in) :: shape(4)
      real(wp), intent(in) :: y(4, 2)      !< of the element's nodes [m, -]
      real(wp) :: offset(2)
      offset = shape(1)*y(1:2, 1) + shape(2)*y(3:4, 1) + shape(3)*y(1:2, 2) + shape(4)*y(3:4, 2)
   end function offset_by

   !> What the wall adds to the residual where the string touches: R (n + m t x n) on the offset, r a R n on the slope. With their
   !> derivatives by the offset. A law for a metre of wall gives them per metre.
   pure subroutine wall_action(law, offset, lever, around, force, across, couple, by_across, by_couple)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: offset(2)   !< not zero [m]
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(out) :: force      !< R [N/m, or N]
      real(wp), intent(out) :: across(2), couple(2), by_across(2, 2), by_couple(2, 2)
      real(wp) :: distance, stiffness, n(2), tau(2), by_n(2, 2), by_tau(2, 2)
      integer :: i
      distance = norm2(offset)
      call contact_force(law, merge(state_rigid, state_elastic, distance > (1.0_wp + law%eps_nmax)*law%clearance), distance, &
                         force, stiffness)
      n = offset/distance
      tau = [-n(2), n(1)]
      across = force*(n + around*tau)
      couple = lever*force*n
      do i = 1, 2
         by_n(:, i) = stiffness*n(i)*n + force/distance*tau(i)*tau
         by_tau(:, i) = stiffness*n(i)*tau - force/distance*tau(i)*n
      end do
      by_across = by_n + around*by_tau
      by_couple = lever*by_n
   end subroutine wall_action

   !> Forces and moments at the nodes (4,n) [N, N.m], from the equilibrium of the element below each node, its loads and contact
   !> taken into account; at the last node from the element above it. Minus the first and second are the force across the hole that
   !> the string below the node exerts on the string above it, along n_1 and n_2. Minus the third and fourth are the bending moment
   !> EI (k + y'') there.
   pure function element_forces(beam, y) result(forces)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)      !< (4,n) [m, -]
      real(wp) :: forces(4, size(y, 2))
      real(wp) :: k(8, 8), f(8), all(8), local(8)
      logical :: touches
      integer :: e, n, p
      n = size(y, 2)
      do e = 1, n - 1
         call linear_element(beam, e, k, f)
         local = [y(:, e), y(:, e + 1)]
         all = matmul(k, local) - f
         do p = 1, contact_places
            call contact_element(beam, e, p, y, f, touches)
            if (touches) all = all + f
         end do
         forces(:, e) = all(:4)
         if (e == n - 1) forces(:, n) = -all(5:)
      end do
   end function element_forces

   !> Contact forces R at the places of the elements, which lie at `contact_xi` of their lengths (contact_places,n-1) [N].
   pure function contact_forces(beam, y) result(forces)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      real(wp) :: forces(contact_places, size(y, 2) - 1)
      real(wp) :: length, offset(2), a(2), b(2), c(2, 2), d(2, 2)
      integer :: e, p
      do e = 1, size(y, 2) - 1
         length = beam%md(e + 1) - beam%md(e)
         do p = 1, contact_places
            offset = offset_by(hermite_value(contact_xi(p), length), y(:, e:e + 1))
            forces(p, e) = 0.0_wp
            if (norm2(offset) > beam%law(e)%clearance) &
               call wall_action(beam%law(e), offset, 0.0_wp, 0.0_wp, forces(p, e), a, b, c, d)
            forces(p, e) = forces(p, e)*length/contact_places
         end do
      end do
   end function contact_forces

   !> Contact forces of the tool joints, in the order of beam%point [N].
   pure function point_forces(beam, y) result(forces)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      real(wp) :: forces(size(beam%point))
      real(wp) :: a(2), b(2), c(2, 2), d(2, 2)
      integer :: p
      forces = 0.0_wp
      do p = 1, size(beam%point)
         associate (offset => y(1:2, beam%point(p)))
            if (norm2(offset) > beam%point_law(p)%clearance) &
               call wall_action(beam%point_law(p), offset, 0.0_wp, 0.0_wp, forces(p), a, b, c, d)
         end associate
      end do
   end function point_forces

   !> Bending moment EI (k + y'') by the shape of one element, at its upper (side 1) or lower end (side 2), along n_1 and n_2
   !> [N.m]. Where it jumps from one element to the next, the elements are too long.
   pure function moment_within(beam, y, e, side) result(moment)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      integer, intent(in) :: e, side
      real(wp) :: moment(2)
      moment = beam%ei(e)*beam%curvature(:, e) + moment_of_offsets(beam, y, e, side)
   end function moment_within

   !> The part EI y'' of that moment: what offsets, or a change of offsets, make [N.m].
   pure function moment_of_offsets(beam, y, e, side) result(moment)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :)
      integer, intent(in) :: e, side
      real(wp) :: moment(2)
      real(wp) :: bend(4)
      bend = hermite_bend(real(side - 1, wp), beam%md(e + 1) - beam%md(e))
      moment = beam%ei(e)*offset_by(bend, y(:, e:e + 1))
   end function moment_of_offsets
end module dg_bending_beam

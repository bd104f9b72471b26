!> A string in its hole as a slender beam, bent under an axial force and a torque that are known.
!>
!> The analysis of a case has elements that are longer than the bending length sqrt(EI/T). It finds axial force, torque and the sum
!> of contact to a ten-thousandth, but not the bending moment between the places where its elements touch. This beam finds that
!> moment, on shorter elements. The unknowns of a node are the offset y = (y_1, y_2) of the string off the hole axis, along n_1 and
!> n_2 of the frame of the hole (convention 3), and its slope y' by measured depth. The string is in equilibrium when for every
!> small displacement v across the hole
!>
!>   integral of  EI (k + y'' - b).v'' - M_t t x (k + y'').v' + T y'.v' - (T k + w).v + R n.v + m R (t x n).v + r a R n.v'  = 0.
!>
!>   EI  bending stiffness [N.m2]                       R    contact force on the string per metre, where |y| > c [N/m]
!>   k   curvature of the hole axis [1/m]               n    y/|y|: outwards
!>   b   curvature of the string before loading [1/m]
!>   T   axial force, tension positive [N]              m    coefficient of friction around the hole (convention 13) [-]
!>   M_t torque (convention 9) [N.m]                    a    coefficient of friction along the hole (convention 13) [-]
!>   w   buoyed weight across the hole [N/m]            r    radius of contact [m]
!>
!> An end that is not held carries neither moment nor force across the hole. Slopes y', and |k| c, are small against one. The small
!> force around the hole that belongs to the friction of a sliding string (F_tau of dg_gap_contact) is left out.
!> Contact is that of Eqs. 4 to 6 of Liu, Ding & Zhang (2002), the rest that of their Eqs. 9 to 12 without squares of y.
module dg_bending_beam
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_gap_state, only: contact_force, gap_law_type, state_elastic, state_rigid
   implicit none
   private
   public :: bending_beam_type, bent_type, beam_contact_type, node_unknowns, contact_places, contact_xi
   public :: set_linear_part, add_contact, add_contact_stiffness, find_forces, curvature_within, length_of

   !> Unknowns of a node: y_1, y_2 [m], their slopes [-].
   integer, parameter :: node_unknowns = 4
   !> Places of an element at which the wall is felt. A node has two unknowns in a plane, offset and slope; more places than two
   !> would leave a string that lies on the wall no freedom to bend along it.
   integer, parameter :: contact_places = 2
   real(wp), parameter :: third = 1.0_wp/sqrt(3.0_wp)
   real(wp), parameter :: contact_xi(contact_places) = [0.5_wp*(1.0_wp - third), 0.5_wp*(1.0_wp + third)]
   !> There, of an element of unit length: shape functions of y and y' at its upper, then at its lower node, and their slopes.
   real(wp), parameter :: rest(contact_places) = 1.0_wp - contact_xi
   real(wp), parameter :: contact_value(4, contact_places) = transpose(reshape( &
      [rest**2*(1.0_wp + 2.0_wp*contact_xi), contact_xi*rest**2, contact_xi**2*(1.0_wp + 2.0_wp*rest), -rest*contact_xi**2], &
      [contact_places, 4]))
   real(wp), parameter :: contact_slope(4, contact_places) = transpose(reshape( &
      [-6.0_wp*contact_xi*rest, rest*(1.0_wp - 3.0_wp*contact_xi), 6.0_wp*contact_xi*rest, -contact_xi*(3.0_wp*rest - 1.0_wp)], &
      [contact_places, 4]))

   !> The beam: n nodes from the top down, element e between nodes e and e + 1.
   type :: bending_beam_type
      real(wp), allocatable :: md(:)            !< depth of the nodes along the string, before loading [m]
      real(wp), allocatable :: place(:)         !< measured depth of the hole where a node now is [m]
      real(wp), allocatable :: axial(:)         !< T at the nodes [N]
      real(wp), allocatable :: down(:, :)       !< part of the unit vector downwards that is across the hole, at the nodes (2,n) [-]
      real(wp), allocatable :: viscous(:)       !< stiffness that holds a compressed string during the iteration, at the nodes [N/m]
      logical, allocatable :: held(:)           !< nodes whose offset and slope stay as they are
      logical, allocatable :: centred(:)        !< nodes whose offset stays as it is
      integer, allocatable :: owner(:)          !< element of the analysis in which an element of the beam lies
      real(wp), allocatable :: curvature(:, :)  !< k of the hole, by element (2,e) [1/m]
      real(wp), allocatable :: bend(:, :)       !< b of the string, by element (2,e) [1/m]
      real(wp), allocatable :: torque(:)        !< M_t by element [N.m]
      real(wp), allocatable :: weight(:)        !< buoyed weight per length, by element [N/m]
      real(wp), allocatable :: ei(:)            !< by element [N.m2]
      type(gap_law_type), allocatable :: law(:) !< of a metre of wall, by element (stiffnesses in N/m2)
      real(wp), allocatable :: radius(:)        !< radius of contact r, by element [m]
      real(wp), allocatable :: along(:)         !< friction coefficient a, by element [-]
      real(wp), allocatable :: around(:)        !< friction coefficient m, by element [-]
      integer, allocatable :: point(:)             !< nodes at which tool joints touch, from the top down
      integer, allocatable :: point_owner(:)       !< element of the analysis in which it lies
      type(gap_law_type), allocatable :: point_law(:)  !< of the whole contact (stiffnesses in N/m)
   end type bending_beam_type

   !> The beam as it is bent.
   type :: bent_type
      real(wp), allocatable :: y(:, :)          !< offsets and slopes at the nodes (4,n) [m, -]
      !> Forces and moments at the nodes, from the equilibrium of the element below each node, its loads and contact taken into
      !> account; at the last node from the element above it. Minus the first and second are the force across the hole that the
      !> string below the node exerts on the string above it, along n_1 and n_2. Minus the third and fourth are the bending moment
      !> EI (k + y'' - b) there (4,n) [N, N.m].
      real(wp), allocatable :: forces(:, :)
      !> Contact forces R at the places of the elements, which lie at `contact_xi` of their lengths (contact_places,n-1) [N].
      real(wp), allocatable :: pressed(:, :)
      real(wp), allocatable :: points(:)        !< contact forces of the tool joints, in the order of beam%point [N]
   end type bent_type

   !> How the wall presses at a place.
   type :: wall_push_type
      logical :: touches       !< without which the others are not set
      real(wp) :: force        !< R [N/m, or N]
      real(wp) :: stiffness    !< derivative of R by the distance from the hole axis [N/m2, or N/m]
      real(wp) :: distance     !< from there [m]
      real(wp) :: n(2)         !< outwards
   end type wall_push_type

   !> How the wall presses at a shape of the beam.
   type :: beam_contact_type
      private
      type(wall_push_type), allocatable :: place(:, :)   !< of the elements (contact_places,n-1)
      type(wall_push_type), allocatable :: point(:)      !< of tool joints
   end type beam_contact_type

contains

   !> Matrix and load of everything but contact: residual = matrix y - load.
   pure subroutine set_linear_part(beam, matrix, load)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(out) :: matrix     !< 4 unknowns a node
      real(wp), contiguous, intent(out) :: load(:, :)                !< (4,n) [N, N.m]
      real(wp) :: straight(4, 4), turned(4, 4), f(8)
      integer :: e, n
      n = size(beam%md)
      matrix = new_block_matrix(n, node_unknowns)
      load = 0.0_wp
      do e = 1, n - 1
         call linear_element(beam, e, straight, turned, f)
         call add_block(straight(:2, :2), turned(:2, :2), matrix%diagonal(:, :, e))
         call add_block(straight(3:, 3:), turned(3:, 3:), matrix%diagonal(:, :, e + 1))
         call add_block(straight(:2, 3:), turned(:2, 3:), matrix%upper(:, :, e))
         call add_block(straight(3:, :2), turned(3:, :2), matrix%lower(:, :, e))
         load(:, e) = load(:, e) + f(:4)
         load(:, e + 1) = load(:, e + 1) + f(5:)
      end do
   end subroutine set_linear_part

   !> Adds to a block what couples offset and slope of one direction with the same, and with those of the other direction.
   pure subroutine add_block(straight, turned, block)
      real(wp), intent(in) :: straight(:, :), turned(:, :)   !< (2,2), parts of larger ones: assumed shapes copy nothing
      real(wp), intent(inout) :: block(4, 4)
      block(1:3:2, 1:3:2) = block(1:3:2, 1:3:2) + straight
      block(2:4:2, 2:4:2) = block(2:4:2, 2:4:2) + straight
      block(1:3:2, 2:4:2) = block(1:3:2, 2:4:2) + turned
      block(2:4:2, 1:3:2) = block(2:4:2, 1:3:2) - turned
   end subroutine add_block

   !> Matrices and load of one element but for contact [N/m, N, N.m]. The matrices are in the order (y, y') of one direction at the
   !> upper, then at the lower node: `straight` acts in each direction, `turned` from the second on the first, and minus it from the
   !> first on the second. The load is in the order (y_1, y_2, y_1', y_2'). Integrals of the cubic shape functions in closed form,
   !> where axial force and weight change linearly.
   pure subroutine linear_element(beam, e, straight, turned, f)
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: e
      real(wp), intent(out) :: straight(4, 4), turned(4, 4), f(8)
      real(wp) :: length, couple, upper(2), lower(2), bend(2), shear, turn, tight(2)
      length = beam%md(e + 1) - beam%md(e)
      associate (t => beam%axial(e:e + 1), k => beam%curvature(:, e), torque => beam%torque(e))
         shear = 12.0_wp*beam%ei(e)/length**3 + 0.6_wp*(t(1) + t(2))/length
         turn = 6.0_wp*beam%ei(e)/length**2
         couple = beam%ei(e)/length
         tight = length/30.0_wp*t
         straight(1, :) = [shear, turn + 0.1_wp*t(2), -shear, turn + 0.1_wp*t(1)]
         straight(2, :) = [straight(1, 2), 4.0_wp*couple + 3.0_wp*tight(1) + tight(2), -straight(1, 2), &
                           2.0_wp*couple - 0.5_wp*(tight(1) + tight(2))]
         straight(3, :) = -straight(1, :)
         straight(4, :) = [straight(1, 4), straight(2, 4), -straight(1, 4), 4.0_wp*couple + tight(1) + 3.0_wp*tight(2)]
         turn = torque/length
         turned(1, :) = [0.0_wp, turn, 0.0_wp, -turn]
         turned(2, :) = [-turn, -0.5_wp*torque, turn, -0.5_wp*torque]
         turned(3, :) = -turned(1, :)
         turned(4, :) = [turn, 0.5_wp*torque, -turn, 0.5_wp*torque]
         upper = (beam%weight(e)*beam%down(:, e) + t(1)*k)*length
         lower = (beam%weight(e)*beam%down(:, e + 1) + t(2)*k)*length
         bend = beam%ei(e)*(k - beam%bend(:, e))
         f(1:2) = 0.35_wp*upper + 0.15_wp*lower + torque*[k(2), -k(1)]
         f(3:4) = length*(upper/20.0_wp + lower/30.0_wp) + bend
         f(5:6) = 0.15_wp*upper + 0.35_wp*lower - torque*[k(2), -k(1)]
         f(7:8) = -length*(upper/30.0_wp + lower/20.0_wp) - bend
      end associate
   end subroutine linear_element

   !> Adds what contact makes at the shape y to a residual, and keeps how the wall presses there.
   pure subroutine add_contact(beam, y, residual, contact)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :)            !< (4,n) [m, -]
      real(wp), contiguous, intent(inout) :: residual(:, :)  !< (4,n) [N, N.m]
      type(beam_contact_type), intent(inout) :: contact      !< for add_contact_stiffness
      real(wp) :: across(2), couple(2)
      integer :: e, n, p
      if (.not. allocated(contact%place)) allocate (contact%place(contact_places, size(beam%ei)), contact%point(size(beam%point)))
      do e = 1, size(beam%ei)
         call press_element(beam%law(e), beam%md(e + 1) - beam%md(e), beam%along(e)*beam%radius(e), beam%around(e), &
                            y(:, e), y(:, e + 1), contact%place(:, e), residual(:, e), residual(:, e + 1))
      end do
      do p = 1, size(beam%point)
         n = beam%point(p)
         associate (push => contact%point(p))
            push%touches = length_of(y(1:2, n)) > beam%point_law(p)%clearance
            if (.not. push%touches) cycle
            e = min(n, size(beam%ei))
            call push_at(beam%point_law(p), y(1:2, n), push)
            call find_action(push, beam%along(e)*beam%radius(e), beam%around(e), across, couple)
         end associate
         residual(:, n) = residual(:, n) + [across, couple]
      end do
   end subroutine add_contact

   !> What contact makes at the places of one element.
   pure subroutine press_element(law, length, lever, around, upper, lower, push, above, below)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: length, lever, around           !< of the element; r a; m [m, m, -]
      real(wp), intent(in) :: upper(4), lower(4)              !< offsets and slopes of the element's nodes [m, -]
      type(wall_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout) :: above(4), below(4)           !< residuals of these nodes [N, N.m]
      real(wp) :: offset(2), value(4), slope(4), weight, across(2), couple(2), column(8)
      integer :: p
      weight = length/contact_places
      do p = 1, contact_places
         call find_contact(law%clearance, length, p, upper, lower, push(p)%touches, value, slope, offset)
         if (.not. push(p)%touches) cycle
         call push_at(law, offset, push(p))
         call find_action(push(p), lever, around, across, couple)
         column = weight*by_shape(value, across) + by_shape(weight*slope, couple)
         above = above + column(:4)
         below = below + column(5:)
      end do
   end subroutine press_element

   !> Adds to a matrix the derivatives of what contact makes.
   pure subroutine add_contact_stiffness(beam, contact, matrix)
      type(bending_beam_type), intent(in) :: beam
      type(beam_contact_type), intent(in) :: contact       !< of add_contact
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: by_across(2, 2), by_couple(2, 2)
      integer :: e, n, p
      do e = 1, size(beam%ei)
         if (.not. any(contact%place(:, e)%touches)) cycle
         call stiffen_element(beam%md(e + 1) - beam%md(e), beam%along(e)*beam%radius(e), beam%around(e), contact%place(:, e), &
                              matrix%diagonal(:, :, e), matrix%upper(:, :, e), matrix%lower(:, :, e), matrix%diagonal(:, :, e + 1))
      end do
      do p = 1, size(beam%point)
         if (.not. contact%point(p)%touches) cycle
         n = beam%point(p)
         e = min(n, size(beam%ei))
         call find_stiffness(contact%point(p), beam%along(e)*beam%radius(e), beam%around(e), by_across, by_couple)
         matrix%diagonal(1:2, 1:2, n) = matrix%diagonal(1:2, 1:2, n) + by_across
         matrix%diagonal(3:4, 1:2, n) = matrix%diagonal(3:4, 1:2, n) + by_couple
      end do
   end subroutine add_contact_stiffness

   !> Adds the stiffness of one element's contact to the blocks of its nodes.
   pure subroutine stiffen_element(length, lever, around, push, upper, right, left, lower)
      real(wp), intent(in) :: length, lever, around           !< of the element; r a; m [m, m, -]
      type(wall_push_type), intent(in) :: push(contact_places)
      real(wp), intent(inout), dimension(4, 4) :: upper, right, left, lower   !< rows of the upper node, then of the lower one
      real(wp) :: value(4), slope(4), weight, by_across(2, 2), by_couple(2, 2), column(8)
      integer :: p, c
      weight = length/contact_places
      do p = 1, contact_places
         if (.not. push(p)%touches) cycle
         value = contact_value(:, p)*[1.0_wp, length, 1.0_wp, length]
         slope = weight*(contact_slope(:, p)*[1.0_wp/length, 1.0_wp, 1.0_wp/length, 1.0_wp])
         call find_stiffness(push(p), lever, around, by_across, by_couple)
         do c = 1, 2
            column = weight*by_shape(value, by_across(:, c)) + by_shape(slope, by_couple(:, c))
            upper(:, c) = upper(:, c) + value(1)*column(:4)
            upper(:, c + 2) = upper(:, c + 2) + value(2)*column(:4)
            right(:, c) = right(:, c) + value(3)*column(:4)
            right(:, c + 2) = right(:, c + 2) + value(4)*column(:4)
            left(:, c) = left(:, c) + value(1)*column(5:)
            left(:, c + 2) = left(:, c + 2) + value(2)*column(5:)
            lower(:, c) = lower(:, c) + value(3)*column(5:)
            lower(:, c + 2) = lower(:, c + 2) + value(4)*column(5:)
         end do
      end do
   end subroutine stiffen_element

   !> Whether the string touches at a place of an element, and how it lies there. Where it does not touch, slope is not set.
   pure subroutine find_contact(clearance, length, p, upper, lower, touches, value, slope, offset)
      real(wp), intent(in) :: clearance, length        !< of the element [m]
      integer, intent(in) :: p
      real(wp), intent(in) :: upper(4), lower(4)       !< offsets and slopes of the element's nodes [m, -]
      logical, intent(out) :: touches
      real(wp), intent(out) :: value(4), slope(4)      !< shape functions and their slopes
      real(wp), intent(out) :: offset(2)               !< [m]
      value = contact_value(:, p)*[1.0_wp, length, 1.0_wp, length]
      offset = offset_by(value, upper, lower)
      touches = offset(1)**2 + offset(2)**2 > clearance**2
      if (touches) slope = contact_slope(:, p)*[1.0_wp/length, 1.0_wp, 1.0_wp/length, 1.0_wp]
   end subroutine find_contact

   !> A vector across the hole on each of an element's unknowns, by the values of their shape functions.
   pure function by_shape(shape, vector) result(all)
      real(wp), intent(in) :: shape(4), vector(2)
      real(wp) :: all(8)
      all(1:2) = shape(1)*vector
      all(3:4) = shape(2)*vector
      all(5:6) = shape(3)*vector
      all(7:8) = shape(4)*vector
   end function by_shape

   !> Offset of a point of an element by the values of the shape functions there, or its derivative by theirs.
   pure function offset_by(shape, upper, lower) result(offset)
      real(wp), intent(in) :: shape(4)
      real(wp), intent(in) :: upper(4), lower(4)      !< of the element's nodes [m, -]
      real(wp) :: offset(2)
      offset = shape(1)*upper(1:2) + shape(2)*upper(3:4) + shape(3)*lower(1:2) + shape(4)*lower(3:4)
   end function offset_by

   !> Length of a vector across the hole.
   pure function length_of(vector) result(length)
      real(wp), intent(in) :: vector(2)
      real(wp) :: length
      length = sqrt(vector(1)**2 + vector(2)**2)
   end function length_of

   !> How the wall presses where the string touches. A law for a metre of wall gives it per metre.
   pure subroutine push_at(law, offset, push)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: offset(2)   !< not zero [m]
      type(wall_push_type), intent(inout) :: push
      push%distance = length_of(offset)
      call contact_force(law, merge(state_rigid, state_elastic, push%distance > (1.0_wp + law%eps_nmax)*law%clearance), &
                         push%distance, push%force, push%stiffness)
      push%n = offset/push%distance
   end subroutine push_at

   !> What the wall adds to the residual: R (n + m t x n) on the offset, r a R n on the slope.
   pure subroutine find_action(push, lever, around, across, couple)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(out) :: across(2), couple(2)
      across = push%force*(push%n + around*[-push%n(2), push%n(1)])
      couple = lever*push%force*push%n
   end subroutine find_action

   !> Derivatives of these by the offset.
   pure subroutine find_stiffness(push, lever, around, by_across, by_couple)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(out) :: by_across(2, 2), by_couple(2, 2)
      real(wp) :: tau(2)
      integer :: i
      associate (n => push%n, stiffness => push%stiffness, force => push%force, distance => push%distance)
         tau = [-n(2), n(1)]
         do i = 1, 2
            by_across(:, i) = (stiffness*n(i))*n + (force/distance*tau(i))*tau
         end do
         by_couple = lever*by_across
         if (.not. abs(around) > 0.0_wp) return
         do i = 1, 2
            by_across(:, i) = by_across(:, i) + (around*stiffness*n(i))*tau - (around*force/distance*tau(i))*n
         end do
      end associate
   end subroutine find_stiffness

   !> Forces along the beam at a shape.
   pure subroutine find_forces(beam, y, bent)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :)        !< (4,n) [m, -]
      type(bent_type), intent(out) :: bent
      type(wall_push_type) :: push
      real(wp) :: straight(4, 4), turned(4, 4), f(8), all(8), offset(2), across(2), couple(2), value(4), slope(4), &
                  length, weight
      logical :: touches
      integer :: e, n, p, j
      n = size(y, 2)
      bent%y = y
      allocate (bent%forces(4, n), bent%pressed(contact_places, n - 1), bent%points(size(beam%point)))
      bent%pressed = 0.0_wp
      bent%points = 0.0_wp
      do e = 1, n - 1
         call linear_element(beam, e, straight, turned, f)
         all = -f
         do j = 1, 2
            all(1::2) = all(1::2) + straight(:, j)*y(2*j - 1, e) + turned(:, j)*y(2*j, e) &
                        + straight(:, j + 2)*y(2*j - 1, e + 1) + turned(:, j + 2)*y(2*j, e + 1)
            all(2::2) = all(2::2) + straight(:, j)*y(2*j, e) - turned(:, j)*y(2*j - 1, e) &
                        + straight(:, j + 2)*y(2*j, e + 1) - turned(:, j + 2)*y(2*j - 1, e + 1)
         end do
         length = beam%md(e + 1) - beam%md(e)
         weight = length/contact_places
         do p = 1, contact_places
            call find_contact(beam%law(e)%clearance, length, p, y(:, e), y(:, e + 1), touches, value, slope, offset)
            if (.not. touches) cycle
            call push_at(beam%law(e), offset, push)
            call find_action(push, beam%along(e)*beam%radius(e), beam%around(e), across, couple)
            bent%pressed(p, e) = weight*push%force
            all = all + by_shape(weight*value, across) + by_shape(weight*slope, couple)
         end do
         bent%forces(:, e) = all(:4)
         if (e == n - 1) bent%forces(:, n) = -all(5:)
      end do
      do p = 1, size(beam%point)
         offset = y(1:2, beam%point(p))
         if (.not. length_of(offset) > beam%point_law(p)%clearance) cycle
         call push_at(beam%point_law(p), offset, push)
         bent%points(p) = push%force
      end do
   end subroutine find_forces

   !> Second derivative y'' by the shape of one element, at its upper (first column) and its lower end, along n_1 and n_2 [1/m].
   !> EI (k + y'' - b) is the bending moment by that shape. Where it jumps from one element to the next, the elements are too long.
   pure function curvature_within(length, upper, lower) result(bend)
      real(wp), intent(in) :: length                  !< of the element [m]
      real(wp), intent(in) :: upper(4), lower(4)      !< offsets and slopes of its nodes, or changes of these [m, -]
      real(wp) :: bend(2, 2)
      real(wp) :: chord(2)
      chord = 3.0_wp*(lower(1:2) - upper(1:2))/length
      bend(:, 1) = 2.0_wp*(chord - 2.0_wp*upper(3:4) - lower(3:4))/length
      bend(:, 2) = 2.0_wp*(2.0_wp*lower(3:4) + upper(3:4) - chord)/length
   end function curvature_within
end module dg_bending_beam

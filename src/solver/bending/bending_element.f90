!> One element of a bending beam: forces on its nodes by bending, tension, torque, loads and the wall, and their derivatives.
!> The equation is in the header of dg_bending_beam. Its integrals are those of the cubic shape functions, in closed form where
!> axial force and weight change linearly. The integral over the wall is the sum over `contact_places` places.
module dg_bending_element
   use dg_kinds, only: wp
   use dg_beam_section, only: beam_section_type, end_stiffness
   use dg_gap_state, only: contact_force, gap_law_type, state_elastic, state_rigid
   use dg_hermite, only: hermite_line_load
   implicit none
   private
   public :: beam_element_type, wall_push_type, contact_places, contact_xi
   public :: set_element, push_element, push_at, element_action, element_stiffness, add_action, add_stiffness, moments_of_shape

   !> Number of places of an element at which the wall is felt. A node has an offset and a slope to each side. More than two
   !> places would leave a string on the wall no freedom to bend along it.
   integer, parameter :: contact_places = 2
   real(wp), parameter :: third = 1.0_wp/sqrt(3.0_wp)
   real(wp), parameter :: contact_xi(contact_places) = [0.5_wp*(1.0_wp - third), 0.5_wp*(1.0_wp + third)]
   !> Shape functions of y and y' at these places for an element of unit length, at the upper, then at the lower node. Then
   !> their slopes.
   real(wp), parameter :: one_minus_xi(contact_places) = 1.0_wp - contact_xi
   real(wp), parameter :: contact_value(4, contact_places) = transpose(reshape( &
      [one_minus_xi**2*(1.0_wp + 2.0_wp*contact_xi), contact_xi*one_minus_xi**2, &
       contact_xi**2*(1.0_wp + 2.0_wp*one_minus_xi), -one_minus_xi*contact_xi**2], [contact_places, 4]))
   real(wp), parameter :: contact_slope(4, contact_places) = transpose(reshape( &
      [-6.0_wp*contact_xi*one_minus_xi, one_minus_xi*(1.0_wp - 3.0_wp*contact_xi), &
       6.0_wp*contact_xi*one_minus_xi, -contact_xi*(3.0_wp*one_minus_xi - 1.0_wp)], [contact_places, 4]))

   type :: beam_element_type
      ! set by the maker of the beam
      type(gap_law_type) :: law          !< of a metre of wall (stiffnesses in N/m2)
      type(gap_law_type) :: press        !< the same law, no stiffer than Newton's steps tolerate
      type(beam_section_type) :: section !< its length is set by set_element
      real(wp) :: moved(contact_places) = 0.0_wp      !< how far inwards that wall is moved at the places of contact [m]
      real(wp) :: blade(2) = 0.0_wp      !< e, centre of eccentric blades from the axis of the string [m]
      real(wp) :: lever = 0.0_wp         !< r a, radius of contact times friction coefficient along the hole [m]
      real(wp) :: around = 0.0_wp        !< friction coefficient m around the hole [-]
      ! set by set_element
      real(wp) :: length = 0.0_wp        !< [m]
      real(wp) :: per_length = 0.0_wp    !< one over it [1/m]
      real(wp) :: bent(2) = 0.0_wp       !< k - b [1/m]
      real(wp) :: torque(2) = 0.0_wp     !< M_t/2 [N.m], M_t over the length [N]
      ! stiffness coefficients, each including the axial force: 12 EI/L^3, 6 EI/L^2, and 4, 2, 4 EI/L
      real(wp) :: k_offset = 0.0_wp           !< force by the offset of the upper node from the lower one [N/m]
      real(wp) :: k_offset_slope(2) = 0.0_wp  !< couple at the upper and at the lower node by that offset [N]
      real(wp) :: k_slope(3) = 0.0_wp         !< couple at the upper node by its own slope, by the lower slope; at the lower node by
                                              !< its own slope [N.m]
      real(wp) :: load(8) = 0.0_wp       !< load of weight and bends on (y_1, y_2, y_1', y_2') of the upper, then the lower node [N,
                                         !< N.m]
   end type beam_element_type

   !> Push of the wall at a node, or on the half of an element that belongs to a place of contact.
   type :: wall_push_type
      real(wp) :: force = 0.0_wp         !< R [N]; 0 without contact, and then the others are not set
      real(wp) :: stiffness = 0.0_wp     !< derivative of R by the distance from the hole axis [N/m]
      real(wp) :: turning = 0.0_wp       !< R over that distance [N/m]
      real(wp) :: n(2) = 0.0_wp          !< direction outwards [-]
   end type wall_push_type

contains

   !> Set all but section, law and friction of an element. Axial force and weight change linearly along it.
   pure subroutine set_element(length, axial, torque, curvature, bend, weight, down, element)
      real(wp), intent(in) :: length           !< [m]
      real(wp), intent(in) :: axial(2)         !< T at its nodes [N]
      real(wp), intent(in) :: torque           !< M_t [N.m]
      real(wp), intent(in) :: curvature(2)     !< k [1/m]
      real(wp), intent(in) :: bend(2)          !< b [1/m]
      real(wp), intent(in) :: weight           !< buoyed, per length [N/m]
      real(wp), intent(in) :: down(2, 2)       !< unit vector downwards, its components across the hole, at its nodes (2,2) [-]
      type(beam_element_type), intent(inout) :: element
      real(wp) :: ends(2), tight(2), upper(2), lower(2), bending(2), turning(2)
      element%section%length = length
      ends = end_stiffness(element%section)
      tight = (length/30.0_wp)*axial
      element%length = length
      element%per_length = 1.0_wp/length
      element%bent = curvature - bend
      element%torque(1) = 0.5_wp*torque
      element%torque(2) = torque/length
      element%k_offset = (2.0_wp*sum(ends)/length + 0.6_wp*(axial(1) + axial(2)))/length
      element%k_offset_slope(1) = sum(ends)/length + 0.1_wp*axial(2)
      element%k_offset_slope(2) = sum(ends)/length + 0.1_wp*axial(1)
      element%k_slope(1) = ends(1) + 3.0_wp*tight(1) + tight(2)
      element%k_slope(2) = ends(2) - 0.5_wp*(tight(1) + tight(2))
      element%k_slope(3) = ends(1) + tight(1) + 3.0_wp*tight(2)
      upper = (weight*down(:, 1) + axial(1)*curvature)*length
      lower = (weight*down(:, 2) + axial(2)*curvature)*length
      bending = element%section%ei*element%bent
      turning(1) = torque*curvature(2)
      turning(2) = -torque*curvature(1)
      element%load(1:2) = 0.35_wp*upper + 0.15_wp*lower + turning
      element%load(3:4) = length*(upper/20.0_wp + lower/30.0_wp) + bending
      element%load(5:6) = 0.15_wp*upper + 0.35_wp*lower - turning
      element%load(7:8) = -length*(upper/30.0_wp + lower/20.0_wp) - bending
   end subroutine set_element

   !> Add a load that is constant along an element.
   pure subroutine push_element(load, element)
      real(wp), intent(in) :: load(2)     !< [N/m]
      type(beam_element_type), intent(inout) :: element
      real(wp) :: line(4)
      line = hermite_line_load(element%length)
      element%load = element%load + [line(1)*load, line(2)*load, line(3)*load, line(4)*load]
   end subroutine push_element

   !> Forces and couples that hold an element's nodes at a given shape, and the push of the wall. Their sum over the elements
   !> is zero at equilibrium. Those of the upper node are added to `at_upper`.
   pure subroutine element_action(element, upper, lower, push, at_upper, at_lower)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in) :: upper(4), lower(4)       !< offsets and slopes of its nodes [m, -]
      type(wall_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout) :: at_upper(4)           !< [N, N.m]
      real(wp), intent(out) :: at_lower(4)             !< the same at the lower node [N, N.m]
      real(wp) :: value(4), slope(4), force(2), couple(2), twisted(2)
      integer :: p
      associate (d => upper(1:2) - lower(1:2), u => upper(3:4), v => lower(3:4), torque => element%torque)
         force = element%k_offset*d + element%k_offset_slope(1)*u + element%k_offset_slope(2)*v - turned(torque(2)*(u - v))
         twisted = turned(torque(2)*d + torque(1)*(u + v))
         at_upper(1:2) = at_upper(1:2) + (force - element%load(1:2))
         at_upper(3:4) = at_upper(3:4) &
                         + (element%k_offset_slope(1)*d + element%k_slope(1)*u + element%k_slope(2)*v + twisted - element%load(3:4))
         at_lower(1:2) = -force - element%load(5:6)
         at_lower(3:4) = element%k_offset_slope(2)*d + element%k_slope(2)*u + element%k_slope(3)*v - twisted - element%load(7:8)
      end associate
      do p = 1, contact_places
         call shapes_at(element, p, value, slope)
         call push_at(element%press, element%moved(p), 0.5_wp*element%length, &
                      element%blade + value(1)*upper(1:2) + value(2)*upper(3:4) + value(3)*lower(1:2) + value(4)*lower(3:4), &
                      push(p))
         if (.not. push(p)%force > 0.0_wp) cycle
         call find_action(push(p), element%lever, element%around, force, couple)
         at_upper(1:2) = at_upper(1:2) + (value(1)*force + slope(1)*couple)
         at_upper(3:4) = at_upper(3:4) + (value(2)*force + slope(2)*couple)
         at_lower(1:2) = at_lower(1:2) + (value(3)*force + slope(3)*couple)
         at_lower(3:4) = at_lower(3:4) + (value(4)*force + slope(4)*couple)
      end do
   end subroutine element_action

   !> Derivatives of these by offsets and slopes, at a given push of the wall. Without the wall the block of two unknowns is
   !> a*I + c*t x I. The torque gives c, which couples the two directions with opposite signs.
   pure subroutine element_stiffness(element, push, k)
      type(beam_element_type), intent(in) :: element
      type(wall_push_type), intent(in) :: push(contact_places)
      real(wp), intent(out) :: k(2, 4, 2, 4)       !< (direction, unknown) of row, then of column [N/m, N, N.m]
      real(wp) :: straight(4, 4), across(4, 4), stiffness(2, 2), sideways(2, 2), pushed(2, 4, 2), value(4), slope(4)
      integer :: i, j, p
      associate (s => element%k_offset, t => element%k_offset_slope, c => element%k_slope)
         straight(:, 1) = [s, t(1), -s, t(2)]
         straight(:, 2) = [t(1), c(1), -t(1), c(2)]
         straight(:, 3) = -straight(:, 1)
         straight(:, 4) = [t(2), c(2), -t(2), c(3)]
      end associate
      associate (twist => element%torque(1), turn => element%torque(2))
         across(:, 1) = [0.0_wp, turn, 0.0_wp, -turn]
         across(:, 2) = [-turn, twist, turn, -twist]
         across(:, 3) = -across(:, 1)
         across(:, 4) = [turn, twist, -turn, -twist]
      end associate
      k(1, :, 1, :) = straight
      k(2, :, 1, :) = across
      k(1, :, 2, :) = -across
      k(2, :, 2, :) = straight
      do p = 1, contact_places
         if (.not. push(p)%force > 0.0_wp) cycle
         call shapes_at(element, p, value, slope)
         call find_stiffness(push(p), element%around, stiffness, sideways)
         do i = 1, 4
            pushed(:, i, :) = value(i)*sideways + (slope(i)*element%lever)*stiffness
         end do
         do j = 1, 4
            k(:, :, :, j) = k(:, :, :, j) + value(j)*pushed
         end do
      end do
   end subroutine element_stiffness

   !> Shape functions of an element's unknowns at a place of contact [-, m], and their slopes [1/m, -].
   pure subroutine shapes_at(element, p, value, slope)
      type(beam_element_type), intent(in) :: element
      integer, intent(in) :: p
      real(wp), intent(out) :: value(4), slope(4)
      value = contact_value(:, p)*[1.0_wp, element%length, 1.0_wp, element%length]
      slope = contact_slope(:, p)*[element%per_length, 1.0_wp, element%per_length, 1.0_wp]
   end subroutine shapes_at

   !> Vector t x v: a vector across the hole, turned by a right angle.
   pure function turned(vector) result(other)
      real(wp), intent(in) :: vector(2)
      real(wp) :: other(2)
      other(1) = -vector(2)
      other(2) = vector(1)
   end function turned

   !> Push of the wall at an offset, by the law of dg_gap_state.
   pure subroutine push_at(law, moved, length, offset, push)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: moved       !< how far inwards the wall is moved [m]
      real(wp), intent(in) :: length      !< length of wall that presses there, for a law per metre of wall [m]; else 1
      real(wp), intent(in) :: offset(2)   !< from the hole axis [m]
      type(wall_push_type), intent(inout) :: push
      real(wp) :: distance, force, stiffness
      push%force = 0.0_wp
      distance = sqrt(offset(1)**2 + offset(2)**2)
      if (.not. distance + moved > law%clearance) return
      call contact_force(law, merge(state_rigid, state_elastic, distance + moved > (1.0_wp + law%eps_nmax)*law%clearance), &
                         distance + moved, force, stiffness)
      push%force = length*force
      push%stiffness = length*stiffness
      push%turning = push%force/distance
      push%n = offset/distance
   end subroutine push_at

   !> Force and couple of the wall: R (n + m t x n) on the offset, r a R n on the slope.
   pure subroutine find_action(push, lever, around, force, couple)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(out) :: force(2)   !< [N]
      real(wp), intent(out) :: couple(2)  !< [N.m]
      force = push%force*push%n
      couple = lever*force
      force = force + around*turned(force)
   end subroutine find_action

   !> Derivatives by the offset of R n, and of R (n + m t x n), with friction around the hole.
   pure subroutine find_stiffness(push, around, stiffness, sideways)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: around            !< m [-]
      real(wp), intent(out) :: stiffness(2, 2)  !< [N/m]
      real(wp), intent(out) :: sideways(2, 2)   !< [N/m]
      real(wp) :: steep
      steep = push%stiffness - push%turning
      stiffness(1, 1) = push%turning + steep*push%n(1)*push%n(1)
      stiffness(2, 1) = steep*push%n(1)*push%n(2)
      stiffness(1, 2) = stiffness(2, 1)
      stiffness(2, 2) = push%turning + steep*push%n(2)*push%n(2)
      sideways(1, :) = stiffness(1, :) - around*stiffness(2, :)
      sideways(2, :) = stiffness(2, :) + around*stiffness(1, :)
   end subroutine find_stiffness

   !> Add force and couple of the wall at a node.
   pure subroutine add_action(push, lever, around, action)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(inout) :: action(4)   !< force and couple, changed here (4) [N, N.m]
      real(wp) :: force(2), couple(2)
      call find_action(push, lever, around, force, couple)
      action = action + [force, couple]
   end subroutine add_action

   !> Add their derivatives by the node's offset.
   pure subroutine add_stiffness(push, lever, around, block)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(inout) :: block(:, :)    !< (4,4) [N/m, N]
      real(wp) :: stiffness(2, 2), sideways(2, 2)
      call find_stiffness(push, around, stiffness, sideways)
      block(1:2, 1:2) = block(1:2, 1:2) + sideways
      block(3:4, 1:2) = block(3:4, 1:2) + lever*stiffness
   end subroutine add_stiffness

   !> Bending moments EI (k + y'' - b) by the shape of an element at its upper (first column) and its lower end [N.m].
   pure subroutine moments_of_shape(element, upper, lower, moments)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in) :: upper(4), lower(4)   !< offsets and slopes of its nodes [m, -]
      real(wp), intent(out) :: moments(2, 2)       !< (2, ends) [N.m]
      real(wp) :: ends(2), chord(2), bending(2)
      ends = end_stiffness(element%section)
      bending = element%section%ei*element%bent
      chord = (sum(ends)*element%per_length)*(lower(1:2) - upper(1:2))
      moments(:, 1) = chord - ends(1)*upper(3:4) - ends(2)*lower(3:4) + bending
      moments(:, 2) = ends(1)*lower(3:4) + ends(2)*upper(3:4) - chord + bending
   end subroutine moments_of_shape
end module dg_bending_element

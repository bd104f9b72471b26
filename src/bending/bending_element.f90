!> One element of a bending beam: what bending, tension, torque, loads and the wall do to its nodes, and the derivatives of that.
!> The equation is in the header of dg_bending_beam. Its integrals are those of the cubic shape functions, in closed form where
!> axial force and weight change linearly; the wall's is taken at `contact_places` places.
module dg_bending_element
   use dg_kinds, only: wp
   use dg_gap_state, only: gap_law_type
   implicit none
   private
   public :: beam_element_type, wall_push_type, contact_places, contact_xi
   public :: set_element, element_action, element_matrix, push_at, add_action, add_stiffness, moments_of_shape, raise_moments

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

   type :: beam_element_type
      ! set by who makes the beam
      type(gap_law_type) :: law          !< of a metre of wall (stiffnesses in N/m2)
      real(wp) :: lever = 0.0_wp         !< r a, radius of contact times friction coefficient along the hole [m]
      real(wp) :: around = 0.0_wp        !< friction coefficient m around the hole [-]
      ! set by set_element
      real(wp) :: length = 0.0_wp        !< [m]
      real(wp) :: per_length = 0.0_wp    !< one over it [1/m]
      real(wp) :: ei = 0.0_wp            !< [N.m2]
      real(wp) :: bent(2) = 0.0_wp       !< k - b [1/m]
      real(wp) :: torque(2) = 0.0_wp     !< M_t/2 [N.m], M_t over the length [N]
      real(wp) :: shear = 0.0_wp         !< force by the offset of the upper node from that of the lower one [N/m]
      real(wp) :: turn(2) = 0.0_wp       !< couple at the upper and at the lower node by the same [N]
      real(wp) :: couple(3) = 0.0_wp     !< at the upper node by its slope, by the slope of the lower node, and there [N.m]
      real(wp) :: load(8) = 0.0_wp       !< of weight and bends, (y_1, y_2, y_1', y_2') at the upper, then the lower node [N, N.m]
   end type beam_element_type

   !> How the wall presses at a place.
   type :: wall_push_type
      real(wp) :: force = 0.0_wp         !< R; 0 where nothing touches, and the others are then not set [N/m, or N]
      real(wp) :: stiffness = 0.0_wp     !< derivative of R by the distance from the hole axis [N/m2, or N/m]
      real(wp) :: turning = 0.0_wp       !< R over that distance [N/m2, or N/m]
      real(wp) :: n(2) = 0.0_wp          !< outwards
   end type wall_push_type

contains

   !> Sets what an element needs but law and friction. Axial force and weight change linearly along it.
   pure subroutine set_element(length, ei, axial, torque, curvature, bend, weight, down, element)
      real(wp), intent(in) :: length           !< [m]
      real(wp), intent(in) :: ei               !< [N.m2]
      real(wp), intent(in) :: axial(2)         !< T at its nodes [N]
      real(wp), intent(in) :: torque           !< M_t [N.m]
      real(wp), intent(in) :: curvature(2)     !< k [1/m]
      real(wp), intent(in) :: bend(2)          !< b [1/m]
      real(wp), intent(in) :: weight           !< buoyed, per length [N/m]
      real(wp), intent(in) :: down(2, 2)       !< part of the unit vector downwards across the hole, at its nodes (2,2) [-]
      type(beam_element_type), intent(inout) :: element
      real(wp) :: stiffness, tight(2), upper(2), lower(2), bending(2), turning(2)
      stiffness = ei/length
      tight = (length/30.0_wp)*axial
      element%length = length
      element%per_length = 1.0_wp/length
      element%ei = ei
      element%bent = curvature - bend
      element%torque(1) = 0.5_wp*torque
      element%torque(2) = torque/length
      element%shear = (12.0_wp*stiffness/length + 0.6_wp*(axial(1) + axial(2)))/length
      element%turn(1) = 6.0_wp*stiffness/length + 0.1_wp*axial(2)
      element%turn(2) = 6.0_wp*stiffness/length + 0.1_wp*axial(1)
      element%couple(1) = 4.0_wp*stiffness + 3.0_wp*tight(1) + tight(2)
      element%couple(2) = 2.0_wp*stiffness - 0.5_wp*(tight(1) + tight(2))
      element%couple(3) = 4.0_wp*stiffness + tight(1) + 3.0_wp*tight(2)
      upper = (weight*down(:, 1) + axial(1)*curvature)*length
      lower = (weight*down(:, 2) + axial(2)*curvature)*length
      bending = ei*element%bent
      turning(1) = torque*curvature(2)
      turning(2) = -torque*curvature(1)
      element%load(1:2) = 0.35_wp*upper + 0.15_wp*lower + turning
      element%load(3:4) = length*(upper/20.0_wp + lower/30.0_wp) + bending
      element%load(5:6) = 0.15_wp*upper + 0.35_wp*lower - turning
      element%load(7:8) = -length*(upper/30.0_wp + lower/20.0_wp) - bending
   end subroutine set_element

   !> Forces and couples that an element's nodes must be held with at a shape, and how the wall presses. Over the elements they add
   !> up to zero at equilibrium: those of the upper node are added to what is there.
   pure subroutine element_action(element, upper, lower, push, action)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in) :: upper(4), lower(4)        !< offsets and slopes of its nodes [m, -]
      type(wall_push_type), intent(inout) :: push(contact_places)
      real(wp), intent(inout) :: action(8)              !< in the order of the loads [N, N.m]
      real(wp), dimension(2) :: difference, turn, couple, force, offset, far
      real(wp) :: square
      integer :: p
      difference = upper(1:2) - lower(1:2)
      turn = element%torque(2)*(upper(3:4) - lower(3:4))
      couple = element%torque(2)*difference + element%torque(1)*(upper(3:4) + lower(3:4))
      force = element%shear*difference + element%turn(1)*upper(3:4) + element%turn(2)*lower(3:4)
      force(1) = force(1) + turn(2)
      force(2) = force(2) - turn(1)
      action(1:2) = action(1:2) + (force - element%load(1:2))
      action(5:6) = -force - element%load(5:6)
      force = element%turn(1)*difference + element%couple(1)*upper(3:4) + element%couple(2)*lower(3:4) - element%load(3:4)
      force(1) = force(1) - couple(2)
      force(2) = force(2) + couple(1)
      action(3:4) = action(3:4) + force
      force = element%turn(2)*difference + element%couple(2)*upper(3:4) + element%couple(3)*lower(3:4) - element%load(7:8)
      force(1) = force(1) + couple(2)
      force(2) = force(2) - couple(1)
      action(7:8) = force
      do p = 1, contact_places
         far = contact_value(2, p)*upper(3:4) + contact_value(4, p)*lower(3:4)
         offset = contact_value(1, p)*upper(1:2) + contact_value(3, p)*lower(1:2) + element%length*far
         square = offset(1)**2 + offset(2)**2
         push(p)%force = 0.0_wp
         if (.not. square > element%law%clearance**2) cycle
         call push_at(element%law, offset, square, push(p))
         call add_push(element, p, push(p), action)
      end do
   end subroutine element_action

   !> What the wall adds at one place of an element.
   pure subroutine add_push(element, p, push, action)
      type(beam_element_type), intent(in) :: element
      integer, intent(in) :: p
      type(wall_push_type), intent(in) :: push
      real(wp), intent(inout) :: action(8)
      real(wp) :: force, across(2), couple(2)
      force = push%force*element%length/contact_places
      across(1) = force*(push%n(1) - element%around*push%n(2))
      across(2) = force*(push%n(2) + element%around*push%n(1))
      couple = (force*element%lever*element%per_length)*push%n
      action(1:2) = action(1:2) + (contact_value(1, p)*across + contact_slope(1, p)*couple)
      action(3:4) = action(3:4) + element%length*(contact_value(2, p)*across + contact_slope(2, p)*couple)
      action(5:6) = action(5:6) + (contact_value(3, p)*across + contact_slope(3, p)*couple)
      action(7:8) = action(7:8) + element%length*(contact_value(4, p)*across + contact_slope(4, p)*couple)
   end subroutine add_push

   !> Derivatives of an element's action by the offsets and slopes of its nodes, row by row: matrix(:, i) is the derivative of the
   !> i-th force, and one more pair of numbers that is left alone. Those of the upper node's action by its own unknowns are added to
   !> what is there.
   pure subroutine element_matrix(element, push, matrix)
      type(beam_element_type), intent(in) :: element
      type(wall_push_type), intent(in) :: push(contact_places)   !< of element_action
      real(wp), intent(inout) :: matrix(2, 5, 2, 4)              !< (direction, shape; direction, shape) of column, then of row
      integer :: p
      associate (shear => element%shear, up => element%turn(1), down => element%turn(2), couple => element%couple, &
                 twist => element%torque(1), turn => element%torque(2))
         call add_pair(shear, 0.0_wp, matrix(:, 1, :, 1))
         call add_pair(up, turn, matrix(:, 2, :, 1))
         call put_pair(-shear, 0.0_wp, matrix(:, 3, :, 1))
         call put_pair(down, -turn, matrix(:, 4, :, 1))
         call add_pair(up, -turn, matrix(:, 1, :, 2))
         call add_pair(couple(1), -twist, matrix(:, 2, :, 2))
         call put_pair(-up, turn, matrix(:, 3, :, 2))
         call put_pair(couple(2), -twist, matrix(:, 4, :, 2))
         call put_pair(-shear, 0.0_wp, matrix(:, 1, :, 3))
         call put_pair(-up, -turn, matrix(:, 2, :, 3))
         call put_pair(shear, 0.0_wp, matrix(:, 3, :, 3))
         call put_pair(-down, turn, matrix(:, 4, :, 3))
         call put_pair(down, turn, matrix(:, 1, :, 4))
         call put_pair(couple(2), twist, matrix(:, 2, :, 4))
         call put_pair(-down, -turn, matrix(:, 3, :, 4))
         call put_pair(couple(3), twist, matrix(:, 4, :, 4))
      end associate
      do p = 1, contact_places
         if (push(p)%force > 0.0_wp) call add_wall(element, push(p), contact_value(:, p), contact_slope(:, p), matrix)
      end do
   end subroutine element_matrix

   !> What couples one unknown in both directions with another: `straight` in each direction, `turned` from the second on the first,
   !> and minus it from the first on the second.
   pure subroutine put_pair(straight, turned, pair)
      real(wp), intent(in) :: straight, turned
      real(wp), intent(inout) :: pair(:, :)   !< (2,2), part of a larger array
      pair(1, 1) = straight
      pair(2, 1) = turned
      pair(1, 2) = -turned
      pair(2, 2) = straight
   end subroutine put_pair

   !> The same, added to what is there.
   pure subroutine add_pair(straight, turned, pair)
      real(wp), intent(in) :: straight, turned
      real(wp), intent(inout) :: pair(:, :)
      pair(1, 1) = pair(1, 1) + straight
      pair(2, 1) = pair(2, 1) + turned
      pair(1, 2) = pair(1, 2) - turned
      pair(2, 2) = pair(2, 2) + straight
   end subroutine add_pair

   !> What the wall at one place of an element adds to its matrix.
   pure subroutine add_wall(element, push, shape, slopes, matrix)
      type(beam_element_type), intent(in) :: element
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: shape(4), slopes(4)         !< shape functions there, of an element of unit length
      real(wp), intent(inout) :: matrix(2, 5, 8)
      real(wp) :: stiffness(2, 2), rows(2, 2, 4), second, fourth, lever
      stiffness = stiffness_of(push, element%length/contact_places)
      second = element%length*shape(2)
      fourth = element%length*shape(4)
      lever = element%lever*element%per_length
      rows(:, :, 1) = (shape(1) + lever*slopes(1))*stiffness
      rows(:, :, 2) = (second + element%lever*slopes(2))*stiffness
      rows(:, :, 3) = (shape(3) + lever*slopes(3))*stiffness
      rows(:, :, 4) = (fourth + element%lever*slopes(4))*stiffness
      if (abs(element%around) > 0.0_wp) then
         call add_turned(element%around*shape(1), stiffness, rows(:, :, 1))
         call add_turned(element%around*second, stiffness, rows(:, :, 2))
         call add_turned(element%around*shape(3), stiffness, rows(:, :, 3))
         call add_turned(element%around*fourth, stiffness, rows(:, :, 4))
      end if
      call add_rows([shape(1), second, shape(3), fourth], rows, matrix)
   end subroutine add_wall

   !> A column of four factors times a row of pairs, added to a matrix.
   pure subroutine add_rows(factor, rows, matrix)
      real(wp), intent(in) :: factor(4), rows(2, 8)
      real(wp), intent(inout) :: matrix(2, 5, 8)
      integer :: i
      do i = 1, 8
         matrix(:, 1, i) = matrix(:, 1, i) + factor(1)*rows(:, i)
         matrix(:, 2, i) = matrix(:, 2, i) + factor(2)*rows(:, i)
         matrix(:, 3, i) = matrix(:, 3, i) + factor(3)*rows(:, i)
         matrix(:, 4, i) = matrix(:, 4, i) + factor(4)*rows(:, i)
      end do
   end subroutine add_rows

   !> Adds what friction around the hole brings: a part of a stiffness, turned by a right angle.
   pure subroutine add_turned(part, stiffness, rows)
      real(wp), intent(in) :: part, stiffness(2, 2)
      real(wp), intent(inout) :: rows(2, 2)
      rows(:, 1) = rows(:, 1) - part*stiffness(:, 2)
      rows(:, 2) = rows(:, 2) + part*stiffness(:, 1)
   end subroutine add_turned

   !> How the wall presses where the string touches, by the law of dg_gap_state. A law for a metre of wall gives it per metre.
   pure subroutine push_at(law, offset, square, push)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: offset(2)   !< not zero [m]
      real(wp), intent(in) :: square      !< of its length [m2]
      type(wall_push_type), intent(inout) :: push
      real(wp) :: distance, beyond
      distance = sqrt(square)
      push%stiffness = law%contact
      push%force = law%contact*(distance - law%clearance)
      beyond = distance - (1.0_wp + law%eps_nmax)*law%clearance
      if (beyond > 0.0_wp) then
         push%stiffness = law%maximum
         push%force = push%force + (law%maximum - law%contact)*beyond
      end if
      push%turning = push%force/distance
      push%n = offset/distance
   end subroutine push_at

   !> Adds what a wall that presses at a node does there: R (n + m t x n) on the offset, r a R n on the slope.
   pure subroutine add_action(push, lever, around, action)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(inout) :: action(4)
      action(1) = action(1) + push%force*(push%n(1) - around*push%n(2))
      action(2) = action(2) + push%force*(push%n(2) + around*push%n(1))
      action(3:4) = action(3:4) + lever*push%force*push%n
   end subroutine add_action

   !> Adds the derivatives of that by the node's offset, row by row.
   pure subroutine add_stiffness(push, lever, around, matrix)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: lever       !< r a [m]
      real(wp), intent(in) :: around      !< m [-]
      real(wp), intent(inout) :: matrix(:, :)    !< at least (2,4)
      real(wp) :: stiffness(2, 2)
      stiffness = stiffness_of(push, 1.0_wp)
      matrix(1:2, 3:4) = matrix(1:2, 3:4) + lever*stiffness
      matrix(1:2, 1) = matrix(1:2, 1) + stiffness(:, 1) - around*stiffness(:, 2)
      matrix(1:2, 2) = matrix(1:2, 2) + stiffness(:, 2) + around*stiffness(:, 1)
   end subroutine add_stiffness

   !> Derivatives of R n by the offset, times a factor.
   pure function stiffness_of(push, factor) result(stiffness)
      type(wall_push_type), intent(in) :: push
      real(wp), intent(in) :: factor
      real(wp) :: stiffness(2, 2)
      real(wp) :: turning, steep
      turning = factor*push%turning
      steep = factor*push%stiffness - turning
      stiffness(1, 1) = turning + steep*push%n(1)*push%n(1)
      stiffness(2, 1) = steep*push%n(1)*push%n(2)
      stiffness(1, 2) = stiffness(2, 1)
      stiffness(2, 2) = turning + steep*push%n(2)*push%n(2)
   end function stiffness_of

   !> Bending moments EI (k + y'' - b) by the shape of an element at its upper (first column) and its lower end [N.m].
   pure subroutine moments_of_shape(element, upper, lower, moments)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in) :: upper(4), lower(4)   !< offsets and slopes of its nodes [m, -]
      real(wp), intent(out) :: moments(2, 2)
      call moments_of_change(element, upper, lower, moments)
      moments(:, 1) = moments(:, 1) + element%ei*element%bent
      moments(:, 2) = moments(:, 2) + element%ei*element%bent
   end subroutine moments_of_shape

   !> EI y'', by which these moments change as offsets and slopes do.
   pure subroutine moments_of_change(element, upper, lower, moments)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in) :: upper(4), lower(4)
      real(wp), intent(out) :: moments(2, 2)
      real(wp) :: chord(2), stiffness
      stiffness = 2.0_wp*element%ei*element%per_length
      chord = (3.0_wp*element%per_length)*(lower(1:2) - upper(1:2))
      moments(:, 1) = stiffness*(chord - 2.0_wp*upper(3:4) - lower(3:4))
      moments(:, 2) = stiffness*(2.0_wp*lower(3:4) + upper(3:4) - chord)
   end subroutine moments_of_change

   !> Raises two numbers to the squares of an element's moments and of their changes, where these are larger [N2.m2].
   pure subroutine raise_moments(element, upper, lower, change_above, change_below, most, changed)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in), dimension(4) :: upper, lower, change_above, change_below
      real(wp), intent(inout) :: most, changed
      real(wp) :: moments(2, 2), change(2, 2)
      call moments_of_shape(element, upper, lower, moments)
      call moments_of_change(element, change_above, change_below, change)
      most = max(most, moments(1, 1)**2 + moments(2, 1)**2, moments(1, 2)**2 + moments(2, 2)**2)
      changed = max(changed, change(1, 1)**2 + change(2, 1)**2, change(1, 2)**2 + change(2, 2)**2)
   end subroutine raise_moments
end module dg_bending_element

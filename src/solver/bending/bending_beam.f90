!> A string in its hole as a slender beam, bent under a given axial force and torque.
!>
!> The analysis of a case has elements that are longer than the bending length sqrt(EI/T). It finds axial force, torque and the
!> sum of contact to a ten-thousandth. The bending moment in between is less exact, as an element touches at one point. This
!> beam finds that moment, on shorter elements. The unknowns of a node are the offset y = (y_1, y_2) of the string from the
!> hole axis, and its slope y' by measured depth. Offsets are along n_1 and n_2 of the frame of the hole (convention 3). The
!> string is in equilibrium when for every small displacement v across the hole
!>
!>   integral of  EI (k + y'' - b).v'' - M_t t x (k + y'').v' + T y'.v' - (T k + w + q).v + R n.v + m R (t x n).v + r a R n.v'  = 0.
!>
!> - EI: bending stiffness [N.m2]
!> - k: curvature of the hole axis [1/m]
!> - b: curvature of the string before loading [1/m]
!> - T: axial force, tension positive [N]
!> - M_t: torque (convention 9) [N.m]
!> - w: buoyed weight across the hole [N/m]
!> - q: force of pads across the hole [N/m]
!> - R: contact force on the string per metre, where |y| > c [N/m]
!> - n = y/|y|: outwards
!> - m, a: coefficients of friction around and along the hole (convention 13) [-]
!> - r: radius of contact [m]
!>
!> For eccentric blades |y| and n are those of their centre, y + e (dg_bending_element).
!>
!> An end that is not held carries neither moment nor force across the hole. Slopes y', and |k| c, are small against one. The
!> small force around the hole from the friction of a sliding string (F_tau of dg_gap_contact) is neglected. Contact follows
!> Eqs. 4 to 6 of Liu, Ding & Zhang (2002). The rest follows their Eqs. 9 to 12, linear in y and without shear deformation.
module dg_bending_beam
   use dg_kinds, only: wp
   use dg_bending_element, only: beam_element_type, contact_places, element_action, push_at, push_element, set_element, &
      wall_push_type
   use dg_gap_state, only: gap_law_type
   implicit none
   private
   public :: bending_beam_type, bent_type, node_unknowns
   public :: set_elements, press_points, contact_sum, find_forces, length_of

   !> Unknowns of a node: y_1, y_2 [m], their slopes [-].
   integer, parameter :: node_unknowns = 4

   !> The beam: n nodes from the top down, and element e between nodes e and e + 1.
   type :: bending_beam_type
      real(wp), allocatable :: md(:)            !< depth of the nodes along the string, before loading [m]
      real(wp), allocatable :: place(:)         !< measured depth of the hole at the present place of a node [m]
      real(wp), allocatable :: axial(:)         !< T at the nodes [N]
      real(wp), allocatable :: down(:, :)       !< unit vector downwards, its components across the hole, at the nodes (2,n) [-]
      real(wp), allocatable :: viscous(:)       !< stiffness that holds a compressed string during the iteration, at the nodes [N/m]
      logical, allocatable :: held(:)           !< nodes with fixed offset and slope
      logical, allocatable :: centred(:)        !< nodes with fixed offset
      integer, allocatable :: owner(:)          !< element of the analysis that contains an element of the beam
      real(wp), allocatable :: curvature(:, :)  !< k of the hole, by element (2,e) [1/m]
      real(wp), allocatable :: bend(:, :)       !< b of the string, by element (2,e) [1/m]
      real(wp), allocatable :: push(:, :)       !< q of pads, by element (2,e) [N/m]; not allocated without pads
      real(wp), allocatable :: torque(:)        !< M_t by element [N.m]
      real(wp), allocatable :: weight(:)        !< buoyed weight per length, by element [N/m]
      type(beam_element_type), allocatable :: element(:)  !< sections, laws and friction; the rest is set by set_elements
      integer, allocatable :: point(:)             !< nodes at which tool joints touch, from the top down
      integer, allocatable :: point_owner(:)       !< element of the analysis that contains it
      type(gap_law_type), allocatable :: point_law(:)  !< of the whole contact (stiffnesses in N/m)
      !> The same law, no stiffer than Newton's steps tolerate, and how far inwards the wall is moved for that [m].
      type(gap_law_type), allocatable :: point_press(:)
      real(wp), allocatable :: point_moved(:)
      real(wp) :: pressed_softly = 0.0_wp          !< sum of contact against walls that yield too much [N]
   end type bending_beam_type

   !> The solved beam.
   type :: bent_type
      real(wp), allocatable :: y(:, :)          !< offsets and slopes at the nodes (4,n) [m, -]
      !> Forces and moments at the nodes (4,n) [N, N.m]. They follow from the equilibrium of the element below each node, with
      !> its loads and contact. At the last node they follow from the element above it. Minus the first and second are the
      !> force across the hole that the string below the node exerts on the string above it, along n_1 and n_2. Minus the third
      !> and fourth are the bending moment EI (k + y'' - b) there.
      real(wp), allocatable :: forces(:, :)
      !> Contact forces R at the `contact_xi` of the elements (contact_places,n-1) [N].
      real(wp), allocatable :: pressed(:, :)
      real(wp), allocatable :: points(:)        !< contact forces of the tool joints, in the order of beam%point [N]
   end type bent_type

contains

   !> Set up the elements, once all else of the beam is set.
   pure subroutine set_elements(beam)
      type(bending_beam_type), intent(inout) :: beam
      integer :: e
      do e = 1, size(beam%element)
         call set_element(beam%md(e + 1) - beam%md(e), beam%axial(e:e + 1), beam%torque(e), beam%curvature(:, e), &
                          beam%bend(:, e), beam%weight(e), beam%down(:, e:e + 1), beam%element(e))
         if (allocated(beam%push)) call push_element(beam%push(:, e), beam%element(e))
      end do
   end subroutine set_elements

   !> Push of the wall on centralizers at given offsets.
   pure subroutine press_points(beam, offset, push)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: offset(:, :)                 !< of their nodes (2,points) [m]
      type(wall_push_type), intent(inout) :: push(:)       !< in the order of beam%point
      integer :: p
      do p = 1, size(beam%point)
         call push_at(beam%point_press(p), beam%point_moved(p), 1.0_wp, offset(:, p), push(p))
      end do
   end subroutine press_points

   !> Forces along the beam at a given shape.
   pure subroutine find_forces(beam, y, bent)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :)        !< (4,n) [m, -]
      type(bent_type), intent(out) :: bent
      type(wall_push_type) :: push(contact_places), point(size(beam%point))
      real(wp) :: below(4)
      integer :: e, n
      n = size(y, 2)
      bent%y = y
      allocate (bent%forces(4, n), bent%pressed(contact_places, n - 1))
      bent%forces = 0.0_wp
      do e = 1, n - 1
         call element_action(beam%element(e), y(:, e), y(:, e + 1), push, bent%forces(:, e), below)
         bent%pressed(:, e) = push%force
      end do
      bent%forces(:, n) = -below
      call press_points(beam, y(1:2, beam%point), point)
      bent%points = point%force
   end subroutine find_forces

   !> Sum of all contact forces [N].
   pure function contact_sum(bent) result(force)
      type(bent_type), intent(in) :: bent
      real(wp) :: force
      force = sum(bent%pressed) + sum(bent%points)
   end function contact_sum

   !> Length of a vector across the hole, in its own unit.
   pure function length_of(vector) result(length)
      real(wp), intent(in) :: vector(2)
      real(wp) :: length
      length = sqrt(vector(1)**2 + vector(2)**2)
   end function length_of
end module dg_bending_beam

!> The 12-dof beam element: internal forces and the stiffness K0 + KN + Ksigma of Eqs. 9, 10 and 12.
!>
!> Force and tangent are derivatives of one energy, in measures that no rigid motion changes. Forces and moments of every
!> element therefore balance to round-off at any displacement:
!> - e = (x_j - x_i)/l: chord direction, with l the length of the chord
!> - c_i = d_i.e, c_j = d_j.e: cosines of the angles alpha_i, alpha_j between nodal tangents and chord
!> - p = d_i.d_j
!> - theta_i: rotation vector that turns e into d_i, of length alpha_i
!> - A = alpha_i**2 + alpha_j**2, B = theta_i.theta_j
!> - b = (2 A - B)/30: arc length of the cubic over its chord, less one. The axial strain is the mean over the element. Point
!>   by point it would resist pure bending (locking).
!> - epsilon = l (1 + b)/L_m - 1: axial strain
!> - U = EA L_m/2 epsilon**2 + (2 EI/L)(A + B): energy [J]
!>
!>   e = (x_j - x_i)/l              chord direction, l its length
!>   c_i = d_i.e, c_j = d_j.e       cosines of the angles alpha_i, alpha_j between nodal tangents and chord
!>   p = d_i.d_j
!>   theta_i                        rotation vector that turns e into d_i; its length is alpha_i
!>   A = alpha_i**2 + alpha_j**2,  B = theta_i.theta_j
!>   b = (2 A - B)/30               arc length of the cubic over its chord, less one. The axial strain is the mean over the
!>                                  element: taken point by point it would resist pure bending (locking)
!>   epsilon = l (1 + b)/L_m - 1    axial strain
!>   U = EA L_m/2 epsilon**2 + (2 EI/L)(A + B)
!>
!> L is the element's length along the hole. L_m, its unstressed length, is l (1 + b) with nodes and tangents on the hole axis.
!> A string on the axis of an arc thus carries no axial force, and by A and B exactly M = EI/R. In the tangent, U'' at zero
!> displacement is K0. Terms proportional to the axial force N are Ksigma, and the rest is KN. There is no shear deformation.
!>
!> Twist phi is a scalar along the string (turned about its own tangent, against a frame that does not spin). The torque M_t
!> enters as an end-moment vector M_t (d_i + d_j)/(1 + p). It is the one vector that balances at both ends and does the work
!> M_t (phi_j - phi_i).
!>
!> Vectors of 12 are ordered (x_i, d_i, x_j, d_j) in space axes. dg_assembly turns them into the element's 12 dofs.
module dg_beam_element
   use dg_kinds, only: wp
   use dg_beam_angle, only: angle_ratio_alone, angle_ratio_once
   use dg_beam_energy, only: axial_force, bowing_of, energy_hessian, energy_slopes, gradients, measure, measure_type, thirtieth
   use dg_beam_section, only: beam_section_type
   use dg_vector, only: cross, outer, skew
   implicit none
   private
   public :: beam_force, beam_tangent, beam_tangent_parts, beam_stress_tangent, membrane_length, membrane_step
   public :: torque_force, torque_tangent

contains

   !> l (1 + b) of a configuration [m]; with nodes and tangents on the hole axis it is the unstressed length L_m.
   pure function membrane_length(chord, d_i, d_j) result(length)
      real(wp), intent(in) :: chord(3)  !< x_j - x_i [m]
      real(wp), intent(in) :: d_i(3), d_j(3)   !< unit tangents of the string at the nodes [-]
      real(wp) :: length
      real(wp) :: l, e(3), a(3, 2), c(2), s, g(2)
      call measure_chord(chord, d_i, d_j, l, e, a, c, s)
      g(1) = angle_ratio_alone(c(1))
      g(2) = angle_ratio_alone(c(2))
      length = l*(1.0_wp + bowing_of(c, g, s))
   end function membrane_length

   !> Measures of a configuration: chord length and direction, tangents less their part along it, cosines, and s = p - c_i c_j.
   pure subroutine measure_chord(chord, d_i, d_j, l, e, a, c, s)
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)
      real(wp), intent(out) :: l, e(3), a(3, 2), c(2), s
      l = sqrt(chord(1)*chord(1) + chord(2)*chord(2) + chord(3)*chord(3))
      e = chord*(1.0_wp/l)
      c(1) = d_i(1)*e(1) + d_i(2)*e(2) + d_i(3)*e(3)
      c(2) = d_j(1)*e(1) + d_j(2)*e(2) + d_j(3)*e(3)
      a(:, 1) = d_i - c(1)*e
      a(:, 2) = d_j - c(2)*e
      s = a(1, 1)*a(1, 2) + a(2, 1)*a(2, 2) + a(3, 1)*a(3, 2)
   end subroutine measure_chord

   !> Length that determines the axial force (membrane_length), and its change to first order by a move [m]. The terms are
   !> written out, as each step of the iteration needs them for every element.
   pure subroutine membrane_step(chord, d_i, d_j, move, turn_i, turn_j, length, longer)
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)   !< as in beam_force [m, -]
      real(wp), intent(in) :: move(3)                !< of x_j against x_i [m]
      real(wp), intent(in) :: turn_i(3), turn_j(3)   !< changes of the tangents [-]
      real(wp), intent(out) :: length, longer        !< [m]
      real(wp) :: l, reciprocal, e(3), a(3, 2), c(2), g(2), s, dg(2), product, by_i, by_j, by_p
      call measure_chord(chord, d_i, d_j, l, e, a, c, s)
      reciprocal = 1.0_wp/l
      call angle_ratio_once(c(1), g(1), dg(1))
      call angle_ratio_once(c(2), g(2), dg(2))
      product = g(1)*g(2)
      ! changes of the cosines and of d_i.d_j
      by_i = turn_i(1)*e(1) + turn_i(2)*e(2) + turn_i(3)*e(3) + (a(1, 1)*move(1) + a(2, 1)*move(2) + a(3, 1)*move(3))*reciprocal
      by_j = turn_j(1)*e(1) + turn_j(2)*e(2) + turn_j(3)*e(3) + (a(1, 2)*move(1) + a(2, 2)*move(2) + a(3, 2)*move(3))*reciprocal
      by_p = turn_i(1)*d_j(1) + turn_i(2)*d_j(2) + turn_i(3)*d_j(3) + d_i(1)*turn_j(1) + d_i(2)*turn_j(2) + d_i(3)*turn_j(3)
      length = 1.0_wp + bowing_of(c, g, s)
      longer = length*(e(1)*move(1) + e(2)*move(2) + e(3)*move(3)) &
               - l*thirtieth*((4.0_wp*g(1) + dg(1)*g(2)*s - product*c(2))*by_i &
                              + (4.0_wp*g(2) + g(1)*dg(2)*s - product*c(1))*by_j + product*by_p)
      length = l*length
   end subroutine membrane_step

   !> Internal force dU/dy(12) [N; N.m per unit director] of the element, Eq. 9 left-hand side, and its axial force.
   pure subroutine beam_force(section, chord, d_i, d_j, force, axial)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: chord(3)       !< x_j - x_i [m]
      real(wp), intent(in) :: d_i(3), d_j(3) !< unit tangents of the string at the nodes [-]
      real(wp), intent(out) :: force(12)     !< on (x_i, d_i, x_j, d_j) [N; N.m]
      real(wp), intent(out) :: axial         !< N, tension > 0 [N]
      type(measure_type) :: m
      call measure(chord, d_i, d_j, m)
      axial = axial_force(section, m)
      force = gradients(m, d_i, d_j, energy_slopes(m, section, axial))
   end subroutine beam_force

   !> Internal force and its consistent tangent d2U/dy2(12,12), symmetric: K0 + KN + Ksigma of Eq. 10.
   pure subroutine beam_tangent(section, chord, d_i, d_j, force, axial, stiffness)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)   !< as in beam_force [m, -]
      real(wp), intent(out) :: force(12)                 !< on (x_i, d_i, x_j, d_j) [N; N.m]
      real(wp), intent(out) :: axial                     !< tension > 0 [N]
      real(wp), intent(out) :: stiffness(12, 12)         !< [N/m; N; N.m]
      type(measure_type) :: m
      call measure(chord, d_i, d_j, m)
      axial = axial_force(section, m)
      call tangent_of(m, section, axial, d_i, d_j, force, stiffness)
   end subroutine beam_tangent

   !> The tangent in the paper's three parts, for study and test; the solution uses their sum (beam_tangent). k0 is at the
   !> reference configuration, ksigma are all terms with the current axial force, and kn is the rest.
   pure subroutine beam_tangent_parts(section, chord, d_i, d_j, reference_chord, reference_i, reference_j, k0, kn, ksigma)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)                             !< as in beam_force [m, -]
      real(wp), intent(in) :: reference_chord(3), reference_i(3), reference_j(3)   !< the same in the reference configuration [m, -]
      real(wp), intent(out), dimension(12, 12) :: k0, kn, ksigma                   !< [N/m; N; N.m]
      real(wp) :: force(12), axial
      call beam_material_tangent(section, reference_chord, reference_i, reference_j, k0)
      call beam_material_tangent(section, chord, d_i, d_j, kn)
      kn = kn - k0
      call beam_force(section, chord, d_i, d_j, force, axial)
      call beam_stress_tangent(chord, d_i, d_j, axial, force, ksigma)
   end subroutine beam_tangent_parts

   !> Internal force by an axial force alone, and Ksigma of Eq. 10. Both are proportional to the axial force.
   pure subroutine beam_stress_tangent(chord, d_i, d_j, axial, force, ksigma)
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)   !< as in beam_force [m, -]
      real(wp), intent(in) :: axial                      !< tension > 0 [N]
      real(wp), intent(out) :: force(12), ksigma(12, 12) !< [N; N.m], [N/m; N; N.m]
      type(measure_type) :: m
      call measure(chord, d_i, d_j, m)
      call tangent_of(m, beam_section_type(length=1.0_wp, membrane_length=1.0_wp), axial, d_i, d_j, force, ksigma)
   end subroutine beam_stress_tangent

   !> Tangent without the terms of the axial force.
   pure subroutine beam_material_tangent(section, chord, d_i, d_j, stiffness)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)
      real(wp), intent(out) :: stiffness(12, 12)
      type(measure_type) :: m
      real(wp) :: ignored(12)
      call measure(chord, d_i, d_j, m)
      call tangent_of(m, section, 0.0_wp, d_i, d_j, ignored, stiffness)
   end subroutine beam_material_tangent

   !> Force and tangent of a section under a given axial force.
   pure subroutine tangent_of(m, section, axial, d_i, d_j, force, stiffness)
      type(measure_type), intent(in) :: m
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: axial, d_i(3), d_j(3)
      real(wp), intent(out) :: force(12), stiffness(12, 12)
      real(wp) :: first(4)
      first = energy_slopes(m, section, axial)
      force = gradients(m, d_i, d_j, first)
      call space_hessian(m, d_i, d_j, energy_hessian(m, section, axial), first, stiffness)
   end subroutine tangent_of

   !> Second derivatives in space from those of scalar measures: sum C_ab grad z_a grad z_b + sum first_a grad grad z_a.
   pure subroutine space_hessian(m, d_i, d_j, c, first, k)
      type(measure_type), intent(in) :: m
      real(wp), intent(in) :: d_i(3), d_j(3)
      real(wp), intent(in) :: c(4, 4), first(4)
      real(wp), intent(out) :: k(12, 12)
      real(wp) :: e(3), v2(3), v3(3), reciprocal, along, across, q1(3), q2(3), q3(3), r(3), t(3)
      real(wp) :: chord(3, 3), chord_i(3, 3), chord_j(3, 3)
      integer :: i, j
      reciprocal = 1.0_wp/m%length
      e = m%e
      v2 = m%a(:, 1)*reciprocal
      v3 = m%a(:, 2)*reciprocal
      ! chord-chord: columns q multiply e, v2, v3
      q1 = c(1, 1)*e + c(1, 2)*v2 + c(1, 3)*v3
      q2 = c(2, 1)*e + c(2, 2)*v2 + c(2, 3)*v3 - first(2)*reciprocal*e
      q3 = c(3, 1)*e + c(3, 2)*v2 + c(3, 3)*v3 - first(3)*reciprocal*e
      q1 = q1 - (first(2)*v2 + first(3)*v3)*reciprocal
      across = first(1)*reciprocal - (first(2)*m%c(1) + first(3)*m%c(2))*reciprocal**2
      along = -across
      do j = 1, 3
         do i = 1, 3
            chord(i, j) = q1(i)*e(j) + q2(i)*v2(j) + q3(i)*v3(j) + along*e(i)*e(j)
         end do
         chord(j, j) = chord(j, j) + across
      end do
      ! chord-director
      q1 = c(1, 2)*e + c(2, 2)*v2 + c(3, 2)*v3 - first(2)*reciprocal*e
      r = c(1, 4)*e + c(2, 4)*v2 + c(3, 4)*v3
      q2 = c(1, 3)*e + c(2, 3)*v2 + c(3, 3)*v3 - first(3)*reciprocal*e
      do j = 1, 3
         do i = 1, 3
            chord_i(i, j) = q1(i)*e(j) + r(i)*d_j(j)
            chord_j(i, j) = q2(i)*e(j) + r(i)*d_i(j)
         end do
         chord_i(j, j) = chord_i(j, j) + first(2)*reciprocal
         chord_j(j, j) = chord_j(j, j) + first(3)*reciprocal
      end do
      k(7:9, 7:9) = chord
      k(1:3, 1:3) = chord
      k(1:3, 7:9) = -chord
      k(7:9, 1:3) = -chord
      k(7:9, 4:6) = chord_i
      k(1:3, 4:6) = -chord_i
      k(7:9, 10:12) = chord_j
      k(1:3, 10:12) = -chord_j
      ! director-director
      q1 = c(2, 2)*e + c(2, 4)*d_j
      q2 = c(4, 2)*e + c(4, 4)*d_j
      r = c(3, 3)*e + c(3, 4)*d_i
      t = c(4, 3)*e + c(4, 4)*d_i
      do j = 1, 3
         do i = 1, 3
            k(3 + i, 3 + j) = q1(i)*e(j) + q2(i)*d_j(j)
            k(9 + i, 9 + j) = r(i)*e(j) + t(i)*d_i(j)
            k(3 + i, 9 + j) = (c(2, 3)*e(i) + c(4, 3)*d_j(i))*e(j) + (c(2, 4)*e(i) + c(4, 4)*d_j(i))*d_i(j)
         end do
         k(3 + j, 9 + j) = k(3 + j, 9 + j) + first(4)
      end do
      ! the rest by symmetry
      do j = 1, 3
         do i = 1, 3
            k(9 + i, 3 + j) = k(3 + j, 9 + i)
            k(3 + i, 6 + j) = k(6 + j, 3 + i)
            k(3 + i, j) = k(j, 3 + i)
            k(9 + i, 6 + j) = k(6 + j, 9 + i)
            k(9 + i, j) = k(j, 9 + i)
         end do
      end do
   end subroutine space_hessian

   !> Force on both directors of the torque's end-moment vector: T (d_i x d_j)/(1 + p), the same at both [N.m].
   !> `torque` is GJ/L (phi_j - phi_i): it acts as -T on phi_i and +T on phi_j.
   pure function torque_force(torque, d_i, d_j) result(force)
      real(wp), intent(in) :: torque           !< T [N.m]
      real(wp), intent(in) :: d_i(3), d_j(3)   !< unit tangents of the string at the nodes [-]
      real(wp) :: force(3)
      force = cross(d_i, d_j)*(torque/(1.0_wp + dot_product(d_i, d_j)))
   end function torque_force

   !> Derivatives of torque_force by d_i, d_j (3,3) at fixed torque, and by torque (3).
   pure subroutine torque_tangent(torque, d_i, d_j, by_i, by_j, by_torque)
      real(wp), intent(in) :: torque                                  !< T [N.m]
      real(wp), intent(in) :: d_i(3), d_j(3)                          !< unit tangents of the string at the nodes [-]
      real(wp), intent(out) :: by_i(3, 3), by_j(3, 3), by_torque(3)   !< [N.m, N.m, -]
      real(wp) :: factor
      factor = 1.0_wp/(1.0_wp + dot_product(d_i, d_j))
      by_torque = cross(d_i, d_j)*factor
      by_i = -torque*factor*(skew(d_j) + outer(by_torque, d_j))
      by_j = torque*factor*(skew(d_i) - outer(by_torque, d_i))
   end subroutine torque_tangent
end module dg_beam_element

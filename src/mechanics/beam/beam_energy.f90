!> Energy of the beam element (dg_beam_element): its measures, its derivatives by them, and the forces on nodes and directors.
module dg_beam_energy
   use dg_kinds, only: wp
   use dg_beam_angle, only: angle_ratios
   use dg_beam_section, only: beam_section_type, end_stiffness
   implicit none
   private
   public :: measure_type, measure, bowing_of, axial_force, energy_slopes, gradients, energy_hessian, thirtieth

   real(wp), parameter :: thirtieth = 1.0_wp/30.0_wp

   !> Measures of a configuration and the derivatives of A, B and U by them. In arrays of two the upper node comes first.
   type :: measure_type
      real(wp) :: e(3)                        ! chord direction
      real(wp) :: a(3, 2)                     ! tangents less their part along it
      real(wp) :: length                      ! l
      real(wp), dimension(2) :: c, g, dg, ddg ! cosines, and g of them
      real(wp) :: s                           ! p - c_i c_j, p = d_i.d_j
      real(wp) :: bowing                      ! b
      real(wp) :: by_c(2)                     ! first derivatives of B by the cosines
   end type measure_type

contains

   !> Compute the measures of an element whose nodes have directors d_i and d_j.
   pure subroutine measure(chord, d_i, d_j, m)
      real(wp), intent(in) :: chord(3), d_i(3), d_j(3)   !< x_j - x_i [m], unit tangents at the nodes [-]
      type(measure_type), intent(out) :: m
      real(wp) :: product
      m%length = sqrt(dot_product(chord, chord))
      m%e = chord/m%length
      m%c = [dot_product(d_i, m%e), dot_product(d_j, m%e)]
      m%a(:, 1) = d_i - m%c(1)*m%e
      m%a(:, 2) = d_j - m%c(2)*m%e
      call angle_ratios(2, m%c, m%g, m%dg, m%ddg)
      m%s = dot_product(m%a(:, 1), m%a(:, 2))     ! p - c_i c_j without its cancellation
      m%bowing = bowing_of(m%c, m%g, m%s)
      product = m%g(1)*m%g(2)
      m%by_c(1) = m%dg(1)*m%g(2)*m%s - product*m%c(2)
      m%by_c(2) = m%g(1)*m%dg(2)*m%s - product*m%c(1)
   end subroutine measure

   !> b = (2 A - B)/30 from the cosines, g of them, and s = p - c_i c_j: (alpha_i)**2 = g_i**2 (1 - c_i**2), B = g_i g_j s.
   pure function bowing_of(c, g, s) result(bowing)
      real(wp), intent(in) :: c(2), g(2), s   !< [-]
      real(wp) :: bowing                      !< [-]
      bowing = (2.0_wp*(g(1)*g(1)*(1.0_wp - c(1))*(1.0_wp + c(1)) + g(2)*g(2)*(1.0_wp - c(2))*(1.0_wp + c(2))) &
                - g(1)*g(2)*s)*thirtieth
   end function bowing_of

   !> Axial force N, tension > 0 [N].
   pure function axial_force(section, m) result(axial)
      type(beam_section_type), intent(in) :: section
      type(measure_type), intent(in) :: m
      real(wp) :: axial
      axial = section%ea/section%membrane_length*(m%length*(1.0_wp + m%bowing) - section%membrane_length)
   end function axial_force

   !> dU/dA and dU/dB at fixed l [N.m]: dU = N d(l (1 + b)) + (2 EI/L)(dA + dB), with db = (2 dA - dB)/30.
   pure function weights_of(section, axial, m) result(weights)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: axial          !< N [N]
      type(measure_type), intent(in) :: m
      real(wp) :: weights(2)
      real(wp) :: ends(2), carried
      ends = end_stiffness(section)
      carried = thirtieth*axial*m%length
      weights = [0.5_wp*ends(1) + 2.0_wp*carried, ends(2) - carried]
   end function weights_of

   !> First derivatives of U by (l, c_i, c_j, p) [N, N.m]. The derivative of A by c_i is -2 g_i.
   pure function energy_slopes(m, section, axial) result(first)
      type(measure_type), intent(in) :: m
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: axial          !< N [N]
      real(wp) :: first(4)
      real(wp) :: weights(2)
      weights = weights_of(section, axial, m)
      first(1) = axial*(1.0_wp + m%bowing)
      first(2:3) = -2.0_wp*weights(1)*m%g + weights(2)*m%by_c
      first(4) = weights(2)*m%g(1)*m%g(2)
   end function energy_slopes

   !> dU/dy(12) from the first derivatives by the scalar measures.
   pure function gradients(m, d_i, d_j, first) result(force)
      type(measure_type), intent(in) :: m
      real(wp), intent(in) :: d_i(3), d_j(3), first(4)   !< unit tangents at the nodes [-]; from energy_slopes [N, N.m]
      real(wp) :: force(12)                              !< on (x_i, d_i, x_j, d_j) [N; N.m]
      force(7:9) = first(1)*m%e + (first(2)*m%a(:, 1) + first(3)*m%a(:, 2))/m%length
      force(1:3) = -force(7:9)
      force(4:6) = first(2)*m%e + first(4)*d_j
      force(10:12) = first(3)*m%e + first(4)*d_i
   end function gradients

   !> Second derivatives c(4,4) of U by (l, c_i, c_j, p). With axial = 0 they are the terms without axial force. For a section
   !> without stiffness they are the terms of the axial force alone.
   pure function energy_hessian(m, section, axial) result(c)
      type(measure_type), intent(in) :: m
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: axial          !< N, tension > 0 [N]
      real(wp) :: c(4, 4)                    !< [N/m, N, N.m]
      real(wp) :: by_bowing(4), by_strain(4), weights(2), g_ij, mixed(2)
      integer :: i, j
      weights = weights_of(section, axial, m)
      g_ij = m%g(1)*m%g(2)
      mixed = [m%dg(1)*m%g(2), m%g(1)*m%dg(2)]
      ! derivatives of the bowing, and of the strain times L_m
      by_bowing(1) = 0.0_wp
      by_bowing(2:3) = -(4.0_wp*m%g + m%by_c)*thirtieth
      by_bowing(4) = -g_ij*thirtieth
      by_strain = m%length*by_bowing
      by_strain(1) = 1.0_wp + m%bowing
      do j = 1, 4
         c(:, j) = section%ea/section%membrane_length*by_strain*by_strain(j)
      end do
      c(2:4, 1) = c(2:4, 1) + axial*by_bowing(2:4)
      do i = 1, 2
         c(1 + i, 1 + i) = c(1 + i, 1 + i) - 2.0_wp*weights(1)*m%dg(i) - 2.0_wp*weights(2)*mixed(i)*m%c(3 - i) &
                           + weights(2)*m%ddg(i)*m%g(3 - i)*m%s
         c(4, 1 + i) = c(4, 1 + i) + weights(2)*mixed(i)
      end do
      c(3, 2) = c(3, 2) + weights(2)*(m%dg(1)*m%dg(2)*m%s - mixed(1)*m%c(1) - mixed(2)*m%c(2) - g_ij)
      c(1, 2:4) = c(2:4, 1)
      c(2, 3:4) = c(3:4, 2)
      c(3, 4) = c(4, 3)
   end function energy_hessian
end module dg_beam_energy

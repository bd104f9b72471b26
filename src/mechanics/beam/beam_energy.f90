!> The beam element's energy (dg_beam_element) of several elements side by side: its measures, its derivatives by them, and the
!> forces on nodes and directors.
module dg_beam_energy
   use dg_kinds, only: wp
   use dg_beam_angle, only: angle_ratios
   use dg_lanes, only: lanes
   implicit none
   private
   public :: measure_type, sections_type, measure, measure_forces, energy_slopes, gradients, energy_hessians

   real(wp), parameter :: thirtieth = 1.0_wp/30.0_wp

   !> What elements side by side are made of, as the energy asks for it.
   type :: sections_type
      real(wp), dimension(lanes) :: membrane_length   !< L_m [m]
      real(wp), dimension(lanes) :: stretching        !< EA/L_m [N/m]
      real(wp), dimension(lanes) :: bending           !< 2 EI/L [N.m]
   end type sections_type

   !> The measures of configurations side by side and the derivatives of A, B and U by them. In (lanes, 2) the upper node comes
   !> first.
   type :: measure_type
      real(wp) :: e(lanes, 3)                  ! chord direction
      real(wp) :: a(lanes, 3, 2)               ! tangents less their part along it
      real(wp) :: length(lanes)                ! l
      real(wp), dimension(lanes, 2) :: c, g, dg, ddg   ! cosines, and g of them
      real(wp) :: s(lanes)                     ! p - c_i c_j, p = d_i.d_j
      real(wp) :: bowing(lanes)                ! b
      real(wp) :: by_c(lanes, 2)               ! first derivatives of B by the cosines
   end type measure_type

contains

   !> Of elements whose upper nodes have directors d(1:lanes,:), and whose lower ones d(2:,:).
   pure subroutine measure(chord, d, m)
      real(wp), intent(in) :: chord(lanes, 3), d(lanes + 1, 3)
      type(measure_type), intent(out) :: m
      real(wp) :: reciprocal, e1, e2, e3, x, y, squares
      integer :: l
      do l = 1, lanes
         m%length(l) = sqrt(chord(l, 1)*chord(l, 1) + chord(l, 2)*chord(l, 2) + chord(l, 3)*chord(l, 3))
         reciprocal = 1.0_wp/m%length(l)
         e1 = chord(l, 1)*reciprocal
         e2 = chord(l, 2)*reciprocal
         e3 = chord(l, 3)*reciprocal
         m%e(l, 1) = e1
         m%e(l, 2) = e2
         m%e(l, 3) = e3
         x = d(l, 1)*e1 + d(l, 2)*e2 + d(l, 3)*e3
         y = d(l + 1, 1)*e1 + d(l + 1, 2)*e2 + d(l + 1, 3)*e3
         m%c(l, 1) = x
         m%c(l, 2) = y
         m%a(l, 1, 1) = d(l, 1) - x*e1
         m%a(l, 2, 1) = d(l, 2) - x*e2
         m%a(l, 3, 1) = d(l, 3) - x*e3
         m%a(l, 1, 2) = d(l + 1, 1) - y*e1
         m%a(l, 2, 2) = d(l + 1, 2) - y*e2
         m%a(l, 3, 2) = d(l + 1, 3) - y*e3
      end do
      call angle_ratios(2*lanes, m%c, m%g, m%dg, m%ddg)
      do l = 1, lanes
         ! s = p - c_i c_j without its cancellation
         m%s(l) = m%a(l, 1, 1)*m%a(l, 1, 2) + m%a(l, 2, 1)*m%a(l, 2, 2) + m%a(l, 3, 1)*m%a(l, 3, 2)
         squares = m%g(l, 1)*m%g(l, 1)*(1.0_wp - m%c(l, 1))*(1.0_wp + m%c(l, 1)) &
                   + m%g(l, 2)*m%g(l, 2)*(1.0_wp - m%c(l, 2))*(1.0_wp + m%c(l, 2))
         x = m%g(l, 1)*m%g(l, 2)
         m%bowing(l) = (2.0_wp*squares - x*m%s(l))*thirtieth
         m%by_c(l, 1) = m%dg(l, 1)*m%g(l, 2)*m%s(l) - x*m%c(l, 2)
         m%by_c(l, 2) = m%g(l, 1)*m%dg(l, 2)*m%s(l) - x*m%c(l, 1)
      end do
   end subroutine measure

   !> beam_force of elements side by side, with the measures of the configurations and the energy's first derivatives by them, of
   !> which the tangent is made.
   pure subroutine measure_forces(sections, chord, d, m, first, force, axial)
      type(sections_type), intent(in) :: sections
      real(wp), intent(in) :: chord(lanes, 3)
      real(wp), intent(in) :: d(lanes + 1, 3)          !< of the nodes, from above down
      type(measure_type), intent(out) :: m
      real(wp), intent(out) :: first(lanes, 4)         !< by (l, c_i, c_j, p) [N, N.m]
      real(wp), intent(out) :: force(lanes, 12), axial(lanes)
      integer :: l
      call measure(chord, d, m)
      do l = 1, lanes
         axial(l) = sections%stretching(l)*(m%length(l)*(1.0_wp + m%bowing(l)) - sections%membrane_length(l))
      end do
      call energy_slopes(m, axial, sections%bending, first)
      call gradients(m, d, first, force)
   end subroutine measure_forces

   !> First derivatives of U by (l, c_i, c_j, p).
   pure subroutine energy_slopes(m, axial, bending, first)
      type(measure_type), intent(in) :: m
      real(wp), intent(in) :: axial(lanes), bending(lanes)   !< N, 2 EI/L [N, N.m]
      real(wp), intent(out) :: first(lanes, 4)
      real(wp) :: carried, weight_a, weight_b
      integer :: l
      do l = 1, lanes
         ! dU = EA L_m eps deps + ..., with deps = (1 + b) dl/L_m + l db/L_m: weights of A and B are dU/dA and dU/dB
         carried = thirtieth*axial(l)*m%length(l)
         weight_a = -2.0_wp*(bending(l) + 2.0_wp*carried)
         weight_b = bending(l) - carried
         first(l, 1) = axial(l)*(1.0_wp + m%bowing(l))
         first(l, 2) = weight_a*m%g(l, 1) + weight_b*m%by_c(l, 1)
         first(l, 3) = weight_a*m%g(l, 2) + weight_b*m%by_c(l, 2)
         first(l, 4) = weight_b*m%g(l, 1)*m%g(l, 2)
      end do
   end subroutine energy_slopes

   !> dU/dy(12) from the first derivatives by the scalar measures.
   pure subroutine gradients(m, d, first, force)
      type(measure_type), intent(in) :: m
      real(wp), intent(in) :: d(lanes + 1, 3), first(lanes, 4)
      real(wp), intent(out) :: force(lanes, 12)
      real(wp) :: by_i, by_j, x
      integer :: l, k
      do l = 1, lanes
         by_i = first(l, 2)/m%length(l)
         by_j = first(l, 3)/m%length(l)
         do k = 1, 3
            x = first(l, 1)*m%e(l, k) + by_i*m%a(l, k, 1) + by_j*m%a(l, k, 2)
            force(l, 6 + k) = x
            force(l, k) = -x
            force(l, 3 + k) = first(l, 2)*m%e(l, k) + first(l, 4)*d(l + 1, k)
            force(l, 9 + k) = first(l, 3)*m%e(l, k) + first(l, 4)*d(l, k)
         end do
      end do
   end subroutine gradients

   !> Second derivatives c(lanes,4,4) of U by (l, c_i, c_j, p), on the diagonal and below. Those without the axial force come of
   !> axial = 0, those that the axial force alone makes of sections without stiffness.
   pure subroutine energy_hessians(m, sections, axial, c)
      type(measure_type), intent(in) :: m
      type(sections_type), intent(in) :: sections
      real(wp), intent(in) :: axial(lanes)   !< N, tension > 0 [N]
      real(wp), intent(inout) :: c(lanes, 4, 4)
      real(wp) :: b_i, b_j, b_p, s_l, s_i, s_j, s_p, carried, weight_a, weight_b, stiffness, g_ij, mixed
      integer :: l
      do l = 1, lanes
         stiffness = sections%stretching(l)
         ! derivatives of the bowing, and of the strain times L_m
         g_ij = m%g(l, 1)*m%g(l, 2)
         b_i = -(4.0_wp*m%g(l, 1) + m%by_c(l, 1))*thirtieth
         b_j = -(4.0_wp*m%g(l, 2) + m%by_c(l, 2))*thirtieth
         b_p = -g_ij*thirtieth
         s_l = 1.0_wp + m%bowing(l)
         s_i = m%length(l)*b_i
         s_j = m%length(l)*b_j
         s_p = m%length(l)*b_p
         carried = thirtieth*axial(l)*m%length(l)
         weight_a = 2.0_wp*(sections%bending(l) + 2.0_wp*carried)
         weight_b = sections%bending(l) - carried
         c(l, 1, 1) = stiffness*s_l*s_l
         c(l, 2, 1) = stiffness*s_l*s_i + axial(l)*b_i
         c(l, 3, 1) = stiffness*s_l*s_j + axial(l)*b_j
         c(l, 4, 1) = stiffness*s_l*s_p + axial(l)*b_p
         mixed = m%dg(l, 1)*m%g(l, 2)
         c(l, 4, 2) = stiffness*s_i*s_p + weight_b*mixed
         c(l, 2, 2) = stiffness*s_i*s_i - weight_a*m%dg(l, 1) &
                      + weight_b*(m%ddg(l, 1)*m%g(l, 2)*m%s(l) - 2.0_wp*mixed*m%c(l, 2))
         c(l, 3, 2) = stiffness*s_i*s_j + weight_b*(m%dg(l, 1)*m%dg(l, 2)*m%s(l) - mixed*m%c(l, 1) &
                                                    - m%g(l, 1)*m%dg(l, 2)*m%c(l, 2) - g_ij)
         mixed = m%g(l, 1)*m%dg(l, 2)
         c(l, 4, 3) = stiffness*s_j*s_p + weight_b*mixed
         c(l, 3, 3) = stiffness*s_j*s_j - weight_a*m%dg(l, 2) &
                      + weight_b*(m%g(l, 1)*m%ddg(l, 2)*m%s(l) - 2.0_wp*mixed*m%c(l, 1))
         c(l, 4, 4) = stiffness*s_p*s_p
      end do
   end subroutine energy_hessians
end module dg_beam_energy

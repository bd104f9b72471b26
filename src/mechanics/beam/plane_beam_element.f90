!> The beam element of dg_beam_element in a plane, where tangents are angles: the same energy of the same measures,
!>
!>   U = EA L_m/2 (l (1 + b)/L_m - 1)**2 + (2 EI/L)(A + B),  A = alpha_i**2 + alpha_j**2,  B = alpha_i alpha_j
!>
!> with the signed angles alpha from the chord to the string's tangents. Its second derivative has ten numbers by the chord's
!> stretch and turn and by the two angles, and goes straight to the six unknowns of the nodes: a sixth of the work in space.
!>
!> Vectors of two are components along two fixed axes of the plane, the second a quarter turn from the first; angles count from the
!> first to the second. A node's unknowns are u along the hole axis, v across it (`across`, a quarter turn from `axis`) and the
!> slope beta of the string against the hole axis, whose angle is atan(beta).
module dg_plane_beam_element
   use dg_kinds, only: wp
   use dg_beam_angle, only: signed_angle
   use dg_beam_element, only: beam_section_type
   implicit none
   private
   public :: plane_node_type, plane_beam, unknowns

   real(wp), parameter :: thirtieth = 1.0_wp/30.0_wp
   integer, parameter :: unknowns = 6   !< of an element: u, v, beta of its upper and of its lower node

   !> Where a node is and how it may move.
   type :: plane_node_type
      real(wp) :: axis(2) = 0.0_wp    !< hole axis' unit tangent t: motion by u
      real(wp) :: across(2) = 0.0_wp  !< a quarter turn from it: motion by v
      real(wp) :: shift(2) = 0.0_wp   !< displacement [m]
      real(wp) :: d(2) = 0.0_wp       !< string's unit tangent
      real(wp) :: turn = 1.0_wp       !< its angle's derivative by beta, 1/(1 + beta**2)
      real(wp) :: bend = 0.0_wp       !< and the second
   end type plane_node_type

contains

   !> Internal force dU/d(u_i, v_i, beta_i, u_j, v_j, beta_j) [N, N, N.m] and, where it is wanted, the tangent d2U.
   pure subroutine plane_beam(section, chord, i, j, wanted, force, axial, stiffness)
      type(beam_section_type), intent(in) :: section
      real(wp), intent(in) :: chord(2)               !< x_j - x_i [m]
      type(plane_node_type), intent(in) :: i, j
      logical, intent(in) :: wanted                  !< the tangent is
      real(wp), intent(out) :: force(unknowns)
      real(wp), intent(out) :: axial                 !< N, tension > 0 [N]
      real(wp), intent(inout) :: stiffness(unknowns, unknowns)
      real(wp) :: length, reciprocal, e_1, e_2, cosine_i, sine_i, cosine_j, sine_j, angle_i, angle_j
      real(wp) :: b_i, b_j, bowing, weight_a, weight_b, moment_i, moment_j, shear, stretched, bending, carried
      real(wp) :: slack, u_li, u_lj, u_ii, u_ij, u_jj, by_along, mixed, by_aside, square, along_i, aside_i, along_j, aside_j
      length = sqrt(chord(1)**2 + chord(2)**2)
      reciprocal = 1.0_wp/length
      e_1 = chord(1)*reciprocal
      e_2 = chord(2)*reciprocal
      angle_i = angle_of(e_1*i%d(1) + e_2*i%d(2), e_1*i%d(2) - e_2*i%d(1))
      angle_j = angle_of(e_1*j%d(1) + e_2*j%d(2), e_1*j%d(2) - e_2*j%d(1))
      b_i = thirtieth*(4.0_wp*angle_i - angle_j)     ! derivatives of b = (2 A - B)/30
      b_j = thirtieth*(4.0_wp*angle_j - angle_i)
      bowing = 0.5_wp*(b_i*angle_i + b_j*angle_j)    ! homogeneous of second degree
      ! weights of A and B as in energy_slopes of dg_beam_energy
      stretched = section%axial_stiffness/section%membrane_length
      bending = 2.0_wp*section%bending_stiffness/section%length
      axial = stretched*(length*(1.0_wp + bowing) - section%membrane_length)
      carried = thirtieth*axial*length
      weight_a = 2.0_wp*carried + bending
      weight_b = bending - carried
      moment_i = 2.0_wp*weight_a*angle_i + weight_b*angle_j
      moment_j = 2.0_wp*weight_a*angle_j + weight_b*angle_i
      ! the chord on the nodes' axes: moving them by u and v stretches and turns it
      cosine_i = e_1*i%axis(1) + e_2*i%axis(2)
      sine_i = e_1*i%across(1) + e_2*i%across(2)
      cosine_j = e_1*j%axis(1) + e_2*j%axis(2)
      sine_j = e_1*j%across(1) + e_2*j%across(2)
      slack = axial*(1.0_wp + bowing)
      shear = (moment_i + moment_j)*reciprocal
      force(1) = -slack*cosine_i - shear*sine_i
      force(2) = shear*cosine_i - slack*sine_i
      force(3) = moment_i*i%turn
      force(4) = slack*cosine_j + shear*sine_j
      force(5) = slack*sine_j - shear*cosine_j
      force(6) = moment_j*j%turn
      if (.not. wanted) return
      ! second derivatives of U by l, alpha_i, alpha_j: what stretching adds, and what the axial force carries
      square = stretched*length**2
      u_li = (stretched*(1.0_wp + bowing)*length + axial)*b_i
      u_lj = (stretched*(1.0_wp + bowing)*length + axial)*b_j
      u_ii = square*b_i*b_i + 4.0_wp*carried + 2.0_wp*bending
      u_ij = square*b_i*b_j - carried + bending
      u_jj = square*b_j*b_j + 4.0_wp*carried + 2.0_wp*bending
      ! by the chord along and aside, alpha = theta - aside/l
      by_along = stretched*(1.0_wp + bowing)**2
      mixed = (shear - (u_li + u_lj))*reciprocal
      by_aside = ((u_ii + 2.0_wp*u_ij + u_jj)*reciprocal + slack)*reciprocal
      ! and so by the unknowns: columns along and aside first, then rows
      along_i = by_along*cosine_i - mixed*sine_i
      aside_i = mixed*cosine_i - by_aside*sine_i
      stiffness(1, 1) = cosine_i*along_i - sine_i*aside_i
      along_i = by_along*sine_i + mixed*cosine_i
      aside_i = mixed*sine_i + by_aside*cosine_i
      stiffness(1, 2) = cosine_i*along_i - sine_i*aside_i
      stiffness(2, 1) = stiffness(1, 2)
      stiffness(2, 2) = sine_i*along_i + cosine_i*aside_i
      along_j = by_along*cosine_j - mixed*sine_j
      aside_j = mixed*cosine_j - by_aside*sine_j
      stiffness(4, 4) = cosine_j*along_j - sine_j*aside_j
      stiffness(1, 4) = sine_i*aside_j - cosine_i*along_j
      stiffness(4, 1) = stiffness(1, 4)
      stiffness(2, 4) = -sine_i*along_j - cosine_i*aside_j
      stiffness(4, 2) = stiffness(2, 4)
      along_j = by_along*sine_j + mixed*cosine_j
      aside_j = mixed*sine_j + by_aside*cosine_j
      stiffness(4, 5) = cosine_j*along_j - sine_j*aside_j
      stiffness(5, 4) = stiffness(4, 5)
      stiffness(5, 5) = sine_j*along_j + cosine_j*aside_j
      stiffness(1, 5) = sine_i*aside_j - cosine_i*along_j
      stiffness(5, 1) = stiffness(1, 5)
      stiffness(2, 5) = -sine_i*along_j - cosine_i*aside_j
      stiffness(5, 2) = stiffness(2, 5)
      call enter_angle(3, i%turn*u_li, i%turn*(u_ii + u_ij)*reciprocal, cosine_i, sine_i, cosine_j, sine_j, stiffness)
      call enter_angle(6, j%turn*u_lj, j%turn*(u_ij + u_jj)*reciprocal, cosine_i, sine_i, cosine_j, sine_j, stiffness)
      stiffness(3, 3) = u_ii*i%turn**2 + moment_i*i%bend
      stiffness(6, 6) = u_jj*j%turn**2 + moment_j*j%bend
      stiffness(3, 6) = u_ij*i%turn*j%turn
      stiffness(6, 3) = stiffness(3, 6)
   end subroutine plane_beam

   !> Row and column of an angle's unknown: what it does to the force along the chord and to that across it.
   pure subroutine enter_angle(k, along, aside, cosine_i, sine_i, cosine_j, sine_j, stiffness)
      integer, intent(in) :: k
      real(wp), intent(in) :: along, aside, cosine_i, sine_i, cosine_j, sine_j
      real(wp), intent(inout) :: stiffness(unknowns, unknowns)
      stiffness(1, k) = -along*cosine_i - aside*sine_i
      stiffness(2, k) = aside*cosine_i - along*sine_i
      stiffness(4, k) = along*cosine_j + aside*sine_j
      stiffness(5, k) = along*sine_j - aside*cosine_j
      stiffness(k, 1) = stiffness(1, k)
      stiffness(k, 2) = stiffness(2, k)
      stiffness(k, 4) = stiffness(4, k)
      stiffness(k, 5) = stiffness(5, k)
   end subroutine enter_angle

   !> The signed angle of a cosine and a sine [rad]; here so that it is inlined where it is so small that five terms of the series
   !> of dg_beam_angle, n!/(2n+1)!! u**n with u = 1 - cos(alpha), leave nothing.
   pure function angle_of(cosine, sine) result(angle)
      real(wp), intent(in) :: cosine, sine
      real(wp) :: angle
      real(wp), parameter :: small = 1.0e-3_wp
      real(wp) :: u
      u = 1.0_wp - cosine
      if (u < small) then
         angle = sine*(1.0_wp + u*(1.0_wp/3.0_wp + u*(2.0_wp/15.0_wp + u*(2.0_wp/35.0_wp + u*(8.0_wp/315.0_wp)))))
      else
         angle = signed_angle(cosine, sine)
      end if
   end function angle_of
end module dg_plane_beam_element

!> A beam element that is bent before anything loads it: a piece of a bent housing.
!>
!> Its stress-free shape is an arc of angle b, whose lower end points towards q, a unit vector across the element. In addition
!> to the energy of a straight element (dg_beam_element) it has
!>
!>   U = -M q.(d_j - d_i),   M = EI b/(L cos(b/2)),   q = p/|p|,   p = r x (q_0 x r)
!>
!> where r is the chord, and d_i and d_j are the tangents at its ends. q_0 is the direction of the tool face, fixed in space. q
!> is q_0 less its part along the chord, so that q turns with the element. With this M the element is free of force and moment
!> in its own shape. An external moment at right angles to q_0 is needed to keep q_0. It acts about the hole axis, where q_0 is
!> across the hole.
!>
!> Vectors of 12 are ordered (x_i, d_i, x_j, d_j) in space axes, as in dg_beam_element.
module dg_beam_bend
   use dg_kinds, only: wp
   use dg_vector, only: cross, outer
   implicit none
   private
   public :: bend_moment, add_bend, holding_moment

contains

   !> M [N.m] of an element of bending stiffness EI [N.m2] and length L [m] that is bent by `angle` [rad].
   elemental function bend_moment(bending_stiffness, length, angle) result(moment)
      real(wp), intent(in) :: bending_stiffness, length, angle   !< EI [N.m2], L [m], b [rad]
      real(wp) :: moment
      moment = bending_stiffness*angle/(length*cos(0.5_wp*angle))
   end function bend_moment

   !> Add the internal force dU/dy(12) [N; N.m per unit director] and, if `wanted`, its symmetric tangent d2U/dy2(12,12).
   pure subroutine add_bend(moment, held, chord, d_i, d_j, wanted, force, stiffness)
      real(wp), intent(in) :: moment          !< M [N.m]
      real(wp), intent(in) :: held(3)         !< q_0, of any length > 0, not along the chord [-]
      real(wp), intent(in) :: chord(3)        !< r = x_j - x_i [m]
      real(wp), intent(in) :: d_i(3), d_j(3)  !< unit tangents of the string at the nodes [-]
      logical, intent(in) :: wanted           !< true if the tangent is wanted
      real(wp), intent(inout) :: force(12)    !< [N; N.m]
      real(wp), intent(inout) :: stiffness(12, 12)   !< [N/m; N; N.m]
      real(wp) :: p(3), q(3), size_of, turned(3), across(3), along, by_chord(3), swing(3, 3), second(3, 3), image(3)
      integer :: i
      p = held*dot_product(chord, chord) - chord*dot_product(held, chord)
      size_of = sqrt(dot_product(p, p))
      q = p/size_of
      turned = d_j - d_i
      along = dot_product(turned, q)
      across = turned - along*q
      ! swing = dq/dr = (1 - q q) dp/dr/|p|
      swing = 2.0_wp*outer(held, chord) - outer(chord, held)
      do i = 1, 3
         swing(i, i) = swing(i, i) - dot_product(held, chord)
      end do
      swing = swing/size_of
      image = matmul(q, swing)                    ! q.dp/|p|
      swing = swing - outer(q, image)
      by_chord = matmul(across, swing)
      force(4:6) = force(4:6) + moment*q
      force(10:12) = force(10:12) - moment*q
      force(1:3) = force(1:3) + moment*by_chord
      force(7:9) = force(7:9) - moment*by_chord
      if (.not. wanted) return
      ! second derivative of q.turned by r: that of p, less the effect of the length of p
      second = -outer(held, across) - outer(across, held)
      do i = 1, 3
         second(i, i) = second(i, i) + 2.0_wp*dot_product(held, across)
      end do
      second = second/size_of - outer(by_chord, image) - outer(image, by_chord) - along*matmul(transpose(swing), swing)
      call add_pair(-moment*second, stiffness)
      swing = moment*swing
      stiffness(4:6, 7:9) = stiffness(4:6, 7:9) + swing
      stiffness(4:6, 1:3) = stiffness(4:6, 1:3) - swing
      stiffness(10:12, 7:9) = stiffness(10:12, 7:9) - swing
      stiffness(10:12, 1:3) = stiffness(10:12, 1:3) + swing
      swing = transpose(swing)
      stiffness(7:9, 4:6) = stiffness(7:9, 4:6) + swing
      stiffness(1:3, 4:6) = stiffness(1:3, 4:6) - swing
      stiffness(7:9, 10:12) = stiffness(7:9, 10:12) - swing
      stiffness(1:3, 10:12) = stiffness(1:3, 10:12) + swing
   end subroutine add_bend

   !> External moment [N.m] that holds the direction of the bend: across q_0, in the plane of q_0 and the chord. It is zero if
   !> the element is bent in that plane.
   pure function holding_moment(moment, held, chord, d_i, d_j) result(holding)
      real(wp), intent(in) :: moment          !< M [N.m]
      real(wp), intent(in) :: held(3), chord(3), d_i(3), d_j(3)   !< as in add_bend [-, m]
      real(wp) :: holding(3)
      real(wp) :: force(12), unused(12, 12)
      force = 0.0_wp
      unused = 0.0_wp
      call add_bend(moment, held, chord, d_i, d_j, .false., force, unused)
      holding = -(cross(chord, force(7:9)) + cross(d_i, force(4:6)) + cross(d_j, force(10:12)))
   end function holding_moment

   !> Add a block that couples the two ends of the chord.
   pure subroutine add_pair(block, stiffness)
      real(wp), intent(in) :: block(3, 3)
      real(wp), intent(inout) :: stiffness(12, 12)
      stiffness(1:3, 1:3) = stiffness(1:3, 1:3) + block
      stiffness(7:9, 7:9) = stiffness(7:9, 7:9) + block
      stiffness(1:3, 7:9) = stiffness(1:3, 7:9) - block
      stiffness(7:9, 1:3) = stiffness(7:9, 1:3) - block
   end subroutine add_pair
end module dg_beam_bend

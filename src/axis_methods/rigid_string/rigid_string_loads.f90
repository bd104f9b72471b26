!> Forces in a stiff string that follows the hole axis, integrated from the bit up.
!>
!> Ho 1988 (SPE 18047) balances forces and moments of a rod along the hole, here in vectors. Payne & Abbassian 1997 (SPE 28293)
!> show when it matters. Force F = T t + V and moment E I t x k - M t of the lower part on the upper:
!>     dF/ds + w g + q = 0,   d(E I t x k - M t)/ds + t x F = -(moment of friction)
!> They give shear, contact force on the wall per metre and axial force (s' up the hole):
!>     V = -(d(E I k)/ds) - M t x k
!>     c = T k + w (g - (g.t) t) + dV/ds,   n = |c|
!>     dT/ds' = w g.t + f n - V.k,   dM/ds' = m r n
!> Only the parts of dV/ds and d(E I k)/ds across the hole are meant. On an arc E I k only turns with the hole, so that
!> stiffness acts only at the changes of curvature (dg_curvature_change). In c the part -(dM/ds) t x k is neglected. It is m r
!> k n, some 1e-5 of n and across it. At its ends the string keeps the hole's direction and curvature, as if it continued.
!> Without changes, and so for E I = 0, this is the soft string.
module dg_rigid_string_loads
   use dg_kinds, only: wp
   use dg_curvature_change, only: bending_at, change_type, find_extents
   use dg_model, only: model_type
   use dg_packer, only: end_compression
   use dg_soft_string_loads, only: largest_angle, longest_step, runaway_force, soft_totals_type
   use dg_string_piece, only: at_offset, climbed, layout_of, layout_type, piece_above, piece_type, share_contact
   use dg_trajectory, only: point_on_arc
   use dg_vector, only: cross
   implicit none
   private
   public :: rigid_string_at

   !> Steps near a change [-]: this part of its length l, growing by this part of the distance from it. The fourth-order step
   !> leaves 1e-5 of the pair of forces, itself some per cent of a bend's contact force.
   real(wp), parameter :: length_share = 0.25_wp
   real(wp), parameter :: distance_share = 0.125_wp

   !> Forces at a depth, and the shape to which they belong.
   type :: balance_type
      real(wp) :: contact(3) = 0.0_wp   !< on the wall [N/m]
      real(wp) :: bend(3) = 0.0_wp      !< curvature of the string [1/m]
      real(wp) :: shear(3) = 0.0_wp     !< [N]
      real(wp) :: bending(3) = 0.0_wp   !< moment [N.m]
   end type balance_type

contains

   !> Axial force, torque, contact and bending moment of the stiff string of a load case at given depths. Where they jump
   !> `contact` and `across` are those just below. At a depth that is given twice, they are those just above and just below.
   pure subroutine rigid_string_at(model, case_index, stiff_at, md, axial, torque, contact, across, totals)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(change_type), intent(in) :: stiff_at(:) !< changes at which the string is stiff, from the top down
      real(wp), intent(in) :: md(:)                !< never decreasing, from the first station to the bit [m]
      real(wp), intent(out) :: axial(:)            !< effective, tension > 0 [N]
      real(wp), intent(out) :: torque(:)           !< [N.m]
      real(wp), intent(out) :: contact(:, :)       !< (3, :) force of the string on the wall, across the hole [N/m]
      real(wp), intent(out) :: across(:, :)        !< (2, :) resultant moment [N.m] and resultant shear force |V| [N]
      type(soft_totals_type), intent(out) :: totals
      type(change_type), allocatable :: changes(:)
      type(layout_type) :: layout
      type(piece_type) :: piece
      real(wp) :: position, force, moment, nearby
      integer :: i
      associate (load_case => model%cases(case_index))
         position = load_case%bit_depth
         force = -end_compression(model, load_case)
         moment = load_case%tob
      end associate
      allocate (changes, source=stiff_at)
      call find_extents(changes)
      layout = layout_of(model, case_index)
      piece = piece_above(model, layout, position, 1.0_wp)
      do i = size(md), 1, -1
         do while (position > md(i))
            call integrate_up(piece, changes, max(piece%top, md(i)), position, force, moment, totals)
            if (position > md(i)) piece = piece_above(model, layout, position, 1.0_wp)
         end do
         axial(i) = force
         torque(i) = moment
         nearby = md(i) + spacing(md(i))
         if (i < size(md)) then
            if (.not. md(i + 1) > md(i)) nearby = md(i) - spacing(md(i))
         end if
         call forces_across(piece, changes, md(i), nearby, force, moment, contact(:, i), across(:, i))
         if (position <= piece%top .and. i > 1) piece = piece_above(model, layout, position, 1.0_wp)
      end do
   end subroutine rigid_string_at

   !> Integrate up a piece of string from `position` to `target`. Weight is the difference of vertical depth. Friction and
   !> shear use the classical Runge-Kutta method, with short steps at changes of curvature.
   pure subroutine integrate_up(piece, changes, target, position, force, moment, sums)
      type(piece_type), intent(inout) :: piece
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: target           !< [m]
      real(wp), intent(inout) :: position      !< [m]
      real(wp), intent(inout) :: force         !< [N]
      real(wp), intent(inout) :: moment        !< [N.m]
      type(soft_totals_type), intent(inout) :: sums
      real(wp) :: step, side, upper, n1, n2, n3, n4, d1, d2, d3, d4, middle, ahead, normal, z1, z2, z3
      integer :: steps
      if (sums%runaway) position = target
      do while (position > target)
         step = step_from(piece, changes, target, position)
         upper = position - step
         if (upper <= target) upper = target
         step = position - upper
         side = 0.5_wp*(position + upper)
         steps = sums%steps + 1
         z1 = depth_at(piece, position)
         z2 = depth_at(piece, side)
         z3 = depth_at(piece, upper)
         middle = force + piece%weight*(z1 - z2)
         ahead = force + piece%weight*(z1 - z3)
         call rates(piece, changes, position, side, force, moment, n1, d1)
         if (piece%spans%present) then
            call share_contact(piece, n1, force)
            call rates(piece, changes, position, side, force, moment, n1, d1)
         end if
         call rates(piece, changes, side, side, middle + 0.5_wp*step*d1, moment, n2, d2)
         call rates(piece, changes, side, side, middle + 0.5_wp*step*d2, moment, n3, d3)
         call rates(piece, changes, upper, side, ahead + step*d3, moment, n4, d4)
         normal = step*(n1 + 2.0_wp*n2 + 2.0_wp*n3 + n4)/6.0_wp
         force = ahead + step*(d1 + 2.0_wp*d2 + 2.0_wp*d3 + d4)/6.0_wp
         moment = moment + piece%rotary*piece%radius*normal
         sums%normal_force = sums%normal_force + normal
         sums%weight = sums%weight + piece%weight*(z1 - z3)
         sums%steps = steps
         position = upper
         if (abs(force) > runaway_force) then
            sums%runaway = .true.
            sums%runaway_md = upper
            position = target
         end if
      end do
   end subroutine integrate_up

   !> Length of the next step up from `position` [m].
   pure function step_from(piece, changes, target, position) result(step)
      type(piece_type), intent(in) :: piece
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: target, position   !< [m]
      real(wp) :: step
      real(wp) :: far
      integer :: j, above
      step = position - target
      if (piece%arc%curvature > 0.0_wp) step = min(step, longest_step, largest_angle/piece%arc%curvature)
      if (piece%spans%present) step = min(step, longest_step)
      ! from the nearest changes on, until distance alone leaves the step unchanged
      above = changes_above(changes, position)
      do j = above, 1, -1
         far = distance_share*(position - changes(j)%md)
         if (far >= step) exit
         step = min(step, length_share*changes(j)%length + far)
      end do
      do j = above + 1, size(changes)
         far = distance_share*(changes(j)%md - position)
         if (far >= step) exit
         step = min(step, length_share*changes(j)%length + far)
      end do
   end function step_from

   !> Number of changes, ordered by depth, at a depth and above it.
   pure function changes_above(changes, md) result(number)
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: md   !< [m]
      integer :: number
      integer :: below, middle
      number = 0
      below = size(changes) + 1
      do while (below - number > 1)
         middle = (number + below)/2
         if (changes(middle)%md <= md) then
            number = middle
         else
            below = middle
         end if
      end do
   end function changes_above

   !> Contact force per metre, and its and the shear's part of the change of axial force per metre up the hole.
   pure subroutine rates(piece, changes, md, side, force, moment, normal, change)
      type(piece_type), intent(in) :: piece
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: md        !< [m]
      real(wp), intent(in) :: side      !< a depth on the wanted side [m]
      real(wp), intent(in) :: force     !< [N]
      real(wp), intent(in) :: moment    !< torque [N.m]
      real(wp), intent(out) :: normal   !< [N/m]
      real(wp), intent(out) :: change   !< [N/m]
      type(balance_type) :: here
      here = balance(piece, changes, md, side, force, moment)
      normal = piece%climb*norm2(here%contact)
      change = piece%axial*normal + piece%drag - dot_product(here%shear, here%bend)
   end subroutine rates

   !> Balance of forces and moments at a depth.
   pure function balance(piece, changes, md, side, force, moment) result(here)
      type(piece_type), intent(in) :: piece
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: md, side        !< a depth, and one on the wanted side [m]
      real(wp), intent(in) :: force, moment   !< [N], torque [N.m]
      type(balance_type) :: here
      real(wp), dimension(3) :: position, across, tangent, hole, more, more_slope, shear_slope
      call at_offset(piece, md - piece%arc%md, position, across, hole)
      call point_on_arc(piece%arc, md - piece%arc%md, position, tangent, hole)
      call bending_at(changes, md, side, tangent, more, more_slope, here%bending, here%shear, shear_slope)
      here%bend = hole + more
      here%bending = here%bending + piece%stiffness*hole
      here%contact = force*here%bend + across + shear_slope - moment*cross(tangent, more_slope)
   end function balance

   !> Contact force [N/m], and resultant moment [N.m] and resultant shear force [N] on one side of a depth.
   pure subroutine forces_across(piece, changes, md, side, force, moment, contact, across)
      type(piece_type), intent(in) :: piece
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: md, side        !< a depth, and one on the wanted side [m]
      real(wp), intent(in) :: force, moment   !< [N], torque [N.m]
      real(wp), intent(out) :: contact(3), across(2)
      type(balance_type) :: here
      real(wp) :: position(3), tangent(3), curvature(3)
      here = balance(piece, changes, md, side, force, moment)
      call point_on_arc(piece%arc, md - piece%arc%md, position, tangent, curvature)
      contact = climbed(piece, tangent, here%contact)
      across = [norm2(here%bending), norm2(here%shear - moment*cross(tangent, here%bend))]
   end subroutine forces_across

   !> True vertical depth from the start of the piece's arc [m].
   pure function depth_at(piece, md) result(z)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: md
      real(wp) :: z
      real(wp) :: position(3), tangent(3), curvature(3)
      call point_on_arc(piece%arc, md - piece%arc%md, position, tangent, curvature)
      z = position(3)
   end function depth_at
end module dg_rigid_string_loads

!> Equilibrium of a bending beam by Newton's method with the full tangent. Contact is judged anew at each shape.
!>
!> The beam's potential is the sum of bending, tension and wall. The wall pushes back the more the deeper the string is in it.
!> Without friction and compression, and with a torque below 2 sqrt(EI T), this potential is convex: there is one equilibrium. The
!> work of the residual along a Newton step then rises from a negative value to zero. A step after which that work is still large
!> is shortened (see `falls`).
!> A compressed beam's matrix may be indefinite. It is then solved again with an additional stiffness at the nodes
!> (beam%viscous). That stiffness is in the matrix alone, so it leaves no trace at equilibrium.
module dg_bending_solution
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, node_unknowns, press_points
   use dg_bending_element, only: add_action, contact_places, wall_push_type
   use dg_bending_elimination, only: newton_step
   use dg_bending_fold, only: fold_beam, fold_shape, folded_beam_type, half_of, mirror, unfold_forces, unfold_shape
   use dg_bending_pair, only: pair, pair_action, pair_push_type, raise_moments
   use dg_largest, only: largest_of
   implicit none
   private
   public :: solve_bending, least_moment

   !> Largest residual at equilibrium, over the largest nodal load [-]: moments are then right to a hundred-thousandth.
   real(wp), parameter :: tolerance = 1.0e-6_wp
   integer, parameter :: most_iterations = 60
   !> A step is taken as it is when the work of the residual along it falls to this part of what it was [-]. Else it is shortened.
   real(wp), parameter :: falls = 0.7_wp
   integer, parameter :: most_trials = 8

contains

   !> Iterates from a shape to equilibrium. Where none is found within `most_iterations`, or the matrix is singular, y is the last
   !> shape.
   pure subroutine solve_bending(beam, y, settled, found, anchor, pressed)
      type(bending_beam_type), intent(in) :: beam      !< with its elements set
      real(wp), contiguous, intent(inout) :: y(:, :)   !< offsets and slopes (4,n) [m, -]
      real(wp), intent(in) :: settled      !< the iteration ends with a full step that changes moments by less than this part of
                                           !< the largest one [-]
      logical, intent(out) :: found        !< equilibrium
      !> Shape to which springs as stiff as the resistance pull compressed parts (4,n) [m, -]; absent: none do.
      real(wp), contiguous, intent(in), optional :: anchor(:, :)
      real(wp), intent(out), optional :: pressed(:, :)   !< contact forces at the places of the elements (contact_places,n-1) [N]
      type(folded_beam_type) :: folded
      type(pair_push_type) :: push(contact_places, size(y, 2)/2)
      type(wall_push_type) :: points(size(beam%point))
      real(wp), dimension(pair, node_unknowns, size(y, 2)/2 + 1) :: shape, residual, step, trial
      real(wp) :: scale, least, work, share, lower, upper, work_lower, work_trial
      logical :: solved
      real(wp), allocatable :: springs(:, :, :)      ! the anchor, or nothing
      integer :: iteration, try
      call fold_beam(beam, folded)
      call fold_shape(y, shape)
      scale = largest_load(beam)
      least = least_moment(beam)
      found = .false.
      if (present(anchor)) then
         allocate (springs, mold=shape)
         call fold_shape(anchor, springs)
      else
         allocate (springs(pair, node_unknowns, 0))
      end if
      call find_residual(beam, folded, shape, springs, push, points, residual)
      do iteration = 0, most_iterations
         found = largest_of(size(residual), residual) <= tolerance*scale
         if (found) exit
         call find_step(beam, folded, push, points, present(anchor), residual, step, solved)
         if (.not. solved) exit
         work = product_of(size(step), residual, step)
         lower = 0.0_wp
         work_lower = work
         upper = 1.0_wp
         share = 1.0_wp
         do try = 1, most_trials
            call move(size(step), share, step, shape, trial)
            call find_residual(beam, folded, trial, springs, push, points, residual)
            work_trial = product_of(size(step), residual, step)
            if (abs(work_trial) <= falls*abs(work) .or. .not. work < 0.0_wp) exit
            if (work_trial > 0.0_wp) then
               upper = share
            else
               lower = share
               work_lower = work_trial
               if (upper >= 1.0_wp .and. share >= 1.0_wp) exit
            end if
            share = 0.5_wp*(lower + upper)
            if (work_trial > 0.0_wp) share = max(0.1_wp*(upper - lower) + lower, &
                                                 min(share, lower - work_lower*(upper - lower)/(work_trial - work_lower)))
         end do
         shape = trial
         if (share >= 1.0_wp) found = is_small(folded, shape, step, settled, least)
         if (found) exit
      end do
      call unfold_shape(shape, y)
      if (present(pressed)) call unfold_forces(push, pressed)
   end subroutine solve_bending

   !> A Newton step, held by more stiffness where the matrix is not positive definite.
   pure subroutine find_step(beam, folded, push, points, anchored, residual, step, solved)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      type(pair_push_type), contiguous, intent(in) :: push(:, :)
      type(wall_push_type), intent(in) :: points(:)
      logical, intent(in) :: anchored          !< by springs, whose stiffness is in the matrix
      real(wp), contiguous, intent(in) :: residual(:, :, :)
      real(wp), contiguous, intent(out) :: step(:, :, :)
      logical, intent(out) :: solved           !< .false.: there is no step
      integer :: viscous, more
      viscous = merge(1, 0, anchored)
      do more = 0, 1
         call newton_step(beam, folded, push, points, viscous + more, more > 0, residual, step, solved)
         if (solved) return
      end do
   end subroutine find_step

   !> Residual at a shape, and how the wall presses there.
   pure subroutine find_residual(beam, folded, shape, anchor, push, points, residual)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      real(wp), contiguous, intent(in) :: shape(:, :, :)
      real(wp), contiguous, intent(in) :: anchor(:, :, :)    !< without columns: none
      type(pair_push_type), contiguous, intent(inout) :: push(:, :)    !< at the places of the elements
      type(wall_push_type), intent(inout) :: points(:)       !< of tool joints
      !> Of the middle node in the upper half; zero there in the lower one [N, N.m].
      real(wp), contiguous, intent(out) :: residual(:, :, :)
      integer :: n, i
      residual(:, :, 1) = 0.0_wp
      do n = 1, folded%middle - 1
         call pair_action(folded%pairs(n), shape(:, :, n), shape(:, :, n + 1), push(:, n), residual(:, :, n), &
                          residual(:, :, n + 1))
      end do
      n = folded%middle
      residual(1, :, n) = residual(1, :, n) + mirror*residual(2, :, n)
      residual(2, :, n) = 0.0_wp
      if (size(points) > 0) call add_points(beam, folded, shape, points, residual)
      if (size(anchor, 3) > 0) then
         do n = 1, folded%middle
            do i = 1, node_unknowns/2       ! offsets
               residual(:, i, n) = residual(:, i, n) + folded%viscous(:, n)*(shape(:, i, n) - anchor(:, i, n))
            end do
         end do
      end if
      do n = 1, folded%middle
         if (folded%plain(n)) cycle
         residual(1, :folded%fixed(1, n), n) = 0.0_wp
         residual(2, :folded%fixed(2, n), n) = 0.0_wp
      end do
   end subroutine find_residual

   !> Adds what the wall does to tool joints.
   pure subroutine add_points(beam, folded, shape, points, residual)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(in) :: folded
      real(wp), contiguous, intent(in) :: shape(:, :, :)
      type(wall_push_type), intent(inout) :: points(:)
      real(wp), contiguous, intent(inout) :: residual(:, :, :)
      real(wp) :: offset(2, size(points)), action(node_unknowns)
      integer :: p, e, half(size(points)), n(size(points))
      call half_of(folded%middle, beam%point, half, n)
      do p = 1, size(points)
         offset(:, p) = shape(half(p), :2, n(p))
      end do
      call press_points(beam, offset, points)
      do p = 1, size(points)
         if (.not. points(p)%force > 0.0_wp) cycle
         e = min(beam%point(p), size(beam%element))
         action = 0.0_wp
         call add_action(points(p), merge(1, -1, half(p) == 1)*beam%element(e)%lever, beam%element(e)%around, action)
         residual(half(p), :, n(p)) = residual(half(p), :, n(p)) + action
      end do
   end subroutine add_points

   !> What the tolerance of the residual, or the round-off of the weight, leaves of moments [N.m]: smaller ones are none. A string
   !> that rests on a straight wall, or hangs in a vertical hole, has none, and to be small or large against round-off says nothing.
   pure function least_moment(beam) result(moment)
      type(bending_beam_type), intent(in) :: beam      !< with its elements set
      real(wp) :: moment
      moment = max(tolerance*largest_load(beam), epsilon(1.0_wp)*maxval(abs(beam%weight)*beam%element%length)) &
               *maxval(beam%element%length)
   end function least_moment

   !> Largest load across the hole on a node [N].
   pure function largest_load(beam) result(load)
      type(bending_beam_type), intent(in) :: beam
      real(wp) :: load
      real(wp) :: above(2)
      integer :: e
      load = tiny(1.0_wp)
      above = 0.0_wp
      do e = 1, size(beam%ei)
         load = max(load, maxval(abs(above + beam%element(e)%load(1:2))))
         above = beam%element(e)%load(5:6)
      end do
      load = max(load, maxval(abs(above)))
   end function largest_load

   !> The shape that a part of a step leads to.
   pure subroutine move(n, share, step, from, to)
      integer, intent(in) :: n
      real(wp), intent(in) :: share, step(n), from(n)
      real(wp), intent(out) :: to(n)
      to = from + share*step
   end subroutine move

   !> Sum of products, of an even number n: a node has four unknowns.
   pure function product_of(n, a, b) result(product)
      integer, intent(in) :: n
      real(wp), intent(in) :: a(n), b(n)
      real(wp) :: product
      real(wp) :: part(2)
      integer :: i
      part = 0.0_wp
      do i = 1, n - 1, 2
         part = part + a(i:i + 1)*b(i:i + 1)
      end do
      product = part(1) + part(2)
   end function product_of

   !> Whether a step changed moments at the ends of the elements by less than a part of the largest one there after it.
   pure function is_small(folded, y, step, part, least) result(small)
      type(folded_beam_type), intent(in) :: folded
      real(wp), contiguous, intent(in) :: y(:, :, :), step(:, :, :)   !< after the step; the step
      real(wp), intent(in) :: part     !< [-]
      real(wp), intent(in) :: least    !< of least_moment [N.m]
      logical :: small
      real(wp), dimension(pair) :: most, changed      ! squares
      integer :: n
      most = 0.0_wp
      changed = 0.0_wp
      do n = 1, size(folded%pairs)
         call raise_moments(folded%pairs(n), y(:, :, n), y(:, :, n + 1), step(:, :, n), step(:, :, n + 1), most, changed)
      end do
      small = maxval(changed) <= part**2*max(maxval(most), least**2)
   end function is_small
end module dg_bending_solution

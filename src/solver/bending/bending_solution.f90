!> Equilibrium of a bending beam by Newton's method with the full tangent. Contact is judged anew at each shape.
!>
!> The beam's potential is the sum of bending, tension and wall. The wall pushes back more the deeper the string is in it.
!> Without friction and compression, and with a torque below 2 sqrt(EI T), this potential is convex: there is one equilibrium.
!> The work of the residual along a Newton step then rises from a negative value to zero. A step after which that work is still
!> large is shortened (see `falls`). A compressed beam's matrix may be indefinite. It is then solved again with an additional
!> stiffness at the nodes (beam%viscous). That stiffness is in the matrix alone, and does not change the equilibrium.
module dg_bending_solution
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, press_points
   use dg_bending_element, only: add_action, contact_places, element_action, moments_of_shape, wall_push_type
   use dg_bending_elimination, only: newton_step
   use dg_largest, only: largest_of
   implicit none
   private
   public :: solve_bending, least_moment

   !> Largest residual at equilibrium, over the largest nodal load [-]: moments are then right to a hundred-thousandth.
   real(wp), parameter :: tolerance = 1.0e-6_wp
   integer, parameter :: most_iterations = 60
   !> A step is taken whole if the work of the residual along it falls to this part of its first value [-]. Otherwise it is
   !> shortened.
   real(wp), parameter :: falls = 0.7_wp
   integer, parameter :: most_trials = 8

contains

   !> Iterate from a shape to equilibrium. If none is found within `most_iterations`, or the matrix is singular, y is the last
   !> shape.
   pure subroutine solve_bending(beam, y, settled, found, anchor, pressed)
      type(bending_beam_type), intent(in) :: beam      !< with its elements set
      real(wp), contiguous, intent(inout) :: y(:, :)   !< offsets and slopes (4,n) [m, -]
      real(wp), intent(in) :: settled      !< the iteration ends with a full step that changes moments by less than this part of
                                           !< the largest one [-]
      logical, intent(out) :: found        !< true at equilibrium
      !> Shape to which springs of stiffness beam%viscous pull compressed parts (4,n) [m, -]; absent: no springs.
      real(wp), contiguous, intent(in), optional :: anchor(:, :)
      real(wp), intent(out), optional :: pressed(:, :)   !< contact forces at the places of the elements (contact_places,n-1) [N]
      type(wall_push_type) :: push(contact_places, size(y, 2) - 1), points(size(beam%point))
      real(wp), dimension(size(y, 1), size(y, 2)) :: residual, step, trial
      real(wp), allocatable :: springs(:, :)      ! the anchor, or without columns
      real(wp) :: scale, least, work, share, lower, upper, work_lower, work_trial
      logical :: solved
      integer :: iteration, try
      scale = largest_load(beam)
      least = least_moment(beam)
      found = .false.
      if (present(anchor)) then
         allocate (springs, source=anchor)
      else
         allocate (springs(size(y, 1), 0))
      end if
      call find_residual(beam, y, push, points, residual, springs)
      do iteration = 0, most_iterations
         found = largest_of(size(residual), residual) <= tolerance*scale
         if (found) exit
         call find_step(beam, push, points, present(anchor), residual, step, solved)
         if (.not. solved) exit
         work = sum(residual*step)
         lower = 0.0_wp
         work_lower = work
         upper = 1.0_wp
         share = 1.0_wp
         do try = 1, most_trials
            trial = y + share*step
            call find_residual(beam, trial, push, points, residual, springs)
            work_trial = sum(residual*step)
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
         y = trial
         if (share >= 1.0_wp) found = is_small(beam, y, step, settled, least)
         if (found) exit
      end do
      if (present(pressed)) pressed = push%force
   end subroutine solve_bending

   !> Compute a Newton step, with more stiffness if the matrix is not positive definite.
   pure subroutine find_step(beam, push, points, anchored, residual, step, solved)
      type(bending_beam_type), intent(in) :: beam
      type(wall_push_type), contiguous, intent(in) :: push(:, :)
      type(wall_push_type), intent(in) :: points(:)
      logical, intent(in) :: anchored          !< true if the stiffness of springs is in the matrix
      real(wp), contiguous, intent(in) :: residual(:, :)
      real(wp), contiguous, intent(out) :: step(:, :)
      logical, intent(out) :: solved           !< false: there is no step
      integer :: viscous, more
      viscous = merge(1, 0, anchored)
      do more = 0, 1
         call newton_step(beam, push, points, viscous + more, more > 0, residual, step, solved)
         if (solved) return
      end do
   end subroutine find_step

   !> Residual and push of the wall at a shape.
   pure subroutine find_residual(beam, y, push, points, residual, anchor)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :)
      type(wall_push_type), contiguous, intent(inout) :: push(:, :)    !< at the places of the elements
      type(wall_push_type), intent(inout) :: points(:)                 !< of tool joints
      real(wp), contiguous, intent(out) :: residual(:, :)              !< zero for fixed unknowns (4,n) [N, N.m]
      real(wp), contiguous, intent(in) :: anchor(:, :)                 !< shape to which springs pull, or without columns [m, -]
      integer :: e, n, p
      residual(:, 1) = 0.0_wp
      do e = 1, size(beam%element)
         call element_action(beam%element(e), y(:, e), y(:, e + 1), push(:, e), residual(:, e), residual(:, e + 1))
      end do
      call press_points(beam, y(1:2, beam%point), points)
      do p = 1, size(points)
         if (.not. points(p)%force > 0.0_wp) cycle
         n = beam%point(p)
         e = min(n, size(beam%element))
         call add_action(points(p), beam%element(e)%lever, beam%element(e)%around, residual(:, n))
      end do
      do n = 1, size(y, 2)
         if (size(anchor, 2) > 0) residual(1:2, n) = residual(1:2, n) + beam%viscous(n)*(y(1:2, n) - anchor(1:2, n))
         if (beam%centred(n)) residual(1:2, n) = 0.0_wp
         if (beam%held(n)) residual(:, n) = 0.0_wp
      end do
   end subroutine find_residual

   !> Least moment that exceeds the tolerance of the residual, and the round-off of the weight [N.m]. Smaller moments count as zero.
   !> A string on a straight wall, or hanging in a vertical hole, has zero moments: no error relative to round-off is meaningful.
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
      do e = 1, size(beam%element)
         load = max(load, maxval(abs(above + beam%element(e)%load(1:2))))
         above = beam%element(e)%load(5:6)
      end do
      load = max(load, maxval(abs(above)))
   end function largest_load

   !> True if a step changed moments at the ends of the elements by less than a part of the largest one after the step.
   pure function is_small(beam, y, step, part, least) result(small)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :), step(:, :)   !< shape after the step; the step (4,n) [m, -]
      real(wp), intent(in) :: part     !< [-]
      real(wp), intent(in) :: least    !< of least_moment [N.m]
      logical :: small
      real(wp) :: moments(2, 2), before(2, 2), most, changed    ! squares of the largest moment and change
      integer :: e
      most = least**2
      changed = 0.0_wp
      do e = 1, size(beam%element)
         call moments_of_shape(beam%element(e), y(:, e), y(:, e + 1), moments)
         call moments_of_shape(beam%element(e), y(:, e) - step(:, e), y(:, e + 1) - step(:, e + 1), before)
         most = max(most, sum(moments(:, 1)**2), sum(moments(:, 2)**2))
         changed = max(changed, sum((moments(:, 1) - before(:, 1))**2), sum((moments(:, 2) - before(:, 2))**2))
      end do
      small = changed <= part**2*most
   end function is_small
end module dg_bending_solution

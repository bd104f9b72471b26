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
   use dg_bending_beam, only: add_contact, bending_beam_type, curvature_within, node_unknowns, set_linear_part
   use dg_bending_elimination, only: eliminate, product_of
   use dg_block_matrix, only: block_matrix_type, copy_matrix
   implicit none
   private
   public :: solve_bending

   !> Largest residual at equilibrium, over the largest nodal load [-]: moments are then right to a hundred-thousandth.
   real(wp), parameter :: tolerance = 1.0e-6_wp
   integer, parameter :: most_iterations = 60
   !> A step is taken as it is when the work of the residual along it falls to this part of what it was [-]. Else it is shortened.
   real(wp), parameter :: falls = 0.7_wp
   integer, parameter :: most_trials = 8

contains

   !> Iterates from a shape to equilibrium. Where none is found within `most_iterations`, or the matrix is singular, y is the last
   !> shape.
   pure subroutine solve_bending(beam, y, settled, found, anchor)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(inout) :: y(:, :)   !< offsets and slopes (4,n) [m, -]
      real(wp), intent(in) :: settled      !< the iteration ends with a full step that changes moments by less than this part of
                                           !< the largest one [-]
      logical, intent(out) :: found        !< equilibrium
      !> Shape to which springs as stiff as the resistance pull compressed parts (4,n) [m, -]; absent: none do.
      real(wp), intent(in), optional :: anchor(:, :)
      type(block_matrix_type) :: linear, matrix
      real(wp), dimension(node_unknowns, size(y, 2)) :: load, residual, step, trial
      real(wp) :: scale, work, share, lower, upper, work_lower, work_trial
      logical :: regular, definite, small
      logical :: fixed(node_unknowns, size(y, 2))
      integer :: iteration, try
      fixed = spread(beam%held, 1, node_unknowns)
      fixed(1, :) = fixed(1, :) .or. beam%centred
      fixed(2, :) = fixed(2, :) .or. beam%centred
      call set_linear_part(beam, linear, load)
      scale = max(maxval(abs(load(1:2, :))), tiny(1.0_wp))
      matrix = linear
      found = .false.
      call assemble(beam, linear, load, fixed, y, residual, anchor, matrix)
      do iteration = 0, most_iterations
         if (maxval(abs(residual)) <= tolerance*scale) then
            found = .true.
            return
         end if
         call fix_unknowns(fixed, matrix)
         step = -residual
         call eliminate(matrix, step, regular, definite)
         if (.not. (regular .and. definite)) then
            call assemble(beam, linear, load, fixed, y, residual, anchor, matrix)
            call add_viscous(beam, matrix)
            call fix_unknowns(fixed, matrix)
            step = -residual
            call eliminate(matrix, step, regular, definite)
            if (.not. regular) return
         end if
         work = sum(residual*step)
         lower = 0.0_wp
         work_lower = work
         upper = 1.0_wp
         share = 1.0_wp
         small = is_small(beam, y, step, settled)
         do try = 1, most_trials
            trial = y + share*step
            if (try == 1 .and. .not. small) then      ! most often the shape that is taken
               call assemble(beam, linear, load, fixed, trial, residual, anchor, matrix)
            else
               call assemble(beam, linear, load, fixed, trial, residual, anchor)
            end if
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
         found = small .and. share >= 1.0_wp
         if (found) return
         if (small .or. share < 1.0_wp) call assemble(beam, linear, load, fixed, y, residual, anchor, matrix)
      end do
   end subroutine solve_bending

   !> Residual, and matrix where it is asked for, at a shape, contact included [N, N.m].
   pure subroutine assemble(beam, linear, load, fixed, shape, residual, anchor, matrix)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(in) :: linear     !< of all but contact
      real(wp), contiguous, intent(in) :: load(:, :)                !< of all but contact
      logical, intent(in) :: fixed(:, :)                !< unknowns that stay as they are
      real(wp), contiguous, intent(in) :: shape(:, :)
      real(wp), contiguous, intent(out) :: residual(:, :)
      real(wp), intent(in), optional :: anchor(:, :)
      type(block_matrix_type), intent(inout), optional :: matrix
      integer :: n
      if (present(matrix)) call copy_matrix(linear, matrix)
      call linear_residual(linear, load, shape, residual)
      call add_contact(beam, shape, residual, matrix)
      if (present(anchor)) then
         do n = 1, size(shape, 2)
            residual(1:2, n) = residual(1:2, n) + beam%viscous(n)*(shape(1:2, n) - anchor(1:2, n))
         end do
         if (present(matrix)) call add_viscous(beam, matrix)
      end if
      where (fixed) residual = 0.0_wp
   end subroutine assemble

   !> Stiffness that holds a compressed string, at its nodes.
   pure subroutine add_viscous(beam, matrix)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(inout) :: matrix
      integer :: n, i
      do n = 1, size(beam%viscous)
         do i = 1, 2
            matrix%diagonal(i, i, n) = matrix%diagonal(i, i, n) + beam%viscous(n)
         end do
      end do
   end subroutine add_viscous

   !> Whether a step changes moments at the ends of the elements by less than a part of the largest one there after it.
   pure function is_small(beam, y, step, part) result(small)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :), step(:, :)
      real(wp), intent(in) :: part     !< [-]
      logical :: small
      real(wp) :: length, largest, changed, change(2, 2), bend(2, 2)
      integer :: e
      largest = 0.0_wp
      changed = 0.0_wp
      do e = 1, size(beam%ei)
         length = beam%md(e + 1) - beam%md(e)
         change = curvature_within(length, step(:, e), step(:, e + 1))
         bend = change + curvature_within(length, y(:, e), y(:, e + 1))
         bend(:, 1) = bend(:, 1) + beam%curvature(:, e)
         bend(:, 2) = bend(:, 2) + beam%curvature(:, e)
         changed = max(changed, beam%ei(e)**2*maxval(change(1, :)**2 + change(2, :)**2))      ! squares
         largest = max(largest, beam%ei(e)**2*maxval(bend(1, :)**2 + bend(2, :)**2))
      end do
      small = changed <= part**2*largest
   end function is_small

   !> Matrix times y less load.
   pure subroutine linear_residual(matrix, load, y, residual)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), contiguous, intent(in) :: load(:, :), y(:, :)
      real(wp), contiguous, intent(out) :: residual(:, :)
      real(wp) :: r(node_unknowns)
      integer :: n
      do n = 1, size(y, 2)
         r = product_of(matrix%diagonal(:, :, n), y(:, n)) - load(:, n)
         if (n > 1) r = r + product_of(matrix%lower(:, :, n - 1), y(:, n - 1))
         if (n < size(y, 2)) r = r + product_of(matrix%upper(:, :, n), y(:, n + 1))
         residual(:, n) = r
      end do
   end subroutine linear_residual

   !> Takes unknowns that stay as they are out of the matrix: zero rows and columns, with ones on the diagonal.
   pure subroutine fix_unknowns(fixed, matrix)
      logical, intent(in) :: fixed(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      integer :: i, n, nodes
      nodes = size(fixed, 2)
      do n = 1, nodes
         do i = 1, node_unknowns
            if (.not. fixed(i, n)) cycle
            matrix%diagonal(i, :, n) = 0.0_wp
            matrix%diagonal(:, i, n) = 0.0_wp
            matrix%diagonal(i, i, n) = 1.0_wp
            if (n < nodes) then
               matrix%upper(i, :, n) = 0.0_wp
               matrix%lower(:, i, n) = 0.0_wp
            end if
            if (n > 1) then
               matrix%upper(:, i, n - 1) = 0.0_wp
               matrix%lower(i, :, n - 1) = 0.0_wp
            end if
         end do
      end do
   end subroutine fix_unknowns
end module dg_bending_solution

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
   use dg_bending_beam, only: add_contact, add_contact_stiffness, beam_contact_type, bending_beam_type, curvature_within, &
                              node_unknowns, set_linear_part
   use dg_bending_elimination, only: eliminate
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
      type(beam_contact_type) :: contact
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
      call find_residual(beam, linear, load, fixed, y, residual, contact, anchor)
      do iteration = 0, most_iterations
         if (maxval(abs(residual)) <= tolerance*scale) then
            found = .true.
            return
         end if
         call set_matrix(beam, linear, contact, fixed, merge(1, 0, present(anchor)), matrix)
         step = -residual
         call eliminate(matrix, step, regular, definite)
         if (.not. (regular .and. definite)) then
            call set_matrix(beam, linear, contact, fixed, merge(2, 1, present(anchor)), matrix)
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
            call find_residual(beam, linear, load, fixed, trial, residual, contact, anchor)
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
      end do
   end subroutine solve_bending

   !> Residual at a shape, contact included [N, N.m].
   pure subroutine find_residual(beam, linear, load, fixed, shape, residual, contact, anchor)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(in) :: linear     !< of all but contact
      real(wp), contiguous, intent(in) :: load(:, :)    !< of all but contact
      logical, intent(in) :: fixed(:, :)                !< unknowns that stay as they are
      real(wp), contiguous, intent(in) :: shape(:, :)
      real(wp), contiguous, intent(out) :: residual(:, :)
      type(beam_contact_type), intent(inout) :: contact !< how the wall presses there
      real(wp), intent(in), optional :: anchor(:, :)
      integer :: n
      call linear_residual(linear, load, shape, residual)
      call add_contact(beam, shape, residual, contact)
      if (present(anchor)) then
         do n = 1, size(shape, 2)
            residual(1:2, n) = residual(1:2, n) + beam%viscous(n)*(shape(1:2, n) - anchor(1:2, n))
         end do
      end if
      where (fixed) residual = 0.0_wp
   end subroutine find_residual

   !> Matrix where the wall presses so.
   pure subroutine set_matrix(beam, linear, contact, fixed, viscous, matrix)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(in) :: linear     !< of all but contact
      type(beam_contact_type), intent(in) :: contact
      logical, intent(in) :: fixed(:, :)                !< unknowns that stay as they are
      integer, intent(in) :: viscous                    !< how many times the stiffness that holds a compressed string is added
      type(block_matrix_type), intent(inout) :: matrix
      integer :: i
      call copy_matrix(linear, matrix)
      call add_contact_stiffness(beam, contact, matrix)
      do i = 1, viscous
         call add_viscous(beam, matrix)
      end do
      call fix_unknowns(fixed, matrix)
   end subroutine set_matrix

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
         bend(:, 1) = bend(:, 1) + (beam%curvature(:, e) - beam%bend(:, e))
         bend(:, 2) = bend(:, 2) + (beam%curvature(:, e) - beam%bend(:, e))
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
      integer :: n
      do n = 1, size(y, 2)
         residual(:, n) = -load(:, n)
         call add_product(matrix%diagonal(:, :, n), y(:, n), residual(:, n))
         if (n > 1) call add_product(matrix%lower(:, :, n - 1), y(:, n - 1), residual(:, n))
         if (n < size(y, 2)) call add_product(matrix%upper(:, :, n), y(:, n + 1), residual(:, n))
      end do
   end subroutine linear_residual

   !> r <- r + a x, of a block and a node's unknowns.
   pure subroutine add_product(a, x, r)
      real(wp), intent(in) :: a(node_unknowns, node_unknowns), x(node_unknowns)
      real(wp), intent(inout) :: r(node_unknowns)
      r = r + (a(:, 1)*x(1) + a(:, 2)*x(2) + a(:, 3)*x(3) + a(:, 4)*x(4))
   end subroutine add_product

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

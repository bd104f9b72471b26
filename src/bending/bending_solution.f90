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
   use dg_bending_beam, only: add_contact, bending_beam_type, moment_of_offsets, moment_within, node_unknowns, set_linear_part
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
      real(wp), intent(inout) :: y(:, :)   !< offsets and slopes (4,n) [m, -]
      real(wp), intent(in) :: settled      !< the iteration ends with a full step that changes moments by less than this part of
                                           !< the largest one [-]
      logical, intent(out) :: found        !< equilibrium
      !> Shape to which springs as stiff as the resistance pull compressed parts (4,n) [m, -]; absent: none do.
      real(wp), intent(in), optional :: anchor(:, :)
      type(block_matrix_type) :: linear, matrix
      real(wp), dimension(node_unknowns, size(y, 2)) :: load, residual, step, trial
      real(wp) :: scale, work, share, lower, upper, work_lower, work_trial, largest, changed
      logical :: regular, definite
      logical :: fixed(node_unknowns, size(y, 2))
      integer :: iteration, n, try
      fixed = spread(beam%held, 1, node_unknowns)
      fixed(1, :) = fixed(1, :) .or. beam%centred
      fixed(2, :) = fixed(2, :) .or. beam%centred
      call set_linear_part(beam, linear, load)
      scale = max(maxval(abs(load(1:2, :))), tiny(1.0_wp))
      matrix = linear
      found = .false.
      call assemble(beam, linear, load, fixed, y, residual, matrix, anchor)
      do iteration = 0, most_iterations
         if (maxval(abs(residual)) <= tolerance*scale) then
            found = .true.
            return
         end if
         call fix_unknowns(fixed, matrix)
         step = -residual
         call eliminate(matrix, step, regular, definite)
         if (.not. (regular .and. definite)) then
            call assemble(beam, linear, load, fixed, y, residual, matrix, anchor)
            do n = 1, size(y, 2)
               matrix%diagonal(1, 1, n) = matrix%diagonal(1, 1, n) + beam%viscous(n)
               matrix%diagonal(2, 2, n) = matrix%diagonal(2, 2, n) + beam%viscous(n)
            end do
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
         do try = 1, most_trials
            trial = y + share*step
            call assemble(beam, linear, load, fixed, trial, residual, matrix, anchor)
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
         if (share >= 1.0_wp) then
            call moment_change(beam, y, step, largest, changed)
            found = changed <= settled*largest
            if (found) return
         end if
      end do
   end subroutine solve_bending

   !> Residual and matrix at a shape, contact included [N, N.m].
   pure subroutine assemble(beam, linear, load, fixed, shape, residual, matrix, anchor)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(in) :: linear     !< of all but contact
      real(wp), intent(in) :: load(:, :)                !< of all but contact
      logical, intent(in) :: fixed(:, :)                !< unknowns that stay as they are
      real(wp), intent(in) :: shape(:, :)
      real(wp), intent(out) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      real(wp), intent(in), optional :: anchor(:, :)
      integer :: n, i
      call copy_matrix(linear, matrix)
      call linear_residual(linear, load, shape, residual)
      call add_contact(beam, shape, residual, matrix)
      if (present(anchor)) then
         do n = 1, size(shape, 2)
            do i = 1, 2
               residual(i, n) = residual(i, n) + beam%viscous(n)*(shape(i, n) - anchor(i, n))
               matrix%diagonal(i, i, n) = matrix%diagonal(i, i, n) + beam%viscous(n)
            end do
         end do
      end if
      where (fixed) residual = 0.0_wp
   end subroutine assemble

   !> Largest moment at the ends of the elements, and the largest that a step adds there [N.m].
   pure subroutine moment_change(beam, y, step, largest, changed)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: y(:, :), step(:, :)
      real(wp), intent(out) :: largest, changed
      integer :: e, side
      largest = 0.0_wp
      changed = 0.0_wp
      do e = 1, size(y, 2) - 1
         do side = 1, 2
            largest = max(largest, norm2(moment_within(beam, y, e, side)))
            changed = max(changed, norm2(moment_of_offsets(beam, step, e, side)))
         end do
      end do
   end subroutine moment_change

   !> Matrix times y less load.
   pure subroutine linear_residual(matrix, load, y, residual)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), intent(in) :: load(:, :), y(:, :)
      real(wp), intent(out) :: residual(:, :)
      integer :: n, j
      residual = -load
      do n = 1, size(y, 2)
         do j = 1, node_unknowns
            residual(:, n) = residual(:, n) + matrix%diagonal(:, j, n)*y(j, n)
         end do
      end do
      do n = 1, size(y, 2) - 1
         do j = 1, node_unknowns
            residual(:, n) = residual(:, n) + matrix%upper(:, j, n)*y(j, n + 1)
            residual(:, n + 1) = residual(:, n + 1) + matrix%lower(:, j, n)*y(j, n)
         end do
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

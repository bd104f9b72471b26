!> Equilibrium of a bending beam by Newton's method: full tangent, contact judged anew in each iteration, steps shortened where the
!> work of the residual along them does not fall.
!>
!> Under tension the beam's potential is convex (bending, tension, and a wall that pushes back the more the deeper it is entered),
!> friction aside, so that there is one equilibrium, and the work of the residual along a step rises from a negative value to zero.
module dg_bending_solution
   use dg_kinds, only: wp
   use dg_bending_beam, only: add_contact, bending_beam_type, moment_of_offsets, moment_within, node_unknowns, set_linear_part
   use dg_bending_elimination, only: eliminate
   use dg_block_matrix, only: block_matrix_type, copy_matrix
   implicit none
   private
   public :: solve_bending

   !> Largest residual over the largest nodal load at equilibrium [-]. Moments are then good to a hundred-thousandth.
   real(wp), parameter :: tolerance = 1.0e-6_wp
   integer, parameter :: most_iterations = 60
   !> A step is taken as it is where the residual's work along it falls to this part [-]; else it is shortened.
   real(wp), parameter :: falls = 0.7_wp
   integer, parameter :: most_trials = 8

contains

   !> Iterates from y(4,n) to equilibrium. `found` tells whether it was reached.
   pure subroutine solve_bending(beam, y, settled, found, anchor)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(inout) :: y(:, :)
      real(wp), intent(in) :: settled      !< a full step that changes no moment by more than this part of the largest ends it [-]
      logical, intent(out) :: found
      real(wp), intent(in), optional :: anchor(:, :)   !< shape to which springs as stiff as the resistance pull compressed parts
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

   !> Residual and matrix at a shape.
   pure subroutine assemble(beam, linear, load, fixed, shape, residual, matrix, anchor)
      type(bending_beam_type), intent(in) :: beam
      type(block_matrix_type), intent(in) :: linear     !< of all but contact
      real(wp), intent(in) :: load(:, :)                !< its load
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

   !> Largest moment within the elements, and the largest that a step adds [N.m].
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

   !> Matrix y - load, written out for blocks of four.
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

   !> Rows and columns of unknowns that stay as they are: ones on the diagonal.
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

!> A Newton step of a bending beam. Its matrix is made and eliminated node by node from the top down, without exchange of rows.
!> Under tension the matrix is positive definite but for friction and torque, whose part is small. An inexact step does no
!> harm, as dg_bending_solution judges it by its residual. No matrix is kept: a node only leaves one block and load for the
!> next one.
module dg_bending_elimination
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, b => node_unknowns
   use dg_bending_element, only: add_stiffness, element_stiffness, wall_push_type
   implicit none
   private
   public :: newton_step

   !> Columns of the equations of a node and the next one: those of the node, of the next one, and the load.
   integer, parameter :: next = b + 1, load = 2*b + 1

contains

   !> Solve matrix*step = -residual at a given push of the wall.
   pure subroutine newton_step(beam, push, points, viscous, indefinite, residual, step, solved)
      type(bending_beam_type), intent(in) :: beam
      type(wall_push_type), intent(in) :: push(:, :)        !< at the places of the elements (contact_places,n-1)
      type(wall_push_type), intent(in) :: points(:)         !< of tool joints
      integer, intent(in) :: viscous        !< number of times that the stiffness for a compressed string is added
      logical, intent(in) :: indefinite     !< pivots may be negative
      real(wp), intent(in) :: residual(:, :)      !< zero for fixed unknowns (4,n) [N, N.m]
      real(wp), intent(out) :: step(:, :)         !< [m, -]
      logical, intent(out) :: solved        !< false if a pivot vanishes, or is negative: there is no step then
      real(wp) :: a(2*b, load)              ! equations of a node and the next one
      real(wp) :: x(b, next:load, size(step, 2))      ! unknowns as a function of those of the next node, and of the load
      real(wp) :: left(b, next:load)                  ! block and load of a node from the nodes above it
      integer :: n, nodes, p, e
      nodes = size(step, 2)
      left = 0.0_wp
      left(:, load) = residual(:, 1)
      p = 1
      do n = 1, nodes
         if (n < nodes) then
            call element_stiffness(beam%element(n), push(:, n), a)
            a(next:, load) = residual(:, n + 1)
         else
            a = 0.0_wp
         end if
         a(:b, :b) = a(:b, :b) + left(:, next:load - 1)
         a(:b, load) = left(:, load)
         a(1, 1) = a(1, 1) + viscous*beam%viscous(n)
         a(2, 2) = a(2, 2) + viscous*beam%viscous(n)
         if (p <= size(points)) then
            if (beam%point(p) == n) then
               e = min(n, nodes - 1)
               if (points(p)%force > 0.0_wp) call add_stiffness(points(p), beam%element(e)%lever, beam%element(e)%around, a)
               p = p + 1
            end if
         end if
         if (beam%held(n)) then
            call keep(b, a)
         else if (beam%centred(n)) then
            call keep(b/2, a)
         end if
         call eliminate(a, indefinite, solved)
         if (.not. solved) return
         x(:, :, n) = a(:b, next:)
         left = a(next:, next:)
      end do
      step(:, nodes) = -x(:, load, nodes)
      do n = nodes - 1, 1, -1
         step(:, n) = -x(:, load, n) - matmul(x(:, next:load - 1, n), step(:, n + 1))
      end do
   end subroutine newton_step

   !> Remove the first unknowns of a node, which are fixed, from the equations: zero rows and columns, with ones on the
   !> diagonal.
   pure subroutine keep(fixed, a)
      integer, intent(in) :: fixed
      real(wp), intent(inout) :: a(2*b, load)
      integer :: i
      do i = 1, fixed
         a(i, :) = 0.0_wp
         a(:, i) = 0.0_wp
         a(i, i) = 1.0_wp
      end do
   end subroutine keep

   !> Solve the equations of a node for its unknowns, and remove these from the equations of the next one.
   pure subroutine eliminate(a, indefinite, solved)
      real(wp), intent(inout) :: a(2*b, load)
      logical, intent(in) :: indefinite
      logical, intent(out) :: solved
      real(wp) :: factor, reciprocal
      integer :: j, k
      do k = 1, b
         solved = a(k, k) > tiny(factor) .or. (indefinite .and. a(k, k) < -tiny(factor))
         if (.not. solved) return
         reciprocal = 1.0_wp/a(k, k)
         do j = k + 1, load
            factor = a(k, j)*reciprocal
            a(:, j) = a(:, j) - factor*a(:, k)
            a(k, j) = factor
         end do
      end do
   end subroutine eliminate
end module dg_bending_elimination

!> A Newton step of a bending beam: its matrix is made and eliminated at once, element by element.
!>
!> Blocks of 4 x 4 are solved by their quarters, without exchange of rows. Under tension the matrix is positive definite but for
!> friction and torque, whose part is small. An inexact step does no harm: dg_bending_solution judges it by the residual that it
!> leaves. No matrix is kept: what an element adds to its lower node is all that goes on to the next one. The processor takes two
!> numbers at once where gfortran leaves the loop over the numbers of a row a loop (unroll 1).
module dg_bending_elimination
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, b => node_unknowns
   use dg_bending_element, only: add_stiffness, contact_places, element_matrix, wall_push_type
   implicit none
   private
   public :: newton_step

   !> Equations of an element's nodes, row by row: coefficients of the upper node's unknowns, of the lower one's, right-hand side,
   !> and one number that makes pairs.
   integer, parameter :: side = 2*b + 1, wide = 2*b + 2
   !> What of these stands behind the coefficients of the upper node.
   integer, parameter :: behind = wide - b

contains

   !> Solves matrix step = -residual where the wall presses so.
   pure subroutine newton_step(beam, push, points, fixed, viscous, indefinite, residual, step, solved)
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: fixed(:)       !< how many of a node's unknowns, from the first on, stay as they are (n)
      type(wall_push_type), intent(in) :: push(contact_places, size(fixed) - 1)        !< at the places of the elements
      type(wall_push_type), intent(in) :: points(:)         !< of tool joints
      integer, intent(in) :: viscous        !< how many times the stiffness that holds a compressed string is added
      logical, intent(in) :: indefinite     !< pivots may be negative
      real(wp), intent(in) :: residual(b, size(fixed))      !< zero for unknowns that stay [N, N.m]
      real(wp), intent(out) :: step(b, size(fixed))         !< [m, -]
      logical, intent(out) :: solved        !< .false. where a pivot vanishes, or is negative: there is no step then
      real(wp) :: equations(wide, 2*b), rows(behind, b, size(fixed)), held
      integer :: n, nodes, i, p
      nodes = size(fixed)
      p = 1
      equations = 0.0_wp
      equations(side, b + 1:) = residual(:, 1)
      do n = 1, nodes
         call go_down(equations)
         if (n < nodes) then
            call element_matrix(beam%element(n), push(:, n), equations)
            equations(side, b + 1:) = residual(:, n + 1)
         else
            equations(b + 1:2*b, :b) = 0.0_wp
         end if
         held = viscous*beam%viscous(n)
         equations(1, 1) = equations(1, 1) + held
         equations(2, 2) = equations(2, 2) + held
         if (p <= size(points)) then
            if (beam%point(p) == n) then
               i = min(n, nodes - 1)
               if (points(p)%force > 0.0_wp) &
                  call add_stiffness(points(p), beam%element(i)%lever, beam%element(i)%around, equations)
               p = p + 1
            end if
         end if
         if (fixed(n) > 0) call keep(fixed(n), 0, equations)
         if (n < nodes) then
            if (fixed(n + 1) > 0) call keep(fixed(n + 1), b, equations)
         end if
         call eliminate(equations, indefinite, rows(:, :, n), solved)
         if (.not. solved) return
      end do
      step(:, nodes) = -rows(behind - 1, :, nodes)
      do n = nodes - 1, 1, -1
         do i = 1, b
            step(i, n) = -(rows(behind - 1, i, n) + rows(1, i, n)*step(1, n + 1) + rows(2, i, n)*step(2, n + 1) &
                           + rows(3, i, n)*step(3, n + 1) + rows(4, i, n)*step(4, n + 1))
         end do
      end do
   end subroutine newton_step

   !> What is left of the lower node's equations becomes the begin of the upper node's of the next element.
   pure subroutine go_down(equations)
      real(wp), intent(inout) :: equations(2, b + 1, 2*b)
      integer :: i
      do i = 1, b
         equations(:, 1, i) = equations(:, 3, b + i)
         equations(:, 2, i) = equations(:, 4, b + i)
         equations(:, b + 1, i) = equations(:, b + 1, b + i)
      end do
   end subroutine go_down

   !> Takes unknowns of a node that stay as they are out of the equations: zero rows and columns, with ones on the diagonal.
   pure subroutine keep(fixed, before, equations)
      integer, intent(in) :: fixed, before     !< how many; number of unknowns before the node's
      real(wp), intent(inout) :: equations(wide, 2*b)
      integer :: i
      do i = before + 1, before + fixed
         equations(i, :) = 0.0_wp
         equations(:2*b, i) = 0.0_wp
         equations(i, i) = 1.0_wp
      end do
   end subroutine keep

   !> Solves the equations of the upper node for its unknowns, first for the offsets, then for the slopes, and takes these unknowns
   !> out of the equations of the lower node.
   pure subroutine eliminate(equations, indefinite, rows, solved)
      real(wp), intent(inout) :: equations(wide, 2*b)
      logical, intent(in) :: indefinite     !< pivots may be negative
      real(wp), intent(out) :: rows(behind, b)
      logical, intent(out) :: solved
      real(wp) :: first(2, 2), second(2, 2), share(2, 2), rest(2, 2), upper(2), lower(2)
      integer :: i, j
      call invert(equations(1:2, 1:2), indefinite, first, solved)
      if (.not. solved) return
      do i = 1, 2
         share(:, i) = first(1, i)*equations(3:4, 1) + first(2, i)*equations(3:4, 2)
      end do
      do i = 1, 2
         rest(:, i) = equations(3:4, i + 2) - (equations(1, i + 2)*share(:, 1) + equations(2, i + 2)*share(:, 2))
      end do
      call invert(rest, indefinite, second, solved)
      if (.not. solved) return
      !GCC$ unroll 1
      do j = 1, behind
         upper(1) = first(1, 1)*equations(b + j, 1) + first(2, 1)*equations(b + j, 2)
         upper(2) = first(1, 2)*equations(b + j, 1) + first(2, 2)*equations(b + j, 2)
         lower(1) = equations(b + j, 3) - (equations(1, 3)*upper(1) + equations(2, 3)*upper(2))
         lower(2) = equations(b + j, 4) - (equations(1, 4)*upper(1) + equations(2, 4)*upper(2))
         rows(j, 3) = second(1, 1)*lower(1) + second(2, 1)*lower(2)
         rows(j, 4) = second(1, 2)*lower(1) + second(2, 2)*lower(2)
         rows(j, 1) = upper(1) - (share(1, 1)*rows(j, 3) + share(2, 1)*rows(j, 4))
         rows(j, 2) = upper(2) - (share(1, 2)*rows(j, 3) + share(2, 2)*rows(j, 4))
         do i = b + 1, 2*b
            equations(b + j, i) = equations(b + j, i) - (equations(1, i)*rows(j, 1) + equations(2, i)*rows(j, 2) &
                                                         + equations(3, i)*rows(j, 3) + equations(4, i)*rows(j, 4))
         end do
      end do
   end subroutine eliminate

   !> Inverse of a quarter, unless a pivot vanishes, or is negative.
   pure subroutine invert(a, indefinite, inverse, solved)
      real(wp), intent(in) :: a(:, :)          !< (2,2), part of a larger one: assumed shape copies nothing
      logical, intent(in) :: indefinite
      real(wp), intent(out) :: inverse(2, 2)
      logical, intent(out) :: solved
      real(wp) :: determinant, share
      determinant = a(1, 1)*a(2, 2) - a(1, 2)*a(2, 1)
      solved = determinant > tiny(1.0_wp) .and. a(1, 1) > 0.0_wp
      if (indefinite) solved = abs(determinant) > tiny(1.0_wp)
      if (.not. solved) return
      share = 1.0_wp/determinant
      inverse(1, 1) = a(2, 2)*share
      inverse(2, 2) = a(1, 1)*share
      inverse(1, 2) = -a(1, 2)*share
      inverse(2, 1) = -a(2, 1)*share
   end subroutine invert
end module dg_bending_elimination

!> A solution on a mesh as the start on a finer mesh.
module dg_refinement
   use dg_kinds, only: wp
   use dg_hermite, only: hermite_slope, hermite_value
   use dg_solution, only: solution_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_axial, dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, dof_twist
   implicit none
   private
   public :: transfer_solution

   !> Least length of an element over its earlier length at which it keeps the place of its gap [-]. It is 1 but for round-off.
   real(wp), parameter :: whole = 0.999_wp

contains

   !> Transfer a solution to a finer mesh. The state gives the string the same shape, slide and twist. Gaps keep their states,
   !> and each element gets its share of the contact forces.
   pure subroutine transfer_solution(trajectory, solution, finer)
      type(trajectory_type), intent(in) :: trajectory
      type(solution_type), intent(in) :: solution
      type(solution_type), intent(inout) :: finer    !< with all its arrays allocated
      real(wp) :: xi, shape(4), slope(4), place(3), direction(3), axis(3), shift(3), d(3)
      integer :: n, e, a
      associate (coarse => solution%mesh, work => solution%work, fine => finer%mesh, state => finer%state)
         e = 1
         do n = 1, fine%nodes
            do while (e < coarse%elements .and. fine%md(n) > coarse%md(e + 1))
               e = e + 1
            end do
            xi = min(max((fine%md(n) - coarse%md(e))/coarse%length(e), 0.0_wp), 1.0_wp)
            shape = hermite_value(xi, coarse%length(e))
            slope = hermite_slope(xi, coarse%length(e))
            place = shape(1)*work%shift(:, e) + shape(2)*work%d(:, e) &
                    + shape(3)*(coarse%chord(:, e) + work%shift(:, e + 1)) + shape(4)*work%d(:, e + 1)
            direction = slope(1)*work%shift(:, e) + slope(2)*work%d(:, e) &
                        + slope(3)*(coarse%chord(:, e) + work%shift(:, e + 1)) + slope(4)*work%d(:, e + 1)
            axis = fine%base(:, n) - coarse%base(:, e)           ! of the hole at the fine node, from the coarse node
            do a = coarse%arc(e), fine%arc(n) - 1
               axis = axis + trajectory%arcs(a)%chord
            end do
            shift = place - axis
            d = direction/norm2(direction)
            associate (frame => fine%frame(:, :, n))
               state(dof_axial, n) = dot_product(shift, frame(:, 1))
               state(dof_lateral_1, n) = dot_product(shift, frame(:, 2))
               state(dof_lateral_2, n) = dot_product(shift, frame(:, 3))
               state(dof_slope_1, n) = dot_product(d, frame(:, 2))/dot_product(d, frame(:, 1))
               state(dof_slope_2, n) = dot_product(d, frame(:, 3))/dot_product(d, frame(:, 1))
            end associate
            state(dof_twist, n) = (1.0_wp - xi)*solution%state(dof_twist, e) + xi*solution%state(dof_twist, e + 1)
         end do
         e = 1
         do n = 1, fine%elements
            do while (e < coarse%elements .and. 0.5_wp*(fine%md(n) + fine%md(n + 1)) > coarse%md(e + 1))
               e = e + 1
            end do
            xi = fine%length(n)/coarse%length(e)
            finer%gaps%state(n) = solution%gaps%state(e)
            finer%work%normal(n) = xi*work%normal(e)
            if (xi > whole) finer%gaps%xi(n) = solution%gaps%xi(e)
         end do
         state(dof_axial, 1) = 0.0_wp
         state(dof_twist, 1) = 0.0_wp
      end associate
   end subroutine transfer_solution
end module dg_refinement

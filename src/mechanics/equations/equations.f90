!> Storage for the equations of one solution, with the inputs and results of its iteration.
module dg_equations
   use dg_kinds, only: wp
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, block_size, make_matrix_room
   use dg_case_result, only: iteration_type
   use dg_gap_table, only: gap_table_type
   use dg_linear_solver, only: linear_solver_type, new_linear_solver
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, make_room_for_recovery, workspace_type
   implicit none
   private
   public :: equations_type, release_room, make_room, find_tangent, end_iterations
   public :: add_gap_rigidity
   public :: forces_alone, whole_tangent, energy_tangent

   !> Parts of the tangent to assemble: no part; the whole; or that of the energy (`conservative` of `assemble`).
   integer, parameter :: forces_alone = 0, whole_tangent = 1, energy_tangent = 2

   type :: equations_type
      type(block_matrix_type) :: matrix
      type(linear_solver_type) :: solver
      real(wp), allocatable :: step(:, :)         !< (6,nodes) [m, rad, -]
      real(wp) :: force_scale = 1.0_wp            !< scale to which residuals are compared [N]
      type(iteration_type), allocatable :: history(:)
      integer :: iterations = 0                   !< of all attempts so far
      real(wp) :: unbalanced_md = 0.0_wp          !< depth of the largest unbalanced force at the end of an attempt [m]
      logical :: gaps_taken_back = .false.        !< moved gaps found no better equilibrium: their places were restored
   end type equations_type

contains

   !> Release the arrays of earlier equations. The start of an iteration does not use them, and needs half as much memory.
   pure subroutine release_room(equations)
      type(equations_type), intent(inout) :: equations
      equations%matrix = block_matrix_type()
      equations%solver = linear_solver_type()
      if (allocated(equations%step)) deallocate (equations%step)
   end subroutine release_room

   !> Allocate the equations of a mesh.
   pure subroutine make_room(equations, kind, nodes)
      type(equations_type), intent(inout) :: equations
      integer, intent(in) :: kind          !< linear solver
      integer, intent(in) :: nodes
      call make_matrix_room(nodes, equations%matrix)
      call new_linear_solver(kind, nodes, equations%solver)
      if (allocated(equations%step)) deallocate (equations%step)
      allocate (equations%step(block_size, nodes), source=0.0_wp)
   end subroutine make_room

   !> Residual(6,nodes) and, unless forces alone are wanted, tangent.
   pure subroutine find_tangent(equations, trajectory, mesh, loads, gaps, state, wanted, work, residual)
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)  !< (6,nodes) [m, rad, -]
      integer, intent(in) :: wanted        !< forces_alone, whole_tangent or energy_tangent
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)   !< (6,nodes) [N, N.m]
      call assemble(trajectory, mesh, loads, gaps, state, wanted == energy_tangent, work, residual, equations%matrix, &
                    wanted == forces_alone)
   end subroutine find_tangent

   !> Release what only iterations need, half of a solution's memory. Fill the other quantities of the result. Contact forces
   !> stay those of the iteration. Those of Eq. 4 at the depths in the wall would have the round-off of places times the wall's
   !> stiffness.
   pure subroutine end_iterations(equations, trajectory, mesh, loads, gaps, state, work)
      type(equations_type), intent(inout) :: equations
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)   !< (6,nodes) [m, rad, -]
      type(workspace_type), intent(inout) :: work
      real(wp), allocatable :: residual(:, :)
      equations%matrix = block_matrix_type()
      equations%solver = linear_solver_type()
      deallocate (equations%step)
      allocate (residual(block_size, mesh%nodes))
      call make_room_for_recovery(mesh, work)
      call assemble(trajectory, mesh, loads, gaps, state, .false., work, residual, equations%matrix, forces_only=.true.)
   end subroutine end_iterations

   !> Add the rigidity gk_min of the gaps [N/m2] to the lateral unknowns.
   pure subroutine add_gap_rigidity(mesh, gk_min, matrix)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: gk_min   !< [N/m2]
      type(block_matrix_type), intent(inout) :: matrix
      integer :: n, i, e
      do e = 1, mesh%elements
         do n = e, e + 1
            do i = dof_lateral_1, dof_lateral_2
               matrix%diagonal(i, i, n) = matrix%diagonal(i, i, n) + 0.5_wp*gk_min*mesh%length(e)
            end do
         end do
      end do
   end subroutine add_gap_rigidity
end module dg_equations

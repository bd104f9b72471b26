!> The linear problem of one iteration in which contact forces are unknowns of their own.
!>
!> Unknowns are the step d of the nodes and the change dR of every closed gap's contact force R. A gap is closed where it presses,
!> and then |f| = depth(R), the depth in the wall that carries R; else R = 0. To first order, with h = |f| - depth(R) what the gap
!> is too deep for its force,
!>   K d + on dR = -r(d, R),      dR = rho (h + by.d),
!> r the residual with the forces as they are, K its tangent at given R, friction's directions in `on` (dg_gap_action). rho is
!> the wall's stiffness in series with a softer one: a proximal step, the wall's own when that one is stiff. dR is eliminated
!> element by element: K + rho on by^T keeps the blocks of the chain.
!>
!> Which gaps are closed is settled within the linear problem, before the string moves: a closed gap that would pull opens, an open
!> one that would reach into the wall closes, and the problem is solved anew, which costs a third of an assembly (primal-dual
!> active set: Hintermueller, Ito & Kunisch 2002, SIAM J. Optim. 13, 865).
module dg_contact_problem
   use dg_kinds, only: wp
   use dg_assembly, only: add_friction
   use dg_block_matrix, only: block_matrix_type, copy_matrix, new_block_matrix
   use dg_block_solver, only: block_positive_definite
   use dg_gap_action, only: find_contact_rows, load_type
   use dg_gap_depths, only: depth_of
   use dg_gap_state, only: state_free, state_rigid
   use dg_gap_table, only: gap_table_type
   use dg_linear_solver, only: solve_linear
   use dg_mesh, only: mesh_type
   use dg_newton, only: newton_type
   use dg_viscosity, only: add_viscosity, damped_type, raise_viscosity
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: contact_problem_type, new_contact_problem, measure_contacts, add_pushes, hold_by_viscosity, is_definite
   public :: prepare_problem, solve_problem, change_of_gap, in_series

   !> Times that gaps are opened and closed within one linear problem: most settle in three to five. With one, 15 of 53 hard wells
   !> found no equilibrium, with ten 11.
   integer, parameter :: most_rounds = 10

   type :: contact_problem_type
      real(wp), allocatable :: by(:, :)        !< change of |f| by the element's unknowns (12,e)
      real(wp), allocatable :: on(:, :)        !< residual by the contact force (12,e)
      real(wp), allocatable :: penalty(:)      !< rho (e) [N/m]
      real(wp), allocatable :: deep(:)         !< h (e) [m]
      real(wp), allocatable :: wanted(:)       !< R + dR of closed gaps, 0 of open ones (e) [N]
      logical, allocatable :: closed(:)        !< in the linear problem (e)
      real(wp), allocatable :: load(:, :)      !< its right-hand side, pushes included (6,nodes)
      type(block_matrix_type) :: base          !< its matrix without closed gaps
   end type contact_problem_type

contains

   !> Room for a mesh.
   pure subroutine new_contact_problem(mesh, problem)
      type(mesh_type), intent(in) :: mesh
      type(contact_problem_type), intent(out) :: problem
      allocate (problem%by(12, mesh%elements), problem%on(12, mesh%elements), problem%penalty(mesh%elements), &
                problem%deep(mesh%elements), problem%wanted(mesh%elements), problem%load(6, mesh%nodes), source=0.0_wp)
      allocate (problem%closed(mesh%elements), source=.false.)
      problem%base = new_block_matrix(mesh%nodes)
   end subroutine new_contact_problem

   !> Rows, penalties and depths at `state`, at which `work` has been placed and surveyed.
   pure subroutine measure_contacts(mesh, loads, gaps, state, soft, work, problem)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      real(wp), intent(in) :: soft                 !< stiffness in series with the wall's [N/m2]
      type(workspace_type), intent(inout) :: work  !< with the contact forces
      type(contact_problem_type), intent(inout) :: problem
      real(wp) :: wall
      integer :: e
      call find_contact_rows(mesh, loads, gaps, state, work, problem%by, problem%on)
      do e = 1, mesh%elements
         wall = merge(gaps%law(e)%maximum, gaps%law(e)%contact, gaps%state(e) == state_rigid)
         problem%penalty(e) = in_series(wall, soft*mesh%length(e))
         problem%deep(e) = work%displacement(e) - depth_of(gaps%law(e), work%normal(e))
      end do
   end subroutine measure_contacts

   !> load(6,nodes) = residual + rho h on, of the gaps that are closed: the residual were contact forces those that belong to the
   !> depths, with rho for the wall.
   pure subroutine add_pushes(gaps, residual, problem, load)
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: residual(:, :)
      type(contact_problem_type), intent(in) :: problem
      real(wp), intent(out) :: load(:, :)
      real(wp) :: push
      integer :: e
      load = residual
      do e = 1, size(gaps%state)
         if (gaps%state(e) == state_free) cycle
         push = problem%penalty(e)*problem%deep(e)
         load(:, e) = load(:, e) + push*problem%on(1:6, e)
         load(:, e + 1) = load(:, e + 1) + push*problem%on(7:12, e)
      end do
   end subroutine add_pushes

   !> Stiffness of two springs in series [N/m].
   elemental function in_series(a, b) result(stiffness)
      real(wp), intent(in) :: a, b
      real(wp) :: stiffness
      stiffness = 1.0_wp/(1.0_wp/a + 1.0_wp/b)
   end function in_series

   !> The energy's tangent with the closed gaps' stiffness.
   pure subroutine add_closed(energy, problem, matrix)
      type(block_matrix_type), intent(in) :: energy
      type(contact_problem_type), intent(in) :: problem
      type(block_matrix_type), intent(inout) :: matrix
      integer :: e
      call copy_matrix(energy, matrix)
      do e = 1, size(problem%closed)
         if (problem%closed(e)) call add_dyad(problem%penalty(e)*problem%by(:, e), problem%by(:, e), e, matrix)
      end do
   end subroutine add_closed

   !> Whether that tangent, with so much viscosity, is positive definite.
   pure subroutine is_definite(damped, problem, viscosity, matrix, definite)
      type(damped_type), intent(in) :: damped
      type(contact_problem_type), intent(in) :: problem
      real(wp), intent(in) :: viscosity               !< in units of damped%lump [-]
      type(block_matrix_type), intent(inout) :: matrix
      logical, intent(out) :: definite
      call add_closed(damped%energy, problem, matrix)
      call block_positive_definite(matrix, viscosity, damped%lump, definite)
   end subroutine is_definite

   !> Raises viscosity until that tangent is positive definite with it.
   pure subroutine hold_by_viscosity(problem, matrix, damped)
      type(contact_problem_type), intent(in) :: problem
      type(block_matrix_type), intent(inout) :: matrix
      type(damped_type), intent(inout) :: damped
      call add_closed(damped%energy, problem, matrix)
      call raise_viscosity(matrix, damped%lump, 0.0_wp, damped%viscosity)
   end subroutine hold_by_viscosity

   !> The matrix without closed gaps: energy's tangent, friction's where it is `live`, and viscosity.
   subroutine prepare_problem(damped, mesh, loads, gaps, state, live, work, problem)
      type(damped_type), intent(in) :: damped
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: state(:, :)
      logical, intent(in) :: live
      type(workspace_type), intent(inout) :: work
      type(contact_problem_type), intent(inout) :: problem
      call copy_matrix(damped%energy, problem%base)
      if (live) call add_friction(mesh, loads, gaps, state, work, problem%base)
      call add_viscosity(damped, problem%base)
   end subroutine prepare_problem

   !> Solves the linear problem for newton%step, the forces wanted and the gaps closed. `slope` is that of the energy along the
   !> step.
   subroutine solve_problem(newton, gaps, residual, force, live, problem, slope, fault)
      type(newton_type), intent(inout) :: newton
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: residual(:, :)       !< r(d, R)
      real(wp), intent(in) :: force(:)             !< R [N]
      logical, intent(in) :: live                  !< friction follows the contact forces within the problem
      type(contact_problem_type), intent(inout) :: problem   !< `closed`: where to begin
      real(wp), intent(out) :: slope               !< [J]
      integer, intent(out) :: fault                !< 0: none
      real(wp) :: change
      integer :: round, e, changes
      do round = 1, most_rounds
         call copy_matrix(problem%base, newton%matrix)
         problem%load = residual
         do e = 1, size(force)
            change = -force(e)
            if (problem%closed(e)) then
               change = problem%penalty(e)*problem%deep(e)
               if (live) then
                  call add_dyad(problem%penalty(e)*problem%on(:, e), problem%by(:, e), e, newton%matrix)
               else
                  call add_dyad(problem%penalty(e)*problem%by(:, e), problem%by(:, e), e, newton%matrix)
               end if
            end if
            problem%load(:, e) = problem%load(:, e) + change*problem%on(1:6, e)
            problem%load(:, e + 1) = problem%load(:, e + 1) + change*problem%on(7:12, e)
         end do
         call solve_linear(newton%solver, newton%matrix, problem%load, newton%step, fault)
         if (fault /= 0) return
         call judge_closed(gaps, force, newton%step, problem, changes)
         if (changes == 0) exit
      end do
      slope = sum(newton%step*problem%load)
   end subroutine solve_problem

   !> Opens and closes gaps by what a step makes of them; enters the forces wanted.
   pure subroutine judge_closed(gaps, force, step, problem, changes)
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: force(:), step(:, :)
      type(contact_problem_type), intent(inout) :: problem
      integer, intent(out) :: changes
      real(wp) :: deep
      integer :: e
      changes = 0
      do e = 1, size(force)
         deep = problem%deep(e) + change_of_gap(problem, step, e)
         problem%wanted(e) = 0.0_wp
         if (problem%closed(e)) then
            problem%wanted(e) = force(e) + problem%penalty(e)*deep
            if (problem%wanted(e) >= -gaps%law(e)%r_n0) cycle
            problem%closed(e) = .false.
         else
            if (deep <= gaps%law(e)%eps_n0*gaps%law(e)%clearance .or. .not. any(abs(problem%by(:, e)) > 0.0_wp)) cycle
            problem%closed(e) = .true.
            problem%wanted(e) = problem%penalty(e)*deep
         end if
         changes = changes + 1
      end do
   end subroutine judge_closed

   !> Change of a gap's |f| by a step, to first order [m].
   pure function change_of_gap(problem, step, e) result(change)
      type(contact_problem_type), intent(in) :: problem
      real(wp), intent(in) :: step(:, :)
      integer, intent(in) :: e
      real(wp) :: change
      change = sum(problem%by(1:6, e)*step(:, e)) + sum(problem%by(7:12, e)*step(:, e + 1))
   end function change_of_gap

   !> Adds a b^T of an element's unknowns to a chain.
   pure subroutine add_dyad(a, b, e, matrix)
      real(wp), intent(in) :: a(12), b(12)
      integer, intent(in) :: e
      type(block_matrix_type), intent(inout) :: matrix
      integer :: j
      do j = 1, 6
         matrix%diagonal(:, j, e) = matrix%diagonal(:, j, e) + a(1:6)*b(j)
         matrix%upper(:, j, e) = matrix%upper(:, j, e) + a(1:6)*b(j + 6)
         matrix%lower(:, j, e) = matrix%lower(:, j, e) + a(7:12)*b(j)
         matrix%diagonal(:, j, e + 1) = matrix%diagonal(:, j, e + 1) + a(7:12)*b(j + 6)
      end do
   end subroutine add_dyad
end module dg_contact_problem

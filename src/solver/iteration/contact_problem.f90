!> Linear problem of one iteration in which contact forces are unknowns of their own.
!>
!> Unknowns are the step d of the nodes and the change dR of the contact force R of every closed gap. A closed gap presses, and
!> then |f| = depth(R), the depth in the wall that carries R. In an open gap R = 0. The depth beyond what the force R needs
!> is h = |f| - depth(R) [m]. To first order:
!>   K d + on dR = -r(d, R)
!>   dR = rho (h + by.d)
!> - r is the residual at the present forces, and K its tangent at given R.
!> - on = dr/dR has the directions of normal force and friction. by = d |f|/dq has the direction of the depth
!>   (dg_gap_action).
!> - rho is the wall's stiffness in series with a softer one, which keeps steps short. As the softer one grows, rho becomes the
!>   wall's.
!> The force dR is eliminated element by element: K + rho on by^T keeps the blocks of the chain. Where friction forces are held
!> constant, on = by, and the matrix is symmetric.
!>
!> The set of closed gaps is found within the linear problem, before the string moves. A closed gap that would pull opens. An
!> open one that would enter the wall closes. The problem is then solved anew, which costs a third of an assembly. This is the
!> primal-dual active set method (Hintermueller, Ito & Kunisch 2002, SIAM J. Optim. 13, 865).
module dg_contact_problem
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   use dg_element_rows, only: add_dyad, add_rows, multiply_rows
   use dg_equations, only: equations_type
   use dg_followed_gaps, only: follower_type, see_from_extrema
   use dg_gap_action, only: find_contact_rows, load_type
   use dg_gap_state, only: depth_of, state_free, state_rigid
   use dg_gap_table, only: gap_table_type
   use dg_linear_solver, only: solve_linear
   use dg_mesh, only: mesh_type
   use dg_positive_definite, only: block_positive_definite
   use dg_tuning, only: tuning_type
   use dg_damping, only: damping_most
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: contact_problem_type, new_contact_problem, measure_contacts, add_pushes, damp_until_definite, is_definite
   public :: solve_problem, in_series

   type :: contact_problem_type
      real(wp), allocatable :: by(:, :)        !< change of |f| by the unknowns of the element's nodes (12,e)
      real(wp), allocatable :: on(:, :)        !< change of the residual by the contact force (12,e)
      real(wp), allocatable :: penalty(:)      !< rho (e) [N/m]
      real(wp), allocatable :: deep(:)         !< h (e) [m]
      real(wp), allocatable :: moved(:)        !< change of |f| by the linear problem's step (e) [m]
      real(wp), allocatable :: wanted(:)       !< R + dR of closed gaps, 0 of open ones (e) [N]
      logical, allocatable :: closed(:)        !< in the linear problem (e)
      real(wp), allocatable :: load(:, :)      !< right-hand side with pushes; then the residual after a step (6,nodes)
      type(follower_type), allocatable :: followers(:)   !< gaps whose places are unknowns too
      integer :: unsettled = 0                 !< gaps that would still open or close after the last round
   end type contact_problem_type

contains

   !> Allocate the arrays of a problem for a mesh.
   pure subroutine new_contact_problem(mesh, problem)
      type(mesh_type), intent(in) :: mesh
      type(contact_problem_type), intent(out) :: problem
      allocate (problem%by(2*block_size, mesh%elements), problem%on(2*block_size, mesh%elements), problem%penalty(mesh%elements), &
                problem%deep(mesh%elements), problem%moved(mesh%elements), problem%wanted(mesh%elements), &
                problem%load(block_size, mesh%nodes), source=0.0_wp)
      allocate (problem%closed(mesh%elements), source=.false.)
      allocate (problem%followers(0))
   end subroutine new_contact_problem

   !> Compute rows, penalties and depths at the state at which `work` has been placed and surveyed.
   pure subroutine measure_contacts(mesh, loads, gaps, soft, work, problem)
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: soft                 !< stiffness in series with the wall's [N/m2]
      type(workspace_type), intent(inout) :: work  !< with the contact forces
      type(contact_problem_type), intent(inout) :: problem
      real(wp) :: wall
      integer :: e
      call find_contact_rows(mesh, loads, gaps, 1, mesh%elements, work, problem%by, problem%on)
      do e = 1, mesh%elements
         wall = merge(gaps%law(e)%maximum, gaps%law(e)%contact, gaps%state(e) == state_rigid)
         problem%penalty(e) = in_series(wall, soft*mesh%length(e))
         problem%deep(e) = work%displacement(e) - depth_of(gaps%law(e), work%normal(e))
      end do
      call see_from_extrema(problem%followers, problem%by, problem%on, problem%deep)
   end subroutine measure_contacts

   !> Set problem%load = residual + sum of rho*h*on over the closed gaps (6,nodes). It is the residual with the contact forces
   !> that belong to the depths, if the wall had the stiffness rho.
   pure subroutine add_pushes(gaps, residual, problem)
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: residual(:, :)   !< at the present forces (6,nodes) [N, N.m]
      type(contact_problem_type), intent(inout) :: problem
      real(wp) :: push(size(gaps%state))
      problem%load = residual
      push = merge(problem%penalty*problem%deep, 0.0_wp, gaps%state /= state_free)
      call add_rows(size(push), push, problem%on, problem%load)
   end subroutine add_pushes

   !> Stiffness of two springs in series [N/m].
   elemental function in_series(a, b) result(stiffness)
      real(wp), intent(in) :: a, b   !< [N/m]
      real(wp) :: stiffness
      stiffness = 1.0_wp/(1.0_wp/a + 1.0_wp/b)
   end function in_series

   !> Test if the energy's tangent is positive definite, with the stiffness of closed gaps and the given damping.
   pure subroutine is_definite(energy, lump, problem, damping, definite)
      type(block_matrix_type), intent(in) :: energy
      real(wp), intent(in) :: lump(:, :)            !< diagonal terms of a unit of damping (6,nodes) [N/m, N.m]
      type(contact_problem_type), intent(in) :: problem
      real(wp), intent(in) :: damping               !< [-]
      logical, intent(out) :: definite
      call block_positive_definite(energy, damping, lump, definite, merge(problem%penalty, 0.0_wp, problem%closed), problem%by)
   end subroutine is_definite

   !> Raise damping until that tangent is positive definite with it, or with the margin.
   pure subroutine damp_until_definite(tuning, energy, lump, problem, margin, damping)
      type(tuning_type), intent(in) :: tuning
      type(block_matrix_type), intent(in) :: energy
      real(wp), intent(in) :: lump(:, :)              !< diagonal terms of a unit of damping (6,nodes) [N/m, N.m]
      type(contact_problem_type), intent(in) :: problem
      real(wp), intent(in) :: margin                  !< damping that it may have without a raise [-]
      real(wp), intent(inout) :: damping              !< in units of F^2/(4 EI) [-]
      logical :: definite
      do
         call is_definite(energy, lump, problem, max(damping, margin), definite)
         if (definite .or. damping > damping_most) return
         damping = tuning%until_definite*max(damping, tuning%damping_start)
      end do
   end subroutine damp_until_definite

   !> Solve the linear problem for equations%step, the moves of the gaps, their forces and the closed gaps. On entry
   !> equations%matrix has no closed gaps, on return it has them.
   subroutine solve_problem(most_rounds, equations, gaps, residual, force, live, problem, fault)
      integer, intent(in) :: most_rounds           !< times that gaps are opened and closed
      type(equations_type), intent(inout) :: equations
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: residual(:, :)       !< r(d, R) (6,nodes) [N, N.m]
      real(wp), intent(in) :: force(:)             !< R [N]
      logical, intent(in) :: live                  !< true if friction follows the contact forces within the problem
      type(contact_problem_type), intent(inout) :: problem   !< closed: on entry the first guess
      integer, intent(out) :: fault                !< 0: none
      logical :: entered(size(force))              !< gaps whose stiffness is in the matrix
      real(wp) :: change(size(force)), rho
      integer :: round, e, changes
      entered = .false.
      changes = 0
      do round = 1, most_rounds
         problem%load = residual
         change = merge(problem%penalty*problem%deep, -force, problem%closed)
         if (live) then
            call add_rows(size(force), change, problem%on, problem%load)
         else
            call add_rows(size(force), change, problem%by, problem%load)
         end if
         do e = 1, size(force)
            if (problem%closed(e) .eqv. entered(e)) cycle
            rho = merge(problem%penalty(e), -problem%penalty(e), problem%closed(e))
            if (live) then
               call add_dyad(rho, problem%on(:, e), problem%by(:, e), e, equations%matrix)
            else
               call add_dyad(rho, problem%by(:, e), problem%by(:, e), e, equations%matrix)
            end if
            entered(e) = problem%closed(e)
         end do
         call solve_linear(equations%solver, equations%matrix, problem%load, equations%step, fault)
         if (fault /= 0) return
         call judge_closed(gaps, force, equations%step, problem, changes)
         if (changes == 0) exit
      end do
      problem%unsettled = changes
   end subroutine solve_problem

   !> Open and close gaps by the result of a step, and set the contact forces at its end.
   pure subroutine judge_closed(gaps, force, step, problem, changes)
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: force(:)
      real(wp), intent(in), contiguous :: step(:, :)
      type(contact_problem_type), intent(inout) :: problem
      integer, intent(out) :: changes
      real(wp) :: deep
      integer :: e
      changes = 0
      call multiply_rows(size(force), problem%by, step, problem%moved)
      do e = 1, size(force)
         deep = problem%deep(e) + problem%moved(e)
         problem%wanted(e) = 0.0_wp
         if (problem%closed(e)) then
            problem%wanted(e) = force(e) + problem%penalty(e)*deep
            if (problem%wanted(e) >= -gaps%thresholds%r_n0) cycle
            problem%closed(e) = .false.
         else
            if (deep <= gaps%thresholds%eps_n0*gaps%law(e)%clearance .or. .not. any(abs(problem%by(:, e)) > 0.0_wp)) cycle
            problem%closed(e) = .true.
            problem%wanted(e) = problem%penalty(e)*deep
         end if
         changes = changes + 1
      end do
   end subroutine judge_closed
end module dg_contact_problem

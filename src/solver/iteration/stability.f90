!> Stability of an equilibrium, and its margin. The tangent without friction and torque, the second derivative of an energy, is
!> positive definite where a string is stable.
module dg_stability
   use dg_kinds, only: wp
   use dg_assembly, only: assemble
   use dg_beam_element, only: beam_stress_tangent
   use dg_block_matrix, only: add_symmetric, block_matrix_type, new_block_matrix
   use dg_director, only: director_curvature
   use dg_mesh, only: mesh_type
   use dg_positive_definite, only: block_positive_definite
   use dg_scatter, only: clear_element, clear_held, element_type, scatter_element
   use dg_solution, only: solution_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: find_stability_margin

   !> Number of halvings in the search of the stability margin, which give it to 0.4 %.
   integer, parameter :: margin_halvings = 8

contains

   !> Part by which compression could still grow before stability is lost [-], at most 1. The tangent stays positive definite
   !> when that multiple of Ksigma of the compressed elements (Eq. 10) is added. Contact forces are kept. A helix or sinusoid
   !> that may be shifted along the hole without work has 0. The arrays of solution%equations are overwritten.
   pure subroutine find_stability_margin(trajectory, solution, margin)
      type(solution_type), intent(inout) :: solution
      type(trajectory_type), intent(in) :: trajectory
      real(wp), intent(out) :: margin   !< 0 to 1 [-]
      type(block_matrix_type) :: compression
      real(wp) :: low, high, added, forces(solution%mesh%elements), residual(6, solution%mesh%nodes)
      logical :: definite
      integer :: i
      associate (equations => solution%equations, mesh => solution%mesh, work => solution%work)
         forces = work%normal
         work%separate = .false.        ! the stiffness of the walls belongs to this tangent
         call assemble(trajectory, mesh, solution%loads, solution%gaps, solution%state, .true., work, residual, equations%matrix)
         work%separate = .true.
         work%normal = forces
         call assemble_compression(mesh, work, compression)
         equations%step = 0.0_wp        ! no damping
         low = 0.0_wp
         high = 1.0_wp
         margin = high
         added = 0.0_wp
         do i = 0, margin_halvings
            call add_symmetric(margin - added, compression, equations%matrix)
            added = margin
            call block_positive_definite(equations%matrix, 0.0_wp, equations%step, definite)
            if (definite) then
               low = margin
               if (i == 0) return
            else
               high = margin
            end if
            margin = 0.5_wp*(low + high)
         end do
         margin = low
      end associate
   end subroutine find_stability_margin

   !> Assemble Ksigma of the elements in compression.
   pure subroutine assemble_compression(mesh, work, matrix)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work       !< nodes placed, with axial forces
      type(block_matrix_type), intent(out) :: matrix
      type(element_type) :: element
      real(wp) :: chord(3), force(12)
      integer :: e, n
      matrix = new_block_matrix(mesh%nodes)
      call clear_element(element)
      do e = 1, mesh%elements
         if (.not. work%axial(e) < 0.0_wp) cycle
         chord = mesh%chord(:, e) + (work%shift(:, e + 1) - work%shift(:, e))
         call beam_stress_tangent(chord, work%d(:, e), work%d(:, e + 1), work%axial(e), force, element%k)
         call scatter_element(mesh, e, work%d(:, e:e + 1), element, matrix)
         do n = e, e + 1
            matrix%diagonal(5:6, 5:6, n) = matrix%diagonal(5:6, 5:6, n) + director_curvature(mesh%frame(:, :, n), work%d(:, n), &
                                                                                              force(6*(n - e) + 4:6*(n - e) + 6))
         end do
      end do
      call clear_held(mesh%held, matrix)
   end subroutine assemble_compression
end module dg_stability

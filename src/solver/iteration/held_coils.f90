!> Friction that holds a sliding string sideways too, where it drifts (dg_equilibrium).
!>
!> Friction of a sliding string acts along the hole. No force then stops coils from turning round the hole, and a tenth of a
!> newton turns them for ever. Real friction opposes any motion. A contact that slides by v along the hole and by u across it
!> has a friction force of size m R. It acts against both:
!>   F = m R (cos a t - sin a tau),   tan a = u/v,   tau = t x n.
!> A string in equilibrium has no u, but its history is unknown, so that sin a may have any value. It is a state of its own
!> here, zero when the string begins to be held. A step that moves a contact by u changes it by k u/(m R). At a small upper
!> limit of it the contact slips, against a softer spring. A string that goes on moving sideways is thus braked, and one that
!> drifts comes to rest. The spring k is softer than the damping that a stable equilibrium may need, and stability is judged
!> without it. The torque of the sideways force about the string's own axis, some newton metres, is neglected.
module dg_held_coils
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   use dg_element_rows, only: add_dyad, multiply_rows
   use dg_gap_action, only: find_side_row, near
   use dg_gap_state, only: state_free
   use dg_mesh, only: mesh_type
   use dg_solution, only: solution_type
   use dg_tuning, only: tuning_type
   use dg_workspace, only: dof_lateral_1
   implicit none
   private
   public :: holder_type, start_to_hold, find_holding, add_holding, hold_sideways

   type :: holder_type
      logical :: holding = .false.
      integer :: quiet = 0                       !< iterations since many gaps opened, closed or moved
      real(wp), allocatable :: row(:, :)         !< motion along tau by the unknowns of the element's nodes (12,e) [-, m]
      real(wp), allocatable :: stiffness(:)      !< stiffness of the spring, 0 of a gap that is not held (e) [N/m]
      real(wp), allocatable :: before(:)         !< share of friction before the step (e) [-]
   end type holder_type

contains

   !> Begin to hold the string, if it slides without turning.
   pure subroutine start_to_hold(mesh, holder)
      type(mesh_type), intent(in) :: mesh
      type(holder_type), intent(inout) :: holder
      holder%holding = any(abs(mesh%friction_along) > 0.0_wp) .and. .not. any(mesh%friction_around > 0.0_wp)
      if (.not. holder%holding) return
      allocate (holder%row(2*block_size, mesh%elements), holder%stiffness(mesh%elements), holder%before(mesh%elements), &
                source=0.0_wp)
   end subroutine start_to_hold

   !> Compute the springs at the present state, before a step. Where a contact slips its force stays the same, so that its spring
   !> is soft.
   pure subroutine find_holding(tuning, lump, solution, holder)
      type(tuning_type), intent(in) :: tuning
      real(wp), intent(in) :: lump(:, :)         !< diagonal terms of a unit of damping (6,nodes) [N/m, N.m]
      type(solution_type), intent(in) :: solution
      type(holder_type), intent(inout) :: holder
      integer :: e
      holder%before = solution%work%held
      holder%stiffness = 0.0_wp
      associate (mesh => solution%mesh, gaps => solution%gaps, work => solution%work)
         do e = 1, mesh%elements
            if (gaps%state(e) == state_free .or. .not. abs(mesh%friction_along(e)) > 0.0_wp .or. &
                work%displacement(e) < near*gaps%law(e)%clearance) cycle
            call find_side_row(mesh, gaps, e, work, holder%row(:, e))
            holder%stiffness(e) = 0.5_wp*tuning%hold_stiffness*(lump(dof_lateral_1, e) + lump(dof_lateral_1, e + 1))
            if (.not. abs(holder%before(e)) < tuning%most_held) holder%stiffness(e) = tuning%hold_slipping*holder%stiffness(e)
         end do
      end associate
   end subroutine find_holding

   !> Add the springs to a matrix.
   pure subroutine add_holding(holder, matrix)
      type(holder_type), intent(in) :: holder
      type(block_matrix_type), intent(inout) :: matrix
      integer :: e
      do e = 1, size(holder%stiffness)
         if (holder%stiffness(e) > 0.0_wp) call add_dyad(holder%stiffness(e), holder%row(:, e), holder%row(:, e), e, matrix)
      end do
   end subroutine add_holding

   !> Set the shares of friction at the end of equations%step.
   pure subroutine hold_sideways(holder, most, solution)
      type(holder_type), intent(in) :: holder
      real(wp), intent(in) :: most               !< largest share [-]
      type(solution_type), intent(inout) :: solution
      real(wp) :: moved(size(holder%before)), friction
      integer :: e
      call multiply_rows(size(moved), holder%row, solution%equations%step, moved)
      do e = 1, size(moved)
         associate (held => solution%work%held(e))
            friction = abs(solution%mesh%friction_along(e))*solution%loads%friction_scale*solution%work%normal(e)
            held = 0.0_wp
            if (.not. (holder%stiffness(e) > 0.0_wp .and. friction > 0.0_wp)) cycle
            held = max(-most, min(most, holder%before(e) + holder%stiffness(e)*moved(e)/friction))
         end associate
      end do
   end subroutine hold_sideways
end module dg_held_coils

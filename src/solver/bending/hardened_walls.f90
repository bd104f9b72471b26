!> Equilibrium of a bending beam by continuation: walls start soft and are hardened step by step to their own stiffness.
!>
!> Newton's method opens and closes one contact after the other where walls are stiff, and may cycle. Against a soft wall many
!> places touch at once, and the steps are smooth. Each level starts from the shape of the level before.
module dg_hardened_walls
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type
   use dg_bending_solution, only: solve_bending
   use dg_moved_walls, only: firm, soften_walls
   implicit none
   private
   public :: solve_with_hardened_walls

   !> Stiffness of the softest wall [N/m2]: that of a drill collar of ten metres between its contacts.
   real(wp), parameter :: softest = 1.0e4_wp
   !> Factor on the stiffness of the walls from step to step [-].
   real(wp), parameter :: hardening = 10.0_wp
   !> Change of moments over the largest one at which a step with softer walls ends [-].
   real(wp), parameter :: roughly = 0.1_wp

contains

   !> Bend a beam against walls that are hardened to their own stiffness. Arguments are those of solve_bending, except that
   !> `found` is true after any converged step. y is then the equilibrium of the last converged step.
   pure subroutine solve_with_hardened_walls(beam, begin, y, settled, found, anchor, pressed)
      type(bending_beam_type), intent(inout) :: beam     !< on return with walls no stiffer than Newton's steps tolerate
      real(wp), intent(in) :: begin                      !< stiffness of walls that y is an equilibrium against, 0: none [N/m2]
      real(wp), contiguous, intent(inout) :: y(:, :)     !< offsets and slopes (4,n) [m, -]
      real(wp), intent(in) :: settled                    !< change of moments at the end, over the largest [-]
      logical, intent(out) :: found
      real(wp), contiguous, intent(in) :: anchor(:, :)   !< shape to which springs pull compressed parts (4,n) [m, -]
      real(wp), intent(inout) :: pressed(:, :)   !< contact forces at the places of the elements (contact_places,n-1) [N]
      real(wp) :: harder(size(y, 1), size(y, 2)), forces(size(pressed, 1), size(pressed, 2)), stiffness, hardest
      logical :: reached
      found = .false.
      call soften_walls(huge(1.0_wp), firm, beam)
      hardest = maxval(beam%element%press%maximum)
      stiffness = max(softest, hardening*begin)
      harder = y
      do
         call soften_walls(stiffness, firm, beam)
         call solve_bending(beam, harder, merge(roughly, settled, stiffness < hardest), reached, anchor, forces)
         if (reached) then
            found = .true.
            y = harder
            pressed = forces
         end if
         if (.not. stiffness < hardest) exit
         stiffness = hardening*stiffness
      end do
   end subroutine solve_with_hardened_walls
end module dg_hardened_walls

!> Equilibrium of a bending beam by continuation: walls begin soft and are hardened step by step to their own stiffness.
!>
!> Newton's method opens and closes one contact after the other where walls are stiff, and may cycle. Against a soft wall many
!> places touch at once, and the steps are smooth. Each level starts from the shape of the level before.
module dg_hardened_walls
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type
   use dg_bending_solution, only: solve_bending
   use dg_gap_state, only: gap_law_type
   implicit none
   private
   public :: solve_with_hardened_walls

   !> Stiffness of the softest wall [N/m2]: that of a drill collar of ten metres between its contacts.
   real(wp), parameter :: softest = 1.0e4_wp
   !> Stiffness of each wall over that of the wall before [-].
   real(wp), parameter :: hardening = 10.0_wp
   !> Change of moments over the largest one at which a softer wall has done its part [-].
   real(wp), parameter :: roughly = 0.1_wp
   !> Length of a tool joint's contact [m].
   real(wp), parameter :: joint_length = 1.0_wp

contains

   !> Bends a beam against walls that are hardened to their own stiffness. Arguments as those of solve_bending.
   pure subroutine solve_with_hardened_walls(beam, begin, y, settled, found, anchor, pressed)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: begin                      !< stiffness of walls that y is an equilibrium against; 0: none [N/m2]
      real(wp), contiguous, intent(inout) :: y(:, :)     !< offsets and slopes (4,n) [m, -]
      real(wp), intent(in) :: settled                    !< change of moments at the end, over the largest [-]
      logical, intent(out) :: found                      !< equilibrium against the walls' own stiffness
      real(wp), contiguous, intent(in), optional :: anchor(:, :)   !< shape to which springs pull compressed parts (4,n) [m, -]
      real(wp), intent(out), optional :: pressed(:, :)   !< contact forces at the places of the elements (contact_places,n-1) [N]
      type(bending_beam_type) :: softer
      real(wp) :: stiffness
      logical :: reached
      softer = beam
      stiffness = max(softest, hardening*begin)
      do while (stiffness < maxval(beam%element%law%maximum))
         call soften(stiffness, beam%element%law, softer%element%law)
         call soften(joint_length*stiffness, beam%point_law, softer%point_law)
         call solve_bending(softer, y, roughly, reached, anchor)
         stiffness = hardening*stiffness
      end do
      call solve_bending(beam, y, settled, found, anchor, pressed)
   end subroutine solve_with_hardened_walls

   !> A law with no stiffness above the given one.
   elemental subroutine soften(stiffness, law, softer)
      real(wp), intent(in) :: stiffness           !< in the unit of the law [N/m2 or N/m]
      type(gap_law_type), intent(in) :: law
      type(gap_law_type), intent(inout) :: softer
      softer%contact = min(stiffness, law%contact)
      softer%maximum = min(stiffness, law%maximum)
   end subroutine soften
end module dg_hardened_walls

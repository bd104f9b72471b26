!> Walls of a bending beam at their own stiffness, by steps against softer walls.
!>
!> A wall of rock or steel yields by micrometres. Newton's steps against it open and close one contact after the other, and may
!> cycle. They are taken against a wall that is no stiffer than `firm` at each place of contact. Where the string presses it by
!> a force R, the wall is then moved inwards by depth_soft(R) - depth_true(R). The force R is then reached at the true depth,
!> and the beam is solved once more. The remaining error is about the string's stiffness over that of the softened wall. In
!> most strings one repetition is enough. A short stiff blade with a bend needs several, each against a stiffer wall.
!>
!> This is the method of multipliers, with the force R as the multiplier (augmented Lagrangian; Hestenes 1969, Multiplier and
!> gradient methods, J. Optim. Theory Appl. 4, 303-320).
module dg_moved_walls
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, bent_type, find_forces
   use dg_bending_element, only: contact_places
   use dg_gap_state, only: depth_of, gap_law_type
   implicit none
   private
   public :: move_walls, soften_walls, firm, firmer, less_firm

   !> Largest stiffness of a wall at one place of contact that Newton's steps tolerate from any shape [N/m]. Slim strings,
   !> which are a thousand times less stiff than collars, have `less_firm`. Next to an equilibrium walls may be `firmer` times
   !> as stiff [-].
   real(wp), parameter :: firm = 3.0e8_wp, less_firm = 1.0e7_wp, firmer = 3.0_wp
   !> Least clearance over which an error of a wall's place counts [m]: bow springs may touch from the start.
   real(wp), parameter :: least_room = 1.0e-4_wp
   !> Length of a centralizer's contact [m].
   real(wp), parameter :: joint_length = 1.0_wp

contains

   !> Move walls inwards by the excess of their yielding under the contact forces of a given shape. Make them as stiff as
   !> Newton's steps tolerate next to an equilibrium.
   pure subroutine move_walls(at_place, y, beam, missed)
      real(wp), intent(in) :: at_place                  !< stiffness at each place to which they have been softened [N/m]
      real(wp), contiguous, intent(in) :: y(:, :)       !< an equilibrium against them: offsets and slopes (4,n) [m, -]
      type(bending_beam_type), intent(inout) :: beam
      real(wp), intent(out) :: missed                   !< largest distance of a true wall from where it was, over the clearance [-]
      type(bending_beam_type) :: before
      type(bent_type) :: bent
      integer :: e, p
      call find_forces(beam, y, bent)
      before = beam
      missed = 0.0_wp
      call soften_walls(huge(1.0_wp), firmer*at_place, beam)
      do e = 1, size(beam%element)
         associate (law => beam%element(e)%law, now => before%element(e), length => beam%element(e)%length)
            if (.not. now%press%maximum < law%maximum) cycle
            do p = 1, contact_places
               if (.not. bent%pressed(p, e) > 0.0_wp) cycle
               associate (force => contact_places*bent%pressed(p, e)/length)
                  missed = max(missed, abs(yielding(law, now%press, force) - now%moved(p))/max(law%clearance, least_room))
                  beam%element(e)%moved(p) = yielding(law, beam%element(e)%press, force)
               end associate
            end do
         end associate
      end do
      do p = 1, size(beam%point)
         missed = max(missed, abs(yielding(beam%point_law(p), before%point_press(p), bent%points(p)) - before%point_moved(p)) &
                              /max(beam%point_law(p)%clearance, least_room))
         beam%point_moved(p) = yielding(beam%point_law(p), beam%point_press(p), bent%points(p))
      end do
   end subroutine move_walls

   !> Put walls back to their places, no stiffer than given and than Newton's steps tolerate.
   pure subroutine soften_walls(stiffness, at_place, beam)
      real(wp), intent(in) :: stiffness      !< [N/m2]
      real(wp), intent(in) :: at_place       !< at each place of contact [N/m]
      type(bending_beam_type), intent(inout) :: beam
      integer :: e
      do e = 1, size(beam%element)
         associate (element => beam%element(e), most => min(stiffness, contact_places*at_place/beam%element(e)%length))
            element%press = softened(element%law, most)
            element%moved = 0.0_wp
         end associate
      end do
      beam%point_press = softened(beam%point_law, min(joint_length*stiffness, at_place))
      beam%point_moved = spread(0.0_wp, 1, size(beam%point))
   end subroutine soften_walls

   !> Law with no stiffness above a given one.
   elemental function softened(law, most) result(softer)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: most           !< in the unit of the law [N/m2 or N/m]
      type(gap_law_type) :: softer
      softer = law
      softer%contact = min(law%contact, most)
      softer%maximum = min(law%maximum, most)
   end function softened

   !> Excess of a softer wall's yielding to a force [m].
   pure function yielding(law, softer, force) result(more)
      type(gap_law_type), intent(in) :: law, softer
      real(wp), intent(in) :: force          !< in the unit of the laws [N/m or N]
      real(wp) :: more
      more = depth_of(softer, force) - depth_of(law, force)
   end function yielding
end module dg_moved_walls

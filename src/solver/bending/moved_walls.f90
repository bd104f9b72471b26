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
   use dg_bending_beam, only: bending_beam_type, bent_type
   use dg_bending_element, only: beam_element_type, contact_places
   use dg_gap_state, only: depth_of, gap_law_type
   implicit none
   private
   public :: misplacement, move_walls, soften_walls, firm, firmer, less_firm

   !> Largest stiffness of a wall at one place of contact that Newton's steps tolerate from any shape [N/m]. Slim strings,
   !> which are a thousand times less stiff than collars, have `less_firm`. Next to an equilibrium walls may be `firmer` times
   !> as stiff [-].
   real(wp), parameter :: firm = 3.0e8_wp, less_firm = 1.0e7_wp, firmer = 3.0_wp
   !> Least clearance over which an error of a wall's place counts [m]: bow springs may touch from the start.
   real(wp), parameter :: least_room = 1.0e-4_wp
   !> Length of a centralizer's contact [m].
   real(wp), parameter :: joint_length = 1.0_wp

contains

   !> Move walls inwards by the excess of their yielding under the contact forces of an equilibrium against them. Make them as
   !> stiff as Newton's steps tolerate next to it.
   pure subroutine move_walls(at_place, bent, beam)
      real(wp), intent(in) :: at_place              !< stiffness at each place to which they have been softened [N/m]
      type(bent_type), intent(in) :: bent           !< its forces
      type(bending_beam_type), intent(inout) :: beam
      integer :: e, p
      call soften_walls(huge(1.0_wp), firmer*at_place, beam)
      do e = 1, size(beam%element)
         associate (element => beam%element(e))
            do p = 1, contact_places
               if (bent%pressed(p, e) > 0.0_wp) &
                  element%moved(p) = yielding(element%law, element%press, load_of(element, bent%pressed(p, e)))
            end do
         end associate
      end do
      do p = 1, size(beam%point)
         beam%point_moved(p) = yielding(beam%point_law(p), beam%point_press(p), bent%points(p))
      end do
   end subroutine move_walls

   !> Largest distance of a pressed wall from its true place, over the clearance [-].
   pure function misplacement(bent, beam) result(most)
      type(bent_type), intent(in) :: bent           !< forces of an equilibrium against the walls
      type(bending_beam_type), intent(in) :: beam
      real(wp) :: most
      integer :: e, p
      most = 0.0_wp
      do e = 1, size(beam%element)
         associate (element => beam%element(e))
            do p = 1, contact_places
               if (bent%pressed(p, e) > 0.0_wp) most = max(most, abs(element%moved(p) - yielding( &
                  element%law, element%press, load_of(element, bent%pressed(p, e))))/max(element%law%clearance, least_room))
            end do
         end associate
      end do
      do p = 1, size(beam%point)
         most = max(most, abs(beam%point_moved(p) - yielding(beam%point_law(p), beam%point_press(p), bent%points(p))) &
                          /max(beam%point_law(p)%clearance, least_room))
      end do
   end function misplacement

   !> Force per metre of wall at one place of contact of an element [N/m].
   pure function load_of(element, force) result(load)
      type(beam_element_type), intent(in) :: element
      real(wp), intent(in) :: force          !< at that place [N]
      real(wp) :: load
      load = contact_places*force/element%length
   end function load_of

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

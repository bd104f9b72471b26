!> Places where a string that lies on the wall presses it by more than what lies there: where it lifts off, and where a bend
!> begins or ends. The wall takes a force there that in the limit of a hard wall has no length, as the shear force jumps.
module dg_contact_edges
   use dg_kinds, only: wp
   implicit none
   private
   public :: contact_edge_type, find_edges, centroid, moments_of_misplacing

   !> Contact force per metre over what weight and tension in a bend carry to the wall, from which it belongs to an edge [-].
   !> Contact that is spread stays within a few per cent of one. The wall yields, which spreads an edge over some decimetres of
   !> twice to ten times that load.
   real(wp), parameter :: concentrated = 1.5_wp
   !> And down to which stretches beside it belong to it too [-].
   real(wp), parameter :: raised = 1.1_wp
   !> Force of an edge beyond what is spread, over the string's sum of contact, under which it is left out [-]: nobody acts on less,
   !> and the elements' own unevenness makes as much.
   real(wp), parameter :: least_share = 1.0e-3_wp

   !> Moment by which a contact force is missed that is felt at the wrong place of an element, over the change of the force per
   !> metre times the square of the element's length [-].
   real(wp), parameter :: edge_share = 1.0_wp/32.0_wp
   !> The same for a force at one place of an element, over that force times the element's length [-]: the place nearest to the
   !> force is up to 0.29 lengths from it, and between two nodes its peak is cut off by up to an eighth.
   real(wp), parameter :: point_share = 0.4_wp

   type :: contact_edge_type
      real(wp) :: md = 0.0_wp       !< centroid of the force [m]
      real(wp) :: force = 0.0_wp    !< beyond what is spread [N]
      real(wp) :: length = 0.0_wp   !< over which it acts [m]
   end type contact_edge_type

contains

   !> Edges from the top down: runs of stretches of string whose force is more than `raised` times the spread load, somewhere
   !> more than `concentrated` times.
   pure subroutine find_edges(md, length, force, spread_load, total, edges)
      real(wp), intent(in) :: md(:)            !< where the force of each stretch acts, increasing [m]
      real(wp), intent(in) :: length(:)        !< of each stretch [m]
      real(wp), intent(in) :: force(:)         !< of contact, 0 where nothing touches or other contacts stand [N]
      real(wp), intent(in) :: spread_load(:)   !< per length: what weight and bends carry to the wall there [N/m]
      real(wp), intent(in) :: total            !< sum of contact over the string [N]
      type(contact_edge_type), allocatable, intent(out) :: edges(:)
      type(contact_edge_type) :: found(size(md)/2 + 1)
      real(wp) :: beyond(size(md))
      logical :: pressed(size(md))
      integer :: first, last, count
      pressed = force > raised*spread_load*length .and. force > 0.0_wp
      beyond = max(force - spread_load*length, 0.0_wp)
      count = 0
      last = 0
      do
         first = last + findloc(pressed(last + 1:), .true., dim=1)
         if (first == last) exit
         last = first
         do while (last < size(md))
            if (.not. pressed(last + 1)) exit
            last = last + 1
         end do
         if (sum(beyond(first:last)) > least_share*total .and. &
             any(force(first:last) > concentrated*spread_load(first:last)*length(first:last))) then
            count = count + 1
            found(count)%force = sum(beyond(first:last))
            found(count)%length = sum(length(first:last))
            found(count)%md = centroid(md(first:last), beyond(first:last))
         end if
         if (last == size(md)) exit
      end do
      edges = found(:count)
   end subroutine find_edges

   !> Where the sum of forces acts; the middle of their places where there are none.
   pure function centroid(md, force) result(place)
      real(wp), intent(in) :: md(:), force(:)   !< [m, N]
      real(wp) :: place
      if (sum(force) > 0.0_wp) then
         place = sum(md*force)/sum(force)
      else
         place = 0.5_wp*(md(1) + md(size(md)))
      end if
   end function centroid

   !> Moments at the nodes of a beam that may be missed as contact begins, ends or has its peak within an element (n) [N.m]. A
   !> force that is felt a part of an element away from its place makes a moment.
   pure function moments_of_misplacing(length, pressed) result(moments)
      real(wp), intent(in) :: length(:)       !< of the elements (n-1) [m]
      real(wp), intent(in) :: pressed(:, :)   !< contact forces at both places of each element (2,n-1) [N]
      real(wp) :: moments(size(length) + 1)
      real(wp) :: load(0:2*size(length) + 1), carried
      integer :: e, p, k
      load = 0.0_wp      ! beyond the ends, too
      do e = 1, size(length)
         load(2*e - 1:2*e) = 2.0_wp*pressed(:, e)/length(e)      ! per metre
      end do
      moments = 0.0_wp
      do e = 1, size(length)
         do p = 1, 2
            k = 2*(e - 1) + p
            moments(e:e + 1) = max(moments(e:e + 1), abs(load(2*e) - load(2*e - 1))*length(e)**2*edge_share, &
                                   0.5_wp*(load(k) - max(load(k - 1), load(k + 1)))*length(e)**2*point_share)
         end do
      end do
      do e = 1, size(length) - 1      ! and between two elements, of what the one pressed more carries
         carried = abs(load(2*e + 1) - load(2*e))*merge(length(e + 1), length(e), load(2*e + 1) > load(2*e))
         moments(e + 1) = max(moments(e + 1), carried*maxval(length(e:e + 1))*edge_share)
      end do
   end function moments_of_misplacing
end module dg_contact_edges

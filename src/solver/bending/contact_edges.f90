!> Edges of contact: places where a string on the wall presses it by more than its spread load. They are where it leaves the
!> wall, and where a bend begins or ends. In the limit of a hard wall the force there has no length, as the shear force jumps.
module dg_contact_edges
   use dg_kinds, only: wp
   implicit none
   private
   public :: contact_edge_type, find_edges, centroid, moments_of_misplacing

   !> Least contact force of an edge per metre, over the load of weight and of tension in a bend [-]. Spread contact is within
   !> a few per cent of one. The wall yields, which spreads an edge over some decimetres with twice to ten times that load.
   real(wp), parameter :: concentrated = 1.5_wp
   !> The same for neighbouring lengths that belong to the edge too [-].
   real(wp), parameter :: raised = 1.1_wp
   !> Least force of an edge beyond the spread load, over the string's sum of contact [-]. Smaller edges do not matter, and
   !> uneven elements make as much.
   real(wp), parameter :: least_share = 1.0e-3_wp

   !> Error of a moment by a contact force at the wrong place of an element [-]. It is over the change of the force per metre
   !> times the square of the element's length.
   real(wp), parameter :: edge_share = 1.0_wp/32.0_wp
   !> The same for a force at one place of an element, over that force times the element's length [-]. The place nearest to the
   !> force is up to 0.29 lengths from it. Between two nodes the moment's peak is cut off by up to an eighth.
   real(wp), parameter :: point_share = 0.4_wp

   type :: contact_edge_type
      real(wp) :: md = 0.0_wp       !< centroid of the force [m]
      real(wp) :: force = 0.0_wp    !< beyond the spread load [N]
      real(wp) :: length = 0.0_wp   !< length over which it acts [m]
   end type contact_edge_type

contains

   !> Edges from the top down. An edge is a run of lengths whose force is more than `raised` times the spread load, and
   !> somewhere more than `concentrated` times.
   pure subroutine find_edges(md, length, force, spread_load, total, edges)
      real(wp), intent(in) :: md(:)            !< place of each force, increasing [m]
      real(wp), intent(in) :: length(:)        !< length over which each force acts [m]
      real(wp), intent(in) :: force(:)         !< contact force, 0 without contact or at other kinds of contact [N]
      real(wp), intent(in) :: spread_load(:)   !< load per metre of weight and bends on the wall [N/m]
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

   !> Centroid of forces; the middle of their places if all are zero [m].
   pure function centroid(md, force) result(place)
      real(wp), intent(in) :: md(:), force(:)   !< [m, N]
      real(wp) :: place
      if (sum(force) > 0.0_wp) then
         place = sum(md*force)/sum(force)
      else
         place = 0.5_wp*(md(1) + md(size(md)))
      end if
   end function centroid

   !> Errors of the moments at the nodes of a beam where contact begins, ends or has its peak within an element (n) [N.m]. A
   !> force at the wrong place of an element makes a moment.
   pure function moments_of_misplacing(length, pressed) result(moments)
      real(wp), intent(in) :: length(:)       !< of the elements (n-1) [m]
      real(wp), intent(in) :: pressed(:, :)   !< contact forces at both places of each element (2,n-1) [N]
      real(wp) :: moments(size(length) + 1)
      real(wp) :: load(0:2*size(length) + 1), carried
      integer :: e, p, k
      load = 0.0_wp      ! 0 beyond both ends
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
      do e = 1, size(length) - 1      ! between two elements: the load of the one that is pressed more
         carried = abs(load(2*e + 1) - load(2*e))*merge(length(e + 1), length(e), load(2*e + 1) > load(2*e))
         moments(e + 1) = max(moments(e + 1), carried*maxval(length(e:e + 1))*edge_share)
      end do
   end function moments_of_misplacing
end module dg_contact_edges

!> Fronts of release: where a string leaves the wall gap by gap.
!>
!> A string lighter on the wall than it was taken to be lifts off from the edge of its contact: the outermost gap pulls instead
!> of pushing, opens, and only then does the next one pull. Where elements are longer than sqrt(EI/T), over which bending
!> fades, each iteration opens one gap, and a mesh of so many elements takes as many iterations. A front that has gone on for
!> some of them, while nothing else changes, is let run ahead, twice as far each time; what opened too far closes again at once.
module dg_release_front
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type
   implicit none
   private
   public :: release_front_type, new_release_front, forget_fronts, release_ahead

   !> Gaps next to each other opened in as many iterations that make a front; the doublings of its run-ahead are bounded.
   integer, parameter :: steady = 5, most_doublings = 5
   !> Gaps changing in one iteration, more of which are no fronts but the string still finding its place.
   integer, parameter :: most_fronts = 2

   !> What is kept from iteration to iteration.
   type :: release_front_type
      integer, allocatable :: before(:)          !< states of the gaps before they are judged (elements)
      logical, allocatable :: tried(:)           !< opened ahead once: not again, lest a front run to and fro (elements)
      integer :: number = 0                      !< of fronts
      integer :: at(most_fronts) = 0             !< gap that each has reached
      integer :: way(most_fronts) = 0            !< 1 or -1 along the elements, 0 where it has just begun
      integer :: steps(most_fronts) = 0          !< iterations that it has gone on
   end type release_front_type

contains

   !> Room for so many gaps.
   pure subroutine new_release_front(elements, front)
      integer, intent(in) :: elements
      type(release_front_type), intent(out) :: front
      allocate (front%before(elements), source=state_free)
      allocate (front%tried(elements), source=.false.)
   end subroutine new_release_front

   !> Begins anew, for another wall or load.
   pure subroutine forget_fronts(front)
      type(release_front_type), intent(inout) :: front
      front%number = 0
      front%tried = .false.
   end subroutine forget_fronts

   !> Opens gaps ahead of fronts. `front%before` holds the states before the gaps were judged, with `flips` changes.
   pure subroutine release_ahead(front, flips, gaps, opened)
      type(release_front_type), intent(inout) :: front
      integer, intent(in) :: flips
      type(gap_table_type), intent(inout) :: gaps
      integer, intent(out) :: opened             !< gaps opened here
      integer :: at(most_fronts), way(most_fronts), steps(most_fronts), number, e, f, ahead
      opened = 0
      number = 0
      if (flips >= 1 .and. flips <= most_fronts) then
         do e = 1, size(gaps%state)
            if (front%before(e) == state_free .or. gaps%state(e) /= state_free) cycle
            number = number + 1
            at(number) = e
            way(number) = 0
            steps(number) = 1
            do f = 1, front%number
               if (abs(e - front%at(f)) /= 1 .or. front%way(f) == front%at(f) - e) cycle
               way(number) = e - front%at(f)
               steps(number) = front%steps(f) + 1
            end do
         end do
      end if
      do f = 1, number
         if (steps(f) <= steady) cycle
         do ahead = 1, 2**min(steps(f) - steady, most_doublings)
            e = at(f) + way(f)
            if (e < 1 .or. e > size(gaps%state)) exit
            if (gaps%state(e) == state_free .or. front%tried(e)) exit
            front%tried(e) = .true.
            gaps%state(e) = state_free
            gaps%flips(e) = gaps%flips(e) + 1
            opened = opened + 1
            at(f) = e
         end do
      end do
      front%number = number
      front%at = at
      front%way = way
      front%steps = steps
   end subroutine release_ahead
end module dg_release_front

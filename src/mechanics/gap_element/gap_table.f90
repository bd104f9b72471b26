!> The state table: one MCGE an element, its place, its state, and every flip recorded.
module dg_gap_table
   use dg_kinds, only: wp
   use dg_gap_state, only: gap_law_type, gap_thresholds_type, state_free
   implicit none
   private
   public :: gap_table_type, new_gap_table, fix_gap, gain_to_move, move_gap, lone_contacts, count_states, keep_gaps, take_gaps_back

   type :: gap_table_type
      type(gap_law_type), allocatable :: law(:)  !< of each element's gap
      type(gap_thresholds_type) :: thresholds    !< of all
      real(wp), allocatable :: xi(:)             !< place x0/L [-]
      integer, allocatable :: state(:)           !< state_free, state_elastic, state_rigid
      logical, allocatable :: followed(:)        !< its place follows the extremum within the iteration
      logical, allocatable :: fixed(:)           !< it stays at its place
      integer, allocatable :: flips(:)           !< changes of state so far
      integer, allocatable :: moves(:)           !< times moved, or begun to follow, so far
   end type gap_table_type

   !> A gap that keeps moving between two places that are as good is held by a threshold that grows with its moves;
   !> this bounds the growth (2**20 times the threshold is far beyond any clearance).
   integer, parameter :: most_doublings = 20

   !> Closed gaps next to each other that are still one contact: two gaps may meet at a node.
   integer, parameter :: most_lone = 2

contains

   !> A table of free gaps at xi = `place`.
   pure function new_gap_table(laws, place) result(table)
      type(gap_law_type), intent(in) :: laws(:)
      real(wp), intent(in) :: place
      type(gap_table_type) :: table
      integer :: n
      n = size(laws)
      allocate (table%law, source=laws)
      allocate (table%xi(n), source=place)
      allocate (table%state(n), source=state_free)
      allocate (table%followed(n), table%fixed(n), source=.false.)
      allocate (table%flips(n), table%moves(n), source=0)
   end function new_gap_table

   !> Remembers places, states and their counts; laws stay with the table.
   pure subroutine keep_gaps(table, kept)
      type(gap_table_type), intent(in) :: table
      type(gap_table_type), intent(inout) :: kept
      kept%xi = table%xi
      kept%state = table%state
      kept%flips = table%flips
      kept%moves = table%moves
      kept%followed = table%followed
   end subroutine keep_gaps

   !> Puts the gaps back to what keep_gaps remembered.
   pure subroutine take_gaps_back(kept, table)
      type(gap_table_type), intent(in) :: kept
      type(gap_table_type), intent(inout) :: table
      table%xi = kept%xi
      table%state = kept%state
      table%flips = kept%flips
      table%moves = kept%moves
      table%followed = kept%followed
   end subroutine take_gaps_back

   !> Moves a gap to the extremum x0 = xi L (Eq. 2) where the string is so much deeper there as gain_to_move asks for.
   pure subroutine move_gap(table, e, xi, at_extremum, at_gap, threshold, moved)
      type(gap_table_type), intent(inout) :: table
      integer, intent(in) :: e
      real(wp), intent(in) :: xi            !< of the extremum
      real(wp), intent(in) :: at_extremum   !< |f| there [m]
      real(wp), intent(in) :: at_gap        !< |f| at the present place [m]
      real(wp), intent(in) :: threshold     !< [m]
      logical, intent(out) :: moved
      moved = at_extremum - at_gap > gain_to_move(table, e, threshold) .and. .not. table%fixed(e)
      if (.not. moved) return
      table%xi(e) = xi
      table%moves(e) = table%moves(e) + 1
   end subroutine move_gap

   !> Puts a gap at a place where it stays.
   pure subroutine fix_gap(table, e, xi, state)
      type(gap_table_type), intent(inout) :: table
      integer, intent(in) :: e
      real(wp), intent(in) :: xi            !< place x0/L [-]
      integer, intent(in) :: state
      table%xi(e) = xi
      table%state(e) = state
      table%fixed(e) = .true.
   end subroutine fix_gap

   !> Gain in depth at the extremum above which a gap moves there [m]. The paper puts x0 where the element "is to make first
   !> contact": a free gap goes to the extremum at once the first time, a closed one only when the string is deeper there by
   !> `threshold`. The threshold doubles with every move made, free or closed: an element that wants contact at two places would
   !> otherwise hand its one gap to and fro for ever.
   pure function gain_to_move(table, e, threshold) result(gain)
      type(gap_table_type), intent(in) :: table
      integer, intent(in) :: e
      real(wp), intent(in) :: threshold     !< [m]
      real(wp) :: gain
      real(wp) :: least
      least = 2.0_wp**min(table%moves(e), most_doublings)
      if (table%state(e) == state_free) least = least - 1.0_wp
      gain = least*threshold
   end function gain_to_move

   !> Gaps whose contacts stand by themselves, and the open ones next to them: one gap or two next to each other, open ones beyond.
   !> Where a string lies on the wall its gaps share the load, and where in its element each of them sits makes no difference that
   !> the mesh could show; to move one wakes its neighbours. Where it touches at one place, at a stabilizer or in a sharp bend, that
   !> gap carries all of the load between two spans, and its place rules how the spans bend.
   pure function lone_contacts(state) result(lone)
      integer, intent(in) :: state(:)   !< of the gaps
      logical :: lone(size(state))
      integer :: e, first
      lone = .false.
      first = 0                         ! of a run of closed gaps
      do e = 1, size(state) + 1
         if (e <= size(state)) then
            if (state(e) /= state_free) then
               if (first == 0) first = e
               cycle
            end if
         end if
         if (first > 0 .and. e - first <= most_lone) lone(max(first - 1, 1):min(e, size(state))) = .true.
         first = 0
      end do
   end function lone_contacts

   !> Number of gaps in each state, 0:2.
   pure function count_states(table) result(number)
      type(gap_table_type), intent(in) :: table
      integer :: number(0:2)
      integer :: i
      do i = 0, 2
         number(i) = count(table%state == i)
      end do
   end function count_states
end module dg_gap_table

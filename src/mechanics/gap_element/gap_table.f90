!> State table: one MCGE an element, with its place, its state, and the number of its changes.
module dg_gap_table
   use dg_kinds, only: wp
   use dg_gap_state, only: gap_law_type, gap_thresholds_type, state_free
   implicit none
   private
   public :: gap_table_type, new_gap_table, fix_gap, gain_to_move, move_gap, lone_contacts, count_states, keep_gaps, &
             restore_gap_table

   type :: gap_table_type
      type(gap_law_type), allocatable :: law(:)  !< of each element's gap
      type(gap_thresholds_type) :: thresholds    !< of all
      real(wp), allocatable :: xi(:)             !< place x0/L [-]
      integer, allocatable :: state(:)           !< state_free, state_elastic, state_rigid
      logical, allocatable :: followed(:)        !< its place follows the extremum within the iteration
      logical, allocatable :: fixed(:)           !< it stays at its place
      integer, allocatable :: flips(:)           !< changes of state so far
      integer, allocatable :: moves(:)           !< number of moves, and of times it began to follow
   end type gap_table_type

   !> Limit of the growth of a threshold by moves. The threshold of a gap that keeps moving between two equally good places
   !> grows with its moves. 2**20 times the threshold is far beyond any clearance.
   integer, parameter :: most_doublings = 20

   !> Most closed gaps next to each other that are still one contact: two gaps may meet at a node.
   integer, parameter :: most_lone = 2

contains

   !> Make a table of free gaps at xi = `place`.
   pure function new_gap_table(laws, place) result(table)
      type(gap_law_type), intent(in) :: laws(:)
      real(wp), intent(in) :: place   !< x0/L [-]
      type(gap_table_type) :: table
      integer :: n
      n = size(laws)
      allocate (table%law, source=laws)
      allocate (table%xi(n), source=place)
      allocate (table%state(n), source=state_free)
      allocate (table%followed(n), table%fixed(n), source=.false.)
      allocate (table%flips(n), table%moves(n), source=0)
   end function new_gap_table

   !> Save places, states and their counts. Laws stay with the table.
   pure subroutine keep_gaps(table, kept)
      type(gap_table_type), intent(in) :: table
      type(gap_table_type), intent(inout) :: kept
      kept%xi = table%xi
      kept%state = table%state
      kept%flips = table%flips
      kept%moves = table%moves
      kept%followed = table%followed
   end subroutine keep_gaps

   !> Restore what keep_gaps saved.
   pure subroutine restore_gap_table(kept, table)
      type(gap_table_type), intent(in) :: kept
      type(gap_table_type), intent(inout) :: table
      table%xi = kept%xi
      table%state = kept%state
      table%flips = kept%flips
      table%moves = kept%moves
      table%followed = kept%followed
   end subroutine restore_gap_table

   !> Move a gap to the extremum x0 = xi L (Eq. 2) if the string is deeper there by more than gain_to_move.
   pure subroutine move_gap(table, e, xi, at_extremum, at_gap, threshold, moved)
      type(gap_table_type), intent(inout) :: table
      integer, intent(in) :: e
      real(wp), intent(in) :: xi            !< of the extremum [-]
      real(wp), intent(in) :: at_extremum   !< |f| there [m]
      real(wp), intent(in) :: at_gap        !< |f| at the present place [m]
      real(wp), intent(in) :: threshold     !< [m]
      logical, intent(out) :: moved
      moved = at_extremum - at_gap > gain_to_move(table, e, threshold) .and. .not. table%fixed(e)
      if (.not. moved) return
      table%xi(e) = xi
      table%moves(e) = table%moves(e) + 1
   end subroutine move_gap

   !> Put a gap at a place where it stays.
   pure subroutine fix_gap(table, e, xi, state)
      type(gap_table_type), intent(inout) :: table
      integer, intent(in) :: e
      real(wp), intent(in) :: xi            !< place x0/L [-]
      integer, intent(in) :: state
      table%xi(e) = xi
      table%state(e) = state
      table%fixed(e) = .true.
   end subroutine fix_gap

   !> Least gain in depth at the extremum for which a gap moves there [m]. The paper puts x0 where the element "is to make
   !> first contact". A free gap goes to the extremum at once the first time. A closed one goes only when the string is deeper
   !> there by `threshold`. The threshold doubles with every move, free or closed. Otherwise an element with contact at two
   !> places would move its one gap back and forth for ever.
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

   !> True for gaps of single contacts, and the open ones next to them. A single contact is one closed gap, or two next to each
   !> other, with open ones beyond. Where a string lies on the wall its gaps share the load. The place of each in its element
   !> then makes no visible difference, and to move one disturbs its neighbours. At a stabilizer or in a sharp bend one gap
   !> carries all of the load between two spans. Its place then determines how the spans bend.
   pure function lone_contacts(state) result(lone)
      integer, intent(in) :: state(:)   !< states of the gaps
      logical :: lone(size(state))
      integer :: e, first
      lone = .false.
      first = 0                         ! first of a run of closed gaps
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

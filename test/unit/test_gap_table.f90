!> The state table: counting, and the rule by which a gap moves.
module dg_test_gap_table
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_gap_state, only: gap_law_type, state_elastic, state_free, state_rigid
   use dg_gap_table, only: count_states, gap_table_type, lone_contacts, move_gap, new_gap_table
   use dg_kinds, only: wp
   implicit none
   private
   public :: gap_table_suite

   type(gap_law_type), parameter :: law = gap_law_type(clearance=0.05_wp, contact=1.0e6_wp, maximum=1.0e7_wp, &
                                                       eps_nmax=0.1_wp)

contains

   function gap_table_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('gap_table')
      call suite%addTest(TestMethod('lone_contacts', test_lone_contacts))
      call suite%addTest(TestMethod('count', test_count))
      call suite%addTest(TestMethod('move_rule', test_move_rule))
      call suite%addTest(TestMethod('moves_end', test_moves_end))
   end function gap_table_suite

   subroutine test_count()
      type(gap_table_type) :: table
      table = new_gap_table([law, law, law, law], 0.5_wp)
      call assertEqual([4, 0, 0], count_states(table), message='free at first')
      table%state = [state_free, state_elastic, state_rigid, state_free]
      call assertEqual([2, 1, 1], count_states(table))
   end subroutine test_count

   !> A free gap goes at once the first time; a closed one when it gains `threshold`; either needs twice as
   !> much with every move made: least gain / threshold = 2**moves, less one while free.
   subroutine test_move_rule()
      type(gap_table_type) :: table
      logical :: moved
      real(wp), parameter :: unit = 0.5_wp*law%clearance
      table = new_gap_table([law], 0.5_wp)
      call move_gap(table, 1, 0.2_wp, 0.05_wp, 0.05_wp, unit, moved)
      call assertFalse(moved, message='no gain')
      call move_gap(table, 1, 0.2_wp, 0.051_wp, 0.05_wp, unit, moved)
      call assertTrue(moved, message='free: any gain')
      call assertEqual(0.2_wp, table%xi(1))
      call assertEqual(1, table%moves(1))
      call move_gap(table, 1, 0.3_wp, 0.05_wp + 0.99_wp*unit, 0.05_wp, unit, moved)
      call assertFalse(moved, message='free, second time, below one unit')
      table%state(1) = state_elastic
      call move_gap(table, 1, 0.3_wp, 0.05_wp + 1.99_wp*unit, 0.05_wp, unit, moved)
      call assertFalse(moved, message='closed, second time, below two units')
      call move_gap(table, 1, 0.3_wp, 0.05_wp + 2.01_wp*unit, 0.05_wp, unit, moved)
      call assertTrue(moved, message='closed, second time, above two units')
      call move_gap(table, 1, 0.4_wp, 0.05_wp + 3.99_wp*unit, 0.05_wp, unit, moved)
      call assertFalse(moved, message='closed, third time, below four units')
   end subroutine test_move_rule

   !> However long a gap is pulled to and fro between two places, its moves stay few.
   subroutine test_moves_end()
      type(gap_table_type) :: table
      logical :: moved
      integer :: i
      table = new_gap_table([law], 0.5_wp)
      table%state(1) = state_elastic
      do i = 1, 1000
         call move_gap(table, 1, 0.1_wp*modulo(i, 2), 0.10_wp, 0.05_wp, 0.1_wp*law%clearance, moved)
      end do
      ! 2**n 0.1 c < c for n = 0 to 3
      call assertEqual(4, table%moves(1))
   end subroutine test_moves_end

   !> 1 and 2 are closed. Three closed gaps in a row are a string that lies on the wall.
   subroutine test_lone_contacts()
      logical, parameter :: t = .true., f = .false.
      call assertTrue(all(lone_contacts([1, 1, 1, 1, 1, 0, 0, 1, 1, 0]) .eqv. [f, f, f, f, f, f, t, t, t, t]), &
                      message='a stabilizer below a string that lies')
      call assertTrue(all(lone_contacts([1, 0, 0, 1, 1, 2, 1, 0, 0]) .eqv. [t, t, f, f, f, f, f, f, f]), message='one at the top')
      call assertTrue(.not. any(lone_contacts([1, 1, 1, 1])), message='none')
      call assertTrue(all(lone_contacts([0, 1, 0, 1, 1, 0])), message='none lies')
      call assertTrue(.not. any(lone_contacts([0, 0])), message='nothing touches')
      call assertTrue(all(lone_contacts([0, 0, 1, 0, 0]) .eqv. [f, t, t, t, f]), message='and its neighbours')
   end subroutine test_lone_contacts
end module dg_test_gap_table

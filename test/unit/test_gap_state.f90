!> Every row of the state table (Eqs. 7 and 8), and the force law of Fig. 2.
module dg_test_gap_state
   use funit, only: assertEqual, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_gap_state, only: contact_force, depth_of, gap_law_type, gap_thresholds_type, next_state
   use dg_kinds, only: wp
   use dg_named_states, only: state_elastic, state_free, state_name, state_rigid
   implicit none
   private
   public :: gap_state_suite

   type(gap_law_type), parameter :: law = gap_law_type(clearance=0.05_wp, contact=1.0e6_wp, maximum=1.0e7_wp, eps_nmax=0.05_wp)
   !> c = 0.05 m; the force threshold is reached at 1e-6 m = 2e-5 c, so eps_n0 = 1e-4 decides here ...
   type(gap_thresholds_type), parameter :: by_compression = gap_thresholds_type(eps_n0=1.0e-4_wp, r_n0=1.0_wp)
   !> ... and r_n0, reached at 1e-4 m = 2e-3 c, here.
   type(gap_thresholds_type), parameter :: by_force = gap_thresholds_type(eps_n0=1.0e-4_wp, r_n0=100.0_wp)
   integer, parameter :: f = state_free, e = state_elastic, r = state_rigid

contains

   function gap_state_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('gap_state')
      call suite%addTest(TestMethod('table_by_compression', test_table_by_compression))
      call suite%addTest(TestMethod('table_by_force', test_table_by_force))
      call suite%addTest(TestMethod('no_thresholds', test_no_thresholds))
      call suite%addTest(TestMethod('by_contact_force', test_by_contact_force))
      call suite%addTest(TestMethod('softness', test_softness))
      call suite%addTest(TestMethod('settled', test_settled))
      call suite%addTest(TestMethod('force_is_continuous', test_force_is_continuous))
      call suite%addTest(TestMethod('names', test_names))
   end function gap_state_suite

   !> Columns: eps - 1 where no force presses yet; then the state that follows free and elastic.
   subroutine check_depths(thresholds, compression, from_free, from_elastic)
      type(gap_thresholds_type), intent(in) :: thresholds
      real(wp), intent(in) :: compression(:)
      integer, intent(in) :: from_free(:), from_elastic(:)
      real(wp) :: deep
      integer :: i
      do i = 1, size(compression)
         deep = law%clearance*compression(i)
         call assertEqual(from_free(i), next_state(law, thresholds, state_free, 0.0_wp, deep, law%contact), message='from free')
         call assertEqual(from_elastic(i), next_state(law, thresholds, state_elastic, 0.0_wp, deep, law%contact), &
                          message='from elastic')
      end do
   end subroutine check_depths

   subroutine test_table_by_compression()
      call check_depths(by_compression, &
         [-1.0_wp, -2.0e-4_wp, -0.9e-4_wp, -1.0e-6_wp, 1.0e-6_wp, 0.9e-4_wp, 2.0e-4_wp, 0.049_wp, 3.0_wp], &
         [f, f, f, f, f, f, e, e, e], &
         [f, f, e, e, e, e, e, e, e])
   end subroutine test_table_by_compression

   subroutine test_table_by_force()
      call check_depths(by_force, &
         [-1.0_wp, -2.1e-3_wp, -1.9e-3_wp, -2.0e-4_wp, 0.0_wp, 2.0e-4_wp, 1.9e-3_wp, 2.1e-3_wp], &
         [f, f, f, f, f, f, f, e], &
         [f, f, e, e, e, e, e, e])
   end subroutine test_table_by_force

   !> With both thresholds zero the sign of the compression decides, but for the point itself, which stays.
   subroutine test_no_thresholds()
      call check_depths(gap_thresholds_type(), [-1.0e-12_wp, 0.0_wp, 1.0e-12_wp], [f, f, e], [f, e, e])
   end subroutine test_no_thresholds

   !> A closed gap whose force and depth belong together goes by its force: it opens where it pulls beyond r_n0, is elastic up to
   !> Gkc c eps_nmax = 2500 N and rigid beyond.
   subroutine test_by_contact_force()
      real(wp), parameter :: force(6) = [-1.0e3_wp, -101.0_wp, -99.0_wp, 0.0_wp, 2499.0_wp, 2501.0_wp]
      integer, parameter :: follows(6) = [f, f, e, e, e, r]
      integer :: i, state
      do i = 1, size(force)
         do state = state_elastic, state_rigid
            call assertEqual(follows(i), next_state(law, by_force, state, force(i), 0.0_wp, law%contact))
         end do
      end do
   end subroutine test_by_contact_force

   !> A gap that presses does not open where it stands open by less than its force closes at the softness that it is judged by:
   !> 2000 N at 2e6 N/m is 1 mm.
   subroutine test_softness()
      call assertEqual(e, next_state(law, by_force, e, 2000.0_wp, -0.9e-3_wp, 2.0e6_wp))
      call assertEqual(f, next_state(law, by_force, e, 2000.0_wp, -1.1e-3_wp, 2.0e6_wp))
      call assertEqual(e, next_state(law, by_force, e, 2000.0_wp, -1.1e-3_wp, 1.0e5_wp))
   end subroutine test_softness

   !> A second judgement with the force that belongs to the first one's state changes nothing: no state takes turns with another.
   subroutine test_settled()
      integer :: i, state, next, again
      real(wp) :: force, stiffness, displacement
      do i = -60, 60
         displacement = law%clearance*(1.0_wp + 1.0e-3_wp*i)
         do state = state_free, state_elastic
            call contact_force(law, state, displacement, force, stiffness)
            next = next_state(law, by_force, state, force, displacement - depth_of(law, max(force, 0.0_wp)), law%contact)
            call contact_force(law, next, displacement, force, stiffness)
            again = next_state(law, by_force, next, force, displacement - depth_of(law, max(force, 0.0_wp)), law%contact)
            if (state == state_elastic .or. i < 50) call assertEqual(next, again)     ! a free gap is elastic before it is rigid
         end do
      end do
   end subroutine test_settled

   !> Fig. 2: zero, then Gkc, then Gkmax, without a step where they join; the force is the integral of the rigidity.
   subroutine test_force_is_continuous()
      real(wp) :: force, stiffness, other, edge
      call contact_force(law, state_free, 0.03_wp, force, stiffness)
      call assertEqual(0.0_wp, force, message='free')
      call assertEqual(0.0_wp, stiffness, message='free: gk_min is the solution''s, not the force''s')
      call contact_force(law, state_elastic, law%clearance, force, stiffness)
      call assertEqual(0.0_wp, force, message='touching')
      call contact_force(law, state_elastic, law%clearance + 1.0e-3_wp, force, stiffness)
      call assertEqual(1000.0_wp, force, 1.0e-9_wp, message='elastic, 1 mm')
      call assertEqual(law%contact, stiffness)
      edge = law%clearance*(1.0_wp + law%eps_nmax)
      call contact_force(law, state_elastic, edge, force, stiffness)
      call contact_force(law, state_rigid, edge, other, stiffness)
      call assertEqual(force, other, 1.0e-9_wp, message='where elastic turns to rigid')
      call assertEqual(law%maximum, stiffness)
      call contact_force(law, state_rigid, edge + 1.0e-3_wp, other, stiffness)
      call assertEqual(force + 1.0e4_wp, other, 1.0e-8_wp, message='rigid, 1 mm further')
      call assertGreaterThan(force, 0.0_wp)
   end subroutine test_force_is_continuous

   subroutine test_names()
      call assertTrue(state_name(state_free) == 'free' .and. state_name(state_elastic) == 'elastic' &
                      .and. state_name(state_rigid) == 'rigid')
   end subroutine test_names
end module dg_test_gap_state

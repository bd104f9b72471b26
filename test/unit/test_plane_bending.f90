!> A beam that stays in a plane, bent in that plane and bent in space.
module dg_test_plane_bending
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_bending_beam, only: bending_beam_type, set_elements
   use dg_bending_element, only: contact_places
   use dg_moved_walls, only: soften_walls
   use dg_bending_solution, only: solve_bending
   use dg_gap_state, only: gap_law_type
   use dg_kinds, only: wp
   implicit none
   private
   public :: plane_bending_suite

   !> The plane's direction on n_1 and n_2.
   real(wp), parameter :: lateral(2) = [0.6_wp, -0.8_wp]
   real(wp), parameter :: settled = 1.0e-9_wp, close = 1.0e-9_wp

contains

   function plane_bending_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('plane_bending')
      call suite%addTest(TestMethod('pulled', test_pulled))
      call suite%addTest(TestMethod('compressed', test_compressed))
      call suite%addTest(TestMethod('held_ends', test_held))
      call suite%addTest(TestMethod('no_solution', test_none))
   end function plane_bending_suite

   !> A string of n nodes, 6 m apart, that lies in a bend with friction along the hole. A joint touches at the ninth node.
   pure function string_of(n, tension) result(beam)
      integer, intent(in) :: n
      real(wp), intent(in) :: tension     !< at the upper end, half of it at the lower one [N]
      type(bending_beam_type) :: beam
      integer :: e
      beam%md = [(6.0_wp*(e - 1), e=1, n)]
      beam%place = beam%md
      beam%axial = [(tension*(1.0_wp - 0.5_wp*(e - 1)/(n - 1)), e=1, n)]
      allocate (beam%down(2, n), beam%curvature(2, n - 1), beam%bend(2, n - 1))
      allocate (beam%viscous(n), source=2.0e4_wp)
      allocate (beam%held(n), beam%centred(n), source=.false.)
      allocate (beam%torque(n - 1), source=0.0_wp)
      allocate (beam%weight(n - 1), source=300.0_wp)
      allocate (beam%ei(n - 1), source=1.5e6_wp)
      allocate (beam%element(n - 1))
      beam%owner = [(e, e=1, n - 1)]
      beam%bend = 0.0_wp
      do e = 1, n
         beam%down(:, e) = 0.8_wp*lateral
         if (e < n) beam%curvature(:, e) = merge(1.0e-3_wp, -2.0e-4_wp, e < 14)*lateral
      end do
      beam%element%law = gap_law_type(clearance=0.04_wp, contact=1.0e7_wp, maximum=1.0e8_wp, eps_nmax=0.01_wp)
      beam%element%lever = 0.03_wp
      beam%element(9)%law%clearance = 1.0e6_wp
      beam%point = [9]
      beam%point_owner = [9]
      beam%point_law = [gap_law_type(clearance=0.03_wp, contact=1.0e8_wp, maximum=1.0e8_wp, eps_nmax=1.0_wp)]
      call set_elements(beam)
      call soften_walls(1.0e20_wp, 1.0e20_wp, beam)
   end function string_of

   !> Bends both ways from a line along the wall. Offsets may differ by a part of the largest, contact forces by one of theirs.
   subroutine compare(beam, anchored, name)
      type(bending_beam_type), intent(inout) :: beam
      logical, intent(in) :: anchored
      character(*), intent(in) :: name
      real(wp), dimension(4, size(beam%md)) :: in_space, in_plane, anchor
      real(wp), dimension(contact_places, size(beam%ei)) :: space_force, plane_force
      logical :: found
      in_space = 0.0_wp
      in_space(1:2, :) = spread(0.04_wp*lateral, 2, size(beam%md))
      in_plane = in_space
      anchor = 0.0_wp
      anchor(1:2, :) = spread(0.02_wp*lateral, 2, size(beam%md))
      beam%lateral = 0.0_wp
      if (anchored) then
         call solve_bending(beam, in_space, settled, found, anchor=anchor, pressed=space_force)
      else
         call solve_bending(beam, in_space, settled, found, pressed=space_force)
      end if
      call assertTrue(found, message=name//': found in space')
      beam%lateral = lateral
      if (anchored) then
         call solve_bending(beam, in_plane, settled, found, anchor=anchor, pressed=plane_force)
      else
         call solve_bending(beam, in_plane, settled, found, pressed=plane_force)
      end if
      call assertTrue(found, message=name//': found in its plane')
      call assertTrue(count(space_force > 0.0_wp) > 4, message=name//': touches')
      call assertEqual(0.0_wp, maxval(abs(in_plane - in_space)), tolerance=close*maxval(abs(in_space)), message=name//': offsets')
      call assertEqual(0.0_wp, maxval(abs(plane_force - space_force)), tolerance=1.0e-6_wp*maxval(space_force), &
                       message=name//': forces')
   end subroutine compare

   !> An odd and an even number of nodes: the middle node stands for itself, or its mate is none.
   subroutine test_pulled()
      type(bending_beam_type) :: beam
      integer :: n
      do n = 30, 31
         beam = string_of(n, 2.0e5_wp)
         call compare(beam, .false., merge('even', 'odd ', n == 30))
      end do
   end subroutine test_pulled

   !> Springs pull it to where it was laid.
   subroutine test_compressed()
      type(bending_beam_type) :: beam
      beam = string_of(30, -4.0e4_wp)
      call compare(beam, .true., 'compressed')
   end subroutine test_compressed

   subroutine test_held()
      type(bending_beam_type) :: beam
      beam = string_of(31, 2.0e5_wp)
      beam%held(1) = .true.
      beam%centred(31) = .true.
      call compare(beam, .false., 'held')
   end subroutine test_held

   !> Nothing holds a string without weight and tension that touches nowhere.
   subroutine test_none()
      type(bending_beam_type) :: beam
      real(wp) :: y(4, 12)
      logical :: found
      beam = string_of(12, 0.0_wp)
      beam%point = [integer ::]
      beam%point_law = [gap_law_type ::]
      beam%element%law%clearance = 10.0_wp
      beam%lateral = lateral
      y = 0.0_wp
      call solve_bending(beam, y, settled, found)
      call assertTrue(.not. found)
   end subroutine test_none
end module dg_test_plane_bending

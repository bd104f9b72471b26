!> The consistent tangent against central differences of the residual, entry by entry, on a short curved string
!> with contact in all states, friction in both directions, torque and supports.
module dg_test_tangent
   use funit, only: TestMethod, TestSuite, assertTrue, assertEqual, assertLessThan
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_assembly, only: add_unsymmetric_part, assemble, load_type
   use dg_beam_element, only: beam_tangent, beam_tangent_parts, beam_force, membrane_length
   use dg_beam_section, only: beam_section_type
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_error, only: error_type
   use dg_gap_state, only: gap_law_type, state_elastic, state_free, state_rigid
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: arc_at, frame_on_arc, interpolation_minimum_curvature, new_trajectory, point_on_arc, trajectory_type
   use dg_followed_gaps, only: add_place_stiffness, follower_type, measure_followers
   use dg_gap_action, only: find_contact_rows
   use dg_gap_survey, only: survey_between, survey_gaps
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: tangent_suite

   !> Step of the central difference: its truncation error goes with the square, its round-off with the inverse.
   real(wp), parameter :: step = 1.0e-6_wp
   !> Of an entry against the largest in its unknown's row and column scale. Seen: 3e-9.
   real(wp), parameter :: tolerance = 1.0e-7_wp
   !> Shares of friction that climb in a string that whirls here and there.
   real(wp), parameter :: whirling(6) = [0.0_wp, 0.5_wp, 1.0_wp, 0.0_wp, 0.3_wp, 0.0_wp]

contains

   function tangent_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('tangent')
      call suite%addTest(TestMethod('beam_parts_sum_to_second_derivative', beam_parts_sum_to_second_derivative))
      call suite%addTest(TestMethod('whole_string_tangent_matches_differences', whole_string_tangent_matches_differences))
      call suite%addTest(TestMethod('conservative_tangent_is_symmetric', conservative_tangent_is_symmetric))
      call suite%addTest(TestMethod('friction_makes_it_whole', friction_makes_it_whole))
      call suite%addTest(TestMethod('forces_alone_are_the_same', forces_alone_are_the_same))
      call suite%addTest(TestMethod('contact_rows_match_differences', contact_rows_match_differences))
      call suite%addTest(TestMethod('followed_gap_matches_differences', followed_gap_matches_differences))
   end function tangent_suite

   !> K0 + KN + Ksigma is the derivative of the internal force.
   subroutine beam_parts_sum_to_second_derivative()
      type(beam_section_type) :: section
      real(wp) :: chord(3), d_i(3), d_j(3), y(12), plus(12), minus(12), axial, force(12)
      real(wp) :: total(12, 12), k0(12, 12), kn(12, 12), ksigma(12, 12), differences(12, 12), straight(3)
      integer :: i
      straight = [0.0_wp, 0.0_wp, 1.0_wp]
      section = beam_section_type(length=5.0_wp, membrane_length=5.0_wp, ea=7.0e8_wp, ei=1.2e6_wp)
      y = [0.01_wp, -0.02_wp, 0.03_wp, 0.02_wp, -0.01_wp, 1.0_wp, 0.05_wp, 0.02_wp, 5.031_wp, -0.015_wp, 0.03_wp, 0.99_wp]
      chord = y(7:9) - y(1:3)
      d_i = y(4:6)
      d_j = y(10:12)
      call beam_tangent(section, chord, d_i, d_j, force, axial, total)
      call beam_tangent_parts(section, chord, d_i, d_j, 5.0_wp*straight, straight, straight, k0, kn, ksigma)
      do i = 1, 12
         plus = shifted(i, step)
         minus = shifted(i, -step)
         differences(:, i) = (plus - minus)/(2.0_wp*step)
      end do
      call assertLessThan(maxval(abs(differences - total))/maxval(abs(total)), tolerance, message='beam tangent')
      call assertLessThan(maxval(abs(k0 + kn + ksigma - total))/maxval(abs(total)), 1.0e-14_wp, message='sum of parts')
      call assertTrue(maxval(abs(kn)) > 0.0_wp .and. maxval(abs(ksigma)) > 0.0_wp, message='parts are not empty')
   contains
      function shifted(index, amount) result(f)
         integer, intent(in) :: index
         real(wp), intent(in) :: amount
         real(wp) :: f(12), z(12), n
         z = y
         z(index) = z(index) + amount
         call beam_force(section, z(7:9) - z(1:3), z(4:6), z(10:12), f, n)
      end function shifted
   end subroutine beam_parts_sum_to_second_derivative

   !> A string of six elements around a bend whose plane turns, with every kind of action on it.
   subroutine curved_string(trajectory, mesh, gaps, loads, state)
      type(trajectory_type), intent(out) :: trajectory
      type(mesh_type), intent(out) :: mesh
      type(gap_table_type), intent(out) :: gaps
      type(load_type), intent(out) :: loads
      real(wp), allocatable, intent(out) :: state(:, :)
      type(error_type), allocatable :: error
      type(gap_law_type) :: law
      real(wp) :: tangent(3), curvature(3), end_point(3)
      integer, parameter :: elements = 6
      integer :: e, n, a
      call new_trajectory(trajectory, [0.0_wp, 11.0_wp, 24.0_wp, 40.0_wp], [20.0_wp, 24.0_wp, 31.0_wp, 36.0_wp]*degree, &
                          [10.0_wp, 14.0_wp, 11.0_wp, 20.0_wp]*degree, interpolation_minimum_curvature, error)
      mesh%elements = elements
      mesh%nodes = elements + 1
      mesh%md = [(5.0_wp*n, n=0, elements)]
      allocate (mesh%frame(3, 3, mesh%nodes), mesh%base(3, mesh%nodes), mesh%arc(mesh%nodes), mesh%chord(3, elements))
      do n = 1, mesh%nodes
         a = arc_at(trajectory, mesh%md(n))
         mesh%arc(n) = a
         call point_on_arc(trajectory%arcs(a), mesh%md(n) - trajectory%arcs(a)%md, mesh%base(:, n), tangent, curvature)
         call frame_on_arc(trajectory%arcs(a), mesh%md(n) - trajectory%arcs(a)%md, mesh%frame(:, 1, n), mesh%frame(:, 2, n), &
                           mesh%frame(:, 3, n))
      end do
      do e = 1, elements
         end_point = mesh%base(:, e + 1)
         do a = mesh%arc(e), mesh%arc(e + 1) - 1
            end_point = end_point + trajectory%arcs(a)%chord
         end do
         mesh%chord(:, e) = end_point - mesh%base(:, e)
      end do
      mesh%length = spread(5.0_wp, 1, elements)
      mesh%section = [(beam_section_type(length=5.0_wp, ea=7.0e8_wp, ei=1.2e6_wp, gj=0.9e6_wp, &
                                         membrane_length=membrane_length(mesh%chord(:, e), mesh%frame(:, 1, e), &
                                                                         mesh%frame(:, 1, e + 1))), e=1, elements)]
      mesh%weight = spread(260.0_wp, 1, elements)
      mesh%radius = spread(0.08_wp, 1, elements)
      mesh%friction_along = [0.2_wp, -0.2_wp, 0.1_wp, 0.3_wp, 0.2_wp, 0.2_wp]
      mesh%friction_around = [0.2_wp, 0.2_wp, 0.3_wp, 0.0_wp, 0.1_wp, 0.2_wp]
      mesh%drag = spread(150.0_wp, 1, elements)
      mesh%centralizer = spread(.false., 1, elements)
      law = gap_law_type(clearance=0.045_wp, contact=5.0e5_wp, maximum=3.0e6_wp, eps_nmax=0.05_wp)
      gaps = new_gap_table([(law, e=1, elements)], 0.5_wp)
      gaps%xi = [0.5_wp, 0.2_wp, 1.0_wp, 0.7_wp, 0.0_wp, 0.4_wp]
      gaps%state = [state_elastic, state_elastic, state_rigid, state_free, state_elastic, state_rigid]
      loads = load_type(wob=3.0e4_wp, tob=2.0e3_wp, friction_scale=0.9_wp, top_support=1.0e6_wp, bit_support=1.0e6_wp)
      allocate (state(6, mesh%nodes))
      do n = 1, mesh%nodes
         state(:, n) = [0.001_wp*n, 0.046_wp*cos(0.3_wp*n), 0.047_wp*sin(0.3_wp*n), -0.02_wp*n, 0.004_wp*sin(1.0_wp*n), &
                        0.003_wp*cos(2.0_wp*n)]
      end do
      state(1, 1) = 0.0_wp
      state(4, 1) = 0.0_wp
   end subroutine curved_string

   subroutine whole_string_tangent_matches_differences()
      type(trajectory_type) :: trajectory
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix, spare
      real(wp), allocatable :: state(:, :), residual(:, :), plus(:, :), minus(:, :), changed(:, :)
      real(wp), allocatable :: dense(:, :)
      real(wp) :: worst, scale(6), error
      integer :: n, i, k, m, kind
      call curved_string(trajectory, mesh, gaps, loads, state)
      call new_workspace(mesh, work)
      do kind = 1, 2
         if (kind == 2) work%sideways = whirling
         matrix = new_block_matrix(mesh%nodes)
         spare = new_block_matrix(mesh%nodes)
         if (kind == 1) allocate (residual, plus, minus, mold=state)
         call assemble_at(trajectory, mesh, loads, gaps, state, .false., work, residual, matrix)
         dense = to_dense(matrix)
         ! A row or column of forces and metres is stiffer than one of moments and slopes by a length squared.
         scale = [1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp]
         worst = 0.0_wp
         do n = 1, mesh%nodes
            do i = 1, 6
               if (n == 1 .and. (i == 1 .or. i == 4)) cycle   ! held
               changed = state
               changed(i, n) = state(i, n) + step
               call assemble_at(trajectory, mesh, loads, gaps, changed, .false., work, plus, spare)
               changed(i, n) = state(i, n) - step
               call assemble_at(trajectory, mesh, loads, gaps, changed, .false., work, minus, spare)
               plus = (plus - minus)/(2.0_wp*step)
               do m = 1, mesh%nodes
                  do k = 1, 6
                     if (m == 1 .and. (k == 1 .or. k == 4)) cycle
                     error = abs(plus(k, m) - dense(6*(m - 1) + k, 6*(n - 1) + i))
                     error = error/sqrt(abs(dense(6*(m - 1) + k, 6*(m - 1) + k)*dense(6*(n - 1) + i, 6*(n - 1) + i)))
                     worst = max(worst, error)
                  end do
               end do
            end do
         end do
         call assertLessThan(worst, tolerance, message='largest deviation of the tangent from differences')
      end do
   end subroutine whole_string_tangent_matches_differences

   !> Without friction and torque the tangent is the second derivative of an energy.
   subroutine conservative_tangent_is_symmetric()
      type(trajectory_type) :: trajectory
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix
      real(wp), allocatable :: state(:, :), residual(:, :), dense(:, :)
      integer :: kind
      call curved_string(trajectory, mesh, gaps, loads, state)
      loads%wob = 0.0_wp     ! along the turning tangent: a follower force, with a small unsymmetric part of its own
      call new_workspace(mesh, work)
      matrix = new_block_matrix(mesh%nodes)
      allocate (residual, mold=state)
      do kind = 1, 2
         if (kind == 2) then
            work%sideways = whirling
            mesh%friction_along = 0.0_wp       ! along a curved axis its couple derives from no energy, if hardly so
         end if
         call assemble_at(trajectory, mesh, loads, gaps, state, .true., work, residual, matrix)
         dense = to_dense(matrix)
         call assertLessThan(maxval(abs(dense - transpose(dense)))/maxval(abs(dense)), 1.0e-13_wp, message='asymmetry')
      end do
   end subroutine conservative_tangent_is_symmetric

   !> The conservative tangent with what friction and torque add is the whole one: of a string that whirls; everything acting at
   !> once; a string that slides
   !> without turning, torque or none; one without friction, to which nothing is added.
   subroutine friction_makes_it_whole()
      type(trajectory_type) :: trajectory
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: whole, parts
      real(wp), allocatable :: state(:, :), residual(:, :), added(:, :)
      integer :: kind
      call curved_string(trajectory, mesh, gaps, loads, state)
      call new_workspace(mesh, work)
      whole = new_block_matrix(mesh%nodes)
      parts = new_block_matrix(mesh%nodes)
      allocate (residual, mold=state)
      do kind = 0, 4
         work%sideways = merge(whirling, 1.0_wp, kind == 0)
         if (kind > 1) mesh%friction_around = 0.0_wp
         if (kind > 2) state(4, :) = 0.0_wp
         if (kind > 3) mesh%friction_along = 0.0_wp
         call assemble_at(trajectory, mesh, loads, gaps, state, .false., work, residual, whole)
         call assemble_at(trajectory, mesh, loads, gaps, state, .true., work, residual, parts)
         added = to_dense(whole) - to_dense(parts)
         call assertTrue(maxval(abs(added)) > 1.0_wp .eqv. kind < 4, message='something is missing but without friction')
         call add_unsymmetric_part(mesh, loads, gaps, state, work, parts)
         added = to_dense(whole) - to_dense(parts)
         call assertLessThan(maxval(abs(added))/maxval(abs(to_dense(whole))), 1.0e-14_wp, message='whole')
      end do
   end subroutine friction_makes_it_whole

   !> Forces without their tangent are the same to the last bit, and leave the matrix alone but for its supports.
   subroutine forces_alone_are_the_same()
      type(trajectory_type) :: trajectory
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix, other
      real(wp), allocatable :: state(:, :), residual(:, :), alone(:, :)
      real(wp) :: hookload
      call curved_string(trajectory, mesh, gaps, loads, state)
      call new_workspace(mesh, work)
      matrix = new_block_matrix(mesh%nodes)
      other = new_block_matrix(mesh%nodes)
      allocate (residual, alone, mold=state)
      call assemble_at(trajectory, mesh, loads, gaps, state, .false., work, residual, matrix)
      hookload = work%hookload
      call assemble(trajectory, mesh, loads, gaps, state, .false., work, alone, other, forces_only=.true.)
      call assertTrue(maxval(abs(residual)) > 0.0_wp)
      call assertEqual(0.0_wp, maxval(abs(residual - alone)))
      call assertEqual(hookload, work%hookload)
      call assertEqual(0.0_wp, maxval(abs(other%lower)), message='no tangent')
   end subroutine forces_alone_are_the_same

   !> Contact forces as unknowns: what one of them adds to the residual, and what moves its gap, against differences; with friction
   !> in both directions, sliding and whirling.
   subroutine contact_rows_match_differences()
      type(trajectory_type) :: trajectory
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: ignored
      real(wp), allocatable :: state(:, :), residual(:, :), other(:, :), by(:, :), on(:, :)
      real(wp), parameter :: newtons = 100.0_wp
      real(wp) :: deeper(2), difference(12)
      integer :: kind, e, i, j, closed
      call curved_string(trajectory, mesh, gaps, loads, state)
      call new_workspace(mesh, work)
      ignored = new_block_matrix(mesh%nodes)
      allocate (residual, other, mold=state)
      allocate (by(12, mesh%elements), on(12, mesh%elements))
      work%separate = .true.
      closed = 0
      do kind = 0, 2
         work%sideways = merge(whirling, 1.0_wp, kind == 0)
         if (kind > 1) mesh%friction_around = 0.0_wp
         work%normal = [(1000.0_wp + 100.0_wp*e, e=1, mesh%elements)]
         call assemble_at(trajectory, mesh, loads, gaps, state, .false., work, residual, ignored)
         call find_contact_rows(mesh, loads, gaps, 1, mesh%elements, work, by, on)
         do e = 1, mesh%elements
            if (gaps%state(e) == state_free) cycle
            closed = closed + 1
            work%normal(e) = work%normal(e) + newtons
            call assemble_at(trajectory, mesh, loads, gaps, state, .false., work, other, ignored)
            work%normal(e) = work%normal(e) - newtons
            difference = [other(:, e) - residual(:, e), other(:, e + 1) - residual(:, e + 1)]/newtons
            difference = difference - on(:, e)
            if (kind == 0 .and. e == 1) difference(5:6) = 0.0_wp     ! the top's torque, a reaction, bends a whirling string there
            call assertLessThan(maxval(abs(difference))/maxval(abs(on(:, e))), 1.0e-6_wp, message='residual by force')
            do i = 1, 12
               if (e == 1 .and. (i == 1 .or. i == 4)) cycle       ! held
               do j = 1, 2
                  other = state
                  associate (unknown => other(mod(i - 1, 6) + 1, e + (i - 1)/6))
                     unknown = unknown + merge(step, -step, j == 1)
                  end associate
                  call place_nodes(mesh, other, work)
                  call survey_gaps(trajectory, mesh, gaps, work)
                  deeper(j) = work%displacement(e)
               end do
               difference(i) = (deeper(1) - deeper(2))/(2.0_wp*step) - by(i, e)
               call assertLessThan(abs(difference(i)), 1.0e-6_wp, message='gap by unknown')
            end do
            call place_nodes(mesh, state, work)
            call survey_gaps(trajectory, mesh, gaps, work)
         end do
      end do
      call assertTrue(closed > 6, message='closed gaps')
   end subroutine contact_rows_match_differences

   !> A gap whose place is at the extremum of its element wherever the string moves, its force held: the residual's differences are
   !> the tangent with what following adds. That adds a tenth of it or more, and without friction it is symmetric.
   subroutine followed_gap_matches_differences()
      type(trajectory_type) :: trajectory
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix, ignored
      type(follower_type), allocatable :: followers(:)
      real(wp), allocatable :: state(:, :), residual(:, :), other(:, :), before(:, :), dense(:, :)
      integer, parameter :: e = 3, first = 6*(e - 1)
      real(wp), parameter :: bulge = 0.02_wp     ! slope at its ends [-]
      real(wp) :: outward(2), plain(12, 12), difference(12, 2), worst
      integer :: kind, i, j
      call curved_string(trajectory, mesh, gaps, loads, state)
      outward = state(2:3, e)/norm2(state(2:3, e))
      state(5:6, e) = bulge*outward
      state(5:6, e + 1) = -bulge*outward
      call new_workspace(mesh, work)
      matrix = new_block_matrix(mesh%nodes)
      ignored = new_block_matrix(mesh%nodes)
      allocate (residual, other, before, mold=state)
      work%separate = .true.
      work%normal = [(20000.0_wp + 100.0_wp*j, j=1, mesh%elements)]
      do kind = 1, 2
         if (kind == 2) then
            mesh%friction_around = 0.0_wp
            mesh%friction_along = 0.0_wp
         end if
         gaps%followed = .false.
         gaps%followed(e) = .true.
         call find_place(state)
         call assemble_at(trajectory, mesh, loads, gaps, state, .false., work, residual, matrix)
         dense = to_dense(matrix)
         plain = dense(first + 1:first + 12, first + 1:first + 12)
         call measure_followers(trajectory, mesh, loads, 0.0_wp, gaps, work, followers)
         call assertEqual(1, size(followers))
         if (size(followers) /= 1) return
         call assertLessThan(abs(followers(1)%ahead), 1.0e-3_wp, message='at the extremum')
         call add_place_stiffness(followers, .true., .true., matrix)
         dense = to_dense(matrix)
         associate (block => dense(first + 1:first + 12, first + 1:first + 12))
            worst = maxval(abs(block(:, 2:3) - plain(:, 2:3)))/maxval(abs(plain(2:3, 2:3)))
            call assertTrue(worst > 0.1_wp, message='following adds a part')
            if (kind == 2) call assertLessThan(maxval(abs(block - plain - transpose(block - plain)))/maxval(abs(block - plain)), &
                                               1.0e-3_wp, message='asymmetry')
            do i = 1, 12
               do j = 1, 2
                  other = state
                  associate (unknown => other(mod(i - 1, 6) + 1, e + (i - 1)/6))
                     unknown = unknown + merge(step, -step, j == 1)
                  end associate
                  call place_nodes(mesh, other, work)
                  call find_place(other)
                  call assemble_at(trajectory, mesh, loads, gaps, other, .false., work, before, ignored)
                  difference(:, j) = [before(:, e), before(:, e + 1)]
               end do
               difference(:, 1) = (difference(:, 1) - difference(:, 2))/(2.0_wp*step)
               worst = 0.0_wp
               do j = 1, 12
                  worst = max(worst, abs(difference(j, 1) - block(j, i))/sqrt(abs(block(i, i)*block(j, j))))
               end do
               call assertLessThan(worst, 1.0e-4_wp, message='residual by unknown')
            end do
         end associate
      end do

   contains

      !> Puts the gap where |f| is largest, by Newton's method with differences.
      subroutine find_place(there)
         real(wp), contiguous, intent(in) :: there(:, :)
         real(wp), parameter :: beside = 1.0e-3_wp
         real(wp) :: f(-1:1), place
         integer :: k, m
         call place_nodes(mesh, there, work)
         do m = 1, 8
            place = gaps%xi(e)
            do k = -1, 1
               gaps%xi(e) = place + k*beside
               call survey_between(trajectory, mesh, gaps, e, e, work)
               f(k) = work%displacement(e)
            end do
            gaps%xi(e) = place + 0.5_wp*beside*(f(1) - f(-1))/(2.0_wp*f(0) - f(1) - f(-1))
         end do
      end subroutine find_place
   end subroutine followed_gap_matches_differences

   subroutine assemble_at(trajectory, mesh, loads, gaps, state, conservative, work, residual, matrix)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(gap_table_type), intent(in) :: gaps
      real(wp), contiguous, intent(in) :: state(:, :)
      logical, intent(in) :: conservative
      type(workspace_type), intent(inout) :: work
      real(wp), intent(inout) :: residual(:, :)
      type(block_matrix_type), intent(inout) :: matrix
      call place_nodes(mesh, state, work)
      call survey_gaps(trajectory, mesh, gaps, work)
      call assemble(trajectory, mesh, loads, gaps, state, conservative, work, residual, matrix)
   end subroutine assemble_at

   function to_dense(matrix) result(dense)
      type(block_matrix_type), intent(in) :: matrix
      real(wp), allocatable :: dense(:, :)
      integer :: n, a
      allocate (dense(6*size(matrix%diagonal, 3), 6*size(matrix%diagonal, 3)), source=0.0_wp)
      do n = 1, size(matrix%diagonal, 3)
         a = 6*(n - 1)
         dense(a + 1:a + 6, a + 1:a + 6) = matrix%diagonal(:, :, n)
         if (n == size(matrix%diagonal, 3)) exit
         dense(a + 1:a + 6, a + 7:a + 12) = matrix%upper(:, :, n)
         dense(a + 7:a + 12, a + 1:a + 6) = matrix%lower(:, :, n)
      end do
   end function to_dense
end module dg_test_tangent

!> Strings solved in the plane of their hole: the same equations as in space, the same results, and only where nothing leaves the
!> plane.
module dg_test_plane
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, &
                    TestSuite
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, new_block_matrix, plane_block_size
   use dg_case_result, only: case_result_type, result_converged, way_buckles, way_left, way_not_asked, way_planar, way_rotates, &
                             way_turns
   use dg_error, only: error_type
   use dg_gap_action, only: find_contact_rows
   use dg_gap_state, only: gap_law_type, state_elastic, state_free, state_rigid
   use dg_gap_survey, only: survey_gaps
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_kinds, only: wp
   use dg_linear_solver, only: solver_banded, solver_sparse
   use dg_load_case, only: operation_rotate_off_bottom, operation_sliding_drilling, operation_static, operation_trip_in, &
                           operation_trip_out
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_nodes, settings_of
   use dg_plane, only: find_plane, flatten, plane_type, unfold
   use dg_plane_assembly, only: assemble_in_plane, find_rows_in_plane
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: hold_ends, new_well, note, pipe, string_weight, three_part_well
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: plane_suite

   real(wp), parameter :: w = 262.0_wp, od = 0.127_wp, id = 0.1086_wp
   !> Both ways end within the tolerance of 1e-9 of the weight, at states that differ by what that leaves open.
   real(wp), parameter :: same_hookload = 1.0e-9_wp, same_contact = 1.0e-8_wp, same_profile = 1.0e-6_wp

contains

   function plane_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('plane')
      call suite%addTest(TestMethod('equations_are_those_of_space', test_equations))
      call suite%addTest(TestMethod('tangent_matches_differences', test_differences))
      call suite%addTest(TestMethod('rows_are_those_of_space', test_rows))
      call suite%addTest(TestMethod('planes_are_found', test_planes_are_found))
      call suite%addTest(TestMethod('build_hold_drop', test_build_hold_drop))
      call suite%addTest(TestMethod('lateral', test_lateral))
      call suite%addTest(TestMethod('vertical', test_vertical))
      call suite%addTest(TestMethod('assembly', test_assembly))
      call suite%addTest(TestMethod('settings', test_settings))
      call suite%addTest(TestMethod('fine_mesh', test_fine_mesh))
      call suite%addTest(TestMethod('space_where_it_must', test_space_where_it_must))
      call suite%addTest(TestMethod('space_decides', test_space_decides))
   end function plane_suite

   !> A string of six elements in a hole that is vertical at the top, where its frame starts north, builds and drops at an azimuth:
   !> anything may be at its ends and on its way, and its gaps are in all states.
   subroutine planar_string(model, mesh, plane, gaps, loads, state, work)
      type(model_type), intent(out) :: model
      type(mesh_type), intent(out) :: mesh
      type(plane_type), intent(out) :: plane
      type(gap_table_type), intent(out) :: gaps
      type(load_type), intent(out) :: loads
      real(wp), allocatable, intent(out) :: state(:, :)
      type(workspace_type), intent(out) :: work
      real(wp), allocatable :: step(:, :)
      type(gap_law_type) :: law
      logical :: found
      integer :: n, e
      call new_well(model, [0.0_wp, 5.0_wp, 17.0_wp, 30.0_wp], [0.0_wp, 0.0_wp, 11.0_wp, 4.0_wp], spread(130.0_wp, 1, 4), 0.2_wp, &
                    0.3_wp, pipe(w, od, id))
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 5.5_wp), mesh)
      call find_plane(mesh, plane, found)
      call assertTrue(found, message='a plane')
      mesh%axial = [(0.3_wp*sin(2.0_wp*e), e=1, mesh%elements)]
      mesh%axial(2) = 0.0_wp
      mesh%rotary = 0.0_wp
      law = gap_law_type(clearance=0.0365_wp, contact=5.0e5_wp, maximum=3.0e6_wp, eps_nmax=0.05_wp)
      gaps = new_gap_table([(law, e=1, mesh%elements)], 0.5_wp)
      gaps%xi = [(0.5_wp + 0.5_wp*sin(3.0_wp*e), e=1, mesh%elements)]
      gaps%state = [(merge(merge(state_rigid, state_elastic, modulo(e, 3) == 0), state_free, e /= 4), e=1, mesh%elements)]
      loads = load_type(wob=3.0e4_wp, friction_scale=0.9_wp, top_support=1.0e6_wp, bit_support=2.0e6_wp)
      allocate (state(6, mesh%nodes), source=0.0_wp)
      allocate (step(plane_block_size, mesh%nodes))
      do n = 1, mesh%nodes
         step(:, n) = [0.002_wp*(n - 1), 0.038_wp*cos(1.3_wp*n), 0.03_wp*sin(2.0_wp*n)]
         call unfold(plane, step(:, n), state(:, n))
      end do
      call new_workspace(mesh, work)
   end subroutine planar_string

   !> Residual and every block of the tangent in the plane are those in space, and in space nothing points out of the plane.
   subroutine test_equations()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(plane_type) :: plane
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: small, matrix
      real(wp), allocatable :: state(:, :), residual(:, :), alone(:, :), spatial(:, :)
      real(wp) :: ways(6, 3), scale, force, moment, hookload, worst
      integer :: n, next
      real(wp), parameter :: round_off = 1.0e-12_wp
      call planar_string(model, mesh, plane, gaps, loads, state, work)
      call place_nodes(mesh, state, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      small = new_block_matrix(mesh%nodes, plane_block_size)
      matrix = new_block_matrix(mesh%nodes)
      allocate (residual(3, mesh%nodes), alone(3, mesh%nodes), spatial(6, mesh%nodes))
      call assemble_in_plane(model%trajectory, mesh, plane, loads, gaps, state, .false., work, residual, small)
      call assemble_in_plane(model%trajectory, mesh, plane, loads, gaps, state, .true., work, alone, small)
      hookload = work%hookload
      call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, spatial, matrix)
      ways = 0.0_wp
      ways(1, 1) = 1.0_wp
      ways(2:3, 2) = plane%lateral
      ways(5:6, 3) = plane%lateral
      force = maxval(abs(spatial(1:3, :)))
      moment = maxval(abs(spatial(4:6, :)))
      call assertGreaterThan(moment, 1.0_wp, message='something acts')
      call assertEqual(0.0_wp, maxval(abs(residual - alone)), message='forces alone are the same')
      call assertRelativelyEqual(work%hookload, hookload, round_off, message='hook load')
      call assertLessThan(maxval(abs(matmul(transpose(ways), spatial) - residual)), round_off*force, message='residual')
      call assertLessThan(maxval(abs(spatial - matmul(ways, residual))), round_off*force, message='nothing out of the plane')
      worst = 0.0_wp
      scale = maxval(abs(matrix%diagonal))
      do n = 1, mesh%nodes
         worst = max(worst, maxval(abs(matmul(transpose(ways), matmul(matrix%diagonal(:, :, n), ways)) - small%diagonal(:, :, n))))
         next = n + 1
         if (next > mesh%nodes) cycle
         worst = max(worst, maxval(abs(matmul(transpose(ways), matmul(matrix%upper(:, :, n), ways)) - small%upper(:, :, n))), &
                     maxval(abs(matmul(transpose(ways), matmul(matrix%lower(:, :, n), ways)) - small%lower(:, :, n))))
      end do
      call note('largest difference of the tangents over their largest entry', worst/scale)
      call assertLessThan(worst, round_off*scale, message='tangent')
   end subroutine test_equations

   !> Rows of contact forces in the plane are those in space, of gaps near the wall and of none else.
   subroutine test_rows()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(plane_type) :: plane
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      real(wp), allocatable :: state(:, :), by(:, :), on(:, :), spatial_by(:, :), spatial_on(:, :)
      real(wp) :: ways(12, 6)
      integer :: i, rows
      real(wp), parameter :: round_off = 1.0e-12_wp
      call planar_string(model, mesh, plane, gaps, loads, state, work)
      call place_nodes(mesh, state, work)
      call survey_gaps(model%trajectory, mesh, gaps, work)
      work%separate = .true.
      work%normal = 0.0_wp
      allocate (by(6, mesh%elements), on(6, mesh%elements), spatial_by(12, mesh%elements), spatial_on(12, mesh%elements))
      call find_contact_rows(mesh, loads, gaps, 1, mesh%elements, work, spatial_by, spatial_on)
      call find_rows_in_plane(mesh, plane, loads, gaps, state, work, by, on)
      ways = 0.0_wp
      do i = 0, 1
         ways(6*i + 1, 3*i + 1) = 1.0_wp
         ways(6*i + 2:6*i + 3, 3*i + 2) = plane%lateral
         ways(6*i + 5:6*i + 6, 3*i + 3) = plane%lateral
      end do
      call assertEqual(matmul(transpose(ways), spatial_by), by, round_off, message='by')
      call assertEqual(matmul(transpose(ways), spatial_on), on, round_off, message='on')
      rows = count(maxval(abs(by), dim=1) > 0.0_wp)
      call assertGreaterThan(rows, 1, message='some are near')
      call assertLessThan(rows, mesh%elements, message='some are not')
   end subroutine test_rows

   !> The tangent against central differences of the residual, as for the one in space.
   subroutine test_differences()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(plane_type) :: plane
      type(gap_table_type) :: gaps
      type(load_type) :: loads
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix
      real(wp), allocatable :: state(:, :), residual(:, :), column(:, :), step(:, :), expected(:, :)
      real(wp) :: worst
      real(wp), parameter :: h = 1.0e-6_wp, tolerance = 1.0e-7_wp
      integer :: n, i, before
      call planar_string(model, mesh, plane, gaps, loads, state, work)
      matrix = new_block_matrix(mesh%nodes, plane_block_size)
      allocate (residual(3, mesh%nodes), column(3, mesh%nodes), step(3, mesh%nodes), expected(3, mesh%nodes))
      call residual_at(0.0_wp, residual, .false.)
      worst = 0.0_wp
      do n = 1, mesh%nodes
         do i = 1, 3
            if (n == 1 .and. i == 1) cycle     ! held
            step = 0.0_wp
            step(i, n) = 1.0_wp
            call residual_at(h, column, .true.)
            call residual_at(-h, residual, .true.)
            column = (column - residual)/(2.0_wp*h)
            expected = 0.0_wp
            before = n - 1
            expected(:, n) = matrix%diagonal(:, i, n)
            if (n < mesh%nodes) expected(:, n + 1) = matrix%lower(:, i, n)
            if (before > 0) expected(:, before) = matrix%upper(:, i, before)
            worst = max(worst, maxval(abs(column - expected)))
         end do
      end do
      worst = worst/maxval(abs(matrix%diagonal))
      call note('largest deviation of the tangent from differences', worst)
      call assertLessThan(worst, tolerance, message='tangent')

   contains

      subroutine residual_at(share, r, forces_only)
         real(wp), intent(in) :: share
         real(wp), intent(inout) :: r(:, :)
         logical, intent(in) :: forces_only
         real(wp) :: moved(6, mesh%nodes)
         integer :: k
         do k = 1, mesh%nodes
            call unfold(plane, step(:, k), moved(:, k))
         end do
         moved = state + share*moved
         call place_nodes(mesh, moved, work)
         call survey_gaps(model%trajectory, mesh, gaps, work)
         call assemble_in_plane(model%trajectory, mesh, plane, loads, gaps, moved, forces_only, work, r, matrix)
      end subroutine residual_at
   end subroutine test_differences

   !> At any azimuth, through the vertical to the other side, beyond 90 deg; and not where the azimuth changes by a thousandth of a
   !> degree. What lies out of the plane is taken off, what lies in it stays.
   subroutine test_planes_are_found()
      real(wp) :: state(6, 4), flat(6, 4), once(6, 4)
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(plane_type) :: plane
      integer :: i, k
      logical :: found
      real(wp) :: azimuth(4)
      do i = 0, 11
         azimuth = 33.3_wp*i + [0.0_wp, 0.0_wp, 0.0_wp, 180.0_wp]
         call look([0.0_wp, 20.0_wp, 0.0_wp, 30.0_wp], azimuth)
         call assertTrue(found, message='through the vertical')
         call assertLessThan(abs(mesh%frame(1, 1, 2)*plane%horizontal(2) - mesh%frame(2, 1, 2)*plane%horizontal(1)), &
                             1.0e-12_wp, message='along it')
         azimuth = 33.3_wp*i
         call look([10.0_wp, 60.0_wp, 97.0_wp, 85.0_wp], azimuth)
         call assertTrue(found, message='beyond 90 deg')
         call look([0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], azimuth)
         call assertTrue(found, message='vertical')
         azimuth(3) = azimuth(3) + 1.0e-3_wp
         call look([10.0_wp, 20.0_wp, 30.0_wp, 40.0_wp], azimuth)
         call assertFalse(found, message='turning')
      end do
      call look([5.0_wp, 20.0_wp, 30.0_wp, 40.0_wp], spread(70.0_wp, 1, 4))
      state = reshape([(sin(1.0_wp*k), k=1, 24)], [6, 4])
      flat = state
      call flatten(plane, flat)
      once = flat
      call flatten(plane, flat)
      call assertEqual(0.0_wp, maxval(abs(flat - once)), 1.0e-15_wp, message='flat stays flat')
      call assertEqual(matmul(plane%lateral, state(2:3, :)), matmul(plane%lateral, flat(2:3, :)), 1.0e-15_wp, message='offset')
      call assertEqual(matmul(plane%lateral, state(5:6, :)), matmul(plane%lateral, flat(5:6, :)), 1.0e-15_wp, message='slope')
      call assertEqual(0.0_wp, maxval(abs(flat(4, :))), message='no twist')
      call assertGreaterThan(maxval(abs(flat - state)), 0.1_wp, message='something was taken off')

   contains

      subroutine look(inclination, azimuth)
         real(wp), intent(in) :: inclination(4), azimuth(4)
         call new_well(model, [0.0_wp, 100.0_wp, 230.0_wp, 300.0_wp], inclination, azimuth, 0.2_wp, 0.3_wp, pipe(w, od, id))
         call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 40.0_wp), mesh)
         call find_plane(mesh, plane, found)
      end subroutine look
   end subroutine test_planes_are_found

   !> Solves the model's case in the plane and in space, and compares all that an engineer reads.
   subroutine compare(model, what)
      type(model_type), intent(inout) :: model
      character(*), intent(in) :: what
      type(case_result_type) :: plane, space
      type(error_type), allocatable :: error
      real(wp) :: scale
      model%numerics%in_plane = .false.
      call solve_static_analysis(model, 1, space, error)
      model%numerics%in_plane = .true.
      call solve_static_analysis(model, 1, plane, error)
      call assertEqual(result_converged, space%status, message=what//': space')
      call assertEqual(result_converged, plane%status, message=what//': plane')
      call assertEqual(way_not_asked, space%way, message=what//': in space')
      call assertEqual(way_planar, plane%way, message=what//': in the plane')
      if (plane%status /= result_converged .or. space%status /= result_converged) return
      scale = string_weight(model) + abs(model%cases(1)%wob)
      call assertLessThan(abs(plane%hookload - space%hookload), same_hookload*scale, message=what//': hook load')
      call assertEqual(0.0_wp, plane%torque, message=what//': torque')
      call assertLessThan(abs(plane%normal_force - space%normal_force), same_contact*scale, message=what//': contact')
      call assertLessThan(plane%equilibrium_force, 1.0e-8_wp*scale, message=what//': balance')
      call assertEqual(space%elements, plane%elements, message=what//': elements')
      call assertEqual(space%states, plane%states, message=what//': states')
      call assertLessThan(real(abs(space%iterations - plane%iterations), wp), 2.5_wp, message=what//': iterations')
      call alike(space%profile%axial, plane%profile%axial, 'axial force')
      call alike(space%profile%bending, plane%profile%bending, 'bending moment')
      call alike(space%profile%shear, plane%profile%shear, 'shear')
      call alike(space%profile%side_force, plane%profile%side_force, 'side force')
      call alike(space%profile%displacement, plane%profile%displacement, 'displacement')
      call assertEqual(space%profile%gap_state, plane%profile%gap_state, message=what//': contact states')
      call assertEqual(space%bit_tilt, plane%bit_tilt, 1.0e-8_wp, message=what//': tilt of the bit')

   contains

      subroutine alike(one, other, name)
         real(wp), intent(in) :: one(:), other(:)
         character(*), intent(in) :: name
         call note(what//': difference in '//name, maxval(abs(one - other))/max(maxval(abs(one)), tiny(scale)))
         call assertLessThan(maxval(abs(one - other)), max(same_profile*maxval(abs(one)), 1.0e-9_wp), message=what//': '//name)
      end subroutine alike
   end subroutine compare

   !> Vertical, build, hold, drop at an azimuth: out, in, sliding with a little weight on the bit, standing still; ends held and
   !> free.
   subroutine test_build_hold_drop()
      type(model_type) :: model
      integer, parameter :: operation(4) = [operation_trip_out, operation_trip_in, operation_sliding_drilling, operation_static]
      character(*), parameter :: name(4) = [character(7) :: 'out', 'in', 'sliding', 'static']
      integer :: i, ends
      do i = 1, size(operation)
         do ends = 1, 2
            call new_well(model, [0.0_wp, 300.0_wp, 700.0_wp, 1100.0_wp, 1500.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp, 15.0_wp], &
                          spread(130.0_wp, 1, 5), 0.2159_wp, 0.25_wp, pipe(w, od, id))
            model%cases(1)%operation = operation(i)
            if (operation(i) == operation_sliding_drilling) model%cases(1)%wob = 5.0e3_wp
            model%boundary%top_centred = .true.
            model%boundary%bit_centred = ends == 1
            call compare(model, trim(name(i))//merge(', held', ', free', ends == 1))
         end do
      end do
   end subroutine test_build_hold_drop

   !> A lateral of 95 deg: going out, and lowered where it still slides by its weight.
   subroutine test_lateral()
      type(model_type) :: model
      integer :: i
      do i = 1, 2
         call new_well(model, [0.0_wp, 1500.0_wp, 1900.0_wp, 2000.0_wp], [0.0_wp, 0.0_wp, 95.0_wp, 95.0_wp], &
                       spread(211.0_wp, 1, 4), 0.2159_wp, merge(0.3_wp, 0.1_wp, i == 1), pipe(w, od, id))
         model%boundary%top_centred = .true.
         model%cases(1)%operation = merge(operation_trip_out, operation_trip_in, i == 1)
         call compare(model, merge('lateral, out', 'lateral, in ', i == 1))
      end do
   end subroutine test_lateral

   !> In an exactly vertical hole any vertical plane will do: the string hangs on the axis, the hook load is its weight.
   subroutine test_vertical()
      type(model_type) :: model
      call new_well(model, [0.0_wp, 800.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.2159_wp, 0.25_wp, pipe(w, od, id))
      call hold_ends(model)
      model%cases(1)%operation = operation_trip_out
      call compare(model, 'vertical')
   end subroutine test_vertical

   !> Collars, heavy-weight and drill pipe in mud, with tool joints that touch one by one, and with a stiff wall.
   subroutine test_assembly()
      type(model_type) :: model
      integer :: i
      do i = 1, 3
         call three_part_well(model, [0.0_wp, 400.0_wp, 900.0_wp, 1600.0_wp], [0.0_wp, 0.0_wp, 50.0_wp, 50.0_wp], 900.0_wp)
         model%cases(1)%operation = operation_trip_out
         if (i == 2) then
            model%strings(1)%components(3)%joint_spacing = 9.5_wp
            model%strings(1)%components(3)%joint_length = 0.5_wp
            model%numerics%discrete_joints = .true.
         end if
         if (i == 3) then
            model%numerics%gk_contact = 1.0e9_wp
            model%numerics%gk_max = 1.0e10_wp
         end if
         call compare(model, 'assembly')
      end do
   end subroutine test_assembly

   !> A string in a hole that is vertical, builds to 40 deg and holds.
   subroutine build_and_hold(model, operation)
      type(model_type), intent(out) :: model
      integer, intent(in) :: operation
      call new_well(model, [0.0_wp, 300.0_wp, 700.0_wp, 1100.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], &
                    spread(300.0_wp, 1, 4), 0.2159_wp, 0.25_wp, pipe(w, od, id))
      model%boundary%top_centred = .true.
      model%cases(1)%operation = operation
   end subroutine build_and_hold

   !> Gaps at the nodes, load steps, the other linear solvers.
   subroutine test_settings()
      type(model_type) :: model
      integer :: i
      do i = 1, 4
         call build_and_hold(model, operation_trip_out)
         if (i == 1) model%numerics%gap_location = gap_at_nodes
         if (i == 2) model%numerics%load_steps = 3
         if (i == 3) model%numerics%linear_solver = solver_banded
         if (i == 4) model%numerics%linear_solver = solver_sparse
         call compare(model, 'settings')
      end do
      call assertTrue(all([ask('auto'), ask('fast')]), message='auto and fast ask for planes')
      call assertFalse(any([ask('standard'), ask('reference')]), message='standard and reference do not')

   contains

      function ask(fidelity) result(yes)
         character(*), intent(in) :: fidelity
         logical :: yes
         model%numerics = settings_of(fidelity)
         yes = model%numerics%in_plane
      end function ask
   end subroutine test_settings

   !> A mesh fine enough to be started from a coarse one, both in the plane.
   subroutine test_fine_mesh()
      type(model_type) :: model
      call build_and_hold(model, operation_trip_in)
      model%numerics%element_length = 0.7_wp
      model%numerics%gap_location = gap_at_nodes   ! where those at their extremum come to stand depends on the way, by 1.5e-7
      call compare(model, 'fine')
   end subroutine test_fine_mesh

   !> Not in the plane: a hole that turns, a string that turns, torque on the bit, a string compressed beyond a quarter of its
   !> coiling load.
   subroutine test_space_where_it_must()
      integer, parameter :: operation(4) = [operation_trip_out, operation_rotate_off_bottom, operation_sliding_drilling, &
                                            operation_sliding_drilling]
      integer, parameter :: way(4) = [way_turns, way_rotates, way_rotates, way_buckles]
      real(wp), parameter :: turn(4) = [0.01_wp, 0.0_wp, 0.0_wp, 0.0_wp], tob(4) = [0.0_wp, 0.0_wp, 500.0_wp, 0.0_wp]
      real(wp), parameter :: wob(4) = [0.0_wp, 0.0_wp, 1.0e3_wp, 8.0e4_wp]
      type(model_type) :: model
      type(case_result_type) :: asked, not_asked
      type(error_type), allocatable :: error
      integer :: i
      do i = 1, size(way)
         call new_well(model, [0.0_wp, 300.0_wp, 700.0_wp, 900.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], &
                       [0.0_wp, 0.0_wp, 0.0_wp, turn(i)], 0.2159_wp, 0.25_wp, pipe(w, od, id))
         call hold_ends(model)
         model%cases(1)%operation = operation(i)
         model%cases(1)%wob = wob(i)
         model%cases(1)%tob = tob(i)
         call solve_static_analysis(model, 1, not_asked, error)
         model%numerics%in_plane = .true.
         call solve_static_analysis(model, 1, asked, error)
         call assertEqual(result_converged, asked%status)
         call assertEqual(way(i), asked%way, message='why')
         call assertEqual(not_asked%hookload, asked%hookload, message='the same solution to the digit')
         call assertEqual(not_asked%iterations, asked%iterations)
      end do
   end subroutine test_space_where_it_must

   !> A plane as far as the string reaches while it is not stretched; under its weight the bit hangs some centimetres below, where
   !> the hole turns aside. The bit's support pushes it out of the plane: what was solved in it is not believed, and space has the
   !> answer that it had without.
   subroutine test_space_decides()
      type(model_type) :: model
      type(case_result_type) :: asked, not_asked
      type(error_type), allocatable :: error
      call new_well(model, [0.0_wp, 900.0_wp, 1500.0_wp, 1530.0_wp], [0.0_wp, 0.0_wp, 30.0_wp, 30.0_wp], &
                    [50.0_wp, 50.0_wp, 50.0_wp, 110.0_wp], 0.2159_wp, 0.25_wp, pipe(w, od, id))
      call hold_ends(model)
      model%cases(1)%operation = operation_trip_out
      model%cases(1)%bit_depth = 1500.0_wp
      call solve_static_analysis(model, 1, not_asked, error)
      model%numerics%in_plane = .true.
      call solve_static_analysis(model, 1, asked, error)
      call assertEqual(result_converged, asked%status)
      call assertEqual(way_left, asked%way, message='way')
      call assertEqual(not_asked%hookload, asked%hookload, message='the same solution to the digit')
      call assertGreaterThan(asked%iterations, not_asked%iterations, message='iterations in the plane are counted')
   end subroutine test_space_decides
end module dg_test_plane

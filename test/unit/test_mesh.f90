!> The mesh of a load case, and the predicted start laid on it.
module dg_test_mesh
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_centralizer, only: centralizer_type
   use dg_case_result, only: scale_count
   use dg_component, only: buoyed_weight, component_type
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_gap_state, only: gap_law_type, state_elastic, state_free
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_hole_section, only: hole_section_type, wall_of
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_trip_out
   use dg_mesh, only: graded, mesh_type, new_mesh, node_depths, subdivided
   use dg_mesh_for_case, only: mesh_for_case
   use dg_missing, only: given
   use dg_model, only: model_type
   use dg_predictor, only: predict, start_type
   use dg_soft_string_loads, only: soft_string_at, soft_totals_type
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory, position_at
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: mesh_suite

contains

   function mesh_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('mesh')
      call suite%addTest(TestMethod('nodes_at_every_change', test_nodes_at_every_change))
      call suite%addTest(TestMethod('no_sliver', test_no_sliver))
      call suite%addTest(TestMethod('ends_of_components', test_ends_of_components))
      call suite%addTest(TestMethod('step_beside_edge', test_step_beside_edge))
      call suite%addTest(TestMethod('centralizers', test_centralizers))
      call suite%addTest(TestMethod('subdivided', test_subdivided))
      call suite%addTest(TestMethod('graded', test_graded))
      call suite%addTest(TestMethod('sag', test_sag))
      call suite%addTest(TestMethod('properties', test_properties))
      call suite%addTest(TestMethod('walls', test_walls))
      call suite%addTest(TestMethod('geometry', test_geometry))
      call suite%addTest(TestMethod('predicted_start', test_predicted_start))
   end function mesh_suite

   !> 300 m of well with a bend, two hole sections, collars of 40 m under pipe.
   subroutine build(model)
      type(model_type), intent(out) :: model
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, 101.0_wp, 173.0_wp, 300.0_wp], [30.0_wp, 30.0_wp, 50.0_wp, 60.0_wp]*degree, &
                          [10.0_wp, 10.0_wp, 25.0_wp, 25.0_wp]*degree, interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(2), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('cased', 0.0_wp, 130.0_wp, 0.22_wp, 0.2_wp, 0.25_wp, 3.0e7_wp, 0.001_wp)
      model%holes(2) = hole_section_type('open', 130.0_wp, 300.0_wp, 0.21_wp, 0.3_wp, 0.35_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(2))
      model%strings(1)%components(1) = component_type('collar', 'collar', 40.0_wp, 0.16_wp, 0.07_wp, 130.0_wp)
      model%strings(1)%components(2) = component_type('pipe', 'drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 31.0_wp, joint_od=0.165_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = 291.0_wp
      model%cases(1)%operation = operation_trip_out
      model%mud = standing_mud(1200.0_wp)
   end subroutine build

   !> Stations 101 and 173, shoe 130, collar top 291 - 40 = 251, between them equal parts of at most 10 m.
   subroutine test_nodes_at_every_change()
      type(model_type) :: model
      real(wp), allocatable :: md(:), gaps(:)
      real(wp), parameter :: wanted(6) = [0.0_wp, 101.0_wp, 130.0_wp, 173.0_wp, 251.0_wp, 291.0_wp]
      integer :: i
      call build(model)
      allocate (md, source=node_depths(model, model%cases(1), 10.0_wp))
      do i = 1, size(wanted)
         call assertEqual(1, count(abs(md - wanted(i)) < 1.0e-12_wp), message='a node at every change, once')
      end do
      allocate (gaps, source=md(2:) - md(:size(md) - 1))
      call assertLessThan(maxval(gaps), 10.0_wp*1.0011_wp, message='longest element')
      call assertLessThan(0.0_wp, minval(gaps), message='ascending')
      call assertEqual(11 + 3 + 5 + 8 + 4, size(gaps), message='no more elements than asked for')
      call assertEqual(0.0_wp, md(1))
      call assertEqual(291.0_wp, md(size(md)), message='the bit, to the last bit')
   end subroutine test_nodes_at_every_change

   !> A shoe a millimetre under a station makes no element of a millimetre.
   subroutine test_no_sliver()
      type(model_type) :: model
      real(wp), allocatable :: md(:)
      call build(model)
      model%holes(:)%md_bottom = [173.001_wp, 300.0_wp]
      allocate (md, source=node_depths(model, model%cases(1), 10.0_wp))
      call assertEqual(1, count(abs(md - 173.0_wp) < 1.0_wp))
      model%holes(:)%md_bottom = [290.999_wp, 300.0_wp]
      deallocate (md)
      allocate (md, source=node_depths(model, model%cases(1), 10.0_wp))
      call assertEqual(1, count(abs(md - 291.0_wp) < 1.0_wp), message='nor at the bit')
   end subroutine test_no_sliver

   !> Elements as long as a deck may have them: a stabilizer, cut into pieces, under pipe has nodes at its ends.
   subroutine test_ends_of_components()
      type(model_type) :: model
      type(component_type) :: blades
      real(wp), allocatable :: md(:)
      real(wp), parameter :: wanted(2) = [249.2_wp, 251.0_wp], longest = 1000.0_wp
      integer :: i
      call build(model)
      blades = component_type('blades', 'stabilizer', 1.8_wp, 0.16_wp, 0.07_wp, 150.0_wp, joint_od=0.2_wp)
      model%strings(1)%components = [model%strings(1)%components(1), blades, model%strings(1)%components(2)]
      allocate (md, source=node_depths(model, model%cases(1), longest))
      do i = 1, size(wanted)
         call assertEqual(1, count(abs(md - wanted(i)) < 1.0e-9_wp), message='a node at every end, once')
      end do
   end subroutine test_ends_of_components

   !> A hole section that ends 2 mm and more below the upper end of the collars, at 251: that end stays in it.
   subroutine test_step_beside_edge()
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp), parameter :: below(3) = [0.002_wp, 0.01_wp, 0.05_wp]
      integer :: i, e
      call build(model)
      do i = 1, size(below)
         model%holes(:)%md_bottom = [251.0_wp + below(i), 300.0_wp]
         model%holes(2)%md_top = model%holes(1)%md_bottom
         call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 1000.0_wp), mesh)
         e = count(mesh%md < 251.0_wp + 0.5_wp*below(i))
         call assertEqual(251.0_wp, mesh%md(e), 1.0e-9_wp, message='the end of the collars')
         call assertEqual(0.5_wp*(0.22_wp - 0.16_wp), mesh%clearance(e), 1.0e-12_wp, message='in the upper hole')
         call assertEqual(0.5_wp*(0.21_wp - 0.16_wp), mesh%clearance(e + 1), 1.0e-12_wp, message='in the lower one')
      end do
   end subroutine test_step_beside_edge

   !> Bow springs every 12 m from 5 m above the lower end of the pipe, which stands at 251: 246, 234 ... Each has an element of half
   !> a metre, a load of 24 times the mean, and the stiffness of its rating, 6 kN at 0.33 of 20 mm.
   subroutine test_centralizers()
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp), parameter :: length = 0.5_wp
      integer :: e
      call build(model)
      model%strings(1)%components(2)%joint_od = 0.0_wp
      associate (centralizer => model%strings(1)%components(2)%centralizer, pipe => model%strings(1)%components(2))
         centralizer = centralizer_type(present=.true., bow=.true., od=0.215_wp, spacing=12.0_wp, first=5.0_wp, &
                                        restoring_force=6.0e3_wp, rated_hole=pipe%od + 0.04_wp, running_force=700.0_wp)
         call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 3.0_wp), mesh)
         call assertEqual(21, count(mesh%centralizer), message='one each from 246 m to 6 m')
         do e = 1, mesh%elements
            if (.not. mesh%centralizer(e)) cycle
            call assertEqual(length, mesh%length(e), 1.0e-9_wp, message='length')
            call assertEqual(0.0_wp, modulo(246.0_wp - mesh%md(e) - 0.5_wp*length + 1.0e-6_wp, 12.0_wp), 1.0e-5_wp, message='place')
            call assertRelativelyEqual(6.0e3_wp/(0.33_wp*0.02_wp), mesh%wall(e)*mesh%length(e), 1.0e-9_wp, message='stiffness')
            call assertRelativelyEqual(24.0_wp, mesh%load_factor(e), 1.0e-9_wp)
            ! cased with 220 mm, which the bow does not fill, below 130 m with 210 mm, which is narrower
            call assertEqual(merge(2.5e-3_wp, 0.0_wp, mesh%md(e) < 130.0_wp), mesh%opening(e), 1.0e-5_wp, message='opening')
            call assertEqual(merge(0.0_wp, 700.0_wp, mesh%md(e) < 130.0_wp), mesh%drag(e), 1.0e-6_wp, message='drag, pulled')
         end do
         call assertEqual(0.0_wp, sum(mesh%drag, mask=.not. mesh%centralizer), message='none between')
         centralizer%bow = .false.
         centralizer%od = 0.2_wp
         call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 3.0_wp), mesh)
         call assertEqual(0.1_wp, pack(mesh%radius, mesh%centralizer), 1.0e-12_wp, message='rigid ones rub at their blades')
         call assertEqual(0.0_wp, maxval(abs(mesh%opening - mesh%clearance)), message='and do not give way')
      end associate
   end subroutine test_centralizers

   subroutine test_subdivided()
      call assertEqual([0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.5_wp, 6.0_wp], &
                       subdivided([0.0_wp, 3.0_wp, 6.0_wp], [1.0_wp, 2.9_wp]), 1.0e-15_wp)
      call assertEqual([2.0_wp, 3.0_wp], subdivided([2.0_wp, 3.0_wp], [1.0_wp]), 1.0e-15_wp)
   end subroutine test_subdivided

   !> 4 m cut to elements of 1 m, with 32 m before it and 35 m behind it: elements of at most 2, 4, 8 and 16 m from there on. A
   !> short interval that was not cut, the third, makes none of its neighbours short.
   subroutine test_graded()
      real(wp), parameter :: depths(6) = [0.0_wp, 32.0_wp, 36.0_wp, 71.0_wp, 71.5_wp, 100.0_wp]
      real(wp), allocatable :: finer(:), length(:)
      integer :: e
      finer = graded(depths, [40.0_wp, 1.0_wp, 40.0_wp, 40.0_wp, 40.0_wp], 2.0_wp)
      length = finer(2:) - finer(:size(finer) - 1)
      do e = 1, size(depths)
         call assertLessThan(minval(abs(finer - depths(e))), 1.0e-12_wp, message='kept')
      end do
      call assertEqual([16.0_wp, 8.0_wp, 4.0_wp, 2.0_wp, 2.0_wp], length(:5), 1.0e-12_wp, message='before')
      call assertEqual(1.0_wp, length(6:9), 1.0e-12_wp, message='what was cut')
      do e = 10, size(length) - 2
         call assertLessThan(length(e), 2.01_wp*length(e - 1), message='behind')
      end do
      call assertEqual([0.5_wp, 28.5_wp], length(size(length) - 1:), 1.0e-12_wp, message='far behind')
      call assertEqual(subdivided(depths, [1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp]), &
                       graded(depths, [1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp], 2.0_wp), 1.0e-12_wp, message='short everywhere')
   end subroutine test_graded

   !> A string along a level hole may sag between two gaps by a fifth of the clearance, and no element is shorter than that asks
   !> for: fixed ends hold it by q l^4/(384 EI) as a beam, and under tension T by q l^2/(8 T) as a rope, both side by side. 30 m
   !> take four parts without tension, two with 2 MN.
   subroutine test_sag()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(soft_totals_type) :: totals
      type(error_type), allocatable :: error
      real(wp), parameter :: pull(2) = [0.0_wp, 2.0e6_wp], level(2) = 90.0_wp*degree
      integer, parameter :: parts(2) = [4, 2]
      real(wp) :: compressed, strained, pressing
      integer :: i, shortened(scale_count)
      call build(model)
      call new_trajectory(model%trajectory, [0.0_wp, 300.0_wp], level, [0.0_wp, 0.0_wp], interpolation_minimum_curvature, error)
      model%holes = [hole_section_type('open', 0.0_wp, 300.0_wp, 0.21_wp)]
      model%strings(1)%components = [model%strings(1)%components(2)]
      model%cases(1)%bit_depth = 300.0_wp
      do i = 1, size(pull)
         model%cases(1)%wob = -pull(i)
         call mesh_for_case(model, 1, 30.0_wp, mesh, totals, compressed, strained, pressing, shortened)
         call assertEqual(10*parts(i), mesh%elements, message='parts')
         call assertLessThan(sag(30.0_wp/parts(i)), 0.2_wp, message='bears it')
         call assertLessThan(0.2_wp, sag(30.0_wp/(parts(i) - 1)), message='no shorter than that')
      end do

   contains

      pure function sag(length) result(over_clearance)
         real(wp), intent(in) :: length
         real(wp) :: over_clearance
         over_clearance = mesh%weight(1)/(384.0_wp*mesh%section(1)%ei/length**4 + 8.0_wp*pull(i)/length**2)/mesh%clearance(1)
      end function sag
   end subroutine test_sag

   subroutine test_properties()
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp) :: middle, w
      integer :: e
      call build(model)
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 10.0_wp), mesh)
      do e = 1, mesh%elements
         middle = 0.5_wp*(mesh%md(e) + mesh%md(e + 1))
         if (middle > 251.0_wp) then
            w = buoyed_weight(model%strings(1)%components(1), 1200.0_wp, 1200.0_wp, model%gravity)
            call assertEqual(0.08_wp, mesh%radius(e), 1.0e-15_wp, message='collar')
         else
            w = buoyed_weight(model%strings(1)%components(2), 1200.0_wp, 1200.0_wp, model%gravity)
            call assertEqual(0.0825_wp, mesh%radius(e), 1.0e-15_wp, message='joint')
         end if
         call assertEqual(w, mesh%weight(e))
         if (middle < 130.0_wp) then
            call assertEqual(0.2_wp, mesh%friction_along(e), message='cased')
            call assertEqual(0.0275_wp, mesh%clearance(e), 1.0e-15_wp)
            call assertEqual(3.0e7_wp, mesh%wall(e), message='the section''s wall')
            call assertEqual(2.0_wp*0.001_wp/(0.22_wp - 0.165_wp), mesh%eps_nmax(e), 1.0e-14_wp, message='2 t/(D - d)')
         else
            call assertEqual(0.3_wp, mesh%friction_along(e), message='open')
            call assertEqual(model%numerics%gk_contact, mesh%wall(e), message='the solver''s wall')
            call assertEqual(model%numerics%eps_nmax, mesh%eps_nmax(e))
         end if
      end do
      call assertEqual(0.0_wp, mesh%friction_around, message='no rotation')
      model%cases(1)%operation = operation_rotate_off_bottom
      model%cases(1)%friction_rotary = given(0.11_wp)
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 10.0_wp), mesh)
      call assertEqual(0.0_wp, mesh%friction_along, message='mu2 = 0 when rotating (Eq. 5)')
      call assertEqual(0.11_wp, mesh%friction_around, message='the case''s own friction')
   end subroutine test_properties

   !> Chords add up to the well path; frames are right-handed and unit.
   subroutine test_geometry()
      type(model_type) :: model
      type(mesh_type) :: mesh
      real(wp) :: position(3), tangent(3), product(3, 3)
      integer :: n, i
      call build(model)
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 10.0_wp), mesh)
      call position_at(model%trajectory, 291.0_wp, position, tangent)
      call assertEqual(position, sum(mesh%chord, dim=2), 1.0e-11_wp)
      do n = 1, mesh%nodes
         call position_at(model%trajectory, mesh%md(n), position, tangent)
         call assertEqual(tangent, mesh%frame(:, 1, n), 1.0e-14_wp)
         product = matmul(transpose(mesh%frame(:, :, n)), mesh%frame(:, :, n))
         do i = 1, 3
            product(i, i) = product(i, i) - 1.0_wp
         end do
         call assertEqual(0.0_wp, product, 1.0e-14_wp, message='orthonormal')
      end do
   end subroutine test_geometry

   !> Every element of the start carries the soft string's axial force and torque, and nodes lie at the wall on the side
   !> that the soft string names, pressed in by its contact force.
   subroutine test_predicted_start()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix
      type(gap_law_type) :: law
      real(wp), allocatable :: state(:, :), residual(:, :), axial(:), torque(:), contact(:, :), pressed(:), load(:)
      real(wp) :: force
      integer :: e, n, i, bending
      call build(model)
      model%boundary%top_centred = .false.
      model%boundary%bit_centred = .false.
      model%cases(1)%wob = -2.0e4_wp       ! in tension throughout: nothing is coiled or seeded
      model%cases(1)%tob = 500.0_wp
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 10.0_wp), mesh)
      law = gap_law_type(clearance=1.0_wp)
      gaps = new_gap_table([(law, e=1, mesh%elements)], 0.5_wp)
      allocate (state(6, mesh%nodes), residual(6, mesh%nodes), axial(mesh%nodes), torque(mesh%nodes), contact(3, mesh%nodes), &
                pressed(mesh%elements))
      call predict(model, 1, mesh, start_type(), spread(1.0_wp, 1, mesh%elements), state, gaps, pressed)
      call soft_string_at(model, 1, mesh%md, axial, torque, contact)
      call assertTrue(all(gaps%state == state_elastic), message='an inclined string touches everywhere')
      gaps%state = state_free
      call new_workspace(mesh, work)
      call place_nodes(mesh, state, work)
      matrix = new_block_matrix(mesh%nodes)
      call assemble(model%trajectory, mesh, load_type(), gaps, state, .false., work, residual, matrix)
      do e = 1, mesh%elements
         ! the secant ends at round-off of positions, 1e-15 m of some 10 m, times EA/L of 1e8 N/m
         call assertEqual(0.5_wp*(axial(e) + axial(e + 1)), work%axial(e), 1.0_wp, message='axial force')
         call assertEqual(-0.5_wp*(torque(e) + torque(e + 1)), work%torque(e), 1.0e-6_wp, message='torque')
      end do
      bending = 0
      do n = 1, mesh%nodes
         force = norm2(contact(:, n))
         e = min(n, mesh%elements)
         ! where it changes sides it comes off the wall, within 1.5 sqrt(EI/T) and an element; elsewhere it is bent along the wall
         if (any([(dot_product(contact(:, i), contact(:, i + 1)) < 0.0_wp .and. &
                   abs(0.5_wp*(mesh%md(i) + mesh%md(i + 1)) - mesh%md(n)) < &
                   1.5_wp*sqrt(mesh%section(e)%ei/abs(axial(n))) + 15.0_wp, i=1, mesh%elements)])) then
            bending = bending + 1
            call assertTrue(norm2(state(2:3, n)) < 1.1_wp*mesh%clearance(e), message='within the wall')
            cycle
         end if
         if (n == 1 .or. n == mesh%nodes) cycle      ! free ends
         if (maxval(abs(mesh%clearance(e) - mesh%clearance(max(n - 2, 1):min(n + 1, mesh%elements)))) > 0.0_wp) cycle
         call assertRelativelyEqual(mesh%clearance(e), norm2(state(2:3, n)), 0.1_wp, message='at the wall')
         call assertEqual(force, dot_product(contact(:, n), state(2, n)*mesh%frame(:, 2, n) + state(3, n)*mesh%frame(:, 3, n)) &
                          /norm2(state(2:3, n)), 0.05_wp*force, message='on the soft string''s side')
      end do
      call assertTrue(bending > 0 .and. bending < mesh%nodes/2, message='sides change, here and there')
      ! in the middle of elements: at their ends the weight may jump
      call soft_string_at(model, 1, mesh%md(2:) - 0.5_wp*mesh%length, axial(2:), torque(2:), contact(:, 2:))
      load = [(norm2(contact(:, e + 1))*mesh%length(e), e=1, mesh%elements)]
      call assertRelativelyEqual(sum(load), sum(pressed), 0.02_wp, message='contact force')
   end subroutine test_predicted_start

   !> Which wall a section of the hole has: its own, the solver's, or that of a mud sheath; none is stiffer than 1e13 N/m2.
   subroutine test_walls()
      real(wp), parameter :: contact = 1.0e11_wp, most = 1.0e12_wp
      type(hole_section_type) :: hole
      real(wp) :: elastic, rigid
      call wall_of(hole, contact, most, elastic, rigid)
      call assertEqual([contact, most], [elastic, rigid], message='the solver''s')
      hole%mud_sheath = 2.0e-3_wp
      call wall_of(hole, contact, most, elastic, rigid)
      call assertEqual([1.0e8_wp, most], [elastic, rigid], message='mud, and the solver''s wall behind it')
      hole%wall_stiffness = 3.0e6_wp
      call wall_of(hole, contact, most, elastic, rigid)
      call assertEqual([3.0e6_wp, most], [elastic, rigid], message='mud of a stiffness that is given')
      hole%mud_sheath = 0.0_wp
      call wall_of(hole, contact, most, elastic, rigid)
      call assertEqual([3.0e6_wp, 3.0e7_wp], [elastic, rigid], message='its own')
      hole%wall_stiffness = 1.0e15_wp
      call wall_of(hole, contact, most, elastic, rigid)
      call assertEqual([1.0e13_wp, 1.0e13_wp], [elastic, rigid], message='no stiffer than that')
   end subroutine test_walls
end module dg_test_mesh

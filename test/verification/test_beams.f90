!> Chains of the beam element alone, held and loaded as textbooks do and no string is: cantilever, elastica, columns,
!> a beam on three supports; and stretch and twist of a hanging string.
module dg_test_beams
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_assembly, only: assemble, load_type
   use dg_band_solver, only: band_factor, band_solve, band_solver_type, new_band_solver
   use dg_beam_element, only: beam_tangent
   use dg_beam_section, only: beam_section_type
   use dg_block_matrix, only: block_matrix_type, new_block_matrix
   use dg_component, only: axial_stiffness, torsional_stiffness
   use dg_constants, only: pi
   use dg_director, only: director, director_curvature, director_gradient
   use dg_gap_state, only: gap_law_type
   use dg_gap_table, only: gap_table_type, new_gap_table
   use dg_hermite, only: hermite_line_load
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_model, only: model_type
   use dg_positive_definite, only: block_positive_definite
   use dg_test_wells, only: new_well, note, pipe
   use dg_workspace, only: new_workspace, place_nodes, workspace_type
   implicit none
   private
   public :: beams_suite

   !> A chain along x of length and E I one; displacements in x, y, z, an idle unknown, slopes in y and z.
   type :: chain_type
      integer :: elements = 0
      type(beam_section_type) :: section
      logical, allocatable :: held(:, :)       !< (6,nodes)
      real(wp), allocatable :: load(:, :)      !< dead forces (3,nodes)
      real(wp) :: line_load(3) = 0.0_wp        !< dead, per length
      real(wp), allocatable :: state(:, :)     !< (6,nodes)
      real(wp), allocatable :: residual(:, :)  !< internal less external force; at held unknowns the reaction (6,nodes)
      type(block_matrix_type) :: matrix
   end type chain_type

   !> E A L**2/(E I): stretch is 1e-7 of the loads here, round-off of it 1e-9.
   real(wp), parameter :: axial = 1.0e7_wp
   !> x, y, z in columns.
   real(wp), parameter :: frame(3, 3) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [3, 3])

contains

   function beams_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('beams')
      call suite%addTest(TestMethod('cantilever', test_cantilever))
      call suite%addTest(TestMethod('elastica', test_elastica))
      call suite%addTest(TestMethod('elastica_converges', test_elastica_converges))
      call suite%addTest(TestMethod('rolled_into_a_circle', test_circle))
      call suite%addTest(TestMethod('euler_columns', test_euler_columns))
      call suite%addTest(TestMethod('column_under_its_weight', test_column_under_its_weight))
      call suite%addTest(TestMethod('three_supports', test_three_supports))
      call suite%addTest(TestMethod('stretch_and_twist', test_stretch_and_twist))
   end function beams_suite

   function new_chain(elements) result(chain)
      integer, intent(in) :: elements
      type(chain_type) :: chain
      real(wp) :: length
      length = 1.0_wp/elements
      chain%elements = elements
      chain%section = beam_section_type(length=length, membrane_length=length, ea=axial, ei=1.0_wp)
      allocate (chain%held(6, elements + 1), source=.false.)
      chain%held(4, :) = .true.
      allocate (chain%load(3, elements + 1), chain%state(6, elements + 1), chain%residual(6, elements + 1), source=0.0_wp)
      chain%matrix = new_block_matrix(elements + 1)
   end function new_chain

   !> Residual and tangent with `factor` times the loads.
   subroutine assemble_chain(chain, factor)
      type(chain_type), intent(inout) :: chain
      real(wp), intent(in) :: factor
      real(wp) :: d(3, chain%elements + 1), g(3, 2, chain%elements + 1), f(6, chain%elements + 1)
      real(wp) :: force(12), tension, k(12, 12), map_i(6, 6), map_j(6, 6), chord(3), weight(4)
      integer :: e, n, i
      do n = 1, chain%elements + 1
         d(:, n) = director(frame, chain%state(5:6, n))
         g(:, :, n) = director_gradient(frame, d(:, n))
      end do
      f = 0.0_wp
      chain%matrix%diagonal = 0.0_wp
      weight = hermite_line_load(chain%section%length)
      do e = 1, chain%elements
         chord = [chain%section%length, 0.0_wp, 0.0_wp] + chain%state(1:3, e + 1) - chain%state(1:3, e)
         call beam_tangent(chain%section, chord, d(:, e), d(:, e + 1), force, tension, k)
         do i = 1, 4
            force(3*i - 2:3*i) = force(3*i - 2:3*i) - factor*weight(i)*chain%line_load
         end do
         f(:, e) = f(:, e) + force(1:6)
         f(:, e + 1) = f(:, e + 1) + force(7:12)
         map_i = map_of(g(:, :, e))
         map_j = map_of(g(:, :, e + 1))
         chain%matrix%diagonal(:, :, e) = chain%matrix%diagonal(:, :, e) + matmul(transpose(map_i), matmul(k(1:6, 1:6), map_i))
         chain%matrix%diagonal(:, :, e + 1) = chain%matrix%diagonal(:, :, e + 1) &
            + matmul(transpose(map_j), matmul(k(7:12, 7:12), map_j))
         chain%matrix%upper(:, :, e) = matmul(transpose(map_i), matmul(k(1:6, 7:12), map_j))
         chain%matrix%lower(:, :, e) = matmul(transpose(map_j), matmul(k(7:12, 1:6), map_i))
      end do
      do n = 1, chain%elements + 1
         f(1:3, n) = f(1:3, n) - factor*chain%load(:, n)
         chain%residual(1:3, n) = f(1:3, n)
         chain%residual(4, n) = 0.0_wp
         chain%residual(5:6, n) = matmul(f(4:6, n), g(:, :, n))
         chain%matrix%diagonal(5:6, 5:6, n) = chain%matrix%diagonal(5:6, 5:6, n) &
            + director_curvature(frame, d(:, n), f(4:6, n))
      end do
      do n = 1, chain%elements + 1
         do i = 1, 6
            if (.not. chain%held(i, n)) cycle
            chain%matrix%diagonal(i, :, n) = 0.0_wp
            chain%matrix%diagonal(:, i, n) = 0.0_wp
            chain%matrix%diagonal(i, i, n) = 1.0_wp
            if (n <= chain%elements) chain%matrix%upper(i, :, n) = 0.0_wp
            if (n <= chain%elements) chain%matrix%lower(:, i, n) = 0.0_wp
            if (n > 1) chain%matrix%lower(i, :, n - 1) = 0.0_wp
            if (n > 1) chain%matrix%upper(:, i, n - 1) = 0.0_wp
         end do
      end do
   end subroutine assemble_chain

   !> From a node's six unknowns to its position and director.
   pure function map_of(gradient) result(map)
      real(wp), intent(in) :: gradient(3, 2)
      real(wp) :: map(6, 6)
      map = 0.0_wp
      map(1:3, 1:3) = frame
      map(4:6, 5:6) = gradient
   end function map_of

   !> Equilibrium under the loads, brought on in steps. The last state's tangent and residual stay in the chain.
   subroutine find_equilibrium(chain, steps)
      type(chain_type), intent(inout) :: chain
      integer, intent(in) :: steps
      type(band_solver_type) :: solver
      real(wp) :: change(6, chain%elements + 1)
      integer :: step, iteration, info
      solver = new_band_solver(chain%elements + 1)
      do step = 1, steps
         do iteration = 1, 40
            call assemble_chain(chain, real(step, wp)/steps)
            change = merge(0.0_wp, -chain%residual, chain%held)
            if (iteration > 2 .and. maxval(abs(change)) < 1.0e-8_wp) exit
            call band_factor(solver, chain%matrix, info)
            call assertEqual(0, info, message='regular')
            call band_solve(solver, change)
            chain%state = chain%state + change
         end do
         call assertLessThan(iteration, 40, message='converges')
      end do
   end subroutine find_equilibrium

   function stable(chain) result(definite)
      type(chain_type), intent(in) :: chain
      logical :: definite
      real(wp) :: nothing(6, chain%elements + 1)
      nothing = 0.0_wp
      call block_positive_definite(chain%matrix, 0.0_wp, nothing, definite)
   end function stable

   !> P L**3/(3 EI), slope P L**2/(2 EI), reaction moment P L: one element is exact.
   subroutine test_cantilever()
      type(chain_type) :: chain
      real(wp), parameter :: p = 1.0e-4_wp
      chain = new_chain(1)
      chain%held(:, 1) = .true.
      chain%load(:, 2) = [0.0_wp, p, 0.0_wp]
      call find_equilibrium(chain, 1)
      ! The square of the deflection is 1e-9; forces are balanced to 1e-8 of E I/L**2, 1e-4 of the load times 1e-8.
      call assertRelativelyEqual(p/3.0_wp, chain%state(2, 2), 1.0e-7_wp, message='deflection')
      call assertRelativelyEqual(p/2.0_wp, chain%state(5, 2), 1.0e-7_wp, message='slope')
      call assertRelativelyEqual(-p, chain%residual(5, 1), 1.0e-6_wp, message='moment at the clamp')
      call assertRelativelyEqual(-p, chain%residual(2, 1), 1.0e-6_wp, message='force at the clamp')
   end subroutine test_cantilever

   !> Tip of the elastica under a dead load P across (Bisshopp & Drucker 1945), by quadrature: with p**2 = (1 + sin(phi))/2,
   !> phi the tip's angle, sin(psi_0) = 1/(p sqrt 2) and ds = dpsi/(alpha sqrt(1 - p**2 sin(psi)**2)), alpha**2 = P/EI:
   !> L = integral of ds from psi_0 to pi/2 gives phi, deflection = integral of (2 p**2 sin(psi)**2 - 1) ds,
   !> shortening L - sqrt(2 sin(phi))/alpha.
   subroutine exact_tip(load, deflection, distance, angle)
      real(wp), intent(in) :: load
      real(wp), intent(out) :: deflection, distance, angle
      real(wp) :: lower, upper, length
      integer :: i
      lower = 1.0e-6_wp
      upper = 0.5_wp*pi - 1.0e-9_wp
      do i = 1, 60
         angle = 0.5_wp*(lower + upper)
         call integrals(angle, length, deflection)
         if (length < sqrt(load)) then
            lower = angle
         else
            upper = angle
         end if
      end do
      deflection = deflection/sqrt(load)
      distance = sqrt(2.0_wp*sin(angle)/load)
   end subroutine exact_tip

   pure subroutine integrals(angle, length, deflection)
      real(wp), intent(in) :: angle
      real(wp), intent(out) :: length, deflection
      integer, parameter :: n = 4000
      real(wp) :: square, first, width, psi, ds
      integer :: i
      square = 0.5_wp*(1.0_wp + sin(angle))
      first = asin(1.0_wp/sqrt(2.0_wp*square))
      width = (0.5_wp*pi - first)/n
      length = 0.0_wp
      deflection = 0.0_wp
      do i = 0, n                                   ! Simpson
         psi = first + i*width
         ds = width/3.0_wp*merge(merge(4.0_wp, 2.0_wp, modulo(i, 2) == 1), 1.0_wp, i > 0 .and. i < n) &
              /sqrt(1.0_wp - square*sin(psi)**2)
         length = length + ds
         deflection = deflection + (2.0_wp*square*sin(psi)**2 - 1.0_wp)*ds
      end do
   end subroutine integrals

   subroutine bend_cantilever(elements, load, chain)
      integer, intent(in) :: elements
      real(wp), intent(in) :: load
      type(chain_type), intent(out) :: chain
      chain = new_chain(elements)
      chain%held(:, 1) = .true.
      chain%load(:, elements + 1) = load*[0.0_wp, 0.6_wp, 0.8_wp]   ! out of both planes
      call find_equilibrium(chain, 10)
   end subroutine bend_cantilever

   !> P L**2/EI = 1, 2, 3 and 10, with 20 elements. Mattiasson (1981) prints 0.30172, 0.49346, 0.60325 and 0.81061.
   subroutine test_elastica()
      real(wp), parameter :: load(4) = [1.0_wp, 2.0_wp, 3.0_wp, 10.0_wp]
      real(wp), parameter :: printed(4) = [0.30172_wp, 0.49346_wp, 0.60325_wp, 0.81061_wp]
      !> Fourth order in the turn of an element, at 10 some 0.15 rad at the clamp. Seen: 3e-8, 8e-8, 1.2e-7, 5e-7.
      real(wp), parameter :: tolerance = 1.0e-6_wp
      type(chain_type) :: chain
      real(wp) :: deflection, distance, angle, tip(3)
      integer :: i
      do i = 1, size(load)
         call exact_tip(load(i), deflection, distance, angle)
         call assertEqual(printed(i), deflection, 0.5e-5_wp, message='quadrature')
         call bend_cantilever(20, load(i), chain)
         tip = chain%state(1:3, 21)
         call note('elastica: deflection', norm2(tip(2:3)) - deflection)
         call note('elastica: shortening', 1.0_wp + tip(1) - distance)
         call note('elastica: angle', atan(norm2(chain%state(5:6, 21))) - angle)
         call assertEqual(deflection, norm2(tip(2:3)), tolerance, message='deflection')
         call assertEqual(distance, 1.0_wp + tip(1), tolerance, message='distance of the tip')
         call assertEqual(angle, atan(norm2(chain%state(5:6, 21))), tolerance, message='angle')
         call assertEqual(0.75_wp, tip(2)/tip(3), 1.0e-7_wp, message='in the plane of the load')
         call assertRelativelyEqual(load(i)*distance, norm2(chain%residual(5:6, 1)), 1.0e-5_wp, message='moment at the clamp')
         call assertTrue(stable(chain), message='stable')
      end do
   end subroutine test_elastica

   !> Twice the elements, a sixteenth of the error.
   subroutine test_elastica_converges()
      type(chain_type) :: chain
      real(wp) :: deflection, distance, angle, error(3)
      integer :: i
      call exact_tip(3.0_wp, deflection, distance, angle)
      do i = 1, 3
         call bend_cantilever(2*2**i, 3.0_wp, chain)
         error(i) = abs(norm2(chain%state(2:3, 2*2**i + 1)) - deflection)
         call note('elastica: error of 4, 8, 16 elements', error(i))
      end do
      call assertLessThan(error(2), error(1)/8.0_wp, message='4 to 8')
      call assertLessThan(error(3), error(2)/8.0_wp, message='8 to 16')
   end subroutine test_elastica_converges

   !> An end moment M rolls a cantilever to an arc of curvature M/EI; 60 deg in all, within what slopes bear. The moment is a
   !> force on the director across it, M = d x f.
   subroutine test_circle()
      type(chain_type) :: chain
      type(band_solver_type) :: solver
      real(wp), parameter :: angle = pi/3.0_wp
      integer, parameter :: elements = 10
      real(wp) :: change(6, elements + 1), moment(2)
      integer :: iteration, step, info
      chain = new_chain(elements)
      chain%held(:, 1) = .true.
      solver = new_band_solver(elements + 1)
      do step = 1, 5
         do iteration = 1, 30
            call assemble_chain(chain, 0.0_wp)
            ! work M d(angle), angle = atan(slope): conjugate to the slope is M/(1 + slope**2)
            moment = [angle*step/5.0_wp/(1.0_wp + chain%state(5, elements + 1)**2), 0.0_wp]
            chain%residual(5:6, elements + 1) = chain%residual(5:6, elements + 1) - moment
            chain%matrix%diagonal(5, 5, elements + 1) = chain%matrix%diagonal(5, 5, elements + 1) &
               + 2.0_wp*chain%state(5, elements + 1)*moment(1)/(1.0_wp + chain%state(5, elements + 1)**2)
            change = merge(0.0_wp, -chain%residual, chain%held)
            if (maxval(abs(change)) < 1.0e-8_wp) exit
            call band_factor(solver, chain%matrix, info)
            call band_solve(solver, change)
            chain%state = chain%state + change
         end do
         call assertLessThan(iteration, 30, message='converges')
      end do
      call note('circle: angle', atan(chain%state(5, elements + 1)) - angle)
      call note('circle: deflection', chain%state(2, elements + 1) - (1.0_wp - cos(angle))/angle)
      call note('circle: distance', 1.0_wp + chain%state(1, elements + 1) - sin(angle)/angle)
      call assertEqual(angle, atan(chain%state(5, elements + 1)), 1.0e-6_wp, message='angle')
      call assertEqual((1.0_wp - cos(angle))/angle, chain%state(2, elements + 1), 1.0e-5_wp, message='deflection')
      call assertEqual(sin(angle)/angle, 1.0_wp + chain%state(1, elements + 1), 1.0e-5_wp, message='distance')
   end subroutine test_circle

   !> The tangent loses definiteness at Euler's loads, P L**2/EI: pi**2/4 clamped and free, pi**2 pinned, 20.190729 (tan k = k)
   !> clamped and pinned, 4 pi**2 clamped at both ends. Ten elements are 1e-5 above, (k/10)**4/720.
   subroutine test_euler_columns()
      real(wp), parameter :: critical(4) = [0.25_wp*pi**2, pi**2, 20.190729_wp, 4.0_wp*pi**2], margin = 5.0e-4_wp
      type(chain_type) :: chain
      integer, parameter :: elements = 10
      integer :: i, side
      do i = 1, 4
         do side = -1, 1, 2
            chain = new_chain(elements)
            chain%held(1:3, 1) = .true.
            chain%held(5:6, 1) = i /= 2                 ! clamped but for the second
            if (i > 1) chain%held(2:3, elements + 1) = .true.
            if (i == 4) chain%held(5:6, elements + 1) = .true.
            chain%load(1, elements + 1) = -critical(i)*(1.0_wp + side*margin)
            call find_equilibrium(chain, 1)
            if (side < 0) call assertTrue(stable(chain), message='just below')
            if (side > 0) call assertFalse(stable(chain), message='just above')
         end do
      end do
   end subroutine test_euler_columns

   !> Greenhill (1881): a column clamped below falls over at w L**3/EI = 7.837347 (first zero of the Bessel function of order
   !> -1/3, squared times 9/4).
   subroutine test_column_under_its_weight()
      type(chain_type) :: chain
      integer :: side
      do side = -1, 1, 2
         chain = new_chain(20)
         chain%held(:, 1) = .true.
         chain%line_load = [-7.837347_wp*(1.0_wp + side*2.0e-4_wp), 0.0_wp, 0.0_wp]
         call find_equilibrium(chain, 1)
         if (side < 0) call assertTrue(stable(chain), message='just below')
         if (side > 0) call assertFalse(stable(chain), message='just above')
      end do
   end subroutine test_column_under_its_weight

   !> Two spans l under w: 5/4 w l in the middle, 3/8 w l at the ends, moment w l**2/8 over the middle; nodes are exact.
   subroutine test_three_supports()
      type(chain_type) :: chain
      real(wp), parameter :: w = 1.0e-3_wp, span = 0.5_wp, tolerance = 1.0e-5_wp
      integer, parameter :: elements = 8, middle = elements/2 + 1
      chain = new_chain(elements)
      chain%held(1, 1) = .true.
      chain%held(2:3, [1, middle, elements + 1]) = .true.
      chain%line_load = [0.0_wp, 0.0_wp, w]
      call find_equilibrium(chain, 1)
      call assertRelativelyEqual(-1.25_wp*w*span, chain%residual(3, middle), tolerance, message='middle')
      call assertRelativelyEqual(-0.375_wp*w*span, chain%residual(3, 1), tolerance, message='end')
      call assertRelativelyEqual(-0.375_wp*w*span, chain%residual(3, elements + 1), tolerance, message='other end')
      ! largest deflection 0.0054 w l**4/EI at 0.42 l of a span; at mid-span w l**4/(192 EI)
      call assertRelativelyEqual(w*span**4/192.0_wp, chain%state(3, 3), tolerance, message='deflection at mid-span')
   end subroutine test_three_supports

   !> A string of two pipes hanging straight down: the bit sinks by the integral of F/EA and turns by the integral of T/GJ,
   !> both exact at the nodes.
   subroutine test_stretch_and_twist()
      type(model_type) :: model
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(workspace_type) :: work
      type(block_matrix_type) :: matrix
      type(band_solver_type) :: solver
      type(gap_law_type) :: law
      type(load_type) :: loads
      real(wp), allocatable :: state(:, :), residual(:, :)
      real(wp) :: ea(2), gj(2), sink, turn
      real(wp), parameter :: w(2) = [1500.0_wp, 262.0_wp], length(2) = [40.0_wp, 90.0_wp], wob = 2.0e4_wp, tob = 3.0e3_wp
      integer :: e, step, info
      call new_well(model, [0.0_wp, 130.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.3_wp, 0.0_wp, pipe(w(1), 0.16_wp, 0.07_wp))
      model%strings(1)%components = [pipe(w(1), 0.16_wp, 0.07_wp), pipe(w(2), 0.127_wp, 0.1086_wp)]
      model%strings(1)%components(1)%length = length(1)
      model%cases(1)%operation = operation_static
      ea = axial_stiffness(model%strings(1)%components)
      gj = torsional_stiffness(model%strings(1)%components)
      call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 13.0_wp), mesh)
      gaps = new_gap_table([(law, e=1, mesh%elements)], 0.5_wp)
      loads = load_type(wob=wob, tob=tob, top_support=1.0e6_wp, bit_support=1.0e6_wp)
      matrix = new_block_matrix(mesh%nodes)
      solver = new_band_solver(mesh%nodes)
      call new_workspace(mesh, work)
      allocate (state(6, mesh%nodes), residual(6, mesh%nodes), source=0.0_wp)
      do step = 1, 4
         call place_nodes(mesh, state, work)
         call assemble(model%trajectory, mesh, loads, gaps, state, .false., work, residual, matrix)
         call band_factor(solver, matrix, info)
         residual = -residual
         call band_solve(solver, residual)
         state = state + residual
      end do
      sink = (-wob*length(1) + 0.5_wp*w(1)*length(1)**2)/ea(1) &
             + ((w(1)*length(1) - wob)*length(2) + 0.5_wp*w(2)*length(2)**2)/ea(2)
      turn = -tob*(length(1)/gj(1) + length(2)/gj(2))
      call assertRelativelyEqual(sink, state(1, mesh%nodes), 1.0e-9_wp, message='stretch')
      call assertRelativelyEqual(turn, state(4, mesh%nodes), 1.0e-9_wp, message='twist')
      call assertRelativelyEqual(tob, work%top_torque, 1.0e-9_wp, message='torque at the top')
      call assertRelativelyEqual(sum(w*length) - wob, work%hookload, 1.0e-9_wp, message='hook load')
   end subroutine test_stretch_and_twist
end module dg_test_beams

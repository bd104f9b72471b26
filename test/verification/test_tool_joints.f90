!> Drill pipe that touches at its tool joints only: the bending moment between them in closed form, and where the body comes
!> to the wall.
!>
!> Paslay & Cernocky 1991 (SPE 22547): joints 2 L apart hold the pipe in a hole of curvature 1/R. By symmetry the pipe has the
!> hole's direction at joint and mid-span, so that the mean of its curvature is 1/R. Between, M'' = T M/(EI): with
!> k = sqrt(|T|/EI) the moment is EI/R times kL cosh(kx)/sinh(kL) in tension, kL cos(kx)/sin(kL) in compression, x from
!> mid-span: largest at the joint, kL/tanh(kL), or at mid-span, kL/sin(kL).
module dg_test_tool_joints
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: operation_sliding_drilling, operation_static
   use dg_model, only: model_type
   use dg_profile, only: state_free
   use dg_soft_string, only: solve_soft_string
   use dg_soft_string_loads, only: other_loads_type, soft_string_at
   use dg_solve_case, only: solve_case
   use dg_test_wells, only: hold_ends, new_well, note, pipe, solve, string_weight
   implicit none
   private
   public :: tool_joints_suite

   real(wp), parameter :: half = 4.75_wp              !< L, half the distance between joints [m]
   real(wp), parameter :: radius = 600.0_wp           !< R of the hole [m]
   real(wp), parameter :: depth = 24.0_wp*2.0_wp*half  !< of the bit [m]
   real(wp), parameter :: spans_below = 12.0_wp       !< between the bit and the joint looked at
   !> The closed form is that of joints of no length; these are 1/95 of the span.
   real(wp), parameter :: joint = 0.1_wp
   !> Where the moment is largest, 1.1e-3 is seen, of the joint's length and of elements of a tenth of a span.
   real(wp), parameter :: within = 2.0e-3_wp

contains

   function tool_joints_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('tool_joints')
      call suite%addTest(TestMethod('magnification_in_tension', test_tension))
      call suite%addTest(TestMethod('magnification_in_compression', test_compression))
      call suite%addTest(TestMethod('body_touches_between', test_body))
      call suite%addTest(TestMethod('buckled_between', test_buckled))
      call suite%addTest(TestMethod('bowed_between', test_bowed))
   end function tool_joints_suite

   !> Weightless pipe of 127 mm with joints of 168.3 mm in an arc; ends free.
   subroutine build(model, arc_radius)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: arc_radius   !< [m]
      type(component_type) :: component
      component = pipe(0.0_wp, 0.127_wp, 0.1086_wp)
      component%joint_od = 0.1683_wp
      component%joint_length = joint
      component%joint_spacing = 2.0_wp*half
      call new_well(model, [0.0_wp, depth], [0.0_wp, depth/arc_radius/degree], [0.0_wp, 0.0_wp], 0.2159_wp, 0.0_wp, component)
      model%numerics%discrete_joints = .true.
      model%numerics%element_length = 0.475_wp   ! an even number to a span: a node at mid-span
   end subroutine build

   !> Row of the profile nearest to a place in spans from the bit.
   pure function row(result, spans) result(i)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: spans
      integer :: i
      i = minloc(abs(result%profile%md - (depth - spans*2.0_wp*half)), dim=1)
   end function row

   !> Pipe under an axial force [N]: moments over EI/R at the joint in the middle of the string and at mid-span beside it. What the
   !> free ends disturb goes over from span to span, in compression of kL = 1.4 by a factor of 0.54: 7e-4 is left.
   subroutine solve_jointed(axial, at_joint, at_middle)
      real(wp), intent(in) :: axial
      real(wp), intent(out) :: at_joint, at_middle
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: unit
      call build(model, radius)
      unit = bending_stiffness(model%strings(1)%components(1))/radius
      call solve(model, operation_static, -axial, 0.0_wp, result, 'jointed pipe')
      ! A joint has a node at either end, and is held by its one gap in the middle.
      at_joint = maxval(result%profile%bending, mask=abs(result%profile%md - (depth - spans_below*2.0_wp*half)) < joint)/unit
      at_middle = result%profile%bending(row(result, spans_below - 0.5_wp))/unit
      call assertEqual(state_free, result%profile%gap_state(row(result, spans_below - 0.5_wp)), message='the body is free')
      call assertGreaterThan(result%profile%gap_state(row(result, spans_below)), state_free, message='the joint touches')
   end subroutine solve_jointed

   subroutine test_tension()
      real(wp), parameter :: kl(3) = [1.0_wp, 2.0_wp, 3.0_wp]
      real(wp) :: at_joint, at_middle, nodes
      integer :: i
      do i = 1, size(kl)
         call solve_jointed(stiffness()*(kl(i)/half)**2, at_joint, at_middle)
         call note('kL', kl(i))
         nodes = cosh(kl(i)*(1.0_wp - 0.5_wp*joint/half))/cosh(kl(i))      ! of the moment at the gap, half a joint from it
         call note('at the joint, over kL/tanh(kL)', at_joint/nodes*tanh(kl(i))/kl(i))
         call note('at mid-span, over kL/sinh(kL)', at_middle*sinh(kl(i))/kl(i))
         call assertRelativelyEqual(kl(i)/tanh(kl(i)), at_joint/nodes, within, message='at the joint')
         call assertRelativelyEqual(kl(i)/sinh(kl(i)), at_middle, within, message='at mid-span')
         call assertRelativelyEqual(at_joint/nodes, told(stiffness()*(kl(i)/half)**2), within, &
                                    message='as the soft string tells it')
      end do
   end subroutine test_tension

   subroutine test_compression()
      real(wp), parameter :: kl(2) = [0.8_wp, 1.4_wp]
      real(wp) :: at_joint, at_middle
      integer :: i
      do i = 1, size(kl)
         call solve_jointed(-stiffness()*(kl(i)/half)**2, at_joint, at_middle)
         call note('kL', kl(i))
         call note('at mid-span, over kL/sin(kL)', at_middle*sin(kl(i))/kl(i))
         call assertRelativelyEqual(kl(i)/sin(kl(i)), at_middle, within, message='at mid-span')
         call assertLessThan(at_joint, at_middle, message='less at the joint')
         call assertRelativelyEqual(at_middle, told(-stiffness()*(kl(i)/half)**2), within, &
                                    message='as the soft string tells it')
      end do
   end subroutine test_compression

   !> The magnification that the profile of a soft string gives under an axial force [N].
   function told(axial) result(factor)
      real(wp), intent(in) :: axial
      real(wp) :: factor
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(error_type), allocatable :: error
      call build(model, radius)
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = -axial
      call solve_soft_string(model, 1, result, error)
      call find_along_string(model, result, along)
      factor = along%magnification(row(result, spans_below))
   end function told

   pure function stiffness() result(ei)
      real(wp) :: ei
      ei = bending_stiffness(pipe(0.0_wp, 0.127_wp, 0.1086_wp))
   end function stiffness

   !> In a bend of 200 m, pulled straight between joints, the body would lie L^2/(2 R) = 56 mm nearer to the inside than they
   !> do; it stands off by 21 mm only. So it touches at mid-span, and its moment at the joint is below the closed form's.
   subroutine test_body()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: tight = 200.0_wp, kl = 3.0_wp
      real(wp) :: ei
      call build(model, tight)
      ei = bending_stiffness(model%strings(1)%components(1))
      call solve(model, operation_static, -ei*(kl/half)**2, 0.0_wp, result, 'body on the wall')
      call assertGreaterThan(result%profile%gap_state(row(result, spans_below - 0.5_wp)), state_free, message='the body touches')
      call assertGreaterThan(result%profile%gap_state(row(result, spans_below)), state_free, message='the joint touches')
      call assertEqual(state_free, result%profile%gap_state(row(result, spans_below - 0.25_wp)), message='free between')
      call note('at the joint, over that of a body that does not touch', &
                result%profile%bending(row(result, spans_below))/(ei/tight*kl/tanh(kl)))
      call assertLessThan(result%profile%bending(row(result, spans_below)), ei/tight*kl/tanh(kl), message='less at the joint')
   end subroutine test_body

   !> Pipe slid down a vertical hole, buckled to a helix: friction by beams with joints one by one against that of the soft string,
   !> which knows of the pipe between joints only by its Euler load. Above that load joints one by one rub more than smeared ones.
   subroutine test_buckled()
      real(wp), parameter :: over_euler(3) = [0.8_wp, 2.0_wp, 3.5_wp]
      real(wp), parameter :: seen = 0.18_wp     !< 0.15 is seen [-]
      real(wp) :: beams, soft, beams_smeared, soft_smeared
      integer :: i
      do i = 1, size(over_euler)
         call find_friction_of(over_euler(i), .true., beams, soft)
         call find_friction_of(over_euler(i), .false., beams_smeared, soft_smeared)
         call note('load at the bit over the Euler load between joints', over_euler(i))
         call note('friction by beams, joints one by one over smeared', beams/beams_smeared)
         call note('friction, soft string over beams, one by one', soft/beams)
         call note('friction, soft string over beams, smeared', soft_smeared/beams_smeared)
         call assertRelativelyEqual(beams, soft, seen, message='friction of pipe between joints')
         if (over_euler(i) > 1.0_wp) call assertGreaterThan(beams, 1.05_wp*beams_smeared, message='pipe between joints rubs')
      end do
   end subroutine test_buckled

   !> Friction of the string of test_buckled by beams and by the soft string [N].
   subroutine find_friction_of(over_euler, one_by_one, beams, soft)
      real(wp), intent(in) :: over_euler         !< load at the bit over the Euler load between joints [-]
      logical, intent(in) :: one_by_one
      real(wp), intent(out) :: beams, soft
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: component
      real(wp) :: axial(1), torque(1), wob
      component = pipe(0.0_wp, 0.0889_wp, 0.0702_wp)
      component%mass = 21.0_wp
      component%joint_od = 0.127_wp
      component%joint_length = 0.45_wp
      component%joint_spacing = 2.0_wp*half
      wob = over_euler*pi**2*bending_stiffness(component)/component%joint_spacing**2
      call new_well(model, [0.0_wp, 600.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.155_wp, 0.3_wp, component)
      model%numerics%discrete_joints = one_by_one
      call solve(model, operation_sliding_drilling, wob, 0.0_wp, result, 'buckled pipe')
      call soft_string_at(model, 1, [0.0_wp], axial, torque, other=other_loads_type(coiled=.true.))
      beams = string_weight(model) - wob - result%hookload
      soft = string_weight(model) - wob - axial(1)
   end subroutine find_friction_of

   !> Pipe of 3 1/2 in on a slant of 80 deg, pressed with 90 kN: twice the Euler load of its 9.5 m between joints, less than the
   !> 137 kN at which all of it buckles on its joints. It bows out to the wall, which adds 15 % to the contact force. The reference
   !> is a rod in three dimensions by another program, with joints as parts of 0.45 m, which settled from a shape of this one. Two
   !> of its meshes differ by 0.1 %. Joints one by one are taken without being asked for.
   subroutine test_bowed()
      real(wp), parameter :: load = 90.0e3_wp, mass_weight = 174.462_wp, bit = 205.0_wp, across = 0.984807753_wp
      real(wp), parameter :: by_rod = 40.687e3_wp, same = 1.5e-3_wp, other_ends = 0.01_wp, little = 0.88_wp
      integer, parameter :: joints = 22
      type(model_type) :: model
      type(component_type) :: body, tool_joint
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i
      body = pipe(mass_weight, 0.0889_wp, 0.0702_wp)
      body%joint_od = 0.127_wp
      body%joint_length = 0.45_wp
      body%joint_spacing = 9.5_wp
      call new_well(model, [0.0_wp, 210.0_wp], [80.0_wp, 80.0_wp], [40.0_wp, 40.0_wp], 0.155_wp, 0.0_wp, body)
      call hold_ends(model)
      model%cases(1)%bit_depth = bit
      model%cases(1)%operation = operation_static
      model%cases(1)%wob = load
      call solve_case(model, model_mcge, 1, result, error)
      call assertEqual(result_converged, result%status, message=result%message)
      call assertTrue(result%joints_apart, message='one by one')
      call note('contact force over that of the rod, joints of the pipe', result%normal_force/by_rod)
      call assertRelativelyEqual(by_rod, result%normal_force, other_ends, message='joints of the pipe')
      model%numerics%joints_by_need = .false.
      call solve_case(model, model_mcge, 1, result, error)
      call assertLessThan(result%normal_force/by_rod, little, message='smeared')
      call assertRelativelyEqual(mass_weight*across*bit, result%normal_force, other_ends, message='smeared: weight alone')
      tool_joint = pipe(mass_weight, 0.0889_wp, 0.0702_wp)
      tool_joint%joint_od = 0.127_wp
      tool_joint%length = 0.45_wp
      body = pipe(mass_weight, 0.0889_wp, 0.0702_wp)
      body%length = 9.05_wp
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(2*joints))
      do i = 1, joints
         model%strings(1)%components(2*i - 1) = tool_joint
         model%strings(1)%components(2*i) = body
      end do
      model%strings(1)%components(2*joints)%length = 0.0_wp
      call solve_case(model, model_mcge, 1, result, error)
      call assertEqual(result_converged, result%status, message=result%message)
      call note('contact force over that of the rod, joints as parts', result%normal_force/by_rod)
      call assertRelativelyEqual(by_rod, result%normal_force, same, message='joints as parts')
   end subroutine test_bowed
end module dg_test_tool_joints

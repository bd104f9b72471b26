!> Fatigue of strings that turn: a published example, and a bend of which all is known.
!>
!> Lyons (ed.), Standard handbook of petroleum and natural gas engineering, 1996, vol. 1, p. 764: drill pipe of 4 1/2 in with a bore
!> of 3.826 in, S-135, is pulled so that K = 0.024061/in with E = 30e6 psi. It bears a bending of 14,776 psi, and with joints 360 in
!> apart a dogleg of 3.47 deg/100 ft.
module dg_test_fatigue
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: bending_stiffness, component_type, tube_area, tube_inertia
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_fatigue, only: fatigue_type, find_fatigue, permitted_dogleg
   use dg_fatigue_curve, only: fatigue_curve_type, fatigue_e75, fatigue_own, fatigue_s135, permitted_amplitude, turns_to_failure
   use dg_find_verdict, only: find_verdict
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_trip_out
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_solve_case, only: solve_case
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_verdict, only: answer_no, answer_yes, limit_fatigue, limit_joint_fatigue, verdict_type
   use dg_unchecked_text, only: unchecked_text
   use dg_units, only: si_units
   use dg_utilisation, only: find_utilisation
   use dg_verdict_text, only: verdict_reason
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: fatigue_suite

   real(wp), parameter :: inch = 0.0254_wp, psi = 6894.757293168_wp, per_100_ft = degree/30.48_wp
   real(wp), parameter :: radius = 200.0_wp       !< of the bend of the well [m]

contains

   function fatigue_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('fatigue')
      call suite%addTest(TestMethod('published_dogleg', test_published))
      call suite%addTest(TestMethod('curves', test_curves))
      call suite%addTest(TestMethod('bend', test_bend))
      call suite%addTest(TestMethod('damage', test_damage))
      call suite%addTest(TestMethod('not_without_rotation', test_still))
      call suite%addTest(TestMethod('joints', test_joints))
      call suite%addTest(TestMethod('hours', test_hours))
      call suite%addTest(TestMethod('narrow_joints', test_narrow_joints))
      call suite%addTest(TestMethod('joints_decide', test_verdict))
      call suite%addTest(TestMethod('weak_part', test_weak_part))
   end function fatigue_suite

   function pipe() result(part)
      type(component_type) :: part
      part%name = 'pipe'
      part%kind = 'drillpipe'
      part%od = 4.5_wp*inch
      part%id = 3.826_wp*inch
      part%joint_od = 6.25_wp*inch
      part%joint_spacing = 360.0_wp*inch
      part%youngs = 30.0e6_wp*psi
      part%mass = part%density*tube_area(part%od, part%id)
      part%fatigue%curve = fatigue_s135
   end function pipe

   !> Their numbers have four and three digits.
   subroutine test_published()
      type(component_type) :: part
      real(wp) :: tension
      part = pipe()
      tension = (0.024061_wp/inch)**2*bending_stiffness(part)
      call assertEqual(14776.0_wp, permitted_amplitude(part%fatigue, tension/tube_area(part%od, part%id))/psi, 1.0_wp)
      call assertEqual(3.47_wp, permitted_dogleg(part, tension)/per_100_ft, 0.005_wp)
   end subroutine test_published

   !> E75 at the ends of its range, 0 and 67,000 psi; S135; Goodman's line; corrosive mud; Basquin's line.
   subroutine test_curves()
      type(fatigue_curve_type) :: curve
      curve%curve = fatigue_e75
      call assertRelativelyEqual(18000.0_wp, permitted_amplitude(curve, -1.0_wp)/psi, 1.0e-12_wp)
      call assertRelativelyEqual(8000.0_wp, permitted_amplitude(curve, 67.0e3_wp*psi)/psi, 1.0e-12_wp)
      curve%share = 0.6_wp
      call assertRelativelyEqual(10800.0_wp, permitted_amplitude(curve, 0.0_wp)/psi, 1.0e-12_wp)
      curve = fatigue_curve_type(fatigue_s135)
      call assertRelativelyEqual(10000.0_wp, permitted_amplitude(curve, 72.5e3_wp*psi)/psi, 1.0e-12_wp)
      curve = fatigue_curve_type(fatigue_own, limit=200.0e6_wp, tensile=1000.0e6_wp, exponent=5.0_wp, turns=2.0e6_wp)
      call assertRelativelyEqual(150.0e6_wp, permitted_amplitude(curve, 250.0e6_wp), 1.0e-12_wp)
      call assertRelativelyEqual(2.0e6_wp/32.0_wp, turns_to_failure(curve, 300.0e6_wp, 150.0e6_wp), 1.0e-12_wp)
      call assertEqual(0.0_wp, turns_to_failure(curve, 149.0e6_wp, 150.0e6_wp), 0.0_wp)
   end subroutine test_curves

   !> A build to 90 deg and a straight end; soft string, without friction.
   subroutine solve(operation, curve, hours, model, result, parts, joints)
      integer, intent(in) :: operation
      type(fatigue_curve_type), intent(in) :: curve
      real(wp), intent(in) :: hours
      type(model_type), intent(out) :: model
      type(case_result_type), intent(out) :: result
      type(fatigue_type), allocatable, intent(out) :: parts(:)
      type(fatigue_curve_type), intent(in), optional :: joints   !< curve of connections
      type(along_string_type) :: along
      type(error_type), allocatable :: error
      real(wp) :: depths(4)
      depths = [0.0_wp, 500.0_wp, 500.0_wp + 0.5_wp*pi*radius, 1200.0_wp]
      call new_trajectory(model%trajectory, depths, [0.0_wp, 0.0_wp, 0.5_wp*pi, 0.5_wp*pi], [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depths(4), 8.5_wp*inch, 0.0_wp, 0.0_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(2))
      model%strings(1)%components = pipe()
      model%strings(1)%components(1)%length = 600.0_wp
      model%strings(1)%components%fatigue = curve
      if (present(joints)) model%strings(1)%components%joint_fatigue = joints
      model%mud = standing_mud(0.0_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depths(4)
      model%cases(1)%operation = operation
      model%cases(1)%angular_speed = 4.0_wp*pi
      model%cases(1)%hours = hours
      call solve_case(model, model_soft, 1, result, error)
      call assertFalse(allocated(error))
      call assertEqual(result_converged, result%status)
      call find_along_string(model, result, along)
      call find_fatigue(model, result, along, parts)
   end subroutine solve

   !> The lower component is worst at its upper end, where it hangs in the bend: E D/(2 R) KL/tanh(KL). Where the hole bends as the
   !> tension permits, all of the amplitude is used.
   subroutine test_bend()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      real(wp) :: tension, kl
      integer :: i
      call solve(operation_rotate_off_bottom, fatigue_curve_type(fatigue_s135), 0.0_wp, model, result, parts)
      call assertEqual(2, size(parts))
      call assertTrue(parts(1)%used >= parts(2)%used)
      associate (part => model%strings(1)%components(1))
         do i = 1, 2
            tension = parts(i)%tension*tube_area(part%od, part%id)
            kl = 0.5_wp*part%joint_spacing*sqrt(tension/bending_stiffness(part))
            call assertRelativelyEqual(part%youngs*part%od/(2.0_wp*radius)*kl/tanh(kl), parts(i)%amplitude, 1.0e-9_wp)
            call assertRelativelyEqual(1.0_wp/radius, parts(i)%dogleg*parts(i)%used, 1.0e-9_wp)
            call assertTrue(is_missing(parts(i)%turns) .and. is_missing(parts(i)%damage))
         end do
         ! the upper component hangs straight to 500 m and has the larger tension at the beginning of the bend
         call assertEqual(2, parts(1)%part)
         call assertEqual(500.0_wp, parts(1)%md, 1.0e-6_wp)
         call assertRelativelyEqual(part%mass*model%gravity*radius, parts(1)%tension*tube_area(part%od, part%id), 1.0e-9_wp)
      end associate
   end subroutine test_bend

   !> 120 turns a minute for 10 hours.
   subroutine test_damage()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      type(fatigue_curve_type) :: curve
      curve = fatigue_curve_type(fatigue_own, limit=40.0e6_wp, exponent=6.0_wp)
      call solve(operation_rotate_off_bottom, curve, 10.0_wp, model, result, parts)
      call assertTrue(parts(1)%used > 1.0_wp)
      call assertRelativelyEqual(1.0e6_wp/parts(1)%used**6, parts(1)%turns, 1.0e-9_wp)
      call assertRelativelyEqual(72000.0_wp/parts(1)%turns, parts(1)%damage, 1.0e-9_wp)
      curve = fatigue_curve_type(fatigue_own, limit=1.0e9_wp, exponent=6.0_wp)
      call solve(operation_rotate_off_bottom, curve, 10.0_wp, model, result, parts)
      call assertTrue(is_missing(parts(1)%turns))
      call assertEqual(0.0_wp, parts(1)%damage, 0.0_wp)
   end subroutine test_damage

   subroutine test_still()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      call solve(operation_trip_out, fatigue_curve_type(fatigue_s135), 10.0_wp, model, result, parts)
      call assertEqual(0, size(parts))
   end subroutine test_still

   !> Connections in the bend of `test_bend`: they take the moment E I/R KL/tanh(KL) of the body beside them with their own section,
   !> and bear the dogleg in which all of their amplitude is used. Without tool joints their stress is that of the body.
   subroutine test_joints()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:), flush(:)
      type(along_string_type) :: along
      type(fatigue_curve_type) :: joints
      real(wp) :: tension, kl, inertia
      integer :: i
      joints = fatigue_curve_type(fatigue_own, limit=5.0e6_wp, exponent=6.0_wp)
      call solve(operation_rotate_off_bottom, fatigue_curve_type(), 10.0_wp, model, result, parts, joints)
      call assertEqual(2, size(parts))
      associate (part => model%strings(1)%components(1))
         inertia = tube_inertia(part%joint_od, part%id)
         do i = 1, 2
            call assertTrue(parts(i)%joint)
            tension = parts(i)%tension*tube_area(part%joint_od, part%id)
            kl = 0.5_wp*part%joint_spacing*sqrt(tension/bending_stiffness(part))
            call assertRelativelyEqual(bending_stiffness(part)/radius*kl/tanh(kl)*0.5_wp*part%joint_od/inertia, &
                                       parts(i)%amplitude, 1.0e-9_wp)
            call assertRelativelyEqual(1.0_wp/radius, parts(i)%dogleg*parts(i)%used, 1.0e-9_wp)
            call assertRelativelyEqual(1.0e6_wp/parts(i)%used**6, parts(i)%turns, 1.0e-9_wp)
            call assertRelativelyEqual(72000.0_wp/parts(i)%turns, parts(i)%damage, 1.0e-9_wp)
         end do
         call assertEqual(500.0_wp, parts(1)%md, 1.0e-6_wp)
      end associate
      call solve(operation_rotate_off_bottom, fatigue_curve_type(fatigue_s135), 10.0_wp, model, result, parts, joints)
      call assertEqual(4, size(parts))
      call assertEqual(2, count(parts%joint))
      call assertTrue(all(parts(:3)%used >= parts(2:)%used), message='the worst first')
      model%strings(1)%components%joint_od = 0.0_wp
      call find_along_string(model, result, along)
      call find_fatigue(model, result, along, flush)
      call assertRelativelyEqual(bending_stiffness(pipe())/radius*0.5_wp*4.5_wp*inch/tube_inertia(4.5_wp*inch, 3.826_wp*inch), &
                                 maxval(flush%amplitude, mask=flush%joint), 1.0e-9_wp)
   end subroutine test_joints

   !> Joints whose bore is given, 3 in where the pipe has 3.826 in: amplitude and tension of the worst connection, and von Mises'
   !> stress in the joint there, without torque and pressure: its tension and bending.
   subroutine test_narrow_joints()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      type(along_string_type) :: along
      type(fatigue_curve_type) :: joints
      real(wp), parameter :: bore = 3.0_wp*inch
      real(wp) :: tension, kl
      integer :: row
      joints = fatigue_curve_type(fatigue_own, limit=5.0e6_wp, exponent=6.0_wp)
      call solve(operation_rotate_off_bottom, fatigue_curve_type(), 10.0_wp, model, result, parts, joints)
      model%strings(1)%components%joint_id = bore
      call find_along_string(model, result, along)
      call find_fatigue(model, result, along, parts)
      associate (part => model%strings(1)%components(1))
         call assertEqual(500.0_wp, parts(1)%md, 1.0e-6_wp)
         tension = part%mass*model%gravity*radius
         kl = 0.5_wp*part%joint_spacing*sqrt(tension/bending_stiffness(part))
         call assertRelativelyEqual(tension/tube_area(part%joint_od, bore), parts(1)%tension, 1.0e-9_wp)
         call assertRelativelyEqual(bending_stiffness(part)/radius*kl/tanh(kl)*0.5_wp*part%joint_od/ &
                                    tube_inertia(part%joint_od, bore), parts(1)%amplitude, 1.0e-9_wp)
         call assertRelativelyEqual(1.0_wp/radius, parts(1)%dogleg*parts(1)%used, 1.0e-9_wp)
         row = minloc(abs(result%profile%md - parts(1)%md), dim=1)
         row = row - 1 + maxloc(along%joint_von_mises(row:row + 1), dim=1)
         call assertRelativelyEqual(parts(1)%tension + parts(1)%amplitude, along%joint_von_mises(row), 1.0e-6_wp)
      end associate
   end subroutine test_narrow_joints

   !> Connections that last less than the body make the answer NO.
   subroutine test_verdict()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(verdict_type) :: verdict
      character(:), allocatable :: text
      call solve(operation_rotate_off_bottom, fatigue_curve_type(fatigue_own, limit=40.0e6_wp, exponent=5.0_wp), 1000.0_wp, &
                 model, result, parts, fatigue_curve_type(fatigue_own, limit=5.0e6_wp, exponent=5.0_wp))
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertTrue(whole%joint_fatigue%damage > whole%fatigue%damage .and. whole%fatigue%damage > 1.0_wp)
      call find_verdict(model, result, whole, verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(limit_joint_fatigue, verdict%limit)
      call assertRelativelyEqual(whole%joint_fatigue%damage, verdict%used%value, 1.0e-12_wp)
      whole%joint_fatigue%damage = 0.5_wp*whole%fatigue%damage
      model%strings(1)%components(1)%name = 'lower pipe'
      model%strings(1)%components(2)%name = 'upper pipe'
      call find_verdict(model, result, whole, verdict)
      call assertEqual(limit_fatigue, verdict%limit)
      text = verdict_reason(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, "Fatigue by hours of rotation at ") == 1 .and. index(text, " m in 'upper pipe': 1000 h, ") > 0, &
                      message=text)
   end subroutine test_verdict

   !> The component at the depth of a limit of strength is named: lower or upper pipe, one of them of soft steel.
   subroutine test_weak_part()
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      character(*), parameter :: names(2) = ['lower pipe', 'upper pipe']
      integer :: i
      call solve(operation_rotate_off_bottom, fatigue_curve_type(), 1000.0_wp, model, result, parts)
      do i = 1, 2
         model%strings(1)%components(i)%name = names(i)
      end do
      do i = 1, 2
         model%strings(1)%components%yield = 900.0e6_wp
         model%strings(1)%components(i)%yield = 50.0e6_wp
         call judge_part(" m in '"//names(i)//"': ")
      end do
   contains
      subroutine judge_part(words)
         character(*), intent(in) :: words
         type(along_string_type) :: along
         type(whole_string_type) :: whole
         type(verdict_type) :: verdict
         character(:), allocatable :: text
         call find_along_string(model, result, along)
         call find_whole_string(model, result, along, whole)
         call find_utilisation(model, result, along, whole%utilisation)
         call find_verdict(model, result, whole, verdict)
         call assertEqual(answer_no, verdict%answer)
         text = verdict_reason(si_units(), model%cases(1), verdict)
         call assertTrue(index(text, words) > 0, message=text)
      end subroutine judge_part
   end subroutine test_weak_part

   !> A little less than the hours that pipe bears is a yes near its limit, a little more a NO; both tell the hours. Without hours,
   !> and then without an exponent, fatigue is not checked, and the text says what is missing.
   subroutine test_hours()
      type(fatigue_curve_type), parameter :: curve = fatigue_curve_type(fatigue_own, limit=40.0e6_wp, exponent=5.0_wp)
      type(verdict_type) :: verdict
      character(:), allocatable :: text
      real(wp) :: life
      call judge(curve, 1.0_wp, verdict, text)
      life = 1.0_wp/verdict%used%value
      call judge(curve, 0.97_wp*life, verdict, text)
      call assertEqual(answer_yes, verdict%answer)
      call assertEqual(limit_fatigue, verdict%limit)
      call assertRelativelyEqual(0.97_wp, verdict%used%value, 1.0e-12_wp)
      call assertRelativelyEqual(0.97_wp*life*3600.0_wp, verdict%load%value, 1.0e-12_wp)
      call assertRelativelyEqual(life*3600.0_wp, verdict%allowed%value, 1.0e-12_wp)
      call assertEqual('', text)
      call judge(curve, 1.03_wp*life, verdict, text)
      call assertEqual(answer_no, verdict%answer)
      call assertRelativelyEqual(life*3600.0_wp, verdict%allowed%value, 1.0e-12_wp)
      call judge(curve, 0.0_wp, verdict, text)
      call assertEqual(answer_yes, verdict%answer)
      call assertEqual('(its limit is passed, no hours or rpm), joint fatigue', text)
      call judge(fatigue_curve_type(fatigue_own, limit=40.0e6_wp), life, verdict, text)
      call assertEqual('(its limit is passed, no fatigue_exponent), joint fatigue', text)
   end subroutine test_hours

   !> Verdict of the case with a curve and hours, and what the text says of fatigue that was not checked.
   subroutine judge(curve, hours, verdict, text)
      type(fatigue_curve_type), intent(in) :: curve
      real(wp), intent(in) :: hours
      type(verdict_type), intent(out) :: verdict
      character(:), allocatable, intent(out) :: text
      type(model_type) :: model
      type(case_result_type) :: result
      type(fatigue_type), allocatable :: parts(:)
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      call solve(operation_rotate_off_bottom, curve, hours, model, result, parts)
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call find_verdict(model, result, whole, verdict)
      text = unchecked_text(verdict%not_checked, model%strings(1)%components)
      text = text(index(text//'(its', '(its'):)
   end subroutine judge
end module dg_test_fatigue

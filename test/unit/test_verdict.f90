!> The answer to 'can it be done?' against closed forms: a uniform string in a straight inclined hole, by the soft string.
module dg_test_verdict
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, result_locked_up, result_not_converged
   use dg_component, only: buoyed_weight, tube_area
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_find_verdict, only: find_verdict
   use dg_fluid, only: standing_mud
   use dg_friction_estimate, only: find_upper_friction, friction_estimate_type, upper_friction_type
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_rotary_drilling, operation_sliding_drilling, operation_static, &
      operation_trip_in, operation_trip_out
   use dg_missing, only: given, missing, optional_real
   use dg_model, only: model_type
   use dg_rounding, only: rounded_down
   use dg_soft_string, only: solve_soft_string
   use dg_text, only: to_text
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_unchecked_text, only: unchecked_codes, unchecked_text
   use dg_units, only: si_units
   use dg_utilisation, only: find_utilisation, limit_joint_torsion, limit_makeup, limit_rig, limit_slips, limit_tension, &
                             limit_top_drive
   use dg_verdict, only: answer_no, answer_unknown, answer_yes, every_limit_count, friction_calibrated, limit_code, limit_fatigue, &
                         limit_lock_up, limit_string_weight, note_uncertain, verdict_type
   use dg_verdict_text, only: task_text, verdict_reason, verdict_sentences
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: verdict_suite

   real(wp), parameter :: depth = 600.0_wp, angle = 60.0_wp*degree, friction = 0.3_wp, mud = 1200.0_wp
   real(wp), parameter :: close = 1.0e-3_wp

contains

   function verdict_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('verdict')
      call suite%addTest(TestMethod('string_weight_and_its_reserve', test_weight))
      call suite%addTest(TestMethod('push_needed', test_push))
      call suite%addTest(TestMethod('too_much_weight_on_bit', test_weight_on_bit))
      call suite%addTest(TestMethod('impossible_without_load_too', test_without_load))
      call suite%addTest(TestMethod('rig_and_its_reserve', test_rig))
      call suite%addTest(TestMethod('limit_behind_the_reserve', test_reserve_limit))
      call suite%addTest(TestMethod('reserve_of_coils', test_reserve_of_coils))
      call suite%addTest(TestMethod('upper_end_of_friction', test_upper_end))
      call suite%addTest(TestMethod('upper_end_of_frictions_together', test_correlated_frictions))
      call suite%addTest(TestMethod('no_lock_up_of_a_string_that_rests', test_static))
      call suite%addTest(TestMethod('top_drive', test_top_drive))
      call suite%addTest(TestMethod('what_was_not_checked', test_not_checked))
      call suite%addTest(TestMethod('locked_up', test_locked_up))
      call suite%addTest(TestMethod('no_solution', test_no_solution))
      call suite%addTest(TestMethod('uncertain_contact', test_uncertain))
      call suite%addTest(TestMethod('codes_without_blanks', test_codes))
   end function verdict_suite

   !> A collar all the way up in a straight hole.
   subroutine build(model, operation, wob)
      type(model_type), intent(out) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob          !< [N]
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, depth], [angle, angle], [0.0_wp, 0.0_wp], &
                          interpolation_minimum_curvature, error)
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, depth, 0.2159_wp, friction, friction)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      associate (part => model%strings(1)%components(1))
         part%kind = 'collar'
         part%name = 'collar'
         part%od = 0.1651_wp
         part%id = 0.0714_wp
         part%mass = part%density*tube_area(part%od, part%id)
      end associate
      model%mud = standing_mud(mud)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = depth
      model%cases(1)%operation = operation
      model%cases(1)%wob = wob
   end subroutine build

   !> Buoyed weight of the whole string [N].
   function weight_of(model) result(weight)
      type(model_type), intent(in) :: model
      real(wp) :: weight
      weight = depth*buoyed_weight(model%strings(1)%components(1), mud, mud, model%gravity)
   end function weight_of

   !> Solve by the soft string and judge.
   subroutine judge(model, rig_limit, verdict, upper)
      type(model_type), intent(in) :: model
      type(optional_real), intent(in) :: rig_limit      !< [N]
      type(verdict_type), intent(out) :: verdict
      type(upper_friction_type), intent(in), optional :: upper
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      type(model_type) :: limited
      type(error_type), allocatable :: error
      limited = model
      limited%rig%max_hookload = rig_limit
      call solve_soft_string(limited, 1, result, error)
      call assertFalse(allocated(error))
      call find_along_string(limited, result, along)
      call find_whole_string(limited, result, along, whole)
      call find_utilisation(limited, result, along, whole%utilisation)
      call find_verdict(limited, result, whole, verdict, upper)
   end subroutine judge

   !> Running in: hook load W (cos a - f sin a). Friction may be cot a/f times as high until nothing hangs on the hook.
   subroutine test_weight()
      type(model_type) :: model
      type(verdict_type) :: verdict
      call build(model, operation_trip_in, 0.0_wp)
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_yes, verdict%answer)
      call assertEqual(limit_string_weight, verdict%limit)
      call assertRelativelyEqual(friction*tan(angle), verdict%used%value, close, message='used')
      call assertRelativelyEqual(weight_of(model)*cos(angle), verdict%allowed%value, close, message='weight along the hole')
      call assertRelativelyEqual(1.0_wp/(friction*tan(angle)), verdict%friction_reserve%value, close, message='reserve')
      call assertEqual(limit_string_weight, verdict%reserve_limit)
   end subroutine test_weight

   !> Friction of 0.7 holds a string at 60 degrees: W (f sin a - cos a) of push. Turned, it goes down.
   subroutine test_push()
      type(model_type) :: model
      type(verdict_type) :: verdict
      character(:), allocatable :: reason
      call build(model, operation_trip_in, 0.0_wp)
      model%cases(1)%friction_axial = given(0.7_wp)
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(limit_string_weight, verdict%limit)
      call assertFalse(verdict%friction_reserve%present, message='a reserve of what cannot be done')
      call assertRelativelyEqual(weight_of(model)*cos(angle), verdict%turning_hookload%value, close, message='turned')
      allocate (character(0) :: reason)
      reason = verdict_reason(si_units(), model%cases(1), verdict)
      call assertEqual(to_text(weight_of(model)*(0.7_wp*sin(angle) - cos(angle))/1000.0_wp, 3)// &
                       ' kN of push needed at surface', reason)
      reason = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(reason, 'Rotate the string') > 0, message=reason)
      call assertRelativelyEqual(1.0_wp/(0.7_wp*tan(angle)), verdict%possible_friction%value, close, message='less friction')
      call assertTrue(index(reason, 'The answer becomes yes below about 0.824 times all friction factors') > 0, message=reason)
   end subroutine test_push

   !> Sliding with one and a half of the weight on bit that the string brings to the bit.
   subroutine test_weight_on_bit()
      type(model_type) :: model
      type(verdict_type) :: verdict
      character(:), allocatable :: reason
      real(wp) :: most
      call build(model, operation_sliding_drilling, 0.0_wp)
      most = weight_of(model)*(cos(angle) - friction*sin(angle))
      model%cases(1)%wob = 1.5_wp*most
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertRelativelyEqual(most, verdict%most_wob%value, close, message='largest weight on bit')
      allocate (character(0) :: reason)
      reason = verdict_reason(si_units(), model%cases(1), verdict)
      call assertEqual('String weight alone brings '//to_text(rounded_down(most/1000.0_wp, 3), 3)//' kN to the bit, '// &
                       to_text(1.5_wp*most/1000.0_wp, 3)//' kN asked', reason)
      model%cases(1)%wob = 0.9_wp*most
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_yes, verdict%answer, message='nine tenths of it')
      call assertEqual(limit_string_weight, verdict%limit)
      call assertRelativelyEqual(1.0_wp - 0.1_wp*most/(weight_of(model)*cos(angle)), verdict%used%value, close)
   end subroutine test_weight_on_bit

   !> Overpull and weight on bit that are not what makes the answer no: W (f sin a - cos a) of push, W (cos a + f sin a) on the rig.
   subroutine test_without_load()
      real(wp), parameter :: asked = 50.0e3_wp
      type(model_type) :: model
      type(verdict_type) :: verdict
      real(wp) :: push, load
      call build(model, operation_sliding_drilling, asked)
      model%cases(1)%friction_axial = given(0.7_wp)
      push = weight_of(model)*(0.7_wp*sin(angle) - cos(angle))
      call expect(optional_real(), 'String weight alone brings no load to the bit, 50 kN asked. Not possible without weight on '// &
                  'bit either: '//'string weight is '//kilonewtons(push)//' short. No shallower bit depth is possible either')
      model%cases(1)%wob = 0.0_wp
      model%cases(1)%bit_depth = 0.1_wp*depth
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_no, verdict%answer, message='shallower')
      call build(model, operation_trip_out, -asked)
      load = weight_of(model)*(cos(angle) + friction*sin(angle))
      call expect(given(load - 9.0e3_wp), ', with 50 kN of overpull at the bit. Not possible without overpull either: hook '// &
                  'load with block (rig) 9 kN too much then')
      call expect(given(load + 20.05e3_wp), ', with 50 kN of overpull at the bit. By the limits checked, overpull up to '// &
                  'about 20 kN is possible: then hook load with block (rig) is at its limit')
      ! torque f W sin a times the radius is within the limit when the bit is off bottom
      call build(model, operation_rotary_drilling, asked)
      load = friction*weight_of(model)*sin(angle)*0.5_wp*model%strings(1)%components(1)%od
      model%cases(1)%tob = load
      model%rig%given = .true.
      model%rig%max_torque = given(1.1_wp*load)
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(0, verdict%limit_without_load, message='no bit torque without weight on bit')
   contains
      subroutine expect(rig_limit, words)
         type(optional_real), intent(in) :: rig_limit      !< [N]
         character(*), intent(in) :: words
         character(:), allocatable :: text
         call judge(model, rig_limit, verdict)
         text = verdict_sentences(si_units(), model%cases(1), verdict)
         call assertTrue(index(text, words) > 0, message=text)
      end subroutine expect

      function kilonewtons(force) result(text)
         real(wp), intent(in) :: force       !< [N]
         character(:), allocatable :: text
         text = to_text(force/1000.0_wp, 3)//' kN'
      end function kilonewtons
   end subroutine test_without_load

   !> Two sections of equal length whose frictions have a half width of 0.12 each, correlation r: the friction that both take
   !> together has one of 0.12 sqrt((1 + r)/2) on their mean.
   subroutine test_correlated_frictions()
      real(wp), parameter :: r(3) = [-0.98_wp, 0.0_wp, 1.0_wp]
      type(model_type) :: model
      type(verdict_type) :: verdict
      type(friction_estimate_type) :: estimate
      type(upper_friction_type) :: upper
      real(wp) :: load
      integer :: i
      call build(model, operation_trip_out, 0.0_wp)
      model%holes = [model%holes(1), model%holes(1)]
      model%holes(1)%md_bottom = 0.5_wp*depth
      model%holes(2)%md_top = 0.5_wp*depth
      do i = 1, size(r)
         estimate = friction_estimate_type(name='k', applied=.true., found=.true., half_widths=[0.12_wp, 0.12_wp], known=.true., &
                                           deviations=[0.06_wp, 0.06_wp], &
                                           correlation=reshape([1.0_wp, r(i), r(i), 1.0_wp], [2, 2]))
         call find_upper_friction(model%holes, [estimate], upper)
         load = weight_of(model)*(cos(angle) + (friction + 0.12_wp*sqrt(0.5_wp*(1.0_wp + r(i))))*sin(angle))
         call judge(model, given(1.001_wp*load), verdict, upper)
         call assertEqual(answer_yes, verdict%answer, message='a rig that carries it')
         call judge(model, given(0.999_wp*load), verdict, upper)
         call assertEqual(answer_no, verdict%answer, message='a rig that does not')
      end do
   end subroutine test_correlated_frictions

   !> Pulling out with friction that was found, f = 0.3, 95 % interval up to 0.42. The rig carries the hook
   !> load W (cos a + f sin a) at 0.3, and, or not, at the upper end.
   subroutine test_upper_end()
      type(model_type) :: model
      type(verdict_type) :: verdict
      type(friction_estimate_type) :: estimate
      type(upper_friction_type) :: upper
      character(:), allocatable :: text
      real(wp) :: ends(2), loads(2)
      call build(model, operation_trip_out, 0.0_wp)
      estimate = friction_estimate_type(name='k', applied=.true., found=.true., half_widths=[0.12_wp])
      call find_upper_friction(model%holes, [estimate], upper)
      ends = [friction, friction + 0.12_wp]
      call assertRelativelyEqual(ends(2), upper%holes(1)%friction_axial, close)
      call assertRelativelyEqual(ends(2), upper%holes(1)%friction_rotary, close)
      loads = weight_of(model)*(cos(angle) + ends*sin(angle))
      allocate (character(0) :: text)
      call judge(model, given(1.01_wp*loads(2)), verdict, upper)
      call assertEqual(answer_yes, verdict%answer)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, 'The answer is yes at the upper end of the 95 % interval of friction, too. '// &
                            'The answer becomes NO') > 0, message=text)
      call judge(model, given(0.99_wp*loads(2)), verdict, upper)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(limit_rig, verdict%limit)
      call assertRelativelyEqual(1.0_wp/0.99_wp, verdict%used%value, close)
      call assertFalse(verdict%friction_reserve%present)
      call assertRelativelyEqual((0.99_wp*loads(2)/weight_of(model) - cos(angle))/(friction*sin(angle)), &
                                 verdict%possible_friction%value, close)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertEqual(588.21_wp, loads(2)/1000.0_wp, 0.005_wp)
      call assertEqual('Hook load with block (rig): 588.21 kN, 582.32 kN allowed, 5.89 kN too much, at the upper end of the '// &
                       '95 % interval of friction. With up to about 1.36 times the calibrated friction the answer is yes', text)
      model%cases(1)%measured_hookload = given(loads(1))
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, '. A hook load was measured in this case, so it could be done: friction was less then. '// &
                            'With up to about') > 0, message=text)
      ! One that cannot be done with the friction found, either.
      call judge(model, given(0.99_wp*loads(1)), verdict, upper)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertEqual(0, index(text, 'upper end'), message=text)
      call assertTrue(index(text, 'The answer becomes yes below about 0.9') > 0, message=text)
      ! A friction of the load case's own was not found.
      model%cases(1)%friction_axial = given(friction)
      call judge(model, given(0.99_wp*loads(2)), verdict, upper)
      call assertEqual(answer_yes, verdict%answer)
      model%cases(1)%friction_axial%present = .false.
      estimate%half_widths = missing
      call find_upper_friction(model%holes, [estimate], upper)
      call judge(model, given(0.99_wp*loads(2)), verdict, upper)
      call assertEqual(answer_yes, verdict%answer)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, 'times the calibrated friction') > 0, message=text)
      call assertEqual(friction_calibrated, verdict%friction)
   end subroutine test_upper_end

   !> A string that rests has no friction and no lock-up: weight on bit takes 0.3/cos a of its weight along the hole.
   subroutine test_static()
      type(model_type) :: model
      type(verdict_type) :: verdict
      character(:), allocatable :: text
      call build(model, operation_static, 0.3_wp*weight_of_pipe())
      call judge(model, optional_real(), verdict)
      call assertEqual(limit_string_weight, verdict%limit)
      allocate (character(0) :: text)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, 'Nearest of the limits checked: string weight along the hole (340.5 kN), WOB takes 204.3 kN '// &
                            'of it, 60 % used, ') == 1, message=text)
      call assertTrue(index(text, ' left as hook load') > 0, message=text)
      call assertTrue(any(verdict%not_checked), message='the rig has no limit')
      verdict%not_checked = .false.
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, 'Nearest limit: ') == 1, message=text)
      text = task_text(si_units(), model%cases(1))
      call assertEqual('Static at ', text(:10))
   contains
      !> Buoyed weight of the whole string [N].
      function weight_of_pipe() result(weight)
         real(wp) :: weight
         type(model_type) :: empty
         call build(empty, operation_static, 0.0_wp)
         weight = weight_of(empty)
      end function weight_of_pipe
   end subroutine test_static

   !> Pulling out, W (cos a + f sin a) and a block of 100 kN on a rig. The factor follows from the rest.
   subroutine test_rig()
      type(model_type) :: model
      type(verdict_type) :: verdict
      real(wp) :: load, block
      block = 100.0e3_wp
      call build(model, operation_trip_out, 0.0_wp)
      model%rig%given = .true.
      model%rig%block_weight = block
      load = weight_of(model)*(cos(angle) + friction*sin(angle)) + block
      call judge(model, given(1.1_wp*load), verdict)
      call assertEqual(answer_yes, verdict%answer)
      call assertEqual(limit_rig, verdict%limit)
      call assertRelativelyEqual(load, verdict%load%value, close)
      call assertRelativelyEqual(1.0_wp + 0.1_wp*load/(weight_of(model)*friction*sin(angle)), verdict%friction_reserve%value, close)
      call judge(model, given(0.9_wp*load), verdict)
      call assertEqual(answer_no, verdict%answer, message='too heavy for the rig')
      call assertEqual(limit_rig, verdict%limit)
      call assertRelativelyEqual(1.0_wp - 0.1_wp*load/(weight_of(model)*friction*sin(angle)), verdict%possible_friction%value, &
                                 close)
      call judge(model, given(0.9_wp*weight_of(model)*cos(angle)), verdict)
      call assertEqual(answer_no, verdict%answer, message='too heavy without friction')
      call assertFalse(verdict%possible_friction%present, message='friction does not decide')
   end subroutine test_rig

   !> A heavy block uses most of the rig. Friction grows the string's tension faster than the load of the rig.
   subroutine test_reserve_limit()
      type(model_type) :: model
      type(verdict_type) :: verdict
      character(:), allocatable :: text
      real(wp) :: load
      call build(model, operation_trip_out, 0.0_wp)
      load = weight_of(model)*(cos(angle) + friction*sin(angle))
      model%rig%given = .true.
      model%rig%block_weight = load
      associate (pipe => model%strings(1)%components(1))
         pipe%yield = load/(0.8_wp*0.25_wp*pi*(pipe%od**2 - pipe%id**2))
      end associate
      call judge(model, given(2.0_wp*load/0.85_wp), verdict)
      call assertEqual(limit_rig, verdict%limit, message='today')
      call assertEqual(limit_tension, verdict%reserve_limit, message='with more friction')
      allocate (character(0) :: text)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, 'times all friction factors (0.519), by tension') > 0, message=text)
   end subroutine test_reserve_limit

   !> The soft string has no friction of coils in its hook load, but in its largest weight on bit: the reserve ends there. With 1.02
   !> times the factor the answer is no, with 0.98 times yes.
   subroutine test_reserve_of_coils()
      real(wp), parameter :: steep = 0.02_wp, bottom = 3000.0_wp, today = 0.3_wp
      type(model_type) :: model
      type(verdict_type) :: verdict
      type(error_type), allocatable :: error
      real(wp) :: factor
      integer :: i
      call build(model, operation_sliding_drilling, 0.0_wp)
      call new_trajectory(model%trajectory, [0.0_wp, bottom], [steep, steep], [0.0_wp, 0.0_wp], interpolation_minimum_curvature, &
                          error)
      call assertFalse(allocated(error))
      model%holes(1)%md_bottom = bottom
      model%cases(1)%bit_depth = bottom
      model%cases(1)%friction_axial = given(today)
      associate (tubing => model%strings(1)%components(1))
         tubing%od = 0.073_wp
         tubing%id = 0.062_wp
         tubing%mass = tubing%density*tube_area(tubing%od, tubing%id)
      end associate
      call judge(model, optional_real(), verdict)
      model%cases(1)%wob = 0.9_wp*verdict%most_wob%value
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_yes, verdict%answer, message='today')
      call assertTrue(verdict%friction_reserve%present, message='a reserve')
      factor = verdict%friction_reserve%value
      do i = 1, 2
         model%cases(1)%friction_axial = given(today*factor*merge(0.98_wp, 1.02_wp, i == 1))
         call judge(model, optional_real(), verdict)
         call assertEqual(merge(answer_yes, answer_no, i == 1), verdict%answer, message='beside the factor')
      end do
   end subroutine test_reserve_of_coils

   !> Torque f W sin a times the radius of the string.
   subroutine test_top_drive()
      type(model_type) :: model
      type(verdict_type) :: verdict
      real(wp) :: torque
      call build(model, operation_rotary_drilling, 0.0_wp)
      torque = friction*weight_of(model)*sin(angle)*0.5_wp*model%strings(1)%components(1)%od
      model%rig%given = .true.
      model%rig%max_torque = given(1.25_wp*torque)
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_yes, verdict%answer)
      call assertEqual(limit_top_drive, verdict%limit)
      call assertRelativelyEqual(0.8_wp, verdict%used%value, close)
      call assertRelativelyEqual(1.25_wp, verdict%friction_reserve%value, close)
      model%rig%max_torque = given(0.8_wp*torque)
      call judge(model, optional_real(), verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(limit_top_drive, verdict%limit)
   end subroutine test_top_drive

   !> Limits without a rating are named, those of turning only where the string turns.
   subroutine test_not_checked()
      type(model_type) :: model
      type(verdict_type) :: verdict
      character(:), allocatable :: names
      call build(model, operation_trip_out, 0.0_wp)
      call judge(model, optional_real(), verdict)
      call assertTrue(all(verdict%not_checked([limit_tension, limit_rig, limit_slips])))
      call assertFalse(any(verdict%not_checked([limit_makeup, limit_joint_torsion, limit_top_drive, limit_fatigue])), &
                       message='nothing turns')
      model%cases(1)%operation = operation_rotary_drilling
      model%strings(1)%components(1)%yield = 700.0e6_wp
      model%rig%max_torque = given(1.0e6_wp)
      call judge(model, given(1.0e7_wp), verdict)
      allocate (character(0) :: names)
      names = unchecked_codes(verdict)
      call assertEqual('joint_torsion make_up_torque slips joint_tension fatigue', names)
      names = unchecked_text(verdict%not_checked, model%strings(1)%components)
      call assertEqual('connections (no make-up torque or rating), slips, fatigue', names)
      ! one part more, which alone has a joint torsion and no yield
      model%strings(1)%components = [model%strings(1)%components, model%strings(1)%components(1)]
      model%strings(1)%components(1)%kind = 'drillpipe'
      model%strings(1)%components(2)%name = 'upper'
      model%strings(1)%components(2)%yield = 0.0_wp
      model%strings(1)%components(2)%joint_torsion = 1.0e6_wp
      call judge(model, given(1.0e7_wp), verdict)
      names = unchecked_text(verdict%not_checked, model%strings(1)%components)
      call assertEqual('pipe strength of upper (no yield), joint torsion of '//model%strings(1)%components(1)%name// &
                       ', make-up torque, slips, fatigue', names)
   end subroutine test_not_checked

   !> A string that is locked up cannot be done, and its weight on bit is told.
   subroutine test_locked_up()
      type(model_type) :: model
      type(case_result_type) :: result
      type(whole_string_type) :: whole
      type(verdict_type) :: verdict
      character(:), allocatable :: text
      real(wp) :: most
      call build(model, operation_sliding_drilling, 0.0_wp)
      most = weight_of(model)*(cos(angle) - friction*sin(angle))
      model%cases(1)%wob = 2.0_wp*most
      result%case_index = 1
      result%status = result_locked_up
      call find_verdict(model, result, whole, verdict)
      call assertEqual(answer_no, verdict%answer)
      call assertEqual(limit_lock_up, verdict%limit)
      call assertRelativelyEqual(most, verdict%most_wob%value, close)
      result%lock_up_load = 0.5_wp*most
      call find_verdict(model, result, whole, verdict)
      call assertRelativelyEqual(0.5_wp*most, verdict%most_wob%value, close, message='what beams bear')
      model%cases(1)%operation = operation_trip_out
      call find_verdict(model, result, whole, verdict)
      call assertTrue(index(verdict_reason(si_units(), model%cases(1), verdict), 'a pull does not move it') > 0)
      ! What is left, and a factor next to 1.
      verdict = verdict_type()
      verdict%answer = answer_yes
      verdict%limit = limit_lock_up
      verdict%load = given(170.0e3_wp)
      verdict%allowed = given(558.0e3_wp)
      verdict%used = given(170.0_wp/558.0_wp)
      verdict%friction_reserve = given(1.00491_wp)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertEqual('Close to its limit: the answer becomes NO above about 1.004 times all friction factors. Most used: '// &
                       'lock-up, WOB 170 of 558 kN by the soft string, 30.5 % used', text)
      verdict%friction_reserve = given(1.25_wp)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertEqual('Nearest limit: lock-up, WOB 170 of 558 kN by the soft string, 30.5 % used. The answer becomes NO '// &
                       'above about 1.25 times all friction factors', text)
      call judge_reserve(1.04_wp, 'above about 1.04 times all friction factors')
      call judge_reserve(1.00142_wp, 'above about 1.001 times all friction factors')
      call judge_reserve(1.00042_wp, 'already with 0.2 % more friction')
      call judge_reserve(1.0_wp, 'already with 0.2 % more friction')
      call judge_used(0.9994_wp, '99.9')
      call judge_used(0.9996_wp, '99.96')
      call judge_used(0.9999996_wp, '99.99996')
      call judge_used(1.0_wp, '100')
      verdict = verdict_type()
      verdict%answer = answer_no
      verdict%limit = limit_top_drive
      verdict%load = given(35.01e3_wp)
      verdict%allowed = given(35.0e3_wp)
      verdict%possible_friction = given(0.9999996_wp)
      text = verdict_sentences(si_units(), model%cases(1), verdict)
      call assertTrue(index(text, 'becomes yes below about 0.9999 times') > 0, message=text)
   contains
      subroutine judge_reserve(factor, words)
         real(wp), intent(in) :: factor
         character(*), intent(in) :: words
         verdict%friction_reserve = given(factor)
         text = verdict_sentences(si_units(), model%cases(1), verdict)
         call assertTrue(index(text//'.', 'the answer becomes NO '//words//'.') > 0, message=text)
      end subroutine judge_reserve

      subroutine judge_used(share, words)
         real(wp), intent(in) :: share
         character(*), intent(in) :: words
         verdict%used = given(share)
         text = verdict_sentences(si_units(), model%cases(1), verdict)
         call assertTrue(index(text//'.', ', '//words//' % used.') > 0, message=text)
      end subroutine judge_used
   end subroutine test_locked_up

   !> A case that has not converged has no answer.
   subroutine test_no_solution()
      type(model_type) :: model
      type(case_result_type) :: result
      type(whole_string_type) :: whole
      type(verdict_type) :: verdict
      call build(model, operation_static, 0.0_wp)
      result%case_index = 1
      result%status = result_not_converged
      call find_verdict(model, result, whole, verdict)
      call assertEqual(answer_unknown, verdict%answer)
      call assertEqual('', verdict_reason(si_units(), model%cases(1), verdict))
   end subroutine test_no_solution

   !> A yes whose limit is nearer than the error of contact force says so: drag where friction may grow by less, stress where less
   !> is left; a helically buckled string by its stress alone.
   subroutine test_uncertain()
      type(verdict_type) :: verdict
      verdict%answer = answer_yes
      verdict%friction_reserve = given(1.2_wp)
      call note_uncertain(0.15_wp, 0.8_wp, .false., verdict)
      call assertEqual(0.0_wp, verdict%uncertain, message='more is left')
      call note_uncertain(0.24_wp, 0.5_wp, .true., verdict)
      call assertEqual(0.0_wp, verdict%uncertain, message='drag of a coiled string is not in doubt')
      call note_uncertain(0.24_wp, 0.5_wp, .false., verdict)
      call assertEqual(0.24_wp, verdict%uncertain, message='drag')
      verdict%uncertain = 0.0_wp
      call note_uncertain(0.52_wp, 0.85_wp, .true., verdict)
      call assertEqual(0.52_wp, verdict%uncertain, message='stress')
      verdict%limit = limit_string_weight
      call assertTrue(index(verdict_sentences(si_units(), load_case_type(), verdict), &
                            'UNCERTAIN: contact force may be off by 52 %, more than is left of a limit. ') > 0)
      verdict%answer = answer_no
      verdict%uncertain = 0.0_wp
      call note_uncertain(0.52_wp, 0.85_wp, .true., verdict)
      call assertEqual(0.0_wp, verdict%uncertain, message='NO stays NO')
   end subroutine test_uncertain

   !> Names in files are separated by blanks: none has one inside, and none is used twice.
   subroutine test_codes()
      character(:), allocatable :: code
      integer :: i, k
      allocate (character(0) :: code)
      do i = 1, every_limit_count
         code = trim(limit_code(i))
         call assertEqual(0, scan(code, ' -'), message=code)
         do k = 1, i - 1
            call assertFalse(code == limit_code(k), message=code)
         end do
      end do
   end subroutine test_codes
end module dg_test_verdict

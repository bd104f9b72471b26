!> Cases at the edge of what can be solved: what is left there is said, and bounded by its reason.
module dg_test_hard_cases
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, &
                    TestMethod, TestSuite
   use dg_constants, only: degree
   use dg_case_result, only: case_result_type, judged_start, result_converged, result_locked_up, &
                            result_not_converged
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_sliding_drilling, operation_trip_in, operation_trip_out
   use dg_model, only: model_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_stiff_drag, only: find_stiff_drag
   use dg_test_wells, only: hold_ends, new_well, note, part, pipe, solve, string_weight
   implicit none
   private
   public :: hard_cases_suite

   real(wp), parameter :: w = 262.0_wp, od = 0.127_wp, id = 0.1086_wp

contains

   function hard_cases_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('hard_cases')
      call suite%addTest(TestMethod('stiff_walls', test_stiff_walls))
      call suite%addTest(TestMethod('stiff_supports', test_stiff_supports))
      call suite%addTest(TestMethod('light_rods', test_light_rods))
      call suite%addTest(TestMethod('twisted_string', test_twisted_string))
      call suite%addTest(TestMethod('walls_that_pull', test_walls_that_pull))
      call suite%addTest(TestMethod('severe_dogleg', test_severe_dogleg))
      call suite%addTest(TestMethod('drifting_coils', test_drifting_coils))
      call suite%addTest(TestMethod('more_than_pipe_bears', test_more_than_pipe_bears))
      call suite%addTest(TestMethod('noisy_survey', test_noisy_survey))
      call suite%addTest(TestMethod('sliding_motor', test_sliding_motor))
   end function hard_cases_suite

   !> Walls of 1e9 to 1e17 N/m2, ten million times as stiff as solid steel. A place of some hundred metres is known to 1e-13 m, and
   !> what that is off would press with the wall's stiffness times the element: 100 kN at 1e17. Contact forces are unknowns of their
   !> own, so that forces balance all the same, and hook load and sum of contact are those of softer walls.
   subroutine test_stiff_walls()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      real(wp) :: hookload, normal
      integer :: i
      hookload = 0.0_wp
      normal = 0.0_wp
      do i = 9, 17, 2
         call new_well(model, [0.0_wp, 200.0_wp, 500.0_wp], [20.0_wp, 60.0_wp, 60.0_wp], [350.0_wp, 10.0_wp, 10.0_wp], 0.2_wp, &
                       0.3_wp, pipe(w, od, id))
         model%numerics%gk_contact = 10.0_wp**i
         model%numerics%gk_max = 10.0_wp*model%numerics%gk_contact
         model%cases(1)%operation = operation_trip_out
         call solve_static_analysis(model, 1, result, error)
         call assertEqual(result_converged, result%status, message='status')
         call note('force out of balance over weight', result%equilibrium_force/string_weight(model))
         call assertLessThan(result%equilibrium_force, 1.0e-6_wp*string_weight(model), message='forces balance')
         if (i > 9) then
            call note('hook load by the stiffer wall, less one', result%hookload/hookload - 1.0_wp)
            call note('sum of contact by the stiffer wall, less one', result%normal_force/normal - 1.0_wp)
            call assertRelativelyEqual(hookload, result%hookload, 1.0e-4_wp, message='hook load')
            call assertRelativelyEqual(normal, result%normal_force, 1.0e-3_wp, message='sum of contact')
         end if
         hookload = result%hookload
         normal = result%normal_force
         call judge_history(result)
      end do
   end subroutine test_stiff_walls

   !> Every iteration stands in an attempt and in a stage of its mesh; stages follow each other within an attempt, attempts too.
   subroutine judge_history(result)
      type(case_result_type), intent(in) :: result
      integer :: i
      associate (rows => result%history)
         call assertEqual(1, rows(1)%attempt, message='first attempt')
         call assertEqual(1, rows(1)%stage, message='first stage')
         call assertEqual(judged_start, rows(1)%judged, message='nothing led to the start')
         call assertTrue(any(rows%judged /= judged_start), message='steps are judged')
         do i = 2, size(rows)
            if (rows(i)%attempt == rows(i - 1)%attempt) then
               call assertTrue(any(rows(i)%stage - rows(i - 1)%stage == [0, 1]), message='stage by stage')
            else
               call assertEqual(rows(i - 1)%attempt + 1, rows(i)%attempt, message='attempt by attempt')
            end if
         end do
      end associate
   end subroutine judge_history

   !> Ends that are held, at walls of 1e9 and 1e15 N/m2. A support's force follows from the place of its node, kilometres from the
   !> origin of its arc: with the wall's own stiffness round-off of that place was a hundred newtons, and three cases of four found
   !> no equilibrium.
   subroutine test_stiff_supports()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: hookload
      integer :: i
      hookload = 0.0_wp
      do i = 9, 15, 6
         call new_well(model, [0.0_wp, 500.0_wp, 2000.0_wp, 3500.0_wp, 5000.0_wp], [0.0_wp, 5.0_wp, 60.0_wp, 90.0_wp, 90.0_wp], &
                       [20.0_wp, 20.0_wp, 60.0_wp, 60.0_wp, 100.0_wp], 0.2159_wp, 0.25_wp, pipe(w, od, id))
         call hold_ends(model)
         model%numerics%gk_contact = 10.0_wp**i
         model%numerics%gk_max = 10.0_wp**i
         call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'stiff supports')
         call assertLessThan(result%iterations, 30, message='iterations')
         if (i > 9) call assertRelativelyEqual(hookload, result%hookload, 1.0e-4_wp, message='hook load')
         hookload = result%hookload
      end do
   end subroutine test_stiff_supports

   !> Rods of 26 N/m from one station to the next at 3000 m: round-off of places at the held ends is 1e-8 of their weight.
   subroutine test_light_rods()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call new_well(model, [0.0_wp, 3000.0_wp], [40.0_wp, 40.0_wp], [30.0_wp, 30.0_wp], 0.062_wp, 0.25_wp, &
                    pipe(26.0_wp, 0.0222_wp, 0.0_wp))
      call hold_ends(model)
      model%cases(1)%operation = operation_trip_out
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_converged, result%status, message=result%message)
      call assertLessThan(result%iterations, 10, message='iterations')
   end subroutine test_light_rods

   !> Coiled tubing that hangs straight in a vertical hole, in equilibrium from the start, under a torque on its lower end beyond
   !> that at which it leaves the axis (17 to 18 kN.m, by finite differences of the hanging beam): such an equilibrium is none.
   subroutine test_twisted_string()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call new_well(model, [0.0_wp, 300.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.3112_wp, 0.25_wp, &
                    pipe(50.0_wp, 0.0603_wp, 0.0516_wp))
      call hold_ends(model)
      model%numerics%element_length = 1.0_wp
      model%cases(1)%operation = operation_sliding_drilling
      model%cases(1)%tob = 8.0e3_wp
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_converged, result%status, message='half the torque')
      model%cases(1)%tob = 20.0e3_wp
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_not_converged, result%status, message='beyond it')
      call assertFalse(allocated(result%profile%md), message='no state')
      call assertGreaterThan(index(result%message, 'No stable equilibrium found'), 0, message=result%message)
      call assertGreaterThan(index(result%message, '. Lower wob or tob'), 0, message=result%message)
      call assertGreaterThan(index(result%message, 'elements up to 1 m (4 starts)'), 0, message=result%message)
      model%numerics%max_iterations = 10
      call solve_static_analysis(model, 1, result, error)
      call assertLessThan(result%iterations, 11, message='all attempts together')
      call assertGreaterThan(index(result%message, 'Set max_iterations to 1300, its default'), 0, message=result%message)
   end subroutine test_twisted_string

   !> A threshold of force so high that closed gaps hold the string to the wall where it would leave it: round a bend of 67 deg/30 m
   !> the contact force came out below zero.
   subroutine test_walls_that_pull()
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call new_well(model, [0.0_wp, 1200.0_wp, 1240.0_wp, 1360.0_wp], [0.0_wp, 0.0_wp, 90.0_wp, 90.0_wp], &
                    spread(120.0_wp, 1, 4), 0.1524_wp, 0.0_wp, pipe(194.0_wp, 0.0889_wp, 0.0702_wp))
      model%numerics%r_n0 = 1.0e3_wp
      model%cases(1)%operation = operation_trip_out
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_not_converged, result%status, message='status')
      call assertGreaterThan(index(result%message, 'Set r_n0 to '), 0, message=result%message)
   end subroutine test_walls_that_pull

   !> Going in through 80 deg at 300 deg/30 m, a radius of 45 diameters: bending presses the string on the wall with forces whose
   !> friction is more than its weight, so that it must be pushed from above, 38 kN, and snakes in the vertical hole. The
   !> soft string, from which the mesh takes its compression, knows nothing of that: elements of 10 m end without rest, or with one,
   !> and say so; those of 0.5 and 1 m find it. Between strings without stiffness and held on the axis it lies in any case.
   subroutine test_severe_dogleg()
      type(model_type) :: model
      type(case_result_type) :: result, soft, rigid
      type(error_type), allocatable :: error
      real(wp) :: hookload(2)
      integer :: i
      real(wp), parameter :: lengths(2) = [0.5_wp, 1.0_wp]
      do i = 1, 2
         call new_well(model, [0.0_wp, 100.0_wp, 108.0_wp, 200.0_wp], [0.0_wp, 0.0_wp, 80.0_wp, 80.0_wp], &
                       spread(0.0_wp, 1, 4), 0.2_wp, 0.3_wp, pipe(w, od, id))
         call hold_ends(model)
         model%numerics%element_length = lengths(i)
         call solve(model, operation_trip_in, 0.0_wp, 0.0_wp, result, 'severe dogleg')
         hookload(i) = result%hookload
         call note('hook load [N]', result%hookload)
         call assertTrue(index(result%message, 'pushed at surface') > 0, message='said: '//result%message)
      end do
      ! Snakes of one string on two meshes need not be the same one: on six of 0.25 to 2 m one like it takes 29.6 to 33.3 kN.
      call assertRelativelyEqual(hookload(1), hookload(2), 0.13_wp, message='by longer elements')
      call solve_soft_string(model, 1, soft, error)
      call solve_rigid_string(model, 1, rigid, error)
      call assertGreaterThan(soft%hookload, hookload(1), message='stiffness drags')
      call assertGreaterThan(hookload(1), rigid%hookload, message='no more than on the axis')
      model%numerics%element_length = 10.0_wp
      call solve_static_analysis(model, 1, result, error)
      call assertTrue(result%message /= '', message='what elements of 10 m come to is not quiet')
   end subroutine test_severe_dogleg

   !> Tubing that slides near lock-up, coiled above and in the build: with friction along the hole alone its coils turn round the
   !> hole for ever. Friction holds them sideways, too. It is Coulomb's in sum: along the hole it is less than the friction factor
   !> times contact by what the largest share takes, no more. Forces balance in the sum over the string, sideways friction
   !> included. At 36 kN an equilibrium without it is found, too, after a long way. Held coils stop short of it: hook loads differ
   !> by 0.22 % of drag. With less load the string soon comes to rest by itself, and nothing holds it.
   subroutine test_drifting_coils()
      real(wp), parameter :: friction = 0.348_wp, wob(3) = [34.5e3_wp, 36.0e3_wp, 27.0e3_wp], short = 2.5e-3_wp
      integer, parameter :: drifting = 2
      type(model_type) :: model, unheld
      type(case_result_type) :: result, other
      type(error_type), allocatable :: error
      real(wp) :: lost
      integer :: i
      call new_well(model, [0.0_wp, 1020.0_wp, 2175.0_wp, 2655.0_wp], [0.0_wp, 0.0_wp, 77.0_wp, 77.0_wp], spread(145.0_wp, 1, 4), &
                    0.1594_wp, friction, pipe(73.1_wp, 0.073_wp, 0.062_wp))
      call hold_ends(model)
      model%numerics%moments = .false.
      model%numerics%tuning%most_meshes = 1
      model%numerics%tuning%most_attempts = 1
      model%cases(1)%operation = operation_sliding_drilling
      do i = 1, size(wob)
         model%cases(1)%wob = wob(i)
         call solve_static_analysis(model, 1, result, error)
         call assertEqual(result_converged, result%status, message=result%message)
         call note('iterations', real(result%iterations, wp))
         call note('hook load [N]', result%hookload)
         call assertLessThan(result%equilibrium_force, 1.0e-6_wp*string_weight(model), message='forces balance')
         lost = 1.0_wp - result%friction/(friction*result%normal_force)
         call note('part of friction that is not along the hole', lost)
         unheld = model
         unheld%numerics%tuning%longest_quiet = 1000000
         call solve_static_analysis(unheld, 1, other, error)
         call note('iterations, not held', real(other%iterations, wp))
         if (i <= drifting) then
            call assertGreaterThan(index(result%message, 'keep the coils'), 0, message='said: '//result%message)
            call assertGreaterThan(lost, 0.0_wp, message='less along the hole')
            call assertLessThan(lost, 0.51_wp*model%numerics%tuning%most_held**2, message='no more than the largest share takes')
            if (i == 1) call assertEqual(result_not_converged, other%status, message='not held')
            if (i == 2) call assertEqual(result_converged, other%status, message=other%message)
            if (i == 2) call assertLessThan(abs(result%hookload - other%hookload), short*abs(other%friction), message='hook load')
         else
            call assertEqual(index(result%message, 'keep the coils'), 0, message='nothing said: '//result%message)
            call assertEqual(other%hookload, result%hookload, message='hook load')
         end if
      end do
   end subroutine test_drifting_coils

   !> A string that is pulled through seven bends of 90 deg, each of which multiplies the pull by exp(friction*pi/2). With friction
   !> 0.5 the top needs 245 times the pull at the bit, which stretches pipe by 2 %. Such a case is locked up. With half of the
   !> friction it needs 16 times that pull, and the case converges.
   subroutine test_more_than_pipe_bears()
      integer, parameter :: bends = 7
      real(wp), parameter :: pull = 60.0e3_wp, friction(2) = [0.5_wp, 0.25_wp], quarter = 0.5_wp*acos(-1.0_wp)
      integer, parameter :: expected(2) = [result_locked_up, result_converged]
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i, n
      do i = 1, size(friction)
         call new_well(model, [(300.0_wp*n, n=0, bends)], spread(90.0_wp, 1, bends + 1), [(90.0_wp*mod(n, 4), n=0, bends)], &
                       0.2_wp, friction(i), pipe(w, od, id))
         model%cases(1)%operation = operation_trip_out
         model%cases(1)%wob = -pull
         call solve_static_analysis(model, 1, result, error)
         call assertEqual(expected(i), result%status, message=result%message)
         if (i == 1) then
            call assertGreaterThan(index(result%message, '%, which no pipe bears'), 0, message=result%message)
         else
            call note('hook load over that of a weightless rope', result%hookload/(pull*exp(friction(i)*bends*quarter)))
            call assertGreaterThan(result%hookload, pull*exp(friction(i)*bends*quarter), message='more than without weight')
         end if
      end do
   end subroutine test_more_than_pipe_bears

   !> A string that is pulled along a level hole whose survey goes left and right by 3 deg every 9 m. The soft string follows each
   !> bend and would be stretched by more than 1 %. Pipe in a hole that is much wider cuts the bends short. In a vertical hole
   !> neither has friction, and its share is no number to divide by.
   subroutine test_noisy_survey()
      integer, parameter :: stations = 231, most_iterations = 60
      real(wp), parameter :: spacing = 9.0_wp, noise = 3.0_wp, pull = 50.0e3_wp, steel = 206.0e9_wp
      real(wp), parameter :: no_pipe = 0.01_wp, part = 0.2_wp, refined = 0.012_wp
      type(model_type) :: model
      type(case_result_type) :: result, soft, finer
      type(error_type), allocatable :: error
      real(wp) :: drag, share
      integer :: n
      call new_well(model, [0.0_wp, 450.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.2_wp, 0.4_wp, pipe(w, od, id))
      model%cases(1)%operation = operation_trip_out
      call find_stiff_drag(model, 1, drag, share)
      call assertEqual(1.0_wp, share, message='no friction, no share')
      call new_well(model, [(spacing*n, n=0, stations - 1)], spread(90.0_wp, 1, stations), &
                    [(noise*mod(n, 2), n=0, stations - 1)], 0.2_wp, 0.4_wp, pipe(w, od, id))
      model%cases(1)%operation = operation_trip_out
      model%cases(1)%wob = -pull
      call solve_soft_string(model, 1, soft, error)
      call assertGreaterThan(soft%hookload/(steel*0.25_wp*acos(-1.0_wp)*(od**2 - id**2)), no_pipe, message='stretch, soft')
      call solve_static_analysis(model, 1, result, error)
      call assertEqual(result_converged, result%status, message=result%message)
      call assertLessThan(result%friction/soft%friction, part, message='friction over that of the soft string')
      call assertLessThan(result%iterations, most_iterations, message='iterations')
      model%numerics%element_length = result%element_lengths(2)/3.0_wp
      call solve_static_analysis(model, 1, finer, error)
      call assertRelativelyEqual(result%hookload, finer%hookload, refined, message='elements a third as long')
   end subroutine test_noisy_survey

   !> A motor that slides in a wide hole, its bit free. Its bend crosses the hole axis, so that short stiff elements are next to
   !> it. Turns about the axis bent them with meganewtons in each step: 462 and 318 iterations, and no equilibrium in a well with
   !> more friction.
   subroutine test_sliding_motor()
      real(wp), parameter :: wob(2) = [100.0e3_wp, 160.0e3_wp]
      integer, parameter :: most = 40           ! 10 and 18 are seen
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: i
      do i = 1, size(wob)
         call new_well(model, [0.0_wp, 900.0_wp, 1290.0_wp, 1923.0_wp], [0.0_wp, 0.0_wp, 66.8_wp, 66.8_wp], &
                       spread(90.0_wp, 1, 4), 0.3423_wp, 0.3_wp, &
                       part('drillpipe', 0.0_wp, 0.1492_wp, 0.1308_wp, 37.5_wp, 0.1778_wp))
         model%strings(1)%components = [part('bit', 0.3_wp, 0.2096_wp, 0.0714_wp, 239.43_wp, 0.3112_wp), &
                                        part('motor', 6.0_wp, 0.2096_wp, 0.0714_wp, 191.54_wp, 0.0_wp), &
                                        part('stabilizer', 1.5_wp, 0.2096_wp, 0.0714_wp, 239.43_wp, 0.3048_wp), &
                                        part('mwd', 10.0_wp, 0.2096_wp, 0.0714_wp, 191.54_wp, 0.0_wp), &
                                        part('stabilizer', 1.5_wp, 0.2096_wp, 0.0714_wp, 239.43_wp, 0.3048_wp), &
                                        part('drillpipe', 140.0_wp, 0.1492_wp, 0.1016_wp, 85.0_wp, 0.1778_wp), &
                                        model%strings(1)%components(1)]
         model%strings(1)%components(2)%bend = 2.61_wp*degree
         model%strings(1)%components(2)%bend_position = 0.96_wp
         model%boundary%top_centred = .true.
         call solve(model, operation_sliding_drilling, wob(i), 4.95e3_wp, result, 'sliding motor')
         call assertLessThan(result%iterations, most, message='iterations')
      end do
   end subroutine test_sliding_motor
end module dg_test_hard_cases

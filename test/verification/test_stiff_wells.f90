!> Rigid and mixed strings in whole wells: the soft string's answers where stiffness does nothing, closed forms where it
!> does, and the same friction in every operation of every model.
module dg_test_stiff_wells
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_kinds, only: wp
   use dg_load_case, only: operation_backream, operation_ream, operation_rotary_drilling, operation_rotate_off_bottom, &
      operation_sliding_drilling, operation_static, operation_trip_in, operation_trip_out
   use dg_missing, only: is_missing
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: new_well, note, pipe, three_part_well
   use dg_trajectory, only: true_vertical_depth
   implicit none
   private
   public :: stiff_wells_suite

   integer, parameter :: soft = 1, rigid = 2, mixed = 3, mcge = 4
   character(*), parameter :: names(4) = [character(5) :: 'soft', 'rigid', 'mixed', 'mcge']
   real(wp), parameter :: wob = 89.0e3_wp, tob = 2700.0_wp
   !> Effect of E I in the three wells: pairs of forces |d|/l at two changes of curvature, some kN of friction-bearing contact at
   !> most, of which half lightens the contact on its other side. Reached in buildhold: 7e-6 of the hook load, 2e-5 of the torque.
   real(wp), parameter :: stiffness_share = 2.0e-5_wp
   real(wp), parameter :: stiffness_share_of_torque = 5.0e-5_wp
   !> Largest difference of the beams: they cut bends inside the clearance and touch in places. 2 per cent of the friction at most:
   !> 2.04 with overpull, with elements of half a metre as with those of ten.
   real(wp), parameter :: beam_share = 0.021_wp

contains

   function stiff_wells_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('stiff_wells')
      call suite%addTest(TestMethod('vertical', test_vertical))
      call suite%addTest(TestMethod('slant', test_slant))
      call suite%addTest(TestMethod('buildhold', test_buildhold))
      call suite%addTest(TestMethod('soft_without_stiffness', test_no_stiffness))
      call suite%addTest(TestMethod('energy_of_bending', test_energy))
      call suite%addTest(TestMethod('pair_of_forces', test_pair))
      call suite%addTest(TestMethod('moment_follows_the_hole', test_moment))
      call suite%addTest(TestMethod('shear_force', test_shear))
      call suite%addTest(TestMethod('beam_between_walls', test_walls))
      call suite%addTest(TestMethod('reaming_between_tripping_and_rotating', test_reaming))
      call suite%addTest(TestMethod('overpull', test_overpull))
      call suite%addTest(TestMethod('static', test_static))
      call suite%addTest(TestMethod('casing_run', test_casing))
      call suite%addTest(TestMethod('wall_climb', test_climb))
      call suite%addTest(TestMethod('warns_outside_its_range', test_warning))
   end function stiff_wells_suite

   subroutine solve(which, model, result)
      integer, intent(in) :: which
      type(model_type), intent(in) :: model
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      select case (which)
      case (soft); call solve_soft_string(model, 1, result, error)
      case (rigid); call solve_rigid_string(model, 1, result, error)
      case (mixed); call solve_mixed_string(model, 1, result, error)
      case default; call solve_static_analysis(model, 1, result, error)
      end select
      call assertFalse(allocated(error), message=trim(names(which)))
      call assertEqual(result_converged, result%status, message=trim(names(which))//': status '//result%message)
   end subroutine solve

   subroutine set_case(model, operation, weight_on_bit, torque_on_bit)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: weight_on_bit, torque_on_bit
      model%cases(1)%operation = operation
      model%cases(1)%wob = weight_on_bit
      model%cases(1)%tob = torque_on_bit
   end subroutine set_case

   !> Rigid and mixed against the known answer of the soft string.
   subroutine expect(model, operation, weight_on_bit, torque_on_bit, hookload, torque, what)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: weight_on_bit, torque_on_bit, hookload, torque
      character(*), intent(in) :: what
      type(case_result_type) :: result
      integer :: which
      call set_case(model, operation, weight_on_bit, torque_on_bit)
      do which = rigid, mixed
         call solve(which, model, result)
         call assertRelativelyEqual(hookload, result%hookload, stiffness_share, message=what//', '//trim(names(which)))
         call assertEqual(torque, result%torque, stiffness_share_of_torque*max(torque, 1.0_wp), &
                          message=what//', torque, '//trim(names(which)))
      end do
   end subroutine expect

   subroutine test_vertical()
      type(model_type) :: model
      call three_part_well(model, [0.0_wp, 2000.0_wp], [0.0_wp, 0.0_wp], 1200.0_wp)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, 732311.5_wp, 0.0_wp, 'up')
      call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, 732311.5_wp, 0.0_wp, 'down')
      call expect(model, operation_rotary_drilling, wob, tob, 643311.5_wp, tob, 'rotary')
      call expect(model, operation_sliding_drilling, wob, tob, 643311.5_wp, tob, 'sliding')
   end subroutine test_vertical

   subroutine test_slant()
      type(model_type) :: model
      call three_part_well(model, [0.0_wp, 500.0_wp, 1100.0_wp, 3000.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], 1400.0_wp)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, 1103899.3_wp, 0.0_wp, 'up')
      call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, 604507.2_wp, 0.0_wp, 'down')
      call expect(model, operation_rotary_drilling, wob, tob, 730839.9_wp, 22207.5_wp, 'rotary')
      call expect(model, operation_sliding_drilling, wob, tob, 529760.6_wp, tob, 'sliding')
   end subroutine test_slant

   subroutine test_buildhold()
      type(model_type) :: model
      call three_part_well(model, [0.0_wp, 800.0_wp, 1450.0_wp, 3500.0_wp], [0.0_wp, 0.0_wp, 65.0_wp, 65.0_wp], 1800.0_wp)
      call expect(model, operation_trip_out, 0.0_wp, 0.0_wp, 1063531.1_wp, 0.0_wp, 'up')
      call expect(model, operation_trip_in, 0.0_wp, 0.0_wp, 414663.3_wp, 0.0_wp, 'down')
      call expect(model, operation_rotary_drilling, wob, tob, 576055.4_wp, 26934.2_wp, 'rotary')
      call expect(model, operation_sliding_drilling, wob, tob, 327352.3_wp, tob, 'sliding')
   end subroutine test_buildhold

   !> Without stiffness nothing is left but the soft string: same balance, other steps (fourth order, 1e-10).
   subroutine test_no_stiffness()
      type(model_type) :: model
      type(case_result_type) :: reference, result
      integer :: which
      call three_part_well(model, [0.0_wp, 800.0_wp, 1450.0_wp, 3500.0_wp], [0.0_wp, 0.0_wp, 65.0_wp, 65.0_wp], 1800.0_wp)
      model%strings(1)%components%youngs = 0.0_wp
      call set_case(model, operation_backream, 0.0_wp, 0.0_wp)
      model%cases(1)%angular_speed = 10.0_wp
      model%cases(1)%trip_speed = 0.5_wp
      call solve(soft, model, reference)
      do which = rigid, mixed
         call solve(which, model, result)
         call assertRelativelyEqual(reference%hookload, result%hookload, 1.0e-10_wp, message='hook load')
         call assertRelativelyEqual(reference%torque, result%torque, 1.0e-10_wp, message='torque')
         call assertEqual(0.0_wp, maxval(result%profile%bending), message='no moment')
      end do
   end subroutine test_no_stiffness

   !> Without friction T + E I k^2/2 + w z is the same all along: a bit in a bend adds E I k^2/2 to the hook load.
   subroutine test_energy()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: energy, weight
      real(wp), parameter :: curvature = 5.0e-3_wp
      !> The change of curvature is spread over 3 m, in which the hole turns by 0.02 rad.
      real(wp), parameter :: spread_out = 1.0e-3_wp
      call new_well(model, [0.0_wp, 300.0_wp, 500.0_wp], [0.0_wp, 0.0_wp, 1.0_wp/degree], [0.0_wp, 0.0_wp, 0.0_wp], &
                    0.2_wp, 0.0_wp, pipe(300.0_wp, 0.127_wp, 0.07_wp))
      call set_case(model, operation_static, -1.0e5_wp, 0.0_wp)
      call solve(rigid, model, result)
      weight = 300.0_wp*true_vertical_depth(model%trajectory, 500.0_wp) + 1.0e5_wp
      energy = 0.5_wp*bending_stiffness(model%strings(1)%components(1))*curvature**2
      call assertRelativelyEqual(energy, result%hookload - weight, spread_out, message='E I k^2/2')
   end subroutine test_energy

   !> A slack weightless pipe into a bend: the wall bends it by contact forces of |d|/(2 l) on each side of the change,
   !> l = sqrt(2 c/|dk|), with nothing to lighten. Pull 1 N.
   subroutine test_pair()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: jump, length
      real(wp), parameter :: curvature = 2.0e-3_wp, clearance = 0.03_wp
      call new_well(model, [0.0_wp, 200.0_wp, 400.0_wp], [0.0_wp, 0.0_wp, 0.4_wp/degree], [0.0_wp, 0.0_wp, 0.0_wp], &
                    0.127_wp + 2.0_wp*clearance, 0.0_wp, pipe(0.0_wp, 0.127_wp, 0.07_wp))
      call set_case(model, operation_static, -1.0_wp, 0.0_wp)
      jump = bending_stiffness(model%strings(1)%components(1))*curvature
      length = sqrt(2.0_wp*clearance/curvature)
      call solve(rigid, model, result)
      ! The pull of 1 N, and the tension E I k^2/2 that bending makes, add 1 per cent in the bend.
      call assertRelativelyEqual(jump/length, result%normal_force, 0.01_wp, message='sum of contact forces')
      call solve(soft, model, result)
      call assertLessThan(result%normal_force, 1.0_wp, message='the soft string presses with the pull alone')
   end subroutine test_pair

   !> In the middle of a long bend the moment is E I k; it has no jump at the kick-off.
   subroutine test_moment()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: full
      call new_well(model, [0.0_wp, 300.0_wp, 800.0_wp], [0.0_wp, 0.0_wp, 30.0_wp], [0.0_wp, 0.0_wp, 0.0_wp], 0.2_wp, 0.2_wp, &
                    pipe(300.0_wp, 0.127_wp, 0.1086_wp))
      call set_case(model, operation_trip_out, 0.0_wp, 0.0_wp)
      full = bending_stiffness(model%strings(1)%components(1))*30.0_wp*degree/500.0_wp
      call solve(rigid, model, result)
      call assertRelativelyEqual(full, at(550.0_wp), 1.0e-9_wp, message='in the bend')
      call assertRelativelyEqual(0.5_wp*full, at(300.0_wp), 1.0e-9_wp, message='half at the kick-off')
      call assertEqual(0.0_wp, at(100.0_wp), message='none above')
   contains
      function at(md) result(moment)
         real(wp), intent(in) :: md
         real(wp) :: moment
         moment = result%profile%bending(minloc(abs(result%profile%md - md), 1))
      end function at
   end subroutine test_moment

   !> Hook load and sum of contact of a finite-difference beam between two walls (steps of 0.2 m, friction along the hole): casing
   !> in a build, and heavy pipe in a dogleg of 9 deg in 20 m, pulled and lowered. The stiff string presses too hard in the dogleg.
   subroutine test_walls()
      real(wp), parameter :: casing(2, 2) = reshape([818.766_wp, 479.06_wp, 562.131_wp, 376.39_wp], [2, 2])      ! kN
      real(wp), parameter :: dogleg(2, 2) = reshape([608.063_wp, 100.11_wp, 325.595_wp, 62.23_wp], [2, 2])
      type(model_type) :: model
      type(component_type) :: steel
      steel = pipe(10.0_wp*69.9_wp, 0.2445_wp, 0.2205_wp)
      steel%joint_od = 0.2699_wp
      call new_well(model, [0.0_wp, 300.0_wp, 900.0_wp, 1450.0_wp], [0.0_wp, 0.0_wp, 50.0_wp, 50.0_wp], spread(77.0_wp, 1, 4), &
                    0.3112_wp, 0.3_wp, steel)
      model%mud = standing_mud(1300.0_wp)
      call compare(casing, [0.0_wp, 0.0_wp], 5.0e-3_wp, 0.02_wp, 'casing')
      steel = pipe(10.0_wp*73.4_wp, 0.127_wp, 0.0762_wp)
      steel%joint_od = 0.1651_wp
      call new_well(model, [0.0_wp, 250.0_wp, 270.0_wp, 560.0_wp], [2.0_wp, 2.0_wp, 11.0_wp, 11.0_wp], spread(77.0_wp, 1, 4), &
                    0.2159_wp, 0.2_wp, steel)
      model%mud = standing_mud(1200.0_wp)
      call compare(dogleg, [-250.0e3_wp, 0.0_wp], 0.01_wp, 0.2_wp, 'dogleg')

   contains

      subroutine compare(beam, wob, hookload_within, contact_within, what)
         real(wp), intent(in) :: beam(2, 2)      !< hook load and contact, pulled and lowered [kN]
         real(wp), intent(in) :: wob(2)          !< [N]
         real(wp), intent(in) :: hookload_within, contact_within
         character(*), intent(in) :: what
         integer, parameter :: operations(2) = [operation_trip_out, operation_trip_in]
         type(case_result_type) :: result
         integer :: i
         model%gravity = 9.80665_wp
         do i = 1, 2
            call set_case(model, operations(i), wob(i), 0.0_wp)
            call solve(rigid, model, result)
            call note(what//': hook load over the beam''s', 1.0e-3_wp*result%hookload/beam(1, i) - 1.0_wp)
            call note(what//': contact over the beam''s', 1.0e-3_wp*result%normal_force/beam(2, i) - 1.0_wp)
            call assertRelativelyEqual(beam(1, i), 1.0e-3_wp*result%hookload, hookload_within, message=what//': hook load')
            call assertRelativelyEqual(beam(2, i), 1.0e-3_wp*result%normal_force, contact_within, message=what//': contact')
         end do
      end subroutine compare
   end subroutine test_walls

   !> Shear force: |d|/(2 l) where the wall bends a slack pipe, and M k for a torque M in a bend, which beams have too. A soft
   !> string has none.
   subroutine test_shear()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: curvature = 2.0e-3_wp, clearance = 0.03_wp, torque = 2.0e4_wp
      integer :: which, i
      call new_well(model, [0.0_wp, 200.0_wp, 400.0_wp], [0.0_wp, 0.0_wp, 0.4_wp/degree], [0.0_wp, 0.0_wp, 0.0_wp], &
                    0.127_wp + 2.0_wp*clearance, 0.0_wp, pipe(0.0_wp, 0.127_wp, 0.07_wp))
      call set_case(model, operation_static, -1.0_wp, 0.0_wp)
      call solve(rigid, model, result)
      i = minloc(abs(result%profile%md - 200.0_wp), dim=1)
      call assertRelativelyEqual(0.5_wp*bending_stiffness(model%strings(1)%components(1))*curvature/ &
                                 sqrt(2.0_wp*clearance/curvature), result%profile%shear(i), 1.0e-6_wp, &
                                 message='at the change of curvature')
      call set_case(model, operation_rotary_drilling, -1.0e3_wp, torque)
      do which = rigid, mcge
         call solve(which, model, result)
         i = minloc(abs(result%profile%md - 300.0_wp), dim=1)
         call note('shear in the bend over M k, '//names(which), result%profile%shear(i)/(torque*curvature))
         call assertRelativelyEqual(torque*curvature, result%profile%shear(i), merge(0.01_wp, 1.0e-6_wp, which == mcge), &
                                    message='in the bend, '//names(which))
      end do
      call solve(soft, model, result)
      call assertTrue(all(is_missing(result%profile%shear)), message='soft')
   end subroutine test_shear

   !> A bend and a tangent in which every model solves fast; friction 0.3.
   subroutine small_well(model)
      type(model_type), intent(out) :: model
      call new_well(model, [0.0_wp, 200.0_wp, 500.0_wp, 900.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], &
                    [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], 0.2159_wp, 0.3_wp, pipe(300.0_wp, 0.127_wp, 0.1086_wp))
   end subroutine small_well

   !> Reaming: the velocity ratio turns tripping into rotating. Slowly turned it is the trip, fast the rotation; between,
   !> in a straight hole, (friction force)^2 + (torque/r)^2 keeps its value, in every model.
   subroutine test_reaming()
      type(model_type) :: model
      type(case_result_type) :: result, trip
      real(wp), parameter :: radius = 0.0635_wp, slow = 1.0e-9_wp
      real(wp) :: weight, ratio
      integer :: which
      call new_well(model, [0.0_wp, 400.0_wp], [50.0_wp, 50.0_wp], [0.0_wp, 0.0_wp], 0.2159_wp, 0.3_wp, &
                    pipe(300.0_wp, 0.127_wp, 0.1086_wp))
      weight = 300.0_wp*400.0_wp*cos(50.0_wp*degree)
      do which = soft, mcge
         call set_case(model, operation_trip_out, 0.0_wp, 0.0_wp)
         call solve(which, model, trip)
         call set_case(model, operation_backream, 0.0_wp, 0.0_wp)
         model%cases(1)%angular_speed = slow
         model%cases(1)%trip_speed = 0.2_wp
         call solve(which, model, result)
         call assertRelativelyEqual(trip%hookload, result%hookload, 1.0e-6_wp, message='slowly turned, '//names(which))
         model%cases(1)%angular_speed = 0.2_wp/radius
         call solve(which, model, result)
         ! Equal speeds share equally; a beam that climbs the wall presses by 1/sqrt(1 + mu^2/2) = 0.978.
         ratio = (result%hookload - weight)*sqrt(2.0_wp)/(trip%hookload - weight)
         call assertEqual(1.0_wp, ratio, merge(0.025_wp, 1.0e-6_wp, which == mcge), message='shared, '//names(which))
         call assertRelativelyEqual((result%hookload - weight)*radius, result%torque, 1.0e-3_wp, &
                                    message='both ways, '//names(which))
         model%cases(1)%operation = operation_ream
         call solve(which, model, trip)
         call assertRelativelyEqual(result%hookload - weight, weight - trip%hookload, 1.0e-3_wp, message='ream, '//names(which))
      end do
   end subroutine test_reaming

   !> Overpull, wob < 0: more tension at the bit, grown by the bend; all models alike.
   subroutine test_overpull()
      call compare(operation_trip_out, -2.0e5_wp, 0.0_wp, 'overpull')
   end subroutine test_overpull

   !> Static: no friction at all, weight times depth, whatever the friction of the hole.
   subroutine test_static()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: which
      call small_well(model)
      call set_case(model, operation_static, -1.0e4_wp, 0.0_wp)
      do which = soft, mcge
         call solve(which, model, result)
         call assertRelativelyEqual(300.0_wp*true_vertical_depth(model%trajectory, 900.0_wp) + 1.0e4_wp, result%hookload, &
                                    1.0e-4_wp, message=names(which))
         call assertEqual(0.0_wp, result%torque, 1.0e-6_wp, message=names(which))
      end do
      call compare(operation_rotate_off_bottom, 0.0_wp, 0.0_wp, 'rotating')
   end subroutine test_static

   !> All models against the soft string in the small well; friction within beam_share plus wall climb.
   subroutine compare(operation, weight_on_bit, torque_on_bit, what)
      integer, intent(in) :: operation
      real(wp), intent(in) :: weight_on_bit, torque_on_bit
      character(*), intent(in) :: what
      type(model_type) :: model
      type(case_result_type) :: reference, result
      integer :: which
      real(wp), parameter :: climb = 0.045_wp        ! 1 - 1/sqrt(1 + 0.3^2)
      call small_well(model)
      call set_case(model, operation, weight_on_bit, torque_on_bit)
      call solve(soft, model, reference)
      do which = rigid, mcge
         call solve(which, model, result)
         call assertEqual(reference%hookload, result%hookload, beam_share*abs(reference%friction) + 1.0e-4_wp*reference%hookload, &
                          message=what//', hook load, '//names(which))
         call assertEqual(reference%torque, result%torque, (beam_share + climb)*reference%torque + 1.0e-6_wp, &
                          message=what//', torque, '//names(which))
      end do
   end subroutine compare

   !> Casing run: a string of 244.5 mm casing lowered into a 311.15 mm hole. Its stiffness, fifteen times that of drill
   !> pipe, is seen, and no model is far from another.
   subroutine test_casing()
      type(model_type) :: model
      type(case_result_type) :: reference, result
      type(component_type) :: casing
      integer :: which
      casing = pipe(500.0_wp, 0.2445_wp, 0.2205_wp)
      casing%kind = 'casing'
      call new_well(model, [0.0_wp, 200.0_wp, 700.0_wp, 1000.0_wp], [0.0_wp, 0.0_wp, 40.0_wp, 40.0_wp], &
                    [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], 0.31115_wp, 0.3_wp, casing)
      call set_case(model, operation_trip_in, 0.0_wp, 0.0_wp)
      call solve(soft, model, reference)
      do which = rigid, mcge
         call solve(which, model, result)
         call assertRelativelyEqual(reference%hookload, result%hookload, 0.02_wp, message=names(which))
         if (which /= mcge) call assertGreaterThan(abs(result%hookload - reference%hookload), 10.0_wp, message='stiffness is seen')
      end do
   end subroutine test_casing

   !> A turning string climbs until contact and its friction carry the weight: n = w sin(th)/sqrt(1 + mu^2), at 180 deg
   !> less atan(mu); closed form, straight hole. The beams, which climb by themselves, agree.
   subroutine test_climb()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: mu = 0.3_wp, radius = 0.0635_wp
      real(wp) :: side
      integer :: which
      call new_well(model, [0.0_wp, 400.0_wp], [50.0_wp, 50.0_wp], [0.0_wp, 0.0_wp], 0.2159_wp, mu, &
                    pipe(300.0_wp, 0.127_wp, 0.1086_wp))
      call set_case(model, operation_rotate_off_bottom, 0.0_wp, 0.0_wp)
      model%numerics%wall_climb = .true.
      side = 300.0_wp*sin(50.0_wp*degree)/sqrt(1.0_wp + mu**2)
      do which = soft, mcge
         call solve(which, model, result)
         call assertRelativelyEqual(mu*radius*side*400.0_wp, result%torque, merge(1.0e-3_wp, 1.0e-12_wp, which == mcge), &
                                    message='torque, '//names(which))
         if (which == mcge) cycle
         call assertRelativelyEqual(side, result%profile%side_force(2), 1.0e-12_wp, message='side force, '//names(which))
         call assertEqual(pi - atan(mu), result%profile%clock(2), 1.0e-12_wp, message='clock, '//names(which))
      end do
   end subroutine test_climb

   !> Compression beyond helical buckling is out of the range of a string on the axis; tension is in it.
   subroutine test_warning()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: which
      call new_well(model, [0.0_wp, 1500.0_wp], [0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], 0.2159_wp, 0.3_wp, &
                    pipe(300.0_wp, 0.127_wp, 0.1086_wp))
      do which = soft, mixed
         call set_case(model, operation_sliding_drilling, 2.0e5_wp, 0.0_wp)
         call solve(which, model, result)
         call assertGreaterThan(index(result%message, 'outside the range'), 0, message=names(which))
         call set_case(model, operation_sliding_drilling, 1.0e4_wp, 0.0_wp)
         call solve(which, model, result)
         call assertEqual('', result%message, message=names(which))
      end do
   end subroutine test_warning
end module dg_test_stiff_wells

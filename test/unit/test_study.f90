!> Studies: every combination of the lists once; the finest is the reference; orders and errors of made-up solutions with
!> known ones; the Pareto set of points that can be told by eye.
module dg_test_study
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: result_converged, result_not_converged
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge, model_soft
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_numerics, only: fidelity_name, gap_at_extremum, gap_at_nodes, numerics_type
   use dg_study_comparison, only: compare_case, error_bending, error_bending_rms, error_hookload, error_normal_force, &
                                  error_torque, pareto_set, study_record_type, fit_order
   use dg_study_plan, only: most_variants, study_plan_type
   use dg_study_variant, only: is_finer, set_variant, study_variants, variant_type
   implicit none
   private
   public :: study_suite

   real(wp), parameter :: round_off = 1.0e-12_wp
   !> Orders are looked for in steps of 0.01.
   real(wp), parameter :: order_step = 0.0101_wp

contains

   function study_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('study')
      call suite%addTest(TestMethod('variants', test_variants))
      call suite%addTest(TestMethod('walls', test_walls))
      call suite%addTest(TestMethod('order_of_a_power', test_order))
      call suite%addTest(TestMethod('no_order', test_no_order))
      call suite%addTest(TestMethod('errors_and_reference', test_errors))
      call suite%addTest(TestMethod('profiles_at_all_depths', test_profiles))
      call suite%addTest(TestMethod('finest_without_solution', test_lost_reference))
      call suite%addTest(TestMethod('pareto_set', test_pareto))
   end function study_suite

   !> A plan whose lists are all empty but for the models.
   pure function plan_of(models) result(plan)
      integer, intent(in) :: models(:)
      type(study_plan_type) :: plan
      plan%cases = [1]
      plan%models = models
      allocate (plan%element_lengths(0), plan%tolerances(0), plan%wall_stiffnesses(0), plan%gap_locations(0), &
                plan%linear_solvers(0), plan%fidelities(0))
   end function plan_of

   !> Beams: 3 meshes x 2 tolerances x 2 places; soft string: the two element lengths alone.
   subroutine test_variants()
      type(study_plan_type) :: plan
      type(numerics_type) :: numerics
      type(variant_type), allocatable :: variants(:)
      integer :: i, finest
      plan = plan_of([model_soft, model_mcge])
      plan%element_lengths = [20.0_wp, 4.0_wp]
      plan%fidelities = [4]
      plan%tolerances = [1.0e-4_wp, 1.0e-10_wp]
      plan%gap_locations = [gap_at_nodes, gap_at_extremum]
      numerics%relocation = 0.25_wp
      call study_variants(plan, numerics, variants)
      call assertEqual(14, size(variants))
      call assertEqual(24.0_wp, most_variants(plan), round_off, message='before those that are alike fall together')
      finest = 1
      do i = 1, size(variants)
         call assertEqual(0.25_wp, variants(i)%numerics%relocation, round_off, message='settings of the deck stay')
         if (is_finer(variants(i), variants(finest))) finest = i
         call assertFalse(is_finer(variants(i), variants(i)), message='finer than itself')
      end do
      call assertTrue(variants(finest)%numerics%halve_moments, message='its moments are proven')
      numerics%moments = .true.
      call study_variants(plan, numerics, variants)
      do i = 1, size(variants)
         call assertTrue(variants(i)%numerics%halve_moments .eqv. (variants(i)%model == model_mcge .and. &
            variants(i)%numerics%element_length < 1.01_wp), message='only those of the shortest elements')
      end do
      call assertEqual('reference', trim(fidelity_name(variants(finest)%fidelity)))
      call assertEqual(1.0_wp, variants(finest)%numerics%element_length, round_off)
      call assertEqual(1.0e-10_wp, variants(finest)%numerics%tolerance, round_off*1.0e-10_wp)
      call assertEqual(gap_at_extremum, variants(finest)%numerics%gap_location)
   end subroutine test_variants

   !> A wall of the study goes before those of the hole sections, the rigid wall in proportion.
   subroutine test_walls()
      type(model_type) :: model
      type(variant_type) :: variant
      allocate (model%holes(2))
      model%holes(1) = hole_section_type()
      model%holes(2) = hole_section_type()
      model%holes(2)%wall_stiffness = 7.0_wp
      variant%numerics%gk_contact = 1.0e8_wp
      variant%numerics%gk_max = 2.0e9_wp
      call set_variant(variant, model)
      call assertEqual(7.0_wp, model%holes(2)%wall_stiffness, round_off, message='no wall in the study')
      variant%wall = 1.0e6_wp
      call set_variant(variant, model)
      call assertEqual(1.0e6_wp, model%holes(1)%wall_stiffness, round_off)
      call assertEqual(1.0e6_wp, model%holes(2)%wall_stiffness, round_off)
      call assertEqual(2.0e7_wp, model%numerics%gk_max, 1.0e-6_wp)
   end subroutine test_walls

   !> v(h) = 3 + 0.2 h^p: differences to the finest of five, itself wrong by 0.2 h^p.
   subroutine test_order()
      real(wp), parameter :: h(5) = [16.0_wp, 8.0_wp, 4.0_wp, 2.0_wp, 1.0_wp], orders(3) = [1.0_wp, 2.0_wp, 4.0_wp]
      real(wp) :: order
      integer :: i
      do i = 1, size(orders)
         call fit_order(h, 0.2_wp*abs(h**orders(i) - 1.0_wp), 1.0_wp, round_off, order)
         call assertEqual(orders(i), order, order_step)
      end do
   end subroutine test_order

   !> One point, points at round-off, points that do not fall: no order.
   subroutine test_no_order()
      real(wp) :: order
      call fit_order([4.0_wp, 1.0_wp], [1.0_wp, 0.0_wp], 1.0_wp, round_off, order)
      call assertTrue(is_missing(order), message='one point')
      call fit_order([4.0_wp, 2.0_wp, 1.0_wp], [1.0e-13_wp, 1.0e-14_wp, 0.0_wp], 1.0_wp, round_off, order)
      call assertTrue(is_missing(order), message='round-off')
      call fit_order([4.0_wp, 2.0_wp, 1.0_wp], [1.0_wp, 3.0_wp, 0.0_wp], 1.0_wp, round_off, order)
      call assertTrue(is_missing(order), message='growing with refinement')
   end subroutine test_no_order

   !> Three meshes of one model: hook load 700 (1 + 1e-3 h^2), torque none, moments M(s) = s + h on 0 to 4 m.
   pure subroutine three_meshes(variants, records)
      type(variant_type), intent(out) :: variants(3)
      type(study_record_type), intent(out) :: records(3)
      real(wp), parameter :: h(3) = [4.0_wp, 2.0_wp, 1.0_wp]
      integer :: i
      variants%model = model_mcge
      variants%numerics%element_length = h
      records%status = result_converged
      records%hookload = 7.0e5_wp*(1.0_wp + 1.0e-3_wp*h**2)
      records%normal_force = 1.0e3_wp*h
      records%mean_length = h
      records%seconds = [1.0_wp, 2.0_wp, 8.0_wp]
      do i = 1, size(records)
         records(i)%md = [0.0_wp, 2.0_wp, 4.0_wp]
         records(i)%moments = records(i)%md + h(i)
         records(i)%bending = maxval(records(i)%moments)
      end do
      records(3)%md = [0.0_wp, 4.0_wp]     ! the same line by other points
      records(3)%moments = [1.0_wp, 5.0_wp]
   end subroutine three_meshes

   subroutine test_errors()
      type(variant_type) :: variants(3)
      type(study_record_type) :: records(3)
      call three_meshes(variants, records)
      call compare_case(variants, records)
      call assertTrue(records(3)%is_reference .and. .not. any(records(:2)%is_reference))
      call assertEqual(15.0e-3_wp/1.001_wp, records(1)%errors(error_hookload), round_off)
      call assertEqual(3.0_wp, records(1)%errors(error_normal_force), round_off)
      call assertEqual(3.0_wp/5.0_wp, records(1)%errors(error_bending), round_off, message='constant difference of 3 over 5')
      call assertEqual(3.0_wp/5.0_wp, records(1)%errors(error_bending_rms), round_off, message='and its root mean square')
      call assertTrue(all(is_missing(records%errors(error_torque))), message='no torque, no error')
      call assertEqual(2.0_wp, records(1)%orders(error_hookload), order_step)
      call assertEqual(1.0_wp, records(2)%orders(error_bending), order_step)
      call assertTrue(is_missing(records(1)%orders(error_torque)))
      call assertEqual(0.25_wp, records(2)%cost, round_off)
      call assertTrue(all(records%in_pareto_set))
   end subroutine test_errors

   !> Moments are compared at the rows of both: a peak of one between two rows of the other counts.
   subroutine test_profiles()
      type(variant_type) :: variants(3)
      type(study_record_type) :: records(3)
      call three_meshes(variants, records)
      ! a triangle of 2 about 1 m, between two rows of the reference, which has a row of its own at 3 m
      records(1)%md = [0.0_wp, 0.5_wp, 1.0_wp, 1.5_wp, 4.0_wp]
      records(1)%moments = [1.0_wp, 1.5_wp, 4.0_wp, 2.5_wp, 5.0_wp]
      records(3)%md = [0.0_wp, 3.0_wp, 4.0_wp]
      records(3)%moments = [1.0_wp, 4.0_wp, 5.0_wp]
      call compare_case(variants, records)
      call assertEqual(2.0_wp/5.0_wp, records(1)%errors(error_bending), round_off, message='triangle')
      call assertEqual(sqrt(1.0_wp/3.0_wp)/5.0_wp, records(1)%errors(error_bending_rms), round_off, message='its rms')
      records(1)%moments(3) = 2.0_wp
      records(3)%moments(2) = 9.0_wp
      records(3)%bending = 9.0_wp
      call compare_case(variants, records)
      call assertEqual(5.0_wp/9.0_wp, records(1)%errors(error_bending), round_off, message='a peak that the record has not')
   end subroutine test_profiles

   !> Where the finest finds no solution the next is the reference, and what has none has no error.
   subroutine test_lost_reference()
      type(variant_type) :: variants(3)
      type(study_record_type) :: records(3)
      call three_meshes(variants, records)
      records(3)%status = result_not_converged
      call compare_case(variants, records)
      call assertTrue(records(2)%is_reference)
      call assertTrue(is_missing(records(3)%errors(error_hookload)) .and. .not. records(3)%in_pareto_set)
      call assertEqual(12.0e-3_wp/1.004_wp, records(1)%errors(error_hookload), round_off)
      records%status = result_not_converged
      records%is_reference = .false.
      call compare_case(variants, records)
      call assertFalse(any(records%is_reference))
   end subroutine test_lost_reference

   !> Cheap and rough, dear and fine, one beaten by the second, one without solution, one as good as the first but slower.
   subroutine test_pareto()
      logical :: worth(5)
      worth = pareto_set([1.0e-2_wp, 1.0e-4_wp, 2.0e-4_wp, missing, 1.0e-2_wp], [1.0_wp, 5.0_wp, 6.0_wp, 0.1_wp, 2.0_wp])
      call assertTrue(all(worth .eqv. [.true., .true., .false., .false., .false.]))
   end subroutine test_pareto
end module dg_test_study

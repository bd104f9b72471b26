!> Every operation by every model, on the deck that shows them side by side, input/operations.nml: friction, torque and contact
!> agree, and stand in the order that friction gives them.
module dg_test_operations
   use funit, only: anyExceptions, assertEqual, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_list_type, error_text, error_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_load_case, only: moves_axially, operation_count, operation_name, rotates
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_read_deck, only: read_deck
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: note
   implicit none
   private
   public :: operations_suite

   integer, parameter :: soft = 1, rigid = 2, mixed = 3, mcge = 4
   character(*), parameter :: names(4) = [character(5) :: 'soft', 'rigid', 'mixed', 'mcge']
   !> Largest difference of a model's friction, torque and contact force from the soft string's, over its value [-]. Stiffness adds
   !> pairs of contact forces at the ends of the bend, in this well some 1e-5 of the whole. Beams hang free where they cross from
   !> the high side of the bend to the low side below it, 2c = 46 mm down in l = sqrt(4 c T/(w sin)) = 10 m: that takes off about 2
   !> w sin l = 5 kN of 518.
   real(wp), parameter :: apart(4) = [0.0_wp, 5.0e-5_wp, 5.0e-5_wp, 0.016_wp]
   !> Hook load without friction over the weight: what beams gain by lying lower than the axis and by bending.
   real(wp), parameter :: lifted = 2.0e-4_wp

contains

   function operations_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('operations')
      call suite%addTest(TestMethod('all_models_agree', test_agreement))
      call suite%addTest(TestMethod('friction_gives_the_order', test_order))
   end function operations_suite

   subroutine solve_all(model, results)
      type(model_type), intent(out) :: model
      type(case_result_type), allocatable, intent(out) :: results(:, :)   !< (case, model)
      type(job_type) :: job
      type(error_list_type) :: faults
      type(error_type), allocatable :: error
      character(:), allocatable :: first
      integer :: i
      call read_deck('input/operations.nml', model, job, faults)
      first = ''
      if (faults%count > 0) first = error_text(faults%items(1))
      call assertEqual('', first, message='no fault')
      if (anyExceptions()) return
      allocate (results(size(model%cases), size(names)))
      do i = 1, size(model%cases)
         call solve_soft_string(model, i, results(i, soft), error)
         call solve_rigid_string(model, i, results(i, rigid), error)
         call solve_mixed_string(model, i, results(i, mixed), error)
         call solve_static_analysis(model, i, results(i, mcge), error)
      end do
   end subroutine solve_all

   subroutine test_agreement()
      type(model_type) :: model
      type(case_result_type), allocatable :: results(:, :)
      character(:), allocatable :: what
      integer :: i, m
      call solve_all(model, results)
      if (anyExceptions()) return
      do i = 1, operation_count
         call assertTrue(any(model%cases%operation == i), message=trim(operation_name(i))//' is in the deck')
      end do
      do i = 1, size(results, 1)
         associate (load_case => model%cases(i), reference => results(i, soft))
            do m = 1, size(names)
               what = load_case%name//', '//trim(names(m))
               associate (result => results(i, m))
                  call assertEqual(result_converged, result%status, message=what)
                  call assertRelativelyEqual(reference%hookload + reference%friction, result%hookload + result%friction, &
                                             1.0e-9_wp, message=what//': one weight')
                  if (m == soft) cycle
                  call note(what//': contact', result%normal_force/reference%normal_force - 1.0_wp)
                  call assertRelativelyEqual(reference%normal_force, result%normal_force, apart(m), message=what//': contact')
                  if (moves_axially(load_case%operation)) then
                     call note(what//': friction', result%friction/reference%friction - 1.0_wp)
                     call assertRelativelyEqual(reference%friction, result%friction, apart(m), message=what//': friction')
                  else
                     call assertEqual(reference%hookload, result%hookload, lifted*reference%hookload, &
                                      message=what//': no friction')
                  end if
                  if (rotates(load_case%operation)) then
                     call note(what//': torque', result%torque/reference%torque - 1.0_wp)
                     call assertRelativelyEqual(reference%torque, result%torque, apart(m), message=what//': torque')
                  else
                     call assertEqual(load_case%tob, result%torque, 1.0e-6_wp*max(load_case%tob, 1.0_wp), &
                                      message=what//': the torque of the bit alone')
                  end if
               end associate
            end do
         end associate
      end do
   end subroutine test_agreement

   !> Overpull above pulling above pulling while turning above turning, and so down; turning off bottom hangs what hangs without
   !> friction, and turns harder the less it moves along.
   subroutine test_order()
      type(model_type) :: model
      type(case_result_type), allocatable :: results(:, :)
      integer :: m
      call solve_all(model, results)
      if (anyExceptions()) return
      do m = 1, size(names)
         call above('overpull', 'up')
         call above('up', 'backream')
         call above('backream', 'rotate')
         call above('rotate', 'ream')
         call above('ream', 'down')
         call above('rotate', 'rotary')
         call above('down', 'sliding')
         call assertRelativelyEqual(results(case_named('static'), m)%hookload, results(case_named('rotate'), m)%hookload, &
                                    1.0e-6_wp, message=names(m)//': turning takes no hook load')
         call assertLessThan(results(case_named('ream'), m)%torque, results(case_named('rotate'), m)%torque, &
                             message=names(m)//': reaming shares friction')
      end do
   contains
      subroutine above(upper, lower)
         character(*), intent(in) :: upper, lower
         call assertLessThan(results(case_named(lower), m)%hookload, results(case_named(upper), m)%hookload, &
                             message=names(m)//': '//upper//' above '//lower)
      end subroutine above

      integer function case_named(name)
         character(*), intent(in) :: name
         do case_named = 1, size(model%cases)
            if (model%cases(case_named)%name == name) return
         end do
      end function case_named
   end subroutine test_order
end module dg_test_operations

!> Tools that open below casing: a string with one is, by all methods, that with a plain part of the diameter that it has there.
module dg_test_opened_tools
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_assembly_picture, only: assembly_chart
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type
   use dg_error, only: error_type
   use dg_gnuplot_script, only: chart_script
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_trip_in, operation_trip_out
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_test_wells, only: part, three_part_well
   use dg_text, only: text_type
   use dg_units, only: si_units
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: opened_tools_suite

   character(*), parameter :: methods(4) = [character(5) :: 'soft', 'rigid', 'mixed', 'mcge']
   real(wp), parameter :: shoe = 1400.0_wp, bottom = 2000.0_wp
   real(wp), parameter :: hole = 0.2509_wp, closed = 0.213_wp, opened = 0.2477_wp   !< diameters [m]
   real(wp), parameter :: pilot = 30.0_wp, tool = 1.2_wp                            !< lengths below the tool and of it [m]
   real(wp), parameter :: same = 1.0e-10_wp

contains

   function opened_tools_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('opened_tools')
      call suite%addTest(TestMethod('open_below', test_open))
      call suite%addTest(TestMethod('closed_above', test_closed))
      call suite%addTest(TestMethod('opens_as_a_whole', test_whole))
      call suite%addTest(TestMethod('joint_by_joint', test_discrete))
      call suite%addTest(TestMethod('bicentre_bit', test_bit))
      call suite%addTest(TestMethod('picture', test_picture))
      call suite%addTest(TestMethod('weight_that_yields_it', test_yield))
      call suite%addTest(TestMethod('packer_fills_its_hole', test_packer))
   end function opened_tools_suite

   !> Collars of the pilot hole, a reamer, collars, heavy-weight pipe, drill pipe; the bit at a depth.
   subroutine build(model, bit, touching, opened_od)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: bit                      !< [m]
      real(wp), intent(in) :: touching                 !< closed diameter of the reamer [m]
      real(wp), intent(in), optional :: opened_od      !< absent: the reamer does not open [m]
      type(component_type), allocatable :: parts(:)
      call three_part_well(model, [0.0_wp, 600.0_wp, 1200.0_wp, bottom], [0.0_wp, 0.0_wp, 50.0_wp, 55.0_wp], shoe)
      model%holes(2)%diameter = hole
      model%cases(1)%bit_depth = bit
      associate (above => model%strings(1)%components)
         allocate (parts(2 + size(above)))
         parts(1) = part('collar', pilot, 0.17145_wp, 0.0714_wp, 160.87051759_wp, 0.0_wp)
         parts(2) = part('stabilizer', tool, 0.19_wp, 0.0714_wp, 190.0_wp, touching)
         parts(3:) = above
      end associate
      call move_alloc(parts, model%strings(1)%components)
      if (present(opened_od)) model%strings(1)%components(2)%opened_od = opened_od
      if (present(opened_od)) model%strings(1)%components(2)%opened_below = shoe
      model%strings(1)%components%yield = 700.0e6_wp
   end subroutine build

   subroutine solve_by(model, method, operation, result)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: method, operation
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      model%cases(1)%operation = operation
      model%cases(1)%wob = 0.0_wp
      if (operation == operation_rotary_drilling) model%cases(1)%wob = 40.0e3_wp
      select case (trim(methods(method)))
      case ('soft'); call solve_soft_string(model, 1, result, error)
      case ('rigid'); call solve_rigid_string(model, 1, result, error)
      case ('mixed'); call solve_mixed_string(model, 1, result, error)
      case default; call solve_static_analysis(model, 1, result, error)
      end select
      call assertFalse(allocated(error), message=methods(method))
      call assertEqual(result_converged, result%status, message=methods(method))
   end subroutine solve_by

   !> Totals, profile and buckling limits of two models agree, by all methods.
   subroutine compare(first, second, what)
      type(model_type), intent(inout) :: first, second
      character(*), intent(in) :: what
      integer, parameter :: operations(2) = [operation_trip_out, operation_rotary_drilling]
      integer :: method, i
      do method = 1, size(methods)
         do i = 1, size(operations)
            call compare_by(first, second, method, operations(i), what//' '//methods(method))
         end do
      end do
   end subroutine compare

   subroutine compare_by(first, second, method, operation, what)
      type(model_type), intent(inout) :: first, second
      integer, intent(in) :: method, operation
      character(*), intent(in) :: what
      type(case_result_type) :: one, other
      type(along_string_type) :: along, along_other
      type(whole_string_type) :: whole, whole_other
      call solve_by(first, method, operation, one)
      call solve_by(second, method, operation, other)
      call assertEqual(other%hookload, one%hookload, same*abs(other%hookload), message=what//': hook load')
      call assertEqual(other%torque, one%torque, same*max(abs(other%torque), 1.0_wp), message=what//': torque')
      call assertEqual(other%normal_force, one%normal_force, same*other%normal_force, message=what//': contact')
      call assertEqual(size(other%profile%md), size(one%profile%md), message=what//': rows')
      if (size(other%profile%md) /= size(one%profile%md)) return
      call assertEqual(other%profile%displacement, one%profile%displacement, same*hole, message=what//': place in the hole')
      call assertEqual(other%profile%bending, one%profile%bending, same*maxval(other%profile%bending), message=what//': bending')
      call find_along_string(first, one, along)
      call find_along_string(second, other, along_other)
      call assertTrue(all(abs(along%sinusoidal - along_other%sinusoidal) <= same*abs(along_other%sinusoidal)), &
                      message=what//': buckling limits')
      call find_whole_string(first, one, along, whole)
      call find_whole_string(second, other, along_other, whole_other)
      call assertEqual(whole_other%wob_lockup%value, whole%wob_lockup%value, same*whole_other%wob_lockup%value, &
                       message=what//': weight on bit before lock-up')
      call assertEqual(whole_other%wob_yield%value, whole%wob_yield%value, same*whole_other%wob_lockup%value, &
                       message=what//': weight on bit before yield')
   end subroutine compare_by

   !> Hook load, torque and sum of contact of a model by the beams [N, N.m, N].
   function totals_of(model) result(totals)
      type(model_type), intent(inout) :: model
      real(wp) :: totals(3)
      type(case_result_type) :: result
      call solve_by(model, size(methods), operation_rotary_drilling, result)
      totals = [result%hookload, result%torque, result%normal_force]
   end function totals_of

   subroutine test_open()
      type(model_type) :: tool_model, plain, narrow
      real(wp) :: difference(3)
      call build(tool_model, bottom, closed, opened)
      call build(plain, bottom, opened)
      call compare(tool_model, plain, 'open')
      call build(narrow, bottom, closed)
      difference = abs(totals_of(plain) - totals_of(narrow))
      call assertGreaterThan(difference(2), 1.0_wp, message='torque knows the diameter')
   end subroutine test_open

   subroutine test_closed()
      type(model_type) :: tool_model, plain
      call build(tool_model, shoe - 10.0_wp, closed, opened)
      call build(plain, shoe - 10.0_wp, closed)
      call compare(tool_model, plain, 'closed')
   end subroutine test_closed

   !> A tool that stands astride its depth is closed; from where its upper end is there on, to round-off, it is open.
   subroutine test_whole()
      type(model_type) :: tool_model, plain
      real(wp), parameter :: hair = 1.0e-9_wp
      call build(tool_model, shoe + pilot + 0.9_wp*tool, closed, opened)
      call build(plain, shoe + pilot + 0.9_wp*tool, closed)
      call compare(tool_model, plain, 'astride')
      call build(tool_model, shoe + pilot + tool - hair, closed, opened)
      call build(plain, shoe + pilot + tool - hair, opened)
      call compare(tool_model, plain, 'just below')
   end subroutine test_whole

   !> Where tool joints touch one by one, a tool that opens touches all along, whatever its kind is called.
   subroutine test_discrete()
      type(model_type) :: tool_model, plain
      integer :: i
      do i = 1, 2
         if (i == 1) call build(tool_model, bottom, closed, opened)
         if (i == 2) call build(tool_model, shoe - 10.0_wp, closed, opened)
         tool_model%strings(1)%components(2)%kind = 'under-reamer'
         if (i == 1) call build(plain, bottom, opened)
         if (i == 2) call build(plain, shoe - 10.0_wp, closed)
         tool_model%numerics%discrete_joints = .true.
         plain%numerics%discrete_joints = .true.
         call compare_by(tool_model, plain, size(methods), operation_trip_out, 'joint by joint')
      end do
   end subroutine test_discrete

   !> A bit that passes the casing and drills the hole below it, at the axis of which it is held.
   subroutine test_bit()
      type(model_type) :: tool_model, plain
      call build(tool_model, bottom, closed, opened)
      call build(plain, bottom, closed, opened)
      tool_model%strings(1)%components(1)%kind = 'bit'
      tool_model%strings(1)%components(1)%length = 0.4_wp
      plain%strings(1)%components(1) = tool_model%strings(1)%components(1)
      tool_model%strings(1)%components(1)%joint_od = closed
      tool_model%strings(1)%components(1)%opened_od = hole
      tool_model%strings(1)%components(1)%opened_below = shoe
      plain%strings(1)%components(1)%joint_od = hole
      call compare(tool_model, plain, 'bit')
   end subroutine test_bit

   !> The picture of the assembly draws what touches.
   subroutine test_picture()
      type(model_type) :: models(2)
      type(case_result_type) :: results(2)
      type(job_type) :: job
      type(text_type), allocatable :: lines(:), wanted(:)
      integer :: i, k
      job%units = si_units()
      do k = 1, 2
         call build(models(1), merge(bottom, shoe - 10.0_wp, k == 1), closed, opened)
         call build(models(2), merge(bottom, shoe - 10.0_wp, k == 1), merge(opened, closed, k == 1))
         do i = 1, 2
            call solve_by(models(i), size(methods), operation_trip_out, results(i))
         end do
         call chart_script(assembly_chart(job, models(1), results(1)), lines)
         call chart_script(assembly_chart(job, models(2), results(2)), wanted)
         call assertEqual(size(wanted), size(lines))
         do i = 1, min(size(wanted), size(lines))
            if (lines(i)%text /= wanted(i)%text) call assertEqual(wanted(i)%text, lines(i)%text)
         end do
      end do
   end subroutine test_picture

   !> A long slender tool that coils before it yields: its clearance says under which weight on bit.
   subroutine test_yield()
      type(model_type) :: models(3)
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: weight(3)
      integer :: i
      call build(models(1), bottom, closed, opened)
      call build(models(2), bottom, opened)
      call build(models(3), bottom, closed)
      do i = 1, 3
         associate (parts => models(i)%strings(1)%components)
            parts%yield = 0.0_wp
            parts(2)%yield = 300.0e6_wp
            parts(2)%length = 200.0_wp
            parts(2)%od = 0.06_wp
            parts(2)%id = 0.05_wp
            parts(2)%mass = 10.0_wp
         end associate
         call solve_by(models(i), 1, operation_trip_in, result)
         call find_along_string(models(i), result, along)
         call find_whole_string(models(i), result, along, whole)
         call assertTrue(whole%wob_yield%present)
         weight(i) = whole%wob_yield%value
      end do
      call assertEqual(weight(2), weight(1), same*weight(2), message='open')
      call assertGreaterThan(weight(2), 1.01_wp*weight(3), message='less room, more weight')
   end subroutine test_yield

   !> Solve a tool as wide as its hole by all methods. It has a quarter of a millimetre of room, as a bit has.
   subroutine test_packer()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: method
      call build(model, bottom, closed, hole)
      do method = 1, size(methods)
         call solve_by(model, method, operation_trip_out, result)
         call assertGreaterThan(result%hookload, 0.0_wp, message=methods(method))
      end do
   end subroutine test_packer
end module dg_test_opened_tools

!> The door for programs of others: what it solves is what a deck solves, and nonsense that a program fills in comes back as an
!> error, whatever it is. The nonsense is tried under run-time checks and traps, too (.ci/run), where it must not stop the program.
module dg_test_library
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_missing, only: is_missing
   use dg_finite_result, only: finish_result
   use dg_file_system, only: delete_file, write_text_file
   use dg_library_parts, only: drilling, fill, loads, quantities, refuse, refuse_case, spoil, spoil_case
   use dg_text, only: append_text, text_type, to_text
   use drillgap, only: add_component, add_fluid, case_result_type, collar_closed, deck_type, degree, error_type, given, &
      load_case_type, method_name, model_parts_type, model_type, new_model, operation_ream, operation_trip_out, &
      outcome_type, read_deck, result_converged, result_not_converged, settings_of, solve, solve_cases, wp
   implicit none
   private
   public :: library_suite

   character(*), parameter :: path = 'build/test_library.nml'
contains

   function library_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('library')
      call suite%addTest(TestMethod('parts_and_deck_give_the_same', test_same_as_deck, tearDown=remove_deck))
      call suite%addTest(TestMethod('deck_with_faults', test_deck_faults, tearDown=remove_deck))
      call suite%addTest(TestMethod('numbers_that_are_none', test_not_finite))
      call suite%addTest(TestMethod('numbers_out_of_range', test_ranges))
      call suite%addTest(TestMethod('nothing_filled_in', test_empty))
      call suite%addTest(TestMethod('surveys', test_surveys))
      call suite%addTest(TestMethod('holes', test_holes))
      call suite%addTest(TestMethod('strings', test_strings))
      call suite%addTest(TestMethod('fluids_and_settings', test_fluids))
      call suite%addTest(TestMethod('load_cases', test_load_cases))
      call suite%addTest(TestMethod('all_faults_at_once', test_all_faults))
      call suite%addTest(TestMethod('tool_that_opens', test_tool))
      call suite%addTest(TestMethod('more_memory_than_there_is', test_memory))
      call suite%addTest(TestMethod('threads', test_threads))
      call suite%addTest(TestMethod('results_that_are_no_numbers', test_runaway))
   end function library_suite

   subroutine remove_deck()
      call delete_file(path)
   end subroutine remove_deck

   subroutine test_same_as_deck()
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(deck_type) :: deck
      type(case_result_type) :: from_parts, from_deck
      type(error_type), allocatable :: error
      type(text_type), allocatable :: lines(:)
      integer :: i
      call append_text(lines, "&job models = 'soft', 'mcge' /")
      call append_text(lines, '&trajectory md = 0, 600, 1500, 2400, inc = 0, 0, 60, 60, azi = 45, 45, 45, 45 /')
      call append_text(lines, '&hole diameter = 224.5, friction = 0.2, md_bottom = 1500 /')
      call append_text(lines, '&hole diameter = 215.9, friction = 0.25 /')
      call append_text(lines, '&fluid density = 1200 /')
      call append_text(lines, "&component kind = 'collar', length = 120, od = 165.1, id = 71.4 /")
      call append_text(lines, '&component od = 127.0, id = 108.6, mass = 31.9, joint_od = 161.9 /')
      call append_text(lines, "&load_case name = 'drill', operation = 'rotary', bit_depth = 2400, wob = 50, tob = 3 /")
      call write_text_file(path, lines, error)
      call read_deck(path, deck, error)
      call assertFalse(allocated(error), message='deck read')
      if (allocated(error)) return
      call assertEqual(1, size(deck%cases))
      call assertTrue(all(deck%methods == [character(5) :: 'soft', 'mcge']))
      call assertEqual('', deck%notes)
      call fill(parts)
      call new_model(model, parts, error)
      call assertFalse(allocated(error), message='model made')
      do i = 1, size(method_name)
         call solve(model, drilling(), method_name(i), from_parts, error)
         call assertFalse(allocated(error), message='solved')
         call solve(deck%model, deck%cases(1), method_name(i), from_deck, error)
         call assertEqual(result_converged, from_parts%status)
         call assertEqual(from_deck%hookload, from_parts%hookload, 1.0e-9_wp*from_deck%hookload, message=method_name(i))
         call assertEqual(from_deck%torque, from_parts%torque, 1.0e-9_wp*from_deck%torque, message=method_name(i))
      end do
   end subroutine test_same_as_deck

   subroutine test_deck_faults()
      type(deck_type) :: deck
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      type(text_type), allocatable :: lines(:)
      call append_text(lines, '&trajectory md = 0, 600, inc = 0, 0 /')
      call append_text(lines, '&hole diameter = -1 /')
      call append_text(lines, '&component od = 127 /')
      call append_text(lines, "&load_case name = 'a', operation = 'up', bit_depth = 700 /")
      call write_text_file(path, lines, error)
      call read_deck(path, deck, error)
      call assertTrue(allocated(error), message='refused')
      if (.not. allocated(error)) return
      call assertTrue(index(error%message, path//':2: group &hole') == 1, message=error%message)
      call assertTrue(index(error%message, new_line('a')//path//':4: ') > 0, message=error%message)
      call solve(deck%model, drilling(), 'soft', result, error)
      call assertTrue(allocated(error), message='solves nothing')
      call read_deck('build/no_such_deck.nml', deck, error)
      call assertTrue(allocated(error), message='no deck')
   end subroutine test_deck_faults

   subroutine test_not_finite()
      type(model_parts_type) :: parts
      type(load_case_type) :: load_case
      real(wp) :: number
      integer :: i, k
      do k = 1, 2
         number = ieee_value(number, ieee_quiet_nan)
         if (k == 2) number = ieee_value(number, ieee_positive_inf)
         do i = 1, quantities
            call fill(parts)
            call spoil(parts, i, number)
            call refuse(parts, 'not a finite number')
         end do
         do i = 1, loads
            load_case = drilling()
            call spoil_case(load_case, i, number)
            call refuse_case(load_case, 'not a finite number')
         end do
      end do
   end subroutine test_not_finite

   !> Refuse negative values, and a thousand times the limit: millimetres, kilometres, per cent.
   subroutine test_ranges()
      integer, parameter :: may_be_negative(1) = [3]
      type(model_parts_type) :: parts
      type(load_case_type) :: load_case
      integer :: i
      do i = 1, quantities
         if (any(i == may_be_negative)) cycle
         call fill(parts)
         call spoil(parts, i, -1.0_wp)
         call refuse(parts, ': ')
         call fill(parts)
         call spoil(parts, i, 1.0e30_wp)
         call refuse(parts, ': ')
      end do
      do i = 1, loads
         load_case = drilling()
         call spoil_case(load_case, i, 1.0e30_wp)
         call refuse_case(load_case, 'out of range')
         if (i == 2) cycle            ! a bit that is pulled
         load_case = drilling()
         call spoil_case(load_case, i, -10.0_wp)
         call refuse_case(load_case, 'out of range')
      end do
      call fill(parts)
      parts%holes(2)%diameter = 215.9_wp
      call refuse(parts, 'holes(2): diameter = 215.9 m is out of range; needs a number, 0.001 to 5 m')
      call fill(parts)
      parts%strings(1)%components(2)%od = 127.0_wp
      call refuse(parts, 'strings(1)%components(2): od = 127 m is out of range')
   end subroutine test_ranges

   subroutine test_empty()
      type(model_parts_type) :: empty, parts
      type(model_type) :: model
      type(case_result_type) :: result
      type(load_case_type) :: load_case
      type(error_type), allocatable :: error
      call refuse(empty, 'survey: md is not allocated')
      call refuse(empty, 'holes: missing; give sections from surface down')
      call refuse(empty, 'strings: missing')
      call fill(parts)
      deallocate (parts%survey%inclination)
      call refuse(parts, 'survey: inclination is not allocated')
      call fill(parts)
      deallocate (parts%strings(1)%components)
      call refuse(parts, 'strings(1): it has no components')
      call refuse_case(load_case, 'bit_depth')
      call solve(model, drilling(), 'soft', result, error)
      call assertTrue(allocated(error), message='no model was made')
      call fill(parts)
      call new_model(model, parts, error)
      call assertFalse(allocated(error))
      call solve(model, drilling(), 'finite elements', result, error)
      call assertTrue(allocated(error), message='no such method')
      call solve(model, drilling(), 'MCGE', result, error)
      call assertFalse(allocated(error), message='large letters')
      deallocate (parts%survey%azimuth, parts%fluids)
      deallocate (parts%strings(1)%name, parts%strings(1)%components(1)%name, parts%strings(1)%components(1)%kind)
      call new_model(model, parts, error)
      call assertFalse(allocated(error), message='what has a default')
      call solve(model, drilling(), 'soft', result, error)
      call assertFalse(allocated(error), message='solves with names left out')
   end subroutine test_empty

   subroutine test_surveys()
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call fill(parts)
      parts%survey%md(3) = 300.0_wp
      call refuse(parts, 'survey: station 3 at 300 m is not below station 2 at 600 m')
      call fill(parts)
      parts%survey%md = [0.0_wp]
      parts%survey%inclination = [0.0_wp]
      parts%survey%azimuth = [0.0_wp]
      call refuse(parts, 'survey: md holds 1 station(s); at least two are needed')
      call fill(parts)
      parts%survey%inclination = [0.0_wp, 1.0_wp]
      call refuse(parts, 'survey: inclination has 2 values, md has 4')
      call fill(parts)
      parts%survey%inclination(:2) = 10.0_wp*degree
      parts%survey%md(1) = 100.0_wp
      call refuse(parts, 'survey: the first station is at 100 m and inclined')
      call fill(parts)
      parts%survey%interpolation = 7
      call refuse(parts, 'survey: interpolation = 7')
      call fill(parts)
      parts%survey%inclination(3) = 60.0_wp      ! degrees
      call refuse(parts, 'inclination = 60 rad is out of range')
      call fill(parts)
      parts%survey%md(1) = 100.0_wp
      call new_model(model, parts, error)
      call assertFalse(allocated(error), message='vertical above the first station')
      call solve(model, drilling(), 'soft', result, error)
      call assertFalse(allocated(error))
      call assertEqual(0.0_wp, result%profile%md(1))
   end subroutine test_surveys

   subroutine test_holes()
      type(model_parts_type) :: parts
      call fill(parts)
      parts%holes(2)%md_top = 1600.0_wp
      call refuse(parts, 'holes(2): md_top = 1600 m leaves a gap below the section above (holes(1)), which ends at 1500 m')
      call fill(parts)
      parts%holes(2)%md_top = 1400.0_wp
      call refuse(parts, 'leaves an overlap with')
      call fill(parts)
      parts%holes(1)%md_top = 10.0_wp
      call refuse(parts, 'holes(1): the uppermost section begins at 10 m')
      call fill(parts)
      parts%holes(1)%md_top = 1600.0_wp
      call refuse(parts, 'holes(1): md_bottom = 1500 m is not below md_top = 1600 m')
      call fill(parts)
      parts%holes = parts%holes([2, 1])
      call refuse(parts, 'holes(1): md_bottom = 0 m is out of range')      ! only the last may leave its end open
   end subroutine test_holes

   subroutine test_strings()
      type(model_parts_type) :: parts
      call fill(parts)
      parts%strings(1)%components(2)%mass = 0.0_wp
      call refuse(parts, 'strings(1)%components(2): mass = 0')
      call fill(parts)
      parts%strings(1)%components(1)%length = 0.0_wp
      call refuse(parts, 'only the last component')
      call fill(parts)
      parts%strings(1)%components(1)%id = 0.2_wp
      call refuse(parts, 'id = 0.2 is not smaller than od = 0.1651')
      call fill(parts)
      parts%strings(1)%components(2)%joint_od = 0.1_wp
      call refuse(parts, 'joint_od = 0.1 is smaller than od = 0.127')
      call fill(parts)
      parts%strings(1)%components(2)%density = 1100.0_wp
      call refuse(parts, 'floats')
      call fill(parts)
      parts%strings(1)%components(1)%centralizer%present = .true.
      parts%strings(1)%components(1)%centralizer%spacing = 10.0_wp
      parts%strings(1)%components(1)%centralizer%od = 0.16_wp
      call refuse(parts, 'strings(1)%components(1)%centralizer: od = 0.16 m is not greater than that of ''collar'' ')
      call fill(parts)
      call add_component(parts, 'drillpipe', od=0.127_wp, id=0.1086_wp, string='main')
      call refuse(parts, 'components(2): length of ''drillpipe'' is missing or 0')
      call fill(parts)
      call add_component(parts, 'drillpipe', od=0.127_wp, id=0.1086_wp, string='other')
      parts%strings(2)%name = 'main'
      call refuse(parts, 'strings(2): name ''main'' is taken by strings(1)')
   end subroutine test_strings

   subroutine test_fluids()
      type(model_parts_type) :: parts
      call fill(parts)
      call add_fluid(parts, density=1300.0_wp)
      call refuse(parts, 'fluids(1): the fluid in fluids(2) fills its whole length')
      call fill(parts)
      parts%fluids(1)%collar = collar_closed
      call refuse(parts, 'fluids(1): a float_collar')
      call fill(parts)
      parts%fluids(1)%collar = 17
      call refuse(parts, 'fluids(1): collar = 17 is not a valid collar')
      call fill(parts)
      parts%numerics = settings_of('auto')
      parts%numerics%gk_contact = 500.0_wp
      parts%numerics%gk_min = 2.0_wp*parts%numerics%gk_contact
      call refuse(parts, 'numerics: gk_min must be smaller')
      parts%numerics = settings_of('auto')
      parts%numerics%max_iterations = 0
      call refuse(parts, 'numerics: max_iterations')
      parts%numerics = settings_of('auto')
      parts%numerics%linear_solver = 0
      call refuse(parts, 'numerics: linear_solver = 0 is not valid; needs a number from 1 to ')
      call fill(parts)
      parts%rig%lines = 0
      call refuse(parts, 'rig: lines')
   end subroutine test_fluids

   subroutine test_load_cases()
      type(load_case_type) :: load_case
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      load_case = drilling()
      load_case%string = 'mian'
      call refuse_case(load_case, 'no component belongs to string ''mian''; did you mean ''main''?')
      load_case%string = ''
      call refuse_case(load_case, 'no component belongs to string ''''')
      load_case = drilling()
      load_case%bit_depth = 2500.0_wp
      call refuse_case(load_case, 'bit_depth = 2500 m lies below the survey, which ends at 2400 m')
      load_case = drilling()
      load_case%operation = 99
      call refuse_case(load_case, 'operation = 99 is not a valid operation; needs a number from 1 to ')
      load_case = drilling()
      load_case%operation = operation_ream
      call refuse_case(load_case, 'operation ream needs angular_speed > 0')
      call fill(parts)
      parts%strings(1)%components(2)%fatigue%curve = 9
      call new_model(model, parts, error)
      call assertTrue(allocated(error), message='fatigue curve')
      if (allocated(error)) call assertTrue(index(error%message, 'curve = 9 is not a valid fatigue curve') > 0, &
                                            message=error%message)
      call fill(parts)
      parts%strings(1)%components(2)%length = 1000.0_wp
      call new_model(model, parts, error)
      call assertFalse(allocated(error))
      call solve(model, drilling(), 'mcge', result, error)
      call assertTrue(allocated(error), message='too short')
      if (allocated(error)) call assertTrue(index(error%message, 'does not reach surface') > 0, message=error%message)
      call fill(parts)
      parts%strings(1)%components(1)%od = 0.22_wp
      call new_model(model, parts, error)
      call assertFalse(allocated(error))
      call solve(model, drilling(), 'mcge', result, error)
      call assertTrue(allocated(error), message='too wide')
      if (allocated(error)) call assertTrue(index(error%message, 'does not pass the hole of 0.2159 m (holes(2))') > 0, &
                                            message=error%message)
   end subroutine test_load_cases

   !> Collars that open below the casing at 1500 m, or below 2350 m: those with a joint_od of that diameter, or without.
   subroutine test_tool()
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      real(wp) :: torque(4)
      integer :: i
      do i = 1, 4
         call fill(parts)
         parts%holes(1)%cased = .true.
         associate (part => parts%strings(1)%components(1))
            if (i == 2) part%joint_od = 0.21_wp
            if (i > 2) part%opened_od = 0.21_wp
            if (i == 4) part%opened_below = 2350.0_wp
         end associate
         call new_model(model, parts, error)
         call assertFalse(allocated(error))
         call solve(model, drilling(), 'soft', result, error)
         call assertFalse(allocated(error))
         torque(i) = result%torque
      end do
      call assertEqual(torque(2), torque(3), message='open')
      call assertEqual(torque(1), torque(4), message='closed')
      call assertTrue(torque(2) > torque(1), message='torque knows the diameter')
   end subroutine test_tool

   !> Tool joints every five millimetres in a hole of 49 km: elements of a millimetre, 300 GB.
   subroutine test_memory()
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(load_case_type) :: load_case
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call fill(parts)
      parts%survey%md(4) = 49.0e3_wp
      parts%numerics = settings_of('reference')
      parts%numerics%element_length = 0.01_wp
      parts%numerics%discrete_joints = .true.
      parts%strings(1)%components%joint_spacing = 0.005_wp
      call new_model(model, parts, error)
      call assertFalse(allocated(error))
      load_case = drilling()
      load_case%bit_depth = 49.0e3_wp
      call solve(model, load_case, 'mcge', result, error)
      call assertTrue(allocated(error), message='hundreds of gigabytes')
      if (allocated(error)) call assertTrue(index(error%message, 'GB of memory') > 0, message=error%message)
   end subroutine test_memory

   subroutine test_all_faults()
      type(model_parts_type) :: parts
      integer :: i
      call fill(parts)
      parts%holes(2)%diameter = 215.9_wp
      parts%strings(1)%components(1)%mass = 0.0_wp
      parts%gravity = -1.0_wp
      call refuse(parts, 'holes(2): ')
      call refuse(parts, new_line('a')//'strings(1)%components(1): ')
      call refuse(parts, new_line('a')//'model: gravity')
      do i = 1, 60
         call add_component(parts, 'drillpipe', od=127.0_wp, id=108.0_wp)
      end do
      call refuse(parts, 'and ')
   end subroutine test_all_faults

   !> Cases solved by several threads are those solved one after another, the refused among them, too.
   subroutine test_threads()
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(load_case_type) :: cases(40)
      type(outcome_type), allocatable :: one(:), four(:)
      type(error_type), allocatable :: error
      integer :: i
      call fill(parts)
      call new_model(model, parts, error)
      call assertFalse(allocated(error))
      do i = 1, size(cases)
         cases(i)%operation = operation_trip_out
         cases(i)%bit_depth = 2400.0_wp
         cases(i)%friction_axial = given(0.01_wp*i)
         if (mod(i, 3) == 0) cases(i)%bit_depth = 2400.0_wp + i
         if (mod(i, 4) == 0) cases(i)%string = 'string '//to_text(i)
      end do
      call solve_cases(model, cases, 'soft', one, threads=1)
      call solve_cases(model, cases, 'soft', four, threads=4)
      call assertEqual(size(cases), size(four))
      do i = 1, size(cases)
         call assertTrue(allocated(four(i)%error) .eqv. (mod(i, 3) == 0 .or. mod(i, 4) == 0), message='refused '//to_text(i))
         call assertEqual(one(i)%result%hookload, four(i)%result%hookload, message='same')
         call assertEqual(one(i)%result%message, four(i)%result%message, message='same words')
         call assertEqual(i, four(i)%result%case_index)
      end do
      call solve_cases(model, cases(:0), 'soft', one)
      call assertEqual(0, size(one))
   end subroutine test_threads

   !> A model's last step: a number that is none, of the whole or of a row, is not converged.
   subroutine test_runaway()
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(case_result_type) :: result, spoilt
      type(error_type), allocatable :: error
      real(wp) :: nan
      integer :: i
      nan = ieee_value(nan, ieee_quiet_nan)
      call fill(parts)
      call new_model(model, parts, error)
      call solve(model, drilling(), 'soft', result, error)
      call assertEqual(result_converged, result%status)
      spoilt = result
      call finish_result(spoilt)
      call assertEqual(result_converged, spoilt%status, message='numbers stay')
      call assertEqual(result%hookload, spoilt%hookload)
      do i = 1, 4
         spoilt = result
         if (i == 1) spoilt%hookload = nan
         if (i == 2) spoilt%torque = ieee_value(nan, ieee_positive_inf)
         if (i == 3) spoilt%profile%axial(2) = nan
         if (i == 4) spoilt%profile%bending(3) = nan
         call finish_result(spoilt)
         call assertEqual(result_not_converged, spoilt%status)
         call assertEqual(0.0_wp, spoilt%hookload)
         call assertFalse(allocated(spoilt%profile%md))
         call assertTrue(is_missing(spoilt%bit_tilt) .and. is_missing(spoilt%moment_error), message='bit and moments')
      end do
   end subroutine test_runaway
end module dg_test_library

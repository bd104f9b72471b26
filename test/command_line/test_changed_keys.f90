!> A record of a sweep under a deck whose keys have changed, one at a time: either it is refused, or the key has no part in what is
!> solved, and a sweep from the beginning has the same results.
module dg_test_changed_keys
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_program_run, only: deck_path, replaced, results_path, run_deck_text, run_program, run_type
   use dg_result_rows, only: lines_of
   use dg_text, only: text_type
   implicit none
   private
   public :: changed_keys_suite

   character(*), parameter :: newline = achar(10)
   character(*), parameter :: record = results_path//'/sweep_b.part_1_of_2'
   character(*), parameter :: again = deck_path//' --output '//results_path//' --part 1/2'
   !> Text of the deck, and its replacement.
   character(*), parameter :: changes(2, 66) = reshape([character(80) :: &
      'gravity = 9.8', 'gravity = 9.7', &
      "interpolation = 'minimum_curvature'", "interpolation = 'spline'", &
      'inc = 0.0, 0.0, 30.0', 'inc = 0.0, 0.0, 31.0', &
      'azi = 10.0, 10.0, 12.0', 'azi = 10.0, 10.0, 14.0', &
      'md  = 0.0, 500.0, 900.0', 'md  = 0.0, 510.0, 900.0', &
      "kind = 'random', amplitude = 0.5, period = 35, seed = 1", "kind = 'sine', amplitude = 0.5, period = 35", &
      'amplitude = 0.5', 'amplitude = 0.6', &
      'period = 35', 'period = 40', &
      'seed = 1', 'seed = 2', &
      'md_top = 510.0', 'md_top = 530.0', &
      'md_bottom = 810.0', 'md_bottom = 830.0', &
      'md_bottom = 400.0', 'md_bottom = 410.0', &
      'diameter = 315.9', 'diameter = 316.0', &
      'friction_axial = 0.31', 'friction_axial = 0.32', &
      'friction_rotary = 0.33', 'friction_rotary = 0.34', &
      'wall_stiffness = 1.0e6', 'wall_stiffness = 1.1e6', &
      'mud_sheath = 1.5', 'mud_sheath = 1.6', &
      'cased = .true.', 'cased = .false.', &
      "name = 'lower'", "name = 'other'", &
      'density = 1200.0', 'density = 1210.0', &
      'density = 1300.0', 'density = 1310.0', &
      "where = 'inside', density = 1300.0, above_bit = 100.0, float_collar = 'none'", &
      "where = 'outside', density = 1300.0, md_top = 600.0", &
      'above_bit = 100.0', 'above_bit = 110.0', &
      "float_collar = 'none'", "float_collar = 'closed'", &
      "float_collar = 'none'", "float_collar = 'open_below'", &
      "kind = 'collar'", "kind = 'stabilizer'", &
      'length = 105.0', 'length = 106.0', &
      'od = 171.45', 'od = 172.0', &
      'id = 71.4', 'id = 71.5', &
      'mass = 140.0', 'mass = 141.0', &
      'density = 7850.0', 'density = 7800.0', &
      'youngs = 206.0', 'youngs = 200.0', &
      'poisson = 0.3,', 'poisson = 0.2,', &
      'joint_od = 168.3', 'joint_od = 169.0', &
      'opened_od = 250.0', 'opened_od = 251.0', &
      'opened_below = 500.0', 'opened_below = 501.0', &
      ', opened_below = 500.0', '', &
      'joint_length = 0.51', 'joint_length = 0.55', &
      'joint_spacing = 9.4', 'joint_spacing = 9.6', &
      'yield = 931.0', 'yield = 700.0', &
      'makeup_torque = 20.0', 'makeup_torque = 21.0', &
      "wear_class = 'new'", "wear_class = 'premium'", &
      "wear_class = 'new'", 'wall_left = 0.9', &
      "connection = 'NC50'", "connection = 'NC46'", &
      'joint_id = 82.0', 'joint_id = 83.0', &
      'joint_yield = 827.0', 'joint_yield = 800.0', &
      'friction_scale = 0.9', 'friction_scale = 0.8', &
      'friction_scale = 0.9', 'friction_axial = 0.2', &
      'friction_scale = 0.9', 'friction_rotary = 0.2', &
      'od = 280.0, spacing', 'od = 281.0, spacing', &
      'spacing = 40.0', 'spacing = 41.0', &
      'first = 3.0', 'first = 4.0', &
      "component = 'top', kind = 'rigid'", "component = 'collars', kind = 'rigid'", &
      'friction = 0.21', 'friction = 0.22', &
      'restoring_force = 5.0', 'restoring_force = 6.0', &
      'rated_hole = 311.0', 'rated_hole = 312.0', &
      'running_force = 1.0', 'running_force = 1.1', &
      'block_weight = 100.0', 'block_weight = 110.0', &
      'max_torque = 40.0', 'max_torque = 41.0', &
      "top_lateral = 'centred'", "top_lateral = 'free'", &
      "bit_lateral = 'centred'", "bit_lateral = 'free'", &
      'element_length = 10.0', 'element_length = 9.0', &
      'wob = 20.0', 'wob = 21.0', &
      'tob = 1.0', 'tob = 1.1', &
      'rpm = 60.0', 'rpm = 70.0', &
      'trip_speed = 0.3', 'trip_speed = 0.4'], [2, 66])

contains

   function changed_keys_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('changed_keys')
      call suite%addTest(TestMethod('refused_or_the_same', test_keys))
      call suite%addTest(TestMethod('told_in_units_of_the_deck', test_units))
   end function changed_keys_suite

   function deck() result(text)
      character(:), allocatable :: text
      text = "&job models = 'soft', plots = .false., gravity = 9.8 /"//newline// &
             "&trajectory md  = 0.0, 500.0, 900.0, inc = 0.0, 0.0, 30.0, azi = 10.0, 10.0, 12.0"//newline// &
             "  interpolation = 'minimum_curvature' /"//newline// &
             "&tortuosity kind = 'random', amplitude = 0.5, period = 35, seed = 1, md_top = 510.0, md_bottom = 810.0 /"//newline// &
             "&hole md_top = 0.0, md_bottom = 400.0, diameter = 320.0, friction = 0.25, cased = .true. /"//newline// &
             "&hole name = 'lower', diameter = 315.9, friction_axial = 0.31, friction_rotary = 0.33"//newline// &
             "  wall_stiffness = 1.0e6, mud_sheath = 1.5 /"//newline// &
             "&fluid density = 1200.0 /"//newline// &
             "&fluid where = 'inside', density = 1300.0, above_bit = 100.0, float_collar = 'none' /"//newline// &
             "&component name = 'collars', kind = 'collar', length = 105.0, od = 171.45, id = 71.4, mass = 140.0"//newline// &
             "  density = 7850.0, youngs = 206.0, poisson = 0.3, friction_scale = 0.9 /"//newline// &
             "&component name = 'reamer', kind = 'reamer', length = 1.5, od = 190.0, id = 60.0, opened_od = 250.0"// &
             ", opened_below = 500.0 /"//newline// &
             "&component name = 'pipe', length = 300.0, od = 127.0, id = 108.6, joint_od = 168.3, joint_length = 0.51"//newline// &
             "  joint_spacing = 9.4, yield = 931.0, makeup_torque = 20.0, wear_class = 'new', connection = 'NC50'"//newline// &
             "  joint_id = 82.0, joint_yield = 827.0 /"//newline// &
             "&component name = 'top', od = 127.0, id = 108.6 /"//newline// &
             "&centralizer component = 'top', kind = 'rigid', od = 280.0, spacing = 40.0, first = 3.0"//newline// &
             "  friction = 0.21 /"//newline// &
             "&centralizer component = 'pipe', kind = 'bow', od = 330.0, spacing = 50.0, restoring_force = 5.0"//newline// &
             "  rated_hole = 311.0, running_force = 1.0 /"//newline// &
             "&rig block_weight = 100.0, max_torque = 40.0 /"//newline// &
             "&boundary top_lateral = 'centred', bit_lateral = 'centred' /"//newline// &
             "&solver element_length = 10.0 /"//newline// &
             "&sweep name = 'b', model = 'soft', 'mcge', operations = 'rotary', 'up', bit_depth_from = 850"//newline// &
             "  wob = 20.0, tob = 1.0, rpm = 60.0, trip_speed = 0.3 /"//newline
   end function deck

   subroutine write_deck(text)
      character(*), intent(in) :: text
      type(error_type), allocatable :: error
      type(text_type) :: whole(1)
      whole(1)%text = text
      call write_text_file(deck_path, whole, error)
   end subroutine write_deck

   subroutine test_keys()
      type(run_type) :: run
      type(text_type), allocatable :: base(:), resumed(:), anew(:)
      type(error_type), allocatable :: error
      character(:), allocatable :: what
      integer :: i, j, refused
      run = run_deck_text(deck(), '--part 1/2')
      call assertEqual(0, run%status, message=run%diagnostics)
      allocate (base(0), resumed(0), anew(0))
      base = lines_of(record)
      if (anyExceptions()) return
      refused = 0
      do i = 1, size(changes, 2)
         what = trim(changes(2, i))
         call write_deck(replaced(deck(), trim(changes(1, i)), what))
         call write_text_file(record, base, error)
         run = run_program(again)
         if (run%status == 2) then
            refused = refused + 1
            call assertTrue(index(run%diagnostics, 'it is of another deck: ') > 0, message=what//': '//run%diagnostics)
            cycle
         end if
         call assertEqual(0, run%status, message=what//': '//run%diagnostics)
         resumed = lines_of(record)
         if (anyExceptions()) return
         call delete_file(record)
         run = run_program(again)
         anew = lines_of(record)
         if (anyExceptions()) return
         call assertEqual(size(anew), size(resumed), message=what)
         do j = 1, min(size(anew), size(resumed))
            if (anew(j)%text /= resumed(j)%text) call assertEqual(anew(j)%text, resumed(j)%text, message=what)
         end do
      end do
      ! a deck that is never resumed would pass the rest
      call assertGreaterThan(size(changes, 2), refused)
      call assertGreaterThan(refused, size(changes, 2)/2)
   end subroutine test_keys

   !> Numbers of a refusal are in the units of the deck.
   subroutine test_units()
      type(run_type) :: run
      run = run_deck_text(deck(), '--part 1/2')
      call assertEqual(0, run%status, message=run%diagnostics)
      call refuse('wob = 20.0', 'wob = 21.0', 'wob was 20 kN and is 21 kN')
      call refuse('diameter = 315.9', 'diameter = 316', 'hole 2, diameter was 315.9 mm and is 316 mm')
      call refuse('opened_od = 250.0', 'opened_od = 251', 'component 2, opened_od was 250 mm and is 251 mm')
      call refuse('rpm = 60.0', 'rpm = 70.0', 'rotation was 60 rpm and is 70 rpm')
      call refuse('trip_speed = 0.3', 'trip_speed = 0.4', 'trip speed was 0.3 m/s and is 0.4 m/s')
   contains
      subroutine refuse(old, new, wanted)
         character(*), intent(in) :: old, new, wanted
         call write_deck(replaced(deck(), old, new))
         run = run_program(again)
         call assertEqual(2, run%status, message=wanted)
         call assertTrue(index(run%diagnostics, 'it is of another deck: '//wanted//';') > 0, &
                         message='wanted '//wanted//'; got '//run%diagnostics)
      end subroutine refuse
   end subroutine test_units
end module dg_test_changed_keys

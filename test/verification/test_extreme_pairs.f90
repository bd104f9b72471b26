!> Extremes of two axes at once, strings out of the ordinary, and numbers that are none: the last rows of the table of extremes.
module dg_test_extreme_pairs
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use funit, only: assertTrue, TestMethod, TestSuite
   use dg_constants, only: pi
   use dg_extreme_case, only: answer_type, contact, extreme_case_type, hookload, solve_extreme, verdict_type
   use dg_extreme_reference, only: by_independent_beam, by_short_elements
   use dg_extreme_table, only: begin_row, finish_row, row_type, add_row, add_bent, add_short, add_straight
   use dg_extreme_wells, only: base_well, case_of, horizontal_well, straight_well, tubing_well
   use dg_independent_beam, only: independent_well_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotate_off_bottom, operation_sliding_drilling, operation_static, operation_trip_in, &
                           operation_trip_out
   implicit none
   private
   public :: extreme_pairs_suite

   real(wp), parameter :: mu = 0.3_wp
   integer, parameter :: operations(2) = [operation_trip_out, operation_rotate_off_bottom]
   !> Extremes of the axes: walls [N/m2], lengths of elements and clearances [m].
   real(wp), parameter :: soft = 1.0e5_wp, hard = 1.0e13_wp, short = 0.1_wp, long = 100.0_wp, tight = 1.0e-4_wp, wide = 0.5_wp
   real(wp), parameter :: sixteenth = 0.0625_wp    !< of a metre [m]

contains

   function extreme_pairs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('extreme_pairs')
      call suite%addTest(TestMethod('walls', test_walls))
      call suite%addTest(TestMethod('doglegs', test_doglegs))
      call suite%addTest(TestMethod('steep', test_steep))
      call suite%addTest(TestMethod('loads', test_loads))
      call suite%addTest(TestMethod('strings', test_strings))
      call suite%addTest(TestMethod('bad_numbers', test_bad_numbers))
   end function extreme_pairs_suite

   !> A well with another clearance.
   pure function with_clearance(well, clearance) result(other)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: clearance       !< [m]
      type(independent_well_type) :: other
      other = well
      other%diameter = max(well%od(1), well%joint(1)) + 2.0_wp*clearance
   end function with_clearance

   !> Stiffness of the wall, length of elements and clearance, two by two. References are those of the program on short elements
   !> where clearance over length, or the reference's own wall, matters.
   subroutine test_walls()
      type(row_type) :: row
      type(independent_well_type) :: well
      type(answer_type) :: reference
      character(*), parameter :: room(3) = [character(12) :: 'wide hole', 'usual hole', 'tight hole']
      logical :: found
      integer :: k, i
      call begin_row(row, 'two of wall, elements, clearance', 'ends of each')
      do k = 1, 2
         do i = 1, 3
            well = base_well()
            if (i == 1) well = with_clearance(well, wide)
            if (i == 3) well = with_clearance(well, tight)
            call find_reference(soft)
            if (i == 2) call add_pair(', soft wall, short elements', soft, short)
            if (i == 2) call add_pair(', soft wall, long elements', soft, long)
            if (i /= 2) call add_pair(', soft wall', soft, 0.0_wp)
            call find_reference(0.0_wp)
            if (i == 2) call add_pair(', hard wall, short elements', hard, short)
            if (i == 2) call add_pair(', hard wall, long elements', hard, long)
            if (i /= 2) call add_pair(', hard wall', hard, 0.0_wp)
            if (i == 1 .or. (i == 3 .and. k == 1)) call add_pair(', short elements', 0.0_wp, short)
            if (i /= 2) call add_pair(', long elements', 0.0_wp, long)
         end do
      end do
      call finish_row(row)
   contains
      subroutine find_reference(wall)
         real(wp), intent(in) :: wall               !< [N/m2]; 0: the default
         type(extreme_case_type) :: extreme
         extreme = case_of(well, operations(k), mu, trim(room(i)))
         extreme%wall = wall
         if (i == 2) call by_independent_beam(extreme, reference, found)
         if (i /= 2) call by_short_elements(extreme, reference, found)
         call assertTrue(found, message=trim(extreme%label)//': reference')
      end subroutine find_reference

      subroutine add_pair(label, wall, element)
         character(*), intent(in) :: label
         real(wp), intent(in) :: wall, element      !< [N/m2, m]; 0: the default
         type(extreme_case_type) :: extreme
         extreme = case_of(well, operations(k), mu, trim(room(i))//label)
         extreme%wall = wall
         extreme%element = element
         call add_row(extreme, reference, row)
      end subroutine add_pair
   end subroutine test_walls

   !> A sharp bend, with extremes of the other axes. Where the wall is soft the string lies 28 mm off the axis of the hole,
   !> 0.16 % of the radius. The independent beam leaves that out: its contact is 0.1 % less than that of ever shorter
   !> elements.
   subroutine test_doglegs()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(independent_well_type) :: well
      integer :: k
      call begin_row(row, 'dogleg of 100 deg/30 m and another', 'ends of each')
      do k = 1, 2
         extreme = case_of(tubing_well(100.0_wp), operations(k), mu, 'sharp, soft wall')
         extreme%wall = soft
         if (k == 1) call add_short(extreme, row, sixteenth)
         if (k == 2) call add_bent(extreme, row)
         extreme = case_of(tubing_well(100.0_wp), operations(k), mu, 'sharp, hard wall')
         extreme%wall = hard
         call add_bent(extreme, row)
         extreme = case_of(tubing_well(100.0_wp), operations(k), mu, 'sharp, short elements')
         extreme%element = short
         call add_bent(extreme, row)
         extreme = case_of(tubing_well(100.0_wp), operations(k), mu, 'sharp, long elements')
         extreme%element = long
         call add_bent(extreme, row)
         call add_short(case_of(with_clearance(tubing_well(100.0_wp), tight), operations(k), mu, 'sharp, tight hole'), row)
         call add_short(case_of(with_clearance(tubing_well(100.0_wp), wide), operations(k), mu, 'sharp, wide hole'), row)
         call add_short(case_of(tubing_well(100.0_wp), operations(k), 1.0_wp, 'sharp, friction 1'), row)
         well = tubing_well(100.0_wp)
         well%wob = -3.0e5_wp
         call add_bent(case_of(well, operations(k), mu, 'sharp, overpull'), row)
      end do
      call finish_row(row)
   end subroutine test_doglegs

   !> Where a string slopes by more than a tenth its moments are those of the long elements, and a message says so; with half a
   !> metre of room drill pipe slopes less.
   subroutine test_steep()
      character(*), parameter :: told = 'slopes by more than a tenth'
      type(answer_type) :: answer
      type(verdict_type) :: verdict
      call solve_extreme(case_of(with_clearance(tubing_well(100.0_wp), wide), operation_trip_out, mu, 'steep'), answer, verdict)
      call assertTrue(index(verdict%message, told) > 0, message='steep')
      call solve_extreme(case_of(with_clearance(base_well(), wide), operation_trip_out, mu, 'less steep'), answer, verdict)
      call assertTrue(index(verdict%message, told) == 0, message='less steep')
   end subroutine test_steep

   !> Loads, friction, length and room.
   subroutine test_loads()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(independent_well_type) :: well
      integer :: k
      call begin_row(row, 'two of load, friction, length, clearance', 'ends of each')
      do k = 1, 2
         well = base_well()
         well%wob = -1.0e6_wp
         call add_bent(case_of(well, operations(k), 1.0_wp, 'overpull, friction 1'), row)
         call add_short(case_of(with_clearance(well, tight), operations(k), mu, 'overpull, tight hole'), row)
         call add_short(case_of(with_clearance(well, wide), operations(k), mu, 'overpull, wide hole'), row)
         call add_short(case_of(with_clearance(base_well(), tight), operations(k), 1.0_wp, 'friction 1, tight hole'), row)
         call add_short(case_of(with_clearance(base_well(), wide), operations(k), 1.0_wp, 'friction 1, wide hole'), row)
         call add_straight(case_of(straight_well(15.0e3_wp, 80.0_wp), operations(k), 1.0_wp, '15 km, friction 1'), row)
         well = straight_well(5.0_wp, 80.0_wp)
         call add_straight(case_of(with_clearance(well, wide), operations(k), mu, '5 m, wide hole'), row)
         call add_straight(case_of(with_clearance(well, tight), operations(k), mu, '5 m, tight hole'), row)
      end do
      well = straight_well(5.0_wp, 80.0_wp)
      call add_bent(case_of(with_clearance(well, wide), operation_static, mu, '5 m held, wide hole'), row)
      well = horizontal_well()
      well%wob = 1.0e6_wp
      extreme = case_of(with_clearance(well, wide), operation_sliding_drilling, mu, 'hard push, wide hole')
      extreme%lock_up = .true.
      call add_short(extreme, row)
      extreme = case_of(well, operation_sliding_drilling, 1.0_wp, 'hard push, friction 1')
      extreme%lock_up = .true.
      call add_short(extreme, row)
      call finish_row(row)
   end subroutine test_loads

   !> Next to no weight, solid bars, and stiffness that jumps by a thousand at a joint.
   subroutine test_strings()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(independent_well_type) :: well
      type(answer_type) :: reference
      integer :: k
      call begin_row(row, 'strings', 'weightless, solid, stiffness times 1500')
      ! a rope over a bend of 90 deg: F exp(mu beta), contact F (exp(mu beta) - 1)/mu
      well = tubing_well(3.0_wp)
      well%md = [0.0_wp, 100.0_wp, 1000.0_wp, 1100.0_wp]
      well%inclination = [0.0_wp, 0.0_wp, 90.0_wp, 90.0_wp]
      well%bit = 1100.0_wp
      well%mud = 0.0_wp
      well%mass = 1.0e-6_wp
      well%wob = -1.0e5_wp
      extreme = case_of(well, operation_trip_out, mu, 'weightless over a bend')
      extreme%held = .false.
      reference%value(hookload) = -well%wob*exp(mu*0.5_wp*pi)
      reference%value(contact) = -well%wob*(exp(mu*0.5_wp*pi) - 1.0_wp)/mu
      call add_row(extreme, reference, row)
      well = straight_well(100.0_wp, 50.0_wp)
      well%mud = 0.0_wp
      well%mass = 1.0e-6_wp
      call add_straight(case_of(well, operation_trip_out, mu, 'weightless, no load'), row)
      do k = 1, 2
         well = base_well()
         well%id = 0.0_wp
         well%joint = 0.0_wp
         well%mass = 99.4_wp
         call add_bent(case_of(well, operations(k), mu, 'solid bar'), row)
         well = base_well()
         well%length = [100.0_wp, 0.0_wp]
         well%od = [0.2_wp, 0.0381_wp]
         well%id = [0.0_wp, 0.0318_wp]
         well%joint = [0.0_wp, 0.0_wp]
         well%mass = [245.0_wp, 2.5_wp]
         call add_bent(case_of(well, operations(k), mu, 'solid collars below thin tubing'), row)
         well%length = [400.0_wp, 0.0_wp]
         call add_bent(case_of(well, operations(k), mu, 'the same, joint in the build'), row)
      end do
      call finish_row(row)
   end subroutine test_strings

   !> Every number of a well that is no number, or infinite, is refused.
   subroutine test_bad_numbers()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      real(wp) :: bad
      integer :: i, k
      call begin_row(row, 'not a number, infinite', 'in each input')
      do k = 1, 2
         if (k == 1) bad = ieee_value(bad, ieee_quiet_nan)
         if (k == 2) bad = ieee_value(bad, ieee_positive_inf)
         do i = 1, 14
            extreme = case_of(base_well(), operation_trip_in, mu, merge('NaN     ', 'infinity', k == 1))
            extreme%refusal = .true.
            call set_value(i, bad, extreme)
            call add_row(extreme, answer_type(), row)
         end do
      end do
      call finish_row(row)
   contains
      subroutine set_value(place, value, changed)
         integer, intent(in) :: place
         real(wp), intent(in) :: value
         type(extreme_case_type), intent(inout) :: changed
         associate (well => changed%well)
            select case (place)
            case (1)
               well%md(3) = value
            case (2)
               well%inclination(3) = value
            case (3)
               well%azimuth(3) = value
            case (4)
               well%diameter = value
            case (5)
               well%bit = value
            case (6)
               well%wob = value
            case (7)
               well%tob = value
            case (8)
               well%along = value
            case (9)
               well%around = value
            case (10)
               well%youngs = value
            case (11)
               well%gravity = value
            case (12)
               well%od = value
            case (13)
               well%mass = value
            case default
               changed%wall = value
            end select
         end associate
      end subroutine set_value
   end subroutine test_bad_numbers
end module dg_test_extreme_pairs

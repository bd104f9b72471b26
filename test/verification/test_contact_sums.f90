!> Sums of contact, hook loads and torques of stabilized assemblies in holes that build and turn, and of blades down to 1 mm.
!> Expected values are those of an independent rod in three dimensions, with supports and a mesh of its own. It has the same law
!> of the wall, mostly 1e5 and 1e6 kN/m2, so that it does not judge the wall.
module dg_test_contact_sums
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_kinds, only: wp
   use dg_test_lone_contacts, only: solve_deck
   use dg_test_wells, only: note
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: contact_sums_suite

   !> Words of the message that contact forces differ.
   character(*), parameter :: said = 'Contact force uncertain by '
   !> Words of the message on contact at points of a rigid wall.
   character(*), parameter :: points = 'The string presses a rigid wall at single points, most at 597.9 m'
   !> The walls of the rod.
   character(*), parameter :: walls = '&solver gk_contact = 1.0e5, gk_max = 1.0e6 /'

contains

   function contact_sums_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('contact_sums')
      call suite%addTest(TestMethod('two_blades', test_two_blades))
      call suite%addTest(TestMethod('sharp_bend', test_sharp_bend))
      call suite%addTest(TestMethod('packed_rotating', test_packed_rotating))
      call suite%addTest(TestMethod('bent_motor', test_bent_motor))
      call suite%addTest(TestMethod('blades_of_5_mm', test_short_blades))
      call suite%addTest(TestMethod('tight_short_blades', test_tight_short_blades))
      call suite%addTest(TestMethod('blade_lengths', test_blade_lengths))
      call suite%addTest(TestMethod('default_wall', test_default_wall))
      call suite%addTest(TestMethod('bend_in_a_blade', test_bend_in_a_blade))
      call suite%addTest(TestMethod('totals_only', test_totals_only))
      call suite%addTest(TestMethod('jammed_motor', test_jammed_motor))
      call suite%addTest(TestMethod('two_analyses', test_two_analyses))
      call suite%addTest(TestMethod('coiled', test_coiled))
   end function contact_sums_suite

   !> Two blades of 1.8 m in a hole that turns by 4 deg/30 m, pulled. The contact sum was 0.7 % too small.
   subroutine test_two_blades()
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call two_blades(deck)
      call compare(deck, 321789.6_wp, 0.0_wp, 276950.1_wp)
   end subroutine test_two_blades

   !> A well with two blades of 1.8 m.
   subroutine two_blades(deck)
      type(text_type), allocatable, intent(inout) :: deck(:)
      call append_text(deck, '&trajectory md = 0, 80, 200, inc = 40, 46, 52, azi = 0, 12, 40 /')
      call append_text(deck, '&hole diameter = 311.1, friction = 0.25 /')
      call append_text(deck, '&fluid density = 1200 /')
      call append_text(deck, "&component kind = 'bit', length = 0.4, od = 230, id = 71.4, mass = 250 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 1.8, od = 203.2, id = 71.4, mass = 220, joint_od = 309.6 /")
      call append_text(deck, "&component kind = 'collar', length = 18, od = 203.2, id = 71.4, mass = 220 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 1.8, od = 203.2, id = 71.4, mass = 220, joint_od = 307.9 /")
      call append_text(deck, "&component kind = 'collar', od = 203.2, id = 71.4, mass = 220 /")
      call append_text(deck, "&load_case name = 'a', operation = 'trip_out', bit_depth = 200 /")
   end subroutine two_blades

   !> Two blades of 1 m in a hole that builds and turns by 16 deg/30 m.
   subroutine test_sharp_bend()
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call append_text(deck, '&trajectory md = 0, 40, 140, 200, inc = 60, 60, 90, 90, azi = 0, 0, 45, 75 /')
      call append_text(deck, '&hole diameter = 215.9, friction = 0.3 /')
      call append_text(deck, '&fluid density = 1200 /')
      call append_text(deck, "&component kind = 'bit', length = 0.3, od = 180, id = 71.4, mass = 170 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 1, od = 165.1, id = 71.4, mass = 136, joint_od = 212.7 /")
      call append_text(deck, '&component length = 5, od = 165.1, id = 71.4, mass = 136 /')
      call append_text(deck, "&component kind = 'stabilizer', length = 1, od = 165.1, id = 71.4, mass = 136, joint_od = 203.2 /")
      call append_text(deck, '&component od = 127, id = 76.2, mass = 73, joint_od = 168.3 /')
      call append_text(deck, "&load_case name = 'a', operation = 'trip_out', bit_depth = 190 /")
      call compare(deck, 82048.2_wp, 0.0_wp, 179074.7_wp)
   end subroutine test_sharp_bend

   !> A packed assembly of three blades turns on bottom in a bend of 7 deg/30 m.
   subroutine test_packed_rotating()
      type(text_type), allocatable :: deck(:)
      real(wp), parameter :: blades(3) = [214.3_wp, 212.7_wp, 211.1_wp], above(3) = [4.0_wp, 9.0_wp, 0.0_wp]
      allocate (deck(0))
      call start_packed(deck)
      call add_blades(deck, 1.5_wp, blades, above)
      call add_upper_part(deck)
      call append_text(deck, "&load_case name = 'a', operation = 'rotary_drilling', bit_depth = 290, wob = 80, tob = 4 /")
      call compare(deck, 56506.8_wp, 8803.0_wp, 212076.7_wp)
   end subroutine test_packed_rotating

   !> A motor with a bent housing slides. The contact sum was 0.3 % too large on elements of a metre.
   subroutine test_bent_motor()
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call append_text(deck, '&trajectory md = 0, 80, 200, inc = 40, 46, 52, azi = 0, 12, 40 /')
      call append_text(deck, '&hole diameter = 215.9, friction = 0.25 /')
      call append_motor(deck)
      call append_text(deck, "&load_case name = 'a', operation = 'sliding_drilling', bit_depth = 200, wob = 60, toolface = 60 /")
      call compare(deck, -205.4_wp, 0.0_wp, 146322.2_wp)
   end subroutine test_bent_motor

   !> Mud, and a motor with a bend of 1.5 deg in the middle of its lower blade, of 0.4 m, below heavy-weight pipe.
   subroutine append_motor(deck)
      type(text_type), allocatable, intent(inout) :: deck(:)
      call append_text(deck, '&fluid density = 1200 /')
      call append_text(deck, "&component kind = 'bit', length = 0.1, od = 180, id = 50.8, mass = 150, joint_od = 215.9 /")
      call append_text(deck, "&component kind = 'motor', length = 1.6, od = 171.4, id = 80, mass = 140 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 0.4, od = 171.4, id = 80, mass = 140, joint_od = 212.7, "// &
                       'bend = 1.5, bend_position = 0.2 /')
      call append_text(deck, "&component kind = 'motor', length = 7, od = 171.4, id = 100, mass = 120 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 0.4, od = 165.1, id = 71.4, mass = 136, joint_od = 209.6 /")
      call append_text(deck, "&component kind = 'collar', length = 30, od = 165.1, id = 71.4, mass = 136 /")
      call append_text(deck, '&component od = 127, id = 76.2, mass = 73, joint_od = 168.3 /')
   end subroutine append_motor

   !> Blades of 5 mm with clearances of 0.8 and 2 mm on a side, pulled. They were lost where depths are merged.
   subroutine test_short_blades()
      type(text_type), allocatable :: deck(:)
      real(wp), parameter :: blades(2) = [214.3_wp, 211.9_wp], above(2) = [4.0_wp, 9.0_wp]
      allocate (deck(0))
      call start_packed(deck)
      call add_blades(deck, 0.005_wp, blades, above)
      call add_upper_part(deck)
      call append_text(deck, "&load_case name = 'a', operation = 'trip_out', bit_depth = 290 /")
      call compare(deck, 168412.6_wp, 0.0_wp, 133958.8_wp)
   end subroutine test_short_blades

   !> Blades of 20 mm next to the bit with 0.4 and 1 mm of clearance, and one of 100 mm above, pulled along a stiffer wall (1e7
   !> kN/m2 throughout). What is expected is of the rod of `.ci/rod.py`. The contact sum was 0.22 % too small: each short blade had
   !> one contact point, and the bit's support gave way by 9 micrometres.
   subroutine test_tight_short_blades()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      real(wp), parameter :: hookload = 185386.1_wp, contact = 206785.1_wp, side_force = 87271.2_wp, moment = 47385.4_wp
      allocate (deck(0))
      call start_packed(deck)
      call add_blades(deck, 0.02_wp, [215.1_wp], [3.0_wp])
      call add_blades(deck, 0.02_wp, [213.9_wp], [6.0_wp])
      call add_blades(deck, 0.1_wp, [211.9_wp], [0.0_wp])
      call add_upper_part(deck)
      call append_text(deck, "&load_case name = 'a', operation = 'trip_out', bit_depth = 290 /")
      call append_text(deck, '&solver gk_contact = 1.0e7, gk_max = 1.0e7 /')
      call solve_deck(deck, 0.0_wp, .false., result)
      call note('sum of contact over that of the rod, less one', result%normal_force/contact - 1.0_wp)
      call note('hook load over that of the rod, less one', result%hookload/hookload - 1.0_wp)
      call note('side force over that of the rod, less one', result%bit_side_force/side_force - 1.0_wp)
      call assertRelativelyEqual(contact, result%normal_force, 1.0e-3_wp, message='sum of contact')
      call assertRelativelyEqual(hookload, result%hookload, 3.0e-4_wp, message='hook load')
      call assertRelativelyEqual(side_force, result%bit_side_force, 3.0e-3_wp, message='side force of the bit')
      call assertRelativelyEqual(moment, maxval(result%profile%bending), 6.0e-3_wp, message='largest moment')
   end subroutine test_tight_short_blades

   !> A blade of 1.6 mm of clearance holds collars of a horizontal string that is pushed, however short it is: moment and bit force
   !> change smoothly down to a blade of 1 mm. At 0.02 m the string once lay 25 mm off the axis there.
   subroutine test_blade_lengths()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      real(wp), parameter :: lengths(5) = [0.1_wp, 0.02_wp, 0.01_wp, 0.005_wp, 0.001_wp]
      character(40) :: text
      integer :: i, k
      do i = 1, size(lengths)
         if (allocated(deck)) deallocate (deck)
         allocate (deck(0))
         call append_text(deck, '&trajectory md = 0, 40, inc = 90, 90, azi = 0, 0 /')
         call append_text(deck, '&hole diameter = 215.9 /')
         call append_text(deck, '&fluid density = 1200 /')
         call append_text(deck, "&component kind = 'bit', length = 0.3, od = 200, id = 50 /")
         call append_text(deck, "&component kind = 'collar', length = 8.7, od = 165.1, id = 71.4 /")
         write (text, '(a, f5.3)') 'length = ', lengths(i)
         call append_text(deck, "&component kind = 'stabilizer', od = 165.1, id = 71.4, joint_od = 212.7, "//trim(text)//' /')
         call append_text(deck, "&component kind = 'collar', od = 165.1, id = 71.4 /")
         call append_text(deck, "&load_case name = 's', operation = 'static', bit_depth = 40, wob = 50 /")
         call append_text(deck, '&solver gk_contact = 1.0e8, gk_max = 1.0e8 /')
         call solve_deck(deck, 0.0_wp, .false., result)
         k = minloc(abs(result%profile%md - 31.0_wp + 0.5_wp*lengths(i)), dim=1)
         call note('offset at the blade [m]', result%profile%displacement(k))
         call assertLessThan(result%profile%displacement(k), 2.0e-3_wp, message='at the blade, '//trim(text))
         call assertRelativelyEqual(15100.0_wp, maxval(result%profile%bending), 0.01_wp, message='moment, '//trim(text))
      end do
   end subroutine test_blade_lengths

   !> The default wall is as good as rigid: with ten times its stiffness a packed assembly has the same hook load, torque, contact
   !> and largest moment within 0.3 %. A wall of 1e4 kN/m2 has not. The side force of the bit, 53 kN on a lever of 0.3 m to the
   !> nearest blade, changes with micrometres of yielding: the short elements take the default wall as rigid.
   subroutine test_default_wall()
      real(wp), parameter :: within = 3.0e-3_wp, bit_within = 1.0e-3_wp
      type(case_result_type) :: result, stiffer, softer
      call solve_packed('', result)
      call solve_packed('&solver gk_contact = 1.0e9 /', stiffer)
      call solve_packed('&solver gk_contact = 1.0e4 /', softer)
      call assertRelativelyEqual(stiffer%hookload, result%hookload, within, message='hook load')
      call assertRelativelyEqual(stiffer%torque, result%torque, within, message='torque')
      call assertRelativelyEqual(stiffer%normal_force, result%normal_force, within, message='sum of contact')
      call assertRelativelyEqual(maxval(stiffer%profile%bending), maxval(result%profile%bending), within, message='moment')
      call assertRelativelyEqual(stiffer%bit_side_force, result%bit_side_force, bit_within, message='side force of the bit')
      call note('a soft wall: side force over that at the default wall', softer%bit_side_force/result%bit_side_force)
      call assertGreaterThan(abs(softer%bit_side_force/result%bit_side_force - 1.0_wp), 0.05_wp, message='a soft wall')
   end subroutine test_default_wall

   !> A motor with a bend of 1.5 deg in the middle of a blade of 0.4 m, which presses both ends of the blade and its middle against
   !> the wall. In a wall of sandstone (1e7 kN/m2) the rod has these figures. Once the short elements' wall yielded there, and
   !> the next stiffness jumped to a rigid one: contact was 11 % too large. With the default wall both analyses agree, and halved
   !> elements change nothing: once contact was 12 % too small.
   subroutine test_bend_in_a_blade()
      real(wp), parameter :: contact = 326443.0_wp, hookload = 152314.0_wp, moment = 77202.0_wp, side = 39836.0_wp
      real(wp), parameter :: within = 5.0e-3_wp
      type(case_result_type) :: result, halved
      call solve_bent_blade('&solver gk_contact = 1.0e7, gk_max = 1.0e8 /', result)
      call note('contact over that of the rod, less one', result%normal_force/contact - 1.0_wp)
      call assertRelativelyEqual(hookload, result%hookload, 1.0e-3_wp, message='hook load')
      call assertRelativelyEqual(contact, result%normal_force, 1.5e-3_wp, message='contact')
      call assertRelativelyEqual(moment, maxval(result%profile%bending), 1.0e-3_wp, message='largest moment')
      call assertRelativelyEqual(side, result%bit_side_force, 1.0e-3_wp, message='side force')
      call solve_bent_blade('', result)
      call assertGreaterThan(index(result%message, points), 0, message='a rigid wall')
      call assertGreaterThan(index(result%message, 'Set wall_stiffness of the hole, 1e7 kN/m2'), 0, message='advice')
      call solve_bent_blade('', halved, ', wall_stiffness = 1.0e7')
      call assertEqual(0, index(halved%message, points), message='as advised')
      call assertLessThan(halved%normal_force, (1.0_wp - result%unlike_contact%yielding)*result%normal_force, message='smaller')
      call assertRelativelyEqual(result%unlike_contact%by_beam, result%normal_force, within, message='both analyses')
      call solve_bent_blade("&solver fidelity = 'reference' /", halved)
      call assertRelativelyEqual(halved%unlike_contact%by_beam, result%unlike_contact%by_beam, within, message='halved')
      call assertRelativelyEqual(halved%normal_force, result%normal_force, within, message='halved: contact')
   end subroutine test_bend_in_a_blade

   !> A point of a sweep has the totals of its load case. It had the contact of long elements: 12 % less.
   subroutine test_totals_only()
      type(case_result_type) :: result, point
      call solve_bent_blade('', result)
      call solve_bent_blade('', point, totals_only=.true.)
      call assertRelativelyEqual(result%hookload, point%hookload, 1.0e-9_wp, message='hook load')
      call assertRelativelyEqual(result%normal_force, point%normal_force, 1.0e-9_wp, message='contact')
   end subroutine test_totals_only

   !> A motor that slides, its bend within the blade, with a line for the solver, and keys of its hole.
   subroutine solve_bent_blade(solver, result, hole, totals_only)
      character(*), intent(in) :: solver
      type(case_result_type), intent(out) :: result
      character(*), intent(in), optional :: hole
      logical, intent(in), optional :: totals_only
      character(:), allocatable :: keys
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      keys = ''
      if (present(hole)) keys = hole
      call append_text(deck, '&trajectory md = 0, 600, inc = 40, 40, azi = 30, 30 /')
      call append_text(deck, '&hole diameter = 215.9, friction = 0.25'//keys//' /')
      call append_motor(deck)
      call append_text(deck, "&load_case name = 'a', operation = 'sliding', bit_depth = 600, wob = 60, toolface = 0 /")
      if (solver /= '') call append_text(deck, solver)
      call solve_deck(deck, 0.0_wp, .false., result, totals_only=totals_only)
   end subroutine solve_bent_blade

   !> A motor with a bend of 1.5 deg that touches along its 9 m, with 1.6 mm of room. It jams, and nothing brings it down. Helical
   !> buckling was given as the reason. With blades alone that touch, as the message advises, it slides.
   subroutine test_jammed_motor()
      type(case_result_type) :: result
      call solve_motor(', joint_od = 308', result_locked_up, result)
      call assertGreaterThan(index(result%message, 'Locked up: the stiff assembly holds the string'), 0, message=result%message)
      call solve_motor('', result_converged, result)
   end subroutine test_jammed_motor

   !> A motor that slides below two blades, with keys of its housing, to an expected status.
   subroutine solve_motor(keys, status, result)
      character(*), intent(in) :: keys
      integer, intent(in) :: status        !< expected
      type(case_result_type), intent(out) :: result
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call append_text(deck, '&trajectory md = 0, 610, 1220, 2743, inc = 0, 0, 45, 45, azi = 4*10 /')
      call append_text(deck, '&hole diameter = 311.15, friction = 0.25 /')
      call append_text(deck, '&fluid density = 1200 /')
      call append_text(deck, "&component kind = 'bit', length = 0.37, od = 230, joint_od = 311.15 /")
      call append_text(deck, "&component kind = 'motor', length = 9.1, od = 244.5, id = 101.6, bend = 1.5, bend_position = 1.8"// &
                       keys//' /')
      call append_text(deck, "&component kind = 'stabilizer', length = 1.8, od = 230, id = 76.2, joint_od = 308 /")
      call append_text(deck, "&component kind = 'mwd', length = 9.1, od = 203.2, id = 76.2 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 1.8, od = 230, id = 76.2, joint_od = 308 /")
      call append_text(deck, "&component kind = 'collar', length = 55, od = 203.2, id = 71.4 /")
      call append_text(deck, '&component od = 127, id = 76.2, mass = 73.4, joint_od = 165.1, length = 180 /')
      call append_text(deck, '&component od = 127, id = 108.6, mass = 31.9, joint_od = 168.3 /')
      call append_text(deck, "&load_case name = 'a', operation = 'sliding', bit_depth = 2743, wob = 89, toolface = 0 /")
      call solve_deck(deck, 0.0_wp, .false., result, status)
   end subroutine solve_motor

   !> The contact force on the elements of hook load and torque is that on the elements of moments, in sum and part by part. So
   !> it is
   !> where a blade stands 0.3 m above the bit. On a blade of 2 mm the wall of the long elements yields by a third of the clearance,
   !> that of the short ones does not, and the result says so.
   subroutine test_two_analyses()
      real(wp), parameter :: within = 3.0e-3_wp
      type(case_result_type) :: result
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call two_blades(deck)
      call solve_deck(deck, 0.0_wp, .false., result)
      associate (found => result%unlike_contact)
         call note('contact on short elements over that on long ones, less one', found%by_beam/found%by_analysis - 1.0_wp)
         call note('largest difference of a part over the whole', found%share)
         call assertRelativelyEqual(result%normal_force, found%by_analysis, 1.0e-6_wp, message='of the analysis')
         call assertRelativelyEqual(found%by_analysis, found%by_beam, within, message='sum')
         call assertLessThan(found%share, within, message='part by part')
      end associate
      call assertEqual(0, index(result%message, said), message='nothing is said')
      call solve_packed('', result)
      call assertEqual(0, index(result%message, said), message='a blade 0.3 m above the bit')
      deallocate (deck)
      allocate (deck(0))
      call append_text(deck, '&trajectory md = 0, 10, inc = 90, 90, azi = 0, 0 /')
      call append_text(deck, '&hole diameter = 215.9 /')
      call append_text(deck, "&component kind = 'collar', length = 0.999, od = 171.45, id = 71.4, mass = 152.9 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 0.002, od = 171.45, id = 71.4, mass = 152.9, "// &
                       'joint_od = 215.2 /')
      call append_text(deck, "&component kind = 'collar', od = 171.45, id = 71.4, mass = 152.9 /")
      call append_text(deck, "&load_case name = 'a', operation = 'static', bit_depth = 10 /")
      call solve_deck(deck, 0.0_wp, .false., result)
      call note('a blade of 2 mm: largest difference of a part over the whole', result%unlike_contact%share)
      call assertLessThan(result%unlike_contact%share, within, message='a blade of 2 mm')
      call assertEqual(0, index(result%message, said), message='nothing is said of a blade of 2 mm')
   end subroutine test_two_analyses

   !> A helically buckled string whose contact differs between both analyses by 30 %. On shorter elements both agree, and hook load
   !> and contact are those of the long ones: the result blames moments and side forces, not the drag.
   subroutine test_coiled()
      character(*), parameter :: blamed = '. Side forces and moments there may be off by '
      type(case_result_type) :: result, finer
      call solve_horizontal('', result)
      call assertGreaterThan(index(result%message, said), 0, message='on the usual elements')
      call assertGreaterThan(index(result%message, blamed), 0, message='what may be off')
      call solve_horizontal('&solver element_length = 10 /', finer)
      call assertEqual(0, index(finer%message, said), message='on shorter elements')
      call note('hook load on shorter elements over that on the usual ones, less one', finer%hookload/result%hookload - 1.0_wp)
      call assertRelativelyEqual(result%hookload, finer%hookload, 1.0e-3_wp, message='hook load')
      call assertRelativelyEqual(result%normal_force, finer%normal_force, 1.0e-3_wp, message='contact')
   end subroutine test_coiled

   !> A string that slides in a horizontal hole of 2 km, with a line of its own for the solver.
   subroutine solve_horizontal(solver, result)
      character(*), intent(in) :: solver
      type(case_result_type), intent(out) :: result
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call append_text(deck, '&trajectory md = 0, 1500, 2100, 4200, inc = 0, 0, 90, 90, azi = 20, 20, 20, 20 /')
      call append_text(deck, "&hole name = 'casing', diameter = 222, friction = 0.2, cased = .true., md_bottom = 1600 /")
      call append_text(deck, "&hole name = 'open', diameter = 215.9, friction = 0.3 /")
      call append_text(deck, '&fluid density = 1250 /')
      call append_text(deck, "&component kind = 'bit', length = 0.3, od = 150, joint_od = 215.9 /")
      call append_text(deck, "&component kind = 'collar', length = 60, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component kind = 'hwdp', length = 150, od = 127, id = 76.2, mass = 73.4, joint_od = 165.1 /")
      call append_text(deck, '&component od = 127, id = 108.6, mass = 31.9, joint_od = 161.9 /')
      call append_text(deck, "&load_case name = 'a', operation = 'slide', bit_depth = 4000, wob = 40, tob = 3 /")
      if (solver /= '') call append_text(deck, solver)
      call solve_deck(deck, 0.0_wp, .false., result)
   end subroutine solve_horizontal

   !> A packed assembly that turns, with a line of its own for the solver.
   subroutine solve_packed(solver, result)
      character(*), intent(in) :: solver
      type(case_result_type), intent(out) :: result
      real(wp), parameter :: blades(2) = [214.3_wp, 211.9_wp], above(2) = [4.0_wp, 9.0_wp]
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call start_packed(deck)
      call add_blades(deck, 0.5_wp, blades, above)
      call add_upper_part(deck)
      call append_text(deck, "&load_case name = 'a', operation = 'backream', bit_depth = 290, rpm = 60, trip_speed = 0.1 /")
      if (solver /= '') call append_text(deck, solver)
      call solve_deck(deck, 0.0_wp, .false., result)
   end subroutine solve_packed

   !> Hole and fluid of the packed assemblies, and their bit.
   subroutine start_packed(deck)
      type(text_type), allocatable, intent(inout) :: deck(:)
      call append_text(deck, '&trajectory md = 0, 60, 180, 300, inc = 30, 30, 52, 74, azi = 0, 0, 20, 52 /')
      call append_text(deck, '&hole diameter = 215.9, friction = 0.25 /')
      call append_text(deck, '&fluid density = 1200 /')
      call append_text(deck, "&component kind = 'bit', length = 0.3, od = 180, id = 71.4, mass = 170 /")
   end subroutine start_packed

   !> Collars and heavy-weight pipe above the blades.
   subroutine add_upper_part(deck)
      type(text_type), allocatable, intent(inout) :: deck(:)
      call append_text(deck, '&component length = 60, od = 165.1, id = 71.4, mass = 136 /')
      call append_text(deck, '&component od = 127, id = 76.2, mass = 73, joint_od = 168.3 /')
   end subroutine add_upper_part

   !> Blades of a length [m] and of diameters [mm], with collars of other lengths [m] above them; 0: none.
   subroutine add_blades(deck, length, diameters, above)
      type(text_type), allocatable, intent(inout) :: deck(:)
      real(wp), intent(in) :: length, diameters(:), above(:)
      character(60) :: text
      integer :: i
      do i = 1, size(diameters)
         write (text, '(a, f5.3, a, f5.1)') 'length = ', length, ', joint_od = ', diameters(i)
         call append_text(deck, "&component kind = 'stabilizer', od = 171.4, id = 71.4, mass = 160, "//trim(text)//' /')
         if (.not. above(i) > 0.0_wp) cycle
         write (text, '(a, f4.1)') 'length = ', above(i)
         call append_text(deck, '&component od = 171.4, id = 71.4, mass = 150, '//trim(text)//' /')
      end do
   end subroutine add_blades

   !> Hook load, torque and sum of contact of a deck beside those of the rod [N, N.m, N].
   subroutine compare(deck, hookload, torque, contact)
      type(text_type), allocatable, intent(inout) :: deck(:)
      real(wp), intent(in) :: hookload, torque, contact
      type(case_result_type) :: result
      call append_text(deck, walls)
      call solve_deck(deck, 0.0_wp, .false., result)
      call note('sum of contact over that of the rod, less one', result%normal_force/contact - 1.0_wp)
      call assertRelativelyEqual(contact, result%normal_force, 1.5e-3_wp, message='sum of contact')
      call note('hook load less that of the rod [N]', result%hookload - hookload)
      call assertLessThan(abs(result%hookload - hookload), 1.5e-3_wp*0.3_wp*contact + 1.0_wp, message='hook load')
      if (.not. torque > 0.0_wp) return
      call assertRelativelyEqual(torque, result%torque, 1.5e-3_wp, message='torque')
   end subroutine compare
end module dg_test_contact_sums

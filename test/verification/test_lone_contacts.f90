!> Contacts that stand alone, stiff walls and bits with little room: where the string touches and how it bends there. The wells were
!> made by independent reviewers; what is expected is statics, or what the same program finds on elements of a quarter of a metre to
!> two metres.
module dg_test_lone_contacts
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use dg_case_result, only: case_result_type, contact_blades, result_converged
   use dg_constants, only: pi
   use dg_error, only: error_list_type, error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_read_deck, only: read_deck
   use dg_static_analysis, only: solve_static_analysis
   use dg_study_comparison, only: compare_lines
   use dg_test_wells, only: note
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: lone_contacts_suite, solve_deck

   character(*), parameter :: path = 'build/test_lone_contacts.nml'

contains

   function lone_contacts_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('lone_contacts')
      call suite%addTest(TestMethod('place', test_place))
      call suite%addTest(TestMethod('moment', test_moment))
      call suite%addTest(TestMethod('other_equilibrium', test_other_equilibrium))
      call suite%addTest(TestMethod('torque_at_blades', test_torque_at_blades))
      call suite%addTest(TestMethod('stiff_wall', test_stiff_wall))
      call suite%addTest(TestMethod('tight_bit', test_tight_bit))
      call suite%addTest(TestMethod('tilted_blade', test_tilted_blade))
      call suite%addTest(TestMethod('joints_one_by_one', test_joints_one_by_one))
      call suite%addTest(TestMethod('short_joints', test_short_joints))
      call suite%addTest(TestMethod('pulled_joints', test_pulled_joints))
      call suite%addTest(TestMethod('eccentric_blade', test_eccentric_blade))
      call suite%addTest(TestMethod('two_edges', test_two_edges))
   end function lone_contacts_suite

   !> A short assembly turns through enlarged parts of a bend of 16 deg/30 m. Once a contact of 3 kN stood at one end of its element
   !> while the string was deepest, by 4 mm, at the other: torque and contact were 5 % too large.
   subroutine test_place()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result, fine
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0.0, 114.8875, 229.775, 344.6625, 459.55, inc = 3.57, 26.5475, 49.525, "// &
                       "38.03625, 95.48, azi = 5*165.67 /")
      call add_holes(deck, [406.95_wp, 415.95_wp, 433.95_wp, 434.55_wp, 443.55_wp, 445.55_wp, 450.55_wp, 459.55_wp], &
                     [215.9_wp, 241.3_wp, 228.6_wp, 215.9_wp, 228.6_wp, 275.9_wp, 228.6_wp, 215.9_wp])
      call append_text(deck, "&fluid density = 1800.0 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', length = 0.25, od = 190.0, id = 60.0, joint_od = 215.9 /")
      call append_text(deck, "&component name = 'st', kind = 'stabilizer', length = 0.5, od = 165.1, id = 71.4, "// &
                       "joint_od = 214.3, joint_length = 0.5 /")
      call append_text(deck, "&component name = 'dc', length = 2.0, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component name = 'hw', length = 22.9775, od = 127.0, id = 76.2, mass = 73.4, "// &
                       "joint_od = 165.1, joint_length = 1.0 /")
      call append_text(deck, "&component name = 'dp', od = 127.0, id = 108.6, mass = 31.9, joint_od = 168.3 /")
      call append_text(deck, "&boundary bit_lateral = 'free' /")
      call append_text(deck, "&load_case name = 'c', operation = 'rotate_off_bottom', bit_depth = 459.55 /")
      call solve_both(deck, 2.0_wp, result, fine)
      call note('torque over that on elements of 2 m, less one', result%torque/fine%torque - 1.0_wp)
      call assertRelativelyEqual(fine%torque, result%torque, 5.0e-3_wp, message='torque')
      call compare_contact(result, fine, 5.0e-3_wp)
   end subroutine test_place

   !> Pipe in a near-vertical hole with a kick of 5 deg within 8 m. Its largest moment is at a contact in the middle of an element
   !> of 2.1 m. Once no row was there, and the moment was told 23 % too small.
   subroutine test_moment()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result, fine
      real(wp) :: largest
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0.0, 51.05, 55.27, 59.49, 169.86, inc = 0.0, 0.0, 5.0, 0.0, 0.0, "// &
                       "azi = 5*248.67 /")
      call append_text(deck, "&hole diameter = 311.1, friction = 0.4 /")
      call append_text(deck, "&fluid density = 1050.0 /")
      call append_text(deck, "&component name = 'dc', length = 29.36, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component name = 'dp', od = 127.0, id = 108.6, mass = 31.9, joint_od = 168.3 /")
      call append_text(deck, "&boundary bit_lateral = 'free' /")
      call append_text(deck, "&load_case name = 'c', operation = 'rotary_drilling', bit_depth = 169.86, wob = 9.51, "// &
                       "tob = 0.06 /")
      call solve_deck(deck, 0.0_wp, .false., result)
      call solve_deck(deck, 0.25_wp, .true., fine)
      largest = maxval(fine%profile%bending)
      call note('largest moment over that on elements of 0.25 m, less one', maxval(result%profile%bending)/largest - 1.0_wp)
      call assertRelativelyEqual(largest, maxval(result%profile%bending), 0.03_wp, message='largest moment')
   end subroutine test_moment

   !> Collars in a vertical hole, pushed a little beyond buckling. Elements that are halved until moments stand may lead to the
   !> straight string, which is in equilibrium, too: no moments at all, and "proven". The string that was found is bent.
   subroutine test_other_equilibrium()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0.0, 95.54, 191.08, 286.62, inc = 4*0.0, azi = 143.15, 143.15, 173.15, 143.15 /")
      call append_text(deck, "&hole diameter = 215.9, friction = 0.5 /")
      call append_text(deck, "&fluid density = 1500.0 /")
      call append_text(deck, "&component name = 'dc', length = 26.38, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component name = 'dp', od = 127.0, id = 108.6, mass = 31.9, joint_od = 168.3 /")
      call append_text(deck, "&load_case name = 'c', operation = 'sliding_drilling', bit_depth = 286.62, wob = 22.49 /")
      call append_text(deck, "&solver load_steps = 2 /")
      call solve_deck(deck, 0.0_wp, .true., result)
      call note('largest moment [N.m]', maxval(result%profile%bending))
      call assertGreaterThan(maxval(result%profile%bending), 50.0_wp, message='bent')
      if (.not. is_missing(result%moment_error)) &
         call assertGreaterThan(maxval(result%profile%displacement), 0.01_wp, message='proven: of the string that was found')
   end subroutine test_other_equilibrium

   !> An assembly on three blades turns in a straight hole. At each blade the torque falls by coefficient, radius and force, over
   !> the metre below and above it; at the top it is that of the summary, at the bit none. Once a row had the mean torque of the
   !> elements beside it: a tenth of the whole off at a blade, and at the top another than the summary.
   subroutine test_torque_at_blades()
      real(wp), parameter :: friction = 0.3_wp, blade = 0.5_wp*0.2143_wp
      real(wp), parameter :: within = 0.02_wp       ! blades and collars beside them, which touch nothing there
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      real(wp) :: fall
      integer :: i, blades
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0.0, 400.0, inc = 2*70.0, azi = 2*30.0 /")
      call append_text(deck, "&hole diameter = 215.9, friction = 0.3 /")
      call append_text(deck, "&fluid density = 1200.0 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', length = 0.25, od = 165.1, id = 60.0 /")
      do i = 1, 3
         call append_text(deck, "&component name = 'collar', kind = 'collar', length = 9.0, od = 165.1, id = 71.4 /")
         call append_text(deck, "&component name = 'blades', kind = 'stabilizer', length = 1.0, od = 165.1, id = 71.4, "// &
                          "joint_od = 214.3 /")
      end do
      call append_text(deck, "&component name = 'collar', kind = 'collar', length = 18.0, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component name = 'pipe', od = 127.0, id = 108.6, mass = 31.9, joint_od = 168.3 /")
      call append_text(deck, "&boundary bit_lateral = 'free' /")
      call append_text(deck, "&load_case name = 'c', operation = 'rotate_off_bottom', bit_depth = 400.0 /")
      call solve_deck(deck, 0.0_wp, .false., result)
      blades = 0
      associate (p => result%profile, contacts => result%contacts)
         call assertRelativelyEqual(result%torque, p%torque(1), 1.0e-9_wp, message='top')
         call assertLessThan(abs(p%torque(size(p%md))), 1.0e-6_wp*result%torque, message='bit')
         do i = 1, size(contacts)
            if (contacts(i)%kind /= contact_blades) cycle
            blades = blades + 1
            fall = torque_at(contacts(i)%md - 1.0_wp) - torque_at(contacts(i)%md + 1.0_wp)
            call note('torque lost at blades, over coefficient times radius times force, less one', &
                      fall/(friction*blade*contacts(i)%force) - 1.0_wp)
            call assertRelativelyEqual(friction*blade*contacts(i)%force, fall, within, message='at blades')
         end do
      end associate
      call assertEqual(3, blades, message='blades that touch')

   contains

      !> By a straight line between rows.
      pure function torque_at(md) result(torque)
         real(wp), intent(in) :: md
         real(wp) :: torque
         integer :: n
         associate (p => result%profile)
            n = max(1, min(size(p%md) - 1, count(p%md <= md)))
            torque = p%torque(n) + (p%torque(n + 1) - p%torque(n))*(md - p%md(n))/(p%md(n + 1) - p%md(n))
         end associate
      end function torque_at
   end subroutine test_torque_at_blades

   !> Coiled tubing pulled along a wall of 1e7 kN/m2. Once no equilibrium was found on short elements: moments were 83 % of the
   !> largest off, with a message.
   subroutine test_stiff_wall()
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0, 309.69217, 837.59659, 1281.13791, inc = 0, 0, 70.38726, 70.38726, "// &
                       "azi = 4*104.13631 /")
      call append_text(deck, "&hole diameter = 159.0, friction = 0.2, wall_stiffness = 1.0e7 /")
      call append_text(deck, "&fluid density = 1000 /")
      call append_text(deck, "&component name = 'tool', kind = 'motor', od = 60.96, id = 25.0, length = 4.0, mass = 12.0 /")
      call append_text(deck, "&component name = 'coiled tubing', od = 50.8, id = 42.9 /")
      call append_text(deck, "&boundary top_lateral = 'free', bit_lateral = 'free' /")
      call append_text(deck, "&load_case name = 'c', operation = 'trip_out', bit_depth = 1281.13791 /")
      call compare_moments(deck, 1.0_wp)
   end subroutine test_stiff_wall

   !> A packed assembly whose free bit has a quarter of a millimetre of room. On short elements it lies on the other side of that
   !> room. Once this half millimetre was taken for another equilibrium: moments were 32 % of the largest off, with a message.
   subroutine test_tight_bit()
      type(text_type), allocatable :: deck(:)
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0, 300, inc = 87, 87, azi = 0, 0 /")
      call append_text(deck, "&hole diameter = 311.2, friction = 0.0 /")
      call append_text(deck, "&fluid density = 1000 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', od = 193, id = 50, length = 0.35, "// &
                       "joint_od = 311.2, mass = 223 /")
      call append_text(deck, "&component name = 'st1', kind = 'stabilizer', od = 203.2, id = 71.4, mass = 234, length = 0.4, "// &
                       "joint_od = 308 /")
      call append_text(deck, "&component name = 'dc1', kind = 'collar', od = 203.2, id = 71.4, mass = 223, length = 1.5 /")
      call append_text(deck, "&component name = 'st2', kind = 'stabilizer', od = 203.2, id = 71.4, mass = 234, length = 1.0, "// &
                       "joint_od = 309.6 /")
      call append_text(deck, "&component name = 'dc2', kind = 'collar', od = 203.2, id = 71.4, mass = 223, length = 9 /")
      call append_text(deck, "&component name = 'st3', kind = 'stabilizer', od = 203.2, id = 71.4, mass = 234, length = 1.0, "// &
                       "joint_od = 286.2 /")
      call append_text(deck, "&component name = 'dc3', kind = 'collar', od = 203.2, id = 71.4, mass = 223, length = 60 /")
      call append_text(deck, "&component name = 'dp', od = 149.2, id = 130.8, mass = 37.5, joint_od = 177.8 /")
      call append_text(deck, "&boundary bit_lateral = 'free' /")
      call append_text(deck, "&load_case name = 'c', operation = 'trip_in', bit_depth = 300 /")
      call compare_moments(deck, 0.5_wp)
   end subroutine test_tight_bit

   !> A motor with a bend of 2 deg within a blade, whose edge presses two tenths of a millimetre into the wall. Once the wall of the
   !> whole element stood against that edge: sum of contact 26 % too large.
   subroutine test_tilted_blade()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result, fine
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0, 100, inc = 2.5, 2.5, azi = 0, 0 /")
      call append_text(deck, "&hole diameter = 155.6, friction = 0.3, wall_stiffness = 1.0e6 /")
      call append_text(deck, "&fluid density = 0 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', od = 114.665, id = 50, length = 0.25, joint_od = 155.6, "// &
                       "mass = 69 /")
      call append_text(deck, "&component name = 'housing', kind = 'motor', od = 124.3, id = 50, length = 1.6 /")
      call append_text(deck, "&component name = 'st1', kind = 'stabilizer', od = 120.7, id = 57.2, mass = 72.45, length = 0.4, "// &
                       "joint_od = 152.4, bend = 2.0, bend_position = 0.2 /")
      call append_text(deck, "&component name = 'motor', kind = 'motor', od = 124.3, id = 50, length = 7 /")
      call append_text(deck, "&component name = 'st2', kind = 'stabilizer', od = 120.7, id = 57.2, mass = 72.45, length = 0.4, "// &
                       "joint_od = 152.4 /")
      call append_text(deck, "&component name = 'mwd', kind = 'mwd', od = 120.7, id = 57.2, mass = 58.65, length = 10 /")
      call append_text(deck, "&component name = 'dp', od = 101.6, id = 84.8, mass = 22.5, joint_od = 133.4 /")
      call append_text(deck, "&boundary bit_lateral = 'free' /")
      call append_text(deck, "&load_case name = 'c', operation = 'trip_in', bit_depth = 100 /")
      call solve_both(deck, 0.02_wp, result, fine)
      call compare_contact(result, fine, 0.02_wp)
   end subroutine test_tilted_blade

   !> Pipe pulled with 250 kN in a bend of 10 deg/30 m bends more than its wall, so that long joints touch with both edges. Largest
   !> moments of an independent rod with elements of millimetres. Once a joint pressed at one point, and they were 6 and 10 % too
   !> large.
   subroutine test_pulled_joints()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      character(3), parameter :: lengths(2) = ['0.5', '1.0']
      real(wp), parameter :: rod(2) = [21.56e3_wp, 20.614e3_wp]
      integer :: i
      do i = 1, size(lengths)
         if (allocated(deck)) deallocate (deck)
         allocate (deck(0))
         call append_text(deck, "&trajectory md = 0, 50, 150, inc = 30, 30, 63, azi = 0, 0, 0 /")
         call append_text(deck, "&hole diameter = 215.9, friction = 0.3 /")
         call append_text(deck, "&fluid density = 1200 /")
         call append_text(deck, "&component od = 127, id = 76.2, mass = 73, joint_od = 168.3, joint_length = "//lengths(i)//' /')
         call append_text(deck, "&load_case name = 'a', operation = 'up', bit_depth = 150, wob = -250 /")
         call append_text(deck, "&solver tool_joints = 'discrete' /")
         call solve_deck(deck, 0.0_wp, .false., result)
         call note('largest moment over that of the rod, joints of '//lengths(i)//' m', &
                   maxval(abs(result%profile%bending))/rod(i))
         call assertRelativelyEqual(rod(i), maxval(abs(result%profile%bending)), 6.0e-3_wp, message=lengths(i))
      end do
   end subroutine test_pulled_joints

   !> Blades offset to the east in a vertical hole: they press there, and the bit and the top balance them in the west. Once the
   !> list said west for all three.
   subroutine test_eccentric_blade()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0, 60, inc = 0, 0, azi = 0, 0 /")
      call append_text(deck, "&hole diameter = 215.9 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', length = 0.3, od = 200, id = 70, joint_od = 215.9 /")
      call append_text(deck, "&component kind = 'collar', length = 4.45, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 0.5, od = 165.1, id = 71.4, joint_od = 211.9, "// &
                       "blade_offset = 10, blade_clock = 90 /")
      call append_text(deck, "&component kind = 'collar', od = 165.1, id = 71.4 /")
      call append_text(deck, "&load_case name = 'a', operation = 'static', bit_depth = 50, toolface = 0 /")
      call solve_deck(deck, 0.0_wp, .false., result)
      associate (found => result%contacts)
         call assertEqual(3, size(found), message='top, blades, bit')
         if (size(found) /= 3) return
         call assertEqual(0.5_wp*pi, found(2)%clock, 1.0e-3_wp, message='blades press east')
         call assertRelativelyEqual(sum(found([1, 3])%force), found(2)%force, 2.0e-3_wp, message='balance')
         call assertEqual(1.5_wp*pi, modulo(found(1)%clock, 2.0_wp*pi), 1.0e-3_wp, message='top')
         call assertEqual(1.5_wp*pi, modulo(found(3)%clock, 2.0_wp*pi), 1.0e-3_wp, message='bit')
      end associate
   end subroutine test_eccentric_blade

   !> A blade of 1.2 m beside a bent housing presses south with its upper and north with its lower edge, as an independent rod
   !> finds: 40.1 and 33.7 kN, 6.38 kN together. All contacts balance in a vertical hole. Once it was one force of 75 kN.
   subroutine test_two_edges()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      integer :: blades(3), i
      allocate (deck(0))
      call append_text(deck, "&trajectory md = 0, 60, inc = 0, 0, azi = 0, 0 /")
      call append_text(deck, "&hole diameter = 215.9 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', length = 0.3, od = 200, id = 70, joint_od = 215.9 /")
      call append_text(deck, "&component kind = 'collar', length = 2, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 1.2, od = 165.1, id = 71.4, joint_od = 214.9 /")
      call append_text(deck, "&component kind = 'motor', length = 7, od = 165.1, id = 71.4, bend = 1, bend_position = 1 /")
      call append_text(deck, "&component kind = 'stabilizer', length = 0.4, od = 165.1, id = 71.4, joint_od = 212.7 /")
      call append_text(deck, "&component kind = 'collar', od = 165.1, id = 71.4 /")
      call append_text(deck, "&load_case name = 'a', operation = 'static', bit_depth = 50, toolface = 0 /")
      call solve_deck(deck, 0.0_wp, .false., result)
      associate (found => result%contacts)
         blades = pack([(i, i=1, size(found))], found%kind == contact_blades, [0, 0, 0])
         call assertEqual(3, count(found%kind == contact_blades), message='one above, two edges of the long one')
         if (any(blades == 0)) return
         call assertEqual(-1.0_wp, cos(found(blades(2))%clock), 1.0e-3_wp, message='upper edge, south')
         call assertEqual(1.0_wp, cos(found(blades(3))%clock), 1.0e-3_wp, message='lower edge, north')
         call note('upper and lower edge over those of the rod', found(blades(2))%force/40.1e3_wp)
         call assertRelativelyEqual(6.38e3_wp, found(blades(2))%force - found(blades(3))%force, 5.0e-3_wp, message='together')
         call assertRelativelyEqual(40.1e3_wp, found(blades(2))%force, 0.025_wp, message='upper edge')
         call assertEqual(0.0_wp, sum(found%force*cos(found%clock)), 2.0e-3_wp*found(blades(2))%force, message='balance')
      end associate
   end subroutine test_two_edges

   !> A deck at the default settings, and on elements so long.
   subroutine solve_both(deck, length, result, fine)
      type(text_type), intent(in) :: deck(:)
      real(wp), intent(in) :: length       !< [m]
      type(case_result_type), intent(out) :: result, fine
      call solve_deck(deck, 0.0_wp, .false., result)
      call solve_deck(deck, length, .false., fine)
   end subroutine solve_both

   !> The sum of contact is that on finer elements.
   subroutine compare_contact(result, fine, within)
      type(case_result_type), intent(in) :: result, fine
      real(wp), intent(in) :: within       !< of it [-]
      call note('sum of contact over that on fine elements, less one', result%normal_force/fine%normal_force - 1.0_wp)
      call assertRelativelyEqual(fine%normal_force, result%normal_force, within, message='sum of contact')
   end subroutine compare_contact

   !> Tool joints that touch one by one, moments proven on elements of some millimetres beside them: the area under the side force
   !> of the rows is the sum of contact. Once each node next to a joint counted as that joint, and a quarter of the area was lost.
   subroutine test_joints_one_by_one()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: result
      real(wp) :: area
      integer :: n
      allocate (deck(0))
      call start_jointed(deck, '')
      call solve_deck(deck, 0.0_wp, .true., result)
      associate (p => result%profile)
         n = size(p%md)
         area = 0.5_wp*sum((p%side_force(2:) + p%side_force(:n - 1))*(p%md(2:) - p%md(:n - 1)))
      end associate
      call note('area under the side force over the sum of contact, less one', area/result%normal_force - 1.0_wp)
      call assertRelativelyEqual(result%normal_force, area, 1.0e-6_wp, message='area under the side force')
   end subroutine test_joints_one_by_one

   !> Joints of 1 and 20 mm touch at one point, as those of half a metre do. Once joints below 30 mm were lost: contact stood at 7
   !> places of 36.
   subroutine test_short_joints()
      type(text_type), allocatable :: deck(:)
      type(case_result_type) :: usual, short
      integer :: i
      character(*), parameter :: length(2) = [character(22) :: ', joint_length = 0.02', ', joint_length = 0.001']
      allocate (deck(0))
      call start_jointed(deck, '')
      call solve_deck(deck, 0.0_wp, .false., usual)
      do i = 1, size(length)
         deallocate (deck)
         allocate (deck(0))
         call start_jointed(deck, trim(length(i)))
         call solve_deck(deck, 0.0_wp, .false., short)
         call assertEqual(size(usual%contacts), size(short%contacts), message='contacts'//length(i))
         call assertRelativelyEqual(usual%normal_force, short%normal_force, 1.0e-3_wp, message='sum of contact'//length(i))
         ! a usual joint touches with both edges, which a short one cannot
         call assertRelativelyEqual(maxval(usual%profile%bending), maxval(short%profile%bending), 0.02_wp, &
                                    message='moment'//length(i))
      end do
   end subroutine test_short_joints

   !> Drill pipe whose joints touch one by one, `more` of which is given.
   subroutine start_jointed(deck, more)
      type(text_type), allocatable, intent(inout) :: deck(:)
      character(*), intent(in) :: more
      call append_text(deck, "&trajectory md = 0.0, 300.0, 600.0, 1000.0, inc = 0.0, 0.0, 50.0, 50.0, azi = 4*30.0 /")
      call append_text(deck, "&hole diameter = 215.9, friction = 0.3 /")
      call append_text(deck, "&fluid density = 1200.0 /")
      call append_text(deck, "&component name = 'bit', kind = 'bit', length = 0.25, od = 165.1, id = 60.0 /")
      call append_text(deck, "&component name = 'collar', kind = 'collar', length = 18.0, od = 165.1, id = 71.4 /")
      call append_text(deck, "&component name = 'pipe', od = 127.0, id = 108.6, mass = 31.9, joint_od = 168.3"//more//" /")
      call append_text(deck, "&load_case name = 'c', operation = 'trip_out', bit_depth = 1000.0 /")
      call append_text(deck, "&solver tool_joints = 'discrete' /")
   end subroutine start_jointed

   !> Moments of a deck at the default settings are found, and are those of elements so long.
   subroutine compare_moments(deck, length)
      type(text_type), intent(in) :: deck(:)
      real(wp), intent(in) :: length       !< [m]
      type(case_result_type) :: result, fine
      real(wp) :: worst, rms, largest
      call solve_both(deck, length, result, fine)
      largest = maxval(fine%profile%bending)
      call compare_lines(result%profile%md, result%profile%bending, fine%profile%md, fine%profile%bending, worst, rms)
      call note('moment off, root mean square, over the largest', rms/largest)
      call note('moment off at worst, over the largest', worst/largest)
      call assertFalse(is_missing(result%moment_error), message='moments found')
      call assertLessThan(rms, 0.01_wp*largest, message='moments, root mean square')
      call assertRelativelyEqual(largest, maxval(result%profile%bending), 0.03_wp, message='largest moment')
   end subroutine compare_moments

   subroutine add_holes(deck, bottom, diameter)
      type(text_type), allocatable, intent(inout) :: deck(:)
      real(wp), intent(in) :: bottom(:), diameter(:)     !< [m, mm]
      character(80) :: line
      integer :: i
      do i = 1, size(bottom)
         write (line, '(a,f0.2,a,f0.1,a)') '&hole md_bottom = ', bottom(i), ', diameter = ', diameter(i), ', friction = 0.1 /'
         call append_text(deck, trim(line))
      end do
   end subroutine add_holes

   !> Solves the one case of a deck, on elements so long or, where that is 0, as the program chooses.
   subroutine solve_deck(deck, length, proven, result, status, totals_only)
      type(text_type), intent(in) :: deck(:)
      real(wp), intent(in) :: length       !< [m]
      logical, intent(in) :: proven        !< elements are halved until moments stand
      type(case_result_type), intent(out) :: result
      integer, intent(in), optional :: status       !< expected; default: converged
      logical, intent(in), optional :: totals_only  !< as of a point of a sweep
      type(text_type), allocatable :: lines(:)
      type(model_type) :: model
      type(job_type) :: job
      type(error_list_type) :: faults
      type(error_type), allocatable :: error
      integer :: i, expected
      expected = result_converged
      if (present(status)) expected = status
      allocate (lines(0))
      call append_text(lines, "&job title = 'lone contacts' /")
      do i = 1, size(deck)
         call append_text(lines, deck(i)%text)
      end do
      call write_text_file(path, lines, error)
      call assertFalse(allocated(error), message='deck written')
      call read_deck(path, model, job, faults)
      call assertEqual(0, faults%count, message='deck read')
      if (length > 0.0_wp) model%numerics%element_length = length
      if (proven) model%numerics%halve_moments = .true.
      call solve_static_analysis(model, 1, result, error, totals_only)
      call assertEqual(expected, result%status, message='status')
   end subroutine solve_deck
end module dg_test_lone_contacts

!> Results along a string at default settings, against a string solved independently (dg_independent_beam). Cases: rotating and
!> pulled strings in a hole that builds and turns, a tapered one, a sharp dogleg, casing run in.
module dg_test_moments
   use funit, only: assertGreaterThan, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: case_result_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_independent_beam, only: bend_stretched, independent_beam_type, independent_well_type, places_of, push_at_bit, &
                                  value_at
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_missing, only: is_missing
   use dg_mixed_string, only: solve_mixed_string
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_profile, only: profile_type
   use dg_rigid_string, only: solve_rigid_string
   use dg_test_wells, only: hold_ends, new_well, note, part, solve
   implicit none
   private
   public :: moments_suite

   !> Promised errors at default settings. Over the largest moment: the largest moment itself, how far it may be low, every row,
   !> root mean square. Over their own size: hook load, torque, sum of contact.
   real(wp), parameter :: largest_within = 0.03_wp, never_below = 0.02_wp, everywhere_within = 0.05_wp, mean_within = 0.01_wp
   real(wp), parameter :: hookload_within = 1.0e-3_wp, contact_within = 5.0e-3_wp, torque_within = 2.0e-3_wp
   !> Force and tilt of the bit as vectors, over their own size. Seen: 0.2 %; by the elements of the analysis 3 to 5 %.
   real(wp), parameter :: bit_within = 5.0e-3_wp
   !> Largest estimated error in a result: more than the true error, and less than the limit of a warning.
   real(wp), parameter :: told_within = 0.05_wp
   !> The rest of the columns. Axial force over the largest and torque over that at the top: between the nodes of the analysis
   !> they go along straight lines past contacts that stand at one place. Offset, as a vector, over the clearance; clock angle on
   !> the wall; contact summed up from the top over all of it; shear over the largest: it jumps at the ends of contact, where a
   !> row is held to lie between what the reference has within some steps of it.
   real(wp), parameter :: axial_within = 4.0e-3_wp, torque_along_within = 0.01_wp, offset_within = 0.01_wp
   real(wp), parameter :: clock_within = 0.5_wp*degree, sum_within = 0.03_wp, shear_within = 0.1_wp, shear_mean_within = 0.015_wp
   real(wp), parameter :: at_a_jump = 0.5_wp
   !> All round a row that is held to lie on the wall, the string does [m].
   real(wp), parameter :: wall_part = 5.0_wp
   !> Hook load of the stiff string: it counts contact on both sides of a change of sides, where beams hang free.
   real(wp), parameter :: rigid_within = 0.015_wp
   !> Rows nearer than this to an end are not compared [m]: the bit of a stretched string is not where the other one's is.
   real(wp), parameter :: end_part = 5.0_wp
   !> A hole that builds and turns at once [m, deg, deg].
   real(wp), parameter :: build_md(5) = [0.0_wp, 200.0_wp, 300.0_wp, 700.0_wp, 1100.0_wp]
   real(wp), parameter :: build_inc(5) = [0.0_wp, 0.0_wp, 10.0_wp, 40.0_wp, 40.0_wp]
   real(wp), parameter :: build_azi(5) = [40.0_wp, 40.0_wp, 40.0_wp, 110.0_wp, 110.0_wp]

contains

   function moments_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('moments')
      call suite%addTest(TestMethod('rotating', test_rotating))
      call suite%addTest(TestMethod('drilling', test_drilling))
      call suite%addTest(TestMethod('torque', test_torque))
      call suite%addTest(TestMethod('tapered', test_tapered))
      call suite%addTest(TestMethod('dogleg', test_dogleg))
      call suite%addTest(TestMethod('casing', test_casing))
      call suite%addTest(TestMethod('couple', test_couple))
      call suite%addTest(TestMethod('rigid_and_mixed', test_rigid))
   end function moments_suite

   !> Drill pipe in the hole that builds and turns.
   function pipe_in_bend() result(well)
      type(independent_well_type) :: well
      call set_hole(well, build_md, build_inc, build_azi)
      well%diameter = 0.2159_wp
      well%mud = 1250.0_wp
      well%bit = 1050.0_wp
      call set_string(well, [0.0_wp], [0.127_wp], [0.1086_wp], [0.1619_wp], [31.9_wp])
   end function pipe_in_bend

   pure subroutine set_hole(well, md, inclination, azimuth)
      type(independent_well_type), intent(inout) :: well
      real(wp), intent(in) :: md(:), inclination(:), azimuth(:)   !< [m, deg, deg]
      well%md = md
      well%inclination = inclination
      well%azimuth = azimuth
   end subroutine set_hole

   pure subroutine set_string(well, length, od, id, joint, mass)
      type(independent_well_type), intent(inout) :: well
      real(wp), intent(in) :: length(:), od(:), id(:), joint(:), mass(:)
      well%length = length
      well%od = od
      well%id = id
      well%joint = joint
      well%mass = mass
   end subroutine set_string

   subroutine test_rotating()
      type(independent_well_type) :: well
      well = pipe_in_bend()
      well%around = 0.3_wp
      call compare(well, operation_rotate_off_bottom, 'rotating')
   end subroutine test_rotating

   !> On bottom, compressed below buckling.
   subroutine test_drilling()
      type(independent_well_type) :: well
      well = pipe_in_bend()
      well%around = 0.3_wp
      well%wob = 30.0e3_wp
      well%tob = 5.0e3_wp
      call compare(well, operation_rotary_drilling, 'drilling')
   end subroutine test_drilling

   !> A torque on the bit that turns the string about the hole where it is off the wall: the other way round, it would lie elsewhere
   !> by 0.07 of the clearance.
   subroutine test_torque()
      type(independent_well_type) :: well
      well = pipe_in_bend()
      well%around = 0.3_wp
      well%tob = 20.0e3_wp
      call compare(well, operation_rotary_drilling, 'torque')
   end subroutine test_torque

   subroutine test_tapered()
      type(independent_well_type) :: well
      well = pipe_in_bend()
      well%along = 0.25_wp
      call set_string(well, [90.0_wp, 120.0_wp, 0.0_wp], [0.1651_wp, 0.127_wp, 0.127_wp], [0.0714_wp, 0.0762_wp, 0.1086_wp], &
                      [0.1651_wp, 0.1651_wp, 0.1619_wp], [136.0_wp, 73.4_wp, 31.9_wp])
      call compare(well, operation_trip_out, 'tapered')
   end subroutine test_tapered

   !> 12 deg/30 m over 20 m, sideways for the most part, under 300 kN at the bit.
   subroutine test_dogleg()
      type(independent_well_type) :: well
      call set_hole(well, [0.0_wp, 250.0_wp, 270.0_wp, 600.0_wp], [2.0_wp, 2.0_wp, 9.2_wp, 9.2_wp], &
                    [50.0_wp, 50.0_wp, 75.0_wp, 75.0_wp])
      well%diameter = 0.2159_wp
      well%mud = 1200.0_wp
      well%bit = 560.0_wp
      well%wob = -300.0e3_wp
      well%along = 0.2_wp
      well%step = 0.1_wp
      call set_string(well, [0.0_wp], [0.127_wp], [0.0762_wp], [0.1651_wp], [73.4_wp])
      call compare(well, operation_trip_out, 'dogleg')
   end subroutine test_dogleg

   function casing_in_bend() result(well)
      type(independent_well_type) :: well
      well = pipe_in_bend()
      well%diameter = 0.3112_wp
      well%mud = 1300.0_wp
      well%along = -0.3_wp
      call set_string(well, [0.0_wp], [0.2445_wp], [0.2205_wp], [0.2699_wp], [69.9_wp])
   end function casing_in_bend

   subroutine test_casing()
      call compare(casing_in_bend(), operation_trip_in, 'casing')
   end subroutine test_casing

   !> Thick casing pulled with friction 1 through a sharp turn: the couple of friction at its skin is worth 0.26 % of the largest
   !> moment; with the other sign that would be 0.55 % larger.
   subroutine test_couple()
      type(independent_well_type) :: well
      well = casing_in_bend()
      call set_hole(well, [0.0_wp, 200.0_wp, 300.0_wp, 600.0_wp, 800.0_wp], [0.0_wp, 0.0_wp, 20.0_wp, 45.0_wp, 45.0_wp], build_azi)
      well%joint = 0.3_wp
      well%along = 1.0_wp
      well%bit = 780.0_wp
      well%step = 0.1_wp
      call compare(well, operation_trip_out, 'couple', 0.002_wp)
   end subroutine test_couple

   !> The model of the program for a well, at default settings.
   subroutine build(well, model)
      type(independent_well_type), intent(in) :: well
      type(model_type), intent(out) :: model
      integer :: i
      call new_well(model, well%md, well%inclination, well%azimuth, well%diameter, well%around + abs(well%along), &
                    part('drillpipe', 0.0_wp, well%od(1), well%id(1), well%mass(1), well%joint(1)))
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(size(well%od)))
      do i = 1, size(well%od)
         model%strings(1)%components(i) = part('drillpipe', well%length(i), well%od(i), well%id(i), well%mass(i), well%joint(i))
      end do
      model%cases(1)%bit_depth = well%bit
      model%cases(1)%wob = well%wob
      model%cases(1)%tob = well%tob
      model%mud = standing_mud(well%mud)
      model%gravity = well%gravity
      call hold_ends(model)
      model%numerics = settings_of('auto')
   end subroutine build

   subroutine compare(well, operation, what, closely)
      type(independent_well_type), intent(in) :: well
      integer, intent(in) :: operation
      character(*), intent(in) :: what
      real(wp), intent(in), optional :: closely    !< largest moment within this [-], other columns not
      type(independent_beam_type) :: beam
      type(model_type) :: model
      type(case_result_type) :: result
      logical :: found
      real(wp), allocatable :: place(:)
      call bend_stretched(well, beam, found)
      call assertTrue(found, message=what//': reference')
      call build(well, model)
      call solve(model, operation, well%wob, well%tob, result, what)
      call note(what//': hook load over the other', result%hookload/beam%axial(0) - 1.0_wp)
      call note(what//': contact over the other', result%normal_force/sum(beam%contact) - 1.0_wp)
      call assertRelativelyEqual(beam%axial(0), result%hookload, hookload_within, message=what//': hook load '//result%message)
      call assertRelativelyEqual(sum(beam%contact), result%normal_force, contact_within, message=what//': contact')
      if (well%around > 0.0_wp) call assertRelativelyEqual(beam%torque(0), result%torque, torque_within, message=what//': torque')
      place = places_of(beam, result%profile%md)
      call compare_moments(beam, result%profile, place, result%moment_error, what)
      if (present(closely)) call assertRelativelyEqual(maxval(norm2(beam%moment, dim=1)), maxval(result%profile%bending), closely, &
                                                       message=what//': largest moment')
      if (.not. present(closely)) call compare_columns(beam, result, place, what)
      call compare_bit(beam, result, what)
   end subroutine compare

   !> Force and tilt of the bit with their directions, over their own size.
   subroutine compare_bit(beam, result, what)
      type(independent_beam_type), intent(in) :: beam
      type(case_result_type), intent(in) :: result
      character(*), intent(in) :: what
      real(wp) :: push(2), slope(2)
      call push_at_bit(beam, push, slope)
      push = result%bit_side_force*direction(result%bit_side_clock)/norm2(push) - push/norm2(push)
      slope = tan(result%bit_tilt)*direction(result%bit_tilt_clock)/norm2(slope) - slope/norm2(slope)
      call note(what//': side force of the bit off', norm2(push))
      call note(what//': tilt of the bit off', norm2(slope))
      call assertLessThan(norm2(push), bit_within, message=what//': side force of the bit')
      call assertLessThan(norm2(slope), bit_within, message=what//': tilt of the bit')
   end subroutine compare_bit

   !> Rows that are compared.
   pure function inner(beam, place) result(yes)
      type(independent_beam_type), intent(in) :: beam
      real(wp), intent(in) :: place(:)
      logical :: yes(size(place))
      yes = place > end_part .and. place < beam%x(beam%n) - end_part
   end function inner

   !> Root of the mean square by length: rows crowd where the moment changes.
   pure function mean_of(off, place, counts) result(mean)
      real(wp), intent(in) :: off(:), place(:)
      logical, intent(in) :: counts(:)
      real(wp) :: mean, weight(size(place))
      integer :: n
      n = size(place)
      weight(1) = 0.0_wp
      weight(2:) = 0.5_wp*(place(2:) - place(:n - 1))
      weight(:n - 1) = weight(:n - 1) + weight(2:)
      mean = sqrt(sum(off**2*weight, mask=counts)/sum(weight, mask=counts))
   end function mean_of

   subroutine compare_moments(beam, profile, place, told, what)
      type(independent_beam_type), intent(in) :: beam
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: place(:)
      real(wp), intent(in) :: told        !< how far moments may be off as the result has it [-]
      character(*), intent(in) :: what
      real(wp) :: largest, off(size(place)), mean, moment(0:beam%n)
      integer :: i
      moment = norm2(beam%moment, dim=1)
      largest = maxval(moment)
      do i = 1, size(place)
         off(i) = (profile%bending(i) - value_at(beam, moment, place(i)))/largest
      end do
      mean = mean_of(off, place, inner(beam, place))
      i = maxloc(abs(off), dim=1, mask=inner(beam, place))
      call note(what//': largest moment over the other', maxval(profile%bending)/largest - 1.0_wp)
      call note(what//': moment off at worst, over the largest', off(i))
      call note(what//': where', place(i))
      call note(what//': moment off, root mean square', mean)
      call assertLessThan(maxval(profile%bending)/largest, 1.0_wp + largest_within, message=what//': largest moment too high')
      call assertGreaterThan(maxval(profile%bending)/largest, 1.0_wp - never_below, message=what//': largest moment too low')
      call assertLessThan(abs(off(i)), everywhere_within, message=what//': moment somewhere')
      call assertLessThan(mean, mean_within, message=what//': moment, mean')
      call note(what//': told error over that at worst', told/abs(off(i)))
      call assertLessThan(abs(off(i)), told, message=what//': more off than told')
      call assertLessThan(told, told_within, message=what//': told error')
   end subroutine compare_moments

   !> An angle without whole turns [rad], and the clock angle of the other solution at a place.
   pure function turn_of(angle) result(turn)
      real(wp), intent(in) :: angle
      real(wp) :: turn
      turn = angle - 2.0_wp*pi*nint(angle/(2.0_wp*pi))
   end function turn_of

   !> True if the hole leaves the vertical between two nodes about a place, and clock angles go over from north to the high side.
   pure function north_ends(beam, place) result(yes)
      type(independent_beam_type), intent(in) :: beam
      real(wp), intent(in) :: place
      logical :: yes
      integer :: i
      i = min(max(int(place/beam%h), 1), beam%n - 2)
      yes = .not. norm2(beam%weight(:, i - 1)) > 0.0_wp .and. norm2(beam%weight(:, i + 2)) > 0.0_wp
   end function north_ends

   pure function direction(clock) result(n)
      real(wp), intent(in) :: clock
      real(wp) :: n(2)
      n = [cos(clock), sin(clock)]
   end function direction

   pure function clock_at(beam, place) result(clock)
      type(independent_beam_type), intent(in) :: beam
      real(wp), intent(in) :: place
      real(wp) :: clock
      integer :: i
      i = min(max(int(place/beam%h), 0), beam%n - 1)
      clock = beam%clock(i) + (place/beam%h - i)*turn_of(beam%clock(i + 1) - beam%clock(i))
   end function clock_at

   !> Axial force, torque, offset, clock angle on the wall, shear and contact summed up from the top.
   subroutine compare_columns(beam, result, place, what)
      type(independent_beam_type), intent(in) :: beam
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: place(:)
      character(*), intent(in) :: what
      real(wp), dimension(size(place)) :: axial, torque, offset, clock, shear, misplaced, summed, sums
      real(wp) :: distance(0:beam%n), force(0:beam%n), contact(0:beam%n), other(2)
      integer :: i
      logical :: counts(size(place)), lies(size(place)), beside(0:beam%n)
      associate (profile => result%profile)
         distance = norm2(beam%y, dim=1)
         force(1:) = norm2(beam%shear, dim=1)
         force(0) = force(1)
         force(1:beam%n - 1) = 0.5_wp*(force(1:beam%n - 1) + force(2:))
         contact(0) = beam%contact(0)
         do i = 1, beam%n
            contact(i) = contact(i - 1) + 0.5_wp*(beam%contact(i - 1) + beam%contact(i))
         end do
         counts = inner(beam, place)
         do i = 1, size(place)
            axial(i) = profile%axial(i) - value_at(beam, beam%axial, place(i))
            torque(i) = profile%torque(i) - value_at(beam, beam%torque, place(i))
            other = value_at(beam, distance, place(i))*direction(clock_at(beam, place(i)))
            offset(i) = norm2(profile%displacement(i)*direction(profile%clock(i)) - other)/beam%clearance(beam%n)
            if (north_ends(beam, place(i))) offset(i) = 0.0_wp
            lies(i) = all(beam%clearance - distance < 0.05_wp*beam%clearance .or. abs(beam%x - place(i)) > wall_part)
            clock(i) = turn_of(profile%clock(i) - clock_at(beam, place(i)))
            shear(i) = 0.0_wp
            if (.not. is_missing(profile%shear(i))) shear(i) = (profile%shear(i) - value_at(beam, force, place(i)))/maxval(force)
            misplaced(i) = 0.0_wp
            beside = abs(beam%x - place(i)) < at_a_jump
            if (abs(shear(i)) > 0.0_wp) misplaced(i) = max(profile%shear(i) - maxval(force, beside), &
                                                           minval(force, beside) - profile%shear(i), 0.0_wp)/maxval(force)
            summed(i) = value_at(beam, contact, place(i))/contact(beam%n)
         end do
         sums(1) = 0.0_wp
         do i = 2, size(place)
            sums(i) = sums(i - 1) + 0.5_wp*(profile%md(i) - profile%md(i - 1))*sum(profile%side_force(i - 1:i))
         end do
         call note(what//': axial force off', maxval(abs(axial), mask=counts)/maxval(abs(beam%axial)))
         call note(what//': torque off', maxval(abs(torque), mask=counts)/max(beam%torque(0), 1.0_wp))
         call note(what//': offset off, over the clearance', maxval(abs(offset), mask=counts))
         call note(what//': clock off on the wall, deg', maxval(abs(clock), mask=counts .and. lies)/degree)
         call note(what//': shear off, over the largest', maxval(abs(shear), mask=counts))
         call note(what//': the same, but for its place', maxval(misplaced, mask=counts))
         call note(what//': shear off, root mean square', mean_of(shear, place, counts))
         call note(what//': summed contact off', maxval(abs(sums/result%normal_force - summed), mask=counts))
         call note(what//': side force over the md, over the sum of contact', sums(size(sums))/result%normal_force - 1.0_wp)
         call assertLessThan(maxval(abs(axial), mask=counts), axial_within*maxval(abs(beam%axial)), message=what//': axial force')
         call assertLessThan(maxval(abs(torque), mask=counts), torque_along_within*max(beam%torque(0), 1.0_wp), &
                             message=what//': torque along')
         call assertLessThan(maxval(abs(offset), mask=counts), offset_within, message=what//': offset')
         call assertLessThan(maxval(abs(clock), mask=counts .and. lies), clock_within, message=what//': clock')
         call assertLessThan(maxval(misplaced, mask=counts), shear_within, message=what//': shear')
         call assertLessThan(mean_of(shear, place, counts), shear_mean_within, message=what//': shear, mean')
         call assertLessThan(maxval(abs(sums/result%normal_force - summed), mask=counts), sum_within, &
                             message=what//': contact along')
         call assertRelativelyEqual(result%normal_force, sums(size(sums)), 1.0e-6_wp, message=what//': side force adds up')
      end associate
   end subroutine compare_columns

   !> Strings that follow the hole, stiff all along or in places, have the hole's own moment: in long bends, away from their ends,
   !> that of the others.
   subroutine test_rigid()
      character(5), parameter :: name(2) = ['rigid', 'mixed']
      type(independent_well_type) :: well
      type(independent_beam_type) :: beam
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      logical :: found
      integer :: i, which
      well = casing_in_bend()
      call bend_stretched(well, beam, found)
      call assertTrue(found, message='rigid: reference')
      call build(well, model)
      model%cases(1)%operation = operation_trip_in
      do which = 1, 2
         if (which == 1) call solve_rigid_string(model, 1, result, error)
         if (which == 2) call solve_mixed_string(model, 1, result, error)
         call assertTrue(.not. allocated(error), message=name(which))
         call note(name(which)//': hook load over the other', result%hookload/beam%axial(0) - 1.0_wp)
         call assertRelativelyEqual(beam%axial(0), result%hookload, rigid_within, message=name(which)//': hook load')
         do i = 1, size(result%profile%md)
            if (minval(abs(result%profile%md(i) - well%md(3:4))) < 40.0_wp) cycle
            if (result%profile%md(i) < well%md(3) .or. result%profile%md(i) > well%md(4)) cycle
            call assertRelativelyEqual(value_at(beam, norm2(beam%moment, dim=1), result%profile%md(i)), &
                                       result%profile%bending(i), largest_within, message=name(which)//': moment')
         end do
      end do
   end subroutine test_rigid
end module dg_test_moments

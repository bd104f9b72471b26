!> Tortuosity on a plan against closed forms, what is drawn at random against its distribution, and surveys tied on to surface.
module dg_test_tortuosity
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use dg_constants, only: degree, pi
   use dg_error, only: error_list_type
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_minimum_curvature, only: dogleg_between
   use dg_model, only: model_type
   use dg_model_text, only: model_lines
   use dg_read_deck, only: build_deck
   use dg_test_trajectory, only: path
   use dg_text, only: append_text, text_type
   use dg_tortuosity, only: lay_tortuosity, lower_end, tortuosity_type, turning
   use dg_trajectory, only: position_at, tangent_of, trajectory_type
   implicit none
   private
   public :: tortuosity_suite

   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   function tortuosity_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('tortuosity')
      call suite%addTest(TestMethod('sine_in_a_vertical_hole', test_vertical))
      call suite%addTest(TestMethod('sine_in_an_inclined_hole', test_inclined))
      call suite%addTest(TestMethod('plan_outside_and_at_ends', test_plan))
      call suite%addTest(TestMethod('what_is_drawn', test_drawn))
      call suite%addTest(TestMethod('seeds_and_records', test_seeds))
      call suite%addTest(TestMethod('tied_on', test_tied_on))
      call suite%addTest(TestMethod('kick_off', test_kick_off))
   end function tortuosity_suite

   !> The stations of a plan with one section laid on it.
   subroutine laid(plan, section, md, inclination, azimuth)
      type(trajectory_type), intent(in) :: plan
      type(tortuosity_type), intent(in) :: section
      real(wp), allocatable, intent(out) :: md(:), inclination(:), azimuth(:)
      md = plan%md
      inclination = plan%inclination
      azimuth = plan%azimuth
      call lay_tortuosity(plan, section, md, inclination, azimuth)
      call assertTrue(all(md(2:) > md(:size(md) - 1)), message='depths increase')
   end subroutine laid

   !> In a vertical hole a sine swings in one plane: it turns by 4 amplitudes a period, and the root mean square of doglegs over a
   !> length h is sqrt(2) A sin(pi h/P).
   subroutine test_vertical()
      real(wp), parameter :: amplitude = 0.8_wp*degree, period = 80.0_wp, h = 30.0_wp
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      type(trajectory_type) :: drilled, plan
      real(wp) :: square
      integer :: i, steps, first
      plan = path([0.0_wp, 1000.0_wp], [0.0_wp, 0.0_wp], [50.0_wp, 50.0_wp])
      call laid(plan, tortuosity_type(amplitude=amplitude, period=period, md_top=100.0_wp, md_bottom=900.0_wp), &
                md, inclination, azimuth)
      drilled = path(md, inclination/degree, azimuth/degree)
      call assertEqual(10*4*amplitude, turning(drilled, 0.0_wp, 1000.0_wp), round_off)
      call assertEqual(0.0_wp, turning(plan, 0.0_wp, 1000.0_wp), round_off)
      call assertEqual(amplitude, maxval(inclination), round_off)
      steps = nint(h/(period/16))
      first = 2                ! stations at 0, then 100, 105, ...
      square = 0.0_wp
      do i = first, first + 127
         square = square + dogleg_between(tangent_of(inclination(i), azimuth(i)), &
                                          tangent_of(inclination(i + steps), azimuth(i + steps)))**2/128
      end do
      call assertEqual(sqrt(2.0_wp)*amplitude*sin(pi*h/period), sqrt(square), 1.0e-10_wp)
      ! it swings in the plane of the azimuth that the plan names
      do i = 1, size(md)
         call assertEqual(0.0_wp, sin(inclination(i))*sin(azimuth(i) - 50.0_wp*degree), round_off)
      end do
   end subroutine test_vertical

   !> At an inclination i, both angles change by x: a period turns by twice the integral of sqrt(1 + sin(i + x)^2) from -A to A,
   !> here by Simpson's rule; the arcs between stations cut the sphere's curve by less than 1e-5 of it.
   subroutine test_inclined()
      real(wp), parameter :: amplitude = 1.0_wp*degree, plan_inclination = 60.0_wp
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      type(trajectory_type) :: drilled
      real(wp) :: expected
      call laid(path([0.0_wp, 1000.0_wp], [plan_inclination, plan_inclination], [359.9_wp, 359.9_wp]), &
                tortuosity_type(amplitude=amplitude, period=100.0_wp, md_bottom=1000.0_wp), md, inclination, azimuth)
      drilled = path(md, inclination/degree, azimuth/degree)
      expected = 2.0_wp*(2.0_wp*amplitude)*(speed(-amplitude) + 4.0_wp*speed(0.0_wp) + speed(amplitude))/6.0_wp
      call assertEqual(10.0_wp*expected, turning(drilled, 0.0_wp, 1000.0_wp), 1.0e-5_wp*expected*10.0_wp)
      call assertEqual(161, size(md))
      call assertEqual(1000.0_wp, md(161), message='the very end of the plan')
   contains
      pure function speed(x) result(value)
         real(wp), intent(in) :: x
         real(wp) :: value
         value = sqrt(1.0_wp + sin(plan_inclination*degree + x)**2)
      end function speed
   end subroutine test_inclined

   !> Stations outside stay; inside they take part, unless one is added next to them; a section ends with a whole half period; at
   !> its ends the hole has the plan's direction.
   subroutine test_plan()
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      type(trajectory_type) :: plan
      type(tortuosity_type) :: section
      real(wp) :: tangent(3), position(3), change
      integer :: i
      plan = path([0.0_wp, 500.0_wp, 703.0_wp, 850.1_wp, 1200.0_wp, 2000.0_wp], &
                  [0.0_wp, 0.0_wp, 20.0_wp, 30.0_wp, 60.0_wp, 60.0_wp], [10.0_wp, 10.0_wp, 10.0_wp, 10.0_wp, 10.0_wp, 10.0_wp])
      section = tortuosity_type(amplitude=0.5_wp*degree, period=160.0_wp, md_top=600.0_wp, md_bottom=1150.0_wp)
      call assertEqual(1080.0_wp, lower_end(section), round_off*1080)
      call laid(plan, section, md, inclination, azimuth)
      call assertEqual([0.0_wp, 500.0_wp], md(:2), message='above')
      call assertEqual([1200.0_wp, 2000.0_wp], md(size(md) - 1:), message='below')
      call assertEqual([60.0_wp, 60.0_wp]*degree, inclination(size(md) - 1:), round_off)
      call assertTrue(any(abs(md - 703.0_wp) <= 0.0_wp), message='a station of the plan between two added ones stays')
      call assertFalse(any(abs(md - 850.1_wp) <= 0.0_wp), message='one next to an added one gives way')
      call assertEqual(2 + 49 + 1 + 2, size(md))
      do i = 1, size(md)
         if (md(i) < section%md_top .or. md(i) > 1080.0_wp) cycle
         call position_at(plan, md(i), position, tangent)
         change = section%amplitude*sin(2.0_wp*pi*(md(i) - 600.0_wp)/160.0_wp)
         call assertEqual(acos(tangent(3)) + change, inclination(i), 1.0e-10_wp)
         call assertEqual(10.0_wp*degree + change, azimuth(i), 1.0e-10_wp)
      end do
   end subroutine test_plan

   !> Up or down and sideways: within the amplitude, mean square a third of its square, as of an even distribution, within four
   !> standard errors; the two are not correlated.
   subroutine test_drawn()
      real(wp), parameter :: amplitude = 0.7_wp*degree
      integer, parameter :: n = 2001
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      real(wp) :: upwards(n - 1), sideways(n - 1), tangent(3)
      integer :: i
      call laid(path([0.0_wp, 10.0_wp*n], [60.0_wp, 60.0_wp], [90.0_wp, 90.0_wp]), &
                tortuosity_type(random=.true., amplitude=amplitude, period=10.0_wp, md_bottom=10.0_wp*n, seed=7), &
                md, inclination, azimuth)
      call assertEqual(n + 1, size(md))
      call assertEqual([60.0_wp, 60.0_wp]*degree, inclination([1, n + 1]), round_off, message='both ends on the plan')
      do i = 1, n - 1
         tangent = tangent_of(inclination(i + 1), azimuth(i + 1))
         sideways(i) = asin(-tangent(1))          ! a hole to the east: right is south
         upwards(i) = atan2(tangent(2), tangent(3)) - 60.0_wp*degree
      end do
      call assertLessThan(max(maxval(abs(sideways)), maxval(abs(upwards))), amplitude*(1.0_wp + round_off))
      call check(upwards)
      call check(sideways)
      call assertEqual(0.0_wp, sum(upwards*sideways)/(n - 1), 4.0_wp*amplitude**2/3.0_wp/sqrt(real(n - 1, wp)))
   contains
      subroutine check(angle)
         real(wp), intent(in) :: angle(:)
         call assertEqual(0.0_wp, sum(angle)/size(angle), 4.0_wp*amplitude/sqrt(3.0_wp*size(angle)))
         call assertEqual(amplitude**2/3.0_wp, sum(angle**2)/size(angle), 4.0_wp*amplitude**2*sqrt(4.0_wp/45.0_wp/size(angle)))
      end subroutine check
   end subroutine test_drawn

   !> The same seed gives the same hole, another seed, amplitude or period another one, and a record of a sweep knows.
   subroutine test_seeds()
      character(*), parameter :: base = "&tortuosity kind = 'random', amplitude = 0.5, period = 30"
      type(model_type) :: one, same, other
      type(text_type), allocatable :: notes(:)
      one = model_of("md = 0, 900, inc = 40, 40, azi = 10, 10", base//' /', notes)
      same = model_of("md = 0, 900, inc = 40, 40, azi = 10, 10", base//', seed = 1 /', notes)
      call assertTrue(all_alike(one, same))
      other = model_of("md = 0, 900, inc = 40, 40, azi = 10, 10", base//', seed = 2 /', notes)
      call assertFalse(all_alike(one, other), message='another seed')
      other = model_of("md = 0, 900, inc = 40, 40, azi = 10, 10", "&tortuosity kind = 'random', amplitude = 0.6, period = 30 /", &
                       notes)
      call assertFalse(all_alike(one, other), message='another amplitude')
      call assertEqual(1, size(notes))
      call assertTrue(index(notes(1)%text, '0 to 900 m: random changes of 0.6 deg every 30 m, seed 1.') > 0, message=notes(1)%text)
      other = model_of("md = 0, 900, inc = 40, 40, azi = 10, 10", '', notes)
      call assertFalse(all_alike(one, other), message='none')
      call assertFalse(allocated(other%path_notes))
      call assertEqual(0, size(notes))
   contains
      function all_alike(a, b) result(alike)
         type(model_type), intent(in) :: a, b
         logical :: alike
         type(text_type), allocatable :: lines_a(:), lines_b(:)
         integer :: i
         allocate (lines_a, source=model_lines(a, 'main'))
         allocate (lines_b, source=model_lines(b, 'main'))
         alike = size(lines_a) == size(lines_b)
         if (alike) alike = all([(lines_a(i)%text == lines_b(i)%text, i=1, size(lines_a))])
      end function all_alike
   end subroutine test_seeds

   !> A survey that begins vertical below surface has the path of one that says so.
   subroutine test_tied_on()
      type(model_type) :: tied, whole
      type(text_type), allocatable :: notes(:)
      whole = model_of('md = 0, 500, 900, inc = 0, 0, 40, azi = 30, 30, 30', '', notes)
      call assertEqual(0, size(notes))
      tied = model_of('md = 500, 900, inc = 0, 40, azi = 30, 30', '', notes)
      call assertEqual(1, size(notes))
      call assertEqual(whole%trajectory%md, tied%trajectory%md)
      call assertEqual(whole%trajectory%arcs(2)%origin, tied%trajectory%arcs(2)%origin)
      call assertEqual(whole%trajectory%arcs(2)%chord, tied%trajectory%arcs(2)%chord)
      tied = model_of('md = 600, 900, inc = 0.4, 40, azi = 30, 30', '', notes)
      call assertTrue(index(notes(1)%text, 'turns by 0.4 deg, 0.02 deg/30 m') > 0, message=notes(1)%text)
   end subroutine test_tied_on

   !> An arc from the kick-off to the first station: depth K + R sin(i), displacement R (1 - cos(i)).
   subroutine test_kick_off()
      type(model_type) :: tied
      type(text_type), allocatable :: notes(:)
      real(wp) :: position(3), tangent(3), radius
      tied = model_of("md = 500, 900, inc = 30, 40, azi = 90, 90, tie_on = 'vertical', kick_off = 200", '', notes)
      radius = 300.0_wp/(30.0_wp*degree)
      call position_at(tied%trajectory, 500.0_wp, position, tangent)
      call assertEqual([0.0_wp, radius*(1.0_wp - cos(30.0_wp*degree)), 200.0_wp + radius*sin(30.0_wp*degree)], position, 1.0e-10_wp)
      call assertTrue(index(notes(1)%text, 'turns by 30 deg, 3 deg/30 m') > 0, message=notes(1)%text)
      tied = model_of("md = 500, 900, inc = 30, 40, azi = 90, 90, tie_on = 'vertical'", '', notes)
      radius = 500.0_wp/(30.0_wp*degree)
      call position_at(tied%trajectory, 500.0_wp, position, tangent)
      call assertEqual([0.0_wp, radius*(1.0_wp - cos(30.0_wp*degree)), radius*sin(30.0_wp*degree)], position, 1.0e-10_wp)
      tied = model_of("md = 0, 900, inc = 30, 40, azi = 90, 90, tie_on = 'vertical'", '', notes)
      call assertEqual(0, size(notes), message='nothing to tie on')
      call assertEqual(2, size(tied%trajectory%md))
   end subroutine test_kick_off

   !> The model of a deck with that path; a fault fails the test.
   function model_of(stations, group, notes) result(model)
      character(*), intent(in) :: stations, group
      type(text_type), allocatable, intent(out) :: notes(:)
      type(model_type) :: model
      type(job_type) :: job
      type(error_list_type) :: faults
      type(text_type), allocatable :: lines(:)
      call append_text(lines, '&trajectory '//stations//' /')
      call append_text(lines, group)
      call append_text(lines, '&hole diameter = 215.9 /')
      call append_text(lines, '&fluid density = 1200 /')
      call append_text(lines, '&component kind = ''tubing'', od = 127, id = 108.6 /')
      call append_text(lines, "&load_case name = 'a', operation = 'static', bit_depth = 900 /")
      call build_deck('deck', lines, model, job, faults)
      notes = job%notes
      call assertEqual(0, faults%count)
   end function model_of
end module dg_test_tortuosity

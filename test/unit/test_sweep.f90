!> Sweeps: depths, numbering, the string at every depth, and the bookkeeping of records and parts.
module dg_test_sweep
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_case_result, only: result_converged, result_locked_up, result_not_converged
   use dg_component, only: component_type
   use dg_error, only: error_type
   use dg_hole_section, only: hole_section_type
   use dg_job, only: model_mcge, model_soft
   use dg_kinds, only: wp
   use dg_load_case, only: operation_count, operation_label, operation_rotate_off_bottom, operation_trip_in, operation_trip_out
   use dg_measured_table, only: factor_text, fitting_friction
   use dg_mesh, only: mesh_type, new_mesh, node_depths
   use dg_missing, only: given, missing, optional_real
   use dg_model, only: model_type
   use dg_model_text, only: sweep_lines
   use dg_number_text, only: page_width
   use dg_sweep, only: point_at, point_case, point_count, point_number, point_type, regular_depths, shown_depths, &
      sweep_type, with_depths
   use dg_sweep_result, only: is_solved, sweep_result_type
   use dg_sweep_table, only: sweep_table
   use dg_sweep_work, only: in_part, result_text, add_record, read_result
   use dg_task_record, only: difference_of, read_record, record_head, record_line, record_type
   use dg_text, only: append_text, text_type
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   use dg_units, only: si_units
   implicit none
   private
   public :: sweep_suite

contains

   function sweep_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('sweep')
      call suite%addTest(TestMethod('depths', test_depths))
      call suite%addTest(TestMethod('depths_in_a_table', test_depths_in_a_table))
      call suite%addTest(TestMethod('numbers', test_numbers))
      call suite%addTest(TestMethod('string_at_depth', test_string_at_depth))
      call suite%addTest(TestMethod('parts_cover_all_once', test_parts))
      call suite%addTest(TestMethod('result_through_text', test_result_text))
      call suite%addTest(TestMethod('record_through_text', test_record))
      call suite%addTest(TestMethod('damaged_records', test_damaged))
      call suite%addTest(TestMethod('impossible_results', test_impossible))
      call suite%addTest(TestMethod('whole_last_line', test_whole_last_line))
      call suite%addTest(TestMethod('long_settings', test_long_settings))
      call suite%addTest(TestMethod('foreign_records', test_foreign))
      call suite%addTest(TestMethod('settings_name_the_difference', test_settings))
      call suite%addTest(TestMethod('fitting_friction', test_fitting))
      call suite%addTest(TestMethod('heads_stand_apart', test_heads))
   end function sweep_suite

   !> Two models, two operations, three friction factors over a well with a shoe at 200 m and collars of 40 m.
   subroutine build(model, sweep)
      type(model_type), intent(out) :: model
      type(sweep_type), intent(out) :: sweep
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, [0.0_wp, 200.0_wp, 400.0_wp], [0.0_wp, 0.1_wp, 0.5_wp], spread(0.0_wp, 1, 3), &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      allocate (model%holes(2), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('cased', 0.0_wp, 200.0_wp, 0.22_wp, 0.2_wp, 0.25_wp)
      model%holes(2) = hole_section_type('open', 200.0_wp, 400.0_wp, 0.21_wp, 0.3_wp, 0.35_wp)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(2))
      model%strings(1)%components(1) = component_type('collar', 'collar', 40.0_wp, 0.16_wp, 0.07_wp, 130.0_wp)
      model%strings(1)%components(2) = component_type('pipe', 'drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 31.0_wp)
      sweep%name = 's'
      sweep%string = 'main'
      sweep%models = [model_mcge, model_soft]
      sweep%operations = [operation_trip_out, operation_rotate_off_bottom]
      allocate (sweep%frictions(3))
      sweep%frictions(1) = given(0.1_wp)
      sweep%frictions(3) = given(0.3_wp)
      sweep%depths = [50.0_wp, 100.0_wp, 250.0_wp, 400.0_wp]
      allocate (sweep%measured(0))
   end subroutine build

   subroutine test_depths()
      real(wp), parameter :: hair = 1.0e-9_wp
      call same([30.0_wp, 60.0_wp, 90.0_wp], regular_depths(0.0_wp, 90.0_wp, 30.0_wp), 'none at surface')
      call same([10.0_wp, 40.0_wp, 70.0_wp, 90.0_wp], regular_depths(10.0_wp, 90.0_wp, 30.0_wp), 'the last one always')
      call same([20.0_wp], regular_depths(0.0_wp, 20.0_wp, 30.0_wp), 'shorter than a step')
      call same([20.0_wp], regular_depths(20.0_wp, 20.0_wp, 30.0_wp), 'one depth')
      call same([0.1_wp, 0.2_wp, 0.3_wp], regular_depths(0.1_wp, 0.3_wp, 0.1_wp), 'no round-off at the end')
      call same([1.0_wp, 2.0_wp, 2.5_wp, 3.0_wp], with_depths([1.0_wp, 2.0_wp, 3.0_wp], [2.5_wp, 2.0_wp, 0.5_wp, 4.0_wp]), &
                'put in between')
   contains
      subroutine same(wanted, found, message)
         real(wp), intent(in) :: wanted(:), found(:)
         character(*), intent(in) :: message
         call assertEqual(size(wanted), size(found), message=message)
         if (size(wanted) == size(found)) call assertEqual(wanted, found, hair, message=message)
      end subroutine same
   end subroutine test_depths

   !> Depths of a printed table: all of 25, else at equal steps and with the last one.
   subroutine test_depths_in_a_table()
      type(sweep_type) :: sweep
      integer, parameter :: sizes(4) = [1, 25, 34, 101], wanted(4) = [1, 25, 17, 21]
      integer, allocatable :: rows(:)
      integer :: i
      do i = 1, size(sizes)
         sweep%depths = spread(1.0_wp, 1, sizes(i))
         rows = shown_depths(sweep)
         call assertEqual(sizes(i), rows(size(rows)), message='the last depth')
         call assertEqual(wanted(i), size(rows), message='rows')
         call assertTrue(all(rows(2:) - rows(:size(rows) - 1) == (sizes(i) + 24)/25), message='equal steps')
      end do
   end subroutine test_depths_in_a_table

   !> 2 x 2 x 3 x 4 points; every number comes back; depth counts fastest.
   subroutine test_numbers()
      type(model_type) :: model
      type(sweep_type) :: sweep
      type(point_type) :: point
      integer :: i
      call build(model, sweep)
      call assertEqual(48, point_count(sweep))
      do i = 1, point_count(sweep)
         call assertEqual(i, point_number(sweep, point_at(sweep, i)))
      end do
      point = point_at(sweep, 29)     ! 28 = 24 (second model) + 4 (second friction)
      call assertEqual([2, 1, 2, 1], [point%model, point%operation, point%friction, point%depth])
   end subroutine test_numbers

   !> Components move with the bit, the upper one is shortened, the hole stays: at every depth the lowest 40 m are collars,
   !> all above is pipe, and clearances and friction change at 200 m.
   subroutine test_string_at_depth()
      type(model_type) :: model
      type(sweep_type) :: sweep
      type(mesh_type) :: mesh
      real(wp) :: middle
      integer :: i, e
      logical :: collar, cased
      real(wp), parameter :: tiny_length = 1.0e-9_wp, collar_radius = 0.08_wp
      call build(model, sweep)
      do i = 1, size(sweep%depths)
         call point_case(sweep, point_type(1, 1, 2, i), model%cases(1))
         call assertFalse(model%cases(1)%friction_axial%present, message='friction of the hole')
         call new_mesh(model, model%cases(1), node_depths(model, model%cases(1), 7.0_wp), mesh)
         call assertEqual(sweep%depths(i), sum(mesh%length), tiny_length)
         call assertEqual(40.0_wp, sum(mesh%length, abs(mesh%radius - collar_radius) < tiny_length), tiny_length, &
                          message='length of the collars')
         do e = 1, mesh%elements
            middle = 0.5_wp*(mesh%md(e) + mesh%md(e + 1))
            collar = sweep%depths(i) - middle < 40.0_wp
            cased = middle < 200.0_wp
            call assertEqual(merge(0.08_wp, 0.0635_wp, collar), mesh%radius(e), tiny_length)
            call assertEqual(merge(0.11_wp, 0.105_wp, cased) - mesh%radius(e), mesh%clearance(e), tiny_length)
            call assertEqual(merge(0.2_wp, 0.3_wp, cased), mesh%friction_along(e), tiny_length)
         end do
      end do
      call point_case(sweep, point_type(1, 2, 3, 4), model%cases(1))
      call assertEqual(0.3_wp, model%cases(1)%friction_rotary%value)
      call assertEqual(operation_rotate_off_bottom, model%cases(1)%operation)
   end subroutine test_string_at_depth

   !> Parts are disjoint and together the whole, also where the number of pieces is no multiple of theirs.
   subroutine test_parts()
      integer :: times(10), part, parts, i
      do parts = 1, 12
         times = 0
         do part = 1, parts
            times = times + merge(1, 0, in_part([(i, i=1, 10)], part, parts))
         end do
         call assertEqual(spread(1, 1, 10), times)
      end do
   end subroutine test_parts

   subroutine test_result_text()
      type(sweep_result_type) :: point, back
      integer, parameter :: statuses(3) = [result_converged, result_not_converged, result_locked_up]
      logical :: sound
      integer :: i
      do i = 1, size(statuses)
         point%status = statuses(i)
         point%hookload = 1.0e6_wp/3.0_wp
         point%torque = -1.0e-300_wp/7.0_wp
         if (i == 2) point%message = 'no; reason = at all ;'
         call read_result(result_text(point), back, sound)
         call assertTrue(sound)
         call assertEqual(point%status, back%status)
         call assertEqual(point%hookload, back%hookload, message='to the last bit')
         call assertEqual(point%torque, back%torque, message='to the last bit')
         call assertTrue(allocated(back%message) .eqv. allocated(point%message))
         if (allocated(back%message)) call assertEqual(point%message, back%message)
      end do
      call read_result('', back, sound)
      call assertFalse(sound)
      call read_result('converged 1.0', back, sound)
      call assertFalse(sound)
      call read_result('solved'//repeat(' 1.0E+000', 10), back, sound)
      call assertFalse(sound)
   end subroutine test_result_text

   !> Settings for the tests of records.
   subroutine set_settings(settings)
      type(text_type), allocatable, intent(out) :: settings(:)
      call append_text(settings, 'a = 1')
      call append_text(settings, 'b, m = 2')
   end subroutine set_settings

   !> Lines of a record of part 2 of 3 of seven points that holds points 2 and 5.
   subroutine set_record(lines)
      type(text_type), allocatable, intent(out) :: lines(:)
      type(text_type), allocatable :: settings(:)
      type(sweep_result_type) :: point
      call set_settings(settings)
      allocate (lines, source=record_head(2, 3, 7, settings))
      point%status = result_converged
      point%hookload = 5.0_wp
      call append_text(lines, record_line(5, result_text(point)))
      point%hookload = 2.0_wp
      call append_text(lines, record_line(2, result_text(point)))
   end subroutine set_record

   subroutine test_record()
      type(text_type), allocatable :: lines(:), settings(:)
      type(record_type) :: record
      type(sweep_result_type) :: points(7)
      character(:), allocatable :: failure
      call set_record(lines)
      call set_settings(settings)
      call read_record(lines, record, failure)
      call assertEqual('', failure)
      call assertEqual([2, 3, 7], [record%part, record%parts, record%pieces])
      call assertEqual([5, 2], record%numbers)
      call add_record(record, 2, 3, settings, points, failure)
      call assertEqual('', failure)
      call assertEqual([.false., .true., .false., .false., .true., .false., .false.], is_solved(points))
      call assertEqual(5.0_wp, points(5)%hookload)
      ! a line that was cut short is left out, the same result once more does no harm
      call append_text(lines, lines(size(lines))%text)
      call append_text(lines, lines(size(lines))%text(:20))
      call read_record(lines, record, failure)
      call assertEqual('', failure)
      call assertEqual([5, 2], record%numbers)
   end subroutine test_record

   subroutine test_damaged()
      type(text_type), allocatable :: lines(:)
      call set_record(lines)
      call refuse(lines(:3), 'it is not a record: it has 3 lines')
      call refuse(lines(2:), "it is not a record: it begins 'part 2 of 3'")
      call refuse(lines(:5), 'its head is damaged or cut short')
      call refuse([lines(:1), lines(3:)], 'its head is damaged or cut short')
      call append_text(lines, lines(size(lines))%text)
      lines(size(lines) - 1)%text = '2 conv'
      call refuse(lines, 'line 8 is damaged')
      lines(size(lines) - 1)%text = '8'//lines(size(lines))%text(2:)
      call refuse(lines, 'line 8 is damaged')
      lines(size(lines) - 1)%text = '5'//lines(size(lines))%text(2:)
      call refuse(lines, 'line 8: piece 5 is there twice, with different results')
   contains
      subroutine refuse(text, wanted)
         type(text_type), intent(in) :: text(:)
         character(*), intent(in) :: wanted
         type(record_type) :: record
         character(:), allocatable :: failure
         call read_record(text, record, failure)
         call assertEqual(wanted, failure)
      end subroutine refuse
   end subroutine test_damaged

   !> Results that no run can have written are refused with their line: numbers that are none, are blank, or no string can have.
   subroutine test_impossible()
      character(*), parameter :: good = '   2.0000000000000000E+000'
      character(*), parameter :: bad(10) = [character(25) :: '                      NaN', '                 Infinity', &
         '                -Infinity', '', '  1.0000000000000000E+300', '  -1.0000000000000000E+16', '   2.0000000000000000D+000', &
         '   2.000000000000000E+0000', '                        2', '   2,0000000000000000E+000']
      type(text_type), allocatable :: lines(:)
      integer :: i
      call set_record(lines)
      do i = 1, size(bad)
         call refuse('2 converged'//bad(i)//good//' ;')
         call refuse('2 converged'//good//bad(i)//' ;')
      end do
      call refuse('2 '//good//good//' ;')
      call refuse('2 solved'//good//good//' ;')
      call refuse('2 locked_up                      NaN'//good//' ;')
      call refuse('2 not_converged'//good//'                 Infinity no rest ;')
      call refuse('2 converged'//good//good//'no blank before ;')
      call refuse('2 converged'//good//good//' a'//achar(27)//'[2J ;')
   contains
      !> In the last line, too, which is whole.
      subroutine refuse(line)
         character(*), intent(in) :: line
         type(text_type), allocatable :: settings(:)
         type(record_type) :: record
         type(sweep_result_type) :: points(7)
         character(:), allocatable :: failure
         lines(8)%text = line
         call set_settings(settings)
         call read_record(lines, record, failure)
         if (failure == '') call add_record(record, 2, 3, settings, points, failure)
         call assertEqual('line 8: the result of point 2 is damaged', failure, message=line)
         call assertFalse(any(is_solved(points)), message='nothing taken')
      end subroutine refuse
   end subroutine test_impossible

   !> A last line that is whole is judged like the others; a head cannot ask for endless memory.
   subroutine test_whole_last_line()
      type(text_type), allocatable :: lines(:)
      type(record_type) :: record
      character(:), allocatable :: failure
      call set_record(lines)
      call append_text(lines, '-1'//lines(8)%text(2:))
      call read_record(lines, record, failure)
      call assertEqual('line 9 is damaged', failure)
      lines(9)%text = '8'//lines(8)%text(2:)
      call read_record(lines, record, failure)
      call assertEqual('line 9 is damaged', failure)
      lines(3)%text = 'pieces 999999999'
      call read_record(lines, record, failure)
      call assertEqual('its head is damaged or cut short', failure)
   end subroutine test_whole_last_line

   !> A record of another part, another deck, or of points that are there already gives nothing.
   subroutine test_foreign()
      type(text_type), allocatable :: lines(:), settings(:)
      type(record_type) :: record
      type(sweep_result_type) :: points(7), fewer(6)
      character(:), allocatable :: failure
      call set_record(lines)
      call set_settings(settings)
      call read_record(lines, record, failure)
      call add_record(record, 3, 3, settings, points, failure)
      call assertEqual('it holds part 2 of 3 instead of part 3 of 3', failure)
      call add_record(record, 2, 4, settings, points, failure)
      call assertEqual('it holds part 2 of 3 instead of part 2 of 4', failure)
      call add_record(record, 2, 3, settings, fewer, failure)
      call assertEqual('it is of 7 points, the deck has 6', failure)
      settings(2)%text = 'b, m = 3'
      call add_record(record, 2, 3, settings, points, failure)
      call assertEqual('it is of another deck: b, m was 2 and is 3', failure)
      settings(2)%text = 'b, m = 2'
      record%numbers(2) = 3
      call add_record(record, 2, 3, settings, points, failure)
      call assertEqual('line 8: point 3 does not belong to part 2 of 3', failure)
      call assertFalse(any(is_solved(points)), message='nothing taken')
      record%numbers(2) = 2
      points(2)%status = result_converged
      call add_record(record, 2, 3, settings, points, failure)
      call assertEqual('line 8: point 2 is there already', failure)
      call assertFalse(is_solved(points(5)), message='nothing taken')
   end subroutine test_foreign

   !> Whatever of the model or the sweep changes is named, with both values.
   subroutine test_settings()
      type(model_type) :: model
      type(sweep_type) :: sweep
      type(text_type), allocatable :: then(:)
      call build(model, sweep)
      allocate (then, source=sweep_lines(model, sweep))
      call assertEqual('', difference_of(then, sweep_lines(model, sweep)))
      model%holes(2)%friction_axial = 0.31_wp
      call assertEqual('hole 2, friction_axial was 0.3 and is 0.31', difference_of(then, sweep_lines(model, sweep)))
      model%holes(2)%friction_axial = 0.3_wp
      model%holes(2)%friction_running_in = 0.4_wp
      call assertTrue(difference_of(then, sweep_lines(model, sweep)) /= '', message='friction_running_in')
      model%holes(2)%friction_running_in = missing
      model%strings(1)%components(1)%mass = 131.0_wp
      call assertEqual('component 1, mass was 130 and is 131', difference_of(then, sweep_lines(model, sweep)))
      model%strings(1)%components(1)%mass = 130.0_wp
      model%trajectory%inclination(2) = 0.2_wp
      call assertEqual('survey, inclination has changed', difference_of(then, sweep_lines(model, sweep)))
      model%trajectory%inclination(2) = 0.1_wp
      model%numerics%tolerance = 1.0e-8_wp
      call assertEqual('solver settings has changed', difference_of(then, sweep_lines(model, sweep)))
      model%numerics%tolerance = 1.0e-9_wp
      sweep%operations(2) = operation_trip_in
      call assertEqual('operations was trip_out rotate_off_bottom and is trip_out trip_in', &
                       difference_of(then, sweep_lines(model, sweep)))
      sweep%operations(2) = operation_rotate_off_bottom
      sweep%depths(2) = 101.0_wp
      call assertEqual('bit depths, m has changed', difference_of(then, sweep_lines(model, sweep)))
   end subroutine test_settings

   !> However many stations, no line of a record is longer than a file is read with, and each number still counts.
   subroutine test_long_settings()
      type(model_type) :: model
      type(sweep_type) :: sweep
      type(text_type), allocatable :: then(:)
      integer, parameter :: stations = 5003, longest = 100000
      integer :: i
      call build(model, sweep)
      deallocate (model%trajectory%md)
      allocate (model%trajectory%md(stations), source=[(real(i, wp), i=1, stations)])
      allocate (then, source=sweep_lines(model, sweep))
      call assertTrue(all([(len(then(i)%text), i=1, size(then))] < longest))
      model%trajectory%md(stations) = 7.0_wp
      call assertEqual('survey, md, from 5001 has changed', difference_of(then, sweep_lines(model, sweep)))
   end subroutine test_long_settings

   !> Hook loads of 10, 8, 4 at 0.1, 0.2, 0.3: 7 lies a quarter of the way from 0.2 to 0.3, in whatever order.
   subroutine test_fitting()
      type(optional_real) :: frictions(3), none(1), fits
      real(wp), parameter :: hair = 1.0e-12_wp
      frictions = given([0.3_wp, 0.1_wp, 0.2_wp])
      fits = fitting_friction(frictions, [4.0_wp, 10.0_wp, 8.0_wp], spread(.true., 1, 3), 7.0_wp)
      call assertTrue(fits%present)
      call assertEqual(0.225_wp, fits%value, hair)
      fits = fitting_friction(frictions, [4.0_wp, 10.0_wp, 8.0_wp], spread(.true., 1, 3), 11.0_wp)
      call assertFalse(fits%present, message='outside')
      fits = fitting_friction(frictions, [4.0_wp, 10.0_wp, 8.0_wp], [.false., .true., .true.], 7.0_wp)
      call assertFalse(fits%present, message='a neighbour without solution')
      fits = fitting_friction(none, [4.0_wp], [.true.], 4.0_wp)
      call assertFalse(fits%present, message='friction of the hole')
   end subroutine test_fitting

   !> Words in the heads of tables stand apart, and tables fit the page: each operation with one to five friction factors, single
   !> and in pairs.
   subroutine test_heads()
      real(wp), parameter :: factors(5) = [0.012_wp, 1.2_wp, 0.1234_wp, 0.11_wp, 0.5_wp]
      integer :: n, o
      do n = 1, size(factors)
         do o = 1, operation_count
            call judge_heads([o], factors(:n))
            call judge_heads([o], factors(:n), factors(:n))
         end do
      end do
      call judge_heads([(o, o=1, operation_count)], factors(:1))
      call judge_heads([(o, o=1, operation_count)], factors(:1), factors(:1))
   end subroutine test_heads

   !> Judges the first table of a sweep with as many columns as fit the page.
   subroutine judge_heads(operations, frictions, cased)
      integer, intent(in) :: operations(:)
      real(wp), intent(in) :: frictions(:)
      real(wp), intent(in), optional :: cased(:)
      type(sweep_type) :: sweep
      type(sweep_result_type), allocatable :: points(:)
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: names, factors, label
      integer :: i, o
      sweep%name = 's'
      sweep%models = [model_soft]
      sweep%operations = operations
      sweep%depths = [400.0_wp]
      sweep%frictions = given(frictions)
      if (present(cased)) sweep%frictions_cased = cased
      allocate (sweep%measured(0))
      allocate (points(point_count(sweep)))
      points%status = result_converged
      points%hookload = [(1.0e5_wp*i, i=1, size(points))]      ! unlike: a column for each friction factor
      allocate (lines, source=sweep_table(si_units(), sweep, points))
      names = 'Bit depth'
      factors = 'm'
      do o = 1, size(operations)
         label = trim(operation_label(operations(o)))
         if (size(frictions) == 1) label = label(:index(label//' ', ' ') - 1)
         names = names//' '//label
         do i = 1, size(frictions)
            factors = factors//' '//factor_text(sweep, i)
         end do
      end do
      call assertEqual(names, single_spaced(lines(4)%text))
      call assertEqual(factors, single_spaced(lines(5)%text))
      do i = 1, size(lines)
         if (index(lines(i)%text, 'Cannot be done') == 0) call assertTrue(len(lines(i)%text) <= page_width, message=lines(i)%text)
      end do
   end subroutine judge_heads

   !> Words of a text with one blank between.
   pure function single_spaced(text) result(words)
      character(*), intent(in) :: text
      character(:), allocatable :: words
      integer :: i
      words = ''
      do i = 1, len(text)
         if (text(i:i) == ' ') cycle
         if (i > 1) then
            if (text(i - 1:i - 1) == ' ' .and. words /= '') words = words//' '
         end if
         words = words//text(i:i)
      end do
   end function single_spaced
end module dg_test_sweep

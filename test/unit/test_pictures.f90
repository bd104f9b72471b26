!> Scripts for gnuplot and pieces of the report page: what a user's text must not break, and axes that can be read.
module dg_test_pictures
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, new_along_string
   use dg_assembly_picture, only: assembly_chart
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_chart, only: add_panel, chart_type, fit_range, new_chart
   use dg_column, only: add, quantity_force, quantity_length, quantity_text, row_type
   use dg_component, only: component_type
   use dg_forces_picture, only: forces_chart
   use dg_gnuplot_script, only: chart_script, spelled
   use dg_hookload_picture, only: hookload_chart
   use dg_html_text, only: append_inline_svg, append_table, css_string
   use dg_line_list, only: line_list_type
   use dg_job, only: job_type, model_mcge, model_soft
   use dg_markup, only: html_safe
   use dg_load_case, only: operation_rotary_drilling, operation_trip_in, operation_trip_out
   use dg_missing, only: given, is_missing, missing, optional_real
   use dg_model, only: model_type
   use dg_path_picture, only: path_chart
   use dg_picture_data, only: picked_rows, picture_data_type
   use dg_rig, only: rig_type
   use dg_strength_picture, only: strength_chart
   use dg_study_comparison, only: error_hookload, study_record_type
   use dg_study_picture, only: study_chart
   use dg_study_variant, only: variant_type
   use dg_sweep, only: sweep_type
   use dg_sweep_picture, only: sweep_chart
   use dg_sweep_result, only: sweep_result_type
   use dg_test_report_sample, only: findings_with, sample_job, sample_model, sample_results
   use dg_text, only: append_text, text_type, to_text
   use dg_units, only: field_units, unit_system_type
   implicit none
   private
   public :: pictures_suite

contains

   function pictures_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('pictures')
      call suite%addTest(TestMethod('quotes', test_quotes))
      call suite%addTest(TestMethod('round_steps', test_round_steps))
      call suite%addTest(TestMethod('html_text', test_html_text))
      call suite%addTest(TestMethod('html_table', test_html_table))
      call suite%addTest(TestMethod('picked_rows', test_picked_rows))
      call suite%addTest(TestMethod('pictures_keep_apart', test_inline))
      call suite%addTest(TestMethod('hook_loads', test_hook_loads))
      call suite%addTest(TestMethod('case_scripts', test_case_scripts))
      call suite%addTest(TestMethod('sweep', test_sweep))
      call suite%addTest(TestMethod('study', test_study))
   end function pictures_suite

   subroutine test_quotes()
      call assertEqual("'a `b` @c \'", spelled('a `b` @c \'))
      call assertEqual("'it'.""\047"".'s a `b`'", spelled("it's a `b`"))
      call assertEqual("'driller'.""\047"".'s 12-1/4'", spelled("driller's 12-1/4"))
      call assertEqual("""\047"".""\047"".'1'", spelled("''1"), message='no digit follows a number')
      call assertEqual("'a'.""\047""", spelled("a'"))
      call assertEqual("''", spelled(''))
   end subroutine test_quotes

   !> Steps are 1, 2 or 5 times a power of ten, and no more of them than their labels have room for.
   subroutine test_round_steps()
      call assertEqual('set xrange [0:830]; set xtics 200', range_of(0.0_wp, 830.0_wp))
      call assertEqual('set xrange [0:0.09]; set xtics 0.02', range_of(0.0_wp, 0.09_wp))
      call assertEqual('set xrange [-300:450]; set xtics 200', range_of(-300.0_wp, 450.0_wp))
      call assertEqual('set xrange [0:5.5]; set xtics 2', range_of(0.0_wp, 5.5_wp))
      call assertEqual('set xrange [0:36]; set xtics 10', range_of(0.0_wp, 36.0_wp), message='7.2: the next power of ten')
      call assertEqual('set xrange [-1:1]; set xtics 1', range_of(0.0_wp, 0.0_wp), message='nothing to show')
      call assertEqual('set xrange [0:0.0125]; set xtics 0.005', range_of(0.0_wp, 0.0125_wp), message='long labels')
   end subroutine test_round_steps

   function range_of(low, high) result(line)
      real(wp), intent(in) :: low, high
      character(:), allocatable :: line
      type(chart_type) :: chart
      chart = new_chart('x', '', field_units(), 500, [0.8_wp, 0.9_wp])
      call add_panel(chart, [0.1_wp, 0.1_wp + 240.0_wp/chart%width, 0.1_wp, 0.8_wp], '')
      call fit_range(chart, [low, high])
      associate (axis => chart%panels(1)%x)
         line = 'set xrange ['//to_text(axis%ends(1), 8)//':'//to_text(axis%ends(2), 8)//']; set xtics '//axis%tics
      end associate
   end function range_of

   subroutine test_html_text()
      call assertEqual('a&lt;b&gt; &amp; &quot;c&quot;', html_safe('a<b> & "c"'))
      call assertEqual('x y', html_safe('x'//achar(9)//'y'))
      ! u umlaut in UTF-8 stays, the same in Latin-1 is not UTF-8, nor is a cut letter or a stray second byte
      call assertEqual(char(195)//char(188), html_safe(char(195)//char(188)))
      call assertEqual('?z', html_safe(char(252)//'z'))
      call assertEqual('?', html_safe(char(195)))
      call assertEqual('??', html_safe(char(188)//char(188)))
      call assertEqual('"a \000022 \00005C \00003C  b"', css_string('a "\< b'))
      call assertEqual('"'//char(195)//char(188)//'"', css_string(char(195)//char(188)))
   end subroutine test_html_text

   !> Columns without any value are left out; what is there is in the deck's units.
   subroutine test_html_table()
      type(line_list_type) :: page
      type(row_type) :: row
      type(job_type) :: job
      job = sample_job()
      call add(row, 'case', quantity_text, 'its name', 'a<b')
      call add(row, 'stretch', quantity_length, 'of the string', 1.25_wp)
      call add(row, 'rig_limit', quantity_force, 'as in the deck', missing)
      call append_table(page, [character(12) :: 'case', 'rig_limit', 'stretch'], job%units, [row], [.true.])
      call assertEqual(3, page%count)
      call assertTrue(index(page%lines(1)%text, '>case<br>') > 0, message=page%lines(1)%text)
      call assertTrue(index(page%lines(1)%text, '>stretch<br><small>m</small>') > 0, message=page%lines(1)%text)
      call assertFalse(index(page%lines(1)%text, 'rig') > 0, message=page%lines(1)%text)
      call assertEqual('<tr class="bad"><td class="text">a&lt;b !</td><td>1.25</td></tr>', page%lines(2)%text)
   end subroutine test_html_table

   !> Of many rows of a file some, evenly apart, with their places.
   subroutine test_picked_rows()
      type(picture_data_type) :: data
      integer, allocatable :: rows(:)
      integer :: i
      call picked_rows('a.csv', [(mod(i, 2) == 0, i=1, 10)], data, rows)
      call assertEqual([2, 4, 6, 8, 10], rows)
      call assertEqual(1, data%every)
      call picked_rows('a.csv', [(.true., i=1, 401)], data, rows)
      call assertEqual(3, data%every)
      call assertEqual([1, 4, 400], rows([1, 2, size(rows)]))
      call assertEqual(size(rows), size(data%rows))
   end subroutine test_picked_rows

   !> Two pictures in one page must not share the names of their marks.
   subroutine test_inline()
      type(line_list_type) :: page
      type(text_type), allocatable :: svg(:)
      character(:), allocatable :: text
      integer :: i
      allocate (svg(0))
      call append_text(svg, '<?xml version="1.0"?>')
      call append_text(svg, '<svg')
      call append_text(svg, '<title>forces</title>')
      call append_text(svg, '<g fill="none">')
      call append_text(svg, '</g>')
      call append_text(svg, '<g id="a">')
      call append_text(svg, '<path/>')
      call append_text(svg, '</g>')
      call append_text(svg, "<use xlink:href='#gpPt5' id='gpPt6'/>")
      call append_inline_svg(page, svg, 'p3')
      text = ''
      do i = 1, page%count
         text = text//page%lines(i)%text//'|'
      end do
      call assertEqual('<svg|<title>forces</title>|<g id="a">|<path/>|</g>|'// &
                       "<use xlink:href='#p3gpPt5' id='p3gpPt6'/>|", text)
   end subroutine test_inline

   !> A mark a case in the deck's units; a case that did not converge leaves none. A no of some models names them.
   subroutine test_hook_loads()
      type(chart_type) :: chart
      type(job_type) :: job
      type(text_type), allocatable :: lines(:)
      type(case_result_type), allocatable :: results(:)
      type(model_type) :: model
      allocate (results, source=sample_results())
      chart = hookload_chart(findings_with(sample_job(), sample_model(), results, [.true., .false., .true., .false.]))
      call chart_script(chart, lines)
      call assertTrue(has_text(lines, "'i_down !' 2"), message='cannot be done')
      call assertTrue(has_text(lines, "'i_up' 1"), message='can be done')
      associate (panels => chart%panels)
         call assertEqual([733.4_wp, 745.0_wp], [panels(1)%curves(1)%points(1, 1), panels(1)%curves(2)%points(1, 1)], 1.0e-9_wp)
         call assertEqual(1.557047_wp, panels(2)%curves(1)%points(1, 1), 1.0e-6_wp, message='error')
         call assertEqual([568.2_wp, 13.69_wp], [panels(1)%curves(1)%points(1, 3), panels(3)%curves(1)%points(1, 3)], 1.0e-9_wp, &
                          message='torque of the one that rotates')
         call assertTrue(is_missing(panels(3)%curves(1)%points(1, 1)), message='no torque going up')
         call assertTrue(is_missing(panels(1)%curves(1)%points(1, 4)), message='not converged')
         call assertEqual(524.3_wp, panels(1)%curves(3)%points(1, 4), 1.0e-9_wp, message='reference')
         call assertTrue(all(is_missing(panels(1)%x%ends)))
      end associate
      job = sample_job()
      job%models = [model_mcge, model_soft]
      results = [results, results(:2)]
      results(5:)%model = model_soft
      chart = hookload_chart(findings_with(job, sample_model(), results, [.true., .false., .true., .true., .false., .false.]))
      call chart_script(chart, lines)
      call assertTrue(has_text(lines, "'i_up ! soft' 1"), message='one model says no')
      call assertTrue(has_text(lines, "'i_down !' 2"), message='all models say no')
      call assertTrue(has_text(lines, 'no solution (with the name of a model: by that model alone)'), message='what the name means')
      model = sample_model()
      model%cases%measured_hookload = optional_real()
      model%cases%reference_hookload = optional_real()
      chart = hookload_chart(findings_with(sample_job(), model, results(:1), [.true.]))
      call assertEqual([0.99_wp, 1.01_wp]*733.4_wp, chart%panels(1)%x%ends, 1.0e-9_wp, message='close together')
   end subroutine test_hook_loads

   !> The scripts draw what the case has and name units.
   subroutine test_case_scripts()
      type(along_string_type) :: along
      type(text_type), allocatable :: lines(:)
      type(case_result_type), allocatable :: results(:)
      type(model_type) :: model
      model = model_with_string()
      allocate (results, source=sample_results())
      along = new_along_string(2)
      along%pipe_joint = 9.5_wp
      call chart_script(forces_chart(sample_job(), model, results(:1), [along], ' rigid'), lines)
      call assertTrue(has_text(lines, 'up at 2075 m; no solution: rigid'))
      call assertTrue(has_line(lines, "set output 'forces_i_up.svg'.unfinished"))
      call assertTrue(has_text(lines, "set xlabel 'effective axial force [kN]'"))
      call assertTrue(has_text(lines, "set xlabel 'bending moment [kN.m]'"), message='no torque going up')
      call assertTrue(has_text(lines, 'set yrange [2075:0]'), message='depth downwards')
      call assertTrue(has_text(lines, '$c1 with lines'))
      call assertTrue(has_text(lines, "set xlabel 'side force on 9.5 m [kN]'"), message='on the length of a joint')
      call assertTrue(has_text(lines, 'from graph 0, first 1000 to graph 1, first 1000 nohead'), message='the shoe')
      call assertTrue(has_text(lines, 'set label '//spelled("9-5/8 in 'casing'")//' at'), message='a text of the deck')
      call chart_script(strength_chart(sample_job(), model, results(:1), [new_along_string(2)]), lines)
      call assertTrue(has_text(lines, "set xlabel 'bending stress [MPa]'"))
      call assertFalse(has_text(lines, 'make-up torque'), message='no torque going up')
      call assertFalse(has_text(lines, 'safety factor'), message='no yield strength')
      results(1)%bit_side_force = 14.2e3_wp
      call chart_script(assembly_chart(sample_job(), model, results(1)), lines)
      call assertTrue(has_text(lines, 'model mcge; bit presses 14.2 kN'))
      call assertTrue(has_text(lines, "set label 'pipe' at first 20"), message='the part by name')
      call assertTrue(has_text(lines, 'set xrange [40:0]'), message='the bit at the right')
      call chart_script(path_chart(sample_job(), model, results(1)), lines)
      call assertTrue(has_text(lines, "set xlabel 'vertical section along azimuth 0 deg [m]'"))
      call assertTrue(has_text(lines, 'rigid contact'))
      call assertFalse(has_text(lines, 'casing (widths'), message='no hole section is cased')
      model%holes%cased = [.true., .false.]
      model%holes%diameter = [0.3_wp, 0.2_wp]
      call chart_script(path_chart(sample_job(), model, results(1)), lines)
      call assertTrue(has_text(lines, 'casing (widths'))
   end subroutine test_case_scripts

   !> The sample with pipe that has joints, in a cased hole.
   function model_with_string() result(model)
      type(model_type) :: model
      integer :: i
      model = sample_model()
      allocate (model%strings(1), model%holes(2))
      allocate (model%strings(1)%components(1))
      model%strings(1)%name = 'string'
      model%strings(1)%components(1) = component_type(name='pipe', kind='drillpipe', od=0.127_wp, id=0.1086_wp, &
                                                      joint_od=0.162_wp, joint_spacing=9.5_wp)
      do i = 1, size(model%cases)
         model%cases(i)%string = 'string'
      end do
      model%holes%md_bottom = [1000.0_wp, 2075.0_wp]
      model%holes(1)%name = "9-5/8 in 'casing'"
      model%holes(2)%name = 'open hole'
   end function model_with_string

   !> A curve an operation and friction factor, of the points of the model that converged.
   subroutine test_sweep()
      type(text_type), allocatable :: lines(:)
      type(chart_type) :: chart
      type(sweep_type) :: sweep
      type(model_type) :: model
      type(sweep_result_type) :: points(16)
      type(unit_system_type) :: units
      integer :: i
      units = field_units()
      model = sample_model()
      allocate (model%holes(1))
      sweep%name = 'broom'
      sweep%models = [model_mcge, model_soft]
      sweep%operations = [operation_trip_out, operation_rotary_drilling]
      sweep%frictions = given([0.1_wp, 0.25_wp])
      sweep%depths = [100.0_wp, 2000.0_wp]
      allocate (sweep%measured(1))
      sweep%measured(1)%operation = operation_trip_out
      sweep%measured(1)%hookload = given(200.0_wp*units%force)
      points%status = result_converged
      points%hookload = [(i*units%force, i=1, size(points))]
      points%torque = [(i*units%moment, i=1, size(points))]
      points(12)%status = result_locked_up
      chart = sweep_chart(units, sweep, 2, model, points)
      call chart_script(chart, lines)
      call assertEqual('sweep_broom_soft', chart%name)
      associate (curves => chart%panels(1)%curves)
         call assertEqual([9.0_wp, 10.0_wp], curves(1)%points(1, :), 1.0e-9_wp, message='after the eight of the other model')
         call assertEqual(11.0_wp, curves(3)%points(1, 1), 1.0e-9_wp, message='after two of the other factor')
         call assertTrue(is_missing(curves(3)%points(1, 2)), message='locked up')
         call assertEqual(0, size(curves(2)%points), message='can be done')
         call assertEqual([chart%panels(1)%x%ends(1), 2000.0_wp/units%length], curves(5)%points(:, 1), 1.0_wp, &
                          message='at the edge')
         call assertTrue(curves(5)%at_edge .and. size(curves(4)%points) == 0, message='no hook load')
         call assertEqual(200.0_wp, curves(10)%points(1, 1), 1.0e-9_wp, message='measured')
         call assertEqual(10, size(curves))
         ! operations, one of them measured, then frictions, then what cannot be done
         call assertEqual([1, 4], curves(1)%keys, message='entries of the legend')
         call assertEqual([1, 5, 6], curves(4)%keys, message='cannot be done')
         call assertEqual([1, 5, 7], curves(5)%keys, message='locked up')
         call assertEqual(1, size(curves(10)%keys), message='measured')
      end associate
      call assertEqual(2, size(chart%panels(2)%curves), message='no torque going up')
      call assertEqual(13.0_wp, chart%panels(2)%curves(1)%points(1, 1), 1.0e-9_wp)
      call assertTrue(has_text(lines, 'set yrange [6561.6798:0]'))
      call assertTrue(has_text(lines, "title 'friction 0.25'"))
      call assertFalse(has_text(lines, 'limit of the rig'))
      sweep%frictions = [optional_real()]
      call chart_script(sweep_chart(units, sweep, 1, model, points), lines)
      call assertTrue(has_text(lines, "title 'friction of &hole'"))
      ! sheaves that do not rub: one line at what the rig may carry; one of torque
      model%rig = rig_type(given=.true., block_weight=50.0_wp*units%force, max_hookload=given(400.0_wp*units%force), &
                           max_torque=given(30.0_wp*units%moment))
      call chart_script(sweep_chart(units, sweep, 1, model, points), lines)
      chart = sweep_chart(units, sweep, 1, model, points)
      do i = 1, 2
         associate (limit => chart%panels(i)%curves(size(chart%panels(i)%curves)))
            call assertEqual('limit of the rig', limit%name)
            call assertEqual([merge(400.0_wp, 30.0_wp, i == 1), 0.0_wp, merge(400.0_wp, 30.0_wp, i == 1), 2000.0_wp/units%length], &
                             [limit%points(:, 1), limit%points(:, 2)], 1.0e-9_wp, message='from top to bottom')
         end associate
      end do
      call assertTrue(has_text(lines, "set label 'limit of the rig, 400 klbf' at first 400, graph"), message='its name')
      ! what the rig shows when the string yields: the block's 50 klbf above hook load and overpull
      call assertFalse(has_text(lines, 'pipe yields'), message='no yield strength')
      points%overpull_margin = 5.0_wp*units%force
      chart = sweep_chart(units, sweep, 1, model, points)
      call chart_script(chart, lines)
      call assertTrue(has_text(lines, 'pipe yields at this hook load (up, '))
      associate (curves => chart%panels(1)%curves)
         call assertEqual(56.0_wp, curves(size(curves))%points(1, 1), 1.0e-9_wp)
         call assertTrue(curves(size(curves))%sets_axis, message='near the others')
      end associate
      ! neither a far limit nor much push sets the axis, which the limit of the rig ends
      points%overpull_margin = 5000.0_wp*units%force
      points(3)%hookload = -600.0_wp*units%force
      points(3)%limit = 1
      chart = sweep_chart(units, sweep, 1, model, points)
      call chart_script(chart, lines)
      call assertTrue(has_text(lines, 'pipe yields at a hook load of 5050 klbf (up, '), message='named')
      call assertTrue(all(abs(chart%panels(1)%x%ends) < 500.0_wp), message='the axis')
      call assertTrue(is_missing(chart%panels(1)%curves(3)%points(1, 1)), message='much push')
      ! sheaves that rub: the indicator shows less or more than the load as blocks move
      model%rig%lines = 8
      model%rig%sheave_efficiency = 0.98_wp
      sweep%operations = [operation_trip_out, operation_trip_in]
      chart = sweep_chart(units, sweep, 1, model, points)
      call chart_script(chart, lines)
      call assertFalse(has_text(lines, ' 400 klbf'))
      call assertTrue(has_text(lines, 'klbf, up'' at first 3'), message='less is shown going up')
      call assertTrue(has_text(lines, 'klbf, down'' at first 4'), message='more going down')
      call assertEqual(2, count([(index(chart%panels(1)%curves(i)%name, 'limit of the rig, ') == 1, &
                                  i=1, size(chart%panels(1)%curves))]))
   end subroutine test_sweep

   !> Errors of the models of the study in per cent, without torque where nothing turns.
   subroutine test_study()
      type(text_type), allocatable :: lines(:)
      type(chart_type) :: chart
      type(variant_type) :: variants(2)
      type(study_record_type) :: records(2)
      type(model_type) :: model
      model = sample_model()
      variants%model = model_soft
      records%status = result_converged
      records%seconds = [1.0_wp, 2.0_wp]
      records(:)%errors(error_hookload) = [0.02_wp, 0.0_wp]
      chart = study_chart(field_units(), model%cases(1), [model_soft], variants, records)
      call chart_script(chart, lines)
      call assertEqual([1.0_wp, 2.0_wp], chart%panels(1)%curves(1)%points(:, 1), 1.0e-9_wp, message='2 % in 1 s')
      call assertEqual(2, size(chart%panels(1)%curves(1)%points), message='the finest has no mark')
      call assertTrue(index(chart%title, ': error against the finest settings, and solution time') > 0, message=chart%title)
      call assertTrue(has_text(lines, "title 'soft'"))
      call assertFalse(has_text(lines, "title 'mcge'"))
      call assertFalse(has_text(lines, 'error of torque'))
      call chart_script(study_chart(field_units(), model%cases(3), [model_soft], variants, records), lines)
      call assertTrue(has_text(lines, 'error of torque'))
      call assertTrue(has_text(lines, 'set xrange [0.1:1]; set yrange [0.1:1]'), message='a panel without marks')
   end subroutine test_study

   pure function has_line(lines, line) result(has)
      type(text_type), intent(in) :: lines(:)
      character(*), intent(in) :: line
      logical :: has
      integer :: i
      has = .false.
      do i = 1, size(lines)
         if (lines(i)%text == line) has = .true.
      end do
   end function has_line

   pure function has_text(lines, text) result(has)
      type(text_type), intent(in) :: lines(:)
      character(*), intent(in) :: text
      logical :: has
      integer :: i
      has = .false.
      do i = 1, size(lines)
         if (index(lines(i)%text, text) > 0) has = .true.
      end do
   end function has_text
end module dg_test_pictures

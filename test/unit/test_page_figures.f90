!> Pictures of a run as data of the page: blocks, looks, points, and names that would end a script.
module dg_test_page_figures
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_chart, only: add_curve, add_depth_panel, add_points, add_rows, chart_type, new_chart, set_depth
   use dg_curve_look, only: look_part, marked_line_style
   use dg_line_list, only: line_list_type
   use dg_missing, only: missing
   use dg_page_code, only: coded_bits, coded_curve, coded_depths, scale_type, scale_within
   use dg_page_figures, only: append_figures, is_live
   use dg_picture_list, only: picture_list_type
   use dg_quantity, only: quantity_force, quantity_none
   use dg_text, only: text_type
   use dg_units, only: field_units, si_units
   use dg_hole_section, only: hole_section_type
   implicit none
   private
   public :: page_figures_suite

contains

   function page_figures_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('page_figures')
      call suite%addTest(TestMethod('looks', test_looks))
      call suite%addTest(TestMethod('blocks', test_blocks))
      call suite%addTest(TestMethod('code', test_code))
      call suite%addTest(TestMethod('depths', test_depths))
   end function page_figures_suite

   !> Find the text that follows a word of a look; a word within another does not count.
   subroutine test_looks()
      character(:), allocatable :: look
      look = marked_line_style(2, 80, 1.6_wp, '(8,4)')
      call assertEqual('linespoints', look_part(look, 'with'))
      call assertEqual('(8,4)', look_part(look, 'dt'))
      call assertEqual('#D55E00', look_part(look, 'rgb'))
      call assertEqual('5', look_part(look, 'pt'))
      call assertEqual('', look_part(look, 'points'))
      call assertEqual('', look_part('', 'pt'))
   end subroutine test_looks

   !> Digits worked out by hand: a step back; levels of a scale, zero and the largest value among them; values too far apart for a
   !> scale; three levels in two digits; a bit for each depth.
   subroutine test_code()
      real(wp), parameter :: near(3) = [-1.0_wp, 0.0_wp, 1.0_wp], far(2) = [2.0e6_wp, 0.001_wp]
      type(scale_type) :: scale
      call assertEqual('"~7#RgA"', coded_depths([1.0_wp, 2.0_wp, 1.5_wp]))
      scale = scale_within(near, 2.0e-4_wp)
      call assertEqual('[-2501,0.0004,0,"#$?l[W",5004]', coded_curve(scale, '0', near))
      call assertEqual(0.0_wp, read_back(0.0_wp))
      scale = scale_within(far, 1.0e-3_wp)
      call assertEqual('[0,1,0,"jc7R^C-I~~~~"]', coded_curve(scale, '0', [far, missing]))
      call assertEqual('[0,1,0,"''xyL",20]', coded_curve(scale_type(levels=20), '0', [1.0_wp, 2.0_wp, 3.0_wp, missing]))
      call assertEqual('"ED"', coded_bits([.true., .false., .false., .false., .false., .true., .true.]))
      scale = scale_within([-0.3_wp, 0.7123_wp, 0.2_wp], 0.1_wp)
      call assertEqual(0.7123_wp, read_back(0.7123_wp), 1.0e-12_wp, message='the largest value')
   contains
      !> A value on the scale, as curves.js reads it.
      pure real(wp) function read_back(value)
         real(wp), intent(in) :: value
         read_back = (scale%first + nint(value/scale%step - scale%first))*scale%step
      end function read_back
   end subroutine test_code

   !> An axis of depth begins at a round depth above the curves, at 0 where they begin near it; names of hole sections above it are
   !> left out.
   subroutine test_depths()
      type(picture_list_type) :: list
      type(line_list_type) :: lines
      type(chart_type) :: chart
      type(hole_section_type) :: holes(3)
      real(wp), parameter :: place(4) = [0.2_wp, 0.9_wp, 0.1_wp, 0.9_wp]
      integer :: i
      do i = 1, 3
         holes(i)%name = 'hole'
         holes(i)%md_bottom = 2000.0_wp*i
      end do
      call begin([4200.0_wp, 6200.0_wp], 4000.0_wp)
      call assertEqual(0, size(chart%panels(1)%notes), message='above the axis')
      call append_figures(lines, list, 3.0e-4_wp)
      call assertTrue(index(lines%lines(3)%text, '"over":"bit depth","begin":4000,"end":6200') > 0, message=lines%lines(3)%text)
      call begin([300.0_wp, 2400.0_wp], 200.0_wp)
      call assertEqual(1, size(chart%panels(1)%notes))
      call begin([100.0_wp, 6200.0_wp], 0.0_wp)
      call begin([6200.0_wp, 6200.0_wp], 6000.0_wp)
   contains
      subroutine begin(depths, first)
         real(wp), intent(in) :: depths(2), first      !< of curves, of the axis
         chart = new_chart('sweep', 'Sweep', si_units(), 400, [0.8_wp, 0.9_wp])
         call set_depth(chart, 'bit depth', depths, holes, place, .true.)
         call add_depth_panel(chart, place, 'hook load', quantity_force)
         call assertEqual(first, chart%panels(1)%y%ends(2))
         if (allocated(list%pictures)) deallocate (list%pictures)
         allocate (list%pictures(1))
         list%pictures(1)%chart = chart
      end subroutine begin
   end subroutine test_depths

   !> Rows of their own begin a block; a value that lacks has the greatest level; a black curve has the ink of the page; a curve has
   !> a name and an entry of the legend.
   subroutine test_blocks()
      type(picture_list_type) :: list
      type(line_list_type) :: lines
      type(chart_type) :: chart
      type(text_type) :: names(2)
      character(:), allocatable :: text
      real(wp), parameter :: place(4) = [0.2_wp, 0.9_wp, 0.1_wp, 0.9_wp]
      integer :: i
      names(1)%text = 'first'
      names(2)%text = '</script>'
      chart = new_chart('fit', 'Fit', field_units(), 400, [0.8_wp, 0.9_wp])
      call add_rows(chart, place, 'friction', quantity_none, names, 0.2_wp)
      call add_curve(chart, [0.25_wp, missing], [1.0_wp, 2.0_wp], "with points pt 6 lc rgb '#000000'", 'before')
      call add_points(chart, reshape([0.3_wp, 2.0_wp, 0.2_wp, 0.4_wp], [4, 1]), "with xerrorbars pt 0 lc rgb '#0072B2'", &
                      name='interval')
      call add_rows(chart, place, 'offset', quantity_force, names, 0.2_wp)
      call add_curve(chart, [4.0_wp, 5.0_wp], [1.0_wp, 2.0_wp], "with lines dt (8,4) lc rgb '#0072B2'", '', [1])
      allocate (list%pictures(3))
      list%pictures(1)%chart = chart
      list%pictures(2)%chart = chart
      list%pictures(2)%case_index = 1
      list%pictures(3)%chart = chart
      list%pictures(3)%chart%panels(2)%logarithmic = .true.
      call assertTrue(is_live(list%pictures(1)))
      call assertFalse(is_live(list%pictures(2)), message='of a load case')
      call assertFalse(is_live(list%pictures(3)), message='logarithms')
      call append_figures(lines, list, 3.0e-4_wp)
      text = ''
      do i = 1, lines%count
         text = text//lines%lines(i)%text
      end do
      call assertEqual('"figures":[{"title":"Fit","keys":['// &
         '{"text":"before","look":{"stroke":"currentColor"},"mark":6,"marks":true},'// &
         '{"text":"interval","look":{"stroke":"#0072B2"},"mark":0,"marks":true}],"blocks":['// &
         '{"rows":["first","\u003C/script\u003E"],"panels":[{"label":"friction","quantity":"q0","lines":['// &
         '{"name":"before","keys":[0],"look":{"stroke":"currentColor"},"mark":6,"marks":true,"points":[1,0.25,"~7#","#~"]},'// &
         '{"name":"interval","keys":[1],"look":{"stroke":"#0072B2"},"mark":0,"marks":true,"points":[1,0.3,"R}L","#"],'// &
         '"low":[1,0.2,"R}L","#"],"high":[1,0.4,"R}L","#"]}]}]},{"rows":["first","\u003C/script\u003E"],"panels":['// &
         '{"label":"offset","quantity":"force","lines":[{"name":"before","keys":[0],'// &
         '"look":{"stroke":"#0072B2","stroke-dasharray":"8 4"},"points":[66667,5.999952e-5,"~7#","##''800|",16671]}]}]}]}]', &
                       text)
   end subroutine test_blocks
end module dg_test_page_figures

!> Pictures of whole runs: names that would be commands to gnuplot, and gnuplots that do not do what they should.
module dg_test_picture_runs
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_program_run, only: deck_path, good_deck, replaced, results_path, run_deck_text, run_program, run_type, scratch
   use dg_text, only: text_type
   implicit none
   private
   public :: picture_runs_suite

   character(*), parameter :: newline = achar(10)

contains

   function picture_runs_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('picture_runs')
      call suite%addTest(TestMethod('names_are_no_commands', test_names))
      call suite%addTest(TestMethod('names_of_files', test_file_names))
      call suite%addTest(TestMethod('gnuplot_fails_at_one', test_fails_at_one))
      call suite%addTest(TestMethod('a_single_depth_is_no_curve', test_single_depth))
   end function picture_runs_suite

   !> gnuplot draws names as they are, whatever they would be to it.
   subroutine test_names()
      character(*), parameter :: names(8) = [character(44) :: "'.system(""touch made"").'", "'; system 'touch made'; x='", &
                                             '`touch made`', "Bob's fit", 'a,b', 'x"y', 'a\b', 'x@ {/Symbol a}^2_%s\']
      type(run_type) :: run
      character(:), allocatable :: picture
      integer :: i
      logical :: is
      do i = 1, size(names)
         run = run_deck_text(deck_with([names(i)]))
         call assertEqual(0, run%status, message=trim(names(i))//': '//run%diagnostics)
         picture = content('pictures/calibration_1_soft.svg')
         call assertTrue(index(picture, '<text>Calibration '//trim(names(i))//', model soft</text>') > 0, message=trim(names(i)))
         call assertTrue(index(picture, '<text>'//trim(names(i))//'</text>') > 0, message='the hole section '//trim(names(i)))
         inquire (file=results_path//'/pictures/made', exist=is)
         call assertFalse(is, message=trim(names(i)))
      end do
   end subroutine test_names

   !> Pictures of calibrations whose names make the same file are two.
   subroutine test_file_names()
      type(run_type) :: run
      run = run_deck_text(deck_with([character(4) :: '2', 'a/b']))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(content('pictures/calibration_2_soft.svg'), 'Calibration 2, ') > 0)
      call assertTrue(index(content('pictures/calibration_2_soft_2.svg'), 'Calibration a/b, ') > 0)
   end subroutine test_file_names

   !> One picture lacks, the others are there and on the page.
   subroutine test_fails_at_one()
      type(run_type) :: run
      type(text_type) :: script(4)
      type(error_type), allocatable :: error
      run = run_deck_text(replaced(good_deck(), ', plots = .false.', ''), '--check')
      script(1)%text = '#!/bin/sh'
      script(2)%text = 'for a; do case $a in path_u.gp) echo "<svg>" > path_u.svg.unfinished; exit 1 ;; esac; done'
      script(3)%text = 'for a; do case $a in *.gp) n=${a%.gp}'
      script(4)%text = 'echo "<svg></svg>" > $n.svg.unfinished ;; esac; done'
      call write_text_file(scratch//'/gnuplot', script, error)
      call execute_command_line('chmod +x '//scratch//'/gnuplot')
      run = run_program(deck_path//' --output '//results_path, environment='PATH="'//scratch//':$PATH"')
      call assertEqual(1, run%status)
      call assertTrue(index(run%diagnostics, 'gnuplot failed: 6 of 7 pictures') > 0 .and. &
                      index(run%diagnostics, ', path_u is not') > 0, message=run%diagnostics)
      call assertEqual('', content('pictures/path_u.svg'))
      call assertEqual('<svg></svg>'//newline, content('pictures/forces_u.svg'))
      call assertTrue(index(content('report.html'), '1 of 7 pictures are not drawn') > 0)
   end subroutine test_fails_at_one

   !> A sweep and samples at a single depth have no broomstick: a curve of one point cannot be seen. With two depths they have.
   subroutine test_single_depth()
      character(*), parameter :: broomsticks(2) = [character(32) :: 'pictures/sweep_b_soft.svg', 'pictures/uncertainty_m_soft.svg']
      type(run_type) :: run
      character(:), allocatable :: text
      integer :: i
      text = replaced(good_deck(), ', plots = .false.', '')//"&sweep name = 'b', bit_depth_from = 500, bit_depth_step = 400 /"// &
         newline//"&uncertainty name = 'm', bit_depth_from = 500, bit_depth_step = 400, samples = 99, friction_deviation = 0.1 /"
      run = run_deck_text(text)
      call assertEqual(0, run%status, message=run%diagnostics)
      do i = 1, size(broomsticks)
         call assertTrue(index(content(trim(broomsticks(i))), '</svg>') > 0, message=trim(broomsticks(i)))
      end do
      run = run_deck_text(replaced(replaced(text, 'from = 500', 'from = 900'), 'from = 500', 'from = 900'))
      call assertEqual(0, run%status, message=run%diagnostics)
      do i = 1, size(broomsticks)
         call assertEqual('', content(trim(broomsticks(i))), message=trim(broomsticks(i)))
      end do
      call assertTrue(index(content('pictures/tornado_m_soft.svg'), '</svg>') > 0, message='tornado')
   end subroutine test_single_depth

   !> The good deck with calibrations of these names, the first of which a hole section has, too.
   function deck_with(names) result(text)
      character(*), intent(in) :: names(:)
      character(:), allocatable :: text
      integer :: i
      text = replaced(good_deck(), ', plots = .false.', '')
      text = replaced(text, '&hole md_top = 400.0', '&hole name = '//in_quotes(trim(names(1)))//', md_top = 400.0')
      text = replaced(text, "operation = 'up'", "operation = 'up', measured_hookload = 300.0")
      text = replaced(text, "operation = 'sliding'", "operation = 'sliding', measured_hookload = 200.0")
      do i = 1, size(names)
         text = text//"&calibrate separate = 'holes', name = "//in_quotes(trim(names(i)))//' /'//newline
      end do
   end function deck_with

   pure function in_quotes(text) result(literal)
      character(*), intent(in) :: text
      character(:), allocatable :: literal
      integer :: i
      literal = "'"
      do i = 1, len(text)
         if (text(i:i) == "'") literal = literal//"'"
         literal = literal//text(i:i)
      end do
      literal = literal//"'"
   end function in_quotes

   !> A file of results; '' where there is none.
   function content(name) result(text)
      character(*), intent(in) :: name
      character(:), allocatable :: text
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      integer :: i
      call read_lines(results_path//'/'//name, lines, failure)
      text = ''
      do i = 1, size(lines)
         text = text//lines(i)%text//newline
      end do
   end function content
end module dg_test_picture_runs

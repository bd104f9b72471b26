!> Bounds of the work of a deck: what is refused at once, and what is told before work begins.
module dg_test_bounds
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_program_run, only: deck_path, good_deck, replaced, run_deck_text, run_interrupted, run_type, scratch
   use dg_text, only: to_text
   implicit none
   private
   public :: bounds_suite

   character(*), parameter :: newline = achar(10)
   !> The line after the good deck.
   character(*), parameter :: place = deck_path//':21: group &'

contains

   function bounds_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('bounds')
      call suite%addTest(TestMethod('too_many_groups', test_groups))
      call suite%addTest(TestMethod('calibrations', test_calibrations))
      call suite%addTest(TestMethod('many_parts', test_parts))
      call suite%addTest(TestMethod('work_is_told', test_told))
   end function bounds_suite

   !> One group more than a deck may have.
   subroutine test_groups()
      call refuse(repeat('&fluid density = 1200.0 / ', 1000), 'fluid: a deck has at most 1000 of them')
   end subroutine test_groups

   !> A fit with an unknown for each of too many depths; a stuck point in too many cases.
   subroutine test_calibrations()
      call refuse("&calibrate separate = 'depths' /"//measured_cases(1001), &
                  'calibrate: 1001 unknowns; a calibration has at most 1000')
      call refuse("&calibrate parameter = 'sticking', sticking_depth = 5, model = 'soft', 'rigid', 'mixed', 'mcge' /"// &
                  measured_cases(2501), 'calibrate: 10004 pairs of load case and model; a group has at most 10000')
   end subroutine test_calibrations

   !> Names are found, and sections ordered, among many: a centralizer on each of 300 components, 300 sections from below.
   subroutine test_parts()
      integer, parameter :: many = 300     ! of 2 m
      type(run_type) :: run
      character(:), allocatable :: parts, holes
      integer :: i
      parts = ''
      holes = ''
      do i = 1, many
         parts = parts//"&component name = 'c"//to_text(i)//"', length = 2, od = 120, id = 70 /"// &
                 "&centralizer component = 'c"//to_text(many + 1 - i)//"', kind = 'rigid', od = 200, spacing = 2 /"//newline
         holes = holes//'&hole md_top = '//to_text(400 + many - i)//', md_bottom = '//to_text(401 + many - i)// &
                 ', diameter = '//to_text(215 + modulo(i, 2))//', friction = 0.3 /'//newline
      end do
      run = run_deck_text(replaced(good_deck(), '&component od', parts//'&component od'), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'c1 (') > 0 .and. index(run%output, 'c300 (') > 0, message='all components')
      call assertEqual(many, times(run%output, 'rigid centralizers'), message=run%output(:min(len(run%output), 3000)))
      run = run_deck_text(replaced(good_deck(), '&hole md_top = 400.0', holes//'&hole md_top = 700.0'), '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(many + 2, times(run%output, 'hole        '), message='sections')
      call assertTrue(index(run%output, '400 to 401 ') < index(run%output, '699 to 700 '), message='from the top down')
   end subroutine test_parts

   !> Each kind of repeated work tells how many solutions it takes, and nothing with --quiet.
   subroutine test_told()
      type(run_type) :: run
      character(:), allocatable :: deck
      deck = good_deck()//"&sweep name = 'b', frictions = 0.2, 0.3, bit_depth_step = 100 /"//newline// &
             "&uncertainty name = 'm', samples = 100, bit_depth_from = 900, friction_deviation = 0.05 /"//newline// &
             "&study cases = 'u', element_lengths = 5, 10 /"//newline// &
             "&load_case name = 'd', operation = 'up', bit_depth = 900, measured_hookload = 300 /"//newline// &
             "&calibrate name = 'c', separate = 'none', cases = 'd' /"//newline// &
             "&calibrate name = 'k', parameter = 'sticking', sticking_depth = 600, cases = 'd' /"//newline
      run = run_deck_text(deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      call told("sweep 'b'")
      call told("uncertainty 'm'")
      call told('study')
      call told("calibration 'c', model soft")
      call told("calibration 'k'")
      run = run_deck_text(deck, '--quiet')
      call assertEqual('', run%work)
      run = run_deck_text(good_deck()//"&uncertainty name = 'l', samples = 100000, friction_deviation = 0.05,"// &
                          " bit_depth_from = 500, bit_depth_step = 100 /"//newline, '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      ! long work, which is ended when its time is told
      run = run_interrupted('', "grep -q ' left$' "//scratch//'/diagnostics.txt', 'TERM')
      call assertTrue(index(run%work, ' left'//newline) > 0, message='expected time; got: '//run%work//run%diagnostics)
   contains
      subroutine told(what)
         character(*), intent(in) :: what
         integer :: at
         at = index(run%work, 'drillgap: '//what//': ')
         call assertTrue(at > 0, message='wanted '//what//'; got: '//run%work)
         if (at == 0) return
         at = at + len('drillgap: '//what)
         associate (line => run%work(at:at + index(run%work(at:), newline) - 1))
            call assertTrue(index(line, ' solutions to find') > 0, message=what)
         end associate
      end subroutine told
   end subroutine test_told

   !> Load cases with measured hook loads, each at a depth of its own.
   function measured_cases(number) result(text)
      integer, intent(in) :: number
      character(:), allocatable :: text
      character(110) :: one
      integer :: i
      allocate (character(len(one)*number) :: text)
      do i = 1, number
         write (one, '(a, i0, a, i0, a)') "&load_case name = 'm", i, "', operation = 'up', bit_depth = 8", 10000 + i, &
            'e-3, measured_hookload = 300 /'
         one(len(one):) = newline
         text(len(one)*(i - 1) + 1:len(one)*i) = one
      end do
   end function measured_cases

   !> Number of times that a word stands in a text.
   function times(text, word) result(number)
      character(*), intent(in) :: text, word
      integer :: number
      integer :: i
      number = 0
      do i = 1, len(text) - len(word) + 1
         if (text(i:i + len(word) - 1) == word) number = number + 1
      end do
   end function times

   !> The good deck with more groups in its next line is refused there.
   subroutine refuse(groups, expected)
      character(*), intent(in) :: groups, expected
      type(run_type) :: run
      run = run_deck_text(good_deck()//groups//newline)
      call assertEqual(2, run%status, message=expected)
      call assertTrue(index(run%diagnostics, place//expected) > 0, message='wanted '//expected//'; got: '//run%diagnostics)
      call assertFalse(run%has_results, message='no folder of results: '//expected)
   end subroutine refuse
end module dg_test_bounds

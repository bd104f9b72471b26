!> Figures that a run prints beside its answers: they agree with the deck, with another run, and with what the advice brings.
module dg_test_printed_figures
   use funit, only: anyExceptions, assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_program_run, only: replaced, results_path, run_deck_text, run_type, unwrapped
   use dg_result_rows, only: lines_of, number
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: printed_figures_suite

   character(*), parameter :: newline = achar(10)
   integer, parameter :: col_torque = 14

contains

   function printed_figures_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('printed_figures')
      call suite%addTest(TestMethod('whirling', test_whirling))
      call suite%addTest(TestMethod('uncertain_contact', test_contact))
   end function printed_figures_suite

   !> A string on a slant. `loads` are those of its load case.
   function slant(model, loads) result(text)
      character(*), intent(in) :: model, loads
      character(:), allocatable :: text
      text = "&job models = '"//model//"', plots = .false., hdf5 = .false., profiles = .false. /"//newline// &
             "&trajectory md = 0, 1000, inc = 60, 60, azi = 0, 0 /"//newline// &
             "&hole diameter = 215.9, friction = 0.4 /"//newline// &
             "&fluid density = 1200 /"//newline//"&component name = 'dp', od = 127, id = 108.6, joint_od = 168 /"//newline// &
             "&load_case name = 'c', bit_depth = 1000, "//loads//" /"//newline
   end function slant

   !> Torque without sideways friction lies above that of a string that keeps its side, by what the message says. Nothing is said
   !> where the torque does not change, as in a vertical hole.
   subroutine test_whirling()
      character(*), parameter :: whirls = 'the rotating string does not stay on one side of the hole'
      type(run_type) :: run
      real(wp) :: held, found, high
      run = run_deck_text(slant('mcge', "operation = 'rotary', tob = 0, wob = 0.001"))
      call assertEqual(0, index(unwrapped(run%output), whirls), message=run%output)
      held = torque()
      run = run_deck_text(slant('mcge', "operation = 'rotary', tob = 0, wob = 150"))
      call assertTrue(index(unwrapped(run%output), whirls) > 0, message=run%output)
      found = torque()
      high = value_after(run%output, 'and torque at surface ')
      call assertTrue(found > held .and. abs(found*(1.0_wp - 0.01_wp*high) - held) < found - held, &
                      message=to_text(held)//' held, '//to_text(found)//' found, % too high '//to_text(high))
      run = run_deck_text(replaced(slant('mcge', "operation = 'rotary', tob = 4, wob = 30"), 'inc = 60, 60', 'inc = 0, 0'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual(0, index(unwrapped(run%output), whirls), message=run%output)
   contains
      !> Torque at surface [kN.m].
      function torque() result(value)
         real(wp) :: value
         type(text_type), allocatable :: rows(:)
         allocate (rows, source=lines_of(results_path//'/summary.csv'))
         value = 0.0_wp
         if (.not. anyExceptions()) value = number(rows(2)%text, col_torque)
      end function torque
   end subroutine test_whirling

   !> A place is named where it is a part of the string.
   subroutine test_contact()
      character(*), parameter :: head = 'Contact force uncertain by ', place = ' %, mostly between '
      type(run_type) :: run
      run = run_deck_text(replaced(slant('mcge', "operation = 'rotary', tob = 4, wob = 100"), 'inc = 60, 60', 'inc = 0, 0'))
      call assertTrue(index(unwrapped(run%output), head) > 0, message=run%output)
      call assertEqual(0, index(unwrapped(run%output), place), message=run%output)
      run = run_deck_text(replaced(slant('mcge', "operation = 'sliding', friction = 0.2, wob = 300"), '&component', &
                                   "&component name = 'hw', length = 300, od = 127, id = 76.2, joint_od = 160 / &component"))
      call assertTrue(index(unwrapped(run%output), place//'0 m and 700 m: ') > 0, message=run%output)
   end subroutine test_contact

   !> The number behind words of an output; 0 where they are absent, which fails the test.
   function value_after(output, words) result(value)
      character(*), intent(in) :: output, words
      real(wp) :: value
      character(:), allocatable :: text
      integer :: place, status
      value = 0.0_wp
      allocate (text, source=unwrapped(output))
      place = index(text, words)
      status = 1
      if (place > 0) read (text(place + len(words):), *, iostat=status) value
      call assertEqual(0, status, message=words//' in '//output)
   end function value_after
end module dg_test_printed_figures

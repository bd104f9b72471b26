!> Runs the built program as a user does: a deck in a scratch folder, then status, output and files.
!> The program is the one named in the environment variable DRILLGAP, or else the one that fpm has built
!> beside this test program.
module dg_program_run
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_folder, only: make_folder, is_folder
   use dg_error, only: error_type
   use dg_place, only: absolute_path, give_up, set_variable
   use dg_text, only: text_type, append_text
   implicit none
   private
   public :: run_type, run_program, run_interrupted, run_deck_text, good_deck, replaced, scratch, deck_path, results_path, &
      until, is_result, clear_scratch, settle_program, program_path, content, unwrapped

   !> Below fpm's own folder, which no repository keeps.
   character(*), parameter :: scratch = 'build/test_command_line'
   character(*), parameter :: deck_path = scratch//'/deck.nml'
   character(*), parameter :: results_path = scratch//'/results'
   character(*), parameter :: newline = achar(10)

   type :: run_type
      integer :: status = -1
      character(:), allocatable :: output      !< of standard output, lines ended by LF
      character(:), allocatable :: diagnostics !< of standard error, without the lines of `work`
      character(:), allocatable :: work        !< lines of standard error that tell how much there is to solve, and its time
      logical :: has_results = .false.         !< the output folder is there
   end type run_type

contains

   !> A deck without fault that is solved in no time; 20 lines, which tests of messages count on.
   function good_deck() result(text)
      character(:), allocatable :: text
      text = "&job title = 'a deck', models = 'soft', plots = .false. /"//newline// &
             "&trajectory"//newline// &
             "  md  = 0.0, 500.0, 900.0"//newline// &
             "  inc = 0.0, 0.0, 30.0"//newline// &
             "  azi = 3*10.0 /"//newline// &
             "&hole md_top = 0.0, md_bottom = 400.0"//newline// &
             "  diameter = 220.0, friction = 0.25 /"//newline// &
             "&hole md_top = 400.0, md_bottom = 900.0"//newline// &
             "  diameter = 215.9, friction = 0.3 /"//newline// &
             "&fluid density = 1200.0 /"//newline// &
             "&component name = 'collars', kind = 'collar', length = 100.0"//newline// &
             "  od = 171.45, id = 71.4 /"//newline// &
             "&component od = 127.0, id = 108.6"//newline// &
             "  joint_od = 168.3 /"//newline// &
             "&boundary top_lateral = 'centred' /"//newline// &
             "&load_case name = 'u', operation = 'up'"//newline// &
             "  bit_depth = 900.0 /"//newline// &
             "&load_case name = 's', operation = 'sliding', bit_depth = 800.0"//newline// &
             "  wob = 20.0 /"//newline// &
             "&solver element_length = 10.0 /"//newline
   end function good_deck

   !> `text` with the first `old` replaced; `old` that is not there spoils the text, so that the test fails.
   function replaced(text, old, new) result(changed)
      character(*), intent(in) :: text, old, new
      character(:), allocatable :: changed
      integer :: at
      at = index(text, old)
      if (at == 0) then
         changed = 'nothing to replace: '//old
      else
         changed = text(:at - 1)//new//text(at + len(old):)
      end if
   end function replaced

   !> A printed text with the lines of each wrapped paragraph joined.
   pure function unwrapped(text) result(whole)
      character(*), intent(in) :: text
      character(:), allocatable :: whole
      integer :: at
      whole = text
      do
         at = index(whole, newline//'  ')
         if (at == 0) exit
         whole = whole(:at - 1)//' '//trim(adjustl(whole(at + 1:)))
      end do
   end function unwrapped

   !> Writes `text` as deck and runs it with results below the scratch folder.
   function run_deck_text(text, options) result(run)
      character(*), intent(in) :: text
      character(*), intent(in), optional :: options
      type(run_type) :: run
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      integer :: first, length
      call clear_scratch()
      allocate (lines(0))
      first = 1
      do while (first <= len(text))
         length = index(text(first:), newline) - 1
         if (length < 0) length = len(text) - first + 1
         call append_text(lines, text(first:first + length - 1))
         first = first + length + 1
      end do
      call write_text_file(deck_path, lines, error)
      if (allocated(error)) then
         run%diagnostics = error%message
         run%work = ''
         run%output = ''
         return
      end if
      if (present(options)) then
         run = run_program(deck_path//' --output '//results_path//' '//options)
      else
         run = run_program(deck_path//' --output '//results_path)
      end if
   end function run_deck_text

   !> Runs the program with arguments as a shell takes them.
   function run_program(arguments, environment) result(run)
      character(*), intent(in) :: arguments
      character(*), intent(in), optional :: environment   !< NAME=VALUE, set for this run alone
      type(run_type) :: run
      integer :: command_status
      character(:), allocatable :: command
      command = "'"//program_path()//"' "//arguments//' > '//scratch//'/output.txt 2> '//scratch//'/diagnostics.txt'
      if (present(environment)) command = environment//' '//command
      call execute_command_line(command, exitstat=run%status, cmdstat=command_status)
      if (command_status /= 0) run%status = -1
      run%output = content(scratch//'/output.txt')
      call split_diagnostics(run)
      run%has_results = is_folder(results_path)
   end function run_program

   !> A line of a shell that waits until a condition holds, for two minutes at most: a busy machine is slow.
   pure function until(condition) result(line)
      character(*), intent(in) :: condition    !< a command
      character(:), allocatable :: line
      line = 'for i in $(seq 6000); do '//condition//' && break; sleep 0.02; done'
   end function until

   !> A condition: the file is among the results.
   pure function is_result(file) result(condition)
      character(*), intent(in) :: file
      character(:), allocatable :: condition
      condition = '[ -e '//results_path//'/'//file//' ]'
   end function is_result

   !> Runs the deck in the scratch folder and ends it by a signal as soon as a condition holds.
   function run_interrupted(options, condition, signal) result(run)
      character(*), intent(in) :: options
      character(*), intent(in) :: condition    !< of `until`
      character(*), intent(in) :: signal       !< name as `kill` takes it
      type(run_type) :: run
      integer :: command_status
      ! in the foreground: a shell starts what is behind & with SIGINT ignored; these tests may have been started so, too
      call execute_command_line('('//until(condition)//'; kill -'//signal//' $(cat '//scratch//'/interrupted_pid)) & '// &
                                "sh -c 'echo $$ > "//scratch//'/interrupted_pid; '// &
                                'exec env --default-signal "'//program_path()//'" '//deck_path//' --output '// &
                                results_path//' '//options//"' > "//scratch//'/output.txt 2> '//scratch//'/diagnostics.txt', &
                                exitstat=run%status, cmdstat=command_status)
      if (command_status /= 0) run%status = -1
      run%output = content(scratch//'/output.txt')
      call split_diagnostics(run)
      run%has_results = is_folder(results_path)
   end function run_interrupted

   !> Takes what stands on standard error apart: how long work takes depends on the machine.
   subroutine split_diagnostics(run)
      type(run_type), intent(inout) :: run
      character(:), allocatable :: left, line
      integer :: length
      left = content(scratch//'/diagnostics.txt')
      run%diagnostics = ''
      run%work = ''
      do while (len(left) > 0)
         length = index(left, newline)
         line = left(:length)
         left = left(length + 1:)
         if (index(line, ' solutions to find'//newline) > 0 .or. index(line, ' left'//newline) > 0) then
            run%work = run%work//line
         else
            run%diagnostics = run%diagnostics//line
         end if
      end do
   end subroutine split_diagnostics

   !> Empties the scratch folder.
   subroutine clear_scratch()
      type(error_type), allocatable :: error
      integer :: status
      call execute_command_line('rm -rf '//scratch, exitstat=status)
      call make_folder(scratch, error)
   end subroutine clear_scratch

   !> Leaves the path of the program in DRILLGAP, from / on: to be called before the working folder changes. Without DRILLGAP it is
   !> build/<compiler and flags>/app/drillgap where this program is build/<compiler and flags>/test/command_line. Stops
   !> where there is none.
   subroutine settle_program()
      character(:), allocatable :: path, full
      integer :: length
      path = program_path()
      if (path == '') then
         deallocate (path)
         call get_command_argument(0, length=length)
         allocate (character(length) :: path)
         call get_command_argument(0, value=path)
         path = path(:index(path, '/', back=.true.))//'../app/drillgap'
      end if
      full = absolute_path(path)
      if (full == '') call give_up('no program '//path//': `fpm test` builds it, or DRILLGAP names it')
      call set_variable('DRILLGAP', full)
   end subroutine settle_program

   !> The program that is run.
   function program_path() result(path)
      character(:), allocatable :: path
      integer :: length
      call get_environment_variable('DRILLGAP', length=length)
      allocate (character(length) :: path)
      if (length > 0) call get_environment_variable('DRILLGAP', value=path)
   end function program_path

   !> A whole file; '' where there is none.
   function content(path) result(text)
      character(*), intent(in) :: path
      character(:), allocatable :: text
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      integer :: i
      call read_lines(path, lines, failure)
      text = ''
      do i = 1, size(lines)
         text = text//lines(i)%text//newline
      end do
   end function content
end module dg_program_run

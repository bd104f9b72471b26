!> The command line.
module dg_arguments
   use dg_error, only: error_type, raise, status_bad_input
   use dg_part_list, only: is_count, read_part_list
   use dg_deck_schema, only: listed
   use dg_quantity, only: deck_systems
   use dg_text, only: append_text, quoted, suggestion, text_type
   use dg_units, only: deck_system
   use dg_version, only: program_name
   implicit none
   private
   public :: arguments_type, read_arguments, usage_lines

   type :: arguments_type
      character(:), allocatable :: deck       !< '-': from standard input
      character(:), allocatable :: output_dir !< '': as the deck says
      integer :: threads = 0                  !< 0: as many as there are cores
      logical :: threads_given = .false.      !< else as the deck says
      integer, allocatable :: chosen(:)       !< parts of sweeps and uncertainties, one after another; 1 of an undivided run
      integer :: parts = 0                    !< of so many; 0: undivided
      integer :: merge = 0                    !< > 0: so many parts are to be joined
      character(:), allocatable :: action    !< '', or what to do instead of a run: an option without its dashes
      character(:), allocatable :: units     !< '', or the system of units for --convert and --import
      type(text_type), allocatable :: files(:) !< for --import, behind `deck`
      character(:), allocatable :: well      !< the same; '': the only one
      logical :: again = .false.              !< points that did not converge are solved again
      logical :: check = .false.
      logical :: quiet = .false.
      logical :: help = .false.
      logical :: version = .false.
   end type arguments_type

   character(*), parameter :: options(15) = [character(16) :: '--check', '--output', '--threads', '--part', '--merge', '--again', &
                                             '--quiet', '--help', '--version', '--template', '--list-catalogue', '--convert', &
                                             '--import', '--well', '--units']
   !> Most digits of a number of threads.
   integer, parameter :: longest_count = 4

contains

   !> Reads the command line. Bad input, one line each: unknown option, option without its value, no deck or two.
   subroutine read_arguments(arguments, error)
      type(arguments_type), intent(out) :: arguments
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: word, option, value
      integer :: i, equals
      logical :: only_decks

      arguments%deck = ''
      arguments%output_dir = ''
      arguments%action = ''
      arguments%units = ''
      arguments%well = ''
      allocate (arguments%files(0))
      arguments%chosen = [1]
      value = ''
      only_decks = .false.
      i = 0
      do while (i < command_argument_count())
         i = i + 1
         word = argument(i)
         if (word == '--' .and. len(word) == 2 .and. .not. only_decks) then
            only_decks = .true.
            cycle
         end if
         if (index(word, '-') /= 1 .or. len(word) == 1 .or. only_decks) then
            if (arguments%deck /= '' .and. arguments%action == 'convert' .and. deck_system(word) > 0 .and. &
                arguments%units == '') then
               arguments%units = word
               cycle
            else if (arguments%action == 'import' .and. arguments%deck /= '' .and. word /= '') then
               call append_text(arguments%files, word)
               cycle
            else if (arguments%deck /= '' .and. arguments%action == 'convert') then
               call refuse('--convert takes one deck and units, as '//listed(deck_systems)//', not '//quoted(word))
            else if (arguments%deck /= '') then
               call refuse('two decks, '//quoted(arguments%deck)//' and '//quoted(word)//'. Give one')
            else if (word == '') then
               call refuse('the name of the deck is empty. Give a file')
            end if
            if (allocated(error)) return
            arguments%deck = word
            if (only_decks .and. word == '-') arguments%deck = './-'
            cycle
         end if
         option = word
         equals = index(word, '=')
         if (equals > 0) option = word(:equals - 1)
         select case (option)
         case ('--output', '--threads', '--part', '--merge', '--well', '--units')
            value = ''
            if (equals > 0) then
               value = word(equals + 1:)
            else
               i = i + 1
               if (i <= command_argument_count()) value = argument(i)
            end if
            call read_value()
         case ('--again', '--check', '--quiet', '--help', '--version', '-h', '-v')
            if (equals > 0) call refuse(option//' takes no value. Write '//option)
            if (option == '--again') arguments%again = .true.
            if (option == '--check') arguments%check = .true.
            if (option == '--quiet') arguments%quiet = .true.
            if (option == '--help' .or. option == '-h') arguments%help = .true.
            if (option == '--version' .or. option == '-v') arguments%version = .true.
         case ('--template', '--list-catalogue', '--convert', '--import')
            if (equals > 0) call refuse('after '//option//' comes a blank, not =')
            if (arguments%action /= '') call refuse(option//' and --'//arguments%action//' exclude each other. Give one')
            arguments%action = option(3:)
         case default
            call refuse('unknown option '//quoted(option)//', '//suggestion(option, options))
         end select
         if (allocated(error)) return
      end do
      if (.not. allocated(error)) call check_words(arguments, error)

   contains

      !> Read the value of an option that has one.
      subroutine read_value()
         if (value == '') then
            call refuse(option//' needs a value, as in '//option//' '//sample_of(option))
            return
         end if
         select case (option)
         case ('--output')
            arguments%output_dir = value
         case ('--well')
            arguments%well = value
         case ('--units')
            arguments%units = value
            if (deck_system(value) == 0) call refuse('no units '//quoted(value)//'. Units are '//listed(deck_systems))
         case ('--part')
            call read_part(value, arguments, error)
         case ('--merge')
            if (.not. is_count(value)) call refuse('--merge '//value//' is not a number of parts. Give 1 to 9999, as in --merge 4')
            if (is_count(value)) read (value, *) arguments%merge
         case default
            call read_threads(value)
         end select
      end subroutine read_value

      subroutine refuse(message)
         character(*), intent(in) :: message
         call raise_once(error, message)
      end subroutine refuse

      subroutine read_threads(text)
         character(*), intent(in) :: text
         if (verify(text, '0123456789') == 0 .and. len(text) <= longest_count) then
            read (text, *) arguments%threads
            arguments%threads_given = .true.
         else
            call refuse('--threads '//text//' is not a number of threads. Give 0 (all cores) to 9999')
         end if
      end subroutine read_threads
   end subroutine read_arguments

   !> Check the options together: required ones, and those that exclude each other.
   subroutine check_words(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(inout) :: error
      if (arguments%action == 'convert' .and. arguments%deck == '') &
         call raise_once(error, '--convert needs a deck, as in --convert well.nml')
      if (arguments%action == 'import') then
         if (arguments%deck == '') call raise_once(error, '--import needs a file, as in --import well.xml')
      else if (arguments%well /= '' .or. (arguments%units /= '' .and. arguments%action /= 'convert')) then
         call raise_once(error, '--well and --units go with --import')
      end if
      if (arguments%deck == '' .and. arguments%action == '' .and. .not. (arguments%help .or. arguments%version)) &
         call raise_once(error, 'no deck given. Write '//program_name//' DECK.nml')
      if (arguments%deck /= '' .and. arguments%action == 'template' .and. deck_system(arguments%deck) == 0) &
         call raise_once(error, '--template takes no deck and no units '//quoted(arguments%deck)//'. Units are '// &
                         listed(deck_systems))
      if (arguments%parts > 0 .and. arguments%merge > 0) &
         call raise_once(error, '--part and --merge exclude each other. Join the parts when all are there')
   end subroutine check_words

   !> Reads i/n or a list of parts.
   subroutine read_part(text, arguments, error)
      character(*), intent(in) :: text
      type(arguments_type), intent(inout) :: arguments
      type(error_type), allocatable, intent(inout) :: error
      character(:), allocatable :: failure
      call read_part_list(text, arguments%chosen, arguments%parts, failure)
      if (failure /= '') call raise_once(error, '--part '//text//' is not a part: '//failure// &
         '. Give i/n with i from 1 to n, as '// &
                                         'in --part 2/4, or several, each once, as in --part 3,7-9/40')
   end subroutine read_part

   !> Keeps the first fault.
   subroutine raise_once(error, message)
      type(error_type), allocatable, intent(inout) :: error
      character(*), intent(in) :: message
      character(:), allocatable :: end_mark
      if (allocated(error)) return
      end_mark = '.'
      if (index('.?', message(len(message):)) > 0) end_mark = ''
      call raise(error, status_bad_input, message//end_mark//' See '//program_name//' --help')
   end subroutine raise_once

   !> A value that an option may have.
   pure function sample_of(option) result(value)
      character(*), intent(in) :: option
      character(:), allocatable :: value
      select case (option)
      case ('--output'); value = 'results'
      case ('--part'); value = '2/4'
      case ('--well'); value = 'A-1'
      case ('--units'); value = 'field'
      case default; value = '4'
      end select
   end function sample_of

   !> One argument at its own length.
   function argument(number) result(word)
      integer, intent(in) :: number
      character(:), allocatable :: word
      integer :: length
      call get_command_argument(number, length=length)
      allocate (character(length) :: word)
      if (length > 0) call get_command_argument(number, value=word)
   end function argument

   !> Usage of the program.
   subroutine usage_lines(lines)
      type(text_type), allocatable, intent(out) :: lines(:)
      call append_text(lines, 'usage: '//program_name//' DECK.nml [options]')
      call append_text(lines, '  DECK.nml       a deck; - reads it from standard input, with --output or output_dir in it')
      call append_text(lines, '  --check        check the deck and print how it is understood; solve nothing')
      call append_text(lines, '  --output DIR   folder of results instead of the deck''s output_dir')
      call append_text(lines, '  --threads N    number of cases solved at the same time, in place of the deck''s; 0: all cores')
      call append_text(lines, '  --part I/N     solve only part I of N of the sweeps and uncertainties; --merge N then joins them;')
      call append_text(lines, '                 several parts one after another: --part 3,7-9/40')
      call append_text(lines, '  --merge N      join the N parts of each sweep, solve nothing')
      call append_text(lines, '  --again        solve again points of sweeps and uncertainties that did not converge,')
      call append_text(lines, '                 with the present &solver of DECK.nml; can be combined with --part or --merge')
      call append_text(lines, '  --quiet        print results only: no progress, no notes')
      call append_text(lines, '  --help, -h     this text')
      call append_text(lines, '  --version, -v  name and version')
      call append_text(lines, 'or: '//program_name//' --template [UNITS]            prints a commented deck to start from')
      call append_text(lines, '    '//program_name//' --list-catalogue [PATTERN]    '// &
                       'prints the catalogue of pipe, or its entries with PATTERN')
      call append_text(lines, '    '//program_name//' --convert DECK.nml [UNITS]    '// &
                       'prints the deck in other units')
      call append_text(lines, '    '//program_name//' --import FILE... [--well NAME] [--units UNITS]')
      call append_text(lines, '                 prints a deck made from an EDM export, or from WITSML documents of a well')
      call append_text(lines, 'UNITS: '//listed(deck_systems))
      call append_text(lines, 'exit status: 0 every case has an answer, yes or no, '// &
                       '3 a case did not converge,')
      call append_text(lines, '             2 bad command line, deck or data file, 1 anything else')
   end subroutine usage_lines
end module dg_arguments

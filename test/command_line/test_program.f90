!> The command line as such: options, exit statuses, and what is left on disk.
module dg_test_program
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_program_run, only: run_type, run_program, run_deck_text, good_deck, content, replaced, scratch, deck_path, results_path, &
      clear_scratch, unwrapped
   use dg_result_rows, only: field
   use dg_text, only: text_type, append_text
   implicit none
   private
   public :: program_suite

   character(*), parameter :: newline = achar(10)

contains

   function program_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('program')
      call suite%addTest(TestMethod('no_deck', test_no_deck))
      call suite%addTest(TestMethod('version_and_help', test_version_and_help))
      call suite%addTest(TestMethod('bad_options', test_bad_options))
      call suite%addTest(TestMethod('deck_not_there', test_deck_not_there))
      call suite%addTest(TestMethod('check_leaves_nothing', test_check))
      call suite%addTest(TestMethod('solves', test_solves))
      call suite%addTest(TestMethod('no_profiles', test_no_profiles))
      call suite%addTest(TestMethod('hdf5_files', test_hdf5_files))
      call suite%addTest(TestMethod('hdf5_file_in_the_way', test_hdf5_in_the_way))
      call suite%addTest(TestMethod('pictures', test_pictures))
      call suite%addTest(TestMethod('no_gnuplot', test_no_gnuplot))
      call suite%addTest(TestMethod('limits', test_limits))
      call suite%addTest(TestMethod('strength', test_strength))
      call suite%addTest(TestMethod('not_converged', test_not_converged))
      call suite%addTest(TestMethod('output_not_writable', test_output_not_writable))
      call suite%addTest(TestMethod('survey_file', test_survey_file))
      call suite%addTest(TestMethod('forms_of_a_deck', test_forms))
   end function program_suite

   subroutine test_no_deck()
      type(run_type) :: run
      call clear_scratch()
      run = run_program('')
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'no deck given') > 0, message=run%diagnostics)
      call assertEqual(len(run%diagnostics), index(run%diagnostics, newline), message='one line: '//run%diagnostics)
      call assertTrue(index(run%diagnostics, 'See drillgap --help') > 0, message=run%diagnostics)
      call assertEqual('', run%output)
   end subroutine test_no_deck

   subroutine test_version_and_help()
      type(run_type) :: run
      call clear_scratch()
      run = run_program('--version')
      call assertEqual(0, run%status)
      call assertEqual('drillgap 0.3.0'//newline, run%output)
      run = run_program('-v')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('drillgap 0.3.0'//newline, run%output)
      run = run_program('-h')
      call assertEqual(0, run%status)
      call assertTrue(index(run%output, 'usage: drillgap DECK.nml') == 1, message=run%output)
      run = run_program('--help')
      call assertEqual(0, run%status)
      call assertTrue(index(run%output, 'usage: drillgap DECK.nml') == 1, message=run%output)
      call assertEqual('', run%diagnostics)
   end subroutine test_version_and_help

   subroutine test_bad_options()
      call clear_scratch()
      call refuse('deck.nml --chekc', "unknown option '--chekc', did you mean '--check'?")
      call refuse('deck.nml --output', '--output needs a value')
      call refuse('deck.nml --threads two', '--threads two is not a number of threads')
      call refuse('deck.nml --quiet=yes', '--quiet takes no value')
      call refuse('deck.nml other.nml', "two decks, 'deck.nml' and 'other.nml'. Give one")
   end subroutine test_bad_options

   subroutine refuse(arguments, expected)
      character(*), intent(in) :: arguments, expected
      type(run_type) :: run
      run = run_program(arguments)
      call assertEqual(2, run%status, message=arguments)
      call assertTrue(index(run%diagnostics, expected) > 0, message='wanted: '//expected//'; got: '//run%diagnostics)
   end subroutine refuse

   subroutine test_deck_not_there()
      type(run_type) :: run
      call clear_scratch()
      run = run_program(scratch//'/absent.nml --output '//results_path)
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, scratch//'/absent.nml: deck cannot be opened') == 1, message=run%diagnostics)
      call assertFalse(run%has_results)
      run = run_program(scratch//' --output '//results_path)
      call assertEqual(2, run%status)
      call assertTrue(index(run%diagnostics, 'it is a folder') > 0, message=run%diagnostics)
   end subroutine test_deck_not_there

   subroutine test_check()
      type(run_type) :: run
      run = run_deck_text(good_deck(), '--check')
      call assertEqual(0, run%status)
      call assertFalse(run%has_results)
      call assertTrue(index(run%output, 'sliding_drilling at 800 m') > 0, message=run%output)
      call assertEqual('', run%diagnostics)
      ! options before the deck, values behind =
      run = run_program('--check --output='//results_path//' '//deck_path)
      call assertEqual(0, run%status)
      call assertTrue(index(run%output, 'results in  '//results_path) > 0, message=run%output)
   end subroutine test_check

   subroutine test_solves()
      type(run_type) :: run
      run = run_deck_text(good_deck())
      call assertEqual(0, run%status)
      call assertTrue(is_file('summary.csv'))
      call assertTrue(is_file('profile_u_soft.csv'))
      call assertTrue(is_file('profile_s_soft.csv'))
      call assertTrue(index(run%output, 'a deck') > 0, message=run%output)
      call assertEqual('', run%diagnostics, message='no progress where nobody watches')
   end subroutine test_solves

   subroutine test_no_profiles()
      type(run_type) :: run
      run = run_deck_text(replaced(good_deck(), 'title', 'profiles = .false., title'))
      call assertEqual(0, run%status)
      call assertTrue(is_file('summary.csv'))
      call assertFalse(is_file('profile_u_soft.csv'))
   end subroutine test_no_profiles

   !> Pictures and page where the deck does not say no; gnuplot must be there.
   subroutine test_pictures()
      type(run_type) :: run
      character(:), allocatable :: picture
      run = run_deck_text(with_plots())
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertEqual('', run%diagnostics)
      call assertTrue(is_file('pictures/hookload.svg'))
      call assertTrue(is_file('pictures/path_u.svg'))
      picture = content(results_path//'/pictures/path_u.svg')
      call assertTrue(index(picture, '<title>Well path with contact of the string. u: up at 900 m, model soft. a deck</title>') > 0)
      call assertEqual(index(picture, '<title>'), index(picture, '<title>', back=.true.), message='one title')
      call assertTrue(is_file('pictures/forces_s.svg'))
      call assertFalse(is_file('pictures/gnuplot.log'))
      call assertTrue(is_file('report.html'))
      run = run_deck_text(good_deck())
      call assertFalse(is_file('pictures/hookload.svg'))
      call assertFalse(is_file('report.html'))
   end subroutine test_pictures

   !> Without gnuplot the run says so, and scripts, data and page are there all the same.
   subroutine test_no_gnuplot()
      type(run_type) :: run
      run = run_deck_text(with_plots(), '--check')
      run = run_program(deck_path//' --output '//results_path, environment='PATH=/nonexistent')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, 'note: no gnuplot here') > 0, message=run%diagnostics)
      call assertTrue(is_file('pictures/all.gp'))
      call assertTrue(is_file('pictures/forces_s.gp'))
      call assertTrue(is_file('profile_s_soft.csv'))
      call assertFalse(is_file('pictures/forces_s.svg'))
      call assertTrue(is_file('report.html'))
   end subroutine test_no_gnuplot

   !> The deck without its word against pictures, which cost other tests time.
   function with_plots() result(text)
      character(:), allocatable :: text
      text = replaced(good_deck(), ', plots = .false.', '')
   end function with_plots

   !> Whole files of the format, or none where the deck says so; what is in them .ci/check_results.py reads.
   subroutine test_hdf5_files()
      type(run_type) :: run
      run = run_deck_text(with_plots())
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(is_hdf5('results.h5'))
      call assertTrue(is_hdf5('view_u_soft.hdf'))
      call assertTrue(is_hdf5('view_s_soft.hdf'))
      call assertFalse(is_file('results.h5.unfinished'))
      run = run_deck_text(replaced(with_plots(), 'title', 'hdf5 = .false., title'))
      call assertFalse(is_file('results.h5'))
      call assertTrue(is_file('view_u_soft.hdf'))
      run = run_deck_text(good_deck())
      call assertTrue(is_file('results.h5'))
      call assertFalse(is_file('view_u_soft.hdf'))
   end subroutine test_hdf5_files

   !> A file that cannot be written costs the exit status, not the other files.
   subroutine test_hdf5_in_the_way()
      type(run_type) :: run
      run = run_deck_text(with_plots(), '--check')
      call execute_command_line('mkdir -p '//results_path//'/results.h5')
      run = run_program(deck_path//' --output '//results_path)
      call assertEqual(1, run%status)
      call assertTrue(index(run%diagnostics, 'results.h5') > 0, message=run%diagnostics)
      call assertFalse(is_file('results.h5.unfinished'))
      call assertTrue(is_file('summary.csv'))
      call assertTrue(is_file('view_u_soft.hdf'))
      call assertTrue(index(run%output, 'a deck') > 0, message=run%output)
   end subroutine test_hdf5_in_the_way

   !> limits.csv and the short block: yield, make-up torque and the rig's limit only where they are given.
   subroutine test_limits()
      type(run_type) :: run
      character(:), allocatable :: deck
      run = run_deck_text(good_deck())
      call assertTrue(is_file('limits.csv'))
      call assertTrue(index(run%output, 'Limits, model soft (all: limits.csv)') > 0, message=run%output)
      call assertTrue(index(run%output, 'Least margin to buckling') > 0, message=run%output)
      call assertFalse(index(run%output, 'Least safety against yield') > 0, message=run%output)
      run = run_deck_text(replaced(replaced(good_deck(), 'title', 'rig_limit = 9000.0, title'), 'id = 108.6', &
                                   'id = 108.6, yield = 724.0, makeup_torque = 30.0'))
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'Least safety against yield') > 0, message=run%output)
      call assertTrue(index(overpull(), ', pipe)') > 0, message=overpull())
      call assertTrue(index(run%output, 'Least margin to rig limit') > 0, message=run%output)
      call assertTrue(index(run%output, 'Least margin to make-up     30.00 kN.m') > 0, message=run%output)
      deck = replaced(good_deck(), 'id = 108.6', 'id = 108.6, yield = 724.0')
      run = run_deck_text(replaced(deck, 'title', 'rig_limit = 100.0, title'))
      call assertTrue(index(overpull(), ', rig)') > 0, message=overpull())
      run = run_deck_text(deck)
      call assertTrue(index(overpull(), ', pipe alone, rig NOT CHECKED)') > 0, message=overpull())
   contains
      !> The line of the overpull that is left.
      function overpull() result(line)
         character(:), allocatable :: line
         line = run%output(index(run%output, 'Overpull left, pipe or rig'):)
         line = line(:index(line, achar(10)))
      end function overpull
   end subroutine test_limits

   !> Strengths of the deck as --check prints them (5 in 19.50 lb/ft S-135, premium, NC50 of 6-5/8 by 2-3/4 in: 560.8 klbf, 58.1
   !> kft.lbf, 10,029 psi and 63,406 ft.lbf by API), and the limit that governs; none without a yield strength.
   subroutine test_strength()
      type(run_type) :: run
      character(:), allocatable :: deck, limit
      run = run_deck_text(good_deck())
      call assertTrue(index(run%output, 'NOT CHECKED, as the deck gives no limit: pipe strength (no yield)') > 0, &
                      message=run%output)
      call last_limit(limit)
      call assertEqual('', limit, message='nothing is known')
      deck = replaced(good_deck(), 'id = 108.6', "id = 108.6104, yield = 930.792, wear_class = 'premium', connection = 'nc50', "// &
                      'joint_id = 69.85')
      deck = replaced(deck, 'joint_od = 168.3', 'joint_od = 168.275')
      run = run_deck_text(deck, '--check')
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(run%output, 'strength with 80 % of the wall: tension 2494.4') > 0, message=run%output)
      call assertTrue(index(run%output, ', collapse 69.14') > 0, message=run%output)
      call assertTrue(index(run%output, ', connection 85.966') > 0, message=run%output)
      call assertTrue(index(run%output, ', make-up 51.58') > 0, message=run%output)
      run = run_deck_text(deck)
      call assertEqual(0, run%status, message=run%diagnostics)
      call assertTrue(index(unwrapped(run%output), "von Mises stress at 500 m in 'drillpipe', 121.1 of 930.7 MPa, 13 % used") > 0, &
                      message=run%output)
      ! it is used most at surface, where the string neither turns nor bends
      call last_limit(limit)
      call assertEqual('tension', limit)
      run = run_deck_text(replaced(deck, ', joint_id = 69.85', ''), '--check')
      call assertTrue(index(run%output, 'the torque at which its connection yields is not known') > 0, message=run%output)

   contains

      !> Which limit governs the last case.
      subroutine last_limit(limit)
         character(:), allocatable, intent(out) :: limit
         type(text_type), allocatable :: lines(:)
         character(:), allocatable :: before
         integer :: i
         call read_lines(results_path//'/limits.csv', lines, before)
         limit = before
         if (size(lines) < 2) return
         before = lines(1)%text(:index(lines(1)%text, ',governing_limit,'))
         limit = field(lines(size(lines))%text, count([(before(i:i) == ',', i=1, len(before))]) + 1)
      end subroutine last_limit
   end subroutine test_strength

   !> One iteration is never enough; the other model's results are written all the same.
   subroutine test_not_converged()
      type(run_type) :: run
      run = run_deck_text(replaced(replaced(good_deck(), "'soft'", "'mcge', 'soft'"), 'element_length = 10.0', &
                                   'element_length = 50.0, max_iterations = 1'))
      call assertEqual(3, run%status)
      call assertTrue(index(run%diagnostics, "case 'u', model mcge: did not converge") > 0, message=run%diagnostics)
      call assertTrue(is_file('profile_u_soft.csv'))
      call assertTrue(is_file('summary.csv'))
      call assertFalse(is_file('profile_u_mcge.csv'), message='a failed case has no profile')
      call assertTrue(index(run%diagnostics, ' out of balance at ') > 0, message=run%diagnostics)
      call assertTrue(index(run%diagnostics, '. Tried in 1 iterations: elements up to ') > 0, message=run%diagnostics)
      call assertTrue(index(content(results_path//'/limits.csv'), newline//'u,mcge,not_converged,,,,') > 0)
      call assertTrue(index(content(results_path//'/summary.csv'), ',not_converged,1,') > 0)
      call assertTrue(index(content(results_path//'/summary.csv'), ',,,,,,,,not_converged,1,') > 0, &
                      message=content(results_path//'/summary.csv'))
   end subroutine test_not_converged

   !> A file stands where the folder should be.
   subroutine test_output_not_writable()
      type(run_type) :: run
      run = run_deck_text(good_deck(), '--output '//deck_path//'/results')
      call assertEqual(1, run%status)
      call assertTrue(index(run%diagnostics, 'cannot make the output folder') > 0, message=run%diagnostics)
   end subroutine test_output_not_writable

   !> A table beside the deck: any order and case of columns, other columns, comments, both separators.
   subroutine test_survey_file()
      call survey(['# made up             ', 'Azi,MD (m),dogleg,INC ', '10,0,0,0              ', '10,500,0,0            ', &
                   '10,900,2.2,30         '], 0, '')
      call survey(['md inc azi            ', '0   0   10            ', '500 0   10 # kick off ', '900 30  10            '], 0, '')
      call survey(['md;inc;azi            ', '0;0;10                ', '500,5;0;10            ', '900;30;10             '], 0, '')
      call survey(['md,inc,azi            ', '0,0,10                ', '900,30,10             ', '500,0,10              '], 4, &
                  'station 3 at 500 m is not below station 2 at 900 m')
      call survey(['md,inc,azi            ', '0,0,10                ', '900,thirty,10         '], &
                  3, "inc = 'thirty' is not a number")
      call survey(['md,inc,azi            ', '0,0,10                ', '900,30                '], 3, 'no value for azi')
      call survey(['md,inc,azi            ', '0,0,10                ', '900,190,10            '], 3, 'inc = 190 is out of range')
      call survey(['md,inc,azi            ', '0,0,10                ', '900,30,-999.25        '], 3, &
                  'azi = -999.25 is out of range; needs a number, -360 to 720 deg')
      call survey(['md,inc,azi            ', '0,0,10                ', '60000,30,10           '], 3, &
                  'md = 60000 is out of range; needs a number, 0 to 50000 m')
      call survey(['tvd,inc,azi           ', '0,0,10                ', '900,30,10             '], 1, 'the header names no md')
   end subroutine test_survey_file

   subroutine survey(rows, line, expected)
      character(*), intent(in) :: rows(:)
      integer, intent(in) :: line             !< of the fault in the table; 0: none
      character(*), intent(in) :: expected
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      type(run_type) :: run
      character(16) :: place
      character(:), allocatable :: text
      integer :: i
      text = replaced(good_deck(), 'md  = 0.0, 500.0, 900.0', "survey_file = 'wells/path.csv'")
      text = replaced(replaced(text, 'inc = 0.0, 0.0, 30.0', ''), 'azi = 3*10.0', '')
      ! the table must be there when the deck runs, and writing a deck empties the folder: run twice
      run = run_deck_text(text, '--check')
      call assertEqual(2, run%status, message='no table')
      call assertTrue(index(run%diagnostics, deck_path//':3: group &trajectory: survey_file: '//scratch// &
                            '/wells/path.csv: survey file cannot be opened (') == 1, message=run%diagnostics)
      call execute_command_line('mkdir -p '//scratch//'/wells')
      allocate (lines(0))
      do i = 1, size(rows)
         call append_text(lines, trim(rows(i)))
      end do
      call write_text_file(scratch//'/wells/path.csv', lines, error)
      run = run_program('--check '//deck_path)
      if (line == 0) then
         call assertEqual(0, run%status, message=run%diagnostics)
      else
         call assertEqual(2, run%status, message=expected)
         write (place, '(a,i0,a)') ':', line, ':'
         call assertTrue(index(run%diagnostics, scratch//'/wells/path.csv'//trim(place)) == 1, message=run%diagnostics)
         call assertTrue(index(run%diagnostics, expected) > 0, message=run%diagnostics)
      end if
   end subroutine survey

   !> Accept the forms of a namelist: capitals, tabs, CR LF, &end, values over lines, both quotes, quotes doubled, subscripts, keys
   !> parted by blanks or commas, ! in texts.
   subroutine test_forms()
      call accept('&job title', '&JOB Title')
      call accept("'a deck'", '"it''s ! one / deck"')
      call accept("'a deck'", "'it''s'")
      call accept('  md  = 0.0, 500.0, 900.0', achar(9)//'md'//achar(9)//'='//achar(9)//'0.0'//achar(13)//newline// &
                  '500.0'//newline//'! a comment'//newline//', 900.0'//achar(13))
      call accept('azi = 3*10.0 /', 'azi(1:2) = 2*10.0, azi(3) = 1.0d1 &end')
      call accept('azi = 3*10.0', 'azi(:) = 10 +10. 1e1')
      call accept('&fluid density = 1200.0 /', '&fluid density=1200./&boundary/')
      call accept("&boundary top_lateral = 'centred' /", '')
      call accept('0.0, 0.0, 30.0', '0.0, 0.0, 30.0,')
   end subroutine test_forms

   subroutine accept(old, new)
      character(*), intent(in) :: old, new
      type(run_type) :: run
      character(:), allocatable :: text
      text = replaced(good_deck(), old, new)
      if (index(new, '&boundary/') > 0) text = replaced(text, "&boundary top_lateral = 'centred' /", '')
      run = run_deck_text(text, '--check')
      call assertEqual(0, run%status, message=new//': '//run%diagnostics)
   end subroutine accept

   !> True if a file of that name is among the results.
   function is_file(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      inquire (file=results_path//'/'//name, exist=is)
   end function is_file

   !> True if a file of that name is among the results and begins as HDF5 files do.
   function is_hdf5(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      character(*), parameter :: signature = achar(137)//'HDF'//achar(13)//achar(10)//achar(26)//achar(10)
      character(len(signature)) :: found
      integer :: unit, status
      found = ''
      open (newunit=unit, file=results_path//'/'//name, access='stream', form='unformatted', action='read', status='old', &
            iostat=status)
      if (status == 0) then
         read (unit, iostat=status) found
         close (unit)
      end if
      is = status == 0 .and. found == signature
   end function is_hdf5
end module dg_test_program

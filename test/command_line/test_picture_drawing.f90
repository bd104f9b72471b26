!> Input and runs of gnuplot: texts that it must take as they are, programs of its name that fail or hang.
module dg_test_picture_drawing
   use, intrinsic :: iso_c_binding, only: c_char, c_int
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_readable, only: cut_text
   use dg_child_process, only: child_type, end_child, find_program, start_child, wait_for_child
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: delete_file, write_text_file
   use dg_folder, only: make_folder
   use dg_gnuplot_script, only: row_tics, spelled
   use dg_kinds, only: wp
   use dg_picture_drawing, only: draw_pictures
   use dg_text, only: append_text, c_text, plain_utf8, text_list, text_type, to_text
   implicit none
   private
   public :: picture_drawing_suite

   character(*), parameter :: folder = 'build/test_picture_drawing'
   character(*), parameter :: umlaut = char(195)//char(188), sum_sign = char(226)//char(136)//char(145)
   !> Seconds that none of these programs takes.
   real(wp), parameter :: long = 60.0_wp

   interface
      function c_setenv(name, value, overwrite) result(status) bind(c, name='setenv')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: name(*), value(*)
         integer(c_int), value :: overwrite
         integer(c_int) :: status
      end function c_setenv
   end interface

contains

   function picture_drawing_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('picture_drawing')
      call suite%addTest(TestMethod('printable_text', test_printable))
      call suite%addTest(TestMethod('cut_letters', test_cut))
      call suite%addTest(TestMethod('quotes_of_all_bytes', test_all_bytes))
      call suite%addTest(TestMethod('exit_status', test_exit_status))
      call suite%addTest(TestMethod('environment', test_environment))
      call suite%addTest(TestMethod('stubborn_child', test_stubborn_child))
      call suite%addTest(TestMethod('whole_pictures_only', test_whole_only))
      call suite%addTest(TestMethod('hangs', test_hangs))
      call suite%addTest(TestMethod('slow', test_slow))
      call suite%addTest(TestMethod('two_at_a_time', test_two_at_a_time))
   end function picture_drawing_suite

   !> Control bytes become blanks, what is not UTF-8 becomes '?', byte by byte; all else stays.
   subroutine test_printable()
      integer :: i
      do i = 0, 255
         select case (i)
         case (0:31, 127); call assertEqual('a b', plain_utf8('a'//achar(i)//'b'), message=to_text(i))
         case (32:126); call assertEqual('a'//achar(i)//'b', plain_utf8('a'//achar(i)//'b'), message=to_text(i))
         case default; call assertEqual('a?b', plain_utf8('a'//char(i)//'b'), message=to_text(i))
         end select
      end do
      call assertEqual(umlaut//sum_sign, plain_utf8(umlaut//sum_sign))
      call assertEqual('?', plain_utf8(umlaut(1:1)), message='cut')
      call assertEqual('???', plain_utf8(bytes([224, 128, 128])), message='longer than need be')
      call assertEqual('???', plain_utf8(bytes([237, 160, 128])), message='half of a pair')
      call assertEqual('???', plain_utf8(bytes([239, 191, 191])), message='no character')
      call assertEqual(bytes([239, 191, 189]), plain_utf8(bytes([239, 191, 189])))
      call assertEqual(bytes([240, 159, 152, 128]), plain_utf8(bytes([240, 159, 152, 128])))
      call assertEqual('????', plain_utf8(bytes([244, 144, 128, 128])), message='beyond the last')
   end subroutine test_printable

   subroutine test_cut()
      call assertEqual('abcdef', cut_text('abcdef', 6))
      call assertEqual('abc...', cut_text('abcdefg', 6))
      call assertEqual(umlaut//umlaut//'...', cut_text(repeat(umlaut, 6), 5), message='letters, not bytes')
      call assertEqual(repeat(umlaut, 6), cut_text(repeat(umlaut, 6), 6))
      call assertEqual('', cut_text('', 6))
      call assertEqual("'100%%' 1, 'b' 2", row_tics([text_type('100%'), text_type('b')], 0.5_wp, 1000), message='no format')
   end subroutine test_cut

   !> Whatever bytes stand in a text and beside each other, gnuplot has it as plain_utf8 has it, and runs nothing of it.
   subroutine test_all_bytes()
      character(*), parameter :: special = '''"`@\#%{}$()[],;!<>|.*x '
      type(text_type), allocatable :: texts(:), script(:), printed(:)
      integer :: i, k
      do i = 0, 255
         call append_text(texts, char(i))
         call append_text(texts, char(i)//char(i)//'x'//char(i))
      end do
      do i = 1, len(special)
         do k = 1, len(special)
            call append_text(texts, special(i:i)//special(k:k)//'x')
            call append_text(texts, 'x'//special(i:i)//special(k:k)//special(i:i)//special(k:k))
         end do
      end do
      call append_text(texts, umlaut//"'"//sum_sign)
      call append_text(texts, '`touch made`$(touch made)')
      call append_text(texts, "'.system(""touch made"").'`touch made`@x"//achar(10)//'system "touch made"')
      call append_text(script, "x = 'expanded'")
      do i = 1, size(texts)
         call append_text(script, 'print '//spelled(texts(i)%text))
      end do
      call run_true_gnuplot(script, printed)
      call assertEqual(size(texts), size(printed))
      do i = 1, min(size(texts), size(printed))
         call assertEqual(plain_utf8(texts(i)%text), printed(i)%text, message=spelled(texts(i)%text))
      end do
      call assertFalse(is_file('made'))
      call assertEqual("'x]])'", spelled('x]]>'), message='would end what is no XML in the picture')
   end subroutine test_all_bytes

   subroutine test_exit_status()
      type(child_type) :: child
      type(error_type), allocatable :: error
      child = run_shell('exit 7')
      call assertFalse(child%running)
      call assertEqual(7, child%exit_status)
      child = run_shell('kill -KILL $$')
      call assertEqual(128 + 9, child%exit_status)
      call assertEqual('', find_program('no such program'))
      call make_folder(folder, error)
      call start_child(child, '/no/such/program', [text_type ::], folder, 'output', [character(1) ::], error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertEqual(1, index(error%message, 'cannot start /no/such/program in '//folder//': '))
      call assertFalse(child%running)
   end subroutine test_exit_status

   !> The child sees what this program sees, but for what is hidden from it; it stands in its folder and reads nothing.
   subroutine test_environment()
      type(child_type) :: child
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure
      integer(c_int) :: status
      status = c_setenv(c_text('HIDDEN_ONE'), c_text('1'), 1_c_int)
      status = c_setenv(c_text('SEEN_ONE'), c_text('2'), 1_c_int)
      child = run_shell('echo "$HIDDEN_ONE,$SEEN_ONE,$HOME"; cat; pwd')
      call assertEqual(0, child%exit_status)
      call read_lines(folder//'/output', lines, failure)
      call assertEqual(2, size(lines))
      if (size(lines) < 2) return
      call assertTrue(index(lines(1)%text, ',2,/') == 1, message=lines(1)%text)
      call assertTrue(index(lines(2)%text, folder) > 0, message=lines(2)%text)
   end subroutine test_environment

   !> One that does not heed a request to end is ended all the same.
   subroutine test_stubborn_child()
      type(child_type) :: child
      child = run_shell('trap "" TERM; sleep 1000 & sleep 1000; sleep 1000', 0.2_wp)
      call assertTrue(child%running)
      call end_child(child)
      call assertFalse(child%running)
      call assertEqual(128 + 9, child%exit_status)
   end subroutine test_stubborn_child

   !> A picture that is cut, and one of a script that fails, do not get their names; the others do.
   subroutine test_whole_only()
      type(error_type), allocatable :: error
      logical :: drawn(3)
      call draw('for n in $names; do case $n in a) whole a;; b) whole b; exit 1;; c) cut c;; esac; done', long, drawn, error)
      call assertTrue(all(drawn .eqv. [.true., .false., .false.]))
      call assertTrue(allocated(error))
      if (allocated(error)) call assertTrue(index(error%message, '1 of 3 pictures') > 0 .and. &
                                            index(error%message, ', b is not; gnuplot.log') > 0, message=error%message)
      call assertTrue(is_file('a.svg') .and. .not. (is_file('b.svg') .or. is_file('c.svg')))
      call assertFalse(is_file('b.svg.unfinished') .or. is_file('c.svg.unfinished'))
      call draw('for n in $names; do whole $n; done', long, drawn, error)
      call assertTrue(all(drawn) .and. .not. allocated(error))
      call assertFalse(is_file('gnuplot.log'))
   end subroutine test_whole_only

   !> Keep pictures that were drawn before a gnuplot hangs.
   subroutine test_hangs()
      type(error_type), allocatable :: error
      logical :: drawn(3)
      call draw('for n in $names; do case $n in a) whole a;; *) cut $n; sleep 1000;; esac; done', 1.0_wp, drawn, error)
      call assertTrue(all(drawn .eqv. [.true., .false., .false.]))
      call assertTrue(allocated(error))
      if (allocated(error)) call assertTrue(index(error%message, 'drew nothing for 1 s and was ended: 1 of 3') > 0 &
                                            .and. index(error%message, ' b.gp ') > 0, message=error%message)
      call assertFalse(is_file('b.svg') .or. is_file('b.svg.unfinished'))
      call draw('for n in $names; do whole $n; done; sleep 1000', 1.0_wp, drawn, error)
      call assertTrue(all(drawn) .and. .not. allocated(error), message='it hangs when all is done')
   end subroutine test_hangs

   !> Patience is for each picture, not for all.
   subroutine test_slow()
      type(error_type), allocatable :: error
      logical :: drawn(6)
      call draw('for n in $names; do sleep 0.5; whole $n; done', 2.5_wp, drawn, error)
      call assertTrue(all(drawn) .and. .not. allocated(error))
   end subroutine test_slow

   !> At most two gnuplots run at a time, each with a share of the pictures, and they do run at the same time.
   subroutine test_two_at_a_time()
      type(error_type), allocatable :: error
      character(:), allocatable :: failure
      type(text_type), allocatable :: lines(:)
      logical :: drawn(120)
      integer :: i, together
      call delete_file(folder//'/seen')
      call draw('echo $names | wc -w > share.$$; sleep 1; cat share.* | wc -l >> seen; for n in $names; do whole $n; done; '// &
                'rm share.$$', long, drawn, error)
      call assertTrue(all(drawn) .and. .not. allocated(error))
      call read_lines(folder//'/seen', lines, failure)
      call assertEqual(4, size(lines), message='no more than 50 pictures a share')
      together = 0
      do i = 1, size(lines)
         if (lines(i)%text == '2') together = together + 1
         call assertTrue(lines(i)%text == '1' .or. lines(i)%text == '2', message=lines(i)%text)
      end do
      call assertTrue(together > 0)
   end subroutine test_two_at_a_time

   !> Draws pictures a, b, c, or more of them by number, by a gnuplot that is a shell script of one line, which has their names in
   !> $names; `whole NAME` there makes a picture, `cut NAME` half of one.
   subroutine draw(line, patience, drawn, error)
      character(*), intent(in) :: line
      real(wp), intent(in) :: patience
      logical, intent(out) :: drawn(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: script(4), names(size(drawn))
      integer :: i
      do i = 1, size(names)
         names(i)%text = to_text(i)
         if (size(names) <= 3) names(i)%text = achar(iachar('a') + i - 1)
      end do
      script(1)%text = '#!/bin/sh'
      script(2)%text = 'names=; for a; do case $a in *.gp) names="$names ${a%.gp}";; esac; done'
      script(3)%text = 'whole() { echo "<svg></svg>" > $1.svg.unfinished; }; cut() { echo "<svg>" > $1.svg.unfinished; }'
      script(4)%text = line
      call make_folder(folder, error)
      if (.not. allocated(error)) call write_text_file(folder//'/gnuplot', script, error)
      if (allocated(error)) return
      call execute_command_line('chmod +x '//folder//'/gnuplot')
      call draw_pictures('./gnuplot', folder, names, patience, drawn, error)
   end subroutine draw

   !> Runs a line by a shell, for a time or until it ends.
   function run_shell(line, seconds) result(child)
      character(*), intent(in) :: line
      real(wp), intent(in), optional :: seconds
      type(child_type) :: child
      type(error_type), allocatable :: error
      call make_folder(folder, error)
      call delete_file(folder//'/output')
      call start_child(child, find_program('sh'), text_list('-c', line), folder, 'output', ['HIDDEN_'], error)
      call assertFalse(allocated(error))
      if (present(seconds)) then
         call wait_for_child(child, seconds)
      else
         call wait_for_child(child, long)
      end if
   end function run_shell

   !> Output of gnuplot when it runs a script.
   subroutine run_true_gnuplot(script, printed)
      type(text_type), intent(in) :: script(:)
      type(text_type), allocatable, intent(out) :: printed(:)
      type(child_type) :: child
      type(error_type), allocatable :: error
      character(:), allocatable :: failure
      allocate (printed(0))
      call make_folder(folder, error)
      call delete_file(folder//'/output')
      call write_text_file(folder//'/script.gp', script, error)
      if (.not. allocated(error)) call start_child(child, find_program('gnuplot'), [text_type('-d'), text_type('script.gp')], &
                                                   folder, 'output', ['GNU'], error)
      call assertFalse(allocated(error), message='gnuplot must be there')
      if (allocated(error)) return
      call wait_for_child(child, long)
      call assertEqual(0, child%exit_status)
      call end_child(child)
      call read_lines(folder//'/output', printed, failure)
   end subroutine run_true_gnuplot

   function is_file(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      inquire (file=folder//'/'//name, exist=is)
   end function is_file

   pure function bytes(codes) result(text)
      integer, intent(in) :: codes(:)
      character(size(codes)) :: text
      integer :: i
      do i = 1, size(codes)
         text(i:i) = char(codes(i))
      end do
   end function bytes
end module dg_test_picture_drawing

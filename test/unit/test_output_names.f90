!> Names and texts of output: which names a run may remove, names of files while they are written, texts for a terminal.
module dg_test_output_names
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_file_identity, only: identity_of, identity_of_link, is_same_file
   use dg_file_system, only: finished_name, unfinished_name
   use dg_printable, only: printable
   use dg_result_name, only: case_file, is_record_name, is_result_name, profile_file, record_file
   use dg_text, only: text_list, text_type
   implicit none
   private
   public :: output_names_suite

contains

   function output_names_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('output_names')
      call suite%addTest(TestMethod('results', test_results))
      call suite%addTest(TestMethod('records', test_records))
      call suite%addTest(TestMethod('unfinished', test_unfinished))
      call suite%addTest(TestMethod('printable_bytes', test_printable))
      call suite%addTest(TestMethod('printable_letters', test_letters))
      call suite%addTest(TestMethod('identity', test_identity))
   end function output_names_suite

   subroutine test_results()
      type(text_type), allocatable :: forms(:)
      allocate (forms, source=text_list('study.csv', 'sweep_*.csv'))
      call assertTrue(is_result_name('study.csv', forms))
      call assertTrue(is_result_name('sweep_a.csv', forms))
      call assertFalse(is_result_name('legacy_a.csv', forms))
      call assertTrue(is_result_name('summary.csv', forms))
      call assertTrue(is_result_name(case_file(profile_file, 'a.b+c-1', 2), forms))
      call assertTrue(is_result_name('view_'//repeat('x', 100)//'_mixed.hdf', forms))
      call assertTrue(is_result_name('pictures/all.gp', forms))
      call assertTrue(is_result_name('pictures/path_a.svg', forms))
      call assertFalse(is_result_name('', forms))
      call assertFalse(is_result_name('.', forms))
      call assertFalse(is_result_name('notes.csv', forms))
      call assertFalse(is_result_name('../summary.csv', forms))
      call assertFalse(is_result_name('/summary.csv', forms))
      call assertFalse(is_result_name('x/summary.csv', forms))
      call assertFalse(is_result_name('summary.csv ', forms))
      call assertFalse(is_result_name('profile_a_other.csv', forms))
      call assertFalse(is_result_name('profile__soft.csv/', forms))
      call assertFalse(is_result_name('profile_/../x_soft.csv', forms))
      call assertFalse(is_result_name('sweep_.csv', forms))
      call assertFalse(is_result_name('sweep_a.csv'//achar(10), forms))
      call assertFalse(is_result_name('sweep_s.partial', forms))
      call assertFalse(is_result_name('pictures/.svg', forms))
      call assertFalse(is_result_name('pictures/../x.svg', forms))
      call assertFalse(is_result_name('pictures/a/b.svg', forms))
      call assertFalse(is_result_name('pictures/notes.txt', forms))
      call assertFalse(is_result_name('pictures', forms))
      call assertFalse(is_result_name('sweep_'//repeat('x', 300)//'.csv', forms))
   end subroutine test_results

   subroutine test_records()
      type(text_type), allocatable :: kinds(:)
      allocate (kinds, source=text_list('sweep', 'uncertainty'))
      call assertTrue(is_record_name(record_file('sweep', 's', 1, 0), kinds))
      call assertTrue(is_record_name(record_file('uncertainty', 'u', 12, 9999), kinds))
      call assertFalse(is_record_name('sweep_s.csv', kinds))
      call assertFalse(is_record_name('sweep_s.part_1_of_', kinds))
      call assertFalse(is_record_name('sweep_s.part_x_of_2', kinds))
      call assertFalse(is_record_name('other.partial', kinds))
      call assertFalse(is_record_name('sweep_/s.partial', kinds))
   end subroutine test_records

   !> No name comes twice; the name that a file is to have can be told from it.
   subroutine test_unfinished()
      character(:), allocatable :: first
      first = unfinished_name('out/summary.csv')
      call assertTrue(index(first, 'out/summary.csv.') == 1, message=first)
      call assertEqual('out/summary.csv', finished_name(first))
      call assertTrue(first /= unfinished_name('out/summary.csv'), message=first)
      call assertEqual('', finished_name('summary.csv'))
      call assertEqual('', finished_name('.unfinished'))
      call assertEqual('', finished_name('summary.csv.unfinished'))
      call assertEqual('', finished_name('summary.csv.12.unfinished'))
      call assertEqual('', finished_name('summary.csv.12-x.unfinished'))
      call assertEqual('', finished_name('summary.csv.-12.unfinished'))
      call assertEqual('', finished_name('.1-2.unfinished'))
   end subroutine test_unfinished

   !> Of all bytes those below the blank, DEL and C1 go, others stay; what is to be kept stays.
   subroutine test_printable()
      integer :: i
      character(3) :: text, shown
      do i = 0, 255
         text = 'a'//char(i)//'b'
         shown = printable(text, achar(9))
         if ((i < 32 .and. i /= 9) .or. (i >= 127 .and. i <= 159)) text(2:2) = '?'
         call assertTrue(shown == text, message=shown)
      end do
      call assertEqual('', printable('', ''))
   end subroutine test_printable

   !> Letters in UTF-8 of two to four bytes; commands in UTF-8; texts that are cut in a letter.
   subroutine test_letters()
      character(*), parameter :: e = char(195)//char(169), han = char(228)//char(184)//char(173), &
                                 face = char(240)//char(159)//char(152)//char(128)
      integer :: i
      call assertEqual(e//han//face, printable(e//han//face, ''))
      do i = 128, 159
         call assertEqual('x??y', printable('x'//char(194)//char(i)//'y', ''))
      end do
      call assertEqual(char(194)//char(160), printable(char(194)//char(160), ''))
      call assertEqual(char(240)//'??', printable(face(:3), ''))
      call assertEqual(han(:1)//'?', printable(han(:1)//achar(27), ''))
   end subroutine test_letters

   !> One file by two ways, and two files.
   subroutine test_identity()
      call assertTrue(is_same_file(identity_of('/proc'), identity_of('/./proc/../proc/')))
      call assertFalse(is_same_file(identity_of('/proc'), identity_of('/dev')))
      call assertFalse(is_same_file(identity_of('/absent'), identity_of('/absent')))
      associate (link => identity_of_link('/proc/self'), folder => identity_of('/proc/self'), device => identity_of('/dev/null'))
         call assertTrue(link%is_link .and. .not. link%is_folder)
         call assertTrue(folder%is_folder .and. .not. folder%is_link)
         call assertTrue(device%exists .and. .not. device%is_regular)
      end associate
   end subroutine test_identity
end module dg_test_output_names

!> Lists of parts, and what is told of parts that cannot be joined.
module dg_test_part_list
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_part_faults, only: faults_text, note_part, part_broken, part_faults_type, part_missing, part_unfinished, part_whole, &
                             start_faults
   use dg_part_list, only: part_list_text, read_part_list
   use dg_text, only: to_text
   implicit none
   private
   public :: part_list_suite

contains

   function part_list_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('part_list')
      call suite%addTest(TestMethod('lists', test_lists))
      call suite%addTest(TestMethod('refused_lists', test_refused))
      call suite%addTest(TestMethod('every_list_as_text_and_back', test_back))
      call suite%addTest(TestMethod('faults', test_faults))
      call suite%addTest(TestMethod('many_faults', test_many_faults))
   end function part_list_suite

   subroutine test_lists()
      call check_part('2/4', [2], 4)
      call check_part('3,7-9/40', [3, 7, 8, 9], 40)
      call check_part('7-9,3/40', [3, 7, 8, 9], 40)
      call check_part('5-5,01/0007', [1, 5], 7)
      call check_part('9999/9999', [9999], 9999)
      call check_part('1-2/2', [1, 2], 2)
   contains
      subroutine check_part(text, wanted, wanted_parts)
         character(*), intent(in) :: text
         integer, intent(in) :: wanted(:), wanted_parts
         integer, allocatable :: chosen(:)
         character(:), allocatable :: failure
         integer :: parts
         call read_part_list(text, chosen, parts, failure)
         call assertEqual('', failure, message=text)
         call assertEqual(wanted_parts, parts, message=text)
         call assertEqual(wanted, chosen, message=text)
      end subroutine check_part
   end subroutine test_lists

   subroutine test_refused()
      call refuse('3,,7', 'it has no /')
      call refuse('', 'it has no /')
      call refuse('3,,7/9', 'a number lacks')
      call refuse(',3/9', 'a number lacks')
      call refuse('3,/9', 'a number lacks')
      call refuse('/4', 'a number lacks')
      call refuse('3/', "'' is not a number of parts, 1 to 9999")
      call refuse('3/0', "'0' is not a number of parts, 1 to 9999")
      call refuse('3/4/5', "'4/5' is not a number of parts, 1 to 9999")
      call refuse('1/10000', "'10000' is not a number of parts, 1 to 9999")
      call refuse('9-7/40', '9-7 runs backwards')
      call refuse('41/40', 'there is no part 41 of 40')
      call refuse('39-41/40', 'there is no part 41 of 40')
      call refuse('0/40', "'0' is neither a number nor a range")
      call refuse('0-3/40', "'0-3' is neither a number nor a range")
      call refuse('1-2-3/4', "'1-2-3' is neither a number nor a range")
      call refuse('-3/4', "'-3' is neither a number nor a range")
      call refuse('3-/4', "'3-' is neither a number nor a range")
      call refuse('-/4', "'-' is neither a number nor a range")
      call refuse('1, 2/4', "' 2' is neither a number nor a range")
      call refuse('1.5/4', "'1.5' is neither a number nor a range")
      call refuse('2,2/4', 'part 2 is there twice')
      call refuse('3,1-4/4', 'part 3 is there twice')
   contains
      subroutine refuse(text, wanted)
         character(*), intent(in) :: text, wanted
         integer, allocatable :: chosen(:)
         character(:), allocatable :: failure
         integer :: parts
         call read_part_list(text, chosen, parts, failure)
         call assertEqual(wanted, failure, message=text)
         call assertEqual(0, size(chosen), message=text)
      end subroutine refuse
   end subroutine test_refused

   !> Every subset of eight parts.
   subroutine test_back()
      integer, parameter :: parts = 8
      integer, allocatable :: wanted(:), chosen(:)
      character(:), allocatable :: failure
      integer :: set, found, i
      call assertEqual('', part_list_text([integer ::]))
      call assertEqual('3,7-9', part_list_text([3, 7, 8, 9]))
      do set = 1, 2**parts - 1
         wanted = pack([(i, i=1, parts)], [(btest(set, i - 1), i=1, parts)])
         call read_part_list(part_list_text(wanted)//'/'//to_text(parts), chosen, found, failure)
         call assertEqual('', failure)
         call assertEqual(wanted, chosen)
      end do
   end subroutine test_back

   !> Two sweeps in five parts.
   subroutine test_faults()
      character(*), parameter :: newline = achar(10)
      type(part_faults_type) :: faults
      call start_faults(faults, 5)
      call note_part(faults, 1, part_whole, 'a1', '')
      call note_part(faults, 2, part_missing, 'a2', 'it is missing')
      call assertEqual('the 5 parts are not complete; missing: 2'//newline// &
                       '  a2: it is missing; run --part 2/5'//newline//'  --part 2/5 runs them', faults_text(faults))
      call note_part(faults, 3, part_broken, 'a3', 'line 9 is damaged')
      call note_part(faults, 4, part_unfinished, 'a4', 'it lacks 3 of its points')
      call note_part(faults, 5, part_whole, 'a5', '')
      call note_part(faults, 1, part_whole, 'b1', '')
      call note_part(faults, 2, part_missing, 'b2', 'it is missing')
      call note_part(faults, 3, part_missing, 'b3', 'it is missing')
      call note_part(faults, 4, part_missing, 'b4', 'it is missing')
      call note_part(faults, 5, part_missing, 'b5', 'it is missing')
      call assertEqual('the 5 parts are not complete; missing: 2; broken: 3; not finished: 4-5'//newline// &
                       '  a2: it is missing; run --part 2/5'//newline// &
                       '  a3: line 9 is damaged; remove it and run --part 3/5'//newline// &
                       '  a4: it lacks 3 of its points; go on with --part 4/5'//newline// &
                       '  b2: it is missing; run --part 2/5'//newline// &
                       '  b3: it is missing; run --part 3/5'//newline// &
                       '  b4: it is missing; run --part 4/5'//newline// &
                       '  b5: it is missing; run --part 5/5'//newline// &
                       '  --part 2-5/5 runs them again once the broken files are removed', faults_text(faults))
   end subroutine test_faults

   !> Thousands of parts that lack are all named by number, and few by file.
   subroutine test_many_faults()
      type(part_faults_type) :: faults
      character(:), allocatable :: text
      integer :: part
      call start_faults(faults, 9999)
      call assertEqual('', faults_text(faults))
      do part = 1, 9999
         call note_part(faults, part, merge(part_whole, part_missing, part == 77), 'p', 'it is missing')
      end do
      text = faults_text(faults)
      call assertTrue(index(text, '; missing: 1-76,78-9999') > 0, message=text)
      call assertTrue(index(text, '  and 9978 more') > 0, message=text)
      call assertTrue(index(text, '--part 1-76,78-9999/9999 runs them') > 0, message=text)
   end subroutine test_many_faults
end module dg_test_part_list

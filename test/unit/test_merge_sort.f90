!> Order of numbers and equal texts.
module dg_test_merge_sort
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_kinds, only: wp
   use dg_merge_sort, only: first_equal, sorted_places
   use dg_text, only: text_type
   implicit none
   private
   public :: merge_sort_suite

contains

   function merge_sort_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('merge_sort')
      call suite%addTest(TestMethod('numbers', test_numbers))
      call suite%addTest(TestMethod('texts', test_texts))
   end function merge_sort_suite

   !> Lists of 0 to 33 numbers, many of them equal, come in ascending order; equal numbers keep the order of the list.
   subroutine test_numbers()
      real(wp) :: numbers(33)
      integer :: order(33)
      integer :: i, n
      numbers = [(real(modulo(7*i, 11), wp), i=1, size(numbers))]
      do n = 0, size(numbers)
         order(:n) = sorted_places(numbers(:n))
         call assertEqual(n*(n + 1)/2, sum(order(:n)), message='each place once')
         do i = 2, n
            associate (before => order(i - 1), this => order(i))
               call assertTrue(numbers(before) < numbers(this) .or. (numbers(before) <= numbers(this) .and. before < this))
            end associate
         end do
      end do
   end subroutine test_numbers

   !> The first equal text; blanks at the end do not count, and an empty text is a text.
   subroutine test_texts()
      character(*), parameter :: words(7) = [character(3) :: 'b', 'a', '', 'b', 'ab', '', 'a']
      type(text_type) :: texts(size(words))
      integer :: i
      do i = 1, size(words)
         texts(i)%text = trim(words(i))
      end do
      call assertEqual([1, 2, 3, 1, 5, 3, 2], first_equal(texts))
      texts(7)%text = 'a '
      call assertEqual([1, 2, 3, 1, 5, 3, 2], first_equal(texts))
   end subroutine test_texts
end module dg_test_merge_sort

!> Order of numbers and of texts by merging sorted runs: n log n comparisons, where all pairs are n^2.
module dg_merge_sort
   use dg_kinds, only: wp
   use dg_text, only: text_type
   implicit none
   private
   public :: first_equal, sorted_places

contains

   !> Place of the first text of the list that is equal to each text.
   pure function first_equal(texts) result(first)
      type(text_type), intent(in) :: texts(:)
      integer :: first(size(texts))
      integer :: order(size(texts))
      integer :: i
      call sort(size(texts), order, texts=texts)
      first = [(i, i=1, size(texts))]
      do i = 2, size(texts)
         if (texts(order(i))%text == texts(order(i - 1))%text) first(order(i)) = first(order(i - 1))
      end do
   end function first_equal

   !> Places of numbers in ascending order; equal numbers keep the order of the list.
   pure function sorted_places(numbers) result(order)
      real(wp), intent(in) :: numbers(:)
      integer :: order(size(numbers))
      call sort(size(numbers), order, numbers=numbers)
   end function sorted_places

   !> Places of numbers, or of texts, in ascending order.
   pure subroutine sort(n, order, numbers, texts)
      integer, intent(in) :: n
      integer, intent(out) :: order(n)
      real(wp), intent(in), optional :: numbers(:)
      type(text_type), intent(in), optional :: texts(:)
      integer :: both(n)                ! pairs of runs, merged
      integer :: low, width, i
      order = [(i, i=1, n)]
      width = 1
      do while (width < n)
         do low = 1, n, 2*width
            call merge_runs(low, min(low + width - 1, n), min(low + 2*width - 1, n), both)
         end do
         order = both
         width = 2*width
      end do

   contains

      !> Merges the sorted runs low to middle and middle + 1 to high.
      pure subroutine merge_runs(low, middle, high, merged)
         integer, intent(in) :: low, middle, high
         integer, intent(inout) :: merged(:)
         integer :: left, right, place
         logical :: from_left
         left = low
         right = middle + 1
         do place = low, high
            from_left = left <= middle
            if (from_left .and. right <= high) from_left = in_order(order(left), order(right))
            if (from_left) then
               merged(place) = order(left)
               left = left + 1
            else
               merged(place) = order(right)
               right = right + 1
            end if
         end do
      end subroutine merge_runs

      !> True if the first of two places may stand before the second.
      pure function in_order(first, second) result(is)
         integer, intent(in) :: first, second
         logical :: is
         if (present(numbers)) then
            is = numbers(first) <= numbers(second)
         else
            is = texts(first)%text <= texts(second)%text
         end if
      end function in_order
   end subroutine sort
end module dg_merge_sort

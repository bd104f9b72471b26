!> Text of failure messages.
module funit_text
   use, intrinsic :: iso_fortran_env, only: int64, real64
   implicit none
   private
   public :: text_of, position_text, complaint

   interface text_of
      module procedure text_of_real, text_of_integer, text_of_logical
   end interface text_of

contains

   !> Seventeen digits: two different numbers never look the same.
   function text_of_real(value) result(text)
      real(real64), intent(in) :: value
      character(:), allocatable :: text
      character(30) :: buffer
      write (buffer, '(es26.16e3)') value
      text = trim(adjustl(buffer))
   end function text_of_real

   function text_of_integer(value) result(text)
      integer(int64), intent(in) :: value
      character(:), allocatable :: text
      character(30) :: buffer
      write (buffer, '(i0)') value
      text = trim(buffer)
   end function text_of_integer

   function text_of_logical(value) result(text)
      logical, intent(in) :: value
      character(:), allocatable :: text
      text = merge('true ', 'false', value)
      text = trim(text)
   end function text_of_logical

   !> Place of element `k` (in array element order) of an array of that shape; '' for a scalar.
   function position_text(k, extents) result(text)
      integer, intent(in) :: k
      integer, intent(in) :: extents(:)
      character(:), allocatable :: text
      integer :: d, rest
      text = ''
      if (size(extents) == 0) return
      rest = k - 1
      text = ' at ('
      do d = 1, size(extents)
         if (d > 1) text = text//','
         text = text//text_of(int(1 + mod(rest, extents(d)), int64))
         rest = rest/extents(d)
      end do
      text = text//')'
   end function position_text

   !> One failure in words.
   function complaint(expected, actual, difference, place, message) result(text)
      character(*), intent(in) :: expected
      character(*), intent(in) :: actual
      character(*), intent(in) :: difference !< '' where there is none
      character(*), intent(in) :: place      !< from position_text
      character(*), intent(in), optional :: message
      character(:), allocatable :: text
      text = ''
      if (present(message)) text = message//': '
      text = text//'Expected: <'//expected//'>; Actual: <'//actual//'>'
      if (difference /= '') text = text//'; Difference: <'//difference//'>'
      text = text//place
   end function complaint
end module funit_text

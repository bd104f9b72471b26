!> Names and words as people read them in a sentence.
module dg_readable
   use dg_text, only: letter_end, lower_case, text_type, to_text
   implicit none
   private
   public :: spaced, squeezed, capital, cut_text, first_names

contains

   !> The first names of a list: 'A, B and 3 more'.
   pure function first_names(names, most) result(text)
      type(text_type), intent(in) :: names(:)
      integer, intent(in) :: most          !< number of names that are given
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, min(size(names), most)
         if (i > 1) text = text//', '
         text = text//names(i)%text
      end do
      if (size(names) > most) text = text//' and '//to_text(size(names) - most)//' more'
   end function first_names

   !> A name as words: blanks for '_'.
   pure function spaced(name) result(text)
      character(*), intent(in) :: name
      character(len(name)) :: text
      integer :: i
      text = name
      do i = 1, len(name)
         if (name(i:i) == '_') text(i:i) = ' '
      end do
   end function spaced

   !> Small letters without blanks, tabs and the letters of `also`.
   pure function squeezed(text, also) result(tight)
      character(*), intent(in) :: text, also
      character(:), allocatable :: tight
      integer :: i
      tight = ''
      do i = 1, len(text)
         if (scan(text(i:i), ' '//achar(9)//also) == 0) tight = tight//lower_case(text(i:i))
      end do
   end function squeezed

   !> A text as a sentence begins.
   pure function capital(text) result(sentence)
      character(*), intent(in) :: text
      character(len(text)) :: sentence
      integer, parameter :: apart = iachar('a') - iachar('A')
      sentence = text
      if (text(:1) >= 'a' .and. text(:1) <= 'z') sentence(:1) = achar(iachar(text(:1)) - apart)
   end function capital

   !> A text of at most `most` letters: of a longer one the beginning and '...'.
   pure function cut_text(text, most) result(short)
      character(*), intent(in) :: text
      integer, intent(in) :: most
      character(:), allocatable :: short
      integer :: letters, last, kept
      letters = 0
      kept = 0
      last = 0
      do while (last < len(text))
         letters = letters + 1
         if (letters > most) then
            short = text(:kept)//'...'
            return
         end if
         last = max(last + 1, letter_end(text, last + 1))
         if (letters == most - len('...')) kept = last
      end do
      short = text
   end function cut_text
end module dg_readable

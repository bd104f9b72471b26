!> Names and words as people read them in a sentence.
module dg_readable
   implicit none
   private
   public :: spaced, capital

contains

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

   !> A text as a sentence begins.
   pure function capital(text) result(sentence)
      character(*), intent(in) :: text
      character(len(text)) :: sentence
      integer, parameter :: apart = iachar('a') - iachar('A')
      sentence = text
      if (text(:1) >= 'a' .and. text(:1) <= 'z') sentence(:1) = achar(iachar(text(:1)) - apart)
   end function capital
end module dg_readable

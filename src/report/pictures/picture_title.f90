!> Titles of pictures, in words, in the place of the names that gnuplot gives: browsers show titles, screen readers read them.
module dg_picture_title
   use dg_error, only: error_type
   use dg_file_lines, only: read_lines
   use dg_file_system, only: write_text_file
   use dg_markup, only: html_safe
   use dg_text, only: text_type
   implicit none
   private
   public :: write_title

   character(*), parameter :: opening = '<title>', closing = '</title>'

contains

   !> Writes a picture anew with `title` as that of the whole, and without titles of its curves. A file that cannot be read, or has
   !> no title, stays as it is. `error` where the new one cannot be written.
   subroutine write_title(path, title, error)
      character(*), intent(in) :: path
      character(*), intent(in) :: title
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: failure, own
      integer :: i, first, last
      allocate (lines(0))
      call read_lines(path, lines, failure)
      own = opening//html_safe(title)//closing
      do i = 1, size(lines)
         first = index(lines(i)%text, opening)
         last = index(lines(i)%text, closing)
         if (first == 0 .or. last < first) cycle
         lines(i)%text = lines(i)%text(:first - 1)//own//lines(i)%text(last + len(closing):)
         own = ''
      end do
      if (own == '') call write_text_file(path, lines, error)
   end subroutine write_title
end module dg_picture_title

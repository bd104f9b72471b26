!> Looks of curves in gnuplot's words. Colours are those of Okabe & Ito (2008), which colour-blind readers tell apart; dashes and
!> marks differ too, for print in black and white.
module dg_curve_look
   use dg_kinds, only: wp
   use dg_text, only: to_text
   implicit none
   private
   public :: colour_of, dash_of, line_style, mark_style, marked_line_style, band_look
   public :: look_part, style_count, colour_grey, colour_black, colour_white, limit_dash, letter_width

   !> Looks that differ. The next curve looks like the first again.
   integer, parameter :: style_count = 7
   character(*), parameter :: colours(style_count) = [character(7) :: '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', &
      '#56B4E9', '#000000']
   character(*), parameter :: dashes(style_count) = [character(14) :: '1', '(12,4)', '(3,3)', '(12,4,3,4)', '(20,5)', '(6,3)', &
      '(12,3,3,3,3,3)']
   integer, parameter :: marks(style_count) = [7, 5, 9, 13, 11, 15, 3]
   !> Black is also the colour of measured values, whatever the curves.
   character(*), parameter :: colour_grey = '#999999', colour_black = '#000000', colour_white = '#ffffff'
   !> Of limits, whatever the curves.
   character(*), parameter :: limit_dash = '(3,3)'
   !> Width of a letter of the font [px], a little more than the mean.
   real(wp), parameter :: letter_width = 8.0_wp
   integer, parameter :: digits = 8

contains

   !> Colour, dash and mark of the n-th of several curves.
   pure function colour_of(n) result(text)
      integer, intent(in) :: n
      character(:), allocatable :: text
      text = trim(colours(1 + mod(n - 1, style_count)))
   end function colour_of

   !> Dash of the n-th of several curves.
   pure function dash_of(n) result(text)
      integer, intent(in) :: n
      character(:), allocatable :: text
      text = trim(dashes(1 + mod(n - 1, style_count)))
   end function dash_of

   !> Mark of the n-th of several curves, gnuplot's number.
   pure function mark_of(n) result(number)
      integer, intent(in) :: n
      integer :: number
      number = marks(1 + mod(n - 1, style_count))
   end function mark_of

   !> Look of the n-th of several lines.
   pure function line_style(n) result(look)
      integer, intent(in) :: n
      character(:), allocatable :: look
      look = "with lines lw 1.8 lc rgb '"//colour_of(n)//"' dt "//dash_of(n)
   end function line_style

   !> Look of the n-th of several kinds of points; `size` 1 is gnuplot's own.
   pure function mark_style(n, size) result(look)
      integer, intent(in) :: n
      real(wp), intent(in) :: size
      character(:), allocatable :: look
      look = 'with points pt '//to_text(mark_of(n))//' ps '//to_text(size, digits)//" lc rgb '"//colour_of(n)//"'"
   end function mark_style

   !> Look of the n-th of several lines with its marks here and there, for print without colours: in a panel of `points` points.
   pure function marked_line_style(n, points, width, dash) result(look)
      integer, intent(in) :: n, points
      real(wp), intent(in) :: width          !< of the line; 1 is gnuplot's own
      character(*), intent(in) :: dash
      character(:), allocatable :: look
      integer, parameter :: marks_each = 8
      look = 'with linespoints lw '//to_text(width, digits)//' dt '//dash//' pt '//to_text(mark_of(n))//' ps 0.6 pi '// &
         to_text(max(1, points/marks_each))//" lc rgb '"//colour_of(n)//"'"
   end function marked_line_style

   !> Look of a band in a colour, light enough for a line of the same.
   pure function band_look(colour) result(look)
      character(*), intent(in) :: colour
      character(:), allocatable :: look
      look = "with filledcurves closed fs solid 0.35 noborder fc rgb '"//colour//"'"
   end function band_look

   !> Text behind a word of a look, without quotes; '' where the look lacks the word.
   pure function look_part(look, word) result(text)
      character(*), intent(in) :: look, word
      character(:), allocatable :: text
      integer :: first
      text = ''
      first = index(' '//look, ' '//word//' ')
      if (first == 0) return
      text = look(first + len(word) + 1:)//' '
      text = text(:index(text, ' ') - 1)
      if (index(text, "'") == 1) text = text(2:len(text) - 1)
   end function look_part
end module dg_curve_look

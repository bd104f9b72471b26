!> The common part of all pictures: lines of a gnuplot script, one look for all. Colours are those of Okabe & Ito (2008),
!> which colour-blind readers tell apart; dashes and marks differ too, for print in black and white.
!>
!> No text of a deck becomes part of a script but through `spelled`: gnuplot runs what stands in its scripts.
module dg_gnuplot_script
   use dg_kinds, only: wp
   use dg_text, only: append_text, letter_end, plain_utf8, text_type, to_text
   implicit none
   private
   public :: colour_of, dash_of, mark_of
   public :: start_script, end_script, panel, legend, plot, x_range, y_range, line_style, mark_style, marked_line_style, &
             row_tics, spelled, results_file, cut_text, style_count, series_type, add_series
   public :: colour_grey, colour_black, colour_measured, limit_dash, letter_width, ending_variable

   !> Different curves that can be told apart.
   integer, parameter :: style_count = 7
   character(*), parameter :: colours(style_count) = [character(7) :: '#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', &
      '#56B4E9', '#000000']
   character(*), parameter :: dashes(style_count) = [character(14) :: '1', '(12,4)', '(3,3)', '(12,4,3,4)', '(20,5)', '(6,3)', &
      '(12,3,3,3,3,3)']
   integer, parameter :: marks(style_count) = [7, 5, 9, 13, 11, 15, 3]
   character(*), parameter :: colour_grey = '#999999', colour_black = '#000000'
   !> Of measured points, whatever the curves.
   character(*), parameter :: colour_measured = '#000000'
   !> Of limits, whatever the curves.
   character(*), parameter :: limit_dash = '(3,3)'

   character(*), parameter :: font = 'sans-serif,12'
   !> Width of a letter of the font [px], a little more than the mean.
   real(wp), parameter :: letter_width = 8.0_wp
   !> Letters of a title: more would end beyond the picture.
   integer, parameter :: most_of_title = 200
   !> Variable of gnuplot that is put behind the name of the picture's file: drillgap draws under another name first. Not set where
   !> a script is run by hand.
   character(*), parameter :: ending_variable = 'unfinished'
   !> Longest label of a tic [bytes] with a '%' in it: gnuplot 5.4 takes it for a format, and cuts what it shows even in a letter.
   integer, parameter :: longest_format = 49
   !> Digits of a place or range in a script: finer than any picture.
   integer, parameter :: digits = 8

   !> One curve of a panel: what stands behind `plot`, and its name in the legend ('' for none).
   type :: series_type
      character(:), allocatable :: using   !< data and columns
      character(:), allocatable :: look    !< with ...
      character(:), allocatable :: title
   end type series_type

contains

   !> First lines of a script that draws `<name>.svg` [pixels at 96 dpi]; `name` is safe as a file's (is_separator_free).
   pure subroutine start_script(lines, name, width, height)
      type(text_type), allocatable, intent(out) :: lines(:)
      character(*), intent(in) :: name
      integer, intent(in) :: width, height
      allocate (lines(0))
      call append_text(lines, '# Draws '//name//'.svg again: gnuplot '//name//'.gp')
      call append_text(lines, 'reset')
      call append_text(lines, 'if (!exists('//spelled(ending_variable)//')) '//ending_variable//" = ''")
      call append_text(lines, "set terminal svg noenhanced size "//to_text(width)//','//to_text(height)// &
                       " dynamic font '"//font//"' background '#ffffff' name "//spelled(plain(name)))
      call append_text(lines, 'set output '//spelled(name//'.svg')//'.'//ending_variable)
      call append_text(lines, 'set encoding utf8')
      ! a row is never a comment, whatever name it begins with
      call append_text(lines, "set datafile separator ','; set datafile commentschars ''")
      call append_text(lines, 'set multiplot')
   end subroutine start_script

   !> Last lines of a script.
   pure subroutine end_script(lines)
      type(text_type), allocatable, intent(inout) :: lines(:)
      call append_text(lines, 'unset multiplot')
      call append_text(lines, 'unset output')
   end subroutine end_script

   !> Title and legend in a strip of their own, of parts of the picture's height, so that they never cover a curve.
   pure subroutine legend(lines, title, series, bottom, top)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: title
      type(series_type), intent(in) :: series(:)
      real(wp), intent(in) :: bottom, top
      type(series_type), allocatable :: empty(:)
      integer :: i
      allocate (empty, source=series)
      do i = 1, size(empty)
         empty(i)%using = 'NaN'
      end do
      call append_text(lines, 'unset border; unset tics; unset grid; unset xlabel; unset ylabel')
      call append_text(lines, 'set label 1 '//spelled(cut_text(title, most_of_title))//' at screen 0.012, screen '// &
                       to_text(top, digits)//" offset 0,1.1 left font ',14'")
      call margins(lines, 0.02_wp, 0.98_wp, bottom, top)
      call append_text(lines, 'set key center center horizontal Left reverse samplen 3 width 1')
      call append_text(lines, 'set xrange [0:1]; set yrange [0:1]')
      call plot(lines, empty)
      call append_text(lines, 'unset label 1; set key off')
      call append_text(lines, "set border 31 lw 0.8 lc rgb '#444444'; set grid lc rgb '#d8d8d8' lw 0.6")
      call append_text(lines, 'set xtics; set ytics; set tics nomirror; set autoscale')
   end subroutine legend

   !> Where the next panel stands, in parts of the picture, and what its axes are called.
   pure subroutine panel(lines, left, right, bottom, top, x_label, y_label)
      type(text_type), allocatable, intent(inout) :: lines(:)
      real(wp), intent(in) :: left, right, bottom, top
      character(*), intent(in) :: x_label
      character(*), intent(in) :: y_label   !< '': the axis of the panel to the left holds here too
      call margins(lines, left, right, bottom, top)
      call append_text(lines, 'set autoscale x; set xtics autofreq')
      call append_text(lines, 'set xlabel '//spelled(x_label))
      if (y_label == '') then
         call append_text(lines, "unset ylabel; set format y ''")
      else
         call append_text(lines, "set ylabel "//spelled(y_label)//"; set format y '% h'")
      end if
   end subroutine panel

   !> Range of the x axis of the panel [shown units], with round steps between its tics: five or as many as labels have room for.
   pure subroutine x_range(lines, low, high, room)
      type(text_type), allocatable, intent(inout) :: lines(:)
      real(wp), intent(in) :: low, high
      real(wp), intent(in) :: room        !< width of the panel [px]
      !> Most steps and fewest: two labels tell a scale.
      integer, parameter :: most = 5, fewest = 2
      !> Letters between two labels.
      integer, parameter :: blank = 2
      real(wp) :: step
      integer :: intervals, letters
      if (.not. high - low > tiny(step)) then
         call append_text(lines, 'set xrange [-1:1]; set xtics 1')
         return
      end if
      do intervals = most, fewest, -1
         step = round_step((high - low)/real(intervals, wp))
         letters = max(len(to_text(step*aint(high/step), digits)), len(to_text(step*aint(low/step), digits)), &
                       len(to_text(step, digits))) + blank
         if (((high - low)/step)*letters*letter_width <= room) exit
      end do
      call append_text(lines, 'set xrange ['//to_text(low, digits)//':'//to_text(high, digits)//']; set xtics '// &
                       to_text(step, digits))
   end subroutine x_range

   !> Range of the y axis of a low panel [shown units] with some air, and about four round steps between its tics.
   pure subroutine y_range(lines, low, high)
      type(text_type), allocatable, intent(inout) :: lines(:)
      real(wp), intent(in) :: low, high
      real(wp), parameter :: air = 0.08_wp, steps = 4.0_wp
      if (.not. high - low > tiny(low)) then
         call append_text(lines, 'set yrange [-1:1]; set ytics 1')
      else
         call append_text(lines, 'set yrange ['//to_text(low - air*(high - low), digits)//':'// &
                          to_text(high + air*(high - low), digits)//']; set ytics '// &
                          to_text(round_step((high - low)/steps), digits))
      end if
   end subroutine y_range

   !> The next larger of 1, 2 and 5 times a power of ten.
   pure function round_step(least) result(step)
      real(wp), intent(in) :: least       !< > 0
      real(wp) :: step
      real(wp), parameter :: round(4) = [1.0_wp, 2.0_wp, 5.0_wp, 10.0_wp]
      real(wp) :: power
      integer :: i
      power = 10.0_wp**floor(log10(least))
      do i = 1, size(round)
         step = round(i)*power
         if (least <= step) return
      end do
   end function round_step

   pure subroutine margins(lines, left, right, bottom, top)
      type(text_type), allocatable, intent(inout) :: lines(:)
      real(wp), intent(in) :: left, right, bottom, top
      call append_text(lines, 'set lmargin at screen '//to_text(left, digits)//'; set rmargin at screen '// &
                       to_text(right, digits)//'; set bmargin at screen '//to_text(bottom, digits)// &
                       '; set tmargin at screen '//to_text(top, digits))
   end subroutine margins

   !> One plot command of all curves.
   pure subroutine plot(lines, series, may_lack)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(series_type), intent(in) :: series(:)
      !> Data may lack, all of them, where nothing converged, and the panel has no range of its own: gnuplot fails at a panel
      !> without a number, unless a function is among its curves.
      logical, intent(in), optional :: may_lack
      character(:), allocatable :: line
      logical :: function_too
      integer :: i
      function_too = .false.
      if (present(may_lack)) function_too = may_lack
      do i = 1, size(series)
         line = '     '
         if (i == 1) line = 'plot '
         line = line//series(i)%using//' '//series(i)%look
         if (series(i)%title == '') then
            line = line//' notitle'
         else
            line = line//' title '//spelled(series(i)%title)
         end if
         if (i < size(series) .or. function_too) line = line//', \'
         call append_text(lines, line)
      end do
      if (function_too) call append_text(lines, '     NaN notitle')
   end subroutine plot

   !> Appends a curve.
   pure subroutine add_series(list, using, look, title)
      type(series_type), allocatable, intent(inout) :: list(:)
      character(*), intent(in) :: using, look, title
      type(series_type), allocatable :: longer(:)
      integer :: n
      n = 0
      if (allocated(list)) n = size(list)
      allocate (longer(n + 1))
      if (n > 0) longer(:n) = list
      longer(n + 1)%using = using
      longer(n + 1)%look = look
      longer(n + 1)%title = title
      call move_alloc(longer, list)
   end subroutine add_series

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

   !> What stands at the rows of a panel, as the tics of its axis; longer names are cut so that they fit `room`, a part of
   !> a picture so many pixels wide.
   pure function row_tics(names, room, width) result(tics)
      type(text_type), intent(in) :: names(:)
      real(wp), intent(in) :: room
      integer, intent(in) :: width
      character(:), allocatable :: tics
      character(:), allocatable :: label
      integer :: i, most, letters
      most = int(room*real(width, wp)/letter_width) - 1
      tics = ''
      do i = 1, size(names)
         if (i > 1) tics = tics//', '
         letters = most
         label = cut_text(names(i)%text, letters)
         do while (index(label, '%') > 0 .and. len(label) > longest_format)
            letters = letters - 1
            label = cut_text(names(i)%text, letters)
         end do
         tics = tics//spelled(without_format(label))//' '//to_text(i)
      end do
   end function row_tics

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

   !> A text as the label of a tic, in which gnuplot takes '%' for the beginning of a number's format.
   pure function without_format(text) result(label)
      character(*), intent(in) :: text
      character(:), allocatable :: label
      integer :: i
      label = ''
      do i = 1, len(text)
         if (text(i:i) == '%') label = label//'%'
         label = label//text(i:i)
      end do
   end function without_format

   !> A file of results, which stands beside the folder of scripts, as a script names it; `name` is safe as a file's.
   pure function results_file(name) result(literal)
      character(*), intent(in) :: name
      character(:), allocatable :: literal
      literal = spelled('../'//name//'.csv')
   end function results_file

   !> A text as gnuplot takes it literally, the only way of a deck's text into a script. Control bytes, which would end a line or
   !> spoil the picture, become blanks; bytes that make no letter become '?'.
   !>
   !> Between single quotes gnuplot knows no escape, no command in backticks and no macro. It misreads a quote written twice there
   !> (5.4), and a bare quote between double quotes switches macros on. Each quote therefore stands alone, as "\047", joined to
   !> the pieces around it by dots. No digit follows the number: gnuplot reads three or four octal digits.
   pure function spelled(text) result(literal)
      character(*), intent(in) :: text
      character(:), allocatable :: literal
      character(*), parameter :: quote = '"'//achar(92)//'047"', joint = '.'
      character(len(text)) :: shown
      integer :: i, first, last
      shown = plain_utf8(text)
      ! where a part of an XML file ends that is not read as XML: gnuplot writes it as it is
      do i = 3, len(shown)
         if (shown(i - 2:i) == ']]>') shown(i:i) = ')'
      end do
      literal = ''
      first = 1
      do while (first <= len(shown))
         if (first > 1) literal = literal//joint
         if (shown(first:first) == "'") then
            literal = literal//quote
            first = first + 1
         else
            last = first + scan(shown(first:)//"'", "'") - 2
            literal = literal//"'"//shown(first:last)//"'"
            first = last + 1
         end if
      end do
      if (literal == '') literal = "''"
   end function spelled

   !> Letters and digits of a name, for identifiers within the picture.
   pure function plain(name) result(identifier)
      character(*), intent(in) :: name
      character(len(name)) :: identifier
      integer :: i
      identifier = name
      do i = 1, len(name)
         if (scan(name(i:i), '-.+') == 1) identifier(i:i) = '_'
      end do
   end function plain
end module dg_gnuplot_script

!> Conversion of a chart into a script for gnuplot, which draws it.
!>
!> Text of a deck only enters a script through `spelled`, as gnuplot executes its scripts.
module dg_gnuplot_script
   use dg_kinds, only: wp
   use dg_chart, only: axis_type, chart_type, curve_type, panel_type
   use dg_curve_look, only: band_look, colour_of, letter_width
   use dg_depth_curve, only: bands_of, kept_points
   use dg_missing, only: is_missing
   use dg_number_text, only: append_csv_number
   use dg_quantity, only: quantity_none
   use dg_readable, only: cut_text
   use dg_ten_digits, only: longest_number
   use dg_text, only: append_text, either, plain_utf8, append_piece, text_type, to_text
   use dg_unit_kind, only: unit_label
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: chart_script, row_tics, spelled, ending_variable

   character(*), parameter :: font = 'sans-serif,12'
   !> Letters of a title: more would end beyond the picture.
   integer, parameter :: most_of_title = 200
   !> Variable of gnuplot that is put behind the name of the picture's file: drillgap draws under another name first. Not set where
   !> a script is run by hand.
   character(*), parameter :: ending_variable = 'unfinished'
   !> Longest label of a tic [bytes] with a '%' in it. gnuplot 5.4 takes it for a format, and cuts its text, even within a
   !> letter.
   integer, parameter :: longest_format = 49
   !> Digits of a place or range in a script: finer than any picture.
   integer, parameter :: digits = 8
   !> Largest distance of a drawn line from the curve, over the width of its panel [-]: a third of a pixel.
   real(wp), parameter :: fineness = 1.5e-3_wp
   !> Most points of a curve. One with more alternates so often that it hides itself. It is drawn as a band of `band_parts`
   !> parts.
   integer, parameter :: most_points = 500, band_parts = 150

contains

   !> The script that draws `<name>.svg` of a chart, whose name is safe as a file's (is_separator_free).
   pure subroutine chart_script(chart, lines)
      type(chart_type), intent(in) :: chart
      type(text_type), allocatable, intent(out) :: lines(:)
      type(text_type), allocatable :: panels(:)
      logical :: banded
      integer :: i
      allocate (lines(0), panels(0))
      banded = .false.
      do i = 1, size(chart%panels)
         call write_panel(panels, chart%panels(i), chart%units, chart%width, banded)
      end do
      associate (name => chart%name)
         call append_text(lines, '# Draws '//name//'.svg again: gnuplot '//name//'.gp')
         call append_text(lines, 'reset')
         call append_text(lines, 'if (!exists('//spelled(ending_variable)//')) '//ending_variable//" = ''")
         call append_text(lines, 'set terminal svg noenhanced size '//to_text(chart%width)//','//to_text(chart%height)// &
                          " dynamic font '"//font//"' background '#ffffff' name "//spelled(plain(name)))
         call append_text(lines, 'set output '//spelled(name//'.svg')//'.'//ending_variable)
      end associate
      call append_text(lines, "set encoding utf8; set datafile separator ','; set multiplot")
      call write_legend(lines, chart, banded)
      lines = [lines, panels]
      call append_text(lines, 'unset multiplot')
      call append_text(lines, 'unset output')
   end subroutine chart_script

   !> Title and legend in a strip of their own, so that they never cover a curve.
   pure subroutine write_legend(lines, chart, banded)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(chart_type), intent(in) :: chart
      logical, intent(in) :: banded           !< a curve is drawn as a band
      integer :: i
      call append_text(lines, 'unset border; unset tics')
      call append_text(lines, 'set label 1 '//spelled(cut_text(chart%title, most_of_title))//' at screen 0.012, screen '// &
                       to_text(chart%legend(2), digits)//" offset 0,1.1 left font ',14'")
      call append_text(lines, margins([0.02_wp, 0.98_wp, chart%legend]))
      call append_text(lines, 'set key center center horizontal Left reverse samplen 3 width 1')
      call append_text(lines, 'set xrange [0:1]; set yrange [0:1]')
      call append_text(lines, 'plot \')
      do i = 1, size(chart%keys)
         call append_text(lines, entry_of(chart%keys(i)%look, chart%keys(i)%text))
      end do
      if (banded) call append_text(lines, entry_of(band_look(colour_of(1)), 'least to greatest, mean as line'))
      call append_text(lines, '     NaN notitle')
      call append_text(lines, 'unset label 1; set key off')
      call append_text(lines, "set border 31 lw 0.8 lc rgb '#444444'; set grid lc rgb '#d8d8d8' lw 0.6")
      call append_text(lines, 'set xtics; set ytics; set tics nomirror')
   contains
      pure function entry_of(look, text) result(line)
         character(*), intent(in) :: look, text
         character(:), allocatable :: line
         line = '     NaN '//look//' title '//spelled(text)//', \'
      end function entry_of
   end subroutine write_legend

   !> A panel with all that is in it.
   pure subroutine write_panel(lines, panel, units, width, banded)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(panel_type), intent(in) :: panel
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: width               !< of the picture [px]
      logical, intent(inout) :: banded           !< a curve is drawn as a band
      type(text_type), allocatable :: plots(:)
      character(:), allocatable :: at
      logical :: known
      integer :: i
      allocate (plots(0))
      known = .false.
      do i = 1, size(panel%curves)
         call write_curve(lines, plots, panel, panel%curves(i), '$c'//to_text(i), banded)
         known = known .or. .not. all(is_missing(panel%curves(i)%points))
      end do
      call append_text(lines, 'unset label; unset arrow; set autoscale; '//margins(panel%place))
      do i = 1, size(panel%lines)
         at = 'first '//to_text(panel%lines(i)%at, digits)
         call append_text(lines, 'set arrow from graph 0, '//at//' to graph 1, '//at//' nohead '//panel%lines(i)%look)
      end do
      do i = 1, size(panel%notes)
         associate (note => panel%notes(i))
            call append_text(lines, 'set label '//spelled(note%text)//' at '//either('graph', 'first', note%of_panel(1))// &
                             ' '//to_text(note%at(1), digits)//', '//either('graph', 'first', note%of_panel(2))//' '// &
                             to_text(note%at(2), digits)//' '//note%look)
         end associate
      end do
      call write_axis(lines, panel%x, 'x', units, width)
      call write_axis(lines, panel%y, 'y', units, width)
      if (panel%logarithmic) then
         call append_text(lines, "set logscale xy; set format xy '%g'")
         ! gnuplot fails at a panel without a number
         if (.not. known) call append_text(lines, 'set xrange [0.1:1]; set yrange [0.1:1]')
      else if (panel%air(1) > 0.0_wp .and. is_missing(panel%x%ends(1))) then
         call append_text(lines, 'set autoscale xfix')
      end if
      at = 'set offsets'
      do i = 1, 2
         at = at//repeat(' graph '//to_text(panel%air(i), digits)//',', 2)
      end do
      call append_text(lines, at(:len(at) - 1))
      call append_text(lines, 'plot \')
      lines = [lines, plots]
      ! so it does where data lack, all of them, unless a function is among the curves
      call append_text(lines, '     NaN notitle')
   end subroutine write_panel

   pure subroutine write_axis(lines, axis, letter, units, width)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(axis_type), intent(in) :: axis
      character, intent(in) :: letter            !< x or y
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: width               !< of the picture [px]
      character(:), allocatable :: tics, label
      tics = axis%tics
      if (tics == '') tics = 'autofreq'
      if (allocated(axis%rows)) tics = '('//row_tics(axis%rows, axis%room, width)//')'
      label = 'unset '//letter//'label'
      if (axis%label /= '') label = 'set '//letter//'label '//spelled(axis%label//unit_text())
      call append_text(lines, label//'; set format '//letter//' '//spelled(either('% h', '', axis%numbered))// &
                       '; set '//letter//'range ['//ending(axis%ends(1))//':'//ending(axis%ends(2))//']; set '//letter// &
                       'tics '//tics)
   contains
      !> The unit of the axis in brackets.
      pure function unit_text() result(text)
         character(:), allocatable :: text
         text = ''
         if (axis%quantity /= quantity_none) text = ' ['//unit_label(units, axis%quantity)//']'
      end function unit_text

      pure function ending(value) result(text)
         real(wp), intent(in) :: value
         character(:), allocatable :: text
         text = '*'
         if (.not. is_missing(value)) text = to_text(value, digits)
      end function ending
   end subroutine write_axis

   !> Points of a curve as a block of data, and the command that plots it. Along the depth only visible points are kept. A
   !> curve that alternates too often becomes a band from least to greatest with the mean in it.
   pure subroutine write_curve(lines, plots, panel, curve, block, banded)
      type(text_type), allocatable, intent(inout) :: lines(:), plots(:)
      type(panel_type), intent(in) :: panel
      type(curve_type), intent(in) :: curve
      character(*), intent(in) :: block       !< name, with its $
      logical, intent(inout) :: banded
      logical :: kept(size(curve%points, 2))
      real(wp) :: least(band_parts), mean(band_parts), greatest(band_parts), middle(band_parts)
      integer, allocatable :: shown(:)
      integer :: i, n
      n = size(kept)
      kept = .true.
      associate (x => curve%points(1, :), y => curve%points(2, :))
         if (curve%along_depth) kept = kept_points(y, x, fineness*(panel%x%ends(2) - panel%x%ends(1)))
         if (count(kept) > most_points .and. curve%band /= '' .and. .not. any(is_missing(x))) then
            banded = .true.
            call bands_of(y, x, least, mean, greatest)
            middle = y(1) + (y(n) - y(1))*[(real(i, wp) - 0.5_wp, i=1, band_parts)]/band_parts
            call write_points(lines, block//'b', reshape([least, greatest(band_parts:1:-1), middle, middle(band_parts:1:-1)], &
                                                         [2, 2*band_parts], order=[2, 1]))
            call append_text(plots, '     '//block//'b '//band_look(curve%band)//' notitle, \')
            call write_points(lines, block, reshape([mean, middle], [2, band_parts], order=[2, 1]))
         else
            shown = pack([(i, i=1, n)], kept)
            call write_points(lines, block, curve%points(:, shown))
         end if
      end associate
      if (n > 0) call append_text(plots, '     '//block//' '//curve%look//' notitle, \')
   end subroutine write_curve

   !> A block of data within the script.
   pure subroutine write_points(lines, block, points)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: block       !< name, with its $
      real(wp), intent(in) :: points(:, :)    !< a row of the block a column
      character(:), allocatable :: room
      integer :: i, k, filled
      allocate (character(size(points)*(longest_number + 1)) :: room)
      filled = 0
      do i = 1, size(points, 2)
         do k = 1, size(points, 1)
            if (k > 1) call append_piece(room, filled, ',')
            if (is_missing(points(k, i))) then
               call append_piece(room, filled, 'NaN')
            else
               call append_csv_number(room, filled, points(k, i))
            end if
         end do
         call append_piece(room, filled, new_line('a'))
      end do
      call append_text(lines, block//' << EOD')
      if (filled > 0) call append_text(lines, room(:filled - 1))
      call append_text(lines, 'EOD')
   end subroutine write_points

   !> Ends of a panel, in parts of the picture.
   pure function margins(place) result(text)
      real(wp), intent(in) :: place(4)        !< left, right, bottom, top
      character(:), allocatable :: text
      text = 'set lmargin at screen '//to_text(place(1), digits)//'; set rmargin at screen '//to_text(place(2), digits)// &
             '; set bmargin at screen '//to_text(place(3), digits)//'; set tmargin at screen '//to_text(place(4), digits)
   end function margins

   !> Names of the rows of a panel, as the tics of its axis. Longer names are cut so that they fit `room`, a part of a picture with
   !> the given width in pixels.
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

!> Panels of curves against depth: their points are in the script, no more than can be seen; hole sections end at lines across all
!> panels, with their names in the first.
module dg_depth_panels
   use dg_kinds, only: wp
   use dg_depth_curve, only: bands_of, kept_points
   use dg_gnuplot_script, only: add_series, colour_grey, cut_text, letter_width, panel, plot, series_type, spelled, x_range
   use dg_hole_section, only: hole_section_type
   use dg_missing, only: is_missing
   use dg_number_text, only: put_csv_number
   use dg_ten_digits, only: longest_number
   use dg_text, only: append_text, put_piece, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: curve_type, panel_place_type, add_curve, range_of_curves, draw_panel, add_points, band_look, put_sections, &
             name_no_sections

   !> A curve of a panel, as it is shown.
   type :: curve_type
      real(wp), allocatable :: depth(:)      !< never decreasing, in the deck's units
      real(wp), allocatable :: values(:)     !< as many, `missing` where there is none
      character(:), allocatable :: look      !< with ...
      character(7) :: colour = ''            !< of its band
   end type curve_type

   !> Where panels stand, in parts of a picture, and its size.
   type :: panel_place_type
      real(wp) :: left = 0.0_wp, right = 1.0_wp, bottom = 0.0_wp, top = 1.0_wp
      integer :: width = 0, height = 0       !< of the picture [px]
   end type panel_place_type

   integer, parameter :: digits = 8
   !> How far a drawn line may be from the curve, of the width of its panel [-]: a third of a pixel.
   real(wp), parameter :: fineness = 1.5e-3_wp
   !> A curve of more points than this goes to and fro so often that it hides itself: it is drawn as a band of so many parts.
   integer, parameter :: most_points = 500, band_parts = 150
   !> Numbers of arrows and labels of hole sections: those below are others'.
   integer, parameter :: first_number = 100
   !> Height of a name [px].
   real(wp), parameter :: name_height = 14.0_wp

contains

   !> Appends a curve; `depth` and `values` in SI units, divided by `length` and `unit`.
   pure subroutine add_curve(list, depth, length, values, unit, look, colour)
      type(curve_type), allocatable, intent(inout) :: list(:)
      real(wp), intent(in) :: depth(:), values(:)   !< as many
      real(wp), intent(in) :: length, unit
      character(*), intent(in) :: look
      character(*), intent(in) :: colour            !< of its band; '': it has none
      type(curve_type), allocatable :: longer(:)
      integer :: n
      n = 0
      if (allocated(list)) n = size(list)
      allocate (longer(n + 1))
      if (n > 0) longer(:n) = list
      allocate (longer(n + 1)%depth, source=depth/length)
      allocate (longer(n + 1)%values, source=values)
      where (.not. is_missing(values)) longer(n + 1)%values = values/unit
      longer(n + 1)%look = look
      longer(n + 1)%colour = colour
      call move_alloc(longer, list)
   end subroutine add_curve

   !> Ends of an axis on which all curves and 0 lie, with some air.
   pure subroutine range_of_curves(curves, low, high)
      type(curve_type), intent(in) :: curves(:)
      real(wp), intent(out) :: low, high
      real(wp), parameter :: air = 1.05_wp
      integer :: i
      low = 0.0_wp
      high = 0.0_wp
      do i = 1, size(curves)
         low = min(low, air*minval(curves(i)%values, mask=.not. is_missing(curves(i)%values)))
         high = max(high, air*maxval(curves(i)%values, mask=.not. is_missing(curves(i)%values)))
      end do
   end subroutine range_of_curves

   !> One panel. Curves that go to and fro too often become a band from least to greatest with the mean in it; `banded` says so.
   pure subroutine draw_panel(lines, place, labels, curves, low, high, banded, others)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(panel_place_type), intent(in) :: place
      type(text_type), intent(in) :: labels(2)            !< of both axes; '': the depths of the panel to the left hold here too
      type(curve_type), intent(in) :: curves(:)
      real(wp), intent(in) :: low, high                   !< ends of the axis
      logical, intent(out) :: banded
      type(series_type), intent(in), optional :: others(:)  !< beside the curves
      type(series_type), allocatable :: series(:)
      logical, allocatable :: kept(:)
      integer :: i
      banded = .false.
      allocate (series(0))
      do i = 1, size(curves)
         associate (curve => curves(i), block => '$c'//to_text(i))
            kept = kept_points(curve%depth, curve%values, fineness*(high - low))
            if (count(kept) > most_points .and. curve%colour /= '' .and. .not. any(is_missing(curve%values))) then
               banded = .true.
               call add_band(lines, series, block, curve)
            else
               call add_points(lines, block, pack(curve%values, kept), pack(curve%depth, kept))
               call add_series(series, block//' using 1:2', curve%look, '')
            end if
         end associate
      end do
      if (present(others)) series = [series, others]
      call panel(lines, place%left, place%right, place%bottom, place%top, labels(1)%text, labels(2)%text)
      call x_range(lines, low, high, (place%right - place%left)*place%width)
      call plot(lines, series, may_lack=.true.)
   end subroutine draw_panel

   !> A band and the line of means in it.
   pure subroutine add_band(lines, series, block, curve)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(series_type), allocatable, intent(inout) :: series(:)
      character(*), intent(in) :: block
      type(curve_type), intent(in) :: curve
      real(wp) :: least(band_parts), mean(band_parts), greatest(band_parts), middle(band_parts)
      integer :: i, n
      n = size(curve%depth)
      call bands_of(curve%depth, curve%values, least, mean, greatest)
      middle = curve%depth(1) + (curve%depth(n) - curve%depth(1))*[(real(i, wp) - 0.5_wp, i=1, band_parts)]/band_parts
      call add_points(lines, block//'b', [least, greatest(band_parts:1:-1)], [middle, middle(band_parts:1:-1)])
      call add_points(lines, block, mean, middle)
      call add_series(series, block//'b using 1:2', band_look(curve%colour), '')
      call add_series(series, block//' using 1:2', curve%look, '')
   end subroutine add_band

   !> Look of a band in a colour, light enough for a line of the same.
   pure function band_look(colour) result(look)
      character(*), intent(in) :: colour
      character(:), allocatable :: look
      look = "with filledcurves closed fs solid 0.35 noborder fc rgb '"//colour//"'"
   end function band_look

   !> Points as a block of data within a script, in columns 1 and 2.
   pure subroutine add_points(lines, block, x, y)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: block       !< name, with its $
      real(wp), intent(in) :: x(:), y(:)      !< as many; `missing` breaks a line
      character(:), allocatable :: room
      integer :: i, filled
      allocate (character(size(x)*(2*longest_number + 2)) :: room)
      filled = 0
      do i = 1, size(x)
         if (is_missing(x(i))) then
            call put_piece(room, filled, 'NaN')
         else
            call put_csv_number(room, filled, x(i))
         end if
         call put_piece(room, filled, ',')
         call put_csv_number(room, filled, y(i))
         call put_piece(room, filled, new_line('a'))
      end do
      call append_text(lines, block//' << EOD')
      if (filled > 0) call append_text(lines, room(:filled - 1))
      call append_text(lines, 'EOD')
   end subroutine add_points

   !> A line across all panels that follow where a hole section ends above the bit, its name above it in the first. Where lines are
   !> too close for names the deeper one has its name.
   pure subroutine put_sections(lines, holes, units, deepest, place, names_left)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(hole_section_type), intent(in) :: holes(:)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: deepest                 !< end of the axis [m], which begins at 0
      type(panel_place_type), intent(in) :: place     !< of the first panel
      logical, intent(in) :: names_left               !< names stand at its left edge, else at its right
      character(:), allocatable :: depth, edge, side
      real(wp) :: pixel, named
      integer :: i, most
      pixel = deepest/((place%top - place%bottom)*place%height)
      most = int((place%right - place%left)*place%width/letter_width)
      named = huge(named)
      edge = '0.98'
      side = 'right'
      if (names_left) then
         edge = '0.02'
         side = 'left'
      end if
      do i = size(holes) - 1, 1, -1
         if (holes(i)%md_bottom >= deepest) cycle
         depth = to_text(holes(i)%md_bottom/units%length, digits)
         call append_text(lines, 'set arrow '//to_text(first_number + i)//' from graph 0, first '//depth//' to graph 1, first '// &
                          depth//" nohead lw 1 dt (12,4,2,4) lc rgb '"//colour_grey//"'")
         if (named - holes(i)%md_bottom < name_height*pixel .or. holes(i)%md_bottom < name_height*pixel) cycle
         named = holes(i)%md_bottom
         call append_text(lines, 'set label '//to_text(first_number + i)//' '//spelled(cut_text(holes(i)%name, most))// &
                          ' at graph '//edge//', first '//depth//' '//side//" offset 0,0.4 font ',9' textcolor rgb '#555555'")
      end do
   end subroutine put_sections

   !> Leaves the lines, for the panels beside the first.
   pure subroutine name_no_sections(lines)
      type(text_type), allocatable, intent(inout) :: lines(:)
      call append_text(lines, 'unset label')
   end subroutine name_no_sections
end module dg_depth_panels

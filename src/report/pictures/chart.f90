!> A picture as data: panels with axes, curves, lines across them and notes; title and legend above. Numbers are in the
!> displayed units, places in parts of the picture. dg_gnuplot_script draws it.
module dg_chart
   use dg_kinds, only: wp
   use dg_curve_look, only: colour_grey, letter_width
   use dg_hole_section, only: hole_section_type
   use dg_missing, only: is_missing, missing
   use dg_quantity, only: quantity_length, quantity_none
   use dg_readable, only: cut_text
   use dg_text, only: either, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: chart_type, panel_type, axis_type, curve_type
   public :: new_chart, beside, add_panel, add_rows, set_depth, add_depth_panel, add_points, add_curve, add_depth_curve, add_key, &
             key_of, add_label, fit_range, is_empty, round_step

   !> Points that are joined, marked or filled.
   type :: curve_type
      !> (:, n): to the right, up, and further values of each point for the look; `missing` breaks a line.
      real(wp), allocatable :: points(:, :)
      character(:), allocatable :: look         !< gnuplot's `with`
      logical :: along_depth = .false.          !< points that cannot be seen are left out
      logical :: sets_axis = .true.             !< it lies on the horizontal axis as a whole
      logical :: at_edge = .false.              !< marks at the lower end of that axis, which have no value
      character(7) :: band = ''                 !< colour of the band that a curve of too many turns becomes; '': none
      integer, allocatable :: keys(:)           !< entries of the legend that it belongs to
      character(:), allocatable :: name         !< where it is pointed at; '': the texts of its entries
   end type curve_type

   type :: note_type
      character(:), allocatable :: text, look
      real(wp) :: at(2) = 0.0_wp                !< to the right and up
      logical :: of_panel(2) = .false.          !< in parts of the panel, not in its units
   end type note_type

   !> A level line across a panel.
   type :: line_type
      real(wp) :: at = 0.0_wp
      character(:), allocatable :: look
   end type line_type

   type :: axis_type
      character(:), allocatable :: label        !< '': none
      integer :: quantity = quantity_none       !< of its numbers; its unit stands behind the label
      real(wp) :: ends(2) = missing             !< `missing`: as the curves have it
      character(:), allocatable :: tics         !< gnuplot's step or list; '': as it thinks
      logical :: numbered = .true.              !< numbers stand beside the tics
      type(text_type), allocatable :: rows(:)   !< names of rows 1, 2, ... that stand there instead
      real(wp) :: room = 0.0_wp                 !< for these names
   end type axis_type

   type :: panel_type
      real(wp) :: place(4) = 0.0_wp             !< left, right, bottom, top
      type(axis_type) :: x, y
      logical :: logarithmic = .false.          !< both axes
      real(wp) :: air(2) = 0.0_wp               !< between curves and frame across and up, in parts of the panel
      type(curve_type), allocatable :: curves(:)
      type(line_type), allocatable :: lines(:)
      type(note_type), allocatable :: notes(:)
   end type panel_type

   !> An entry of the legend.
   type :: key_type
      character(:), allocatable :: look, text
   end type key_type

   type :: chart_type
      character(:), allocatable :: name         !< of its files, without ending
      character(:), allocatable :: title
      type(unit_system_type) :: units
      integer :: width = 1120, height = 0       !< [px] at 96 dpi
      real(wp) :: legend(2) = 0.0_wp            !< bottom and top of the legend
      type(key_type), allocatable :: keys(:)
      type(panel_type), allocatable :: panels(:)
      type(panel_type) :: depth                 !< axis, lines and notes of panels over depth, see set_depth
   end type chart_type

contains

   !> A chart without panels.
   pure function new_chart(name, title, units, height, legend) result(chart)
      character(*), intent(in) :: name, title
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: height
      real(wp), intent(in) :: legend(2)       !< its bottom and top
      type(chart_type) :: chart
      chart%name = name
      chart%title = title
      chart%units = units
      chart%height = height
      chart%legend = legend
      allocate (chart%keys(0), chart%panels(0))
   end function new_chart

   !> Place of one of several panels side by side.
   pure function beside(number, count, first, gap) result(place)
      integer, intent(in) :: number, count
      real(wp), intent(in) :: first(4)        !< left, right, bottom and top of all
      real(wp), intent(in) :: gap
      real(wp) :: place(4), wide
      wide = (first(2) - first(1) + gap)/count - gap
      place(1) = first(1) + (number - 1)*(wide + gap)
      place(2:) = [place(1) + wide, first(3:)]
   end function beside

   !> Appends a panel. Without `y_label` the vertical axis of the panel to the left holds for it, too.
   pure subroutine add_panel(chart, place, x_label, y_label)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: place(4)
      character(*), intent(in) :: x_label
      character(*), intent(in), optional :: y_label
      type(panel_type), allocatable :: longer(:)
      integer :: n
      n = size(chart%panels) + 1
      allocate (longer(n))
      longer(:n - 1) = chart%panels
      associate (panel => longer(n))
         panel%place = place
         panel%x%label = x_label
         panel%x%tics = ''
         panel%y%label = ''
         panel%y%tics = ''
         panel%y%numbered = present(y_label)
         if (present(y_label)) panel%y%label = y_label
         allocate (panel%curves(0), panel%lines(0), panel%notes(0))
      end associate
      call move_alloc(longer, chart%panels)
   end subroutine add_panel

   !> Appends a panel with rows that have names, the first on top.
   pure subroutine add_rows(chart, place, x_label, quantity, names, room)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: place(4)
      character(*), intent(in) :: x_label
      integer, intent(in) :: quantity   !< of the horizontal axis
      type(text_type), intent(in) :: names(:)
      real(wp), intent(in) :: room      !< to the left of the panel for the names; 0: those of the panel to the left hold here
      call add_panel(chart, place, x_label)
      chart%panels(size(chart%panels))%x%quantity = quantity
      associate (axis => chart%panels(size(chart%panels))%y)
         axis%ends = [real(size(names), wp) + 0.6_wp, 0.4_wp]
         axis%tics = '1'
         axis%room = room
         if (room > 0.0_wp) allocate (axis%rows, source=names)
      end associate
   end subroutine add_rows

   !> Sets what panels over depth share: the axis, and a line where a hole section ends above the deepest place. Names of sections
   !> stand above their lines in the first panel. Where lines are too close for names the deeper one has its name.
   pure subroutine set_depth(chart, label, depths, holes, place, left)
      type(chart_type), intent(inout) :: chart
      character(*), intent(in) :: label               !< of the axis, without unit
      real(wp), intent(in) :: depths(2)               !< least and greatest of the curves [m]
      type(hole_section_type), intent(in) :: holes(:)
      real(wp), intent(in) :: place(4)                !< of the first panel
      logical, intent(in) :: left                     !< names stand at its left edge, else at its right
      !> Height of a name [px].
      real(wp), parameter :: name_height = 14.0_wp
      !> Steps of the axis, at one of which it begins; its least length over the greatest depth; part of a step above a curve.
      real(wp), parameter :: steps = 20.0_wp, least = 0.5_wp, air = 0.1_wp
      character(:), allocatable :: side
      real(wp) :: high, named, ends(2), step
      integer :: i, most
      associate (depth => chart%depth, length => chart%units%length)
         step = length*round_step(max(depths(2) - depths(1), least*depths(2))/(steps*length))
         ends = [max(0.0_wp, step*floor(depths(1)/step - air)), depths(2)]
         depth%y%label = label
         depth%y%quantity = quantity_length
         depth%y%ends = [ends(2), ends(1)]/length
         depth%y%tics = ''
         allocate (depth%lines(0), depth%notes(0))
         high = name_height*(ends(2) - ends(1))/((place(4) - place(3))*chart%height)
         most = int((place(2) - place(1))*chart%width/letter_width)
         side = either('left', 'right', left)//" offset 0,0.4 font ',9' textcolor rgb '#555555'"
         named = huge(named)
         do i = size(holes) - 1, 1, -1
            associate (md => holes(i)%md_bottom)
               if (md >= ends(2) .or. md <= ends(1)) cycle
               call append_line(depth, md/length, "lw 1 dt (12,4,2,4) lc rgb '"//colour_grey//"'")
               if (named - md < high .or. md - ends(1) < high) cycle
               named = md
               call append_label(depth, cut_text(holes(i)%name, most), [merge(0.02_wp, 0.98_wp, left), md/length], side, &
                                [.true., .false.])
            end associate
         end do
      end associate
   end subroutine set_depth

   !> Appends a panel over depth.
   pure subroutine add_depth_panel(chart, place, x_label, quantity)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: place(4)
      character(*), intent(in) :: x_label
      integer, intent(in) :: quantity   !< of the horizontal axis
      call add_panel(chart, place, x_label)
      associate (panel => chart%panels(size(chart%panels)))
         panel%x%quantity = quantity
         panel%lines = chart%depth%lines
         panel%y%ends = chart%depth%y%ends
         if (size(chart%panels) > 1) return
         panel%y = chart%depth%y
         panel%notes = chart%depth%notes
      end associate
   end subroutine add_depth_panel

   !> Appends points of any kind to the last panel.
   pure subroutine add_points(chart, points, look, keys, name)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: points(:, :)      !< see curve_type
      character(*), intent(in) :: look
      integer, intent(in), optional :: keys(:)          !< see curve_type; absent: none
      character(*), intent(in), optional :: name        !< see curve_type; absent: ''
      type(curve_type), allocatable :: longer(:)
      associate (panel => chart%panels(size(chart%panels)))
         allocate (longer(size(panel%curves) + 1))
         longer(:size(panel%curves)) = panel%curves
         longer(size(longer))%points = points
         associate (curve => longer(size(longer)))
            curve%look = look
            allocate (curve%keys(0))
            if (present(keys)) curve%keys = keys
            curve%name = ''
            if (present(name)) curve%name = name
         end associate
         call move_alloc(longer, panel%curves)
      end associate
   end subroutine add_points

   !> Appends a curve to the last panel, and to the legend under its name.
   pure subroutine add_curve(chart, x, y, look, name, keys)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: x(:), y(:)
      character(*), intent(in) :: look
      character(*), intent(in) :: name      !< '': it has none
      integer, intent(in), optional :: keys(:)      !< entries of the legend that a curve without a name belongs to
      real(wp) :: points(2, size(x))
      points(1, :) = x
      points(2, :) = y
      if (name /= '') then
         call add_key(chart, look, name)
         call add_points(chart, points, look, [size(chart%keys)])
      else
         call add_points(chart, points, look, keys)
      end if
   end subroutine add_curve

   !> Appends a curve along the string to the last panel, from SI units.
   pure subroutine add_depth_curve(chart, depth, values, unit, look, name, band)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in) :: depth(:)      !< never decreasing [m]
      real(wp), intent(in) :: values(:)     !< one for each depth; `missing` leaves a gap
      real(wp), intent(in) :: unit          !< of the values [SI]
      character(*), intent(in) :: look, name
      character(*), intent(in) :: band      !< see curve_type
      real(wp) :: shown(size(values))
      shown = missing
      where (.not. is_missing(values)) shown = values/unit
      call add_curve(chart, shown, depth/chart%units%length, look, name)
      associate (panel => chart%panels(size(chart%panels)))
         associate (curve => panel%curves(size(panel%curves)))
            curve%along_depth = .true.
            curve%band = band
         end associate
      end associate
   end subroutine add_depth_curve

   !> Appends an entry to the legend.
   pure subroutine add_key(chart, look, text)
      type(chart_type), intent(inout) :: chart
      character(*), intent(in) :: look, text
      type(key_type), allocatable :: longer(:)
      allocate (longer(size(chart%keys) + 1))
      longer(:size(chart%keys)) = chart%keys
      longer(size(longer))%look = look
      longer(size(longer))%text = text
      call move_alloc(longer, chart%keys)
   end subroutine add_key

   !> Place of an entry of the legend with a text; none where no entry has it.
   pure function key_of(chart, text) result(number)
      type(chart_type), intent(in) :: chart
      character(*), intent(in) :: text
      integer, allocatable :: number(:)       !< one or none
      integer :: i
      number = pack([(i, i=1, size(chart%keys))], [(chart%keys(i)%text == text, i=1, size(chart%keys))])
      number = number(:min(1, size(number)))
   end function key_of

   !> Appends a text to the last panel.
   pure subroutine add_label(chart, text, at, look, of_panel)
      type(chart_type), intent(inout) :: chart
      character(*), intent(in) :: text
      real(wp), intent(in) :: at(2)
      character(*), intent(in) :: look
      logical, intent(in) :: of_panel(2)    !< see note_type
      call append_label(chart%panels(size(chart%panels)), text, at, look, of_panel)
   end subroutine add_label

   pure subroutine append_label(panel, text, at, look, of_panel)
      type(panel_type), intent(inout) :: panel
      character(*), intent(in) :: text, look
      real(wp), intent(in) :: at(2)
      logical, intent(in) :: of_panel(2)
      type(note_type), allocatable :: longer(:)
      allocate (longer(size(panel%notes) + 1))
      longer(:size(panel%notes)) = panel%notes
      associate (note => longer(size(longer)))
         note%text = text
         note%look = look
         note%at = at
         note%of_panel = of_panel
      end associate
      call move_alloc(longer, panel%notes)
   end subroutine append_label

   pure subroutine append_line(panel, at, look)
      type(panel_type), intent(inout) :: panel
      real(wp), intent(in) :: at
      character(*), intent(in) :: look
      type(line_type), allocatable :: longer(:)
      allocate (longer(size(panel%lines) + 1))
      longer(:size(panel%lines)) = panel%lines
      associate (line => longer(size(longer)))
         line%at = at
         line%look = look
      end associate
      call move_alloc(longer, panel%lines)
   end subroutine append_line

   !> True where no curve has a point that can be shown.
   pure function is_empty(chart) result(empty)
      type(chart_type), intent(in) :: chart
      logical :: empty
      integer :: i, k
      empty = .false.
      do i = 1, size(chart%panels)
         do k = 1, size(chart%panels(i)%curves)
            associate (points => chart%panels(i)%curves(k)%points)
               if (any(.not. (is_missing(points(1, :)) .or. is_missing(points(2, :))))) return
            end associate
         end do
      end do
      empty = .true.
   end function is_empty

   !> Sets the horizontal axis of the last panel: all curves and 0 lie on it with some air, or ends that are given. Steps between
   !> its tics are round, five or as many as numbers have room for.
   pure subroutine fit_range(chart, given, most)
      type(chart_type), intent(inout) :: chart
      real(wp), intent(in), optional :: given(2)
      real(wp), intent(in), optional :: most          !< end of the axis at most
      real(wp), parameter :: air = 1.05_wp
      !> Most and fewest steps: two numbers define a scale. Letters between two numbers.
      integer, parameter :: most_steps = 5, fewest = 2, blank = 2, digits = 8
      real(wp) :: ends(2), step, room
      integer :: i, letters
      associate (panel => chart%panels(size(chart%panels)))
         ends = 0.0_wp
         do i = 1, size(panel%curves)
            associate (x => panel%curves(i)%points(1, :))
               if (all(is_missing(x))) cycle
               ends = [min(ends(1), air*minval(x, mask=.not. is_missing(x))), &
                       max(ends(2), air*maxval(x, mask=.not. is_missing(x)))]
            end associate
         end do
         if (present(most)) ends(2) = min(ends(2), most)
         if (present(given)) ends = given
         step = 1.0_wp
         if (ends(2) - ends(1) > tiny(step)) then
            room = (panel%place(2) - panel%place(1))*chart%width
            do i = most_steps, fewest, -1
               step = round_step((ends(2) - ends(1))/real(i, wp))
               letters = max(len(to_text(step*aint(ends(2)/step), digits)), len(to_text(step*aint(ends(1)/step), digits)), &
                             len(to_text(step, digits))) + blank
               if (((ends(2) - ends(1))/step)*letters*letter_width <= room) exit
            end do
         else
            ends = [-1.0_wp, 1.0_wp]
         end if
         panel%x%ends = ends
         panel%x%tics = to_text(step, digits)
      end associate
   end subroutine fit_range

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
end module dg_chart

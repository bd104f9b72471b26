!> Pictures of the whole run as the script of the page draws them (page.js), as JSON: blocks of panels over one axis, curves,
!> legend. Numbers are in the deck's units.
module dg_page_figures
   use dg_kinds, only: wp
   use dg_chart, only: add_key, chart_type, curve_type, key_of, panel_type
   use dg_curve_look, only: colour_black, colour_white, look_part
   use dg_json, only: json_string, quantity_key
   use dg_line_list, only: add_line, line_list_type
   use dg_missing, only: is_missing
   use dg_page_curves, only: curve_text
   use dg_picture_list, only: picture_list_type, picture_type
   use dg_text, only: to_text
   implicit none
   private
   public :: append_figures, is_live, look_text

   integer, parameter :: digits = 7

contains

   !> True if the script draws a picture: one of the run, whose panels stand over depth or rows.
   elemental function is_live(picture) result(is)
      type(picture_type), intent(in) :: picture
      logical :: is
      integer :: i
      is = picture%case_index == 0 .and. allocated(picture%chart)
      if (.not. is) return
      do i = 1, size(picture%chart%panels)
         associate (panel => picture%chart%panels(i))
            is = is .and. .not. panel%logarithmic .and. .not. any(is_missing(panel%y%ends))
         end associate
      end do
   end function is_live

   !> A list of all such pictures. Panels with an axis of their own begin a block.
   subroutine append_figures(lines, list, tolerance)
      type(line_list_type), intent(inout) :: lines
      type(picture_list_type), intent(in) :: list
      real(wp), intent(in) :: tolerance          !< of curves, see page_curves
      type(chart_type) :: chart
      character(:), allocatable :: text
      integer :: i, k
      logical :: begins
      call add_line(lines, '"figures":[')
      text = ''
      do i = 1, size(list%pictures)
         if (.not. is_live(list%pictures(i))) cycle
         if (text /= '') call add_line(lines, text//',')
         chart = list%pictures(i)%chart
         call give_keys(chart)
         call add_line(lines, '{"title":'//json_string(chart%title)//',"keys":['//keys_text(chart)//'],"blocks":[')
         do k = 1, size(chart%panels)
            begins = k == 1 .or. allocated(chart%panels(k)%y%rows)
            if (begins) then
               if (k > 1) call add_line(lines, ']},')
               call add_line(lines, '{'//axis_text(chart%panels(k))//',"panels":[')
            else
               call add_line(lines, ',')
            end if
            call append_panel(lines, chart%panels(k), tolerance)
         end do
         text = ']}]}'
      end do
      call add_line(lines, text//']')
   end subroutine append_figures

   !> Give curves without an entry of the legend one of their own, which switches them on and off. Give curves without a name
   !> the texts of their entries.
   pure subroutine give_keys(chart)
      type(chart_type), intent(inout) :: chart
      integer :: i, k
      do i = 1, size(chart%panels)
         do k = 1, size(chart%panels(i)%curves)
            associate (curve => chart%panels(i)%curves(k))
               if (curve%name == '') then
                  curve%name = texts_of(chart, curve%keys)
               else if (size(curve%keys) == 0) then
                  if (size(key_of(chart, curve%name)) == 0) call add_key(chart, curve%look, curve%name)
                  curve%keys = key_of(chart, curve%name)
               end if
            end associate
         end do
      end do
   end subroutine give_keys

   !> Texts of entries of the legend, a comma between them.
   pure function texts_of(chart, keys) result(text)
      type(chart_type), intent(in) :: chart
      integer, intent(in) :: keys(:)      !< places of the entries
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, size(keys)
         if (i > 1) text = text//', '
         text = text//chart%keys(keys(i))%text
      end do
   end function texts_of

   !> Entries of the legend. A white one is words only.
   pure function keys_text(chart) result(text)
      type(chart_type), intent(in) :: chart
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, size(chart%keys)
         if (i > 1) text = text//','
         text = text//'{"text":'//json_string(chart%keys(i)%text)//look_text(chart%keys(i)%look)//'}'
      end do
   end function keys_text

   !> Text at the vertical axis: names of rows, or the label of the axis and its ends.
   pure function axis_text(panel) result(text)
      type(panel_type), intent(in) :: panel
      character(:), allocatable :: text
      integer :: i
      if (.not. allocated(panel%y%rows)) then
         text = '"over":'//json_string(panel%y%label)//',"begin":'//to_text(panel%y%ends(2), digits)// &
                ',"end":'//to_text(panel%y%ends(1), digits)
         return
      end if
      text = '"rows":['
      do i = 1, size(panel%y%rows)
         if (i > 1) text = text//','
         text = text//json_string(panel%y%rows(i)%text)
      end do
      text = text//']'
   end function axis_text

   subroutine append_panel(lines, panel, tolerance)
      type(line_list_type), intent(inout) :: lines
      type(panel_type), intent(in) :: panel
      real(wp), intent(in) :: tolerance
      character(:), allocatable :: text
      integer :: i
      text = '{"label":'//json_string(panel%x%label)//',"quantity":'//json_string(quantity_key(panel%x%quantity))
      if (.not. is_missing(panel%x%ends(1))) text = text//',"low":'//to_text(panel%x%ends(1), digits)
      call add_line(lines, text//',"lines":[')
      do i = 1, size(panel%curves)
         text = curve_json(panel%curves(i), tolerance)
         if (i < size(panel%curves)) text = text//','
         call add_line(lines, text)
      end do
      call add_line(lines, ']}')
   end subroutine append_panel

   !> A curve: its name, entries of the legend, look and points; of bars both ends, too.
   pure function curve_json(curve, tolerance) result(text)
      type(curve_type), intent(in) :: curve
      real(wp), intent(in) :: tolerance
      character(:), allocatable :: text
      integer :: i
      text = '{"name":'//json_string(curve%name)//',"keys":['
      do i = 1, size(curve%keys)
         if (i > 1) text = text//','
         text = text//to_text(curve%keys(i) - 1)
      end do
      text = text//']'//look_text(curve%look)
      if (.not. curve%sets_axis) text = text//',"loose":true'
      if (curve%at_edge) text = text//',"edge":true'
      text = text//',"points":'
      associate (x => curve%points(1, :), y => curve%points(2, :))
         select case (look_part(curve%look, 'with'))
         case ('lines', 'linespoints')
            text = text//curve_text(y, x, tolerance)
         case ('xerrorbars', 'boxxyerror')
            text = text//curve_text(y, x, 0.0_wp)//',"low":'//curve_text(y, curve%points(3, :), 0.0_wp)//',"high":'// &
                   curve_text(y, curve%points(4, :), 0.0_wp)
         case default
            text = text//curve_text(y, x, 0.0_wp)
         end select
      end associate
      text = text//'}'
   end function curve_json

   !> Colour, dash and mark of a look, whether its points are not joined. Black is the page's own ink.
   pure function look_text(look) result(text)
      character(*), intent(in) :: look
      character(:), allocatable :: text
      character(:), allocatable :: colour, dash
      integer :: i
      colour = look_part(look, 'rgb')
      if (colour == colour_black) colour = 'currentColor'
      text = ',"look":{"stroke":'//json_string(colour)
      dash = look_part(look, 'dt')
      if (index(dash, '(') == 1) then
         do i = 1, len(dash)
            if (scan(dash(i:i), '(,)') == 1) dash(i:i) = ' '
         end do
         text = text//',"stroke-dasharray":'//json_string(trim(adjustl(dash)))
      end if
      text = text//'}'
      if (colour == colour_white) text = text//',"words":true'
      if (look_part(look, 'pt') /= '') text = text//',"mark":'//look_part(look, 'pt')
      select case (look_part(look, 'with'))
      case ('points', 'xerrorbars'); text = text//',"marks":true'
      case ('boxxyerror'); text = text//',"marks":true,"thick":true'
      case default             ! a line
      end select
   end function look_text
end module dg_page_figures

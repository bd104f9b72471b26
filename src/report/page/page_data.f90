!> Data of the page's script (page.js): units, columns, load cases, charts, strings, curves, contacts, as JSON. Numbers are in the
!> deck's units.
module dg_page_data
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_component, only: closed_diameter
   use dg_drillstring, only: component_tops
   use dg_findings, only: findings_type
   use dg_html_text, only: heading_of
   use dg_job, only: job_type, leading_model
   use dg_line_list, only: add_line, line_list_type
   use dg_json, only: json_string, quantity_key
   use dg_model, only: model_type, string_index
   use dg_page_curves, only: curve_series, is_inverse, joint_force
   use dg_page_figures, only: append_figures
   use dg_page_thinning, only: finest
   use dg_page_profiles, only: append_profiles, case_looks, charts, curves_type, find_curves, has_curves, reduced_text, &
                               thinned_text
   use dg_picture_list, only: picture_list_type
   use dg_quantity, only: quantity_rows => rows, system_base, system_name
   use dg_series, only: series_list_type
   use dg_text, only: to_text
   use dg_trajectory, only: top_md
   use dg_units, only: system_of, unit_system_type
   use dg_verdict, only: answer_no
   use dg_unit_kind, only: unit_factor, unit_label
   implicit none
   private
   public :: append_page_data, governing_case

   integer, parameter :: digits = 7

contains

   !> The load case that is shown first: with curves, the first that cannot be done, else the one nearest to a limit; 0: none.
   pure function governing_case(found) result(number)
      type(findings_type), intent(in) :: found
      integer :: number
      real(wp) :: used, most
      integer :: i
      number = 0
      most = -1.0_wp
      do i = 1, size(found%results)
         if (.not. has_curves(found%results(i)) .or. found%results(i)%model /= leading_model(found%job)) cycle
         used = 0.0_wp
         if (found%wholes(i)%verdict%used%present) used = found%wholes(i)%verdict%used%value
         if (found%wholes(i)%verdict%answer == answer_no) used = huge(used)
         if (used <= most) cycle
         most = used
         number = found%results(i)%case_index
      end do
   end function governing_case

   !> The data, in an element of the page: what stands along the string of the load cases where one is shown, figures of the run.
   subroutine append_page_data(lines, found, pictures, shown)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(picture_list_type), intent(in) :: pictures
      integer, intent(in) :: shown                          !< load case that is shown first; 0: none
      type(curves_type) :: curves
      type(series_list_type) :: list
      integer :: i
      if (shown > 0) then
         i = findloc(has_curves(found%results), .true., dim=1)
         list = curve_series(found%results(i)%profile, found%alongs(i))    ! for their names
         call find_curves(found, list, curves)
      else
         allocate (list%items(0))
      end if
      call add_line(lines, '<script type="application/json" id="data">')
      call add_line(lines, '{"units":'//json_string(trim(found%job%units%name))//',"systems":['//systems_text()//'],"thinned":'// &
                       json_string(thinned_text())//',"reduced":'//json_string(reduced_text(curves))//',')
      call append_quantities(lines, found%job%units)
      if (shown > 0) then
         call add_line(lines, '"start":'//to_text(shown - 1)//',')
         call append_columns(lines, list, alike_joint(found%alongs, has_curves(found%results))/found%job%units%length)
         call append_cases(lines, found%job, found%model)
         call add_line(lines, '"looks":['//case_looks()//'],"charts":[')
         do i = 1, size(charts)
            call add_line(lines, trim(charts(i)))
         end do
         call add_line(lines, '],"profiles":[')
         call append_profiles(lines, found, list, curves)
         call add_line(lines, '],')
      end if
      call append_figures(lines, pictures, finest)
      call add_line(lines, '}</script>')
   end subroutine append_page_data

   !> Unit and factor of each quantity in each system, from the deck's units.
   subroutine append_quantities(lines, units)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      integer :: i, k
      text = '"quantities":{'
      do i = 0, ubound(quantity_rows, 1)
         if (i > 0) text = text//','
         text = text//json_string(quantity_key(i))//':{'
         do k = 1, system_base - 1
            if (k > 1) text = text//','
            text = text//json_string(trim(system_name(k)))//':['//json_string(unit_label(system_of(k), i))//','// &
                   to_text(unit_factor(units, i)/unit_factor(system_of(k), i), digits)//']'
         end do
         text = text//'}'
      end do
      call add_line(lines, text//'},')
   end subroutine append_quantities

   !> Names of the systems of units that a deck may have.
   function systems_text() result(text)
      character(:), allocatable :: text
      integer :: k
      text = ''
      do k = 1, system_base - 1
         if (k > 1) text = text//','
         text = text//json_string(trim(system_name(k)))
      end do
   end function systems_text

   !> Label, quantity and meaning of each column; of states their words.
   subroutine append_columns(lines, list, joint)
      type(line_list_type), intent(inout) :: lines
      type(series_list_type), intent(in) :: list
      real(wp), intent(in) :: joint      !< length of a joint of pipe in all strings; 0: they differ
      character(:), allocatable :: text
      integer :: i, k
      call add_line(lines, '"columns":{')
      do i = 1, list%count
         associate (series => list%items(i), column => list%items(i)%column)
            text = json_string(trim(column%name))//':{"label":'//json_string(heading_of(trim(column%name)))// &
                   ',"quantity":'//json_string(quantity_key(column%quantity))// &
                   ',"meaning":'//json_string(trim(column%meaning))
            if (column%name == joint_force .and. joint > 0.0_wp) text = text//',"over":'//to_text(joint, digits)
            if (is_inverse(column%name)) text = text//',"inverse":true'
            if (allocated(series%words)) then
               text = text//',"words":['
               do k = 0, ubound(series%words, 1)
                  if (k > 0) text = text//','
                  text = text//json_string(series%words(k)%text)
               end do
               text = text//']'
            end if
         end associate
         call add_line(lines, text//'}'//trim(merge(',', ' ', i < list%count)))
      end do
      call add_line(lines, '},')
   end subroutine append_columns

   !> Length of a joint of pipe in all strings [m]; 0 if they differ.
   pure function alike_joint(alongs, some) result(joint)
      type(along_string_type), intent(in) :: alongs(:)
      logical, intent(in) :: some(:)      !< as many: they count
      real(wp) :: joint
      joint = maxval(alongs%pipe_joint, mask=some)
      if (joint - minval(alongs%pipe_joint, mask=some) > epsilon(joint)*joint) joint = 0.0_wp
   end function alike_joint

   !> Name, depth and string of each load case.
   subroutine append_cases(lines, job, model)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      character(:), allocatable :: text
      integer :: i
      call add_line(lines, '"cases":[')
      do i = 1, size(model%cases)
         text = '{"name":'//json_string(model%cases(i)%name)//',"depth":'// &
                to_text(model%cases(i)%bit_depth/job%units%length, digits)//',"parts":['//parts_text(job, model, i)//']}'
         if (i < size(model%cases)) text = text//','
         call add_line(lines, text)
      end do
      call add_line(lines, '],')
   end subroutine append_cases

   !> Components of the string of a load case: name, diameter, from and to above the bit.
   function parts_text(job, model, case_index) result(text)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      character(:), allocatable :: text
      real(wp), allocatable :: tops(:)
      real(wp) :: lower
      integer :: i, string
      string = string_index(model%strings, model%cases(case_index)%string)
      allocate (tops, source=component_tops(model%strings(string), &
                                            model%cases(case_index)%bit_depth - top_md(model%trajectory)))
      text = ''
      lower = 0.0_wp
      do i = 1, size(tops)
         associate (part => model%strings(string)%components(i))
            if (i > 1) text = text//','
            text = text//'{"name":'//json_string(part%name)//',"od":'// &
                   to_text(closed_diameter(part)/job%units%diameter, digits)//',"from":'// &
                   to_text(lower/job%units%length, digits)//',"to":'//to_text(tops(i)/job%units%length, digits)//'}'
            lower = tops(i)
         end associate
      end do
   end function parts_text

end module dg_page_data

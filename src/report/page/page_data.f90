!> Data of the page's script (page.js): units, columns, load cases, charts, strings, curves, contacts, as JSON. Numbers are in the
!> deck's units.
module dg_page_data
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: closed_diameter
   use dg_curve_look, only: dash_of, line_style, marked_line_style
   use dg_drillstring, only: component_tops
   use dg_job, only: job_type, leading_model, model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_json, only: json_string, quantity_key
   use dg_model, only: model_type, string_index
   use dg_page_curves, only: curve_series, has_own_depths, profile_curves
   use dg_page_figures, only: append_figures, look_text
   use dg_picture_list, only: picture_list_type
   use dg_quantity, only: quantity_rows => rows, system_base, system_name
   use dg_readable, only: spaced
   use dg_series, only: series_list_type
   use dg_text, only: text_type, to_text
   use dg_trajectory, only: top_md
   use dg_units, only: system_of, unit_system_type
   use dg_verdict, only: answer_no
   use dg_whole_string, only: whole_string_type
   use dg_unit_kind, only: unit_factor, unit_label
   implicit none
   private
   public :: append_page_data, governing_case

   !> Charts of the page: panels side by side over one depth, each with columns of a profile. `turn`: an angle; `most`: values above
   !> are not shown; `limit`: a limit of compression, a dashed line without part in the range.
   character(*), parameter :: charts(*) = [character(330) :: &
      '{"title":"Forces","panels":[{"label":"effective axial force","curves":[{"column":"axial"}]},'// &
      '{"label":"torque","curves":[{"column":"torque"}]},'// &
      '{"label":"side force on a joint","curves":[{"column":"side_force_on_joint"}]},', &
      '{"label":"bending moment","curves":[{"column":"bending"}]},'// &
      '{"label":"clock angle","curves":[{"column":"clock"}],"turn":true,"low":0,"high":360,"ticks":[0,90,180,270]}]},', &
      '{"title":"Strength","panels":[{"label":"von Mises stress","curves":[{"column":"von_mises"}]},'// &
      '{"label":"safety factor","curves":[{"column":"safety_factor"}],"most":10},', &
      '{"label":"bending stress","curves":[{"column":"bending_stress"}]},'// &
      '{"label":"bending range in a turn","curves":[{"column":"bending_range"}]}]},', &
      '{"title":"Buckling","panels":[{"label":"axial force and limit","curves":[{"column":"axial"},'// &
      '{"column":"sinusoidal_load","limit":true,"mark":0,"look":'// &
      '{"stroke":"currentColor","stroke-dasharray":"2 3","stroke-width":1}}]},', &
      '{"label":"margin to buckling","curves":[{"column":"buckling_margin"}]},'// &
      '{"label":"displacement","curves":[{"column":"displacement"}]},{"label":"standoff","curves":[{"column":"standoff"}]}]},', &
      '{"title":"Well","panels":[{"label":"inclination","curves":[{"column":"inclination"}]},'// &
      '{"label":"azimuth","curves":[{"column":"azimuth"}]},', &
      '{"label":"dogleg","curves":[{"column":"dogleg"}]},{"label":"true vertical depth","curves":[{"column":"tvd"}]}]}']
   !> Thinning of curves, over the range of a column [-]: the finest with which the data stay below `most_letters`.
   real(wp), parameter :: tolerances(3) = [3.0e-4_wp, 1.0e-3_wp, 3.0e-3_wp]
   integer, parameter :: most_letters = 4000000
   !> Length from the bit upwards that the script draws with its contacts (shown_length of page.js) [m].
   real(wp), parameter :: assembly_length = 40.0_wp
   integer, parameter :: digits = 7, contact_digits = 4, tolerance_digits = 2
   real(wp), parameter :: percent = 0.01_wp

contains

   !> True if a result has curves.
   elemental function has_curves(result) result(has)
      type(case_result_type), intent(in) :: result
      logical :: has
      has = result%status == result_converged .and. allocated(result%profile%md)
   end function has_curves

   !> The load case that is shown first: with curves, the first that cannot be done, else the one nearest to a limit; 0: none.
   pure function governing_case(job, results, wholes) result(number)
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)
      integer :: number
      real(wp) :: used, most
      integer :: i
      number = 0
      most = -1.0_wp
      do i = 1, size(results)
         if (.not. has_curves(results(i)) .or. results(i)%model /= leading_model(job)) cycle
         used = 0.0_wp
         if (wholes(i)%verdict%used%present) used = wholes(i)%verdict%used%value
         if (wholes(i)%verdict%answer == answer_no) used = huge(used)
         if (used <= most) cycle
         most = used
         number = results(i)%case_index
      end do
   end function governing_case

   !> The data, in an element of the page: what stands along the string of the load cases where one is shown, figures of the run.
   subroutine append_page_data(lines, job, model, results, alongs, pictures, shown)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(picture_list_type), intent(in) :: pictures
      integer, intent(in) :: shown                          !< load case that is shown first; 0: none
      type(text_type), allocatable :: curves(:, :), rows(:)
      type(series_list_type) :: list
      real(wp) :: tolerance
      integer :: i
      tolerance = tolerances(1)
      if (shown > 0) then
         i = findloc(has_curves(results), .true., dim=1)
         list = curve_series(results(i)%profile, alongs(i))    ! for their names
         call find_curves(job, results, alongs, list%count, curves, rows, tolerance)
      else
         allocate (list%items(0))
      end if
      call add_line(lines, '<script type="application/json" id="data">')
      call add_line(lines, '{"units":'//json_string(trim(job%units%name))//',"systems":['//systems_text()//'],"thinned":'// &
                       json_string(to_text(tolerance/percent, tolerance_digits)//' %')//',')
      call append_quantities(lines, job%units)
      if (shown > 0) then
         call add_line(lines, '"start":'//to_text(shown - 1)//',')
         call append_columns(lines, list)
         call append_cases(lines, job, model)
         call add_line(lines, '"charts":[')
         do i = 1, size(charts)
            call add_line(lines, trim(charts(i)))
         end do
         call add_line(lines, '],"profiles":[')
         call append_profiles(lines, job, model, results, list, curves, rows, shown)
         call add_line(lines, '],')
      end if
      call append_figures(lines, pictures, tolerance)
      call add_line(lines, '}</script>')
   end subroutine append_page_data

   !> Curves of all results, thinned as little as their size allows.
   subroutine find_curves(job, results, alongs, columns, curves, rows, tolerance)
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)          !< as many
      integer, intent(in) :: columns                            !< their number
      type(text_type), allocatable, intent(out) :: curves(:, :) !< by column and result
      type(text_type), allocatable, intent(out) :: rows(:)      !< depths of the rows of results, '' where no curve has them
      real(wp), intent(out) :: tolerance                        !< to which they are thinned
      integer :: i, k
      allocate (curves(columns, size(results)), rows(size(results)))
      do k = 1, size(tolerances)
         tolerance = tolerances(k)
         do i = 1, size(results)
            if (has_curves(results(i))) &
               call profile_curves(results(i)%profile, alongs(i), job%units, tolerance, curves(:, i), rows(i))
         end do
         if (letters_of(curves, rows) <= most_letters) exit
      end do
   end subroutine find_curves

   !> Letters of all curves, and of the depths that they share.
   pure function letters_of(curves, rows) result(number)
      type(text_type), intent(in) :: curves(:, :), rows(:)
      integer :: number
      integer :: i, k
      number = 0
      do i = 1, size(curves, 2)
         if (allocated(rows(i)%text)) number = number + len(rows(i)%text)
         do k = 1, size(curves, 1)
            if (allocated(curves(k, i)%text)) number = number + len(curves(k, i)%text)
         end do
      end do
   end function letters_of

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
   subroutine append_columns(lines, list)
      type(line_list_type), intent(inout) :: lines
      type(series_list_type), intent(in) :: list
      character(:), allocatable :: text
      integer :: i, k
      call add_line(lines, '"columns":{')
      do i = 1, list%count
         associate (series => list%items(i), column => list%items(i)%column)
            text = json_string(trim(column%name))//':{"label":'//json_string(spaced(trim(column%name)))// &
                   ',"quantity":'//json_string(quantity_key(column%quantity))// &
                   ',"meaning":'//json_string(trim(column%meaning))
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

   !> The curves of each result that has some. One that an earlier result has, too, is a number: the place of that one.
   subroutine append_profiles(lines, job, model, results, list, curves, rows, shown)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(series_list_type), intent(in) :: list
      type(text_type), intent(in) :: curves(:, :)   !< of its columns, by result
      type(text_type), intent(in) :: rows(:)        !< depths of their rows
      integer, intent(in) :: shown                  !< load case that is shown first
      integer :: places(count(has_curves(results))), i, k, j, same
      character(:), allocatable :: text
      places = pack([(i, i=1, size(results))], has_curves(results))
      do i = 1, size(places)
         call add_line(lines, '{"case":'//to_text(results(places(i))%case_index - 1)//',"model":'// &
                          json_string(trim(model_name(results(places(i))%model)))//',"key":'// &
                          profile_key(job, model, results(places(i)), shown)//',')
         if (rows(places(i))%text /= '') call add_line(lines, '"depths":'//rows(places(i))%text//',')
         if (allocated(results(places(i))%contacts)) call add_line(lines, '"contacts":['// &
                                                                  contacts_text(job, results(places(i)))//'],')
         call add_line(lines, '"curves":{')
         text = ''
         do k = 1, list%count
            associate (curve => curves(k, places(i))%text)
               if (curve == '') cycle
               same = 0
               do j = 1, i - 1
                  if (curves(k, places(j))%text == curve .and. has_own_depths(curve)) exit
                  same = j
               end do
               if (text /= '') call add_line(lines, text//',')
               text = json_string(trim(list%items(k)%column%name))//':'
               if (j < i) then
                  text = text//to_text(same)
               else
                  text = text//curve
               end if
            end associate
         end do
         call add_line(lines, text)
         call add_line(lines, '}}'//trim(merge(',', ' ', i < size(places))))
      end do
   end subroutine append_profiles

   !> Entry of a profile in the legend: name and look. Methods differ by their dashes, load cases by their marks; the case that is
   !> shown first has none.
   pure function profile_key(job, model, result, shown) result(key)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      integer, intent(in) :: shown
      character(:), allocatable :: key
      integer :: method, turn
      method = findloc(job%models, result%model, dim=1)
      turn = modulo(result%case_index - shown, size(model%cases))
      if (turn == 0) then
         key = look_text(line_style(method))
      else
         key = look_text(marked_line_style(turn*size(job%models) + method, 1, 1.0_wp, dash_of(method)))
      end if
      key = '{"text":'//json_string(model%cases(result%case_index)%name//' '//trim(model_name(result%model)))//key//'}'
   end function profile_key

   !> Depth, force and clock angle of each contact of the assembly.
   function contacts_text(job, result) result(text)
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result      !< with contacts
      character(:), allocatable :: text
      real(wp) :: top
      integer :: i
      text = ''
      top = result%profile%md(size(result%profile%md)) - assembly_length
      do i = 1, size(result%contacts)
         associate (contact => result%contacts(i))
            if (contact%md < top) cycle
            if (text /= '') text = text//','
            text = text//'['//to_text(contact%md/job%units%length, digits)//','// &
                   to_text(contact%force/job%units%force, contact_digits)//','// &
                   to_text(contact%clock/job%units%angle, contact_digits)//']'
         end associate
      end do
   end function contacts_text
end module dg_page_data

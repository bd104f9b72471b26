!> Curves along the string of all load cases for the page, as JSON: charts, curves by page_curves, legend, contacts. Load cases with
!> too many points have fewer curves, or less exact ones.
module dg_page_profiles
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_curve_look, only: dash_of, line_style, marked_line_style, style_count
   use dg_findings, only: findings_type
   use dg_job, only: job_type, model_name
   use dg_json, only: json_string
   use dg_line_list, only: add_line, line_list_type
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_page_code, only: letters_of
   use dg_page_curves, only: accuracy_type, profile_curves, share_type, stands_alone
   use dg_page_figures, only: look_text
   use dg_page_thinning, only: finest
   use dg_series, only: series_list_type
   use dg_text, only: either, text_type, to_text
   implicit none
   private
   public :: append_profiles, case_looks, charts, curves_type, find_curves, has_curves, reduced_text, thinned_text

   !> Charts of the page: panels side by side over one depth, each with columns of a profile. `turn`: an angle; `most`: values above
   !> are not shown; `limit`: a limit of compression, a dashed line without part in the range.
   character(*), parameter :: charts(*) = [character(330) :: &
      '{"title":"Forces","panels":[{"label":"effective axial force","curves":[{"column":"axial"}]},'// &
      '{"label":"torque","curves":[{"column":"torque"}]},'// &
      '{"label":"side force per joint of pipe","curves":[{"column":"side_force_on_joint"}]},', &
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
   !> Columns that the well is drawn from, besides those of charts.
   character(*), parameter :: well_columns(6) = [character(9) :: 'north', 'east', 'od', 'hole', 'gap_state', 'buckling']
   !> Letters of the curves of a run: of few load cases together, for each of more, of all together at most. A load case leaves what
   !> it does not need to others. One that needs more than the rest leaves columns without a chart out. Then its longest curves,
   !> which oscillate, are thinned more, until all fit. Smooth curves are short and keep the finest tolerance.
   integer, parameter :: few_letters = 300000, case_letters = 60000, most_letters = 4000000
   !> Factor by which the room of a curve shrinks, and its least value [letters].
   real(wp), parameter :: shorter = 0.75_wp, shortest = 100.0_wp
   !> Length from the bit upwards that the script draws with its contacts (shown_length of page.js) [m].
   real(wp), parameter :: assembly_length = 40.0_wp
   integer, parameter :: digits = 7, contact_digits = 4, tolerance_digits = 2
   real(wp), parameter :: percent = 0.01_wp

   !> Curves of all results.
   type :: curves_type
      type(text_type), allocatable :: texts(:, :)   !< by column and result
      type(text_type), allocatable :: rows(:)       !< depths that curves of a result share; '': none
      type(accuracy_type), allocatable :: accuracy(:, :)   !< by column and result
      integer :: reduced = 0                        !< load cases without all columns
   end type curves_type

contains

   !> True if a result has curves.
   elemental function has_curves(result) result(has)
      type(case_result_type), intent(in) :: result
      logical :: has
      has = result%status == result_converged .and. allocated(result%profile%md)
   end function has_curves

   !> Curves of all results, thinned as little as their size allows.
   subroutine find_curves(found, list, curves)
      type(findings_type), intent(in) :: found
      type(series_list_type), intent(in) :: list                !< names of the columns
      type(curves_type), intent(out) :: curves
      type(share_type) :: share
      integer, allocatable :: letters(:)
      integer :: i, k, room, cases
      allocate (curves%texts(list%count, size(found%results)), curves%accuracy(list%count, size(found%results)), &
                curves%rows(size(found%results)))
      allocate (letters(maxval(found%results%case_index)), source=0)
      do i = 1, size(letters)
         call write_case(share_type(), i, letters(i))
      end do
      cases = count(letters > 0)
      room = room_in(min(max(few_letters, cases*case_letters), most_letters), letters)
      do i = 1, size(letters)
         if (letters(i) <= room) cycle
         share = share_type([(has_chart(trim(list%items(k)%column%name)), k=1, list%count)])
         call write_case(share, i, letters(i))
         share%letters = room
         do while (letters(i) > room .and. share%letters > shortest)
            share%letters = shorter*share%letters
            call write_case(share, i, letters(i))
         end do
         curves%reduced = curves%reduced + 1
      end do
   contains
      !> Write the curves of a load case by all models.
      subroutine write_case(share, number, letters)
         type(share_type), intent(in) :: share
         integer, intent(in) :: number             !< of the load case
         integer, intent(out) :: letters
         integer :: n
         letters = 0
         do n = 1, size(found%results)
            if (found%results(n)%case_index /= number .or. .not. has_curves(found%results(n))) cycle
            call profile_curves(found%results(n)%profile, found%alongs(n), found%job%units, share, curves%texts(:, n), &
                                curves%accuracy(:, n), curves%rows(n))
            letters = letters + letters_of(curves%rows(n:n)) + letters_of(curves%texts(:, n))
         end do
      end subroutine write_case
   end subroutine find_curves

   !> Most letters that each load case may have, so that all together have no more than a total.
   pure function room_in(total, letters) result(room)
      integer, intent(in) :: total
      integer, intent(in) :: letters(:)     !< that each one needs
      integer :: room
      integer :: rest, i
      rest = total
      associate (ascending => letters(sorted_places(real(letters, wp))))
         do i = 1, size(letters)
            room = rest/(size(letters) - i + 1)
            if (ascending(i) > room) return
            rest = rest - ascending(i)
         end do
      end associate
      room = maxval(letters)
   end function room_in

   !> True if a column is in a chart or in the well.
   pure function has_chart(name) result(has)
      character(*), intent(in) :: name
      logical :: has
      has = any(index(charts, '"column":"'//name//'"') > 0) .or. any(name == well_columns)
   end function has_chart

   !> The tolerance to which curves are thinned.
   pure function thinned_text() result(text)
      character(:), allocatable :: text
      text = to_text(finest/percent, tolerance_digits)//' %'
   end function thinned_text

   !> Sentence on load cases with many points: they have fewer columns, and less exact curves. It is empty where there are none.
   pure function reduced_text(curves) result(text)
      type(curves_type), intent(in) :: curves
      character(:), allocatable :: text
      text = ''
      if (curves%reduced == 0) return
      text = ' '//to_text(curves%reduced)//either(' load case has', ' load cases have', curves%reduced == 1)// &
             ' many points: only the columns of charts are here.'
      if (any(curves%accuracy%within > finest)) text = text//' Curves that oscillate are '// &
         'less exact there, as the box of values says.'
   end function reduced_text

   !> The curves of each result that has some. One that an earlier result has, too, is a number: the place of that one.
   subroutine append_profiles(lines, found, list, curves)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(series_list_type), intent(in) :: list
      type(curves_type), intent(in) :: curves
      integer :: places(count(has_curves(found%results))), i, k
      logical :: some
      places = pack([(i, i=1, size(found%results))], has_curves(found%results))
      do i = 1, size(places)
         associate (result => found%results(places(i)))
            call add_line(lines, '{"case":'//to_text(result%case_index - 1)//',"model":'// &
                             json_string(trim(model_name(result%model)))//',"key":'// &
                             profile_key(found%job, found%model, result)//',')
            if (.not. is_missing(result%bit_side_force)) call add_line(lines, '"held":true,')
            if (allocated(result%contacts)) call add_line(lines, '"contacts":['//contacts_text(found%job, result)//'],')
         end associate
         call append_depths(lines, curves, places(:i))
         call append_bands(lines, list, curves%accuracy(:, places(i)))
         call add_line(lines, '"curves":{')
         some = .false.
         do k = 1, list%count
            if (curves%texts(k, places(i))%text == '') cycle
            call add_line(lines, trim(merge(',', ' ', some))//json_string(trim(list%items(k)%column%name))//':'// &
                             curve_or_place(curves, k, places(:i)))
            some = .true.
         end do
         call add_line(lines, '}}'//trim(merge(',', ' ', i < size(places))))
      end do
   end subroutine append_profiles

   !> Depths that the curves of the last of some results share, or the place of the first result that has the same.
   subroutine append_depths(lines, curves, results)
      type(line_list_type), intent(inout) :: lines
      type(curves_type), intent(in) :: curves
      integer, intent(in) :: results(:)
      integer :: j, last
      last = size(results)
      associate (rows => curves%rows(results(last))%text)
         if (rows == '') return
         do j = 1, last - 1
            if (curves%rows(results(j))%text == rows) exit
         end do
         if (j < last) then
            call add_line(lines, '"depths":'//to_text(j - 1)//',')
         else
            call add_line(lines, '"depths":'//rows//',')
         end if
      end associate
   end subroutine append_depths

   !> Distances within which curves stay that are thinned more than others.
   subroutine append_bands(lines, list, accuracy)
      type(line_list_type), intent(inout) :: lines
      type(series_list_type), intent(in) :: list
      type(accuracy_type), intent(in) :: accuracy(:)     !< by column
      character(:), allocatable :: text
      integer :: k
      text = ''
      do k = 1, list%count
         if (accuracy(k)%within <= finest) cycle
         text = text//either(',', '', text /= '')//json_string(trim(list%items(k)%column%name))//':'// &
                to_text(accuracy(k)%band, tolerance_digits)
      end do
      if (text /= '') call add_line(lines, '"bands":{'//text//'},')
   end subroutine append_bands

   !> A curve of the last of some results, or the place of the first result that has the same.
   pure function curve_or_place(curves, column, results) result(json)
      type(curves_type), intent(in) :: curves
      integer, intent(in) :: column, results(:)
      character(:), allocatable :: json
      integer :: j, last
      last = size(results)
      json = curves%texts(column, results(last))%text
      do j = 1, last - 1
         if (curves%texts(column, results(j))%text /= json) cycle
         if (.not. stands_alone(json, curves%rows(results(j))%text == curves%rows(results(last))%text)) cycle
         json = to_text(j - 1)
         return
      end do
   end function curve_or_place

   !> Entry of a profile in the legend: name and look of its method. Methods differ by colour and dash; where several load cases
   !> are shown, by dash alone.
   pure function profile_key(job, model, result) result(key)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      character(:), allocatable :: key
      key = '{"text":'//json_string(model%cases(result%case_index)%name//' '//trim(model_name(result%model)))// &
            look_text(line_style(findloc(job%models, result%model, dim=1)))//'}'
   end function profile_key

   !> Colours and marks of load cases that are shown together.
   pure function case_looks() result(json)
      character(:), allocatable :: json
      character(:), allocatable :: look
      integer :: i
      json = ''
      do i = 1, style_count
         look = look_text(marked_line_style(i, 1, 1.0_wp, dash_of(1)))
         json = json//either('', ',', i == 1)//'{'//look(2:)//'}'
      end do
   end function case_looks

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
end module dg_page_profiles

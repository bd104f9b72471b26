!> Pictures of the page: places of the charts that its script draws, fixed pictures for readers without script, and pictures of
!> the whole run.
module dg_html_pictures
   use dg_case_result, only: case_result_type, result_converged, result_status_name
   use dg_file_lines, only: read_lines
   use dg_findings, only: findings_type
   use dg_html_text, only: append_inline_svg, append_rows
   use dg_job, only: job_type, leading_model
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_model, only: model_type
   use dg_page_figures, only: is_live
   use dg_picture_data, only: picture_data_type
   use dg_picture_list, only: folder_in, picture_list_type, picture_type
   use dg_readable, only: first_names, spaced
   use dg_text, only: quoted, text_type, to_text
   use dg_verdict, only: answer_name, answer_yes
   implicit none
   private
   public :: append_pictures

   character(*), parameter :: hint = '<p class="hint">Point at a depth to read all curves there. Drag up or down, or spread '// &
      'two fingers, to zoom. Double click for the whole depth. Arrow keys move the slider.</p>'
   !> Of a fixed picture that stands beside a chart of the script.
   integer, parameter :: most_letters = 150000
   !> Load cases without curves that are named.
   integer, parameter :: most_names = 4

contains

   !> Append charts that the script draws, with fixed pictures for readers without script. They show the load case nearest to a
   !> limit. Then append the pictures of the whole run.
   subroutine append_pictures(lines, found, list, shown)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(picture_list_type), intent(in) :: list
      integer, intent(in) :: shown               !< that load case; 0: none has a picture
      logical :: of_run(size(list%pictures))
      integer :: k
      if (.not. all(list%pictures%drawn)) &
         call add_line(lines, '<p class="note warn">'//to_text(count(.not. list%pictures%drawn))//' of '// &
                       to_text(size(list%pictures))//' pictures are not drawn: gnuplot was not there or failed. All scripts '// &
                       'stand in the folder of results.</p>')
      if (shown > 0) then
         call add_line(lines, '<h2>Along the string</h2>'//without_text(found%model, &
            pack(found%results, found%results%model == leading_model(found%job) .and. &
                 found%results%status /= result_converged), shown)//hint)
         call add_line(lines, '<div class="live"></div><div class="static">')
         call add_line(lines, '<h3>Load case '//html_safe(found%model%cases(shown)%name)//'</h3><p>Pictures of all load '// &
                          'cases stand in the folder <code>pictures</code>.</p>')
         do k = 1, size(list%pictures)
            if (list%pictures(k)%case_index == shown .and. list%pictures(k)%drawn) &
               call append_picture(lines, found%job, list%pictures(k), k, ' of '//html_safe(found%model%cases(shown)%name))
         end do
         call add_line(lines, '</div>')
      end if
      of_run = list%pictures%case_index == 0 .and. (list%pictures%drawn .or. is_live(list%pictures))
      if (any(of_run)) call add_line(lines, '<h2>Pictures of the run</h2>')
      if (shown == 0 .and. any(is_live(list%pictures))) call add_line(lines, hint)
      do k = 1, size(list%pictures)
         if (of_run(k)) call append_picture(lines, found%job, list%pictures(k), k, '')
      end do
      if (list%empty /= '') call add_line(lines, '<p class="note">Not drawn, as no value is known: '// &
                                          html_safe(list%empty)//'. Answers, warnings and tables say why.</p>')
      if (.not. found%job%profiles) &
         call add_line(lines, '<p>Picture files along the string need <code>profiles = .true.</code></p>')
   end subroutine append_pictures

   !> Load cases that have no curves, and the one that is shown in their place; '' if all have curves.
   function without_text(model, lost, shown) result(text)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: lost(:)      !< results without a solution
      integer, intent(in) :: shown
      character(:), allocatable :: text
      type(text_type) :: names(size(lost))
      integer :: i
      text = ''
      if (size(lost) == 0) return
      do i = 1, size(lost)
         names(i)%text = quoted(model%cases(lost(i)%case_index)%name)//' ('// &
                         trim(spaced(trim(result_status_name(lost(i)%status))))//')'
      end do
      text = '<p class="note">No solution, so no curves: '//html_safe(first_names(names, most_names)//'. Shown first: '// &
             quoted(model%cases(shown)%name))//'.</p>'
   end function without_text

   !> A picture: the place of a chart, where the script draws one, and the fixed picture.
   subroutine append_picture(lines, job, picture, number, of_case)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(picture_type), intent(in) :: picture
      integer, intent(in) :: number
      character(*), intent(in) :: of_case        !< behind a heading, in HTML; '' for a picture of the run
      character(:), allocatable :: title
      title = ''
      if (is_live(picture)) title = picture%chart%title
      call add_line(lines, '<figure>')
      if (is_live(picture)) call add_line(lines, '<h3>'//html_safe(title)//'</h3><div class="live"></div><div class="static">')
      if (picture%drawn) call append_fixed(lines, job, picture, number)
      if (is_live(picture)) call add_line(lines, '</div>')
      if (picture%caption /= title) call add_line(lines, '<figcaption>'//html_safe(picture%caption)//'</figcaption>')
      call append_data(lines, job, picture%data, of_case)
      call add_line(lines, '</figure>')
   end subroutine append_picture

   !> The picture itself. One of the run that is too large is named instead.
   subroutine append_fixed(lines, job, picture, number)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(picture_type), intent(in) :: picture
      integer, intent(in) :: number
      type(text_type), allocatable :: svg(:)
      character(:), allocatable :: failure
      integer :: i
      call read_lines(folder_in(job)//'/'//picture%name//'.svg', svg, failure)
      if (failure /= '') then
         call add_line(lines, '<p class="note warn">Picture '//html_safe(failure)//'</p>')
      else if (is_live(picture) .and. sum([(len(svg(i)%text), i=1, size(svg))]) > most_letters) then
         call add_line(lines, '<p class="note">A large picture: pictures/'//html_safe(picture%name)//'.svg</p>')
      else
         call append_inline_svg(lines, svg, 'p'//to_text(number))
      end if
   end subroutine append_fixed

   !> The numbers of a picture, in a table that opens beneath it; the file that has all.
   subroutine append_data(lines, job, data, of_case)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(picture_data_type), intent(in) :: data
      character(*), intent(in) :: of_case        !< as append_picture
      character(:), allocatable :: link
      logical :: marked(size(data%rows))
      integer :: i, k
      link = '<a href="'//html_safe(data%file)//'">'//html_safe(data%file)//'</a>'
      if (size(data%rows) == 0) then
         call add_line(lines, '<p class="data">Numbers: '//link//'</p>')
         return
      end if
      marked = .false.
      do k = 1, size(data%rows)
         do i = 1, data%rows(k)%count
            associate (field => data%rows(k)%fields(i))
               if (field%column%name == 'can_be_done') marked(k) = field%text /= trim(answer_name(answer_yes))
               if (field%column%name == 'status') marked(k) = field%text /= trim(result_status_name(result_converged))
            end associate
         end do
      end do
      call add_line(lines, '<details><summary>Numbers'//of_case//'</summary>')
      call append_rows(lines, job%units, data%rows, marked)
      if (data%every > 1) call add_line(lines, '<p>One row of each '//to_text(data%every)//'.</p>')
      call add_line(lines, '<p>All: '//link//'</p></details>')
   end subroutine append_data
end module dg_html_pictures

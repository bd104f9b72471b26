!> One picture of a whole run: hook load of every case by every model, with measurement and reference; beside it the error
!> against measurement, and torque where any case has one.
module dg_hookload_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_comparison, only: as_measured, percent_error
   use dg_gnuplot_script, only: add_series, colour_measured, end_script, legend, letter_width, mark_style, panel, plot, row_tics, &
                                series_type, start_script
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, optional_real, rotates
   use dg_model, only: model_type
   use dg_rig, only: indicated_load
   use dg_text, only: append_text, text_type, to_text
   use dg_column, only: quantity_moment, unit_text
   use dg_verdict_text, only: mark_meaning, row_mark
   implicit none
   private
   public :: hookload_script

   integer, parameter :: digits = 8
   integer, parameter :: width = 1120
   !> Heights [px]: of a case by one model, of each further model, of title and legend, of the axis below.
   integer, parameter :: row_height = 26, model_height = 6, head_height = 84, foot_height = 62
   !> Part of a case's height in which the marks of its models stand one below the other: they would hide each other in a row.
   real(wp), parameter :: spread = 0.6_wp
   !> Largest part of the picture that names of cases may take.
   real(wp), parameter :: most_names = 0.3_wp
   character(*), parameter :: absent = 'NaN'

contains

   !> Script of the picture of all hook loads beside what was measured.
   subroutine hookload_script(name, job, model, results, marked, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: marked(:)      !< as many: cannot be done, or no solution
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      type(text_type) :: names(size(model%cases))
      logical :: with_error, with_torque
      real(wp) :: left, wide, bottom, top, height
      integer :: i, n, panels, at, longest
      character(:), allocatable :: tics, label
      n = size(model%cases)
      height = real(head_height + foot_height + (row_height + model_height*(size(job%models) - 1))*n, wp)
      with_error = any(model%cases%measured_hookload%present)
      with_torque = any(has_torque(model%cases))
      panels = 1 + count([with_error, with_torque])
      longest = 0
      do i = 1, n
         names(i)%text = model%cases(i)%name
         if (any(marked .and. results%case_index == i)) names(i)%text = names(i)%text//' '//row_mark
         longest = max(longest, len(names(i)%text))
      end do
      left = min(most_names, letter_width*real(longest + 2, wp)/real(width, wp))
      tics = row_tics(names, left, width)
      wide = (0.985_wp - left)/real(panels, wp) - 0.02_wp
      bottom = real(foot_height, wp)/height
      top = 1.0_wp - real(head_height, wp)/height
      call start_script(lines, name, width, nint(height))
      call append_data(lines, job, model, results)
      call append_text(lines, 'set datafile separator whitespace')
      ! columns: case, measured, reference, measured torque; then hook load, error, torque of each model
      do i = 1, size(job%models)
         call add_marks(5 + 3*(i - 1), mark_style(i, 0.8_wp), trim(model_name(job%models(i))), i)
      end do
      if (with_error) call add_marks(2, "with points pt 2 ps 1.1 lw 1.6 lc rgb '"//colour_measured//"'", 'measured')
      if (any(model%cases%reference_hookload%present)) &
         call add_marks(3, "with points pt 6 ps 1.3 lw 1.2 lc rgb '"//colour_measured//"'", 'reference')
      if (any(results%status /= result_converged)) &
         call add_series(series, 'NaN', "with lines lc rgb '#ffffff'", 'not converged cases are left out')
      if (any(marked)) call add_series(series, 'NaN', "with lines lc rgb '#ffffff'", mark_meaning)
      call legend(lines, 'Hook load of all cases', series, top + 8.0_wp/height, 1.0_wp - 40.0_wp/height)
      call append_text(lines, 'set yrange ['//to_text(real(n, wp) + 0.6_wp, digits)//':0.4]')
      label = 'hook load'
      if (model%rig%given) label = 'hook load as the rig shows it'
      call panel(lines, left, left + wide, bottom, top, label//' ['//trim(job%units%force_label)//']', ' ')
      call append_text(lines, 'set ytics ('//tics//'); unset ylabel')
      ! no mark on the frame
      call append_text(lines, 'set autoscale xfix; set offsets graph 0.04, graph 0.04, 0, 0')
      call plot(lines, series, may_lack=.true.)
      at = 1
      if (with_error) then
         deallocate (series)
         do i = 1, size(job%models)
            call add_marks(6 + 3*(i - 1), mark_style(i, 0.8_wp), '', i)
         end do
         call next_panel('error against measurement [%]')
         call append_text(lines, 'set xrange [0:*]')
         call plot(lines, series, may_lack=.true.)
      end if
      if (with_torque) then
         deallocate (series)
         do i = 1, size(job%models)
            call add_marks(7 + 3*(i - 1), mark_style(i, 0.8_wp), '', i)
         end do
         if (any(model%cases%measured_torque%present)) &
            call add_marks(4, "with points pt 2 ps 1.1 lw 1.6 lc rgb '"//colour_measured//"'", '')
         call next_panel('torque at the top ['//unit_text(quantity_moment, job%units)//']')
         call append_text(lines, 'set xrange [0:*]')
         call plot(lines, series, may_lack=.true.)
      end if
      call end_script(lines)

   contains

      !> Marks on the lines of the cases, those of a model (one of `job%models`) beside them.
      subroutine add_marks(column, look, title, number)
         integer, intent(in) :: column
         character(*), intent(in) :: look, title
         integer, intent(in), optional :: number
         real(wp) :: beside
         beside = 0.0_wp
         if (present(number)) beside = spread*(real(number, wp)/real(size(job%models) + 1, wp) - 0.5_wp)
         call add_series(series, '$cases using '//to_text(column)//':($1 + '//to_text(beside, digits)//')', look, title)
      end subroutine add_marks

      subroutine next_panel(label)
         character(*), intent(in) :: label
         real(wp) :: start
         start = left + real(at, wp)*(wide + 0.025_wp)
         call panel(lines, start, start + wide, bottom, top, label, '')
         call append_text(lines, 'set ytics 1')
         at = at + 1
      end subroutine next_panel
   end subroutine hookload_script

   !> The numbers drawn, one row a case.
   pure subroutine append_data(lines, job, model, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      character(:), allocatable :: row
      type(optional_real) :: reference
      integer :: i, k
      call append_text(lines, '# case, measured and reference hook load, measured torque; of each model hook load, error, torque')
      call append_text(lines, '$cases << END')
      do i = 1, size(model%cases)
         associate (load_case => model%cases(i))
            reference = load_case%reference_hookload
            if (model%rig%given) reference%value = indicated_load(model%rig, load_case%operation, reference%value)
            row = to_text(i)//' '//cell(load_case%measured_hookload, job%units%force)//' '// &
               cell(reference, job%units%force)//' '//cell(load_case%measured_torque, job%units%moment)
            do k = 1, size(job%models)
               row = row//model_cells(load_case, results, i, job%models(k), job)
            end do
         end associate
         call append_text(lines, row)
      end do
      call append_text(lines, 'END')
   end subroutine append_data

   !> Hook load, error and torque of one case by one model.
   pure function model_cells(load_case, results, number, model, job) result(cells)
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: results(:)
      integer, intent(in) :: number       !< of the case
      integer, intent(in) :: model        !< number of the model
      type(job_type), intent(in) :: job
      character(:), allocatable :: cells
      real(wp) :: hookload
      integer :: i
      do i = 1, size(results)
         if (results(i)%case_index /= number .or. results(i)%model /= model) cycle
         if (results(i)%status /= result_converged) cycle
         hookload = as_measured(results(i)%hookload, results(i)%weight_indicator)
         cells = ' '//to_text(hookload/job%units%force, digits)//' '// &
            cell(percent_error(hookload, load_case%measured_hookload), 1.0_wp)//' '
         if (has_torque(load_case)) then
            cells = cells//to_text(results(i)%torque/job%units%moment, digits)
         else
            cells = cells//absent
         end if
         return
      end do
      cells = ' '//absent//' '//absent//' '//absent
   end function model_cells

   !> Whether the torque of a case is more than round-off.
   elemental function has_torque(load_case) result(has)
      type(load_case_type), intent(in) :: load_case
      logical :: has
      has = rotates(load_case%operation) .or. abs(load_case%tob) > 0.0_wp
   end function has_torque

   pure function cell(number, unit) result(text)
      type(optional_real), intent(in) :: number
      real(wp), intent(in) :: unit
      character(:), allocatable :: text
      text = absent
      if (number%present) text = to_text(number%value/unit, digits)
   end function cell
end module dg_hookload_picture

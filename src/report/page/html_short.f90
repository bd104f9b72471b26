!> A run in a few sentences: load cases that cannot be done, largest stress, range of the hook load, buckling, accuracy of the
!> results.
module dg_html_short
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_block_question, only: block_question
   use dg_comparison, only: as_measured, percent_error
   use dg_findings, only: findings_type, rows_of
   use dg_job, only: job_type, leading_model, model_mcge, model_meaning, model_name
   use dg_html_text, only: said_number
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_missing, only: is_missing, optional_real
   use dg_model, only: model_type
   use dg_run_outcome, only: outcome_type
   use dg_readable, only: first_names
   use dg_text, only: either, text_type, to_text
   use dg_unit_kind, only: unit_force, unit_length, unit_stress
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_no, limit_title, verdict_type
   use dg_verdict_table, only: unlike_text
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: append_short

   integer, parameter :: few = 4, fewer = 3    !< digits
   real(wp), parameter :: per_cent = 100.0_wp
   !> Load cases that a sentence names at most.
   integer, parameter :: most_named = 6

contains

   !> The sentences, of the load cases with one model: gap elements where they are asked for, else the first model; then of sweeps.
   subroutine append_short(lines, found, outcome)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(outcome_type), intent(in) :: outcome
      integer, allocatable :: rows(:)
      integer :: i, shown
      shown = leading_model(found%job)
      allocate (rows, source=rows_of(found, shown))
      rows = pack(rows, found%results(rows)%status == result_converged)
      if (size(found%results) == 0 .and. .not. allocated(outcome%sentences)) return
      call add_line(lines, '<h2>In short</h2>')
      if (size(found%results) > 0) call add_line(lines, '<p>By model '//trim(model_name(shown))//' ('// &
                                           trim(model_meaning(shown))//').</p>')
      call add_line(lines, '<ul>')
      call append_impossible(lines, found%job%units, found%model, pack(found%results%case_index, found%results%model == shown), &
                             pack(found%wholes%verdict, found%results%model == shown))
      if (size(rows) > 0) then
         call append_stress(lines, found%job%units, found%model, found%results(rows), found%alongs(rows))
         call append_loads(lines, found%job, found%model, found%results(rows))
         call append_buckled(lines, found%job%units, found%model, found%results(rows), found%wholes(rows), &
                             pack(found%results%case_index, found%results%model == shown .and. &
                                  found%results%status == result_locked_up))
         call append_errors(lines, found%job%units, found%model, found%results(rows))
         call append_models(lines, found, rows)
         if (shown == model_mcge) call append_moments(lines, found%model, found%results(rows), found%wholes(rows))
      end if
      if (allocated(outcome%sentences)) then
         do i = 1, size(outcome%sentences)
            call add_line(lines, '<li>'//html_safe(outcome%sentences(i)%text)//'.</li>')
         end do
      end if
      call add_line(lines, '</ul>')
   end subroutine append_short

   !> Load cases that cannot be done: how deep they can be, and the limit that decides.
   subroutine append_impossible(lines, units, model, cases, verdicts)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      integer, intent(in) :: cases(:)                       !< their numbers
      type(verdict_type), intent(in) :: verdicts(:)         !< as many
      character(:), allocatable :: depth
      integer :: i, told
      told = 0
      do i = 1, size(cases)
         if (verdicts(i)%answer /= answer_no) cycle
         told = told + 1
         if (told > most_named) cycle
         depth = ''
         if (verdicts(i)%reach%present) then
            if (verdicts(i)%reach%value > 0.0_wp) &
               depth = ' Possible down to about '//said_number(units, unit_length, verdicts(i)%reach%value, fewer, down=.true.)//'.'
         end if
         call add_line(lines, '<li>'//html_safe(model%cases(cases(i))%name)//': <b class="no">NO</b> ('// &
                       trim(limit_title(verdicts(i)%limit))//').'//depth//'</li>')
      end do
      if (told > most_named) call add_line(lines, '<li>'//to_text(told - most_named)//' more: NO.</li>')
      if (told == 0 .and. size(cases) > 0) call add_line(lines, '<li>Of the load cases none is answered NO.</li>')
   end subroutine append_impossible

   !> Largest von Mises stress of all load cases, with its depth.
   subroutine append_stress(lines, units, model, results, alongs)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      real(wp) :: most
      integer :: i, row, worst, place
      most = 0.0_wp
      do i = 1, size(results)
         if (.not. allocated(results(i)%profile%md)) cycle
         row = maxloc(alongs(i)%jointed_von_mises, dim=1, mask=.not. is_missing(alongs(i)%jointed_von_mises))
         if (row == 0) cycle
         if (alongs(i)%jointed_von_mises(row) <= most) cycle
         most = alongs(i)%jointed_von_mises(row)
         worst = i
         place = row
      end do
      if (most > 0.0_wp) call add_line(lines, '<li>Largest von Mises stress: '// &
         said_number(units, unit_stress, most, fewer)//' at '// &
         said_number(units, unit_length, results(worst)%profile%md(place), few)//' ('// &
         html_safe(model%cases(results(worst)%case_index)%name)//'), bending between tool joints included.</li>')
   end subroutine append_stress

   !> Least and greatest hook load.
   subroutine append_loads(lines, job, model, results)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      character(:), allocatable :: head
      integer :: least, most
      head = '<li>Hook load'//either(' without the block: ', ': ', model%rig%given)
      least = minloc(results%hookload, dim=1)
      most = maxloc(results%hookload, dim=1)
      if (size(results) == 1) then
         call add_line(lines, head//said_number(job%units, unit_force, results(1)%hookload, few)//' ('// &
                       html_safe(model%cases(results(1)%case_index)%name)//').</li>')
      else
         call add_line(lines, head//'from '// &
                       said_number(job%units, unit_force, results(least)%hookload, few)//' ('// &
                       html_safe(model%cases(results(least)%case_index)%name)//') to '// &
                       said_number(job%units, unit_force, results(most)%hookload, few)//' ('// &
                       html_safe(model%cases(results(most)%case_index)%name)//').</li>')
      end if
   end subroutine append_loads

   !> Append the cases that buckle by beams, or that are above the published limit by models on the axis, and where. Then those
   !> that lock up: without a solution their buckling is unknown.
   subroutine append_buckled(lines, units, model, results, wholes, locked)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)
      integer, intent(in) :: locked(:)         !< load cases that lock up
      type(text_type) :: places(size(results))
      type(optional_real) :: span(2)
      character(:), allocatable :: text
      integer :: i, buckled
      buckled = 0
      do i = 1, size(results)
         span = wholes(i)%buckled_span
         if (results(i)%model == model_mcge) span = wholes(i)%shape_span
         if (.not. span(1)%present) cycle
         buckled = buckled + 1
         places(buckled)%text = html_safe(model%cases(results(i)%case_index)%name)//' (from '// &
            said_number(units, unit_length, span(1)%value, few)//' to '//said_number(units, unit_length, span(2)%value, few)//')'
      end do
      text = 'Beyond a published buckling limit'
      if (results(1)%model == model_mcge) text = 'Found to buckle'
      if (buckled > 0) then
         call add_line(lines, '<li>'//text//': '//first_names(places(:buckled), most_named)//'.</li>')
      else
         call add_line(lines, '<li>'//text//': no load case'//either(' with a solution', '', size(locked) > 0)//'.</li>')
      end if
      if (size(locked) > 0) call add_line(lines, '<li>Locked up, buckling not known: '//named(model, locked)//'.</li>')
   end subroutine append_buckled

   !> Append hook loads against measured ones, and against another calculation.
   subroutine append_errors(lines, units, model, results)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(optional_real) :: measured(size(results)), reference(size(results))
      character(:), allocatable :: question
      integer :: i
      do i = 1, size(results)
         associate (load_case => model%cases(results(i)%case_index))
            measured(i) = percent_error(as_measured(results(i)%hookload, results(i)%weight_indicator), load_case%measured_hookload)
            reference(i) = percent_error(results(i)%hookload, load_case%reference_hookload)
         end associate
      end do
      call write_errors('Measured hook loads'//either('', ' (weight indicator, block included)', &
                                                      all(is_missing(results%weight_indicator))), measured)
      question = block_question(units, model%cases(results%case_index), results)
      if (question /= '') call add_line(lines, '<li>'//html_safe(question)//'.</li>')
      call write_errors('Reference hook loads', reference)
   contains
      subroutine write_errors(what, errors)
         character(*), intent(in) :: what
         type(optional_real), intent(in) :: errors(:)
         integer :: worst
         if (.not. any(errors%present)) return
         worst = maxloc(errors%value, dim=1, mask=errors%present)
         call add_line(lines, '<li>'//what//': '//to_text(count(errors%present))//', met within '// &
                       to_text(errors(worst)%value, fewer)//' %; the worst is '// &
                       html_safe(model%cases(results(worst)%case_index)%name)//'.</li>')
      end subroutine write_errors
   end subroutine append_errors

   !> Append the difference of hook loads of other models from these, and the cases that they answer otherwise.
   subroutine append_models(lines, found, rows)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      integer, intent(in) :: rows(:)           !< of the model that is shown
      character(:), allocatable :: otherwise
      real(wp) :: apart, worst, scale
      integer :: i, k, m, where_worst
      scale = maxval(abs(found%results(rows)%hookload))
      if (.not. scale > 0.0_wp) return
      do m = 1, size(found%job%models)
         if (found%job%models(m) == found%results(rows(1))%model) cycle
         worst = -1.0_wp
         where_worst = 0
         do i = 1, size(rows)
            do k = 1, size(found%results)
               if (found%results(k)%model /= found%job%models(m) .or. found%results(k)%status /= result_converged .or. &
                   found%results(k)%case_index /= found%results(rows(i))%case_index) cycle
               apart = abs(found%results(k)%hookload - found%results(rows(i))%hookload)
               if (apart > worst) then
                  worst = apart
                  where_worst = found%results(k)%case_index
               end if
            end do
         end do
         if (where_worst == 0) cycle
         otherwise = unlike_text(found, found%job%models(m))
         call add_line(lines, '<li>Model '//trim(model_name(found%job%models(m)))//': hook loads within '// &
                       said_number(found%job%units, unit_force, worst, fewer)//' of these, '// &
                       to_text(per_cent*worst/scale, fewer)//' % of the greatest; the worst is '// &
                       html_safe(found%model%cases(where_worst)%name)//'.'// &
                       either('', ' '//html_safe(otherwise), otherwise == '')//'</li>')
      end do
   end subroutine append_models

   !> Append the estimated error of bending moments.
   subroutine append_moments(lines, model, results, wholes)
      type(line_list_type), intent(inout) :: lines
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)
      integer :: worst
      if (.not. any(wholes%bending_error%present)) return
      worst = maxloc(wholes%bending_error%value, dim=1, mask=wholes%bending_error%present)
      call add_line(lines, '<li>Estimated error of bending moments: '// &
                    to_text(per_cent*wholes(worst)%bending_error%value, fewer)// &
                    ' % of the largest, in '// &
                    html_safe(model%cases(results(worst)%case_index)%name)//'.</li>')
   end subroutine append_moments

   !> Names of load cases, the first of many.
   function named(model, cases) result(text)
      type(model_type), intent(in) :: model
      integer, intent(in) :: cases(:)      !< their numbers
      character(:), allocatable :: text
      type(text_type) :: names(size(cases))
      integer :: i
      do i = 1, size(cases)
         names(i)%text = html_safe(model%cases(cases(i))%name)
      end do
      text = first_names(names, most_named)
   end function named
end module dg_html_short

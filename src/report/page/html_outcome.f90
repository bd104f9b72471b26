!> The headline of a page: number of solutions of a run, and those that failed.
module dg_html_outcome
   use dg_column, only: row_type
   use dg_error, only: status_not_converged
   use dg_html_text, only: append_rows
   use dg_line_list, only: add_line, line_list_type
   use dg_run_outcome, only: case_part, locked_count, lost_count, lost_row, outcome_type, part_row, solution_count
   use dg_text, only: either, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: append_outcome, append_lost

contains

   !> One sentence for all parts of a run; the parts where there are several.
   subroutine append_outcome(lines, units, outcome)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(outcome_type), intent(in) :: outcome
      type(row_type), allocatable :: rows(:)
      integer :: i, total, lost, locked
      total = solution_count(outcome)
      if (total == 0) return
      lost = lost_count(outcome)
      locked = locked_count(outcome)
      if (lost > 0) then
         call add_line(lines, '<p class="note warn">'//to_text(lost)//' of '//solutions_text(total)//' did not converge '// &
                       '(exit status '//to_text(status_not_converged)//').'//either(' ', '', locked > 0)//locked_text()//'</p>')
      else if (locked > 0) then
         call add_line(lines, '<p class="note">'//locked_text()//either(' The others were found.', '', locked < total)//'</p>')
      else if (total == 1) then
         call add_line(lines, '<p class="note">The calculation converged.'//place_text('answer stands')//'</p>')
      else
         call add_line(lines, '<p class="note">All '//solutions_text(total)//' were found.'//place_text('answers stand')//'</p>')
      end if
      if (size(outcome%parts) > 1) then
         allocate (rows(size(outcome%parts)))
         do i = 1, size(rows)
            rows(i) = part_row(outcome%parts(i))
         end do
         call append_rows(lines, units, rows, spread(.false., 1, size(rows)))
      end if
   contains
      !> Heading under which answers stand; '' where a part of the run has none.
      pure function place_text(what) result(text)
         character(*), intent(in) :: what
         character(:), allocatable :: text
         integer :: k
         text = ''
         if (any([(outcome%parts(k)%name == case_part .and. outcome%parts(k)%solutions > 0, k=1, size(outcome%parts))])) then
            text = 'Can it be done?'
         else if (allocated(outcome%sentences)) then
            text = 'In short.'
         end if
         if (text /= '') text = ' The '//what//' under '//text
      end function place_text

      !> Lock-up is a result of the string, not a failure.
      pure function locked_text() result(text)
         character(:), allocatable :: text
         text = ''
         if (locked > 0) text = to_text(locked)//' of '//solutions_text(total)//trim(merge(' locks up', ' lock up ', &
            locked == 1))//': the string cannot be brought to that depth or load.'
      end function locked_text

      pure function solutions_text(number) result(text)
         integer, intent(in) :: number
         character(:), allocatable :: text
         text = to_text(number)//trim(merge(' solution ', ' solutions', number == 1))
      end function solutions_text
   end subroutine append_outcome

   !> A row for each solution that failed or locked up.
   subroutine append_lost(lines, units, outcome)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(outcome_type), intent(in) :: outcome
      type(row_type), allocatable :: rows(:)
      integer :: i
      if (.not. allocated(outcome%lost)) return
      call add_line(lines, '<h2>Not solved, or locked up</h2>')
      allocate (rows(size(outcome%lost)))
      do i = 1, size(rows)
         rows(i) = lost_row(outcome%lost(i))
      end do
      call append_rows(lines, units, rows, spread(.false., 1, size(rows)))
      if (outcome%unlisted > 0) call add_line(lines, '<p>and '//to_text(outcome%unlisted)//' rows more: see the files of '// &
                                              'results.</p>')
   end subroutine append_lost

end module dg_html_outcome

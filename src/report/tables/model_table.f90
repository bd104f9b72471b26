!> Table of the models of a run side by side. It has hook load, torque and cost of each, and differences from the first model
!> of the deck. Every line fits 120 columns.
module dg_model_table
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers
   use dg_findings, only: are_marked, findings_type
   use dg_job, only: model_name
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_text, only: append_text, text_type
   use dg_text_table, only: add_cell, append_table, close_rows, end_row, text_table_type
   use dg_unit_kind, only: unit_label, unit_moment
   use dg_units, only: unit_system_type
   use dg_verdict_text, only: mark_meaning, row_mark
   implicit none
   private
   public :: model_table

   integer, parameter :: name_width = 24
   integer, parameter :: model_width = 8
   integer, parameter :: number_width = 12
   integer, parameter :: share_width = 9
   integer, parameter :: seconds_width = 10
   real(wp), parameter :: one = 1.0_wp
   !> Torque below which a difference in per cent is not shown [N.m].
   real(wp), parameter :: least_torque = 1.0_wp

contains

   !> The lines of the comparison, cases in the deck's order, in each the models in the deck's order. No line where
   !> there is one model.
   pure function model_table(found) result(lines)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: lines(:)
      type(text_table_type) :: table
      logical :: marked(size(found%results))
      integer :: i, j, first, row
      allocate (lines(0))
      if (size(found%job%models) < 2) return
      marked = are_marked(found)
      call append_text(lines, '')
      call append_text(lines, 'Models side by side; differences against '//trim(model_name(found%job%models(1))))
      do j = 1, size(found%model%cases)
         do i = 1, size(found%job%models)
            row = findloc(found%results%model == found%job%models(i) .and. found%results%case_index == j, .true., dim=1)
            if (i == 1) first = row
            if (row == 0 .or. first == 0) cycle
            call add_row(table, found%job%units, found%model, found%results(row), found%results(first), i == 1)
            call end_row(table, merge(' '//row_mark, '  ', marked(row)))
         end do
      end do
      call close_rows(table)
      do i = 1, size(found%job%models)
         call add_cell(table, '', name_width, 'all')
         call add_cell(table, '', model_width, model_name(found%job%models(i)))
         call add_cell(table, '', 4*number_width + 2*share_width, '')
         call add_cell(table, '', seconds_width, sum(found%results%seconds, found%results%model == found%job%models(i)), one, 4)
         call end_row(table, '')
      end do
      call append_table(lines, table)
      if (any(marked)) call append_text(lines, mark_meaning)
   end function model_table

   !> Add the cells of a result; differences are against `reference`.
   pure subroutine add_row(table, units, model, result, reference, is_reference)
      type(text_table_type), intent(inout) :: table
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result, reference
      logical, intent(in) :: is_reference
      type(optional_real) :: hookload, pull, pull_share, torque, turn, turn_share
      character(:), allocatable :: name, force, moment
      force = '|'//trim(units%force_label)
      moment = '|'//unit_label(units, unit_moment)
      name = ''
      if (is_reference) name = model%cases(result%case_index)%name
      hookload = optional_real(has_numbers(result%status), result%hookload)
      torque = optional_real(has_numbers(result%status), result%torque)
      if (.not. is_reference .and. has_numbers(result%status) .and. has_numbers(reference%status)) then
         pull = given(result%hookload - reference%hookload)
         turn = given(result%torque - reference%torque)
         if (abs(reference%hookload) > 0.0_wp .and. abs(pull%value) <= abs(reference%hookload)) &
            pull_share = given(100.0_wp*pull%value/abs(reference%hookload))
         if (abs(reference%torque) > max(abs(turn%value), least_torque)) &
            turn_share = given(100.0_wp*turn%value/abs(reference%torque))
      end if
      call add_cell(table, 'Case', name_width, name)
      call add_cell(table, 'Model', model_width, model_name(result%model))
      call add_cell(table, 'Hook load'//force, number_width, hookload, units%force, 3)
      call add_cell(table, 'Difference'//force, number_width, pull, units%force, 3)
      call add_cell(table, '|%', share_width, pull_share, one, 3)
      call add_cell(table, 'Torque'//moment, number_width, torque, units%moment, 3)
      call add_cell(table, 'Difference'//moment, number_width, turn, units%moment, 3)
      call add_cell(table, '|%', share_width, turn_share, one, 3)
      call add_cell(table, 'Seconds', seconds_width, result%seconds, one, 4)
   end subroutine add_row
end module dg_model_table

!> The models of a run side by side: hook load and torque of each, what parts them from the first model of the deck,
!> and what each cost. Every line fits 120 columns.
module dg_model_table
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers
   use dg_job, only: job_type, model_name
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_number_text, only: fixed_cell, left_aligned, right_aligned
   use dg_text, only: append_text, text_type
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
   !> A larger difference than the number itself has no share in per cent.
   !> Torque under which a difference in per cent says nothing [N.m].
   real(wp), parameter :: least_torque = 1.0_wp

contains

   !> The lines of the comparison, cases in the deck's order, in each the models in the deck's order. No line where
   !> there is one model.
   pure function model_table(job, model, results, marked) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: marked(:)         !< as many: cannot be done, or no solution
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: rule, mark
      integer :: i, j, first, row
      allocate (lines(0))
      if (size(job%models) < 2) return
      rule = repeat('-', name_width + model_width + 4*number_width + 2*share_width + seconds_width)
      call append_text(lines, '')
      call append_text(lines, 'Models side by side; differences against '//trim(model_name(job%models(1))))
      call append_text(lines, rule)
      call append_head(lines, job%units)
      call append_text(lines, rule)
      do j = 1, size(model%cases)
         first = row_of(results, job%models(1), j)
         do i = 1, size(job%models)
            row = row_of(results, job%models(i), j)
            if (row == 0 .or. first == 0) cycle
            mark = trim(merge(' '//row_mark, '  ', marked(row)))
            call append_text(lines, trim(table_row(job%units, model, results(row), results(first), i == 1))//mark)
         end do
      end do
      call append_text(lines, rule)
      do i = 1, size(job%models)
         call append_text(lines, left_aligned('all', name_width)//left_aligned(trim(model_name(job%models(i))), model_width)// &
                          repeat(' ', 4*number_width + 2*share_width)// &
                          fixed_cell(sum(results%seconds, results%model == job%models(i)), seconds_width, 4))
      end do
      if (any(marked)) call append_text(lines, mark_meaning)
   end function model_table

   pure subroutine append_head(lines, units)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: moment
      moment = unit_label(units, unit_moment)
      call append_text(lines, left_aligned('Case', name_width)//left_aligned('Model', model_width)// &
                       right_aligned('Hook load', number_width)//right_aligned('Difference', number_width)// &
                       right_aligned('', share_width)//right_aligned('Torque', number_width)// &
                       right_aligned('Difference', number_width)//right_aligned('', share_width)// &
                       right_aligned('Seconds', seconds_width))
      call append_text(lines, repeat(' ', name_width + model_width)// &
                       right_aligned(trim(units%force_label), number_width)// &
                       right_aligned(trim(units%force_label), number_width)//right_aligned('%', share_width)// &
                       right_aligned(moment, number_width)//right_aligned(moment, number_width)//right_aligned('%', share_width))
   end subroutine append_head

   pure function table_row(units, model, result, reference, is_reference) result(row)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result, reference
      logical, intent(in) :: is_reference
      character(:), allocatable :: row
      type(optional_real) :: pull, turn, pull_share, turn_share
      character(name_width) :: name
      name = ''
      if (is_reference) name = left_aligned(model%cases(result%case_index)%name, name_width)
      if (.not. is_reference .and. has_numbers(result%status) .and. has_numbers(reference%status)) then
         pull = given(result%hookload - reference%hookload)
         turn = given(result%torque - reference%torque)
         if (abs(reference%hookload) > 0.0_wp .and. abs(pull%value) <= abs(reference%hookload)) &
            pull_share = given(100.0_wp*pull%value/abs(reference%hookload))
         if (abs(reference%torque) > max(abs(turn%value), least_torque)) &
            turn_share = given(100.0_wp*turn%value/abs(reference%torque))
      end if
      row = name//left_aligned(trim(model_name(result%model)), model_width)// &
         fixed_cell(optional_real(has_numbers(result%status), result%hookload), units%force, number_width, 3)// &
         fixed_cell(pull, units%force, number_width, 3)//fixed_cell(pull_share, one, share_width, 3)// &
         fixed_cell(optional_real(has_numbers(result%status), result%torque), units%moment, number_width, 3)// &
         fixed_cell(turn, units%moment, number_width, 3)//fixed_cell(turn_share, one, share_width, 3)// &
         fixed_cell(result%seconds, seconds_width, 4)
   end function table_row

   !> Row of a model and case among the results, 0 where there is none.
   pure function row_of(results, number, case_index) result(row)
      type(case_result_type), intent(in) :: results(:)
      integer, intent(in) :: number, case_index
      integer :: row
      do row = 1, size(results)
         if (results(row)%model == number .and. results(row)%case_index == case_index) return
      end do
      row = 0
   end function row_of
end module dg_model_table

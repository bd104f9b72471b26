!> Two tables of every model on standard output: the paper's Table 1, and the cost of each case. Every line fits 120 columns.
module dg_result_table
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers, result_converged, result_status_name, scale_count, scale_name
   use dg_findings, only: findings_type, rows_of
   use dg_job, only: model_meaning, model_name
   use dg_load_case, only: load_case_type
   use dg_number_text, only: scientific_cell
   use dg_table_1, only: append_table_1
   use dg_text_table, only: add_cell, append_table, close_rows, end_row, text_table_type
   use dg_text, only: append_text, either, text_type, to_text
   use dg_unit_kind, only: in_units, unit_label, unit_length, unit_moment
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: cost_table, result_table

   !> Widths of the columns of the second table.
   integer, parameter :: name_width = 24
   integer, parameter :: status_width = 14
   integer, parameter :: count_width = 8
   integer, parameter :: iterations_width = 11
   integer, parameter :: seconds_width = 9
   integer, parameter :: residual_width = 10
   real(wp), parameter :: one = 1.0_wp

contains

   !> The lines of Table 1.
   function result_table(found) result(lines)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: lines(:)
      integer, allocatable :: rows(:)
      integer :: i
      allocate (lines(0))
      do i = 1, size(found%job%models)
         rows = rows_of(found, found%job%models(i))
         if (size(rows) == 0) cycle
         call append_text(lines, '')
         call append_text(lines, 'Model '//trim(model_name(found%job%models(i)))//' ('// &
                          trim(model_meaning(found%job%models(i)))//')')
         call append_table_1(lines, found%job%units, found%model%cases(found%results(rows)%case_index), found%results(rows), &
                             found%wholes(rows)%verdict)
      end do
   end function result_table

   !> The lines of the table of costs.
   pure function cost_table(found) result(lines)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: lines(:)
      integer, allocatable :: rows(:)
      integer :: i
      allocate (lines(0))
      do i = 1, size(found%job%models)
         rows = rows_of(found, found%job%models(i))
         if (size(rows) == 0) cycle
         call append_text(lines, '')
         call append_text(lines, 'How it was solved, model '//trim(model_name(found%job%models(i)))//': elements, contacts by '// &
                          'state, changes of state and place')
         call append_costs(lines, found%job%units, found%model%cases(found%results(rows)%case_index), found%results(rows))
      end do
   end function cost_table

   !> Append the cost of each case and the final states of its gaps; '-' where a model has no gaps or does not iterate.
   pure subroutine append_costs(lines, units, cases, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      type(text_table_type) :: table
      character(:), allocatable :: balance
      logical :: gaps, iterates
      integer :: i
      do i = 1, size(results)
         iterates = results(i)%iterations > 0
         call add_sums(table, cases(i)%name, result_status_name(results(i)%status), results(i:i), iterates)
         gaps = any(results(i)%states > 0)
         call add_cell(table, 'Free', count_width, results(i)%states(0), gaps)
         call add_cell(table, 'Elastic', count_width, results(i)%states(1), gaps)
         call add_cell(table, 'Rigid', count_width, results(i)%states(2), gaps)
         call add_cell(table, 'Flips', count_width, results(i)%flips, iterates)
         call add_cell(table, 'Moves', count_width, results(i)%moves, iterates)
         call end_row(table, '')
      end do
      call close_rows(table)
      iterates = any(results%iterations > 0)
      call add_sums(table, 'all', to_text(count(results%status == result_converged))//' of '//to_text(size(results)), &
                    results, iterates)
      balance = ''
      if (iterates .and. any(has_numbers(results%status))) balance = '   out of balance '// &
         trim(adjustl(scientific_cell(maxval(results%equilibrium_force)/units%force, residual_width)))//' '// &
         trim(units%force_label)//', '// &
         trim(adjustl(scientific_cell(maxval(results%equilibrium_moment)/units%moment, residual_width)))//' '// &
         unit_label(units, unit_moment)
      call end_row(table, balance)
      call append_table(lines, table)
      if (any(results%element_lengths(2) > 0.0_wp)) call append_text(lines, mesh_line(results, units))
   end subroutine append_costs

   !> Add the cells that have a sum, of one result or of several.
   pure subroutine add_sums(table, name, status, results, iterates)
      type(text_table_type), intent(inout) :: table
      character(*), intent(in) :: name, status
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: iterates
      call add_cell(table, 'Case', name_width, name)
      call add_cell(table, 'Status', status_width, status)
      call add_cell(table, 'Elements', count_width, sum(results%elements))
      call add_cell(table, 'Iterations', iterations_width, sum(results%iterations), iterates)
      call add_cell(table, 'Seconds', seconds_width, sum(results%seconds), one, 3)
   end subroutine add_sums

   !> Summary of the meshes, and of local scales that required shorter elements than the deck, in all cases together.
   pure function mesh_line(results, units) result(line)
      type(case_result_type), intent(in) :: results(:)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: line
      integer :: i, number
      real(wp) :: least
      least = minval(results%element_lengths(1), mask=results%element_lengths(2) > 0.0_wp)
      line = 'elements of '//to_text(least/units%length, 3)//' to '// &
         in_units(units, unit_length, maxval(results%element_lengths(2)), 3)
      number = 0
      do i = 1, scale_count
         if (sum(results%shortened(i)) == 0) cycle
         line = line//either('; number shortened:', ',', number == 0)//' '// &
            trim(scale_name(i))//' '//to_text(sum(results%shortened(i)))
         number = number + 1
      end do
      number = count(results%joints_apart)
      if (number > 0) line = line//'; tool joints one by one in '//to_text(number)//either(' case', ' cases', number == 1)// &
                             ', as compressed pipe bows out between them'
   end function mesh_line
end module dg_result_table

!> A study on standard output: worst errors and cost of each way of solving. Every line fits 120 columns.
module dg_study_table
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged
   use dg_job, only: job_type, model_mcge, model_name
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: given, is_missing, missing, optional_real
   use dg_model, only: model_type
   use dg_number_text, only: fixed_cell, scientific_cell, fixed_text
   use dg_numerics, only: fidelity_name, gap_location_name, solver_name
   use dg_study_comparison, only: error_bending, error_count, error_hookload, error_normal_force, error_torque, &
                                  pareto_set, study_record_type
   use dg_study_plan, only: study_plan_type
   use dg_study_variant, only: is_finer, same_but_mesh, same_settings, variant_type, wall_of
   use dg_text, only: append_text, either, text_type, to_text
   use dg_text_table, only: add_cell, add_right, append_table, end_row, text_table_type
   use dg_unit_kind, only: in_units, unit_label, unit_length, unit_wall
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: study_table

   integer, parameter :: model_width = 7, mesh_width = 10, gap_width = 10, solver_width = 7
   integer, parameter :: cell = 9
   integer, parameter :: narrow = 7, wide = 8
   real(wp), parameter :: one = 1.0_wp, per_cent = 100.0_wp, megabyte = 1024.0_wp**2
   !> Below this a per cent is shown with an exponent.
   real(wp), parameter :: least_fixed = 1.0e-3_wp
   !> Digits of numbers in words.
   integer, parameter :: digits = 3
   character(*), parameter :: absent = '-'

   !> All cases of a variant together.
   type :: total_type
      integer :: lost = 0                    !< cases without solution
      real(wp) :: errors(error_count) = missing !< worst of all cases [-]
      real(wp) :: seconds = 0.0_wp
      real(wp) :: memory = missing           !< greatest [bytes]
      integer :: iterations = 0
      integer :: elements = 0                !< of all cases
   end type total_type

contains

   !> The lines of a study; records(variants, cases).
   pure function study_table(job, model, plan, variants, records) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(study_plan_type), intent(in) :: plan
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(in) :: records(:, :)
      type(text_type), allocatable :: lines(:)
      type(total_type) :: totals(size(variants))
      real(wp) :: worst(size(variants)), seconds(size(variants))
      logical :: worth(size(variants))
      type(text_table_type) :: table
      integer :: i, finest
      finest = 1
      do i = 1, size(variants)
         totals(i) = total_of(records(i, :))
         seconds(i) = totals(i)%seconds
         worst(i) = missing
         if (totals(i)%lost == 0) worst(i) = maxval(totals(i)%errors([error_hookload, error_torque]))
         if (is_finer(variants(i), variants(finest))) finest = i
      end do
      worth = pareto_set(worst, seconds)
      allocate (lines(0))
      call append_text(lines, '')
      call append_text(lines, 'Study of '//to_text(size(records, 2))//' cases; errors: worst of all cases against the finest '// &
                       'variant in %, iterations and seconds: all cases')
      do i = 1, size(variants)
         call add_row(table, job%units, variants(i), totals(i), totals(finest))
         call end_row(table, ' '//either('*', '', worth(i))//either('=', '', i == finest)// &
                      either('!', '', totals(i)%lost > 0))
      end do
      call append_table(lines, table)
      call append_text(lines, '* nothing here is both more accurate (hook load, torque) and faster: Pareto set   = the finest')
      call append_lost(lines, model, job, plan, variants, records)
      call append_fidelities(lines, job%units, variants, totals, finest)
      call append_orders(lines, variants, records)
   end function study_table

   !> All cases of one variant.
   pure function total_of(records) result(total)
      type(study_record_type), intent(in) :: records(:)
      type(total_type) :: total
      integer :: k
      total%lost = count(records%status /= result_converged)
      do k = 1, error_count
         total%errors(k) = maxval(records%errors(k))
      end do
      total%seconds = sum(records%seconds)
      total%memory = maxval(records%memory)
      total%iterations = sum(records%iterations)
      total%elements = sum(records%elements)
   end function total_of

   !> Add the cells of a variant.
   pure subroutine add_row(table, units, variant, total, finest)
      type(text_table_type), intent(inout) :: table
      type(unit_system_type), intent(in) :: units
      type(variant_type), intent(in) :: variant
      type(total_type), intent(in) :: total, finest
      type(optional_real) :: cost
      character(:), allocatable :: gaps, solver
      real(wp) :: tolerance, wall
      tolerance = missing
      wall = missing
      gaps = absent
      solver = absent
      if (variant%model == model_mcge) then
         tolerance = variant%numerics%tolerance
         wall = wall_of(variant)/units%wall_stiffness
         gaps = gap_location_name(variant%numerics%gap_location)
         solver = solver_name(variant%numerics%linear_solver)
      end if
      if (finest%seconds > 0.0_wp) cost = given(total%seconds/finest%seconds)
      call add_cell(table, 'Model', model_width, model_name(variant%model))
      call add_cell(table, 'Mesh', mesh_width, mesh_of(units, variant))
      call add_right(table, 'Toler.', wide, scientific_cell(tolerance, wide))
      call add_right(table, unit_label(units, unit_wall), wide, scientific_cell(wall, wide))
      call add_cell(table, 'Gaps', gap_width, gaps)
      call add_cell(table, 'Solver', solver_width, solver)
      call add_right(table, 'Hook load', cell, error_cell(total%errors(error_hookload)))
      call add_right(table, 'Torque', cell, error_cell(total%errors(error_torque)))
      call add_right(table, 'Contact', cell, error_cell(total%errors(error_normal_force)))
      call add_right(table, 'Moment', cell, error_cell(total%errors(error_bending)))
      call add_cell(table, 'Iterat.', wide, total%iterations)
      call add_cell(table, 'Seconds', wide, total%seconds, one, 4)
      call add_cell(table, 'Cost', narrow, cost, one, 4)
      call add_cell(table, 'MB', narrow, total%memory, megabyte, 2)
   end subroutine add_row

   !> Choice of the elements of a variant: a fidelity or a length.
   pure function mesh_of(units, variant) result(text)
      type(unit_system_type), intent(in) :: units
      type(variant_type), intent(in) :: variant
      character(:), allocatable :: text
      if (variant%fidelity > 0) then
         text = trim(fidelity_name(variant%fidelity))
      else
         text = in_units(units, unit_length, variant%numerics%element_length, digits)
      end if
   end function mesh_of

   !> A share as per cent.
   pure function error_cell(share) result(text)
      real(wp), intent(in) :: share
      character(cell) :: text
      if (is_missing(share)) then
         text = fixed_cell(share, cell, 4)
      else if (per_cent*share >= least_fixed .or. .not. share > 0.0_wp) then
         text = fixed_cell(per_cent*share, cell, 4)
      else
         text = scientific_cell(per_cent*share, cell)
      end if
   end function error_cell

   !> Append the variants without a solution.
   pure subroutine append_lost(lines, model, job, plan, variants, records)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(model_type), intent(in) :: model
      type(job_type), intent(in) :: job
      type(study_plan_type), intent(in) :: plan
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(in) :: records(:, :)
      integer :: i, j
      do i = 1, size(variants)
         do j = 1, size(records, 2)
            if (records(i, j)%status == result_converged) cycle
            call append_text(lines, '! no solution: '//model%cases(plan%cases(j))%name//', '// &
                             trim(model_name(variants(i)%model))//', '//mesh_of(job%units, variants(i))// &
                             '; left out of the errors above')
         end do
      end do
   end subroutine append_lost

   !> Append the errors of each fidelity against the finest, and its cost.
   pure subroutine append_fidelities(lines, units, variants, totals, finest)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(variant_type), intent(in) :: variants(:)
      type(total_type), intent(in) :: totals(:)
      integer, intent(in) :: finest
      character(:), allocatable :: words
      integer :: i
      do i = 1, size(variants)
         if (variants(i)%fidelity == 0 .or. i == finest .or. totals(i)%lost > 0 .or. totals(finest)%lost > 0) cycle
         ! with all of a fidelity's tolerances, walls ... in the table, those of the finest say enough in words
         if (count(variants%fidelity == variants(i)%fidelity) > 1 .and. .not. same_settings(variants(i), variants(finest))) cycle
         words = 'Fidelity '//trim(fidelity_name(variants(i)%fidelity))//': hook load within '// &
            to_text(per_cent*totals(i)%errors(error_hookload), digits)//' %'
         if (.not. is_missing(totals(i)%errors(error_torque))) &
            words = words//', torque within '//to_text(per_cent*totals(i)%errors(error_torque), digits)//' %'
         words = words//' of '//mesh_of(units, variants(finest))
         if (totals(finest)%seconds > 0.0_wp .and. totals(i)%seconds > 0.0_wp) words = words//', '// &
            to_text(totals(finest)%seconds/totals(i)%seconds, digits)//' times as fast'
         call append_text(lines, words)
      end do
   end subroutine append_fidelities

   !> Observed orders of convergence, one line a family of variants that differ in element length alone.
   pure subroutine append_orders(lines, variants, records)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(in) :: records(:, :)
      type(text_table_type) :: table
      character(:), allocatable :: gaps, solver
      logical :: first, headed
      integer :: i, j
      headed = .false.
      do i = 1, size(variants)
         first = variants(i)%fidelity == 0
         do j = 1, i - 1
            if (same_but_mesh(variants(i), variants(j))) first = .false.
         end do
         if (.not. first .or. all([(is_missing(records(i, j)%orders), j=1, size(records, 2))])) cycle
         gaps = ''
         solver = ''
         if (variants(i)%model == model_mcge) then
            gaps = gap_location_name(variants(i)%numerics%gap_location)
            solver = solver_name(variants(i)%numerics%linear_solver)
         end if
         call add_cell(table, 'Model', model_width, model_name(variants(i)%model))
         call add_cell(table, 'Gaps', gap_width, gaps)
         call add_cell(table, 'Solver', solver_width, solver)
         call add_right(table, 'Hook load', 2*cell, range_text(records(i, :)%orders(error_hookload)))
         call add_right(table, 'Torque', 2*cell, range_text(records(i, :)%orders(error_torque)))
         call add_right(table, 'Contact', 2*cell, range_text(records(i, :)%orders(error_normal_force)))
         call add_right(table, 'Moment', 2*cell, range_text(records(i, :)%orders(error_bending)))
         call end_row(table, '')
         headed = .true.
      end do
      if (.not. headed) return
      call append_text(lines, '')
      call append_text(lines, 'Order of convergence with element length: median of the cases (least to greatest)')
      call append_table(lines, table)
   end subroutine append_orders

   !> Median, least and greatest of the numbers that are not missing; '-' where there are none.
   pure function range_text(numbers) result(text)
      real(wp), intent(in) :: numbers(:)
      character(:), allocatable :: text
      real(wp), allocatable :: sorted(:)
      integer :: n
      sorted = pack(numbers, .not. is_missing(numbers))
      sorted = sorted(sorted_places(sorted))
      n = size(sorted)
      text = absent
      if (n == 0) return
      text = fixed_text(0.5_wp*(sorted((n + 1)/2) + sorted(n/2 + 1)), 1)
      if (n > 1) text = text//' ('//fixed_text(sorted(1), 1)//' to '//fixed_text(sorted(n), 1)//')'
   end function range_text
end module dg_study_table

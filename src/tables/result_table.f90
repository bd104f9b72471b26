!> The tables on standard output: the paper's Table 1, what the run cost, and what was found on the way.
!> Every line fits 120 columns.
module dg_result_table
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged, result_status_name, scale_count, scale_name, way_count, way_name, &
                             way_not_asked, way_planar
   use dg_comparison, only: as_measured, known, percent_error
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, moves_axially, operation_label, optional_real, rotates
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_number_text, only: count_cell, fixed_cell, left_aligned, right_aligned, scientific_cell
   use dg_text, only: append_text, text_type, to_text
   use dg_unit_kind, only: unit_label, unit_moment
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: result_table

   integer, parameter :: page_width = 120

   !> Widths of the columns of Table 1; together with the mark they fill the page.
   integer, parameter :: section_width = 27
   integer, parameter :: operation_width = 17
   integer, parameter :: wob_width = 8
   integer, parameter :: calculated_width = 11
   integer, parameter :: measured_width = 10
   integer, parameter :: error_width = 9
   integer, parameter :: friction_width = 11
   integer, parameter :: moment_width = 8
   integer, parameter :: indicator_width = 10
   integer, parameter :: reference_width = 10
   integer, parameter :: reference_error_width = 7

   !> Which columns Table 1 has beside those of the paper.
   type :: layout_type
      logical :: reference = .false.
      logical :: indicator = .false.           !< what the rig shows
      integer :: section = section_width       !< narrower where both are there
   end type layout_type

   !> Widths of the columns of the second table.
   integer, parameter :: name_width = 24
   integer, parameter :: status_width = 14
   integer, parameter :: count_width = 8
   integer, parameter :: iterations_width = 11
   integer, parameter :: seconds_width = 9
   integer, parameter :: residual_width = 10

   !> Behind a row of Table 1 whose numbers are no solution.
   character(*), parameter :: no_solution_mark = ' !'

contains

   !> The lines of the tables.
   pure function result_table(job, model, results) result(lines)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(text_type), allocatable :: lines(:)
      integer, allocatable :: rows(:)
      integer :: i, k
      allocate (lines(0))
      if (allocated(job%title)) then
         if (job%title /= '') call append_text(lines, job%title)
      end if
      do i = 1, size(job%models)
         rows = pack([(k, k=1, size(results))], results%model == job%models(i))
         if (size(rows) == 0) cycle
         call append_text(lines, '')
         call append_text(lines, 'Model '//trim(model_name(job%models(i))))
         call append_table_1(lines, job%units, model%cases(results(rows)%case_index), results(rows))
         call append_text(lines, '')
         call append_costs(lines, job%units, model%cases(results(rows)%case_index), results(rows))
         call append_messages(lines, model%cases(results(rows)%case_index), results(rows))
      end do
   end function result_table

   !> Table 1 of the paper; with reference hook loads where any case has one, with what the rig shows where one is given.
   pure subroutine append_table_1(lines, units, cases, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      type(text_type), allocatable :: label(:)
      type(layout_type) :: layout
      integer :: first, last, row
      layout%reference = any(cases%reference_hookload%present)
      layout%indicator = any(.not. is_missing(results%weight_indicator))
      if (layout%reference .and. layout%indicator) layout%section = section_width - indicator_width
      call append_table_1_head(lines, units, layout)
      first = 1
      do while (first <= size(cases))
         last = end_of_section(cases, first)
         label = section_label(units, cases(first), results(first), layout%section)
         do row = first, max(last, first + size(label) - 1)
            if (row <= last) then
               call append_text(lines, label_cell(label, row - first + 1, layout%section)// &
                                trim(table_1_row(units, cases(row), results(row), layout)))
            else
               call append_text(lines, trim(label_cell(label, row - first + 1, layout%section)))
            end if
         end do
         first = last + 1
      end do
      call append_text(lines, repeat('-', table_1_width(layout)))
      call append_error(lines, trim(merge('Weight indicator', 'Hook load       ', layout%indicator))//' against measurement', &
                        cases, results, &
                        percent_error(as_measured(results%hookload, results%weight_indicator), cases%measured_hookload))
      call append_error(lines, 'Hook load against reference', cases, results, &
                        percent_error(results%hookload, cases%reference_hookload))
      call append_error(lines, 'Force moment against measurement', cases, results, &
                        percent_error(results%torque, cases%measured_torque))
   end subroutine append_table_1

   pure subroutine append_table_1_head(lines, units, layout)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(in) :: layout
      character(:), allocatable :: first, second, third
      first = left_aligned(trim(merge('Section and well depth', 'Section, depth        ', layout%section == section_width)), &
                           layout%section)//left_aligned('Load case', operation_width)// &
         right_aligned('Drilling', wob_width)//right_aligned('Calculated', calculated_width)// &
         right_aligned('Measured', measured_width)//right_aligned('Relative', error_width)// &
         right_aligned('Frictional', friction_width)//right_aligned('Force', moment_width)
      second = repeat(' ', layout%section + operation_width)// &
         right_aligned('weight', wob_width)//right_aligned('hook load', calculated_width)// &
         right_aligned('hook load', measured_width)//right_aligned('error', error_width)// &
         right_aligned('resistance', friction_width)//right_aligned('moment', moment_width)
      third = repeat(' ', layout%section + operation_width)// &
         right_aligned(trim(units%force_label), wob_width)//right_aligned(trim(units%force_label), calculated_width)// &
         right_aligned(trim(units%force_label), measured_width)//right_aligned('%', error_width)// &
         right_aligned(trim(units%force_label), friction_width)//right_aligned(unit_label(units, unit_moment), moment_width)
      if (layout%indicator) then
         first = first//right_aligned('Weight', indicator_width)
         second = second//right_aligned('indicator', indicator_width)
         third = third//right_aligned(trim(units%force_label), indicator_width)
      end if
      if (layout%reference) then
         first = first//right_aligned('Reference', reference_width)//right_aligned('Ref.', reference_error_width)
         second = second//right_aligned('hook load', reference_width)//right_aligned('error', reference_error_width)
         third = third//right_aligned(trim(units%force_label), reference_width)//right_aligned('%', reference_error_width)
      end if
      call append_text(lines, repeat('-', table_1_width(layout)))
      call append_text(lines, trim(first))
      call append_text(lines, trim(second))
      call append_text(lines, trim(third))
      call append_text(lines, repeat('-', table_1_width(layout)))
   end subroutine append_table_1_head

   pure function table_1_width(layout) result(width)
      type(layout_type), intent(in) :: layout
      integer :: width
      width = layout%section + operation_width + wob_width + calculated_width + measured_width + error_width + &
         friction_width + moment_width
      if (layout%indicator) width = width + indicator_width
      if (layout%reference) width = width + reference_width + reference_error_width
   end function table_1_width

   !> One row without its section label. As in the paper, friction belongs to axial motion and the force
   !> moment to rotation.
   pure function table_1_row(units, load_case, result, layout) result(row)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      type(layout_type), intent(in) :: layout
      character(:), allocatable :: row
      row = left_aligned(trim(operation_label(load_case%operation)), operation_width)// &
         fixed_cell(load_case%wob/units%force, wob_width, 1)// &
         fixed_cell(result%hookload/units%force, calculated_width, 1)// &
         fixed_cell(load_case%measured_hookload, units%force, measured_width, 1)// &
         fixed_cell(percent_error(as_measured(result%hookload, result%weight_indicator), load_case%measured_hookload), 1.0_wp, &
                    error_width, 2)// &
         fixed_cell(optional_real(moves_axially(load_case%operation), result%friction), units%force, friction_width, 2)// &
         fixed_cell(optional_real(rotates(load_case%operation), result%torque), units%moment, moment_width, 2)
      if (layout%indicator) row = row//fixed_cell(known(result%weight_indicator), units%force, indicator_width, 1)
      if (layout%reference) row = row// &
         fixed_cell(load_case%reference_hookload, units%force, reference_width, 1)// &
         fixed_cell(percent_error(result%hookload, load_case%reference_hookload), 1.0_wp, reference_error_width, 2)
      if (result%status /= result_converged) row = row//no_solution_mark
   end function table_1_row

   !> Index of the last of the cases that follow `first` with the same section label and bit depth.
   pure function end_of_section(cases, first) result(last)
      type(load_case_type), intent(in) :: cases(:)
      integer, intent(in) :: first
      integer :: last
      !> Depths closer than this count as one [m]: decks give them in whole centimetres at best.
      real(wp), parameter :: same_depth = 0.005_wp
      last = first
      do while (last < size(cases))
         if (section_of(cases(last + 1)) /= section_of(cases(first))) return
         if (abs(cases(last + 1)%bit_depth - cases(first)%bit_depth) > same_depth) return
         last = last + 1
      end do
   end function end_of_section

   pure function section_of(load_case) result(section)
      type(load_case_type), intent(in) :: load_case
      character(:), allocatable :: section
      section = ''
      if (allocated(load_case%section)) section = load_case%section
   end function section_of

   !> Section, depth and inclination, as lines that fit their column.
   pure function section_label(units, load_case, result, width) result(label)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      integer, intent(in) :: width
      type(text_type), allocatable :: label(:)
      real(wp), parameter :: tenth = 10.0_wp !< depths and angles are shown to one digit behind the point
      allocate (label(0))
      if (section_of(load_case) /= '') call append_wrapped(label, '', section_of(load_case), width - 1)
      call append_wrapped(label, '', to_text(anint(tenth*load_case%bit_depth/units%length)/tenth)//' '// &
                          trim(units%length_label)//', '// &
                          to_text(anint(tenth*result%inclination/units%angle)/tenth)//' deg', width - 1)
   end function section_label

   pure function label_cell(label, i, width) result(cell)
      type(text_type), intent(in) :: label(:)
      integer, intent(in) :: i
      integer, intent(in) :: width
      character(width) :: cell
      cell = ''
      if (i <= size(label)) cell = label(i)%text
   end function label_cell

   !> Mean and worst of the errors that are there, over the cases that were solved; nothing where no case
   !> has anything to compare with.
   pure subroutine append_error(lines, what, cases, results, errors)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: what
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      type(optional_real), intent(in) :: errors(:) !< [%]
      logical :: counted(size(errors))
      real(wp) :: mean
      integer :: n, worst
      character(:), allocatable :: line
      if (.not. any(errors%present)) return
      counted = errors%present .and. results%status == result_converged
      n = count(counted)
      line = what//': '
      if (n > 0) then
         mean = sum(errors%value, mask=counted)/real(n, wp)
         worst = maxloc(errors%value, mask=counted, dim=1)
         line = line//'mean error '//trim(adjustl(fixed_cell(mean, 12, 2)))//' %, worst '// &
            trim(adjustl(fixed_cell(errors(worst)%value, 12, 2)))//' % ('//cases(worst)%name//'), '//to_text(n)
         if (n == 1) line = line//' case'
         if (n /= 1) line = line//' cases'
      else
         line = line//'no case solved'
      end if
      if (count(errors%present) > n) line = line//', '//to_text(count(errors%present) - n)//' not solved left out'
      call append_wrapped(lines, '', line, page_width)
   end subroutine append_error

   !> What each case cost and where its gaps ended; '-' where a model has no gaps or does not iterate.
   pure subroutine append_costs(lines, units, cases, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      character(:), allocatable :: rule
      character(:), allocatable :: line
      logical :: gaps, iterates
      integer :: i
      rule = repeat('-', name_width + status_width + 6*count_width + iterations_width + seconds_width)
      call append_text(lines, rule)
      call append_text(lines, left_aligned('Case', name_width)//left_aligned('Status', status_width)// &
                       right_aligned('Elements', count_width)//right_aligned('Iterations', iterations_width)// &
                       right_aligned('Seconds', seconds_width)//right_aligned('Free', count_width)// &
                       right_aligned('Elastic', count_width)//right_aligned('Rigid', count_width)// &
                       right_aligned('Flips', count_width)//right_aligned('Moves', count_width))
      call append_text(lines, rule)
      do i = 1, size(results)
         gaps = any(results(i)%states > 0)
         iterates = results(i)%iterations > 0
         call append_text(lines, left_aligned(cases(i)%name, name_width)// &
                          left_aligned(trim(result_status_name(results(i)%status)), status_width)// &
                          count_cell(results(i)%elements, count_width)// &
                          count_cell(results(i)%iterations, iterations_width, iterates)// &
                          fixed_cell(results(i)%seconds, seconds_width, 3)// &
                          count_cell(results(i)%states(0), count_width, gaps)// &
                          count_cell(results(i)%states(1), count_width, gaps)// &
                          count_cell(results(i)%states(2), count_width, gaps)// &
                          count_cell(results(i)%flips, count_width, iterates)// &
                          count_cell(results(i)%moves, count_width, iterates))
      end do
      call append_text(lines, rule)
      iterates = any(results%iterations > 0)
      line = left_aligned('all', name_width)// &
         left_aligned(to_text(count(results%status == result_converged))//' of '//to_text(size(results)), status_width)// &
         count_cell(sum(results%elements), count_width)// &
         count_cell(sum(results%iterations), iterations_width, iterates)// &
         fixed_cell(sum(results%seconds), seconds_width, 3)
      if (iterates) line = line//'   equilibrium to '// &
         trim(adjustl(scientific_cell(maxval(results%equilibrium_force)/units%force, residual_width)))//' '// &
         trim(units%force_label)//', '// &
         trim(adjustl(scientific_cell(maxval(results%equilibrium_moment)/units%moment, residual_width)))//' '// &
         unit_label(units, unit_moment)
      call append_text(lines, line)
      if (any(results%element_lengths(2) > 0.0_wp)) call append_text(lines, mesh_line(results, units))
      if (any(results%way /= way_not_asked)) call append_text(lines, plane_line(results))
   end subroutine append_costs

   !> How many cases were solved in the plane of their hole, and why the others were not.
   pure function plane_line(results) result(line)
      type(case_result_type), intent(in) :: results(:)
      character(:), allocatable :: line
      integer :: i, number
      line = 'solved in the plane of the hole: '//to_text(count(results%way == way_planar))//' of '//to_text(size(results))
      number = 0
      do i = 1, way_count
         if (i == way_planar .or. .not. any(results%way == i)) cycle
         line = line//trim(merge('; in space:', ',          ', number == 0))//' '//trim(way_name(i))//' ('// &
            to_text(count(results%way == i))//')'
         number = number + 1
      end do
   end function plane_line

   !> What the meshes are like, and which local scales asked for shorter elements than the deck, in all cases together.
   pure function mesh_line(results, units) result(line)
      type(case_result_type), intent(in) :: results(:)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: line
      integer :: i, number
      real(wp) :: least
      least = minval(results%element_lengths(1), mask=results%element_lengths(2) > 0.0_wp)
      line = 'elements of '//trim(adjustl(fixed_cell(least/units%length, seconds_width, 1)))//' to '// &
         trim(adjustl(fixed_cell(maxval(results%element_lengths(2))/units%length, seconds_width, 1)))//' '//trim(units%length_label)
      number = 0
      do i = 1, scale_count
         if (sum(results%shortened(i)) == 0) cycle
         line = line//trim(merge('; intervals cut finer for', ',                        ', number == 0))//' '// &
            trim(scale_name(i))//' ('//to_text(sum(results%shortened(i)))//')'
         number = number + 1
      end do
   end function mesh_line

   !> What the models had to say, and what the mark in Table 1 means.
   pure subroutine append_messages(lines, cases, results)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      character(:), allocatable :: message
      integer :: i
      do i = 1, size(results)
         message = ''
         if (allocated(results(i)%message)) message = results(i)%message
         if (results(i)%status /= result_converged) then
            if (message == '') message = 'no reason given'
            message = trim(result_status_name(results(i)%status))//', numbers are no solution: '//message
            call append_wrapped(lines, '! '//cases(i)%name//': ', message, page_width)
         else if (message /= '') then
            call append_wrapped(lines, cases(i)%name//': ', message, page_width)
         end if
      end do
   end subroutine append_messages

   !> Appends a text in lines of at most `width`, broken at blanks where there are any, later lines
   !> indented by two.
   pure subroutine append_wrapped(lines, head, text, width)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: head
      character(*), intent(in) :: text
      integer, intent(in) :: width
      character(*), parameter :: indent = '  '
      character(:), allocatable :: rest
      integer :: cut
      rest = head//text
      do while (len_trim(rest) > width)
         cut = index(rest(:width + 1), ' ', back=.true.)
         if (cut <= len(indent) + 1) cut = width + 1
         call append_text(lines, trim(rest(:cut - 1)))
         rest = indent//trim(adjustl(rest(cut:)))
      end do
      call append_text(lines, trim(rest))
   end subroutine append_wrapped
end module dg_result_table

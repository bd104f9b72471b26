!> The paper's Table 1 of a run: its columns in their order, with the case's name beside the operation and the trade's words under
!> the paper's. A column that would be empty in every row is left out. Every line fits 120 columns.
module dg_table_1
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, has_numbers, result_converged
   use dg_comparison, only: as_measured, known, percent_error
   use dg_load_case, only: load_case_type, moves_axially, operation_label, optional_real, rotates
   use dg_missing, only: is_missing
   use dg_number_text, only: fixed_cell, left_aligned, right_aligned
   use dg_text, only: append_text, text_type, to_text
   use dg_unit_kind, only: unit_force, unit_label, unit_moment
   use dg_units, only: unit_system_type
   use dg_verdict_text, only: mark_meaning, row_mark
   use dg_wrapped_text, only: append_wrapped, page_width
   implicit none
   private
   public :: append_table_1

   !> Columns of numbers, in their order.
   integer, parameter :: col_wob = 1, col_calculated = 2, col_measured = 3, col_error = 4, col_friction = 5, col_moment = 6, &
                         col_indicator = 7, col_reference = 8, col_reference_error = 9, col_count = 9
   integer, parameter :: widths(col_count) = [8, 11, 10, 9, 11, 9, 10, 10, 6]
   integer, parameter :: decimals(col_count) = [1, 1, 1, 2, 2, 2, 1, 1, 2]
   integer, parameter :: head_lines = 3
   character(*), parameter :: heads(head_lines, col_count) = reshape([character(10) :: &
      'Drilling', 'weight', '(WOB)', 'Calculated', 'hook load', '', 'Measured', 'hook load', '', 'Relative', 'error', '', &
      'Frictional', 'resistance', '(drag)', 'Torque', 'at', 'surface', 'Weight', 'indicator', '', &
      'Reference', 'hook load', '', 'Ref.', 'error', ''], [head_lines, col_count])

   !> Columns of words: as wide as their longest word and a gap, but not wider than these.
   integer, parameter :: most_section = 27, most_name = 25
   integer, parameter :: gap = 1
   !> Narrower than that a column of words tells nothing.
   integer, parameter :: least_section = 15, least_name = 6

   !> Which columns there are, and how wide those of words are.
   type :: layout_type
      logical :: shown(col_count) = .false.
      integer :: section = 0, operation = 0, name = 0
      integer :: before_mark = 1
   end type layout_type

contains

   !> Table 1 of some results and their cases, and how far they are from what was measured and from the reference.
   pure subroutine append_table_1(lines, units, cases, results, marked)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: marked(:)         !< rows that cannot be done, or have no solution
      type(text_type), allocatable :: label(:)
      type(layout_type) :: layout
      type(optional_real) :: other(size(cases))
      real(wp) :: load(size(cases))
      integer :: first, last, row
      layout = layout_of(units, cases, results, any(marked))
      call append_head(lines, units, layout)
      first = 1
      do while (first <= size(cases))
         last = end_of_section(cases, first)
         label = section_label(units, cases(first), results(first), layout%section - gap)
         do row = first, max(last, first + size(label) - 1)
            if (row <= last) then
               call append_text(lines, label_cell(label, row - first + 1, layout%section)// &
                                trim(row_of(units, cases(row), results(row), layout)//mark_of(layout, marked(row))))
            else
               call append_text(lines, trim(label_cell(label, row - first + 1, layout%section)))
            end if
         end do
         first = last + 1
      end do
      call append_text(lines, repeat('-', width_of(layout)))
      if (any(marked)) call append_text(lines, mark_meaning)
      load = as_measured(results%hookload, results%weight_indicator)
      other = cases%measured_hookload
      call append_error(lines, trim(merge('Weight indicator', 'Hook load       ', layout%shown(col_indicator)))// &
                        ' against measurement', cases, results, load, other)
      load = results%hookload
      other = cases%reference_hookload
      call append_error(lines, 'Hook load against reference', cases, results, load, other)
      load = results%torque
      other = cases%measured_torque
      call append_error(lines, 'Torque against measurement', cases, results, load, other)
   end subroutine append_table_1

   !> Columns that have something to show. Where the page is too narrow names are cut, then labels of sections.
   pure function layout_of(units, cases, results, marks) result(layout)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: marks             !< some rows have a mark
      type(layout_type) :: layout
      type(text_type), allocatable :: label(:)
      integer :: i, k, over
      layout%shown(col_wob) = .true.
      layout%shown(col_calculated) = .true.
      layout%shown(col_measured:col_error) = any(cases%measured_hookload%present)
      layout%shown(col_friction) = any(moves_axially(cases%operation))
      layout%shown(col_moment) = any(rotates(cases%operation))
      layout%shown(col_indicator) = any(.not. is_missing(results%weight_indicator))
      layout%shown(col_reference:col_reference_error) = any(cases%reference_hookload%present)
      layout%section = len('Section and') + gap
      layout%operation = len('Load case') + gap
      layout%name = len('Name') + gap
      do i = 1, size(cases)
         label = section_label(units, cases(i), results(i), most_section)
         do k = 1, size(label)
            layout%section = max(layout%section, min(len(label(k)%text), most_section) + gap)
         end do
         layout%operation = max(layout%operation, len_trim(operation_label(cases(i)%operation)) + gap)
         layout%name = max(layout%name, min(len(cases(i)%name), most_name) + gap)
      end do
      over = width_of(layout) - page_width
      if (marks) then
         over = over + len(row_mark)
         if (over >= 0) layout%before_mark = 0
      end if
      if (over <= 0) return
      i = min(over, max(0, layout%section - least_section))
      layout%section = layout%section - i
      layout%name = layout%name - (over - i)
      if (layout%name < least_name) layout%name = 0
   end function layout_of

   pure function width_of(layout) result(width)
      type(layout_type), intent(in) :: layout
      integer :: width
      width = layout%section + layout%operation + layout%name + sum(widths, mask=layout%shown)
   end function width_of

   pure subroutine append_head(lines, units, layout)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(in) :: layout
      character(*), parameter :: section(head_lines) = [character(11) :: 'Section and', 'well depth', '']
      character(*), parameter :: operation(head_lines) = [character(9) :: 'Load case', '', '']
      character(*), parameter :: name(head_lines) = [character(4) :: 'Name', '', '']
      character(:), allocatable :: line
      character(8) :: unit
      integer :: i, c
      call append_text(lines, repeat('-', width_of(layout)))
      do i = 1, head_lines
         line = left_aligned(section(i), layout%section)//left_aligned(operation(i), layout%operation)// &
            left_aligned(name(i), layout%name)
         do c = 1, col_count
            if (layout%shown(c)) line = line//right_aligned(trim(heads(i, c)), widths(c))
         end do
         call append_text(lines, trim(line))
      end do
      line = repeat(' ', layout%section + layout%operation + layout%name)
      do c = 1, col_count
         if (.not. layout%shown(c)) cycle
         unit = unit_label(units, unit_force)
         if (c == col_error .or. c == col_reference_error) unit = '%'
         if (c == col_moment) unit = unit_label(units, unit_moment)
         line = line//right_aligned(trim(unit), widths(c))
      end do
      call append_text(lines, trim(line))
      call append_text(lines, repeat('-', width_of(layout)))
   end subroutine append_head

   !> One row without its section label. As in the paper, friction belongs to axial motion and torque to rotation.
   pure function row_of(units, load_case, result, layout) result(row)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      type(layout_type), intent(in) :: layout
      character(:), allocatable :: row
      type(optional_real) :: values(col_count)
      real(wp) :: unit
      integer :: c
      values(col_wob) = optional_real(.true., load_case%wob)
      values(col_calculated) = optional_real(has_numbers(result%status), result%hookload)
      values(col_measured) = load_case%measured_hookload
      values(col_error) = percent_error(as_measured(result%hookload, result%weight_indicator), load_case%measured_hookload)
      values(col_friction) = optional_real(moves_axially(load_case%operation) .and. has_numbers(result%status), result%friction)
      values(col_moment) = optional_real(rotates(load_case%operation) .and. has_numbers(result%status), result%torque)
      values(col_indicator) = known(result%weight_indicator)
      values(col_reference) = load_case%reference_hookload
      values(col_reference_error) = percent_error(result%hookload, load_case%reference_hookload)
      values(col_error)%present = values(col_error)%present .and. has_numbers(result%status)
      values(col_reference_error)%present = values(col_reference_error)%present .and. has_numbers(result%status)
      row = left_aligned(trim(operation_label(load_case%operation)), layout%operation)//left_aligned(load_case%name, layout%name)
      do c = 1, col_count
         if (.not. layout%shown(c)) cycle
         unit = units%force
         if (c == col_error .or. c == col_reference_error) unit = 1.0_wp
         if (c == col_moment) unit = units%moment
         row = row//fixed_cell(values(c), unit, widths(c), decimals(c))
      end do
   end function row_of

   !> What stands behind a row: the mark, or nothing.
   pure function mark_of(layout, marked) result(mark)
      type(layout_type), intent(in) :: layout
      logical, intent(in) :: marked
      character(:), allocatable :: mark
      mark = ''
      if (marked) mark = repeat(' ', layout%before_mark)//row_mark
   end function mark_of

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
      if (section_of(load_case) /= '') call append_wrapped(label, '', section_of(load_case), width)
      call append_wrapped(label, '', to_text(anint(tenth*load_case%bit_depth/units%length)/tenth)//' '// &
                          trim(units%length_label)//', '// &
                          to_text(anint(tenth*result%inclination/units%angle)/tenth)//' deg', width)
   end function section_label

   pure function label_cell(label, i, width) result(cell)
      type(text_type), intent(in) :: label(:)
      integer, intent(in) :: i
      integer, intent(in) :: width
      character(width) :: cell
      cell = ''
      if (i <= size(label)) cell = label(i)%text
   end function label_cell

   !> Mean and worst of the errors that are there, over the cases that were solved, and by how much the calculated values are too
   !> high or too low on average; nothing where no case has anything to compare with.
   pure subroutine append_error(lines, what, cases, results, calculated, other)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: what
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      real(wp), intent(in) :: calculated(:)
      type(optional_real), intent(in) :: other(:)      !< measured, or of another calculation
      type(optional_real) :: errors(size(other))       ! [%]
      logical :: counted(size(other))
      real(wp) :: mean, bias
      integer :: n, worst
      character(:), allocatable :: line
      errors = percent_error(calculated, other)
      if (.not. any(errors%present)) return
      counted = errors%present .and. results%status == result_converged
      n = count(counted)
      line = what//': '
      if (n > 0) then
         mean = sum(errors%value, mask=counted)/real(n, wp)
         bias = sum(sign(errors%value, calculated - other%value), mask=counted)/real(n, wp)
         worst = maxloc(errors%value, mask=counted, dim=1)
         line = line//'mean error '//trim(adjustl(fixed_cell(mean, 12, 2)))//' %, worst '// &
            trim(adjustl(fixed_cell(errors(worst)%value, 12, 2)))//' % ('//cases(worst)%name//'), '//to_text(n)
         if (n == 1) line = line//' case'
         if (n /= 1) line = line//' cases'
         line = line//', '//trim(adjustl(fixed_cell(abs(bias), 12, 2)))//' % too '//trim(merge('high', 'low ', bias > 0.0_wp))
         if (n > 1) line = line//' on average'
      else
         line = line//'no case solved'
      end if
      if (count(errors%present) > n) line = line//', '//to_text(count(errors%present) - n)//' not solved left out'
      call append_wrapped(lines, '', line, page_width)
   end subroutine append_error
end module dg_table_1

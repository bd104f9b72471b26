!> The paper's Table 1 of a run: its columns in their order. The case's name is beside the operation, and the words of the
!> trade are under the paper's. A column that would be empty in every row is left out. Every line fits 120 columns.
module dg_table_1
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_column, only: field_real, fields_of, row_type
   use dg_block_question, only: block_question
   use dg_comparison, only: as_measured, percent_error
   use dg_load_case, only: load_case_type, moves_axially, operation_label, rotates
   use dg_missing, only: is_missing, optional_real
   use dg_number_text, only: append_wrapped, page_width, fixed_text
   use dg_summary_file, only: summary_row
   use dg_text, only: append_text, either, text_or_nothing, text_type, to_text
   use dg_text_table, only: add_cell, append_table, end_row, text_table_type
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_yes, verdict_type
   use dg_verdict_text, only: mark_meaning, row_mark
   use dg_unit_kind, only: unit_factor, unit_label
   implicit none
   private
   public :: append_table_1, page_columns

   !> Rows to which a column of numbers applies: all, strings that move along or turn, cases with a measured or reference hook
   !> load, rigs.
   integer, parameter :: for_all = 0, for_moving = 1, for_turning = 2, for_measured = 3, for_reference = 4, for_rigs = 5

   !> A column of numbers: one of summary.csv, which has its values, meaning and unit.
   type :: number_type
      character(18) :: name
      character(28) :: head              !< three lines with '|' between
      integer :: width, decimals
      integer :: rows                    !< rows to which it applies
   end type number_type

   type(number_type), parameter :: numbers(*) = [ &
      number_type('wob', 'Drilling|weight|(WOB)', 8, 1, for_all), &
      number_type('hookload', 'Calculated|hook load|', 11, 1, for_all), &
      number_type('measured', 'Measured|hook load|', 10, 1, for_measured), &
      number_type('error', 'Relative|error|', 9, 2, for_measured), &
      number_type('friction', 'Frictional|resistance|(drag)', 11, 2, for_moving), &
      number_type('torque', 'Torque|at|surface', 9, 2, for_turning), &
      number_type('weight_indicator', 'Weight|indicator|(+ block)', 10, 1, for_rigs), &
      number_type('reference', 'Reference|hook load|', 10, 1, for_reference), &
      number_type('reference_error', 'Ref.|error|', 6, 2, for_reference)]

   !> Columns of summary.csv and limits.csv in the first table of the page, which has room for more. What was asked for comes first:
   !> a phone shows the first few only.
   character(*), parameter :: page_columns(*) = [character(18) :: 'case', 'hookload', 'weight_indicator', 'measured', 'error', &
      'reference', 'reference_error', 'torque', 'friction', 'normal_force', 'largest_bending', 'largest_bending_md', &
      'operation', 'bit_depth', 'wob', 'section']

   !> Columns of words: as wide as their longest word and a gap, but not wider than these.
   integer, parameter :: most_section = 27, most_name = 25
   integer, parameter :: gap = 1
   !> Narrower than that a column of words tells nothing.
   integer, parameter :: least_section = 15, least_name = 6

   !> Columns that are present, and widths of those of words.
   type :: layout_type
      logical :: shown(size(numbers)) = .false.
      integer :: section = 0, operation = 0, name = 0
      integer :: before_mark = 1
   end type layout_type

contains

   !> Append Table 1 of some results and their cases, and their errors against measured and reference values.
   subroutine append_table_1(lines, units, cases, results, verdicts)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      type(verdict_type), intent(in) :: verdicts(:)
      type(text_table_type) :: table
      type(text_type), allocatable :: label(:)
      type(layout_type) :: layout
      logical :: marked(size(cases))           ! rows that cannot be done, or have no solution
      type(optional_real) :: other(size(cases))
      real(wp) :: load(size(cases))
      character(:), allocatable :: what
      integer :: first, last, row
      marked = verdicts%answer /= answer_yes
      layout = layout_of(units, cases, results, any(marked))
      first = 1
      do while (first <= size(cases))
         last = end_of_section(cases, first)
         label = section_label(units, cases(first), results(first), layout%section - gap)
         do row = first, max(last, first + size(label) - 1)
            call add_cell(table, 'Section and|well depth', layout%section, label_line(label, row - first + 1))
            if (row <= last) call add_case(table, units, cases(row), results(row), verdicts(row), layout)
            call end_row(table, either(repeat(' ', layout%before_mark)//row_mark, '', row <= last .and. marked(min(row, last))))
         end do
         first = last + 1
      end do
      call append_table(lines, table)
      if (any(marked)) call append_text(lines, mark_meaning)
      load = as_measured(results%hookload, results%weight_indicator)
      other = cases%measured_hookload
      what = 'Hook load'
      if (any(.not. is_missing(results%weight_indicator))) what = 'Weight indicator, block included,'
      call append_error(lines, what//' against measurement', cases, results, load, other)
      call append_wrapped(lines, block_question(units, cases, results))
      load = results%hookload
      other = cases%reference_hookload
      call append_error(lines, 'Hook load against reference', cases, results, load, other)
      load = results%torque
      other = cases%measured_torque
      call append_error(lines, 'Torque against measurement', cases, results, load, other)
   end subroutine append_table_1

   !> Choose the columns with any value. If the page is too narrow names are cut, then labels of sections.
   pure function layout_of(units, cases, results, marks) result(layout)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)
      logical, intent(in) :: marks             !< some rows have a mark
      type(layout_type) :: layout
      type(text_type), allocatable :: label(:)
      integer :: i, k, over
      do i = 1, size(numbers)
         layout%shown(i) = any(says(numbers(i)%rows, cases, results))
      end do
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
      over = layout%section + layout%operation + layout%name + sum(numbers%width, mask=layout%shown) - page_width
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

   !> Add the cells of a case behind its section label.
   subroutine add_case(table, units, load_case, result, verdict, layout)
      type(text_table_type), intent(inout) :: table
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      type(verdict_type), intent(in) :: verdict
      type(layout_type), intent(in) :: layout
      type(row_type) :: values
      type(optional_real) :: value
      integer :: c
      values = fields_of(summary_row(load_case, result, verdict, units), numbers%name)
      call add_cell(table, 'Load case', layout%operation, operation_label(load_case%operation))
      call add_cell(table, 'Name', layout%name, load_case%name)
      do c = 1, size(numbers)
         if (.not. layout%shown(c)) cycle
         associate (field => values%fields(c))
            value = optional_real(field%kind == field_real .and. says(numbers(c)%rows, load_case, result), field%real_value)
            call add_cell(table, head_of(c, layout)//'|'//unit_label(units, field%column%quantity), numbers(c)%width, &
                          value, unit_factor(units, field%column%quantity), numbers(c)%decimals)
         end associate
      end do
   end subroutine add_case

   !> Head of a column. With &rig measured values are those of the indicator, and hook loads say that they have no block.
   pure function head_of(column, layout) result(head)
      integer, intent(in) :: column
      type(layout_type), intent(in) :: layout
      character(:), allocatable :: head
      head = trim(numbers(column)%head)
      if (.not. any(layout%shown .and. numbers%rows == for_rigs)) return
      select case (numbers(column)%name)
      case ('measured'); head = 'Measured|indicator|'
      case ('hookload', 'reference'); head = head//'(no block)'
      case default       ! of any run
      end select
   end function head_of

   !> True if a column applies to a case. As in the paper, friction belongs to axial motion and torque to rotation. Torque on
   !> bit also belongs to a sliding string: a motor turns its bit.
   elemental function says(rows, load_case, result) result(is)
      integer, intent(in) :: rows        !< of the column
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      logical :: is
      select case (rows)
      case (for_moving); is = moves_axially(load_case%operation)
      case (for_turning); is = rotates(load_case%operation) .or. load_case%tob > 0.0_wp
      case (for_measured); is = load_case%measured_hookload%present
      case (for_reference); is = load_case%reference_hookload%present
      case (for_rigs); is = .not. is_missing(result%weight_indicator)
      case default; is = .true.
      end select
   end function says

   !> Index of the last of the cases that follow `first` with the same section label and bit depth.
   pure function end_of_section(cases, first) result(last)
      type(load_case_type), intent(in) :: cases(:)
      integer, intent(in) :: first
      integer :: last
      !> Depths closer than this count as one [m]: decks give them in whole centimetres at best.
      real(wp), parameter :: same_depth = 0.005_wp
      last = first
      do while (last < size(cases))
         if (text_or_nothing(cases(last + 1)%section) /= text_or_nothing(cases(first)%section)) return
         if (abs(cases(last + 1)%bit_depth - cases(first)%bit_depth) > same_depth) return
         last = last + 1
      end do
   end function end_of_section

   !> Section, depth and inclination, as lines that fit their column.
   pure function section_label(units, load_case, result, width) result(label)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      integer, intent(in) :: width
      type(text_type), allocatable :: label(:)
      real(wp), parameter :: tenth = 10.0_wp !< depths and angles are shown to one digit behind the point
      allocate (label(0))
      call append_wrapped(label, text_or_nothing(load_case%section), width)
      call append_wrapped(label, to_text(anint(tenth*load_case%bit_depth/units%length)/tenth)//' '// &
                          trim(units%length_label)//', '// &
                          to_text(anint(tenth*result%inclination/units%angle)/tenth)//' deg', width)
   end function section_label

   pure function label_line(label, i) result(line)
      type(text_type), intent(in) :: label(:)
      integer, intent(in) :: i
      character(:), allocatable :: line
      line = ''
      if (i <= size(label)) line = label(i)%text
   end function label_line

   !> Append mean and worst of the known errors, over the solved cases, and the mean excess of the calculated values. Nothing
   !> is appended if no case has a value to compare with.
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
         line = line//'mean error '//fixed_text(mean, 2)//' %, worst '// &
            fixed_text(errors(worst)%value, 2)//' % ('//cases(worst)%name//'), '//to_text(n)
         if (n == 1) line = line//' case'
         if (n /= 1) line = line//' cases'
         line = line//', '//fixed_text(abs(bias), 2)//' % too '//either('high', 'low', bias > 0.0_wp)
         if (n > 1) line = line//' on average'
      else
         line = line//'no case solved'
      end if
      if (count(errors%present) > n) line = line//', '//to_text(count(errors%present) - n)//' not solved left out'
      call append_wrapped(lines, line)
   end subroutine append_error
end module dg_table_1

!> The groups &legacy of a deck: which columns of which file, laid beside which load case.
module dg_deck_legacy
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, claim_name, group_fault, integer_of, is_given, is_sound, line_of, named, &
      text_of
   use dg_deck_draft, only: draft_type, find_case
   use dg_error, only: error_at, error_list_type
   use dg_file_lines, only: beside
   use dg_legacy_file, only: column_count, column_name, column_quantity, column_type, read_legacy_file, unit_value
   use dg_legacy_comparison, only: legacy_table_type
   use dg_text, only: is_separator_free, quoted, text_type
   use dg_unit_kind, only: unit_label
   use dg_units, only: unit_system, unit_system_type
   implicit none
   private
   public :: read_legacy

   character(*), parameter :: digits = '0123456789'
   !> Most digits of a column number.
   integer, parameter :: longest_number = 6
   character(*), parameter :: legal_units(column_count) = [character(38) :: 'm, ft', 'N, daN, kN, kdaN, t, lbf, klbf, kip', &
      'N.m, kN.m, ft.lbf, kft.lbf', 'N/m, kN/m, kdaN/m, lbf/ft, klbf/ft']

contains

   !> All tables of a deck, in its order; each group's faults.
   subroutine read_legacy(draft, groups, tables, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      type(legacy_table_type), allocatable, intent(out) :: tables(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: taken(:)
      integer, allocatable :: mine(:)
      integer :: n
      allocate (taken(0))
      allocate (mine, source=named(groups, 'legacy'))
      allocate (tables(size(mine)))
      do n = 1, size(mine)
         associate (group => groups(mine(n)))
            call read_one(draft, group, tables(n), faults)
            call claim_name(group, 'label', tables(n)%label, taken, faults)
         end associate
      end do
   end subroutine read_legacy

   subroutine read_one(draft, group, table, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(legacy_table_type), intent(out) :: table
      type(error_list_type), intent(inout) :: faults
      type(column_type) :: columns(column_count)
      type(unit_system_type) :: units
      logical :: sound
      integer :: k

      sound = is_sound(group, 'file') .and. is_sound(group, 'label') .and. is_sound(group, 'case')
      table%label = text_of(group, 'label', '')
      table%skipped = ''
      table%file = beside(draft%path, text_of(group, 'file', ''))
      if (is_sound(group, 'label') .and. .not. is_separator_free(table%label)) call group_fault(group, 'label', 'label = '// &
         quoted(table%label)//' cannot be part of a file name; use 1 to 100 letters, digits and _ - . +, no dot first', faults)
      if (is_sound(group, 'case')) then
         call find_case(draft, group%name, line_of(group, 'case'), text_of(group, 'case', ''), table%case_index, faults)
         sound = sound .and. table%case_index > 0
      end if
      units = draft%units
      if (is_given(group, 'units')) units = unit_system(text_of(group, 'units', ''))
      do k = 1, column_count
         call read_column(k, trim(column_name(k)), columns(k))
      end do
      if (any(columns%last > 0)) then
         do k = 1, column_count
            if (columns(k)%last == 0 .and. columns(k)%required) call group_fault(group, trim(column_name(k)), &
               trim(column_name(k))//' = '//quoted(columns(k)%place)// &
               ' is a heading or a number, other columns are characters; give all as ''first:last''', faults)
         end do
      end if
      if (sound) call read_legacy_file(table%file, integer_of(group, 'skip', 0), columns, table%md, table%values, &
                                       table%skipped, sound, faults, &
                                       error_at(draft%path, line_of(group, 'file'), 'group &legacy: file'))
      table%has = columns(2:)%number > 0 .or. columns(2:)%last > 0

   contains

      !> Place and unit of one column.
      subroutine read_column(k, key, column)
         integer, intent(in) :: k
         character(*), intent(in) :: key
         type(column_type), intent(out) :: column
         integer :: colon
         column%place = text_of(group, key, key)
         column%required = k == 1 .or. is_given(group, key)
         if (is_given(group, key) .and. .not. is_sound(group, key)) sound = .false.
         colon = index(column%place, ':')
         if (column%place == '') then
            call group_fault(group, key, key//' is empty; give a heading, a number, or characters ''first:last''', faults)
         else if (is_number(column%place)) then
            read (column%place, *) column%number
            if (column%number == 0) call group_fault(group, key, key//' = 0 is not a column; the first is 1', faults)
         else if (colon > 0) then
            if (is_number(column%place(:colon - 1)) .and. is_number(column%place(colon + 1:))) then
               read (column%place(:colon - 1), *) column%first
               read (column%place(colon + 1:), *) column%last
            end if
            if (column%first < 1 .or. column%last < column%first) &
               call group_fault(group, key, key//' = '//quoted(column%place)// &
                  ' is not a range of characters; write as in ''11:20''', &
                  faults)
         end if
         column%unit_name = unit_label(units, column_quantity(k))
         column%unit_given = is_given(group, key//'_unit')
         if (column%unit_given) column%unit_name = text_of(group, key//'_unit', column%unit_name)
         column%unit = unit_value(k, column%unit_name)
         if (.not. column%unit > 0.0_wp) then
            call group_fault(group, key//'_unit', key//'_unit = '//quoted(column%unit_name)//' is unknown; legal: '// &
               trim(legal_units(k)), faults)
            column%unit = 1.0_wp
         end if
      end subroutine read_column

      pure function is_number(text) result(is)
         character(*), intent(in) :: text
         logical :: is
         is = len(text) > 0 .and. len(text) <= longest_number .and. verify(text, digits) == 0
      end function is_number
   end subroutine read_one
end module dg_deck_legacy

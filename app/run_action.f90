!> Actions of the program without a solution: a template deck, the catalogue of pipe, a deck in other units, a deck from
!> another program's case.
module dg_run_action
   use dg_arguments, only: arguments_type
   use dg_catalogue, only: catalogue_type, find_catalogue, kind_of_grades, number_of, numeric_keys, place_of_name, &
                           read_catalogue
   use dg_deck_convert, only: convert_deck
   use dg_deck_schema, only: group_keys_type
   use dg_deck_source, only: read_source
   use dg_deck_template, only: deck_template
   use dg_diagnostic, only: report_line, report_lines
   use dg_error, only: add_fault, error_lines, error_list_type, status_bad_input, status_failure, status_ok
   use dg_import_case, only: import_case
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_number_text, only: fixed_cell, left_aligned, right_aligned
   use dg_printed_text, only: print_lines
   use dg_process, only: someone_reads
   use dg_read_deck, only: build_deck
   use dg_registry, only: deck_groups
   use dg_standard_output, only: write_line
   use dg_text, only: append_text, lower_case, quoted, text_list, text_type
   use dg_unit_kind, only: unit_diameter, unit_label, unit_mass, unit_stress
   use dg_units, only: field_units, si_units, unit_system, unit_system_type
   implicit none
   private
   public :: run_action

   !> Columns of the list of the catalogue, numbers once in SI and once in field units.
   integer, parameter :: name_width = 38, kind_width = 15
   character(*), parameter :: heading = '      od      id    mass joint od  yield'

contains

   !> Does what an option that solves nothing says.
   subroutine run_action(arguments, status)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status          !< of the program
      type(text_type), allocatable :: lines(:), deck(:)
      type(error_list_type) :: faults
      type(group_keys_type), allocatable :: groups(:)
      type(model_type) :: model
      type(job_type) :: job
      type(unit_system_type) :: units
      character(:), allocatable :: name, failure
      allocate (lines(0))   ! the compiler's flow analysis takes them for undefined otherwise
      select case (arguments%action)
      case ('template')
         call deck_groups(groups)
         call deck_template(groups, unit_system(arguments%deck), lines)
         call print_lines(lines)
         status = status_ok
      case ('list-catalogue')
         call list_catalogue(arguments%deck, status)
      case ('convert')
         call read_source(arguments%deck, name, deck, failure)
         if (failure /= '') then
            call add_fault(faults, name, 0, 'deck '//failure)
         else
            call build_deck(name, deck, model, job, faults)
         end if
         if (faults%count > 0) then
            call report_lines(error_lines(faults))
            status = status_bad_input
         else
            call deck_groups(groups)
            units = unit_system(arguments%units)
            if (arguments%units == '' .and. job%units%name == units%name) units = field_units()
            call convert_deck(name, deck, job%units, units, groups, lines)
            call print_deck(lines)
            status = status_ok
         end if
      case ('import')
         call import_case([text_list(arguments%deck), arguments%files], arguments%well, arguments%units, lines, failure)
         status = status_ok
         if (failure == '') then
            call print_deck(lines)
         else
            call report_line(failure)
            status = status_bad_input
         end if
      case default
         status = status_failure
      end select
   end subroutine run_action

   !> A deck, byte for byte, unless a terminal shows it.
   subroutine print_deck(lines)
      type(text_type), intent(in) :: lines(:)
      integer :: i
      if (someone_reads()) then
         call print_lines(lines)
         return
      end if
      do i = 1, size(lines)
         call write_line(lines(i)%text)
      end do
   end subroutine print_deck

   !> Prints the entries that have `pattern` in their name or kind. With a grade as its last word: the pipes that have the words
   !> before it, of that grade.
   subroutine list_catalogue(pattern, status)
      character(*), intent(in) :: pattern
      integer, intent(out) :: status
      type(catalogue_type) :: catalogue
      type(error_list_type) :: faults
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: path, sought
      integer :: i, cut, grade
      status = status_bad_input
      call find_catalogue('', '', path)
      call read_catalogue(path, catalogue, faults)
      if (faults%count > 0) then
         call report_lines(error_lines(faults))
         return
      end if
      allocate (lines(0))
      sought = lower_case(trim(pattern))
      cut = index(sought, ' ', back=.true.)
      grade = 0
      if (cut > 0) grade = place_of_name(catalogue, sought(cut + 1:), .true.)
      if (grade > 0) sought = sought(:cut - 1)
      do i = 1, size(catalogue%entries)
         if (grade > 0 .and. catalogue%entries(i)%kind == kind_of_grades) cycle
         if (index(lower_case(catalogue%entries(i)%name), sought) == 0 .and. &
             index(lower_case(catalogue%entries(i)%kind), sought) == 0) cycle
         if (size(lines) == 0) then
            call append_text(lines, path)
            if (grade == 0) call append_text(lines, 'A grade behind the name of pipe gives its yield: '// &
                                             "'CSG 5-1/2 23.00 P110'. Joint torsion is known for names with joint "// &
                                             'diameters, as 6-5/8x2-3/4.')
            call append_text(lines, left_aligned('name', name_width)//left_aligned('kind', kind_width)//heading//heading// &
                             '  source')
            call append_text(lines, repeat(' ', name_width + kind_width)//heads(si_units())//heads(field_units()))
         end if
         call append_text(lines, entry_line(catalogue, i, grade))
      end do
      if (size(lines) == 0) then
         call report_line(path//' has nothing like '//quoted(pattern))
         return
      end if
      if (sought /= '' .and. place_of_name(catalogue, sought, .true.) > 0) &
         call append_text(lines, 'A grade stands behind the name of a '// &
                          "pipe: catalogue = 'DP 5 19.50 NC50 S135'. List pipe of a grade so: --list-catalogue 'DP 5 S135'")
      call print_lines(lines)
      status = status_ok
   end subroutine list_catalogue

   !> Units of the columns of numbers.
   function heads(units) result(text)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      text = right_aligned(unit_label(units, unit_diameter), 8)//right_aligned(unit_label(units, unit_diameter), 8)// &
         right_aligned(unit_label(units, unit_mass), 8)//right_aligned(unit_label(units, unit_diameter), 9)// &
         right_aligned(unit_label(units, unit_stress), 7)
   end function heads

   !> One entry of the list, with the number of its grade or 0.
   function entry_line(catalogue, entry, grade) result(line)
      type(catalogue_type), intent(in) :: catalogue
      integer, intent(in) :: entry, grade
      character(:), allocatable :: line
      associate (found => catalogue%entries(entry))
         line = found%name
         if (grade > 0) line = line//' '//catalogue%entries(grade)%name
         line = left_aligned(line, name_width)//left_aligned(found%kind, kind_width)//cells(si_units(), 1)// &
                cells(field_units(), 3)//'  '//found%source
      end associate
   contains
      function cells(units, decimals) result(text)
         type(unit_system_type), intent(in) :: units
         integer, intent(in) :: decimals          !< of diameters
         character(:), allocatable :: text
         text = cell('od', units%diameter, 8, decimals)//cell('id', units%diameter, 8, decimals)// &
            cell('mass', units%mass_per_length, 8, 2)//cell('joint_od', units%diameter, 9, decimals)// &
            cell('yield', units%stress, 7, 0)
      end function cells

      function cell(key, unit, width, decimals) result(text)
         character(*), intent(in) :: key
         real(wp), intent(in) :: unit
         integer, intent(in) :: width, decimals
         character(width) :: text
         real(wp) :: number
         logical :: has
         call number_of(catalogue, entry, grade, findloc(numeric_keys == key, .true., dim=1), has, number)
         text = repeat(' ', width - 1)//'-'
         if (has) text = fixed_cell(number/unit, width, decimals)
      end function cell
   end function entry_line
end module dg_run_action

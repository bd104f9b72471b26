!> results.h5: everything of a run in one file, as output/README.md describes it.
!>
!> /cases/<case>/<model>/<column>          along the string, as in profile_<case>_<model>.csv
!> /cases/<case>/<model>/history/<column>  as in history_<case>_<model>.csv
!> /cases/<case>/<model>/gaps/<column>     the state table at the end, one row a gap element
!> /survey/<column>                        stations of the hole, as given
!> Rows of summary.csv and limits.csv are attributes of /cases/<case>/<model>.
module dg_results_h5
   use, intrinsic :: iso_fortran_env, only: compiler_options, compiler_version
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type, contact_name, contact_point_type
   use dg_column, only: column_header, column_type, field_absent, field_integer, field_list_type, field_real, field_text, &
                        quantity_angle, quantity_force, quantity_length, quantity_none, quantity_text, unit_size, unit_text
   use dg_contacts_file, only: contact_columns
   use dg_error, only: error_type
   use dg_named_states, only: state_name
   use dg_hdf5_file, only: close_hdf5, create_hdf5, hdf5_file_type, make_group, write_attribute, write_data
   use dg_history_file, only: history_columns, history_fields
   use dg_job, only: job_type, model_name
   use dg_limits_file, only: limits_columns, limits_fields
   use dg_missing, only: missing
   use dg_model, only: model_type
   use dg_profile_columns, only: code_names, profile_codes, profile_columns, profile_values
   use dg_summary_file, only: summary_columns, summary_fields
   use dg_text, only: text_or_nothing, to_text
   use dg_units, only: unit_system_type
   use dg_version, only: program_name, program_version
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: write_results_h5, time_stamp

   type(column_type), parameter :: survey_columns(3) = [ &
      column_type('md', quantity_length, 'measured depth of the station'), &
      column_type('inclination', quantity_angle, 'of the hole'), &
      column_type('azimuth', quantity_angle, 'of the hole, from north')]

   type(column_type), parameter :: gap_columns(5) = [ &
      column_type('md', quantity_length, 'measured depth of the gap element''s place x0'), &
      column_type('state', quantity_text, 'free, elastic or rigid'), &
      column_type('force', quantity_force, 'contact force of the element'), &
      column_type('flips', quantity_none, 'changes of state during the iteration'), &
      column_type('moves', quantity_none, 'changes of place during the iteration')]

contains

   !> Writes results.h5 to `path`.
   subroutine write_results_h5(path, job, model, results, alongs, wholes, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)  !< as many
      type(whole_string_type), intent(in) :: wholes(:)  !< as many
      type(error_type), allocatable, intent(out) :: error
      type(hdf5_file_type) :: file
      character(:), allocatable :: group
      integer :: i, j
      call create_hdf5(file, path)
      call put_provenance(file, job)
      call put_survey(file, job%units, model)
      call make_group(file, '/cases')
      do i = 1, size(model%cases)
         group = '/cases/'//model%cases(i)%name
         call make_group(file, group)
         do j = 1, size(results)
            if (results(j)%case_index == i) &
               call put_result(file, group//'/'//trim(model_name(results(j)%model)), job%units, model%cases(i)%name, model, &
                               results(j), alongs(j), wholes(j))
         end do
      end do
      call close_hdf5(file, error)
   end subroutine write_results_h5

   !> Where the numbers come from, as attributes of the root.
   subroutine put_provenance(file, job)
      type(hdf5_file_type), intent(inout) :: file
      type(job_type), intent(in) :: job
      call write_attribute(file, '/', 'program', program_name)
      call write_attribute(file, '/', 'version', program_version)
      call write_attribute(file, '/', 'compiler', compiler_version())
      call write_attribute(file, '/', 'compiler_options', compiler_options())
      call write_attribute(file, '/', 'time', time_stamp())
      call write_attribute(file, '/', 'title', text_or_nothing(job%title))
      call write_attribute(file, '/', 'deck_path', text_or_nothing(job%deck_path))
      call write_attribute(file, '/', 'deck', text_or_nothing(job%deck_text))
      call write_attribute(file, '/', 'unit_system', trim(job%units%name))
   end subroutine put_provenance

   subroutine put_survey(file, units, model)
      type(hdf5_file_type), intent(inout) :: file
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      integer :: i
      call make_group(file, '/survey')
      call put_column(file, '/survey', survey_columns(1), units, model%trajectory%md)
      call put_column(file, '/survey', survey_columns(2), units, model%trajectory%inclination)
      call put_column(file, '/survey', survey_columns(3), units, model%trajectory%azimuth)
      if (.not. allocated(model%path_notes)) return
      do i = 1, size(model%path_notes)
         call write_attribute(file, '/survey', 'note_'//to_text(i), model%path_notes(i)%text)
      end do
   end subroutine put_survey

   !> One result: its rows of tables as attributes, its columns, its history.
   subroutine put_result(file, group, units, name, model, result, along, whole)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: name     !< of the case
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(whole_string_type), intent(in) :: whole
      type(field_list_type) :: row
      real(wp), allocatable :: values(:)
      integer, allocatable :: codes(:)
      integer :: j, n
      call make_group(file, group)
      call summary_fields(model%cases(result%case_index), result, whole%verdict, units, row)
      call put_row(file, group, summary_columns, units, row, 1)
      call limits_fields(name, result, whole, row)
      call put_row(file, group, limits_columns, units, row, 4)    ! case, model and status stand there already
      call put_iteration(file, group, units, result)
      if (.not. allocated(result%profile%md)) return
      call write_attribute(file, group, 'neutral_point_'//trim(units%length_label), whole%neutral_points/units%length)
      n = size(result%profile%md)
      allocate (values(n), codes(n))
      do j = 1, size(profile_columns)
         associate (column => profile_columns(j))
            if (column%quantity == quantity_text) then
               call profile_codes(trim(column%name), result%profile, along, codes)
               call put_codes(file, group, column, codes, code_names(trim(column%name)))
            else
               call profile_values(trim(column%name), result%profile, along, values)
               call put_column(file, group, column, units, values)
            end if
         end associate
      end do
      if (allocated(result%contacts)) then
         if (size(result%contacts) > 0) call put_contacts(file, group//'/contacts', units, result%contacts)
      end if
   end subroutine put_result

   !> What tells of the iteration, be it that it found no equilibrium: the state table and the history.
   subroutine put_iteration(file, group, units, result)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(in) :: result
      if (allocated(result%gaps)) call put_gaps(file, group//'/gaps', units, result)
      if (.not. allocated(result%history)) return
      if (size(result%history) > 0) call put_history(file, group//'/history', units, result)
   end subroutine put_iteration

   !> The state table.
   subroutine put_gaps(file, group, units, result)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(in) :: result
      real(wp), allocatable :: values(:, :)
      integer, allocatable :: states(:)
      allocate (values(size(result%gaps), 4))
      values(:, 1) = result%gaps%md
      values(:, 2) = result%gaps%force
      values(:, 3) = result%gaps%flips
      values(:, 4) = result%gaps%moves
      allocate (states(size(result%gaps)))
      states = result%gaps%state
      call make_group(file, group)
      call put_column(file, group, gap_columns(1), units, values(:, 1))
      call put_codes(file, group, gap_columns(2), states, state_name)
      call put_column(file, group, gap_columns(3), units, values(:, 2))
      call put_column(file, group, gap_columns(4), units, values(:, 3))
      call put_column(file, group, gap_columns(5), units, values(:, 4))
   end subroutine put_gaps

   !> The concentrated contacts.
   subroutine put_contacts(file, group, units, contacts)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(contact_point_type), intent(in) :: contacts(:)
      real(wp) :: values(size(contacts), 4)
      integer :: i
      values(:, 1) = contacts%md
      values(:, 2) = contacts%force
      values(:, 3) = contacts%length
      values(:, 4) = contacts%clock
      call make_group(file, group)
      do i = 1, 4
         call put_column(file, group, contact_columns(i), units, values(:, i))
      end do
      call put_codes(file, group, contact_columns(5), contacts%kind - 1, contact_name)
   end subroutine put_contacts

   !> The course of the iteration.
   subroutine put_history(file, group, units, result)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(case_result_type), intent(in) :: result
      real(wp), allocatable :: values(:, :)
      type(field_list_type) :: row
      integer :: i, j
      allocate (values(size(result%history), size(history_columns)))
      do i = 1, size(result%history)
         call history_fields(result%history(i), row)
         do j = 1, size(history_columns)
            values(i, j) = missing
            select case (row%fields(j)%kind)
            case (field_real); values(i, j) = row%fields(j)%real_value
            case (field_integer); values(i, j) = row%fields(j)%integer_value
            case default
               if (history_columns(j)%name == 'judged_by') values(i, j) = result%history(i)%judged
            end select
         end do
      end do
      call make_group(file, group)
      do j = 1, size(history_columns)
         call put_column(file, group, history_columns(j), units, values(:, j))
      end do
   end subroutine put_history

   !> One column of numbers with its unit and description.
   subroutine put_column(file, group, column, units, values)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(column_type), intent(in) :: column
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: values(:)    !< in SI units
      character(:), allocatable :: path
      path = group//'/'//column_header(column, units)
      call write_data(file, path, values, unit=unit_size(column%quantity, units))
      call write_attribute(file, path, 'units', unit_text(column%quantity, units))
      call write_attribute(file, path, 'description', trim(column%meaning))
   end subroutine put_column

   !> A column of numbers that stand for words.
   subroutine put_codes(file, group, column, codes, names)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(column_type), intent(in) :: column
      integer, intent(in) :: codes(:)
      character(*), intent(in) :: names(0:)   !< by number
      character(:), allocatable :: path
      path = group//'/'//trim(column%name)
      call write_data(file, path, codes)
      call write_attribute(file, path, 'units', '')
      call write_attribute(file, path, 'description', trim(column%meaning))
      call write_attribute(file, path, 'values', code_text(names))
   end subroutine put_codes

   !> A row of a table as attributes, from its column `first` on; values that are absent are left out.
   subroutine put_row(file, group, columns, units, row, first)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(column_type), intent(in) :: columns(:)
      type(unit_system_type), intent(in) :: units
      type(field_list_type), intent(in) :: row
      integer, intent(in) :: first
      character(:), allocatable :: name
      integer :: j
      do j = first, size(columns)
         name = column_header(columns(j), units)
         select case (row%fields(j)%kind)
         case (field_text); call write_attribute(file, group, name, row%fields(j)%text)
         case (field_integer); call write_attribute(file, group, name, row%fields(j)%integer_value)
         case (field_real); call write_attribute(file, group, name, row%fields(j)%real_value/ &
                                                 unit_size(columns(j)%quantity, units))
         case (field_absent)
         case default
         end select
      end do
   end subroutine put_row

   !> '0 free, 1 elastic, 2 rigid'; a name that is empty in CSV files is '(empty)'.
   pure function code_text(names) result(text)
      character(*), intent(in) :: names(0:)
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 0, ubound(names, 1)
         if (i > 0) text = text//', '
         text = text//to_text(i)//' '//trim(names(i))
         if (names(i) == '') text = text//'(empty)'
      end do
   end function code_text

   !> Now, in the form of ISO 8601 with the zone: 2002-11-30T12:00:00+08:00.
   function time_stamp() result(text)
      character(25) :: text
      character(8) :: date
      character(10) :: time
      character(5) :: zone
      call date_and_time(date=date, time=time, zone=zone)
      text = date(1:4)//'-'//date(5:6)//'-'//date(7:8)//'T'//time(1:2)//':'//time(3:4)//':'//time(5:6)// &
         zone(1:3)//':'//zone(4:5)
   end function time_stamp
end module dg_results_h5

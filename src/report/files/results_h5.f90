!> results.h5: all results of a run in one file, as described in output/README.md.
!>
!> - /cases/<case>/<model>/<column>: along the string, as in profile_<case>_<model>.csv
!> - /cases/<case>/<model>/history/<column>: as in history_<case>_<model>.csv
!> - /cases/<case>/<model>/gaps/<column>: the state table at the end, one row per gap element
!> - /survey/<column>: stations of the hole, as given
!> - attributes of /cases/<case>/<model>: rows of summary.csv and limits.csv
module dg_results_h5
   use, intrinsic :: iso_fortran_env, only: compiler_options, compiler_version
   use dg_kinds, only: wp
   use dg_column, only: column_header, field_integer, field_real, field_text, quantity_angle, quantity_length, quantity_text, &
                        row_type
   use dg_findings, only: findings_type, name_of
   use dg_solution_series, only: contact_series, history_series, gap_series
   use dg_error, only: error_type
   use dg_hdf5_file, only: close_hdf5, create_hdf5, hdf5_file_type, make_group, write_attribute, write_data
   use dg_job, only: job_type, model_name
   use dg_limits_file, only: limits_row
   use dg_model, only: model_type
   use dg_profile_file, only: profile_series
   use dg_series, only: add, series_list_type, value_count
   use dg_summary_file, only: summary_row
   use dg_text, only: text_or_nothing, text_type, to_text
   use dg_trajectory, only: trajectory_type
   use dg_units, only: unit_system_type
   use dg_version, only: program_name, program_version
   use dg_unit_kind, only: unit_factor, unit_label
   implicit none
   private
   public :: write_results_h5, time_stamp

contains

   !> Writes results.h5 to `path`.
   subroutine write_results_h5(path, found, error)
      character(*), intent(in) :: path
      type(findings_type), intent(in) :: found
      type(error_type), allocatable, intent(out) :: error
      type(hdf5_file_type) :: file
      character(:), allocatable :: group
      integer :: i, j
      call create_hdf5(file, path)
      call write_provenance(file, found%job)
      call write_survey(file, found%job%units, found%model)
      call make_group(file, '/cases')
      do i = 1, size(found%model%cases)
         group = '/cases/'//found%model%cases(i)%name
         call make_group(file, group)
         do j = 1, size(found%results)
            if (found%results(j)%case_index == i) &
               call write_result(file, group//'/'//trim(model_name(found%results(j)%model)), found, j)
         end do
      end do
      call close_hdf5(file, error)
   end subroutine write_results_h5

   !> Origin of the numbers, as attributes of the root.
   subroutine write_provenance(file, job)
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
   end subroutine write_provenance

   subroutine write_survey(file, units, model)
      type(hdf5_file_type), intent(inout) :: file
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      integer :: i
      call write_table(file, '/survey', units, survey_series(model%trajectory))
      if (.not. allocated(model%path_notes)) return
      do i = 1, size(model%path_notes)
         call write_attribute(file, '/survey', 'note_'//to_text(i), model%path_notes(i)%text)
      end do
   end subroutine write_survey

   !> Stations of the hole.
   pure function survey_series(trajectory) result(list)
      type(trajectory_type), intent(in) :: trajectory
      type(series_list_type) :: list
      call add(list, 'md', quantity_length, 'measured depth of the station', trajectory%md)
      call add(list, 'inclination', quantity_angle, 'of the hole', trajectory%inclination)
      call add(list, 'azimuth', quantity_angle, 'of the hole, from north', trajectory%azimuth)
   end function survey_series

   !> One result: its rows of tables as attributes, its columns, its history.
   subroutine write_result(file, group, found, row)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(findings_type), intent(in) :: found
      integer, intent(in) :: row            !< number of the result
      associate (units => found%job%units, result => found%results(row), whole => found%wholes(row))
         call make_group(file, group)
         call write_row(file, group, units, &
                        summary_row(found%model%cases(result%case_index), result, whole%verdict, units), 1)
         ! case, model and status stand there already
         call write_row(file, group, units, limits_row(name_of(found, row), result, whole), 4)
         if (allocated(result%gaps)) call write_table(file, group//'/gaps', units, gap_series(result%gaps))
         if (allocated(result%history)) call write_table(file, group//'/history', units, history_series(result%history))
         if (.not. allocated(result%profile%md)) return
         call write_attribute(file, group, 'neutral_point_'//trim(units%length_label), whole%neutral_points/units%length)
         call write_columns(file, group, units, profile_series(result%profile, found%alongs(row)))
         if (allocated(result%contacts)) call write_table(file, group//'/contacts', units, contact_series(result%contacts))
      end associate
   end subroutine write_result

   !> Columns in a group of their own, where there are any rows.
   subroutine write_table(file, group, units, list)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(series_list_type), intent(in) :: list
      if (value_count(list) == 0) return
      call make_group(file, group)
      call write_columns(file, group, units, list)
   end subroutine write_table

   !> Columns with their units and descriptions. States with quantity_text are stored with their words, others as numbers.
   subroutine write_columns(file, group, units, list)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(series_list_type), intent(in) :: list
      character(:), allocatable :: path
      integer :: i
      do i = 1, list%count
         associate (series => list%items(i), column => list%items(i)%column)
            path = group//'/'//column_header(column, units)
            if (.not. allocated(series%states)) then
               call write_data(file, path, series%numbers, unit=unit_factor(units, column%quantity))
            else if (column%quantity == quantity_text) then
               call write_data(file, path, series%states)
            else
               call write_data(file, path, real(series%states, wp), unit=1.0_wp)
            end if
            call write_attribute(file, path, 'units', unit_label(units, column%quantity))
            call write_attribute(file, path, 'description', trim(column%meaning))
            if (column%quantity == quantity_text) call write_attribute(file, path, 'values', words_text(series%words))
         end associate
      end do
   end subroutine write_columns

   !> A row of a table as attributes, from its column `first` on; values that are absent are left out.
   subroutine write_row(file, group, units, row, first)
      type(hdf5_file_type), intent(inout) :: file
      character(*), intent(in) :: group
      type(unit_system_type), intent(in) :: units
      type(row_type), intent(in) :: row
      integer, intent(in) :: first
      character(:), allocatable :: name
      integer :: j
      do j = first, row%count
         associate (field => row%fields(j))
            name = column_header(field%column, units)
            select case (field%kind)
            case (field_text); call write_attribute(file, group, name, field%text)
            case (field_integer); call write_attribute(file, group, name, field%integer_value)
            case (field_real); call write_attribute(file, group, name, &
                                                    field%real_value/unit_factor(units, field%column%quantity))
            case default
            end select
         end associate
      end do
   end subroutine write_row

   !> '0 free, 1 elastic, 2 rigid'; a word that is empty in CSV files is '(empty)'.
   pure function words_text(words) result(text)
      type(text_type), intent(in) :: words(0:)
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 0, ubound(words, 1)
         if (i > 0) text = text//', '
         text = text//to_text(i)//' '//words(i)%text
         if (words(i)%text == '') text = text//'(empty)'
      end do
   end function words_text

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

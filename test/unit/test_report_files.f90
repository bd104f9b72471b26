module dg_test_report_files
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_csv_table, only: write_series
   use dg_error, only: error_type, status_failure
   use dg_file_system, only: delete_file, rename_file, write_text_file
   use dg_constants, only: pi
   use dg_solution_series, only: contact_series, history_series
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_along_string, only: new_along_string
   use dg_column, only: csv_header, csv_row, row_type
   use dg_profile_file, only: profile_series
   use dg_summary_file, only: summary_row, write_summary
   use dg_test_report_sample, only: sample_job, sample_model, sample_results
   use dg_text, only: append_text, text_type
   use dg_case_result, only: case_result_type, contact_joint, contact_point_type, iteration_type
   use dg_verdict, only: verdict_type
   use dg_findings, only: findings_type
   use dg_whole_string, only: whole_string_type
   use dg_units, only: field_units, si_units
   implicit none
   private
   public :: report_files_suite

   integer, parameter :: line_length = 1000
   !> Scratch file, below fpm's own folder.
   character(*), parameter :: path = 'build/test_report_files.txt'

contains

   function report_files_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('report_files')
      call suite%addTest(TestMethod('whole_or_not_at_all', test_whole_or_not_at_all, tearDown=remove_scratch))
      call suite%addTest(TestMethod('no_such_folder', test_no_such_folder))
      call suite%addTest(TestMethod('rename', test_rename, tearDown=remove_scratch))
      call suite%addTest(TestMethod('summary', test_summary, tearDown=remove_scratch))
      call suite%addTest(TestMethod('summary_quotes_text', test_summary_quotes_text))
      call suite%addTest(TestMethod('summary_in_field_units', test_summary_in_field_units))
      call suite%addTest(TestMethod('profile', test_profile, tearDown=remove_scratch))
      call suite%addTest(TestMethod('profile_in_field_units', test_profile_in_field_units, tearDown=remove_scratch))
      call suite%addTest(TestMethod('history', test_history, tearDown=remove_scratch))
      call suite%addTest(TestMethod('contacts', test_contacts, tearDown=remove_scratch))
      call suite%addTest(TestMethod('no_history', test_no_history, tearDown=remove_scratch))
   end function report_files_suite

   subroutine remove_scratch()
      call delete_file(path)
   end subroutine remove_scratch

   subroutine test_whole_or_not_at_all()
      type(text_type) :: lines(2)
      type(error_type), allocatable :: error
      type(text_type), allocatable :: found(:)
      lines(1)%text = 'old'
      lines(2)%text = ''
      call write_text_file(path, lines, error)
      call assertFalse(allocated(error))
      lines(1)%text = 'new'
      call write_text_file(path, lines, error)
      call assertFalse(allocated(error))
      call read_lines(path, found)
      call assertEqual(2, size(found))
      if (anyExceptions()) return
      call assertEqual('new', found(1)%text)
      call assertFalse(exists(path//'.unfinished'), message='nothing unfinished is left')
   end subroutine test_whole_or_not_at_all

   subroutine test_no_such_folder()
      type(error_type), allocatable :: error
      type(text_type) :: lines(0)
      call write_text_file('build/no/such/folder/file.csv', lines, error)
      call assertTrue(allocated(error))
      if (.not. allocated(error)) return
      call assertEqual(status_failure, error%status)
      call assertTrue(index(error%message, 'build/no/such/folder/file.csv') > 0, message=error%message)
   end subroutine test_no_such_folder

   subroutine test_rename()
      type(error_type), allocatable :: error
      type(text_type) :: lines(1)
      lines(1)%text = 'x'
      call write_text_file(path//'.a', lines, error)
      call rename_file(path//'.a', path, error)
      call assertFalse(allocated(error))
      call assertTrue(exists(path))
      call rename_file(path//'.a', path, error)
      call assertTrue(allocated(error), message='the file has moved')
      if (allocated(error)) call assertEqual(1, index(error%message, 'cannot rename '//path//'.a to '//path//': '))
      call delete_file(path//'.a') ! absent: no harm
   end subroutine test_rename

   !> Columns and their order are a contract.
   subroutine test_summary()
      type(whole_string_type) :: wholes(4)
      type(findings_type) :: found
      type(error_type), allocatable :: error
      type(text_type), allocatable :: rows(:)
      character(*), parameter :: contract = 'case,section,model,operation,bit_depth_m,inclination_deg,wob_kN,hookload_kN,'// &
         'measured_kN,error_pct,reference_kN,reference_error_pct,friction_kN,torque_kNm,normal_force_kN,status,'// &
         'iterations,elements,seconds,'
      found = findings_type(sample_job(), sample_model(), sample_results(), wholes=wholes)
      call write_summary(path, found, error)
      call assertFalse(allocated(error))
      call read_lines(path, rows)
      call assertEqual(5, size(rows))
      if (anyExceptions()) return
      call assertEqual(contract, rows(1)%text(:len(contract)))
      call assertEqual('i_up,Inclined section,mcge,trip_out,2075.000000,65.00000000,0.000000000,733.4000000,745.0000000,'// &
                       '1.557046980,,,-17.29000000,0.000000000,170.0000000,converged,7,208,0.2500000000,,,100,90,18,12,3,'// &
                       '0.1000000000E-8,0.2000000000E-8,,,unknown,,,,,,,,0', rows(2)%text)
      call assertTrue(index(rows(5)%text, ',170.0000000,,,,524.3000000,,,,,not_converged,200,208,') > 0, message=rows(5)%text)
      call assertTrue(index(rows(5)%text, ',not_converged,200,') > 0)
   end subroutine test_summary

   subroutine test_summary_quotes_text()
      type(model_type) :: model
      type(job_type) :: job
      type(case_result_type), allocatable :: results(:)
      character(:), allocatable :: row
      model = sample_model()
      model%cases(1)%section = 'curve, "upper"'
      job = sample_job()
      allocate (results, source=sample_results())
      row = csv_row(summary_row(model%cases(1), results(1), verdict_type(), job%units), job%units)
      call assertEqual(1, index(row, 'i_up,"curve, ""upper""",mcge,'), message=row)
      deallocate (model%cases(1)%section)
      row = csv_row(summary_row(model%cases(1), results(1), verdict_type(), job%units), job%units)
      call assertEqual(1, index(row, 'i_up,,mcge,'), message=row)
   end subroutine test_summary_quotes_text

   subroutine test_summary_in_field_units()
      character(:), allocatable :: header
      type(case_result_type), allocatable :: results(:)
      type(model_type) :: model
      type(row_type) :: row
      model = sample_model()
      allocate (results, source=sample_results())
      row = summary_row(model%cases(1), results(1), verdict_type(), field_units())
      header = csv_header(row%fields(:row%count)%column, field_units())
      call assertTrue(index(header, ',bit_depth_ft,inclination_deg,wob_klbf,hookload_klbf,') > 0, message=header)
      call assertTrue(index(header, ',torque_kftlbf,') > 0, message=header)
   end subroutine test_summary_in_field_units

   subroutine test_profile()
      type(error_type), allocatable :: error
      type(text_type), allocatable :: found(:)
      type(case_result_type), allocatable :: results(:)
      allocate (results, source=sample_results())
      call write_series(profile_series(results(1)%profile, new_along_string(2)), path, si_units(), error)
      call assertFalse(allocated(error))
      call read_lines(path, found)
      call assertEqual(3, size(found))
      if (anyExceptions()) return
      call assertEqual(1, index(found(1)%text, 'md_m,tvd_m,north_m,east_m,inclination_deg,azimuth_deg,axial_kN,torque_kNm,'// &
                                'side_force_kN_m,bending_kNm,displacement_mm,clock_deg,gap_state,true_axial_kN,shear_kN,'), &
                       message='the first thirteen are a contract')
      call assertTrue(index(found(2)%text, ',733.4000000,') > 0, message=found(2)%text)
      call assertEqual(1, index(found(3)%text, '2075.000000,0.000000000,0.000000000,0.000000000,65.00000000,0.000000000,'// &
                                '0.000000000,0.000000000,0.000000000,0.000000000,44.50000000,0.000000000,elastic,'), &
                       message=found(3)%text)
      call assertTrue(index(found(3)%text, ',elastic,0.000000000,,') > 0, message='no shear force: an empty field')
   end subroutine test_profile

   !> 2075 m = 6807.742782 ft; 733.4 kN = 164.8748789 klbf; 44.5 mm = 1.751968504 in.
   subroutine test_profile_in_field_units()
      type(error_type), allocatable :: error
      type(text_type), allocatable :: found(:)
      type(case_result_type), allocatable :: results(:)
      type(job_type) :: job
      job = sample_job()
      job%units = field_units()
      allocate (results, source=sample_results())
      call write_series(profile_series(results(1)%profile, new_along_string(2)), path, job%units, error)
      call read_lines(path, found)
      if (anyExceptions()) return
      call assertTrue(index(found(1)%text, 'md_ft,') == 1 .and. index(found(1)%text, ',side_force_klbf_ft,') > 0, &
                      message=found(1)%text)
      call assertTrue(index(found(2)%text, ',164.8748789,') > 0, message=found(2)%text)
      call assertTrue(index(found(3)%text, '6807.742782,') == 1 .and. index(found(3)%text, ',1.751968504,') > 0, &
                      message=found(3)%text)
   end subroutine test_profile_in_field_units

   subroutine test_history()
      type(error_type), allocatable :: error
      type(text_type), allocatable :: found(:)
      type(case_result_type), allocatable :: results(:)
      allocate (results, source=sample_results())
      call write_series(history_series(results(1)%history), path, si_units(), error)
      call read_lines(path, found)
      call assertEqual(2, size(found))
      if (anyExceptions()) return
      call assertEqual('attempt,increment,stage,iteration,residual_kN,residual_kNm,lateral_step_mm,damping,'// &
                       'judged_by,negative_pivots,contacts,flips,moves,hookload_kN', found(1)%text)
      call assertEqual('1,1,2,1,0.5000000000,0.000000000,0.000000000,0.000000000,start,,0,0,0,733.4000000', found(2)%text)
   end subroutine test_history

   !> One that presses the low side, and the header alone where none was looked for.
   subroutine test_contacts()
      type(error_type), allocatable :: error
      type(text_type), allocatable :: found(:)
      call write_series(contact_series([contact_point_type ::]), path, si_units(), error)
      call read_lines(path, found)
      call assertEqual(1, size(found))
      if (anyExceptions()) return
      call write_series(contact_series([contact_point_type(contact_joint, 2070.0_wp, 2500.0_wp, 0.5_wp, pi)]), path, si_units(), &
                        error)
      call read_lines(path, found)
      call assertEqual(2, size(found))
      if (anyExceptions()) return
      call assertEqual('md_m,force_kN,length_m,clock_deg,kind', found(1)%text)
      call assertEqual('2070.000000,2.500000000,0.5000000000,180.0000000,tool joint', found(2)%text)
   end subroutine test_contacts

   subroutine test_no_history()
      type(error_type), allocatable :: error
      type(text_type), allocatable :: found(:)
      call write_series(history_series([iteration_type ::]), path, si_units(), error)
      call read_lines(path, found)
      if (anyExceptions()) return
      call assertEqual(1, size(found))
   end subroutine test_no_history

   logical function exists(file)
      character(*), intent(in) :: file
      inquire (file=file, exist=exists)
   end function exists

   subroutine read_lines(file, lines)
      character(*), intent(in) :: file
      type(text_type), allocatable, intent(out) :: lines(:)
      character(line_length) :: line
      integer :: unit, status
      allocate (lines(0))
      open (newunit=unit, file=file, action='read', status='old', iostat=status)
      call assertEqual(0, status, message='open '//file)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         call append_text(lines, trim(line))
      end do
      close (unit)
   end subroutine read_lines
end module dg_test_report_files

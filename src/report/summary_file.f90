!> summary.csv: one row a case and model.
module dg_summary_file
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_status_name
   use dg_comparison, only: percent_error
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, operation_name
   use dg_model, only: model_type
   use dg_number_text, only: csv_number, csv_optional, csv_text
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: write_summary, summary_header, summary_row

   real(wp), parameter :: one = 1.0_wp !< unit of numbers that carry none (per cent)

contains

   !> Writes summary.csv to `path`, in the order of `results`. Columns are added at the end only: others
   !> rely on the names.
   subroutine write_summary(path, job, model, results, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: lines(0:size(results))
      integer :: i
      lines(0)%text = summary_header(job%units)
      do i = 1, size(results)
         lines(i)%text = summary_row(job%units, model%cases(results(i)%case_index), results(i))
      end do
      call write_text_file(path, lines, error)
   end subroutine write_summary

   pure function summary_header(units) result(header)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: header
      character(:), allocatable :: length, force, moment
      length = '_'//trim(units%length_label)
      force = '_'//trim(units%force_label)
      moment = '_'//trim(units%moment_label)
      header = 'case,section,model,operation,bit_depth'//length//',inclination_deg,wob'//force//',hookload'//force// &
         ',measured'//force//',error_pct,reference'//force//',reference_error_pct,friction'//force// &
         ',torque'//moment//',normal_force'//force//',status,iterations,elements,seconds'// &
         ',measured_torque'//moment//',torque_error_pct,gaps_free,gaps_elastic,gaps_rigid,flips,moves'// &
         ',equilibrium'//force//',equilibrium'//moment//',message'
   end function summary_header

   pure function summary_row(units, load_case, result) result(row)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(case_result_type), intent(in) :: result
      character(:), allocatable :: row
      integer :: state
      row = csv_text(load_case%name)//','//csv_text(text_or_nothing(load_case%section))//','// &
         trim(model_name(result%model))//','//trim(operation_name(load_case%operation))//','// &
         csv_number(load_case%bit_depth/units%length)//','//csv_number(result%inclination/units%angle)//','// &
         csv_number(load_case%wob/units%force)//','//csv_number(result%hookload/units%force)//','// &
         csv_optional(load_case%measured_hookload, units%force)//','// &
         csv_optional(percent_error(result%hookload, load_case%measured_hookload), one)//','// &
         csv_optional(load_case%reference_hookload, units%force)//','// &
         csv_optional(percent_error(result%hookload, load_case%reference_hookload), one)//','// &
         csv_number(result%friction/units%force)//','//csv_number(result%torque/units%moment)//','// &
         csv_number(result%normal_force/units%force)//','//trim(result_status_name(result%status))//','// &
         csv_number(result%iterations)//','//csv_number(result%elements)//','//csv_number(result%seconds)
      row = row//','//csv_optional(load_case%measured_torque, units%moment)//','// &
         csv_optional(percent_error(result%torque, load_case%measured_torque), one)
      do state = lbound(result%states, 1), ubound(result%states, 1)
         row = row//','//csv_number(result%states(state))
      end do
      row = row//','//csv_number(result%flips)//','//csv_number(result%moves)//','// &
         csv_number(result%equilibrium_force/units%force)//','//csv_number(result%equilibrium_moment/units%moment)//','// &
         csv_text(text_or_nothing(result%message))
   end function summary_row

   pure function text_or_nothing(text) result(found)
      character(:), allocatable, intent(in) :: text
      character(:), allocatable :: found
      found = ''
      if (allocated(text)) found = text
   end function text_or_nothing
end module dg_summary_file

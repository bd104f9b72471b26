!> history_<case>_<model>.csv: the course of the iteration, one row an iteration.
module dg_history_file
   use dg_case_result, only: case_result_type, iteration_type
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type
   use dg_number_text, only: csv_number
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: write_history, history_header, history_row

contains

   !> Writes the iteration history of `result` to `path`: only the header where none was kept.
   subroutine write_history(path, job, result, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: i, n
      n = 0
      if (allocated(result%history)) n = size(result%history)
      allocate (lines(0:n))
      lines(0)%text = history_header(job%units)
      do i = 1, n
         lines(i)%text = history_row(job%units, result%history(i))
      end do
      call write_text_file(path, lines, error)
   end subroutine write_history

   pure function history_header(units) result(header)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: header
      character(:), allocatable :: force, moment
      force = trim(units%force_label)
      moment = trim(units%moment_label)
      header = 'increment,iteration,residual_'//force//',residual_'//moment//',lateral_step_'//trim(units%diameter_label)// &
         ',viscosity,contacts,flips,moves,hookload_'//force
   end function history_header

   pure function history_row(units, step) result(row)
      type(unit_system_type), intent(in) :: units
      type(iteration_type), intent(in) :: step
      character(:), allocatable :: row
      row = csv_number(step%increment)//','//csv_number(step%iteration)//','// &
         csv_number(step%residual_force/units%force)//','//csv_number(step%residual_moment/units%moment)//','// &
         csv_number(step%lateral_step/units%diameter)//','//csv_number(step%viscosity)//','// &
         csv_number(step%contacts)//','//csv_number(step%flips)//','//csv_number(step%moves)//','// &
         csv_number(step%hookload/units%force)
   end function history_row
end module dg_history_file

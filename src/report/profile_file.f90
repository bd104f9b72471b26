!> profile_<case>_<model>.csv: results along the string, surface to bit.
module dg_profile_file
   use dg_case_result, only: case_result_type
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type
   use dg_number_text, only: csv_number
   use dg_profile, only: profile_type, state_name
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: write_profile, profile_header, profile_row

contains

   !> Writes the profile of `result` to `path`. Columns are added at the end only: others rely on the names.
   subroutine write_profile(path, job, result, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: i, n
      n = 0
      if (allocated(result%profile%md)) n = size(result%profile%md)
      allocate (lines(0:n))
      lines(0)%text = profile_header(job%units)
      do i = 1, n
         lines(i)%text = profile_row(job%units, result%profile, i)
      end do
      call write_text_file(path, lines, error)
   end subroutine write_profile

   pure function profile_header(units) result(header)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: header
      character(:), allocatable :: length, force, moment
      length = '_'//trim(units%length_label)
      force = '_'//trim(units%force_label)
      moment = '_'//trim(units%moment_label)
      header = 'md'//length//',tvd'//length//',north'//length//',east'//length//',inclination_deg,azimuth_deg,axial'// &
         force//',torque'//moment//',side_force_'//trim(units%force_per_length_label)//',bending'//moment// &
         ',displacement_'//trim(units%diameter_label)//',clock_deg,gap_state'
   end function profile_header

   pure function profile_row(units, profile, i) result(row)
      type(unit_system_type), intent(in) :: units
      type(profile_type), intent(in) :: profile
      integer, intent(in) :: i
      character(:), allocatable :: row
      row = csv_number(profile%md(i)/units%length)//','//csv_number(profile%tvd(i)/units%length)//','// &
         csv_number(profile%north(i)/units%length)//','//csv_number(profile%east(i)/units%length)//','// &
         csv_number(profile%inclination(i)/units%angle)//','//csv_number(profile%azimuth(i)/units%angle)//','// &
         csv_number(profile%axial(i)/units%force)//','//csv_number(profile%torque(i)/units%moment)//','// &
         csv_number(profile%side_force(i)/units%force_per_length)//','//csv_number(profile%bending(i)/units%moment)//','// &
         csv_number(profile%displacement(i)/units%diameter)//','//csv_number(profile%clock(i)/units%angle)//','// &
         trim(state_name(profile%gap_state(i)))
   end function profile_row
end module dg_profile_file

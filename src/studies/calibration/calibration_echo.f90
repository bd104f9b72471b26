!> Tells what a deck's calibrations ask for as the program understood it.
module dg_calibration_echo
   use dg_kinds, only: wp
   use dg_calibration, only: parameter_name, predicts
   use dg_job, only: job_type, model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_sticking, only: find_free_point, sticking_name
   use dg_text, only: joined, to_text
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: add_calibrations

   !> Significant digits of a length.
   integer, parameter :: digits = 7

contains

   !> One line a calibration, one a held string.
   pure subroutine add_calibrations(lines, job)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      character(:), allocatable :: line
      real(wp) :: where
      integer :: i
      do i = 1, size(job%calibrations)
         associate (calibration => job%calibrations(i))
            line = 'calibrate   '//calibration%name//': '//trim(parameter_name(calibration%parameter))//'; '// &
               joined(model_name(calibration%models), ', ')//'; '//to_text(size(calibration%unknowns))//' unknowns from '// &
               to_text(size(calibration%data))//' measured values of '//to_text(size(calibration%cases))//' load cases'
            if (predicts(calibration)) line = line//'; '//to_text(size(calibration%predicted))//' predicted'
            if (calibration%apply) line = line//'; applied'
            call add_line(lines, line)
         end associate
      end do
      do i = 1, size(job%stickings)
         associate (sticking => job%stickings(i))
            where = sticking%depth
            if (sticking%kind == find_free_point) where = sticking%stretch
            call add_line(lines, 'calibrate   '//sticking%name//': '//trim(sticking_name(sticking%kind))//', '// &
               trim(merge('stretch', 'depth  ', sticking%kind == find_free_point))//' '// &
               trim(in_units(job%units, unit_length, where, digits))//'; '// &
               joined(model_name(sticking%models), ', ')//'; '//to_text(size(sticking%cases))//' load cases')
         end associate
      end do
   end subroutine add_calibrations
end module dg_calibration_echo

!> Tells what a deck's calibrations ask for as the program understood it.
module dg_calibration_echo
   use dg_calibration, only: calibration_type, parameter_name, predicts
   use dg_job, only: model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_text, only: joined, to_text
   implicit none
   private
   public :: add_calibrations

contains

   !> One line a calibration.
   pure subroutine add_calibrations(lines, calibrations)
      type(line_list_type), intent(inout) :: lines
      type(calibration_type), intent(in) :: calibrations(:)
      character(:), allocatable :: line
      integer :: i
      do i = 1, size(calibrations)
         associate (calibration => calibrations(i))
            line = 'calibrate   '//calibration%name//': '//trim(parameter_name(calibration%parameter))//'; '// &
               joined(model_name(calibration%models), ', ')//'; '//to_text(size(calibration%unknowns))//' unknowns from '// &
               to_text(size(calibration%data))//' measured values of '//to_text(size(calibration%cases))//' load cases'
            if (predicts(calibration)) line = line//'; '//to_text(size(calibration%predicted))//' predicted'
            if (calibration%apply) line = line//'; applied'
            call add_line(lines, line)
         end associate
      end do
   end subroutine add_calibrations
end module dg_calibration_echo

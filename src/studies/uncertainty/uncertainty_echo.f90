!> Tells what a deck's Monte Carlos ask for as the program understood it.
module dg_uncertainty_echo
   use dg_job, only: model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_load_case, only: operation_name
   use dg_text, only: joined, to_text
   use dg_uncertainty, only: piece_count, uncertainty_type
   use dg_uncertainty_table, only: deviations_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: add_uncertainties

contains

   !> One line a Monte Carlo.
   pure subroutine add_uncertainties(lines, uncertainties, units)
      type(line_list_type), intent(inout) :: lines
      type(uncertainty_type), intent(in) :: uncertainties(:)
      type(unit_system_type), intent(in) :: units
      integer :: i
      do i = 1, size(uncertainties)
         associate (uncertainty => uncertainties(i), range => uncertainties(i)%range)
            call add_line(lines, 'uncertainty '//range%name//': '//joined(model_name(range%models), ', ')//'; '// &
               joined(operation_name(range%operations), ', ')//'; '//to_text(size(range%depths))//' depths; '// &
               to_text(uncertainty%samples)//' samples, '//to_text(piece_count(uncertainty))//' solutions; '// &
               deviations_text(units, uncertainty))
         end associate
      end do
   end subroutine add_uncertainties
end module dg_uncertainty_echo

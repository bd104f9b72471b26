!> All that the results of a Monte Carlo depend on, in words.
module dg_uncertainty_text
   use dg_line_list, only: add_line, line_list_type
   use dg_model, only: model_type
   use dg_model_text, only: append_numbers, append_sweep, yes_or_no
   use dg_text, only: text_type, to_text
   use dg_uncertainty, only: uncertainty_type
   implicit none
   private
   public :: uncertainty_lines

contains

   !> What a Monte Carlo is. The gauges' deviations come in when all is solved and may change.
   function uncertainty_lines(model, uncertainty) result(texts)
      type(model_type), intent(in) :: model
      type(uncertainty_type), intent(in) :: uncertainty
      type(text_type), allocatable :: texts(:)
      type(line_list_type) :: lines
      integer :: i
      call append_sweep(lines, model, uncertainty%range)
      call add_line(lines, 'samples = '//to_text(uncertainty%samples))
      call add_line(lines, 'seed = '//to_text(uncertainty%seed))
      if (allocated(uncertainty%friction_factor)) then
         do i = 1, size(uncertainty%friction_factor, 1)
            call append_numbers(lines, 'friction of hole '//to_text(i), uncertainty%friction_factor(i, :i))
         end do
         call add_line(lines, 'friction axial, rotary = '//yes_or_no(uncertainty%axial)//' '//yes_or_no(uncertainty%rotary))
      end if
      call add_line(lines, 'deviation of mud density = '//to_text(uncertainty%density_deviation))
      call add_line(lines, 'deviation of inclination, rad = '//to_text(uncertainty%inclination_deviation))
      call add_line(lines, 'deviation of azimuth, rad = '//to_text(uncertainty%azimuth_deviation))
      call add_line(lines, 'systematic survey errors = '//yes_or_no(uncertainty%systematic_survey))
      allocate (texts, source=lines%lines(:lines%count))
   end function uncertainty_lines
end module dg_uncertainty_text

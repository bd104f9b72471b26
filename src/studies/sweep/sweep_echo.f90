!> Tells what a deck's sweeps ask for as the program understood it, in the deck's units.
module dg_sweep_echo
   use dg_kinds, only: wp
   use dg_job, only: model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_load_case, only: operation_name
   use dg_sweep, only: point_count, sweep_type
   use dg_text, only: joined, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: add_sweeps

   !> Significant digits of a depth.
   integer, parameter :: digits = 7

contains

   !> One line a sweep.
   pure subroutine add_sweeps(lines, sweeps, units)
      type(line_list_type), intent(inout) :: lines
      type(sweep_type), intent(in) :: sweeps(:)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: factors
      integer :: i, k
      do i = 1, size(sweeps)
         associate (sweep => sweeps(i))
            factors = ''
            do k = 1, size(sweep%frictions)
               if (sweep%frictions(k)%present) factors = factors//' '//to_text(sweep%frictions(k)%value)
               if (allocated(sweep%frictions_cased)) factors = factors//' (cased '//to_text(sweep%frictions_cased(k))//')'
            end do
            if (factors == '') factors = ' of the hole'
            call add_line(lines, 'sweep       '//sweep%name//': '//joined(model_name(sweep%models), ', ')//'; '// &
               joined(operation_name(sweep%operations), ', ')//'; friction'//factors//'; string '//sweep%string//'; '// &
               to_text(size(sweep%depths))//' depths, '//shown(sweep%depths(1))//' to '// &
               shown(sweep%depths(size(sweep%depths)))//' '//trim(units%length_label)//'; '// &
               to_text(point_count(sweep))//' points, '//to_text(size(sweep%measured))//' measured')
         end associate
      end do
   contains
      pure function shown(depth) result(text)
         real(wp), intent(in) :: depth     !< [m]
         character(:), allocatable :: text
         text = to_text(depth/units%length, digits)
      end function shown
   end subroutine add_sweeps
end module dg_sweep_echo

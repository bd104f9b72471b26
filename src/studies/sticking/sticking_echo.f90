!> Tells what a deck asks of strings that are held as the program understood it.
module dg_sticking_echo
   use dg_kinds, only: wp
   use dg_job, only: model_name
   use dg_line_list, only: add_line, line_list_type
   use dg_sticking, only: find_free_point, sticking_name, sticking_type
   use dg_text, only: joined, to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: add_stickings

   !> Significant digits of a length.
   integer, parameter :: digits = 7

contains

   !> One line a held string.
   pure subroutine add_stickings(lines, stickings, units)
      type(line_list_type), intent(inout) :: lines
      type(sticking_type), intent(in) :: stickings(:)
      type(unit_system_type), intent(in) :: units
      real(wp) :: where
      integer :: i
      do i = 1, size(stickings)
         associate (sticking => stickings(i))
            where = sticking%depth
            if (sticking%kind == find_free_point) where = sticking%stretch
            call add_line(lines, 'calibrate   '//sticking%name//': '//trim(sticking_name(sticking%kind))//', '// &
               trim(merge('stretch', 'depth  ', sticking%kind == find_free_point))//' '// &
               trim(in_units(units, unit_length, where, digits))//'; '// &
               joined(model_name(sticking%models), ', ')//'; '//to_text(size(sticking%cases))//' load cases')
         end associate
      end do
   end subroutine add_stickings
end module dg_sticking_echo

!> Hook load and torque of a string that is held at its lower end, as a function of the pull and torque there.
module dg_stuck_function
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_type
   use dg_interruption, only: by_signals
   use dg_least_squares, only: measured_function_type
   use dg_model, only: copy_without_cases, model_type
   use dg_solve_case, only: solve_case
   use dg_stuck_string, only: cut_string
   implicit none
   private
   public :: stuck_function_type, new_stuck_function, solve_held

   type, extends(measured_function_type) :: stuck_function_type
      type(model_type) :: model                !< its string ends where it is held
      integer :: number = 0                    !< of the model that solves
      character(:), allocatable :: message     !< of the last solution that was none
   contains
      procedure :: evaluate
   end type stuck_function_type

contains

   !> The string of a load case held at a depth [m].
   subroutine new_stuck_function(function, model, case_index, depth, number)
      type(stuck_function_type), intent(out) :: function
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: depth
      integer, intent(in) :: number
      call copy_without_cases(model, function%model)
      function%model%cases(1) = model%cases(case_index)
      call cut_string(function%model, depth)
      function%number = number
      function%message = ''
   end subroutine new_stuck_function

   !> Points hold the pull [N] and, where looked for, the torque [N.m] at the lower end.
   subroutine evaluate(self, points, values, solved)
      class(stuck_function_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      type(case_result_type) :: result
      integer :: p
      do p = 1, size(points, 2)
         call solve_held(self, points(:, p), result, totals_only=.true.)
         values(1, p) = result%hookload
         if (size(values, 1) > 1) values(2, p) = result%torque
         solved(:, p) = result%status == result_converged
         if (.not. solved(1, p)) self%message = result%message
      end do
   end subroutine evaluate

   !> The string with a pull and torque at its lower end.
   subroutine solve_held(function, point, result, totals_only)
      class(stuck_function_type), intent(inout) :: function
      real(wp), intent(in) :: point(:)
      type(case_result_type), intent(out) :: result
      logical, intent(in) :: totals_only
      type(error_type), allocatable :: error
      function%model%cases(1)%wob = -point(1)
      if (size(point) > 1) function%model%cases(1)%tob = point(2)
      call solve_case(function%model, function%number, 1, result, error, totals_only=totals_only, stop=by_signals())
   end subroutine solve_held
end module dg_stuck_function

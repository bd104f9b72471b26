!> Hook loads and torques of a calibration's load cases as a function of its friction factors, by any model, on all cores.
module dg_string_function
   use dg_kinds, only: wp
   use dg_calibration, only: calibration_type, hookload_datum, with_factors
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_type
   use dg_interruption, only: by_signals
   use dg_job, only: model_mcge
   use dg_least_squares, only: measured_function_type
   use dg_missing, only: missing, optional_real
   use dg_model, only: copy_without_cases, model_type
   use dg_rig, only: indicated_load
   use dg_solve_case, only: solve_case
   use dg_threads, only: thread_count
   implicit none
   private
   public :: string_function_type, new_string_function

   type, extends(measured_function_type) :: string_function_type
      type(model_type) :: model
      type(calibration_type) :: calibration
      integer :: number = 0                    !< of the model that solves
      integer :: threads = 0
      integer :: solutions = 0                 !< load cases solved so far
      character(:), allocatable :: message     !< of the last case that had no solution
      real(wp), allocatable :: known_point(:)  !< the last single point, and what it gave
      real(wp), allocatable :: known(:, :)     !< (hook load and torque, cases)
      logical, allocatable :: known_solved(:)
   contains
      procedure :: evaluate
      procedure :: as_given
   end type string_function_type

   !> Tasks that a thread must have where one takes microseconds: fewer, and the threads wait longer for each other than they work.
   integer, parameter :: least_share = 100

contains

   !> Function that a calibration fits: by its `number`-th model, on the given number of threads.
   subroutine new_string_function(function, model, calibration, number, threads)
      type(string_function_type), intent(out) :: function
      type(model_type), intent(in) :: model
      type(calibration_type), intent(in) :: calibration
      integer, intent(in) :: number, threads
      function%model = model
      function%calibration = calibration
      function%number = number
      function%threads = threads
      function%message = ''
   end subroutine new_string_function

   !> Values at several points. A case none of whose factors differs from the last single point is not solved again.
   subroutine evaluate(self, points, values, solved)
      class(string_function_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)
      real(wp), intent(out) :: values(:, :)
      logical, intent(out) :: solved(:, :)
      real(wp) :: found(2, size(self%calibration%cases), size(points, 2))
      logical :: sound(size(self%calibration%cases), size(points, 2))
      integer :: tasks(2, size(self%calibration%cases)*size(points, 2)), i, p, n
      n = 0
      do p = 1, size(points, 2)
         do i = 1, size(self%calibration%cases)
            if (is_known(self, i, points(:, p))) then
               found(:, i, p) = self%known(:, i)
               sound(i, p) = self%known_solved(i)
            else
               n = n + 1
               tasks(:, n) = [i, p]
            end if
         end do
      end do
      call solve_tasks(self, points, tasks(:, :n), found, sound)
      if (size(points, 2) == 1) then
         self%known_point = points(:, 1)
         self%known = found(:, :, 1)
         self%known_solved = sound(:, 1)
      end if
      do p = 1, size(points, 2)
         call list_data(self, points(:, p), found(:, :, p), sound(:, p), values(:, p), solved(:, p))
      end do
   end subroutine evaluate

   !> The data as the deck's own friction gives them; missing where there is no solution.
   subroutine as_given(self, values)
      class(string_function_type), intent(inout) :: self
      real(wp), intent(out) :: values(:)
      real(wp) :: found(2, size(self%calibration%cases), 1)
      logical :: sound(size(self%calibration%cases), 1), solved(size(values))
      integer :: tasks(2, size(self%calibration%cases)), i
      real(wp) :: no_points(0, 1)
      tasks(1, :) = [(i, i=1, size(sound))]
      tasks(2, :) = 1
      call solve_tasks(self, no_points, tasks, found, sound)
      call list_data(self, no_points(:, 1), found(:, :, 1), sound(:, 1), values, solved)
      where (.not. solved) values = missing
   end subroutine as_given

   !> True if a case has all factors of the last single point.
   pure function is_known(self, place, point) result(yes)
      class(string_function_type), intent(in) :: self
      integer, intent(in) :: place
      real(wp), intent(in) :: point(:)
      logical :: yes
      integer :: j, unknown
      yes = allocated(self%known_point)
      if (.not. yes) return
      do j = 1, size(self%calibration%holes)
         unknown = self%calibration%unknown_of(place, j)
         if (unknown > 0) yes = yes .and. abs(point(unknown) - self%known_point(unknown)) <= 0.0_wp
      end do
   end function is_known

   !> Solves cases at points, as many at a time as allowed. Results do not depend on the number of threads.
   subroutine solve_tasks(self, points, tasks, found, sound)
      class(string_function_type), intent(inout) :: self
      real(wp), intent(in) :: points(:, :)        !< no rows: as the deck has it
      integer, intent(in) :: tasks(:, :)          !< place of the case, number of the point
      real(wp), intent(inout) :: found(:, :, :)
      logical, intent(inout) :: sound(:, :)
      integer :: shares
      shares = size(tasks, 2)
      if (self%number /= model_mcge) shares = shares/least_share
      !$omp parallel num_threads(thread_count(self%threads, shares)) default(shared)
      call share_tasks()
      !$omp end parallel
      self%solutions = self%solutions + size(tasks, 2)
   contains
      !> Work of one thread, with a model of its own.
      subroutine share_tasks()
         type(model_type) :: mine
         type(case_result_type) :: result
         type(error_type), allocatable :: error
         integer :: k
         call copy_without_cases(self%model, mine)
         !$omp do schedule(dynamic, 1)
         do k = 1, size(tasks, 2)
            associate (i => tasks(1, k), p => tasks(2, k))
               mine%cases(1) = self%model%cases(self%calibration%cases(i))
               if (size(points, 1) > 0) then
                  mine%holes = with_factors(self%calibration, self%model%holes, mine%cases(1), i, points(:, p))
                  mine%cases(1)%friction_axial = optional_real()
                  mine%cases(1)%friction_rotary = optional_real()
               end if
               call solve_case(mine, self%number, 1, result, error, totals_only=.true., stop=by_signals())
               found(:, i, p) = [result%hookload, result%torque]
               sound(i, p) = result%status == result_converged
               if (.not. sound(i, p)) then
                  !$omp critical (calibration_message)
                  self%message = result%message
                  !$omp end critical (calibration_message)
               end if
            end associate
         end do
         !$omp end do
      end subroutine share_tasks
   end subroutine solve_tasks

   !> List hook loads, as the indicator of the rig shows them, and torques of cases in the order of the data.
   pure subroutine list_data(self, point, found, sound, values, solved)
      class(string_function_type), intent(in) :: self
      real(wp), intent(in) :: point(:)            !< empty: as the deck has it
      real(wp), intent(in) :: found(:, :)
      logical, intent(in) :: sound(:)
      real(wp), intent(out) :: values(:)
      logical, intent(out) :: solved(:)
      integer :: d, offset
      do d = 1, size(values)
         associate (datum => self%calibration%data(d))
            values(d) = found(merge(1, 2, datum%kind == hookload_datum), datum%case)
            solved(d) = sound(datum%case)
            if (datum%kind /= hookload_datum) cycle
            offset = self%calibration%offset_of(datum%case)
            if (size(point) > 0 .and. offset > 0) values(d) = values(d) + point(offset)
            values(d) = indicated_load(self%model%rig, self%model%cases(self%calibration%cases(datum%case))%operation, values(d))
         end associate
      end do
   end subroutine list_data
end module dg_string_function

!> drillgap for other programs: `use drillgap` is all that they name.
!>
!> A program fills in `model_parts_type`, in SI units, by hand or by add_hole, add_component and add_fluid. new_model checks
!> all of it and makes a model. Only new_model and read_deck make models. solve and solve_cases solve load cases of a model by
!> any method: 'mcge', 'soft', 'rigid', 'mixed'. Invalid data give an error. A case without equilibrium is a result with that
!> status. No procedure stops the program, prints, or keeps data between calls.
!>
!> Threads of OpenMP may call solve at the same time, with one model or several: a model is only read. A program that does so
!> must itself be built with OpenMP (`openmp = "*"` in its fpm.toml), so that this library is, too.
module drillgap
   use dg_case_memory, only: check_case_memory
   use dg_case_result, only: case_result_type, contact_point_type, gap_row_type, iteration_type, result_converged, &
      result_locked_up, result_not_converged, result_status_name
   use dg_centralizer, only: centralizer_type
   use dg_checked_model, only: build_checked_model, check_load_case
   use dg_component, only: component_type
   use dg_connection_rating, only: connection_rating_type
   use dg_constants, only: degree, pi
   use dg_drillstring, only: drillstring_type
   use dg_error, only: error_list_type, error_type, joined_errors, raise, status_bad_input, status_failure
   use dg_fatigue_curve, only: fatigue_curve_type, fatigue_e75, fatigue_none, fatigue_own, fatigue_s135
   use dg_fluid, only: collar_closed, collar_none, collar_open_below, fluid_type
   use dg_hole_section, only: hole_section_type
   use dg_job, only: job_type, model_count, model_name
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_backream, operation_from_name, operation_name, operation_ream, &
      operation_rotary_drilling, operation_rotate_off_bottom, operation_sliding_drilling, operation_static, &
      operation_trip_in, operation_trip_out
   use dg_missing, only: given, is_missing, missing, optional_real
   use dg_model, only: boundary_type, copy_without_cases, inner_type => model_type
   use dg_model_parts, only: model_parts_type, survey_type
   use dg_numerics, only: gap_at_extremum, gap_at_nodes, numerics_type, settings_of
   use dg_parts_by_call, only: add_component, add_fluid, add_hole
   use dg_process_memory, only: address_room, memory_of_machine
   use dg_profile, only: profile_type, side_above, side_below, side_none, state_elastic, state_free, state_rigid
   use dg_read_deck, only: read_checked_deck => read_deck
   use dg_rig, only: rig_type
   use dg_solve_case, only: solve_case
   use dg_text, only: lower_case, quoted
   use dg_threads, only: thread_count
   use dg_trajectory, only: interpolation_minimum_curvature, interpolation_spline
   implicit none
   private
   ! Names that stay (README.md beside this file; .ci/check_library.py compares).
   public :: wp, pi, degree, missing, is_missing, optional_real, given
   public :: error_type, status_bad_input, status_failure
   public :: model_parts_type, survey_type, interpolation_minimum_curvature, interpolation_spline
   public :: hole_section_type, drillstring_type, component_type, centralizer_type, fluid_type
   public :: connection_rating_type
   public :: fatigue_curve_type, fatigue_none, fatigue_e75, fatigue_s135, fatigue_own
   public :: collar_none, collar_closed, collar_open_below, boundary_type, rig_type
   public :: numerics_type, settings_of, gap_at_extremum, gap_at_nodes
   public :: add_hole, add_component, add_fluid
   public :: model_type, new_model, deck_type, read_deck
   public :: load_case_type, operation_name, operation_from_name
   public :: operation_trip_out, operation_trip_in, operation_rotate_off_bottom, operation_rotary_drilling
   public :: operation_sliding_drilling, operation_ream, operation_backream, operation_static
   public :: solve, solve_cases, outcome_type, method_name
   public :: case_result_type, profile_type, gap_row_type, contact_point_type, iteration_type
   public :: result_converged, result_not_converged, result_locked_up, result_status_name
   public :: state_free, state_elastic, state_rigid, side_none, side_above, side_below

   !> Names of the methods: nonlinear beams with contact gap elements, soft string, stiff string on the hole axis, stiff where
   !> stiffness matters.
   character(*), parameter :: method_name(model_count) = model_name

   !> A model that has been checked.
   type :: model_type
      private
      logical :: made = .false.
      type(inner_type) :: inner
   end type model_type

   !> Content of a deck: model, load cases, methods and notes.
   type :: deck_type
      type(model_type) :: model
      type(load_case_type), allocatable :: cases(:)
      character(len(method_name)), allocatable :: methods(:)  !< by which it wants them solved
      character(:), allocatable :: notes                      !< what is legal but hardly meant, one line each; '': nothing
   end type deck_type

   !> A result, or why there is none.
   type :: outcome_type
      type(case_result_type) :: result
      type(error_type), allocatable :: error
   end type outcome_type

contains

   !> Makes a model of parts. Error (status_bad_input): its message has one line for each thing that is wrong, with the component
   !> of `parts` that it is in. Then no model is made. Example: README.md beside this file.
   subroutine new_model(model, parts, error)
      type(model_type), intent(out) :: model
      type(model_parts_type), intent(in) :: parts
      type(error_type), allocatable, intent(out) :: error
      !$omp critical (drillgap_words)
      call build_checked_model(parts, model%inner, error)
      !$omp end critical (drillgap_words)
      model%made = .not. allocated(error)
   end subroutine new_model

   !> Reads a deck with the files that it names. Error (status_bad_input): one line for each fault, with file and line. Load cases
   !> and methods are taken; what else the deck asks for (sweeps, calibrations, ...) is the program's. Example: README.md
   !> beside this file.
   subroutine read_deck(path, deck, error)
      character(*), intent(in) :: path
      type(deck_type), intent(out) :: deck
      type(error_type), allocatable, intent(out) :: error
      type(job_type) :: job
      type(error_list_type) :: faults
      integer :: i
      !$omp critical (drillgap_words)
      call read_checked_deck(path, deck%model%inner, job, faults)
      deck%notes = ''
      if (faults%count > 0) then
         call raise(error, status_bad_input, joined_errors(faults))
      else
         do i = 1, size(job%notes)
            if (i > 1) deck%notes = deck%notes//new_line('a')
            deck%notes = deck%notes//job%notes(i)%text
         end do
         deck%cases = deck%model%inner%cases
         deck%methods = method_name(job%models)
         deck%model%made = .true.
      end if
      !$omp end critical (drillgap_words)
   end subroutine read_deck

   !> Solve one load case. The error is status_bad_input if the model was not made, the method is unknown, the load case is
   !> invalid, or memory is too small. It is status_failure for anything else. Without an error `result%status` says if the
   !> numbers are valid. Example: the first program there.
   subroutine solve(model, load_case, method, result, error, totals_only)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      character(*), intent(in) :: method               !< one of method_name
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      logical, intent(in), optional :: totals_only     !< .true.: hook load, torque and the like, no profile where that saves time
      type(inner_type) :: one
      integer :: number
      number = findloc(method_name == lower_case(method), .true., dim=1)
      if (.not. model%made) then
         call raise(error, status_bad_input, 'the model was not made; call new_model or read_deck, and look at its error')
      else if (number == 0) then
         call raise(error, status_bad_input, 'no method '//quoted(method)//"; there are 'mcge', 'soft', 'rigid', 'mixed'")
      else
         call copy_without_cases(model%inner, one)
         one%cases(1) = load_case
         ! words of faults are made by one thread at a time: see to_text in dg_text
         !$omp critical (drillgap_words)
         call check_load_case(one, one%cases(1), error)
         if (.not. allocated(error)) call check_case_memory(one, room, error)
         !$omp end critical (drillgap_words)
         if (.not. allocated(error)) call solve_case(one, number, 1, result, error, totals_only)
      end if
      if (.not. allocated(error)) return
      result%status = result_not_converged
      result%message = error%message
   end subroutine solve

   !> Memory that is there [bytes].
   function room() result(bytes)
      real(wp) :: bytes
      bytes = min(memory_of_machine(), address_room())
   end function room

   !> Solves load cases, as many at a time as there are threads. One that is refused does not keep the others from being solved.
   !> Example: the second program there.
   subroutine solve_cases(model, load_cases, method, outcomes, totals_only, threads)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_cases(:)
      character(*), intent(in) :: method
      type(outcome_type), allocatable, intent(out) :: outcomes(:)   !< one a load case
      logical, intent(in), optional :: totals_only
      integer, intent(in), optional :: threads         !< absent or 0: all cores, or what OMP_NUM_THREADS says
      integer :: i, wanted
      wanted = 0
      if (present(threads)) wanted = threads
      allocate (outcomes(size(load_cases)))
      !$omp parallel do schedule(dynamic, 1) num_threads(thread_count(wanted, size(load_cases)))
      do i = 1, size(load_cases)
         call solve(model, load_cases(i), method, outcomes(i)%result, outcomes(i)%error, totals_only)
         outcomes(i)%result%case_index = i
      end do
      !$omp end parallel do
   end subroutine solve_cases
end module drillgap

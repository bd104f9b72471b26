!> A study of numbered points, solved in parts where asked for, from where an interrupted run stopped: sweep, Monte Carlo.
module dg_ensemble_study
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_memory, only: elements_in, finer_text, need_type, keep_larger
   use dg_case_result, only: result_not_converged
   use dg_clock, only: seconds_between
   use dg_diagnostic, only: report_line
   use dg_ensemble_record, only: close_record, ensemble_title, ensemble_type, failed_text, open_record, taken_text, join_parts, &
      write_record
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_type, raise, status_failure, status_not_converged
   use dg_exit_status, only: graver, note_ending, note_failure
   use dg_interruption, only: interruption_name, is_interrupted
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_model_text, only: sweep_lines
   use dg_printed_text, only: print_and_keep, print_line
   use dg_progress, only: end_progress, progress_type, start_progress
   use dg_readable, only: capital
   use dg_result_name, only: failed_file, points_file, record_file
   use dg_study, only: phase_points, run_type, study_type
   use dg_sweep, only: point_count, sweep_type
   use dg_sweep_points, only: point_text
   use dg_sweep_result, only: is_solved
   use dg_sweep_work, only: in_part
   use dg_text, only: append_text, quoted, text_list, text_or_nothing, text_type, to_text
   use dg_threads, only: thread_count
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: ensemble_study_type, name_ranges, prepare_ensembles
   public :: range_text_type

   !> Names of a kind of study.
   type :: range_text_type
      character(:), allocatable :: what            !< sweep or uncertainty, in messages and names of files
      character(:), allocatable :: points          !< its points, and those that are solved
      character(:), allocatable :: points_solved
      character(:), allocatable :: left_out        !< treatment of those that did not converge; '': none
      character(:), allocatable :: fewer           !< advice for fewer of them
   end type range_text_type

   type, abstract, extends(study_type) :: ensemble_study_type
      type(range_text_type) :: texts                      !< what it is called
      type(sweep_type), allocatable :: ranges(:)          !< ranges of depths, as many as the deck has groups
      integer, allocatable :: samples(:)                  !< solutions of each point of a range; 1: nothing is drawn
      type(ensemble_type), allocatable :: ensembles(:)    !< as many
   contains
      procedure(solve_interface), deferred :: solve
      procedure(report_interface), deferred :: report
      procedure :: settings
      procedure :: run => run_ensembles
      procedure :: name_records
      procedure :: add_need
      procedure :: prepare => prepare_ensembles
      procedure :: finish => close_records
   end type ensemble_study_type

   abstract interface
      !> Solves the points that are left.
      subroutine solve_interface(self, number, run, watch)
         import :: ensemble_study_type, run_type, ensemble_watch_type
         implicit none
         class(ensemble_study_type), intent(inout) :: self
         integer, intent(in) :: number
         type(run_type), intent(in) :: run
         class(ensemble_watch_type), intent(inout) :: watch
      end subroutine solve_interface

      !> Report the points: write the file, return lines for the terminal.
      subroutine report_interface(self, number, run, lines, error)
         import :: ensemble_study_type, run_type, text_type, error_type
         implicit none
         class(ensemble_study_type), intent(inout) :: self
         integer, intent(in) :: number
         type(run_type), intent(inout) :: run
         type(text_type), allocatable, intent(out) :: lines(:)
         type(error_type), allocatable, intent(out) :: error
      end subroutine report_interface
   end interface

   !> Memory of a point, with its line in a record [bytes].
   real(wp), parameter :: bytes_of_point = 250.0_wp

contains

   !> Names what it is called and, once its ranges are read, its files. They run after all other studies.
   subroutine name_ranges(self, texts, samples)
      class(ensemble_study_type), intent(inout) :: self
      type(range_text_type), intent(in) :: texts
      integer, intent(in) :: samples(:)            !< of a point of each range
      integer :: i
      self%texts = texts
      self%samples = samples
      self%asked = size(self%ranges) > 0
      self%phase = phase_points
      self%record_kind = texts%what
      self%forms = text_list(points_file(texts%what, '*'))
      allocate (self%files(0))
      do i = 1, size(self%ranges)
         call append_text(self%files, points_file(texts%what, text_or_nothing(self%ranges(i)%name)))
      end do
   end subroutine name_ranges

   !> Solutions of a range.
   pure function piece_count(self, number) result(pieces)
      class(ensemble_study_type), intent(in) :: self
      integer, intent(in) :: number
      integer :: pieces
      pieces = point_count(self%ranges(number))*self%samples(number)
   end function piece_count

   !> All that the results of a range depend on.
   function settings(self, number, model) result(lines)
      class(ensemble_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(model_type), intent(in) :: model
      type(text_type), allocatable :: lines(:)
      allocate (lines, source=sweep_lines(model, self%ranges(number)))
   end function settings

   !> Find the results of earlier runs: records of interrupted ones, or all parts if they are to be joined, with their faults.
   !> An error (bad input) if a record does not fit the deck.
   subroutine prepare_ensembles(self, run, error)
      class(ensemble_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      if (allocated(self%ensembles)) deallocate (self%ensembles)
      allocate (self%ensembles(size(self%ranges)))
      do i = 1, size(self%ensembles)
         associate (ensemble => self%ensembles(i))
            ensemble%what = self%texts%what
            ensemble%name = self%ranges(i)%name
            allocate (ensemble%settings, source=self%settings(i, run%model))
            allocate (ensemble%points(piece_count(self, i)))
            if (run%job%merge > 0) then
               call join_parts(run%job, ensemble, run%part_faults)
            else
               call open_record(run%job, ensemble, error)
            end if
         end associate
         if (allocated(error)) return
      end do
   end subroutine prepare_ensembles

   !> One after the other.
   subroutine run_ensembles(self, run, error)
      class(ensemble_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: failure
      integer :: i
      do i = 1, size(self%ensembles)
         if (is_interrupted()) then
            call note_ending(ensemble_title(self%ensembles(i)), run%status)
            exit
         end if
         call run_one(self, i, run, failure)
         run%written = run%written .and. .not. allocated(failure)
         call note_failure(failure, run%status)
         if (any(self%ensembles(i)%points%status == result_not_converged)) &
            run%status = graver(run%status, status_not_converged)
      end do
      do i = 1, size(self%ensembles)
         run%points_lost = run%points_lost .or. any(self%ensembles(i)%points%status == result_not_converged)
      end do
      if (allocated(error)) return
   end subroutine run_ensembles

   !> Solve the rest of one, write and print it.
   subroutine run_one(self, number, run, error)
      class(ensemble_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(inout) :: run
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: resumed
      real(wp) :: seconds
      associate (job => run%job)
         resumed = count(is_solved(self%ensembles(number)%points))
         seconds = 0.0_wp
         if (job%merge == 0) call solve_rest(self, number, run, seconds)
         if (any(self%ensembles(number)%points%status == result_not_converged)) call report_lost(self, number, job%units)
         if (.not. is_interrupted()) call report_text(failed_text(self%ensembles(number), max(job%parts, job%merge)))
         if (job%merge == 0 .and. (is_interrupted() .or. job%parts > 0)) then
            call keep_for_later(self%ensembles(number), self%texts, job, error)
            return
         end if
         call self%report(number, run, lines, error)
         if (allocated(error)) return
         associate (points => self%ensembles(number)%points)
            if (any(points%earlier)) call append_text(lines, to_text(count(points%earlier))//' of '//to_text(size(points))//' '// &
               self%texts%points//' were found with other settings of the solver, by a run before --again')
            call print_and_keep(run%printed, lines)
            if (job%merge > 0) then
               call print_line(to_text(size(points))//' '//self%texts%points//', joined from '//to_text(job%merge)//' parts')
            else
               call print_line(to_text(size(points) - resumed)//' '//self%texts%points_solved//' in '//to_text(seconds, 3)//' s')
            end if
         end associate
      end associate
   end subroutine run_one

   !> Writes the record of what is not finished, or of a part.
   subroutine keep_for_later(ensemble, texts, job, error)
      type(ensemble_type), intent(inout) :: ensemble
      type(range_text_type), intent(in) :: texts
      type(job_type), intent(in) :: job
      type(error_type), allocatable, intent(out) :: error
      call write_record(ensemble, error)
      if (allocated(error)) return
      if (is_interrupted()) then
         call raise(error, status_failure, ensemble_title(ensemble)//': ended by '//interruption_name()//' with '// &
                    solved_of_all(ensemble)//' '//texts%points_solved//'; the same command goes on from there ('// &
                    ensemble%path//')')
      else
         call print_line(capital(ensemble%what)//' '//ensemble%name//', part '//to_text(job%part)//' of '// &
                         to_text(job%parts)//': '//solved_of_all(ensemble)//' '//texts%points//', in '//ensemble%path)
      end if
   end subroutine keep_for_later

   !> Solves the points that have no result yet, with their progress on the terminal.
   subroutine solve_rest(self, number, run, seconds)
      class(ensemble_study_type), intent(inout) :: self
      integer, intent(in) :: number
      type(run_type), intent(in) :: run
      real(wp), intent(out) :: seconds
      type(progress_type) :: progress
      integer(int64) :: start, finish
      integer :: i, left
      call report_text(taken_text(self%ensembles(number), run%job%again))
      call system_clock(start)
      associate (points => self%ensembles(number)%points)
         left = count(.not. is_solved(points) .and. in_part([(i, i=1, size(points))], run%job%part, max(run%job%parts, 1)))
      end associate
      call start_progress(progress, ensemble_title(self%ensembles(number)), to_text(left)//' solutions', run%job%quiet)
      call self%solve(number, run, progress)
      call end_progress(progress)
      if (allocated(self%ensembles(number)%failure)) call report_line(self%ensembles(number)%failure%message)
      call system_clock(finish)
      seconds = seconds_between(start, finish)
   end subroutine solve_rest

   !> Close records of finished work. They stay if points of any of the run did not converge. A file that cannot be written is
   !> reported, and raises the exit status.
   subroutine close_records(self, run)
      class(ensemble_study_type), intent(inout) :: self
      type(run_type), intent(inout) :: run
      type(error_type), allocatable :: error
      integer :: i
      if (.not. run%written .or. max(run%job%parts, run%job%merge) > 0) return
      do i = 1, size(self%ensembles)
         call close_record(self%ensembles(i), run%points_lost, error)
         call note_failure(error, run%status)
      end do
   end subroutine close_records

   !> Report the number of points without solution, and the first of them with its reason, so that it can be examined.
   subroutine report_lost(self, number, units)
      class(ensemble_study_type), intent(in) :: self
      integer, intent(in) :: number
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      integer :: first
      associate (points => self%ensembles(number)%points, samples => self%samples(number))
         first = findloc(points%status, result_not_converged, dim=1)
         text = ensemble_title(self%ensembles(number))//': '//to_text(count(points%status == result_not_converged))//' of '// &
                to_text(count(is_solved(points)))//' '//self%texts%points//' did not converge'// &
                self%texts%left_out//'; the first: '//point_text(units, self%ranges(number), (first - 1)/samples + 1)
         if (samples > 1) text = text//', sample '//to_text(modulo(first - 1, samples) + 1)
         if (allocated(points(first)%message)) text = text//': '//points(first)%message
      end associate
      call report_line(text)
   end subroutine report_lost

   !> A record each, and of an undivided run one of points that did not converge.
   subroutine name_records(self, job, names)
      class(ensemble_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(inout) :: names(:)
      integer :: i
      if (job%merge > 0) return
      do i = 1, size(self%ranges)
         call append_text(names, record_file(self%texts%what, self%ranges(i)%name, job%part, job%parts))
         if (job%parts == 0) call append_text(names, failed_file(self%texts%what, self%ranges(i)%name))
      end do
   end subroutine name_records

   !> Memory at the greatest depth, and of all points.
   subroutine add_need(self, job, model, need)
      class(ensemble_study_type), intent(in) :: self
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(need_type), intent(inout) :: need
      real(wp) :: elements
      integer :: i
      do i = 1, size(self%ranges)
         elements = 0.0_wp
         associate (range => self%ranges(i))
            if (job%merge == 0) elements = elements_in(model, range%string, maxval(range%depths), model%numerics%element_length)
            need%kept = need%kept + bytes_of_point*piece_count(self, i)
            call keep_larger(need, elements, thread_count(job%threads, piece_count(self, i)), &
                             self%texts%what//' '//quoted(range%name)//', '//to_text(piece_count(self, i))//' solutions', &
                             self%texts%fewer//', '//finer_text(model, model%numerics%element_length))
         end associate
      end do
   end subroutine add_need

   subroutine report_text(text)
      character(*), intent(in) :: text
      if (text /= '') call report_line(text)
   end subroutine report_text

   !> Number of points that have their result: 3 of 5.
   pure function solved_of_all(ensemble) result(text)
      type(ensemble_type), intent(in) :: ensemble
      character(:), allocatable :: text
      text = to_text(count(is_solved(ensemble%points)))//' of '//to_text(size(ensemble%points))
   end function solved_of_all
end module dg_ensemble_study

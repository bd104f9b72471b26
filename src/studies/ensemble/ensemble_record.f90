!> An ensemble: the points of a sweep, or of a Monte Carlo with its samples. Its files keep solved points, so that an
!> interrupted run can be continued and parts can be joined. They are sweep_<name>.partial, or sweep_<name>.part_<i>_of_<n> for
!> one part of a divided run. If points of an undivided run did not converge, sweep_<name>.failed keeps all of them, so that
!> these can be solved again.
module dg_ensemble_record
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_result, only: result_not_converged
   use dg_clock, only: seconds_between
   use dg_error, only: error_type, raise, status_bad_input, status_failure
   use dg_file_lines, only: read_lines
   use dg_file_system, only: append_lines, delete_file, write_text_file
   use dg_job, only: job_type
   use dg_part_list, only: part_list_text
   use dg_part_faults, only: note_part, part_broken, part_faults_type, part_missing, part_unfinished, part_whole
   use dg_result_name, only: failed_file, record_file
   use dg_sweep_result, only: is_solved, sweep_result_type, unsolved
   use dg_sweep_work, only: result_text, add_record
   use dg_task_record, only: read_record, record_head, record_line, record_type
   use dg_text, only: quoted, text_type, to_text
   implicit none
   private
   public :: ensemble_type, ensemble_title, open_record, join_parts, keep, write_record, close_record
   public :: taken_text, failed_text

   !> A sweep or Monte Carlo of a job, with its results as far as they are there, and where they are kept.
   type :: ensemble_type
      character(:), allocatable :: what         !< sweep or uncertainty
      character(:), allocatable :: name         !< of it
      type(sweep_result_type), allocatable :: points(:)   !< of a Monte Carlo one a point and sample
      type(text_type), allocatable :: settings(:)         !< what the results depend on
      ! its record
      character(:), allocatable :: path
      character(:), allocatable :: failed       !< path of the record that stays where points did not converge; '': `path` stays
      character(:), allocatable :: source       !< file whose points were taken over
      integer :: to_repeat = 0                  !< points of that file that did not converge, and are solved again
      integer :: part = 1, parts = 1
      integer, allocatable :: waiting(:)        !< numbers of points that are solved and not yet on disk
      integer :: count = 0                      !< of these
      integer(int64) :: last = 0                !< when something was written [ticks]
      logical :: there = .false.                !< the file is there
      type(error_type), allocatable :: failure  !< why nothing can be written any more
   end type ensemble_type

   !> Results are written no later than this after they came [s]. A short sweep needs no record.
   real(wp), parameter :: patience = 0.1_wp

contains

   !> Name of an ensemble in messages: sweep 'a'.
   pure function ensemble_title(ensemble) result(title)
      type(ensemble_type), intent(in) :: ensemble
      character(:), allocatable :: title
      title = ensemble%what//' '//quoted(ensemble%name)
   end function ensemble_title

   !> Path of the record of a part, or of an undivided run (`parts` = 0).
   pure function record_path(job, ensemble, part, parts) result(path)
      type(job_type), intent(in) :: job
      type(ensemble_type), intent(in) :: ensemble
      integer, intent(in) :: part, parts
      character(:), allocatable :: path
      path = job%output_dir//'/'//record_file(ensemble%what, ensemble%name, part, parts)
   end function record_path

   !> Begin to keep the results of a run. Results of a record of an interrupted run are taken over. A record of other work is
   !> refused (bad input). With --again, results of a finished run are also taken over, except points that did not converge.
   subroutine open_record(job, ensemble, error)
      type(job_type), intent(in) :: job
      type(ensemble_type), intent(inout) :: ensemble   !< points that are not solved, and settings
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: failure
      logical :: there, goes_back(size(ensemble%points))
      ensemble%path = record_path(job, ensemble, job%part, job%parts)
      ensemble%failed = ''
      if (job%parts == 0) ensemble%failed = job%output_dir//'/'//failed_file(ensemble%what, ensemble%name)
      ensemble%part = job%part
      ensemble%parts = max(job%parts, 1)
      allocate (ensemble%waiting(size(ensemble%points)))
      call system_clock(ensemble%last)
      inquire (file=ensemble%path, exist=ensemble%there)
      ensemble%source = ensemble%path
      there = ensemble%there
      if (.not. there .and. job%again .and. job%parts == 0) then
         ensemble%source = ensemble%failed
         inquire (file=ensemble%source, exist=there)
      end if
      if (.not. there) return
      call read_results(job, ensemble%source, [ensemble%part, ensemble%parts], ensemble, failure)
      if (failure /= '') then
         call raise(error, status_bad_input, ensemble%what//' '//ensemble%name//': cannot go on with '//ensemble%source// &
                    ': '//failure//'; restore the deck, or remove that file to begin anew')
         return
      end if
      goes_back = ensemble%points%earlier .and. ensemble%points%status == result_not_converged
      ensemble%to_repeat = count(goes_back)
      where (goes_back)
         ensemble%points%status = unsolved
         ensemble%points%earlier = .false.
      end where
      call write_record(ensemble, error)   ! without a line that was cut short
   end subroutine open_record

   !> Joins the results of all parts. Those that are missing, broken, of another deck or not finished are noted.
   subroutine join_parts(job, ensemble, faults)
      type(job_type), intent(in) :: job
      type(ensemble_type), intent(inout) :: ensemble   !< points that are not solved, and settings
      type(part_faults_type), intent(inout) :: faults
      character(:), allocatable :: path, failure
      integer :: part, missing, state
      logical :: there
      do part = 1, job%merge
         path = record_path(job, ensemble, part, job%merge)
         inquire (file=path, exist=there)
         failure = 'it is missing'
         state = part_missing
         if (there) then
            call read_results(job, path, [part, job%merge], ensemble, failure)
            missing = count(.not. is_solved(ensemble%points(part::job%merge)))
            state = part_whole
            if (failure /= '') then
               state = part_broken
            else if (missing > 0) then
               state = part_unfinished
               failure = 'it lacks '//to_text(missing)//' of its points'
            end if
         end if
         call note_part(faults, part, state, path, failure)
      end do
   end subroutine join_parts

   !> Read the results of one file.
   subroutine read_results(job, path, part, ensemble, failure)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: path
      integer, intent(in) :: part(2)                   !< its number, and of how many
      type(ensemble_type), intent(inout) :: ensemble
      character(:), allocatable, intent(out) :: failure
      type(text_type), allocatable :: lines(:)
      type(record_type) :: record
      allocate (lines(0))   ! the compiler's flow analysis takes it for undefined otherwise
      call read_lines(path, lines, failure)
      if (failure /= '') return
      call read_record(lines, record, failure)
      if (failure /= '') return
      call add_record(record, part(1), part(2), ensemble%settings, ensemble%points, failure, job%units, job%again)
   end subroutine read_results

   !> Which results of earlier runs are taken over, and which of them are solved again, before anything is solved; '' for none.
   pure function taken_text(ensemble, again) result(text)
      type(ensemble_type), intent(in) :: ensemble
      logical, intent(in) :: again                     !< asked for
      character(:), allocatable :: text
      integer :: taken, lost
      text = ''
      taken = count(is_solved(ensemble%points))
      lost = count(ensemble%points%status == result_not_converged)
      if (taken + ensemble%to_repeat == 0) then
         if (again) text = ensemble_title(ensemble)//': there are no earlier results; all points are solved'
         return
      end if
      text = ensemble_title(ensemble)//': '//to_text(taken)//' points were solved before, in '//ensemble%source
      if (ensemble%to_repeat > 0) then
         text = text//'; '//to_text(ensemble%to_repeat)//' that did not converge are solved again'
      else if (again .and. lost > 0) then
         text = text//'; '//to_text(lost)//' of them did not converge with the same settings of the solver: change these'
      else if (again) then
         text = text//'; all of them converged or locked up, so none is solved again'
      end if
   end function taken_text

   !> Advice on how to solve points again that did not converge; '' where all did.
   pure function failed_text(ensemble, parts) result(text)
      type(ensemble_type), intent(in) :: ensemble
      integer, intent(in) :: parts                     !< of the run; 0: undivided
      character(:), allocatable :: text
      integer :: i, n
      text = ''
      n = count(ensemble%points%status == result_not_converged)
      if (n == 0) return
      text = ensemble_title(ensemble)//': change settings of the solver and give --again to solve '//to_text(n)//' points once more'
      if (parts > 0) text = text//'; they are in --part '//part_list_text(pack([(i, i=1, parts)], &
         [(any(ensemble%points(i::parts)%status == result_not_converged), i=1, parts)]))//'/'//to_text(parts)
   end function failed_text

   !> Note that a point is solved, and write waiting points after some time. A file that cannot be written is noted in the
   !> ensemble, and the work goes on without it.
   subroutine keep(ensemble, number)
      type(ensemble_type), intent(inout) :: ensemble
      integer, intent(in) :: number                       !< of a point that is solved now
      type(error_type), allocatable :: error
      integer(int64) :: now
      if (allocated(ensemble%failure)) return
      ensemble%count = ensemble%count + 1
      ensemble%waiting(ensemble%count) = number
      call system_clock(now)
      if (seconds_between(ensemble%last, now) < patience) return
      ensemble%last = now
      if (ensemble%there) then
         call append_waiting(ensemble, error)
      else
         call write_record(ensemble, error)
      end if
      if (allocated(error)) call move_alloc(error, ensemble%failure)
   end subroutine keep

   !> Close the record. That of an undivided run is removed, unless points of its deck did not converge. Then it stays under
   !> another name, so that these can be solved again.
   subroutine close_record(ensemble, lost, error)
      type(ensemble_type), intent(inout) :: ensemble
      logical, intent(in) :: lost                         !< points of the deck did not converge, here or elsewhere
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: partial
      logical :: there
      partial = ensemble%path
      if (lost) then
         ensemble%path = ensemble%failed
         call write_record(ensemble, error)
         if (allocated(error)) return
      else
         inquire (file=ensemble%failed, exist=there)
         if (there) call delete_file(ensemble%failed)
      end if
      inquire (file=partial, exist=there)
      if (there) call delete_file(partial)
   end subroutine close_record

   !> Writes the whole record with all points that are solved.
   subroutine write_record(ensemble, error)
      type(ensemble_type), intent(inout) :: ensemble
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: i, head
      associate (top => record_head(ensemble%part, ensemble%parts, size(ensemble%points), ensemble%settings))
         head = size(top)
         allocate (lines(head + count(is_solved(ensemble%points))))
         do i = 1, head
            lines(i)%text = top(i)%text
         end do
      end associate
      do i = 1, size(ensemble%points)
         if (.not. is_solved(ensemble%points(i))) cycle
         head = head + 1
         lines(head)%text = record_line(i, result_text(ensemble%points(i)))
      end do
      call write_text_file(ensemble%path, lines, error)
      ensemble%there = .not. allocated(error)
      ensemble%count = 0
   end subroutine write_record

   !> Append the waiting points at the end of the record.
   subroutine append_waiting(ensemble, error)
      type(ensemble_type), intent(inout) :: ensemble
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: lines(ensemble%count)
      character(:), allocatable :: failure
      integer :: i
      do i = 1, size(lines)
         lines(i)%text = record_line(ensemble%waiting(i), result_text(ensemble%points(ensemble%waiting(i))))
      end do
      call append_lines(ensemble%path, lines, failure)
      if (failure /= '') call raise(error, status_failure, 'cannot write '//ensemble%path//': '//failure// &
                                    '; an interruption would lose what is solved')
      ensemble%count = 0
   end subroutine append_waiting
end module dg_ensemble_record

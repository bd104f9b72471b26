!> Files in which a sweep keeps what is solved, so that an interrupted run goes on where it stopped and parts can be joined:
!> sweep_<name>.partial, or sweep_<name>.part_<i>_of_<n> for one part of a divided run. Where points of an undivided run did not
!> converge, sweep_<name>.failed keeps all of them, so that these can be solved again.
module dg_sweep_record
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_result, only: result_not_converged
   use dg_diagnostic, only: tell
   use dg_error, only: error_type, raise, status_bad_input, status_failure
   use dg_file_lines, only: read_lines
   use dg_file_system, only: delete_file, write_text_file
   use dg_job, only: job_type
   use dg_part_list, only: part_list_text
   use dg_part_faults, only: note_part, part_broken, part_faults_type, part_missing, part_unfinished, part_whole
   use dg_progress, only: seconds_between
   use dg_result_name, only: failed_file, record_file
   use dg_sweep_result, only: is_solved, sweep_result_type, unsolved
   use dg_sweep_work, only: result_text, take_record
   use dg_system_reason, only: reason_of_failed_write
   use dg_task_record, only: read_record, record_head, record_line, record_type
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: keeper_type, record_path, open_record, take_parts, keep, write_record, close_record, tell_taken, tell_failed

   !> Keeps results while they come.
   type :: keeper_type
      character(:), allocatable :: path
      character(:), allocatable :: failed       !< path of the record that stays where points did not converge; '': `path` stays
      character(:), allocatable :: source       !< file whose points were taken over
      integer :: put_back = 0                   !< points of that file that did not converge, and are solved again
      integer :: part = 1, parts = 1
      type(text_type), allocatable :: settings(:)
      integer, allocatable :: waiting(:)        !< numbers of points that are solved and not yet on disk
      integer :: count = 0                      !< of these
      integer(int64) :: last = 0                !< when something was written [ticks]
      logical :: there = .false.                !< the file is there
      type(error_type), allocatable :: failure  !< why nothing can be written any more
   end type keeper_type

   !> Results go to disk no later than this after they came [s]: a short sweep needs no record.
   real(wp), parameter :: patience = 0.1_wp

contains

   !> Path of the record of a part, or of an undivided run (`parts` = 0).
   pure function record_path(job, what, name, part, parts) result(path)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: what         !< sweep or uncertainty
      character(*), intent(in) :: name         !< of it
      integer, intent(in) :: part, parts
      character(:), allocatable :: path
      path = job%output_dir//'/'//record_file(what, name, part, parts)
   end function record_path

   !> Begins to keep the results of a run. Where an interrupted run has left a record its results are taken over; one of other
   !> work is refused (bad input). With --again, so are those of a finished run, except points that did not converge.
   subroutine open_record(job, what, name, settings, points, keeper, error)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: what, name
      type(text_type), intent(in) :: settings(:)
      type(sweep_result_type), intent(inout) :: points(:)
      type(keeper_type), intent(out) :: keeper
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: failure
      logical :: there, goes_back(size(points))
      keeper%path = record_path(job, what, name, job%part, job%parts)
      keeper%failed = ''
      if (job%parts == 0) keeper%failed = job%output_dir//'/'//failed_file(what, name)
      keeper%part = job%part
      keeper%parts = max(job%parts, 1)
      keeper%settings = settings
      allocate (keeper%waiting(size(points)))
      call system_clock(keeper%last)
      inquire (file=keeper%path, exist=keeper%there)
      keeper%source = keeper%path
      there = keeper%there
      if (.not. there .and. job%again .and. job%parts == 0) then
         keeper%source = keeper%failed
         inquire (file=keeper%source, exist=there)
      end if
      if (.not. there) return
      call take_file(job, keeper%source, [keeper%part, keeper%parts], settings, points, failure)
      if (failure /= '') then
         call raise(error, status_bad_input, what//' '//name//': cannot go on with '//keeper%source//': '//failure// &
                    '; restore the deck, or remove that file to begin anew')
         return
      end if
      goes_back = points%earlier .and. points%status == result_not_converged
      keeper%put_back = count(goes_back)
      where (goes_back)
         points%status = unsolved
         points%earlier = .false.
      end where
      call write_record(keeper, points, error)   ! without a line that was cut short
   end subroutine open_record

   !> Joins the results of all parts. Those that are missing, broken, of another deck or not finished are noted.
   subroutine take_parts(job, what, name, settings, points, faults)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: what, name
      type(text_type), intent(in) :: settings(:)
      type(sweep_result_type), intent(inout) :: points(:)
      type(part_faults_type), intent(inout) :: faults
      character(:), allocatable :: path, failure
      integer :: part, missing, state
      logical :: there
      do part = 1, job%merge
         path = record_path(job, what, name, part, job%merge)
         inquire (file=path, exist=there)
         failure = 'it is missing'
         state = part_missing
         if (there) then
            call take_file(job, path, [part, job%merge], settings, points, failure)
            missing = count(.not. is_solved(points(part::job%merge)))
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
   end subroutine take_parts

   !> Takes the results of one file.
   subroutine take_file(job, path, part, settings, points, failure)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: path
      integer, intent(in) :: part(2)                   !< its number, and of how many
      type(text_type), intent(in) :: settings(:)
      type(sweep_result_type), intent(inout) :: points(:)
      character(:), allocatable, intent(out) :: failure
      type(text_type), allocatable :: lines(:)
      type(record_type) :: record
      allocate (lines(0))   ! the compiler's flow analysis takes it for undefined otherwise
      call read_lines(path, lines, failure)
      if (failure /= '') return
      call read_record(lines, record, failure)
      if (failure /= '') return
      call take_record(record, part(1), part(2), settings, points, failure, job%units, job%again)
   end subroutine take_file

   !> Tells which results of earlier runs are taken over, and which of them are solved again.
   subroutine tell_taken(keeper, whose, points, again)
      type(keeper_type), intent(in) :: keeper
      character(*), intent(in) :: whose                   !< sweep 'a'
      type(sweep_result_type), intent(in) :: points(:)    !< as they are before anything is solved
      logical, intent(in) :: again                        !< asked for
      character(:), allocatable :: text
      integer :: taken, lost
      taken = count(is_solved(points))
      lost = count(points%status == result_not_converged)
      if (taken + keeper%put_back == 0) then
         if (again) call tell(whose//': there are no earlier results; all points are solved')
         return
      end if
      text = whose//': '//to_text(taken)//' points were solved before, in '//keeper%source
      if (keeper%put_back > 0) then
         text = text//'; '//to_text(keeper%put_back)//' that did not converge are solved again'
      else if (again .and. lost > 0) then
         text = text//'; '//to_text(lost)//' of them did not converge with the same settings of the solver: change these'
      else if (again) then
         text = text//'; all of them converged or locked up, so none is solved again'
      end if
      call tell(text)
   end subroutine tell_taken

   !> Tells how points that did not converge can be solved again.
   subroutine tell_failed(whose, points, parts)
      character(*), intent(in) :: whose
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: parts                        !< of the run; 0: undivided
      character(:), allocatable :: text
      integer :: i, n
      n = count(points%status == result_not_converged)
      if (n == 0) return
      text = whose//': change settings of the solver and give --again to solve '//to_text(n)//' points once more'
      if (parts > 0) text = text//'; they are in --part '//part_list_text(pack([(i, i=1, parts)], &
         [(any(points(i::parts)%status == result_not_converged), i=1, parts)]))//'/'//to_text(parts)
      call tell(text)
   end subroutine tell_failed

   !> Notes that a point is solved and puts what waits to disk when some time has gone by. A file that cannot be written is noted in
   !> the keeper; the work goes on without.
   subroutine keep(keeper, number, points)
      type(keeper_type), intent(inout) :: keeper
      integer, intent(in) :: number                       !< of a point that is solved now
      type(sweep_result_type), intent(in) :: points(:)    !< all of the sweep
      type(error_type), allocatable :: error
      integer(int64) :: now
      if (allocated(keeper%failure)) return
      keeper%count = keeper%count + 1
      keeper%waiting(keeper%count) = number
      call system_clock(now)
      if (seconds_between(keeper%last, now) < patience) return
      keeper%last = now
      if (keeper%there) then
         call append_waiting(keeper, points, error)
      else
         call write_record(keeper, points, error)
      end if
      if (allocated(error)) call move_alloc(error, keeper%failure)
   end subroutine keep

   !> Ends keeping. The record of an undivided run has served, unless points of its deck did not converge: then it stays
   !> under another name, so that these can be solved again.
   subroutine close_record(keeper, points, lost, error)
      type(keeper_type), intent(inout) :: keeper
      type(sweep_result_type), intent(in) :: points(:)
      logical, intent(in) :: lost                         !< points of the deck did not converge, here or elsewhere
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: partial
      logical :: there
      partial = keeper%path
      if (lost) then
         keeper%path = keeper%failed
         call write_record(keeper, points, error)
         if (allocated(error)) return
      else
         inquire (file=keeper%failed, exist=there)
         if (there) call delete_file(keeper%failed)
      end if
      inquire (file=partial, exist=there)
      if (there) call delete_file(partial)
   end subroutine close_record

   !> Writes the whole record with all points that are solved.
   subroutine write_record(keeper, points, error)
      type(keeper_type), intent(inout) :: keeper
      type(sweep_result_type), intent(in) :: points(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: i, head
      associate (top => record_head(keeper%part, keeper%parts, size(points), keeper%settings))
         head = size(top)
         allocate (lines(head + count(is_solved(points))))
         do i = 1, head
            lines(i)%text = top(i)%text
         end do
      end associate
      do i = 1, size(points)
         if (.not. is_solved(points(i))) cycle
         head = head + 1
         lines(head)%text = record_line(i, result_text(points(i)))
      end do
      call write_text_file(keeper%path, lines, error)
      keeper%there = .not. allocated(error)
      keeper%count = 0
   end subroutine write_record

   !> Puts the waiting points at the end of the record.
   subroutine append_waiting(keeper, points, error)
      type(keeper_type), intent(inout) :: keeper
      type(sweep_result_type), intent(in) :: points(:)
      type(error_type), allocatable, intent(out) :: error
      character(:), allocatable :: reason
      integer :: unit, status, i
      open (newunit=unit, file=keeper%path, status='old', position='append', action='write', iostat=status)
      do i = 1, keeper%count
         if (status /= 0) exit
         write (unit, '(a)', iostat=status) record_line(keeper%waiting(i), result_text(points(keeper%waiting(i))))
      end do
      if (status == 0) close (unit, iostat=status)
      if (status /= 0) then
         reason = reason_of_failed_write(keeper%path)
         if (reason == '') reason = 'it failed once'
         call raise(error, status_failure, 'cannot write '//keeper%path//': '//reason//'; an interruption would '// &
                    'lose what is solved')
      end if
      keeper%count = 0
   end subroutine append_waiting
end module dg_sweep_record

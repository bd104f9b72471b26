!> A sweep as numbered pieces of work: what belongs to which part, and results as lines of a record.
module dg_sweep_work
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged, result_locked_up, result_status_name
   use dg_sweep_result, only: is_solved, sweep_result_type
   use dg_task_record, only: difference_of, part_text, record_type, solver_key
   use dg_text, only: text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: in_part, result_text, read_result, add_record

   !> Numbers of a double in text, to the last bit.
   character(*), parameter :: row_form = '(2es25.16e3)'
   integer, parameter :: number_width = 25
   !> Stands before a point that an earlier run solved with other settings of the solver.
   character(*), parameter :: earlier_mark = 'earlier '
   !> Greatest plausible hook load [N] and torque [N.m] of a record. They are far above any rig, and below the effect of a
   !> damaged exponent. Those of a point without solution may be anything finite.
   real(wp), parameter :: greatest = 1.0e15_wp

contains

   !> True if a piece of work belongs to part `part` of `parts`. Each part takes every parts-th piece, so that it has its share of
   !> shallow and of deep points.
   elemental function in_part(piece, part, parts) result(yes)
      integer, intent(in) :: piece, part, parts
      logical :: yes
      yes = modulo(piece - 1, parts) == part - 1
   end function in_part

   !> A solved point as text of a record: status, hook load and torque to the last bit, message.
   pure function result_text(point) result(text)
      type(sweep_result_type), intent(in) :: point
      character(:), allocatable :: text
      character(2*number_width) :: numbers
      write (numbers, row_form) point%hookload, point%torque
      text = trim(result_status_name(point%status))//numbers
      if (point%earlier) text = earlier_mark//text
      if (allocated(point%message)) text = text//' '//point%message
   end function result_text

   !> Read the point of such a text. `sound` is true if result_text can have written it: the two numbers in exactly that form,
   !> and finite. A solution's numbers must be no greater than any string can have.
   pure recursive subroutine read_result(text, point, sound)
      character(*), intent(in) :: text
      type(sweep_result_type), intent(out) :: point
      logical, intent(out) :: sound
      character(2*number_width) :: again
      integer :: i, at, last, status
      sound = .false.
      if (index(text, earlier_mark) == 1) then
         call read_result(text(len(earlier_mark) + 1:), point, sound)
         sound = sound .and. .not. point%earlier
         point%earlier = .true.
         return
      end if
      do i = 1, result_locked_up
         at = len_trim(result_status_name(i))
         last = at + 2*number_width
         if (len(text) < last) cycle
         if (text(:at + 1) /= trim(result_status_name(i))//' ') cycle
         if (.not. (fits(text(at + 1:at + number_width)) .and. fits(text(at + number_width + 1:last)))) return
         read (text(at + 1:last), row_form, iostat=status) point%hookload, point%torque
         if (status /= 0) return
         if (.not. all(ieee_is_finite([point%hookload, point%torque]))) return
         if (i == result_converged .and. max(abs(point%hookload), abs(point%torque)) > greatest) return
         write (again, row_form) point%hookload, point%torque
         if (again /= text(at + 1:last)) return
         point%status = i
         if (len(text) > last) then
            if (text(last + 1:last + 1) /= ' ' .or. has_control_bytes(text(last + 1:))) return
            point%message = text(last + 2:)
         end if
         sound = .true.
         return
      end do
   end subroutine read_result

   !> True if the exponent of a number in row_form, its last three letters, fits a double. Reading a greater one overflows.
   pure function fits(number) result(does)
      character(number_width), intent(in) :: number
      logical :: does
      character(*), parameter :: digits = '0123456789', greatest_exponent = '307'
      does = verify(number(number_width - 2:), digits) == 0 .and. number(number_width - 2:) <= greatest_exponent
   end function fits

   !> True if a text holds bytes that no message has.
   pure function has_control_bytes(text) result(has)
      character(*), intent(in) :: text
      logical :: has
      integer, parameter :: delete = 127
      integer :: i
      has = any([(iachar(text(i:i)) < iachar(' ') .or. iachar(text(i:i)) == delete, i=1, len(text))])
   end function has_control_bytes

   !> Add the results of a record to the present ones. `failure` is '', or says why the record is not part `part` of `parts` of
   !> the work with these settings. Then `points` stay. With `again` the record may have other settings of the solver; its
   !> points then count as earlier ones.
   pure subroutine add_record(record, part, parts, settings, points, failure, units, again)
      type(record_type), intent(in) :: record
      integer, intent(in) :: part, parts
      type(text_type), intent(in) :: settings(:)
      type(sweep_result_type), intent(inout) :: points(:)
      character(:), allocatable, intent(out) :: failure
      type(unit_system_type), intent(in), optional :: units    !< in which `failure` tells numbers; else SI
      logical, intent(in), optional :: again
      type(sweep_result_type) :: found(size(record%numbers))
      logical :: sound, other_solver
      integer :: i
      failure = difference_of(record%settings, settings, units)
      other_solver = .false.
      if (present(again) .and. failure /= '') then
         if (again) then
            failure = difference_of(without_solver(record%settings), without_solver(settings), units)
            other_solver = failure == ''
         end if
      end if
      if (failure /= '') then
         if (difference_of(without_solver(record%settings), without_solver(settings)) == '') &
            failure = failure//' (--again takes its points over)'
         failure = 'it is of another deck: '//failure
         return
      end if
      if (record%pieces /= size(points)) then
         failure = 'it is of '//to_text(record%pieces)//' points, the deck has '//to_text(size(points))
         return
      end if
      if (record%part /= part .or. record%parts /= parts) then
         failure = 'it holds '//part_text(record%part, record%parts)//' instead of '//part_text(part, parts)
         return
      end if
      do i = 1, size(found)
         call read_result(record%texts(i)%text, found(i), sound)
         if (.not. sound) then
            failure = 'the result of point '//to_text(record%numbers(i))//' is damaged'
         else if (.not. in_part(record%numbers(i), part, parts)) then
            failure = 'point '//to_text(record%numbers(i))//' does not belong to '//part_text(part, parts)
         else if (is_solved(points(record%numbers(i)))) then
            failure = 'point '//to_text(record%numbers(i))//' is there already'
         end if
         if (failure /= '') then
            failure = 'line '//to_text(record%places(i))//': '//failure
            return
         end if
      end do
      do i = 1, size(found)
         if (other_solver) found(i)%earlier = .true.
         points(record%numbers(i)) = found(i)
      end do
   end subroutine add_record

   !> Settings without those of the solver.
   pure function without_solver(settings) result(others)
      type(text_type), intent(in) :: settings(:)
      type(text_type) :: others(size(settings))
      integer :: i
      do i = 1, size(settings)
         others(i)%text = settings(i)%text
         if (index(settings(i)%text, solver_key) == 1) others(i)%text = solver_key
      end do
   end function without_solver
end module dg_sweep_work

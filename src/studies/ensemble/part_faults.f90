!> Reasons why the parts of a divided run cannot be joined: all sweeps and all parts of them in one message.
module dg_part_faults
   use dg_error, only: add_fault, error_list_type, first_errors
   use dg_part_list, only: part_list_text
   use dg_text, only: to_text
   implicit none
   private
   public :: part_faults_type, part_whole, part_missing, part_broken, part_unfinished, start_faults, note_part, faults_text

   ! State of a record of a part.
   integer, parameter :: part_whole = 1, part_missing = 2, part_broken = 3, part_unfinished = 4

   type :: part_faults_type
      private
      logical, allocatable :: seen(:, :)       !< of each state (row) and part: a record that is so
      type(error_list_type) :: records         !< those at fault
   end type part_faults_type

   !> Records that the message tells one by one. The numbers of the parts are all there in any case.
   integer, parameter :: most_lines = 20

contains

   !> No faults yet of so many parts.
   subroutine start_faults(faults, parts)
      type(part_faults_type), intent(out) :: faults
      integer, intent(in) :: parts
      allocate (faults%seen(part_unfinished, parts), source=.false.)
   end subroutine start_faults

   !> Notes one record of a part.
   pure subroutine note_part(faults, part, state, path, reason)
      type(part_faults_type), intent(inout) :: faults
      integer, intent(in) :: part
      integer, intent(in) :: state             !< part_whole, ...
      character(*), intent(in) :: path
      character(*), intent(in) :: reason       !< what is wrong with it
      character(:), allocatable :: remedy
      faults%seen(state, part) = .true.
      if (state == part_whole) return
      remedy = 'run'
      if (state == part_broken) remedy = 'remove it and run'
      if (state == part_unfinished) remedy = 'go on with'
      call add_fault(faults%records, path, 0, reason//'; '//remedy//' --part '//to_text(part)//'/'//to_text(size(faults%seen, 2)))
   end subroutine note_part

   !> All faults, by the numbers of the parts; '' if all are whole. A part with records of several sweeps is broken if one of
   !> them is. It is missing if all of them are, else not finished.
   pure function faults_text(faults) result(text)
      type(part_faults_type), intent(in) :: faults
      character(:), allocatable :: text
      logical, allocatable :: broken(:), missing(:), unfinished(:)
      integer :: parts
      text = ''
      if (faults%records%count == 0) return
      parts = size(faults%seen, 2)
      allocate (broken(parts), missing(parts), unfinished(parts))
      broken = faults%seen(part_broken, :)
      missing = faults%seen(part_missing, :) .and. .not. (broken .or. faults%seen(part_unfinished, :) .or. &
                                                          faults%seen(part_whole, :))
      unfinished = (faults%seen(part_missing, :) .or. faults%seen(part_unfinished, :)) .and. .not. (broken .or. missing)
      text = 'the '//to_text(parts)//' parts are not complete'//named('missing', missing)//named('broken', broken)// &
         named('not finished', unfinished)//new_line('a')//first_errors(faults%records, most_lines, '  ')
      text = text//new_line('a')//'  --part '//part_list_text(places(broken .or. missing .or. unfinished))//'/'//to_text(parts)
      if (any(broken)) then
         text = text//' runs them again once the broken files are removed'
      else
         text = text//' runs them'
      end if
   end function faults_text

   !> The parts that are so, if any.
   pure function named(what, are) result(text)
      character(*), intent(in) :: what
      logical, intent(in) :: are(:)            !< of each part
      character(:), allocatable :: text
      text = ''
      if (any(are)) text = '; '//what//': '//part_list_text(places(are))
   end function named

   pure function places(are) result(numbers)
      logical, intent(in) :: are(:)
      integer, allocatable :: numbers(:)
      integer :: i
      numbers = pack([(i, i=1, size(are))], are)
   end function places
end module dg_part_faults

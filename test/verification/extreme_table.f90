!> Rows of the table of extremes: takes cases, counts verdicts, prints one row an axis. test/README.md keeps what is printed and
!> .ci/check_extremes.py compares.
module dg_extreme_table
   use, intrinsic :: iso_fortran_env, only: output_unit
   use funit, only: assertTrue
   use dg_extreme_case, only: answer_type, extreme_case_type, judge, quantity_count, quantity_name, right, &
                              solve_extreme, unsolved, verdict_count, verdict_name, verdict_type, wrong
   use dg_extreme_reference, only: by_independent_beam, by_short_elements, by_straight_hole
   use dg_kinds, only: wp
   use dg_missing, only: is_missing, missing
   use dg_text, only: to_text
   implicit none
   private
   public :: row_type, begin_row, add_row, add_bent, add_short, add_straight, finish_row

   !> One row of the table.
   type :: row_type
      character(:), allocatable :: axis, range
      integer :: count(verdict_count) = 0
      real(wp) :: worst(quantity_count) = missing
   end type row_type

   !> Known failures. Cases that the program does not solve, and says so: none.
   character(*), parameter :: not_solved(0) = [character(40) ::]
   !> Known failures. Cases that converge, and are off by more than the tolerance without a word: none.
   character(*), parameter :: off(0) = [character(40) ::]

contains

   subroutine begin_row(row, axis, range)
      type(row_type), intent(out) :: row
      character(*), intent(in) :: axis, range
      row%axis = axis
      row%range = range
   end subroutine begin_row

   !> A case in a straight hole, against closed forms.
   subroutine add_straight(extreme, row)
      type(extreme_case_type), intent(in) :: extreme
      type(row_type), intent(inout) :: row
      type(extreme_case_type) :: free
      type(answer_type) :: reference
      free = extreme
      free%held = .false.
      call by_straight_hole(free, reference)
      call add_row(free, reference, row)
   end subroutine add_straight

   !> A case against the independent beam.
   subroutine add_bent(extreme, row)
      type(extreme_case_type), intent(in) :: extreme
      type(row_type), intent(inout) :: row
      type(answer_type) :: reference
      logical :: found
      call by_independent_beam(extreme, reference, found)
      call assertTrue(found, message=trim(extreme%label)//': reference')
      if (found) call add_row(extreme, reference, row)
   end subroutine add_bent

   !> A case against the program on short elements, where nothing else is known.
   subroutine add_short(extreme, row, element)
      type(extreme_case_type), intent(in) :: extreme
      type(row_type), intent(inout) :: row
      real(wp), intent(in), optional :: element     !< longest of the reference [m], else that of by_short_elements
      type(answer_type) :: reference
      logical :: found
      found = extreme%lock_up
      if (.not. found) call by_short_elements(extreme, reference, found, element)
      call assertTrue(found, message=trim(extreme%label)//': reference')
      if (found) call add_row(extreme, reference, row)
   end subroutine add_short

   !> Solves and judges one case.
   subroutine add_row(extreme, reference, row)
      type(extreme_case_type), intent(in) :: extreme
      type(answer_type), intent(in) :: reference
      type(row_type), intent(inout) :: row
      type(answer_type) :: answer
      type(verdict_type) :: verdict
      character(:), allocatable :: deviation
      real :: start, finish
      integer :: i
      call cpu_time(start)
      call solve_extreme(extreme, answer, verdict)
      call cpu_time(finish)
      call judge(extreme, answer, reference, verdict)
      row%count(verdict%number) = row%count(verdict%number) + 1
      if (is_told()) write (output_unit, '(2x,a,1x,a,t56,f6.2,4es9.1,2x,a)') verdict_name(verdict%number), trim(extreme%label), &
         finish - start, (merge(0.0_wp, verdict%error(i), is_missing(verdict%error(i))), i=1, quantity_count), verdict%message
      deviation = ''
      if (verdict%worst > 0) deviation = ', '//trim(quantity_name(verdict%worst))//' off by '// &
                                         to_text(100.0_wp*verdict%error(verdict%worst), 2)//' %'
      call assertTrue((verdict%number == wrong) .eqv. any(off == extreme%label), message=trim(extreme%label)//': '// &
                      trim(verdict_name(verdict%number))//deviation//', listed otherwise; '//verdict%message)
      call assertTrue((verdict%number == unsolved) .eqv. any(not_solved == extreme%label), message=trim(extreme%label)//': '// &
                      trim(verdict_name(verdict%number))//', listed otherwise; '//verdict%message)
      if (verdict%number /= right) return
      do i = 1, quantity_count
         row%worst(i) = max(row%worst(i), verdict%error(i))
      end do
   end subroutine add_row

   !> Prints a row. Errors are the worst of the cases that are right.
   subroutine finish_row(row)
      type(row_type), intent(in) :: row
      character(8) :: cell(quantity_count)
      integer :: i
      do i = 1, quantity_count
         cell(i) = '-'
         if (.not. is_missing(row%worst(i))) write (cell(i), '(es7.1)') row%worst(i)
      end do
      write (output_unit, '(*(a))') '| ', row%axis, ' | ', row%range, (' | '//to_text(row%count(i)), i=1, verdict_count), &
         (' | '//trim(cell(i)), i=1, quantity_count), ' |'
   end subroutine finish_row

   !> True if option -d asks the tests to print their steps.
   function is_told() result(told)
      logical :: told
      character(8) :: argument
      integer :: i
      told = .false.
      do i = 1, command_argument_count()
         call get_command_argument(i, argument)
         told = told .or. argument == '-d'
      end do
   end function is_told
end module dg_extreme_table

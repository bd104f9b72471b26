!> Load of a packer on the lower end of a string that it holds. A packer is set in one load case, and another one then pumps.
!>
!> A fixed packer lets the lower end move neither up nor down from its place in the first case. A landed string rests on a
!> shoulder: it can move up, but not down. The load is searched with the soft string, whose change of length (dg_length_change)
!> falls with it. Every method then solves the case with that load.
module dg_held_string
   use dg_along_string, only: along_string_type, find_along_string
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_case_result, only: case_result_type, has_numbers
   use dg_error, only: error_type
   use dg_job, only: model_soft
   use dg_kinds, only: wp
   use dg_length_change, only: find_length_change, length_change_type, total_change
   use dg_model, only: hold_free, hold_landed, model_type
   use dg_solve_case, only: solve_case
   implicit none
   private
   public :: find_packer_loads

   !> First step of the search [N], and most doublings of it.
   real(wp), parameter :: first_step = 1.0e4_wp
   integer, parameter :: doublings = 30
   !> Accuracy of the load [N].
   real(wp), parameter :: narrowness = 0.1_wp

contains

   !> Set the weight on bit of each load case that is held by its packer to the load at the lower end. A case for which none is
   !> found keeps its own, and `failed` has its number.
   subroutine find_packer_loads(model, failed)
      type(model_type), intent(inout) :: model
      integer, allocatable, intent(out) :: failed(:)
      integer :: i
      logical :: found
      allocate (failed(0))
      if (model%boundary%packer_hold == hold_free) return
      do i = 1, size(model%cases)
         if (model%cases(i)%length_reference == 0) cycle
         call find_packer_load(model, i, found)
         if (.not. found) failed = [failed, i]
      end do
   end subroutine find_packer_loads

   !> Find the load of one load case that is held.
   subroutine find_packer_load(model, number, found)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: number
      logical, intent(out) :: found
      type(bracket_type) :: bracket
      real(wp) :: there, low, high, value_low, value_high, step
      integer :: i
      call find_total(model, model%cases(number)%length_reference, there, found)
      if (.not. found) return
      low = 0.0_wp
      call find_moved(low, value_low)
      if (.not. found) return
      if (value_low < 0.0_wp .and. model%boundary%packer_hold == hold_landed) then
         model%cases(number)%wob = 0.0_wp       ! the string is above its shoulder
         return
      end if
      step = merge(first_step, -first_step, value_low >= 0.0_wp)
      high = low
      value_high = value_low
      do i = 1, doublings
         low = high
         value_low = value_high
         high = high + step
         call find_moved(high, value_high)
         if (.not. found) return
         if ((value_high >= 0.0_wp) .neqv. (value_low >= 0.0_wp)) exit
         step = 2.0_wp*step
      end do
      found = i <= doublings
      if (.not. found) return
      if (value_low >= 0.0_wp) then
         bracket = new_bracket(low, value_low, high, value_high)
      else
         bracket = new_bracket(high, value_high, low, value_low)
      end if
      do while (.not. is_narrow(bracket, narrowness))
         high = next_try(bracket, narrowness)
         call find_moved(high, value_high)
         if (.not. found) return
         call narrow(bracket, high, value_high)
      end do
      model%cases(number)%wob = bracket%low
   contains
      !> Move of the lower end against the reference case, downwards [m], under a load [N].
      subroutine find_moved(load, moved)
         real(wp), intent(in) :: load
         real(wp), intent(out) :: moved
         real(wp) :: own, total
         own = model%cases(number)%wob
         model%cases(number)%wob = load
         call find_total(model, number, total, found)
         model%cases(number)%wob = own
         moved = total - there
      end subroutine find_moved
   end subroutine find_packer_load

   !> Change of length in a load case by the soft string [m].
   subroutine find_total(model, number, total, found)
      type(model_type), intent(in) :: model
      integer, intent(in) :: number
      real(wp), intent(out) :: total
      logical, intent(out) :: found
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(length_change_type) :: change
      type(error_type), allocatable :: error
      total = 0.0_wp
      call solve_case(model, model_soft, number, result, error)
      found = .not. allocated(error) .and. has_numbers(result%status)
      if (.not. found) return
      call find_along_string(model, result, along)
      call find_length_change(model, result, along, change)
      total = total_change(change)
   end subroutine find_total
end module dg_held_string

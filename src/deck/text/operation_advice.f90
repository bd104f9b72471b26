!> Advice on an operation of a deck that is unknown: nearest by its name and all its aliases, told by its long name.
module dg_operation_advice
   use dg_load_case, only: alike, operation_aliases, operation_count, operation_from_name, operation_name
   use dg_text, only: edit_distance, joined
   implicit none
   private
   public :: operation_advice

   !> Slips that a name may have, by its length.
   integer, parameter :: short_name = 4, slips_of_short = 1, slips_of_long = 2
   !> Letters of a name that is cut short.
   integer, parameter :: shortest_stem = 5
   !> Words of the rig that mean more than one operation, or one with a load.
   character(*), parameter :: overpull = 'overpull'
   character(*), parameter :: both_ways(4) = [character(12) :: 'trip', 'tripping', 'reciprocate', 'washing']

contains

   !> Advice on an unknown name. Where two operations are equally near, both are named.
   pure function operation_advice(name) result(advice)
      character(*), intent(in) :: name
      character(:), allocatable :: advice
      logical :: near(operation_count)
      integer :: i
      if (alike(name) == overpull .or. alike(name) == 'overpulling') then
         advice = "write 'trip_out' with a wob below 0, which pulls the bit"
         return
      end if
      if (any(both_ways == alike(name))) then
         advice = "write 'trip_out' or 'trip_in'"
         return
      end if
      call find_near(trim(alike(name)), near)
      if (any(near)) then
         advice = "did you mean '"//joined(pack(operation_name, near), "' or '")//"'? "
      else
         advice = ''
      end if
      advice = advice//'legal: '//joined([(operation_name(i), i=1, operation_count)], ', ')// &
         ' and the aliases of input/README.md'
   end function operation_advice

   !> Operations that have the nearest of all names. Of short names one slip counts, of long ones two; else a name that goes on
   !> where this one ends.
   pure subroutine find_near(name, near)
      character(*), intent(in) :: name       !< as `alike` gives it, without blanks
      logical, intent(out) :: near(operation_count)
      character(20), parameter :: names(*) = [character(20) :: operation_name, operation_aliases%name]
      integer :: distance(size(names)), i, most
      most = slips_of_long
      if (len(name) <= short_name) most = slips_of_short
      distance = [(edit_distance(name, trim(alike(names(i)))), i=1, size(names))]
      near = .false.
      do i = 1, size(names)
         if (distance(i) <= most .and. distance(i) == minval(distance)) near(operation_from_name(trim(names(i)))) = .true.
      end do
      if (any(near) .or. len(name) < shortest_stem) return
      do i = 1, size(names)
         if (index(alike(names(i)), name) == 1) near(operation_from_name(trim(names(i)))) = .true.
      end do
   end subroutine find_near
end module dg_operation_advice

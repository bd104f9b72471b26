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
      integer :: i, best, distance
      near = .false.
      best = slips_of_long
      if (len(name) <= short_name) best = slips_of_short
      do i = 1, operation_count + size(operation_aliases)
         distance = edit_distance(name, trim(alike(word(i))))
         if (distance > best) cycle
         if (distance < best) near = .false.
         best = distance
         near(operation_from_name(word(i))) = .true.
      end do
      if (any(near) .or. len(name) < shortest_stem) return
      do i = 1, operation_count + size(operation_aliases)
         if (index(alike(word(i)), name) == 1) near(operation_from_name(word(i))) = .true.
      end do
   contains
      pure function word(number)
         integer, intent(in) :: number
         character(:), allocatable :: word
         if (number <= operation_count) then
            word = trim(operation_name(number))
         else
            word = trim(operation_aliases(number - operation_count)%name)
         end if
      end function word
   end subroutine find_near
end module dg_operation_advice

!> How many elements go side by side through the assembly: the first dimension of its arrays. A loop over lanes does the same to
!> each, so that a processor takes several at a time.
module dg_lanes
   implicit none
   private
   public :: lanes

   !> Even, since numbers go two at a time. Eight are no faster than four, two are 4 to 9 % slower.
   integer, parameter :: lanes = 4
end module dg_lanes

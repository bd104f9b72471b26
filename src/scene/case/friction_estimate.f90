!> What is known of the friction of hole sections beyond the deck: found by one study of a run, for others to go on from.
module dg_friction_estimate
   use dg_kinds, only: wp
   implicit none
   private
   public :: friction_estimate_type

   type :: friction_estimate_type
      character(:), allocatable :: name              !< of the study
      logical :: applied = .false.                   !< the rest of the run uses the coefficients
      logical :: axial = .true., rotary = .true.     !< which coefficients it is of
      logical :: found = .false.
      logical :: known = .false.                     !< the numbers below are
      real(wp), allocatable :: deviations(:)         !< one a hole section [-]
      real(wp), allocatable :: correlation(:, :)     !< of two sections [-]
   end type friction_estimate_type
end module dg_friction_estimate

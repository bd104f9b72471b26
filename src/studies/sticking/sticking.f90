!> What a &calibrate of a deck asks of a string that does not move freely (hypothesis 2 of the paper): the resistance at a
!> stuck point or key seat, or the depth down to which the string is free.
module dg_sticking
   use dg_kinds, only: wp
   use dg_load_case, only: optional_real
   implicit none
   private
   public :: sticking_type, find_resistance, find_free_point, sticking_name

   integer, parameter :: find_resistance = 1   !< from hook load and torque, the depth being known
   integer, parameter :: find_free_point = 2   !< from the stretch between two pulls
   !> Names in decks and files, in the order of the numbers above.
   character(*), parameter :: sticking_name(2) = [character(10) :: 'sticking', 'free_point']

   type :: sticking_type
      character(:), allocatable :: name
      integer :: kind = find_resistance
      integer, allocatable :: models(:)         !< numbers (dg_job)
      integer, allocatable :: cases(:)          !< numbers of load cases; two pulls for a free point, the smaller one first
      real(wp) :: depth = 0.0_wp                !< of the stuck point, where that is known [m]
      real(wp) :: stretch = 0.0_wp              !< of the string at surface from the first pull to the second [m]
      type(optional_real) :: hookload_deviation !< standard deviation of a measured hook load [N]
      type(optional_real) :: torque_deviation   !< of a measured torque [N.m]
   end type sticking_type
end module dg_sticking

!> Data of a &calibrate for a string that does not move freely (hypothesis 2 of the paper). Unknown is the resistance at a stuck
!> point or key seat, or the depth down to which the string is free.
module dg_sticking
   use dg_kinds, only: wp
   use dg_missing, only: missing, optional_real
   implicit none
   private
   public :: sticking_type, find_resistance, find_free_point, sticking_name
   public :: sticking_result_type, sticking_status_name
   public :: sticking_found, sticking_at_bound, sticking_below_bit, sticking_no_solution

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

   integer, parameter :: sticking_found = 1
   integer, parameter :: sticking_at_bound = 2       !< the torque that arrives is less than friction takes
   integer, parameter :: sticking_below_bit = 3      !< the whole string stretches less: it is free down to the bit
   integer, parameter :: sticking_no_solution = 4
   character(*), parameter :: sticking_status_name(4) = [character(11) :: 'found', 'at_bound', 'below_bit', 'no_solution']

   !> Result for a string that is held, with one model. SI units; `missing` where there is no value.
   type :: sticking_result_type
      integer :: model = 0                        !< number (dg_job)
      integer :: case_index = 0                   !< of the load case, of the second pull of a free point
      integer :: status = sticking_no_solution
      real(wp) :: depth = missing                 !< of the stuck point [m]
      real(wp) :: depth_without_friction = missing !< the free point by the usual formula [m]
      real(wp) :: free_hookload = missing         !< if nothing stuck [N]
      real(wp) :: tension_above = missing         !< in the string just above the stuck point [N]
      real(wp) :: tension_below = missing         !< there if nothing stuck [N]
      real(wp) :: half_width = missing            !< of the 95 % interval of the resistance, from the gauge alone [N]
      real(wp) :: torque_above = missing          !< [N.m]
      real(wp) :: torque_below = missing          !< [N.m]
      character(:), allocatable :: message
   end type sticking_result_type
end module dg_sticking

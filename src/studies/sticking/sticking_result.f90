!> What was found of a string that is held, with one model. SI units; `missing` where there is no value.
module dg_sticking_result
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: sticking_result_type, sticking_status_name
   public :: sticking_found, sticking_at_bound, sticking_below_bit, sticking_no_solution

   integer, parameter :: sticking_found = 1
   integer, parameter :: sticking_at_bound = 2       !< less torque arrives than friction takes
   integer, parameter :: sticking_below_bit = 3      !< the whole string stretches less: it is free down to the bit
   integer, parameter :: sticking_no_solution = 4
   character(*), parameter :: sticking_status_name(4) = [character(11) :: 'found', 'at_bound', 'below_bit', 'no_solution']

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
end module dg_sticking_result

!> Settings of the solver that must keep an order.
module dg_settings_check
   use dg_error, only: add_part_fault, error_list_type
   use dg_numerics, only: numerics_type
   implicit none
   private
   public :: check_numerics

contains

   !> A free gap yields more than a wall, an elastic wall no less than a rigid one, and contact begins before the wall is rigid.
   subroutine check_numerics(numerics, found)
      type(numerics_type), intent(in) :: numerics
      type(error_list_type), intent(inout) :: found
      if (numerics%gk_min >= numerics%gk_contact) call fault('gk_min', 'gk_min must be smaller than gk_contact')
      if (numerics%gk_contact > numerics%gk_max) call fault('gk_max', 'gk_max must be at least gk_contact')
      if (numerics%eps_n0 >= numerics%eps_nmax) call fault('eps_n0', 'eps_n0 must be smaller than eps_nmax')
   contains
      subroutine fault(key, message)
         character(*), intent(in) :: key, message
         call add_part_fault(found, 'solver', 0, key, message)
      end subroutine fault
   end subroutine check_numerics
end module dg_settings_check

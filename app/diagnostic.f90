!> What the program says on standard error.
module dg_diagnostic
   use, intrinsic :: iso_fortran_env, only: error_unit
   use dg_fault_list, only: fault_list_type, fault_text, fault_type, sorted_faults
   use dg_version, only: program_name
   implicit none
   private
   public :: tell, tell_faults

contains

   !> A line of its own, with the program's name before it.
   subroutine tell(message)
      character(*), intent(in) :: message
      write (error_unit, '(a)') program_name//': '//message
   end subroutine tell

   !> The faults of the input, a line each, in their order in its files.
   subroutine tell_faults(faults)
      type(fault_list_type), intent(in) :: faults
      type(fault_type), allocatable :: sorted(:)
      integer :: i
      allocate (sorted, source=sorted_faults(faults))
      do i = 1, size(sorted)
         write (error_unit, '(a)') fault_text(sorted(i))
      end do
   end subroutine tell_faults
end module dg_diagnostic

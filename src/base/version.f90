!> Name and version of the program, as printed and as written into result files.
module dg_version
   implicit none
   private
   public :: program_name, program_version

   character(*), parameter :: program_name = 'drillgap'
   character(*), parameter :: program_version = '0.3.0'
end module dg_version

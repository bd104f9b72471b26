!> What another program printed of one load case: depths, and any of axial force, torque, side force. SI units.
module dg_legacy_table
   use dg_kinds, only: wp
   use dg_quantity, only: quantity_force, quantity_line_load, quantity_moment
   implicit none
   private
   public :: legacy_table_type, quantity_count, quantity_axial, quantity_torque, quantity_side_force, quantity_of

   integer, parameter :: quantity_axial = 1       !< effective, tension > 0 [N]
   integer, parameter :: quantity_torque = 2      !< [N.m]
   integer, parameter :: quantity_side_force = 3  !< normal contact force per metre [N/m]
   integer, parameter :: quantity_count = 3
   !> Units that they are shown in.
   integer, parameter :: quantity_of(quantity_count) = [quantity_force, quantity_moment, quantity_line_load]

   type :: legacy_table_type
      character(:), allocatable :: label             !< safe as part of a file name
      character(:), allocatable :: file
      character(:), allocatable :: skipped           !< rows of the file that are not read, in words; '': all are
      integer :: case_index = 0                      !< in the model's cases
      logical :: has(quantity_count) = .false.
      real(wp), allocatable :: md(:)                 !< ascending [m]
      real(wp), allocatable :: values(:, :)          !< (size(md), quantity_count); zero where a quantity is missing
   end type legacy_table_type
end module dg_legacy_table

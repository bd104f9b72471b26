!> States of contact and of buckling, by number and by name.
module dg_named_states
   implicit none
   private
   public :: state_free, state_elastic, state_rigid, state_name
   public :: buckling_none, buckling_sinusoidal, buckling_helical, buckling_name

   integer, parameter :: state_free = 0    !< a gap without contact: Eq. 7 of the paper
   integer, parameter :: state_elastic = 1 !< Eq. 8
   integer, parameter :: state_rigid = 2   !< Eq. 8 beyond eps_nmax
   !> Names in files, in the order of the numbers above.
   character(*), parameter :: state_name(0:2) = [character(7) :: 'free', 'elastic', 'rigid']

   integer, parameter :: buckling_none = 0
   integer, parameter :: buckling_sinusoidal = 1
   integer, parameter :: buckling_helical = 2
   !> Names in files, by the numbers above.
   character(*), parameter :: buckling_name(0:2) = [character(10) :: 'none', 'sinusoidal', 'helical']
end module dg_named_states

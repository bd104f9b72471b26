!> Words for a study of points over bit depth.
module dg_range_text
   implicit none
   private
   public :: range_text_type

   !> What it is called.
   type :: range_text_type
      character(:), allocatable :: what            !< sweep or uncertainty, in messages and names of files
      character(:), allocatable :: points          !< its points, and those that are solved
      character(:), allocatable :: points_solved
      character(:), allocatable :: left_out        !< what becomes of those that did not converge; '': nothing
      character(:), allocatable :: fewer           !< what makes them less
   end type range_text_type
end module dg_range_text

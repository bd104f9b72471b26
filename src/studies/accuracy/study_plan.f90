!> Plan of a deck's &study: lists of settings to compare, each empty where the deck does not vary it. SI units.
module dg_study_plan
   use dg_kinds, only: wp
   implicit none
   private
   public :: study_plan_type, most_variants, most_solutions

   type :: study_plan_type
      integer, allocatable :: cases(:)            !< numbers of the load cases
      integer, allocatable :: models(:)           !< numbers of the models (dg_job)
      real(wp), allocatable :: element_lengths(:) !< [m]
      real(wp), allocatable :: tolerances(:)      !< [-]
      real(wp), allocatable :: wall_stiffnesses(:) !< [N/m2]
      integer, allocatable :: gap_locations(:)    !< gap_at_extremum, gap_at_nodes
      integer, allocatable :: linear_solvers(:)   !< numbers of the linear solvers (dg_linear_solver)
      integer, allocatable :: fidelities(:)       !< places in fidelity_name (dg_numerics)
   end type study_plan_type

   !> Most solutions of a study: more is a slip in a list.
   integer, parameter :: most_solutions = 10000

contains

   !> Combinations of all lists with each other: as many variants as there can be.
   pure function most_variants(plan) result(number)
      type(study_plan_type), intent(in) :: plan
      real(wp) :: number      !< real: no overflow, however long the lists
      number = real(size(plan%models), wp)*real(max(1, size(plan%element_lengths) + size(plan%fidelities)), wp)* &
               real(max(1, size(plan%tolerances)), wp)*real(max(1, size(plan%wall_stiffnesses)), wp)* &
               real(max(1, size(plan%gap_locations)), wp)*real(max(1, size(plan%linear_solvers)), wp)
   end function most_variants
end module dg_study_plan

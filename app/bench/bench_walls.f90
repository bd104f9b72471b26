!> The wall's stiffness over ten decades: what it changes in the answer, and in the equations.
module dg_bench_walls
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_bench_chain, only: chain_type, new_chain
   use dg_case_result, only: case_result_type, result_status_name
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_sparse_solver, only: sparse_condition, sparse_factor, sparse_release, sparse_solver_type
   use dg_static_analysis, only: solve_static_analysis
   implicit none
   private
   public :: print_walls

   !> Decades of the stiffness [N/m2].
   integer, parameter :: softest = 4, stiffest = 14
   !> A rigid wall over the elastic one [-].
   real(wp), parameter :: rigid_over_elastic = 10.0_wp
   real(wp), parameter :: kilonewton = 1.0e3_wp

contains

   !> One line a decade: answer, cost, balance that is left, and the condition of the matrix at the predicted state (estimate,
   !> 1-norm).
   subroutine print_walls(model, case_index)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(model_type) :: walled
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      type(chain_type) :: chain
      type(sparse_solver_type) :: sparse
      real(wp) :: condition, wall
      integer :: decade, info
      write (output_unit, '(/,a)') 'Stiffness of the wall, '//model%cases(case_index)%name
      write (output_unit, '(a)') 'wall N/m2  hook load kN  torque kN.m  contact kN  moment kN.m  iterations  balance kN  '// &
         'condition  status'
      walled = model
      do decade = softest, stiffest
         wall = 10.0_wp**decade
         walled%numerics%gk_contact = wall
         walled%numerics%gk_max = rigid_over_elastic*wall
         walled%holes%wall_stiffness = wall
         call solve_static_analysis(walled, case_index, result, error)
         call new_chain(walled, case_index, walled%numerics%element_length, chain)
         call sparse_factor(sparse, chain%matrix, info)
         call sparse_condition(sparse, condition)
         call sparse_release(sparse)
         write (output_unit, '(es9.0,f14.4,f13.5,f12.3,f13.3,i12,es12.1,es11.1,2x,a)') wall, result%hookload/kilonewton, &
            result%torque/kilonewton, result%normal_force/kilonewton, maxval(result%profile%bending)/kilonewton, &
            result%iterations, result%equilibrium_force/kilonewton, condition, trim(result_status_name(result%status))
      end do
   end subroutine print_walls
end module dg_bench_walls

!> A load case on a mesh with the state of its string: the data of the iteration to equilibrium (dg_equilibrium).
module dg_solution
   use dg_kinds, only: wp
   use dg_case_result, only: scale_count
   use dg_equations, only: equations_type
   use dg_gap_action, only: load_type
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_stopping, only: stop_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: solution_type

   type :: solution_type
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(workspace_type) :: work
      type(load_type) :: loads
      type(equations_type) :: equations
      real(wp), allocatable :: state(:, :)       !< (6,nodes) [m, rad, -]
      real(wp) :: compressed = 0.0_wp            !< largest compression over the helical load [-]
      real(wp) :: pressing = 0.0_wp              !< largest expected contact load over its clearance [N/m2]
      integer :: shortened(scale_count) = 0      !< intervals that were cut, by the scale that required it
      type(stop_type) :: stop
   end type solution_type
end module dg_solution

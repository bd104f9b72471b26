!> Course of a solution and its contacts: contacts_<case>_<model>.csv, history_<case>_<model>.csv, state table.
module dg_solution_series
   use dg_case_result, only: contact_name, contact_point_type, iteration_type, judged_name, gap_row_type
   use dg_column, only: quantity_angle, quantity_force, quantity_length, quantity_text, quantity_moment, quantity_none, &
                        quantity_width
   use dg_series, only: add, series_list_type
   use dg_named_states, only: state_name
   implicit none
   private
   public :: contact_series, gap_series
   public :: history_series

contains

   !> Contacts by column. New columns are put at the end only.
   pure function contact_series(contacts) result(list)
      type(contact_point_type), intent(in) :: contacts(:)
      type(series_list_type) :: list
      call add(list, 'md', quantity_length, 'measured depth of the centroid of the force, before loading', contacts%md)
      call add(list, 'force', quantity_force, &
               'force of the string across the hole on the wall; at an edge: in excess of weight and of tension in a bend', &
               contacts%force)
      call add(list, 'length', quantity_length, 'length of string on which the force acts; 0 for bit and top', contacts%length)
      call add(list, 'clock', quantity_angle, 'direction of the force, as clock in the profiles', contacts%clock)
      call add(list, 'kind', quantity_text, &
               'tool joint, stabilizer, centralizer, edge, bit or top', contacts%kind - 1, contact_name)
   end function contact_series

   !> Iterations by column.
   pure function history_series(steps) result(list)
      type(iteration_type), intent(in) :: steps(:)
      type(series_list_type) :: list
      call add(list, 'attempt', quantity_none, &
               'number of the attempt at the case; attempts on shorter elements continue the count', steps%attempt)
      call add(list, 'increment', quantity_none, 'load step', steps%increment)
      call add(list, 'stage', quantity_none, &
               'number of the mesh; elements are cut where the string stands outside the hole', steps%stage)
      call add(list, 'iteration', quantity_none, 'counted through all attempts, load steps and stages of the mesh', steps%iteration)
      call add(list, 'residual', quantity_force, 'largest nodal force out of balance', steps%residual_force)
      call add(list, 'residual', quantity_moment, 'largest nodal moment out of balance', steps%residual_moment)
      call add(list, 'lateral_step', quantity_width, &
               'largest lateral change in the step before limits', steps%lateral_step)
      call add(list, 'damping', quantity_none, &
               'damping of that step, in units of compression^2/(4 EI)', steps%damping)
      call add(list, 'judged_by', quantity_none, &
               'what judged that step: start (there was none), whole (taken as it is: the string is in tension), energy, '// &
               'residual, refused (the string went back); in results.h5 1 to 5 in this order', &
               steps%judged, [character(len(judged_name)) :: '', judged_name])
      call add(list, 'negative_pivots', quantity_none, &
               'negative eigenvalues of the matrix of that step: ways in which the string was unstable; by linear_solver '// &
               'sparse where friction and torque leave the matrix symmetric, else empty', steps%negative_pivots)
      call add(list, 'contacts', quantity_none, 'gaps that touch', steps%contacts)
      call add(list, 'flips', quantity_none, 'gaps that changed state after that step', steps%flips)
      call add(list, 'moves', quantity_none, 'gaps that moved to another x0 after that step', steps%moves)
      call add(list, 'hookload', quantity_force, 'axial force at the top at this iteration', steps%hookload)
   end function history_series

   !> The state table.
   pure function gap_series(gaps) result(list)
      type(gap_row_type), intent(in) :: gaps(:)
      type(series_list_type) :: list
      call add(list, 'md', quantity_length, 'measured depth of the gap element''s place x0', gaps%md)
      call add(list, 'state', quantity_text, 'free, elastic or rigid', gaps%state, state_name)
      call add(list, 'force', quantity_force, 'contact force of the element', gaps%force)
      call add(list, 'flips', quantity_none, 'changes of state during the iteration', gaps%flips)
      call add(list, 'moves', quantity_none, 'changes of place during the iteration', gaps%moves)
   end function gap_series
end module dg_solution_series

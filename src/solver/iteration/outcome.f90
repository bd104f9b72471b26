!> Outcome of a run of the iteration to equilibrium.
module dg_outcome
   implicit none
   private
   public :: outcome_open, outcome_converged, outcome_outside, outcome_singular, outcome_exhausted, outcome_stalled, &
             outcome_damped, outcome_stopped

   integer, parameter :: outcome_open = 0        !< the run goes on
   integer, parameter :: outcome_converged = 1   !< in equilibrium
   integer, parameter :: outcome_outside = 2     !< in an equilibrium outside the hole between its contact points
   integer, parameter :: outcome_singular = 3    !< the linear problem has no unique solution
   integer, parameter :: outcome_exhausted = 4   !< all iterations are used
   integer, parameter :: outcome_stalled = 5     !< the residual has not decreased for too long
   integer, parameter :: outcome_damped = 6      !< damping or the residual is above its limit
   integer, parameter :: outcome_stopped = 7     !< interrupted
end module dg_outcome

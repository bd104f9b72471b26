!> Result of a model for one point of a sweep. SI units.
module dg_sweep_result
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged, result_locked_up
   use dg_missing, only: missing
   use dg_verdict, only: answer_no, answer_unknown, answer_yes
   implicit none
   private
   public :: sweep_result_type, unsolved, is_solved, answer_of

   !> Status of a point that nobody has solved yet, beside those of dg_case_result.
   integer, parameter :: unsolved = 0

   type :: sweep_result_type
      integer :: status = unsolved
      real(wp) :: hookload = 0.0_wp            !< [N]
      real(wp) :: weight_indicator = missing   !< what the rig's indicator shows of it; missing where no rig is given [N]
      real(wp) :: torque = 0.0_wp              !< at the top [N.m]
      ! what is left to limits; missing where there is none
      real(wp) :: rig_margin = missing         !< load that the rig may carry less that on it [N]
      real(wp) :: torque_margin = missing      !< torque of the rig less that at the top [N.m]
      real(wp) :: overpull_margin = missing    !< pull that may be added before anything yields [N]
      integer :: limit = 0                     !< limit that is passed (dg_verdict); 0: none that is known
      logical :: earlier = .false.             !< solved by an earlier run with other settings of the solver
      character(:), allocatable :: message     !< reason where there is no solution, warnings else; not allocated: none
   end type sweep_result_type

contains

   !> True if a point was tried, also where no solution was found.
   elemental function is_solved(point) result(yes)
      type(sweep_result_type), intent(in) :: point
      logical :: yes
      yes = point%status /= unsolved
   end function is_solved

   !> Can it be done: dg_verdict's answer for a point.
   elemental function answer_of(point) result(answer)
      type(sweep_result_type), intent(in) :: point
      integer :: answer
      answer = answer_unknown
      if (point%status == result_converged) answer = answer_yes
      if (point%status == result_locked_up .or. point%limit > 0) answer = answer_no
   end function answer_of
end module dg_sweep_result

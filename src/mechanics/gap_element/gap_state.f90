!> States of the Multi-directional Contact Gap Element (MCGE): Eqs. 3, 7 and 8 and Fig. 2 of the paper.
!>
!> Penetration carries force. With |f| the lateral displacement of the string's axis from the hole axis and c = (D - d)/2 the
!> clearance, the relative compression is eps = |f|/c (Eq. 3). Per metre of contact:
!> - free: R = 0, with Gk = gk_min
!> - elastic: R = gk_contact (|f| - c), up to eps - 1 = eps_nmax
!> - rigid: R = gk_contact c eps_nmax + gk_max (|f| - c (1 + eps_nmax)), beyond
!> R is continuous and piecewise linear. gk_min keeps the matrix regular while nothing touches. It is in the tangent only, so
!> that it does not act on a converged string.
module dg_gap_state
   use dg_kinds, only: wp
   use dg_named_states, only: state_elastic, state_free, state_rigid
   implicit none
   private
   public :: state_free, state_elastic, state_rigid
   public :: gap_law_type, gap_thresholds_type, next_state, contact_force, depth_of, is_round

   !> The law of one gap, per element: rigidities times tributary length.
   type :: gap_law_type
      real(wp) :: clearance = 0.0_wp  !< offset at which contact begins [m]: c = (D - d)/2, less at a bow spring
      real(wp) :: contact = 0.0_wp    !< Gkc [N/m]
      real(wp) :: maximum = 0.0_wp    !< Gkmax [N/m]
      real(wp) :: eps_nmax = 0.0_wp   !< elastic range of relative compression [-]
   end type gap_law_type

   !> Thresholds beyond which a gap closes or opens, the same for all gaps.
   type :: gap_thresholds_type
      real(wp) :: eps_n0 = 0.0_wp     !< of relative compression [-]
      real(wp) :: r_n0 = 0.0_wp       !< of force [N]
   end type gap_thresholds_type

contains

   !> State after the present one (Eqs. 7 and 8), where contact force and depth are both unknowns. A free gap closes when it is
   !> compressed beyond eps_n0 and would carry more than r_n0. A closed gap opens when it pulls with more than r_n0. It also
   !> opens when it is open beyond eps_n0 and would pull so by the force at its depth. Otherwise the state stays, so that two
   !> points do not alternate by round-off. Elastic and rigid change at eps_nmax, without a threshold.
   pure function next_state(law, thresholds, state, force, deep, softness) result(next)
      type(gap_law_type), intent(in) :: law
      type(gap_thresholds_type), intent(in) :: thresholds
      integer, intent(in) :: state      !< present state
      real(wp), intent(in) :: force     !< R; zero in a free gap [N]
      real(wp), intent(in) :: deep      !< |f| less the depth that R needs (depth_of) [m]
      real(wp), intent(in) :: softness  !< stiffness for a closed gap's force at its depth, not above the wall's [N/m]
      integer :: next
      next = state
      if (state == state_free) then
         if (deep > thresholds%eps_n0*law%clearance .and. law%contact*deep > thresholds%r_n0) next = state_elastic
      else
         next = merge(state_rigid, state_elastic, force > law%contact*law%clearance*law%eps_nmax)
         if (force < -thresholds%r_n0 .or. (force + softness*deep < -thresholds%r_n0 .and. &
                                            deep < -thresholds%eps_n0*law%clearance)) next = state_free
      end if
   end function next_state

   !> Contact force R [N] >= 0 pressing inwards (but for the thresholds' width), and its derivative by |f| [N/m]
   !> (Eq. 4, Fig. 2).
   pure subroutine contact_force(law, state, displacement, force, stiffness)
      type(gap_law_type), intent(in) :: law
      integer, intent(in) :: state
      real(wp), intent(in) :: displacement   !< |f| [m]
      real(wp), intent(out) :: force         !< R [N]
      real(wp), intent(out) :: stiffness     !< dR/d|f| [N/m]
      real(wp) :: elastic
      select case (state)
      case (state_elastic)
         stiffness = law%contact
         force = law%contact*(displacement - law%clearance)
      case (state_rigid)
         elastic = law%clearance*law%eps_nmax
         stiffness = law%maximum
         force = law%contact*elastic + law%maximum*(displacement - law%clearance - elastic)
      case default
         stiffness = 0.0_wp
         force = 0.0_wp
      end select
   end subroutine contact_force

   !> |f| [m] at which a closed gap carries a force [N]: the inverse of contact_force.
   pure function depth_of(law, force) result(depth)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: force   !< R, >= 0 [N]
      real(wp) :: depth, elastic
      elastic = law%contact*law%clearance*law%eps_nmax
      depth = law%clearance + min(force, elastic)/law%contact + max(force - elastic, 0.0_wp)/law%maximum
   end function depth_of

   !> True if the string is curved so much next to a gap that its place matters. That is so if |f| half an element away is less
   !> by more than `part` of the depth in the wall.
   pure function is_round(law, force, bend, part) result(is)
      type(gap_law_type), intent(in) :: law
      real(wp), intent(in) :: force            !< R [N]
      real(wp), intent(in) :: bend             !< -d2|f|/dxi2, xi = x/L [m]
      real(wp), intent(in) :: part             !< [-]
      logical :: is
      is = 0.125_wp*bend > part*(depth_of(law, force) - law%clearance)
   end function is_round
end module dg_gap_state

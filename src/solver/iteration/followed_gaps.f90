!> Gaps that follow the extremum of their element (Eq. 2) within the iteration: their places x0 are unknowns too.
!>
!> A single contact carries its load R at the place where |f| is largest. When it is moved there the string tilts about it.
!> The extremum then goes the other way by kappa times the move, with kappa = -R C/|f''| and C the string's flexibility in
!> turning. In sharp bends |kappa| is above 1, and a gap that is moved repeatedly swings ever farther. Here x0 is found
!> together with the string. To first order, with a prime for the derivative by x:
!>   K d + on dR + R on' dx = -r
!>   f' + by'.d + f'' dx = 0
!> The change dx is eliminated as dR is (dg_contact_problem). That adds R/|f''| on' by'^T to K, and R on' f'/|f''| to r.
!> For the energy the first term is a spring that resists the string's turn at the contact. Newton's method then converges
!> quadratically in all unknowns. Where the string is so straight next to the contact that the place makes no difference, the
!> gap stays.
module dg_followed_gaps
   use dg_kinds, only: wp
   use dg_block_matrix, only: block_matrix_type, block_size
   use dg_element_rows, only: add_dyad
   use dg_gap_action, only: find_contact_rows, load_type
   use dg_gap_state, only: is_round, state_free
   use dg_gap_survey, only: survey_between
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_trajectory, only: trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: follower_type, measure_followers, add_place_forces, add_place_stiffness, see_from_extrema, follow_extrema

   !> Part of the element over which central differences give derivatives along it [-].
   real(wp), parameter :: beside = 0.005_wp
   !> Largest distance of the extremum from its gap that is expected [-]. Where |f| is straighter, f'' is increased to give
   !> that distance.
   real(wp), parameter :: farthest = 0.5_wp

   !> A gap that follows its extremum; x is in units of the element length.
   type :: follower_type
      integer :: e                        !< its element
      real(wp) :: force                   !< R [N]
      real(wp) :: bend                    !< -f'' > 0 [m]
      real(wp) :: ahead                   !< f'/|f''|: distance of the extremum from the gap if the string does not move [-]
      real(wp) :: by(2*block_size)        !< by' [-, m]
      real(wp) :: on(2*block_size)        !< on' [-, m]
   end type follower_type

contains

   !> Compute the terms of gaps that follow in the linear problem. A gap at an end of its element whose extremum is beyond that
   !> end stays there.
   pure subroutine measure_followers(trajectory, mesh, loads, relocation, gaps, work, followers)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      real(wp), intent(in) :: relocation             !< `part` of is_round [-]
      type(gap_table_type), intent(inout) :: gaps
      type(workspace_type), intent(inout) :: work    !< placed and surveyed
      type(follower_type), allocatable, intent(inout) :: followers(:)
      type(follower_type) :: one
      real(wp) :: by(2*block_size, 2), on(2*block_size, 2), f(2), slope, bend, place
      integer :: e, s, found
      if (allocated(followers)) deallocate (followers)
      allocate (followers(count(gaps%followed)))
      found = 0
      do e = 1, mesh%elements
         if (.not. gaps%followed(e) .or. gaps%state(e) == state_free .or. .not. work%normal(e) > 0.0_wp) cycle
         place = gaps%xi(e)
         by = 0.0_wp
         on = 0.0_wp
         do s = 1, 2
            gaps%xi(e) = place + merge(-beside, beside, s == 1)
            call survey_between(trajectory, mesh, gaps, e, e, work)
            f(s) = work%displacement(e)
            call find_contact_rows(mesh, loads, gaps, e, e, work, by(:, s:s), on(:, s:s))
         end do
         gaps%xi(e) = place
         call survey_between(trajectory, mesh, gaps, e, e, work)
         slope = (f(2) - f(1))/(2.0_wp*beside)
         bend = (2.0_wp*work%displacement(e) - f(1) - f(2))/beside**2
         if ((place <= 0.0_wp .and. slope < 0.0_wp) .or. (place >= 1.0_wp .and. slope > 0.0_wp)) cycle
         gaps%followed(e) = is_round(gaps%law(e), work%normal(e), bend, relocation)
         if (.not. gaps%followed(e)) cycle
         bend = max(bend, abs(slope)/farthest)
         one%e = e
         one%force = work%normal(e)
         one%bend = bend
         one%ahead = slope/bend
         one%by = (by(:, 2) - by(:, 1))/(2.0_wp*beside)
         one%on = (on(:, 2) - on(:, 1))/(2.0_wp*beside)
         found = found + 1
         followers(found) = one
      end do
      followers = followers(:found)
   end subroutine measure_followers

   !> Add to a residual (6,nodes) the effect of contact forces at the extrema instead of at the gaps.
   pure subroutine add_place_forces(followers, residual)
      type(follower_type), intent(in) :: followers(:)
      real(wp), intent(inout) :: residual(:, :)   !< [N, N.m]
      integer :: i
      do i = 1, size(followers)
         associate (a => followers(i))
            residual(:, a%e) = residual(:, a%e) + (a%force*a%ahead)*a%on(:block_size)
            residual(:, a%e + 1) = residual(:, a%e + 1) + (a%force*a%ahead)*a%on(block_size + 1:)
         end associate
      end do
   end subroutine add_place_forces

   !> Add to a tangent the terms of the gaps that follow: the part of the energy, the part of friction, or both.
   pure subroutine add_place_stiffness(followers, energy, rest, matrix)
      type(follower_type), intent(in) :: followers(:)
      logical, intent(in) :: energy, rest
      type(block_matrix_type), intent(inout) :: matrix
      real(wp) :: on(2*block_size), by(2*block_size)
      integer :: i
      do i = 1, size(followers)
         by = followers(i)%by
         on = 0.0_wp
         if (energy) on = by
         if (rest) on = on + (followers(i)%on - by)
         call add_dyad(followers(i)%force/followers(i)%bend, on, by, followers(i)%e, matrix)
      end do
   end subroutine add_place_stiffness

   !> Change rows and depths to those at the extrema.
   pure subroutine see_from_extrema(followers, by, on, deep)
      type(follower_type), intent(in) :: followers(:)
      real(wp), intent(inout) :: by(:, :), on(:, :), deep(:)   !< of all gaps (12,e), (12,e), (e) [m]
      integer :: i
      do i = 1, size(followers)
         associate (a => followers(i))
            by(:, a%e) = by(:, a%e) + a%ahead*a%by
            on(:, a%e) = on(:, a%e) + a%ahead*a%on
            deep(a%e) = deep(a%e) + 0.5_wp*a%bend*a%ahead**2
         end associate
      end do
   end subroutine see_from_extrema

   !> Move the gaps that follow by a share of the linear problem's step.
   pure subroutine follow_extrema(followers, step, share, places, xi)
      type(follower_type), intent(in) :: followers(:)
      real(wp), intent(in) :: step(:, :)       !< that share of the step (6,nodes) [m, rad, -]
      real(wp), intent(in) :: share            !< [-]
      real(wp), intent(in) :: places(:)        !< places of all gaps before the step (e) [-]
      real(wp), intent(inout) :: xi(:)         !< places after the step (e) [-]
      integer :: i
      real(wp) :: turn
      do i = 1, size(followers)
         associate (a => followers(i))
            turn = dot_product(a%by(:block_size), step(:, a%e)) + dot_product(a%by(block_size + 1:), step(:, a%e + 1))
            xi(a%e) = max(0.0_wp, min(1.0_wp, places(a%e) + share*a%ahead + turn/a%bend))
         end associate
      end do
   end subroutine follow_extrema
end module dg_followed_gaps

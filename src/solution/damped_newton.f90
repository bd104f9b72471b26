!> Newton-Raphson iteration of a compressed string, which buckles: it leaves its side of the hole, snakes and coils.
!>
!> On the way the tangent is indefinite, or next to singular: plain Newton leads uphill, or throws the string across the
!> hole along a mode that nothing resists. Levenberg's (1944) damping as a viscous term on the lateral unknowns does neither:
!>   1. Viscosity nu is raised until the tangent without friction and torque, the second derivative of an energy, is
!>      positive definite with it (inertia control).
!>   2. A step is taken only if it goes down that energy with friction's forces frozen: the slope r.p along the step
!>      must not have turned into a rise as steep at its end. Else nu is raised and the step solved anew: other than a shorter
!>      step this holds back the modes of least stiffness only. No slope felt at all, the step is drawn out.
!>   3. Lateral steps of nodes near the wall are turns about the hole axis. Along straight lines a string on a round wall
!>      could only creep.
!>   4. Where a rotating string's friction spoils the descent it goes by a lagged normal force for a while. A gap that opens or
!>      closes drops its lagged friction, lest it come and go as a whole. A sliding string's friction stays live: coils hold by it;
!>      the residual then has a say in whether a step counts.
!>   5. In a vertical hole nothing resists a turn of the whole string about the axis. Torque drives that turn: its drive is taken
!>      off the residual, and the string found is the whirling one, seen as it turns. Without torque that only guides the way,
!>      and the string is at last turned to where nothing drives it.
!>   6. After a step closed gaps go where its linear forces have them (dg_gap_depths): a stiff wall is then no stiffer a problem
!>      than a soft one.
!> All of it acts on steps. At convergence lagged and live normal forces are one, and the residual is the true one but for 5.
module dg_damped_newton
   use dg_kinds, only: wp
   use dg_assembly, only: assemble, load_type
   use dg_block_matrix, only: swap_matrices
   use dg_block_solver, only: block_positive_definite
   use dg_case_result, only: iteration_type
   use dg_damped_step, only: drop_friction, find_step, flips_friction
   use dg_gap_survey, only: survey_gaps
   use dg_gap_depths, only: close_gently, depths_after, keep_forces, put_gaps
   use dg_gap_state, only: state_free
   use dg_gap_table, only: gap_table_type, keep_gaps, take_gaps_back
   use dg_interruption, only: is_interrupted
   use dg_mesh, only: mesh_type
   use dg_newton, only: add_gap_rigidity, judge, judge_surveyed, largest, largest_turn, longest_round, most_rounds, &
                        newton_converged, newton_exhausted, newton_singular, newton_type, take_residual
   use dg_numerics, only: numerics_type
   use dg_stability, only: margin_of
   use dg_trajectory, only: trajectory_type
   use dg_turning_step, only: axis_of, is_straight_down, phase_type, take_off_drive, turn_along_wall, turning_mode, &
                              turn_to_rest
   use dg_viscosity, only: damped_type, ease_viscosity, until_definite, viscosity_least, viscosity_most, viscosity_start, weigh
   use dg_workspace, only: dof_lateral_1, dof_lateral_2, dof_slope_1, dof_slope_2, place_nodes, workspace_type
   implicit none
   private
   public :: iterate_damped

   !> A residual over the force scale so small that the margin is left alone, lest viscosity delay the end [-].
   real(wp), parameter :: near_rest = 1.0e-6_wp
   !> The same at which gaps are first given the places that they want: their moves are no less good for it, and what is left to do
   !> is done with them.
   real(wp), parameter :: settling_residual = 1.0e-3_wp
   !> Slope at a step's end over that at its start, both of the energy [-]: a rise less than this is accepted; a fall this many
   !> times as steep is friction running away.
   real(wp), parameter :: largest_rise = 0.6_wp, largest_fall = 3.0_wp
   !> A damped step at whose end the slope is this part of what it was is drawn out by this factor, up to this part of the
   !> clearance.
   real(wp), parameter :: still_falling = 0.5_wp, drawn = 3.0_wp, drawn_limit = 0.3_wp
   !> Lagged friction ends when normal forces differ from it by this part in sum, or the residual over the force scale is
   !> below this [-].
   real(wp), parameter :: friction_drift = 0.1_wp, calm_residual = 1.0e-4_wp
   !> Where an energy tells little, a step counts that leaves this part of the residual: near a whirling string's rest, whose drive
   !> has none, and where a string slides, whose friction is much of what holds it; near rest a sliding string's residual may even
   !> grow by this [-].
   real(wp), parameter :: halved = 0.5_wp, grown = 100.0_wp
   !> Steps of such a string in a row with gaps changing after which gaps are taken to be cycling, and steps are halved.
   integer, parameter :: patience = 10
   !> Iterations after which such a string whose gaps have moved is taken back: those that come to rest do so in 3 to 8.
   integer, parameter :: longest_turning_round = 10
   !> Iterations kept for a string whose gaps are taken back to come to rest: it need not have been quite there when they moved.
   integer, parameter :: to_settle = 10

contains

   !> Iterates `state` to a stable equilibrium under `loads`. `outcome` is one of the numbers of dg_newton.
   subroutine iterate_damped(newton, damped, trajectory, mesh, loads, numerics, tolerance, soft, increment, gaps, state, work, &
                             outcome)
      type(newton_type), intent(inout) :: newton
      type(damped_type), intent(inout) :: damped
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(load_type), intent(in) :: loads
      type(numerics_type), intent(in) :: numerics
      real(wp), intent(in) :: tolerance          !< of the residual over the force scale [-]
      logical, intent(in) :: soft                !< a stage before the last: gaps may move at once, and need not be at rest
      integer, intent(in) :: increment
      type(gap_table_type), intent(inout) :: gaps
      real(wp), intent(inout) :: state(:, :)
      type(workspace_type), intent(inout) :: work
      integer, intent(out) :: outcome
      type(iteration_type) :: row
      type(load_type) :: lagged
      type(phase_type) :: phase
      real(wp) :: before, slope, slope_after, growth, share, margin
      real(wp) :: taken        ! off the trial's residual: lambda
      logical :: fresh, good, lag, live, vertical, torque, sliding, settled, changed, lost
      logical :: known         ! residual and tangent, as they have been assembled for the trial
      integer :: info, rounds, round_start, wait
      integer :: stalled       ! steps in a row with gaps changing
      logical :: emptied       ! lagged friction taken off gaps since the last good step
      logical :: moving        ! gaps moved after the last good step, and may again: a trial's tangent would be of no use
      lagged = loads
      lagged%lagged = .true.
      vertical = is_straight_down(mesh)
      torque = any(mesh%rotary > 0.0_wp) .or. abs(loads%tob) > 0.0_wp
      margin = margin_of(mesh, loads)
      sliding = any(abs(mesh%axial) > 0.0_wp)
      lag = .false.
      live = .false.
      rounds = 0
      round_start = newton%iterations
      wait = 0
      stalled = 0
      emptied = .false.
      moving = soft
      growth = until_definite
      damped%viscosity = 0.0_wp
      damped%drive = 0.0_wp
      row%increment = increment
      fresh = .true.
      known = .false.
      call judge(trajectory, mesh, numerics, soft, .true., .false., state, gaps, work, row)
      if (damped%continued) call keep_forces(trajectory, mesh, gaps, damped%depth, state, work)
      do
         if (fresh) then
            call measure()
            call record()
            if (.not. lag .and. before <= tolerance*newton%force_scale .and. (row%flips == 0 .or. soft)) then
               call look_round(settled, changed)
               if (settled .and. vertical .and. .not. torque .and. damped%drive > tolerance*newton%force_scale) then
                  ! without torque nothing drives that turn: something holds it
                  call axis_of(trajectory, mesh, work, state, damped%old)
                  state = state - damped%old
                  call turn_to_rest(phase, damped%pull, state, lost)
                  state = state + damped%old
                  if (lost) then
                     vertical = .false.
                     damped%drive = 0.0_wp
                  end if
                  call judge(trajectory, mesh, numerics, .false., .true., .false., state, gaps, work, row)
                  call keep_forces(trajectory, mesh, gaps, damped%depth, state, work)
                  cycle
               end if
               if (settled) then
                  outcome = newton_converged
                  return
               end if
               if (changed) cycle
            else if (.not. (lag .or. soft .or. row%flips > 0) .and. before <= settling_residual*newton%force_scale) then
               call move_gaps(changed)
               if (changed) cycle
            end if
         end if
         call record()
         if (rounds > 0 .and. .not. newton%gaps_taken_back .and. .not. is_interrupted() .and. newton%iterations >= &
             min(round_start + merge(longest_turning_round, longest_round, vertical), numerics%max_iterations - to_settle)) then
            call take_back()
            cycle
         end if
         if (newton%iterations >= numerics%max_iterations .or. is_interrupted()) then
            outcome = newton_exhausted
            return
         end if
         if (fresh) call add_gap_rigidity(mesh, numerics%gk_min, damped%energy, newton%laterals)
         call solve_step(info)
         row%viscosity = damped%viscosity
         if (info /= 0) then
            outcome = newton_singular
            return
         end if
         damped%old = state
         call keep()
         call take_step()
         newton%iterations = newton%iterations + 1
         slope = share*slope
         good = leads_down()
         if (.not. good) call stop_at_contact(good)
         fresh = good
         if (good) then
            emptied = .false.
            stalled = merge(stalled + 1, 0, row%flips > 0)
            if (damped%viscosity > 0.0_wp .and. slope < 0.0_wp) call draw_out()
            wait = max(wait - 1, 0)
            call ease_viscosity(growth < 1.5_wp*until_definite, damped%viscosity)
            growth = until_definite
            if (soft) call judge_surveyed(trajectory, mesh, numerics, .true., row%flips == 0, .false., gaps, work, row)
            moving = row%moves > 0 .or. (soft .and. row%flips > 0)
            known = known .and. .not. moving
            if (row%moves > 0) call keep_forces(trajectory, mesh, gaps, damped%depth, state, work)
         else if (.not. (live .or. sliding .or. vertical .or. emptied) .and. flips_friction(damped, gaps, work)) then
            call drop_friction(damped, gaps, work)
            call go_back(damped%old)
            emptied = .true.      ! once a step: what is measured anew may bring it back
            fresh = .true.
         else if (live .and. slope >= 0.0_wp .and. .not. sliding) then
            wait = 1
            call go_back(damped%old)
         else
            damped%viscosity = min(max(damped%viscosity, viscosity_start)*growth, viscosity_most)
            growth = until_definite*growth
            call go_back(damped%old)
            if (damped%viscosity >= viscosity_most) then      ! no step leads down any more
               if (vertical .and. rounds > 0 .and. .not. newton%gaps_taken_back) then
                  call take_back()
                  cycle
               end if
               call record()
               outcome = newton_exhausted
               return
            end if
         end if
      end do

   contains

      !> Residual and energy's tangent at the state, with live friction or with the lagged one that follows it.
      subroutine measure()
         if (known) then
            newton%residual = damped%trial
            if (vertical) newton%residual = newton%residual + taken*damped%lump*damped%mode
         end if
         if (lag) then
            if (.not. known .or. live) call assemble(trajectory, mesh, lagged, gaps, state, .true., work, newton%residual, &
                                                     damped%energy, forces_only=.true.)
            lag = sum(abs(work%normal - work%pressing)) > friction_drift*sum(work%pressing) .and. &
                  maxval(abs(newton%residual)) > calm_residual*newton%force_scale
         end if
         if (known .and. (live .neqv. lag)) then
            call swap_matrices(newton%matrix, damped%energy)
         else
            call assemble(trajectory, mesh, merge(lagged, loads, lag), gaps, state, .true., work, newton%residual, damped%energy)
         end if
         if (.not. lag) work%pressing = work%normal
         known = .false.
         call weigh(mesh, work, damped%lump)
         if (vertical) then
            call turning_mode(state, damped%mode)
            call take_off_drive(damped%lump, damped%mode, newton%residual, damped%drive, damped%pull)
         end if
         call take_residual(newton, row)
         before = largest(row)
         row%hookload = work%hookload
         row%contacts = count(gaps%state /= state_free)
      end subroutine measure

      !> Enters the row in the history, in place of what stands there of this iteration.
      subroutine record()
         row%iteration = newton%iterations
         newton%history(newton%iterations + 1) = row
      end subroutine record

      !> Whether the present rest is stable and, against the final wall, no gap wants another place; those that do have it.
      subroutine look_round(settled, changed)
         logical, intent(out) :: settled, changed
         changed = .false.
         call block_positive_definite(damped%energy, margin, damped%lump, settled)
         if (.not. settled .or. soft) return
         call move_gaps(changed)
         settled = .not. changed
      end subroutine look_round

      !> Gives gaps the places that they want.
      subroutine move_gaps(changed)
         logical, intent(out) :: changed
         changed = .false.
         if (rounds >= most_rounds) return
         newton%rest = state
         call keep_gaps(gaps, newton%gaps_at_rest)
         call judge_surveyed(trajectory, mesh, numerics, .true., .true., loads%bit_support > 0.0_wp .and. .not. vertical, gaps, &
                             work, row)
         changed = row%moves > 0 .or. row%flips > 0
         if (.not. changed) return
         rounds = rounds + 1
         round_start = newton%iterations
         call keep_forces(trajectory, mesh, gaps, damped%depth, state, work)
      end subroutine move_gaps

      !> Back to the rest before gaps moved, which then is the end.
      subroutine take_back()
         call take_gaps_back(newton%gaps_at_rest, gaps)
         call keep()
         call go_back(newton%rest)
         newton%gaps_taken_back = .true.
         rounds = most_rounds
         round_start = huge(round_start) - longest_round
         damped%viscosity = 0.0_wp
         growth = until_definite
         lag = .false.
         fresh = .true.
      end subroutine take_back

      !> Newton's step with friction's tangent; where that does not lead down, or there is no friction, the energy's.
      subroutine solve_step(fault)
         integer, intent(out) :: fault
         real(wp) :: least
         least = merge(margin, viscosity_least, before < near_rest*newton%force_scale)
         live = .not. lag .and. wait == 0
         if (live .and. (sliding .or. torque)) then
            call find_step(newton, damped, mesh, loads, gaps, least, vertical, .true., state, work, slope, fault)
            if (fault /= 0 .or. slope < 0.0_wp .or. sliding .or. near_whirl()) return
            lag = .true.
            live = .false.
         end if
         call find_step(newton, damped, mesh, loads, gaps, least, vertical, .false., state, work, slope, fault)
      end subroutine solve_step

      !> Takes the step within its limits, and looks what is there.
      subroutine take_step()
         row%negative_pivots = newton%solver%negative_pivots
         row%lateral_step = maxval(abs(newton%step(dof_lateral_1:dof_lateral_2, :)))
         share = 1.0_wp/max(1.0_wp, row%lateral_step/damped%step_limit, &
                            maxval(abs(newton%step(dof_slope_1:dof_slope_2, :)))/largest_turn)
         if (vertical .and. stalled > patience) share = 0.5_wp*share
         newton%step = share*newton%step
         call look()
      end subroutine take_step

      !> Places the string a step off the old state, whose nodes stand in `work`; slope_after is that along the step.
      subroutine look()
         type(load_type) :: used
         real(wp) :: ignored
         call depths_after(mesh, gaps, newton%step, work, damped%depth)
         call turn_along_wall(trajectory, mesh, work, newton%step, state)
         call place_nodes(mesh, state, work)
         call survey_gaps(trajectory, mesh, gaps, work)
         call put_gaps(trajectory, mesh, gaps, damped%depth, state, work)
         call judge_surveyed(trajectory, mesh, numerics, .false., .true., .false., gaps, work, row)
         call close_gently(trajectory, mesh, gaps, damped%depth, state, work)
         used = loads
         used%lagged = .not. live
         call assemble(trajectory, mesh, used, gaps, state, .true., work, damped%trial, newton%matrix, forces_only=moving)
         known = .not. moving
         if (vertical) then
            call turning_mode(state, damped%mode)
            call take_off_drive(damped%lump, damped%mode, damped%trial, ignored, taken)
         end if
         slope_after = sum(newton%step*damped%trial)
      end subroutine look

      !> Whether the residual alone may tell of a step.
      pure function near_whirl() result(near)
         logical :: near
         near = vertical .and. before < calm_residual*newton%force_scale
      end function near_whirl

      !> Whether the step taken leads down.
      pure function leads_down() result(down)
         logical :: down
         down = slope < 0.0_wp .and. slope_after < -largest_rise*slope
         if (live) down = slope < 0.0_wp .and. slope_after > largest_fall*slope .and. &
                          (slope_after < -largest_rise*slope .or. maxval(abs(damped%trial)) < before)
         if (.not. (live .and. (sliding .or. near_whirl()))) return
         down = down .or. maxval(abs(damped%trial)) < before*merge(grown, halved, sliding .and. &
                                                                   before < calm_residual*newton%force_scale)
      end function leads_down

      !> Cuts a refused step that brings one gap to the wall where it does so: the energy falls to there, and then rises as steeply
      !> as the wall is stiff. Where several close none of them matters so much.
      subroutine stop_at_contact(better)
         logical, intent(out) :: better
         real(wp) :: deep, travel, part
         integer :: met, e
         better = .false.
         if (.not. (slope < 0.0_wp .and. slope_after > 0.0_wp)) return
         met = 0
         do e = 1, mesh%elements
            if (damped%states(e) /= state_free .or. gaps%state(e) == state_free) cycle
            if (met > 0) return
            met = e
         end do
         if (met == 0) return
         deep = work%displacement(met)
         call go_back(damped%old)
         travel = deep - work%displacement(met)
         if (.not. travel > 0.0_wp) return
         associate (law => gaps%law(met))
            part = min((law%clearance - work%displacement(met))/travel - slope/(law%contact*travel**2), 1.0_wp)
         end associate
         newton%step = part*newton%step
         share = part*share
         slope = part*slope
         call look()
         better = leads_down()
      end subroutine stop_at_contact

      !> Goes on the way of a good damped step while it still falls and no gap changes.
      subroutine draw_out()
         do
            if (.not. slope_after < still_falling*slope .or. row%flips > 0) return
            if (.not. drawn*share*row%lateral_step < drawn_limit*damped%step_limit) return
            call keep()
            damped%drawn_from = state
            newton%step = drawn*newton%step
            share = drawn*share
            slope = drawn*slope
            call go_back(damped%old)
            call look()
            if (slope_after < 0.0_wp .and. row%flips == 0) cycle
            call go_back(damped%drawn_from)
            return
         end do
      end subroutine draw_out

      !> Remembers the states of the gaps.
      subroutine keep()
         damped%states = gaps%state
         damped%flips = gaps%flips
      end subroutine keep

      !> Back to a state and to the gaps that were kept with it.
      subroutine go_back(to)
         real(wp), intent(in) :: to(:, :)
         state = to
         gaps%state = damped%states
         gaps%flips = damped%flips
         row%flips = 0
         known = .false.
         call place_nodes(mesh, state, work)
         call survey_gaps(trajectory, mesh, gaps, work)
         if (vertical) call turning_mode(state, damped%mode)
      end subroutine go_back
   end subroutine iterate_damped

end module dg_damped_newton

!> All numbers of the start and the iteration of beams that are neither physics nor the user's choice. To measure their worth,
!> `fpm run --example bench --flag -O3 -- ablation` solves wells with and without each. A new number is also entered
!> there (`app/bench/bench_ablation.f90`).
module dg_tuning
   use dg_kinds, only: wp
   implicit none
   private
   public :: attempt_type, mesh_try_type, tuning_type

   !> One attempt at a case.
   type :: attempt_type
      integer :: longest = 0               !< its most iterations
      real(wp) :: growth = 0.0_wp          !< growth of rho over the softest at its beginning [-]
      logical :: spread = .false.          !< contact forces of the start are those against soft walls
      logical :: other_place = .false.     !< other place of the gaps: nodes for the extremum, the extremum for nodes
      real(wp) :: reach = 1.0_wp           !< its step limit over step_limit of the deck [-]
   end type attempt_type

   !> A mesh on which a case is tried, and its attempts.
   type :: mesh_try_type
      real(wp) :: length = 1.0_wp          !< longest element over that of the first mesh [-]
      integer :: first = 1, last = 0       !< attempts
   end type mesh_try_type

   !> Step limit of the fourth attempt over that of the first [-]. Where a blade has a millimetre of clearance in a wide hole,
   !> shorter steps do not bring the collars to their side. The fourth attempt solves two of three such cases.
   real(wp), parameter :: long = 15.0_wp

   type :: tuning_type
      ! ---- the attempts at a case (dg_static_analysis)
      !> The attempts in their order. The first converges in three to five iterations for an ordinary string, and in a hundred
      !> for most others. The second begins with contact forces spread by soft walls, and keeps such walls for longer. Gaps
      !> then settle more slowly and more surely. The third has the gaps at their other place, as short packed assemblies may
      !> have no equilibrium at the first place. The fourth takes long steps.
      type(attempt_type) :: attempt(4) = [attempt_type(170, 100.0_wp), attempt_type(150, 1.0_wp, spread=.true.), &
                                          attempt_type(150, 100.0_wp, other_place=.true.), &
                                          attempt_type(100, 100.0_wp, reach=long)]
      !> Number of attempts that are made, at most 4.
      integer :: most_attempts = 4
      !> Iterations of the first attempt for a string in helical buckling. Near lock-up many need 200 to 320. The other
      !> attempts do not find their equilibria.
      integer :: coiled_longest = 400
      !> Iterations without a residual below all before, after which an attempt is given up. Hard wells that converge have at
      !> most 103. Attempts that do not converge would go on for hundreds.
      integer :: longest_stall = 110
      !> Iterations without a residual below all before, after which a string without damping is damped. Where gaps open and close
      !> in turn, its steps may come back to the same place for ever.
      integer :: longest_cycle = 20
      !> The meshes in their order. The first has the lengths of the deck. A string pushed near lock-up is far from the soft
      !> string for which its mesh was made. Shorter elements find its equilibrium.
      type(mesh_try_type) :: mesh(4) = [mesh_try_type(1.0_wp, 1, 4), mesh_try_type(0.25_wp, 1, 3), mesh_try_type(0.5_wp, 1, 2), &
                                        mesh_try_type(0.125_wp, 3, 3)]
      !> Number of meshes that are tried, at most 4.
      integer :: most_meshes = 4
      !> Number of times that elements are cut if the string is outside its hole.
      integer :: most_cuts = 3
      !> Least part of the helical load at which equilibria are checked for stability [-]. Sinusoidal buckling begins at
      !> 1/sqrt(2) of it. Lubinski's first mode of a vertical string begins at 1/2, or at 1/4 in a very long one.
      real(wp) :: damped_share = 0.25_wp

      ! ---- the start (dg_predictor, dg_buckled_start, dg_bent_start, dg_walls)
      !> The softest wall yields to the expected contact load by this part of the clearance [-]. It is as soft as beams of some
      !> metres between two contacts, so that no single gap matters.
      real(wp) :: soft_penetration = 0.1_wp
      !> Parts compressed above their buckling load start as a helix or a sinusoid. Otherwise they start on the low side, with
      !> the imperfection.
      logical :: start_buckled = .true.
      !> They start as their image in a mirror along the hole's vertical plane: helices turn the other way.
      logical :: start_mirrored = .false.
      !> The soft string's line is bent as a beam before it is the start.
      logical :: start_bent = .true.
      !> Largest distance of a node of that line from the axis, over its clearance [-]. Beyond it the start is the line bent
      !> against walls of their own stiffness. A stabilizer's clearance is a thirtieth of a collar's. Soft walls that suit
      !> collars let it out of the hole by all of theirs.
      real(wp) :: start_outside = 1.9_wp
      !> Least distance of a node from the one above, over the length of the element below [-]. Closer nodes start on a smooth
      !> line between others, except at tool joints. A very short element may jump there with the clearance.
      real(wp) :: sliver = 0.4_wp
      !> Least distance of a resultant from the middle of its element, over its length, that places the gap there [-]. Such
      !> distances occur next to places where the string lifts off. Smaller ones come from the load's change along an element.
      real(wp) :: aside = 0.05_wp

      ! ---- contact forces (dg_contact_problem, dg_iteration_state)
      !> Number of times that gaps are opened and closed within one linear problem: most settle in three to five.
      integer :: most_settlings = 10
      !> Factor by which rho grows when few gaps change in a step and the residual is small at its end [-]. It is also the
      !> growth of rho after gaps have moved near an equilibrium.
      real(wp) :: growth = 100.0_wp
      !> Gaps that change over closed gaps, up to which they are few [-].
      real(wp) :: few = 0.05_wp
      !> Residual over the force scale, below which it is small [-].
      real(wp) :: calm = 1.0e-2_wp
      !> Growth from which on rho is the wall's own stiffness, and gaps keep their places [-].
      real(wp) :: stiff = 1.0e4_wp
      !> Largest distance of a gap's new place outside the hole before there is an equilibrium, over the clearance [-]. Farther
      !> out the element is too long for the iteration, and is cut if it stays there.
      real(wp) :: gently = 0.1_wp
      !> Number of times that gaps may move near an equilibrium to the extremum of their element, or begin to follow it.
      integer :: most_moves = 2
      !> Number of further moves of contacts that are then still far from where the string is deepest. Without them the torque
      !> of a string in an enlarged bend is 6 % wrong (`fpm test verification --flag -O3 -- -f lone_contacts.place`).
      integer :: more_moves = 2
      !> Least excess of the string's depth elsewhere in the element of such a contact [m]. At 1 mm more gaps move in vain.
      real(wp) :: astray = 3.0e-3_wp
      !> Iterations after the last move of gaps at which a string is given up, and restored to its state before.
      integer :: longest_round = 25

      ! ---- damping (dg_damping, dg_step)
      !> Least damping of a string in tension, over the stiffness of a wall that yields visibly to its expected load [-].
      real(wp) :: of_soft_wall = 1.0e-2_wp
      !> Part of damping that holds nodes back along the hole [-], where friction slides them.
      real(wp) :: along_hole = 0.1_wp
      !> First damping of a string that had none [-].
      real(wp) :: damping_start = 1.0e-3_wp
      !> Factor of damping after a step that was accepted at first try [-].
      real(wp) :: after_success = 0.3_wp
      !> Factor of damping after a step that was refused before [-]. Each refusal doubles its own factor (Nielsen 1999).
      real(wp) :: after_refusal = 0.8_wp
      !> Factor of damping while the tangent is indefinite, and at the first refusal [-].
      real(wp) :: until_definite = 2.0_wp
      !> Damping is raised by this factor while a node moves by more than the step limit [-].
      real(wp) :: raise_damping = 4.0_wp
      !> Maximum number of increases.
      integer :: most_raises = 8
      !> Residual over the force scale below which an equilibrium is near [-]: there a string that counts as stable is not
      !> damped more.
      real(wp) :: near = 1.0e-4_wp

      ! ---- a string that drifts (dg_held_coils)
      !> Iterations in which few gaps opened, closed or moved, after which a stable sliding string counts as drifting. Attempts
      !> after the first wait twice as long, and until no gap changes.
      integer :: longest_quiet = 15
      !> Stiffness against its sideways motion, in units of damping [-]: half of the damping that a stable equilibrium may
      !> need.
      real(wp) :: hold_stiffness = 0.01_wp
      !> Stiffness where a contact slips, over `hold_stiffness` [-]. With 1 a string that creeps needs two to three times as
      !> many iterations.
      real(wp) :: hold_slipping = 0.01_wp
      !> Largest share of a contact's friction that acts sideways [-]. It reduces friction along the hole by at most 0.13 %.
      !> With 2 % some strings do not converge that converge by themselves.
      real(wp) :: most_held = 0.05_wp

      ! ---- the step (dg_step, dg_line_search, dg_node_moves, dg_equilibrium)
      !> If true, nodes are slid along the hole until elements have the axial forces of the linear problem.
      logical :: keep_lengths = .true.
      !> Slope at a step's end over that at its start, above which the step of a damped string is shortened [-].
      real(wp) :: uphill = 0.3_wp
      !> Largest number of times that it is shortened.
      integer :: most_searches = 3
      !> Least factor of a shortening [-].
      real(wp) :: shortest = 0.1_wp
      !> Largest factor of a shortening [-].
      real(wp) :: longest = 0.7_wp
      !> Slope at a step's end over that at its start, above which the step is refused [-].
      real(wp) :: refused = 0.6_wp
      !> Largest lateral change by the last step of a compressed string in equilibrium, over its largest clearance [-]. Near
      !> its buckling load almost no force moves it.
      real(wp) :: still = 1.0e-4_wp
      !> Residual over the force scale below which elements are cut and gaps are moved [-]: Newton's last steps change neither.
      real(wp) :: nearly = 1.0e-3_wp
   end type tuning_type
end module dg_tuning

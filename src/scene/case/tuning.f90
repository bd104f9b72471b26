!> Every number that steers the start and the iteration of beams, and is neither physics nor the user's choice. What each of them
!> is worth: `fpm run --example bench --profile release -- ablation` solves wells with it and without it; a new number is entered
!> there, too (`app/bench/bench_ablation.f90`).
module dg_tuning
   use dg_kinds, only: wp
   implicit none
   private
   public :: attempt_type, tuning_type

   !> One attempt at a case.
   type :: attempt_type
      integer :: longest = 0               !< iterations that it may have
      real(wp) :: growth = 0.0_wp          !< of rho over the softest, to begin with [-]
      logical :: spread = .false.          !< contact forces of the start are those against soft walls
      logical :: other_place = .false.     !< of the gaps: nodes for the extremum, the extremum for nodes
      real(wp) :: reach = 1.0_wp           !< its step limit over step_limit of the deck [-]
   end type attempt_type

   !> A mesh that a case is tried on, and the attempts that are made there.
   type :: mesh_try_type
      real(wp) :: length = 1.0_wp          !< of the longest element over that of the first mesh [-]
      integer :: first = 1, last = 0       !< attempts
   end type mesh_try_type

   !> Step limit of the fourth attempt over that of the first [-]. Where a blade has a millimetre of room in a wide hole, the steps
   !> of the others are too short to bring the collars to their side: 24 of 50 such cases are lost without the fourth, 7 with it.
   real(wp), parameter :: long = 15.0_wp

   type :: tuning_type
      ! ---- the attempts at a case (dg_static_analysis)
      !> The attempts in their order. The first finds an ordinary string's equilibrium in three to five iterations, and that of most
      !> others in a hundred. The second begins with contact forces that soft walls spread, and has such walls for longer: gaps
      !> settle more slowly and more surely. The third has the gaps at their other place: short packed assemblies may have no
      !> equilibrium at the place asked for. The fourth takes long steps.
      type(attempt_type) :: attempt(4) = [attempt_type(170, 100.0_wp), attempt_type(150, 1.0_wp, spread=.true.), &
                                          attempt_type(150, 100.0_wp, other_place=.true.), &
                                          attempt_type(100, 100.0_wp, reach=long)]
      !> Number of attempts that are made, at most 4.
      integer :: most_attempts = 4
      !> Iterations of the first attempt at a string that coils. Near lock-up many need 200 to 320. The other attempts did not find
      !> their equilibria.
      integer :: coiled_longest = 400
      !> Iterations without a residual less than all before, after which an attempt is given up. Hard wells that converge have at
      !> most 103. Attempts that find nothing go on for hundreds.
      integer :: longest_stall = 110
      !> The meshes in their order. The first is the one asked for. A string that is pushed near lock-up lies far from the soft
      !> string that its mesh was made for: shorter elements find its equilibrium.
      type(mesh_try_type) :: mesh(4) = [mesh_try_type(1.0_wp, 1, 4), mesh_try_type(0.25_wp, 1, 3), mesh_try_type(0.5_wp, 1, 2), &
                                        mesh_try_type(0.125_wp, 3, 3)]
      !> Number of meshes that are tried, at most 4.
      integer :: most_meshes = 4
      !> Times that elements are cut where the string stands outside its hole.
      integer :: most_cuts = 3
      !> Part of the helical load from which equilibria are checked for stability [-]. Sinusoidal buckling comes at 1/sqrt(2) of it,
      !> Lubinski's first mode of a vertical string at 1/2, at 1/4 when it is very long.
      real(wp) :: damped_share = 0.25_wp

      ! ---- the start (dg_predictor, dg_buckled_start, dg_bent_start, dg_walls)
      !> The softest wall yields to the expected contact load by this part of the clearance [-]: as soft as beams of some metres are
      !> between two contacts, so that no single gap matters.
      real(wp) :: soft_penetration = 0.1_wp
      !> Parts compressed beyond their buckling load start as a helix or a snake. Without that they start on the low side, with the
      !> imperfection.
      logical :: start_buckled = .true.
      !> They start as the image of that in a mirror along the hole's vertical plane: coils turn the other way.
      logical :: start_mirrored = .false.
      !> The soft string's line is bent as a beam before it is the start.
      logical :: start_bent = .true.
      !> Where a node of that line lies farther off the axis than so many times its clearance, the start is the line bent against
      !> walls of their own stiffness [-]: a stabilizer's clearance is a thirtieth of a collar's, and soft walls that suit collars
      !> let it out of the hole by all of theirs. With two a motor in a lateral took 13 times the iterations. Without a bound
      !> elements of 1 m take three times as many.
      real(wp) :: start_outside = 1.9_wp
      !> Nodes closer than this to one above, over the length of the element below, start on a smooth line between others, but at
      !> tool joints [-]: a sliver may jump there with the clearance.
      real(wp) :: sliver = 0.4_wp
      !> A resultant so far off the middle of its element, over its length, places the gap there [-]: next to places that the string
      !> lifts off from. Less comes of the load's change along an element.
      real(wp) :: aside = 0.05_wp

      ! ---- contact forces (dg_contact_problem, dg_iteration_state)
      !> Times that gaps are opened and closed within one linear problem: most settle in three to five. With one, 15 of 53 hard
      !> wells found no equilibrium, with ten 11.
      integer :: most_settlings = 10
      !> rho grows by this when few gaps change in a step and the residual is small at its end, and is so many times the softest
      !> again when gaps have moved near an equilibrium [-]. Judged by the residual at the step's begin it grew one iteration later.
      real(wp) :: growth = 100.0_wp
      !> Gaps that change over those closed, at which that is few [-].
      real(wp) :: few = 0.05_wp
      !> Residual over the force scale at which it is small [-].
      real(wp) :: calm = 1.0e-2_wp
      !> From this growth on rho is the wall's own, and gaps stay where they are [-].
      real(wp) :: stiff = 1.0e4_wp
      !> Largest distance of a gap's new place outside the hole before there is an equilibrium, over the clearance [-]. Farther out
      !> the element is too long for the iteration, and is cut where it stays so.
      real(wp) :: gently = 0.1_wp
      !> Times that gaps may move near an equilibrium to the extremum of their element, or begin to follow it. Four cost more
      !> iterations and gain nothing.
      integer :: most_moves = 2
      !> Times more that contacts may which are then still far from where the string is deepest. Without that torque of a string in
      !> an enlarged bend is 6 % off: `fpm test verification -- -f lone_contacts.place` fails. Of 1,105 decks of an independent
      !> reviewer 54 cases have contact more than 1 % off that on short elements, not 59.
      integer :: more_moves = 2
      !> Depth by which the string must be deeper elsewhere in the element of such a contact [m]. At 1 mm more gaps move in vain.
      real(wp) :: astray = 3.0e-3_wp
      !> Iterations after its gaps last moved at which a string is given up, and taken back to where it was before.
      integer :: longest_round = 25

      ! ---- damping (dg_damping, dg_step)
      !> Least damping of a string that may be all in tension, over the stiffness of a wall that its expected load presses in
      !> visibly [-].
      real(wp) :: of_soft_wall = 1.0e-2_wp
      !> The part of damping that holds nodes back along the hole [-]: friction that slides them drives that, too.
      real(wp) :: along_hole = 0.1_wp
      !> First damping of a string that had none [-].
      real(wp) :: damping_start = 1.0e-3_wp
      !> Factor of damping after a step that was accepted at first try [-].
      real(wp) :: after_success = 0.3_wp
      !> What is left of damping after a step that was refused before [-]. Each refusal doubles its own factor (Nielsen 1999).
      real(wp) :: after_refusal = 0.8_wp
      !> Factor of damping while the tangent is indefinite, and at the first refusal [-].
      real(wp) :: until_definite = 2.0_wp
      !> Damping is raised by this factor while a node moves by more than the step limit [-].
      real(wp) :: raise_damping = 4.0_wp
      !> Maximum number of increases.
      integer :: most_raises = 8
      !> Residual over the force scale next to an equilibrium [-]: there a string that would count as stable is not held.
      real(wp) :: near = 1.0e-4_wp

      ! ---- a string that drifts (dg_held_coils)
      !> Iterations in which no gap opened, closed or moved, after which a stable string that slides is taken to drift. With 20
      !> two of 600 wells are held that come to rest by themselves.
      integer :: longest_quiet = 30
      !> Stiffness against its sideways motion, in units of damping [-]: half of what a stable equilibrium may need.
      real(wp) :: hold_stiffness = 0.01_wp
      !> Largest share of a contact's friction that acts sideways [-]. It takes 0.13 % off friction along the hole at most. With 2 %
      !> two of 600 wells find no equilibrium that find one by themselves.
      real(wp) :: most_held = 0.05_wp

      ! ---- the step (dg_step, dg_line_search, dg_node_moves, dg_equilibrium)
      !> Nodes are slid along the hole until elements have the axial forces of the linear problem.
      logical :: keep_lengths = .true.
      !> A slope at a step's end over that at its start from which the step of a damped string is shortened [-].
      real(wp) :: uphill = 0.3_wp
      !> Times that it is shortened.
      integer :: most_searches = 3
      !> Each time to no less than this part [-].
      real(wp) :: shortest = 0.1_wp
      !> And to no more than this part [-].
      real(wp) :: longest = 0.7_wp
      !> A slope at a step's end over that at its start by which the step is refused [-].
      real(wp) :: refused = 0.6_wp
      !> Largest lateral change by the last step of a compressed string, over the string's largest clearance, at which it is in
      !> equilibrium [-]: near its buckling load next to no force moves it.
      real(wp) :: still = 1.0e-4_wp
      !> Residual over the force scale from which on elements are cut and gaps are moved [-]: Newton's last steps change neither.
      real(wp) :: nearly = 1.0e-3_wp
   end type tuning_type
end module dg_tuning

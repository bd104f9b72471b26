!> Settings of the solution that a deck may change. Ranges are in dg_deck_keys, all other numbers of the iteration in
!> dg_tuning.
module dg_numerics
   use dg_kinds, only: wp
   use dg_key_visitor, only: key_visitor_type
   use dg_linear_solver_name, only: solver_banded, solver_block, solver_name, solver_sparse
   use dg_text, only: lower_case, quoted
   use dg_tuning, only: tuning_type
   implicit none
   private
   public :: numerics_type, default_wall, patience, settings_of_attempt, visit_numerics, smears_all_joints
   public :: gap_at_extremum, gap_at_nodes
   public :: gap_location_count, gap_location_name
   public :: fidelity_name, settings_of, set_fidelity
   public :: solver_banded, solver_block, solver_name, solver_sparse

   integer, parameter :: gap_at_extremum = 1 !< the paper's x0, Eq. 2
   integer, parameter :: gap_at_nodes = 2    !< fixed points: the cheap alternative
   integer, parameter :: gap_location_count = 2
   !> Names in decks, in the order of the numbers above.
   character(*), parameter :: gap_location_name(gap_location_count) = [character(8) :: 'extremum', 'nodes']

   integer, parameter :: fidelity_count = 4
   !> Names in decks. With auto the local scale limits elements. fast is the same with fixed gaps and a loose tolerance.
   !> standard and reference have a fine mesh everywhere. All but fast find moments on elements short enough for them, and solve
   !> tool joints one by one where that matters.
   !> reference proves these by halving the elements.
   character(*), parameter :: fidelity_name(fidelity_count) = [character(9) :: 'auto', 'fast', 'standard', 'reference']
   !> Longest element of each [m].
   real(wp), parameter :: fidelity_length(fidelity_count) = [30.0_wp, 60.0_wp, 10.0_wp, 1.0_wp]
   !> Length of string below which elements of auto become shorter [m]. Strings of some hundred metres, as stabilized
   !> assemblies in bends, are solved in hundredths of a second. On elements of 30 m contact and drag were up to 0.4 % wrong.
   real(wp), parameter :: auto_full_length = 1500.0_wp
   !> Tolerance of `fast` [-]: a hook load of 700 kN to a newton.
   real(wp), parameter :: fast_tolerance = 1.0e-6_wp

   !> Relative compression over which the wall yields elastically before it counts as rigid [-]. It holds without a setting of
   !> the deck and without a mud sheath. 5 % of the clearance is 2 mm in a usual hole.
   real(wp), parameter :: default_elastic_share = 0.05_wp

   !> Default stiffness of a wall [N/m2]: half of solid steel's, as good as rigid.
   real(wp), parameter :: default_wall = 1.0e11_wp

   type :: numerics_type
      real(wp) :: element_length = 10.0_wp     !< longest element [m]
      real(wp) :: full_length = 0.0_wp         !< string below which longest elements shrink with its square [m]; 0: none
      integer :: gap_location = gap_at_extremum
      !> Largest residual force over the string's weight (and moment over weight times one metre) at convergence [-].
      !> Round-off of the residual is near 1e-14.
      real(wp) :: tolerance = 1.0e-9_wp
      logical :: discrete_joints = .false.     !< tool joints touch one by one, not smeared along their component
      logical :: joints_by_need = .true.       !< beams: one by one where compressed pipe bows out between; soft string: it does
      logical :: moments = .false.             !< moments are found on elements short enough for them
      logical :: halve_moments = .false.       !< these elements are halved until moments do not change, which proves them
      logical :: friction_range = .true.       !< sliding strings in helical buckling are also solved from a second start
      integer :: linear_solver = solver_block  !< number of one of solver_name
      integer :: max_iterations = 1300         !< of all attempts at a case together
      integer :: load_steps = 1                !< increments of friction and bit loads
      real(wp) :: gk_min = 1.0e-3_wp           !< compressive rigidity of a free MCGE [N/m2]: Gkmin of Eq. 7
      real(wp) :: gk_contact = default_wall    !< of a wall in elastic contact [N/m2]: Gkc of Eq. 8
      real(wp) :: gk_max = 1.0e12_wp           !< of a rigid wall [N/m2]: Gkmax
      real(wp) :: eps_n0 = 1.0e-8_wp           !< threshold of relative compression [-]: Eqs. 7-8
      real(wp) :: eps_nmax = default_elastic_share !< relative compression at which elastic turns to rigid [-]: Eq. 8
      real(wp) :: r_n0 = 1.0e-3_wp             !< threshold of contact force [N]: Eqs. 7-8
      real(wp) :: relocation = 0.5_wp          !< least gain in depth, over c, for which a closed MCGE moves [-]
      real(wp) :: step_limit = 2.0_wp          !< lateral step over the clearance above which damping is raised [-]
      real(wp) :: imperfection = 1.0e-3_wp     !< seeded lateral offset of compressed parts over the clearance [-]
      logical :: wall_climb = .false.          !< soft, rigid, mixed: a turning string climbs the wall
      logical :: mixed_elements = .false.      !< mixed: finite elements next to the bit, not a rigid string
      logical :: history = .false.             !< keep and write the iteration history
      type(tuning_type) :: tuning              !< numbers of start and iteration that no deck changes
      character(50) :: unknown_fidelity = ''   !< a name that settings_of does not know, in quotes; new_model refuses it
   end type numerics_type

contains

   !> Visit the numbers that a deck may set.
   subroutine visit_numerics(numerics, visitor)
      type(numerics_type), intent(inout) :: numerics
      class(key_visitor_type), intent(inout) :: visitor
      call visitor%number('element_length', numerics%element_length)
      call visitor%number('tolerance', numerics%tolerance)
      call visitor%whole('max_iterations', numerics%max_iterations)
      call visitor%whole('load_steps', numerics%load_steps)
      call visitor%number('gk_min', numerics%gk_min)
      call visitor%number('gk_contact', numerics%gk_contact)
      call visitor%number('gk_max', numerics%gk_max)
      call visitor%number('eps_n0', numerics%eps_n0)
      call visitor%number('eps_nmax', numerics%eps_nmax)
      call visitor%number('r_n0', numerics%r_n0)
      call visitor%number('relocation', numerics%relocation)
      call visitor%number('step_limit', numerics%step_limit)
      call visitor%number('imperfection', numerics%imperfection)
   end subroutine visit_numerics

   !> True if pipe never bows out to the wall between its tool joints: they are smeared in every case, also of the soft string.
   pure function smears_all_joints(numerics) result(smears)
      type(numerics_type), intent(in) :: numerics
      logical :: smears
      smears = .not. (numerics%discrete_joints .or. numerics%joints_by_need)
   end function smears_all_joints

   !> Settings of a fidelity by its name, in any letter case. new_model refuses settings of an unknown name.
   pure function settings_of(fidelity) result(numerics)
      character(*), intent(in) :: fidelity
      type(numerics_type) :: numerics
      call set_fidelity(numerics, fidelity)
   end function settings_of

   !> Length of an attempt, and of a stall in it, over the default [-]. All attempts together use max_iterations. If that is
   !> below its default, fewer attempts are made, which are not shorter.
   pure function patience(numerics) result(times)
      type(numerics_type), intent(in) :: numerics
      type(numerics_type) :: usual
      real(wp) :: times
      times = max(1.0_wp, real(numerics%max_iterations, wp)/real(usual%max_iterations, wp))
   end function patience

   !> Settings of one attempt: its iterations, its stall, its steps, the place of its gaps.
   pure function settings_of_attempt(numerics, number, coils) result(settings)
      type(numerics_type), intent(in) :: numerics   !< of the case
      integer, intent(in) :: number                 !< of the attempt
      logical, intent(in) :: coils                  !< true if the string is compressed above the helical load
      type(numerics_type) :: settings
      real(wp) :: times
      settings = numerics
      times = patience(numerics)
      associate (attempt => numerics%tuning%attempt(number))
         settings%max_iterations = nint(times*attempt%longest)
         if (number == 1 .and. coils) settings%max_iterations = nint(times*numerics%tuning%coiled_longest)
         settings%tuning%longest_stall = nint(times*numerics%tuning%longest_stall)
         settings%step_limit = attempt%reach*numerics%step_limit
         if (attempt%other_place) settings%gap_location = other_location(numerics%gap_location)
      end associate
   end function settings_of_attempt

   !> The other place of the gaps.
   elemental function other_location(location) result(other)
      integer, intent(in) :: location
      integer :: other
      other = merge(gap_at_extremum, gap_at_nodes, location == gap_at_nodes)
   end function other_location

   !> Change the settings that a fidelity decides, and keep the others.
   pure subroutine set_fidelity(numerics, fidelity)
      type(numerics_type), intent(inout) :: numerics
      character(*), intent(in) :: fidelity   !< an unknown one is noted, and changes no number
      type(numerics_type) :: defaults
      integer :: i
      numerics%unknown_fidelity = quoted(fidelity)
      do i = 1, fidelity_count
         if (lower_case(fidelity) /= fidelity_name(i)) cycle
         numerics%unknown_fidelity = ''
         numerics%element_length = fidelity_length(i)
         numerics%full_length = merge(auto_full_length, 0.0_wp, fidelity_name(i) == 'auto')
         numerics%gap_location = merge(gap_at_nodes, defaults%gap_location, fidelity_name(i) == 'fast')
         numerics%tolerance = merge(fast_tolerance, defaults%tolerance, fidelity_name(i) == 'fast')
         numerics%moments = fidelity_name(i) /= 'fast'
         numerics%joints_by_need = fidelity_name(i) /= 'fast'
         numerics%halve_moments = fidelity_name(i) == 'reference'
      end do
   end subroutine set_fidelity
end module dg_numerics

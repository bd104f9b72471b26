!> Result of any model for one load case. SI units.
module dg_case_result
   use dg_kinds, only: wp
   use dg_missing, only: missing, missing_count, optional_real
   use dg_profile, only: profile_type
   implicit none
   private
   public :: case_result_type, gap_row_type, iteration_type, unlike_contact_type
   public :: judged_start, judged_whole, judged_energy, judged_residual, judged_refused, judged_name
   public :: scale_compression, scale_bend, scale_load, scale_joint, scale_end, scale_neighbour, scale_count, scale_name
   public :: result_converged, result_not_converged, result_locked_up, result_status_name
   public :: add_sentence, has_numbers, is_pushed, push_needed, without_load_type
   public :: contact_point_type, contact_joint, contact_blades, contact_edge, contact_bit, contact_top, contact_centralizer, &
             contact_name

   integer, parameter :: result_converged = 1
   integer, parameter :: result_not_converged = 2
   integer, parameter :: result_locked_up = 3
   !> Names in files, in the order of the numbers above.
   character(*), parameter :: result_status_name(3) = [character(13) :: 'converged', 'not_converged', 'locked_up']
   !> Said of a hook load below zero, by more than this part of the largest axial force: round-off is a thousandth of that [-].
   character(*), parameter :: push_needed = 'The hook load is below zero. The string must be pushed at surface'
   real(wp), parameter :: pushed_from = 1.0e-6_wp

   !> Judgement of a step of the iteration, and names in files. In order: no step yet; whole step, without damping; accepted by
   !> the slope of the energy; accepted by a smaller residual; refused.
   integer, parameter :: judged_start = 1, judged_whole = 2, judged_energy = 3, judged_residual = 4, judged_refused = 5
   character(*), parameter :: judged_name(5) = [character(8) :: 'start', 'whole', 'energy', 'residual', 'refused']

   !> Local scales that may ask for shorter elements, and their names in reports.
   integer, parameter :: scale_compression = 1, scale_bend = 2, scale_load = 3, scale_joint = 4, scale_end = 5, &
                         scale_neighbour = 6
   integer, parameter :: scale_count = 6
   character(*), parameter :: scale_name(scale_count) = [character(16) :: 'compression', 'bends', 'side load', 'tool joints', &
      'free ends', 'short neighbours']

   !> Part that presses the wall at one place, and names in files.
   integer, parameter :: contact_joint = 1, contact_blades = 2, contact_edge = 3, contact_bit = 4, contact_top = 5, &
                         contact_centralizer = 6
   character(*), parameter :: contact_name(6) = [character(11) :: 'tool joint', 'stabilizer', 'edge', 'bit', 'top', 'centralizer']

   !> A contact force that acts over a short length.
   type :: contact_point_type
      integer :: kind = 0
      real(wp) :: md = 0.0_wp                  !< centroid of the force [m]
      real(wp) :: force = 0.0_wp               !< [N]
      real(wp) :: length = 0.0_wp              !< over which it acts [m]
      real(wp) :: clock = 0.0_wp               !< towards where it presses the wall [rad], as in a profile
   end type contact_point_type

   !> One row of the iteration history.
   type :: iteration_type
      integer :: attempt = 0                   !< at the case, from 1
      integer :: increment = 0                 !< load step
      integer :: stage = 1                     !< of the mesh: one more each time that elements are cut
      integer :: iteration = 0                 !< within the case
      real(wp) :: residual_force = 0.0_wp      !< largest nodal residual [N]
      real(wp) :: residual_moment = 0.0_wp     !< largest nodal residual [N.m]
      real(wp) :: lateral_step = 0.0_wp        !< largest lateral change [m]
      real(wp) :: damping = 0.0_wp             !< of the step that led here, in units of F^2/(4 EI) [-]
      integer :: judged = judged_start         !< what judged the step that led here
      integer :: negative_pivots = missing_count !< negative eigenvalues of the step's matrix; missing: not known
      integer :: contacts = 0                  !< gaps in contact
      integer :: flips = 0                     !< gaps that changed state
      integer :: moves = 0                     !< gaps that moved to another x0
      real(wp) :: hookload = 0.0_wp            !< [N]
   end type iteration_type

   !> One row of the state table as it stands at the end: the gap of one element.
   type :: gap_row_type
      real(wp) :: md = 0.0_wp                  !< of its place x0 [m]
      integer :: state = 0                     !< free, elastic, rigid (dg_named_states)
      real(wp) :: force = 0.0_wp               !< contact force, >= 0 [N]
      integer :: flips = 0                     !< changes of state in all
      integer :: moves = 0                     !< changes of place in all
   end type gap_row_type

   !> Difference between the contact force of the analysis and that of the beam which gives its moments.
   type :: unlike_contact_type
      real(wp) :: by_analysis = 0.0_wp   !< contact force of the whole string [N]
      real(wp) :: by_beam = 0.0_wp       !< the same of the beam [N]
      real(wp) :: warned = 0.0_wp        !< difference over that of the analysis, where a warning names it; else 0 [-]
      real(wp) :: share = 0.0_wp         !< difference in the part where they differ most, over the larger of both [-]
      real(wp) :: md(2) = 0.0_wp         !< where that part begins and ends [m]
      real(wp) :: yielding = 0.0_wp      !< part of the beam's contact that goes where walls yield a little more [-]
      real(wp) :: point = 0.0_wp         !< where the beam presses its wall most per length [m]
      real(wp) :: wall = 0.0_wp          !< stiffness of the wall there [N/m2]
   end type unlike_contact_type

   !> Result of a case without its weight on bit.
   type :: without_load_type
      integer :: status = result_not_converged   !< that, too, where it was not looked at
      real(wp) :: hookload = 0.0_wp              !< of a converged one [N]
      real(wp) :: friction_scale = 1.0_wp        !< of all friction, with which the soft string has that hook load [-]
   end type without_load_type

   !> Values at which string weight is just enough, by beams, all else equal. Absent where they were not looked for or not found.
   type :: weight_limits_type
      type(optional_real) :: friction            !< factor on all friction [-]
      type(optional_real) :: wob                 !< [N]
      type(optional_real) :: reach               !< bit depth [m]
      type(optional_real) :: friction_scale      !< on the friction of the soft string, which has the beams' hook load there [-]
      integer :: iterations = 0                  !< of all solutions for them
   end type weight_limits_type

   type :: case_result_type
      integer :: case_index = 0                !< in model%cases
      integer :: model = 0                     !< number of the model (dg_job)
      integer :: status = result_not_converged
      character(:), allocatable :: message     !< reason and remedy where not converged, warnings else; may be ''
      integer :: attempts = 0                  !< on the last mesh; beams only
      real(wp) :: inclination = 0.0_wp         !< of the hole at the bit [rad]
      real(wp) :: hookload = 0.0_wp            !< axial force held at the top [N]
      real(wp) :: weight_indicator = missing   !< what the rig's indicator shows of it; missing where no rig is given [N]
      real(wp) :: friction = 0.0_wp            !< buoyed axial weight - compression of the lower end - hookload [N]
      real(wp) :: torque = 0.0_wp              !< at the top [N.m]
      real(wp) :: normal_force = 0.0_wp        !< sum of contact forces over the string [N]
      integer :: iterations = 0
      integer :: elements = 0
      real(wp) :: element_lengths(2) = 0.0_wp  !< shortest and longest element [m]; 0 where the model has none
      integer :: shortened(scale_count) = 0    !< intervals cut finer, by the local scale that asked; elements that grading added
      real(wp) :: seconds = 0.0_wp             !< wall time of this case's solution alone
      type(profile_type) :: profile
      !> State table summary: gaps by state at the end (free, elastic, rigid), and flips and moves in all.
      integer :: states(0:2) = 0
      integer :: flips = 0
      integer :: moves = 0
      !> Part by which compression could still grow until the tangent is indefinite, at constant contact forces (dg_stability)
      !> [-]. 1 stands for more. It is missing if the string is not compressed enough.
      real(wp) :: stability_margin = missing
      logical :: coiled = .false.              !< the string is compressed beyond its helical load: it may lie in more than one way
      !> Greatest weight on bit that a push brings down which the pipe bears, or minus the pull at the bit that is needed; missing
      !> where not locked up [N].
      real(wp) :: lock_up_load = missing
      real(wp) :: weight_on_bit = missing          !< that a given hook load brings [N]
      type(without_load_type) :: without_load  !< of a string that goes down and locks up or must be pushed
      type(weight_limits_type) :: weight_limits  !< of a buckled string that goes down
      !> Friction that smeared tool joints leave out, a rough number by the soft string; huge: the string may lock up by it [N].
      real(wp) :: left_out_friction = 0.0_wp
      logical :: joints_apart = .false.        !< tool joints were solved one by one, though the model smears them
      integer :: beam_nodes = 0                !< of the beam on which the moments of the profile were found; 0: of none
      !> Estimated error of moments of the profile, over the largest [-]; missing where it was not estimated.
      real(wp) :: moment_error = missing
      !> Where the contact force of that beam differs most from that of the analysis.
      type(unlike_contact_type) :: unlike_contact
      !> Force of a bit that the formation holds on the axis, across the hole [N], and its clock angle [rad]. Missing if the
      !> bit is not held, and without elements.
      real(wp) :: bit_side_force = missing
      real(wp) :: bit_side_clock = missing
      !> Angle between bit and hole axis, and the clock angle to which it points [rad]; missing without elements.
      real(wp) :: bit_tilt = missing
      real(wp) :: bit_tilt_clock = missing
      !> Inclination of the hole axis less that of the string at its lowest survey sensor [rad]; missing without one.
      real(wp) :: sag_correction = missing
      real(wp) :: sensor_md = missing          !< measured depth of that sensor [m]
      !> Length by which bends of the string off the hole axis bring its ends together [m]; missing without short elements.
      real(wp) :: shortening = missing
      !> Residual of the global equilibrium, supports included: force [N], moment about the top [N.m].
      real(wp) :: equilibrium_force = 0.0_wp
      real(wp) :: equilibrium_moment = 0.0_wp
      type(gap_row_type), allocatable :: gaps(:)     !< from the top down; models with gap elements only
      !> Concentrated contacts from the top down; not allocated where moments were not looked for on short elements.
      type(contact_point_type), allocatable :: contacts(:)
      type(iteration_type), allocatable :: history(:)
   end type case_result_type

contains

   !> True where a result of this status has numbers to show. One that did not converge or is locked up has none, in no table, file
   !> or picture.
   elemental function has_numbers(status) result(has)
      integer, intent(in) :: status      !< result_converged, result_not_converged or result_locked_up
      logical :: has
      has = status == result_converged
   end function has_numbers

   !> Add a sentence, or several, to a message; '' adds nothing.
   pure subroutine add_sentence(message, sentence)
      character(:), allocatable, intent(inout) :: message
      character(*), intent(in) :: sentence      !< without the full stop at its end
      if (message /= '' .and. sentence /= '') message = message//'. '
      message = message//sentence
   end subroutine add_sentence

   !> True if a string would have to be pushed at surface, as `push_needed` says.
   pure function is_pushed(hookload, axial) result(pushed)
      real(wp), intent(in) :: hookload   !< [N]
      real(wp), intent(in) :: axial(:)   !< along the string [N]
      logical :: pushed
      pushed = hookload < -pushed_from*maxval(abs(axial))
   end function is_pushed
end module dg_case_result

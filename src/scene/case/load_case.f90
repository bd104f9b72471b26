!> A load case: operation of the string, bit depth, loads.
module dg_load_case
   use dg_kinds, only: wp
   use dg_key_visitor, only: key_visitor_type
   use dg_missing, only: optional_real
   use dg_text, only: lower_case
   implicit none
   private
   public :: load_case_type
   public :: operation_trip_out, operation_trip_in, operation_rotate_off_bottom, operation_rotary_drilling
   public :: operation_sliding_drilling, operation_ream, operation_backream, operation_static
   public :: operation_count, operation_name, operation_label, operation_from_name, friction_split, alike, operation_aliases
   public :: drills, moves_axially, rotates, visit_case

   integer, parameter :: operation_trip_out = 1
   integer, parameter :: operation_trip_in = 2
   integer, parameter :: operation_rotate_off_bottom = 3
   integer, parameter :: operation_rotary_drilling = 4
   integer, parameter :: operation_sliding_drilling = 5
   integer, parameter :: operation_ream = 6
   integer, parameter :: operation_backream = 7
   integer, parameter :: operation_static = 8
   integer, parameter :: operation_count = 8

   !> An operation.
   type :: operation_type
      character(18) :: name = ''      !< in decks and files
      character(18) :: label = ''     !< as the paper's Table 1 writes it
      integer :: block = 0            !< motion of the block: 1 raised, -1 lowered, 0 still
      integer :: string = 0           !< motion of the string along the hole against friction: 1 up, -1 down, 0 none
      logical :: turns = .false.      !< the string rotates
   end type operation_type

   !> All operations, in the order of the numbers above.
   type(operation_type), parameter :: operations(operation_count) = [ &
      operation_type('trip_out', 'up', block=1, string=1), &
      operation_type('trip_in', 'down', block=-1, string=-1), &
      operation_type('rotate_off_bottom', 'rotating', turns=.true.), &
      operation_type('rotary_drilling', 'rotary drilling', block=-1, turns=.true.), &
      operation_type('sliding_drilling', 'sliding drilling', block=-1, string=-1), &
      operation_type('ream', 'ream', block=-1, string=-1, turns=.true.), &
      operation_type('backream', 'backream', block=1, string=1, turns=.true.), &
      operation_type('static', 'static')]

   character(*), parameter :: operation_name(operation_count) = operations%name
   character(*), parameter :: operation_label(operation_count) = operations%label
   integer, parameter, public :: block_way(operation_count) = operations%block

   !> Another name of an operation.
   type :: alias_type
      character(20) :: name = ''
      integer :: operation = 0
      logical :: is_listed = .false.   !< the error of an unknown operation names it
   end type alias_type

   !> Other names that a deck may use. Letter case, blanks, hyphens and underscores do not count: pick_up, pickup, PICK-UP.
   !> The paper's short names come first.
   type(alias_type), parameter :: operation_aliases(*) = [ &
      alias_type('up', operation_trip_out), &
      alias_type('down', operation_trip_in), &
      alias_type('rotary', operation_rotary_drilling), &
      alias_type('sliding', operation_sliding_drilling), &
      alias_type('pick_up', operation_trip_out, .true.), &
      alias_type('picking_up', operation_trip_out), &
      alias_type('pooh', operation_trip_out, .true.), &
      alias_type('poh', operation_trip_out), &
      alias_type('pull_out', operation_trip_out), &
      alias_type('pull_out_of_hole', operation_trip_out), &
      alias_type('pulling_out', operation_trip_out), &
      alias_type('tripping_out', operation_trip_out), &
      alias_type('slack_off', operation_trip_in, .true.), &
      alias_type('slacking_off', operation_trip_in), &
      alias_type('rih', operation_trip_in, .true.), &
      alias_type('run_in', operation_trip_in), &
      alias_type('run_in_hole', operation_trip_in), &
      alias_type('running_in', operation_trip_in), &
      alias_type('tripping_in', operation_trip_in), &
      alias_type('rotate', operation_rotate_off_bottom), &
      alias_type('rotating', operation_rotate_off_bottom), &
      alias_type('rob', operation_rotate_off_bottom), &
      alias_type('rotating_off_bottom', operation_rotate_off_bottom), &
      alias_type('drill', operation_rotary_drilling), &
      alias_type('drilling', operation_rotary_drilling, .true.), &
      alias_type('rotate_on_bottom', operation_rotary_drilling), &
      alias_type('rotating_on_bottom', operation_rotary_drilling), &
      alias_type('rotate_drilling', operation_rotary_drilling), &
      alias_type('slide', operation_sliding_drilling, .true.), &
      alias_type('slide_drilling', operation_sliding_drilling), &
      alias_type('reaming', operation_ream), &
      alias_type('backreaming', operation_backream)]

   type :: load_case_type
      character(:), allocatable :: name     !< unique, safe as part of a file name
      character(:), allocatable :: section  !< label of the hole section in tables
      character(:), allocatable :: string   !< name of the drillstring
      integer :: operation = operation_static
      real(wp) :: bit_depth = 0.0_wp        !< measured depth of the bit [m]
      real(wp) :: wob = 0.0_wp              !< weight on bit [N]; > 0 pushes the bit, < 0 pulls it
      real(wp) :: tob = 0.0_wp              !< torque on bit [N.m], >= 0
      type(optional_real) :: friction_axial  !< overrides mu2 of every hole section [-]
      type(optional_real) :: friction_rotary !< overrides mu1 of every hole section [-]
      real(wp) :: angular_speed = 0.0_wp    !< of the string [rad/s], >= 0
      real(wp) :: hours = 0.0_wp            !< time of rotation at that speed [h], >= 0
      real(wp) :: trip_speed = 0.0_wp       !< axial, of the string [m/s], >= 0
      real(wp) :: toolface = 0.0_wp         !< direction of bends of the string: from the high side (north), clockwise [rad]
      logical :: bend_stands = .false.      !< a string that turns keeps its bends, at this tool face; else it is straight
      real(wp) :: pump_pressure = 0.0_wp    !< added to the pressure inside [Pa], >= 0
      real(wp) :: annulus_pressure = 0.0_wp !< added to the pressure outside [Pa], >= 0
      type(optional_real) :: inside_density !< of the fluid inside, instead of the mud [kg/m3]
      real(wp) :: temperature_change_top = 0.0_wp      !< of the string at surface, since it was run [K]
      real(wp) :: temperature_change_bottom = 0.0_wp   !< the same at the bit; linear in true vertical depth between [K]
      real(wp) :: above_ambient_top = 0.0_wp           !< temperature of the string at surface, >= 0 [K]
      real(wp) :: above_ambient_bottom = 0.0_wp        !< the same at the bit; linear in true vertical depth between [K]
      integer :: length_reference = 0       !< number of the load case from which a change of length counts, 0: none
      type(optional_real) :: measured_hookload  !< [N]
      type(optional_real) :: measured_torque    !< [N.m]
      type(optional_real) :: reference_hookload !< of another calculation [N]
   end type load_case_type

contains

   !> Visit all numbers of a load case.
   subroutine visit_case(load_case, visitor)
      type(load_case_type), intent(inout) :: load_case
      class(key_visitor_type), intent(inout) :: visitor
      call visitor%number('bit_depth', load_case%bit_depth)
      call visitor%number('hours', load_case%hours)
      call visitor%number('wob', load_case%wob)
      call visitor%number('tob', load_case%tob)
      call visitor%number('rpm', load_case%angular_speed)
      call visitor%number('trip_speed', load_case%trip_speed)
      call visitor%number('toolface', load_case%toolface)
      call visitor%number('pump_pressure', load_case%pump_pressure)
      call visitor%number('annulus_pressure', load_case%annulus_pressure)
      call visitor%optional('inside_density', load_case%inside_density)
      call visitor%number('temperature_change_top', load_case%temperature_change_top)
      call visitor%number('temperature_change_bottom', load_case%temperature_change_bottom)
      call visitor%number('above_ambient_top', load_case%above_ambient_top)
      call visitor%number('above_ambient_bottom', load_case%above_ambient_bottom)
      call visitor%optional('friction_axial', load_case%friction_axial)
      call visitor%optional('friction_rotary', load_case%friction_rotary)
      call visitor%optional('measured_hookload', load_case%measured_hookload)
      call visitor%optional('measured_torque', load_case%measured_torque)
      call visitor%optional('reference_hookload', load_case%reference_hookload)
   end subroutine visit_case

   !> Number of an operation from its name or an alias, 0 for an unknown name.
   pure function operation_from_name(name) result(operation)
      character(*), intent(in) :: name
      integer :: operation
      integer :: i
      do operation = 1, operation_count
         if (alike(name) == alike(operation_name(operation))) return
      end do
      operation = 0
      do i = 1, size(operation_aliases)
         if (alike(name) == alike(operation_aliases(i)%name)) operation = operation_aliases(i)%operation
      end do
   end function operation_from_name

   !> Name of an operation for comparison: small letters, without blanks, hyphens and underscores, with trailing blanks.
   pure function alike(name) result(text)
      character(*), intent(in) :: name
      character(len(name)) :: text
      integer :: i, n
      text = ''
      n = 0
      do i = 1, len(name)
         if (scan(name(i:i), ' -_') > 0) cycle
         n = n + 1
         text(n:n) = lower_case(name(i:i))
      end do
   end function alike

   !> Friction coefficients of an operation, signed by the motion (paper, Eq. 5 with mu1 = 0 or mu2 = 0). In combined motion
   !> the one Coulomb force is against the velocity of the surface. Each coefficient then acts with its share of that velocity.
   !> - axial: friction force on the string along the hole's tangent t per unit contact force, > 0 down the hole (string moves
   !>   up)
   !> - rotary: circumferential friction against the rotation, >= 0
   pure subroutine friction_split(load_case, mu_axial, mu_rotary, radius, axial, rotary)
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: mu_axial   !< mu2 [-]
      real(wp), intent(in) :: mu_rotary  !< mu1 [-]
      real(wp), intent(in) :: radius     !< radius at which the string touches [m]
      real(wp), intent(out) :: axial
      real(wp), intent(out) :: rotary
      type(operation_type) :: operation
      real(wp) :: speed         ! of the surface of the string [m/s]
      operation = operations(load_case%operation)
      axial = operation%string*mu_axial
      rotary = merge(mu_rotary, 0.0_wp, operation%turns)
      if (operation%string == 0 .or. .not. operation%turns) return
      speed = hypot(load_case%angular_speed*radius, load_case%trip_speed)
      if (speed > 0.0_wp) then
         axial = axial*(load_case%trip_speed/speed)
         rotary = rotary*(load_case%angular_speed*radius/speed)
      else
         axial = 0.0_wp
         rotary = 0.0_wp
      end if
   end subroutine friction_split

   !> True if friction acts along the hole, so that Table 1 has a frictional resistance. False for an invalid number.
   elemental function moves_axially(operation) result(yes)
      integer, intent(in) :: operation
      logical :: yes
      yes = .false.
      if (operation >= 1 .and. operation <= operation_count) yes = operations(operation)%string /= 0
   end function moves_axially

   !> True if the string turns, so that Table 1 has a torque. False for an invalid number.
   elemental function rotates(operation) result(yes)
      integer, intent(in) :: operation
      logical :: yes
      yes = .false.
      if (operation >= 1 .and. operation <= operation_count) yes = operations(operation)%turns
   end function rotates

   !> True for operations with weight on bit: rotary and sliding drilling.
   elemental function drills(operation) result(does)
      integer, intent(in) :: operation
      logical :: does
      does = operation == operation_rotary_drilling .or. operation == operation_sliding_drilling
   end function drills
end module dg_load_case

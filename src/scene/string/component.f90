!> One component of a drillstring: a length of pipe, collar or tool of constant section. All quantities SI. Section properties
!> are those of the new tube body.
module dg_component
   use dg_kinds, only: wp
   use dg_centralizer, only: centralizer_type
   use dg_connection_rating, only: connection_rating_type
   use dg_constants, only: pi, steel_density
   use dg_fatigue_curve, only: fatigue_curve_type
   use dg_key_visitor, only: key_visitor_type
   use dg_missing, only: is_missing, missing
   use dg_text, only: lower_case
   implicit none
   private
   public :: component_type, tube_area, tube_inertia, axial_stiffness, bending_stiffness, torsional_stiffness
   public :: visit_forces, visit_ratings
   public :: closed_diameter, contact_diameter, centralizer_diameter, opens, is_open
   public :: effective_joint_length, find_bowing
   public :: buoyed_weight, has_blades, has_joints, joint_bore, worn_od, is_worn, has_bend, has_pad, &
             is_bit, is_eccentric, is_hwdp, is_drill_pipe, is_pipe, is_coiled_tubing, room_of, room_of_held_bit, &
             shortest_contact, usual_yield_loss

   !> Beginning of the kind of a stabilizer, in either spelling or short.
   character(*), parameter :: stabilizer = 'stab'
   !> Clearance around a bit that is as wide as its hole [m]: API's tolerance of new bits.
   real(wp), parameter :: least_clearance = 0.25e-3_wp
   !> Largest tilt of a bit in its own cut [-]: more than by the largest bend, 5 deg.
   real(wp), parameter :: most_tilt = 0.1_wp
   !> Longest bit that may tilt in a wider hole [m].
   real(wp), parameter :: longest_bit = 1.5_wp
   !> Round-off of depths [m]: a tool whose upper end is higher than its depth of opening by less is open.
   real(wp), parameter :: depth_round_off = 1.0e-6_wp
   !> Shortest component, tool joint or hole section [m], as each has its contact and its nodes.
   real(wp), parameter :: shortest_contact = 1.0e-3_wp
   !> Default length of a tool joint [m]: pin and box of API drill pipe together.
   real(wp), parameter :: usual_joint_length = 0.5_wp

   !> Part of the yield strength of low alloy steel that a degree takes [1/K]: 0.03 %/degF. It holds for quenched and tempered
   !> steel up to 232 degC (API work item 2351, Temperature effect on performance properties, for TR 5C3).
   real(wp), parameter :: usual_yield_loss = 5.4e-4_wp

   type :: component_type
      character(:), allocatable :: name      !< free text
      character(:), allocatable :: kind      !< drillpipe, hwdp, collar, stabilizer, ...
      real(wp) :: length = 0.0_wp            !< [m]; 0 on the last one: reaches to surface
      real(wp) :: od = 0.0_wp                !< outside diameter of the body [m]
      real(wp) :: id = 0.0_wp                !< inside diameter [m]
      real(wp) :: mass = 0.0_wp              !< in air, per length [kg/m]
      real(wp) :: density = steel_density    !< of the material [kg/m3], for buoyancy
      real(wp) :: youngs = 206.0e9_wp        !< Young's modulus [Pa]
      real(wp) :: poisson = 0.3_wp           !< Poisson's ratio [-]
      real(wp) :: expansion = 12.42e-6_wp    !< thermal, of length [1/K]; 6.9e-6/degF, Lubinski, Althouse & Logan 1962
      real(wp) :: joint_od = 0.0_wp          !< tool joint (or blade) outside diameter [m]; 0: none, the body touches
      real(wp) :: joint_length = 0.0_wp      !< [m]
      real(wp) :: joint_spacing = 9.5_wp     !< [m]
      real(wp) :: joint_id = 0.0_wp          !< bore of its tool joints [m]; 0: not given
      real(wp) :: yield = 0.0_wp             !< yield strength [Pa]; 0: not given
      real(wp) :: yield_loss = usual_yield_loss   !< loss per degree above ambient temperature [1/K]
      real(wp) :: makeup_torque = 0.0_wp     !< of its connections [N.m]; 0: not given
      real(wp) :: friction_axial = missing   !< own mu2, in any hole [-]; missing: that of the hole
      real(wp) :: friction_rotary = missing  !< own mu1, in any hole [-]; missing: that of the hole
      real(wp) :: scale_axial = 1.0_wp       !< factor on mu2 of the hole [-]
      real(wp) :: scale_rotary = 1.0_wp      !< factor on mu1 of the hole [-]
      real(wp) :: joint_torsion = 0.0_wp     !< torque at which a connection yields [N.m]; 0: not known
      real(wp) :: wall_left = 1.0_wp         !< wall of the worn body over that of the new one [-]
      real(wp) :: bend = 0.0_wp              !< angle of a bent housing [rad]; 0: straight
      real(wp) :: bend_position = 0.0_wp     !< of the bend above the component's lower end [m]
      real(wp) :: pad_force = 0.0_wp         !< force on the string across the hole by pads on its wall [N]; 0: none
      real(wp) :: pad_clock = 0.0_wp         !< its direction [rad], from the high side, clockwise looking down the hole
      real(wp) :: pad_position = 0.0_wp      !< of the pads above the component's lower end [m]
      real(wp) :: blade_offset = 0.0_wp      !< of the centre of its blades from the axis of the string [m]; 0: centred
      real(wp) :: blade_clock = 0.0_wp       !< direction of that offset [rad], clockwise from the tool face, looking down the hole
      real(wp) :: sensor = missing           !< of a survey sensor above the component's lower end [m]; missing: none
      real(wp) :: opened_od = 0.0_wp         !< outside diameter of an open tool [m]; 0: it does not open
      real(wp) :: opened_below = missing     !< measured depth below which it is open [m]; missing: not known yet
      type(connection_rating_type) :: rating !< of its connections
      type(fatigue_curve_type) :: fatigue    !< of its body
      type(fatigue_curve_type) :: joint_fatigue   !< of its connections: an own curve or none
      type(centralizer_type) :: centralizer  !< on its body
   end type component_type

contains

   !> Visit the numbers of a component that determine forces.
   subroutine visit_forces(part, visitor)
      type(component_type), intent(inout) :: part
      class(key_visitor_type), intent(inout) :: visitor
      call visitor%number('length', part%length)
      call visitor%number('od', part%od)
      call visitor%number('id', part%id)
      call visitor%number('mass', part%mass)
      call visitor%number('density', part%density)
      call visitor%number('youngs', part%youngs)
      call visitor%number('poisson', part%poisson)
      call visitor%number('joint_od', part%joint_od)
      call visitor%number('joint_length', part%joint_length)
      call visitor%number('joint_spacing', part%joint_spacing)
      call visitor%number('opened_od', part%opened_od)
      call visitor%number_or_missing('opened_below', part%opened_below)
      call visitor%number_or_missing('friction_axial', part%friction_axial)
      call visitor%number_or_missing('friction_rotary', part%friction_rotary)
      call visitor%number('friction_scale_axial', part%scale_axial)
      call visitor%number('friction_scale_rotary', part%scale_rotary)
      call visitor%number('bend', part%bend)
      call visitor%number('bend_position', part%bend_position)
      call visitor%number('pad_force', part%pad_force)
      call visitor%number('pad_clock', part%pad_clock)
      call visitor%number('pad_position', part%pad_position)
      call visitor%number('blade_offset', part%blade_offset)
      call visitor%number('blade_clock', part%blade_clock)
   end subroutine visit_forces

   !> Visit the other numbers of a component: strength, expansion, sensor. Numbers of its fatigue curves are not visited.
   subroutine visit_ratings(part, visitor)
      type(component_type), intent(inout) :: part
      class(key_visitor_type), intent(inout) :: visitor
      call visitor%number('expansion', part%expansion)
      call visitor%number('yield', part%yield)
      call visitor%number('yield_loss', part%yield_loss)
      call visitor%number('makeup_torque', part%makeup_torque)
      call visitor%number('joint_id', part%joint_id)
      call visitor%number('joint_torsion', part%joint_torsion)
      call visitor%number_or_missing('tension_efficiency', part%rating%tension)
      call visitor%number_or_missing('compression_efficiency', part%rating%compression)
      call visitor%number_or_missing('burst_efficiency', part%rating%burst)
      call visitor%number_or_missing('collapse_efficiency', part%rating%collapse)
      call visitor%number_or_missing('joint_dogleg', part%rating%dogleg)
      call visitor%number_or_missing('sensor', part%sensor)
      call visitor%number('wall_left', part%wall_left)
   end subroutine visit_ratings

   !> Cross-section area of a tube [m2] from its diameters [m].
   elemental function tube_area(od, id) result(area)
      real(wp), intent(in) :: od, id
      real(wp) :: area
      area = 0.25_wp*pi*(od - id)*(od + id)
   end function tube_area

   !> Second moment of area of a tube about a diameter [m4]; the polar one is twice this.
   elemental function tube_inertia(od, id) result(inertia)
      real(wp), intent(in) :: od, id
      real(wp) :: inertia
      inertia = pi/64.0_wp*(od**4 - id**4)
   end function tube_inertia

   !> Outside diameter of the worn body [m]: pipe wears outside, the bore stays. Only strength depends on it, weight and
   !> stiffness do not.
   elemental function worn_od(component) result(diameter)
      type(component_type), intent(in) :: component
      real(wp) :: diameter
      diameter = component%od
      if (is_worn(component)) diameter = component%id + component%wall_left*(component%od - component%id)
   end function worn_od

   !> True if the body has less wall than new pipe.
   elemental function is_worn(component) result(worn)
      type(component_type), intent(in) :: component
      logical :: worn
      worn = component%wall_left < 1.0_wp
   end function is_worn

   !> E A [N].
   elemental function axial_stiffness(component) result(ea)
      type(component_type), intent(in) :: component
      real(wp) :: ea
      ea = component%youngs*tube_area(component%od, component%id)
   end function axial_stiffness

   !> E I [N.m2].
   elemental function bending_stiffness(component) result(ei)
      type(component_type), intent(in) :: component
      real(wp) :: ei
      ei = component%youngs*tube_inertia(component%od, component%id)
   end function bending_stiffness

   !> G J [N.m2] with G = E/(2 (1 + nu)) and J = 2 I.
   elemental function torsional_stiffness(component) result(gj)
      type(component_type), intent(in) :: component
      real(wp) :: gj
      gj = bending_stiffness(component)/(1.0_wp + component%poisson)
   end function torsional_stiffness

   !> Diameter with which the component passes the hole, before it opens if it does [m]: the larger one of joint and body.
   elemental function closed_diameter(component) result(diameter)
      type(component_type), intent(in) :: component
      real(wp) :: diameter
      diameter = max(component%joint_od, component%od)
   end function closed_diameter

   !> Diameter that touches the wall first at the component's place [m]: that of a tool that is open there, else the closed
   !> one. It is also twice the radius at which friction gives torque.
   elemental function contact_diameter(component, upper_end) result(diameter)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: upper_end   !< measured depth of the component's upper end [m]
      real(wp) :: diameter
      diameter = closed_diameter(component)
      if (is_open(component, upper_end)) diameter = component%opened_od
   end function contact_diameter

   !> True if the component is a tool that opens: under-reamer, expandable stabilizer, bicentre bit, packer.
   elemental function opens(component) result(does)
      type(component_type), intent(in) :: component
      logical :: does
      does = component%opened_od > 0.0_wp
   end function opens

   !> True if a tool is open. It opens as a whole, once no part of it is above the depth at which it opens.
   elemental function is_open(component, upper_end) result(is)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: upper_end   !< measured depth of the component's upper end [m]
      logical :: is
      is = opens(component) .and. .not. is_missing(component%opened_below)
      if (is) is = upper_end >= component%opened_below - depth_round_off
   end function is_open

   !> Diameter at which the component touches at its centralizers [m]: that of rigid ones, or of wider couplings. Within a bow
   !> spring the pipe turns. Tools that open have no centralizers.
   elemental function centralizer_diameter(component) result(diameter)
      type(component_type), intent(in) :: component
      real(wp) :: diameter
      diameter = closed_diameter(component)
      if (component%centralizer%present .and. .not. component%centralizer%bow) &
         diameter = max(component%centralizer%od, closed_diameter(component))
   end function centralizer_diameter

   !> True if the component touches at joints spaced along it, with a thinner body between them.
   elemental function has_joints(component) result(has)
      type(component_type), intent(in) :: component
      logical :: has
      has = component%joint_od > component%od .and. .not. (has_blades(component) .or. is_bit(component))
   end function has_joints

   !> Clearance of a component [m] from half the difference of diameters. A bit without clearance gets a little.
   elemental function room_of(half_difference) result(room)
      real(wp), intent(in) :: half_difference   !< (D - d)/2 [m]
      real(wp) :: room
      room = half_difference
      if (.not. room > 0.0_wp) room = least_clearance
   end function room_of

   !> Clearance [m] of a bit whose lower end is held in the middle of its hole. Its gauge does not touch, so that it may tilt. Its
   !> end on the axis and its gauge at the wall would be a clamp, which no hole is. A bit in casing would have ten times the
   !> side force. A bit as wide as its hole makes a hole wider by tilt times gauge as it drills ahead. A component that is
   !> longer than a bit, and narrower than its hole, touches the wall.
   elemental function room_of_held_bit(component, half_difference) result(room)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: half_difference   !< (D - d)/2 [m]
      real(wp) :: room
      room = room_of(half_difference)
      if (is_bit(component) .and. (component%length <= longest_bit .or. .not. half_difference > least_clearance)) &
         room = max(room, most_tilt*component%length)
   end function room_of_held_bit

   !> True for coiled tubing, which cannot be turned.
   elemental function is_coiled_tubing(component) result(is)
      type(component_type), intent(in) :: component
      logical :: is
      is = .false.
      if (allocated(component%kind)) is = index(lower_case(component%kind), 'coil') > 0
   end function is_coiled_tubing

   !> True if the component is pipe, which may go up to surface: no collar and no tool. A component without a kind is drill pipe.
   elemental function is_pipe(component) result(is)
      type(component_type), intent(in) :: component
      logical :: is
      character(:), allocatable :: kind
      is = .true.
      if (.not. allocated(component%kind)) return
      kind = lower_case(component%kind)
      is = kind == '' .or. index(kind, 'pipe') > 0 .or. &
           any(kind == [character(10) :: 'hwdp', 'casing', 'liner', 'tubing', 'sucker_rod', 'rod'])
   end function is_pipe

   !> True for drill pipe: no heavy weight pipe, wash pipe, casing, tubing or rods.
   elemental function is_drill_pipe(component) result(is)
      type(component_type), intent(in) :: component
      logical :: is
      is = .true.
      if (.not. allocated(component%kind)) return
      if (component%kind /= '') is = index(lower_case(component%kind), 'pipe') > 0 .and. &
                                     index(lower_case(component%kind), 'wash') == 0
   end function is_drill_pipe

   !> True for heavy weight drill pipe, whose weight serves as weight on bit.
   elemental function is_hwdp(component) result(is)
      type(component_type), intent(in) :: component
      logical :: is
      is = .false.
      if (allocated(component%kind)) is = lower_case(component%kind) == 'hwdp'
   end function is_hwdp

   !> True if the component is a bit, which may be as wide as its hole.
   elemental function is_bit(component) result(is)
      type(component_type), intent(in) :: component
      logical :: is
      is = .false.
      if (allocated(component%kind)) is = lower_case(component%kind) == 'bit'
   end function is_bit

   !> True if the component has blades, which touch along its whole length. It is a stabilizer, with its joint_od or without,
   !> or another tool that opens, open or closed. A bit has none.
   elemental function has_blades(component) result(has)
      type(component_type), intent(in) :: component
      logical :: has
      has = .false.
      if (allocated(component%kind)) has = index(lower_case(component%kind), stabilizer) == 1
      if (.not. has) has = opens(component) .and. .not. is_bit(component)
   end function has_blades

   !> True if the component is bent before anything loads it.
   elemental function has_bend(component) result(has)
      type(component_type), intent(in) :: component
      logical :: has
      has = component%bend > 0.0_wp
   end function has_bend

   !> True if pads of the component press it across the hole: a push-the-bit tool.
   elemental function has_pad(component) result(has)
      type(component_type), intent(in) :: component
      logical :: has
      has = component%pad_force > 0.0_wp
   end function has_pad

   !> True if the blades of a stabilizer are off the axis of the string.
   elemental function is_eccentric(component) result(is)
      type(component_type), intent(in) :: component
      logical :: is
      is = component%blade_offset > 0.0_wp
   end function is_eccentric

   !> Bore of the tool joints [m]. By default it is the wider one of the body, so that stresses are on the safe side.
   elemental function joint_bore(component) result(bore)
      type(component_type), intent(in) :: component
      real(wp) :: bore
      bore = component%id
      if (component%joint_id > 0.0_wp) bore = component%joint_id
   end function joint_bore

   !> Length of one tool joint [m].
   elemental function effective_joint_length(component) result(length)
      type(component_type), intent(in) :: component
      real(wp) :: length
      length = component%joint_length
      if (.not. length > 0.0_wp) length = usual_joint_length
      length = min(length, component%joint_spacing)
   end function effective_joint_length

   !> Length from joint to joint, from middle to middle, of pipe that can bow out between them [m]. Short components have half a
   !> joint at either end. The length is 0 without joints, where joints are longer than the pipe between them, and where
   !> centralizers carry the pipe.
   elemental function bowing_length(component) result(length)
      type(component_type), intent(in) :: component
      real(wp) :: length
      length = component%joint_spacing
      if (component%length > 0.0_wp) length = min(length, component%length)
      if (length < 2.0_wp*effective_joint_length(component) .or. component%centralizer%present .or. &
          .not. has_joints(component)) length = 0.0_wp
   end function bowing_length

   !> Height of the joints over the body [m], and Euler's load of the body between two of them [N]. Both are 0 where the body
   !> cannot bow out to the wall.
   pure subroutine find_bowing(component, upper_end, height, euler)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: upper_end        !< measured depth of the component's upper end [m]
      real(wp), intent(out) :: height, euler
      real(wp) :: length
      height = 0.0_wp
      euler = 0.0_wp
      length = bowing_length(component)
      if (.not. length > 0.0_wp) return
      height = 0.5_wp*(contact_diameter(component, upper_end) - component%od)
      euler = pi**2*bending_stiffness(component)/length**2
   end subroutine find_bowing

   !> Effective (buoyed) weight in fluid per length [N/m], which belongs to effective axial force. It is that of the pipe and
   !> of the fluid in its bore, less that of the fluid which both displace. A_i is the bore and m/rho the steel's area, with
   !> tool joints and upsets. The displaced area is A_i + m/rho, so that
   !>     w = g (m + rho_i A_i - rho_o (A_i + m/rho)) = m g (1 - rho_o/rho) + (rho_i - rho_o) g A_i.
   !> The second term is zero with one fluid on both sides. The weight is negative if the string floats.
   elemental function buoyed_weight(component, outside, inside, gravity) result(weight)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: outside, inside  !< densities of the fluids [kg/m3]
      real(wp), intent(in) :: gravity          !< [m/s2]
      real(wp) :: weight
      weight = component%mass*gravity*(1.0_wp - outside/component%density) &
               + (inside - outside)*gravity*tube_area(component%id, 0.0_wp)
   end function buoyed_weight
end module dg_component

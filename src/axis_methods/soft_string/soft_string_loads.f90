!> Forces in a flexible string on the hole axis (soft string), integrated from the bit up.
!>
!> Johancsik, Friesen & Dawson 1984 (SPE 11380, Eqs. 1-4) give the force balance of a short piece of string. Sheppard, Wick &
!> Burgess 1987 (SPE 15463) give its limit as the piece shrinks. That is integrated here in vectors, so that no inclination or
!> azimuth occurs. With the contact force c on the wall per metre, and s' up the hole,
!>     c = T k + w (g - (g.t) t),     n = |c|
!>     dT/ds' = w g.t + f n,      dM/ds' = m r n
!> - T: effective tension [N], M: torque [N.m]
!> - k = dt/ds: curvature vector [1/m], g: unit vector down
!> - w: buoyed weight [N/m], r: radius of contact [m]
!> - f, m: signed shares of friction along and around the hole (friction_split) [-]
!> Running forces of bow springs per length are added to f n. If a component has centralizers they share the contact with the
!> body between them (dg_centralized_contact). Brett et al. 1989 (the paper's flexible type) use the same balance.
!>
!> With `coiled`, compression F above the helical load presses the string on the wall all around. The contact force is c
!> F^2/(4 EI) per metre (Mitchell 1986) where that is more than n. Friction then grows with F squared. Above some weight on bit
!> no push at the top is enough (Wu & Juvkam-Wold 1993).
module dg_soft_string_loads
   use dg_kinds, only: wp
   use dg_buckling_limits, only: helical_low, sinusoidal_limit
   use dg_helical_load, only: coil_clearance, helical_bend, helical_contact, helical_load
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_packer, only: end_compression, packer_push
   use dg_sinusoidal_shape, only: sinusoidal_contact, sinusoidal_swing
   use dg_string_piece, only: climbed, layout_of, layout_type, piece_above, piece_type, share_contact
   use dg_trajectory, only: point_on_arc, turn_of, turn_type
   implicit none
   private
   public :: soft_string_at, soft_totals_type, other_loads_type, bearable_strain
   ! Public for the stiff string, which shares them.
   public :: longest_step, largest_angle, runaway_force

   !> Longest step in a bend [m] and largest angle turned in it [rad]. The step is of fourth order. At this angle it is exact
   !> to 1e-9 even with a friction coefficient of one. The limit is the kink of n where a string in a bend changes sides. It
   !> costs less than f |dn/ds| h^2/8 < 1 N once.
   real(wp), parameter :: longest_step = 5.0_wp
   real(wp), parameter :: largest_angle = 0.02_wp
   !> Axial force above which the integration stops [N]. No string carries a millionth of it, and friction in a long sharp bend
   !> grows exponentially to overflow.
   real(wp), parameter :: runaway_force = 1.0e15_wp
   !> Strain of a helically buckled string at which the integration stops [-], by compression and by the bending of the helix.
   !> Its friction becomes infinite at a finite length. Pipe of 135 ksi yields at 0.45 %.
   real(wp), parameter :: bearable_strain = 0.005_wp

   !> Sums over the string between the first of the given depths and the bit.
   type :: soft_totals_type
      real(wp) :: weight = 0.0_wp        !< buoyed weight along the hole: sum of w dz [N]
      real(wp) :: normal_force = 0.0_wp  !< integral of n [N]
      integer :: steps = 0               !< integration steps
      real(wp) :: strain = 0.0_wp        !< largest in a helically buckled string, by compression and by the bending of the helix
                                         !< [-]
      real(wp) :: coil = 0.0_wp          !< length that helical buckling takes up, of Lubinski's helix [m]
      real(wp) :: bowed = 0.0_wp         !< length of pipe that bows out between its tool joints [m]
      logical :: runaway = .false.       !< axial force grew without bound
      real(wp) :: runaway_md = 0.0_wp    !< depth where it did, above which nothing was integrated [m]
   end type soft_totals_type

   !> Loads that differ from the load case. The scales are for load increments.
   type :: other_loads_type
      real(wp) :: friction_scale = 1.0_wp   !< on every friction coefficient [-]
      real(wp) :: load_scale = 1.0_wp       !< on weight and torque on bit [-]
      logical :: coiled = .false.           !< with the friction of helical buckling
      logical :: climbs = .false.           !< a rotating string climbs the wall, whatever the model says
      type(optional_real) :: wob            !< weight on bit instead of the load case's [N]
   end type other_loads_type

   !> A place of a piece. The load across the hole needs scalars only: three-vectors and their norms took half of the time.
   type :: place_type
      real(wp) :: tangent(3) = 0.0_wp, normal(3) = 0.0_wp   !< of the arc
      real(wp) :: depth = 0.0_wp    !< vertical, below the arc's start [m]
      real(wp) :: both = 0.0_wp     !< k.g: curvature vector k, weight across the hole g per length [N/m2]
      real(wp) :: across = 0.0_wp   !< g.g [N2/m2]
   end type place_type

contains

   !> Axial force, torque and contact of the soft string of a load case at given depths. Where weight, curvature or friction
   !> jump, `contact` is the one just below the depth. At a depth that is given twice, it is those just above and just below.
   pure subroutine soft_string_at(model, case_index, md, axial, torque, contact, totals, other)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)                !< never decreasing, from the first station to the bit [m]
      real(wp), intent(out) :: axial(:)            !< effective, tension > 0 [N]
      real(wp), intent(out) :: torque(:)           !< [N.m]
      !> Force of the string on the wall, across the hole, without helical buckling (3, :) [N/m].
      real(wp), intent(out), optional :: contact(:, :)
      type(soft_totals_type), intent(out), optional :: totals
      type(other_loads_type), intent(in), optional :: other   !< loads that differ from the load case
      type(other_loads_type) :: loads
      type(soft_totals_type) :: sums
      type(layout_type) :: layout
      type(piece_type) :: piece
      type(place_type) :: place
      real(wp) :: position, force, moment
      integer :: i
      if (present(other)) loads = other
      associate (load_case => model%cases(case_index))
         position = load_case%bit_depth
         force = -loads%load_scale*end_compression(model, load_case)
         if (loads%wob%present) force = -loads%load_scale*(loads%wob%value + packer_push(model, load_case))
         force = force + loads%friction_scale*model%stiff_drag
         moment = loads%load_scale*load_case%tob
      end associate
      layout = layout_of(model, case_index)
      call enter_piece(model, layout, position, loads, piece, place)
      do i = size(md), 1, -1
         do while (position > md(i))
            call integrate_up(piece, max(piece%top, md(i)), position, place, force, moment, sums)
            if (position > md(i)) call enter_piece(model, layout, position, loads, piece, place)
         end do
         axial(i) = force
         torque(i) = moment
         if (present(contact)) contact(:, i) = contact_force(piece, place, force)
         ! The next depth up starts in the piece above.
         if (position <= piece%top .and. i > 1) call enter_piece(model, layout, position, loads, piece, place)
      end do
      if (present(totals)) totals = sums
   end subroutine soft_string_at

   !> Enter the piece that ends at a depth [m].
   pure subroutine enter_piece(model, layout, md, loads, piece, place)
      type(model_type), intent(in) :: model
      type(layout_type), intent(in) :: layout
      real(wp), intent(in) :: md                !< [m]
      type(other_loads_type), intent(in) :: loads
      type(piece_type), intent(out) :: piece
      type(place_type), intent(out) :: place    !< at that depth
      piece = piece_above(model, layout, md, loads%friction_scale*model%stiff_share, loads%coiled, loads%climbs)
      place = place_at(piece, md - piece%arc%md)
   end subroutine enter_piece

   !> Load across the hole [N/m] at a place of a piece under an axial force [N].
   pure function load_across(piece, place, force) result(load)
      type(piece_type), intent(in) :: piece
      type(place_type), intent(in) :: place
      real(wp), intent(in) :: force
      real(wp) :: load
      load = sqrt(max(force*(force*piece%arc%curvature**2 + 2.0_wp*place%both) + place%across, 0.0_wp))
   end function load_across

   !> Contact force [N/m] at a place of a piece under an axial force [N].
   pure function pressed(piece, place, force) result(normal)
      type(piece_type), intent(in) :: piece
      type(place_type), intent(in) :: place
      real(wp), intent(in) :: force
      real(wp) :: normal, limit, clearance
      normal = load_across(piece, place, force)
      if (piece%coils .and. force < 0.0_wp) then
         clearance = coil_clearance(piece%clearance, piece%joint_height, piece%euler, -force)
         limit = sinusoidal_limit(piece%stiffness, normal, clearance)
         if (-force > max(helical_low*limit, piece%least_helical)) then
            normal = max(normal, helical_contact(piece%stiffness, -force, clearance))
         else if (-force > limit .and. normal > 0.0_wp) then
            normal = normal*sinusoidal_contact(sinusoidal_swing(-force/limit))
         end if
      end if
      normal = piece%climb*normal
   end function pressed

   !> Strain of a compressed piece by compression, and by bending if it is helically buckled [-]. Also the part of its length
   !> that the helix takes up, c^2 F/(4 EI).
   pure subroutine find_strain(piece, place, compression, strain, coil)
      type(piece_type), intent(in) :: piece
      type(place_type), intent(in) :: place
      real(wp), intent(in) :: compression    !< > 0 [N]
      real(wp), intent(out) :: strain, coil
      real(wp) :: clearance, bend, across
      coil = 0.0_wp
      strain = compression/piece%stretching
      clearance = coil_clearance(piece%clearance, piece%joint_height, piece%euler, compression)
      across = load_across(piece, place, -compression)
      if (.not. compression > helical_load(piece%stiffness, across, piece%weight, clearance)) return
      bend = helical_bend(piece%stiffness, compression, clearance)
      strain = strain + piece%reach*bend
      coil = 0.5_wp*clearance*bend
   end subroutine find_strain

   !> Integrate up a piece of string from `position` to `target`. The weight is the difference of true vertical depth, exact on
   !> an arc. Friction uses the classical Runge-Kutta method, exact where straight.
   pure subroutine integrate_up(piece, target, position, place, force, moment, sums)
      type(piece_type), intent(inout) :: piece
      real(wp), intent(in) :: target             !< [m]
      real(wp), intent(inout) :: position        !< [m]
      type(place_type), intent(inout) :: place   !< at `position`
      real(wp), intent(inout) :: force           !< [N]
      real(wp), intent(inout) :: moment          !< [N.m]
      type(soft_totals_type), intent(inout) :: sums
      real(wp) :: step, angle, offset, normal, middle, upper, n1, n2, n3, n4, strain, coil
      type(place_type) :: half_way, there
      type(turn_type) :: turn
      logical :: bent
      integer :: steps, i
      offset = position - piece%arc%md
      step = position - target
      position = target
      if (sums%runaway) then
         place = place_at(piece, target - piece%arc%md)
         return
      end if
      angle = step*piece%arc%curvature
      steps = 1
      if (angle > 0.0_wp .or. piece%coils .or. piece%spans%present) &
         steps = max(1, ceiling(step/longest_step), ceiling(angle/largest_angle))
      step = step/real(steps, wp)
      bent = angle > 0.0_wp
      if (bent) turn = turn_of(piece%arc, 0.5_wp*step)
      half_way = place
      there = place
      do i = 1, steps
         if (bent) then
            call go_up(piece, turn, place, half_way)
            call go_up(piece, turn, half_way, there)
         else
            half_way%depth = place%depth - 0.5_wp*step*place%tangent(3)
            there%depth = place%depth - step*place%tangent(3)
         end if
         offset = offset - step
         middle = force + piece%weight*(place%depth - half_way%depth) + 0.5_wp*step*piece%drag
         n1 = pressed(piece, place, force)
         if (piece%spans%present) call share_contact(piece, n1, force)
         upper = force + piece%weight*(place%depth - there%depth) + step*piece%drag
         if (.not. bent .and. (.not. piece%coils .or. min(force, upper + step*piece%axial*n1) >= 0.0_wp)) then
            normal = step*n1      ! the load across a straight hole does not depend on axial force
         else
            n2 = pressed(piece, half_way, middle + 0.5_wp*step*piece%axial*n1)
            n3 = n2
            if (abs(piece%axial) > 0.0_wp) n3 = pressed(piece, half_way, middle + 0.5_wp*step*piece%axial*n2)
            n4 = pressed(piece, there, upper + step*piece%axial*n3)
            normal = step*(n1 + 2.0_wp*n2 + 2.0_wp*n3 + n4)/6.0_wp
         end if
         force = upper
         force = force + piece%axial*normal
         moment = moment + piece%rotary*piece%radius*normal
         sums%normal_force = sums%normal_force + normal
         sums%weight = sums%weight + piece%weight*(place%depth - there%depth)
         sums%steps = sums%steps + 1
         if (piece%coils .and. force < 0.0_wp) then
            call find_strain(piece, there, -force, strain, coil)
            sums%strain = max(sums%strain, strain)
            sums%coil = sums%coil + step*coil
            if (piece%joint_height > 0.0_wp .and. -force > piece%euler) sums%bowed = sums%bowed + step
         end if
         if (abs(force) > runaway_force .or. sums%strain > bearable_strain) then
            sums%runaway = .true.
            sums%runaway_md = piece%arc%md + offset
            place = place_at(piece, target - piece%arc%md)
            return
         end if
         place = there
      end do
   end subroutine integrate_up

   !> A place of the piece. The square of the load across the hole is the sum of T^2 k.k, 2 T k.g and g.g. The curvature vector
   !> is across the tangent, so that weight along it adds nothing.
   pure function place_at(piece, offset) result(place)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: offset   !< from the start of the piece's arc [m]
      type(place_type) :: place
      real(wp) :: position(3), bend(3)
      call point_on_arc(piece%arc, offset, position, place%tangent, bend)
      place%depth = position(3)
      place%normal = piece%arc%normal
      if (piece%arc%curvature > 0.0_wp) place%normal = bend/piece%arc%curvature
      place%both = piece%weight*bend(3)
      place%across = piece%weight**2*(place%tangent(1)**2 + place%tangent(2)**2)
   end function place_at

   !> The place a step up the hole from another one, the same as place_at but for round-off.
   pure subroutine go_up(piece, turn, below, place)
      type(piece_type), intent(in) :: piece
      type(turn_type), intent(in) :: turn
      type(place_type), intent(in) :: below
      type(place_type), intent(out) :: place
      integer :: i
      do i = 1, 3
         place%tangent(i) = turn%cosine*below%tangent(i) - turn%sine*below%normal(i)
         place%normal(i) = turn%cosine*below%normal(i) + turn%sine*below%tangent(i)
      end do
      place%depth = below%depth - (turn%along*below%tangent(3) + turn%inward*below%normal(3))
      place%both = piece%weight*piece%arc%curvature*place%normal(3)
      place%across = piece%weight**2*(place%tangent(1)**2 + place%tangent(2)**2)
   end subroutine go_up

   !> Force of the string on the wall [N/m] at a place under an axial force [N].
   pure function contact_force(piece, place, force) result(contact)
      type(piece_type), intent(in) :: piece
      type(place_type), intent(in) :: place
      real(wp), intent(in) :: force
      real(wp) :: contact(3)
      real(wp) :: across(3)
      across(1:2) = -place%tangent(3)*place%tangent(1:2)
      across(3) = place%tangent(1)**2 + place%tangent(2)**2
      contact = (force*piece%arc%curvature)*place%normal + piece%weight*across
      if (piece%climb < 1.0_wp) contact = climbed(piece, place%tangent, contact)
   end function contact_force
end module dg_soft_string_loads

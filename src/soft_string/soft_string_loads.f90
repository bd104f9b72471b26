!> Forces in a flexible string that lies on the hole axis (soft string), integrated from the bit up.
!>
!> Johancsik, Friesen & Dawson 1984 (SPE 11380, Eqs. 1-4) give the force balance of a short piece of string;
!> Sheppard, Wick & Burgess 1987 (SPE 15463) its limit as the piece shrinks, which is integrated here in
!> vectors, so that no inclination or azimuth occurs:
!>     contact force on the wall per metre   c = T k + w (g - (g.t) t),     n = |c|
!>     dT/ds' = w g.t + f n,      dM/ds' = m r n                     (s' up the hole)
!> with effective tension T, curvature vector k = dt/ds, unit vector down g, buoyed weight w, radius of contact r,
!> and the signed shares f, m of friction along and around the hole (friction_split). Running forces of bow springs per length are
!> added to f n. Where a component has centralisers all contact is theirs.
!> Brett et al. 1989 (the paper's flexible type) use the same balance.
!>
!> Asked for `coiled`, compression F beyond the coiling load presses the string on the wall all around, by c F^2/(4 EI) per metre
!> (Mitchell 1986) where that is more than n: friction then grows with F squared, and a weight on bit exists that no push at the
!> top can bring down (Wu & Juvkam-Wold 1993).
module dg_soft_string_loads
   use dg_kinds, only: wp
   use dg_buckling_limits, only: helical_low, lubinski_first, sinusoidal_limit, vertical_unit
   use dg_snake, only: snake_contact, snake_swing
   use dg_component, only: axial_stiffness, bending_stiffness, buoyed_weight, centralizer_diameter, contact_diameter
   use dg_contact_friction, only: find_friction, running_drag
   use dg_drillstring, only: component_tops
   use dg_fluid, only: density_at, fluid_tops, side_inside, side_outside
   use dg_hole_section, only: hole_section_at
   use dg_load_case, only: optional_real
   use dg_model, only: model_type, string_index
   use dg_trajectory, only: arc_type, arc_at, point_on_arc, top_md, turn_of, turn_type
   use dg_vector, only: cross
   implicit none
   private
   public :: soft_string_at, soft_totals_type, other_loads_type, breakpoints
   ! The pieces of a string, which the stiff string shares.
   public :: layout_type, layout_of, piece_type, piece_above, at_offset, climbed, longest_step, largest_angle, runaway_force
   public :: coiling_load, coil_force

   !> Longest step in a bend [m] and largest angle turned in it [rad]. The step is of fourth order: at this
   !> angle it is exact to 1e-9 even with a friction coefficient of one. What limits it is the kink of n where
   !> a string in a bend changes sides, which costs less than f |dn/ds| h^2/8 < 1 N once.
   real(wp), parameter :: longest_step = 5.0_wp
   real(wp), parameter :: largest_angle = 0.02_wp
   !> Axial force beyond which the integration stops [N]: no string carries a millionth of it, and friction in
   !> a long sharp bend grows exponentially until numbers end.
   real(wp), parameter :: runaway_force = 1.0e15_wp
   !> The same for a coiled string, whose friction reaches infinity at a finite length: strain [-] that no steel bears.
   real(wp), parameter :: runaway_strain = 0.01_wp

   !> Changes closer together than this count as one in `breakpoints` [m]: round-off of depths, and no row of a
   !> table worth printing.
   real(wp), parameter :: shortest_piece = 1.0e-6_wp

   !> Sums over the string between the first of the depths asked for and the bit.
   type :: soft_totals_type
      real(wp) :: weight = 0.0_wp        !< buoyed weight along the hole: sum of w dz [N]
      real(wp) :: normal_force = 0.0_wp  !< integral of n [N]
      integer :: steps = 0               !< integration steps
      logical :: runaway = .false.       !< axial force left all bounds
      real(wp) :: runaway_md = 0.0_wp    !< ... at this depth, above which nothing was integrated [m]
   end type soft_totals_type

   !> Loads that are not those of the load case. The scales serve load increments.
   type :: other_loads_type
      real(wp) :: friction_scale = 1.0_wp   !< on every friction coefficient [-]
      real(wp) :: load_scale = 1.0_wp       !< on weight and torque on bit [-]
      logical :: coiled = .false.           !< friction of a coiled string too
      type(optional_real) :: wob            !< weight on bit instead of the load case's [N]
   end type other_loads_type

   !> What the pieces of a string are cut by, looked up once for all.
   type :: layout_type
      integer :: case_index = 0
      integer :: string = 0                   !< its number
      real(wp), allocatable :: tops(:)        !< of its components, from the bit up; its last one has the top of the string [m]
      real(wp), allocatable :: fluids(:)      !< depths at which a fluid begins, ascending [m]
   end type layout_type

   !> A piece of string of constant properties in one arc and one hole section.
   type :: piece_type
      type(arc_type) :: arc
      real(wp) :: top = 0.0_wp      !< measured depth of its upper end [m]
      real(wp) :: weight = 0.0_wp   !< buoyed [N/m]
      real(wp) :: radius = 0.0_wp   !< of contact [m]
      real(wp) :: drag = 0.0_wp     !< of bow springs, signed as f [N/m]
      real(wp) :: axial = 0.0_wp    !< f of the balance above [-]
      real(wp) :: rotary = 0.0_wp   !< m of the balance above [-]
      real(wp) :: climb = 1.0_wp    !< contact force over load across the hole: 1/sqrt(1 + m^2) with wall climb, else 1 [-]
      real(wp) :: stiffness = 0.0_wp !< E I of the body, which a soft string leaves out [N.m2]
      real(wp) :: stretching = 0.0_wp !< E A of the body [N]
      real(wp) :: clearance = 0.0_wp !< (D - d)/2 [m]
      real(wp) :: least_coiling = 0.0_wp !< coiling load of a string that nothing presses [N]
      logical :: coils = .false.    !< compression presses it on the wall where it snakes or coils
   end type piece_type

   !> A place of a piece. What the load across the hole needs are scalars: three-vectors and their norms took half of the time.
   type :: place_type
      real(wp) :: tangent(3) = 0.0_wp, normal(3) = 0.0_wp   !< of the arc
      real(wp) :: depth = 0.0_wp    !< vertical, below the arc's start [m]
      real(wp) :: both = 0.0_wp     !< k.g: curvature vector k, weight across the hole g per length [N/m2]
      real(wp) :: across = 0.0_wp   !< g.g [N2/m2]
   end type place_type

contains

   !> Axial force, torque and contact of the soft string of a load case at given depths.
   !> Where weight, curvature or friction jump, `contact` is the one just below the depth. Without it places within an arc are
   !> found by turning the one below, which differs by round-off and takes a third of the time.
   pure subroutine soft_string_at(model, case_index, md, axial, torque, contact, totals, other)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)                !< ascending, from the first station to the bit [m]
      real(wp), intent(out) :: axial(:)            !< effective, tension > 0 [N]
      real(wp), intent(out) :: torque(:)           !< [N.m]
      !> (3, :) force of the string on the wall, across the hole, coils left out [N/m]
      real(wp), intent(out), optional :: contact(:, :)
      type(soft_totals_type), intent(out), optional :: totals
      type(other_loads_type), intent(in), optional :: other   !< than the load case's
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
         force = -loads%load_scale*load_case%wob
         if (loads%wob%present) force = -loads%load_scale*loads%wob%value
         moment = loads%load_scale*load_case%tob
      end associate
      layout = layout_of(model, case_index)
      call enter_piece(model, layout, position, loads, piece, place)
      do i = size(md), 1, -1
         do while (position > md(i))
            call climb(piece, max(piece%top, md(i)), present(contact), position, place, force, moment, sums)
            if (position > md(i)) call enter_piece(model, layout, position, loads, piece, place)
         end do
         axial(i) = force
         torque(i) = moment
         if (present(contact)) contact(:, i) = contact_force(piece, md(i), force)
         ! The next depth up starts in the piece above.
         if (position <= piece%top .and. i > 1) call enter_piece(model, layout, position, loads, piece, place)
      end do
      if (present(totals)) totals = sums
   end subroutine soft_string_at

   !> Goes on with the piece that ends at a depth [m].
   pure subroutine enter_piece(model, layout, md, loads, piece, place)
      type(model_type), intent(in) :: model
      type(layout_type), intent(in) :: layout
      real(wp), intent(in) :: md                !< [m]
      type(other_loads_type), intent(in) :: loads
      type(piece_type), intent(out) :: piece
      type(place_type), intent(out) :: place    !< at that depth
      piece = piece_above(model, layout, md, loads%friction_scale, loads%coiled)
      place = place_at(piece, md - piece%arc%md)
   end subroutine enter_piece

   !> Axial compression [N] beyond which a string under a known side load n per metre is taken to coil: the lower helical limit of
   !> dg_buckling_limits, 2 sqrt(2 EI n/c), and in a vertical hole, where n is nothing, twice Lubinski's (1950) first-order load
   !> 1.94 (EI w^2)^(1/3), at which the pipe lies on the wall all around: earlier than the published helical limit there, so
   !> that a start of the beams and a lock-up are not late.
   elemental function coiling_load(ei, side_load, weight, clearance) result(load)
      real(wp), intent(in) :: ei         !< [N.m2]
      real(wp), intent(in) :: side_load  !< [N/m]
      real(wp), intent(in) :: weight     !< [N/m]
      real(wp), intent(in) :: clearance  !< > 0 [m]
      real(wp) :: load
      load = max(helical_low*sinusoidal_limit(ei, side_load, clearance), least_coiling_load(ei, weight))
   end function coiling_load

   !> The same of a string that nothing presses.
   elemental function least_coiling_load(ei, weight) result(load)
      real(wp), intent(in) :: ei, weight   !< [N.m2, N/m]
      real(wp) :: load
      !> Of one without weight; loads are divided by it [N].
      real(wp), parameter :: next_to_none = 1.0e-6_wp
      load = max(2.0_wp*lubinski_first*vertical_unit(ei, abs(weight)), next_to_none)
   end function least_coiling_load

   !> Contact force per metre c F^2/(4 EI) of a coiled string [N/m].
   elemental function coil_force(ei, compression, clearance) result(force)
      real(wp), intent(in) :: ei, compression, clearance   !< [N.m2, N, m]
      real(wp) :: force
      force = clearance*max(compression, 0.0_wp)**2/(4.0_wp*ei)
   end function coil_force

   !> Contact force [N/m] at a place of a piece under an axial force [N].
   pure function pressed(piece, place, force) result(normal)
      type(piece_type), intent(in) :: piece
      type(place_type), intent(in) :: place
      real(wp), intent(in) :: force
      real(wp) :: normal, limit
      normal = sqrt(max(force*(force*piece%arc%curvature**2 + 2.0_wp*place%both) + place%across, 0.0_wp))
      if (piece%coils .and. force < 0.0_wp) then
         limit = sinusoidal_limit(piece%stiffness, normal, piece%clearance)
         if (-force > max(helical_low*limit, piece%least_coiling)) then
            normal = max(normal, coil_force(piece%stiffness, -force, piece%clearance))
         else if (normal > 0.0_wp) then
            normal = normal*snake_contact(snake_swing(-force/limit))
         end if
      end if
      normal = piece%climb*normal
   end function pressed

   !> The layout of the string of a load case.
   pure function layout_of(model, case_index) result(layout)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(layout_type) :: layout
      associate (load_case => model%cases(case_index))
         layout%case_index = case_index
         layout%string = string_index(model%strings, load_case%string)
         allocate (layout%fluids, source=fluid_tops(model%mud, load_case%bit_depth))
         allocate (layout%tops, source=load_case%bit_depth - component_tops(model%strings(layout%string), &
                                                                            load_case%bit_depth - top_md(model%trajectory)))
      end associate
   end function layout_of

   !> The piece of string that ends, or lies, at a depth [m]; it reaches up to the next change of anything.
   pure function piece_above(model, layout, md, friction_scale, coiled) result(piece)
      type(model_type), intent(in) :: model
      type(layout_type), intent(in) :: layout
      real(wp), intent(in) :: md
      real(wp), intent(in) :: friction_scale
      logical, intent(in), optional :: coiled   !< absent: no
      type(piece_type) :: piece
      real(wp) :: middle
      integer :: i, k, hole
      i = arc_at(model%trajectory, md)
      if (model%trajectory%arcs(i)%md >= md .and. i > 1) i = i - 1
      piece%arc = model%trajectory%arcs(i)
      piece%top = piece%arc%md
      hole = hole_section_at(model%holes, md)
      if (hole > 1 .and. model%holes(hole)%md_top >= md) hole = hole - 1
      if (hole > 1) piece%top = max(piece%top, model%holes(hole)%md_top)
      do i = 1, size(layout%tops) - 1
         if (layout%tops(i) < md) exit
      end do
      if (i < size(layout%tops)) piece%top = max(piece%top, layout%tops(i))
      do k = 1, size(layout%fluids)
         if (layout%fluids(k) < md) piece%top = max(piece%top, layout%fluids(k))
      end do
      middle = 0.5_wp*(piece%top + md)
      associate (load_case => model%cases(layout%case_index), part => model%strings(layout%string)%components(i))
         piece%weight = buoyed_weight(part, density_at(model%mud, side_outside, middle, load_case%bit_depth), &
                                      density_at(model%mud, side_inside, middle, load_case%bit_depth), model%gravity)
         piece%radius = 0.5_wp*centralizer_diameter(part)
         piece%stiffness = bending_stiffness(part)
         piece%stretching = axial_stiffness(part)
         piece%clearance = 0.5_wp*(model%holes(hole)%diameter - contact_diameter(part))
         call find_friction(model%holes(hole), part, load_case, part%centralizer%present, piece%radius, friction_scale, &
                            piece%axial, piece%rotary)
         if (part%centralizer%present) piece%drag = friction_scale*running_drag(model%holes(hole), part, load_case) &
                                                    /part%centralizer%spacing
      end associate
      if (present(coiled)) piece%coils = coiled .and. piece%clearance > 0.0_wp
      if (piece%coils) piece%least_coiling = least_coiling_load(piece%stiffness, piece%weight)
      if (model%numerics%wall_climb) piece%climb = 1.0_wp/sqrt(1.0_wp + piece%rotary**2)
   end function piece_above

   !> Integrates up a piece of string from `position` to `target`. The weight enters as difference of true
   !> vertical depth, exact on an arc; friction by the classical Runge-Kutta method, exact where straight.
   pure subroutine climb(piece, target, closely, position, place, force, moment, sums)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: target             !< [m]
      logical, intent(in) :: closely             !< every place from its depth, not from the one below
      real(wp), intent(inout) :: position        !< [m]
      type(place_type), intent(inout) :: place   !< at `position`
      real(wp), intent(inout) :: force           !< [N]
      real(wp), intent(inout) :: moment          !< [N.m]
      type(soft_totals_type), intent(inout) :: sums
      real(wp) :: step, angle, offset, normal, middle, n1, n2, n3, n4
      type(place_type) :: half_way, there
      type(turn_type) :: turn
      integer :: steps, i
      offset = position - piece%arc%md
      step = position - target
      position = target
      if (sums%runaway) return
      angle = step*piece%arc%curvature
      steps = 1
      if (angle > 0.0_wp .or. (piece%coils .and. abs(piece%axial) > 0.0_wp)) &
         steps = max(1, ceiling(step/longest_step), ceiling(angle/largest_angle))
      step = step/real(steps, wp)
      turn = turn_of(piece%arc, 0.5_wp*step)
      if (closely) place = place_at(piece, offset)
      do i = 1, steps
         if (closely) then
            half_way = place_at(piece, offset - 0.5_wp*step)
            there = place_at(piece, offset - step)
         else
            call go_up(piece, turn, place, half_way)
            call go_up(piece, turn, half_way, there)
         end if
         offset = offset - step
         middle = force + piece%weight*(place%depth - half_way%depth) + 0.5_wp*step*piece%drag
         n1 = pressed(piece, place, force)
         n2 = pressed(piece, half_way, middle + 0.5_wp*step*piece%axial*n1)
         n3 = pressed(piece, half_way, middle + 0.5_wp*step*piece%axial*n2)
         force = force + piece%weight*(place%depth - there%depth) + step*piece%drag
         n4 = pressed(piece, there, force + step*piece%axial*n3)
         normal = step*(n1 + 2.0_wp*n2 + 2.0_wp*n3 + n4)/6.0_wp
         force = force + piece%axial*normal
         moment = moment + piece%rotary*piece%radius*normal
         sums%normal_force = sums%normal_force + normal
         sums%weight = sums%weight + piece%weight*(place%depth - there%depth)
         sums%steps = sums%steps + 1
         if (abs(force) > runaway_force .or. (piece%coils .and. -force > runaway_strain*piece%stretching)) then
            sums%runaway = .true.
            sums%runaway_md = piece%arc%md + offset
            return
         end if
         place = there
      end do
   end subroutine climb

   !> A place of the piece. What the load across the hole needs: its square is the sum of T^2 k.k, 2 T k.g and g.g. The curvature
   !> vector lies across the tangent, so that weight along it adds nothing.
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

   !> The place a step up the hole from another one, as place_at has it but for round-off.
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

   !> Position relative to the arc's start [m], weight across the hole [N/m] and curvature vector [1/m].
   pure subroutine at_offset(piece, offset, position, across, bend)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: offset   !< from the start of the piece's arc [m]
      real(wp), intent(out) :: position(3), across(3), bend(3)
      real(wp) :: tangent(3)
      call point_on_arc(piece%arc, offset, position, tangent, bend)
      across = piece%weight*([0.0_wp, 0.0_wp, 1.0_wp] - tangent(3)*tangent)
   end subroutine at_offset

   !> Force of the string on the wall [N/m] at a depth [m] under an axial force [N].
   pure function contact_force(piece, md, force) result(contact)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: md
      real(wp), intent(in) :: force
      real(wp) :: contact(3)
      real(wp) :: position(3), across(3), bend(3)
      call at_offset(piece, md - piece%arc%md, position, across, bend)
      contact = climbed(piece, md, force*bend + across)
   end function contact_force

   !> Contact force under a load across the hole [N/m]: the load itself, or with wall climb what balances it together
   !> with its own friction around the hole, load = n + m t x n, where the turning string comes to rest.
   pure function climbed(piece, md, load) result(contact)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: md        !< [m]
      real(wp), intent(in) :: load(3)
      real(wp) :: contact(3)
      real(wp) :: position(3), tangent(3), bend(3)
      contact = load
      if (piece%climb >= 1.0_wp) return
      call point_on_arc(piece%arc, md - piece%arc%md, position, tangent, bend)
      contact = piece%climb**2*(load - piece%rotary*cross(tangent, load))
   end function climbed

   !> Depths between the top of the string and the bit where something changes: first station and bit, survey
   !> stations, ends of hole sections, components and fluids. Ascending, none twice [m].
   pure function breakpoints(model, case_index) result(md)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), allocatable :: md(:)
      real(wp), allocatable :: all_md(:), tops(:), hole_tops(:)
      real(wp) :: top, bit
      integer :: count, i
      top = top_md(model%trajectory)
      bit = model%cases(case_index)%bit_depth
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         allocate (tops, source=bit - component_tops(string, bit - top))
      end associate
      tops = tops(size(tops):1:-1)
      allocate (hole_tops(size(model%holes)))
      hole_tops(:) = model%holes%md_top
      all_md = merged(model%trajectory%md, merged(hole_tops, merged(fluid_tops(model%mud, bit), tops)))
      allocate (md(size(all_md) + 2))
      count = 1
      md(1) = top
      do i = 1, size(all_md)
         if (all_md(i) <= md(count) + shortest_piece .or. all_md(i) >= bit - shortest_piece) cycle
         count = count + 1
         md(count) = all_md(i)
      end do
      count = count + 1
      md(count) = bit
      md = md(:count)
   end function breakpoints

   !> Two ascending lists as one.
   pure function merged(a, b) result(c)
      real(wp), intent(in) :: a(:), b(:)
      real(wp) :: c(size(a) + size(b))
      integer :: i, j, k
      i = 1
      j = 1
      do k = 1, size(c)
         if (j > size(b)) then
            c(k) = a(i)
            i = i + 1
         else if (i > size(a)) then
            c(k) = b(j)
            j = j + 1
         else if (a(i) <= b(j)) then
            c(k) = a(i)
            i = i + 1
         else
            c(k) = b(j)
            j = j + 1
         end if
      end do
   end function merged
end module dg_soft_string_loads

!> Pieces of a string on the hole axis. Between changes of hole, component and fluid all properties are constant. The soft and
!> the stiff string are integrated over them.
module dg_string_piece
   use dg_kinds, only: wp
   use dg_centralized_contact, only: body_share, spans_of, spans_type
   use dg_helical_load, only: least_helical_load
   use dg_component, only: axial_stiffness, bending_stiffness, centralizer_diameter, contact_diameter, find_bowing
   use dg_contact_friction, only: find_friction, running_drag
   use dg_drillstring, only: component_at, component_tops
   use dg_fluid, only: fluid_tops
   use dg_fluid_pressure, only: weight_at
   use dg_hole_section, only: hole_section_at
   use dg_model, only: model_type, string_index
   use dg_numerics, only: smears_all_joints
   use dg_trajectory, only: arc_type, arc_at, point_on_arc, top_md
   use dg_vector, only: cross
   implicit none
   private
   public :: layout_type, layout_of, piece_type, piece_above, share_contact, at_offset, climbed, breakpoints

   !> Changes closer together than this count as one in `breakpoints` [m]: round-off of depths.
   real(wp), parameter :: shortest_piece = 1.0e-6_wp

   !> Data by which a string is cut into pieces, found once for all pieces.
   type :: layout_type
      integer :: case_index = 0
      integer :: string = 0                   !< its number
      real(wp), allocatable :: heights(:)     !< of the tops of its components: minus their depths, from the bit up [m]
      real(wp), allocatable :: fluids(:)      !< depths at which a fluid begins, ascending [m]
   end type layout_type

   !> Friction of a contact.
   type :: rubbing_type
      real(wp) :: axial = 0.0_wp    !< f of the balance in dg_soft_string_loads [-]
      real(wp) :: rotary = 0.0_wp   !< m of that balance [-]
      real(wp) :: radius = 0.0_wp   !< [m]
   end type rubbing_type

   !> A piece of string of constant properties in one arc and one hole section.
   type :: piece_type
      type(arc_type) :: arc
      real(wp) :: top = 0.0_wp      !< measured depth of its upper end [m]
      real(wp) :: weight = 0.0_wp   !< buoyed [N/m]
      real(wp) :: radius = 0.0_wp   !< of contact [m]
      real(wp) :: drag = 0.0_wp     !< of bow springs, with the sign of f [N/m]
      real(wp) :: axial = 0.0_wp    !< f of the balance in dg_soft_string_loads [-]
      real(wp) :: rotary = 0.0_wp   !< m of that balance [-]
      real(wp) :: climb = 1.0_wp    !< contact force over load across the hole: 1/sqrt(1 + m^2) with wall climb, else 1 [-]
      real(wp) :: stiffness = 0.0_wp !< E I of the body, which a soft string neglects [N.m2]
      real(wp) :: stretching = 0.0_wp !< E A of the body [N]
      real(wp) :: reach = 0.0_wp    !< of its outside from its axis [m]
      real(wp) :: clearance = 0.0_wp !< (D - d)/2 [m]
      real(wp) :: joint_height = 0.0_wp !< of joints that touch one by one, over the body [m]
      real(wp) :: euler = 0.0_wp    !< Euler load of the body between two of these joints [N]
      real(wp) :: least_helical = 0.0_wp !< helical load without side load [N]
      logical :: coils = .false.    !< compression presses it on the wall in sinusoidal or helical buckling
      type(spans_type) :: spans     !< between centralizers
      type(rubbing_type) :: rubbing(2) !< of centralizers, of the body between them; set with spans
   end type piece_type

contains

   !> The layout of the string of a load case.
   pure function layout_of(model, case_index) result(layout)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(layout_type) :: layout
      associate (load_case => model%cases(case_index))
         layout%case_index = case_index
         layout%string = string_index(model%strings, load_case%string)
         allocate (layout%fluids, source=fluid_tops(model%mud, load_case%bit_depth))
         allocate (layout%heights, source=component_tops(model%strings(layout%string), &
                                                         load_case%bit_depth - top_md(model%trajectory)) - load_case%bit_depth)
      end associate
   end function layout_of

   !> The piece of string that ends at, or contains, a depth [m]. It reaches up to the next change of anything.
   pure function piece_above(model, layout, md, friction_scale, coiled, climbs) result(piece)
      type(model_type), intent(in) :: model
      type(layout_type), intent(in) :: layout
      real(wp), intent(in) :: md                        !< [m]
      real(wp), intent(in) :: friction_scale            !< on all coefficients [-]
      logical, intent(in), optional :: coiled, climbs   !< absent: false, and as the model says
      type(piece_type) :: piece
      real(wp) :: middle
      logical :: climbing
      integer :: i, k, hole
      i = arc_at(model%trajectory, md)
      if (model%trajectory%arcs(i)%md >= md .and. i > 1) i = i - 1
      piece%arc = model%trajectory%arcs(i)
      piece%top = piece%arc%md
      hole = hole_section_at(model%holes, md)
      if (hole > 1 .and. model%holes(hole)%md_top >= md) hole = hole - 1
      if (hole > 1) piece%top = max(piece%top, model%holes(hole)%md_top)
      i = component_at(layout%heights, -md)
      if (i < size(layout%heights)) piece%top = max(piece%top, -layout%heights(i))
      do k = 1, size(layout%fluids)
         if (layout%fluids(k) < md) piece%top = max(piece%top, layout%fluids(k))
      end do
      middle = 0.5_wp*(piece%top + md)
      associate (load_case => model%cases(layout%case_index), part => model%strings(layout%string)%components(i))
         piece%weight = weight_at(part, model, load_case, middle)
         piece%radius = 0.5_wp*contact_diameter(part, -layout%heights(i))
         if (part%centralizer%present) piece%radius = 0.5_wp*centralizer_diameter(part)
         piece%stiffness = bending_stiffness(part)
         piece%stretching = axial_stiffness(part)
         piece%reach = 0.5_wp*part%od
         piece%clearance = 0.5_wp*(model%holes(hole)%diameter - contact_diameter(part, -layout%heights(i)))
         call find_friction(model%holes(hole), part, load_case, part%centralizer%present, piece%radius, friction_scale, &
                            piece%axial, piece%rotary)
         if (.not. smears_all_joints(model%numerics)) &
            call find_bowing(part, -layout%heights(i), piece%joint_height, piece%euler)
         if (part%centralizer%present) then
            piece%drag = running_drag(model%holes(hole), part, load_case)/part%centralizer%spacing
            piece%spans = spans_of(part, model%holes(hole)%diameter, max(piece%clearance, 0.0_wp))
            piece%rubbing(1) = rubbing_type(piece%axial, piece%rotary, piece%radius)
            associate (body => piece%rubbing(2))
               body%radius = 0.5_wp*contact_diameter(part, -layout%heights(i))
               call find_friction(model%holes(hole), part, load_case, .false., body%radius, friction_scale, body%axial, body%rotary)
            end associate
         end if
      end associate
      if (present(coiled)) piece%coils = coiled .and. piece%clearance > 0.0_wp
      if (piece%coils) piece%least_helical = least_helical_load(piece%stiffness, piece%weight)
      climbing = model%numerics%wall_climb
      if (present(climbs)) climbing = climbing .or. climbs
      if (climbing) piece%climb = 1.0_wp/sqrt(1.0_wp + piece%rotary**2)
   end function piece_above

   !> Share the contact of a piece between its centralizers and the body between them. Its friction is their mean by force.
   pure subroutine share_contact(piece, load, axial)
      type(piece_type), intent(inout) :: piece   !< with spans
      real(wp), intent(in) :: load               !< across the hole [N/m]
      real(wp), intent(in) :: axial              !< effective [N]
      real(wp) :: parts(2)
      parts(2) = body_share(piece%spans, load, axial)
      parts(1) = 1.0_wp - parts(2)
      piece%axial = dot_product(parts, piece%rubbing%axial)
      piece%rotary = dot_product(parts, piece%rubbing%rotary)
      piece%radius = dot_product(parts, piece%rubbing%radius)
      if (piece%rotary > 0.0_wp) piece%radius = dot_product(parts, piece%rubbing%rotary*piece%rubbing%radius)/piece%rotary
      if (piece%climb < 1.0_wp) piece%climb = 1.0_wp/sqrt(1.0_wp + piece%rotary**2)
   end subroutine share_contact

   !> Position relative to the arc's start [m], weight across the hole [N/m] and curvature vector [1/m].
   pure subroutine at_offset(piece, offset, position, across, bend)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: offset   !< from the start of the piece's arc [m]
      real(wp), intent(out) :: position(3), across(3), bend(3)   !< [m], [N/m], [1/m]
      real(wp) :: tangent(3)
      call point_on_arc(piece%arc, offset, position, tangent, bend)
      across = piece%weight*([0.0_wp, 0.0_wp, 1.0_wp] - tangent(3)*tangent)
   end subroutine at_offset

   !> Contact force under a load across the hole [N/m]. It is the load itself, or with wall climb the force that balances it
   !> together with its own friction around the hole. Then load = n + m t x n, where the turning string comes to rest.
   pure function climbed(piece, tangent, load) result(contact)
      type(piece_type), intent(in) :: piece
      real(wp), intent(in) :: tangent(3)   !< of the hole, unit [-]
      real(wp), intent(in) :: load(3)      !< [N/m]
      real(wp) :: contact(3)
      contact = load
      if (piece%climb >= 1.0_wp) return
      contact = piece%climb**2*(load - piece%rotary*cross(tangent, load))
   end function climbed

   !> Depths between the top of the string and the bit where something changes, ascending, without doubles [m]. They are first
   !> station and bit, survey stations, ends of hole sections, components and fluids.
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
end module dg_string_piece

!> Beam elements of the string of one load case along the hole.
!>
!> Nodes are at survey stations and at ends of hole sections, of components and of fluids, so that no element contains a
!> change. More nodes between them limit the length. Properties of an element are those at its place in the hole before it
!> stretches.
module dg_mesh
   use dg_kinds, only: wp
   use dg_beam_element, only: membrane_length
   use dg_beam_section, only: beam_section_type, section_of
   use dg_centralizer, only: at_centralizer, bow_opening, bow_stiffness, contact_length
   use dg_component, only: centralizer_diameter, component_type, contact_diameter, effective_joint_length, &
                           has_bend, has_joints, has_pad, is_eccentric, room_of, room_of_held_bit
   use dg_contact_friction, only: find_friction, running_drag
   use dg_drillstring, only: all_centralizer_ends, at_joint, bend_within, component_at, component_tops, joint_ends, &
                             pad_within, tool_ends
   use dg_fluid, only: fluid_tops
   use dg_fluid_pressure, only: weight_at
   use dg_hole_section, only: hole_section_at, wall_of
   use dg_load_case, only: load_case_type, rotates
   use dg_merge_sort, only: sorted_places
   use dg_model, only: model_type, string_index
   use dg_trajectory, only: arc_at, frame_on_arc, high_side
   use dg_vector, only: cross
   implicit none
   private
   public :: mesh_type, new_mesh, node_depths, subdivided, graded, is_vertical, reach_of, upright, widest_beside

   type :: mesh_type
      integer :: nodes = 0
      integer :: elements = 0
      integer :: held = 1                        !< node that is held along the hole: the top, or the bit under a given hook load
      ! nodes
      real(wp), allocatable :: md(:)             !< measured depth [m]
      real(wp), allocatable :: frame(:, :, :)    !< columns t, n_1, n_2 of the hole axis (3,3,nodes) [-]
      real(wp), allocatable :: base(:, :)        !< position relative to the origin of its arc (3,nodes) [m]
      integer, allocatable :: arc(:)             !< arc of the trajectory
      logical, allocatable :: beside_edge(:)     !< added beside an edge of the string: a start is laid through the other nodes
      ! elements
      real(wp), allocatable :: length(:)         !< along the hole [m]
      real(wp), allocatable :: chord(:, :)       !< between nodes on the axis (3,elements) [m]
      type(beam_section_type), allocatable :: section(:)   !< lengths and stiffnesses for the beam elements
      real(wp), allocatable :: weight(:)         !< buoyed, per length [N/m]
      real(wp), allocatable :: clearance(:)      !< (D - d)/2 [m]
      real(wp), allocatable :: opening(:)        !< offset at which contact begins: the clearance, less for a bow spring [m]
      real(wp), allocatable :: radius(:)         !< of contact, d/2 [m]
      real(wp), allocatable :: lying(:)          !< clearance where the string lies: that of its joints [m]
      real(wp), allocatable :: load_factor(:)    !< contact load of an element over the string's mean, > 1 at joints [-]
      real(wp), allocatable :: spacing(:)        !< between joints, 0 if the string touches everywhere [m]
      real(wp), allocatable :: friction_along(:) !< friction along the hole, > 0 pushes down the hole [-]
      real(wp), allocatable :: friction_around(:) !< circumferential friction [-]
      real(wp), allocatable :: wall(:)           !< wall stiffness Gkc, or a bow spring's over its length [N/m2]
      real(wp), allocatable :: rigid(:)          !< of the wall beyond its elastic range, Gkmax [N/m2]
      real(wp), allocatable :: eps_nmax(:)       !< elastic range [-]
      real(wp), allocatable :: drag(:)           !< running force of bow springs, > 0 pushes down the hole [N]
      logical, allocatable :: centralizer(:)     !< a centralizer touches, at the middle of its element
      !> Angle by which an element is bent before loading, times the unit vector to which its lower end points (3,elements) [rad];
      !> not allocated where the whole string is straight.
      real(wp), allocatable :: bend(:, :)
      !> Force of pads on the string per length, across the hole (3,elements) [N/m]; not allocated where no tool has pads.
      real(wp), allocatable :: push(:, :)
      !> Centre of eccentric blades, where the wall is felt, off the axis of the string (3,elements) [m]; not allocated without.
      real(wp), allocatable :: blade(:, :)
   end type mesh_type

   !> Depths closer than this part of the element length are one node: survey, components and hole often share a depth.
   real(wp), parameter :: merge_share = 1.0e-3_wp
   !> Depths farther apart than this are two nodes, however long elements may be [m]. Decks round depths to millimetres. The edge
   !> of a blade may touch just above a wider hole.
   real(wp), parameter :: longest_merge = 0.0015_wp

   real(wp), parameter :: upright = 1.0_wp - 1.0e-12_wp      !< vertical to round-off: cosine of the inclination

contains

   !> True if the hole is vertical along the whole string, up or down.
   pure function is_vertical(mesh) result(vertical)
      type(mesh_type), intent(in) :: mesh
      logical :: vertical
      vertical = all(abs(mesh%frame(3, 1, :)) > upright)
   end function is_vertical

   !> Largest distance of the axis of the string from the hole axis within the wall [m]: the clearance, more by eccentric
   !> blades.
   pure function reach_of(mesh, e) result(reach)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp) :: reach
      reach = mesh%clearance(e)
      if (allocated(mesh%blade)) reach = reach + norm2(mesh%blade(:, e))
   end function reach_of

   !> Reach of the wider of the elements beside a node [m].
   pure function widest_beside(mesh, n) result(reach)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: n
      real(wp) :: reach
      reach = max(reach_of(mesh, max(n - 1, 1)), reach_of(mesh, min(n, mesh%elements)))
   end function widest_beside

   !> Make the mesh of a load case on given nodes. String and depths have been checked.
   pure subroutine new_mesh(model, load_case, depths, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: depths(:)   !< of the nodes, from the first station to the bit [m]
      type(mesh_type), intent(out) :: mesh
      real(wp) :: end_point(3), middle, top, upper_end, distance
      real(wp), allocatable :: tops(:)
      integer :: e, n, index, part
      index = string_index(model%strings, load_case%string)
      mesh%md = depths
      mesh%nodes = size(mesh%md)
      mesh%elements = mesh%nodes - 1
      mesh%held = merge(mesh%nodes, 1, model%hookload%present)
      allocate (mesh%frame(3, 3, mesh%nodes), mesh%base(3, mesh%nodes), mesh%arc(mesh%nodes))
      allocate (mesh%beside_edge(mesh%nodes), source=.false.)
      mesh%arc(1) = 1
      do n = 1, mesh%nodes
         mesh%arc(n) = arc_at(model%trajectory, mesh%md(n), near=mesh%arc(max(n - 1, 1)))
         associate (arc => model%trajectory%arcs(mesh%arc(n)))
            call frame_on_arc(arc, mesh%md(n) - arc%md, mesh%frame(:, 1, n), mesh%frame(:, 2, n), mesh%frame(:, 3, n), &
                              mesh%base(:, n))
         end associate
      end do
      n = mesh%elements
      allocate (mesh%length(n), mesh%chord(3, n), mesh%section(n), mesh%weight(n), mesh%clearance(n), &
                mesh%radius(n), mesh%friction_along(n), mesh%friction_around(n), mesh%wall(n), mesh%rigid(n), mesh%eps_nmax(n), &
                mesh%lying(n), mesh%load_factor(n), mesh%spacing(n), mesh%opening(n), mesh%drag(n), mesh%centralizer(n))
      top = mesh%md(1)
      allocate (tops(size(model%strings(index)%components)))
      tops = component_tops(model%strings(index), load_case%bit_depth - top)
      do e = 1, mesh%elements
         mesh%length(e) = mesh%md(e + 1) - mesh%md(e)
         end_point = mesh%base(:, e + 1)
         do n = mesh%arc(e), mesh%arc(e + 1) - 1
            end_point = end_point + model%trajectory%arcs(n)%chord
         end do
         mesh%chord(:, e) = end_point - mesh%base(:, e)
         middle = 0.5_wp*(mesh%md(e) + mesh%md(e + 1))
         part = component_at(tops, load_case%bit_depth - middle)
         upper_end = load_case%bit_depth - tops(part)
         associate (component => model%strings(index)%components(part))
            mesh%section(e) = section_of(component, mesh%length(e), &
                                         membrane_length(mesh%chord(:, e), mesh%frame(:, 1, e), mesh%frame(:, 1, e + 1)))
            mesh%weight(e) = weight_at(component, model, load_case, middle)
            distance = load_case%bit_depth - middle
            if (part > 1) distance = distance - tops(part - 1)
            mesh%centralizer(e) = at_centralizer(component%centralizer, distance)
            mesh%radius(e) = 0.5_wp*merge(centralizer_diameter(component), contact_diameter(component, upper_end), &
                                          mesh%centralizer(e))
            call set_hole_data(model, load_case, component, part == 1, middle, e, mesh)
            mesh%lying(e) = mesh%clearance(e)
            mesh%load_factor(e) = 1.0_wp
            mesh%spacing(e) = 0.0_wp
            if (component%centralizer%present) call set_centralizer(model, load_case, component, middle, e, mesh)
            if (component%centralizer%present) cycle
            if (.not. (model%numerics%discrete_joints .and. has_joints(component))) cycle
            mesh%spacing(e) = component%joint_spacing
            if (at_joint(component, distance)) then
               mesh%load_factor(e) = component%joint_spacing/effective_joint_length(component)
            else
               mesh%load_factor(e) = 0.0_wp
               mesh%radius(e) = 0.5_wp*component%od
               call set_hole_data(model, load_case, component, part == 1, middle, e, mesh)
            end if
         end associate
      end do
      if (load_case%bend_stands .or. .not. rotates(load_case%operation)) then
         if (any(has_bend(model%strings(index)%components))) call bend_mesh(model, load_case, tops, mesh)
         if (any(is_eccentric(model%strings(index)%components))) call offset_blades(model, load_case, tops, mesh)
      end if
      if (any(has_pad(model%strings(index)%components))) call push_mesh(model, load_case, tops, mesh)
   end subroutine new_mesh

   !> Set forces of pads on the elements. A steering tool presses to one side of the hole, so that pads do not turn with it.
   pure subroutine push_mesh(model, load_case, tops, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: tops(:)    !< from component_tops
      type(mesh_type), intent(inout) :: mesh
      real(wp) :: up(3), force(2)
      integer :: e
      allocate (mesh%push(3, mesh%elements), source=0.0_wp)
      do e = 1, mesh%elements
         force = pad_within(model%strings(string_index(model%strings, load_case%string)), tops, &
                            load_case%bit_depth - mesh%md(e + 1), load_case%bit_depth - mesh%md(e))
         if (.not. any(abs(force) > 0.0_wp)) cycle
         associate (t => mesh%frame(:, 1, e))
            up = high_side(t)
            mesh%push(:, e) = (force(1)*up + force(2)*cross(t, up))/mesh%length(e)
         end associate
      end do
   end subroutine push_mesh

   !> Bend the elements before loading: towards the tool face, about the hole axis at their place.
   pure subroutine bend_mesh(model, load_case, tops, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: tops(:)    !< from component_tops
      type(mesh_type), intent(inout) :: mesh
      real(wp) :: up(3), angle
      integer :: e
      allocate (mesh%bend(3, mesh%elements), source=0.0_wp)
      do e = 1, mesh%elements
         angle = bend_within(model%strings(string_index(model%strings, load_case%string)), tops, &
                             load_case%bit_depth - mesh%md(e + 1), load_case%bit_depth - mesh%md(e))
         if (.not. angle > 0.0_wp) cycle
         associate (t => mesh%frame(:, 1, e))
            up = high_side(t)
            mesh%bend(:, e) = angle*(cos(load_case%toolface)*up + sin(load_case%toolface)*cross(t, up))
         end associate
      end do
   end subroutine bend_mesh

   !> Set the centre of eccentric blades about the hole axis at their place. They turn with the tool face.
   pure subroutine offset_blades(model, load_case, tops, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: tops(:)    !< from component_tops
      type(mesh_type), intent(inout) :: mesh
      real(wp) :: clock
      integer :: e
      allocate (mesh%blade(3, mesh%elements), source=0.0_wp)
      do e = 1, mesh%elements
         associate (part => model%strings(string_index(model%strings, load_case%string))%components( &
                    component_at(tops, load_case%bit_depth - 0.5_wp*(mesh%md(e) + mesh%md(e + 1)))), t => mesh%frame(:, 1, e))
            if (.not. is_eccentric(part)) cycle
            clock = load_case%toolface + part%blade_clock
            mesh%blade(:, e) = part%blade_offset*(cos(clock)*high_side(t) + sin(clock)*cross(t, high_side(t)))
         end associate
      end do
   end subroutine offset_blades

   !> Set the data of the hole at a depth [m] for an element whose contact radius is known.
   pure subroutine set_hole_data(model, load_case, component, lowest, md, e, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(component_type), intent(in) :: component
      logical, intent(in) :: lowest      !< true for the lowest component of the string
      real(wp), intent(in) :: md
      integer, intent(in) :: e
      type(mesh_type), intent(inout) :: mesh
      associate (hole => model%holes(hole_section_at(model%holes, md)))
         mesh%clearance(e) = room_of(0.5_wp*hole%diameter - mesh%radius(e))
         if (lowest .and. model%boundary%bit_centred) &
            mesh%clearance(e) = room_of_held_bit(component, 0.5_wp*hole%diameter - mesh%radius(e))
         mesh%opening(e) = mesh%clearance(e)
         mesh%drag(e) = 0.0_wp
         call wall_of(hole, model%numerics%gk_contact, model%numerics%gk_max, mesh%wall(e), mesh%rigid(e))
         mesh%eps_nmax(e) = model%numerics%eps_nmax
         if (hole%mud_sheath > 0.0_wp) mesh%eps_nmax(e) = hole%mud_sheath/mesh%clearance(e)  ! = 2 t/(D - d)
         call find_friction(hole, component, load_case, mesh%centralizer(e), mesh%radius(e), 1.0_wp, mesh%friction_along(e), &
                            mesh%friction_around(e))
      end associate
   end subroutine set_hole_data

   !> Set centralizers on an element of their component, after set_hole_data: they carry all of its load.
   pure subroutine set_centralizer(model, load_case, component, md, e, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: md
      integer, intent(in) :: e
      type(mesh_type), intent(inout) :: mesh
      associate (centralizer => component%centralizer, hole => model%holes(hole_section_at(model%holes, md)))
         mesh%spacing(e) = centralizer%spacing
         mesh%load_factor(e) = merge(centralizer%spacing/contact_length, 0.0_wp, mesh%centralizer(e))
         if (centralizer%bow) then
            mesh%lying(e) = min(mesh%clearance(e), bow_opening(centralizer, hole%diameter) &
                                + abs(mesh%weight(e))*centralizer%spacing/bow_stiffness(centralizer, component%od))
         else
            mesh%lying(e) = 0.5_wp*(hole%diameter - centralizer_diameter(component))
         end if
         if (.not. mesh%centralizer(e)) return
         if (centralizer%bow) then
            mesh%opening(e) = min(bow_opening(centralizer, hole%diameter), mesh%clearance(e))
            mesh%eps_nmax(e) = (mesh%clearance(e) - mesh%opening(e))/mesh%opening(e)
            mesh%wall(e) = bow_stiffness(centralizer, component%od)/contact_length
            mesh%drag(e) = running_drag(hole, component, load_case)*mesh%length(e)/contact_length
         end if
      end associate
   end subroutine set_centralizer

   !> Depths of the nodes [m], from the first station to the bit: all breaks, and equal parts no longer than `element_length`.
   pure function node_depths(model, load_case, element_length) result(depths)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: element_length   !< longest element [m]
      real(wp), allocatable :: depths(:)
      real(wp), allocatable :: breaks(:), kept(:), tops(:)
      real(wp) :: top, bit, gap
      integer :: i, n
      top = model%trajectory%md(1)
      bit = load_case%bit_depth
      n = string_index(model%strings, load_case%string)
      allocate (tops(size(model%strings(n)%components)))
      tops = component_tops(model%strings(n), bit - top)
      breaks = [model%trajectory%md, model%holes%md_bottom, bit - tops, fluid_tops(model%mud, bit)]
      breaks = [breaks, bit - tool_ends(model%strings(n), tops)]
      breaks = [breaks, bit - all_centralizer_ends(model%strings(n), tops)]
      if (model%numerics%discrete_joints) breaks = [breaks, bit - joint_ends(model%strings(n), tops)]
      breaks = pack(breaks, breaks > top .and. breaks < bit)
      breaks = breaks(sorted_places(breaks))
      ! no component and no section of the hole is lost, however short
      gap = min(merge_share*element_length, longest_merge, 0.5_wp*minval(tops - [0.0_wp, tops(:size(tops) - 1)], &
                mask=tops > [0.0_wp, tops(:size(tops) - 1)]), 0.5_wp*minval(model%holes%md_bottom - model%holes%md_top))
      ! half a joint is at the lower end of its component
      if (model%numerics%discrete_joints) gap = min(gap, 0.25_wp*minval(effective_joint_length(model%strings(n)%components), &
                                                                        mask=has_joints(model%strings(n)%components)))
      allocate (kept(size(breaks) + 2))
      kept(1) = top
      n = 1
      do i = 1, size(breaks)
         if (breaks(i) - kept(n) <= gap .or. bit - breaks(i) <= gap) cycle
         n = n + 1
         kept(n) = breaks(i)
      end do
      n = n + 1
      kept(n) = bit
      depths = subdivided(kept(:n), spread(element_length, 1, n - 1))
   end function node_depths

   !> Depths with every interval cut into equal parts no longer than its `longest` [m].
   pure function subdivided(depths, longest) result(finer)
      real(wp), intent(in) :: depths(:), longest(:)   !< increasing (n), by interval (n-1) [m]
      real(wp), allocatable :: finer(:)
      integer :: pieces(size(longest)), i, j, n
      do i = 1, size(longest)
         pieces(i) = piece_count(depths(i + 1) - depths(i), longest(i))
      end do
      allocate (finer(sum(pieces) + 1))
      finer(1) = depths(1)
      n = 1
      do i = 1, size(longest)
         do j = 1, pieces(i) - 1
            finer(n + j) = depths(i) + (depths(i + 1) - depths(i))*j/pieces(i)
         end do
         n = n + pieces(i)
         finer(n) = depths(i + 1)
      end do
   end function subdivided

   !> Depths with every interval cut as by subdivided [m], and shorter beside intervals that had to be cut. Lengths grow there
   !> by (growth - 1) times the distance from them. Parts are cut in halves, so that neighbours differ by a factor of two. An
   !> interval that is short by itself does not limit others.
   pure function graded(depths, longest, growth) result(finer)
      real(wp), intent(in) :: depths(:), longest(:)   !< increasing (n), by interval (n-1) [m]
      real(wp), intent(in) :: growth       !< > 1 [-]
      real(wp), allocatable :: finer(:)
      real(wp), allocatable :: bound(:), parts(:), room(:), more(:)
      integer :: i, n, filled
      n = size(depths)
      allocate (bound(n), source=huge(1.0_wp))   ! length of an element that begins or ends here
      do i = 1, n - 1
         if (longest(i) < depths(i + 1) - depths(i)) bound(i:i + 1) = min(bound(i:i + 1), growth*longest(i))
      end do
      do i = 1, n - 1      ! lengths that grow by a factor grow linearly with distance
         bound(i + 1) = min(bound(i + 1), bound(i) + (growth - 1.0_wp)*(depths(i + 1) - depths(i)))
      end do
      do i = n - 1, 1, -1
         bound(i) = min(bound(i), bound(i + 1) + (growth - 1.0_wp)*(depths(i + 1) - depths(i)))
      end do
      allocate (room(2*n))
      filled = 0
      do i = 1, n - 1
         call grade_interval(depths(i:i + 1), longest(i), bound(i:i + 1), growth, parts)
         if (filled + size(parts) > size(room)) then
            allocate (more(2*(filled + size(parts))))
            more(:filled) = room(:filled)
            call move_alloc(more, room)
         end if
         room(filled + 1:filled + size(parts)) = parts
         filled = filled + size(parts) - 1       ! the last one begins the next interval
      end do
      finer = room(:filled + 1)
   end function graded

   !> Cut one interval into equal parts, and these in halves until all keep the bounds that grow from both ends.
   pure subroutine grade_interval(ends, longest, bound, growth, parts)
      real(wp), intent(in) :: ends(2), longest, bound(2), growth
      real(wp), allocatable, intent(out) :: parts(:)
      real(wp), allocatable :: length(:), most(:)
      integer :: n
      parts = subdivided(ends, [longest])
      if (parts(2) - parts(1) <= minval(bound)) return
      do
         n = size(parts) - 1
         length = parts(2:) - parts(:n)
         most = min(bound(1) + (growth - 1.0_wp)*(parts(:n) - ends(1)), bound(2) + (growth - 1.0_wp)*(ends(2) - parts(2:)))
         if (.not. any(most < (1.0_wp - merge_share)*length)) return
         parts = subdivided(parts, merge(0.5_wp*length, length, most < (1.0_wp - merge_share)*length))
      end do
   end subroutine grade_interval

   !> Number of elements in a piece of string, none longer than `element_length` but for round-off.
   pure function piece_count(length, element_length) result(pieces)
      real(wp), intent(in) :: length, element_length
      integer :: pieces
      pieces = max(1, ceiling(length/element_length*(1.0_wp - merge_share)))
   end function piece_count
end module dg_mesh

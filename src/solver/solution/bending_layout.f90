!> Position of the string of an analysis, and the beam that gives its moments (dg_bending_profile): nodes, loads and walls.
module dg_bending_layout
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, node_unknowns, set_elements
   use dg_gap_state, only: gap_law_type, state_free
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_model, only: model_type
   use dg_moved_walls, only: firm, soften_walls
   use dg_numerics, only: default_wall
   use dg_profile, only: profile_type
   use dg_trajectory, only: arc_at, closest_point, frame_on_arc, trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: solved_string_type, read_solved_string, find_breaks, stands_alone, new_beam

   !> Length of elements at a place where the moment changes quickly, over the bending length there [-].
   real(wp), parameter :: layer_share = 0.6_wp
   !> Smallest jump of EI times hole curvature between two bends that counts, over the largest such moment in the hole [-].
   real(wp), parameter :: jump_share = 0.02_wp
   !> Largest slope against the hole for which the beam is valid [-]. The beam neglects squares of slopes.
   real(wp), parameter :: steepest = 0.1_wp
   !> Relative change of stiffness or clearance that counts [-].
   real(wp), parameter :: change = 0.01_wp
   !> Nodes closer than this are one [m].
   real(wp), parameter :: sliver = 0.02_wp
   !> Distance of a node from the point of contact that it was made for, at most [m].
   real(wp), parameter :: same_place = 1.0e-6_wp
   !> Length of elements where clearance changes or a bend begins or ends [m]. It holds up to a distance `near_bit` above the
   !> bit [m]. An element feels the wall at a fifth of its length from its end. With elements of 0.1 m the edge of a tilted
   !> blade may enter a rigid wall unfelt.
   real(wp), parameter :: edge_length = 2.0e-3_wp, near_bit = 50.0_wp
   !> Clearance of an element whose only contact is a point [m].
   real(wp), parameter :: out_of_reach = 1.0e6_wp
   !> Distance from a free end over which stiffer springs hold a compressed string, over sqrt(EI/P) [-].
   real(wp), parameter :: end_reach = 8.0_wp
   !> Least force [N] and least load [N/m] in the formula of a bending length.
   real(wp), parameter :: least_force = 1.0_wp, least_load = 1.0e-6_wp

   !> The string of the analysis at the nodes of its mesh, in the frame of the hole at the present place of each node.
   type :: solved_string_type
      real(wp), allocatable :: slide(:)      !< how far a node has moved down the hole (n) [m]
      real(wp), allocatable :: y(:, :)       !< offset and slope against the hole axis (4,n) [m, -]
      real(wp), allocatable :: axial(:)      !< tension positive (n) [N]
      real(wp), allocatable :: bending(:)    !< bending moment (n) [N.m]
      real(wp), allocatable :: load(:)       !< contact force per metre, mean over an element and its neighbours (e) [N/m]
      logical, allocatable :: bends(:)       !< true if the beam replaces an element; false where it is too steep (e)
      real(wp) :: firm = firm                !< stiffness of its walls at one place of contact during Newton's steps [N/m]
      logical :: anchored = .false.          !< true if springs hold compressed parts at the string of the analysis
   end type solved_string_type

contains

   !> Read the position of the string from an analysis, and find the elements that the beam replaces.
   pure subroutine read_solved_string(model, mesh, work, profile, solved)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      type(profile_type), intent(in) :: profile
      type(solved_string_type), intent(out) :: solved
      real(wp) :: point(3), gap(3), t(3), n_1(3), n_2(3), unused(3), offset, slope, length
      integer :: n, e, arc, first, last
      allocate (solved%slide(mesh%nodes), solved%y(node_unknowns, mesh%nodes), solved%load(mesh%elements), &
                solved%bends(mesh%elements))
      solved%axial = profile%axial
      solved%bending = profile%bending
      do n = 1, mesh%nodes
         arc = mesh%arc(n)
         point = mesh%base(:, n) + work%shift(:, n)
         call closest_point(model%trajectory, arc, point, offset, gap, t, unused)
         solved%slide(n) = model%trajectory%arcs(arc)%md + offset - mesh%md(n)
         call frame_on_arc(model%trajectory%arcs(arc), offset, t, n_1, n_2)
         solved%y(1:2, n) = [dot_product(gap, n_1), dot_product(gap, n_2)]
         slope = max(dot_product(work%d(:, n), t), steepest)
         solved%y(3:4, n) = [dot_product(work%d(:, n), n_1), dot_product(work%d(:, n), n_2)]/slope
      end do
      ! the bit's support in the analysis yields by micrometres, that of the beam does not
      if (model%boundary%bit_centred) solved%y(1:2, mesh%nodes) = 0.0_wp
      do e = 1, mesh%elements
         first = max(e - 1, 1)
         last = min(e + 1, mesh%elements)
         length = sum(mesh%length(first:last))
         solved%load(e) = max(sum(work%normal(first:last)), 0.0_wp)/length
         solved%bends(e) = max(norm2(solved%y(3:4, e)), norm2(solved%y(3:4, e + 1))) < steepest
      end do
   end subroutine read_solved_string

   !> Depths along the string where the beam must have nodes, and the longest element allowed at each of them. They are:
   !> - the nodes of the mesh
   !> - centralizers, and tool joints in compression
   !> - beginnings and ends of bends, as seen from the displaced string
   !> - single contacts, if `alone`
   pure subroutine find_breaks(model, mesh, gaps, solved, alone, breaks, longest)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(solved_string_type), intent(in) :: solved
      logical, intent(in) :: alone                       !< true if nodes are wanted at single contacts
      real(wp), allocatable, intent(out) :: breaks(:)    !< increasing [m]
      real(wp), allocatable, intent(out) :: longest(:)   !< huge where a break has no limit (n) [m]
      real(wp) :: scale, largest, jump, place, share, bends(2, size(model%trajectory%arcs))
      integer :: e, n, arc, count, before, k
      associate (arcs => model%trajectory%arcs)
         largest = tiny(1.0_wp)
         do arc = 1, size(arcs)
            bends(:, arc) = curvature_in_frame(model%trajectory, arc)
         end do
         n = mesh%nodes + size(arcs) + mesh%elements
         allocate (breaks(n), longest(n))
         do e = 1, mesh%elements
            largest = max(largest, mesh%section(e)%ei*arcs(mesh%arc(e))%curvature)
         end do
         count = 0
         arc = 1
         do n = 1, mesh%nodes
            count = count + 1
            breaks(count) = mesh%md(n)
            longest(count) = huge(1.0_wp)
            e = min(n, mesh%elements)
            k = max(n - 1, 1)
            if (n == 1 .or. n == mesh%nodes) then
               longest(count) = layer_share*bending_length(mesh%section(e)%ei, solved%axial(n), mesh%clearance(e), &
                                                           max(solved%load(e), mesh%weight(e)))
            else if (differ(mesh%section(e)%ei, mesh%section(k)%ei) .or. differ(mesh%clearance(e), mesh%clearance(k))) then
               longest(count) = layer_share*min( &
                  bending_length(mesh%section(e)%ei, solved%axial(n), mesh%clearance(e), max(solved%load(e), mesh%weight(e))), &
                  bending_length(mesh%section(k)%ei, solved%axial(n), mesh%clearance(k), max(solved%load(k), mesh%weight(k))))
            end if
            if (is_edge(mesh, n)) longest(count) = min(longest(count), edge_length)
            if (n == mesh%nodes) exit
            if (is_point(mesh, gaps, solved%axial, n)) then
               count = count + 1
               breaks(count) = mesh%md(n) + gaps%xi(n)*mesh%length(n)
               longest(count) = huge(1.0_wp)
               cycle
            end if
            ! bends that begin beside this element of the displaced string
            before = count
            do while (arc < size(arcs))
               place = arcs(arc + 1)%md
               if (place > mesh%md(n + 1) + solved%slide(n + 1)) exit
               arc = arc + 1
               if (place < mesh%md(n) + solved%slide(n)) cycle
               jump = mesh%section(n)%ei*norm2(bends(:, arc) - bends(:, arc - 1))
               share = (place - mesh%md(n) - solved%slide(n))/(mesh%length(n) + solved%slide(n + 1) - solved%slide(n))
               place = mesh%md(n) + share*mesh%length(n)
               scale = huge(1.0_wp)
               if (jump > jump_share*largest) scale = layer_share*min( &
                  sqrt(mesh%section(n)%ei/max(abs(solved%axial(n)), abs(solved%axial(n + 1)), least_force)), &
                  sqrt(mesh%clearance(n)*mesh%section(n)%ei/jump))
               if (place - breaks(count) < sliver) then
                  longest(count) = min(longest(count), scale)
               else if (mesh%md(n + 1) - place < sliver) then      ! the next node takes its place
                  longest(count) = min(longest(count), scale + mesh%length(n))
               else
                  count = count + 1
                  breaks(count) = place
                  longest(count) = scale
               end if
            end do
            ! a single contact bends the string most at its own place
            if (alone .and. count == before .and. stands_alone(mesh, gaps, n)) then
               count = count + 1
               breaks(count) = mesh%md(n) + gaps%xi(n)*mesh%length(n)
               longest(count) = huge(1.0_wp)
            end if
         end do
         breaks = breaks(:count)
         longest = longest(:count)
      end associate
   end subroutine find_breaks

   !> True if clearance changes at a node, as at a blade's end, or a bent housing begins or ends. Nodes further than `near_bit`
   !> above the bit are no edges.
   pure function is_edge(mesh, n) result(is)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: n
      logical :: is
      is = n > 1 .and. n < mesh%nodes
      if (is) is = mesh%md(mesh%nodes) - mesh%md(n) < near_bit
      if (.not. is) return
      is = differ(mesh%clearance(n - 1), mesh%clearance(n))
      if (.not. is .and. allocated(mesh%bend)) is = any(abs(mesh%bend(:, n - 1)) > 0.0_wp) .neqv. any(abs(mesh%bend(:, n)) > 0.0_wp)
   end function is_edge

   !> True if the contact of an element is a point between its ends. That is so for centralizers, and for tool joints in
   !> compression, which touch in their middle. Pulled in a bend, a tool joint touches with both edges.
   pure function is_point(mesh, gaps, axial, e) result(is)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      real(wp), intent(in) :: axial(:)      !< at the nodes, tension > 0 [N]
      integer, intent(in) :: e
      logical :: is
      is = mesh%spacing(e) > 0.0_wp .and. mesh%load_factor(e) > 1.0_wp .and. is_between(mesh, gaps, e)
      if (is) is = mesh%centralizer(e) .or. min(axial(e), axial(e + 1)) < 0.0_wp
   end function is_point

   !> True if an element has a single contact between its ends, at the extremum that its gap follows.
   elemental function stands_alone(mesh, gaps, e) result(does)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      logical :: does
      does = gaps%followed(e) .and. gaps%state(e) /= state_free .and. is_between(mesh, gaps, e)
   end function stands_alone

   !> True if a gap is not next to an end of its element.
   pure function is_between(mesh, gaps, e) result(is)
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      integer, intent(in) :: e
      logical :: is
      is = gaps%xi(e)*mesh%length(e) > sliver .and. (1.0_wp - gaps%xi(e))*mesh%length(e) > sliver
   end function is_between

   !> True if two positive numbers differ by a significant change.
   pure function differ(a, b) result(yes)
      real(wp), intent(in) :: a, b
      logical :: yes
      yes = abs(a - b) > change*max(abs(a), abs(b))
   end function differ

   !> Length over which a moment fades [m], the shorter of two. Axial force gives sqrt(EI/|T|). Where a string meets or
   !> leaves its wall, a load q per metre gives (EI*c/q)**(1/4).
   pure function bending_length(ei, axial, clearance, load) result(length)
      real(wp), intent(in) :: ei, axial, clearance, load   !< [N.m2, N, m, N/m]
      real(wp) :: length
      length = min(sqrt(ei/max(abs(axial), least_force)), (ei*max(clearance, 0.0_wp)/max(load, least_load))**0.25_wp)
   end function bending_length

   !> Curvature of an arc along n_1 and n_2 of its frame [1/m].
   pure function curvature_in_frame(trajectory, arc) result(k)
      type(trajectory_type), intent(in) :: trajectory
      integer, intent(in) :: arc
      real(wp) :: k(2)
      associate (a => trajectory%arcs(arc))
         k = a%curvature*[dot_product(a%normal, a%lateral_1), dot_product(a%normal, a%lateral_2)]
      end associate
   end function curvature_in_frame

   !> The beam on given nodes. They must include all breaks (find_breaks) between the first and the last of them.
   pure subroutine new_beam(model, mesh, gaps, work, solved, nodes, beam)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(solved_string_type), intent(in) :: solved
      real(wp), intent(in) :: nodes(:)     !< depths along the string, increasing [m]
      type(bending_beam_type), intent(out) :: beam
      real(wp), parameter :: down(3) = [0.0_wp, 0.0_wp, 1.0_wp]
      real(wp) :: share, place, t(3), n_1(3), n_2(3), middle
      integer :: n, e, o, arc
      n = size(nodes)
      beam%md = nodes
      allocate (beam%place(n), beam%axial(n), beam%down(2, n), beam%owner(n - 1), beam%curvature(2, n - 1), beam%torque(n - 1), &
                beam%weight(n - 1), beam%element(n - 1))
      allocate (beam%held(n), beam%centred(n), source=.false.)
      allocate (beam%bend(2, n - 1), source=0.0_wp)
      if (allocated(mesh%push)) allocate (beam%push(2, n - 1))
      allocate (beam%viscous(n), source=0.0_wp)
      allocate (beam%point(0), beam%point_owner(0))
      o = 1
      arc = 1
      do e = 1, n
         do while (o < mesh%elements .and. mesh%md(o + 1) <= nodes(min(e, n - 1)))
            o = o + 1
         end do
         share = (nodes(e) - mesh%md(o))/mesh%length(o)
         beam%axial(e) = (1.0_wp - share)*solved%axial(o) + share*solved%axial(o + 1)
         place = nodes(e) + (1.0_wp - share)*solved%slide(o) + share*solved%slide(o + 1)
         beam%place(e) = place
         arc = arc_at(model%trajectory, place, near=arc)
         call frame_on_arc(model%trajectory%arcs(arc), place - model%trajectory%arcs(arc)%md, t, n_1, n_2)
         beam%down(:, e) = [dot_product(down, n_1), dot_product(down, n_2)]
         if (.not. solved%bends(o)) beam%held(e) = .true.
         if (e > 1) beam%held(e) = beam%held(e) .or. .not. solved%bends(beam%owner(e - 1))
         if (e == n) exit
         beam%owner(e) = o
         beam%torque(e) = -work%torque(o)
         beam%viscous(e:e + 1) = beam%viscous(e:e + 1) &
            + min(solved%axial(o), solved%axial(o + 1), 0.0_wp)**2/(4.0_wp*mesh%section(o)%ei)*0.5_wp*(nodes(e + 1) - nodes(e))
         beam%weight(e) = mesh%weight(o)
         beam%element(e)%section = mesh%section(o)
         if (allocated(mesh%bend)) &
            beam%bend(:, e) = [dot_product(mesh%bend(:, o), n_1), dot_product(mesh%bend(:, o), n_2)]/mesh%length(o)
         if (allocated(mesh%push)) beam%push(:, e) = [dot_product(mesh%push(:, o), n_1), dot_product(mesh%push(:, o), n_2)]
         if (allocated(mesh%blade)) &
            beam%element(e)%blade = [dot_product(mesh%blade(:, o), n_1), dot_product(mesh%blade(:, o), n_2)]
         beam%element(e)%law = gaps%law(o)
         beam%element(e)%law%clearance = mesh%opening(o)         ! a fitted gap has a clearance of its own
         call set_wall(gaps%law(o)%contact/mesh%length(o), gaps%law(o)%maximum/mesh%length(o), beam%element(e)%law)
         if (is_point(mesh, gaps, solved%axial, o)) then
            beam%element(e)%law%clearance = out_of_reach
            if (e > 1) then
               if (beam%owner(e - 1) == o .and. abs(nodes(e) - mesh%md(o) - gaps%xi(o)*mesh%length(o)) < same_place) then
                  beam%point = [beam%point, e]
                  beam%point_owner = [beam%point_owner, o]
               end if
            end if
         end if
         beam%element(e)%lever = mesh%radius(o)*mesh%friction_along(o)
         beam%element(e)%around = mesh%friction_around(o)*work%sideways(o)
      end do
      arc = 1
      do e = 1, n - 1
         middle = 0.5_wp*(beam%place(e) + beam%place(e + 1))
         arc = arc_at(model%trajectory, middle, near=arc)
         beam%curvature(:, e) = curvature_in_frame(model%trajectory, arc)
      end do
      call set_elements(beam)
      allocate (beam%point_law(size(beam%point)))
      beam%point_law = gaps%law(beam%point_owner)
      call soften_walls(huge(1.0_wp), solved%firm, beam)
      beam%centred(1) = model%boundary%top_centred .and. nodes(1) <= mesh%md(1)
      beam%centred(n) = model%boundary%bit_centred .and. nodes(n) >= mesh%md(mesh%nodes)
      if (nodes(1) <= mesh%md(1)) call hold_free_end(1, beam)
      if (nodes(n) >= mesh%md(mesh%nodes)) call hold_free_end(n, beam)
   end subroutine new_beam

   !> Set the stiffness of a wall in the beam. A wall that is meant to be rigid, as by default, is rigid. Else an edge with a
   !> contact of some millimetres would yield by a good part of a tight blade's clearance. A wall of 1e10 N/m2 or less changes
   !> by at most 1e-4. The function is smooth in between.
   pure subroutine set_wall(contact, maximum, law)
      real(wp), intent(in) :: contact, maximum       !< given: elastic, and beyond its range [N/m2]
      type(gap_law_type), intent(inout) :: law
      real(wp), parameter :: rigid = 1.0e13_wp      ! N/m2
      real(wp) :: harder
      harder = min(1.0_wp + rigid/default_wall*(contact/default_wall)**6, max(1.0_wp, rigid/contact))
      law%contact = harder*contact
      law%maximum = min(harder*maximum, max(maximum, rigid))
   end subroutine set_wall

   !> Raise the stiffness of the springs near a free end that is compressed. On a bed of stiffness k per length a long string
   !> buckles under 2*sqrt(k*EI). At a free end it buckles under sqrt(k*EI) (Hetenyi, Beams on Elastic Foundation, 1946). That
   !> mode fades over 2*sqrt(EI/P).
   pure subroutine hold_free_end(n, beam)
      integer, intent(in) :: n            !< the first or the last node
      type(bending_beam_type), intent(inout) :: beam
      real(wp) :: reach
      if (beam%centred(n) .or. beam%axial(n) > -least_force) return
      reach = end_reach*sqrt(beam%element(min(n, size(beam%element)))%section%ei/(-beam%axial(n)))
      where (abs(beam%md - beam%md(n)) < reach) beam%viscous = 4.0_wp*beam%viscous
   end subroutine hold_free_end
end module dg_bending_layout

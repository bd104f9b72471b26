!> Element lengths from the local scale of the problem, known from the soft string before anything is solved.
!>
!> One element has one gap, and feels the wall at one place. Between two gaps the string must therefore stay in the hole. It
!> must not sag through the wall, cut the corner of a bend, or buckle. Lengths grow gradually from short elements to long ones.
module dg_mesh_for_case
   use dg_kinds, only: wp
   use dg_case_result, only: scale_bend, scale_compression, scale_count, scale_end, scale_joint, scale_load, &
                             scale_neighbour
   use dg_helical_load, only: helical_contact, helical_load
   use dg_constants, only: pi
   use dg_load_case, only: load_case_type
   use dg_mesh, only: graded, is_vertical, mesh_type, new_mesh, node_depths, subdivided
   use dg_model, only: model_type
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_trajectory, only: arc_at, top_md
   implicit none
   private
   public :: mesh_for_case, cut_elements, near_edges, shortest, shortest_cut

   !> Longest element over a quarter wave pi/2*sqrt(2*EI/F) of a compressed string's buckling [-]. A longer element buckles
   !> between its nodes, where no gap can hold it, and the iteration does not converge.
   real(wp), parameter :: quarter_wave_share = 0.9_wp
   !> The same where the string is expected to buckle helically: eight elements a turn.
   real(wp), parameter :: helical_share = 0.5_wp
   !> Compression over the helical load from which the string buckles sinusoidally [-]: 1/sqrt(2) (Dawson & Paslay 1984) and a
   !> little.
   real(wp), parameter :: sinusoidal_share = 0.72_wp
   !> Part of the clearance by which an element may sag between fixed ends under its contact load [-]. A straight element may
   !> miss the hole's bend by the same part. At one half some wells do not converge. At a quarter contact in a dogleg of 9 deg
   !> in 20 m is 0.26 % too small, at this value 0.1 %.
   real(wp), parameter :: clearance_share = 0.2_wp
   !> Sag of the overhang at a free end over the clearance [-].
   real(wp), parameter :: overhang_share = 0.01_wp
   !> Longest element of a pipe body between tool joints over their spacing [-]. It is also at most sqrt(EI/|T|), the length
   !> over which its bending moment fades.
   real(wp), parameter :: body_share = 0.25_wp
   !> Lower bound of all local scales [m]: a contact patch is not shorter than a tool joint.
   real(wp), parameter :: shortest = 0.5_wp
   !> Growth factor of element lengths next to intervals that had to be cut [-]. The string goes on bending below the end of a
   !> bend. It leaves one wall there and reaches the other within lengths such as the bend's own elements have. Long elements
   !> next to them made the torque behind a bend of 67 deg/30 m wrong by 5 %.
   real(wp), parameter :: growth = 1.4_wp
   !> Longest element beside a bent housing [m], and the distance over which that holds [m]. The bend presses collars against
   !> the hole. On elements of 1 m the contact of a motor is 0.3 % too large.
   real(wp), parameter :: longest_beside_bend = 0.3_wp, reach_of_bend = 40.0_wp
   !> Length of the parts into which an element outside the hole is cut, over its own [-], and the shortest of them [m]. A bit
   !> or blade that tilts in its hole touches with both ends, and an element has one gap. With longer parts more motors with a
   !> bent housing do not converge.
   real(wp), parameter :: cut_share = 0.25_wp, shortest_cut = 0.02_wp

   !> Length of elements beside an edge of the string [m]. Contact at an edge is that short.
   real(wp), parameter :: edge_length = 0.05_wp
   !> The same within a distance of a bend [m]. The bend tilts the edge, which makes its contact shorter still.
   real(wp), parameter :: tilted_edge = 0.005_wp, tilted_within = 10.0_wp
   !> The same close to the bend [m], and beside pieces of the string not longer than `short_piece` [m]. Shorter elements do
   !> not converge there.
   real(wp), parameter :: bent_edge = 0.02_wp, bent_within = 0.5_wp, short_piece = 0.2_wp
   !> Length of an element over that of a shorter neighbour beside an edge [-].
   real(wp), parameter :: edge_growth = 1.3_wp
   !> Least change of radius over clearance that makes an end of a component an edge [-].
   real(wp), parameter :: edge_height = 0.3_wp

contains

   !> Mesh of a load case. Elements are not longer than `element_length`, which shrinks in a string shorter than
   !> numerics%full_length, nor than the local scale. If the soft string is locked up (totals%runaway), only `totals` and a
   !> first mesh are set.
   pure subroutine mesh_for_case(model, case_index, element_length, mesh, totals, compressed, strained, pressing, shortened)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: element_length   !< [m]
      type(mesh_type), intent(out) :: mesh
      type(soft_totals_type), intent(out) :: totals  !< of the helically buckled soft string
      real(wp), intent(out) :: compressed      !< largest compression of the soft string over its helical load [-]
      real(wp), intent(out) :: strained        !< largest axial strain of the soft string [-]
      real(wp), intent(out) :: pressing        !< largest expected contact load over its clearance [N/m2]
      integer, intent(out) :: shortened(:)     !< intervals that were cut, by the scale that required it (scale_count)
      real(wp), allocatable :: axial(:), torque(:), contact(:, :), longest(:), depths(:), bends(:)
      logical :: vertical, beside_bend
      real(wp) :: curvature, compression, side_load, across, share, scales(scale_count), at_most
      integer :: e, i
      compressed = 0.0_wp
      strained = 0.0_wp
      pressing = 0.0_wp
      shortened = 0
      associate (load_case => model%cases(case_index))
         at_most = element_length
         if (model%numerics%full_length > 0.0_wp) at_most = min(element_length, max(shortest, &
            element_length*((load_case%bit_depth - top_md(model%trajectory))/model%numerics%full_length)**2))
         call new_mesh(model, load_case, node_depths(model, load_case, at_most), mesh)
         allocate (axial(mesh%nodes), torque(mesh%nodes), contact(3, mesh%nodes), longest(mesh%elements))
         call soft_string_at(model, case_index, mesh%md, axial, torque, contact, totals, other_loads_type(coiled=.true.))
         if (totals%runaway) return
         vertical = is_vertical(mesh)
         allocate (bends, source=bend_depths(mesh))
         do e = 1, mesh%elements
            curvature = model%trajectory%arcs(arc_at(model%trajectory, 0.5_wp*(mesh%md(e) + mesh%md(e + 1)), &
                                                      near=mesh%arc(e)))%curvature
            compression = -min(axial(e), axial(e + 1))
            side_load = max(norm2(contact(:, e)), norm2(contact(:, e + 1)))
            across = merge(0.0_wp, mesh%weight(e), vertical)      ! where weight presses the string to no wall
            pressing = max(pressing, max(across, side_load, helical_contact(mesh%section(e)%ei, compression, mesh%clearance(e))) &
                                     *mesh%load_factor(e)/mesh%clearance(e))
            scales = local_scales(mesh%section(e)%ei, mesh%weight(e), mesh%clearance(e), curvature, compression, side_load)
            if (mesh%spacing(e) > 0.0_wp) scales(scale_joint) = &
               min(body_share*mesh%spacing(e), sqrt(mesh%section(e)%ei/max(abs(axial(e)), abs(axial(e + 1)), 1.0_wp)))
            if ((e == 1 .and. .not. model%boundary%top_centred) .or. (e == mesh%elements .and. .not. model%boundary%bit_centred)) &
               scales(scale_end) = free_end(mesh%section(e)%ei, mesh%weight(e), mesh%clearance(e))
            beside_bend = any(abs(mesh%md(e) - bends) < reach_of_bend)
            if (beside_bend) scales(scale_bend) = min(scales(scale_bend), longest_beside_bend)
            longest(e) = max(minval(scales), merge(longest_beside_bend, shortest, beside_bend))
            if (longest(e) < mesh%length(e)) then
               i = minloc(scales, dim=1)
               shortened(i) = shortened(i) + 1
            end if
            longest(e) = min(longest(e), mesh%length(e))
            side_load = min(norm2(contact(:, e)), norm2(contact(:, e + 1)))
            strained = max(strained, abs(axial(e))/mesh%section(e)%ea, abs(axial(e + 1))/mesh%section(e)%ea)
            if (.not. compression > 0.0_wp) cycle
            share = compression/helical_load(mesh%section(e)%ei, side_load, mesh%weight(e), mesh%clearance(e))
            compressed = max(compressed, share)
         end do
         depths = subdivided(mesh%md, longest)
         ! single tool joints set element lengths by their spacing, so that no gradual growth is needed
         if (.not. (model%numerics%discrete_joints .or. any(mesh%centralizer))) then
            e = size(depths)
            depths = graded(mesh%md, longest, growth)
            shortened(scale_neighbour) = size(depths) - e
         end if
         if (size(depths) > mesh%nodes) call new_mesh(model, load_case, depths, mesh)
         call cut_edges(model, load_case, mesh)
      end associate
   end subroutine mesh_for_case

   !> Put short elements on both sides of every edge of the string, with lengths that grow from there.
   pure subroutine cut_edges(model, load_case, mesh)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(mesh_type), intent(inout) :: mesh
      type(mesh_type) :: finer
      real(wp) :: longest(mesh%elements)
      real(wp), allocatable :: depths(:), bends(:)
      integer :: n, coarse
      allocate (bends, source=bend_depths(mesh))
      longest = mesh%length
      do n = 2, mesh%nodes - 1
         if (is_edge(mesh, n)) longest(n - 1:n) = min(longest(n - 1:n), length_at_edge(mesh%length(n - 1:n), mesh%md(n), bends))
      end do
      depths = graded(mesh%md, longest, edge_growth)
      depths = halved_pieces(mesh, depths)
      if (size(depths) == mesh%nodes) return
      call new_mesh(model, load_case, depths, finer)
      coarse = 1
      do n = 1, finer%nodes
         finer%beside_edge(n) = finer%md(n) < mesh%md(coarse)
         if (.not. finer%beside_edge(n)) coarse = coarse + 1
      end do
      mesh = finer
   end subroutine cut_edges

   !> Lengths of the elements on both sides of an edge [m].
   pure function length_at_edge(pieces, md, bends) result(lengths)
      real(wp), intent(in) :: pieces(2)     !< elements to be cut, above and below the edge [m]
      real(wp), intent(in) :: md, bends(:)  !< depths of the edge and of bends [m]
      real(wp) :: lengths(2)
      lengths = edge_length
      if (any(abs(md - bends) < bent_within)) then
         lengths = bent_edge
      else if (any(abs(md - bends) < tilted_within) .and. all(pieces > short_piece)) then
         lengths = tilted_edge
      end if
   end function length_at_edge

   !> Depths [m] with one more in the middle of each uncut piece between two edges, if it has less clearance than both its
   !> neighbours. Such a piece, a short blade or a ring, rests on both its ends, and an element has one gap.
   pure function halved_pieces(mesh, depths) result(finer)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: depths(:)    !< depths of the mesh, and others between them [m]
      real(wp), allocatable :: finer(:)
      real(wp) :: longest(size(depths) - 1)
      integer :: e, i
      longest = depths(2:) - depths(:size(depths) - 1)
      i = 1
      do e = 2, mesh%elements - 1
         do while (depths(i) < mesh%md(e))
            i = i + 1
         end do
         if (depths(i + 1) < mesh%md(e + 1) .or. mesh%clearance(e) >= min(mesh%clearance(e - 1), mesh%clearance(e + 1))) cycle
         if (is_edge(mesh, e) .and. is_edge(mesh, e + 1)) longest(i) = 0.5_wp*longest(i)
      end do
      finer = subdivided(depths, longest)
   end function halved_pieces

   !> True if the contact diameter changes at a node, as at a blade's end, or a bent housing begins or ends. Tool joints and
   !> centralizers that touch one by one have their contact in the middle of their element.
   pure function is_edge(mesh, n) result(is)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: n
      logical :: is
      is = abs(mesh%radius(n) - mesh%radius(n - 1)) > edge_height*max(mesh%clearance(n), mesh%clearance(n - 1)) .and. &
           .not. (mesh%spacing(n) > 0.0_wp .and. mesh%spacing(n - 1) > 0.0_wp)
      if (.not. is .and. allocated(mesh%bend)) is = any(abs(mesh%bend(:, n - 1)) > 0.0_wp) .neqv. any(abs(mesh%bend(:, n)) > 0.0_wp)
   end function is_edge

   !> True for elements within `reach_of_bend` of a bend or an edge, as of a stabilizer's blade. They are those of the stiff
   !> assembly.
   pure function near_edges(mesh) result(near)
      type(mesh_type), intent(in) :: mesh
      logical :: near(mesh%elements)
      logical :: marked(mesh%elements)      ! the upper node
      real(wp) :: last
      integer :: n
      marked = bends_at(mesh)
      do n = 2, mesh%elements
         marked(n) = marked(n) .or. is_edge(mesh, n)
      end do
      last = -huge(last)
      do n = 1, mesh%elements
         if (marked(n)) last = mesh%md(n)
         near(n) = mesh%md(n) - last < reach_of_bend
      end do
      last = huge(last)
      do n = mesh%elements, 1, -1
         if (marked(n)) last = mesh%md(n)
         near(n) = near(n) .or. last - mesh%md(n) < reach_of_bend
      end do
   end function near_edges

   !> Depths at which a housing is bent, or pads press [m]. Most strings have none.
   pure function bend_depths(mesh) result(depths)
      type(mesh_type), intent(in) :: mesh
      real(wp), allocatable :: depths(:)
      allocate (depths, source=pack(mesh%md(:mesh%elements), bends_at(mesh)))
   end function bend_depths

   !> True for elements at whose upper node a housing is bent, or pads press.
   pure function bends_at(mesh) result(there)
      type(mesh_type), intent(in) :: mesh
      logical :: there(mesh%elements)
      there = .false.
      if (allocated(mesh%bend)) there = any(abs(mesh%bend) > 0.0_wp, dim=1)
      if (allocated(mesh%push)) there = there .or. any(abs(mesh%push) > 0.0_wp, dim=1)
   end function bends_at

   !> Depths of the nodes [m] after marked elements, and those next to them, are cut in four. Parts are not shorter than
   !> `shortest_cut`. Neighbours are cut so that lengths grow gradually.
   pure function cut_elements(model, mesh, marked) result(depths)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: marked(:)
      real(wp), allocatable :: depths(:)
      real(wp) :: longest(mesh%elements)
      integer :: e
      longest = mesh%length
      do e = 1, mesh%elements
         if (any(marked(max(e - 1, 1):min(e + 1, mesh%elements)))) &
            longest(e) = min(mesh%length(e), max(cut_share*mesh%length(e), shortest_cut))
      end do
      if (model%numerics%discrete_joints .or. any(mesh%centralizer)) then
         depths = subdivided(mesh%md, longest)
      else
         depths = graded(mesh%md, longest, growth)
      end if
   end function cut_elements

   !> Longest element at a free end [m]. Half of it hangs over the last gap, and must not sag through the wall.
   elemental function free_end(ei, weight, clearance) result(length)
      real(wp), intent(in) :: ei, weight, clearance   !< [N.m2, N/m, m]
      real(wp) :: length
      length = huge(length)
      if (weight > 0.0_wp) length = max((8.0_wp*ei*overhang_share*clearance/weight)**0.25_wp, shortest)
   end function free_end

   !> Longest elements [m] that the local scales allow, by scale; huge where one has no limit.
   pure function local_scales(ei, weight, clearance, curvature, compression, side_load) result(lengths)
      real(wp), intent(in) :: ei           !< [N.m2]
      real(wp), intent(in) :: weight       !< [N/m]
      real(wp), intent(in) :: clearance    !< [m]
      real(wp), intent(in) :: curvature    !< of the hole [1/m]
      real(wp), intent(in) :: compression  !< [N], negative in tension
      real(wp), intent(in) :: side_load    !< contact force [N/m]
      real(wp) :: lengths(scale_count)
      real(wp) :: share, sag, rope
      lengths = huge(lengths)
      if (compression > 0.0_wp) then
         share = quarter_wave_share
         if (compression > sinusoidal_share*helical_load(ei, side_load, weight, clearance)) share = helical_share
         lengths(scale_compression) = share*0.5_wp*pi*sqrt(2.0_wp*ei/compression)
      end if
      if (curvature > 0.0_wp) lengths(scale_bend) = sqrt(8.0_wp*clearance_share*clearance/curvature)
      ! between fixed ends the stiffness of a beam and of a rope add up: sag = q/(384 EI/l^4 + 8 T/l^2)
      sag = clearance_share*clearance
      rope = 4.0_wp*max(-compression, 0.0_wp)*sag
      if (side_load > 0.0_wp) lengths(scale_load) = sqrt((rope + sqrt(rope**2 + 384.0_wp*ei*sag*side_load))/side_load)
   end function local_scales
end module dg_mesh_for_case

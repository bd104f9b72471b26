!> Rows of the profile of a string whose moments are those of the beam (dg_bending_profile).
module dg_bending_rows
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, bent_type, length_of
   use dg_bending_element, only: contact_xi
   use dg_bending_nodes, only: rows_needed
   use dg_case_result, only: case_result_type, unlike_contact_type
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type, reach_of
   use dg_model, only: model_type
   use dg_profile, only: new_profile, profile_type, side_above, side_below, state_elastic, state_free, state_rigid, taken_rows
   use dg_profile_rows, only: lay_rows
   use dg_trajectory, only: arc_at, azimuth_of, clock_angle, frame_on_arc, inclination_of, point_on_arc, trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: alike, clock_in_hole, compare_contact, contact_scale, merge_rows

   !> Two moments are alike if they differ by less than this part of the largest one [-].
   real(wp), parameter :: alike = 0.005_wp

   !> Least contact force to which a difference is compared [N].
   real(wp), parameter :: least_contact = 1.0_wp

contains

   !> Make the profile anew: a row at each node of the mesh, and between them as many nodes of the beam as the moment needs.
   !> Straight lines between the rows are then within a quarter of a per cent of the largest moment. Where something changes
   !> two rows stand at one depth, each with the contact of its own side.
   pure subroutine merge_rows(model, mesh, gaps, work, beam, bent, scale, result)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp), intent(in) :: scale(:)                  !< by element of the analysis, from contact_scale [-]
      type(case_result_type), intent(inout) :: result   !< profile: on entry of the analysis, on return of the beam
      type(profile_type) :: own, profile
      real(wp) :: moment(size(beam%md)), share, above(size(beam%md)), weight, across(2)
      logical :: kept(size(beam%md))
      integer, allocatable :: rows(:)
      integer :: n, o, row
      own = result%profile
      call choose_moments(mesh, beam, bent%forces, own%bending, moment, kept)
      rows = pack([(n, n=1, size(kept))], kept)
      above = contact_above(mesh, beam, bent)
      profile = new_profile(size(rows))
      do row = 1, size(rows)
         n = rows(row)
         o = beam%owner(min(n, size(beam%owner)))
         share = (beam%md(n) - mesh%md(o))/mesh%length(o)
         profile%md(row) = beam%md(n)
         call set_place(model%trajectory, mesh%arc(o), row, profile)
         weight = mesh%weight(o)*mesh%chord(3, o)
         profile%axial(row) = own%axial(o) - share*weight - above(n)*(own%axial(o) - own%axial(o + 1) - weight)
         profile%torque(row) = (1.0_wp - above(n))*own%torque(o) + above(n)*own%torque(o + 1)
         profile%bending(row) = moment(n)
         if (beam%held(n)) then       ! a node of the mesh
            if (share > 0.5_wp) o = o + 1
            profile%displacement(row) = own%displacement(o)
            profile%clock(row) = own%clock(o)
            profile%shear(row) = own%shear(o)
         else
            across = bent%y(1:2, n)
            profile%displacement(row) = length_of(across)
            profile%clock(row) = clock_in_hole(model%trajectory, mesh%arc(o), beam%place(n), across)
            profile%shear(row) = length_of(bent%forces(1:2, n) + beam%axial(n)*bent%y(3:4, n))
         end if
      end do
      call set_contact(model, mesh, gaps, beam, rows, contact_at_rows(mesh, work, beam, bent, scale, rows), result%case_index, &
                       profile)
      result%profile = profile
   end subroutine merge_rows

   !> Double the rows where something changes, and set side force and state of contact in all rows. The area under straight
   !> lines between the rows of a part of the string is the contact force of that part.
   pure subroutine set_contact(model, mesh, gaps, beam, rows, force, case_index, profile)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: rows(:)                    !< nodes of the beam that are rows
      real(wp), intent(in) :: force(:, :)               !< at the rows, of contact_at_rows [N]
      integer, intent(in) :: case_index
      type(profile_type), intent(inout) :: profile      !< on entry with one row a node
      integer, allocatable :: from(:), side(:)
      real(wp) :: length(2), share(2)
      integer :: state(2), element(2), row, i, k, n
      call lay_rows(model, case_index, profile%md, from, side)
      profile = taken_rows(profile, from)
      profile%side = side
      do i = 1, size(from)
         row = from(i)
         n = rows(row)
         length = beam%md([n, rows(min(row + 1, size(rows)))]) - beam%md([rows(max(row - 1, 1)), n])
         share = merge(0.0_wp, 1.0_wp, [side(i) == side_below, side(i) == side_above])
         profile%side_force(i) = 2.0_wp*sum(share*force(:, row))/sum(share*length)
         element = beam%owner([max(n - 1, 1), min(n, size(beam%owner))])
         do k = 1, 2
            state(k) = state_free
            if (beam%held(n)) then
               state(k) = gaps%state(element(k))
            else if (force(k, row) > 0.0_wp) then
               state(k) = merge(state_rigid, state_elastic, profile%displacement(i) > &
                                reach_of(mesh, element(k)) + mesh%eps_nmax(element(k))*mesh%clearance(element(k)))
            end if
         end do
         profile%gap_state(i) = maxval(state, mask=share > 0.0_wp)
      end do
   end subroutine set_contact

   !> Moments at the nodes of the beam, and which of these nodes become rows. Where the beam is held, moments are those of the
   !> analysis.
   pure subroutine choose_moments(mesh, beam, forces, bending, moment, kept)
      type(mesh_type), intent(in) :: mesh
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: forces(:, :)       !< at the nodes of the beam, see bent_type (4,n) [N, N.m]
      real(wp), intent(in) :: bending(:)         !< of the analysis, at the nodes of the mesh [N.m]
      real(wp), intent(out) :: moment(:)         !< (n) [N.m]
      logical, intent(out) :: kept(:)            !< nodes that become rows (n)
      real(wp) :: share
      integer :: n, o, e
      e = 1
      do n = 1, size(moment)
         moment(n) = length_of(forces(3:4, n))
         if (beam%held(n)) then
            o = beam%owner(min(n, size(beam%owner)))
            share = (beam%md(n) - mesh%md(o))/mesh%length(o)
            moment(n) = (1.0_wp - share)*bending(o) + share*bending(o + 1)
         end if
         kept(n) = .not. beam%md(n) < mesh%md(e)
         if (kept(n)) e = min(e + 1, mesh%nodes)
      end do
      kept(beam%point) = .true.       ! points of contact have rows of their own
      call rows_needed(beam%md, moment, 0.5_wp*alike*maxval(moment), kept)
   end subroutine choose_moments

   !> Contact force at each row, of the piece of string above it and of the piece below it (2,rows) [N]. A force between two
   !> rows is divided between them by the law of the lever.
   pure function contact_at_rows(mesh, work, beam, bent, scale, rows) result(forces)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp), intent(in) :: scale(:)        !< see contact_scale
      integer, intent(in) :: rows(:)          !< nodes of the beam that are rows, the first and the last among them
      real(wp) :: forces(2, size(rows))
      real(wp) :: ends(2, size(beam%element)), share(2)
      integer :: e, row
      ends = contact_at_ends(mesh, work, beam, bent, scale)
      forces = 0.0_wp
      row = 1
      do e = 1, size(beam%element)
         if (e == rows(row + 1)) row = row + 1
         associate (upper => beam%md(rows(row)), lower => beam%md(rows(row + 1)))
            share = (beam%md(e:e + 1) - upper)/(lower - upper)
         end associate
         forces(2, row) = forces(2, row) + sum((1.0_wp - share)*ends(:, e))
         forces(1, row + 1) = forces(1, row + 1) + sum(share*ends(:, e))
      end do
   end function contact_at_rows

   !> Part of an element's contact that lies above a node of the beam [-]. Friction has changed torque and axial force by that
   !> part. In an element without contact it is the part of the length.
   pure function contact_above(mesh, beam, bent) result(above)
      type(mesh_type), intent(in) :: mesh
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp) :: above(size(beam%md))
      real(wp) :: contact(size(beam%element)), total(mesh%elements)
      integer :: e, p
      contact = sum(bent%pressed, dim=1)
      do p = 1, size(bent%points)      ! between the two elements that meet there
         contact(beam%point(p) - 1:beam%point(p)) = contact(beam%point(p) - 1:beam%point(p)) + 0.5_wp*bent%points(p)
      end do
      total = 0.0_wp
      do e = 1, size(contact)
         above(e) = total(beam%owner(e))
         total(beam%owner(e)) = total(beam%owner(e)) + contact(e)
      end do
      do e = 1, size(contact)
         associate (o => beam%owner(e))
            if (total(o) > 0.0_wp) then
               above(e) = above(e)/total(o)
            else
               above(e) = (beam%md(e) - mesh%md(o))/mesh%length(o)
            end if
         end associate
      end do
      above(size(above)) = 1.0_wp
   end function contact_above

   !> Contact forces of the elements of the beam, at both of their ends (2,e) [N]. They are distributed as in the beam, and
   !> scaled to the sum of the analysis. The force of a point is spread over its element of the analysis. Elements that
   !> the beam does not replace have the forces of the analysis.
   pure function contact_at_ends(mesh, work, beam, bent, scale) result(forces)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp), intent(in) :: scale(:)        !< see contact_scale
      real(wp) :: forces(2, size(beam%element))
      integer :: e, o, p
      forces = 0.0_wp
      p = 1
      do e = 1, size(beam%element)
         o = beam%owner(e)
         associate (share => 0.5_wp*(beam%md(e + 1) - beam%md(e))/mesh%length(o))
            if (scale(o) > 0.0_wp) then
               forces(1, e) = scale(o)*sum((1.0_wp - contact_xi)*bent%pressed(:, e))
               forces(2, e) = scale(o)*sum(contact_xi*bent%pressed(:, e))
               do while (p < size(bent%points))
                  if (beam%point_owner(p) >= o) exit
                  p = p + 1
               end do
               if (size(bent%points) == 0) cycle
               if (beam%point_owner(p) == o) forces(:, e) = forces(:, e) + scale(o)*share*bent%points(p)
            else
               forces(:, e) = share*max(work%normal(o), 0.0_wp)
            end if
         end associate
      end do
   end function contact_at_ends

   !> Factors for the contact forces of the beam, by element of the analysis [-]. With them each run of elements that the beam
   !> replaces has the contact of the analysis. The factor is 0 where the forces of the analysis are used.
   pure function contact_scale(bends, normal, beam, bent) result(scale)
      logical, intent(in) :: bends(:)            !< elements that the beam replaces
      real(wp), intent(in) :: normal(:)          !< contact of the analysis, by element [N]
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp) :: scale(size(bends))
      scale = sum_over_sum(bends, max(normal, 0.0_wp), contact_by_element(size(bends), beam, bent))
   end function contact_scale

   !> Contact forces of the beam, summed by element of the analysis [N].
   pure function contact_by_element(elements, beam, bent) result(found)
      integer, intent(in) :: elements            !< of the analysis
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp) :: found(elements)
      integer :: e, p
      found = 0.0_wp
      do e = 1, size(beam%element)
         found(beam%owner(e)) = found(beam%owner(e)) + sum(bent%pressed(:, e))
      end do
      do p = 1, size(bent%points)
         found(beam%point_owner(p)) = found(beam%point_owner(p)) + bent%points(p)
      end do
   end function contact_by_element

   !> Compare the contact force of the analysis with that of the beam, part by part of the string. A part has one diameter and
   !> one clearance. `unlike` holds the part with the largest difference.
   pure subroutine compare_contact(mesh, bends, normal, beam, bent, unlike)
      type(mesh_type), intent(in) :: mesh
      logical, intent(in) :: bends(:)            !< elements that the beam replaces
      real(wp), intent(in) :: normal(:)          !< contact of the analysis, by element [N]
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      type(unlike_contact_type), intent(out) :: unlike
      real(wp) :: own(mesh%elements), found(mesh%elements), apart, most
      integer :: first, last
      own = max(normal, 0.0_wp)
      found = contact_by_element(mesh%elements, beam, bent)
      where (.not. bends) found = own
      unlike%by_analysis = sum(own)
      unlike%by_beam = sum(found)
      most = 0.0_wp
      first = 1
      do last = 1, mesh%elements
         if (last < mesh%elements) then
            if (is_same(mesh%radius(last), mesh%radius(last + 1)) .and. &
                is_same(mesh%clearance(last), mesh%clearance(last + 1))) cycle
         end if
         apart = abs(sum(found(first:last)) - sum(own(first:last)))
         if (apart > most) then
            most = apart
            unlike%md = [mesh%md(first), mesh%md(last + 1)]
         end if
         first = last + 1
      end do
      unlike%share = most/max(unlike%by_analysis, unlike%by_beam, least_contact)
   end subroutine compare_contact

   !> True if two lengths are equal within round-off.
   pure function is_same(a, b) result(same)
      real(wp), intent(in) :: a, b
      logical :: same
      same = abs(a - b) <= 1.0e-9_wp*max(abs(a), abs(b))
   end function is_same

   !> Sum of `forces` over sum of `found`, for each run of neighbouring elements that the beam replaces [-]. It is 0 for other
   !> elements, and where the second sum is 0.
   pure function sum_over_sum(bends, forces, found) result(scale)
      logical, intent(in) :: bends(:)
      real(wp), intent(in) :: forces(:), found(:)    !< by element: of the analysis, of the beam [N]
      real(wp) :: scale(size(bends))
      integer :: first, last
      scale = 0.0_wp
      last = 0
      do while (last < size(bends))
         first = last + 1
         last = first
         do while (last < size(bends))
            if (bends(last + 1) .neqv. bends(first)) exit
            last = last + 1
         end do
         if (bends(first) .and. sum(found(first:last)) > 0.0_wp) scale(first:last) = sum(forces(first:last))/sum(found(first:last))
      end do
   end function sum_over_sum

   !> Set position and direction of the hole axis at a row.
   pure subroutine set_place(trajectory, near, row, profile)
      type(trajectory_type), intent(in) :: trajectory
      integer, intent(in) :: near, row
      type(profile_type), intent(inout) :: profile
      real(wp) :: position(3), tangent(3), curvature(3)
      integer :: arc
      arc = arc_at(trajectory, profile%md(row), near=near)
      call point_on_arc(trajectory%arcs(arc), profile%md(row) - trajectory%arcs(arc)%md, position, tangent, curvature)
      position = trajectory%arcs(arc)%origin + position
      profile%north(row) = position(1)
      profile%east(row) = position(2)
      profile%tvd(row) = position(3)
      profile%inclination(row) = inclination_of(tangent)
      profile%azimuth(row) = azimuth_of(tangent)
   end subroutine set_place

   !> Clock angle [rad] of an offset in the frame of the hole.
   pure function clock_in_hole(trajectory, near, md, offset) result(clock)
      type(trajectory_type), intent(in) :: trajectory
      integer, intent(in) :: near
      real(wp), intent(in) :: md          !< [m]
      real(wp), intent(in) :: offset(2)   !< [m]
      real(wp) :: clock
      real(wp) :: t(3), n_1(3), n_2(3)
      integer :: arc
      arc = arc_at(trajectory, md, near=near)
      call frame_on_arc(trajectory%arcs(arc), md - trajectory%arcs(arc)%md, t, n_1, n_2)
      clock = clock_angle(t, offset(1)*n_1 + offset(2)*n_2)
   end function clock_in_hole
end module dg_bending_rows

!> Bending moment along a string that an analysis has solved, on elements that are short enough for it.
!>
!> An element of the analysis touches the wall at one point. Where elements are longer than the bending length sqrt(EI/T), the
!> string hangs like a bridge between these points. In a bend under tension the moment at the nodes is then too low. It is EI/R
!> times x/sinh(x) with x = L/2 sqrt(T/EI). Peaks at the ends of bends fall between nodes. Hook load, torque and the sum of
!> contact are right all the same. Here the string is solved again as a beam (dg_bending_beam), under the axial force and the
!> torque that were found. Elements are short at its ends and where the curvature of the hole, the stiffness or the clearance
!> changes. They grow from there. An element is halved if two ways to find its moment differ (`to_be_halved`). Bending, shear,
!> side force, offset and clock of the profile are those of that beam. Where it has a peak between two nodes of the mesh, rows
!> are added.
!>
!> Parts that slope against the hole by more than a tenth stay as in the analysis. The beam of small slopes is not valid there.
module dg_bending_profile
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, bent_type, contact_sum, find_forces, length_of
   use dg_bending_element, only: moments_of_shape
   use dg_bending_equilibrium, only: is_near, settle_firmly, solve_anchored
   use dg_bending_layout, only: find_breaks, read_solved_string, solved_string_type, new_beam, stands_alone
   use dg_bending_nodes, only: graded_nodes, halved_nodes, shape_at, shortening_of
   use dg_bending_rows, only: alike, clock_in_hole, compare_contact, contact_scale, merge_rows
   use dg_bending_solution, only: least_moment
   use dg_case_result, only: case_result_type
   use dg_contact_edges, only: moments_of_misplacing
   use dg_contact_list, only: list_contacts
   use dg_drillstring, only: component_tops
   use dg_fitted_gaps, only: are_worth_fitting, fit_gaps, fitted_gaps_type
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_moved_walls, only: firm, less_firm
   use dg_recovery, only: part_profile
   use dg_trajectory, only: arc_at, frame_on_arc, inclination_of, top_md, trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: bend_profile

   !> Elements are halved where two recoveries of the moment differ by more than this part of the largest moment [-]. A halving
   !> is repeated at most `most_rounds` times before the whole string is solved again. The whole string is solved at most
   !> `most_passes` times.
   real(wp), parameter :: rough = 6.0e-3_wp
   integer, parameter :: most_rounds = 6, most_passes = 3
   !> The same for moments near the largest one, which must not be underestimated [-].
   real(wp), parameter :: rough_peak = 3.0e-3_wp, near_largest = 0.06_wp
   !> A mesh is proven when halving all its elements changes no moment by more than this part of the largest [-]. At most
   !> `most_proofs` halvings are tried.
   real(wp), parameter :: proven = 0.005_wp
   integer, parameter :: most_proofs = 3
   !> Elements of this length or less are not halved to prove a mesh [m]. With elements of a quarter of a millimetre the
   !> solution diverged.
   real(wp), parameter :: finest = 4.0e-3_wp
   !> Number of elements on each side of halved ones that are solved with them.
   integer, parameter :: margin = 8
   !> Change of moments by the last step of an iteration, over the largest [-]: `roughly` on the first mesh, `settled` on later
   !> ones.
   real(wp), parameter :: settled = 2.0e-3_wp, roughly = 3.0e-2_wp
   !> Largest difference of the contact force of a part of the string from the analysis, over the larger force of the whole [-].
   !> With more, the beam is rejected.
   real(wp), parameter :: most_unlike = 0.5_wp
   !> Weight of a largest moment between two nodes against a difference of recoveries [-].
   real(wp), parameter :: peak_share = 5.0_wp
   !> No element becomes shorter than this by halving, except to prove a mesh [m].
   real(wp), parameter :: shortest = 0.01_wp

contains

   !> Replace the profile of a result by that of the beam, list its concentrated contacts, and estimate the error of its
   !> moments. If the beam finds no equilibrium near the analysis, the profile only gets double rows, and that error is
   !> missing.
   subroutine bend_profile(model, mesh, gaps, work, result, steep, fitted)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work          !< assembled at the solution
      type(case_result_type), intent(inout) :: result   !< profile: on entry at the nodes of the mesh, on return with more rows
      real(wp), intent(out) :: steep(2)                 !< depths between which elements are too steep for the beam, equal if there
                                                        !< are none [m]
      type(fitted_gaps_type), intent(out) :: fitted     !< gaps with the contact of the beam, filled if a fit is worth its cost
      type(solved_string_type) :: solved
      type(bending_beam_type) :: beam
      type(bent_type) :: bent
      real(wp), allocatable :: breaks(:), longest(:), nodes(:), other(:), scale(:)
      integer :: attempt, e
      result%moment_error = missing
      call read_solved_string(model, mesh, work, result%profile, solved)
      steep = 0.0_wp
      if (.not. all(solved%bends)) steep = [mesh%md(findloc(solved%bends, .false., dim=1)), &
                                           mesh%md(findloc(solved%bends, .false., dim=1, back=.true.) + 1)]
      if (.not. any(solved%bends)) then
         call part_profile(model, result%case_index, mesh, gaps, work, result%profile)
         return
      end if
      call find_breaks(model, mesh, gaps, solved, .true., breaks, longest)
      allocate (nodes, source=graded_nodes(breaks, longest))
      if (any(stands_alone(mesh, gaps, [(e, e=1, mesh%elements)]))) then
         call find_breaks(model, mesh, gaps, solved, .false., breaks, longest)
         allocate (other, source=graded_nodes(breaks, longest))
         if (size(other) == size(nodes)) deallocate (other)       ! none of them has a node of its own
      end if
      deallocate (breaks, longest, solved%load)
      do attempt = 1, merge(8, 4, allocated(other))
         solved%anchored = mod(attempt, 2) == 0
         solved%firm = merge(firm, less_firm, mod(attempt - 1, 4) < 2)
         if (attempt == 5) call move_alloc(other, nodes)       ! without nodes at single contacts
         call bend_again(model, mesh, gaps, work, solved, nodes, beam, bent, result%moment_error)
         if (is_missing(result%moment_error)) cycle
         call compare_contact(mesh, solved%bends, work%normal, beam, bent, result%unlike_contact)
         if (result%unlike_contact%share <= most_unlike) exit
         result%moment_error = missing
      end do
      if (is_missing(result%moment_error)) then
         call part_profile(model, result%case_index, mesh, gaps, work, result%profile)
         return
      end if
      result%moment_error = result%moment_error + alike       ! the rows may differ from the beam by this
      result%beam_nodes = size(beam%md)
      associate (found => result%unlike_contact, hard => contact_sum(bent))
         found%yielding = (hard - beam%pressed_softly)/max(hard, found%by_beam, tiny(1.0_wp))
         e = maxloc(sum(bent%pressed, dim=1)/beam%element%length, dim=1)
         found%point = beam%md(e)
         found%wall = gaps%law(beam%owner(e))%contact/mesh%length(beam%owner(e))
      end associate
      if (are_worth_fitting(model%trajectory, mesh, result%coiled, result%unlike_contact%share)) &
         call fit_gaps(mesh, solved%bends, beam, bent, gaps, work%normal, fitted)
      call set_bit(model%trajectory, mesh, beam, bent, result)
      call set_sag(model, beam, bent, result)
      result%shortening = shortening_of(beam%place, bent%y)
      scale = contact_scale(solved%bends, work%normal, beam, bent)
      call list_contacts(model, mesh, work, beam, bent, scale, result)
      call merge_rows(model, mesh, gaps, work, beam, bent, scale, result)
   end subroutine bend_profile

   !> Set side force of the bit, if it is held, and tilt of the bit to those of the beam. In the last element of the analysis
   !> the place of contact is only as exact as its gap.
   pure subroutine set_bit(trajectory, mesh, beam, bent, result)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      type(case_result_type), intent(inout) :: result
      integer :: n
      n = size(beam%md)
      if (beam%held(n)) return
      associate (arc => mesh%arc(mesh%elements), push => bent%forces(1:2, n), slope => bent%y(3:4, n))
         result%bit_tilt = atan(length_of(slope))
         result%bit_tilt_clock = clock_in_hole(trajectory, arc, beam%place(n), slope)
         if (.not. beam%centred(n)) return
         result%bit_side_force = length_of(push)
         result%bit_side_clock = clock_in_hole(trajectory, arc, beam%place(n), push)
      end associate
   end subroutine set_bit

   !> Inclination of the hole axis less that of the string at its lowest survey sensor. The string's direction is that of the hole
   !> and the slopes y' across it: t + y_1' n_1 + y_2' n_2 (convention 3).
   pure subroutine set_sag(model, beam, bent, result)
      type(model_type), intent(in) :: model
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      type(case_result_type), intent(inout) :: result
      real(wp) :: md, shape(4, 1), t(3), n_1(3), n_2(3), along(3)
      integer :: arc
      md = sensor_depth(model, result%case_index)
      if (is_missing(md) .or. md < beam%md(1) .or. md > beam%md(size(beam%md))) return
      shape = shape_at(beam%md, bent%y, [md])
      arc = arc_at(model%trajectory, md)
      call frame_on_arc(model%trajectory%arcs(arc), md - model%trajectory%arcs(arc)%md, t, n_1, n_2)
      along = t + shape(3, 1)*n_1 + shape(4, 1)*n_2
      result%sag_correction = inclination_of(t) - inclination_of(along/norm2(along))
      result%sensor_md = md
   end subroutine set_sag

   !> Measured depth of the lowest survey sensor of a load case's string [m]; missing without one.
   pure function sensor_depth(model, case_index) result(md)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp) :: md
      real(wp), allocatable :: tops(:)
      real(wp) :: bit
      integer :: i
      bit = model%cases(case_index)%bit_depth
      md = missing
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         do i = 1, size(tops)
            if (is_missing(string%components(i)%sensor)) cycle
            md = bit - string%components(i)%sensor
            if (i > 1) md = md - tops(i - 1)
            return
         end do
      end associate
   end function sensor_depth

   !> Equilibrium of the beam on nodes that are added until its moments are good. `error` is missing if there is no equilibrium
   !> near the string of the analysis.
   subroutine bend_again(model, mesh, gaps, work, solved, start, beam, bent, error)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(solved_string_type), intent(in) :: solved
      real(wp), intent(in) :: start(:)                          !< nodes to begin with [m]
      type(bending_beam_type), intent(out) :: beam
      type(bent_type), intent(out) :: bent
      real(wp), intent(out) :: error                            !< of moments, over the largest [-]
      real(wp), allocatable :: y(:, :), moments(:), differences(:)
      logical, allocatable :: marked(:)
      logical :: found
      integer :: round, pass
      error = missing
      allocate (y, source=shape_at(mesh%md, solved%y, start))
      call new_beam(model, mesh, gaps, work, solved, start, beam)
      call solve_anchored(mesh, solved, beam, y, roughly, found)
      if (.not. found) return
      call recover_moments(beam, y, bent, moments, differences)
      do pass = 1, most_passes
         do round = 1, most_rounds
            marked = to_be_halved(beam%md, moments, differences, largest_of(beam, moments))
            if (.not. any(marked)) exit
            call halve(model, mesh, gaps, work, solved, marked, beam, y)
            call recover_moments(beam, y, bent, moments, differences)
         end do
         if (pass > 1 .and. round == 1) exit      ! the whole string needs no shorter elements
         call solve_anchored(mesh, solved, beam, y, settled, found)
         if (.not. found) return
         call recover_moments(beam, y, bent, moments, differences)
      end do
      call settle_firmly(mesh, solved, beam, y)
      call recover_moments(beam, y, bent, moments, differences)
      if (.not. is_near(mesh, solved, beam%md, y, moments)) return
      error = maxval(differences)/largest_of(beam, moments)
      if (model%numerics%halve_moments) call prove(model, mesh, gaps, work, solved, beam, y, bent, moments, error)
   end subroutine bend_again

   !> Halve all elements longer than `finest` until that changes no moment by more than `proven` of the largest, or
   !> `most_proofs` times. `error` is the last change. It is missing if there is no equilibrium near the string of the
   !> analysis.
   subroutine prove(model, mesh, gaps, work, solved, beam, y, bent, moments, error)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(solved_string_type), intent(in) :: solved
      type(bending_beam_type), intent(inout) :: beam
      real(wp), allocatable, intent(inout) :: y(:, :)
      type(bent_type), intent(inout) :: bent
      real(wp), allocatable, intent(inout) :: moments(:)
      real(wp), intent(out) :: error
      real(wp), allocatable :: finer(:), shape(:, :), before(:), differences(:)
      logical, allocatable :: marked(:)
      integer, allocatable :: kept(:)          ! numbers of the nodes among the finer ones
      logical :: found
      integer :: round, n
      error = missing
      do round = 1, most_proofs
         n = size(beam%md)
         marked = beam%md(2:) - beam%md(:n - 1) > finest
         if (allocated(finer)) deallocate (finer)
         allocate (finer, source=halved_nodes(beam%md, marked))
         kept = [1, (n + 1 + count(marked(:n)), n=1, size(marked))]
         allocate (shape, source=shape_at(beam%md, y, finer))
         call move_alloc(shape, y)
         call new_beam(model, mesh, gaps, work, solved, finer, beam)
         call solve_anchored(mesh, solved, beam, y, settled, found)
         error = missing
         if (.not. found) return
         call settle_firmly(mesh, solved, beam, y)
         call move_alloc(moments, before)
         call recover_moments(beam, y, bent, moments, differences)
         if (.not. is_near(mesh, solved, beam%md, y, moments)) return
         error = maxval(abs(moments(kept) - before))/largest_of(beam, moments)
         if (error <= proven) return
      end do
   end subroutine prove

   !> Halve elements, and solve the beam again around them. Each neighbourhood is solved by itself, between nodes that are
   !> held. Where one finds no equilibrium, the shape of the longer elements stays.
   subroutine halve(model, mesh, gaps, work, solved, marked, beam, y)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(gap_table_type), intent(in) :: gaps
      type(workspace_type), intent(in) :: work
      type(solved_string_type), intent(in) :: solved
      logical, intent(in) :: marked(:)                  !< elements to be halved
      type(bending_beam_type), intent(inout) :: beam
      real(wp), allocatable, intent(inout) :: y(:, :)   !< (4,n) [m, -]
      type(bending_beam_type) :: part
      real(wp), allocatable :: finer(:), shape(:, :), own(:, :)
      integer, allocatable :: place(:)
      integer :: e, n, first, last, top, bottom
      logical :: found
      allocate (finer, source=halved_nodes(beam%md, marked))
      allocate (shape, source=shape_at(beam%md, y, finer))
      allocate (place(size(beam%md)))          ! number of each node among the finer ones
      n = 1
      do e = 1, size(beam%md)
         place(e) = n
         if (e < size(beam%md)) n = n + merge(2, 1, marked(e))
      end do
      last = 0
      do
         first = last + findloc(marked(last + 1:), .true., dim=1)
         if (first == last) exit
         last = first
         do e = first + 1, size(marked)
            if (e - last > 2*margin) exit
            if (marked(e)) last = e
         end do
         top = place(max(first - margin, 1))
         bottom = place(min(last + 1 + margin, size(beam%md)))
         call new_beam(model, mesh, gaps, work, solved, finer(top:bottom), part)
         part%held(1) = part%held(1) .or. top > 1
         part%held(size(part%held)) = part%held(size(part%held)) .or. bottom < size(finer)
         own = shape(:, top:bottom)
         call solve_anchored(mesh, solved, part, own, settled, found)
         if (found) shape(:, top:bottom) = own
         if (last == size(marked)) exit
      end do
      call move_alloc(shape, y)
      call new_beam(model, mesh, gaps, work, solved, finer, beam)
   end subroutine halve

   !> Largest moment [N.m], at least the moment that counts as zero, and never 0.
   pure function largest_of(beam, moments) result(largest)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: moments(:)
      real(wp) :: largest
      largest = max(maxval(moments), least_moment(beam), tiny(1.0_wp))
   end function largest_of

   !> Mark elements that are too long: two recoveries of the moment differ at one of their ends.
   pure function to_be_halved(nodes, moments, differences, largest) result(marked)
      real(wp), intent(in) :: nodes(:)                 !< [m]
      real(wp), intent(in) :: moments(:)               !< at the nodes [N.m]
      real(wp), intent(in) :: differences(:)           !< of two recoveries, at the nodes [N.m]
      real(wp), intent(in) :: largest                  !< of largest_of [N.m]
      logical :: marked(size(nodes) - 1)
      logical :: bad(size(nodes))
      integer :: n
      bad = differences > merge(rough_peak, rough, moments > (1.0_wp - near_largest)*largest)*largest
      do n = 1, size(marked)
         marked(n) = any(bad(n:n + 1)) .and. nodes(n + 1) - nodes(n) > 2.0_wp*shortest
      end do
   end function to_be_halved

   !> Moments at the nodes from the equilibrium of the elements, and their distance from the moments by the shape of the
   !> elements. The first are of higher order in the length of the elements. Where the distance is small they are right.
   pure subroutine recover_moments(beam, y, bent, moments, differences)
      type(bending_beam_type), intent(in) :: beam
      real(wp), contiguous, intent(in) :: y(:, :)
      type(bent_type), intent(out) :: bent
      real(wp), allocatable, intent(out) :: moments(:), differences(:)     !< 0 where the beam is held (n) [N.m]
      real(wp) :: bend(2, 2), above(2)
      integer :: n
      call find_forces(beam, y, bent)
      allocate (moments(size(y, 2)), differences(size(y, 2)), source=0.0_wp)
      above = 0.0_wp
      do n = 1, size(y, 2)
         if (n < size(y, 2)) call moments_of_shape(beam%element(n), y(:, n), y(:, n + 1), bend)
         if (.not. beam%held(n)) then
            moments(n) = length_of(bent%forces(3:4, n))
            if (n > 1 .and. n < size(y, 2)) &
               differences(n) = length_of(0.5_wp*(bend(:, 1) + above) + bent%forces(3:4, n))
         end if
         above = bend(:, 2)
      end do
      differences = max(differences, moments_of_misplacing(beam%md(2:) - beam%md(:size(beam%element)), bent%pressed))
      call add_peaks(beam, bent, moments, differences)
   end subroutine recover_moments

   !> Raise the differences where the largest moment of the string lies between two nodes, so that a node is added there. The
   !> moment between two nodes is a cubic through moments and their slopes at both.
   pure subroutine add_peaks(beam, bent, moments, differences)
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp), intent(in) :: moments(:)
      real(wp), intent(inout) :: differences(:)
      real(wp) :: slope(2), next(2), middle(2), largest
      integer :: e
      next = 0.0_wp
      largest = maxval(moments)
      do e = 1, size(moments)
         slope = next
         next = bent%forces(1:2, e) + beam%axial(e)*bent%y(3:4, e)      ! derivative of the moment along the string
         if (e == 1) cycle
         if (beam%held(e) .or. beam%held(e - 1)) cycle
         middle = -0.5_wp*(bent%forces(3:4, e - 1) + bent%forces(3:4, e)) + 0.125_wp*(beam%md(e) - beam%md(e - 1))*(slope - next)
         differences(e) = max(differences(e), peak_share*(length_of(middle) - largest))
      end do
   end subroutine add_peaks
end module dg_bending_profile

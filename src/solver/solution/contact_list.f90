!> List of the concentrated contacts of a string (dg_bending_profile): single tool joints, stabilizers, edges of contact, and
!> supports of the ends.
module dg_contact_list
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, bent_type, length_of
   use dg_bending_element, only: contact_places, contact_xi
   use dg_bending_rows, only: clock_in_hole
   use dg_case_result, only: case_result_type, contact_bit, contact_blades, contact_centralizer, contact_edge, contact_joint, &
                             contact_point_type, contact_top
   use dg_component, only: has_blades
   use dg_contact_edges, only: centroid, contact_edge_type, find_edges
   use dg_drillstring, only: component_at, component_tops
   use dg_mesh, only: mesh_type
   use dg_missing, only: is_missing
   use dg_model, only: model_type, string_index
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: list_contacts

   !> Cosine of the largest angle between forces of one contact [-]: 30 deg.
   real(wp), parameter :: one_side = 0.866_wp

   !> Contact forces of short lengths of string, from the top down.
   type :: stretches_type
      real(wp), allocatable :: md(:)          !< where the force acts [m]
      real(wp), allocatable :: length(:)      !< [m]
      real(wp), allocatable :: force(:)       !< [N]
      real(wp), allocatable :: towards(:, :)  !< direction in which it presses the wall, in the frame of the hole (2,n) [-]
      real(wp), allocatable :: load(:)        !< load per metre of weight and bends on the wall [N/m]
      integer, allocatable :: owner(:)        !< element of the analysis
      logical, allocatable :: spread(:)       !< true for a force of the beam on a wall that it feels all along
   end type stretches_type

contains

   !> Fill result%contacts, from the top down. Edges are only found where the beam replaces the string of the analysis.
   subroutine list_contacts(model, mesh, work, beam, bent, scale, result)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp), intent(in) :: scale(:)   !< by element, from contact_scale of dg_bending_rows [-]
      type(case_result_type), intent(inout) :: result
      type(stretches_type) :: stretches
      type(contact_edge_type), allocatable :: edges(:)
      type(contact_point_type) :: point
      integer :: kind(mesh%elements), i
      real(wp) :: pushed(2)
      call find_stretches(mesh, work, beam, bent, scale, stretches)
      kind = kinds_of(model, result%case_index, mesh)
      if (allocated(result%contacts)) deallocate (result%contacts)
      allocate (result%contacts(0))
      call add_groups(model, mesh, beam, kind, stretches, result%contacts)
      associate (force => merge(stretches%force, 0.0_wp, stretches%spread .and. kind(stretches%owner) == 0))
         call find_edges(stretches%md, stretches%length, force, stretches%load, result%normal_force, edges)
      end associate
      do i = 1, size(edges)
         point = contact_point_type(contact_edge, edges(i)%md, edges(i)%force, edges(i)%length)
         point%clock = clock_near(model, mesh, beam, edges(i)%md, bent%y(1:2, nearest_node(beam, edges(i)%md)))
         call insert(point, result%contacts)
      end do
      if (beam%centred(1) .and. .not. beam%held(1)) then
         pushed = -bent%forces(1:2, 1)
         point = contact_point_type(contact_top, beam%md(1), length_of(pushed))
         point%clock = clock_in_hole(model%trajectory, mesh%arc(1), beam%place(1), pushed)
         call insert(point, result%contacts)
      end if
      if (.not. is_missing(result%bit_side_force)) call insert( &
         contact_point_type(contact_bit, mesh%md(mesh%nodes), result%bit_side_force, 0.0_wp, result%bit_side_clock), &
         result%contacts)
   end subroutine list_contacts

   !> Collect all contact forces of the string, with the sum of the analysis. Each element of the beam has `contact_places` of
   !> them, and its points one each. Elements that the beam does not replace have the force of the analysis.
   pure subroutine find_stretches(mesh, work, beam, bent, scale, stretches)
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      type(bending_beam_type), intent(in) :: beam
      type(bent_type), intent(in) :: bent
      real(wp), intent(in) :: scale(:)
      type(stretches_type), intent(out) :: stretches
      real(wp) :: length, across(2)
      integer :: e, o, p, n, k
      n = contact_places*size(beam%element) + size(bent%points)
      allocate (stretches%md(n), stretches%length(n), stretches%force(n), stretches%load(n), stretches%owner(n), &
                stretches%spread(n), stretches%towards(2, n))
      n = 0
      k = 1
      do e = 1, size(beam%element)
         o = beam%owner(e)
         if (k <= size(bent%points)) then
            if (beam%point(k) == e) then
               call add(beam%md(e), mesh%length(o), merge(scale(o)*bent%points(k), max(work%normal(o), 0.0_wp), &
                                                          scale(o) > 0.0_wp), 0.0_wp, o, .false., n, stretches)
               stretches%towards(:, n) = direction(bent%y(1:2, e) + beam%element(e)%blade)
               k = k + 1
            end if
         end if
         length = beam%md(e + 1) - beam%md(e)
         do p = 1, contact_places
            associate (xi => contact_xi(p))
               across = (1.0_wp - xi)*(beam%weight(e)*beam%down(:, e) + beam%axial(e)*beam%curvature(:, e)) &
                        + xi*(beam%weight(e)*beam%down(:, e + 1) + beam%axial(e + 1)*beam%curvature(:, e))
               if (allocated(beam%push)) across = across + beam%push(:, e)
               if (scale(o) > 0.0_wp) then
                  call add(beam%md(e) + xi*length, length/contact_places, scale(o)*bent%pressed(p, e), length_of(across), &
                           o, .true., n, stretches)
               else
                  call add(beam%md(e) + xi*length, length/contact_places, &
                           max(work%normal(o), 0.0_wp)*length/(contact_places*mesh%length(o)), length_of(across), o, .false., n, &
                           stretches)
                  if (any(beam%point_owner == o)) stretches%force(n) = 0.0_wp     ! the force of this element acts at its point
               end if
               stretches%towards(:, n) = direction((1.0_wp - xi)*bent%y(1:2, e) + xi*bent%y(1:2, e + 1) + beam%element(e)%blade)
            end associate
         end do
      end do
   end subroutine find_stretches

   pure subroutine add(md, length, force, load, owner, is_spread, n, stretches)
      real(wp), intent(in) :: md, length, force, load
      integer, intent(in) :: owner
      logical, intent(in) :: is_spread
      integer, intent(inout) :: n          !< stretches so far
      type(stretches_type), intent(inout) :: stretches
      n = n + 1
      stretches%md(n) = md
      stretches%length(n) = length
      stretches%force(n) = force
      stretches%load(n) = load
      stretches%owner(n) = owner
      stretches%spread(n) = is_spread
   end subroutine add

   !> Kind of contact at each element of the analysis: contact_centralizer, contact_joint where tool joints stand one by one,
   !> contact_blades, else 0.
   pure function kinds_of(model, case_index, mesh) result(kind)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(mesh_type), intent(in) :: mesh
      integer :: kind(mesh%elements)
      real(wp), allocatable :: tops(:)
      real(wp) :: height
      integer :: e, string
      string = string_index(model%strings, model%cases(case_index)%string)
      associate (components => model%strings(string)%components, bottom => mesh%md(mesh%nodes))
         allocate (tops, source=component_tops(model%strings(string), bottom - mesh%md(1)))
         do e = 1, mesh%elements
            kind(e) = 0
            height = bottom - mesh%md(e) - 0.5_wp*mesh%length(e)
            if (has_blades(components(component_at(tops, height)))) then
               kind(e) = contact_blades
            else if (mesh%spacing(e) > 0.0_wp .and. mesh%load_factor(e) > 1.0_wp) then
               kind(e) = merge(contact_centralizer, contact_joint, mesh%centralizer(e))
            end if
         end do
      end associate
   end function kinds_of

   !> Direction of an offset; 0 on the axis.
   pure function direction(offset) result(towards)
      real(wp), intent(in) :: offset(2)       !< [m]
      real(wp) :: towards(2)
      towards = offset/max(norm2(offset), tiny(1.0_wp))
   end function direction

   !> Add contacts for each run of touching elements of one kind: a joint, or a stabilizer. A tilted one has two, where its
   !> upper and its lower edge press different sides. The force of a contact is the sum of its vectors.
   pure subroutine add_groups(model, mesh, beam, kind, stretches, contacts)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(bending_beam_type), intent(in) :: beam
      integer, intent(in) :: kind(:)        !< of elements of the analysis
      type(stretches_type), intent(in) :: stretches
      type(contact_point_type), allocatable, intent(inout) :: contacts(:)
      type(contact_point_type) :: point
      real(wp) :: pushed(2), next(2)
      integer :: of(size(stretches%owner)), first, last
      of = kind(stretches%owner)
      last = 0
      do while (last < size(of))
         first = last + 1
         last = first
         pushed = stretches%force(first)*stretches%towards(:, first)
         do while (last < size(of))
            if (of(last + 1) /= of(first)) exit
            next = stretches%force(last + 1)*stretches%towards(:, last + 1)
            if (dot_product(next, pushed) < one_side*norm2(next)*norm2(pushed)) exit
            pushed = pushed + next
            last = last + 1
         end do
         if (of(first) == 0) cycle
         associate (force => stretches%force(first:last))
            if (.not. sum(force) > 0.0_wp) cycle
            point = contact_point_type(of(first), centroid(stretches%md(first:last), force), norm2(pushed), &
                                       sum(stretches%length(first:last), mask=force > 0.0_wp))
         end associate
         point%clock = clock_near(model, mesh, beam, point%md, pushed)
         call insert(point, contacts)
      end do
   end subroutine add_groups

   !> Insert a contact by its depth.
   pure subroutine insert(point, contacts)
      type(contact_point_type), intent(in) :: point
      type(contact_point_type), allocatable, intent(inout) :: contacts(:)
      integer :: n
      n = count(contacts%md <= point%md)
      contacts = [contacts(:n), point, contacts(n + 1:)]
   end subroutine insert

   !> Clock angle [rad] of a direction across the hole, in the frame of the node of the beam that is nearest to a depth.
   pure function clock_near(model, mesh, beam, md, across) result(clock)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: md           !< [m]
      real(wp), intent(in) :: across(2)
      real(wp) :: clock
      integer :: n
      n = nearest_node(beam, md)
      clock = clock_in_hole(model%trajectory, mesh%arc(beam%owner(min(n, size(beam%owner)))), beam%place(n), across)
   end function clock_near

   !> Node of the beam that is nearest to a depth.
   pure function nearest_node(beam, md) result(n)
      type(bending_beam_type), intent(in) :: beam
      real(wp), intent(in) :: md           !< [m]
      integer :: n
      n = minloc(abs(beam%md - md), dim=1)
   end function nearest_node
end module dg_contact_list

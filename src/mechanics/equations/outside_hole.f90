!> Distance of a solved string outside its hole. An element's gap feels the wall at one place. If the string touches at two
!> places, it leaves the hole at the other one. That happens at the step of a casing shoe and farther down, or at both ends of
!> a buckling wave.
module dg_outside_hole
   use dg_kinds, only: wp
   use dg_gap_location, only: extremum_of_displacement
   use dg_gap_survey, only: at_blade, node_lie, out_of_reach, point_on_string
   use dg_numerics, only: default_wall
   use dg_mesh, only: mesh_type, reach_of
   use dg_profile, only: profile_type
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_diameter, unit_length, unit_wall
   use dg_units, only: unit_system_type
   use dg_trajectory, only: gap_to_axis, trajectory_type
   use dg_workspace, only: workspace_type
   implicit none
   private
   public :: outside_type, measure_outside, measure_rows, outside_message, outside_place

   !> Distance outside the hole, over the clearance [-], above which a message reports it: rock yields and elements sag.
   real(wp), parameter :: least_outside = 0.2_wp
   !> If no point of an element can be outside by this part of that limit [-], the element is not examined closer. A cubic and
   !> an arc differ by far less.
   real(wp), parameter :: sure = 0.75_wp
   !> Length of the elements that are advised over the one outside [-]. It brings four of five strings inside, and a quarter
   !> hardly more. Elements shorter than `short` [m] are pieces of blades, for which shorter ones do not help.
   real(wp), parameter :: advised = 0.5_wp, short = 0.5_wp
   !> The wall is said to yield if the gap is outside by more than this part of the largest excess [-].
   real(wp), parameter :: of_the_wall = 0.5_wp
   !> Digits of lengths in the message.
   integer, parameter :: shown = 2, shown_depth = 6
   !> Words that mark every such message.
   character(*), parameter :: outside_place = ' outside its hole at '

   !> Place where a string is farthest outside, in clearances of the hole section and component there.
   type :: outside_type
      integer :: elements = 0          !< number of elements outside by more than is reported
      real(wp) :: excess = 0.0_wp      !< largest excess: offset over clearance, less one [-]
      real(wp) :: clearance = 0.0_wp   !< clearance there [m]
      real(wp) :: md = 0.0_wp          !< depth of that point of the string before loading [m]
      real(wp) :: length = 0.0_wp      !< length of its element [m]
      real(wp) :: wall = 0.0_wp        !< stiffness of its wall in elastic contact [N/m2]
      logical :: gives_way = .false.   !< true if the wall itself is pressed in
   end type outside_type

contains

   !> Measure every element of a solution at the largest offset of its cubic shape, ends included. In a mud sheath the string
   !> may be as deep as that is thick. `work` has the nodes placed and the gaps surveyed.
   pure subroutine measure_outside(trajectory, mesh, work, outside, cut)
      type(trajectory_type), intent(in) :: trajectory
      type(mesh_type), intent(in) :: mesh
      type(workspace_type), intent(in) :: work
      type(outside_type), intent(out) :: outside
      !> True for elements to be cut. Most are outside by more than is reported while their gap is not: the wall does not
      !> yield. In others the gap presses the wall in by as much while one end does not touch it. That happens where a blade
      !> tilts or contact ends. The wall of the whole element would then act against one edge.
      logical, intent(out), optional :: cut(:)
      real(wp) :: gap_i(3), gap_j(3), slope_i(3), slope_j(3), blade_i(3), blade_j(3)
      real(wp) :: gap(3), tangent(3), curvature(3), point(3), xi, largest, excess, pressed_in
      integer :: e, arc
      if (present(cut)) cut = .false.
      call node_lie(trajectory, mesh, work, 1, gap_j, slope_j)
      do e = 1, mesh%elements
         gap_i = gap_j
         slope_i = slope_j
         call node_lie(trajectory, mesh, work, e + 1, gap_j, slope_j)
         blade_i = at_blade(mesh, e, gap_i)
         blade_j = at_blade(mesh, e, gap_j)
         if (out_of_reach(blade_i, slope_i, blade_j, slope_j, mesh%length(e), &
                          (1.0_wp + sure*told_from(mesh, e))*mesh%clearance(e))) cycle
         call extremum_of_displacement(blade_i, slope_i, blade_j, slope_j, mesh%length(e), xi, largest)
         point = mesh%base(:, e) + point_on_string(mesh, work, e, xi)
         arc = mesh%arc(e)
         call gap_to_axis(trajectory, arc, point, gap, tangent, curvature)
         gap = at_blade(mesh, e, gap)
         excess = sqrt(gap(1)**2 + gap(2)**2 + gap(3)**2)/mesh%clearance(e) - 1.0_wp
         if (.not. is_told(excess, mesh, e)) cycle
         pressed_in = max(work%displacement(e)/mesh%clearance(e) - 1.0_wp, 0.0_wp)
         if (present(cut)) cut(e) = is_told(excess - pressed_in, mesh, e) .or. &
            (is_told(pressed_in, mesh, e) .and. min(norm2(blade_i), norm2(blade_j)) < mesh%clearance(e))
         outside%elements = outside%elements + 1
         if (excess <= outside%excess) cycle
         outside%excess = excess
         outside%clearance = mesh%clearance(e)
         outside%md = mesh%md(e) + xi*mesh%length(e)
         outside%length = mesh%length(e)
         outside%wall = mesh%wall(e)
         outside%gives_way = work%displacement(e)/mesh%clearance(e) - 1.0_wp > of_the_wall*excess
      end do
   end subroutine measure_outside

   !> Measure the rows of a profile, of which there are more than nodes of the mesh. A row between two elements is measured in
   !> the narrower one. An eccentric blade may be on either side.
   pure subroutine measure_rows(mesh, profile, outside)
      type(mesh_type), intent(in) :: mesh
      type(profile_type), intent(in) :: profile
      type(outside_type), intent(out) :: outside
      real(wp) :: excess
      integer :: i, e, narrow, last
      e = 1
      last = 0
      do i = 1, size(profile%md)
         do while (e < mesh%elements .and. profile%md(i) > mesh%md(e + 1))
            e = e + 1
         end do
         narrow = e
         if (profile%md(i) >= mesh%md(e + 1) .and. e < mesh%elements) then
            if (reach_of(mesh, e + 1) < reach_of(mesh, e)) narrow = e + 1
         end if
         excess = (profile%displacement(i) - reach_of(mesh, narrow))/mesh%clearance(narrow)
         if (.not. is_told(excess, mesh, narrow)) cycle
         if (narrow /= last) outside%elements = outside%elements + 1
         last = narrow
         if (excess <= outside%excess) cycle
         outside%excess = excess
         outside%clearance = mesh%clearance(narrow)
         outside%md = profile%md(i)
         outside%length = mesh%length(narrow)
      end do
   end subroutine measure_rows

   !> True if an excess over the clearance [-] in an element is to be reported.
   pure function is_told(excess, mesh, e) result(told)
      real(wp), intent(in) :: excess
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      logical :: told
      told = excess > told_from(mesh, e)
   end function is_told

   !> Least excess over the clearance that is reported [-].
   pure function told_from(mesh, e) result(least)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp) :: least
      least = max(least_outside, mesh%eps_nmax(e))
   end function told_from

   !> Message on a string outside its hole: place, distance, advice.
   pure subroutine outside_message(units, outside, text)
      type(unit_system_type), intent(in) :: units
      type(outside_type), intent(in) :: outside
      character(:), allocatable, intent(out) :: text
      text = in_units(units, unit_diameter, outside%excess*outside%clearance, shown)//outside_place// &
             in_units(units, unit_length, outside%md, shown_depth)//', of '// &
             in_units(units, unit_diameter, outside%clearance, shown)//' clearance'
      if (outside%elements > 1) text = text//'. '//to_text(outside%elements)// &
         ' elements stand outside by more than a fifth of their clearance'
      if (outside%gives_way) then
         text = 'The wall gives way: the string stands '//text
         if (outside%wall < default_wall) text = text//'. Set wall_stiffness to '// &
            in_units(units, unit_wall, default_wall, shown)//', the default, which is as good as rigid'
      else
         text = 'Between its contact points the solution puts the string '//text//'. Contact there may be off'
         if (outside%length > short) text = text//'. Set element_length to '// &
            in_units(units, unit_length, advised*outside%length, shown)//' in &solver, which helps most strings'
      end if
   end subroutine outside_message
end module dg_outside_hole

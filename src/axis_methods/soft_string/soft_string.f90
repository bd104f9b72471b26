!> The flexible model (soft string) of a load case, with a result like any other model's.
module dg_soft_string
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_clock, only: seconds_between
   use dg_component, only: bending_stiffness, contact_diameter
   use dg_drillstring, only: component_at, component_tops
   use dg_error, only: error_type, raise, status_bad_input
   use dg_finite_result, only: finish_result
   use dg_hole_section, only: hole_section_at
   use dg_fluid_pressure, only: surface_push
   use dg_job, only: model_soft
   use dg_model, only: model_type, string_index
   use dg_packer, only: end_compression
   use dg_profile, only: profile_type, new_profile, piece_depths, side_above, side_none, state_free, state_elastic
   use dg_profile_rows, only: lay_rows
   use dg_soft_string_loads, only: soft_string_at, soft_totals_type
   use dg_string_piece, only: breakpoints
   use dg_string_range, only: range_warning
   use dg_trajectory, only: arc_at, azimuth_of, clock_angle, inclination_of, point_on_arc, position_at, top_md
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: solve_soft_string
   ! Public for the stiff string, which shares them.
   public :: subdivided, check_string_case, set_totals, set_profile

   !> Contact force per metre below which a weightless or balanced string counts as free [N/m].
   real(wp), parameter :: contact_threshold = 1.0e-6_wp
   !> Digits of a depth in a message.
   integer, parameter :: shown_depth = 5

contains

   !> Solve a load case with the soft string, without iteration. The status is `converged`, or `locked_up` if friction in a
   !> long bend grows without bound. Refused (bad input): unknown string, bit above the first station. `message` says if a
   !> string must be pushed at surface.
   subroutine solve_soft_string(model, case_index, result, error, totals_only)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      logical, intent(in), optional :: totals_only   !< true: no profile, to save time in thousands of cases
      real(wp), allocatable :: md(:), axial(:), torque(:), contact(:, :)
      integer, allocatable :: from(:), side(:)
      type(soft_totals_type) :: totals
      integer(int64) :: start, finish
      logical :: with_profile
      call system_clock(start)
      with_profile = .true.
      if (present(totals_only)) with_profile = .not. totals_only
      call check_string_case(model, case_index, error)
      if (allocated(error)) return
      md = subdivided(breakpoints(model, case_index), model%numerics%element_length)
      if (with_profile) then
         call lay_rows(model, case_index, md, from, side)
         md = md(from)
         allocate (contact(3, size(md)))   ! else absent below
      end if
      allocate (axial(size(md)), torque(size(md)))
      call soft_string_at(model, case_index, md, axial, torque, contact, totals=totals)
      call set_totals(model, case_index, md, axial, torque, totals, result)
      result%model = model_soft
      if (with_profile) then
         call set_profile(model, case_index, md, side, axial, torque, contact, result)
         call system_clock(finish)
         result%seconds = seconds_between(start, finish)
      end if
      call finish_result(result)
   end subroutine solve_soft_string

   !> Refuse (bad input) a load case without a string or with the bit above the first station.
   pure subroutine check_string_case(model, case_index, error)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(error_type), allocatable, intent(out) :: error
      associate (load_case => model%cases(case_index))
         if (string_index(model%strings, load_case%string) == 0) then
            call raise(error, status_bad_input, 'load case '//load_case%name//": there is no string '"//load_case%string//"'")
         else if (load_case%bit_depth <= top_md(model%trajectory)) then
            call raise(error, status_bad_input, 'load case '//load_case%name//': bit_depth must lie below the first station')
         end if
      end associate
   end subroutine check_string_case

   !> Depths with points between, none farther apart than `spacing` [m].
   pure function subdivided(md, spacing) result(fine)
      real(wp), intent(in) :: md(:)      !< ascending [m]
      real(wp), intent(in) :: spacing    !< > 0 [m]
      real(wp), allocatable :: fine(:)
      integer :: parts(size(md) - 1)
      integer :: i, j, k
      parts = max(1, ceiling((md(2:) - md(:size(md) - 1))/spacing))
      allocate (fine(sum(parts) + 1))
      k = 0
      do i = 1, size(parts)
         do j = 0, parts(i) - 1
            k = k + 1
            fine(k) = md(i) + (md(i + 1) - md(i))*real(j, wp)/real(parts(i), wp)
         end do
      end do
      fine(k + 1) = md(size(md))
   end function subdivided

   !> Set the totals of a string on the hole axis. A bend in which friction grows without bound makes it `locked_up`.
   pure subroutine set_totals(model, case_index, md, axial, torque, totals, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)            !< from the top down [m]
      real(wp), intent(in) :: axial(:)         !< [N]
      real(wp), intent(in) :: torque(:)        !< [N.m]
      type(soft_totals_type), intent(in) :: totals
      type(case_result_type), intent(inout) :: result
      character(:), allocatable :: warning
      real(wp) :: position(3), tangent(3)
      associate (load_case => model%cases(case_index))
         call position_at(model%trajectory, load_case%bit_depth, position, tangent)
         result%case_index = case_index
         result%inclination = inclination_of(tangent)
         result%hookload = axial(1) - surface_push(model, case_index)
         result%friction = totals%weight - end_compression(model, load_case) - axial(1)
         result%torque = torque(1)
         result%normal_force = totals%normal_force
         result%elements = totals%steps
         result%status = result_converged
         call range_warning(model, case_index, md, axial, result%hookload, warning)
         result%message = warning
         if (totals%runaway) then
            result%status = result_locked_up
            result%message = 'Locked up: friction grows without bound in the bend that ends at '// &
               in_units(model%units, unit_length, totals%runaway_md, shown_depth)
         end if
      end associate
      allocate (result%history(0))
   end subroutine set_totals

   !> Set the profile of such a string, and count its points that touch. Two rows at one depth are one point.
   pure subroutine set_profile(model, case_index, md, side, axial, torque, contact, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)                                !< as in fill_profile [m]
      integer, intent(in) :: side(:)
      real(wp), intent(in) :: axial(:), torque(:), contact(:, :)   !< as in fill_profile [N, N.m, N/m]
      type(case_result_type), intent(inout) :: result
      call fill_profile(model, case_index, md, side, axial, torque, contact, result%profile)
      result%states = 0
      result%states(state_elastic) = count(result%profile%gap_state == state_elastic .and. side /= side_above)
      result%states(state_free) = count(result%profile%gap_state == state_free .and. side /= side_above)
   end subroutine set_profile

   !> Profile of a string that lies on the wall wherever it presses on it. Its bending moment is that of the body in the hole's
   !> curvature. A soft string has no moment, but a real one that follows the hole does.
   pure subroutine fill_profile(model, case_index, md, side, axial, torque, contact, profile)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md(:)          !< of the rows, from lay_rows [m]
      integer, intent(in) :: side(:)         !< of the rows, from lay_rows
      real(wp), intent(in) :: axial(:)       !< [N]
      real(wp), intent(in) :: torque(:)      !< [N.m]
      real(wp), intent(in) :: contact(:, :)  !< (3, size(md)) [N/m]
      type(profile_type), intent(out) :: profile
      real(wp) :: position(3), tangent(3), curvature(3), bit, clearance
      real(wp) :: depths(size(md))
      real(wp), allocatable :: tops(:)
      integer :: i, arc, hole, part
      profile = new_profile(size(md))
      profile%md = md
      profile%side = side
      depths = piece_depths(profile)
      bit = model%cases(case_index)%bit_depth
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         arc = 1
         do i = 1, size(md)
            arc = arc_at(model%trajectory, merge(md(i), depths(i), side(i) == side_none), near=arc)
            hole = hole_section_at(model%holes, depths(i))
            part = component_at(tops, bit - depths(i))
            call point_on_arc(model%trajectory%arcs(arc), md(i) - model%trajectory%arcs(arc)%md, position, tangent, curvature)
            position = position + model%trajectory%arcs(arc)%origin
            profile%north(i) = position(1)
            profile%east(i) = position(2)
            profile%tvd(i) = position(3)
            profile%inclination(i) = inclination_of(tangent)
            profile%azimuth(i) = azimuth_of(tangent)
            profile%axial(i) = axial(i)
            profile%torque(i) = torque(i)
            profile%side_force(i) = norm2(contact(:, i))
            profile%bending(i) = bending_stiffness(string%components(part))*norm2(curvature)
            if (profile%side_force(i) <= contact_threshold) cycle
            clearance = 0.5_wp*(model%holes(hole)%diameter - contact_diameter(string%components(part), bit - tops(part)))
            profile%displacement(i) = max(clearance, 0.0_wp)
            profile%clock(i) = clock_angle(tangent, contact(:, i))
            profile%gap_state(i) = state_elastic
         end do
      end associate
   end subroutine fill_profile
end module dg_soft_string

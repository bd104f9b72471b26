!> The mixed model with finite elements at the bit. Beams with contact gap elements reach from the bit to well above the
!> bottom-hole assembly. The string is on the axis from there to surface.
!>
!> At the join only axial force and torque are passed on. Friction below follows from the contact of the beams, friction above
!> from the force at the join, so that no iteration is needed. The join is `reach` above the assembly, several tangency lengths
!> of drill pipe. There the assembly's shear force and moment have died out. The beams end there free of moment. In a bend the
!> last of them straightens over a bending length. That reduces the axial force by E I/(2 R^2), some tens of newtons.
module dg_assembly_elements
   use dg_kinds, only: wp
   use dg_case_result, only: add_sentence, case_result_type, result_converged
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: degree
   use dg_curvature_change, only: change_type, curvature_changes
   use dg_drillstring, only: component_tops
   use dg_error, only: error_type
   use dg_fluid, only: cut_mud
   use dg_missing, only: missing
   use dg_model, only: model_type, string_index
   use dg_profile, only: new_profile, profile_type
   use dg_profile_rows, only: part_rows
   use dg_rigid_string, only: solve_at_changes
   use dg_soft_string_loads, only: soft_string_at
   use dg_static_analysis, only: solve_static_analysis
   use dg_stopping, only: stop_type
   use dg_trajectory, only: cut_trajectory, top_md
   implicit none
   private
   public :: solve_with_elements, join_depth, matters

   !> Length of pipe above the assembly that is also beams [m]. Tangency lengths of drill pipe are 10 to 20 m.
   real(wp), parameter :: reach = 100.0_wp
   !> Side load below which the string hangs free at the join [N/m]. No load would hold its end, which is then put on the axis.
   real(wp), parameter :: least_side_load = 1.0_wp
   !> Least sharp change of curvature [1/m]: 15 deg in 30 m, where stiff and soft strings differ by Payne & Abbassian (1997).
   real(wp), parameter :: sharp_turn = 15.0_wp*degree/30.0_wp
   !> Least stiffness of a component of the assembly over that of the uppermost component [-]: beyond round-off.
   real(wp), parameter :: stiffer = 1.0_wp + 1.0e-6_wp

contains

   !> True if stiffness matters at a change of curvature.
   elemental function matters(change, pipe) result(yes)
      type(change_type), intent(in) :: change
      real(wp), intent(in) :: pipe   !< E I of the uppermost component [N.m2]
      logical :: yes
      yes = change%forced .or. change%stiffness > stiffer*pipe .or. norm2(change%curvature) > sharp_turn
   end function matters

   !> Depth of the join [m]: `reach` above the highest of the components next to the bit that are stiffer than the uppermost
   !> one. If little more than `reach` of pipe would be left, it is the first station, so that all are beams.
   pure function join_depth(model, case_index) result(md)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp) :: md
      real(wp), allocatable :: tops(:)
      real(wp) :: pipe, assembly
      integer :: i
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)), &
                 bit => model%cases(case_index)%bit_depth, top => top_md(model%trajectory))
         allocate (tops, source=component_tops(string, bit - top))
         pipe = bending_stiffness(string%components(size(tops)))
         assembly = 0.0_wp
         do i = 1, size(tops)
            if (bending_stiffness(string%components(i)) <= stiffer*pipe) exit
            assembly = tops(i)
         end do
         md = bit - assembly - reach
         if (md <= top + reach) md = top
      end associate
   end function join_depth

   !> Solve a load case that has passed check_string_case. Statuses are those of the beams.
   subroutine solve_with_elements(model, case_index, result, error, stop)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error
      type(stop_type), intent(in), optional :: stop
      type(model_type) :: part
      type(case_result_type) :: above
      type(change_type), allocatable :: changes(:)
      type(profile_type) :: beams
      real(wp) :: join, axial(1), torque(1), contact(3, 1)
      join = join_depth(model, case_index)
      part = model
      if (join > top_md(model%trajectory)) then
         call cut_trajectory(model%trajectory, join, part%trajectory)
         call soft_string_at(model, case_index, [join], axial, torque, contact)
         part%boundary%top_centred = norm2(contact(:, 1)) < least_side_load
      end if
      call solve_static_analysis(part, case_index, result, error, stop=stop)
      if (allocated(error) .or. .not. join > top_md(model%trajectory) .or. result%status /= result_converged) return
      part = model
      call keep_upper_string(model, case_index, join, part)
      call cut_mud(part%mud, model%cases(case_index)%bit_depth - join)
      part%cases(case_index)%bit_depth = join
      part%boundary%packer_bore = 0.0_wp
      part%cases(case_index)%wob = -result%hookload
      part%cases(case_index)%tob = result%torque
      call curvature_changes(part, case_index, changes)
      call solve_at_changes(part, case_index, pack(changes, matters(changes, uppermost(part, case_index))), above)
      result%status = above%status
      result%shortening = missing      ! the shortening of the lower part alone is known
      call add_sentence(result%message, above%message)
      result%hookload = above%hookload
      result%torque = above%torque
      result%friction = result%friction + above%friction
      result%normal_force = result%normal_force + above%normal_force
      result%elements = result%elements + above%elements
      result%states = result%states + above%states
      beams = result%profile
      call join_profiles(above%profile, beams, result%profile)
      call part_rows(model, case_index, result%profile)     ! there may be a change at the join
   end subroutine solve_with_elements

   !> Bending stiffness of the uppermost component [N.m2].
   pure function uppermost(model, case_index) result(pipe)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp) :: pipe
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         pipe = bending_stiffness(string%components(size(string%components)))
      end associate
   end function uppermost

   !> Remove all below a depth [m] from the string of a load case.
   pure subroutine keep_upper_string(model, case_index, md, upper)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md
      type(model_type), intent(inout) :: upper
      type(component_type), allocatable :: kept(:)
      real(wp), allocatable :: tops(:)
      integer :: string, first, last, i
      string = string_index(model%strings, model%cases(case_index)%string)
      associate (whole => model%strings(string), bit => model%cases(case_index)%bit_depth)
         allocate (tops, source=component_tops(whole, bit - top_md(model%trajectory)))
         last = size(tops)
         do first = 1, last - 1
            if (tops(first) > bit - md) exit
         end do
         allocate (kept(last - first + 1))
         do i = first, last
            kept(i - first + 1) = whole%components(i)
         end do
         kept(1)%length = tops(first) - (bit - md)
      end associate
      deallocate (upper%strings(string)%components)
      allocate (upper%strings(string)%components(size(kept)))
      do i = 1, size(kept)
         upper%strings(string)%components(i) = kept(i)
      end do
   end subroutine keep_upper_string

   !> Join the rows of both. The join has one row, that of the beams.
   pure subroutine join_profiles(upper, lower, whole)
      type(profile_type), intent(in) :: upper, lower
      type(profile_type), intent(out) :: whole
      integer :: n
      n = size(upper%md) - 1
      whole = new_profile(n + size(lower%md))
      whole%md = [upper%md(:n), lower%md]
      whole%tvd = [upper%tvd(:n), lower%tvd]
      whole%north = [upper%north(:n), lower%north]
      whole%east = [upper%east(:n), lower%east]
      whole%inclination = [upper%inclination(:n), lower%inclination]
      whole%azimuth = [upper%azimuth(:n), lower%azimuth]
      whole%axial = [upper%axial(:n), lower%axial]
      whole%torque = [upper%torque(:n), lower%torque]
      whole%side_force = [upper%side_force(:n), lower%side_force]
      whole%bending = [upper%bending(:n), lower%bending]
      whole%displacement = [upper%displacement(:n), lower%displacement]
      whole%clock = [upper%clock(:n), lower%clock]
      whole%shear = [upper%shear(:n), lower%shear]
      whole%gap_state = [upper%gap_state(:n), lower%gap_state]
      whole%side = [upper%side(:n), lower%side]
   end subroutine join_profiles
end module dg_assembly_elements

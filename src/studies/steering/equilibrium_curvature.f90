!> Curvature at which an assembly drills on: that of the hole in which its bit has no tendency to leave the hole's direction.
!>
!> The lowest part of a string is solved in holes of constant curvature k. They end at the bit in the direction of the given
!> hole. F is the side force of the bit on the formation and a its tilt against the hole axis, both as vectors across the hole.
!> The hole goes on with the k for which
!>
!>   F(k) = 0,   or   a(k) + s F(k)/W = 0   where the bit cuts sideways:
!>
!> W weight on bit, s the penetration of the bit sideways over that ahead for the same force. The hole then goes where the bit goes:
!> ahead along its own axis, and sideways by its side force. Newton's method in the two components of k, with differences.
!> A bend, or eccentric blades, of a string that turns is seen at toolfaces all round: F and a are then their means.
module dg_equilibrium_curvature
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: closed_diameter, has_bend, is_bit, is_eccentric
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_fluid, only: shift_mud
   use dg_hole_section, only: hole_section_at
   use dg_interruption, only: by_signals, is_interrupted
   use dg_job, only: model_mcge
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, optional_real
   use dg_model, only: copy_without_cases, model_type, string_index
   use dg_solve_case, only: solve_case
   use dg_steering, only: steering_result_type
   use dg_three_points, only: three_point_dogleg
   use dg_trajectory, only: arc_at, azimuth_of, high_side, inclination_of, interpolation_minimum_curvature, new_trajectory, &
                            point_on_arc
   use dg_unit_kind, only: in_units, unit_curvature
   use dg_units, only: unit_system_type
   use dg_vector, only: cross
   implicit none
   private
   public :: find_equilibrium_curvature

   !> Change of curvature for differences, the last step, and the longest one [1/m].
   real(wp), parameter :: apart = 0.5_wp*degree/30.0_wp, settled = 0.01_wp*degree/30.0_wp, longest = 10.0_wp*degree/30.0_wp
   integer, parameter :: most_steps = 12, most_trials = 4
   !> Digits of a dogleg in a message.
   integer, parameter :: shown = 3
   !> Number of tool faces for a bend that turns.
   integer, parameter :: toolfaces_round = 8
   !> Inclination below which the hole has no usable high side [rad].
   real(wp), parameter :: least_inclination = 2.0_wp*degree
   !> Largest turn of the hole along the solved part [rad]. In a stronger curve a shorter part is solved.
   real(wp), parameter :: most_turn = 100.0_wp*degree
   !> Message if moments of short elements were not found, as between stabilizers and walls of 1e10 kN/m2.
   character(*), parameter :: rough_message = 'side force, tilt and dogleg may be off by 20 %: no solution on short '// &
      'elements. A softer wall (gk_max, mud_sheath) helps'
   !> Distance of stations [m].
   real(wp), parameter :: station = 30.0_wp

   !> The lowest part of a string in holes of its own.
   type :: probe_type
      type(model_type) :: model
      real(wp) :: length = 0.0_wp                              !< of string [m]
      real(wp) :: tangent(3) = 0.0_wp, up(3) = 0.0_wp, right(3) = 0.0_wp   !< of the hole at the bit
      real(wp), allocatable :: toolfaces(:)                    !< over which is averaged [rad]
      type(optional_real) :: side_cutting                      !< s [-]
      real(wp) :: wob = 0.0_wp                                 !< W [N]
      integer :: solutions = 0
      logical :: rough = .false.                               !< a solution has the side force of the analysis' own elements
      character(:), allocatable :: message                     !< why a solution failed
   end type probe_type

contains

   !> Set a result of a load case at a tool face [rad]. It is marked as not found if the string has no equilibrium in such a
   !> hole, or if Newton's method does not converge.
   subroutine find_equilibrium_curvature(model, case_index, toolface, length, side_cutting, result, enlargement, &
                                         measured)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: toolface
      real(wp), intent(in) :: length                    !< of the string above the bit that is solved [m]
      type(optional_real), intent(in) :: side_cutting   !< s [-]; > 0 wants a weight on bit
      type(steering_result_type), intent(out) :: result
      real(wp), intent(in), optional :: enlargement     !< of the hole above the bit, in diameter; absent: none [m]
      real(wp), intent(in), optional :: measured        !< dogleg towards the toolface; absent or missing: not measured [1/m]
      type(probe_type) :: probe
      real(wp) :: k(2), f(2), push(2), tilt(2)
      logical :: sound
      call new_probe(model, case_index, toolface, length, side_cutting, probe, result)
      if (present(enlargement)) call enlarge_hole(probe, enlargement)
      if (.not. is_missing(result%toolface)) result%three_points = three_point_dogleg(probe%model%strings( &
         string_index(model%strings, model%cases(case_index)%string)), model%cases(case_index)%bit_depth, &
         probe%model%holes(1)%diameter)
      if (result%inclination < least_inclination .or. result%inclination > pi - least_inclination) then
         result%message = 'the hole is vertical there, to 2 deg: it has no high side'
         return
      end if
      k = result%hole
      call evaluate(probe, k, f, sound, push, tilt)
      if (sound) then
         result%side_force = push
         result%tilt = tilt
         call settle(probe, k, f, result%found, sound)
      end if
      if (present(measured)) then
         if (sound .and. .not. is_missing(measured)) call fit_side_cutting(probe, measured, toolface, result)
      end if
      result%solutions = probe%solutions
      if (result%found) then
         result%curvature = k
         if (probe%rough) result%message = rough_message
         if (present(measured)) then
            if (.not. is_missing(measured) .and. is_missing(result%side_cutting)) &
               result%message = unreached_text(model%units, measured, result%reach)
         end if
      else if (sound) then
         result%message = 'no curvature found in which the bit wants to go nowhere else'
      else
         result%message = probe%message
      end if
   end subroutine find_equilibrium_curvature

   !> Newton's method from a curvature k with its f to the one where f is zero.
   subroutine settle(probe, k, f, found, sound)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(inout) :: k(2), f(2)
      logical, intent(out) :: found
      logical, intent(out) :: sound                     !< all strings on the way have an equilibrium
      real(wp) :: slope(2, 2), step(2)
      integer :: iteration
      found = .false.
      do iteration = 1, most_steps
         call differentiate(probe, k, f, slope, sound)
         if (.not. sound) return
         step = solution_of(slope, -f)
         if (norm2(step) > longest) step = step*(longest/norm2(step))
         found = norm2(step) <= settled
         if (found) exit
         call shorten_step(probe, k, f, step, sound)
         if (.not. sound) return
      end do
      if (found) k = k + step
   end subroutine settle

   !> The part of the string, and the hole at its bit.
   subroutine new_probe(model, case_index, toolface, length, side_cutting, probe, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: toolface, length
      type(optional_real), intent(in) :: side_cutting
      type(probe_type), intent(out) :: probe
      type(steering_result_type), intent(inout) :: result
      real(wp) :: position(3), curvature(3)
      logical :: directed      ! by a bend, or eccentric blades
      integer :: i
      call copy_without_cases(model, probe%model)
      probe%model%cases(1) = model%cases(case_index)
      probe%model%numerics%moments = .true.             ! side force and tilt are those of short elements
      associate (case => probe%model%cases(1), trajectory => model%trajectory)
         case%bend_stands = .true.
         probe%length = min(length, case%bit_depth - trajectory%md(1))
         probe%wob = case%wob
         probe%side_cutting = side_cutting
         probe%message = ''
         deallocate (probe%model%holes)
         allocate (probe%model%holes(1))
         probe%model%holes(1) = model%holes(hole_section_at(model%holes, case%bit_depth))
         i = arc_at(trajectory, case%bit_depth)
         if (case%bit_depth <= trajectory%arcs(i)%md) i = max(i - 1, 1)      ! the hole that is there, not what is to come
         call point_on_arc(trajectory%arcs(i), case%bit_depth - trajectory%arcs(i)%md, position, probe%tangent, curvature)
         associate (components => model%strings(string_index(model%strings, case%string))%components)
            directed = any(has_bend(components) .or. is_eccentric(components))
         end associate
         if (directed .and. rotates(case%operation)) then
            probe%toolfaces = [(2.0_wp*pi*i/toolfaces_round, i=0, toolfaces_round - 1)]
         else
            probe%toolfaces = [toolface]
            if (directed) result%toolface = toolface
         end if
      end associate
      probe%up = high_side(probe%tangent)
      probe%right = cross(probe%tangent, probe%up)
      result%case_index = case_index
      result%inclination = inclination_of(probe%tangent)
      result%hole = [dot_product(curvature, probe%up), dot_product(curvature, probe%right)]
      result%message = ''
   end subroutine new_probe

   !> Widens the hole above the bit. A bit that fills its hole goes on to do so.
   pure subroutine enlarge_hole(probe, enlargement)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: enlargement   !< of the diameter [m]
      integer :: i
      if (.not. enlargement > 0.0_wp) return
      probe%model%holes(1)%diameter = probe%model%holes(1)%diameter + enlargement
      do i = 1, size(probe%model%strings)
         associate (bit => probe%model%strings(i)%components(1))
            if (is_bit(bit)) bit%joint_od = closed_diameter(bit) + enlargement
         end associate
      end do
   end subroutine enlarge_hole

   !> Side cutting s [-] with a(k) + s F(k)/W = 0 towards the tool face in a hole of the measured dogleg; missing if there is
   !> none above 0. Also the doglegs without side cutting and without side force.
   subroutine fit_side_cutting(probe, measured, toolface, result)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: measured          !< [1/m]
      real(wp), intent(in) :: toolface          !< [rad]
      type(steering_result_type), intent(inout) :: result
      type(optional_real), parameter :: ends(2) = [optional_real(.true., 0.0_wp), optional_real()]
      type(optional_real) :: side_cutting
      real(wp) :: k(2), f(2), push(2), tilt(2)
      logical :: sound, found
      integer :: i
      if (.not. probe%wob > 0.0_wp) return
      side_cutting = probe%side_cutting
      do i = 1, size(ends)
         probe%side_cutting = ends(i)
         k = result%hole
         call evaluate(probe, k, f, sound)
         if (sound) call settle(probe, k, f, found, sound)
         if (sound .and. found) result%reach(i) = dot_product(k, direction(toolface))
      end do
      probe%side_cutting = side_cutting
      call evaluate(probe, measured*direction(toolface), f, sound, push, tilt)
      if (.not. sound) return
      push(1) = dot_product(push, direction(toolface))
      tilt(1) = dot_product(tilt, direction(toolface))
      if (push(1)*tilt(1) < 0.0_wp) result%side_cutting = -tilt(1)*probe%wob/push(1)
   end subroutine fit_side_cutting

   !> Message on a measured dogleg that no side cutting gives.
   pure function unreached_text(units, measured, reach) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: measured          !< [1/m]
      real(wp), intent(in) :: reach(2)          !< doglegs without side cutting and without side force, may be missing [1/m]
      character(:), allocatable :: text
      text = 'no side_cutting above 0 gives the measured dogleg of '//in_units(units, unit_curvature, measured, shown)
      if (.not. is_missing(reach(1))) text = text//'. Without side cutting it is '// &
         in_units(units, unit_curvature, reach(1), shown)
      if (.not. is_missing(reach(2))) text = text//'. Without bit side force it is '// &
         in_units(units, unit_curvature, reach(2), shown)
      text = text//'. Check unit (per 30 m or 100 ft) and sign (> 0 is towards the toolface)'
   end function unreached_text

   !> Function that is zero at the equilibrium curvature, for a string in a hole of curvature k; with its parts where they are asked
   !> for.
   subroutine evaluate(probe, k, f, sound, push, tilt)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: k(2)                          !< towards the high side and to the right [1/m]
      real(wp), intent(out) :: f(2)                         !< [N], or [-] with side cutting
      logical, intent(out) :: sound                         !< all of its strings have an equilibrium
      real(wp), intent(out), optional :: push(2), tilt(2)   !< side force [N], tilt [rad]
      type(case_result_type), allocatable :: solved
      type(error_type), allocatable :: error
      real(wp) :: force(2), slope(2)
      integer :: i
      f = 0.0_wp
      force = 0.0_wp
      slope = 0.0_wp
      call bend_hole(probe, k, error)
      sound = .not. allocated(error)
      if (.not. sound) probe%message = error%message
      do i = 1, size(probe%toolfaces)
         if (.not. sound) exit
         probe%model%cases(1)%toolface = probe%toolfaces(i)
         allocate (solved)
         call solve_case(probe%model, model_mcge, 1, solved, error, stop=by_signals())
         probe%solutions = probe%solutions + 1
         sound = .not. (allocated(error) .or. is_interrupted())
         if (allocated(error)) probe%message = error%message
         if (sound) then
            sound = solved%status == result_converged .and. .not. is_missing(solved%bit_side_force)
            if (.not. sound) probe%message = solved%message
         end if
         if (sound) then
            probe%rough = probe%rough .or. is_missing(solved%moment_error)
            force = force + solved%bit_side_force*direction(solved%bit_side_clock)/size(probe%toolfaces)
            slope = slope + tan(solved%bit_tilt)*direction(solved%bit_tilt_clock)/size(probe%toolfaces)
         end if
         deallocate (solved)
      end do
      if (.not. sound) return
      f = force
      if (probe%side_cutting%present) f = slope + probe%side_cutting%value*force/probe%wob
      if (present(push)) push = force
      if (present(tilt)) tilt = slope
   end subroutine evaluate

   pure function direction(clock) result(n)
      real(wp), intent(in) :: clock
      real(wp) :: n(2)
      n = [cos(clock), sin(clock)]
   end function direction

   !> Gives the probe a hole of curvature k that ends at the bit.
   subroutine bend_hole(probe, k, error)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: k(2)
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      real(wp) :: length, size_of, normal(3), t(3), angle
      integer :: i, n
      length = probe%length
      size_of = norm2(k)
      normal = 0.0_wp
      if (size_of > 0.0_wp) then
         length = min(length, most_turn/size_of)
         normal = (k(1)*probe%up + k(2)*probe%right)/size_of
      end if
      n = max(2, ceiling(length/station) + 1)
      allocate (md(n), inclination(n), azimuth(n))
      do i = 1, n
         md(i) = length*(i - 1)/(n - 1)
         angle = (length - md(i))*size_of               ! back from the bit
         t = cos(angle)*probe%tangent - sin(angle)*normal
         inclination(i) = inclination_of(t)
         azimuth(i) = azimuth_of(t)
      end do
      call new_trajectory(probe%model%trajectory, md, inclination, azimuth, interpolation_minimum_curvature, error)
      call shift_mud(probe%model%mud, length - probe%model%cases(1)%bit_depth)     ! the string stays in the same fluids
      probe%model%cases(1)%bit_depth = length
      probe%model%holes%md_top = 0.0_wp
      probe%model%holes%md_bottom = length
   end subroutine bend_hole

   !> Derivatives of f by k, by differences.
   subroutine differentiate(probe, k, f, slope, sound)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: k(2), f(2)
      real(wp), intent(out) :: slope(2, 2)
      logical, intent(out) :: sound
      real(wp) :: other(2), beside(2)
      integer :: j
      slope = 0.0_wp
      do j = 1, 2
         beside = k
         beside(j) = beside(j) + apart
         call evaluate(probe, beside, other, sound)
         if (.not. sound) return
         slope(:, j) = (other - f)/apart
      end do
   end subroutine differentiate

   !> Takes a step, shortened until f becomes smaller; at last as short as it then is.
   subroutine shorten_step(probe, k, f, step, sound)
      type(probe_type), intent(inout) :: probe
      real(wp), intent(inout) :: k(2), f(2)
      real(wp), intent(in) :: step(2)
      logical, intent(out) :: sound
      real(wp) :: trial(2), other(2), share
      integer :: try
      share = 1.0_wp
      do try = 1, most_trials
         trial = k + share*step
         call evaluate(probe, trial, other, sound)
         if (sound .and. norm2(other) < norm2(f)) exit
         share = 0.5_wp*share
      end do
      k = trial
      f = other
   end subroutine shorten_step

   !> x of a x = b; a long one where a is singular [1/m].
   pure function solution_of(a, b) result(x)
      real(wp), intent(in) :: a(2, 2), b(2)
      real(wp) :: x(2), determinant
      determinant = a(1, 1)*a(2, 2) - a(1, 2)*a(2, 1)
      x = 1.0_wp/station          ! far
      if (.not. abs(determinant) > 0.0_wp) return
      x = [b(1)*a(2, 2) - b(2)*a(1, 2), b(2)*a(1, 1) - b(1)*a(2, 1)]/determinant
   end function solution_of
end module dg_equilibrium_curvature

!> Models built in code, and the one way in which verification tests solve them: whatever a test is after, its case must
!> converge and its forces must balance.
module dg_test_wells
   use, intrinsic :: iso_fortran_env, only: output_unit
   use funit, only: assertEqual, assertFalse, assertLessThan
   use dg_case_result, only: case_result_type, result_converged
   use dg_component, only: component_type, tube_area
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_static_analysis, only: solve_static_analysis
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: new_well, hold_ends, three_part_well, part, pipe, steel, solve, note, string_weight

   !> Unbalanced force of a node over the string's weight and bit load, to which each of its three components is iterated; moment
   !> over that times the string's extent. What is left of all nodes may lie to one side: a snake that stops within the tolerance by
   !> its last step leaves 2e-8 of a hundred nodes, most cases 1e-10.
   real(wp), parameter :: balance = 1.0e-9_wp

contains

   !> A well with one hole section and one pipe, one case, no mud, ends free; angles in degrees.
   subroutine new_well(model, md, inclination, azimuth, diameter, friction, component)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: md(:), inclination(:), azimuth(:)
      real(wp), intent(in) :: diameter     !< of the hole [m]
      real(wp), intent(in) :: friction     !< in both directions [-]
      type(component_type), intent(in) :: component
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, md, inclination*degree, azimuth*degree, interpolation_minimum_curvature, error)
      call assertFalse(allocated(error), message='trajectory')
      allocate (model%holes(1), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', md(1), md(size(md)), diameter, friction, friction)
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(1))
      model%strings(1)%components(1) = component
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = md(size(md))
      model%boundary%top_centred = .false.
      model%boundary%bit_centred = .false.
      model%mud = standing_mud(0.0_wp)
      model%gravity = 10.0_wp
   end subroutine new_well

   !> Holds both ends in the middle of the hole.
   subroutine hold_ends(model)
      type(model_type), intent(inout) :: model
      model%boundary%top_centred = .true.
      model%boundary%bit_centred = .true.
   end subroutine hold_ends

   !> A well of the kind that has independently computed answers: two hole sections, mud of 1440 kg/m3, collar, heavy-weight
   !> pipe and drill pipe, no operation yet. Angles in degrees; the azimuth is any one.
   subroutine three_part_well(model, md, inclination, shoe, friction_above, friction_below)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: md(:), inclination(:), shoe
      real(wp), intent(in), optional :: friction_above, friction_below   !< else 0.25 and 0.35
      type(error_type), allocatable :: error
      real(wp), parameter :: azimuth = 60.0_wp*degree
      real(wp) :: friction(2)
      friction = [0.25_wp, 0.35_wp]
      if (present(friction_above)) friction(1) = friction_above
      if (present(friction_below)) friction(2) = friction_below
      call new_trajectory(model%trajectory, md, inclination*degree, spread(azimuth, 1, size(md)), &
                          interpolation_minimum_curvature, error)
      call assertFalse(allocated(error), message='trajectory')
      allocate (model%holes(2), model%strings(1), model%cases(1))
      model%holes(1) = hole_section_type('cased', 0.0_wp, shoe, 0.22_wp, friction(1), friction(1))
      model%holes(2) = hole_section_type('open', shoe, md(size(md)), 0.2159_wp, friction(2), friction(2))
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(3))
      model%strings(1)%components(1) = part('collar', 150.0_wp, 0.17145_wp, 0.0714_wp, 160.87051759_wp, 0.0_wp)
      model%strings(1)%components(2) = part('hwdp', 150.0_wp, 0.127_wp, 0.0762_wp, 73.36648027_wp, 0.1651_wp)
      model%strings(1)%components(3) = part('drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 33.126528414_wp, 0.168275_wp)
      model%cases(1)%name = 'case'
      model%cases(1)%section = ''
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = md(size(md))
      model%mud = standing_mud(1440.0_wp)
   end subroutine three_part_well

   !> A component by its numbers; no tool joints where `joint_od` is 0.
   pure function part(kind, length, od, id, mass, joint_od) result(component)
      character(*), intent(in) :: kind
      real(wp), intent(in) :: length, od, id   !< [m]
      real(wp), intent(in) :: mass             !< [kg/m]
      real(wp), intent(in) :: joint_od         !< [m]
      type(component_type) :: component
      component%name = kind
      component%kind = kind
      component%length = length
      component%od = od
      component%id = id
      component%mass = mass
      component%joint_od = joint_od
   end function part

   !> A tube of steel without tool joints.
   pure function steel(kind, length, od, id) result(component)
      character(*), intent(in) :: kind
      real(wp), intent(in) :: length, od, id   !< [m]
      type(component_type) :: component
      component = part(kind, length, od, id, component%density*tube_area(od, id), 0.0_wp)
   end function steel

   !> A pipe of a weight in the fluid [N/m], at the gravity of new_well.
   pure function pipe(weight, od, id, youngs) result(component)
      real(wp), intent(in) :: weight, od, id
      real(wp), intent(in), optional :: youngs
      type(component_type) :: component
      component%name = 'pipe'
      component%kind = 'drillpipe'
      component%od = od
      component%id = id
      component%mass = weight/10.0_wp
      if (present(youngs)) component%youngs = youngs
   end function pipe

   !> Solves the model's case for an operation and bit loads; checks convergence and global equilibrium.
   subroutine solve(model, operation, wob, tob, result, what)
      type(model_type), intent(inout) :: model
      integer, intent(in) :: operation
      real(wp), intent(in) :: wob, tob
      type(case_result_type), intent(out) :: result
      character(*), intent(in) :: what
      type(error_type), allocatable :: error
      real(wp) :: scale, left
      model%cases(1)%operation = operation
      model%cases(1)%wob = wob
      model%cases(1)%tob = tob
      call solve_static_analysis(model, 1, result, error)
      call assertFalse(allocated(error), message=what//': error')
      if (allocated(error)) return
      call assertEqual(result_converged, result%status, message=what//': '//result%message)
      scale = string_weight(model) + abs(wob)
      call note(what//': iterations', real(result%iterations, wp))
      call note(what//': force out of balance over weight', result%equilibrium_force/scale)
      call note(what//': moment out of balance over weight times length', &
                result%equilibrium_moment/(scale*model%cases(1)%bit_depth))
      left = sqrt(3.0_wp)*balance*scale*size(result%profile%md)
      call assertLessThan(result%equilibrium_force, left, message=what//': forces balance')
      call assertLessThan(result%equilibrium_moment, left*model%cases(1)%bit_depth, message=what//': moments balance')
   end subroutine solve

   !> Weight of the whole string in the hole [N], in its first fluid; components but the last as long as they say.
   pure function string_weight(model) result(weight)
      type(model_type), intent(in) :: model
      real(wp) :: weight, length, rest, density
      integer :: i
      rest = model%cases(1)%bit_depth - model%trajectory%md(1)
      density = 0.0_wp
      if (allocated(model%mud%fluids)) density = model%mud%fluids(1)%density
      weight = 0.0_wp
      associate (components => model%strings(1)%components)
         do i = 1, size(components)
            length = merge(rest, components(i)%length, i == size(components))
            weight = weight + length*components(i)%mass*model%gravity*(1.0_wp - density/components(i)%density)
            rest = rest - length
         end do
      end associate
   end function string_weight

   !> A number for who runs the tests with -d: what was seen behind a tolerance.
   subroutine note(what, value)
      character(*), intent(in) :: what
      real(wp), intent(in) :: value
      character(8) :: argument
      integer :: i
      do i = 1, command_argument_count()
         call get_command_argument(i, argument)
         if (argument == '-d') write (output_unit, '(3x,a,t60,es16.8)') what, value
      end do
   end subroutine note
end module dg_test_wells

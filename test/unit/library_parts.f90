!> Parts of a well as a program of others fills them in, what spoils them, and that they are refused then.
module dg_library_parts
   use funit, only: assertEqual, assertFalse, assertTrue
   use drillgap, only: add_component, add_fluid, add_hole, case_result_type, degree, error_type, given, load_case_type, &
      method_name, model_parts_type, model_type, new_model, operation_rotary_drilling, result_not_converged, settings_of, solve, &
      status_bad_input, wp
   implicit none
   private
   public :: drilling, fill, loads, quantities, refuse, refuse_case, spoil, spoil_case

   integer, parameter :: quantities = 38   !< that `spoil` knows
   integer, parameter :: loads = 8         !< that `spoil_case` knows

contains

   !> A well of 2400 m with a string of collars and drill pipe.
   subroutine fill(parts)
      type(model_parts_type), intent(out) :: parts
      parts%survey%md = [0.0_wp, 600.0_wp, 1500.0_wp, 2400.0_wp]
      parts%survey%inclination = [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp]*degree
      parts%survey%azimuth = [45.0_wp, 45.0_wp, 45.0_wp, 45.0_wp]*degree
      call add_hole(parts, diameter=0.2245_wp, friction=0.2_wp, md_bottom=1500.0_wp)
      call add_hole(parts, diameter=0.2159_wp, friction=0.25_wp)
      call add_fluid(parts, density=1200.0_wp)
      call add_component(parts, 'collar', od=0.1651_wp, id=0.0714_wp, length=120.0_wp)
      call add_component(parts, 'drillpipe', od=0.127_wp, id=0.1086_wp, mass=31.9_wp, joint_od=0.1619_wp)
   end subroutine fill

   !> Rotary drilling at the end of that well.
   function drilling() result(load_case)
      type(load_case_type) :: load_case
      load_case%operation = operation_rotary_drilling
      load_case%bit_depth = 2400.0_wp
      load_case%wob = 50.0e3_wp
      load_case%tob = 3.0e3_wp
   end function drilling

   !> A model of parts must be refused with a message that holds `expected`, and then solves nothing.
   subroutine refuse(parts, expected)
      type(model_parts_type), intent(in) :: parts
      character(*), intent(in) :: expected
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call new_model(model, parts, error)
      call assertTrue(allocated(error), message='refused: '//expected)
      if (.not. allocated(error)) return
      call assertEqual(status_bad_input, error%status)
      call assertTrue(index(error%message, expected) > 0, message=error%message//' holds '//expected)
      call solve(model, drilling(), 'soft', result, error)
      call assertTrue(allocated(error), message='solves nothing: '//expected)
      call assertEqual(result_not_converged, result%status)
   end subroutine refuse

   !> A load case must be refused by every method with a message that holds `expected`.
   subroutine refuse_case(load_case, expected)
      type(load_case_type), intent(in) :: load_case
      character(*), intent(in) :: expected
      type(model_parts_type) :: parts
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      integer :: i
      call fill(parts)
      call new_model(model, parts, error)
      call assertFalse(allocated(error))
      do i = 1, size(method_name)
         call solve(model, load_case, method_name(i), result, error)
         call assertTrue(allocated(error), message='refused: '//expected)
         if (.not. allocated(error)) return
         call assertTrue(index(error%message, expected) > 0, message=error%message//' holds '//expected)
         call assertEqual(result_not_converged, result%status)
      end do
   end subroutine refuse_case

   !> Puts a number into one of the quantities of parts.
   subroutine spoil(parts, quantity, number)
      type(model_parts_type), intent(inout) :: parts
      integer, intent(in) :: quantity
      real(wp), intent(in) :: number
      if (.not. allocated(parts%numerics)) parts%numerics = settings_of('auto')
      associate (part => parts%strings(1)%components(1), hole => parts%holes(1), numerics => parts%numerics)
         select case (quantity)
         case (1); parts%survey%md(3) = number
         case (2); parts%survey%inclination(3) = number
         case (3); parts%survey%azimuth(3) = number
         case (4); hole%md_bottom = number
         case (5); hole%diameter = number
         case (6); hole%friction_axial = number
         case (7); hole%friction_rotary = number
         case (8); hole%wall_stiffness = number
         case (9); hole%mud_sheath = number
         case (10); part%length = number
         case (11); part%od = number
         case (12); part%id = number
         case (13); part%mass = number
         case (14); part%density = number
         case (15); part%youngs = number
         case (16); part%poisson = number
         case (17); part%joint_od = number
         case (18); part%joint_spacing = number
         case (19); part%yield = number
         case (20); part%friction_axial = number
         case (21); part%scale_rotary = number
         case (22); part%wall_left = number
         case (23); part%bend = number
         case (24); parts%fluids(1)%density = number
         case (25); parts%fluids(1)%md_top = number
         case (26); parts%fluids(1)%above_bit = number
         case (27); parts%rig%block_weight = number
         case (28); parts%rig%sheave_efficiency = number
         case (29); parts%gravity = number
         case (30); numerics%element_length = number
         case (31); numerics%tolerance = number
         case (32); numerics%gk_contact = number
         case (33); numerics%eps_nmax = number
         case (34); numerics%step_limit = number
         case (35)
            part%centralizer%present = .true.
            part%centralizer%spacing = 10.0_wp
            part%centralizer%od = number
         case (36)
            part%centralizer%present = .true.
            part%centralizer%od = 0.2_wp
            part%centralizer%spacing = number
         case (37); part%opened_od = number
         case (38); part%opened_below = number
         case default
         end select
      end associate
   end subroutine spoil

   !> Puts a number into one of the quantities of a load case.
   subroutine spoil_case(load_case, quantity, number)
      type(load_case_type), intent(inout) :: load_case
      integer, intent(in) :: quantity
      real(wp), intent(in) :: number
      select case (quantity)
      case (1); load_case%bit_depth = number
      case (2); load_case%wob = number
      case (3); load_case%tob = number
      case (4); load_case%friction_axial = given(number)
      case (5); load_case%friction_rotary = given(number)
      case (6); load_case%pump_pressure = number
      case (7); load_case%toolface = number
      case (8); load_case%trip_speed = number
      case default
      end select
   end subroutine spoil_case
end module dg_library_parts

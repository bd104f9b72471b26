!> Concentrated contacts against statics: a slick assembly that lands, two stabilizers, a blade between held ends, a tight
!> blade near the bit, the end of a bend under tension, tool joints.
module dg_test_contacts
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, contact_bit, contact_blades, contact_edge, contact_joint
   use dg_component, only: bending_stiffness, component_type
   use dg_constants, only: degree, pi
   use dg_kinds, only: wp
   use dg_load_case, only: operation_static, operation_trip_out
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_profile, only: side_above, side_below, state_free
   use dg_test_wells, only: hold_ends, new_well, note, pipe, solve
   use dg_whole_string, only: find_whole_string, whole_string_type
   implicit none
   private
   public :: contacts_suite

   real(wp), parameter :: w = 1500.0_wp, od = 0.17145_wp, id = 0.0714_wp, hole = 0.2159_wp, depth = 80.0_wp
   !> Stiff enough that an edge of contact has hardly any length [N/m2].
   real(wp), parameter :: hard = 1.0e11_wp
   !> Of the force of an edge, whose place is known to an element of the beam: 0.97 of it is seen, and one element's load is 0.02.
   real(wp), parameter :: within = 0.05_wp, same = 1.0e-6_wp

contains

   function contacts_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('contacts')
      call suite%addTest(TestMethod('slick_assembly_lands', test_slick))
      call suite%addTest(TestMethod('two_stabilizers', test_stabilizers))
      call suite%addTest(TestMethod('blade_between_held_ends', test_blade))
      call suite%addTest(TestMethod('tight_blade_near_the_bit', test_near_bit))
      call suite%addTest(TestMethod('end_of_a_bend', test_bend))
      call suite%addTest(TestMethod('tool_joints', test_joints))
   end function contacts_suite

   !> Of one kind, in order, which of the contacts.
   pure function those(result, kind) result(which)
      type(case_result_type), intent(in) :: result
      integer, intent(in) :: kind
      integer, allocatable :: which(:)
      integer :: i
      allocate (which(0))
      if (.not. allocated(result%contacts)) return
      which = pack([(i, i=1, size(result%contacts))], result%contacts%kind == kind)
   end function those

   !> By the trapezoid rule the column of side force holds all contact.
   subroutine check_sum(result)
      type(case_result_type), intent(in) :: result
      integer :: n
      n = size(result%profile%md)
      associate (p => result%profile)
         call assertRelativelyEqual(result%normal_force, sum(0.5_wp*(p%side_force(2:) + p%side_force(:n - 1))* &
                                                             (p%md(2:) - p%md(:n - 1))), same, message='sum of contact')
      end associate
   end subroutine check_sum

   !> Collars in a horizontal hole, the bit held: they land (24 EI c/w)^(1/4) from the bit, and half of that weight is at each end.
   subroutine test_slick()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp) :: length
      integer :: edge
      call new_well(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, pipe(w, od, id))
      model%boundary%bit_centred = .true.
      call set_wall(model)
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'slick')
      length = (12.0_wp*bending_stiffness(pipe(w, od, id))*(hole - od)/w)**0.25_wp
      call assertEqual(1, size(those(result, contact_edge)))
      call assertEqual(1, size(those(result, contact_bit)))
      if (size(those(result, contact_edge)) /= 1) return
      edge = findloc(result%contacts%kind, contact_edge, dim=1)
      call note('edge over w L/2', result%contacts(edge)%force/(0.5_wp*w*length))
      call note('its distance from the bit over L', (depth - result%contacts(edge)%md)/length)
      call assertRelativelyEqual(0.5_wp*w*length, result%contacts(edge)%force, within, message='edge')
      call assertRelativelyEqual(length, depth - result%contacts(edge)%md, within, message='its place')
      call assertEqual(pi, result%contacts(edge)%clock, 1.0e-3_wp, message='on the low side')
      call assertEqual(result%bit_side_force, result%contacts(size(result%contacts))%force, message='bit')
      call check_sum(result)
   end subroutine test_slick

   subroutine set_wall(model)
      type(model_type), intent(inout) :: model
      model%numerics%moments = .true.
      model%numerics%gk_contact = hard
      model%numerics%gk_max = hard
   end subroutine set_wall

   !> From the edge down, stabilizers, bit and edge carry the weight.
   subroutine test_stabilizers()
      type(model_type) :: model
      type(case_result_type) :: result
      type(component_type) :: parts(5)
      integer, allocatable :: blades(:), edges(:)
      real(wp) :: bit, landed
      integer :: i
      call new_well(model, [0.0_wp, depth], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, pipe(w, od, id))
      do i = 1, 5
         parts(i) = pipe(w, od, id)
      end do
      parts(1:4)%length = [4.0_wp, 1.0_wp, 10.0_wp, 1.0_wp]
      parts([2, 4])%joint_od = 0.2127_wp
      parts(2)%kind = 'stabilizer'
      parts(4)%kind = 'stabiliser'
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components(5))
      do i = 1, 5
         model%strings(1)%components(i) = parts(i)
      end do
      model%boundary%bit_centred = .true.
      call set_wall(model)
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'two stabilizers')
      blades = those(result, contact_blades)
      edges = those(result, contact_edge)
      call assertEqual(2, size(blades))
      call assertEqual(1, size(edges))
      if (size(blades) /= 2 .or. size(edges) /= 1) return
      call assertTrue(abs(depth - result%contacts(blades(2))%md - 4.5_wp) <= 0.5_wp, message='the lower one')
      call assertTrue(abs(depth - result%contacts(blades(1))%md - 15.5_wp) <= 0.5_wp, message='the upper one')
      bit = -result%bit_side_force*cos(result%bit_side_clock)
      landed = w*(depth - result%contacts(edges(1))%md)
      call note('carried over weight', (sum(result%contacts([blades, edges])%force) + bit)/landed)
      call assertRelativelyEqual(landed, sum(result%contacts([blades, edges])%force) + bit, within)
      call check_part(result, parts(1)%length, parts(2)%length, result%contacts(blades(2))%force)
      call check_part(result, sum(parts(1:3)%length), parts(4)%length, result%contacts(blades(1))%force)
      call check_sum(result)
   end subroutine test_stabilizers

   !> Two equal spans of a level collar that is held in the middle of the hole at both ends. Weight presses a short blade between
   !> them onto the low side with 5 w L/8 - 48 EI c/L^3, L being the length of both spans and c the clearance of the blade. The rows
   !> of the blade hold that force, the rows of the free collar beside it none. On the length of a joint of pipe the largest side
   !> force is that force over this length.
   subroutine test_blade()
      type(model_type) :: model
      type(case_result_type) :: result
      integer, allocatable :: blades(:)
      integer :: upper, lower
      real(wp), parameter :: length = 10.0_wp, blade = 0.1_wp, blade_od = 0.2127_wp, joint = 9.5_wp
      type(along_string_type) :: along
      type(whole_string_type) :: whole
      real(wp) :: force, below
      below = 0.5_wp*(length - blade)
      call lay_collar(model, length, below, blade, blade_od)
      call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'blade between held ends')
      force = 0.625_wp*w*length - 24.0_wp*bending_stiffness(pipe(w, od, id))*(hole - blade_od)/length**3
      blades = those(result, contact_blades)
      call assertEqual(1, size(blades))
      if (size(blades) /= 1) return
      call note('contact force of the blade over the closed form', result%contacts(blades(1))%force/force)
      call assertRelativelyEqual(force, result%contacts(blades(1))%force, 0.002_wp, message='blade')
      call check_part(result, below, blade, result%contacts(blades(1))%force)
      call find_along_string(model, result, along)
      call find_whole_string(model, result, along, whole)
      call assertRelativelyEqual(force/joint, whole%side_force, 0.002_wp, message='largest side force')
      call assertEqual(0.5_wp*length, whole%side_force_md, 0.5_wp*blade + 1.0e-6_wp, message='where')
      associate (p => result%profile)
         upper = findloc(p%side, side_above, dim=1)
         lower = findloc(p%side, side_below, dim=1, back=.true.)
         call assertEqual([0.0_wp, 0.0_wp], p%side_force([upper, lower]), message='side force of the collar beside it')
         call assertEqual([state_free, state_free], p%gap_state([upper, lower]), message='state of the collar beside it')
         call assertTrue(all(p%side_force([upper + 1, lower - 1]) > force/blade), message='both edges of the blade press')
         call assertTrue(all(p%gap_state([upper + 1, lower - 1]) /= state_free), message='state of the edges')
      end associate
      call check_sum(result)
   end subroutine test_blade

   !> The same collar with a blade of 2 mm, a metre from the bit, with 0.35 or 0.7 mm of clearance. The wall is the default
   !> one, taken as rigid. Simply supported ends: without the blade the place lies y lower, the blade presses with R = (y - c)/f,
   !> the bit with w L/2 - R b/L.
   subroutine test_near_bit()
      type(model_type) :: model
      type(case_result_type) :: result
      integer :: k
      real(wp), parameter :: length = 10.0_wp, blade = 2.0e-3_wp, from_bit = 1.0_wp, clearances(2) = [0.35e-3_wp, 0.7e-3_wp]
      real(wp) :: ei, free, flexibility, force, bit
      ei = bending_stiffness(pipe(w, od, id))
      free = w*from_bit*(length**3 - 2.0_wp*length*from_bit**2 + from_bit**3)/(24.0_wp*ei)
      flexibility = (from_bit*(length - from_bit))**2/(3.0_wp*ei*length)
      do k = 1, size(clearances)
         call lay_collar(model, length, from_bit - 0.5_wp*blade, blade, hole - 2.0_wp*clearances(k))
         call solve(model, operation_static, 0.0_wp, 0.0_wp, result, 'tight blade near the bit')
         force = (free - clearances(k))/flexibility
         bit = abs(0.5_wp*w*length - force*(length - from_bit)/length)
         call note('side force of the bit [N]', bit)
         call note('that found, over it, less one', result%bit_side_force/bit - 1.0_wp)
         call assertRelativelyEqual(bit, result%bit_side_force, 0.003_wp, message='side force of the bit')
      end do
   end subroutine test_near_bit

   !> A level collar with a blade, held in the middle of the hole at both ends.
   subroutine lay_collar(model, length, below, blade, blade_od)
      type(model_type), intent(out) :: model
      real(wp), intent(in) :: length      !< of the collar [m]
      real(wp), intent(in) :: below       !< of it below the blade [m]
      real(wp), intent(in) :: blade       !< length of the blade [m]
      real(wp), intent(in) :: blade_od    !< [m]
      type(component_type) :: parts(3)
      call new_well(model, [0.0_wp, length], [90.0_wp, 90.0_wp], [0.0_wp, 0.0_wp], hole, 0.0_wp, pipe(w, od, id))
      parts = pipe(w, od, id)
      parts(1:2)%length = [below, blade]
      parts(2)%joint_od = blade_od
      parts(2)%kind = 'stabilizer'
      deallocate (model%strings(1)%components)
      allocate (model%strings(1)%components, source=parts)
      call hold_ends(model)
      call set_wall(model)
   end subroutine lay_collar

   !> By the trapezoid rule the rows of a part of the string, of which two stand at each end, hold its contact force.
   subroutine check_part(result, from_bit, length, force)
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: from_bit       !< of the lower end of the part [m]
      real(wp), intent(in) :: length         !< of the part [m]
      real(wp), intent(in) :: force          !< [N]
      real(wp), parameter :: same_place = 1.0e-6_wp
      real(wp) :: bottom
      integer :: first, last
      associate (p => result%profile)
         bottom = p%md(size(p%md)) - from_bit
         first = findloc(abs(p%md - bottom + length) < same_place .and. p%side == side_below, .true., dim=1)
         last = findloc(abs(p%md - bottom) < same_place .and. p%side == side_above, .true., dim=1)
         call assertTrue(first > 0 .and. last > first, message='rows at both ends')
         if (.not. (first > 0 .and. last > first)) return
         call assertRelativelyEqual(force, sum(0.5_wp*(p%side_force(first + 1:last) + p%side_force(first:last - 1))* &
                                               (p%md(first + 1:last) - p%md(first:last - 1))), same, message='area over the part')
      end associate
   end subroutine check_part

   !> Weightless pipe pulled with T out of an arc of curvature k into straight hole. Its moment is EI k where it lies on the
   !> wall and fades from there as exp(-x sqrt(T/EI)): the shear force jumps by k sqrt(T EI), sqrt(EI/T) within the arc,
   !> whence the string has the hole's direction far above.
   subroutine test_bend()
      type(model_type) :: model
      type(case_result_type) :: result
      real(wp), parameter :: radius = 300.0_wp, tension = 4.0e5_wp, kick = 60.0_wp, length = 120.0_wp
      integer, allocatable :: edges(:)
      real(wp) :: ei, jump
      call new_well(model, [0.0_wp, kick, length], [0.0_wp, 0.0_wp, (length - kick)/radius/degree], [0.0_wp, 0.0_wp, 0.0_wp], &
                    0.2159_wp, 0.0_wp, pipe(0.0_wp, 0.127_wp, 0.1086_wp))
      model%boundary%top_centred = .true.
      call set_wall(model)
      call solve(model, operation_static, -tension, 0.0_wp, result, 'end of a bend')
      edges = those(result, contact_edge)
      call assertTrue(size(edges) > 0)
      if (size(edges) == 0) return
      ei = bending_stiffness(pipe(0.0_wp, 0.127_wp, 0.1086_wp))
      jump = sqrt(tension*ei)/radius
      call note('edge over jump of the shear force', result%contacts(edges(1))%force/jump)
      call note('its place in the arc over sqrt(EI/T)', (result%contacts(edges(1))%md - kick)/sqrt(ei/tension))
      call assertRelativelyEqual(jump, result%contacts(edges(1))%force, within)
      call assertEqual(kick + sqrt(ei/tension), result%contacts(edges(1))%md, 0.25_wp*sqrt(ei/tension))
      call check_sum(result)
   end subroutine test_bend

   !> Joints one by one carry all contact, and stand with it in the profile; smeared they have that of their share of the string.
   subroutine test_joints()
      type(model_type) :: model
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(component_type) :: jointed
      integer, allocatable :: joints(:)
      real(wp), parameter :: spacing = 9.5_wp, weight = 263.0_wp      ! m, N/m
      integer :: row
      jointed = pipe(weight, 0.127_wp, 0.1086_wp)
      jointed%joint_od = 0.1683_wp
      jointed%joint_spacing = spacing
      call new_well(model, [0.0_wp, 300.0_wp, 600.0_wp], [0.0_wp, 0.0_wp, 40.0_wp], [0.0_wp, 0.0_wp, 0.0_wp], 0.2159_wp, 0.25_wp, &
                    jointed)
      model%numerics%moments = .true.
      call hold_ends(model)
      call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'smeared')
      call find_along_string(model, result, along)
      row = minloc(abs(result%profile%md - 350.0_wp), dim=1)     ! in the bend, pulled to its high side
      associate (p => result%profile)
         call assertRelativelyEqual(spacing*(p%axial(row)*40.0_wp*degree/300.0_wp - weight*sin(p%inclination(row))), &
                                    along%joint_side_force(row), 0.002_wp, message='T k - w sin(inclination) on a joint')
      end associate
      call check_sum(result)
      model%numerics%discrete_joints = .true.
      call solve(model, operation_trip_out, 0.0_wp, 0.0_wp, result, 'one by one')
      call find_along_string(model, result, along)
      joints = those(result, contact_joint)
      call note('joints that touch', real(size(joints), wp))
      call note('their force over all contact', sum(result%contacts(joints)%force)/result%normal_force)
      call assertRelativelyEqual(result%normal_force, sum(result%contacts(joints)%force), 0.01_wp, message='joints carry all')
      call assertRelativelyEqual(sum(result%contacts(joints)%force), sum(along%joint_side_force), same, message='in the profile')
      call assertEqual(size(joints), count(along%joint_side_force > 0.0_wp), message='a row each')
      call assertEqual(0, count(is_missing(along%joint_side_force)))
      call check_sum(result)
   end subroutine test_joints
end module dg_test_contacts

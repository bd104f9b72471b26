!> Friction of a component in its hole: coefficients of hole, load case and component together.
module dg_contact_friction
   use dg_kinds, only: wp
   use dg_component, only: centralizer_diameter, component_type
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: friction_split, load_case_type, moves_axially, operation_trip_in
   use dg_missing, only: is_missing
   implicit none
   private
   public :: find_friction, frictions_met, running_drag, axial_friction, set_axial_friction, &
             scale_friction, shift_friction

contains

   !> Axial coefficient of a hole section for an operation [-]. A section may have another one for trip_in.
   elemental function axial_friction(hole, operation) result(friction)
      type(hole_section_type), intent(in) :: hole
      integer, intent(in) :: operation
      real(wp) :: friction
      friction = hole%friction_axial
      if (operation == operation_trip_in .and. .not. is_missing(hole%friction_running_in)) friction = hole%friction_running_in
   end function axial_friction

   !> Coefficients of a hole section along and around it [-]. A load case may override them.
   pure subroutine find_hole_friction(hole, load_case, axial, rotary)
      type(hole_section_type), intent(in) :: hole
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(out) :: axial, rotary
      axial = axial_friction(hole, load_case%operation)
      if (load_case%friction_axial%present) axial = load_case%friction_axial%value
      rotary = hole%friction_rotary
      if (load_case%friction_rotary%present) rotary = load_case%friction_rotary%value
   end subroutine find_hole_friction

   !> Friction factors that a load case meets in its hole, from the top down, each once. They are those along the hole for a
   !> string that moves, else those around it.
   pure function frictions_met(holes, load_case) result(factors)
      type(hole_section_type), intent(in) :: holes(:)
      type(load_case_type), intent(in) :: load_case
      real(wp), allocatable :: factors(:)
      real(wp) :: axial, rotary, factor
      integer :: i
      allocate (factors(0))
      do i = 1, size(holes)
         if (.not. holes(i)%md_top < load_case%bit_depth) cycle
         call find_hole_friction(holes(i), load_case, axial, rotary)
         factor = merge(axial, rotary, moves_axially(load_case%operation))
         if (factor > 0.0_wp .and. all(abs(factors - factor) > 0.0_wp)) factors = [factors, factor]
      end do
   end function frictions_met

   !> Set the axial coefficient of a hole section for load cases with these operations; absent: for all operations. Operations
   !> without axial motion count as trip_out if no other one moves axially. All code that changes the friction of a hole calls
   !> this.
   pure subroutine set_axial_friction(hole, friction, operations)
      type(hole_section_type), intent(inout) :: hole
      real(wp), intent(in) :: friction                    !< [-]
      integer, intent(in), optional :: operations(:)
      logical :: running_in, others
      running_in = .not. is_missing(hole%friction_running_in)
      others = .true.
      if (present(operations)) then
         running_in = running_in .and. any(operations == operation_trip_in)
         others = .not. running_in .or. any(operations /= operation_trip_in .and. moves_axially(operations))
      end if
      if (running_in) hole%friction_running_in = friction
      if (others) hole%friction_axial = friction
   end subroutine set_axial_friction

   !> Add to the axial or rotary coefficients of a hole section, or to both. Negative results become 0.
   elemental subroutine shift_friction(hole, change, axial, rotary)
      type(hole_section_type), intent(inout) :: hole
      real(wp), intent(in) :: change                      !< [-]
      logical, intent(in) :: axial, rotary                !< which coefficients
      if (rotary) hole%friction_rotary = max(hole%friction_rotary + change, 0.0_wp)
      if (.not. axial) return
      hole%friction_axial = max(hole%friction_axial + change, 0.0_wp)
      if (.not. is_missing(hole%friction_running_in)) hole%friction_running_in = max(hole%friction_running_in + change, 0.0_wp)
   end subroutine shift_friction

   !> Multiply all friction of a component, whatever it comes from, except the running force of bow springs.
   elemental subroutine scale_friction(factor, component)
      real(wp), intent(in) :: factor                      !< [-]
      type(component_type), intent(inout) :: component
      component%scale_axial = factor*component%scale_axial
      component%scale_rotary = factor*component%scale_rotary
      call scale(component%friction_axial)
      call scale(component%friction_rotary)
      call scale(component%centralizer%friction_axial)
      call scale(component%centralizer%friction_rotary)

   contains

      !> Multiply a coefficient, if it is given.
      pure subroutine scale(friction)
         real(wp), intent(inout) :: friction              !< [-]
         if (.not. is_missing(friction)) friction = factor*friction
      end subroutine scale
   end subroutine scale_friction

   !> Signed shares of friction along and around the hole, as in friction_split. A load case overrides the coefficients of the
   !> hole. A component multiplies both by a factor, or replaces them by coefficients of its own. So does a centralizer where
   !> it touches.
   pure subroutine find_friction(hole, component, load_case, centralized, radius, scale, axial, rotary)
      type(hole_section_type), intent(in) :: hole
      type(component_type), intent(in) :: component
      type(load_case_type), intent(in) :: load_case
      logical, intent(in) :: centralized !< true if its centralizers touch, not its body
      real(wp), intent(in) :: radius     !< radius at which the string touches [m]
      real(wp), intent(in) :: scale      !< factor on all coefficients [-]
      real(wp), intent(out) :: axial     !< > 0 pushes down the hole [-]
      real(wp), intent(out) :: rotary    !< against the rotation, >= 0 [-]
      real(wp) :: mu_axial, mu_rotary
      call find_hole_friction(hole, load_case, mu_axial, mu_rotary)
      mu_axial = mu_axial*component%scale_axial
      if (.not. is_missing(component%friction_axial)) mu_axial = component%friction_axial
      mu_rotary = mu_rotary*component%scale_rotary
      if (.not. is_missing(component%friction_rotary)) mu_rotary = component%friction_rotary
      if (centralized) then
         if (.not. is_missing(component%centralizer%friction_axial)) mu_axial = component%centralizer%friction_axial
         if (.not. is_missing(component%centralizer%friction_rotary)) mu_rotary = component%centralizer%friction_rotary
      end if
      call friction_split(load_case, scale*mu_axial, scale*mu_rotary, radius, axial, rotary)
   end subroutine find_friction

   !> Drag of a bow spring in a hole that is narrower than it [N], with the sign of `axial` in find_friction. It is its running
   !> force. For a string that turns as it moves, it is reduced like an axial friction.
   pure function running_drag(hole, component, load_case) result(drag)
      type(hole_section_type), intent(in) :: hole
      type(component_type), intent(in) :: component
      type(load_case_type), intent(in) :: load_case
      real(wp) :: drag, ignored
      drag = 0.0_wp
      if (.not. component%centralizer%present .or. hole%diameter >= component%centralizer%od) return
      call friction_split(load_case, component%centralizer%running_force, 0.0_wp, 0.5_wp*centralizer_diameter(component), drag, &
                          ignored)
   end function running_drag
end module dg_contact_friction

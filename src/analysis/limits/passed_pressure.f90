!> Limits by pressure that a load case passes. Whatever its axial force, they can be judged without a solution. Of a solution, the
!> pump pressure with which they are not passed.
module dg_passed_pressure
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_case_result, only: case_result_type
   use dg_fluid, only: density_at, fills, mud_type, side_inside, side_outside
   use dg_job, only: model_soft
   use dg_missing, only: given, optional_real
   use dg_model, only: model_type
   use dg_profile_rows, only: lay_rows
   use dg_soft_string, only: set_profile
   use dg_string_piece, only: breakpoints
   use dg_utilisation, only: as_much, find_utilisation, limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse, &
                             utilisation_type
   implicit none
   private
   public :: find_passed_pressure, find_pump_pressure, is_burst

   integer, parameter :: by_pressure(4) = [limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse]
   !> Accuracy of a pump pressure over its search [-].
   real(wp), parameter :: narrowness = 1.0e-5_wp
   !> Density of air below which a string is empty [kg/m3]. Gas that is kept under pressure is heavier.
   real(wp), parameter :: empty = 10.0_wp

contains

   !> Find the limit that is exceeded most. Axial force counts as zero. The compression of a locked-up string would not reduce
   !> burst and collapse as they are judged.
   pure subroutine find_passed_pressure(model, case_index, limit, load, allowed, checked)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      integer, intent(out) :: limit              !< number of dg_utilisation; 0: none is exceeded
      real(wp), intent(out) :: load, allowed     !< difference of pressures there, and the allowed one [Pa]
      logical, intent(out) :: checked            !< true if a strength against pressure is known
      type(case_result_type) :: still
      type(along_string_type) :: along
      type(utilisation_type) :: utilisation
      real(wp), allocatable :: breaks(:), md(:), none(:)
      integer, allocatable :: from(:), side(:)
      integer :: i
      allocate (breaks, source=breakpoints(model, case_index))
      call lay_rows(model, case_index, breaks, from, side)
      allocate (md, source=breaks(from))
      allocate (none(size(md)), source=0.0_wp)
      still%case_index = case_index
      still%model = model_soft
      call set_profile(model, case_index, md, side, none, none, spread(none, 1, 3), still)
      call find_along_string(model, still, along)
      call find_utilisation(model, still, along, utilisation)
      limit = 0
      load = 0.0_wp
      allowed = 0.0_wp
      associate (used => utilisation%used(by_pressure))
         checked = any(used%present)
         i = maxloc(used%value, dim=1, mask=used%present)
         if (i == 0) return
         if (.not. used(i)%value > 1.0_wp + as_much) return
         limit = by_pressure(i)
         load = utilisation%load(limit)
         allowed = load/used(i)%value
      end associate
   end subroutine find_passed_pressure

   !> Find the pump pressure with which a result that passes a limit by pressure passes no limit of dg_utilisation. It is the one
   !> next to the given pressure: less for burst, more for collapse. Pump pressure changes no axial force. Absent if there is no
   !> such pressure, for tubing in a packer, whose forces change, and where compressed pipe yields.
   !> An empty string is to be filled instead, if that prevents collapse.
   pure subroutine find_pump_pressure(model, result, limit, wob_yield, pump, fill)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result       !< converged
      integer, intent(in) :: limit                       !< that is passed
      type(optional_real), intent(in) :: wob_yield       !< weight on bit at which compressed pipe yields [N]
      type(optional_real), intent(out) :: pump           !< [Pa]
      logical, intent(out) :: fill                       !< true: fill the string with the fluid outside
      type(bracket_type) :: bracket
      type(utilisation_type) :: uses
      real(wp) :: now, far, left, pressure
      fill = .false.
      if (all(by_pressure /= limit) .or. model%boundary%packer_bore > 0.0_wp) return
      if (wob_yield%present .and. model%cases(result%case_index)%wob > wob_yield%value) return
      now = model%cases(result%case_index)%pump_pressure
      if (.not. is_burst(limit) .and. is_empty()) then
         uses = uses_at(now, filled(model%mud))
         fill = uses%used(uses%governing)%value <= 1.0_wp + as_much
         if (fill) return
      end if
      uses = uses_at(now)
      left = 1.0_wp - uses%used(limit)%value
      far = now + merge(-1.0_wp, 1.0_wp, is_burst(limit))*uses%load(limit)
      far = max(far, 0.0_wp)
      uses = uses_at(far)
      if (uses%used(limit)%value > 1.0_wp) return
      bracket = new_bracket(far, 1.0_wp - uses%used(limit)%value, now, left)
      do while (.not. is_narrow(bracket, narrowness*abs(far - now)))
         pressure = next_try(bracket, narrowness*abs(far - now))
         uses = uses_at(pressure)
         call narrow(bracket, pressure, 1.0_wp - uses%used(limit)%value)
      end do
      uses = uses_at(bracket%low)
      if (uses%used(uses%governing)%value <= 1.0_wp + as_much) pump = given(bracket%low)
   contains
      !> True if the string is empty anywhere between its top and the bit.
      pure function is_empty() result(is)
         logical :: is
         integer :: i
         associate (md => result%profile%md, bit => model%cases(result%case_index)%bit_depth)
            is = any([(density_at(model%mud, side_inside, md(i), bit) < empty, i=1, size(md))])
         end associate
      end function is_empty

      !> Uses of all limits with a pump pressure [Pa], and with another mud.
      pure function uses_at(pressure, mud) result(uses)
         real(wp), intent(in) :: pressure
         type(mud_type), intent(in), optional :: mud
         type(utilisation_type) :: uses
         type(model_type) :: other
         type(along_string_type) :: along
         other = model
         other%cases(result%case_index)%pump_pressure = pressure
         if (present(mud)) other%mud = mud
         call find_along_string(other, result, along)
         call find_utilisation(other, result, along, uses)
      end function uses_at
   end subroutine find_pump_pressure

   !> Fluids of a string that is filled with those outside.
   pure function filled(mud)
      type(mud_type), intent(in) :: mud
      type(mud_type) :: filled
      if (.not. allocated(mud%fluids)) return
      allocate (filled%fluids, source=pack(mud%fluids, fills(mud%fluids, side_outside)))
      filled%fluids%inside = .true.
   end function filled

   !> True for a limit of pressure inside.
   elemental function is_burst(limit) result(is)
      integer, intent(in) :: limit       !< number of dg_utilisation
      logical :: is
      is = limit == limit_burst .or. limit == limit_joint_burst
   end function is_burst
end module dg_passed_pressure

!> Loads of limits as texts, in the deck's units. Three numbers of one sentence add up as they are shown.
module dg_load_text
   use dg_kinds, only: wp
   use dg_fatigue, only: hour
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_curvature, unit_factor, unit_force, unit_label, unit_moment, unit_none, unit_pressure, &
                           unit_stress
   use dg_units, only: unit_system_type
   use dg_utilisation, only: limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse, &
                             limit_joint_compression, limit_joint_dogleg, limit_joint_tension, limit_joint_torsion, limit_makeup, &
                             limit_top_drive, limit_torsion, limit_von_mises
   use dg_verdict, only: limit_casing_wear, limit_fatigue, limit_joint_fatigue
   implicit none
   private
   public :: force_text, load_text, number_text, sum_texts, sum_width

   !> Digits of a load, and of the smallest of three that add up.
   integer, parameter :: shown = 3
   !> Fewest digits of the allowed load of three that add up: it is the same beside a small load and a large one.
   integer, parameter :: fewest_digits = 4
   !> Most digits of the largest of three that add up: a small one beside it has fewer than `shown`.
   integer, parameter :: most_digits = 5
   !> Excess of a shown difference that is round-off [steps].
   real(wp), parameter :: round_off = 1.0e-6_wp
   !> Room for a load with its unit.
   integer, parameter :: sum_width = 40

contains

   !> A load, the allowed load and their difference, rounded at one place so that they add up. The load is rounded as in tables. A
   !> load that is too much is at least one step more than the allowed one.
   pure function sum_texts(units, limit, load, allowed) result(texts)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: limit
      real(wp), intent(in) :: load, allowed     !< [N, N.m, Pa, 1/m or s]
      character(sum_width) :: texts(3)
      real(wp) :: numbers(3), steps(2), unit       ! steps: in units of the last place
      integer :: place, i
      unit = factor_of(units, limit)
      numbers = abs([load, allowed, allowed - load])/unit
      texts(1) = load_text(units, limit, load)
      texts(2) = load_text(units, limit, allowed)
      texts(3) = load_text(units, limit, abs(allowed - load))
      if (any(numbers(:2) > huge(1)) .or. .not. maxval(numbers) > 0.0_wp) return
      place = floor(log10(maxval(numbers))) + 1 - most_digits
      if (minval(numbers) > 0.0_wp) then
         place = max(place, min(floor(log10(minval(numbers))) + 1 - shown, floor(log10(numbers(2))) + 1 - fewest_digits))
      end if
      ! the allowed load is rounded down, whatever the load
      steps = [anint(load/unit*10.0_wp**(-place)), floor_of(allowed/unit*10.0_wp**(-place))]
      if (load > allowed .and. .not. steps(1) > steps(2)) steps(1) = steps(2) + 1.0_wp
      numbers = [steps, abs(steps(2) - steps(1))]
      do i = 1, size(texts)
         texts(i) = to_text(numbers(i)*10.0_wp**place, digits_of(numbers(i)))//' '//label_of(units, limit)
      end do
   end function sum_texts

   !> The greatest whole number that is not above a number, but for round-off.
   elemental function floor_of(number) result(whole)
      real(wp), intent(in) :: number
      real(wp) :: whole
      whole = aint(number)
      if (number - whole > 1.0_wp - round_off) whole = whole + 1.0_wp
      if (number - whole < -round_off) whole = whole - 1.0_wp
   end function floor_of

   !> Digits of a whole number.
   elemental function digits_of(number) result(digits)
      real(wp), intent(in) :: number
      integer :: digits
      digits = 1
      if (abs(number) >= 1.0_wp) digits = floor(log10(abs(number))) + 1
   end function digits_of

   !> A load of a limit without its unit.
   pure function number_text(units, limit, load) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: limit
      real(wp), intent(in) :: load       !< [N, N.m or Pa]
      character(:), allocatable :: text
      text = load_text(units, limit, load)
      text = text(:index(text, ' ') - 1)
   end function number_text

   !> A load of a limit.
   pure function load_text(units, limit, load) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: limit
      real(wp), intent(in) :: load       !< [N, N.m, Pa, 1/m or s]
      character(:), allocatable :: text
      text = to_text(load/factor_of(units, limit), shown)//' '//label_of(units, limit)
   end function load_text

   !> A force.
   pure function force_text(units, force) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: force      !< [N]
      character(:), allocatable :: text
      text = in_units(units, unit_force, force, shown)
   end function force_text

   !> Unit of the load of a limit [SI].
   pure function factor_of(units, limit) result(factor)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: limit
      real(wp) :: factor
      factor = hour
      if (quantity_of(limit) /= unit_none) factor = unit_factor(units, quantity_of(limit))
   end function factor_of

   !> Name of the unit of the load of a limit.
   pure function label_of(units, limit) result(label)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: limit
      character(:), allocatable :: label
      label = 'h'
      if (quantity_of(limit) /= unit_none) label = trim(unit_label(units, quantity_of(limit)))
   end function label_of

   !> Quantity of the load of a limit; none for hours.
   pure function quantity_of(limit) result(quantity)
      integer, intent(in) :: limit
      integer :: quantity
      select case (limit)
      case (limit_torsion, limit_joint_torsion, limit_makeup, limit_top_drive); quantity = unit_moment
      case (limit_joint_dogleg); quantity = unit_curvature
      case (limit_von_mises, limit_joint_tension, limit_joint_compression); quantity = unit_stress
      case (limit_fatigue, limit_joint_fatigue, limit_casing_wear); quantity = unit_none
      case (limit_burst, limit_collapse, limit_joint_burst, limit_joint_collapse); quantity = unit_pressure
      case default; quantity = unit_force
      end select
   end function quantity_of
end module dg_load_text

!> Result of a load case whose string cannot be brought to its depth or load.
module dg_lock_up_result
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_locked_up
   use dg_fluid_pressure, only: surface_push
   use dg_job, only: model_mcge
   use dg_model, only: model_type
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_text, only: to_text
   use dg_trajectory, only: inclination_of, position_at, top_md
   use dg_unit_kind, only: in_units, unit_force, unit_length
   use dg_weight_on_bit, only: most_load_at_bit
   implicit none
   private
   public :: add_load_at_bit, result_of_lock_up

   !> Digits in a message.
   integer, parameter :: shown = 4, shown_depth = 6

contains

   !> Make the result of a case that is locked up: a message without numbers. Either friction of the helically buckled string
   !> grows without bound, or no pipe carries the pull against it.
   subroutine result_of_lock_up(model, case_index, totals, strained, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(soft_totals_type), intent(in) :: totals   !< of the soft string that locks up
      real(wp), intent(in) :: strained      !< its largest axial strain [-]
      type(case_result_type), intent(out) :: result
      type(model_type) :: limp             ! its soft string without the stiff assembly's friction
      type(soft_totals_type) :: without
      real(wp) :: position(3), tangent(3), axial(1), torque(1), drag
      call position_at(model%trajectory, model%cases(case_index)%bit_depth, position, tangent)
      result%case_index = case_index
      result%model = model_mcge
      result%status = result_locked_up
      result%inclination = inclination_of(tangent)
      allocate (result%gaps(0), result%history(0))
      if (.not. totals%runaway) then
         call soft_string_at(model, case_index, [top_md(model%trajectory)], axial, torque, other=other_loads_type(coiled=.true.))
         result%message = 'Locked up: friction holds the string. '//in_units(model%units, unit_force, &
                          axial(1) - surface_push(model, case_index), shown)//' at surface would move it and stretch it by '// &
                          to_text(100.0_wp*strained, shown)//' %, which no pipe bears'
         return
      end if
      limp = model
      limp%stiff_drag = 0.0_wp
      call soft_string_at(limp, case_index, [top_md(model%trajectory)], axial, torque, totals=without, &
                          other=other_loads_type(coiled=.true.))
      drag = abs(without%weight - model%cases(case_index)%wob - axial(1))
      if (without%runaway .or. drag > abs(model%stiff_drag)) then
         result%message = 'Locked up: with the bit at '// &
                          in_units(model%units, unit_length, model%cases(case_index)%bit_depth, shown_depth)// &
                          ', friction of helical buckling between surface and '// &
                          to_text(anint(totals%runaway_md/model%units%length))//' '//trim(model%units%length_label)// &
                          ' takes up any push from surface. '
      else
         result%message = 'Locked up: the stiff assembly holds the string. Its bend or its blades press the hole, which takes '// &
                          in_units(model%units, unit_force, abs(model%stiff_drag), shown)//' of friction. Check the '// &
                          'diameters that touch, the diameter of the hole and the bend. '
      end if
      result%lock_up_load = most_load_at_bit(model, case_index, coiled=.true., pushed=.true.)
      call add_load_at_bit(model, result%lock_up_load, .false., result%message)
   end subroutine result_of_lock_up

   !> Append the greatest load that reaches the bit, however hard the string is pushed at surface, or how much of it is missing.
   subroutine add_load_at_bit(model, load, by_beams, message)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: load         !< at the bit, < 0: what is missing [N]
      logical, intent(in) :: by_beams      !< found by beams, not by the soft string
      character(:), allocatable, intent(inout) :: message
      character(:), allocatable :: text
      text = in_units(model%units, unit_force, abs(load), shown)
      if (load > 0.0_wp) then
         message = message//'Pushed at surface with all that pipe bears, the string brings at most '//text//' to the bit'
      else
         message = message//'No push at surface brings the string down to this depth'
         if (load < 0.0_wp) message = message//': '//text//' are missing at the bit with all the push that pipe bears'
      end if
      if (by_beams .and. abs(load) > 0.0_wp) message = message//', by beams'
   end subroutine add_load_at_bit
end module dg_lock_up_result

!> Description of a component beside its pipe body: a bent housing, pads, eccentric blades, a survey sensor, rated connections, a
!> fatigue curve.
module dg_tools_text
   use dg_component, only: component_type, has_bend, has_pad, is_eccentric, usual_yield_loss
   use dg_fatigue_curve, only: fatigue_curve_name, fatigue_curve_type, fatigue_none, fatigue_own
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_angle, unit_curvature, unit_diameter, unit_force, unit_length, unit_loss, unit_stress
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: tools_text

   integer, parameter :: digits = 7

contains

   !> All of them, each behind a comma; '' for plain pipe.
   pure function tools_text(units, part) result(text)
      type(unit_system_type), intent(in) :: units
      type(component_type), intent(in) :: part
      character(:), allocatable :: text
      text = ''
      if (has_bend(part)) text = ', bent by '//shown(unit_angle, part%bend)//' at '//shown(unit_length, part%bend_position)// &
         ', straight where the string rotates'
      if (has_pad(part)) text = text//', pushed by pads with '//shown(unit_force, part%pad_force)//' to '// &
         shown(unit_angle, part%pad_clock)//' at '//shown(unit_length, part%pad_position)
      if (is_eccentric(part)) text = text//', blades off centre by '//shown(unit_diameter, part%blade_offset)//' at '// &
         shown(unit_angle, part%blade_clock)//' from the toolface, centred where the string rotates'
      if (.not. is_missing(part%sensor)) text = text//', survey sensor at '//shown(unit_length, part%sensor)
      if (abs(part%yield_loss - usual_yield_loss) > 0.0_wp) text = text//', yield loss '//shown(unit_loss, part%yield_loss)
      associate (rating => part%rating)
         text = text//rated(', connection tension ', rating%tension)//rated(', connection compression ', rating%compression)// &
                rated(', connection burst ', rating%burst)//rated(', connection collapse ', rating%collapse)
         if (.not. is_missing(rating%dogleg)) text = text//', connection dogleg '//shown(unit_curvature, rating%dogleg)
      end associate
      text = text//fatigue_text(', fatigue ', part%fatigue)//fatigue_text(', joint fatigue ', part%joint_fatigue)
   contains
      !> A fatigue curve; nothing for none.
      pure function fatigue_text(head, fatigue) result(text)
         character(*), intent(in) :: head
         type(fatigue_curve_type), intent(in) :: fatigue
         character(:), allocatable :: text
         text = ''
         if (fatigue%curve == fatigue_none) return
         text = head//trim(fatigue_curve_name(fatigue%curve))
         if (fatigue%curve == fatigue_own) text = text//' '//shown(unit_stress, fatigue%limit)
         if (fatigue%tensile > 0.0_wp) text = text//', tensile strength '//shown(unit_stress, fatigue%tensile)
         if (fatigue%share < 1.0_wp) text = text//' times '//to_text(fatigue%share, digits)
         if (fatigue%exponent > 0.0_wp) text = text//', exponent '//to_text(fatigue%exponent, digits)//' from '// &
            to_text(fatigue%turns, digits)//' turns'
      end function fatigue_text

      !> An efficiency of connections; nothing where it is not known.
      pure function rated(head, share) result(words)
         character(*), intent(in) :: head
         real(wp), intent(in) :: share      !< of the strength of the body [-]
         character(:), allocatable :: words
         words = ''
         if (.not. is_missing(share)) words = head//to_text(100.0_wp*share, digits)//' % of the body'
      end function rated

      pure function shown(quantity, value) result(words)
         integer, intent(in) :: quantity
         real(wp), intent(in) :: value
         character(:), allocatable :: words
         words = in_units(units, quantity, value, digits)
      end function shown
   end function tools_text
end module dg_tools_text

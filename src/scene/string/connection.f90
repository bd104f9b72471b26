!> Rotary shouldered connections: dimensions by API Spec 7-2, and the torque at which one yields by API RP 7G, appendix A.8.
module dg_connection
   use dg_kinds, only: wp
   use dg_constants, only: degree, inch, pi
   implicit none
   private
   public :: connection_name, find_connection, connection_torsion, makeup_share

   !> Dimensions [m], except the taper [-].
   type :: connection_type
      real(wp) :: pitch_diameter = 0.0_wp   !< C, of the thread at the gauge point
      real(wp) :: taper = 0.0_wp            !< of the diameter over the length [-]
      real(wp) :: pin_length = 0.0_wp       !< L_pc
      real(wp) :: counterbore = 0.0_wp      !< Q_c, of the box
      real(wp) :: thread_height = 0.0_wp    !< H, not truncated
      real(wp) :: root_truncation = 0.0_wp  !< S_rs
   end type connection_type

   integer, parameter :: connection_count = 15
   !> Names in decks; FH without a blank, because a name of a deck has none.
   character(*), parameter :: connection_name(connection_count) = [character(7) :: 'NC23', 'NC26', 'NC31', 'NC35', 'NC38', 'NC40', &
      'NC44', 'NC46', 'NC50', 'NC56', 'NC61', 'NC70', 'NC77', '5-1/2FH', '6-5/8FH']

   !> Torque to which connections are made up, over the one at which they yield (API RP 7G).
   real(wp), parameter :: makeup_share = 0.6_wp

   ! Dimensions as the standard prints them [in]: pitch diameter, taper [in/ft], length of the pin, counterbore of the box.
   real(wp), parameter :: inch_per_foot = 1.0_wp/12.0_wp
   real(wp), parameter :: dimensions(4, connection_count) = reshape([ &
      2.355_wp, 2.0_wp, 3.0_wp, 2.625_wp, &
      2.668_wp, 2.0_wp, 3.0_wp, 2.9375_wp, &
      3.183_wp, 2.0_wp, 3.5_wp, 3.453125_wp, &
      3.531_wp, 2.0_wp, 3.75_wp, 3.8125_wp, &
      3.808_wp, 2.0_wp, 4.0_wp, 4.078125_wp, &
      4.072_wp, 2.0_wp, 4.5_wp, 4.34375_wp, &
      4.417_wp, 2.0_wp, 4.5_wp, 4.6875_wp, &
      4.626_wp, 2.0_wp, 4.5_wp, 4.90625_wp, &
      5.0417_wp, 2.0_wp, 4.5_wp, 5.3125_wp, &
      5.616_wp, 3.0_wp, 5.0_wp, 5.9375_wp, &
      6.178_wp, 3.0_wp, 5.5_wp, 6.5_wp, &
      7.053_wp, 3.0_wp, 6.0_wp, 7.375_wp, &
      7.741_wp, 3.0_wp, 6.5_wp, 8.0625_wp, &
      5.591_wp, 2.0_wp, 5.0_wp, 5.90625_wp, &
      6.5196_wp, 2.0_wp, 5.0_wp, 6.84375_wp], [4, connection_count])
   !> Four threads an inch.
   real(wp), parameter :: pitch = 0.25_wp*inch
   !> Heights of the thread, not truncated, by the taper: 2 and 3 in/ft.
   real(wp), parameter :: height_2 = 0.216005_wp*inch, height_3 = 0.215379_wp*inch
   !> Truncations of the root: thread forms V-0.038R of the NC family, V-0.050 of full hole.
   real(wp), parameter :: truncation_nc = 0.038_wp*inch, truncation_fh = 0.025_wp*inch
   integer, parameter :: first_full_hole = 14
   real(wp), parameter :: thread_angle = 30.0_wp*degree     !< half of it
   real(wp), parameter :: thread_friction = 0.08_wp         !< of thread compound, on threads and shoulder

contains

   !> The connection of that number among `connection_name`.
   pure function find_connection(number) result(connection)
      integer, intent(in) :: number
      type(connection_type) :: connection
      connection%pitch_diameter = dimensions(1, number)*inch
      connection%taper = dimensions(2, number)*inch_per_foot
      connection%pin_length = dimensions(3, number)*inch
      connection%counterbore = dimensions(4, number)*inch
      connection%thread_height = merge(height_2, height_3, dimensions(2, number) < 2.5_wp)
      connection%root_truncation = merge(truncation_fh, truncation_nc, number >= first_full_hole)
   end function find_connection

   !> Torque [N.m] at which pin or box yields: Y A (p/(2 pi) + R_t f/cos(30 deg) + R_s f). A is the lesser area, of the pin 3/4
   !> in, of the box 3/8 in from the shoulder (API RP 7G, A.8.2). It is 0 if the bore leaves no pin or the outside no box.
   elemental function connection_torsion(connection, od, bore, yield) result(torque)
      type(connection_type), intent(in) :: connection
      real(wp), intent(in) :: od      !< of the tool joint [m]
      real(wp), intent(in) :: bore    !< of the pin [m]
      real(wp), intent(in) :: yield   !< strength of the tool joint [Pa]
      real(wp) :: torque
      real(wp) :: box_bore, pin_od, area, thread_radius, shoulder_radius
      associate (c => connection)
         box_bore = c%counterbore - c%taper*0.375_wp*inch
         pin_od = c%pitch_diameter - 2.0_wp*(0.5_wp*c%thread_height - c%root_truncation) - c%taper*0.125_wp*inch
         area = 0.25_wp*pi*min((od - box_bore)*(od + box_bore), (pin_od - bore)*(pin_od + bore))
         thread_radius = 0.25_wp*(2.0_wp*c%pitch_diameter - (c%pin_length - 0.625_wp*inch)*c%taper)
         shoulder_radius = 0.25_wp*(od + c%counterbore)
      end associate
      torque = yield*max(area, 0.0_wp)*(pitch/(2.0_wp*pi) + thread_friction*(thread_radius/cos(thread_angle) + shoulder_radius))
   end function connection_torsion
end module dg_connection

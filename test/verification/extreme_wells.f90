!> Wells and cases from which the table of extremes starts.
module dg_extreme_wells
   use dg_constants, only: degree, pi
   use dg_extreme_case, only: extreme_case_type
   use dg_independent_beam, only: independent_well_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_rotate_off_bottom, operation_sliding_drilling, &
                           operation_trip_in, operation_trip_out
   implicit none
   private
   public :: base_well, straight_well, tubing_well, horizontal_well, case_of, add_stations, coil_lock_up, coil_condition

   !> Azimuth of holes that do not turn [deg].
   real(wp), parameter :: azimuth = 40.0_wp
   !> Nodes of the independent beam to a radius of a bend, at least, and their largest distance [m].
   real(wp), parameter :: steps_a_radius = 200.0_wp, longest_step = 0.1_wp

contains

   !> Drill pipe in a hole of 580 m that builds and turns.
   pure function base_well() result(well)
      type(independent_well_type) :: well
      well%md = [0.0_wp, 150.0_wp, 250.0_wp, 450.0_wp, 600.0_wp]
      well%inclination = [0.0_wp, 0.0_wp, 10.0_wp, 35.0_wp, 35.0_wp]
      well%azimuth = [azimuth, azimuth, azimuth, 2.0_wp*azimuth, 2.0_wp*azimuth]
      well%diameter = 0.2159_wp
      well%mud = 1250.0_wp
      well%bit = 580.0_wp
      well%length = [0.0_wp]
      well%od = [0.127_wp]
      well%id = [0.1086_wp]
      well%joint = [0.1619_wp]
      well%mass = [31.9_wp]
   end function base_well

   !> The same pipe in a straight hole.
   pure function straight_well(length, inclination) result(well)
      real(wp), intent(in) :: length, inclination    !< [m], [deg]
      type(independent_well_type) :: well
      well = base_well()
      well%md = [0.0_wp, length]
      well%inclination = [inclination, inclination]
      well%azimuth = [azimuth, azimuth]
      well%bit = length
   end function straight_well

   !> Tubing over a bend of up to 60 deg, 100 m of straight hole on both sides.
   pure function tubing_well(dogleg) result(well)
      real(wp), intent(in) :: dogleg     !< [deg/30 m]
      type(independent_well_type) :: well
      real(wp) :: angle, length
      angle = min(60.0_wp, 10.0_wp*dogleg)
      length = 30.0_wp*angle/dogleg
      well = base_well()
      well%md = [0.0_wp, 100.0_wp, 100.0_wp + length, 200.0_wp + length]
      well%inclination = [0.0_wp, 0.0_wp, angle, angle]
      well%azimuth = [azimuth, azimuth, azimuth, azimuth]
      well%bit = 200.0_wp + length
      well%diameter = 0.1_wp
      well%od = [0.0603_wp]
      well%id = [0.0507_wp]
      well%joint = [0.0_wp]
      well%mass = [6.9_wp]
      well%step = min(longest_step, 30.0_wp/(degree*dogleg)/steps_a_radius)
   end function tubing_well

   !> The tubing in 600 m of horizontal hole.
   pure function horizontal_well() result(well)
      type(independent_well_type) :: well
      well = tubing_well(1.0_wp)
      well%md = [0.0_wp, 600.0_wp]
      well%inclination = [90.0_wp, 90.0_wp]
      well%azimuth = [azimuth, azimuth]
      well%bit = 600.0_wp
   end function horizontal_well

   !> The case of an operation in a well, with that friction.
   pure function case_of(well, operation, friction, label) result(extreme)
      type(independent_well_type), intent(in) :: well
      integer, intent(in) :: operation
      real(wp), intent(in) :: friction     !< [-]
      character(*), intent(in) :: label
      type(extreme_case_type) :: extreme
      extreme%well = well
      extreme%operation = operation
      extreme%well%along = 0.0_wp
      extreme%well%around = 0.0_wp
      select case (operation)
      case (operation_trip_out)
         extreme%well%along = friction
         extreme%label = label//', up'
      case (operation_trip_in)
         extreme%well%along = -friction
         extreme%label = label//', down'
      case (operation_sliding_drilling)
         extreme%well%along = -friction
         extreme%label = label//', sliding'
      case (operation_rotate_off_bottom, operation_rotary_drilling)
         extreme%well%around = friction
         extreme%label = label//', rotating'
      case default
         extreme%label = label//', static'
      end select
   end function case_of

   !> Adds stations at equal distances on a bend that begins at the second station.
   pure subroutine add_stations(well, spacing, length)
      type(independent_well_type), intent(inout) :: well
      real(wp), intent(in) :: spacing, length     !< [m]
      real(wp) :: build
      real(wp), allocatable :: md(:)
      integer :: i, n
      n = nint(length/spacing)
      if (length >= well%md(3) - well%md(2)) n = n - 1
      build = (well%inclination(3) - well%inclination(2))/(well%md(3) - well%md(2))
      md = well%md(2) + spacing*[(i, i=1, n)]
      well%inclination = [well%inclination(:2), well%inclination(2) + build*(md - well%md(2)), well%inclination(3:)]
      well%azimuth = [well%azimuth(:2), spread(well%azimuth(1), 1, n), well%azimuth(3:)]
      well%md = [well%md(:2), md, well%md(3:)]
   end subroutine add_stations

   !> Load on the bit of a horizontal string in a helix beyond which no push P that pipe bears moves it [N]:
   !> dF/ds = mu c F**2/(4 EI), so 1/F(top) = 1/WOB - mu c L/(4 EI). The weight presses one side of the helix as much more as the
   !> other less. P strains the outside of the pipe by 0.5 %: P (1/EA + r c/(2 EI)), by compression and by the bending of the helix.
   pure function coil_lock_up(well, friction) result(load)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: friction     !< [-]
      real(wp) :: load, push
      push = 0.005_wp/(4.0_wp/(well%youngs*pi*(well%od(1)**2 - well%id(1)**2)) + &
                       0.5_wp*well%od(1)*clearance_of(well)/(2.0_wp*stiffness_of(well)))
      load = 1.0_wp/(taken_by_coils(well, friction) + 1.0_wp/push)
   end function coil_lock_up

   !> Relative change of the push at the top by one of the load on the bit [-], by the same formula.
   pure function coil_condition(well, friction) result(condition)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: friction     !< [-]
      real(wp) :: condition, share
      condition = 1.0_wp
      share = well%wob*taken_by_coils(well, friction)
      if (share < 1.0_wp) condition = 1.0_wp/(1.0_wp - share)
   end function coil_condition

   !> mu c L/(4 EI) [1/N].
   pure function taken_by_coils(well, friction) result(taken)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: friction     !< [-]
      real(wp) :: taken
      taken = friction*clearance_of(well)*well%bit/(4.0_wp*stiffness_of(well))
   end function taken_by_coils

   !> Of the first component on a side [m].
   pure function clearance_of(well) result(clearance)
      type(independent_well_type), intent(in) :: well
      real(wp) :: clearance
      clearance = 0.5_wp*(well%diameter - well%od(1))
   end function clearance_of

   !> Bending stiffness of the first component [N.m2].
   pure function stiffness_of(well) result(stiffness)
      type(independent_well_type), intent(in) :: well
      real(wp) :: stiffness
      stiffness = well%youngs*pi/64.0_wp*(well%od(1)**4 - well%id(1)**4)
   end function stiffness_of
end module dg_extreme_wells

!> Tortuosity added to a planned path. Drilled holes undulate where plans are smooth, and drag grows with that. The direction
!> of the plan is changed at added stations, by a sine or at random, as in planning programs.
module dg_tortuosity
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_counter_random, only: uniform_number
   use dg_trajectory, only: azimuth_of, inclination_of, position_at, tangent_of, trajectory_type
   implicit none
   private
   public :: tortuosity_type, lay_tortuosity, lower_end, turning

   !> Stations in a period of a sine. A multiple of four, so that the sine's extremes are stations.
   integer, parameter :: stations_a_period = 16
   !> Least distance of a station of the plan from an added one, over their spacing [-]. Closer stations are replaced by the
   !> added one, which is on the plan as well.
   real(wp), parameter :: near = 0.1_wp
   !> Sine of the inclination below which the azimuth is taken from an inclined part of the hole [-].
   real(wp), parameter :: vertical_sine = 1.0e-6_wp
   !> Part of a period that is round-off of two depths [-].
   real(wp), parameter :: round_off = 1.0e-9_wp

   !> One section of tortuosity.
   type :: tortuosity_type
      logical :: random = .false.         !< at random; else a sine
      real(wp) :: amplitude = 0.0_wp      !< largest change of an angle [rad]
      real(wp) :: period = 0.0_wp         !< of the sine; distance of random directions [m]
      real(wp) :: md_top = 0.0_wp         !< where it begins [m]
      real(wp) :: md_bottom = 0.0_wp      !< it ends with the last whole half period (sine) or period (random) above this [m]
      integer :: seed = 1                 !< seed of the random directions, >= 0
      integer :: number = 1               !< number of the section: sections with one seed differ
   end type tortuosity_type

contains

   !> Depth where a section ends [m]. There and at md_top the hole has the direction of its plan.
   elemental function lower_end(section) result(md)
      type(tortuosity_type), intent(in) :: section
      real(wp) :: md
      md = section%md_top + step_of(section)*number_of_steps(section)
      if (abs(md - section%md_bottom) <= round_off*section%period) md = section%md_bottom
   end function lower_end

   !> Distance of added stations [m].
   elemental function step_of(section) result(step)
      type(tortuosity_type), intent(in) :: section
      real(wp) :: step
      step = section%period
      if (.not. section%random) step = section%period/stations_a_period
   end function step_of

   !> Number of steps from md_top to the end of a section.
   elemental function number_of_steps(section) result(steps)
      type(tortuosity_type), intent(in) :: section
      integer :: steps
      real(wp) :: periods
      periods = (section%md_bottom - section%md_top)/section%period + round_off
      if (section%random) then
         steps = int(periods)
      else
         steps = int(2.0_wp*periods)*(stations_a_period/2)
      end if
   end function number_of_steps

   !> Add the stations of a section to those of a plan and change the directions there.
   !> - Sine: inclination and azimuth both change by amplitude*sin(2 pi (md - md_top)/period). In a vertical hole only the
   !>   inclination changes.
   !> - Random: each period has a new direction, up to the amplitude upwards or downwards and as much sideways, evenly
   !>   distributed. The azimuth thus changes by up to amplitude/sin(inclination). Stations of the plan between two periods are
   !>   interpolated.
   !> Stations outside the section stay.
   subroutine lay_tortuosity(plan, section, md, inclination, azimuth)
      type(trajectory_type), intent(in) :: plan              !< without tortuosity
      type(tortuosity_type), intent(in) :: section           !< within the plan, two periods long at least
      real(wp), allocatable, intent(inout) :: md(:)          !< of the stations [m]
      real(wp), allocatable, intent(inout) :: inclination(:) !< as many [rad]
      real(wp), allocatable, intent(inout) :: azimuth(:)     !< as many [rad]
      real(wp), allocatable :: new_md(:), new_inclination(:), new_azimuth(:)
      real(wp) :: step, upper, tangent(3)
      integer :: i, k, n, next
      step = step_of(section)
      n = number_of_steps(section)
      allocate (new_md(size(md) + n + 1), new_inclination(size(md) + n + 1), new_azimuth(size(md) + n + 1))
      k = 0
      next = 1
      do while (md(next) < section%md_top .and. next < size(md))
         call keep(next)
         next = next + 1
      end do
      do i = 0, n - 1
         upper = section%md_top + i*step
         call add_depth(upper)
         do while (md(next) < upper + step .and. next < size(md))
            if (md(next) > upper + near*step .and. md(next) < upper + (1.0_wp - near)*step) call add_depth(md(next))
            next = next + 1
         end do
      end do
      upper = lower_end(section)
      call add_depth(upper)
      do i = next, size(md)
         if (md(i) > upper + near*step .or. (md(i) > upper .and. i == size(md))) call keep(i)
      end do
      md = new_md(:k)
      inclination = new_inclination(:k)
      azimuth = new_azimuth(:k)

   contains

      !> Keep a station of the plan.
      subroutine keep(station)
         integer, intent(in) :: station
         k = k + 1
         new_md(k) = md(station)
         new_inclination(k) = inclination(station)
         new_azimuth(k) = azimuth(station)
      end subroutine keep

      !> Add a station with the direction of plan and tortuosity.
      subroutine add_depth(depth)
         real(wp), intent(in) :: depth
         k = k + 1
         tangent = tortuous_tangent(plan, section, depth)
         new_md(k) = depth
         new_inclination(k) = inclination_of(tangent)
         new_azimuth(k) = azimuth_of(tangent)
      end subroutine add_depth
   end subroutine lay_tortuosity

   !> Direction of the hole with its tortuosity.
   pure function tortuous_tangent(plan, section, md) result(tangent)
      type(trajectory_type), intent(in) :: plan
      type(tortuosity_type), intent(in) :: section
      real(wp), intent(in) :: md                 !< within the section [m]
      real(wp) :: tangent(3)
      real(wp) :: position(3), inclination, azimuth, change, sideways
      call position_at(plan, md, position, tangent)
      inclination = inclination_of(tangent)
      azimuth = azimuth_of(tangent)
      if (hypot(tangent(1), tangent(2)) <= vertical_sine) azimuth = azimuth_below(plan, md)
      if (section%random) then
         change = drawn(section, md, 1)
         sideways = drawn(section, md, 2)
         tangent = cos(sideways)*tangent_of(inclination + change, azimuth) + &
                   sin(sideways)*[-sin(azimuth), cos(azimuth), 0.0_wp]
      else
         change = section%amplitude*sin(2.0_wp*pi*modulo((md - section%md_top)/section%period, 1.0_wp))
         sideways = change
         if (hypot(tangent(1), tangent(2)) <= vertical_sine) sideways = 0.0_wp
         tangent = tangent_of(inclination + change, azimuth + sideways)
      end if
   end function tortuous_tangent

   !> Azimuth of a vertical hole [rad]: that of the next station that is inclined, else that of the last one.
   pure function azimuth_below(plan, md) result(azimuth)
      type(trajectory_type), intent(in) :: plan
      real(wp), intent(in) :: md     !< [m]
      real(wp) :: azimuth
      integer :: i
      do i = 1, size(plan%md) - 1
         if (plan%md(i) >= md .and. abs(sin(plan%inclination(i))) > vertical_sine) exit
      end do
      azimuth = plan%azimuth(i)
   end function azimuth_below

   !> Random angle at a depth [rad], between the two angles above and below it; 0 at both ends of the section.
   pure function drawn(section, md, direction) result(angle)
      type(tortuosity_type), intent(in) :: section
      real(wp), intent(in) :: md          !< [m]
      integer, intent(in) :: direction    !< 1: up or down, 2: sideways
      real(wp) :: angle
      real(wp) :: place
      integer :: above
      place = (md - section%md_top)/section%period
      above = int(place + round_off)
      angle = at(above) + max(place - above, 0.0_wp)*(at(above + 1) - at(above))

   contains
      pure function at(index) result(value)
         integer, intent(in) :: index
         real(wp) :: value
         value = 0.0_wp
         if (index <= 0 .or. index >= number_of_steps(section)) return
         value = section%amplitude*(2.0_wp*uniform_number(section%seed, section%number, direction, index) - 1.0_wp)
      end function at
   end function drawn

   !> Angle by which a path turns between two depths, in any direction [rad].
   pure function turning(path, md_top, md_bottom) result(angle)
      type(trajectory_type), intent(in) :: path
      real(wp), intent(in) :: md_top, md_bottom   !< [m]
      real(wp) :: angle
      integer :: i
      angle = 0.0_wp
      do i = 1, size(path%arcs)
         associate (arc => path%arcs(i))
            angle = angle + arc%curvature*max(min(arc%md + arc%length, md_bottom) - max(arc%md, md_top), 0.0_wp)
         end associate
      end do
   end function turning
end module dg_tortuosity

!> Wells as they are drilled, drawn at random from a seed: standard plans with the noise of surveys and the tortuosity of motors,
!> cased and open hole, drill strings of five sizes with their assemblies, casing, liners, tubing, coiled tubing and sucker rods,
!> each in the operations it is used for, friction 0.05 to 0.6, weight on bit up to buckling. Sizes are those of API tables.
module dg_drilled_well
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_component, only: component_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_backream, operation_ream, operation_rotary_drilling, operation_rotate_off_bottom, &
      operation_sliding_drilling, operation_static, operation_trip_in, operation_trip_out
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_random_well, only: begin_draws, draw, stations_type
   use dg_trajectory, only: azimuth_of, inclination_of, interpolation_minimum_curvature, new_trajectory, position_at, &
      trajectory_type
   implicit none
   private
   public :: draw_drilled_well, plan_count, plan_name, string_count, string_name

   integer, parameter :: vertical = 1, build_and_hold = 2, s_shaped = 3, horizontal = 4, short_radius = 5, winding = 6, &
                         extended_reach = 7, plan_count = 7
   character(*), parameter :: plan_name(plan_count) = [character(14) :: 'vertical', 'build and hold', 's-shaped', 'horizontal', &
      'short radius', 'winding', 'extended reach']
   !> Share of each plan among drilled wells [-].
   real(wp), parameter :: plan_share(plan_count) = [0.12_wp, 0.20_wp, 0.13_wp, 0.25_wp, 0.08_wp, 0.12_wp, 0.10_wp]

   integer, parameter :: drill_string = 1, casing = 2, liner = 3, tubing = 4, coiled_tubing = 5, rods = 6, string_count = 6
   character(*), parameter :: string_name(string_count) = [character(13) :: 'drill string', 'casing', 'liner', 'tubing', &
      'coiled tubing', 'rods']
   real(wp), parameter :: string_share(string_count) = [0.66_wp, 0.08_wp, 0.07_wp, 0.07_wp, 0.08_wp, 0.04_wp]

   integer, parameter :: slick = 1, packed = 2, pendulum = 3, motor = 4, no_collars = 5
   real(wp), parameter :: assembly_share(5) = [0.15_wp, 0.25_wp, 0.15_wp, 0.30_wp, 0.15_wp]

   ! Drill pipe of 5 7/8, 5, 4, 3 1/2 and 2 7/8 in with what goes with it [m, kg/m, N, m].
   integer, parameter :: sizes = 5
   real(wp), parameter :: size_share(sizes) = [0.15_wp, 0.40_wp, 0.17_wp, 0.18_wp, 0.10_wp]
   real(wp), parameter :: pipe_od(sizes) = [0.1492_wp, 0.127_wp, 0.1016_wp, 0.0889_wp, 0.073_wp]
   real(wp), parameter :: pipe_id(sizes) = [0.1318_wp, 0.1086_wp, 0.0848_wp, 0.0702_wp, 0.0546_wp]
   real(wp), parameter :: pipe_mass(sizes) = [38.9_wp, 31.1_wp, 22.9_wp, 20.7_wp, 16.2_wp]
   real(wp), parameter :: joint_od(sizes) = [0.1778_wp, 0.1683_wp, 0.1334_wp, 0.1207_wp, 0.1048_wp]
   real(wp), parameter :: heavy_id(sizes) = [0.1016_wp, 0.0762_wp, 0.0651_wp, 0.0524_wp, 0.0460_wp]
   real(wp), parameter :: heavy_mass(sizes) = [85.0_wp, 73.4_wp, 44.2_wp, 37.7_wp, 25.0_wp]
   real(wp), parameter :: collar_od(sizes) = [0.2032_wp, 0.1651_wp, 0.1207_wp, 0.1207_wp, 0.0889_wp]
   real(wp), parameter :: collar_id(sizes) = [0.0714_wp, 0.0714_wp, 0.0572_wp, 0.0572_wp, 0.0381_wp]
   real(wp), parameter :: collar_mass(sizes) = [223.0_wp, 136.0_wp, 69.7_wp, 69.7_wp, 39.8_wp]
   real(wp), parameter :: bit(sizes) = [0.3112_wp, 0.2159_wp, 0.1556_wp, 0.1524_wp, 0.1143_wp]
   real(wp), parameter :: cased(sizes) = [0.3153_wp, 0.2205_wp, 0.1594_wp, 0.1594_wp, 0.1243_wp]
   real(wp), parameter :: cased_above(sizes) = [0.4826_wp, 0.3153_wp, 0.2205_wp, 0.2205_wp, 0.1746_wp]
   real(wp), parameter :: most_on_bit(sizes) = [2.5e5_wp, 2.0e5_wp, 1.2e5_wp, 1.0e5_wp, 5.0e4_wp]
   !> Torque of a bit over its weight times its diameter [-]: a tenth (rock bits) to a third (fixed cutters).
   real(wp), parameter :: least_bite = 0.1_wp, more_bite = 0.23_wp

   !> Casing that is run, with the hole and the casing before it: 9 5/8, 7 and 4 1/2 in.
   integer, parameter :: casings = 3
   real(wp), parameter :: run_od(casings) = [0.2445_wp, 0.1778_wp, 0.1143_wp], run_id(casings) = [0.2205_wp, 0.1594_wp, 0.1016_wp]
   real(wp), parameter :: run_mass(casings) = [69.9_wp, 43.2_wp, 17.3_wp], run_hole(casings) = [0.3112_wp, 0.2159_wp, 0.1556_wp]
   real(wp), parameter :: run_cased(casings) = [0.3153_wp, 0.2205_wp, 0.1594_wp], run_most(casings) = [1.0e5_wp, 8.0e4_wp, 4.0e4_wp]
   integer, parameter :: run_above(casings) = [1, 2, 3]      ! drill pipe that runs it as a liner

   !> Coiled tubing of 1 1/2, 2 and 2 3/8 in.
   real(wp), parameter :: coil_od(3) = [0.0381_wp, 0.0508_wp, 0.0603_wp], coil_id(3) = [0.0318_wp, 0.0429_wp, 0.0516_wp]
   real(wp), parameter :: steel = 7850.0_wp

   real(wp), parameter :: muds(5) = [0.0_wp, 1000.0_wp, 1150.0_wp, 1350.0_wp, 1700.0_wp]   ! kg/m3
   !> Most stations of a survey: long ones have longer courses.
   integer, parameter :: most_stations = 600

contains

   !> The well of a seed: survey, and a model with one string and one load case that has no trajectory yet.
   subroutine draw_drilled_well(seed, stations, model, plan, string)
      integer, intent(in) :: seed
      type(stations_type), intent(out) :: stations
      type(model_type), intent(out) :: model
      integer, intent(out) :: plan, string       !< numbers of their names
      integer(int64) :: state
      call begin_draws(seed, state)
      plan = pick(state, plan_share)
      call draw_plan(state, plan, stations)
      if (draw(state) > 0.25_wp) call survey_plan(state, stations)
      allocate (model%strings(1), model%cases(1))
      model%strings(1)%name = 'main'
      associate (load => model%cases(1))
         load%name = 'case'
         load%section = ''
         load%string = 'main'
         load%bit_depth = stations%md(size(stations%md))
         if (draw(state) < 0.15_wp) load%bit_depth = between(state, 0.6_wp, 1.0_wp)*load%bit_depth
         load%angular_speed = between(state, 20.0_wp, 180.0_wp)*2.0_wp*pi/60.0_wp
         load%trip_speed = between(state, 0.01_wp, 0.6_wp)
      end associate
      string = pick(state, string_share)
      if (plan == short_radius .and. any(string == [casing, liner])) string = drill_string
      select case (string)
      case (drill_string); call draw_drill_string(state, plan, stations, model)
      case (casing, liner); call draw_casing(state, string, stations, model)
      case (coiled_tubing); call draw_coiled_tubing(state, stations, model)
      case default; call draw_production_string(state, string, stations, model)
      end select
      call fit_lengths(model)
      model%mud = standing_mud(muds(1 + int(size(muds)*draw(state))))
      model%boundary%top_centred = draw(state) > 0.25_wp
      model%boundary%bit_centred = draw(state) > 0.5_wp
      model%numerics = settings_of('auto')
      if (draw(state) < 0.2_wp) model%numerics = settings_of('standard')
   end subroutine draw_drilled_well

   !> Plans of straight courses and arcs, in a direction at random.
   subroutine draw_plan(state, plan, stations)
      integer(int64), intent(inout) :: state
      integer, intent(in) :: plan
      type(stations_type), intent(out) :: stations
      real(wp) :: direction, kickoff, steepness, angle, landing, drop
      integer :: i
      direction = 360.0_wp*draw(state)
      stations%md = [0.0_wp]
      stations%inclination = [0.0_wp]
      stations%azimuth = [direction]
      kickoff = between(state, 100.0_wp, 1800.0_wp)
      select case (plan)
      case (vertical)
         call go(between(state, 300.0_wp, 5000.0_wp), 2.0_wp*draw(state), direction)
      case (build_and_hold)
         angle = between(state, 10.0_wp, 80.0_wp)
         call go(kickoff, 0.0_wp, direction)
         call go(30.0_wp*angle/between(state, 1.0_wp, 5.0_wp), angle, direction)
         call go(between(state, 300.0_wp, 3500.0_wp), angle, direction + between(state, -15.0_wp, 15.0_wp))
      case (s_shaped)
         angle = between(state, 15.0_wp, 60.0_wp)
         drop = angle*draw(state)**2
         call go(0.6_wp*kickoff, 0.0_wp, direction)
         call go(30.0_wp*angle/between(state, 1.5_wp, 5.0_wp), angle, direction)
         call go(between(state, 150.0_wp, 1500.0_wp), angle, direction)
         call go(30.0_wp*(angle - drop)/between(state, 1.0_wp, 4.0_wp) + 10.0_wp, drop, direction)
         call go(between(state, 100.0_wp, 1500.0_wp), drop, direction)
      case (horizontal)
         landing = between(state, 84.0_wp, 98.0_wp)
         steepness = between(state, 2.0_wp, 15.0_wp)
         call go(kickoff, 0.0_wp, direction)
         call go(30.0_wp*landing/steepness, landing, direction)
         angle = 0.0_wp
         if (draw(state) < 0.4_wp) angle = between(state, -80.0_wp, 80.0_wp)
         call go(100.0_wp + 30.0_wp*abs(angle)/between(state, 2.0_wp, 5.0_wp), landing, direction + angle)
         call go(between(state, 200.0_wp, 2500.0_wp), landing, direction + angle)
      case (short_radius)
         landing = between(state, 80.0_wp, 95.0_wp)
         call go(kickoff, 0.0_wp, direction)
         call go(30.0_wp*landing/between(state, 25.0_wp, 75.0_wp), landing, direction)
         call go(between(state, 50.0_wp, 400.0_wp), landing, direction + between(state, -10.0_wp, 10.0_wp))
      case (winding)
         angle = 0.0_wp
         call go(0.5_wp*kickoff, angle, direction)
         do i = 1, 4 + int(5.0_wp*draw(state))
            angle = min(95.0_wp, max(0.0_wp, angle + between(state, -20.0_wp, 35.0_wp)))
            direction = direction + between(state, -40.0_wp, 40.0_wp)
            call go(between(state, 200.0_wp, 700.0_wp), angle, direction)
         end do
      case default
         angle = between(state, 70.0_wp, 86.0_wp)
         call go(0.5_wp*kickoff, 0.0_wp, direction)
         call go(30.0_wp*angle/between(state, 1.5_wp, 3.0_wp), angle, direction)
         call go(between(state, 4000.0_wp, 9000.0_wp), angle, direction + between(state, -25.0_wp, 25.0_wp))
         if (draw(state) < 0.5_wp) call go(500.0_wp, 90.0_wp, stations%azimuth(size(stations%azimuth)))
      end select

   contains

      !> A course to the next station.
      subroutine go(length, inclination, azimuth)
         real(wp), intent(in) :: length, inclination, azimuth   !< [m], [deg], [deg]
         stations%md = [stations%md, stations%md(size(stations%md)) + length]
         stations%inclination = [stations%inclination, inclination]
         stations%azimuth = [stations%azimuth, modulo(azimuth, 360.0_wp)]
      end subroutine go
   end subroutine draw_plan

   !> The plan as it was surveyed: stations every stand or less, off by the noise of the tool and by what a motor leaves behind.
   subroutine survey_plan(state, stations)
      integer(int64), intent(inout) :: state
      type(stations_type), intent(inout) :: stations
      type(trajectory_type) :: planned
      type(error_type), allocatable :: error
      type(stations_type) :: seen
      real(wp), parameter :: courses(5) = [9.5_wp, 15.0_wp, 19.0_wp, 28.5_wp, 30.0_wp]   ! m
      real(wp), parameter :: flattest = 0.3_wp   ! sine of the inclination below which azimuths are not off any more
      real(wp) :: course, noise, wave, amplitude, phase, position(3), tangent(3), along
      integer :: i, n
      call new_trajectory(planned, stations%md, stations%inclination*degree, stations%azimuth*degree, &
                          interpolation_minimum_curvature, error)
      if (allocated(error)) error stop 'a plan that makes no path'
      along = stations%md(size(stations%md))
      course = max(courses(1 + int(size(courses)*draw(state))), along/most_stations)
      n = ceiling(along/course) + 1
      noise = 0.0_wp
      if (draw(state) < 0.7_wp) noise = between(state, 0.05_wp, 0.3_wp)
      amplitude = 0.0_wp
      if (draw(state) < 0.5_wp) amplitude = between(state, 0.1_wp, 1.0_wp)
      wave = max(between(state, 60.0_wp, 250.0_wp), 4.0_wp*course)
      phase = 2.0_wp*pi*draw(state)
      allocate (seen%md(n), seen%inclination(n), seen%azimuth(n))
      do i = 1, n
         seen%md(i) = along*(i - 1)/(n - 1)
         call position_at(planned, seen%md(i), position, tangent)
         associate (inclination => seen%inclination(i), azimuth => seen%azimuth(i))
            inclination = inclination_of(tangent)/degree
            azimuth = stations%azimuth(1)
            if (inclination > 0.01_wp) azimuth = azimuth_of(tangent)/degree
            if (i == 1) cycle
            azimuth = azimuth + (noise*normal(state) + amplitude*cos(2.0_wp*pi*seen%md(i)/wave + phase))/ &
                      max(flattest, sin(inclination*degree))
            inclination = inclination + noise*normal(state) + amplitude*sin(2.0_wp*pi*seen%md(i)/wave + phase)
            if (inclination < 0.0_wp) azimuth = azimuth + 180.0_wp
            inclination = abs(inclination)
            azimuth = modulo(azimuth, 360.0_wp)
         end associate
      end do
      stations = seen
   end subroutine survey_plan

   !> Drill pipe on heavy-weight on an assembly, tapered in one of ten, in cased and open hole.
   subroutine draw_drill_string(state, plan, stations, model)
      integer(int64), intent(inout) :: state
      integer, intent(in) :: plan
      type(stations_type), intent(in) :: stations
      type(model_type), intent(inout) :: model
      real(wp), parameter :: operation_share(8) = [0.15_wp, 0.15_wp, 0.08_wp, 0.24_wp, 0.20_wp, 0.06_wp, 0.06_wp, 0.06_wp]
      integer, parameter :: operations(8) = [operation_trip_out, operation_trip_in, operation_rotate_off_bottom, &
         operation_rotary_drilling, operation_sliding_drilling, operation_ream, operation_backream, operation_static]
      real(wp) :: length
      integer :: k, assembly
      k = pick(state, size_share)
      assembly = pick(state, assembly_share)
      if (plan == short_radius) then
         k = max(k, 4)
         assembly = merge(motor, no_collars, draw(state) < 0.5_wp)
      end if
      allocate (model%strings(1)%components(0))
      select case (assembly)
      case (slick)
         call collars(between(state, 20.0_wp, 180.0_wp))
      case (packed)
         call blades()
         call collars(between(state, 1.0_wp, 5.0_wp))
         call blades()
         call collars(9.1_wp)
         call blades()
         call collars(between(state, 20.0_wp, 120.0_wp))
      case (pendulum)
         call collars(between(state, 9.0_wp, 28.0_wp))
         call blades()
         call collars(between(state, 30.0_wp, 120.0_wp))
      case (motor)
         call add(model, 'motor', 'motor', 8.0_wp, collar_od(k), collar_id(k), 0.8_wp*collar_mass(k))
         if (draw(state) < 0.7_wp) call blades()
         call add(model, 'mwd', 'mwd', between(state, 9.0_wp, 18.0_wp), collar_od(k), collar_id(k), 0.85_wp*collar_mass(k))
         if (draw(state) < 0.4_wp) call collars(between(state, 9.0_wp, 30.0_wp))
      case default
         call add(model, 'motor', 'motor', 7.0_wp, collar_od(k), collar_id(k), 0.8_wp*collar_mass(k))
      end select
      call add(model, 'heavy-weight', 'hwdp', between(state, 25.0_wp, 280.0_wp), pipe_od(k), heavy_id(k), heavy_mass(k), &
               joint_od(k))
      length = 0.0_wp
      if (k > 1 .and. draw(state) < 0.1_wp) length = between(state, 0.2_wp, 0.6_wp)*model%cases(1)%bit_depth
      call add(model, 'pipe', 'drillpipe', length, pipe_od(k), pipe_id(k), pipe_mass(k), joint_od(k))
      if (length > 0.0_wp) call add(model, 'larger pipe', 'drillpipe', 0.0_wp, pipe_od(k - 1), pipe_id(k - 1), pipe_mass(k - 1), &
                                    joint_od(k - 1))
      if (length > 0.0_wp) then      ! the larger pipe stays in the casing that it fits
         call lay_sections(state, stations, model, max(cased(k), cased(k - 1)), max(cased(k), cased(k - 1)), cased_above(k - 1))
      else
         call lay_sections(state, stations, model, bit(k), cased(k), cased_above(k))
      end if
      associate (load => model%cases(1))
         load%operation = operations(pick(state, operation_share))
         select case (load%operation)
         case (operation_rotary_drilling, operation_sliding_drilling, operation_static)
            load%wob = most_on_bit(k)*draw(state)**1.3_wp
            if (load%operation /= operation_static) load%tob = load%wob*bit(k)*(least_bite + more_bite*draw(state))
         case (operation_trip_out)
            if (draw(state) < 0.1_wp) load%wob = -between(state, 0.0_wp, 1.0e5_wp)      ! overpull
         case default
            if (draw(state) < 0.3_wp) load%tob = between(state, 0.0_wp, 2.0e3_wp)
            if (load%operation == operation_trip_in) load%tob = 0.0_wp
         end select
      end associate

   contains

      subroutine collars(length)
         real(wp), intent(in) :: length   !< [m]
         call add(model, 'collar', 'collar', length, collar_od(k), collar_id(k), collar_mass(k))
      end subroutine collars

      !> A stabilizer, full gauge or worn.
      subroutine blades()
         real(wp), parameter :: under(4) = [0.8e-3_wp, 1.6e-3_wp, 3.2e-3_wp, 6.4e-3_wp]   ! m
         call add(model, 'blades', 'stabilizer', between(state, 1.2_wp, 2.0_wp), collar_od(k), collar_id(k), &
                  1.1_wp*collar_mass(k), bit(k) - 2.0_wp*under(1 + int(size(under)*draw(state))))
      end subroutine blades
   end subroutine draw_drill_string

   !> Casing to surface, or a liner on drill pipe; with centralizers in half of them.
   subroutine draw_casing(state, string, stations, model)
      integer(int64), intent(inout) :: state
      integer, intent(in) :: string
      type(stations_type), intent(in) :: stations
      type(model_type), intent(inout) :: model
      integer, parameter :: operations(4) = [operation_trip_in, operation_trip_out, operation_rotate_off_bottom, operation_ream]
      real(wp) :: outer
      integer :: k
      k = 1 + int(casings*draw(state))
      allocate (model%strings(1)%components(0))
      outer = merge(1.08_wp*run_od(k), 0.0_wp, draw(state) < 0.5_wp)
      if (string == liner) then
         call add(model, 'liner', 'casing', between(state, 0.1_wp, 0.5_wp)*model%cases(1)%bit_depth, run_od(k), run_id(k), &
                  run_mass(k), outer)
         call add(model, 'pipe', 'drillpipe', 0.0_wp, pipe_od(run_above(k)), pipe_id(run_above(k)), pipe_mass(run_above(k)), &
                  joint_od(run_above(k)))
      else
         call add(model, 'casing', 'casing', 0.0_wp, run_od(k), run_id(k), run_mass(k), outer)
      end if
      call lay_sections(state, stations, model, run_hole(k), run_cased(k), run_cased(k))
      model%cases(1)%operation = operations(pick(state, [0.6_wp, 0.15_wp, 0.15_wp, 0.1_wp]))
      if (model%cases(1)%operation == operation_trip_in .and. draw(state) < 0.3_wp) &
         model%cases(1)%wob = run_most(k)*draw(state)            ! it stands on a ledge
   end subroutine draw_casing

   !> Coiled tubing with a tool or without, through tubing and beyond it.
   subroutine draw_coiled_tubing(state, stations, model)
      integer(int64), intent(inout) :: state
      type(stations_type), intent(in) :: stations
      type(model_type), intent(inout) :: model
      real(wp), parameter :: through(3) = [0.076_wp, 0.0996_wp, 0.124_wp]
      integer, parameter :: operations(4) = [operation_trip_in, operation_trip_out, operation_sliding_drilling, operation_static]
      integer :: k
      k = 1 + int(3.0_wp*draw(state))
      allocate (model%strings(1)%components(0))
      if (draw(state) < 0.7_wp) &
         call add(model, 'tool', 'motor', between(state, 3.0_wp, 12.0_wp), 1.15_wp*coil_od(k), 0.025_wp, 14.0_wp)
      call add(model, 'coil', 'coiled tubing', 0.0_wp, coil_od(k), coil_id(k), 0.25_wp*pi*(coil_od(k)**2 - coil_id(k)**2)*steel)
      call lay_sections(state, stations, model, 0.1143_wp, through(1 + int(3.0_wp*draw(state))), 0.124_wp)
      associate (load => model%cases(1))
         load%operation = operations(pick(state, [0.35_wp, 0.25_wp, 0.25_wp, 0.15_wp]))
         if (load%operation /= operation_trip_out) load%wob = 1.2e4_wp*draw(state)**2
         if (load%operation == operation_sliding_drilling) load%tob = 300.0_wp*draw(state)
      end associate
   end subroutine draw_coiled_tubing

   !> Tubing in casing, or sucker rods in tubing.
   subroutine draw_production_string(state, string, stations, model)
      integer(int64), intent(inout) :: state
      integer, intent(in) :: string
      type(stations_type), intent(in) :: stations
      type(model_type), intent(inout) :: model
      integer, parameter :: operations(3) = [operation_trip_in, operation_trip_out, operation_static]
      real(wp) :: inside
      allocate (model%strings(1)%components(0))
      model%cases(1)%operation = operations(1 + int(3.0_wp*draw(state)))
      if (string == rods) then
         call add(model, 'sinker bar', 'rod', min(120.0_wp, 0.2_wp*model%cases(1)%bit_depth), 0.0381_wp, 0.0_wp, 8.9_wp)
         call add(model, 'rod 7/8', 'rod', 0.5_wp*model%cases(1)%bit_depth, 0.0222_wp, 0.0_wp, 3.3_wp, 0.046_wp)
         call add(model, 'rod 1', 'rod', 0.0_wp, 0.0254_wp, 0.0_wp, 4.3_wp, 0.051_wp)
         inside = merge(0.062_wp, 0.076_wp, draw(state) < 0.5_wp)
         model%cases(1)%wob = -2.0e4_wp*draw(state)             ! the pump's load
      else
         call add(model, 'tubing', 'tubing', 0.0_wp, 0.073_wp, 0.062_wp, 9.7_wp, merge(0.0889_wp, 0.0_wp, draw(state) < 0.5_wp))
         inside = merge(0.1243_wp, 0.1594_wp, draw(state) < 0.5_wp)
         if (model%cases(1)%operation /= operation_trip_out) model%cases(1)%wob = 5.0e4_wp*draw(state)**2   ! set down on a packer
      end if
      call lay_sections(state, stations, model, inside, inside, inside)
   end subroutine draw_production_string

   !> Casing, perhaps of two diameters, to a shoe, and open hole below it, as drilled or washed out.
   subroutine lay_sections(state, stations, model, open, inside, inside_above)
      integer(int64), intent(inout) :: state
      type(stations_type), intent(in) :: stations
      type(model_type), intent(inout) :: model
      real(wp), intent(in) :: open, inside, inside_above   !< diameters of the open hole and of both casings [m]
      real(wp), parameter :: washed(5) = [1.0_wp, 1.0_wp, 1.0_wp, 1.03_wp, 1.1_wp]
      real(wp) :: shoe, hanger, bottom, cased_friction, open_friction
      bottom = stations%md(size(stations%md))
      shoe = between(state, 0.2_wp, 0.85_wp)*bottom
      hanger = between(state, 0.3_wp, 0.7_wp)*shoe
      cased_friction = between(state, 0.05_wp, 0.35_wp)
      open_friction = min(0.6_wp, cased_friction + between(state, 0.0_wp, 0.3_wp))
      if (draw(state) < 0.35_wp) then
         allocate (model%holes(3))
         model%holes(1) = hole_section_type('casing', 0.0_wp, hanger, inside_above, cased_friction, cased_friction)
         model%holes(2) = hole_section_type('liner', hanger, shoe, inside, cased_friction, cased_friction)
      else
         allocate (model%holes(2))
         model%holes(1) = hole_section_type('casing', 0.0_wp, shoe, inside, cased_friction, cased_friction)
      end if
      model%holes(size(model%holes)) = hole_section_type('open', shoe, bottom, open*washed(1 + int(5.0_wp*draw(state))), &
                                                         open_friction, open_friction)
   end subroutine lay_sections

   !> The next component from the bit upwards.
   subroutine add(model, name, kind, length, od, id, mass, joint)
      type(model_type), intent(inout) :: model
      character(*), intent(in) :: name, kind
      real(wp), intent(in) :: length, od, id, mass      !< [m], [m], [m], [kg/m]
      real(wp), intent(in), optional :: joint           !< [m]
      type(component_type), allocatable :: parts(:)
      integer :: n
      n = size(model%strings(1)%components)
      allocate (parts(n + 1))
      parts(:n) = model%strings(1)%components
      associate (part => parts(n + 1))
         part%name = name
         part%kind = kind
         part%length = length
         part%od = od
         part%id = id
         part%mass = mass
         if (present(joint)) part%joint_od = joint
      end associate
      call move_alloc(parts, model%strings(1)%components)
   end subroutine add

   !> Shortens all but the uppermost component where they do not fit into the well.
   subroutine fit_lengths(model)
      type(model_type), intent(inout) :: model
      real(wp), parameter :: most = 0.85_wp
      real(wp) :: below
      integer :: n
      n = size(model%strings(1)%components)
      if (n == 1) return
      associate (parts => model%strings(1)%components)
         below = sum(parts(:n - 1)%length)
         if (below > most*model%cases(1)%bit_depth) parts(:n - 1)%length = parts(:n - 1)%length*most*model%cases(1)%bit_depth/below
      end associate
   end subroutine fit_lengths

   !> A number between two.
   function between(state, least, most) result(number)
      integer(int64), intent(inout) :: state
      real(wp), intent(in) :: least, most
      real(wp) :: number
      number = least + (most - least)*draw(state)
   end function between

   !> One of several by their shares, which sum up to 1.
   function pick(state, shares) result(one)
      integer(int64), intent(inout) :: state
      real(wp), intent(in) :: shares(:)
      integer :: one
      real(wp) :: left
      left = draw(state)
      do one = 1, size(shares) - 1
         left = left - shares(one)
         if (left < 0.0_wp) return
      end do
      one = size(shares)
   end function pick

   !> Very nearly normal, of deviation 1: twelve uniform numbers.
   function normal(state) result(number)
      integer(int64), intent(inout) :: state
      real(wp) :: number
      integer :: i
      number = -6.0_wp
      do i = 1, 12
         number = number + draw(state)
      end do
   end function normal
end module dg_drilled_well

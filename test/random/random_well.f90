!> Wells drawn at random from a seed: surveys that build, drop and turn, strings of many kinds, operations and loads. The same
!> seed gives the same well with every compiler.
module dg_random_well
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_component, only: component_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_type
   use dg_fluid, only: standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_count, operation_rotary_drilling, operation_sliding_drilling, operation_static
   use dg_model, only: model_type
   use dg_numerics, only: gap_at_extremum, gap_at_nodes
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory
   implicit none
   private
   public :: stations_type, begin_draws, draw, draw_well, lay_path, split_component

   !> A survey, angles in degrees.
   type :: stations_type
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
   end type stations_type

   ! The minimal standard generator of Park & Miller (1988), with the multiplier that they recommend now.
   integer(int64), parameter :: multiplier = 48271_int64, modulus = 2147483647_int64
   !> Draws thrown away first: seeds that are neighbours begin alike.
   integer, parameter :: warm_up = 20

   ! Ranges.
   integer, parameter :: fewest_stations = 4, more_stations = 5
   real(wp), parameter :: shortest_course = 30.0_wp, longer_course = 300.0_wp    ! m
   real(wp), parameter :: mildest = 0.5_wp, sharper = 30.0_wp                   ! deg/30 m, and times
   real(wp), parameter :: largest_turn = 80.0_wp, steepest = 105.0_wp           ! deg
   real(wp), parameter :: shortest_element = 4.0_wp, longest_element = 30.0_wp  ! m
   real(wp), parameter :: largest_wob = 1.0e5_wp, largest_tob = 5.0e3_wp        ! N, N.m
   real(wp), parameter :: tubing_share = 0.05_wp                                ! of these, for coiled tubing

contains

   !> The well of a seed: survey, and a model with one string and one load case that has no trajectory yet.
   subroutine draw_well(seed, stations, model)
      integer, intent(in) :: seed
      type(stations_type), intent(out) :: stations
      type(model_type), intent(out) :: model
      integer(int64) :: state
      call begin_draws(seed, state)
      call draw_stations(state, stations)
      call draw_string(state, model)
      allocate (model%holes(1), model%cases(1))
      model%holes(1) = hole_section_type('hole', 0.0_wp, stations%md(size(stations%md)), 0.2159_wp, 0.0_wp, 0.0_wp)
      model%holes(1)%friction_axial = 0.5_wp*draw(state)
      model%holes(1)%friction_rotary = model%holes(1)%friction_axial
      if (size(model%strings(1)%components) == 1) model%holes(1)%diameter = 0.15_wp
      model%mud = standing_mud(1200.0_wp)
      model%boundary%top_centred = draw(state) > 0.3_wp
      model%boundary%bit_centred = draw(state) > 0.3_wp
      model%numerics%element_length = shortest_element*(longest_element/shortest_element)**draw(state)
      model%numerics%gap_location = merge(gap_at_extremum, gap_at_nodes, draw(state) > 0.5_wp)
      associate (case => model%cases(1))
         case%name = 'case'
         case%section = ''
         case%string = 'main'
         case%bit_depth = stations%md(size(stations%md))
         case%operation = 1 + int(operation_count*draw(state))
         case%angular_speed = 0.1_wp + 10.0_wp*draw(state)
         case%trip_speed = 0.01_wp + draw(state)
         case%wob = largest_wob*draw(state)
         case%tob = largest_tob*draw(state)
         if (size(model%strings(1)%components) == 1) then
            case%wob = tubing_share*case%wob
            case%tob = tubing_share*case%tob
         end if
         if (all(case%operation /= [operation_rotary_drilling, operation_sliding_drilling, operation_static])) then
            case%wob = 0.0_wp
            case%tob = 0.0_wp
         end if
      end associate
   end subroutine draw_well

   !> The generator's state where the draws of a seed begin.
   subroutine begin_draws(seed, state)
      integer, intent(in) :: seed
      integer(int64), intent(out) :: state
      integer :: i
      real(wp) :: waste
      state = 1_int64 + modulo(int(seed, int64)*7919_int64, modulus - 1_int64)
      do i = 1, warm_up
         waste = draw(state)
      end do
      if (waste > 1.0_wp) state = 1_int64      ! never: keeps the draws
   end subroutine begin_draws

   !> A path of straight courses and arcs; dogleg log-uniform, direction at random.
   subroutine draw_stations(state, stations)
      integer(int64), intent(inout) :: state
      type(stations_type), intent(out) :: stations
      real(wp) :: turn, way
      integer :: i, n
      n = fewest_stations + int(more_stations*draw(state))
      allocate (stations%md(n), stations%inclination(n), stations%azimuth(n), source=0.0_wp)
      stations%azimuth = 360.0_wp*draw(state)
      if (draw(state) > 0.7_wp) stations%inclination(1) = 60.0_wp*draw(state)
      do i = 2, n
         associate (course => stations%md(i), before => stations%md(i - 1))
            course = before + shortest_course + longer_course*draw(state)
            turn = mildest*sharper**(draw(state)**1.5_wp)*(course - before)/30.0_wp
         end associate
         if (draw(state) < 0.25_wp) turn = 0.0_wp
         turn = min(turn, largest_turn)
         way = 2.0_wp*pi*draw(state)
         stations%inclination(i) = abs(stations%inclination(i - 1) + turn*cos(way))
         if (stations%inclination(i) > steepest) stations%inclination(i) = 2.0_wp*steepest - stations%inclination(i)
         stations%azimuth(i) = modulo(stations%azimuth(i - 1) + turn*sin(way)/ &
                                      max(0.3_wp, sin(stations%inclination(i)*degree)), 360.0_wp)
      end do
   end subroutine draw_stations

   !> Coiled tubing; thin tubing on collars, a jump in stiffness; or collars, heavy-weight and drill pipe.
   subroutine draw_string(state, model)
      integer(int64), intent(inout) :: state
      type(model_type), intent(inout) :: model
      allocate (model%strings(1))
      model%strings(1)%name = 'main'
      select case (int(4.0_wp*draw(state)))
      case (0)
         allocate (model%strings(1)%components(1))
         call set_part(1, 'coiled tubing', 0.0_wp, 0.0508_wp, 0.0429_wp, 4.6_wp, 0.0_wp)
      case (1)
         allocate (model%strings(1)%components(2))
         call set_part(1, 'collar', 10.0_wp + 120.0_wp*draw(state), 0.1651_wp, 0.0714_wp, 136.0_wp, 0.0_wp)
         call set_part(2, 'tubing', 0.0_wp, 0.073_wp, 0.0548_wp, 15.5_wp, 0.0_wp)
      case default
         allocate (model%strings(1)%components(3))
         call set_part(1, 'collar', 5.0_wp + 100.0_wp*draw(state), 0.1651_wp, 0.0714_wp, 136.0_wp, 0.0_wp)
         call set_part(2, 'heavy-weight', 5.0_wp + 100.0_wp*draw(state), 0.127_wp, 0.0762_wp, 73.4_wp, 0.165_wp)
         call set_part(3, 'drill pipe', 0.0_wp, 0.127_wp, 0.1086_wp, 33.1_wp, 0.168_wp)
      end select
   contains
      subroutine set_part(i, name, length, od, id, mass, joint_od)
         integer, intent(in) :: i
         character(*), intent(in) :: name
         real(wp), intent(in) :: length, od, id, mass, joint_od   !< [m], [m], [m], [kg/m], [m]
         associate (part => model%strings(1)%components(i))
            part%name = name
            part%kind = 'drillpipe'
            part%length = length
            part%od = od
            part%id = id
            part%mass = mass
            part%joint_od = joint_od
         end associate
      end subroutine set_part
   end subroutine draw_string

   !> Gives a model the path of a survey.
   subroutine lay_path(stations, model)
      type(stations_type), intent(in) :: stations
      type(model_type), intent(inout) :: model
      type(error_type), allocatable :: error
      call new_trajectory(model%trajectory, stations%md, stations%inclination*degree, stations%azimuth*degree, &
                          interpolation_minimum_curvature, error)
      if (allocated(error)) error stop 'a random survey that makes no path'
   end subroutine lay_path

   !> The same string with its uppermost component, the one that reaches to surface, in two parts of the same pipe.
   subroutine split_component(length, model)
      real(wp), intent(in) :: length           !< of the lower part [m]
      type(model_type), intent(inout) :: model
      type(component_type), allocatable :: parts(:)
      integer :: n
      n = size(model%strings(1)%components)
      allocate (parts(n + 1))
      parts(:n) = model%strings(1)%components
      parts(n)%length = length
      parts(n + 1) = model%strings(1)%components(n)
      call move_alloc(parts, model%strings(1)%components)
   end subroutine split_component

   !> The next number of the generator, above 0 and below 1.
   function draw(state) result(number)
      integer(int64), intent(inout) :: state
      real(wp) :: number
      state = modulo(state*multiplier, modulus)
      number = real(state, wp)/real(modulus, wp)
   end function draw
end module dg_random_well

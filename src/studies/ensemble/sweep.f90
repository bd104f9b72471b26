!> A sweep: one string over a range of bit depths, with several operations and friction factors (the broomstick).
!>
!> A point of a sweep is a load case like any other. Components are listed from the bit upwards, so that the string fits at
!> every depth. The components move with the bit, the uppermost one gets its length from the depth, and the sections of the
!> hole stay.
module dg_sweep
   use dg_kinds, only: wp
   use dg_contact_friction, only: set_axial_friction
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: load_case_type, operation_static
   use dg_missing, only: optional_real
   implicit none
   private
   public :: sweep_type, measured_type, point_type
   public :: point_count, point_number, point_at, model_of, measured_at, shown_depths
   public :: point_case, point_holes, at_operation, regular_depths, with_depths

   !> Measured values of the rig at a depth in an operation.
   type :: measured_type
      character(:), allocatable :: name        !< of the load case that tells it
      integer :: operation = operation_static
      real(wp) :: bit_depth = 0.0_wp           !< [m]
      type(optional_real) :: hookload          !< [N]
      type(optional_real) :: torque            !< [N.m]
   end type measured_type

   type :: sweep_type
      character(:), allocatable :: name        !< unique, safe as part of a file name
      character(:), allocatable :: string      !< name of the drillstring
      integer, allocatable :: models(:)        !< numbers (dg_job)
      integer, allocatable :: operations(:)    !< numbers (dg_load_case)
      type(optional_real), allocatable :: frictions(:) !< at least one; absent: the coefficients of the hole sections
      real(wp), allocatable :: depths(:)       !< of the bit, ascending, at least one [m]
      !> Coefficients of cased hole sections, as many as frictions, which then are those of the others; not allocated: none of
      !> their own.
      real(wp), allocatable :: frictions_cased(:)
      ! one for all operations, or one each; not allocated: none
      real(wp), allocatable :: wob(:)          !< [N]
      real(wp), allocatable :: tob(:)          !< [N.m]
      real(wp), allocatable :: angular_speed(:) !< [rad/s]
      real(wp), allocatable :: trip_speed(:)   !< [m/s]
      type(measured_type), allocatable :: measured(:)
   end type sweep_type

   !> Place of a point: positions in the lists of its sweep.
   type :: point_type
      integer :: model = 1, operation = 1, friction = 1, depth = 1
   end type point_type

   !> Depths closer than this part of the step are one [-]: round-off of the last step.
   real(wp), parameter :: same_share = 1.0e-6_wp
   !> Depths this close are one [m].
   real(wp), parameter :: same_depth = 1.0e-6_wp

contains

   !> Number of points of a sweep: every model on every curve at every depth. deck/deck_sweep.f90 refuses more than a number holds.
   pure function point_count(sweep) result(count)
      type(sweep_type), intent(in) :: sweep
      integer :: count
      count = size(sweep%models)*size(sweep%operations)*size(sweep%frictions)*size(sweep%depths)
   end function point_count

   !> Number of a point from 1 on: curve after curve, model after model, depth counting fastest.
   pure function point_number(sweep, point) result(number)
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      integer :: number
      number = (((point%model - 1)*size(sweep%operations) + point%operation - 1)*size(sweep%frictions) &
                + point%friction - 1)*size(sweep%depths) + point%depth
   end function point_number

   !> The point of a number.
   pure function point_at(sweep, number) result(point)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number
      type(point_type) :: point
      integer :: rest
      rest = number - 1
      point%depth = modulo(rest, size(sweep%depths)) + 1
      rest = rest/size(sweep%depths)
      point%friction = modulo(rest, size(sweep%frictions)) + 1
      rest = rest/size(sweep%frictions)
      point%operation = modulo(rest, size(sweep%operations)) + 1
      point%model = rest/size(sweep%operations) + 1
   end function point_at

   !> Place of the model of a point.
   pure function model_of(sweep, number) result(model)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number      !< of the point
      integer :: model
      type(point_type) :: point
      point = point_at(sweep, number)
      model = point%model
   end function model_of

   !> Measured values at a point; numbers that were not measured are absent.
   pure function measured_at(sweep, point) result(measured)
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(measured_type) :: measured
      integer :: i
      do i = size(sweep%measured), 1, -1
         associate (told => sweep%measured(i))
            if (told%operation /= sweep%operations(point%operation)) cycle
            if (abs(told%bit_depth - sweep%depths(point%depth)) > 0.0_wp) cycle
            if (told%hookload%present) measured%hookload = told%hookload
            if (told%torque%present) measured%torque = told%torque
         end associate
      end do
   end function measured_at

   !> Numbers of the depths that a printed table shows, at equal steps up to the last. A page shows the shape of a curve, files
   !> have every depth.
   pure function shown_depths(sweep) result(numbers)
      type(sweep_type), intent(in) :: sweep
      integer, allocatable :: numbers(:)
      integer, parameter :: most_rows = 25
      integer :: i, step
      associate (depths => size(sweep%depths))
         step = (depths + most_rows - 1)/most_rows
         numbers = [(i, i=depths - step*((depths - 1)/step), depths, step)]
      end associate
   end function shown_depths

   !> The load case of a point.
   pure subroutine point_case(sweep, point, load_case)
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(load_case_type), intent(inout) :: load_case
      load_case%name = sweep%name
      load_case%string = sweep%string
      load_case%operation = sweep%operations(point%operation)
      load_case%bit_depth = sweep%depths(point%depth)
      load_case%wob = at_operation(sweep%wob, point%operation)
      load_case%tob = at_operation(sweep%tob, point%operation)
      load_case%friction_axial = sweep%frictions(point%friction)
      if (allocated(sweep%frictions_cased)) load_case%friction_axial = optional_real()     ! point_holes gives them
      load_case%friction_rotary = load_case%friction_axial
      load_case%angular_speed = at_operation(sweep%angular_speed, point%operation)
      load_case%trip_speed = at_operation(sweep%trip_speed, point%operation)
   end subroutine point_case

   !> Gives hole sections their friction at a point where cased ones have their own; else they stay.
   pure subroutine point_holes(sweep, point, holes)
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(hole_section_type), intent(inout) :: holes(:)
      real(wp) :: friction
      integer :: i
      if (.not. allocated(sweep%frictions_cased)) return
      do i = 1, size(holes)
         friction = sweep%frictions(point%friction)%value
         if (holes(i)%cased) friction = sweep%frictions_cased(point%friction)
         call set_axial_friction(holes(i), friction)
         holes(i)%friction_rotary = friction
      end do
   end subroutine point_holes

   !> Value for an operation from a list with one value for all operations, or one for each. 0 without a list.
   pure function at_operation(list, operation) result(value)
      real(wp), allocatable, intent(in) :: list(:)
      integer, intent(in) :: operation         !< its place in the sweep
      real(wp) :: value
      value = 0.0_wp
      if (.not. allocated(list)) return
      if (size(list) > 0) value = list(min(operation, size(list)))
   end function at_operation

   !> Depths from `first` to `last` every `step`, `last` always among them [m]. A `first` at surface is left out: there is
   !> no string yet.
   pure function regular_depths(first, last, step) result(depths)
      real(wp), intent(in) :: first   !< >= 0
      real(wp), intent(in) :: last    !< >= first, > 0
      real(wp), intent(in) :: step    !< > 0
      real(wp), allocatable :: depths(:)
      integer :: i, start, steps
      start = merge(0, 1, first > 0.0_wp)
      steps = floor((last - first)/step + same_share)
      allocate (depths(max(steps - start + 1, 0)))
      do i = start, steps
         depths(i - start + 1) = first + i*step
      end do
      if (size(depths) > 0) then
         if (last - depths(size(depths)) <= same_share*step) then
            depths(size(depths)) = last
            return
         end if
      end if
      depths = [depths, last]
   end function regular_depths

   !> Ascending depths with others put in between, where they are not there yet and lie within their range [m].
   pure function with_depths(depths, others) result(all_depths)
      real(wp), intent(in) :: depths(:)   !< ascending
      real(wp), intent(in) :: others(:)
      real(wp), allocatable :: all_depths(:)
      integer :: i, place
      all_depths = depths
      do i = 1, size(others)
         if (others(i) < depths(1) .or. others(i) > depths(size(depths))) cycle
         if (any(abs(all_depths - others(i)) <= same_depth)) cycle
         place = count(all_depths < others(i))
         all_depths = [all_depths(:place), others(i), all_depths(place + 1:)]
      end do
   end function with_depths
end module dg_sweep

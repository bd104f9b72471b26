!> Data of a deck's &calibrate: friction factors that are to be found from measured hook loads and torques.
!>
!> An unknown is one factor that hole sections and load cases share. It may be one for all, or one for each hole section,
!> operation, bit depth, or combination of these that occurs. A calibration may also find the gauge's excess over string and
!> block (an unknown weight). Without that, a wrong weight would change the friction.
module dg_calibration
   use dg_kinds, only: wp
   use dg_contact_friction, only: axial_friction, set_axial_friction
   use dg_hole_section, only: hole_section_type
   use dg_load_case, only: load_case_type, moves_axially, rotates
   use dg_missing, only: optional_real
   use dg_rig, only: rig_type
   implicit none
   private
   public :: calibration_type, unknown_type
   public :: calibrate_friction, calibrate_friction_axial, calibrate_friction_rotary, parameter_name
   public :: set_unknowns, set_data, tells, with_factors, factors_of_deck, hookload_datum, torque_datum
   public :: apply_factors, apply_offset, applied_factor, variance_kinds, ahead_of, predicts, solutions_a_step
   public :: offset_one, offset_depths, offset_name

   integer, parameter :: calibrate_friction = 1         !< mu1 and mu2 as one
   integer, parameter :: calibrate_friction_axial = 2   !< mu2 alone
   integer, parameter :: calibrate_friction_rotary = 3  !< mu1 alone
   !> Names in decks and files, in the order of the numbers above.
   character(*), parameter :: parameter_name(3) = [character(15) :: 'friction', 'friction_axial', 'friction_rotary']

   integer, parameter :: hookload_datum = 1, torque_datum = 2

   !> Offsets of the hook load: none, one, or one for each bit depth.
   integer, parameter :: offset_none = 1, offset_one = 2, offset_depths = 3
   character(*), parameter :: offset_name(3) = [character(6) :: 'none', 'one', 'depths']

   !> One factor, or one offset. Components that do not distinguish it are absent or 0.
   type :: unknown_type
      logical :: is_offset = .false.         !< of the hook load [N]
      integer :: hole = 0                    !< number of the hole section
      integer :: operation = 0               !< number (dg_load_case)
      type(optional_real) :: bit_depth       !< [m]
   end type unknown_type

   !> One measured number.
   type :: datum_type
      integer :: case = 0                    !< place in the calibration's cases
      integer :: kind = hookload_datum       !< hookload_datum or torque_datum
      real(wp) :: measured = 0.0_wp          !< [N] or [N.m]
      real(wp) :: deviation = 1.0_wp         !< standard deviation [N] or [N.m]
   end type datum_type

   type :: calibration_type
      character(:), allocatable :: name      !< unique
      integer :: parameter = calibrate_friction
      integer, allocatable :: models(:)      !< numbers (dg_job)
      integer, allocatable :: cases(:)       !< numbers of load cases
      integer, allocatable :: predicted(:)   !< numbers of load cases that are to be predicted from what is found
      integer, allocatable :: holes(:)       !< numbers of hole sections with friction as an unknown
      logical :: by_hole = .true., by_operation = .false., by_depth = .false. !< what has a factor of its own
      integer :: offset = offset_none        !< offset of the gauge as an unknown
      logical :: apply = .false.             !< the rest of the run uses the results
      type(optional_real) :: hookload_deviation !< standard deviation of a measured hook load [N]; absent: not known
      type(optional_real) :: torque_deviation   !< of a measured torque [N.m]
      type(unknown_type), allocatable :: unknowns(:)
      integer, allocatable :: unknown_of(:, :)  !< (size(cases), size(holes)): its number, 0 where the bit is above the section
      integer, allocatable :: offset_of(:)      !< number of the offset of each case, 0: none
      type(datum_type), allocatable :: data(:)
   end type calibration_type

   !> Default standard deviation, over the mean of the measured values of a kind [-]. If hook loads and torques are measured
   !> the residuals give that of each (dg_fit_by_kinds), starting from this.
   real(wp), parameter :: usual_deviation = 0.02_wp

   !> A factor is applied as it is printed, with four decimals. It is never known better, and the printed one gives the same
   !> results in a deck. Machines that differ in the last bit also agree, as parts of a divided sweep must.
   real(wp), parameter :: applied_steps = 1.0e4_wp

contains

   !> Finds the unknowns of a calibration whose cases and holes are set.
   subroutine set_unknowns(calibration, load_cases, holes)
      type(calibration_type), intent(inout) :: calibration
      type(load_case_type), intent(in) :: load_cases(:)     !< all of the deck
      type(hole_section_type), intent(in) :: holes(:)       !< all of the deck
      type(unknown_type) :: found(size(calibration%cases)*(size(calibration%holes) + 1)), one
      integer :: i, j, n
      if (allocated(calibration%unknown_of)) deallocate (calibration%unknown_of)
      allocate (calibration%unknown_of(size(calibration%cases), size(calibration%holes)), source=0)
      n = 0
      do j = 1, size(calibration%holes)
         do i = 1, size(calibration%cases)
            associate (case => load_cases(calibration%cases(i)))
               if (holes(calibration%holes(j))%md_top >= case%bit_depth) cycle
               one = unknown_type()
               if (calibration%by_hole) one%hole = calibration%holes(j)
               if (calibration%by_operation) one%operation = case%operation
               if (calibration%by_depth) one%bit_depth = optional_real(.true., case%bit_depth)
            end associate
            call enter(calibration%unknown_of(i, j))
         end do
      end do
      if (allocated(calibration%offset_of)) deallocate (calibration%offset_of)
      allocate (calibration%offset_of(size(calibration%cases)), source=0)
      do i = 1, size(calibration%cases)
         associate (case => load_cases(calibration%cases(i)))
            if (calibration%offset == offset_none .or. .not. case%measured_hookload%present) cycle
            one = unknown_type(is_offset=.true.)
            if (calibration%offset == offset_depths) one%bit_depth = optional_real(.true., case%bit_depth)
         end associate
         call enter(calibration%offset_of(i))
      end do
      calibration%unknowns = found(:n)
   contains
      !> Number of `one` among the unknowns, to which it is added if it is new.
      subroutine enter(number)
         integer, intent(out) :: number
         do number = 1, n
            if (is_same(found(number), one)) return
         end do
         n = n + 1
         found(n) = one
      end subroutine enter
   end subroutine set_unknowns

   pure function is_same(one, other) result(yes)
      type(unknown_type), intent(in) :: one, other
      logical :: yes
      yes = (one%is_offset .eqv. other%is_offset) .and. one%hole == other%hole .and. one%operation == other%operation .and. &
            abs(one%bit_depth%value - other%bit_depth%value) <= 0.0_wp
   end function is_same

   !> Lists what was measured in the calibration's cases, with standard deviations.
   subroutine set_data(calibration, load_cases)
      type(calibration_type), intent(inout) :: calibration
      type(load_case_type), intent(in) :: load_cases(:)
      integer :: i, n
      n = 0
      if (allocated(calibration%data)) deallocate (calibration%data)
      allocate (calibration%data(count(load_cases(calibration%cases)%measured_hookload%present) + &
                                 count(load_cases(calibration%cases)%measured_torque%present)))
      do i = 1, size(calibration%cases)
         associate (case => load_cases(calibration%cases(i)))
            if (case%measured_hookload%present) call add(hookload_datum, case%measured_hookload%value)
            if (case%measured_torque%present) call add(torque_datum, case%measured_torque%value)
         end associate
      end do
      call weigh(hookload_datum, calibration%hookload_deviation)
      call weigh(torque_datum, calibration%torque_deviation)
   contains
      subroutine add(kind, measured)
         integer, intent(in) :: kind
         real(wp), intent(in) :: measured
         n = n + 1
         calibration%data(n) = datum_type(i, kind, measured)
      end subroutine add

      subroutine weigh(kind, deviation)
         integer, intent(in) :: kind
         type(optional_real), intent(in) :: deviation
         real(wp) :: value
         integer :: many
         many = count(calibration%data%kind == kind)
         if (many == 0) return
         value = usual_deviation*sum(abs(calibration%data%measured), mask=calibration%data%kind == kind)/real(many, wp)
         if (.not. value > 0.0_wp) value = 1.0_wp      ! nothing but zeros measured
         if (deviation%present) value = deviation%value
         where (calibration%data%kind == kind) calibration%data%deviation = value
      end subroutine weigh
   end subroutine set_data

   !> True if a calibration has load cases to predict.
   elemental function predicts(calibration) result(yes)
      type(calibration_type), intent(in) :: calibration
      logical :: yes
      yes = allocated(calibration%predicted)
      if (yes) yes = size(calibration%predicted) > 0
   end function predicts

   !> The same unknowns for the load cases of a prediction. Its values are the hook load of each, and the torque of those that
   !> turn if torques are calibrated. Measurements of these cases are not used.
   pure function ahead_of(calibration, load_cases) result(ahead)
      type(calibration_type), intent(in) :: calibration
      type(load_case_type), intent(in) :: load_cases(:)
      type(calibration_type) :: ahead
      logical :: turns(size(calibration%predicted))
      integer :: i, j, n, u
      ahead = calibration
      ahead%cases = calibration%predicted
      deallocate (ahead%unknown_of, ahead%offset_of, ahead%data)
      allocate (ahead%unknown_of(size(ahead%cases), size(ahead%holes)), ahead%offset_of(size(ahead%cases)), source=0)
      do u = 1, size(ahead%unknowns)
         associate (unknown => ahead%unknowns(u))
            if (unknown%is_offset) ahead%offset_of = u
            if (unknown%is_offset) cycle
            do j = 1, size(ahead%holes)
               if (ahead%by_hole .and. unknown%hole /= ahead%holes(j)) cycle
               do i = 1, size(ahead%cases)
                  if (ahead%by_operation .and. unknown%operation /= load_cases(ahead%cases(i))%operation) cycle
                  ahead%unknown_of(i, j) = u
               end do
            end do
         end associate
      end do
      turns = .false.
      if (any(calibration%data%kind == torque_datum)) turns = rotates(load_cases(ahead%cases)%operation)
      allocate (ahead%data(size(turns) + count(turns)))
      n = 0
      do i = 1, size(turns)
         n = n + 1
         ahead%data(n) = datum_type(i, hookload_datum)
         if (.not. turns(i)) cycle
         n = n + 1
         ahead%data(n) = datum_type(i, torque_datum)
      end do
   end function ahead_of

   !> Number of the variance that the residuals must give, for each datum: one for hook loads, one for torques. It is 0 if the
   !> deck gives the deviation.
   pure function variance_kinds(calibration) result(kinds)
      type(calibration_type), intent(in) :: calibration
      integer :: kinds(size(calibration%data))
      integer :: torques
      kinds = 0
      torques = 1
      if (.not. calibration%hookload_deviation%present .and. any(calibration%data%kind == hookload_datum)) then
         where (calibration%data%kind == hookload_datum) kinds = 1
         torques = 2
      end if
      if (.not. calibration%torque_deviation%present) then
         where (calibration%data%kind == torque_datum) kinds = torques
      end if
   end function variance_kinds

   !> True if a measured number depends on an unknown. Hook load depends on friction along the hole, torque on friction around
   !> it, each if the string moves in that direction.
   pure function tells(calibration, load_cases, datum, unknown) result(yes)
      type(calibration_type), intent(in) :: calibration
      type(load_case_type), intent(in) :: load_cases(:)
      integer, intent(in) :: datum, unknown
      logical :: yes
      associate (told => calibration%data(datum))
         associate (operation => load_cases(calibration%cases(told%case))%operation)
            yes = any(calibration%unknown_of(told%case, :) == unknown)
            if (calibration%unknowns(unknown)%is_offset) then
               yes = told%kind == hookload_datum .and. calibration%offset_of(told%case) == unknown
            else if (told%kind == hookload_datum) then
               yes = yes .and. calibration%parameter /= calibrate_friction_rotary .and. moves_axially(operation)
            else
               yes = yes .and. calibration%parameter /= calibrate_friction_axial .and. rotates(operation)
            end if
         end associate
      end associate
   end function tells

   !> Hole sections of a case with given factors: first the overrides of the case, then the calibrated factors.
   pure function with_factors(calibration, holes, load_case, place, factors) result(changed)
      type(calibration_type), intent(in) :: calibration
      type(hole_section_type), intent(in) :: holes(:)
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: place               !< of the case in the calibration
      real(wp), intent(in) :: factors(:)         !< one an unknown
      type(hole_section_type), allocatable :: changed(:)
      integer :: j, unknown
      allocate (changed, source=holes)
      do j = 1, size(changed)
         if (load_case%friction_axial%present) call set_axial_friction(changed(j), load_case%friction_axial%value)
      end do
      if (load_case%friction_rotary%present) changed%friction_rotary = load_case%friction_rotary%value
      do j = 1, size(calibration%holes)
         unknown = calibration%unknown_of(place, j)
         if (unknown == 0) cycle
         associate (hole => changed(calibration%holes(j)))
            if (calibration%parameter /= calibrate_friction_rotary) &
               call set_axial_friction(hole, factors(unknown), [load_case%operation])
            if (calibration%parameter /= calibrate_friction_axial) hole%friction_rotary = factors(unknown)
         end associate
      end do
   end function with_factors

   !> Give hole sections the calibrated friction: factors of sections, or one of all. Coefficients that the data do not
   !> determine stay. So does the friction of operations without a case.
   pure subroutine apply_factors(calibration, factors, found, load_cases, holes)
      type(calibration_type), intent(in) :: calibration
      real(wp), intent(in) :: factors(:)         !< one an unknown
      logical, intent(in) :: found(:)             !< one an unknown
      type(load_case_type), intent(in) :: load_cases(:)     !< all of the deck
      type(hole_section_type), intent(inout) :: holes(:)
      integer :: j, u
      do u = 1, size(calibration%unknowns)
         if (calibration%unknowns(u)%is_offset .or. .not. found(u)) cycle
         do j = 1, size(calibration%holes)
            if (calibration%by_hole .and. calibration%unknowns(u)%hole /= calibration%holes(j)) cycle
            associate (hole => holes(calibration%holes(j)))
               if (calibration%parameter /= calibrate_friction_rotary) &
                  call set_axial_friction(hole, factors(u), load_cases(calibration%cases)%operation)
               if (calibration%parameter /= calibrate_friction_axial) hole%friction_rotary = factors(u)
            end associate
         end do
      end do
   end subroutine apply_factors

   !> Give the rig the one offset as weight of its block. Without a rig, or if each depth has an offset of its own, it is not
   !> applied.
   pure subroutine apply_offset(calibration, factors, found, rig, applied)
      type(calibration_type), intent(in) :: calibration
      real(wp), intent(in) :: factors(:)         !< one an unknown
      logical, intent(in) :: found(:)             !< one an unknown
      type(rig_type), intent(inout) :: rig
      logical, intent(out) :: applied
      integer :: u
      applied = .false.
      if (.not. rig%given .or. calibration%offset /= offset_one) return
      do u = 1, size(calibration%unknowns)
         if (.not. (calibration%unknowns(u)%is_offset .and. found(u))) cycle
         rig%block_weight = rig%block_weight + factors(u)
         applied = .true.
      end do
   end subroutine apply_offset

   !> A factor as it is printed and applied.
   elemental function applied_factor(factor) result(applied)
      real(wp), intent(in) :: factor
      real(wp) :: applied
      applied = anint(factor*applied_steps)/applied_steps
   end function applied_factor

   !> The factors that the deck gives, as a start: the mean over the hole sections and cases of each unknown.
   pure function factors_of_deck(calibration, holes, load_cases) result(factors)
      type(calibration_type), intent(in) :: calibration
      type(hole_section_type), intent(in) :: holes(:)
      type(load_case_type), intent(in) :: load_cases(:)
      real(wp) :: factors(size(calibration%unknowns))
      real(wp) :: axial, rotary
      integer :: many(size(calibration%unknowns)), i, j, unknown
      factors = 0.0_wp
      many = 0
      do j = 1, size(calibration%holes)
         do i = 1, size(calibration%cases)
            unknown = calibration%unknown_of(i, j)
            if (unknown == 0) cycle
            axial = axial_friction(holes(calibration%holes(j)), load_cases(calibration%cases(i))%operation)
            rotary = holes(calibration%holes(j))%friction_rotary
            associate (case => load_cases(calibration%cases(i)))
               if (case%friction_axial%present) axial = case%friction_axial%value
               if (case%friction_rotary%present) rotary = case%friction_rotary%value
            end associate
            many(unknown) = many(unknown) + 1
            select case (calibration%parameter)
            case (calibrate_friction_axial); factors(unknown) = factors(unknown) + axial
            case (calibrate_friction_rotary); factors(unknown) = factors(unknown) + rotary
            case default; factors(unknown) = factors(unknown) + 0.5_wp*(axial + rotary)
            end select
         end do
      end do
      factors = factors/real(max(many, 1), wp)      ! offsets begin at zero
   end function factors_of_deck

   !> Load cases that one step of a fit solves: each once, and again for each factor that it depends on.
   pure function solutions_a_step(calibration) result(number)
      type(calibration_type), intent(in) :: calibration
      integer :: number
      integer :: i, j
      number = size(calibration%cases)
      do i = 1, size(calibration%cases)
         do j = 1, size(calibration%holes)
            associate (unknown => calibration%unknown_of(i, j))
               if (unknown > 0 .and. .not. any(calibration%unknown_of(i, :j - 1) == unknown)) number = number + 1
            end associate
         end do
      end do
   end function solutions_a_step
end module dg_calibration

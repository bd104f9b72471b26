!> One case of the table of extremes: a well, how it is solved by the program, and the verdict on the answer.
module dg_extreme_case
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_checked_model, only: build_checked_model, check_load_case
   use dg_component, only: component_type
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_fluid, only: mud_type, standing_mud
   use dg_hole_section, only: hole_section_type
   use dg_independent_beam, only: independent_well_type
   use dg_job, only: model_mcge
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type, operation_trip_out
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type
   use dg_model_parts, only: model_parts_type
   use dg_numerics, only: settings_of
   use dg_solve_case, only: solve_case
   implicit none
   private
   public :: extreme_case_type, answer_type, verdict_type, solve_extreme, judge, weight_of
   public :: quantity_count, quantity_name, hookload, torque, contact, moment
   public :: right, refused, marked, locked_up, unsolved, wrong, verdict_count, verdict_name

   !> Quantities that are compared.
   integer, parameter :: hookload = 1, torque = 2, contact = 3, moment = 4, quantity_count = 4
   character(*), parameter :: quantity_name(quantity_count) = [character(9) :: 'hook load', 'torque', 'contact', 'moment']
   !> Words of a warning that says that a quantity may be off, without a figure for it.
   character(*), parameter :: warned_by(quantity_count) = [character(40) :: 'on hook load, torque and contact force', &
      'on hook load, torque and contact force', 'on hook load, torque and contact force', 'Bending moments and stresses']
   !> The same of a string that whirls, by other words.
   character(*), parameter :: warned_too(quantity_count) = [character(40) :: 'on hook load, torque and contact force', &
      'contact force and friction torque there', 'contact force and friction torque there', 'bending moments between contacts']
   !> Texts before another hook load and another largest moment of a helically buckled string.
   character(*), parameter :: another = 'From another start', other_hookload = ' the hook load is', &
                              other_moment = 'the largest bending moment is'
   !> Text before the per cent by which contact force, and with it hook load and torque, may be off.
   character(*), parameter :: one_of_them = 'Contact force uncertain by '
   !> Told errors have two digits [-].
   real(wp), parameter :: rounded = 1.05_wp
   !> Stands for an error that has no figure [-].
   real(wp), parameter :: huge_error = 1.0e9_wp
   !> Largest error of each [-]. Hook load, of the larger of itself and the weight: a tenth of what a weight indicator shows.
   !> Torque, of itself: as much as friction torque of a sensor repeats. Contact, of the sum: where the string lifts off, it is
   !> known to half an element.
   !> Moment, of the largest: between the nodes of the program and of the reference it is not known better.
   real(wp), parameter :: tolerance(quantity_count) = [1.0e-3_wp, 2.0e-3_wp, 1.0e-2_wp, 2.0e-2_wp]
   !> Sum of contact below which its error is one of this part of the weight [-], and torque of that contact alike.
   real(wp), parameter :: least_contact = 1.0e-3_wp

   !> Verdicts on a case.
   integer, parameter :: right = 1, refused = 2, marked = 3, locked_up = 4, unsolved = 5, wrong = 6, verdict_count = 6
   character(*), parameter :: verdict_name(verdict_count) = [character(10) :: 'right', 'refused', 'marked', 'locked up', &
                                                             'not solved', 'wrong']

   !> Case to solve. Friction is that of the well: along and around the hole.
   type :: extreme_case_type
      character(60) :: label = ''
      type(independent_well_type) :: well
      integer :: operation = operation_trip_out
      real(wp) :: wall = 0.0_wp              !< stiffness per metre [N/m2]; 0: the program's default
      real(wp) :: element = 0.0_wp           !< longest element [m]; 0: the program's default
      logical :: held = .true.               !< ends in the middle of the hole; else free across
      logical :: refusal = .false.           !< the model must be refused
      !> Relative change of the hook load by one of the load on the bit, where a closed form tells [-]. Near lock-up it is large,
      !> and the tolerance of the hook load grows by it.
      real(wp) :: condition = 1.0_wp
      logical :: lock_up = .false.           !< no push at surface moves the string
   end type extreme_case_type

   !> Numbers of an answer; missing where there is none.
   type :: answer_type
      real(wp) :: value(quantity_count) = missing   !< [N, N.m, N, N.m]
   end type answer_type

   type :: verdict_type
      integer :: number = wrong
      integer :: worst = 0                          !< quantity that is off by most of its tolerance; 0: none is compared
      real(wp) :: error(quantity_count) = missing   !< [-]
      character(:), allocatable :: message          !< of the program
   end type verdict_type

contains

   !> Solves a case as the program does for a user: the model is checked first.
   subroutine solve_extreme(extreme, answer, verdict, fidelity)
      type(extreme_case_type), intent(in) :: extreme
      type(answer_type), intent(out) :: answer
      type(verdict_type), intent(out) :: verdict    !< without errors; `right` where there are numbers
      character(*), intent(in), optional :: fidelity   !< else auto
      type(model_type) :: model
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      verdict%number = refused
      call build(extreme, fidelity, model, error)
      if (.not. allocated(error)) call solve_case(model, model_mcge, 1, result, error)
      if (allocated(error)) then
         verdict%message = error%message
         return
      end if
      verdict%message = result%message
      verdict%number = unsolved
      if (result%status == result_locked_up) verdict%number = locked_up
      if (result%status /= result_converged) return
      answer%value = [result%hookload, result%torque, result%normal_force, maxval(result%profile%bending)]
      verdict%number = merge(right, wrong, all(ieee_is_finite(answer%value)))
      verdict%error(moment) = result%moment_error
   end subroutine solve_extreme

   !> The program's model of a case, checked.
   subroutine build(extreme, fidelity, model, error)
      type(extreme_case_type), intent(in) :: extreme
      character(*), intent(in), optional :: fidelity
      type(model_type), intent(out) :: model
      type(error_type), allocatable, intent(out) :: error
      type(model_parts_type) :: parts
      type(load_case_type) :: load_case
      type(mud_type) :: mud
      integer :: i
      associate (well => extreme%well)
         parts%survey%md = well%md
         parts%survey%inclination = well%inclination*degree
         parts%survey%azimuth = well%azimuth*degree
         allocate (parts%holes(1), parts%strings(1))
         parts%holes(1) = hole_section_type('hole', 0.0_wp, well%md(size(well%md)), well%diameter, abs(well%along), well%around)
         parts%holes(1)%wall_stiffness = extreme%wall
         allocate (parts%strings(1)%components(size(well%od)))
         do i = 1, size(well%od)
            parts%strings(1)%components(i) = component_of(well, i)
         end do
         mud = standing_mud(well%mud)
         if (well%mud > 0.0_wp) parts%fluids = mud%fluids
         parts%boundary%top_centred = extreme%held
         parts%boundary%bit_centred = extreme%held
         parts%gravity = well%gravity
         parts%numerics = settings_of('auto')
         if (present(fidelity)) parts%numerics = settings_of(fidelity)
         if (extreme%element > 0.0_wp) parts%numerics%element_length = extreme%element
         ! the wall of the reference has one stiffness at any depth
         parts%numerics%gk_max = parts%numerics%gk_contact
         call build_checked_model(parts, model, error)
         if (allocated(error)) return
         load_case%operation = extreme%operation
         load_case%bit_depth = well%bit
         load_case%wob = well%wob
         load_case%tob = well%tob
         call check_load_case(model, load_case, error)
         if (allocated(error)) return
         model%cases = [load_case]
      end associate
   end subroutine build

   pure function component_of(well, place) result(component)
      type(independent_well_type), intent(in) :: well
      integer, intent(in) :: place               !< from the bit up
      type(component_type) :: component
      component%name = 'pipe'
      component%kind = 'drillpipe'
      component%length = well%length(place)
      component%od = well%od(place)
      component%id = well%id(place)
      component%mass = well%mass(place)
      component%joint_od = well%joint(place)
      component%youngs = well%youngs
   end function component_of

   !> Judges the program's answer by a reference: errors, and whether what is off is told. `verdict` comes from solve_extreme.
   pure subroutine judge(extreme, answer, reference, verdict)
      type(extreme_case_type), intent(in) :: extreme
      type(answer_type), intent(in) :: answer, reference
      type(verdict_type), intent(inout) :: verdict
      real(wp) :: allowed(quantity_count), told(quantity_count), least
      integer :: i
      told = told_errors(verdict%message, verdict%error(moment))
      verdict%error = missing
      if (extreme%refusal .neqv. verdict%number == refused) verdict%number = wrong
      if ((extreme%lock_up .neqv. verdict%number == locked_up) .and. verdict%number /= unsolved) verdict%number = wrong
      if (verdict%number /= right) return
      allowed = tolerance
      allowed(hookload) = allowed(hookload)*extreme%condition
      do i = 1, quantity_count
         if (is_missing(reference%value(i))) cycle
         least = 0.0_wp
         if (i == hookload) least = weight_of(extreme%well)
         if (i == torque) least = least_contact*weight_of(extreme%well)*0.5_wp*maxval(extreme%well%od)
         if (i == contact) least = least_contact*weight_of(extreme%well)
         verdict%error(i) = abs(answer%value(i) - reference%value(i))/max(abs(reference%value(i)), least, tiny(1.0_wp))
         if (verdict%worst == 0) verdict%worst = i
         if (verdict%error(i)/allowed(i) > verdict%error(verdict%worst)/allowed(verdict%worst)) verdict%worst = i
         if (verdict%error(i) <= allowed(i)) cycle
         if (verdict%number == right) verdict%number = marked
         if (abs(answer%value(i) - reference%value(i)) > &
             rounded*told(i)*max(abs(reference%value(i)), abs(answer%value(i)), least)) verdict%number = wrong
      end do
   end subroutine judge

   !> Error of each quantity that the program tells [-]: 0 where it tells none, `huge_error` where it warns without a figure.
   pure function told_errors(message, moment_error) result(told)
      character(*), intent(in) :: message
      real(wp), intent(in) :: moment_error       !< bending_error of limits.csv [-]; missing: none
      real(wp) :: told(quantity_count), percent
      integer :: i, status, first, last
      told = 0.0_wp
      if (.not. is_missing(moment_error)) told(moment) = moment_error
      first = index(message, one_of_them) + len(one_of_them)
      if (first > len(one_of_them)) then
         last = first + index(message(first:), ' ') - 2
         read (message(first:last), *, iostat=status) percent
         if (status == 0) told([hookload, torque, contact]) = 0.01_wp*percent
      end if
      first = index(message, another)
      if (first > 0) then
         if (index(message(first:), other_hookload) > 0) told([hookload, contact]) = huge_error
         if (index(message(first:), other_moment) > 0) told(moment) = huge_error
      end if
      do i = 1, quantity_count
         if (index(message, trim(warned_by(i))) + index(message, trim(warned_too(i))) > 0) told(i) = huge_error
      end do
   end function told_errors

   !> Weight of the string in the mud [N].
   pure function weight_of(well) result(weight)
      type(independent_well_type), intent(in) :: well
      real(wp) :: weight, left
      real(wp), parameter :: steel = 7850.0_wp
      integer :: i
      left = well%bit
      weight = 0.0_wp
      do i = 1, size(well%mass)
         weight = weight + well%mass(i)*merge(left, well%length(i), i == size(well%mass))
         left = left - well%length(i)
      end do
      weight = weight*well%gravity*(1.0_wp - well%mud/steel)
   end function weight_of
end module dg_extreme_case

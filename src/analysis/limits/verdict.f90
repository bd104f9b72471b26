!> The answer to 'can it be done?' for one load case, with the limit that decides.
module dg_verdict
   use dg_kinds, only: wp
   use dg_component, only: component_type
   use dg_constants, only: pi
   use dg_missing, only: optional_real
   use dg_text, only: lower_case
   use dg_utilisation, only: limit_count, limit_name
   implicit none
   private
   public :: verdict_type, note_uncertain, note_left_out, set_name, &
             is_most, is_near_by_friction, is_uncertain, is_without_check, nearness, little_reserve, slow_turning, &
             answer_unknown, answer_no, answer_yes, answer_name, every_limit_count, &
             limit_string_weight, limit_lock_up, limit_fatigue, limit_joint_fatigue, limit_wob_yield, limit_seal_travel, &
             limit_packer_force, limit_casing_wear, limit_worn_casing, limit_bend, limits_by_hours, &
             limit_title, limit_code
   public :: friction_given, friction_calibrated, friction_upper_end, friction_upper_end_alone

   integer, parameter :: answer_unknown = 0, answer_no = 1, answer_yes = 2
   !> Names in files, in the order of the numbers above.
   character(*), parameter :: answer_name(0:2) = [character(7) :: 'unknown', 'no', 'yes']

   !> Limits besides those of dg_utilisation:
   !> - string weight: the part of the buoyed weight that friction and weight on bit take. With a `max_push` of the rig it is the
   !>   part of that push which is needed.
   !> - lock-up: weight on bit over the largest that comes to the bit by string weight and `max_push`
   !> - fatigue: the part of the life of bodies or connections that the hours of the case use
   !> - yield under WOB: weight on bit over the one at which compressed pipe yields. It includes the bending of helical
   !>   buckling, which the stresses of the soft string lack.
   !> - travel of the seals in a packer and force on it: never checked, as the deck has no key for them
   !> - casing wear: the volume that the hours of the case wear off over that of a groove through the wall
   !> - strength of the worn casing: never checked, as the deck has no pressures that the casing must bear
   !> - bend: stress and fatigue by a bent housing of a string that turns, never checked, as it is solved straight
   integer, parameter :: limit_string_weight = limit_count + 1, limit_lock_up = limit_count + 2, limit_fatigue = limit_count + 3, &
                         limit_joint_fatigue = limit_count + 4, limit_wob_yield = limit_count + 5, &
                         limit_seal_travel = limit_count + 6, limit_packer_force = limit_count + 7, &
                         limit_casing_wear = limit_count + 8, limit_worn_casing = limit_count + 9, &
                         limit_bend = limit_count + 10
   integer, parameter :: every_limit_count = limit_count + 10
   character(*), parameter :: further_name(limit_count + 1:every_limit_count) = [character(27) :: 'string weight', 'lock-up', &
      'fatigue', 'joint fatigue', 'yield under WOB', 'seal travel', 'packer force', 'casing wear', 'strength of the worn casing', &
      'bend']
   !> Limits of the hours of rotation.
   integer, parameter :: limits_by_hours(3) = [limit_fatigue, limit_joint_fatigue, limit_casing_wear]

   !> Friction of an answer: of the deck; of a calibration without a 95 % interval; of a calibration at whose upper end the
   !> answer holds. The last value: the answer is no only at the upper end.
   integer, parameter :: friction_given = 0, friction_calibrated = 1, friction_upper_end = 2, friction_upper_end_alone = 3

   !> Friction reserve below which the answer is near its limit [-].
   real(wp), parameter :: little_reserve = 1.2_wp
   !> Speed of rotation for which a remedy names a speed along the hole: 20 rpm, as casing is turned [rad/s].
   real(wp), parameter :: slow_turning = 20.0_wp*2.0_wp*pi/60.0_wp
   !> Ratio of the friction that smeared joints leave out, by beams with joints one by one, to its rough number [-]. Near lock-up
   !> it may be 20, where a friction reserve below `joints_reserve` tells of it.
   real(wp), parameter :: roughest = 5.0_wp, joints_reserve = 1.15_wp

   type :: verdict_type
      integer :: answer = answer_unknown
      integer :: limit = 0                          !< limit that decides; for yes the one used most; 0: none known
      type(optional_real) :: used                   !< part of it that is used [-]
      type(optional_real) :: md                     !< depth [m]; absent for the whole string
      integer :: part = 0                           !< number of the component there; 0: not known
      character(:), allocatable :: component        !< its name; not allocated: not known
      type(optional_real) :: load, allowed          !< load there and allowed load [N, N.m, Pa or s]
      logical :: not_checked(every_limit_count) = .false.   !< limits that apply here and have no rating
      type(optional_real) :: friction_reserve       !< yes: factor by which all friction may grow until the answer is no [-]
      integer :: reserve_limit = 0                  !< limit that is passed then
      logical :: weight_judged = .false.            !< string weight is one of the limits
      logical :: reserve_buckles = .false.          !< beams buckle only with that friction: perhaps less is enough
      logical :: reserve_unknown = .false.          !< loads with another friction or weight on bit cannot be estimated
      type(optional_real) :: possible_friction      !< no: factor of all friction up to which the answer is yes [-]
      integer :: friction = friction_given          !< friction of the answer
      real(wp), allocatable :: frictions(:)         !< factors of the deck that the case meets [-]
      real(wp) :: uncertain = 0.0_wp                !< yes: error of contact force that exceeds what is left; else 0 [-]
      logical :: joints_uncertain = .false.         !< yes: friction that smeared joints leave out may exceed what is left
      real(wp) :: fatigue_used = 0.0_wp             !< yes: bending over that of endless life, hours not judged; else 0 [-]
      real(wp) :: fatigue_md = 0.0_wp               !< depth there [m]
      real(wp) :: buckled_length = 0.0_wp           !< of string in helical buckling [m]
      logical :: pressure_pushes = .false.          !< pressure of the annulus also takes string weight
      logical :: packer_pushes = .false.            !< pressures at a packer also take it
      logical :: buckled_by_formula = .false.       !< above the published load; else by beams
      real(wp) :: push = 0.0_wp                     !< push needed at surface [N]
      real(wp) :: max_push = 0.0_wp                 !< largest one of the rig [N]
      type(optional_real) :: most_wob               !< largest weight on bit by string weight and that push [N]
      type(optional_real) :: wob_yield              !< weight on bit at which compressed pipe yields, if that is less [N]
      logical :: wob_by_beams = .false.             !< beams have found it, else the soft string
      type(optional_real) :: reach                  !< no: greatest bit depth that is possible, 0: none [m]
      type(optional_real) :: pump_pressure          !< no by burst or collapse: pump pressure with which the answer is yes [Pa]
      logical :: fill = .false.                     !< no by collapse: the answer is yes if the empty string is filled
      integer :: also = 0                           !< no: another limit that is also passed, 0: none
      real(wp) :: also_load = 0.0_wp, also_allowed = 0.0_wp   !< load there and allowed load [N, N.m, Pa or s]
      logical :: alone = .false.                    !< no without a solution: of the other limits only pressure is known
      logical :: pressures_judged = .false.         !< burst or collapse of such a string has been judged
      real(wp) :: passed(every_limit_count) = 0.0_wp    !< used part of each limit that is passed, 0 of the others [-]
      type(optional_real) :: most_pull              !< no, pulling: largest overpull with which no limit is passed [N]
      integer :: pull_limit = 0                     !< limit that is passed with more
      integer :: limit_without_load = 0             !< no: limit that is also passed without weight on bit or overpull; 0: none
      real(wp) :: excess_without_load = 0.0_wp      !< load beyond that limit, except for lock-up [N, N.m or Pa]
      !> Hook load and torque at surface if the string were turned, if that would help [N, N.m].
      type(optional_real) :: turning_hookload, turning_torque
      type(optional_real) :: turning_speed          !< along the hole, at `slow_turning`, up to which that helps [m/s]
   end type verdict_type

contains

   !> Mark a yes as uncertain if its limit is nearer than the error of contact force in a warning. That error is one of
   !> moments, and of drag unless the string is helically buckled.
   elemental subroutine note_uncertain(error, von_mises_used, coiled, verdict)
      real(wp), intent(in) :: error            !< [-]; 0: no warning
      real(wp), intent(in) :: von_mises_used   !< [-]; 0: not known
      logical, intent(in) :: coiled            !< the string is helically buckled
      type(verdict_type), intent(inout) :: verdict
      real(wp) :: used
      if (verdict%answer /= answer_yes) return
      used = von_mises_used
      if (.not. coiled .and. verdict%reserve_unknown) used = max(used, verdict%used%value)
      if (used*(1.0_wp + error) > 1.0_wp) verdict%uncertain = error
      if (.not. coiled .and. verdict%friction_reserve%present .and. verdict%friction_reserve%value < 1.0_wp + error) &
         verdict%uncertain = error
   end subroutine note_uncertain

   !> Mark a yes of a string that goes down as uncertain where smeared tool joints may leave out more friction than its hook
   !> load. `verdict` has its friction reserve.
   elemental subroutine note_left_out(friction, hookload, verdict)
      real(wp), intent(in) :: friction         !< rough number, huge: lock-up [N]
      real(wp), intent(in) :: hookload         !< with the push that is possible [N]
      type(verdict_type), intent(inout) :: verdict
      if (verdict%answer /= answer_yes .or. .not. friction > 0.0_wp) return
      verdict%joints_uncertain = friction > hookload/roughest
      if (verdict%friction_reserve%present .and. verdict%friction_reserve%value < joints_reserve) verdict%joints_uncertain = .true.
   end subroutine note_left_out

   !> Set the name of the component where the limit is used most.
   pure subroutine set_name(part, verdict)
      type(component_type), intent(in) :: part
      type(verdict_type), intent(inout) :: verdict
      if (allocated(part%name)) verdict%component = part%name
   end subroutine set_name

   !> True if a share [-] is more than the used part of the limit so far.
   pure function is_most(share, verdict) result(is)
      real(wp), intent(in) :: share
      type(verdict_type), intent(in) :: verdict
      logical :: is
      is = share > 0.0_wp
      if (verdict%used%present) is = share > verdict%used%value
   end function is_most

   !> True if a little more friction makes a yes a NO, and no limit is used as much as that says.
   elemental function is_near_by_friction(verdict) result(near)
      type(verdict_type), intent(in) :: verdict
      logical :: near
      near = verdict%friction_reserve%present
      if (near) near = verdict%friction_reserve%value < little_reserve
      if (near .and. verdict%used%present) near = verdict%used%value*verdict%friction_reserve%value < 1.0_wp
   end function is_near_by_friction

   !> True for a yes that the results do not prove.
   elemental function is_uncertain(verdict) result(uncertain)
      type(verdict_type), intent(in) :: verdict
      logical :: uncertain
      uncertain = verdict%answer == answer_yes .and. &
                  (verdict%uncertain > 0.0_wp .or. verdict%joints_uncertain .or. verdict%fatigue_used > 0.0_wp)
   end function is_uncertain

   !> True for a yes without any limit.
   elemental function is_without_check(verdict) result(without)
      type(verdict_type), intent(in) :: verdict
      logical :: without
      without = verdict%answer == answer_yes .and. verdict%limit == 0 .and. .not. verdict%weight_judged
   end function is_without_check

   !> Nearness of a yes to its limit [-]: 1 is at the limit, 0 not known.
   elemental function nearness(verdict) result(near)
      type(verdict_type), intent(in) :: verdict
      real(wp) :: near
      near = 0.0_wp
      if (verdict%used%present) near = verdict%used%value
      if (is_near_by_friction(verdict)) near = 1.0_wp/verdict%friction_reserve%value
   end function nearness

   !> Name of a limit in texts, with trailing blanks; blank for 0.
   pure function limit_title(limit) result(name)
      integer, intent(in) :: limit
      character(len(further_name)) :: name
      name = ''
      if (limit > limit_count) then
         name = further_name(limit)
      else if (limit > 0) then
         name = limit_name(limit)
      end if
   end function limit_title

   !> Name of a limit in files: lower case, '_' in place of blanks and hyphens, with trailing blanks.
   pure function limit_code(limit) result(code)
      integer, intent(in) :: limit
      character(len(further_name)) :: code
      integer :: i
      code = lower_case(limit_title(limit))
      do i = 1, len_trim(code)
         if (code(i:i) == ' ' .or. code(i:i) == '-') code(i:i) = '_'
      end do
   end function limit_code
end module dg_verdict

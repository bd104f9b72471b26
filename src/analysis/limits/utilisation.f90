!> Utilisation of each strength of a string, load times design factor over strength, and the governing limit, which is used
!> most.
!>
!> Tension is the effective one, as API rates pipe in mud. Where two components meet each has a row, so that the weaker
!> connection counts. Buckling is not a strength and has margins of its own (dg_buckling_limits).
!>
!> Ratings of premium connections are below the strength of the body. Tension and compression are judged by the axial stress of
!> the most loaded fibre. It is without the pressure that both sides have and with bending, as in Bourgoyne et al. (1986),
!> Applied drilling engineering, eq. 7.14. Pressures are compared with burst and collapse of the body, and the curvature of the
!> pipe with its dogleg.
!>
!> Slips hold a string that hangs with its bit off bottom: their load is the hook load and the weight on bit. Nobody sets them
!> while the bit is pulled, so cases with a pull at the bit have no use of slips.
module dg_utilisation
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, body_bending
   use dg_case_result, only: case_result_type
   use dg_component, only: component_type, is_bit, is_pipe, tube_area, worn_od
   use dg_connection_rating, only: is_rated
   use dg_design_factors, only: design_factors_type
   use dg_drillstring, only: component_at, component_tops, topmost
   use dg_load_case, only: rotates
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type, string_index
   use dg_profile, only: piece_depths, profile_type
   use dg_pipe_strength, only: burst_strength, collapse_strength, collapses_as_steel, slip_share, tensile_strength, &
                               torsional_strength, warmed
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: utilisation_type, find_utilisation, limit_count, limit_name, governing_name, has_rating, has_joint_rating, &
             lacks_rating, part_limits
   public :: limit_von_mises, limit_tension, limit_torsion, limit_joint_torsion, limit_makeup, limit_burst, limit_collapse, &
             limit_slips, limit_rig, limit_top_drive, limit_joint_tension, limit_joint_compression, limit_joint_burst, &
             limit_joint_collapse, limit_joint_dogleg, joint_ratings, as_much

   integer, parameter :: limit_von_mises = 1, limit_tension = 2, limit_torsion = 3, limit_joint_torsion = 4, limit_makeup = 5, &
                         limit_burst = 6, limit_collapse = 7, limit_slips = 8, limit_rig = 9, limit_top_drive = 10, &
                         limit_joint_tension = 11, limit_joint_compression = 12, limit_joint_burst = 13, &
                         limit_joint_collapse = 14, limit_joint_dogleg = 15
   integer, parameter :: limit_count = 15
   !> Ratings of premium connections.
   integer, parameter :: joint_ratings(5) = [limit_joint_tension, limit_joint_compression, limit_joint_burst, &
                                             limit_joint_collapse, limit_joint_dogleg]
   !> Limits by strengths of each component.
   integer, parameter :: part_limits(12) = [limit_von_mises, limit_tension, limit_torsion, limit_joint_torsion, limit_makeup, &
                                            limit_burst, limit_collapse, joint_ratings]
   character(*), parameter :: limit_name(limit_count) = [character(17) :: 'von Mises', 'tension', 'torsion', 'joint torsion', &
      'make-up torque', 'burst', 'collapse', 'slips', 'rig', 'top drive', 'joint tension', 'joint compression', 'joint burst', &
      'joint collapse', 'joint dogleg']
   !> Order of limits that are used alike. Limits of the pipe come before its connections, von Mises last. Under a pull alone
   !> it equals tension.
   integer, parameter :: precedence(limit_count) = [limit_top_drive, limit_rig, limit_slips, limit_collapse, limit_burst, &
      limit_makeup, limit_joint_torsion, limit_torsion, limit_tension, joint_ratings, limit_von_mises]

   type :: utilisation_type
      type(optional_real) :: used(limit_count)   !< largest along the string [-]; absent without a known strength
      type(optional_real) :: md(limit_count)     !< its depth [m]
      integer :: part(limit_count) = 0           !< number of the component there; 0: a limit at surface, or not used at all
      real(wp) :: load(limit_count) = 0.0_wp     !< load that is compared with the strength there [N, N.m, Pa or 1/m]
      integer :: governing = 0                   !< the limit that is used most; 0: none known
   end type utilisation_type

   !> Least relative difference for a limit to count as used more than another [-]: beyond round-off.
   real(wp), parameter :: as_much = 1.0e-6_wp
   !> Least relative difference of two uses of one limit at two depths [-].
   real(wp), parameter :: round_off = 1.0e-10_wp

contains

   !> Find all utilisations, from a result and its columns along the string.
   pure subroutine find_utilisation(model, result, along, utilisation)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(utilisation_type), intent(out) :: utilisation
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, depths(size(result%profile%md)), before(limit_count)
      integer :: i, limit, number
      bit = model%cases(result%case_index)%bit_depth
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)), &
                 profile => result%profile)
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         depths = piece_depths(profile)
         do i = 1, size(profile%md)
            before = utilisation%used%value
            number = component_at(tops, bit - depths(i))
            associate (part => string%components(number))
               if (along%yield_left(i) < 1.0_wp) then
                  call use_row(warmed(part, along%yield_left(i)), model%design, profile, along, i, utilisation)
               else
                  call use_row(part, model%design, profile, along, i, utilisation)
               end if
               if (.not. is_missing(along%safety_factor(i))) call use_limit(utilisation, limit_von_mises, &
                  model%design%von_mises*along%jointed_von_mises(i)/(along%yield_left(i)*part%yield), along%jointed_von_mises(i), &
                  profile%md(i))
            end associate
            where (utilisation%used%value > before) utilisation%part = number
         end do
         associate (uppermost => string%components(topmost(tops)), wob => model%cases(result%case_index)%wob)
            if (model%design%slip_length > 0.0_wp .and. uppermost%yield > 0.0_wp .and. .not. wob < 0.0_wp) &
               call use_limit(utilisation, limit_slips, &
                  model%design%tension*max(result%hookload + wob, 0.0_wp)/(along%yield_left(1)*tensile_strength(uppermost)* &
                  slip_share(worn_od(uppermost), model%design%slip_lateral, model%design%slip_length)), &
                  result%hookload + wob, profile%md(1))
         end associate
         if (model%rig%max_hookload%present) call use_limit(utilisation, limit_rig, &
            max(result%hookload + model%rig%block_weight, 0.0_wp)/model%rig%max_hookload%value, &
            result%hookload + model%rig%block_weight, profile%md(1))
         if (model%rig%max_torque%present .and. rotates(model%cases(result%case_index)%operation)) &
            call use_limit(utilisation, limit_top_drive, abs(result%torque)/model%rig%max_torque%value, abs(result%torque), &
                           profile%md(1))
      end associate
      do i = 1, limit_count
         limit = precedence(i)
         if (.not. utilisation%used(limit)%present) cycle
         if (utilisation%governing > 0) then
            if (utilisation%used(limit)%value <= (1.0_wp + as_much)*utilisation%used(utilisation%governing)%value) cycle
         end if
         utilisation%governing = limit
      end do
   end subroutine find_utilisation

   !> Add the use of strengths and ratings of one component at a row of the profile.
   pure subroutine use_row(part, factors, profile, along, row, utilisation)
      type(component_type), intent(in) :: part      !< with its strength at the local temperature
      type(design_factors_type), intent(in) :: factors
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      integer, intent(in) :: row
      type(utilisation_type), intent(inout) :: utilisation
      call use_component(part, factors, profile%axial(row), profile%torque(row), along%pressure(row), &
                         along%inside_pressure(row), profile%md(row), utilisation)
      if (is_rated(part%rating)) call use_rating(part, factors, along, row, profile%md(row), utilisation)
   end subroutine use_row

   !> Utilisation of the strengths of one component at one depth.
   pure subroutine use_component(part, factors, axial, torque, outside, inside, md, utilisation)
      type(component_type), intent(in) :: part
      type(design_factors_type), intent(in) :: factors
      real(wp), intent(in) :: axial             !< effective [N]
      real(wp), intent(in) :: torque            !< [N.m]
      real(wp), intent(in) :: outside, inside   !< pressures [Pa]
      real(wp), intent(in) :: md                !< [m]
      type(utilisation_type), intent(inout) :: utilisation
      real(wp) :: od, stress
      if (part%joint_torsion > 0.0_wp) &
         call use_limit(utilisation, limit_joint_torsion, factors%torsion*abs(torque)/part%joint_torsion, abs(torque), md)
      if (part%makeup_torque > 0.0_wp) &
         call use_limit(utilisation, limit_makeup, abs(torque)/part%makeup_torque, abs(torque), md)
      if (.not. part%yield > 0.0_wp) return
      call use_limit(utilisation, limit_tension, factors%tension*max(axial, 0.0_wp)/tensile_strength(part), axial, md)
      call use_limit(utilisation, limit_torsion, factors%torsion*abs(torque)/torsional_strength(part), abs(torque), md)
      call use_limit(utilisation, limit_burst, factors%burst*max(inside - outside, 0.0_wp)/burst_strength(part), &
                     inside - outside, md)
      if (.not. collapses_as_steel(part)) return
      ! True axial stress plus pressure inside: the effect of one mud pressure on both cancels.
      od = worn_od(part)
      stress = (axial - (outside - inside)*tube_area(od, 0.0_wp))/tube_area(od, part%id)
      call use_limit(utilisation, limit_collapse, factors%collapse*share_of(max(outside - inside, 0.0_wp), &
         collapse_strength(part, stress)), outside - inside, md)
   end subroutine use_component

   !> Add the use of the ratings of one component's connections at a row of the profile.
   pure subroutine use_rating(part, factors, along, row, md, utilisation)
      type(component_type), intent(in) :: part
      type(design_factors_type), intent(in) :: factors
      type(along_string_type), intent(in) :: along
      integer, intent(in) :: row
      real(wp), intent(in) :: md                !< [m]
      type(utilisation_type), intent(inout) :: utilisation
      real(wp) :: curvature, bending, stress
      curvature = along%bending_stress(row)/(0.5_wp*part%youngs*worn_od(part))
      if (.not. is_missing(part%rating%dogleg)) &
         call use_limit(utilisation, limit_joint_dogleg, curvature/part%rating%dogleg, curvature, md)
      if (.not. part%yield > 0.0_wp) return
      bending = body_bending(along, row)
      associate (rating => part%rating, outside => along%pressure(row), inside => along%inside_pressure(row))
         stress = along%axial_stress(row) + min(outside, inside)
         call use_share(limit_joint_tension, rating%tension, factors%tension, bending + stress, part%yield, &
                        md, utilisation)
         call use_share(limit_joint_compression, rating%compression, factors%tension, bending - stress, part%yield, &
                        md, utilisation)
         call use_share(limit_joint_burst, rating%burst, factors%burst, inside - outside, burst_strength(part), &
                        md, utilisation)
         if (collapses_as_steel(part)) call use_share(limit_joint_collapse, rating%collapse, factors%collapse, &
            outside - inside, collapse_strength(part, stress), md, utilisation)
      end associate
   end subroutine use_rating

   !> Add the use of a rating, if there is one.
   pure subroutine use_share(limit, rating, factor, load, strength, md, utilisation)
      integer, intent(in) :: limit
      real(wp), intent(in) :: rating     !< over `strength`, may be missing [-]
      real(wp), intent(in) :: factor     !< on the load [-]
      real(wp), intent(in) :: load       !< counts as zero if negative [Pa]
      real(wp), intent(in) :: strength   !< of the body [Pa]
      real(wp), intent(in) :: md         !< [m]
      type(utilisation_type), intent(inout) :: utilisation
      if (.not. is_missing(rating)) &
         call use_limit(utilisation, limit, factor*share_of(max(load, 0.0_wp), rating*strength), load, md)
   end subroutine use_share

   !> True if the deck gives a component the strength of a limit.
   elemental function has_rating(part, limit) result(has)
      type(component_type), intent(in) :: part
      integer, intent(in) :: limit
      logical :: has
      select case (limit)
      case (limit_von_mises, limit_tension, limit_torsion, limit_burst, limit_collapse); has = part%yield > 0.0_wp
      case (limit_joint_torsion); has = part%joint_torsion > 0.0_wp
      case (limit_makeup); has = part%makeup_torque > 0.0_wp
      case (limit_joint_tension); has = part%yield > 0.0_wp .and. .not. is_missing(part%rating%tension)
      case (limit_joint_compression); has = part%yield > 0.0_wp .and. .not. is_missing(part%rating%compression)
      case (limit_joint_burst); has = part%yield > 0.0_wp .and. .not. is_missing(part%rating%burst)
      case (limit_joint_collapse); has = part%yield > 0.0_wp .and. .not. is_missing(part%rating%collapse)
      case (limit_joint_dogleg); has = .not. is_missing(part%rating%dogleg)
      case default; has = .false.
      end select
   end function has_rating

   !> True if the deck gives a component any strength of its connections.
   elemental function has_joint_rating(part) result(has)
      type(component_type), intent(in) :: part
      logical :: has
      has = has_rating(part, limit_joint_torsion) .or. has_rating(part, limit_makeup) .or. is_rated(part%rating)
   end function has_joint_rating

   !> True if a component needs the strength of a limit and lacks it. All but the bit need a yield strength. Pipe also needs
   !> strengths of its joints. Only for the limits of components.
   elemental function lacks_rating(part, limit) result(lacks)
      type(component_type), intent(in) :: part
      integer, intent(in) :: limit
      logical :: lacks
      lacks = .not. has_rating(part, limit) .and. .not. is_bit(part)
      if (any(limit == [limit_joint_torsion, limit_makeup, joint_ratings])) lacks = lacks .and. is_pipe(part)
   end function lacks_rating

   !> Load over strength, where the strength may be zero [-].
   elemental function share_of(load, strength) result(share)
      real(wp), intent(in) :: load, strength   !< in one unit, >= 0
      real(wp) :: share
      share = 0.0_wp
      if (load > 0.0_wp) share = load/max(strength, load*epsilon(1.0_wp))
   end function share_of

   !> Keep a use of a limit if it is more than any before. Among equal ones the uppermost is kept.
   pure subroutine use_limit(utilisation, limit, used, load, md)
      type(utilisation_type), intent(inout) :: utilisation
      integer, intent(in) :: limit
      real(wp), intent(in) :: used   !< [-]
      real(wp), intent(in) :: load   !< [N, N.m, Pa or 1/m]
      real(wp), intent(in) :: md     !< [m]
      if (utilisation%used(limit)%present .and. used <= (1.0_wp + round_off)*utilisation%used(limit)%value) return
      utilisation%used(limit) = given(used)
      utilisation%md(limit) = given(md)
      utilisation%load(limit) = load
   end subroutine use_limit

   !> Name of the limit that governs; '' for none.
   pure function governing_name(utilisation) result(name)
      type(utilisation_type), intent(in) :: utilisation
      character(len(limit_name)) :: name
      name = ''
      if (utilisation%governing > 0) name = limit_name(utilisation%governing)
   end function governing_name
end module dg_utilisation

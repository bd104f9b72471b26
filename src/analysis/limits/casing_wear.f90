!> Wear of casing by a string that turns in it, after Hall, White & Dawson. The volume worn off a metre of casing is a wear
!> factor times the work of sliding. That work is the side force of a metre of string times the path of its surface:
!>
!>   V = f N omega r t
!> - f: wear factor [1/Pa]
!> - N: side force per length [N/m]
!> - omega: speed [rad/s]
!> - r: radius of contact [m]
!> - t: time [s]
!>
!> Tool joints carry the side force of a whole joint of pipe. They are at a place of the casing only for their part of the
!> time, so that the product is the same. The string is assumed to move by at least a joint of pipe while it turns. N is
!> therefore the mean over the distance of two tool joints. The groove is a crescent, as wide as the joint in it: the part of
!> the joint's circle outside the bore. Burst and collapse of the rest are those of casing worn so thin all around (API 5C3;
!> Barlow with 7/8 of the wall). That is the usual choice, on the safe side.
module dg_casing_wear
   use dg_kinds, only: wp
   use dg_bracket, only: bracket_type, is_narrow, narrow, new_bracket, next_try
   use dg_case_result, only: case_result_type
   use dg_component, only: component_type, contact_diameter
   use dg_constants, only: pi
   use dg_drillstring, only: component_at, component_tops
   use dg_hole_section, only: hole_section_at, hole_section_type
   use dg_load_case, only: load_case_type, rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_pipe_strength, only: burst_strength, collapse_strength
   use dg_profile, only: piece_depths
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: groove_type, find_casing_wear, worst_groove, wears_casing, crescent_area, groove_depth

   !> Groove in a casing at a depth.
   type :: groove_type
      logical :: present = .false.
      real(wp) :: md = 0.0_wp              !< [m]
      integer :: hole = 0                  !< number of its hole section
      real(wp) :: side_force = 0.0_wp      !< mean over a joint of pipe [N/m]
      real(wp) :: volume = 0.0_wp          !< worn off per length [m2]
      real(wp) :: depth = 0.0_wp           !< [m]
      real(wp) :: used = 0.0_wp            !< volume over that of a groove through the wall [-]
      real(wp) :: wall_left = 1.0_wp       !< wall left over the new wall [-]
      real(wp) :: burst = missing          !< strength left [Pa]
      real(wp) :: collapse = missing       !< strength left without tension [Pa]
   end type groove_type

   !> Angles below which a series replaces a difference [rad]. Accuracy of the depth of a groove over the wall [-].
   real(wp), parameter :: small = 1.0e-2_wp, narrowness = 1.0e-9_wp
   real(wp), parameter :: hour = 3600.0_wp   ! s

contains

   !> True if a section of the hole is casing with a wear factor.
   elemental function is_worn_casing(hole) result(is)
      type(hole_section_type), intent(in) :: hole
      logical :: is
      is = .not. (is_missing(hole%casing_od) .or. is_missing(hole%wear_factor))
   end function is_worn_casing

   !> True if a load case wears casing: it rotates for some hours, and the deck has a wear factor.
   pure function wears_casing(model, load_case) result(wears)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: wears
      wears = rotates(load_case%operation) .and. load_case%hours > 0.0_wp .and. load_case%angular_speed > 0.0_wp
      if (wears) wears = any(is_worn_casing(model%holes))
   end function wears_casing

   !> Grooves at the rows of a profile in casing, from the top down.
   pure subroutine find_casing_wear(model, result, grooves)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(groove_type), allocatable, intent(out) :: grooves(:)
      real(wp), dimension(size(result%profile%md)) :: depths, force, work
      real(wp), allocatable :: tops(:)
      type(groove_type) :: groove
      real(wp) :: bit, upper, lower, spacing
      integer :: i, part, count
      count = 0
      allocate (grooves(merge(size(depths), 0, wears_casing(model, model%cases(result%case_index)))))
      if (size(grooves) == 0) return
      associate (profile => result%profile, load_case => model%cases(result%case_index), &
                 string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         bit = load_case%bit_depth
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         depths = piece_depths(profile)
         force = 0.0_wp          ! sums from the top: side force, and side force times radius of contact
         work = 0.0_wp
         do i = 2, size(depths)
            force(i) = force(i - 1) + 0.5_wp*(profile%side_force(i - 1) + profile%side_force(i))*(profile%md(i) - profile%md(i - 1))
            part = component_at(tops, bit - 0.5_wp*(profile%md(i - 1) + profile%md(i)))
            work(i) = work(i - 1) + 0.5_wp*contact_diameter(string%components(part), bit - tops(part))*(force(i) - force(i - 1))
         end do
         do i = 1, size(depths)
            associate (hole => model%holes(hole_section_at(model%holes, depths(i))))
               if (.not. is_worn_casing(hole)) cycle
               spacing = string%components(component_at(tops, bit - depths(i)))%joint_spacing
               upper = max(profile%md(i) - 0.5_wp*spacing, hole%md_top, profile%md(1))
               lower = min(profile%md(i) + 0.5_wp*spacing, hole%md_bottom, profile%md(size(depths)))
               if (.not. lower > upper) cycle
               groove%md = profile%md(i)
               groove%hole = hole_section_at(model%holes, depths(i))
               groove%side_force = (value_at(force, lower) - value_at(force, upper))/(lower - upper)
               groove%volume = hole%wear_factor*load_case%angular_speed*load_case%hours*hour* &
                               (value_at(work, lower) - value_at(work, upper))/(lower - upper)
               part = component_at(tops, bit - depths(i))
               call set_strength(hole, 0.5_wp*contact_diameter(string%components(part), bit - tops(part)), groove)
            end associate
            count = count + 1
            grooves(count) = groove
         end do
      end associate
      grooves = grooves(:count)
   contains
      !> A sum at a depth, linear between rows.
      pure function value_at(sums, md) result(value)
         real(wp), intent(in) :: sums(:)
         real(wp), intent(in) :: md      !< [m]
         real(wp) :: value
         integer :: low, high, middle
         low = 1
         high = size(sums)
         do while (high - low > 1)
            middle = (low + high)/2
            if (result%profile%md(middle) <= md) then
               low = middle
            else
               high = middle
            end if
         end do
         value = sums(low)
         associate (length => result%profile%md(high) - result%profile%md(low))
            if (length > 0.0_wp) value = value + (md - result%profile%md(low))/length*(sums(high) - sums(low))
         end associate
      end function value_at
   end subroutine find_casing_wear

   !> Depth of a groove from its volume, and the strengths that are left.
   pure subroutine set_strength(hole, radius, groove)
      type(hole_section_type), intent(in) :: hole
      real(wp), intent(in) :: radius       !< of the joint [m]
      type(groove_type), intent(inout) :: groove
      type(component_type) :: casing
      real(wp) :: wall
      groove%present = .true.
      wall = 0.5_wp*(hole%casing_od - hole%diameter)
      groove%depth = groove_depth(groove%volume, 0.5_wp*hole%diameter, radius, wall)
      groove%used = groove%volume/crescent_area(wall, 0.5_wp*hole%diameter, radius)
      groove%wall_left = 1.0_wp - groove%depth/wall
      groove%burst = missing
      groove%collapse = missing
      if (is_missing(hole%casing_yield)) return
      casing%yield = hole%casing_yield
      casing%od = hole%casing_od
      casing%id = hole%casing_od - 2.0_wp*wall*groove%wall_left
      groove%burst = burst_strength(casing)
      groove%collapse = 0.0_wp
      if (groove%depth < wall) groove%collapse = collapse_strength(casing, 0.0_wp)
   end subroutine set_strength

   !> The groove that is nearest to going through its wall or furthest beyond, not present if there are no grooves.
   pure function worst_groove(grooves) result(worst)
      type(groove_type), intent(in) :: grooves(:)
      type(groove_type) :: worst
      if (size(grooves) > 0) worst = grooves(maxloc(grooves%used, dim=1))
   end function worst_groove

   !> Area between the bore and a joint in a groove: the joint's circle less its part within the bore [m2].
   pure function crescent_area(depth, bore, radius) result(area)
      real(wp), intent(in) :: depth    !< of the groove [m]
      real(wp), intent(in) :: bore     !< radius of the casing inside [m]
      real(wp), intent(in) :: radius   !< of the joint, < bore [m]
      real(wp) :: area
      real(wp) :: apart, short, chord
      area = 0.0_wp
      if (.not. depth > 0.0_wp) return
      apart = bore - radius + depth                            ! the two axes
      short = 0.5_wp*depth*(2.0_wp*radius - depth)/apart       ! bore less the chord's distance from the casing's axis
      if (short >= 2.0_wp*bore .or. depth >= 2.0_wp*radius) then
         area = pi*radius**2
         return
      end if
      chord = sqrt(short*(2.0_wp*bore - short))                ! half of it
      area = radius**2*segment(atan2(chord, bore - short - apart)) - bore**2*segment(atan2(chord, bore - short))
   end function crescent_area

   !> Area of a circular segment over the square of the radius, by half its angle [rad].
   pure function segment(angle) result(area)
      real(wp), intent(in) :: angle
      real(wp) :: area
      area = angle - sin(angle)*cos(angle)
      if (angle < small) area = angle**3*(2.0_wp/3.0_wp - 2.0_wp/15.0_wp*angle**2)
   end function segment

   !> Depth of the groove of a given volume [m], at most the wall.
   pure function groove_depth(volume, bore, radius, wall) result(depth)
      real(wp), intent(in) :: volume         !< worn off per length [m2]
      real(wp), intent(in) :: bore, radius   !< of casing and joint [m]
      real(wp), intent(in) :: wall           !< > 0 [m]
      real(wp) :: depth
      type(bracket_type) :: bracket
      depth = 0.0_wp
      if (.not. volume > 0.0_wp) return
      depth = wall
      if (volume >= crescent_area(wall, bore, radius)) return
      bracket = new_bracket(0.0_wp, volume, wall, volume - crescent_area(wall, bore, radius))
      do while (.not. is_narrow(bracket, narrowness*wall))
         depth = next_try(bracket, narrowness*wall)
         call narrow(bracket, depth, volume - crescent_area(depth, bore, radius))
      end do
      depth = 0.5_wp*(bracket%low + bracket%high)
   end function groove_depth
end module dg_casing_wear

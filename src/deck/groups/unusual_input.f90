!> Notes on legal but unusual numbers of a deck: mostly another unit, or a missing value. Each has one note with the number,
!> its place, and the usual range.
module dg_unusual_input
   use dg_kinds, only: wp
   use dg_constants, only: degree, foot, inch
   use dg_component, only: component_type, has_joints, is_bit, is_pipe, opens
   use dg_contact_friction, only: axial_friction
   use dg_deck_draft, only: draft_fluid_type, draft_hole_type, draft_type, lowest_of, string_use_type
   use dg_load_case, only: moves_axially, operation_static, rotates
   use dg_meant_units, only: deepest_model
   use dg_missing, only: is_missing
   use dg_model, only: hold_free, packer_hold_name
   use dg_unusual_survey, only: note_survey
   use dg_text, only: append_text, lower_case, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_diameter, unit_label, unit_length
   use dg_units, only: unit_system_type
   use dg_unusual_case, only: air_weight, note_case, note_light, note_temperatures, note_use
   use dg_unusual_component, only: holds_any, note_component, note_joint, note_place, note_twice
   use dg_unusual_tool, only: note_tool_shapes
   use dg_usual_range, only: is_unusual, note_range, usual_block, usual_casing_yield, usual_deep_wall, usual_density, &
                             usual_friction, usual_gravity, usual_hole, usual_hookload, usual_running_in, usual_surface, &
                             usual_top_drive, usual_wall, usual_wear
   implicit none
   private
   public :: note_unusual, holes_in_inches, inches_meant, largest_pressure

   !> Longest pipe that stands at a bit below collars [m].
   real(wp), parameter :: longest_bha_pipe = 100.0_wp
   !> Widest drilled hole, 36 in, if its number of inches is read as millimetres [m].
   real(wp), parameter :: widest_of_inches = 36.5e-3_wp
   !> Lightest mud in kg/m3, a foam.
   real(wp), parameter :: lightest_mud = 300.0_wp
   !> Advice on a deck with such holes.
   character(*), parameter :: inches_meant = "are these inches? Write units = 'metric' or 'field' in &job"
   !> Longest gap of air above a riser [m].
   real(wp), parameter :: longest_air_gap = 100.0_wp
   !> A string that is longer than the hole by more than this [m].
   real(wp), parameter :: above_surface = 1.0_wp
   !> Longest collars of a string [m]: 30 to 40 joints.
   real(wp), parameter :: longest_collars = 500.0_wp
   !> Friction in casing over that of open hole, above which the two may be swapped [-]. Fits of measured wells have up to 1.4.
   real(wp), parameter :: rougher = 1.6_wp
   !> Part by which a ratio of depths may differ from that of metre and foot [-]: the deepest bit is seldom at the last station.
   real(wp), parameter :: as_feet = 0.02_wp
   !> Outside diameters of casing that no usual casing has inside [m]. Others are both: 7 5/8 in comes with 6 5/8 in inside,
   !> 9 7/8 in with 8 5/8 in, 22 in with 20 in. Diameters in mm have round-off [m].
   real(wp), parameter :: casing_sizes(*) = inch*[4.5_wp, 5.0_wp, 7.0_wp, 9.625_wp, 10.75_wp, 11.75_wp, 13.375_wp, 16.0_wp, &
                                                18.625_wp], as_size = 0.15e-3_wp
   !> Deepest soft ground [m], and inclination at surface of crossings, which stay in it [rad].
   real(wp), parameter :: deepest_soil = 1000.0_wp, of_crossing = 30.0_wp*degree
   integer, parameter :: digits = 4, depth_digits = 6

contains

   !> Adds a note for each matter.
   subroutine note_unusual(draft, uses, fitted, notes)
      type(draft_type), intent(in) :: draft
      type(string_use_type), intent(in) :: uses(:)     !< of strings, beside those of load cases
      logical, intent(in) :: fitted       !< a study of the deck finds the friction
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      call note_survey(draft, notes)
      call note_survey_in_feet(draft, uses, notes)
      if (size(draft%fluids) == 0) call append_text(notes, 'There is no &fluid: the string is weighed in air. Mud takes '// &
                                                    'about 15 % off its weight')
      do i = 1, size(draft%fluids)
         call note_fluid(draft, draft%fluids(i), deepest_bit(draft, uses), notes)
      end do
      if (.not. fitted) call note_friction(draft, notes)
      do i = 1, size(draft%holes)
         call note_hole_friction(draft, draft%holes(i), fitted, notes)
         call note_wall(draft, draft%holes(i), notes)
         if (.not. is_air_gap(draft, i)) &
            call note_range(draft%units, hole_text(draft%holes(i)), usual_hole, draft%holes(i)%section%diameter, notes)
      end do
      do i = 1, size(uses)
         call note_use(draft%units, uses(i), air_weight(draft, uses(i)%string, uses(i)%depth), notes)
      end do
      do i = 1, size(draft%components)
         call note_component(draft%units, draft%components(i), notes)
      end do
      call note_order(draft, notes)
      call note_length(draft, notes)
      call note_collars(draft, notes)
      call note_cased(draft, notes)
      call note_tool_shapes(draft, notes)
      call note_place(draft, notes)
      call note_twice(draft, notes)
      call note_joint(draft, notes)
      if (draft%rig%given .and. draft%rig%max_hookload%present .and. .not. draft%block_given) &
         call append_text(notes, 'group &rig: max_hookload includes the block, and block_weight is not given. Give it, or 0 '// &
                          'for a limit without block')
      call note_range(draft%units, 'group &rig', usual_block, draft%rig%block_weight, notes)
      if (draft%rig%max_hookload%present) call note_range(draft%units, 'group &rig', usual_hookload, draft%rig%max_hookload%value, &
                                                          notes)
      if (draft%rig%max_torque%present) &
         call note_range(draft%units, 'group &rig', usual_top_drive, draft%rig%max_torque%value, notes)
      call note_range(draft%units, 'group &job', usual_gravity, draft%gravity, notes)
      if (draft%boundary%packer_hold /= hold_free .and. .not. any(draft%cases%load_case%length_reference > 0)) &
         call append_text(notes, 'group &boundary: packer_hold = '//quoted(trim(packer_hold_name(draft%boundary%packer_hold)))// &
                          ' holds the string in load cases with length_reference, and none has one. Give it the case in '// &
                          'which the packer was set')
      call note_temperatures(draft%units, draft%cases%load_case, notes)
      do i = 1, size(draft%cases)
         associate (case => draft%cases(i)%load_case)
            call note_case(draft%units, trim(draft%cases(i)%what)//' '//quoted(case%name), case, draft%cases(i)%line_tob > 0, &
                           air_weight(draft, case%string, case%bit_depth), notes)
         end associate
      end do
   end subroutine note_unusual

   !> One fluid: its numbers, and a density that is left out where the string is weighed in it.
   subroutine note_fluid(draft, item, deepest, notes)
      type(draft_type), intent(in) :: draft
      type(draft_fluid_type), intent(in) :: item
      real(wp), intent(in) :: deepest     !< bit of all cases and studies [m]
      type(text_type), allocatable, intent(inout) :: notes(:)
      associate (fluid => item%fluid, what => 'group &fluid in line '//to_text(item%line))
         if (fluid%outside .and. .not. item%density_given) call append_text(notes, what//' has no density: the string is '// &
            'weighed in air. Give density, or density = 0 for air')
         call note_range(draft%units, 'group &fluid', usual_density, fluid%density, notes)
         call note_range(draft%units, 'group &fluid', usual_surface, fluid%surface_pressure, notes)
         if (fluid%density > 0.0_wp .and. .not. (fluid%inside .and. fluid%outside)) &
            call note_light(draft%units, what//': density', fluid%density, largest_pressure(draft), notes)
         if (fluid%above_bit > 0.0_wp .and. fluid%above_bit >= deepest) &
            call append_text(notes, 'group &fluid: above_bit = '//in_units(draft%units, unit_length, fluid%above_bit, &
            depth_digits)//' is longer than any string in the hole, so that this fluid fills all of it'// &
            feet_question(draft%units, fluid%above_bit, deepest))
         if (fluid%md_top >= draft%stations%md(size(draft%stations%md))) call append_text(notes, 'group &fluid: md_top = '// &
            in_units(draft%units, unit_length, fluid%md_top, depth_digits)//' is below the hole, so that this fluid '// &
            'is nowhere. Give the depth where it begins')
      end associate
   end subroutine note_fluid

   !> Largest pressure of pump, annulus and surface [Pa].
   pure function largest_pressure(draft) result(pressure)
      type(draft_type), intent(in) :: draft
      real(wp) :: pressure
      pressure = 0.0_wp
      if (size(draft%cases) > 0) pressure = max(maxval(draft%cases%load_case%pump_pressure), &
                                                maxval(draft%cases%load_case%annulus_pressure))
      if (size(draft%fluids) > 0) pressure = max(pressure, maxval(draft%fluids%fluid%surface_pressure))
   end function largest_pressure

   !> True if all hole diameters in millimetres are too small for a well, and the hole is deeper than a laboratory model.
   pure function holes_in_inches(draft) result(inches)
      type(draft_type), intent(in) :: draft
      logical :: inches
      inches = .false.
      if (size(draft%holes) == 0 .or. unit_label(draft%units, unit_diameter) /= 'mm') return
      if (.not. (draft%has_stations .and. all(draft%holes%sound))) return
      inches = all(draft%holes%section%diameter < widest_of_inches) .and. &
               draft%stations%md(size(draft%stations%md)) > deepest_model
      ! a string in mm and mud in kg/m3 are those of SI: the holes alone are wrong
      if (inches .and. any(draft%fluids%fluid%density > lightest_mud)) &
         inches = all(draft%components%component%od < widest_of_inches)
   end function holes_in_inches

   !> Hole sections without any friction that a moving case relies on.
   subroutine note_friction(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, k
      do k = 1, size(draft%cases)
         if (draft%cases(k)%load_case%operation == operation_static .or. &
             draft%cases(k)%load_case%friction_axial%present) cycle
         do i = 1, size(draft%holes)
            associate (hole => draft%holes(i))
               if (is_air_gap(draft, i)) cycle
               if (hole%friction_given .or. axial_friction(hole%section, draft%cases(k)%load_case%operation) > 0.0_wp .or. &
                   hole%section%md_top >= draft%cases(k)%load_case%bit_depth) cycle
               call append_text(notes, 'group &hole in line '//to_text(hole%line)//': '//quoted(hole%section%name)// &
                                ' has no friction. Drag and torque there are zero. Give friction')
            end associate
         end do
         return
      end do
   end subroutine note_friction

   !> True for the uppermost section where it is short and wider than the one below: the air above a riser, where no wall is.
   pure function is_air_gap(draft, number) result(is)
      type(draft_type), intent(in) :: draft
      integer, intent(in) :: number         !< of the section
      logical :: is
      is = number == 1 .and. size(draft%holes) > 1
      if (is) is = draft%holes(1)%section%md_bottom < longest_air_gap .and. &
                   draft%holes(1)%section%diameter > draft%holes(2)%section%diameter
   end function is_air_gap

   !> Friction that is far from what was measured anywhere, and a section that lets a string turn without any.
   subroutine note_hole_friction(draft, hole, fitted, notes)
      type(draft_type), intent(in) :: draft
      type(draft_hole_type), intent(in) :: hole
      logical, intent(in) :: fitted       !< a study of the deck finds the friction
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: what
      what = hole_text(hole)
      associate (axial => hole%section%friction_axial, rotary => hole%section%friction_rotary, &
                 running_in => hole%section%friction_running_in)
         if (axial > 0.0_wp) call note_range(draft%units, what, usual_friction, axial, notes)
         if (rotary > 0.0_wp .and. abs(rotary - axial) > 0.0_wp) call note_range(draft%units, what, usual_friction, rotary, notes)
         if (.not. is_missing(running_in)) then
            if (running_in > 0.0_wp) call note_range(draft%units, what, usual_running_in, running_in, notes)
         end if
         if (axial > 0.0_wp .and. .not. rotary > 0.0_wp .and. any(rotates(draft%cases%load_case%operation))) &
            call append_text(notes, what//' has no friction_rotary, so that torque there is zero. Give it, or friction for both')
         if (rotary > 0.0_wp .and. .not. (axial > 0.0_wp .or. fitted) .and. is_missing(running_in) .and. &
             any(moves_axially(draft%cases%load_case%operation) .and. .not. draft%cases%load_case%friction_axial%present)) &
            call append_text(notes, what//' has no friction_axial, so that drag there is zero. Give it, or friction for both')
      end associate
   end subroutine note_hole_friction

   !> Stiffness and wear of the wall of a section, and the size of a casing in place of its inside.
   subroutine note_wall(draft, hole, notes)
      type(draft_type), intent(in) :: draft
      type(draft_hole_type), intent(in) :: hole
      type(text_type), allocatable, intent(inout) :: notes(:)
      logical :: hard
      associate (wall => hole%section)
         if (.not. is_missing(wall%casing_yield)) &
            call note_range(draft%units, hole_text(hole), usual_casing_yield, wall%casing_yield, notes)
         hard = wall%cased .or. (wall%md_bottom > deepest_soil .and. draft%stations%inclination(1) < of_crossing)
         if (wall%wall_stiffness > 0.0_wp) call note_range(draft%units, hole_text(hole), merge(usual_deep_wall, usual_wall, &
            hard .and. .not. is_unusual(usual_wall, wall%wall_stiffness)), wall%wall_stiffness, notes)
         if (.not. is_missing(wall%wear_factor)) call note_range(draft%units, hole_text(hole), usual_wear, wall%wear_factor, notes)
         if (.not. (wall%cased .or. holds_any(wall%name, [character(6) :: 'casing', 'liner', 'csg']))) return
         if (holds_any(wall%name, [character(5) :: 'open', 'below', 'riser'])) return
         ! a casing_od says that the two are known
         if (.not. is_missing(wall%casing_od) .or. all(abs(wall%diameter - casing_sizes) > as_size)) return
         call append_text(notes, hole_text(hole)//': diameter = '// &
                          in_units(draft%units, unit_diameter, wall%diameter, depth_digits)// &
                          ' is the outside diameter of a casing. The hole needs its inside diameter')
      end associate
   end subroutine note_wall

   function hole_text(hole) result(text)
      type(draft_hole_type), intent(in) :: hole
      character(:), allocatable :: text
      text = 'group &hole in line '//to_text(hole%line)//': '//quoted(hole%section%name)
   end function hole_text

   !> A bit above other components of its string, or drill pipe at the bit below collars: the string is listed from the top.
   subroutine note_order(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components))
      integer :: i, k
      lowest = lowest_of(draft)
      do i = 2, size(draft%components)
         associate (item => draft%components(i))
            if (.not. is_bit(item%component) .or. opens(item%component) .or. lowest(i) == i) cycle
            call append_text(notes, 'group &component in line '//to_text(item%line)//': bit '//quoted(item%component%name)// &
                             ' stands above '//quoted(draft%components(lowest(i))%component%name)// &
                             '. List components from the bit upwards')
         end associate
      end do
      do i = 1, size(draft%components)
         if (.not. is_long_pipe(draft%components(i)%component)) cycle
         if (any(lowest(:i - 1) == lowest(i) .and. .not. is_bit(draft%components(:i - 1)%component))) cycle
         do k = i + 1, size(draft%components)
            if (lowest(k) /= lowest(i) .or. index(lower_case(draft%components(k)%component%kind), 'collar') == 0) cycle
            ! with pipe above the collars, too, the string is inverted on purpose
            if (any(lowest(k:) == lowest(i) .and. is_long_pipe_to_surface(draft%components(k:)%component))) exit
            call append_text(notes, 'group &component in line '//to_text(draft%components(i)%line)//': drill pipe '// &
                             quoted(draft%components(i)%component%name)//' stands at the bit, collars '// &
                             quoted(draft%components(k)%component%name)//' above it. List components from the bit upwards')
            exit
         end do
      end do

   contains

      elemental function is_long_pipe(part) result(is)
         type(component_type), intent(in) :: part
         logical :: is
         is = has_joints(part) .and. is_pipe(part) .and. part%length > longest_bha_pipe
      end function is_long_pipe
      elemental function is_long_pipe_to_surface(part) result(is)
         type(component_type), intent(in) :: part
         logical :: is
         is = is_pipe(part) .and. (part%length > longest_bha_pipe .or. .not. part%length > 0.0_wp)
      end function is_long_pipe_to_surface
   end subroutine note_order

   !> A string longer than the hole, whose last component has a length.
   subroutine note_length(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components))
      real(wp) :: length, depth
      integer :: i
      depth = draft%stations%md(size(draft%stations%md))
      lowest = lowest_of(draft)
      do i = 1, size(draft%components)
         if (any(lowest(i + 1:) == lowest(i)) .or. .not. draft%components(i)%component%length > 0.0_wp) cycle
         length = sum(draft%components%component%length, mask=lowest == lowest(i))
         if (length <= depth + above_surface) cycle
         call append_text(notes, 'String '//quoted(draft%components(i)%string)//' is '// &
                          in_units(draft%units, unit_length, length, depth_digits)//' long, the hole ends at '// &
                          in_units(draft%units, unit_length, depth, depth_digits)// &
                          '. What stands above surface is left out. Leave out the length of the last component')
      end do
   end subroutine note_length

   !> More drill collars than any string has.
   subroutine note_collars(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components)), i
      real(wp) :: length
      logical :: collar(size(draft%components))
      lowest = lowest_of(draft)
      collar = [(index(lower_case(draft%components(i)%component%kind), 'collar') > 0, i=1, size(collar))]
      do i = 1, size(draft%components)
         if (lowest(i) /= i) cycle
         length = sum(draft%components%component%length, mask=collar .and. lowest == i)
         if (length > longest_collars) call append_text(notes, 'String '//quoted(draft%components(i)%string)//' has '// &
            in_units(draft%units, unit_length, length, digits)//' of collars. Usual is at most '// &
            in_units(draft%units, unit_length, longest_collars, digits)//'. Is a length mistyped?')
      end do
   end subroutine note_collars

   !> A cased section below an open one, or rougher than one below it. What has no friction, as the gap above a riser, is not open.
   subroutine note_cased(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, k
      do i = 2, size(draft%holes)
         if (.not. draft%holes(i)%section%cased .or. draft%holes(i - 1)%section%cased .or. &
             .not. draft%holes(i - 1)%section%friction_axial > 0.0_wp) cycle
         call append_text(notes, 'group &hole in line '//to_text(draft%holes(i)%line)//': '// &
            quoted(draft%holes(i)%section%name)//' is cased, '//quoted(draft%holes(i - 1)%section%name)// &
            ' above it is not. Give cased = .true. above, too, or leave it out')
         exit
      end do
      do i = 1, size(draft%holes)
         if (.not. draft%holes(i)%section%cased) cycle
         do k = i + 1, size(draft%holes)
            associate (cased => draft%holes(i)%section, open => draft%holes(k)%section)
               if (open%cased .or. .not. open%friction_axial > 0.0_wp .or. &
                   cased%friction_axial <= rougher*open%friction_axial) cycle
               call append_text(notes, 'group &hole in line '//to_text(draft%holes(i)%line)//': friction = '// &
                  to_text(cased%friction_axial, digits)//' in casing is above '//to_text(open%friction_axial, digits)// &
                  ' of open hole '//quoted(open%name)//'. Are the two swapped?')
               return
            end associate
         end do
      end do
   end subroutine note_cased

   !> Deepest bit of all cases and studies [m].
   pure function deepest_bit(draft, uses) result(depth)
      type(draft_type), intent(in) :: draft
      type(string_use_type), intent(in) :: uses(:)
      real(wp) :: depth
      depth = draft%stations%md(size(draft%stations%md))
      if (size(draft%cases) + size(uses) == 0) return
      depth = 0.0_wp
      if (size(draft%cases) > 0) depth = maxval(draft%cases%load_case%bit_depth)
      if (size(uses) > 0) depth = max(depth, maxval(uses%depth))
   end function deepest_bit

   !> A survey that ends as many times deeper than bit and hole as a metre has feet. A hole that ends with the survey does so by
   !> default.
   subroutine note_survey_in_feet(draft, uses, notes)
      type(draft_type), intent(in) :: draft
      type(string_use_type), intent(in) :: uses(:)
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: last, deepest
      last = draft%stations%md(size(draft%stations%md))
      deepest = max(deepest_bit(draft, uses), maxval(draft%holes%section%md_top), &
                    maxval(draft%holes%section%md_bottom, mask=draft%holes%has_bottom))
      if (abs(last*foot - deepest) > as_feet*deepest .or. .not. in_metres(draft%units)) return
      call append_text(notes, 'group &trajectory: the survey ends at '//in_units(draft%units, unit_length, last, depth_digits)// &
                       ', '//to_text(last/deepest, digits)//' times as deep as bit and hole. Is it in ft? In a file write '// &
                       "survey_units = 'field'. In the deck write md in m: "//to_text(last*foot, digits)//' at its end')
   end subroutine note_survey_in_feet

   !> True for depths in metres.
   pure function in_metres(units) result(are)
      type(unit_system_type), intent(in) :: units
      logical :: are
      are = abs(units%length - 1.0_wp) < as_feet
   end function in_metres

   !> Question for feet where a length in metres is too long, and not so in feet; '' for others.
   function feet_question(units, length, longest) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: length, longest      !< [m]
      character(:), allocatable :: text
      text = ''
      if (in_metres(units) .and. length*foot < longest) &
         text = '. Is it in ft? Then write '//to_text(length*foot, digits)
   end function feet_question
end module dg_unusual_input

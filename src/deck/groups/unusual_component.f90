!> Notes on legal but unusual components: mostly another unit, or a missing value. Each has one note with the number, its place,
!> and the usual range.
module dg_unusual_component
   use dg_kinds, only: wp
   use dg_component, only: component_type, effective_joint_length, has_joints, is_bit, is_coiled_tubing, is_hwdp, is_pipe, &
                           tube_area
   use dg_deck_draft, only: draft_component_type, draft_type, lowest_of
   use dg_fatigue_curve, only: fatigue_s135
   use dg_likely_unit, only: unit_questions
   use dg_missing, only: is_missing
   use dg_string_check, only: widest_blades
   use dg_text, only: append_text, edit_distance, lower_case, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_density, unit_diameter, unit_factor, unit_length, unit_mass, unit_modulus, unit_moment, &
                           unit_stress
   use dg_units, only: unit_system_type
   use dg_usual_range, only: is_unusual, note_range, usual_bend, usual_centralizers, usual_compression, usual_fatigue, &
                             usual_joint_fatigue, usual_joint_id, usual_joint_length, usual_joint_spacing, usual_joint_torsion, &
                             usual_joint_yield, usual_makeup, usual_restoring, usual_running_force, usual_tensile, usual_tension, &
                             usual_yield
   implicit none
   private
   public :: holds_any, is_nominal_mass, note_component, note_joint, note_place, note_twice

   !> Longest solid bar among drill tools [m].
   real(wp), parameter :: longest_bar = 5.0_wp
   !> Part of the mass of a pipe that its tool joints add [-]: couplings of tubing add less.
   real(wp), parameter :: least_of_joints = 0.08_wp, round_off = 1.0e-9_wp
   !> Largest mass over that of the tube, of pipe with tool joints, that is the nominal weight of a catalogue and not its mass [-].
   !> Nominal weight is 1.03 to 1.09 of the tube, true mass 1.12 to 1.35.
   real(wp), parameter :: nominal = 1.095_wp
   !> Least mass of joints over that of the tube, by which nominal weights are too small [-]: couplings have less.
   real(wp), parameter :: heavy_joints = 0.11_wp
   !> Diameters of drill pipe [m]: 3 1/2 to 6 5/8 in; nominal weights of tubing, up to 4 in, are true ones.
   real(wp), parameter :: thinnest = 0.088_wp, thickest = 0.17_wp, thickest_tubing = 0.102_wp
   !> Least bore of pipe over its outside diameter, and a usual one [-]: heavy weight pipe has 0.59, collars without a kind 0.25.
   real(wp), parameter :: least_bore = 0.22_wp, usual_bore = 0.5_wp
   !> Young's modulus and density of light alloys [Pa, kg/m3]: aluminium has 72e9 and 2800, titanium 114e9 and 4430.
   real(wp), parameter :: soft_metal = 90.0e9_wp, light_metal = 5500.0_wp, stiff_metal = 170.0e9_wp
   !> Least yield strength of pipe with the fatigue curve of S135 [Pa]: 135 ksi less what a catalogue rounds off.
   real(wp), parameter :: least_s135 = 900.0e6_wp
   !> Longest tool [m]: collars with a logging tool have 60.
   real(wp), parameter :: longest_tool = 150.0_wp
   !> Shortest string of pipe without joints that is unusual [m].
   real(wp), parameter :: shortest_pipe = 300.0_wp
   !> Words in the kinds of tools, which do not go up to surface.
   character(*), parameter :: tools(*) = [character(8) :: 'bit', 'motor', 'mwd', 'lwd', 'stab', 'jar', 'reamer', 'rss', 'steer', &
                                          'turbine', 'sensor', 'collar']
   !> Words in the kinds of tools that no string has twice in a row.
   character(*), parameter :: lone_tools(*) = [character(7) :: 'motor', 'turbine', 'mwd', 'rss']
   !> Shortest kind that may have two letters wrong, and kinds that are meant so.
   integer, parameter :: long_kind = 5
   character(*), parameter :: meant_so(*) = [character(8) :: 'coring', 'turbine', 'roller', 'collet']
   !> Difference of one joint from the distance of joints [-]: joints of range 2 have 30 to 32 ft.
   real(wp), parameter :: one_joint = 0.05_wp
   integer, parameter :: digits = 4

contains

   !> Numbers and kind of a component.
   subroutine note_component(units, item, notes)
      type(unit_system_type), intent(in) :: units
      type(draft_component_type), intent(in) :: item
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: what, question, of_springs
      what = part_text(item)
      of_springs = 'group &centralizer of '//quoted(item%component%name)
      associate (part => item%component)
         if (part%yield > 0.0_wp) call note_range(units, what, usual_yield, part%yield, notes)
         if (item%joint_yield > 0.0_wp) call note_range(units, what, usual_joint_yield, item%joint_yield, notes)
         if (part%joint_id > 0.0_wp) call note_range(units, what, usual_joint_id, part%joint_id, notes)
         if (part%fatigue%limit > 0.0_wp) call note_range(units, what, usual_fatigue, part%fatigue%limit, notes)
         if (part%fatigue%tensile > 0.0_wp) call note_range(units, what, usual_tensile, part%fatigue%tensile, notes)
         if (part%joint_fatigue%limit > 0.0_wp) call note_range(units, what, usual_joint_fatigue, part%joint_fatigue%limit, notes)
         if (item%makeup_given) call note_range(units, what, usual_makeup, part%makeup_torque, notes)
         if (item%torsion_given) call note_range(units, what, usual_joint_torsion, part%joint_torsion, notes)
         call note_range(units, of_springs, usual_restoring, part%centralizer%restoring_force, notes)
         call note_range(units, of_springs, usual_running_force, part%centralizer%running_force, notes)
         if (part%centralizer%present .and. is_casing(part)) &
            call note_range(units, of_springs, usual_centralizers, part%centralizer%spacing, notes)
         if (nearly_kind(part%kind) /= '') call append_text(notes, what//': kind = '//quoted(part%kind)// &
            ' is not known. Did you mean '//quoted(nearly_kind(part%kind))//'?')
         if (has_joints(part)) then
            if (.not. is_rod(part)) call note_range(units, what, usual_joint_spacing, part%joint_spacing, notes)
            call note_range(units, what, usual_joint_length, part%joint_length, notes)
         end if
         if (part%bend > 0.0_wp) call note_range(units, what, usual_bend, part%bend, notes)
         if (.not. is_missing(part%rating%tension)) call note_range(units, what, usual_tension, part%rating%tension, notes)
         if (.not. is_missing(part%rating%compression)) &
            call note_range(units, what, usual_compression, part%rating%compression, notes)
         if (part%fatigue%curve == fatigue_s135 .and. part%yield > 0.0_wp .and. part%yield < least_s135) &
            call append_text(notes, what//': fatigue_curve = ''S135'' is of stronger pipe than yield = '// &
                             in_units(units, unit_stress, part%yield, digits)//". Write 'E75', or 'own' with fatigue_limit")
         question = ''
         if (part%joint_od > widest_blades*part%od) question = unit_questions(units, unit_diameter, part%od/units%diameter, &
            part%joint_od/widest_blades, part%joint_od, digits, 'od')
         if (question /= '') call append_text(notes, what//': od = '//in_units(units, unit_diameter, part%od, digits)// &
            ' is small for joint_od = '//in_units(units, unit_diameter, part%joint_od, digits)//question)
         if (part%joint_torsion > 0.0_wp .and. part%makeup_torque > part%joint_torsion .and. &
             .not. is_unusual(usual_makeup, part%makeup_torque)) call append_text(notes, what// &
            ': makeup_torque is above joint_torsion, '//in_units(units, unit_moment, part%joint_torsion, digits)// &
            ': its joints would yield in make-up')
         if (lacks_joints(part)) call append_text(notes, what//': without mass it weighs '// &
            in_units(units, unit_mass, part%mass, digits)//', as a tube without tool joints. Give mass, joints counted in')
         if (is_plain(item)) call append_text(notes, what//': without joint_od and mass it is plain pipe. Tool joints add '// &
                                              '12 to 35 % to its mass. Give both, or a name of the catalogue. '// &
                                              "Pipe without joints needs its kind, as 'casing'")
         if (item%mass_given .and. is_nominal_mass(part, part%mass)) call append_text(notes, what//': mass = '// &
            in_units(units, unit_mass, part%mass, digits)// &
            ' is little more than its tube has. Is it the nominal weight? Give the mass with tool joints, or a name of the '// &
            'catalogue')
         if (is_pipe(part) .and. part%id > 0.0_wp .and. part%id < least_bore*part%od) call append_text(notes, what//': id = '// &
            in_units(units, unit_diameter, part%id, digits)//' leaves a wall of '// &
            in_units(units, unit_diameter, 0.5_wp*(part%od - part%id), digits)// &
            unit_questions(units, unit_diameter, part%id/units%diameter, usual_bore*part%od, part%od, digits)// &
            '. Is id the wall? Then write id = '// &
            to_text((part%od - 2.0_wp*part%id)/unit_factor(units, unit_diameter), digits))
         if ((part%youngs < soft_metal .and. part%density > light_metal) .or. &
             (part%youngs > stiff_metal .and. part%density < light_metal)) &
            call append_text(notes, what//': youngs = '//to_text(part%youngs/unit_factor(units, unit_modulus), digits)// &
               ' and density = '//in_units(units, unit_density, part%density, digits)//' are of two materials. Give both')
         if (part%id > 0.0_wp .or. item%mass_given .or. (part%length > 0.0_wp .and. part%length <= longest_bar)) return
         if (index(lower_case(part%kind), 'rod') > 0 .or. index(lower_case(part%kind), 'bar') > 0) return
         call append_text(notes, what//' is a solid bar of '//in_units(units, unit_mass, part%mass, digits)// &
                          ', as it has no id and no mass. Give the inside diameter')
      end associate
   end subroutine note_component

   !> True for casing and liner. Guides of rods and protectors of drill pipe stand closer.
   pure function is_casing(part) result(is)
      type(component_type), intent(in) :: part
      logical :: is
      is = holds_any(part%kind, [character(6) :: 'casing', 'liner'])
   end function is_casing

   !> True for rods, which are as short as 1.5 m.
   pure function is_rod(part) result(is)
      type(component_type), intent(in) :: part
      logical :: is
      is = index(lower_case(part%kind), 'rod') > 0 .or. index(lower_case(part%kind), 'coring') > 0
   end function is_rod

   !> A tool of the length of pipe, or one without a length that goes up to surface.
   subroutine note_place(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components)), i
      lowest = lowest_of(draft)
      do i = 1, size(draft%components)
         associate (item => draft%components(i), part => draft%components(i)%component)
            if (.not. is_tool(part%kind)) cycle
            if (part%length > longest_tool .and. index(lower_case(part%kind), 'collar') == 0) then
               call append_text(notes, part_text(item)//' is '//in_units(draft%units, unit_length, part%length, digits)// &
                                ' long. Usual for a tool is at most '//in_units(draft%units, unit_length, longest_tool, digits)// &
                                '. Is a length mistyped?')
            else if (.not. part%length > 0.0_wp .and. any(lowest(:i - 1) == lowest(i)) .and. &
                     .not. any(lowest(i + 1:) == lowest(i))) then
               if (.not. any(draft%components%component%length > shortest_pipe .and. lowest == lowest(i))) cycle
               call append_text(notes, part_text(item)//' has no length, so that it goes up to surface. List components from '// &
                                'the bit upwards, or give its length')
            end if
         end associate
      end do
   end subroutine note_place

   !> Drill pipe as long as one joint, between tools and other pipe, and alone of its size in a long string.
   subroutine note_joint(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components)), i
      if (draft%stations%md(size(draft%stations%md)) < shortest_pipe) return
      lowest = lowest_of(draft)
      associate (parts => draft%components%component)
         do i = 2, size(parts) - 1
            if (any(lowest(i - 1:i + 1) /= lowest(i)) .or. .not. is_one_joint(parts(i))) cycle
            if (is_pipe(parts(i - 1)) .or. .not. is_pipe(parts(i + 1))) cycle
            if (count(lowest == lowest(i) .and. abs(parts%od - parts(i)%od) < round_off) > 1) cycle
            call append_text(notes, part_text(draft%components(i))//' is '// &
               in_units(draft%units, unit_length, parts(i)%length, digits)//' long, and no other part of the string has its '// &
               'od. Is length that of one joint? Give the length of all its joints together')
         end do
      end associate
   end subroutine note_joint

   !> True for drill pipe or heavy weight pipe of one joint. Couplings of tubing are lighter than tool joints.
   elemental function is_one_joint(part) result(is)
      type(component_type), intent(in) :: part
      logical :: is
      is = has_joints(part) .and. abs(part%length - part%joint_spacing) <= one_joint*part%joint_spacing
      if (is .and. .not. is_hwdp(part)) is = index(lower_case(part%kind), 'pipe') > 0 .and. &
                                              added_by_joints(part, effective_joint_length(part)) > heavy_joints
   end function is_one_joint

   !> A bit, or another tool of which a string has one, that stands twice in a row with the same name and numbers: a copy.
   subroutine note_twice(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      do i = 2, size(draft%components)
         associate (item => draft%components(i), before => draft%components(i - 1))
            if (item%string /= before%string .or. item%component%name /= before%component%name .or. &
                item%component%kind /= before%component%kind) cycle
            if (.not. (is_bit(item%component) .or. &
                       holds_any(item%component%kind, lone_tools))) cycle
            if (any(abs(sizes(item%component) - sizes(before%component)) > 0.0_wp)) cycle
            call append_text(notes, part_text(item)//' stands twice in a row, first in line '//to_text(before%line)// &
                             '. Is one a copy? Leave it out')
         end associate
      end do
   contains
      pure function sizes(part) result(numbers)
         type(component_type), intent(in) :: part
         real(wp) :: numbers(5)
         numbers = [part%length, part%od, part%id, part%mass, part%joint_od]
      end function sizes
   end subroutine note_twice

   function part_text(item) result(text)
      type(draft_component_type), intent(in) :: item
      character(:), allocatable :: text
      text = 'group &component in line '//to_text(item%line)//': '//quoted(item%component%name)
   end function part_text

   !> True for the kind of a tool.
   pure function is_tool(kind) result(is)
      character(*), intent(in) :: kind
      logical :: is
      is = holds_any(kind, tools)
   end function is_tool

   !> True if a text holds one of some words, in any letter case.
   pure function holds_any(text, words) result(holds)
      character(*), intent(in) :: text, words(:)
      logical :: holds
      integer :: i
      holds = any([(index(lower_case(text), trim(words(i))) > 0, i=1, size(words))])
   end function holds_any

   !> True for drill pipe whose mass is that of the tube between its tool joints, which would add to it. Their length is known.
   elemental function lacks_joints(part) result(lacks)
      type(component_type), intent(in) :: part
      logical :: lacks
      lacks = .false.
      if (.not. (has_joints(part) .and. part%id > 0.0_wp)) return
      if (.not. (is_hwdp(part) .or. index(lower_case(part%kind), 'pipe') > 0)) return
      lacks = abs(part%mass - part%density*tube_area(part%od, part%id)) < round_off*part%mass .and. &
              added_by_joints(part, part%joint_length) > least_of_joints
   end function lacks_joints

   !> Mass that tool joints add to pipe, over that of the tube [-].
   elemental function added_by_joints(part, length) result(share)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: length          !< of a joint [m]
      real(wp) :: share
      share = length*tube_area(part%joint_od, part%od)/(part%joint_spacing*tube_area(part%od, part%id))
   end function added_by_joints

   !> True for drill pipe to surface that has neither joints nor a mass.
   elemental function is_plain(item) result(is)
      type(draft_component_type), intent(in) :: item
      logical :: is
      associate (part => item%component)
         is = .not. (has_joints(part) .or. item%mass_given) .and. is_pipe(part) .and. .not. is_coiled_tubing(part) .and. &
              part%id > 0.0_wp .and. (part%length > shortest_pipe .or. .not. part%length > 0.0_wp)
         if (is) is = part%od > thinnest .and. part%od < thickest .and. index(lower_case(part%kind), 'drill') > 0
      end associate
   end function is_plain

   !> True for drill pipe with joints for which a mass is near that of its tube.
   elemental function is_nominal_mass(part, mass) result(is)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: mass            !< [kg/m]
      logical :: is
      real(wp) :: tube
      is = has_joints(part) .and. is_pipe(part) .and. index(lower_case(part%kind), 'pipe') > 0 .and. &
           part%od > thickest_tubing .and. part%od < thickest
      if (is) is = added_by_joints(part, effective_joint_length(part)) > heavy_joints
      tube = part%density*tube_area(part%od, part%id)
      if (is) is = mass > tube .and. mass < nominal*tube
   end function is_nominal_mass

   !> The kind that a kind differs from by one letter, or by two with the same first letter; '' for others, which name tools.
   pure function nearly_kind(kind) result(meant)
      character(*), intent(in) :: kind
      character(:), allocatable :: meant
      character(10), parameter :: kinds(*) = [character(10) :: 'drillpipe', 'collar', 'stabilizer', 'casing', 'liner', &
                                                'tubing', 'hwdp']
      character(:), allocatable :: word
      integer :: i, distance, nearest
      meant = ''
      word = lower_case(kind)
      if (any([index(word, 'pipe'), index(word, 'collar'), index(word, 'stab')] > 0)) return
      if (any(word == meant_so)) return
      if (index(word, 'drill ') == 1) word = trim(adjustl(word(7:)))
      nearest = 3
      do i = 1, size(kinds)
         distance = edit_distance(word, trim(kinds(i)))
         if (distance == 0 .or. distance >= nearest) cycle
         if (distance == 2 .and. (len(word) < long_kind .or. word(1:1) /= kinds(i) (1:1))) cycle
         nearest = distance
         meant = trim(kinds(i))
      end do
   end function nearly_kind
end module dg_unusual_component

!> Notes on legal but unlikely input: numbers that look like a mistake of units, and parts that no case uses. The program prints the
!> notes and continues. Ranges that reject a value are in the table of keys (dg_deck_keys).
module dg_deck_notes
   use dg_kinds, only: wp
   use dg_component, only: closed_diameter, component_type, has_bend, has_blades, has_joints, has_pad, is_eccentric, is_open, &
                           opens, tube_area
   use dg_catalogue_pipe, only: find_pipe
   use dg_constants, only: degree, foot, pound
   use dg_deck_draft, only: draft_component_type, draft_type, lowest_of, string_use_type
   use dg_error, only: error_type
   use dg_job, only: job_type, model_mcge, model_mixed, model_name
   use dg_likely_unit, only: mud_question, unit_questions
   use dg_minimum_curvature, only: dogleg_between
   use dg_missing, only: is_missing, missing
   use dg_path_difference, only: find_difference, path_difference_type
   use dg_survey, only: tangent_of
   use dg_text, only: append_text, either, lower_case, quoted, text_type, to_text
   use dg_trajectory, only: interpolation_minimum_curvature, interpolation_spline, new_trajectory, trajectory_type
   use dg_unusual_case, only: is_gas
   use dg_unusual_component, only: holds_any, is_nominal_mass
   use dg_unusual_input, only: largest_pressure
   use dg_unit_kind, only: in_units, unit_curvature, unit_density, unit_diameter, unit_factor, &
                           unit_length, unit_mass, unit_modulus
   use dg_usual_range, only: note_range, usual_slips
   implicit none
   private
   public :: note_oddities

   !> Ratio of hole and string diameters of an unlikely hole: inches or metres among millimetres.
   real(wp), parameter :: widest_hole = 12.0_wp
   !> Mass over that of the tube between od and id. Joints and upsets add up to two fifths (a published example has 1.53). Pounds a
   !> foot are 0.67 of kilogrammes a metre, 0.8 of the tube for jointed pipe. Tools have hollows.
   real(wp), parameter :: least_mass = 0.75_wp, least_pipe_mass = 0.92_wp, most_mass = 1.6_wp
   !> Least mass of motors and other tools over that of their tube [-]: their id is the bore of a rotor or a flow tube.
   real(wp), parameter :: least_tool_mass = 0.5_wp
   character(*), parameter :: hollow(*) = [character(7) :: 'motor', 'turbine', 'rss', 'steer', 'mwd', 'lwd']
   !> Range of Young's moduli of strings [Pa]: glass fibre has 45e9, steel 206e9.
   real(wp), parameter :: softest = 35.0e9_wp, stiffest = 260.0e9_wp
   !> Sharpest bend in tests, coiled tubing in 300 deg/30 m, and a margin [rad/m].
   real(wp), parameter :: sharpest = 310.0_wp*degree/30.0_wp
   !> Lighter than any foam that is pumped [kg/m3]: a specific gravity, or a number of another unit.
   real(wp), parameter :: lightest_mud = 300.0_wp
   !> Deeper than any hole so far [m]: feet among metres.
   real(wp), parameter :: deepest = 16.0e3_wp
   !> For comparison: water [kg/m3] and steel [Pa].
   real(wp), parameter :: water = 1000.0_wp, steel = 206.0e9_wp
   !> Threshold of Eqs. 7-8 above which the contact force that it hides shows in the hook load [-]. In a build of 900 m it is
   !> 1e-4 at this threshold, 2 % at the largest legal one.
   real(wp), parameter :: large_eps_n0 = 0.01_wp
   !> Angle between the directions of a spline and of minimum curvature, above which stations are too sparse for a spline
   !> [rad]. With stations every 9 to 30 m random wells have less in all but sharp bends, and drag differs by 1 to 17 %. With
   !> stations only where the plan changes it is 8 to 44 deg, and drag differs by 17 to 540 %.
   real(wp), parameter :: sparse = 3.0_wp*degree
   !> Least od of bows over the hole that they fill, but for what a hand measures [-].
   real(wp), parameter :: filling = 0.99_wp
   !> Most components with notes.
   integer, parameter :: most_notes = 200
   integer, parameter :: digits = 6, few_digits = 4, angle_digits = 3

contains

   !> Add unusual data of a deck without fault to the notes of its job.
   subroutine note_oddities(draft, job, uses)
      type(draft_type), intent(in) :: draft
      type(job_type), intent(inout) :: job
      type(string_use_type), intent(in) :: uses(:)     !< of strings, beside those of load cases
      real(wp), dimension(size(draft%components)) :: deepest_bit, below
      real(wp) :: narrowest, pressure
      integer :: i, before
      pressure = largest_pressure(draft)
      do i = 1, size(draft%fluids)
         associate (fluid => draft%fluids(i)%fluid, units => draft%units)
            ! a fluid of one side alone may well be gas
            if (fluid%inside .and. fluid%outside .and. fluid%density > 0.0_wp .and. fluid%density < lightest_mud) &
               call append_text(job%notes, 'group &fluid: density = '//in_units(units, unit_density, fluid%density, digits)// &
                                ' is that of a gas or foam, water has '//in_units(units, unit_density, water, few_digits)// &
                                either('', mud_question(units, fluid%density, few_digits), &
                                       pressure > 0.0_wp .and. is_gas(fluid%density, pressure)))
         end associate
      end do
      if (draft%design%slip_length > 0.0_wp) &
         call note_range(draft%units, 'group &strength', usual_slips, draft%design%slip_length, job%notes)
      if (draft%numerics%eps_n0 >= large_eps_n0) call append_text(job%notes, &
         'group &solver: eps_n0 is large: contact this close to the wall is ignored, so contact force and friction are '// &
         'too small')
      call note_path(draft, job%notes)
      if (draft%interpolation == interpolation_spline) call note_spline(draft, job%notes)
      call find_uses(draft, uses, deepest_bit, below)
      narrowest = minval(draft%holes%section%diameter)
      before = size(job%notes)
      do i = 1, size(draft%components)
         call note_component(draft, draft%components(i), narrowest, job%notes)
         call note_unused(draft, draft%components(i), deepest_bit(i), below(i), job%notes)
         if (.not. is_missing(deepest_bit(i))) &
            call note_closed(draft, draft%components(i), deepest_bit(i) - below(i), job%notes)
         if (draft%components(i)%component%centralizer%bow) call note_bows(draft, uses, draft%components(i), below(i), job%notes)
         if (size(job%notes) < before + most_notes) cycle
         call append_text(job%notes, 'more notes on components are left out')
         exit
      end do
      call note_tools(draft, job%models, job%notes)
   end subroutine note_oddities

   !> Note bent housings, pads and eccentric blades that a model leaves out.
   subroutine note_tools(draft, models, notes)
      type(draft_type), intent(in) :: draft
      integer, intent(in) :: models(:)         !< of the job
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      do i = 1, size(draft%components)
         associate (item => draft%components(i))
            if (has_bend(item%component)) call note_model(item%line, 'the bent housing')
            if (has_pad(item%component)) call note_model(item%line, 'the force of the pads')
            if (is_eccentric(item%component)) call note_model(item%line, 'the offset of the blades')
         end associate
      end do
   contains
      subroutine note_model(line, ignored)
         integer, intent(in) :: line
         character(*), intent(in) :: ignored
         integer :: m
         do m = 1, size(models)
            if (models(m) == model_mcge .or. (models(m) == model_mixed .and. draft%numerics%mixed_elements)) cycle
            call append_text(notes, 'group &component in line '//to_text(line)//': model '//trim(model_name(models(m)))// &
                             ' ignores '//ignored//'. Use mcge')
         end do
      end subroutine note_model
   end subroutine note_tools

   !> Note a survey that goes deeper, or turns more sharply, than any hole does.
   subroutine note_path(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: curvature
      integer :: i, before
      associate (stations => draft%stations, units => draft%units)
         do i = 2, size(stations%md)
            before = i - 1
            curvature = dogleg_between(tangent_of(stations%inclination(before), stations%azimuth(before)), &
                                       tangent_of(stations%inclination(i), stations%azimuth(i)))/ &
                        (stations%md(i) - stations%md(before))
            if (curvature <= sharpest) cycle
            call append_text(notes, 'group &trajectory: between '//to_text(stations%md(before)/units%length, digits)//' and '// &
                             in_units(units, unit_length, stations%md(i), digits)//' the hole turns by '// &
                             in_units(units, unit_curvature, curvature, few_digits)// &
                             ', more than results were ever checked for; is a depth or an angle mistyped?')
            exit
         end do
         if (stations%md(size(stations%md)) > deepest) call append_text(notes, 'group &trajectory: the last station lies at '// &
            in_units(units, unit_length, stations%md(size(stations%md)), digits)// &
            ', deeper than any hole so far; mind the units')
      end associate
   end subroutine note_path

   !> Note a spline that swings between its stations.
   subroutine note_spline(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      type(trajectory_type) :: spline, arcs
      type(path_difference_type) :: difference
      type(error_type), allocatable :: error
      associate (stations => draft%stations, units => draft%units)
         call new_trajectory(spline, stations%md, stations%inclination, stations%azimuth, interpolation_spline, error)
         if (.not. allocated(error)) call new_trajectory(arcs, stations%md, stations%inclination, stations%azimuth, &
                                                         interpolation_minimum_curvature, error)
         if (allocated(error)) return
         difference = find_difference(spline, arcs)
         if (difference%direction <= sparse) return
         call append_text(notes, "group &trajectory: interpolation = 'spline' swings between sparse stations: it leaves "// &
            'minimum curvature by up to '//to_text(difference%direction/degree, angle_digits)//' deg in direction, near '// &
            in_units(units, unit_length, difference%direction_md, few_digits)//', and by up to '// &
            in_units(units, unit_length, difference%position, angle_digits)//' in position. It turns '// &
            'by '//to_text(difference%turns(1)/degree, angle_digits)//' deg in all instead of '// &
            to_text(difference%turns(2)/degree, angle_digits)//'; friction and moments go by that. Give stations where bends '// &
            "begin and end and between, or interpolation = 'minimum_curvature'")
      end associate
   end subroutine note_spline

   !> Note numbers of a component that do not fit each other.
   subroutine note_component(draft, item, narrowest, notes)
      type(draft_type), intent(in) :: draft
      type(draft_component_type), intent(in) :: item
      real(wp), intent(in) :: narrowest         !< diameter of the narrowest hole section [m]
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: tube, least
      associate (part => item%component, units => draft%units)
         if (narrowest > widest_hole*closed_diameter(part)) then
            call note('it is '//in_units(units, unit_diameter, closed_diameter(part), digits)//' wide in holes of '// &
                      in_units(units, unit_diameter, narrowest, digits)//' and more; mind the units of od'// &
                      either(', id and joint_od', ' and id', part%joint_od > part%od)// &
                      unit_questions(units, unit_diameter, closed_diameter(part)/units%diameter, narrowest/widest_hole, &
                                     narrowest, few_digits, either('joint_od', 'od', part%joint_od > part%od)))
            return      ! its mass follows
         end if
         if (part%centralizer%present .and. part%centralizer%od <= closed_diameter(part)) call note('its couplings or joints, '// &
            in_units(units, unit_diameter, closed_diameter(part), digits)//', are wider than its centralizers, '// &
            in_units(units, unit_diameter, part%centralizer%od, digits)//': the centralizers do not touch; check both')
         if (has_blades(part) .and. .not. (part%joint_od > part%od .or. opens(part))) &
            call note('a stabilizer without joint_od touches at its od, '// &
            in_units(units, unit_diameter, part%od, digits)//', and bends as a pipe of that od; '// &
            'give blades as joint_od and their body as od')
         tube = part%density*tube_area(part%od, part%id)
         least = merge(least_pipe_mass, least_mass, has_joints(part))
         if (holds_any(part%kind, hollow)) least = least_tool_mass
         if (part%mass > 0.0_wp .and. (part%mass < least*tube .or. part%mass > most_mass*tube)) then
            if (part%id > 0.0_wp) then
               call note('mass = '//to_text(part%mass/units%mass_per_length, digits)//', but a tube of its od, id and '// &
                  'density has '//to_text(tube/units%mass_per_length, few_digits)// &
                  '; mind the units, and the density of what is not steel'//mass_question()//width_question('od', part%od)// &
                  width_question('id', part%id))
            else
               call note('it has no id. Stiffness and strength are those of a solid bar, which has '// &
                  in_units(units, unit_mass, tube, few_digits)//', not mass = '// &
                  to_text(part%mass/units%mass_per_length, digits)//'. Give the inside diameter')
            end if
         end if
         if (part%youngs < softest .or. part%youngs > stiffest) call note('youngs = '// &
            to_text(part%youngs/unit_factor(units, unit_modulus), digits)//'; steel has '// &
            to_text(steel/unit_factor(units, unit_modulus), few_digits))
         if (item%connected .and. .not. part%joint_torsion > 0.0_wp) call note('the torque at which its connection yields is '// &
            'not known: it needs a joint_id (with tool joints) or an id and a yield (without) that leave a pin and a box; or '// &
            'give joint_torsion')
      end associate
   contains
      !> Question for the unit of the mass of pipe with joints. Screens and insulated or coated tubing are heavier than tubes.
      function mass_question() result(text)
         character(:), allocatable :: text, pipe
         real(wp) :: mass
         text = ''
         if (has_joints(item%component) .and. .not. is_insulated(item%component)) then
            if (is_nominal_mass(item%component, item%component%mass/draft%units%mass_per_length*pound/foot)) then
               call find_pipe(item%component, pipe, mass)
               if (pipe /= '') then
                  text = '. Is it the nominal weight in lbm/ft? The mass with tool joints of '//quoted(pipe)//' is '// &
                         to_text(mass/draft%units%mass_per_length, few_digits)//'. Write that'
                  return
               end if
            end if
            text = unit_questions(draft%units, unit_mass, &
            item%component%mass/draft%units%mass_per_length, least_pipe_mass*tube, most_mass*tube, few_digits, 'mass')
         end if
      end function mass_question
      !> Question for the unit of a diameter, in which the tube has the mass.
      function width_question(key, width) result(text)
         character(*), intent(in) :: key
         real(wp), intent(in) :: width           !< [m]
         character(:), allocatable :: text
         associate (larger => item%component%mass/tube)
            text = unit_questions(draft%units, unit_diameter, width/draft%units%diameter, width*sqrt(larger/most_mass), &
                                  width*sqrt(larger/least_mass), few_digits, key)
         end associate
      end function width_question
      subroutine note(text)
         character(*), intent(in) :: text
         call append_text(notes, 'group &component in line '//to_text(item%line)//': '//quoted(item%component%name)//': '//text)
      end subroutine note
   end subroutine note_component

   !> True for insulated tubing, with a gap between two pipes: od and id leave a wall that is not all steel.
   pure function is_insulated(part) result(is)
      type(component_type), intent(in) :: part
      logical :: is
      character(:), allocatable :: words
      words = lower_case(part%name//' '//part%kind)
      is = index(words, 'vit') > 0 .or. index(words, 'insulat') > 0 .or. index(words, 'double wall') > 0
   end function is_insulated

   !> Deepest bit of the string of each component, and the length of the string below the component.
   subroutine find_uses(draft, uses, deepest_bit, below)
      type(draft_type), intent(in) :: draft
      type(string_use_type), intent(in) :: uses(:)
      real(wp), intent(out) :: deepest_bit(:)   !< of all cases and other uses; missing: the string is not used [m]
      real(wp), intent(out) :: below(:)         !< [m]
      real(wp) :: length(size(below))           ! of each string so far, at the place of its lowest component
      integer :: lowest(size(below)), i
      lowest = lowest_of(draft)
      length = 0.0_wp
      do i = 1, size(below)
         if (lowest(i) == i) deepest_bit(i) = depth_of(draft%components(i)%string)
         deepest_bit(i) = deepest_bit(lowest(i))
         below(i) = length(lowest(i))
         length(lowest(i)) = below(i) + draft%components(i)%component%length
      end do

   contains

      !> The greatest depth of a string; missing where it is not used [m].
      function depth_of(string) result(depth)
         character(*), intent(in) :: string
         real(wp) :: depth
         integer :: k
         depth = missing
         do k = 1, size(draft%cases)
            if (draft%cases(k)%load_case%string == string) depth = max(depth, draft%cases(k)%load_case%bit_depth)
         end do
         do k = 1, size(uses)
            if (uses(k)%string == string) depth = max(depth, uses(k)%depth)
         end do
      end function depth_of
   end subroutine find_uses

   !> Note a component that never enters the hole: its string is not named, or the parts below it fill every hole.
   subroutine note_unused(draft, item, deepest_bit, below, notes)
      type(draft_type), intent(in) :: draft
      type(draft_component_type), intent(in) :: item
      real(wp), intent(in) :: deepest_bit       !< of its string; missing: the string is not used [m]
      real(wp), intent(in) :: below             !< length of its string below it [m]
      type(text_type), allocatable, intent(inout) :: notes(:)
      if (is_missing(deepest_bit)) then
         call append_text(notes, 'group &component in line '//to_text(item%line)//': string '//quoted(item%string)// &
                          ' is used by no case and no sweep')
      else if (below >= deepest_bit) then
         call append_text(notes, 'group &component in line '//to_text(item%line)//': '//quoted(item%component%name)// &
                          ' never enters the hole: the components below it are '// &
                          in_units(draft%units, unit_length, below, digits)//' long')
      end if
   end subroutine note_unused

   !> Note bow springs that are smaller than the hole at every place where they stand in cases and studies.
   subroutine note_bows(draft, uses, item, below, notes)
      type(draft_type), intent(in) :: draft
      type(string_use_type), intent(in) :: uses(:)
      type(draft_component_type), intent(in) :: item
      real(wp), intent(in) :: below             !< length of its string below it [m]
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: narrowest
      integer :: i
      narrowest = huge(narrowest)
      do i = 1, size(draft%cases)
         if (draft%cases(i)%load_case%string == item%string) call find_narrowest(draft%cases(i)%load_case%bit_depth)
      end do
      do i = 1, size(uses)
         if (uses(i)%string == item%string) call find_narrowest(uses(i)%depth)
      end do
      associate (od => item%component%centralizer%od, units => draft%units)
         if (narrowest >= huge(narrowest) .or. od >= filling*narrowest) return
         call append_text(notes, 'group &centralizer of '//quoted(item%component%name)//': od = '// &
            in_units(units, unit_diameter, od, digits)//' of its bow springs is smaller than the hole, '// &
            in_units(units, unit_diameter, narrowest, digits)//' and more where they stand. They have no running_force there '// &
            'and centre the string less. Give the od of free bows')
      end associate
   contains
      !> The narrowest hole beside the component, with the bit at a depth.
      subroutine find_narrowest(bit_depth)
         real(wp), intent(in) :: bit_depth        !< [m]
         real(wp) :: lower, upper
         integer :: k
         lower = bit_depth - below
         upper = 0.0_wp
         if (item%component%length > 0.0_wp) upper = max(lower - item%component%length, 0.0_wp)
         do k = 1, size(draft%holes)
            associate (hole => draft%holes(k)%section)
               if (min(hole%md_bottom, lower) > max(hole%md_top, upper)) narrowest = min(narrowest, hole%diameter)
            end associate
         end do
      end subroutine find_narrowest
   end subroutine note_bows

   !> Note a tool that opens, but stays above its depth of opening in all cases.
   subroutine note_closed(draft, item, lower_end, notes)
      type(draft_type), intent(in) :: draft
      type(draft_component_type), intent(in) :: item
      real(wp), intent(in) :: lower_end         !< greatest measured depth of its lower end [m]
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: upper_end
      associate (part => item%component, units => draft%units)
         upper_end = 0.0_wp
         if (part%length > 0.0_wp) upper_end = max(lower_end - part%length, 0.0_wp)
         if (.not. opens(part) .or. .not. lower_end > 0.0_wp .or. is_open(part, upper_end)) return
         call append_text(notes, 'group &component in line '//to_text(item%line)//': '//quoted(part%name)// &
            ' counts as closed everywhere: a tool opens where its whole length is below opened_below = '// &
            in_units(units, unit_length, part%opened_below, digits)//', and its upper end comes to '// &
            in_units(units, unit_length, upper_end, digits))
      end associate
   end subroutine note_closed
end module dg_deck_notes

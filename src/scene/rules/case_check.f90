!> Checks of load cases: numbers that their operation needs, reach of hole and string to the bit, and passage of the string.
module dg_case_check
   use dg_constants, only: foot, inch
   use dg_component, only: closed_diameter, component_type, has_blades, is_bit, is_open, is_pipe, opens
   use dg_hole_check, only: depth_round_off
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_likely_unit, only: unit_questions
   use dg_load_case, only: load_case_type, moves_axially, operation_name, rotates
   use dg_error, only: add_part_fault, error_list_type
   use dg_shown_size, only: depth_words, diameter_digits, diameter_words
   use dg_opening_check, only: check_open_passage, opening_advice
   use dg_text, only: either, quoted, suggestion, to_text
   use dg_unit_kind, only: unit_diameter, unit_label
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: hole_question, pipe_question
   public :: check_operation, check_reach, check_string_name, check_string_length, check_passage, lies_below

   !> Depth below the end of a survey that is round-off: a depth in ft with one decimal has 15 mm. In a short hole it is a part of
   !> its depth [m, -].
   real(wp), parameter :: rounded_depth = 0.02_wp, rounded_part = 1.0e-4_wp
   integer, parameter :: metre_digits = 6
   !> Depth of a bit over that of its survey, from which the survey may be in m and the bit in ft [-].
   real(wp), parameter :: least_ratio = 2.5_wp
   !> Widest hole, and part of a diameter that is round-off of inches [m, -].
   real(wp), parameter :: widest_hole = 1.2_wp, rounded = 2.0e-3_wp
   integer, parameter :: hole_digits = 4
   !> Diameter by which a stabilizer is usually smaller than its hole [m].
   real(wp), parameter :: under_gauge = inch/32.0_wp
   !> Words before a question for the unit of a hole.
   character(*), parameter :: hole_question = '. Look at the diameter of that hole'
   !> Words before a question for the unit of a component, and the narrowest one [m].
   character(*), parameter :: pipe_question = '. Diameters of this deck are in '
   real(wp), parameter :: narrowest_pipe = 0.02_wp
   character(*), parameter :: bit_advice = ". Only a bit may fill its hole: is it one? Then write kind = 'bit'"

contains

   !> Check speeds. Reaming needs both, whose ratio divides the friction. Hours of rotation need its speed.
   subroutine check_operation(load_case, found, speed)
      type(load_case_type), intent(in) :: load_case
      type(error_list_type), intent(inout) :: found
      character(*), intent(in), optional :: speed  !< the caller's name of the speed of rotation; absent: rpm, as in decks
      if (load_case%hours > 0.0_wp .and. .not. load_case%angular_speed > 0.0_wp) &
         call add_part_fault(found, 'load_case', 0, 'rpm', 'hours needs rpm > 0')
      if (.not. (rotates(load_case%operation) .and. moves_axially(load_case%operation))) return
      if (.not. load_case%angular_speed > 0.0_wp) then
         if (present(speed)) then
            call need('rpm', speed)
         else
            call need('rpm', 'rpm')
         end if
      end if
      if (.not. load_case%trip_speed > 0.0_wp) call need('trip_speed', 'trip_speed')
   contains
      subroutine need(key, called)
         character(*), intent(in) :: key, called
         call add_part_fault(found, 'load_case', 0, key, 'operation '//trim(operation_name(load_case%operation))//' needs '// &
                             called//' > 0')
      end subroutine need
   end subroutine check_operation

   !> Check that the bit is not below `what`. A depth beyond its end by round-off becomes its end.
   subroutine check_reach(depth, key, what, bottom, units, found)
      real(wp), intent(inout) :: depth             !< of the bit [m]
      character(*), intent(in) :: key              !< of the depth
      character(*), intent(in) :: what             !< 'survey' or the like
      real(wp), intent(in) :: bottom               !< its end [m]
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      if (lies_below(depth, bottom)) then
         call add_part_fault(found, 'load_case', 0, 'bit_depth', key//' = '//depth_words(units, depth)//' lies below the '// &
                             what//', which ends at '//depth_words(units, bottom)//'; needs a number, > 0 and <= '// &
                             depth_words(units, bottom)//either(metres_question(units, depth, bottom), '', what == 'survey'))
      else
         depth = min(depth, bottom)
      end if
   end subroutine check_reach

   !> True for a depth below an end by more than round-off.
   elemental function lies_below(depth, bottom) result(below)
      real(wp), intent(in) :: depth, bottom        !< [m]
      logical :: below
      below = depth > bottom + min(rounded_depth, rounded_part*bottom)
   end function lies_below

   !> Question for a survey in m in a deck in ft, where the bit would then be in the hole; '' for others.
   pure function metres_question(units, depth, bottom) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: depth, bottom        !< of the bit and of the survey [m]
      character(:), allocatable :: text
      text = ''
      if (abs(units%length - foot) > depth_round_off .or. depth < least_ratio*bottom .or. &
          depth*foot > bottom*(1.0_wp + depth_round_off)) return
      text = '. Is md of the survey in m? '//to_text(bottom/foot, metre_digits)//' m are '// &
             to_text(bottom/foot**2, metre_digits)//" ft. In a file write survey_units = 'SI'"
   end function metres_question

   !> Check that there is a string of that name.
   subroutine check_string_name(string, names, found)
      character(*), intent(in) :: string
      character(*), intent(in) :: names(:)         !< of strings, each once
      type(error_list_type), intent(inout) :: found
      if (any(names == string)) return
      call add_part_fault(found, 'load_case', 0, 'string', 'no component belongs to string '//quoted(string)//'; '// &
                          suggestion(string, names))
   end subroutine check_string_name

   !> Check that a string whose uppermost component has a length reaches from the bit to surface. Pipe may be longer, a tool
   !> may not.
   subroutine check_string_length(components, uppermost, load_case, key, units, found)
      type(component_type), intent(in) :: components(:)   !< from the bit upwards, one at least
      integer, intent(in) :: uppermost                    !< place of the last one
      type(load_case_type), intent(in) :: load_case
      character(*), intent(in) :: key                     !< of the depth of the bit
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      character(:), allocatable :: words
      real(wp) :: length
      logical :: goes_up
      integer :: k
      length = 0.0_wp
      do k = 1, size(components)
         length = length + components(k)%length
      end do
      if (.not. all(components%length > 0.0_wp)) return       ! one may reach to surface, or have its own fault
      if (.not. length < load_case%bit_depth*(1.0_wp - depth_round_off)) return
      words = 'string '//quoted(load_case%string)//' is '//depth_words(units, length)// &
              ' long and does not reach surface from '//key//' = '//depth_words(units, load_case%bit_depth)//': '// &
              depth_words(units, load_case%bit_depth - length)//' of pipe are missing; '
      associate (last => components(size(components)))
         goes_up = is_pipe(last)
         if (goes_up .and. allocated(last%kind)) goes_up = last%kind /= 'hwdp'      ! heavy weight pipe does not reach surface
      end associate
      if (goes_up) then
         call add_part_fault(found, 'load_case', 0, 'bit_depth', words//'leave out the length of its last component (', &
                             'component', uppermost, ')')
      else
         call add_part_fault(found, 'load_case', 0, 'bit_depth', words// &
                             'add drill pipe without a length as last component, after '// &
                             quoted(components(size(components))%name)//' (', 'component', uppermost, &
                             '); drillgap --list-catalogue prints its sizes')
      end if
   end subroutine check_string_length

   !> Check that every component is thinner than each hole section that it has passed. A bit may fill its hole. A tool that
   !> opens passes with its closed diameter down to where it opens.
   subroutine check_passage(components, places, holes, bit_depth, whose, units, found)
      type(component_type), intent(in) :: components(:)   !< from the bit upwards
      integer, intent(in) :: places(:)                    !< of each
      type(hole_section_type), intent(in) :: holes(:)     !< from the top down
      real(wp), intent(in) :: bit_depth                   !< [m]
      character(*), intent(in) :: whose                   !< owner of the depth: "case 'up'"
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      character(:), allocatable :: part
      real(wp) :: narrowest(size(holes))                  ! diameter of a section and all above it [m]
      integer :: k, h, lowest
      real(wp) :: lower_end, upper_end, diameter
      narrowest = holes%diameter
      do h = 2, size(holes)
         narrowest(h) = min(narrowest(h), narrowest(h - 1))
      end do
      lower_end = bit_depth
      lowest = size(holes)                                ! section of the lower end of the component
      do k = 1, size(components)
         if (lower_end <= 0.0_wp) return
         upper_end = 0.0_wp
         if (components(k)%length > 0.0_wp) upper_end = max(lower_end - components(k)%length, 0.0_wp)
         if (is_open(components(k), upper_end)) &
            call check_open_passage(components(k), places(k), holes, lower_end, whose, units, found)
         diameter = closed_diameter(components(k))
         do while (lowest > 0)
            if (holes(lowest)%md_top < lower_end*(1.0_wp - depth_round_off)) exit
            lowest = lowest - 1
         end do
         part = 'component'
         if (components(k)%centralizer%present .and. .not. components(k)%centralizer%bow) then
            if (components(k)%centralizer%od > diameter) part = 'centralizer'
            diameter = max(components(k)%centralizer%od, diameter)
         end if
         do h = 1, lowest
            if (diameter < narrowest(lowest)) exit
            if (diameter < holes(h)%diameter) cycle
            if (is_bit(components(k)) .and. .not. diameter > holes(h)%diameter) cycle
            call add_part_fault(found, part, places(k), 'od', quoted(components(k)%name)//' with '// &
                                either('couplings or joints of ', '', by_joint())//wide(diameter)//' does not pass the hole of '// &
                                wide(holes(h)%diameter)//' (', 'hole', h, ') in '//whose//advice())
         end do
         if (components(k)%length <= 0.0_wp) return
         lower_end = upper_end
      end do
   contains
      !> Advice: the hole or the component is in another unit, or the component is a bit, or a tool that opens.
      function advice() result(text)
         character(:), allocatable :: text
         text = unit_questions(units, unit_diameter, holes(h)%diameter/units%diameter, (1.0_wp - rounded)*diameter, &
                               widest_hole, hole_digits)
         if (text /= '') then
            text = hole_question//text
            return
         end if
         text = unit_questions(units, unit_diameter, diameter/units%diameter, narrowest_pipe, &
                               (1.0_wp + rounded)*narrowest(lowest), hole_digits, 'this one')
         if (text /= '') then
            text = pipe_question//unit_label(units, unit_diameter)//text
         else
            text = '; needs a diameter '//either('<=', '<', is_bit(components(k)))//' '//wide(narrowest(lowest))// &
                   gauge_advice()// &
                   either(bit_advice, '', k == 1 .and. .not. (diameter > holes(h)%diameter .or. is_pipe(components(k))))// &
                   opening_advice(components(k), holes, lowest, units)
         end if
      end function advice

      !> Usual size of a stabilizer of full gauge; '' for other components.
      function gauge_advice() result(text)
         character(:), allocatable :: text
         text = ''
         if (has_blades(components(k)) .and. .not. opens(components(k)) .and. abs(diameter - narrowest(lowest)) < under_gauge) &
            text = '. Give its size under gauge, usually 1/32 in less: '// &
                   diameter_words(units, narrowest(lowest) - under_gauge, hole_digits)
      end function gauge_advice

      !> True for pipe whose joints are its widest part.
      function by_joint() result(is)
         logical :: is
         is = is_pipe(components(k)) .and. components(k)%joint_od > components(k)%od .and. part == 'component'
      end function by_joint

      function wide(width) result(text)
         real(wp), intent(in) :: width
         character(:), allocatable :: text
         text = diameter_words(units, width, diameter_digits)
      end function wide
   end subroutine check_passage
end module dg_case_check

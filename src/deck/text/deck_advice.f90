!> Advice on words of a deck that differ from its keys. It covers names of groups and keys in other programs and on the rig,
!> and operations by a similar name. It also covers numbers as people write them (8-1/2, 5", 135 ksi), and other names of
!> units. None of these is read.
module dg_deck_advice
   use dg_kinds, only: wp
   use dg_deck_number, only: read_fraction, read_real
   use dg_deck_schema, only: key_rule_type, kind_real, kind_text, legal_range
   use dg_likely_unit, only: unit_questions
   use dg_load_case, only: alike, operation_aliases, operation_count, operation_from_name, operation_name
   use dg_text, only: nearest_name, suggestion, edit_distance, joined, lower_case, to_text
   use dg_unit_kind, only: heaviest_mud, lightest_oil, unit_density, unit_diameter, unit_label, unit_none, &
                           unit_pressure
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: key_advice, meant_key, operation_advice, unit_advice, value_advice

   !> A group or key of a deck, with its names elsewhere.
   type :: names_type
      character(16) :: group = ''       !< of the key; '': a group is meant
      character(20) :: ours = ''
      character(88) :: foreign = ''     !< a blank between two
   end type names_type

   type(names_type), parameter :: names(*) = [ &
      names_type('', 'component', 'bha string drillstring drill_string drillpipe drill_pipe pipe collar bit tubular'), &
      names_type('', 'load_case', 'bitrun bit_run run loadcase loadcases load operation case'), &
      names_type('', 'trajectory', 'survey surveys wellpath well_path path deviation'), &
      names_type('', 'fluid', 'mud mud_weight fluids'), &
      names_type('', 'hole', 'casing open_hole openhole wellbore hole_section section'), &
      names_type('', 'job', 'well units settings general project'), &
      names_type('component', 'joint_od', 'tool_joint_od tooljoint_od tj_od blade_od'), &
      names_type('component', 'joint_id', 'tool_joint_id tj_id'), &
      names_type('component', 'joint_length', 'tool_joint_length tj_length'), &
      names_type('component', 'joint_spacing', 'average_joint_length range_length'), &
      names_type('component', 'joint_torsion', 'torsional_yield torsional_strength tj_torque joint_torque'), &
      names_type('component', 'bend', 'bend_angle bent_housing housing_angle'), &
      names_type('component', 'od', 'outer_diameter outside_diameter diameter'), &
      names_type('component', 'id', 'inner_diameter inside_diameter'), &
      names_type('component', 'mass', 'weight linear_weight unit_weight adjusted_weight weight_in_air ppf'), &
      names_type('component', 'yield', 'yield_strength min_yield grade steel_grade smys'), &
      names_type('component', 'youngs', 'modulus youngs_modulus elastic_modulus'), &
      names_type('component', 'kind', 'type'), &
      names_type('component', 'makeup_torque', 'makeup mut'), &
      names_type('hole', 'diameter', 'id od size hole_size hole_diameter bit_size casing_id'), &
      names_type('hole', 'friction', 'ff friction_factor mu'), &
      names_type('hole', 'md_top', 'top from'), &
      names_type('hole', 'md_bottom', 'bottom to shoe shoe_depth casing_shoe depth'), &
      names_type('fluid', 'density', 'mud_weight mudweight mud_density weight mw ppg'), &
      names_type('fluid', 'surface_pressure', 'back_pressure backpressure annulus_pressure wellhead_pressure'), &
      names_type('rig', 'block_weight', 'block travelling_block block_mass hook_weight'), &
      names_type('rig', 'max_hookload', 'rig_limit capacity rated_load max_load hook_capacity'), &
      names_type('rig', 'max_torque', 'top_drive_torque torque_limit'), &
      names_type('rig', 'max_push', 'push thrust max_thrust injector_force snubbing_force hold_down'), &
      names_type('rig', 'lines', 'number_of_lines line_count'), &
      names_type('trajectory', 'md', 'depth'), &
      names_type('trajectory', 'inc', 'inclination'), &
      names_type('trajectory', 'azi', 'azimuth'), &
      names_type('trajectory', 'survey_file', 'file'), &
      names_type('load_case', 'bit_depth', 'depth md'), &
      names_type('load_case', 'wob', 'weight_on_bit'), &
      names_type('load_case', 'tob', 'torque_on_bit bit_torque'), &
      names_type('load_case', 'measured_hookload', 'hookload hook_load actual_hookload'), &
      names_type('load_case', 'measured_torque', 'torque surface_torque actual_torque'), &
      names_type('load_case', 'rpm', 'surface_rpm rotary_speed rotation_speed'), &
      names_type('load_case', 'trip_speed', 'tripping_speed hoisting_speed running_speed block_speed speed'), &
      names_type('load_case', 'pump_pressure', 'spp standpipe_pressure'), &
      names_type('load_case', 'annulus_pressure', 'back_pressure backpressure choke_pressure wellhead_pressure'), &
      names_type('load_case', 'friction', 'ff friction_factor mu'), &
      names_type('load_case', 'toolface', 'tool_face tfo'), &
      names_type('load_case', 'operation', 'type mode activity'), &
      names_type('job', 'title', 'name'), &
      names_type('job', 'units', 'unit_system'), &
      names_type('job', 'output_dir', 'output'), &
      names_type('job', 'models', 'model')]

   !> Names elsewhere that no key has, and what to do. Group '': any.
   type :: absent_type
      character(16) :: group = ''
      character(88) :: foreign = ''     !< a blank between two
      character(88) :: advice = ''
   end type absent_type

   character(*), parameter :: needless = 'no result depends on it. Leave it out'
   type(absent_type), parameter :: absent(*) = [ &
      absent_type('', 'flow_rate flowrate flow gpm pump_rate viscosity plastic_viscosity pv yield_point yp tfa', &
                  'hydraulics are not calculated. Of the flow only pump_pressure of &load_case counts'), &
      absent_type('', 'rop rate_of_penetration penetration_rate', needless), &
      absent_type('fluid', 'name type label', needless), &
      absent_type('load_case', 'mud_weight mudweight mud_density density mw', &
                  'the mud stands in &fluid. Write inside_density for another one within the string'), &
      absent_type('component', 'nominal_weight', 'give mass, with that of the tool joints'), &
      absent_type('component', 'wall_thickness wall wt', 'give id, which is od less twice the wall')]

   !> Slips that a name may have, by its length.
   integer, parameter :: short_name = 4, slips_of_short = 1, slips_of_long = 2
   !> Names that one message lists, letters of a word that counts, and how much it counts in a name and in a meaning.
   integer, parameter :: few_keys = 6, shortest_word = 3, of_name = 3, of_meaning = 2
   !> Letters of a name that is cut short.
   integer, parameter :: shortest_stem = 5
   !> Words of the rig that mean more than one operation, or one with a load.
   character(*), parameter :: overpull = 'overpull'
   character(*), parameter :: both_ways(4) = [character(12) :: 'trip', 'tripping', 'reciprocate', 'washing']

   !> Significant digits of a number that is advised.
   integer, parameter :: digits_told = 7, advised_digits = 4
   !> Largest pressure of pumps, 15,000 psi [Pa].
   real(wp), parameter :: most_pressure = 105.0e6_wp
   !> Diameters that may be meant in another unit [m].
   real(wp), parameter :: narrowest_pipe = 0.01_wp, widest_hole = 1.2_wp
   integer, parameter :: letters_of_thousand = 3
   character(*), parameter :: digits = '0123456789'

contains

   !> Advice on an unknown key of a group, or on an unknown group if `group` is ''. It is the one with the same meaning, else
   !> the nearest by its letters, else those near by meaning, or all where they are few.
   pure function key_advice(group, name, legal, meanings) result(advice)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:), meanings(:)
      character(:), allocatable :: advice
      integer, allocatable :: near(:)
      advice = same_name(group, name, legal)
      if (advice /= '') then
         advice = "did you mean '"//advice//"'?"
      else
         advice = absent_advice(group, name)
         if (advice /= '') return
         advice = suggestion(name, legal)
         if (size(legal) <= few_keys .or. nearest_name(name, legal) /= '') return
         allocate (near, source=near_by_meaning(name, legal, meanings))
         advice = 'input/README.md lists all '//to_text(size(legal))
         if (size(near) > 0) advice = 'keys of similar meaning: '//joined(legal(near), ', ')//'. '//advice
      end if
   end function key_advice

   !> Advice on a name that no key has, be it by another name; '' for others.
   pure function absent_advice(group, name) result(advice)
      character(*), intent(in) :: group, name
      character(:), allocatable :: advice
      integer :: i
      advice = ''
      if (name == '' .or. group == '') return
      do i = 1, size(absent)
         if (absent(i)%group /= '' .and. absent(i)%group /= group) cycle
         if (index(' '//absent(i)%foreign, ' '//name//' ') > 0) advice = trim(absent(i)%advice)
      end do
   end function absent_advice

   !> Places of the few names that share most words with an unknown one, in themselves or in their meaning.
   pure function near_by_meaning(name, legal, meanings) result(places)
      character(*), intent(in) :: name
      character(*), intent(in) :: legal(:), meanings(:)
      integer, allocatable :: places(:)
      integer :: score(size(legal)), i, first
      character(:), allocatable :: word
      score = 0
      first = 1
      do while (first <= len(name))
         call next_word(name, '_- ', first, word)
         if (word == '') cycle
         do i = 1, size(legal)
            if (index(legal(i), word) > 0) score(i) = score(i) + of_name
            if (shares_word(word, lower_case(meanings(i)))) score(i) = score(i) + of_meaning
         end do
      end do
      allocate (places(0))
      do while (any(score > 0) .and. size(places) < few_keys)
         places = [places, maxloc(score, dim=1)]
         score(places(size(places))) = 0
      end do
   end function near_by_meaning

   !> True if a text has a word that begins with `word`, or with which `word` ends: 'pulls' and 'overpull'.
   pure function shares_word(word, text) result(shares)
      character(*), intent(in) :: word, text
      logical :: shares
      character(:), allocatable :: other
      integer :: first
      shares = .false.
      first = 1
      do while (first <= len_trim(text))
         call next_word(text, ' ,;:()=-', first, other)
         if (other == '') cycle
         if (index(other, word) == 1) shares = .true.
         if (len(other) < short_name .or. len(other) > len(word)) cycle
         if (word(len(word) - len(other) + 1:) == other) shares = .true.
      end do
   end function shares_word

   !> The word of a text that begins at `first`, without the s of a plural; '' for a short one. `first` moves behind it.
   pure subroutine next_word(text, separators, first, word)
      character(*), intent(in) :: text, separators
      integer, intent(inout) :: first
      character(:), allocatable, intent(out) :: word
      integer :: length
      length = scan(text(first:)//separators, separators) - 1
      word = text(first:first + length - 1)
      first = first + length + 1
      if (length < shortest_word) word = ''
      if (length >= shortest_word .and. index(word, 's', back=.true.) == length) word = word(:length - 1)
   end subroutine next_word

   !> The key that an unknown one is taken for; '' where none is.
   pure function meant_key(group, name, legal) result(meant)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: meant
      meant = same_name(group, name, legal)
      if (meant == '') meant = nearest_name(name, legal)
   end function meant_key

   !> The group or key that means the same; '' where none is known.
   pure function same_name(group, name, legal) result(meant)
      character(*), intent(in) :: group, name
      character(*), intent(in) :: legal(:)
      character(:), allocatable :: meant
      integer :: i
      meant = ''
      do i = 1, size(names)
         if (names(i)%group /= group .or. .not. any(legal == names(i)%ours)) cycle
         if (name /= '' .and. index(' '//names(i)%foreign, ' '//name//' ') > 0) meant = trim(names(i)%ours)
      end do
   end function same_name

   !> Advice on an unknown name. Where two operations are equally near, both are named.
   pure function operation_advice(name) result(advice)
      character(*), intent(in) :: name
      character(:), allocatable :: advice
      logical :: near(operation_count)
      integer :: i
      if (alike(name) == overpull .or. alike(name) == 'overpulling') then
         advice = "write 'trip_out' with a wob below 0, which pulls the bit"
         return
      end if
      if (any(both_ways == alike(name))) then
         advice = "write 'trip_out' or 'trip_in'"
         return
      end if
      call find_near(trim(alike(name)), near)
      if (any(near)) then
         advice = "did you mean '"//joined(pack(operation_name, near), "' or '")//"'? "
      else
         advice = ''
      end if
      advice = advice//'legal: '//joined([(operation_name(i), i=1, operation_count)], ', ')// &
         '; also '//joined(pack(operation_aliases%name, operation_aliases%is_listed), ', ')
   end function operation_advice

   !> Operations that have the nearest of all names. Of short names one slip counts, of long ones two; else a name that goes on
   !> where this one ends, or that begins this one.
   pure subroutine find_near(name, near)
      character(*), intent(in) :: name       !< as `alike` gives it, without blanks
      logical, intent(out) :: near(operation_count)
      character(20), parameter :: names(*) = [character(20) :: operation_name, operation_aliases%name]
      integer :: distance(size(names)), i, most
      most = slips_of_long
      if (len(name) <= short_name) most = slips_of_short
      distance = [(edit_distance(name, trim(alike(names(i)))), i=1, size(names))]
      near = .false.
      do i = 1, size(names)
         if (distance(i) <= most .and. distance(i) == minval(distance)) near(operation_from_name(trim(names(i)))) = .true.
      end do
      if (any(near) .or. len(name) < shortest_stem) return
      do i = 1, size(names)
         if (index(alike(names(i)), name) == 1) near(operation_from_name(trim(names(i)))) = .true.
      end do
      if (any(near)) return
      do i = 1, size(names)
         if (len_trim(alike(names(i))) >= shortest_stem .and. index(name, trim(alike(names(i)))) == 1) &
            near(operation_from_name(trim(names(i)))) = .true.
      end do
   end subroutine find_near

   !> Advice for a text that is no number, with '; ' before it; '' where there is no advice.
   pure function value_advice(text, rule, units) result(advice)
      character(*), intent(in) :: text             !< as in the deck; several values with blanks between them
      type(key_rule_type), intent(in) :: rule      !< of the key
      type(unit_system_type), intent(in) :: units  !< of the deck
      character(:), allocatable :: advice
      real(wp) :: number
      logical :: legal
      integer :: length
      advice = ''
      if (rule%kind == kind_text) return
      call read_fraction(without_mark(text), number, legal)
      if (legal) then
         advice = '; write '//to_text(number, digits_told)
         return
      end if
      ! '1 25' of 1,25; a number with its unit behind
      length = verify(text, digits//'.+-') - 1
      if (length > 0 .and. verify(trim(text), digits//' ') == 0 .and. len_trim(text) > length) then
         advice = '; decimals have a point: '//text(:length)//'.'//trim(adjustl(text(length + 1:)))
         if (len_trim(adjustl(text(length + 1:))) == letters_of_thousand .and. scan(text(1:1), '0-') == 0) &
            advice = advice//'. Thousands have no mark: '//text(:length)//trim(adjustl(text(length + 1:)))
         if (verify(trim(adjustl(text(length + 1:))), digits) == 0) return
         advice = ''
      end if
      if (length < 1) return
      call read_real(text(:length), number, legal)
      if (.not. legal .or. verify(text(length + 1:length + 1), ' ''"#%') > 0 .and. &
          scan(lower_case(text(length + 1:length + 1)), 'abcdefghijklmnopqrstuvwxyz') == 0) return
      advice = '; write the number alone'
      if (rule%unit /= unit_none) advice = advice//'; its unit is '//unit_label(units, rule%unit)
   end function value_advice

   !> Advice for a number out of its range that would be legal in another unit.
   pure function unit_advice(text, rule, units) result(advice)
      character(*), intent(in) :: text
      type(key_rule_type), intent(in) :: rule
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: advice
      real(wp) :: number, range(2)
      logical :: legal
      advice = ''
      if (rule%kind /= kind_real) return
      call read_real(text, number, legal)
      if (.not. legal) return
      range = legal_range(rule)
      if (rule%unit == unit_diameter) range = [narrowest_pipe, widest_hole]
      if (rule%unit == unit_density) range = [lightest_oil, heaviest_mud]
      if (rule%unit == unit_pressure) range(2) = min(range(2), most_pressure)
      advice = unit_questions(units, rule%unit, number, range(1), range(2), advised_digits)
   end function unit_advice

   !> A text without a mark of inches at its end, in quotes or as a word.
   pure function without_mark(text) result(bare)
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      integer :: last
      last = len_trim(text)
      if (last > 2) then
         if (lower_case(text(last - 1:last)) == 'in') last = len_trim(text(:last - 2))
      end if
      if (last > 1) then
         if (scan(text(last:last), '"''') == 1) last = len_trim(text(:last - 1))
      end if
      bare = text(:last)
   end function without_mark
end module dg_deck_advice

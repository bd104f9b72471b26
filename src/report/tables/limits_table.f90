!> A short block on standard output: how near the string came to its limits, for the worst of the solved cases of a model. The
!> rest is in limits.csv.
module dg_limits_table
   use dg_kinds, only: wp
   use dg_findings, only: findings_type, rows_of
   use dg_named_states, only: buckling_none
   use dg_case_result, only: case_result_type, result_converged
   use dg_casing_wear, only: groove_type
   use dg_quantity, only: quantity_force, quantity_length, quantity_line_load, quantity_moment, quantity_none, &
                          quantity_turns
   use dg_comparison, only: in_percent
   use dg_constants, only: pi
   use dg_drillstring, only: component_tops
   use dg_fatigue, only: fatigue_type
   use dg_job, only: model_name
   use dg_length_change, only: total_change
   use dg_load_case, only: operation_static
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type, string_index
   use dg_number_text, only: append_wrapped, fixed_text
   use dg_text, only: append_text, either, lower_case, text_type, to_text
   use dg_trajectory, only: top_md
   use dg_unchecked_text, only: components_without_yield
   use dg_unit_kind, only: in_units, unit_curvature, unit_diameter, unit_force, unit_pressure, unit_stress, unit_factor, &
                           unit_label
   use dg_units, only: unit_system_type
   use dg_utilisation, only: joint_ratings, limit_name, limit_von_mises, utilisation_type
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: limits_table

   integer, parameter :: head_width = 30
   integer, parameter :: few = 3
   !> Least increase of von Mises stress by bending between tool joints that a line names [-].
   real(wp), parameter :: least_joint_bending = 0.01_wp
   !> Least number of turns of a helix that is shown with three digits.
   real(wp), parameter :: many_turns = 100.0_wp
   character(*), parameter :: jar_kind = 'jar'

   !> Least length of buckling that is shown, in units of the table: half of the last digit.
   real(wp), parameter :: least_length = 0.5_wp
   !> Least wind-up that is shown [rad]: half of the last digit.
   real(wp), parameter :: least_windup = 0.005_wp*2.0_wp*pi

contains

   !> The lines of the block of every model; a model without a solved case has none.
   pure subroutine limits_table(found, lines)
      type(findings_type), intent(in) :: found
      type(text_type), allocatable, intent(out) :: lines(:)
      integer, allocatable :: rows(:)
      integer :: i
      allocate (lines(0))
      do i = 1, size(found%job%models)
         rows = rows_of(found, found%job%models(i))
         rows = pack(rows, found%results(rows)%status == result_converged)
         if (size(rows) == 0) cycle
         call append_text(lines, '')
         call append_text(lines, 'Limits, model '//trim(model_name(found%job%models(i)))//' (all: limits.csv)')
         call append_block(lines, found%job%units, found%model, found%results(rows), found%wholes(rows))
      end do
   end subroutine limits_table

   pure subroutine append_block(lines, units, model, results, wholes)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(whole_string_type), intent(in) :: wholes(:)
      type(optional_real), dimension(size(results)) :: numbers, nowhere
      type(text_type) :: names(size(results)), deciders(size(results))
      character(:), allocatable :: left_out
      real(wp) :: turns
      integer :: i
      do i = 1, size(results)
         names(i)%text = model%cases(results(i)%case_index)%name
      end do
      call append_extreme(lines, units, names, 'Largest stretch', quantity_length, 2, given(wholes%stretch), nowhere, .true.)
      call append_extreme(lines, units, names, 'Largest wind-up', quantity_turns, 2, &
                          beyond(abs(wholes%windup), least_windup), nowhere, .true.)
      numbers = wholes%bending_error
      numbers%value = wholes%bending
      call append_extreme(lines, units, names, 'Largest bending moment', quantity_moment, 2, numbers, &
                          given(wholes%bending_md), .true.)
      call append_extreme(lines, units, names, 'Moments may be off by, %', quantity_none, 1, &
                          in_percent(wholes%bending_error), nowhere, .true.)
      call append_extreme(lines, units, names, 'Largest mean side force', quantity_line_load, 3, given(wholes%side_force), &
                          given(wholes%side_force_md), .true.)
      numbers = in_percent(wholes%least_standoff)
      do i = 1, size(results)
         associate (string => model%strings(string_index(model%strings, model%cases(results(i)%case_index)%string)))
            numbers(i)%present = numbers(i)%present .and. any(string%components%centralizer%present)
         end associate
      end do
      ! in parentheses: a component of an array of records is handed on as a copy
      call append_extreme(lines, units, names, 'Least standoff, %', quantity_none, 1, numbers, &
                          (wholes%least_standoff_md), .false.)
      call append_extreme(lines, units, names, 'Least safety against yield', quantity_none, 2, &
                          (wholes%least_safety), (wholes%least_safety_md), .false.)
      left_out = components_without_yield(model)
      if (left_out /= '' .and. any(wholes%least_safety%present)) &
         call append_wrapped(lines, '    without '//left_out//' (no yield)')
      call find_overpull(wholes, numbers, deciders)
      do i = 1, size(results)
         deciders(i)%text = names(i)%text//', '//deciders(i)%text
      end do
      call append_extreme(lines, units, deciders, 'Overpull left, pipe or rig', quantity_force, 1, numbers, nowhere, .false.)
      if (any(bends_between_joints(wholes, model%design%von_mises))) call append_text(lines, '    safety and overpull of the '// &
         'pipe leave out bending between tool joints, which the answers include')
      call append_extreme(lines, units, names, 'Least margin to rig limit', quantity_force, 1, &
                          (wholes%rig_margin), nowhere, .false.)
      call append_extreme(lines, units, names, 'Least margin to make-up', quantity_moment, 2, &
                          (wholes%makeup_margin), (wholes%makeup_margin_md), .false.)
      deciders = noted(names, wholes%buckling_margin%present .and. wholes%buckling_margin%value < 0.0_wp, ', buckled')
      call append_extreme(lines, units, deciders, 'Least margin to buckling', quantity_force, 1, &
                          (wholes%buckling_margin), (wholes%buckling_margin_md), .false.)
      deciders = noted(names, wholes%wob_buckling%present .and. .not. wholes%wob_buckling%value > 0.0_wp, ', buckles without WOB')
      numbers = wholes%wob_buckling
      numbers%present = numbers%present .and. model%cases(results%case_index)%wob > 0.0_wp
      call append_extreme(lines, units, deciders, 'WOB where buckling begins', quantity_force, 1, numbers, nowhere, .false.)
      do i = 1, size(results)
         if (.not. max(wholes(i)%sinusoidal_length, wholes(i)%helical_length) > least_length*units%length) cycle
         call append_text(lines, '  By formula, buckled in '//names(i)%text//span_text(units, wholes(i)%buckled_span)//': '// &
                          lengths_text(units, wholes(i)%sinusoidal_length, wholes(i)%helical_length))
      end do
      do i = 1, size(results)
         if (wholes(i)%shape == buckling_none) cycle
         turns = wholes(i)%coil_turns
         call append_text(lines, '  By mcge, buckled in '//names(i)%text//span_text(units, wholes(i)%shape_span)//': '// &
                          lengths_text(units, wholes(i)%snaking_length, wholes(i)%coiled_length)// &
                          either(' ('//to_text(turns, merge(2, 3, turns < many_turns))//' turns)', '', turns > 0.0_wp))
      end do
      do i = 1, size(results)
         if (.not. wholes(i)%sag_correction%present) cycle
         call append_text(lines, '  Sag correction in '//names(i)%text//': '// &
                          fixed_text(wholes(i)%sag_correction%value/units%angle, 3)// &
                          ' deg at the sensor, '// &
                          whole_depth(units, wholes(i)%sensor_md%value)// &
                          either('', '. Surveys are taken at rest: use ''static''', &
                                 any(model%cases%operation == operation_static)))
      end do
      do i = 1, size(results)
         if (wholes(i)%length_change%present) call append_length_change(lines, units, model, results(i)%case_index, wholes(i))
      end do
      do i = 1, size(results)
         if (wholes(i)%yield_left%present) call append_text(lines, '  Yield strength left in '//names(i)%text//': '// &
            to_text(100.0_wp*wholes(i)%yield_left%value, few)//' % at '// &
            whole_depth(units, wholes(i)%yield_left_md%value)//', by temperature')
         call append_ratings(lines, names(i)%text, wholes(i)%utilisation)
         if (wholes(i)%groove%present) call append_groove(lines, units, names(i)%text, wholes(i)%groove)
         if (wholes(i)%fatigue%present) call append_fatigue(lines, units, 'Fatigue in '//names(i)%text, wholes(i)%fatigue)
         if (wholes(i)%joint_fatigue%present) &
            call append_fatigue(lines, units, 'Fatigue of joints in '//names(i)%text, wholes(i)%joint_fatigue)
      end do
      do i = 1, size(results)
         call append_jars(lines, units, model, results(i), names(i)%text)
      end do
   end subroutine append_block

   !> Names with a note behind some of them.
   pure function noted(names, some, note) result(longer)
      type(text_type), intent(in) :: names(:)
      logical, intent(in) :: some(:)             !< as many
      character(*), intent(in) :: note
      type(text_type) :: longer(size(names))
      integer :: i
      do i = 1, size(names)
         longer(i)%text = names(i)%text//either(note, '', some(i))
      end do
   end function noted

   !> A depth or length without decimals.
   pure function whole_depth(units, md) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: md         !< [m]
      character(:), allocatable :: text
      text = to_text(anint(md/units%length))//' '//trim(units%length_label)
   end function whole_depth

   !> Lengths of buckled string.
   pure function lengths_text(units, sinusoidal, helical) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: sinusoidal, helical     !< [m]
      character(:), allocatable :: text
      text = 'sinusoidal '//whole_depth(units, sinusoidal)//', helical '//whole_depth(units, helical)
   end function lengths_text

   !> First and last depth of a part of the string.
   pure function span_text(units, span) result(text)
      type(unit_system_type), intent(in) :: units
      type(optional_real), intent(in) :: span(2)      !< [m]
      character(:), allocatable :: text
      text = ', '//whole_depth(units, span(1)%value)//' to '//whole_depth(units, span(2)%value)
   end function span_text

   !> Pull that may be added at the top of each case, and its limit: the smaller of the rig's capacity and the pipe's.
   pure subroutine find_overpull(wholes, pulls, deciders)
      type(whole_string_type), intent(in) :: wholes(:)
      type(optional_real), intent(out) :: pulls(:)             !< as many [N]
      type(text_type), intent(out) :: deciders(:)
      integer :: i
      do i = 1, size(wholes)
         associate (pipe => wholes(i)%overpull_margin, rig => wholes(i)%rig_margin)
            pulls(i) = pipe
            deciders(i)%text = 'pipe'
            if (.not. rig%present) then
               deciders(i)%text = 'pipe alone, rig NOT CHECKED'
            else if (.not. pipe%present) then
               pulls(i) = rig
               deciders(i)%text = 'rig alone, pipe NOT CHECKED'
            else if (rig%value < pipe%value) then
               pulls(i) = rig
               deciders(i)%text = 'rig'
            end if
         end associate
      end do
   end subroutine find_overpull

   !> True where bending between tool joints raises the utilisation of a case.
   elemental function bends_between_joints(whole, factor) result(bends)
      type(whole_string_type), intent(in) :: whole
      real(wp), intent(in) :: factor       !< design factor on von Mises stress [-]
      logical :: bends
      associate (used => whole%utilisation%used(limit_von_mises), safety => whole%least_safety)
         bends = used%present .and. safety%present
         if (bends) bends = used%value*safety%value > (1.0_wp + least_joint_bending)*factor
      end associate
   end function bends_between_joints

   !> Append the utilisation of the ratings of premium connections, where they have some.
   pure subroutine append_ratings(lines, name, utilisation)
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(*), intent(in) :: name                 !< of the case
      type(utilisation_type), intent(in) :: utilisation
      character(*), parameter :: joint = 'joint '
      character(:), allocatable :: text, rating
      integer :: i
      text = ''
      do i = 1, size(joint_ratings)
         associate (used => utilisation%used(joint_ratings(i)))
            if (.not. used%present) cycle
            if (text /= '') text = text//', '
            rating = trim(limit_name(joint_ratings(i)))
            text = text//rating(len(joint) + 1:)//' '//fixed_text(used%value/0.01_wp, 1)//' %'
         end associate
      end do
      if (text /= '') call append_text(lines, '  Ratings of connections used in '//name//': '//text)
   end subroutine append_ratings

   !> Fatigue of body or connections with the most fatigue.
   pure subroutine append_fatigue(lines, units, head, fatigue)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: head                 !< of the line
      type(fatigue_type), intent(in) :: fatigue
      character(:), allocatable :: text
      text = '  '//head//': bending stress '//in_units(units, unit_stress, fatigue%amplitude, few)//' at '// &
             whole_depth(units, fatigue%md)//', endurance limit '// &
             in_units(units, unit_stress, fatigue%permitted, few)
      if (.not. is_missing(fatigue%turns)) text = text//', '//to_text(fatigue%turns, few)//' turns until failure'
      call append_text(lines, text)
      text = ''
      if (.not. is_missing(fatigue%dogleg)) text = 'largest dogleg without fatigue '// &
         in_units(units, unit_curvature, fatigue%dogleg, few)//' (formula, only tool joints touch)'
      if (.not. is_missing(fatigue%damage)) then
         if (text /= '') text = text//', '
         text = text//to_text(100.0_wp*fatigue%damage, few)//' % of life used'
      end if
      if (text /= '') call append_text(lines, '    '//text)
   end subroutine append_fatigue

   !> The worst groove in casing, and the wall and strength that are left.
   pure subroutine append_groove(lines, units, name, groove)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: name                 !< of the case
      type(groove_type), intent(in) :: groove
      character(:), allocatable :: left
      left = ''
      if (.not. is_missing(groove%burst)) left = ', burst '//in_units(units, unit_pressure, groove%burst, few)// &
         ', collapse '//in_units(units, unit_pressure, groove%collapse, few)
      call append_text(lines, '  Casing wear in '//name//': '//in_units(units, unit_diameter, groove%depth, few)//' at '// &
                       whole_depth(units, groove%md)//', '// &
                       to_text(100.0_wp*groove%wall_left, few)//' % of the wall left'//left)
   end subroutine append_groove

   !> Change of length and its parts, and the force that a packer takes.
   pure subroutine append_length_change(lines, units, model, number, whole)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      integer, intent(in) :: number                    !< of the load case
      type(whole_string_type), intent(in) :: whole
      character(:), allocatable :: reference
      reference = 'the string before it was run'
      associate (load_case => model%cases(number), change => whole%length_change)
         if (load_case%length_reference > 0) reference = 'case '//model%cases(load_case%length_reference)%name
         call append_text(lines, '  Change of length in '//load_case%name//': '//shown(total_change(change))//' '// &
                          trim(units%length_label)//' (force '//shown(change%force)//', pressure (ballooning) '// &
                          shown(change%pressure)//', buckling '//shown(change%buckling)//', temperature '// &
                          shown(change%temperature)//')')
         call append_text(lines, '    longer is positive, against '//reference)
         if (whole%packer_force%present .and. abs(whole%packer_force%value) > 0.0_wp) &
            call append_text(lines, '  Force on the packer in '//load_case%name//': '// &
                             in_units(units, unit_force, abs(whole%packer_force%value), few)// &
                             either(' down', ' up', whole%packer_force%value > 0.0_wp))
      end associate
   contains
      pure function shown(length) result(text)
         real(wp), intent(in) :: length   !< [m]
         character(:), allocatable :: text
         text = fixed_text(length/units%length, 3)
      end function shown
   end subroutine append_length_change

   !> Axial force at each jar: a jar near the neutral point works badly and wears.
   pure subroutine append_jars(lines, units, model, result, name)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      character(*), intent(in) :: name                 !< of the case
      real(wp), allocatable :: tops(:)
      character(:), allocatable :: label
      real(wp) :: bit, md, axial
      integer :: i
      bit = model%cases(result%case_index)%bit_depth
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         do i = 1, size(tops)
            associate (part => string%components(i))
               if (lower_case(part%kind) /= jar_kind .or. .not. tops(i) < tops(size(tops))) cycle      ! or above surface
               md = bit - (tops(i) - 0.5_wp*part%length)
               axial = result%profile%axial(minloc(abs(result%profile%md - md), dim=1))
               label = 'Jar '
               if (lower_case(part%name) /= jar_kind) label = label//part%name//' '
               call append_text(lines, '  '//label//'in '//name//': '// &
                                either('tension', 'compression', axial >= 0.0_wp)//' of '// &
                                in_units(units, unit_force, abs(axial), few)//' at '// &
                                whole_depth(units, md))
            end associate
         end do
      end associate
   end subroutine append_jars

   !> A number that counts beyond a least one.
   elemental function beyond(value, least) result(number)
      real(wp), intent(in) :: value, least
      type(optional_real) :: number
      number = optional_real(value > least, value)
   end function beyond

   !> The least or the largest of some numbers, with its case and place.
   pure subroutine append_extreme(lines, units, names, what, quantity, decimals, numbers, depths, largest)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(text_type), intent(in) :: names(:)                      !< of the cases
      character(*), intent(in) :: what
      integer, intent(in) :: quantity, decimals
      type(optional_real), intent(in) :: numbers(:), depths(:)     !< as many
      logical, intent(in) :: largest
      character(head_width) :: head
      character(:), allocatable :: line
      integer :: k
      if (.not. any(numbers%present)) return
      k = minloc(merge(-numbers%value, numbers%value, largest), mask=numbers%present, dim=1)
      head = '  '//what
      line = head//fixed_text(numbers(k)%value/unit_factor(units, quantity), decimals)
      if (unit_label(units, quantity) /= '') line = line//' '//unit_label(units, quantity)
      if (depths(k)%present) line = line//' at '//whole_depth(units, depths(k)%value)
      call append_text(lines, line//' ('//names(k)%text//')')
   end subroutine append_extreme
end module dg_limits_table

!> The groups &calibrate of a deck: factors that are unknown, and checks that its measurements can determine them.
module dg_deck_calibrate
   use dg_calibration, only: calibrate_friction, calibrate_friction_axial, calibrate_friction_rotary, calibration_type, &
                             offset_depths, offset_name, offset_one, parameter_name, set_data, set_unknowns, solutions_a_step, &
                             tells, unknown_type
   use dg_checked_group, only: checked_group_type, claim_name, group_fault, is_given, is_sound, line_of, logical_of, named, &
      optional_of, text_of, texts_of
   use dg_deck_draft, only: draft_type, find_case
   use dg_error, only: error_list_type
   use dg_hole_section, only: hole_section_type
   use dg_measured_cases, only: list_measured_cases, list_models
   use dg_load_case, only: load_case_type, operation_name
   use dg_missing, only: given
   use dg_text, only: name_shown, quoted, suggestion, text_type, to_text
   implicit none
   private
   public :: read_calibration_groups

   !> Digits of a depth in a message.
   integer, parameter :: depth_digits = 7
   character(*), parameter :: not_for_friction(2) = [character(14) :: 'sticking_depth', 'stretch']

   !> Bounds of one calibration. A step of its fit takes as many solutions as given here, of all its models.
   integer, parameter :: most_cases = 10000, most_pairs = 1000000, most_unknowns = 1000, most_solutions = 100000

contains

   !> All calibrations of a deck, in its order, and the faults of each.
   subroutine read_calibration_groups(draft, groups, calibrations, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: groups(:)
      type(calibration_type), allocatable, intent(out) :: calibrations(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: taken(:)
      integer, allocatable :: mine(:)
      integer :: n
      allocate (taken(0))
      allocate (mine, source=named(groups, 'calibrate'))
      mine = pack(mine, [(any(text_of(groups(mine(n)), 'parameter', trim(parameter_name(1))) == parameter_name), &
                         n=1, size(mine))])
      allocate (calibrations(size(mine)))
      do n = 1, size(mine)
         associate (group => groups(mine(n)))
            call read_one(draft, group, n, calibrations(n), faults)
            call check_apply(draft, group, calibrations(:n), faults)
            call claim_name(group, 'name', calibrations(n)%name, taken, faults)
         end associate
      end do
   end subroutine read_calibration_groups

   subroutine read_one(draft, group, number, calibration, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: number            !< of the calibration in the deck
      type(calibration_type), intent(out) :: calibration
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: texts(:)
      integer :: i, before
      before = faults%count
      allocate (texts(0))   ! the compiler's flow analysis takes it for undefined otherwise
      calibration%name = text_of(group, 'name', to_text(number))
      ! the first of the names where none is given, or an unknown one
      calibration%parameter = max(1, findloc(parameter_name == text_of(group, 'parameter', ''), .true., dim=1))
      calibration%offset = max(1, findloc(offset_name == text_of(group, 'offset', ''), .true., dim=1))
      if (is_given(group, 'separate')) then
         texts = texts_of(group, 'separate')
         calibration%by_hole = .false.
         do i = 1, size(texts)
            if (texts(i)%text == 'holes') calibration%by_hole = .true.
            if (texts(i)%text == 'operations') calibration%by_operation = .true.
            if (texts(i)%text == 'depths') calibration%by_depth = .true.
            if (texts(i)%text == 'none' .and. size(texts) > 1) &
               call group_fault(group, 'separate', "separate holds 'none' and something else; keep one", faults)
         end do
      end if
      do i = 1, size(not_for_friction)
         if (.not. is_given(group, trim(not_for_friction(i))) .or. .not. is_sound(group, 'parameter')) cycle
         call group_fault(group, trim(not_for_friction(i)), trim(not_for_friction(i))//' has no meaning with parameter = '// &
            quoted(trim(parameter_name(calibration%parameter)))//'; leave it out', faults)
      end do
      calibration%apply = logical_of(group, 'apply', .false.)
      call list_models(group, calibration%models)
      calibration%hookload_deviation = optional_of(group, 'hookload_deviation')
      calibration%torque_deviation = optional_of(group, 'torque_deviation')
      call read_predicted(draft, group, calibration%predicted, faults)
      call list_measured_cases(draft, group, calibration%cases, faults, calibration%predicted)
      call read_holes(draft, group, calibration%holes, faults)
      if (faults%count > before .or. .not. all(group%values%sound .or. .not. group%values%given)) return
      if (.not. (all(draft%cases(calibration%cases)%sound) .and. all(draft%holes%sound))) return
      call lay_out(draft, group, calibration, faults)
   end subroutine read_one

   !> Numbers of the load cases that are to be predicted, each once; none where none is named.
   subroutine read_predicted(draft, group, cases, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, allocatable, intent(out) :: cases(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: wanted(:), used(:)
      integer :: i, k, found
      allocate (cases(0))
      allocate (wanted, source=texts_of(group, 'predict'))
      allocate (used, source=texts_of(group, 'cases'))
      do i = 1, size(wanted)
         call find_case(draft, group%name, line_of(group, 'predict'), wanted(i)%text, found, faults)
         if (found == 0) cycle
         if (any([(used(k)%text == wanted(i)%text, k=1, size(used))])) then
            call group_fault(group, 'predict', 'load case '//quoted(wanted(i)%text)// &
               ' is one of cases, so it would be no prediction; keep it in one', faults)
         else if (.not. any(cases == found)) then
            cases = [cases, found]
         end if
      end do
   end subroutine read_predicted

   !> Numbers of the hole sections named; all if none is. No fault if the name of a section is at fault itself.
   subroutine read_holes(draft, group, holes, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, allocatable, intent(out) :: holes(:)
      type(error_list_type), intent(inout) :: faults
      type(text_type), allocatable :: wanted(:)
      character(name_shown) :: names(size(draft%holes))
      integer :: i, k
      allocate (wanted, source=texts_of(group, 'holes'))
      do k = 1, size(names)
         names(k) = draft%holes(k)%section%name
      end do
      allocate (holes(0))
      if (.not. is_given(group, 'holes')) holes = [(k, k=1, size(names))]
      do i = 1, size(wanted)
         do k = 1, size(names)
            if (draft%holes(k)%section%name == wanted(i)%text .and. .not. any(holes == k)) holes = [holes, k]
         end do
         if (any(names == '')) cycle
         if (.not. any([(draft%holes(k)%section%name == wanted(i)%text, k=1, size(names))])) &
            call group_fault(group, 'holes', 'there is no hole section '//quoted(wanted(i)%text)//'; '// &
               suggestion(wanted(i)%text, names), faults)
      end do
   end subroutine read_holes

   !> List unknowns and data, and refuse unknowns that these data cannot determine.
   subroutine lay_out(draft, group, calibration, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(calibration_type), intent(inout) :: calibration
      type(error_list_type), intent(inout) :: faults
      type(load_case_type) :: load_cases(size(draft%cases))
      type(hole_section_type) :: holes(size(draft%holes))
      logical, allocatable :: telling(:, :)
      integer :: d, i, u
      if (too_many(size(calibration%cases), most_cases, 'load cases')) return
      if (too_many(size(calibration%cases)*size(calibration%holes), most_pairs, 'pairs of load case and hole section')) return
      load_cases = draft%cases%load_case
      holes = draft%holes%section
      call set_unknowns(calibration, load_cases, holes)
      if (too_many(size(calibration%unknowns), most_unknowns, 'unknowns')) return
      if (too_many(solutions_a_step(calibration)*size(calibration%models), most_solutions, 'solutions a step')) return
      call set_data(calibration, load_cases)
      do i = 1, size(calibration%holes)
         if (any(calibration%unknown_of(:, i) > 0)) cycle
         if (.not. (calibration%by_hole .or. is_given(group, 'holes'))) cycle
         call group_fault(group, 'holes', 'no bit of its cases reaches hole section '// &
            quoted(holes(calibration%holes(i))%name)//'; leave it out of holes', faults)
      end do
      call check_predicted(draft, group, calibration, faults)
      if (size(calibration%unknowns) == 0 .or. .not. all(draft%cases%sound)) return
      allocate (telling(size(calibration%data), size(calibration%unknowns)))
      do u = 1, size(calibration%unknowns)
         do d = 1, size(calibration%data)
            telling(d, u) = tells(calibration, load_cases, d, u)
         end do
         if (any(telling(:, u))) cycle
         call group_fault(group, 'cases', 'nothing measured tells '//unknown_words(draft, calibration%unknowns(u))// &
            ': hook loads tell friction along the hole, torques friction around it, where the string moves so; '// &
            'add such a case or leave out those that ask for it', faults)
      end do
      if (count(any(telling, dim=2)) < size(calibration%unknowns)) &
         call group_fault(group, 'cases', to_text(count(any(telling, dim=2)))//' measured values for '// &
            to_text(size(calibration%unknowns))//' unknowns: add measurements, or leave out separate or offset', faults)
   contains
      !> True if a number is above its bound; then adds a message.
      function too_many(number, most, what) result(yes)
         integer, intent(in) :: number, most
         character(*), intent(in) :: what
         logical :: yes
         yes = number > most
         if (yes) call group_fault(group, 'cases', to_text(number)//' '//what//'; a calibration has at most '//to_text(most)// &
            '; name fewer cases or holes, or separate less', faults)
      end function too_many
   end subroutine lay_out

   !> Check load cases of a prediction. The factors of its depth and operation must be among the unknowns.
   subroutine check_predicted(draft, group, calibration, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(calibration_type), intent(in) :: calibration
      type(error_list_type), intent(inout) :: faults
      integer :: i
      if (size(calibration%predicted) == 0) return
      if (calibration%by_depth .or. calibration%offset == offset_depths) &
         call group_fault(group, 'predict', &
            'predict has no meaning with a factor or an offset a depth: none is that of another depth', faults)
      if (.not. calibration%by_operation) return
      do i = 1, size(calibration%predicted)
         associate (case => draft%cases(calibration%predicted(i))%load_case)
            if (any(calibration%unknowns%operation == case%operation)) cycle
            call group_fault(group, 'predict', 'load case '//quoted(case%name)//': no measured case tells a factor of '// &
               trim(operation_name(case%operation))//'; leave it out or separate less', faults)
         end associate
      end do
   end subroutine check_predicted

   !> Check factors that are applied. There must be one factor per hole section, from one model and one calibration, and no load
   !> case of its own may overrule it.
   subroutine check_apply(draft, group, calibrations, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(calibration_type), intent(in) :: calibrations(:)      !< up to that of the group
      type(error_list_type), intent(inout) :: faults
      integer :: i, j
      associate (mine => calibrations(size(calibrations)))
         if (.not. (mine%apply .and. allocated(mine%holes))) return
         if (mine%by_operation .or. mine%by_depth) call group_fault(group, 'apply', &
            "apply needs separate = 'none' or 'holes': a factor of an "// &
            'operation or depth has no place in a hole section; put it into load cases by hand', faults)
         if (size(mine%models) > 1) call group_fault(group, 'apply', 'apply needs one model, to tell whose factors are meant', &
            faults)
         do i = 1, size(mine%cases)
            associate (case => draft%cases(mine%cases(i)))
               if (case%load_case%friction_axial%present .and. mine%parameter /= calibrate_friction_rotary .or. &
                   case%load_case%friction_rotary%present .and. mine%parameter /= calibrate_friction_axial) &
                  call group_fault(group, 'apply', 'load case '//quoted(case%load_case%name)//' (line '//to_text(case%line)// &
                     ') has friction of '// &
                     'its own, which stands above that of the hole; leave it out there, or leave out apply', faults)
            end associate
         end do
         do i = 1, size(calibrations) - 1
            if (.not. (calibrations(i)%apply .and. allocated(calibrations(i)%holes))) cycle
            if (draft%rig%given .and. mine%offset == offset_one .and. calibrations(i)%offset == offset_one) &
               call group_fault(group, 'apply', 'calibration '//quoted(calibrations(i)%name)// &
                  ' applies an offset to the block_weight of &rig '//'already; keep one', faults)
            if (mine%parameter /= calibrate_friction .and. calibrations(i)%parameter /= calibrate_friction .and. &
                mine%parameter /= calibrations(i)%parameter) cycle
            do j = 1, size(mine%holes)
               if (any(calibrations(i)%holes == mine%holes(j))) exit
            end do
            if (j > size(mine%holes)) cycle
            call group_fault(group, 'apply', 'calibration '//quoted(calibrations(i)%name)// &
               ' applies friction of hole section '//quoted(draft%holes(mine%holes(j))%section%name)//' already; keep one', &
               faults)
         end do
      end associate
   end subroutine check_apply

   !> Name of an unknown, for messages.
   function unknown_words(draft, unknown) result(words)
      type(draft_type), intent(in) :: draft
      type(unknown_type), intent(in) :: unknown
      character(:), allocatable :: words
      words = 'the factor'
      if (unknown%is_offset) words = 'the offset of the hook load'
      if (unknown%hole > 0) words = words//' of hole section '//quoted(draft%holes(unknown%hole)%section%name)
      if (unknown%operation > 0) words = words//' of '//trim(operation_name(unknown%operation))
      if (unknown%bit_depth%present) words = words//' at bit_depth = '// &
         to_text(unknown%bit_depth%value/draft%units%length, depth_digits)
   end function unknown_words
end module dg_deck_calibrate

!> A range of bit depths in a group of a deck: which string, in which operations, by which models.
module dg_deck_range
   use dg_kinds, only: wp
   use dg_checked_group, only: checked_group_type, group_fault, is_given, is_sound, line_of, places_of, real_of, reals_of, &
      text_of, texts_of
   use dg_deck_check, only: check_case
   use dg_deck_draft, only: deck_type, draft_case_type, draft_type, note_use, string_use_type
   use dg_error, only: error_list_type
   use dg_job, only: model_name
   use dg_load_case, only: load_case_type, moves_axially, operation_from_name, operation_rotate_off_bottom, operation_trip_in, &
      operation_trip_out, rotates
   use dg_missing, only: given
   use dg_sweep, only: at_operation, measured_type, regular_depths, sweep_type, with_depths
   use dg_text, only: is_separator_free, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: read_range, note_range_use

   !> Distance of depths where a deck says nothing [m].
   real(wp), parameter :: usual_step = 30.0_wp
   !> Most points of a sweep: more is a slip in bit_depth_step.
   integer, parameter :: most_points = 1000000
   !> Digits of a depth in a message.
   integer, parameter :: depth_digits = 7

contains

   !> Notes the use of a string by a range without fault.
   subroutine note_range_use(deck, range, group)
      type(deck_type), intent(inout) :: deck
      type(sweep_type), intent(in) :: range
      character(*), intent(in) :: group      !< of the deck, by name
      type(string_use_type) :: use
      if (.not. allocated(range%depths)) return
      use%string = range%string
      use%depth = maxval(range%depths)
      use%turns = any(rotates(range%operations))
      use%operations = range%operations
      use%group = group
      allocate (use%wob(0), use%tob(0))
      if (allocated(range%wob)) use%wob = range%wob
      if (allocated(range%tob)) use%tob = range%tob
      use%measured = measured_cases(range)
      call note_use(deck, use)
   end subroutine note_range_use

   !> Measurements of a range as load cases.
   pure function measured_cases(range) result(cases)
      type(sweep_type), intent(in) :: range
      type(load_case_type), allocatable :: cases(:)
      integer :: i, k
      if (.not. allocated(range%measured)) then
         allocate (cases(0))
         return
      end if
      allocate (cases(size(range%measured)))
      do i = 1, size(cases)
         cases(i)%name = range%measured(i)%name
         cases(i)%string = range%string
         cases(i)%bit_depth = range%measured(i)%bit_depth
         cases(i)%operation = range%measured(i)%operation
         cases(i)%measured_hookload = range%measured(i)%hookload
         cases(i)%measured_torque = range%measured(i)%torque
         do k = 1, size(range%operations)
            if (range%operations(k) == cases(i)%operation) cases(i)%wob = at_operation(range%wob, k)
         end do
      end do
   end function measured_cases

   !> String, operations and depths of a group: a &sweep, or another that has its keys. Its depths are not allocated where there
   !> is a fault.
   subroutine read_range(draft, group, number, models, sweep, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      integer, intent(in) :: number                !< of the sweep in the deck
      integer, intent(in) :: models(:)
      type(sweep_type), intent(out) :: sweep
      type(error_list_type), intent(inout) :: faults
      type(draft_case_type) :: probe
      type(text_type), allocatable :: texts(:)
      real(wp), allocatable :: numbers(:)
      real(wp) :: first, last, step, points
      character(:), allocatable :: key
      integer :: i, m, before
      before = faults%count
      allocate (texts(0), numbers(0))   ! the compiler's flow analysis takes them for undefined otherwise
      sweep%name = text_of(group, 'name', to_text(number))
      if (.not. is_separator_free(sweep%name)) call group_fault(group, 'name', 'name = '//quoted(sweep%name)// &
         ' cannot be part of a file name; use letters, digits and _ - . +, no dot first', faults)
      sweep%string = text_of(group, 'string', 'main')
      sweep%operations = [operation_trip_out, operation_trip_in, operation_rotate_off_bottom]
      if (is_given(group, 'operations')) then
         texts = texts_of(group, 'operations')
         sweep%operations = [integer ::]
         do i = 1, size(texts)
            m = operation_from_name(texts(i)%text)
            if (m > 0 .and. .not. any(sweep%operations == m)) sweep%operations = [sweep%operations, m]  ! named twice: runs once
         end do
      end if
      sweep%models = models
      if (is_given(group, 'model')) sweep%models = places_of(group, 'model', model_name)
      call read_loads(group, sweep, faults)
      key = 'frictions'
      if (group%name /= 'sweep') key = 'friction'      ! one of them
      numbers = reals_of(group, key)
      allocate (sweep%frictions(max(size(numbers), 1)))
      do i = 1, size(numbers)
         if (any(abs(numbers(:i - 1) - numbers(i)) <= 0.0_wp)) &
            call group_fault(group, 'frictions', 'frictions holds '//to_text(numbers(i))//' twice; keep one', faults)
         sweep%frictions(i) = given(numbers(i))
      end do
      if (group%name == 'sweep') call read_pairs(draft, group, sweep, faults)
      call set_default_end(draft, group, last)
      first = real_of(group, 'bit_depth_from', 0.0_wp)
      step = real_of(group, 'bit_depth_step', usual_step)
      probe%group = group%name
      probe%depth_key = 'bit_depth_to'
      probe%what = 'sweep'
      probe%line = group%line
      probe%line_depth = line_of(group, 'bit_depth_to')
      probe%line_string = line_of(group, 'string')
      probe%sound = .true.
      probe%load_case%name = sweep%name
      probe%load_case%string = sweep%string
      probe%load_case%bit_depth = last
      if (last > 0.0_wp .and. is_sound_or_absent('bit_depth_to') .and. is_sound(group, 'string')) &
         call check_case(draft, probe, faults)
      last = probe%load_case%bit_depth
      if (faults%count > before .or. .not. (last > 0.0_wp .and. step > 0.0_wp)) return
      if (.not. (is_sound(group, 'bit_depth_from') .and. is_sound(group, 'bit_depth_step'))) return
      if (first > last) then
         call group_fault(group, 'bit_depth_from', 'bit_depth_from = '//shown(first)//' lies below bit_depth_to = '// &
            shown(last), faults)
         return
      end if
      points = ((last - first)/step + 1.0_wp)*size(sweep%operations)*size(sweep%frictions)*size(sweep%models)
      if (points > real(most_points, wp)) then
         call group_fault(group, 'bit_depth_step', 'bit_depth_step = '//shown(step)//' makes '//to_text(points, 7)// &
            ' points; at most '//to_text(most_points)//' can be solved in one sweep', faults)
         return
      end if
      sweep%depths = regular_depths(first, last, step)
      call add_measured(draft, sweep)

   contains

      pure function is_sound_or_absent(key) result(yes)
         character(*), intent(in) :: key
         logical :: yes
         yes = is_sound(group, key) .or. .not. is_given(group, key)
      end function is_sound_or_absent

      pure function shown(depth) result(text)
         real(wp), intent(in) :: depth
         character(:), allocatable :: text
         text = in_units(draft%units, unit_length, depth, depth_digits)
      end function shown
   end subroutine read_range

   !> Loads and speeds, one of all operations or one of each; reaming needs both speeds.
   subroutine read_loads(group, sweep, faults)
      type(checked_group_type), intent(in) :: group
      type(sweep_type), intent(inout) :: sweep
      type(error_list_type), intent(inout) :: faults
      integer :: o
      call copy_loads('wob', sweep%wob)
      call copy_loads('tob', sweep%tob)
      call copy_loads('rpm', sweep%angular_speed)
      call copy_loads('trip_speed', sweep%trip_speed)
      do o = 1, size(sweep%operations)
         if (.not. (rotates(sweep%operations(o)) .and. moves_axially(sweep%operations(o)))) cycle
         call need_speed('rpm', at_operation(sweep%angular_speed, o))
         call need_speed('trip_speed', at_operation(sweep%trip_speed, o))
         exit
      end do
   contains
      subroutine copy_loads(key, loads)
         character(*), intent(in) :: key
         real(wp), allocatable, intent(out) :: loads(:)
         loads = reals_of(group, key)
         if (any(size(loads) == [0, 1, size(sweep%operations)]) .or. .not. is_sound(group, 'operations')) return
         call group_fault(group, key, key//' has '//to_text(size(loads))//' values for '//to_text(size(sweep%operations))// &
            ' operations; give one, or one for each', faults)
      end subroutine copy_loads

      subroutine need_speed(key, value)
         character(*), intent(in) :: key
         real(wp), intent(in) :: value
         if (value > 0.0_wp .or. .not. is_sound(group, key)) return
         call group_fault(group, key, 'reaming needs '//key//' > 0', faults)
      end subroutine need_speed
   end subroutine read_loads

   !> Pairs of friction in cased and open hole.
   subroutine read_pairs(draft, group, sweep, faults)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      type(sweep_type), intent(inout) :: sweep
      type(error_list_type), intent(inout) :: faults
      real(wp), allocatable :: cased(:), open(:)
      character(:), allocatable :: key
      integer :: i, j
      allocate (cased(0), open(0))
      if (.not. (is_given(group, 'frictions_cased') .or. is_given(group, 'frictions_open'))) return
      ! A number that is none is told already.
      if (is_given(group, 'frictions_cased') .neqv. is_sound(group, 'frictions_cased')) return
      if (is_given(group, 'frictions_open') .neqv. is_sound(group, 'frictions_open')) return
      cased = reals_of(group, 'frictions_cased')
      open = reals_of(group, 'frictions_open')
      key = 'frictions_cased'
      if (.not. is_given(group, key)) key = 'frictions_open'
      if (is_given(group, 'frictions')) call group_fault(group, key, &
         'frictions_cased and frictions_open stand in place of frictions; keep one way', faults)
      if (size(cased) /= size(open)) call group_fault(group, key, 'frictions_cased has '//to_text(size(cased))// &
         ' values, frictions_open has '//to_text(size(open))//'; they go in pairs', faults)
      if (.not. (any(draft%holes%section%cased) .and. any(.not. draft%holes%section%cased))) &
         call group_fault(group, key, 'pairs of friction need a hole section with cased = .true., and one without', faults)
      if (size(cased) /= size(open) .or. size(cased) == 0) return
      do i = 1, size(cased)
         do j = 1, i - 1
            if (max(abs(cased(i) - cased(j)), abs(open(i) - open(j))) <= 0.0_wp) &
               call group_fault(group, key, 'the pair '//to_text(cased(i))//', '//to_text(open(i))// &
                  ' stands there twice; keep one', faults)
         end do
      end do
      sweep%frictions_cased = cased
      deallocate (sweep%frictions)
      allocate (sweep%frictions(size(open)))
      sweep%frictions = given(open)
   end subroutine read_pairs

   !> The last depth [m]: as given, else the end of survey and holes; 0 where these are not known.
   subroutine set_default_end(draft, group, last)
      type(draft_type), intent(in) :: draft
      type(checked_group_type), intent(in) :: group
      real(wp), intent(out) :: last
      last = real_of(group, 'bit_depth_to', 0.0_wp)
      if (is_given(group, 'bit_depth_to')) return
      if (.not. draft%has_stations .or. size(draft%holes) == 0) return
      if (.not. all(draft%holes%sound)) return
      last = min(draft%stations%md(size(draft%stations%md)), draft%holes(size(draft%holes))%section%md_bottom)
   end subroutine set_default_end

   !> Measurements that load cases of the deck tell of this string in these operations. Their depths join the sweep's, so
   !> that each can be laid beside a calculated value.
   subroutine add_measured(draft, sweep)
      type(draft_type), intent(in) :: draft
      type(sweep_type), intent(inout) :: sweep
      type(measured_type), allocatable :: found(:)
      real(wp) :: depths(size(draft%cases))
      integer :: i, n, o
      allocate (found(size(draft%cases)))
      n = 0
      do i = 1, size(draft%cases)
         associate (case => draft%cases(i)%load_case)
            if (.not. draft%cases(i)%sound) cycle
            if (case%string /= sweep%string .or. .not. any(sweep%operations == case%operation)) cycle
            if (.not. (case%measured_hookload%present .or. case%measured_torque%present)) cycle
            if (case%bit_depth < sweep%depths(1) .or. case%bit_depth > sweep%depths(size(sweep%depths))) cycle
            o = findloc(sweep%operations, case%operation, dim=1)
            if (abs(case%wob - at_operation(sweep%wob, o)) > 0.0_wp .or. &
                abs(case%tob - at_operation(sweep%tob, o)) > 0.0_wp) cycle   ! another load
            n = n + 1
            found(n)%name = case%name
            found(n)%operation = case%operation
            found(n)%bit_depth = case%bit_depth
            found(n)%hookload = case%measured_hookload
            found(n)%torque = case%measured_torque
            depths(n) = case%bit_depth
         end associate
      end do
      sweep%measured = found(:n)
      sweep%depths = with_depths(sweep%depths, depths(:n))
   end subroutine add_measured
end module dg_deck_range

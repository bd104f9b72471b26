!> Opening of a deck: it is read with all files that it names, and checked. Groups of studies are read by the studies. Closing
!> of a deck: the model is built, in SI units. All faults are reported together, and no model is built if there is one.
module dg_open_deck
   use dg_catalogue, only: catalogue_within
   use dg_checked_group, only: checked_group_type, group_fault, integer_of, is_given, is_sound, logical_of, optional_of, &
      places_of, real_of, text_of
   use dg_deck_advice, only: key_advice
   use dg_deck_catalogue, only: fill_from_catalogue
   use dg_deck_centralizer, only: read_centralizers
   use dg_deck_check, only: close_holes, check_draft
   use dg_deck_draft, only: deck_type, draft_type, lowest_of, sections_of
   use dg_deck_fluid, only: draft_fluid, note_fluids, place_fluids
   use dg_deck_notes, only: note_oddities
   use dg_deck_parts, only: draft_hole, draft_component, draft_case, draft_boundary, draft_design, draft_numerics, draft_rig
   use dg_deck_schema, only: group_keys_type, group_place, name_length
   use dg_deck_source, only: default_folder, input_path
   use dg_deck_survey, only: read_stations
   use dg_deck_text, only: group_type, parse_groups
   use dg_deck_tie_on, only: tie_on
   use dg_deck_token, only: token_type, tokenize
   use dg_deck_tortuosity, only: apply_tortuosity
   use dg_deck_values, only: check_group
   use dg_drillstring, only: drillstring_type
   use dg_error, only: add_fault, error_list_type, error_type
   use dg_file_lines, only: beside
   use dg_job, only: job_type, model_name
   use dg_meant_units, only: check_units
   use dg_missing, only: optional_real
   use dg_model, only: model_type
   use dg_numerics, only: settings_of
   use dg_rig, only: rig_type
   use dg_text, only: append_text, text_type, to_text
   use dg_trajectory, only: interpolation_minimum_curvature, interpolation_spline, new_trajectory
   use dg_units, only: deck_system, unit_system, unit_system_type, si_units
   use dg_unusual_case, only: note_deviations, usual_inside
   use dg_unusual_input, only: note_unusual
   use dg_unusual_rig, only: note_rig
   implicit none
   private
   public :: open_deck, close_deck

contains

   !> Open a deck whose lines are read. If its units are not `known`, nothing else is read.
   subroutine open_deck(path, lines, rules, deck, job, known, faults)
      character(*), intent(in) :: path
      type(text_type), intent(in) :: lines(:)
      type(group_keys_type), intent(in) :: rules(:)      !< groups that a deck may have, with their keys
      type(deck_type), intent(out) :: deck
      type(job_type), intent(inout) :: job
      logical, intent(out) :: known
      type(error_list_type), intent(inout) :: faults
      type(token_type), allocatable :: tokens(:)
      type(group_type), allocatable :: groups(:)
      character(:), allocatable :: catalogue
      integer :: i, k
      allocate (deck%uses(0), deck%estimates(0))
      call tokenize(lines, tokens)
      call parse_groups(path, tokens, groups, faults)
      deallocate (tokens)
      call check_group_names(path, groups, rules, faults)
      deck%draft%path = path
      call find_units(path, groups, rules, deck%draft%units, known, faults)
      if (known) call check_units(path, groups, deck%draft%units, known, faults)
      if (.not. known) return      ! of numbers in unknown units no range and no other file can be checked
      allocate (deck%groups(size(groups)))
      do i = 1, size(groups)
         k = group_place(rules, groups(i)%name)
         if (k > 0) then
            call check_group(path, groups(i), rules(k)%keys, deck%draft%units, deck%groups(i), faults)
         else
            deck%groups(i)%name = ''        ! reported already
         end if
         deallocate (groups(i)%entries)
      end do
      call read_job(path, deck%draft%units, deck%groups, job)
      job%deck_text = text_of_lines(lines)
      call fill_from_catalogue(path, deck%groups, catalogue, faults)
      call read_draft(deck%groups, deck%draft, faults)
      call apply_tortuosity(deck%groups, deck%draft, faults)
      call read_centralizers(deck%groups, deck%draft, faults)
      call read_rig_limit(deck%groups, deck%draft%rig, faults)
      call close_holes(deck%draft, faults)
      call check_draft(deck%draft, faults)
      deck%inputs = inputs_of(path, deck%groups, catalogue)
   end subroutine open_deck

   !> Build the model of a deck without faults. Notes of the job name legal but unusual settings.
   subroutine close_deck(deck, job, model, faults)
      type(deck_type), intent(inout) :: deck
      type(job_type), intent(inout) :: job
      type(model_type), intent(out) :: model
      type(error_list_type), intent(inout) :: faults
      type(model_type) :: sound
      logical :: fitted
      job%inputs = deck%inputs
      if (faults%count == 0) call build_model(deck%draft, model, faults)
      if (faults%count > 0) return
      if (allocated(deck%draft%path_notes)) job%notes = [job%notes, deck%draft%path_notes]
      if (allocated(deck%draft%path_warnings)) job%notes = [job%notes, deck%draft%path_warnings]
      fitted = .false.
      if (allocated(deck%estimates)) fitted = size(deck%estimates) > 0
      call note_unusual(deck%draft, deck%uses, fitted, job%notes)
      call note_deviations(deck%draft%units, deck%groups, job%notes)
      call note_oddities(deck%draft, job, deck%uses)
      sound = usual_inside(model)
      call note_fluids(sound, deck%draft%units, job%notes)
      call note_rig(sound, deck%uses, deck%draft%units, job%notes)
   end subroutine close_deck

   !> Groups: known, not given twice where once is enough, none missing.
   subroutine check_group_names(path, groups, rules, faults)
      character(*), intent(in) :: path
      type(group_type), intent(in) :: groups(:)
      type(group_keys_type), intent(in) :: rules(:)      !< groups that a deck may have
      type(error_list_type), intent(inout) :: faults
      character(name_length) :: names(size(rules))
      character(len(rules(1)%rule%meaning)) :: meanings(size(rules))
      integer :: i, j, k, slips, found(size(rules))
      do k = 1, size(rules)
         names(k) = rules(k)%rule%name
         meanings(k) = rules(k)%rule%meaning
      end do
      slips = 0
      found = 0
      do i = 1, size(groups)
         k = group_place(rules, groups(i)%name)
         if (k == 0) then
            slips = slips + 1
            call add_fault(faults, path, groups(i)%line, 'unknown group &'//groups(i)%name//'; '// &
                           key_advice('', groups(i)%name, names, meanings))
            cycle
         end if
         found(k) = found(k) + 1
         if (found(k) == rules(k)%rule%most + 1) call add_fault(faults, path, groups(i)%line, 'group &'//groups(i)%name// &
            ': a deck has at most '//to_text(rules(k)%rule%most)//' of them')
         if (rules(k)%rule%repeatable) cycle
         do j = 1, i - 1
            if (groups(j)%name /= groups(i)%name) cycle
            call add_fault(faults, path, groups(i)%line, 'group &'//groups(i)%name//': given a second time, first in line '// &
                           to_text(groups(j)%line)//'; keep one')
            exit
         end do
      end do
      ! a misspelt group is most likely the missing one
      if (slips > 0) return
      do k = 1, size(rules)
         if (.not. rules(k)%rule%required) cycle
         do i = 1, size(groups)
            if (groups(i)%name == rules(k)%rule%name) exit
            if (rules(k)%rule%name == 'load_case' .and. rules(group_place(rules, groups(i)%name))%rule%own_cases) exit
         end do
         if (i > size(groups)) call add_fault(faults, path, 1, 'group &'//trim(rules(k)%rule%name)// &
            ': missing; a deck needs it ('//trim(rules(k)%rule%meaning)//')')
      end do
   end subroutine check_group_names

   !> Files that the deck is made of: itself, its survey, its catalogue ('': none).
   pure function inputs_of(path, groups, catalogue) result(inputs)
      character(*), intent(in) :: path
      type(checked_group_type), intent(in) :: groups(:)
      character(*), intent(in) :: catalogue
      type(text_type), allocatable :: inputs(:)
      integer :: i
      call append_text(inputs, input_path(path))
      do i = 1, size(groups)
         if (groups(i)%name /= 'trajectory') cycle
         if (text_of(groups(i), 'survey_file', '') /= '') &
            call append_text(inputs, beside(path, text_of(groups(i), 'survey_file', '')))
         if (text_of(groups(i), 'parent_file', '') /= '') &
            call append_text(inputs, beside(path, text_of(groups(i), 'parent_file', '')))
      end do
      if (catalogue /= '' .and. catalogue /= catalogue_within) call append_text(inputs, catalogue)
   end function inputs_of

   !> Find the units of the deck, which all else needs: SI by default. `known` is false if &job names an unknown system, and
   !> the faults of &job are noted. A system whose quote is not closed is known, so that other faults are found, too.
   subroutine find_units(path, groups, rules, units, known, faults)
      character(*), intent(in) :: path
      type(group_type), intent(in) :: groups(:)
      type(group_keys_type), intent(in) :: rules(:)
      type(unit_system_type), intent(out) :: units
      logical, intent(out) :: known
      type(error_list_type), intent(inout) :: faults
      type(checked_group_type) :: checked
      type(error_list_type) :: found
      character(:), allocatable :: system
      integer :: i
      units = si_units()
      known = .true.
      do i = 1, size(groups)
         if (groups(i)%name /= 'job') cycle
         associate (keys => rules(group_place(rules, 'job'))%keys)
            call check_group(path, groups(i), keys, units, checked, found)
            if (.not. is_given(checked, 'units')) cycle
            system = open_units(groups(i))
            known = is_sound(checked, 'units') .or. system /= ''
            if (.not. known) call check_group(path, groups(i), keys, units, checked, faults)
         end associate
         if (known) units = unit_system(text_of(checked, 'units', system))
         return
      end do
   end subroutine find_units

   !> First word of units behind a quote that is not closed, if it names a system; else ''.
   pure function open_units(group) result(system)
      type(group_type), intent(in) :: group
      character(:), allocatable :: system
      integer :: i
      system = ''
      do i = 1, size(group%entries)
         if (group%entries(i)%key /= 'units' .or. .not. allocated(group%entries(i)%open)) cycle
         system = group%entries(i)%open
         system = system(:scan(system//',', ' ,/!') - 1)
         if (deck_system(system) == 0) system = ''
      end do
   end function open_units

   !> Fills the job from &job, or from defaults where the deck has none.
   subroutine read_job(path, units, groups, job)
      character(*), intent(in) :: path
      type(unit_system_type), intent(in) :: units
      type(checked_group_type), intent(in) :: groups(:)
      type(job_type), intent(inout) :: job
      type(text_type), allocatable :: models(:)
      integer :: i
      job%deck_path = path
      job%units = units
      job%title = ''
      job%output_dir = default_folder(path)
      job%models = [1]
      allocate (models(0))
      do i = 1, size(groups)
         if (groups(i)%name /= 'job') cycle
         job%title = text_of(groups(i), 'title', '')
         job%output_dir = text_of(groups(i), 'output_dir', job%output_dir)
         if (job%output_dir == '') job%output_dir = default_folder(path)
         job%profiles = logical_of(groups(i), 'profiles', .true.)
         job%hdf5 = logical_of(groups(i), 'hdf5', .true.)
         job%plots = logical_of(groups(i), 'plots', .true.)
         job%threads = integer_of(groups(i), 'threads', 0)
         if (is_sound(groups(i), 'models')) job%models = places_of(groups(i), 'models', model_name)
         return
      end do
   end subroutine read_job

   !> The load that the rig may carry: rig_limit of &job is max_hookload of &rig under another name.
   subroutine read_rig_limit(groups, rig, faults)
      type(checked_group_type), intent(in) :: groups(:)
      type(rig_type), intent(inout) :: rig
      type(error_list_type), intent(inout) :: faults
      type(optional_real) :: limit
      integer :: i
      do i = 1, size(groups)
         if (groups(i)%name == 'job') limit = optional_of(groups(i), 'rig_limit')
      end do
      if (.not. limit%present) return
      do i = 1, size(groups)
         if (groups(i)%name /= 'rig' .or. .not. rig%max_hookload%present) cycle
         call group_fault(groups(i), 'max_hookload', 'max_hookload is rig_limit of &job under another name; keep one', faults)
         return
      end do
      rig%max_hookload = limit
   end subroutine read_rig_limit

   !> The lines of a file in one text, in linear time.
   pure function text_of_lines(lines) result(text)
      type(text_type), intent(in) :: lines(:)
      character(:), allocatable :: text
      integer :: i, length
      length = 0
      do i = 1, size(lines)
         length = length + len(lines(i)%text) + 1
      end do
      allocate (character(length) :: text)
      length = 0
      do i = 1, size(lines)
         text(length + 1:length + len(lines(i)%text) + 1) = lines(i)%text//new_line('a')
         length = length + len(lines(i)%text) + 1
      end do
   end function text_of_lines

   !> Fills the draft from all groups but &job.
   subroutine read_draft(groups, draft, faults)
      type(checked_group_type), intent(in) :: groups(:)
      type(draft_type), intent(inout) :: draft
      type(error_list_type), intent(inout) :: faults
      integer :: i, holes, fluids, components, cases
      allocate (draft%holes(count_of('hole')), draft%components(count_of('component')), draft%cases(count_of('load_case')))
      allocate (draft%fluids(count_of('fluid')))
      holes = 0
      fluids = 0
      components = 0
      cases = 0
      draft%numerics = settings_of('auto')      ! for a deck without &solver
      do i = 1, size(groups)
         select case (groups(i)%name)
         case ('job')
            draft%gravity = real_of(groups(i), 'gravity', draft%gravity)
         case ('trajectory')
            if (draft%trajectory_line > 0) cycle     ! a second one is a fault already
            draft%trajectory_line = groups(i)%line
            draft%interpolation = merge(interpolation_spline, interpolation_minimum_curvature, &
                                        text_of(groups(i), 'interpolation', '') == 'spline')
            call read_stations(groups(i), draft%units, draft%stations, draft%has_stations, draft%path_notes, &
                               draft%path_warnings, faults)
            if (draft%has_stations) call tie_on(groups(i), draft, faults)
         case ('hole')
            holes = holes + 1
            call draft_hole(groups(i), holes, draft%holes(holes))
         case ('fluid')
            fluids = fluids + 1
            call draft_fluid(groups(i), draft%fluids(fluids), faults)
         case ('rig')
            call draft_rig(groups(i), draft%rig, faults)
            draft%block_given = is_given(groups(i), 'block_weight')
         case ('component')
            components = components + 1
            call draft_component(groups(i), draft%units, draft%components(components), faults)
         case ('load_case')
            cases = cases + 1
            call draft_case(groups(i), draft%cases(cases), faults)
         case ('strength')
            draft%design = draft_design(groups(i))
         case ('boundary')
            call draft_boundary(groups(i), draft%boundary, faults)
         case ('solver')
            call draft_numerics(groups(i), draft%numerics, faults)
         case default
         end select
      end do
   contains
      pure function count_of(name) result(number)
         character(*), intent(in) :: name
         integer :: number
         integer :: k
         number = 0
         do k = 1, size(groups)
            if (groups(k)%name == name) number = number + 1
         end do
      end function count_of
   end subroutine read_draft

   !> Build the model. Remaining faults are stations without a valid path, and data of fluids that need the path.
   subroutine build_model(draft, model, faults)
      type(draft_type), intent(in) :: draft
      type(model_type), intent(out) :: model
      type(error_list_type), intent(inout) :: faults
      type(error_type), allocatable :: error
      integer :: i

      call new_trajectory(model%trajectory, draft%stations%md, draft%stations%inclination, draft%stations%azimuth, &
                          draft%interpolation, error)
      if (allocated(error)) then
         call add_fault(faults, draft%path, draft%trajectory_line, 'group &trajectory: '//error%message)
         return
      end if
      if (allocated(draft%path_notes)) model%path_notes = draft%path_notes
      model%holes = sections_of(draft)
      allocate (model%cases(size(draft%cases)))
      do i = 1, size(draft%cases)
         model%cases(i) = draft%cases(i)%load_case
      end do
      call build_strings(draft, model%strings)
      model%boundary = draft%boundary
      model%numerics = draft%numerics
      model%rig = draft%rig
      model%design = draft%design
      call place_fluids(draft, model%trajectory, model%mud, faults)
      model%gravity = draft%gravity
      model%units = draft%units
   end subroutine build_model

   !> Components of one name make one string, in the deck's order.
   pure subroutine build_strings(draft, strings)
      type(draft_type), intent(in) :: draft
      type(drillstring_type), allocatable, intent(out) :: strings(:)
      integer :: lowest(size(draft%components)), i, k, n
      integer, allocatable :: parts(:)
      lowest = lowest_of(draft)
      allocate (strings(count(lowest == [(i, i=1, size(lowest))])))
      n = 0
      do i = 1, size(lowest)
         if (lowest(i) < i) cycle
         n = n + 1
         strings(n)%name = draft%components(i)%string
         parts = pack([(k, k=1, size(lowest))], lowest == i)
         allocate (strings(n)%components(size(parts)))
         do k = 1, size(parts)
            strings(n)%components(k) = draft%components(parts(k))%component
         end do
      end do
   end subroutine build_strings
end module dg_open_deck

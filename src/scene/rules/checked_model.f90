!> Make a model of parts that a program has filled in, and check load cases of it. All checks of a deck are made, and that
!> nothing is missing. Messages are in SI units and name the wrong component: holes(2), strings(1)%components(3).
module dg_checked_model
   use dg_case_check, only: check_operation, check_passage, check_reach, check_string_length, check_string_name
   use dg_component, only: component_type
   use dg_error, only: add_fault, add_part_fault, clear_errors, error_list_type, error_type, first_errors, &
      other_of, other_place_of, place_of, raise, status_bad_input, whole_message
   use dg_fluid, only: fluid_type, standing_mud
   use dg_fluid_check, only: check_fluid, check_fluid_order
   use dg_hole_check, only: check_section, join_sections
   use dg_kinds, only: wp
   use dg_load_case, only: load_case_type
   use dg_missing, only: is_shown
   use dg_model, only: model_type, string_index
   use dg_model_parts, only: model_parts_type, survey_type
   use dg_numerics, only: settings_of
   use dg_opening_check, only: set_opened_depth
   use dg_range_check, only: check_case_ranges, check_centralizer_ranges, check_component_ranges, check_fluid_ranges, &
      check_numerics, check_numerics_ranges, check_range, check_rig_ranges, check_section_ranges, is_zero, ranges_type, set_ranges
   use dg_string_check, only: check_centralizer, check_component, check_in_string
   use dg_survey_check, only: begins_below, begins_vertical, check_station_numbers, check_station_order
   use dg_text, only: name_shown, quoted, to_text
   use dg_text_fault, only: find_text_fault
   use dg_trajectory, only: bottom_md, interpolation_minimum_curvature, interpolation_spline, new_trajectory, top_md
   use dg_units, only: base_units
   implicit none
   private
   public :: build_checked_model, check_load_case

   !> Most faults that a message names; the rest are counted.
   integer, parameter :: most_told = 20
   !> Length of a section whose end is not known [m].
   real(wp), parameter :: some_depth = 1.0_wp

contains

   !> Make the model, without load cases. Every part is checked. `error` names all faults, and then the model is not valid.
   subroutine build_checked_model(parts, model, error)
      type(model_parts_type), intent(in) :: parts
      type(model_type), intent(out) :: model
      type(error_type), allocatable, intent(out) :: error
      type(error_list_type) :: report
      logical :: sound_survey, sound_holes, sound_fluids
      model%units = base_units()
      model%boundary = parts%boundary
      model%rig = parts%rig
      model%gravity = parts%gravity
      model%numerics = settings_of('auto')
      if (allocated(parts%numerics)) model%numerics = parts%numerics
      call set_survey(parts%survey, model, report, sound_survey)
      call check_holes(parts, sound_survey, model, report, sound_holes)
      call check_fluids(parts, sound_survey, model, report, sound_fluids)
      call check_strings(parts, sound_fluids, model, report)
      if (report%count == 0) call set_openings(model, report)
      call check_settings(model, report)
      allocate (model%cases(0))
      call report_error(report, error)
   end subroutine build_checked_model

   !> Check a load case of a model, and set its defaults. A depth of the bit that is off by round-off becomes the end of the
   !> hole.
   subroutine check_load_case(model, load_case, error)
      type(model_type), intent(in) :: model            !< from build_checked_model or from a deck
      type(load_case_type), intent(inout) :: load_case
      type(error_type), allocatable, intent(out) :: error
      type(error_list_type) :: report, found
      character(name_shown) :: names(size(model%strings))
      character(:), allocatable :: whose
      integer :: i, k, string
      if (.not. allocated(load_case%name)) load_case%name = 'case'
      if (.not. allocated(load_case%section)) load_case%section = ''
      if (.not. allocated(load_case%string)) load_case%string = model%strings(1)%name
      whose = 'load case '//quoted(load_case%name)
      call check_text(load_case%name, 'name', whose, report)
      call check_text(load_case%section, 'section', whose, report)
      do i = 1, size(names)
         names(i) = model%strings(i)%name
      end do
      call check_case_ranges(load_case, found)
      if (found%count == 0) then
         call check_operation(load_case, found, 'angular_speed')
         call check_reach(load_case%bit_depth, 'bit_depth', 'survey', bottom_md(model%trajectory), base_units(), found)
         call check_reach(load_case%bit_depth, 'bit_depth', 'lowest hole section', model%holes(size(model%holes))%md_bottom, &
                          base_units(), found)
         if (load_case%bit_depth <= top_md(model%trajectory)) call add_part_fault(found, 'load_case', 0, 'bit_depth', &
            'bit_depth must lie below the first station')
      end if
      string = string_index(model%strings, load_case%string)
      if (string == 0) call check_string_name(load_case%string, names, found)
      if (found%count == 0) then
         associate (components => model%strings(string)%components)
            call check_string_length(components, size(components), load_case, 'bit_depth', base_units(), found)
            call check_passage(components, [(k, k=1, size(components))], model%holes, load_case%bit_depth, &
                               'case '//quoted(load_case%name), base_units(), found)
         end associate
      end if
      call report_all(found, whose, string, report)
      call report_error(report, error)
   end subroutine check_load_case

   !> Set the path. A vertical hole is added above a survey that begins below surface.
   subroutine set_survey(survey, model, report, sound)
      type(survey_type), intent(in) :: survey
      type(model_type), intent(inout) :: model
      type(error_list_type), intent(inout) :: report
      logical, intent(out) :: sound
      type(error_list_type) :: found
      type(error_type), allocatable :: error
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      integer :: i, before
      before = report%count
      sound = .false.
      if (.not. allocated(survey%md)) call add_fault(report, 'survey', 0, 'md is not allocated; give depths of stations')
      if (.not. allocated(survey%inclination)) call add_fault(report, 'survey', 0, &
         'inclination is not allocated; give that of each station')
      if (.not. any(survey%interpolation == [interpolation_minimum_curvature, interpolation_spline])) &
         call add_fault(report, 'survey', 0, 'interpolation = '//to_text(survey%interpolation)//' is not valid')
      if (report%count > before) return
      md = survey%md
      inclination = survey%inclination
      if (allocated(survey%azimuth)) then
         azimuth = survey%azimuth
      else
         azimuth = [(0.0_wp, i=1, size(md))]
      end if
      call check_station_numbers(md, inclination, azimuth, found)
      if (found%count == 0) call check_station_order(md, base_units(), found)
      if (found%count == 0) then
         if (begins_below(md(1)) .and. .not. begins_vertical(inclination(1))) call add_part_fault(found, 'trajectory', 0, 'md', &
            'the first station is at '//to_text(md(1))//' m and inclined; the survey must begin at surface, md = 0, or where '// &
            'the hole is still vertical')
      end if
      call report_all(found, 'survey', 0, report)
      if (report%count > before) return
      if (begins_below(md(1))) then
         md = [0.0_wp, md]
         inclination = [0.0_wp, inclination]
         azimuth = [azimuth(1), azimuth]
      end if
      call new_trajectory(model%trajectory, md, inclination, azimuth, survey%interpolation, error)
      sound = .not. allocated(error)
      if (.not. sound) call add_fault(report, 'survey', 0, error%message)
   end subroutine set_survey

   subroutine check_holes(parts, sound_survey, model, report, sound)
      type(model_parts_type), intent(in) :: parts
      logical, intent(in) :: sound_survey
      type(model_type), intent(inout) :: model
      type(error_list_type), intent(inout) :: report
      logical, intent(out) :: sound
      type(error_list_type) :: found
      integer :: i, n, before
      before = report%count
      n = 0
      if (allocated(parts%holes)) n = size(parts%holes)
      if (n == 0) call add_fault(report, 'holes', 0, 'missing; give sections from surface down')
      allocate (model%holes(n))
      do i = 1, n
         model%holes(i) = parts%holes(i)
         associate (hole => model%holes(i))
            if (.not. allocated(hole%name)) hole%name = 'hole '//to_text(i)
            call check_section_ranges_of(i == n)
            if (found%count == 0) call check_section(hole, i, base_units(), found)
            call report_all(found, 'holes('//to_text(i)//')', 0, report)
            call check_text(hole%name, 'name', 'holes('//to_text(i)//')', report)
         end associate
      end do
      if (report%count == before .and. n > 0) call join_sections(model%holes, base_units(), found)
      call report_each(found, 'holes', report)
      sound = report%count == before
   contains
      !> The last section may leave its end open. Without a survey the end is not known, and only its other numbers are checked.
      subroutine check_section_ranges_of(lowest)
         logical, intent(in) :: lowest
         if (lowest .and. is_zero(model%holes(i)%md_bottom)) then
            model%holes(i)%md_bottom = some_depth
            if (sound_survey) model%holes(i)%md_bottom = bottom_md(model%trajectory)
            if (.not. sound_survey .and. is_shown(model%holes(i)%md_top)) &
               model%holes(i)%md_bottom = model%holes(i)%md_top + some_depth
         end if
         call check_section_ranges(model%holes(i), i, found)
      end subroutine check_section_ranges_of
   end subroutine check_holes

   subroutine check_fluids(parts, sound_survey, model, report, sound)
      type(model_parts_type), intent(in) :: parts
      logical, intent(in) :: sound_survey
      type(model_type), intent(inout) :: model
      type(error_list_type), intent(inout) :: report
      logical, intent(out) :: sound
      type(error_list_type) :: found
      integer :: i, before
      before = report%count
      sound = .true.
      model%mud = standing_mud(0.0_wp)
      if (.not. allocated(parts%fluids)) return
      if (size(parts%fluids) == 0) return
      model%mud%fluids = parts%fluids
      do i = 1, size(parts%fluids)
         call check_fluid_ranges(parts%fluids(i), i, found)
         if (found%count == 0) call check_fluid(parts%fluids(i), i, found)
         call report_all(found, 'fluids('//to_text(i)//')', 0, report)
      end do
      sound = report%count == before
      if (.not. (sound .and. sound_survey)) return
      call check_fluid_order(model%mud%fluids, bottom_md(model%trajectory), found)
      call report_each(found, 'fluids', report)
   end subroutine check_fluids

   subroutine check_strings(parts, sound_fluids, model, report)
      type(model_parts_type), intent(in) :: parts
      logical, intent(in) :: sound_fluids
      type(model_type), intent(inout) :: model
      type(error_list_type), intent(inout) :: report
      character(:), allocatable :: where
      integer :: i, j, n
      n = 0
      if (allocated(parts%strings)) n = size(parts%strings)
      if (n == 0) call add_fault(report, 'strings', 0, 'missing; give one, its components from the bit upwards')
      allocate (model%strings(n))
      do i = 1, n
         where = 'strings('//to_text(i)//')'
         associate (string => model%strings(i))
            string = parts%strings(i)
            if (.not. allocated(string%name)) string%name = 'main'
            call check_text(string%name, 'name', where, report)
            do j = 1, i - 1
               if (model%strings(j)%name == string%name) call add_fault(report, where, 0, 'name '//quoted(string%name)// &
                  ' is taken by strings('//to_text(j)//')')
            end do
            if (.not. allocated(string%components)) allocate (string%components(0))
            if (size(string%components) == 0) call add_fault(report, where, 0, &
               'it has no components; give them from the bit upwards')
            do j = 1, size(string%components)
               call check_one_component(parts%fluids, sound_fluids, string%name, i, j, string%components, report)
            end do
         end associate
      end do
   end subroutine check_strings

   !> Check one component, and set its missing names.
   subroutine check_one_component(fluids, sound_fluids, name, string, place, components, report)
      type(fluid_type), allocatable, intent(in) :: fluids(:)
      logical, intent(in) :: sound_fluids
      character(*), intent(in) :: name                    !< of the string
      integer, intent(in) :: string, place
      type(component_type), intent(inout) :: components(:)
      type(error_list_type), intent(inout) :: report
      type(error_list_type) :: found
      character(:), allocatable :: where
      real(wp) :: heaviest
      logical :: weighs
      associate (part => components(place))
         where = 'strings('//to_text(string)//')%components('//to_text(place)//')'
         if (.not. allocated(part%kind)) part%kind = 'drillpipe'
         if (allocated(part%name)) call check_text(part%name, 'name', where, report)
         if (.not. allocated(part%name)) part%name = part%kind
         call check_text(part%kind, 'kind', where, report)
         call check_component_ranges(part, place, found)
         if (is_zero(part%mass)) call add_part_fault(found, 'component', place, 'mass', &
            'mass = 0; give it per length, as add_component does by od, id and density')
         if (found%count == 0) then
            call check_component(part, place, base_units(), found)
            weighs = .false.
            if (allocated(fluids) .and. sound_fluids) weighs = size(fluids) > 0
            if (weighs) then
               heaviest = maxval(fluids%density)
               call check_in_string(part, place, name, place == size(components), base_units(), found, heaviest)
            else
               call check_in_string(part, place, name, place == size(components), base_units(), found)
            end if
            call report_all(found, where, string, report)
            if (.not. part%centralizer%present) return
            call check_centralizer_ranges(part%centralizer, place, found)
            if (found%count == 0) call check_centralizer(part%centralizer, part, place, base_units(), found)
            where = where//'%centralizer'
         end if
         call report_all(found, where, string, report)
      end associate
   end subroutine check_one_component

   !> Set the depth of tools that open. All else of holes and strings must be right.
   subroutine set_openings(model, report)
      type(model_type), intent(inout) :: model
      type(error_list_type), intent(inout) :: report
      type(error_list_type) :: found
      integer :: i, j
      do i = 1, size(model%strings)
         do j = 1, size(model%strings(i)%components)
            call set_opened_depth(model%strings(i)%components(j), j, model%holes, found)
            call report_all(found, 'strings('//to_text(i)//')%components('//to_text(j)//')', i, report)
         end do
      end do
   end subroutine set_openings

   subroutine check_settings(model, report)
      type(model_type), intent(in) :: model
      type(error_list_type), intent(inout) :: report
      type(error_list_type) :: found
      type(ranges_type) :: ranges
      call check_numerics_ranges(model%numerics, found)
      if (found%count == 0) call check_numerics(model%numerics, found)
      call report_all(found, 'numerics', 0, report)
      call check_rig_ranges(model%rig, found)
      call report_all(found, 'rig', 0, report)
      call set_ranges('boundary', 0, ranges)
      call check_range(ranges, 'packer_bore', model%boundary%packer_bore, found)
      call report_all(found, 'boundary', 0, report)
      call set_ranges('job', 0, ranges)
      call check_range(ranges, 'gravity', model%gravity, found)
      call report_all(found, 'model', 0, report)
   end subroutine check_settings

   !> Report all faults of the part `where`, and empty the list.
   subroutine report_all(found, where, string, report)
      type(error_list_type), intent(inout) :: found
      character(*), intent(in) :: where
      integer, intent(in) :: string           !< string whose components are meant; 0: none
      type(error_list_type), intent(inout) :: report
      integer :: i
      do i = 1, found%count
         call report_one(found%items(i), where, string, report)
      end do
      call clear_errors(found)
   end subroutine report_all

   !> Report faults each of which names its own part.
   subroutine report_each(found, parts, report)
      type(error_list_type), intent(in) :: found
      character(*), intent(in) :: parts       !< component of model_parts_type: 'holes'
      type(error_list_type), intent(inout) :: report
      integer :: i
      do i = 1, found%count
         call report_one(found%items(i), parts//'('//to_text(place_of(found%items(i)))//')', 0, report)
      end do
   end subroutine report_each

   subroutine report_one(fault, where, string, report)
      type(error_type), intent(in) :: fault
      character(*), intent(in) :: where
      integer, intent(in) :: string
      type(error_list_type), intent(inout) :: report
      character(:), allocatable :: words, mention
      select case (other_of(fault))
      case ('hole')
         mention = 'holes('//to_text(other_place_of(fault))//')'
      case ('fluid')
         mention = 'fluids('//to_text(other_place_of(fault))//')'
      case default
         mention = 'strings('//to_text(string)//')%components('//to_text(other_place_of(fault))//')'
      end select
      call whole_message(fault, mention, words)
      call add_fault(report, where, 0, words)
   end subroutine report_one

   !> Report a name that a file could not hold as a cell.
   subroutine check_text(text, called, where, report)
      character(*), intent(in) :: text, called, where
      type(error_list_type), intent(inout) :: report
      character(:), allocatable :: fault
      call find_text_fault(text, .true., fault)
      if (fault /= '') call add_fault(report, where, 0, called//' = '//quoted(text)//' '//fault)
   end subroutine check_text

   subroutine report_error(report, error)
      type(error_list_type), intent(in) :: report
      type(error_type), allocatable, intent(out) :: error
      if (report%count > 0) call raise(error, status_bad_input, first_errors(report, most_told, ''))
   end subroutine report_error
end module dg_checked_model

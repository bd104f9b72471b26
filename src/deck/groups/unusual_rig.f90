!> Notes on hook loads, measured or of the block, that do not fit the weight of their string. Mostly they are in another unit,
!> or two are swapped.
module dg_unusual_rig
   use dg_kinds, only: wp
   use dg_deck_draft, only: string_use_type
   use dg_fluid_pressure, only: push_of, stretch_type, stretches_of, weight_at
   use dg_hole_section, only: hole_section_at
   use dg_likely_unit, only: tonnes_question, unit_questions
   use dg_load_case, only: block_way, load_case_type, moves_axially, operation_trip_in, operation_trip_out, rotates
   use dg_missing, only: optional_real
   use dg_model, only: model_type, string_index
   use dg_text, only: append_text, either, quoted, text_type, to_text
   use dg_trajectory, only: top_md, true_vertical_depth
   use dg_unit_kind, only: in_units, unit_diameter, unit_force, unit_length
   use dg_units, only: unit_system_type
   use dg_unusual_case, only: note_bit_loads
   use dg_usual_range, only: is_unusual, note_range, usual_block, usual_bore, usual_lines, usual_measured, usual_sheave
   implicit none
   private
   public :: note_rig

   !> Block weight over the weight of the heaviest string, and over the largest hook load of the rig [-]. Block and hook of rigs
   !> without a top drive have 3 % of what the rig carries, with it 6 to 10 %. Tonnes read as kN are a tenth.
   real(wp), parameter :: lightest_block = 0.035_wp, lightest_of_rig = 0.02_wp
   !> The heaviest block of light rigs over the same [-], and the largest hook load of any rig [N].
   real(wp), parameter :: heaviest_of_rig = 0.4_wp, largest_rig = 18.0e6_wp
   !> Measured hook load over string and block [-]: of a string that is pulled or rotates, and of any. Tonnes read as kN are 0.10,
   !> klbf read as kN 0.22; kN read as klbf are 4.4.
   real(wp), parameter :: least_measured = 0.5_wp, most_measured = 3.5_wp
   !> Weight along the hole over the whole one, below which a hole is nearly level from end to end [-].
   real(wp), parameter :: nearly_level = 0.1_wp
   !> Range of a hook load in the unit that is asked for, over the same [-].
   real(wp), parameter :: least_likely = 0.6_wp, most_likely = 2.0_wp
   !> Weight of string and block over the largest hook load of the rig, above which a wrong unit is likely [-]. Less is an
   !> impossible plan.
   real(wp), parameter :: most_overload = 2.0_wp
   !> Longest tail of a string below its packer [m].
   real(wp), parameter :: longest_tail = 300.0_wp
   !> Range of a missing load over the block weight that is taken for the block [-]. The block must weigh at least this part of
   !> the string, or the missing load may be an error of the string's weight [-].
   real(wp), parameter :: least_lack = 0.7_wp, most_lack = 1.3_wp, least_told = 0.1_wp
   !> Depths that are the same [m].
   real(wp), parameter :: same_depth = 1.0_wp
   real(wp), parameter :: percent = 0.01_wp
   integer, parameter :: digits = 4, few_digits = 2, depth_digits = 6

contains

   !> Add one note a matter, with the first load case that has it.
   subroutine note_rig(model, uses, units, notes)
      type(model_type), intent(in) :: model
      type(string_use_type), intent(in) :: uses(:)      !< of strings, beside those of load cases
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: weights(size(model%cases)), each
      integer :: i
      call note_packer(model, units, notes)
      ! Without losses in the sheaves the number of lines changes no result.
      if (model%rig%sheave_efficiency < 1.0_wp) then
         call note_range(units, 'group &rig', usual_lines, real(model%rig%lines, wp), notes)
         each = model%rig%sheave_efficiency**(2.0_wp/(model%rig%lines + 1))
         if (is_unusual(usual_sheave, each)) then
            call note_range(units, 'group &rig', usual_sheave, model%rig%sheave_efficiency, notes)
         else if (is_unusual(usual_sheave, model%rig%sheave_efficiency)) then
            call append_text(notes, 'group &rig: sheave_efficiency is that of one sheave, '// &
               to_text(model%rig%sheave_efficiency, digits)//' here. If it is of the whole block, write '// &
               to_text(each, few_digits + 1))
         end if
      end if
      if (top_md(model%trajectory) > 0.0_wp) return
      weights = [(hanging_weight(model, model%cases(i), .true.), i=1, size(model%cases))]
      call note_block(model, units, weights, notes)
      call note_rig_limit(model, units, weights, notes)
      call note_bit_loads(model, units, notes)
      call note_hook_loads(model, uses, units, notes)
      call note_block_left_out(model, units, notes)
      call note_swapped(model, units, notes)
   end subroutine note_rig

   !> A seal bore in another unit, or wider than the hole just above the lower end of the string. The first load case is named.
   subroutine note_packer(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, upper, lower
      if (.not. model%boundary%packer_bore > 0.0_wp) return
      if (is_unusual(usual_bore, model%boundary%packer_bore)) then
         call note_range(units, 'group &boundary', usual_bore, model%boundary%packer_bore, notes)
         return
      end if
      do i = 1, size(model%cases)
         ! the receptacle may stand on a liner, with the tail of the string below it
         upper = hole_section_at(model%holes, model%cases(i)%bit_depth - longest_tail)
         lower = hole_section_at(model%holes, model%cases(i)%bit_depth - same_depth)
         associate (widest => maxval(model%holes(upper:lower)%diameter))
            if (model%boundary%packer_bore <= widest) cycle
            call append_text(notes, 'group &boundary: packer_bore = '// &
               in_units(units, unit_diameter, model%boundary%packer_bore, digits)//' is wider than the hole at the packer, '// &
               in_units(units, unit_diameter, widest, digits)//' at '// &
               in_units(units, unit_length, model%cases(i)%bit_depth, depth_digits)//'. Give the diameter of the seal bore')
            return
         end associate
      end do
   end subroutine note_packer

   !> A block that is lighter than that of any rig that carries such a string.
   subroutine note_block(model, units, weights, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: weights(:)      !< of strings, by load case [N]
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: heaviest
      character(:), allocatable :: share
      if (size(weights) == 0) return
      heaviest = maxval(weights)
      associate (block => model%rig%block_weight, most => model%rig%max_hookload)
         if (.not. block > 0.0_wp) return
         if (block < lightest_block*heaviest) then
            share = to_text(block/heaviest/percent, few_digits)//' % of the string, which weighs '// &
                    in_units(units, unit_force, heaviest, digits)//' in mud'
         else if (most%present .and. block < lightest_of_rig*most%value) then
            share = to_text(block/most%value/percent, few_digits)//' % of max_hookload'
         else
            return
         end if
         call append_text(notes, 'group &rig: block_weight = '//in_units(units, unit_force, block, digits)//' is '// &
            share//tonnes_question('block_weight', units, block, model%gravity, digits))
      end associate
   end subroutine note_block

   !> A rig that does not carry the weight of the string without drag.
   subroutine note_rig_limit(model, units, weights, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: weights(:)      !< of strings, by load case [N]
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: question
      real(wp) :: load
      if (size(weights) == 0 .or. .not. model%rig%max_hookload%present) return
      if (is_unusual(usual_block, model%rig%block_weight)) return      ! which has a note of its own
      load = maxval(weights) + model%rig%block_weight
      associate (most => model%rig%max_hookload%value)
         question = ''
         if (model%rig%block_weight > heaviest_of_rig*most .and. load > most) question = unit_questions(units, unit_force, &
            most/units%force, load, largest_rig, digits, 'max_hookload')
         if (question /= '') then
            call append_text(notes, 'group &rig: block_weight = '//in_units(units, unit_force, model%rig%block_weight, digits)// &
               ' is '//to_text(model%rig%block_weight/most/percent, few_digits)//' % of max_hookload'//question)
            return
         end if
         if (load <= most_overload*most) return
         call append_text(notes, 'The rig carries '//in_units(units, unit_force, most, digits)//', string and block weigh '// &
            in_units(units, unit_force, load, digits)//' in mud without drag'// &
            tonnes_question('its limit', units, most, model%gravity, digits))
      end associate
   end subroutine note_rig_limit

   !> The first hook load, measured or of another program, that is far from what string and block weigh.
   subroutine note_hook_loads(model, uses, units, notes)
      type(model_type), intent(in) :: model
      type(string_use_type), intent(in) :: uses(:)
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, k, before
      before = size(notes)
      do i = 1, size(model%cases)
         associate (case => model%cases(i))
            call note_hook_load(model, case, 'load case '//quoted(case%name)//': measured_hookload', case%measured_hookload, &
                                model%rig%given, units, notes)
            if (size(notes) > before) return
            call note_hook_load(model, case, 'load case '//quoted(case%name)//': reference_hookload', case%reference_hookload, &
                                .false., units, notes)
            if (size(notes) > before) return
         end associate
      end do
      do i = 1, size(uses)
         if (.not. allocated(uses(i)%measured)) cycle
         do k = 1, size(uses(i)%measured)
            associate (case => uses(i)%measured(k))
               call note_hook_load(model, case, 'group &'//uses(i)%group//': measured_hookloads at '// &
                                   in_units(units, unit_length, case%bit_depth, depth_digits), &
                                   case%measured_hookload, model%rig%given, units, notes)
               if (case%measured_torque%present) call note_range(units, 'group &'//uses(i)%group, usual_measured, &
                                                                 case%measured_torque%value, notes)
            end associate
            if (size(notes) > before) return
         end do
      end do
   end subroutine note_hook_loads

   !> Measured hook loads that lack the block: all of strings that turn, without drag, are low by about its weight. The first is
   !> named. A single measured load may be wrong for another reason.
   subroutine note_block_left_out(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: expected, lacks
      integer :: i, first
      if (.not. model%rig%block_weight > 0.0_wp .or. count(model%cases%measured_hookload%present) < 2) return
      first = 0
      do i = 1, size(model%cases)
         associate (case => model%cases(i))
            if (.not. case%measured_hookload%present) cycle
            expected = hanging_weight(model, case, .true.) - case%wob - push_of(model, case)
            lacks = (expected + model%rig%block_weight - case%measured_hookload%value)/model%rig%block_weight
            ! a pick-up above string and block has the block in it
            if (case%operation == operation_trip_out .and. lacks < 0.0_wp) return
            if (.not. rotates(case%operation) .or. moves_axially(case%operation)) cycle
            if (model%rig%block_weight < least_told*expected .or. lacks < least_lack .or. lacks > most_lack) return
            if (first == 0) first = i
         end associate
      end do
      if (first == 0) return
      associate (case => model%cases(first))
         call append_text(notes, 'load case '//quoted(case%name)//': measured_hookload = '// &
            in_units(units, unit_force, case%measured_hookload%value, digits)//' is the weight of the string in mud'// &
            either(' less WOB', '', case%wob > 0.0_wp)//'. With block_weight it would be '// &
            in_units(units, unit_force, case%measured_hookload%value + model%rig%block_weight, digits)// &
            '. If loads are measured without the block, write block_weight = 0')
      end associate
   end subroutine note_block_left_out

   !> A hook load that is far from what string and block weigh, or was measured without the block, it seems. Drag may be as
   !> much as the string weighs. Where the lower end lies nearly as high as the rig, drag is all.
   subroutine note_hook_load(model, case, what, load, with_block, units, notes)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: case
      character(*), intent(in) :: what        !< has the load
      type(optional_real), intent(in) :: load !< [N]
      logical, intent(in) :: with_block       !< the load counts the block in
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      character(:), allocatable :: question
      real(wp) :: weight, expected, share
      logical :: bears_all       ! the hook bears the whole weight at least
      if (.not. load%present) return
      weight = hanging_weight(model, case, .true.)
      expected = weight - case%wob - push_of(model, case)
      ! pipe that is snubbed in hangs on the hook with next to no weight
      if (push_of(model, case) > 0.0_wp .and. expected < least_measured*weight) return
      if (with_block) expected = expected + model%rig%block_weight
      if (.not. expected > 0.0_wp) return
      share = load%value/expected
      if (with_block .and. load%value <= model%rig%block_weight .and. case%operation == operation_trip_out .and. &
          load%value > least_measured*weight) then
         call append_text(notes, what//' is no more than block_weight of &rig; with &rig it is what the indicator shows, the '// &
                          'block counted in')
         return
      end if
      bears_all = block_way(case%operation) > 0 .or. (rotates(case%operation) .and. .not. moves_axially(case%operation))
      if (share > most_measured) then
         associate (whole => hanging_weight(model, case, .false.))
            if (weight < nearly_level*whole .or. load%value < expected + whole) return
         end associate
      else if (share >= least_measured .or. .not. bears_all) then
         return
      end if
      question = unit_questions(units, unit_force, load%value/units%force, least_likely*expected, most_likely*expected, digits, &
                                'the hook load')
      call append_text(notes, what//' = '//in_units(units, unit_force, load%value, digits)//' is '// &
         to_text(share/percent, few_digits)//' % of what '//either('string and block weigh', 'the string weighs', with_block)// &
         ' in mud'//either(' less WOB', '', case%wob > 0.0_wp)//', '//in_units(units, unit_force, expected, digits)// &
         either(question, '. Check both numbers', question /= ''))
   end subroutine note_hook_load

   !> A pick-up weight below the slack-off weight of the same string at the same depth.
   subroutine note_swapped(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i, k
      do i = 1, size(model%cases)
         do k = 1, size(model%cases)
            associate (up => model%cases(i), down => model%cases(k))
               if (up%operation /= operation_trip_out .or. down%operation /= operation_trip_in .or. up%string /= down%string) cycle
               if (.not. (up%measured_hookload%present .and. down%measured_hookload%present)) cycle
               if (abs(up%bit_depth - down%bit_depth) > same_depth .or. abs(up%wob) > 0.0_wp .or. abs(down%wob) > 0.0_wp) cycle
               if (up%measured_hookload%value >= down%measured_hookload%value) cycle
               call append_text(notes, 'load case '//quoted(up%name)//': measured_hookload = '// &
                  in_units(units, unit_force, up%measured_hookload%value, digits)//' of pick-up is below the '// &
                  in_units(units, unit_force, down%measured_hookload%value, digits)//' of slack-off in '//quoted(down%name)// &
                  '. Are the two swapped?')
               return
            end associate
         end do
      end do
   end subroutine note_swapped

   !> Weight of a string in mud [N].
   function hanging_weight(model, load_case, along) result(weight)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical, intent(in) :: along            !< its part along the hole, that hangs on the hook
      real(wp) :: weight, height
      type(stretch_type), allocatable :: stretches(:)
      integer :: i
      weight = 0.0_wp
      associate (string => model%strings(string_index(model%strings, load_case%string)))
         allocate (stretches, source=stretches_of(model, string, load_case%bit_depth))
         do i = 1, size(stretches)
            associate (upper => stretches(i)%upper, lower => stretches(i)%lower)
               height = lower - upper
               if (along) height = true_vertical_depth(model%trajectory, lower) - true_vertical_depth(model%trajectory, upper)
               weight = weight + height*weight_at(string%components(stretches(i)%component), model, load_case, &
                                                  0.5_wp*(lower + upper))
            end associate
         end do
      end associate
   end function hanging_weight
end module dg_unusual_rig

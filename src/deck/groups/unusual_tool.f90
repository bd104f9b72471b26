!> Notes on legal but unusual bits, motors and steering tools of a deck, and on the angles of their tools. Each has one note with
!> the number and its place.
module dg_unusual_tool
   use dg_kinds, only: wp
   use dg_component, only: closed_diameter, component_type, has_bend, has_pad, is_bit, is_eccentric, is_pipe, opens
   use dg_constants, only: degree, pi
   use dg_deck_draft, only: diameter_at, draft_component_type, draft_type, lowest_of
   use dg_load_case, only: drills, operation_name, rotates
   use dg_text, only: append_text, quoted, text_type, to_text
   use dg_unit_kind, only: in_units, unit_diameter, unit_length
   use dg_unusual_component, only: holds_any
   use dg_usual_range, only: note_range, usual_blade_offset, usual_pad
   implicit none
   private
   public :: note_tool_shapes, note_radians

   !> Greatest height of a bend above the lower end of its motor [m], and over its length [-]. Motors bend 1 to 3 m above.
   real(wp), parameter :: highest_bend = 4.0_wp, lower_half = 0.5_wp
   !> Longest bent sub, a short collar [m].
   real(wp), parameter :: longest_sub = 5.0_wp
   !> Least diameter of a bit over that of the hole that it drills [-]: washed-out hole is 5 % wider.
   real(wp), parameter :: least_bit = 0.9_wp
   !> Numbers that people write as degrees have no more than one decimal [rad].
   real(wp), parameter :: one_decimal = 0.1_wp*degree, round_off = 1.0e-6_wp*degree
   !> Words in kinds and names of what cuts.
   character(*), parameter :: cutting(*) = [character(6) :: 'bit', 'mill', 'opener', 'reamer', 'core', 'coring', 'shoe']
   integer, parameter :: digits = 4

contains

   !> Adds a note for each matter.
   subroutine note_tool_shapes(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: lowest(size(draft%components)), i
      lowest = lowest_of(draft)
      call note_angles(draft, notes)
      call note_speeds(draft, notes)
      do i = 1, size(lowest)
         associate (item => draft%components(i), part => draft%components(i)%component)
            if (has_bend(part)) then
               call note_bend(draft, item, notes)
               if (any(has_bend(draft%components(:i - 1)%component) .and. lowest(:i - 1) == lowest(i))) &
                  call append_text(notes, place(item)//' is the second component with a bend of its string, and both bends '// &
                                   'count. Leave one out if they are of one motor')
            end if
            if (has_pad(part)) call note_range(draft%units, place(item), usual_pad, part%pad_force, notes)
            if (is_eccentric(part)) call note_range(draft%units, place(item), usual_blade_offset, part%blade_offset, notes)
            if (lowest(i) == i) call note_bit(draft, lowest == i, item, notes)
         end associate
      end do
   end subroutine note_tool_shapes

   !> Tool faces and clock angles of cases and components.
   subroutine note_angles(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp), allocatable :: angles(:)
      allocate (angles(0))
      if (size(draft%cases) > 0) angles = draft%cases%load_case%toolface
      call note_radians([angles, pack(draft%components%component%pad_clock, has_pad(draft%components%component)), &
                         pack(draft%components%component%blade_clock, is_eccentric(draft%components%component))], notes)
   end subroutine note_angles

   !> Note tool faces or clock angles that are all below a full turn in radians, one of them with two decimals or more.
   subroutine note_radians(angles, notes)
      real(wp), intent(in) :: angles(:)    !< [rad]
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      i = findloc(abs(angles - one_decimal*anint(angles/one_decimal)) > round_off, .true., dim=1)
      if (i == 0 .or. any(abs(angles) > 2.0_wp*pi*degree)) return
      call append_text(notes, 'The deck has '//to_text(angles(i)/degree, digits)//' as toolface or clock angle, and none above '// &
                       '6.3 deg. Are these angles in radians? They are read as degrees')
   end subroutine note_radians

   !> The first case with a speed that does not rotate, beside one that does. Decks of programs have all keys in each case.
   subroutine note_speeds(draft, notes)
      type(draft_type), intent(in) :: draft
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      if (.not. any(rotates(draft%cases%load_case%operation))) return
      do i = 1, size(draft%cases)
         associate (load_case => draft%cases(i)%load_case)
            if (rotates(load_case%operation) .or. .not. load_case%angular_speed > 0.0_wp) cycle
            call append_text(notes, trim(draft%cases(i)%what)//' '//quoted(load_case%name)//': rpm is ignored, as operation = '// &
                             quoted(trim(operation_name(load_case%operation)))//' does not rotate')
            return
         end associate
      end do
   end subroutine note_speeds

   !> A bend high above the lower end of its component, or in a part that is not bent.
   subroutine note_bend(draft, item, notes)
      type(draft_type), intent(in) :: draft
      type(draft_component_type), intent(in) :: item
      type(text_type), allocatable, intent(inout) :: notes(:)
      associate (part => item%component, units => draft%units)
         if (part%bend_position > highest_bend .or. &
             (part%length > 0.0_wp .and. part%bend_position > lower_half*part%length)) &
            call append_text(notes, place(item)//': bend_position = '//in_units(units, unit_length, part%bend_position, digits)// &
               ' is unusual. It is counted from the lower end of the component. Usual is at most '// &
               in_units(units, unit_length, highest_bend, digits)//' and half of its length')
         if (is_pipe(part) .or. is_bit(part) .or. (holds_any(part%kind, [character(6) :: 'collar']) .and. &
                                                   .not. (part%length > 0.0_wp .and. part%length < longest_sub))) &
            call append_text(notes, place(item)//': its kind = '//quoted(part%kind)//' has no bend. Give the bend to the motor')
      end associate
   end subroutine note_bend

   !> A steering tool without a bit, and a bit that is small for the hole that it drills.
   subroutine note_bit(draft, mine, item, notes)
      type(draft_type), intent(in) :: draft
      logical, intent(in) :: mine(:)                     !< components of the string
      type(draft_component_type), intent(in) :: item     !< the lowest of them
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: diameter
      integer :: i
      if (any(mine .and. (has_bend(draft%components%component) .or. has_pad(draft%components%component))) .and. &
          .not. any([(mine(i) .and. is_cutting(draft%components(i)%component), i=1, size(mine))])) then
         call append_text(notes, 'String '//quoted(item%string)//" has a bend or pads, and no kind = 'bit'. List the bit first")
         return
      end if
      if (.not. is_bit(item%component)) return
      if (any(mine .and. opens(draft%components%component))) return
      do i = 1, size(draft%cases)
         associate (load_case => draft%cases(i)%load_case, units => draft%units)
            if (load_case%string /= item%string .or. .not. drills(load_case%operation)) cycle
            diameter = diameter_at(draft, load_case%bit_depth)
            if (closed_diameter(item%component) >= least_bit*diameter) cycle
            call append_text(notes, place(item)//' is '//in_units(units, unit_diameter, closed_diameter(item%component), digits)// &
               ' wide, and '//quoted(load_case%name)//' drills a hole of '//in_units(units, unit_diameter, diameter, digits)// &
               '. Give the diameter of the bit as joint_od')
            return
         end associate
      end do
   end subroutine note_bit

   !> True for bits and other tools that cut.
   pure function is_cutting(part) result(is)
      type(component_type), intent(in) :: part
      logical :: is
      is = holds_any(part%kind//' '//part%name, cutting)
   end function is_cutting

   !> Group, line and name of a component.
   function place(item) result(text)
      type(draft_component_type), intent(in) :: item
      character(:), allocatable :: text
      text = 'group &component in line '//to_text(item%line)//': '//quoted(item%component%name)
   end function place
end module dg_unusual_tool

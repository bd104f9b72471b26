!> Comments of a deck that is converted to other units, in the form of --template. They are ranges '[0 to 50000 m]', and keys
!> of a group with a comment mark before them, '! joint_spacing = 9.5'.
module dg_deck_comment
   use dg_kinds, only: wp
   use dg_deck_number, only: read_real
   use dg_deck_schema, only: group_keys_type, group_place, kind_real, rule_place
   use dg_text, only: lower_case, text_type, to_text
   use dg_unit_kind, only: unit_factor, unit_gravity, unit_label, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: convert_comments, shortest

   !> A number is written with the fewest digits that are this near to it [-]. Examples are 0.3 mm in 3000 m, and 1500 m, which
   !> is 1500 m again after two conversions.
   real(wp), parameter :: near = 1.0e-7_wp
   integer, parameter :: most_digits = 9
   !> Digits of the ends of a range.
   integer, parameter :: range_digits = 5

contains

   !> Changes the comments of a deck.
   pure subroutine convert_comments(units, other, groups, lines)
      type(unit_system_type), intent(in) :: units      !< of the deck
      type(unit_system_type), intent(in) :: other      !< that is wanted
      type(group_keys_type), intent(in) :: groups(:)
      type(text_type), intent(inout) :: lines(:)
      character(:), allocatable :: bare
      integer :: i, group, mark
      group = 0
      do i = 1, size(lines)
         mark = index(lines(i)%text, '!')
         bare = adjustl(lines(i)%text)
         if (index(bare, '!') == 1) bare = adjustl(bare(2:))
         if (index(bare, '&') == 1) group = group_place(groups, lower_case(bare(2:scan(bare//' ', ' ') - 1)))
         if (mark == 0) cycle
         if (lines(i)%text(:mark - 1) == '' .and. group > 0) call convert_key(units, other, groups(group), lines(i)%text)
         call convert_ranges(units, other, mark, lines(i)%text)
      end do
   end subroutine convert_comments

   !> The numbers of a key that is a comment: '! key = 1, 2   ! meaning'.
   pure subroutine convert_key(units, other, group, line)
      type(unit_system_type), intent(in) :: units, other
      type(group_keys_type), intent(in) :: group
      character(:), allocatable, intent(inout) :: line
      real(wp) :: scale
      integer :: equals, last, rule, mark, length
      character(:), allocatable :: values
      mark = index(line, '!')
      equals = index(line, '=')
      if (equals <= mark + 1) return
      rule = rule_place(group%keys, lower_case(trim(adjustl(line(mark + 1:equals - 1)))))
      if (rule == 0) return
      if (group%keys(rule)%kind /= kind_real) return
      scale = unit_factor(units, group%keys(rule)%unit)/unit_factor(other, group%keys(rule)%unit)
      if (abs(scale - 1.0_wp) <= epsilon(scale)) return
      last = index(line(equals:), '!') + equals - 2
      if (last < equals) last = len(line)
      length = len_trim(line(equals + 1:last))
      values = scaled(line(equals + 1:equals + length), scale, .false.)
      ! remarks behind it stay in their column where that has room
      values = values//line(equals + length + 1 + max(0, min(len(values) - length, last - equals - length - 1)):last)
      line = line(:equals)//values//line(last + 1:)
   end subroutine convert_key

   !> The ranges with a unit behind `mark`: '[0 to 50000 m]', '[kN]'.
   pure subroutine convert_ranges(units, other, mark, line)
      type(unit_system_type), intent(in) :: units, other
      integer, intent(in) :: mark
      character(:), allocatable, intent(inout) :: line
      character(:), allocatable :: label, new
      integer :: first, last, unit, cut
      first = mark
      do
         cut = index(line(first:), '[')
         if (cut == 0) return
         first = first + cut
         last = index(line(first:), ']') + first - 2
         if (last < first) return
         cut = index(line(first:last), ' ', back=.true.) + first - 1
         label = line(cut + 1:last)
         do unit = unit_length, unit_gravity
            if (unit_label(units, unit) == label .and. unit_label(other, unit) /= label) exit
         end do
         if (unit > unit_gravity .or. label == '') cycle
         new = scaled(line(first:cut), unit_factor(units, unit)/unit_factor(other, unit), .true.)//unit_label(other, unit)
         line = line(:first - 1)//new//line(last + 1:)
      end do
   end subroutine convert_ranges

   !> A text with its numbers multiplied. Words that are no numbers stay, and blanks and commas.
   pure function scaled(text, scale, is_range) result(new)
      character(*), intent(in) :: text
      real(wp), intent(in) :: scale
      logical, intent(in) :: is_range        !< with the digits of ranges
      character(:), allocatable :: new
      real(wp) :: number
      logical :: legal
      integer :: at, length
      new = ''
      at = 1
      do while (at <= len(text))
         length = scan(text(at:), ' ,') - 1
         if (length < 0) length = len(text) - at + 1
         if (length == 0) then
            new = new//text(at:at)
            at = at + 1
            cycle
         end if
         call read_real(text(at:at + length - 1), number, legal)
         if (.not. legal) then
            new = new//text(at:at + length - 1)
         else if (is_range) then
            new = new//to_text(number*scale, range_digits)
         else
            new = new//shortest(number*scale)
         end if
         at = at + length
      end do
   end function scaled

   !> Number as a person would write it.
   pure function shortest(number) result(text)
      real(wp), intent(in) :: number
      character(:), allocatable :: text
      real(wp) :: back
      integer :: digits
      do digits = 1, most_digits
         text = to_text(number, digits)
         read (text, *) back
         if (abs(back - number) <= near*abs(number)) return
      end do
   end function shortest
end module dg_deck_comment

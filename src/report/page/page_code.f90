!> Numbers of the page's curves in few letters: digits of base 90. Each digit is one printable letter that stands for itself in
!> JSON and cannot end an element of HTML. page.js reads them.
!>
!> Values: a value is (first + level) step, with a whole number `level`. Zero is therefore exact. All levels of a curve have the
!> same number of digits. With four digits there is no common step. The first three digits, less 364500, are the number, and the
!> last digit, less 45, is its power of ten. The greatest level marks a missing value.
!>
!> Depths: the step from the depth before, in thousandths, in digits of base 45. A step to a greater depth is written as twice its
!> size, one to a lesser depth as twice its size less one. All digits but the last of a step have 45 added.
module dg_page_code
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_text, only: append_piece, text_type, to_text
   implicit none
   private
   public :: scale_type, coded_curve, coded_depths, letters_of, per_unit, rounded, scale_within

   type :: scale_type
      real(wp) :: first = 0.0_wp       !< whole number
      real(wp) :: step = 1.0_wp
      integer :: digits = 1            !< of a level
   end type scale_type

   integer, parameter :: base = 90, half = 45, floating = 4, middle = base**3/2
   !> Signs of digits begin with '#' and leave out '<' and the backslash.
   integer, parameter :: first_sign = 35, left_out(2) = [60, 92]
   integer, parameter :: longest_step = 6      !< digits, of the largest integer
   !> A scale has base**digits less this many steps: one for the mark of a missing value, one as steps are one less than levels, two
   !> for rounding.
   integer, parameter :: spare = 4
   real(wp), parameter :: per_unit = 1000.0_wp
   !> First level, at most: it is written with seven digits.
   real(wp), parameter :: most_first = 9.0e6_wp
   integer, parameter :: digits = 7

contains

   !> The shortest scale that rounds values by `band` at most, or as little as it can.
   pure function scale_within(values, band) result(scale)
      real(wp), intent(in) :: values(:)      !< one at least is there
      real(wp), intent(in) :: band
      type(scale_type) :: scale
      real(wp) :: low, high
      integer :: k
      low = minval(values, mask=.not. is_missing(values))
      high = maxval(values, mask=.not. is_missing(values))
      if (.not. high > low) then
         if (abs(low) > 0.0_wp) scale = scale_type(1.0_wp, low, 1)
         return
      end if
      do k = 1, floating - 1
         scale%digits = k
         scale%step = (high - low)/(base**k - spare)
         scale%first = anint(low/scale%step - 0.5_wp)
         if (0.5_wp*scale%step <= band .and. abs(scale%first) < most_first) return
      end do
      scale = scale_type(digits=floating)
   end function scale_within

   !> A value as a reader finds it.
   elemental function rounded(scale, value) result(found)
      type(scale_type), intent(in) :: scale
      real(wp), intent(in) :: value
      real(wp) :: found
      integer :: level
      level = level_of(scale, value)
      if (scale%digits == floating) then
         found = (level/base - middle)*10.0_wp**(modulo(level, base) - half)
      else
         found = (scale%first + level)*scale%step
      end if
   end function rounded

   !> Level of a value.
   elemental function level_of(scale, value) result(level)
      type(scale_type), intent(in) :: scale
      real(wp), intent(in) :: value
      integer :: level
      integer :: power
      if (is_missing(value)) then
         level = base**scale%digits - 1
      else if (scale%digits == floating) then
         power = -half
         if (abs(value) > 0.0_wp) power = min(max(power, ceiling(log10(abs(value)/(middle - 1)))), half - 1)
         level = (nint(value/10.0_wp**power) + middle)*base + power + half
      else
         level = nint(value/scale%step - scale%first)
      end if
   end function level_of

   !> A curve in JSON: its scale, its depths, the levels of its values.
   pure function coded_curve(scale, depths, values) result(json)
      type(scale_type), intent(in) :: scale
      character(*), intent(in) :: depths      !< in JSON
      real(wp), intent(in) :: values(:)
      character(:), allocatable :: json
      character(scale%digits*size(values)) :: levels
      integer :: i, filled
      filled = 0
      do i = 1, size(values)
         call append_piece(levels, filled, number_text(level_of(scale, values(i)), base, scale%digits, 0))
      end do
      json = '['//to_text(scale%first, digits)//','//to_text(scale%step, digits)//','//depths//',"'//levels//'"]'
   end function coded_curve

   !> Depths in JSON.
   pure function coded_depths(depths) result(json)
      real(wp), intent(in) :: depths(:)
      character(:), allocatable :: json
      character(longest_step*size(depths)) :: room
      integer :: i, filled, place, last, number, length, rest
      filled = 0
      last = 0
      do i = 1, size(depths)
         place = nint(per_unit*depths(i))
         number = 2*abs(place - last)
         if (place < last) number = number - 1
         length = 1
         rest = number/half
         do while (rest > 0)
            length = length + 1
            rest = rest/half
         end do
         call append_piece(room, filled, number_text(number, half, length, half))
         last = place
      end do
      json = '"'//room(:filled)//'"'
   end function coded_depths

   !> Digits of a number. `added` to all but the last of them.
   pure function number_text(number, base, length, added) result(text)
      integer, intent(in) :: number, base, length, added
      character(length) :: text
      integer :: i, rest, code
      rest = number
      do i = length, 1, -1
         code = first_sign + modulo(rest, base)
         if (i < length) code = code + added
         if (code >= left_out(1)) code = code + 1
         if (code >= left_out(2)) code = code + 1
         text(i:i) = achar(code)
         rest = rest/base
      end do
   end function number_text

   !> Letters of some texts.
   pure function letters_of(texts) result(number)
      type(text_type), intent(in) :: texts(:)
      integer :: number
      integer :: i
      number = sum([(len(texts(i)%text), i=1, size(texts))])
   end function letters_of
end module dg_page_code

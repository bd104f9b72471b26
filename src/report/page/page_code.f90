!> Numbers of the page's curves in few letters: digits of base 90. Each digit is one printable letter that stands for itself in
!> JSON and cannot end an element of HTML. page.js reads them.
!>
!> Values: a value is (first + level) step, with a whole number `level`. Zero is therefore exact, and so is the largest value
!> without its sign. Levels stand in groups: a group is one number, in as few digits as hold it. Values that are too far apart
!> have no common step. Three digits, less 364500, are then the number, and the fourth, less 45, is its power of ten. The greatest
!> level marks a missing value.
!>
!> Depths: how much greater the step from the depth before is than the last step, in thousandths, in digits of base 45. It is
!> written as twice its size, one below zero as twice its size less one. All digits but the last have 45 added.
!>
!> Depths among those of a profile: where they are many, a bit for each, six in a digit.
module dg_page_code
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_text, only: append_piece, text_type, to_text
   implicit none
   private
   public :: scale_type, coded_bits, coded_curve, coded_depths, letters_of, per_unit, per_value, scale_within

   type :: scale_type
      real(wp) :: first = 0.0_wp       !< whole number
      real(wp) :: step = 1.0_wp
      integer :: levels = 90           !< with that of a missing value
   end type scale_type

   integer, parameter :: base = 90, half = 45, bits = 6, middle = base**3/2, floating = base**4
   !> Signs of digits begin with '#' and leave out '<' and the backslash.
   integer, parameter :: first_sign = 35, left_out(2) = [60, 92]
   integer, parameter :: longest_step = 6      !< digits, of the largest integer
   !> Levels besides those between the least and the greatest value: one for the mark of a missing value, one as steps are one less
   !> than levels, two for rounding.
   integer, parameter :: spare = 4
   integer, parameter :: most_levels = base**3
   !> Digits of a group at most: a whole number that JavaScript can hold.
   integer, parameter :: longest_group = 8
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
      real(wp) :: low, high, steps, most
      low = minval(values, mask=.not. is_missing(values))
      high = maxval(values, mask=.not. is_missing(values))
      most = max(abs(low), abs(high))
      if (.not. high > low) then
         if (most > 0.0_wp) scale = scale_type(1.0_wp, low, base)
         return
      end if
      scale = scale_type(levels=floating)
      if (2.0_wp*band*most_levels < high - low) return
      ! so many steps that the largest value is one of them, and no fewer than a digit has
      steps = most*max(0.5_wp/band, (base - 2*spare)/(high - low))
      if (steps > most_first - 1.0_wp) return
      steps = ceiling(steps)
      scale%step = most/steps
      scale%first = anint(low/scale%step - 0.5_wp)
      scale%levels = max(base, ceiling((high - low)/scale%step) + spare)
   end function scale_within

   !> Digits of a group of levels, and levels in a group: the fewest digits a level.
   pure subroutine find_group(levels, length, number)
      integer, intent(in) :: levels
      integer, intent(out) :: length, number
      integer(int64) :: power
      integer :: i, n
      length = 1
      number = 0
      do i = 1, longest_group
         n = 0
         power = levels
         do while (power <= int(base, int64)**i)
            n = n + 1
            if (power > int(base, int64)**i/levels) exit      ! the next one may have no integer
            power = power*levels
         end do
         if (n*length <= number*i) cycle
         length = i
         number = n
      end do
   end subroutine find_group

   !> Letters of a value.
   pure function per_value(scale) result(letters)
      type(scale_type), intent(in) :: scale
      real(wp) :: letters
      integer :: length, number
      call find_group(scale%levels, length, number)
      letters = real(length, wp)/real(number, wp)
   end function per_value

   !> Level of a value.
   elemental function level_of(scale, value) result(level)
      type(scale_type), intent(in) :: scale
      real(wp), intent(in) :: value
      integer :: level
      integer :: power
      if (is_missing(value)) then
         level = scale%levels - 1
      else if (scale%levels == floating) then
         power = -half
         if (abs(value) > 0.0_wp) power = min(max(power, ceiling(log10(abs(value)/(middle - 1)))), half - 1)
         level = (nint(value/10.0_wp**power) + middle)*base + power + half
      else
         level = nint(value/scale%step - scale%first)
      end if
   end function level_of

   !> A curve in JSON: its scale, its depths, the levels of its values, their number where a level has not whole digits.
   pure function coded_curve(scale, depths, values) result(json)
      type(scale_type), intent(in) :: scale
      character(*), intent(in) :: depths      !< in JSON
      real(wp), intent(in) :: values(:)
      character(:), allocatable :: json
      character(:), allocatable :: levels
      integer(int64) :: group
      integer :: i, k, filled, length, number
      call find_group(scale%levels, length, number)
      allocate (character(length*((size(values) - 1)/number + 1)) :: levels)
      filled = 0
      do i = 1, size(values), number
         group = 0
         do k = i, i + number - 1
            group = group*scale%levels
            if (k <= size(values)) group = group + level_of(scale, values(k))
         end do
         call append_piece(levels, filled, number_text(group, base, length, 0))
      end do
      json = '['//to_text(scale%first, digits)//','//to_text(scale%step, digits)//','//depths//',"'//levels//'"'
      if (scale%levels /= base**length) json = json//','//to_text(scale%levels)
      json = json//']'
   end function coded_curve

   !> Which of some depths a curve has, in JSON.
   pure function coded_bits(has) result(json)
      logical, intent(in) :: has(:)
      character(:), allocatable :: json
      character((size(has) - 1)/bits + 1) :: text
      integer :: i, k, number
      do i = 1, len(text)
         number = 0
         do k = bits*(i - 1) + 1, bits*i
            number = 2*number
            if (k <= size(has)) number = number + count(has(k:k))
         end do
         text(i:i) = number_text(int(number, int64), base, 1, 0)
      end do
      json = '"'//text//'"'
   end function coded_bits

   !> Depths in JSON.
   pure function coded_depths(depths) result(json)
      real(wp), intent(in) :: depths(:)
      character(:), allocatable :: json
      character(longest_step*size(depths)) :: room
      integer :: i, filled, place, last, step, number, length, rest
      filled = 0
      last = 0
      step = 0
      do i = 1, size(depths)
         place = nint(per_unit*depths(i))
         number = 2*abs(place - last - step)
         if (place - last < step) number = number - 1
         step = place - last
         length = 1
         rest = number/half
         do while (rest > 0)
            length = length + 1
            rest = rest/half
         end do
         call append_piece(room, filled, number_text(int(number, int64), half, length, half))
         last = place
      end do
      json = '"'//room(:filled)//'"'
   end function coded_depths

   !> Digits of a number. `added` to all but the last of them.
   pure function number_text(number, base, length, added) result(text)
      integer(int64), intent(in) :: number
      integer, intent(in) :: base, length, added
      character(length) :: text
      integer(int64) :: rest
      integer :: i, code
      rest = number
      do i = length, 1, -1
         code = first_sign + int(modulo(rest, int(base, int64)))
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

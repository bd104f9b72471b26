!> Curves of the page that are written by others. A stress is its moment times a number in each component. A margin is the sum of
!> two curves. A curve of the hole is that of another model.
module dg_page_relations
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_missing, only: is_missing, missing
   use dg_page_code, only: per_unit
   use dg_page_thinning, only: inner_range, line_at, read_at, thinned_type
   use dg_profile, only: profile_type, side_below
   use dg_rounding, only: rounded_nearest
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: by_other, is_inverse, part_for_others, rows_for_others, starts_of, write_by_first, write_by_others, written_type

   !> Curves of a profile as they are written.
   type :: written_type
      real(wp), allocatable :: md(:)              !< of the rows, in units of the page
      type(thinned_type), allocatable :: curves(:)
      integer :: place = 0                        !< of the profile on the page, from 0
   end type written_type

   character(*), parameter :: inverse = 'safety_factor'
   integer, parameter :: digits = 7, depth_digits = 10
   !> Begin of a curve that goes with another one.
   character(*), parameter :: by_other = '["'
   !> Curves that go with another one in each component, and the one.
   character(*), parameter :: linear(2, 8) = reshape([character(22) :: 'bending_stress', 'bending', 'bending_range', 'bending', &
      'jointed_bending_stress', 'bending', inverse, 'von_mises', 'envelope_margin', 'von_mises', 'standoff', 'displacement', &
      'torsional_stress', 'torque', 'axial_stress', 'true_axial'], [2, 8])
   !> Curves that are the sum of two.
   character(*), parameter :: sums(3, 1) = reshape([character(22) :: 'buckling_margin', 'axial', 'sinusoidal_load'], [3, 1])
   !> Rows of a component at least, in the mean, for which the numbers of a curve that goes with another are shorter.
   integer, parameter :: least_rows = 15
   !> Difference of two numbers that are alike, over the greater one [-].
   real(wp), parameter :: alike = 1.0e-6_wp
   !> Part of its tolerance that a curve keeps, at least, for others that are written by it [-].
   real(wp), parameter :: least_part = 0.3_wp
   !> Bands of a curve by itself within which a curve by another one may be, where it says so.
   real(wp), parameter :: most_loose = 3.0_wp

contains

   !> True for a column whose inverse is the curve: a safety factor is largest where nothing is asked of the string.
   elemental function is_inverse(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      is = name == inverse
   end function is_inverse

   !> Write a curve by earlier ones of its profile, if it goes with them. `loose`: it may be less exact than it would be by itself.
   pure subroutine write_by_others(curves, number, md, starts, loose, text, within)
      type(thinned_type), intent(inout) :: curves(:)
      integer, intent(in) :: number               !< of the curve
      real(wp), intent(in) :: md(:)
      integer, intent(in) :: starts(:)            !< first rows of components
      logical, intent(in) :: loose
      character(:), allocatable, intent(inout) :: text
      real(wp), intent(inout) :: within           !< of its range [-]
      real(wp), allocatable :: made(:)
      real(wp) :: apart
      type(text_type) :: found
      integer :: i, k, other
      found%text = ''
      associate (curve => curves(number))
         do i = 1, size(linear, 2)
            k = place_of(linear(2, i))
            if (curve%name /= linear(1, i) .or. k == 0) cycle
            if (curves(k)%own) call make_by_parts(curves(k), curve, md, starts, made, found%text)
         end do
         do i = 1, size(sums, 2)
            k = place_of(sums(2, i))
            other = place_of(sums(3, i))
            if (curve%name /= sums(1, i) .or. min(k, other) == 0) cycle
            call make_by_two(curves(k), curves(other), curve, md, made, found%text)
         end do
         if (found%text == '') return
         if (any(is_missing(made) .neqv. is_missing(curve%values))) return
         apart = maxval(abs(made - curve%values), mask=.not. is_missing(made))
         if (apart > curve%band .and. .not. (loose .and. apart <= most_loose*curve%band)) return
         call widen(curve, apart, within)
         curve%read = made
      end associate
      text = found%text
   contains
      !> Number of an earlier curve that is written; 0: none.
      pure integer function place_of(name)
         character(*), intent(in) :: name
         integer :: j
         place_of = 0
         do j = 1, number - 1
            if (.not. allocated(curves(j)%read)) cycle
            if (curves(j)%name == name) place_of = j
         end do
      end function place_of
   end subroutine write_by_others

   !> Give a curve the band in which it is written by others, if that is wider.
   pure subroutine widen(curve, band, within)
      type(thinned_type), intent(inout) :: curve
      real(wp), intent(in) :: band
      real(wp), intent(inout) :: within           !< of its range [-]
      if (band <= curve%band) return
      if (curve%band > 0.0_wp) within = within*band/curve%band
      curve%band = band
   end subroutine widen

   !> A curve that is the sum of two, in JSON: their names, then its peaks. `made`: the values as the page reads them.
   pure subroutine make_by_two(one, other, curve, md, made, text)
      type(thinned_type), intent(in) :: one, other, curve
      real(wp), intent(in) :: md(:)
      real(wp), allocatable, intent(out) :: made(:)
      character(:), allocatable, intent(out) :: text
      made = sum_of(one%read, other%read)
      call keep_peaks(curve, md, (one%kept .or. other%kept) .or. .not. (one%own .and. other%own), made)
      text = by_other//one%name//'","'//other%name//'"'//peaks_text(curve, md)//']'
   end subroutine make_by_two

   elemental function sum_of(a, b) result(sum)
      real(wp), intent(in) :: a, b
      real(wp) :: sum
      sum = missing
      if (.not. (is_missing(a) .or. is_missing(b))) sum = a + b
   end function sum_of

   !> Rows of a curve that must be kept for others that are written by it. These are the first and the last of each component, and
   !> those of the largest and the least value of each other curve.
   pure function rows_for_others(curves, number, starts) result(rows)
      type(thinned_type), intent(in) :: curves(:)
      integer, intent(in) :: number               !< of the curve
      integer, intent(in) :: starts(:)            !< first rows of components
      integer, allocatable :: rows(:)
      integer :: k
      rows = [integer ::]
      do k = number + 1, size(curves)
         if (.not. is_by(curves(k), curves(number), starts)) cycle
         if (size(rows) == 0) rows = [starts, starts(2:) - 1]
         rows = [rows, ends_of(curves(k))]
      end do
   end function rows_for_others

   !> True if a curve may be written by another one, component by component.
   pure function is_by(curve, source, starts) result(is)
      type(thinned_type), intent(in) :: curve, source
      integer, intent(in) :: starts(:)
      logical :: is
      is = .false.
      if (.not. (allocated(curve%values) .and. allocated(source%values))) return
      if (any(linear(1, :) == curve%name .and. linear(2, :) == source%name)) is = goes_with(source, curve, starts)
   end function is_by

   !> Rows of the largest and of the least value.
   pure function ends_of(curve) result(ends)
      type(thinned_type), intent(in) :: curve
      integer :: ends(2)
      ends(1) = maxloc(curve%values, dim=1)
      ends(2) = minloc(curve%values, dim=1, mask=.not. is_missing(curve%values))
   end function ends_of

   !> Part of the tolerance of a curve with which those that are written by it keep theirs [-].
   pure function part_for_others(curves, number, starts) result(part)
      type(thinned_type), intent(in) :: curves(:)
      integer, intent(in) :: number               !< of the curve
      integer, intent(in) :: starts(:)            !< first rows of components
      real(wp) :: part
      real(wp), allocatable :: parts(:, :)
      integer :: k
      part = 1.0_wp
      do k = number + 1, size(curves)
         if (.not. is_by(curves(k), curves(number), starts)) cycle
         parts = parts_by(curves(number), curves(k), starts)
         if (maxval(abs(parts(1, :))) > 0.0_wp) &
            part = min(part, inner_range(curves(k)%values)/(maxval(abs(parts(1, :)))*inner_range(curves(number)%values)))
      end do
      part = max(part, least_part)
   end function part_for_others

   !> True if a curve may be written by another one: numbers of components are fewer than those of rows, and all values are there.
   pure function goes_with(source, curve, starts) result(goes)
      type(thinned_type), intent(in) :: source, curve
      integer, intent(in) :: starts(:)
      logical :: goes
      goes = least_rows*size(starts) <= size(curve%values) .and. .not. any(is_missing(source%values)) .and. &
             .not. any(is_missing(curve%values))
   end function goes_with

   !> Factor and addend of a curve by another one, in each component.
   pure function parts_by(source, curve, starts) result(parts)
      type(thinned_type), intent(in) :: source, curve
      integer, intent(in) :: starts(:)
      real(wp) :: parts(2, size(starts))
      integer :: i, least, most
      do i = 1, size(starts)
         associate (from => source%values(starts(i):last_of(starts, i, source)), &
                    to => curve%values(starts(i):last_of(starts, i, source)))
            least = minloc(from, dim=1)
            most = maxloc(from, dim=1)
            parts(:, i) = 0.0_wp
            if (from(most) > from(least)) parts(1, i) = rounded_nearest((to(most) - to(least))/(from(most) - from(least)), digits)
            parts(2, i) = rounded_nearest(to(least) - parts(1, i)*from(least), digits)
         end associate
      end do
   end function parts_by

   !> Last row of a component.
   pure function last_of(starts, number, curve) result(last)
      integer, intent(in) :: starts(:), number
      type(thinned_type), intent(in) :: curve
      integer :: last
      last = size(curve%values)
      if (number < size(starts)) last = starts(number + 1) - 1
   end function last_of

   !> A curve by another one, in JSON: its name, both peaks, then points, factor and addend of each component; '' where these would
   !> be longer. `made`: the values as the page reads them.
   pure subroutine make_by_parts(source, curve, md, starts, made, text)
      type(thinned_type), intent(in) :: source, curve
      real(wp), intent(in) :: md(:)
      integer, intent(in) :: starts(:)
      real(wp), allocatable, intent(out) :: made(:)
      character(:), allocatable, intent(out) :: text
      real(wp) :: parts(2, size(starts))
      integer :: i, last
      text = ''
      if (.not. goes_with(source, curve, starts)) return
      parts = parts_by(source, curve, starts)
      made = source%read
      text = by_other//source%name//'"'//peaks_text(curve, md)
      do i = 1, size(starts)
         last = last_of(starts, i, curve)
         made(starts(i):last) = parts(1, i)*made(starts(i):last) + parts(2, i)
         text = text//','//to_text(count(source%kept(starts(i):last)))//','//to_text(parts(1, i), digits)//','// &
                to_text(parts(2, i), digits)
      end do
      text = text//']'
      call keep_peaks(curve, md, source%kept, made)
   end subroutine make_by_parts

   !> Depth and value of the largest and of the least value, in JSON.
   pure function peaks_text(curve, md) result(text)
      type(thinned_type), intent(in) :: curve
      real(wp), intent(in) :: md(:)
      character(:), allocatable :: text
      integer :: i, ends(2)
      ends = ends_of(curve)
      text = ''
      do i = 1, size(ends)
         text = text//','//to_text(anint(per_unit*md(ends(i)))/per_unit, depth_digits)//','// &
                to_text(curve%values(ends(i)), digits)
      end do
   end function peaks_text

   !> Values as the page reads them: at the points none is beyond the peaks of the curve, and these are exact.
   pure subroutine keep_peaks(curve, md, points, made)
      type(thinned_type), intent(in) :: curve
      real(wp), intent(in) :: md(:)
      logical, intent(in) :: points(:)
      real(wp), intent(inout) :: made(:)
      logical :: kept(size(md))
      integer :: ends(2)
      ends = ends_of(curve)
      where (.not. is_missing(made)) made = max(curve%values(ends(2)), min(curve%values(ends(1)), made))
      made(ends) = curve%values(ends)
      kept = points
      kept(ends) = .true.
      made = line_at(pack(md, kept), pack(made, kept), md)
   end subroutine keep_peaks

   !> Largest value of a curve without its sign.
   pure function peak_of(curve) result(peak)
      type(thinned_type), intent(in) :: curve
      real(wp) :: peak
      peak = maxval(abs(curve%values), mask=.not. is_missing(curve%values))
   end function peak_of

   !> Write a curve as the place of the profile that is written first, if it has the same curve, with the same peak.
   pure subroutine write_by_first(first, curve, md, text, within)
      type(written_type), intent(in) :: first
      type(thinned_type), intent(inout) :: curve
      real(wp), intent(in) :: md(:)
      character(:), allocatable, intent(inout) :: text
      real(wp), intent(inout) :: within           !< of its range [-]
      real(wp) :: read(size(md)), ends(2)
      integer :: i
      if (.not. allocated(first%md)) return
      ends = [first%md(1) - md(1), first%md(size(first%md)) - md(size(md))]
      if (any(abs(ends) > 0.5_wp/per_unit)) return
      do i = 1, size(first%curves)
         if (.not. first%curves(i)%own) cycle
         if (first%curves(i)%name /= curve%name) cycle
         read = read_at(first%curves(i), first%md, md)
         if (any(is_missing(read) .neqv. is_missing(curve%values))) return
         if (any(.not. is_missing(read) .and. abs(read - curve%values) > curve%band)) return
         if (abs(peak_of(first%curves(i)) - peak_of(curve)) > alike*peak_of(curve)) return
         if (first%curves(i)%within > within) call widen(curve, first%curves(i)%band, within)      ! between its rows, too
         text = to_text(first%place)
         curve%read = read
      end do
   end subroutine write_by_first

   !> First rows of components, as far as these differ in what curves go by, and of sections of the hole.
   pure function starts_of(profile, along) result(starts)
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      integer, allocatable :: starts(:)
      logical :: begins(size(along%od))
      integer :: i
      do i = 1, size(begins)
         begins(i) = i == 1
         if (i == 1) cycle
         begins(i) = differ(along%od(i - 1:i)) .or. differ(along%hole_diameter(i - 1:i)) .or. differ(along%per_moment(i - 1:i))
         if (profile%side(i) /= side_below) cycle
         associate (left => along%envelope_margin(i - 1:i), stress => along%von_mises(i - 1:i))
            if (any(is_missing(left)) .or. any(is_missing(stress))) then
               begins(i) = begins(i) .or. (is_missing(left(1)) .neqv. is_missing(left(2)))
            else      ! stress times what is in use at the other row: equal where the yield strength is
               begins(i) = begins(i) .or. differ(stress*(1.0_wp - left([2, 1])))
            end if
         end associate
      end do
      starts = pack([(i, i=1, size(begins))], begins)
   contains
      pure logical function differ(two)
         real(wp), intent(in) :: two(2)
         differ = abs(two(2) - two(1)) > alike*maxval(abs(two))
      end function differ
   end function starts_of
end module dg_page_relations

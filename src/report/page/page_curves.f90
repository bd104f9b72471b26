!> Curves of the page: columns of a profile, thinned as pictures are, in JSON as page_code writes it.
!>
!> Straight lines between the kept points are within a tolerance of a column's range of all others. The range is that of nine in
!> ten values. One force on an edge, or the safety factor of an unloaded bit, is thousands of times the rest.
!>
!> Curves of a profile change at the same contacts. So depths are written once, and a curve has the places of its own among them.
!> A stress may be its moment times a number, plus a number, in each component. These numbers then stand in place of the curve.
module dg_page_curves
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_profile, only: profile_type
   use dg_quantity, only: quantity_force
   use dg_constants, only: pi
   use dg_depth_curve, only: kept_points
   use dg_line_load, only: force_on_length
   use dg_merge_sort, only: sorted_places
   use dg_missing, only: is_missing
   use dg_page_code, only: coded_curve, coded_depths, letters_of, per_unit, rounded, scale_type, scale_within
   use dg_profile_file, only: profile_series
   use dg_rounding, only: rounded_nearest
   use dg_series, only: add, series_list_type
   use dg_text, only: text_type, to_text
   use dg_units, only: unit_system_type
   use dg_unit_kind, only: unit_factor
   implicit none
   private
   public :: curve_series, curve_text, finest, profile_curves, share_type, stands_alone

   !> Tolerance to which curves are thinned, over the range of a column [-].
   real(wp), parameter :: finest = 3.0e-4_wp
   !> Columns of a profile to write, and the room for each.
   type :: share_type
      logical, allocatable :: columns(:)          !< those of `curve_series` that are written; not allocated: all
      integer :: most_letters = huge(1)           !< of a curve, which is thinned further where it has more
   end type share_type

   type :: thinned_type
      character(:), allocatable :: name
      real(wp), allocatable :: values(:)          !< at all rows
      logical, allocatable :: kept(:)             !< rows that are written; not allocated: none
      type(scale_type) :: scale
      real(wp) :: band = 0.0_wp                   !< within which the curve stays
   end type thinned_type

   character(*), parameter :: clock = 'clock', joint_force = 'side_force_on_joint'
   !> Length of string for the additional curve of side force, a joint of pipe, and number of its places.
   real(wp), parameter :: joint = 9.5_wp
   integer, parameter :: joint_places = 1000
   !> Parts of the band around a thinned curve in which its points are rounded: the one with the shorter text is taken [-].
   real(wp), parameter :: rounding(2) = [0.1_wp, 0.5_wp]
   !> Factor of the tolerance of a curve that is too long, and the tolerance that is kept whatever the length [-].
   real(wp), parameter :: coarser = 1.25_wp, most_within = 0.3_wp
   !> A curve with fewer points has its own depths. It may be that of an earlier profile, too.
   integer, parameter :: fewest_shared = 64
   integer, parameter :: digits = 7
   !> Depths of a curve that has all shared depths.
   character(*), parameter :: rows_depths = '0'
   !> Begin of a curve that goes with another one.
   character(*), parameter :: by_other = '["'
   !> Rows of a component at least, in the mean, for which the numbers of a curve that goes with another are shorter.
   integer, parameter :: least_rows = 15
   !> Change of an angle that is kept, at least [rad], and values that are all alike [-].
   real(wp), parameter :: least_turn = pi/180.0_wp, alike = 1.0e-9_wp
   !> Part of the values, at each end of their order, that does not count for the range [-].
   real(wp), parameter :: outer = 0.05_wp
   !> Largest turn of an angle between two points that are kept, where the profile has more [rad].
   real(wp), parameter :: most_turn = 0.5_wp*pi

contains

   !> Profile columns that are curves: all but the depth and the side of a jump, and one more.
   pure function curve_series(profile, along) result(list)
      type(profile_type), intent(in) :: profile      !< with rows
      type(along_string_type), intent(in) :: along
      type(series_list_type) :: list
      type(series_list_type) :: all
      integer :: i
      all = profile_series(profile, along)
      allocate (list%items(all%count + 1))
      do i = 1, all%count
         if (any(all%items(i)%column%name == [character(4) :: 'md', 'side'])) cycle
         list%count = list%count + 1
         list%items(list%count) = all%items(i)
      end do
      call add(list, joint_force, quantity_force, 'contact force on 9.5 m of string, the length of a joint', profile%side_force)
   end function curve_series

   !> A text for each of `curve_series`; '' where a column has no value or is left out. `rows`: depths that curves share; '' where
   !> no curve has them.
   pure subroutine profile_curves(profile, along, units, share, texts, within, rows)
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(unit_system_type), intent(in) :: units
      type(share_type), intent(in) :: share
      type(text_type), intent(out) :: texts(:)   !< as many
      real(wp), intent(out) :: within(:)         !< of a column's range, to which each is thinned [-]
      type(text_type), intent(out) :: rows
      type(series_list_type) :: list
      type(thinned_type), allocatable :: curves(:)
      real(wp) :: md(size(profile%md))
      integer :: k
      list = curve_series(profile, along)
      md = profile%md/units%length
      within = finest
      allocate (curves(list%count))
      do k = 1, list%count
         texts(k)%text = ''
         if (allocated(share%columns)) then
            if (.not. share%columns(k)) cycle
         end if
         associate (series => list%items(k))
            curves(k)%name = trim(series%column%name)
            if (allocated(series%states)) then
               curves(k)%kept = kept_states(series%states)
               curves(k)%values = real(series%states, wp)
            else if (curves(k)%name == joint_force) then
               call write_joints(profile, series%numbers, units, share, texts(k)%text, within(k))
            else if (.not. all(is_missing(series%numbers))) then
               curves(k)%values = in_unit(series%numbers, unit_factor(units, series%column%quantity))
               call thin_curve(curves(k), md, series%numbers, units, share, within(k))
            end if
         end associate
      end do
      call write_curves(curves, md, starts_of(along), texts, rows)
   end subroutine profile_curves

   !> Thin a curve, further than asked for where its text would be too long.
   pure subroutine thin_curve(curve, md, numbers, units, share, within)
      type(thinned_type), intent(inout) :: curve     !< with name and values
      real(wp), intent(in) :: md(:)                  !< as many
      real(wp), intent(in) :: numbers(:)             !< the values [SI]
      type(unit_system_type), intent(in) :: units
      type(share_type), intent(in) :: share
      real(wp), intent(inout) :: within
      real(wp) :: range
      logical :: kept(size(md))
      type(scale_type) :: scale
      integer :: i, letters
      range = inner_range(curve%values)
      do
         curve%band = within*range
         if (curve%name == clock) curve%band = max(least_turn, within*2.0_wp*pi)/units%angle
         curve%kept = spread(.true., 1, size(md))
         curve%scale = scale_within(curve%values, curve%band)
         letters = curve%scale%digits*size(md)
         do i = 1, size(rounding)
            if (curve%name == clock) then
               kept = kept_angles(md, numbers, within)
            else
               kept = kept_values(md, curve%values, (1.0_wp - rounding(i))*curve%band)
            end if
            scale = scale_within(pack(curve%values, kept), rounding(i)*curve%band)
            if ((1 + scale%digits)*count(kept) >= letters) cycle
            letters = (1 + scale%digits)*count(kept)
            curve%kept = kept
            curve%scale = scale
         end do
         if (letters <= share%most_letters .or. within >= most_within) return
         within = coarser*within
      end do
   end subroutine thin_curve

   !> Write thinned curves. Depths that several curves keep are written once, in `rows`, where the texts are shorter so.
   pure subroutine write_curves(curves, md, starts, texts, rows)
      type(thinned_type), intent(in) :: curves(:)
      real(wp), intent(in) :: md(:)
      integer, intent(in) :: starts(:)                !< first rows of components
      type(text_type), intent(inout) :: texts(:)      !< of those that are written already; '' for others
      type(text_type), intent(out) :: rows
      type(text_type) :: own(size(curves)), shared(size(curves))
      logical :: used(size(md))
      integer :: place(size(md)), last, i, k
      used = .false.
      do k = 1, size(curves)
         if (.not. allocated(curves(k)%kept)) cycle
         if (count(curves(k)%kept) >= fewest_shared) used = used .or. curves(k)%kept
      end do
      last = 0
      do i = 1, size(md)
         if (used(i)) last = last + 1
         place(i) = last
      end do
      do k = 1, size(curves)
         own(k)%text = ''
         shared(k)%text = ''
         if (.not. allocated(curves(k)%kept)) cycle
         associate (kept => curves(k)%kept, values => pack(curves(k)%values, curves(k)%kept))
            own(k)%text = coded_curve(curves(k)%scale, coded_depths(pack(md, kept)), values)
            shared(k)%text = own(k)%text
            if (count(kept) < fewest_shared) cycle
            shared(k)%text = coded_curve(curves(k)%scale, shared_depths(pack(place, kept), count(used)), values)
            if (all(kept)) call write_by_others(curves(:k), starts, shared(:k))
         end associate
      end do
      rows%text = coded_depths(pack(md, used))
      if (letters_of(own) <= letters_of(shared) + len(rows%text)) then
         shared = own
         rows%text = ''
      end if
      do k = 1, size(curves)
         if (shared(k)%text /= '') texts(k)%text = shared(k)%text
      end do
   end subroutine write_curves

   !> Places in the shared depths, in JSON.
   pure function shared_depths(places, number) result(json)
      integer, intent(in) :: places(:), number      !< number of shared depths
      character(:), allocatable :: json
      json = '['//coded_depths(real(places - 1, wp)/per_unit)//']'
      if (size(places) == number) json = rows_depths
   end function shared_depths

   !> True if a curve's text means the same in another profile, which may have the same shared depths.
   pure function stands_alone(text, same_depths) result(alone)
      character(*), intent(in) :: text
      logical, intent(in) :: same_depths
      logical :: alone
      alone = index(text, by_other) /= 1
      if (.not. same_depths) alone = alone .and. index(text, ','//rows_depths//',"') == 0 .and. index(text, ',["') == 0
   end function stands_alone

   !> Write the last of some curves by an earlier one that has all rows, if it goes with one.
   pure subroutine write_by_others(curves, starts, texts)
      type(thinned_type), intent(in) :: curves(:)
      integer, intent(in) :: starts(:)            !< first rows of components
      type(text_type), intent(inout) :: texts(:)  !< theirs
      character(:), allocatable :: found
      integer :: i, last
      last = size(curves)
      do i = 1, last - 1
         if (.not. allocated(curves(i)%kept)) cycle
         if (.not. all(curves(i)%kept) .or. index(texts(i)%text, by_other) == 1) cycle
         found = text_by(curves(i), curves(last)%values, curves(last)%band, starts)
         if (found == '') cycle
         texts(last)%text = found
         return
      end do
   end subroutine write_by_others

   !> Values by those of another curve: rows, factor and addend for each component; '' where they are not within `band` of that.
   pure function text_by(source, values, band, starts) result(text)
      type(thinned_type), intent(in) :: source
      real(wp), intent(in) :: values(:), band
      integer, intent(in) :: starts(:)
      character(:), allocatable :: text
      character(:), allocatable :: pieces
      real(wp) :: factor, addend
      integer :: i, last, least, most
      text = ''
      if (least_rows*size(starts) > size(values) .or. any(is_missing(source%values)) .or. any(is_missing(values))) return
      pieces = by_other//source%name//'"'
      do i = 1, size(starts)
         last = size(values)
         if (i < size(starts)) last = starts(i + 1) - 1
         associate (from => source%values(starts(i):last), to => values(starts(i):last))
            least = minloc(from, dim=1)
            most = maxloc(from, dim=1)
            factor = 0.0_wp
            if (from(most) > from(least)) factor = (to(most) - to(least))/(from(most) - from(least))
            factor = rounded_nearest(factor, digits)
            addend = rounded_nearest(to(least) - factor*from(least), digits)
            if (any(abs(factor*rounded(source%scale, from) + addend - to) > band)) return
            pieces = pieces//','//to_text(size(to))//','//to_text(factor, digits)//','//to_text(addend, digits)
         end associate
      end do
      text = pieces//']'
   end function text_by

   !> First rows of components and sections of the hole.
   pure function starts_of(along) result(starts)
      type(along_string_type), intent(in) :: along
      integer, allocatable :: starts(:)
      integer :: i
      associate (od => along%od, hole => along%hole_diameter)
         starts = [1, pack([(i, i=2, size(od))], abs(od(2:) - od(:size(od) - 1)) > 0.0_wp .or. &
                                                 abs(hole(2:) - hole(:size(hole) - 1)) > 0.0_wp)]
      end associate
   end function starts_of

   !> Contact force on a joint, at equal steps of depth.
   pure subroutine write_joints(profile, side_force, units, share, text, within)
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: side_force(:)         !< per length [N/m]
      type(unit_system_type), intent(in) :: units
      type(share_type), intent(in) :: share
      character(:), allocatable, intent(out) :: text
      real(wp), intent(inout) :: within
      real(wp), dimension(0:joint_places) :: places, values
      character(:), allocatable :: ends
      type(thinned_type) :: curve
      integer :: i, n
      n = size(profile%md)
      places = profile%md(1) + (profile%md(n) - profile%md(1))*[(real(i, wp)/joint_places, i=0, joint_places)]
      values = force_on_length(profile%md, side_force, joint, places)/units%force
      places = places/units%length
      curve%name = joint_force
      curve%values = values
      call thin_curve(curve, places, values, units, share, within)
      if (all(curve%kept)) then
         ends = '['//to_text(places(0), digits)//','//to_text(places(joint_places), digits)//','//to_text(joint_places)//']'
      else
         ends = coded_depths(pack(places, curve%kept))
      end if
      text = coded_curve(curve%scale, ends, pack(values, curve%kept))
   end subroutine write_joints

   !> A curve of numbers. With a tolerance of zero all points stand, in any order.
   pure function curve_text(depths, values, tolerance) result(text)
      real(wp), intent(in) :: depths(:), values(:)  !< in the units of the page
      real(wp), intent(in) :: tolerance             !< of the range [-]
      character(:), allocatable :: text
      logical :: kept(size(values))
      real(wp) :: band
      text = 'null'
      if (all(is_missing(values))) return
      band = tolerance*inner_range(values)
      kept = .true.
      if (tolerance > 0.0_wp) kept = kept_values(depths, values, (1.0_wp - rounding(1))*band)
      text = coded_curve(scale_within(pack(values, kept), rounding(1)*band), coded_depths(pack(depths, kept)), pack(values, kept))
   end function curve_text

   elemental function in_unit(value, unit) result(number)
      real(wp), intent(in) :: value, unit
      real(wp) :: number
      number = value
      if (.not. is_missing(value)) number = value/unit
   end function in_unit

   !> Points of a curve that are kept. Straight lines between them are within `band` of all others.
   pure function kept_values(depths, values, band) result(kept)
      real(wp), intent(in) :: depths(:), values(:), band
      logical :: kept(size(values))
      if (.not. any(is_missing(values)) .and. maxval(values) - minval(values) <= alike*maxval(abs(values))) then
         kept = .false.
         kept([1, size(kept)]) = .true.
      else
         kept = kept_points(depths, values, band)
      end if
   end function kept_values

   !> Range of nine in ten values that are there; the whole range where these are alike.
   pure function inner_range(values) result(range)
      real(wp), intent(in) :: values(:)
      real(wp) :: range
      real(wp), allocatable :: there(:)
      integer, allocatable :: places(:)
      integer :: cut
      there = pack(values, .not. is_missing(values))
      places = sorted_places(there)
      there = there(places)
      cut = int(outer*size(there))
      range = there(size(there) - cut) - there(1 + cut)
      if (range <= alike*(there(size(there)) - there(1))) range = there(size(there)) - there(1)
   end function inner_range

   !> Points of an angle that are kept: it is thinned without its jumps from a full turn to zero.
   pure function kept_angles(depths, values, tolerance) result(kept)
      real(wp), intent(in) :: depths(:), values(:), tolerance      !< values [rad]
      logical :: kept(size(values))
      real(wp) :: steady(size(values)), turn
      integer :: i, last
      steady = values
      turn = 0.0_wp
      do i = 2, size(values)
         if (is_missing(values(i)) .or. is_missing(values(i - 1))) cycle
         if (values(i) - values(i - 1) > pi) turn = turn - 2.0_wp*pi
         if (values(i) - values(i - 1) < -pi) turn = turn + 2.0_wp*pi
         steady(i) = values(i) + turn
      end do
      kept = kept_points(depths, steady, max(least_turn, tolerance*2.0_wp*pi))
      last = 1
      do i = 2, size(values)
         if (is_missing(values(i)) .or. is_missing(values(last))) then
            last = i
         else if (kept(i) .or. abs(steady(i) - steady(last)) > most_turn) then
            ! a reader goes the short way round between two points
            if (abs(steady(i) - steady(last)) > most_turn) kept(i - 1) = .true.
            last = merge(i, i - 1, kept(i))
         end if
      end do
   end function kept_angles

   !> States that are kept: both ends of each change.
   pure function kept_states(codes) result(kept)
      integer, intent(in) :: codes(:)
      logical :: kept(size(codes))
      integer :: i
      kept = .false.
      kept([1, size(codes)]) = .true.
      do i = 2, size(codes)
         if (codes(i) /= codes(i - 1)) kept(i - 1:i) = .true.
      end do
   end function kept_states
end module dg_page_curves

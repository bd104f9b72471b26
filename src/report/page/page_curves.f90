!> Curves of the page: columns of a profile, thinned as pictures are, in JSON as page_code writes it.
!>
!> Straight lines between the kept points are within `tolerance` of a column's range of all others. The range is that of nine in
!> ten values. One force on an edge, or the safety factor of an unloaded bit, is thousands of times the rest.
!>
!> A curve that changes at each contact keeps nearly all rows. Such curves share the depths of the profile's rows. A stress may be
!> its moment times a number, plus a number, in each component. These numbers then stand in place of the curve.
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
   use dg_page_code, only: coded_curve, coded_depths, rounded, scale_type, scale_within
   use dg_profile_file, only: profile_series
   use dg_rounding, only: rounded_nearest
   use dg_series, only: put, series_list_type
   use dg_text, only: text_type, to_text
   use dg_units, only: unit_system_type
   use dg_unit_kind, only: unit_factor
   implicit none
   private
   public :: curve_series, curve_text, has_own_depths, profile_curves

   !> A curve that keeps most rows of its profile.
   type :: rough_type
      character(:), allocatable :: name
      type(scale_type) :: scale
      real(wp), allocatable :: values(:)      !< at all rows
   end type rough_type

   character(*), parameter :: clock = 'clock', joint_force = 'side_force_on_joint'
   !> Length of string for the additional curve of side force, a joint of pipe, and number of its places.
   real(wp), parameter :: joint = 9.5_wp
   integer, parameter :: joint_places = 1000
   !> Part of the band around a thinned curve in which its points are rounded [-].
   real(wp), parameter :: rounding = 0.1_wp
   integer, parameter :: digits = 7
   !> Depths of a curve that has all rows of its profile.
   character(*), parameter :: rows_depths = '0'
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
      call put(list, joint_force, quantity_force, 'contact force on 9.5 m of string, the length of a joint', profile%side_force)
   end function curve_series

   !> A text for each of `curve_series`; '' where a column has no value. `rows`: depths of all rows; '' where no curve has them.
   pure subroutine profile_curves(profile, along, units, tolerance, texts, rows)
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: tolerance          !< of a column's range [-]
      type(text_type), intent(out) :: texts(:)   !< as many
      type(text_type), intent(out) :: rows
      type(series_list_type) :: list
      type(rough_type), allocatable :: rough(:)
      logical :: kept(size(profile%md))
      real(wp), dimension(size(profile%md)) :: md, values
      real(wp) :: band
      integer :: k
      list = curve_series(profile, along)
      md = profile%md/units%length
      allocate (rough(0))
      do k = 1, list%count
         texts(k)%text = ''
         associate (series => list%items(k))
            if (allocated(series%states)) then
               kept = kept_states(series%states)
               texts(k)%text = coded_curve(scale_type(), coded_depths(pack(md, kept)), real(pack(series%states, kept), wp))
            else if (series%column%name == joint_force) then
               texts(k)%text = joint_text(profile, series%numbers, units, tolerance)
            else if (.not. all(is_missing(series%numbers))) then
               values = in_unit(series%numbers, unit_factor(units, series%column%quantity))
               band = tolerance*inner_range(values)
               if (series%column%name == clock) then
                  kept = kept_angles(md, series%numbers, tolerance)
                  band = max(least_turn, tolerance*2.0_wp*pi)/units%angle
               else
                  kept = kept_values(md, values, band)
               end if
               if (2*count(kept) <= size(kept)) then
                  texts(k)%text = thinned_text(md, values, kept, band)
               else
                  call add_rough(rough, rough_type(trim(series%column%name), scale_within(values, band), values), band, &
                                 starts_of(along), texts(k)%text)
               end if
            end if
         end associate
      end do
      rows%text = ''
      if (size(rough) > 0) rows%text = coded_depths(md)
   end subroutine profile_curves

   !> True if a curve's text means the same in every profile: no depths of rows, no other curve in it.
   pure function has_own_depths(text) result(has)
      character(*), intent(in) :: text
      logical :: has
      has = index(text, '["') /= 1 .and. index(text, ','//rows_depths//',"') == 0
   end function has_own_depths

   !> Write a curve that keeps most rows: by a curve of `rough` if it goes with one, else by its values. In the latter case it is
   !> added to `rough`.
   pure subroutine add_rough(rough, curve, band, starts, text)
      type(rough_type), allocatable, intent(inout) :: rough(:)
      type(rough_type), intent(in) :: curve
      real(wp), intent(in) :: band                !< within which its values stay
      integer, intent(in) :: starts(:)            !< first rows of components
      character(:), allocatable, intent(out) :: text
      integer :: i
      text = ''
      do i = 1, size(rough)
         text = text_by(rough(i), curve%values, band, starts)
         if (text /= '') return
      end do
      text = coded_curve(curve%scale, rows_depths, curve%values)
      rough = [rough, curve]
   end subroutine add_rough

   !> Values by those of another curve: rows, factor and addend for each component; '' where they are not within `band` of that.
   pure function text_by(source, values, band, starts) result(text)
      type(rough_type), intent(in) :: source
      real(wp), intent(in) :: values(:), band
      integer, intent(in) :: starts(:)
      character(:), allocatable :: text
      character(:), allocatable :: pieces
      real(wp) :: factor, addend
      integer :: i, last, least, most
      text = ''
      if (least_rows*size(starts) > size(values) .or. any(is_missing(source%values)) .or. any(is_missing(values))) return
      pieces = '["'//source%name//'"'
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
   pure function joint_text(profile, side_force, units, tolerance) result(text)
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: side_force(:)         !< per length [N/m]
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: tolerance
      character(:), allocatable :: text
      real(wp), dimension(0:joint_places) :: places, values
      logical :: kept(0:joint_places)
      real(wp) :: band
      integer :: i, n
      n = size(profile%md)
      places = profile%md(1) + (profile%md(n) - profile%md(1))*[(real(i, wp)/joint_places, i=0, joint_places)]
      values = force_on_length(profile%md, side_force, joint, places)/units%force
      places = places/units%length
      band = tolerance*inner_range(values)
      kept = kept_values(places, values, band)
      if (2*count(kept) <= joint_places) then
         text = thinned_text(places, values, kept, band)
      else
         text = coded_curve(scale_within(values, band), '['//to_text(places(0), digits)//','// &
                            to_text(places(joint_places), digits)//','//to_text(joint_places)//']', values)
      end if
   end function joint_text

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
      if (tolerance > 0.0_wp) kept = kept_values(depths, values, band)
      text = thinned_text(depths, values, kept, band)
   end function curve_text

   !> A curve of the points that are kept, with their depths.
   pure function thinned_text(depths, values, kept, band) result(text)
      real(wp), intent(in) :: depths(:), values(:)
      logical, intent(in) :: kept(:)
      real(wp), intent(in) :: band            !< within which all points are
      character(:), allocatable :: text
      text = coded_curve(scale_within(pack(values, kept), rounding*band), coded_depths(pack(depths, kept)), pack(values, kept))
   end function thinned_text

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
         kept = kept_points(depths, values, (1.0_wp - rounding)*band)
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

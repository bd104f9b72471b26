!> Curves of the page: columns of a profile, thinned as page_thinning does, in JSON as page_code writes it.
!>
!> Curves of a profile change at the same contacts. So depths are written once, and a curve has the places of its own among them.
module dg_page_curves
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_profile, only: profile_type
   use dg_quantity, only: quantity_force
   use dg_line_load, only: force_on_length
   use dg_missing, only: is_missing, missing
   use dg_page_code, only: coded_bits, coded_curve, coded_depths, letters_of, per_unit, scale_type, scale_within
   use dg_page_thinning, only: finest, inner_range, kept_states, kept_values, rounding, thin_curve, thinned_type
   use dg_profile_file, only: profile_series
   use dg_series, only: add, series_list_type
   use dg_text, only: text_type, to_text
   use dg_units, only: unit_system_type
   use dg_unit_kind, only: unit_factor
   implicit none
   private
   public :: accuracy_type, curve_series, curve_text, is_inverse, joint_force, profile_curves, share_type, stands_alone

   !> Columns of a profile to write, and the room for each.
   type :: share_type
      logical, allocatable :: columns(:)          !< those of `curve_series` that are written; not allocated: all
      real(wp) :: letters = huge(1.0_wp)          !< of a curve. One that needs more is thinned more
   end type share_type

   !> Distance of a written curve from its rows, at most.
   type :: accuracy_type
      real(wp) :: within = finest                 !< over the range of the column [-]
      real(wp) :: band = 0.0_wp                   !< in units of the page
   end type accuracy_type

   !> Factor by which the tolerance of a curve with too many letters grows, and its largest value [-].
   real(wp), parameter :: coarser = 1.25_wp, most_within = 0.3_wp
   character(*), parameter :: joint_force = 'side_force_on_joint'
   !> Places of the additional curve of side force.
   integer, parameter :: joint_places = 1000
   !> A curve with fewer points has its own depths. It may be that of an earlier profile, too.
   integer, parameter :: fewest_shared = 64
   integer, parameter :: digits = 7
   !> Depths of a curve that has all shared depths.
   character(*), parameter :: rows_depths = '0'
   !> Begin of depths with a bit for each shared one.
   character(*), parameter :: by_bits = '[0,'
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
      call add(list, joint_force, quantity_force, &
               'contact force on a joint of pipe (joint_spacing of the longest component with joints, else 9.5 m)', &
               profile%side_force)
   end function curve_series

   !> A text for each of `curve_series`; '' where a column has no value or is left out. `rows`: depths that curves share; '' where
   !> no curve has them.
   pure subroutine profile_curves(profile, along, units, share, texts, accuracy, rows)
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(unit_system_type), intent(in) :: units
      type(share_type), intent(in) :: share
      type(text_type), intent(out) :: texts(:)   !< as many
      type(accuracy_type), intent(inout) :: accuracy(:)   !< of each, at least
      type(text_type), intent(out) :: rows
      type(series_list_type) :: list
      type(thinned_type), allocatable :: curves(:)
      real(wp) :: md(size(profile%md)), numbers(size(profile%md))
      integer :: k
      list = curve_series(profile, along)
      md = profile%md/units%length
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
               curves(k)%scale = scale_type(levels=maxval(series%states) + 2)
            else if (curves(k)%name == joint_force) then
               call write_joints(profile, along%pipe_joint, units, share%letters, accuracy(k), texts(k)%text)
            else if (.not. all(is_missing(series%numbers))) then
               numbers = series%numbers
               if (is_inverse(curves(k)%name)) call invert(along%envelope_margin, numbers)
               curves(k)%values = in_unit(numbers, unit_factor(units, series%column%quantity))
               call thin_to_fit(curves(k), md, units%angle, share%letters, accuracy(k))
            end if
         end associate
      end do
      call write_curves(curves, md, texts, rows)
   end subroutine profile_curves

   !> Thin a curve, with a larger tolerance if its text is longer than wanted.
   pure subroutine thin_to_fit(curve, md, angle, letters, accuracy)
      type(thinned_type), intent(inout) :: curve
      real(wp), intent(in) :: md(:)
      real(wp), intent(in) :: angle              !< unit of angles [rad]
      real(wp), intent(in) :: letters            !< of its text
      type(accuracy_type), intent(inout) :: accuracy
      do
         call thin_curve(curve, md, angle, accuracy%within)
         if (curve%letters <= letters .or. accuracy%within >= most_within) exit
         accuracy%within = min(coarser*accuracy%within, most_within)
      end do
      accuracy%band = curve%band
   end subroutine thin_to_fit

   !> True for a column whose inverse is the curve: a safety factor is largest where nothing is asked of the string.
   elemental function is_inverse(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      is = name == 'safety_factor'
   end function is_inverse

   !> Parts of the yield strength in use, from what is left; missing where none is given.
   pure subroutine invert(left, numbers)
      real(wp), intent(in) :: left(:)
      real(wp), intent(out) :: numbers(:)
      numbers = missing
      where (.not. is_missing(left)) numbers = 1.0_wp - left
   end subroutine invert

   !> Write thinned curves. Depths that several curves keep are written once, in `rows`, where the texts are shorter so.
   pure subroutine write_curves(curves, md, texts, rows)
      type(thinned_type), intent(in) :: curves(:)
      real(wp), intent(in) :: md(:)
      type(text_type), intent(inout) :: texts(:)      !< of those that are written already; '' for others
      type(text_type), intent(out) :: rows
      type(text_type) :: own(size(curves)), shared(size(curves))
      logical :: used(size(md))
      integer :: k
      used = .false.
      do k = 1, size(curves)
         if (.not. allocated(curves(k)%kept)) cycle
         if (count(curves(k)%kept) >= fewest_shared) used = used .or. curves(k)%kept
      end do
      do k = 1, size(curves)
         own(k)%text = ''
         shared(k)%text = ''
         if (.not. allocated(curves(k)%kept)) cycle
         associate (kept => curves(k)%kept, values => pack(curves(k)%values, curves(k)%kept))
            own(k)%text = coded_curve(curves(k)%scale, coded_depths(pack(md, kept)), values)
            shared(k)%text = own(k)%text
            if (count(kept) < fewest_shared) cycle
            shared(k)%text = coded_curve(curves(k)%scale, shared_depths(pack(kept, used)), values)
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

   !> Which of the shared depths a curve has, in JSON: the shorter of their places and a bit for each.
   pure function shared_depths(has) result(json)
      logical, intent(in) :: has(:)
      character(:), allocatable :: json
      integer :: i
      json = rows_depths
      if (all(has)) return
      json = '['//coded_depths(pack([(real(i, wp), i=0, size(has) - 1)], has)/per_unit)//']'
      if (len(coded_bits(has)) + 2 < len(json)) json = by_bits//coded_bits(has)//']'
   end function shared_depths

   !> True if a curve's text means the same in another profile, which may have the same shared depths.
   pure function stands_alone(text, same_depths) result(alone)
      character(*), intent(in) :: text
      logical, intent(in) :: same_depths
      logical :: alone
      alone = same_depths .or. (index(text, ','//rows_depths//',"') == 0 .and. index(text, ',["') == 0 .and. &
                                index(text, ','//by_bits) == 0)
   end function stands_alone

   !> Contact force on a joint, at equal steps of depth.
   pure subroutine write_joints(profile, joint, units, letters, accuracy, text)
      type(profile_type), intent(in) :: profile
      real(wp), intent(in) :: joint                 !< its length [m]
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: letters               !< of its text
      type(accuracy_type), intent(inout) :: accuracy
      character(:), allocatable, intent(out) :: text
      real(wp), dimension(0:joint_places) :: places, values
      character(:), allocatable :: ends
      type(thinned_type) :: curve
      integer :: i, n
      n = size(profile%md)
      places = profile%md(1) + (profile%md(n) - profile%md(1))*[(real(i, wp)/joint_places, i=0, joint_places)]
      values = force_on_length(profile%md, profile%side_force, joint, places)/units%force
      places = places/units%length
      curve%name = joint_force
      curve%values = values
      call thin_to_fit(curve, places, units%angle, letters, accuracy)
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
end module dg_page_curves

!> A case of another program: survey, hole, string and mud, as far as its files hold them. SI units; unknown data are 0 or ''.
module dg_imported_case
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   use dg_text, only: append_text, lower_case, quoted, text_type, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: imported_case_type, imported_hole_type, imported_part_type, add_hole, add_part, empty_case, lined_up, kind_of_part
   public :: is_meant, one_of

   !> A section of the hole.
   type :: imported_hole_type
      character(:), allocatable :: name, remark
      real(wp) :: top = 0.0_wp, bottom = 0.0_wp    !< measured depth [m]
      real(wp) :: diameter = 0.0_wp                !< inside [m]
      real(wp) :: friction = 0.0_wp                !< [-]
      logical :: cased = .false.
   end type imported_hole_type

   !> A component of the string.
   type :: imported_part_type
      character(:), allocatable :: name, kind, remark
      real(wp) :: length = 0.0_wp                  !< [m]
      real(wp) :: od = 0.0_wp, id = 0.0_wp, joint_od = 0.0_wp, joint_id = 0.0_wp   !< [m]
      real(wp) :: joint_length = 0.0_wp            !< [m]
      real(wp) :: mass = 0.0_wp                    !< in air [kg/m]
      real(wp) :: yield = 0.0_wp                   !< [Pa]
      real(wp) :: makeup_torque = 0.0_wp           !< [N.m]
      real(wp) :: bend = 0.0_wp                    !< [rad]
      real(wp) :: bend_position = 0.0_wp           !< [m]
   end type imported_part_type

   type :: imported_case_type
      character(:), allocatable :: well, source    !< names of the well, and of the files that it was read from
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)   !< stations [m, rad, rad]
      type(imported_hole_type), allocatable :: holes(:)
      type(imported_part_type), allocatable :: parts(:)            !< from the bit upwards
      real(wp) :: density = 0.0_wp                 !< of the mud [kg/m3]
      real(wp) :: bit_depth = 0.0_wp               !< of the string in the files [m]
      type(text_type), allocatable :: survey_notes(:), hole_notes(:), string_notes(:), fluid_notes(:)
   end type imported_case_type

   !> Beginnings or parts of words for a component, with its kind in a deck. The first match counts.
   character(*), parameter :: words(2, 23) = reshape([character(12) :: 'heavy', 'hwdp', 'hwdp', 'hwdp', 'hw', 'hwdp', &
      'stab', 'stabilizer', 'stb', 'stabilizer', 'ream', 'reamer', 'collar', 'collar', 'drill pipe', 'drillpipe', &
      'drillpipe', 'drillpipe', 'casing', 'casing', 'cas', 'casing', 'liner', 'casing', 'tubing', 'tubing', 'tbg', 'tubing', &
      'motor', 'motor', 'mud_mot', 'motor', 'mwd', 'mwd', 'lwd', 'mwd', 'jar', 'jar', 'bit', 'bit', 'dp', 'drillpipe', &
      'dc', 'collar', 'mot', 'motor'], [2, 23])
   !> Words that mean a component only by themselves.
   character(*), parameter :: alone(6) = [character(4) :: 'hw', 'dp', 'dc', 'mot', 'cas', 'bit']

contains

   !> An empty case.
   pure function empty_case() result(case)
      type(imported_case_type) :: case
      case%well = ''
      case%source = ''
      allocate (case%md(0), case%inclination(0), case%azimuth(0), case%holes(0), case%parts(0))
      allocate (case%survey_notes(0), case%hole_notes(0), case%string_notes(0), case%fluid_notes(0))
   end function empty_case

   !> Adds a section of the hole; one without depths or diameter is left out, with a note.
   pure subroutine add_hole(case, hole)
      type(imported_case_type), intent(inout) :: case
      type(imported_hole_type), intent(in) :: hole
      if (hole%bottom <= hole%top .or. hole%diameter <= 0.0_wp) then
         call append_text(case%hole_notes, 'MISSING: depths or diameter of section '//hole%name//', left out')
      else
         case%holes = [case%holes, hole]
      end if
   end subroutine add_hole

   !> Adds a component above those that are there. A joint no wider than the body does not count, but blades of a stabilizer do.
   pure subroutine add_part(case, part)
      type(imported_case_type), intent(inout) :: case
      type(imported_part_type), intent(in) :: part
      case%parts = [case%parts, part]
      associate (added => case%parts(size(case%parts)))
         if (added%joint_od <= added%od .and. added%kind /= 'stabilizer') added%joint_od = 0.0_wp
         if (added%joint_od <= 0.0_wp) added%joint_id = 0.0_wp
         if (added%joint_od <= 0.0_wp) added%joint_length = 0.0_wp
      end associate
   end subroutine add_part

   !> Kind of a component by its name in another program; '' if unknown.
   pure function kind_of_part(text) result(kind)
      character(*), intent(in) :: text
      character(:), allocatable :: kind
      character(:), allocatable :: plain
      integer :: i, k
      plain = lower_case(text)
      do k = 1, len(plain)
         if (scan(plain(k:k), '_-/,.()') > 0) plain(k:k) = ' '
      end do
      kind = ''
      do i = 1, size(words, 2)
         if (any(alone == words(1, i))) then
            if (index(' '//plain//' ', ' '//trim(words(1, i))//' ') == 0) cycle
         else if (index(plain, trim(words(1, i))) == 0) then
            cycle
         end if
         kind = trim(words(2, i))
         return
      end do
   end function kind_of_part

   !> Sections that abut, from those of a file, which may overlap. `notes` name gaps.
   pure subroutine lined_up(given, units, holes, notes)
      type(imported_hole_type), intent(in) :: given(:)
      type(unit_system_type), intent(in) :: units  !< of the notes
      type(imported_hole_type), allocatable, intent(out) :: holes(:)
      type(text_type), allocatable, intent(inout) :: notes(:)
      real(wp) :: depths(2*size(given) + 1), top, bottom
      integer :: i, k, best, last
      real(wp), parameter :: apart = 0.01_wp       ! m
      allocate (holes(0))
      depths = [0.0_wp, given%top, given%bottom]
      depths = depths(sorted_places(depths))
      last = 0
      top = 0.0_wp
      do i = 2, size(depths)
         bottom = depths(i)
         if (bottom - top < apart) cycle
         best = 0
         do k = 1, size(given)
            if (given(k)%top > top + apart .or. given(k)%bottom < bottom - apart) cycle
            if (best > 0) then
               if (.not. counts_before(given(k), given(best))) cycle
            end if
            best = k
         end do
         if (best == 0) then
            call next_section(bottom, best)
            call append_text(notes, 'GUESSED: no section from '//to_text(top/units%length, 6)//' to '// &
                             to_text(bottom/units%length, 6)//' '//trim(units%length_label)//'; the one below reaches up')
         end if
         if (best == 0) exit
         if (best == last) then
            holes(size(holes))%bottom = bottom
         else
            holes = [holes, given(best)]
            holes(size(holes))%top = top
            holes(size(holes))%bottom = bottom
         end if
         last = best
         top = bottom
      end do

   contains

      !> The section that begins where a gap ends.
      pure subroutine next_section(depth, section)
         real(wp), intent(in) :: depth
         integer, intent(out) :: section
         integer :: j
         section = 0
         do j = 1, size(given)
            if (abs(given(j)%top - depth) > apart) cycle
            if (section == 0) section = j
            if (counts_before(given(j), given(section))) section = j
         end do
      end subroutine next_section
   end subroutine lined_up

   !> True if the first of two sections at one depth counts: casing before open hole, the narrower casing, the shallower open
   !> hole.
   pure function counts_before(one, other) result(counts)
      type(imported_hole_type), intent(in) :: one, other
      logical :: counts
      counts = one%cased .and. .not. other%cased
      if (one%cased .neqv. other%cased) return
      counts = one%bottom < other%bottom
      if (one%cased) counts = one%diameter < other%diameter
   end function counts_before

   !> True if a name is the wanted one, letter case aside.
   pure function is_meant(name, wanted) result(is)
      character(*), intent(in) :: name, wanted
      logical :: is
      is = wanted /= '' .and. lower_case(name) == lower_case(wanted)
   end function is_meant

   !> "A, B and C": names for a message, each once.
   pure function one_of(names) result(text)
      type(text_type), intent(in) :: names(:)
      character(:), allocatable :: text
      integer :: i, k
      text = ''
      do i = 1, size(names)
         if (any([(names(k)%text == names(i)%text, k=1, i - 1)])) cycle
         if (text /= '') text = text//', '
         text = text//quoted(names(i)%text)
      end do
   end function one_of
end module dg_imported_case

!> Checks the parts of a deck against each other: holes cover the depths of the cases, strings reach surface
!> and pass the hole, names are unique. Only parts that are legal in themselves take part, so that one slip
!> gives one message.
module dg_deck_check
   use dg_kinds, only: wp
   use dg_component, only: centralizer_diameter, is_bit
   use dg_deck_draft, only: draft_case_type, draft_type, draft_hole_type
   use dg_fault_list, only: fault_list_type, add_fault
   use dg_text, only: quoted, suggestion, to_text, lower_case
   implicit none
   private
   public :: close_holes, check_draft, check_case

   !> Part of a depth that is only round-off of a conversion or of a survey table [-].
   real(wp), parameter :: depth_round_off = 1.0e-6_wp
   integer, parameter :: depth_digits = 9
   integer, parameter :: diameter_digits = 6
   !> Letters of a string's name that a suggestion repeats.
   integer, parameter :: name_shown = 64

contains

   !> Brings the hole sections into the order of depth, gives open ends their default and checks that they abut
   !> from surface on.
   subroutine close_holes(draft, faults)
      type(draft_type), intent(inout) :: draft
      type(fault_list_type), intent(inout) :: faults
      type(draft_hole_type) :: moving
      integer :: i, j, n
      logical :: closed

      n = size(draft%holes)
      closed = .true.
      do i = 1, n
         associate (hole => draft%holes(i))
            if (.not. hole%sound) cycle
            if (.not. hole%has_top .and. i > 1) then
               closed = draft%holes(i - 1)%sound .and. draft%holes(i - 1)%has_bottom
               hole%section%md_top = draft%holes(i - 1)%section%md_bottom
               if (.not. closed) then
                  if (draft%holes(i - 1)%sound) call fault(hole%line, 'key md_top is missing, and the section before has '// &
                                                           'no md_bottom; give one of them')
                  hole%sound = .false.
                  cycle
               end if
            end if
            if (.not. hole%has_bottom) then
               if (i == n) then
                  hole%section%md_bottom = hole%section%md_top
                  if (.not. draft%has_stations) hole%sound = .false.
                  if (draft%has_stations) hole%section%md_bottom = draft%stations%md(size(draft%stations%md))
               else if (draft%holes(i + 1)%has_top .and. draft%holes(i + 1)%sound) then
                  hole%section%md_bottom = draft%holes(i + 1)%section%md_top
               else
                  hole%sound = .false.
                  if (draft%holes(i + 1)%sound) call fault(hole%line, 'key md_bottom is missing, and the next section has '// &
                                                           'no md_top; give one of them')
                  draft%holes(i + 1)%sound = .false.
                  cycle
               end if
               hole%has_bottom = .true.
            end if
            if (hole%sound .and. hole%section%md_bottom <= hole%section%md_top) then
               call fault(hole%line_bottom, 'md_bottom = '//depth_text(draft, hole%section%md_bottom)// &
                          ' is not below md_top = '//depth_text(draft, hole%section%md_top))
               hole%sound = .false.
            end if
         end associate
      end do
      if (n == 0 .or. .not. all(draft%holes%sound)) return
      do i = 2, n
         do j = i, 2, -1
            if (draft%holes(j - 1)%section%md_top <= draft%holes(j)%section%md_top) exit
            moving = draft%holes(j)
            draft%holes(j) = draft%holes(j - 1)
            draft%holes(j - 1) = moving
         end do
      end do
      if (draft%holes(1)%section%md_top > 0.0_wp) call fault(draft%holes(1)%line_top, 'the uppermost section begins at '// &
         depth_text(draft, draft%holes(1)%section%md_top)//'; holes must begin at surface, md_top = 0')
      do i = 2, n
         associate (above => draft%holes(i - 1)%section%md_bottom, below => draft%holes(i)%section%md_top)
            if (abs(below - above) <= depth_round_off*above) then
               below = above
            else
               call fault(draft%holes(i)%line_top, 'md_top = '//depth_text(draft, below)//' leaves '// &
                          gap_word(below > above)//' the section above (line '//to_text(draft%holes(i - 1)%line)// &
                          '), which ends at '//depth_text(draft, above)//'; sections must abut')
               draft%holes(i)%sound = .false.
            end if
         end associate
      end do

   contains

      subroutine fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, draft%path, line, 'group &hole: '//message)
      end subroutine fault

      function gap_word(gap) result(text)
         logical, intent(in) :: gap
         character(:), allocatable :: text
         if (gap) then
            text = 'a gap below'
         else
            text = 'an overlap with'
         end if
      end function gap_word
   end subroutine close_holes

   !> All checks across groups; `draft` is as it comes from close_holes.
   subroutine check_draft(draft, faults)
      type(draft_type), intent(inout) :: draft
      type(fault_list_type), intent(inout) :: faults
      type(draft_case_type) :: item
      integer :: i
      call check_strings(draft, faults)
      do i = 1, size(draft%cases)
         call check_name(draft, i, faults)
         if (.not. draft%cases(i)%sound) cycle
         item = draft%cases(i)
         call check_case(draft, item, faults)
         draft%cases(i) = item
      end do
   end subroutine check_draft

   !> Survey and holes reach the bit of a case, its string exists, reaches surface and passes the hole.
   subroutine check_case(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(inout) :: item
      type(fault_list_type), intent(inout) :: faults
      call check_depth(draft, item, faults)
      call check_string(draft, item, faults)
   end subroutine check_case

   !> Components: lengths, and that they sink in the mud.
   subroutine check_strings(draft, faults)
      type(draft_type), intent(in) :: draft
      type(fault_list_type), intent(inout) :: faults
      real(wp) :: heaviest
      integer :: i, j
      do i = 1, size(draft%components)
         associate (item => draft%components(i))
            if (.not. item%sound) cycle
            if (item%component%length <= 0.0_wp) then
               do j = i + 1, size(draft%components)
                  if (draft%components(j)%string /= item%string) cycle
                  call add_fault(faults, draft%path, item%line_length, 'group &component: length of '// &
                                 quoted(item%component%name)//' is missing or 0; only the last component of string '// &
                                 quoted(item%string)//' may reach to surface')
                  exit
               end do
            end if
            if (size(draft%fluids) == 0) cycle
            heaviest = maxval(draft%fluids%fluid%density)
            if (heaviest >= item%component%density) &
               call add_fault(faults, draft%path, item%line_density, 'group &component: '// &
                              quoted(item%component%name)//' floats: the mud, '//dense(heaviest)// &
                              ', is not lighter than the material, '//dense(item%component%density))
         end associate
      end do
   contains
      function dense(density) result(text)
         real(wp), intent(in) :: density
         character(:), allocatable :: text
         text = to_text(density/draft%units%density, diameter_digits)
      end function dense
   end subroutine check_strings

   !> Names of cases become file names: unique, also where letter case does not count.
   subroutine check_name(draft, i, faults)
      type(draft_type), intent(in) :: draft
      integer, intent(in) :: i
      type(fault_list_type), intent(inout) :: faults
      integer :: j
      if (draft%cases(i)%load_case%name == '') return
      do j = 1, i - 1
         if (lower_case(draft%cases(j)%load_case%name) /= lower_case(draft%cases(i)%load_case%name)) cycle
         call add_fault(faults, draft%path, draft%cases(i)%line_name, 'group &load_case: name '// &
                        quoted(draft%cases(i)%load_case%name)//' is taken by the case in line '// &
                        to_text(draft%cases(j)%line)//'; names must be unique, letter case aside')
         return
      end do
   end subroutine check_name

   !> Survey and holes reach the bit.
   subroutine check_depth(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(inout) :: item
      type(fault_list_type), intent(inout) :: faults
      if (draft%has_stations) call reach('survey', draft%stations%md(size(draft%stations%md)))
      if (all(draft%holes%sound) .and. size(draft%holes) > 0) &
         call reach('lowest hole section', draft%holes(size(draft%holes))%section%md_bottom)
   contains
      subroutine reach(what, bottom)
         character(*), intent(in) :: what
         real(wp), intent(in) :: bottom
         associate (depth => item%load_case%bit_depth)
            if (depth > bottom*(1.0_wp + depth_round_off)) then
               call add_fault(faults, draft%path, item%line_depth, 'group &'//trim(item%group)//': '// &
                              trim(item%depth_key)//' = '// &
                              depth_text(draft, depth)//' lies below the '//what//', which ends at '// &
                              depth_text(draft, bottom)//'; needs a number, > 0 and <= '//depth_text(draft, bottom))
               item%sound = .false.
            else
               depth = min(depth, bottom)
            end if
         end associate
      end subroutine reach
   end subroutine check_depth

   !> The string of a case exists, reaches surface and passes the hole.
   subroutine check_string(draft, item, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(in) :: item
      type(fault_list_type), intent(inout) :: faults
      integer, allocatable :: parts(:)
      character(name_shown) :: names(size(draft%components))
      integer :: k
      real(wp) :: length

      associate (case => item%load_case)
         allocate (parts(0))
         do k = 1, size(draft%components)
            if (draft%components(k)%string == case%string) parts = [parts, k]
         end do
         if (size(draft%components) == 0) return     ! said already
         if (size(parts) == 0) then
            do k = 1, size(names)
               names(k) = draft%components(k)%string
            end do
            call fault(item%line_string, 'no component belongs to string '//quoted(case%string)//'; '// &
                       suggestion(case%string, distinct(names)))
            return
         end if
         if (.not. all(draft%components(parts)%sound)) return
         length = 0.0_wp
         do k = 1, size(parts)
            length = length + draft%components(parts(k))%component%length
         end do
         if (draft%components(parts(size(parts)))%component%length > 0.0_wp .and. &
             length < case%bit_depth*(1.0_wp - depth_round_off)) &
            call fault(item%line_depth, 'string '//quoted(case%string)//' is '//depth_text(draft, length)// &
                       ' long and does not reach surface from '//trim(item%depth_key)//' = '//depth_text(draft, case%bit_depth)// &
                       '; leave out the length of its last component (line '// &
                       to_text(draft%components(parts(size(parts)))%line)//')')
         if (all(draft%holes%sound)) call check_passage(draft, item, parts, faults)
      end associate
   contains
      subroutine fault(line, message)
         integer, intent(in) :: line
         character(*), intent(in) :: message
         call add_fault(faults, draft%path, line, 'group &'//trim(item%group)//': '//message)
      end subroutine fault
   end subroutine check_string

   !> Every component is thinner than each hole section that it has passed on its way down.
   subroutine check_passage(draft, probe, parts, faults)
      type(draft_type), intent(in) :: draft
      type(draft_case_type), intent(in) :: probe
      integer, intent(in) :: parts(:)        !< components of its string, from the bit up
      type(fault_list_type), intent(inout) :: faults
      integer :: k, h, m, line
      real(wp) :: lower_end, diameter
      lower_end = probe%load_case%bit_depth
      do k = 1, size(parts)
         if (lower_end <= 0.0_wp) return
         associate (item => draft%components(parts(k)))
            diameter = centralizer_diameter(item%component)
            line = merge(item%line_centralizer, item%line_diameter, item%line_centralizer > 0)
            do h = 1, size(draft%holes)
               if (draft%holes(h)%section%md_top >= lower_end) exit
               if (diameter < draft%holes(h)%section%diameter) cycle
               if (is_bit(item%component) .and. .not. diameter > draft%holes(h)%section%diameter) cycle
               if (said_before(line)) exit
               call add_fault(faults, draft%path, line, 'group &'// &
                              trim(merge('centralizer', 'component  ', item%line_centralizer > 0))//': '// &
                              quoted(item%component%name)//' with '//wide(diameter)//' does not pass the hole of '// &
                              wide(draft%holes(h)%section%diameter)//' (line '//to_text(draft%holes(h)%line)// &
                              ') in '//trim(probe%what)//' '//quoted(probe%load_case%name)//'; needs a diameter < '// &
                              wide(draft%holes(h)%section%diameter))
               exit
            end do
            lower_end = lower_end - item%component%length
            if (item%component%length <= 0.0_wp) return
         end associate
      end do
   contains
      !> One case is enough to show that a component is too wide.
      function said_before(line) result(said)
         integer, intent(in) :: line
         logical :: said
         said = .false.
         do m = 1, faults%count
            if (faults%items(m)%line /= line) cycle
            if (index(faults%items(m)%message, 'does not pass') > 0) said = .true.
         end do
      end function said_before

      function wide(width) result(text)
         real(wp), intent(in) :: width
         character(:), allocatable :: text
         text = to_text(width/draft%units%diameter, diameter_digits)//' '//trim(draft%units%diameter_label)
      end function wide
   end subroutine check_passage

   !> The names without repetition.
   pure function distinct(names) result(once)
      character(*), intent(in) :: names(:)
      character(len(names)), allocatable :: once(:)
      logical :: first(size(names))
      integer :: i
      first = .true.
      do i = 2, size(names)
         first(i) = .not. any(names(:i - 1) == names(i))
      end do
      once = pack(names, first)
   end function distinct

   !> A depth with the deck's unit.
   pure function depth_text(draft, depth) result(text)
      type(draft_type), intent(in) :: draft
      real(wp), intent(in) :: depth          !< [m]
      character(:), allocatable :: text
      text = to_text(depth/draft%units%length, depth_digits)//' '//trim(draft%units%length_label)
   end function depth_text
end module dg_deck_check

!> The case in an EDM export (Landmark). Each row of a table is an element. Its values are attributes in feet, inches, lbm/gal,
!> lbm/ft, psi and ft.lbf, without a unit beside them.
module dg_edm_case
   use dg_constants, only: degree, foot, gallon, inch, pound, pound_force, psi
   use dg_edm_rows, only: choose_wellbore, get, is_of, pick
   use dg_imported_case, only: add_hole, add_part, imported_case_type, imported_hole_type, imported_part_type, kind_of_part, &
      one_of
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   use dg_text, only: append_text, lower_case, quoted, text_type, to_text
   use dg_xml_tree, only: attribute, xml_tree_type
   implicit none
   private
   public :: read_edm_case

   !> A yield above this is in lbf/ft2 [psi], a density above this in lbm/ft3 [lbm/gal].
   real(wp), parameter :: highest_yield = 1.0e6_wp, highest_density = 25.0_wp
   real(wp), parameter :: vertical = 0.01_wp*degree
   real(wp), parameter :: square_foot = 144.0_wp, cubic_foot = 1728.0_wp/231.0_wp     ! in2, gal

contains

   !> Read survey, hole, string and mud of a wellbore. `failure` lists the wellbores to choose from, or the value that is not a
   !> number.
   subroutine read_edm_case(tree, wanted, case, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: wanted           !< name of a well or wellbore; '': the only one
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      character(:), allocatable :: wellbore, group, assembly
      real(wp) :: datum
      integer :: row
      call choose_wellbore(tree, wanted, wellbore, case%well, failure)
      if (failure /= '') return
      call read_survey(tree, wellbore, case, datum, failure)
      if (failure /= '') return
      call append_text(case%survey_notes, 'GUESSED: units of the export: ft, in, deg, lbm/gal, lbm/ft, psi, ft.lbf')
      call pick(tree, 'cd_case', wellbore, 'case_name', 'hole_sect_group_id', 'case', case%hole_notes, row)
      group = ''
      assembly = ''
      if (row > 0) then
         group = attribute(tree%elements(row), 'hole_sect_group_id')
         assembly = attribute(tree%elements(row), 'assembly_id')
      end if
      if (group == '') then
         call pick(tree, 'cd_hole_sect_group', wellbore, 'hole_name', 'hole_sect_group_id', 'group of sections', &
                   case%hole_notes, row)
         if (row > 0) group = attribute(tree%elements(row), 'hole_sect_group_id')
      end if
      call read_holes(tree, wellbore, group, datum, case, failure)
      if (failure == '') call read_string(tree, wellbore, assembly, datum, case, failure)
      if (failure == '') call read_fluid(tree, wellbore, case, failure)
   end subroutine read_edm_case

   !> Stations of the definitive survey, else of a survey. `datum`: to be added to every depth [m].
   subroutine read_survey(tree, wellbore, case, datum, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: wellbore
      type(imported_case_type), intent(inout) :: case
      real(wp), intent(out) :: datum
      character(:), allocatable, intent(inout) :: failure
      character(:), allocatable :: table, key, header
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)
      integer, allocatable :: rows(:), order(:)
      integer :: row, i
      datum = 0.0_wp
      table = 'cd_definitive_survey'
      key = 'def_survey_header_id'
      if (.not. any([(tree%elements(i)%name == table//'_station' .and. is_of(tree, i, wellbore), i=1, tree%n)])) then
         table = 'cd_survey'
         key = 'survey_header_id'
      end if
      call pick(tree, table//'_header', wellbore, 'name', key, 'survey', case%survey_notes, row)
      header = ''
      if (row > 0) header = attribute(tree%elements(row), key)
      rows = pack([(i, i=1, tree%n)], [(tree%elements(i)%name == table//'_station' .and. is_of(tree, i, wellbore) .and. &
                                        (header == '' .or. attribute(tree%elements(i), key) == header), i=1, tree%n)])
      if (size(rows) == 0) then
         failure = 'has no station of the survey '//quoted(header)
         return
      end if
      allocate (md(size(rows)), inclination(size(rows)), azimuth(size(rows)))
      do i = 1, size(rows)
         if (attribute(tree%elements(rows(i)), 'md') == '' .or. attribute(tree%elements(rows(i)), 'inclination') == '') then
            failure = 'line '//to_text(tree%elements(rows(i))%line)//': the survey station has no md or no inclination'
            return
         end if
         call get(tree, rows(i), 'md', foot, md(i), failure)
         call get(tree, rows(i), 'inclination', degree, inclination(i), failure)
         call get(tree, rows(i), 'azimuth', degree, azimuth(i), failure)
         if (inclination(i) > vertical .and. attribute(tree%elements(rows(i)), 'azimuth') == '' .and. failure == '') &
            failure = 'line '//to_text(tree%elements(rows(i))%line)//': the survey station is inclined and has no azimuth'
      end do
      if (failure /= '') return
      order = sorted_places(md)
      order = pack(order, [.true., (md(order(i)) > md(order(i - 1)), i=2, size(order))])
      case%md = md(order)
      case%inclination = inclination(order)
      case%azimuth = azimuth(order)
      if (size(order) < size(rows)) call append_text(case%survey_notes, to_text(size(rows) - size(order))// &
                                                     ' stations at the depth of another are left out')
      if (case%md(1) < 0.0_wp) then
         call find_datum(tree, -case%md(1), datum, failure)
         case%md = case%md + datum
         call append_text(case%survey_notes, 'GUESSED: depths count from the sea; '//to_text(datum/foot, 6)//' ft added')
         if (case%md(1) < 0.0_wp .and. failure == '') failure = 'has a survey that begins above the datum of its depths'
      end if
   end subroutine read_survey

   !> Height of the rig's datum: the default one, else the nearest to the uppermost station.
   subroutine find_datum(tree, height, datum, failure)
      type(xml_tree_type), intent(in) :: tree
      real(wp), intent(in) :: height               !< of the uppermost station [m]
      real(wp), intent(out) :: datum
      character(:), allocatable, intent(inout) :: failure
      real(wp), parameter :: close = 0.1_wp        ! m
      real(wp) :: elevation
      integer :: i
      datum = height
      do i = 1, tree%n
         if (tree%elements(i)%name /= 'cd_datum') cycle
         call get(tree, i, 'datum_elevation', foot, elevation, failure)
         if (elevation < height - close) cycle
         if (datum > height .and. lower_case(attribute(tree%elements(i), 'is_default')) /= 'y') cycle
         datum = max(elevation, height)
      end do
   end subroutine find_datum

   !> Sections of the hole, of a group where one is known.
   subroutine read_holes(tree, wellbore, group, datum, case, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: wellbore, group
      real(wp), intent(in) :: datum                !< [m]
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(imported_hole_type) :: hole
      real(wp) :: length, shoe
      integer :: i
      do i = 1, tree%n
         if (tree%elements(i)%name /= 'cd_hole_sect' .or. .not. is_of(tree, i, wellbore)) cycle
         if (group /= '' .and. attribute(tree%elements(i), 'hole_sect_group_id') /= group) cycle
         hole%name = attribute(tree%elements(i), 'name')
         if (hole%name == '') hole%name = attribute(tree%elements(i), 'catalog_key_desc')
         if (hole%name == '') hole%name = attribute(tree%elements(i), 'sect_type_code')
         hole%cased = any(index(lower_case(attribute(tree%elements(i), 'sect_type_code')), ['cas', 'lin', 'rsr', 'ris']) == 1)
         hole%remark = ''
         hole%diameter = first_of('effective_diameter', 'hole_size')
         if (hole%cased) hole%diameter = first_of('id_casing', 'effective_diameter')
         call get(tree, i, 'length', foot, length, failure)
         call get(tree, i, 'md_base', foot, hole%bottom, failure)
         call get(tree, i, 'md_shoe', foot, shoe, failure)
         call get(tree, i, 'md_top', foot, hole%top, failure)
         call get(tree, i, 'cof', 1.0_wp, hole%friction, failure)
         if (failure /= '') return
         if (attribute(tree%elements(i), 'md_base') == '') hole%bottom = shoe
         if (attribute(tree%elements(i), 'md_top') == '' .and. length > 0.0_wp .and. hole%bottom > 0.0_wp) &
            hole%top = hole%bottom - length
         if (hole%bottom <= 0.0_wp .and. length > 0.0_wp) then
            if (size(case%holes) > 0 .and. attribute(tree%elements(i), 'md_top') == '') &
               hole%top = maxval(case%holes%bottom) - datum
            hole%bottom = hole%top + length
         end if
         if (.not. hole%cased .and. length <= 0.0_wp .and. attribute(tree%elements(i), 'md_top') == '') &
            call append_text(case%hole_notes, 'GUESSED: top of section '//hole%name//': where the one above ends')
         hole%top = max(0.0_wp, hole%top + datum)
         hole%bottom = hole%bottom + datum
         call add_hole(case, hole)
      end do

   contains

      !> The first of two attributes that has a value [m].
      function first_of(first, second) result(value)
         character(*), intent(in) :: first, second
         real(wp) :: value
         call get(tree, i, first, inch, value, failure)
         if (value <= 0.0_wp) call get(tree, i, second, inch, value, failure)
      end function first_of
   end subroutine read_holes

   !> The string: that of the case, else the deepest drillstring, else any.
   subroutine read_string(tree, wellbore, asked, datum, case, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: wellbore
      character(*), intent(in) :: asked            !< id of the assembly of the case; ''
      real(wp), intent(in) :: datum                !< [m]
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(text_type), allocatable :: names(:)
      integer, allocatable :: rows(:)
      real(wp), allocatable :: numbers(:)
      real(wp) :: base, rank, best
      character(:), allocatable :: id, kind
      integer :: i, chosen
      allocate (names(0))
      chosen = 0
      best = -huge(1.0_wp)
      do i = 1, tree%n
         if (tree%elements(i)%name /= 'cd_assembly' .or. .not. is_of(tree, i, wellbore)) cycle
         call append_text(names, attribute(tree%elements(i), 'assembly_name'))
         call get(tree, i, 'md_assembly_base', foot, base, failure)
         kind = lower_case(attribute(tree%elements(i), 'string_type'))
         rank = base
         if (index(kind, 'drill') > 0 .or. index(kind, 'bha') > 0 .or. index(kind, 'work') > 0) rank = rank + 1.0e6_wp
         if (asked /= '' .and. attribute(tree%elements(i), 'assembly_id') == asked) rank = rank + 1.0e7_wp
         if (rank <= best) cycle
         best = rank
         chosen = i
         case%bit_depth = base
         if (base > 0.0_wp) case%bit_depth = base + datum
      end do
      if (chosen == 0 .or. failure /= '') return
      if (size(names) > 1) call append_text(case%string_notes, 'GUESSED: string '// &
         attribute(tree%elements(chosen), 'assembly_name')//', of '//one_of(names))
      id = attribute(tree%elements(chosen), 'assembly_id')
      rows = pack([(i, i=1, tree%n)], [(tree%elements(i)%name == 'cd_assembly_comp' .and. is_of(tree, i, wellbore) .and. &
                                        attribute(tree%elements(i), 'assembly_id') == id, i=1, tree%n)])
      allocate (numbers(size(rows)))
      do i = 1, size(rows)
         call get(tree, rows(i), 'sequence_no', 1.0_wp, numbers(i), failure)
      end do
      rows = rows(sorted_places(numbers))
      do i = 1, size(rows)
         if (failure == '') call read_part(tree, rows(i), case, failure)
      end do
      call order_from_bit(lower_case(attribute(tree%elements(chosen), 'is_top_down')), case)
   end subroutine read_string

   !> Components from the bit upwards, whichever way the export has them.
   subroutine order_from_bit(top_down, case)
      character(*), intent(in) :: top_down         !< 'y', 'n' or ''
      type(imported_case_type), intent(inout) :: case
      integer :: n
      n = size(case%parts)
      if (n < 2) return
      if (case%parts(1)%kind == 'bit' .and. case%parts(n)%kind /= 'bit') return
      if (case%parts(n)%kind == 'bit' .or. top_down /= 'n') case%parts = case%parts(n:1:-1)
      if (case%parts(1)%kind /= 'bit' .and. top_down == '') &
         call append_text(case%string_notes, 'GUESSED: the export lists the string from the top; it has no bit at either end')
   end subroutine order_from_bit

   subroutine read_part(tree, row, case, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: row
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(imported_part_type) :: part
      character(:), allocatable :: words
      character(*), parameter :: names(4) = [character(16) :: 'comp_name', 'description', 'catalog_key_desc', 'sect_type_code']
      integer :: i
      part%name = ''
      do i = 1, size(names)
         if (part%name == '') part%name = attribute(tree%elements(row), trim(names(i)))
      end do
      words = attribute(tree%elements(row), 'comp_type_code')//' '//attribute(tree%elements(row), 'sect_type_code')
      part%kind = kind_of_part(words)
      if (part%kind == '' .or. part%kind == 'collar') words = kind_of_part(part%name)
      if (part%kind == '' .or. (part%kind == 'collar' .and. words /= '')) part%kind = words
      part%remark = ''
      call get(tree, row, 'length', foot, part%length, failure)
      call get(tree, row, 'od_body', inch, part%od, failure)
      call get(tree, row, 'id_body', inch, part%id, failure)
      call get(tree, row, 'od_connection', inch, part%joint_od, failure)
      call get(tree, row, 'id_connection', inch, part%joint_id, failure)
      call get(tree, row, 'length_tool_joint', foot, part%joint_length, failure)
      call get(tree, row, 'approximate_weight', pound/foot, part%mass, failure)
      call get(tree, row, 'min_yield_stress', psi, part%yield, failure)
      call get(tree, row, 'makeup_torque', foot*pound_force, part%makeup_torque, failure)
      if (part%yield > highest_yield*psi) part%yield = part%yield/square_foot
      if (part%kind == 'stabilizer') then
         call get(tree, row, 'blade_od', inch, part%joint_od, failure)
         if (part%joint_od <= 0.0_wp) call get(tree, row, 'od_blade', inch, part%joint_od, failure)
      end if
      if (index(lower_case(attribute(tree%elements(row), 'material')), 'al') == 1 .or. &
          index(lower_case(attribute(tree%elements(row), 'material')), 'ti') == 1) &
         part%remark = 'MISSING: density and modulus of '//attribute(tree%elements(row), 'material')//'; steel is taken'
      call add_part(case, part)
   end subroutine read_part

   !> The mud: the last row of the wellbore that has a density.
   subroutine read_fluid(tree, wellbore, case, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: wellbore
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(text_type), allocatable :: names(:)
      real(wp) :: density
      integer :: i
      allocate (names(0))
      do i = 1, tree%n
         if (tree%elements(i)%name /= 'cd_fluid' .or. .not. is_of(tree, i, wellbore)) cycle
         call get(tree, i, 'density', 1.0_wp, density, failure)
         if (density <= 0.0_wp) cycle
         if (density > highest_density) density = density/cubic_foot
         case%density = density*pound/gallon
         call append_text(names, attribute(tree%elements(i), 'fluid_name')//' ('//to_text(density, 5)//' lbm/gal)')
      end do
      if (size(names) > 1) call append_text(case%fluid_notes, 'GUESSED: the last of the fluids '//one_of(names))
   end subroutine read_fluid
end module dg_edm_case

!> Hole, string and mud in WITSML documents (Energistics; 1.3.1, 1.4.1, 2.0, 2.1). Trajectories are read by dg_survey_file.
module dg_witsml_case
   use dg_constants, only: degree, foot, gallon, inch, pound, survey_foot
   use dg_deck_number, only: read_real
   use dg_imported_case, only: add_hole, add_part, imported_case_type, imported_hole_type, imported_part_type, is_meant, &
      kind_of_part, one_of
   use dg_kinds, only: wp
   use dg_merge_sort, only: sorted_places
   use dg_text, only: append_text, lower_case, quoted, text_type, to_text
   use dg_witsml_survey, only: object_name, well_of
   use dg_xml_tree, only: attribute, child, text_at, xml_tree_type
   implicit none
   private
   public :: witsml_elements, has_trajectory, is_called, read_witsml_case

   character(*), parameter :: witsml_elements = 'trajectory tubular wbgeometry wellboregeometry fluidsreport'

   !> Names of units in WITSML, in lower case, with their SI values.
   type :: unit_type
      character(10) :: name = ''
      real(wp) :: value = 0.0_wp
   end type unit_type
   type(unit_type), parameter :: lengths(8) = [unit_type('m', 1.0_wp), unit_type('mm', 1.0e-3_wp), unit_type('cm', 1.0e-2_wp), &
      unit_type('in', inch), unit_type('ft', foot), unit_type('ftus', survey_foot), &
      unit_type('ft[us]', survey_foot), unit_type('km', 1.0e3_wp)]
   type(unit_type), parameter :: masses(4) = [unit_type('kg/m', 1.0_wp), unit_type('lbm/ft', pound/foot), &
      unit_type('lb/ft', pound/foot), unit_type('g/m', 1.0e-3_wp)]
   type(unit_type), parameter :: densities(9) = [unit_type('kg/m3', 1.0_wp), unit_type('g/cm3', 1.0e3_wp), &
      unit_type('kg/dm3', 1.0e3_wp), unit_type('kg/l', 1.0e3_wp), unit_type('lbm/galus', pound/gallon), &
      unit_type('lbm/gal', pound/gallon), unit_type('lbm/gal[us', pound/gallon), unit_type('lb/gal', pound/gallon), &
      unit_type('lbm/ft3', pound/foot**3)]
   type(unit_type), parameter :: angles(3) = [unit_type('dega', degree), unit_type('deg', degree), unit_type('rad', 1.0_wp)]
   type(unit_type), parameter :: numbers(3) = [unit_type('', 1.0_wp), unit_type('euc', 1.0_wp), unit_type('%', 0.01_wp)]

contains

   !> True if an object, its well or its wellbore has a name. The name '' fits any object, and an object without a well fits any
   !> name.
   function is_called(tree, i, name) result(is)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      character(*), intent(in) :: name
      logical :: is
      is = name == '' .or. well_of(tree, i) == '' .or. is_meant(well_of(tree, i), name) .or. &
           is_meant(object_name(tree, i), name) .or. is_meant(text_at(tree, i, 'namewellbore'), name)
   end function is_called

   !> True if a document has a trajectory with a name, of a well.
   function has_trajectory(tree, well, name) result(has)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: well, name       !< '': any
      logical :: has
      integer :: i
      has = .false.
      do i = 1, tree%n
         if (tree%elements(i)%parent > 0 .or. tree%elements(i)%name /= 'trajectory') cycle
         has = has .or. (is_called(tree, i, well) .and. is_called(tree, i, name))
      end do
   end function has_trajectory

   !> Read hole, string and mud of a well from one document, each once.
   subroutine read_witsml_case(tree, well, case, failure)
      type(xml_tree_type), intent(in) :: tree
      character(*), intent(in) :: well             !< ''; any
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      integer :: i
      do i = 1, tree%n
         if (tree%elements(i)%parent > 0 .or. failure /= '') cycle
         if (.not. is_called(tree, i, well)) cycle
         select case (tree%elements(i)%name)
         case ('tubular')
            if (size(case%parts) > 0) then
               call append_text(case%string_notes, 'GUESSED: string '//object_name(tree, i)//' is left out, the first one counts')
            else
               call read_string(tree, i, case, failure)
            end if
         case ('wbgeometry', 'wellboregeometry')
            if (size(case%holes) > 0) then
               call append_text(case%hole_notes, 'GUESSED: geometry '//object_name(tree, i)//' is left out, the first one counts')
            else
               call read_holes(tree, i, case, failure)
            end if
         case ('fluidsreport')
            call read_fluid(tree, i, case, failure)
         case default
         end select
      end do
   end subroutine read_witsml_case

   !> A number with its unit; 0 where the element is absent or empty.
   subroutine get(tree, i, path, units, value, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      character(*), intent(in) :: path
      type(unit_type), intent(in) :: units(:)
      real(wp), intent(inout) :: value             !< [SI]; stays where the element is absent
      character(:), allocatable, intent(inout) :: failure
      character(:), allocatable :: uom
      logical :: legal
      real(wp) :: number
      integer :: k, place
      k = child(tree, i, path)
      if (k == 0 .or. failure /= '') return
      if (tree%elements(k)%text == '') return
      call read_real(tree%elements(k)%text, number, legal)
      uom = lower_case(attribute(tree%elements(k), 'uom'))
      if (.not. legal) then
         failure = path//' = '//quoted(tree%elements(k)%text)//' is not a number'
      else
         if (index(uom, '[us]') > 3) uom = uom(:index(uom, '[us]') + 2)
         if (uom == 'ft[us') uom = 'ft[us]'
         place = findloc(units%name == uom, .true., dim=1)
         if (place == 0) then
            failure = 'the unit of '//path//', uom = '//quoted(uom)//', is not known'
         else
            value = number*units(place)%value
         end if
      end if
      if (failure /= '') failure = 'line '//to_text(tree%elements(k)%line)//': '//failure
   end subroutine get

   !> Components by their sequence, which begins at the bit.
   subroutine read_string(tree, tubular, case, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: tubular
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      integer, allocatable :: places(:)
      real(wp), allocatable :: sequence(:)
      real(wp) :: number
      integer :: i
      allocate (places(0), sequence(0))
      i = child(tree, tubular, 'tubularcomponent')
      do while (i > 0)
         number = real(size(places) + 1, wp)
         call get(tree, i, 'sequence', numbers, number, failure)
         places = [places, i]
         sequence = [sequence, number]
         i = child(tree, tubular, 'tubularcomponent', after=i)
      end do
      places = places(sorted_places(sequence))
      do i = 1, size(places)
         if (failure == '') call read_part(tree, places(i), case, failure)
      end do
      i = size(case%parts)
      if (i < 2) return
      if (case%parts(i)%kind == 'bit' .and. case%parts(1)%kind /= 'bit') then
         case%parts = case%parts(i:1:-1)
         call append_text(case%string_notes, 'GUESSED: the document lists the string from the top, as its last component is a bit')
      end if
   end subroutine read_string

   subroutine read_part(tree, i, case, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(imported_part_type) :: part
      character(:), allocatable :: type_name
      type_name = text_at(tree, i, 'typetubularcomp')
      if (type_name == '') type_name = text_at(tree, i, 'typetubularcomponent')
      part%name = text_at(tree, i, 'description')
      if (part%name == '') part%name = type_name
      part%kind = kind_of_part(type_name)
      if (part%kind == '') part%kind = kind_of_part(part%name)
      part%remark = ''
      call get(tree, i, 'len', lengths, part%length, failure)
      call get(tree, i, 'od', lengths, part%od, failure)
      call get(tree, i, 'id', lengths, part%id, failure)
      call get(tree, i, 'wtperlen', masses, part%mass, failure)
      call get(tree, i, 'connection/od', lengths, part%joint_od, failure)
      call get(tree, i, 'odmx', lengths, part%joint_od, failure)
      select case (part%kind)
      case ('stabilizer')
         call get(tree, i, 'stabilizer/odblademx', lengths, part%joint_od, failure)
      case ('bit')
         call get(tree, i, 'bitrecord/diabit', lengths, part%joint_od, failure)
      case default
         call get(tree, i, 'bend/angle', angles, part%bend, failure)
         call get(tree, i, 'bend/distbendbot', lengths, part%bend_position, failure)
         call get(tree, i, 'stabilizer/odblademx', lengths, part%joint_od, failure)
      end select
      call add_part(case, part)
   end subroutine read_part

   !> Sections of hole and casing.
   subroutine read_holes(tree, geometry, case, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: geometry
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(imported_hole_type) :: hole
      character(:), allocatable :: section
      integer :: i
      section = 'wbgeometrysection'
      if (child(tree, geometry, section) == 0) section = 'wellboregeometrysection'
      if (child(tree, geometry, section) == 0) section = 'section'
      i = child(tree, geometry, section)
      do while (i > 0)
         hole = imported_hole_type()
         hole%name = text_at(tree, i, 'typeholecasing')
         hole%remark = ''
         hole%cased = index(lower_case(hole%name), 'open') == 0 .and. hole%name /= ''
         call get(tree, i, 'mdtop', lengths, hole%top, failure)
         call get(tree, i, 'mdbottom', lengths, hole%bottom, failure)
         call get(tree, i, 'sectionmdinterval/mdtop', lengths, hole%top, failure)
         call get(tree, i, 'sectionmdinterval/mdbase', lengths, hole%bottom, failure)
         call get(tree, i, 'idsection', lengths, hole%diameter, failure)
         call get(tree, i, 'factfric', numbers, hole%friction, failure)
         if (hole%diameter <= 0.0_wp .and. .not. hole%cased) call get(tree, i, 'diahole', lengths, hole%diameter, failure)
         if (hole%diameter <= 0.0_wp .and. .not. hole%cased) call get(tree, i, 'odsection', lengths, hole%diameter, failure)
         if (failure /= '') return
         call add_hole(case, hole)
         i = child(tree, geometry, section, after=i)
      end do
   end subroutine read_holes

   !> Density of the last fluid of the report.
   subroutine read_fluid(tree, report, case, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: report
      type(imported_case_type), intent(inout) :: case
      character(:), allocatable, intent(inout) :: failure
      type(text_type), allocatable :: names(:)
      integer :: i
      allocate (names(0))
      i = child(tree, report, 'fluid')
      do while (i > 0)
         call get(tree, i, 'density', densities, case%density, failure)
         call append_text(names, text_at(tree, i, 'type')//' '//to_text(case%density, 6)//' kg/m3')
         i = child(tree, report, 'fluid', after=i)
      end do
      if (size(names) > 1) call append_text(case%fluid_notes, 'GUESSED: the last of the fluids '//one_of(names))
   end subroutine read_fluid
end module dg_witsml_case

!> Trajectories of WITSML documents (1.3.1, 1.4.1, 2.0, 2.1; Energistics) as lines of a survey table.
module dg_witsml_survey
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_deck_number, only: read_real
   use dg_merge_sort, only: sorted_places
   use dg_table_unit, only: read_unit
   use dg_text, only: either, lower_case, quoted, text_type, to_text
   use dg_xml, only: read_tree
   use dg_xml_tree, only: attribute, text_at, xml_tree_type
   implicit none
   private
   public :: witsml_table, object_name, well_of

   !> Elements of a station, and the headings that their columns get.
   integer, parameter :: of_md = 1, of_inc = 2, of_azi = 3, value_count = 6
   character(*), parameter :: value_names(value_count) = [character(6) :: 'md', 'incl', 'azi', 'tvd', 'dispns', 'dispew']
   character(*), parameter :: headings(value_count) = [character(9) :: 'md (m)', 'inc (deg)', 'azi (deg)', 'tvd (m)', 'north (m)', &
      'east (m)']
   logical, parameter :: is_angle(value_count) = [.false., .true., .true., .false., .false., .false.]
   !> Names of units in WITSML, and as tables of surveys have them.
   character(*), parameter :: unit_names(2, 4) = reshape([character(6) :: 'dega', 'deg', 'ftus', 'usft', 'ft[us]', 'usft', &
      'ftkb', 'ft'], [2, 4])

   !> Names of a trajectory.
   type :: trajectory_type
      character(:), allocatable :: name, well, wellbore
      integer :: stations = 0
   end type trajectory_type

   type :: station_type
      integer :: trajectory = 0                    !< its number in the document
      integer :: line = 0
      real(wp) :: values(value_count) = 0.0_wp     !< [m or deg]
      logical :: has(value_count) = .false.
   end type station_type

contains

   !> Turns the document `path` into a table: a header, then a row for each station. Each row has the number of the station's line
   !> in the document, where every station begins a line. `chosen` says which trajectory it is.
   subroutine witsml_table(path, wanted, lines, chosen, failure)
      character(*), intent(in) :: path
      character(*), intent(in) :: wanted               !< name of the trajectory, its well or wellbore; '': the only one
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(:), allocatable, intent(out) :: chosen
      character(:), allocatable, intent(out) :: failure
      type(xml_tree_type) :: tree
      type(trajectory_type), allocatable :: trajectories(:)
      type(station_type), allocatable :: stations(:)
      integer :: i, n, number
      chosen = ''
      call read_tree(path, 'trajectory', 'uom', tree, failure)
      allocate (trajectories(0), stations(tree%n))
      n = 0
      do i = 1, tree%n
         if (failure /= '') return
         if (tree%elements(i)%name == 'trajectory') trajectories = [trajectories, trajectory_of(tree, i)]
         if (tree%elements(i)%name /= 'trajectorystation') cycle
         n = n + 1
         number = size(trajectories)
         trajectories(number)%stations = trajectories(number)%stations + 1
         stations(n)%trajectory = number
         call read_station(tree, i, stations(n), failure)
      end do
      if (failure == '') call choose(trajectories, wanted, number, failure)
      if (failure /= '') return
      associate (found => trajectories(number))
         chosen = 'WITSML trajectory '//quoted(found%name)//' of well '//quoted(found%well)//', '//to_text(found%stations)// &
                  ' stations'
      end associate
      call write_table(pack(stations(:n), stations(:n)%trajectory == number), lines)
   end subroutine witsml_table

   !> The names of a trajectory.
   function trajectory_of(tree, i) result(one)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      type(trajectory_type) :: one
      one%name = object_name(tree, i)
      one%well = well_of(tree, i)
      one%wellbore = text_at(tree, i, 'namewellbore')
      if (one%wellbore == '') one%wellbore = text_at(tree, i, 'wellbore/title')
   end function trajectory_of

   !> Name of an object of a document: a trajectory, a string.
   pure function object_name(tree, i) result(name)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      character(:), allocatable :: name
      name = text_at(tree, i, 'name')
      if (name == '') name = text_at(tree, i, 'citation/title')
   end function object_name

   !> Well of an object; of series 2, which names the wellbore alone, that.
   pure function well_of(tree, i) result(name)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      character(:), allocatable :: name
      name = text_at(tree, i, 'namewell')
      if (name == '') name = text_at(tree, i, 'wellbore/title')
   end function well_of

   !> The values directly in a station, which has md and inc. `failure` begins with the line in the document.
   subroutine read_station(tree, i, station, failure)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i                     !< element of the station
      type(station_type), intent(inout) :: station
      character(:), allocatable, intent(inout) :: failure
      integer :: line, k, value
      line = tree%elements(i)%line
      station%line = line
      do k = i + 1, tree%n
         if (tree%elements(k)%parent < i .or. failure /= '') exit
         line = tree%elements(k)%line
         value = findloc(value_names == tree%elements(k)%name, .true., dim=1)
         if (tree%elements(k)%parent == i .and. value > 0) call read_value()
      end do
      do value = of_md, of_inc
         if (.not. station%has(value)) call fail('a trajectoryStation has no '//trim(value_names(value)))
      end do

   contains

      !> A number and its unit, which is in the attribute uom.
      subroutine read_value()
         character(:), allocatable :: uom
         real(wp) :: unit
         logical :: known
         integer :: m
         associate (element => tree%elements(k))
            uom = attribute(element, 'uom')
            do m = 1, size(unit_names, 2)
               if (lower_case(uom) == unit_names(1, m)) uom = trim(unit_names(2, m))
            end do
            unit = 0.0_wp
            known = .false.
            if (uom /= '') call read_unit(uom, is_angle(value), unit, known)
            if (.not. (known .and. unit > 0.0_wp)) call fail('the unit of '//trim(value_names(value))//', uom = '//quoted(uom)// &
               ', is not known; '//either('deg and rad', 'm, ft and ft[US]', is_angle(value))//' are')
            if (element%text == '') return
            call read_real(element%text, station%values(value), station%has(value))
            if (.not. station%has(value)) &
               call fail(trim(value_names(value))//' = '//quoted(element%text)//' is not a number')
            if (is_angle(value)) unit = unit/degree
            station%values(value) = station%values(value)*unit
         end associate
      end subroutine read_value

      !> Keeps the first failure.
      subroutine fail(why)
         character(*), intent(in) :: why
         if (failure == '') failure = 'line '//to_text(line)//': '//why
      end subroutine fail
   end subroutine read_station

   !> The trajectory that is meant. Several and none named, or none of the name, are a failure that lists them.
   pure subroutine choose(trajectories, wanted, number, failure)
      type(trajectory_type), intent(in) :: trajectories(:)
      character(*), intent(in) :: wanted
      integer, intent(out) :: number
      character(:), allocatable, intent(inout) :: failure
      integer :: i, fitting
      number = 0
      fitting = 0
      do i = 1, size(trajectories)
         associate (one => trajectories(i))
            if (one%stations == 0) cycle
            if (wanted /= '' .and. .not. is_called(one, wanted)) cycle
            fitting = fitting + 1
            if (number == 0) number = i
         end associate
      end do
      if (fitting == 1) return
      if (sum(trajectories%stations) == 0) then
         failure = 'is an XML document without a WITSML trajectory: no trajectoryStation is in it. Export the survey as CSV, '// &
                   'or as a WITSML trajectory'
         return
      end if
      failure = 'holds these trajectories: '//names_of(trajectories)//'. Name one by survey_well'
      if (wanted /= '' .and. fitting == 0) failure = failure//'; none is called '//quoted(wanted)
      if (fitting > 1 .and. wanted /= '') failure = failure//'; '//to_text(fitting)//' are called '//quoted(wanted)
   end subroutine choose

   !> True if a trajectory, its well or its wellbore has a name; letter case does not count.
   pure function is_called(one, name) result(is)
      type(trajectory_type), intent(in) :: one
      character(*), intent(in) :: name
      logical :: is
      is = lower_case(one%name) == lower_case(name) .or. lower_case(one%well) == lower_case(name) .or. &
           lower_case(one%wellbore) == lower_case(name)
   end function is_called

   !> "'plan' of well 'A-1' (12 stations), 'actual' of well ..."
   pure function names_of(trajectories) result(text)
      type(trajectory_type), intent(in) :: trajectories(:)
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, size(trajectories)
         associate (one => trajectories(i))
            if (one%stations == 0) cycle
            if (text /= '') text = text//', '
            text = text//quoted(one%name)//' of well '//quoted(one%well)//' ('//to_text(one%stations)//' stations)'
         end associate
      end do
   end function names_of

   !> The table of stations, by measured depth. Columns of positions are those that each station has.
   pure subroutine write_table(stations, lines)
      type(station_type), intent(in) :: stations(:)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(station_type) :: sorted(size(stations))
      real(wp) :: md(size(stations))
      integer :: i, k, row, length, n
      logical :: wanted(value_count), in_place
      character(:), allocatable :: text
      n = size(stations)
      md = stations%values(of_md)
      sorted = stations(sorted_places(md))
      do k = 1, value_count
         wanted(k) = k <= of_azi .or. all(stations%has(k))
      end do
      ! A station keeps its line where each begins a line of its own, below the first and in order.
      in_place = sorted(1)%line > 1 .and. all(sorted(2:)%line > sorted(:n - 1)%line)
      length = merge(sorted(n)%line, n + 1, in_place)
      deallocate (lines)
      allocate (lines(length))
      do i = 1, length
         lines(i)%text = ''
      end do
      text = ''
      do k = 1, value_count
         if (wanted(k)) text = text//','//trim(headings(k))
      end do
      lines(1)%text = text(2:)
      do i = 1, n
         row = merge(sorted(i)%line, i + 1, in_place)
         text = ''
         do k = 1, value_count
            if (.not. wanted(k)) cycle
            text = text//','
            if (sorted(i)%has(k)) text = text//to_text(sorted(i)%values(k))
         end do
         lines(row)%text = text(2:)
      end do
   end subroutine write_table
end module dg_witsml_survey

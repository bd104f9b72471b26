!> Trajectories of WITSML documents (1.3.1, 1.4.1, 2.0, 2.1; Energistics) as lines of a survey table.
module dg_witsml_survey
   use dg_kinds, only: wp
   use dg_constants, only: degree
   use dg_deck_number, only: read_real
   use dg_merge_sort, only: sorted_places
   use dg_table_unit, only: read_unit
   use dg_text, only: lower_case, quoted, text_type, to_text
   use dg_xml, only: read_xml, xml_reader_type
   implicit none
   private
   public :: witsml_table

   !> Elements of a station, and the headings that their columns get.
   integer, parameter :: of_md = 1, of_inc = 2, of_azi = 3, value_count = 6
   character(*), parameter :: value_names(value_count) = [character(6) :: 'md', 'incl', 'azi', 'tvd', 'dispns', 'dispew']
   character(*), parameter :: headings(value_count) = [character(9) :: 'md (m)', 'inc (deg)', 'azi (deg)', 'tvd (m)', 'north (m)', &
      'east (m)']
   logical, parameter :: is_angle(value_count) = [.false., .true., .true., .false., .false., .false.]
   !> Names of units in WITSML, and as tables of surveys have them.
   character(*), parameter :: unit_names(2, 4) = reshape([character(6) :: 'dega', 'deg', 'ftus', 'usft', 'ft[us]', 'usft', &
      'ftkb', 'ft'], [2, 4])
   integer, parameter :: deepest = 100, first_room = 256

   !> Names of a trajectory.
   type :: trajectory_type
      character(:), allocatable :: name, well, wellbore
      integer :: stations = 0
   end type trajectory_type

   type, extends(xml_reader_type) :: witsml_type
      character(40) :: path(deepest) = ''          !< open elements, in lower case
      integer :: depth = 0
      type(trajectory_type), allocatable :: trajectories(:)
      integer :: n = 0                             !< stations
      integer, allocatable :: of(:), line(:)       !< trajectory and line of a station
      real(wp), allocatable :: values(:, :)        !< (value_count,n) [m or deg]
      logical, allocatable :: has(:, :)
      real(wp) :: unit = 1.0_wp                    !< of the number that is being read
      integer :: here = 0                          !< line of the last element
      character(:), allocatable :: failure         !< the first
   contains
      procedure :: begin => begin_element
      procedure :: finish => finish_element
   end type witsml_type

contains

   !> Turns the document `path` into a table: a header, then a row for each station. Each row has the number of the station's line
   !> in the document, where every station begins a line. `chosen` says which trajectory it is.
   subroutine witsml_table(path, wanted, lines, chosen, failure)
      character(*), intent(in) :: path
      character(*), intent(in) :: wanted               !< name of the trajectory, its well or wellbore; '': the only one
      type(text_type), allocatable, intent(inout) :: lines(:)
      character(:), allocatable, intent(out) :: chosen
      character(:), allocatable, intent(out) :: failure
      type(witsml_type) :: document
      integer :: number
      allocate (document%trajectories(0), document%of(first_room), document%line(first_room))
      allocate (document%values(value_count, first_room), document%has(value_count, first_room))
      document%failure = ''
      chosen = ''
      call read_xml(path, document, failure)
      if (failure == '') failure = document%failure
      if (failure /= '') return
      call choose(document%trajectories, wanted, number, failure)
      if (failure /= '') return
      associate (found => document%trajectories(number))
         chosen = 'WITSML trajectory '//quoted(found%name)//' of well '//quoted(found%well)//', '//to_text(found%stations)// &
                  ' stations'
      end associate
      call write_table(document, number, lines)
   end subroutine witsml_table

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

   !> Whether a trajectory, its well or its wellbore has a name; letter case does not count.
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

   !> The table of a trajectory, by measured depth. Columns of positions are those that each station has.
   pure subroutine write_table(document, number, lines)
      type(witsml_type), intent(in) :: document
      integer, intent(in) :: number
      type(text_type), allocatable, intent(inout) :: lines(:)
      integer :: order(count(document%of(:document%n) == number)), i, k, row, length
      real(wp) :: md(size(order))
      logical :: wanted(value_count), in_place
      character(:), allocatable :: text
      order = pack([(i, i=1, document%n)], document%of(:document%n) == number)
      md = document%values(of_md, order)
      order = order(sorted_places(md))
      do k = 1, value_count
         wanted(k) = k <= of_azi .or. all(document%has(k, order))
      end do
      ! A station keeps its line where each begins a line of its own, below the first and in order.
      in_place = document%line(order(1)) > 1 .and. all(document%line(order(2:)) > document%line(order(:size(order) - 1)))
      length = merge(document%line(order(size(order))), size(order) + 1, in_place)
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
      do i = 1, size(order)
         row = merge(document%line(order(i)), i + 1, in_place)
         text = ''
         do k = 1, value_count
            if (.not. wanted(k)) cycle
            text = text//','
            if (document%has(k, order(i))) text = text//to_text(document%values(k, order(i)))
         end do
         lines(row)%text = text(2:)
      end do
   end subroutine write_table

   !> An element begins: a trajectory, a station, or a number with its unit.
   subroutine begin_element(reader, name, attributes, line)
      class(witsml_type), intent(inout) :: reader
      character(*), intent(in) :: name
      type(text_type), intent(in) :: attributes(:)
      integer, intent(in) :: line
      type(trajectory_type) :: empty
      reader%here = line
      if (reader%depth == deepest) return
      reader%depth = reader%depth + 1
      reader%path(reader%depth) = lower_case(name)
      select case (reader%path(reader%depth))
      case ('trajectory')
         empty%name = ''
         empty%well = ''
         empty%wellbore = ''
         reader%trajectories = [reader%trajectories, empty]
      case ('trajectorystation')
         if (size(reader%trajectories) == 0) return
         call add_station(reader, line)
      case default
         if (number_here(reader) > 0) call read_uom(reader, number_here(reader), attributes)
      end select
   end subroutine begin_element

   !> An element ends: a name, or a number of a station.
   subroutine finish_element(reader, name, text)
      class(witsml_type), intent(inout) :: reader
      character(*), intent(in) :: name, text
      real(wp) :: number
      logical :: is_number
      integer :: k
      if (lower_case(name) /= reader%path(reader%depth)) return
      if (size(reader%trajectories) > 0) call take_name(reader, trim(adjustl(text)))
      k = number_here(reader)
      if (k > 0 .and. text /= '') then
         call read_real(trim(adjustl(text)), number, is_number)
         if (is_number) then
            reader%values(k, reader%n) = number*reader%unit
            reader%has(k, reader%n) = .true.
         else
            call fail(reader, trim(value_names(k))//' = '//quoted(trim(adjustl(text)))//' is not a number')
         end if
      end if
      if (reader%path(reader%depth) == 'trajectorystation' .and. reader%n > 0) then
         do k = of_md, of_inc
            if (.not. reader%has(k, reader%n)) call fail(reader, 'a trajectoryStation has no '//trim(value_names(k)))
         end do
      end if
      reader%depth = reader%depth - 1
   end subroutine finish_element

   !> Number of the value whose element is open, directly in a station; 0: another element.
   pure function number_here(reader) result(number)
      class(witsml_type), intent(in) :: reader
      integer :: number
      number = 0
      if (reader%depth < 2 .or. reader%n == 0) return
      if (reader%path(reader%depth - 1) /= 'trajectorystation') return
      number = findloc(value_names == reader%path(reader%depth), .true., dim=1)
   end function number_here

   !> The unit of a number, in its attribute uom.
   subroutine read_uom(reader, k, attributes)
      class(witsml_type), intent(inout) :: reader
      integer, intent(in) :: k
      type(text_type), intent(in) :: attributes(:)
      character(:), allocatable :: uom
      real(wp) :: unit
      logical :: known
      integer :: i
      uom = ''
      do i = 1, size(attributes) - 1, 2
         if (attributes(i)%text == 'uom') uom = attributes(i + 1)%text
      end do
      do i = 1, size(unit_names, 2)
         if (lower_case(uom) == unit_names(1, i)) uom = trim(unit_names(2, i))
      end do
      unit = 0.0_wp
      known = .false.
      if (uom /= '') call read_unit(uom, is_angle(k), unit, known)
      if (.not. (known .and. unit > 0.0_wp)) then
         call fail(reader, 'the unit of '//trim(value_names(k))//', uom = '//quoted(uom)//', is not known; '// &
                   trim(merge('deg and rad     ', 'm, ft and ft[US]', is_angle(k)))//' are')
         unit = 1.0_wp
      end if
      reader%unit = unit
      if (is_angle(k)) reader%unit = unit/degree
   end subroutine read_uom

   !> Takes a name of the trajectory that is open.
   subroutine take_name(reader, text)
      class(witsml_type), intent(inout) :: reader
      character(*), intent(in) :: text
      character(40) :: parent, above
      parent = ''
      above = ''
      if (reader%depth > 1) parent = reader%path(reader%depth - 1)
      if (reader%depth > 2) above = reader%path(reader%depth - 2)
      associate (one => reader%trajectories(size(reader%trajectories)))
         select case (reader%path(reader%depth))
         case ('name')
            if (parent == 'trajectory') one%name = text
         case ('namewell')
            if (parent == 'trajectory') one%well = text
         case ('namewellbore')
            if (parent == 'trajectory') one%wellbore = text
         case ('title')
            if (parent == 'citation' .and. above == 'trajectory') one%name = text
            if (parent == 'wellbore') one%wellbore = text
            if (parent == 'wellbore' .and. one%well == '') one%well = text
         case default
         end select
      end associate
   end subroutine take_name

   !> Room for one more station, and the station.
   subroutine add_station(reader, line)
      class(witsml_type), intent(inout) :: reader
      integer, intent(in) :: line
      integer :: room
      room = size(reader%of)
      if (reader%n == room) then
         reader%of = [reader%of, spread(0, 1, room)]
         reader%line = [reader%line, spread(0, 1, room)]
         reader%values = reshape([reader%values, reader%values], [value_count, 2*room])
         reader%has = reshape([reader%has, reader%has], [value_count, 2*room])
      end if
      reader%n = reader%n + 1
      reader%of(reader%n) = size(reader%trajectories)
      reader%line(reader%n) = line
      reader%has(:, reader%n) = .false.
      associate (one => reader%trajectories(size(reader%trajectories)))
         one%stations = one%stations + 1
      end associate
   end subroutine add_station

   !> Keeps the first failure, with its line.
   subroutine fail(reader, why)
      class(witsml_type), intent(inout) :: reader
      character(*), intent(in) :: why
      if (reader%failure == '') reader%failure = 'line '//to_text(reader%here)//': '//why
   end subroutine fail
end module dg_witsml_survey

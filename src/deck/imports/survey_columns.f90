!> Which columns of a survey table are measured depth, inclination and azimuth, by their headings or as the deck names them.
module dg_survey_columns
   use dg_constants, only: degree, foot, survey_foot
   use dg_deck_number, only: is_number
   use dg_kinds, only: wp
   use dg_readable, only: squeezed
   use dg_survey_heading, only: column_azi, column_inc, column_md, column_name, heading_type, loose_rank, no_column, read_heading
   use dg_table_unit, only: read_unit
   use dg_text, only: nearest_name, quoted, to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: layout_type, no_extent, column_names_type, choose_columns, set_unit, missing_columns, taken_columns

   !> Headings that the deck names for md, inc, azi; '': none.
   type :: column_names_type
      character(200) :: names(3) = ''
      character(200) :: well = ''                !< trajectory of a WITSML document; '': the only one
   end type column_names_type

   !> Columns of a table and the SI values of their units.
   type :: layout_type
      character :: separator = ' '               !< of the rows
      logical :: wide = .false.                  !< two blanks or more separate the cells of a row, one does not
      type(heading_type), allocatable :: headings(:)
      integer :: place(6) = 0                    !< column of md, inc, azi, tvd, north, east; 0: none
      integer :: rival(3) = 0                    !< another column that might be md, inc, azi; 0: none
      integer :: well = 0                        !< column of the name of the well; 0: none
      integer :: width = 0                       !< columns that the header names
      real(wp) :: factor(6) = 1.0_wp
      real(wp) :: rival_factor(3) = 1.0_wp
      logical :: told(6) = .false.               !< the table itself names the unit
      integer :: first_header = 0, first_row = 0 !< first line of the header, line below it and its units
      integer, allocatable :: extent(:, :)       !< first and last letter of each column, (2, width); empty where not known
      logical :: has_null = .false.
      real(wp) :: null = 0.0_wp                  !< number for no value
      character(:), allocatable :: foreign       !< fault of a unit, for a message; '': none
      character(:), allocatable :: unknown       !< fault of a name in the deck, for a message; '': none
   end type layout_type

   integer, parameter :: no_extent(2, 0) = reshape([integer ::], [2, 0])
   !> Headings of the name of a well, without blanks and marks.
   character(*), parameter :: well_names(17) = [character(16) :: 'well', 'wellname', 'wellbore', 'wellborename', 'borehole', &
      'boreholename', 'uwi', 'api', 'apino', 'apinumber', 'apiwellno', 'apiwellnumber', 'wellno', 'wellid', 'wellboreid', &
      'wellnumber', 'holeid']
   character(*), parameter :: known_names(3) = [character(130) :: &
      'MD, Measured Depth, Depth, Survey Depth, Hole Depth, Along Hole Depth, AHD, Total MD', &
      'Inc, Incl, Inclination, Deviation, Devi, Drift, Hole Angle, Deviation Angle', &
      'Azi, Azim, Azm, Azimuth, HAZI, Bearing, Direction, with or without Grid, True, Corrected, Magnetic']

contains

   !> Choose columns by their headings. Of several for one quantity that of the lowest rank is taken, and the first of these.
   subroutine choose_columns(headings, names, units, layout)
      type(heading_type), intent(in) :: headings(:)
      type(column_names_type), intent(in) :: names
      type(unit_system_type), intent(in) :: units
      type(layout_type), intent(inout) :: layout
      integer :: column, i
      logical :: named(size(layout%place))       ! by the deck
      layout%headings = headings
      layout%width = size(headings)
      layout%place = 0
      layout%rival = 0
      layout%factor = units%length
      layout%factor(column_inc:column_azi) = units%angle
      layout%told = .false.
      layout%foreign = ''
      layout%unknown = ''
      layout%well = 0
      do i = size(headings), 1, -1
         if (any(well_names == headings(i)%name)) layout%well = i
      end do
      named = .false.
      do column = 1, column_azi
         if (names%names(column) == '') cycle
         named(column) = .true.
         call find_named(headings, trim(names%names(column)), column, layout)
      end do
      do column = 1, size(layout%place)
         if (.not. named(column)) call choose(column)
         if (layout%place(column) > 0) call set_unit(layout, column, headings(layout%place(column))%unit)
      end do
      do column = 1, column_azi
         if (layout%rival(column) > 0) call read_rival_unit(headings, column, layout)
      end do

   contains

      !> The column of the lowest rank; the next one is a rival of md, inc or azi, unless it alone is only likely.
      subroutine choose(wanted)
         integer, intent(in) :: wanted
         logical :: may(size(headings)), unclear
         integer :: other
         may = [(headings(i)%column == wanted .and. .not. any(layout%place == i), i=1, size(headings))]
         if (.not. any(may)) return
         layout%place(wanted) = minloc(headings%rank, dim=1, mask=may)
         if (wanted > column_azi) return
         associate (rank => headings(layout%place(wanted))%rank)
            may(layout%place(wanted)) = .false.
            other = minloc(headings%rank, dim=1, mask=may)
            if (other > 0) then
               if (rank >= loose_rank .or. headings(other)%rank < loose_rank) layout%rival(wanted) = other
            end if
            ! another heading speaks of the quantity in words that are not known: the user must choose
            unclear = any([(headings(i)%speaks(wanted) .and. headings(i)%column == no_column, i=1, size(headings))])
            if (rank >= loose_rank .and. unclear) layout%place(wanted) = 0
         end associate
      end subroutine choose
   end subroutine choose_columns

   !> The column that the deck names: its heading as it stands, else without regard to capitals, blanks and unit.
   subroutine find_named(headings, name, wanted, layout)
      type(heading_type), intent(in) :: headings(:)
      character(*), intent(in) :: name          !< that the deck gives
      integer, intent(in) :: wanted
      type(layout_type), intent(inout) :: layout
      type(heading_type) :: asked
      logical :: alike(size(headings))
      integer :: k, attempt
      call read_heading(name, asked)
      do attempt = 1, 3
         alike = [(is_alike(headings(k), asked, attempt), k=1, size(headings))]
         layout%place(wanted) = findloc(alike, .true., dim=1)
         if (count(alike) > 1) layout%unknown = trim(column_name(wanted))//'_column = '//quoted(asked%text)// &
            ' stands twice in the header. Rename one of them'
         if (any(alike)) return
      end do
      layout%unknown = trim(column_name(wanted))//'_column = '//quoted(asked%text)//' is not a heading of the file. '// &
                       seen_headings(headings)//nearest_heading(asked%text, headings)
   end subroutine find_named

   !> The unit of a rival; a heading with an unknown unit is another quantity and no rival.
   subroutine read_rival_unit(headings, wanted, layout)
      type(heading_type), intent(in) :: headings(:)
      integer, intent(in) :: wanted
      type(layout_type), intent(inout) :: layout
      real(wp) :: value
      logical :: known
      layout%rival_factor(wanted) = layout%factor(wanted)
      call read_unit(headings(layout%rival(wanted))%unit, wanted /= column_md, value, known)
      if (.not. known) then
         layout%rival(wanted) = 0
      else if (value > 0.0_wp) then
         layout%rival_factor(wanted) = value
      end if
   end subroutine read_rival_unit

   !> True if a heading is the one that was asked for, less strictly from attempt to attempt.
   pure function is_alike(heading, asked, attempt) result(alike)
      type(heading_type), intent(in) :: heading, asked
      integer, intent(in) :: attempt
      logical :: alike
      character(*), parameter :: marks = '"_'
      select case (attempt)
      case (1)
         alike = heading%text == asked%text
      case (2)
         alike = squeezed(heading%text, marks) == squeezed(asked%text, marks)
      case default
         alike = heading%name == asked%name .and. heading%name /= '' .and. (asked%unit == '' .or. asked%unit == heading%unit)
      end select
   end function is_alike

   pure function nearest_heading(name, headings) result(advice)
      character(*), intent(in) :: name
      type(heading_type), intent(in) :: headings(:)
      character(:), allocatable :: advice
      character(48) :: candidates(size(headings))
      integer :: i
      do i = 1, size(headings)
         candidates(i) = headings(i)%text
      end do
      advice = nearest_name(name, candidates)
      if (advice /= '') advice = ". Did you mean '"//advice//"'?"
   end function nearest_heading

   !> Set the unit of a column, if the text names one ('MD (RKB)' does not). An unknown unit, or one that contradicts an
   !> earlier one, is kept for a fault if the column is needed. A position in such a unit is not compared.
   pure subroutine set_unit(layout, column, name)
      type(layout_type), intent(inout) :: layout
      integer, intent(in) :: column
      character(*), intent(in) :: name
      real(wp) :: value
      logical :: known
      call read_unit(name, column == column_inc .or. column == column_azi, value, known)
      if (.not. known) then
         if (column > column_azi) layout%place(column) = 0
         if (column <= column_azi .and. layout%foreign == '') layout%foreign = trim(column_name(column))//' in '//quoted(name)// &
            '; a heading may name m, ft or usft, deg or rad: convert other units'
      else if (value > 0.0_wp) then
         if (layout%told(column) .and. abs(value - layout%factor(column)) > 0.0_wp) then
            if (column > column_azi) then
               layout%place(column) = 0
            else if (layout%foreign == '') then
               layout%foreign = trim(column_name(column))//' in '//quoted(name)// &
                                ', but its heading or another row names another unit'
            end if
         end if
         layout%factor(column) = value
         layout%told(column) = .true.
      end if
   end subroutine set_unit

   !> 'Headings seen: 'Foo', 'Inc'.'
   pure function seen_headings(headings) result(words)
      type(heading_type), intent(in) :: headings(:)
      character(:), allocatable :: words
      integer, parameter :: most = 24
      integer :: i
      words = 'Headings seen: '
      do i = 1, min(size(headings), most)
         if (i > 1) words = words//', '
         words = words//quoted(headings(i)%text)
      end do
      if (size(headings) > most) words = words//' and more'
   end function seen_headings

   !> Missing columns among md, inc (and azi where `with_azimuth`), headings that were found and are known, and keys that name them.
   pure function missing_columns(layout, with_azimuth) result(words)
      type(layout_type), intent(in) :: layout
      logical, intent(in) :: with_azimuth
      character(:), allocatable :: words
      character(:), allocatable :: known, keys
      integer :: column
      words = 'the header names no '
      known = ''
      keys = ''
      do column = 1, merge(column_azi, column_inc, with_azimuth)
         if (layout%place(column) /= 0) cycle
         if (known /= '') words = words//' and no '
         words = words//trim(column_name(column))
         known = known//'. Known for '//trim(column_name(column))//': '//trim(known_names(column))
         if (keys /= '') keys = keys//' and '
         keys = keys//trim(column_name(column))//'_column'
      end do
      if (all([(is_number(layout%headings(column)%text), column=1, size(layout%headings))])) then
         words = words//', it holds numbers. Write a line with the names of the columns above it, as MD'//layout%separator// &
                 'Inc'//layout%separator//'Azi'
         return
      end if
      words = words//'. '//seen_headings(layout%headings)//known//'. Or name the column in &trajectory by '//keys// &
              ', with its heading as it stands in the file'
   end function missing_columns

   !> Columns that are read, with their units: md from column 'Measured Depth' [ft], inc from 'Inclination' [deg].
   pure function taken_columns(layout) result(words)
      type(layout_type), intent(in) :: layout    !< with md, inc, azi
      character(:), allocatable :: words
      integer :: column
      words = ''
      do column = column_md, column_azi
         if (column > column_md) words = words//','
         words = words//' '//trim(column_name(column))//' from '
         if (column == column_md) words = words//'column '
         words = words//quoted(layout%headings(layout%place(column))%text)//' ['// &
                 unit_name(layout%factor(column), column /= column_md)//']'
      end do
   end function taken_columns

   !> Name of a unit of depths or angles.
   pure function unit_name(value, angle) result(name)
      real(wp), intent(in) :: value              !< [m or rad]
      logical, intent(in) :: angle
      character(:), allocatable :: name
      real(wp), parameter :: round_off = 1.0e-9_wp
      if (angle) then
         name = 'deg'
         if (abs(value - degree) > round_off) name = to_text(value/degree, 6)//' deg'
      else if (abs(value - foot) <= round_off) then
         name = 'ft'
      else if (abs(value - survey_foot) <= round_off) then
         name = 'US ft'
      else
         name = 'm'
         if (abs(value - 1.0_wp) > round_off) name = to_text(value, 7)//' m'
      end if
   end function unit_name
end module dg_survey_columns

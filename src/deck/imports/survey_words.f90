!> Words in the headings of survey tables, and the part that each plays.
module dg_survey_words
   use dg_table_unit, only: resembles_unit
   use dg_text, only: append_text, lower_case, text_type
   implicit none
   private
   public :: words_of, role_of
   public :: role_unknown, role_md, role_depth, role_measured, role_along, role_total, role_inc, role_drift, role_angle, &
             role_azi, role_direction, role_tvd, role_vertical, role_true, role_grid, role_corrected, role_magnetic, role_datum, &
             role_sea, role_station, role_neutral, role_plan, role_north, role_east, role_letter, role_map, role_minutes, &
             role_other, role_unit, role_axis

   !> Parts of a word in a heading.
   enum, bind(c)
      enumerator :: role_unknown = 0
      enumerator :: role_md          !< measured depth by itself
      enumerator :: role_depth       !< a depth, which one is open
      enumerator :: role_measured    !< measured
      enumerator :: role_along       !< along the hole
      enumerator :: role_total       !< depth of the hole, not of the station
      enumerator :: role_inc         !< inclination
      enumerator :: role_drift       !< inclination; beside a direction a part of its name
      enumerator :: role_angle       !< an angle, which one is open
      enumerator :: role_azi         !< azimuth
      enumerator :: role_direction   !< azimuth by a looser name
      enumerator :: role_tvd         !< true vertical depth
      enumerator :: role_vertical    !< vertical
      enumerator :: role_true        !< true north, or a true depth
      enumerator :: role_grid        !< grid north
      enumerator :: role_corrected   !< corrected, final
      enumerator :: role_magnetic    !< magnetic, raw
      enumerator :: role_datum       !< from where a depth counts
      enumerator :: role_sea         !< from sea level
      enumerator :: role_station     !< of a station
      enumerator :: role_neutral     !< says nothing of the quantity
      enumerator :: role_plan        !< planned, not measured
      enumerator :: role_north       !< position to the north
      enumerator :: role_east        !< position to the east
      enumerator :: role_letter      !< n, s, e, w, t, g
      enumerator :: role_map         !< a map coordinate
      enumerator :: role_axis        !< dx, dy
      enumerator :: role_minutes     !< minutes of arc
      enumerator :: role_other       !< of another quantity
      enumerator :: role_unit        !< a unit
   end enum

   integer, parameter :: longest = 14
   character(longest), parameter :: md_words(*) = [character(longest) :: 'md', 'ahd', 'dmea', 'mdepth', 'mdpth', &
      'mdept', 'messtiefe', 'messteufe', 'bohrteufe']
   character(longest), parameter :: depth_words(*) = [character(longest) :: 'depth', 'dept', 'dpth', 'depths', &
      'tdep', 'teufe', 'tiefe', 'diepte', 'dybde', 'dyp', 'profondeur', 'profundidad', 'profundidade', 'prof']
   character(longest), parameter :: measured_words(*) = [character(longest) :: 'measured', 'meas', 'measd', 'msd', &
      'mesd', 'gemessene', 'gemeten', 'malt', 'maalt', 'mesuree', 'medida', 'measure']
   character(longest), parameter :: along_words(*) = [character(longest) :: 'along', 'ah']
   character(longest), parameter :: total_words(*) = [character(longest) :: 'total', 'drilled', 'drillers', &
      'driller', 'drill', 'log', 'logged', 'loggers', 'logger']
   character(longest), parameter :: inc_words(*) = [character(longest) :: 'inc', 'incl', 'inclination', 'inclin', &
      'incli', 'incln', 'inclinations', 'inclinaison', 'inclinacion', 'inclinacao', 'inklination', 'inklinasjon', &
      'inklin', 'inclinatie', 'neigung', 'hdev', 'helning', 'inclinazione', 'incs']
   character(longest), parameter :: drift_words(*) = [character(longest) :: 'deviation', 'dev', 'devi', 'devn', &
      'deviatie', 'deviasjon', 'avvik', 'drift', 'deviations', 'devia']
   character(longest), parameter :: angle_words(*) = [character(longest) :: 'angle', 'ang', 'angles', 'winkel']
   character(longest), parameter :: azi_words(*) = [character(longest) :: 'azi', 'azim', 'azm', 'az', 'azimuth', &
      'azimut', 'acimut', 'azimute', 'asimut', 'hazi', 'haz', 'hazim', 'azmth', 'azmuth', 'azimth', 'azth', &
      'azimuths', 'azmt', 'azt', 'azmut', 'azis', 'dazi']
   character(longest), parameter :: direction_words(*) = [character(longest) :: 'bearing', 'brg', 'direction', &
      'dir', 'dirn', 'retning', 'richting', 'richtung', 'direccion', 'heading']
   character(longest), parameter :: tvd_words(*) = [character(longest) :: 'tvd', 'tv', 'vd', 'vdepth', 'tvdepth', &
      'tvert', 'tvds', 'tvdr']
   character(longest), parameter :: vertical_words(*) = [character(longest) :: 'vertical', 'vert', 'verticale', &
      'vertikal', 'verticaal']
   character(longest), parameter :: true_words(*) = [character(longest) :: 'true', 'tn', 'tnorth', 'geographic', &
      'geodetic', 'truenorth']
   character(longest), parameter :: grid_words(*) = [character(longest) :: 'grid', 'gn', 'gnorth', 'gridnorth', &
      'grd']
   character(longest), parameter :: corrected_words(*) = [character(longest) :: 'corrected', 'corr', 'cor', &
      'final', 'definitive', 'crt', 'corrd', 'adjusted', 'sag']
   character(longest), parameter :: magnetic_words(*) = [character(longest) :: 'magnetic', 'mag', 'mn', 'magn', &
      'raw', 'uncorrected', 'uncorr', 'unc', 'observed']
   character(longest), parameter :: datum_words(*) = [character(longest) :: 'rkb', 'kb', 'rt', 'brt', 'bkb', &
      'brkb', 'df', 'bdf', 'gl', 'bgl', 'rte', 'kbe', 'dfe', 'gle', 'rotary', 'kelly']
   character(longest), parameter :: sea_words(*) = [character(longest) :: 'subsea', 'ss', 'msl', 'sea', 'tvdss', &
      'sstvd', 'bmsl', 'amsl', 'elevation']
   character(longest), parameter :: station_words(*) = [character(longest) :: 'survey', 'station', 'svy', 'surv', &
      'stn', 'sta', 'point', 'pt', 'sensor', 'surveyed', 'actual', 'act', 'surveys']
   character(longest), parameter :: neutral_words(*) = [character(longest) :: 'hole', 'well', 'wellbore', &
      'borehole', 'bore', 'of', 'from', 'the', 'at', 'value', 'val', 'qty', 'below', 'to', 'table', 'bushing', &
      'floor', 'rig', 'gyro', 'mwd', 'computed', 'compass', 'calc', 'calculated', 'path', 'directional']
   character(longest), parameter :: plan_words(*) = [character(longest) :: 'plan', 'planned', 'proposed', 'design', &
      'proposal', 'pln']
   character(longest), parameter :: north_words(*) = [character(longest) :: 'north', 'ns', 'south', 'nord', &
      'norte', 'noord']
   character(longest), parameter :: east_words(*) = [character(longest) :: 'east', 'ew', 'west', 'ost', 'este', &
      'oost']
   character(longest), parameter :: map_words(*) = [character(longest) :: 'northing', 'northings', 'easting', &
      'eastings']
   character(longest), parameter :: axis_words(*) = [character(longest) :: 'dx', 'dy']
   character(1), parameter :: letters(8) = ['n', 's', 'e', 'w', 't', 'g', 'x', 'y']
   character(longest), parameter :: minute_words(*) = [character(longest) :: 'min', 'mins', 'minute', 'minutes', &
      'quadrant']
   !> Words of other columns: a line of such words may be a part of the header.
   character(longest), parameter :: other_words(*) = [character(longest) :: 'dls', 'dogleg', 'doglegs', 'dog', &
      'leg', 'build', 'turn', 'walk', 'rate', 'section', 'vsec', 'vs', 'vsect', 'closure', 'clos', 'course', &
      'length', 'displacement', 'displ', 'disp', 'departure', 'dep', 'distance', 'dist', 'offset', 'offsets', &
      'local', 'coordinates', 'coordinate', 'coord', 'coords', 'map', 'latitude', 'longitude', 'lat', 'long', &
      'lon', 'rectangular', 'toolface', 'tool', 'face', 'tf', 'gtf', 'mtf', 'hs', 'type', 'comment', 'comments', &
      'remarks', 'name', 'date', 'time', 'error', 'dip', 'temp', 'temperature', 'declination', 'convergence', &
      'source', 'uwi', 'api', 'no', 'number', 'id', 'index', 'br', 'tr', 'bur', 'severity', 'target', 'horizontal', &
      'horiz', 'bit', 'annotation', 'severities', 'radius']
   character(longest), parameter :: unit_words(*) = [character(longest) :: 'ft', 'usft', 'feet', 'foot', 'metres', &
      'meters', 'metre', 'meter', 'deg', 'degs', 'degree', 'degrees', 'rad', 'radians', 'ftkb', 'mrkb']
   character(longest), parameter :: all_words(*) = [md_words, depth_words, measured_words, along_words, total_words, inc_words, &
      drift_words, angle_words, azi_words, direction_words, tvd_words, vertical_words, true_words, grid_words, corrected_words, &
      magnetic_words, datum_words, sea_words, station_words, neutral_words, plan_words, north_words, east_words, map_words, &
      axis_words, minute_words, other_words, unit_words]

contains

   !> The words of a heading in small letters: 'DEVIATION_ANGLE' gives deviation and angle, 'AzimuthTN' azimuth and tn.
   pure subroutine words_of(heading, words)
      character(*), intent(in) :: heading
      type(text_type), allocatable, intent(out) :: words(:)
      character(*), parameter :: alphanumeric = 'abcdefghijklmnopqrstuvwxyz0123456789%'
      character(:), allocatable :: plain
      integer :: first, last
      allocate (words(0))
      plain = plain_letters(heading)
      first = 1
      do while (first <= len(plain))
         last = first
         do while (last <= len(plain))
            if (scan(plain(last:last), alphanumeric) == 0 .and. iachar(plain(last:last)) < 128) exit
            last = last + 1
         end do
         if (last > first) call add_word(plain(first:last - 1), words)
         first = last + 1
      end do
      call join_letters(words)
   end subroutine words_of

   !> Joins letters that are written one by one: M.D. and T.V.D.
   pure subroutine join_letters(words)
      type(text_type), allocatable, intent(inout) :: words(:)
      character(*), parameter :: known(3) = [character(3) :: 'md', 'tvd', 'ahd']
      type(text_type), allocatable :: joined(:)
      character(:), allocatable :: letters
      integer :: i
      letters = ''
      do i = 1, size(words)
         if (len(words(i)%text) > 1) exit
         letters = letters//words(i)%text
      end do
      if (.not. any(known == letters)) return
      allocate (joined(0))
      call append_text(joined, letters)
      do i = len(letters) + 1, size(words)
         call append_text(joined, words(i)%text)
      end do
      call move_alloc(joined, words)
   end subroutine join_letters

   !> Adds a word, or the words that it is written together from.
   pure subroutine add_word(word, words)
      character(*), intent(in) :: word
      type(text_type), allocatable, intent(inout) :: words(:)
      integer :: cut(0:len(word))     ! where the last word of what ends here begins; 0: no words end here
      integer :: i, k, length, first
      cut = 0
      if (role_of(word) == role_unknown .and. len(word) <= 3*longest) then
         cut(0) = 1
         do i = 2, len(word)
            do k = 1, size(all_words)
               length = len_trim(all_words(k))
               if (length > i) cycle
               if (cut(i - length) == 0 .or. word(i - length + 1:i) /= all_words(k)(:length)) cycle
               if (cut(i) == 0 .or. i - length + 1 < cut(i)) cut(i) = i - length + 1
            end do
         end do
         cut(0) = 0
      end if
      if (cut(len(word)) <= 1) then
         call append_text(words, word)
         return
      end if
      first = cut(len(word))
      call add_parts(word(:first - 1), cut(0:first - 1), words)
      call append_text(words, word(first:))
   end subroutine add_word

   !> Adds the words of which the letters before a cut are made.
   pure recursive subroutine add_parts(letters_before, cut, words)
      character(*), intent(in) :: letters_before
      integer, intent(in) :: cut(0:)
      type(text_type), allocatable, intent(inout) :: words(:)
      integer :: first
      first = cut(len(letters_before))
      if (first > 1) call add_parts(letters_before(:first - 1), cut(0:first - 1), words)
      call append_text(words, letters_before(max(first, 1):))
   end subroutine add_parts

   !> The part that a word in small letters plays.
   pure function role_of(word) result(role)
      character(*), intent(in) :: word
      integer :: role
      role = role_unknown
      if (any(md_words == word)) role = role_md
      if (any(depth_words == word)) role = role_depth
      if (any(measured_words == word)) role = role_measured
      if (any(along_words == word)) role = role_along
      if (any(total_words == word)) role = role_total
      if (any(inc_words == word)) role = role_inc
      if (any(drift_words == word)) role = role_drift
      if (any(angle_words == word)) role = role_angle
      if (any(azi_words == word)) role = role_azi
      if (any(direction_words == word)) role = role_direction
      if (any(tvd_words == word)) role = role_tvd
      if (any(vertical_words == word)) role = role_vertical
      if (any(true_words == word)) role = role_true
      if (any(grid_words == word)) role = role_grid
      if (any(corrected_words == word)) role = role_corrected
      if (any(magnetic_words == word)) role = role_magnetic
      if (any(datum_words == word)) role = role_datum
      if (any(sea_words == word)) role = role_sea
      if (any(station_words == word)) role = role_station
      if (any(neutral_words == word)) role = role_neutral
      if (any(plan_words == word)) role = role_plan
      if (any(north_words == word)) role = role_north
      if (any(east_words == word)) role = role_east
      if (any(map_words == word)) role = role_map
      if (any(axis_words == word)) role = role_axis
      if (any(minute_words == word)) role = role_minutes
      if (any(other_words == word)) role = role_other
      if (any(letters == word)) role = role_letter
      if (role /= role_unknown) return
      if (any(unit_words == word) .or. resembles_unit(word, .false.) .or. resembles_unit(word, .true.)) role = role_unit
   end function role_of

   !> Small letters without accents; a degree sign is the word for it. UTF-8 or Latin 1.
   pure function plain_letters(text) result(plain)
      character(*), intent(in) :: text
      character(:), allocatable :: plain
      !> Letters of Latin 1 from A with grave accent on; ? where there is none.
      character(*), parameter :: bases = 'aaaaaaaceeeeiiiidnooooo?ouuuuyts'
      character(len(text)*5) :: buffer
      integer :: i, code, n
      buffer = ''
      n = 0
      i = 0
      do while (i < len(text))
         i = i + 1
         code = iachar(text(i:i))
         if (code == 194 .and. i < len(text)) then
            i = i + 1
            code = iachar(text(i:i))
         else if (code == 195 .and. i < len(text)) then
            i = i + 1
            code = iachar(text(i:i)) + 64
         end if
         if (code == 176 .or. code == 186) then
            buffer(n + 1:n + 5) = ' deg '
            n = n + 5
         else if (code >= 192 .and. code <= 255) then
            n = n + 1
            buffer(n:n) = bases(mod(code, 32) + 1:mod(code, 32) + 1)
         else if (code == 160) then
            n = n + 1
         else
            n = n + 1
            buffer(n:n) = lower_case(text(i:i))
         end if
      end do
      plain = buffer(:n)
   end function plain_letters
end module dg_survey_words

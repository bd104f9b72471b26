!> Words in the headings of survey tables, and the part that each plays.
module dg_survey_words
   use dg_table_unit, only: plain_letters, resembles_unit
   use dg_text, only: append_text, text_type
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

   integer, parameter :: longest = 14      ! letters of a word

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
      character(:), allocatable :: letters
      integer :: i
      letters = ''
      do i = 1, size(words)
         if (len(words(i)%text) > 1) exit
         letters = letters//words(i)%text
      end do
      if (.not. any(known == letters)) return
      words(len(letters))%text = letters
      words = words(len(letters):)
   end subroutine join_letters

   !> Adds a word, or the words that it is written together from.
   pure subroutine add_word(word, words)
      character(*), intent(in) :: word
      type(text_type), allocatable, intent(inout) :: words(:)
      integer :: cut(0:len(word))     ! where the last word of what ends here begins; 0: no words end here
      integer, allocatable :: starts(:)
      integer :: i, first
      cut = 0
      if (role_of(word) == role_unknown .and. len(word) <= 3*longest) then
         do i = 2, len(word)
            do first = max(1, i - longest + 1), i - 1
               if (first > 1) then
                  if (cut(first - 1) == 0) cycle
               end if
               if (listed_role(word(first:i)) == role_unknown) cycle
               cut(i) = first
               exit
            end do
         end do
      end if
      allocate (starts(1), source=len(word) + 1)
      do while (starts(1) > 1)
         starts = [max(cut(starts(1) - 1), 1), starts]
      end do
      do i = 1, size(starts) - 1
         call append_text(words, word(starts(i):starts(i + 1) - 1))
      end do
   end subroutine add_word

   !> The part that a word in small letters plays.
   pure function role_of(word) result(role)
      character(*), intent(in) :: word
      integer :: role
      role = listed_role(word)
      if (role /= role_unknown) return
      if (resembles_unit(word, .false.) .or. resembles_unit(word, .true.)) role = role_unit
   end function role_of

   !> The part of a word that is listed here.
   pure function listed_role(word) result(role)
      character(*), intent(in) :: word
      integer :: role
      select case (word)
      case ('md', 'ahd', 'dmea', 'mdepth', 'mdpth', 'mdept', 'messtiefe', 'messteufe', 'bohrteufe')
         role = role_md
      case ('depth', 'dept', 'dpth', 'depths', 'tdep', 'teufe', 'tiefe', 'diepte', 'dybde', 'dyp', 'profondeur', &
            'profundidad', 'profundidade', 'prof')
         role = role_depth
      case ('measured', 'meas', 'measd', 'msd', 'mesd', 'gemessene', 'gemeten', 'malt', 'maalt', 'mesuree', &
            'medida', 'measure')
         role = role_measured
      case ('along', 'ah')
         role = role_along
      case ('total', 'drilled', 'drillers', 'driller', 'drill', 'log', 'logged', 'loggers', 'logger')
         role = role_total
      case ('inc', 'incl', 'inclination', 'inclin', 'incli', 'incln', 'inclinations', 'inclinaison', 'inclinacion', &
            'inclinacao', 'inklination', 'inklinasjon', 'inklin', 'inclinatie', 'neigung', 'hdev', 'helning', &
            'inclinazione', 'incs')
         role = role_inc
      case ('deviation', 'dev', 'devi', 'devn', 'deviatie', 'deviasjon', 'avvik', 'drift', 'deviations', 'devia')
         role = role_drift
      case ('angle', 'ang', 'angles', 'winkel')
         role = role_angle
      case ('azi', 'azim', 'azm', 'az', 'azimuth', 'azimut', 'acimut', 'azimute', 'asimut', 'hazi', 'haz', 'hazim', &
            'azmth', 'azmuth', 'azimth', 'azth', 'azimuths', 'azmt', 'azt', 'azmut', 'azis', 'dazi')
         role = role_azi
      case ('bearing', 'brg', 'direction', 'dir', 'dirn', 'retning', 'richting', 'richtung', 'direccion', 'heading')
         role = role_direction
      case ('tvd', 'tv', 'vd', 'vdepth', 'tvdepth', 'tvert', 'tvds', 'tvdr')
         role = role_tvd
      case ('vertical', 'vert', 'verticale', 'vertikal', 'verticaal')
         role = role_vertical
      case ('true', 'tn', 'tnorth', 'geographic', 'geodetic', 'truenorth')
         role = role_true
      case ('grid', 'gn', 'gnorth', 'gridnorth', 'grd')
         role = role_grid
      case ('corrected', 'corr', 'cor', 'final', 'definitive', 'crt', 'corrd', 'adjusted', 'sag')
         role = role_corrected
      case ('magnetic', 'mag', 'mn', 'magn', 'raw', 'uncorrected', 'uncorr', 'unc', 'observed')
         role = role_magnetic
      case ('rkb', 'kb', 'rt', 'brt', 'bkb', 'brkb', 'df', 'bdf', 'gl', 'bgl', 'rte', 'kbe', 'dfe', 'gle', &
            'rotary', 'kelly')
         role = role_datum
      case ('subsea', 'ss', 'msl', 'sea', 'tvdss', 'sstvd', 'bmsl', 'amsl', 'elevation')
         role = role_sea
      case ('survey', 'station', 'svy', 'surv', 'stn', 'sta', 'point', 'pt', 'sensor', 'surveyed', 'actual', 'act', &
            'surveys')
         role = role_station
      case ('hole', 'well', 'wellbore', 'borehole', 'bore', 'of', 'from', 'the', 'at', 'value', 'val', 'qty', &
            'below', 'to', 'table', 'bushing', 'floor', 'rig', 'gyro', 'mwd', 'computed', 'compass', 'calc', &
            'calculated', 'path', 'directional')
         role = role_neutral
      case ('plan', 'planned', 'proposed', 'design', 'proposal', 'pln')
         role = role_plan
      case ('north', 'ns', 'south', 'nord', 'norte', 'noord')
         role = role_north
      case ('east', 'ew', 'west', 'ost', 'este', 'oost')
         role = role_east
      case ('n', 's', 'e', 'w', 't', 'g', 'x', 'y')
         role = role_letter
      case ('northing', 'northings', 'easting', 'eastings')
         role = role_map
      case ('dx', 'dy')
         role = role_axis
      case ('min', 'mins', 'minute', 'minutes', 'quadrant')
         role = role_minutes
      case ('dls', 'dogleg', 'doglegs', 'dog', 'leg', 'build', 'turn', 'walk', 'rate', 'section', 'vsec', 'vs', &
            'vsect', 'closure', 'clos', 'course', 'length', 'displacement', 'displ', 'disp', 'departure', 'dep', &
            'distance', 'dist', 'offset', 'offsets', 'local', 'coordinates', 'coordinate', 'coord', 'coords', &
            'map', 'latitude', 'longitude', 'lat', 'long', 'lon', 'rectangular', 'toolface', 'tool', 'face', 'tf', &
            'gtf', 'mtf', 'hs', 'type', 'comment', 'comments', 'remarks', 'name', 'date', 'time', 'error', 'dip', &
            'temp', 'temperature', 'declination', 'convergence', 'source', 'uwi', 'api', 'no', 'number', 'id', &
            'index', 'br', 'tr', 'bur', 'severity', 'target', 'horizontal', 'horiz', 'bit', 'annotation', &
            'severities', 'radius')
         role = role_other
      case ('ft', 'usft', 'feet', 'foot', 'metres', 'meters', 'metre', 'meter', 'deg', 'degs', 'degree', 'degrees', &
            'rad', 'radians', 'ftkb', 'mrkb')
         role = role_unit
      case default
         role = role_unknown
      end select
   end function listed_role
end module dg_survey_words

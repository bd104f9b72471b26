!> Units in their usual spellings beside the name of a column: 'ft', '(ftKB)', '[m RKB]', 'deg TN', a degree sign.
module dg_table_unit
   use dg_kinds, only: wp
   use dg_constants, only: degree, foot, survey_foot
   use dg_text, only: lower_case
   implicit none
   private
   public :: plain_letters, read_unit, resembles_unit

   !> From where depths count. Said beside a unit, written on to it, or alone; no unit.
   character(*), parameter :: datums(26) = [character(5) :: 'rkb', 'kb', 'rt', 'brt', 'bkb', 'brkb', 'df', 'bdf', 'gl', 'bgl', &
      'gr', 'msl', 'amsl', 'bmsl', 'sl', 'ss', 'rte', 'kbe', 'dfe', 'gle', 'lat', 'md', 'ah', 'ahd', 'ref', 'datum']
   !> The same in words.
   character(*), parameter :: datum_words(19) = [character(7) :: 'from', 'below', 'above', 'to', 'the', 'rotary', 'table', &
      'kelly', 'bushing', 'drill', 'rig', 'floor', 'derrick', 'ground', 'level', 'mean', 'sea', 'along', 'hole']
   !> From which north azimuths count. The letters are taken for it only beside a unit: alone, g stands for gons.
   character(*), parameter :: norths(8) = [character(8) :: 'tn', 'gn', 'mn', 'true', 'grid', 'magnetic', 'mag', 'north']
   character(*), parameter :: north_letters(3) = ['n', 't', 'g']
   !> Beginnings of a word that goes on with a datum or a north: 'ftkb', 'mrt', 'degtn'.
   character(*), parameter :: stems(9) = [character(6) :: 'usft', 'feet', 'ft', 'metres', 'meters', 'metre', 'meter', 'm', 'deg']
   !> Units that are not converted here but tell that a row is one of units.
   character(*), parameter :: other_lengths(17) = [character(7) :: 'km', 'hm', 'dm', 'cm', 'mm', 'in', 'inch', 'inches', 'yd', &
      'yard', 'yards', 'mi', 'mile', 'miles', 'fathom', 'kft', '0.1in']
   character(*), parameter :: other_angles(18) = [character(7) :: 'g', 'gon', 'gons', 'grad', 'grads', 'grade', 'grades', 'dms', &
      'turn', 'turns', 'rev', 'mrad', 'mil', 'mils', '%', 'pct', 'percent', 'permil']

contains

   !> Unit of a column by a text: its SI value [m or rad], 0 if the text names no unit. A datum or a north beside it is
   !> ignored. Any other text is not `known`: ignored, it would make correct numbers wrong.
   pure subroutine read_unit(text, angle, value, known)
      character(*), intent(in) :: text
      logical, intent(in) :: angle     !< .true. for a column of angles, else lengths are looked for
      real(wp), intent(out) :: value
      logical, intent(out) :: known
      character(:), allocatable :: plain, word
      real(wp) :: found
      logical :: of_surveys, letters
      integer :: first, last, k
      plain = plain_words(text)
      value = 0.0_wp
      known = .true.
      of_surveys = .false.
      letters = .false.
      first = 1
      do while (first <= len(plain))
         last = first + index(plain(first:)//' ', ' ') - 2
         word = plain(first:last)
         first = last + 2
         if (word == '') cycle
         found = unit_of(word, angle)
         do k = 1, size(stems)
            if (found > 0.0_wp .or. is_datum(word, angle)) exit
            if (index(word, trim(stems(k))) /= 1) cycle
            if (is_tail(word(len_trim(stems(k)) + 1:), angle)) found = unit_of(trim(stems(k)), angle)
         end do
         if (found > 0.0_wp) then
            if (value > 0.0_wp .and. abs(found - value) > 0.0_wp) known = .false.      ! two units are none
            value = found
         else if (.not. angle .and. any(word == [character(6) :: 'us', 'survey'])) then
            of_surveys = .true.
         else if (angle .and. any(north_letters == word)) then
            letters = .true.
         else if (.not. is_datum(word, angle)) then
            known = .false.
         end if
      end do
      if (of_surveys) then
         if (abs(value - foot) > 0.0_wp .and. abs(value - survey_foot) > 0.0_wp) known = .false.
         value = survey_foot
      end if
      if (letters .and. value <= 0.0_wp) known = .false.
      if (.not. known) value = 0.0_wp
   end subroutine read_unit

   !> True if a cell looks like a unit for such a column, one that is converted here or not. It is in brackets, or known by name.
   pure function resembles_unit(cell, angle) result(is)
      character(*), intent(in) :: cell
      logical, intent(in) :: angle
      logical :: is
      character(:), allocatable :: plain
      real(wp) :: value
      logical :: known
      is = .false.
      if (len_trim(cell) == 0) return
      call read_unit(cell, angle, value, known)
      plain = trim(adjustl(lower_case(cell)))
      is = value > 0.0_wp .or. (scan(plain(1:1), '([') == 1 .and. scan(plain, ')]', back=.true.) == len(plain))
      if (angle) is = is .or. any(other_angles == trim(plain_words(cell)))
      if (.not. angle) is = is .or. any(other_lengths == trim(plain_words(cell)))
   end function resembles_unit

   !> Small letters with blanks for brackets and marks; a degree sign is the word for it.
   pure function plain_words(text) result(plain)
      character(*), intent(in) :: text
      character(:), allocatable :: plain
      character(*), parameter :: marks = '()[]{}<>,;:_-/'//achar(9)   ! no quotes: those are feet and inches
      integer :: i
      plain = plain_letters(text)//' '
      do i = 1, len(plain) - 1
         if (plain(i:i) == '.' .and. scan(plain(i + 1:i + 1), ' )]') == 1) plain(i:i) = ' '     ! 'deg.', 'ft.)'
         if (scan(plain(i:i), marks) == 1) plain(i:i) = ' '
      end do
      plain = trim(adjustl(plain))
   end function plain_words

   !> Small letters without accents; a degree sign is the word for it. UTF-8 or Latin 1.
   pure function plain_letters(text) result(plain)
      character(*), intent(in) :: text
      character(:), allocatable :: plain
      !> Letters of Latin 1 from A with grave accent on; ? where there is none.
      character(*), parameter :: bases = 'aaaaaaaceeeeiiiidnooooo?ouuuuyts'
      character(*), parameter :: ring = char(203)//char(154)     ! above, used for degrees
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
         if (code == 203 .and. index(text(i:), ring) == 1) then
            i = i + 1
            code = 176
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
   !> SI value of a unit by its name in small letters [m or rad]; 0 where it is none that is converted.
   pure function unit_of(name, angle) result(value)
      character(*), intent(in) :: name
      logical, intent(in) :: angle
      real(wp) :: value
      value = 0.0_wp
      if (angle) then
         select case (name)
         case ('deg', 'degs', 'degree', 'degrees', 'dega'); value = degree
         case ('rad', 'rads', 'radian', 'radians'); value = 1.0_wp
         case default
         end select
      else
         select case (name)
         case ('ft', 'f', 'feet', 'foot', ''''); value = foot
         case ('usft', 'ftus'); value = survey_foot
         case ('m', 'meter', 'metre', 'meters', 'metres'); value = 1.0_wp
         case default
         end select
      end if
   end function unit_of

   !> True if a word names the datum of a depth, or the north of an azimuth.
   pure function is_datum(word, angle) result(is)
      character(*), intent(in) :: word
      logical, intent(in) :: angle
      logical :: is
      if (angle) then
         is = any(norths == word)
      else
         is = any(datum_words == word) .or. is_tail(word, angle)
      end if
   end function is_datum

   !> True if the end of a word is one or two words of a datum: 'mdrkb' in 'mmdrkb', 'n' in 'degn'.
   pure function is_tail(rest, angle) result(is)
      character(*), intent(in) :: rest
      logical, intent(in) :: angle
      logical :: is
      integer :: cut
      if (angle) then
         is = any(norths == rest) .or. any(north_letters == rest)
         return
      end if
      is = any(datums == rest)
      do cut = 1, len(rest) - 1
         is = is .or. (any(datums == rest(:cut)) .and. any(datums == rest(cut + 1:)))
      end do
   end function is_tail
end module dg_table_unit

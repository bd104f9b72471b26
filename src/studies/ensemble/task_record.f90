!> The record of work that is split into numbered pieces: a description of the work, the part of this record, and finished
!> pieces.
!>
!> A record is text, written while the work goes on. An interrupted run can be continued with it, and the parts of a divided
!> one joined. Its settings contain all that the work depends on. Pieces of other work are therefore never taken for its own,
!> and differences can be named. Layout:
!> - drillgap record, format 1
!> - part 2 of 4 (1 of 1: undivided)
!> - pieces 1488 (of all parts together)
!> - settings 57 (that many lines `key = value` follow)
!> - NUMBER TEXT ; (one line a piece; without its end mark a line was cut short and does not count)
module dg_task_record
   use dg_text, only: quoted, text_type, to_text
   use dg_units, only: unit_system_type
   use dg_kinds, only: wp
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: key_rule_type, rule_place
   use dg_unit_kind, only: unit_angle, unit_factor, unit_label, unit_length, unit_none, unit_rotation, unit_speed
   implicit none
   private
   public :: record_type, record_head, record_line, read_record, difference_of, part_text, solver_key, told

   type :: record_type
      integer :: part = 1
      integer :: parts = 1
      integer :: pieces = 0                        !< of all parts together
      type(text_type), allocatable :: settings(:)  !< `key = value`
      integer, allocatable :: numbers(:)           !< of the pieces that are done, in the order of the file
      type(text_type), allocatable :: texts(:)     !< what is known of each
      integer, allocatable :: places(:)            !< the line of each in the file
   end type record_type

   character(*), parameter :: title = 'drillgap record, format 1'
   character(*), parameter :: end_mark = ' ;'
   integer, parameter :: head_lines = 4
   character(*), parameter :: equals = ' = '
   !> Setting that holds all of the solver. Another one there still gives a solution of the same work.
   character(*), parameter :: solver_key = 'solver settings'
   !> Largest plausible number of pieces. A larger one is a damaged head, and would only take memory.
   integer, parameter :: most_pieces = 10000000
   !> Longest value that a message repeats.
   integer, parameter :: longest_shown = 60

   !> Digits of a number in another unit than that of the record: its round-off is not shown.
   integer, parameter :: digits = 8

contains

   !> The lines of a record before its first piece.
   pure function record_head(part, parts, pieces, settings) result(lines)
      integer, intent(in) :: part, parts, pieces
      type(text_type), intent(in) :: settings(:)
      type(text_type), allocatable :: lines(:)
      integer :: i
      allocate (lines(head_lines + size(settings)))
      lines(1)%text = title
      lines(2)%text = part_text(part, parts)
      lines(3)%text = 'pieces '//to_text(pieces)
      lines(4)%text = 'settings '//to_text(size(settings))
      do i = 1, size(settings)
         lines(head_lines + i)%text = settings(i)%text
      end do
   end function record_head

   !> Text on a part in a record's head, as 'part 3 of 40'.
   pure function part_text(part, parts) result(text)
      integer, intent(in) :: part, parts
      character(:), allocatable :: text
      text = 'part '//to_text(part)//' of '//to_text(parts)
   end function part_text

   !> The line of one piece.
   pure function record_line(number, text) result(line)
      integer, intent(in) :: number
      character(*), intent(in) :: text     !< one line
      character(:), allocatable :: line
      line = to_text(number)//' '//text//end_mark
   end function record_line

   !> Reads the lines of a record. `failure` is '' or says what is wrong with them, and in which line. A last line that was cut
   !> short, without its end mark, is left out. Any other line that cannot be read is a failure, and so is a piece that stands
   !> there twice with different texts.
   pure subroutine read_record(lines, record, failure)
      type(text_type), intent(in) :: lines(:)
      type(record_type), intent(out) :: record
      character(:), allocatable, intent(out) :: failure
      integer, allocatable :: first_place(:)
      integer :: i, settings, number, count, blank
      logical :: sound, whole
      failure = ''
      allocate (record%numbers(0), record%texts(0), record%places(0), record%settings(0))
      if (size(lines) < head_lines) then
         failure = 'it is not a record: it has '//to_text(size(lines))//' lines'
         return
      end if
      if (lines(1)%text /= title) then
         failure = 'it is not a record: it begins '//quoted(lines(1)%text)
         return
      end if
      settings = 0
      blank = index(lines(2)%text, ' of ')
      sound = index(lines(2)%text, 'part ') == 1 .and. blank > 0
      if (sound) call read_number(lines(2)%text(len('part '):blank), record%part, sound)
      if (sound) call read_number(lines(2)%text(blank + len(' of '):), record%parts, sound)
      if (sound) call read_number(after('pieces ', lines(3)%text), record%pieces, sound)
      if (sound) call read_number(after('settings ', lines(4)%text), settings, sound)
      if (sound) sound = record%pieces <= most_pieces
      if (.not. sound .or. head_lines + settings > size(lines)) then
         failure = 'its head is damaged or cut short'
         return
      end if
      record%settings = lines(head_lines + 1:head_lines + settings)
      count = size(lines) - head_lines - settings
      deallocate (record%numbers, record%texts, record%places)
      allocate (record%numbers(count), record%texts(count), record%places(count))
      allocate (first_place(record%pieces), source=0)
      count = 0
      do i = head_lines + settings + 1, size(lines)
         associate (line => lines(i)%text)
            blank = index(line, ' ')
            number = 0
            whole = len(line) >= len(end_mark)
            if (whole) whole = line(len(line) - len(end_mark) + 1:) == end_mark
            if (.not. whole .and. i == size(lines)) exit
            sound = whole .and. len(line) > len(end_mark) + 1 .and. blank > 1
            if (sound) call read_number(line(:blank), number, sound)
            if (sound) sound = number <= record%pieces
            if (.not. sound) then
               failure = 'line '//to_text(i)//' is damaged'
               return
            end if
            if (first_place(number) > 0) then
               if (record%texts(first_place(number))%text /= line(blank + 1:len(line) - len(end_mark))) then
                  failure = 'line '//to_text(i)//': piece '//to_text(number)//' is there twice, with different results'
                  return
               end if
               cycle
            end if
            count = count + 1
            first_place(number) = count
            record%numbers(count) = number
            record%places(count) = i
            record%texts(count)%text = line(blank + 1:len(line) - len(end_mark))
         end associate
      end do
      record%numbers = record%numbers(:count)
      record%texts = record%texts(:count)
      record%places = record%places(:count)
   end subroutine read_record

   !> Text behind a word; '' where the text does not begin with the word.
   pure function after(word, text) result(rest)
      character(*), intent(in) :: word, text
      character(:), allocatable :: rest
      rest = ''
      if (index(text, word) == 1) rest = text(len(word) + 1:)
   end function after

   !> A whole number >= 1 of up to nine digits.
   pure subroutine read_number(text, number, sound)
      character(*), intent(in) :: text
      integer, intent(out) :: number
      logical, intent(out) :: sound
      integer, parameter :: longest = 9
      integer :: status
      number = 0
      sound = len_trim(adjustl(text)) >= 1 .and. len_trim(adjustl(text)) <= longest .and. verify(text, ' 0123456789') == 0
      if (sound) read (text, *, iostat=status) number
      if (sound) sound = status == 0 .and. number >= 1
   end subroutine read_number

   !> The first setting in which two lists differ, in words: '' where they are the same.
   pure function difference_of(then, now, units) result(words)
      type(text_type), intent(in) :: then(:), now(:)
      type(unit_system_type), intent(in), optional :: units   !< to tell numbers in; else SI
      character(:), allocatable :: words
      integer :: i, cut
      words = ''
      do i = 1, min(size(then), size(now))
         if (then(i)%text == now(i)%text) cycle
         cut = index(then(i)%text, equals)
         if (cut > 0 .and. index(now(i)%text, then(i)%text(:max(cut, 1) + len(equals) - 1)) == 1) then
            words = then(i)%text(:cut - 1)//' has changed'
            if (max(len(then(i)%text), len(now(i)%text)) - cut <= longest_shown) &
               words = told(then(i)%text(:cut - 1), then(i)%text(cut + len(equals):), now(i)%text(cut + len(equals):), units)
         else
            words = quoted(then(i)%text)//' is now '//quoted(now(i)%text)
         end if
         return
      end do
      if (size(then) > size(now)) words = quoted(then(size(now) + 1)%text)//' is gone'
      if (size(now) > size(then)) words = quoted(now(size(then) + 1)%text)//' is new'
   end function difference_of

   !> Text `key was ... and is ...`. Numbers of a record are SI. Those of a known quantity are converted to the deck's units.
   pure function told(key, then, now, units) result(words)
      character(*), intent(in) :: key                         !< as dg_model_text writes it
      character(*), intent(in) :: then, now                   !< values as text
      type(unit_system_type), intent(in), optional :: units   !< not there: as in the record
      character(:), allocatable :: words
      character(:), allocatable :: label
      real(wp) :: factor, before, after
      integer :: cut, status, unit
      words = key//' was '//then//' and is '//now
      if (.not. present(units)) return
      cut = index(key, ' ', back=.true.)
      unit = unit_of(key(cut + 1:))
      if (unit == unit_none) return
      read (then, *, iostat=status) before
      if (status /= 0) return
      read (now, *, iostat=status) after
      if (status /= 0) return
      factor = unit_factor(units, unit)
      label = unit_label(units, unit)
      ! a unit stands behind a comma in some keys
      words = key
      if (cut > 2 .and. scan(key(cut + 1:), '/') + index(' m rad ', ' '//key(cut + 1:)//' ') > 0) words = key(:cut - 2)
      words = words//' was '//to_text(before/factor, digits)//' '//label//' and is '//to_text(after/factor, digits)//' '//label
   end function told

   !> The unit that a deck has for a quantity: that of its key. None where the record's own is the deck's.
   pure function unit_of(word) result(unit)
      character(*), intent(in) :: word                        !< the last of a key
      integer :: unit
      character(*), parameter :: groups(6) = [character(11) :: 'hole', 'fluid', 'component', 'centralizer', 'boundary', 'load_case']
      type(key_rule_type), allocatable :: rules(:)
      integer :: i, k
      select case (word)
      case ('m'); unit = unit_length
      case ('rad'); unit = unit_angle
      case ('rad/s'); unit = unit_rotation
      case ('m/s'); unit = unit_speed
      case default; unit = unit_none
      end select
      do i = 1, size(groups)
         rules = keys_of(trim(groups(i)))
         k = rule_place(rules, word)
         if (k > 0) unit = rules(k)%unit
      end do
   end function unit_of
end module dg_task_record

!> Small text tools: letter case, likeness of names, numbers as text with the fewest digits, texts made fit to be shown.
module dg_text
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_c_binding, only: c_char, c_null_char
   use dg_kinds, only: wp
   use dg_decimal_digits, only: find_digits, most_digits
   use dg_printable, only: printable
   implicit none
   private
   public :: text_type, append_text, text_list, append_piece, joined, either, text_or_nothing
   public :: name_shown
   public :: lower_case, quoted, edit_distance, nearest_name, suggestion, to_text, is_separator_free, c_text, plain_utf8, letter_end

   !> A text of its own length, for lists of texts.
   type :: text_type
      character(:), allocatable :: text
   end type text_type

   !> Digits that a double always keeps through text and back.
   integer, parameter :: safe_digits = 15
   !> Letters of the longest real, -0.000123456789012345 or -1.23456789012345e-308.
   integer, parameter :: longest_real = 22
   !> Longest piece of a user's text that a message repeats.
   integer, parameter :: quote_limit = 48
   !> Letters of a name that a suggestion repeats.
   integer, parameter :: name_shown = 64

   !> A number as text: integers plainly, reals with the fewest digits that give the number back.
   !>
   !> These functions, `quoted` and `either` declare the length of their result. Threads call them. gfortran keeps a deferred
   !> length in one static variable for each call in the source (TREE_STATIC in its trans-expr.c, seen with 12.2). Two threads
   !> at one call would then exchange lengths and corrupt the heap.
   interface to_text
      module procedure integer_text
      module procedure real_text
      module procedure rounded_text
   end interface to_text

contains

   !> Append one text to a list; an unallocated list is an empty one.
   pure subroutine append_text(list, text)
      type(text_type), allocatable, intent(inout) :: list(:)
      character(*), intent(in) :: text
      type(text_type), allocatable :: longer(:)
      integer :: n, i
      n = 0
      if (allocated(list)) n = size(list)
      allocate (longer(n + 1))
      do i = 1, n
         call move_alloc(list(i)%text, longer(i)%text)   ! much cheaper than copies
      end do
      longer(n + 1)%text = text
      call move_alloc(longer, list)
   end subroutine append_text

   !> List of up to four texts. Do not use an array of structure constructors: gfortran 12 allots one byte for a text whose
   !> length it does not know there.
   pure function text_list(first, second, third, fourth) result(list)
      character(*), intent(in), optional :: first, second, third, fourth
      type(text_type), allocatable :: list(:)
      allocate (list(0))
      if (present(first)) call append_text(list, first)
      if (present(second)) call append_text(list, second)
      if (present(third)) call append_text(list, third)
      if (present(fourth)) call append_text(list, fourth)
   end function text_list

   !> Puts a piece behind the letters that a text has so far. For texts that are made letter by letter: `text = text//piece` copies
   !> all of it each time, which takes the square of its length.
   pure subroutine append_piece(text, filled, piece)
      character(*), intent(inout) :: text     !< with room for the piece
      integer, intent(inout) :: filled        !< letters so far
      character(*), intent(in) :: piece
      text(filled + 1:filled + len(piece)) = piece
      filled = filled + len(piece)
   end subroutine append_piece

   !> The texts of a list in one, with `separator` between them.
   pure function joined(list, separator) result(text)
      character(*), intent(in) :: list(:)   !< blanks at the end of each are dropped
      character(*), intent(in) :: separator
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, size(list)
         if (i > 1) text = text//separator
         text = text//trim(list(i))
      end do
   end function joined

   !> A text that may be unallocated: then ''.
   pure function text_or_nothing(text) result(found)
      character(:), allocatable, intent(in) :: text
      character(:), allocatable :: found
      found = ''
      if (allocated(text)) found = text
   end function text_or_nothing

   !> ASCII capitals to small letters; other bytes stay as they are.
   pure function lower_case(text) result(lower)
      character(*), intent(in) :: text
      character(len(text)) :: lower
      integer, parameter :: shift = iachar('a') - iachar('A')
      integer :: i
      do i = 1, len(text)
         lower(i:i) = text(i:i)
         if (text(i:i) >= 'A' .and. text(i:i) <= 'Z') lower(i:i) = achar(iachar(text(i:i)) + shift)
      end do
   end function lower_case

   !> A user's text in quotes for a message: cut to a readable length between two letters, control bytes shown as '?'.
   pure function quoted(text) result(shown)
      character(*), intent(in) :: text
      character(min(len(text), quote_limit) + 2) :: shown
      integer :: last, letter
      if (len(text) <= quote_limit) then
         shown = "'"//printable(text, '')//"'"
         return
      end if
      last = 0
      do
         letter = letter_end(text, last + 1)
         if (letter == 0) letter = last + 1
         if (letter > quote_limit - 3) exit
         last = letter
      end do
      shown = "'"//printable(text(:last), '')//repeat('.', quote_limit - last)//"'"
   end function quoted

   !> A text that every reader of UTF-8 and XML takes: control bytes become blanks, bytes that make no letter '?'.
   pure function plain_utf8(text) result(safe)
      character(*), intent(in) :: text
      character(len(text)) :: safe
      integer :: i, last
      i = 1
      do while (i <= len(text))
         last = letter_end(text, i)
         if (last == 0) then
            safe(i:i) = '?'
            last = i
         else if (iachar(text(i:i)) < iachar(' ') .or. iachar(text(i:i)) == 127) then
            safe(i:i) = ' '
         else
            safe(i:last) = text(i:last)
         end if
         i = last + 1
      end do
   end function plain_utf8

   !> Last byte of the letter in UTF-8 that begins at byte `first`; 0 if none does. See table 3-7 of the Unicode standard,
   !> without U+FFFE and U+FFFF.
   pure function letter_end(text, first) result(last)
      character(*), intent(in) :: text
      integer, intent(in) :: first
      integer :: last
      integer :: low, high, k   ! what the second byte may be
      low = 128
      high = 191
      last = first
      select case (iachar(text(first:first)))
      case (0:127)
         return
      case (194:223); last = first + 1
      case (224:239); last = first + 2
      case (240:244); last = first + 3
      case default
         last = 0
         return
      end select
      select case (iachar(text(first:first)))
      case (224); low = 160
      case (237); high = 159
      case (240); low = 144
      case (244); high = 143
      case default
      end select
      if (last > len(text)) then
         last = 0
      else if (iachar(text(first + 1:first + 1)) < low .or. iachar(text(first + 1:first + 1)) > high) then
         last = 0
      else
         do k = first + 2, last
            if (iachar(text(k:k)) < 128 .or. iachar(text(k:k)) > 191) exit
         end do
         if (k <= last) then
            last = 0
         else if (last == first + 2) then
            if (text(first:first + 1) == char(239)//char(191) .and. iachar(text(last:last)) > 189) last = 0
         end if
      end if
   end function letter_end

   !> One of two texts, the first where it is so. The length is written without commas, which pages for programmers cannot read.
   pure function either(first, second, so) result(text)
      character(*), intent(in) :: first, second
      logical, intent(in) :: so
      character(len(first)*count([so]) + len(second)*count([.not. so])) :: text
      text = first
      if (.not. so) text = second
   end function either

   !> Least number of letters to insert, delete, change or swap with a neighbour that turns `a` into `b`. This is optimal
   !> string alignment (Damerau 1964).
   pure function edit_distance(a, b) result(distance)
      character(*), intent(in) :: a, b
      integer :: distance
      integer :: cost(0:len(a), 0:len(b))
      integer :: i, j, change
      cost(:, 0) = [(i, i=0, len(a))]
      cost(0, :) = [(j, j=0, len(b))]
      do j = 1, len(b)
         do i = 1, len(a)
            change = merge(0, 1, a(i:i) == b(j:j))
            cost(i, j) = min(cost(i - 1, j) + 1, cost(i, j - 1) + 1, cost(i - 1, j - 1) + change)
            if (swapped(i, j)) cost(i, j) = min(cost(i, j), cost(max(i - 2, 0), max(j - 2, 0)) + 1)
         end do
      end do
      distance = cost(len(a), len(b))
   contains
      !> True if the letters that end here are two neighbours in the other order.
      pure function swapped(i, j)
         integer, intent(in) :: i, j
         logical :: swapped
         swapped = i > 1 .and. j > 1
         if (swapped) swapped = a(i:i) == b(j - 1:j - 1) .and. a(i - 1:i - 1) == b(j:j)
      end function swapped
   end function edit_distance

   !> Candidate most like `name` (letter case aside), or '' if none is near. A near one continues `name`, or differs by at most
   !> two slips or a third of its letters.
   pure function nearest_name(name, candidates) result(nearest)
      character(*), intent(in) :: name
      character(*), intent(in) :: candidates(:)
      character(:), allocatable :: nearest
      integer :: i, distance, best
      integer, parameter :: shortest_stem = 3   ! of fewer letters too many names begin alike
      nearest = ''
      best = max(2, len_trim(name)/3) + 1
      if (len_trim(name) <= 3) best = 2   ! two slips would turn a name of three letters into any other
      do i = 1, size(candidates)
         distance = edit_distance(trim(lower_case(name)), trim(lower_case(candidates(i))))
         if (distance < best) then
            best = distance
            nearest = trim(candidates(i))
         end if
      end do
      if (nearest /= '' .or. len_trim(name) < shortest_stem) return
      do i = 1, size(candidates)
         if (index(lower_case(candidates(i)), trim(lower_case(name))) == 1) nearest = trim(candidates(i))
      end do
   end function nearest_name

   !> Advice on an unknown name: the nearest legal one where one is near, else all of them.
   pure function suggestion(name, candidates) result(advice)
      character(*), intent(in) :: name
      character(*), intent(in) :: candidates(:)
      character(:), allocatable :: advice
      advice = nearest_name(name, candidates)
      if (advice /= '') then
         advice = "did you mean '"//advice//"'?"
      else
         advice = 'legal: '//joined(candidates, ', ')
      end if
   end function suggestion

   !> True if a text is safe as part of a file name. It has letters, digits and _ - . + only, is not empty and does not begin with a
   !> dot. It is short enough for a file's name of 255 bytes.
   pure function is_separator_free(text) result(safe)
      character(*), intent(in) :: text
      logical :: safe
      character(*), parameter :: allowed = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+'
      integer, parameter :: longest = 100
      safe = len(text) > 0 .and. len(text) <= longest .and. verify(text, allowed) == 0
      if (safe) safe = text(1:1) /= '.'
   end function is_separator_free

   ! Before the functions that declare texts by them: gfortran asks for that.
   pure function integer_length(number) result(length)
      integer, intent(in) :: number
      integer :: length
      character(16) :: buffer
      write (buffer, '(i0)') number
      length = len_trim(buffer)
   end function integer_length

   pure function real_length(number, digits) result(length)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      integer :: length
      character(longest_real) :: whole
      call write_real(number, digits, whole, length)
   end function real_length

   !> An integer as text.
   pure function integer_text(number) result(text)
      integer, intent(in) :: number
      character(integer_length(number)) :: text
      write (text, '(i0)') number
   end function integer_text

   !> Text of a finite real with the fewest digits that give it back to 15 significant ones: plain if short, else with an
   !> exponent.
   pure function real_text(number) result(text)
      real(wp), intent(in) :: number
      character(real_length(number, safe_digits)) :: text
      character(longest_real) :: whole
      integer :: length
      call write_real(number, safe_digits, whole, length)
      text = whole(:length)
   end function real_text

   !> The same to `digits` significant ones.
   pure function rounded_text(number, digits) result(text)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      character(real_length(number, digits)) :: text
      character(longest_real) :: whole
      integer :: length
      call write_real(number, digits, whole, length)
      text = whole(:length)
   end function rounded_text

   pure subroutine write_real(number, digits, text, length)
      real(wp), intent(in) :: number
      integer, intent(in) :: digits
      character(longest_real), intent(out) :: text
      integer, intent(out) :: length
      character(safe_digits) :: mantissa
      integer :: n, exponent
      ! plain notation for 0.0001 up to ten million less one
      integer, parameter :: least_plain = -4, most_plain = 6
      length = 0
      if (.not. ieee_is_finite(number)) then     ! of an iteration that ran away
         call append_piece(text, length, 'beyond all numbers')
         return
      else if (abs(number) <= 0.0_wp) then
         call append_piece(text, length, '0')
         return
      end if
      n = max(1, min(digits, safe_digits))
      call find_leading_digits(abs(number), n, mantissa, exponent)
      do while (n > 1 .and. mantissa(n:n) == '0')     ! without noughts at their end
         n = n - 1
      end do
      if (number < 0.0_wp) call append_piece(text, length, '-')
      if (exponent < least_plain .or. exponent > most_plain) then
         call append_piece(text, length, mantissa(1:1))
         if (n > 1) call append_piece(text, length, '.'//mantissa(2:n))
         call append_piece(text, length, 'e'//integer_text(exponent))
      else if (exponent < 0) then
         call append_piece(text, length, '0.'//repeat('0', -exponent - 1))
         call append_piece(text, length, mantissa(:n))
      else if (n <= exponent + 1) then
         call append_piece(text, length, mantissa(:n))
         call append_piece(text, length, repeat('0', exponent + 1 - n))
      else
         call append_piece(text, length, mantissa(:exponent + 1))
         call append_piece(text, length, '.')
         call append_piece(text, length, mantissa(exponent + 2:n))
      end if
   end subroutine write_real

   !> The first n digits of x > 0, without the point, and the exponent of the first.
   pure subroutine find_leading_digits(x, n, mantissa, exponent)
      real(wp), intent(in) :: x
      integer, intent(in) :: n
      character(safe_digits), intent(out) :: mantissa
      integer, intent(out) :: exponent
      character(most_digits) :: letters
      character(40) :: buffer
      character(16) :: form
      integer :: point
      logical :: certain
      if (n <= most_digits) then
         call find_digits(x, n, letters, exponent, certain)
         if (certain) then
            mantissa = letters(most_digits - n + 1:)
            return
         end if
      end if
      write (form, '(a,i0,a)') '(es30.', n - 1, 'e3)'
      write (buffer, form) x
      buffer = adjustl(buffer)
      point = index(buffer, 'E')
      read (buffer(point + 1:), *) exponent
      mantissa = buffer(1:1)//buffer(3:point - 1)
   end subroutine find_leading_digits

   !> A text as C wants it: characters and a null.
   pure function c_text(text) result(chars)
      character(*), intent(in) :: text
      character(kind=c_char) :: chars(len(text) + 1)
      chars = transfer(text//c_null_char, chars)
   end function c_text
end module dg_text

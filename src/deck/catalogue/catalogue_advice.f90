!> Advice on a name that the catalogue does not have: entries of the same kind, size, weight and grade in any spelling. 'DP 5
!> 19.5 S-135' means 'DP 5 19.50 NC50 S135'.
module dg_catalogue_advice
   use dg_catalogue, only: catalogue_type, kind_of_grades
   use dg_deck_number, only: read_fraction, read_real
   use dg_kinds, only: wp
   use dg_readable, only: squeezed
   use dg_text, only: append_text, edit_distance, lower_case, suggestion, text_type
   implicit none
   private
   public :: catalogue_advice

   !> Most names in a message.
   integer, parameter :: most_told = 8
   !> Letters of the longest name of an entry with its grade.
   integer, parameter :: longest = 80
   !> Two sizes or weights are the same up to this [in, lbm/ft].
   real(wp), parameter :: same = 5.0e-3_wp
   !> Largest relative difference of near weights [-]: nominal, adjusted and rounded weights differ by less.
   real(wp), parameter :: near = 0.1_wp
   !> Marks and units behind a number.
   character(*), parameter :: marks(7) = [character(6) :: 'lbm/ft', 'lbs/ft', 'lb/ft', 'ppf', '#', '"', 'in']
   !> First words of names, and their other spellings.
   character(*), parameter :: kind_words(2, 7) = reshape([character(10) :: 'drillpipe', 'dp', 'pipe', 'dp', 'heavywate', 'hwdp', &
      'hw', 'hwdp', 'collar', 'dc', 'casing', 'csg', 'tubing', 'tbg'], [2, 7])

   !> Parts of a name.
   type :: parts_type
      character(:), allocatable :: kind      !< first word, small letters; '': none
      character(:), allocatable :: grade     !< small letters, without hyphens; '': none
      character(:), allocatable :: rest      !< connection and what else there is, small letters
      real(wp) :: size = 0.0_wp              !< [in]; 0: none
      real(wp) :: weight = 0.0_wp            !< [lbm/ft]; 0: none
   end type parts_type

contains

   !> Names of the catalogue near `name`. First come entries of its kind and size with the same weight, then with a near one, then
   !> all. Of these the most similar connection counts. Without a size: the command that lists the kind.
   function catalogue_advice(catalogue, name) result(advice)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: name
      character(:), allocatable :: advice
      type(parts_type) :: wanted, entry
      type(text_type), allocatable :: found(:)
      character(longest), allocatable :: names(:)
      character(:), allocatable :: grade
      integer :: i, rank, best, distance, nearest
      advice = grade_advice(catalogue, name)
      if (advice /= '') return
      call split_name(catalogue, name, wanted)
      grade = grade_name(catalogue, wanted%grade)
      if (grade /= '') grade = ' '//grade
      best = huge(best)
      nearest = huge(nearest)
      allocate (found(0), names(0))
      do i = 1, size(catalogue%entries)
         if (catalogue%entries(i)%kind == kind_of_grades) cycle
         call split_name(catalogue, catalogue%entries(i)%name, entry)
         if (wanted%kind /= '' .and. entry%kind /= wanted%kind) cycle
         names = [character(longest) :: names, catalogue%entries(i)%name//grade]
         if (.not. wanted%size > 0.0_wp .or. abs(entry%size - wanted%size) > same) cycle
         rank = 2
         if (abs(entry%weight - wanted%weight) <= near*wanted%weight .or. .not. wanted%weight > 0.0_wp) rank = 1
         if (abs(entry%weight - wanted%weight) <= same) rank = 0
         distance = 0
         if (wanted%rest /= '') distance = edit_distance(wanted%rest, entry%rest)
         if (rank > best .or. (rank == best .and. distance > nearest)) cycle
         if (rank < best .or. distance < nearest) then
            deallocate (found)
            allocate (found(0))
         end if
         best = rank
         nearest = distance
         call append_text(found, catalogue%entries(i)%name//grade)
      end do
      if (size(found) == 0) then
         advice = suggestion(name, names)
         if (wanted%kind /= '') then
            advice = '--list-catalogue '//wanted%kind//' lists what it has'
         else if (index(advice, 'legal:') == 1) then
            advice = '--list-catalogue lists what it has'
         end if
         return
      end if
      advice = 'did you mean '
      do i = 1, min(size(found), most_told)
         if (i > 1 .and. i == size(found)) then
            advice = advice//' or '
         else if (i > 1) then
            advice = advice//', '
         end if
         advice = advice//"'"//found(i)%text//"'"
      end do
      advice = advice//'?'
      if (size(found) > most_told) advice = advice//' --list-catalogue lists more'
   end function catalogue_advice

   !> Advice on a name that is one of the catalogue with a word behind it, which is no grade; '' for others.
   pure function grade_advice(catalogue, name) result(advice)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: name
      character(:), allocatable :: advice
      character(:), allocatable :: body, word, grade
      integer :: i, last
      logical :: found
      advice = ''
      last = index(trim(name), ' ', back=.true.)
      if (last < 2) return
      body = trim(name(:last - 1))
      word = trim(name(last + 1:))
      grade = ''
      found = .false.
      do i = 1, size(catalogue%entries)
         associate (entry => catalogue%entries(i))
            if (entry%kind /= kind_of_grades) then
               found = found .or. lower_case(entry%name) == lower_case(body)
            else if (edit_distance(lower_case(word), lower_case(entry%name)) == 1) then
               grade = entry%name
            end if
         end associate
      end do
      if (.not. found) return
      if (grade /= '') then
         advice = "did you mean '"//body//' '//grade//"'?"
      else
         advice = "leave out '"//word//"'. For a grade that the catalogue does not have give yield"
      end if
   end function grade_advice

   !> Split a name: kind, size, weight, grade, and the rest.
   subroutine split_name(catalogue, name, parts)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: name
      type(parts_type), intent(out) :: parts
      character(:), allocatable :: left, word
      real(wp) :: number
      logical :: legal, whole
      integer :: length
      parts%kind = ''
      parts%grade = ''
      parts%rest = ''
      whole = .false.                ! the last number was a whole one, which a fraction may follow
      left = trim(adjustl(lower_case(name)))
      do while (left /= '')
         length = scan(left//' ', ' ,') - 1
         word = left(:length)
         left = adjustl(left(min(length + 2, len(left) + 1):))
         if (word == '') cycle
         call read_size(without_mark(word), number, legal)
         if (parts%weight > 0.0_wp) legal = .false.       ! what follows is a connection
         if (legal .and. parts%size > 0.0_wp .and. whole .and. index(word, '/') > 0 .and. scan(word, '-') == 0) then
            parts%size = parts%size + number
            whole = .false.
         else if (legal .and. .not. parts%size > 0.0_wp) then
            parts%size = number
            whole = verify(word, '0123456789') == 0
         else if (legal) then
            parts%weight = number
         else if (grade_name(catalogue, squeezed(word, '-')) /= '') then
            parts%grade = squeezed(word, '-')
         else if (parts%kind == '' .and. .not. parts%size > 0.0_wp .and. parts%rest == '') then
            parts%kind = kind_of(catalogue, word)
            if (parts%kind == '') parts%rest = word
         else
            parts%rest = trim(parts%rest//' '//word)
         end if
      end do
      parts%rest = trim(adjustl(parts%rest))
   end subroutine split_name

   !> First word of names that a word means; '' if no entry has it.
   pure function kind_of(catalogue, word) result(kind)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: word
      character(:), allocatable :: kind
      integer :: i
      kind = word
      do i = 1, size(kind_words, 2)
         if (squeezed(word, '-') == kind_words(1, i)) kind = trim(kind_words(2, i))
      end do
      do i = 1, size(catalogue%entries)
         if (catalogue%entries(i)%kind == kind_of_grades) cycle
         if (index(lower_case(catalogue%entries(i)%name)//' ', kind//' ') == 1) return
      end do
      kind = ''
   end function kind_of

   !> Name of a grade in the catalogue, found without regard to hyphens; '' for an unknown grade.
   pure function grade_name(catalogue, word) result(name)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: word        !< as `squeezed` gives it, without hyphens
      character(:), allocatable :: name
      integer :: i
      name = ''
      if (word == '') return
      do i = 1, size(catalogue%entries)
         if (catalogue%entries(i)%kind /= kind_of_grades) cycle
         if (squeezed(catalogue%entries(i)%name, '-') == word) name = catalogue%entries(i)%name
      end do
   end function grade_name

   !> A word without the mark or unit at its end.
   pure function without_mark(word) result(text)
      character(*), intent(in) :: word
      character(:), allocatable :: text
      integer :: i, last
      text = word
      do i = 1, size(marks)
         last = len(text) - len_trim(marks(i))
         if (last < 1) cycle
         if (text(last + 1:) == trim(marks(i))) text = text(:last)
      end do
   end function without_mark

   !> A size or weight: 5, 5-1/2, 1/2, 19.50.
   pure subroutine read_size(word, number, legal)
      character(*), intent(in) :: word
      real(wp), intent(out) :: number
      logical, intent(out) :: legal
      number = 0.0_wp
      legal = verify(word, '0123456789.-/') == 0 .and. scan(word, '0123456789') == 1
      if (.not. legal) return
      if (index(word, '/') > 0) then
         call read_fraction(word, number, legal)
      else
         legal = index(word, '-') == 0
         if (legal) call read_real(word, number, legal)
      end if
   end subroutine read_size
end module dg_catalogue_advice

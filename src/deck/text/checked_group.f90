!> One group of a deck after checking: a value for each key of its table, with ways to ask for it.
module dg_checked_group
   use dg_kinds, only: wp
   use dg_deck_schema, only: name_length
   use dg_error, only: add_fault, error_list_type
   use dg_missing, only: given, optional_real
   use dg_text, only: append_text, lower_case, quoted, text_type
   implicit none
   private
   public :: value_type, checked_group_type, claim_name, group_fault, is_whole, named
   public :: is_given, is_sound, line_of, optional_of, real_of, integer_of, logical_of, text_of, reals_of, texts_of, places_of

   !> Numbers or texts of a key.
   type :: content_type
      real(wp), allocatable :: numbers(:)    !< SI; integers too
      type(text_type), allocatable :: texts(:)
   end type content_type

   !> The value of one key in one group. Most keys of a group are absent and have no content, which saves memory.
   type :: value_type
      character(name_length) :: key = ''
      logical :: given = .false.             !< stands in the deck
      logical :: sound = .false.             !< holds a legal value, given or by default
      logical :: required = .false.          !< must stand in the deck
      integer :: line = 0                    !< of the key; of the group where not given
      logical :: flag = .false.
      real(wp) :: number = 0.0_wp            !< by default, where the content has no numbers [SI]
      type(content_type), allocatable :: content
   end type value_type

   !> One group with a value for each of its keys.
   type :: checked_group_type
      character(:), allocatable :: path           !< of its deck
      character(:), allocatable :: name
      integer :: line = 0
      type(value_type), allocatable :: values(:)  !< in the order of the rules of its keys
   end type checked_group_type

contains

   !> Place of a key among those of its group.
   pure function place_of(group, key) result(place)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      integer :: place
      do place = 1, size(group%values)
         if (group%values(place)%key == key) return
      end do
      place = 0
   end function place_of

   !> True if a key is in the deck, valid or not.
   pure function is_given(group, key) result(given)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      logical :: given
      given = group%values(place_of(group, key))%given
   end function is_given

   !> True if a key has a legal value, from the deck or by default.
   pure function is_sound(group, key) result(sound)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      logical :: sound
      sound = group%values(place_of(group, key))%sound
   end function is_sound

   !> Line of a key; of its group where it is not given.
   pure function line_of(group, key) result(line)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      integer :: line
      line = group%values(place_of(group, key))%line
   end function line_of

   !> Notes a fault of a key, or of the group as a whole where `key` is ''.
   pure subroutine group_fault(group, key, message, faults)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key, message
      type(error_list_type), intent(inout) :: faults
      integer :: line
      line = group%line
      if (key /= '') line = line_of(group, key)
      call add_fault(faults, group%path, line, 'group &'//group%name//': '//message)
   end subroutine group_fault

   !> Places of the groups with a name.
   pure function named(groups, name) result(places)
      type(checked_group_type), intent(in) :: groups(:)
      character(*), intent(in) :: name
      integer, allocatable :: places(:)
      integer :: i
      places = pack([(i, i=1, size(groups))], [(groups(i)%name == name, i=1, size(groups))])
   end function named

   !> Enters the name of something into a list. Notes a fault where it is taken, letter case aside. '' is no name.
   pure subroutine claim_name(group, key, name, taken, faults)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key              !< that holds the name
      character(*), intent(in) :: name
      type(text_type), allocatable, intent(inout) :: taken(:)
      type(error_list_type), intent(inout) :: faults
      integer :: i
      if (name == '') return
      if (any([(taken(i)%text == lower_case(name), i=1, size(taken))])) then
         call group_fault(group, key, key//' '//quoted(name)//' is taken; '//key//'s must be unique, letter case aside', faults)
      else
         call append_text(taken, lower_case(name))
      end if
   end subroutine claim_name

   !> True if every key of a group that is given or required has a legal value.
   pure function is_whole(group) result(whole)
      type(checked_group_type), intent(in) :: group
      logical :: whole
      whole = all(group%values%sound .or. .not. (group%values%given .or. group%values%required))
   end function is_whole

   !> The number of a key [SI], or `otherwise` where it has no legal one.
   pure function real_of(group, key, otherwise) result(number)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      real(wp), intent(in) :: otherwise
      real(wp) :: number
      number = otherwise
      associate (value => group%values(place_of(group, key)))
         if (value%sound) number = value%number
         if (value%sound .and. allocated(value%content)) number = value%content%numbers(1)
      end associate
   end function real_of

   !> The number of a key [SI]; absent where it has no legal one.
   pure function optional_of(group, key) result(number)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      type(optional_real) :: number
      if (is_sound(group, key)) number = given(real_of(group, key, 0.0_wp))
   end function optional_of

   !> The whole number of a key, or `otherwise`.
   pure function integer_of(group, key, otherwise) result(number)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      integer, intent(in) :: otherwise
      integer :: number
      number = nint(real_of(group, key, real(otherwise, wp)))
   end function integer_of

   !> The logical of a key, or `otherwise`.
   pure function logical_of(group, key, otherwise) result(flag)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      logical, intent(in) :: otherwise
      logical :: flag
      flag = otherwise
      if (is_sound(group, key)) flag = group%values(place_of(group, key))%flag
   end function logical_of

   !> The text of a key, or `otherwise`.
   pure function text_of(group, key, otherwise) result(text)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      character(*), intent(in) :: otherwise
      character(:), allocatable :: text
      text = otherwise
      if (is_sound(group, key)) text = group%values(place_of(group, key))%content%texts(1)%text
   end function text_of

   !> All numbers of a key [SI]; none where it has no legal ones.
   pure function reals_of(group, key) result(numbers)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      real(wp), allocatable :: numbers(:)
      allocate (numbers(0))
      associate (value => group%values(place_of(group, key)))
         if (value%sound) numbers = [value%number]
         if (value%sound .and. allocated(value%content)) numbers = value%content%numbers
      end associate
   end function reals_of

   !> All texts of a key; none where it has no legal ones.
   pure function texts_of(group, key) result(texts)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      type(text_type), allocatable :: texts(:)
      allocate (texts(0))
      if (is_sound(group, key)) texts = group%values(place_of(group, key))%content%texts
   end function texts_of

   !> Places of a key's texts in a list of names, each once; none where the key has no legal ones.
   pure function places_of(group, key, names) result(found)
      type(checked_group_type), intent(in) :: group
      character(*), intent(in) :: key
      character(*), intent(in) :: names(:)
      integer, allocatable :: found(:)
      type(text_type), allocatable :: texts(:)
      integer :: i, k
      allocate (texts, source=texts_of(group, key))
      allocate (found(0))
      do i = 1, size(texts)
         do k = 1, size(names)
            if (texts(i)%text == names(k) .and. .not. any(found == k)) found = [found, k]
         end do
      end do
   end function places_of
end module dg_checked_group

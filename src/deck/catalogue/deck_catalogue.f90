!> Fill components of a deck from the catalogue. Values of the deck have priority over the catalogue, and the catalogue over
!> defaults.
module dg_deck_catalogue
   use dg_kinds, only: wp
   use dg_catalogue, only: catalogue_type, find_catalogue, find_entry, number_of, numeric_keys, read_catalogue
   use dg_catalogue_advice, only: catalogue_advice
   use dg_checked_group, only: checked_group_type, is_given, is_sound, line_of, text_of
   use dg_deck_keys, only: key_place
   use dg_error, only: add_fault, error_at, error_list_type, error_type
   use dg_text, only: append_text, quoted
   implicit none
   private
   public :: fill_from_catalogue

contains

   !> Fill every component of the deck `path` that names an entry. The catalogue is only read if one does.
   subroutine fill_from_catalogue(path, groups, file, faults)
      character(*), intent(in) :: path
      type(checked_group_type), intent(inout) :: groups(:)
      character(:), allocatable, intent(out) :: file     !< the catalogue's path; '' where none was needed
      type(error_list_type), intent(inout) :: faults
      type(catalogue_type) :: catalogue
      type(error_type) :: asked
      character(:), allocatable :: named
      integer :: i, before
      logical :: tried, sound
      named = ''
      file = ''
      asked = error_at(path, 0, '')
      tried = .false.
      sound = .false.
      do i = 1, size(groups)
         if (groups(i)%name /= 'job') cycle
         named = text_of(groups(i), 'catalogue_file', '')
         if (named /= '') asked = error_at(path, line_of(groups(i), 'catalogue_file'), 'group &job: catalogue_file')
      end do
      do i = 1, size(groups)
         if (groups(i)%name /= 'component') cycle
         if (.not. is_given(groups(i), 'catalogue') .or. .not. is_sound(groups(i), 'catalogue')) cycle
         if (.not. tried) then
            tried = .true.
            call find_catalogue(path, named, file)
            before = faults%noted
            if (named == '') asked = error_at(path, line_of(groups(i), 'catalogue'), 'group &component: catalogue')
            call read_catalogue(file, catalogue, faults, asked)
            sound = faults%noted == before
         end if
         if (sound) call fill(path, catalogue, groups(i), faults)
      end do
   end subroutine fill_from_catalogue

   !> Fills one component.
   subroutine fill(path, catalogue, group, faults)
      character(*), intent(in) :: path
      type(catalogue_type), intent(in) :: catalogue
      type(checked_group_type), intent(inout) :: group
      type(error_list_type), intent(inout) :: faults
      character(:), allocatable :: name
      integer :: entry, grade, key, place
      real(wp) :: number
      logical :: has
      name = text_of(group, 'catalogue', '')
      call find_entry(catalogue, name, entry, grade)
      if (entry == 0) then
         call add_fault(faults, path, line_of(group, 'catalogue'), 'group &component: '//catalogue%path//' has no '// &
                        quoted(name)//'; '//catalogue_advice(catalogue, name))
         return
      end if
      do key = 1, size(numeric_keys)
         if (is_given(group, trim(numeric_keys(key)))) cycle
         call number_of(catalogue, entry, grade, key, has, number)
         if (.not. has) cycle
         place = key_place('component', trim(numeric_keys(key)))
         if (.not. allocated(group%values(place)%content)) allocate (group%values(place)%content)
         group%values(place)%content%numbers = [number]
         group%values(place)%sound = .true.
      end do
      call fill_text('name', name)
      call fill_text('kind', catalogue%entries(entry)%kind)
      call fill_text('connection', catalogue%entries(entry)%connection)
      if (.not. is_sound(group, 'od') .and. .not. is_given(group, 'od')) call add_fault(faults, path, &
         line_of(group, 'catalogue'), 'group &component: '//quoted(name)//' of '//catalogue%path//' has no od; give it here')

   contains

      subroutine fill_text(key_name, text)
         character(*), intent(in) :: key_name, text
         integer :: k
         if (is_given(group, key_name) .or. text == '') return
         k = key_place('component', key_name)
         if (allocated(group%values(k)%content)) deallocate (group%values(k)%content)
         allocate (group%values(k)%content)
         allocate (group%values(k)%content%texts(0))
         call append_text(group%values(k)%content%texts, text)
         group%values(k)%sound = .true.
      end subroutine fill_text
   end subroutine fill
end module dg_deck_catalogue

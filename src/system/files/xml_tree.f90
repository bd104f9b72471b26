!> Chosen elements of an XML document, with what is in them, as a list in the order of the document.
module dg_xml_tree
   use dg_text, only: append_text, lower_case, text_type, to_text
   use dg_xml, only: read_xml, xml_reader_type
   implicit none
   private
   public :: xml_tree_type, attribute, child, read_tree

   type :: xml_element_type
      character(:), allocatable :: name            !< without prefix, in lower case
      character(:), allocatable :: text            !< characters directly in it
      type(text_type), allocatable :: attributes(:) !< name in lower case, value, ...
      integer :: parent = 0                        !< number of the element that it stands in; 0: one that was not chosen
      integer :: line = 0
   end type xml_element_type

   !> What is in an element follows it.
   type, extends(xml_reader_type) :: xml_tree_type
      type(xml_element_type), allocatable :: elements(:)
      integer :: n = 0
      integer, private :: open = 0                 !< element that is being read
      character(:), allocatable, private :: chosen, kept  !< names with blanks round them
      logical, private :: full = .false.
   contains
      procedure :: begin => begin_element
      procedure :: finish => finish_element
   end type xml_tree_type

   !> Elements that are kept of a document: 15,000 stations have 400,000.
   integer, parameter :: most_elements = 4000000, first_room = 1024

contains

   !> Reads the document `path`. `failure` says what is wrong, as of `read_xml`.
   subroutine read_tree(path, chosen, kept, tree, failure)
      character(*), intent(in) :: path
      character(*), intent(in) :: chosen           !< names of elements in lower case, a blank between two
      character(*), intent(in) :: kept             !< the same of attributes
      type(xml_tree_type), intent(out) :: tree
      character(:), allocatable, intent(out) :: failure
      allocate (tree%elements(first_room))
      tree%chosen = ' '//chosen//' '
      tree%kept = ' '//kept//' '
      call read_xml(path, tree, failure)
      if (failure == '' .and. tree%full) failure = 'has more than '//to_text(most_elements)//' elements of a case'
   end subroutine read_tree

   subroutine begin_element(reader, name, attributes, line)
      class(xml_tree_type), intent(inout) :: reader
      character(*), intent(in) :: name
      type(text_type), intent(in) :: attributes(:)
      integer, intent(in) :: line
      type(xml_element_type), allocatable :: more(:)
      integer :: i, k
      if (reader%open == 0 .and. index(reader%chosen, ' '//lower_case(name)//' ') == 0) return
      if (reader%n == most_elements) reader%full = .true.
      if (reader%full) return
      if (reader%n == size(reader%elements)) then
         allocate (more(2*reader%n))
         more(:reader%n) = reader%elements
         call move_alloc(more, reader%elements)
      end if
      reader%n = reader%n + 1
      associate (element => reader%elements(reader%n))
         element%name = lower_case(name)
         element%text = ''
         element%parent = reader%open
         element%line = line
         allocate (element%attributes(0))
         do i = 1, size(attributes) - 1, 2
            k = index(attributes(i)%text, ':', back=.true.)
            if (index(reader%kept, ' '//lower_case(attributes(i)%text(k + 1:))//' ') == 0) cycle
            call append_text(element%attributes, lower_case(attributes(i)%text(k + 1:)))
            call append_text(element%attributes, attributes(i + 1)%text)
         end do
      end associate
      reader%open = reader%n
   end subroutine begin_element

   subroutine finish_element(reader, name, text)
      class(xml_tree_type), intent(inout) :: reader
      character(*), intent(in) :: name, text
      if (reader%open == 0 .or. reader%full) return
      if (reader%elements(reader%open)%name /= lower_case(name)) return
      reader%elements(reader%open)%text = trimmed(text)
      reader%open = reader%elements(reader%open)%parent
   end subroutine finish_element

   !> An attribute without the blanks round it; '' where it is absent.
   pure function attribute(element, name) result(value)
      type(xml_element_type), intent(in) :: element
      character(*), intent(in) :: name
      character(:), allocatable :: value
      integer :: i
      value = ''
      do i = 1, size(element%attributes) - 1, 2
         if (element%attributes(i)%text == name) value = trimmed(element%attributes(i + 1)%text)
      end do
   end function attribute

   !> Number of the first element of a path of names ('connection/od') in element `parent`; 0: absent. `after`: the next one.
   pure recursive function child(tree, parent, path, after) result(number)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: parent
      character(*), intent(in) :: path
      integer, intent(in), optional :: after
      integer :: number
      integer :: i, slash, first
      number = 0
      slash = index(path//'/', '/')
      first = parent + 1
      if (present(after)) first = max(first, after + 1)
      do i = first, tree%n
         if (tree%elements(i)%parent < parent) exit
         if (tree%elements(i)%parent /= parent .or. tree%elements(i)%name /= path(:slash - 1)) cycle
         number = i
         if (slash < len(path)) number = child(tree, i, path(slash + 1:))
         if (number > 0) return
      end do
   end function child

   !> A text without blanks, tabs and ends of lines at its ends.
   pure function trimmed(text) result(bare)
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      character(*), parameter :: blanks = ' '//achar(9)//achar(10)//achar(13)
      bare = ''
      if (verify(text, blanks) > 0) bare = text(verify(text, blanks):verify(text, blanks, back=.true.))
   end function trimmed
end module dg_xml_tree

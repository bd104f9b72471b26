!> Chosen elements of an XML document, with what is in them, as a list in the order of the document. Module dg_xml reads it.
module dg_xml_tree
   use dg_text, only: append_text, lower_case, text_type
   implicit none
   private
   public :: xml_tree_type, attribute, child, close_element, open_element, text_at

   type :: xml_element_type
      character(:), allocatable :: name            !< without prefix, in lower case
      character(:), allocatable :: text            !< characters directly in it
      type(text_type), allocatable :: attributes(:) !< name in lower case, value, ...
      integer :: parent = 0                        !< number of the element that it stands in; 0: one that was not chosen
      integer :: line = 0
   end type xml_element_type

   !> Elements of a document, each before its content.
   type :: xml_tree_type
      type(xml_element_type), allocatable :: elements(:)
      integer :: n = 0
      integer :: open = 0                          !< element that is being read; 0: one that is not chosen
      character(:), allocatable :: chosen, kept    !< names of elements and attributes, with blanks round them
   end type xml_tree_type


contains

   !> An element begins: it is kept where it is chosen, or stands in a chosen one. Names may have a prefix.
   subroutine open_element(tree, name, attributes, line)
      type(xml_tree_type), intent(inout) :: tree
      character(*), intent(in) :: name
      type(text_type), intent(in) :: attributes(:)   !< name, value, name, value ...
      integer, intent(in) :: line                  !< of the document
      type(xml_element_type), allocatable :: more(:)
      integer :: i
      if (tree%open == 0 .and. index(tree%chosen, ' '//plain_name(name)//' ') == 0) return
      if (tree%n == size(tree%elements)) then
         allocate (more(2*tree%n))
         more(:tree%n) = tree%elements
         call move_alloc(more, tree%elements)
      end if
      tree%n = tree%n + 1
      associate (element => tree%elements(tree%n))
         element%name = plain_name(name)
         element%text = ''
         element%parent = tree%open
         element%line = line
         allocate (element%attributes(0))
         do i = 1, size(attributes) - 1, 2
            if (index(tree%kept, ' '//plain_name(attributes(i)%text)//' ') == 0) cycle
            call append_text(element%attributes, plain_name(attributes(i)%text))
            call append_text(element%attributes, attributes(i + 1)%text)
         end do
      end associate
      tree%open = tree%n
   end subroutine open_element

   !> The element that is open ends.
   subroutine close_element(tree)
      type(xml_tree_type), intent(inout) :: tree
      if (tree%open == 0) return
      associate (element => tree%elements(tree%open))
         element%text = trimmed(element%text)
         tree%open = element%parent
      end associate
   end subroutine close_element

   !> A name in lower case, without the prefix of its name space.
   pure function plain_name(name) result(plain)
      character(*), intent(in) :: name
      character(:), allocatable :: plain
      plain = lower_case(name(index(name, ':', back=.true.) + 1:))
   end function plain_name

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

   !> Text of the element at a path; '' where it is absent.
   pure function text_at(tree, i, path) result(text)
      type(xml_tree_type), intent(in) :: tree
      integer, intent(in) :: i
      character(*), intent(in) :: path
      character(:), allocatable :: text
      integer :: k
      text = ''
      k = child(tree, i, path)
      if (k > 0) text = tree%elements(k)%text
   end function text_at

   !> A text without blanks, tabs and ends of lines at its ends.
   pure function trimmed(text) result(bare)
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      character(*), parameter :: blanks = ' '//achar(9)//achar(10)//achar(13)
      bare = ''
      if (verify(text, blanks) > 0) bare = text(verify(text, blanks):verify(text, blanks, back=.true.))
   end function trimmed
end module dg_xml_tree

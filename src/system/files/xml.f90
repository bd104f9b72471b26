!> Reads XML into a tree by expat, a library that is looked for at run time: nothing needs it to build or to start.
!>
!> A document type is refused, and with it every entity of its own. Nothing is fetched. Elements may be `deepest` deep, and
!> of the characters in one `most_text` are kept.
module dg_xml
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_f_procpointer, c_funloc, c_funptr, c_int, c_loc, &
                                          c_long, c_null_ptr, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_c_calls, only: c_dlsym
   use dg_system_reason, only: from_c_text
   use dg_text, only: c_text, text_type, to_text
   use dg_xml_tree, only: close_element, open_element, xml_tree_type
   implicit none
   private
   public :: read_tree

   !> Data of the functions that expat calls.
   type :: context_type
      type(xml_tree_type), pointer :: tree => null()
      type(c_ptr) :: parser = c_null_ptr
      procedure(c_stop_parser), pointer, nopass :: stop => null()
      procedure(c_line_number), pointer, nopass :: line => null()
      integer :: depth = 0                         !< elements that are open
      character(:), allocatable :: refused         !< why reading was stopped
   end type context_type

   integer, parameter :: deepest = 100, most_text = 1000, block_length = 65536
   !> Elements that are kept of a document: 15,000 stations have 400,000.
   integer, parameter :: most_elements = 4000000, first_room = 1024
   character(*), parameter :: library = 'libexpat.so.1'

   abstract interface
      function c_create_parser(encoding) result(parser) bind(c)
         import :: c_ptr
         implicit none
         type(c_ptr), value :: encoding
         type(c_ptr) :: parser
      end function c_create_parser
      subroutine c_set_data(parser, data) bind(c)
         import :: c_ptr
         implicit none
         type(c_ptr), value :: parser, data
      end subroutine c_set_data
      subroutine c_set_two(parser, first, second) bind(c)
         import :: c_funptr, c_ptr
         implicit none
         type(c_ptr), value :: parser
         type(c_funptr), value :: first, second
      end subroutine c_set_two
      subroutine c_set_one(parser, handler) bind(c)
         import :: c_funptr, c_ptr
         implicit none
         type(c_ptr), value :: parser
         type(c_funptr), value :: handler
      end subroutine c_set_one
      function c_parse(parser, text, length, last) result(status) bind(c)
         import :: c_char, c_int, c_ptr
         implicit none
         type(c_ptr), value :: parser
         character(kind=c_char), intent(in) :: text(*)
         integer(c_int), value :: length, last
         integer(c_int) :: status
      end function c_parse
      function c_error_code(parser) result(code) bind(c)
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: parser
         integer(c_int) :: code
      end function c_error_code
      function c_error_text(code) result(text) bind(c)
         import :: c_int, c_ptr
         implicit none
         integer(c_int), value :: code
         type(c_ptr) :: text
      end function c_error_text
      function c_line_number(parser) result(line) bind(c)
         import :: c_long, c_ptr
         implicit none
         type(c_ptr), value :: parser
         integer(c_long) :: line
      end function c_line_number
      subroutine c_free_parser(parser) bind(c)
         import :: c_ptr
         implicit none
         type(c_ptr), value :: parser
      end subroutine c_free_parser
      function c_stop_parser(parser, resumable) result(status) bind(c)
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: parser
         integer(c_int), value :: resumable
         integer(c_int) :: status
      end function c_stop_parser
   end interface

   interface
      function c_dlopen(path, mode) result(handle) bind(c, name='dlopen')
         import :: c_char, c_int, c_ptr
         implicit none
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
         type(c_ptr) :: handle
      end function c_dlopen
   end interface

contains

   !> Reads chosen elements of the document `path`, with all in them. `failure` says what is wrong, with the line; else ''.
   subroutine read_tree(path, chosen, kept, tree, failure)
      character(*), intent(in) :: path
      character(*), intent(in) :: chosen           !< names of elements in lower case, a blank between two
      character(*), intent(in) :: kept             !< the same of attributes
      type(xml_tree_type), target, intent(out) :: tree
      character(:), allocatable, intent(out) :: failure
      type(context_type), target :: context
      type(c_ptr) :: handle
      procedure(c_create_parser), pointer :: create
      procedure(c_set_data), pointer :: set_data
      procedure(c_set_two), pointer :: set_elements
      procedure(c_set_one), pointer :: set_characters, set_doctype
      procedure(c_stop_parser), pointer :: stop_parser
      procedure(c_line_number), pointer :: line_number
      integer(c_int), parameter :: lazy = 1
      failure = ''
      allocate (tree%elements(first_room))
      tree%chosen = ' '//chosen//' '
      tree%kept = ' '//kept//' '
      handle = c_dlopen(c_text(library), lazy)
      if (.not. c_associated(handle)) then
         failure = 'is XML, and '//library//', which reads it, is not on this machine. Install it (package libexpat1), '// &
                   'or export the survey as CSV'
         return
      end if
      call c_f_procpointer(address_of(handle, 'XML_ParserCreate'), create)
      call c_f_procpointer(address_of(handle, 'XML_SetUserData'), set_data)
      call c_f_procpointer(address_of(handle, 'XML_SetElementHandler'), set_elements)
      call c_f_procpointer(address_of(handle, 'XML_SetCharacterDataHandler'), set_characters)
      call c_f_procpointer(address_of(handle, 'XML_SetStartDoctypeDeclHandler'), set_doctype)
      call c_f_procpointer(address_of(handle, 'XML_StopParser'), stop_parser)
      call c_f_procpointer(address_of(handle, 'XML_GetCurrentLineNumber'), line_number)
      context%stop => stop_parser
      context%line => line_number
      context%tree => tree
      context%refused = ''
      context%parser = create(c_null_ptr)
      call set_data(context%parser, c_loc(context))
      call set_elements(context%parser, c_funloc(element_begins), c_funloc(element_ends))
      call set_characters(context%parser, c_funloc(characters_come))
      call set_doctype(context%parser, c_funloc(doctype_comes))
      call parse_file(handle, path, context, failure)
   end subroutine read_tree

   !> A function of the library; it has every one of them since 2001.
   function address_of(handle, name) result(address)
      type(c_ptr), intent(in) :: handle
      character(*), intent(in) :: name
      type(c_funptr) :: address
      address = transfer(c_dlsym(handle, c_text(name)), address)
   end function address_of

   !> Gives the file to the parser, piece by piece, and frees it.
   subroutine parse_file(handle, path, context, failure)
      type(c_ptr), intent(in) :: handle
      character(*), intent(in) :: path
      type(context_type), intent(inout) :: context
      character(:), allocatable, intent(inout) :: failure
      procedure(c_parse), pointer :: parse
      procedure(c_error_code), pointer :: error_code
      procedure(c_error_text), pointer :: error_text
      procedure(c_free_parser), pointer :: free
      integer(c_int), parameter :: failed = 0
      character(block_length), allocatable :: block
      character(256) :: message
      integer(c_int) :: status
      integer(int64) :: bytes
      integer :: unit, length, line, opened
      open (newunit=unit, file=path, status='old', action='read', access='stream', form='unformatted', iostat=opened, &
            iomsg=message)
      if (opened /= 0) then
         failure = 'cannot be opened ('//trim(message)//')'
         return
      end if
      inquire (unit=unit, size=bytes)
      allocate (block)
      call c_f_procpointer(address_of(handle, 'XML_Parse'), parse)
      call c_f_procpointer(address_of(handle, 'XML_GetErrorCode'), error_code)
      call c_f_procpointer(address_of(handle, 'XML_ErrorString'), error_text)
      call c_f_procpointer(address_of(handle, 'XML_ParserFree'), free)
      status = 1
      do while (bytes > 0 .and. status /= failed)
         length = int(min(bytes, int(block_length, int64)))
         read (unit, iostat=opened) block(:length)
         bytes = merge(bytes - length, 0_int64, opened == 0)
         status = parse(context%parser, block, int(length, c_int), merge(1_c_int, 0_c_int, bytes == 0))
      end do
      close (unit)
      if (status == failed) then
         line = int(context%line(context%parser))
         if (context%refused /= '') then
            failure = context%refused
         else
            failure = 'is not valid XML: '//from_c_text(error_text(error_code(context%parser)))
         end if
         failure = failure//' (line '//to_text(line)//')'
      end if
      call free(context%parser)
   end subroutine parse_file

   !> Called by expat.
   subroutine element_begins(data, name, attributes) bind(c)
      type(c_ptr), value :: data, name
      type(c_ptr), intent(in) :: attributes(*)      !< name, value, ..., null
      type(context_type), pointer :: context
      type(text_type), allocatable :: pairs(:)
      integer :: i, n
      call c_f_pointer(data, context)
      if (context%refused /= '') return
      if (context%depth == deepest) call refuse(context, 'has elements in each other deeper than '//to_text(deepest))
      if (context%tree%n == most_elements) call refuse(context, 'has more than '//to_text(most_elements)//' elements of a case')
      if (context%refused /= '') return
      n = 0
      do while (c_associated(attributes(n + 1)))
         n = n + 1
      end do
      allocate (pairs(n))
      do i = 1, n
         pairs(i)%text = from_c_text(attributes(i))
      end do
      context%depth = context%depth + 1
      call open_element(context%tree, from_c_text(name), pairs, int(context%line(context%parser)))
   end subroutine element_begins

   !> Called by expat.
   subroutine element_ends(data, name) bind(c)
      type(c_ptr), value :: data, name
      type(context_type), pointer :: context
      call c_f_pointer(data, context)
      if (context%refused /= '' .or. .not. c_associated(name)) return
      call close_element(context%tree)
      context%depth = context%depth - 1
   end subroutine element_ends

   !> Called by expat, several times for one text.
   subroutine characters_come(data, text, length) bind(c)
      type(c_ptr), value :: data
      character(kind=c_char), intent(in) :: text(*)
      integer(c_int), value :: length
      type(context_type), pointer :: context
      integer :: taken
      call c_f_pointer(data, context)
      if (context%refused /= '' .or. context%tree%open == 0) return
      associate (kept => context%tree%elements(context%tree%open))
         taken = min(int(length), most_text - len(kept%text))
         kept%text = kept%text//transfer(text(:taken), repeat(' ', taken))
      end associate
   end subroutine characters_come

   !> Called by expat.
   subroutine doctype_comes(data, name, system_id, public_id, has_subset) bind(c)
      type(c_ptr), value :: data, name, system_id, public_id
      integer(c_int), value :: has_subset
      type(context_type), pointer :: context
      call c_f_pointer(data, context)
      if (.not. c_associated(name)) return
      if (c_associated(system_id) .or. c_associated(public_id) .or. has_subset /= 0) &
         call refuse(context, 'has a document type (DTD), which is not read')
   end subroutine doctype_comes

   !> Stops the parser.
   subroutine refuse(context, why)
      type(context_type), intent(inout) :: context
      character(*), intent(in) :: why
      integer(c_int) :: status
      context%refused = why
      status = context%stop(context%parser, 0_c_int)
      if (status == 0) return      ! it has stopped already
   end subroutine refuse
end module dg_xml

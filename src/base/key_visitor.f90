!> A visit to the numbers of a type by their keys. Each type of a model names its keys once, beside its components, in a procedure
!> `visit_...`. Who reads a deck, checks ranges or writes a record extends `key_visitor_type`.
module dg_key_visitor
   use dg_kinds, only: wp
   use dg_missing, only: given, is_mark, missing, optional_real
   implicit none
   private
   public :: key_visitor_type

   type, abstract :: key_visitor_type
   contains
      procedure(number_interface), deferred :: number
      procedure :: number_or_missing
      procedure :: whole
      procedure :: optional
   end type key_visitor_type

   abstract interface
      !> One number with its key. The visitor may change it.
      subroutine number_interface(self, key, value)
         import :: key_visitor_type, wp
         implicit none
         class(key_visitor_type), intent(inout) :: self
         character(*), intent(in) :: key
         real(wp), intent(inout) :: value              !< [SI]
      end subroutine number_interface
   end interface

contains

   !> A number that may be missing, and is not visited then. Who reads numbers overrides this.
   subroutine number_or_missing(self, key, value)
      class(key_visitor_type), intent(inout) :: self
      character(*), intent(in) :: key
      real(wp), intent(inout) :: value              !< [SI]
      if (.not. is_mark(value)) call self%number(key, value)
   end subroutine number_or_missing

   !> A whole number.
   subroutine whole(self, key, value)
      class(key_visitor_type), intent(inout) :: self
      character(*), intent(in) :: key
      integer, intent(inout) :: value
      real(wp) :: number
      number = real(value, wp)
      call self%number(key, number)
      value = nint(number)
   end subroutine whole

   !> A number that may be absent.
   subroutine optional(self, key, value)
      class(key_visitor_type), intent(inout) :: self
      character(*), intent(in) :: key
      type(optional_real), intent(inout) :: value
      real(wp) :: number
      number = missing
      if (value%present) number = value%value
      call self%number_or_missing(key, number)
      if (.not. is_mark(number)) value = given(number)
   end subroutine optional
end module dg_key_visitor

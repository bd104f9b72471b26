!> What checks find wrong in a model, gathered. Who asked adds where it stands: a deck its file and line, a program the name of
!> the part. A message that names a second part leaves a place for that, too.
module dg_model_fault
   use dg_kinds, only: wp
   use dg_unit_kind, only: in_units, unit_diameter, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: model_fault_type, model_faults_type, note_fault, fault_words, depth_words, diameter_words
   public :: depth_digits, length_digits, diameter_digits

   !> Digits of depths, of other lengths, and of diameters in messages.
   integer, parameter :: depth_digits = 9, length_digits = 7, diameter_digits = 6

   type :: model_fault_type
      ! Texts have no values here: with -finit-derived gfortran 12 writes a .mod file of them that it cannot read.
      character(12) :: part                   !< what is wrong: the name of its group in a deck
      integer :: place = 0                    !< of the part among those of its kind, as the caller counts them; 0: the kind has one
      character(32) :: key                    !< which of its quantities: the key in a deck
      character(:), allocatable :: message    !< as far as where the other part is named; all of it where none is
      character(12) :: other                  !< kind of the part that the message names besides; '': none
      integer :: other_place = 0
      character(:), allocatable :: rest       !< of the message, behind the name of the other part
   end type model_fault_type

   type :: model_faults_type
      integer :: count = 0
      type(model_fault_type), allocatable :: items(:)   !< the first `count` are meant
   end type model_faults_type

   integer, parameter :: first_capacity = 8

contains

   !> Notes one fault; `other`, `other_place` and `rest` go together.
   pure subroutine note_fault(found, part, place, key, message, other, other_place, rest)
      type(model_faults_type), intent(inout) :: found
      character(*), intent(in) :: part
      integer, intent(in) :: place
      character(*), intent(in) :: key, message
      character(*), intent(in), optional :: other
      integer, intent(in), optional :: other_place
      character(*), intent(in), optional :: rest
      type(model_fault_type), allocatable :: longer(:)
      if (.not. allocated(found%items)) allocate (found%items(first_capacity))
      if (found%count == size(found%items)) then
         allocate (longer(2*found%count))
         longer(:found%count) = found%items
         call move_alloc(longer, found%items)
      end if
      found%count = found%count + 1
      associate (fault => found%items(found%count))
         fault%part = part
         fault%place = place
         fault%key = key
         fault%message = message
         fault%other = ''
         fault%rest = ''
         if (present(other)) fault%other = other
         if (present(other_place)) fault%other_place = other_place
         if (present(rest)) fault%rest = rest
      end associate
   end subroutine note_fault

   !> The whole message; `mention` is what the caller calls the other part: 'line 12', 'holes(2)'.
   pure subroutine fault_words(fault, mention, words)
      type(model_fault_type), intent(in) :: fault
      character(*), intent(in) :: mention
      character(:), allocatable, intent(out) :: words
      words = fault%message
      if (fault%other /= '') words = words//mention
      words = words//fault%rest
   end subroutine fault_words

   !> A depth with its unit.
   pure function depth_words(units, depth) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: depth          !< [m]
      character(:), allocatable :: text
      text = trim(in_units(units, unit_length, depth, depth_digits))
   end function depth_words

   !> A diameter with its unit.
   pure function diameter_words(units, diameter, digits) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: diameter       !< [m]
      integer, intent(in) :: digits
      character(:), allocatable :: text
      text = trim(in_units(units, unit_diameter, diameter, digits))
   end function diameter_words
end module dg_model_fault

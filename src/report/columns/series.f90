!> Columns with all their values: results along the string, contacts, iterations. One statement puts a column into a list: name,
!> quantity, meaning and values.
module dg_series
   use dg_kinds, only: wp
   use dg_column, only: column_type, add, add_filled, row_type, unknown_column
   use dg_missing, only: is_missing, missing
   use dg_text, only: text_type
   implicit none
   private
   public :: series_list_type, add, series_of, row_of, value_count

   !> A column and its values: numbers, counts, or states by number.
   type :: series_type
      type(column_type) :: column
      real(wp), allocatable :: numbers(:)                !< in SI units, missing where there is none
      logical :: is_whole = .false.                      !< numbers are counts
      integer, allocatable :: states(:)                  !< numbers of words
      type(text_type), allocatable :: words(:)           !< (0:), by number
   end type series_type

   !> Columns in their order, with as many values each.
   type :: series_list_type
      integer :: count = 0
      type(series_type), allocatable :: items(:)         !< with room for more
   end type series_list_type

   !> Add the next column of a list (or of a row).
   interface add
      module procedure add_numbers, add_counts, add_states, add_named
   end interface add

contains

   !> The column of that name. An unknown name ends the program: it is a fault in the sources.
   function series_of(list, name) result(series)
      type(series_list_type), intent(in) :: list
      character(*), intent(in) :: name
      type(series_type) :: series
      integer :: i
      i = findloc(list%items(:list%count)%column%name == name, .true., dim=1)
      if (i == 0) call unknown_column(name)
      series = list%items(i)
   end function series_of

   !> Values of each column of a list.
   pure function value_count(list) result(number)
      type(series_list_type), intent(in) :: list
      integer :: number
      number = 0
      if (list%count == 0) return
      if (allocated(list%items(1)%states)) number = size(list%items(1)%states)
      if (allocated(list%items(1)%numbers)) number = size(list%items(1)%numbers)
   end function value_count

   !> A row of numbers and words.
   pure function row_of(list, number) result(row)
      type(series_list_type), intent(in) :: list
      integer, intent(in) :: number
      type(row_type) :: row
      integer :: i
      allocate (row%fields(list%count))
      do i = 1, list%count
         associate (series => list%items(i), column => list%items(i)%column)
            if (allocated(series%states)) then
               call add_filled(row, column%name, column%quantity, column%meaning, series%words(series%states(number))%text)
            else if (series%is_whole .and. .not. is_missing(series%numbers(number))) then
               call add(row, column%name, column%quantity, column%meaning, nint(series%numbers(number)))
            else
               call add(row, column%name, column%quantity, column%meaning, series%numbers(number))
            end if
         end associate
      end do
   end function row_of

   !> Add a column without values.
   pure subroutine add_column(list, name, quantity, meaning)
      type(series_list_type), intent(inout) :: list
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      type(series_type), allocatable :: longer(:)
      integer :: i
      if (.not. allocated(list%items)) allocate (list%items(64))
      if (list%count == size(list%items)) then
         allocate (longer(2*list%count))
         do i = 1, list%count
            longer(i) = list%items(i)
         end do
         call move_alloc(longer, list%items)
      end if
      list%count = list%count + 1
      list%items(list%count)%column = column_type(name, quantity, meaning)
   end subroutine add_column

   pure subroutine add_numbers(list, name, quantity, meaning, values)
      type(series_list_type), intent(inout) :: list
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      real(wp), intent(in) :: values(:)      !< in SI units, missing where there is none
      call add_column(list, name, quantity, meaning)
      list%items(list%count)%numbers = values
   end subroutine add_numbers

   pure subroutine add_counts(list, name, quantity, meaning, values)
      type(series_list_type), intent(inout) :: list
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      integer, intent(in) :: values(:)       !< missing_count where there is none
      call add_column(list, name, quantity, meaning)
      list%items(list%count)%is_whole = .true.
      list%items(list%count)%numbers = merge(missing, real(values, wp), is_missing(values))
   end subroutine add_counts

   pure subroutine add_states(list, name, quantity, meaning, values, words)
      type(series_list_type), intent(inout) :: list
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      integer, intent(in) :: values(:)
      character(*), intent(in) :: words(0:)  !< by value
      type(text_type) :: texts(0:ubound(words, 1))
      integer :: i
      do i = 0, ubound(words, 1)
         texts(i)%text = trim(words(i))
      end do
      call add_named(list, name, quantity, meaning, values, texts)
   end subroutine add_states

   !> States by number, or names, as the numbers of components.
   pure subroutine add_named(list, name, quantity, meaning, values, words)
      type(series_list_type), intent(inout) :: list
      character(*), intent(in) :: name
      integer, intent(in) :: quantity
      character(*), intent(in) :: meaning
      integer, intent(in) :: values(:)
      type(text_type), intent(in) :: words(0:)  !< by value
      call add_column(list, name, quantity, meaning)
      list%items(list%count)%states = values
      allocate (list%items(list%count)%words(0:ubound(words, 1)), source=words)
   end subroutine add_named
end module dg_series

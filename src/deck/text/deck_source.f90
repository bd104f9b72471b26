!> Source of the lines of a deck: a file, or standard input under the name '-'.
module dg_deck_source
   use dg_file_lines, only: read_lines
   use dg_text, only: lower_case, text_type
   implicit none
   private
   public :: default_folder, input_path, read_source

   !> Name of a deck on the command line that comes from standard input.
   character(*), parameter :: dash = '-'
   !> Its name in messages. It has no folder: paths in the deck are relative to the working folder.
   character(*), parameter :: dash_name = 'standard input'
   character(*), parameter :: dash_file = '/dev/stdin'

contains

   !> Read the lines of a deck. `failure` is '' or the reason why `lines` is empty.
   subroutine read_source(deck, name, lines, failure)
      character(*), intent(in) :: deck                       !< as on the command line
      character(:), allocatable, intent(out) :: name         !< of the deck in messages; paths are relative to its folder
      type(text_type), allocatable, intent(out) :: lines(:)
      character(:), allocatable, intent(out) :: failure
      name = deck
      if (deck == dash) name = dash_name
      call read_lines(input_path(name), lines, failure, piped=.true.)
   end subroutine read_source

   !> File that holds the deck of a name.
   pure function input_path(name) result(path)
      character(*), intent(in) :: name
      character(:), allocatable :: path
      path = name
      if (name == dash_name) path = dash_file
   end function input_path

   !> Folder of results where the deck names none: output/<name of the deck without .nml>; '' of standard input.
   pure function default_folder(name) result(folder)
      character(*), intent(in) :: name
      character(:), allocatable :: folder
      folder = ''
      if (name == dash_name) return
      folder = name(index(name, '/', back=.true.) + 1:)
      if (len(folder) > 4) then
         if (lower_case(folder(len(folder) - 3:)) == '.nml') folder = folder(:len(folder) - 4)
      end if
      folder = 'output/'//folder
   end function default_folder
end module dg_deck_source

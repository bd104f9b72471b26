!> The pictures of a run as their scripts are written: names, what they show in words and in numbers, which are there.
module dg_picture_list
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type
   use dg_picture_data, only: picture_data_type
   use dg_result_name, only: picture_folder
   use dg_text, only: text_type, to_text
   use dg_written_files, only: note_file
   implicit none
   private
   public :: picture_type, picture_list_type, add_picture, free_name, folder_in, new_picture

   type :: picture_type
      character(:), allocatable :: name     !< of the files, without ending
      character(:), allocatable :: caption
      integer :: case_index = 0             !< load case that it belongs to; 0: the run
      logical :: drawn = .false.            !< it is there, not only its script
      type(picture_data_type) :: data       !< what it shows, in numbers
   end type picture_type

   type :: picture_list_type
      type(picture_type), allocatable :: pictures(:)
      logical :: no_gnuplot = .false.
   end type picture_list_type

contains

   !> A name that no picture has: the wanted one, or that with the next number.
   function free_name(list, wanted) result(name)
      type(picture_list_type), intent(in) :: list
      character(*), intent(in) :: wanted
      character(:), allocatable :: name
      integer :: n, i
      name = wanted
      n = 1
      do while (any([(list%pictures(i)%name == name, i=1, size(list%pictures))]))
         n = n + 1
         name = wanted//'_'//to_text(n)
      end do
   end function free_name

   !> Writes a script and enters its picture. Where there is an error already, nothing is done; a script that cannot be written is
   !> an error.
   subroutine add_picture(list, job, picture, lines, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(picture_type), intent(in) :: picture
      type(text_type), intent(in) :: lines(:)
      type(error_type), allocatable, intent(inout) :: error
      type(picture_type), allocatable :: longer(:)
      integer :: n
      if (allocated(error)) return
      call note_file(job%output_dir, picture_folder//'/'//picture%name//'.gp', error)
      if (.not. allocated(error)) call note_file(job%output_dir, picture_folder//'/'//picture%name//'.svg', error)
      if (.not. allocated(error)) call write_text_file(folder_in(job)//'/'//picture%name//'.gp', lines, error)
      n = size(list%pictures)
      allocate (longer(n + 1))
      longer(:n) = list%pictures
      longer(n + 1) = picture
      call move_alloc(longer, list%pictures)
   end subroutine add_picture

   !> A picture that is not drawn yet.
   pure function new_picture(name, caption, case_index, data) result(picture)
      character(*), intent(in) :: name, caption
      integer, intent(in) :: case_index
      type(picture_data_type), intent(in) :: data
      type(picture_type) :: picture
      picture%name = name
      picture%caption = caption
      picture%case_index = case_index
      picture%data = data
   end function new_picture

   !> Folder of the pictures of a run.
   pure function folder_in(job) result(path)
      type(job_type), intent(in) :: job
      character(:), allocatable :: path
      path = job%output_dir//'/'//picture_folder
   end function folder_in
end module dg_picture_list

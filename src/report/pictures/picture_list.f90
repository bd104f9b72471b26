!> The pictures of a run as their scripts are written: names, captions, numbers, and whether they are drawn.
module dg_picture_list
   use dg_chart, only: chart_type, is_empty
   use dg_column, only: row_type
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_gnuplot_script, only: chart_script
   use dg_job, only: job_type
   use dg_picture_data, only: picture_data_type
   use dg_result_name, only: picture_folder
   use dg_text, only: text_or_nothing, text_type, to_text
   use dg_written_files, only: note_file
   implicit none
   private
   public :: picture_type, picture_list_type, add_picture, folder_in

   type :: picture_type
      character(:), allocatable :: name     !< of the files, without ending
      character(:), allocatable :: caption
      character(:), allocatable :: title    !< caption, what the chart is of, title of the run
      integer :: case_index = 0             !< load case that it belongs to; 0: the run
      logical :: drawn = .false.            !< it is there, not only its script
      type(picture_data_type) :: data       !< what it shows, in numbers
      type(chart_type), allocatable :: chart   !< of a picture of the run: the page draws it
   end type picture_type

   type :: picture_list_type
      type(picture_type), allocatable :: pictures(:)
      character(:), allocatable :: empty    !< words of charts without a point, which are not drawn, '; ' between them
      logical :: no_gnuplot = .false.
   end type picture_list_type

contains

   !> Writes the script of a chart and enters its picture, under another name where one has its own; of an empty chart its words
   !> alone. Where there is an error already, nothing is done; a script that cannot be written is an error.
   subroutine add_picture(list, job, chart, caption, case_index, data, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(chart_type), intent(in) :: chart
      character(*), intent(in) :: caption
      integer, intent(in) :: case_index
      type(picture_data_type), intent(in) :: data
      type(error_type), allocatable, intent(inout) :: error
      type(picture_type), allocatable :: longer(:)
      type(chart_type) :: named
      type(chart_type), allocatable :: kept
      type(text_type), allocatable :: lines(:)
      type(row_type), allocatable :: rows(:)
      character(:), allocatable :: words
      integer :: n, i, number
      if (allocated(error)) return
      words = caption
      if (chart%title /= caption) words = words//'. '//chart%title
      if (is_empty(chart)) then
         if (list%empty /= '') list%empty = list%empty//'; '
         list%empty = list%empty//words
         return
      end if
      named = chart
      number = 1
      n = size(list%pictures)
      do while (any([(list%pictures(i)%name == named%name, i=1, n)]))
         number = number + 1
         named%name = chart%name//'_'//to_text(number)
      end do
      call chart_script(named, lines)
      call note_file(job%output_dir, picture_folder//'/'//named%name//'.gp', error)
      if (.not. allocated(error)) call note_file(job%output_dir, picture_folder//'/'//named%name//'.svg', error)
      if (.not. allocated(error)) call write_text_file(folder_in(job)//'/'//named%name//'.gp', lines, error)
      allocate (longer(n + 1))
      do i = 1, n
         ! many rows and points: not copied for each picture that is added
         call move_alloc(list%pictures(i)%data%rows, rows)
         call move_alloc(list%pictures(i)%chart, kept)
         longer(i) = list%pictures(i)
         call move_alloc(rows, longer(i)%data%rows)
         call move_alloc(kept, longer(i)%chart)
      end do
      longer(n + 1)%name = named%name
      longer(n + 1)%caption = caption
      longer(n + 1)%title = words
      if (text_or_nothing(job%title) /= '') longer(n + 1)%title = words//'. '//job%title
      longer(n + 1)%case_index = case_index
      longer(n + 1)%data = data
      if (case_index == 0) longer(n + 1)%chart = chart
      call move_alloc(longer, list%pictures)
   end subroutine add_picture

   !> Folder of the pictures of a run.
   pure function folder_in(job) result(path)
      type(job_type), intent(in) :: job
      character(:), allocatable :: path
      path = job%output_dir//'/'//picture_folder
   end function folder_in
end module dg_picture_list

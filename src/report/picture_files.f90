!> The pictures of a run: writes a gnuplot script for each into the folder `pictures` of the output folder, has gnuplot draw
!> them, and tells which are there. Without gnuplot the scripts stay, to be drawn elsewhere.
module dg_picture_files
   use dg_along_string, only: along_string_type
   use dg_calibration_picture, only: calibration_script
   use dg_case_pictures, only: forces_script, path_script
   use dg_case_result, only: case_result_type, result_converged
   use dg_error, only: error_type, raise, status_failure
   use dg_file_system, only: delete_file, write_text_file
   use dg_folder, only: make_folder
   use dg_hookload_picture, only: hookload_script
   use dg_job, only: job_type, model_mcge, model_name
   use dg_legacy_picture, only: legacy_script
   use dg_model, only: model_type
   use dg_study_picture, only: study_script
   use dg_sweep_picture, only: sweep_script
   use dg_uncertainty_picture, only: uncertainty_script
   use dg_text, only: is_separator_free, text_type, to_text
   implicit none
   private
   public :: picture_type, picture_list_type, picture_folder, write_pictures, folder_in

   !> Folder of scripts and pictures, within the output folder.
   character(*), parameter :: picture_folder = 'pictures'
   !> What the shell is told to answer where there is no gnuplot (EX_UNAVAILABLE of sysexits.h; its own 127 counts as a command
   !> that could not be run at all).
   integer, parameter :: status_no_gnuplot = 69
   !> Where gnuplot complains, within that folder; kept only where it failed.
   character(*), parameter :: complaint_file = 'gnuplot.log'
   !> Script that draws all.
   character(*), parameter :: whole_script = 'all'

   type :: picture_type
      character(:), allocatable :: name     !< of the files, without ending
      character(:), allocatable :: caption
      integer :: case_index = 0             !< load case that it belongs to; 0: the run
   end type picture_type

   type :: picture_list_type
      type(picture_type), allocatable :: pictures(:)
      logical :: drawn = .false.            !< the pictures are there, not only their scripts
      logical :: no_gnuplot = .false.
   end type picture_list_type

contains

   !> Writes and draws all. `error` where a script cannot be written or gnuplot fails; a missing gnuplot is none.
   subroutine write_pictures(job, model, results, alongs, list, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(picture_list_type), intent(out) :: list
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name, left_out
      integer, allocatable :: rows(:)
      integer :: i, k
      allocate (list%pictures(0))
      call make_folder(folder_in(job), error)
      if (allocated(error)) return
      if (size(results) > 0) then
         call hookload_script('hookload', job, model, results, lines)
         call add('hookload', 'Hook load of all cases', 0)
      end if
      if (allocated(job%sweeps)) then
         do i = 1, size(job%sweeps)
            associate (sweep => job%sweeps(i))
               do k = 1, size(sweep%models)
                  name = 'sweep_'//sweep%name//'_'//trim(model_name(sweep%models(k)))
                  call sweep_script(name, job%units, sweep, sweep%models(k), lines)
                  call add(name, 'Hook load and torque against bit depth, sweep '//sweep%name//', model '// &
                           trim(model_name(sweep%models(k))), 0)
               end do
            end associate
         end do
      end if
      if (allocated(job%calibrations)) then
         do i = 1, size(job%calibrations)
            associate (calibration => job%calibrations(i))
               do k = 1, size(calibration%models)
                  name = to_text(i)             ! where its name is none for a file
                  if (is_separator_free(calibration%name)) name = calibration%name
                  name = 'calibration_'//name//'_'//trim(model_name(calibration%models(k)))
                  call calibration_script(name, job, model, i, k, lines)
                  call add(name, 'Friction found from measurements, and the error before and after', 0)
               end do
            end associate
         end do
      end if
      if (allocated(job%uncertainties)) then
         do i = 1, size(job%uncertainties)
            associate (range => job%uncertainties(i)%range)
               do k = 1, size(range%models)
                  name = 'uncertainty_'//range%name//'_'//trim(model_name(range%models(k)))
                  call uncertainty_script(name, job%units, range, range%models(k), lines)
                  call add(name, 'What uncertain data make of hook load and torque', 0)
               end do
            end associate
         end do
      end if
      if (allocated(job%study)) then
         do k = 1, size(job%study%cases)
            associate (load_case => model%cases(job%study%cases(k)))
               call study_script('study_'//load_case%name, job, load_case, job%study, lines)
               call add('study_'//load_case%name, 'Error against the finest way to compute it, and what it costs', &
                        job%study%cases(k))
            end associate
         end do
      end if
      if (allocated(job%legacy)) then
         do i = 1, size(job%legacy)
            associate (table => job%legacy(i))
               call legacy_script('legacy_'//table%label, job, table, model%cases(table%case_index)%name, lines)
               call add('legacy_'//table%label, 'Our results and those of '//table%label, table%case_index)
            end associate
         end do
      end if
      do i = 1, size(model%cases)
         if (.not. job%profiles) exit       ! the files that these draw from
         rows = pack([(k, k=1, size(results))], results%case_index == i .and. results%status == result_converged)
         rows = pack(rows, [(allocated(results(rows(k))%profile%md), k=1, size(rows))])
         if (size(rows) == 0) cycle         ! numbers that are no solution are not drawn
         left_out = ''
         do k = 1, size(results)
            if (results(k)%case_index == i .and. .not. any(rows == k)) left_out = left_out//' '//trim(model_name(results(k)%model))
         end do
         name = model%cases(i)%name
         ! contact is what gap elements find; of other models the first
         k = rows(max(1, findloc(results(rows)%model == model_mcge, .true., dim=1)))
         call path_script('path_'//name, job, model%cases(i), results(k), lines)
         call add('path_'//name, 'Well path with contact of the string', i)
         call forces_script('forces_'//name, job, model%cases(i), results(rows), alongs(rows), left_out, lines)
         call add('forces_'//name, 'Along the string', i)
      end do
      if (.not. allocated(error)) call draw(job, list, error)

   contains

      !> Writes the script and enters the picture.
      subroutine add(name, caption, case_index)
         character(*), intent(in) :: name, caption
         integer, intent(in) :: case_index
         type(picture_type), allocatable :: longer(:)
         integer :: n
         if (allocated(error)) return
         call write_text_file(folder_in(job)//'/'//name//'.gp', lines, error)
         n = size(list%pictures)
         allocate (longer(n + 1))
         longer(:n) = list%pictures
         longer(n + 1)%name = name
         longer(n + 1)%caption = caption
         longer(n + 1)%case_index = case_index
         call move_alloc(longer, list%pictures)
      end subroutine add
   end subroutine write_pictures

   !> Has one gnuplot draw all scripts. Pictures of an earlier run go first, so that what is there is of this one.
   subroutine draw(job, list, error)
      type(job_type), intent(in) :: job
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: scripts(size(list%pictures))
      character(:), allocatable :: command
      integer :: i, status, command_status
      logical :: is
      do i = 1, size(list%pictures)
         call delete_file(folder_in(job)//'/'//list%pictures(i)%name//'.svg')
         scripts(i)%text = "load '"//list%pictures(i)%name//".gp'"
      end do
      call write_text_file(folder_in(job)//'/'//whole_script//'.gp', scripts, error)
      if (allocated(error)) return
      command = 'cd -- '//for_shell(folder_in(job))//' && { command -v gnuplot >/dev/null 2>&1 || exit '// &
         to_text(status_no_gnuplot)//'; } && exec gnuplot '//whole_script//'.gp >'//complaint_file//' 2>&1 </dev/null'
      call execute_command_line(command, exitstat=status, cmdstat=command_status)
      list%no_gnuplot = command_status == 0 .and. status == status_no_gnuplot
      if (list%no_gnuplot) return
      list%drawn = command_status == 0 .and. status == 0
      do i = 1, size(list%pictures)
         inquire (file=folder_in(job)//'/'//list%pictures(i)%name//'.svg', exist=is)
         list%drawn = list%drawn .and. is
      end do
      if (list%drawn) then
         call delete_file(folder_in(job)//'/'//complaint_file)
      else
         call raise(error, status_failure, 'gnuplot failed on the scripts in '//folder_in(job)//'; '//complaint_file// &
                    ' there tells why')
      end if
   end subroutine draw

   pure function folder_in(job) result(path)
      type(job_type), intent(in) :: job
      character(:), allocatable :: path
      path = job%output_dir//'/'//picture_folder
   end function folder_in

   !> A path as one word of a shell's command.
   pure function for_shell(path) result(word)
      character(*), intent(in) :: path
      character(:), allocatable :: word
      integer :: i
      word = "'"
      do i = 1, len(path)
         if (path(i:i) == "'") then
            word = word//"'\''"
         else
            word = word//path(i:i)
         end if
      end do
      word = word//"'"
   end function for_shell
end module dg_picture_files

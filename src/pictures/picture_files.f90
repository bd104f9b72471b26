!> The pictures of a run: writes a gnuplot script for each into the folder `pictures` of the output folder, has gnuplot draw
!> them, and tells which are there. Without gnuplot the scripts stay, to be drawn elsewhere.
module dg_picture_files
   use dg_along_string, only: along_string_type
   use dg_assembly_picture, only: assembly_script, shown_length
   use dg_calibration_picture, only: calibration_script
   use dg_case_result, only: case_result_type, result_converged
   use dg_child_process, only: find_program
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_folder, only: make_folder
   use dg_forces_picture, only: forces_script
   use dg_gnuplot_script, only: spelled
   use dg_hookload_picture, only: hookload_script
   use dg_job, only: job_type, model_mcge, model_name
   use dg_legacy_picture, only: legacy_script
   use dg_model, only: model_type
   use dg_path_picture, only: path_script
   use dg_picture_data, only: file_data, picture_data_type, rows_along, rows_of_contacts
   use dg_picture_drawing, only: complaint_file, draw_pictures, usual_patience
   use dg_result_name, only: case_file, contacts_file, picture_folder, profile_file
   use dg_strength_picture, only: strength_script
   use dg_study_picture, only: study_script
   use dg_sweep_picture, only: sweep_script
   use dg_uncertainty_picture, only: uncertainty_script
   use dg_text, only: is_separator_free, text_type, to_text
   use dg_written_files, only: note_file
   implicit none
   private
   public :: picture_type, picture_list_type, write_pictures, folder_in

   !> Script that draws all, for whoever wants them again.
   character(*), parameter :: whole_script = 'all'

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

   !> Columns of the tables of a case's pictures.
   character(*), parameter :: path_columns(9) = [character(16) :: 'md', 'tvd', 'north', 'east', 'inclination', 'azimuth', &
      'dogleg', 'displacement', 'standoff']
   character(*), parameter :: forces_columns(8) = [character(16) :: 'md', 'axial', 'torque', 'bending', 'side_force', 'clock', &
      'sinusoidal_load', 'buckling_margin']
   character(*), parameter :: strength_columns(8) = [character(16) :: 'md', 'von_mises', 'safety_factor', 'axial_stress', &
      'bending_stress', 'bending_range', 'torsional_stress', 'torque']

contains

   !> Writes and draws all. `error` where a script cannot be written, gnuplot fails or the program is asked to end; a missing
   !> gnuplot is none.
   subroutine write_pictures(job, model, results, alongs, list, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(picture_list_type), intent(out) :: list
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name, left_out, file
      integer, allocatable :: rows(:)
      integer :: i, k
      logical :: apart
      allocate (list%pictures(0))
      call make_folder(folder_in(job), error)
      if (allocated(error)) return
      if (size(results) > 0) then
         call hookload_script('hookload', job, model, results, lines)
         call add('hookload', 'Hook load of all cases', 0, file_data('summary.csv'))
      end if
      if (allocated(job%sweeps)) then
         do i = 1, size(job%sweeps)
            associate (sweep => job%sweeps(i))
               do k = 1, size(sweep%models)
                  name = free_name('sweep_'//sweep%name//'_'//trim(model_name(sweep%models(k))))
                  call sweep_script(name, job%units, sweep, sweep%models(k), model%rig, model%holes, lines)
                  call add(name, 'Hook load and torque against bit depth, sweep '//sweep%name//', model '// &
                           trim(model_name(sweep%models(k))), 0, file_data('sweep_'//sweep%name//'.csv'))
               end do
            end associate
         end do
      end if
      ! a run that joins parts has neither calibrated nor solved anything else
      apart = job%merge > 0
      if (allocated(job%calibrations) .and. .not. apart) then
         do i = 1, size(job%calibrations)
            associate (calibration => job%calibrations(i))
               do k = 1, size(calibration%models)
                  name = to_text(i)             ! where its name is none for a file
                  if (is_separator_free(calibration%name)) name = calibration%name
                  name = free_name('calibration_'//name//'_'//trim(model_name(calibration%models(k))))
                  call calibration_script(name, job, model, i, k, lines)
                  call add(name, 'Friction found from measurements, and the error before and after', 0, &
                           file_data('calibration_data.csv'))
               end do
            end associate
         end do
      end if
      if (allocated(job%uncertainties)) then
         do i = 1, size(job%uncertainties)
            associate (range => job%uncertainties(i)%range)
               do k = 1, size(range%models)
                  name = free_name('uncertainty_'//range%name//'_'//trim(model_name(range%models(k))))
                  call uncertainty_script(name, job%units, range, range%models(k), model%rig, model%holes, lines)
                  call add(name, 'What uncertain data make of hook load and torque', 0, &
                           file_data('uncertainty_'//range%name//'.csv'))
               end do
            end associate
         end do
      end if
      if (allocated(job%study) .and. .not. apart) then
         do k = 1, size(job%study%cases)
            associate (load_case => model%cases(job%study%cases(k)))
               name = free_name('study_'//load_case%name)
               call study_script(name, job, load_case, job%study, lines)
               call add(name, 'Error against the finest way to compute it, and what it costs', &
                        job%study%cases(k), file_data('study.csv'))
            end associate
         end do
      end if
      if (allocated(job%legacy) .and. .not. apart) then
         do i = 1, size(job%legacy)
            associate (table => job%legacy(i))
               name = free_name('legacy_'//table%label)
               call legacy_script(name, job, table, model%cases(table%case_index)%name, lines)
               call add(name, 'Our results and those of '//table%label, table%case_index, file_data('legacy_'//table%label//'.csv'))
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
         ! contact is what gap elements find; of other models the first
         k = rows(max(1, findloc(results(rows)%model == model_mcge, .true., dim=1)))
         file = case_file(profile_file, model%cases(i)%name, results(k)%model)
         name = free_name('path_'//model%cases(i)%name)
         call path_script(name, job, model, results(k), lines)
         call add(name, 'Well path with contact of the string', i, rows_along(file, path_columns, results(k), alongs(k)))
         name = free_name('forces_'//model%cases(i)%name)
         call forces_script(name, job, model, results(rows), alongs(rows), left_out, lines)
         call add(name, 'Along the string', i, rows_along(file, forces_columns, results(k), alongs(k)))
         name = free_name('strength_'//model%cases(i)%name)
         call strength_script(name, job, model, results(rows), alongs(rows), lines)
         call add(name, 'Stress, safety factor and torque against what the string bears', i, &
                  rows_along(file, strength_columns, results(k), alongs(k)))
         if (results(k)%model == model_mcge) then
            name = free_name('assembly_'//model%cases(i)%name)
            call assembly_script(name, job, model, results(k), lines)
            call add(name, 'The lowest part of the string in its hole; forces across it, angles as clock angles', i, &
                     rows_of_contacts(case_file(contacts_file, model%cases(i)%name, results(k)%model), results(k), &
                                      model%cases(i)%bit_depth - shown_length))
         end if
      end do
      if (.not. allocated(error)) call draw(job, list, error)

   contains

      !> A name that no picture has: the wanted one, or that with the next number.
      function free_name(wanted) result(name)
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

      !> Writes the script and enters the picture.
      subroutine add(name, caption, case_index, data)
         character(*), intent(in) :: name, caption
         integer, intent(in) :: case_index
         type(picture_data_type), intent(in) :: data
         type(picture_type), allocatable :: longer(:)
         integer :: n
         if (allocated(error)) return
         call note_file(job%output_dir, picture_folder//'/'//name//'.gp', error)
         if (.not. allocated(error)) call note_file(job%output_dir, picture_folder//'/'//name//'.svg', error)
         if (.not. allocated(error)) call write_text_file(folder_in(job)//'/'//name//'.gp', lines, error)
         n = size(list%pictures)
         allocate (longer(n + 1))
         longer(:n) = list%pictures
         longer(n + 1)%name = name
         longer(n + 1)%caption = caption
         longer(n + 1)%case_index = case_index
         longer(n + 1)%data = data
         call move_alloc(longer, list%pictures)
      end subroutine add
   end subroutine write_pictures

   !> Has gnuplot draw all scripts, if there is one.
   subroutine draw(job, list, error)
      type(job_type), intent(in) :: job
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: names(size(list%pictures)), scripts(size(list%pictures))
      character(:), allocatable :: gnuplot
      logical :: drawn(size(list%pictures))
      integer :: i
      do i = 1, size(list%pictures)
         names(i)%text = list%pictures(i)%name
         scripts(i)%text = 'load '//spelled(names(i)%text//'.gp')
      end do
      call note_file(job%output_dir, picture_folder//'/'//whole_script//'.gp', error)
      if (.not. allocated(error)) call note_file(job%output_dir, picture_folder//'/'//complaint_file, error)
      if (.not. allocated(error)) call write_text_file(folder_in(job)//'/'//whole_script//'.gp', scripts, error)
      if (allocated(error)) return
      gnuplot = find_program('gnuplot')
      list%no_gnuplot = gnuplot == ''
      call draw_pictures(gnuplot, folder_in(job), names, usual_patience, drawn, error)
      list%pictures%drawn = drawn
   end subroutine draw

   pure function folder_in(job) result(path)
      type(job_type), intent(in) :: job
      character(:), allocatable :: path
      path = job%output_dir//'/'//picture_folder
   end function folder_in
end module dg_picture_files

!> The pictures of a run: writes a gnuplot script for each into the folder `pictures` of the output folder, has gnuplot draw
!> them, and tells which are there. Without gnuplot the scripts stay, to be drawn elsewhere.
module dg_picture_files
   use dg_along_string, only: along_string_type
   use dg_assembly_picture, only: assembly_script, shown_length
   use dg_calibration_file, only: datum_columns
   use dg_calibration_picture, only: calibration_script
   use dg_case_result, only: case_result_type, result_converged
   use dg_child_process, only: find_program
   use dg_column, only: field_real
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_folder, only: make_folder
   use dg_forces_picture, only: forces_script
   use dg_gnuplot_script, only: spelled
   use dg_hookload_picture, only: hookload_script
   use dg_job, only: job_type, model_mcge, model_name
   use dg_legacy_picture, only: legacy_script
   use dg_legacy_rows, only: legacy_columns
   use dg_model, only: model_type
   use dg_path_picture, only: path_script
   use dg_picture_data, only: picture_data_type, rows_along, rows_of_contacts, rows_of_file
   use dg_picture_drawing, only: complaint_file, draw_pictures, usual_patience
   use dg_picture_list, only: add_picture, folder_in, free_name, picture_list_type, picture_type
   use dg_result_name, only: case_file, contacts_file, picture_folder, profile_file
   use dg_strength_picture, only: strength_script
   use dg_study_file, only: study_columns
   use dg_study_picture, only: study_script
   use dg_summary_file, only: summary_columns
   use dg_sweep_file, only: sweep_columns
   use dg_sweep_picture, only: sweep_script
   use dg_uncertainty_file, only: uncertainty_columns
   use dg_uncertainty_picture, only: uncertainty_script
   use dg_text, only: is_separator_free, text_list, text_type, to_text
   use dg_written_files, only: check_picture_folder, note_file
   implicit none
   private
   public :: write_pictures

   !> Script that draws all, for whoever wants them again.
   character(*), parameter :: whole_script = 'all'

   !> Columns of the tables beneath pictures, of the files that these are drawn from.
   character(*), parameter :: path_columns(9) = [character(16) :: 'md', 'tvd', 'north', 'east', 'inclination', 'azimuth', &
      'dogleg', 'displacement', 'standoff']
   character(*), parameter :: forces_columns(8) = [character(16) :: 'md', 'axial', 'torque', 'bending', 'side_force', 'clock', &
      'sinusoidal_load', 'buckling_margin']
   character(*), parameter :: strength_columns(8) = [character(16) :: 'md', 'von_mises', 'safety_factor', 'axial_stress', &
      'bending_stress', 'bending_range', 'torsional_stress', 'torque']
   character(*), parameter :: hookload_shown(10) = [character(24) :: 'case', 'model', 'hookload', 'weight_indicator', 'measured', &
      'error', 'reference', 'reference_error', 'torque', 'status']
   character(*), parameter :: sweep_shown(14) = [character(24) :: 'operation', 'friction', 'friction_cased', 'bit_depth', &
      'hookload', 'weight_indicator', 'torque', 'overpull_margin', 'rig_margin', 'torque_margin', 'measured_hookload', &
      'measured_torque', 'error', 'status']
   character(*), parameter :: datum_shown(11) = [character(24) :: 'case', 'operation', 'bit_depth', 'measured_hookload', &
      'before_hookload', 'after_hookload', 'measured_torque', 'before_torque', 'after_torque', 'before_error', 'after_error']
   character(*), parameter :: uncertainty_shown(14) = [character(24) :: 'operation', 'bit_depth', 'hookload_p10', 'hookload_p50', &
      'hookload_p90', 'weight_indicator_p10', 'weight_indicator_p50', 'weight_indicator_p90', 'torque_p10', 'torque_p50', &
      'torque_p90', 'samples', 'locked_up', 'not_converged']
   character(*), parameter :: study_shown(17) = [character(24) :: 'model', 'fidelity', 'element_length', 'tolerance', &
      'wall_stiffness', 'gap_location', 'linear_solver', 'status', 'hookload', 'hookload_error', 'torque_error', &
      'normal_force_error', 'bending_error', 'iterations', 'seconds', 'cost', 'pareto']
   character(*), parameter :: legacy_shown(12) = [character(24) :: 'model', 'md', 'hole', 'axial', 'legacy_axial', &
      'axial_difference', 'torque', 'legacy_torque', 'torque_difference', 'side_force', 'legacy_side_force', &
      'side_force_difference']

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
      integer :: i
      logical :: apart
      allocate (list%pictures(0))
      call make_folder(folder_in(job), error)
      if (.not. allocated(error)) call check_picture_folder(job, error)     ! it may have changed since the run began
      if (allocated(error)) return
      if (size(results) > 0) then
         call hookload_script('hookload', job, model, results, lines)
         call add_picture(list, job, of('hookload', 'Hook load of all cases', 0, &
                                        rows_of_file(job, 'summary.csv', summary_columns, hookload_shown, text_list())), &
                          lines, error)
      end if
      ! a run that joins parts has neither calibrated nor solved anything else
      apart = job%merge > 0
      if (allocated(job%sweeps)) call add_sweeps(list, job, model, error)
      if (allocated(job%calibrations) .and. .not. apart) call add_calibrations(list, job, model, error)
      if (allocated(job%uncertainties)) call add_uncertainties(list, job, model, error)
      if (allocated(job%study) .and. .not. apart) call add_study(list, job, model, error)
      if (allocated(job%legacy) .and. .not. apart) call add_legacies(list, job, model, error)
      if (job%profiles) then                ! the files that these draw from
         do i = 1, size(model%cases)
            call add_case(list, job, model, i, results, alongs, error)
         end do
      end if
      if (.not. allocated(error)) call draw(job, list, error)
   end subroutine write_pictures

   !> A broomstick for each sweep and model.
   subroutine add_sweeps(list, job, model, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(inout) :: error
      type(text_type), allocatable :: lines(:)
      type(picture_data_type) :: data
      character(:), allocatable :: name, file
      integer :: i, k, margin, row
      margin = findloc(sweep_shown, 'overpull_margin', dim=1)
      do i = 1, size(job%sweeps)
         associate (sweep => job%sweeps(i))
            do k = 1, size(sweep%models)
               name = free_name(list, 'sweep_'//sweep%name//'_'//trim(model_name(sweep%models(k))))
               file = 'sweep_'//sweep%name//'.csv'
               data = rows_of_file(job, file, sweep_columns, sweep_shown, &
                                   text_list('model', trim(model_name(sweep%models(k)))))
               call sweep_script(name, job%units, sweep, sweep%models(k), model%rig, model%holes, &
                                 any([(data%rows(row)%fields(margin)%kind == field_real, row=1, size(data%rows))]), lines)
               call add_picture(list, job, of(name, 'Hook load and torque against bit depth, sweep '//sweep%name//', model '// &
                                              trim(model_name(sweep%models(k))), 0, data), lines, error)
            end do
         end associate
      end do
   end subroutine add_sweeps

   !> A picture for each calibration and model.
   subroutine add_calibrations(list, job, model, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(inout) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name
      integer :: i, k
      do i = 1, size(job%calibrations)
         associate (calibration => job%calibrations(i))
            do k = 1, size(calibration%models)
               name = to_text(i)             ! where its name is none for a file
               if (is_separator_free(calibration%name)) name = calibration%name
               name = free_name(list, 'calibration_'//name//'_'//trim(model_name(calibration%models(k))))
               call calibration_script(name, job, model, i, k, lines)
               call add_picture(list, job, of(name, 'Friction found from measurements, and the error before and after', 0, &
                  rows_of_file(job, 'calibration_data.csv', datum_columns, datum_shown, &
                               text_list('calibration', calibration%name, 'model', trim(model_name(calibration%models(k)))))), &
                                lines, error)
            end do
         end associate
      end do
   end subroutine add_calibrations

   !> A broomstick of quantiles for each range of depths and model.
   subroutine add_uncertainties(list, job, model, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(inout) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name, file
      integer :: i, k
      do i = 1, size(job%uncertainties)
         associate (range => job%uncertainties(i)%range)
            do k = 1, size(range%models)
               name = free_name(list, 'uncertainty_'//range%name//'_'//trim(model_name(range%models(k))))
               file = 'uncertainty_'//range%name//'.csv'
               call uncertainty_script(name, job%units, range, range%models(k), model%rig, model%holes, lines)
               call add_picture(list, job, of(name, 'What uncertain data make of hook load and torque', 0, &
                  rows_of_file(job, file, uncertainty_columns, uncertainty_shown, &
                               text_list('model', trim(model_name(range%models(k)))))), lines, error)
            end do
         end associate
      end do
   end subroutine add_uncertainties

   !> A picture for each case of the study.
   subroutine add_study(list, job, model, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(inout) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name
      integer :: k
      do k = 1, size(job%study%cases)
         associate (load_case => model%cases(job%study%cases(k)))
            name = free_name(list, 'study_'//load_case%name)
            call study_script(name, job, load_case, job%study, lines)
            call add_picture(list, job, of(name, 'Error against the finest way to compute it, and what it costs', &
               job%study%cases(k), rows_of_file(job, 'study.csv', study_columns, study_shown, &
                                                text_list('case', load_case%name))), lines, error)
         end associate
      end do
   end subroutine add_study

   !> A picture for each table of another program.
   subroutine add_legacies(list, job, model, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(inout) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name, file
      integer :: i
      do i = 1, size(job%legacy)
         associate (table => job%legacy(i))
            name = free_name(list, 'legacy_'//table%label)
            file = 'legacy_'//table%label//'.csv'
            call legacy_script(name, job, table, model%cases(table%case_index)%name, model%holes, lines)
            call add_picture(list, job, of(name, 'Our results and those of '//table%label, table%case_index, &
                                           rows_of_file(job, file, legacy_columns, legacy_shown, text_list())), lines, error)
         end associate
      end do
   end subroutine add_legacies

   !> Pictures along the string of a load case, of those results that are solutions; none where there are none.
   subroutine add_case(list, job, model, case_index, results, alongs, error)
      type(picture_list_type), intent(inout) :: list
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(case_result_type), intent(in) :: results(:)
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(error_type), allocatable, intent(inout) :: error
      type(text_type), allocatable :: lines(:)
      character(:), allocatable :: name, left_out, file
      integer, allocatable :: rows(:)
      integer :: k
      rows = pack([(k, k=1, size(results))], results%case_index == case_index .and. results%status == result_converged)
      rows = pack(rows, [(allocated(results(rows(k))%profile%md), k=1, size(rows))])
      if (size(rows) == 0) return         ! numbers that are no solution are not drawn
      left_out = ''
      do k = 1, size(results)
         if (results(k)%case_index == case_index .and. .not. any(rows == k)) &
            left_out = left_out//' '//trim(model_name(results(k)%model))
      end do
      ! contact is what gap elements find; of other models the first
      k = rows(max(1, findloc(results(rows)%model == model_mcge, .true., dim=1)))
      associate (load_case => model%cases(case_index))
         file = case_file(profile_file, load_case%name, results(k)%model)
         name = free_name(list, 'path_'//load_case%name)
         call path_script(name, job, model, results(k), lines)
         call add_picture(list, job, of(name, 'Well path with contact of the string', case_index, &
                                        rows_along(file, path_columns, results(k), alongs(k))), lines, error)
         name = free_name(list, 'forces_'//load_case%name)
         call forces_script(name, job, model, results(rows), alongs(rows), left_out, lines)
         call add_picture(list, job, of(name, 'Along the string', case_index, &
                                        rows_along(file, forces_columns, results(k), alongs(k))), lines, error)
         name = free_name(list, 'strength_'//load_case%name)
         call strength_script(name, job, model, results(rows), alongs(rows), lines)
         call add_picture(list, job, of(name, 'Stress, safety factor and torque against what the string bears', case_index, &
                                        rows_along(file, strength_columns, results(k), alongs(k))), lines, error)
         if (results(k)%model /= model_mcge) return
         name = free_name(list, 'assembly_'//load_case%name)
         call assembly_script(name, job, model, results(k), lines)
         call add_picture(list, job, of(name, &
            'The lowest part of the string in its hole; forces across it, angles as clock angles', case_index, &
            rows_of_contacts(case_file(contacts_file, load_case%name, results(k)%model), results(k), &
                             load_case%bit_depth - shown_length)), lines, error)
      end associate
   end subroutine add_case

   !> A picture that is not drawn yet.
   pure function of(name, caption, case_index, data) result(picture)
      character(*), intent(in) :: name, caption
      integer, intent(in) :: case_index
      type(picture_data_type), intent(in) :: data
      type(picture_type) :: picture
      picture%name = name
      picture%caption = caption
      picture%case_index = case_index
      picture%data = data
   end function of

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
end module dg_picture_files

!> Pictures of a run. A gnuplot script for each is written into the folder `pictures` of the output folder, and drawn by
!> gnuplot. The result names the pictures. Without gnuplot the scripts stay, to be drawn elsewhere.
module dg_picture_files
   use dg_assembly_picture, only: assembly_chart, shown_length
   use dg_case_result, only: result_converged
   use dg_column, only: fields_of
   use dg_child_process, only: find_program
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_findings, only: findings_type
   use dg_folder, only: make_folder
   use dg_forces_picture, only: forces_chart
   use dg_gnuplot_script, only: spelled
   use dg_hookload_picture, only: hookload_chart
   use dg_job, only: job_type, model_mcge, model_name
   use dg_path_picture, only: path_chart
   use dg_picture_data, only: picked_rows, picture_data_type, rows_along, rows_of_contacts
   use dg_picture_drawing, only: complaint_file, draw_pictures, usual_patience
   use dg_picture_list, only: add_picture, folder_in, picture_list_type
   use dg_picture_title, only: write_title
   use dg_result_name, only: case_file, contacts_file, picture_folder, profile_file
   use dg_strength_picture, only: strength_chart
   use dg_summary_file, only: summary_row
   use dg_text, only: text_type
   use dg_verdict, only: answer_yes
   use dg_written_files, only: check_picture_folder, note_file
   implicit none
   private
   public :: begin_pictures, end_pictures

   !> Script that draws all pictures again.
   character(*), parameter :: whole_script = 'all'

   !> Columns of the tables beneath pictures, of the files that these are drawn from.
   character(*), parameter :: path_columns(9) = [character(16) :: 'md', 'tvd', 'north', 'east', 'inclination', 'azimuth', &
      'dogleg', 'displacement', 'standoff']
   character(*), parameter :: forces_columns(8) = [character(16) :: 'md', 'axial', 'torque', 'bending', 'side_force', 'clock', &
      'sinusoidal_load', 'buckling_margin']
   character(*), parameter :: strength_columns(8) = [character(16) :: 'md', 'von_mises', 'safety_factor', 'axial_stress', &
      'bending_stress', 'bending_range', 'torsional_stress', 'torque']
   character(*), parameter :: hookload_shown(10) = [character(24) :: 'case', 'model', 'hookload', 'weight_indicator', 'measured', &
      'error', 'reference', 'reference_error', 'torque', 'can_be_done']

contains

   !> Begins the pictures of a run with that of all load cases. `error` where a script cannot be written.
   subroutine begin_pictures(found, list, error)
      type(findings_type), intent(in) :: found
      type(picture_list_type), intent(out) :: list
      type(error_type), allocatable, intent(out) :: error
      type(picture_data_type) :: data
      logical, allocatable :: wanted(:)
      integer, allocatable :: rows(:)
      integer :: i
      allocate (list%pictures(0))
      list%empty = ''
      call make_folder(folder_in(found%job), error)
      if (.not. allocated(error)) call check_picture_folder(found%job, error)     ! it may have changed since the run began
      if (allocated(error) .or. size(found%results) == 0) return
      allocate (wanted(size(found%results)), source=.true.)
      call picked_rows('summary.csv', wanted, data, rows)
      do i = 1, size(rows)
         associate (result => found%results(rows(i)))
            data%rows(i) = fields_of(summary_row(found%model%cases(result%case_index), result, found%wholes(rows(i))%verdict, &
                                                 found%job%units), hookload_shown)
         end associate
      end do
      call add_picture(list, found%job, hookload_chart(found), 'Hook load of all cases', 0, data, error)
   end subroutine begin_pictures

   !> Adds those along the string of each load case, and has all drawn. `error` also where gnuplot fails or the program is asked to
   !> end; a missing gnuplot is none.
   subroutine end_pictures(found, list, error)
      type(findings_type), intent(in) :: found
      type(picture_list_type), intent(inout) :: list
      type(error_type), allocatable, intent(inout) :: error
      integer :: i
      if (allocated(error)) return
      if (found%job%profiles) then                ! the files that these draw from
         do i = 1, size(found%model%cases)
            call add_case(list, found, i, error)
         end do
      end if
      if (.not. allocated(error)) call draw(found%job, list, error)
   end subroutine end_pictures

   !> Pictures along the string of a load case, of those results that are solutions; none where there are none.
   subroutine add_case(list, found, case_index, error)
      type(picture_list_type), intent(inout) :: list
      type(findings_type), intent(in) :: found
      integer, intent(in) :: case_index
      type(error_type), allocatable, intent(inout) :: error
      character(:), allocatable :: left_out, file, answer
      integer, allocatable :: rows(:)
      integer :: k
      rows = pack([(k, k=1, size(found%results))], found%results%case_index == case_index .and. &
                  found%results%status == result_converged)
      rows = pack(rows, [(allocated(found%results(rows(k))%profile%md), k=1, size(rows))])
      if (size(rows) == 0) return         ! numbers that are no solution are not drawn
      left_out = ''
      do k = 1, size(found%results)
         if (found%results(k)%case_index == case_index .and. .not. any(rows == k)) &
            left_out = left_out//' '//trim(model_name(found%results(k)%model))
      end do
      ! contact is what gap elements find; of other models the first
      k = rows(max(1, findloc(found%results(rows)%model == model_mcge, .true., dim=1)))
      answer = ''
      if (found%wholes(k)%verdict%answer /= answer_yes) answer = '. The operation cannot be done'
      associate (load_case => found%model%cases(case_index))
         file = case_file(profile_file, load_case%name, found%results(k)%model)
         call add_picture(list, found%job, path_chart(found%job, found%model, found%results(k)), &
                          'Well path with contact of the string'//answer, case_index, &
                          rows_along(file, path_columns, found%results(k), found%alongs(k)), error)
         call add_picture(list, found%job, forces_chart(found%job, found%model, found%results(rows), found%alongs(rows), &
                                                         left_out), 'Forces and moments along the string'//answer, &
                          case_index, rows_along(file, forces_columns, found%results(k), found%alongs(k)), error)
         call add_picture(list, found%job, strength_chart(found%job, found%model, found%results(rows), found%alongs(rows)), &
                          'Stress, safety factor and torque against what the string bears'//answer, case_index, &
                          rows_along(file, strength_columns, found%results(k), found%alongs(k)), error)
         if (found%results(k)%model /= model_mcge) return
         call add_picture(list, found%job, assembly_chart(found%job, found%model, found%results(k)), &
                          'The lowest part of the string in its hole; forces across it, angles as clock angles'//answer, &
                          case_index, rows_of_contacts(case_file(contacts_file, load_case%name, found%results(k)%model), &
                                                       found%results(k), load_case%bit_depth - shown_length), error)
      end associate
   end subroutine add_case

   !> Has gnuplot draw all scripts, if there is one, and gives the pictures their titles.
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
      do i = 1, size(drawn)
         if (allocated(error)) return
         if (drawn(i)) call write_title(folder_in(job)//'/'//names(i)%text//'.svg', list%pictures(i)%title, error)
      end do
   end subroutine draw
end module dg_picture_files

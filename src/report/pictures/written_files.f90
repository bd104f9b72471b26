!> List of the files that a run has written into its output folder, kept there in drillgap_files.txt. The next run removes the
!> listed files that it does not write anew, and no others. A check comes first: a run must not write over its input, or
!> through a link.
module dg_written_files
   use dg_error, only: error_type, raise, status_bad_input, status_failure
   use dg_file_identity, only: identity_of, identity_of_link, identity_type, is_same_file, link_target
   use dg_file_lines, only: beside, folder_of, read_lines
   use dg_file_system, only: delete_file, finished_name, unfinished_suffix, write_text_file
   use dg_folder, only: list_folder, remove_empty_folder
   use dg_folder_lock, only: lock_name
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_picture_drawing, only: complaint_file
   use dg_result_name, only: is_record_name, is_result_name, picture_folder, result_names
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: check_inputs, check_links, check_picture_folder, begin_files, note_file, end_files, other_records

   !> The list, in the output folder, and its first line. A file without that line is not a list of this program.
   character(*), parameter :: list_name = 'drillgap_files.txt'
   character(*), parameter :: title = 'drillgap wrote these files here; its next run removes them'

   !> Links in a row that Linux follows.
   integer, parameter :: most_links = 40

contains

   !> Refuse (bad input) a run that would write over, or remove, a file that it reads, under any name. The message has both
   !> names. No file is written.
   subroutine check_inputs(job, model, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: names(:), earlier(:)
      character(:), allocatable :: faults
      integer :: i
      allocate (names(0), earlier(0))   ! the compiler's flow analysis takes them for undefined otherwise
      call names_to_write(job, model, names)
      if (job%parts == 0) call read_list(job, earlier)
      faults = ''
      do i = 1, size(names)
         call look_for(names(i)%text, 'write')
      end do
      do i = 1, size(job%inputs)
         if (job%plots .and. job%parts == 0) call look_among_pictures(job%inputs(i)%text)
      end do
      do i = 1, size(earlier)
         call look_for(earlier(i)%text, 'remove')
      end do
      if (faults /= '') call raise(error, status_bad_input, 'the run would destroy what it reads; give another folder by '// &
                                   'output_dir or --output, or move the file'//faults)

   contains

      subroutine look_for(name, verb)
         character(*), intent(in) :: name, verb
         type(identity_type) :: there
         character(:), allocatable :: path
         integer :: k
         path = job%output_dir//'/'//name
         there = identity_of(path)
         if (.not. there%exists) return
         do k = 1, size(job%inputs)
            if (is_same_file(there, identity_of(job%inputs(k)%text))) call note(job%inputs(k)%text, verb, path)
         end do
      end subroutine look_for

      !> An input with the name of a picture, or that links to one, by however many links: pictures' names are not known yet.
      subroutine look_among_pictures(input)
         character(*), intent(in) :: input
         type(identity_type) :: pictures, home
         character(:), allocatable :: path, base
         integer :: step
         pictures = identity_of(job%output_dir//'/'//picture_folder)
         path = input
         do step = 1, most_links
            home = identity_of(beside(path, '.'))
            base = path(len(folder_of(path)) + 1:)
            if (is_same_file(home, pictures) .and. is_result_name(picture_folder//'/'//base, job%study_forms)) then
               call note(input, 'write', job%output_dir//'/'//picture_folder//'/'//base)
               return
            end if
            if (link_target(path) == '') return
            path = beside(path, link_target(path))
         end do
      end subroutine look_among_pictures

      subroutine note(input, verb, path)
         character(*), intent(in) :: input, verb, path
         character(:), allocatable :: line
         line = new_line('a')//input//': the run would '//verb//' '//path//', which is this file'
         if (index(faults//new_line('a'), line//new_line('a')) == 0) faults = faults//line
      end subroutine note
   end subroutine check_inputs

   !> Names of all that a run writes, but for pictures, whose names are not known yet.
   subroutine names_to_write(job, model, names)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(text_type), allocatable, intent(out) :: names(:)
      integer :: i
      allocate (names(0))   ! as above
      call result_names(job, model, names)
      do i = 1, size(job%study_records)
         call append_text(names, job%study_records(i)%text)
      end do
      call append_text(names, list_name)
      call append_text(names, lock_name)
      if (job%plots) call append_text(names, picture_folder//'/'//complaint_file)
   end subroutine names_to_write

   !> Refuse (failure) a run if there are links in the output folder under names that it would write, wherever they lead. No
   !> file is written outside the output folder. Links under names of pictures are replaced.
   subroutine check_links(job, model, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: names(:)
      character(:), allocatable :: links, target
      integer :: i
      if (job%plots .and. job%parts == 0) call check_picture_folder(job, error)
      if (allocated(error)) return
      allocate (names(0))   ! as above
      call names_to_write(job, model, names)
      links = ''
      do i = 1, size(names)
         target = link_target(job%output_dir//'/'//names(i)%text)
         if (target /= '') links = links//new_line('a')//job%output_dir//'/'//names(i)%text//': link to '//target
      end do
      if (links /= '') call raise(error, status_failure, 'links stand in the output folder where the run would write; remove '// &
                                  'them, or give another folder by output_dir or --output'//links)
   end subroutine check_links

   !> Refuse (failure) a folder of pictures that is elsewhere, behind a link, or not a folder.
   subroutine check_picture_folder(job, error)
      type(job_type), intent(in) :: job
      type(error_type), allocatable, intent(out) :: error
      type(identity_type) :: there
      character(:), allocatable :: path
      path = job%output_dir//'/'//picture_folder
      there = identity_of_link(path)
      if (there%is_link) then
         call raise(error, status_failure, path//' is a link to '//link_target(path)//', and nothing is written outside the '// &
                    'output folder; remove the link, or give another folder by output_dir or --output')
      else if (there%exists .and. .not. there%is_folder) then
         call raise(error, status_failure, path//' is not a folder; remove it, or give another folder by output_dir or --output')
      end if
   end subroutine check_picture_folder

   !> Begin the results of a run that holds the folder. Remove results of earlier runs, and write the list of the new ones. A
   !> part of a divided run does not touch results.
   subroutine begin_files(job, model, error)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: names(:), earlier(:)
      integer :: i
      call remove_unfinished(job, '')
      if (job%parts > 0) return
      call remove_unfinished(job, picture_folder//'/')
      allocate (names(0), earlier(0))   ! as above
      call read_list(job, earlier)
      do i = 1, size(earlier)
         call remove_result(job, earlier(i)%text)
         call remove_result(job, earlier(i)%text//unfinished_suffix)     ! of a picture that was being drawn
      end do
      call result_names(job, model, names)
      do i = 1, size(names)
         call remove_result(job, names(i)%text)
      end do
      if (is_own_folder(job%output_dir//'/'//picture_folder) .and. size(earlier) > 0) &
         call remove_empty_folder(job%output_dir//'/'//picture_folder)
      call write_list(job%output_dir, names, error)
   end subroutine begin_files

   !> Enters files that are about to be written and that result_names does not know.
   subroutine note_file(folder, name, error)
      character(*), intent(in) :: folder       !< of output
      character(*), intent(in) :: name         !< relative to it
      type(error_type), allocatable, intent(out) :: error
      type(identity_type) :: list
      integer :: unit, status
      list = identity_of_link(folder//'/'//list_name)
      if (.not. list%is_regular) return        ! a picture that is drawn elsewhere than in a run
      open (newunit=unit, file=folder//'/'//list_name, status='old', position='append', action='write', iostat=status)
      if (status == 0) write (unit, '(a)', iostat=status) name
      if (status == 0) close (unit, iostat=status)
      if (status /= 0) call raise(error, status_failure, 'cannot write '//folder//'/'//list_name//' (is the disk full?)')
   end subroutine note_file

   !> End the results of a run: the list has the existing files. Failure if the list itself is gone: whoever removed it may
   !> have removed results, too.
   subroutine end_files(job, error)
      type(job_type), intent(in) :: job
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: names(:), there(:)
      type(identity_type) :: file
      integer :: i, n
      if (job%parts > 0) return
      file = identity_of_link(job%output_dir//'/'//list_name)
      if (.not. file%is_regular) then
         call raise(error, status_failure, job%output_dir//'/'//list_name//' was removed during the run, and results may be '// &
                    'missing; run again')
         return
      end if
      allocate (names(0))   ! as above
      call read_list(job, names)
      allocate (there(size(names)))
      n = 0
      do i = 1, size(names)
         file = identity_of_link(job%output_dir//'/'//names(i)%text)
         if (.not. file%is_regular) cycle
         n = n + 1
         there(n)%text = names(i)%text
      end do
      call write_list(job%output_dir, there(:n), error)
   end subroutine end_files

   !> Names of records of unfinished work that this run does not continue. They may hold hours of work, and stay.
   subroutine other_records(job, names)
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(out) :: names(:)
      type(text_type), allocatable :: found(:), mine(:)
      integer :: i, k
      allocate (names(0), found(0), mine(0))   ! as above
      mine = job%study_records
      call list_folder(job%output_dir, '.partial', found)
      do i = 1, size(found)
         if (.not. is_record_name(found(i)%text, job%study_kinds)) cycle
         if (any([(mine(k)%text == found(i)%text, k=1, size(mine))])) cycle
         call append_text(names, found(i)%text)
      end do
   end subroutine other_records

   !> The names of the list in a folder, those of results only; none where there is no list of ours.
   subroutine read_list(job, names)
      type(job_type), intent(in) :: job
      type(text_type), allocatable, intent(out) :: names(:)
      type(text_type), allocatable :: lines(:)
      type(identity_type) :: list
      character(:), allocatable :: failure
      integer :: i, n
      allocate (names(0))
      list = identity_of_link(job%output_dir//'/'//list_name)
      if (.not. list%is_regular) return
      call read_lines(job%output_dir//'/'//list_name, lines, failure)
      if (failure /= '' .or. size(lines) == 0) return
      if (lines(1)%text /= title) return
      n = 0
      do i = 2, size(lines)
         if (.not. is_result_name(lines(i)%text, job%study_forms)) cycle
         n = n + 1
         lines(n)%text = lines(i)%text
      end do
      names = lines(:n)
   end subroutine read_list

   subroutine write_list(folder, names, error)
      character(*), intent(in) :: folder
      type(text_type), intent(in) :: names(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type) :: lines(0:size(names))
      integer :: i
      lines(0)%text = title
      do i = 1, size(names)
         lines(i)%text = names(i)%text
      end do
      call write_text_file(folder//'/'//list_name, lines, error)
   end subroutine write_list

   !> Removes a result: a file that is neither link nor input, in a folder that is no link.
   subroutine remove_result(job, name)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: name
      type(identity_type) :: file
      character(:), allocatable :: path
      path = job%output_dir//'/'//name
      file = identity_of_link(path)
      if (.not. file%is_regular .or. is_input(job, file)) return
      if (index(name, '/') > 0 .and. .not. is_own_folder(job%output_dir//'/'//picture_folder)) return
      call delete_file(path)
   end subroutine remove_result

   !> True if a file is an input of the run.
   function is_input(job, file) result(is)
      type(job_type), intent(in) :: job
      type(identity_type), intent(in) :: file
      logical :: is
      integer :: i
      is = .false.
      do i = 1, size(job%inputs)
         is = is .or. is_same_file(file, identity_of(job%inputs(i)%text))
      end do
   end function is_input

   !> Remove unfinished files of a run that was killed. A part of a divided run only removes its own: others may be at work.
   subroutine remove_unfinished(job, place)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: place        !< folder within the output folder, with its slash; '': that itself
      type(text_type), allocatable :: found(:), mine(:)
      type(identity_type) :: file
      character(:), allocatable :: name, path
      integer :: i, k
      logical :: goes
      if (place /= '' .and. .not. is_own_folder(job%output_dir//'/'//picture_folder)) return
      allocate (found(0), mine(0))   ! as above
      mine = job%study_records
      call list_folder(job%output_dir//'/'//place, unfinished_suffix, found)
      do i = 1, size(found)
         name = place//finished_name(found(i)%text)
         goes = is_result_name(name, job%study_forms) .or. is_record_name(name, job%study_kinds) .or. name == list_name
         if (job%parts > 0) goes = any([(mine(k)%text == name, k=1, size(mine))])
         path = job%output_dir//'/'//place//found(i)%text
         file = identity_of_link(path)
         if (goes .and. file%is_regular .and. .not. is_input(job, file)) call delete_file(path)
      end do
   end subroutine remove_unfinished

   !> True if a path is a folder and not a link to one.
   function is_own_folder(path) result(is)
      character(*), intent(in) :: path
      logical :: is
      type(identity_type) :: there
      there = identity_of_link(path)
      is = there%is_folder
   end function is_own_folder
end module dg_written_files

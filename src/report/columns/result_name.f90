!> Names of the files of results, relative to the output folder. No other file is ever removed from it.
module dg_result_name
   use dg_casing_wear, only: wears_casing
   use dg_fatigue, only: asks_for_fatigue
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type
   use dg_model, only: model_type
   use dg_text, only: text_type, to_text
   implicit none
   private
   public :: profile_file, view_file, hole_file, contacts_file, wear_file, fatigue_file, history_file
   public :: case_files, wanted_files, case_file, points_file, record_file, failed_file
   public :: result_names, is_result_name, is_record_name, picture_folder

   ! Files of one case: places of their beginnings and endings.
   integer, parameter :: profile_file = 1, contacts_file = 2, wear_file = 3, fatigue_file = 4, view_file = 5, hole_file = 6, &
                         history_file = 7, case_files = 7

   !> Folder of scripts and pictures, within the output folder.
   character(*), parameter :: picture_folder = 'pictures'
   character(*), parameter :: fixed_names(4) = [character(26) :: 'summary.csv', 'limits.csv', 'results.h5', 'report.html']
   !> Beginnings of names with something of the deck in them, and their endings. Builds before 0.2.0 wrote .vtkhdf.
   character(*), parameter :: beginnings(8) = [character(12) :: 'profile_', 'contacts_', 'casing_wear_', 'fatigue_', 'view_', &
      'hole_', 'history_', 'view_']
   character(*), parameter :: endings(8) = [character(7) :: '.csv', '.csv', '.csv', '.csv', '.hdf', '.hdf', '.csv', '.vtkhdf']
   !> Stands for something of the deck in the forms of names of studies.
   character, parameter :: anything = '*'
   !> Of pictures: scripts, pictures, those that are being drawn, gnuplot's complaints.
   character(*), parameter :: picture_endings(4) = [character(15) :: '.gp', '.svg', '.svg.unfinished', '.log']
   !> Characters of names, and the longest name of the system.
   character(*), parameter :: letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+'
   character(*), parameter :: digits = '0123456789'
   integer, parameter :: longest_name = 255

contains

   !> Files that a case is to have, once it is solved.
   pure function wanted_files(job, model, load_case) result(wanted)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: wanted(case_files)
      wanted = job%profiles
      wanted(wear_file) = job%profiles .and. wears_casing(model, load_case)
      wanted(fatigue_file) = job%profiles .and. asks_for_fatigue(model, load_case)
      wanted([view_file, hole_file]) = job%plots
      wanted(history_file) = model%numerics%history
   end function wanted_files

   !> Name of a file of one case and model.
   pure function case_file(kind, case, number) result(name)
      integer, intent(in) :: kind               !< profile_file, ...
      character(*), intent(in) :: case
      integer, intent(in) :: number             !< of the model
      character(:), allocatable :: name
      name = trim(beginnings(kind))//case//'_'//trim(model_name(number))//trim(endings(kind))
   end function case_file

   !> Name of the file of points over bit depth.
   pure function points_file(what, name) result(file)
      character(*), intent(in) :: what         !< sweep or uncertainty
      character(*), intent(in) :: name         !< of it
      character(:), allocatable :: file
      file = what//'_'//name//'.csv'
   end function points_file

   !> Name of the record of work that is not finished: of a part, or of an undivided run (`parts` = 0).
   pure function record_file(what, name, part, parts) result(file)
      character(*), intent(in) :: what, name   !< as in points_file
      integer, intent(in) :: part, parts
      character(:), allocatable :: file
      file = what//'_'//name//'.partial'
      if (parts > 0) file = what//'_'//name//'.part_'//to_text(part)//'_of_'//to_text(parts)
   end function record_file

   !> Name of the record that an undivided run leaves where points did not converge: they can be solved again from it.
   pure function failed_file(what, name) result(file)
      character(*), intent(in) :: what, name   !< as in points_file
      character(:), allocatable :: file
      file = what//'_'//name//'.failed'
   end function failed_file

   !> Names of the results that a run of the job writes, pictures aside. A part of a divided run writes none.
   subroutine result_names(job, model, names)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(text_type), allocatable, intent(out) :: names(:)
      integer :: i, j, n
      n = size(fixed_names) + size(job%study_files) + case_files*size(job%models)*size(model%cases)
      allocate (names(n))
      n = 0
      call add('report.html', job%plots)
      do i = 1, size(job%study_files)
         call add(job%study_files(i)%text, .true.)
      end do
      if (job%merge == 0 .and. size(model%cases) > 0) call add_cases()
      if (job%parts > 0) n = 0
      names = names(:n)

   contains

      subroutine add(name, is_written)
         character(*), intent(in) :: name
         logical, intent(in) :: is_written
         if (.not. is_written) return
         n = n + 1
         names(n)%text = name
      end subroutine add

      !> Add the names of files of load cases.
      subroutine add_cases()
         logical :: wanted(case_files)
         integer :: kind
         call add('summary.csv', .true.)
         call add('limits.csv', .true.)
         call add('results.h5', job%hdf5)
         do j = 1, size(job%models)
            do i = 1, size(model%cases)
               wanted = wanted_files(job, model, model%cases(i))
               do kind = 1, case_files
                  call add(case_file(kind, model%cases(i)%name, job%models(j)), wanted(kind))
               end do
            end do
         end do
      end subroutine add_cases
   end subroutine result_names

   !> True if a name may be that of a result. It is plain, in the output folder or its folder of pictures, and has a form that runs
   !> write.
   pure function is_result_name(name, forms) result(is)
      character(*), intent(in) :: name
      type(text_type), intent(in) :: forms(:)      !< of names that studies give: study.csv, sweep_*.csv
      logical :: is
      integer :: i, j
      is = .false.
      if (index(name, picture_folder//'/') == 1) then
         if (.not. is_plain(name(len(picture_folder) + 2:))) return
         do i = 1, size(picture_endings)
            is = is .or. has_form(name, picture_folder//'/', trim(picture_endings(i)))
         end do
         return
      end if
      if (.not. is_plain(name)) return
      is = any(fixed_names == name)
      do i = 1, size(beginnings)
         if (endings(i) /= '.csv') then           ! of any model
            is = is .or. has_form(name, trim(beginnings(i)), trim(endings(i)))
            cycle
         end if
         do j = 1, size(model_name)
            is = is .or. has_form(name, trim(beginnings(i)), '_'//trim(model_name(j))//trim(endings(i)))
         end do
      end do
      do i = 1, size(forms)
         j = index(forms(i)%text, anything)
         if (j == 0) then
            is = is .or. name == forms(i)%text
         else
            is = is .or. has_form(name, forms(i)%text(:j - 1), forms(i)%text(j + 1:))
         end if
      end do
   end function is_result_name

   !> True if a name may be that of a record.
   pure function is_record_name(name, kinds) result(is)
      character(*), intent(in) :: name
      type(text_type), intent(in) :: kinds(:)      !< of studies that keep records: sweep
      logical :: is
      integer :: part, of, i
      is = .false.
      if (.not. is_plain(name)) return
      if (.not. any([(index(name, kinds(i)%text//'_') == 1, i=1, size(kinds))])) return
      is = has_form(name, '', '.partial') .or. has_form(name, '', '.failed')
      part = index(name, '.part_', back=.true.)
      of = index(name, '_of_', back=.true.)
      if (is .or. part == 0 .or. of <= part + len('.part_') .or. of + len('_of_') > len(name)) return
      is = verify(name(part + len('.part_'):of - 1), digits) == 0 .and. verify(name(of + len('_of_'):), digits) == 0
   end function is_record_name

   !> True if a name has this beginning and this ending, with something between.
   pure function has_form(name, beginning, ending) result(has)
      character(*), intent(in) :: name, beginning, ending
      logical :: has
      has = len(name) > len(beginning) + len(ending)
      if (has) has = name(:len(beginning)) == beginning .and. name(len(name) - len(ending) + 1:) == ending
   end function has_form

   pure function is_plain(name) result(is)
      character(*), intent(in) :: name
      logical :: is
      is = len(name) > 0 .and. len(name) <= longest_name .and. verify(name, letters) == 0
      if (is) is = name(1:1) /= '.'
   end function is_plain
end module dg_result_name

!> The numbers behind a picture: some rows of them for a table, and the file that has all.
module dg_picture_data
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: column_named, column_type, field_list_type, put, put_none
   use dg_contacts_file, only: contact_columns, contact_fields
   use dg_csv_reading, only: columns_in, csv_texts, ends_in_quotes, read_csv_row
   use dg_file_lines, only: read_lines
   use dg_job, only: job_type
   use dg_missing, only: is_missing
   use dg_profile_columns, only: profile_columns, profile_values
   use dg_text, only: text_type
   implicit none
   private
   public :: picture_data_type, rows_of_file, rows_along, rows_of_contacts

   type :: picture_data_type
      character(:), allocatable :: file                 !< of results
      type(column_type), allocatable :: columns(:)      !< of the rows
      type(field_list_type), allocatable :: rows(:)
      integer :: every = 1                              !< rows of the file a row here
   end type picture_data_type

   !> About so many depths of a table are evenly apart.
   integer, parameter :: usual_rows = 20
   !> Most rows of a table that is taken from a file: more make a long page, and nobody reads them there.
   integer, parameter :: most_rows = 200

contains

   !> Some columns of a CSV file of results that a picture is drawn from: of the rows in which the texts of other columns are those
   !> of `matching`. Of more than two hundred such rows some, evenly apart. A file that cannot be read leaves no rows.
   function rows_of_file(job, file, columns, names, matching) result(data)
      type(job_type), intent(in) :: job
      character(*), intent(in) :: file                  !< in the output folder
      type(column_type), intent(in) :: columns(:)       !< of that file
      character(*), intent(in) :: names(:)              !< of those that are shown
      type(text_type), intent(in) :: matching(:)        !< a name of a column and a text, by turns
      type(picture_data_type) :: data
      type(column_type) :: others(size(matching)/2)
      type(text_type), allocatable :: lines(:), texts(:)
      type(field_list_type), allocatable :: rows(:)
      type(field_list_type) :: row
      integer :: places(size(names)), at(size(matching)/2)
      character(:), allocatable :: line, failure
      integer :: i, n
      data%file = file
      allocate (data%columns(size(names)))
      do i = 1, size(names)
         data%columns(i) = column_named(columns, trim(names(i)))
      end do
      do i = 1, size(others)
         others(i) = column_named(columns, matching(2*i - 1)%text)
      end do
      call read_lines(job%output_dir//'/'//file, lines, failure)
      allocate (rows(size(lines)))
      n = 0
      line = ''
      do i = 1, size(lines)
         line = line//lines(i)%text
         if (ends_in_quotes(line)) cycle
         call csv_texts(line, texts)
         line = ''
         if (i == 1) then
            places = columns_in(texts, data%columns, job%units)
            at = columns_in(texts, others, job%units)
            cycle
         end if
         if (.not. matches()) cycle
         call read_csv_row(texts, places, data%columns, job%units, row)
         n = n + 1
         rows(n) = row
      end do
      data%every = max(1, (n + most_rows - 1)/most_rows)
      data%rows = rows(1:n:data%every)
   contains
      pure function matches() result(yes)
         logical :: yes
         integer :: k
         yes = .true.
         do k = 1, size(at)
            if (at(k) < 1 .or. at(k) > size(texts)) cycle
            yes = yes .and. texts(at(k))%text == matching(2*k)%text
         end do
      end function matches
   end function rows_of_file

   !> Columns of a profile at depths that are about evenly apart, and where any of them is largest or least.
   pure function rows_along(file, names, result, along) result(data)
      character(*), intent(in) :: file
      character(*), intent(in) :: names(:)              !< of columns of profile_columns, md first
      type(case_result_type), intent(in) :: result      !< with a profile
      type(along_string_type), intent(in) :: along
      type(picture_data_type) :: data
      real(wp) :: values(size(result%profile%md), size(names))
      logical :: shown(size(result%profile%md))
      integer :: i, j, n
      data%file = file
      n = size(result%profile%md)
      shown = .false.
      do i = 0, usual_rows
         shown(minloc(abs(result%profile%md - (result%profile%md(1) + (result%profile%md(n) - result%profile%md(1))*i/ &
                                               usual_rows)), dim=1)) = .true.
      end do
      allocate (data%columns(size(names)))
      do j = 1, size(names)
         data%columns(j) = column_named(profile_columns, trim(names(j)))
         call profile_values(trim(names(j)), result%profile, along, values(:, j))
         associate (known => .not. is_missing(values(:, j)))
            if (.not. any(known)) cycle
            shown(minloc(values(:, j), mask=known, dim=1)) = .true.
            shown(maxloc(values(:, j), mask=known, dim=1)) = .true.
         end associate
      end do
      allocate (data%rows(count(shown)))
      n = 0
      do i = 1, size(shown)
         if (.not. shown(i)) cycle
         n = n + 1
         do j = 1, size(names)
            if (is_missing(values(i, j))) then
               call put_none(data%rows(n))
            else
               call put(data%rows(n), values(i, j))
            end if
         end do
      end do
   end function rows_along

   !> The contacts below a depth [m].
   pure function rows_of_contacts(file, result, from) result(data)
      character(*), intent(in) :: file
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: from
      type(picture_data_type) :: data
      integer :: i, n
      data%file = file
      allocate (data%columns, source=contact_columns)
      if (.not. allocated(result%contacts)) then
         allocate (data%rows(0))
         return
      end if
      allocate (data%rows(count(result%contacts%md >= from)))
      n = 0
      do i = 1, size(result%contacts)
         if (result%contacts(i)%md < from) cycle
         n = n + 1
         call contact_fields(result%contacts(i), data%rows(n))
      end do
   end function rows_of_contacts
end module dg_picture_data

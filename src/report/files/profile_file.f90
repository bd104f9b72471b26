!> profile_<case>_<model>.csv: results along the string, surface to bit.
module dg_profile_file
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: csv_header, put_csv_value, quantity_text, unit_size
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_job, only: job_type
   use dg_profile_columns, only: code_names, profile_codes, profile_columns, profile_values
   use dg_ten_digits, only: longest_number
   use dg_text, only: put_piece, text_type
   implicit none
   private
   public :: write_profile

contains

   !> Writes the profile of `result` to `path`.
   subroutine write_profile(path, job, result, along, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      real(wp), allocatable :: values(:, :)
      integer, allocatable :: codes(:, :)
      character(10) :: names(0:2, size(profile_columns))    ! none longer than a number
      real(wp) :: unit(size(profile_columns))
      character(size(profile_columns)*(longest_number + 1)) :: row
      integer :: i, j, n, filled
      n = 0
      if (allocated(result%profile%md)) n = size(result%profile%md)
      allocate (lines(0:n), values(n, size(profile_columns)), codes(n, size(profile_columns)))
      lines(0)%text = csv_header(profile_columns, job%units)
      do j = 1, size(profile_columns)
         unit(j) = unit_size(profile_columns(j)%quantity, job%units)
         names(:, j) = code_names(trim(profile_columns(j)%name))
         if (n == 0) cycle
         call profile_values(trim(profile_columns(j)%name), result%profile, along, values(:, j))
         call profile_codes(trim(profile_columns(j)%name), result%profile, along, codes(:, j))
      end do
      do i = 1, n
         filled = 0
         do j = 1, size(profile_columns)
            if (profile_columns(j)%quantity == quantity_text) then
               call put_piece(row, filled, trim(names(codes(i, j), j)))
            else
               call put_csv_value(row, filled, values(i, j), unit(j))
            end if
            filled = filled + 1
            row(filled:filled) = ','
         end do
         lines(i)%text = row(:filled - 1)
      end do
      call write_text_file(path, lines, error)
   end subroutine write_profile
end module dg_profile_file

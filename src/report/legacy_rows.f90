!> legacy_<label>.csv: another program's results beside ours, one row a model and depth.
module dg_legacy_rows
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_hole_interval, only: interval_at, interval_name
   use dg_job, only: job_type, model_name
   use dg_legacy_comparison, only: comparison_type
   use dg_legacy_table, only: quantity_count
   use dg_kinds, only: wp
   use dg_number_text, only: csv_number
   use dg_text, only: append_text, text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: append_legacy_rows, legacy_header, write_legacy_file

contains

   pure function legacy_header(units) result(header)
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: header
      character(:), allocatable :: length, force, moment, side
      length = '_'//trim(units%length_label)
      force = '_'//trim(units%force_label)
      moment = '_'//trim(units%moment_label)
      side = '_'//trim(units%force_per_length_label)
      header = 'case,model,md'//length//',hole,axial'//force//',legacy_axial'//force//',axial_difference'//force// &
         ',torque'//moment//',legacy_torque'//moment//',torque_difference'//moment//',side_force'//side// &
         ',legacy_side_force'//side//',side_force_difference'//side
   end function legacy_header

   !> Appends the rows of one model; fields of a quantity that the table has not are empty but for ours.
   subroutine append_legacy_rows(lines, units, case_name, model, comparison)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      type(comparison_type), intent(in) :: comparison
      character(:), allocatable :: row
      real(wp) :: factor(quantity_count)
      integer :: i, k
      factor = [units%force, units%moment, units%force_per_length]
      do i = 1, size(comparison%md)
         row = case_name//','//trim(model_name(model))//','//csv_number(comparison%md(i)/units%length)//','// &
            trim(interval_name(comparison%intervals(interval_at(comparison%intervals, comparison%md(i)))%kind))
         do k = 1, quantity_count
            row = row//','//csv_number(comparison%ours(i, k)/factor(k))
            if (comparison%parting(k)%present) then
               row = row//','//csv_number(comparison%theirs(i, k)/factor(k))//','// &
                  csv_number((comparison%theirs(i, k) - comparison%ours(i, k))/factor(k))
            else
               row = row//',,'
            end if
         end do
         call append_text(lines, row)
      end do
   end subroutine append_legacy_rows

   !> Writes header and rows to `path`.
   subroutine write_legacy_file(path, job, rows, error)
      character(*), intent(in) :: path
      type(job_type), intent(in) :: job
      type(text_type), intent(in) :: rows(:)
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: lines(:)
      integer :: i
      allocate (lines(0:size(rows)))
      lines(0)%text = legacy_header(job%units)
      do i = 1, size(rows)
         lines(i)%text = rows(i)%text
      end do
      call write_text_file(path, lines, error)
   end subroutine write_legacy_file
end module dg_legacy_rows

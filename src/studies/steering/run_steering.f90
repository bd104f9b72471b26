!> Runs what a &steering asks: each load case at each toolface.
module dg_run_steering
   use dg_case_result, only: result_not_converged
   use dg_diagnostic, only: tell
   use dg_equilibrium_curvature, only: find_equilibrium_curvature
   use dg_error, only: error_type
   use dg_interruption, only: is_interrupted
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_missing, only: is_missing
   use dg_model, only: model_type
   use dg_printed_text, only: print_and_keep, printed_text_type
   use dg_run_outcome, only: add_part, note_lost
   use dg_steering_file, only: write_steering
   use dg_steering_result, only: steering_result_type
   use dg_steering_table, only: steering_table
   use dg_text, only: quoted, text_type
   use dg_threads, only: thread_count
   implicit none
   private
   public :: run_steering

contains

   !> Solves, writes steering.csv, prints. `lost` counts those without a curvature.
   subroutine run_steering(printed, job, model, lost, error)
      type(printed_text_type), intent(inout) :: printed
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      integer, intent(out) :: lost
      type(error_type), allocatable, intent(out) :: error
      type(steering_result_type), allocatable :: results(:)
      type(text_type), allocatable :: lines(:)
      integer :: i, k, row, each
      lost = 0
      associate (steering => job%steering)
         each = max(size(steering%toolfaces), 1)
         allocate (results(each*size(steering%cases)))
         !$omp parallel do schedule(dynamic, 1) num_threads(thread_count(job%threads, size(results))) default(shared) &
         !$omp private(row, k)
         do row = 1, size(results)
            k = steering%cases((row - 1)/each + 1)
            call find_equilibrium_curvature(model, k, toolface_of(k, modulo(row - 1, each) + 1), steering%length, &
                                            steering%side_cutting, results(row))
         end do
         !$omp end parallel do
      end associate
      if (is_interrupted()) return
      call once_each(results)
      do i = 1, size(results)
         if (results(i)%found .and. len(results(i)%message) == 0) cycle
         if (.not. results(i)%found) then
            lost = lost + 1
            call note_lost(printed%outcome, 'steering', 0, result_not_converged, results(i)%message, &
                           model%cases(results(i)%case_index))
         end if
         call tell('steering, case '//quoted(model%cases(results(i)%case_index)%name)// &
                   trim(merge(':              ', ': no curvature;', results(i)%found))//' '//results(i)%message)
      end do
      call add_part(printed%outcome, 'steering', size(results), 0, lost)
      call write_steering(job%output_dir//'/steering.csv', job, model, results, error)
      if (allocated(error)) return
      allocate (lines, source=steering_table(job, model, results))
      call print_and_keep(printed, lines)
   contains
      pure function toolface_of(case_index, number) result(toolface)
         integer, intent(in) :: case_index, number
         real(wp) :: toolface
         toolface = model%cases(case_index)%toolface
         if (size(job%steering%toolfaces) > 0) toolface = job%steering%toolfaces(number)
      end function toolface_of
   end subroutine run_steering

   !> A case that no toolface changes has one row.
   subroutine once_each(results)
      type(steering_result_type), allocatable, intent(inout) :: results(:)
      logical :: kept(size(results))
      type(steering_result_type), allocatable :: fewer(:)
      integer :: i, n
      kept = .true.
      do i = 2, size(results)
         kept(i) = .not. (is_missing(results(i)%toolface) .and. results(i)%case_index == results(i - 1)%case_index)
      end do
      allocate (fewer(count(kept)))
      n = 0
      do i = 1, size(results)
         if (.not. kept(i)) cycle
         n = n + 1
         fewer(n) = results(i)
      end do
      call move_alloc(fewer, results)
   end subroutine once_each
end module dg_run_steering

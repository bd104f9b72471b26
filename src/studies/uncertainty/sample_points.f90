!> The samples of a Monte Carlo at the points of its range, on all cores.
module dg_sample_points
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged, result_not_converged
   use dg_ensemble_record, only: ensemble_type, keep
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_type
   use dg_interruption, only: is_interrupted
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_sampled_model, only: draw_model
   use dg_sweep, only: point_at, point_case, point_count, point_type
   use dg_sweep_points, only: solve_totals
   use dg_sweep_result, only: is_solved, sweep_result_type
   use dg_sweep_work, only: in_part
   use dg_text, only: to_text
   use dg_threads, only: thread_count
   use dg_uncertainty, only: piece_number, uncertainty_type
   implicit none
   private
   public :: solve_samples

contains

   !> Solve the missing samples of this part, one after another. A sample's inputs depend only on the seed and its number.
   !> Results therefore do not depend on the number of threads, on parts, nor on earlier samples.
   subroutine solve_samples(job, model, uncertainty, ensemble, watch)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(uncertainty_type), intent(in) :: uncertainty
      type(ensemble_type), intent(inout) :: ensemble
      class(ensemble_watch_type), intent(inout) :: watch
      logical, allocatable :: left(:)
      real(wp) :: before
      integer :: i, solved
      allocate (left, source=.not. is_solved(ensemble%points) .and. &
                             in_part([(i, i=1, size(ensemble%points))], job%part, max(job%parts, 1)))
      solved = count(is_solved(ensemble%points))
      before = share()
      !$omp parallel num_threads(thread_count(job%threads, uncertainty%samples)) default(shared)
      call share_samples()
      !$omp end parallel

   contains

      !> Part of the work of this part that is done [-].
      function share() result(done)
         real(wp) :: done
         done = real(solved, wp)*real(max(job%parts, 1), wp)/real(size(ensemble%points), wp)
      end function share

      !> Work of one thread.
      subroutine share_samples()
         type(model_type) :: mine
         type(error_type), allocatable :: no_path
         type(sweep_result_type) :: found(point_count(uncertainty%range))
         integer :: point, sample, piece
         !$omp do schedule(dynamic, 1)
         do sample = 1, uncertainty%samples
            if (is_interrupted()) cycle
            if (.not. any(left([(piece_number(uncertainty, point, sample), point=1, size(found))]))) cycle
            call draw_model(model, uncertainty, sample, mine, no_path)
            do point = 1, size(found)
               if (.not. left(piece_number(uncertainty, point, sample))) cycle
               if (allocated(no_path)) then
                  found(point)%status = result_not_converged
                  found(point)%message = no_path%message
               else
                  call solve_point(mine, uncertainty, point_at(uncertainty%range, point), found(point))
               end if
            end do
            ! the list of all pieces is touched here only: its record is written from it
            !$omp critical (uncertainty_results)
            do point = 1, size(found)
               piece = piece_number(uncertainty, point, sample)
               if (.not. left(piece) .or. .not. is_solved(found(point))) cycle
               ensemble%points(piece) = found(point)
               solved = solved + 1
               call keep(ensemble, piece)
            end do
            call watch%show(share(), before, to_text(solved)//' of '//to_text(size(ensemble%points))//' solutions')
            !$omp end critical (uncertainty_results)
         end do
         !$omp end do
      end subroutine share_samples
   end subroutine solve_samples

   !> Solves one point of a sample. Warnings are left out: there are as many as solutions.
   subroutine solve_point(model, uncertainty, point, found)
      type(model_type), intent(inout) :: model     !< its first load case is overwritten
      type(uncertainty_type), intent(in) :: uncertainty
      type(point_type), intent(in) :: point
      type(sweep_result_type), intent(out) :: found
      call point_case(uncertainty%range, point, model%cases(1))
      model%cases(1)%friction_axial%present = .false.      ! the sections have it as it was drawn
      model%cases(1)%friction_rotary%present = .false.
      call solve_totals(model, uncertainty%range%models(point%model), found)
      if (found%status == result_converged .and. allocated(found%message)) deallocate (found%message)
   end subroutine solve_point
end module dg_sample_points

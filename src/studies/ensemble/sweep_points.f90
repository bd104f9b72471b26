!> The points of a sweep, on all cores: their solutions, and their margins to the limits of rig and string.
module dg_sweep_points
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type, find_along_string
   use dg_case_result, only: case_result_type, has_numbers, result_converged, result_locked_up, result_not_converged
   use dg_ensemble_record, only: ensemble_type, keep
   use dg_ensemble_watch, only: ensemble_watch_type
   use dg_error, only: error_type
   use dg_interruption, only: by_signals, is_interrupted
   use dg_job, only: job_type, model_mcge, model_name, model_soft
   use dg_load_case, only: operation_label
   use dg_missing, only: is_missing, missing
   use dg_model, only: copy_without_cases, model_type, string_index
   use dg_rig, only: indicated_load
   use dg_solve_case, only: solve_case
   use dg_string_weight, only: passed_weight
   use dg_sweep, only: point_at, point_case, point_count, point_holes, point_type, sweep_type
   use dg_sweep_result, only: is_solved, sweep_result_type
   use dg_sweep_work, only: in_part
   use dg_text, only: to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_threads, only: thread_count
   use dg_units, only: unit_system_type
   use dg_utilisation, only: as_much, find_utilisation, has_rating, limit_rig, limit_top_drive, part_limits, utilisation_type
   use dg_verdict, only: limit_lock_up
   implicit none
   private
   public :: solve_points, solve_totals, point_text, add_indicator, add_limits

   !> Most points that a thread solves before it returns their results.
   integer, parameter :: block_size = 16

contains

   !> Solve the points of this part that have no result yet, as many at a time as the job allows. Points are independent:
   !> results do not depend on the number of threads, nor on earlier points. After a signal the rest is not solved.
   subroutine solve_points(job, model, sweep, ensemble, watch)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(ensemble_type), intent(inout) :: ensemble
      class(ensemble_watch_type), intent(inout) :: watch
      integer, allocatable :: left(:), blocks(:)
      real(wp) :: work, done, before
      integer :: i, solved
      associate (points => ensemble%points)
         left = pack([(i, i=1, size(points))], .not. is_solved(points) .and. &
                     in_part([(i, i=1, size(points))], job%part, max(job%parts, 1)))
         solved = count(is_solved(points))
      end associate
      blocks = starts_of_blocks(sweep, left)
      ! a deep string costs more than a shallow one, about in proportion
      work = sum_of_depths(sweep, job)
      done = work - sum([(depth_of(sweep, left(i)), i=1, size(left))])
      before = done/work
      !$omp parallel num_threads(thread_count(job%threads, size(blocks) - 1)) default(shared)
      call share_points()
      !$omp end parallel

   contains

      !> Work of one thread: with a model of its own, whose one load case becomes point after point.
      subroutine share_points()
         type(model_type) :: mine
         type(sweep_result_type) :: found(block_size)
         integer :: block, k, first, last
         call copy_without_cases(model, mine)
         !$omp do schedule(dynamic, 1)
         do block = 1, size(blocks) - 1
            first = blocks(block)
            last = blocks(block + 1) - 1
            do k = first, last
               call solve_point(mine, sweep, point_at(sweep, left(k)), found(k - first + 1))
            end do
            ! the list of all points is touched here only: its record is written from it
            !$omp critical (sweep_results)
            do k = first, last
               if (.not. is_solved(found(k - first + 1))) cycle      ! a signal came
               ensemble%points(left(k)) = found(k - first + 1)
               done = done + depth_of(sweep, left(k))
               solved = solved + 1
               call keep(ensemble, left(k))
            end do
            call watch%show(done/work, before, to_text(solved)//' of '//to_text(size(ensemble%points))//' points')
            !$omp end critical (sweep_results)
         end do
         !$omp end do
      end subroutine share_points
   end subroutine solve_points

   !> Add readings of the weight indicator to solved points, in the order of their numbers, each with all of its samples.
   subroutine add_indicator(model, sweep, samples, points)
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: samples               !< of a point; 1 where nothing is drawn
      type(sweep_result_type), intent(inout) :: points(:)
      type(point_type) :: place
      integer :: i
      if (.not. model%rig%given) return
      do i = 1, size(points)
         place = point_at(sweep, (i - 1)/samples + 1)
         if (.not. has_numbers(points(i)%status)) cycle
         points(i)%weight_indicator = indicated_load(model%rig, sweep%operations(place%operation), points(i)%hookload)
      end do
   end subroutine add_indicator

   !> Add the margins to the limits of rig and string, and the limit that each point passes. That is lock-up, string weight,
   !> else the most used of rig and strengths. Strengths, and the pull until yield, are by the soft string, which has a force
   !> at every depth in microseconds. The friction of a buckled string is included for models that lack it.
   subroutine add_limits(job, model, sweep, points)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(inout) :: points(:)
      logical :: rated
      integer :: i
      associate (rig => model%rig, string => model%strings(string_index(model%strings, sweep%string)))
         where (points%status == result_converged)
            points%rig_margin = merge(rig%max_hookload%value - rig%block_weight - points%hookload, missing, &
                                      rig%max_hookload%present)
            points%torque_margin = merge(rig%max_torque%value - points%torque, missing, rig%max_torque%present)
         end where
         rated = any([(has_rating(string%components, part_limits(i)), i=1, size(part_limits))])
      end associate
      where (is_below_zero(points%torque_margin)) points%limit = limit_top_drive
      where (is_below_zero(points%rig_margin)) points%limit = limit_rig
      where (points%status == result_locked_up) points%limit = limit_lock_up
      !$omp parallel num_threads(thread_count(job%threads, size(points)/block_size)) default(shared)
      call share_points()
      !$omp end parallel
   contains
      !> Work of one thread, with a model of its own.
      subroutine share_points()
         type(model_type) :: mine
         type(point_type) :: place
         integer :: n, passed
         call copy_without_cases(model, mine)
         !$omp do schedule(dynamic, block_size)
         do n = 1, size(points)
            if (points(n)%status /= result_converged) cycle
            place = point_at(sweep, n)
            call point_case(sweep, place, mine%cases(1))
            call point_holes(sweep, place, mine%holes)
            if (rated .and. .not. is_interrupted()) call judge_strengths(mine, points(n))
            passed = passed_weight(mine, sweep%models(place%model), 1, points(n)%hookload, abs(points(n)%hookload))
            if (passed > 0) points(n)%limit = passed
         end do
         !$omp end do
      end subroutine share_points

      !> True for a margin that is known and passed.
      elemental function is_below_zero(margin)
         real(wp), intent(in) :: margin
         logical :: is_below_zero
         is_below_zero = .not. is_missing(margin) .and. margin < 0.0_wp
      end function is_below_zero
   end subroutine add_limits

   !> Set the most used of rig and strengths if it is passed, and the pull until yield.
   subroutine judge_strengths(model, point)
      type(model_type), intent(in) :: model                !< its first load case is that of the point
      type(sweep_result_type), intent(inout) :: point
      type(case_result_type) :: result
      type(along_string_type) :: along
      type(utilisation_type) :: utilisation
      type(error_type), allocatable :: error
      call solve_case(model, model_soft, 1, result, error, stop=by_signals())
      if (result%status /= result_converged) return
      call find_along_string(model, result, along)
      if (.not. all(is_missing(along%overpull))) &
         point%overpull_margin = minval(along%overpull, mask=.not. is_missing(along%overpull))
      result%hookload = point%hookload
      result%torque = point%torque
      call find_utilisation(model, result, along, utilisation)
      if (utilisation%governing == 0) return
      if (utilisation%used(utilisation%governing)%value > 1.0_wp + as_much) point%limit = utilisation%governing
   end subroutine judge_strengths

   !> Where blocks of points begin that a thread solves before it hands over the results, and the end of the last + 1. Beams
   !> go one by one; the other models take microseconds, less than the threads would wait for each other.
   pure function starts_of_blocks(sweep, left) result(starts)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: left(:)       !< numbers of points, ascending
      integer, allocatable :: starts(:)
      type(point_type) :: point
      integer :: k, n
      allocate (starts(size(left) + 1))
      n = 0
      k = 1
      do while (k <= size(left))
         n = n + 1
         starts(n) = k
         point = point_at(sweep, left(k))
         k = k + merge(1, block_size, sweep%models(point%model) == model_mcge)
      end do
      n = n + 1
      starts(n) = size(left) + 1
      starts = starts(:n)
   end function starts_of_blocks

   !> Solves one point.
   subroutine solve_point(model, sweep, point, found)
      type(model_type), intent(inout) :: model     !< its first load case is overwritten
      type(sweep_type), intent(in) :: sweep
      type(point_type), intent(in) :: point
      type(sweep_result_type), intent(out) :: found
      call point_case(sweep, point, model%cases(1))
      call point_holes(sweep, point, model%holes)
      call solve_totals(model, sweep%models(point%model), found)
   end subroutine solve_point

   !> Hook load and torque of the first load case, with the message of its solution. A case that is interrupted by a signal
   !> stays unsolved, for the next run.
   subroutine solve_totals(model, number, found)
      type(model_type), intent(in) :: model
      integer, intent(in) :: number                !< of the model that solves
      type(sweep_result_type), intent(out) :: found
      type(case_result_type) :: result
      type(error_type), allocatable :: error
      call solve_case(model, number, 1, result, error, totals_only=.true., stop=by_signals())
      if (is_interrupted() .and. result%status == result_not_converged) return
      found%status = result%status
      found%hookload = result%hookload
      found%torque = result%torque
      if (result%message /= '') found%message = result%message
   end subroutine solve_totals

   !> Bit depth of a point [m].
   pure function depth_of(sweep, number) result(depth)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number
      real(wp) :: depth
      depth = sweep%depths(modulo(number - 1, size(sweep%depths)) + 1)
   end function depth_of

   !> Sum of the bit depths of all points of this part [m].
   pure function sum_of_depths(sweep, job) result(depths)
      type(sweep_type), intent(in) :: sweep
      type(job_type), intent(in) :: job
      real(wp) :: depths
      integer :: i
      depths = 0.0_wp
      do i = job%part, point_count(sweep), max(job%parts, 1)
         depths = depths + depth_of(sweep, i)
      end do
   end function sum_of_depths

   !> A point in words: model, operation, friction where the sweep has it, bit depth.
   pure function point_text(units, sweep, number) result(text)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number                !< of the point
      character(:), allocatable :: text
      type(point_type) :: point
      point = point_at(sweep, number)
      text = trim(model_name(sweep%models(point%model)))//', '//trim(operation_label(sweep%operations(point%operation)))
      if (sweep%frictions(point%friction)%present) text = text//', friction '//to_text(sweep%frictions(point%friction)%value)
      text = text//', bit at '//in_units(units, unit_length, sweep%depths(point%depth), 7)
   end function point_text
end module dg_sweep_points

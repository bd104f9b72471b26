!> Sentences of a sweep: limits that it passes, and where first; warnings of its points.
module dg_sweep_sentences
   use dg_case_result, only: has_numbers
   use dg_kinds, only: wp
   use dg_job, only: model_name
   use dg_load_case, only: operation_label
   use dg_measured_table, only: factor_text
   use dg_missing, only: is_missing
   use dg_number_text, only: append_wrapped
   use dg_readable, only: first_names, squeezed
   use dg_sweep, only: model_of, point_at, point_count, point_number, point_type, sweep_type
   use dg_sweep_result, only: answer_of, sweep_result_type
   use dg_text, only: append_text, either, text_type, to_text
   use dg_unit_kind, only: in_units, unit_length
   use dg_units, only: unit_system_type
   use dg_verdict, only: answer_no, answer_yes, limit_title
   implicit none
   private
   public :: append_answers, append_warned, friction_text, sweep_sentences

   !> Limits that a sentence tells.
   integer, parameter :: most_passed = 6
   !> Ranges of depth in a sentence.
   integer, parameter :: most_ranges = 5
   integer, parameter :: depth_digits = 7
   !> Letters in which warnings of one kind may differ.
   character(*), parameter :: digits_and_point = '0123456789.'

contains

   !> Sentences on a sweep for the top of a page, one a model: which limits it passes, and where first.
   pure function sweep_sentences(units, sweep, points) result(lines)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      type(text_type), allocatable :: lines(:), passed(:)
      character(:), allocatable :: text
      integer :: m, i, warned
      allocate (lines(0))
      do m = 1, size(sweep%models)
         text = 'Sweep '//sweep%name//', model '//trim(model_name(sweep%models(m)))//': '
         if (allocated(passed)) deallocate (passed)
         allocate (passed(0))
         call append_answers(passed, units, sweep, points, m)
         text = text//passed(1)%text
         do i = 2, min(size(passed), most_passed)
            text = text//'. '//passed(i)%text
         end do
         if (size(passed) > most_passed) text = text//'. '//to_text(size(passed) - most_passed)//' more in its table'
         warned = count(is_warned(points) .and. points_of_model(sweep, m))
         if (warned > 0) text = text//'. Points with a warning: '//to_text(warned)//', see column message of its file'
         call append_text(lines, text)
      end do
   end function sweep_sentences

   !> Depths at which an operation of a model cannot be done at a friction factor, and the limit that is passed there. If
   !> there is none, one sentence on all points of the model.
   pure subroutine append_answers(lines, units, sweep, points, model)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      character(:), allocatable :: place
      logical :: there(size(sweep%depths))
      integer :: o, f, first, upper
      logical :: impossible
      impossible = .false.
      do o = 1, size(sweep%operations)
         do f = 1, size(sweep%frictions)
            first = point_number(sweep, point_type(model, o, f, 1))
            there = answer_of(points(first:first + size(there) - 1)) == answer_no
            if (.not. any(there)) cycle
            impossible = .true.
            upper = findloc(there, .true., dim=1)
            place = ranges_text(units, sweep, there)
            call append_text(lines, 'Cannot be done '//place//': '//trim(operation_label(sweep%operations(o)))//', '// &
                             friction_text(sweep, f)//' ('//trim(limit_title(points(first + upper - 1)%limit))//')')
         end do
      end do
      if (.not. impossible) call append_text(lines, possible_text(pack(points, points_of_model(sweep, model))))
   end subroutine append_answers

   !> Answer of points that pass no limit.
   pure function possible_text(points) result(text)
      type(sweep_result_type), intent(in) :: points(:)
      character(:), allocatable :: text
      integer :: solved
      solved = count(answer_of(points) == answer_yes)
      text = 'Can be done'
      if (solved < size(points)) text = text//' at '//to_text(solved)//' of '//to_text(size(points))// &
                                        ' points, the others have no solution'
      if (.not. all(is_missing(points%rig_margin) .and. is_missing(points%torque_margin) .and. &
                    is_missing(points%overpull_margin))) then
         text = text//'. No limit of rig or string is passed'
      else
         text = text//either(', ', ' ', solved < size(points))//'by string weight'//either(' and push', '', &
            any(has_numbers(points%status) .and. points%hookload < 0.0_wp))//'. No limits of rig or string are known'
      end if
   end function possible_text

   !> Depths that count, one range after the other: 'from 1000 m to 1200 m and from 1500 m'.
   pure function ranges_text(units, sweep, there) result(text)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      logical, intent(in) :: there(:)      !< one a depth; some are true
      character(:), allocatable :: text
      type(text_type), allocatable :: ranges(:)
      character(:), allocatable :: range
      integer :: upper, lower
      if (all(there) .and. size(there) > 1) then
         text = 'at any depth from '//depth_text(units, sweep, 1)//' to '//depth_text(units, sweep, size(there))
         return
      end if
      allocate (ranges(0))
      lower = 0
      do while (any(there(lower + 1:)))
         upper = lower + findloc(there(lower + 1:), .true., dim=1)
         lower = upper - 1 + findloc([there(upper:), .false.], .false., dim=1) - 1
         range = 'from '//depth_text(units, sweep, upper)
         if (upper == 1) range = range//', the least depth of the sweep'
         if (lower < size(there)) range = range//either(',', '', upper == 1)//' to '//depth_text(units, sweep, lower)
         if (lower == upper .and. (lower < size(there) .or. upper == 1)) range = 'at '//depth_text(units, sweep, upper)
         call append_text(ranges, range)
      end do
      text = first_names(ranges, most_ranges)
   end function ranges_text

   !> Warnings of the points of a model that can be done. Warnings are of one kind if they are alike but for their numbers. Each
   !> kind has one line, with the warning of its deepest point.
   pure subroutine append_warned(lines, units, sweep, points, model)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      type(sweep_result_type), intent(in) :: points(:)
      integer, intent(in) :: model
      logical :: left(size(points)), alike(size(points))
      type(point_type) :: point
      character(:), allocatable :: kind
      real(wp) :: depth
      integer :: i, deepest
      left = is_warned(points) .and. points_of_model(sweep, model)
      do while (any(left))
         kind = squeezed(points(findloc(left, .true., dim=1))%message, digits_and_point)
         alike = .false.
         depth = 0.0_wp
         do i = 1, size(points)
            if (.not. left(i)) cycle
            alike(i) = squeezed(points(i)%message, digits_and_point) == kind
            if (.not. alike(i)) cycle
            point = point_at(sweep, i)
            if (sweep%depths(point%depth) < depth) cycle
            depth = sweep%depths(point%depth)
            deepest = i
         end do
         left = left .and. .not. alike
         point = point_at(sweep, deepest)
         call append_wrapped(lines, 'WARNING at '//to_text(count(alike))//either(' point', ' points', count(alike) == 1)// &
                          ' of model '//trim(model_name(sweep%models(model)))//either(', ', ', the deepest ', count(alike) == 1)// &
                          'at '//depth_text(units, sweep, point%depth)//', '// &
                          trim(operation_label(sweep%operations(point%operation)))//', '// &
                          friction_text(sweep, point%friction)//': '//points(deepest)%message)
      end do
   end subroutine append_warned

   !> True for a point that can be done, and has a warning.
   elemental function is_warned(point) result(warned)
      type(sweep_result_type), intent(in) :: point
      logical :: warned
      warned = answer_of(point) == answer_yes .and. allocated(point%message)
      if (warned) warned = point%message /= ''
   end function is_warned

   !> True for the points of a model.
   pure function points_of_model(sweep, model) result(are)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: model
      logical :: are(point_count(sweep))
      integer :: i
      are = [(model_of(sweep, i) == model, i=1, size(are))]
   end function points_of_model

   pure function depth_text(units, sweep, number) result(text)
      type(unit_system_type), intent(in) :: units
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number       !< of a depth
      character(:), allocatable :: text
      text = in_units(units, unit_length, sweep%depths(number), depth_digits)
   end function depth_text

   !> A friction factor in words, for messages and the legend.
   pure function friction_text(sweep, number) result(text)
      type(sweep_type), intent(in) :: sweep
      integer, intent(in) :: number       !< of a friction factor
      character(:), allocatable :: text
      text = 'friction of &hole'
      if (sweep%frictions(number)%present) text = 'friction '//factor_text(sweep, number)
   end function friction_text
end module dg_sweep_sentences

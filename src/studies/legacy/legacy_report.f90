!> Another program's results beside ours on standard output: table of differences, and in words where along the hole
!> the two part. Every line fits 120 columns.
module dg_legacy_report
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged, result_status_name
   use dg_hole_interval, only: interval_at, interval_name, interval_type
   use dg_job, only: model_name
   use dg_legacy_comparison, only: agreement, comparison_type, parting_type, legacy_table_type, quantity_axial, quantity_count, &
                                   quantity_of, quantity_side_force
   use dg_legacy_file, only: column_name
   use dg_number_text, only: left_aligned
   use dg_text, only: append_text, either, text_type, to_text
   use dg_text_table, only: add_cell, append_table, end_row, text_table_type
   use dg_unit_kind, only: in_units, unit_length, unit_factor, unit_label
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: legacy_report

   integer, parameter :: cell = 12
   integer, parameter :: hole_width = 10
   !> Rows of a printed table; the file has all.
   integer, parameter :: most_rows = 16
   !> Intervals of a hole that are listed; a noisy survey has dozens.
   integer, parameter :: most_intervals = 10
   !> Digits of forces and depths in words.
   integer, parameter :: shown = 5
   character(*), parameter :: quantity_words(quantity_count) = [character(11) :: 'axial force', 'torque', 'side force']
   real(wp), parameter :: one = 1.0_wp, per_cent = 100.0_wp
   !> Growth that is zero but for round-off, over the largest [-].
   real(wp), parameter :: round_off = 1.0e-9_wp
   !> Difference over our largest from which on theirs is hardly in the unit that is read [-].
   real(wp), parameter :: other_unit = 5.0_wp

contains

   !> Words, and where asked for the tables, of one table beside one model.
   pure function legacy_report(units, table, case_name, model, status, comparison, with_tables) result(lines)
      type(unit_system_type), intent(in) :: units
      type(legacy_table_type), intent(in) :: table
      character(*), intent(in) :: case_name
      integer, intent(in) :: model
      integer, intent(in) :: status               !< of our result
      type(comparison_type), intent(in) :: comparison
      logical, intent(in) :: with_tables
      type(text_type), allocatable :: lines(:)
      integer :: k
      allocate (lines(0))
      if (status /= result_converged) then
         call append_text(lines, '')
         call append_text(lines, 'Legacy '//table%label//' is not compared: case '//case_name//', model '// &
                          trim(model_name(model))//', has no solution ('//trim(result_status_name(status))//').')
         return
      end if
      call append_text(lines, '')
      call append_text(lines, 'Legacy '//table%label//' compared with case '//case_name//', model '// &
                       trim(model_name(model))//'. Difference: legacy - drillgap')
      if (comparison%outside > 0) call append_text(lines, to_text(comparison%outside)//' of '//to_text(size(table%md))// &
                                                   ' rows of the table lie beyond the string and are left out')
      if (size(comparison%md) == 0) return
      if (grows_with_depth(comparison)) then
         call append_text(lines, 'The force of the table grows with depth, that of drillgap falls. Hook loads at several bit')
         call append_text(lines, 'depths are given as measured_hookloads of &sweep, or as')
         call append_text(lines, 'reference_hookload, one load case per depth. &legacy compares forces along the string.')
      end if
      do k = 1, quantity_count
         if (.not. comparison%parting(k)%present) cycle
         if (with_tables) call append_columns(lines, units, k, comparison)
         call append_words(lines, units, k, comparison, comparison%parting(k))
      end do
   end function legacy_report

   !> True if their axial force is larger at the lowest depth than at the top and ours is not. Their table then looks like hook
   !> loads over bit depth.
   pure function grows_with_depth(comparison) result(grows)
      type(comparison_type), intent(in) :: comparison
      logical :: grows
      grows = comparison%parting(quantity_axial)%present
      if (.not. grows) return
      associate (theirs => comparison%theirs(:, quantity_axial), ours => comparison%ours(:, quantity_axial), &
                 n => size(comparison%md))
         grows = theirs(n) > theirs(1) .and. ours(n) < ours(1)
      end associate
   end function grows_with_depth

   !> Ours and theirs against depth, thinned out to `most_rows`.
   pure subroutine append_columns(lines, units, k, comparison)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: k
      type(comparison_type), intent(in) :: comparison
      type(text_table_type) :: table
      character(:), allocatable :: unit
      real(wp) :: factor, ours, theirs
      integer :: i, interval, n, row, rows
      factor = unit_factor(units, quantity_of(k))
      unit = '|'//unit_label(units, quantity_of(k))
      n = size(comparison%md)
      rows = min(n, most_rows)
      do row = 1, rows
         i = 1
         if (rows > 1) i = 1 + ((row - 1)*(n - 1))/(rows - 1)
         ours = comparison%ours(i, k)
         theirs = comparison%theirs(i, k)
         interval = interval_at(comparison%intervals, comparison%md(i))
         call add_cell(table, 'Depth|'//trim(units%length_label), cell, comparison%md(i), units%length, 1)
         call add_cell(table, 'Hole', hole_width, interval_name(comparison%intervals(interval)%kind))
         call add_cell(table, 'drillgap'//unit, cell, ours, factor, 3)
         call add_cell(table, 'Legacy'//unit, cell, theirs, factor, 3)
         call add_cell(table, 'Difference'//unit, cell, theirs - ours, factor, 3)
         call add_cell(table, '% of|largest', cell - 2, share_of(theirs - ours, comparison%parting(k)%scale), one, 2)
         call end_row(table, '')
      end do
      call append_table(lines, table)
   end subroutine append_columns

   !> Largest and mean difference, growth by interval of the hole, and where they part.
   pure subroutine append_words(lines, units, k, comparison, parting)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: k
      type(comparison_type), intent(in) :: comparison
      type(parting_type), intent(in) :: parting
      character(:), allocatable :: unit
      character(:), allocatable :: what
      real(wp) :: factor
      integer :: i, n
      logical :: listed(size(comparison%intervals))
      n = size(comparison%md)
      factor = unit_factor(units, quantity_of(k))
      unit = unit_label(units, quantity_of(k))
      what = trim(quantity_words(k))
      call append_text(lines, 'Difference in '//what//': largest '//signed(parting%largest/factor)//' '//unit//' ('// &
                       to_text(share_of(abs(parting%largest), parting%scale), 3)//' % of the largest) at '// &
                       depth(parting%largest_md)//', mean '//to_text(parting%mean/factor, shown)//' '//unit//' over '// &
                       to_text(size(comparison%md))//' depths')
      if (parting%agrees) then
         call append_text(lines, 'Both agree within 0.1 % of the largest '//what//'.')
         return
      end if
      if (abs(parting%largest) > other_unit*parting%scale) call append_text(lines, 'The values of the table are much '// &
         'larger: check the unit of the column ('//trim(column_name(k + 1))//'_unit) and the load case.')
      if (abs(parting%at_bottom) > agreement*parting%scale) &
         call append_text(lines, 'At the lowest depth, '//depth(comparison%md(n))//', the difference is '// &
                          growth_text(parting%at_bottom)// &
                          ' already.')
      call append_text(lines, either('Difference summed along the hole, from the bit up:', &
                                     'Change of the difference, from the bit up:', k == quantity_side_force))
      listed = listed_intervals(parting%growth)
      do i = size(comparison%intervals), 1, -1
         if (.not. listed(i)) cycle
         associate (interval => comparison%intervals(i))
            call append_text(lines, '  '//left_aligned(trim(interval_name(interval%kind)), hole_width)//'from '// &
                             depth(interval%md_bottom)//' up to '//depth(interval%md_top)//': '// &
                             growth_text(parting%growth(i))//remark(interval))
         end associate
      end do
      if (.not. all(listed)) call append_text(lines, '  '//to_text(count(.not. listed))//' other intervals together: '// &
                                            growth_text(sum(parting%growth, mask=.not. listed)))
      if (parting%worst == 0) then
         call append_text(lines, to_text(per_cent*parting%share, 3)//' % of the difference in '//what// &
                          ' exists at the lowest depth: compare the loads on the bit.')
         return
      end if
      associate (worst => comparison%intervals(parting%worst))
         call append_text(lines, 'The tables differ above '//depth(parting%parting_md)//'. '// &
                          to_text(per_cent*parting%share, 3)//' % of the net difference in '//what//' arises in the '// &
                          trim(interval_name(worst%kind))//' section, '//depth(worst%md_top)//' to '//depth(worst%md_bottom)//'.')
      end associate

   contains

      pure function depth(md) result(text)
         real(wp), intent(in) :: md
         character(:), allocatable :: text
         text = in_units(units, unit_length, md, shown + 1)
      end function depth

      pure function growth_text(growth) result(text)
         real(wp), intent(in) :: growth
         character(:), allocatable :: text
         real(wp) :: shown_growth
         shown_growth = growth
         if (abs(growth) < round_off*maxval(abs(parting%growth))) shown_growth = 0.0_wp
         if (k == quantity_side_force) then     ! an integral along the hole
            text = signed(shown_growth/units%force)//' '//trim(units%force_label)
         else
            text = signed(shown_growth/factor)//' '//unit
         end if
      end function growth_text

      !> Remark on the growth over an interval without a depth of the table.
      pure function remark(interval) result(text)
         type(interval_type), intent(in) :: interval
         character(:), allocatable :: text
         text = ''
         if (.not. any(comparison%md > interval%md_top .and. comparison%md < interval%md_bottom)) &
            text = ' (interpolated)'
      end function remark
   end subroutine append_words

   !> Intervals that are listed: all, or of many those with the largest changes.
   pure function listed_intervals(growth) result(listed)
      real(wp), intent(in) :: growth(:)
      logical :: listed(size(growth))
      integer :: i
      listed = size(growth) <= most_intervals
      if (all(listed)) return
      do i = 1, most_intervals - 1
         listed(maxloc(abs(growth), mask=.not. listed, dim=1)) = .true.
      end do
   end function listed_intervals

   !> With its sign, also where that is plus.
   pure function signed(value) result(text)
      real(wp), intent(in) :: value
      character(:), allocatable :: text
      text = to_text(value, shown)
      if (value > 0.0_wp) text = '+'//text
   end function signed

   pure function share_of(part, whole) result(share)
      real(wp), intent(in) :: part, whole
      real(wp) :: share
      share = 0.0_wp
      if (whole > 0.0_wp) share = per_cent*part/whole
   end function share_of
end module dg_legacy_report

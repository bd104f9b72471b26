!> Picture of another program's results beside ours: each quantity that it has, and the difference.
module dg_legacy_picture
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type
   use dg_chart, only: add_curve, add_depth_panel, add_key, beside, chart_type, new_chart, set_depth
   use dg_curve_look, only: colour_black, line_style
   use dg_job, only: job_type, model_name
   use dg_legacy_comparison, only: comparison_type, compare_with_legacy, legacy_table_type, quantity_count, quantity_of
   use dg_model, only: model_type
   use dg_text, only: either
   use dg_unit_kind, only: unit_factor
   implicit none
   private
   public :: legacy_chart

   !> Name of each quantity on its axis.
   character(*), parameter :: axis_name(quantity_count) = [character(21) :: 'effective axial force', 'torque', 'side force']
   character(*), parameter :: their_look = "with linespoints pt 6 ps 0.6 lw 1.0 dt (3,3) lc rgb '"//colour_black//"'"

contains

   !> Another program's table beside our results of its case.
   function legacy_chart(job, model, table, results) result(chart)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(legacy_table_type), intent(in) :: table
      type(case_result_type), intent(in) :: results(:)
      type(chart_type) :: chart
      type(comparison_type) :: comparisons(size(job%models))    !< by model, without depths where it has no result
      real(wp) :: unit
      integer :: quantity, i, k, m
      do i = 1, size(results)
         if (results(i)%case_index /= table%case_index .or. .not. allocated(results(i)%profile%md)) cycle
         call compare_with_legacy(table, results(i)%profile, model%trajectory, &
                                  comparisons(findloc(job%models, results(i)%model, dim=1)))
      end do
      chart = new_chart('legacy_'//table%label, 'Case '//model%cases(table%case_index)%name//' beside '//table%label, job%units, &
                        580, [0.84_wp, 0.92_wp])
      do m = 1, size(job%models)
         call add_key(chart, line_style(m), trim(model_name(job%models(m))))
      end do
      call add_key(chart, their_look, table%label)
      call set_depth(chart, 'measured depth', [minval(table%md), maxval(table%md)], model%holes, place(), .true.)
      do quantity = 1, quantity_count
         if (.not. table%has(quantity)) cycle
         associate (dimension => quantity_of(quantity))
            unit = unit_factor(job%units, dimension)
            do k = 0, 1
               call add_depth_panel(chart, place(), trim(axis_name(quantity))//either(', legacy - drillgap', '', k == 1), dimension)
               do m = 1, size(job%models)
                  associate (one => comparisons(m))
                     if (.not. allocated(one%md)) cycle
                     if (k == 0) then
                        call add(one%md, one%ours(:, quantity), line_style(m), m)
                     else
                        call add(one%md, one%theirs(:, quantity) - one%ours(:, quantity), line_style(m), m)
                     end if
                  end associate
               end do
               associate (one => comparisons(1))
                  if (k == 0 .and. allocated(one%md)) call add(one%md, one%theirs(:, quantity), their_look, size(chart%keys))
               end associate
            end do
         end associate
      end do

   contains

      !> Of the next panel.
      pure function place()
         real(wp) :: place(4)
         place = beside(size(chart%panels) + 1, 2*count(table%has), [0.075_wp, 0.985_wp, 0.125_wp, 0.84_wp], 0.025_wp)
      end function place

      subroutine add(md, values, look, key)
         real(wp), intent(in) :: md(:), values(:)     !< [SI]
         character(*), intent(in) :: look
         integer, intent(in) :: key                   !< entry of the legend
         call add_curve(chart, values/unit, md/job%units%length, look, '', [key])
      end subroutine add
   end function legacy_chart
end module dg_legacy_picture

!> Ranking of uncertain inputs at the deepest bit depth. Each has a bar, whose length to either side of the mean is the
!> standard deviation by this input alone.
module dg_tornado_picture
   use dg_kinds, only: wp
   use dg_chart, only: add_points, add_rows, chart_type, new_chart
   use dg_curve_look, only: colour_of
   use dg_job, only: model_name
   use dg_load_case, only: operation_label, rotates
   use dg_missing, only: is_missing
   use dg_quantity, only: quantity_force, quantity_moment
   use dg_readable, only: spaced
   use dg_sample_statistics, only: distribution_type, point_statistics_type
   use dg_sweep, only: point_number, point_type
   use dg_text, only: text_type
   use dg_uncertainty, only: uncertainty_type
   use dg_unit_kind, only: in_units, unit_length
   use dg_units, only: unit_system_type
   use dg_variance_shares, only: input_count, input_name, varies
   implicit none
   private
   public :: tornado_chart

   integer, parameter :: depth_digits = 6, head = 110, row_height = 24
   real(wp), parameter :: half_a_bar = 0.36_wp

contains

   !> One model's bars, rows of all operations below each other.
   function tornado_chart(units, uncertainty, place, statistics) result(chart)
      type(unit_system_type), intent(in) :: units
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: place          !< of the model in the range's
      type(point_statistics_type), intent(in) :: statistics(:)      !< of all points
      type(chart_type) :: chart
      real(wp), parameter :: left(2) = [0.24_wp, 0.63_wp], right(2) = [0.6_wp, 0.99_wp]
      integer, dimension(input_count*size(uncertainty%range%operations)) :: inputs, operations   !< of each row
      type(text_type) :: names(size(inputs))
      character(:), allocatable :: name
      real(wp) :: height
      integer :: rows, i, o
      rows = 0
      associate (range => uncertainty%range)
         do o = 1, size(range%operations)
            do i = 1, input_count
               if (.not. varies(uncertainty, i)) cycle
               rows = rows + 1
               inputs(rows) = i
               operations(rows) = o
               names(rows)%text = trim(operation_label(range%operations(o)))//': '//spaced(trim(input_name(i)))
            end do
         end do
         height = real(head + row_height*rows, wp)
         name = trim(model_name(range%models(place)))
         associate (top => 1.0_wp - 45.0_wp/height, bottom => 55.0_wp/height)
            chart = new_chart('tornado_'//range%name//'_'//name, 'Uncertainty '//range%name//', model '//name// &
                              ': what matters most at '//in_units(units, unit_length, range%depths(size(range%depths)), &
                                                                       depth_digits), units, nint(height), &
                              [top, 1.0_wp - 38.0_wp/height])
            call add_rows(chart, [left(1), right(1), bottom, top], 'hook load by one standard deviation', quantity_force, &
                          names(:rows), left(1))
            do i = 1, rows
               associate (point => statistics(point_number(range, point_type(place, operations(i), 1, size(range%depths)))))
                  call add_bar(point%hookload, point%hookload_shares(inputs(i)), units%force)
               end associate
            end do
            call add_rows(chart, [left(2), right(2), bottom, top], 'torque by one standard deviation', quantity_moment, &
                          names(:rows), 0.0_wp)
            do i = 1, rows
               if (.not. rotates(range%operations(operations(i)))) cycle
               associate (point => statistics(point_number(range, point_type(place, operations(i), 1, size(range%depths)))))
                  call add_bar(point%torque, point%torque_shares(inputs(i)), units%moment)
               end associate
            end do
         end associate
      end associate

   contains

      !> The bar of row `i`, to either side of the mean.
      subroutine add_bar(distribution, share, unit)
         type(distribution_type), intent(in) :: distribution
         real(wp), intent(in) :: share      !< of the variance [-]
         real(wp), intent(in) :: unit
         real(wp) :: mean, effect, row
         if (is_missing(share) .or. is_missing(distribution%deviation)) return
         mean = distribution%mean/unit
         effect = distribution%deviation*sqrt(share)/unit
         row = real(i, wp)
         call add_points(chart, reshape([mean, row, mean - effect, mean + effect, row - half_a_bar, row + half_a_bar], [6, 1]), &
                         "with boxxyerror fs solid 0.75 noborder lc rgb '"//colour_of(inputs(i))//"'", &
                         name='mean, one standard deviation')
      end subroutine add_bar
   end function tornado_chart
end module dg_tornado_picture

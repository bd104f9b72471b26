!> What matters most at the deepest bit depth: a bar for each uncertain input, as long as the standard deviation that it makes by
!> itself to either side of the mean, from uncertainty_<name>.csv.
module dg_tornado_picture
   use dg_kinds, only: wp
   use dg_column, only: column_header, column_named
   use dg_gnuplot_script, only: add_series, colour_of, end_script, legend, panel, plot, results_file, row_tics, series_type, &
                                start_script
   use dg_html_text, only: spaced
   use dg_job, only: model_name
   use dg_load_case, only: operation_label, rotates
   use dg_sweep, only: point_number, point_type
   use dg_text, only: append_text, text_type, to_text
   use dg_uncertainty, only: uncertainty_type
   use dg_uncertainty_file, only: share_column, uncertainty_columns
   use dg_unit_kind, only: in_units, unit_label, unit_length, unit_moment
   use dg_units, only: unit_system_type
   use dg_variance_shares, only: input_count, input_name, varies
   implicit none
   private
   public :: tornado_script

   integer, parameter :: digits = 8, depth_digits = 6, width = 1120, head = 110, row_height = 24
   real(wp), parameter :: half_a_bar = 0.36_wp

contains

   !> One model's bars, rows of all operations below each other.
   subroutine tornado_script(name, units, uncertainty, place, lines)
      character(*), intent(in) :: name      !< of the picture
      type(unit_system_type), intent(in) :: units
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: place          !< of the model in the range's
      type(text_type), allocatable, intent(out) :: lines(:)
      real(wp), parameter :: left(2) = [0.24_wp, 0.63_wp], right(2) = [0.6_wp, 0.99_wp]
      type(series_type), allocatable :: none(:)
      type(text_type) :: names(input_count*size(uncertainty%range%operations))
      integer :: rows, i, o, height
      rows = 0
      do o = 1, size(uncertainty%range%operations)
         do i = 1, input_count
            if (.not. varies(uncertainty, i)) cycle
            rows = rows + 1
            names(rows)%text = trim(operation_label(uncertainty%range%operations(o)))//': '//spaced(trim(input_name(i)))
         end do
      end do
      height = head + row_height*rows
      call start_script(lines, name, width, height)
      call append_text(lines, 'set style fill solid 0.75 noborder')
      associate (range => uncertainty%range, top => 1.0_wp - 45.0_wp/real(height, wp), bottom => 55.0_wp/real(height, wp))
         call add_series(none, 'NaN', 'with lines', '')
         call legend(lines, 'Uncertainty '//range%name//', model '//trim(model_name(range%models(place)))// &
                     ': what matters most at '// &
                     trim(in_units(units, unit_length, range%depths(size(range%depths)), depth_digits)), none, top, &
                     1.0_wp - 25.0_wp/real(height, wp))
         call panel(lines, left(1), right(1), bottom, top, 'hook load by one standard deviation ['// &
                    trim(units%force_label)//']', ' ')
         call draw('hookload', .false., row_tics(names(:rows), left(1), width))
         call panel(lines, left(2), right(2), bottom, top, 'torque by one standard deviation ['// &
                    unit_label(units, unit_moment)//']', ' ')
         call draw('torque', .true., '')
      end associate
      call end_script(lines)

   contains

      !> The bars of one result, the first row on top.
      subroutine draw(result, turning, tics)
         character(*), intent(in) :: result, tics
         logical, intent(in) :: turning      !< operations that turn alone
         type(series_type), allocatable :: bars(:)
         integer :: row
         row = 0
         do o = 1, size(uncertainty%range%operations)
            do i = 1, input_count
               if (.not. varies(uncertainty, i)) cycle
               row = row + 1
               if (turning .and. .not. rotates(uncertainty%range%operations(o))) cycle
               call add_series(bars, bar(result, row), "with boxxyerror lc rgb '"//colour_of(i)//"'", '')
            end do
         end do
         if (.not. allocated(bars)) call add_series(bars, 'NaN', 'with lines', '')
         call append_text(lines, 'set yrange ['//to_text(real(rows, wp) + 0.6_wp, digits)//':0.4]; set ytics ('//tics// &
                          '); unset ylabel')
         call plot(lines, bars, may_lack=.true.)
      end subroutine draw

      !> From its row of the file: mean, row, ends of the bar.
      function bar(result, row) result(using)
         character(*), intent(in) :: result
         integer, intent(in) :: row
         character(:), allocatable :: using
         character(:), allocatable :: at, mean, effect
         integer :: point
         point = point_number(uncertainty%range, point_type(place, o, 1, size(uncertainty%range%depths))) - 1
         at = to_text(row)
         mean = "column('"//heading(result//'_mean')//"')"
         effect = "column('"//heading(result//'_deviation')//"')*sqrt(column('"//heading(share_column(result, i))//"')/100)"
         using = results_file('uncertainty_'//uncertainty%range%name)//' every ::'//to_text(point)//'::'//to_text(point)// &
                 ' using ('//mean//'):('//at//'):('//mean//'-'//effect//'):('//mean//'+'//effect//'):('//at//'-'// &
                 to_text(half_a_bar, digits)//'):('//at//'+'//to_text(half_a_bar, digits)//')'
      end function bar

      !> Heading of a column of the file.
      pure function heading(column) result(text)
         character(*), intent(in) :: column
         character(:), allocatable :: text
         text = column_header(column_named(uncertainty_columns, trim(column)), units)
      end function heading
   end subroutine tornado_script
end module dg_tornado_picture

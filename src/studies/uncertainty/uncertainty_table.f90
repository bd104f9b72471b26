!> A Monte Carlo in print: P10, P50, P90 of hook load and torque against bit depth, with what was measured beside. Every line
!> fits 120 columns.
module dg_uncertainty_table
   use dg_job, only: model_name
   use dg_kinds, only: wp
   use dg_load_case, only: operation_label, rotates
   use dg_missing, only: is_missing
   use dg_readable, only: spaced
   use dg_sample_statistics, only: distribution_type, p10, p50, p90, point_statistics_type
   use dg_sweep, only: measured_at, measured_type, point_number, point_type, shown_depths
   use dg_text, only: append_text, either, text_type, to_text
   use dg_text_table, only: add_cell, append_table, end_row, text_table_type
   use dg_uncertainty, only: uncertainty_type
   use dg_unit_kind, only: in_units, unit_label, unit_length, unit_moment
   use dg_units, only: unit_system_type
   use dg_variance_shares, only: input_name, varies
   implicit none
   private
   public :: uncertainty_table, deviations_text

   integer, parameter :: depth_width = 10, cell_width = 10
   integer, parameter :: digits = 4, depth_digits = 7, share_digits = 2
   !> Sampling error of P10 and P90 over their distance from P50, times the root of the number of samples [-]. In 95 % of runs it
   !> is less, for a normal distribution: 1.96 sqrt(0.1*0.9)/(z phi(z)) with z = 1.2816.
   real(wp), parameter :: sampling = 2.614_wp

contains

   !> Lines of the table of a Monte Carlo: quantiles by depth, for each model and operation.
   pure function uncertainty_table(units, uncertainty, statistics, indicated) result(lines)
      type(unit_system_type), intent(in) :: units
      type(uncertainty_type), intent(in) :: uncertainty
      type(point_statistics_type), intent(in) :: statistics(:)   !< in the order of the points' numbers
      logical, intent(in) :: indicated                           !< hook loads as the rig shows them
      type(text_type), allocatable :: lines(:)
      integer :: m, o
      allocate (lines(0))
      call append_text(lines, '')
      call append_text(lines, 'Uncertainty '//uncertainty%range%name//': '//to_text(uncertainty%samples)//' samples, seed '// &
                       to_text(uncertainty%seed)//'; standard deviations:')
      call append_text(lines, '  '//deviations_text(units, uncertainty))
      call append_text(lines, '  P10 and P90 are uncertain by '// &
                       to_text(100.0_wp*sampling/sqrt(real(uncertainty%samples, wp)), share_digits)// &
                       ' % of their distance from P50, as samples are random. More samples make this less')
      do m = 1, size(uncertainty%range%models)
         do o = 1, size(uncertainty%range%operations)
            call append_curve(lines, units, uncertainty, statistics, point_type(m, o, 1, 1), indicated)
         end do
      end do
   end function uncertainty_table

   !> Uncertain inputs and their deviations.
   pure function deviations_text(units, uncertainty) result(text)
      type(unit_system_type), intent(in) :: units
      type(uncertainty_type), intent(in) :: uncertainty
      character(:), allocatable :: text
      text = ''
      call add_friction()
      call add('mud density', uncertainty%density_deviation/units%density)
      call add('inclination', uncertainty%inclination_deviation/units%angle)
      call add('azimuth', uncertainty%azimuth_deviation/units%angle)
      call add('hook load gauge', uncertainty%hookload_deviation/units%force)
      call add('torque gauge', uncertainty%torque_deviation/units%moment)
      text = text(len(', ') + 1:)
   contains
      !> One deviation, or one a hole section; how much varies together.
      pure subroutine add_friction()
         integer :: i
         if (uncertainty%estimate > 0 .and. .not. allocated(uncertainty%friction_deviations)) text = text// &
            ', friction as calibrated'
         if (.not. allocated(uncertainty%friction_deviations)) return
         associate (each => uncertainty%friction_deviations)
            if (.not. any(each > 0.0_wp)) return
            text = text//', friction '//to_text(each(1), digits)
            do i = 2, size(each)
               if (any(abs(each - each(1)) > 0.0_wp)) text = text//' and '//to_text(each(i), digits)
            end do
            if (uncertainty%estimate > 0) then
               text = text//' as calibrated'
            else if (size(each) > 1 .and. is_missing(uncertainty%friction_correlation)) then
               text = text//' (correlations as given)'
            else if (size(each) > 1) then
               text = text//' (correlation '//to_text(uncertainty%friction_correlation, digits)//')'
            end if
         end associate
      end subroutine add_friction

      pure subroutine add(name, value)
         character(*), intent(in) :: name
         real(wp), intent(in) :: value
         if (value > 0.0_wp) text = text//', '//name//' '//to_text(value, digits)
      end subroutine add
   end function deviations_text

   !> One operation by one model.
   pure subroutine append_curve(lines, units, uncertainty, statistics, curve, indicated)
      type(text_type), allocatable, intent(inout) :: lines(:)
      type(unit_system_type), intent(in) :: units
      type(uncertainty_type), intent(in) :: uncertainty
      type(point_statistics_type), intent(in) :: statistics(:)
      type(point_type), intent(in) :: curve
      logical, intent(in) :: indicated
      type(text_table_type) :: table
      type(point_type) :: point
      type(measured_type) :: measured
      integer, allocatable :: depths(:)
      integer :: i, n, first, last
      call append_text(lines, '')
      call append_text(lines, trim(operation_label(uncertainty%range%operations(curve%operation)))//', model '// &
                       trim(model_name(uncertainty%range%models(curve%model)))//': '// &
                       either('weight indicator', 'hook load', indicated)//', '// &
                       trim(units%force_label)// &
                       ', and torque, '//unit_label(units, unit_moment)//', under which 10, 50 and 90 % of the samples lie')
      allocate (depths, source=shown_depths(uncertainty%range))
      point = curve
      do i = 1, size(depths)
         point%depth = depths(i)
         measured = measured_at(uncertainty%range, point)
         associate (found => statistics(point_number(uncertainty%range, point)))
            call add_cell(table, 'Bit depth', depth_width, uncertainty%range%depths(point%depth), units%length, 1)
            call add_quantiles(table, merge(found%weight_indicator, found%hookload, indicated), units%force, 1)
            call add_cell(table, 'Measured', cell_width, measured%hookload, units%force, 1)
            call add_quantiles(table, found%torque, units%moment, 2)
            call add_cell(table, 'Samples', cell_width, found%solved)
            call end_row(table, merge('!', ' ', found%not_converged > 0))
         end associate
      end do
      call append_table(lines, table)
      n = size(uncertainty%range%depths)
      if (size(depths) < n) call append_text(lines, to_text(size(depths))//' of '//to_text(n)//' depths; the CSV file has all')
      point%depth = 1
      first = point_number(uncertainty%range, point)
      point%depth = n
      last = point_number(uncertainty%range, point)
      associate (curve_points => statistics(first:last))
         if (any(curve_points%not_converged > 0)) call append_text(lines, &
            '! samples without solution are left out: '//most(curve_points%not_converged)//'; the numbers are those of the others')
         if (any(curve_points%locked_up > 0)) call append_text(lines, &
            'Locked up: '//most(curve_points%locked_up)//'; they count as hook loads below all others; - : among them')
      end associate
      associate (deepest => statistics(last))
         if (.not. any(is_missing(deepest%hookload_shares))) call append_text(lines, shares_text('hook load', uncertainty, &
                                                                                                 deepest%hookload_shares))
         if (rotates(uncertainty%range%operations(curve%operation)) .and. .not. any(is_missing(deepest%torque_shares))) &
            call append_text(lines, shares_text('torque', uncertainty, deepest%torque_shares))
      end associate
   contains
      !> Number of samples at the depth that has most of them.
      pure function most(counts) result(text)
         integer, intent(in) :: counts(:)
         character(:), allocatable :: text
         text = to_text(maxval(counts))//' of '//to_text(uncertainty%samples)//' with the bit at '// &
                in_units(units, unit_length, uncertainty%range%depths(maxloc(counts, dim=1)), depth_digits)
      end function most
   end subroutine append_curve

   !> Ranking of inputs at the deepest bit depth, the largest share first.
   pure function shares_text(what, uncertainty, shares) result(text)
      character(*), intent(in) :: what
      type(uncertainty_type), intent(in) :: uncertainty
      real(wp), intent(in) :: shares(:)      !< of the variance, by input [-]
      character(:), allocatable :: text
      real(wp) :: left(size(shares))
      integer :: i, largest
      text = ''
      left = shares
      do i = 1, size(shares)
         largest = maxloc(left, dim=1)
         left(largest) = -1.0_wp
         if (varies(uncertainty, largest)) text = text//', '// &
            either('nonlinear effects', spaced(trim(input_name(largest))), input_name(largest) == 'rest')//' '// &
            to_text(100.0_wp*shares(largest), share_digits)//' %'
      end do
      text = 'Share of the variance of '//what//' at the deepest bit depth: '//text(len(', ') + 1:)
   end function shares_text

   pure subroutine add_quantiles(table, distribution, unit, decimals)
      type(text_table_type), intent(inout) :: table
      type(distribution_type), intent(in) :: distribution
      real(wp), intent(in) :: unit
      integer, intent(in) :: decimals
      call add_cell(table, 'P10', cell_width, distribution%quantiles(p10), unit, decimals)
      call add_cell(table, 'P50', cell_width, distribution%quantiles(p50), unit, decimals)
      call add_cell(table, 'P90', cell_width, distribution%quantiles(p90), unit, decimals)
   end subroutine add_quantiles
end module dg_uncertainty_table

module dg_test_report_cells
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use dg_comparison, only: percent_error
   use dg_markup, only: html_safe
   use, intrinsic :: iso_fortran_env, only: int64
   use dg_kinds, only: wp
   use dg_load_case, only: moves_axially, operation_backream, operation_rotary_drilling, operation_sliding_drilling, &
      operation_static, operation_trip_out, rotates
   use dg_missing, only: given, is_shown, missing, optional_real
   use dg_number_text, only: append_wrapped, count_cell, csv_text, fixed_cell, left_aligned, append_csv_number, right_aligned, &
                             scientific_cell
   use dg_ten_digits, only: longest_number
   use dg_text, only: text_type
   use dg_text_table, only: add_cell, add_instead, append_table, close_rows, end_row, text_table_type
   implicit none
   private
   public :: report_cells_suite

   type(optional_real), parameter :: nothing = optional_real()
   character(*), parameter :: line_break = achar(10)

contains

   function report_cells_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('report_cells')
      call suite%addTest(TestMethod('fixed', test_fixed))
      call suite%addTest(TestMethod('other_cells', test_other_cells))
      call suite%addTest(TestMethod('table', test_table))
      call suite%addTest(TestMethod('csv_numbers', test_csv_numbers))
      call suite%addTest(TestMethod('no_numbers', test_no_numbers))
      call suite%addTest(TestMethod('csv_text', test_csv_text))
      call suite%addTest(TestMethod('long_texts', test_long_texts))
      call suite%addTest(TestMethod('wrapped', test_wrapped))
      call suite%addTest(TestMethod('percent_error', test_percent_error))
      call suite%addTest(TestMethod('which_column_applies', test_which_column_applies))
   end function report_cells_suite

   !> Brackets make leading blanks count.
   subroutine test_fixed()
      call assertEqual('[   733.4]', '['//fixed_cell(733.4_wp, 8, 1)//']')
      call assertEqual('[  -17.29]', '['//fixed_cell(-17.294_wp, 8, 2)//']')
      call assertEqual('[    0.50]', '['//fixed_cell(0.5_wp, 8, 2)//']', message='zero before the point')
      call assertEqual('[    0.00]', '['//fixed_cell(-0.001_wp, 8, 2)//']', message='no negative zero')
      call assertEqual('[ 1.2E+09]', '['//fixed_cell(1.2e9_wp, 8, 1)//']', message='too long for its cell')
      call assertEqual('[       -]', '['//fixed_cell(nothing, 1.0_wp, 8, 2)//']', message='absent')
      call assertEqual('[   745.0]', '['//fixed_cell(given(745.0e3_wp), 1.0e3_wp, 8, 1)//']')
   end subroutine test_fixed

   subroutine test_other_cells()
      call assertEqual('[  1.5E-12]', '['//scientific_cell(1.5e-12_wp, 9)//']')
      call assertEqual('[  0.0E+00]', '['//scientific_cell(0.0_wp, 9)//']')
      call assertEqual('[   12]', '['//count_cell(12, 5)//']')
      call assertEqual('[    -]', '['//count_cell(12, 5, .false.)//']')
      call assertEqual('[ab   ]', '['//left_aligned('ab', 5)//']')
      call assertEqual('[abcd... ]', '['//left_aligned('abcdefghij', 8)//']')
      call assertEqual('[   ab]', '['//right_aligned('ab', 5)//']')
   end subroutine test_other_cells

   !> A row of words, a mark, and a sum below the closing rule; the second table begins at the rule that ends the first.
   subroutine test_table()
      type(text_table_type) :: table
      type(text_type), allocatable :: lines(:)
      character(*), parameter :: rule = '----------------------'
      character(*), parameter :: expected(*) = [character(len(rule) + 3) :: rule, 'Case     Load  Remark', '           kN', rule, &
         'one   no value', 'two       2.0  high !', rule, 'all         -  none']
      integer :: i
      call add_row('one', missing, 'low', .true.)
      call add_row('two', 2000.0_wp, 'high', .false.)
      allocate (lines(0))
      call append_table(lines, table)
      call append_table(lines, table)
      call assertEqual(13, size(lines))
      call close_rows(table)
      call add_row('all', missing, 'none', .false.)
      deallocate (lines)
      allocate (lines(0))
      call append_table(lines, table)
      call assertEqual(size(expected), size(lines))
      do i = 1, min(size(expected), size(lines))
         call assertEqual(trim(expected(i)), lines(i)%text)
      end do
   contains
      subroutine add_row(name, load, remark, without)
         character(*), intent(in) :: name
         real(wp), intent(in) :: load         !< [N]
         character(*), intent(in) :: remark
         logical, intent(in) :: without       !< words in place of numbers
         call add_cell(table, 'Case', 6, name)
         if (without) call add_instead(table, 'no value')
         call add_cell(table, 'Load|kN', 7, load, 1000.0_wp, 1)
         call add_cell(table, 'Remark', 7, remark)
         call end_row(table, trim(merge(' !', '  ', name == 'two')))
      end subroutine add_row
   end subroutine test_table

   !> Read numbers back: they differ by less than the 1e-9 promised.
   subroutine test_csv_numbers()
      real(wp), parameter :: values(6) = [733.123456789012_wp, -1.0e-7_wp/3.0_wp, 3190.0_wp, 2.0e5_wp/3.0_wp, 1.0e30_wp, 0.1_wp]
      real(wp), parameter :: promised = 1.0e-9_wp
      character(40) :: field
      real(wp) :: found
      integer :: i
      do i = 1, size(values)
         field = csv_number(values(i))
         read (field, *) found
         call assertEqual(values(i), found, promised*abs(values(i)), message=csv_number(values(i)))
      end do
      call assertEqual('0.000000000', csv_number(-0.0_wp))
   end subroutine test_csv_numbers

   !> Write missing, infinite and NaN values as an empty field, and in a cell as a dash.
   subroutine test_no_numbers()
      real(wp) :: none(5)
      integer :: i
      none = [missing, transfer(int(z'7FF0000000000000', int64), 1.0_wp), transfer(int(z'FFF0000000000000', int64), 1.0_wp), &
              transfer(int(z'7FF8000000000000', int64), 1.0_wp), transfer(int(z'FFF8000000000001', int64), 1.0_wp)]
      do i = 1, size(none)
         call assertEqual('', csv_number(none(i)))
         call assertEqual('[     -]', '['//fixed_cell(none(i), 6, 1)//']')
         call assertEqual('[     -]', '['//scientific_cell(none(i), 6)//']')
         call assertFalse(is_shown(none(i)))
      end do
      call assertTrue(all(is_shown([0.0_wp, -1.0_wp, 1.0e308_wp, -1.0e308_wp, 5.0e-324_wp])))
      call assertEqual('1.000000000', csv_number(1.0_wp))
   end subroutine test_no_numbers

   !> A number as a field of its own.
   function csv_number(value) result(field)
      real(wp), intent(in) :: value
      character(:), allocatable :: field
      character(longest_number) :: buffer
      integer :: filled
      filled = 0
      call append_csv_number(buffer, filled, value)
      field = buffer(:filled)
   end function csv_number

   !> RFC 4180; what commands a terminal does not stay.
   subroutine test_csv_text()
      call assertEqual('plain text', csv_text('plain text'))
      call assertEqual('"a,b"', csv_text('a,b'))
      call assertEqual('"5"" pipe"', csv_text('5" pipe'))
      call assertEqual('"a'//line_break//'b"', csv_text('a'//line_break//'b'))
      call assertEqual('', csv_text(''))
      call assertEqual('"a?[31m,?'//char(195)//char(169)//'"', &
                       csv_text('a'//achar(27)//'[31m,'//achar(127)//char(195)//char(169)))
   end subroutine test_csv_text

   !> A text of a megabyte in a cell and on the page: milliseconds. A procedure that takes the square of the length takes a minute,
   !> so that the bound of a hundred times what is needed tells the two apart on any machine.
   subroutine test_long_texts()
      real(wp), parameter :: bound = 5.0_wp     ! [s]
      integer, parameter :: half = 500000
      character(:), allocatable :: text
      real(wp) :: start, finish
      call cpu_time(start)
      text = html_safe(repeat('<x', half))
      call assertEqual(5*half, len(text))
      call assertEqual('&lt;x&lt;x', text(5*half - 9:))
      text = csv_text(repeat('"x', half))
      call assertEqual(3*half + 2, len(text))
      call assertEqual('""x""x"', text(3*half - 4:))
      call cpu_time(finish)
      call assertTrue(finish - start < bound)
   end subroutine test_long_texts

   !> Lines break at blanks, but not between a number and its unit.
   subroutine test_wrapped()
      type(text_type), allocatable :: lines(:)
      allocate (lines(0))
      call append_wrapped(lines, 'a load of 701.3 kN, 40.1 % used, and a word that is longer', 16)
      call assertEqual(5, size(lines))
      if (size(lines) /= 5) return
      call assertEqual('a load of|  701.3 kN,|  40.1 % used,|  and a word|  that is longer', lines(1)%text//'|'//lines(2)%text// &
                       '|'//lines(3)%text//'|'//lines(4)%text//'|'//lines(5)%text)
      deallocate (lines)
      allocate (lines(0))
      call append_wrapped(lines, '0123456789012345678', 16)
      call assertEqual('0123456789012345', lines(1)%text, message='no blank')
   end subroutine test_wrapped

   !> First row of the paper's Table 1: 733.4 against 745.0 kN is 1.56 %.
   subroutine test_percent_error()
      type(optional_real) :: error
      error = percent_error(733.4e3_wp, given(745.0e3_wp))
      call assertTrue(error%present)
      call assertEqual(1.56_wp, error%value, 0.005_wp)
      error = percent_error(1.0_wp, nothing)
      call assertFalse(error%present)
      error = percent_error(1.0_wp, given(0.0_wp))
      call assertFalse(error%present, message='no error of nothing')
      error = percent_error(7.0e5_wp, given(1.0e-303_wp))
      call assertFalse(error%present, message='beyond all numbers')
   end subroutine test_percent_error

   subroutine test_which_column_applies()
      call assertTrue(moves_axially([operation_trip_out, operation_sliding_drilling, operation_backream]))
      call assertFalse(moves_axially([operation_rotary_drilling, operation_static]))
      call assertTrue(rotates([operation_rotary_drilling, operation_backream]))
      call assertFalse(rotates([operation_trip_out, operation_sliding_drilling, operation_static]))
   end subroutine test_which_column_applies
end module dg_test_report_cells

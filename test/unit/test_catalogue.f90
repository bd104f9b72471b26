!> The catalogue of pipe: its numbers against published ones, and the ways in which a name finds an entry.
module dg_test_catalogue
   use funit, only: anyExceptions, assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_catalogue, only: catalogue_type, catalogue_within, find_entry, number_of, numeric_keys, read_catalogue
   use dg_component, only: tube_area
   use dg_constants, only: degree
   use dg_error, only: error_list_type, error_text, error_type
   use dg_file_system, only: delete_file, write_text_file
   use dg_kinds, only: wp
   use dg_text, only: append_text, text_type
   implicit none
   private
   public :: catalogue_suite

   character(*), parameter :: scratch = 'build/test_catalogue.csv'
   real(wp), parameter :: pound_force = 4.4482216152605_wp, pound_per_foot = 0.45359237_wp/0.3048_wp
   real(wp), parameter :: steel = 7850.0_wp, aluminium = 2780.0_wp

contains

   function catalogue_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('catalogue')
      call suite%addTest(TestMethod('published_strengths', test_strengths))
      call suite%addTest(TestMethod('masses', test_masses))
      call suite%addTest(TestMethod('names', test_names))
      call suite%addTest(TestMethod('within_the_program', test_within))
      call suite%addTest(TestMethod('aluminium_floats_as_it_should', test_aluminium))
      call suite%addTest(TestMethod('units', test_units, tearDown=remove_scratch))
      call suite%addTest(TestMethod('faults', test_faults, tearDown=remove_scratch))
      call suite%addTest(TestMethod('names_twice', test_twice, tearDown=remove_scratch))
   end function catalogue_suite

   subroutine remove_scratch()
      call delete_file(scratch)
   end subroutine remove_scratch

   !> Tensile strength of new pipe of grade E, as API RP 7G prints it [lbf]: yield strength times the area of the body.
   subroutine test_strengths()
      type(catalogue_type) :: catalogue
      call read_input(catalogue)
      if (anyExceptions()) return
      call strength('DP 2-3/8 6.65 NC26 E75', 138220.0_wp)
      call strength('DP 2-7/8 10.40 NC31 E75', 214340.0_wp)
      call strength('DP 3-1/2 13.30 NC38 E75', 271570.0_wp)
      call strength('DP 3-1/2 15.50 NC38 E75', 322780.0_wp)
      call strength('DP 4 14.00 NC40 E75', 285360.0_wp)
      call strength('DP 4 15.70 NC40 E75', 324120.0_wp)
      call strength('DP 4-1/2 16.60 NC46 E75', 330560.0_wp)
      call strength('DP 4-1/2 20.00 NC50 E75', 412360.0_wp)
      call strength('DP 5 19.50 NC50 E75', 395600.0_wp)
      call strength('DP 5 25.60 5-1/2 FH E75', 530150.0_wp)
      call strength('DP 5-1/2 21.90 FH E75', 437120.0_wp)
      call strength('DP 5-1/2 24.70 FH E75', 497220.0_wp)
      call strength('DP 6-5/8 25.20 FH E75', 489470.0_wp)
      call strength('DP 5 19.50 NC50 S135', 712070.0_wp)
   contains
      subroutine strength(name, published)
         character(*), intent(in) :: name
         real(wp), intent(in) :: published
         ! API rounds to 10 lbf, and diameters to the thousandth of an inch
         real(wp), parameter :: rounding = 2.0e-4_wp
         call assertRelativelyEqual(published*pound_force, number(catalogue, name, 'yield')* &
            tube_area(number(catalogue, name, 'od'), number(catalogue, name, 'id')), rounding, message=name)
      end subroutine strength
   end subroutine test_strengths

   !> Compare the weight in a name with that of the body. It is more by threads, couplings and upsets, up to 6 % for casing and
   !> tubing. With tool joints pipe is 10 to 30 % heavier than its body (those of the smallest bores most), of aluminium 18 to 24 %,
   !> rods with couplings 9 %.
   subroutine test_masses()
      type(catalogue_type) :: catalogue
      real(wp) :: ratio, high, low, body
      integer :: i, checked, od, id, mass
      call read_input(catalogue)
      if (anyExceptions()) return
      od = place('od')
      id = place('id')
      mass = place('mass')
      checked = 0
      do i = 1, size(catalogue%entries)
         associate (entry => catalogue%entries(i))
            if (.not. entry%has(mass)) cycle
            select case (entry%kind)
            case ('casing', 'tubing'); low = 0.99_wp; high = 1.06_wp
            case ('drillpipe', 'hwdp'); low = 1.10_wp; high = 1.30_wp
            case ('aluminium_pipe'); low = 1.18_wp; high = 1.24_wp
            case ('sucker_rod'); low = 1.08_wp; high = 1.09_wp
            case default; low = 0.0_wp; high = 0.0_wp
            end select
            body = steel*tube_area(entry%numbers(od), entry%numbers(id))
            if (entry%kind == 'aluminium_pipe') body = aluminium/steel*body
            ratio = entry%numbers(mass)/body
            call assertTrue(ratio > low .and. ratio < high, message=entry%name)
            checked = checked + 1
         end associate
      end do
      call assertTrue(checked > 50)
      call assertRelativelyEqual(20.85_wp*pound_per_foot, number(catalogue, 'DP 5 19.50 NC50', 'mass'), 2.0e-3_wp, &
                                 message='API RP 7G')
   end subroutine test_masses

   !> The catalogue that the program carries is the one of input/.
   subroutine test_within()
      type(catalogue_type) :: catalogue, within
      type(error_list_type) :: faults
      integer :: i
      call read_input(catalogue)
      if (anyExceptions()) return
      call read_catalogue(catalogue_within, within, faults)
      call assertEqual(0, faults%count)
      call assertEqual(size(catalogue%entries), size(within%entries))
      if (anyExceptions()) return
      do i = 1, size(within%entries)
         call assertEqual(catalogue%entries(i)%name, within%entries(i)%name)
         call assertEqual(catalogue%entries(i)%kind//catalogue%entries(i)%connection, &
                          within%entries(i)%kind//within%entries(i)%connection)
         call assertTrue(all(catalogue%entries(i)%has .eqv. within%entries(i)%has), message=within%entries(i)%name)
         call assertEqual(0.0_wp, maxval(abs(catalogue%entries(i)%numbers - within%entries(i)%numbers)))
      end do
   end subroutine test_within

   !> Steel joints among aluminium: by its density a metre displaces as much as body and joints of 0.45 m in 12 m together.
   subroutine test_aluminium()
      type(catalogue_type) :: catalogue
      real(wp) :: displaced
      call read_input(catalogue)
      if (anyExceptions()) return
      displaced = (11.55_wp*tube_area(0.147_wp, 0.125_wp) + 0.45_wp*tube_area(0.172_wp, 0.125_wp))/12.0_wp
      call assertRelativelyEqual(displaced, number(catalogue, 'ADP 147x11', 'mass')/number(catalogue, 'ADP 147x11', 'density'), &
                                 1.0e-3_wp)
      call assertRelativelyEqual(325.0e6_wp, number(catalogue, 'ADP 147x11 D16T', 'yield'), 1.0e-4_wp)
   end subroutine test_aluminium

   subroutine test_names()
      type(catalogue_type) :: catalogue
      integer :: entry, grade
      call read_input(catalogue)
      if (anyExceptions()) return
      call find_entry(catalogue, ' dp  5 19.50 nc50', entry, grade)
      call assertTrue(entry > 0, message='letter case and blanks')
      call assertEqual(0, grade)
      call find_entry(catalogue, 'CSG 9-5/8 47.00 L80', entry, grade)
      call assertTrue(entry > 0 .and. grade > 0)
      call find_entry(catalogue, 'CSG 9-5/8 47.00 L81', entry, grade)
      call assertEqual(0, entry, message='no such grade')
      call find_entry(catalogue, 'L80', entry, grade)
      call assertEqual(0, entry, message='a grade is no pipe')
      call find_entry(catalogue, '', entry, grade)
      call assertEqual(0, entry)
   end subroutine test_names

   !> Columns in any order and either system; empty fields give nothing.
   subroutine test_units()
      type(catalogue_type) :: catalogue
      type(error_list_type) :: faults
      logical :: has
      real(wp) :: found
      integer :: entry, grade
      call write_lines([character(120) :: 'yield_MPa,name,OD_mm,id_in,mass_kg_m,tension_efficiency,joint_dogleg_deg_100ft,'// &
                        'yield_loss_pct_degF', '500,mine,127,,30,0.7,15,0.03'])
      call read_catalogue(scratch, catalogue, faults)
      call assertEqual(0, faults%count)
      if (anyExceptions()) return
      call find_entry(catalogue, 'mine', entry, grade)
      call assertEqual(1, entry)
      call assertRelativelyEqual(0.127_wp, number(catalogue, 'mine', 'od'), 1.0e-14_wp)
      call assertRelativelyEqual(500.0e6_wp, number(catalogue, 'mine', 'yield'), 1.0e-14_wp)
      call assertRelativelyEqual(0.7_wp, number(catalogue, 'mine', 'tension_efficiency'), 1.0e-14_wp)
      call assertRelativelyEqual(15.0_wp*degree/30.48_wp, number(catalogue, 'mine', 'joint_dogleg'), 1.0e-14_wp)
      call assertRelativelyEqual(0.054e-2_wp, number(catalogue, 'mine', 'yield_loss'), 1.0e-14_wp)
      call number_of(catalogue, entry, grade, place('id'), has, found)
      call assertFalse(has)
   end subroutine test_units

   subroutine test_faults()
      type(catalogue_type) :: catalogue
      type(error_list_type) :: faults
      call write_lines([character(60) :: 'name,od_in,colour', 'a,wide,red', ',5,red', 'b,5,red,more', 'c,1e9,red'])
      call read_catalogue(scratch, catalogue, faults)
      call assertEqual(5, faults%count)
      if (anyExceptions()) return
      call assertTrue(index(faults%items(1)%message, "unknown column 'colour'") > 0, message=faults%items(1)%message)
      call assertTrue(index(faults%items(2)%message, "od = 'wide' is not a number that a deck may give") > 0, &
                      message=faults%items(2)%message)
      call assertTrue(index(faults%items(3)%message, 'catalogue: the row has no name') > 0, message=faults%items(3)%message)
      call assertTrue(index(faults%items(4)%message, 'has 4 columns, the header 3') > 0, message=faults%items(4)%message)
      call assertTrue(index(faults%items(5)%message, "od = '1e9'") > 0, message=faults%items(5)%message)
      call assertTrue(index(error_text(faults%items(3)), ':3: ') > 0, message=error_text(faults%items(3)))
   end subroutine test_faults

   !> Which of two rows of one name is meant nobody can tell; a grade may be called as a pipe is.
   subroutine test_twice()
      type(catalogue_type) :: catalogue
      type(error_list_type) :: faults
      call write_lines([character(60) :: 'name,kind,od_in', 'DP 5,drillpipe,5', 'L80,grade,', 'l80,casing,7', &
                                         ' dp  5 ,drillpipe,5.1', &
                                         'DP 6,drillpipe,6', 'L80,Grade,', 'l80,grade,'])
      call read_catalogue(scratch, catalogue, faults)
      call assertEqual(3, faults%count)
      if (anyExceptions()) return
      call assertTrue(index(faults%items(1)%message, "'dp  5' stands in line 2 already") > 0, message=faults%items(1)%message)
      call assertTrue(index(error_text(faults%items(1)), ':5: ') > 0, message=error_text(faults%items(1)))
      call assertTrue(index(faults%items(2)%message, "'L80' stands in line 4 already") > 0, message=faults%items(2)%message)
      call assertTrue(index(faults%items(3)%message, "'l80' stands in line 3 already") > 0, message=faults%items(3)%message)
   end subroutine test_twice

   !> The catalogue of input/; a failure where it cannot be read.
   subroutine read_input(catalogue)
      type(catalogue_type), intent(out) :: catalogue
      type(error_list_type) :: faults
      character(:), allocatable :: first
      call read_catalogue('input/catalogue.csv', catalogue, faults)
      first = ''
      if (faults%count > 0) first = error_text(faults%items(1))
      call assertEqual('', first, message='no fault')
      call assertTrue(allocated(catalogue%entries), message='entries')
   end subroutine read_input

   function number(catalogue, name, key) result(value)
      type(catalogue_type), intent(in) :: catalogue
      character(*), intent(in) :: name, key
      real(wp) :: value
      integer :: entry, grade
      logical :: has
      call find_entry(catalogue, name, entry, grade)
      value = 0.0_wp
      if (entry > 0) call number_of(catalogue, entry, grade, place(key), has, value)
   end function number

   pure integer function place(key)
      character(*), intent(in) :: key
      do place = 1, size(numeric_keys)
         if (numeric_keys(place) == key) return
      end do
      place = 1
   end function place

   subroutine write_lines(texts)
      character(*), intent(in) :: texts(:)
      type(text_type), allocatable :: lines(:)
      type(error_type), allocatable :: error
      integer :: i
      allocate (lines(0))
      do i = 1, size(texts)
         call append_text(lines, trim(texts(i)))
      end do
      call write_text_file(scratch, lines, error)
      call assertFalse(allocated(error))
   end subroutine write_lines
end module dg_test_catalogue

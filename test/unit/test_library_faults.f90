!> The door for programs of others: names that files could not hold, and one error for one mistake.
module dg_test_library_faults
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use funit, only: assertEqual, TestMethod, TestSuite
   use dg_library_parts, only: drilling, fill, quantities, refuse, refuse_case, spoil
   use drillgap, only: error_type, load_case_type, model_parts_type, model_type, new_model, settings_of, wp
   implicit none
   private
   public :: library_faults_suite

contains

   function library_faults_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('library_faults')
      call suite%addTest(TestMethod('names', test_names))
      call suite%addTest(TestMethod('one_mistake_one_error', test_one_mistake))
   end function library_faults_suite

   !> Names that a deck may not have either: files of results hold them.
   subroutine test_names()
      type(load_case_type) :: load_case
      type(model_parts_type) :: parts
      call fill(parts)
      parts%holes(1)%name = '=1+1'
      call refuse(parts, 'holes(1): name = ''=1+1'' begins with =')
      call fill(parts)
      parts%strings(1)%components(2)%name = '@pipe'
      call refuse(parts, 'strings(1)%components(2): name = ''@pipe'' begins with @')
      call fill(parts)
      parts%strings(1)%components(2)%kind = char(216)//char(156)
      call refuse(parts, 'strings(1)%components(2): kind = ''??'' holds the letter U+061C')
      call fill(parts)
      parts%strings(1)%name = char(246)
      call refuse(parts, 'is not UTF-8: byte 1 is hexadecimal F6')
      load_case = drilling()
      load_case%name = '-drill'
      call refuse_case(load_case, 'name = ''-drill'' begins with -')
      load_case = drilling()
      load_case%section = '+8'
      call refuse_case(load_case, 'section = ''+8'' begins with +')
   end subroutine test_names

   !> A quantity that is not finite, an unknown fidelity, and a bad survey of a hole without a lower end give one line each.
   subroutine test_one_mistake()
      type(model_parts_type) :: parts
      real(wp) :: number
      integer :: i, k
      number = ieee_value(number, ieee_quiet_nan)
      do i = 1, quantities
         call fill(parts)
         call spoil(parts, i, number)
         call refuse_once(parts, ': ')
      end do
      do k = 1, 4
         call fill(parts)
         parts%holes(size(parts%holes))%md_bottom = 0.0_wp
         if (k == 1) parts%survey%md(3) = -1.0_wp
         if (k == 2) parts%survey%md(3) = parts%survey%md(2)
         if (k == 3) deallocate (parts%survey%inclination)
         if (k == 4) parts%survey%md = parts%survey%md(:1)
         call refuse_once(parts, 'survey: ')
      end do
      call fill(parts)
      parts%strings(1)%components(1)%opened_od = 0.21_wp
      call refuse_once(parts, 'strings(1)%components(1): ''collar'' has opened_od and no depth from which on it is open')
      parts%strings(1)%components(1)%opened_od = 0.16_wp
      call refuse_once(parts, 'opened_od = 0.16 is not greater than the closed diameter, 0.1651')
      parts%strings(1)%components(1)%opened_od = 0.0_wp
      parts%strings(1)%components(1)%opened_below = 1500.0_wp
      call refuse_once(parts, 'opened_below = 1500 has no meaning without opened_od')
      call fill(parts)
      parts%numerics = settings_of('nonsense')
      call refuse_once(parts, 'numerics: settings_of(''nonsense'') is unknown; legal: auto, fast, standard, reference')
      parts%numerics = settings_of('')
      call refuse_once(parts, 'numerics: settings_of('''') is unknown')
      parts%numerics = settings_of('Fast')
      call assertEqual('', parts%numerics%unknown_fidelity)
      call assertEqual(60.0_wp, parts%numerics%element_length)
   end subroutine test_one_mistake

   !> Parts must be refused with a message of one line that holds `expected`.
   subroutine refuse_once(parts, expected)
      type(model_parts_type), intent(in) :: parts
      character(*), intent(in) :: expected
      type(model_type) :: model
      type(error_type), allocatable :: error
      call refuse(parts, expected)
      call new_model(model, parts, error)
      if (.not. allocated(error)) return
      call assertEqual(0, index(error%message, new_line('a')), message='one line: '//error%message)
   end subroutine refuse_once
end module dg_test_library_faults

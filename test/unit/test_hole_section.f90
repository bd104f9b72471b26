module dg_test_hole_section
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use dg_hole_section, only: hole_section_at, hole_section_type, last_shoe, visit_hole
   use dg_key_visitor, only: key_visitor_type
   use dg_contact_friction, only: axial_friction, set_axial_friction
   use dg_deck_keys, only: keys_of
   use dg_deck_schema, only: key_rule_type, kind_real
   use dg_kinds, only: wp
   use dg_load_case, only: operation_count, operation_rotary_drilling, operation_trip_in, operation_trip_out
   use dg_missing, only: is_missing
   implicit none
   private
   public :: hole_section_suite

   !> Collects keys and numbers; each number is doubled.
   type, extends(key_visitor_type) :: collector_type
      character(20) :: keys(20) = ''
      real(wp) :: numbers(20) = 0.0_wp
      integer :: count = 0
   contains
      procedure :: number => collect
   end type collector_type

contains

   subroutine collect(self, key, value)
      class(collector_type), intent(inout) :: self
      character(*), intent(in) :: key
      real(wp), intent(inout) :: value
      self%count = self%count + 1
      self%keys(self%count) = key
      self%numbers(self%count) = value
      value = 2.0_wp*value
   end subroutine collect

   function hole_section_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('hole_section')
      call suite%addTest(TestMethod('section_at_a_depth', test_section_at_a_depth))
      call suite%addTest(TestMethod('last_shoe', test_last_shoe))
      call suite%addTest(TestMethod('numbers_are_those_of_a_deck', test_numbers))
      call suite%addTest(TestMethod('friction_of_an_operation', test_friction))
   end function hole_section_suite

   subroutine test_section_at_a_depth()
      type(hole_section_type) :: sections(2)
      sections%md_top = [0.0_wp, 1200.0_wp]
      sections%md_bottom = [1200.0_wp, 3000.0_wp]
      call assertEqual(1, hole_section_at(sections, 0.0_wp))
      call assertEqual(1, hole_section_at(sections, 1199.0_wp))
      call assertEqual(2, hole_section_at(sections, 1200.0_wp), message='at a boundary the lower one')
      call assertEqual(2, hole_section_at(sections, 3000.0_wp))
      call assertEqual(2, hole_section_at(sections, 3500.0_wp), message='below the last')
      call assertEqual(1, hole_section_at(sections, -5.0_wp), message='above the first')
   end subroutine test_section_at_a_depth

   !> Every number that a deck may give to a section is visited once, but for `friction`, which stands for two of them. A
   !> number that is missing is left out.
   subroutine test_numbers()
      type(key_rule_type), allocatable :: rules(:)
      type(hole_section_type) :: hole
      type(collector_type) :: collector
      integer :: k
      rules = keys_of('hole')
      hole = hole_section_type('', 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp, 6.0_wp, 7.0_wp, .false., 8.0_wp, &
                               9.0_wp, 10.0_wp, 11.0_wp)
      call visit_hole(hole, collector)
      do k = 1, size(rules)
         if (rules(k)%kind /= kind_real .or. rules(k)%key == 'friction') cycle
         call assertEqual(1, count(collector%keys == rules(k)%key), message=rules(k)%key)
      end do
      call assertEqual(count(rules%kind == kind_real) - 1, collector%count)
      call assertEqual([(real(k, wp), k=1, 11)], collector%numbers(:11))
      call assertEqual(22.0_wp, hole%wear_factor, message='a visitor may change a number')
      hole = hole_section_type('', 1.0_wp, 2.0_wp, 3.0_wp)
      collector = collector_type()
      call visit_hole(hole, collector)
      call assertEqual(7, collector%count, message='four numbers are missing')
   end subroutine test_numbers

   !> Of trip_in alone another, where it is given; changed for some operations or for all.
   subroutine test_friction()
      type(hole_section_type) :: hole, changed
      integer :: operation
      hole%friction_axial = 0.2_wp
      call assertEqual(0.2_wp, axial_friction(hole, operation_trip_in))
      changed = hole
      call set_axial_friction(changed, 0.4_wp, [operation_trip_in])
      call assertEqual(0.4_wp, axial_friction(changed, operation_trip_out), message='one coefficient for both')
      hole%friction_running_in = 0.3_wp
      do operation = 1, operation_count
         call assertEqual(merge(0.3_wp, 0.2_wp, operation == operation_trip_in), axial_friction(hole, operation))
      end do
      changed = hole
      call set_axial_friction(changed, 0.4_wp)
      call assertEqual([0.4_wp, 0.4_wp], axial_friction(changed, [operation_trip_in, operation_trip_out]))
      changed = hole
      call set_axial_friction(changed, 0.4_wp, [operation_trip_in, operation_rotary_drilling])
      call assertEqual([0.4_wp, 0.2_wp], axial_friction(changed, [operation_trip_in, operation_trip_out]))
      changed = hole
      call set_axial_friction(changed, 0.4_wp, [operation_rotary_drilling])
      call assertEqual([0.3_wp, 0.4_wp], axial_friction(changed, [operation_trip_in, operation_trip_out]))
   end subroutine test_friction

   !> Casing, a window of open hole, a liner, open hole.
   subroutine test_last_shoe()
      type(hole_section_type) :: sections(4)
      sections%md_bottom = [1200.0_wp, 1210.0_wp, 2000.0_wp, 3000.0_wp]
      call assertTrue(is_missing(last_shoe(sections)), message='no casing')
      sections(1)%cased = .true.
      call assertEqual(1200.0_wp, last_shoe(sections))
      sections(3)%cased = .true.
      call assertEqual(2000.0_wp, last_shoe(sections))
   end subroutine test_last_shoe
end module dg_test_hole_section

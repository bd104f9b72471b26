!> Strings that are held: cutting them off, stretch by sections and its inverse, stretch from profiles.
module dg_test_stuck_string
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_component, only: axial_stiffness, component_type
   use dg_drillstring, only: component_tops, drillstring_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_profile, only: new_profile, profile_type
   use dg_stuck_string, only: cut_string, free_point_without_friction, stretch_between, value_at
   implicit none
   private
   public :: stuck_string_suite

   real(wp), parameter :: round_off = 1.0e-12_wp

contains

   function stuck_string_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('stuck_string')
      call suite%addTest(TestMethod('cut', test_cut))
      call suite%addTest(TestMethod('stretch_by_sections', test_sections))
      call suite%addTest(TestMethod('stretch_of_profiles', test_profiles))
   end function stuck_string_suite

   !> Collars of 100 m, heavy pipe of 200 m, pipe to surface; bit at 1000 m.
   subroutine build(model)
      type(model_type), intent(out) :: model
      allocate (model%holes(0), model%strings(1), model%cases(1))
      model%strings(1)%name = 'main'
      allocate (model%strings(1)%components(3))
      model%strings(1)%components(1) = component_type('collar', 'collar', 100.0_wp, 0.16_wp, 0.07_wp, 130.0_wp)
      model%strings(1)%components(2) = component_type('heavy', 'hwdp', 200.0_wp, 0.127_wp, 0.0762_wp, 73.0_wp)
      model%strings(1)%components(3) = component_type('pipe', 'drillpipe', 0.0_wp, 0.127_wp, 0.1086_wp, 31.0_wp)
      model%cases(1)%string = 'main'
      model%cases(1)%bit_depth = 1000.0_wp
   end subroutine build

   subroutine test_cut()
      type(model_type) :: model
      call build(model)
      call cut_string(model, 1000.0_wp)
      call assertEqual(3, size(model%strings(1)%components))
      call assertTrue(model%boundary%bit_centred, message='held at the bit: as the deck says')
      call cut_string(model, 850.0_wp)
      call assertEqual(2, size(model%strings(1)%components))
      call assertEqual('heavy', model%strings(1)%components(1)%name)
      call assertEqual(150.0_wp, model%strings(1)%components(1)%length, round_off, message='of its 200 m')
      call assertEqual(850.0_wp, model%cases(1)%bit_depth)
      call assertFalse(model%boundary%bit_centred)
      call cut_string(model, 700.0_wp)
      call assertEqual('pipe', model%strings(1)%components(1)%name, message='exactly at the joint')
      call cut_string(model, 300.0_wp)
      call assertEqual(1, size(model%strings(1)%components))
      call assertEqual(0.0_wp, model%strings(1)%components(1)%length, message='still to surface')
   end subroutine test_cut

   !> Sum of length over E A; the formula gives back the depth in each of the three parts, and more than the bit's beyond.
   subroutine test_sections()
      type(model_type) :: model
      real(wp), parameter :: depths(3) = [300.0_wp, 850.0_wp, 990.0_wp], pull = 2.0e5_wp
      integer :: i
      call build(model)
      associate (string => model%strings(1), parts => model%strings(1)%components)
         call assertRelativelyEqual(700.0_wp/axial_stiffness(parts(3)) + 150.0_wp/axial_stiffness(parts(2)), &
                                    compliance(string, 1000.0_wp, 850.0_wp), round_off)
         do i = 1, size(depths)
            call assertRelativelyEqual(depths(i), free_point_without_friction(string, 1000.0_wp, pull, &
                                       pull*compliance(string, 1000.0_wp, depths(i))), round_off)
         end do
         call assertGreaterThan(free_point_without_friction(string, 1000.0_wp, pull, &
                                1.01_wp*pull*compliance(string, 1000.0_wp, 1000.0_wp)), 1000.0_wp)
      end associate
   end subroutine test_sections

   !> A change of force from 100 kN at surface to 40 kN at 800 m in a straight line, on meshes that differ: mean times length
   !> over E A of the pipe down to 700 m and of the heavy pipe below.
   subroutine test_profiles()
      type(model_type) :: model
      type(profile_type) :: first, second
      integer :: i
      call build(model)
      first = new_profile(9)
      first%md = [(100.0_wp*i, i=0, 8)]
      first%axial = 2.0e5_wp - 50.0_wp*first%md
      second = new_profile(3)
      second%md = [0.0_wp, 350.0_wp, 800.0_wp]
      second%axial = 3.0e5_wp - 125.0_wp*second%md
      call assertEqual(3.0e5_wp - 125.0_wp*420.0_wp, value_at(second%md, second%axial, 420.0_wp), 1.0e-6_wp)
      associate (parts => model%strings(1)%components)
         call assertRelativelyEqual(700.0_wp*73.75e3_wp/axial_stiffness(parts(3)) + &
                                    100.0_wp*43.75e3_wp/axial_stiffness(parts(2)), &
                                    stretch_between(first, second, model%strings(1), 1000.0_wp), round_off)
      end associate
   end subroutine test_profiles

   !> Stretch of the string between surface and a depth for a pull of one newton that does not change along it [m/N].
   pure function compliance(string, bit_depth, depth) result(stretch)
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit_depth, depth    !< [m]
      real(wp) :: stretch
      real(wp) :: tops(size(string%components)), top, bottom
      integer :: i
      tops = bit_depth - component_tops(string, bit_depth)      ! depths of the upper ends
      stretch = 0.0_wp
      bottom = bit_depth
      do i = 1, size(tops)
         top = tops(i)
         stretch = stretch + max(0.0_wp, min(bottom, depth) - top)/axial_stiffness(string%components(i))
         bottom = top
      end do
   end function compliance
end module dg_test_stuck_string

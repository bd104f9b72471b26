!> Extremes of every axis of a well, at default settings: each case is right, refused, marked or locked up, not quietly wrong.
module dg_test_extremes
   use funit, only: assertTrue, TestMethod, TestSuite
   use dg_extreme_case, only: answer_type, extreme_case_type
   use dg_extreme_reference, only: by_independent_beam
   use dg_extreme_table, only: begin_row, finish_row, row_type, add_row, add_bent, add_short, add_straight
   use dg_extreme_wells, only: add_stations, base_well, case_of, coil_condition, coil_lock_up, horizontal_well, straight_well, &
                               tubing_well
   use dg_independent_beam, only: independent_well_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_rotary_drilling, operation_rotate_off_bottom, operation_sliding_drilling, operation_static, &
                           operation_trip_in, operation_trip_out
   use dg_text, only: to_text
   implicit none
   private
   public :: extremes_suite

   real(wp), parameter :: mu = 0.3_wp
   !> Operations of most axes, and of those where going down matters.
   integer, parameter :: two(2) = [operation_trip_out, operation_rotate_off_bottom], &
                         three(3) = [operation_trip_out, operation_trip_in, operation_rotate_off_bottom]
   !> Clearances up to which the independent beam needs short elements, and these [m]. The second are for torque.
   real(wp), parameter :: tight(2) = [1.0e-3_wp, 1.5e-4_wp], fine_step(2) = [0.1_wp, 0.05_wp]
   !> Wall from which on the reference has the same, as good as rigid [N/m2].
   real(wp), parameter :: rigid = 1.0e10_wp

contains

   function extremes_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('extremes')
      call suite%addTest(TestMethod('wall_stiffness', test_wall_stiffness))
      call suite%addTest(TestMethod('element_length', test_element_length))
      call suite%addTest(TestMethod('clearance', test_clearance))
      call suite%addTest(TestMethod('string_length', test_string_length))
      call suite%addTest(TestMethod('dogleg', test_dogleg))
      call suite%addTest(TestMethod('friction', test_friction))
      call suite%addTest(TestMethod('weight_on_bit', test_weight_on_bit))
      call suite%addTest(TestMethod('push', test_push))
      call suite%addTest(TestMethod('stations', test_stations))
      call suite%addTest(TestMethod('inclination', test_inclination))
   end function extremes_suite

   !> From mud to what no material has.
   subroutine test_wall_stiffness()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(answer_type) :: reference(2)
      real(wp) :: wall
      logical :: found
      integer :: i, k
      call begin_row(row, 'wall stiffness', '1 to 1e10 kN/m2')
      do i = 0, 10
         wall = 1.0e3_wp*10.0_wp**i
         do k = 1, 2
            extreme = case_of(base_well(), two(k), mu, 'wall '//to_text(1.0e-3_wp*wall, 2)//' kN/m2')
            extreme%wall = wall
            if (wall <= rigid) call by_independent_beam(extreme, reference(k), found)
            call assertTrue(found, message=trim(extreme%label)//': reference')
            call add_row(extreme, reference(k), row)
         end do
      end do
      call finish_row(row)
   end subroutine test_wall_stiffness

   subroutine test_element_length()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(answer_type) :: reference
      real(wp), parameter :: length(7) = [0.1_wp, 0.3_wp, 1.0_wp, 3.0_wp, 10.0_wp, 30.0_wp, 100.0_wp]
      logical :: found
      integer :: i, k
      call begin_row(row, 'element length', '0.1 to 100 m')
      do k = 1, 2
         call by_independent_beam(case_of(base_well(), two(k), mu, ''), reference, found)
         call assertTrue(found, message='elements: reference')
         do i = 1, size(length)
            extreme = case_of(base_well(), two(k), mu, 'elements '//to_text(length(i), 2)//' m')
            extreme%element = length(i)
            call add_row(extreme, reference, row)
         end do
      end do
      call finish_row(row)
   end subroutine test_element_length

   subroutine test_clearance()
      type(row_type) :: row
      type(independent_well_type) :: well
      real(wp), parameter :: clearance(7) = [1.0e-4_wp, 5.0e-4_wp, 2.0e-3_wp, 1.0e-2_wp, 3.0e-2_wp, 0.1_wp, 0.5_wp]
      integer :: i, k
      call begin_row(row, 'clearance', '0.1 mm to 0.5 m')
      do i = 1, size(clearance)
         well = base_well()
         well%diameter = well%joint(1) + 2.0_wp*clearance(i)
         if (clearance(i) < tight(1)) well%step = fine_step(1)
         do k = 1, 2
            if (clearance(i) < tight(2) .and. two(k) == operation_rotate_off_bottom) well%step = fine_step(2)
            call add_bent(case_of(well, two(k), mu, 'clearance '//to_text(1.0e3_wp*clearance(i), 2)//' mm'), row)
         end do
      end do
      call finish_row(row)
   end subroutine test_clearance

   !> A straight hole of 50 deg, a short beam between its supports, and long vertical holes that build to 60 deg.
   subroutine test_string_length()
      type(row_type) :: row
      type(independent_well_type) :: well
      real(wp), parameter :: length(7) = [5.0_wp, 15.0_wp, 50.0_wp, 150.0_wp, 500.0_wp, 2000.0_wp, 15000.0_wp]
      integer :: i, k
      call begin_row(row, 'string length', '5 m to 15 km')
      do i = 1, size(length)
         do k = 1, 3
            well = straight_well(length(i), 50.0_wp)
            call add_straight(case_of(well, three(k), mu, 'length '//to_text(length(i), 2)//' m'), row)
         end do
         if (length(i) < 20.0_wp) call add_bent(case_of(well, operation_static, mu, 'held, '//to_text(length(i), 2)//' m'), row)
      end do
      do i = 1, 2
         well = base_well()
         well%md = [0.0_wp, 1000.0_wp, 2000.0_wp, 5000.0_wp*merge(1.0_wp, 3.0_wp, i == 1)]
         well%inclination = [0.0_wp, 0.0_wp, 60.0_wp, 60.0_wp]
         well%azimuth = spread(20.0_wp, 1, 4)
         well%bit = well%md(4)
         well%step = merge(0.5_wp, 0.75_wp, i == 1)
         call add_bent(case_of(well, operation_trip_out, mu, 'built, '//to_text(well%bit, 2)//' m'), row)
      end do
      call finish_row(row)
   end subroutine test_string_length

   !> The independent beam leaves out clearance over radius, 0.35 % at the sharpest.
   subroutine test_dogleg()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      real(wp), parameter :: dogleg(8) = [0.05_wp, 0.3_wp, 1.0_wp, 3.0_wp, 10.0_wp, 30.0_wp, 100.0_wp, 300.0_wp], sharp = 200.0_wp
      integer :: i, k
      call begin_row(row, 'dogleg', '0.05 to 300 deg/30 m')
      do i = 1, size(dogleg)
         do k = 1, 2
            extreme = case_of(tubing_well(dogleg(i)), two(k), mu, 'dogleg '//to_text(dogleg(i), 2))
            if (dogleg(i) > sharp) then
               call add_short(extreme, row)
            else
               call add_bent(extreme, row)
            end if
         end do
      end do
      call finish_row(row)
   end subroutine test_dogleg

   subroutine test_friction()
      type(row_type) :: row
      real(wp), parameter :: friction(5) = [0.0_wp, 0.1_wp, 0.3_wp, 0.6_wp, 1.0_wp]
      character(:), allocatable :: label
      integer :: i, k
      call begin_row(row, 'friction', '0 to 1')
      do i = 1, size(friction)
         label = 'friction '//to_text(friction(i), 2)
         do k = 1, 3
            call add_bent(case_of(base_well(), three(k), friction(i), label), row)
            call add_straight(case_of(straight_well(150.0_wp, 50.0_wp), three(k), friction(i), label//', straight'), row)
         end do
      end do
      call finish_row(row)
   end subroutine test_friction

   !> From hard overpull to next to buckling.
   subroutine test_weight_on_bit()
      type(row_type) :: row
      type(independent_well_type) :: well
      real(wp), parameter :: wob(9) = [-3.0e6_wp, -1.0e6_wp, -3.0e5_wp, -1.0e5_wp, -1.0e4_wp, 0.0_wp, 1.0e4_wp, 2.0e4_wp, 4.0e4_wp]
      character(:), allocatable :: label
      integer :: i
      call begin_row(row, 'weight on bit', '-3000 to 40 kN')
      do i = 1, size(wob)
         well = base_well()
         well%wob = wob(i)
         label = 'WOB '//to_text(1.0e-3_wp*wob(i), 4)//' kN'
         call add_bent(case_of(well, merge(operation_trip_out, operation_static, wob(i) < 0.0_wp), mu, label), row)
         call add_bent(case_of(well, operation_rotary_drilling, mu, label), row)
      end do
      call finish_row(row)
   end subroutine test_weight_on_bit

   !> A horizontal string pushed beyond buckling, and beyond the load at which friction of its coils holds it.
   subroutine test_push()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(independent_well_type) :: well
      real(wp), parameter :: share(8) = [0.1_wp, 0.3_wp, 0.6_wp, 0.8_wp, 0.95_wp, 1.05_wp, 2.0_wp, 10.0_wp]
      integer :: i
      call begin_row(row, 'push over lock-up load', '0.1 to 10')
      do i = 1, size(share)
         well = horizontal_well()
         well%wob = share(i)*coil_lock_up(well, mu)
         extreme = case_of(well, operation_sliding_drilling, mu, 'push '//to_text(share(i), 3)//' of lock-up')
         extreme%lock_up = share(i) > 1.0_wp
         extreme%condition = coil_condition(well, mu)
         call add_short(extreme, row)
      end do
      call finish_row(row)
   end subroutine test_push

   !> One hole by stations 1 km apart, and with 200 more on a part of its bend.
   subroutine test_stations()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      type(independent_well_type) :: well
      type(answer_type) :: reference
      real(wp), parameter :: spacing(6) = [1000.0_wp, 100.0_wp, 10.0_wp, 1.0_wp, 0.1_wp, 0.01_wp]
      integer :: i, k
      logical :: found
      call begin_row(row, 'distance of stations', '0.01 m to 1 km')
      do k = 1, 2
         well = base_well()
         well%md = [0.0_wp, 1000.0_wp, 2000.0_wp, 3000.0_wp]
         well%inclination = [0.0_wp, 0.0_wp, 50.0_wp, 50.0_wp]
         well%azimuth = spread(20.0_wp, 1, 4)
         well%bit = 2900.0_wp
         well%step = 0.5_wp
         do i = 1, size(spacing)
            extreme = case_of(well, two(k), mu, 'stations '//to_text(spacing(i), 2)//' m')
            if (i == 1) call by_independent_beam(extreme, reference, found)
            if (i > 1) call add_stations(extreme%well, spacing(i), min(1000.0_wp, 200.0_wp*spacing(i)))
            call assertTrue(found, message='stations: reference')
            call add_row(extreme, reference, row)
         end do
      end do
      call finish_row(row)
   end subroutine test_stations

   !> From straight down to straight up. A string of 60 m that is pushed straight up buckles, which closed forms do not know.
   subroutine test_inclination()
      type(row_type) :: row
      type(extreme_case_type) :: extreme
      real(wp), parameter :: inclination(9) = [0.0_wp, 1.0_wp, 10.0_wp, 45.0_wp, 80.0_wp, 90.0_wp, 100.0_wp, 150.0_wp, 180.0_wp]
      integer :: i, k
      call begin_row(row, 'inclination', '0 to 180 deg')
      do i = 1, size(inclination)
         do k = 1, 3
            extreme = case_of(straight_well(60.0_wp, inclination(i)), three(k), mu, 'inclination '//to_text(inclination(i), 3))
            if (inclination(i) < 180.0_wp) call add_straight(extreme, row)
            if (.not. inclination(i) < 180.0_wp) call add_short(extreme, row)
         end do
      end do
      call finish_row(row)
   end subroutine test_inclination
end module dg_test_extremes

!> Fluids by depth: which one stands where, collars and levels of decks, weights and pressures by hand.
module dg_test_fluid
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use dg_component, only: buoyed_weight, component_type
   use dg_constants, only: degree, pi
   use dg_error, only: error_list_type, error_text, error_type
   use dg_fluid, only: collar_closed, cut_mud, density_at, fluid_tops, fluid_type, heaviest_fluid, mud_type, side_inside, &
                       side_outside, standing_mud
   use dg_job, only: job_type
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_read_deck, only: build_deck
   use dg_sampled_model, only: draw_model, draw_of, quantity_density
   use dg_text, only: append_text, text_type
   use dg_trajectory, only: interpolation_minimum_curvature, measured_depth_at, new_trajectory, trajectory_type, &
                            true_vertical_depth
   use dg_uncertainty, only: uncertainty_type
   implicit none
   private
   public :: fluid_suite

   real(wp), parameter :: rounding = 1.0e-12_wp

contains

   function fluid_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('fluid')
      call suite%addTest(TestMethod('weight_by_hand', test_weight))
      call suite%addTest(TestMethod('one_fluid_as_before', test_one_fluid))
      call suite%addTest(TestMethod('which_fluid_where', test_places))
      call suite%addTest(TestMethod('string_cut_off', test_cut))
      call suite%addTest(TestMethod('depth_of_a_level', test_level))
      call suite%addTest(TestMethod('deck', test_deck))
      call suite%addTest(TestMethod('samples', test_samples))
   end function fluid_suite

   !> 1 m of pipe of 30 kg/m, steel of 7850 kg/m3, bore 0.1 m: oil of 800 inside, mud of 1500 outside, gravity 10:
   !> 300 + 80 pi/4 0.1**2 100 - 15000 (pi/4 0.1**2 + 30/7850) N.
   subroutine test_weight()
      type(component_type) :: pipe
      real(wp) :: bore
      pipe%od = 0.12_wp
      pipe%id = 0.1_wp
      pipe%mass = 30.0_wp
      bore = 0.25_wp*pi*0.01_wp
      call assertRelativelyEqual(300.0_wp + 8000.0_wp*bore - 15000.0_wp*(bore + 30.0_wp/7850.0_wp), &
                                 buoyed_weight(pipe, 1500.0_wp, 800.0_wp, 10.0_wp), rounding)
   end subroutine test_weight

   !> To the last bit what a string in one mud weighed.
   subroutine test_one_fluid()
      type(component_type) :: pipe
      pipe%id = 0.1086_wp
      pipe%mass = 31.9_wp
      call assertEqual(31.9_wp*9.80665_wp*(1.0_wp - 1203.7_wp/7850.0_wp), buoyed_weight(pipe, 1203.7_wp, 1203.7_wp, 9.80665_wp), &
                       0.0_wp)
   end subroutine test_one_fluid

   !> Mud from 20 m on both sides, inside something else from 500 m above the bit.
   subroutine test_places()
      type(mud_type) :: mud, air
      call assertEqual(0.0_wp, density_at(air, side_inside, 100.0_wp, 1000.0_wp), message='air')
      call assertEqual(0, size(fluid_tops(air, 1000.0_wp)))
      allocate (mud%fluids(2))
      mud%fluids(1) = fluid_type(density=1200.0_wp, md_top=20.0_wp)
      mud%fluids(2) = fluid_type(outside=.false., density=1.0_wp, above_bit=500.0_wp)
      call assertEqual(0.0_wp, density_at(mud, side_outside, 19.0_wp, 1000.0_wp))
      call assertEqual(1200.0_wp, density_at(mud, side_outside, 20.0_wp, 1000.0_wp))
      call assertEqual(1200.0_wp, density_at(mud, side_outside, 999.0_wp, 1000.0_wp))
      call assertEqual(1200.0_wp, density_at(mud, side_inside, 499.0_wp, 1000.0_wp))
      call assertEqual(1.0_wp, density_at(mud, side_inside, 501.0_wp, 1000.0_wp))
      call assertEqual(1.0_wp, density_at(mud, side_inside, 1.0_wp, 400.0_wp), message='its place is above the surface')
      call assertEqual([20.0_wp, 500.0_wp], fluid_tops(mud, 1000.0_wp))
      call assertEqual([10.0_wp, 20.0_wp], fluid_tops(mud, 510.0_wp), message='ascending')
      call assertEqual([20.0_wp], fluid_tops(mud, 400.0_wp))
      call assertEqual(1200.0_wp, heaviest_fluid(mud))
   end subroutine test_places

   !> A string that ends 200 m higher: places count from its new end, a fluid below it is gone.
   subroutine test_cut()
      type(mud_type) :: mud
      mud = standing_mud(1200.0_wp)
      mud%fluids = [mud%fluids, fluid_type(outside=.false., above_bit=500.0_wp, collar=collar_closed), &
                    fluid_type(outside=.false., density=900.0_wp, above_bit=30.0_wp)]
      call cut_mud(mud, 200.0_wp)
      call assertEqual(2, size(mud%fluids))
      call assertEqual(1200.0_wp, density_at(mud, side_inside, 499.0_wp, 800.0_wp))
      call assertEqual(0.0_wp, density_at(mud, side_inside, 799.0_wp, 800.0_wp))
   end subroutine test_cut

   !> Straight to 600 m, then an arc to 90 deg over 900 m, radius 900/(pi/2): 600 m + radius sin(angle) of depth. Past 90 deg the
   !> hole comes up again: the first place counts.
   subroutine test_level()
      type(trajectory_type) :: path
      type(error_type), allocatable :: error
      real(wp), parameter :: radius = 900.0_wp/(0.5_wp*pi)
      call new_trajectory(path, [0.0_wp, 600.0_wp, 1500.0_wp, 2000.0_wp], [0.0_wp, 0.0_wp, 90.0_wp, 110.0_wp]*degree, &
                          [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], interpolation_minimum_curvature, error)
      call assertFalse(allocated(error))
      call assertEqual(250.0_wp, measured_depth_at(path, 250.0_wp), 1.0e-9_wp)
      call assertEqual(0.0_wp, measured_depth_at(path, 0.0_wp))
      call assertEqual(900.0_wp, measured_depth_at(path, 600.0_wp + 0.5_wp*radius), 1.0e-9_wp, message='30 deg')
      call assertTrue(measured_depth_at(path, 600.0_wp + 1.01_wp*radius) > 1.0e6_wp, message='never so deep')
      call assertTrue(measured_depth_at(path, true_vertical_depth(path, 1990.0_wp)) < 1500.0_wp)
   end subroutine test_level

   !> Lines of a deck with some fluids.
   subroutine read_with(fluids, model, faults, notes)
      character(*), intent(in) :: fluids
      type(model_type), intent(out) :: model
      type(error_list_type), intent(out) :: faults
      type(text_type), allocatable, intent(out) :: notes(:)
      type(text_type), allocatable :: lines(:)
      type(job_type) :: job
      call append_text(lines, '&trajectory md = 0, 1000, 2000, inc = 60, 60, 60, azi = 0, 0, 0 /')
      call append_text(lines, '&hole diameter = 311 friction = 0.2 /')
      call append_text(lines, '&component od = 244.5 id = 220.5 yield = 550 /')
      call append_text(lines, "&load_case name='a' operation='up' bit_depth=2000 pump_pressure = 15 /")
      call append_text(lines, fluids)
      call build_deck('deck', lines, model, job, faults)
      notes = job%notes
   end subroutine read_with

   subroutine test_deck()
      type(model_type) :: model
      type(error_list_type) :: faults
      type(text_type), allocatable :: notes(:)
      integer :: i
      call read_with('&fluid density=1200 / &fluid where=''inside'' density=900 tvd_top=500 / '// &
                     '&fluid where=''inside'' above_bit=300 float_collar=''closed'' /', model, faults, notes)
      call assertEqual(0, faults%count)
      if (faults%count > 0) return
      call assertEqual(15.0e6_wp, model%cases(1)%pump_pressure)
      call assertEqual([1000.0_wp, 1700.0_wp], fluid_tops(model%mud, 2000.0_wp), 1.0e-9_wp)
      call assertEqual(collar_closed, model%mud%fluids(3)%collar)
      call assertTrue(model%mud%fluids(1)%outside .and. .not. model%mud%fluids(2)%outside)
      call assertFalse(any([(index(notes(i)%text, 'float valve') > 0, i=1, size(notes))]), message='the collar holds')
      call read_with('&fluid where=''outside'' density=2000 /', model, faults, notes)
      call assertTrue(index(notes(2)%text, 'floats at 2000') > 0, message=notes(2)%text)
      call refuse('&fluid md_top=10, tvd_top=20 /', 'keep one')
      call refuse('&fluid above_bit=10 /', 'needs where')
      call refuse('&fluid where=''inside'', float_collar=''closed'' /', 'needs above_bit')
      call refuse('&fluid density=1200, tvd_top=1001 /', 'deeper than the hole')
      call refuse('&fluid density=1200 / &fluid density=1300 /', 'fills its whole length')
      call refuse('&fluid density=1200 / &fluid where=''inside'' / &fluid where=''outside'' /', 'fills its whole length')
      call refuse('&fluid density=1200 / &fluid where=''inside'' above_bit=300 / &fluid where=''inside'' tvd_top=200 /', &
                  'fills its whole length')
      call refuse('&fluid density=1200 / &fluid where=''inside'' above_bit=300 / &fluid where=''inside'' above_bit=500 /', &
                  'fills its whole length')
      call refuse('&fluid where=''inside'' density=8000 /', 'floats: the mud')
   contains
      subroutine refuse(fluids, expected)
         character(*), intent(in) :: fluids, expected
         call read_with(fluids, model, faults, notes)
         call assertEqual(1, faults%count, message=fluids)
         if (faults%count /= 1) return
         call assertTrue(index(error_text(faults%items(1)), expected) > 0, message=error_text(faults%items(1)))
         call assertTrue(index(error_text(faults%items(1)), 'deck:') == 1, message='file and line')
      end subroutine refuse
   end subroutine test_deck

   !> A deviation of density is that of the heaviest fluid; gas changes by as much less as it is lighter.
   subroutine test_samples()
      type(model_type) :: model, drawn
      type(error_list_type) :: faults
      type(text_type), allocatable :: notes(:)
      type(uncertainty_type) :: uncertainty
      type(error_type), allocatable :: error
      real(wp) :: change
      call read_with('&fluid density=1200 / &fluid where=''inside'' density=12 /', model, faults, notes)
      allocate (uncertainty%range%frictions(1))
      uncertainty%density_deviation = 50.0_wp
      call draw_model(model, uncertainty, 3, drawn, error)
      change = 50.0_wp*draw_of(uncertainty, 3, quantity_density, 0)
      call assertRelativelyEqual(1200.0_wp + change, drawn%mud%fluids(1)%density, rounding)
      call assertRelativelyEqual(12.0_wp*(1.0_wp + change/1200.0_wp), drawn%mud%fluids(2)%density, rounding)
   end subroutine test_samples
end module dg_test_fluid

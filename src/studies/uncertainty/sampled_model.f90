!> The model of one sample, with random friction, mud and survey.
module dg_sampled_model
   use dg_kinds, only: wp
   use dg_constants, only: pi
   use dg_contact_friction, only: set_axial_friction, shift_friction
   use dg_counter_random, only: normal_number
   use dg_error, only: error_type
   use dg_fluid, only: heaviest_fluid
   use dg_model, only: copy_without_cases, model_type
   use dg_trajectory, only: new_trajectory
   use dg_uncertainty, only: uncertainty_type
   implicit none
   private
   public :: draw_model, draw_of
   public :: quantity_friction, quantity_density, quantity_inclination, quantity_azimuth, quantity_hookload, quantity_torque

   !> Random quantities. Each has its own numbers, so that a deck with one more uncertainty keeps the others'.
   integer, parameter :: quantity_friction = 1     !< index: hole section
   integer, parameter :: quantity_density = 2
   integer, parameter :: quantity_inclination = 3  !< index: station; 0: all alike
   integer, parameter :: quantity_azimuth = 4
   integer, parameter :: quantity_hookload = 5     !< index: point
   integer, parameter :: quantity_torque = 6

contains

   !> A standard normal number of a sample.
   elemental function draw_of(uncertainty, sample, quantity, index) result(number)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: sample, quantity, index
      real(wp) :: number
      number = normal_number(uncertainty%seed, sample, quantity, index)
   end function draw_of

   !> The model of a sample, with room for one load case. Coefficients and density that would be negative are 0. `error` tells
   !> that the stations drawn make no path.
   subroutine draw_model(model, uncertainty, sample, drawn, error)
      type(model_type), intent(in) :: model
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: sample            !< >= 1
      type(model_type), intent(out) :: drawn
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: change
      integer :: i, j
      call copy_without_cases(model, drawn)
      do i = 1, size(drawn%holes)
         associate (hole => drawn%holes(i))
            if (uncertainty%range%frictions(1)%present) then
               call set_axial_friction(hole, uncertainty%range%frictions(1)%value)
               hole%friction_rotary = uncertainty%range%frictions(1)%value
            end if
            if (.not. allocated(uncertainty%friction_factor)) cycle
            change = 0.0_wp
            do j = 1, i
               if (abs(uncertainty%friction_factor(i, j)) > 0.0_wp) change = change + uncertainty%friction_factor(i, j)* &
                  draw_of(uncertainty, sample, quantity_friction, j)
            end do
            call shift_friction(hole, change, uncertainty%axial, uncertainty%rotary)
         end associate
      end do
      if (uncertainty%density_deviation > 0.0_wp .and. allocated(drawn%mud%fluids)) drawn%mud%fluids%density = &
         max(model%mud%fluids%density + uncertainty%density_deviation*draw_of(uncertainty, sample, quantity_density, 0)* &
             share_of(model%mud%fluids%density, heaviest_fluid(model%mud)), 0.0_wp)
      if (uncertainty%inclination_deviation > 0.0_wp .or. uncertainty%azimuth_deviation > 0.0_wp) &
         call draw_survey(model, uncertainty, sample, drawn, error)
   end subroutine draw_model

   !> Factor of a fluid on the deviation of density [-]. It is 1 for the heaviest one, and smaller for others, gas above all,
   !> in proportion to their density.
   elemental function share_of(density, heaviest) result(share)
      real(wp), intent(in) :: density, heaviest   !< [kg/m3]
      real(wp) :: share
      share = 1.0_wp
      if (density < heaviest) share = density/heaviest
   end function share_of

   !> Stations with random angles. An inclination below 0 or beyond pi is the same direction seen from the other side.
   subroutine draw_survey(model, uncertainty, sample, drawn, error)
      type(model_type), intent(in) :: model
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: sample
      type(model_type), intent(inout) :: drawn
      type(error_type), allocatable, intent(out) :: error
      real(wp), dimension(size(model%trajectory%md)) :: inclination, azimuth
      integer :: station(size(inclination)), i
      station = [(i, i=1, size(station))]
      if (uncertainty%systematic_survey) station = 0
      inclination = model%trajectory%inclination + uncertainty%inclination_deviation* &
                    draw_of(uncertainty, sample, quantity_inclination, station)
      azimuth = model%trajectory%azimuth + uncertainty%azimuth_deviation*draw_of(uncertainty, sample, quantity_azimuth, station)
      where (inclination < 0.0_wp .or. inclination > pi) azimuth = azimuth + pi
      where (inclination > pi) inclination = 2.0_wp*pi - inclination
      inclination = abs(inclination)
      call new_trajectory(drawn%trajectory, model%trajectory%md, inclination, azimuth, uncertainty%interpolation, error)
   end subroutine draw_survey
end module dg_sampled_model

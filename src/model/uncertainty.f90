!> What an &uncertainty of a deck asks for: a range of bit depths as in a sweep, solved again and again with what is not known
!> drawn anew each time.
module dg_uncertainty
   use dg_kinds, only: wp
   use dg_sweep, only: point_count, sweep_type
   use dg_trajectory, only: interpolation_minimum_curvature
   implicit none
   private
   public :: uncertainty_type, piece_count, piece_number

   type :: uncertainty_type
      type(sweep_type) :: range                     !< models, operations, depths; one friction, absent: that of the hole
      integer :: samples = 1000
      integer :: seed = 1                           !< >= 0
      ! standard deviations
      real(wp) :: friction_deviation = 0.0_wp       !< of each hole section's coefficients, both alike [-]
      real(wp) :: density_deviation = 0.0_wp        !< of the mud [kg/m3]
      real(wp) :: inclination_deviation = 0.0_wp    !< of a station [rad]
      real(wp) :: azimuth_deviation = 0.0_wp        !< of a station [rad]
      real(wp) :: hookload_deviation = 0.0_wp       !< of the gauge [N]
      real(wp) :: torque_deviation = 0.0_wp         !< of the gauge [N.m]
      logical :: systematic_survey = .false.        !< all stations are off alike, else each on its own
      integer :: interpolation = interpolation_minimum_curvature !< of the survey
   end type uncertainty_type

contains

   !> Solutions in all: each point of the range with each sample.
   pure function piece_count(uncertainty) result(count)
      type(uncertainty_type), intent(in) :: uncertainty
      integer :: count
      count = point_count(uncertainty%range)*uncertainty%samples
   end function piece_count

   !> Number of the solution of a point with a sample.
   elemental function piece_number(uncertainty, point, sample) result(number)
      type(uncertainty_type), intent(in) :: uncertainty
      integer, intent(in) :: point, sample
      integer :: number
      number = (point - 1)*uncertainty%samples + sample
   end function piece_number
end module dg_uncertainty

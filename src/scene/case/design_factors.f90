!> Factors on loads before they are compared with strengths, and the slips that hold the string.
module dg_design_factors
   use dg_kinds, only: wp
   implicit none
   private
   public :: design_factors_type

   type :: design_factors_type
      real(wp) :: von_mises = 1.0_wp
      real(wp) :: tension = 1.0_wp        !< of slips too
      real(wp) :: torsion = 1.0_wp        !< of bodies and connections; not of make-up torque
      real(wp) :: burst = 1.0_wp
      real(wp) :: collapse = 1.0_wp
      real(wp) :: slip_length = 0.0_wp    !< length of the slips that grip the pipe [m]; 0: not known
      real(wp) :: slip_lateral = 4.0_wp   !< lateral over axial load of the slips [-]
   end type design_factors_type
end module dg_design_factors

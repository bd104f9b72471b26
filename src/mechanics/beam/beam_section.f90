!> Section of a beam element: lengths and stiffnesses of both elements (dg_beam_element, dg_bending_element).
module dg_beam_section
   use dg_kinds, only: wp
   use dg_component, only: axial_stiffness, bending_stiffness, component_type, torsional_stiffness
   implicit none
   private
   public :: beam_section_type, section_of, end_stiffness

   type :: beam_section_type
      real(wp) :: length = 0.0_wp              !< L, along the hole [m]
      real(wp) :: membrane_length = 0.0_wp     !< L_m, unstressed length for the axial force [m]
      real(wp) :: ea = 0.0_wp                  !< EA, axial stiffness [N]
      real(wp) :: ei = 0.0_wp                  !< EI, bending stiffness [N.m2]
      real(wp) :: gj = 0.0_wp                  !< GJ, torsional stiffness [N.m2]
   end type beam_section_type

contains

   !> Section of an element of a component.
   pure function section_of(component, length, membrane_length) result(section)
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: length, membrane_length   !< unstressed [m]
      type(beam_section_type) :: section
      section%length = length
      section%membrane_length = membrane_length
      section%ea = axial_stiffness(component)
      section%ei = bending_stiffness(component)
      section%gj = torsional_stiffness(component)
   end function section_of

   !> Moments at the ends of an element by a turn of one end: at that end, and at the other end [N.m per rad].
   pure function end_stiffness(section) result(moments)
      type(beam_section_type), intent(in) :: section
      real(wp) :: moments(2)
      moments = [4.0_wp, 2.0_wp]*(section%ei/section%length)
   end function end_stiffness
end module dg_beam_section

!> References of the table of extremes: closed forms of a straight hole, a beam solved independently, and the program itself on
!> elements of a quarter of a metre.
module dg_extreme_reference
   use dg_constants, only: degree
   use dg_extreme_case, only: answer_type, contact, extreme_case_type, hookload, moment, right, solve_extreme, torque, &
                              verdict_type, weight_of
   use dg_independent_beam, only: bend_stretched, independent_beam_type, independent_well_type
   use dg_kinds, only: wp
   implicit none
   private
   public :: by_straight_hole, by_independent_beam, by_short_elements

   !> Walls that the independent beam takes for rigid, tried in this order [N/m2]: against the stiffer ones its iteration does not
   !> always end. The softest yields by micrometres. The first is for strings with less room than `tight` [m].
   real(wp), parameter :: rigid(3) = [1.0e11_wp, 1.0e10_wp, 1.0e9_wp], tight = 2.0e-3_wp
   real(wp), parameter :: quarter = 0.25_wp      !< of the longest element at `reference` [m]

contains

   !> A straight hole, ends free across: w L (cos +- mu sin) - WOB, the string at rest on the wall. A string that turns climbs to
   !> atan(mu): N = w sin/sqrt(1 + mu**2), torque = mu r N L + TOB.
   pure subroutine by_straight_hole(extreme, answer)
      type(extreme_case_type), intent(in) :: extreme
      type(answer_type), intent(out) :: answer
      real(wp) :: theta, weight
      associate (well => extreme%well)
         theta = well%inclination(1)*degree
         weight = weight_of(well)
         answer%value(contact) = weight*sin(theta)/sqrt(1.0_wp + well%around**2)
         answer%value(hookload) = weight*cos(theta) + well%along*answer%value(contact) - well%wob
         answer%value(torque) = well%tob + well%around*0.5_wp*max(well%od(1), well%joint(1))*answer%value(contact)
      end associate
   end subroutine by_straight_hole

   !> Differences in space. They leave out clearance over radius, and clearance times bend over length.
   subroutine by_independent_beam(extreme, answer, found)
      type(extreme_case_type), intent(in) :: extreme
      type(answer_type), intent(out) :: answer
      logical, intent(out) :: found
      type(independent_well_type) :: well
      type(independent_beam_type) :: beam
      integer :: i
      well = extreme%well
      do i = merge(1, 2, well%diameter - max(well%od(1), well%joint(1)) <= 2.0_wp*tight), size(rigid)
         well%wall = rigid(i)
         if (extreme%wall > 0.0_wp) well%wall = min(extreme%wall, rigid(i))
         call bend_stretched(well, beam, found)
         if (found) exit
      end do
      if (.not. found) return
      answer%value(hookload) = beam%axial(0)
      answer%value(torque) = beam%torque(0)
      answer%value(contact) = sum(beam%contact)
      answer%value(moment) = maxval(norm2(beam%moment, dim=1))
   end subroutine by_independent_beam

   !> The program at `reference`.
   subroutine by_short_elements(extreme, answer, found, element)
      type(extreme_case_type), intent(in) :: extreme
      type(answer_type), intent(out) :: answer
      logical, intent(out) :: found
      real(wp), intent(in), optional :: element     !< longest [m], else a quarter of a metre
      type(extreme_case_type) :: fine
      type(verdict_type) :: verdict
      fine = extreme
      fine%element = quarter
      if (present(element)) fine%element = element
      call solve_extreme(fine, answer, verdict, 'reference')
      found = verdict%number == right
   end subroutine by_short_elements
end module dg_extreme_reference

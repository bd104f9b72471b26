!> Compression at which a string buckles helically, and its contact force then. Starts of the beams and the lock-up of the soft
!> string use them.
module dg_helical_load
   use dg_kinds, only: wp
   use dg_buckling_limits, only: helical_low, lubinski_first, sinusoidal_limit, vertical_unit
   implicit none
   private
   public :: helical_load, least_helical_load, helical_contact, helical_bend, coil_clearance, wound_compression

contains

   !> Axial compression [N] above which a string under a known side load n per metre counts as helically buckled. It is the
   !> lower helical limit of dg_buckling_limits, 2 sqrt(2 EI n/c). In a vertical hole, where n = 0, it is twice Lubinski's
   !> (1950) first-order load 1.94 (EI w^2)^(1/3). There the pipe touches the wall all around, earlier than at the published
   !> helical limit. A start of the beams and a lock-up are therefore not late.
   elemental function helical_load(ei, side_load, weight, clearance) result(load)
      real(wp), intent(in) :: ei         !< [N.m2]
      real(wp), intent(in) :: side_load  !< [N/m]
      real(wp), intent(in) :: weight     !< [N/m]
      real(wp), intent(in) :: clearance  !< > 0 [m]
      real(wp) :: load
      load = max(helical_low*sinusoidal_limit(ei, side_load, clearance), least_helical_load(ei, weight))
   end function helical_load

   !> Helical load of a string without side load [N].
   elemental function least_helical_load(ei, weight) result(load)
      real(wp), intent(in) :: ei, weight   !< [N.m2, N/m]
      real(wp) :: load
      !> Load of a string without weight, as loads are divided by it [N].
      real(wp), parameter :: next_to_none = 1.0e-6_wp
      load = max(2.0_wp*lubinski_first*vertical_unit(ei, weight), next_to_none)
   end function least_helical_load

   !> Contact force per metre c F^2/(4 EI) of a helically buckled string [N/m].
   elemental function helical_contact(ei, compression, clearance) result(force)
      real(wp), intent(in) :: ei, compression, clearance   !< [N.m2, N, m]
      real(wp) :: force
      force = clearance*max(compression, 0.0_wp)**2/(4.0_wp*ei)
   end function helical_contact

   !> Curvature c F/(2 EI) of a helically buckled string [1/m] (Lubinski, Althouse & Logan 1962).
   elemental function helical_bend(ei, compression, clearance) result(curvature)
      real(wp), intent(in) :: ei, compression, clearance   !< [N.m2, N, m]
      real(wp) :: curvature
      curvature = clearance*max(compression, 0.0_wp)/(2.0_wp*ei)
   end function helical_bend

   !> Clearance of a helix of pipe whose joints touch one by one [m]. Pipe between two joints bows out to the wall above its Euler
   !> load P. The clearance grows from that of the joints to that of the body by the part 1 - P/F. Mitchell (2000) describes
   !> the contact of pipe between connectors. The growth is ours: it gives friction within 18 % of beams.
   elemental function coil_clearance(joints, height, euler, compression) result(clearance)
      real(wp), intent(in) :: joints        !< clearance of the joints [m]
      real(wp), intent(in) :: height        !< of the joints over the body, 0 for pipe without [m]
      real(wp), intent(in) :: euler         !< P of the body between two joints [N]
      real(wp), intent(in) :: compression   !< F, > 0 [N]
      real(wp) :: clearance
      clearance = joints + height*max(0.0_wp, 1.0_wp - euler/compression)
   end function coil_clearance

   !> Compression that winds a helix without torque as tightly as `compression` winds one under torque [N]. It is 2 EI b^2,
   !> with b the angle per metre of the helix of least energy, 2 EI b^2 - 1.5 M b - F = 0 (Miska & Cunha 1995). A string that
   !> is turned to the right winds to the left, down the hole. Wound to the right it would have -M. At given b the contact
   !> force of such a helix is c b^2 (F + M b - EI b^2) per metre.
   elemental function wound_compression(ei, compression, torque) result(force)
      real(wp), intent(in) :: ei            !< bending stiffness [N.m2]
      real(wp), intent(in) :: compression   !< F, > 0 [N]
      real(wp), intent(in) :: torque        !< M, of either sense [N.m]
      real(wp) :: force
      force = (1.5_wp*abs(torque) + sqrt(2.25_wp*torque**2 + 8.0_wp*ei*compression))**2/(8.0_wp*ei)
   end function wound_compression
end module dg_helical_load

!> The hole in sections along measured depth: diameter, friction, wall.
module dg_hole_section
   use dg_kinds, only: wp
   use dg_key_visitor, only: key_visitor_type
   use dg_missing, only: missing
   implicit none
   private
   public :: hole_section_type, hole_section_at, last_shoe, wall_of
   public :: visit_hole

   !> Default stiffness of a mud sheath: that of stiff clay [N/m2].
   real(wp), parameter :: sheath_stiffness = 1.0e8_wp
   !> Largest stiffness of a wall [N/m2]: fifty times solid steel. Beyond it only round-off changes.
   real(wp), parameter :: hardest = 1.0e13_wp

   type :: hole_section_type
      character(:), allocatable :: name
      real(wp) :: md_top = 0.0_wp          !< [m]
      real(wp) :: md_bottom = 0.0_wp       !< [m]
      real(wp) :: diameter = 0.0_wp        !< inside diameter D [m]
      real(wp) :: friction_axial = 0.0_wp  !< mu2 of Eq. 5 [-]
      real(wp) :: friction_rotary = 0.0_wp !< mu1 of Eq. 5 [-]
      real(wp) :: wall_stiffness = 0.0_wp  !< per metre of contact and of penetration [N/m2]; 0: gk_contact of the solver
      real(wp) :: mud_sheath = 0.0_wp      !< thickness t [m]; > 0 sets eps_nmax = 2 t/(D - d) here
      logical :: cased = .false.           !< for sweeps of cased and open friction, and for tools that open
      real(wp) :: friction_running_in = missing !< mu2 of trip_in alone [-]; missing: friction_axial
      real(wp) :: casing_od = missing      !< outside diameter of the casing, for wear [m]
      real(wp) :: casing_yield = missing   !< its yield strength, for the wall that wear leaves [Pa]
      real(wp) :: wear_factor = missing    !< volume worn off it over the work of sliding [1/Pa]
   end type hole_section_type

contains

   !> Visit all numbers of a section.
   subroutine visit_hole(hole, visitor)
      type(hole_section_type), intent(inout) :: hole
      class(key_visitor_type), intent(inout) :: visitor
      call visitor%number('md_top', hole%md_top)
      call visitor%number('md_bottom', hole%md_bottom)
      call visitor%number('diameter', hole%diameter)
      call visitor%number('friction_axial', hole%friction_axial)
      call visitor%number('friction_rotary', hole%friction_rotary)
      call visitor%number('wall_stiffness', hole%wall_stiffness)
      call visitor%number('mud_sheath', hole%mud_sheath)
      call visitor%number_or_missing('friction_running_in', hole%friction_running_in)
      call visitor%number_or_missing('casing_od', hole%casing_od)
      call visitor%number_or_missing('casing_yield', hole%casing_yield)
      call visitor%number_or_missing('wear_factor', hole%wear_factor)
   end subroutine visit_hole

   !> Stiffness of a section's wall, elastic and rigid [N/m2]. Without a stiffness of the section the solver's is used. Where
   !> mud covers the wall the elastic one is that of the mud, by default at most that of clay. The rigid one is then the
   !> solver's.
   pure subroutine wall_of(hole, gk_contact, gk_max, elastic, rigid)
      type(hole_section_type), intent(in) :: hole
      real(wp), intent(in) :: gk_contact, gk_max   !< of the solver [N/m2]
      real(wp), intent(out) :: elastic, rigid
      elastic = hole%wall_stiffness
      if (.not. elastic > 0.0_wp) then
         elastic = gk_contact
         if (hole%mud_sheath > 0.0_wp) elastic = min(elastic, sheath_stiffness)
      end if
      elastic = min(elastic, hardest)
      rigid = max(gk_max, elastic)
      if (hole%wall_stiffness > 0.0_wp .and. .not. hole%mud_sheath > 0.0_wp) rigid = elastic*(gk_max/gk_contact)
      rigid = min(rigid, hardest)
   end subroutine wall_of

   !> Index of the section that holds a depth [m]; at a boundary the lower one. Sections are ordered and abut. Depths outside
   !> belong to the nearest.
   pure function hole_section_at(sections, md) result(index)
      type(hole_section_type), intent(in) :: sections(:)
      real(wp), intent(in) :: md
      integer :: index
      do index = 1, size(sections) - 1
         if (md < sections(index)%md_bottom) return
      end do
      index = size(sections)
   end function hole_section_at

   !> Measured depth of the lower end of the last cased section [m]; missing without a cased section.
   pure function last_shoe(sections) result(md)
      type(hole_section_type), intent(in) :: sections(:)   !< from the top down
      real(wp) :: md
      integer :: i
      md = missing
      do i = 1, size(sections)
         if (sections(i)%cased) md = sections(i)%md_bottom
      end do
   end function last_shoe
end module dg_hole_section

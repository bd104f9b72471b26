!> The hole in sections along measured depth: diameter, friction, wall.
module dg_hole_section
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: hole_section_type, hole_section_at, last_shoe, wall_of
   public :: hole_keys, hole_numbers

   !> Stiffness of a mud sheath where none is given: that of stiff clay [N/m2].
   real(wp), parameter :: sheath_stiffness = 1.0e8_wp
   !> Walls that are given stiffer than this count as this stiff: fifty times solid steel, beyond which nothing changes but
   !> round-off [N/m2].
   real(wp), parameter :: hardest = 1.0e13_wp

   !> Keys of the numbers of a section, in the order of `hole_numbers`.
   character(*), parameter :: hole_keys(11) = [character(19) :: 'md_top', 'md_bottom', 'diameter', 'friction_axial', &
      'friction_rotary', 'wall_stiffness', 'mud_sheath', 'friction_running_in', 'casing_od', 'casing_yield', 'wear_factor']

   type :: hole_section_type
      character(:), allocatable :: name
      real(wp) :: md_top = 0.0_wp          !< [m]
      real(wp) :: md_bottom = 0.0_wp       !< [m]
      real(wp) :: diameter = 0.0_wp        !< inside diameter D [m]
      real(wp) :: friction_axial = 0.0_wp  !< mu2 of Eq. 5 [-]
      real(wp) :: friction_rotary = 0.0_wp !< mu1 of Eq. 5 [-]
      real(wp) :: wall_stiffness = 0.0_wp  !< per metre of contact and of penetration [N/m2]; 0: gk_contact of the solver
      real(wp) :: mud_sheath = 0.0_wp      !< thickness t [m]; > 0 sets eps_nmax = 2 t/(D - d) here
      logical :: cased = .false.           !< for sweeps by friction cased and open, and for tools that open
      real(wp) :: friction_running_in = missing !< mu2 of trip_in alone [-]; missing: friction_axial
      real(wp) :: casing_od = missing      !< outside diameter of the casing, for wear [m]
      real(wp) :: casing_yield = missing   !< its yield strength, for what wear leaves [Pa]
      real(wp) :: wear_factor = missing    !< volume worn off it over the work of sliding [1/Pa]
   end type hole_section_type

contains

   !> All numbers of a section [SI], for checks and records.
   pure function hole_numbers(hole) result(numbers)
      type(hole_section_type), intent(in) :: hole
      real(wp) :: numbers(size(hole_keys))
      numbers = [hole%md_top, hole%md_bottom, hole%diameter, hole%friction_axial, hole%friction_rotary, hole%wall_stiffness, &
                 hole%mud_sheath, hole%friction_running_in, hole%casing_od, hole%casing_yield, hole%wear_factor]
   end function hole_numbers

   !> Stiffness of a section's wall, elastic and rigid [N/m2]. Where the section has none of its own the solver's holds. Where mud
   !> covers the wall the elastic one is that of the mud, no more than clay's where none is given, and the rigid one the solver's.
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

   !> Index of the section that holds a depth [m]; at a boundary the lower one. Sections are ordered and
   !> abut; depths outside belong to the nearest.
   pure function hole_section_at(sections, md) result(index)
      type(hole_section_type), intent(in) :: sections(:)
      real(wp), intent(in) :: md
      integer :: index
      do index = 1, size(sections) - 1
         if (md < sections(index)%md_bottom) return
      end do
      index = size(sections)
   end function hole_section_at

   !> Measured depth of the lower end of the last cased section [m]; missing where no section is cased.
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

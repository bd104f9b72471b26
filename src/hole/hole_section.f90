!> The hole in sections along measured depth: diameter, friction, wall.
module dg_hole_section
   use dg_kinds, only: wp
   use dg_missing, only: missing
   implicit none
   private
   public :: hole_section_type, hole_section_at, last_shoe

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
   end type hole_section_type

contains

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

!> Parts of a model, one a call. One line of code sets a hole section, a component or a fluid, with the defaults of a deck. All
!> else is set in the type afterwards. SI units. Nothing is checked here: new_model does that.
module dg_parts_by_call
   use dg_component, only: component_type, tube_area
   use dg_drillstring, only: drillstring_type
   use dg_fluid, only: fluid_type
   use dg_hole_section, only: hole_section_type
   use dg_kinds, only: wp
   use dg_model_parts, only: model_parts_type
   implicit none
   private
   public :: add_hole, add_component, add_fluid

contains

   !> A hole section below those that are there. The last one may leave out its end: it reaches to that of the survey.
   pure subroutine add_hole(parts, diameter, friction, md_bottom, name)
      type(model_parts_type), intent(inout) :: parts
      real(wp), intent(in) :: diameter               !< inside [m]
      real(wp), intent(in) :: friction               !< coefficient along and around the hole [-]
      real(wp), intent(in), optional :: md_bottom    !< measured depth of its lower end [m]
      character(*), intent(in), optional :: name
      type(hole_section_type), allocatable :: more(:)
      integer :: n
      n = 0
      if (allocated(parts%holes)) n = size(parts%holes)
      allocate (more(n + 1))
      if (n > 0) then
         more(:n) = parts%holes
         more(n + 1)%md_top = more(n)%md_bottom
      end if
      associate (hole => more(n + 1))
         if (present(name)) hole%name = name
         if (present(md_bottom)) hole%md_bottom = md_bottom
         hole%diameter = diameter
         hole%friction_axial = friction
         hole%friction_rotary = friction
      end associate
      call move_alloc(more, parts%holes)
   end subroutine add_hole

   !> A component above those that the string has; the last one may leave out its length: it reaches to surface. Without `mass` it
   !> is a tube of steel.
   pure subroutine add_component(parts, kind, od, id, length, mass, joint_od, string)
      type(model_parts_type), intent(inout) :: parts
      character(*), intent(in) :: kind               !< drillpipe, collar, stabilizer, bit, ...: see input/README.md
      real(wp), intent(in) :: od, id                 !< of the body [m]
      real(wp), intent(in), optional :: length       !< [m]
      real(wp), intent(in), optional :: mass         !< in air, per length [kg/m]
      real(wp), intent(in), optional :: joint_od     !< of tool joints or blades [m]
      character(*), intent(in), optional :: string   !< name of the string; absent: the first, or 'main'
      type(component_type), allocatable :: more(:)
      integer :: i, n
      call find_string(parts, string, i)
      n = size(parts%strings(i)%components)
      allocate (more(n + 1))
      if (n > 0) more(:n) = parts%strings(i)%components
      associate (part => more(n + 1))
         part%kind = kind
         part%name = kind
         part%od = od
         part%id = id
         if (present(length)) part%length = length
         if (present(joint_od)) part%joint_od = joint_od
         part%mass = part%density*tube_area(od, id)
         if (present(mass)) part%mass = mass
      end associate
      call move_alloc(more, parts%strings(i)%components)
   end subroutine add_component

   !> A fluid below those that are there, inside and outside the string.
   pure subroutine add_fluid(parts, density, md_top)
      type(model_parts_type), intent(inout) :: parts
      real(wp), intent(in) :: density                !< [kg/m3]
      real(wp), intent(in), optional :: md_top       !< measured depth of its upper end [m]; absent: surface
      type(fluid_type) :: fluid
      fluid%density = density
      if (present(md_top)) fluid%md_top = md_top
      if (.not. allocated(parts%fluids)) allocate (parts%fluids(0))
      parts%fluids = [parts%fluids, fluid]
   end subroutine add_fluid

   !> Place of a string of that name, which is made where it is not there.
   pure subroutine find_string(parts, name, place)
      type(model_parts_type), intent(inout) :: parts
      character(*), intent(in), optional :: name
      integer, intent(out) :: place
      type(drillstring_type), allocatable :: more(:)
      integer :: n
      n = 0
      if (allocated(parts%strings)) n = size(parts%strings)
      do place = 1, n
         if (.not. present(name)) exit
         if (.not. allocated(parts%strings(place)%name)) cycle
         if (parts%strings(place)%name == name) exit
      end do
      if (place > n) then
         allocate (more(n + 1))
         if (n > 0) more(:n) = parts%strings
         more(n + 1)%name = 'main'
         if (present(name)) more(n + 1)%name = name
         call move_alloc(more, parts%strings)
      end if
      if (.not. allocated(parts%strings(place)%components)) allocate (parts%strings(place)%components(0))
   end subroutine find_string
end module dg_parts_by_call

!> Pipe of the program's catalogue by its diameters.
module dg_catalogue_pipe
   use dg_kinds, only: wp
   use dg_catalogue, only: catalogue_type, catalogue_within, numeric_keys, read_catalogue
   use dg_component, only: component_type
   use dg_error, only: error_list_type
   implicit none
   private
   public :: find_pipe

   !> Difference of diameters of one pipe [m]: inches and millimetres are rounded.
   real(wp), parameter :: alike = 0.3e-3_wp

contains

   !> Pipe of the catalogue with the od and id of a component: name and mass per length. Of several, the one with the nearest
   !> joint_od. The name is '' if the catalogue has none.
   subroutine find_pipe(part, name, mass)
      type(component_type), intent(in) :: part
      character(:), allocatable, intent(out) :: name
      real(wp), intent(out) :: mass      !< [kg/m]
      type(catalogue_type) :: catalogue
      type(error_list_type) :: faults
      real(wp) :: nearest
      integer :: od, id, joint_od, weight, i
      od = findloc(numeric_keys, 'od', dim=1)
      id = findloc(numeric_keys, 'id', dim=1)
      joint_od = findloc(numeric_keys, 'joint_od', dim=1)
      weight = findloc(numeric_keys, 'mass', dim=1)
      name = ''
      mass = 0.0_wp
      nearest = huge(nearest)
      call read_catalogue(catalogue_within, catalogue, faults)
      do i = 1, size(catalogue%entries)
         associate (entry => catalogue%entries(i))
            if (.not. all(entry%has([od, id, joint_od, weight]))) cycle
            if (abs(entry%numbers(od) - part%od) > alike .or. abs(entry%numbers(id) - part%id) > alike) cycle
            if (abs(entry%numbers(joint_od) - part%joint_od) >= nearest) cycle
            nearest = abs(entry%numbers(joint_od) - part%joint_od)
            name = entry%name
            mass = entry%numbers(weight)
         end associate
      end do
   end subroutine find_pipe
end module dg_catalogue_pipe

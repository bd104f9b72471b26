!> Pressures of the fluids inside and outside a string at rest, by depth.
!>
!> The pressure of a column of fluids is the sum of density times gravity times true vertical extent above a place. Air above
!> the first fluid has no pressure, as pressures count from that of the atmosphere. The pressure of the annulus at surface adds
!> to the column outside. Pump pressure adds to the column inside from the surface down to the first closed collar, else to the
!> bit. Losses along the string are neglected, so that the bit takes all of it. Below a closed collar the column begins anew.
module dg_fluid_pressure
   use dg_kinds, only: wp
   use dg_component, only: buoyed_weight, component_type, tube_area
   use dg_drillstring, only: component_tops, drillstring_type, topmost
   use dg_fluid, only: collar_none, collar_open_below, density_at, fluid_at, fluid_top, fluid_tops, side_inside, &
      side_outside
   use dg_load_case, only: load_case_type
   use dg_model, only: model_type, string_index
   use dg_trajectory, only: top_md, true_vertical_depth
   implicit none
   private
   public :: fluid_column_type, is_hung, needed_push, new_fluid_column, pressure_at, push_of, stretch_type, stretches_of, &
             surface_push, weight_at

   !> The fluids of one side in a load case, as pieces of one density from the top down.
   type :: fluid_column_type
      real(wp), allocatable :: md(:)         !< upper ends [m]
      real(wp), allocatable :: tvd(:)        !< of the upper ends, below the first station [m]
      real(wp), allocatable :: pressure(:)   !< at the upper ends [Pa]
      real(wp), allocatable :: gradient(:)   !< density times gravity [Pa/m]
   end type fluid_column_type

   !> A part of a string of one component, in one fluid on either side.
   type :: stretch_type
      integer :: component = 0     !< of the string
      real(wp) :: upper = 0.0_wp, lower = 0.0_wp   !< measured depths of its ends [m]
   end type stretch_type

contains

   !> Make the column of a side. If the lowest collar is open below, the part beneath it has the pressure of the annulus at the
   !> bit.
   pure subroutine new_fluid_column(model, load_case, side, column)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: side   !< side_inside or side_outside
      type(fluid_column_type), intent(out) :: column
      type(fluid_column_type) :: annulus
      real(wp) :: bit_tvd
      integer :: i, collar
      call stack_up(model, load_case, side, column)
      if (side == side_outside) return
      do i = size(column%md), 1, -1
         collar = collar_at(model, column%md(i), load_case%bit_depth)
         if (collar /= collar_none) exit
      end do
      if (collar /= collar_open_below) return
      call stack_up(model, load_case, side_outside, annulus)
      bit_tvd = true_vertical_depth(model%trajectory, load_case%bit_depth)
      column%pressure(i:) = column%pressure(i:) + pressure_at(annulus, load_case%bit_depth, bit_tvd) &
                            - pressure_at(column, load_case%bit_depth, bit_tvd)
   end subroutine new_fluid_column

   !> Stack the pieces of a side. Pressures are summed from the surface down, and anew below each collar.
   pure subroutine stack_up(model, load_case, side, column)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: side
      type(fluid_column_type), intent(out) :: column
      real(wp) :: pressure
      real(wp), allocatable :: tops(:)
      integer :: i
      allocate (tops, source=fluid_tops(model%mud, load_case%bit_depth))
      allocate (column%md(size(tops) + 1))
      column%md(1) = top_md(model%trajectory)
      column%md(2:) = tops
      allocate (column%tvd(size(column%md)), column%pressure(size(column%md)), column%gradient(size(column%md)))
      pressure = 0.0_wp
      if (side == side_inside) then
         pressure = load_case%pump_pressure
      else
         i = fluid_at(model%mud, side, column%md(1), load_case%bit_depth)
         pressure = load_case%annulus_pressure
         if (i > 0) pressure = pressure + model%mud%fluids(i)%surface_pressure
      end if
      do i = 1, size(column%md)
         column%tvd(i) = true_vertical_depth(model%trajectory, column%md(i))
         column%gradient(i) = density_in(model, load_case, side, column%md(i))*model%gravity
         if (i > 1) pressure = pressure + column%gradient(i - 1)*(column%tvd(i) - column%tvd(i - 1))
         if (side == side_inside .and. collar_at(model, column%md(i), load_case%bit_depth) /= collar_none) pressure = 0.0_wp
         column%pressure(i) = pressure
      end do
   end subroutine stack_up

   !> Buoyed weight per length of a component at a measured depth, in the fluids of a load case [N/m].
   pure function weight_at(component, model, load_case, md) result(weight)
      type(component_type), intent(in) :: component
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp), intent(in) :: md          !< [m]
      real(wp) :: weight
      weight = buoyed_weight(component, density_in(model, load_case, side_outside, md), &
                             density_in(model, load_case, side_inside, md), model%gravity)
   end function weight_at

   !> Parts of a string with its bit at a depth [m], component by component from the bit upwards. String above the first
   !> station is left out.
   pure function stretches_of(model, string, bit) result(stretches)
      type(model_type), intent(in) :: model
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit
      type(stretch_type), allocatable :: stretches(:)
      type(stretch_type) :: one
      real(wp), allocatable :: ends(:), breaks(:)      ! of components, from the bit upwards; of fluids, from the top down
      integer :: i, k
      allocate (stretches(0))
      allocate (ends, source=[bit, bit - component_tops(string, bit - top_md(model%trajectory))])
      allocate (breaks, source=[top_md(model%trajectory), fluid_tops(model%mud, bit), bit])
      do i = 1, size(ends) - 1
         do k = 1, size(breaks) - 1
            one = stretch_type(i, max(ends(i + 1), breaks(k)), min(ends(i), breaks(k + 1)))
            if (one%upper < one%lower) stretches = [stretches, one]
         end do
      end do
   end function stretches_of

   !> Density of the fluid of a side in a load case [kg/m3]. Where two fluids meet it is that of the lower one.
   pure function density_in(model, load_case, side, md) result(density)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: side         !< side_inside or side_outside
      real(wp), intent(in) :: md          !< [m]
      real(wp) :: density
      if (side == side_inside .and. load_case%inside_density%present) then
         density = load_case%inside_density%value
      else
         density = density_at(model%mud, side, md, load_case%bit_depth)
      end if
   end function density_in

   !> Collar at the upper end of a piece.
   pure function collar_at(model, md, bit_depth) result(collar)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: md, bit_depth   !< [m]
      integer :: collar
      integer :: i
      collar = collar_none
      if (.not. allocated(model%mud%fluids)) return
      do i = 1, size(model%mud%fluids)
         associate (fluid => model%mud%fluids(i))
            if (fluid%collar == collar_none .or. fluid%above_bit >= bit_depth) cycle
            if (abs(fluid_top(fluid, bit_depth) - md) <= 0.0_wp) collar = fluid%collar
         end associate
      end do
   end function collar_at

   !> Pressure above that of the atmosphere [Pa] at a place of the hole; never negative.
   pure function pressure_at(column, md, tvd) result(pressure)
      type(fluid_column_type), intent(in) :: column
      real(wp), intent(in) :: md    !< measured depth; where two fluids meet, the lower one counts [m]
      real(wp), intent(in) :: tvd   !< of the same place, below the first station [m]
      real(wp) :: pressure
      integer :: i
      do i = size(column%md), 2, -1
         if (column%md(i) <= md) exit
      end do
      pressure = max(column%pressure(i) + column%gradient(i)*(tvd - column%tvd(i)), 0.0_wp)
   end function pressure_at

   !> Force by which pressure of a closed annulus pushes pipe out at surface [N], of a load case of the model.
   pure function surface_push(model, case_index) result(push)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp) :: push
      push = push_of(model, model%cases(case_index))
   end function surface_push

   !> Force by which pressure of a closed annulus pushes pipe out at surface [N]: its area there times that pressure. Hook load
   !> is the effective tension less this. It is 0 for tubing in a packer, whose hanger holds it, and where the survey begins
   !> below surface.
   pure function push_of(model, load_case) result(push)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp) :: push
      type(component_type) :: top
      real(wp) :: pressure
      push = 0.0_wp
      if (top_md(model%trajectory) > 0.0_wp .or. model%boundary%packer_bore > 0.0_wp) return
      pressure = annulus_at_surface(model, load_case)
      if (.not. pressure > 0.0_wp) return
      top = top_component(model, load_case)
      push = pressure*tube_area(top%od, 0.0_wp)
   end function push_of

   !> Component of the string at surface, of a survey that begins there.
   pure function top_component(model, load_case) result(top)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      type(component_type) :: top
      associate (string => model%strings(string_index(model%strings, load_case%string)))
         top = string%components(topmost(component_tops(string, load_case%bit_depth)))
      end associate
   end function top_component

   !> Pressure of the annulus at surface [Pa].
   pure function annulus_at_surface(model, load_case) result(pressure)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      real(wp) :: pressure
      pressure = load_case%annulus_pressure
      ! only the uppermost fluid of the annulus may have a pressure
      if (allocated(model%mud%fluids)) pressure = pressure + maxval([0.0_wp, model%mud%fluids%surface_pressure])
   end function annulus_at_surface

   !> True for tubing in its hanger: it has a packer, and an earlier load case has set it.
   elemental function is_hung(model, load_case) result(hung)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: hung
      hung = model%boundary%packer_bore > 0.0_wp .and. load_case%length_reference > 0
   end function is_hung

   !> Load of tubing on its hanger less the hook load [N]: pressure inside pulls the steel, pressure outside pushes it. The tree
   !> and not the string closes the bore at surface. It is 0 for other strings.
   elemental function hanger_pull(model, case_index) result(pull)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp) :: pull
      type(component_type) :: top
      pull = 0.0_wp
      associate (load_case => model%cases(case_index))
         if (.not. is_hung(model, load_case)) return
         top = top_component(model, load_case)
         pull = load_case%pump_pressure*tube_area(top%id, 0.0_wp) &
                - annulus_at_surface(model, load_case)*tube_area(top%od, 0.0_wp)
      end associate
   end function hanger_pull

   !> Push at surface that a hook load needs [N], < 0 for a pull: minus the load of the hanger, where the string has one.
   elemental function needed_push(model, case_index, hookload) result(push)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: hookload     !< [N]
      real(wp) :: push
      push = -hookload - hanger_pull(model, case_index)
   end function needed_push
end module dg_fluid_pressure

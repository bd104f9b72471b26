!> What is worth saying of the fluids of a deck: a string that floats, and what must hold pressures apart at the bit.
module dg_fluid_notes
   use dg_kinds, only: wp
   use dg_component, only: buoyed_weight
   use dg_drillstring, only: component_at, component_tops
   use dg_fluid, only: density_at, fluid_tops, side_inside, side_outside
   use dg_fluid_pressure, only: fluid_column_type, new_fluid_column, pressure_at
   use dg_load_case, only: load_case_type
   use dg_model, only: model_type, string_index
   use dg_text, only: append_text, quoted, text_type
   use dg_trajectory, only: top_md, true_vertical_depth
   use dg_unit_kind, only: in_units, unit_length, unit_pressure
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: note_fluids

   !> Difference of pressures that is round-off of depths [Pa].
   real(wp), parameter :: no_pressure = 1.0e3_wp
   !> Just above a depth [m].
   real(wp), parameter :: hair = 1.0e-6_wp
   integer, parameter :: digits = 4

contains

   !> One note a matter, with the first load case where it is so.
   subroutine note_fluids(model, units, notes)
      type(model_type), intent(in) :: model
      type(unit_system_type), intent(in) :: units
      type(text_type), allocatable, intent(inout) :: notes(:)
      integer :: i
      logical :: held, floats
      if (.not. allocated(model%mud%fluids)) return
      held = model%boundary%packer_bore > 0.0_wp      ! its seal holds the difference
      floats = .false.
      do i = 1, size(model%cases)
         if (.not. held) call note_bit(i, held)
         if (.not. floats) call note_floating(i, floats)
      end do

   contains

      subroutine note_bit(number, said)
         integer, intent(in) :: number
         logical, intent(out) :: said
         type(fluid_column_type) :: inside, outside
         type(load_case_type) :: still   ! without pump pressure: a closed collar keeps it from the bit
         real(wp) :: within, around, tvd
         still = model%cases(number)
         still%pump_pressure = 0.0_wp
         associate (case => still)
            tvd = true_vertical_depth(model%trajectory, case%bit_depth)
            call new_fluid_column(model, case, side_inside, inside)
            call new_fluid_column(model, case, side_outside, outside)
            within = pressure_at(inside, case%bit_depth, tvd)
            around = pressure_at(outside, case%bit_depth, tvd)
            said = abs(within - around) > no_pressure
            if (said) call append_text(notes, 'group &fluid: load case '//quoted(case%name)// &
               ': without pump pressure the fluid inside presses on the bit with '//pressed(within)//', that outside with '// &
               pressed(around)//'; a float valve or plug at the end of the string is taken to hold the difference')
         end associate
      end subroutine note_bit

      subroutine note_floating(number, said)
         integer, intent(in) :: number
         logical, intent(out) :: said
         real(wp), allocatable :: tops(:), depths(:)
         real(wp) :: bit, md
         integer :: k
         said = .false.
         bit = model%cases(number)%bit_depth
         associate (string => model%strings(string_index(model%strings, model%cases(number)%string)))
            allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
            allocate (depths, source=[bit, bit - tops, fluid_tops(model%mud, bit)])
            do k = 1, size(depths)
               md = depths(k) - hair        ! every piece of one weight ends at one of these depths
               if (md <= top_md(model%trajectory)) cycle
               associate (part => string%components(component_at(tops, bit - md)))
                  said = buoyed_weight(part, density_at(model%mud, side_outside, md, bit), &
                                       density_at(model%mud, side_inside, md, bit), model%gravity) < 0.0_wp
                  if (said) call append_text(notes, 'group &fluid: load case '//quoted(model%cases(number)%name)//': '// &
                     quoted(part%name)//' floats at '//trim(in_units(units, unit_length, depths(k), digits))// &
                     ': with what is in it it weighs less than the fluid outside that it displaces')
               end associate
               if (said) return
            end do
         end associate
      end subroutine note_floating

      function pressed(pressure) result(text)
         real(wp), intent(in) :: pressure
         character(:), allocatable :: text
         text = trim(in_units(units, unit_pressure, pressure, digits))
      end function pressed
   end subroutine note_fluids
end module dg_fluid_notes

!> Change of the length of a string, in the four parts of Lubinski, Althouse & Logan (1962), Helical buckling of tubing sealed
!> in packers, J. Pet. Technol. 14(6), SPE-178-PA. The reference is the string without load, without pressure and before
!> temperature changes. Longer is positive. The parts are integrals over the string of:
!> - force: F_a/(E A), Hooke's law, with the true axial force F_a = T - p_o A_o + p_i A_i, tension > 0
!> - pressure: -2 nu (p_i A_i - p_o A_o)/(E A), ballooning
!> - buckling: -y'^2/2, for a slope y' of the string against the hole axis
!> - temperature: alpha dt, with dt linear in true vertical depth
!>
!>   force         F_a/(E A)                  Hooke's law; F_a = T - p_o A_o + p_i A_i is the true axial force, tension > 0
!>   pressure      -2 nu (p_i A_i - p_o A_o)/(E A)   ballooning
!>   buckling      -y'^2/2                    the string leans against the hole axis by y'
!>   temperature   alpha dt                   dt linear in true vertical depth
!>
!> The slope y' of mcge is that of its own string on short elements, so that sag between contacts counts too. For other
!> methods, and for mcge without short elements, it follows from the compression F and the clearance c. Above the lower helical
!> limit y'^2/2 = c^2 F/(4 EI) (a helix of the pitch 2 pi (2 EI/F)^(1/2)). Between it and the sinusoidal limit F_s,
!> dg_sinusoidal_shape gives y'^2/2 = c^2 A^2 k^2 F_s/(8 EI).
module dg_length_change
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_component, only: axial_stiffness, bending_stiffness, component_type, contact_diameter, find_bowing, room_of, tube_area
   use dg_drillstring, only: component_at, component_tops
   use dg_helical_load, only: coil_clearance
   use dg_load_case, only: load_case_type
   use dg_missing, only: is_missing
   use dg_model, only: model_type, string_index
   use dg_numerics, only: smears_all_joints
   use dg_pipe_stress, only: true_axial
   use dg_profile, only: between_ends
   use dg_sinusoidal_shape, only: sinusoidal_swing, sinusoidal_wave
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: length_change_type, find_length_change, asks_for_length, total_change, less

   !> Parts of a change of length, longer > 0 [m].
   type :: length_change_type
      logical :: present = .false.       !< the deck asks for it
      real(wp) :: force = 0.0_wp         !< of the true axial force, by Hooke's law
      real(wp) :: pressure = 0.0_wp      !< of ballooning
      real(wp) :: buckling = 0.0_wp      !< of the buckled shape, <= 0
      real(wp) :: temperature = 0.0_wp   !< of the change of temperature
   end type length_change_type

contains

   !> True if a deck asks for the change of length in a load case. It does so by a packer, a pressure of the annulus or a
   !> change of temperature. It also does so if another case refers to one.
   pure function asks_for_length(model, load_case) result(asks)
      type(model_type), intent(in) :: model
      type(load_case_type), intent(in) :: load_case
      logical :: asks
      asks = model%boundary%packer_bore > 0.0_wp .or. abs(load_case%temperature_change_top) > 0.0_wp .or. &
             abs(load_case%temperature_change_bottom) > 0.0_wp .or. any(model%cases%length_reference > 0) .or. &
             load_case%annulus_pressure > 0.0_wp
      if (allocated(model%mud%fluids)) asks = asks .or. any(model%mud%fluids%surface_pressure > 0.0_wp)
   end function asks_for_length

   !> Compute all parts, for the whole string. Trapezoids between rows; no component ends between two rows.
   pure subroutine find_length_change(model, result, along, change)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      type(along_string_type), intent(in) :: along
      type(length_change_type), intent(out) :: change
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, length, outside, inside, axial
      integer :: i, number
      logical :: bows
      bows = .not. smears_all_joints(model%numerics)
      change%present = .true.
      associate (profile => result%profile, load_case => model%cases(result%case_index), &
                 string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         bit = load_case%bit_depth
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         do i = 2, size(profile%md)
            length = profile%md(i) - profile%md(i - 1)
            number = component_at(tops, bit - 0.5_wp*(profile%md(i - 1) + profile%md(i)))
            associate (part => string%components(number))
               outside = 0.5_wp*(along%pressure(i - 1) + along%pressure(i))
               inside = 0.5_wp*(along%inside_pressure(i - 1) + along%inside_pressure(i))
               axial = true_axial(0.5_wp*(profile%axial(i - 1) + profile%axial(i)), part%od, part%id, outside, inside)
               change%force = change%force + length*axial/axial_stiffness(part)
               change%pressure = change%pressure - length*2.0_wp*part%poisson/axial_stiffness(part)* &
                  (inside*tube_area(part%id, 0.0_wp) - outside*tube_area(part%od, 0.0_wp))
               change%temperature = change%temperature + 0.5_wp*length*part%expansion*(warmer(i - 1) + warmer(i))
               if (is_missing(result%shortening)) change%buckling = change%buckling - 0.5_wp*length* &
                  (lean(part, bit - tops(number), bows, along, i - 1, profile%axial(i - 1)) + &
                   lean(part, bit - tops(number), bows, along, i, profile%axial(i)))
            end associate
         end do
      end associate
      if (.not. is_missing(result%shortening)) change%buckling = -result%shortening
   contains
      !> Change of temperature at a row [K].
      pure function warmer(row) result(change_there)
         integer, intent(in) :: row
         real(wp) :: change_there
         associate (load_case => model%cases(result%case_index))
            change_there = between_ends(result%profile, row, load_case%temperature_change_top, &
                                        load_case%temperature_change_bottom)
         end associate
      end function warmer
   end subroutine find_length_change

   !> Shortening per length, y'^2/2 [-], at a row, for the published shapes.
   pure function lean(part, upper_end, bows, along, row, axial) result(short)
      type(component_type), intent(in) :: part
      real(wp), intent(in) :: upper_end   !< measured depth of the component's upper end [m]
      logical, intent(in) :: bows         !< pipe bows out between its joints
      type(along_string_type), intent(in) :: along
      integer, intent(in) :: row
      real(wp), intent(in) :: axial       !< effective, tension > 0 [N]
      real(wp) :: short
      real(wp) :: clearance, swing, height, euler
      short = 0.0_wp
      if (axial >= 0.0_wp) return
      clearance = room_of(0.5_wp*(along%hole_diameter(row) - contact_diameter(part, upper_end)))
      if (is_missing(along%helical(row)) .or. -axial > along%helical(row)) then
         if (bows) then
            call find_bowing(part, upper_end, height, euler)
            clearance = coil_clearance(clearance, height, euler, -axial)
         end if
         short = -clearance**2*axial/(4.0_wp*bending_stiffness(part))
      else if (-axial > along%sinusoidal(row)) then
         swing = sinusoidal_swing(-axial/along%sinusoidal(row))
         short = (clearance*swing*sinusoidal_wave(swing))**2*along%sinusoidal(row)/(8.0_wp*bending_stiffness(part))
      end if
   end function lean

   !> Sum of the parts [m].
   elemental function total_change(change) result(length)
      type(length_change_type), intent(in) :: change
      real(wp) :: length
      length = change%force + change%pressure + change%buckling + change%temperature
   end function total_change

   !> Change of length from a reference state to another.
   elemental function less(change, reference) result(difference)
      type(length_change_type), intent(in) :: change, reference
      type(length_change_type) :: difference
      difference = length_change_type(change%present .and. reference%present, change%force - reference%force, &
                                      change%pressure - reference%pressure, change%buckling - reference%buckling, &
                                      change%temperature - reference%temperature)
   end function less
end module dg_length_change

!> The columns along the string: what each is and where its values are. New ones are added at the end only: others
!> rely on the names and on the order of the first thirteen.
module dg_profile_columns
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_named_states, only: buckling_name
   use dg_column, only: column_type, quantity_angle, quantity_curvature, quantity_force, quantity_length, quantity_line_load, &
                        quantity_moment, quantity_none, quantity_percent, quantity_pressure, quantity_stress, &
                        quantity_text, quantity_width
   use dg_missing, only: is_missing, missing
   use dg_profile, only: profile_type, side_name, state_name
   implicit none
   private
   public :: profile_columns, profile_values, profile_codes, code_names

   type(column_type), parameter :: profile_columns(39) = [ &
      column_type('md', quantity_length, 'measured depth, of the point before loading'), &
      column_type('tvd', quantity_length, 'true vertical depth of the hole axis, from the first station'), &
      column_type('north', quantity_length, 'of the hole axis, from the first station'), &
      column_type('east', quantity_length, 'of the hole axis, from the first station'), &
      column_type('inclination', quantity_angle, 'of the hole axis'), &
      column_type('azimuth', quantity_angle, 'of the hole axis, from north; 0 where vertical'), &
      column_type('axial', quantity_force, 'effective axial force, tension positive'), &
      column_type('torque', quantity_moment, 'positive as a right-hand drive from the top makes it'), &
      column_type('side_force', quantity_line_load, 'normal contact force per length'), &
      column_type('bending', quantity_moment, 'resultant bending moment of both planes, the hole''s own curvature '// &
         'included; soft: what the hole''s curvature would ask of the pipe'), &
      column_type('displacement', quantity_width, 'of the string axis off the hole axis'), &
      column_type('clock', quantity_angle, 'where the string lies: degrees from the high side (from north where the hole '// &
         'is vertical), clockwise looking down the hole'), &
      column_type('gap_state', quantity_text, 'free, elastic or rigid: the hardest of the adjoining elements'), &
      column_type('true_axial', quantity_force, 'axial force in the wall of the pipe: effective - (p_o A_o - p_i A_i)'), &
      column_type('shear', quantity_force, 'resultant shear force; empty for soft, which has none'), &
      column_type('axial_stress', quantity_stress, 'of the true axial force, in the body of the pipe'), &
      column_type('bending_stress', quantity_stress, 'amplitude at the outer surface'), &
      column_type('torsional_stress', quantity_stress, 'shear stress at the outer surface'), &
      column_type('hoop_stress', quantity_stress, 'at the inner surface (Lame)'), &
      column_type('von_mises', quantity_stress, 'equivalent stress, largest in the section'), &
      column_type('safety_factor', quantity_none, 'yield over von_mises; empty where no yield is given'), &
      column_type('envelope_margin', quantity_none, 'part of the tension-torque envelope left, bending included: '// &
         '1 - von_mises/yield; empty where no yield is given'), &
      column_type('bending_range', quantity_stress, 'of the bending stress in one turn of the string, for fatigue; '// &
         '0 where the string does not turn'), &
      column_type('sinusoidal_load', quantity_force, 'compression at which the string buckles into a sine; in a drop '// &
         'that of the side on which it lies; empty where neither weight nor curvature gives a limit'), &
      column_type('helical_load', quantity_force, 'compression at which it coils, lower published limit'), &
      column_type('helical_load_upper', quantity_force, 'the same, upper limit'), &
      column_type('buckling_margin', quantity_force, 'sinusoidal_load + axial: compression left before buckling'), &
      column_type('buckling', quantity_text, 'none, sinusoidal or helical (beyond the lower limit), by the loads above'), &
      column_type('pressure', quantity_pressure, 'of the fluid outside'), &
      column_type('dogleg', quantity_curvature, 'curvature of the hole; where two bends meet the sharper one'), &
      column_type('od', quantity_width, 'outside diameter of the body'), &
      column_type('hole', quantity_width, 'diameter of the hole'), &
      column_type('joint_magnification', quantity_none, 'largest bending between tool joints that touch alone, over the '// &
         'column bending; 1 where joints were solved one by one; empty without joints, and in compression beyond the '// &
         'closed form'), &
      column_type('jointed_bending_stress', quantity_stress, 'joint_magnification times bending_stress, in the body of the '// &
         'pipe'), &
      column_type('joint_von_mises', quantity_stress, 'equivalent stress in a tool joint, if one stands here; empty '// &
         'without joints'), &
      column_type('joint_side_force', quantity_force, 'contact force of a tool joint: side_force times the distance of joints; '// &
         'of joints solved one by one that of the joint that stands here, 0 between; empty without joints'), &
      column_type('standoff', quantity_percent, 'least distance of the body from the wall, over that of a centred one: 100 '// &
         'where it is centred, 0 where it touches; of mcge alone'), &
      column_type('inside_pressure', quantity_pressure, 'of the fluid inside, pump pressure included'), &
      column_type('side', quantity_text, 'above or below where a component, hole section or fluid changes: that depth has '// &
         'a row for each side; else empty')]

contains

   !> Values of the column of that name, in SI units, `missing` where there is none.
   pure subroutine profile_values(name, profile, along, values)
      character(*), intent(in) :: name
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      real(wp), intent(out) :: values(:)
      values = missing
      select case (name)
      case ('md'); values = profile%md
      case ('tvd'); values = profile%tvd
      case ('north'); values = profile%north
      case ('east'); values = profile%east
      case ('inclination'); values = profile%inclination
      case ('azimuth'); values = profile%azimuth
      case ('axial'); values = profile%axial
      case ('torque'); values = profile%torque
      case ('side_force'); values = profile%side_force
      case ('bending'); values = profile%bending
      case ('displacement'); values = profile%displacement
      case ('clock'); values = profile%clock
      case ('true_axial'); values = along%true_axial
      case ('shear'); values = profile%shear
      case ('axial_stress'); values = along%axial_stress
      case ('bending_stress'); values = along%bending_stress
      case ('torsional_stress'); values = along%torsional_stress
      case ('hoop_stress'); values = along%hoop_stress
      case ('von_mises'); values = along%von_mises
      case ('safety_factor'); values = along%safety_factor
      case ('envelope_margin'); values = along%envelope_margin
      case ('bending_range'); values = along%bending_range
      case ('sinusoidal_load'); values = along%sinusoidal
      case ('helical_load'); values = along%helical
      case ('helical_load_upper'); values = along%helical_upper
      case ('buckling_margin'); values = along%buckling_margin
      case ('pressure'); values = along%pressure
      case ('dogleg'); values = along%curvature
      case ('od'); values = along%od
      case ('hole'); values = along%hole_diameter
      case ('joint_magnification'); values = along%magnification
      case ('jointed_bending_stress'); values = along%jointed_bending
      case ('joint_von_mises'); values = along%joint_von_mises
      case ('joint_side_force'); values = along%joint_side_force
      case ('standoff')
         where (.not. is_missing(along%standoff)) values = 100.0_wp*along%standoff
      case ('inside_pressure'); values = along%inside_pressure
      case default
      end select
   end subroutine profile_values

   !> Numbers, from 0, that stand for the texts of a column of texts.
   pure subroutine profile_codes(name, profile, along, codes)
      character(*), intent(in) :: name
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      integer, intent(out) :: codes(:)
      codes = 0
      select case (name)
      case ('gap_state'); codes = profile%gap_state
      case ('buckling'); codes = along%buckling
      case ('side'); codes = profile%side
      case default
      end select
   end subroutine profile_codes

   !> The texts of a column of texts, by number from 0.
   pure function code_names(name) result(names)
      character(*), intent(in) :: name
      character(10) :: names(0:2)
      names = ''
      select case (name)
      case ('gap_state'); names = state_name
      case ('buckling'); names = buckling_name
      case ('side'); names = side_name
      case default
      end select
   end function code_names
end module dg_profile_columns

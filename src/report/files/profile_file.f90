!> profile_<case>_<model>.csv: results along the string, surface to bit.
module dg_profile_file
   use dg_along_string, only: along_string_type
   use dg_column, only: quantity_angle, quantity_curvature, quantity_force, quantity_length, quantity_line_load, &
                        quantity_moment, quantity_none, quantity_percent, quantity_pressure, quantity_stress, quantity_text, &
                        quantity_width
   use dg_comparison, only: percent_of
   use dg_named_states, only: buckling_name
   use dg_profile, only: profile_type, side_name, state_name
   use dg_series, only: add, series_list_type
   implicit none
   private
   public :: profile_series

contains

   !> The columns along the string. New columns are put at the end only: others rely on the names and on the order of the first
   !> thirteen.
   pure function profile_series(profile, along) result(list)
      type(profile_type), intent(in) :: profile
      type(along_string_type), intent(in) :: along
      type(series_list_type) :: list
      call add(list, 'md', quantity_length, 'measured depth of the point before loading', profile%md)
      call add(list, 'tvd', quantity_length, 'true vertical depth of the hole axis below the first station', profile%tvd)
      call add(list, 'north', quantity_length, 'of the hole axis, from the first station', profile%north)
      call add(list, 'east', quantity_length, 'of the hole axis, from the first station', profile%east)
      call add(list, 'inclination', quantity_angle, 'inclination of the hole axis', profile%inclination)
      call add(list, 'azimuth', quantity_angle, 'azimuth of the hole axis; 0 in a vertical hole', profile%azimuth)
      call add(list, 'axial', quantity_force, 'effective axial force, tension positive', profile%axial)
      call add(list, 'torque', quantity_moment, 'torque; positive for right-hand rotation from the top', profile%torque)
      call add(list, 'side_force', quantity_line_load, &
               'normal contact force per length; the area over a blade is its contact force', profile%side_force)
      call add(list, 'bending', quantity_moment, &
               'resultant bending moment of both planes, curvature of the hole included; soft: EI times the curvature of the '// &
               'hole', profile%bending)
      call add(list, 'displacement', quantity_width, 'distance of the string axis from the hole axis', profile%displacement)
      call add(list, 'clock', quantity_angle, &
               'where the string lies: degrees from the high side (from north where the hole is vertical), clockwise '// &
               'looking down the hole', profile%clock)
      call add(list, 'gap_state', quantity_text, &
               'free, elastic or rigid: the hardest of the adjoining elements; where a depth has two rows, that of its side', &
               profile%gap_state, state_name)
      call add(list, 'true_axial', quantity_force, &
               'axial force in the wall of the pipe: effective - (p_o A_o - p_i A_i)', along%true_axial)
      call add(list, 'shear', quantity_force, 'resultant shear force; empty for soft', profile%shear)
      call add(list, 'axial_stress', quantity_stress, 'stress of the true axial force in the body of the pipe', along%axial_stress)
      call add(list, 'bending_stress', quantity_stress, &
               'amplitude of the bending stress at the outer surface', along%bending_stress)
      call add(list, 'torsional_stress', quantity_stress, 'shear stress at the outer surface', along%torsional_stress)
      call add(list, 'hoop_stress', quantity_stress, 'hoop stress at the inner surface (Lame)', along%hoop_stress)
      call add(list, 'von_mises', quantity_stress, 'largest von Mises stress in the section', along%von_mises)
      call add(list, 'safety_factor', quantity_none, &
               'yield divided by von_mises; empty where no yield is given', along%safety_factor)
      call add(list, 'envelope_margin', quantity_none, &
               'part of the tension-torque envelope left, bending included: 1 - von_mises/yield; empty where no yield is '// &
               'given', along%envelope_margin)
      call add(list, 'bending_range', quantity_stress, &
               'range of the bending stress in one turn of the string, for fatigue; 0 without rotation', &
               along%bending_range)
      call add(list, 'sinusoidal_load', quantity_force, &
               'compression at which sinusoidal buckling begins; in a drop section for the side on which the string lies; '// &
               'empty if neither weight nor curvature gives a limit', along%sinusoidal)
      call add(list, 'helical_load', quantity_force, &
               'compression at which helical buckling begins, lower published limit', along%helical)
      call add(list, 'helical_load_upper', quantity_force, 'compression at which helical buckling begins, upper published '// &
               'limit', along%helical_upper)
      call add(list, 'buckling_margin', quantity_force, &
               'sinusoidal_load + axial: compression left before buckling', along%buckling_margin)
      call add(list, 'buckling', quantity_text, &
               'none, sinusoidal or helical (beyond the lower limit), by the loads above', along%buckling, buckling_name)
      call add(list, 'pressure', quantity_pressure, 'pressure of the fluid outside', along%pressure)
      call add(list, 'dogleg', quantity_curvature, &
               'dogleg severity of the hole; where two bends meet the larger one', along%curvature)
      call add(list, 'od', quantity_width, 'outside diameter of the body', along%od)
      call add(list, 'hole', quantity_width, 'diameter of the hole', along%hole_diameter)
      call add(list, 'joint_magnification', quantity_none, &
               'largest bending between tool joints, if only joints touch, divided by the column bending; 1 with discrete '// &
               'joints; empty without joints, and in compression beyond the closed form', along%magnification)
      call add(list, 'jointed_bending_stress', quantity_stress, &
               'largest bending stress of the body next to tool joints or between them, its contact with the wall included; '// &
               'empty as joint_magnification', along%jointed_bending)
      call add(list, 'joint_von_mises', quantity_stress, &
               'von Mises stress in a tool joint at this depth; empty without joints', along%joint_von_mises)
      call add(list, 'joint_side_force', quantity_force, &
               'contact force of a tool joint, if one stands here: of joint_spacing of its component; of joints solved one '// &
               'by one that of the joint that stands here, 0 between; empty without joints', along%joint_side_force)
      call add(list, 'standoff', quantity_percent, &
               'least distance of the body from the wall: 100 centred, 0 touching; mcge only', percent_of(along%standoff))
      call add(list, 'inside_pressure', quantity_pressure, &
               'pressure of the fluid inside, pump pressure included', along%inside_pressure)
      call add(list, 'side', quantity_text, &
               'above or below, at a change of component, hole section or fluid, where a depth has two rows; else empty', &
               profile%side, side_name)
   end function profile_series
end module dg_profile_file

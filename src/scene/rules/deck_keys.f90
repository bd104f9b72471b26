!> The tables of all groups and keys of a deck that tell of the scene: one place for checking, conversion and documentation. Those
!> of a study stand in its room.
!> Ranges keep out what cannot be meant (a diameter in metres, a modulus in pascal), not what is unusual.
module dg_deck_keys
   use dg_kinds, only: wp
   use dg_component, only: shortest_contact
   use dg_deck_schema, only: add_group, group_keys_type, group_rule_type, &
      key_rule_type, kind_text, kind_integer, kind_logical, rule_place
   use dg_load_case, only: operation_name
   use dg_quantity, only: deck_systems
   use dg_text, only: joined
   use dg_unit_kind, only: unit_length, unit_diameter, unit_angle, unit_mass, unit_density, unit_force, unit_moment, &
      unit_modulus, unit_pressure, unit_stress, unit_wall, unit_rotation, unit_speed, unit_gravity, &
      unit_temperature, unit_expansion, unit_wear, unit_curvature, unit_loss
   implicit none
   private
   public :: scene_groups, keys_of, key_place, operation_words
   public :: deepest, strongest, roughest, heaviest, stiffest, round_off

   type(group_rule_type), parameter :: group_rules(*) = [ &
      group_rule_type('job', meaning='models, units and folder of results'), &
      group_rule_type('trajectory', required=.true., meaning='survey of the hole'), &
      group_rule_type('tortuosity', repeatable=.true., meaning='small doglegs that a plan does not show, added to the path'), &
      group_rule_type('hole', repeatable=.true., required=.true., meaning='a section of the hole: diameter, friction, wall'), &
      group_rule_type('fluid', repeatable=.true., most=1000, &
         meaning='a fluid inside or outside the string, or both; listed from the top down'), &
      group_rule_type('rig', meaning='block, lines and limits of the rig'), &
      group_rule_type('component', repeatable=.true., required=.true., &
         meaning='a part of a drillstring; listed from the bit upwards'), &
      group_rule_type('strength', meaning='design factors, slips'), &
      group_rule_type('centralizer', repeatable=.true., &
         meaning='centralizers on a component'), &
      group_rule_type('boundary', meaning='supports of the ends of the string'), &
      group_rule_type('load_case', repeatable=.true., required=.true., &
         meaning='one operation at one bit depth, with its loads'), &
      group_rule_type('solver', meaning='settings of the method')]

   ! Bounds [deck units of SI].
   real(wp), parameter :: deepest = 50.0e3_wp     ! m; the deepest holes reach 15 km
   real(wp), parameter :: widest = 5.0e3_wp       ! mm
   real(wp), parameter :: narrowest = 1.0_wp      ! mm; less is a diameter in metres
   real(wp), parameter :: strongest = 1.0e5_wp    ! kN and kN.m; more is a load in newton
   real(wp), parameter :: roughest = 2.0_wp       ! friction coefficient; more is per cent
   real(wp), parameter :: heaviest = 25.0e3_wp    ! kg/m3; above tungsten
   real(wp), parameter :: highest_pump = 500.0_wp ! MPa; pumps reach 100, more is bar or psi
   real(wp), parameter :: hottest = 500.0_wp      ! K; wells reach 400
   real(wp), parameter :: stiffest = 1.0e12_wp    ! kN/m2; walls stiffer than 1e10 count as that
   real(wp), parameter :: touching = 1.0_wp       ! kN; what a gap of light pipe carries
   real(wp), parameter :: least_step = 0.1_wp     ! clearances; GP1 takes 12 iterations with it, 150 with a tenth
   real(wp), parameter :: round_off = 1.0e-14_wp  ! residuals cannot be smaller
   real(wp), parameter :: most_lines = 40.0_wp    ! rigs have 6 to 16
   real(wp), parameter :: poorest = 0.5_wp        ! efficiency of a sheave; less is per cent lost
   real(wp), parameter :: sharpest_bend = 5.0_wp  ! deg; beyond this slopes are no longer small
   real(wp), parameter :: most_wear = 1.0e4_wp    ! 1e-14/Pa; tests have 0.1 to 1000
   real(wp), parameter :: most_eccentric = 100.0_wp   ! mm
   real(wp), parameter :: hardest_pad = 500.0_wp  ! kN; pads press with 5 to 50
   real(wp), parameter :: most_efficient = 10.0_wp   ! connection over body; more is per cent
   real(wp), parameter :: sharpest_dogleg = 1.0e3_wp ! deg/30 m; connections take 10 to 70
   real(wp), parameter :: thinnest = 0.1_wp       ! part of the wall that wear leaves; less is no pipe any more
   real(wp), parameter :: most_tortuous = 10.0_wp ! deg; plans have 0.2 to 2, and 10 is no plan any more
   real(wp), parameter :: most_threads = 1024.0_wp
   real(wp), parameter :: most_iterations = 1.0e6_wp
   real(wp), parameter :: most_steps = 1.0e4_wp

   type(key_rule_type), parameter :: job_keys(*) = [ &
      key_rule_type('job', 'title', kind_text, meaning='printed above tables'), &
      key_rule_type('job', 'units', kind_text, default='SI', choices=deck_systems, meaning='unit system of deck and results'), &
      key_rule_type('job', 'models', kind_text, array=.true., default='mcge', choices='mcge soft rigid mixed', &
         meaning='models to run, compared below this table'), &
      key_rule_type('job', 'output_dir', kind_text, meaning='folder of results; default output/<deck name>'), &
      key_rule_type('job', 'gravity', unit=unit_gravity, default='9.80665', low=0.0_wp, high=100.0_wp, &
         meaning='acceleration of gravity'), &
      key_rule_type('job', 'hdf5', kind_logical, default='.true.', meaning='write results.h5'), &
      key_rule_type('job', 'plots', kind_logical, default='.true.', meaning='pictures, report.html and files for ParaView'), &
      key_rule_type('job', 'catalogue_file', kind_text, &
         meaning='catalogue of pipe, path relative to the deck; default: catalogue.csv beside the deck'), &
      key_rule_type('job', 'profiles', kind_logical, default='.true.', meaning='write profiles along the string'), &
      key_rule_type('job', 'rig_limit', unit=unit_force, low=0.0_wp, open=.true., high=strongest, &
         meaning='largest hook load of the rig, block included; default: not known'), &
      key_rule_type('job', 'threads', kind_integer, default='0', low=0.0_wp, high=most_threads, &
         meaning='number of cases solved at the same time; 0: all cores')]

   type(key_rule_type), parameter :: trajectory_keys(*) = [ &
      key_rule_type('trajectory', 'survey_file', kind_text, &
         meaning='survey table with columns md, inc, azi; path relative to the deck'), &
      key_rule_type('trajectory', 'survey_units', kind_text, choices=deck_systems, &
         meaning='units of a survey file without units; default those of the deck'), &
      key_rule_type('trajectory', 'md_column', kind_text, &
         meaning='heading of the measured depth in survey_file, as it stands there; default: found by known headings'), &
      key_rule_type('trajectory', 'inc_column', kind_text, meaning='heading of the inclination in survey_file; default: found '// &
      'by known headings'), &
      key_rule_type('trajectory', 'azi_column', kind_text, meaning='heading of the azimuth in survey_file; default: found by '// &
      'known headings'), &
      key_rule_type('trajectory', 'survey_well', kind_text, &
         meaning='name of the trajectory, well or wellbore to read from a WITSML survey_file'), &
      key_rule_type('trajectory', 'md', unit=unit_length, array=.true., low=0.0_wp, high=deepest, &
         meaning='measured depths of the stations'), &
      key_rule_type('trajectory', 'inc', unit=unit_angle, array=.true., low=0.0_wp, high=180.0_wp, &
         meaning='inclinations at the stations'), &
      key_rule_type('trajectory', 'azi', unit=unit_angle, array=.true., low=-360.0_wp, high=720.0_wp, &
         meaning='azimuths at the stations; may be left out where the whole hole is vertical'), &
      key_rule_type('trajectory', 'interpolation', kind_text, default='minimum_curvature', choices='minimum_curvature spline', &
         meaning='path between stations; a spline needs a station about every 30 m where the hole bends'), &
      key_rule_type('trajectory', 'tie_on', kind_text, default='none', choices='none vertical straight', &
         meaning='path above a first station that lies below surface; straight: in the direction of that station'), &
      key_rule_type('trajectory', 'parent_file', kind_text, &
         meaning='sidetrack: survey file of the parent hole; its stations above the first one here are used'), &
      key_rule_type('trajectory', 'kick_off', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='tie_on vertical: end of the vertical part; an arc leads from there to the first station')]

   type(key_rule_type), parameter :: tortuosity_keys(*) = [ &
      key_rule_type('tortuosity', 'kind', kind_text, required=.true., choices='sine random', &
         meaning='sine: a wave; random: a new direction each period'), &
      key_rule_type('tortuosity', 'amplitude', unit=unit_angle, required=.true., low=0.0_wp, open=.true., high=most_tortuous, &
         meaning='largest change of an angle'), &
      key_rule_type('tortuosity', 'period', unit=unit_length, required=.true., low=1.0_wp, high=deepest, &
         meaning='length of a wave; random: distance between changes'), &
      key_rule_type('tortuosity', 'md_top', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='measured depth of the upper end'), &
      key_rule_type('tortuosity', 'md_bottom', unit=unit_length, low=0.0_wp, open=.true., high=deepest, &
         meaning='measured depth of the lower end; default the last station'), &
      key_rule_type('tortuosity', 'seed', kind_integer, default='1', low=0.0_wp, high=1.0e9_wp, &
         meaning='start of the random numbers: the same seed gives the same hole')]

   type(key_rule_type), parameter :: hole_keys(*) = [ &
      key_rule_type('hole', 'name', kind_text, meaning='label; default hole and its number'), &
      key_rule_type('hole', 'md_top', unit=unit_length, low=0.0_wp, high=deepest, &
         meaning='upper end; default the lower end of the section before'), &
      key_rule_type('hole', 'md_bottom', unit=unit_length, low=0.0_wp, high=deepest, open=.true., &
         meaning='lower end; default the upper end of the next section, for the last one the last station'), &
      key_rule_type('hole', 'diameter', unit=unit_diameter, required=.true., low=narrowest, high=widest, &
         meaning='inside diameter'), &
      key_rule_type('hole', 'friction', low=0.0_wp, high=roughest, default='0', &
         meaning='friction factor, axial and rotary; often 0.15 to 0.25 in casing, 0.2 to 0.4 in open hole'), &
      key_rule_type('hole', 'friction_axial', low=0.0_wp, high=roughest, meaning='friction factor along the hole; default '// &
      'friction'), &
      key_rule_type('hole', 'friction_rotary', low=0.0_wp, high=roughest, meaning='friction factor around the hole; default '// &
      'friction'), &
      key_rule_type('hole', 'friction_running_in', low=0.0_wp, high=roughest, &
         meaning='friction factor along the hole for trip_in only; default friction_axial'), &
      key_rule_type('hole', 'wall_stiffness', unit=unit_wall, low=0.0_wp, high=stiffest, default='0', &
         meaning='contact force per length and penetration; 0: gk_contact of &solver'), &
      key_rule_type('hole', 'mud_sheath', unit=unit_diameter, low=0.0_wp, high=widest, default='0', &
         meaning='thickness t of soft mud on the wall; sets eps_nmax = 2 t/(hole diameter - string diameter)'), &
      key_rule_type('hole', 'cased', kind_logical, default='.false.', &
         meaning='cased section: drawn with walls; uses frictions_cased of a sweep'), &
      key_rule_type('hole', 'casing_od', unit=unit_diameter, low=narrowest, high=widest, &
         meaning='outside diameter of the casing, for its wear; needed with wear_factor'), &
      key_rule_type('hole', 'casing_yield', unit=unit_stress, low=0.0_wp, open=.true., high=1.0e5_wp, &
         meaning='yield strength of the casing, for burst and collapse of the worn casing'), &
      key_rule_type('hole', 'wear_factor', unit=unit_wear, low=0.0_wp, open=.true., high=most_wear, &
         meaning='volume of worn casing per side force and sliding distance; water-base mud 7 to 30 (5 to 20e-10/psi)')]

   type(key_rule_type), parameter :: fluid_keys(*) = [ &
      key_rule_type('fluid', 'density', unit=unit_density, low=0.0_wp, high=heaviest, default='0', meaning='density of the '// &
      'fluid'), &
      key_rule_type('fluid', 'where', kind_text, default='both', choices='both inside outside', &
         meaning='side of the string that it fills'), &
      key_rule_type('fluid', 'md_top', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='measured depth where it begins; it reaches down to the next fluid of its side'), &
      key_rule_type('fluid', 'tvd_top', unit=unit_length, low=0.0_wp, high=deepest, &
         meaning='in place of md_top: true vertical depth of the upper end'), &
      key_rule_type('fluid', 'above_bit', unit=unit_length, low=0.0_wp, open=.true., high=deepest, &
         meaning='in place of md_top: distance of the upper end from the bit, with which it moves; fills a shorter string'), &
      key_rule_type('fluid', 'float_collar', kind_text, default='none', choices='none closed open_below', &
         meaning='float collar at above_bit; open_below: collar closed, string below it open to the hole'), &
      key_rule_type('fluid', 'surface_pressure', unit=unit_pressure, low=0.0_wp, high=highest_pump, default='0', &
         meaning='annulus pressure at surface, pushes the pipe up; for the uppermost fluid outside')]

   type(key_rule_type), parameter :: rig_keys(*) = [ &
      key_rule_type('rig', 'block_weight', unit=unit_force, low=0.0_wp, high=strongest, default='0', &
         meaning='weight of travelling block, hook and top drive'), &
      key_rule_type('rig', 'lines', kind_integer, low=1.0_wp, high=most_lines, &
         meaning='lines strung to the travelling block; needed by a sheave_efficiency below 1'), &
      key_rule_type('rig', 'sheave_efficiency', low=poorest, high=1.0_wp, default='1', &
         meaning='efficiency of one turning sheave; roller bearings 0.96 to 0.99'), &
      key_rule_type('rig', 'deadline_sheave', kind_text, default='inactive', choices='inactive active', &
         meaning='active: the sheave of the dead line turns like the others'), &
      key_rule_type('rig', 'max_hookload', unit=unit_force, low=0.0_wp, open=.true., high=strongest, &
         meaning='largest hook load of the rig, block included; not together with rig_limit of &job'), &
      key_rule_type('rig', 'max_torque', unit=unit_moment, low=0.0_wp, open=.true., high=strongest, &
         meaning='largest torque of top drive or rotary table; default: not known'), &
      key_rule_type('rig', 'max_push', unit=unit_force, low=0.0_wp, high=strongest, default='0', &
         meaning='largest push at surface: block weight set on the string, injector, snubbing unit or hanger; 0: none')]

   type(key_rule_type), parameter :: component_keys(*) = [ &
      key_rule_type('component', 'string', kind_text, default='main', meaning='name of its drillstring'), &
      key_rule_type('component', 'name', kind_text, meaning='label; default the kind'), &
      key_rule_type('component', 'kind', kind_text, default='drillpipe', &
         meaning='drillpipe, hwdp, casing, liner, tubing, rod, collar, jar, stabilizer, bit (may fill its hole), '// &
         'or the name of a tool'), &
      key_rule_type('component', 'catalogue', kind_text, &
         meaning='entry of the catalogue: supplies keys that are not given here, od too'), &
      key_rule_type('component', 'length', unit=unit_length, low=0.0_wp, high=deepest, default='0', &
         meaning='length, 1 mm or more; 0 on the last component: to surface'), &
      key_rule_type('component', 'od', unit=unit_diameter, required=.true., low=narrowest, high=widest, &
         meaning='outside diameter of the body; of a bit, of its shank'), &
      key_rule_type('component', 'id', unit=unit_diameter, low=0.0_wp, high=widest, default='0', meaning='inside diameter'), &
      key_rule_type('component', 'mass', unit=unit_mass, low=0.0_wp, high=heaviest, &
         meaning='mass in air per length; default from od, id and density'), &
      key_rule_type('component', 'density', unit=unit_density, low=0.0_wp, open=.true., high=heaviest, default='7850', &
         meaning='density of the material, for buoyancy'), &
      key_rule_type('component', 'youngs', unit=unit_modulus, low=0.0_wp, open=.true., high=1.0e5_wp, default='206', &
         meaning='Young''s modulus'), &
      key_rule_type('component', 'poisson', low=0.0_wp, high=0.5_wp, default='0.3', meaning='Poisson''s ratio'), &
      key_rule_type('component', 'expansion', unit=unit_expansion, low=0.0_wp, high=100.0_wp, default='12.42', &
         meaning='thermal expansion; 12.42 (6.9 per degF): steel'), &
      key_rule_type('component', 'joint_od', unit=unit_diameter, low=0.0_wp, high=widest, default='0', &
         meaning='diameter of tool joints or blades, of a bit that of its hole; touches the wall, radius of torque; 0: none'), &
      key_rule_type('component', 'joint_length', unit=unit_length, low=0.0_wp, high=1.0e3_wp, default='0', &
         meaning='length of one tool joint, 1 mm or more; 0: 0.5 m'), &
      key_rule_type('component', 'joint_spacing', unit=unit_length, low=0.0_wp, open=.true., high=1.0e3_wp, default='9.5', &
         meaning='distance between tool joints'), &
      key_rule_type('component', 'opened_od', unit=unit_diameter, low=0.0_wp, high=widest, default='0', &
         meaning='diameter of a tool when open, such as an under-reamer; it must fit the hole there; 0: does not open'), &
      key_rule_type('component', 'opened_below', unit=unit_length, low=0.0_wp, high=deepest, &
         meaning='measured depth below which the tool is open; default the lower end of the last cased section'), &
      key_rule_type('component', 'yield', unit=unit_stress, low=0.0_wp, high=1.0e5_wp, default='0', &
         meaning='yield strength; 0: not given'), &
      key_rule_type('component', 'yield_loss', unit=unit_loss, low=0.0_wp, high=1.0_wp, default='0.054', &
         meaning='loss of yield strength per degree above ambient temperature; 0.054 (0.03/degF): steel, proposed for API TR '// &
         '5C3'), &
      key_rule_type('component', 'makeup_torque', unit=unit_moment, low=0.0_wp, high=strongest, default='0', &
         meaning='make-up torque of its connections; 0: 60 % of joint_torsion where that is known'), &
      key_rule_type('component', 'wear_class', kind_text, default='new', choices='new premium class2', &
         meaning='remaining wall 100, 80 or 70 %, worn outside; changes strength, not weight or stiffness'), &
      key_rule_type('component', 'wall_left', low=thinnest, high=1.0_wp, &
         meaning='remaining part of the wall, as inspected; default by wear_class'), &
      key_rule_type('component', 'connection', kind_text, &
         choices='NC23 NC26 NC31 NC35 NC38 NC40 NC44 NC46 NC50 NC56 NC61 NC70 NC77 5-1/2FH 6-5/8FH', &
         meaning='thread of its ends, for joint_torsion; default: not known'), &
      key_rule_type('component', 'joint_id', unit=unit_diameter, low=0.0_wp, high=widest, default='0', &
         meaning='bore of the pin, for joint_torsion, stresses and fatigue of joints; 0: not given, stresses use id'), &
      key_rule_type('component', 'joint_yield', unit=unit_stress, low=0.0_wp, open=.true., high=1.0e5_wp, &
         meaning='yield strength of tool joints, for joint_torsion; default 827.37 MPa (120 ksi), without tool joints yield'), &
      key_rule_type('component', 'joint_torsion', unit=unit_moment, low=0.0_wp, high=strongest, default='0', &
         meaning='torque at which a connection yields; 0: from connection, joint_od, joint_id, joint_yield if given'), &
      key_rule_type('component', 'tension_efficiency', low=0.0_wp, open=.true., high=most_efficient, &
         meaning='tensile strength of its connections divided by that of the body, as in data sheets of premium connections'), &
      key_rule_type('component', 'compression_efficiency', low=0.0_wp, open=.true., high=most_efficient, &
         meaning='compressive strength of its connections divided by the tensile strength of the body'), &
      key_rule_type('component', 'burst_efficiency', low=0.0_wp, open=.true., high=most_efficient, &
         meaning='burst strength of its connections divided by that of the body'), &
      key_rule_type('component', 'collapse_efficiency', low=0.0_wp, open=.true., high=most_efficient, &
         meaning='collapse strength of its connections divided by that of the body'), &
      key_rule_type('component', 'joint_dogleg', unit=unit_curvature, low=0.0_wp, open=.true., high=sharpest_dogleg, &
         meaning='largest dogleg for which its connections are rated'), &
      key_rule_type('component', 'friction', low=0.0_wp, high=roughest, &
         meaning='own friction factor in any hole, axial and rotary; default that of the hole'), &
      key_rule_type('component', 'friction_axial', low=0.0_wp, high=roughest, &
         meaning='own friction factor along the hole; default friction'), &
      key_rule_type('component', 'friction_rotary', low=0.0_wp, high=roughest, &
         meaning='own friction factor around the hole; default friction'), &
      key_rule_type('component', 'friction_scale', low=0.0_wp, high=roughest, default='1', &
         meaning='multiplies the friction of the hole, axial and rotary'), &
      key_rule_type('component', 'friction_scale_axial', low=0.0_wp, high=roughest, &
         meaning='multiplies friction_axial of the hole; default friction_scale'), &
      key_rule_type('component', 'friction_scale_rotary', low=0.0_wp, high=roughest, &
         meaning='multiplies friction_rotary of the hole; default friction_scale'), &
      key_rule_type('component', 'bend', unit=unit_angle, low=0.0_wp, high=sharpest_bend, default='0', &
         meaning='angle of a bent housing; 0: straight'), &
      key_rule_type('component', 'bend_position', unit=unit_length, low=0.0_wp, high=1.0e3_wp, &
         meaning='distance of the bend above the lower end of the component; needed with bend'), &
      key_rule_type('component', 'fatigue_curve', kind_text, default='none', choices='none E75 S135 own', &
         meaning='endurance limit of the rotating body: API RP 7G by grade, or own values'), &
      key_rule_type('component', 'fatigue_limit', unit=unit_stress, low=0.0_wp, open=.true., high=1.0e5_wp, &
         meaning='own curve: endurance limit at zero tension'), &
      key_rule_type('component', 'tensile_strength', unit=unit_stress, low=0.0_wp, high=1.0e5_wp, default='0', &
         meaning='own curve: tensile strength, for the effect of tension (Goodman); 0: no effect'), &
      key_rule_type('component', 'fatigue_share', low=0.0_wp, open=.true., high=1.0_wp, default='1', &
         meaning='corrosion factor on the endurance limit, connections too; very corrosive: 0.6'), &
      key_rule_type('component', 'fatigue_exponent', low=0.0_wp, high=50.0_wp, default='0', &
         meaning='m of the S-N curve above the permitted amplitude, turns = fatigue_turns (permitted/amplitude)^m; 0: not known'), &
      key_rule_type('component', 'fatigue_turns', low=1.0e3_wp, high=1.0e10_wp, default='1e6', &
         meaning='number of turns above which the endurance limit holds'), &
      key_rule_type('component', 'joint_fatigue_limit', unit=unit_stress, low=0.0_wp, open=.true., high=1.0e5_wp, &
         meaning='endurance limit of connections, as bending stress outside the tool joint; default: not known'), &
      key_rule_type('component', 'joint_fatigue_exponent', low=0.0_wp, high=50.0_wp, default='0', &
         meaning='fatigue_exponent of connections'), &
      key_rule_type('component', 'joint_fatigue_turns', low=1.0e3_wp, high=1.0e10_wp, default='1e6', &
         meaning='fatigue_turns of connections'), &
      key_rule_type('component', 'pad_force', unit=unit_force, low=0.0_wp, high=hardest_pad, default='0', &
         meaning='force of pads on the tool, across the hole (push-the-bit), also when it rotates; 0: no pads'), &
      key_rule_type('component', 'pad_clock', unit=unit_angle, low=-360.0_wp, high=360.0_wp, default='0', &
         meaning='direction of this force on the string, as toolface: 0 builds; the extended pad is opposite'), &
      key_rule_type('component', 'pad_position', unit=unit_length, low=0.0_wp, high=1.0e3_wp, &
         meaning='distance of the pads above the lower end of the component; needed with pad_force'), &
      key_rule_type('component', 'blade_offset', unit=unit_diameter, low=0.0_wp, high=most_eccentric, default='0', &
         meaning='distance of the centre of a stabilizer''s blades from the axis of the string; 0: centred'), &
      key_rule_type('component', 'blade_clock', unit=unit_angle, low=-360.0_wp, high=360.0_wp, default='0', &
         meaning='direction of this offset, clockwise from the toolface of the case'), &
      key_rule_type('component', 'sensor', unit=unit_length, low=0.0_wp, high=1.0e3_wp, &
         meaning='distance of a survey sensor above the lower end of the component, for its sag correction')]

   type(key_rule_type), parameter :: strength_keys(*) = [ &
      key_rule_type('strength', 'von_mises_factor', low=1.0_wp, high=10.0_wp, default='1', &
         meaning='design factor on von Mises stress'), &
      key_rule_type('strength', 'tension_factor', low=1.0_wp, high=10.0_wp, default='1', &
         meaning='design factor on tension, also in slips and connections'), &
      key_rule_type('strength', 'torsion_factor', low=1.0_wp, high=10.0_wp, default='1', &
         meaning='design factor on torque of bodies and connections, not on make-up torque'), &
      key_rule_type('strength', 'burst_factor', low=1.0_wp, high=10.0_wp, default='1', &
         meaning='design factor on burst (pressure inside less pressure outside)'), &
      key_rule_type('strength', 'collapse_factor', low=1.0_wp, high=10.0_wp, default='1', &
         meaning='design factor on collapse (pressure outside less pressure inside)'), &
      key_rule_type('strength', 'slip_length', unit=unit_diameter, low=0.0_wp, high=widest, default='0', &
         meaning='length of pipe that the slips grip; 0: not known, slips are not checked'), &
      key_rule_type('strength', 'slip_lateral', low=0.0_wp, high=100.0_wp, default='4', &
         meaning='lateral load of slips divided by axial load; 4: friction of 0.08 on the back of the slips')]
   type(key_rule_type), parameter :: centralizer_keys(*) = [ &
      key_rule_type('centralizer', 'string', kind_text, default='main', meaning='name of the string of the component'), &
      key_rule_type('centralizer', 'component', kind_text, required=.true., &
         meaning='name of the component that carries them; all components of this name in the string'), &
      key_rule_type('centralizer', 'kind', kind_text, default='rigid', choices='rigid bow', meaning='solid, or a bow spring'), &
      key_rule_type('centralizer', 'od', unit=unit_diameter, required=.true., low=narrowest, high=widest, &
         meaning='outside diameter; of bow springs when free'), &
      key_rule_type('centralizer', 'spacing', unit=unit_length, required=.true., low=1.0_wp, high=1.0e3_wp, &
         meaning='distance between centralizers'), &
      key_rule_type('centralizer', 'first', unit=unit_length, low=0.0_wp, high=deepest, &
         meaning='distance of the lowest one above the lower end of the component; default half the spacing'), &
      key_rule_type('centralizer', 'restoring_force', unit=unit_force, low=0.0_wp, open=.true., high=strongest, &
         meaning='restoring force of a bow at 67 % standoff (API 10D)'), &
      key_rule_type('centralizer', 'rated_hole', unit=unit_diameter, low=narrowest, high=widest, &
         meaning='diameter of the hole for which restoring_force holds; default od'), &
      key_rule_type('centralizer', 'running_force', unit=unit_force, low=0.0_wp, high=strongest, default='0', &
         meaning='drag of one bow in a hole narrower than its od (API 10D)'), &
      key_rule_type('centralizer', 'friction', low=0.0_wp, high=roughest, &
         meaning='friction factor of the centralizer, axial and rotary; default that of the component'), &
      key_rule_type('centralizer', 'friction_axial', low=0.0_wp, high=roughest, &
         meaning='its friction factor along the hole; default friction'), &
      key_rule_type('centralizer', 'friction_rotary', low=0.0_wp, high=roughest, &
         meaning='its friction factor around the hole; default friction')]

   type(key_rule_type), parameter :: boundary_keys(*) = [ &
      key_rule_type('boundary', 'top_lateral', kind_text, default='centred', choices='centred free', &
         meaning='lateral support at the top'), &
      key_rule_type('boundary', 'bit_lateral', kind_text, default='centred', choices='centred free', &
         meaning='lateral support at the bit'), &
      key_rule_type('boundary', 'packer_bore', unit=unit_diameter, low=0.0_wp, high=widest, default='0', &
         meaning='diameter of the seal bore of a packer at the lower end; pressures there load the string; 0: no packer'), &
      key_rule_type('boundary', 'packer_hold', kind_text, default='free', choices='free landed fixed', &
         meaning='lower end in cases with length_reference: free slides, landed moves up only, fixed cannot move')]

   type(key_rule_type), parameter :: load_case_keys(*) = [ &
      key_rule_type('load_case', 'name', kind_text, required=.true., meaning='unique; letters, digits and _ - . +'), &
      key_rule_type('load_case', 'section', kind_text, meaning='label of the hole section in tables'), &
      key_rule_type('load_case', 'operation', kind_text, required=.true., choices='*', meaning='operation'), &
      key_rule_type('load_case', 'bit_depth', unit=unit_length, required=.true., low=shortest_contact, high=deepest, &
         meaning='measured depth of the bit'), &
      key_rule_type('load_case', 'wob', unit=unit_force, low=-strongest, high=strongest, default='0', &
         meaning='weight on bit; > 0 pushes the bit, < 0 pulls it'), &
      key_rule_type('load_case', 'tob', unit=unit_moment, low=0.0_wp, high=strongest, default='0', meaning='torque on bit'), &
      key_rule_type('load_case', 'string', kind_text, default='main', meaning='name of the drillstring'), &
      key_rule_type('load_case', 'friction', low=0.0_wp, high=roughest, &
         meaning='friction factor of the whole hole, axial and rotary, in place of those of &hole'), &
      key_rule_type('load_case', 'friction_axial', low=0.0_wp, high=roughest, &
         meaning='friction factor along the hole, in place of the hole''s'), &
      key_rule_type('load_case', 'friction_rotary', low=0.0_wp, high=roughest, &
         meaning='friction factor around the hole, in place of the hole''s'), &
      key_rule_type('load_case', 'rpm', unit=unit_rotation, low=0.0_wp, high=1.0e4_wp, default='0', meaning='rotation speed'), &
      key_rule_type('load_case', 'hours', low=0.0_wp, high=1.0e5_wp, default='0', &
         meaning='hours of rotation at rpm, for casing wear and fatigue'), &
      key_rule_type('load_case', 'trip_speed', unit=unit_speed, low=0.0_wp, high=100.0_wp, default='0', &
         meaning='axial speed of the string'), &
      key_rule_type('load_case', 'pump_pressure', unit=unit_pressure, low=0.0_wp, high=highest_pump, default='0', &
         meaning='pump pressure, added inside from surface to the bit or a closed collar'), &
      key_rule_type('load_case', 'annulus_pressure', unit=unit_pressure, low=0.0_wp, high=highest_pump, default='0', &
         meaning='annulus pressure at surface in this case, added to surface_pressure of &fluid'), &
      key_rule_type('load_case', 'inside_density', unit=unit_density, low=0.0_wp, high=heaviest, &
         meaning='density of the fluid inside in this case (injected, produced); default that of &fluid'), &
      key_rule_type('load_case', 'temperature_change_top', unit=unit_temperature, low=-hottest, high=hottest, default='0', &
         meaning='rise in temperature of the string at surface since it was run; changes its length'), &
      key_rule_type('load_case', 'temperature_change_bottom', unit=unit_temperature, low=-hottest, high=hottest, default='0', &
         meaning='the same at the bit; linear in true vertical depth between'), &
      key_rule_type('load_case', 'above_ambient_top', unit=unit_temperature, low=0.0_wp, high=hottest, default='0', &
         meaning='temperature of the string at surface above 24 degC (75 degF); reduces strength by yield_loss'), &
      key_rule_type('load_case', 'above_ambient_bottom', unit=unit_temperature, low=0.0_wp, high=hottest, default='0', &
         meaning='the same at the bit; linear in true vertical depth between'), &
      key_rule_type('load_case', 'length_reference', kind_text, &
         meaning='load case from which the change of length counts; default: the string before it was run'), &
      key_rule_type('load_case', 'measured_hookload', unit=unit_force, low=0.0_wp, open=.true., high=strongest, &
         meaning='measured hook load, for comparison; with &rig the reading of the weight indicator'), &
      key_rule_type('load_case', 'measured_torque', unit=unit_moment, low=0.0_wp, high=strongest, meaning='measured torque, '// &
      'for comparison'), &
      key_rule_type('load_case', 'reference_hookload', unit=unit_force, low=0.0_wp, open=.true., high=strongest, &
         meaning='hook load of another program, for comparison; without block'), &
      key_rule_type('load_case', 'toolface', unit=unit_angle, low=-360.0_wp, high=360.0_wp, default='0', &
         meaning='direction of a bent housing: from the high side (north in a vertical hole), clockwise looking down')]

   ! Numbers that are defaults of the solver stand in dg_numerics. Its words and logicals stand here, too.
   type(key_rule_type), parameter :: solver_keys(*) = [ &
      key_rule_type('solver', 'fidelity', kind_text, default='auto', choices='auto fast standard reference', &
         meaning='longest element: auto 30 m, less in strings under 1500 m, fast 60, standard 10, reference 1 m; '// &
         'fast: gaps at nodes'), &
      key_rule_type('solver', 'element_length', unit=unit_length, low=0.01_wp, high=1.0e3_wp, &
         meaning='longest element; default that of fidelity'), &
      key_rule_type('solver', 'gap_location', kind_text, choices='extremum nodes', &
         meaning='place of a gap element; default extremum, with fidelity fast nodes'), &
      key_rule_type('solver', 'friction_range', kind_logical, default='.true.', &
         meaning='solve a sliding string in helical buckling from a second start too; gives the range of hook loads'), &
      key_rule_type('solver', 'tool_joints', kind_text, default='auto', choices='auto smeared discrete', &
         meaning='smeared: joint_od touches all along; discrete: each joint, and pipe between; '// &
         'auto: discrete if pipe bows, not with fast'), &
      key_rule_type('solver', 'linear_solver', kind_text, default='block', choices='block banded sparse', &
         meaning='solver of the linear equations'), &
      key_rule_type('solver', 'tolerance', low=round_off, high=0.1_wp, &
         meaning='residual at convergence divided by the weight; above 1e-6 it counts as 1e-6'), &
      key_rule_type('solver', 'max_iterations', kind_integer, low=1.0_wp, high=most_iterations, &
                    meaning='largest number of iterations of a case, all attempts together'), &
      key_rule_type('solver', 'load_steps', kind_integer, low=1.0_wp, high=most_steps, meaning='increments of the load'), &
      key_rule_type('solver', 'gk_min', unit=unit_wall, low=0.0_wp, high=10.0_wp, &
         meaning='rigidity of a free gap: Gkmin, Eq. 7'), &
      key_rule_type('solver', 'gk_contact', unit=unit_wall, low=0.0_wp, open=.true., high=stiffest, &
         meaning='rigidity of a wall in elastic contact: Gkc, Eq. 8'), &
      key_rule_type('solver', 'gk_max', unit=unit_wall, low=0.0_wp, open=.true., high=stiffest, &
         meaning='rigidity of a rigid wall: Gkmax'), &
      key_rule_type('solver', 'eps_n0', low=0.0_wp, high=1.0_wp, meaning='threshold of relative compression, Eqs. 7-8'), &
      key_rule_type('solver', 'eps_nmax', low=0.0_wp, open=.true., high=100.0_wp, &
         meaning='relative compression at which elastic turns to rigid, Eq. 8'), &
      key_rule_type('solver', 'r_n0', unit=unit_force, low=0.0_wp, high=touching, meaning='threshold of contact force, Eqs. 7-8'), &
      key_rule_type('solver', 'relocation', low=0.0_wp, high=10.0_wp, &
         meaning='a gap moves to a place that is deeper by this part of the clearance'), &
      key_rule_type('solver', 'step_limit', low=least_step, high=1.0e3_wp, &
         meaning='lateral step, in clearances, above which damping is raised'), &
      key_rule_type('solver', 'imperfection', low=0.0_wp, high=1.0_wp, &
         meaning='initial lateral offset of compressed parts, in clearances'), &
      key_rule_type('solver', 'wall_climb', kind_logical, default='.false.', &
         meaning='soft, rigid, mixed: a rotating string climbs the wall; divides contact by sqrt(1 + friction_rotary^2)'), &
      key_rule_type('solver', 'mixed_parts', kind_text, default='rigid', choices='rigid elements', &
         meaning='mixed: model of the string next to the bit; elements: beams with gaps to 100 m above the assembly'), &
      key_rule_type('solver', 'history', kind_logical, default='.false.', meaning='write the iteration history')]

contains

   !> The groups of a deck that tell of the scene; studies have groups of their own.
   subroutine scene_groups(groups)
      type(group_keys_type), allocatable, intent(out) :: groups(:)
      integer :: i
      allocate (groups(0))
      do i = 1, size(group_rules)
         call add_group(groups, group_rules(i), keys_of(trim(group_rules(i)%name)))
      end do
   end subroutine scene_groups

   !> Rules of the keys of a group of the scene; none for another.
   pure function keys_of(group) result(rules)
      character(*), intent(in) :: group
      type(key_rule_type), allocatable :: rules(:)
      select case (group)
      case ('job'); rules = job_keys
      case ('trajectory'); rules = trajectory_keys
      case ('hole'); rules = hole_keys
      case ('fluid'); rules = fluid_keys
      case ('rig'); rules = rig_keys
      case ('component'); rules = component_keys
      case ('tortuosity'); rules = tortuosity_keys
      case ('strength'); rules = strength_keys
      case ('centralizer'); rules = centralizer_keys
      case ('boundary'); rules = boundary_keys
      case ('load_case'); rules = load_case_keys
      case ('solver'); rules = solver_keys
      case default; allocate (rules(0))
      end select
   end function keys_of

   !> Place of a key among the rules of its group, 0 where it has none of that name.
   pure function key_place(group, key) result(place)
      character(*), intent(in) :: group, key
      integer :: place
      place = rule_place(keys_of(group), key)
   end function key_place

   !> Names of all operations, blanks between them: too many for a table row.
   pure function operation_words() result(words)
      character(:), allocatable :: words
      words = joined(operation_name, ' ')
   end function operation_words
end module dg_deck_keys

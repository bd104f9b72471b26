!> Advice of messages about keys and numbers of a deck: it is followed, and the message is gone. Each fault is one change to a deck
!> that is right, each remedy one change to the faulty deck.
module dg_test_followed_keys
   use funit, only: TestMethod, TestSuite
   use dg_test_followed_faults, only: follow
   implicit none
   private
   public :: followed_keys_suite

   character(*), parameter :: newline = achar(10)

contains

   function followed_keys_suite() result(suite)
      type(TestSuite) :: suite
      suite = TestSuite('followed_keys')
      call suite%addTest(TestMethod('tools', test_tools))
      call suite%addTest(TestMethod('texts', test_texts))
      call suite%addTest(TestMethod('numbers', test_numbers))
      call suite%addTest(TestMethod('units_and_slips', test_units))
      call suite%addTest(TestMethod('other_ways', test_other_ways))
   end function followed_keys_suite

   !> Keys of tools and of the hole that need another key.
   subroutine test_tools()
      call follow("&solver", "&centralizer component = 'collars', od = 200, spacing = 10, kind = 'bow' / &solver", &
                  "kind = 'bow' needs restoring_force", "'bow'", "'bow', restoring_force = 5")
      call follow("od = 171.45", "bend = 1.5, od = 171.45", "bend needs bend_position", "= 1.5", "= 1.5, bend_position = 2")
      call follow("od = 171.45", "pad_force = 15, od = 171.45", "pad_force needs pad_position", "= 15", "= 15, pad_position = 2")
      call follow("od = 171.45", "fatigue_curve = 'own', od = 171.45", "fatigue_curve = 'own' needs fatigue_limit", "'own'", &
                  "'own', fatigue_limit = 100")
      call follow("od = 171.45", "fatigue_limit = 100, od = 171.45", "fatigue_limit needs fatigue_curve = 'own'", "= 100, od", &
                  "= 100, fatigue_curve = 'own', od")
      call follow("od = 171.45", "joint_fatigue_exponent = 5, od = 171.45", "joint_fatigue_exponent needs joint_fatigue_limit", &
                  "= 5", "= 5, joint_fatigue_limit = 100")
      call follow("top_lateral = 'centred'", "packer_hold = 'fixed'", "packer_hold needs packer_bore", "'fixed'", &
                  "'fixed', packer_bore = 100")
      call follow("&solver", "&rig sheave_efficiency = 0.98 / &solver", "sheave_efficiency = 0.98 needs lines", "= 0.98", &
                  "= 0.98, lines = 10")
      call follow("wob = 20.0", "wob = 20.0, hours = 5", "hours needs rpm > 0", "= 5", "= 5, rpm = 60")
      call follow("wob = 20.0", "wob = 20.0 / &load_case name = 'r', operation = 'reaming', bit_depth = 800, rpm = 60", &
                  "needs trip_speed > 0", "= 60", "= 60, trip_speed = 0.1")
      call follow("diameter = 220.0", "wear_factor = 10, diameter = 220.0", "wear_factor needs casing_od", "= 10", &
                  "= 10, casing_od = 244.5")
      call follow("density = 1200.0", "density = 1200.0 / &fluid density = 1100, above_bit = 10", "it needs where = 'inside'", &
                  "= 10", "= 10, where = 'inside'")
      call follow("density = 1200.0", &
                  "density = 1200.0 / &fluid density = 1100, md_top = 300, where = 'inside', float_collar = 'closed'", &
                  "it needs above_bit", "md_top = 300", "above_bit = 10")
      call follow("density = 1200.0", "density = 1200.0 / &fluid density = 1100", &
                  "from the top down, each with the md_top, tvd_top or", "= 1100", "= 1100, md_top = 300")
      call follow("density = 1200.0", "density = 1200.0 / &fluid density = 1100", &
                  "from the top down, each with the md_top, tvd_top or", "= 1100", "= 1100, tvd_top = 300")
      call follow("density = 1200.0", "density = 1200.0, where = 'inside' / &fluid where = 'inside', density = 1100", &
                  "or above_bit where it begins", "= 1100", "= 1100, above_bit = 300")
      call follow("'centred' /", "'centred', bit_lateral = 'free' / &steering /", "needs bit_lateral = 'centred' in &boundary", &
                  "'free'", "'centred'")
      call follow("'centred' /", "'centred' / &steering cases = 's', measured_dogleg = 1, 2 /", "needs one, or one per case", &
                  "1, 2", "1")
      call follow("'centred' /", "'centred' / &steering cases = 'u', 's', side_cutting = 0.1 /", &
                  "give wob > 0 or no side_cutting", "bit_depth = 900.0", "wob = 5, bit_depth = 900.0")
      call follow("'centred' /", "'centred' / &steering cases = 'u', 's', side_cutting = 0.1 /", &
                  "give wob > 0 or no side_cutting", ", side_cutting = 0.1", "")
   end subroutine test_tools

   !> Groups, keys and texts of a deck.
   subroutine test_texts()
      call follow("&boundary top", "&job / &boundary top", "given a second time, first in line 1; keep one", "&job / ", "")
      call follow("friction = 0.3", "friction = 0.3, diameter = 210", "given a second time, first in line 9; keep one", &
                  ", diameter = 210", "")
      call follow("&component name = 'collars', kind = 'collar', length = 100.0"//newline//"  od = 171.45, id = 71.4 /"//newline// &
                  "&component od = 127.0, id = 108.6"//newline//"  joint_od = 168.3 /", "", &
                  "group &component: missing; a deck needs it", "&solver", "&component od = 127, id = 108.6 / &solver")
      call follow("azi = 3*10.0 /", "azi = 3*10.0", "not closed before &hole in line 6; end it with /", "3*10.0", "3*10.0 /")
      call follow("'a deck'", "'a deck", "is not closed on its line", "'a deck", "'a deck'")
      call follow("= 220.0", "= 8.5""", "a number has no mark of inches behind it", "8.5""", "220")
      call follow("'a deck'", "'F"//char(246)//"rde'", "save the file as UTF-8", char(246), char(195)//char(182))
      call follow("'collars'", "'a"//char(226)//char(129)//char(166)//"b'", "the direction of writing; remove it", char(226)// &
                  char(129)//char(166), "")
      call follow("'collars'", "'=b'", "begin with a letter or a digit", "=b", "b")
      call follow("'s', op", "'@b', op", "begin with a letter or a digit", "@b", "1b")
   end subroutine test_texts

   !> Depths, lengths and settings that do not fit each other.
   subroutine test_numbers()
      character(*), parameter :: landed = "'centred', packer_bore = 100, packer_hold = 'landed' / &load_case name = 'v', "// &
         "operation = 'static', bit_depth = 800, wob = -30 / &load_case name = 'w', operation = 'static', bit_depth = 800, "// &
         "length_reference = 'v' /"
      call follow("md  = 0.0", "tie_on = 'vertical', kick_off = 60, md  = 50", "needs a depth above it", "= 60", "= 40")
      call follow("md  = 0.0, 500.0, 900.0"//newline//"  inc = 0.0, 0.0, 30.0"//newline//"  azi = 3*10.0", &
                  "interpolation = 'spline', md = 0, 775, 900, inc = 0, 160, 30, azi = 3*10", &
                  "or use interpolation = 'minimum_curvature'", "'spline'", "'minimum_curvature'")
      call follow("md  = 0.0, 500.0, 900.0"//newline//"  inc = 0.0, 0.0, 30.0"//newline//"  azi = 3*10.0", &
                  "interpolation = 'spline', md = 0, 775, 900, inc = 0, 160, 30, azi = 3*10", "add stations or use", &
                  "775, 900, inc = 0, 160, 30, azi = 3*10", "400, 775, 830, 900, inc = 0, 80, 160, 90, 30, azi = 5*10")
      call follow("md  = 0.0, 500.0, 900.0"//newline//"  inc = 0.0, 0.0, 30.0"//newline//"  azi = 3*10.0", &
                  "md = 0, inc = 0, azi = 10", "at least two are needed", "md = 0, inc = 0, azi = 10", &
                  "md = 0, 900, inc = 0, 30, azi = 2*10")
      call follow("md  = 0.0, 500.0, 900.0", "md = 0, 500, 400", "measured depth must increase", "400", "900")
      call follow("md_top = 0.0", "md_top = 10.0", "holes must begin at surface, md_top = 0", "= 10.0", "= 0")
      call follow("md_top = 400.0", "md_top = 410.0", "sections must abut", "= 410.0", "= 400.0")
      call follow("md_top = 400.0", "md_top = 390.0", "sections must abut", "= 390.0", "= 400.0")
      call follow("length = 100.0", "", "only the last component of string 'main' may reach to surface", "'collar',", &
                  "'collar', length = 100,")
      call follow("id = 108.6", "id = 108.6, length = 800, kind = 'drillpipe'"//newline// &
                  "  joint_od = 220 / &component od = 127, id = 108.6", "needs a diameter < 215.9 mm", "= 220 /", "= 168 /")
      call follow("= 800.0", "= 950.0", "needs a number, > 0 and <= 900 m", "= 950.0", "= 900.0")
      call follow("wob = 20.0", "wob = 20.0, length_reference = 'u'", "has another string or bit_depth; it must have the same", &
                  "bit_depth = 800.0", "bit_depth = 900.0")
      call follow("'centred' /", "'centred', packer_bore = 100, packer_hold = 'fixed' / &load_case name = 'v', operation = "// &
                  "'static', bit_depth = 800 / &load_case name = 'w', operation = 'static', bit_depth = 800, wob = 5, "// &
                  "length_reference = 'v' /", "leave wob out", "wob = 5, ", "")
      call follow("'centred' /", landed, "give that case wob = 0 or more", "wob = -30", "wob = 0")
      call follow("'centred' /", landed, "or packer_hold = 'fixed'", "'landed'", "'fixed'")
      call follow("= 10.0 /", "= 10.0, gk_contact = 10.0, gk_max = 5.0 /", "gk_max must be at least gk_contact", "= 5.0", &
                  "= 10.0")
      call follow("= 10.0 /", "= 10.0, gk_contact = 5, gk_min = 10 /", "gk_min must be smaller than gk_contact", "= 10 /", &
                  "= 1 /")
      call follow("= 10.0 /", "= 10.0, eps_n0 = 0.9 /", "eps_n0 must be smaller than eps_nmax", "= 0.9", "= 0.001")
      call follow("= 10.0 /", "= 10.0, eps_n0 = 0.015 /", "this close to the wall is ignored", "= 0.015", "= 0.001")
   end subroutine test_numbers

   !> Numbers that are legal and hardly meant, and keys that are missing.
   subroutine test_units()
      call follow("od = 127.0, id = 108.6"//newline//"  joint_od = 168.3", "od = 5.0, id = 4.276"//newline//"  joint_od = 6.63", &
                  "in holes of 215.9 mm and more; mind the units", "od = 5.0, id = 4.276"//newline//"  joint_od = 6.63", &
                  "od = 127.0, id = 108.6"//newline//"  joint_od = 168.3")
      call follow("joint_od = 168.3", "joint_od = 168.3, mass = 19.5", "mind the units, and the density of what is not steel", &
                  "= 19.5", "= 29")
      call follow("joint_od = 168.3", "joint_od = 168.3, mass = 11.2", "mind the units, and the density of what is not steel", &
                  "= 11.2", "= 11.2, density = 2800")
      call follow("joint_od = 168.3", "joint_od = 168.3, youngs = 30", "youngs = 30; steel has 206", "= 30", "= 206")
      call follow("500.0, 900.0", "899.0, 900.0", "is a depth or an angle mistyped?", "899.0", "500.0")
      call follow("500.0, 900.0"//newline, "500.0, 20000.0"//newline, "deeper than any hole so far; mind the units", "20000.0", &
                  "900.0")
      call follow("density = 1200.0", "density = 1.2", "is that of a gas or foam, water has 1000 kg/m3. Is it in sg? "// &
                  "Then write 1200", "= 1.2", "= 1200")
      call follow("density = 1200.0", "density = 10.02", "Is it in lbm/gal? Then write 1201", "= 10.02", "= 1201")
      call follow("wob = 20.0", "wob = 20000.0", "Is it in N? Then write 20", "= 20000.0", "= 20")
      call follow("od = 127.0", "connection = 'NC50', od = 127.0", "needs a joint_id (with tool joints) or an id and a yield", &
                  "= 'NC50'", "= 'NC50', joint_id = 88.9, yield = 931")
      call follow("+", "&tortuosity kind = 'sine', amplitude = 1, period = 100, md_bottom = 150 /", "give a longer section", &
                  "= 150", "= 250")
      call follow(", operation = 'sliding'", "", "key operation is missing; needs a text in quotes: trip_out, trip_in,", "'s'", &
                  "'s', operation = 'trip_in'")
      call follow("bit_depth = 800.0", "", "key bit_depth is missing; needs a number, 0.001 to 50000 m", "'sliding',", &
                  "'sliding', bit_depth = 800,")
   end subroutine test_units

   !> Messages that name several ways: those that no other test takes.
   subroutine test_other_ways()
      character(35), parameter :: lists(*) = [character(35) :: "element_lengths = 5, 10", &
         "fidelities = 'fast', 'auto'", "tolerances = 1e-5, 1e-6", "wall_stiffnesses = 1e6, 1e8", &
         "gap_locations = 'extremum', 'nodes'", "linear_solvers = 'banded', 'sparse'"]
      integer :: i
      call follow("&hole md_top = 0.0, md_bottom = 400.0"//newline//"  diameter = 220.0, friction = 0.25 /"//newline// &
                  "&hole md_top = 400.0,", "&hole md_top = 0.0"//newline//"  diameter = 220.0, friction = 0.25 /"//newline// &
                  "&hole", "give one of them", "0.25 /"//newline//"&hole", "0.25 /"//newline//"&hole md_top = 400,")
      call follow("md  = 0.0, 500.0, 900.0", "kick_off = 30, md = 50.0, 500.0, 900.0", "give both or none", "kick_off = 30,", &
                  "kick_off = 30, tie_on = 'vertical',")
      call follow("diameter = 220.0, friction = 0.25 /", "cased = .true., diameter = 220.0, friction = 0.25 / &sweep "// &
                  "bit_depth_step = 100, frictions = 0.2, frictions_cased = 0.1, frictions_open = 0.2 /", "keep one way", &
                  "frictions = 0.2, ", "")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate separate = 'none', 'holes' / "// &
                  "&load_case name = 'm', operation = 'up', bit_depth = 600, measured_hookload = 200", &
                  "and something else; keep one", "'none', 'holes'", "'holes'")
      call follow("bit_depth = 900.0", "measured_hookload = 300, bit_depth = 900.0 / &calibrate separate = 'operations', "// &
                  "apply = .true. / &load_case name = 'm', operation = 'up', bit_depth = 600, measured_hookload = 200", &
                  "apply needs separate = 'none' or 'holes'", "'operations'", "'holes'")
      do i = 1, size(lists)
         call follow("+", "&study cases = 'u', models = 'mcge' /", "give two values or more of element_lengths, fidelities", &
                     "models = 'mcge'", trim(lists(i)))
      end do
      call follow("+", "&sweep operations = 'up', 'down', bit_depth_to = 900, wob = 1, 2, 3 /", "give one, or one for each", &
                  "1, 2, 3", "1")
      call follow("+", "&uncertainty bit_depth_step = 300, friction_deviation = 0.02, friction_correlation = 0.5, "// &
                  "friction_correlations = 0.5 /", "friction_correlations, not both", ", friction_correlations = 0.5", "")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900 /", "nothing is uncertain; give a", "900 /", &
                  "900, density_deviation = 10 /")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900 /", "nothing is uncertain; give a", "900 /", &
                  "900, inclination_deviation = 0.1 /")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900 /", "nothing is uncertain; give a", "900 /", &
                  "900, azimuth_deviation = 0.1 /")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900 /", "nothing is uncertain; give a", "900 /", &
                  "900, torque_deviation = 1 /")
      call follow("id = 108.6", "id = 108.6, friction = 0.1, friction_scale = 0.5", "give one of the two", "friction = 0.1, ", "")
      call follow("density = 1200.0", "density = 1200.0, md_top = 100, above_bit = 100", &
                  "all say where the fluid begins; keep one", "md_top = 100, ", "where = 'inside', ")
      call follow("od = 127.0, id = 108.6"//newline//"  joint_od = 168.3", "connection = 'NC50', od = 165, id = 71.4", &
                  "or an id and a yield (without) that leave a pin", "= 'NC50'", "= 'NC50', yield = 758")
      call follow("+", "&uncertainty operations = 'up', bit_depth_to = 900, friction_deviations = 0.02 /", &
                  "hole sections; give one for each", "friction_deviations = 0.02", "friction_deviation = 0.02")
   end subroutine test_other_ways
end module dg_test_followed_keys

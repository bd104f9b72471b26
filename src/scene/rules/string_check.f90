!> Checks of drillstrings: numbers within a component, and of components one above the other.
module dg_string_check
   use dg_centralizer, only: centralizer_type
   use dg_component, only: closed_diameter, component_type, has_blades, is_eccentric, opens, shortest_contact
   use dg_kinds, only: wp
   use dg_likely_unit, only: mud_question, unit_questions
   use dg_missing, only: is_missing
   use dg_error, only: add_part_fault, error_list_type
   use dg_shown_size, only: depth_words, diameter_digits, diameter_words, length_digits
   use dg_text, only: either, quoted, to_text
   use dg_unit_kind, only: in_units, unit_density, unit_diameter, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: check_component, check_in_string, check_centralizer, widest_blades

   !> Part of a length that is round-off of a conversion [-].
   real(wp), parameter :: round_off = 1.0e-4_wp
   !> Widest blades and centralizers over their body, those of hole openers [-].
   real(wp), parameter :: widest_blades = 4.0_wp
   integer, parameter :: advised_digits = 4

contains

   !> Check diameters and lengths of one component, each within its range.
   subroutine check_component(component, place, units, found)
      type(component_type), intent(in) :: component
      integer, intent(in) :: place
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      associate (part => component)
         call check_shortest('length', part%length)
         call check_shortest('joint_length', part%joint_length)
         call check_within('bend_position', part%bend_position)
         call check_within('pad_position', part%pad_position)
         if (.not. is_missing(part%sensor)) call check_within('sensor', part%sensor)
         if (part%id >= part%od) call fault('id', 'id = '//wide(part%id)//' is not smaller than od = '//wide(part%od))
         if (part%joint_od > 0.0_wp .and. part%joint_od < part%od) call fault('joint_od', 'joint_od = '//wide(part%joint_od)// &
            ' is smaller than od = '//wide(part%od)//either(width_question(part%joint_od, part%od, units), &
            '; 0 or absent: no joints', width_question(part%joint_od, part%od, units) /= ''))
         if (part%joint_od > 0.0_wp .and. part%joint_id >= part%joint_od) call fault('joint_id', 'joint_id = '// &
            wide(part%joint_id)//' is not smaller than joint_od = '//wide(part%joint_od)//'. Give the bore of the pin')
         if (part%joint_od > 0.0_wp .and. part%joint_length > part%joint_spacing) call fault('joint_length', 'joint_length = '// &
            long(part%joint_length)//' is greater than joint_spacing = '//long(part%joint_spacing))
         if (is_eccentric(part) .and. .not. (has_blades(part) .and. closed_diameter(part) > part%od)) then
            call fault('blade_offset', "blade_offset needs kind = 'stabilizer' and joint_od, the diameter of its blades")
         else if (part%blade_offset > (0.5_wp + round_off)*(closed_diameter(part) - part%od)) then
            call fault('blade_offset', 'blade_offset = '//wide(part%blade_offset)//' is greater than '// &
                       wide(0.5_wp*(closed_diameter(part) - part%od))//': the body would touch before the blades')
         end if
         if (opens(part) .and. part%opened_od <= closed_diameter(part)) call fault('opened_od', 'opened_od = '// &
            wide(part%opened_od)//' is not greater than the closed diameter, '//wide(closed_diameter(part))// &
            ' (the larger of od and joint_od)')
         if (.not. (opens(part) .or. is_missing(part%opened_below))) call fault('opened_below', 'opened_below = '// &
            long(part%opened_below)//' has no meaning without opened_od, the diameter of the open tool; give both')
      end associate
   contains
      subroutine fault(key, message)
         character(*), intent(in) :: key, message
         call add_part_fault(found, 'component', place, key, message)
      end subroutine fault

      !> Check that a place above the lower end of the component is within it.
      subroutine check_within(key, position)
         character(*), intent(in) :: key
         real(wp), intent(in) :: position    !< [m]
         if (component%length > 0.0_wp .and. position > component%length) &
            call fault(key, key//' = '//long(position)//' is greater than length = '//long(component%length))
      end subroutine check_within

      subroutine check_shortest(key, length)
         character(*), intent(in) :: key
         real(wp), intent(in) :: length      !< [m]
         character(:), allocatable :: name
         if (.not. (length > 0.0_wp .and. length < (1.0_wp - round_off)*shortest_contact)) return
         name = ''
         if (allocated(component%name)) name = ' of '//quoted(component%name)
         call fault(key, key//name//' is '//depth_words(units, length)//', shorter than the shortest contact, '// &
                    diameter_words(units, shortest_contact, length_digits)//'. Give '// &
                    in_units(units, unit_length, shortest_contact, length_digits)//' or more')
      end subroutine check_shortest

      function wide(diameter) result(text)
         real(wp), intent(in) :: diameter
         character(:), allocatable :: text
         text = to_text(diameter/units%diameter, length_digits)
      end function wide

      function long(length) result(text)
         real(wp), intent(in) :: length
         character(:), allocatable :: text
         text = to_text(length/units%length, length_digits)
      end function long
   end subroutine check_component

   !> Check that a component has a length unless it is the uppermost, and that it sinks in the mud.
   subroutine check_in_string(component, place, string, uppermost, units, found, heaviest)
      type(component_type), intent(in) :: component
      integer, intent(in) :: place
      character(*), intent(in) :: string           !< its name
      logical, intent(in) :: uppermost
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      real(wp), intent(in), optional :: heaviest   !< density of the heaviest fluid [kg/m3]; absent: there is none
      if (component%length <= 0.0_wp .and. .not. uppermost) call add_part_fault(found, 'component', place, 'length', &
         'length of '//quoted(component%name)//' is missing or 0; list components from the bit upwards: only the last '// &
         'component of string '//quoted(string)//' may reach to surface')
      if (.not. present(heaviest)) return
      if (heaviest >= component%density) call add_part_fault(found, 'component', place, 'density', quoted(component%name)// &
         ' floats: the mud, '//dense(heaviest)//', is not lighter than the material, '//dense(component%density)//advice())
   contains
      function dense(density) result(text)
         real(wp), intent(in) :: density
         character(:), allocatable :: text
         text = in_units(units, unit_density, density, diameter_digits)
      end function dense

      !> Advice on a mud in another unit than the deck's.
      function advice() result(text)
         character(:), allocatable :: text
         text = mud_question(units, heaviest, advised_digits)
         if (text /= '') text = '. Look at the density of the mud'//text
      end function advice
   end subroutine check_in_string

   !> Check that centralizers fit their component. A rigid one is wider than the body, but may be narrower than couplings. A
   !> bow is wider than both, also in the hole where it was rated.
   subroutine check_centralizer(centralizer, component, place, units, found)
      type(centralizer_type), intent(in) :: centralizer
      type(component_type), intent(in) :: component
      integer, intent(in) :: place                 !< of the component
      type(unit_system_type), intent(in) :: units
      type(error_list_type), intent(inout) :: found
      real(wp) :: narrowest     ! diameter that the centralizers must exceed [m]
      associate (part => component)
         if (part%length > 0.0_wp .and. centralizer%first >= part%length) call fault('first', 'the lowest stands '// &
            far(centralizer%first)//' above the lower end of '//quoted(part%name)//', which is '//far(part%length)//' long')
         if (opens(part)) call fault('component', quoted(part%name)//' has opened_od; a tool that opens carries no centralizers')
         narrowest = merge(closed_diameter(part), part%od, centralizer%bow)
         if (centralizer%od <= narrowest) call add_part_fault(found, 'centralizer', place, 'od', 'od = '// &
            wide(centralizer%od)//' is not greater than that of '//quoted(part%name)//' (', 'component', place, '), '// &
            wide(narrowest)//width_question(centralizer%od, narrowest, units))
         if (.not. centralizer%bow) return
         if (centralizer%rated_hole <= closed_diameter(part)) call fault('rated_hole', 'rated_hole = '// &
            wide(centralizer%rated_hole)//' is not greater than the diameter of '//quoted(part%name)//', '// &
            wide(closed_diameter(part))//width_question(centralizer%rated_hole, closed_diameter(part), units))
      end associate
   contains
      subroutine fault(key, message)
         character(*), intent(in) :: key, message
         call add_part_fault(found, 'centralizer', place, key, message)
      end subroutine fault

      function wide(diameter) result(text)
         real(wp), intent(in) :: diameter
         character(:), allocatable :: text
         text = diameter_words(units, diameter, length_digits)
      end function wide

      function far(length) result(text)
         real(wp), intent(in) :: length
         character(:), allocatable :: text
         text = in_units(units, unit_length, length, length_digits)
      end function far
   end subroutine check_centralizer

   !> Question for the unit of a diameter that is smaller than the body's and would be usual in another unit; '' for others.
   function width_question(diameter, body, units) result(text)
      real(wp), intent(in) :: diameter, body       !< [m]
      type(unit_system_type), intent(in) :: units
      character(:), allocatable :: text
      text = unit_questions(units, unit_diameter, diameter/units%diameter, body, widest_blades*body, advised_digits)
   end function width_question
end module dg_string_check

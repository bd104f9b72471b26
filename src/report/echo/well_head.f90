!> The well and its strings in a few lines: depth, largest inclination and dogleg, weight in air, in mud and along the hole.
module dg_well_head
   use dg_kinds, only: wp
   use dg_component, only: buoyed_weight, centralizer_diameter, contact_diameter, is_bit, is_drill_pipe
   use dg_drillstring, only: component_tops, drillstring_type
   use dg_fluid, only: density_at, side_inside, side_outside
   use dg_fluid_pressure, only: stretch_type, stretches_of
   use dg_friction_estimate, only: upper_friction_type
   use dg_hole_section, only: hole_section_type
   use dg_minimum_curvature, only: dogleg_between
   use dg_missing, only: given, is_missing, optional_real
   use dg_model, only: model_type
   use dg_survey, only: tangent_of
   use dg_text, only: append_text, either, text_type, to_text
   use dg_trajectory, only: top_md, true_vertical_depth
   use dg_unit_kind, only: in_units, unit_curvature, unit_density, unit_diameter, unit_factor, unit_force, unit_length
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: deepest_bit, find_clearances, well_head

   integer, parameter :: few = 3, digits = 5, friction_digits = 4
   !> Hole sections whose friction factors are listed one by one.
   integer, parameter :: most_listed = 4
   !> Relative difference below which two weights are the same [-].
   real(wp), parameter :: round_off = 1.0e-9_wp

contains

   !> The lines. Each string stands with the bit at its deepest load case.
   pure function well_head(units, model, upper, own_friction) result(lines)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(upper_friction_type), intent(in), optional :: upper   !< of calibrations that are applied
      logical, intent(in), optional :: own_friction              !< friction factors of the hole sections are not used
      type(text_type), allocatable :: lines(:)
      real(wp) :: deepest, air, mud, along, collars, densities(2)
      character(:), allocatable :: line
      logical :: own, several
      integer :: i
      allocate (lines(0))
      call append_text(lines, path_line(units, model))
      own = .false.
      if (present(own_friction)) own = own_friction
      if (.not. own) call append_text(lines, friction_line(model))
      if (present(upper)) then
         several = size(upper%holes) > 1
         if (upper%known .and. (upper%axial .or. upper%rotary)) call append_text(lines, &
            'Upper end of its 95 % interval'//either(', each section alone (together less):', '', several)// &
            sections_text(upper%holes))
      end if
      do i = 1, size(model%strings)
         deepest = deepest_bit(model, model%strings(i))
         if (.not. deepest > top_md(model%trajectory)) cycle
         call weigh(model, model%strings(i), deepest, air, mud, along, collars, densities)
         line = 'String'//name_of(i, ' ')//', bit at '//in_units(units, unit_length, deepest, digits)//': '// &
            in_units(units, unit_force, air, few)//' in air'
         if (abs(air - mud) > round_off*air) line = line//', '//in_units(units, unit_force, mud, few)//' in mud of '// &
            either(to_text(densities(1)/unit_factor(units, unit_density), few)//' to ', '', densities(2) > densities(1))// &
            in_units(units, unit_density, densities(2), few)
         if (abs(mud - along) > round_off*air) line = line//', '//in_units(units, unit_force, along, digits - 1)// &
            ' along the hole'
         if (collars > 0.0_wp .and. collars < mud) line = line//', '// &
            in_units(units, unit_force, collars, few)//' in mud below the drill pipe'
         call append_text(lines, line)
         line = clearance_line(units, model, model%strings(i), deepest)
         if (line /= '') call append_text(lines, 'Least radial clearance'//name_of(i, ' of ')//' '//line)
      end do
   contains
      !> Name of a string where there are several.
      pure function name_of(i, before) result(name)
         integer, intent(in) :: i
         character(*), intent(in) :: before
         character(:), allocatable :: name
         name = ''
         if (size(model%strings) > 1) name = before//model%strings(i)%name
      end function name_of
   end function well_head

   !> Least clearance of a string in its hole with the bit at a depth, without the bit itself. It is '' if only a bit is in the
   !> hole.
   pure function clearance_line(units, model, string, bit) result(text)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit              !< measured depth [m]
      character(:), allocatable :: text
      type(optional_real) :: clearances(size(string%components))
      real(wp) :: places(size(string%components))
      integer :: part
      text = ''
      call find_clearances(model, string, bit, clearances, places)
      where (is_bit(string%components)) clearances%present = .false.
      if (.not. any(clearances%present)) return
      part = minloc(clearances%value, mask=clearances%present, dim=1)
      text = in_units(units, unit_diameter, clearances(part)%value, few)// &
             ': '//string%components(part)%name//' at '//in_units(units, unit_length, places(part), digits)
   end function clearance_line

   !> The least clearance of each component with the bit at a depth, absent of those above surface.
   pure subroutine find_clearances(model, string, bit, clearances, places)
      type(model_type), intent(in) :: model
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit                          !< measured depth [m]
      type(optional_real), intent(out) :: clearances(:)    !< one a component, on a side [m]
      real(wp), intent(out) :: places(:)                   !< measured depths [m]
      real(wp) :: tops(size(string%components)), lower, upper, widest, clearance
      integer :: i, k
      places = 0.0_wp
      tops = component_tops(string, bit - top_md(model%trajectory))
      lower = bit
      do i = 1, size(tops)
         upper = bit - tops(i)
         widest = max(contact_diameter(string%components(i), upper), centralizer_diameter(string%components(i)))
         do k = 1, size(model%holes)
            if (model%holes(k)%md_top >= lower .or. model%holes(k)%md_bottom <= upper .or. lower <= upper) cycle
            clearance = 0.5_wp*(model%holes(k)%diameter - widest)
            if (clearances(i)%present .and. clearance >= clearances(i)%value) cycle
            clearances(i) = given(clearance)
            places(i) = min(lower, model%holes(k)%md_bottom)
         end do
         lower = upper
      end do
   end subroutine find_clearances

   !> Depth of the bit at the deepest load case of a string [m]; 0 where no case has it.
   pure function deepest_bit(model, string) result(deepest)
      type(model_type), intent(in) :: model
      type(drillstring_type), intent(in) :: string
      real(wp) :: deepest
      integer :: k
      deepest = 0.0_wp
      do k = 1, size(model%cases)
         if (model%cases(k)%string == string%name) deepest = max(deepest, model%cases(k)%bit_depth)
      end do
   end function deepest_bit

   !> Depths, the largest inclination and the sharpest dogleg with where they are.
   pure function path_line(units, model) result(line)
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      character(:), allocatable :: line
      ! part of the deepest station above which a crossing ends, and round-off of depths [m]
      real(wp), parameter :: half = 0.5_wp, no_depth = 1.0e-6_wp
      real(wp) :: dogleg, sharpest, deepest, last
      integer :: i, steepest, place
      associate (path => model%trajectory)
         steepest = maxloc(path%inclination, dim=1)
         sharpest = 0.0_wp
         place = 1
         do i = 2, size(path%md)
            dogleg = dogleg_between(tangent_of(path%inclination(i - 1), path%azimuth(i - 1)), &
                                    tangent_of(path%inclination(i), path%azimuth(i)))/(path%md(i) - path%md(i - 1))
            if (dogleg <= sharpest) cycle
            sharpest = dogleg
            place = i
         end do
         deepest = maxval([(true_vertical_depth(path, path%md(i)), i=1, size(path%md))])
         i = size(path%md)
         last = true_vertical_depth(path, path%md(i))
         if (abs(last) < no_depth) last = 0.0_wp
         line = 'Well to '//in_units(units, unit_length, path%md(i), digits)//', true vertical depth '// &
            in_units(units, unit_length, last, digits)//either(', at most '//in_units(units, unit_length, deepest, digits), '', &
            last < half*deepest - no_depth)// &
            '. Largest inclination '// &
            to_text(path%inclination(steepest)/units%angle, few)//' deg at '// &
            in_units(units, unit_length, path%md(steepest), digits)
         if (sharpest > 0.0_wp) line = line//', dogleg '//in_units(units, unit_curvature, sharpest, few)//' at '// &
            in_units(units, unit_length, path%md(place), digits)
      end associate
   end function path_line

   !> Friction factors of the hole sections, and of load cases that have their own.
   pure function friction_line(model) result(line)
      type(model_type), intent(in) :: model
      character(:), allocatable :: line
      real(wp) :: low, high
      integer :: i, own
      line = 'Friction factor'//sections_text(model%holes)
      own = 0
      low = huge(low)
      high = 0.0_wp
      do i = 1, size(model%cases)
         associate (axial => model%cases(i)%friction_axial, rotary => model%cases(i)%friction_rotary)
            if (axial%present .or. rotary%present) own = own + 1
            if (axial%present) low = min(low, axial%value)
            if (axial%present) high = max(high, axial%value)
            if (rotary%present) low = min(low, rotary%value)
            if (rotary%present) high = max(high, rotary%value)
         end associate
      end do
      if (own == 0) return
      line = line//'. '//to_text(own)//' of '//to_text(size(model%cases))//' load cases have their own, '// &
             to_text(low, friction_digits)
      if (high > low) line = line//' to '//to_text(high, friction_digits)
   end function friction_line

   !> Friction factors of hole sections, a blank before each.
   pure function sections_text(holes) result(text)
      type(hole_section_type), intent(in) :: holes(:)
      character(:), allocatable :: text
      integer :: i
      text = ''
      if (size(holes) <= most_listed) then
         do i = 1, size(holes)
            text = text//' '//to_text(holes(i)%friction_axial, friction_digits)
            if (abs(holes(i)%friction_axial - holes(i)%friction_rotary) > 0.0_wp) &
               text = text//' axial and '//to_text(holes(i)%friction_rotary, friction_digits)//' rotary'
            if (.not. is_missing(holes(i)%friction_running_in)) &
               text = text//', running in '//to_text(holes(i)%friction_running_in, friction_digits)//','
            if (holes(i)%name /= '') text = text//' in '//holes(i)%name
            if (i < size(holes)) text = text//','
         end do
      else
         text = ' '//to_text(minval(holes%friction_axial), friction_digits)//' to '// &
                to_text(maxval(holes%friction_axial), friction_digits)//' axial, '// &
                to_text(minval(holes%friction_rotary), friction_digits)//' to '// &
                to_text(maxval(holes%friction_rotary), friction_digits)//' rotary in '//to_text(size(holes))//' hole sections'
      end if
   end function sections_text

   !> Weights of a string in the hole [N], without string above the first station. They are in air, in its fluids, in its fluids
   !> along the hole, and in its fluids of all below the lowest drill pipe.
   pure subroutine weigh(model, string, bit, air, mud, along, collars, densities)
      type(model_type), intent(in) :: model
      type(drillstring_type), intent(in) :: string
      real(wp), intent(in) :: bit              !< measured depth of the bit [m]
      real(wp), intent(out) :: air, mud, along, collars
      real(wp), intent(out) :: densities(2)    !< least and greatest of the fluids in and around it [kg/m3]
      type(stretch_type), allocatable :: stretches(:)
      real(wp) :: length, middle, weight, fluids(2)
      integer :: i, pipe                    ! the lowest drill pipe
      air = 0.0_wp
      mud = 0.0_wp
      along = 0.0_wp
      collars = 0.0_wp
      densities = [huge(densities), 0.0_wp]
      allocate (stretches, source=stretches_of(model, string, bit))
      pipe = findloc(is_drill_pipe(string%components), .true., dim=1)
      if (pipe == 0) pipe = size(string%components) + 1
      do i = 1, size(stretches)
         associate (part => string%components(stretches(i)%component))
            length = stretches(i)%lower - stretches(i)%upper
            middle = stretches(i)%upper + 0.5_wp*length
            fluids = [density_at(model%mud, side_outside, middle, bit), density_at(model%mud, side_inside, middle, bit)]
            weight = length*buoyed_weight(part, fluids(1), fluids(2), model%gravity)
            densities = [min(densities(1), minval(fluids)), max(densities(2), maxval(fluids))]
            air = air + length*part%mass*model%gravity
            mud = mud + weight
            along = along + weight/length*(true_vertical_depth(model%trajectory, stretches(i)%lower) - &
                                           true_vertical_depth(model%trajectory, stretches(i)%upper))
            if (stretches(i)%component < pipe) collars = collars + weight
         end associate
      end do
   end subroutine weigh
end module dg_well_head

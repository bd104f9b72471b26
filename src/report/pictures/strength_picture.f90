!> Utilisation of the string's strength against depth, by all models. Panels: stress and yield strength, safety factor, bending
!> stress and its range in a turn, torque against make-up torque.
module dg_strength_picture
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_chart, only: add_depth_curve, add_depth_panel, beside, chart_type, fit_range, new_chart, set_depth
   use dg_quantity, only: quantity_moment, quantity_none, quantity_stress
   use dg_component, only: component_type
   use dg_curve_look, only: colour_black, colour_of, line_style
   use dg_drillstring, only: component_at, component_tops
   use dg_job, only: job_type, model_name
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_path_picture, only: case_title
   use dg_profile, only: piece_depths
   use dg_text, only: either, to_text
   implicit none
   private
   public :: strength_chart

   character(*), parameter :: strength_look = "with lines lw 2.5 dt solid lc rgb '"//colour_black//"'", &
                              makeup_look = "with lines lw 2.5 dt (6,3) lc rgb '"//colour_black//"'", &
                              factor_look = "with lines lw 1.5 dt (6,3) lc rgb '"//colour_black//"'"
   !> Largest displayed safety factor over the least one, and its lower bound.
   real(wp), parameter :: most_of_least = 4.0_wp, most_factor = 4.0_wp

contains

   !> All `results` have profiles. Panels without anything to show are left out: safety factors without a yield strength, torque
   !> where there is none.
   function strength_chart(job, model, results, alongs) result(chart)
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)      !< of one case, one a model
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(chart_type) :: chart
      real(wp) :: least
      real(wp), allocatable :: tops(:), depths(:), yields(:), makeups(:), torsions(:)
      logical :: turns, twisted, strong
      integer :: k
      associate (load_case => model%cases(results(1)%case_index), units => job%units)
         turns = rotates(load_case%operation)
         twisted = turns .or. abs(load_case%tob) > 0.0_wp
         strong = any(.not. is_missing(alongs(1)%safety_factor))
         associate (string => model%strings(string_index(model%strings, load_case%string)), deepest => load_case%bit_depth)
            allocate (tops, source=component_tops(string, deepest - results(1)%profile%md(1)))
            call steps(string%components, tops, deepest, depths, yields, makeups, torsions)
         end associate
         chart = new_chart('strength_'//load_case%name, case_title(units, load_case)//': strength', units, 580, [0.83_wp, 0.92_wp])
         call set_depth(chart, 'measured depth', [0.0_wp, load_case%bit_depth], model%holes, place(), .false.)
         call add_depth_panel(chart, place(), 'von Mises'' stress', quantity_stress)
         do k = 1, size(results)
            call add(alongs(k)%von_mises, units%stress, trim(model_name(results(k)%model)), colour_of(k))
         end do
         if (any(alongs(1)%yield_left < 1.0_wp)) then
            call add_depth_curve(chart, results(1)%profile%md, yields_along(model, results(1), alongs(1)%yield_left), &
                                 units%stress, strength_look, 'yield', '')
         else
            call add_steps(yields, units%stress, strength_look, 'yield')
         end if
         call fit_range(chart)
         if (strong) then
            call add_depth_panel(chart, place(), 'safety factor', quantity_none)
            least = huge(least)
            do k = 1, size(results)
               call add(alongs(k)%safety_factor, 1.0_wp, '', colour_of(k))
               least = min(least, minval(alongs(k)%safety_factor, mask=.not. is_missing(alongs(k)%safety_factor)))
            end do
            call add_depth_curve(chart, [0.0_wp, load_case%bit_depth], spread(model%design%von_mises, 1, 2), 1.0_wp, factor_look, &
                                 'design factor '//to_text(model%design%von_mises, 3), '')
            call fit_range(chart, most=max(most_of_least*least, most_factor))
         end if
         call add_depth_panel(chart, place(), either('range of bending in a turn', 'bending stress', turns), &
                              quantity_stress)
         do k = 1, size(results)
            call add(merge(2.0_wp, 1.0_wp, turns)*alongs(k)%bending_stress, units%stress, '', colour_of(k))
         end do
         call fit_range(chart)
         if (.not. twisted) return
         call add_depth_panel(chart, place(), 'torque', quantity_moment)
         do k = 1, size(results)
            call add(results(k)%profile%torque, units%moment, '', '')
         end do
         call add_steps(makeups, units%moment, makeup_look, 'make-up torque')
         call add_steps(torsions, units%moment, strength_look, '')
         call fit_range(chart)
      end associate

   contains

      !> Of the next panel.
      pure function place()
         real(wp) :: place(4)
         place = beside(size(chart%panels) + 1, 2 + count([strong, twisted]), [0.075_wp, 0.985_wp, 0.125_wp, 0.82_wp], 0.03_wp)
      end function place

      !> A curve of one model.
      subroutine add(values, unit, name, band)
         real(wp), intent(in) :: values(:), unit
         character(*), intent(in) :: name, band
         call add_depth_curve(chart, results(k)%profile%md, values, unit, line_style(k), name, band)
      end subroutine add

      !> A strength of the components, where any has one.
      subroutine add_steps(values, unit, look, name)
         real(wp), intent(in) :: values(:), unit
         character(*), intent(in) :: look, name
         if (.not. all(is_missing(values))) call add_depth_curve(chart, depths, values, unit, look, name, '')
      end subroutine add_steps
   end function strength_chart

   !> Strengths of the components, from the top down, each at its upper and its lower end [m]; `missing` where unknown.
   pure subroutine steps(components, tops, deepest, depths, yields, makeups, torsions)
      type(component_type), intent(in) :: components(:)
      real(wp), intent(in) :: tops(:)        !< from component_tops [m]
      real(wp), intent(in) :: deepest        !< depth of the bit [m]
      real(wp), allocatable, intent(out) :: depths(:), yields(:), makeups(:), torsions(:)
      integer :: i, k, n
      n = size(components)
      allocate (depths(2*n), yields(2*n), makeups(2*n), torsions(2*n))
      yields = missing
      makeups = missing
      torsions = missing
      do i = 1, n
         k = n + 1 - i
         depths(2*i - 1) = deepest - tops(k)
         depths(2*i) = deepest
         if (k > 1) depths(2*i) = deepest - tops(k - 1)
         associate (part => components(k), both => [2*i - 1, 2*i])
            if (part%yield > 0.0_wp) yields(both) = part%yield
            if (part%makeup_torque > 0.0_wp) makeups(both) = part%makeup_torque
            if (part%joint_torsion > 0.0_wp) torsions(both) = part%joint_torsion
         end associate
      end do
   end subroutine steps

   !> Yield strength of a warm string at each row of a profile [Pa]; `missing` where it is not known.
   pure function yields_along(model, result, left) result(yields)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: result
      real(wp), intent(in) :: left(:)        !< of the yield strength, one a row [-]
      real(wp) :: yields(size(left))
      real(wp), allocatable :: tops(:)
      real(wp) :: bit, depths(size(left)), yield
      integer :: i
      bit = model%cases(result%case_index)%bit_depth
      depths = piece_depths(result%profile)
      associate (string => model%strings(string_index(model%strings, model%cases(result%case_index)%string)))
         allocate (tops, source=component_tops(string, bit - result%profile%md(1)))
         do i = 1, size(left)
            yield = string%components(component_at(tops, bit - depths(i)))%yield
            yields(i) = merge(left(i)*yield, missing, yield > 0.0_wp)
         end do
      end associate
   end function yields_along
end module dg_strength_picture

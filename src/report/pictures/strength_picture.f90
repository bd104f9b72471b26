!> What is used of the string's strength against depth, by all models: stress and yield strength, safety factor, bending stress and
!> its range in a turn, torque against make-up.
module dg_strength_picture
   use dg_kinds, only: wp
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_column, only: quantity_moment, quantity_stress, unit_text
   use dg_component, only: component_type
   use dg_depth_panels, only: add_curve, band_look, curve_type, draw_panel, name_no_sections, panel_place_type, put_sections, &
                              range_of_curves
   use dg_drillstring, only: component_tops
   use dg_gnuplot_script, only: add_series, colour_black, colour_of, end_script, legend, line_style, series_type, &
                                start_script
   use dg_job, only: job_type, model_name
   use dg_load_case, only: rotates
   use dg_missing, only: is_missing, missing
   use dg_model, only: model_type, string_index
   use dg_path_picture, only: case_title
   use dg_text, only: append_text, text_type, to_text
   implicit none
   private
   public :: strength_script

   integer, parameter :: digits = 8
   !> Size of the picture [px], and the parts of its height that hold panels and legend.
   integer, parameter :: width = 1120, height = 580
   real(wp), parameter :: bottom = 0.125_wp, top = 0.82_wp, legend_top = 0.92_wp
   real(wp), parameter :: first_left = 0.075_wp, last_right = 0.985_wp, gap = 0.03_wp
   character(*), parameter :: strength_look = "with lines lw 2.5 dt solid lc rgb '"//colour_black//"'", &
                              makeup_look = "with lines lw 2.5 dt (6,3) lc rgb '"//colour_black//"'", &
                              factor_look = "with lines lw 1.5 dt (6,3) lc rgb '"//colour_black//"'"
   !> Safety factors are shown up to so many times the least one, and up to this at least: more tell nothing.
   real(wp), parameter :: most_of_least = 4.0_wp, most_factor = 4.0_wp

contains

   !> All `results` have profiles. Panels without anything to show are left out: safety factors without a yield strength, torque
   !> where there is none.
   subroutine strength_script(name, job, model, results, alongs, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(case_result_type), intent(in) :: results(:)      !< of one case, one a model
      type(along_string_type), intent(in) :: alongs(:)      !< as many
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: key(:)
      type(text_type), allocatable :: body(:)
      type(curve_type), allocatable :: curves(:)
      real(wp) :: deepest, length, low, high, least
      real(wp), allocatable :: tops(:), depths(:), yields(:), makeups(:), torsions(:)
      logical :: any_band, turns, twisted, strong
      integer :: k, number, panels
      associate (load_case => model%cases(results(1)%case_index))
         deepest = load_case%bit_depth
         length = job%units%length
         turns = rotates(load_case%operation)
         twisted = turns .or. abs(load_case%tob) > 0.0_wp
         associate (string => model%strings(string_index(model%strings, load_case%string)))
            allocate (tops, source=component_tops(string, deepest - results(1)%profile%md(1)))
            call steps(string%components, tops, deepest, depths, yields, makeups, torsions)
         end associate
         strong = any(.not. is_missing(alongs(1)%safety_factor))
         panels = 2 + count([strong, twisted])
         allocate (body(0), key(0))
         call append_text(body, 'set yrange ['//to_text(deepest/length, digits)//':0]')
         call put_sections(body, model%holes, job%units, deepest, place(1), .false.)
         any_band = .false.
         do k = 1, size(results)
            call add_curve(curves, results(k)%profile%md, length, alongs(k)%von_mises, job%units%stress, line_style(k), &
                           colour_of(k))
            call add_series(key, 'NaN', line_style(k), trim(model_name(results(k)%model)))
         end do
         call add_steps(yields, job%units%stress, strength_look, 'yield')
         call finish(1, 'von Mises'' stress ['//unit_text(quantity_stress, job%units)//']')
         number = 1
         if (strong) then
            number = number + 1
            least = huge(least)
            do k = 1, size(results)
               call add_curve(curves, results(k)%profile%md, length, alongs(k)%safety_factor, 1.0_wp, line_style(k), &
                              colour_of(k))
               least = min(least, minval(alongs(k)%safety_factor, mask=.not. is_missing(alongs(k)%safety_factor)))
            end do
            call add_curve(curves, [0.0_wp, deepest], length, spread(job%design%von_mises, 1, 2), 1.0_wp, factor_look, '')
            call add_series(key, 'NaN', factor_look, 'design factor '//to_text(job%design%von_mises, 3))
            call finish(number, 'safety factor', most_of_least*least)
         end if
         number = number + 1
         do k = 1, size(results)
            call add_curve(curves, results(k)%profile%md, length, merge(2.0_wp, 1.0_wp, turns)*alongs(k)%bending_stress, &
                           job%units%stress, line_style(k), colour_of(k))
         end do
         if (turns) then
            call finish(number, 'range of bending in a turn ['//unit_text(quantity_stress, job%units)//']')
         else
            call finish(number, 'bending stress ['//unit_text(quantity_stress, job%units)//']')
         end if
         if (twisted) then
            number = number + 1
            do k = 1, size(results)
               call add_curve(curves, results(k)%profile%md, length, results(k)%profile%torque, job%units%moment, line_style(k), &
                              '')
            end do
            call add_steps(makeups, job%units%moment, makeup_look, 'make-up torque')
            call add_steps(torsions, job%units%moment, strength_look, '')
            call finish(number, 'torque ['//unit_text(quantity_moment, job%units)//']')
         end if
         if (any_band) call add_series(key, 'NaN', band_look(colour_of(1)), 'least to greatest, mean as line')
         call start_script(lines, name, width, height)
         call legend(lines, case_title(job%units, load_case)//': strength', key, top + 0.01_wp, legend_top)
         lines = [lines, body]
         call end_script(lines)
      end associate

   contains

      pure function place(number) result(where_it_is)
         integer, intent(in) :: number
         type(panel_place_type) :: where_it_is
         real(wp) :: wide
         wide = (last_right - first_left + gap)/panels - gap
         where_it_is = panel_place_type(first_left + (number - 1)*(wide + gap), first_left + (number - 1)*(wide + gap) + wide, &
                                        bottom, top, width, height)
      end function place

      !> A strength of the components, where any has one.
      subroutine add_steps(values, unit, look, label)
         real(wp), intent(in) :: values(:), unit
         character(*), intent(in) :: look, label
         if (all(is_missing(values))) return
         call add_curve(curves, depths, length, values, unit, look, '')
         if (label /= '') call add_series(key, 'NaN', look, label)
      end subroutine add_steps

      !> Draws what has been gathered.
      subroutine finish(number, label, most)
         integer, intent(in) :: number
         character(*), intent(in) :: label
         real(wp), intent(in), optional :: most    !< end of the axis at most
         type(text_type) :: labels(2)
         logical :: banded
         call range_of_curves(curves, low, high)
         if (present(most)) high = min(high, max(most, most_factor))
         labels(1)%text = label
         labels(2)%text = ''
         if (number == 1) labels(2)%text = 'measured depth ['//trim(job%units%length_label)//']'
         call draw_panel(body, place(number), labels, curves, low, high, banded)
         any_band = any_band .or. banded
         if (number == 1) call name_no_sections(body)
         deallocate (curves)
      end subroutine finish
   end subroutine strength_script

   !> What the components bear, from the top down, each at its upper and its lower end [m]; `missing` where it is not known.
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
end module dg_strength_picture

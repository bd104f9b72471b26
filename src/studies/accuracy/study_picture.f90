!> Cost of accuracy in one load case: error of hook load, torque, contact force and bending moment against seconds. One mark per
!> method, both axes logarithmic. The finest method has no error and no mark.
module dg_study_picture
   use dg_kinds, only: wp
   use dg_case_result, only: result_converged
   use dg_chart, only: add_curve, add_panel, chart_type, new_chart
   use dg_curve_look, only: colour_black, mark_style
   use dg_job, only: model_name
   use dg_load_case, only: load_case_type, rotates
   use dg_numerics, only: fidelity_name
   use dg_study_comparison, only: error_bending, error_hookload, error_normal_force, error_torque, study_record_type
   use dg_study_variant, only: variant_type
   use dg_text, only: to_text
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: study_chart

   !> Errors in the order of their panels, and what these are called.
   integer, parameter :: errors(4) = [error_hookload, error_torque, error_normal_force, error_bending]
   character(*), parameter :: names(4) = [character(20) :: 'hook load', 'torque', 'contact force', 'bending moment']

   !> Ways that the picture calls by name, in its legend: they lie too close together for names beside their marks.
   character(*), parameter :: told(3) = [character(8) :: 'auto', 'fast', 'standard']
   integer, parameter :: told_marks(3) = [4, 8, 12]

   !> Errors less than this are drawn as this [%]: one that is round-off leaves no room for the others.
   real(wp), parameter :: least_error = 1.0e-5_wp

contains

   !> Errors of the variants of a study against seconds, for one of its cases.
   function study_chart(units, load_case, models, variants, records) result(chart)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      integer, intent(in) :: models(:)                      !< numbers of those of the study
      type(variant_type), intent(in) :: variants(:)
      type(study_record_type), intent(in) :: records(:)     !< as many
      type(chart_type) :: chart
      real(wp), parameter :: left(0:1) = [0.085_wp, 0.58_wp], wide = 0.40_wp, bottom(0:1) = [0.525_wp, 0.085_wp], tall = 0.355_wp
      logical :: best(size(records))
      integer :: i, k, drawn
      best = records%in_pareto_set
      chart = new_chart('study_'//load_case%name, 'Study of '//load_case%name// &
                        ': error against the finest settings, and solution time', units, 860, [0.89_wp, 0.955_wp])
      do k = 1, size(errors)
         if (errors(k) == error_torque .and. .not. rotates(load_case%operation)) cycle
         drawn = size(chart%panels)
         associate (x => left(mod(drawn, 2)), y => bottom(drawn/2))
            call add_panel(chart, [x, x + wide, y, y + tall], 'solution time [s]', 'error of '//trim(names(k))//' [%]')
         end associate
         chart%panels(drawn + 1)%logarithmic = .true.
         chart%panels(drawn + 1)%air = [0.03_wp, 0.05_wp]
         do i = 1, size(models)
            call add(variants%model == models(i), mark_style(i, 0.7_wp), trim(model_name(models(i))))
         end do
         call add(best, "with points pt 6 ps 1.5 lw 1.0 lc rgb '"//colour_black//"'", &
                  'Pareto: none better and faster')
         do i = 1, size(told)
            call add(is_told(variants%fidelity), 'with points pt '//to_text(told_marks(i))//" ps 1.6 lw 1.0 lc rgb '"// &
                     colour_black//"'", 'fidelity '//trim(told(i)))
         end do
      end do

   contains

      !> Marks of those that are solutions with an error.
      subroutine add(which, look, name)
         logical, intent(in) :: which(:)
         character(*), intent(in) :: look, name
         logical :: shown(size(which))
         real(wp) :: seconds(size(which)), error(size(which))
         seconds = records%seconds
         error = records%errors(errors(k))
         shown = which .and. records%status == result_converged .and. error > 0.0_wp
         call add_curve(chart, pack(seconds, shown), max(100.0_wp*pack(error, shown), least_error), &
                        look, trim(merge(name, repeat(' ', len(name)), drawn == 0)))
      end subroutine add

      elemental function is_told(fidelity) result(is)
         integer, intent(in) :: fidelity
         logical :: is
         is = fidelity > 0
         if (is) is = fidelity_name(fidelity) == told(i)
      end function is_told
   end function study_chart
end module dg_study_picture

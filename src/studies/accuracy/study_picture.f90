!> What accuracy costs in one load case: error of hook load, torque, contact force and bending moment against seconds, from
!> study.csv, one mark a way to compute it, both axes logarithmic. The finest way has no error and no mark.
module dg_study_picture
   use dg_kinds, only: wp
   use dg_gnuplot_script, only: add_series, colour_black, end_script, legend, mark_style, panel, plot, results_file, series_type, &
                                spelled, start_script
   use dg_job, only: job_type, model_name
   use dg_load_case, only: load_case_type, rotates
   use dg_study_plan, only: study_plan_type
   use dg_text, only: append_text, text_type, to_text
   implicit none
   private
   public :: study_script

   integer, parameter :: width = 1120, height = 860
   !> Columns of study.csv, and what their panels are called.
   integer, parameter :: panels = 4
   character(*), parameter :: columns(panels) = [character(22) :: 'hookload_error_pct', 'torque_error_pct', &
      'normal_force_error_pct', 'bending_error_pct']
   character(*), parameter :: names(panels) = [character(20) :: 'hook load', 'torque', 'contact force', 'bending moment']

   !> Ways that the picture calls by name, in its legend: they lie too close together for names beside their marks.
   character(*), parameter :: told(3) = [character(8) :: 'auto', 'fast', 'standard']
   integer, parameter :: told_marks(3) = [4, 8, 12]

   !> Errors less than this are drawn as this [%]: one that is round-off leaves no room for the others.
   real(wp), parameter :: least_error = 1.0e-5_wp

contains

   !> Script of the picture of a study's errors against seconds, for one of its cases.
   subroutine study_script(name, job, load_case, study, lines)
      character(*), intent(in) :: name      !< of the picture
      type(job_type), intent(in) :: job
      type(load_case_type), intent(in) :: load_case
      type(study_plan_type), intent(in) :: study
      type(text_type), allocatable, intent(out) :: lines(:)
      type(series_type), allocatable :: series(:)
      real(wp), parameter :: left(2) = [0.085_wp, 0.58_wp], wide = 0.40_wp, bottom(2) = [0.525_wp, 0.085_wp], tall = 0.355_wp, &
                             legend_bottom = 0.89_wp, legend_top = 0.955_wp
      integer, allocatable :: models(:)
      integer :: i, k, drawn, row, column
      if (size(study%models) > 0) then
         allocate (models, source=study%models)
      else
         allocate (models, source=job%models)
      end if
      call start_script(lines, name, width, height)
      call append_text(lines, "this(value) = stringcolumn('case') eq "//spelled(load_case%name)// &
                       " && stringcolumn('status') eq 'converged' && value > 0 ? (value > "// &
                       to_text(least_error)//' ? value : '//to_text(least_error)//') : NaN')
      call append_text(lines, "made(model, value) = stringcolumn('model') eq model ? this(value) : NaN")
      call append_text(lines, "best(value) = stringcolumn('pareto') eq 'yes' ? this(value) : NaN")
      call append_text(lines, "told(name, value) = stringcolumn('fidelity') eq name ? this(value) : NaN")
      do i = 1, size(models)
         call add_series(series, 'NaN', mark_style(i, 0.8_wp), trim(model_name(models(i))))
      end do
      call add_series(series, 'NaN', best_look(), 'Pareto: none better and faster')
      do i = 1, size(told)
         call add_series(series, 'NaN', told_look(i), 'fidelity '//trim(told(i)))
      end do
      call legend(lines, 'Study of '//load_case%name//': error against the finest way, and what it costs', series, &
                  legend_bottom, legend_top)
      call append_text(lines, 'set logscale xy; set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05')
      drawn = 0
      do k = 1, panels
         if (columns(k) == 'torque_error_pct' .and. .not. rotates(load_case%operation)) cycle
         deallocate (series)
         do i = 1, size(models)
            call add_series(series, marks_of("made('"//trim(model_name(models(i)))//"', "//value(k)//')'), &
                            mark_style(i, 0.7_wp), '')
         end do
         call add_series(series, marks_of('best('//value(k)//')'), best_look(), '')
         do i = 1, size(told)
            call add_series(series, marks_of("told('"//trim(told(i))//"', "//value(k)//')'), told_look(i), '')
         end do
         column = 1 + mod(drawn, 2)
         row = 1 + drawn/2
         drawn = drawn + 1
         call panel(lines, left(column), left(column) + wide, bottom(row), bottom(row) + tall, &
                    'solution time [s]', 'error of '//trim(names(k))//' [%]')
         call append_text(lines, "set autoscale y; set format xy '%g'")
         ! gnuplot fails at a panel without a number: one in which nothing converged, or no way differs, has axes of its own
         call append_text(lines, 'n = 0; set table $none')
         call append_text(lines, 'plot '//results_file('study')//' using (this('//value(k)//') > 0 ? (n = n + 1) : 0) with table')
         call append_text(lines, 'unset table; if (n == 0) { set xrange [0.1:1]; set yrange [0.1:1] }')
         call plot(lines, series)
      end do
      call end_script(lines)

   contains

      pure function value(k) result(text)
         integer, intent(in) :: k
         character(:), allocatable :: text
         text = "column('"//trim(columns(k))//"')"
      end function value

      pure function marks_of(expression) result(using)
         character(*), intent(in) :: expression
         character(:), allocatable :: using
         using = results_file('study')//" using (column('seconds')):("//expression//')'
      end function marks_of
   end subroutine study_script

   !> Around the mark of the model.
   pure function told_look(number) result(look)
      integer, intent(in) :: number
      character(:), allocatable :: look
      look = 'with points pt '//to_text(told_marks(number))//" ps 1.6 lw 1.0 lc rgb '"//colour_black//"'"
   end function told_look

   pure function best_look() result(look)
      character(:), allocatable :: look
      look = "with points pt 6 ps 1.5 lw 1.0 lc rgb '"//colour_black//"'"
   end function best_look
end module dg_study_picture

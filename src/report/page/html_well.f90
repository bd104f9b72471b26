!> Well and string in short, beside the place of the chart that stands on the first printed page.
module dg_html_well
   use dg_kinds, only: wp
   use dg_component, only: component_type
   use dg_drillstring, only: component_tops
   use dg_html_text, only: number_cell, said, said_number, switched
   use dg_job, only: job_type
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_model, only: model_type, string_index
   use dg_quantity, only: system_base
   use dg_run_outcome, only: outcome_type, swept_type
   use dg_text, only: either, text_type, to_text
   use dg_trajectory, only: bottom_md, top_md
   use dg_unit_kind, only: unit_diameter, unit_factor, unit_label, unit_length, unit_mass
   use dg_units, only: system_of, unit_system_type
   use dg_well_head, only: well_head
   implicit none
   private
   public :: append_well, shown_rows

   integer, parameter :: digits = 5
   !> Rows of a string; the first page has no room for more.
   integer, parameter :: most_rows = 15, most_swept = 3

contains

   !> Sentences on the well and its strings, a table of one string, the place of a chart.
   subroutine append_well(lines, job, model, outcome, shown, level)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      type(model_type), intent(in) :: model
      type(outcome_type), intent(in) :: outcome
      integer, intent(in) :: shown            !< load case of the string and the chart; 0: none
      character(*), intent(in) :: level       !< of the heading
      type(text_type), allocatable :: head(:), in_system(:), systems(:, :)
      logical :: own, swept
      integer :: i, k
      swept = allocated(outcome%swept) .and. size(model%cases) == 0
      own = swept
      if (own) own = all([(outcome%swept(i)%frictions /= '', i=1, size(outcome%swept))])
      allocate (head, source=well_head(job%units, model, own_friction=own))
      allocate (systems(system_base - 1, size(head)))
      do k = 1, size(systems, 1)
         in_system = well_head(system_of(k), model, own_friction=own)
         do i = 1, size(head)
            systems(k, i)%text = in_system(i)%text//'.'
         end do
      end do
      call add_line(lines, '<div class="head"><div><'//level//'>Well and string</'//level//'>')
      do i = 1, size(head)
         call add_line(lines, '<p'//said(head(i)%text//'.', systems(:, i))//'>'//html_safe(head(i)%text)//'.</p>')
      end do
      if (swept) call append_swept(lines, job%units, outcome%swept)
      if (shown > 0) then
         call append_string(lines, job%units, model, string_index(model%strings, model%cases(shown)%string), &
                            model%cases(shown)%bit_depth)
      else if (swept) then
         call append_string(lines, job%units, model, string_index(model%strings, outcome%swept(1)%string), &
                            outcome%swept(1)%deepest)
      else
         call append_string(lines, job%units, model, 1, bottom_md(model%trajectory))
      end if
      call add_line(lines, '</div><div class="first live"></div></div>')
   end subroutine append_well

   !> A sentence on each of the first sweeps: how deep, with which friction.
   subroutine append_swept(lines, units, swept)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(swept_type), intent(in) :: swept(:)
      integer :: i
      do i = 1, min(size(swept), most_swept)
         call add_line(lines, '<p>Sweep '//html_safe(swept(i)%name)//': bit down to '// &
                       said_number(units, unit_length, swept(i)%deepest, digits)// &
                       either('', ', friction factor '//swept(i)%frictions, swept(i)%frictions == '')//'.</p>')
      end do
   end subroutine append_swept

   !> Rows that the table of a load case's string has at most.
   pure function shown_rows(model, shown) result(rows)
      type(model_type), intent(in) :: model
      integer, intent(in) :: shown            !< the load case; 0: none
      integer :: rows, number
      number = 1
      if (shown > 0) number = string_index(model%strings, model%cases(shown)%string)
      rows = min(size(model%strings(number)%components), most_rows)
   end function shown_rows

   !> Components of a string in the hole from the bit upwards: name, length, diameter, mass per length.
   subroutine append_string(lines, units, model, number, bit)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(model_type), intent(in) :: model
      integer, intent(in) :: number           !< of the string
      real(wp), intent(in) :: bit             !< measured depth [m]
      real(wp) :: tops(size(model%strings(number)%components)), lengths(size(tops))
      character(:), allocatable :: name
      integer :: i, last
      tops = component_tops(model%strings(number), bit - top_md(model%trajectory))
      lengths = tops - [0.0_wp, tops(:size(tops) - 1)]
      last = findloc(lengths > 0.0_wp, .true., dim=1, back=.true.)
      name = ''
      if (size(model%strings) > 1) name = ' '//html_safe(model%strings(number)%name)
      call add_line(lines, '<table><caption>String'//name//' from the bit at '// &
                       said_number(units, unit_length, bit, digits)//' upwards</caption>')
      call add_line(lines, '<thead><tr><th class="text" scope="col">component</th>'//head_cell('length', unit_length)// &
                       head_cell('od', unit_diameter)//head_cell('mass', unit_mass)//'</tr></thead><tbody>')
      do i = 1, min(last, most_rows)
         call append_component(lines, units, model%strings(number)%components(i), lengths(i))
      end do
      if (last > most_rows) call add_line(lines, '<tr><td class="text">'//to_text(last - most_rows)//' more</td>'// &
                                          cell(units, unit_length, tops(last) - tops(most_rows))//'<td></td><td></td></tr>')
      call add_line(lines, '</tbody></table>')
   contains
      pure function head_cell(heading, quantity) result(text)
         character(*), intent(in) :: heading
         integer, intent(in) :: quantity
         character(:), allocatable :: text
         text = '<th scope="col"'//switched(quantity)//' data-digits="'//to_text(digits)//'">'//heading//'<br><small>'// &
                html_safe(unit_label(units, quantity))//'</small></th>'
      end function head_cell
   end subroutine append_string

   subroutine append_component(lines, units, component, length)
      type(line_list_type), intent(inout) :: lines
      type(unit_system_type), intent(in) :: units
      type(component_type), intent(in) :: component
      real(wp), intent(in) :: length          !< in the hole [m]
      call add_line(lines, '<tr><td class="text long">'//html_safe(component%name)//'</td>'//cell(units, unit_length, length)// &
                       cell(units, unit_diameter, component%od)//cell(units, unit_mass, component%mass)//'</tr>')
   end subroutine append_component

   !> A number of a table.
   pure function cell(units, quantity, value) result(text)
      type(unit_system_type), intent(in) :: units
      integer, intent(in) :: quantity
      real(wp), intent(in) :: value           !< [SI]
      character(:), allocatable :: text
      text = number_cell(value/unit_factor(units, quantity), to_text(value/unit_factor(units, quantity), digits), quantity)
   end function cell
end module dg_html_well

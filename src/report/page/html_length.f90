!> Change of length and force on the packer, on the page: a row for each load case whose deck asks for them.
module dg_html_length
   use dg_findings, only: findings_type
   use dg_html_text, only: said
   use dg_job, only: leading_model
   use dg_kinds, only: wp
   use dg_length_change, only: total_change
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_missing, only: optional_real
   use dg_number_text, only: fixed_text
   use dg_quantity, only: system_base
   use dg_text, only: text_type
   use dg_unit_kind, only: in_units, unit_force
   use dg_units, only: system_of, unit_system_type
   implicit none
   private
   public :: append_lengths

   !> Digits of a force, decimals of a length. A shorter change is zero.
   integer, parameter :: force_digits = 4, decimals = 3

contains

   !> Append the table, by the leading model. Words say the direction: longer or shorter, up or down.
   subroutine append_lengths(lines, found)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      character(:), allocatable :: against
      logical :: shown(size(found%results)), held
      integer :: k
      shown = found%results%model == leading_model(found%job) .and. &
              (found%wholes%length_change%present .or. found%wholes%packer_force%present)
      if (.not. any(shown)) return
      held = any(shown .and. found%wholes%packer_force%present)
      call add_line(lines, '<h2>Change of length'//trim(merge(' and force on the packer', '                        ', held))// &
                       '</h2><div class="wide" tabindex="0"><table><thead><tr>'//head('case')//head('against')// &
                       head('change of length')//head('by force')//head('by pressure')//head('by buckling')// &
                       head('by temperature'))
      if (held) call add_line(lines, head('force on the packer'))
      call add_line(lines, '</tr></thead><tbody>')
      do k = 1, size(found%results)
         if (.not. shown(k)) cycle
         associate (load_case => found%model%cases(found%results(k)%case_index), change => found%wholes(k)%length_change)
            against = 'string before it was run'
            if (load_case%length_reference > 0) against = found%model%cases(load_case%length_reference)%name
            call add_line(lines, '<tr><td class="text">'//html_safe(load_case%name)//'</td><td class="text">'// &
                             html_safe(against)//'</td>'//length_cell(total_change(change))//length_cell(change%force)// &
                             length_cell(change%pressure)//length_cell(change%buckling)//length_cell(change%temperature))
            if (held) call add_line(lines, force_cell(found%wholes(k)%packer_force))
            call add_line(lines, '</tr>')
         end associate
      end do
      call add_line(lines, '</tbody></table></div>')
   contains
      pure function head(title) result(cell)
         character(*), intent(in) :: title
         character(:), allocatable :: cell
         cell = '<th class="text" scope="col">'//title//'</th>'
      end function head

      pure function length_cell(length) result(cell)
         real(wp), intent(in) :: length   !< [m]
         character(:), allocatable :: cell
         type(text_type) :: systems(system_base - 1)
         integer :: i
         do i = 1, size(systems)
            systems(i)%text = length_text(system_of(i), length)
         end do
         cell = said_cell(length_text(found%job%units, length), systems)
      end function length_cell

      pure function force_cell(force) result(cell)
         type(optional_real), intent(in) :: force   !< [N]
         character(:), allocatable :: cell
         type(text_type) :: systems(system_base - 1)
         integer :: i
         cell = '<td>&ndash;</td>'
         if (.not. force%present) return
         do i = 1, size(systems)
            systems(i)%text = packer_text(system_of(i), force%value)
         end do
         cell = said_cell(packer_text(found%job%units, force%value), systems)
      end function force_cell

      !> A cell with its text in the units of the run, and in those that a click brings.
      pure function said_cell(here, systems) result(cell)
         character(*), intent(in) :: here
         type(text_type), intent(in) :: systems(:)
         character(:), allocatable :: cell
         cell = '<td class="text"'//said(here, systems)//'>'//here//'</td>'
      end function said_cell
   end subroutine append_lengths

   !> A change of length with its direction.
   pure function length_text(units, length) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: length   !< longer is positive [m]
      character(:), allocatable :: text
      text = fixed_text(abs(length)/units%length, decimals)
      if (verify(text, '0.') == 0) then
         text = '0'
      else
         text = text//' '//trim(units%length_label)//trim(merge(' longer ', ' shorter', length > 0.0_wp))
      end if
   end function length_text

   !> Force on the packer with its direction.
   pure function packer_text(units, force) result(text)
      type(unit_system_type), intent(in) :: units
      real(wp), intent(in) :: force    !< weight set down is positive [N]
      character(:), allocatable :: text
      text = '0'
      if (abs(force) > 0.0_wp) text = in_units(units, unit_force, abs(force), force_digits)// &
                                      trim(merge(' down', ' up  ', force > 0.0_wp))
   end function packer_text
end module dg_html_length

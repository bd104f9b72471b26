!> report.html: one page of a run that can be mailed and opened anywhere. It has answers, results, limits, warnings, pictures,
!> assumptions and the deck. It refers to no other file.
module dg_html_report
   use dg_design_factors, only: design_factors_type
   use dg_error, only: error_type
   use dg_file_system, only: write_text_file
   use dg_findings, only: findings_type, name_of, rows_of
   use dg_html_length, only: append_lengths
   use dg_html_outcome, only: append_lost, append_outcome
   use dg_html_pictures, only: append_pictures
   use dg_html_short, only: append_short
   use dg_html_style, only: append_style
   use dg_html_text, only: append_preformatted, append_table
   use dg_html_verdict, only: append_verdicts
   use dg_kinds, only: wp
   use dg_job, only: job_type, leading_model, model_mcge, model_mixed, model_name, model_rigid, model_soft
   use dg_limits_file, only: limits_row
   use dg_line_list, only: add_line, line_list_type
   use dg_markup, only: html_safe
   use dg_picture_list, only: picture_list_type
   use dg_column, only: row_type
   use dg_results_h5, only: time_stamp
   use dg_page_data, only: append_page_data, governing_case
   use dg_page_figures, only: is_live
   use dg_page_script, only: script_hash, script_lines
   use dg_printed_text, only: printed_text_type
   use dg_run_outcome, only: case_part, outcome_type
   use dg_summary_file, only: summary_row
   use dg_table_1, only: page_columns
   use dg_readable, only: first_names
   use dg_text, only: append_text, either, text_type, to_text
   use dg_unchecked_text, only: components_without_yield
   use dg_verdict, only: answer_yes
   use dg_version, only: program_name, program_version
   use dg_warnings_table, only: warning_sentences, warnings_heading
   implicit none
   private
   public :: write_html_report

   !> Columns of summary.csv and limits.csv in the other tables of the page; the files have all.
   character(*), parameter :: cost_shown(*) = [character(16) :: 'case', 'status', 'iterations', 'elements', 'gaps_free', &
      'gaps_elastic', 'gaps_rigid', 'flips', 'equilibrium', 'seconds']
   character(*), parameter :: limits_shown(*) = [character(25) :: 'case', 'stretch', 'windup', 'neutral_top', &
      'least_safety_factor', 'overpull_margin', 'buckling', 'buckling_margin', 'buckling_margin_md', 'wob_buckling', &
      'wob_no_hookload', 'wob_lockup', 'rig_margin', 'makeup_margin', 'length_change', 'length_change_force', &
      'length_change_pressure', 'length_change_buckling', 'length_change_temperature', 'packer_force', 'casing_wear', &
      'casing_wear_md', 'casing_wall_left', 'casing_burst_left', 'casing_collapse_left', &
      'fatigue_used', 'fatigue_md', 'fatigue_turns', 'fatigue_damage', 'fatigue_dogleg', 'yield_left', 'used_joint_tension', &
      'used_joint_compression', 'used_joint_burst', 'used_joint_collapse', 'used_joint_dogleg', 'joint_fatigue_used', &
      'joint_fatigue_md', 'joint_fatigue_turns', 'joint_fatigue_damage', 'joint_fatigue_dogleg']
   character(*), parameter :: most_shown(*) = [character(22) :: 'case', 'governing_limit', 'governing_utilisation', &
      'governing_md', 'largest_von_mises', 'largest_bending', 'largest_bending_md', 'largest_side_force', &
      'largest_side_force_md', 'bit_side_force', 'bit_side_clock', 'bit_tilt', 'sag_correction', 'shape', &
      'snaking_length', 'coiled_length', 'coil_turns']
   !> Of these columns, those up to here are for all models; the others are for gap elements only.
   integer, parameter :: most_of_all_models = 12
   integer, parameter :: few = 4    !< digits

contains

   !> Write the page into the output folder: answers, results, warnings, charts of the load case nearest to a limit. All else
   !> is folded. `printed` has the tables of studies and the outcome of all solutions. `echo` is the summary of the deck, line
   !> by line.
   subroutine write_html_report(found, printed, pictures, echo, error)
      type(findings_type), intent(in) :: found
      type(printed_text_type), intent(in) :: printed
      type(picture_list_type), intent(in) :: pictures
      type(text_type), intent(in) :: echo(:)
      type(error_type), allocatable, intent(out) :: error
      type(line_list_type) :: lines
      integer :: shown, i
      shown = governing_case(found)
      call start_page(found%job, lines)
      call append_verdicts(lines, found, printed%outcome, shown)
      if (size(found%results) > 0) call append_results(lines, found)
      call append_lengths(lines, found)
      call append_warnings(lines, found)
      call append_outcome(lines, found%job%units, printed%outcome)
      if (allocated(found%model%path_notes)) then
         do i = 1, size(found%model%path_notes)
            call add_line(lines, '<p class="note">Path: '//html_safe(found%model%path_notes(i)%text)//'</p>')
         end do
      end if
      call append_lost(lines, found%job%units, printed%outcome)
      call append_short(lines, found, printed%outcome)
      if (shown > 0) call add_line(lines, '<div class="printed depths"></div>')
      call append_pictures(lines, found, pictures, shown)
      if (size(found%results) > 0) then
         call open_fold(lines, 'Limits', on_paper=.true.)
         call append_limits(lines, found)
         call close_fold(lines)
      end if
      if (allocated(printed%lines)) then
         if (size(printed%lines) > 0) then
            call open_fold(lines, html_safe(studies_heading(printed%outcome)), on_paper=.false.)
            call append_preformatted(lines, printed%lines)
            call close_fold(lines)
         end if
      end if
      call open_fold(lines, 'What was computed', on_paper=.true.)
      call append_preformatted(lines, echo)
      call append_assumptions(lines, found%job)
      call close_fold(lines)
      if (size(found%results) > 0) then
         call open_fold(lines, 'How it was solved', on_paper=.false.)
         call append_costs(lines, found)
         call close_fold(lines)
      end if
      call open_fold(lines, 'Deck', on_paper=.false.)
      call append_deck(lines, found%job%deck_text)
      call close_fold(lines)
      call add_line(lines, '</main>')
      if (shown > 0 .or. any(is_live(pictures%pictures))) then
         call append_page_data(lines, found, pictures, shown)
         call append_script(lines)
      end if
      call add_line(lines, '</body></html>')
      call write_text_file(found%job%output_dir//'/report.html', lines%lines(:lines%count), error)
   end subroutine write_html_report

   !> Heading of the tables of studies, with the names of the first ones.
   pure function studies_heading(outcome) result(text)
      type(outcome_type), intent(in) :: outcome
      character(:), allocatable :: text
      integer, parameter :: most_names = 4
      type(text_type), allocatable :: names(:)
      integer :: i
      text = 'Studies and comparisons'
      if (.not. allocated(outcome%parts)) return
      allocate (names(0))
      do i = 1, size(outcome%parts)
         if (outcome%parts(i)%name /= case_part) call append_text(names, outcome%parts(i)%name)
      end do
      if (size(names) > 0) text = text//': '//first_names(names, most_names)
   end function studies_heading

   !> Begins a part of the page that is folded: its heading opens it. On paper the script opens those that are wanted there.
   subroutine open_fold(lines, heading, on_paper)
      type(line_list_type), intent(inout) :: lines
      character(*), intent(in) :: heading
      logical, intent(in) :: on_paper
      call add_line(lines, '<details class="fold'//either(' on-paper', '', on_paper)//'"><summary>'// &
                       heading//'</summary>')
   end subroutine open_fold

   subroutine close_fold(lines)
      type(line_list_type), intent(inout) :: lines
      call add_line(lines, '</details>')
   end subroutine close_fold

   !> The script of the page. Its text is what the policy of the page names by its hash.
   subroutine append_script(lines)
      type(line_list_type), intent(inout) :: lines
      integer :: i
      do i = 1, size(script_lines)
         call add_line(lines, trim(merge('<script>', '        ', i == 1))//trim(script_lines(i))// &
                          trim(merge('</script>', '         ', i == size(script_lines))))
      end do
   end subroutine append_script

   !> Head of the page: title, time and program.
   subroutine start_page(job, lines)
      type(job_type), intent(in) :: job
      type(line_list_type), intent(out) :: lines
      character(:), allocatable :: title, stamp
      title = job%title
      if (title == '') title = job%deck_path
      call add_line(lines, '<!DOCTYPE html>')
      call add_line(lines, '<html lang="en"><head><meta charset="utf-8">')
      call add_line(lines, '<meta name="viewport" content="width=device-width, initial-scale=1">')
      call add_line(lines, '<meta http-equiv="Content-Security-Policy" content="default-src ''none''; '// &
                       'style-src ''unsafe-inline''; img-src data:; script-src ''sha256-'//script_hash//'''">')
      call add_line(lines, '<title>'//html_safe(title)//'</title>')
      stamp = time_stamp()
      call append_style(lines, title, program_name//' '//program_version//', '//stamp)
      call add_line(lines, '</head><body><main>')
      call add_line(lines, '<h1>'//html_safe(title)//'</h1>')
      call add_line(lines, '<p>Torque and drag by '//program_name//' '//program_version//', '//html_safe(stamp)// &
                       ', deck '//html_safe(job%deck_path)//', units '//trim(job%units%name)//'.</p>')
      call add_line(lines, '<p class="note switched" hidden="">Answers, charts and tables show the units chosen. Warnings, '// &
                       'printed text and the deck keep '//trim(job%units%name)//' units.</p>')
   end subroutine start_page

   !> Notes on the deck, then messages of load cases, those without a solution first. Beside a NO 'no warnings' would mislead.
   subroutine append_warnings(lines, found)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(text_type), allocatable :: sentences(:)
      integer :: i
      allocate (sentences, source=warning_sentences(found))
      if (size(sentences) == 0) then
         if (all(found%wholes%verdict%answer == answer_yes)) call add_line(lines, '<p>No warnings on deck and load cases.</p>')
         return
      end if
      call add_line(lines, '<h2>'//warnings_heading(sentences)//'</h2><ul>')
      do i = 1, size(sentences)
         call add_line(lines, '<li>'//html_safe(sentences(i)%text)//'</li>')
      end do
      call add_line(lines, '</ul>')
   end subroutine append_warnings

   !> A table a model.
   subroutine append_results(lines, found)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      call add_line(lines, '<h2>Hook load, friction, torque</h2>')
      call add_line(lines, '<p>friction = buoyed weight along the hole &minus; wob &minus; axial force at the top: negative '// &
                    'going up, positive going down. Axial forces are effective (buoyed), tension positive.</p>')
      if (any(found%model%cases%measured_hookload%present .or. found%model%cases%reference_hookload%present)) call add_line(lines, &
         '<p>error: difference between calculated and measured '// &
         trim(merge('weight indicator', 'hook load       ', found%model%rig%given))//', in percent of the measured value. '// &
         'reference error: the same for the reference hook load.</p>')
      if (found%model%rig%given) call add_line(lines, '<p>hook load: of the string, without the block. weight indicator: with '// &
         'block_weight of &amp;rig.</p>')
      call append_summary(lines, found, page_columns)
   end subroutine append_results

   !> Those columns of summary.csv and limits.csv, a table a model. That of the leading model stands first and open.
   subroutine append_summary(lines, found, shown)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      character(*), intent(in) :: shown(:)
      type(row_type), allocatable :: fields(:)
      type(row_type) :: limits
      integer, allocatable :: rows(:)
      integer :: models(size(found%job%models)), i, k
      models = [leading_model(found%job), pack(found%job%models, found%job%models /= leading_model(found%job))]
      do k = 1, size(models)
         rows = rows_of(found, models(k))
         if (allocated(fields)) deallocate (fields)
         allocate (fields(size(rows)))
         do i = 1, size(rows)
            fields(i) = summary_row(found%model%cases(found%results(rows(i))%case_index), found%results(rows(i)), &
                                    found%wholes(rows(i))%verdict, found%job%units)
            limits = limits_row('', found%results(rows(i)), found%wholes(rows(i)))
            fields(i)%fields = [fields(i)%fields(:fields(i)%count), limits%fields(:limits%count)]
            fields(i)%count = size(fields(i)%fields)
         end do
         if (k > 1) call open_fold(lines, 'Model '//trim(model_name(models(k))), on_paper=.false.)
         if (k == 1 .and. size(models) > 1) call add_line(lines, '<h3>Model '//trim(model_name(models(k)))//'</h3>')
         call append_table(lines, shown, found%job%units, fields, &
                           found%wholes(rows)%verdict%answer /= answer_yes)
         if (k > 1) call close_fold(lines)
      end do
   end subroutine append_summary

   !> Append the limits of the string, one table per model.
   subroutine append_limits(lines, found)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      type(row_type), allocatable :: fields(:)
      integer, allocatable :: rows(:)
      logical, allocatable :: marked(:)
      character(:), allocatable :: left_out
      integer :: i, k, columns
      left_out = components_without_yield(found%model)
      if (left_out /= '') left_out = ': they leave out '//left_out
      call add_line(lines, '<p>Buckling limits are published formulas without friction and torque. A negative margin is beyond '// &
                    'the limit. Safety factors need a yield strength in the deck'//html_safe(left_out)//'.</p>')
      call add_line(lines, '<p>Neutral point: the uppermost one, tension above, compression below. Overpull margin: pull '// &
                    'that may be added at the top until the pipe yields, bending included. Margin to rig limit: pull until '// &
                    'the limit of the rig. The smaller one counts. WOB at buckling, zero hook load and lock-up: the weight '// &
                    'on bit that would bring the moving string there. Load cases without WOB have these values, too. '// &
                    'Lock-up counts friction of helical buckling, zero hook load does not.</p>')
      call add_line(lines, '<p>Most used limit: of pipe, connections, slips and rig. String weight, lock-up and buckling '// &
                    'are not included. '//factors_text(found%model%design)//' Largest mean side force: over the length of a '// &
                    'joint of pipe. Bit side force: force of the bit on the formation. '// &
                    'Bit tilt: angle between bit and hole axis. Clock angles count from the high side.</p>')
      do k = 1, size(found%job%models)
         rows = rows_of(found, found%job%models(k))
         rows = pack(rows, [(allocated(found%results(rows(i))%profile%md), i=1, size(rows))])
         if (allocated(fields)) deallocate (fields)
         allocate (fields(size(rows)))
         do i = 1, size(rows)
            fields(i) = limits_row(name_of(found, rows(i)), found%results(rows(i)), found%wholes(rows(i)))
         end do
         call add_line(lines, '<h3>Model '//trim(model_name(found%job%models(k)))//'</h3>')
         marked = found%wholes(rows)%verdict%answer /= answer_yes
         call append_table(lines, limits_shown, found%job%units, fields, marked)
         columns = size(most_shown)
         if (found%job%models(k) /= model_mcge) columns = most_of_all_models
         call append_table(lines, most_shown(:columns), found%job%units, fields, marked)
      end do
   end subroutine append_limits

   !> Factors on loads before they are compared with strengths.
   pure function factors_text(design) result(text)
      type(design_factors_type), intent(in) :: design
      character(:), allocatable :: text
      real(wp) :: factors(5)
      factors = [design%von_mises, design%tension, design%torsion, design%burst, design%collapse]
      if (all(abs(factors - 1.0_wp) <= 0.0_wp)) then
         text = 'All design factors are 1.'
      else
         text = 'Design factors: von Mises '//to_text(factors(1), few)//', tension and slips '//to_text(factors(2), few)// &
                ', torsion '//to_text(factors(3), few)//', burst '//to_text(factors(4), few)//', collapse '// &
                to_text(factors(5), few)//'.'
      end if
   end function factors_text

   !> Append the assumptions of every result, and those that each model adds.
   subroutine append_assumptions(lines, job)
      type(line_list_type), intent(inout) :: lines
      type(job_type), intent(in) :: job
      call add_line(lines, '<h3>Assumptions</h3><ul>')
      call add_line(lines, '<li>Static: no vibration, no stick-slip. The mud stands still: no flow, no heat.</li>')
      call add_line(lines, '<li>Coulomb friction with the factors above. The hole is round, its axis as surveyed.</li>')
      call add_line(lines, '<li>Pipe bends elastically with the stiffness of its body. Safety factors need a yield '// &
                       'strength.</li>')
      if (any(job%models == model_mcge)) call add_line(lines, '<li>mcge: nonlinear beams with contact gap elements after '// &
         'Liu, Ding &amp; Zhang (2002). The contact points are found.</li>')
      if (any(job%models == model_soft)) call add_line(lines, '<li>soft: a string without bending stiffness that lies on '// &
         'the wall everywhere (Johancsik, Friesen &amp; Dawson 1984).</li>')
      if (any(job%models == model_rigid)) call add_line(lines, '<li>rigid: a stiff string that follows the axis of the hole '// &
         '(Ho 1988).</li>')
      if (any(job%models == model_mixed)) call add_line(lines, '<li>mixed: stiff where stiffness or curvature matters, soft '// &
         'elsewhere (Ma &amp; Han 1996).</li>')
      call add_line(lines, '</ul>')
   end subroutine append_assumptions

   !> Append the course of the solutions, one table per model.
   subroutine append_costs(lines, found)
      type(line_list_type), intent(inout) :: lines
      type(findings_type), intent(in) :: found
      call add_line(lines, '<p>equilibrium: what is left of the sum of all forces on the string, supports included.</p>')
      call append_summary(lines, found, cost_shown)
   end subroutine append_costs

   !> The deck's text, line by line.
   subroutine append_deck(lines, text)
      type(line_list_type), intent(inout) :: lines
      character(:), allocatable, intent(in) :: text    !< every line ends with a new line
      type(text_type), allocatable :: deck(:)
      integer :: first, length, n, i
      if (.not. allocated(text)) return
      n = 0
      do i = 1, len(text)
         if (text(i:i) == new_line('a')) n = n + 1
      end do
      allocate (deck(n))
      first = 1
      do i = 1, n
         length = index(text(first:), new_line('a')) - 1
         deck(i)%text = text(first:first + length - 1)
         first = first + length + 1
      end do
      call append_preformatted(lines, deck)
   end subroutine append_deck
end module dg_html_report

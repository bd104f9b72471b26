!> Question whether hook loads were measured without the block, where the deck has a rig.
module dg_block_question
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_converged
   use dg_load_case, only: block_way, load_case_type, moves_axially
   use dg_missing, only: is_missing
   use dg_unit_kind, only: in_units, unit_force
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: block_question

   !> Largest part of the block's share of the indicator by which one case, and all on average, may be off [-].
   real(wp), parameter :: one_off = 0.5_wp, all_off = 0.25_wp
   !> Digits of a force.
   integer, parameter :: shown = 3

contains

   !> Question where all measured loads are below the weight indicator by about the block weight; '' else. Wrong friction cannot
   !> make both pick-up and slack-off too low, nor the load of a string that does not move along the hole. Nor can it lower a
   !> pick-up by more than all of its drag.
   pure function block_question(units, cases, results) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: cases(:)
      type(case_result_type), intent(in) :: results(:)     !< as many
      character(:), allocatable :: text
      logical :: counted(size(cases)), both_ways
      real(wp) :: lacking(size(cases)), block(size(cases))
      integer :: n
      text = ''
      counted = cases%measured_hookload%present .and. results%status == result_converged .and. &
                .not. is_missing(results%weight_indicator)
      n = count(counted)
      if (n == 0) return
      block = results%weight_indicator - results%hookload
      lacking = results%weight_indicator - cases%measured_hookload%value
      if (any(counted .and. .not. abs(lacking - block) < one_off*block)) return
      if (.not. abs(sum(lacking - block, counted)) < all_off*sum(block, counted)) return
      both_ways = any(counted .and. block_way(cases%operation) > 0) .and. any(counted .and. block_way(cases%operation) < 0)
      if (.not. (both_ways .or. any(counted .and. .not. moves_axially(cases%operation)) .or. &
                 any(counted .and. block_way(cases%operation) > 0 .and. lacking > abs(results%friction)))) return
      text = 'Measured hook loads are '//in_units(units, unit_force, sum(lacking, counted)/n, shown)// &
             ' below the weight indicator on average, and the block adds '// &
             in_units(units, unit_force, sum(block, counted)/n, shown)//' to it. Were they measured without the block? '// &
             'Then add block_weight to measured_hookload'
   end function block_question
end module dg_block_question

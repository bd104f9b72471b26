!> Sentences on what brings a string down: its weight, and a push at surface. They have no full stop at their end.
module dg_push_text
   use dg_kinds, only: wp
   use dg_load_case, only: block_way, load_case_type, operation_static
   use dg_load_text, only: force_text, sum_texts, sum_width
   use dg_text, only: either
   use dg_units, only: unit_system_type
   use dg_verdict, only: limit_string_weight, verdict_type
   implicit none
   private
   public :: push_text, weight_text, is_by_push

contains

   !> Push needed at surface by a string whose weight is too little, and the largest one of the rig.
   pure function push_text(units, load_case, verdict) result(text)
      type(unit_system_type), intent(in) :: units
      type(load_case_type), intent(in) :: load_case
      type(verdict_type), intent(in) :: verdict
      character(:), allocatable :: text
      character(sum_width) :: sums(3)      ! needed, possible, their difference
      sums(1) = force_text(units, verdict%push)
      if (verdict%max_push > 0.0_wp) sums = sum_texts(units, limit_string_weight, verdict%push, verdict%max_push)
      text = trim(sums(1))//' of push needed at surface'
      if (load_case%operation == operation_static .or. block_way(load_case%operation) > 0) &
         text = 'the top must be held down with '//trim(sums(1))
      if (verdict%max_push > 0.0_wp) text = text//', '//trim(sums(2))//' possible'
   end function push_text

   !> Subject and verb of a sentence: 'string weight brings', or 'string weight and push bring' for a rig that can push.
   pure function weight_text(verdict, one, many) result(text)
      type(verdict_type), intent(in) :: verdict
      character(*), intent(in) :: one, many      !< verb of string weight alone, and with a push
      character(:), allocatable :: text
      text = 'string weight '//either('and push '//many, one, verdict%max_push > 0.0_wp)
   end function weight_text

   !> True for a string that needs a push, and a rig that has one. It may be too small.
   pure function is_by_push(verdict) result(is)
      type(verdict_type), intent(in) :: verdict
      logical :: is
      is = verdict%push > 0.0_wp .and. verdict%max_push > 0.0_wp
   end function is_by_push
end module dg_push_text

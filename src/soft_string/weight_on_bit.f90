!> How much weight reaches the bit, by the soft string: a search with beams would cost a hundred solutions.
module dg_weight_on_bit
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_soft_string_loads, only: soft_string_at, soft_totals_type
   use dg_trajectory, only: top_md
   implicit none
   private
   public :: most_weight_on_bit

   !> Halvings of the bracket: to 1e-10 of it. Doublings until it is one: from 1 kN to more than any string weighs.
   integer, parameter :: halvings = 34, doublings = 30
   real(wp), parameter :: first_guess = 1.0e3_wp

contains

   !> Greatest weight on bit [N] that leaves a hook load, or with `pushed` that any push at the top brings down; 0 where
   !> none does. With `coiled`, friction of a coiled string counts: without it nothing limits a push.
   pure function most_weight_on_bit(model, case_index, coiled, pushed) result(wob)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(in) :: coiled, pushed
      real(wp) :: wob
      real(wp) :: high, middle
      integer :: i
      wob = 0.0_wp
      if (.not. arrives(model, case_index, 0.0_wp, coiled, pushed)) return
      high = first_guess
      do i = 1, doublings
         if (.not. arrives(model, case_index, high, coiled, pushed)) exit
         wob = high
         high = 2.0_wp*high
      end do
      if (i > doublings) return
      do i = 1, halvings
         middle = 0.5_wp*(wob + high)
         if (arrives(model, case_index, middle, coiled, pushed)) then
            wob = middle
         else
            high = middle
         end if
      end do
   end function most_weight_on_bit

   !> Whether a weight [N] reaches the bit.
   pure function arrives(model, case_index, wob, coiled, pushed) result(yes)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: wob
      logical, intent(in) :: coiled, pushed
      logical :: yes
      type(soft_totals_type) :: totals
      real(wp) :: axial(1), torque(1), contact(3, 1)
      call soft_string_at(model, case_index, [top_md(model%trajectory)], axial, torque, contact, totals=totals, coiled=coiled, &
                          wob=wob)
      yes = .not. totals%runaway .and. (pushed .or. axial(1) >= 0.0_wp)
   end function arrives
end module dg_weight_on_bit

!> Words on friction in the sentences of a verdict: the factor up to which an answer is yes.
module dg_friction_text
   use dg_kinds, only: wp
   use dg_rounding, only: rounded_down
   use dg_text, only: either, to_text
   use dg_verdict, only: friction_given, limit_string_weight, limit_title, little_reserve, verdict_type
   implicit none
   private
   public :: reserve_text, times_text

   !> Digits of factors, and of a factor next to 1.
   integer, parameter :: shown_factor = 3, close_factor = 4
   !> Most friction factors in a sentence.
   integer, parameter :: most_frictions = 3
   !> Friction reserve below which the text has no factor [-]. Reserves are found to 0.001, rounded down.
   real(wp), parameter :: no_reserve = 1.001_wp
   !> Factor of friction below 1 from which on it has more digits [-].
   real(wp), parameter :: nearly_one = 0.99_wp

contains

   !> Effect of more friction on a yes, from the verb on.
   pure function reserve_text(verdict) result(text)
      type(verdict_type), intent(in) :: verdict      !< with a friction reserve
      character(:), allocatable :: text
      text = 'becomes NO '
      if (verdict%friction_reserve%value < no_reserve) then
         text = text//'already with 0.2 % more friction'
      else
         text = text//'above about '//times_text(verdict, verdict%friction_reserve%value)
      end if
      if (verdict%reserve_limit > 0) text = text//', by '//trim(limit_title(verdict%reserve_limit))// &
         either(' and push', '', verdict%reserve_limit == limit_string_weight .and. verdict%max_push > 0.0_wp)
      if (verdict%reserve_buckles) text = text//', perhaps sooner, as pipe buckles then'
   end function reserve_text

   !> A factor of friction, rounded down: with it the answer is yes. Behind it stand the friction factors themselves.
   pure function times_text(verdict, factor) result(text)
      type(verdict_type), intent(in) :: verdict
      real(wp), intent(in) :: factor       !< > 0 [-]
      character(:), allocatable :: text
      integer :: digits
      digits = merge(close_factor, shown_factor, factor > nearly_one .and. factor < little_reserve)
      text = to_text(rounded_down(factor, digits), digits)//' times '// &
             either('all friction factors', 'the calibrated friction', verdict%friction == friction_given)
      if (.not. allocated(verdict%frictions) .or. verdict%friction /= friction_given) return
      if (size(verdict%frictions) > 0 .and. size(verdict%frictions) <= most_frictions) &
         text = text//' ('//joined(verdict%frictions, rounded_down(factor, digits))//')'
   contains
      !> Friction factors times a factor.
      pure function joined(frictions, factor) result(list)
         real(wp), intent(in) :: frictions(:), factor      !< [-]
         character(:), allocatable :: list
         integer :: i
         list = ''
         do i = 1, size(frictions)
            list = list//either(', ', '', i > 1)//to_text(rounded_down(factor*frictions(i), shown_factor), shown_factor)
         end do
      end function joined
   end function times_text
end module dg_friction_text

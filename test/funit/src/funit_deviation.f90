!> Deviation of numbers from the values that a test expects: a test that passes reports the largest. State like that of the
!> exceptions: tests run one after another.
module funit_deviation
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: note_deviation, pop_deviation

   real(real64) :: worst_share = -1.0_real64  ! of what was allowed
   real(real64) :: worst = 0.0_real64         ! over the expected number; absolute where that is zero
   real(real64) :: allowed = 0.0_real64
   integer :: compared = 0

contains

   !> Notes one number that was compared; those that must be the same to the digit do not count.
   subroutine note_deviation(expected, actual, limit)
      real(real64), intent(in) :: expected
      real(real64), intent(in) :: actual
      real(real64), intent(in) :: limit      !< of the difference
      real(real64) :: scale
      if (.not. limit > 0.0_real64) return
      compared = compared + 1
      ! no quotient of numbers so small that it overflows: where floating-point traps are on, that would end the test
      if (limit <= sqrt(tiny(limit)) .or. abs(actual - expected) > sqrt(huge(limit))) return
      if (abs(actual - expected)/limit < worst_share) return
      worst_share = abs(actual - expected)/limit
      scale = 1.0_real64
      if (abs(expected) > limit) scale = abs(expected)
      worst = abs(actual - expected)/scale
      allowed = limit/scale
   end subroutine note_deviation

   !> Text on the deviations since the last call; '' if there are none.
   subroutine pop_deviation(text)
      character(:), allocatable, intent(out) :: text
      character(80) :: line
      text = ''
      if (compared > 0 .and. worst_share >= 0.0_real64) then
         write (line, '(a, es8.1, a, es8.1, a, i0, a)') 'worst deviation', worst, ' of', allowed, ' allowed, ', compared, &
            ' numbers compared'
         text = trim(line)
      end if
      worst_share = -1.0_real64
      compared = 0
   end subroutine pop_deviation
end module funit_deviation

!> A sidetrack: the survey of the hole that it leaves gives the stations above its own.
module dg_parent_survey
   use dg_constants, only: degree
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_minimum_curvature, only: dogleg_between
   use dg_model_fault, only: depth_words
   use dg_survey, only: tangent_of
   use dg_survey_check, only: at_surface, sharpest_tie
   use dg_survey_file, only: station_list_type
   use dg_text, only: to_text
   use dg_trajectory, only: interpolation_minimum_curvature, new_trajectory, position_at, trajectory_type
   use dg_unit_kind, only: in_units, unit_curvature
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: join_parent

   !> Angle between a parent and the first station of its sidetrack from which on they hardly belong together [rad].
   real(wp), parameter :: apart = 1.0_wp*degree
   integer, parameter :: few_digits = 3, curvature_digits = 4

contains

   !> Puts the stations of a parent that lie above the first one of a survey before these. `words` tells how many, and how the hole
   !> turns between the two. `failure` says why nothing was joined; else ''.
   subroutine join_parent(parent, units, stations, words, failure)
      type(station_list_type), intent(in) :: parent      !< without fault
      type(unit_system_type), intent(in) :: units        !< of the words
      type(station_list_type), intent(inout) :: stations !< without fault
      character(:), allocatable, intent(out) :: words, failure
      real(wp) :: first, turn, off
      integer :: n
      failure = ''
      words = ''
      first = stations%md(1)
      n = count(parent%md < first - at_surface)
      if (n == 0) then
         failure = 'the survey begins at '//depth_words(units, first)// &
                   ', and parent_file has no station above. Leave parent_file out'
         return
      end if
      turn = dogleg_between(tangent_of(parent%inclination(n), parent%azimuth(n)), &
                            tangent_of(stations%inclination(1), stations%azimuth(1)))
      words = to_text(n)//' stations of parent_file are taken, down to '//depth_words(units, parent%md(n))// &
              '. From there to the first one of the survey, at '//depth_words(units, first)// &
              ', the hole turns by '//to_text(turn/degree, few_digits)//' deg, '// &
              trim(in_units(units, unit_curvature, turn/(first - parent%md(n)), curvature_digits))
      off = angle_to_parent()
      if (off > apart) words = words//'. There the parent points '//to_text(off/degree, few_digits)// &
                               ' deg away from the first station'
      if (off > apart .or. turn > sharpest_tie*(first - parent%md(n))) words = words// &
         '. Warning: check that both surveys count depth from the same datum and azimuth from the same north'
      stations%md = [parent%md(:n), stations%md]
      stations%inclination = [parent%inclination(:n), stations%inclination]
      stations%azimuth = [parent%azimuth(:n), stations%azimuth]
      stations%lines = [spread(stations%lines(1), 1, n), stations%lines]

   contains

      !> Angle between the parent and the first station at its depth; 0 where the parent ends above [rad].
      function angle_to_parent() result(angle)
         real(wp) :: angle
         type(trajectory_type) :: path
         type(error_type), allocatable :: error
         real(wp) :: position(3), tangent(3)
         angle = 0.0_wp
         if (parent%md(size(parent%md)) < first) return
         call new_trajectory(path, parent%md, parent%inclination, parent%azimuth, interpolation_minimum_curvature, error)
         if (allocated(error)) return
         call position_at(path, first, position, tangent)
         angle = dogleg_between(tangent, tangent_of(stations%inclination(1), stations%azimuth(1)))
      end function angle_to_parent
   end subroutine join_parent
end module dg_parent_survey

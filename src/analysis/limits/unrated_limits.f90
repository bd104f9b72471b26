!> Limits that apply to a load case and have no rating in the deck.
module dg_unrated_limits
   use dg_kinds, only: wp
   use dg_component, only: is_coiled_tubing
   use dg_connection_rating, only: is_rated
   use dg_drillstring, only: component_tops, topmost
   use dg_fatigue_curve, only: fatigue_none
   use dg_load_case, only: rotates
   use dg_model, only: hold_fixed, hold_free, is_straightened, model_type, string_index
   use dg_trajectory, only: top_md
   use dg_utilisation, only: has_joint_rating, has_rating, joint_ratings, lacks_rating, limit_joint_tension, limit_joint_torsion, &
                             limit_makeup, limit_rig, limit_slips, limit_top_drive, limit_torsion, part_limits
   use dg_verdict, only: limit_bend, limit_fatigue, limit_joint_fatigue, limit_packer_force, limit_seal_travel
   implicit none
   private
   public :: note_unrated

contains

   !> Mark limits that apply to a load case and have no rating in the deck, for all or for some components, or
   !> cannot be judged.
   pure subroutine note_unrated(model, case_index, unrated)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      logical, intent(inout) :: unrated(:)       !< one for each limit (dg_verdict)
      logical :: turns
      integer :: i, string, top
      turns = rotates(model%cases(case_index)%operation)
      string = string_index(model%strings, model%cases(case_index)%string)
      associate (parts => model%strings(string)%components)
         do i = 1, size(part_limits)
            associate (limit => part_limits(i))
               unrated(limit) = any(lacks_rating(parts, limit)) .or. .not. any(has_rating(parts, limit))
            end associate
         end do
         if (.not. turns) unrated([limit_torsion, limit_joint_torsion, limit_makeup]) = .false.
         if (.not. any(is_rated(parts%rating))) unrated(joint_ratings) = .false.
         ! connections carry the pull of the pipe, also of one that does not turn
         if (.not. any(has_joint_rating(parts))) unrated(limit_joint_tension) = .not. any(is_coiled_tubing(parts))
         top = topmost(component_tops(model%strings(string), model%cases(case_index)%bit_depth - top_md(model%trajectory)))
         ! without a curve of the pipe, fatigue as a whole is not checked
         unrated(limit_joint_fatigue) = turns .and. any(parts%fatigue%curve /= fatigue_none) .and. &
                                        .not. any(parts%joint_fatigue%curve /= fatigue_none)
         unrated(limit_slips) = .not. (model%design%slip_length > 0.0_wp .and. parts(top)%yield > 0.0_wp) .or. &
                                model%cases(case_index)%wob < 0.0_wp      ! slips are not set under a pull
      end associate
      unrated(limit_bend) = is_straightened(model, model%cases(case_index))
      unrated(limit_rig) = .not. model%rig%max_hookload%present
      unrated(limit_top_drive) = turns .and. .not. model%rig%max_torque%present
      unrated(limit_fatigue) = turns
      unrated(limit_seal_travel) = model%boundary%packer_bore > 0.0_wp .and. model%boundary%packer_hold /= hold_fixed
      unrated(limit_packer_force) = model%boundary%packer_bore > 0.0_wp .and. model%boundary%packer_hold /= hold_free
   end subroutine note_unrated
end module dg_unrated_limits

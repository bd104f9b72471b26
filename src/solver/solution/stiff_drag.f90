!> Friction along the hole of a stiff string, where that of the soft string is far from it.
!>
!> A bent housing, or stabilizers that fill a bending hole, are pressed to the wall by their own stiffness, with up to hundreds
!> of kilonewtons. The soft string has contact by weight and tension alone. A string that slides or is run in has to push such
!> an assembly. Without that push the expected compression is too small, and elements are too long. The pipe then buckles out
!> of the hole between its gaps. The beam of the start (dg_bent_start) has the contact of the assembly, from which friction is
!> taken here.
!>
!> A string that is pulled through the bends of a noisy survey cuts them short. The soft string follows each, and its friction
!> grows from bend to bend, up to several times that of the beam. Its force would call a string locked up that is not, and is
!> a poor start. So its friction is multiplied by a share, with which both have the same.
module dg_stiff_drag
   use dg_kinds, only: wp
   use dg_case_result, only: scale_count
   use dg_end_supports, only: force_scale
   use dg_gap_table, only: gap_table_type
   use dg_mesh, only: mesh_type
   use dg_mesh_for_case, only: mesh_for_case, near_edges
   use dg_model, only: model_type
   use dg_predictor, only: predict, start_type
   use dg_soft_string_loads, only: other_loads_type, soft_string_at, soft_totals_type
   use dg_walls, only: lay_out_gaps, softness
   use dg_weight_on_bit, only: most_load_at_bit
   use dg_whirling, only: find_sideways
   implicit none
   private
   public :: find_stiff_drag

   !> Part of the largest load at the bit by which that load is reduced [-]. At the load itself the soft string may run away by
   !> round-off.
   real(wp), parameter :: eased_by = 0.01_wp
   !> Number of times that the friction of a locked-up string is computed. The load at its bit depends on that friction.
   integer, parameter :: passes = 2
   !> Most corrections of the share, and the friction of the beam over that of the soft string above which none is needed [-].
   integer, parameter :: corrections = 5
   real(wp), parameter :: alike = 0.9_wp

contains

   !> Friction of the stiff assembly less the friction of the soft string there, positive down the hole [N]. It is 0 where it
   !> has no effect. For a string that locks up it is found under the greatest load that reaches its bit. The share belongs to
   !> a string that is pulled and nowhere compressed, else it is 1.
   pure subroutine find_stiff_drag(model, case_index, drag, share)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(out) :: drag   !< > 0 down the hole [N]
      real(wp), intent(out) :: share  !< friction of the beam over that of the soft string elsewhere, at most 1 [-]
      type(model_type) :: eased
      real(wp) :: most, part
      integer :: i
      logical :: locked_up
      eased = model
      share = 1.0_wp
      do i = 1, corrections
         call find_drag(eased, case_index, drag, part, locked_up)
         if (locked_up .or. part > alike) exit
         eased%stiff_share = eased%stiff_share*part
      end do
      share = eased%stiff_share
      if (.not. locked_up) return
      do i = 1, passes
         most = most_load_at_bit(eased, case_index, coiled=.true., pushed=.true.)
         eased%cases(case_index)%wob = most - eased_by*abs(most)
         call find_drag(eased, case_index, drag, part, locked_up)
         if (locked_up .or. .not. abs(drag) > 0.0_wp) return
         eased%stiff_drag = drag
      end do
   end subroutine find_stiff_drag

   !> Find that friction for a string under the loads of its case.
   pure subroutine find_drag(model, case_index, drag, part, locked_up)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(out) :: drag
      real(wp), intent(out) :: part             !< friction of the beam over that of the soft string, 1 if it is not pulled [-]
      logical, intent(out) :: locked_up         !< true if the soft string locks up; `drag` is 0 then
      type(mesh_type) :: mesh
      type(gap_table_type) :: gaps
      type(soft_totals_type) :: totals
      real(wp), allocatable :: sideways(:), state(:, :), pressed(:), axial(:), free(:), torque(:), soft(:)
      real(wp) :: compressed, strained, pressing, elsewhere, least
      logical, allocatable :: stiff(:)
      logical :: pulled
      integer :: shortened(scale_count)
      drag = 0.0_wp
      part = 1.0_wp
      call mesh_for_case(model, case_index, model%numerics%element_length, mesh, totals, compressed, strained, pressing, shortened)
      locked_up = totals%runaway
      if (locked_up) return
      stiff = near_edges(mesh)
      pulled = .not. compressed > 0.0_wp .and. any(mesh%friction_along > 0.0_wp)
      if (.not. (pulled .or. any(abs(mesh%friction_along) > 0.0_wp .and. stiff))) return
      allocate (sideways(mesh%elements), pressed(mesh%elements), soft(mesh%elements))
      allocate (state(6, mesh%nodes), axial(mesh%nodes), free(mesh%nodes), torque(mesh%nodes))
      call find_sideways(model, case_index, mesh, compressed, sideways)
      call lay_out_gaps(model%numerics, mesh, gaps)
      call predict(model, case_index, mesh, start_type(softness=softness(model%numerics%tuning%soft_penetration, mesh, pressing)), &
                   sideways, state, gaps, pressed)
      call soft_string_at(model, case_index, mesh%md, axial, torque, other=other_loads_type(coiled=.true.))
      call soft_string_at(model, case_index, mesh%md, free, torque, other=other_loads_type(friction_scale=0.0_wp))
      axial = axial - free
      soft = axial(:mesh%elements) - axial(2:)
      drag = sum(mesh%friction_along*pressed - soft, mask=stiff)
      elsewhere = sum(soft, mask=.not. stiff)
      least = model%numerics%tuning%nearly*force_scale(model, model%cases(case_index), mesh)
      if (pulled .and. elsewhere > least) part = sum(mesh%friction_along*pressed, mask=.not. stiff)/elsewhere
      if (abs(drag) < least) drag = 0.0_wp
   end subroutine find_drag
end module dg_stiff_drag

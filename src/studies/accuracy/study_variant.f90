!> The variants that a study compares: every combination of its lists, each with all settings of its solution.
!>
!> Element lengths and fidelities make one list: a fidelity is a length with further settings. Models other than the beams only
!> depend on element lengths, and have one variant a length.
module dg_study_variant
   use dg_kinds, only: wp
   use dg_job, only: model_mcge
   use dg_model, only: model_type
   use dg_numerics, only: fidelity_name, gap_at_extremum, numerics_type, set_fidelity
   use dg_study_plan, only: study_plan_type
   implicit none
   private
   public :: variant_type, study_variants, set_variant, is_finer, same_but_mesh, same_settings, wall_of

   type :: variant_type
      integer :: model = 0                !< number of the model (dg_job)
      integer :: fidelity = 0             !< place in fidelity_name; 0: an element length
      type(numerics_type) :: numerics
      real(wp) :: wall = 0.0_wp           !< stiffness of every wall [N/m2]; 0: as in the deck
   end type variant_type

   !> Number of levels by which variants are ranked in fineness.
   integer, parameter :: fineness_levels = 8

contains

   !> All variants of a plan, in the order of the lists. Settings that the plan leaves alone are the model's. Of several meshes of
   !> beams the finest, with which others are compared, halves its elements until moments stay.
   pure subroutine study_variants(plan, numerics, variants)
      type(study_plan_type), intent(in) :: plan
      type(numerics_type), intent(in) :: numerics   !< of the deck
      type(variant_type), allocatable, intent(out) :: variants(:)
      type(variant_type) :: with_mesh, with_tolerance, with_wall, with_gaps, variant
      integer :: i, mesh, meshes, tolerance, wall, gap, solver, pass, n
      logical :: beams
      do pass = 1, 2             ! first count, then take
         n = 0
         do i = 1, size(plan%models)
            beams = plan%models(i) == model_mcge
            meshes = size(plan%element_lengths)
            if (beams) meshes = meshes + size(plan%fidelities)
            do mesh = 1, max(1, meshes)
               with_mesh%model = plan%models(i)
               with_mesh%numerics = numerics
               with_mesh%fidelity = 0
               if (mesh <= size(plan%element_lengths)) then
                  with_mesh%numerics%element_length = plan%element_lengths(mesh)
                  with_mesh%numerics%full_length = 0.0_wp
               else if (beams .and. size(plan%fidelities) > 0) then
                  with_mesh%fidelity = plan%fidelities(mesh - size(plan%element_lengths))
                  call set_fidelity(with_mesh%numerics, fidelity_name(with_mesh%fidelity))
               end if
               if (beams .and. meshes > 1) with_mesh%numerics%halve_moments = with_mesh%numerics%moments .and. &
                  .not. with_mesh%numerics%element_length > shortest_of(plan, numerics)
               do tolerance = 1, merge(max(1, size(plan%tolerances)), 1, beams)
                  with_tolerance = with_mesh
                  if (size(plan%tolerances) > 0) with_tolerance%numerics%tolerance = plan%tolerances(tolerance)
                  do wall = 1, merge(max(1, size(plan%wall_stiffnesses)), 1, beams)
                     with_wall = with_tolerance
                     if (beams .and. size(plan%wall_stiffnesses) > 0) with_wall%wall = plan%wall_stiffnesses(wall)
                     do gap = 1, merge(max(1, size(plan%gap_locations)), 1, beams)
                        with_gaps = with_wall
                        if (size(plan%gap_locations) > 0) with_gaps%numerics%gap_location = plan%gap_locations(gap)
                        do solver = 1, merge(max(1, size(plan%linear_solvers)), 1, beams)
                           variant = with_gaps
                           if (size(plan%linear_solvers) > 0) variant%numerics%linear_solver = plan%linear_solvers(solver)
                           n = n + 1
                           if (pass == 2) variants(n) = variant
                        end do
                     end do
                  end do
               end do
            end do
         end do
         if (pass == 1) allocate (variants(n))
      end do
   end subroutine study_variants

   !> The shortest element that a plan asks of beams [m].
   pure function shortest_of(plan, numerics) result(length)
      type(study_plan_type), intent(in) :: plan
      type(numerics_type), intent(in) :: numerics
      real(wp) :: length
      type(numerics_type) :: other
      integer :: i
      length = minval(plan%element_lengths)
      do i = 1, size(plan%fidelities)
         other = numerics
         call set_fidelity(other, fidelity_name(plan%fidelities(i)))
         length = min(length, other%element_length)
      end do
   end function shortest_of

   !> Give a model the settings of a variant. A wall of the study is that of every hole section. The ratio of the rigid wall to
   !> the elastic one stays.
   pure subroutine set_variant(variant, model)
      type(variant_type), intent(in) :: variant
      type(model_type), intent(inout) :: model
      model%numerics = variant%numerics
      if (.not. variant%wall > 0.0_wp) return
      model%numerics%gk_max = variant%numerics%gk_max*(variant%wall/variant%numerics%gk_contact)
      model%numerics%gk_min = min(variant%numerics%gk_min, variant%numerics%gk_min*(variant%wall/variant%numerics%gk_contact))
      model%numerics%gk_contact = variant%wall
      model%holes%wall_stiffness = variant%wall
   end subroutine set_variant

   !> Stiffness of the wall [N/m2]; that of the solver's settings where neither study nor hole section says otherwise.
   elemental function wall_of(variant) result(wall)
      type(variant_type), intent(in) :: variant
      real(wp) :: wall
      wall = variant%wall
      if (.not. wall > 0.0_wp) wall = variant%numerics%gk_contact
   end function wall_of

   !> True if `one` is a finer model than `other`. The order of criteria: physics, length of elements, proof of moments, tolerance,
   !> stiffer wall, the paper's place of gaps, linear solver (with exchange of rows). The fidelity decides between two alike.
   pure function is_finer(one, other) result(finer)
      type(variant_type), intent(in) :: one, other
      logical :: finer
      real(wp) :: a(fineness_levels), b(fineness_levels)
      integer :: i
      a = fineness(one)
      b = fineness(other)
      finer = .false.
      do i = 1, fineness_levels
         finer = a(i) > b(i)
         if (abs(a(i) - b(i)) > 0.0_wp) return
      end do
   end function is_finer

   !> Fineness of a variant by levels, the weightiest first; greater is finer.
   pure function fineness(variant) result(levels)
      type(variant_type), intent(in) :: variant
      real(wp) :: levels(fineness_levels)
      ! soft, rigid, mixed, beams
      levels = [merge(5.0_wp, real(variant%model, wp), variant%model == model_mcge), -variant%numerics%element_length, &
                merge(1.0_wp, 0.0_wp, variant%numerics%halve_moments), -variant%numerics%tolerance, wall_of(variant), &
                merge(1.0_wp, 0.0_wp, variant%numerics%gap_location == gap_at_extremum), &
                real(variant%numerics%linear_solver, wp), merge(1.0_wp, 0.0_wp, variant%fidelity > 0)]
   end function fineness

   !> True if two variants differ in the length of their elements alone, neither of them a fidelity.
   pure function same_but_mesh(one, other) result(same)
      type(variant_type), intent(in) :: one, other
      logical :: same
      same = one%fidelity == 0 .and. other%fidelity == 0 .and. one%model == other%model .and. same_settings(one, other)
   end function same_but_mesh

   !> True if two variants have tolerance, wall, place of gaps and linear solver in common.
   pure function same_settings(one, other) result(same)
      type(variant_type), intent(in) :: one, other
      logical :: same
      same = .not. abs(one%numerics%tolerance - other%numerics%tolerance) > 0.0_wp .and. &
             .not. abs(one%wall - other%wall) > 0.0_wp .and. &
             one%numerics%gap_location == other%numerics%gap_location .and. &
             one%numerics%linear_solver == other%numerics%linear_solver
   end function same_settings
end module dg_study_variant

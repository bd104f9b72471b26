!> Places where the bending moment of a string that follows the hole would jump, and the length of the transition in a real
!> string.
!>
!> Minimum curvature gives every arc its own constant curvature. E I k therefore jumps at stations (and where the component
!> changes in a bend). A jump of moment would need a couple of infinite forces. A string in a hole with clearance bends
!> gradually instead. Its moment is taken as the hole's with each jump d spread by
!>     e(x) = (d/2) exp(-|x|/l) before it, and e(x) = -(d/2) exp(-|x|/l) behind it.
!> This is the shape of a tensioned beam under a load that jumps, for which l = sqrt(E I/|T|), the bending length. It shifts
!> the string across the hole by l^2 |dk|, from one side of the change to the other. From wall to wall there is room for twice
!> the clearance c, therefore
!>     l = min(sqrt(E I/|T|), sqrt(2 c/|dk|)).
!> If the first is smaller, E I |dk| <= 2 |T| c. Tension then bends the string freely, and stiffness does not add to the
!> contact force of a soft string. If the second is smaller, the wall forces the bend by a pair of contact forces of |d|/(2 l)
!> each.
module dg_curvature_change
   use dg_kinds, only: wp
   use dg_model, only: model_type
   use dg_soft_string_loads, only: soft_string_at
   use dg_string_piece, only: at_offset, breakpoints, layout_of, layout_type, piece_above, piece_type
   implicit none
   private
   public :: change_type, curvature_changes, find_extents, bending_at

   type :: change_type
      real(wp) :: md = 0.0_wp                !< [m]
      real(wp) :: moment(3) = 0.0_wp         !< jump of E I k, below less above [N.m]
      real(wp) :: curvature(3) = 0.0_wp      !< jump of k, below less above [1/m]
      real(wp) :: length = 0.0_wp            !< l of the description above [m]
      real(wp) :: stiffness = 0.0_wp         !< the greater E I of both sides [N.m2]
      logical :: forced = .false.            !< by the wall: l is that of the clearance
      !> For the first of a block: depths above and below which the whole block has no effect [m] (find_extents).
      real(wp) :: highest = -huge(1.0_wp), deepest = huge(1.0_wp)
   end type change_type

   !> Number of lengths l beyond which a change has no effect [-]: exp(-20) is 2e-9.
   real(wp), parameter :: reach = 20.0_wp
   !> Number of changes that are skipped together if none has an effect.
   integer, parameter :: block = 64
   !> Distance from a depth at which the pieces on its two sides are read [m]: twice the distance within which `breakpoints`
   !> joins depths.
   real(wp), parameter :: beside = 2.0e-6_wp
   !> Jump of moment that counts as zero [N.m]: round-off of a bend of 1e7 N.m2 cut into arcs.
   real(wp), parameter :: least_moment = 1.0e-6_wp
   !> Least length of a bend over the diameter [-]: below it beam theory is not valid.
   real(wp), parameter :: least_diameters = 1.0_wp

contains

   !> Find all changes along the string of a load case, from the top down. Bending lengths use the tension of the soft string.
   pure subroutine curvature_changes(model, case_index, changes)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      type(change_type), allocatable, intent(out) :: changes(:)
      type(change_type), allocatable :: found(:)
      type(layout_type) :: layout
      type(piece_type) :: above, below
      real(wp), allocatable :: md(:), axial(:), torque(:), contact(:, :)
      real(wp), dimension(3) :: position, across, bend_above, bend_below
      real(wp) :: turn, clearance
      integer :: i, n
      call places(model, case_index, md)
      allocate (axial(size(md)), torque(size(md)), contact(3, size(md)), found(size(md)))
      call soft_string_at(model, case_index, md, axial, torque, contact)
      layout = layout_of(model, case_index)
      n = 0
      do i = 2, size(md) - 1
         above = piece_above(model, layout, md(i) - beside, 1.0_wp)
         below = piece_above(model, layout, md(i) + beside, 1.0_wp)
         call at_offset(above, md(i) - above%arc%md, position, across, bend_above)
         call at_offset(below, md(i) - below%arc%md, position, across, bend_below)
         associate (change => found(n + 1))
            change%md = md(i)
            change%moment = below%stiffness*bend_below - above%stiffness*bend_above
            if (norm2(change%moment) <= least_moment) cycle
            change%curvature = bend_below - bend_above
            change%stiffness = max(above%stiffness, below%stiffness)
            turn = norm2(change%moment)/change%stiffness
            clearance = max(min(above%clearance, below%clearance), 0.0_wp)
            change%forced = norm2(change%moment) > 2.0_wp*abs(axial(i))*clearance
            if (change%forced) then
               change%length = sqrt(2.0_wp*clearance/turn)
            else
               change%length = sqrt(change%stiffness/abs(axial(i)))
            end if
            change%length = max(change%length, least_diameters*2.0_wp*max(above%radius, below%radius))
         end associate
         n = n + 1
      end do
      allocate (changes(n))
      changes = found(:n)
   end subroutine curvature_changes

   !> Set the extent of the changes of each block. A few long ones only affect their own block.
   pure subroutine find_extents(changes)
      type(change_type), intent(inout) :: changes(:)
      real(wp), parameter :: felt = reach + 1.0_wp     ! one length more than any change has an effect, for round-off
      integer :: first, last
      do first = 1, size(changes), block
         last = min(first + block - 1, size(changes))
         changes(first)%highest = minval(changes(first:last)%md - felt*changes(first:last)%length)
         changes(first)%deepest = maxval(changes(first:last)%md + felt*changes(first:last)%length)
      end do
   end subroutine find_extents

   !> Depths where anything may change, with those of all arcs: a spline has arcs between stations [m].
   pure subroutine places(model, case_index, md)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), allocatable, intent(out) :: md(:)
      real(wp), allocatable :: marks(:)
      integer :: i, j, n
      allocate (marks, source=breakpoints(model, case_index))
      allocate (md(size(marks) + size(model%trajectory%arcs)))
      n = 0
      j = 1
      do i = 1, size(marks)
         do while (j <= size(model%trajectory%arcs))
            if (model%trajectory%arcs(j)%md >= marks(i) - beside) exit
            call add_depth(model%trajectory%arcs(j)%md, md, n)
            j = j + 1
         end do
         call add_depth(marks(i), md, n)
      end do
      md = md(:n)
   end subroutine places

   !> Append a depth unless the list has it.
   pure subroutine add_depth(depth, md, n)
      real(wp), intent(in) :: depth        !< [m]
      real(wp), intent(inout) :: md(:)     !< the first n are set, ascending [m]
      integer, intent(inout) :: n
      if (n > 0) then
         if (depth <= md(n) + beside) return
      end if
      n = n + 1
      md(n) = depth
   end subroutine add_depth

   !> Curvature and moment that the changes add to those of the hole at a depth, across the hole. Call `find_extents` first, so
   !> that changes are found fast. Otherwise every change is examined.
   pure subroutine bending_at(changes, md, side, tangent, curvature, curvature_slope, moment, shear, shear_slope)
      type(change_type), intent(in) :: changes(:)
      real(wp), intent(in) :: md                    !< [m]
      real(wp), intent(in) :: side                  !< a depth on the wanted side of md, as slopes jump at changes [m]
      real(wp), intent(in) :: tangent(3)            !< of the hole, unit [-]
      real(wp), intent(out) :: curvature(3)         !< added to k [1/m]
      real(wp), intent(out) :: curvature_slope(3)   !< d/ds of it, jumps of the hole's k smoothed [1/m2]
      real(wp), intent(out) :: moment(3)            !< added to E I k [N.m]
      real(wp), intent(out) :: shear(3)             !< -d(E I k)/ds, jumps smoothed [N]
      real(wp), intent(out) :: shear_slope(3)       !< d/ds of it [N/m]
      real(wp) :: distance, decay, half, along
      integer :: first, j
      curvature = 0.0_wp
      curvature_slope = 0.0_wp
      moment = 0.0_wp
      shear = 0.0_wp
      shear_slope = 0.0_wp
      do first = 1, size(changes), block
         if (md < changes(first)%highest .or. md > changes(first)%deepest) cycle
         do j = first, min(first + block - 1, size(changes))
            distance = abs(md - changes(j)%md)/changes(j)%length
            if (distance > reach) cycle
            decay = 0.5_wp*exp(-distance)
            half = sign(decay, changes(j)%md - side)    ! positive above the change
            along = decay/changes(j)%length
            curvature = curvature + half*changes(j)%curvature
            curvature_slope = curvature_slope + along*changes(j)%curvature
            moment = moment + half*changes(j)%moment
            shear = shear - along*changes(j)%moment
            shear_slope = shear_slope - (half/changes(j)%length**2)*changes(j)%moment
         end do
      end do
      curvature = across_hole(curvature)
      curvature_slope = across_hole(curvature_slope)
      moment = across_hole(moment)
      shear = across_hole(shear)
      shear_slope = across_hole(shear_slope)
   contains
      pure function across_hole(vector) result(lateral)
         real(wp), intent(in) :: vector(3)
         real(wp) :: lateral(3)
         lateral = vector - dot_product(vector, tangent)*tangent
      end function across_hole
   end subroutine bending_at
end module dg_curvature_change

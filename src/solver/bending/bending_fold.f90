!> A bending beam folded in the middle, for dg_bending_pair. Of n nodes number n/2 + 1 is the middle one. The first dimension of
!> arrays over nodes is of upper and lower half. The last one counts from the ends to the middle, where it is n/2 + 1: the middle
!> node stands in both halves. In a beam of an even number of nodes the lower half begins with an unused node and an unused
!> element.
module dg_bending_fold
   use dg_kinds, only: wp
   use dg_bending_beam, only: bending_beam_type, node_unknowns
   use dg_bending_pair, only: beam_pair_type, pair, pair_push_type, put_element
   implicit none
   private
   public :: folded_beam_type, fold_beam, fold_shape, unfold_shape, unfold_forces, half_of, keep, mirror

   !> What offsets and slopes in the upper half are multiplied by where they are seen from the lower one [-].
   real(wp), parameter :: mirror(node_unknowns) = [1.0_wp, 1.0_wp, -1.0_wp, -1.0_wp]

   type :: folded_beam_type
      integer :: middle = 0                          !< number of the middle node
      type(beam_pair_type), allocatable :: pairs(:)  !< (middle-1)
      real(wp), allocatable :: viscous(:, :)         !< of the beam; of the middle node in the upper half alone (2,middle) [N/m]
      integer, allocatable :: fixed(:, :)            !< how many of a node's unknowns, from the first on, stay (2,middle)
      integer, allocatable :: point(:, :)            !< tool joint of the beam at a node, or 0; as viscous (2,middle)
      logical, allocatable :: plain(:)               !< no node of a pair is fixed or has a tool joint (middle)
   end type folded_beam_type

contains

   !> Folds a beam whose elements are set.
   pure subroutine fold_beam(beam, folded)
      type(bending_beam_type), intent(in) :: beam
      type(folded_beam_type), intent(out) :: folded
      integer :: nodes, middle, half, n, node, p
      nodes = size(beam%md)
      middle = nodes/2 + 1
      folded%middle = middle
      allocate (folded%pairs(middle - 1), folded%viscous(pair, middle), folded%fixed(pair, middle), folded%plain(middle))
      allocate (folded%point(pair, middle), source=0)
      do n = 1, middle
         do half = 1, pair
            node = merge(n, 2*middle - n, half == 1)
            folded%fixed(half, n) = node_unknowns
            folded%viscous(half, n) = 0.0_wp
            if (node > nodes) cycle
            folded%fixed(half, n) = merge(node_unknowns, merge(node_unknowns/2, 0, beam%centred(node)), beam%held(node))
            if (half == 1 .or. n < middle) folded%viscous(half, n) = beam%viscous(node)
            if (n < middle) call put_element(beam%element(merge(node, node - 1, half == 1)), half, folded%pairs(n))
         end do
      end do
      do p = 1, size(beam%point)
         call half_of(middle, beam%point(p), half, n)
         folded%point(half, n) = p
      end do
      do n = 1, middle
         folded%plain(n) = all(folded%fixed(:, n) == 0) .and. all(folded%point(:, n) == 0)
      end do
   end subroutine fold_beam

   !> In which half a node is, and its number there. The middle one is in the upper half.
   elemental subroutine half_of(middle, node, half, n)
      integer, intent(in) :: middle, node
      integer, intent(out) :: half, n
      half = merge(1, 2, node <= middle)
      n = merge(node, 2*middle - node, node <= middle)
   end subroutine half_of

   !> Folds offsets and slopes.
   pure subroutine fold_shape(shape, folded)
      real(wp), contiguous, intent(in) :: shape(:, :)         !< (4,n) [m, -]
      real(wp), contiguous, intent(out) :: folded(:, :, :)    !< (2,4,n/2+1)
      integer :: n, middle
      middle = size(folded, 3)
      folded(2, :, 1) = 0.0_wp
      do n = 1, middle
         folded(1, :, n) = shape(:, n)
         if (2*middle - n <= size(shape, 2)) folded(2, :, n) = mirror*shape(:, 2*middle - n)
      end do
   end subroutine fold_shape

   !> And back.
   pure subroutine unfold_shape(folded, shape)
      real(wp), contiguous, intent(in) :: folded(:, :, :)
      real(wp), contiguous, intent(out) :: shape(:, :)
      integer :: n, middle
      middle = size(folded, 3)
      do n = 1, middle
         if (2*middle - n <= size(shape, 2)) shape(:, 2*middle - n) = mirror*folded(2, :, n)
         shape(:, n) = folded(1, :, n)
      end do
   end subroutine unfold_shape

   !> Contact forces at the places of the elements.
   pure subroutine unfold_forces(push, pressed)
      type(pair_push_type), intent(in) :: push(:, :)     !< (2,n/2)
      real(wp), intent(out) :: pressed(:, :)             !< (2,n-1) [N]
      integer :: n, last
      last = 2*size(push, 2) + 1     ! the lower element of the outermost pair, if there is one, is the one before
      do n = 1, size(push, 2)
         pressed(:, n) = push(:, n)%force(1)
         if (last - n <= size(pressed, 2)) pressed(:, last - n) = push(2:1:-1, n)%force(2)
      end do
   end subroutine unfold_forces

   !> Takes unknowns of a pair's outer nodes that stay as they are out of its equations: zero rows and columns, with ones on the
   !> diagonal.
   pure subroutine keep(fixed, own, next)
      integer, intent(in) :: fixed(pair)                 !< how many, from the first on
      real(wp), intent(inout) :: own(:, :, :)            !< columns of the outer nodes (2,rows,unknowns)
      real(wp), intent(inout) :: next(:, :, :)           !< of the inner ones, and the load
      integer :: half, i
      do half = 1, pair
         do i = 1, fixed(half)
            own(half, i, :) = 0.0_wp
            next(half, i, :) = 0.0_wp
            own(half, :, i) = 0.0_wp
            own(half, i, i) = 1.0_wp
         end do
      end do
   end subroutine keep
end module dg_bending_fold

!> Nodes of a bending beam. They are dense where the moment changes quickly, and their distance grows from there. If a solution
!> shows that they are too far apart, elements are halved.
module dg_bending_nodes
   use dg_kinds, only: wp
   use dg_hermite, only: hermite_slope, hermite_value
   implicit none
   private
   public :: graded_nodes, halved_nodes, shape_at, rows_needed, shortening_of

   !> Growth of the length of elements per metre of distance from a place with short ones [-].
   real(wp), parameter :: growth = 0.25_wp
   !> Most halvings of one interval: its shortest part is then a billionth of it.
   integer, parameter :: deepest = 30

contains

   !> Depths of nodes, increasing [m]. All `breaks` are nodes. Between them no element is longer than `longest` at the breaks,
   !> plus the growth with distance from them.
   pure function graded_nodes(breaks, longest) result(nodes)
      real(wp), intent(in) :: breaks(:)     !< increasing, at least two [m]
      real(wp), intent(in) :: longest(:)    !< longest element at each break; huge where a break has no limit [m]
      real(wp), allocatable :: nodes(:)
      real(wp) :: bound(size(breaks))
      integer :: i, n, filled
      bound = longest
      n = size(breaks)
      do i = 1, n - 1
         bound(i + 1) = min(bound(i + 1), bound(i) + growth*(breaks(i + 1) - breaks(i)))
      end do
      do i = n - 1, 1, -1
         bound(i) = min(bound(i), bound(i + 1) + growth*(breaks(i + 1) - breaks(i)))
      end do
      allocate (nodes(2*n + deepest))
      nodes(1) = breaks(1)
      filled = 1
      do i = 1, n - 1
         call cut(breaks(i:i + 1), bound(i:i + 1), nodes, filled)
      end do
      nodes = nodes(:filled)
   end function graded_nodes

   !> Halve an interval until its parts keep their bounds, and append its nodes except the first. Parts that are not yet done
   !> are on a stack, the uppermost part on top.
   pure subroutine cut(ends, bounds, nodes, filled)
      real(wp), intent(in) :: ends(2), bounds(2)     !< depths, and longest elements there [m]
      real(wp), allocatable, intent(inout) :: nodes(:)
      integer, intent(inout) :: filled
      real(wp) :: at, bound, length, middle, stack(deepest), limits(deepest)
      real(wp), allocatable :: longer(:)
      integer :: top
      at = ends(1)
      bound = bounds(1)
      stack(1) = ends(2)
      limits(1) = bounds(2)
      top = 1
      do while (top > 0)
         length = stack(top) - at
         middle = min(bound, limits(top)) + 0.5_wp*growth*length
         if (length <= middle .or. top == deepest) then
            if (filled == size(nodes)) then
               allocate (longer(2*size(nodes)))
               longer(:filled) = nodes
               call move_alloc(longer, nodes)
            end if
            filled = filled + 1
            nodes(filled) = stack(top)
            at = stack(top)
            bound = limits(top)
            top = top - 1
         else
            stack(top + 1) = at + 0.5_wp*length
            limits(top + 1) = middle
            top = top + 1
         end if
      end do
   end subroutine cut

   !> Nodes with a new one in the middle of each marked element [m].
   pure function halved_nodes(nodes, marked) result(finer)
      real(wp), intent(in) :: nodes(:)      !< increasing [m]
      logical, intent(in) :: marked(:)      !< elements to be halved (n-1)
      real(wp), allocatable :: finer(:)
      integer :: e, n
      allocate (finer(size(nodes) + count(marked)))
      n = 1
      finer(1) = nodes(1)
      do e = 1, size(marked)
         if (marked(e)) then
            n = n + 1
            finer(n) = 0.5_wp*(nodes(e) + nodes(e + 1))
         end if
         n = n + 1
         finer(n) = nodes(e + 1)
      end do
   end function halved_nodes

   !> Offsets and slopes (y_1, y_2, y_1', y_2') of a beam's cubic shape at other nodes (4,m) [m, -].
   pure function shape_at(nodes, y, others) result(shape)
      real(wp), intent(in) :: nodes(:)      !< of the beam, increasing (n) [m]
      real(wp), intent(in) :: y(:, :)       !< offsets and slopes at them (4,n) [m, -]
      real(wp), intent(in) :: others(:)     !< increasing, with the same ends (m) [m]
      real(wp) :: shape(4, size(others))
      real(wp) :: xi, length, value(4), slope(4)
      integer :: e, n
      e = 1
      do n = 1, size(others)
         do while (e < size(nodes) - 1 .and. nodes(e + 1) < others(n))
            e = e + 1
         end do
         length = nodes(e + 1) - nodes(e)
         xi = (others(n) - nodes(e))/length
         value = hermite_value(xi, length)
         slope = hermite_slope(xi, length)
         shape(1:2, n) = value(1)*y(1:2, e) + value(2)*y(3:4, e) + value(3)*y(1:2, e + 1) + value(4)*y(3:4, e + 1)
         shape(3:4, n) = slope(1)*y(1:2, e) + slope(2)*y(3:4, e) + slope(3)*y(1:2, e + 1) + slope(4)*y(3:4, e + 1)
      end do
   end function shape_at

   !> Length by which the slopes of a beam bring its ends together [m]: the integral of y'^2/2, exact for its cubics.
   pure function shortening_of(nodes, y) result(short)
      real(wp), intent(in) :: nodes(:)      !< of the beam, increasing (n) [m]
      real(wp), intent(in) :: y(:, :)       !< offsets and slopes there (4,n) [m, -]
      real(wp) :: short
      real(wp) :: length, step, first, last
      integer :: e, i
      short = 0.0_wp
      do e = 1, size(nodes) - 1
         length = nodes(e + 1) - nodes(e)
         do i = 1, 2
            step = y(i, e + 1) - y(i, e)
            first = y(i + 2, e)
            last = y(i + 2, e + 1)
            short = short + (18.0_wp*step**2/length - 3.0_wp*step*(first + last) + length*(2.0_wp*(first**2 + last**2) &
                                                                                           - first*last))/30.0_wp
         end do
      end do
   end function shortening_of

   !> Choose rows of a table. Straight lines between the rows that are kept differ from the other values by at most `bound`.
   !> From the first row on, each line is as long as possible.
   pure subroutine rows_needed(md, values, bound, kept)
      real(wp), intent(in) :: md(:)         !< increasing [m]
      real(wp), intent(in) :: values(:)     !< in any unit
      real(wp), intent(in) :: bound         !< in the same unit
      logical, intent(inout) :: kept(:)     !< on entry: rows that must be kept, the first and the last among them
      real(wp) :: low, high, slope, reach
      integer :: first, i
      first = 1
      low = -huge(low)
      high = huge(high)
      do i = 2, size(md)
         reach = md(i) - md(first)
         slope = (values(i) - values(first))/reach
         if (slope < low .or. slope > high) then    ! no line from `first` to here passes the values between
            kept(i - 1) = .true.
            first = i - 1
            low = -huge(low)
            high = huge(high)
            reach = md(i) - md(first)
         end if
         low = max(low, (values(i) - bound - values(first))/reach)
         high = min(high, (values(i) + bound - values(first))/reach)
         if (kept(i)) then
            first = i
            low = -huge(low)
            high = huge(high)
         end if
      end do
   end subroutine rows_needed
end module dg_bending_nodes

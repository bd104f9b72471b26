!> A string in its hole solved a second time, by other means: what the moments of the program are held against. Nothing of the
!> program's mechanics is used, only its kinds and LAPACK.
!>
!> Along a string with unit tangent d, let the part below exert the force F = T d + Q (Q across d) and the moment M on the part
!> above. With the force f and the moment g that act from outside per metre,
!>   F' + f = 0,   M' + d x F + g = 0,   M = EI d x d' - M_t d,
!> M_t the torque that a right-hand drive makes. Across d this is Q = -(EI k)' - M_t t x k + t x g with the string's curvature
!> k = k_hole + y'' (in EI k less what a bent string has before loading), y its offset from the hole axis in a frame that does not
!> spin, and
!>   (T y')' + T k_hole + Q' + w - R (n + m t x n) = 0,   t x g = r a R n;
!> along d, T' = -w_t - a R + Q.k and M_t' = -r m R. The wall pushes with R = stiffness (|y| - c) where that is positive; n = y/|y|,
!> a and m the coefficients of friction along (> 0 where the string is pulled) and around the hole, r the radius of contact.
!>
!> Differences on nodes at equal distances: offsets, moments and contact at nodes, T, Q and M_t between them. Offsets come from
!> Newton's method with LAPACK's band solver; T and M_t from the contact found, until it stays.
module dg_independent_beam
   use dg_kinds, only: wp
   use dg_lapack, only: dgbtrf, dgbtrs
   implicit none
   private
   public :: independent_well_type, independent_beam_type, bend_independently, bend_stretched, places_of, push_at_bit, value_at

   real(wp), parameter :: pi = acos(-1.0_wp), steel = 7850.0_wp

   !> A well, a string and a case. Components from the bit up; a length of 0 reaches to surface.
   type :: independent_well_type
      real(wp), allocatable :: md(:), inclination(:), azimuth(:)      !< stations [m, deg, deg]
      real(wp), allocatable :: length(:), od(:), id(:), joint(:)      !< [m]
      real(wp), allocatable :: mass(:)                                !< in air [kg/m]
      real(wp) :: diameter = 0.0_wp           !< of the hole [m]
      real(wp) :: mud = 0.0_wp                !< [kg/m3]
      real(wp) :: bit = 0.0_wp                !< depth [m]
      real(wp) :: wob = 0.0_wp, tob = 0.0_wp  !< [N, N.m]
      real(wp) :: along = 0.0_wp              !< a [-]
      real(wp) :: around = 0.0_wp             !< m [-]
      real(wp) :: youngs = 206.0e9_wp         !< [Pa]
      real(wp) :: gravity = 9.80665_wp        !< [m/s2]
      real(wp) :: wall = 1.0e10_wp            !< stiffness of the wall per metre [N/m2]
      real(wp) :: step = 0.2_wp               !< distance of nodes [m]
      real(wp) :: bend = 0.0_wp, bend_above = 0.0_wp   !< of the string before loading, height of its middle above the bit [rad, m]
      real(wp) :: bend_length = 0.1_wp        !< over which it is bent [m]
      real(wp) :: toolface = 0.0_wp           !< to which the part below it points, from the high side clockwise [rad]
   end type independent_well_type

   !> The string as it lies, nodes 0 to n from the top; what stands between nodes counts from 1 to n.
   type :: independent_beam_type
      integer :: n = 0
      real(wp) :: h = 0.0_wp                                         !< [m]
      real(wp), allocatable :: x(:)                                  !< place in the hole [m]
      real(wp), allocatable :: y(:, :), curvature(:, :), moment(:, :) !< (2,0:n) [m, 1/m, N.m]
      real(wp), allocatable :: contact(:)                            !< R times h [N]
      real(wp), allocatable :: axial(:), torque(:)                   !< at nodes [N, N.m]
      real(wp), allocatable :: shear(:, :)                           !< Q, between nodes (2,n) [N]
      real(wp), allocatable :: clock(:)                              !< from the high side, clockwise looking down [rad]
      real(wp), allocatable :: ei(:), ea(:), clearance(:), radius(:) !< at nodes
      real(wp), allocatable :: k_node(:, :), k_cell(:, :)            !< of the hole [1/m]
      real(wp), allocatable :: kinked(:, :)                          !< curvature of the string before loading, at nodes [1/m]
      real(wp), allocatable :: weight(:, :), along(:)                !< across at nodes, along between them [N/m]
      real(wp), allocatable :: tension(:), twist(:)                  !< T and M_t between nodes
   end type independent_beam_type

   !> Change of the sum of contact at which the outer loop ends [-]; Newton's residual over the largest load.
   real(wp), parameter :: settled = 1.0e-7_wp, rest = 1.0e-9_wp
   integer, parameter :: most_rounds = 60     !< of the outer loop
   integer, parameter :: samples = 8          !< of hole and string to a step
   integer, parameter :: width = 5            !< of the band: three nodes of two unknowns follow each other
   real(wp), parameter :: second(-1:1) = [1.0_wp, -2.0_wp, 1.0_wp]

contains

   subroutine bend_independently(well, beam, found, start)
      type(independent_well_type), intent(in) :: well
      type(independent_beam_type), intent(out) :: beam
      logical, intent(out) :: found
      type(independent_beam_type), intent(in), optional :: start     !< of next to the same well, with as many nodes
      real(wp), allocatable :: before(:)
      integer :: round
      call lay_out(well, beam)
      allocate (before(0:beam%n), source=0.0_wp)
      found = present(start)
      if (found) then
         beam%y = start%y
         beam%contact = start%contact
         beam%shear = start%shear
         beam%curvature = start%curvature
      end if
      do round = 1, most_rounds
         call sum_up(well, beam)
         if (found) call find_offsets(well, well%wall, beam, found)
         if (.not. found) call harden(well, beam, found)
         if (.not. found) exit
         if (round > 8) beam%contact = 0.5_wp*(beam%contact + before)
         if (abs(sum(beam%contact) - sum(before)) <= settled*sum(beam%contact)) exit
         before = beam%contact
      end do
      found = found .and. round <= most_rounds
      beam%clock = modulo(atan2(beam%y(2, :), beam%y(1, :)) - beam%clock, 2.0_wp*pi)
   end subroutine bend_independently

   !> Offsets from the side of the wall to which weight and tension press a string without stiffness, against a wall that hardens.
   subroutine harden(well, beam, found)
      type(independent_well_type), intent(in) :: well
      type(independent_beam_type), intent(inout) :: beam
      logical, intent(out) :: found
      real(wp) :: away(2)
      integer :: i, stage
      do i = 1, beam%n - 1
         away = beam%weight(:, i) + beam%tension(i)*beam%k_node(:, i)
         beam%y(:, i) = beam%clearance(i)*away/max(norm2(away), tiny(1.0_wp))
      end do
      do stage = 6, 0, -1
         call find_offsets(well, well%wall*0.1_wp**stage, beam, found)
      end do
   end subroutine harden

   !> The solution for a string that is as long as the program's when it has stretched, so that both bits are at one place.
   subroutine bend_stretched(well, beam, found)
      type(independent_well_type), intent(in) :: well
      type(independent_beam_type), intent(out) :: beam
      logical, intent(out) :: found
      type(independent_well_type) :: longer
      real(wp) :: lower                        ! length of all components but the uppermost one, which stretches most [m]
      type(independent_beam_type) :: first
      integer :: n
      longer = well
      n = size(well%mass)
      lower = sum(well%length(:n - 1))
      call bend_independently(well, first, found)
      if (.not. found) return
      longer%bit = maxval(places_of(first, [well%bit]))
      longer%mass(n) = well%mass(n)*(well%bit - lower)/(longer%bit - lower)
      longer%step = longer%bit/first%n
      call bend_independently(longer, beam, found, first)
   end subroutine bend_stretched

   !> Where in the hole points of the string are that were at `md` before loading: held at the top, it stretches.
   pure function places_of(beam, md) result(place)
      type(independent_beam_type), intent(in) :: beam
      real(wp), intent(in) :: md(:)
      real(wp) :: place(size(md)), stretch(0:beam%n)
      integer :: i
      stretch(0) = 0.0_wp
      do i = 1, beam%n
         stretch(i) = stretch(i - 1) + 0.5_wp*beam%h*(beam%axial(i - 1)/beam%ea(i - 1) + beam%axial(i)/beam%ea(i))
      end do
      do i = 1, size(md)
         place(i) = md(i) + value_at(beam, stretch, md(i))
      end do
   end function places_of

   !> Nodes, sections of the string and frames of the hole.
   subroutine lay_out(well, beam)
      type(independent_well_type), intent(in) :: well
      type(independent_beam_type), intent(out) :: beam
      real(wp), parameter :: north(3) = [1.0_wp, 0.0_wp, 0.0_wp], up(3) = [0.0_wp, 0.0_wp, -1.0_wp]
      real(wp) :: t(3), n_1(3), n_2(3), k(2), x, soft, high(3), share
      integer :: i, j, n, part
      n = nint(well%bit/well%step)
      beam%n = n
      beam%h = well%bit/n
      allocate (beam%x(0:n), beam%y(2, 0:n), beam%curvature(2, 0:n), beam%moment(2, 0:n), beam%contact(0:n), beam%axial(0:n), &
                beam%torque(0:n), beam%shear(2, n), beam%clock(0:n), beam%ei(0:n), beam%ea(0:n), beam%clearance(0:n), &
                beam%radius(0:n), beam%k_node(2, 0:n), beam%k_cell(2, n), beam%weight(2, 0:n), beam%along(n), beam%tension(n), &
                beam%twist(n))
      beam%y = 0.0_wp
      beam%curvature = 0.0_wp
      beam%moment = 0.0_wp
      beam%contact = 0.0_wp
      beam%shear = 0.0_wp
      beam%k_node = 0.0_wp
      beam%k_cell = 0.0_wp
      beam%weight = 0.0_wp
      beam%along = 0.0_wp
      do i = 0, n
         beam%x(i) = beam%h*i
         call frame_at(well, beam%x(i), t, n_1, n_2, k)
         high = merge(north, up, hypot(n_1(3), n_2(3)) < 1.0e-9_wp)
         beam%clock(i) = atan2(dot_product(high, n_2), dot_product(high, n_1))     ! of the high side, from n_1
         part = component_of(well, beam%x(i))
         beam%ea(i) = well%youngs*0.25_wp*pi*(well%od(part)**2 - well%id(part)**2)
         ! means over the part of hole and string that belongs to a node, and over that between two
         soft = 0.0_wp
         beam%radius(i) = 0.0_wp
         do j = 1, samples
            x = min(max(beam%x(i) + beam%h*((j - 0.5_wp)/samples - 0.5_wp), 0.0_wp), well%bit)
            part = component_of(well, x)
            soft = soft + 1.0_wp/(well%youngs*pi/64.0_wp*(well%od(part)**4 - well%id(part)**4))/samples
            beam%radius(i) = max(beam%radius(i), 0.5_wp*well%od(part), 0.5_wp*well%joint(part))
            call frame_at(well, x, t, n_1, n_2, k)
            beam%k_node(:, i) = beam%k_node(:, i) + k/samples
            beam%weight(:, i) = beam%weight(:, i) + heavy(part)*[n_1(3), n_2(3)]/samples
            if (i == 0) cycle
            x = x - 0.5_wp*beam%h
            part = component_of(well, x)
            call frame_at(well, x, t, n_1, n_2, k)
            beam%k_cell(:, i) = beam%k_cell(:, i) + k/samples
            beam%along(i) = beam%along(i) + heavy(part)*t(3)/samples
         end do
         beam%ei(i) = 1.0_wp/soft
         beam%clearance(i) = 0.5_wp*well%diameter - beam%radius(i)
      end do
      allocate (beam%kinked(2, 0:n), source=0.0_wp)
      do i = 1, n - 1
         share = 0.5_wp + (0.5_wp*well%bend_length - abs(well%bit - well%bend_above - beam%x(i)))/beam%h
         share = min(max(share, 0.0_wp), 1.0_wp)
         beam%kinked(:, i) = share*well%bend/well%bend_length*[cos(beam%clock(i) + well%toolface), &
                                                               sin(beam%clock(i) + well%toolface)]
      end do
   contains
      pure function heavy(part) result(w)
         integer, intent(in) :: part
         real(wp) :: w
         w = well%mass(part)*well%gravity*(1.0_wp - well%mud/steel)
      end function heavy
   end subroutine lay_out

   pure function component_of(well, x) result(part)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: x
      integer :: part
      real(wp) :: top
      top = well%bit
      do part = 1, size(well%od) - 1
         top = top - well%length(part)
         if (x > top) return
      end do
   end function component_of

   !> The frame without spin at a depth, and the hole's curvature in it: from arc to arc, turned about each arc's axis.
   pure subroutine frame_at(well, x, t, n_1, n_2, k)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: x
      real(wp), intent(out) :: t(3), n_1(3), n_2(3), k(2)
      real(wp) :: next(3), axis(3), sine, angle, length, share
      integer :: arc
      t = direction(1)
      n_1 = [1.0_wp, 0.0_wp, 0.0_wp]
      if (hypot(t(1), t(2)) > 1.0e-9_wp) n_1 = [0.0_wp, 0.0_wp, -1.0_wp]
      n_1 = n_1 - t*dot_product(n_1, t)
      n_1 = n_1/norm2(n_1)
      do arc = 1, size(well%md) - 1
         next = direction(arc + 1)
         axis = cross(t, next)
         sine = norm2(axis)
         angle = atan2(sine, dot_product(t, next))
         length = well%md(arc + 1) - well%md(arc)
         share = min((x - well%md(arc))/length, 1.0_wp)
         n_2 = cross(t, n_1)
         k = 0.0_wp
         if (sine > 1.0e-12_wp) then
            axis = axis/sine
            next = cross(axis, t)
            k = angle/length*[dot_product(next, n_1), dot_product(next, n_2)]
            t = turned(t, axis, share*angle)
            n_1 = turned(n_1, axis, share*angle)
         end if
         if (x <= well%md(arc + 1)) exit
      end do
      n_2 = cross(t, n_1)
   contains
      pure function direction(station) result(d)
         integer, intent(in) :: station
         real(wp) :: d(3), i, a
         i = well%inclination(station)*pi/180.0_wp
         a = well%azimuth(station)*pi/180.0_wp
         d = [sin(i)*cos(a), sin(i)*sin(a), cos(i)]
      end function direction
   end subroutine frame_at

   !> Axial force and torque from the bit up, for the contact and the shear force found so far.
   pure subroutine sum_up(well, beam)
      type(independent_well_type), intent(in) :: well
      type(independent_beam_type), intent(inout) :: beam
      real(wp) :: rise, grip
      integer :: i
      beam%axial(beam%n) = -well%wob
      beam%torque(beam%n) = well%tob
      do i = beam%n, 1, -1
         grip = 0.5_wp*(beam%contact(i - 1) + beam%contact(i))      ! the ends are held without friction
         rise = beam%h*beam%along(i) + well%along*grip &
                - 0.5_wp*beam%h*dot_product(beam%shear(:, i), beam%curvature(:, i - 1) + beam%curvature(:, i))
         beam%tension(i) = beam%axial(i) + 0.5_wp*rise
         beam%axial(i - 1) = beam%axial(i) + rise
         rise = well%around*0.5_wp*(beam%radius(i - 1)*beam%contact(i - 1) + beam%radius(i)*beam%contact(i))
         beam%twist(i) = beam%torque(i) + 0.5_wp*rise
         beam%torque(i - 1) = beam%torque(i) + rise
      end do
   end subroutine sum_up

   !> Offsets in equilibrium under T and M_t as they are, by Newton's method. A step is shortened until the residual's work along it
   !> has fallen: under tension and without friction the residual is the slope of a convex energy.
   subroutine find_offsets(well, wall, beam, found)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: wall               !< [N/m2]
      type(independent_beam_type), intent(inout) :: beam
      logical, intent(out) :: found
      real(wp), allocatable :: band(:, :), residual(:, :), step(:, :), start(:, :)
      integer, allocatable :: pivots(:)
      real(wp) :: work, now, low, high, share, load
      integer :: iteration, trial, info, unknowns
      unknowns = 2*(beam%n + 1)
      allocate (band(3*width + 1, unknowns), pivots(unknowns), residual(2, 0:beam%n), step(2, 0:beam%n))
      load = maxval(beam%h*norm2(beam%weight, dim=1)) + maxval(beam%h*abs(beam%tension)*norm2(beam%k_cell, dim=1)) &
             + maxval(beam%ei*(norm2(beam%k_node, dim=1) + norm2(beam%kinked, dim=1)))/beam%h
      found = .false.
      do iteration = 1, 150
         call evaluate(well, wall, beam, residual, band)
         found = maxval(abs(residual)) < rest*load
         if (found) exit
         step = -residual
         call dgbtrf(unknowns, unknowns, width, width, band, size(band, 1), pivots, info)
         if (info /= 0) return
         call dgbtrs('N', unknowns, width, width, 1, band, size(band, 1), pivots, step, unknowns, info)
         start = beam%y
         work = sum(residual*step)
         low = 0.0_wp
         high = 1.0_wp
         share = 1.0_wp
         do trial = 1, 12
            beam%y = start + share*step
            call evaluate(well, wall, beam, residual)
            now = sum(residual*step)
            if (abs(now) <= 0.8_wp*abs(work) .or. work >= 0.0_wp .or. (now < 0.0_wp .and. share >= 1.0_wp)) exit
            if (now > 0.0_wp) high = share
            if (now <= 0.0_wp) low = share
            share = 0.5_wp*(low + high)
         end do
      end do
   end subroutine find_offsets

   !> Forces out of balance across the hole at the nodes [N], from the moments, the shear forces and the contact of these offsets.
   !> The derivative by the offsets is found where it is asked for. Both ends are held on the hole axis.
   subroutine evaluate(well, wall, beam, residual, band)
      type(independent_well_type), intent(in) :: well
      real(wp), intent(in) :: wall
      type(independent_beam_type), intent(inout) :: beam
      real(wp), intent(out) :: residual(:, 0:)
      real(wp), intent(out), optional :: band(:, :)
      real(wp), dimension(2) :: n, tau, through
      real(wp) :: couple(2, 0:beam%n)
      real(wp) :: distance, h, spin(2, 2), normal(2, 2), swing(2, 2), unit(2, 2), lever, force, sign
      integer :: i, j, k, side
      h = beam%h
      spin = reshape([0.0_wp, 1.0_wp, -1.0_wp, 0.0_wp], [2, 2])      ! t x
      unit = reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])
      residual = 0.0_wp
      couple = 0.0_wp
      beam%contact = 0.0_wp
      if (present(band)) band = 0.0_wp
      do i = 1, beam%n - 1
         beam%curvature(:, i) = beam%k_node(:, i) + (beam%y(:, i - 1) - 2.0_wp*beam%y(:, i) + beam%y(:, i + 1))/h**2
         beam%moment(:, i) = beam%ei(i)*(beam%curvature(:, i) - beam%kinked(:, i))
         do j = -1, 1
            residual(:, i + j) = residual(:, i + j) + second(j)/h*beam%moment(:, i)
            if (.not. present(band)) cycle
            do k = -1, 1
               call add(i + j, i + k, second(j)*second(k)*beam%ei(i)/h**3*unit)
            end do
         end do
         residual(:, i) = residual(:, i) - h*beam%weight(:, i)
         distance = norm2(beam%y(:, i))
         if (distance <= beam%clearance(i)) cycle
         n = beam%y(:, i)/distance
         tau = matmul(spin, n)
         force = wall*h*(distance - beam%clearance(i))
         lever = well%along*beam%radius(i)
         beam%contact(i) = force
         residual(:, i) = residual(:, i) + force*(n + well%around*tau)
         couple(:, i) = lever*force/h*n
         if (.not. present(band)) cycle
         do j = 1, 2
            normal(:, j) = wall*h*n*n(j) + force/distance*tau*tau(j)
            swing(:, j) = wall*h*tau*n(j) - force/distance*n*tau(j)
         end do
         call add(i, i, normal + well%around*swing)
         call add(i - 1, i, -0.5_wp*lever/h*normal)               ! the couple of the two cells beside the node
         call add(i + 1, i, 0.5_wp*lever/h*normal)
      end do
      do i = 1, beam%n
         beam%shear(:, i) = -(beam%moment(:, i) - beam%moment(:, i - 1))/h + 0.5_wp*(couple(:, i - 1) + couple(:, i)) &
                            - 0.5_wp*beam%twist(i)*matmul(spin, beam%curvature(:, i - 1) + beam%curvature(:, i))
         through = beam%tension(i)/h*(beam%y(:, i) - beam%y(:, i - 1)) + 0.5_wp*(couple(:, i - 1) + couple(:, i)) &
                   - 0.5_wp*beam%twist(i)*matmul(spin, beam%curvature(:, i - 1) + beam%curvature(:, i))
         do side = 0, 1
            sign = 1.0_wp - 2.0_wp*side
            residual(:, i - side) = residual(:, i - side) + sign*through - 0.5_wp*h*beam%tension(i)*beam%k_cell(:, i)
            if (.not. present(band)) cycle
            call add(i - side, i, sign*beam%tension(i)/h*unit)
            call add(i - side, i - 1, -sign*beam%tension(i)/h*unit)
            do j = max(i - 1, 1), min(i, beam%n - 1)
               do k = -1, 1
                  call add(i - side, j + k, -sign*0.5_wp*beam%twist(i)*second(k)/h**2*spin)
               end do
            end do
         end do
      end do
      residual(:, [0, beam%n]) = 0.0_wp
      if (.not. present(band)) return
      do i = -width, width
         do j = 1, 2
            call hold(j + i, j)
            call hold(2*beam%n + j + i, 2*beam%n + j)
         end do
      end do
   contains
      !> Adds the derivative of the residual of one node by the offset of another.
      subroutine add(row, column, block)
         integer, intent(in) :: row, column
         real(wp), intent(in) :: block(2, 2)
         integer :: a, b
         do b = 1, 2
            do a = 1, 2
               associate (place => band(2*width + 1 + 2*(row - column) + a - b, 2*column + b))
                  place = place + block(a, b)
               end associate
            end do
         end do
      end subroutine add

      !> Takes an unknown that is held out of the equations of another one.
      subroutine hold(other, held)
         integer, intent(in) :: other, held
         if (other < 1 .or. other > size(band, 2)) return
         band(2*width + 1 + other - held, held) = merge(1.0_wp, 0.0_wp, other == held)
         band(2*width + 1 + held - other, other) = merge(1.0_wp, 0.0_wp, other == held)
      end subroutine hold
   end subroutine evaluate

   !> Values at the nodes, by straight lines, at a place in the hole.
   pure function value_at(beam, values, x) result(value)
      type(independent_beam_type), intent(in) :: beam
      real(wp), intent(in) :: values(0:)
      real(wp), intent(in) :: x
      real(wp) :: value, share
      integer :: i
      i = min(max(int(x/beam%h), 0), beam%n - 1)
      share = x/beam%h - i
      value = (1.0_wp - share)*values(i) + share*values(i + 1)
   end function value_at

   !> Side force of the string at its lower end [N], and its slope there [-], along the axes of the frame at the high side (1) and
   !> right of it (2). Without an offset the clock of the last node is minus that of the frame's axis.
   pure subroutine push_at_bit(beam, push, slope)
      type(independent_beam_type), intent(in) :: beam
      real(wp), intent(out) :: push(2), slope(2)
      integer :: n
      n = beam%n
      slope = (beam%y(:, n) - beam%y(:, n - 1))/beam%h
      push = -beam%tension(n)*slope - beam%shear(:, n) + 0.5_wp*beam%h*(beam%weight(:, n) + beam%tension(n)*beam%k_node(:, n))
      slope = slope - 0.5_wp*beam%h*beam%k_node(:, n)           ! the end is not bent
      push = to_high_side(push, beam%clock(n))
      slope = to_high_side(slope, beam%clock(n))
   contains
      pure function to_high_side(v, angle) result(w)
         real(wp), intent(in) :: v(2), angle
         real(wp) :: w(2)
         w = [cos(angle)*v(1) - sin(angle)*v(2), sin(angle)*v(1) + cos(angle)*v(2)]
      end function to_high_side
   end subroutine push_at_bit

   pure function cross(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)
      c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
   end function cross

   pure function turned(v, axis, angle) result(w)
      real(wp), intent(in) :: v(3), axis(3), angle
      real(wp) :: w(3)
      w = v*cos(angle) + cross(axis, v)*sin(angle) + axis*(dot_product(axis, v)*(1.0_wp - cos(angle)))
   end function turned
end module dg_independent_beam

!> The start of a compressed string: sinusoids and helices of buckling theory, phase included.
!>
!> From the straight state the iteration would have to grow every turn from zero, left- and right-handed by chance. It would
!> then have to work the reversals out of the string. Amplitude and pitch are known from theory. So is the place of the waves
!> along the hole, which depends on the ends of the buckled part. To shift a whole sinusoid by a quarter wave takes Newton's
!> method ten to twenty iterations, as the path is curved.
module dg_buckled_start
   use dg_buckling_limits, only: sinusoidal_limit
   use dg_helical_load, only: helical_contact, helical_load
   use dg_constants, only: pi
   use dg_kinds, only: wp
   use dg_mesh, only: mesh_type
   use dg_model, only: model_type
   use dg_sinusoidal_shape, only: sinusoidal_swing, sinusoidal_wave
   use dg_trajectory, only: high_side
   implicit none
   private
   public :: lay_buckled

   !> State of the string at a node.
   integer, parameter :: stretched = 0, on_low_side = 1, sinusoidal = 2, helical = 3
   !> End of a sinusoid: its load fades; an end in the middle of the hole; a stiffer part that does not buckle; a helix.
   integer, parameter :: fades = 0, centred_end = 1, stiff_part = 2, coil_beyond = 3
   !> Distance of the first zero of the sine from the end of the buckled part [half waves], and extra phase of its envelope
   !> there [rad]. For an end in the middle of the hole they follow from linear theory at the load of onset. The sinusoidal
   !> shape a (x + x_0) cos(x + phi) is joined to a string that hangs free between the axis and the wall. With the side load n,
   !> l = (EI c/n)^(1/4). That string is 1.745 l long and presses with 2.019 n l where it touches. At a part r times as stiff
   !> the values are 1 - 1/(2 r) and 0. A rigid part is a clamp. Solutions by beams have 0.73 at heavy-weight pipe (r = 1.9)
   !> and 0.87 to 0.93 at collars (r = 5).
   real(wp), parameter :: zero_at_end = 0.730_wp, lead_at_end = 2.926_wp
   real(wp), parameter :: zero_at_clamp = 1.0_wp, zero_by_stiffness = 0.5_wp
   !> Phase from a centred end at which a helix turns at its full rate [rad]. In solutions by beams it turns a quarter turn
   !> late.
   real(wp), parameter :: coil_turns = pi
   !> Angle to the low side, before it, at which a helix leaves the middle of the hole [rad]. At this angle its weight is
   !> lowest. Its end turns slowly as in `held_back`, at the height of a beam between axis and wall.
   real(wp), parameter :: lag_at_end = 0.92_wp
   !> Largest change of length of the waves, over it, that fits them to both ends of a zone [-].
   real(wp), parameter :: largest_stretch = 0.25_wp
   !> Ratio of bending stiffnesses that ends a sinusoid [-].
   real(wp), parameter :: much_stiffer = 1.5_wp

   !> End of a zone.
   type :: end_type
      integer :: kind = fades
      real(wp) :: zero = 0.0_wp   !< distance of a sinusoid's first zero from there [half waves]
      real(wp) :: lead = 0.0_wp   !< extra phase of a sinusoid's envelope [rad]
   end type end_type

   !> A run of nodes in the same state.
   type :: zone_type
      integer :: first, last
      type(end_type) :: above, below
   end type zone_type

contains

   !> Give a string that the soft string finds compressed by F its buckled shape:
   !> - above the helical load a helix against the wall, of pitch 2 pi sqrt(2 EI/F) and contact force c F^2/(4 EI) per metre
   !> - above the load of Dawson & Paslay a sinusoid about the side on which the string lies (dg_sinusoidal_shape)
   !> - else a helix of the size of the imperfection, as an exactly straight string could not leave that state
   pure subroutine lay_buckled(model, mesh, axial, wall, load, offset, slope)
      type(model_type), intent(in) :: model
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)           !< tension > 0, by node [N]
      real(wp), intent(in) :: wall(:)            !< stiffness per length, by element [N/m2]
      real(wp), intent(inout) :: load(:)         !< contact force per metre, by node [N/m]
      real(wp), intent(inout) :: offset(:, :), slope(:, :)   !< (2,nodes) [m, -]
      integer :: regime(mesh%nodes), i, e
      real(wp) :: rate(mesh%nodes), phase(mesh%nodes), angle
      type(zone_type) :: zone
      call classify_nodes(mesh, axial, load, regime, rate)
      if (.not. model%numerics%tuning%start_buckled) where (regime /= stretched) regime = on_low_side
      phase = 0.0_wp
      do i = 2, mesh%nodes
         phase(i) = phase(i - 1) + rate(i)*(mesh%md(i) - mesh%md(i - 1))
      end do
      zone%first = 1
      do while (zone%first <= mesh%nodes)
         zone%last = last_like(regime, zone%first)
         zone%above = what_ends(mesh, regime, zone%first, -1, model%boundary%top_centred)
         zone%below = what_ends(mesh, regime, zone%last, 1, model%boundary%bit_centred)
         select case (regime(zone%first))
         case (helical)
            angle = atan2(offset(2, zone%first), offset(1, zone%first)) - lag(zone%above)
            call set_helix(mesh, zone, axial, rate, wall, phase, angle, load, offset, slope)
         case (sinusoidal)
            call set_sinusoid(mesh, zone, axial, load, rate, phase, offset, slope)
         case (on_low_side)
            do i = max(zone%first, 2), zone%last
               e = min(i, mesh%elements)
               offset(:, i) = offset(:, i) + model%numerics%imperfection*mesh%clearance(e)*[cos(phase(i)), sin(phase(i))]
            end do
         case default      ! in tension: unchanged
         end select
         zone%first = zone%last + 1
      end do
      if (model%numerics%tuning%start_mirrored) call mirror(mesh, offset, slope)
   end subroutine lay_buckled

   !> Replace a line by its image in a mirror in the vertical plane along the hole. In a vertical hole the mirror is in the
   !> plane through north.
   pure subroutine mirror(mesh, offset, slope)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(inout) :: offset(:, :), slope(:, :)   !< (2,nodes) [m, -]
      real(wp) :: up(3), across(2)
      integer :: i
      do i = 1, mesh%nodes
         associate (t => mesh%frame(:, 1, i), n_1 => mesh%frame(:, 2, i), n_2 => mesh%frame(:, 3, i))
            up = high_side(t)
            across = [-dot_product(up, n_2), dot_product(up, n_1)]       ! out of the mirror
         end associate
         offset(:, i) = offset(:, i) - 2.0_wp*dot_product(offset(:, i), across)*across
         slope(:, i) = slope(:, i) - 2.0_wp*dot_product(slope(:, i), across)*across
      end do
   end subroutine mirror

   !> Find the state of the string at each node, and its wave number [rad/m].
   pure subroutine classify_nodes(mesh, axial, load, regime, rate)
      type(mesh_type), intent(in) :: mesh
      real(wp), intent(in) :: axial(:)
      real(wp), intent(inout) :: load(:)      !< by node [N/m]; between two parts, on return, the load of the weaker part
      integer, intent(out) :: regime(:)
      real(wp), intent(out) :: rate(:)
      real(wp) :: swing
      integer :: i, e
      do i = 1, mesh%nodes
         e = weaker(mesh, i)
         regime(i) = stretched
         rate(i) = 0.0_wp
         if (.not. axial(i) < 0.0_wp) cycle
         regime(i) = on_low_side
         rate(i) = sqrt(-axial(i)/(2.0_wp*mesh%section(e)%ei))
         if (-axial(i) > helical_load(mesh%section(e)%ei, load(i), mesh%weight(e), mesh%clearance(e))) then
            regime(i) = helical
         else
            swing = sinusoidal_swing(ratio_to_onset(mesh, e, -axial(i), load(i)))
            if (.not. swing > 0.0_wp) cycle
            regime(i) = sinusoidal
            rate(i) = (load(i)/(mesh%section(e)%ei*mesh%clearance(e)))**0.25_wp*sinusoidal_wave(swing)
         end if
      end do
      do i = 2, mesh%elements
         e = 0
         if (mesh%section(i)%ei > much_stiffer*mesh%section(i - 1)%ei) e = i - 1
         if (mesh%section(i - 1)%ei > much_stiffer*mesh%section(i)%ei) e = i + 1
         if (e == 0) cycle
         regime(i) = regime(e)
         rate(i) = rate(e)
         load(i) = load(e)
      end do
      call join_zones(mesh%md, rate, regime)
   end subroutine classify_nodes

   !> Join a sinusoid or helix that is shorter than half a wave to the other one beside it. Otherwise they would alternate
   !> where the load changes from station to station.
   pure subroutine join_zones(md, rate, regime)
      real(wp), intent(in) :: md(:), rate(:)
      integer, intent(inout) :: regime(:)
      integer :: first, last
      first = 1
      do while (first <= size(md))
         last = last_like(regime, first)
         if (regime(first) >= sinusoidal .and. sum(rate(first + 1:last)*(md(first + 1:last) - md(first:last - 1))) < pi) then
            if (regime(max(first - 1, 1)) >= sinusoidal .and. first > 1) then
               regime(first:last) = regime(first - 1)
            else if (regime(min(last + 1, size(md))) >= sinusoidal) then
               regime(first:last) = regime(min(last + 1, size(md)))
            end if
         end if
         first = last + 1
      end do
   end subroutine join_zones

   !> Last of the nodes from `first` on that are in the same state.
   pure function last_like(regime, first) result(last)
      integer, intent(in) :: regime(:), first
      integer :: last
      last = first
      do while (last < size(regime))
         if (regime(last + 1) /= regime(first)) exit
         last = last + 1
      end do
   end function last_like

   !> Compression over the sinusoidal limit under the side load, 0 without side load [-].
   pure function ratio_to_onset(mesh, e, compression, load) result(ratio)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: e
      real(wp), intent(in) :: compression, load   !< [N, N/m]
      real(wp) :: ratio
      ratio = 0.0_wp
      if (load > 0.0_wp) ratio = compression/sinusoidal_limit(mesh%section(e)%ei, load, mesh%clearance(e))
   end function ratio_to_onset

   !> Element next to a node that has the smaller bending stiffness.
   pure function weaker(mesh, node) result(e)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: node
      integer :: e
      integer :: above
      above = max(node - 1, 1)
      e = min(node, mesh%elements)
      if (mesh%section(above)%ei < mesh%section(e)%ei) e = above
   end function weaker

   !> Distance of a node from the axis [m], and its change along the hole [-]; for a node on the axis, the clearance.
   pure subroutine radius_of(clearance, offset, slope, radius, growth)
      real(wp), intent(in) :: clearance
      real(wp), intent(in) :: offset(2), slope(2)
      real(wp), intent(out) :: radius, growth
      radius = norm2(offset)
      growth = 0.0_wp
      if (radius > 0.0_wp) then
         growth = dot_product(offset, slope)/radius
      else
         radius = clearance
      end if
   end subroutine radius_of

   !> Kind of end of the zone at one of its nodes: its lower end where `side` is 1, its upper end where it is -1.
   pure function what_ends(mesh, regime, node, side, centred) result(ends)
      type(mesh_type), intent(in) :: mesh
      integer, intent(in) :: regime(:)
      integer, intent(in) :: node, side
      logical, intent(in) :: centred
      type(end_type) :: ends
      real(wp) :: stiffness
      integer :: inside, beyond
      if (node + side < 1 .or. node + side > mesh%nodes) then
         if (centred) ends = end_type(centred_end, zero_at_end, lead_at_end)
      else if (regime(node + side) == helical .or. (regime(node) == helical .and. regime(node + side) == sinusoidal)) then
         ends%kind = coil_beyond
      else
         beyond = min(max(merge(node + side, node, side < 0), 1), mesh%elements)
         inside = min(max(merge(node, node - 1, side < 0), 1), mesh%elements)
         stiffness = mesh%section(beyond)%ei/mesh%section(inside)%ei
         if (stiffness > much_stiffer) &
            ends = end_type(stiff_part, zero_at_clamp - zero_by_stiffness/stiffness, 0.0_wp)
      end if
   end function what_ends

   !> Set a helix from the position of the string above it on. If the string below it has a position too, the turns are
   !> stretched to end there.
   pure subroutine set_helix(mesh, zone, axial, rate, wall, phase, start, load, offset, slope)
      type(mesh_type), intent(in) :: mesh
      type(zone_type), intent(in) :: zone
      real(wp), intent(in) :: axial(:), rate(:), wall(:), phase(:)
      real(wp), intent(in) :: start           !< angle at its upper end [rad]
      real(wp), intent(inout) :: load(:), offset(:, :), slope(:, :)
      real(wp) :: side(2), turns, stretch, angle, away, left, force, radius, growth
      integer :: i, e
      turns = phase(zone%last) - phase(zone%first)
      turns = turns - held_back(zone%above, turns) - held_back(zone%below, turns)
      stretch = 1.0_wp
      side = offset(:, min(zone%last + 1, mesh%nodes))
      if (norm2(side) > 0.0_wp) stretch = stretched_by(turns, atan2(side(2), side(1)) + lag(zone%below) - start, 2.0_wp*pi)
      do i = zone%first, zone%last
         e = weaker(mesh, i)
         force = helical_contact(mesh%section(e)%ei, -axial(i), mesh%clearance(e))
         call radius_of(mesh%clearance(e), offset(:, i), slope(:, i), radius, growth)
         radius = radius + max(force - load(i), 0.0_wp)/wall(e)
         away = phase(i) - phase(zone%first)
         left = phase(zone%last) - phase(i)
         angle = start + stretch*(away - held_back(zone%above, away) + held_back(zone%below, left) &
                                  - held_back(zone%below, away + left))
         offset(:, i) = radius*[cos(angle), sin(angle)]
         slope(:, i) = growth*[cos(angle), sin(angle)] &
                       + radius*stretch*rate(i)*turning(zone%above, away)*turning(zone%below, left)*[-sin(angle), cos(angle)]
         load(i) = max(load(i), force)
      end do
   end subroutine set_helix

   !> Angle by which the end of a helix lags behind the side on which it lies [rad].
   pure function lag(ends) result(angle)
      type(end_type), intent(in) :: ends
      real(wp) :: angle
      angle = merge(lag_at_end, 0.0_wp, ends%kind == centred_end)
   end function lag

   !> Angle that a helix has not turned at a phase x from its end [rad]. Between the axis and the wall it does not turn: from a
   !> centred end its rate grows as (1 - cos x)/2. Where it reaches the wall, the rate is u = beta tanh(beta s) with
   !> beta^2 = F/(2 EI). This solves the beam's equation along the wall without torque, EI (u'' - 2 u^3) + F u = 0 (Mitchell
   !> 1988).
   pure function held_back(ends, away) result(angle)
      type(end_type), intent(in) :: ends
      real(wp), intent(in) :: away    !< [rad]
      real(wp) :: angle
      angle = 0.0_wp
      if (ends%kind == centred_end) angle = 0.5_wp*(min(away, coil_turns) + sin(min(away, coil_turns)))
      if (ends%kind == fades .or. ends%kind == stiff_part) angle = log(2.0_wp) - log(1.0_wp + exp(-2.0_wp*away))
   end function held_back

   !> Rate of turning there over that of the whole helix [-].
   pure function turning(ends, away) result(part)
      type(end_type), intent(in) :: ends
      real(wp), intent(in) :: away    !< [rad]
      real(wp) :: part
      part = 1.0_wp
      if (ends%kind == centred_end) part = 0.5_wp*(1.0_wp - cos(min(away, coil_turns)))
      if (ends%kind == fades .or. ends%kind == stiff_part) part = tanh(away)
   end function turning

   !> Set a sinusoid about the side on which the string lies, with its waves fitted to its ends.
   pure subroutine set_sinusoid(mesh, zone, axial, load, rate, phase, offset, slope)
      type(mesh_type), intent(in) :: mesh
      type(zone_type), intent(in) :: zone
      real(wp), intent(in) :: axial(:), load(:), rate(:), phase(:)
      real(wp), intent(inout) :: offset(:, :), slope(:, :)
      real(wp) :: above, below, stretch, sense, wave, ratio, swing, rise, side, radius, growth
      integer :: i, e
      above = -pi*zone%above%zero
      below = pi*zone%below%zero
      stretch = 1.0_wp
      if (zone%above%kind /= fades .and. zone%below%kind /= fades) then
         stretch = stretched_by(phase(zone%last) - phase(zone%first), below - above, pi)
      else if (zone%below%kind /= fades) then
         above = below - (phase(zone%last) - phase(zone%first))
      end if
      sense = 1.0_wp
      if (zone%below%kind == coil_beyond) sense = sign(sense, cos(above + stretch*(phase(zone%last) - phase(zone%first))))
      do i = zone%first, zone%last
         e = weaker(mesh, i)
         ratio = ratio_to_onset(mesh, e, -axial(i), load(i))
         rise = sqrt(max(ratio - 1.0_wp, 0.0_wp))
         swing = sense*sinusoidal_swing(ratio)
         swing = swing*envelope(zone%above, rise, phase(i) - phase(zone%first)) &
                 *envelope(zone%below, rise, phase(zone%last) - phase(i))
         wave = above + stretch*(phase(i) - phase(zone%first))
         side = atan2(offset(2, i), offset(1, i)) + swing*sin(wave)
         call radius_of(mesh%clearance(e), offset(:, i), slope(:, i), radius, growth)
         offset(:, i) = radius*[cos(side), sin(side)]
         slope(:, i) = growth*[cos(side), sin(side)] + radius*swing*stretch*rate(i)*cos(wave)*[-sin(side), cos(side)]
      end do
   end subroutine set_sinusoid

   !> Factor on a phase that makes it `wanted` plus a whole number of `unit`, or 1 if that changes it too much.
   pure function stretched_by(phase, wanted, unit) result(factor)
      real(wp), intent(in) :: phase, wanted, unit   !< [rad]
      real(wp) :: factor
      factor = 1.0_wp
      if (.not. phase > 0.0_wp) return
      factor = (wanted + unit*anint((phase - wanted)/unit))/phase
      if (abs(factor - 1.0_wp) > largest_stretch) factor = 1.0_wp
   end function stretched_by

   !> Part of its full swing that a sinusoid has at a phase from its end [-]. It is the envelope A(x) of w = A exp(i x) near
   !> the onset: 2 A'' + (b - 1) A = const A^3, with A = 0 at -x_0.
   pure function envelope(ends, rise, away) result(part)
      type(end_type), intent(in) :: ends
      real(wp), intent(in) :: rise    !< sqrt(b - 1), b compression over the load of onset [-]
      real(wp), intent(in) :: away    !< [rad]
      real(wp) :: part
      part = 1.0_wp
      if (ends%kind == centred_end .or. ends%kind == stiff_part) part = tanh(0.5_wp*rise*(away + ends%lead))
   end function envelope
end module dg_buckled_start

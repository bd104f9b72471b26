!> Random wells against what must hold for any well. Arguments: first seed, number of seeds, and `any` or `drilled` for one part
!> alone: wells of any shape, or wells as they are drilled (dg_drilled_part). Where none are given: 20 seeds of the first, 10 of the
!> other.
!>
!> Of every well: the case converges, locks up or is marked; every number is one; forces balance; a well turned about the
!> vertical, and of a string that neither turns nor carries torque the mirror image, give the same; a component in
!> two parts and a station more on an arc change nothing beyond the mesh; the frictional resistance is no more than friction times
!> contact force; up pulls more than hanging free, down less, and more friction makes both more so.
program random
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_fortran_env, only: output_unit
   use dg_case_result, only: case_result_type, result_converged, result_locked_up
   use dg_component, only: bending_stiffness
   use dg_drilled_part, only: check_drilled_wells
   use dg_error, only: error_type
   use dg_kinds, only: wp
   use dg_load_case, only: operation_name, operation_rotate_off_bottom, operation_trip_in, operation_trip_out, &
      moves_axially, rotates
   use dg_model, only: model_type
   use dg_random_well, only: draw_well, lay_path, split_component, stations_type
   use dg_soft_string, only: solve_soft_string
   use dg_static_analysis, only: solve_static_analysis
   use dg_trajectory, only: arc_at, arc_type
   implicit none

   integer, parameter :: balance = 1, turned = 2, mirrored = 3, parted = 4, stationed = 5, bounded = 6, ordered = 7, &
      steeper = 8, agreed = 9, turned_compressed = 10, coiled = 11, checks = 11
   character(*), parameter :: name_of(checks) = [character(56) :: 'forces out of balance over the largest force', &
      'well turned about the vertical', 'mirror image of the well', 'component in two parts', 'one more station on an arc', &
      'friction beyond coefficient times contact force', 'up below free, free below down', &
      'more friction, less resistance', 'soft string in two parts, with a station more', &
      'turned or mirrored, with compression or another way', 'a coil changed in any of these ways']
   !> Largest part of the largest force in the string [-]. Balance, and a turned or mirrored well, are round-off and what the
   !> iteration leaves (1e-9 of the weight at any of some hundred nodes), where the string is in tension; a compressed one has
   !> equilibria next to each other, with a gap more or less in contact, and round-off decides between them. What changes the mesh
   !> shows the mesh's error, of elements up to 30 m; the soft string is integrated finely. A coil, whose contact force is half as
   !> much again as the soft string's or more, rests wherever its friction holds it. Round-off also decides where gaps that move for
   !> long come to rest: turned wells then take other ways, seen by their iterations and moves.
   real(wp), parameter :: tolerance(checks) = [1.0e-6_wp, 1.0e-5_wp, 1.0e-5_wp, 5.0e-3_wp, 5.0e-3_wp, 1.0e-3_wp, 1.0e-3_wp, &
      1.0e-3_wp, 1.0e-4_wp, 5.0e-4_wp, 1.0e-3_wp]
   integer, parameter :: default_first = 1, default_count = 20, default_drilled = 10
   !> Cases that may be marked as not converged: one in so many, and one.
   integer, parameter :: marked_one_in = 20
   !> Compression over the largest force [-] from which a string counts as compressed.
   real(wp), parameter :: compression = 1.0e-3_wp
   real(wp), parameter :: coil = 1.5_wp
   real(wp), parameter :: more_friction = 1.3_wp
   real(wp), parameter :: turn = 137.0_wp      ! deg

   real(wp) :: worst(checks)
   integer :: worst_seed(checks), compared(checks), first, number, seed, solved, marked, passed, failed, locked
   character(8) :: part
   logical :: sound
   worst = 0.0_wp
   worst_seed = 0
   compared = 0
   solved = 0
   marked = 0
   locked = 0
   passed = 0
   failed = 0
   call read_arguments(first, number, part)
   if (part /= 'drilled') call check_wells()
   if (command_argument_count() < 2) number = default_drilled
   if (part /= 'any') call check_drilled_wells(first, number, passed, failed)
   write (output_unit, '(i0,a,i0,a)') passed, ' passed, ', failed, ' failed'
   if (failed > 0) error stop 1

contains

   !> Wells of any shape, seed by seed.
   subroutine check_wells()
      integer :: i
      do seed = first, first + number - 1
         sound = .true.
         call check_well(seed)
         if (sound) then
            passed = passed + 1
         else
            failed = failed + 1
         end if
      end do
      write (output_unit, '(a,i0,a,i0,a,i0,a,i0,a,i0,a)') 'seeds ', first, ' to ', first + number - 1, ': ', solved, &
         ' cases solved, ', locked, ' locked up, ', marked, &
         ' marked as not converged'
      do i = 1, checks
         write (output_unit, '(2x,a,a,es8.1,a,i0,a,es8.1,a,i0,a)') name_of(i), ' worst ', worst(i), ' (seed ', worst_seed(i), &
            '), allowed ', tolerance(i), ', ', compared(i), ' compared'
      end do
      if (marked > 1 + solved/marked_one_in) then
         write (output_unit, '(a)') 'FAIL too many cases marked'
         failed = failed + 1
      else
         passed = passed + 1
      end if
   end subroutine check_wells

   !> All checks of one seed.
   subroutine check_well(seed)
      integer, intent(in) :: seed
      type(stations_type) :: stations, other
      type(model_type) :: model, changed
      type(case_result_type) :: result, again, free, soft, soft_again
      real(wp) :: scale, depth
      logical :: good, good_again, good_free, compressed, coils
      integer :: n, i
      call draw_well(seed, stations, model)
      call lay_path(stations, model)
      call soft_string(model, soft)
      call solve(model, result, good)
      scale = max(maxval(abs(soft%profile%axial)), abs(model%cases(1)%wob), 1.0_wp)
      n = size(stations%md)

      ! a new station half-way along the deepest course: on the arc inclination and azimuth follow from its middle tangent
      changed = model
      other = with_station(stations)
      call lay_path(other, changed)
      depth = 0.4_wp*(model%cases(1)%bit_depth - sum(model%strings(1)%components%length))
      if (depth > 1.0_wp) call split_component(depth, changed)
      call soft_string(changed, soft_again)
      call note(agreed, abs(soft_again%hookload - soft%hookload)/scale)
      if (.not. good) return
      ! a string that whirls has no static equilibrium: its message says what is left out
      if (index(result%message, 'whirl') == 0) call note(balance, result%equilibrium_force/scale)
      compressed = min(minval(result%profile%axial), minval(soft%profile%axial)) < -compression*scale
      coils = result%normal_force > coil*soft%normal_force

      changed = model
      call lay_path(other, changed)
      call solve(changed, again, good_again)
      if (good_again .and. same_places(result, again)) call note(merge(coiled, stationed, coils), &
                                abs(again%hookload - result%hookload)/largest(scale, result))
      if (depth > 1.0_wp) then
         changed = model
         call split_component(depth, changed)
         call solve(changed, again, good_again)
         if (good_again .and. same_places(result, again)) call note(merge(coiled, parted, coils), &
                                   abs(again%hookload - result%hookload)/largest(scale, result))
      end if

      other = stations
      other%azimuth = modulo(stations%azimuth + turn, 360.0_wp)
      changed = model
      call lay_path(other, changed)
      call solve(changed, again, good_again)
      if (good_again) call note_turned(turned, compressed, coils, scale, result, again)
      if (.not. rotates(model%cases(1)%operation) .and. .not. model%cases(1)%tob > 0.0_wp) then
         other%azimuth = modulo(-stations%azimuth, 360.0_wp)
         call lay_path(other, changed)
         call solve(changed, again, good_again)
         if (good_again) call note_turned(mirrored, compressed, coils, scale, result, again)
      end if
      if (moves_axially(model%cases(1)%operation)) call note_friction(model, scale, result)

      ! the same string off bottom, hanging free, up and down
      changed = model
      changed%cases(1)%wob = 0.0_wp
      changed%cases(1)%tob = 0.0_wp
      changed%cases(1)%operation = operation_rotate_off_bottom
      call solve(changed, free, good_free)
      do i = 1, 2
         changed%cases(1)%operation = merge(operation_trip_out, operation_trip_in, i == 1)
         changed%holes = model%holes
         call solve(changed, result, good)
         changed%holes%friction_axial = more_friction*model%holes%friction_axial
         call solve(changed, again, good_again)
         associate (way => merge(1.0_wp, -1.0_wp, i == 1))
            if (good) call note_friction(model, scale, result)
            if (good .and. good_free) call note(ordered, way*(free%hookload - result%hookload)/scale)
            if (good .and. good_again) call note(steeper, way*(result%hookload - again%hookload)/scale)
         end associate
      end do
   end subroutine check_well

   !> A turned or mirrored well: the same to digits, but where round-off decides between places of gaps or of a coil.
   subroutine note_turned(way, compressed, coils, scale, result, again)
      integer, intent(in) :: way                 !< turned or mirrored
      logical, intent(in) :: compressed, coils
      real(wp), intent(in) :: scale
      type(case_result_type), intent(in) :: result, again
      if (coils) then
         call note(coiled, abs(again%hookload - result%hookload)/largest(scale, result))
      else
         call note(merge(turned_compressed, way, compressed .or. another_way(result, again)), &
                   abs(again%hookload - result%hookload)/scale)
      end if
   end subroutine note_turned

   !> Frictional resistance against what the contact force allows. A stiff string that slides out of a bend gives back the energy
   !> of bending E I k^2/2 per length that it had there, at its ends and wherever its stiffness jumps: that is no friction, but
   !> stands in the hook load all the same.
   subroutine note_friction(model, scale, result)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: scale
      type(case_result_type), intent(in) :: result
      real(wp) :: bending, depth, stiffer
      type(arc_type) :: arc
      integer :: i
      depth = model%cases(1)%bit_depth
      bending = 0.0_wp
      stiffer = 0.0_wp
      associate (parts => model%strings(1)%components)
         do i = 1, size(parts)
            arc = model%trajectory%arcs(arc_at(model%trajectory, depth))
            bending = bending + 0.5_wp*abs(bending_stiffness(parts(i)) - stiffer)*arc%curvature**2
            stiffer = bending_stiffness(parts(i))
            depth = depth - parts(i)%length
         end do
         arc = model%trajectory%arcs(arc_at(model%trajectory, 0.0_wp))
         bending = bending + 0.5_wp*stiffer*arc%curvature**2
      end associate
      call note(bounded, (abs(result%friction) - model%holes(1)%friction_axial*result%normal_force - bending)/ &
                largest(scale, result))
   end subroutine note_friction

   !> The largest force in the string, of the soft one or of beams [N].
   pure function largest(scale, result) result(force)
      real(wp), intent(in) :: scale
      type(case_result_type), intent(in) :: result
      real(wp) :: force
      force = max(scale, maxval(abs(result%profile%axial)))
   end function largest

   !> True if both results have their gaps where the deck asks for them. A result that does not carries a message with the size of
   !> the effect.
   pure function same_places(a, b) result(same)
      type(case_result_type), intent(in) :: a, b
      logical :: same
      same = index(a%message//b%message, 'Converged only with') == 0
   end function same_places

   !> True if two solutions converged by different paths, their gaps perhaps at other places.
   pure function another_way(a, b) result(another)
      type(case_result_type), intent(in) :: a, b
      logical :: another
      another = a%iterations /= b%iterations .or. a%moves /= b%moves
   end function another_way

   !> Solves the case by beams; `good` where it converged to numbers.
   subroutine solve(model, result, good)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(out) :: result
      logical, intent(out) :: good
      type(error_type), allocatable :: error
      call solve_static_analysis(model, 1, result, error)
      good = .false.
      if (allocated(error)) then
         call fail('refused: '//error%message)
         return
      end if
      solved = solved + 1
      good = result%status == result_converged
      if (result%status == result_locked_up) then
         locked = locked + 1
      else if (.not. good) then
         marked = marked + 1
         write (output_unit, '(a,i0,5a,f0.2,a)') 'marked: seed ', seed, ', ', trim(operation_name(model%cases(1)%operation)), &
            ', ', result%message, ' (elements ', model%numerics%element_length, ' m)'
      else if (.not. all(ieee_is_finite([result%hookload, result%torque, result%normal_force, result%equilibrium_force])) &
               .or. .not. all(ieee_is_finite(result%profile%axial)) .or. .not. all(ieee_is_finite(result%profile%bending))) then
         call fail('converged to no number')
         good = .false.
      end if
   end subroutine solve

   subroutine soft_string(model, result)
      type(model_type), intent(in) :: model
      type(case_result_type), intent(out) :: result
      type(error_type), allocatable :: error
      call solve_soft_string(model, 1, result, error)
      if (allocated(error)) call fail('soft string refused: '//error%message)
   end subroutine soft_string

   !> A survey with one more station, in the middle of the arc of its last course.
   function with_station(stations) result(more)
      use dg_constants, only: degree
      use dg_survey, only: azimuth_of, inclination_of, tangent_of
      type(stations_type), intent(in) :: stations
      type(stations_type) :: more
      real(wp) :: middle(3)
      integer :: n
      n = size(stations%md)
      middle = tangent_of(stations%inclination(n - 1)*degree, stations%azimuth(n - 1)*degree) + &
               tangent_of(stations%inclination(n)*degree, stations%azimuth(n)*degree)
      middle = middle/norm2(middle)
      more%md = [stations%md(:n - 1), 0.5_wp*(stations%md(n - 1) + stations%md(n)), stations%md(n)]
      more%inclination = [stations%inclination(:n - 1), inclination_of(middle)/degree, stations%inclination(n)]
      more%azimuth = [stations%azimuth(:n - 1), azimuth_of(middle)/degree, stations%azimuth(n)]
   end function with_station

   !> Notes how far a check is off; beyond its tolerance the seed fails.
   subroutine note(check, off)
      integer, intent(in) :: check
      real(wp), intent(in) :: off      !< over the largest force in the string [-]
      character(80) :: text
      compared(check) = compared(check) + 1
      if (off > worst(check)) then
         worst(check) = off
         worst_seed(check) = seed
      end if
      if (off <= tolerance(check)) return
      write (text, '(a,es9.2)') ': ', off
      call fail(trim(name_of(check))//trim(text))
   end subroutine note

   subroutine fail(what)
      character(*), intent(in) :: what
      sound = .false.
      write (output_unit, '(a,i0,2a)') 'FAIL seed ', seed, ': ', what
   end subroutine fail

   !> First seed, number of seeds, and which part; '' for both.
   subroutine read_arguments(first, number, part)
      integer, intent(out) :: first, number
      character(*), intent(out) :: part
      character(32) :: word
      integer :: status
      first = default_first
      number = default_count
      part = ''
      if (command_argument_count() < 2) return
      call get_command_argument(1, word)
      read (word, *, iostat=status) first
      call get_command_argument(2, word)
      if (status == 0) read (word, *, iostat=status) number
      call get_command_argument(3, part)
      if (status /= 0 .or. all(part /= [character(7) :: '', 'any', 'drilled'])) &
         error stop 'usage: random FIRST_SEED NUMBER_OF_SEEDS [any | drilled]'
   end subroutine read_arguments
end program random

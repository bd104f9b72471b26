!> Message on a case that did not converge: the place of the largest error, and the attempts.
module dg_no_equilibrium
   use dg_kinds, only: wp
   use dg_case_result, only: case_result_type, result_not_converged
   use dg_drillstring, only: component_at, component_tops
   use dg_model, only: model_type, string_index
   use dg_numerics, only: numerics_type
   use dg_text, only: either, to_text
   use dg_trajectory, only: top_md
   use dg_unit_kind, only: in_units, unit_length
   implicit none
   private
   public :: add_place, add_tried, list_tried, no_stable

   !> Beginning of the message on a string in balance that a small push moves away.
   character(*), parameter :: no_stable = 'No stable equilibrium found'

   !> Digits of a length and of a depth in a message.
   integer, parameter :: shown = 2, shown_depth = 6

contains

   !> Adds a depth, and the component of the string there, to a text: "2345.1 m, in 'HWDP'".
   pure subroutine add_place(model, case_index, md, text)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      real(wp), intent(in) :: md         !< [m]
      character(:), allocatable, intent(inout) :: text
      real(wp), allocatable :: tops(:)
      real(wp) :: bit
      bit = model%cases(case_index)%bit_depth
      text = text//in_units(model%units, unit_length, md, shown_depth)
      associate (string => model%strings(string_index(model%strings, model%cases(case_index)%string)))
         allocate (tops, source=component_tops(string, bit - top_md(model%trajectory)))
         associate (part => string%components(component_at(tops, bit - md)))
            if (allocated(part%name)) then
               if (part%name /= '') text = text//", in '"//part%name//"'"
            end if
         end associate
      end associate
   end subroutine add_place

   !> Adds the attempts on one mesh to a list in words: 'elements up to 5 m (2 starts), 1.2 m (1)'.
   pure subroutine list_tried(model, longest, attempts, text)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: longest                   !< length of an element [m]
      integer, intent(in) :: attempts
      character(:), allocatable, intent(inout) :: text
      character(:), allocatable :: mesh
      mesh = in_units(model%units, unit_length, longest, shown)//' ('//to_text(attempts)
      if (allocated(text)) then
         text = text//', '//mesh//')'
      else
         text = 'elements up to '//mesh//either(' start)', ' starts)', attempts == 1)
      end if
   end subroutine list_tried

   !> Add to the message of a case without equilibrium what was tried, why the search ended, and what helps. Advice of the message
   !> so far is enough.
   pure subroutine add_tried(model, case_index, tried, worked_out, result)
      type(model_type), intent(in) :: model
      integer, intent(in) :: case_index
      character(*), intent(in) :: tried                 !< on all meshes
      logical, intent(in) :: worked_out                 !< true if a mesh has used its allowed work
      type(case_result_type), intent(inout) :: result
      type(numerics_type) :: usual
      logical :: few_allowed, unstable
      if (result%status /= result_not_converged) return
      few_allowed = .not. worked_out .and. model%numerics%max_iterations < usual%max_iterations
      unstable = index(result%message, no_stable) == 1
      associate (load_case => model%cases(case_index))
         if (few_allowed) then
            result%message = result%message//'. Set max_iterations to '//to_text(usual%max_iterations)// &
               ', its default, which allows more attempts'
         else if (unstable .and. (load_case%wob > 0.0_wp .or. abs(load_case%tob) > 0.0_wp)) then
            result%message = result%message//'. Lower wob or tob'
         else if (index(result%message, '. Set ') == 0) then
            result%message = result%message//'. Check the loads of this case: no setting of &solver is known to help. '// &
               'Model soft solves it without bending stiffness'// &
               either(': its NO holds, its yes may not', '', result%coiled)
         end if
      end associate
      result%message = result%message//'. Tried in '//to_text(result%iterations)//' iterations: '//tried
      if (worked_out) result%message = result%message//'. The search ended at the most work that '//to_text(result%elements)// &
         ' elements may have'
   end subroutine add_tried
end module dg_no_equilibrium

!> All data on which the results of a string depend, in words: one line `key = value` a property, in SI units. Two models with
!> the same lines give the same results. A line that differs names the difference.
module dg_model_text
   use dg_kinds, only: wp
   use dg_centralizer, only: centralizer_type
   use dg_component, only: component_type, visit_forces
   use dg_fluid, only: fluid_type
   use dg_hole_section, only: hole_section_type, visit_hole
   use dg_job, only: model_name
   use dg_key_visitor, only: key_visitor_type
   use dg_line_list, only: add_line, line_list_type
   use dg_load_case, only: operation_name
   use dg_missing, only: is_missing
   use dg_model, only: model_type, string_index
   use dg_numerics, only: numerics_type
   use dg_sweep, only: at_operation, sweep_type
   use dg_task_record, only: solver_key
   use dg_text, only: either, joined, text_type, to_text
   use dg_version, only: program_name, program_version
   implicit none
   private
   public :: model_lines, sweep_lines, append_sweep, append_numbers, yes_or_no

   integer, parameter :: longest_settings = 2000
   !> Numbers in one line: a line of a record may have a hundred kilobytes, and a survey any number of stations.
   integer, parameter :: most_in_line = 1000

   !> Writes a line for each number that it visits; those that are missing are left out.
   type, extends(key_visitor_type) :: line_writer_type
      type(line_list_type), pointer :: lines => null()
      character(:), allocatable :: head
   contains
      procedure :: number => write_number
   end type line_writer_type

contains

   !> Description of a sweep, with its string, hole and solver.
   function sweep_lines(model, sweep) result(texts)
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      type(text_type), allocatable :: texts(:)
      type(line_list_type) :: lines
      call append_sweep(lines, model, sweep)
      allocate (texts, source=lines%lines(:lines%count))
   end function sweep_lines

   !> Append the description of a sweep to lines.
   subroutine append_sweep(lines, model, sweep)
      type(line_list_type), intent(inout) :: lines
      type(model_type), intent(in) :: model
      type(sweep_type), intent(in) :: sweep
      character(:), allocatable :: text
      integer :: i
      call append_model(lines, model, sweep%string)
      call add_line(lines, 'sweep = '//sweep%name)
      call add_line(lines, 'models = '//joined(model_name(sweep%models), ' '))
      call add_line(lines, 'operations = '//joined(operation_name(sweep%operations), ' '))
      text = ''
      do i = 1, size(sweep%frictions)
         if (sweep%frictions(i)%present) then
            text = text//' '//to_text(sweep%frictions(i)%value)
         else
            text = text//' hole'
         end if
      end do
      call add_line(lines, 'frictions ='//text)
      if (allocated(sweep%frictions_cased)) then
         call append_numbers(lines, 'frictions of cased sections', sweep%frictions_cased)
         do i = 1, size(model%holes)
            call add_line(lines, 'hole '//to_text(i)//', cased = '//yes_or_no(model%holes(i)%cased))
         end do
      end if
      call append_loads(lines, 'wob', sweep%wob)
      call append_loads(lines, 'tob', sweep%tob)
      call append_loads(lines, 'rotation, rad/s', sweep%angular_speed)
      call append_loads(lines, 'trip speed, m/s', sweep%trip_speed)
      call add_line(lines, 'first bit depth, m = '//to_text(sweep%depths(1)))
      call add_line(lines, 'last bit depth, m = '//to_text(sweep%depths(size(sweep%depths))))
      call add_line(lines, 'number of bit depths = '//to_text(size(sweep%depths)))
      call append_numbers(lines, 'bit depths, m', sweep%depths)
   end subroutine append_sweep

   !> A load of all operations, or one of each.
   subroutine append_loads(lines, key, loads)
      type(line_list_type), intent(inout) :: lines
      character(*), intent(in) :: key
      real(wp), allocatable, intent(in) :: loads(:)
      logical :: one
      one = .not. allocated(loads)
      if (.not. one) one = size(loads) <= 1
      if (one) then
         call add_line(lines, key//' = '//to_text(at_operation(loads, 1)))
      else
         call append_numbers(lines, key, loads)
      end if
   end subroutine append_loads

   !> The model with one of its strings; its load cases are left out.
   function model_lines(model, string) result(texts)
      type(model_type), intent(in) :: model
      character(*), intent(in) :: string     !< its name
      type(text_type), allocatable :: texts(:)
      type(line_list_type) :: lines
      call append_model(lines, model, string)
      allocate (texts, source=lines%lines(:lines%count))
   end function model_lines

   subroutine append_model(lines, model, string)
      type(line_list_type), intent(inout) :: lines
      type(model_type), intent(in) :: model
      character(*), intent(in) :: string     !< its name
      integer :: i
      call add_line(lines, program_name//' = '//program_version)
      call add_line(lines, 'survey, number of stations = '//to_text(size(model%trajectory%md)))
      call append_numbers(lines, 'survey, md', model%trajectory%md)
      call append_numbers(lines, 'survey, inclination', model%trajectory%inclination)
      call append_numbers(lines, 'survey, azimuth', model%trajectory%azimuth)
      call add_line(lines, 'survey, number of arcs = '//to_text(size(model%trajectory%arcs)))
      do i = 1, size(model%holes)
         call append_hole(lines, 'hole '//to_text(i)//', ', model%holes(i))
      end do
      associate (pipes => model%strings(string_index(model%strings, string))%components)
         call add_line(lines, 'string = '//string//' of '//to_text(size(pipes)))
         do i = 1, size(pipes)
            call append_component(lines, 'component '//to_text(i)//', ', pipes(i))
         end do
      end associate
      if (allocated(model%mud%fluids)) then
         do i = 1, size(model%mud%fluids)
            call append_fluid(lines, 'fluid '//to_text(i)//', ', model%mud%fluids(i))
         end do
      end if
      call add_line(lines, 'gravity = '//to_text(model%gravity))
      call add_line(lines, 'boundary, top centred = '//yes_or_no(model%boundary%top_centred))
      call add_line(lines, 'boundary, bit centred = '//yes_or_no(model%boundary%bit_centred))
      if (model%boundary%packer_bore > 0.0_wp) &
         call add_line(lines, 'boundary, packer_bore = '//to_text(model%boundary%packer_bore))
      call add_line(lines, solver_key//' = '//settings_text(model%numerics))
   end subroutine append_model

   subroutine append_fluid(lines, head, fluid)
      type(line_list_type), intent(inout) :: lines
      character(*), intent(in) :: head
      type(fluid_type), intent(in) :: fluid
      call add_line(lines, head//'inside = '//yes_or_no(fluid%inside))
      call add_line(lines, head//'outside = '//yes_or_no(fluid%outside))
      call add_line(lines, head//'density = '//to_text(fluid%density))
      call add_line(lines, head//'md_top = '//to_text(fluid%md_top))
      call add_line(lines, head//'above_bit = '//to_text(fluid%above_bit))
      if (fluid%surface_pressure > 0.0_wp) call add_line(lines, head//'surface_pressure = '//to_text(fluid%surface_pressure))
   end subroutine append_fluid

   subroutine write_number(self, key, value)
      class(line_writer_type), intent(inout) :: self
      character(*), intent(in) :: key
      real(wp), intent(inout) :: value              !< stays as it is
      call add_line(self%lines, self%head//key//' = '//to_text(value))
   end subroutine write_number

   subroutine append_hole(lines, head, hole)
      type(line_list_type), intent(inout), target :: lines
      character(*), intent(in) :: head
      type(hole_section_type), intent(in) :: hole
      type(line_writer_type) :: writer
      type(hole_section_type) :: visited
      visited = hole
      writer%lines => lines
      writer%head = head
      call visit_hole(visited, writer)
   end subroutine append_hole

   !> Append the data of a component that act on forces; strength and make-up torque do not.
   subroutine append_component(lines, head, part)
      type(line_list_type), intent(inout), target :: lines
      character(*), intent(in) :: head
      type(component_type), intent(in) :: part
      type(line_writer_type) :: writer
      type(component_type) :: visited
      call add_line(lines, head//'kind = '//part%kind)
      visited = part
      writer%lines => lines
      writer%head = head
      call visit_forces(visited, writer)
      if (part%centralizer%present) call append_centralizer(lines, head//'centralizer ', part%centralizer)
   end subroutine append_component

   subroutine append_centralizer(lines, head, centralizer)
      type(line_list_type), intent(inout) :: lines
      character(*), intent(in) :: head
      type(centralizer_type), intent(in) :: centralizer
      call add_line(lines, head//'kind = '//either('bow', 'rigid', centralizer%bow))
      call add_line(lines, head//'od = '//to_text(centralizer%od))
      call add_line(lines, head//'spacing = '//to_text(centralizer%spacing))
      call add_line(lines, head//'first = '//to_text(centralizer%first))
      call add_line(lines, head//'restoring_force = '//to_text(centralizer%restoring_force))
      call add_line(lines, head//'rated_hole = '//to_text(centralizer%rated_hole))
      call add_line(lines, head//'running_force = '//to_text(centralizer%running_force))
      if (.not. is_missing(centralizer%friction_axial)) &
         call add_line(lines, head//'friction_axial = '//to_text(centralizer%friction_axial))
      if (.not. is_missing(centralizer%friction_rotary)) &
         call add_line(lines, head//'friction_rotary = '//to_text(centralizer%friction_rotary))
   end subroutine append_centralizer

   !> All settings of the solver in the order of their type: list-directed output takes in those that come new.
   function settings_text(numerics) result(text)
      type(numerics_type), intent(in) :: numerics
      character(:), allocatable :: text
      character(longest_settings) :: buffer
      integer :: i
      write (buffer, *) numerics
      text = ''
      do i = 1, len_trim(buffer)
         if (buffer(i:i) == ' ' .and. buffer(max(i - 1, 1):max(i - 1, 1)) == ' ') cycle
         text = text//buffer(i:i)
      end do
   end function settings_text

   !> A switch in words.
   pure function yes_or_no(flag) result(text)
      logical, intent(in) :: flag
      character(:), allocatable :: text
      text = either('yes', 'no', flag)
   end function yes_or_no

   !> `key = numbers`, in as many lines as they need.
   subroutine append_numbers(lines, key, numbers)
      type(line_list_type), intent(inout) :: lines
      character(*), intent(in) :: key
      real(wp), intent(in) :: numbers(:)
      integer :: first
      call add_line(lines, key//' ='//numbers_text(numbers(:min(size(numbers), most_in_line))))
      do first = most_in_line + 1, size(numbers), most_in_line
         call add_line(lines, key//', from '//to_text(first)//' ='// &
                          numbers_text(numbers(first:min(size(numbers), first + most_in_line - 1))))
      end do
   end subroutine append_numbers

   pure function numbers_text(numbers) result(text)
      real(wp), intent(in) :: numbers(:)
      character(:), allocatable :: text
      integer, parameter :: width = 24
      character(width) :: one
      integer :: i
      allocate (character(width*size(numbers)) :: text)
      do i = 1, size(numbers)
         write (one, '(es24.15e3)') numbers(i)
         text(width*(i - 1) + 1:width*i) = one
      end do
   end function numbers_text
end module dg_model_text

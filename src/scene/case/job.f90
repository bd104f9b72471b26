!> Models to run and place of results: the part of a deck outside mechanics.
module dg_job
   use dg_text, only: text_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: job_type, model_mcge, model_soft, model_rigid, model_mixed, model_count, model_name, model_meaning, leading_model, &
             is_divided

   integer, parameter :: model_mcge = 1  !< nonlinear beams with contact gap elements (the paper)
   integer, parameter :: model_soft = 2  !< flexible: soft string
   integer, parameter :: model_rigid = 3 !< stiff string that follows the hole axis
   integer, parameter :: model_mixed = 4 !< stiff where stiffness matters, soft elsewhere
   integer, parameter :: model_count = 4
   !> Names in decks and files, in the order of the numbers above.
   character(*), parameter :: model_name(model_count) = [character(5) :: 'mcge', 'soft', 'rigid', 'mixed']
   !> Short descriptions.
   character(*), parameter :: model_meaning(model_count) = [character(26) :: 'beams with contact', 'soft string', &
      'stiff string on the axis', 'stiff and soft string']

   type :: job_type
      character(:), allocatable :: title
      character(:), allocatable :: deck_path   !< as the user typed it
      character(:), allocatable :: output_dir
      type(text_type), allocatable :: inputs(:) !< paths of the files that were read: deck, survey, catalogue, tables
      type(unit_system_type) :: units
      integer, allocatable :: models(:)        !< numbers of the models to run, in the deck's order
      type(text_type), allocatable :: study_files(:)    !< names of the results that studies write
      type(text_type), allocatable :: study_records(:)  !< names of the records of unfinished work
      type(text_type), allocatable :: study_forms(:)    !< forms of names of results by studies of any deck: sweep_*.csv
      type(text_type), allocatable :: study_kinds(:)    !< beginnings of names of such records: sweep
      character(:), allocatable :: deck_text   !< the deck itself, for the record
      type(text_type), allocatable :: notes(:) !< legal but unusual settings of the deck
      logical :: profiles = .true.             !< write profiles along the string
      logical :: hdf5 = .true.                 !< write results.h5
      logical :: plots = .true.                !< write pictures and files for ParaView
      logical :: quiet = .false.
      integer :: part = 1                      !< part of the sweeps that this run solves, from 1 to parts
      integer :: parts = 0                     !< 0: undivided; else only sweeps are run, and only this part of them
      integer :: merge = 0                     !< > 0: so many parts are joined, and no case is solved
      logical :: again = .false.               !< points that did not converge are solved again, with other settings of the solver
      integer :: threads = 0                   !< number of cases solved at a time; 0: all cores
   end type job_type

contains

   !> Number of the model whose results come first: beams with gap elements if the deck has them, else the first of the deck.
   pure function leading_model(job) result(model)
      type(job_type), intent(in) :: job
      integer :: model
      model = job%models(1)
      if (any(job%models == model_mcge)) model = model_mcge
   end function leading_model

   !> True if a run solves one part of its points, or joins parts. It does nothing else then.
   pure function is_divided(job) result(is)
      type(job_type), intent(in) :: job
      logical :: is
      is = job%parts > 0 .or. job%merge > 0
   end function is_divided
end module dg_job

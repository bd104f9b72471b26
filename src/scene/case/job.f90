!> What to run and where results go: the part of a deck that is no mechanics.
module dg_job
   use dg_calibration, only: calibration_type
   use dg_design_factors, only: design_factors_type
   use dg_legacy_table, only: legacy_table_type
   use dg_load_case, only: optional_real
   use dg_steering, only: steering_type
   use dg_sticking, only: sticking_type
   use dg_study_plan, only: study_plan_type
   use dg_sweep, only: sweep_type
   use dg_text, only: text_type
   use dg_uncertainty, only: uncertainty_type
   use dg_units, only: unit_system_type
   implicit none
   private
   public :: job_type, model_mcge, model_soft, model_rigid, model_mixed, model_count, model_name

   integer, parameter :: model_mcge = 1  !< nonlinear beams with contact gap elements (the paper)
   integer, parameter :: model_soft = 2  !< flexible: soft string
   integer, parameter :: model_rigid = 3 !< stiff string that follows the hole axis
   integer, parameter :: model_mixed = 4 !< stiff where stiffness matters, soft elsewhere
   integer, parameter :: model_count = 4
   !> Names in decks and files, in the order of the numbers above.
   character(*), parameter :: model_name(model_count) = [character(5) :: 'mcge', 'soft', 'rigid', 'mixed']

   type :: job_type
      character(:), allocatable :: title
      character(:), allocatable :: deck_path   !< as the user typed it
      character(:), allocatable :: output_dir
      type(text_type), allocatable :: inputs(:) !< paths of the files that were read: deck, survey, catalogue, tables
      type(unit_system_type) :: units
      integer, allocatable :: models(:)        !< numbers of the models to run, in the deck's order
      type(legacy_table_type), allocatable :: legacy(:) !< other programs' results, beside ours
      type(study_plan_type), allocatable :: study       !< accuracy and cost to compare; not allocated: nothing
      type(sweep_type), allocatable :: sweeps(:) !< over bit depth
      type(calibration_type), allocatable :: calibrations(:) !< of friction, from measurements
      type(uncertainty_type), allocatable :: uncertainties(:) !< Monte Carlo over bit depth
      type(steering_type), allocatable :: steering      !< assemblies that are asked where they drill to; not allocated: none
      type(sticking_type), allocatable :: stickings(:) !< strings that are held, from measurements
      type(optional_real) :: rig_limit         !< hook load that the rig may carry [N]
      type(design_factors_type) :: design      !< of strengths
      character(:), allocatable :: deck_text   !< the deck itself, for the record
      logical :: profiles = .true.             !< write profiles along the string
      logical :: hdf5 = .true.                 !< write results.h5
      logical :: plots = .true.                !< write files to look at
      logical :: quiet = .false.
      integer :: part = 1                      !< of the sweeps, the one that this run solves, from 1 to parts
      integer :: parts = 0                     !< 0: undivided; else sweeps alone are run, and only this part of them
      integer :: merge = 0                     !< > 0: so many parts are joined, nothing is solved
      logical :: again = .false.               !< points that did not converge are solved again, with other settings of the solver
      integer :: threads = 0                   !< cases solved at a time; 0: all cores
   end type job_type
end module dg_job

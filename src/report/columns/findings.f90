!> All results of a run: its load cases with their stresses, limits and verdicts. Tables, files, pictures and the page are
!> made from them.
module dg_findings
   use dg_along_string, only: along_string_type
   use dg_case_result, only: case_result_type
   use dg_job, only: job_type
   use dg_model, only: model_type
   use dg_verdict, only: answer_yes
   use dg_whole_string, only: whole_string_type
   implicit none
   private
   public :: findings_type, name_of, rows_of, are_marked

   type :: findings_type
      type(job_type) :: job
      type(model_type) :: model                             !< with friction that a study has found and applied
      type(case_result_type), allocatable :: results(:)     !< all cases of the first model come first
      type(along_string_type), allocatable :: alongs(:)     !< as many
      type(whole_string_type), allocatable :: wholes(:)     !< as many
   end type findings_type

contains

   !> Name of the load case of a result.
   pure function name_of(found, row) result(name)
      type(findings_type), intent(in) :: found
      integer, intent(in) :: row            !< number of the result
      character(:), allocatable :: name
      name = found%model%cases(found%results(row)%case_index)%name
   end function name_of

   !> Numbers of the results by a model.
   pure function rows_of(found, model) result(rows)
      type(findings_type), intent(in) :: found
      integer, intent(in) :: model          !< its number
      integer, allocatable :: rows(:)
      integer :: i
      rows = pack([(i, i=1, size(found%results))], found%results%model == model)
   end function rows_of

   !> True for results that tables and pictures mark: the answer is NO, or it is not known.
   pure function are_marked(found) result(marked)
      type(findings_type), intent(in) :: found
      logical :: marked(size(found%results))
      marked = found%wholes%verdict%answer /= answer_yes
   end function are_marked
end module dg_findings

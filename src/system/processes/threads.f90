!> Number of threads for independent work.
module dg_threads
   !$ use omp_lib, only: omp_get_max_threads
   implicit none
   private
   public :: thread_count

contains

   !> Number of threads for `tasks` independent pieces of work: the wanted number, with 0 for all cores (or OMP_NUM_THREADS).
   !> It is at most the number of pieces. It is one if the program was built without OpenMP.
   function thread_count(wanted, tasks) result(threads)
      integer, intent(in) :: wanted
      integer, intent(in) :: tasks
      integer :: threads
      threads = max(wanted, 1)
      !$ if (wanted == 0) threads = omp_get_max_threads()
      threads = max(1, min(threads, tasks))
   end function thread_count
end module dg_threads

#!/bin/bash
# A sweep as a job array of Slurm: each task solves one part of the deck, a last job joins them. Say how many parts once:
#
#   parts=40
#   job=$(sbatch --parsable --array=1-$parts sweep_slurm.sh DECK.nml $parts)
#   sbatch --dependency=afterany:$job sweep_slurm.sh DECK.nml $parts --merge
#
# A merge that lacks parts joins nothing and names them, ready for --array: sbatch --array=3,7-9 sweep_slurm.sh DECK.nml 40.
# What was solved is not solved again, so a task that ran out of time is just started once more.
# Points that did not converge: change settings of the solver in the deck, then sbatch --array=3,7 sweep_slurm.sh DECK.nml 40 --again
# for the parts that the merge named, and merge with --again.
#SBATCH --job-name=drillgap
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --output=drillgap_%A_%a.log
# A minute before its time is up the task ends by itself and says how far it came.
#SBATCH --signal=B:TERM@60
if ! [[ $2 =~ ^[1-9][0-9]*$ ]]; then
   echo 'usage: sbatch --array=1-PARTS sweep_slurm.sh DECK.nml PARTS [options of drillgap]' >&2
   echo '   or: sbatch sweep_slurm.sh DECK.nml PARTS --merge [options of drillgap]' >&2
   exit 2
fi
case $1 in
/*) deck=$1 ;;
*) deck=./$1 ;; # a name may begin with a minus sign
esac
export OPENBLAS_NUM_THREADS=1
if [ "$3" = --merge ]; then exec drillgap "$deck" --merge "$2" "${@:4}"; fi
exec drillgap "$deck" --part "${SLURM_ARRAY_TASK_ID:?start this by sbatch --array=1-$2}/$2" \
   --threads "${SLURM_CPUS_PER_TASK:-1}" "${@:3}"

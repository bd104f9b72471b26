#!/bin/bash
# A sweep in parts by GNU parallel, as many at a time as there are cores, then joined:
#
#   sweep_parallel.sh DECK.nml 40
#
# Other machines that share the folder take their share where PARALLEL names them: PARALLEL='--sshlogin a,b --workdir .'.
# A merge that lacks parts joins nothing and names them. Start this again then: what was solved is not solved again.
# Points that did not converge: change settings of the solver in the deck, then sweep_parallel.sh DECK.nml 40 --again.
if [ $# -lt 2 ]; then
   echo 'usage: sweep_parallel.sh DECK.nml PARTS [options of drillgap]' >&2
   exit 2
fi
export OPENBLAS_NUM_THREADS=1
# One thread a part: the parts share the cores. A part that fails is left to the merge to name.
seq "$2" | parallel drillgap "$1" --part "{}/$2" --threads 1 --quiet "${@:3}"
exec drillgap "$1" --merge "$2" "${@:3}"

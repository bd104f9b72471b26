#!/bin/bash
# A sweep in parts by GNU parallel, as many at a time as there are cores, then joined:
#
#   sweep_parallel.sh DECK.nml 40
#
# Other machines that share the folder take their share where PARALLEL names them: PARALLEL='--sshlogin a,b --workdir .'.
# A merge that lacks parts joins nothing and names them. Start this again then: what was solved is not solved again.
# Points that did not converge: change settings of the solver in the deck, then sweep_parallel.sh DECK.nml 40 --again.
if ! [[ $2 =~ ^[1-9][0-9]*$ ]]; then
   echo 'usage: sweep_parallel.sh DECK.nml PARTS [options of drillgap]' >&2
   exit 2
fi
case $1 in
/*) deck=$1 ;;
*) deck=./$1 ;; # a name may begin with a minus sign
esac
parts=$2
options=("${@:3}")
export OPENBLAS_NUM_THREADS=1
# The words of a command are inputs of parallel, which quotes them for the shell. Words of its template would be read by that shell.
command='drillgap {1} --part {2} --threads 1 --quiet'
for ((i = 0; i < ${#options[@]}; i++)); do command+=" {$((i + 3))}"; done
# One thread a part: the parts share the cores. A part that fails is left to the merge to name.
for ((part = 1; part <= parts; part++)); do
   printf '%s\0' "$deck" "$part/$parts" "${options[@]}"
done | parallel --null --max-args $((2 + ${#options[@]})) "$command"
exec drillgap "$deck" --merge "$parts" "${options[@]}"

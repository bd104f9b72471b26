#!/usr/bin/env python3
"""What moments at the default settings cost, in instructions, which no busy machine changes: each load case of each deck alone, by
valgrind's callgrind. Prints the solution with moments over that without them, and the solution on elements of 1 m without them
over the default; then medians, least and largest. Checks nothing.

Of a deck's &solver only tool_joints and gap_location stay. A case counts where it is solved, by both settings for the second number.

Usage: price_of_moments.py PROGRAM FOLDER DECK...      (needs valgrind; files that decks name are looked for in input/)
"""
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys

FOOT = 0.3048
# Else long copies count byte by byte, which no processor does.
COPIES = "glibc.cpu.x86_rep_movsb_threshold=100000000:glibc.cpu.x86_rep_stosb_threshold=100000000"
WITHOUT_MOMENTS = "fidelity = 'fast', tolerance = 1e-9, "     # else as the default: gap_location is set where it is not given


def group(name):
    return re.compile(rf"^&{name}\b.*?/[ \t]*(?:!.*)?$", re.S | re.M)


def solution(program, text, solver, folder):
    """Instructions of the solution and of its moments; None where there is no solution."""
    deck = folder / "deck.nml"
    deck.write_text(f"{text}\n&solver {solver} /\n", encoding="utf-8")
    out = folder / "callgrind.out"
    run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", program, deck, "--output", folder / "run",
                          "--quiet", "--threads", "1"], capture_output=True, check=False, env=os.environ | {"GLIBC_TUNABLES": COPIES})
    if run.returncode:
        return None
    listed = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", out], capture_output=True, text=True,
                            check=True).stdout
    found = [re.search(rf"([\d,]+) \([^)]*\)  \S*:__dg_{name}\b", listed)
             for name in ("static_analysis_MOD_solve_static_analysis", "bending_profile_MOD_bend_profile")]
    return [int(match[1].replace(",", "")) if match else 0 for match in found]


def cases(deck):
    """Name, deck text of the case alone, what stays of &solver, metres in the deck's unit of length."""
    text = re.sub(r"^!.*$", "", deck.read_text(encoding="utf-8"), flags=re.M)
    kept = ", ".join(re.findall(r"(?:tool_joints|gap_location)\s*=\s*'\w+'", " ".join(group("solver").findall(text))))
    loads = group("load_case").findall(text)
    for name in ("load_case", "solver", "legacy", "study", "sweep", "calibrate", "uncertainty"):
        text = group(name).sub("", text)
    text = re.sub(r"models\s*=\s*'\w+'(\s*,\s*'\w+')*", "models = 'mcge'", text)
    text = re.sub(r"(plots|hdf5|profiles)\s*=\s*\.\w+\.\s*,?", "", text)
    text = re.sub(r"^&job\b", "&job plots = .false., hdf5 = .false., profiles = .false., ", text, flags=re.M)
    metre = 1.0 / FOOT if re.search(r"units\s*=\s*'field'", text) else 1.0
    for load in loads:
        yield re.search(r"name\s*=\s*'([^']*)'", load)[1], f"{text}\n{load}", kept + ", " if kept else "", metre


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree("input", folder)
    prices, short = [], []
    for deck in map(pathlib.Path, sys.argv[3:]):
        for name, text, kept, metre in cases(deck):
            default = solution(program, text, kept, folder)
            if not default or not default[1]:
                continue
            gaps = "" if "gap_location" in kept else "gap_location = 'extremum', "
            other = solution(program, text, f"{kept}{WITHOUT_MOMENTS}{gaps}element_length = {metre:.9g}", folder)
            prices.append(default[0] / (default[0] - default[1]))
            if other:
                short.append(other[0] / default[0])
            print(f"{deck.name:28s} {name:20s} with over without {prices[-1]:5.2f}, 1 m over default "
                  + (f"{short[-1]:6.2f}" if other else "     -"), flush=True)
    for what, numbers in (("with moments over without", prices), ("1 m over default", short)):
        print(f"{len(numbers)} cases, {what}: median {statistics.median(numbers):.2f}, {min(numbers):.2f} to {max(numbers):.2f}")


if __name__ == "__main__":
    main()

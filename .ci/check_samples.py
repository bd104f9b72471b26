#!/usr/bin/env python3
"""Runs the sample decks of input/ as a user does and checks what came out.

Each deck begins with two lines or more on what it shows, ends with status 0 and nothing on standard error, every row of its
summary.csv converged, and its page and pictures are there. Beams and soft string, independent of each other, must agree on
the hook load within the limit below: what a slip in a deck (a diameter, a unit) would break. What a comment '! prints: ...'
promises must stand in the output.

Usage: check_samples.py PROGRAM RESULTS_FOLDER
"""
import csv
import pathlib
import subprocess
import sys
import time

# Checked with more care elsewhere: gp1 by check_gp1.py, sweep_gp1 with its parts by .ci/run.
ELSEWHERE = {"gp1.nml", "sweep_gp1.nml"}
MODELS_APART = 5.0      # % of the largest hook load of the deck


def faults_of(program, deck, folder):
    lines = deck.read_text(encoding="utf-8").splitlines()
    comments, promises = lines[:2], [line.split(": ", 1)[1] for line in lines if line.startswith("! prints: ")]
    faults = [] if all(line.startswith("! ") for line in comments) else ["does not begin with two lines on what it shows"]
    start = time.time()
    run = subprocess.run([program, deck, "--output", folder], capture_output=True, text=True, timeout=300, check=False)
    print(f"{deck.name:28s} {time.time() - start:6.1f} s")
    if run.returncode != 0 or run.stderr:
        return faults + [f"ended with status {run.returncode}: {run.stderr.strip()}"]
    faults += [f"does not print '{promise}'" for promise in promises if promise not in run.stdout]
    rows = list(csv.DictReader(open(folder / "summary.csv", newline="", encoding="utf-8")))
    faults += [f"{row['case']}, {row['model']}: {row['status']}" for row in rows if row["status"] != "converged"]
    column = next(name for name in rows[0] if name.startswith("hookload_"))
    loads = {(row["case"], row["model"]): float(row[column]) for row in rows}
    largest = max(abs(load) for load in loads.values())
    for (case, model), load in loads.items():
        soft = loads.get((case, "soft"))
        if model == "mcge" and soft is not None and abs(load - soft) > MODELS_APART/100*largest:
            faults.append(f"{case}: mcge {load}, soft {soft}")
    if not (folder / "report.html").exists() or not list((folder / "pictures").glob("*.svg")):
        faults.append("no page or no pictures")
    return faults


def main():
    program, results = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    decks = [deck for deck in sorted(pathlib.Path("input").glob("*.nml")) if deck.name not in ELSEWHERE]
    faults = [f"{deck}: {fault}" for deck in decks for fault in faults_of(program, deck, results / deck.stem)]
    print(f"{len(decks)} decks")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults or not decks else 0


if __name__ == "__main__":
    sys.exit(main())

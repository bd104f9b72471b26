#!/usr/bin/env python3
"""Runs the sample decks of input/ as a user does and checks what came out.

Each deck begins with two lines or more on what it shows, ends with status 0 and nothing on standard error, every row of its
summary.csv converged, and its page and pictures are there. Beams and soft string, independent of each other, must agree on
the hook load within the limit below: what a slip in a deck (a diameter, a unit) would break. What a comment '! prints: ...'
promises must stand in the output.

Every deck converted to the other units and back means the same, to the rounding of a conversion.

Usage: check_samples.py PROGRAM RESULTS_FOLDER
"""
import csv
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from run_results import without_work

# Checked with more care elsewhere: gp1 by check_gp1.py, sweep_gp1 with its parts by .ci/run.
ELSEWHERE = {"gp1.nml", "sweep_gp1.nml"}
ROUNDING = 2.1e-7       # [-]: --convert writes numbers to 1e-7, twice here
MODELS_APART = 5.0      # % of the largest hook load of the deck
# Groups whose tables the page shows as they were printed, and its heading above them.
PRINTED, TABLES = ("&calibrate", "&sweep", "&study", "&steering", "&legacy", "&uncertainty"), ">Studies and comparisons"


def faults_of(program, deck, folder):
    lines = deck.read_text(encoding="utf-8").splitlines()
    comments, promises = lines[:2], [line.split(": ", 1)[1] for line in lines if line.startswith("! prints: ")]
    faults = [] if all(line.startswith("! ") for line in comments) else ["does not begin with two lines on what it shows"]
    start = time.time()
    run = subprocess.run([program, deck, "--output", folder], capture_output=True, text=True, timeout=300, check=False)
    print(f"{deck.name:28s} {time.time() - start:6.1f} s")
    if run.returncode != 0 or without_work(run.stderr):
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
    page = (folder / "report.html").read_text(encoding="utf-8") if (folder / "report.html").exists() else ""
    if not page or not list((folder / "pictures").glob("*.svg")):
        faults.append("no page or no pictures")
    if any(line.lower().startswith(PRINTED) for line in lines) != (TABLES in page):
        faults.append("its page lacks tables that were printed, or has some without any")
    return faults


def faults_of_conversion(program, deck, inputs):
    """To the other units and back: both decks are without fault, and what a check prints is what it printed first."""
    printed = [subprocess.run([program, "--check", inputs / deck.name], capture_output=True, text=True, check=False).stdout]
    source = inputs / deck.name
    for name in ("there", "back"):
        converted = subprocess.run([program, "--convert", source], capture_output=True, text=True, check=False)
        if converted.returncode != 0:
            return [f"conversion {name} ended with status {converted.returncode}: {converted.stderr.strip()}"]
        source = inputs / f"{deck.stem}_{name}.nml"
        source.write_text(converted.stdout, encoding="utf-8")
        run = subprocess.run([program, "--check", source], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return [f"converted {name} it is refused: {run.stderr.strip()}"]
        printed.append(run.stdout)
    # a conversion drops comments, so that groups stand in other lines
    first, last = ([re.sub(r" in line \d+", "", line) for line in text.splitlines() if deck.stem not in line]
                   for text in (printed[0], printed[-1]))
    return [f"converted to and fro: {b}, was: {a}" for a, b in zip(first, last) if not alike(a, b)]


def alike(a, b):
    """Whether two lines are the same but for the rounding of numbers that were converted twice."""
    number = r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?"
    if re.sub(number, "#", a) != re.sub(number, "#", b):
        return False
    pairs = zip(re.findall(number, a), re.findall(number, b))
    return all(abs(float(p) - float(q)) <= ROUNDING * abs(float(p)) for p, q in pairs)


def main():
    program, results = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    decks = [deck for deck in sorted(pathlib.Path("input").glob("*.nml")) if deck.name not in ELSEWHERE]
    faults = [f"{deck}: {fault}" for deck in decks for fault in faults_of(program, deck, results / deck.stem)]
    with tempfile.TemporaryDirectory() as folder:
        inputs = pathlib.Path(shutil.copytree("input", pathlib.Path(folder) / "input"))
        faults += [f"{deck}: {fault}" for deck in sorted(pathlib.Path("input").glob("*.nml"))
                   for fault in faults_of_conversion(program, deck, inputs)]
    print(f"{len(decks)} decks")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults or not decks else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""What the fidelity auto is worth on every sample deck of input/: a study of auto against reference, by the program itself.

Each deck is run with a &study of the two put behind it (instead of its own, where it has one). In every load case auto must
find a solution wherever reference does, and agree with it in hook load and torque within the limit. Prints the worst of each
deck and how much faster auto was, which is not checked: no check goes by the time that a machine takes.

Usage: check_fidelity.py PROGRAM FOLDER
"""
import csv
import pathlib
import re
import shutil
import subprocess
import sys

LIMIT = 0.5               # % of the reference's hook load and torque
STUDY = "\n&study models = 'mcge', fidelities = 'auto', 'reference' /\n"
# The same well and string as gp1.nml or johancsik_well_3.nml.
SAME = {"study_gp1.nml", "sweep_gp1.nml", "calibrate_gp1.nml", "stuck_gp1.nml", "uncertainty_gp1.nml",
        "sweep_johancsik_well_3.nml"}


def number(text):
    return float(text) if text else 0.0


def worst_of(program, deck, folder):
    """Worst errors of auto, cost ratio, faults."""
    text = deck.read_text(encoding="utf-8")
    deck.write_text(re.sub(r"^&study.*?^\s*/\s*$", "", text, flags=re.S | re.M) + STUDY, encoding="utf-8")
    out = folder / deck.stem
    run = subprocess.run([program, deck, "--output", out, "--quiet"], capture_output=True, text=True, timeout=300, check=False)
    if not (out / "study.csv").exists():
        return {}, 0.0, [f"status {run.returncode}, no study: {run.stderr.strip()}"]
    rows = list(csv.DictReader(open(out / "study.csv", newline="", encoding="utf-8")))
    auto = [row for row in rows if row["fidelity"] == "auto"]
    reference = {row["case"]: row for row in rows if row["fidelity"] == "reference"}
    faults = [f"{row['case']}: auto {row['status']}" for row in auto
              if row["status"] != "converged" and reference[row["case"]]["status"] == "converged"]
    solved = [row for row in auto if row["status"] == reference[row["case"]]["status"] == "converged"]
    worst = {column: max((number(row[column]) for row in solved), default=0.0)
             for column in ("hookload_error_pct", "torque_error_pct")}
    seconds = [sum(number(row["seconds"]) for row in group) for group in (auto, reference.values())]
    return worst, seconds[1] / max(seconds[0], 1e-9), faults


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree("input", folder)
    faults = []
    for deck in sorted(folder.glob("*.nml")):
        if deck.name in SAME:
            continue
        worst, ratio, found = worst_of(program, deck, folder / "results")
        for column, error in worst.items():
            if error > LIMIT:
                found.append(f"{column} {error:.3g}, must be below {LIMIT}")
        errors = ", ".join(f"{column[:-10]} within {error:.4f} %" for column, error in worst.items())
        print(f"{deck.name:28s} {errors}, {ratio:.1f} times as fast")
        faults += [f"{deck.name}: {fault}" for fault in found]
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Measures figures of test/README.md anew: iterations, equilibrium and independence of the mesh of GP1, and the well of Johancsik
et al. beside an open library. Prints each figure with what test/README.md says of it.

Usage: check_readme.py PROGRAM SCRATCH_FOLDER GP1_RESULTS JOHANCSIK_RESULTS
"""
import csv
import pathlib
import re
import subprocess
import sys

LENGTHS = ("2.5", "10")         # m; the deck has 5.0
KILOPOUND = 4.4482216152605     # kN
KILOFOOT_POUND = 1.3558179483314004  # kN.m


def summary(folder):
    return list(csv.DictReader(open(pathlib.Path(folder) / "summary.csv", newline="", encoding="utf-8")))


def said(readme, pattern):
    found = re.search(pattern, readme)
    if not found:
        raise SystemExit(f"test/README.md has nothing like: {pattern}")
    return [float(number) for number in found.groups()]


def gp1_with(program, scratch, length):
    """Rows of GP1 with elements of another length, solved beside its survey."""
    text = pathlib.Path("input/gp1.nml").read_text(encoding="utf-8")
    changed = text.replace("element_length = 5.0", f"element_length = {length}").replace(
        "models = 'mcge', 'soft'", "models = 'mcge', plots = .false., hdf5 = .false., profiles = .false.").replace(
        "'gp1_survey.csv'", f"'{pathlib.Path('input/gp1_survey.csv').resolve()}'")
    if changed.count(f"element_length = {length}") != 1 or "plots" not in changed:
        raise SystemExit("input/gp1.nml is not as this check expects it")
    deck = scratch / f"gp1_{length}.nml"
    deck.write_text(changed, encoding="utf-8")
    subprocess.run([program, deck, "--output", scratch / length, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    return summary(scratch / length)


def main():
    program, scratch = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    scratch.mkdir(parents=True, exist_ok=True)
    readme = pathlib.Path("test/README.md").read_text(encoding="utf-8")
    gp1 = [row for row in summary(sys.argv[3]) if row["model"] == "mcge"]
    others = [gp1_with(program, scratch, length) for length in LENGTHS]
    pairs = [(row, other) for rows in others for row, other in zip(gp1, rows)]
    well = {(row["case"], row["model"]): row for row in summary(sys.argv[4])}
    faults = []

    def at_most(what, value, limit):
        print(f"{what}: {value:.4g}, said {limit:g}")
        if not value <= limit:
            faults.append(f"{what}: {value}, test/README.md says {limit}")

    at_most("most iterations of a GP1 row", max(int(row["iterations"]) for row in gp1),
            said(readme, r"takes fewer than (\d+) iterations")[0] - 1)
    at_most("equilibrium of GP1, kN", max(float(row["equilibrium_kN"]) for row in gp1), said(readme, r"GP1: under (\S+) kN")[0])
    hook, torque = said(readme, r"moves no hook load by more than (\S+) kN and no torque by more than (\S+) kN\.m\.")
    at_most("hook load against element length, kN", max(abs(float(a["hookload_kN"]) - float(b["hookload_kN"])) for a, b in pairs), hook)
    at_most("torque against element length, kN.m", max(abs(float(a["torque_kNm"]) - float(b["torque_kNm"])) for a, b in pairs), torque)
    for model in ("soft", "mcge"):
        shown = said(readme, rf"\| drillgap, {model}[^|]*\| (\S+) \| (\S+) \| (\S+) \|")
        found = [float(well["up", model]["hookload_klbf"])*KILOPOUND, float(well["down", model]["hookload_klbf"])*KILOPOUND,
                 float(well["rotating", model]["torque_kftlbf"])*KILOFOOT_POUND]
        for value, number, digits in zip(found, shown, (1, 1, 2)):
            at_most(f"Johancsik's well, {model}, {value:.{digits}f} against {number}", abs(round(value, digits) - number), 1e-9)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

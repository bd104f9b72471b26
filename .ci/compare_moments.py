#!/usr/bin/env python3
"""How far moments at the default settings are from those of the analysis itself on short elements, in any decks.

Each deck is run twice with a &solver of its own, no other: once empty, and once with fidelity 'fast', which finds no moments on
elements of their own, and a short element_length. A case counts where both converge. Moments are compared at the rows of
the first, in per cent of the largest of the second; prints each case, then medians, ninth tenths and worst of all. Checks nothing.
Strings that coil may lie in another phase; their differences along the string say little.

The shorter the second's elements, the better it is: on the end of a stabiliser's blade it wants centimetres.

Usage: compare_moments.py PROGRAM FOLDER LENGTH DECK...      (needs numpy; files that decks name are looked for in input/)
"""
import csv
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np


def solved(program, text, solver, folder, name):
    """Profiles (depth, moment) by case and model, of what converged, and whether a string coils."""
    deck = folder / f"{name}.nml"
    deck.write_text(re.sub(r"^&(solver|study).*?/[ \t]*$", "", text, flags=re.S | re.M) + f"\n&solver {solver} /\n", encoding="utf-8")
    out = folder / name
    try:
        subprocess.run([program, deck, "--output", out, "--quiet", "--threads", "1"], capture_output=True, timeout=120, check=False)
        limits = list(csv.DictReader(open(out / "limits.csv", newline="", encoding="utf-8")))
    except (subprocess.TimeoutExpired, FileNotFoundError):
        return {}
    found = {}
    for row in limits:
        path = out / f"profile_{row['case']}_mcge.csv"
        if row["model"] != "mcge" or row["status"] != "converged" or not path.exists():
            continue
        lines = list(csv.reader(open(path, newline="", encoding="utf-8")))
        depth, moment = (next(i for i, c in enumerate(lines[0]) if c.startswith(start)) for start in ("md_", "bending_k"))
        values = np.array([[float(line[depth]), float(line[moment])] for line in lines[1:]])
        found[row["case"]] = values[:, 0], values[:, 1], row.get("found_buckled", row.get("shape", ""))
    return found


def main():
    program, folder, length = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), float(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree("input", folder)
    rows = []
    for deck in map(pathlib.Path, sys.argv[4:]):
        text = deck.read_text(encoding="utf-8")
        default = solved(program, text, "", folder, "default_run")
        fine = solved(program, text, f"fidelity = 'fast', element_length = {length}", folder, "fine_run")
        for case, (md, moment, shape) in fine.items():
            if case not in default:
                continue
            largest = moment.max()
            place, printed, _ = default[case]
            off = 100 * (printed - np.interp(place, md, moment)) / largest
            weight = np.gradient(place)
            peak = 100 * (printed.max() / largest - 1)
            rows.append((abs(peak), np.abs(off).max(), float(np.sqrt((off**2 * weight).sum() / weight.sum()))))
            print(f"{deck.name:32s} {case:20s} largest {peak:+6.2f} %, anywhere {rows[-1][1]:6.2f} % at {place[np.abs(off).argmax()]:.1f} m, "
                  f"rms {rows[-1][2]:5.2f} % {shape}", flush=True)
    table = np.array(rows)
    for name, numbers in (("median", np.median(table, axis=0)), ("nine of ten", np.percentile(table, 90, axis=0)),
                          ("worst", table.max(axis=0))):
        print(f"{len(table)} cases, {name}: largest moment off by {numbers[0]:.2f} %, anywhere {numbers[1]:.2f} %, rms {numbers[2]:.2f} %")


if __name__ == "__main__":
    main()

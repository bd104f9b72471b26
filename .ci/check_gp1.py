#!/usr/bin/env python3
"""Checks a run of the GP1 deck: the paper's Table 1 is met, and README.md prints this run's table.

Usage: check_gp1.py SUMMARY_CSV STANDARD_OUTPUT README
"""
import csv
import pathlib
import sys

import readme

ROWS = 12                 # of Table 1
REFERENCE_LIMIT = 3.0     # % of the paper's calculated hook loads, which a soft-string fit meets within 2 %
MEASURED_LIMIT = 10.0     # %: 'relative error below 10%' (paper, conclusions)
MEASURED_MEAN = 4.3       # %: the paper's own mean error


def faults_of_summary(path):
    rows = [r for r in csv.DictReader(open(path, newline="", encoding="utf-8"))]
    faults = [f"{r['case']}, {r['model']}: {r['status']}" for r in rows if r["status"] != "converged"]
    rows = [r for r in rows if r["model"] == "mcge"]
    if len(rows) != ROWS:
        return faults + [f"{len(rows)} rows of model mcge, expected {ROWS}"]
    for r in rows:
        for column, limit in (("reference_error_pct", REFERENCE_LIMIT), ("error_pct", MEASURED_LIMIT)):
            if not r[column] or not float(r[column]) < limit:
                faults.append(f"{r['case']}: {column} {r[column] or 'absent'}, must be below {limit}")
    errors = [float(r["error_pct"] or "nan") for r in rows]
    mean = sum(errors) / ROWS
    print(f"mean error against measurement {mean:.2f} %, worst {max(errors):.2f} %, against the paper's calculation worst "
          f"{max(float(r['reference_error_pct'] or 'nan') for r in rows):.2f} %")
    if not mean <= MEASURED_MEAN:
        faults.append(f"mean error {mean:.2f} %, the paper has {MEASURED_MEAN} %")
    return faults


def tables(text):
    """Table 1 of every model: the lines from 'Model NAME' to the next empty one."""
    found, lines = {}, text.splitlines()
    for i, line in enumerate(lines):
        if line.startswith("Model "):
            end = next((k for k in range(i, len(lines)) if not lines[k].strip()), len(lines))
            found[line.split()[1]] = [one.rstrip() for one in lines[i:end]]
    return found


def faults_of_readme(output, path):
    run = tables(output)
    shown = {}
    for block in readme.blocks(path):
        if block.startswith("Model "):      # the deck that users write has a block of its own
            shown.update(tables(block))
    if "mcge" not in shown:
        return [f"{path} shows no table of model mcge"]
    faults = []
    for model, table in shown.items():
        if table != run.get(model):
            faults.append(f"{path}: the table of model {model} is not what the run printed:")
            faults += run.get(model, ["(nothing)"])
    return faults


def main():
    summary, output, path = sys.argv[1:]
    faults = faults_of_summary(summary) + faults_of_readme(pathlib.Path(output).read_text(encoding="utf-8"), path)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

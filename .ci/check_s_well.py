#!/usr/bin/env python3
"""A measured well: friction and block weight from its upper thirteen depths, the lower thirteen predicted.

Usage: check_s_well.py DECK PROGRAM FOLDER

The deck stands beside the repository and is not part of it. What was measured at the lower depths is taken out of the deck before
the program runs, and compared with the predictions afterwards. Settled before that comparison was made: one friction, one
block weight, no sheave friction (lines and sheaves are not told), standard deviation by the residuals and as alike along the
depth as these are; the mean error must be within 2 %, and no fewer measurements may lie in their 95 % intervals than chance
leaves in one of twenty cases, were they independent.
Prints errors and what is left in the mean, by operation and along the depths, and what no friction explains: a string that
rotates weighs about the mean of up and down. Exit status 1 where something does not hold.
"""
import collections
import csv
import math
import pathlib
import re
import subprocess
import sys

MOST_ERROR = 2.0      # per cent, mean
LEAST_CHANCE = 0.05   # of so few within their intervals
UPPER = 13            # depths to calibrate with
MODELS = ("soft", "mcge")


def deck_for(path, folder):
    """The deck to run, and what it hides: {case: measured}, with names of the cases to calibrate with and to predict."""
    text = pathlib.Path(path).read_text(encoding="utf-8")
    cases = re.findall(r"^&load_case name='([^']*)'.*?bit_depth=([0-9.]+), measured_hookload=([0-9.]+)", text, re.M)
    depths = sorted({float(depth) for _, depth, _ in cases})
    known = [name for name, depth, _ in cases if float(depth) in depths[:UPPER]]
    hidden = {name: float(measured) for name, depth, measured in cases if name not in known}
    for name in hidden:
        text = re.sub(r"(name='" + re.escape(name) + r"'.*?), measured_hookload=[0-9.]+", r"\1", text)
    text = re.sub(r"survey_file='([^']*)'", lambda m: f"survey_file='{pathlib.Path(path).resolve().parent / m.group(1)}'", text)
    text = text.replace("&job ", "&job plots=.false., ")

    def quoted(names):
        return ",\n    ".join(f"'{name}'" for name in names)
    text += "&rig block_weight=0 /\n"
    for model in MODELS:
        text += (f"&calibrate name='{model}', model='{model}', separate='none', offset='one',\n  cases={quoted(known)},\n"
                 f"  predict={quoted(hidden)} /\n")
    deck = pathlib.Path(folder) / "s_well.nml"
    deck.parent.mkdir(parents=True, exist_ok=True)
    deck.write_text(text, encoding="utf-8")
    return deck, hidden, known


def triples(path):
    """What was measured at each depth: up, down, rotating."""
    found = collections.defaultdict(dict)
    text = pathlib.Path(path).read_text(encoding="utf-8")
    for operation, depth, measured in re.findall(r"operation='([^']*)', bit_depth=([0-9.]+), measured_hookload=([0-9.]+)", text):
        found[float(depth)][operation] = float(measured)
    return [(one["up"], one["down"], one["rotate_off_bottom"]) for one in found.values()]


def chance_of_so_few(inside, number, share=0.95):
    return sum(math.comb(number, k) * share**k * (1 - share)**(number - k) for k in range(inside + 1))


def slope(points):
    """Least squares slope of y against x."""
    n = len(points)
    x = sum(p[0] for p in points) / n
    y = sum(p[1] for p in points) / n
    return sum((p[0] - x) * (p[1] - y) for p in points) / sum((p[0] - x)**2 for p in points)


def main():
    path, program, folder = sys.argv[1:4]
    deck, hidden, known = deck_for(path, folder)
    if len(hidden) != len(known):
        sys.exit(f"FAULT {len(known)} cases to calibrate with, {len(hidden)} to predict")
    run = subprocess.run([program, str(deck), "--output", str(pathlib.Path(folder) / "results")], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"FAULT the run ended with {run.returncode}: {run.stderr}")
    results = pathlib.Path(folder) / "results"
    fault = False
    for model in MODELS:
        with open(results / "calibration.csv", encoding="utf-8") as lines:
            found = [row for row in csv.DictReader(lines) if row["calibration"] == model]
        friction, offset = found
        print(f"{model}: friction {float(friction['value']):.4f} ({float(friction['lower']):.4f} to {float(friction['upper']):.4f}), "
              f"block weight {float(offset['offset_klbf']):.2f} ({float(offset['offset_lower_klbf']):.2f} to "
              f"{float(offset['offset_upper_klbf']):.2f}) klbf, scatter {float(friction['hookload_deviation_klbf']):.2f} klbf")
        with open(results / "calibration_prediction.csv", encoding="utf-8") as lines:
            rows = [row for row in csv.DictReader(lines) if row["calibration"] == model]
        if {row["case"] for row in rows} != set(hidden):
            sys.exit("FAULT not every case is predicted")
        errors, inside, left = [], 0, collections.defaultdict(list)
        for row in rows:
            measured, predicted = hidden[row["case"]], float(row["predicted_hookload_klbf"])
            errors.append(100 * abs(predicted - measured) / measured)
            inside += float(row["lower_hookload_klbf"]) <= measured <= float(row["upper_hookload_klbf"])
            left[row["operation"]].append((float(row["bit_depth_ft"]), measured - predicted))
        half = (float(rows[-1]["upper_hookload_klbf"]) - float(rows[-1]["lower_hookload_klbf"])) / 2
        chance = chance_of_so_few(inside, len(rows))
        mean = sum(errors) / len(errors)
        print(f"  {len(rows)} predicted: mean error {mean:.2f} %, worst {max(errors):.2f} %; {inside} within +-{half:.1f} klbf "
              f"(95 %; chance of so few {chance:.2g})")
        for operation, points in left.items():
            values = [value for _, value in points]
            print(f"  {operation}: measured less predicted {sum(values) / len(values):+.2f} klbf in the mean, "
                  f"{1000 * slope(points):+.2f} klbf per 1000 ft")
        if mean > MOST_ERROR:
            print(f"FAULT {model}: mean error above {MOST_ERROR} %")
            fault = True
        if chance < LEAST_CHANCE:
            print(f"FAULT {model}: too few within their intervals")
            fault = True
    middle = [(up + down) / 2 - rotating for up, down, rotating in triples(path)]
    print(f"mean of up and down less rotating, measured: {min(middle):+.1f} to {max(middle):+.1f} klbf")
    sys.exit(1 if fault else 0)


if __name__ == "__main__":
    main()

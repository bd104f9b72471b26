#!/usr/bin/env python3
"""Runs every deck of input/extremes/ and prints what came of it: right, refused or marked, with figures.

Usage: extremes.py PATH_TO_DRILLGAP [NAME ...]

What is expected stands in the head of each deck:
  ! Expect: CASE COLUMN = VALUE within TOLERANCE % (source)    the column of summary.csv; kN instead of % is absolute
  ! Expect: CASE marked                                        locked_up, or not_converged with exit status 3
  ! Expect: CASE marked or COLUMN = VALUE within ...           either: there is no telling, but nothing else
  ! Expect: refused: TEXT                                      exit status 2, TEXT in the message, no output folder
  ! Vary: KEY = VALUE, VALUE, ...                              the deck is run with each value of a key
  ! Spread: CASE COLUMN within TOLERANCE %                     largest less smallest of these, over their mean
Ends in 'N passed, N failed'.
"""
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "input" / "extremes"
RIGHT = re.compile(r"(\w+) = (\S+) within (\S+) (%|kN)")
TIME_LIMIT = 300


def run(program, text, home):
    """Exit status, standard error, and the rows of summary.csv by case."""
    deck = pathlib.Path(home) / "deck.nml"
    deck.write_text(text, encoding="utf-8")
    out = pathlib.Path(home) / "out"
    done = subprocess.run([program, str(deck), "--output", str(out)], capture_output=True, text=True, timeout=TIME_LIMIT)
    rows = {}
    if (out / "summary.csv").is_file():
        with (out / "summary.csv").open(encoding="utf-8") as file:
            rows = {row["case"]: row for row in csv.DictReader(file)}
    return done.returncode, done.stderr, rows, out.exists()


def judge(expectation, status, message, rows, wrote):
    """What came of one expectation, and whether that is as expected."""
    if expectation.startswith("refused: "):
        text = expectation[len("refused: "):]
        good = status == 2 and text in message and not wrote
        return good, "refused" if good else f"exit status {status}", text
    case, rest = expectation.split(None, 1)
    if case not in rows:
        return False, f"exit status {status}", message.strip()[:120] or "no row"
    row = rows[case]
    if row["status"] != "converged":
        good = rest.startswith("marked") and (status == 3 or row["status"] == "locked_up")
        return good, f"marked {row['status']}", row["message"][:70]
    wanted = RIGHT.search(rest)
    if not wanted:
        return False, "not marked", f"hookload_kN = {row['hookload_kN']}"
    column, value, allowed, unit = wanted.group(1), float(wanted.group(2)), float(wanted.group(3)), wanted.group(4)
    found = float(row[column])
    off = abs(found - value) * (100.0 / abs(value) if unit == "%" else 1.0)
    good = off <= allowed
    return good, "right" if good else "WRONG", f"{column} = {found:.6g}, closed form {value:.6g}, off {off:.1e} of {allowed:g} {unit}"


def main():
    if len(sys.argv) < 2:
        print(__doc__)
        return 2
    program, names = os.path.abspath(sys.argv[1]), sys.argv[2:]
    passed = failed = 0
    for path in sorted(FOLDER.glob("*.nml")):
        if names and path.stem not in names:
            continue
        text = path.read_text(encoding="utf-8")
        expectations = re.findall(r"^! Expect: (.*)$", text, re.M)
        spreads = re.findall(r"^! Spread: (\w+) (\w+) within (\S+) %", text, re.M)
        seen = {(case, column): [] for case, column, _ in spreads}
        if not expectations + spreads:
            print(f"FAIL {path.name}: nothing expected")
            failed += 1
        vary = re.search(r"^! Vary: (\w+) = (.*)$", text, re.M)
        variants = [("", text)]
        if vary:
            key, values = vary.group(1), [v.strip() for v in vary.group(2).split(",")]
            variants = [(f"{key} = {v}", re.sub(rf"(?<!: )\b{key} = [^,/\s]+", f"{key} = {v}", text)) for v in values]
        for label, variant in variants:
            with tempfile.TemporaryDirectory() as home:
                status, message, rows, wrote = run(program, variant, home)
            for case, column in seen:
                if rows.get(case, {}).get("status") == "converged":
                    seen[case, column].append(float(rows[case][column]))
            if spreads:
                print("     %-20s %-24s " % (path.stem, label) + ", ".join(
                    f"{case} {column} = {float(rows[case][column]):.6g}" if rows[case]["status"] == "converged" else f"{case} marked"
                    for case, column in seen if case in rows), flush=True)
            for expectation in expectations:
                good, outcome, figures = judge(expectation, status, message, rows, wrote)
                for sign in ("Backtrace", "runtime error", "AddressSanitizer"):
                    if sign in message:
                        good, figures = False, message[message.find(sign):][:300]
                passed, failed = passed + good, failed + (not good)
                place = label or expectation.split()[0].rstrip(":")
                print(f"{'ok  ' if good else 'FAIL'} {path.stem:20s} {place:24s} {outcome:22s} {figures}", flush=True)
        for case, column, allowed in spreads:
            values = seen[case, column]
            spread = 100.0 * (max(values) - min(values)) * len(values) / abs(sum(values)) if values else float("inf")
            good = spread <= float(allowed) and len(values) == len(variants)
            passed, failed = passed + good, failed + (not good)
            print(f"{'ok  ' if good else 'FAIL'} {path.stem:20s} {case + ' ' + column:24s} {'spread':22s} {spread:.1e} of {allowed} %, "
                  f"{len(values)} of {len(variants)} right", flush=True)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())

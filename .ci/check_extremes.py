#!/usr/bin/env python3
"""Checks that the table of extremes in test/README.md is the one that the verification tests print.

Usage: check_extremes.py LOG [--write]     LOG: what `fpm test verification` printed; --write brings the table up to date

Rows and numbers of cases must be the same. An error may be twice or half of the kept one, as machines differ; below 1e-6 it is
round-off, and errors are not compared.
"""
import pathlib
import re
import sys

README = pathlib.Path(__file__).resolve().parent.parent / "test/README.md"
HEAD = ["axis", "range", "right", "refused", "marked", "locked up", "not solved", "off", "hook load", "torque", "contact", "moment"]
COUNTS = range(2, 8)
ERRORS = range(8, 12)
ROUND_OFF = 1.0e-6
FACTOR = 2.0
MARKED = re.compile(r"<!-- extremes -->\n(.*?)<!-- end -->", re.S)


def rows(text):
    """Rows of the table in a text: cells by axis."""
    cells = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in text.splitlines() if line.startswith("| ")]
    return {row[0]: row for row in cells if len(row) == len(HEAD) and row != HEAD}


def unlike(kept, printed):
    """Whether two errors differ by more than machines do."""
    if "-" in (kept, printed):
        return kept != printed
    a, b = (max(float(error), ROUND_OFF) for error in (kept, printed))
    return max(a, b) > FACTOR * min(a, b)


def main():
    if not 2 <= len(sys.argv) <= 3 or sys.argv[2:] not in ([], ["--write"]):
        raise SystemExit(__doc__)
    printed = rows(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    text = README.read_text(encoding="utf-8")
    found = MARKED.search(text)
    if not found or not printed:
        raise SystemExit("no table of extremes in test/README.md" if printed else f"no table of extremes in {sys.argv[1]}")
    if sys.argv[2:]:
        table = [HEAD, ["---"] * len(HEAD), *printed.values()]
        lines = "".join("| " + " | ".join(row) + " |\n" if row[0] != "---" else "|" + "---|" * len(HEAD) + "\n" for row in table)
        README.write_text(text[:found.start(1)] + lines + text[found.end(1):], encoding="utf-8")
        return 0
    kept, faults = rows(found.group(1)), []
    for axis in [*kept, *(axis for axis in printed if axis not in kept)]:
        if axis not in kept or axis not in printed:
            faults.append(f"{axis}: only {'printed' if axis in printed else 'in test/README.md'}")
            continue
        faults += [f"{axis}: {HEAD[i]} {kept[axis][i]} in test/README.md, {printed[axis][i]} printed"
                   for i in (1, *COUNTS) if kept[axis][i] != printed[axis][i]]
        faults += [f"{axis}: error of {HEAD[i]} {kept[axis][i]} in test/README.md, {printed[axis][i]} printed"
                   for i in ERRORS if unlike(kept[axis][i], printed[axis][i])]
    for fault in faults:
        print("FAULT", fault)
    print(f"  test/README.md: {len(kept)} axes of extremes" + ("; run .ci/check_extremes.py LOG --write" if faults else ""))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

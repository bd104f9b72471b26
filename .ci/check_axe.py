#!/usr/bin/env python3
"""Looks for obstacles on report.html by axe-core: labels, roles, order of headings, contrast. All parts are unfolded, by day and by night.

The right edge of wide tables, a gradient, is left out: before it axe finds no contrast.

Usage: check_axe.py WHEEL RESULTS_FOLDER...     WHEEL: axe-playwright-python, which holds axe.min.js
"""
import pathlib
import sys
import zipfile

from browser import told_by

NIGHT = "screen and (prefers-color-scheme:dark)"
RULES = """
setTimeout(async () => {
   for (const fold of document.querySelectorAll('details')) fold.open = true
   for (const e of document.querySelectorAll('.wide')) e.style.backgroundImage = 'none'
   const {violations, passes} = await axe.run(document)
   const told = violations.map(v => `${v.id}: ${v.nodes.length} places, the first is ${v.nodes[0].html.slice(0, 200)}`)
   document.title = 'FOUND' + JSON.stringify([passes.length, told])
}, 500)
"""
FEWEST = 20     # rules that a page must have met


def main():
    with zipfile.ZipFile(sys.argv[1]) as wheel:
        axe = next(wheel.read(name).decode() for name in wheel.namelist() if name.endswith("axe.min.js"))
    failed = 0
    for folder in map(pathlib.Path, sys.argv[2:]):
        text = (folder / "report.html").read_text(encoding="utf-8")
        for sky, page in (("day", text), ("night", text.replace(NIGHT, "screen"))):
            told, complaints = told_by(page, axe + "</script><script>" + RULES)
            met, faults = told or (0, [])
            faults = [*faults, *complaints] + ([] if met >= FEWEST else [f"only {met} rules were tried"])
            failed += bool(faults)
            print(f"{folder.name} by {sky}: {met} rules met", *(f"\n   FAULT {fault}" for fault in faults))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

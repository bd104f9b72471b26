#!/usr/bin/env python3
"""Keeps src/deck/catalogue/catalogue_lines.f90, the catalogue that the program carries with it, equal to input/catalogue.csv.

Usage: embed_catalogue.py [--write]     --write makes the source anew
"""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src/deck/catalogue/catalogue_lines.f90"
LONGEST = 110   # letters of a row in a line of Fortran, which may have 132


def module():
    """The source: rows of the catalogue without its comments."""
    rows = [row for row in (ROOT / "input/catalogue.csv").read_text(encoding="ascii").splitlines()
            if row.strip() and not row.startswith("#")]
    width = max(len(row) for row in rows)
    text = []
    for row in rows:
        pieces = [row[i:i + LONGEST].replace("'", "''") for i in range(0, len(row), LONGEST)]
        text += [f"      '{piece}'// &" for piece in pieces[:-1]] + [f"      '{pieces[-1]}', &"]
    text[-1] = text[-1][:-3] + "]"
    return "\n".join([
        "!> The catalogue of pipe that the program carries with it: input/catalogue.csv without its comments, for an installed program",
        "!> that is run anywhere. Written by .ci/embed_catalogue.py --write; change the table, not this.",
        "module dg_catalogue_lines", "   implicit none", "   private", "   public :: catalogue_lines", "",
        f"   character(*), parameter :: catalogue_lines({len(rows)}) = [character({width}) :: &", *text,
        "end module dg_catalogue_lines", ""])


def main():
    text = module()
    if "--write" in sys.argv[1:]:
        SOURCE.write_text(text, encoding="ascii")
    same = SOURCE.exists() and SOURCE.read_text(encoding="ascii") == text
    if not same:
        print("FAULT src/deck/catalogue/catalogue_lines.f90 is not what input/catalogue.csv makes; run .ci/embed_catalogue.py --write")
    return 0 if same else 1


sys.exit(main())

#!/usr/bin/env python3
"""Keeps src/deck/catalogue/catalogue_lines.f90, the catalogue that the program carries with it, equal to input/catalogue.csv.

Usage: embed_catalogue.py [--write]     --write makes the source anew
"""
import pathlib
import sys

from embedded import keep, rows

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src/deck/catalogue/catalogue_lines.f90"


def module():
    """The source: rows of the catalogue without its comments."""
    lines = [row for row in (ROOT / "input/catalogue.csv").read_text(encoding="ascii").splitlines()
             if row.strip() and not row.startswith("#")]
    width = max(len(line) for line in lines)
    return "\n".join([
        "!> The catalogue of pipe within the program: input/catalogue.csv without its comments, for an installed program in any folder.",
        "!> Written by .ci/embed_catalogue.py --write. Change the table, not this file.",
        "module dg_catalogue_lines", "   implicit none", "   private", "   public :: catalogue_lines", "",
        f"   character(*), parameter :: catalogue_lines({len(lines)}) = [character({width}) :: &", *rows(lines),
        "end module dg_catalogue_lines", ""])


sys.exit(keep(SOURCE, module(), "src/deck/catalogue/catalogue_lines.f90 is not what input/catalogue.csv makes; "
              "run .ci/embed_catalogue.py --write"))

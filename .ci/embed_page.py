#!/usr/bin/env python3
"""Keeps src/report/page/page_script.f90, the script and style that the program puts into a page, equal to page.js, curves.js, well.js and page.css.

Usage: embed_page.py [--write]     --write makes the source anew
"""
import base64
import hashlib
import pathlib
import re
import sys

from embedded import keep, rows

PAGE = pathlib.Path(__file__).resolve().parent.parent / "src/report/page"
SOURCE = PAGE / "page_script.f90"
PART = 100      # lines in a statement, which may have 255 lines of Fortran


def lines_of(name):
    """Lines of a file, without what only its readers need: indentation, comments, lines that are empty."""
    lines = [re.sub(r" {2,}// .*", "", line).strip() for line in (PAGE / name).read_text(encoding="ascii").splitlines()]
    return [line for line in lines if line and not line.startswith("// ")]


def array(name, lines):
    """Lines as an array of Fortran, each in pieces, in parts that have no more lines than a statement of Fortran may have."""
    width = max(len(line) for line in lines)
    parts = [lines[i:i + PART] for i in range(0, len(lines), PART)]
    text = []
    for number, part in enumerate(parts, 1):
        text += [f"   character({width}), parameter :: {name}_{number}({len(part)}) = [character({width}) :: &", *rows(part)]
    whole = ", &\n      ".join(f"{name}_{number}" for number in range(1, len(parts) + 1))
    return text + [f"   character({width}), parameter :: {name}({len(lines)}) = [ &\n      {whole}]"]


def module():
    script = lines_of("page.js") + lines_of("curves.js") + lines_of("well.js")
    digest = hashlib.sha256("\n".join(script).encode("ascii")).digest()
    return "\n".join([
        "!> The script and the style of a page: page.js, curves.js, well.js, page.css. The hash of the script permits it. Written by",
        "!> .ci/embed_page.py --write. Change those files, not this one.",
        "module dg_page_script", "   implicit none", "   private", "   public :: script_hash, script_lines, style_lines", "",
        f"   character(*), parameter :: script_hash = '{base64.b64encode(digest).decode()}'",
        *array("script_lines", script), *array("style_lines", lines_of("page.css")), "end module dg_page_script", ""])


sys.exit(keep(SOURCE, module(), "src/report/page/page_script.f90 is not what page.js, curves.js, well.js and page.css make; run .ci/embed_page.py --write"))

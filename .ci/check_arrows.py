#!/usr/bin/env python3
"""Checks that the folders of src/ and app/ use each other only in one direction.

Every folder lists the folders that its modules may use. A new folder must be entered here; an arrow that is
not listed, or a list with a ring in it, fails. Prints the arrows found; exit status 1 on any fault.
"""
import pathlib
import re
import sys

MAY_USE = {
    "base": set(),
    "system": {"base"},
    "linear_algebra": {"base"},
    "trajectory": {"base"},
    "string": {"base"},
    "hole": {"base"},
    "beam": {"base"},
    "gap_element": {"base", "beam"},
    "model": {"base", "linear_algebra", "trajectory", "string", "hole"},
    "results": {"base", "gap_element"},
    "bending": {"base", "beam", "gap_element"},
    "buckling": {"base"},
    "soft_string": {"base", "buckling", "trajectory", "string", "hole", "model", "gap_element", "results"},
    "equations": {"base", "buckling", "linear_algebra", "trajectory", "beam", "gap_element", "model", "results", "soft_string"},
    "start": {"base", "bending", "buckling", "trajectory", "beam", "gap_element", "model", "soft_string", "equations"},
    "iteration": {"base", "system", "linear_algebra", "trajectory", "beam", "gap_element", "model", "results", "equations"},
    "solution": {"base", "system", "bending", "buckling", "linear_algebra", "trajectory", "string", "hole", "beam", "gap_element", "model", "results",
                 "soft_string", "equations", "start", "iteration"},
    "rigid_string": {"base", "trajectory", "model", "results", "soft_string"},
    "mixed_string": {"base", "trajectory", "string", "hole", "model", "results", "soft_string", "rigid_string", "solution"},
    "legacy": {"base", "trajectory", "model", "results"},
    "study": {"base", "model", "results"},
    "campaign": {"base", "trajectory", "string", "hole", "model", "results"},
    "calibration": {"base", "system", "linear_algebra", "string", "hole", "model", "results"},
    "uncertainty": {"base", "trajectory", "hole", "model", "results"},
    "deck_text": {"base", "model"},
    "model_check": {"base", "deck_text", "trajectory", "string", "hole", "model"},
    "imports": {"base", "deck_text", "system"},
    "catalogue": {"base", "deck_text", "imports", "string", "system"},
    "deck": {"base", "catalogue", "deck_text", "hole", "imports", "model", "model_check", "string", "system", "trajectory"},
    "string_limits": {"base", "buckling", "trajectory", "string", "hole", "model", "results", "soft_string"},
    "columns": {"base", "model"},
    "files": {"base", "buckling", "calibration", "columns", "gap_element", "legacy", "model", "results", "string_limits", "study",
              "system", "trajectory", "uncertainty"},
    "tables": {"base", "buckling", "calibration", "columns", "files", "legacy", "model", "results", "string_limits", "study",
               "uncertainty"},
    "pictures": {"base", "columns", "files", "hole", "model", "results", "string", "string_limits", "system", "tables"},
    "page": {"base", "columns", "files", "model", "pictures", "results", "string_limits", "system"},
    "echo": {"base", "hole", "model", "string", "string_limits", "tables", "trajectory"},
    "runs": {"base", "system", "campaign", "calibration", "uncertainty", "hole", "string_limits", "columns", "model", "results",
             "soft_string", "rigid_string", "mixed_string", "solution"},
    "library": {"base", "system", "trajectory", "string", "hole", "model", "results", "runs", "deck_text", "model_check", "deck"},
}
# The main program may use everything; nothing may use it.
MAY_USE["app"] = set(MAY_USE)

# Folders that only the main program and the door of the library may use: input and output are no mechanics.
ONLY_FROM_APP = {"deck", "page", "library"}
DOORS = {"app", "library"}
# Folders whose procedures may read or write files and the screen.
MAY_TALK = {"app", "deck_text", "imports", "catalogue", "deck", "files", "pictures", "page"}
# The modules of system/ that touch files on their behalf, and ask the system.
FILE_MODULES = {"src/system/file_lines.f90", "src/system/file_system.f90", "src/system/folder.f90",
                "src/system/process_memory.f90"}

USE = re.compile(r"^\s*use\s*(?:,\s*(?:non_)?intrinsic\s*)?(?:::)?\s*(\w+)", re.I | re.M)
MODULE = re.compile(r"^\s*module\s+(?!procedure\b|subroutine\b|function\b)(\w+)\s*$", re.I | re.M)
TALK = re.compile(r"^\s*(?:\w+:\s*)?(?:if\s*\(.*\)\s*)?(?:open\s*\(|read\s*\(|write\s*\(|print\s)", re.I | re.M)
TO_TEXT = re.compile(r"(?:read|write)\s*\(\s*(?!unit\b|\*|\d|output_unit|error_unit)\w", re.I)


def folder_of(path, root):
    parts = path.relative_to(root).parts
    return "app" if parts[0] == "app" else parts[1] if len(parts) > 2 else "(src)"


def find_rings(may_use):
    """Folders that reach themselves."""
    rings = []
    for start in may_use:
        seen, todo = set(), list(may_use[start])
        while todo:
            folder = todo.pop()
            if folder not in seen:
                seen.add(folder)
                todo += may_use[folder]
        if start in seen:
            rings.append(start)
    return rings


def check(root):
    sources = sorted(p for top in ("src", "app") for p in (root / top).rglob("*.f90"))
    text = {p: p.read_text(encoding="utf-8") for p in sources}
    home = {m.lower(): folder_of(p, root) for p in sources for m in MODULE.findall(text[p])}
    faults = [f"the list itself has a ring through {folder}/" for folder in find_rings(MAY_USE)]
    arrows = {}
    for path in sources:
        here, name = folder_of(path, root), path.relative_to(root).as_posix()
        if here not in MAY_USE:
            faults.append(f"{name}: folder {here}/ is not in the list of {pathlib.Path(__file__).name}")
            continue
        for used in USE.findall(text[path]):
            there = home.get(used.lower())
            if there is None or there == here:
                continue
            arrows.setdefault(here, set()).add(there)
            if there not in MAY_USE[here]:
                faults.append(f"{name}: {here}/ may not use {there}/ ({used})")
        if here not in MAY_TALK and name not in FILE_MODULES:
            for number, line in enumerate(text[path].splitlines(), 1):
                if TALK.match(line) and not TO_TEXT.search(line):
                    faults.append(f"{name}:{number}: {here}/ reads or writes: {line.strip()}")
    for folder, used in MAY_USE.items():
        faults += [f"the list lets {folder}/ use {u}/" for u in used & ONLY_FROM_APP if folder not in DOORS]
    return arrows, faults


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    arrows, faults = check(root)
    for folder in MAY_USE:
        if folder in arrows:
            print(f"  {folder:15s} uses {', '.join(sorted(arrows[folder]))}")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

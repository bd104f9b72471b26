#!/usr/bin/env python3
"""Checks the houses of src/: which house uses which, the rooms inside a house, the studies beside each other.

src/HOUSE/ROOM/FILE.f90, or src/HOUSE/FILE.f90 in a house of one room; app/ is a house, too. A fault is

  a use of another house that MAY_USE does not list, a house that is not listed, a ring in the list
  a study that uses another study; services of studies are for all of them
  a file with the name of a study outside studies/
  more than 20 files in a room, rooms of a house that use each other in a ring
  more than 1,800 lines in app/, the bench not counted
  reading or writing in a house that is not meant to

Prints the uses found; exit status 1 on any fault.
"""
import collections
import pathlib
import re
import sys

MAY_USE = {
    "base": set(),
    "system": {"base"},
    "algebra": {"base"},
    "scene": {"base"},
    "results": {"base", "scene"},
    "axis_methods": {"base", "scene", "results"},
    "mechanics": {"base", "algebra", "scene", "results", "axis_methods"},
    "solver": {"base", "algebra", "scene", "results", "axis_methods", "mechanics"},
    "analysis": {"base", "scene", "results", "axis_methods", "solver"},
    "deck": {"base", "system", "scene"},
    "report": {"base", "system", "scene", "results", "analysis"},
    "studies": {"base", "system", "algebra", "scene", "results", "analysis", "deck", "report"},
    "library": {"base", "system", "scene", "results", "analysis", "deck", "studies"},
}
# The main program may use everything; nothing may use it.
MAY_USE["app"] = set(MAY_USE)

SERVICES = {"ensemble", "fit"}      # rooms of studies/ that every study may use
STUDY_FILE = re.compile(r"sweep|calibrat|uncertain|sticking|steering|legacy")
FULL = 20                           # files a room
APP_LINES = 1800                    # lines of app/ without the bench

# Houses whose procedures may read or write files and the screen, and other files that do.
MAY_TALK = {"app", "report"}
FILE_MODULES = {"src/system/files/file_lines.f90", "src/system/files/file_system.f90", "src/system/files/folder.f90",
                "src/system/files/xml.f90",
                "src/system/processes/process_memory.f90", "src/system/terminal/diagnostic.f90", "src/system/terminal/progress.f90"}

USE = re.compile(r"^\s*use\s*(?:,\s*(?:non_)?intrinsic\s*)?(?:::)?\s*(\w+)", re.I | re.M)
MODULE = re.compile(r"^\s*(?:module|program)\s+(?!procedure\b|subroutine\b|function\b)(\w+)\s*$", re.I | re.M)
TALK = re.compile(r"^\s*(?:\w+:\s*)?(?:if\s*\(.*\)\s*)?(?:open\s*\(|read\s*\(|write\s*\(|print\s)", re.I | re.M)
TO_TEXT = re.compile(r"(?:read|write)\s*\(\s*(?!unit\b|\*|\d|output_unit|error_unit)\w", re.I)


class Source:
    """A file with its house and its room, both by name; the modules that it has and uses."""

    def __init__(self, path, root):
        parts = path.relative_to(root).parts
        self.name, self.stem, self.text = "/".join(parts), path.stem, path.read_text(encoding="utf-8")
        self.house = "app" if parts[0] == "app" else parts[1] if len(parts) > 2 else "(src)"
        self.room = "/".join(parts[:-1])
        self.study = parts[2] if self.house == "studies" and len(parts) > 3 else ""
        self.modules = [module.lower() for module in MODULE.findall(self.text)]
        self.used = {module.lower() for module in USE.findall(self.text)}


def reached(start, arrows):
    """All that `start` reaches, itself where it is in a ring."""
    seen, todo = set(), list(arrows.get(start, ()))
    while todo:
        one = todo.pop()
        if one not in seen:
            seen.add(one)
            todo += arrows.get(one, ())
    return seen


def sources_of(root):
    return [Source(path, root) for top in ("src", "app") for path in sorted((root / top).rglob("*.f90"))]


def faults_of_uses(sources):
    """Uses that are not allowed: kind of fault to a line for each; all uses between houses; arrows between rooms of a house."""
    home = {module: source for source in sources for module in source.modules}
    found, arrows, inside = collections.defaultdict(list), collections.defaultdict(set), collections.defaultdict(set)
    for source in sources:
        if source.house not in MAY_USE:
            found[f"{source.house} is no house"].append(source.name)
            continue
        for module in sorted(source.used):
            there = home.get(module)
            if there is None or there is source:
                continue
            if there.house != source.house:
                arrows[source.house].add(there.house)
                if there.house not in MAY_USE[source.house]:
                    found[f"{source.house} uses {there.house}"].append(f"{source.name} uses {there.name}")
                continue
            if there.room != source.room:
                inside[source.room].add(there.room)
            # what stands beside the rooms of studies/, as their registry, knows them all
            if source.study and there.study and there.study != source.study and there.study not in SERVICES:
                found[f"studies/{source.study} uses studies/{there.study}"].append(f"{source.name} uses {there.name}")
            if source.study and not there.study and there.stem == "registry":
                found[f"studies/{source.study} uses the registry"].append(source.name)
    return found, arrows, inside


def check(root):
    sources = sources_of(root)
    found, arrows, inside = faults_of_uses(sources)
    for house in MAY_USE:
        if house in reached(house, MAY_USE):
            found["the list has a ring"].append(house)
    for room in sorted(inside):
        if room in reached(room, inside):
            found["a ring of rooms"].append(room)
    for room, number in collections.Counter(source.room for source in sources).items():
        if number > FULL:
            found["a full room"].append(f"{room}/ has {number} files, more than {FULL}")
    for source in sources:
        if source.house != "studies" and STUDY_FILE.search(source.stem):
            found[f"a study's file in {source.house}"].append(source.name)
        if source.house not in MAY_TALK and source.name not in FILE_MODULES:
            found["reads or writes"] += [f"{source.name}:{number}: {line.strip()}" for number, line in
                                         enumerate(source.text.splitlines(), 1) if TALK.match(line) and not TO_TEXT.search(line)]
    lines = sum(source.text.count("\n") for source in sources if source.house == "app" and "bench" not in source.name)
    if lines > APP_LINES:
        found["app is long"] = [f"app/ has {lines} lines without the bench, more than {APP_LINES}"]
    return arrows, {kind: lines for kind, lines in found.items() if lines}


def main():
    arrows, found = check(pathlib.Path(__file__).resolve().parent.parent)
    for house in MAY_USE:
        print(f"  {house:13s} uses {', '.join(name for name in MAY_USE if name in arrows[house])}")
    for kind in sorted(found):
        print(*(f"FAULT {kind}: {line}" for line in found[kind]), sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

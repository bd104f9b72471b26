#!/usr/bin/env python3
"""Checks the door for programs of others, src/library/drillgap.f90, as a stranger uses it.

Usage: check_library.py [--write | --names]

  --names  the names that the module makes public, and the components of its types, are those listed in src/library/README.md
  --write  brings that list up to date: a change of it is a change of what is promised (src/library/README.md)

Without an option besides: the lines of fpm.toml and the programs that src/library/README.md shows are built in a folder outside the
repository, where pkg-config finds no HDF5, and must print what it says.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import readme
from check_docs import without_comments

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOOR = ROOT / "src/library/drillgap.f90"
LIST = ROOT / "src/library/README.md"
BEGIN, END = "<!-- names of the library -->\n", "<!-- end of names -->\n"
FENCED = re.compile(r"^```(\w*)\n(.*?)^```", re.M | re.S)


def public_names():
    """Names that the module makes public."""
    return [name for names in re.findall(r"^ *public ::([^\n]*)", without_comments(DOOR), re.M) for name in re.findall(r"\w+", names)]


def components_of_types():
    """Components of every type of the sources, by the type's name; those after `private` that are not `public` are left out."""
    found = {}
    for path in sorted((ROOT / "src").rglob("*.f90")):
        for name, body in re.findall(r"^ *type :: (\w+)\n(.*?)^ *end type", without_comments(path), re.M | re.S):
            if "private\n" in body:
                before, after = body.split("private\n", 1)
                body = before + "".join(line + "\n" for line in after.split("\n") if re.search(r", *public\b.*::", line))
            names = [re.match(r"\w+", part.strip()).group() for line in re.findall(r"^[^\n]*?::([^\n]*)", body, re.M)
                     for part in re.split(r",(?![^(]*\))", line) if re.match(r"\w+", part.strip())]
            if (name, path) == ("model_type", DOOR) or name not in found or path == DOOR:
                found[name] = names
    return found


def listing():
    names, types = public_names(), components_of_types()
    rows = ["| type | components |", "|---|---|"]
    rows += [f"| `{name}` | {', '.join(f'`{c}`' for c in types[name]) or 'none that is public'} |" for name in names if name in types]
    rest = [f"`{name}`" for name in names if name not in types]
    return "\n".join(["", *rows, "", "Procedures and constants: " + ", ".join(rest) + ".", ""]) + "\n"


def check_names(write):
    text = LIST.read_text(encoding="utf-8")
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        raise SystemExit(f"FAULT src/library/README.md: no marks {BEGIN.strip()} and {END.strip()}")
    head, rest = text.split(BEGIN)
    old, tail = rest.split(END)
    new = listing()
    if write:
        LIST.write_text(head + BEGIN + new + END + tail, encoding="utf-8")
    elif old != new:
        for mark, one, other in (("gone", old, new), ("new", new, old)):
            for word in sorted(set(re.findall(r"`(\w+)`", one)) - set(re.findall(r"`(\w+)`", other))):
                print(f"  {mark}: {word}")
        raise SystemExit("FAULT src/library/README.md: the names of the library are not those listed; where that is meant, say so in "
                         "CHANGELOG.md and run .ci/check_library.py --write")


def printed_after(text, start):
    """The fenced block that follows a program beginning with a text."""
    found = FENCED.findall(text)
    for (language, body), (_, after) in zip(found, found[1:]):
        if language == "fortran" and body.startswith(start):
            return after
    raise SystemExit(f"FAULT src/library/README.md: no program begins with {start}")


def run(command, folder):
    environment = dict(os.environ, PKG_CONFIG_LIBDIR="/nonexistent", PKG_CONFIG_PATH="")
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"FAULT {' '.join(map(str, command))}: status {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def check_programs():
    text = LIST.read_text(encoding="utf-8")
    blocks = FENCED.findall(text)
    manifest = [body for language, body in blocks if language == "toml" and "drillgap" in body]
    programs = [body for language, body in blocks if language == "fortran"]
    if len(manifest) != 1 or len(programs) != 2:
        raise SystemExit(f"FAULT src/library/README.md: {len(manifest)} manifests and {len(programs)} programs, expected 1 and 2")
    with tempfile.TemporaryDirectory() as folder:
        project = pathlib.Path(folder) / "my_well"
        (project / "app").mkdir(parents=True)
        (pathlib.Path(folder) / "drillgap").symlink_to(ROOT)
        (project / "fpm.toml").write_text(manifest[0], encoding="utf-8")
        (project / "well.nml").write_text(readme.one_block("&"), encoding="utf-8")
        for body, file in zip(programs, ("main", "friction_sweep")):
            (project / "app" / f"{file}.f90").write_text(body, encoding="utf-8")
        run(["pipx", "run", "fpm", "build"], project)       # not optimised: a third of the time
        for body, file in zip(programs, ("my_well", "friction_sweep")):
            name = re.match(r"program (\w+)", body).group(1)
            program = next(iter(project.glob(f"build/*/app/{file}")))
            if "hdf5" in run(["ldd", program], project):
                raise SystemExit(f"FAULT {name} is linked with HDF5")
            printed = run([program], project)
            promised = printed_after(text, f"program {name}\n")
            print(f"  {name} prints", printed, sep="\n", end="")
            if printed != promised:
                raise SystemExit(f"FAULT src/library/README.md: {name} prints something else")


def main(arguments):
    if arguments not in ([], ["--write"], ["--names"]):
        raise SystemExit(__doc__)
    os.chdir(ROOT)
    check_names(arguments == ["--write"])
    if not arguments:
        check_programs()


if __name__ == "__main__":
    main(sys.argv[1:])

#!/usr/bin/env python3
"""Checks what a reader relies on when looking for something: names of files and modules, sizes, rules of the sources."""
import pathlib
import re
import sys

TOP = {"fpm.toml", "README.md", "CHANGELOG.md", "LICENSE", "src", "app", "test", "input", "output", "build"}
LONGEST = {"src": 400, "app": 400, "test": 600}   # lines a file
TABLES = {"src/report/page/page_script.f90", "src/scene/rules/deck_keys.f90"}           # longer: one table, a row a key
LARGEST = 120   # lines a procedure, those that it contains among them
MOST_ARGUMENTS = 9
# Procedures that are longer, and why.
LONGER = {
    "load_tests": "a list of suites, two lines each",
}
PREFIX = "dg_"
DOOR = "src/library/drillgap.f90"   # its module has the package's name, which fpm allows beside the prefix

MODULE = re.compile(r"^\s*module\s+(?!procedure\b|subroutine\b|function\b)(\w+)\s*$", re.I | re.M)
USE_ALL = re.compile(r"^\s*use\s*(?:,\s*(?:non_)?intrinsic\s*)?(?:::)?\s*\w+\s*(?:!.*)?$", re.I | re.M)
# Modules that end the program where the sources ask for what they do not have.
ENDS = {"src/report/columns/column.f90"}
STOP = re.compile(r"^\s*(?:if\s*\(.*\)\s*)?(?:error\s+)?stop\b", re.I | re.M)
OLD = re.compile(r"^\s*(?:common\s*/|go\s*to\s|equivalence\s*\()", re.I | re.M)
MARK = re.compile(r"\b(?:TODO|FIXME|XXX)\b|not implemented|placeholder", re.I)
SAVED = re.compile(r"^\s*(?:integer|real|logical|character|type)\b(?!.*\bparameter\b)[^!]*::[^!]*?\b\w+(?:\([^)]*\))?\s*=[^>=]", re.I)


# Houses and rooms that several threads work in. There no function may leave the length of its text to the result: gfortran keeps
# that length in a static variable of each call (see to_text in src/base/text/text.f90).
THREADED = ("src/algebra/", "src/scene/trajectory/", "src/scene/string/", "src/scene/hole/", "src/scene/case/", "src/results/",
            "src/axis_methods/", "src/mechanics/", "src/solver/", "src/analysis/mixed_string/", "src/analysis/limits/", "src/studies/fit/")
THREADED_FILES = {"sampled_model", "sample_statistics", "calibration", "calibration_result", "prediction", "learnt_friction", "stuck_string",
                  "sweep", "sweep_result", "uncertainty", "steering", "sticking",
                  "study_plan"}
FUNCTION = re.compile(r"^[ \t]*(?:(?:pure|elemental|recursive|impure)\s+)*function\s+(\w+)\s*\([^)]*\)\s*(?:result\s*\((\w+)\))?(.*?)"
                      r"^[ \t]*end function", re.I | re.M | re.S)
DEFERRED_OF_BASE = re.compile(r"\b(?:joined|text_or_nothing|suggestion|nearest_name|interruption_name)\s*\(", re.I)


def texts_of_open_length(text):
    """Functions of this text whose result is a text of deferred length, and calls of such functions of base/."""
    found = [name for name, result, body in FUNCTION.findall(text)
             if re.search(rf"character\s*\(\s*:\s*\)\s*,\s*allocatable\s*::[^\n]*\b{result or name}\b", body, re.I)]
    return found + DEFERRED_OF_BASE.findall(text)


# gfortran 12 allots one byte for the text of such an element of an array where its length is known at run time only: dg_text's text_list.
TEXT_IN_ARRAY = re.compile(r"\btext_type\((?!['\"])")


def saved_locals(text):
    """Variables of procedures that are given a value where they are declared: Fortran keeps those between calls."""
    inside, in_type, found = False, False, []
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.split("!")[0].strip().lower()
        if re.match(r"type\s*(?:,[^:]*)?(?:::)?\s*\w+$", bare) and not re.match(r"type\s+is\b", bare):
            in_type = True
        elif re.match(r"end\s*type\b", bare):
            in_type = False
        elif bare == "contains":
            inside = True
        if inside and not in_type and SAVED.match(line):
            found.append(number)
    return found


def untried_numbers(root):
    """Numbers of dg_tuning that nothing uses, or that `bench -- ablation` does not try; the list of attempts is tried by its length."""
    body = re.search(r"type :: tuning_type\n(.*?)end type", (root / "src/scene/case/tuning.f90").read_text(encoding="utf-8"), re.S).group(1)
    names = set(re.findall(r"^ +(?:real|integer|logical)[^:!]*:: (\w+)", body, re.M))
    table = re.findall(r"case.*call change\('(\w+)', tuning%(\w+),",
                       (root / "app/bench/bench_ablation.f90").read_text(encoding="utf-8"))
    used = " ".join(path.read_text(encoding="utf-8") for path in (root / "src").rglob("*.f90"))
    return [f"src/scene/case/tuning.f90: {name}: nothing uses it" for name in sorted(names) if f"tuning%{name}" not in used] + \
           [f"app/bench/bench_ablation.f90: {name}: not tried, or under another name, or no number of dg_tuning"
            for name in sorted(names ^ {name for name, changed in table if name == changed})]


# Procedures that take more, and why.
INNERMOST = "innermost loop over elements: a type would be filled and emptied for each"
FOREIGN = "another library's"
WIDER = {
    **dict.fromkeys(("beam_tangent_parts", "assemble", "gap_nodal_force"), INNERMOST),
    **dict.fromkeys(("dgbtrs", "dgels", "dgesvd", "ldl_numeric"), FOREIGN),
    "prove": "all that bend_again works on, for its last step",
    "set_helix": "arrays along a zone, each of its own meaning",
}

BEGIN_PROCEDURE = re.compile(r"^\s*(?:(?:pure|elemental|recursive|impure|module)\s+)*(?:subroutine|(?:[a-z_]+(?:\([^)]*\))?\s+)?function)"
                             r"\s+(\w+)\s*(\(.*)?$", re.I)
END_PROCEDURE = re.compile(r"^\s*end\s*(?:subroutine|function)\b", re.I)


def large_procedures(path, name):
    """Procedures of a file that are too long, or take too much; the names of all."""
    lines, open_ones, found, names = path.read_text(encoding="utf-8").splitlines(), [], [], set()
    for number, line in enumerate(lines, 1):
        bare = line.split("!")[0]
        begin = BEGIN_PROCEDURE.match(bare)
        if END_PROCEDURE.match(bare):
            procedure, first = open_ones.pop()
            if number - first + 1 > LARGEST and procedure not in LONGER:
                found.append(f"{name}: {procedure} has {number - first + 1} lines, more than {LARGEST}")
        elif begin:
            procedure = begin.group(1).lower()
            names.add(procedure)
            open_ones.append((procedure, number))
            head, k = begin.group(2) or "", number
            while head.rstrip().endswith("&"):
                head, k = head.rstrip().rstrip("&") + lines[k].split("!")[0], k + 1
            arguments = head[1:head.find(")")].split(",")
            if len(arguments) > MOST_ARGUMENTS and procedure not in WIDER:
                found.append(f"{name}: {procedure} takes {len(arguments)} arguments, more than {MOST_ARGUMENTS}")
    return found, names


def bare(text):
    """Statements without comments and texts, each on one line; directives of OpenMP stay."""
    text = re.sub(r"'[^'\n]*'|\"[^\"\n]*\"", "''", text)
    return re.sub(r"&\s*\n\s*&?", " ", re.sub(r"!(?!\$).*", "", text))


IMPORT = re.compile(r"^\s*use\s*(?:,\s*intrinsic\s*)?(?:::)?\s*\w+\s*,\s*only\s*:(.*)$", re.I | re.M)


def unused_imports(text):
    """Names that a file takes from other modules and does not use."""
    rest = set(re.findall(r"(?:\b|(?<=\d_))[a-z]\w*", IMPORT.sub("", bare(text)).lower()))
    names = [name.split("=>")[0].strip() for line in IMPORT.findall(bare(text)) for name in line.split(",")]
    return [name for name in names if re.fullmatch(r"\w+", name) and name.lower() not in rest]


def without_caller(root):
    """Public names of src/ that no other file of src/, app/ or test/ has."""
    texts = {path: bare(path.read_text(encoding="utf-8"))
             for top in ("src", "app", "test") for path in sorted((root / top).rglob("*.f90"))}
    words = {path: set(re.findall(r"\w+", text.lower())) for path, text in texts.items()}
    found = []
    for path, text in texts.items():
        if path.relative_to(root).parts[0] != "src":
            continue
        public = {name.strip().lower() for line in re.findall(r"^\s*public\s*::(.*)$", text, re.I | re.M) for name in line.split(",")}
        for name in sorted(public):
            if not any(name in there for other, there in words.items() if other != path):
                found.append(f"{path.relative_to(root)}: {name} is public, and nothing uses it")
    return found


def undescribed(path, text):
    """Public procedures of a file of src/ without a comment before them."""
    public = {name.strip().lower() for line in re.findall(r"^\s*public\s*::(.*)$", bare(text), re.I | re.M) for name in line.split(",")}
    lines, found = text.splitlines(), []
    for number, line in enumerate(lines):
        begin = BEGIN_PROCEDURE.match(line.split("!")[0])
        if END_PROCEDURE.match(line):
            continue
        if begin and begin.group(1).lower() in public and line.startswith("   ") and line[3] != " " and \
                not lines[number - 1].lstrip().startswith("!>"):
            found.append(f"{path}: {begin.group(1)} is public, and nothing is said of it")
    return found


def check(root):
    faults = [f"{p.name}: not a name for the top level" for p in sorted(root.iterdir())
              if not p.name.startswith(".") and p.name not in TOP] + untried_numbers(root) + without_caller(root)
    procedures = set()
    for top in ("src", "app", "test"):
        for path in sorted((root / top).rglob("*.f90")):
            if "build" in path.relative_to(root).parts:
                continue
            name, text = path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")
            lines = text.count("\n")
            if lines > LONGEST[top] and name not in TABLES:
                faults.append(f"{name}: {lines} lines, more than {LONGEST[top]}")
            large, names = large_procedures(path, name)
            faults += large
            procedures |= names
            if "implicit none" not in text.lower():
                faults.append(f"{name}: no implicit none")
            modules = MODULE.findall(text)
            stand_in = name.startswith("test/funit/")
            wanted = ("" if stand_in or name == DOOR else PREFIX) + path.stem
            if top == "src" and modules != [wanted]:
                faults.append(f"{name}: holds {modules}, expected one module {wanted}")
            elif modules and modules != [wanted]:
                faults.append(f"{name}: holds {modules}, expected {wanted}")
            if modules and not re.search(r"^\s*private\s*$", text, re.M):
                faults.append(f"{name}: not private by default")
            faults += [f"{name}: {unused} is taken from another module, and not used" for unused in unused_imports(text)]
            if USE_ALL.search(text):
                faults.append(f"{name}: use without only: {USE_ALL.search(text).group().strip()}")
            if top == "src" and name not in ENDS and STOP.search(text):
                faults.append(f"{name}: {STOP.search(text).group().strip()}: errors are returned, only the main program stops")
            if OLD.search(text):
                faults.append(f"{name}: {OLD.search(text).group().strip()}")
            if top != "test" and MARK.search(text):
                faults.append(f"{name}: unfinished: {MARK.search(text).group()}")
            if top == "src":
                faults += undescribed(name, text)
            if top == "src" and (name.startswith(THREADED) or path.stem in THREADED_FILES):
                faults += [f"{name}: {found}: a function's text of open length, where threads work" for found in texts_of_open_length(text)]
            faults += [f"{name}:{number}: a value at the declaration is kept between calls" for number in saved_locals(text)]
            faults += [f"{name}:{number}: use text_list: this text gets one byte" for number, line in enumerate(text.splitlines(), 1)
                       if TEXT_IN_ARRAY.search(line.split("!")[0])]
    return faults + [f"check_layout.py: {name} of LONGER or WIDER is not there" for name in sorted({*LONGER, *WIDER} - procedures)]


def main():
    faults = check(pathlib.Path(__file__).resolve().parent.parent)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Lists that are kept by hand are whole: what is added to a type or to the keys of a deck is forgotten nowhere.

  copies    each component of a type in COPIES stands in the procedure that copies the type or writes it down, or is named there
            as left out
  keys      each key that a source asks a group for is a key of a deck; each key of a deck is named by a source that reads decks,
            whole or by its ending ('_unit')
  groups    test/README.md names each group of verification tests
"""
import re
import sys

from check_docs import ROOT, constructors, key_sources, source, unquoted, without_comments

# Type, its file; the file and the procedure that lists its components ('': anywhere in it); components that are left out, and why.
COPIES = (
    ("model_type", "scene/case/model.f90", "scene/case/model.f90", "copy_without_cases", {"path_notes": "texts for reports"}),
    ("hole_section_type", "scene/hole/hole_section.f90", "scene/hole/hole_section.f90", "visit_hole",
     {"name": "a text", "cased": "a logical; model_text.f90 writes it where a sweep goes by it"}),
    ("component_type", "scene/string/component.f90", "scene/string/component.f90", "visit_forces|visit_ratings",
     {"name": "a label", "kind": "a text; model_text.f90 writes it", "centralizer": "a type; model_text.f90 writes it",
      "fatigue": "a type; check_fatigue_ranges and draft_fatigue know it", "joint_fatigue": "the same"}),
    ("load_case_type", "scene/case/load_case.f90", "scene/case/load_case.f90", "visit_case",
     {"name": "a text", "section": "a text", "string": "a text", "operation": "a choice", "bend_stands": "no deck gives it",
      "length_reference": "the name of a load case in decks"}),
    ("rig_type", "scene/case/rig.f90", "scene/case/rig.f90", "visit_rig",
     {"given": "no key", "active_deadline_sheave": "a choice"}),
    ("centralizer_type", "scene/string/centralizer.f90", "studies/ensemble/model_text.f90", "append_centralizer",
     {"present": "asked before"}),
    ("fluid_type", "scene/hole/fluid.f90", "studies/ensemble/model_text.f90", "append_fluid",
     {"collar": "changes stresses alone"}),
)
ASKING = "is_given|is_sound|line_of|optional_of|real_of|integer_of|logical_of|text_of|reals_of|texts_of|places_of"


def components(text, name):
    """Names of the components of a type."""
    body = re.search(rf"type ::\s*{name}\n(.*?)end type", text, re.S).group(1)
    names = []
    for declared in re.findall(r"::\s*([^!\n]*)", body):
        names += re.findall(r"(?:^|,)\s*(\w+)", re.sub(r"\([^()]*\)|=[^,]*", "", declared))
    return names


def faults_of_copies():
    faults = []
    for name, file, lister, procedure, left_out in COPIES:
        text = source(lister)
        if procedure:
            text = "".join(re.findall(rf"subroutine (?:{procedure})\(.*?end subroutine", text, re.S))
        found = components(source(file), name)
        listed = set(re.findall(r"%(\w+)", text))
        place = f"src/{lister}{': ' + procedure if procedure else ''}"
        faults += [f"{place} lacks {one} of {name}; list it there, or name it in .ci/check_lists.py" for one in found
                   if one not in listed | set(left_out)]
        faults += [f".ci/check_lists.py leaves out {one}, which {name} does not have" for one in left_out if one not in found]
    print(f"  {len(COPIES)} types are listed whole")
    return faults


def faults_of_keys():
    rules = constructors(key_sources(), "key_rule_type")
    keys = {unquoted(plain[1]) for plain, _ in rules}
    literals, faults, asked = set(), [], 0
    for house in ("app", "src/deck", "src/scene", "src/studies"):
        for file in sorted((ROOT / house).rglob("*.f90")):
            if file.name.endswith("_keys.f90"):
                continue
            text = without_comments(file)
            if house != "src/scene":
                literals |= set(re.findall(r"'(\w+)'", text)) | {word for words in re.findall(r"'([\w ]+)'", text)
                                                                for word in words.split()}
            visited = re.findall(r"visitor%\w+\('(\w+)'", text)
            literals |= set(visited)
            for key in visited + re.findall(rf"\b(?:{ASKING})\([^'()]*(?:\([^'()]*\))?[^'()]*, *'(\w+)'", text):
                asked += 1
                if key not in keys:
                    faults.append(f"{file.relative_to(ROOT)} asks for the key {key}, which no deck has")
    faults += [f"no source reads the key {key}" for key in sorted(keys - literals)
               if not any(key.endswith(word) for word in literals if word.startswith("_"))]
    print(f"  {len(keys)} keys of decks, asked for at {asked} places")
    return faults


def faults_of_groups():
    text = (ROOT / "test/README.md").read_text(encoding="utf-8")
    names = set(re.findall(r"use dg_test_(\w+), only: \1_suite", (ROOT / "test/verification/verification.f90").read_text()))
    print(f"  {len(names)} groups of verification tests")
    return [f"test/README.md does not name the group {name}" for name in sorted(names) if not re.search(rf"\b{name}\b", text)]


def main():
    faults = faults_of_copies() + faults_of_keys() + faults_of_groups()
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

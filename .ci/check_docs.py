#!/usr/bin/env python3
"""Checks that the READMEs of input/, output/ and src/ say what the sources hold.

  input/README.md   one table a group, between marks; must be the table that the deck reader's own rules give
                    (src/deck/deck_keys.f90, defaults of &solver from src/model/numerics.f90); all operations named
  output/README.md  one table a file: the columns of its header in src/report, all of them, in their order
  src/README.md     one row a folder, with the arrows of check_arrows.py; files and procedures that it cites exist

Usage: check_docs.py [--write]     --write brings the tables of input/README.md up to date
"""
import pathlib
import re
import sys

import check_arrows

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Files of results and the function that gives the header of each.
HEADERS = {
    "summary.csv": ("summary_file.f90", "summary_header"),
    "profile_<case>_<model>.csv": ("profile_file.f90", "profile_header"),
    "history_<case>_<model>.csv": ("history_file.f90", "history_header"),
    "legacy_<label>.csv": ("legacy_rows.f90", "legacy_header"),
}
# Keys whose default the table of keys leaves to the code that makes use of them.
DEFAULTS_ELSEWHERE = {"gap_location": {"gap_at_extremum": "extremum", "gap_at_nodes": "nodes"}}


def source(name):
    """A file of src/ without comments, continued lines joined."""
    return without_comments(ROOT / "src" / name)


def without_comments(path):
    text = path.read_text(encoding="utf-8")
    lines = []
    for line in text.splitlines():
        bare, quote = "", ""
        for char in line:
            if char == "!" and not quote:
                break
            if quote:
                quote = "" if char == quote else quote
            elif char in "'\"":
                quote = char
            bare += char
        lines.append(bare.rstrip())
    return re.sub(r"&\s*\n\s*&?", " ", "\n".join(lines))


def arguments(text):
    """Splits the inside of a structure constructor at its commas."""
    parts, depth, quote, part = [], 0, False, ""
    for char in text:
        if char == "'":
            quote = not quote
        if not quote:
            depth += (char in "([") - (char in ")]")
            if char == "," and depth == 0:
                parts.append(part.strip())
                part = ""
                continue
        part += char
    return parts + [part.strip()]


def constructors(text, name):
    """The arguments of each `name(...)` in a source: positional ones as a list, named ones as a table."""
    found = []
    for match in re.finditer(rf"\b{name}\(", text):
        depth, end, quote = 1, match.end(), False
        while depth:
            char = text[end]
            quote ^= char == "'"
            if not quote:
                depth += (char == "(") - (char == ")")
            end += 1
        plain, named = [], {}
        for part in arguments(text[match.end():end - 1]):
            keyword = re.match(r"(\w+)\s*=\s*(.*)$", part, re.S)
            if keyword:
                named[keyword.group(1)] = keyword.group(2)
            else:
                plain.append(part)
        found.append((plain, named))
    return found


def unquoted(text):
    return text[1:-1].replace("''", "'") if text else ""


def real_constants(text):
    return {name: value for name, value in
            re.findall(r"real\(wp\), parameter ::\s*(\w+)\s*=\s*([-\d.eE]+)(?:_wp)?", text)}


def number(text, constants):
    text = text.strip()
    sign = -1.0 if text.startswith("-") else 1.0
    text = text.lstrip("-").replace("_wp", "")
    return sign*float(constants.get(text, text))


def shown(value):
    """A number with the fewest digits."""
    text = f"{value:.12g}"
    if abs(value) >= 1.0e5 or 0.0 < abs(value) < 1.0e-3:
        text = re.sub(r"\.?0*e([-+])0*", lambda m: "e" + m.group(1).replace("+", ""), f"{value:.6e}")
    return text


def deck_units():
    """Names of the units of a deck, SI and field, and the SI value of one, by the rules' names of units."""
    schema, units = source("deck/deck_schema.f90"), source("base/units.f90")
    labels = {name: (si, field or si) for name, si, field in
              re.findall(r"case \((unit_\w+)\); label = (?:pick\()?'([^']*)'(?:, '([^']*)'\))?", schema)}
    factors = dict(re.findall(r"real\(wp\) :: (\w+) = ([\d.e]+)_wp", units))
    used = dict(re.findall(r"case \((unit_\w+)\); factor = units%(\w+)", schema))
    return labels, {name: float(factors.get(field, 1.0)) for name, field in used.items()}


def solver_defaults():
    """Defaults of the components of numerics_type, in SI."""
    text = source("model/numerics.f90")
    constants = real_constants(text)
    body = text[text.index("type :: numerics_type"):text.index("end type numerics_type")]
    found = {}
    for name, value in re.findall(r"::\s*(\w+)\s*=\s*(\S+)", body):
        found[name] = constants.get(value, value.replace("_wp", ""))
    return found


def key_table(group, rules, labels, factors, numerics):
    """The lines of the table of a group's keys, as they stand in input/README.md."""
    constants = real_constants(source("deck/deck_keys.f90"))
    lines = ["| key | default | legal values | unit (field) | meaning |", "|---|---|---|---|---|"]
    for plain, named in rules:
        if unquoted(plain[0]) != group:
            continue
        key = unquoted(plain[1])
        kind = plain[2] if len(plain) > 2 else "kind_real"
        unit = named.get("unit", "unit_none")
        default = unquoted(named.get("default", ""))
        if group == "solver" and not default:
            value = DEFAULTS_ELSEWHERE.get(key, {}).get(numerics[key], numerics[key])
            default = value if kind in ("kind_text", "kind_logical") else shown(float(value)/factors.get(unit, 1.0))
        if named.get("required") == ".true.":
            default = "*required*"
        elif kind == "kind_text" and default:
            default = f"`'{default}'`"
        elif default:
            default = f"`{default}`"
        choices, later = unquoted(named.get("choices", "")), unquoted(named.get("later", ""))
        if later == "*":
            legal = "not in this version"
        elif choices == "*":
            legal = "see below"
        elif choices:
            legal = ", ".join(f"`'{word}'`" for word in choices.split())
            if later:
                legal += "; not yet " + ", ".join(f"`'{word}'`" for word in later.split())
        elif kind == "kind_text":
            legal = "text"
        elif kind == "kind_logical":
            legal = "`.true.`, `.false.`"
        else:
            low, high = (shown(number(named[end], constants)) for end in ("low", "high"))
            legal = f"> {low}, <= {high}" if named.get("open") == ".true." else f"{low} to {high}"
            if kind == "kind_integer":
                legal = "whole, " + legal
        si, field = labels.get(unit, ("", ""))
        name = f"`{key}(:)`" if named.get("array") == ".true." else f"`{key}`"
        lines.append(f"| {name} | {default or '-'} | {legal} | {si if si == field else f'{si} ({field})'} | "
                     f"{unquoted(named['meaning']).replace('<', '&lt;')} |".replace("|  |", "| - |"))
    return lines


def check_input(write):
    path = ROOT / "input/README.md"
    text = path.read_text(encoding="utf-8")
    keys = source("deck/deck_keys.f90")
    rules = constructors(keys, "key_rule_type")
    labels, factors = deck_units()
    numerics = solver_defaults()
    faults = []
    groups = {unquoted(plain[0]): named for plain, named in constructors(keys, "group_rule_type") if plain}
    marked = re.compile(r"<!-- keys of (\w+) -->\n(.*?)<!-- end -->", re.S)
    documented = {name for name, _ in marked.findall(text)}
    for name, named in groups.items():
        if named.get("available") == ".false.":
            if f"`&{name}`" not in text:
                faults.append(f"input/README.md does not name the group &{name}, which this version does not have")
        elif name not in documented:
            faults.append(f"input/README.md has no table of the keys of &{name}")
    faults += [f"input/README.md documents &{name}, which no deck has" for name in documented - set(groups)]

    def fresh(match):
        table = "\n".join(key_table(match.group(1), rules, labels, factors, numerics)) + "\n"
        if table != match.group(2):
            faults.append(f"input/README.md: table of &{match.group(1)} is out of date; run .ci/check_docs.py --write")
        return f"<!-- keys of {match.group(1)} -->\n{table}<!-- end -->"

    renewed = marked.sub(fresh, text)
    if write and renewed != text:
        path.write_text(renewed, encoding="utf-8")
        faults = [fault for fault in faults if "--write" not in fault]
    cases = source("model/load_case.f90")
    for array in ("operation_name", "operation_alias"):
        words = re.search(rf"{array}\(operation_count\) = \[character\(\d+\) ::(.*?)\]", cases, re.S).group(1)
        faults += [f"input/README.md does not name the operation {word}" for word in re.findall(r"'(\w+)'", words)
                   if f"`{word}`" not in text]
    print(f"  input/README.md: {len(rules)} keys of {len(documented)} groups")
    return faults


def header_of(file, function):
    """The column names that a header function gives with SI units."""
    text = source(f"report/{file}")
    body = re.search(rf"function {function}\(units\).*?end function {function}", text, re.S).group()
    labels = {name: value.strip() for name, value in
              re.findall(r"character\(\d+\) :: (\w+_label) = '([^']*)'", source("base/units.f90"))}
    values = {}

    def value_of(expression):
        result = ""
        for term in expression.split("//"):
            term = term.strip()
            label = re.match(r"trim\(units%(\w+)\)$", term)
            result += unquoted(term) if term.startswith("'") else labels[label.group(1)] if label else values[term]
        return result

    for line in body.splitlines():
        assigned = re.match(r"\s*(\w+) = (.*)$", line)
        if assigned:
            values[assigned.group(1)] = value_of(assigned.group(2))
    return values["header"].split(",")


def check_output():
    text = (ROOT / "output/README.md").read_text(encoding="utf-8")
    faults, total = [], 0
    sections = {title.strip("` "): body for title, body in re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", text, re.M | re.S)}
    for file in sorted((ROOT / "src/report").glob("*.f90")):
        for function in re.findall(r"\bfunction (\w+_header)\(units\)", file.read_text(encoding="utf-8")):
            if (file.name, function) not in HEADERS.values():
                faults.append(f"src/report/{file.name}: {function} is not in the list of {pathlib.Path(__file__).name}")
    for name, (file, function) in HEADERS.items():
        wanted = header_of(file, function)
        total += len(wanted)
        found = re.findall(r"^\| `(\w+)` \|", sections.get(name, ""), re.M)
        faults += [f"output/README.md: {name}: column {column} is missing" for column in wanted if column not in found]
        faults += [f"output/README.md: {name}: there is no column {column}" for column in found if column not in wanted]
        if sorted(found) == sorted(wanted) and found != wanted:
            faults.append(f"output/README.md: {name}: the columns stand in another order than in the file")
    print(f"  output/README.md: {total} columns of {len(HEADERS)} files")
    return faults


def check_src():
    text = (ROOT / "src/README.md").read_text(encoding="utf-8")
    faults, cited = [], 0
    rows = {name: {word for word in re.findall(r"\w+", uses) if word != "nothing"} for name, uses in
            re.findall(r"^\| `(\w+)/` \|.*\| ([^|]*) \|$", text, re.M)}
    for folder in sorted(p.name for p in (ROOT / "src").iterdir() if p.is_dir()):
        if folder not in rows:
            faults.append(f"src/README.md has no row for {folder}/")
        elif rows[folder] != check_arrows.MAY_USE.get(folder):
            faults.append(f"src/README.md: {folder}/ uses {sorted(rows[folder])}, check_arrows.py has "
                          f"{sorted(check_arrows.MAY_USE.get(folder, []))}")
    for name, procedures in re.findall(r"`(\w+/\w+\.f90)`((?:,? `\w+`)*)", text):
        path = ROOT / name if name.startswith("app/") else ROOT / "src" / name
        cited += 1
        if not path.is_file():
            faults.append(f"src/README.md: there is no {name}")
            continue
        for word in re.findall(r"`(\w+)`", procedures):
            if not re.search(rf"\b{word}\b", without_comments(path)):
                faults.append(f"src/README.md: {name} has no {word}")
    conventions = set(re.findall(r"^(\d+)\. \*\*", text, re.M))
    for path in sorted((ROOT / "src").rglob("*.f90")):
        for numbers in re.findall(r"conventions? ([\d, and]*\d)", path.read_text(encoding="utf-8")):
            for one in re.findall(r"\d+", numbers):
                if one not in conventions:
                    faults.append(f"{path.relative_to(ROOT)}: src/README.md has no convention {one}")
    print(f"  src/README.md: {len(rows)} folders, {cited} citations of files, {len(conventions)} conventions")
    return faults


def main():
    write = sys.argv[1:] == ["--write"]
    if sys.argv[1:] and not write:
        raise SystemExit(__doc__)
    faults = check_input(write) + check_output() + check_src()
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Checks that the READMEs of input/, output/ and src/ say what the sources hold.

  input/README.md   one table a group, between marks; must be the table that the deck reader's own rules give
                    (src/scene/rules/deck_keys.f90 and *_keys.f90 of studies/, defaults of &solver from
                    src/scene/case/numerics.f90); all operations named
  output/README.md  one table a file, between marks; must be the table that the writer's own columns give
                    (OUTPUT_HOUSES), units of SI decks
  src/README.md     one row a house, with the arrows of check_houses.py, and one a room; files and procedures that it cites exist;
                    what a new operation, key, column or model touches is what the example of its row touches

Usage: check_docs.py [--write]     --write brings the tables of input/ and output/README.md up to date
"""
import pathlib
import re
import sys

import check_houses

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Houses whose modules describe columns of files and tables.
OUTPUT_HOUSES = ("report", "studies")

# Procedures that add the columns of a table that only report.html has.
ON_PAGE = {"part_row", "lost_row", "curve_series"}
# Procedures that add the columns of a file.
COLUMNS = {
    "study_row": "study.csv",
    "steering_row": "steering.csv",
    "summary_row": "summary.csv",
    "profile_series": "profile_<case>_<model>.csv",
    "limits_row": "limits.csv",
    "history_series": "history_<case>_<model>.csv",
    "legacy_row": "legacy_<label>.csv",
    "sweep_row": "sweep_<name>.csv",
    "uncertainty_row": "uncertainty_<name>.csv",
    "factor_row": "calibration.csv",
    "datum_row": "calibration_data.csv",
    "prediction_row": "calibration_prediction.csv",
    "contact_series": "contacts_<case>_<model>.csv",
    "wear_series": "casing_wear_<case>_<model>.csv",
    "fatigue_series": "fatigue_<case>_<model>.csv",
    "gap_series": "/cases/<case>/<model>/gaps",
    "survey_series": "/survey",
}
# Keys whose default the table of keys leaves to the code that makes use of them; '' where another key sets it.
DEFAULTS_ELSEWHERE = {"gap_location": {"gap_at_extremum": "extremum", "gap_at_nodes": "nodes"}, "element_length": {"10.0": ""}}


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
    return re.sub(r"'\s*//\s*'", "", text)[1:-1].replace("''", "'") if text else ""


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


def key_sources():
    """The tables of keys: those of the scene, then those of studies."""
    studies = sorted((ROOT / "src/studies").glob("*/*_keys.f90"))
    return "\n".join([source("scene/rules/deck_keys.f90"), *map(without_comments, studies)])


def unit_table():
    """The table of src/base/units/quantity.f90: for each quantity its units by system, as label, suffix and factor in words."""
    text = re.sub(r"&\s*\n\s*", "", source("base/units/quantity.f90"))

    def unit(words):
        plain = constructors(words if "(" in words else re.search(rf"\b{words} = (unit_type\(.*)", text).group(1), "unit_type")[0][0]
        return unquoted(plain[0]), unquoted(plain[1]), plain[2]

    return {plain[0]: [unit(words) for words in arguments(plain[1][1:-1])] for plain, _ in constructors(text, "row_type")}


def units_table():
    """The lines of the table of units, as they stand in input/README.md."""
    said = dict(re.findall(r":: (quantity_\w+) = \d+ +!< (.*)", (ROOT / "src/base/units/quantity.f90").read_text(encoding="utf-8")))
    systems = re.search(r"deck_systems = '([^']*)'", source("base/units/quantity.f90")).group(1).split()
    lines = ["| quantity | " + " | ".join(systems) + " |", "|---" * (len(systems) + 1) + "|"]
    for quantity, units in unit_table().items():
        if units[0][0]:
            cells = [label + (f" (`_{suffix}`)" if suffix else "") for label, suffix, _ in units[:len(systems)]]
            name = quantity.removeprefix("quantity_").replace("_", " ")
            lines.append(f"| {name}{': ' + said[quantity] if quantity in said else ''} | " + " | ".join(cells) + " |")
    return lines


def deck_units():
    """Names of the units of a deck by system, and the SI value of one in SI, by the rules' names of units."""
    constants = dict(re.findall(r"(\w+) = ([\d.e]+)_wp(?![*/])", source("base/units/quantity.f90")))
    names = dict(re.findall(r"(unit_\w+) => (quantity_\w+)", source("base/units/unit_kind.f90")))
    table = unit_table()
    labels = {name: [label for label, _, _ in table[quantity][:-1]] for name, quantity in names.items()}
    words = {name: table[quantity][0][2].replace("_wp", "") for name, quantity in names.items()}
    factors = {name: constants.get(word, word) for name, word in words.items()}
    return labels, {name: float(word) for name, word in factors.items() if re.fullmatch(r"[\d.e-]+", word)}


def solver_defaults():
    """Defaults of the components of numerics_type, in SI."""
    text = source("scene/case/numerics.f90")
    constants = real_constants(text)
    body = text[text.index("type :: numerics_type"):text.index("end type numerics_type")]
    found = {}
    for name, value in re.findall(r"::\s*(\w+)\s*=\s*(\S+)", body):
        found[name] = constants.get(value, value.replace("_wp", ""))
    return found


def text_of(words):
    """The text of a constant of src/base/units/quantity.f90 by its name; any other words as they are."""
    constant = re.search(rf"parameter :: {words} = ('[^']*')", source("base/units/quantity.f90")) if words.isidentifier() else None
    return constant.group(1) if constant else words


def key_table(group, rules, labels, factors, numerics):
    """The lines of the table of a group's keys, as they stand in input/README.md."""
    constants = real_constants(key_sources() + source("scene/string/component.f90"))
    lines = ["| key | default | legal values | unit (field, metric) | meaning |", "|---|---|---|---|---|"]
    for plain, named in rules:
        if unquoted(plain[0]) != group:
            continue
        key = unquoted(plain[1])
        kind = plain[2] if len(plain) > 2 else "kind_real"
        unit = named.get("unit", "unit_none")
        default = unquoted(named.get("default", ""))
        if group == "solver" and not default:
            value = DEFAULTS_ELSEWHERE.get(key, {}).get(numerics[key], numerics[key])
            if value:
                default = value if kind in ("kind_text", "kind_logical") else shown(float(value)/factors.get(unit, 1.0))
        if named.get("required") == ".true.":
            default = "*required*"
        elif kind == "kind_text" and default:
            default = f"`'{default}'`"
        elif default:
            default = f"`{default}`"
        choices = unquoted(text_of(named.get("choices", "")))
        if choices == "*":
            legal = "table below" if group == "load_case" else "see &load_case"
        elif choices:
            legal = ", ".join(f"`'{word}'`" for word in choices.split())
        elif kind == "kind_text":
            legal = "text"
        elif kind == "kind_logical":
            legal = "`.true.`, `.false.`"
        else:
            low, high = (shown(number(named[end], constants)) for end in ("low", "high"))
            legal = f"> {low}, <= {high}" if named.get("open") == ".true." else f"{low} to {high}"
            if kind == "kind_integer":
                legal = "whole, " + legal
        si, *others = labels.get(unit, [""])
        units = si if set(others) <= {si} else f"{si} ({', '.join(others)})"
        name = f"`{key}(:)`" if named.get("array") == ".true." else f"`{key}`"
        lines.append(f"| {name} | {default or '-'} | {legal} | {units} | "
                     f"{unquoted(named['meaning']).replace('<', '&lt;')} |".replace("|  |", "| - |"))
    return lines


def check_input(write):
    path = ROOT / "input/README.md"
    text = path.read_text(encoding="utf-8")
    keys = key_sources()
    rules = constructors(keys, "key_rule_type")
    labels, factors = deck_units()
    numerics = solver_defaults()
    faults = []
    groups = {unquoted(plain[0]) for plain, _ in constructors(keys, "group_rule_type") if plain}
    marked = re.compile(r"<!-- keys of (\w+) -->\n(.*?)<!-- end -->", re.S)
    documented = {name for name, _ in marked.findall(text)}
    faults += [f"input/README.md has no table of the keys of &{name}" for name in groups if name not in documented]
    faults += [f"input/README.md documents &{name}, which no deck has" for name in documented - set(groups)]

    def fresh(match):
        table = "\n".join(key_table(match.group(1), rules, labels, factors, numerics)) + "\n"
        if table != match.group(2):
            faults.append(f"input/README.md: table of &{match.group(1)} is out of date; run .ci/check_docs.py --write")
        return f"<!-- keys of {match.group(1)} -->\n{table}<!-- end -->"

    renewed = marked.sub(fresh, text)
    table = "<!-- units -->\n" + "\n".join(units_table()) + "\n<!-- end -->"
    if table not in renewed:
        faults.append("input/README.md: table of units is out of date; run .ci/check_docs.py --write")
        renewed = re.sub(r"<!-- units -->\n.*?<!-- end -->", lambda _: table, renewed, flags=re.S)
    if write and renewed != text:
        path.write_text(renewed, encoding="utf-8")
        faults = [fault for fault in faults if "--write" not in fault]
    cases = source("scene/case/load_case.f90")
    operations = re.findall(r"(?:operation|alias)_type\('(\w+)'", cases)
    faults += [f"input/README.md does not name the operation {word}" for word in operations if f"`{word}`" not in text]
    print(f"  input/README.md: {len(rules)} keys of {len(documented)} groups")
    return faults


def header_suffixes():
    """What each quantity puts behind the name of a column, with SI units."""
    return {quantity: f"_{units[0][1]}" for quantity, units in unit_table().items() if units[0][1]}


def columns_of(name, procedures):
    """Columns that a procedure adds, and those that procedures of its module add for it: name, quantity and meaning."""
    found = []
    for call, words in re.findall(r"call (\w+)(\(.*)", procedures[name]):
        if re.match(r"\((?:row|list), '", words):
            plain, _ = constructors("add" + words, "add")[0]
            found.append((unquoted(plain[1]), plain[2], unquoted(plain[3])))
        elif call in procedures and call != name:
            found += columns_of(call, procedures)
    return found


def column_tables():
    """All tables of columns in OUTPUT_HOUSES: name of the procedure, and its columns as pairs of header and meaning."""
    suffixes, tables, faults = header_suffixes(), {}, []
    for file in sorted(file for house in OUTPUT_HOUSES for file in (ROOT / "src" / house).rglob("*.f90")):
        text = without_comments(file)
        procedures = {name: body for kind, name, body in
                      re.findall(r"\b(subroutine|function) (\w+)\((.*?)end \1 \2\n", text, re.S)}
        told = set()
        for name in set(procedures) & (COLUMNS.keys() | ON_PAGE):
            columns = columns_of(name, procedures)
            told |= {column for column, _, _ in columns}
            tables[name] = [(column + suffixes.get(quantity, ""), meaning) for column, quantity, meaning in columns]
        added = set(re.findall(r"call add\w*\((?:row|list), '(\w+)'", text))
        faults += [f"{file.relative_to(ROOT)}: {pathlib.Path(__file__).name} does not know what {name} is a column of"
                   for name in sorted(added - told)]
    return tables, faults


def check_output(write):
    path = ROOT / "output/README.md"
    text = path.read_text(encoding="utf-8")
    tables, faults = column_tables()
    tables = {name: table for name, table in tables.items() if name not in ON_PAGE}
    marked = re.compile(r"<!-- columns: (\w+) -->\n(.*?)<!-- end -->", re.S)
    shown = {name for name, _ in marked.findall(text)}
    faults += [f"output/README.md has no table of {name} ({COLUMNS.get(name)})" for name in tables if name not in shown]
    faults += [f"output/README.md shows {name}, which the program does not have" for name in shown - set(tables)]

    def fresh(match):
        name = match.group(1)
        rows = [f"| `{header}` | " + meaning.replace("|", "\\|").replace("<", "&lt;") + " |" for header, meaning in tables.get(name, [])]
        table = "\n".join(["| column | meaning |", "|---|---|", *rows]) + "\n"
        if table != match.group(2):
            faults.append(f"output/README.md: table {name} is out of date; run .ci/check_docs.py --write")
        return f"<!-- columns: {name} -->\n{table}<!-- end -->"

    renewed = marked.sub(fresh, text)
    if write and renewed != text:
        path.write_text(renewed, encoding="utf-8")
        faults = [fault for fault in faults if "--write" not in fault]
    print(f"  output/README.md: {sum(map(len, tables.values()))} columns of {len(tables)} tables")
    return faults


def check_src():
    text = (ROOT / "src/README.md").read_text(encoding="utf-8")
    faults, cited = [], 0
    rows = {name: {word for word in re.findall(r"\w+", uses) if word != "nothing"} for name, uses in
            re.findall(r"^\| `(\w+)/` \|.*\| ([^|]*) \|$", text, re.M)}
    for house in sorted({p.relative_to(ROOT / "src").parts[0] for p in (ROOT / "src").rglob("*.f90")}):
        if house not in rows:
            faults.append(f"src/README.md has no row for {house}/")
        elif rows[house] != check_houses.MAY_USE.get(house):
            faults.append(f"src/README.md: {house}/ uses {sorted(rows[house])}, check_houses.py has "
                          f"{sorted(check_houses.MAY_USE.get(house, []))}")
    told = set(re.findall(r"^\| `(\w+/\w+)/` \|", text, re.M))
    rooms = {"/".join(p.relative_to(ROOT / "src").parts[:2]) for p in (ROOT / "src").glob("*/*/*.f90")}
    faults += [f"src/README.md has no row for {room}/" for room in sorted(rooms - told)]
    faults += [f"src/README.md: there is no {room}/" for room in sorted(told - rooms)]
    for name, procedures in re.findall(r"`((?:\w+/)+\w+\.f90)`((?:,? `\w+`)*)", text):
        path = ROOT / name if name.startswith(("app/", "test/")) else ROOT / "src" / name
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
    added = re.findall(r"^\| [^|]* \| ([^|]*) \| `([\w%]+)` \|$", text[text.index("## How to add"):], re.M)
    for files, example in added:
        told = {name if name.startswith("app/") else f"src/{name}" for name in re.findall(r"`((?:\w+/)+\w+\.f90)`", files)}
        there = {str(path.relative_to(ROOT)) for folder in ("src", "app") for path in (ROOT / folder).rglob("*.f90")
                 if re.search(rf"\b{example}\b", without_comments(path))}
        faults += [f"src/README.md, How to add: {example} stands in {name}, too" for name in sorted(there - told)]
        faults += [f"src/README.md, How to add: {name} does not know {example}" for name in sorted(told - there)]
    print(f"  src/README.md: {len(rows)} houses, {len(rooms)} rooms, {cited} citations of files, {len(conventions)} conventions, {len(added)} things to add")
    return faults


def main():
    write = sys.argv[1:] == ["--write"]
    if sys.argv[1:] and not write:
        raise SystemExit(__doc__)
    faults = check_input(write) + check_output(write) + check_src()
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

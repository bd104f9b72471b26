"""What the files of one run must hold, whatever the deck was: legal words, finite numbers, forces in balance, nothing missing.

The deck is judged by what `--check` printed of it (the echo), whose strings and mud give the buoyed weight on a way of their
own. Shared by hostile_decks.py and fuzz.py.
"""
import base64
import csv
import hashlib
import html.parser
import json
import math
import re
import xml.etree.ElementTree

BALANCE = 1.0e-6             # force out of balance over the largest force: residuals are iterated to 1e-9 of the weight
ROUND_OFF = 1.0e-6           # force out of balance of a string next to weightless: its steel is as stiff as ever [kN or klbf]
AGREEMENT = 2.0e-2           # hook load against the uppermost axial force, which stands half an element lower
WEIGHT = 1.0e-5              # weight against that of the echo, which has seven digits, over the weight in air
SIDE_FORCES = 1.0e-4         # sum of side forces against normal_force
PULLED = 2.0e-5             # what walls may pull, which profiles do not show
STATUSES = ("converged", "not_converged", "locked_up")
OPERATIONS = ("trip_out", "trip_in", "rotate_off_bottom", "rotary_drilling", "sliding_drilling", "ream", "backream", "static")
UPWARDS, DOWNWARDS = ("trip_out", "backream"), ("trip_in", "sliding_drilling", "ream")
# Friction that has the wrong sign, over the largest force: bending moments at the ends push along the hole, too.
WRONG_WAY = 2.0e-2
SMALL_STRAIN = 0.01          # stretch over length
# Solutions that a calibration takes for each of its cases.
FIT = 50
TEXTS = {"case", "component", "section", "model", "operation", "status", "message", "gap_state", "judged_by", "kind", "buckling", "side", "shape", "hole", "fidelity",
         "gap_location", "linear_solver", "reference", "pareto", "calibration", "parameter", "verdict", "applied", "governing_limit", "can_be_done",
         "reason", "limit", "not_checked", "settings"}
NO_NUMBER = re.compile(r"[-+]?(nan(\(.*\))?|inf(inity)?|\*+)", re.I)
GRAVITY = 9.80665
# Lines of standard error that tell how much there is to solve, and how long it takes.
WORK = re.compile(r"^drillgap: [^\n]*(\bsolutions?\b|, \d+ %, [^\n]* left|: about [^\n]* left|: \d+ of \d+ solved in )[^\n]*(\n|$)", re.M)
COMPONENT = re.compile(r"^  (?:.*) \(.*\): (to surface|\S+ (?:m|ft)), od \S+ (?:mm|in), .*?(\S+) (?:kg/m|lbm/ft), density (\S+) ")


FORMULA_SIGNS = tuple("=+-@\t\r")       # first letters of a cell that a spreadsheet takes for a formula


def without_work(told):
    """Standard error without the lines that tell of work: how long it takes depends on the machine."""
    return WORK.sub("", told)


def rows_of(path, found):
    """The rows of a CSV file; every number in it is one, every row as long as the header."""
    with path.open(newline="", encoding="latin-1") as file:
        lines = list(csv.reader(file))
    if not lines:
        found.append(f"{path.name} is empty")
        return []
    header, rows = lines[0], []
    if len(set(header)) < len(header):
        found.append(f"{path.name}: a column twice")
    for number, line in enumerate(lines[1:], 2):
        if len(line) != len(header):
            found.append(f"{path.name}:{number}: {len(line)} fields, {len(header)} columns")
            return rows
        for name, field in zip(header, line):
            if name not in TEXTS and field and not is_number(field):
                found.append(f"{path.name}:{number}: {name} is {field!r}")
                return rows
        rows.append(dict(zip(header, line)))
    return rows


def is_number(field):
    try:
        return math.isfinite(float(field))
    except ValueError:
        return False


def endings(row):
    """Endings of columns of force, length and moment in the units of a row of results."""
    return next((found for found in (("kN", "m", "kNm"), ("kdaN", "m", "kNm")) if f"hookload_{found[0]}" in row),
                ("klbf", "ft", "kftlbf"))


def number(row, name):
    return float(row[name]) if row.get(name) else None


class Echo:
    """What `--check` says of a deck."""

    def __init__(self, text):
        self.units = found_in(r"^units +(\w+)$", text) or "SI"
        self.models = re.findall(r"\w+", found_in(r"^models +(.*)$", text))
        self.cases = {}                       # operation, depth, string
        for name, operation, depth, string in re.findall(r"^  (\S+): (\w+) at (\S+) (?:m|ft), string (.*?)(?:, .*)?$", text, re.M):
            self.cases[name] = (operation, float(depth), string)
        self.points = {}                      # of each sweep
        for name, points in re.findall(r"^sweep +(\S+): .*?(\d+) points", text, re.M):
            self.points[name] = int(points)
        # about the solutions that the deck asks for
        self.work = len(self.models) * len(self.cases) + sum(self.points.values()) + sum(map(int, re.findall(r", (\d+) solutions;", text)))
        self.work += FIT * sum(map(int, re.findall(r"^calibrate .* (\d+) load cases$", text, re.M)))
        self.work += sum(int(v) * int(c) for v, c in re.findall(r"^study +at most (\d+) variants of (\d+) cases", text, re.M))
        fluid = re.search(r"^fluid +(\S+) (?:kg/m3|lbm/gal|sg)", text, re.M)
        self.mud = float(fluid.group(1)) if fluid else 0.0
        # Weights are told for one fluid that fills the hole and the string, and no pressure at a packer beside the weight on bit.
        self.one_fluid = len(re.findall(r"^fluid .*(?:, from |, above the bit|inside|outside)|^boundary .*packer bore", text, re.M)) == 0
        self.gravity = float(found_in(r", gravity (\S+) m/s2", text) or GRAVITY)
        self.strings, parts = {}, None        # name: (length or None, mass, density) from the bit upwards
        for line in text.splitlines():
            head = re.match(r"^string +(.*), from the bit upwards$", line)
            part = COMPONENT.match(line)
            if head:
                parts = self.strings.setdefault(head.group(1), [])
            elif part and parts is not None:
                length = None if part.group(1) == "to surface" else float(part.group(1).split()[0])
                parts.append((length, float(part.group(2)), float(part.group(3))))
            elif not line.startswith("  "):
                parts = None

    def weight(self, case, depths, verticals):
        """Weight in mud along the hole and weight in air of a case's string; vertical depths by measured depth."""
        _, bottom, string = self.cases[case]
        if string not in self.strings:
            return None
        scale = self.gravity / {"SI": 1000.0, "field": 1000.0 * GRAVITY, "metric": 10000.0}[self.units]
        wet = dry = 0.0
        for length, mass, density in self.strings[string]:
            top = 0.0 if length is None else max(0.0, bottom - length)
            height = between(depths, verticals, bottom) - between(depths, verticals, top)
            wet += mass * (1.0 - self.mud / density) * scale * height
            dry += mass * scale * (bottom - top)
            bottom = top
        return (wet, dry) if bottom <= 0.0 else None


def found_in(pattern, text):
    match = re.search(pattern, text, re.M)
    return match.group(1) if match else ""


def between(depths, values, depth):
    """Linear interpolation; depths increase."""
    for i in range(1, len(depths)):
        if depth <= depths[i]:
            part = (depth - depths[i - 1]) / (depths[i] - depths[i - 1]) if depths[i] > depths[i - 1] else 0.0
            return values[i - 1] + part * (values[i] - values[i - 1])
    return values[-1]


def faults_of_results(out, status, deck, echo_text=None, order=True):
    """`status`: exit status, 0 or 3; `deck`: its text; without an echo, what it would tell is not asked; `order`: of a sweep's loads."""
    found = []
    tables = {path.name: rows_of(path, found) for path in sorted(out.glob("*.csv"))}
    echo = Echo(echo_text) if echo_text else None
    marked = 0                                                     # rows that make exit status 3
    for name, rows in tables.items():
        for row in rows:
            found += [f"{name}: a spreadsheet runs the cell {cell[:40]!r}" for cell in row.values()
                      if isinstance(cell, str) and cell.lstrip(" ")[:1] in FORMULA_SIGNS and not is_number(cell)][:1]
            if "status" in row and row["status"] not in STATUSES:
                found.append(f"{name}: status {row['status']!r}")
            if "operation" in row and row["operation"] and row["operation"] not in OPERATIONS:
                found.append(f"{name}: operation {row['operation']!r}")
        if name == "summary.csv" or name.startswith("sweep_"):
            marked += sum(row.get("status") == "not_converged" for row in rows)
        if name.startswith("uncertainty_"):
            marked += sum(row.get("not_converged") not in ("0", "") for row in rows)
            found += faults_of_quantiles(name, rows)
        if name == "steering.csv":
            marked += sum(row["status"] == "not_converged" for row in rows)
        if name == "calibration.csv":
            marked += sum(row["verdict"] != "found" for row in rows)
        if name.startswith("sweep_"):
            found += faults_of_sweep(name, rows) if order else []
            if echo and len(rows) != echo.points.get(name[len("sweep_"):-len(".csv")], len(rows)):
                found.append(f"{name}: {len(rows)} rows, {echo.points[name[len('sweep_'):-len('.csv')]]} points")
    asked = re.findall(r"(?i)\btolerance\s*=\s*([-+.\de]+)", deck)          # a loose one leaves as much out of balance
    balance = max([BALANCE] + [100.0 * float(a) for a in asked if re.fullmatch(r"(?i)[-+]?\d*\.?\d+(e[-+]?\d+)?", a)])
    summary = tables.get("summary.csv", [])
    if "summary.csv" not in tables and (echo is None or echo.cases):
        found.append("no summary.csv")
    if echo and [(r["model"], r["case"]) for r in summary] != [(m, c) for m in echo.models for c in echo.cases] and echo.cases:
        found.append(f"summary.csv: {len(summary)} rows, {len(echo.models)} models and {len(echo.cases)} cases")
    for row in summary:
        if row["status"] == "converged":
            found += faults_of_row(out, row, balance, echo, tables)
    for name, rows in tables.items():
        found += faults_of_failed(name, rows)
    if status == 0 and marked and "calibration.csv" not in tables:
        found.append("exit status 0 with a result not converged")
    if status == 3 and not marked:
        found.append("exit status 3 with every result converged")
    return found + faults_of_page(out)


# Columns of a state of the string, by how their names begin: empty where a result did not converge.
SHOWN = ("hookload", "torque", "normal_force", "equilibrium", "largest_", "buckling", "shape", "weight_indicator", "helical", "coil")


def faults_of_failed(name, rows):
    """A result that did not converge shows no state of the string."""
    if name not in ("summary.csv", "limits.csv", "study.csv") and not name.startswith("sweep_"):
        return []
    return [f"{name}: {row.get('case', '')} did not converge, but {column} is {field!r}" for row in rows if row["status"] == "not_converged"
            for column, field in row.items() if field and column.startswith(SHOWN)][:3]


def faults_of_row(out, row, balance, echo, tables):
    """Numbers of one solved case against each other, its profile, and the weight of its string."""
    found = []
    kN, m, kNm = endings(row)
    place = f"case {row['case']}, {row['model']}"
    values = {k: number(row, k) for k in (f"hookload_{kN}", f"friction_{kN}", f"normal_force_{kN}", f"wob_{kN}", f"torque_{kNm}")}
    if None in values.values():
        return [f"{place}: no {[k for k, v in values.items() if v is None]}"]
    hook, friction, normal, wob, torque = values.values()
    force = max(abs(hook), abs(friction), normal, abs(wob))
    left = number(row, f"equilibrium_{kN}") or 0.0
    if not left <= balance * force + ROUND_OFF:
        found.append(f"{place}: {left} {kN} out of balance, forces are {force}")
    if normal < 0.0:
        found.append(f"{place}: normal force {normal}")
    measured = number(row, f"measured_{kN}")
    shown = number(row, f"weight_indicator_{kN}")
    shown = hook if shown is None else shown
    if measured and abs(number(row, "error_pct") - 100.0 * abs(shown - measured) / measured) > 1e-6 * (1.0 + abs(shown / measured)) * 100:
        found.append(f"{place}: error {row['error_pct']} % of {shown} against {measured}")
    profile = tables.get(f"profile_{row['case']}_{row['model']}.csv")
    dry = force
    if profile:
        depths = [float(r[f"md_{m}"]) for r in profile]
        verticals = [float(r[f"tvd_{m}"]) for r in profile]
        axial = float(profile[0][f"axial_{kN}"])
        # Axial force acts along the string, the hook load along the hole: a string of decimetres may lean.
        offsets = [1e-3 * (number(r, "displacement_mm") or 0.0) for r in profile[:2]] if "displacement_mm" in profile[0] else [0.0, 0.0]
        lean = abs(offsets[1] - offsets[0]) / max(depths[1] - depths[0], 1e-9)
        if not abs(axial - hook) <= (AGREEMENT + lean) * max(force, 1e-6) + 0.01 * abs(wob):
            found.append(f"{place}: hook load {hook}, axial force at the top {axial}")
        if any(b < a for a, b in zip(depths, depths[1:])) or abs(depths[-1] - float(row[f"bit_depth_{m}"])) > 1e-6 * depths[-1]:
            found.append(f"{place}: depths of the profile")
        sides = [float(r[f"side_force_{kN}_{m}"]) for r in profile]
        if min(sides) < 0.0:
            found.append(f"{place}: a negative side force")
        # Forces of gaps are spread over the nodes beside them; at other models' points they jump, and sums of them are rough.
        total = sum((b - a) * (p + q) / 2.0 for a, b, p, q in zip(depths, depths[1:], sides, sides[1:]))
        if row["model"] == "mcge" and not abs(total - normal) <= SIDE_FORCES * max(normal, 1e-2 * force) + PULLED * force + 1e-9:
            found.append(f"{place}: side forces sum up to {total}, normal force {normal}")
        weight = echo.weight(row["case"], depths, verticals) if echo and echo.one_fluid and row["case"] in echo.cases else None
        if weight:
            wet, dry = weight
            if not abs(hook + wob + friction - wet) <= WEIGHT * max(dry, force):
                found.append(f"{place}: hook load + wob + friction = {hook + wob + friction}, weight in mud {wet}")
    if echo and row["case"] in echo.cases and (echo.cases[row["case"]][0] != row["operation"]):
        found.append(f"{place}: {row['operation']}, the deck says {echo.cases[row['case']][0]}")
    slack = WRONG_WAY * max(force, dry) + 1e-9
    stretched = max((abs(number(r, f"stretch_{m}") or 0.0) for r in tables.get("limits.csv", [])
                     if (r["case"], r["model"]) == (row["case"], row["model"])), default=0.0)
    if stretched > SMALL_STRAIN * float(row[f"bit_depth_{m}"]):       # tons a metre: told by a note, beyond any theory of beams
        slack = math.inf
    if (row["operation"] in UPWARDS and friction > slack) or (row["operation"] in DOWNWARDS and friction < -slack) or \
            (row["operation"] not in UPWARDS + DOWNWARDS and abs(friction) > slack):
        found.append(f"{place}: {row['operation']} with friction {friction} of {force}")
    if torque < -slack:
        found.append(f"{place}: torque {torque}")
    return found


def faults_of_sweep(name, rows):
    """More friction never helps: up above turning above down, at each depth by each model."""
    found, seen = [], {}
    kN, m, _ = endings(rows[0] if rows else {})
    for row in rows:
        hook = number(row, f"hookload_{kN}")
        if row["status"] != "converged":
            continue
        if hook is None:
            found.append(f"{name}: converged without a hook load at {row[f'bit_depth_{m}']}")
            continue
        seen.setdefault((row["model"], row["friction"], row[f"bit_depth_{m}"]), {})[row["operation"]] = hook
    for place, loads in seen.items():
        slack = WRONG_WAY * max(map(abs, loads.values())) + 1e-9
        order = [loads[o] for o in ("trip_in", "static", "trip_out") if o in loads]
        if any(b < a - slack for a, b in zip(order, order[1:])):
            found.append(f"{name}: {place} {loads}")
    return found


def faults_of_quantiles(name, rows):
    found = []
    for row in rows:
        for what in ("hookload", "torque"):
            values = [float(v) for k, v in row.items() if re.match(rf"{what}_p\d+_", k) and v]
            if values != sorted(values):
                found.append(f"{name}: quantiles {values}")
    return found


class Cells(html.parser.HTMLParser):
    """Texts of table cells, and whether something of a script came in."""

    def __init__(self):
        super().__init__()
        self.cells, self.scripts, self.inside, self.text = [], [], False, False

    def handle_starttag(self, tag, attributes):
        if tag in ("iframe", "img", "link", "object") or any(k.startswith("on") for k, _ in attributes):
            self.scripts.append(tag)
        if tag == "td":
            self.inside, self.text = True, ("class", "text") in attributes

    def handle_endtag(self, tag):
        if tag == "td":
            self.inside = False

    def handle_data(self, data):
        if self.inside and not self.text:
            self.cells.append(data.strip())


def faults_of_scripts(text):
    """A page has its data and the script that it names by its hash, or neither."""
    scripts = re.findall(r"<script([^>]*)>(.*?)</script>", text, re.S | re.I)
    if not scripts:
        return []
    if [attributes for attributes, _ in scripts] != [' type="application/json" id="data"', ""]:
        return [f"report.html holds scripts {[attributes for attributes, _ in scripts]}"]
    try:
        json.loads(scripts[0][1], parse_constant=float.fromhex)
    except ValueError as error:
        return [f"report.html: its data are no JSON: {error}"]
    digest = base64.b64encode(hashlib.sha256(scripts[1][1].encode()).digest()).decode()
    return [] if f"script-src 'sha256-{digest}'" in text else ["report.html: its script is not the one that it names"]


def faults_of_page(out):
    """Pictures are whole, the page is whole and holds nothing that runs."""
    found = []
    for path in sorted(out.rglob("*.svg")):
        try:
            if not xml.etree.ElementTree.parse(path).getroot().tag.endswith("svg"):
                found.append(f"{path.name} is no picture")
            elif re.search(rb"[\s,\"'](-?nan|-?inf)[\s,\"']", re.sub(rb"<text.*?</text>|<title.*?</title>|<desc.*?</desc>", b"",
                                                                   path.read_bytes(), flags=re.S), re.I):
                found.append(f"{path.name}: a number that is none")
        except xml.etree.ElementTree.ParseError as error:
            found.append(f"{path.name} is not whole: {error}")
    page = out / "report.html"
    if page.is_file():
        text = page.read_text(encoding="utf-8", errors="replace")
        if not text.rstrip().endswith("</html>"):
            found.append("report.html is not whole")
        cells = Cells()
        cells.feed(text)
        if cells.scripts:
            found.append(f"report.html holds {cells.scripts[:3]}")
        found += faults_of_scripts(text)
        bad = [cell for cell in cells.cells if NO_NUMBER.fullmatch(cell)]
        if bad:
            found.append(f"report.html: {bad[:3]}")
    return found

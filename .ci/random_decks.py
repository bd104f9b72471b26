#!/usr/bin/env python3
"""Random decks, run by a built drillgap: units and threads must not matter.

Usage: random_decks.py PATH_TO_DRILLGAP [--count N] [--seed S]

Every seed is a well, a string of several parts and three load cases, solved by all four models, five times:

  the deck in SI units           on one thread and on two: every CSV file the same to the last digit, but for times
  the same deck in field units   numbers converted here, by factors of its own: read by the program as it is
  and in metric units            likewise; every number of every CSV file of the models on the axis is then the same, by the unit
                                 in the name of its column
  the SI deck by --convert       the program's own conversion

What summary.csv says is the same in all units: hook load, friction and normal force over the largest force in the string,
torque over the largest torque. More than the tolerances below is a unit gone wrong. A case that is marked must be marked in
all. Prints the worst; ends in 'N passed, N failed'.
"""
import argparse
import contextlib
import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile

from run_results import without_work

MODELS = ("mcge", "soft", "rigid", "mixed")
# Of the largest force, or torque: files hold ten digits, a case is iterated to 1e-9 of the weight. A compressed string has
# equilibria next to each other, and where a gap rests within its thresholds round-off decides whether it counts as touching.
TOLERANCE, TOLERANCE_BESIDE = 1.0e-6, 5.0e-4
GAPS = ("gaps_free", "gaps_elastic", "gaps_rigid")
TIME_LIMIT = 300

# The value in SI deck units of one unit of the others, from the definitions of foot, inch, pound, gallon and standard gravity.
FOOT, INCH, POUND, GALLON, GRAVITY = 0.3048, 0.0254, 0.45359237, 231 * 0.0254**3, 9.80665
FIELD = {
    "m": FOOT, "mm": 25.4, "deg": 1.0, "kg/m": POUND / FOOT, "kg/m3": POUND / GALLON, "kN": POUND * GRAVITY,
    "kN.m": POUND * GRAVITY * FOOT, "GPa": POUND * GRAVITY / INCH**2 / 1e3, "MPa": POUND * GRAVITY / INCH**2 / 1e3,
    "kN/m2": POUND * GRAVITY / FOOT**2, "m/s": FOOT, "m/s2": FOOT, "rpm": 1.0, "": 1.0}
METRIC = {"m": 1.0, "mm": 25.4, "deg": 1.0, "kg/m": 1.0, "kg/m3": 1e3, "kN": 10.0, "kN.m": 1.0, "GPa": 1.0, "MPa": 0.1,
          "kN/m2": 10.0, "m/s": 1.0, "m/s2": 1.0, "rpm": 1.0, "": 1.0}
SYSTEMS = {"SI": dict.fromkeys(FIELD, 1.0), "field": FIELD, "metric": METRIC}
# The value in SI columns of one unit of a column of the others, by the ending of its name, that of SI columns and of the others.
ENDINGS = {
    "field": {"m": ("ft", FOOT), "mm": ("in", 25.4), "kN": ("klbf", FIELD["kN"]), "kNm": ("kftlbf", FIELD["kN.m"]),
              "kN_m": ("klbf_ft", FIELD["kN"] / FOOT), "MPa": ("ksi", FIELD["MPa"]), "deg_30m": ("deg_100ft", 30 / 30.48),
              "kN_m2": ("klbf_ft2", FIELD["kN/m2"])},
    "metric": {"mm": ("in", 25.4), "kN": ("kdaN", 10.0), "kN_m": ("kdaN_m", 10.0), "MPa": ("bar", 0.1), "kN_m2": ("kdaN_m2", 10.0)}}
PRESSURES = {"field": ("psi", FIELD["MPa"] / 1e3), "metric": ("bar", 0.1)}
AXIS_MODELS = ("soft", "rigid")
# Not compared: times, angles that jump from 360 to 0, and, for ties, places of the largest.
LEFT_OUT = ("seconds", "clock_deg", "azimuth_deg")
SAME_COLUMN = 2.0e-6   # of the largest number of a column: files hold ten digits, decks seventeen
UNIT = {
    "md": "m", "inc": "deg", "azi": "deg", "md_top": "m", "md_bottom": "m", "diameter": "mm", "wall_stiffness": "kN/m2",
    "mud_sheath": "mm", "fluid.density": "kg/m3", "component.density": "kg/m3", "length": "m", "od": "mm", "id": "mm",
    "mass": "kg/m", "youngs": "GPa", "joint_od": "mm", "joint_length": "m", "joint_spacing": "m", "yield": "MPa",
    "makeup_torque": "kN.m", "bit_depth": "m", "wob": "kN", "tob": "kN.m", "trip_speed": "m/s", "measured_hookload": "kN",
    "measured_torque": "kN.m", "element_length": "m", "rig_limit": "kN"}
OPERATIONS = ("up", "down", "rotate_off_bottom", "rotary", "sliding", "ream", "backream", "static")


def draw_deck(seed):
    """Groups of a deck in SI units: (name, {key: value}); numbers as numbers, texts quoted already."""
    rng = random.Random(seed)
    md, inc, azi = [0.0], [60.0 * rng.random() if rng.random() < 0.3 else 0.0], [360.0 * rng.random()]
    for _ in range(rng.randrange(3, 8)):
        course = rng.uniform(30.0, 330.0)
        turn = 0.0 if rng.random() < 0.25 else min(80.0, 0.5 * 30.0 ** (rng.random() ** 1.5) * course / 30.0)
        way = rng.uniform(0.0, 2.0 * math.pi)
        inclination = abs(inc[-1] + turn * math.cos(way))
        if inclination > 105.0:
            inclination = 210.0 - inclination
        azi.append((azi[-1] + turn * math.sin(way) / max(0.3, math.sin(math.radians(inclination)))) % 360.0)
        inc.append(inclination)
        md.append(md[-1] + course)
    bottom, friction = md[-1], 0.5 * rng.random()
    groups = [
        ("job", {"title": f"'seed {seed}'", "plots": ".false.", "models": ", ".join(f"'{m}'" for m in MODELS)}),
        ("trajectory", {"md": md, "inc": inc, "azi": azi}),
        ("hole", {"name": "'casing'", "md_bottom": bottom * rng.uniform(0.2, 0.8), "diameter": 224.5, "friction": 0.7 * friction}),
        ("hole", {"name": "'open'", "diameter": 215.9, "friction_axial": friction, "friction_rotary": 0.6 * rng.random(),
                  "wall_stiffness": 10.0 ** rng.uniform(3.5, 6.0)}),
        ("fluid", {"density": rng.uniform(0.0, 1800.0)})]
    if rng.random() < 0.3:
        groups[3][1]["mud_sheath"] = rng.uniform(0.5, 4.0)
    kind = rng.randrange(3)
    if kind == 0:
        groups.append(("component", {"od": 88.9, "id": 76.0, "mass": 14.0, "yield": 552.0}))
    else:
        groups.append(("component", {"name": "'collar'", "kind": "'collar'", "length": rng.uniform(8.0, 80.0), "od": 165.1,
                                     "id": 71.4}))
        if rng.random() < 0.3:
            groups.append(("component", {"name": "'blades'", "kind": "'stabilizer'", "length": 1.8, "od": 165.1, "id": 71.4,
                                         "joint_od": 212.0, "mass": 150.0}))
        if kind == 2:
            groups.append(("component", {"name": "'hwdp'", "length": rng.uniform(5.0, 100.0), "od": 127.0, "id": 76.2,
                                         "mass": 73.4, "joint_od": 165.1, "density": 7800.0, "yield": 379.0}))
        groups.append(("component", {"name": "'pipe'", "od": 127.0, "id": 108.6, "mass": 31.9, "joint_od": 161.9,
                                     "youngs": 210.0, "poisson": 0.29, "joint_spacing": 9.3, "makeup_torque": 30.0}))
    groups.append(("boundary", {"top_lateral": rng.choice(["'centred'", "'free'"]), "bit_lateral": rng.choice(["'centred'", "'free'"])}))
    for name in ("a", "b", "c"):
        operation = rng.choice(OPERATIONS)
        case = {"name": f"'{name}'", "operation": f"'{operation}'", "bit_depth": bottom * (1.0 if name == "a" else rng.uniform(0.5, 1.0))}
        if operation in ("rotary", "sliding", "static"):
            case |= {"wob": rng.uniform(-100.0, 100.0), "tob": rng.uniform(0.0, 5.0)}
            if kind == 0:
                case = case | {"wob": 0.05 * case["wob"], "tob": 0.05 * case["tob"]}
        if operation in ("ream", "backream"):
            case |= {"rpm": rng.uniform(10.0, 150.0), "trip_speed": rng.uniform(0.01, 1.0)}
        if rng.random() < 0.2:
            case |= {"friction": 0.4 * rng.random()}
        if rng.random() < 0.2:
            case |= {"measured_hookload": rng.uniform(50.0, 300.0)}
        groups.append(("load_case", case))
    solver = {"gap_location": rng.choice(["'extremum'", "'nodes'"]), "linear_solver": rng.choice(["'block'", "'banded'", "'sparse'"])}
    if rng.random() < 0.6:
        solver["element_length"] = 6.0 * 5.0 ** rng.random()
    if rng.random() < 0.2:
        solver["tool_joints"] = "'discrete'"
    groups.append(("solver", solver))
    return groups


def deck_text(groups, system):
    """The deck in a system of units; 17 digits, so that a number read is the number written."""
    lines = []
    for group, keys in groups:
        words = [f"units = '{system}'"] if group == "job" else []
        for key, value in keys.items():
            if isinstance(value, str):
                words.append(f"{key} = {value}")
                continue
            factor = SYSTEMS[system][UNIT.get(f"{group}.{key}", UNIT.get(key, ""))]
            numbers = value if isinstance(value, list) else [value]
            words.append(f"{key} = " + ", ".join(repr(number / factor) for number in numbers))
        lines.append(f"&{group} " + "\n   ".join(words) + " /")
    return "\n".join(lines) + "\n"


class Results:
    """What one run left."""

    def __init__(self, program, deck, home, name, threads):
        path, self.folder = home / f"{name}.nml", home / name
        path.write_text(deck, encoding="utf-8")
        done = subprocess.run([program, path, "--output", self.folder, "--threads", str(threads)], capture_output=True, text=True,
                              timeout=TIME_LIMIT, check=False)
        self.status, self.told = done.returncode, without_work(done.stderr).replace(f"/{name}", "")
        summary = self.folder / "summary.csv"
        self.rows = list(csv.DictReader(summary.open(encoding="utf-8"))) if summary.is_file() else []

    def files(self):
        """Every file's content but for times, by name."""
        found = {}
        for path in sorted(self.folder.rglob("*")):
            if path.name == "summary.csv":
                found[path.name] = [{k: v for k, v in row.items() if k != "seconds"} for row in self.rows]
            elif path.suffix == ".csv":
                found[path.name] = path.read_bytes()
        return found


def number(row, column):
    """A number of a row in SI, whatever the units of the file."""
    for ending, factor in (("kN", 1.0), ("klbf", FIELD["kN"]), ("kdaN", METRIC["kN"]), ("kNm", 1.0), ("kftlbf", FIELD["kN.m"])):
        if f"{column}_{ending}" in row:
            return float(row[f"{column}_{ending}"]) * factor
    raise KeyError(column)


def other_column(column, system):
    """Name of a column of an SI file in the file of another system, and the value in SI columns of one of its unit."""
    endings = ENDINGS[system] | ({"MPa": PRESSURES[system]} if (column in ("pressure_MPa", "inside_pressure_MPa") or column.startswith("casing_")) else {})
    for ending in sorted(endings, key=len, reverse=True):
        if column.endswith(f"_{ending}"):
            return column.removesuffix(ending) + endings[ending][0], endings[ending][1]
    return column, 1.0


def unlike_columns(one, other, system):
    """Faults of the CSV files of models on the axis: names of columns, and numbers by their units."""
    faults = []
    for path in sorted(one.glob("*.csv")):
        beam = path.name.startswith(("profile_", "contacts_", "history_")) and not path.stem.endswith(AXIS_MODELS)
        if beam:
            continue
        if not (other / path.name).is_file():
            faults.append(f"{path.name}: not in {system} units")
            continue
        mine, theirs = (list(csv.DictReader((folder / path.name).open(encoding="utf-8"))) for folder in (one, other))
        keep = [i for i, row in enumerate(mine) if row.get("model", AXIS_MODELS[0]) in AXIS_MODELS]
        for column in mine[0] if mine else ():
            name, factor = other_column(column, system)
            if name not in theirs[0]:
                faults.append(f"{path.name}: no column {name} in {system} units")
                continue
            with contextlib.suppress(ValueError):
                pairs = [(float(mine[i][column] or 0), float(theirs[i][name] or 0) * factor) for i in keep]
                largest = max((abs(a) for a, _ in pairs), default=0.0)
                off = max((abs(a - b) for a, b in pairs), default=0.0)
                if column not in LEFT_OUT and "_md_" not in column and off > SAME_COLUMN * max(largest, 1e-3):
                    faults.append(f"{path.name}: {name} is off by {off / max(largest, 1e-3):.1e} of its largest")
    return faults


class Check:
    def __init__(self):
        self.worst = {}

    def note(self, name, off, where):
        if off >= self.worst.get(name, (-1.0, "", 0))[0]:
            self.worst[name] = (off, where, self.worst.get(name, (0, 0, 0))[2])
        self.worst[name] = (*self.worst[name][:2], self.worst[name][2] + 1)

    def seed(self, program, seed):
        """Faults of a seed."""
        groups = draw_deck(seed)
        si = deck_text(groups, "SI")
        with tempfile.TemporaryDirectory() as folder:
            home = pathlib.Path(folder)
            one, two = (Results(program, si, home, name, threads) for name, threads in (("one", 1), ("two", 2)))
            if one.status not in (0, 3):
                return [f"exit status {one.status}: {one.told[:300]}"]
            faults = [f"{name} differs between one and two threads" for name, content in one.files().items()
                      if two.files().get(name) != content]
            if (one.status, one.told) != (two.status, two.told):
                faults.append("what is told differs between one and two threads")
            field, metric = (Results(program, deck_text(groups, system), home, system, 2) for system in ("field", "metric"))
            converted = subprocess.run([program, "--convert", home / "one.nml"], capture_output=True, text=True, check=False)
            if converted.returncode:
                return [*faults, f"not converted: {converted.stderr[:300]}"]
            for system, other in (("field", field), ("metric", metric)):
                faults += unlike_columns(one.folder, other.folder, system)
            for name, other in (("field units", field), ("metric units", metric), ("--convert", Results(program, converted.stdout, home, "converted", 2))):
                faults += self.compare(seed, name, one, other)
            self.note("decks", 0.0, seed)
            return faults

    def compare(self, seed, name, one, other):
        if other.status != one.status or len(other.rows) != len(one.rows):
            return [f"{name}: exit status {other.status}, {len(other.rows)} rows: {other.told[:300]}"]
        faults = []
        for a, b in zip(one.rows, other.rows):
            place = f"{name}, case {a['case']}, {a['model']} ({a['operation']})"
            if a["status"] != b["status"]:
                faults.append(f"{place}: {a['status']} in SI, {b['status']} here")
            if a["status"] != "converged" or b["status"] != "converged":
                self.note("marked", 0.0, seed)
                continue
            profile = list(csv.DictReader((one.folder / f"profile_{a['case']}_{a['model']}.csv").open(encoding="utf-8")))
            axial = [float(row["axial_kN"]) for row in profile]
            force = max(map(abs, axial + [number(a, "wob")]))
            torque = max(abs(number(a, "torque")), max(abs(float(row["torque_kNm"])) for row in profile))
            beside = a["model"] == "mcge" and (min(axial) < -1e-3 * force or any(a[k] != b[k] for k in GAPS))
            kind = "other models" if a["model"] != "mcge" else "beams, compressed or a gap more in contact" if beside else "beams"
            for column, scale in (("hookload", force), ("friction", force), ("normal_force", force), ("torque", torque)):
                off = abs(number(a, column) - number(b, column)) / max(scale, 1e-6)
                label = f"{name}, {kind}: {'torque' if column == 'torque' else 'forces'}"
                self.note(label, off, seed)
                if off > (TOLERANCE_BESIDE if beside else TOLERANCE):
                    faults.append(f"{place}: {column} off by {off:.1e}")
        return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=20, help="decks")
    parser.add_argument("--seed", type=int, default=1, help="of the first deck")
    parser.add_argument("--print", type=int, help="print the deck of this seed and end")
    options = parser.parse_args()
    if options.print is not None:
        print(deck_text(draw_deck(options.print), "SI"))
        return 0
    program = str(pathlib.Path(options.program).resolve())
    check, failed = Check(), 0
    for seed in range(options.seed, options.seed + options.count):
        faults = check.seed(program, seed)
        failed += bool(faults)
        for fault in faults:
            print(f"FAIL seed {seed}: {fault}", flush=True)
    for name, (off, seed, compared) in sorted(check.worst.items()):
        print(f"  {name:68s} worst {off:.1e} (seed {seed}), {compared} compared")
    print(f"{options.count - failed} passed, {failed} failed")
    return 1 if failed or not options.count else 0


if __name__ == "__main__":
    sys.exit(main())

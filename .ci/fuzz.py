#!/usr/bin/env python3
"""Fuzzes a built drillgap with decks, surveys, catalogues, legacy tables and records of unfinished work, made from the samples of input/.

Usage: fuzz.py PATH_TO_DRILLGAP [--count N] [--seed S] [--keep FOLDER] [--kind KIND] [--seconds S]

Case S is what seed S draws: `--seed S --count 1` runs it again. Its kind is one of

  deck       a sample deck, or a random one, changed in its structure: values to extremes, keys and groups moved, doubled, dropped
  limits     the same with legal values only, at and between their limits
  bytes      the same, or one of its files, changed in its bytes: flipped, cut, spliced, other line ends, marks, zeros
  text       texts of a deck that a shell, gnuplot, a terminal or a page would take for something else, with pictures
  survey     a survey in another form that means the same: it is read so, or refused, never otherwise; or any other change of it
  catalogue  the same of a catalogue
  legacy     the same of another program's table
  record     a sweep or an uncertainty goes on from a record that was changed: refused with its line, or the result of the whole
             run but for pieces whose line says something else
  twice      two decks, one after the other, in one output folder: what is left is what the second alone leaves
  collision  a file that the run reads stands where the run would write: refused, and it survives
  link       links out of the output folder under names of results, of folders and of files being written: refused, or not followed
  options    odd command lines
  convert    a deck that is accepted is converted, and converted it is accepted
  spelling   a deck in another spelling that says the same gives the same files
  file       an input is a pipe, a device, a folder or a link, or has an odd name: refused at once, or read
  mistake    one value that no deck may have gives one message

Of every run is asked: exit status 0 to 3 and right for what the files say, no signal, traceback or report of a sanitizer, nothing
touched outside the output folder (working folder, deck's folder, HOME, TMPDIR), inputs survive, no file under an unfinished name,
no control byte on the terminal, bounded time and memory; status 2 names file and line and leaves no folder; else every number is
finite, every row is there, forces balance, hook load + wob + friction is the weight of the string in mud, side forces sum up,
pictures and page are whole and hold nothing that runs. `--check` agrees with the run. Ends in 'N passed, N failed'.
"""
import argparse
import copy
import csv
import functools
import math
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import sys
import tempfile

import mutations
import random_decks
from hostile_decks import FIELD_DECK, LEGACY, SI_DECK, SURVEY
from mutations import KEYS, Deck, change_bytes, change_deck, change_table, legal_value, quoted
from run_results import Echo, faults_of_results, rows_of
from watched_run import Run, bound_memory_of

INPUT = mutations.ROOT / "input"
SAME = 1.0e-6          # of the largest force: a survey in other units, with ten digits or more
SAME_CONVERTED = 1.0e-5   # lengths that --convert has rounded may make an interval more
# A run may take `--seconds`, or this long for each solution that its deck asks for [s]: one that finds no equilibrium takes some seconds.
SECONDS_EACH = 5.0
# Other linear solvers than the default take this many times its time: 1300 iterations of 3600 elements 57 s by 'sparse', 17 s by 'block'.
OTHER_SOLVER = 3.5
# Nothing is waited for longer: times `--seconds`, of processor time and, on a busy machine, of wall time.
PATIENCE, WALL = 3, 15
FORCE_UNITS = (("kN", 1.0), ("klbf", 4.4482216152605), ("kdaN", 10.0))      # endings of columns, and their unit [kN]
MEASURED = ("seconds", "memory_MB", "cost", "pareto")      # differ from run to run
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]")


@functools.cache
def samples():
    """(name, deck, files) of every sample and of the two small wells with everything in them."""
    found = [("si", Deck.parse(SI_DECK), {"wells/path.csv": SURVEY, "wells/other.csv": LEGACY}), ("field", Deck.parse(FIELD_DECK), {})]
    catalogue = (INPUT / "catalogue.csv").read_text(encoding="utf-8")
    for path in sorted(INPUT.glob("*.nml")):
        deck = Deck.parse(path.read_text(encoding="utf-8").encode().decode("latin-1"))
        files = {}
        for name in re.findall(r"'(\w+\.csv)'", deck.text()):
            files[name] = (INPUT / name).read_text(encoding="utf-8")
        used = [v.strip("'") for g in deck.all("component") for v in deck.get(g, "catalogue")]
        if used:
            rows = catalogue.splitlines(keepends=True)
            head = next(i for i, row in enumerate(rows) if row.startswith("name,"))
            keep = [r for r in rows[head + 1:] if any(u.startswith(r.split(",")[0]) for u in used) or ",grade," in r]
            others = [r for r in rows[head + 1:head + 9] if r not in keep]
            files["catalogue.csv"] = "".join(rows[:head + 1] + keep + others)
        found.append((path.stem, deck, files))
    return found


def drawn(rng, *names):
    """A sample with little to solve: few cases, models, depths and samples; pictures and HDF5 seldom."""
    name, deck, files = rng.choice([s for s in samples() if not names or s[0] in names])
    deck, files = deck.copy(), dict(files)
    if not names and rng.random() < 0.15:
        deck, files = Deck.parse(random_decks.deck_text(random_decks.draw_deck(rng.randrange(10**6)),
                                                         "field" if rng.random() < 0.5 else "SI")), {}
    job = deck.one("job")
    deck.set(job, "plots", ".true." if rng.random() < 0.04 else ".false.")
    deck.set(job, "hdf5", ".true." if rng.random() < 0.15 else ".false.")
    if rng.random() < 0.8:
        deck.set(job, "profiles", ".true.")
    models = deck.get(job, "models")
    if len(models) > 2:
        deck.set(job, "models", *rng.sample(models, 2))
    cases = deck.all("load_case")
    named = {v for n in ("study", "calibrate", "legacy") for g in deck.all(n) for k in ("cases", "case") for v in deck.get(g, k)}
    for case in cases[:]:
        if len(cases) > 3 and deck.get(case, "name")[0] not in named and rng.random() < 0.8:
            cases.remove(case)
            deck.groups.remove(case)
    for group in deck.all("calibrate"):
        if len(deck.all("calibrate")) > 1 and rng.random() < 0.6:
            deck.groups.remove(group)
    for group in deck.all("sweep") + deck.all("uncertainty"):
        deck.set(group, "bit_depth_step", "1000" if name != "sweep_johancsik_well_3" else "4000")
        deck.set(group, "bit_depth_from", "300")
        for key in ("frictions", "operations", "model"):
            values = deck.get(group, key)
            if len(values) > 2:
                two = rng.sample(range(len(values)), 2)
                deck.set(group, key, *(values[i] for i in two))
                for load, each in ((k, deck.get(group, k)) for k in ("wob", "tob", "rpm", "trip_speed") if key == "operations"):
                    if len(each) == len(values):
                        deck.set(group, load, *(each[i] for i in two))
    for group in deck.all("uncertainty"):
        deck.set(group, "samples", str(rng.randrange(2, 9)))
    for group in deck.all("study"):
        deck.set(group, "element_lengths", "16.0", "8.0")
        deck.set(group, "fidelities", "'fast'")
        if rng.random() < 0.7:
            deck.set(group, "models", rng.choice(["'mcge'", "'soft'"]))
    return deck.tame(), files


class Lab:
    """Runs of one case, each in a folder of its own, and the faults found."""

    def __init__(self, program, home, seconds):
        self.program, self.home, self.seconds = program, pathlib.Path(home), seconds
        self.faults, self.runs, self.long = [], [], 0

    def start(self, home, files, arguments, before=None):
        """A run in a folder, with the deck in `deck/`, not yet judged."""
        bound = math.ceil(self.bound(files) * PATIENCE)
        return Run(self.program, files, arguments, home=home, cwd="cwd", seconds=self.bound(files) * WALL, deck="deck/deck.nml", before=before,
                   shell_limits=lambda: resource.setrlimit(resource.RLIMIT_CPU, (bound, bound + 5)))

    def bound(self, files):
        """Processor time that a run may take [s]."""
        slower = any(isinstance(text, str) and re.search(r"(?i)linear_solver\s*=\s*'(sparse|banded)", text) for text in files.values())
        return self.seconds * (OTHER_SOLVER if slower else 1.0)

    def note(self, what):
        if len(self.faults) < 8:
            self.faults.append(what)

    def run(self, files, more=(), again=None, before=None, echo=True, expect=None, fault_of_1=True, order=True):
        """One run, judged; `files` lie beside the deck. `again`: in the folder of that run. `expect`: an exit status, or several."""
        home = again.home if again else self.home / str(len(self.runs) + 1)
        home.mkdir(parents=True, exist_ok=True)
        options = ["--threads", "1", *more]
        run = self.start(home, {f"deck/{name}": text for name, text in files.items()}, ["../deck/deck.nml", "--output", "../out", *options], before)
        self.runs.append(run)
        faults = run.faults()
        if run.seconds > self.bound(files):
            told = self.check(run)
            allowed = SECONDS_EACH * Echo(told.stdout).work if told.status == 0 else 0.0
            if run.seconds < allowed and run.killed in (0, signal.SIGXCPU):
                faults, self.long = [f for f in faults if "signal" not in f], self.long + 1
            else:
                faults.append(f"{run.seconds:.0f} s of processor time")
            if run.killed:
                run.status = None                                 # there is nothing to judge
        if run.status == 1 and fault_of_1:
            faults.append("exit status 1: " + run.stderr[:300])
        if CONTROL.search(run.stdout) or CONTROL.search(run.stderr):
            stream = "standard output" if CONTROL.search(run.stdout) else "standard error"
            text = run.stdout if CONTROL.search(run.stdout) else run.stderr
            at = CONTROL.search(text).start()
            faults.append(f"control bytes on {stream}: {text[max(0, at - 60):at + 20]!r}")
        if list(home.rglob("*" + mutations.CANARY + "*")):
            faults.append("a text of the deck was executed")
        if "gnuplot" in run.stderr and "note:" not in run.stderr:
            faults.append("gnuplot: " + run.stderr[:300])
        if run.status in (0, 3) and "--part" not in more:
            told = self.check(run) if echo else None
            if told and told.status:
                faults.append(f"--check has exit status {told.status} and the run {run.status}: {told.stderr[:200]}")
            try:
                faults += faults_of_results(run.out, run.status, files["deck.nml"], told.stdout if told and not told.status else None, order)
            except (KeyError, ValueError, IndexError) as error:
                faults.append(f"results cannot be judged: {type(error).__name__} {error}")
        if expect is not None and run.status is not None and run.status not in (expect if isinstance(expect, tuple) else (expect,)):
            faults.append(f"exit status {run.status}, expected {expect}: {run.stderr[:300]}")
        for fault in faults:
            self.note(fault)
        return run

    def act(self, run, *words):
        """Another action of the program on what lies in the folder of a run."""
        action = self.start(run.home, {}, words)
        self.runs.append(action)
        for fault in action.faults() + ([f"exit status 1: {action.stderr[:200]}"] if action.status == 1 else []):
            self.note(f"{words[0]}: {fault}")
        return action

    def check(self, run):
        return self.start(run.home, {}, ["../deck/deck.nml", "--output", "../out", "--check"])


def summary(run, name="summary.csv"):
    path = run.out / name
    return rows_of(path, []) if path.is_file() else []


def differences(one, other, columns):
    """Where two tables differ in columns of numbers, by more than SAME of the largest; the first of these."""
    if len(one) != len(other):
        return f"{len(one)} rows and {len(other)}"
    for ours, theirs in zip(one, other):
        names = [k for k in ours if k.startswith(columns)]
        scale = max([abs(float(theirs[k])) for k in names if theirs.get(k)] or [0.0])
        for k in names:
            if (ours[k] == "") != (theirs.get(k, "") == "") or ours[k] and abs(float(ours[k]) - float(theirs[k])) > SAME * scale + 1e-9:
                return f"{k} {ours[k]!r}, should be {theirs.get(k)!r} ({ours.get('case', '')})"
    return ""


FORCES = ("hookload_k", "friction_k", "torque_k", "normal_force_k", "bit_depth", "inclination")


def never_misread(lab, rng, base_files, files, may_refuse, columns=FORCES, table="summary.csv", what=""):
    """A changed data file of the same meaning: the same result as the plain one, or refused where that is allowed."""
    base = lab.run(base_files, expect=0)
    run = lab.run(files, expect=(0, 2) if may_refuse else 0)
    if base.status == run.status == 0:
        different = differences(summary(run, table), summary(base, table), columns)
        if different:
            lab.note(f"misread ({what}): {different}")
    return run


def spelt(deck, rng):
    """The text of a deck in another spelling that says the same."""
    order = list({name: None for name, _ in deck.groups})
    rng.shuffle(order)
    groups = sorted(deck.groups, key=lambda g: order.index(g[0])) if rng.random() < 0.7 else deck.groups
    number = re.compile(r"[-+]?\d+\.?\d*")

    def word(text):
        case = rng.randrange(3)
        return text.upper() if case == 0 else text.title() if case == 1 else text

    def value(text):
        if text[0] == "'" and '"' not in text and rng.random() < 0.4:
            return '"' + text[1:-1].replace("''", "'") + '"'
        if number.fullmatch(text) and "." in text and rng.random() < 0.4:
            return rng.choice([text + "0", text + "e0", text + "D+00", "+" + text if text[0].isdigit() else text])
        return word(text) if text.startswith(".") else text

    text = rng.choice(["", "", "! it's a comment with & and / in it\n", "\n\n"])
    for name, entries in groups:
        text += "&" + word(name) + rng.choice([" ", "\n  ", "\t", " ! it's / so\n"])
        for key, values in entries:
            many = len(values) > 1 and len(set(values)) == 1 and values[0][0] != "'" and "*" not in values[0] and rng.random() < 0.7
            written = [f"{len(values)}*{values[0]}"] if many else [value(v) for v in values]
            subscript = f"(1:{len(values)})" if len(values) > 1 and not any("*" in v for v in values) and rng.random() < 0.15 else ""
            separator = rng.choice([", ", " ", ",\n    ", " ,\t", ", ! one\n"])
            text += word(key) + subscript + rng.choice(["=", " = ", " =\n   "]) + separator.join(written) + rng.choice([" ", ", ", "\n  ", " ! 'x\n"])
        text += rng.choice(["/\n", "\n/\n\n", "/ ! end\n"])
    if rng.random() < 0.2:
        text = text.replace("\n", "\r\n")
    return ("\xef\xbb\xbf" if rng.random() < 0.15 else "") + text


# ---- kinds of cases

def case_spelling(lab, rng):
    deck, files = drawn(rng)
    deck.set(deck.one("job"), "plots", ".false.")
    base = lab.run(files | {"deck.nml": deck.text()}, expect=(0, 3))
    run = lab.run(files | {"deck.nml": spelt(deck, rng)}, expect=base.status)
    for path in sorted(base.out.glob("*.csv")):
        ours, theirs = ([{k: v for k, v in row.items() if k not in MEASURED} for row in summary(r, path.name)] for r in (run, base))
        if ours != theirs:
            lab.note(f"another spelling, another {path.name}")
            break


def case_deck(lab, rng):
    deck, files = drawn(rng)
    gentle = rng.random() < 0.5
    for _ in range(rng.choice([2, 3, 5]) if gentle else rng.choice([1, 1, 1, 2, 2, 3])):
        change_deck(deck, rng, gentle)
    lab.run(files | {"deck.nml": deck.tame().text()})


def case_limits(lab, rng):
    """Legal values only, at and between the limits that the deck's documentation gives: nothing is refused for one value alone."""
    deck, files = drawn(rng)
    if rng.random() < 0.5:
        deck.set(deck.one("job"), "models", "'mcge'")
    for _ in range(rng.choice([1, 2, 3, 5])):
        name = rng.choice(["solver", "solver", "hole", "component", "load_case", "fluid", "boundary", "job", "sweep", "uncertainty", "study", "calibrate"])
        if name in ("solver", "boundary", "fluid"):
            deck.one(name)
        if deck.all(name):
            numbers = [k for k, (_, legal, _) in KEYS[name].items() if " to " in legal or "> 0" in legal or "`" in legal]
            key = rng.choice([k for k in numbers if k not in ("threads", "plots", "hdf5", "units")])
            deck.set(rng.choice(deck.all(name)), key, legal_value(name, key, rng, inside=True))
    lab.run(files | {"deck.nml": deck.tame().text()})


def case_bytes(lab, rng):
    deck, files = drawn(rng)
    files["deck.nml"] = deck.text()
    other = drawn(rng)[0].text()
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        name = rng.choice(sorted(files)) if rng.random() < 0.4 else "deck.nml"
        files[name] = change_bytes(files[name], rng, other if name == "deck.nml" else rng.choice(list(files.values())))
    run = lab.run(files)
    if rng.random() < 0.2:
        lab.act(run, "--convert", "../deck/deck.nml")


def case_text(lab, rng):
    names = ("si", "stuck_gp1", "johancsik_well_3", "sweep_gp1", "uncertainty_gp1", "study_gp1", "field")
    deck, files = drawn(rng, *(("calibrate_gp1",) if rng.random() < 0.3 else names))
    if rng.random() < 0.5:
        deck.set(deck.one("job"), "plots", ".true.")
        deck.set(deck.one("job"), "profiles", rng.choice([".true.", ".false."]))
    if rng.random() < 0.7:
        for group in [deck.one("job")] + deck.all("calibrate"):
            deck.set(group, "models" if group[0] == "job" else "model", "'soft'")
    for _ in range(rng.choice([1, 1, 2, 4])):
        name, key = rng.choice([k for k in mutations.TEXT_KEYS[:11] + [("calibrate", "name")] * 4 if deck.all(k[0])])
        text = rng.choice(mutations.NAMES if (name, key) in mutations.NAME_KEYS and rng.random() < 0.6 else mutations.TEXTS)
        if rng.random() < 0.25:
            text = rng.choice([t for t in mutations.TEXTS if mutations.CANARY in t])
        group = rng.choice(deck.all(name))
        old = deck.get(group, key)
        deck.set(group, key, quoted(text))
        if (name, key) == ("load_case", "name"):                  # whoever speaks of it still finds it
            for other in ("calibrate", "study", "legacy"):
                for speaker in deck.all(other):
                    for k, values in speaker[1]:
                        if k in ("case", "cases"):
                            values[:] = [quoted(text) if v in old else v for v in values]
    lab.run(files | {"deck.nml": deck.tame().text()})


LENGTHS = {"m": 1.0, "ft": 0.3048, "usft": 1200.0 / 3937.0}
ODD_LENGTHS = {"km": 1000.0, "kft": 304.8, "cm": 0.01, "mm": 0.001, "in": 0.0254, "yd": 0.9144, "ftKB": 0.3048, "ft RKB": 0.3048,
               "m RKB": 1.0, "mMD": 1.0, "0.1in": 0.00254, "'": 0.3048, "feet": 0.3048, "metres": 1.0, "fathom": 1.8288, "mi": 1609.344,
               "dm": 0.1, "ftUS": 1200.0 / 3937.0, "foot": 0.3048, "inch": 0.0254, "FT MSL": 0.3048, "yards": 0.9144, "ftRT": 0.3048,
               "ft(US)": 1200.0 / 3937.0}
ANGLES = {"deg": 1.0, "rad": 180.0 / math.pi}
ODD_ANGLES = {"gon": 0.9, "grad": 0.9, "mrad": 0.18 / math.pi, "mil": 0.05625, "rev": 360.0, "min": 1.0 / 60.0, "degrees": 1.0, "\xc2\xb0": 1.0,
              "\xb0": 1.0, "dega": 1.0, "radian": 180.0 / math.pi, "g": 0.9, "turns": 360.0, "cdeg": 0.01, "deg/10": 10.0, "arcsec": 1.0 / 3600.0,
              "rads": 180.0 / math.pi, "radz": 180.0 / math.pi, "centesimal": 0.9, "hr": 15.0}
COMMENTED = "a row behind #"
NULLS = ["-999.25", "-9999", "-999", "1e30", "NaN", "", "-", "n/a", "***", "9999999"]


def stations_of(deck, files):
    """md, inc, azi of a deck in its units."""
    trajectory = deck.one("trajectory")
    if deck.get(trajectory, "survey_file"):
        rows = csv.reader(line for line in files[deck.get(trajectory, "survey_file")[0].strip("'")].splitlines() if line[0] in "0123456789")
        return [tuple(map(float, row[:3])) for row in rows]
    return list(zip(*(deck.numbers("trajectory", k) for k in ("md", "inc", "azi"))))


def survey_text(stations, unit, rng):
    """A survey file of these stations and whether it may be refused; `unit`: m or ft, of the depths given."""
    odd = rng.random() < 0.5
    may_refuse, what = False, []
    lengths = dict(LENGTHS, **(ODD_LENGTHS if odd and rng.random() < 0.6 else {}))
    angles = dict(ANGLES, **(ODD_ANGLES if odd and rng.random() < 0.4 else {}))
    names = {"md": rng.choice(list(lengths)), "inc": "deg", "azi": "deg"}
    for column in ("inc", "azi"):
        names[column] = rng.choice(list(angles) + ["deg"] * 3)
    if names["md"] in ODD_LENGTHS or names["inc"] in ODD_ANGLES or names["azi"] in ODD_ANGLES:
        may_refuse = True
    factor = {"md": LENGTHS[unit] / lengths[names["md"]], "inc": 1.0 / angles[names["inc"]], "azi": 1.0 / angles[names["azi"]]}
    values = [{k: v * factor[k] for k, v in zip(("md", "inc", "azi"), station)} for station in stations]
    cells = [{k: f"{v:.12g}" for k, v in row.items()} for row in values]
    order = rng.sample(["md", "inc", "azi"], 3)
    if rng.random() < 0.3:
        order.insert(rng.randrange(4), "tvd")
        for row in cells:
            row["tvd"] = rng.choice(["0", "1.5", "-3"])
    if odd and rng.random() < 0.35:                               # a row without a value, beside the stations
        may_refuse = True
        null = rng.choice(NULLS)
        i = rng.randrange(1, len(cells))
        row = {k: f"{(float(cells[i - 1][k]) + float(cells[i][k])) / 2:.12g}" for k in cells[0]}
        row[rng.choice(["md", "inc", "azi"])] = null
        cells.insert(i, row)
        what.append(f"null {null!r}")
    what += [f"{k} in {names[k]}" for k in ("md", "inc", "azi")]
    if rng.random() < 0.3:
        text, hard = las_text(cells, order, names, rng)
        return text, may_refuse or hard, ", ".join(["LAS", *what])
    comma = rng.random() < 0.2                                    # decimal comma
    separator = rng.choice([";", "\t"] if comma else [",", ";", "\t", "  "])
    if separator == "  " and any("" == v for row in cells for v in row.values()):
        separator = ","
    if comma:
        cells = [{k: v.replace(".", ",") for k, v in row.items()} for row in cells]
    if odd and separator in ";\t" and rng.random() < 0.3:           # marks between thousands
        may_refuse = True
        mark = rng.choice([".", " ", "'"] if comma else [",", " ", "'"])
        for row in cells:
            row["md"] = re.sub(r"^(\d+)(\d{3})(?!\d)", rf"\1{mark}\2", row["md"])
        what.append(f"thousands {mark!r}")
    heading = {"md": rng.choice(["md", "MD", "Measured Depth", "Md"]), "inc": rng.choice(["inc", "Incl", "INC", "Inclination"]),
               "azi": rng.choice(["azi", "Azimuth", "AZI", "Azim"]), "tvd": "tvd"}
    place = rng.choice(["brackets", "square", "underscore", "row"] + (["above"] if odd else []))
    if " " in "".join(names.values()) and separator == "  ":
        place = "brackets"
    lines = []
    if place == "brackets":
        heading = {k: v + (f" ({names[k]})" if k in names else "") for k, v in heading.items()}
    elif place == "square":
        heading = {k: v + (f"[{names[k]}]" if k in names else "") for k, v in heading.items()}
    elif place == "underscore":
        heading = {k: v + (f"_{names[k]}" if k in names else "") for k, v in heading.items()}
    if separator == "  ":
        heading = {k: v.replace(" ", "") for k, v in heading.items()}
    quote = (lambda text: f'"{text}"') if rng.random() < 0.15 and separator != "  " else (lambda text: text)
    lines.append(separator.join(quote(heading[k]) for k in order))
    if place in ("row", "above"):
        units = separator.join(names.get(k, "m") for k in order)
        lines.insert(1 if place == "row" else 0, units)
        may_refuse = may_refuse or place == "above" or " " in units and separator == "  "
    what.append(f"units in {place}, separator {separator!r}" + (", decimal comma" if comma else ""))
    if rng.random() < 0.2:
        lines.insert(0, rng.choice(["# well A", "Well: A-1", "Survey report 12", ""]))
    rows = [separator.join(quote(row[k]) for k in order) for row in cells]
    if len(rows) > 3 and rng.random() < 0.15:
        rows.insert(rng.randrange(1, len(rows)), "#" + rng.choice(["", " "]) + rng.choice(rows))
        what.append(COMMENTED)
    lines += rows
    if rng.random() < 0.2:
        lines.append("")
    text = "\n".join(lines) + rng.choice(["\n", "\n", "\n", ""])
    if rng.random() < 0.15:
        text = text.replace("\n", "\r\n")
    if rng.random() < 0.1:
        text = "\xef\xbb\xbf" + text
    return text, may_refuse, ", ".join(what)


def las_text(cells, order, names, rng):
    """A LAS file, and whether it may be refused."""
    mnemonic = {"md": rng.choice(["DEPT", "MD"]), "inc": rng.choice(["INCL", "DEVI", "INC"]), "azi": rng.choice(["AZIM", "HAZI"]), "tvd": "TVD"}
    if order[0] != "md":
        order = ["md"] + [k for k in order if k != "md"]
    may_refuse = any(" " in n or "." in n for n in names.values())
    lines = ["~Version Information", f" VERS.   {rng.choice(['1.2', '2.0'])} : CWLS", " WRAP.   NO : one line a depth", "~Well Information",
             f" STRT.{names['md']}  {cells[0]['md']} : start", f" STOP.{names['md']} {cells[-1]['md']} : stop", " STEP.  0 : step",
             " NULL.  -999.25 : null", "~Curve Information"]
    lines += [f" {mnemonic[k]}.{names.get(k, 'm')}   : curve" for k in order]
    lines += ["~Parameter", " X.  1 : nothing"] if rng.random() < 0.3 else []
    lines += ["~A  " + "  ".join(mnemonic[k] for k in order)] + ["  ".join(row[k] or "-999.25" for k in order) for row in cells]
    if rng.random() < 0.2:
        del lines[rng.randrange(3, 9)]
        may_refuse = True
    return "\n".join(lines) + "\n", may_refuse


def case_survey(lab, rng):
    deck, files = drawn(rng, "si", "gp1", "casing_run", "short_radius_lateral", "sucker_rods", "johancsik_well_3", "tubing_string", "operations")
    stations = stations_of(deck, files)
    unit = "ft" if deck.get(deck.one("job"), "units") == ["'field'"] else "m"
    same = rng.random() < 0.6
    text, may_refuse, what = survey_text(stations, unit, rng)
    trajectory = deck.one("trajectory")
    for key in ("md", "inc", "azi"):
        deck.drop("trajectory", key)
    deck.set(trajectory, "survey_file", quoted("survey.txt"))
    deck.set(deck.one("job"), "models", "'soft'" if same or rng.random() < 0.5 else "'mcge'")
    for group in deck.all("legacy"):
        deck.groups.remove(group)
    files["deck.nml"] = deck.text()
    if same:
        plain = "\n".join(["md,inc,azi"] + [",".join(f"{v:.12g}" for v in s) for s in stations]) + "\n"
        run = never_misread(lab, rng, files | {"survey.txt": plain}, files | {"survey.txt": text}, may_refuse, what=what)
        if run.status == 0 and COMMENTED in what and "1 that begin with #" not in " ".join((run.stdout + run.stderr).split()):
            lab.note(f"a row of the survey is skipped without a word ({what})")
        return
    for _ in range(rng.choice([1, 1, 2, 3])):
        text = change_table(text, rng, files.get("gp1_survey.csv", SURVEY))
    lab.run(files | {"survey.txt": text})


def case_catalogue(lab, rng):
    deck, files = drawn(rng, "sucker_rods", "casing_run", "bha_analysis", "extended_reach_10km", "tubing_string")
    deck.set(deck.one("job"), "models", "'soft'")
    files["deck.nml"] = deck.text()
    text = files["catalogue.csv"]
    kind = rng.randrange(6)
    changed, may_refuse, what = text, False, ""
    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    if kind == 0:                                                  # rows in another order
        body = rows[1:]
        rng.shuffle(body)
        rows, what = rows[:1] + body, "order of rows"
    elif kind == 1:                                                # columns in another order
        order = rng.sample(range(len(rows[0])), len(rows[0]))
        rows, what = [[row[i] for i in order] for row in rows], "order of columns"
    elif kind == 2:                                                # another unit
        column, (new, factor) = rng.choice([("od_in", ("od_mm", 25.4)), ("id_in", ("id_mm", 25.4)), ("mass_lbm_ft", ("mass_kg_m", 0.45359237 / 0.3048)),
                                            ("od_in", ("od_cm", 2.54)), ("od_in", ("od_m", 0.0254)), ("mass_lbm_ft", ("mass_g_m", 453.59237 / 0.3048)),
                                            ("yield_ksi", ("yield_GPa", 6.894757293168361e-3)), ("od_in", ("od_ft", 1.0 / 12.0))])
        i = rows[0].index(column)
        rows[0][i], what = new, new
        for row in rows[1:]:
            row[i] = f"{float(row[i]) * factor:.14g}" if row[i] else ""
        may_refuse = True
    elif kind == 3:                                                # a row twice, with other numbers
        used = {v.strip("'") for g in deck.all("component") for v in deck.get(g, "catalogue")}
        row = rng.choice([r for r in rows[1:] if any(u.startswith(r[0]) for u in used)])
        twin = [row[0], row[1], "7.5", *row[3:]]
        rows.insert(rng.randrange(1, len(rows) + 1), twin)
    if kind <= 3:
        changed = "\n".join(",".join(row) for row in rows) + "\n"
    if kind <= 2:
        never_misread(lab, rng, files, files | {"catalogue.csv": changed}, may_refuse, what="catalogue, " + what)
    elif kind == 3:
        lab.run(files | {"catalogue.csv": changed}, expect=2)
    else:
        for _ in range(rng.choice([1, 1, 2, 3])):
            changed = change_table(changed, rng, text)
        run = lab.run(files | {"catalogue.csv": changed})
        (run.home / "cwd" / "input").mkdir()
        shutil.copy(run.home / "deck" / "catalogue.csv", run.home / "cwd" / "input")
        lab.act(run, "--list-catalogue", *rng.choice([[], ["DP"], ["9-5/8"], ["\xe9"]]))


def case_legacy(lab, rng):
    deck, files = drawn(rng, "johancsik_well_3")
    deck.set(deck.one("job"), "models", "'soft'")
    group = rng.choice(deck.all("legacy"))
    for other in deck.all("legacy"):
        if other is not group:
            deck.groups.remove(other)
    label = deck.get(group, "label")[0].strip("'")
    name = "johancsik_well_3_legacy.csv"
    plain = [line for line in files[name].splitlines() if not line.startswith("#")]
    rows = [line.split(",") for line in plain]
    rows = rows[:1] + rows[1::rng.choice([1, 3, 7])]
    files[name] = "\n".join(",".join(row) for row in rows) + "\n"
    files["deck.nml"] = deck.text()
    if rng.random() < 0.5:
        md, (force, factor), torque = rng.choice([("m", 0.3048), ("ft", 1.0), ("km", 0.0003048), ("kft", 0.001)]), \
            rng.choice([("kN", 4.4482216152605), ("N", 4448.2216152605), ("lbf", 1000.0), ("kip", 1.0), ("t", 0.45359237), ("daN", 444.82216152605),
                        ("MN", 4.4482216152605e-3), ("tonf", 0.45359237), ("kgf", 453.59237)]), \
            rng.choice([("kN.m", 1.3558179483314), ("ft.lbf", 1000.0), ("N.m", 1355.8179483314), ("kgf.m", 138.25495), ("in.lbf", 12000.0)])
        head = [f"md ({md[0]})", f"up ({force})", f"down ({force})", f"rotating ({torque[0]})"]
        factors = [md[1], factor, factor, torque[1]]
        new = [[f"{float(v) * f:.13g}" for v, f in zip(row, factors)] for row in rows[1:]]
        separator = rng.choice([",", ";", "\t"])
        order = rng.sample(range(4), 4)
        text = "\n".join(separator.join(row[i] for i in order) for row in [head, *new]) + "\n"
        may_refuse = True
        never_misread(lab, rng, files, files | {name: text}, may_refuse, ("md_", "legacy_", "axial_k"), f"legacy_{label}.csv",
                      f"legacy, {head}, separator {separator!r}")
        return
    text = files[name]
    if rng.random() < 0.3:
        change_deck_group = ["legacy", group[1]]
        key = rng.choice(["md", "axial", "torque", "skip", "side_force", "units", "md_unit", "axial_unit", "torque_unit"])
        deck.set(change_deck_group, key, rng.choice(["'1'", "'2'", "'1:10'", "'11:4'", "'0'", "'99'", "'-1'", "3", "1000000", "'ft'", "'m'", "'kN'", "'x'", "''",
                                                     "'1:9999999'", "'field'", "'up'", "'N.m'"]))
        files["deck.nml"] = deck.text()
    for _ in range(rng.choice([0, 1, 1, 2, 3])):
        text = change_table(text, rng, SURVEY)
    lab.run(files | {name: text})


# A fault of one line is named with it; others are of the whole record.
NAMED = r"(:|line )\d+: |line \d+ is |another deck|lacks|no record|holds part|is of \d+ points|head|missing|is there already|cannot be read"
PIECE = re.compile(r"^(\d+) (converged|not_converged|locked_up)(.{25})(.{25})( .*)? ;$")


def finite(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def change_record(lines, rng):
    """One change of a record: its lines, and whether it must be refused (None: as the lines say)."""
    first = next((i for i, line in enumerate(lines) if PIECE.match(line)), 0)
    if first == 0:
        return lines                                               # no piece is left
    i = rng.randrange(first, len(lines))
    kind = rng.randrange(12)
    piece = PIECE.match(lines[i])
    if kind <= 3 and piece:                                        # a number
        field = rng.choice([3, 4])
        bad = rng.choice(["NaN", "Infinity", "-Inf", "", "*" * 25, "1.0E+400", "1.0E+308", "-1.7976931348623157E+308", "1,5", "1.0", "abc", "0x1p3",
                          "1.5000000000000000E+005"])
        return lines[:i] + [lines[i][:piece.start(field)] + f"{bad:>25}" + lines[i][piece.end(field):]] + lines[i + 1:]
    if kind == 4:
        return lines[:i] + [lines[i].replace("converged", rng.choice(["not_converged", "locked_up", "Converged", "solved", ""]), 1)] + lines[i + 1:]
    if kind == 5:
        return lines[:i] + lines[i + 1:]                           # a piece lacks: it is solved
    if kind == 6:
        return lines[:i] + [lines[i]] + lines[i:]                  # a piece twice, alike
    if kind == 7:                                                  # another number of the piece
        return lines[:i] + [re.sub(r"^\d+", rng.choice(["0", "1", "2", "99999", "-1", "1.5", "", "007"]), lines[i])] + lines[i + 1:]
    if kind == 8:
        j = rng.randrange(first)                                   # the head, a setting
        return lines[:j] + [change_bytes(lines[j], rng).replace("\n", "")] + lines[j + 1:]
    if kind == 9:
        return lines[:i] + [lines[i][:rng.randrange(len(lines[i]))]] + lines[i + 1:]
    if kind == 10:
        return change_bytes("\n".join(lines), rng, "\n".join(lines)).split("\n")
    body = lines[first:]
    rng.shuffle(body)
    return lines[:first] + body


def record_deck(rng):
    """A deck with one sweep or one uncertainty of few points, its file and its number columns."""
    uncertain = rng.random() < 0.4
    deck, files = drawn(rng, "uncertainty_gp1" if uncertain else rng.choice(["sweep_gp1", "sweep_johancsik_well_3"]))
    for name in ("sweep", "uncertainty"):
        for group in deck.all(name)[1:]:
            deck.groups.remove(group)
    group = (deck.all("sweep") + deck.all("uncertainty"))[0]
    deck.set(group, "name", "'s'")
    deck.set(group, "model", "'soft'" if rng.random() < 0.7 else "'mcge'")
    deck.set(deck.one("job"), "models", "'soft'")
    deck.set(deck.one("job"), "plots", ".false.")
    for case in deck.all("load_case"):
        deck.groups.remove(case)
    return deck, files, "uncertainty" if uncertain else "sweep"


def case_record(lab, rng):
    deck, files, what = record_deck(rng)
    files["deck.nml"] = deck.text()
    whole = lab.run(files, expect=(0, 3))
    parts = 1 if rng.random() < 0.6 else 2
    made = lab.run(files, ["--part", f"1/{parts}"], expect=(0, 3))
    if parts == 2:
        lab.run(files, ["--part", "2/2"], again=made, expect=(0, 3))
    record = made.out / f"{what}_s.part_1_of_{parts}"
    if not record.is_file() or whole.status not in (0, 3):
        lab.note(f"no {record.name}")
        return
    lines = record.read_text(encoding="latin-1").split("\n")[:-1]
    sound = {int(p.group(1)): p for p in map(PIECE.match, lines) if p}
    for _ in range(rng.choice([1, 1, 1, 2])):
        lines = change_record(lines, rng)
    cut = rng.random() < 0.3 and parts == 1                        # as an interrupted run leaves it
    if cut:
        lines = lines[:rng.randrange(max(1, len(lines) - 8), len(lines) + 1)]
    text = "\n".join(lines) + ("\n" if rng.random() < 0.8 else "")
    if parts == 1:
        record = record.rename(made.out / f"{what}_s.partial")
    record.write_bytes(text.encode("latin-1", "replace"))
    run = lab.run(files, ["--merge", "2"] if parts == 2 else [], again=made, expect=(0, 2, 3), order=False)
    if run.status == 2:
        if record.name not in run.stderr or not re.search(NAMED, run.stderr):
            lab.note(f"refused without file and line of the record: {run.stderr[:250]}")
        if record.read_bytes() != text.encode("latin-1", "replace"):
            lab.note("refused, yet the record was changed")
        return
    if run.status not in (0, 3):
        return
    ours, theirs = summary(run, f"{what}_s.csv"), summary(whole, f"{what}_s.csv")
    if len(ours) != len(theirs):
        lab.note(f"{len(ours)} rows, undisturbed {len(theirs)}")
        return
    said = {int(p.group(1)): p for p in map(PIECE.match, text.replace("\r\n", "\n").split("\n")) if p}
    altered = {n for n, p in said.items() if n in sound and p.group() != sound[n].group()}
    for n in altered:
        if said[n].group(2) == "converged" and not (finite(said[n].group(3)) and finite(said[n].group(4))):
            lab.note(f"accepted a record with {said[n].group()[:70]!r}")
    for n, (a, b) in enumerate(zip(ours, theirs), 1):
        if a != b and (what == "sweep" and n not in altered or not altered):
            k = next(k for k in a if a[k] != b[k])
            lab.note(f"row {n}: {k} is {a[k]!r}, undisturbed {b[k]!r}; no such piece in the record")


def case_twice(lab, rng):
    deck, files = drawn(rng, "si", "field", "gp1", "calibrate_gp1", "sweep_gp1", "johancsik_well_3", "study_gp1", "uncertainty_gp1")
    deck.set(deck.one("job"), "models", "'soft'")
    if rng.random() < 0.2:
        deck.set(deck.one("job"), "plots", ".true.")
    second = copy.deepcopy(deck)
    for _ in range(rng.choice([1, 2])):
        change = rng.randrange(7)
        if change == 0 and len(second.all("load_case")) > 1 and not second.all("calibrate") + second.all("study") + second.all("legacy"):
            second.groups.remove(rng.choice(second.all("load_case")))
        elif change == 1:
            name = rng.choice([n for n in ("load_case", "sweep", "uncertainty", "legacy") if second.all(n)] or ["job"])
            if name == "load_case" and second.all("calibrate") + second.all("study") + second.all("legacy"):
                continue
            second.set(rng.choice(second.all(name)), {"legacy": "label", "job": "title"}.get(name, "name"), "'renamed'")
        elif change == 2:
            second.set(second.one("job"), "models", rng.choice(["'mcge'", "'rigid'"]))
        elif change == 3:
            second.set(second.one("job"), "profiles", ".false.")
        elif change == 4:
            second.set(second.one("job"), rng.choice(["plots", "hdf5"]), ".false.")
        elif change == 5:
            second.groups = [g for g in second.groups if g[0] not in ("sweep", "calibrate", "study", "legacy", "uncertainty")]
        else:
            second.set(second.one("solver"), "history", ".false.")
    first = lab.run(files | {"deck.nml": deck.text()})
    alone = lab.run(files | {"deck.nml": second.text()})
    after = lab.run(files | {"deck.nml": second.text()}, again=first)
    if alone.status in (0, 3) and first.status in (0, 3) and after.status == alone.status:
        left, right = ({p.relative_to(r.out).as_posix() for p in r.out.rglob("*")} for r in (after, alone))
        if left != right:
            lab.note(f"left over {sorted(left - right)[:6]}, missing {sorted(right - left)[:6]}")
        for name in sorted(left & right):
            if name.endswith(".csv") and (after.out / name).is_file():
                ours, theirs = ([{k: v for k, v in row.items() if k not in MEASURED} for row in summary(r, name)]
                                for r in (after, alone))
                if ours != theirs:
                    lab.note(f"{name} is not that of the run alone")
                    break


def case_collision(lab, rng):
    """Something that is read stands in the output folder under the name of a result, by itself or by a link."""
    deck, files = drawn(rng, "si", "sucker_rods", "johancsik_well_3")
    deck.set(deck.one("job"), "models", "'soft'")
    case = deck.get(deck.all("load_case")[0], "name")[0].strip("'")
    results = ["summary.csv", "limits.csv", f"profile_{case}_soft.csv"]
    results += [f"legacy_{deck.get(g, 'label')[0].strip(chr(39))}.csv" for g in deck.all("legacy")]
    result = rng.choice(results + ["summary.csv.unfinished", "summary.csv.7-7.unfinished"])
    key = rng.choice([k for k in (("trajectory", "survey_file"), ("legacy", "file"), ("job", "catalogue_file"), None) if k is None or
                      k[0] == "trajectory" or k[0] == "legacy" and deck.all("legacy") or k[0] == "job" and "catalogue.csv" in files])
    way = rng.choice(["itself", "symbolic link", "hard link"])
    if key == ("trajectory", "survey_file"):
        stations = stations_of(deck, files)
        files["data.csv"] = "\n".join(["md,inc,azi"] + [",".join(f"{v:.12g}" for v in s) for s in stations]) + "\n"
        for name in ("md", "inc", "azi"):
            deck.drop("trajectory", name)
    elif key == ("legacy", "file"):
        files["data.csv"] = files[deck.get(deck.all("legacy")[0], "file")[0].strip("'")]
    elif key:
        files["data.csv"] = files.pop("catalogue.csv")
    source = "deck.nml" if key is None else "data.csv"
    if key:
        group = deck.one(key[0]) if key[0] != "legacy" else deck.all("legacy")[0]
        deck.set(group, key[1], quoted("../out/" + result if way == "itself" else "data.csv"))
    files["deck.nml"] = deck.text()

    def place(home):
        (home / "out").mkdir()
        target, at = home / "deck" / source, home / "out" / result
        if way == "symbolic link" or way == "itself" and key is None:
            at.symlink_to(target)
        elif way == "hard link":
            at.hardlink_to(target)
        else:
            target.rename(at)

    run = lab.run(files, before=place, expect=(0, 1, 2, 3), echo=False, fault_of_1=False)
    kept = (run.home / "out" / result) if way == "itself" and key else run.home / "deck" / source
    if not kept.is_file() or kept.read_bytes() != files[source].encode("latin-1"):
        lab.note(f"an input was lost: {source} as {result} ({way})")


def case_link(lab, rng):
    """Links lead out of the output folder."""
    deck, files = drawn(rng, "si", "sweep_gp1")
    deck.set(deck.one("job"), "models", "'soft'")
    deck.set(deck.one("job"), "plots", ".true.")
    files["deck.nml"] = deck.text()
    cases = [deck.get(group, "name")[0].strip("'") for group in deck.all("load_case")] or ["x"]
    sweeps = [deck.get(group, "name")[0].strip("'") for group in deck.all("sweep") if deck.get(group, "name")] or ["x"]
    names = ["pictures"] * 4 + ["summary.csv", "limits.csv", "results.h5", "report.html", "drillgap_files.txt", "drillgap.lock", "mine.csv"]
    names += [f"{kind}_{rng.choice(cases)}_soft.{end}" for kind, end in (("profile", "csv"), ("view", "hdf"), ("hole", "hdf"))]
    names += [f"sweep_{rng.choice(sweeps)}.{end}" for end in ("csv", "partial", "failed", "part_1_of_2")]
    names += [f"pictures/{name}" for name in ("gnuplot.log", "all.gp", "hookload.gp", "hookload.svg", f"path_{rng.choice(cases)}.svg")]
    chosen = sorted({rng.choice(names) + rng.choice(["", "", "", ".unfinished"]) for _ in range(rng.choice([1, 1, 2, 3]))})

    def place(home):
        (home / "other").mkdir()
        (home / "other" / "precious").write_text("precious", encoding="utf-8")
        (home / "out").mkdir()
        for name in chosen:
            at = home / "out" / name
            if not at.parent.is_symlink():
                at.parent.mkdir(exist_ok=True)
                at.symlink_to(home / rng.choice(["other", "other/precious", "nowhere", "other/nowhere", "deck"]))

    more = rng.choice([(), (), ("--part", "1/2"), ("--merge", "2"), ("--again",)]) if deck.all("sweep") else ()
    run = lab.start(lab.home / "1", {f"deck/{name}": text for name, text in files.items()},
                    ["../deck/deck.nml", "--output", "../out", "--threads", "1", *more], place)
    lab.runs.append(run)
    for fault in run.faults():
        lab.note(fault)
    if "pictures" in chosen and "--part" not in more and run.status != 1:
        lab.note(f"a link for the folder of pictures has exit status {run.status}: {run.stderr[:200]}")
    for name in chosen:
        if run.status in (1, 2) and "out/" + name in run.held and not run.now.get("out/" + name, "").startswith("-> "):
            lab.note(f"refused, but {name} is no link any more")


def case_options(lab, rng):
    deck, files = drawn(rng, "si", "field", "sweep_gp1")
    deck.set(deck.one("job"), "models", "'soft'")
    words = ["--check", "--quiet", "--threads", "0", "1", "-1", "99999", "abc", "--part", "1/1", "0/0", "3/2", "1/99999999999", "1,3-4/4", "3,,7/9", "9-7/40", "1-2-3/4", "/", "--merge", "2", "0",
             "--help", "--version", "--", "", "-", "--outputs", "--output", "--output=", "--part=1/2", "--list-catalogue", "\xff", "x" * 5000, "--threads=2"]
    more = [rng.choice(words) for _ in range(rng.choice([1, 1, 2, 2, 3]))]
    more = [w for i, w in enumerate(more) if not (w.startswith("--output") and w != "--outputs" or i and more[i - 1] == "--output")]
    run = lab.start(lab.home / "1", {f"deck/{n}": t for n, t in files.items()} | {"deck/deck.nml": deck.text()},
                    ["../deck/deck.nml", "--output", "../out", "--threads", "1", *more])
    lab.runs.append(run)
    for fault in run.faults():
        lab.note(f"{more}: {fault}")
    if run.status == 1:
        lab.note(f"{more}: exit status 1: {run.stderr[:200]}")


def case_convert(lab, rng):
    deck, files = drawn(rng)
    for _ in range(rng.choice([0, 1, 2])):
        change_deck(deck, rng, True)
    deck.set(deck.one("job"), "models", "'soft'")
    files["deck.nml"] = deck.tame().text()
    run = lab.run(files)
    if run.status not in (0, 3):
        return
    converted = lab.act(run, "--convert", "../deck/deck.nml", *rng.choice([[], ["SI"], ["field"], ["metric"]]))
    if converted.status:
        lab.note(f"--convert has exit status {converted.status}: {converted.stderr[:300]}")
        return
    again = lab.run(files | {"deck.nml": converted.stdout}, expect=run.status)
    for ours, theirs in zip(summary(again), summary(run)):
        if ours["status"] != theirs["status"] or (ours["case"], ours["model"]) != (theirs["case"], theirs["model"]):
            lab.note(f"converted: {ours['case']} is {ours['status']}, was {theirs['status']}")
        elif ours["status"] == "converged":
            (one, *_), (other, *forces) = ([next(float(r[f"{k}_{unit}"]) * factor for unit, factor in FORCE_UNITS if f"{k}_{unit}" in r)
                                            for k in ("hookload", "wob", "normal_force", "friction")] for r in (ours, theirs))
            if abs(one - other) > SAME_CONVERTED * max(abs(other), *map(abs, forces)) + 1e-9:
                lab.note(f"converted: hook load of {ours['case']} {one}, was {other}")


# No file, or a name that a shell would not leave alone. What is a file is read.
WAYS = ["pipe", "device", "folder", "link to nothing", "link to itself", "link", "name"]
FILE_NAMES = ["a b.csv", "a;b.csv", "-a.csv", "=1+1.csv", "$(echo a).csv", "`echo a`.csv", '"a".csv', "a&b|c.csv", "~",
              "..csv", "a%s.csv", "a\\b.csv", "*.csv"]


def case_file(lab, rng):
    """An input is a pipe, a device, a folder or a link, or has an odd name: refused at once, or read."""
    deck, files = drawn(rng, "si", "sucker_rods", "johancsik_well_3", "gp1", "casing_run")
    deck.set(deck.one("job"), "models", "'soft'")
    deck.set(deck.one("job"), "plots", ".false.")
    named = [(g, k) for n, k in (("trajectory", "survey_file"), ("legacy", "file")) for g in deck.all(n) if deck.get(g, k)]
    if "catalogue.csv" in files:
        deck.set(deck.one("job"), "catalogue_file", "'catalogue.csv'")
        named.append((deck.one("job"), "catalogue_file"))
    group, key = rng.choice(named + [(None, None)])
    way = rng.choice(WAYS)
    name = "deck.nml" if group is None else deck.get(group, key)[0].strip("'")
    if way == "name" and group:
        other = rng.choice(FILE_NAMES)
        files[other] = files[name]
        deck.set(group, key, quoted(other))
    files["deck.nml"] = deck.text()

    def place(home):
        path = home / "deck" / name
        if way == "link":
            path.rename(path.with_name("elsewhere"))
            path.symlink_to("elsewhere")
        elif way != "name":
            path.unlink()
            if way == "pipe":
                os.mkfifo(path)
            elif way == "folder":
                path.mkdir()
            else:
                path.symlink_to({"device": rng.choice(["/dev/zero", "/dev/null", "/dev/random"]), "link to nothing": "nowhere"}.get(way, name))

    lab.seconds = min(lab.seconds, 20.0)
    lab.run(files, before=place, echo=False, expect=(0, 3) if way in ("link", "name") else 2)


def case_mistake(lab, rng):
    """One value that no deck may have gives one message."""
    _, deck, files = rng.choice(samples())
    deck = deck.copy()
    group = rng.choice([g for g in deck.groups if g[1]])
    key, values = rng.choice(group[1])
    i = rng.randrange(len(values))
    values[i] = rng.choice(["'=x'", "'-x'", "'\xe2\x80\xae'", "'\xff'"] if values[i][0] in "'\"" else ["-1e9", "nan", "'x'", "1e400"])
    run = lab.run(files | {"deck.nml": deck.text()}, expect=2)
    messages = run.stderr.strip().split("\n")
    if run.status == 2 and len(messages) > 1:
        lab.note(f"one mistake, {key} = {values[i]}, gives {len(messages)} messages: {messages[:3]}")


KINDS = [(case_deck, 20), (case_limits, 10), (case_bytes, 12), (case_text, 9), (case_survey, 14), (case_catalogue, 5), (case_legacy, 5), (case_record, 9),
         (case_twice, 3), (case_collision, 2), (case_link, 2), (case_options, 2), (case_convert, 5),
         (case_spelling, 4), (case_file, 4), (case_mistake, 5)]


def case_of(seed, only=None):
    """The generator of a seed and its kind."""
    rng = random.Random(f"fuzz {seed}")
    kind = rng.choices([k for k, _ in KINDS], [w for _, w in KINDS])[0]
    if only:
        kind = next(k for k, _ in KINDS if k.__name__ == "case_" + only)
    return kind, rng


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1, help="of the first case")
    parser.add_argument("--keep", help="folder for the cases that fail, each with its runs and faults; default a new one")
    parser.add_argument("--kind", help="all cases of this kind", choices=[k.__name__[5:] for k, _ in KINDS])
    parser.add_argument("--seconds", type=float, default=60.0, help="longest processor time of one run")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    bound_memory_of(program)
    passed = failed = runs = long = 0
    outcomes, kinds, slowest = {}, {}, (0.0, 0)
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="fuzz_"))
    keep = pathlib.Path(options.keep) if options.keep else scratch / "failed"
    for seed in range(options.seed, options.seed + options.count):
        kind, rng = case_of(seed, options.kind)
        lab = Lab(program, scratch / f"seed_{seed}", options.seconds)
        kind(lab, rng)
        name = kind.__name__[5:]
        for run in lab.runs:
            outcomes[run.status] = outcomes.get(run.status, 0) + 1
            slowest = max(slowest, (run.seconds, seed))
        runs, long = runs + len(lab.runs), long + lab.long
        total, bad = kinds.get(name, (0, 0))
        kinds[name] = (total + 1, bad + bool(lab.faults))
        if lab.faults:
            failed += 1
            (lab.home / "faults").write_text("\n".join(lab.faults) + "\n", encoding="utf-8", errors="replace")
            place = keep / f"seed_{seed}"
            keep.mkdir(parents=True, exist_ok=True)
            shutil.rmtree(place, ignore_errors=True)
            shutil.move(lab.home, place)
            print(f"FAIL {name} --seed {seed} (kept in {place}): " + "; ".join(map(repr, lab.faults)), flush=True)
        else:
            passed += 1
            shutil.rmtree(lab.home, ignore_errors=True)
    if not keep.is_relative_to(scratch) or not keep.exists():
        shutil.rmtree(scratch, ignore_errors=True)
    print("kinds, cases and failed ones: " + ", ".join(f"{k} {n} {b}" for k, (n, b) in sorted(kinds.items())))
    print(f"{runs} runs, {long} of them long because asked to be; exit statuses: "
          + ", ".join(f"{n} of {s}" for s, n in sorted(outcomes.items(), key=str)))
    print(f"slowest run: {slowest[0]:.1f} s, seed {slowest[1]}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

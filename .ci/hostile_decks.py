#!/usr/bin/env python3
"""Feeds a built drillgap broken decks, data files and surroundings: it must refuse, mark or solve them, never crash or lie.

Usage: hostile_decks.py PATH_TO_DRILLGAP [--count N] [--seed S] [--only SEED]

First the list below of decks and surroundings, each with the exit status and message that it must bring: a truncated deck,
binary bytes, endless lines, huge counts, files that vanish, full disks, folders that cannot be written. Then N decks that a
seed has mutated at random (bytes, numbers, words, lines, groups; deck or data file). Of every run is asked:

  exit status 0 to 3, and no signal, traceback, sanitizer's report or runtime message
  status 2      a message with file and line, and no output folder
  status 3      a row that says so
  status 0      every row converged or locked up, every number finite, forces in balance, profile and summary in agreement
  always        nothing written outside the output folder, no file under an unfinished name, memory and time bounded

Every mutant that fails is printed with its seed and kept; --only SEED runs that one again. Ends in 'N passed, N failed'.
"""
import argparse
import csv
import math
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

TIME_LIMIT = 120.0           # s, a hundred times what the slowest deck below takes with sanitizers
MEMORY_LIMIT = 1_000_000     # kB; not asked of programs with sanitizers, which keep what has been given back
BALANCE = 1.0e-6             # force out of balance over the largest force: residuals are iterated to 1e-9 of the weight
AGREEMENT = 2.0e-2           # hook load against the uppermost axial force, which stands half an element lower

SI_DECK = """&job title = 'hostile', models = 'mcge', 'soft', 'rigid', 'mixed' /
&trajectory survey_file = 'wells/path.csv', interpolation = 'minimum_curvature' /
&hole name = 'casing', md_bottom = 300.0, diameter = 224.5, friction = 0.2 /
&hole name = 'open', diameter = 215.9, friction_axial = 0.25, friction_rotary = 0.3, wall_stiffness = 1e5, mud_sheath = 1.5 /
&fluid density = 1200.0 /
&component name = 'collar', kind = 'collar', length = 60.0, od = 165.1, id = 71.4, mass = 136.0 /
&component name = 'hwdp', kind = 'hwdp', length = 100.0, od = 127.0, id = 76.2, joint_od = 165.1, yield = 379.0 /
&component name = 'pipe', od = 127.0, id = 108.6, mass = 31.9, joint_od = 161.9, youngs = 206.0, poisson = 0.3 /
&boundary top_lateral = 'centred', bit_lateral = 'free' /
&load_case name = 'up', operation = 'up', bit_depth = 700.0, measured_hookload = 250.0 /
&load_case name = 'drill', operation = 'rotary', bit_depth = 650.0, wob = 10.0, tob = 1.5, rpm = 60 /
&load_case name = 'back', operation = 'backream', bit_depth = 640.0, rpm = 60, trip_speed = 0.1, friction = 0.2 /
&solver element_length = 30.0, gap_location = 'extremum', tolerance = 1e-9, max_iterations = 40 /
&legacy label = 'other', file = 'wells/other.csv', case = 'up', axial = 'tension' /
"""
SURVEY = """# a survey
md,inc,azi
0,0,10
200,0,10
400,20.5,10
600,41.0,15
700,44.0,20
"""
LEGACY = """md,tension
0,260
350,160
700,0
"""
FIELD_DECK = """&JOB units='field' models='soft','mcge' hdf5=.false. plots=.false. /
&trajectory md=0,1000,2000,3000 inc=0,0,30,30 azi=4*45 /
&hole diameter=8.5 friction=0.25 /
&fluid density=10.0 /
&component kind='collar' length=300 od=6.5 id=2.8125 mass=91.0 /
&component od=5.0 id=4.276 mass=21.9 joint_od=6.375 joint_spacing=31 joint_length=1.5 /
&load_case name='in' operation='down' bit_depth=3000 /
&load_case name='slide' operation='sliding' bit_depth=2900 wob=2.0 friction=0.2 /
&solver element_length=90 tool_joints='smeared' history=.true. max_iterations=40 /
"""
DECKS = [{"deck.nml": SI_DECK, "wells/path.csv": SURVEY, "wells/other.csv": LEGACY}, {"deck.nml": FIELD_DECK}]

NUMBERS = ["0", "-1", "1e308", "-1e308", "1e-308", "1e309", "NaN", "nan", "Infinity", "-inf", "1e400", "9" * 40, "0." + "0" * 50 + "1",
           "1d5", "1e", "e5", "+-3", "0x1F", "1_8", ".", "-", "1000000000*0.0", "0*1", "-3*2", "3*", "*", "1e5", "1e-5", "1e-10", "1000000",
           "0.1", "0.5", "90", "180", "89.999999", "1e15", "2147483648", "99999999999999999999", "1,5", "(1,2)", "'7'", ".true.", "''"]
WORDS = ["&", "/", "$", "&end", "&job", "&hole", "&load_case /", "=", "==", ",", ";", "!", "'", '"', "\t", "\r", "\0", "\\", "%", "(", ")",
         "(1)", "(:)", "(2:1)", "(-1)", "(1000000000)", "::", "md", "../../escape", "/etc/passwd", ".", "..", "~", "$HOME", "`id`",
         "é", "\ufeff", "\u202e", "x" * 5000, " " * 5000, "rigid", "static", "ream", "spline", "nodes", "discrete", "field", "SI"]


CHOICES = [["up", "down", "rotary", "sliding", "static", "rotate_off_bottom", "ream", "backream"], ["centred", "free"],
           ["minimum_curvature", "spline"], ["extremum", "nodes"], ["smeared", "discrete"], ["field", "SI"]]


def mutate(text, rng, gentle):
    """One random change of a text (latin-1, so that any byte can stand in it); a gentle one often leaves a legal deck."""
    lines = text.splitlines(keepends=True) or ["\n"]
    i = rng.randrange(len(lines))
    at, to = sorted(rng.randrange(len(text) + 1) for _ in range(2))
    to = min(to, at + rng.choice([1, 3, 20, 200]))
    numbers = list(re.finditer(r"(?<![\w.])[-+]?\d[\d.]*(?:[eEdD][-+]?\d+)?", text))
    words = list(re.finditer(r"[A-Za-z_]\w*", text))
    kind = rng.randrange(14) if not gentle else rng.choice([4, 4, 4, 5, 12, 13, 14])
    if kind <= 3 and numbers:                                                  # a hostile number
        n = rng.choice(numbers)
        return text[:n.start()] + rng.choice(NUMBERS) + text[n.end():]
    if kind == 4 and numbers:                                                  # a number by some factor
        n = rng.choice(numbers)
        try:
            factor = rng.uniform(0.3, 3.0) if gentle else rng.choice([-1, 1e-3, 0.1, 0.9, 1.1, 3, 10, 1e3, 1e6])
            return text[:n.start()] + f"{float(n.group()) * factor:.6g}" + text[n.end():]
        except ValueError:
            return text
    if kind == 5 and len(numbers) > 1:                                         # two numbers change places
        a, b = sorted(rng.sample(numbers, 2), key=lambda m: m.start())
        return text[:a.start()] + b.group() + text[a.end():b.start()] + a.group() + text[b.end():]
    if kind == 14:                                                             # a legal word by another
        name = rng.choice([c for c in CHOICES if any(f"'{w}'" in text for w in c)] or [CHOICES[0]])
        for w in rng.sample(name, len(name)):
            if f"'{w}'" in text:
                return text.replace(f"'{w}'", f"'{rng.choice(name)}'", 1)
    if kind == 6 and words:                                                    # a word by another, or a slip in it
        w = rng.choice(words)
        other = rng.choice([rng.choice(words).group(), rng.choice(WORDS), w.group()[::-1], w.group()[:-1], w.group() + "x"])
        return text[:w.start()] + other + text[w.end():]
    if kind == 7:
        return text[:at] + rng.choice(WORDS) + text[at:]
    if kind == 8:
        return text[:at] + text[to:]
    if kind == 9:                                                              # bytes
        return text[:at] + "".join(chr(rng.randrange(256)) for _ in range(rng.choice([1, 1, 2, 8, 64]))) + text[to:]
    if kind == 10:
        return text[:at]
    if kind == 11:
        lines.insert(rng.randrange(len(lines)), lines[i] * rng.choice([1, 1, 2, 50]))
    elif kind == 12:
        del lines[i]
    else:
        j = rng.randrange(len(lines))
        lines[i], lines[j] = lines[j], lines[i]
    return "".join(lines)


def mutant(seed):
    """The files that a seed stands for: a deck or its data with one to four changes."""
    rng = random.Random(seed)
    files = dict(rng.choice(DECKS))
    gentle = rng.random() < 0.5
    for _ in range(rng.choice([2, 4, 8]) if gentle else rng.choice([1, 1, 1, 2, 2, 3, 4])):
        name = rng.choice(list(files)) if rng.random() < 0.4 else "deck.nml"
        files[name] = mutate(files[name], rng, gentle)
    return files


class Run:
    """One run of the program in a folder of its own."""
    bounded = False      # in memory

    def __init__(self, program, files, arguments=(), before=None, shell_limits=None, stdout=None):
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="hostile_"))
        for name, text in files.items():
            path = self.home / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text if isinstance(text, bytes) else text.encode("latin-1", "replace"))
        if before:
            before(self.home)
        held = set(self.listing())
        self.out = self.home / "out"
        def limits():
            if Run.bounded:
                memory_bound()
            if shell_limits:
                shell_limits()

        arguments = list(arguments) or ["deck.nml", "--output", "out"]
        with open(self.home.parent / (self.home.name + ".err"), "w+b") as errors, \
             open(self.home.parent / (self.home.name + ".txt"), "w+b") as tables:
            process = subprocess.Popen([program, *arguments], cwd=self.home, stdout=stdout or tables, stderr=errors,
                                       stdin=subprocess.DEVNULL, preexec_fn=limits)
            timer = signal.signal(signal.SIGALRM, lambda *_: process.kill())
            signal.setitimer(signal.ITIMER_REAL, TIME_LIMIT)
            _, status, usage = os.wait4(process.pid, 0)
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, timer)
            process.returncode = 0
            self.killed = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
            self.status = os.WEXITSTATUS(status) if os.WIFEXITED(status) else -self.killed
            self.memory = usage.ru_maxrss
            self.seconds = usage.ru_utime + usage.ru_stime
            errors.seek(0)
            self.stderr = errors.read().decode("latin-1")
        for ending in (".err", ".txt"):
            os.unlink(str(self.home) + ending)
        self.strangers = [p for p in set(self.listing()) - held if p != "out" and not p.startswith("out/")]

    def listing(self):
        return [str(p.relative_to(self.home)) for p in self.home.rglob("*")]

    def faults(self):
        """What this run did that no run may do."""
        found = []
        if self.killed:
            found.append(f"ended by signal {self.killed}" + (" (time limit?)" if self.killed == signal.SIGKILL else ""))
        elif self.status not in (0, 1, 2, 3):
            found.append(f"exit status {self.status}")
        for mark in ("Backtrace", "Fortran runtime", "AddressSanitizer", "runtime error", "libgfortran", "HDF5-DIAG", "Error termination"):
            if mark in self.stderr:
                found.append(mark + ": " + self.stderr[max(0, self.stderr.find(mark) - 200):][:600].strip())
                break
        if self.strangers:
            found.append(f"written outside the output folder: {self.strangers[:5]}")
        if Run.bounded and self.memory > MEMORY_LIMIT:
            found.append(f"{self.memory} kB of memory")
        if self.out.is_dir() and list(self.out.rglob("*.unfinished")):
            found.append("unfinished files left")
        if self.status in (1, 2) and not self.stderr.strip():
            found.append(f"exit status {self.status} without a message")
        if self.status == 2:
            if self.out.exists():
                found.append("refused, yet an output folder")
            if not re.search(r"^\S+:\d+: |^\S+: |^drillgap: ", self.stderr, re.M):
                found.append("no file and line: " + self.stderr[:200])
        if self.status in (0, 3):
            found += self.wrong_results()
        return found

    def wrong_results(self):
        found = []
        summary = self.out / "summary.csv"
        if not summary.is_file():
            return ["no summary.csv"]
        deck = (self.home / "deck.nml").read_text(encoding="latin-1")
        asked = re.findall(r"(?i)\btolerance\s*=\s*([-+.\de]+)", deck)          # a loose one leaves as much out of balance
        balance = max([BALANCE] + [100.0 * float(a) for a in asked if re.fullmatch(r"(?i)[-+]?\d*\.?\d+(e[-+]?\d+)?", a)])
        rows = list(csv.DictReader(summary.open(encoding="latin-1")))
        unit = "kN" if "hookload_kN" in rows[0] else "klbf"
        good = [r for r in rows if r["status"] in ("converged", "locked_up")]
        if self.status == 0 and len(good) < len(rows):
            found.append("exit status 0 with a case not converged")
        if self.status == 3 and len(good) == len(rows):
            found.append("exit status 3 with every case converged")
        for path in sorted(self.out.glob("*.csv")):
            text = path.read_text(encoding="latin-1")
            if re.search(r"(?i)(^|,)\s*[-+]?(nan|inf(inity)?|\*+)\s*(,|$)", text, re.M):
                found.append(f"{path.name}: a number that is none")
        for r in rows:
            if r["status"] != "converged":
                continue
            place = f"case {r['case']}, {r['model']}"
            numbers = [float(r[k]) for k in (f"hookload_{unit}", f"friction_{unit}", f"normal_force_{unit}", f"wob_{unit}")]
            force = max(map(abs, numbers))
            left = float(r.get(f"equilibrium_{unit}") or 0.0)
            if not left <= balance * force + 1e-9:
                found.append(f"{place}: {left} {unit} out of balance, forces are {force}")
            profile = self.out / f"profile_{r['case']}_{r['model']}.csv"
            if profile.is_file():
                first = next(csv.DictReader(profile.open(encoding="latin-1")))
                axial = float(first[f"axial_{unit}"])
                if not abs(axial - numbers[0]) <= AGREEMENT * max(force, 1e-6) + 0.01 * abs(numbers[3]):
                    found.append(f"{place}: hook load {numbers[0]}, axial force at the top {axial}")
        return found

    def tidy(self):
        shutil.rmtree(self.home, ignore_errors=True)


def memory_bound():
    """No run may take the machine down. Programs with sanitizers reserve terabytes that they never use: not for those."""
    resource.setrlimit(resource.RLIMIT_AS, (4_000_000_000, 4_000_000_000))


def full_disk():
    """Writes beyond 2 kB fail, as on a full disk, instead of ending the program."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048))


def remove(name):
    return lambda home: (home / name).unlink()


def link(name, target):
    return lambda home: ((home / name).unlink(missing_ok=True), (home / name).symlink_to(target))


def changed(old, new, base=SI_DECK):
    assert old in base, old
    return {"deck.nml": base.replace(old, new, 1), "wells/path.csv": SURVEY, "wells/other.csv": LEGACY}


def listed():
    """(name, files, expected status, text that the message must hold, keywords of Run)"""
    good = DECKS[0]
    out = ["deck.nml", "--output"]
    yield "sound SI deck", good, 0, "", {}
    yield "sound field deck", DECKS[1], 0, "", {}
    yield "empty deck", {"deck.nml": ""}, 2, "missing", {}
    yield "truncated in a group", {**good, "deck.nml": SI_DECK[:700]}, 2, "deck.nml:", {}
    yield "binary deck", {"deck.nml": bytes(range(256)) * 40}, 2, "deck.nml:", {}
    yield "a million zero bytes", {"deck.nml": b"\0" * 1_000_000}, 2, "deck.nml:", {}
    yield "a line of 5 MB", changed("'hostile'", "'" + "x" * 5_000_000 + "'"), 2, "line 1 has more than", {}
    yield "a line of 20 kB", changed("'hostile'", "'" + "x" * 20_000 + "'"), 0, "", {}
    yield "99 kB of keys", changed("density =", "x=1 " * 24_000 + "density ="), 2, "too many faults", {}
    yield "200000 lines", {**good, "deck.nml": SI_DECK + "\n" * 200_000}, 0, "", {}
    yield "20000 groups", {**good, "deck.nml": SI_DECK + "&fluid /\n" * 20_000}, 2, "second time", {}
    yield "5000 cases", {**good, "deck.nml": SI_DECK + "".join(f"&load_case name='c{i}' operation='up' bit_depth=7e9 /\n" for i in range(5000))}, 2, "deck.nml:", {}
    yield "huge repeat count", changed("models = 'mcge', 'soft', 'rigid', 'mixed'", "models = 2000000000*'mcge'"), 2, "deck.nml:1", {}
    yield "large repeat count", changed("models = 'mcge'", "models = 999999*'mcge'"), 2, "deck.nml:1", {}
    yield "200000 stations", changed("survey_file = 'wells/path.csv'", "md = 200000*0.0, inc = 200000*0, azi = 200000*0"), 2, "deck.nml:2", {}
    yield "a deck without end", good, 2, "cannot be read", {"before": link("deck.nml", "/dev/zero")}
    yield "huge subscript", changed("density = 1200.0", "density(2000000000) = 1200.0"), 2, "deck.nml:5", {}
    yield "huge stations", {"deck.nml": FIELD_DECK.replace("azi=4*45", "azi=4*45, md(2000000000)=1")}, 2, "deck.nml:2", {}
    yield "duplicated key", changed("density = 1200.0", "density = 1200.0, density = 1300.0"), 2, "density", {}
    yield "duplicated group", {**good, "deck.nml": SI_DECK + "&fluid density = 1000.0 /\n"}, 2, "second time", {}
    for number in ("NaN", "Infinity", "-Infinity", "1e400", "1e308", "-1e308"):
        yield f"mud of {number}", changed("density = 1200.0", f"density = {number}"), 2, "deck.nml:5", {}
        yield f"station at {number}", {**good, "wells/path.csv": SURVEY.replace("400", number)}, 2, "path.csv:5", {}
    yield "path in the name of a case", changed("name = 'up'", "name = '../../up'"), 2, "deck.nml:10", {}
    yield "path in a label", changed("label = 'other'", "label = '../other'"), 2, "deck.nml:14", {}
    yield "a name of 5000 letters", changed("name = 'up'", "name = '" + "u" * 5000 + "'"), 2, "deck.nml:10", {}
    yield "survey vanished", good, 2, "path.csv: survey file cannot be opened", {"before": remove("wells/path.csv")}
    yield "legacy vanished", good, 2, "other.csv", {"before": remove("wells/other.csv")}
    yield "deck vanished", good, 2, "deck.nml", {"before": remove("deck.nml")}
    yield "deck a folder", {"deck.nml/x": ""}, 2, "folder", {}
    yield "deck links to itself", good, 2, "deck.nml", {"before": link("deck.nml", "deck.nml")}
    yield "survey binary", {**good, "wells/path.csv": bytes(range(256)) * 40}, 2, "path.csv:", {}
    yield "survey empty", {**good, "wells/path.csv": ""}, 2, "path.csv", {}
    yield "survey without rows", {**good, "wells/path.csv": "md,inc,azi\n"}, 2, "path.csv", {}
    yield "survey of 5 MB in one line", {**good, "wells/path.csv": SURVEY + "1," * 2_500_000}, 2, "line 8 has more than", {}
    yield "survey of 5000 columns", {**good, "wells/path.csv": SURVEY.replace("0,0,10", "0,0," + "1," * 5_000)}, 0, "", {}
    yield "survey ragged", {**good, "wells/path.csv": SURVEY.replace(",41.0,15", "")}, 2, "path.csv:6", {}
    yield "survey turning back", {**good, "wells/path.csv": SURVEY.replace("600,", "300,")}, 2, "path.csv:6", {}
    yield "output is a file", good, 1, "cannot make the output folder", {"arguments": [*out, "deck.nml"]}
    yield "output below a file", good, 1, "cannot make the output folder", {"arguments": [*out, "deck.nml/out"]}
    yield "output not writable", good, 1, "cannot", {"arguments": [*out, "/proc/drillgap"]}
    yield "output an endless name", good, 1, "cannot", {"arguments": [*out, "o" * 5000]}
    yield "a folder where a file is to be", good, 1, "summary.csv", {
        "before": lambda home: (home / "out/summary.csv").mkdir(parents=True)}
    yield "disk full", good, 1, "disk full", {"shell_limits": full_disk}
    yield "elements without number", changed("element_length = 30.0", "element_length = 0.01").copy() | {
        "wells/path.csv": SURVEY.replace("700,44.0", "49000,44.0"),
        "deck.nml": SI_DECK.replace("element_length = 30.0", "element_length = 0.01").replace("= 700.0", "= 49000.0")}, 2, "GB", {}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=200, help="mutants")
    parser.add_argument("--seed", type=int, default=1, help="of the first mutant")
    parser.add_argument("--only", type=int, help="run this mutant alone and keep its folder")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    Run.bounded = subprocess.run([program, "--version"], preexec_fn=memory_bound, capture_output=True).returncode == 0
    passed, failed, outcomes = 0, 0, {}
    slowest, largest = (0.0, ""), (0, "")

    def judge(name, run, faults):
        nonlocal passed, failed, slowest, largest
        slowest, largest = max(slowest, (run.seconds, name)), max(largest, (run.memory, name))
        outcomes[run.status] = outcomes.get(run.status, 0) + 1
        if faults:
            failed += 1
            print(f"FAIL {name} (kept in {run.home}): " + "; ".join(faults), flush=True)
        else:
            passed += 1
            run.tidy()

    if options.only is None:
        for name, files, status, text, more in listed():
            run = Run(program, files, **more)
            faults = run.faults() if status != 1 else [f for f in run.faults() if "no summary" not in f]
            if run.status != status:
                faults.append(f"exit status {run.status}, expected {status}: {run.stderr[:300]}")
            if text not in run.stderr:
                faults.append(f"no '{text}' in: {run.stderr[:300]}")
            judge(name, run, faults)
        print(f"listed: {passed} passed, {failed} failed", flush=True)
    seeds = range(options.seed, options.seed + options.count) if options.only is None else [options.only]
    for seed in seeds:
        run = Run(program, mutant(seed))
        faults = run.faults()
        if options.only is not None:
            print(f"exit status {run.status}\n{run.stderr}")
            faults = faults or ["kept on request"]
        judge(f"mutant {seed}", run, faults)
    print("exit statuses: " + ", ".join(f"{n} of {s}" for s, n in sorted(outcomes.items())))
    print(f"slowest: {slowest[0]:.1f} s, {slowest[1]}; largest: {largest[0] / 1000:.0f} MB, {largest[1]}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

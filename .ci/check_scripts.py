#!/usr/bin/env python3
"""Runs input/sweep_parallel.sh and input/sweep_slurm.sh on decks whose names a shell would take for something else, and the two
parameter studies of input/README.md as they stand there.

Usage: check_scripts.py PATH_TO_DRILLGAP

Each name must reach the program as it is, as deck and as output folder, in every part and in the merge; the joined sweep must be
there; nothing that a name says may be run. GNU parallel is used where it is installed, a stand-in that quotes as it does elsewhere.
The task of an array of Slurm is its environment variable.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = 2
NAMES = ["my well", " a", "a'b\"c`touch made`d", "a;touch made;b", "x$(touch made)", "--help", "-", "a\nb", "a\\", "*", "~", "$HOME",
         "{1}{#}{=1=}", "a&touch made&", "a|touch made", "<made", ":::", "#a", "é", "\udcff", "!!", "(a)", "{a,b}"]
DECK = """&job models = 'soft', plots = .false., hdf5 = .false. /
&trajectory md = 0, 500, 900, inc = 0, 0, 30, azi = 3*10 /
&hole diameter = 215.9, friction = 0.3 /
&component od = 127, id = 108.6 /
&sweep name = 's', operations = 'up', bit_depth_from = 500, bit_depth_step = 200 /
"""
STAND_IN = """#!/usr/bin/env python3
import os, re, shlex, subprocess, sys
null, most, each, template = sys.argv[1:]
assert (null, most) == ("--null", "--max-args")
words = os.fsdecode(sys.stdin.buffer.read()).split("\\0")[:-1]
for i in range(0, len(words), int(each)):
    mine = words[i:i + int(each)]
    subprocess.run(re.sub(r"{(\\d+)}", lambda place: shlex.quote(mine[int(place.group(1)) - 1]), template), shell=True, check=False)
"""
WATCHED = """#!/usr/bin/env python3
import os, sys
with open({seen!r}, "ab") as seen:
    seen.write(repr(sys.argv[1:]).encode() + b"\\n")
os.execv({program!r}, ["drillgap", *sys.argv[1:]])
"""


def faults_of(script, name, home):
    """What one script does wrong with one name; `home` holds the programs."""
    folder = home / "well"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    (home / "seen").write_bytes(b"")
    deck, out = name + ".nml", name + " results"
    (folder / deck).write_text(DECK, encoding="utf-8")
    environment = os.environ | {"PATH": f"{home}/bin:{os.environ['PATH']}", "HOME": str(home)}
    environment.pop("PARALLEL", None)

    def start(*words, **more):
        command = ["bash", str(ROOT / "input" / script), deck, str(PARTS), *words]
        return subprocess.run(command, cwd=folder, env=environment | more, capture_output=True, text=True, errors="replace",
                              check=False)

    if script == "sweep_slurm.sh":
        for part in range(1, PARTS + 1):
            start("--output", out, SLURM_ARRAY_TASK_ID=str(part))
        done = start("--merge", "--output", out)
    else:
        done = start("--output", out)
    faults = [f"exit status {done.returncode}: {done.stderr[:300]}"] if done.returncode else []
    seen = [eval(line) for line in (home / "seen").read_text(encoding="utf-8").splitlines()]
    if len(seen) != PARTS + 1 or any(not words or words[0] not in (deck, "./" + deck) or out not in words for words in seen):
        faults.append(f"the program was given {seen}")
    if sorted(path.name for path in folder.iterdir()) != sorted([deck, out]):
        faults.append(f"there are {sorted(path.name for path in folder.iterdir())}")
    if not (folder / out / "sweep_s.csv").is_file():
        faults.append("no sweep_s.csv")
    return faults


def faults_of_studies(home):
    """What the parameter studies do wrong: each prints a row a density, model and load case, with one hook load by either."""
    readme = (ROOT / "input/README.md").read_text(encoding="utf-8")
    folder = home / "study"
    folder.mkdir()
    environment = os.environ | {"PATH": f"{home}/bin:{os.environ['PATH']}"}

    def start(*words):
        return subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, check=False)

    (folder / "well.nml").write_text(start("drillgap", "--template").stdout.replace("&job", "&job plots = .false."), encoding="utf-8")
    rows = []
    for language, program in (("python", [sys.executable, "-c"]), ("sh", ["sh", "-c"])):
        done = start(*program, re.search(rf"^```{language}\n(.*?)^```", readme, re.M | re.S).group(1))
        if done.returncode:
            return [f"{language}: exit status {done.returncode}: {done.stderr[:300]}"]
        rows.append([re.split("[ ,]", line) for line in done.stdout.splitlines()])
    head = (folder / "density_1100/summary.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    by_python = [[row[0], row[1], float(row[3])] for row in rows[0]]
    by_shell = [[row[0], row[1], float(row[1 + head.index("hookload_kN")])] for row in rows[1]]
    densities = sorted({row[0] for row in by_python if row[2] > 0})
    if densities != ["1100", "1200", "1300"] or by_python != by_shell or len({row[2] for row in by_python}) != len(by_python):
        return [f"rows by Python {by_python}, by the shell {by_shell}"]
    return []


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve())
    passed = failed = 0
    with tempfile.TemporaryDirectory(prefix="scripts_") as place:
        home = pathlib.Path(place)
        (home / "bin").mkdir()
        programs = {"drillgap": WATCHED.format(seen=str(home / "seen"), program=program)}
        if not shutil.which("parallel"):
            programs["parallel"] = STAND_IN
        print("GNU parallel:", shutil.which("parallel") or "a stand-in")
        for name, text in programs.items():
            (home / "bin" / name).write_text(text, encoding="utf-8")
            (home / "bin" / name).chmod(0o755)
        for script in ("sweep_parallel.sh", "sweep_slurm.sh"):
            for name in NAMES:
                faults = faults_of(script, name, home)
                passed, failed = passed + (not faults), failed + bool(faults)
                if faults:
                    print(f"FAIL {script}, {name!r}: " + "; ".join(faults), flush=True)
        faults = faults_of_studies(home)
        passed, failed = passed + (not faults), failed + bool(faults)
        if faults:
            print("FAIL input/README.md, parameter study: " + "; ".join(faults), flush=True)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

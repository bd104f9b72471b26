#!/usr/bin/env python3
"""Ends runs of a built drillgap at random moments, and starts them again: nothing half done may look done, nothing is lost.

Usage: interruptions.py PATH_TO_DRILLGAP [--count N] [--seed S]

A deck with load cases, a sweep and an uncertainty is run to its end once. Then N times, each in a fresh folder: it is started,
ended after a random part of that time by SIGINT, SIGTERM or SIGKILL (which no program can answer), sometimes two or three times
over, and at last left to end by itself. After each ending:

  SIGINT, SIGTERM   exit status 1 and a message, or 0 where the run was done first; no file under an unfinished name
  whatever signal   every file under its final name is whole: profiles, sweeps and pictures are those of the undisturbed run,
                    summary.csv has a row for every case, each solved as undisturbed or marked
at the end          every file is that of the undisturbed run but for times, nothing else is left
Other lives:        the output folder is removed or emptied during the run, and a real disk runs full in it (where mounting is allowed):
                    exit status 1 with a message, no traceback, nothing half done under a final name
Read only:          a folder that cannot be written to, empty or with results: exit status 1, the reason, results unchanged
Full disk, pictures: a picture under its final name is whole, and the message names the disk and the page
Two runs:           started together in one folder: one is done as if alone, the other refused by exit status 1 and told who
                    holds the folder, or done after it; so are four parts of which two are the same, while the others share it
Gnuplot:            no gnuplot that hangs outlives a run that is ended by a signal, nor does what it has started
Other names:        a run is killed, then a deck with other names of cases, models and sweeps is run in its folder: it leaves
                    what it leaves in a folder of its own, records of the killed run's unfinished work aside
Ends in 'N passed, N failed'.
"""
import argparse
import csv
import io
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

DECK = """&job models = 'mcge', 'soft', plots = {plots} /
&trajectory md = 0, 600, 1200, 3000, inc = 0, 0, 45, 45, azi = 4*10 /
&hole diameter = 215.9, friction = 0.25 /
&fluid density = 1200 /
&component kind = 'collar', length = 60, od = 165.1, id = 71.4 /
&component od = 127, id = 108.6, joint_od = 168.3 /
&load_case name = 'up', operation = 'up', bit_depth = 3000 /
&load_case name = 'down', operation = 'down', bit_depth = 3000 /
&load_case name = 'drill', operation = 'rotary', bit_depth = 2900, wob = 20 /
&solver element_length = {length} /
&sweep name = 's', operations = 'up', 'down', bit_depth_from = 100, bit_depth_to = 3000, bit_depth_step = 200,
  frictions = 0.1, 0.3, model = 'mcge' /
&uncertainty name = 'u', operations = 'up', 'down', bit_depth_from = 1500, bit_depth_step = 500, samples = 10, seed = 3,
  friction_deviation = 0.03 /
"""
TIME_LIMIT = 120
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
UNFINISHED = ".unfinished"
LOCK = "drillgap.lock"
LIST = "drillgap_files.txt"       # of what is written: more than that while a run is under way


def without_times(path):
    """What a file says, but for seconds and dates."""
    data = path.read_bytes()
    if path.name == "summary.csv":
        rows = list(csv.DictReader(io.StringIO(data.decode())))
        return [{k: v for k, v in row.items() if k != "seconds"} for row in rows]
    if path.suffix in (".h5", ".html", ".hdf"):                 # hold times and dates: that they are whole is asked
        return path.name
    return re.sub(rb"<desc>.*?</desc>", b"", data)


def faults_of(data, name):
    """Whether a file of HDF5 or HTML is whole."""
    if name.endswith((".h5", ".hdf")):
        # the superblock holds where the file ends: at byte 40 in its first two versions, at 28 in later ones
        at = 40 if data[8:9] < b"\2" else 28
        whole = data[:8] == b"\x89HDF\r\n\x1a\n" and int.from_bytes(data[at:at + 8], "little") == len(data)
    else:
        whole = data.rstrip().endswith(b"</html>")
    return [] if whole else [f"{name} is not whole"]


class Place:
    """A folder with the deck, in which runs begin and end."""

    def __init__(self, program, deck, out=None):
        self.program = program
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="interrupted_"))
        (self.home / "deck.nml").write_text(deck, encoding="utf-8")
        self.out = out or self.home / "out"

    def start(self, *options, told="told", environment=None):
        with open(self.home / told, "wb") as errors:
            return subprocess.Popen([self.program, self.home / "deck.nml", "--output", self.out, "--threads", "2", *options],
                                    stdout=subprocess.DEVNULL, stderr=errors, stdin=subprocess.DEVNULL, env=environment)

    def told(self, told="told"):
        return (self.home / told).read_text(errors="replace")

    def files(self):
        return {str(p.relative_to(self.out)): p for p in self.out.rglob("*") if p.is_file()} if self.out.is_dir() else {}


def faults_of_files(place, whole, killed):
    """Files that are not what they look like; `whole` is the undisturbed run's."""
    faults = []
    for name, path in place.files().items():
        if name.endswith(UNFINISHED):
            if not killed:
                faults.append(f"{name} is left")
            continue
        if ".partial" in name or name == LIST or (killed and name == "pictures/gnuplot.log"):
            continue
        if name == LOCK:
            if not killed:
                faults.append("the lock is left")
            continue
        if name not in whole:
            faults.append(f"{name} is a stranger")
        elif name.endswith((".h5", ".html", ".hdf")):
            faults += faults_of(path.read_bytes(), name)
        elif name == "summary.csv":
            for row, good in zip(without_times(path), whole[name], strict=True):
                if row["status"] != "not_converged" and row != good:
                    faults.append(f"summary.csv: {row} instead of {good}")
                if row["status"] == "not_converged" and "ended by" not in row["message"]:
                    faults.append(f"summary.csv: marked without its reason, {row}")
        elif name == "limits.csv" or name.startswith("pictures"):
            if not path.read_bytes().strip():
                faults.append(f"{name} is empty")
        elif without_times(path) != whole[name]:
            faults.append(f"{name} is not that of the undisturbed run")
    return faults


def interrupted(program, deck, whole, seconds, rng):
    """One life of a run that is ended some times, with the faults found."""
    place, faults, story = Place(program, deck), [], []
    for _ in range(rng.choice([1, 1, 2, 3])):
        number = rng.choice(SIGNALS)
        process = place.start()
        after = rng.uniform(0.0, 1.05) * seconds
        time.sleep(after)
        process.send_signal(number)
        try:
            status = process.wait(TIME_LIMIT)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            return place, [*story, "does not end"]
        story.append(f"{number.name} after {after:.2f} s: {status}")
        killed = status in (-signal.SIGKILL, -number)     # a signal before the program watches for it ends it, too
        if status not in (0, 1) and not killed:
            faults.append(f"exit status {status}: {place.told()[:300]}")
        if status == 1 and "ended by SIG" not in place.told():
            faults.append(f"no word of the signal: {place.told()[:300]}")
        if "Backtrace" in place.told() or "rror termination" in place.told():
            faults.append(place.told()[:300])
        faults += faults_of_files(place, whole, killed)
        if faults:
            return place, [*story, *faults]
    process = place.start()
    status = process.wait(TIME_LIMIT)
    if status:
        faults.append(f"left alone: exit status {status}: {place.told()[:300]}")
    files = place.files()
    faults += [f"{name} is missing" for name in whole if name not in files]
    faults += [f"{name} is left over" for name in files if name not in whole]
    faults += [f"{name} is not that of the undisturbed run" for name in whole
               if name in files and not name.startswith("pictures") and without_times(files[name]) != whole[name]]
    return place, [*story, *faults] if faults else []


def two_runs(program, deck, whole, seconds, rng):
    """Two at once, by two paths; then parts, one of them twice."""
    place = Place(program, deck)
    other = place.out / ".." / place.out.name
    first = place.start()
    time.sleep(rng.choice([0.0, 0.0, 0.02, 0.1]))
    second = place.start("--output", other, told="second")
    ends = [(first.wait(TIME_LIMIT), place.told()), (second.wait(TIME_LIMIT), place.told("second"))]
    faults = []
    if sorted(status for status, _ in ends) not in ([0, 1], [0, 0]):     # one after the other, where the first ends at once
        faults.append(f"exit statuses {[status for status, _ in ends]}: {ends[0][1][:200]} {ends[1][1][:200]}")
    faults += [f"no word of who holds the folder: {told[:200]}" for status, told in ends if status == 1 and "in use by another run: process" not in told]
    faults += [f"{name} is left over" for name in place.files() if name not in whole]
    faults += [f"{name} is not that of the undisturbed run" for name in whole
               if name not in place.files() or not name.startswith("pictures") and without_times(place.files()[name]) != whole[name]]
    shutil.rmtree(place.out)
    runs = [(part, place.start("--part", f"{part}/3", told=f"part{i}")) for i, part in enumerate((1, 2, 3, rng.choice((1, 2, 3))))]
    status = [run.wait(TIME_LIMIT) for _, run in runs]
    if sum(status) > 1 or status[runs[3][0] - 1] + status[3] != sum(status):
        faults.append(f"parts: exit statuses {status}: {[place.told(f'part{i}')[:200] for i in range(4)]}")
    if place.start("--merge", "3").wait(TIME_LIMIT):
        faults.append(f"merge: {place.told()[:300]}")
    for name in ("sweep_s.csv", "uncertainty_u.csv"):
        if name not in place.files() or without_times(place.files()[name]) != whole[name]:
            faults.append(f"{name} of parts is not that of the undisturbed run")
    if LOCK in place.files():
        faults.append("the lock is left")
    return place, faults


def is_running(process):
    """Whether a process has not ended; one that nobody has waited for counts as ended."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def gnuplot_left(program, deck, *_):
    """Ends runs whose gnuplots hang, by one signal or by two of a kind."""
    place, faults = Place(program, deck.replace("plots = .false.", "plots = .true.")), []
    folder, numbers = place.home / "bin", place.home / "numbers"
    folder.mkdir()
    (folder / "gnuplot").write_text(f"#!/bin/sh\nsleep 60 &\necho $$ $! >>'{numbers}'\nwait\n", encoding="utf-8")
    (folder / "gnuplot").chmod(0o755)
    surroundings = dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}")
    for signals in ([signal.SIGKILL], [signal.SIGTERM], [signal.SIGINT], [signal.SIGTERM] * 2):
        numbers.write_text("")
        process = place.start(environment=surroundings)
        end = time.monotonic() + TIME_LIMIT
        while len(numbers.read_text().split()) < 4 and process.poll() is None and time.monotonic() < end:     # two gnuplots
            time.sleep(0.01)
        time.sleep(0.3)         # between the start of a gnuplot and that of its guard SIGKILL leaves it: milliseconds
        for number in signals:
            process.send_signal(number)
        process.wait(TIME_LIMIT)
        started = numbers.read_text().split()
        end = time.monotonic() + 5
        while any(map(is_running, started)) and time.monotonic() < end:
            time.sleep(0.01)
        left = list(filter(is_running, started))
        if len(started) < 4 or left:
            faults.append(f"{[s.name for s in signals]}: {len(started)} processes of gnuplot, {len(left)} left: {place.told()[:200]}")
        for one in left:
            os.kill(int(one), signal.SIGKILL)
    return place, faults


def other_names(program, deck, _, seconds, rng):
    place = Place(program, deck)
    process = place.start()
    time.sleep(rng.uniform(0.1, 1.0) * seconds)
    process.kill()
    process.wait(TIME_LIMIT)
    changed = deck.replace("'drill'", "'bore'").replace("'mcge', 'soft'", "'soft', 'rigid'")
    changed = changed.replace("&sweep name = 's'", "&sweep name = 'x'").replace("&uncertainty name = 'u'", "&uncertainty name = 'y'")
    fresh = Place(program, changed)
    (place.home / "deck.nml").write_text(changed, encoding="utf-8")
    faults = [f"exit status {status}" for status in (place.start().wait(TIME_LIMIT), fresh.start().wait(TIME_LIMIT)) if status]
    faults += [f"{name} is left over" for name in place.files() if name not in fresh.files() and not name.endswith(".partial")]
    faults += [f"{name} is not that of a fresh folder" for name, path in fresh.files().items()
               if name not in place.files() or not name.startswith("pictures") and without_times(place.files()[name]) != without_times(path)]
    shutil.rmtree(fresh.home)
    return place, faults


def folder_removed(program, deck, whole, seconds, rng):
    return after_removal(program, deck, whole, rng.uniform(0.1, 0.8) * seconds, lambda out: shutil.rmtree(out, ignore_errors=True))


def folder_emptied(program, deck, whole, seconds, rng):
    """As removal that meets a new file: the folder stays."""
    def empty(out):
        for path in filter(pathlib.Path.is_file, out.rglob("*")):
            path.unlink(missing_ok=True)
    return after_removal(program, deck, whole, rng.uniform(0.1, 0.8) * seconds, empty)


def after_removal(program, deck, whole, seconds, remove):
    place = Place(program, deck)
    process = place.start()
    time.sleep(seconds)
    remove(place.out)
    faster = process.poll() is not None
    status = process.wait(TIME_LIMIT)
    faults = []
    if status not in (0, 1) or (status == 1 and not place.told()):
        faults.append(f"exit status {status}: {place.told()[:300]}")
    if "Backtrace" in place.told() or "rror termination" in place.told():
        faults.append(place.told()[:300])
    if status == 0 and not faster and set(whole) - set(place.files()):
        faults.append(f"exit status 0 with {len(set(whole) - set(place.files()))} files missing")
    return place, faults + [fault for fault in faults_of_files(place, whole, False) if "is not that" in fault]


def mounted(folder, *options):
    """Whether a file system of its own could be mounted at a folder."""
    return subprocess.run(["mount", "-t", "tmpfs", *options, "tmpfs", folder], capture_output=True, check=False).returncode == 0


def picture(path):
    """A picture but for its time, its titles, which are put in when all are drawn, and empty groups of gnuplot's second picture."""
    return re.sub(rb"<title>[^<]*</title>|<g [^>]*>\n</g>\n", b"", without_times(path))


def pictures_on_full_disk(program, *_):
    """Disks of twelve sizes, the last with room for nearly all pictures: one that is there is whole."""
    deck = DECK[:DECK.index("&sweep")].format(plots=".true.", length=60.0).replace("'mcge', 'soft'", "'soft', hdf5 = .false.")
    place, faults = Place(program, deck), []
    if place.start().wait(TIME_LIMIT):
        return place, [place.told()]
    whole = {name: picture(path) for name, path in place.files().items() if name.endswith(".svg")}
    pages = sum(-(-path.stat().st_size // 4096) for path in place.files().values())
    page = -(-(place.out / "report.html").stat().st_size // 4096)
    shutil.rmtree(place.out)
    place.out.mkdir()
    for share in range(12):
        size = f"size={4 * round((pages - page) * (0.45 + 0.05 * share))}k"
        if not mounted(place.out, "-o", size):
            return place, None
        try:
            status = place.start().wait(TIME_LIMIT)
            faults += [f"{size}: {name} is cut" for name, path in place.files().items() if name in whole and picture(path) != whole[name]]
            if status != 1 or "No space left on device" not in place.told() or "report.html" not in place.told():
                faults.append(f"{size}: exit status {status}: {place.told()[:300]}")
            faults += [f"{size}: {name} is left" for name in place.files() if name.endswith(UNFINISHED) or name == LOCK]
        finally:
            subprocess.run(["umount", place.out], check=False)
    return place, faults


def read_only(program, deck, *_):
    """A folder that cannot be written to, empty, absent, or with results."""
    place = Place(program, deck)
    place.out.mkdir()
    if not mounted(place.out):
        return place, None
    faults = []
    try:
        for out in (place.out, place.out / "new/folder", place.out):
            held = sorted(place.files())
            subprocess.run(["mount", "-o", "remount,ro", place.out], check=True)
            status = place.start("--output", out).wait(TIME_LIMIT)
            if status != 1 or "Read-only file system" not in place.told() or sorted(place.files()) != held:
                faults.append(f"{out}: exit status {status}: {place.told()[:300]}")
            subprocess.run(["mount", "-o", "remount,rw", place.out], check=True)
            if not held and place.start().wait(TIME_LIMIT):
                faults.append(place.told()[:300])
    finally:
        subprocess.run(["umount", place.out], check=False)
    return place, faults


def disk_full(program, deck, whole, rng):
    """A small file system of its own as output folder, filled to a random degree; None where mounting is not allowed."""
    place = Place(program, deck)
    place.out.mkdir()
    size = rng.randrange(8, 1600, 4)
    if not mounted(place.out, "-o", f"size={size}k"):
        return place, None
    try:
        process = place.start()
        status = process.wait(TIME_LIMIT)
        story = [f"disk of {size} kB: exit status {status}"]
        faults = faults_of_files(place, whole, False)
        if status not in (0, 1):
            faults.append(f"exit status {status}")
        if status == 1 and not place.told():
            faults.append("no message")
        if status == 0 and set(whole) - set(place.files()):
            faults.append(f"exit status 0 without {sorted(set(whole) - set(place.files()))[:3]}")
        if "Backtrace" in place.told() or "rror termination" in place.told() or "HDF5-DIAG" in place.told():
            faults.append(place.told()[:300])
    finally:
        subprocess.run(["umount", place.out], check=False)
    return place, [*story, *faults] if faults else []


OTHER_LIVES = {"folder removed": folder_removed, "folder emptied": folder_emptied, "two runs": two_runs,
               "other names": other_names, "gnuplot left": gnuplot_left, "read only": read_only, "pictures on a full disk": pictures_on_full_disk}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=20, help="runs that are ended by signals")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--plots", action="store_true", help="with pictures, page and files for ParaView")
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    deck = DECK.format(plots=".true." if options.plots else ".false.", length=15.0)
    place = Place(program, deck)
    begin = time.monotonic()
    if place.start().wait(TIME_LIMIT):
        print(f"FAIL the undisturbed run: {place.told()}\n0 passed, 1 failed")
        return 1
    seconds = time.monotonic() - begin
    whole = {name: without_times(path) for name, path in place.files().items()}
    shutil.rmtree(place.home)
    print(f"undisturbed: {seconds:.1f} s, {len(whole)} files")
    passed = failed = skipped = 0
    lives = [("signals", seed) for seed in range(options.count)]
    lives += [(kind, 0) for kind in ("gnuplot left", "read only", "pictures on a full disk")]
    lives += [(kind, seed) for kind in ("folder removed", "folder emptied", "disk full", "two runs", "other names")
              for seed in range(max(1, options.count // 4))]
    for kind, seed in lives:
        rng = random.Random(f"{options.seed} {kind} {seed}")
        if kind == "signals":
            place, faults = interrupted(program, deck, whole, seconds, rng)
        elif kind in OTHER_LIVES:
            place, faults = OTHER_LIVES[kind](program, deck, whole, seconds, rng)
        else:
            place, faults = disk_full(program, deck, whole, rng)
        if faults is None:
            skipped += 1
        elif faults:
            failed += 1
            print(f"FAIL {kind} {seed} (kept in {place.home}): " + "; ".join(faults), flush=True)
            continue
        else:
            passed += 1
        shutil.rmtree(place.home, ignore_errors=True)
    if skipped:
        print(f"{skipped} file systems not tried: no right to mount")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())

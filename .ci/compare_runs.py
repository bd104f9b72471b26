#!/usr/bin/env python3
"""Compares what two programs make of the same decks: those of input/, and wells of a generator.

Both programs run with a clock that stands (LD_PRELOAD of a few lines of C: the date is constant, each reading of the
stopwatch adds a millisecond, memory is constant) and one thread. So the same work gives the same bytes.

  exact   exit status, standard output, standard error and every file of the results folder are equal byte by byte; only
          lines of drillgap_files.txt may come in another order
  close   exit status, names of files, numbers of rows and columns `status` are equal; hook load, torque and normal
          force of summary.csv and of sweeps are within 1e-7, columns of profiles within 1e-4 of the column's largest value

Of every deck, also of input/extremes/, `--check` is compared, and of those of input/ `--convert`.

Usage: compare_runs.py OLD NEW [--mode exact|close] [--generator FILE --number N [--first N]] [--keep FOLDER] [--only TEXT]
       FILE is a Python program that prints the deck of a seed: `FILE --deck SEED`.
"""
import argparse
import concurrent.futures
import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOTALS, PROFILES = 1.0e-7, 1.0e-4
SMALLEST = 1.0e-3       # differences of smaller values are relative to this part of the column's largest
TOTAL_COLUMNS = ("hookload_", "torque_", "normal_force_")
LIST = "drillgap_files.txt"
LIMIT = 900             # seconds a run
CLOCK = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
static __thread long readings;
static const time_t today = 1700000000;
time_t time(time_t *t) { if (t) *t = today; return today; }
int gettimeofday(struct timeval *restrict t, void *restrict zone) { (void)zone; t->tv_sec = today; t->tv_usec = 0; return 0; }
int clock_gettime(clockid_t clock, struct timespec *t) {
  long k = clock == CLOCK_REALTIME ? 0 : ++readings;
  t->tv_sec = today + k/1000; t->tv_nsec = k%1000*1000000; return 0; }
static const char *path_of(const char *path) {
  const char *memory = getenv("CONSTANT_MEMORY");
  return memory && !strcmp(path, "/proc/self/status") ? memory : path; }
#define OPEN(name) int name(const char *path, int flags, ...) { \
  static int (*next)(const char *, int, ...); va_list rest; mode_t mode = 0; \
  if (!next) next = dlsym(RTLD_NEXT, #name); \
  if (flags & (O_CREAT | O_TMPFILE)) { va_start(rest, flags); mode = va_arg(rest, mode_t); va_end(rest); } \
  return next(path_of(path), flags, mode); }
OPEN(open)
OPEN(open64)
"""


def standing_clock(folder):
    """Compiles the clock; the environment that a program needs for it."""
    (folder / "clock.c").write_text(CLOCK, encoding="utf-8")
    (folder / "status").write_text("VmSize:   40000 kB\nVmHWM:   20000 kB\nVmRSS:   20000 kB\n", encoding="utf-8")
    subprocess.run(["gcc", "-shared", "-fPIC", "-O1", "-o", folder / "clock.so", folder / "clock.c", "-ldl"], check=True)
    return {**os.environ, "LD_PRELOAD": str(folder / "clock.so"), "CONSTANT_MEMORY": str(folder / "status"), "OPENBLAS_NUM_THREADS": "1"}


def run(program, words, folder, environment):
    try:
        ended = subprocess.run([program, *words], cwd=folder, env=environment, capture_output=True, timeout=LIMIT, check=False)
        return {"exit status": str(ended.returncode).encode(), "standard output": ended.stdout, "standard error": ended.stderr}
    except subprocess.TimeoutExpired:
        return {"exit status": b"took too long"}


def outcome_of(program, deck, side, environment, whole):
    """All that a program tells and writes for a deck: name of the thing to bytes."""
    told = {f"--check, {k}": v for k, v in run(program, ["--check", deck], side, environment).items()}
    if not whole:
        return told
    told |= {f"--convert, {k}": v for k, v in run(program, ["--convert", deck], side, environment).items()}
    out = pathlib.Path("out") / pathlib.Path(deck).stem
    told |= run(program, [deck, "--output", out, "--threads", "1"], side, environment)
    told |= {str(path.relative_to(side / out)): path.read_bytes() for path in sorted((side / out).rglob("*")) if path.is_file()}
    if LIST in told:
        told[LIST] = b"\n".join(sorted(told[LIST].splitlines()))
    return told


def first_difference(old, new):
    a, b = old.splitlines(), new.splitlines()
    for number, (p, q) in enumerate(zip(a, b), 1):
        if p != q:
            return f"line {number}: {p[:120]!r}, now {q[:120]!r}"
    return f"{len(a)} lines, now {len(b)}"


def exact(old, new):
    faults = [f"{name} is {'new' if name in new else 'not there any more'}" for name in sorted(old.keys() ^ new.keys())]
    return faults + [f"{name}: {first_difference(old[name], new[name])}" for name in old.keys() & new.keys() if old[name] != new[name]]


def table(data):
    rows = list(csv.reader(data.decode("latin-1").splitlines()))
    return {name: [row[k] for row in rows[1:]] for k, name in enumerate(rows[0])} if rows else {}


def number(field):
    try:
        return float(field)
    except ValueError:
        return None


def columns_apart(old, new, tolerance, own):
    """Largest difference of two columns; relative to the value where own, else to the column's largest."""
    pairs = [(number(a), number(b)) for a, b in zip(old, new)]
    if any((a is None) != (b is None) for a, b in pairs):
        return "a number is absent on one side"
    pairs = [(a, b) for a, b in pairs if a is not None and b is not None]
    largest = max((abs(a) for a, _ in pairs), default=0.0)
    worst = max((abs(a - b)/(max(abs(a), SMALLEST*largest) if own else largest) for a, b in pairs if a != b and largest > 0.0), default=0.0)
    return f"differs by {worst:.1e}, more than {tolerance:.0e}" if worst > tolerance else ""


def close(old, new):
    faults = [f"{name} is {'new' if name in new else 'not there any more'}" for name in sorted(old.keys() ^ new.keys())]
    if old["exit status"] != new["exit status"]:
        faults.append("exit status differs")
    for name in sorted(old.keys() & new.keys()):
        if not name.endswith(".csv"):
            continue
        a, b = table(old[name]), table(new[name])
        if list(a) != list(b) or any(len(a[k]) != len(b[k]) for k in a):
            faults.append(f"{name}: other columns, or another number of rows")
            continue
        for column in a:
            fault = ""
            if column == "status":
                fault = "differs" if a[column] != b[column] else ""
            elif name.startswith("profile_"):
                fault = columns_apart(a[column], b[column], PROFILES, False)
            elif name.startswith(("summary", "sweep_")) and column.startswith(TOTAL_COLUMNS):
                fault = columns_apart(a[column], b[column], TOTALS, True)
            if fault:
                faults.append(f"{name}: {column} {fault}")
    return faults


def compare(deck, arguments, sides, environment):
    whole = not deck.startswith("input/extremes/")
    outcomes = [outcome_of(program, deck, side, environment, whole) for program, side in zip((arguments.old, arguments.new), sides)]
    faults = (close if arguments.mode == "close" and whole else exact)(*outcomes)
    if not arguments.keep:
        for side in sides:
            shutil.rmtree(side / "out" / pathlib.Path(deck).stem, ignore_errors=True)
    return faults, sum(map(len, outcomes[0].values()))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("new", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--mode", choices=("exact", "close"), default="exact")
    parser.add_argument("--generator", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--number", type=int, default=60)
    parser.add_argument("--keep", type=pathlib.Path, help="keeps what both wrote there")
    parser.add_argument("--only", default="", help="only decks whose path has this text")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or pathlib.Path(scratch)
        sides = [folder / "old", folder / "new"]
        shutil.copytree(ROOT / "input", pathlib.Path(scratch) / "decks/input")
        decks = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "input").rglob("*.nml"))
        if arguments.generator:
            (pathlib.Path(scratch) / "decks/wells").mkdir()
            for seed in range(arguments.first, arguments.first + arguments.number):
                deck = f"wells/well_{seed}.nml"
                text = subprocess.run([sys.executable, arguments.generator, "--deck", str(seed)], capture_output=True, check=True).stdout
                (pathlib.Path(scratch) / "decks" / deck).write_bytes(text)
                decks.append(deck)
        for side in sides:
            shutil.copytree(pathlib.Path(scratch) / "decks", side)
        decks = [deck for deck in decks if arguments.only in deck]
        environment, bad, size = standing_clock(pathlib.Path(scratch)), 0, 0
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for deck, (faults, some) in zip(decks, pool.map(lambda d: compare(d, arguments, sides, environment), decks)):
                size, bad = size + some, bad + bool(faults)
                for fault in faults[:8]:
                    print("FAULT", f"{deck}: {fault}", flush=True)
    print(f"{len(decks)} decks compared ({arguments.mode}), {bad} differ; {size/1e6:.0f} MB")
    return 1 if bad or not decks else 0


if __name__ == "__main__":
    sys.exit(main())

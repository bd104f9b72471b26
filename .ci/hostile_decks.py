#!/usr/bin/env python3
"""Feeds a built drillgap broken decks, data files and surroundings: it must refuse, mark or solve them, never crash or lie.

Usage: hostile_decks.py PATH_TO_DRILLGAP

A list of decks and surroundings, each with the exit status and message that it must bring: a truncated deck, binary bytes,
endless lines, huge counts, files that vanish, full disks, folders that cannot be written; fuzz.py draws such at random. Of
every run is asked (watched_run.py, run_results.py):

  exit status 0 to 3, and no signal, traceback, sanitizer's report or runtime message
  status 2      a message with file and line, and no output folder
  status 3      a row that says so
  status 0      every row converged or locked up, every number finite, forces in balance, profile and summary in agreement
  always        nothing written outside the output folder, no file under an unfinished name, memory and time bounded

The folder of a run that fails is kept. Ends in 'N passed, N failed'.
"""
import os
import pathlib
import resource
import signal
import sys

from run_results import faults_of_results
from watched_run import Run, bound_memory_of

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


def full_disk():
    """Writes beyond 2 kB fail, as on a full disk, instead of ending the program."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2048, 2048))


def memory_of(megabytes):
    """No more addresses than that, as by ulimit -v."""
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes * 1024 * 1024,) * 2)


def remove(name):
    return lambda home: (home / name).unlink()


def link(name, target):
    return lambda home: ((home / name).unlink(missing_ok=True), (home / name).symlink_to(target))


def linked_result(name, target):
    return lambda home: ((home / "out").mkdir(), (home / "out" / name).symlink_to(home / target))


def named_pipe(name):
    """A pipe with a name, into which nobody writes."""
    return lambda home: ((home / name).unlink(missing_ok=True), os.mkfifo(home / name))


def changed(old, new, base=SI_DECK):
    assert old in base, old
    return {"deck.nml": base.replace(old, new, 1), "wells/path.csv": SURVEY, "wells/other.csv": LEGACY}


def stranger_catalogue():
    """Collars from a catalogue of the user."""
    files = changed("'hostile'", "'hostile', catalogue_file = 'wells/pipes.csv'")
    return files | {"deck.nml": files["deck.nml"].replace("od = 165.1", "catalogue = 'a', od = 165.1")}


def listed():
    """(name, files, expected status, text or texts that the message must hold, keywords of Run)"""
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
    yield "100 lines of 98 kB", {**good, "deck.nml": SI_DECK + ("! " + "&<" * 49_000 + "\n") * 100}, 0, "", {}
    yield "200000 lines", {**good, "deck.nml": SI_DECK + "\n" * 200_000}, 0, "", {}
    yield "20000 groups", {**good, "deck.nml": SI_DECK + "&boundary /\n" * 20_000}, 2, "second time", {}
    yield "5000 cases", {**good, "deck.nml": SI_DECK + "".join(f"&load_case name='c{i}' operation='up' bit_depth=7e9 /\n" for i in range(5000))}, 2, "deck.nml:", {}
    yield "huge repeat count", changed("models = 'mcge', 'soft', 'rigid', 'mixed'", "models = 2000000000*'mcge'"), 2, "deck.nml:1", {}
    yield "large repeat count", changed("models = 'mcge'", "models = 999999*'mcge'"), 2, "deck.nml:1", {}
    yield "200000 stations", changed("survey_file = 'wells/path.csv'", "md = 200000*0.0, inc = 200000*0, azi = 200000*0"), 2, "deck.nml:2", {}
    yield "a deck without end", good, 2, "cannot be read", {"before": link("deck.nml", "/dev/zero")}
    yield "huge subscript", changed("density = 1200.0", "density(2000000000) = 1200.0"), 2, "deck.nml:5", {}
    yield "huge stations", {"deck.nml": FIELD_DECK.replace("azi=4*45", "azi=4*45, md(2000000000)=1")}, 2, "deck.nml:2", {}
    yield "duplicated key", changed("density = 1200.0", "density = 1200.0, density = 1300.0"), 2, "density", {}
    yield "duplicated group", {**good, "deck.nml": SI_DECK + "&boundary /\n" * 2}, 2, "second time", {}
    for number in ("NaN", "Infinity", "-Infinity", "1e400", "1e308", "-1e308"):
        yield f"mud of {number}", changed("density = 1200.0", f"density = {number}"), 2, "deck.nml:5", {}
        yield f"station at {number}", {**good, "wells/path.csv": SURVEY.replace("400", number)}, 2, "path.csv:5", {}
    yield "path in the name of a case", changed("name = 'up'", "name = '../../up'"), 2, "deck.nml:10", {}
    yield "path in a label", changed("label = 'other'", "label = '../other'"), 2, "deck.nml:14", {}
    yield "a name of 5000 letters", changed("name = 'up'", "name = '" + "u" * 5000 + "'"), 2, "deck.nml:10", {}
    for sign in ("=", "+", "-", "@", "\t", " ="):
        yield f"a title behind {sign!r}", changed("'hostile'", f"'{sign}1+1'"), 2, ("deck.nml:1: ", "A spreadsheet would run"), {}
        yield f"a section behind {sign!r}", changed("'up', operation", f"'up', section = '{sign}1', operation"), 2, "deck.nml:10: ", {}
    yield "signs inside names", changed("'hostile'", "'a=b+c-d@e'"), 0, "", {}
    yield "a catalogue with a formula", {**stranger_catalogue(), "wells/pipes.csv": "name,kind,od_mm\n=1+1,collar,165.1\na,collar,165.1\n"}, 2, (
        "pipes.csv:2: ", "A spreadsheet would run"), {}
    for letter in "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069":
        yield f"a name with U+{ord(letter):04X}", changed("'casing'", f"'a{letter}b'".encode().decode("latin-1")), 2, (
            "deck.nml:3: ", f"U+{ord(letter):04X}"), {}
    for bytes_ in ("\xff", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80"):
        yield f"a name of the bytes {bytes_!r}", changed("'casing'", f"'a{bytes_}'"), 2, ("deck.nml:3: ", "is not UTF-8"), {}
    yield "a commented row of the survey", {**good, "wells/path.csv": SURVEY.replace("400,", "#400,")}, 0, (
        "path.csv: rows skipped: 1 that begin with # (first in line 5)"), {}
    yield "survey vanished", good, 2, "path.csv: survey file cannot be opened", {"before": remove("wells/path.csv")}
    yield "legacy vanished", good, 2, "other.csv", {"before": remove("wells/other.csv")}
    yield "deck vanished", good, 2, "deck.nml", {"before": remove("deck.nml")}
    yield "deck a folder", {"deck.nml/x": ""}, 2, "folder", {}
    yield "deck links to itself", good, 2, "deck.nml", {"before": link("deck.nml", "deck.nml")}
    for what, name, files, place in (("deck", "deck.nml", good, "deck"), ("survey", "wells/path.csv", good, "deck.nml:2"),
                                     ("legacy", "wells/other.csv", good, "deck.nml:14"), ("catalogue", "wells/pipes.csv", stranger_catalogue(), "deck.nml:1")):
        for kind, before in (("a pipe", named_pipe(name)), ("a device", link(name, "/dev/zero")), ("a folder", link(name, "."))):
            yield f"{what} is {kind}", files, 2, (place, f"(it is {kind}"), {"before": before, "seconds": 10.0}
    yield "a device on standard input", good, 2, "(it is a device", {"arguments": ["/dev/stdin", "--output", "out"], "seconds": 10.0}
    yield "survey binary", {**good, "wells/path.csv": bytes(range(256)) * 40}, 2, "path.csv:", {}
    yield "survey empty", {**good, "wells/path.csv": ""}, 2, "path.csv", {}
    yield "survey without rows", {**good, "wells/path.csv": "md,inc,azi\n"}, 2, "path.csv", {}
    yield "survey of 5 MB in one line", {**good, "wells/path.csv": SURVEY + "1," * 2_500_000}, 2, "line 8 has more than", {}
    yield "survey of 5000 columns", {**good, "wells/path.csv": SURVEY.replace("\n", ",1" * 5_000 + "\n")}, 0, "", {}
    yield "survey of 5000 columns without names", {
        **good, "wells/path.csv": SURVEY.replace("0,0,10", "0,0," + "1," * 5_000)}, 2, "a number in column 4", {}
    yield "survey of a null azimuth", {**good, "wells/path.csv": SURVEY.replace(",41.0,15", ",41.0,-999.25")}, 2, "path.csv:6", {}
    yield "survey ragged", {**good, "wells/path.csv": SURVEY.replace(",41.0,15", "")}, 2, "path.csv:6", {}
    yield "survey turning back", {**good, "wells/path.csv": SURVEY.replace("600,", "300,")}, 2, "path.csv:6", {}
    yield "output is a file", good, 1, "File exists", {"arguments": [*out, "deck.nml"]}
    yield "output below a file", good, 1, "Not a directory", {"arguments": [*out, "deck.nml/out"]}
    yield "output not writable", good, 1, "cannot", {"arguments": [*out, "/proc/drillgap"]}
    yield "output an endless name", good, 1, "File name too long", {"arguments": [*out, "o" * 5000]}
    yield "a folder where a file is to be", good, 1, "summary.csv: Is a directory", {
        "before": lambda home: (home / "out/summary.csv").mkdir(parents=True)}
    for name, target, text in (("pictures", "wells", "pictures is a link to"), ("pictures", "nowhere", "pictures is a link to"),
                               ("pictures", "wells/path.csv", "pictures is a link to"), ("results.h5", "nowhere", "results.h5: link to"),
                               ("report.html", "deck.nml.bak", "report.html: link to"), ("limits.csv", "wells", "limits.csv: link to")):
        yield f"{name} a link to {target}", good, 1, text, {"before": linked_result(name, target)}
    yield "disk full", good, 1, "File too large", {"shell_limits": full_disk}
    yield "elements without number", changed("element_length = 30.0", "element_length = 0.01").copy() | {
        "wells/path.csv": SURVEY.replace("700,44.0", "49000,44.0"),
        "deck.nml": SI_DECK.replace("element_length = 30.0", "element_length = 0.01").replace("= 700.0", "= 49000.0")}, 2, "GB", {}
    if not Run.bounded:      # with sanitizers programs need terabytes
        return
    fine = SI_DECK.replace("element_length = 30.0", "element_length = 0.1")
    pipe = "&job models = 'soft', plots = .false. /\n" + SI_DECK[SI_DECK.index("&trajectory"):SI_DECK.index("&load_case")]
    case = "&load_case name = 'up', operation = 'up', bit_depth = 700.0, measured_hookload = 250.0 /\n"
    for name, deck, status, text in (
            ("a case", fine, 1, "fewer threads"),
            ("a sweep", pipe + "&sweep operations = 'up', bit_depth_to = 700, bit_depth_step = 0.001 /\n", 1, "ulimit -v"),
            ("an uncertainty", pipe + "&uncertainty operations = 'up', bit_depth_to = 700, bit_depth_step = 0.7, samples = 5000, "
             "friction_deviation = 0.02 /\n", 1, "fewer samples"),
            ("a study", pipe + case + "&study cases = 'up', models = 'mcge', element_lengths = 0.01, 5 /\n", 1, "larger element_length"),
            ("joints", pipe.replace("joint_od = 161.9", "joint_od = 161.9, joint_spacing = 0.1, joint_length = 0.05") + case
             + "&solver tool_joints = 'discrete' /\n", 1, "smeared"),
            ("a calibration", pipe + case + "&calibrate cases = 'up', separate = 'none' /\n", 1, "OPENBLAS_NUM_THREADS"),
            ("a sound deck", SI_DECK, 0, "")):
        yield f"{name} with 200 MB", {**good, "deck.nml": deck}, status, text, {"shell_limits": memory_of(200)}
    wells = {"wells/path.csv": "md,inc,azi\n" + "".join(f"{i * 0.002:.3f},10,0\n" for i in range(350_001))}
    for megabytes in (150, 200, 250, 300):
        yield f"350000 stations with {megabytes} MB", {**good, **wells}, 1, "ulimit -v", {"shell_limits": memory_of(megabytes)}


def main(program):
    program = str(pathlib.Path(program).resolve())
    bound_memory_of(program)
    passed, failed, outcomes = 0, 0, {}
    slowest, largest = (0.0, ""), (0, "")
    for name, files, status, text, more in listed():
        run = Run(program, files, **more)
        faults = run.faults()
        if run.status in (0, 3):
            faults += faults_of_results(run.out, run.status, run.deck.read_text(encoding="latin-1"))
        if run.status != status:
            faults.append(f"exit status {run.status}, expected {status}: {run.stderr[:300]}")
        for part in (text,) if isinstance(text, str) else text:
            if part not in run.stderr and part not in " ".join((run.stdout + run.stderr).split()):
                faults.append(f"no '{part}' in: {run.stderr[:300]}")
        slowest, largest = max(slowest, (run.seconds, name)), max(largest, (run.memory, name))
        outcomes[run.status] = outcomes.get(run.status, 0) + 1
        if faults:
            failed += 1
            print(f"FAIL {name} (kept in {run.home}): " + "; ".join(faults), flush=True)
        else:
            passed += 1
            run.tidy()
    print("exit statuses: " + ", ".join(f"{n} of {s}" for s, n in sorted(outcomes.items())))
    print(f"slowest: {slowest[0]:.1f} s, {slowest[1]}; largest: {largest[0] / 1000:.0f} MB, {largest[1]}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    sys.exit(main(sys.argv[1]))

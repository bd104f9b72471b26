#!/usr/bin/env python3
"""Pictures of a built drillgap under names and gnuplots that mean no good: nothing that a deck says is executed, no name is lost,
no half picture stands where a whole one should, nothing goes on after the run.

Usage: hostile_pictures.py PATH_TO_DRILLGAP

Names      a deck for each, in which calibrations, a hole section, a component, sections of load cases and the title have it:
           the run is sound, every picture is XML, the name stands in title and tics as it is, every mark of the data is there,
           and no file is made outside the results
Gnuplots   programs of that name on PATH that crash, fail, draw nothing, empty or cut pictures, fail at one picture, leave
           children: exit status 1 with a message, whole pictures only, and the page shows those
Signals    one SIGINT, SIGTERM or SIGHUP ends the run and all of a gnuplot that hangs
Data       panels without a number, where nothing converged or another program's table lies elsewhere, are no fault of gnuplot's
Around     GNUTERM, CDPATH, a start-up file and GNUPLOT_LIB of the user do not matter; nor does a parent that ignores SIGCHLD
Ends in 'N passed, N failed'.
"""
import argparse
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

TIME_LIMIT = 60
NAMES = ["Bob's fit", "a,b", 'x"y', r"a\b", "`touch made`", 'system("touch made")', "x@", "%s", "%", "{/Symbol a}", "a^2_b",
         "Größe ∑", "ends in \\", "tab\there", "#1", "' . system('touch made') . '", "'; system 'touch made'; x='", "''", "a'",
         "a'\\", "`", '"', '""', "$0", "<touch made", "|touch made", "!touch made", "NaN", "a-", "END", "\x01\x02", "\x1b[31m",
         "\x7f",
         "é" * 300, "y" * 5000, "'" * 7, "ab", "]]]>>", "&amp;<b>", "{", "}", "[", "first'", "../made", "a/b", "driller's 12-1/4", "Bob's =1", "%" + "a𝄞" * 12]
#: Marks of the two calibrations: legend, two factors before and after, an offset, three errors before and after.
MARKS = {"first": 2 + 4 + 6, "other": 2 + 4 + 1 + 6}
#: Pictures of a deck with names.
PICTURES = 12
MOST_OF_TIC, MOST_OF_TITLE, MOST_OF_FORMAT = 28, 200, 49
CONTROL = re.compile("[\x00-\x1f\x7f]")
PLAIN_DECK_NAME = "plain"

#: What a fake gnuplot knows: the names of the pictures that it was asked for, in $names.
FAKE = """#!/bin/sh
names=
for argument; do
  case $argument in *.gp) names="$names ${argument%.gp}" ;; esac
done
whole() { printf '<?xml version="1.0"?>\\n<svg>drawn\\n</svg>\\n\\n' > "$1.svg.unfinished"; }
"""
FAKES = {
    "crashes": "kill -SEGV $$\n",
    "fails": "echo no; exit 3\n",
    "draws nothing": "exit 0\n",
    "draws empty pictures": "for n in $names; do : > $n.svg.unfinished; done\n",
    "cuts pictures": "for n in $names; do printf '<?xml version=\"1.0\"?>\\n<svg>half' > $n.svg.unfinished; done\n",
    "looks whole but fails": "for n in $names; do whole $n; done; exit 1\n",
    "cannot be run": None,
}


def quoted(name):
    return "'" + name.replace("'", "''") + "'"


def deck(name):
    return f"""&job title = {quoted(name)}, models = 'soft', hdf5 = .false. /
&trajectory md = 0, 500, 900, inc = 0, 0, 30, azi = 3*10 /
&hole name = {quoted(name)}, md_bottom = 400, diameter = 220, friction = 0.25 /
&hole name = 'low', diameter = 215.9, friction = 0.3 /
&fluid density = 1200 /
&component name = {quoted(name)}, kind = 'collar', length = 100, od = 171.45, id = 71.4 /
&component od = 127, id = 108.6, joint_od = 168.3 /
&load_case name = 'u', section = {quoted(name)}, operation = 'up', bit_depth = 900, measured_hookload = 300 /
&load_case name = 'd', section = {quoted(name)}, operation = 'down', bit_depth = 900, measured_hookload = 200 /
&load_case name = 'r', operation = 'rotate_off_bottom', bit_depth = 900, measured_hookload = 230 /
&calibrate name = 'first', parameter = 'friction', separate = 'holes' /
&calibrate name = {quoted(name)}, parameter = 'friction', separate = 'holes', offset = 'depths' /
&solver element_length = 30 /
"""


class Place:
    """A folder with the deck of a name, in which the program runs."""

    def __init__(self, program, name=PLAIN_DECK_NAME):
        self.program = program
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="pictures_"))
        (self.home / "deck.nml").write_text(deck(name), encoding="utf-8")
        self.out = self.home / "out"
        self.environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        self.told = ""

    def use_gnuplot(self, body):
        """Puts a gnuplot of these lines first on PATH."""
        folder = self.home / "bin"
        folder.mkdir(exist_ok=True)
        path = folder / "gnuplot"
        path.write_text(FAKE + body if body is not None else "\x7fELF no program", encoding="utf-8")
        path.chmod(0o755)
        self.environment["PATH"] = f"{folder}:{os.environ['PATH']}"

    def start(self, *before, options=()):
        return subprocess.Popen([*before, self.program, "deck.nml", "--output", "out", *options], cwd=self.home,
                                env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def run(self, *before, options=()):
        return self.end_of(self.start(*before, options=options))

    def end_of(self, process):
        """Exit status; -1000 where the program does not end."""
        try:
            self.told = process.communicate(timeout=TIME_LIMIT)[1].decode(errors="replace")
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return -1000
        return process.returncode

    def pictures(self):
        return sorted(self.out.glob("pictures/*.svg*"))


def texts_of(path):
    return ["".join(e.itertext()) for e in xml.parse(path).iter("{http://www.w3.org/2000/svg}text")]


def cut(name, most):
    name = CONTROL.sub(" ", name).replace("]]>", "]])")
    return name if len(name) <= most else name[:most - 3] + "..."


def cut_tic(name):
    """Of a tic with a '%', which gnuplot takes for a format, it shows MOST_OF_FORMAT bytes."""
    most = MOST_OF_TIC
    while "%" in cut(name, most) and len(cut(name, most).encode()) > MOST_OF_FORMAT:
        most -= 1
    return cut(name, most)


def faults_of_pictures(place):
    """What is no picture among the pictures."""
    faults = []
    for path in place.pictures():
        try:
            xml.parse(path)
        except (xml.ParseError, OSError) as error:
            faults.append(f"{path.name}: {error}")
        if path.suffix != ".svg":
            faults.append(f"{path.name} is left")
    return faults


def faults_of_name(program, name):
    place, faults = Place(program, name), []
    status = place.run()
    faults += [f"{path} was made" for path in place.home.rglob("made*")]
    if status:
        return place, [*faults, f"fails: {place.told[:300]}"]
    faults += faults_of_pictures(place)
    scripts, pictures = place.out.glob("pictures/*.gp"), place.pictures()
    if {p.stem for p in scripts} - {"all"} != {p.stem for p in pictures} or len(pictures) != PICTURES:
        faults.append(f"{len(pictures)} pictures")
    for path in place.out.glob("pictures/calibration_*.svg") if not faults else []:
        own = "first" if path.stem == "calibration_first_soft" else "other"
        title = cut(f"Calibration {name if own == 'other' else 'first'}, model soft", MOST_OF_TITLE)
        shown = texts_of(path)
        faults += [f"{path.name}: no {text!r} in {shown}" for text in (title, cut_tic(name)) if text not in shown]
        marks = len(re.findall("<use xlink:href='#gpPt[0-9]+' transform='translate", path.read_text(encoding="utf-8")))
        if marks != MARKS[own]:
            faults.append(f"{path.name}: {marks} marks instead of {MARKS[own]}")
    return place, faults


def faults_of_failure(place, status, drawn):
    """After a gnuplot that failed: `drawn` whole pictures, told by the page."""
    faults = faults_of_pictures(place)
    if status != 1 or "pictures in out/pictures are drawn" not in place.told and "cannot start" not in place.told:
        faults.append(f"exit status {status}: {place.told[:300]}")
    if len(place.pictures()) != drawn:
        faults.append(f"{len(place.pictures())} pictures instead of {drawn}")
    page = (place.out / "report.html").read_text(encoding="utf-8")
    if page.count("<svg") > drawn or "are not drawn" not in page:
        faults.append(f"the page has {page.count('<svg')} pictures")
    return faults


def faults_of_fake(program, what):
    place = Place(program)
    place.use_gnuplot(FAKES[what])
    return place, faults_of_failure(place, place.run(), 0)


def one_bad_picture(program, body, drawn):
    """The true gnuplot, but for one picture."""
    place = Place(program)
    place.use_gnuplot(f"{body}exec {shutil.which('gnuplot')} \"$@\"\n")
    return place, faults_of_failure(place, place.run(), drawn)


def old_pictures(program):
    """Pictures of an earlier run do not stand for those that cannot be drawn."""
    place = Place(program)
    status = place.run()
    faults = [f"exit status {status}"] if status else []
    place.use_gnuplot("exit 0\n")
    faults += faults_of_failure(place, place.run(), 0)
    del place.environment["PATH"]
    faults += [f"exit status {status}"] if place.run() or len(place.pictures()) != PICTURES else []
    place.environment["PATH"] = "/nonexistent"
    if place.run() or place.pictures() or "no gnuplot here" not in place.told:
        faults.append(f"without gnuplot: {len(place.pictures())} pictures, {place.told[:300]}")
    return place, faults


def all_of(marker):
    """Processes whose command line holds a marker."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if marker.encode() in path.read_bytes():
                found.append(int(path.parent.name))
        except OSError:
            pass
    return found


def ended_by(program, number, body):
    """One signal while two gnuplots hang: the run ends at once with its pictures so far, they and their children, too."""
    place, faults = Place(program), []
    seconds = f"12345{place.home.name.encode().hex()[-8:].translate(str.maketrans('abcdef', '012345'))}"
    place.use_gnuplot(f"set -- $names; whole $1; : > ../begun_$1\n{body.format(seconds=seconds)}\n")
    process = place.start()
    until = time.monotonic() + TIME_LIMIT
    while len(list(place.out.glob("begun_*"))) < 2 and time.monotonic() < until:
        time.sleep(0.02)
    begin = time.monotonic()
    process.send_signal(number)
    status = place.end_of(process)
    took = time.monotonic() - begin
    if status != 1 or f"ended by {number.name}: 2 of {PICTURES} pictures" not in place.told:
        faults.append(f"exit status {status}: {place.told[:300]}")
    if took > TIME_LIMIT / 2:
        faults.append(f"ends after {took:.0f} s")
    time.sleep(0.2)
    faults += [f"{len(all_of(seconds))} processes go on"] if all_of(seconds) else []
    faults += faults_of_pictures(place)
    faults += [f"{name} of a run that was ended" for name in ("report.html", "pictures/gnuplot.log") if (place.out / name).exists()]
    for left in all_of(seconds):
        os.kill(left, signal.SIGKILL)
    return place, faults


def leaves_children(program):
    """A wrapper that ends well, but leaves a child that would write into a picture later."""
    place = Place(program)
    place.use_gnuplot(f"( sleep 1; echo more >> hookload.svg ) &\nexec {shutil.which('gnuplot')} \"$@\"\n")
    status = place.run()
    time.sleep(1.5)
    return place, ([f"exit status {status}: {place.told[:300]}"] if status else []) + faults_of_pictures(place)


def around(program, what):
    """Surroundings that led gnuplot astray: what is drawn is what is drawn without them."""
    place = Place(program)
    home = place.home / "home"
    home.mkdir()
    status = place.run()
    sound = {p.name: re.sub("<desc>.*</desc>", "", p.read_text(encoding="utf-8")) for p in place.pictures()}
    shutil.rmtree(place.out)
    before = ()
    if what == "GNUTERM":
        place.environment["GNUTERM"] = "nonsense"
    elif what == "start-up file":
        place.environment["HOME"] = str(home)
        (home / ".gnuplot").write_text(f"set print '{home}/made'\nprint 1\nset terminal dumb\nset logscale y\n", encoding="utf-8")
    elif what == "CDPATH":
        place.environment["CDPATH"] = str(home)
        (home / "out/pictures").mkdir(parents=True)
        (home / "out/pictures/all.gp").write_text(f"system 'touch {home}/made'\n", encoding="utf-8")
    elif what == "GNUPLOT_LIB":
        place.environment["GNUPLOT_LIB"] = str(home)
        place.environment["GNUPLOT_DRIVER_DIR"] = str(home)
    elif what == "SIGCHLD ignored":
        before = ("sh", "-c", "trap '' CHLD; exec \"$@\"", "sh")
    elif what == "PATH without folders":
        shutil.copy(shutil.which("gnuplot"), place.home / "gnuplot")
        place.environment["PATH"] = ":/nonexistent"
    status = status or place.run(*before)
    faults = [f"exit status {status}: {place.told[:300]}"] if status else []
    faults += [f"{path} was made" for path in place.home.rglob("made*")]
    for path in place.pictures():
        if re.sub("<desc>.*</desc>", "", path.read_text(encoding="utf-8")) != sound.get(path.name):
            faults.append(f"{path.name} is another picture")
    if len(place.pictures()) != len(sound):
        faults.append(f"{len(place.pictures())} pictures instead of {len(sound)}")
    return place, faults


def by_hand(program):
    """all.gp draws all again, run by a user."""
    place = Place(program)
    status = place.run()
    names = [p.name for p in place.pictures()]
    for path in place.pictures():
        path.unlink()
    drawn = subprocess.run(["gnuplot", "all.gp"], cwd=place.out / "pictures", capture_output=True, check=False)
    faults = faults_of_pictures(place)
    if status or drawn.returncode or [p.name for p in place.pictures()] != names:
        faults.append(f"{drawn.returncode}: {drawn.stderr[:300]}")
    return place, faults


def shared_names(program):
    """Calibrations whose files would have one name."""
    place = Place(program)
    names = ("2", "a/b", "a b", "4", "2_soft", "2_soft_2")
    rows = [f"&calibrate name = {quoted(name)}, parameter = 'friction' /\n" for name in names]
    text = re.sub("(?m)^&calibrate.*\n", "", deck(PLAIN_DECK_NAME)) + "".join(rows)
    (place.home / "deck.nml").write_text(text, encoding="utf-8")
    status = place.run()
    titles = {text for path in place.pictures() for text in texts_of(path) if text.startswith("Calibration ")}
    faults = [f"exit status {status}: {place.told[:300]}"] if status else []
    if len(titles) != len(rows):
        faults.append(f"pictures of {sorted(titles)} only")
    return place, faults


def lacking_data(program, what):
    """Empty pictures are left out, which the page tells. One of which a panel has something to show is drawn."""
    place = Place(program)
    text = re.sub("(?m)^&calibrate.*\n", "", deck(PLAIN_DECK_NAME))
    text += "&legacy label = 'l', case = 'u', file = 'l.csv' /\n"
    depths, wanted, pictures = "2000,300\n2900,0\n", 0, PICTURES - 2
    if what == "nothing converged":
        text = text.replace("'soft'", "'mcge'")
        text = text.replace("element_length = 30", "element_length = 30, fidelity = 'reference', max_iterations = 1")
        group = "operations = 'up', 'rotate_off_bottom', bit_depth_from = 800, bit_depth_step = 100"
        text += (f"&sweep name = 's', {group} /\n&uncertainty name = 's', {group}, samples = 2, friction_deviation = 0.1 /\n"
                 "&study element_lengths = 20, 30, cases = 'r' /\n"
                 "&calibrate name = 'c', parameter = 'friction', model = 'mcge' /\n")
        depths, wanted, pictures = "0,300\n900,0\n", 3, 4
    (place.home / "deck.nml").write_text(text, encoding="utf-8")
    (place.home / "l.csv").write_text("md,axial\n" + depths, encoding="utf-8")
    status = place.run()
    faults = [f"exit status {status}: {place.told[-300:]}"] if status != wanted or "gnuplot" in place.told else []
    if len(place.pictures()) != pictures:
        faults.append(f"{len(place.pictures())} pictures instead of {pictures}")
    if "Not drawn, as no value is known: " not in (place.home / "out/report.html").read_text(encoding="utf-8"):
        faults.append("the page does not tell what is not drawn")
    return place, faults + faults_of_pictures(place)


def joined_parts(program):
    """A run that joins parts draws what it joins."""
    place = Place(program)
    text = deck(PLAIN_DECK_NAME) + "&sweep name = 's', operations = 'up', bit_depth_from = 500, bit_depth_step = 100 /\n"
    (place.home / "deck.nml").write_text(text, encoding="utf-8")
    faults = []
    for option in (("--part", "1/2"), ("--part", "2/2"), ("--merge", "2")):
        status = place.run(options=option)
        faults += [f"{option}: exit status {status}: {place.told[:300]}"] if status else []
    names = [p.name for p in place.pictures()]
    return place, faults + ([] if names == ["sweep_s_soft.svg"] else [f"pictures {names}"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    program = str(pathlib.Path(parser.parse_args().program).resolve())
    hang, deaf = "sleep {seconds}", "trap '' TERM INT HUP; sleep {seconds} & sleep {seconds}; sleep {seconds}"
    tries = [(f"name {name[:40]!r}", faults_of_name, (name,)) for name in NAMES]
    tries += [(f"gnuplot {what}", faults_of_fake, (what,)) for what in FAKES]
    tries += [("one crash", one_bad_picture, ("case \"$names\" in *path_d*) kill -SEGV $$ ;; esac\n", PICTURES - 1)),
              ("one without picture", one_bad_picture, ("sed -i 's/^set output.*/unset output/' path_d.gp\n", PICTURES - 1)),
              ("one with a fault", one_bad_picture, ("sed -i '/^unset output/i plot nonsense' path_d.gp\n", PICTURES - 1)),
              ("an earlier run", old_pictures, ()), ("children", leaves_children, ()), ("by hand", by_hand, ()),
              ("shared names", shared_names, ()), ("joined parts", joined_parts, ())]
    tries += [(what, lacking_data, (what,)) for what in ("nothing converged", "legacy elsewhere")]
    tries += [(f"{number.name}, {kind}", ended_by, (number, body)) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
              for kind, body in (("hangs", "exec " + hang), ("with children", deaf))]
    tries += [(what, around, (what,)) for what in ("GNUTERM", "start-up file", "CDPATH", "GNUPLOT_LIB", "SIGCHLD ignored",
                                                    "PATH without folders")]
    passed = failed = 0
    for what, judge, arguments in tries:
        place, faults = judge(program, *arguments)
        if faults:
            failed += 1
            print(f"FAIL {what} (kept in {place.home}): " + "; ".join(faults)[:600], flush=True)
        else:
            passed += 1
            shutil.rmtree(place.home, ignore_errors=True)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

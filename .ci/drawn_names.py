#!/usr/bin/env python3
"""Pictures and the page of a built drillgap show every name of a deck as it is: all printable signs, all pairs of them.

Usage: drawn_names.py PATH_TO_DRILLGAP

Pairs    names that hold every pair of printable signs of ASCII and two letters beyond: as titles (calibrations) and as tics (hole
         sections); a picture shows each of them letter by letter
Places   names with quotes beside every sign, of hole sections and components: as labels along a depth axis, on the path, in the
         assembly, in a broomstick; what is drawn of a name is the name, or its beginning and '...'
Both     every picture and the page is UTF-8 and XML; the page has the same texts in its pictures, and every name in its own text
Ends in 'N passed, N failed'.
"""
import html.parser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

from hostile_pictures import MOST_OF_TIC, MOST_OF_TITLE, cut, cut_tic, quoted

SIGNS = [chr(code) for code in range(32, 127)] + ["é", "𝄞"]
CALIBRATIONS, HOLES_OF_EACH = 55, 7
TIME_LIMIT = 120
SVG_TEXT = "{http://www.w3.org/2000/svg}text"
#: Tags of HTML that have no end.
OPEN_TAGS = re.compile(r"<((?:meta|br|hr|img|col|wbr|input|link)\b[^>]*?)/?>")

#: Entities that HTML knows and XML does not.
ENTITY = re.compile(r"&(?!(?:amp|lt|gt|quot|apos);)[A-Za-z]+;")


def all_pairs():
    """Signs in an order in which every pair of them stands once (an Euler circuit)."""
    left = {sign: list(SIGNS) for sign in SIGNS}
    path, circuit = [SIGNS[0]], []
    while path:
        if left[path[-1]]:
            path.append(left[path[-1]].pop())
        else:
            circuit.append(path.pop())
    return "".join(reversed(circuit))


def pieces(text, length):
    """Pieces of a text that overlap by one sign, between letters: no blank is first or last, no spreadsheet's sign first."""
    return ["n" + text[first:first + length - 2] + "z" for first in range(0, len(text) - 1, length - 3)]


def deck_of_pairs():
    """The deck, the titles and the tics that it must bring."""
    text = all_pairs()
    names = pieces(text, MOST_OF_TITLE - len("Calibration , model soft"))
    holes = pieces(text, MOST_OF_TIC) + ["%" + "a"*number + "𝄞"*24 for number in range(4)]
    assert len(names) <= CALIBRATIONS and len(holes) <= CALIBRATIONS*HOLES_OF_EACH, (len(names), len(holes))
    names += [f"more {number}" for number in range(len(names), CALIBRATIONS)]
    lines = ["&job models = 'soft', hdf5 = .false., profiles = .false. /",
             "&trajectory md = 0, 500, 900, inc = 0, 0, 30, azi = 3*10 /"]
    for number, name in enumerate(holes, start=1):
        bottom = "" if number == len(holes) else f"md_bottom = {2*number}, "
        lines.append(f"&hole name = {quoted(name)}, {bottom}diameter = 215.9, friction = 0.3 /")
    lines += ["&fluid density = 1200 /", "&component od = 127, id = 108.6 /", "&solver element_length = 30 /"]
    for depth in range(830, 901, 10)[:HOLES_OF_EACH + 1]:
        lines.append(f"&load_case name = 'up_{depth}', operation = 'up', bit_depth = {depth}, measured_hookload = {depth/3:.0f} /")
    for number, name in enumerate(names):
        mine = holes[number*HOLES_OF_EACH:(number + 1)*HOLES_OF_EACH] or holes[:1]
        lines.append(f"&calibrate name = {quoted(name)}, parameter = 'friction', separate = 'holes', holes = "
                     + ", ".join(quoted(hole) for hole in mine) + " /")
    titles = [cut(f"Calibration {name}, model soft", MOST_OF_TITLE) for name in names]
    return "\n".join(lines) + "\n", [*titles, *(cut_tic(hole) for hole in holes)], [*names, *holes]


def deck_of_places():
    """The deck and its names; each begins with a word of its own."""
    beside = "".join(f"{sign}'" for sign in SIGNS if sign != "'") + "''"
    parts = [beside[first:first + 16] for first in range(0, len(beside), 16)]
    holes = [f"h{number:02d}{part}z" for number, part in enumerate(parts)]
    components = [f"c{number:02d}{part}z" for number, part in enumerate(parts)]
    lines = ["&job models = 'mcge', hdf5 = .false. /", "&trajectory md = 0, 500, 900, inc = 0, 0, 30, azi = 3*10 /"]
    for number, name in enumerate(holes, start=1):
        bottom = "" if number == len(holes) else f"md_bottom = {65*number}, "
        lines.append(f"&hole name = {quoted(name)}, {bottom}diameter = {300 - 5*number}, friction = 0.3 /")
    lines.append("&fluid density = 1200 /")
    for number, name in enumerate(components, start=1):
        size = "" if number == len(components) else f"length = {8 if number < 7 else 60}, "
        lines.append(f"&component name = {quoted(name)}, {size}od = {150 - number}, id = 71.4 /")
    lines += ["&load_case name = 'up', operation = 'up', bit_depth = 900 /", "&solver element_length = 30 /",
              "&sweep name = 's', operations = 'up', bit_depth_from = 500, bit_depth_step = 200, model = 'soft' /"]
    return "\n".join(lines) + "\n", holes, components


class Words(html.parser.HTMLParser):
    """Texts of a page."""

    def __init__(self):
        super().__init__()
        self.texts = []

    def handle_data(self, data):
        self.texts.append(data)


def run(program, deck):
    """Folder, faults, texts of each picture by name, and those of the page's pictures and of the page."""
    home = pathlib.Path(tempfile.mkdtemp(prefix="names_"))
    (home / "deck.nml").write_text(deck, encoding="utf-8")
    done = subprocess.run([program, "deck.nml", "--output", "out", "--quiet"], cwd=home, capture_output=True, timeout=TIME_LIMIT,
                          env={**os.environ, "OMP_NUM_THREADS": "1"}, check=False)
    faults = [f"exit status {done.returncode}: {done.stderr[:300]}"] if done.returncode else []
    drawn, inline, page = {}, [], ""
    for path in sorted(home.glob("out/pictures/*.svg")):
        try:
            drawn[path.stem] = ["".join(e.itertext()) for e in xml.fromstring(path.read_text(encoding="utf-8")).iter(SVG_TEXT)]
        except (xml.ParseError, UnicodeDecodeError) as error:
            faults.append(f"{path.name}: {error}")
    try:
        source = (home / "out/report.html").read_text(encoding="utf-8")
        words = Words()
        words.feed(source)
        page = "\n".join(words.texts)
        source = re.sub(r"<script.*?</script>", "", source, flags=re.S)
        whole = ENTITY.sub(lambda found: html.unescape(found.group()), OPEN_TAGS.sub(r"<\1/>", source))
        inline = ["".join(e.itertext()) for e in xml.fromstring(whole).iter(SVG_TEXT)]
    except (OSError, xml.ParseError, UnicodeDecodeError) as error:
        faults.append(f"report.html: {error}")
    if not drawn:
        faults.append("no pictures")
    return home, faults, drawn, inline, page


def faults_of_pairs(program):
    deck, texts, names = deck_of_pairs()
    home, faults, drawn, inline, page = run(program, deck)
    there = {text for picture in drawn.values() for text in picture}
    faults += [f"not drawn: {text!r}" for text in texts if text not in there]
    faults += [f"not in the page's pictures: {text!r}" for text in texts if text not in inline]
    faults += [f"not in the page: {name!r}" for name in names if name not in page]
    return home, len(texts), faults


def faults_of_places(program):
    deck, holes, components = deck_of_places()
    home, faults, drawn, inline, page = run(program, deck)
    names = {name[:3]: name for name in (*holes, *components)}
    seen = 0
    for what, picture in (*drawn.items(), ("report.html", inline)):
        for text in picture:
            name = names.get(text[:3])
            if name is None:
                continue
            seen += 1
            whole = re.sub(r", [0-9.]+ m$", "", text)
            if whole != cut(name, len(whole)) and not (text.endswith("...") and f"{name}, ".startswith(text[:-3])):
                faults.append(f"{what} has {text!r} instead of {name!r}")
    for what, kinds in (("path_up", "hc"), ("forces_up", "h"), ("assembly_up", "c"), ("sweep_s_soft", "h")):
        faults += [f"{what} shows no name of {kind}..." for kind in kinds
                   if not any(re.match(kind + "[0-9][0-9]", text) for text in drawn.get(what, []))]
    faults += [f"not in the page: {name!r}" for name in names.values() if name not in page]
    return home, seen, faults


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve())
    failed = 0
    judges = (("pairs", faults_of_pairs), ("places", faults_of_places))
    for what, judge in judges:
        home, texts, faults = judge(program)
        print(f"{what}: {texts} texts, {len(faults)} faults")
        if faults:
            failed += 1
            print(f"FAIL {what} (kept in {home}): " + "; ".join(faults[:5]), flush=True)
        else:
            shutil.rmtree(home, ignore_errors=True)
    print(f"{len(judges) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

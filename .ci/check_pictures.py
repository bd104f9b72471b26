#!/usr/bin/env python3
"""Keeps the pictures that README.md and output/README.md show true: they are those of the sample decks, drawn anew and compared by all their texts
(titles, axes, tics, names of curves). Those of the study have seconds on an axis: there only titles and names are compared.
No text of any picture in the folders is cut or lies on another. Each picture has one title, in words, with that of the run.
Each page is opened, in field units, without a complaint of the browser; all its curves are those of the CSV files.

Usage: check_pictures.py [--write] FOLDER...     folders of results, each named as its deck or given as DECK=FOLDER
"""
import html
import pathlib
import re
import shutil
import sys
import xml.etree.ElementTree as xml

from browser import View, opened
from check_page import CURVES, WIDTHS, faults_of_curves, faults_of_labels, views_of_labels

SHOWN = pathlib.Path("output/examples")
PAGE = '<html><head><meta charset="utf-8"><title></title></head><body>{}</body></html>'
NUMBER = re.compile(r"[-+]?[0-9.]+(e[-+]?[0-9]+)?")


def elements(path, name):
    """Contents of all elements of a picture that have this name."""
    return [element.text or "" for element in xml.parse(path).iter("{http://www.w3.org/2000/svg}" + name)]


def texts(path):
    found = elements(path, "title") + elements(path, "text")
    return [text for text in found if not NUMBER.fullmatch(text.strip())] if "study_" in path.name else found


def faults_of_titles(folder):
    """A picture says in its title what it shows, and of which run."""
    run = re.search(r"<title>(.*?)</title>", (folder / "report.html").read_text(encoding="utf-8"), re.S).group(1)
    faults = []
    for path in sorted((folder / "pictures").glob("*.svg")):
        titles = elements(path, "title")
        if len(titles) != 1 or path.stem in titles[0] or not titles[0].endswith(". " + html.unescape(run)):
            faults.append(f"{path}: titles {titles}")
    return faults


def main(arguments):
    write = "--write" in arguments
    folders = {}
    for argument in arguments:
        deck, mark, folder = argument.partition("=")
        if argument != "--write":
            folders[deck if mark else pathlib.Path(deck).name] = pathlib.Path(folder if mark else deck)
    named = sorted({name for readme in ("README.md", "output/README.md")
                    for name in re.findall(r"\]\((?:output/)?examples/(\S+\.svg)\)", pathlib.Path(readme).read_text(encoding="utf-8"))})
    faults = [] if named else ["README.md and output/README.md show no picture"]
    for name in named:
        deck = max((d for d in folders if name.startswith(d + "_")), key=len, default=None)
        if deck is None:
            faults.append(f"{name}: no results of its deck among {sorted(folders)}")
            continue
        fresh, kept = folders[deck] / "pictures" / name[len(deck) + 1:], SHOWN / name
        if not fresh.exists():
            faults.append(f"{name}: the run of {deck} draws no {fresh.name}")
        elif write:
            shutil.copyfile(fresh, kept)
        elif not kept.exists() or texts(kept) != texts(fresh):
            faults.append(f"{kept} is not what the run of {deck} draws; check_pictures.py --write brings it up to date")
    faults += [f"{p}: neither README.md nor output/README.md shows it" for p in SHOWN.glob("*") if p.name not in named]
    count, views = 0, {}
    for deck, folder in folders.items():
        faults += faults_of_titles(folder)
        drawn = [p.read_text(encoding="utf-8").partition("<svg") for p in sorted((folder / "pictures").glob("*.svg"))]
        page = PAGE.format("".join(f'<div class="drawn" style="width:1120px"><svg{rest}</div>' for _, _, rest in drawn))
        views |= {(deck, "page"): View(folder / "report.html", "units=field", "''"), (deck, "curves"): View(folder / "report.html", script=CURVES)}
        views[deck, "labels"] = views_of_labels(page, WIDTHS[:1])[0]
        count += len(drawn)
    for (deck, what), (told, complaints) in zip(views, opened(views.values())):
        if what == "labels":
            faults += [f"{deck}: {fault}" for fault in faults_of_labels(told, WIDTHS[0])]
        elif what == "curves":
            faults += [f"{deck}: {fault}" for fault in faults_of_curves(folders[deck], told, complaints)]
        else:
            faults += [f"{deck}: the browser complains of its page: {c}" for c in complaints]
    print(f"{len(named)} pictures shown, labels of {count} looked at")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

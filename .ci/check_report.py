#!/usr/bin/env python3
"""Checks report.html and the pictures of a run: each picture is sound XML, the page refers to nothing outside itself, and a
real browser without a screen shows it: tables and pictures there, nothing beyond its right edge.

Usage: check_report.py RESULTS_FOLDER SCREENSHOT   (needs chromium, and Python with matplotlib)
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

from matplotlib.image import imread

WIDTH, HEIGHT = 1240, 6000          # px: room for the tables and the first pictures
MARGIN = 4                          # px at the right edge that must stay empty
CURVE_COLOURS = {"first curve": (0, 114, 178), "second curve": (213, 94, 0)}
FEWEST_PIXELS = 500                 # of each: a curve across one panel has more


def faults_of_files(folder):
    page = (folder / "report.html").read_text(encoding="utf-8")
    faults = []
    pictures = sorted((folder / "pictures").glob("*.svg"))
    scripts = sorted(p for p in (folder / "pictures").glob("*.gp") if p.stem != "all")
    if [p.stem for p in pictures] != [p.stem for p in scripts]:
        faults.append("not every script has its picture")
    for picture in pictures:
        texts = [t.text for t in xml.parse(picture).iter("{http://www.w3.org/2000/svg}text")]
        if not texts:
            faults.append(f"{picture}: no text")
    if page.count("<svg") != len(pictures) or not pictures:
        faults.append(f"{page.count('<svg')} pictures in the page, {len(pictures)} in the folder")
    bare = page.replace("http://www.w3.org/", "")
    faults += [f"the page refers to {found}" for found in set(re.findall(r"https?://\S+", bare))]
    faults += [f"the page has {found}" for found in set(re.findall(r"<script|<link|\ssrc=|url\(|@import", bare))]
    names = re.findall(r"\sid=['\"]([^'\"]+)", page)
    marks = [name for name in names if "gpPt" in name]
    if len(marks) != len(set(marks)):
        faults.append("two pictures of the page share names of marks")
    for word in ("<h2>Limits</h2>", "<h3>Assumptions</h3>", "<h2>Deck</h2>", "&amp;load_case"):
        if word not in page:
            faults.append(f"the page lacks {word}")
    return faults


def faults_of_screen(folder, screenshot):
    screenshot.unlink(missing_ok=True)
    with tempfile.TemporaryDirectory() as home:
        run = subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={home}",
                              "--hide-scrollbars", f"--window-size={WIDTH},{HEIGHT}", f"--screenshot={screenshot.resolve()}",
                              (folder / "report.html").resolve().as_uri()], capture_output=True, text=True, timeout=240, check=False)
    if run.returncode != 0 or not screenshot.exists():
        return ["the browser made no screenshot: " + run.stderr[-500:]]
    shot = (imread(screenshot)[:, :, :3] * 255).round().astype(int)
    faults = []
    if shot.shape[:2] != (HEIGHT, WIDTH):
        faults.append(f"the screenshot has {shot.shape}")
    if (shot[:, -MARGIN:] != 255).any():
        faults.append("something reaches beyond the right edge")
    for name, colour in CURVE_COLOURS.items():
        pixels = int((abs(shot - colour).max(axis=2) < 12).sum())
        print(f"{name}: {pixels} pixels")
        if pixels < FEWEST_PIXELS:
            faults.append(f"only {pixels} pixels of the {name} are shown")
    return faults


def main():
    folder, screenshot = map(pathlib.Path, sys.argv[1:])
    faults = faults_of_files(folder) + faults_of_screen(folder, screenshot)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Checks report.html and the pictures of a run: each picture is sound XML, the page refers to nothing outside itself, and a
real browser without a screen shows it: tables and pictures there, nothing beyond its right edge. Printed on A4 and Letter it
has every column heading of every table and every line of deck and tables whole, and no heading apart from what it stands over.
Its first sheet stands alone.

Usage: check_report.py RESULTS_FOLDER SCREENSHOT   (needs chromium, and Python with matplotlib and pypdf)
"""
import csv
import html
import pathlib
import re
import sys
import tempfile
import unicodedata
import xml.etree.ElementTree as xml

from matplotlib.image import imread
from pypdf import PdfReader

from browser import browser

WIDTH, HEIGHT = 1240, 6000          # px: room for the tables and the first pictures
MARGIN = 4                          # px at the right edge that must stay empty
CURVE_COLOURS = {"first curve": (0, 114, 178), "second curve": (213, 94, 0)}
FEWEST_PIXELS = 500                 # of each: a curve across one panel has more
PAPERS = {"A4": (842, 595), "Letter": (792, 612)}    # pt, lying broad
LEAST_LETTER = 0.3                  # width of a letter over its height, at least
GOVERNING = "_sliding_2075"         # load case of GP1 that is nearest to a limit
FIXED = 5                           # pictures of the page for where there is no script: of the run, and of that load case
MOST_SHEETS = 10
#: Verdict, well, string and chart of GP1, answers nearest to a limit, a line on the others, notes: they stand on the first sheet.
FIRST_SHEET = ("Can it be done?", "Nearest to a limit: 'sliding_2075'", "Well to 3190 m, true vertical depth 2006.5 m", "Largest inclination 86 deg",
               "dogleg 3 deg/30 m", "Non-magnetic collar 158.8 mm, two joints 19 158.8 124.04", "sliding_2075 mcge", "effective axial force [kN]", "7 more below, all yes, at most 28.7 % of a limit used.", "top drive, fatigue.")
#: Answers of GP1 on paper in their order: five, then, behind the line on the others, the sixth.
NEAREST = ("sliding_2075", "sliding_3190", "up_2770", "up_3190", "up_2075", "down_2075")
#: Values, limits, fluid and hole on paper.
LIMITS = ("Along the string: sliding_2075 mcge", "least safety factor", "neutral point", "WOB at lock-up", "largest von Mises", "fluid 1200 kg/m3", "hole: 0 to 3190 m, diameter 215.9 mm")
TASK = {"up": "Trip out", "down": "Trip in", "sliding": "Sliding drilling"}


def rows_of(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def faults_of_summary(folder, page):
    """What the page tells in short, worked out anew from the files."""
    short = re.search(r"<h2>In short</h2>(.*?)</ul>", page, re.S)
    if not short:
        return ["the page does not begin in short"]
    told = html.unescape(re.sub(r"<[^>]*>", "", short.group(1)))
    solved = [row for row in rows_of(folder / "summary.csv") if row["model"] == "mcge" and row["status"] == "converged"]
    loads = sorted(solved, key=lambda row: float(row["hookload_kN"]))
    worst = max((row for row in solved if row["error_pct"]), key=lambda row: float(row["error_pct"]))
    wanted = [f"from {float(loads[0]['hookload_kN']):.4g} kN ({loads[0]['case']}) to {float(loads[-1]['hookload_kN']):.4g} kN",
              f"met within {float(worst['error_pct']):.3g} %; the worst is {worst['case']}"]
    return [f"in short, the page does not tell '{text}'" for text in wanted if text not in told]


def faults_of_answers(folder, page):
    """The first block of the page: an answer for each row of mcge, with the limit that decides and what was not checked."""
    first = re.search(r"<h2>(.*?)</h2>(.*?)<h2>", page, re.S)
    if not first or not first.group(1).startswith("Can it be done?"):
        return ["the page does not begin with 'Can it be done?'"]
    table = first.group(2).partition('<table class="answers">')[2].partition("</table>")[0]
    rows = [html.unescape(re.sub(r"<[^>]*>", " ", row)) for row in re.findall(r'<tr(?! class="more")[^>]*>(.*?)</tr>', table, re.S)]
    cases = [row for row in rows_of(folder / "summary.csv") if row["model"] == "mcge"]
    faults = [] if len(rows) == len(cases) else [f"{len(rows)} answers for {len(cases)} rows of summary.csv"]
    for case, told in zip(cases, rows):
        answer = {"no": "NO"}.get(case["can_be_done"], case["can_be_done"])
        wanted = [f" {case['case']} ", f" {answer} "]
        if case["can_be_done"] == "yes":
            wanted += [f"{float(case['used_pct']):.3g} % "]
        else:
            wanted += [case["reason"]]
        faults += [f"the answer for {case['case']} does not tell '{text}': {told}" for text in wanted if text not in told]
    if any(case["not_checked"] for case in cases) and "NOT CHECKED, as the deck gives no limit: " not in first.group(2):
        faults += ["the page does not tell which limits were not checked"]
    return faults


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
    fixed = [p for p in pictures if p.stem == "hookload" or p.stem.endswith(GOVERNING)]
    if page.count("<svg") != len(fixed) or len(fixed) != FIXED:
        faults.append(f"{page.count('<svg')} pictures in the page, {len(fixed)} of the run and of {GOVERNING} in the folder")
    bare = page.replace("http://www.w3.org/", "")
    faults += [f"the page refers to {found}" for found in set(re.findall(r"https?://\S+", bare))]
    scripts = re.findall(r"<script[^>]*>", bare)
    if scripts != ['<script type="application/json" id="data">', "<script>"]:
        faults.append(f"the page has scripts {scripts}")
    bare = re.sub(r"<script.*?</script>", "", bare, flags=re.S)
    faults += [f"the page has {found}" for found in set(re.findall(r"<link|\ssrc=|url\(|@import", bare))]
    names = re.findall(r"\sid=['\"]([^'\"]+)", page)
    marks = [name for name in names if "gpPt" in name]
    if len(marks) != len(set(marks)):
        faults.append("two pictures of the page share names of marks")
    opened = page.count("<details>") + page.count('<p class="data">')
    if opened != len(fixed):
        faults.append(f"{opened} pictures of {len(fixed)} have their numbers")
    faults += [f"the page links to {name}, which is not there" for name in set(re.findall(r'<a href="([^"]*)"', page))
               if not name.startswith("#") and not (folder / name).exists()]
    if "prefers-color-scheme:dark" not in page:
        faults.append("no dark form")
    faults += faults_of_summary(folder, page)
    faults += faults_of_answers(folder, page)
    for word in (">Limits</summary>", "<h3>Assumptions</h3>", ">Deck</summary>", "&amp;load_case"):
        if word not in page:
            faults.append(f"the page lacks {word}")
    return faults


def faults_of_screen(folder, screenshot):
    screenshot.unlink(missing_ok=True)
    run = browser("--hide-scrollbars", f"--window-size={WIDTH},{HEIGHT}", f"--screenshot={screenshot.resolve()}",
                  (folder / "report.html").resolve().as_uri())
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


def squeezed(text):
    """Without tags, blanks, ligatures: a browser breaks lines and joins letters where it likes."""
    return unicodedata.normalize("NFKC", re.sub(r"\s+", "", html.unescape(re.sub(r"<[^>]*>", "", text))))


def sheets_of(pdf, faults):
    """Text of each sheet without blanks. What begins or ends beyond the sheet is a fault."""
    sheets = []
    for sheet in PdfReader(pdf).pages:
        parts = []
        width = float(sheet.mediabox.width)

        def keep(text, outer, inner, _font, size):
            if not text.strip():
                return
            parts.append(text)
            left = inner[4] * outer[0] + inner[5] * outer[2] + outer[4]
            right = left + len(text.strip()) * LEAST_LETTER * size * abs(inner[0] * outer[0])
            if left < 0 or right > width:
                faults.append(f"beyond the sheet: {text.strip()!r}")

        sheet.extract_text(visitor_text=keep)
        sheets.append(squeezed(html.escape("".join(parts))))
    return sheets


def faults_of_paper(folder, paper):
    page = (folder / "report.html").read_text(encoding="utf-8")
    whole_page, folded = page, None
    while folded != page:               # closed on paper, one in another
        folded, page = page, re.sub(r"<details[^>]*>(?:(?!<details).)*?</details>", "", page, flags=re.S)
    faults = []
    with tempfile.TemporaryDirectory() as scratch:
        copy, pdf = pathlib.Path(scratch) / "page.html", pathlib.Path(scratch) / "page.pdf"
        if page.count("@page{size:landscape") != 1:
            return ["the page does not say how paper lies"]
        copy.write_text(whole_page.replace("@page{size:landscape", f"@page{{size:{paper} landscape"), encoding="utf-8")
        run = browser("--no-pdf-header-footer", f"--print-to-pdf={pdf}", copy.as_uri())
        if run.returncode != 0 or not pdf.exists():
            return ["the browser printed nothing: " + run.stderr[-500:]]
        size = PdfReader(pdf).pages[0].mediabox
        if (round(size.width), round(size.height)) != PAPERS[paper]:
            faults.append(f"sheets of {size}")
        sheets = sheets_of(pdf, faults)
    whole = "".join(sheets)
    tables = re.findall(r"<thead>(.*?)</thead>", page, re.S)
    lines = [squeezed(line) for text in re.findall(r"<pre[^>]*>(.*?)</pre>", page, re.S) for line in text.splitlines()]
    faults += [f"a table lacks columns: {squeezed(head)}" for head in tables if squeezed(head) not in whole]
    faults += [f"no such line: {line}" for line in lines if line not in whole]
    title = squeezed(re.search(r"<title>(.*?)</title>", page, re.S).group(1))
    headings = [squeezed(text) for text in re.findall(r"<h[123]>(.*?)</h[123]>", page, re.S)]
    for number, sheet in enumerate(sheets, 1):
        foot = f"{number}/{len(sheets)}"
        if title not in sheet or foot not in sheet:
            faults.append(f"sheet {number} lacks title or number")
        if sheet.replace(foot, "").endswith(tuple(headings)):
            faults.append(f"sheet {number} ends with a heading")
    faults += [f"the first sheet lacks {text}" for text in FIRST_SHEET if squeezed(text) not in sheets[0]]
    faults += [f"paper lacks {text}" for text in LIMITS if squeezed(text) not in whole]
    answers = [squeezed(f"{name}{TASK[name.split('_')[0]]} at {name.split('_')[1]} m") for name in NEAREST]
    places = [whole.find(text) for text in (*answers[:-1], "7morebelow", answers[-1])]
    if places != sorted(places):
        faults.append(f"answers on paper are not in the order of {NEAREST}: {places}")
    faults += [f"{whole.count(answer)} answers of {answer}" for answer in answers if whole.count(answer) != 1]
    if len(sheets) > MOST_SHEETS:
        faults.append(f"{len(sheets)} sheets")
    print(f"{paper}: {len(sheets)} sheets, {len(tables)} tables, {len(lines)} lines")
    return [f"{paper}: {fault}" for fault in faults]


def main():
    folder, screenshot = map(pathlib.Path, sys.argv[1:])
    faults = faults_of_files(folder) + faults_of_screen(folder, screenshot)
    for paper in PAPERS:
        faults += faults_of_paper(folder, paper)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

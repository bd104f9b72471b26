#!/usr/bin/env python3
"""Asks the script of report.html in a real browser without a screen: what it reads off at a depth must be what the CSV files have.

The address of the page holds the view, so that `chromium --dump-dom PAGE#case=...&depth=...` gives the table of values there.
Checked: five depths of each chart, two cases at once in other units; that the data are sound JSON and the page lets no
other script run; that a page whose script is not allowed, or fails, shows its fixed pictures; that no label is
cut or lies on another; that two fingers zoom; that a phone need not scroll sideways, and shows which tables do; that a depth may be
typed and is marked in the views of the well; that models may be chosen; that tables and sentences follow the units; that the well is coloured, the assembly has its moment; that the browser has no complaint.

Usage: check_page.py RESULTS_FOLDER      of GP1
"""
import csv
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

CLOSE = 4.0e-4              # of a column's range: curves are thinned to 3e-4 and have five digits
CASES = ("sliding_3190", "rotary_2075")
MODELS = ("mcge", "soft")
PARTS = (0.05, 0.31, 0.5, 0.72, 0.97)       # of the depth
FIELD = {"ft": 1 / 0.3048, "klbf": 0.2248089431, "kft.lbf": 0.7375621493, "ksi": 0.1450377377}     # over m, kN, kN.m, MPa
BIGGEST = 900_000           # bytes of the page

WIDTHS = (1440, 500)        # px; Chromium without a screen is no narrower
LABELS = r"""
setTimeout(() => {
   const found = new Set()
   const look = view => { for (const svg of document.querySelectorAll('.live svg:not(.key), .drawn svg')) {
      const whole = svg.getBoundingClientRect(), name = svg.getAttribute('aria-label') ?? svg.querySelector('title')?.textContent
      const texts = [...svg.querySelectorAll('text:not(.value)')].filter(t => t.textContent.trim() && whole.width)
         .map(t => [t.textContent.trim(), t.getBoundingClientRect()])
      texts.forEach(([t, a], i) => {
         if (a.left < whole.left - 2 || a.right > whole.right + 2 || a.top < whole.top - 2 || a.bottom > whole.bottom + 2) found.add(`${view}, ${name}: ${t} is cut`)
         for (const [u, b] of texts.slice(0, i)) if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
            Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.3 * Math.min(a.height, b.height)) found.add(`${view}, ${name}: ${t} lies on ${u}`)
      })
   } }
   look('first')
   for (const b of document.querySelectorAll('.lower button, .bar .tab')) { b.click(); look(b.textContent) }
   document.title = 'FOUND' + JSON.stringify([...found])
}, 500)
"""

FINGERS = """
const {state} = blocks[0], panel = document.querySelector('svg.panel'), place = panel.getBoundingClientRect()
const finger = (identifier, part) => new Touch({identifier, target: panel, clientX: place.left + 9, clientY: place.top + part * place.height})
const touch = (kind, ...parts) => panel.dispatchEvent(new TouchEvent(kind, {bubbles: true, cancelable: true, touches: parts.map((p, i) => finger(i, p))}))
const whole = state.bottom - state.top
touch('touchstart', .45, .55); touch('touchmove', .35, .65); touch('touchend')
document.title = 'PART' + (state.bottom - state.top) / whole
"""

# Depths as a reader types them, then what the page shows: the field with its label, the caption, the address, marks of the depth.
TYPED = r"""
setTimeout(async () => {
   const told = [], later = wait => new Promise(done => setTimeout(done, wait)), {root} = blocks[0].S, field = root.querySelector('input[type=number]')
   const press = text => [...root.querySelectorAll('button')].find(b => b.textContent.startsWith(text)).click()
   const well = root.querySelector('[aria-label="the well in three dimensions"]'), [lowest] = [...root.querySelectorAll('svg')].slice(-1)
   const off = () => {                                          // of the ring from the piece of the well at that depth, in px
      const ring = well.querySelector('.dot'), {state} = blocks[0], end = Math.max(...D.cases.filter(c => state.case.includes(c.name)).map(c => c.depth))
      const pieces = [...well.querySelectorAll('.near')], piece = pieces[Math.min(pieces.length - 1, Math.floor(state.depth / end * pieces.length))]
      const [ax, ay, bx, by] = piece.getAttribute('d').match(/-?[\d.]+(e-?\d+)?/g).map(Number), x = +ring.getAttribute('cx'), y = +ring.getAttribute('cy')
      return Math.hypot(x - ax, y - ay) + Math.hypot(x - bx, y - by) - Math.hypot(ax - bx, ay - by)
   }
   const type = async text => {
      field.focus()
      field.value = text
      field.dispatchEvent(new Event('change', {bubbles: true}))
      await later(400)
      const line = lowest.querySelector('.cross').getAttribute('d').match(/[\d.]+/), views = ['plan', 'from south', 'from east', '3D']
      told.push([field.value, field.parentNode.textContent.trim(), root.querySelector('caption').textContent, new URLSearchParams(location.hash.slice(1)).get('depth'),
         [...root.querySelectorAll('.lower text')].some(t => t.textContent === 'at ' + depth_text(blocks[0].state.depth)),
         Math.max(...views.map(v => { press(v); return off() })), line && (+line[0] - 10) / (lowest.viewBox.baseVal.width - 30)])
   }
   await type('2312.34')
   await type('3180')
   document.querySelector('p .units').click()
   await type('5001')
   press('lowest')
   await type('5002')
   await type('')
   await type('99999')
   document.title = 'FOUND' + JSON.stringify(told)
}, 300)
"""
# Field, label, caption, depth in the address, section, part of the lowest 40 m of 3190 m.
DEPTHS = [("2312.34", "measured depth [m]", "At 2312.34 m measured depth", 2312.34, None), ("3180", "measured depth [m]", "At 3180 m measured depth", 3180, 0.75),
          ("5001", "measured depth [ft]", "At 5001 ft measured depth", 1524.305, None), ("5002", "measured depth [ft]", "At 5002 ft measured depth", 1524.61, None),
          ("5002", "measured depth [ft]", "At 5002 ft measured depth", 1524.61, None), ("10465.88", "measured depth [ft]", "At 10465.88 ft measured depth", 3190, 1.0)]

# The well by a state of contact, at a depth beside the bit.
COLOURED = r"""
setTimeout(async () => {
   const {root} = blocks[0].S, pick = root.querySelector('[aria-label="colour of the well"]'), field = root.querySelector('input[type=number]')
   const well = root.querySelector('[aria-label="the well in three dimensions"]')
   field.value = '3186'
   field.dispatchEvent(new Event('change'))
   pick.value = 'gap_state'
   pick.dispatchEvent(new Event('change'))
   const [whole, value] = [well, well.querySelector('.value')].map(e => e.getBoundingClientRect())
   document.title = 'FOUND' + JSON.stringify([well.querySelector('.value').textContent, [...well.querySelectorAll('text')][0].textContent,
      value.right <= whole.right && value.left >= whole.left, root.querySelector('figcaption').textContent])
}, 300)
"""

# One model chosen in the list, then a depth beyond the end of the first of two load cases.
CHOSEN = r"""
setTimeout(async () => {
   const told = [], later = wait => new Promise(done => setTimeout(done, wait)), {root} = blocks[0].S, [cases, models] = root.querySelectorAll('select[multiple]')
   const choose = async (list, names) => {
      for (const o of list.options) o.selected = names.includes(o.value)
      list.dispatchEvent(new Event('change'))
      await later(400)
      told.push([...root.querySelectorAll('.legend button')].map(b => b.textContent), location.hash, [...root.querySelectorAll('.readout tr:nth-child(4) td')].map(c => c.textContent).slice(1))
   }
   await choose(models, ['soft'])
   await choose(models, ['mcge', 'soft'])
   await choose(cases, ['up_2075', 'sliding_3190'])
   const field = root.querySelector('input[type=number]')
   field.value = '2500'
   field.dispatchEvent(new Event('change'))
   told.push(root.querySelectorAll('.dot').length, [...root.querySelectorAll('.lower svg')][0].querySelectorAll('circle').length)
   for (const name of ['rotary_2075', 'sliding_2075', 'up_2075']) {
      [...document.querySelectorAll('.answers a')].find(a => a.textContent === name).click()
      await later(400)
      told.push(blocks[0].S.root.querySelector('.tab[aria-pressed=true]').textContent)
   }
   document.title = 'FOUND' + JSON.stringify(told)
}, 300)
"""

# The first table that is wider than a phone, at the top of the window, at the beginning or the end of its way.
SIDEWAYS = """
setTimeout(() => {
   const box = [...document.querySelectorAll('.wide')].find(e => e.scrollWidth > e.clientWidth + 50)
   if (WAY) box.scrollLeft = box.scrollWidth
   box.scrollIntoView()
}, 300)
"""
FEWEST_EDGE = 100           # px of a window's last column in the colour of a table's edge

PHONE = 390                 # px, in a frame
LONG_NAME = "_" + "long" * 12
BEYOND = r"""
setTimeout(() => {
   for (const d of document.querySelectorAll('details')) d.open = true
   const wide = document.documentElement.clientWidth, found = [], root = document.documentElement
   const boxed = e => { for (let p = e.parentElement; p; p = p.parentElement) if (['auto', 'scroll'].includes(getComputedStyle(p).overflowX)) return true }
   if (root.scrollWidth > wide) found.push('the page scrolls sideways')
   for (const e of document.querySelectorAll('body :not(svg *)')) if (e.getBoundingClientRect().right > wide + 1 && !boxed(e)) found.push(`${e.tagName} ${e.textContent.slice(0, 40)} ends beyond the edge`)
   for (const e of document.querySelectorAll('td, th')) if (e.scrollWidth > e.clientWidth + 1) found.push(`${e.textContent} is wider than its cell`)
   parent.postMessage(JSON.stringify(found), '*')
}, 500)
"""
FRAME = f"""<html><head><title></title></head><body><iframe src="inner.html" style="width:{PHONE}px;height:3000px"></iframe>
<script>addEventListener('message', e => document.title = 'FOUND' + e.data)</script></body></html>"""


def dom(page, view="", options=()):
    """The page as the browser has made it, and what it complained of."""
    with tempfile.TemporaryDirectory() as home:
        run = subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", f"--user-data-dir={home}", *options,
                              "--virtual-time-budget=3000", "--dump-dom", page.resolve().as_uri() + ("#" + view if view else "")],
                             capture_output=True, text=True, timeout=240, check=False)
    return run.stdout, re.findall(r"CONSOLE[^\n]*", run.stderr)


def readout(text):
    """Rows of the table of values: quantity -> [unit, value, value ...]."""
    table = re.search(r'class="wide readout".*?</table>', text, re.S)
    if not table:
        return {}
    rows = re.findall(r"<tr>(.*?)</tr>", table.group(0), re.S)
    cells = [[html.unescape(re.sub(r"<[^>]*>", "", cell)) for cell in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row, re.S)] for row in rows]
    return {row[0]: row[1:] for row in cells}


class Profile:
    """A profile_*.csv: values between rows as the page reads them."""

    def __init__(self, folder, case, model):
        with (folder / f"profile_{case}_{model}.csv").open(encoding="utf-8", newline="") as file:
            self.rows = list(csv.DictReader(file))
        self.depth = [float(row["md_m"]) for row in self.rows]

    def column(self, name):
        head = next(h for h in self.rows[0] if h == name or re.fullmatch(re.escape(name) + r"_(m|mm|deg|kN|kNm|kN_m|MPa|deg_30m|pct)", h))
        return [float(row[head]) if row[head] else None for row in self.rows]

    def at(self, name, depth):
        """Value there, and the range of nine in ten values; None where there is none or the curve jumps within a metre."""
        values = self.column(name)
        i = max(k for k in range(len(self.depth)) if self.depth[k] <= depth)
        i = min(i, len(self.depth) - 2)
        near = [v for d, v in zip(self.depth, values) if abs(d - depth) < 1.0]
        a, b = values[i], values[i + 1]
        there = sorted(v for v in values if v is not None)
        cut = int(0.05 * len(there))
        if a is None or b is None or None in near or self.depth[i + 1] <= self.depth[i]:
            return None, 0.0
        return a + (b - a) * (depth - self.depth[i]) / (self.depth[i + 1] - self.depth[i]), (there[-1 - cut] - there[cut]) or there[-1] - there[0]


def faults_of_view(folder, page, data, view, field=False):
    faults, compared = [], 0
    query = urllib.parse.parse_qs(view)
    text, complaints = dom(page, view)
    faults += [f"{view}: the browser complains: {c}" for c in complaints]
    rows = readout(text)
    chart = next(c for c in data["charts"] if c["title"] == query["chart"][0])
    wanted = [c["column"] for p in chart["panels"] for c in p["curves"]]
    names = [name.split(" ") for name in rows.get("quantity", ["unit"])[1:] if " " in name and not name.startswith("difference ")]
    profiles = [Profile(folder, case, model) for case, model in names]
    if len(profiles) != len(MODELS) * len(query["case"]):
        faults.append(f"{view}: the page shows {names}")
    depth = float(query["depth"][0])
    for name in wanted:
        column = data["columns"][name]
        told = rows.get(column["label"])
        if told is None:
            faults.append(f"{view}: no value of {column['label']}")
            continue
        if column.get("words") or name in ("clock", "azimuth", "side_force_on_joint"):
            continue
        factor = FIELD.get(told[0], 1.0) if field else 1.0
        for profile, shown in zip(profiles, told[1:]):
            value, extent = profile.at(name, depth)
            if value is None or shown == "\u2013":
                continue
            compared += 1
            digits = len(shown.partition(".")[2])
            if not abs(float(shown) - value * factor) <= CLOSE * extent * factor + 0.51 * 10 ** -digits:
                faults.append(f"{view}: {name} is shown as {shown}, the file has {value * factor:.6g}")
    return faults, compared


def faults_without_script(page):
    """A page whose script is refused, or fails at once, has its fixed pictures and no charts."""
    faults = []
    text = page.read_text(encoding="utf-8")
    broken = {"refused": re.sub(r"sha256-[^']*", "sha256-" + "A" * 43 + "=", text, count=1),
              "failing": re.sub(r"script-src 'sha256-[^']*'", "script-src 'unsafe-inline'", text, count=1).replace(
                  "'use strict'", "'use strict'; throw new Error('on purpose')", 1)}
    with tempfile.TemporaryDirectory() as scratch:
        for name, changed in broken.items():
            copy = pathlib.Path(scratch) / f"{name}.html"
            copy.write_text(changed, encoding="utf-8")
            made, _ = dom(copy)
            if re.search(r'<html[^>]*class="[^"]*scripted', made) or 'class="wide readout"' in made:
                faults.append(f"a page with a {name} script hides its fixed pictures")
            if made.count("<svg") < 5:
                faults.append(f"a page with a {name} script has {made.count('<svg')} pictures")
    return faults


def faults_of_labels(text, widths=WIDTHS):
    """Texts of all charts of a page, in windows of some widths, in each view of the well: none is cut or lies on another."""
    faults = []
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text)
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch) / "labels.html"
        copy.write_text(text.replace("</body>", f"<script>{LABELS}</script></body>"), encoding="utf-8")
        for width in widths:
            made, _ = dom(copy, options=(f"--window-size={width},1000",))
            found = re.search(r"<title>FOUND(.*?)</title>", made, re.S)
            faults += [f"{width} px: {what}" for what in json.loads(html.unescape(found.group(1)))] if found else ["labels were not looked at"]
    return faults


def faults_of_no_curves(page):
    """Without a load case to show there is a sentence, and no empty chart."""
    made, complaints = dom(page, "case=none")
    faults = [f"no load case: the browser complains: {c}" for c in complaints]
    if "Curves are thinned to 0.03 % of their range." not in html.unescape(made):
        faults.append("the page does not say how close its curves are")
    if "No curves: choose a load case" not in made or 'class="panel"' in made.split("Pictures of the run")[0]:
        faults.append("no load case: the page draws empty charts, or says nothing")
    return faults


def faults_of_phone(text):
    """On a phone, with a long name: what is wide scrolls in its own box, and no text leaves its cell."""
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text).replace(CASES[0], CASES[0] + LONG_NAME)
    with tempfile.TemporaryDirectory() as scratch:
        inner, outer = pathlib.Path(scratch) / "inner.html", pathlib.Path(scratch) / "outer.html"
        inner.write_text(text.replace("</body>", f"<script>{BEYOND}</script></body>"), encoding="utf-8")
        outer.write_text(FRAME, encoding="utf-8")
        made, _ = dom(outer)
    found = re.search(r"<title>FOUND(.*?)</title>", made, re.S)
    return [f"{PHONE} px: {what}" for what in json.loads(html.unescape(found.group(1)))] if found else ["the page was not looked at on a phone"]


def faults_of_touch(page):
    """Two fingers that are spread to three times their distance leave a third of the depth."""
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", page.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch) / "touch.html"
        copy.write_text(text.replace("</body>", f"<script>{FINGERS}</script></body>"), encoding="utf-8")
        made, _ = dom(copy)
    part = re.search(r"<title>PART([0-9.]+)<", made)
    return [] if part and abs(float(part.group(1)) - 1 / 3) < 0.01 else [f"two fingers leave {part and part.group(1)} of the depth"]


def told_by(text, script):
    """What a script finds that acts on a page, and what the browser complained of; null where it does not come to its end."""
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text)
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch) / "acted.html"
        copy.write_text(text.replace("</body>", f"<script>{script}</script></body>"), encoding="utf-8")
        made, complaints = dom(copy, options=("--virtual-time-budget=9000",))
    found = re.search(r"<title>FOUND(.*?)</title>", made, re.S)
    return json.loads(html.unescape(found.group(1))) if found else None, [f"the browser complains: {c}" for c in complaints]


def faults_of_typing(text):
    """A depth that is typed, also beyond what is zoomed to: crosshair, box, address and marks go there; what is no number is left out."""
    told, faults = told_by(text, TYPED)
    for shown, (field, label, caption, depth, part) in zip(told or [[]] * len(DEPTHS), DEPTHS):
        if shown[:3] != [field, label, caption] or float(shown[3] or 0.0) != depth or shown[4:5] != [True]:
            faults.append(f"{depth} m was typed, the page shows {shown}")
        elif shown[5] is None or not shown[5] < 0.1:
            faults.append(f"{depth} m was typed, the mark is {shown[5]} px beside the well")
        elif (shown[6] is None) != (part is None) or (part and not abs(shown[6] - part) < 1e-3):
            faults.append(f"{depth} m was typed, the mark of the assembly is at {shown[6]} of it")
    return faults


def faults_of_choice(text):
    """Models are chosen as load cases are; a depth below the end of a string has no mark of it."""
    told, faults = told_by(text, CHOSEN)
    if not told:
        return [*faults, "models were not chosen"]
    one, one_at, one_row, both, both_at, _, four, _, row, dots, circles, *charts = told
    if one != ["sliding_3190 soft"] or len(one_row) != 2 or "model=soft" not in one_at or "model=mcge" in one_at:
        faults.append(f"one model: the page shows {one}, {one_row}, {one_at}")
    if both != ["sliding_3190 mcge", "sliding_3190 soft"] or "model=" in both_at:
        faults.append(f"both models: the page shows {both}, {both_at}")
    if charts != ["Strength", "Buckling", "Forces"]:
        faults.append(f"answers by von Mises, lock-up, tension lead to {charts}")
    # unit, two load cases by two models, their difference by each model
    if len(four) != 4 or len(row) != 7 or any(abs(float(row[k + 1]) - float(row[k]) - float(row[end])) > 0.11 for k, end in ((1, 5), (3, 6))):
        faults.append(f"two load cases: the page shows {four}, {row}")
    if dots or circles != 3:
        faults.append(f"below the end of a string there are {dots} marks, {circles - 1} strings in the section")
    return faults


def rows_of_case(folder, case):
    """The row of each model in summary.csv, and that in limits.csv."""
    for name in ("summary.csv", "limits.csv"):
        with (folder / name).open(encoding="utf-8", newline="") as file:
            yield from (row for row in csv.DictReader(file) if row["case"] == case)


def faults_of_tables(folder, page):
    """Tables of results in other units, against the files; the note on what stays in those of the deck. Also the number of values compared."""
    faults, compared = [], 0
    made, complaints = dom(page, "units=field")
    faults += [f"tables in field units: the browser complains: {c}" for c in complaints]
    for table in re.findall(r"<table>(.*?)</table>", made, re.S):
        heads = re.findall(r"<th([^>]*)>(.*?)<br><small>(.*?)</small>", table, re.S)
        for row in re.findall(r"<tr[^>]*>(.*?)</tr>", table.partition("<tbody>")[2], re.S):
            cells = [html.unescape(re.sub(r"<[^>]*>", "", cell)) for cell in re.findall(r"<td[^>]*>(.*?)</td>", row, re.S)]
            rows = list(rows_of_case(folder, cells[0].replace(" !", "")))
            for (marks, name, unit), cell in zip(heads, cells):
                column = next((key for r in rows for key in r if re.fullmatch(re.escape(name.replace(" ", "_")) + "_(m|kN|kNm|MPa)", key)), None)
                if not column or cell == "\u2013":
                    continue
                compared += 1
                wanted = [float(r[column]) * FIELD[{"m": "ft", "kN": "klbf", "kNm": "kft.lbf", "MPa": "ksi"}[column.rpartition("_")[2]]] for r in rows if r.get(column)]
                digits = len(cell.partition(".")[2])
                if "data-q" not in marks or unit not in FIELD or not any(abs(float(cell) - value) <= 0.51 * 10 ** -digits + 2e-6 * abs(value) for value in wanted):
                    faults.append(f"tables in field units: {name} of {cells[0]} is {cell} {unit}, the files have {wanted}")
    if not re.search(r'<p class="note switched">[^<]*keep SI units', made):
        faults.append("tables in field units: no note on sentences")
    if not re.search(r'<p class="note switched" hidden', dom(page)[0]):
        faults.append("the note on other units stands beside those of the deck")
    return faults, compared


def faults_of_well(folder, text):
    """The well coloured by a state, which is told at the bit and is not cut; moment and offset below the assembly, against the CSV file."""
    told, faults = told_by(text, COLOURED)
    if not told:
        return [*faults, "the well was not coloured"]
    value, words, inside, caption = told
    if not value.startswith("3186 m: ") or value.split(": ")[1] not in words.split(", ") or "rigid" not in words or not inside:
        faults.append(f"coloured by gap state the well shows '{value}', '{words}', inside: {inside}")
    found, profile = re.search(r"At 3186 m: moment ([0-9.]+) kN\.m, ([0-9.]+) mm off the axis\.$", caption), Profile(folder, CASES[0], "mcge")
    wanted = [profile.at(name, 3186.0)[0] for name in ("bending", "displacement")]
    if not found or any(abs(float(a) - b) > 1e-3 * b for a, b in zip(found.groups(), wanted)):
        faults.append(f"below the assembly stands '{caption}', the file has {wanted}")
    return faults


def faults_of_sentences(page):
    """Answers, well and string in other units: each number of a sentence against that in the deck's units, to the three digits that it has."""
    made, _ = dom(page, "units=field")
    faults, compared = [], 0
    for own, shown in re.findall(r'<(?:td|p|small|span)[^>]*data-own="([^"]*)"[^>]*>([^<]*)<', made):
        for unit, other in (("kN", "klbf"), ("m", "ft"), ("MPa", "ksi")):
            pairs = [re.findall(rf"(?<![0-9./])([0-9.]+) (?:of ([0-9.]+) )?{u}\b(?!\.m)", html.unescape(text)) for text, u in ((own, unit), (shown, other))]
            numbers = [[float(n) for pair in found for n in pair if n] for found in pairs]
            compared += len(numbers[0])
            if len(numbers[0]) != len(numbers[1]) or any(abs(a * FIELD[other] - b) > 0.011 * b + 0.01 for a, b in zip(*numbers)):
                faults.append(f"in field units '{own}' is '{shown}'")
    return faults + ([] if compared > 40 else [f"only {compared} numbers of sentences were compared"])


def faults_of_edge(text):
    """On a phone a wide table has a coloured right edge until its end is seen."""
    from matplotlib.image import imread
    faults = []
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text)
    for way, wanted in (("0", True), ("1", False)):
        with tempfile.TemporaryDirectory() as scratch:
            inner, outer, shot = (pathlib.Path(scratch) / name for name in ("inner.html", "outer.html", "shot.png"))
            inner.write_text(text.replace("</body>", f"<script>{SIDEWAYS.replace('WAY', way)}</script></body>"), encoding="utf-8")
            outer.write_text(FRAME.replace("3000px", "800px"), encoding="utf-8")
            dom(outer, options=("--hide-scrollbars", "--window-size=600,900", f"--screenshot={shot}"))
            picture = (imread(shot)[:, :, :3] * 255).round().astype(int)
        blue = (abs(picture[:400, PHONE - 20:PHONE + 10] - (0, 114, 178)).max(axis=2) < 40).sum(axis=0).max()
        if (blue > FEWEST_EDGE) != wanted:
            faults.append(f"a wide table, {'seen to its end' if way == '1' else 'at its beginning'}: {blue} px of its edge are coloured")
    return faults


def main():
    folder = pathlib.Path(sys.argv[1])
    page = folder / "report.html"
    text = page.read_text(encoding="utf-8")
    faults = [] if len(text.encode()) <= BIGGEST else [f"the page has {len(text.encode())} bytes"]
    data = json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S).group(1))
    if "default-src 'none'" not in text or "unsafe-eval" in text or "script-src 'unsafe" in text:
        faults.append("the page lets other scripts run")
    compared = 0
    for chart in data["charts"]:
        for case, part in zip((CASES * 3)[:len(PARTS)], PARTS):
            depth = round(part * next(c["depth"] for c in data["cases"] if c["name"] == case), 2)
            view = urllib.parse.urlencode({"case": case, "chart": chart["title"], "depth": depth})
            found, n = faults_of_view(folder, page, data, view)
            faults, compared = faults + found, compared + n
    two = "&".join(f"case={case}" for case in CASES) + "&chart=Strength&depth=1500&units=field"
    found, n = faults_of_view(folder, page, data, two, field=True)
    faults, compared = faults + found + faults_without_script(page) + faults_of_labels(text) + faults_of_no_curves(page) + faults_of_phone(text) + faults_of_touch(page), compared + n
    found, n = faults_of_tables(folder, page)
    faults += found + faults_of_sentences(page) + faults_of_well(folder, text) + faults_of_typing(text) + faults_of_choice(text) + faults_of_edge(text)
    print(f"{compared} values read off the page, {n} off its tables")
    if compared < 150 or n < 500:
        faults.append(f"only {compared} values could be compared")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Asks the script of report.html in a real browser without a screen: what it reads off at a depth must be what the CSV files have.

The address of the page holds the view, PAGE#case=...&depth=..., so that an opened page has the table of values there.
Checked: five depths of each chart, two cases at once in other units; that the data are sound JSON and the page lets no
other script run; that a page whose script is not allowed, or fails, shows its fixed pictures; that no label is
cut or lies on another; that two fingers zoom; that a phone need not scroll sideways, and shows which tables do; that a depth may be
typed and is marked in the views of the well; that models may be chosen; that the first printed sheet has the load case of the address; that tables and sentences follow the units; that the well is coloured, the assembly has its moment; that the browser has no complaint.

Usage: check_page.py RESULTS_FOLDER      of GP1
"""
import bisect
import csv
import functools
import html
import json
import pathlib
import re
import sys
import tempfile
import urllib.parse

from browser import READOUTS, View, browser, opened

CLOSE = 4.0e-4              # of a column's range: curves are thinned to 3e-4 and have five digits
#: Columns whose headings are not their names.
HEADINGS = {"largest von Mises, no bending between joints": "largest_von_mises", "depth of most used limit": "governing_md", "largest bending moment": "largest_bending", "depth of largest moment": "largest_bending_md",
            "neutral point": "neutral_top", "depth of least safety factor": "least_safety_md", "depth of buckling margin": "buckling_margin_md", "depth of largest mean side force": "largest_side_force_md", "WOB at buckling": "wob_buckling", "WOB at zero hook load": "wob_no_hookload",
            "WOB at lock-up": "wob_lockup", "margin to rig limit": "rig_margin", "length of sinusoidal buckling": "snaking_length",
            "length of helical buckling": "coiled_length"}
BAND = 1.06                 # a band has two digits
CASES = ("sliding_3190", "rotary_2075")
MODELS = ("mcge", "soft")
PARTS = (0.05, 0.31, 0.5, 0.72, 0.97)       # of the depth
FIELD = {"ft": 1 / 0.3048, "klbf": 0.2248089431, "kft.lbf": 0.7375621493, "ksi": 0.1450377377}     # over m, kN, kN.m, MPa
BIGGEST = 900_000           # bytes of the page

WIDTHS = (1440, 500)        # px
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
document.title = 'FOUND' + (state.bottom - state.top) / whole
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
      value.right <= whole.right && value.left >= whole.left, !![...well.querySelectorAll('text')].find(t => t.textContent === 'E 0')
         && [...well.children].findLastIndex(e => e.matches('.near')) < [...well.children].findIndex(e => e.textContent === 'E 0'), root.querySelector('figcaption').textContent,
      [...root.querySelectorAll('text')].find(t => t.textContent.startsWith('moment, at most')).textContent])
}, 300)
"""

# One model chosen in the list, then a depth beyond the end of the first of two load cases.
CHOSEN = r"""
setTimeout(async () => {
   let heads = []
   const told = [], later = wait => new Promise(done => setTimeout(done, wait)), {root} = blocks[0].S, [cases, models] = root.querySelectorAll('select[multiple]')
   const choose = async (list, names) => {
      for (const o of list.options) o.selected = names.includes(o.value)
      list.dispatchEvent(new Event('change'))
      await later(400)
      told.push([...root.querySelectorAll('.legend button')].map(b => b.textContent), location.hash, [...root.querySelectorAll('.readout tr:nth-child(4) td')].map(c => c.textContent).slice(1))
      heads = [...root.querySelectorAll('.readout th')].map(c => c.textContent)
   }
   await choose(models, ['soft'])
   await choose(models, ['mcge', 'soft'])
   await choose(cases, ['up_2075', 'sliding_3190'])
   told.push(heads.slice(6), [...root.querySelectorAll('.legend svg')].map(s => s.innerHTML.match(/stroke="[^"]*"/)[0] + s.querySelector('path')?.getAttribute('d')))
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

# All curves as the page reads them, between the depths of their rows.
CURVES = r"""
setTimeout(() => {
   const depths = end => Array.from({length: 60}, (_, i) => +((i + .37) / 60 * end).toFixed(3))
   const numbers = p => Object.keys(p.curves).filter(name => !p.curves[name].words)
   const read = (p, name) => depths(D.cases[p.case].depth).map(d => [d, value_at(p, name, d)])
   const owner = (p, name) => D.profiles.find(o => o.case === p.case && o.curves[name] === p.curves[name]).model
   const each = (p, of) => Object.fromEntries(numbers(p).map(name => [name, of(p, name)]))
   document.title = 'FOUND' + JSON.stringify((D.profiles ?? []).map(p => [D.cases[p.case].name, p.model, each(p, read), each(p, (p, name) => p.bands?.[name] ?? 0), each(p, owner)]))
}, 300)
"""
# Curves that are no column of the file, or angles, which are thinned to a degree and turn.
OTHER_CURVES = ("side_force_on_joint", "clock", "azimuth")
INVERSE = ("safety_factor",)         # curves whose inverse goes straight from point to point
ROUNDING = 1.4e-5           # of a value: a number by itself has 36450 steps at least (page_code.f90)
FEWEST_POINTS = 300         # compared on a page

# Curves of the first printed sheet, and the first panel of the charts behind it.
PRINTED = """
setTimeout(() => {
   dispatchEvent(new Event('beforeprint'))
   const panels = place => [...document.querySelectorAll(`.live${place} svg.panel`)].map(p => p.getAttribute('aria-label'))
   const open = () => document.querySelectorAll('details[open]').length, opened = open()
   const told = [[...document.querySelectorAll('.first .legend button')].map(b => b.textContent), panels('.first'), panels(':not(.first)')[0], document.querySelectorAll('.depths tr').length, opened]
   dispatchEvent(new Event('afterprint'))
   document.title = 'FOUND' + JSON.stringify([...told, open()])
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
   for (const e of document.querySelectorAll('.alone .readout th')) for (const word of e.textContent.matchAll(/[^ ]+/g)) {
      const range = document.createRange()
      range.setStart(e.firstChild, word.index)
      range.setEnd(e.firstChild, word.index + word[0].length)
      if (range.getClientRects().length > 1) found.push(`${word[0]} is broken`)
   }
   for (const e of document.querySelectorAll('td, th')) if (e.scrollWidth > e.clientWidth + 1) found.push(`${e.textContent} is wider than its cell`)
   document.title = 'FOUND' + JSON.stringify(found)
}, 500)
"""
# A table on a phone at its beginning, and at its end.
FRAMES = f"""<html><body style="margin:0"><iframe src="0.html" style="width:{PHONE}px;height:800px"></iframe>
<iframe src="1.html" style="width:{PHONE}px;height:800px"></iframe></body></html>"""


def readout(text):
    """Rows of the table of values: quantity -> [unit, value, value ...]."""
    table = re.search(r'class="wide readout".*?</table>', text, re.S)
    if not table:
        return {}
    rows = re.findall(r"<tr>(.*?)</tr>", table.group(0), re.S)
    cells = [[html.unescape(re.sub(r"<[^>]*>", "", cell)) for cell in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row, re.S)] for row in rows]
    return {row[0]: row[1:] for row in cells}


def extent(values):
    """Range of nine in ten values."""
    there = sorted(values)
    cut = int(0.05 * len(there))
    return 0.0 if not there else (there[-1 - cut] - there[cut]) or there[-1] - there[0]


class Profile:
    """A profile_*.csv: values between rows as the page reads them."""
    units = "m|mm|deg|kN|kNm|kN_m|MPa|deg_30m|pct|ft|in|klbf|kftlbf|klbf_ft|ksi|psi|deg_100ft"

    def __init__(self, folder, case, model):
        with (folder / f"profile_{case}_{model}.csv").open(encoding="utf-8", newline="") as file:
            self.rows = list(csv.DictReader(file))
        self.depth = self.column("md")

    @functools.cache
    def column(self, name):
        head = next(h for h in self.rows[0] if h == name or re.fullmatch(f"{name}_({self.units})", h))
        return [float(row[head]) if row[head] else None for row in self.rows]

    def at(self, name, depth):
        """Value there; None where there is none or the curve jumps within a metre."""
        values, d = self.column(name), self.depth
        i = min(bisect.bisect_right(d, depth) - 1, len(d) - 2)
        a, b = values[i], values[i + 1]
        if a is None or b is None or None in values[bisect.bisect_right(d, depth - 1.0):bisect.bisect_left(d, depth + 1.0)] or d[i + 1] <= d[i]:
            return None
        part = (depth - d[i]) / (d[i + 1] - d[i])
        return 1.0 / (1.0 / a + (1.0 / b - 1.0 / a) * part) if name in INVERSE else a + (b - a) * part


def views_of(data):
    """Addresses: five depths of each chart, two load cases at once in other units."""
    views = []
    for chart in data["charts"]:
        for case, part in zip((CASES * 3)[:len(PARTS)], PARTS):
            depth = round(part * next(c["depth"] for c in data["cases"] if c["name"] == case), 2)
            views.append(urllib.parse.urlencode({"case": case, "chart": chart["title"], "depth": depth}))
    return [*views, "&".join(f"case={case}" for case in CASES) + "&chart=Strength&depth=1500&units=field"]


def faults_of_view(folder, data, view, text, complaints):
    """A view against the files; also the number of values compared."""
    faults, compared = [], 0
    query = urllib.parse.parse_qs(view)
    field = "units" in query
    faults += [f"{view}: the browser complains: {c}" for c in complaints]
    rows = readout(text)
    chart = next(c for c in data["charts"] if c["title"] == query["chart"][0])
    wanted = [c["column"] for p in chart["panels"] for c in p["curves"]]
    names = [name.split(" ") for name in rows.get("quantity", ["unit"])[1:] if " " in name and " less " not in name]
    profiles = [Profile(folder, case, model) for case, model in names]
    if len(profiles) != len(MODELS) * len(query["case"]):
        faults.append(f"{view}: the page shows {names}")
    depth = float(query["depth"][0])
    for name in wanted:
        column = data["columns"][name]
        told = rows.get(column["label"]) or next((row for key, row in rows.items() if key.startswith(column["label"] + ", ")), None)
        if told is None:
            faults.append(f"{view}: no value of {column['label']}")
            continue
        if column.get("words") or name in ("clock", "azimuth", "side_force_on_joint"):
            continue
        factor = FIELD.get(told[0], 1.0) if field else 1.0
        for profile, shown in zip(profiles, told[1:]):
            value = profile.at(name, depth)
            if value is None or shown == "\u2013":
                continue
            compared += 1
            close = CLOSE * extent([turned(name, v) for v in profile.column(name) if v is not None])
            near, last = turned(name, value), 0.51 * 10 ** -len(shown.partition(".")[2]) / factor
            ends = [turned(name, float(shown) / factor + step) for step in (-last, last)]
            if not min(ends) - close <= near <= max(ends) + close:
                faults.append(f"{view}: {name} is shown as {shown}, the file has {value * factor:.6g}")
    return faults, compared


def values_near(profile, name, depth):
    """Values of a column at a depth and half a millimetre beside it; None where one is missing."""
    if not profile.depth[0] <= depth <= profile.depth[-1]:
        return None
    near = [profile.at(name, depth + step) for step in (0.0, -5.0e-4, 5.0e-4)]
    return None if None in near else near


def turned(name, value):
    """The value by which a curve is thinned: a safety factor is as close as its inverse."""
    return 1.0 / value if name in INVERSE else value


def faults_of_curves(folder, told, complaints):
    """Every curve of a page against the files. Its depths are rounded to half a thousandth."""
    faults, compared = [f"curves: the browser complains: {c}" for c in complaints], 0
    if told and not any(folder.glob("profile_*.csv")):
        return faults                   # a deck may leave these files out
    for case, model, curves, bands, owners in told or []:
        profiles = {owner: Profile(folder, case, owner) for owner in {model, *owners.values()}}
        for name in (name for name in curves if name not in OTHER_CURVES):
            # a curve of the hole may be that of another model, which has more rows
            close = max(CLOSE * extent([turned(name, v) for v in profiles[model].column(name) if v is not None]), BAND * bands.get(name, 0.0))
            for depth, shown in curves[name]:
                near = values_near(profiles[owners[name]], name, depth) if shown is not None else None
                if not near:
                    continue
                compared += 1
                near = [turned(name, value) for value in near]
                rounding = close + ROUNDING * abs(near[0])
                if not min(near) - rounding <= turned(name, shown) <= max(near) + rounding:
                    faults.append(f"{case} {model}: {name} at {depth} is {shown}, the file has {turned(name, near[0])}")
    return faults + ([f"only {compared} values of curves were compared"] if told != [] and compared < FEWEST_POINTS else [])


NO_SCRIPT = "[d.documentElement.classList.contains('scripted') || !!d.querySelector('.wide.readout'), d.querySelectorAll('svg').length]"


def views_without_script(text):
    """A page whose script is not allowed, one whose script fails at once."""
    refused = re.sub(r"sha256-[^']*", "sha256-" + "A" * 43 + "=", text, count=1)
    failing = re.sub(r"script-src 'sha256-[^']*'", "script-src 'unsafe-inline'", text, count=1)
    failing = failing.replace("'use strict'", "'use strict'; throw new Error('on purpose')", 1)
    return {name: View(page, tell=NO_SCRIPT) for name, page in (("refused", refused), ("failing", failing))}


def faults_without_script(name, told):
    """Such a page has its fixed pictures and no charts."""
    scripted, pictures = told or (True, 0)
    faults = [f"a page with a {name} script hides its fixed pictures"] if scripted else []
    return faults + ([f"a page with a {name} script has {pictures} pictures"] if pictures < 5 else [])


def views_of_labels(text, widths=WIDTHS):
    """Texts of all charts of a page, in windows of some widths, in each view of the well."""
    return [View(text, script=LABELS, width=width) for width in widths]


def faults_of_labels(told, width):
    """None is cut or lies on another."""
    return ["labels were not looked at"] if told is None else [f"{width} px: {what}" for what in told]


def faults_of_beyond(made, _complaints):
    """A depth of the address below the end of the string is told."""
    return [] if "The address asks for 5000 m. The chart ends at 3190 m." in (made or "") else ["a depth beyond the end is not told"]


def faults_of_no_curves(made, complaints):
    """Without a load case to show there is a sentence, and no empty chart."""
    faults = [f"no load case: the browser complains: {c}" for c in complaints]
    told, panels = made or ("", 0)
    if "Curves are thinned to 0.03 % of their range, safety factors by their inverse." not in told:
        faults.append("the page does not say how close its curves are")
    if "No load case is named 'none'." not in told or "No curves: choose a load case" not in told or panels:
        faults.append("no load case: the page draws empty charts, or says nothing")
    return faults


NO_CURVES = "[d.body.textContent, d.querySelector('.live:not(.first)').querySelectorAll('svg.panel').length]"


def view_of_phone(text):
    """A page on a phone, with a long name."""
    return View(text.replace(CASES[0], CASES[0] + LONG_NAME), script=BEYOND, width=PHONE, height=3000)


def faults_of_phone(told):
    """What is wide scrolls in its own box, and no text leaves its cell."""
    return ["the page was not looked at on a phone"] if told is None else [f"{PHONE} px: {what}" for what in told]


def faults_of_touch(part, _complaints):
    """Two fingers that are spread to three times their distance leave a third of the depth."""
    return [] if part and abs(part - 1 / 3) < 0.01 else [f"two fingers leave {part} of the depth"]


def faults_of_typing(told, complaints):
    """A depth that is typed, also beyond what is zoomed to: crosshair, box, address and marks go there; what is no number is left out."""
    faults = [f"typing: the browser complains: {c}" for c in complaints]
    for shown, (field, label, caption, depth, part) in zip(told or [[]] * len(DEPTHS), DEPTHS):
        if shown[:3] != [field, label, caption] or float(shown[3] or 0.0) != depth or shown[4:5] != [True]:
            faults.append(f"{depth} m was typed, the page shows {shown}")
        elif shown[5] is None or not shown[5] < 0.1:
            faults.append(f"{depth} m was typed, the mark is {shown[5]} px beside the well")
        elif (shown[6] is None) != (part is None) or (part and not abs(shown[6] - part) < 1e-3):
            faults.append(f"{depth} m was typed, the mark of the assembly is at {shown[6]} of it")
    return faults


def faults_of_choice(told, complaints):
    """Models are chosen as load cases are; a depth below the end of a string has no mark of it."""
    faults = [f"choice: the browser complains: {c}" for c in complaints]
    if not told:
        return [*faults, "models were not chosen"]
    one, one_at, one_row, both, both_at, _, four, _, row, heads, looks, dots, circles, *charts = told
    if one != ["sliding_3190 soft"] or len(one_row) != 2 or "model=soft" not in one_at or "model=mcge" in one_at:
        faults.append(f"one model: the page shows {one}, {one_row}, {one_at}")
    if both != ["sliding_3190 mcge", "sliding_3190 soft"] or "model=" in both_at:
        faults.append(f"both models: the page shows {both}, {both_at}")
    if charts != ["Strength", "Buckling", "Forces"]:
        faults.append(f"answers by von Mises, lock-up, tension lead to {charts}")
    # unit, two load cases by two models, their difference by each model
    if len(four) != 4 or len(row) != 7 or any(abs(float(row[k + 1]) - float(row[k]) - float(row[end])) > 0.11 for k, end in ((1, 5), (3, 6))):
        faults.append(f"two load cases: the page shows {four}, {row}")
    if heads != [f"sliding_3190 {model} less up_2075 {model}" for model in MODELS]:
        faults.append(f"two load cases: differences are named {heads}")
    if len(looks) != 4 or looks[:2] != looks[2:] or looks[0] == looks[1]:
        faults.append(f"two load cases by two models: colours and marks are {looks}")
    if dots or circles != 3:
        faults.append(f"below the end of a string there are {dots} marks, {circles - 1} strings in the section")
    return faults


def faults_of_print(told, complaints):
    """The first printed sheet has the load case of the address, though another is nearest to a limit. The charts behind it go on."""
    faults = [f"print: the browser complains: {c}" for c in complaints]
    curves, first, behind, depths, opened, left = told or ([], [], "", 0, 0, 0)
    if curves != [f"{CASES[0]} {model}" for model in MODELS] or behind in first or "torque" in first:
        faults.append(f"print: the first sheet shows {curves}, '{first}', the next one '{behind}'")
    if depths < 10 or (opened, left) != (2, 0):
        faults.append(f"print: values at {depths} depths, {opened} parts are opened, {left} of them stay open")
    return faults


def rows_of_case(folder, case):
    """The row of each model in summary.csv, and that in limits.csv."""
    for name in ("summary.csv", "limits.csv"):
        with (folder / name).open(encoding="utf-8", newline="") as file:
            yield from (row for row in csv.DictReader(file) if row["case"] == case)


def faults_of_tables(folder, made, complaints, own):
    """Tables of results in other units, against the files; the note on what stays in those of the deck. Also the number of values compared."""
    faults, compared = [], 0
    faults += [f"tables in field units: the browser complains: {c}" for c in complaints]
    for table in re.findall(r"<table>(.*?)</table>", made, re.S):
        heads = re.findall(r"<th([^>]*)>(.*?)<br><small>(.*?)</small>", table, re.S)
        for row in re.findall(r"<tr[^>]*>(.*?)</tr>", table.partition("<tbody>")[2], re.S):
            cells = [html.unescape(re.sub(r"<[^>]*>", "", cell)) for cell in re.findall(r"<td[^>]*>(.*?)</td>", row, re.S)]
            rows = list(rows_of_case(folder, cells[0].replace(" !", "")))
            for (marks, name, unit), cell in zip(heads, cells):
                column = next((key for r in rows for key in r if re.fullmatch(re.escape(HEADINGS.get(name, name.replace(" ", "_"))) + "_(m|kN|kNm|MPa)", key)), None)
                if not column or cell == "\u2013":
                    continue
                compared += 1
                wanted = [float(r[column]) * FIELD[{"m": "ft", "kN": "klbf", "kNm": "kft.lbf", "MPa": "ksi"}[column.rpartition("_")[2]]] for r in rows if r.get(column)]
                digits = len(cell.partition(".")[2])
                if "data-q" not in marks or unit not in FIELD or not any(abs(float(cell) - value) <= 0.51 * 10 ** -digits + 2e-6 * abs(value) for value in wanted):
                    faults.append(f"tables in field units: {name} of {cells[0]} is {cell} {unit}, the files have {wanted}")
    if not re.search(r'<p class="note switched">[^<]*keep SI units', made):
        faults.append("tables in field units: no note on sentences")
    if not re.search(r'<p class="note switched" hidden', own):
        faults.append("the note on other units stands beside those of the deck")
    return faults, compared


def faults_of_well(folder, told, complaints):
    """The well coloured by a state, which is told at the bit and is not cut; moment and offset below the assembly, against the CSV file."""
    faults = [f"the well: the browser complains: {c}" for c in complaints]
    if not told:
        return [*faults, "the well was not coloured"]
    value, words, inside, above, caption, most = told
    if not value.startswith("3186 m: ") or value.split(": ")[1] not in words.split(", ") or "rigid" not in words or not inside:
        faults.append(f"coloured by gap state the well shows '{value}', '{words}', inside: {inside}")
    faults += [] if above else ["the well hides its labels"]
    found, profile = re.search(r"At 3186 m: moment ([0-9.]+) kN\.m, ([0-9.]+) mm off the axis\.$", caption), Profile(folder, CASES[0], "mcge")
    wanted = [profile.at(name, 3186.0) for name in ("bending", "displacement")]
    if not found or any(abs(float(a) - b) > 1e-3 * b for a, b in zip(found.groups(), wanted)):
        faults.append(f"below the assembly stands '{caption}', the file has {wanted}")
    largest = max(m for d, m in zip(profile.depth, profile.column("bending")) if d >= profile.depth[-1] - 40.0)
    if most != f"moment, at most {largest:.3f} kN.m":
        faults.append(f"above the assembly stands '{most}', the file has {largest}")
    return faults


def faults_of_sentences(made):
    """Answers, well and string in other units: each number of a sentence against that in the deck's units, to the three digits that it has."""
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
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for way in "01":
            (folder / f"{way}.html").write_text(text.replace("</body>", f"<script>{SIDEWAYS.replace('WAY', way)}</script></body>"), encoding="utf-8")
        (folder / "frames.html").write_text(FRAMES, encoding="utf-8")
        browser("--hide-scrollbars", "--window-size=900,900", "--virtual-time-budget=6000", f"--screenshot={folder}/shot.png", (folder / "frames.html").as_uri())
        picture = (imread(folder / "shot.png")[:, :, :3] * 255).round().astype(int)
    faults = []
    for place, name, wanted in ((PHONE, "at its beginning", True), (2 * PHONE + 8, "seen to its end", False)):
        blue = (abs(picture[:400, place - 20:place + 10] - (0, 114, 178)).max(axis=2) < 40).sum(axis=0).max()
        if (blue > FEWEST_EDGE) != wanted:
            faults.append(f"a wide table, {name}: {blue} px of its edge are coloured")
    return faults


def main():
    folder = pathlib.Path(sys.argv[1])
    page = folder / "report.html"
    text = page.read_text(encoding="utf-8")
    faults = [] if len(text.encode()) <= BIGGEST else [f"the page has {len(text.encode())} bytes"]
    data = json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S).group(1))
    if "default-src 'none'" not in text or "unsafe-eval" in text or "script-src 'unsafe" in text:
        faults.append("the page lets other scripts run")
    views = {view: View(page, view, READOUTS) for view in views_of(data)}
    addresses = list(views)
    views |= views_without_script(text)
    views |= {"bare": View(page, "case=none", NO_CURVES), "own": View(page), "beyond": View(page, f"case={CASES[0]}&depth=5000"), "field": View(page, "units=field"), "phone": view_of_phone(text)}
    views |= {name: View(page, f"case={CASES[0]}", script=script) for name, script in (("touch", FINGERS), ("typed", TYPED), ("chosen", CHOSEN), ("well", COLOURED), ("curves", CURVES), ("printed", PRINTED))}
    views |= dict(zip(WIDTHS, views_of_labels(text)))
    told = dict(zip(views, opened(views.values())))
    compared = 0
    for view in addresses:
        found, n = faults_of_view(folder, data, view, *told[view])
        faults, compared = faults + found, compared + n
    for name in ("refused", "failing"):
        faults += faults_without_script(name, told[name][0])
    for width in WIDTHS:
        faults += faults_of_labels(told[width][0], width)
    field, own = told["field"][0] or "", told["own"][0] or ""
    found, n = faults_of_tables(folder, *told["field"], own)
    faults += found + faults_of_sentences(field) + faults_of_no_curves(*told["bare"]) + faults_of_beyond(*told["beyond"]) + faults_of_phone(told["phone"][0])
    faults += faults_of_touch(*told["touch"]) + faults_of_typing(*told["typed"]) + faults_of_choice(*told["chosen"]) + faults_of_print(*told["printed"])
    faults += faults_of_well(folder, *told["well"]) + faults_of_curves(folder, *told["curves"]) + faults_of_edge(text)
    print(f"{compared} values read off the page, {n} off its tables")
    if compared < 150 or n < 500:
        faults.append(f"only {compared} values could be compared")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Asks the charts of studies on report.html in a real browser: what they read off must be what the CSV files have.

A deck of its own has two sweeps, with measured points, limits of the rig, points that lock up and one that fails; a calibration
with a name that would end a script; a Monte Carlo. Checked: seven depths of each sweep, five of the Monte Carlo, rows of the calibration
and of the hook loads, one of them in other units; switches of the legend, zoom by dragging, the slider's words; that the
address holds the view; that no label is cut or lies on another, a phone need not scroll sideways, names stay text, the browser does
not complain, and fixed pictures and tables stand without a script. Printed it has ten sheets at most.

Usage: check_figures.py PATH_TO_DRILLGAP
"""
import collections
import csv
import html
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

from browser import MADE, View, browser, opened
from check_page import CLOSE, CURVES, INVERSE, OTHER_CURVES, Profile, WIDTHS, faults_of_curves, faults_of_labels, faults_of_phone, view_of_phone, views_of_labels

HOSTILE = """Bob's "fit" </script><img src=x onerror=document.title=1>"""
DECK = f"""&job title = 'Broomsticks </script><b>', models = 'mcge', 'soft', hdf5 = .false. /
&trajectory md = 0, 600, 1500, 2400, inc = 0, 0, 80, 92, azi = 0, 0, 20, 40 /
&hole name = 'cased <i>"', md_bottom = 1500, diameter = 220.5, friction = 0.25, cased = .true. /
&hole name = 'open', diameter = 215.9, friction = 0.35 /
&fluid density = 1200 /
&solver max_iterations = 25 /
&rig block_weight = 200, max_hookload = 1300, max_torque = 20 /
&component name = 'collars', kind = 'collar', length = 60, od = 165, id = 71.4 /
&component name = 'pipe', od = 127, id = 108.6, mass = 31.9, joint_od = 165, joint_spacing = 9.5, yield = 724 /
&load_case name = 'pull_A', operation = 'up', bit_depth = 2000, measured_hookload = 700 /
&load_case name = 'push_A', operation = 'down', bit_depth = 2000, measured_hookload = 380 /
&load_case name = 'turn', operation = 'rotate_off_bottom', bit_depth = 2000, measured_hookload = 540, measured_torque = 6 /
&load_case name = 'pull_B', operation = 'up', bit_depth = 2400, measured_hookload = 760 /
&load_case name = 'push_B', operation = 'down', bit_depth = 2400, measured_hookload = 330 /
&sweep name = 'beams', model = 'mcge', operations = 'up', 'down', 'rotate_off_bottom', bit_depth_from = 300, bit_depth_step = 100,
  frictions = 0.3, 0.8, measured_depths = 1250, 1750, measured_operations = 'up', measured_hookloads = 620, 660 /
&sweep name = 'locked', model = 'soft', operations = 'sliding', wob = 100, bit_depth_from = 300, bit_depth_step = 100,
  frictions = 0.3, 0.8 /
&calibrate name = '{HOSTILE.replace("'", "''")}', parameter = 'friction', separate = 'holes', offset = 'depths', model = 'soft' /
&uncertainty name = 'spread', model = 'soft', operations = 'up', 'rotate_off_bottom', bit_depth_from = 600, bit_depth_step = 300,
  samples = 100, seed = 1, friction_deviation = 0.05, density_deviation = 20 /
"""
#: A depth that rounds up, a string of half a metre, names that fill a row. Field units.
ENDS = """&job title = 'Ends', units = 'field', models = 'mcge', 'soft', hdf5 = .false. /
&trajectory md = 0, 2000, 5000, 10465.8793, inc = 0, 0, 80, 92, azi = 0, 0, 20, 40 /
&hole name = 'open', diameter = 8.5, friction = 0.3 /
&fluid density = 10 /
&component name = 'pipe', od = 5, id = 4.276, mass = 21.4, joint_od = 6.375, joint_spacing = 31, yield = 105 /
&load_case name = 'a_long_name_of_a_load_case_that_has_no_blank_1', operation = 'up', bit_depth = 10465.8793 /
&load_case name = 'half_a_metre', operation = 'down', bit_depth = 1.64 /
"""
SWEEP_ALONE = "&sweep name = 's', model = 'soft', operations = 'down', frictions = 0.1, 0.2, bit_depth_from = 2000, bit_depth_to = 8000, bit_depth_step = 2000 /\n"
#: A station each 10 m with noise of about 0.3 deg: nearly every row of every curve is a corner.
STATIONS = range(0, 3010, 10)
NOISY = f"""&job title = 'Noisy survey', models = 'mcge', 'soft', hdf5 = .false. /
&trajectory md = {", ".join(map(str, STATIONS))},
  inc = {", ".join(f"{min(80.0, max(0.0, 0.08 * (s - 500))) + 0.3 * abs(math.sin(s * s)):.2f}" for s in STATIONS)},
  azi = {", ".join(f"{40 + 0.4 * math.cos(3 * s * s):.2f}" for s in STATIONS)} /
&hole name = 'open', diameter = 215.9, friction = 0.3 /
&fluid density = 1300 /
&component name = 'collars', kind = 'collar', length = 60, od = 165, id = 71.4, yield = 758 /
&component name = 'heavy', length = 400, od = 127, id = 76.2, mass = 73.4, joint_od = 165, joint_spacing = 9.5, yield = 379 /
&component name = 'pipe', od = 127, id = 108.6, mass = 31.9, joint_od = 165, joint_spacing = 9.5, yield = 724 /
&load_case name = 'pushed', operation = 'sliding', bit_depth = 3000, wob = 3000 /
""" + "".join(f"&load_case name = '{name}_{k}', operation = '{name}', bit_depth = 3000, friction = 0.{k + 1} /\n" for name in ("up", "down") for k in range(4))
# These do not oscillate.
SMOOTH = ("axial", "sinusoidal_load", "buckling_margin", "inclination", "tvd")
MOST_NOISY = 64_000                     # bytes of the curves of a load case with such a survey, both models
LOST = 3                                # exit status: solutions that did not converge
NAMES = {"trip_out": "up", "trip_in": "down", "rotate_off_bottom": "rotating", "sliding_drilling": "sliding drilling"}
MEASURED = {("up", 1250): 620, ("up", 1750): 660, ("up", 2400): 760, ("down", 2400): 330}
DEPTHS = (300, 850, 1250, 1500, 1700, 2000, 2400)   # between points, beside a measurement, where a point fails, where some lock up
FIELD = {"m": 1 / 0.3048, "kN": 0.2248089431, "kN.m": 0.7375621493}
DASH = "\u2013"
IMPOSSIBLE, LOCKED = ", cannot be done", ", locked up, or value outside the chart"
SPREAD, SPREAD_DEPTHS = "Uncertainty spread, model soft", (600, 1000, 1500, 2000, 2400)
CALIBRATION, LOADS = f"Calibration {HOSTILE}, model soft", "Hook load of all cases"
SWEEPS = (("beams", "mcge"), ("locked", "soft"))
MOST_SHEETS = 10
FEWEST = 200                            # values that must have been compared

ACTIONS = """
setTimeout(() => {
   const b = blocks.find(b => b.S.title === TITLE), root = b.S.root, told = []
   const names = () => [...root.querySelectorAll('.readout td.text')].map(c => c.textContent)
   const press = text => [...root.querySelectorAll('button')].find(c => c.textContent === text).click()
   const later = () => new Promise(done => setTimeout(done, 50))
   const panel = () => root.querySelector('svg.panel'), paths = () => panel().querySelectorAll('g > path').length
   const point = (kind, part) => { const p = panel().getBoundingClientRect()
      panel().dispatchEvent(new PointerEvent(kind, {bubbles: true, pointerType: 'mouse', clientX: p.left + 90, clientY: p.top + part * p.height})) }
   const run = async () => {
      const slider = root.querySelector('[type=range]')
      slider.value = 1000; slider.dispatchEvent(new Event('input', {bubbles: true})); await later()
      told.push(slider.getAttribute('aria-valuetext'), names().length, paths())
      press('down'); await later()
      told.push(names().some(n => n.startsWith('down, friction')), paths())
      press('down'); await later()
      const whole = b.state.bottom - b.state.top
      point('pointerdown', .4); point('pointermove', .6); point('pointerup', .6); await later()
      told.push((b.state.bottom - b.state.top) / whole, document.querySelectorAll('img').length)
      panel().dispatchEvent(new MouseEvent('dblclick', {bubbles: true})); await later()
      told.push((b.state.bottom - b.state.top) / whole)
      document.title = 'FOUND' + JSON.stringify(told)
   }
   run()
}, 300)
"""


HEADINGS = """
setTimeout(() => document.title = 'FOUND' + JSON.stringify([...document.querySelectorAll('.readout th')]
   .filter(h => h.scrollWidth > h.clientWidth + 1).map(h => h.textContent)), 300)
"""

ADDRESSES = """
setTimeout(async () => {
   const told = [], later = wait => new Promise(done => setTimeout(done, wait))
   const captions = () => [0, 2].map(i => blocks[i].S.root.querySelector('caption').textContent)
   document.querySelectorAll('a[href^="#case"]')[1].click(); await later(100)
   told.push(captions(), blocks[0].state.case)
   location.hash = '#chart=' + encodeURIComponent(TITLE) + '&depth=1250'; await later(100)
   blocks[2].S.root.querySelector('.bar button').click(); await later(600)
   told.push(captions(), location.hash)
   document.title = 'FOUND' + JSON.stringify(told)
}, 300)
"""


# The largest value of each curve, without its sign; the least safety factor.
PEAKS = r"""
setTimeout(() => {
   const far = (v, least) => v.filter(isFinite).reduce((a, b) => (least ? b < a : Math.abs(b) > Math.abs(a)) ? b : a)
   const names = p => Object.keys(p.curves).filter(name => !p.curves[name].words)
   document.title = 'FOUND' + JSON.stringify(D.profiles.map(p => [D.cases[p.case].name, p.model, Object.fromEntries(names(p).map(name => [name, far(p.curves[name].v, p.curves[name].inverse)]))]))
}, 300)
"""
PEAK = 2e-6                             # of a value: a number has seven digits


# Marks that end beyond what their clip leaves of them, in all charts of the run.
MARKS = """
setTimeout(() => document.title = 'FOUND' + JSON.stringify([...document.querySelectorAll('.panel g[clip-path]')].flatMap(g => {
   const {y, height} = document.querySelector(g.getAttribute('clip-path').slice(4, -1) + ' rect').getBBox()
   return [...g.querySelectorAll('path[stroke-width="1.6"]')].map(p => p.getBBox()).filter(b => b.height && (b.y < y - .1 || b.y + b.height > y + height + .1)).length
}).reduce((a, b) => a + b, 0)), 400)
"""


SCROLLED = """
setTimeout(() => document.title = 'FOUND' + JSON.stringify(blocks.find(b => b.S.title === TITLE).S.root.getBoundingClientRect().top), 400)
"""


def rows_of(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def readouts(text, title):
    """Tables of the blocks of a figure: name of a line -> values by panel."""
    part = text.split(f"<h3>{html.escape(title, quote=False)}</h3>")[1].split("</figure>")[0]
    tables = []
    for table in re.findall(r'class="wide readout".*?</table>', part, re.S):
        cells = [[html.unescape(re.sub(r"<[^>]*>", "", c)) for c in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row, re.S)]
                 for row in re.findall(r"<tr>(.*?)</tr>", table, re.S)]
        tables.append({row[0]: row[1:] for row in cells})
    return tables


def address(title, depth, units=""):
    return urllib.parse.urlencode({"chart": title, "depth": depth} | ({"units": units} if units else {}))


def line_at(points, depth):
    """Value of a line there: None where a point beside it is missing."""
    for (a, va), (b, vb) in zip(points, points[1:]):
        if a <= depth <= b:
            if depth in (a, b):
                return va if depth == a else vb
            return None if va is None or vb is None else va + (vb - va) * (depth - a) / (b - a)
    return None


def differs(shown, value, extent, factor=1.0):
    if value is None or shown == DASH:
        return (value is None) != (shown == DASH)
    digits = len(shown.partition(".")[2])
    return not abs(float(shown) - value * factor) <= (CLOSE * extent + 6e-5 * abs(value)) * factor + 0.51 * 10 ** -digits


def lines_of_sweep(path):
    """Name of a line -> its points with hook load as the rig shows it and torque; marks where it cannot be done."""
    lines, marks = {}, []
    for row in rows_of(path):
        name = f"{NAMES[row['operation']]}, friction {float(row['friction']):g}"
        solved = row["status"] == "converged"
        load, torque = (float(row[k]) if solved else None for k in ("weight_indicator_kN", "torque_kNm"))
        lines.setdefault(name, []).append((float(row["bit_depth_m"]), load, torque))
        if row["can_be_done"] == "no":
            marks.append((name, float(row["bit_depth_m"])))
    # a load farther below zero than the greatest is above is not drawn
    most = max([p[1] for points in lines.values() for p in points if p[1] is not None])
    lines = {name: [(d, None if v is None or v < -most else v, t) for d, v, t in points] for name, points in lines.items()}
    drawn = {(name, p[0]) for name, points in lines.items() for p in points if p[1] is not None}
    return lines, [(name + (IMPOSSIBLE if (name, d) in drawn else LOCKED), d) for name, d in marks]


def title_of_sweep(name, model):
    return f"Sweep {name}, model {model}"


def units_at(depth):
    return "field" if depth == DEPTHS[1] else ""


def faults_of_sweep(folder, name, model, shown_at, count):
    faults = []
    lines, marks = lines_of_sweep(folder / f"sweep_{name}.csv")
    title = title_of_sweep(name, model)
    for depth in DEPTHS:
        units = units_at(depth)
        f = FIELD if units else dict.fromkeys(FIELD, 1.0)
        (told,) = shown_at(title, depth, units)
        wanted = {}
        for line, points in lines.items():
            extents = [max(v) - min(v) for v in ([p[k] for p in points if p[k] is not None] for k in (1, 2))]
            wanted[line] = [(line_at([(p[0], p[k]) for p in points], depth), extents[k - 1]) for k in (1, 2)]
            if not line.startswith("rotating"):
                wanted[line][1] = (None, 0.0)
        # a mark has the values of its line, and one row with it; at the edge it has none
        wanted |= {line: wanted.pop(line.removesuffix(IMPOSSIBLE).removesuffix(LOCKED)) for line, d in marks if d == depth}
        if name == "beams":
            wanted |= {f"{line}, measured": [(v, 0.0), (None, 0.0)] for (line, d), v in MEASURED.items() if d == depth}
            wanted |= {f"{line}, measured": [(v, 0.0), (t, 0.0)] for line, v, t in (("up", 700, None), ("down", 380, None), ("rotating", 540, 6)) if depth == 2000}
        wanted["limit of the rig"] = [(1300, 0.0), (20 if name == "beams" else None, 0.0)]
        for line, values in wanted.items():
            shown = told.get(line)
            if shown is None:
                faults.append(f"{title} at {depth}: nothing of {line}")
                continue
            for text, (value, extent), factor in zip(shown, values, (f["kN"], f["kN.m"])):
                count[0] += 1
                if differs(text, value, extent, factor):
                    faults.append(f"{title} at {depth}: {line} is shown as {text}, the file has {value}")
        extra = set(told) - set(wanted) - {"curve"}
        if any(not line.startswith("pipe yields at ") for line in extra):
            faults.append(f"{title} at {depth}: {extra} should not be told")
    return faults


def faults_of_spread(folder, shown_at, count):
    faults, points = [], {}
    for row in rows_of(folder / "uncertainty_spread.csv"):
        for k in ("p10", "p50", "p90"):
            points.setdefault(f"{NAMES[row['operation']]}, {k.upper()}", []).append((float(row["bit_depth_m"]), float(row[f"weight_indicator_{k}_kN"]), float(row[f"torque_{k}_kNm"])))
    for depth in SPREAD_DEPTHS:
        (told,) = shown_at(SPREAD, depth)
        for line, these in points.items():
            for k in (1, 2) if line.startswith("rotating") else (1,):
                count[0] += 1
                extent = max(p[k] for p in these) - min(p[k] for p in these)
                if differs(told.get(line, [DASH, DASH])[k - 1], line_at([(p[0], p[k]) for p in these], depth), extent):
                    faults.append(f"uncertainty at {depth}: {line} is shown as {told.get(line)}")
    return faults


def factors_of(folder):
    return [row for row in rows_of(folder / "calibration.csv") if row["parameter"] == "friction"]


def cases_of(folder):
    return list(dict.fromkeys(row["case"] for row in rows_of(folder / "summary.csv")))


def faults_of_rows(folder, shown_at, count):
    """The calibration's factors and the hook loads of all cases, a row each."""
    faults = []
    for number, row in enumerate(factors_of(folder), 1):
        told = shown_at(CALIBRATION, number)[0]
        interval = f"{float(row['value']):.3f} ({float(row['lower']):.3f} to {float(row['upper']):.3f})"
        for name, text in (("before", f"{float(row['start']):.3f}"), ("after", f"{float(row['value']):.3f}"), ("95 % interval", interval)):
            count[0] += 1
            if told.get(name) != [text]:
                faults.append(f"calibration, row {number}: {name} is shown as {told.get(name)}, the file has {text}")
    cases = cases_of(folder)
    for row in rows_of(folder / "summary.csv"):
        (told,) = shown_at(LOADS, cases.index(row["case"]) + 1)
        values = [float(row["weight_indicator_kN"]), float(row["error_pct"]), float(row["torque_kNm"]) if row["case"] == "turn" else None]
        for text, value in zip(told.get(row["model"], []), values):
            count[0] += 1
            if differs(text, value, 0.0):
                faults.append(f"hook loads, {row['case']}: {row['model']} is shown as {text}, the file has {value}")
    return faults


def views_at(folder):
    """A view for each chart and depth, or row, that is compared; by title, depth and units."""
    wanted = [(title_of_sweep(*sweep), depth, units_at(depth)) for sweep in SWEEPS for depth in DEPTHS]
    wanted += [(SPREAD, depth, "") for depth in SPREAD_DEPTHS]
    wanted += [(CALIBRATION, number, "") for number, _ in enumerate(factors_of(folder), 1)]
    wanted += [(LOADS, number, "") for number, _ in enumerate(cases_of(folder), 1)]
    return {key: View(folder / "report.html", address(*key)) for key in wanted}


def views_of_actions(page):
    """Scripts that act on a sweep, on addresses, on a page that is opened at a sweep."""
    title = title_of_sweep(*SWEEPS[0])
    scripts = {"actions": (ACTIONS, ""), "links": (ADDRESSES, ""), "scrolled": (SCROLLED, address(title, 1250, "field"))}
    return {name: View(page, where, script=script.replace("TITLE", json.dumps(title))) for name, (script, where) in scripts.items()}


def faults_of_addresses(told, place):
    """An answer's link opens its load case at the depth of its limit, here the surface; an address opens a sweep at a depth."""
    query = address(title_of_sweep(*SWEEPS[0]), 1250, "field")
    wanted = [["At 0 m measured depth", "At 2400 m measured depth of the bit"], ["push_A"], ["At 0 ft measured depth", "At 4101.05 ft measured depth of the bit"], "#" + query]
    faults = [] if told == wanted else [f"links lead to {told}"]
    return faults + ([] if place is not None and abs(place) < 5 else [f"an address opens its chart {place} px below the top"])


def faults_of_actions(told):
    """Slider, legend, zoom and back."""
    if not told:
        return ["nothing was done on a sweep"]
    faults = []
    words, lines, paths, left, fewer, zoomed, images, whole = told
    if "1000 m" not in words or "up, friction 0.3" not in words or lines < 7:
        faults.append(f"the slider says '{words}', the box has {lines} lines")
    if left or not fewer < paths:
        faults.append("the legend does not switch lines off")
    if not 0.15 < zoomed < 0.35 or whole != 1:
        faults.append(f"dragging leaves {zoomed} of the depth, a double click {whole}")
    if images:
        faults.append("a name became an element")
    return faults


def faults_of_paper(page):
    """Five load cases, two sweeps, a calibration and a Monte Carlo fit ten sheets."""
    with tempfile.TemporaryDirectory() as scratch:
        pdf = pathlib.Path(scratch) / "page.pdf"
        browser(f"--print-to-pdf={pdf}", page.resolve().as_uri())
        sheets = len(re.findall(rb"/Type /Page\b", pdf.read_bytes()))
    return [] if 0 < sheets <= MOST_SHEETS else [f"the page has {sheets} sheets"]


def faults_of_ends(program, scratch):
    """Curves reach the bit, whatever its depth rounds to; a short string is drawn; no number is -0; no heading leaves its cell."""
    deck, folder = pathlib.Path(scratch) / "ends.nml", pathlib.Path(scratch) / "ends"
    deck.write_text(ENDS, encoding="utf-8")
    run = subprocess.run([program, deck, "--output", folder], capture_output=True, text=True, check=False)
    if run.returncode:
        return [f"ends: exit status {run.returncode}: {run.stderr}"]
    page, faults = folder / "report.html", []
    views = {(case, chart): View(page, urllib.parse.urlencode({"case": case, "chart": chart, "depth": 1.0}), MADE_WITH_PICTURES)
             for case in ("a_long_name_of_a_load_case_that_has_no_blank_1", "half_a_metre") for chart in ("Forces", "Buckling", "Well")}
    views["headings"] = View(page, script=HEADINGS)
    told = dict(zip(views, opened(views.values())))
    headings, _ = told["headings"]
    for name, (made, complaints) in told.items():
        faults += [f"ends, {name}: {what}" for what in complaints]
        if name != "headings":
            faults += [f"ends, {name}: {what}" for what in set(re.findall(r"\bNaN\b|>-0(?:\.0*)?<", made or "NaN"))]
    deck.write_text(re.sub(r"&load_case.*", "", ENDS) + SWEEP_ALONE, encoding="utf-8")
    run = subprocess.run([program, deck, "--output", folder], capture_output=True, text=True, check=False)
    text = page.read_text(encoding="utf-8")
    levels = [int(level) for level in re.findall(r"<h(\d)>", text)]
    told = [*re.findall("Can be done", run.stdout), *re.findall("answers stand under In short|bit down to|Friction factor 0.3|friction factor 0.1 to 0.2|Can be done|pipe yields at", text)]
    if told != ["Can be done", "bit down to", "friction factor 0.1 to 0.2", "answers stand under In short", "Can be done", "Can be done"]:
        faults.append(f"a sweep without a load case tells {told}")
    if len(levels) < 3 or any(after > before + 1 for before, after in zip(levels, levels[1:])):
        faults.append(f"without a load case headings have the levels {levels}")
    return faults + [f"ends: the heading {text} lies on the next one" for text in headings or []] + ([] if headings is not None else ["ends: headings were not looked at"])


def faults_of_peaks(folder, told):
    """The largest value of each curve is that of its file, however much the curve is thinned; of a safety factor the least one."""
    faults = [] if told else ["peaks were not looked at"]
    for case, model, peaks in told or []:
        profile = Profile(folder, case, model)
        for name in (name for name in peaks if name not in OTHER_CURVES):
            values = [value for value in profile.column(name) if value is not None]
            wanted = min(values) if name in INVERSE else max(values, key=abs)
            if abs(peaks[name] - wanted) > PEAK * abs(wanted):
                faults.append(f"{case} {model}: the peak of {name} is {peaks[name]}, the file has {wanted}")
    return faults


def faults_of_noise(program, scratch):
    """Curves with too many points have fewer of them, stay within what the page says, keep their peaks, and say so above their values."""
    deck, folder = pathlib.Path(scratch) / "noisy.nml", pathlib.Path(scratch) / "noisy"
    deck.write_text(NOISY, encoding="utf-8")
    run = subprocess.run([program, deck, "--output", folder], capture_output=True, text=True, check=False)
    if run.returncode:
        return [f"noisy: exit status {run.returncode}: {run.stderr}"]
    page = folder / "report.html"
    (curves, complaints), (made, _), (peaks, _) = opened([View(page, script=CURVES), View(page, "case=down_3&chart=Forces&depth=2000"), View(page, script=PEAKS)])
    faults, sizes = [], collections.Counter()
    for profile in json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page.read_text(encoding="utf-8"), re.S).group(1))["profiles"]:
        sizes[profile["case"]] += len(json.dumps(profile, ensure_ascii=False, separators=(",", ":")).encode())
    faults += [f"load case {case} has {size} bytes" for case, size in sizes.items() if size > MOST_NOISY]
    bands = {name for _, _, _, bands, _ in curves or [] for name, band in bands.items() if band}
    if "8 load cases have many points" not in (made or "") or "as the box of values says" not in made or "bending" not in bands or not re.search("\\d \u00b1\\d", made):
        faults.append(f"the curves {bands} are less exact, the page does not say so")
    faults += [f"{name} is thinned like a curve that oscillates" for name in bands & set(SMOOTH)]
    faults += faults_of_peaks(folder, peaks)
    return [f"noisy: {fault}" for fault in faults + faults_of_curves(folder, curves, complaints)]


# Of a page whose script is refused: pictures and tables of the run.
NO_SCRIPT = "(part => [part.split('<svg').length - 1, part.split('<summary>Numbers').length - 1])(d.body.innerHTML.split('Pictures of the run')[1])"
MADE_WITH_PICTURES = MADE.replace("'svg, script, style'", "'script, style'")


def view_without_script(text):
    return View(re.sub(r"sha256-[^']*", "sha256-" + "A" * 43 + "=", text, count=1), tell=NO_SCRIPT)


def faults_without_script(found):
    """Fixed pictures of all studies and their tables."""
    return [] if found == [6, 6] else [f"without a script {found} pictures and tables of the run stand"]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    count = [0]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "results"
        deck = pathlib.Path(scratch) / "figures.nml"
        deck.write_text(DECK, encoding="utf-8")
        run = subprocess.run([program, deck, "--output", folder], capture_output=True, text=True, check=False)
        if run.returncode != LOST:
            print("FAULT exit status", run.returncode, run.stdout[-500:], run.stderr)
            return 1
        page = folder / "report.html"
        states = {row["status"] for row in rows_of(folder / "sweep_beams.csv")}
        faults = [] if states == {"converged", "locked_up", "not_converged"} else [f"the sweep has only {states}"]
        text = page.read_text(encoding="utf-8")
        views = views_at(folder) | views_of_actions(page) | {"phone": view_of_phone(text), "marks": View(page, script=MARKS), "no script": view_without_script(text)}
        views |= dict(zip(WIDTHS, views_of_labels(text)))
        told = dict(zip(views, opened(views.values())))
        faults += [f"{name}: the browser complains: {c}" for name, (_, complaints) in told.items() if name != "no script" for c in complaints]

        def shown_at(title, depth, units=""):
            return readouts(told[title, depth, units][0] or "", title)

        for sweep in SWEEPS:
            faults += faults_of_sweep(folder, *sweep, shown_at, count)
        faults += faults_of_spread(folder, shown_at, count) + faults_of_rows(folder, shown_at, count)
        faults += faults_of_actions(told["actions"][0]) + faults_of_addresses(told["links"][0], told["scrolled"][0])
        for width in WIDTHS:
            faults += faults_of_labels(told[width][0], width)
        faults += [] if told["marks"][0] == 0 else [f"{told['marks'][0]} marks are cut"]
        faults += [] if '"turn, torque"' in text else ["the calibration does not say that an error is of a torque"]
        faults += faults_of_phone(told["phone"][0]) + faults_without_script(told["no script"][0])
        faults += faults_of_paper(page) + faults_of_ends(program, scratch) + faults_of_noise(program, scratch)
    print(f"{count[0]} values read off the page")
    if count[0] < FEWEST:
        faults.append(f"only {count[0]} values could be compared")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

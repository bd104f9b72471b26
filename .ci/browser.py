"""Pages as a real browser without a screen shows them. To start it takes longer than to open a page: one start opens many of them,
one after the other, each in a frame of its own."""
import html
import json
import pathlib
import re
import subprocess
import tempfile
import typing

POLICY = re.compile(r'<meta http-equiv="Content-Security-Policy"[^>]*>')
# What a view tells, by the document d of its frame: the page as the script made it, without pictures and data; boxes of values.
MADE = ("(() => { const copy = d.documentElement.cloneNode(true); copy.querySelectorAll('svg, script, style').forEach(e => e.remove()); "
        "return copy.outerHTML })()")
READOUTS = "[...d.querySelectorAll('.readout')].map(e => e.outerHTML).join('')"
# Opens each job: address, width and height of its frame, what it tells. A page with a script of the check tells by its title, at last.
OPENER = """<html><body><script>
const jobs = %s, told = []
const later = wait => new Promise(done => setTimeout(done, wait))
const run = async () => {
   for (const [url, width, height, tell] of jobs) {
      console.log('OPENS')
      const frame = document.createElement('iframe')
      frame.style = `border:0;width:${width}px;height:${height}px`
      const there = new Promise(done => frame.onload = done)
      frame.src = url
      document.body.append(frame)
      await there
      const d = frame.contentDocument
      for (let k = 0; tell === '' && k < 90 && !d.title.startsWith('FOUND'); k++) await later(100)
      if (tell !== '') await later(600)
      told.push(tell === '' ? d.title : Function('d', 'return ' + tell)(d))
      frame.remove()
   }
   document.body.textContent = 'FOUND' + JSON.stringify(told)
}
run()
</script></body></html>"""
SECONDS = 10                # of the browser's own time, for a page


class View(typing.NamedTuple):
    """A page, by its path or its text, at an address. `script` acts on it and ends with a title, FOUND and JSON: that is told."""
    page: pathlib.Path | str
    address: str = ""
    tell: str = MADE
    script: str = ""
    width: int = 1200
    height: int = 1000


def browser(*options):
    with tempfile.TemporaryDirectory() as home:
        return subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr", f"--user-data-dir={home}", *options],
                              capture_output=True, text=True, timeout=600, check=False)


def opened(views):
    """What each view tells, None where it does not come to that, and what the browser complained of there."""
    views = list(views)
    with tempfile.TemporaryDirectory() as scratch:
        jobs = []
        for number, view in enumerate(views):
            path = view.page
            if view.script or isinstance(path, str):
                text = path if isinstance(path, str) else path.read_text(encoding="utf-8")
                if view.script:
                    text = POLICY.sub("", text).replace("</body>", f"<script>{view.script}</script></body>")
                path = pathlib.Path(scratch) / f"{number}.html"
                path.write_text(text, encoding="utf-8")
            jobs.append([path.resolve().as_uri() + ("#" + view.address if view.address else ""), view.width, view.height, "" if view.script else view.tell])
        outer = pathlib.Path(scratch) / "opener.html"
        outer.write_text(OPENER % json.dumps(jobs), encoding="utf-8")
        run = browser("--allow-file-access-from-files", f"--virtual-time-budget={1000 * SECONDS * len(jobs)}", "--dump-dom", outer.as_uri())
    found = re.search(r"<body>FOUND(.*)</body>", run.stdout, re.S)
    told = json.loads(html.unescape(found.group(1))) if found else [None] * len(views)
    complaints = [re.findall(r"CONSOLE[^\n]*", part) for part in re.split(r'CONSOLE[^\n]*"OPENS"[^\n]*', run.stderr)[1:]]
    complaints += [["the browser did not come to this page"]] * (len(views) - len(complaints))
    return [(acted(text) if view.script else text, said) for view, text, said in zip(views, told, complaints)]


def acted(title):
    """What a script told in the title of its page; None where it did not come to its end."""
    return json.loads(title[len("FOUND"):]) if title and title.startswith("FOUND") else None


def told_by(page, script):
    """What a script finds that acts on a page, and what the browser complained of."""
    told, complaints = opened([View(page, script=script)])[0]
    return told, [f"the browser complains: {c}" for c in complaints]

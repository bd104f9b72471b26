#!/usr/bin/env python3
"""The manual page app/drillgap.1 against the program's sources: options, exit statuses, version.

Every option of --help and of the list in app/arguments.f90 has a heading in the page, and the page has no other; so have the exit
statuses. The version is that of fpm.toml and the newest of CHANGELOG.md. Where `groff` is there it must format the page without a
warning.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    page = (ROOT / "app/drillgap.1").read_text(encoding="utf-8").replace("\\-", "-")
    source = (ROOT / "app/arguments.f90").read_text(encoding="utf-8")
    usage = re.sub(r"'// &\s*'", "", source[source.index("subroutine usage_lines"):])
    version = re.search(r"program_version = '(.+?)'", (ROOT / "src/base/version.f90").read_text(encoding="utf-8")).group(1)
    entries = re.findall(r"^\.TP\n(.*)$", page, re.M)
    told = {option for entry in entries for option in re.findall(r"--[a-z][a-z-]*|(?<=\s)-[a-z]\b", entry)}
    known = set(re.findall(r"'(--[a-z-]+)'", source[source.index("options("):source.index("contains")]))
    read = set(re.findall(r"'(--?[a-z][a-z-]*)'", source[:source.index("subroutine usage_lines")]))
    helped = set(re.findall(r"--[a-z][a-z-]*", usage))
    faults = [f"{option}: in --help or understood, not in the manual page" for option in sorted((known | read | helped) - told)]
    faults += [f"{option}: in the manual page, not understood" for option in sorted(told - read)]
    faults += [f"{option}: understood, not in --help" for option in sorted(known - helped)]
    statuses = set(re.findall(r"[ ,](\d) [a-z]", usage[usage.index("exit status"):]))
    listed = {entry.split()[-1] for entry in entries if re.fullmatch(r"\.B \d", entry)}
    if statuses != listed:
        faults.append(f"exit statuses: {sorted(listed)}, --help has {sorted(statuses)}")
    if f'"drillgap {version}"' not in page:
        faults.append(f"its heading does not tell version {version}")
    manifest = re.search(r'^version = "(.+?)"', (ROOT / "fpm.toml").read_text(encoding="utf-8"), re.M).group(1)
    newest = re.search(r"^## (\d\S*)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M).group(1)
    others = (("fpm.toml", manifest), ("CHANGELOG.md", newest))
    faults += [f"{place} is version {other}, the program {version}" for place, other in others if other != version]
    if shutil.which("groff"):
        shown = subprocess.run(["groff", "-man", "-Tutf8", "-ww", str(ROOT / "app/drillgap.1")], capture_output=True, text=True,
                               check=False)
        if shown.returncode != 0 or shown.stderr:
            faults.append(f"groff: {shown.stderr}")
    for fault in faults:
        print("FAULT app/drillgap.1:", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

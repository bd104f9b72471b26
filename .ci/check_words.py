#!/usr/bin/env python3
"""Checks length, sentences and links of the documents.

  words      at most LIMITS of a document; CHANGELOG.md: of each release. Blocks of code and tables that checks make do not count.
  sentences  at most LONGEST words. A code span is one word; a cell of a table is a sentence.
  links      each link from one document to another names a file that is there, and a heading in it.

Usage: check_words.py [FILE...]     with files, also prints every sentence above 25 words
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMITS = {
    "README.md": 1600,
    "input/README.md": 2500,
    "output/README.md": 1500,
    "test/README.md": 1500,
    "src/README.md": 3500,
    "src/library/README.md": 800,
    "src/theory/index.md": 3000,
    "src/tried.md": 2000,
}
CHANGES, RELEASE = "CHANGELOG.md", 800
LONGEST = 30    # words of a sentence
LONG = 25       # words from which on a sentence is printed on request
FENCED = re.compile(r"^( *)```.*?^\1```[^\n]*$", re.M | re.S)
MADE = re.compile(r"<!-- (?:keys of \w+|units|columns: \w+|extremes|names of the library) -->\n.*?<!-- end[ \w]*-->", re.S)
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def prose(text):
    """What people read: no code, no tables that checks make, no comments; links as their words."""
    for pattern in (FENCED, MADE, re.compile(r"<!--.*?-->", re.S), re.compile(r"^ {4,}(?![-*0-9 ]).*$", re.M)):
        text = pattern.sub("", text)
    return LINK.sub(r"\2", text)


def words(text):
    """Words of a text; a code span is one."""
    return len(re.findall(r"[^\s|]*\w[^\s|]*", re.sub(r"`[^`\n]*`", "code", text)))


def sentences(text):
    """Sentences of paragraphs, items of lists, headings and cells of tables."""
    for block in re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )|\n(?=#)|\n(?=\|)", text):
        for cell in block.split("|") if block.startswith("|") else [block]:
            flat = re.sub(r"`[^`]*`", "code", " ".join(cell.split()))
            yield from re.split(r"(?<=[.!?:])[*\"')]* (?=[A-Z*\"'(]|code)", flat)


def slug(heading):
    """The anchor of a heading."""
    plain = re.sub(r"[`*]", "", LINK.sub(r"\2", heading)).strip().lower()
    return re.sub(r" ", "-", re.sub(r"[^\w\- ]", "", plain))


def anchors(path):
    return {slug(line) for line in re.findall(r"^#+ (.*)$", FENCED.sub("", path.read_text(encoding="utf-8")), re.M)}


def faults_of_links(path, text):
    for _, _, target in LINK.findall(FENCED.sub("", text)):
        if re.match(r"[a-z]+:", target) or target.endswith(".html") or ".html#" in target:
            continue
        name, _, anchor = target.partition("#")
        other = (path.parent / name).resolve() if name else path
        if not other.exists():
            yield f"link to {target}: no such file"
        elif anchor and anchor not in anchors(other):
            yield f"link to {target}: no such heading"


def faults_of(path, limit, told):
    text = path.read_text(encoding="utf-8")
    plain, name = prose(text), path.relative_to(ROOT).as_posix()
    parts = re.split(r"^## (?=\d)", plain, flags=re.M)[1:] if name == CHANGES else [plain]
    for part in parts:
        count, title = words(part), f"{name} {part.split()[0]}" if name == CHANGES else name
        print(f"  {title}: {count} of {limit} words")
        if count > limit:
            yield f"{title}: {count} words, at most {limit}"
    for sentence in sentences(plain):
        count = words(sentence)
        if count > LONGEST:
            yield f"{name}: sentence of {count} words, at most {LONGEST}: {sentence[:90]}"
        elif told and count > LONG:
            print(f"    {count}: {sentence[:110]}")
    yield from (f"{name}: {fault}" for fault in faults_of_links(path, text))


def main():
    asked = sys.argv[1:]
    documents = {**LIMITS, CHANGES: RELEASE}
    faults = [fault for name, limit in documents.items() if (not asked or name in asked)
              for fault in faults_of(ROOT / name, limit, bool(asked))]
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

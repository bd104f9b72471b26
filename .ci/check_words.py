#!/usr/bin/env python3
"""Checks length, sentences and links of the documents, and sentences of the comments of src/ and app/.

  words      at most LIMITS of a document; CHANGELOG.md: of each release. Blocks of code and tables that checks make do not count.
  sentences  at most LONGEST words. A code span is one word; a cell of a table is a sentence.
  links      each link from one document to another names a file that is there, and a heading in it.
  comments   at most LONG words a sentence of a comment. A formula is one word; an item of a list is a sentence. Lines that follow
             each other are read as one text. A semicolon, a colon or a bracket ends no sentence.

Usage: check_words.py [FILE...]     with documents, also prints every sentence above 25 words; with .f90 files, checks these alone
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
LONG = 25       # words of a sentence of a comment; longer ones of documents are printed on request
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


OPERATOR = r"(?:==|/=|<=|>=|\*\*|//|->|=>|[=<>+*/^~-])"
FORMULA = re.compile(rf"\S+(?: {OPERATOR} \S+)+")
SHOWN = re.compile(r" {3,}(?=.* (?:=|<=?|>=?|-) )(?!(?:.* [A-Za-z]{4,}(?= |$)){3})")   # a line that shows a formula, no prose
ITEM = re.compile(r"(?:[-*]|\d{1,2}[.)]) ")
SHORT = re.compile(r"\b(e\.g|i\.e|cf|et al|vs|(?:eqs?|fig|no|vol|pp?)(?=\. *\d))\.", re.I)   # a full stop that ends no sentence


def code_of(line, quote):
    """Length of a line up to its comment, and the quote of a text that the line leaves open."""
    for column, letter in enumerate(line):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "'\"":
            quote = letter
        elif letter == "!":
            return column, ""
    return len(line), quote


def comments(text):
    """Comments of a Fortran source, each with the number of its first line and of its lines. Lines that continue a comment are
    joined, but for items of lists. A formula on an indented line of its own ends a sentence. Directives of OpenMP do not count."""
    found, before, mark, quote = [], "", "", ""   # before, mark: kind and mark of the comment that the line before ends with
    for number, line in enumerate(text.splitlines(), 1):
        length, quote = code_of(line, quote)
        rest, alone, last = line[length:], not line[:length].strip(), mark
        mark = rest[:2] if rest[1:2] in ("<", ">") else "!"
        said = re.sub(r"^![!<>]?", "", rest).strip()
        if rest.startswith("!$") or not said:
            before = ""
            continue
        if SHOWN.match(rest.lstrip("!<>")):
            said = "formula."
        if alone and mark == last and (before == "alone" or before == "after" and mark == "!<") and not ITEM.match(said):
            found[-1][2] += 1
            found[-1][1] += " " + said
        else:
            found.append([number, said, 1])
        before = "alone" if alone and before != "after" else "after"
    return found


def comment_words(sentence):
    """Words of a sentence of a comment: a code span and a formula are one each."""
    return words(FORMULA.sub("formula", re.sub(r"`[^`]*`", "code", sentence)))


def comment_sentences(text):
    """Sentences of a text; abbreviations and figures end none."""
    flat = SHORT.sub(lambda match: match.group(1), " ".join(text.split()))
    return re.split(r"(?<=[.!?])[\"')\]]* ", flat)


def faults_of_comments(name, text):
    for number, comment, _ in comments(text):
        for sentence in comment_sentences(comment):
            count = comment_words(sentence)
            if count > LONG:
                yield f"{name}:{number}: sentence of {count} words, at most {LONG}: {sentence}"


# Comments that must be found too long, and those that must not.
TWELVE = "one two three four five six seven eight nine ten eleven twelve"
MUST_FAIL = (
    f"!> {TWELVE}\n!> {TWELVE} and more.\n",
    f"   x = 1   !< {TWELVE},\n           !< {TWELVE} and more\n",
    f"x = '!'   ! {TWELVE}; {TWELVE} and more.\n",
    f"! {TWELVE}: {TWELVE} (and more).\n",
    f"! {TWELVE}, e.g. {TWELVE} more.\n",
    f"!> {TWELVE}\n!>   {TWELVE} = a\n!> and more.\n",
)
MUST_PASS = (
    f"!> {TWELVE}.\n!> {TWELVE}, and more.\n",
    f"!> {TWELVE}\n\n!> {TWELVE} and more.\n",
    f"!> {TWELVE}\n!> - {TWELVE}\n!> - {TWELVE}\n",
    f"x = 1   ! {TWELVE}\ny = 2   ! {TWELVE}\n! {TWELVE}\n",
    f"print *, '! {TWELVE} {TWELVE} and more'\n",
    f"print *, 'it &\n   &! {TWELVE} {TWELVE} and more'\n",
    f"! {TWELVE} {TWELVE} a + b*c = d - e(f)\n",
    f"!> {TWELVE}\n!>   a + b*c = d - e(f)\n!> {TWELVE}\n",
)


def faults_of_sources(asked):
    """Faults of the sources asked for, or of all; faults of this check itself first."""
    for tries, wanted in ((MUST_FAIL, 1), (MUST_PASS, 0)):
        for text in tries:
            count = len(list(faults_of_comments("", text)))
            if count != wanted:
                yield f"check_words.py: {count} sentences too long, not {wanted}, in {text!r}"
    paths = [path for top in ("src", "app") for path in sorted((ROOT / top).rglob("*.f90"))]
    for path in paths:
        name = path.relative_to(ROOT).as_posix()
        if not asked or name in asked:
            yield from faults_of_comments(name, path.read_text(encoding="utf-8"))


def main():
    asked = sys.argv[1:]
    documents = {**LIMITS, CHANGES: RELEASE}
    faults = [fault for name, limit in documents.items() if (not asked or name in asked)
              for fault in faults_of(ROOT / name, limit, bool(asked))]
    faults += faults_of_sources(asked)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Compares the messages in src and app with the texts that tests expect.

A message is a call that makes a fault, an error, a warning or a note, with its literals. It counts as tested where a test, or a
check of .ci, has LENGTH letters in a row of it (all of a shorter literal) that no other message has. More than ALLOWED untested messages fail. The number
is a bound to be lowered; a piece in a test says that somebody expects the message, not that each of its endings appears.

Usage: check_messages.py [--list]     --list prints the untested messages with file and line
"""
import collections
import re
import sys

from check_docs import ROOT

MAKER = re.compile(r"\bcall (\w*(?:fault|raise|refuse|report_line|message|note|advise)\w*|append_text)\(", re.I)
LITERAL = re.compile(r"'((?:[^']|'')*)'|\"((?:[^\"]|\"\")*)\"")
LENGTH, SHORTEST = 14, 10
ALLOWED = 2


def joined(path):
    """The text of a source: comment lines empty, continued lines as one. Each line of it begins with its number."""
    lines, out, number = path.read_text(encoding="utf-8").splitlines(), "", 0
    for i, line in enumerate(lines, 1):
        plain = re.sub(r"^\s*!.*", "", line).rstrip()
        held, in_text = plain, None
        for k, letter in enumerate(plain):
            if in_text is None and letter == "!":
                held = plain[:k].rstrip()
                break
            in_text = letter if in_text is None and letter in "'\"" else None if letter == in_text else in_text
        if number == 0:
            number = i
            out += f"\n{i}\t"
        if held.endswith("&"):
            out += held[:-1].rstrip() if out.endswith("\t") else held[:-1].strip()
            continue
        out += held if out.endswith("\t") else held.strip()
        number = 0
    return out


def call_end(text, start):
    """Where the parenthesis that opens before `start` closes."""
    depth, in_text = 1, None
    for k in range(start, len(text)):
        letter = text[k]
        if in_text:
            in_text = None if letter == in_text else in_text
        elif letter in "'\"":
            in_text = letter
        else:
            depth += (letter == "(") - (letter == ")")
        if depth == 0 or letter == "\n":
            return k
    return len(text)


def literals(text):
    return [(one or other).replace("''", "'").replace('""', '"') for one, other in LITERAL.findall(text)]


def messages():
    """File, line and literals of each message that has words."""
    for house in ("app", "src"):
        for path in sorted((ROOT / house).rglob("*.f90")):
            text = joined(path) if path.parent.name != "page" else ""
            for found in MAKER.finditer(text):
                inside = text[found.end():call_end(text, found.end())]
                if found.group(1).lower() == "append_text" and not re.match(r"\s*(?:notes|faults|warnings|messages)\b", inside):
                    continue
                pieces = [piece for piece in literals(inside) if len(piece.strip()) >= SHORTEST and " " in piece.strip()]
                if pieces:
                    line = text[text.rfind("\n", 0, found.start()) + 1:].split("\t", 1)[0]
                    yield path.relative_to(ROOT), line, pieces


def grams(piece):
    return {piece[k:k + LENGTH] for k in range(max(len(piece) - LENGTH, 0) + 1)}


def main():
    found = list(messages())
    expected = ""
    for path in sorted((ROOT / "test").rglob("*.f90")):
        expected += "\n".join(re.sub(r"['\"]\s*//\s*['\"]", "", line) for line in joined(path).splitlines()).replace("''", "'")
    for path in sorted((ROOT / ".ci").glob("*")):
        if path.suffix == ".py" and path.name != "check_messages.py":
            expected += re.sub(r"[\"']\s*\n\s*f?[\"']", "", path.read_text(encoding="utf-8"))
    of_one = [set().union(*(grams(piece) for piece in pieces)) for _, _, pieces in found]
    owners = collections.Counter(gram for one in of_one for gram in one)
    untested = []
    for (path, line, pieces), one in zip(found, of_one):
        own = {gram for gram in one if owners[gram] == 1} or one
        if not any(gram in expected for gram in own):
            untested.append(f"{path}:{line}: {' ... '.join(pieces)[:150]}")
    print(f"  {len(found)} messages, {len(found) - len(untested)} of them expected by a test, {len(untested)} by none")
    if "--list" in sys.argv[1:]:
        print("\n".join(untested))
    if len(untested) > ALLOWED:
        print(f"FAULT {len(untested)} messages are expected by no test, at most {ALLOWED} may be (--list prints them)")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

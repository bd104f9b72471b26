#!/usr/bin/env python3
"""Reads the fenced blocks of README.md, so that what it tells users to type is what is checked.

Usage: readme.py command WORD...     prints the one command line that holds all the words
       readme.py deck                prints the deck that the README lets users write
       readme.py python FILE         prints the one block of Python of a Markdown file
       readme.py printed FILE        checks that FILE holds the table that the README shows for that deck
"""
import pathlib
import re
import sys

FENCE = re.compile(r"^```[^\n]*\n(.*?)^```", re.M | re.S)


def blocks(path="README.md"):
    """The texts of the fenced blocks of a Markdown file."""
    return FENCE.findall(pathlib.Path(path).read_text(encoding="utf-8"))


def command(words, path="README.md"):
    """The one line of all fenced blocks that holds all the words, without prompt and comment."""
    lines = [re.sub(r"^\$ ", "", line.split(" #")[0].strip()) for block in blocks(path) for line in block.splitlines()]
    found = sorted({line for line in lines if all(word in line for word in words)})
    if len(found) != 1:
        raise SystemExit(f"{path}: {len(found)} command lines hold {' and '.join(words)}, expected one: {found}")
    return found[0]


def one_block(start):
    """The one fenced block that begins with a text."""
    found = [block for block in blocks() if block.startswith(start)]
    if len(found) != 1:
        raise SystemExit(f"README.md: {len(found)} blocks begin with {start}, expected one")
    return found[0]


def main(action, *words):
    if action == "command" and words:
        print(command(words))
    elif action == "deck" and not words:
        print(one_block("&"), end="")
    elif action == "python" and len(words) == 1:
        found = re.findall(r"^```python\n(.*?)^```", pathlib.Path(words[0]).read_text(encoding="utf-8"), re.M | re.S)
        if len(found) != 1:
            raise SystemExit(f"{words[0]}: {len(found)} blocks of Python, expected one")
        print(found[0], end="")
    elif action == "printed" and len(words) == 1:
        printed = "\n".join(line.rstrip() for line in pathlib.Path(words[0]).read_text(encoding="utf-8").splitlines())
        if one_block("Can it be done?").rstrip() not in printed:
            raise SystemExit("README.md: the table of the deck that users write is not what the run printed:\n" + printed)
    else:
        raise SystemExit(__doc__)


if __name__ == "__main__":
    main(*(sys.argv[1:] or [""]))

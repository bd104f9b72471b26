#!/usr/bin/env python3
"""Reads the fenced blocks of README.md, so that what it tells users to type is what is checked.

Usage: readme.py command WORD...     prints the one command line that holds all the words
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


if __name__ == "__main__":
    if len(sys.argv) < 3 or sys.argv[1] != "command":
        raise SystemExit(__doc__)
    print(command(sys.argv[2:]))

"""Texts that the program carries as arrays of Fortran: their rows, and whether a source is still what they make."""
import sys

LONGEST = 110   # letters of a text in a line of Fortran, which may have 132


def rows(lines):
    """Rows of an array, each text in pieces, the last with the bracket that closes the array."""
    text = []
    for line in lines:
        pieces = [""]
        for letter in line:
            if len(pieces[-1]) >= LONGEST:
                pieces.append("")
            pieces[-1] += letter.replace("'", "''")     # quotes count twice
        text += [f"      '{piece}'// &" for piece in pieces[:-1]] + [f"      '{pieces[-1]}', &"]
    text[-1] = text[-1][:-3] + "]"
    return text


def keep(source, text, fault):
    """Exit status: 1 where `source` does not hold `text`, which --write puts there."""
    if "--write" in sys.argv[1:]:
        source.write_text(text, encoding="ascii")
    same = source.exists() and source.read_text(encoding="ascii") == text
    if not same:
        print("FAULT", fault)
    return 0 if same else 1

"""Decks and tables as structures, and changes of them: by their structure and by their bytes. Texts are latin-1: any byte is one letter."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
KINDS = ["up", "down", "rotary", "sliding", "static", "rotate_off_bottom", "ream", "backream", "trip_out"]
NUMBERS = ["0", "-1", "1", "-0.0", "1e308", "-1e308", "1e-308", "1e309", "NaN", "nan", "Infinity", "-inf", "1e400", "9" * 40,
           "0." + "0" * 50 + "1", "1d5", "1e", "e5", "+-3", "0x1F", "1_8", ".", "-", "1000000000*0.0", "0*1", "-3*2", "3*", "*", "1e5", "1e-5",
           "1e-10", "1000000", "0.1", "0.5", "90", "180", "89.999999", "360", "1e15", "2147483648", "99999999999999999999", "1,5",
           "(1,2)", "'7'", ".true.", "''", "49999", "4.9e-324", "1.7976931348623157e308", "1e-300"]
# Texts that mean nothing else than themselves. What a shell or gnuplot would run leaves a file of this name.
CANARY = "EXECUTED"
TEXTS = ["", " ", "Bob's fit", "Bob's =1", 'x"y', "a,b", "a;b", r"a\b", "a\\", "%s%n%d", "@{x}_y^z", "{/Symbol a}", "é ü Ø 中文".encode().decode("latin-1"),
         "\u202egnp".encode().decode("latin-1"), "\x1b[31mred\x1b[0m", "\x07\x08\x7f", "\xff\xfe", "S\xfcd", "a\tb", "a\nb", "a\rb", "a\0b",
         "x" * 4096, "é".encode().decode("latin-1") * 2000, "<script>alert(1)</script>", "<td>NaN", "&amp;&lt;", "]]>", "--><b>", "../up",
         "/tmp/x", "=1+1", "-rf", "~", "*", "?", "[a]", "!x", "&job /", "/", "#x", f"`touch {CANARY}`", f"$(touch {CANARY})",
         f"'; system('touch {CANARY}'); '", f'"; system("touch {CANARY}"); "', f'".system("touch {CANARY}")."', f"`touch {CANARY}`\\",
         f"a\nsystem 'touch {CANARY}'\n", f"a\n!touch {CANARY}\n", "NaN", "Infinity", "all", "hookload",
         "+1", "-1+1", "@SUM(1)", "\t=1", "\r=1", " =1", "1=1", "a-b+c@d", "=cmd|' /C calc'!A0",
         *(f"a{letter}b".encode().decode("latin-1") for letter in "\u061c\u200e\u200f\u202a\u202c\u2066\u2069"),
         "\xe2\x80", "\xc0\xaf", "\xed\xa0\x80"]
# Names from which files are called, legal ones but odd.
NAMES = ["a", "A", "a_mcge", "a_soft", "1", "all", ".", "..", "-", "-o", ".hidden", "a.b", "a.csv", "a.unfinished", "a.partial", "part_1_of_2",
         "summary", "hookload", "u" * 100, "u" * 200, "u" * 240, "u" * 300, "CON", "a+b", "_", "NaN"]
NAME_KEYS = {("load_case", "name"), ("sweep", "name"), ("uncertainty", "name"), ("legacy", "label")}
TEXT_KEYS = [("job", "title"), ("hole", "name"), ("component", "name"), ("component", "kind"), ("component", "string"),
             ("load_case", "section"), ("load_case", "name"), ("calibrate", "name"), ("sweep", "name"), ("uncertainty", "name"),
             ("legacy", "label"), ("legacy", "md"), ("legacy", "axial"), ("component", "catalogue"), ("trajectory", "survey_file"),
             ("job", "catalogue_file"), ("legacy", "file"), ("sweep", "string"), ("job", "models"), ("hole", "friction")]
WORDS = ["&", "/", "$", "&end", "&job", "&hole", "&load_case /", "=", "==", ",", ";", "!", "'", '"', "\t", "\r", "\0", "\\", "%", "(", ")",
         "(1)", "(:)", "(2:1)", "(-1)", "(1000000000)", "::", "md", "../../escape", "/etc/passwd", ".", "..", "~", "$HOME", "`id`",
         "\xe9", "\xef\xbb\xbf", "\xe2\x80\xae", "x" * 5000, " " * 5000, "rigid", "static", "ream", "spline", "nodes", "discrete", "field", "SI"]
# Keys that ask for work, with the least and most that a fuzzed deck may ask for where it is legal (SI or field alike).
WORK = {"samples": (None, 12), "load_steps": (None, 8), "max_iterations": (None, 1500), "bit_depth_step": (150, None),
        "element_length": (3, None), "element_lengths": (3, None)}
TOKEN = re.compile(r"""\s+|,|![^\n]*|'(?:[^']|'')*'|"(?:[^"]|"")*"|&\w+|/|\w+\s*(?:\([^)]*\))?\s*=|[^\s,/!]+""")


def read_keys():
    """Keys of every group with default and legal values, from input/README.md, which is kept equal to the program's own."""
    keys = {}
    text = (ROOT / "input" / "README.md").read_text(encoding="utf-8")
    for group, table in re.findall(r"<!-- keys of (\w+) -->\n(.*?)<!-- end -->", text, re.S):
        for name, default, legal in re.findall(r"^\| `(\w+(?:\(:\))?)` \| (.*?) \| (.*?) \|", table, re.M):
            keys.setdefault(group, {})[name.replace("(:)", "")] = (default.strip("`"), legal, name.endswith("(:)"))
    return keys


KEYS = read_keys()


class Deck:
    """Groups in order: [name, [[key, [value, ...]], ...]], values as written."""

    def __init__(self, groups):
        self.groups = groups

    @classmethod
    def parse(cls, text):
        groups, at = [], 0
        inside = False
        while at < len(text):
            token = TOKEN.match(text, at)
            if not token:
                raise ValueError(f"no deck: {text[at:at + 40]!r}")
            at, word = token.end(), token.group()
            if word[0] in "!," or word.isspace():
                continue
            if word[0] == "&" and not inside:
                groups.append([word[1:].lower(), []])
                inside = True
            elif not inside:
                raise ValueError(f"no deck: {word!r}")
            elif word == "/":
                inside = False
            elif word.endswith("="):
                groups[-1][1].append([word[:-1].strip().lower(), []])
            elif groups[-1][1]:
                groups[-1][1][-1][1].append(word)
            else:
                raise ValueError(f"no key: {word!r}")
        if inside:
            raise ValueError("a group without end")
        return cls(groups)

    def copy(self):
        return Deck([[name, [[key, list(values)] for key, values in entries]] for name, entries in self.groups])

    def text(self):
        lines = []
        for name, entries in self.groups:
            lines.append(f"&{name}")
            for key, values in entries:
                joined = ", ".join(values)
                lines += [f"  {key} = {joined}"] if len(joined) < 2000 else [f"  {key} ="] + [f"    {v}," for v in values]
            lines.append("/")
        return "\n".join(lines) + "\n"

    def all(self, name):
        return [group for group in self.groups if group[0] == name]

    def get(self, group, key):
        for found, values in group[1]:
            if found == key:
                return values
        return []

    def set(self, group, key, *values):
        for entry in group[1]:
            if entry[0] == key:
                entry[1] = list(values)
                return
        group[1].append([key, list(values)])

    def one(self, name):
        """The only group of a name; made where it lacks."""
        if not self.all(name):
            self.groups.insert(0, [name, []])
        return self.all(name)[0]

    def drop(self, name, key):
        for group in self.all(name):
            group[1] = [entry for entry in group[1] if entry[0] != key]

    def numbers(self, name, key):
        """Numbers of a list with repeat counts."""
        found = []
        for value in self.get(self.one(name), key):
            count, star, number = value.partition("*")
            found += [float(number)] * int(count) if star else [float(value)]
        return found

    def tame(self):
        """Asks for little work where what it asks for is legal."""
        for _, entries in self.groups:
            for key, values in entries:
                least, most = WORK.get(key, (None, None))
                for i, value in enumerate(values):
                    try:
                        number = float(value)
                    except ValueError:
                        continue
                    if least is not None and 0 < number < least:
                        values[i] = str(least)
                    if most is not None and most < number <= 1e6:
                        values[i] = str(most)
        return self


def quoted(text):
    return "'" + text.replace("'", "''") + "'"


def legal_value(group, key, rng, inside=False):
    """A value at or about the limits that the deck's documentation gives; `inside`: none beyond them."""
    default, legal, _ = KEYS[group][key]
    words = re.findall(r"`('[^`]*'|\.\w+\.)`", legal)
    if words:
        return rng.choice(words)
    if key in ("operations", "operation", "measured_operations"):
        return quoted(rng.choice(KINDS))
    limits = [float(n) for n in re.findall(r"-?\d[\d.]*(?:e-?\d+)?", legal)]
    if "text" in legal or not limits:
        return quoted(rng.choice(TEXTS + NAMES))
    low, high = (limits[0], limits[-1])
    if inside:
        least = low if legal.startswith("0 to") or low != 0 else high * 1e-12
        number = rng.choice([least, high, high * 10.0 ** rng.uniform(-12, 0), high * 10.0 ** rng.uniform(-3, 0), least + (high - least) * rng.random()])
        if legal.startswith("whole"):
            number = max(least, round(number))
    elif rng.random() < 0.5:
        usual = float(default) if re.fullmatch(r"\d[-\d.e]*", default) and float(default) else min(1.0, high)
        number = usual * 10.0 ** rng.uniform(-2, 2)
    else:
        number = rng.choice([low, high, low - 1, high * 1.001, low + (high - low) * rng.random(), high * 1e-9])
    return f"{number:.0f}" if legal.startswith("whole") and rng.random() < 0.9 else f"{number:.9g}"


def change_deck(deck, rng, gentle):
    """One change of a deck's structure, in place; a gentle one often leaves a legal deck."""
    groups = deck.groups
    if not groups:
        return
    group = rng.choice(groups)
    entry = rng.choice(group[1]) if group[1] else ["x", ["1"]]
    number = [e for g in groups for e in g[1] if e[1] and re.fullmatch(r"[-+.\deE]+", e[1][0])]
    kind = rng.randrange(16) if not gentle else rng.choice([1, 1, 1, 2, 3, 3, 12, 13, 14])
    if kind == 0 and number:                                       # an extreme value
        values = rng.choice(number)[1]
        values[rng.randrange(len(values))] = rng.choice(NUMBERS)
    elif kind == 1 and number:                                     # a value by some factor
        values = rng.choice(number)[1]
        i = rng.randrange(len(values))
        try:
            values[i] = f"{float(values[i]) * (rng.uniform(0.3, 3.0) if gentle else rng.choice([-1, 1e-6, 1e-3, 0.1, 10, 1e3, 1e6])):.6g}"
        except ValueError:
            pass
    elif kind in (2, 3):                                           # a key of its table, at its limits
        if group[0] in KEYS:
            key = rng.choice(list(KEYS[group[0]]))
            count = rng.choice([1, 1, 2, 3]) if KEYS[group[0]][key][2] else 1
            deck.set(group, key, *[legal_value(group[0], key, rng) for _ in range(count)])
    elif kind == 4:                                                # two keys change groups
        other = rng.choice(groups)
        if group[1] and other[1]:
            i, j = rng.randrange(len(group[1])), rng.randrange(len(other[1]))
            group[1][i], other[1][j] = other[1][j], group[1][i]
    elif kind == 5:                                                # a key twice, in one group or another
        rng.choice([group, rng.choice(groups)])[1].append([entry[0], list(entry[1])])
    elif kind == 6 and group[1]:
        group[1].remove(rng.choice(group[1]))
    elif kind == 7:                                                # a list of another length
        change = rng.randrange(4)
        entry[1] = [[], entry[1] * 2, entry[1][:-1], [f"{rng.choice([2, 3, 1000])}*{v}" for v in entry[1][:1]]][change]
    elif kind == 8:                                                # a value of another type
        entry[1] = [rng.choice(["'text'", "1", ".true.", "", "1.5", "(1,2)", "3*", "''", "1 2 3", "a b"])]
    elif kind == 9:                                                # a slip of the keys
        entry[0] = rng.choice([entry[0][:-1], entry[0] + "x", entry[0].upper(), entry[0] + "(1)", entry[0] + "(2:3)", entry[0] + "(0)", "x y"])
    elif kind == 10:
        groups.insert(rng.randrange(len(groups) + 1), [group[0], [[k, list(v)] for k, v in group[1]]])
    elif kind == 11:
        groups.remove(group)
    elif kind == 12:
        rng.shuffle(groups) if rng.random() < 0.3 else groups.append(groups.pop(rng.randrange(len(groups))))
    elif kind == 13:                                               # a text
        name, key = rng.choice(TEXT_KEYS)
        if deck.all(name):
            text = rng.choice(NAMES if (name, key) in NAME_KEYS and rng.random() < 0.7 else TEXTS)
            deck.set(rng.choice(deck.all(name)), key, quoted(text))
    elif kind == 14:                                               # the other system of units, another operation, another model
        change = rng.randrange(3)
        if change == 0:
            deck.set(deck.one("job"), "units", rng.choice(["'field'", "'SI'", "'metric'"]))
        elif change == 1 and deck.all("load_case"):
            deck.set(rng.choice(deck.all("load_case")), "operation", quoted(rng.choice(KINDS)))
        else:
            deck.set(deck.one("job"), "models", *[quoted(m) for m in rng.sample(["mcge", "soft", "rigid", "mixed"], rng.randrange(1, 5))])
    elif kind == 15:                                               # a group more
        name = rng.choice(list(KEYS))
        keys = rng.sample(list(KEYS[name]), rng.randrange(min(5, len(KEYS[name]))))
        groups.append([name, [[k, [legal_value(name, k, rng)]] for k in keys]])
    elif entry[1]:
        entry[1][rng.randrange(len(entry[1]))] = rng.choice(NUMBERS)


def change_bytes(text, rng, other=""):
    """One change of the letters of a text; `other` is a text from which pieces may come."""
    at, to = sorted(rng.randrange(len(text) + 1) for _ in range(2))
    to = min(to, at + rng.choice([1, 3, 20, 200]))
    kind = rng.randrange(12)
    if kind == 0 and text:
        at = min(at, len(text) - 1)
        return text[:at] + chr(ord(text[at]) ^ (1 << rng.randrange(8))) + text[at + 1:]
    if kind == 1:
        return text[:at] + text[to:]
    if kind == 2:
        return text[:at] + rng.choice(WORDS) + text[at:]
    if kind == 3:
        return text[:at] + "".join(chr(rng.randrange(256)) for _ in range(rng.choice([1, 1, 2, 8, 64]))) + text[to:]
    if kind == 4:
        return text[:at]
    if kind == 5 and other:
        cut, end = sorted(rng.randrange(len(other) + 1) for _ in range(2))
        return text[:at] + other[cut:end] + text[to:]
    if kind == 6:
        return text.replace("\n", rng.choice(["\r\n", "\r", "\n\n", "\n\r"]))
    if kind == 7:
        return rng.choice(["\xef\xbb\xbf", "\xff\xfe", "\xfe\xff", "\0"]) + text
    if kind == 8:
        return text[:at] + "\0" * rng.choice([1, 10, 5000]) + text[at:]
    lines = text.splitlines(keepends=True) or ["\n"]
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    if kind == 9:
        lines.insert(j, lines[i] * rng.choice([1, 1, 2, 50]))
    elif kind == 10:
        del lines[i]
    else:
        lines[i], lines[j] = lines[j], lines[i]
    return "".join(lines)


FIELDS = ["", "NaN", "nan", "Inf", "-1", "0", "1e308", "1e-308", "-999.25", "-9999", "1e30", "999999", "***", "-", "n/a", "null", "1,000", "1 000",
          "1'000", "1.000,5", "1e5", "1d2", "0x10", "12:30", "'5'", '"5"', "5m", "5 ft", "#5", "\xb05", "5\xb0", "360", "361", "-361", "1080",
          "180.001", "\0", "4000000"]
CELL = re.compile(r"[^\s,;]+")


def change_table(text, rng, other=""):
    """One change of a table: a field, a heading, a row, a column."""
    lines = text.splitlines(keepends=True) or ["\n"]
    i = rng.randrange(len(lines))
    cells = list(CELL.finditer(lines[i]))
    kind = rng.randrange(8)
    if kind <= 2 and cells:                                        # a field
        cell = rng.choice(cells)
        lines[i] = lines[i][:cell.start()] + rng.choice(FIELDS) + lines[i][cell.end():]
    elif kind == 3 and len(cells) > 1:                             # two fields change places, or one lacks
        a, b = rng.sample(cells, 2) if rng.random() < 0.5 else (cells[-1], None)
        a, b = sorted([a, b], key=lambda c: c.start()) if b else (a, b)
        lines[i] = lines[i][:a.start()] + b.group() + lines[i][a.end():b.start()] + a.group() + lines[i][b.end():] if b else \
            lines[i][:a.start()] + lines[i][a.end():]
    elif kind == 4:                                                # a heading's unit
        names = [n for n in range(len(lines)) if re.search(r"(?i)\b(md|dept|depth|inc|name|up|axial)", lines[n])]
        if names:
            n = rng.choice(names)
            cell = rng.choice(list(CELL.finditer(lines[n])))
            lines[n] = lines[n][:cell.end()] + rng.choice(["_ft", "_m", " (ft)", " (km)", "[kft]", "_gon", "(rad)", "_kN", "_in", "x"]) + lines[n][cell.end():]
    elif kind == 5:
        lines.insert(rng.randrange(len(lines)), lines[i])
    elif kind == 6:
        del lines[i]
    else:
        return change_bytes(text, rng, other)
    return "".join(lines)

"""Line numbers of inputs in a parameter file, for error messages."""

import re
from collections import Counter
from pathlib import Path

HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(#.*)?$")
KEY = re.compile(r"""\s*["']?([^\s"'=#\[\]]+)["']?\s*=""")
PLACE = re.compile(r"(inputs[.\[][^\s:]*)")


def with_line(message: str, path: Path) -> str:
    """Message with the line number of its input.

    For example, "part.toml: inputs.r: ..." becomes "part.toml:4: inputs.r: ...".
    """
    rest = message.removeprefix(f"{path}: ")
    place = PLACE.match(rest)
    if rest == message or not place:
        return message
    line = line_of(place[1], path.read_bytes().decode("utf-8-sig"))
    return f"{path}:{line}: {rest}" if line else message


def line_of(place: str, text: str) -> int:
    """Line number of an input, such as inputs.supports[2].k, in the text of a parameter file.

    If the input is omitted, the line number of its table is returned; 0 if the table is omitted.

    >>> text = ("[inputs]", "r = 1", "[[inputs.supports]]", "[[inputs.supports]]", "k = 1")
    >>> line_of("inputs.supports[2].k", chr(10).join(text))
    5
    """
    found: dict[str, int] = {}
    tables: Counter[str] = Counter()
    table = ""
    for number, line in enumerate(text.splitlines(), start=1):
        if header := HEADER.match(line):
            table = header[2]
            tables[table] += 1
            table += f"[{tables[table]}]" if header[1] == "[[" else ""
            found.setdefault(table, number)
        elif key := KEY.match(line):
            found.setdefault(f"{table}.{key[1]}".lstrip("."), number)
    while place and place not in found:
        place = re.sub(r"(\[\d+\]|\.?[^.\[\]]+)$", "", place)
    return found.get(place, 0)

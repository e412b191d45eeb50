"""Reduction of the size of a page without a change of its appearance.

Paths consist of relative steps, and repeated equations refer to their first drawing. Attributes
without blanks have no quotes.
"""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise

# a page has the name space of its drawings; text is anchored at its start by default
NEEDLESS = (' xmlns="http://www.w3.org/2000/svg"', ' text-anchor="start"', ' class=""')
# of most rows' graphic
BAND = (
    '<rect class="band" x="30" y="2" width="72" height="14"/><path class="zero" d="M66,0L66,18"/>'
)
SEVERAL = 2
MOST = 400_000  # bytes of a page of a report with several
_STRAIGHT = re.compile(r'(?<= d=")M-?\d[-\d.,LMz]*(?=")')
_POINT = re.compile(r"-?\d+(\.\d)?,-?\d+(\.\d)?")
_CELL_END = re.compile(r"</t[dh]>\s*(?=<t[dh][ >]|</tr>)")  # end tags, which HTML omits
_SIMPLE_VALUE = re.compile(r"""( [a-zA-Z][\w:-]*=)"([^\s"'=<>`]+)"(?=[ >])""")
_VERBATIM = re.compile(r"(<(?:script|style)\b.*?</(?:script|style)>)", re.DOTALL)
_EQUATION = re.compile(r'(<svg class="maths"[^>]*>)(.*?)(</svg>)', re.DOTALL)

Point = tuple[int, int]  # in tenths of a pixel


def slim(page: str) -> str:
    """The page without parts that a browser does not need for the drawing."""
    for packed in NEEDLESS:
        page = page.replace(packed, "")
    page = _once(page, BAND, "band")
    return _STRAIGHT.sub(lambda path: steps(path[0]), _equations_once(page))


def cells(page: str) -> str:
    """The page without end tags of cells before the next cell or the end of a row."""
    return _CELL_END.sub("", page)


def unquoted(page: str) -> str:
    """The page without quotes that HTML does not require; scripts and styles are unchanged."""
    parts = _VERBATIM.split(page)  # those that are verbatim have odd numbers
    # without the blank, the slash of "/>" would belong to the value
    spaced = (part.replace('"/>', '" />') for part in parts[::2])
    parts[::2] = (_SIMPLE_VALUE.sub(r"\1\2", part) for part in spaced)
    return "".join(parts)


def too_large(files: Mapping[str, bytes]) -> Iterator[str]:
    """Messages for pages with more than `MOST` bytes."""
    for name, text in files.items():
        if name.endswith(".html") and len(text) > MOST:
            yield (
                f"{name} has {len(text) / 1000:.1f} kB, but a page must not exceed "
                f"{MOST // 1000} kB"
            )


def _once(page: str, drawing: str, name: str) -> str:
    """The page in which repetitions of `drawing` refer to its first occurrence, named `name`."""
    first, *others = page.split(drawing)
    if len(others) < SEVERAL:
        return page
    again = f'<use href="#{name}"/>'
    return f'{first}<g id="{name}">{drawing}</g>{again.join(others)}'


def _equations_once(page: str) -> str:
    """The page in which a repeated equation refers to its first drawing."""
    repeated = {d for d, n in Counter(e[2] for e in _EQUATION.finditer(page)).items() if n > 1}
    names: dict[str, str] = {}

    def drawn(equation: re.Match[str]) -> str:
        start, drawing, end = equation.groups()
        if drawing in names:
            return f'{start}<use href="#{names[drawing]}"/>{end}'
        if drawing not in repeated:
            return equation[0]
        names[drawing] = f"e{len(names)}"
        return f'{start}<g id="{names[drawing]}">{drawing}</g>{end}'

    return _EQUATION.sub(drawn, page)


def steps(path: str) -> str:
    """A path of straight lines in relative steps: M1,2L3.5,2z gives M1,2h2.5z.

    Coordinates in tenths of a pixel are retained, so that no point moves. Points within a straight
    piece are removed. A path with finer coordinates is returned unchanged.
    """
    parts = path.split("M")[1:]
    if not all(_POINT.fullmatch(p) for part in parts for p in part.rstrip("z").split("L")):
        return path
    return "".join(_part(part.rstrip("z").split("L")) + "z" * part.count("z") for part in parts)


def _part(written: Iterable[str]) -> str:
    points = list(_corners(_tenths(point) for point in written))
    (x, y), packed, last = points[0], [], ""
    for (x0, y0), (x1, y1) in pairwise(points):
        dx, dy = x1 - x0, y1 - y0
        name = "v" if not dx else "h" if not dy else "l"
        numbers = [_short(d) for d in (dx, dy) if d] or ["0"]
        again = name == last
        packed.append(_packed([] if again else [name], numbers, after=again))
        last = name
    return f"M{_packed([], [_short(x), _short(y)])}{''.join(packed)}"


def _tenths(point: str) -> Point:
    x, _, y = point.partition(",")
    return round(10 * float(x)), round(10 * float(y))


def _corners(points: Iterator[Point]) -> Iterator[Point]:
    """Points where the path changes its direction, and its ends."""
    start = held = next(points)
    yield start
    moved = False
    for point in points:
        a, b = (held[0] - start[0], held[1] - start[1]), (point[0] - held[0], point[1] - held[1])
        ahead = a[0] * b[1] == a[1] * b[0] and a[0] * b[0] + a[1] * b[1] >= 0
        if moved and not ahead:
            yield held
            start = held
        held, moved = point, True
    if moved:
        yield held


def _short(tenths: int) -> str:
    """Text of a number of tenths as short as possible: 2.5, 3, .4 and -.4."""
    whole, rest = divmod(abs(tenths), 10)
    sign = "-" * (tenths < 0)
    if not rest:
        return f"{sign}{whole}"
    return f"{sign}{whole or ''}.{rest}"


def _packed(name: list[str], numbers: list[str], *, after: bool = False) -> str:
    """Text of numbers, with a comma only if no sign separates them."""
    packed = "".join(name)
    for i, number in enumerate(numbers):
        packed += "," * ((i > 0 or after) and number[0] != "-") + number
    return packed

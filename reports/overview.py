"""Overview of all rows of a run: difference and detection limit of each, in strips."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from reports import svg
from verify.core.results import CaseResult, Kind, Row, Status

WIDE = 1216.0
LEFT, TOP, HIGH = 50.0, 10.0, 96.0  # of a strip's scale
GAP, STEP = 18.0, 3.4  # between cases, and from row to row at least
BELOW = 34.0  # names, and room to the next strip
LETTER = 9.0  # room for a letter of a name, also in the size of the PDF
NAME = 40  # letters of a name that are drawn
LEAST = -12  # decades of the strip
EACH = 4  # decades from tick to tick
DEMAND = 0.01


@dataclass(frozen=True)
class Group:
    """A case with its drawn rows, and its width."""

    case: CaseResult
    rows: Sequence[Row]
    name: str
    width: float


def overview(cases: Sequence[CaseResult]) -> Markup:
    """SVG with every row that has a difference, on a logarithmic scale.

    Rows that were not run have a vertical line. A dot is the difference, a tick the detection
    limit. Each case links to its page. Names of cases do not overlap, for any number of cases.
    """
    lines = strips([_group(case, rows) for case in cases if (rows := _drawn(case))])
    parts: list[Markup] = []
    for number, line in enumerate(lines):
        parts += _strip(line, number * (TOP + HIGH + BELOW) + TOP)
    words = "relative difference and detection limit of every row"
    high = max(len(lines), 1) * (TOP + HIGH + BELOW)
    return svg.drawing(WIDE, high, parts, words, "overview")


def _drawn(case: CaseResult) -> list[Row]:
    return [row for row in case.rows if _relative(row) or row.status is Status.SKIP]


def _group(case: CaseResult, rows: Sequence[Row]) -> Group:
    name = case.name or case.id
    name = name if len(name) <= NAME else f"{name[: NAME - 1]}…"
    width = max(STEP * len(rows), LETTER * len(name))
    return Group(case, rows, name, min(width, WIDE - LEFT))


def strips(groups: Sequence[Group]) -> list[list[Group]]:
    """Lists of groups that fit a line of the width WIDE; groups keep their order."""
    lines: list[list[Group]] = []
    end = math.inf
    for group in groups:
        if end + group.width > WIDE:
            lines.append([])
            end = LEFT
        lines[-1].append(group)
        end += group.width + GAP
    return lines


def _strip(groups: Sequence[Group], top: float) -> Iterator[Markup]:
    bottom = top + HIGH
    for exponent in range(LEAST, 1, EACH):
        yield _decade(exponent, top, bottom)
    demand = _height(DEMAND, top, bottom)
    yield _tick("1 %", demand)
    yield svg.line(LEFT, demand, WIDE, demand, "demand")
    left = LEFT
    for group in groups:
        yield _case(group, left, top, bottom)
        left += group.width + GAP


def _case(group: Group, left: float, top: float, bottom: float) -> Markup:
    """SVG of the rows of a case, as one path per status (a page contains a thousand rows)."""
    step = group.width / len(group.rows)
    found: dict[Status, list[tuple[float, Row]]] = {}
    for i, row in enumerate(group.rows):
        found.setdefault(row.status, []).append((left + step * (i + 0.5), row))
    marks = Markup("").join(
        Markup('<g class="is-{}">{}</g>').format(status.value.lower(), _marks(rows, top, bottom))
        for status, rows in found.items()
    )
    return Markup('<a href="#case-{}" tabindex="-1"><title>{}: {} rows</title>{}{}{}</a>').format(
        group.case.id, group.name, len(group.rows), marks,
        svg.line(left, bottom, left + group.width, bottom, "zero"),
        svg.text(left, bottom + 16, group.name, "part"),
    )  # fmt: skip


def _marks(rows: Sequence[tuple[float, Row]], top: float, bottom: float) -> Markup:
    bars = dots = holes = ""
    for x, row in rows:
        found = _relative(row)
        if found is None:
            holes += f"M{svg.short(x)},{top:g}v{bottom - top:g}"
            continue
        low, high = (svg.short(_height(value, top, bottom)) for value in found)
        bars += f"M{svg.short(x)},{low}V{high}m-1.5,0h3"
        dots += f"M{svg.short(x)},{low}h0"
    named = (("bar", bars), ("dots", dots), ("none", holes))
    return Markup("").join(Markup('<path class="{}" d="{}"/>').format(*n) for n in named if n[1])


def _height(value: float, top: float, bottom: float) -> float:
    """Height of a relative number in the plot, from 10^LEAST at the bottom to 1 at the top."""
    share = (math.log10(max(value, 1e-300)) - LEAST) / -LEAST
    return bottom - (bottom - top) * min(max(share, 0.0), 1.0)


def _decade(exponent: int, top: float, bottom: float) -> Markup:
    y = _height(10.0**exponent, top, bottom)
    return svg.line(LEFT, y, WIDE, y, "grid") + _tick(_words(exponent), y)


def _words(exponent: int) -> str | Markup:
    return svg.decade(exponent) if exponent else "100 %"


def _tick(words: str | Markup, y: float) -> Markup:
    return Markup('<text class="tick" x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>').format(
        LEFT - 8, y + 4, words
    )


def _relative(row: Row) -> tuple[float, float] | None:
    """Magnitudes of the difference and of the detection limit, divided by the scale."""
    if row.kind is Kind.FACT or row.difference is None or not row.scale:
        return None
    if not (math.isfinite(row.difference) and math.isfinite(row.scale)):
        return None
    size = abs(row.difference / row.scale)
    return size, size if row.detects is None else row.detects

"""The graphic of a row: its difference in units of its own tolerance, and all rows at a glance."""

import math
from collections.abc import Mapping, Sequence

from markupsafe import Markup

from reports import svg
from verify.core.differences import difference, sense
from verify.core.results import CaseResult, Kind, Published, Row, Status

HALF = 36.0  # half the tolerance band in the signature's units
CENTRE = 66.0
WIDE = 1216.0
LETTER = 8.0  # room for a letter of a name
NAME = 40  # letters of a name that are shown
LEAST = -12  # decades of the strip
FAR = 1.7  # tolerances from which a dot becomes an arrow
MARKS = {
    "theory": "M{x:.1f},5v8",
    "FEA": "M{a:.1f},6h6v6h-6z",
    "test": "M{x:.1f},5l4,4l-4,4l-4,-4z",
}


def position(row: Row) -> float | None:
    """Where the formula lies, in tolerances from its reference; None where there is no such thing.

    An approximation lies in its expected interval: from -1 to 1 there. A balance has no formula:
    its residual is what is placed.
    """
    found = difference(row)
    if found is None:
        return None
    if row.interval is not None:
        low, high = row.interval
        return (found.value - (low + high) / 2) / ((high - low) / 2)
    return found.value / found.U if found.U else None


def signature(row: Row) -> Markup:
    """The formula as a dot in the band of its reference; an outlier is an arrow with its factor."""
    where = position(row)
    if where is None or not math.isfinite(where):
        if row.status is not Status.SKIP:
            return Markup("")
        gap = svg.rectangle(CENTRE - HALF, 3, 2 * HALF, 12, "none")
        return svg.drawing(132, 18, [gap], "not run", "sig")
    parts = [
        svg.rectangle(CENTRE - HALF, 2, 2 * HALF, 14, "blunt" if _is_blunt(row) else "band"),
        svg.line(CENTRE, 0, CENTRE, 18, "zero"),
        *(_mark(row, entry) for entry in row.published),
    ]
    if abs(where) > FAR:
        side = math.copysign(1.0, where)
        tip = CENTRE + side * 65
        parts.append(svg.arrow_head(tip, 9, side, 0, "dot"))
        words = f"{abs(where):.2g}×" if abs(where) < 99.5 else f"{min(abs(where), 999):.0f}×"
        words = "≫" if abs(where) >= 999.5 else words
        parts.append(svg.text(tip - side * 8, 12, words, "times", "end" if side > 0 else "start"))
    else:
        parts.append(svg.circle(CENTRE + HALF * where, 9, 3.4, "dot"))
    words = f"formula {where:+.2g} tolerances from its reference"
    if row.interval is not None:
        words = f"model error {where:+.2g} half-widths from the middle of its expected interval"
    return svg.drawing(132, 18, parts, words, f"sig is-{row.status.value.lower()}")


def _is_blunt(row: Row) -> bool:
    """Whether the band alone would hide an error of 1 %."""
    if row.interval is not None:
        return row.interval[1] - row.interval[0] > 0.02
    return bool(row.tolerance and row.scale and row.tolerance / row.scale > 0.01)


def _mark(row: Row, entry: Published) -> Markup:
    """A printed value on the row's own scale, where it fits."""
    reference = row.reference
    if reference is None or not row.tolerance or row.interval is not None:
        return Markup("")
    at = sense(row) * (entry.value - reference) / row.tolerance
    if abs(at) > FAR or entry.kind not in MARKS:
        return Markup("")
    x = CENTRE + HALF * at
    return Markup('<path class="pub" d="{}"/>').format(MARKS[entry.kind].format(x=x, a=x - 3))


def overview(cases: Sequence[CaseResult], anchors: Mapping[str, str]) -> Markup:
    """Every row with a difference on a logarithmic scale; a row not run is a hole.

    Names stand level below their groups where all fit, else upright.

    A dot is how far apart the two sides are, a tick its detection limit.
    """
    shown = [(case, drawn) for case in cases if (drawn := [r for r in case.rows if _drawn(r)])]
    total = sum(len(rows) for _, rows in shown) or 1
    gap, left, top, bottom = 18.0, 50.0, 10.0, 130.0
    room = WIDE - left - gap * max(len(shown) - 1, 0)
    parts = [_decade(e, left, top, bottom) for e in range(LEAST, 1, 2)]
    demand = _height(0.01, top, bottom)
    parts += [svg.line(left, demand, WIDE, demand, "demand")]
    widths = [room * len(rows) / total for _, rows in shown]
    names = [_short(case.name or case.id) for case, _ in shown]
    lengths = [LETTER * len(name) for name in names]
    upright = any(n > w for n, w in zip(lengths, widths, strict=True))
    x = left
    for (_, rows), name, wide in zip(shown, names, widths, strict=True):
        step = wide / len(rows)
        parts += [
            _upright(name, x + wide / 2, bottom + 10) if upright
            else svg.text(x, bottom + 24, name, "part"),
            svg.line(x, bottom, x + wide, bottom, "zero"),
            *(_bar(row, anchors[row.id], x + step * (i + 0.5), top, bottom)
              for i, row in enumerate(rows)),
        ]  # fmt: skip
        x += wide + gap
    words = "relative difference of every row, and its detection limit"
    below = 10 + max(lengths) if upright else 32
    return svg.drawing(WIDE, bottom + below, parts, words, "overview")


def _height(value: float, top: float, bottom: float) -> float:
    """Where a relative number is, from 10^LEAST at the bottom to 1 at the top."""
    share = (math.log10(max(value, 1e-300)) - LEAST) / -LEAST
    return bottom - (bottom - top) * min(max(share, 0.0), 1.0)


def _decade(exponent: int, left: float, top: float, bottom: float) -> Markup:
    y = _height(10.0**exponent, top, bottom)
    words = {0: "100 %", -2: "1 %"}.get(exponent)
    label = Markup('<text class="tick" x="{:.1f}" y="{:.1f}" text-anchor="end">{}</text>').format(
        left - 8, y + 4, words or svg.decade(exponent)
    )
    return svg.line(left, y, WIDE, y, "grid") + label


def _short(name: str) -> str:
    return name if len(name) <= NAME else f"{name[: NAME - 1]}…"


def _upright(name: str, x: float, y: float) -> Markup:
    """The name of a case from the bottom up, ending at (x, y): a narrow group has room for it."""
    return Markup('<g transform="translate({} {}) rotate(-90)">{}</g>').format(
        svg.short(x), svg.short(y), svg.text(0, 4, name, "part", "end")
    )


def _drawn(row: Row) -> bool:
    return _relative(row) is not None or row.status is Status.SKIP


def _relative(row: Row) -> tuple[float, float] | None:
    """Size of the difference and what the row detects, both on its scale."""
    if row.kind is Kind.FACT or row.difference is None or not row.scale:
        return None
    if not (math.isfinite(row.difference) and math.isfinite(row.scale)):
        return None
    size = abs(row.difference / row.scale)
    return size, size if row.detects is None else row.detects


def _bar(row: Row, anchor: str, x: float, top: float, bottom: float) -> Markup:
    found = _relative(row)
    if found is None:
        shape = svg.rectangle(x - 3, top, 6, bottom - top, "none")
    else:
        low, high = (_height(value, top, bottom) for value in found)
        shape = svg.line(x, low, x, high, "bar") + svg.line(x - 4, high, x + 4, high, "bar")
        shape += svg.circle(x, low, 3.2, "dot")
    return Markup('<a href="#{}" tabindex="-1" class="is-{}"><title>{}: {}</title>{}</a>').format(
        anchor, row.status.value.lower(), row.id, row.status.value, shape
    )

"""The graphic of a row: its difference in units of its own tolerance, and all rows at a glance."""

import math
from collections.abc import Mapping, Sequence

from markupsafe import Markup

from reports import svg
from verify.results import CaseResult, Kind, Published, Row, Status

HALF = 36.0  # half the tolerance band in the signature's units
CENTRE = 66.0
WIDE = 1216.0
FAR = 1.7  # tolerances from which a dot becomes an arrow
MARKS = {
    "theory": "M{x:.1f},5v8",
    "FEA": "M{a:.1f},6h6v6h-6z",
    "test": "M{x:.1f},5l4,4l-4,4l-4,-4z",
}


def position(row: Row) -> tuple[float | None, float]:
    """Where the row lies in tolerances, and its standard uncertainty in the same unit.

    Approximations are drawn in their expected interval; a fact has neither.
    """
    if row.interval is not None and row.analytic is not None and row.fem:
        low, high = row.interval
        half = (high - low) / 2
        m = row.analytic / row.fem - 1
        return (m - (low + high) / 2) / half, (row.u_num or 0.0) / abs(row.fem) / half
    if row.difference is None or not row.tolerance or row.kind is Kind.FACT:
        return None, 0.0
    return row.difference / row.tolerance, (row.u_num or 0.0) / row.tolerance


def signature(row: Row) -> Markup:
    """A dot in the grey band passes; an outlier is an arrow with its number of tolerances."""
    where, bar = position(row)
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
        words = f"{abs(where):.2g}×" if abs(where) < 99.5 else f"{abs(where):.0f}×"
        parts.append(svg.text(tip - side * 10, 13, words, "times", "end" if side > 0 else "start"))
    else:
        x = CENTRE + HALF * where
        if bar:
            low, high = max(x - HALF * bar, 1), min(x + HALF * bar, 131)
            parts.append(svg.line(low, 9, high, 9, "bar"))
        parts.append(svg.circle(x, 9, 3.4, "dot"))
    words = f"difference {where:+.2g} times the tolerance"
    if row.interval is not None:
        words = f"model error {where:+.2g} half-widths from the middle of its expected interval"
    return svg.drawing(132, 18, parts, words, f"sig is-{row.status.value.lower()}")


def _is_blunt(row: Row) -> bool:
    return row.detects is not None and row.detects > 0.01


def _mark(row: Row, entry: Published) -> Markup:
    """A printed value on the row's own scale, where it fits."""
    reference = row.analytic
    if reference is None or not row.tolerance or row.interval is not None:
        return Markup("")
    at = (entry.value - reference) / row.tolerance
    if abs(at) > FAR or entry.kind not in MARKS:
        return Markup("")
    x = CENTRE + HALF * at
    return Markup('<path class="pub" d="{}"/>').format(MARKS[entry.kind].format(x=x, a=x - 3))


def overview(cases: Sequence[CaseResult], anchors: Mapping[str, str]) -> Markup:
    """Every row that has a difference as one dot over the cases; a row not run is a hole."""
    shown = [(case, drawn) for case in cases if (drawn := [r for r in case.rows if _drawn(r)])]
    total = sum(len(rows) for _, rows in shown)
    left, width, gap, mid, half = 34.0, WIDE, 18.0, 40.0, 22.0
    room = width - left - gap * max(len(shown) - 1, 0)
    parts = [
        svg.text(left - 8, mid - side * half + 4, name, "tick", "end")
        for side, name in ((1, "+1"), (0, "0"), (-1, f"{svg.MINUS}1"))
    ]
    x = left
    for case, rows in shown:
        wide = room * len(rows) / total
        parts += [
            svg.rectangle(x, mid - half, wide, 2 * half, "band"),
            svg.line(x, mid, x + wide, mid, "zero"),
            *_name(case, x, wide, mid + half + 34),
        ]
        step = wide / len(rows)
        parts += [
            _dot(row, anchors[row.id], x + step * (i + 0.5), mid, half)
            for i, row in enumerate(rows)
        ]
        x += wide + gap
    return svg.drawing(width, 100, parts, "difference over tolerance of every row", "overview")


def _name(case: CaseResult, x: float, wide: float, y: float) -> list[Markup]:
    """The case's name below its rows, from the right where it would leave the image."""
    words = case.name or case.id
    right = x + 8.0 * len(words) > WIDE
    return [svg.text(x + wide, y, words, "part", "end") if right else svg.text(x, y, words, "part")]


def _drawn(row: Row) -> bool:
    return position(row)[0] is not None or row.status is Status.SKIP


def _dot(row: Row, anchor: str, x: float, mid: float, half: float) -> Markup:
    where, bar = position(row)
    if where is None or not math.isfinite(where):
        shape = svg.rectangle(x - 3, mid - half - 1, 6, 2 * half + 2, "none")
    elif abs(where) > FAR:
        side = math.copysign(1.0, where)
        shape = svg.arrow_head(x, mid - side * 39, 0, -side, "dot", 9)
    else:
        y = mid - half * where
        reach = min(half * bar, 1.6 * half)
        shape = svg.line(x, y - reach, x, y + reach, "bar") + svg.circle(x, y, 3.4, "dot")
    return Markup('<a href="#{}" tabindex="-1" class="is-{}"><title>{}: {}</title>{}</a>').format(
        anchor, row.status.value.lower(), row.id, row.status.value, shape
    )

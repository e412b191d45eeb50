"""Graphic of a row: its difference in units of its tolerance."""

import math

from markupsafe import Markup

from reports import svg
from verify.core.differences import difference, sense
from verify.core.results import Published, Row, Status

HALF = 36.0  # half the tolerance band in the signature's units
CENTRE = 66.0
FAR = 1.7  # tolerances from which a dot becomes an arrow
MARKS = {
    "theory": "M{x:.1f},5v8",
    "FEA": "M{a:.1f},6h6v6h-6z",
    "test": "M{x:.1f},5l4,4l-4,4l-4,-4z",
}


def position(row: Row) -> float | None:
    """Difference of formula and reference divided by the tolerance; None without a reference.

    For an approximation, it is the position in the expected interval, whose ends are at -1 and 1.
    For a balance, which has no formula, the residual is used.
    """
    found = difference(row)
    if found is None:
        return None
    if row.interval is not None:
        low, high = row.interval
        return (found.value - (low + high) / 2) / ((high - low) / 2)
    return found.value / found.U if found.U else None


def signature(row: Row) -> Markup:
    """SVG of the formula as a dot in the band of its reference.

    If the dot is far outside the band, an arrow with the factor is drawn instead.
    """
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
    words = f"difference of the formula from its reference: {where:+.2g} tolerances"
    if row.interval is not None:
        words = f"model error: {where:+.2g} half-widths from the centre of its expected interval"
    return svg.drawing(132, 18, parts, words, f"sig is-{row.status.value.lower()}")


def _is_blunt(row: Row) -> bool:
    """Whether the half-width of the band is larger than 1 %."""
    if row.interval is not None:
        return row.interval[1] - row.interval[0] > 0.02
    return bool(row.tolerance and row.scale and row.tolerance / row.scale > 0.01)


def _mark(row: Row, entry: Published) -> Markup:
    """SVG of a printed value on the scale of the row; empty if it does not fit."""
    reference = row.reference
    if reference is None or not row.tolerance or row.interval is not None:
        return Markup("")
    at = sense(row) * (entry.value - reference) / row.tolerance
    if abs(at) > FAR or entry.kind not in MARKS:
        return Markup("")
    x = CENTRE + HALF * at
    return Markup('<path class="pub" d="{}"/>').format(MARKS[entry.kind].format(x=x, a=x - 3))

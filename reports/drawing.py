"""Static SVG: the row's signature, convergence and sketches. Colours come from CSS classes."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup

from verify.results import Row

SPAN = 36.0  # half the tolerance band, in the signature's units
CENTRE = 66.0


def signature(row: Row) -> Markup:
    """Difference in units of the row's own tolerance: a dot in the grey band passes."""
    where, bar = _position(row)
    if where is None:
        return Markup('<svg class="sig" viewBox="0 0 132 16" aria-hidden="true"></svg>')
    wide = row.detects is not None and row.detects > 0.01
    parts = [
        Markup('<rect class="band{}" x="{}" y="3" width="{}" height="10"/>').format(
            " wide" if wide else "", CENTRE - SPAN, 2 * SPAN
        ),
        Markup('<path class="zero" d="M{0},1V15"/>').format(CENTRE),
    ]
    if abs(where) > 1.7:
        side = math.copysign(1, where)
        x = CENTRE + side * 58
        parts.append(Markup('<path class="far" d="M{},8l{},-4v8z"/>').format(x, -side * 7))
        parts.append(
            Markup('<text class="far" x="{}" y="12" text-anchor="{}">{}×</text>').format(
                x - side * 10, "end" if side > 0 else "start", f"{abs(where):.3g}"
            )
        )
    else:
        x = CENTRE + SPAN * where
        if bar:
            low, high = max(x - SPAN * bar, 2), min(x + SPAN * bar, 130)
            parts.append(Markup('<path class="bar" d="M{:.1f},8H{:.1f}"/>').format(low, high))
        parts.append(Markup('<circle class="dot" cx="{:.1f}" cy="8" r="3.2"/>').format(x))
    words = f"difference {where:+.2g} times the tolerance"
    return Markup(
        '<svg class="sig" viewBox="0 0 132 16" role="img" aria-label="{}">{}</svg>'
    ).format(words, Markup("").join(parts))


def _position(row: Row) -> tuple[float | None, float]:
    """Where the dot lies in tolerances, and its standard uncertainty."""
    if row.interval is not None and row.analytic is not None and row.fem:
        low, high = row.interval
        half = (high - low) / 2
        m = row.analytic / row.fem - 1
        return (m - (low + high) / 2) / half, (row.u_num or 0) / abs(row.fem) / half
    if row.difference is None or not row.tolerance or row.kind == "fact":
        return None, 0.0
    return row.difference / row.tolerance, (row.u_num or 0.0) / row.tolerance


def convergence(rows: Sequence[Row]) -> Markup:
    """Distance to the finest value (or the error of an order row) against mesh size, log-log.

    One colour for each order of theory, so that parallel lines of one colour are the message.
    """
    series = [(row, s) for row in rows if (s := _series(row)) and row.order != "round-off"]
    if not series:
        return Markup("")
    orders = sorted({row.formal_order or 0.0 for row, _ in series}, reverse=True)
    box = _Axes([p for _, s in series for p in s])
    parts = [box.frame("mesh size, relative", "difference, relative")]
    for row, s in series:
        points = " ".join(f"{box.x(x):.1f},{box.y(y):.1f}" for x, y in s)
        dots = Markup("").join(
            Markup('<circle cx="{:.1f}" cy="{:.1f}" r="2.4"/>').format(box.x(x), box.y(y))
            for x, y in s
        )
        parts.append(
            Markup('<g class="s{}"><title>{}</title><polyline points="{}"/>{}</g>').format(
                orders.index(row.formal_order or 0.0) % 6, row.quantity, points, dots
            )
        )
    legend = Markup("").join(
        Markup('<li class="s{}"><i></i>{}: {}</li>').format(
            i % 6,
            f"order {order:g}" if order else "no order in theory",
            ", ".join(row.quantity for row, _ in series if (row.formal_order or 0.0) == order),
        )
        for i, order in enumerate(orders)
    )
    plot = Markup('<svg class="plot" viewBox="0 0 400 250">{}</svg><ul class="legend">{}</ul>')
    return plot.format(Markup("").join(parts), legend)


def _series(row: Row) -> list[tuple[float, float]]:
    if len(row.levels) < 3:
        return []
    if row.kind == "trend":
        return [(h, abs(e)) for h, e in row.levels if e]
    finest = row.levels[-1][1]
    scale = row.scale or abs(finest) or 1.0
    return [(h, abs(v - finest) / scale) for h, v in row.levels[:-1] if v != finest]


class _Axes:
    """A log-log frame of 400 by 250 with decades and the mesh sizes marked."""

    def __init__(self, points: Sequence[tuple[float, float]]) -> None:
        self._sizes = sorted({x for x, _ in points})
        self._x0 = math.log10(self._sizes[0]) - 0.05
        self._x1 = math.log10(self._sizes[-1]) + 0.05
        self._y0 = math.floor(math.log10(min(y for _, y in points)))
        self._y1 = math.ceil(math.log10(max(y for _, y in points)) + 1e-9)

    def x(self, value: float) -> float:
        return 52 + 338 * (math.log10(value) - self._x0) / (self._x1 - self._x0)

    def y(self, value: float) -> float:
        return 206 - 194 * (math.log10(value) - self._y0) / max(self._y1 - self._y0, 1)

    def frame(self, x: str, y: str) -> Markup:
        """Box, ticks and axis titles."""
        decade = Markup(
            '<path class="grid" d="M52,{0:.1f}H390"/><text x="47" y="{1:.1f}" text-anchor="end">'
            '10<tspan dy="-4" font-size="8">{2}</tspan></text>'
        )
        step = max(1, (self._y1 - self._y0) // 6)
        ticks = [
            decade.format(self.y(10.0**d), self.y(10.0**d) + 4, str(d).replace("-", "−"))
            for d in range(self._y0, self._y1 + 1, step)
        ]
        ticks += [
            Markup('<text x="{:.1f}" y="220" text-anchor="middle">{:.3g}</text>').format(
                self.x(h), h
            )
            for h in self._sizes
        ]
        return Markup(
            '<rect class="frame" x="52" y="12" width="338" height="194"/>{}'
            '<text x="221" y="242" text-anchor="middle">{}</text>'
            '<text x="12" y="112" text-anchor="middle" transform="rotate(-90 12 112)">{}</text>'
        ).format(Markup("").join(ticks), x, y)


def sketch(data: Mapping[str, Any]) -> Markup:
    """A case's sketch from its plain data: a spring's path or a ring's circles."""
    if "path" in data:
        return _path(data["path"], data["label"])
    if "circles" in data:
        return _ring(data)
    return Markup("")


def _path(points: Sequence[Sequence[float]], label: str) -> Markup:
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    k = 300 / size
    line = " ".join(f"{30 + k * (x - min(xs)):.1f},{20 + k * (max(ys) - y):.1f}" for x, y in points)
    height = 40 + k * (max(ys) - min(ys))
    y = 20 + k * max(ys)
    return Markup(
        '<svg class="sketch" viewBox="0 0 370 {:.0f}" role="img" aria-label="centre line of the '
        'spring">'
        '<path class="axis" d="M4,{:.1f}H366"/><polyline class="body" points="{}"/>'
        '<path class="load" d="M2,{:.1f}h20m-7,-4l7,4l-7,4"/><text x="2" y="{:.1f}">{}</text></svg>'
    ).format(height, y, line, y, y - 8, label)


def _ring(data: Mapping[str, Any]) -> Markup:
    radii = sorted((c["r"] for c in data["circles"]), reverse=True)
    R = 110.0
    parts = [
        Markup('<circle class="body {}" cx="130" cy="130" r="{:.1f}"/>').format(
            "wall" if i == 0 else "hole", R * r
        )
        for i, r in enumerate(radii)
    ]
    for arrow in data["arrows"]:
        inner = arrow["r"] < 1
        r0, r1 = (R * arrow["r"] - 18, R * arrow["r"]) if inner else (R + 18, R)
        for angle in range(0, 360, 45):
            c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            parts.append(
                Markup('<path class="load" marker-end="url(#arrow)" '
                       'd="M{:.1f},{:.1f}L{:.1f},{:.1f}"/>').format(
                    130 + r0 * c, 130 - r0 * s, 130 + r1 * c, 130 - r1 * s
                )
            )  # fmt: skip
        at = (130.0, 134.0) if inner else (130 + R * 0.78 + 24, 130 - R * 0.78 - 20)
        parts.append(
            Markup('<text x="{:.0f}" y="{:.0f}" text-anchor="middle">{}</text>').format(
                *at, _subscript(arrow["label"])
            )
        )
    return Markup(
        '<svg class="sketch" viewBox="0 0 260 264" role="img" aria-label="ring under pressure">'
        "{}</svg>"
    ).format(Markup("").join(parts))


def _subscript(text: str) -> Markup:
    """p_i as SVG text with a lowered index."""
    letter, _, index = text.partition("_")
    return Markup('{}<tspan dy="4" font-size="75%">{}</tspan>').format(letter, index)

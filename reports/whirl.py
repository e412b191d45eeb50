"""Drawing of modes of rotating shafts: orbits, bent centre lines at one phase, outlines.

`templates/whirl.js` moves the lines and dots along the orbits; without it, the drawing is static.
"""

import math
from dataclasses import dataclass

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH
from verify.core.figures import Array, ComplexArray, Mode, Whirl

YAW, PITCH = math.radians(26), math.radians(20)  # of the viewer, from beside the shafts
EDGE, GAP, NAME = 8.0, 20.0, 18.0  # around all, between panels, for a panel's name
LENGTH = 0.94  # length of the shafts over the width of a panel
REACH, MOST = 0.16, 45.0  # largest displacement over the width of a panel, and in pixels
TALLEST = 390.0  # panels in one column
LETTER = 6.2  # about the width of a letter
LINE = 16  # of the key
ORBITS = 8  # of a shaft that are drawn
FINE = 40  # points of a centre line at most
SMALL = 0.5  # pixels that no orbit shows
FLAT = 0.03  # axes of an ellipse that is drawn as a line
ARROW = math.radians(50)  # ahead of the phase that is drawn
COLOURS = (0, 2, 3, 4)  # of the shafts


@dataclass(frozen=True)
class _View:
    """Projection of lengths along the shafts and of displacements across them to pixels."""

    origin: Array
    scale: float
    across: float

    def at(self, z: Array) -> Array:
        """Image points (m, 2) of positions on the axis."""
        return np.asarray(self.origin + self.scale * np.asarray(z)[:, None] * ALONG)

    def moved(self, x: ComplexArray, y: ComplexArray) -> ComplexArray:
        """Complex displacements (m, 2) in the image [pixels]."""
        return np.asarray(self.across * (x[:, None] * RIGHT + y[:, None] * UP))


# the image's x (right) and y (down) of the three axes: x away from the viewer, y up, z right
RIGHT = np.array([math.sin(YAW), -math.sin(PITCH) * math.cos(YAW)])
UP = np.array([0.0, -math.cos(PITCH)])
ALONG = np.array([math.cos(YAW), math.sin(PITCH) * math.sin(YAW)])


@dataclass(frozen=True)
class _Panels:
    """Arrangement of panels in columns: width, height, and position and scale of the axis."""

    columns: int
    wide: float
    high: float
    above: float
    scale: float
    reach: float


def whirl(w: Whirl) -> Markup:
    """SVG with a panel for each mode, a scale bar, and the meaning of the marks."""
    first, last = _ends(w)
    p = _panels(w, last - first, 1)
    if len(w.modes) > 1 and len(w.modes) * p.high > TALLEST:
        p = _panels(w, last - first, 2)
    body = []
    for k, mode in enumerate(w.modes):
        row, column = divmod(k, p.columns)
        left, top = EDGE + column * (p.wide + GAP), EDGE + row * p.high
        start = np.array([left + (1 - LENGTH) / 2 * p.wide, top + p.above])
        largest = max(
            float(np.sqrt(np.abs(x) ** 2 + np.abs(y) ** 2).max()) for _, x, y in mode.lines
        )
        view = _View(start - p.scale * first * ALONG, p.scale, p.reach / (largest or 1.0))
        body.append(svg.text(left + p.wide / 2, top + 12, mode.name, "named", "middle"))
        body += [*_still(w, view, first, last), *_moving(mode, view)]
    end = EDGE + p.high * -(-len(w.modes) // p.columns)
    body += [*_key(w, p.scale, end), *_shafts(w.names, end + LINE)]
    high = end + 26 + (LINE if w.names else 0)
    return svg.drawing(WIDTH, high, body, w.title, "chart whirl")


def _panels(w: Whirl, length: float, columns: int) -> _Panels:
    """Size of the panels: width by the number of columns, height by displacements and shafts."""
    wide = (WIDTH - 2 * EDGE - GAP * (columns - 1)) / columns
    scale, reach = LENGTH * wide / (length * ALONG[0]), min(REACH * wide, MOST)
    thick = scale * max((float(np.max(r)) for _, r in w.outlines), default=0.0)
    above = NAME + max(thick, reach) + 6
    high = above + scale * length * ALONG[1] + max(thick, reach) + 16
    return _Panels(columns, wide, high, above, scale, reach)


def _ends(w: Whirl) -> tuple[float, float]:
    z = np.concatenate([np.asarray(z) for mode in w.modes for z, _, _ in mode.lines]
                       + [np.asarray(z) for z, _ in w.outlines])  # fmt: skip
    first, last = float(z.min()), float(z.max())
    return first, last if last > first else first + 1.0


def _still(w: Whirl, view: _View, first: float, last: float) -> list[Markup]:
    """SVG of the undeformed shafts, their axis, and the bearings."""
    body = []
    for z, r in w.outlines:
        middle, up = view.at(np.asarray(z)), np.outer(view.scale * np.asarray(r), (0.0, 1.0))
        body.append(svg.polyline([*(middle - up), *(middle + up)[::-1]], "outline", closed=True))
    axis = view.at(np.array([first, last]))
    body.append(svg.polyline(axis, "centre"))
    body += [_support(*p) for p in view.at(np.array(w.supports))] if w.supports else []
    body += [_link(*p) for p in view.at(np.array(w.links))] if w.links else []
    return body


def _support(x: float, y: float) -> Markup:
    return svg.polyline([(x, y), (x - 4, y + 8), (x + 4, y + 8)], "support", closed=True)


def _link(x: float, y: float) -> Markup:
    return svg.marker(x, y, 3.2, "link", 3)


def _moving(mode: Mode, view: _View) -> list[Markup]:
    """SVG of the orbits of all shafts, and of their centre lines with dots, at phase zero."""
    orbits, lines, widest = [], [], (0.0, Markup(""))
    for k, (z, x, y) in enumerate(mode.lines):
        colour = COLOURS[k % len(COLOURS)]
        base, moved = view.at(z), view.moved(np.asarray(x), np.asarray(y))
        some = _some(len(z), ORBITS)
        for p, d in zip(base[some], moved[some], strict=True):
            orbit, size, arrow = _orbit(p, d, colour)
            orbits.append(orbit)
            widest = max(widest, (size, arrow), key=lambda found: found[0])
        fine = _some(len(z), FINE)
        lines += [
            _path(base[fine], moved[fine], f"fit s{colour} strokes bent"),
            _path(base[some], moved[some], f"orbit-dot s{colour}"),
        ]
    return [*orbits, *lines, widest[1]]


def _some(count: int, most: int) -> list[int]:
    """At most `most` indices below `count`, including the first and the last."""
    places = np.linspace(0, count - 1, min(count, most))
    return [int(i) for i in np.unique(np.rint(places).astype(int))]


def _orbit(p: Array, d: ComplexArray, colour: int) -> tuple[Markup, float, Markup]:
    """SVG of an ellipse around p, its width, and an arrow head in the direction of motion."""
    axes, (a, b), _ = np.linalg.svd(np.column_stack([d.real, -d.imag]))
    end = a * axes[:, 0]
    if a < SMALL:
        return Markup(""), 0.0, Markup("")
    if b < FLAT * a:
        return svg.polyline([p - end, p + end], f"orbit s{colour}"), float(a), Markup("")
    angle = math.degrees(math.atan2(end[1], end[0]))
    half = Markup("A{} {} {:.0f} 0 0 {},{}")
    (x0, y0), (x1, y1) = ([svg.short(v) for v in q] for q in (p + end, p - end))
    radii = svg.short(float(a)), svg.short(float(b))
    path = Markup('<path class="orbit s{}" d="M{},{}{}{}"/>').format(
        colour, x0, y0, half.format(*radii, angle, x1, y1), half.format(*radii, angle, x0, y0)
    )
    turn = complex(math.cos(ARROW), math.sin(ARROW))
    ahead, way = p + (d * turn).real, (d * turn * 1j).real
    return (
        path,
        float(a),
        svg.arrow_head(ahead[0], ahead[1], way[0], way[1], f"sense s{colour}", 7.0),
    )


def _path(base: Array, moved: ComplexArray, css: str) -> Markup:
    """SVG path of points at phase zero; its data contain displacements at 0 and 90 degrees."""
    shown = base + moved.real
    dots = css.startswith("orbit-dot")
    if dots:
        d = "".join(f"M{svg.short(x)},{svg.short(y)}h0" for x, y in shown)
    else:
        d = "M" + "L".join(f"{svg.short(x)},{svg.short(y)}" for x, y in shown)
    rows = np.column_stack([base, moved.real, -moved.imag])
    data = " ".join(",".join(svg.short(float(v) + 0.0) for v in row) for row in rows)
    return Markup('<path class="{}" d="{}" data-{}="{}"/>').format(
        css, d, "dots" if dots else "line", data
    )


def _key(w: Whirl, scale: float, top: float) -> list[Markup]:
    """SVG of a scale bar with a round length, and of the marks of bearings."""
    length = svg.ticks(0.0, 0.2 * WIDTH / scale, 2)[-1]
    y, right = top + 10, EDGE + scale * length
    body = [
        svg.line(EDGE, y, right, y, "base"),
        *(svg.line(x, y - 3, x, y + 3, "base") for x in (EDGE, right)),
        svg.text(right + 6, y + 4, f"{svg.plain(length)} {w.unit}", "tick"),
    ]
    left = right + 28 + LETTER * len(f"{svg.plain(length)} {w.unit}")
    for there, mark, name in (
        (w.supports, _support(left, y - 4), "bearing to ground"),
        (w.links, None, "bearing between shafts"),
    ):
        if there:
            body += [mark or _link(left, y), svg.text(left + 9, y + 4, name, "tick")]
            left += 26 + LETTER * len(name)
    return body


def _shafts(names: tuple[str, ...], top: float) -> list[Markup]:
    """SVG with the colours of the shafts."""
    body, left, y = [], EDGE, top + 10
    for k, name in enumerate(names):
        colour = COLOURS[k % len(COLOURS)]
        body += [
            svg.line(left, y, left + 22, y, f"fit s{colour} strokes"),
            svg.text(left + 28, y + 4, name, "tick"),
        ]
        left += 46 + LETTER * len(name)
    return body

"""Plot of a quantity over a plane in colours, with axes and a colour bar."""

import base64
from hashlib import sha256

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from reports.axes import WIDTH, Axes
from reports.bitmaps import FINER, webp
from reports.ramps import SIGNED, UNSIGNED, Scale
from verify.core.figures import Array, Density

LEFT, TOP, RIGHT, BOTTOM = 52.0, 28.0, 390.0, 232.0
HEIGHT = 310.0
BAR, BAR_TOP, THICK = 180.0, 282.0, 9.0


def density(d: Density) -> Markup:
    """SVG of the plane; no colour where z is NaN."""
    axes = Axes((LEFT, TOP, RIGHT, BOTTOM), _ends(d.x), _ends(d.y))
    colours = _scale(d)
    data = base64.b64encode(webp(_pixels(d, colours))).decode()
    image = Markup(
        '<image href="data:image/webp;base64,{}" x="{:g}" y="{:g}" width="{:g}" height="{:g}" '
        'preserveAspectRatio="none"/>'
    ).format(data, LEFT, TOP, RIGHT - LEFT, BOTTOM - TOP)
    axes.grid(svg.ticks(*axes.y), svg.plain)
    axes.body.append(image)
    axes.base(svg.ticks(*axes.x, 6), svg.plain)
    axes.titles(d.x_label, d.y_label)
    if d.point is not None:
        axes.body += _mark(axes, *d.point)
    name = sha256(data.encode()).hexdigest()[:10]
    return svg.drawing(
        WIDTH, HEIGHT, [*axes.body, *_bar(colours, name, d.z_label)], d.title, "chart"
    )


def _mark(axes: Axes, x: float, y: float, name: str) -> list[Markup]:
    """SVG of a mark in the plane; its name is on the side with more space."""
    u, v, centre = axes.X(x), axes.Y(y), (LEFT + RIGHT) / 2
    beside, anchor = (u - 10, "end") if u > centre else (u + 10, "start")
    height = v + 14 if v < (TOP + BOTTOM) / 2 else v - 6
    return [svg.circle(u, v, 5.0, "mark"), svg.text(beside, height, name, "named", anchor)]


def _ends(values: Array) -> tuple[float, float]:
    return float(values[0]), float(values[-1])


def _scale(d: Density) -> Scale:
    low, high = d.range or (float(np.nanmin(d.z)), float(np.nanmax(d.z)))
    return Scale(low=low, high=high, stops=SIGNED if d.range is None and low < 0 else UNSIGNED)


def _pixels(d: Density, colours: Scale) -> NDArray[np.uint8]:
    """RGBA pixels of the plane by linear interpolation, with the first row at the bottom."""
    across = np.linspace(0, len(d.x) - 1, FINER * round(RIGHT - LEFT))
    up = np.linspace(len(d.y) - 1, 0, FINER * round(BOTTOM - TOP))
    rows = np.array([np.interp(across, np.arange(len(d.x)), row) for row in d.z])
    z = np.array([np.interp(up, np.arange(len(d.y)), column) for column in rows.T]).T
    seen = np.isfinite(z)
    rgba = colours.colours(np.where(seen, z, colours.low).ravel()).reshape(*z.shape, 4)
    rgba[~seen] = 0
    return rgba


def _bar(colours: Scale, name: str, label: str) -> list[Markup]:
    """SVG of a colour bar with round numbers below it and its title beside it."""
    last = len(colours.stops) - 1
    stops = Markup("").join(
        Markup('<stop offset="{:.4f}" stop-color="{}"/>').format(i / last, colour)
        for i, colour in enumerate(colours.stops)
    )
    parts = [
        Markup('<defs><linearGradient id="z-{}">{}</linearGradient></defs>').format(name, stops),
        Markup('<rect x="{:g}" y="{:g}" width="{:g}" height="{:g}" fill="url(#z-{})"/>').format(
            LEFT, BAR_TOP, BAR, THICK, name
        ),
        svg.text(LEFT + BAR + 10, BAR_TOP + THICK, label, "label"),
    ]
    for value in svg.ticks(colours.low, colours.high, 4):
        x = LEFT + BAR * (value - colours.low) / ((colours.high - colours.low) or 1.0)
        parts += [
            svg.line(x, BAR_TOP + THICK, x, BAR_TOP + THICK + 4, "axis"),
            svg.text(x, BAR_TOP + THICK + 16, svg.plain(value), "tick", "middle"),
        ]
    return parts

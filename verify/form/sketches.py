"""Parts of sketches: circles, rings, rollers, loads, leaders."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

from verify.core.figures import Shape, Sketch

Point = tuple[float, float]


def sketch(title: str, *parts: Shape | Iterable[Shape]) -> Sketch:
    """Sketch of shapes and groups of shapes, drawn in this order."""
    shapes = [s for part in parts for s in ((part,) if isinstance(part, Shape) else part)]
    return Sketch(title=title, shapes=tuple(shapes))


def room(left: float, right: float) -> list[Shape]:
    """Invisible points at x = -`left` and x = `right` that keep space for labels."""
    return [Shape(style="text", points=np.array([[x, 0.0]])) for x in (-left, right)]


def circle(r: float, style: str = "faint", centre: Point = (0.0, 0.0)) -> Shape:
    """Circle with radius `r`."""
    t = np.linspace(0, 2 * np.pi, 73)
    around = r * np.column_stack([np.cos(t), np.sin(t)])
    return Shape(style=style, points=np.asarray(centre) + around)


def ring(r_i: float, r_o: float) -> tuple[Shape, Shape]:
    """Body between two circles."""
    return circle(r_o, "body"), circle(r_i, "hole")


def polar(r: float, degrees: float) -> Point:
    """Point (x, y) at a radius and an angle in degrees."""
    return r * float(np.cos(np.radians(degrees))), r * float(np.sin(np.radians(degrees)))


def rollers(count: int, r: float, at: float) -> list[Shape]:
    """Circles of rollers on a pitch circle; the first is half a pitch from the x axis."""
    return [circle(r, "faint", polar(at, (k + 0.5) * 360 / count)) for k in range(count)]


def radial_loads(count: int, start: float, end: float, label: str) -> list[Shape]:
    """Radial arrows between two radii; the first is on the x axis and has a label."""
    return [
        arrow(polar(start, k * 360 / count), polar(end, k * 360 / count), "" if k else label)
        for k in range(count)
    ]


def arrow(start: ArrayLike, end: ArrayLike, label: str = "", style: str = "load") -> Shape:
    """Arrow for a load."""
    return Shape(style=style, points=np.array([start, end]), label=label)


def leader(start: ArrayLike, end: ArrayLike, label: str) -> Shape:
    """Text with a line to the object that it names."""
    return arrow(start, end, label, "leader")


def text(at: ArrayLike, label: str = "") -> Shape:
    """Text; without a label, an invisible point that extends the area of the drawing."""
    return Shape(style="text", points=np.array([at]), label=label)


def shape(style: str, points: ArrayLike, label: str = "") -> Shape:
    """Shape of any other style, such as an outline or a line."""
    return Shape(style=style, points=np.asarray(points), label=label)

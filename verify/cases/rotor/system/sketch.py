"""Half a section of a rotor above its axis: shafts, discs, bearings to the ground, links."""

from typing import Any

import numpy as np

from verify.cases.rotor.system.transfer import DescribedRotor
from verify.core.figures import Array, Shape, Sketch
from verify.form import sketches
from verify.form.sketches import shape

TALL = 6  # length of the sketch over its largest radius; radii are on a larger scale


def outlines(q: DescribedRotor) -> list[tuple[Any, Any]]:
    """Positions and radii (m,) [m] of each shaft; a step has two points at one position."""
    found = []
    for shaft in q.shafts:
        z, r, at = [], [], shaft.start
        for s in (s for s in q.segments if s.shaft == shaft.name):
            z += [at, at + s.length]
            r += [s.d_o / 2] * 2
            at += s.length
        found.append((np.array(z), np.array(r)))
    return found


def sketch(q: DescribedRotor) -> Sketch:
    """Sketch with radii on a larger scale than lengths; bearings at the radius of their shaft."""
    lines = outlines(q)
    low, high = min(z.min() for z, _ in lines), max(z.max() for z, _ in lines)
    length = high - low
    tall = length / TALL
    k = tall / max(r.max() for _, r in lines)
    ends = np.array([[low - 0.05 * length, 0.0], [high + 0.05 * length, 0.0]])
    shapes = [shape("axis", ends)]
    for (z, r), shaft in zip(lines, q.shafts, strict=True):
        bore = [s.d_i / 2 for s in q.segments if s.shaft == shaft.name for _ in range(2)]
        points = np.vstack([
            np.column_stack([z, k * r]), np.column_stack([z, k * np.array(bore)])[::-1],
        ])  # fmt: skip
        shapes += [shape("body", points)]
        # outline of the lower half, unfilled: bearings are drawn there
        shapes += [shape("line", np.column_stack([z, -k * r]))]
    radius = [k * _radius(q, lines, n) for n in range(len(q.rotor.shaft_of))]
    for disc in q.discs:
        z, foot = q.places[disc.node - 1], radius[disc.node - 1]
        line = np.array([[z, foot], [z, 1.45 * tall]])
        shapes.append(shape("line", line, str(disc.node)))
    size = 0.03 * length
    for support in q.supports:
        top = np.array([q.places[support.node - 1], -radius[support.node - 1]])
        shapes += _triangle(top, size, str(support.node))
    for link in q.links:
        joined = [np.array([q.places[n - 1], -radius[n - 1]]) for n in (link.node, link.to)]
        shapes.append(_diamond((joined[0] + joined[1]) / 2, size / 2))
    names = ", ".join(s.name for s in q.shafts)
    title = (
        f"shafts: {names}. Radii have a larger scale than lengths. Numbers above are nodes of "
        "discs, numbers below are nodes of bearings"
    )
    title += ". Diamonds are bearings or clutches between shafts" if q.links else ""
    return sketches.sketch(title, shapes)


def _radius(q: DescribedRotor, lines: list[tuple[Any, Any]], station: int) -> float:
    """Outer radius [m] at a station; at a step, the larger of the two radii."""
    z, r = lines[q.rotor.shaft_of[station]]
    at = q.places[station]
    return float(r[np.isclose(z, at, rtol=0, atol=1e-9 * (1 + abs(at)))].max())


def _triangle(top: Array, size: float, number: str) -> list[Shape]:
    """Lines of a bearing to the ground, with its number below."""
    wedge = top + size * np.array([[0.0, 0.0], [-1.0, -1.7], [1.0, -1.7]])
    below = top + size * np.array([[0.0, -3.3]])
    return [shape("body", wedge), shape("text", below, number)]


def _diamond(middle: Array, size: float) -> Shape:
    points = middle + size * np.array([[-1.0, 0.0], [0.0, 1.0], [1.0, 0.0], [0.0, -1.0]])
    return shape("body", points)

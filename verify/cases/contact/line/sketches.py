"""Sketches of the cases of line contact."""

from typing import TYPE_CHECKING

import numpy as np

from verify.core.figures import Array, Shape, Sketch
from verify.form.sketches import arrow, circle, leader, room, shape, sketch

if TYPE_CHECKING:
    from verify.cases.contact.line.inputs import FlatInputs
    from verify.cases.contact.line.pair import TwoRollers
    from verify.cases.contact.line.ring import RollerInRace


def arc(y: float, r: float, start: float, turn: float) -> Array:
    """Points of an arc about (0, y), shape (m, 2); angles in degrees from the x axis."""
    t = np.radians(np.linspace(start, start + turn, 73))
    return np.column_stack([r * np.cos(t), y + r * np.sin(t)])


def sector(y: float, r: float, *, below: bool = False) -> Shape:
    """Closed outline of the part x >= 0 of a disc about (0, y): its quarter next to the origin."""
    edge = arc(y, r, 0.0, 90.0) if below else arc(y, r, -90.0, 90.0)
    return shape("modelled", np.vstack([edge, [[0.0, y]]]))


def flat(q: "FlatInputs") -> Sketch:
    """Sketch of a roller between rigid flats."""
    return sketch(
        f"roller, {q.shown('L')} long, between rigid flats", room(2.4, 2.6),
        circle(1.0, "body", (0.0, 1.0)), sector(1.0, 1.0),
        arrow((-1.4, 0.0), (1.4, 0.0), style="clamp"),
        arrow((1.4, 2.0), (-1.4, 2.0), style="clamp"),
        arrow((0.0, -0.3), (0.0, 2.3), style="axis"),
        arrow((0.0, 2.75), (0.0, 2.15), f"F = {q.shown('F')}"), arrow((0.0, -0.75), (0.0, -0.15)),
        leader((-1.6, 1.5), (-0.87, 1.5), f"R = {q.shown('R')}"),
        leader((1.7, 0.8), (0.6, 0.7), "FE: a quarter"),
        leader((1.8, -0.45), (1.1, 0.0), "rigid flat"),
    )  # fmt: skip


def pair(q: "TwoRollers") -> Sketch:
    """Sketch of two rollers; the smaller is drawn with at least 1/20 of the larger radius."""
    size = max(q.R_1, q.R_2)
    top, low = max(q.R_1 / size, 0.05), max(q.R_2 / size, 0.05)
    load = 2 * top + 0.1
    return sketch(
        f"two rollers, {q.shown('L')} long, to scale", room(2.4, 2.6),
        circle(top, "body", (0.0, top)), circle(low, "body", (0.0, -low)),
        sector(top, top), sector(-low, low, below=True),
        arrow((0.0, -2 * low - 0.15), (0.0, 2 * top + 0.15), style="axis"),
        arrow((0.0, load + 0.4), (0.0, load), f"F = {q.shown('F')}"),
        arrow((0.0, -2 * low - 0.5), (0.0, -2 * low - 0.1)),
        leader((-1.3, 1.5 * top + 0.1), (-0.87 * top, 1.5 * top), f"R_1 = {q.shown('R_1')}"),
        leader((-1.4, -1.5 * low), (-0.87 * low, -1.5 * low), f"R_2 = {q.shown('R_2')}"),
        leader((1.5, 0.4), (0.4 * top, 0.8 * top), "FE: two quarters"),
    )  # fmt: skip


def ring(q: "RollerInRace") -> Sketch:
    """Sketch of a roller in the bore of a race."""
    r_i, R = q.r_i / q.r_o, q.R / q.r_o
    force = 2 * R + 0.38  # the upper end of its arrow, with its label above
    half = np.vstack([arc(r_i, 1.0, -90, 180), arc(r_i, r_i, 90, -180)])
    return sketch(
        f"roller, {q.shown('L')} long, in a race, to scale", room(2.0, 2.2),
        circle(1.0, "body", (0.0, r_i)), circle(r_i, "hole", (0.0, r_i)),
        shape("modelled", half), circle(R, "body", (0.0, R)), sector(R, R),
        arrow((0.0, r_i - 1.15), (0.0, force), style="axis"),
        arrow((0.0, force + 0.3), (0.0, r_i + 1.15), style="axis"),
        arrow((0.0, force), (0.0, 2 * R + 0.03), f"F = {q.shown('F')}"),
        leader((-1.35, R), (-R, R), f"R = {q.shown('R')}"),
        leader((-1.3, 1.6 * r_i), (-0.78 * r_i, 1.63 * r_i), f"r_i = {q.shown('r_i')}"),
        leader((1.25, -0.1), (0.72, r_i - 0.7), f"r_o = {q.shown('r_o')}, fixed"),
        leader((1.25, 1.5), (0.7 * (r_i + 1) / 1.4, r_i + 0.5), "FE: 1/2 race, 1/4 roller"),
    )  # fmt: skip

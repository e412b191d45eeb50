"""Figures of a roller's end face."""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from verify.case import State
from verify.cases.contact.roller import figures as roller_figures
from verify.cases.contact.roller.end_fem import EDGE
from verify.cases.contact.roller.inputs import STRETCH
from verify.core.case import Context
from verify.core.figures import Figure, Picture, Shape, Sketch
from verify.form import sketches
from verify.form.plots import curve, dashes, dots, line, plot
from verify.form.sketches import arrow, leader

if TYPE_CHECKING:
    from verify.cases.contact.roller.end import EndFace

MPa, mm = roller_figures.MPa, roller_figures.mm
BODIES = {"end": "model with end faces", "control": "control model without end faces"}
EDGE_DRAWN = 5e-3


def drawn(context: Context) -> Iterator[Figure]:
    """Figures: line load towards the end, and pressure at the edge."""
    if context.fem:
        yield from (line_loads(context, state) for state in context.inputs.states)
        yield edge(context)


def line_loads(context: Context, state: State) -> Figure:
    """Figure: line load along half of the roller, with and without end face, and by half-space."""
    q, arrays = context.inputs, context.fem[-1].arrays
    on: Any = getattr(state.case, "contact")  # noqa: B009
    half = on.y > 0
    curves = [dashes("half-space", on.y[half] / mm, on.line_load[half] / 1e3, 4)]  # fmt: skip
    for i, (name, words) in enumerate(BODIES.items()):
        y, line = (arrays[f"{key}_{name}_{state.words}"] for key in "yq")
        curves.append(curve(f"FE, {words}", y / mm, line / 1e3, "line", 2 * i))
    return plot(
        f"Line load from mid-length to the end, roller with {state.words} profile", "y [mm]",
        "q [N/mm]", curves,
        y_top=1.7 * q.F / q.L / 1e3,
        note="If both bodies continue beyond the ends, the half-space is nearly exact. At a free "
        "end face, the roller deflects more, and load shifts to the middle.",
    )  # fmt: skip


def edge(context: Context) -> Figure:
    """Figure: pressure near the edge of a ring on a longer shaft, and slope by Williams."""
    arrays = context.fem[-1].arrays
    d, p = arrays["edge_distance"], arrays["edge_pressure"]
    near = (d > EDGE / 20) & (d < 0.1)
    x, y = np.log10(d[near]), np.log10(p[near] / p[np.argmin(np.abs(d - EDGE_DRAWN))])
    at = np.array([x.min(), x.max()])
    k, middle = context.inputs.sharpness, float(np.log10(EDGE_DRAWN))
    return plot(
        "Pressure towards the edge of an end face", "log10 distance/radius", "log10 p/p(0.005)",
        dots("FE, ring on a longer shaft", x, y),
        line(f"slope {k:.3f}", at, k * (at - middle), 2),
        dashes("slope −0.5, half-space", at, -0.5 * (at - middle), 4),
        note="Axisymmetric model of a ring on a shaft: near the edge, the section of the ring is a "
        "right-angled corner on a flat. At its end, a roller has the same longitudinal section.",
    )  # fmt: skip


def sketch(q: "EndFace") -> Sketch:
    """Sketch of the section along the axes: the roller between two races."""
    end, h = 1.6, min(q.overhang / q.L * 3.2, 1.6)
    r, race = 0.55, 1.0
    wide = end + h

    def box(style: str, x0: float, y0: float, x1: float, y1: float) -> Shape:
        return Shape(style=style, points=np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]))

    return sketches.sketch(
        f"roller, {q.shown('L')} long, between halves of two equal races",
        sketches.room(5.2, 5.2),
        box("body", -wide, -r - race, wide, -r), box("body", -wide, r, wide, r + race),
        box("body", -end, -r, end, r),
        box("modelled", 0, -r - race, wide, -r), box("modelled", 0, -r, end, r),
        arrow((-wide - 0.3, 0.0), (wide + 0.3, 0.0), style="axis"),
        arrow((0.0, -r - race - 0.2), (0.0, r + race + 0.2), style="axis"),
        arrow((0.0, r + race + 0.7), (0.0, r + race + 0.1), f"F = {q.shown('F')}"),
        arrow((0.0, -r - race - 0.7), (0.0, -r - race - 0.1)),
        arrow((end, -r - race - 0.6), (wide, -r - race - 0.6), f"h = {q.shown('overhang')}",
              "dimension"),
        leader((-wide - 0.8, 0.35), (-end + 0.1, 0.25), f"R_1 = {q.shown('R_1')}"),
        leader((-wide - 0.8, -1.2), (-wide + 0.1, -1.1), f"R_2 = {q.shown('R_2')}"),
        leader((wide + 0.6, 0.3), (end, 0.2), "end face"),
    )  # fmt: skip


def patch() -> Picture:
    """Picture of the pressure on the contact patch, with a magnified width."""
    return replace(
        roller_figures.patch(),
        caption="Pressure on the contact patch of the roller with end faces, without crown; "
        f"lengths across the roller are magnified {STRETCH:.0f} times",
    )  # fmt: skip

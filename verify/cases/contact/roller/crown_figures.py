"""Figures of the comparison of crowns: profiles, pressures of designs, uniform pressures."""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from verify.cases.contact.roller import figures
from verify.cases.contact.roller.inputs import DESIGNS, EVEN, Design, ending
from verify.core.case import Context
from verify.core.figures import Figure
from verify.form.plots import line, plot

if TYPE_CHECKING:
    from verify.cases.contact.roller.crowns import ComparedCrowns

MPa, mm, um = figures.MPa, figures.mm, figures.um
PROFILES = {  # Fig. 11: one parameter at a time
    "K_1": (Design(1, 0.7, 10e-6), Design(3, 0.7, 10e-6), Design(5, 0.7, 10e-6)),
    "K_2": (Design(1, 0.4, 10e-6), Design(1, 0.55, 10e-6), Design(1, 0.7, 10e-6)),
    "z_m": (Design(1, 0.7, 5e-6), Design(1, 0.7, 10e-6), Design(1, 0.7, 15e-6)),
}
COMPARED = (0, 1, 6, 3)  # of the designs, in Fig. 12's plot


def drawn(context: Context) -> Iterator[Figure]:
    """Figures: profiles of Fig. 11, pressures of Fig. 12, and uniform pressures."""
    yield from (grown(context.inputs, varied) for varied in PROFILES)
    if context.fem:
        yield designs(context)
        yield from (by_all(context, design) for design in DESIGNS[:2])
        yield even(context)
        yield ends(context)


def grown(q: "ComparedCrowns", varied: str) -> Figure:
    """Figure like Fig. 11: crowns for increasing values of the parameter `varied`."""
    start = 0.85 if varied == "z_m" else 0.0  # if it is visible
    y = np.linspace(start, 1.0, 301) * q.L / 2
    return plot(
        f"Crowns for increasing {varied} (Fig. 11)", "y [mm]", "z [µm]",
        (
line(f"{design}", y / mm, q.designed(design).gap(y) / um, i)
for i, design in enumerate(PROFILES[varied])
),
        note="Legend: (K_1, K_2, z_m). Only the half y > 0 is drawn; Q = F. Fig. 11 of the paper "
        "was not available for a comparison.",
    )  # fmt: skip


def designs(context: Context) -> Figure:
    """Figure like Fig. 12: pressures of several designs by strips and half-space."""
    q = context.inputs
    curves = []
    for i, design in enumerate(DESIGNS[k] for k in COMPARED):
        along, end = q.designed(design).strips, f"_of_{design!s}"
        curves.append(line(f"{design}", along.y / mm, along.p / MPa, i))
        curves.append(figures.half_space(context, "" if i else "half-space", end, i))
    p_0 = q.p_0 / MPa
    return plot(
        "Pressure of the designs of the paper (Fig. 12)", "y [mm]", "p [MPa]", curves,
        y_top=1.25 * p_0, y_bottom=0.5 * p_0,
        note="Legend: (K_1, K_2, z_m). Lines: strips; dots: half-space. Design (1, 0.7, 10 µm) has "
        "the most uniform pressure except at its ends. Its ends are loaded: there, the pressure of "
        "a half-space is unbounded.",
    )  # fmt: skip


def by_all(context: Context, design: Design) -> Figure:
    """Figure of p(y) by all models for one design."""
    roller = context.inputs.designed(design)
    return figures.pressures(context, roller, f"_of_{design!s}", f", crown {design}")


def even(context: Context) -> Figure:
    """Figure of the pressures with the crowns of Lundberg and of Johns and Gohar."""
    curves = []
    for i, (name, words) in enumerate(EVEN.items()):
        curve = figures.half_space(context, words, ending(name), 2 * i)
        curves.append(replace(curve, y=curve.y * MPa / context.inputs.p_0))
    return plot(
        "Pressure with the crowns of Lundberg and of Johns and Gohar", "y [mm]", "p/p_0", curves,
        y_bottom=0.9, y_top=1.1,
        note="Dots: half-space. p_0: Hertz's pressure of the uniform line load.",
    )  # fmt: skip


def ends(context: Context) -> Figure:
    """Figure of pressures within ten half-widths of the end, with crowns for uniform pressure."""
    q, b = context.inputs, context.inputs.b
    curves = []
    for i, (name, words) in enumerate(EVEN.items()):
        y, p = (context.fem[-1].arrays[f"{key}{ending(name)}"] for key in "yp")
        near = (q.L / 2 - y < 10 * b) & (y < q.L / 2)
        curves.append(line(words, (q.L / 2 - y[near])[::-1] / b, p[near][::-1] / q.p_0, 2 * i))
    return plot(
        "Pressure near the end with the crowns of Lundberg and of Johns and Gohar",
        "distance from the end over b", "p/p_0",
        curves,
        note="Lines: half-space. Towards the end, both pressures rise before they fall: for a "
        "uniform pressure, both crowns should be slightly deeper there. The drop of Lundberg's "
        "crown is infinite at the end.",
    )  # fmt: skip

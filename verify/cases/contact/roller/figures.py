"""Figures of a finite line contact: sketch, equations, curves, pressure maps."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from analytic.contact.roller_parts import RollerParts
from analytic.contact.strips import Strips
from verify.cases.contact.roller.formulas import SlicedRoller
from verify.cases.contact.roller.inputs import STRETCH, Crown, Roller, Tilt
from verify.core.case import Context
from verify.core.figures import Array, Curve, Figure, Picture, Sketch
from verify.form import sketches
from verify.form.plots import curve, dots, line, plot
from verify.form.sketches import arrow, leader, shape

MPa, mm, um = 1e6, 1e-3, 1e-6
NAMES = {"strips": "strips", "slices": "slices, Eqs. 2-5", "independent": "independent slices"}
STYLES = {"strips": ("line", 0), "slices": ("dashes", 1), "independent": ("dashes", 3)}
DOTS = 60  # number of half-space points along the roller
OVER = 1.35  # upper end of the plot, relative to the largest strip pressure away from the ends


def sketch(q: Roller) -> Sketch:
    """Sketch in side view: race and roller, with crown and tilt exaggerated."""
    end, h = 2.0, 1.4
    y = np.linspace(-end, end, 81)
    drop = q.gap(y * q.L / (2 * end))
    z = 0.35 * drop / drop.max() if drop.max() > 0 else 0 * y
    tilted = isinstance(q, Tilt) and q.theta > 0
    top = h + (z if tilted else 0 * y)
    roller = np.vstack([np.column_stack([y, z]), np.column_stack([y, top])[::-1]])
    d = 2 * end * q.d / q.L
    race = f"R_2 = {q.shown('R_2')}" if abs(q.R_2) < 1e4 else "flat"
    crown = " with its crown" if isinstance(q, Crown) else " without crown"
    lean = f", tilted by {np.degrees(q.theta):.3g}°" if isinstance(q, Tilt) else ""
    return sketches.sketch(
        f"roller{crown}{lean} on a longer race, heights exaggerated",
        sketches.room(5.0, 5.0),
        shape("body", [(-3.0, -0.8), (3.0, -0.8), (3.0, 0.0), (-3.0, 0.0)]),
        shape("body", roller),
        arrow((-2.4, (z[0] + top[0]) / 2), (2.4, (z[-1] + top[-1]) / 2), style="axis"),
        arrow((0.0, h + 0.9), (0.0, h + 0.25), f"F = {q.shown('F')}"),
        arrow((-end, -1.35), (end, -1.35), f"l = {q.shown('L')}", "dimension"),
        arrow((end - d, h + 0.45), (end, h + 0.45), f"d = {q.shown('d')}", "dimension"),
        leader((-3.2, 1.2), (-end + 0.1, 1.0), f"R_1 = {q.shown('R_1')}"),
        leader((-3.3, -0.5), (-2.6, -0.4), race),
        [leader((3.2, 0.75), (end, z[-1] / 2), f"z_m = {q.z_m / um:.4g} µm")]
        if isinstance(q, Crown) else [],
    )  # fmt: skip


def modelled(q: SlicedRoller) -> Iterator[tuple[str, RollerParts, dict[str, Any]]]:
    """For each model: its name, its values along the roller, and the style of its curve."""
    for name, words in NAMES.items():
        style, colour = STYLES[name]
        along = q.strips if name == "strips" else q.sliced(name)
        yield words, along, {"style": style, "colour": colour}


def pressures(context: Context, of: Any = None, key: str = "", crown: str = "") -> Figure:
    """Figure of p(y) of the roller `of` (by default of the inputs), by all models.

    `key` is the suffix of the names of the arrays of this roller.
    """
    q = of or context.inputs
    models = list(modelled(q))
    curves = [Curve(name=n, x=one.y / mm, y=one.p / MPa, **style) for n, one, style in models]
    if context.fem:
        curves.append(half_space(context, "half-space", key))
    return plot(
        f"Pressure along the roller, at x = 0{crown}", "y [mm]", "p [MPa]", curves,
        y_top=OVER * max(one.p_max / MPa for _, one, _ in models),
        note=f"{q.n} strips, {q.slices} slices; dots: boundary elements on a half-space, finest "
        "grid. If an end is loaded, the pressure of the half-space is unbounded there, and its "
        "curve leaves the diagram.",
    )  # fmt: skip


def half_space(context: Context, name: str, key: str = "", colour: int = 4) -> Curve:
    """Dots: pressure at some points along the roller, from the finest grid on the half-space."""
    arrays = context.fem[-1].arrays
    y, p = arrays[f"y{key}"], arrays[f"p{key}"]
    some = np.unique(np.round(np.linspace(0, len(y) - 1, DOTS)).astype(int))
    return dots(name, y[some] / mm, p[some] / MPa, colour)


def over(found: Sequence[Strips], x: Array, even: Sequence[float]) -> list[Curve]:
    """Curves of the ratio of peak pressure to `even` pressure; the abscissae are `x`.

    The curve is a line where both ends are unloaded, and dots where an end is loaded.
    """
    p = np.array([float(f.peak) / e for f, e in zip(found, even, strict=True)])
    loaded = np.array([bool(f.carries[0] or f.carries[-1]) for f in found])
    parts = (("given crown, ends unloaded", ~loaded, "line"),
             ("given crown, an end loaded", loaded, "dots"))  # fmt: skip
    return [
        curve(name, x[some], p[some], style) for name, some, style in parts if some.any()
    ]  # fmt: skip


def profile(q: Any) -> Figure:
    """Figure of the gap along the roller before loading."""
    y = np.linspace(-q.L / 2, q.L / 2, 401)
    return plot(
        "Gap before loading, at x = 0", "y [mm]", "z [µm]",
        line("crown" + (" and tilt" if isinstance(q, Tilt) else ""), y / mm, q.gap(y) / um),
        note=f"The straight middle is (1 − K_2) l = {(1 - q.K_2) * q.L / mm:.4g} mm long.",
    )  # fmt: skip


def loads(context: Context) -> Figure:
    """Figure of the line load along the roller by all models."""
    q = context.inputs
    curves = [
        Curve(name=n, x=one.y / mm, y=one.line / 1e3, **style) for n, one, style in modelled(q)
    ]
    return plot(
        "Line load along the roller", "y [mm]", "q [N/mm]", curves,
        y_top=OVER * max(float(np.sort(c.y)[-5]) for c in curves),
        note=f"The mean line load is {q.F / q.L / 1e3:.4g} N/mm.",
    )  # fmt: skip


def patch() -> Picture:
    """Picture of the pressure on the contact patch."""
    return Picture(
        field="patch", data="pressure", symbol="p", unit="MPa", factor=MPa,
        caption="Pressure on the contact patch. Horizontal: along the roller; vertical: across the "
        f"roller, magnified {STRETCH:.0f} times", displacement="", stretch=STRETCH,
    )  # fmt: skip

"""What the report shows of the round ring under pressure."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.polyhedral import expansion
from verify.core.case import Context, Values
from verify.core.figures import Curve, Curves, Equation, Figure, Picture, Shape, Sketch
from verify.core.tex import factor, tex

MPa, mm = 1e6, 1e-3
WALLS = (0.01, 0.0178, 0.0316, 0.0562, 0.1)  # delta_1/d_m of the sweep: a decade
ROLLERS = 6  # drawn round the ring
SOLID = 0.99  # of delta_1/d_m, where figures end: at 1 there is no bore


def arc(r: float, centre: tuple[float, float] = (0.0, 0.0)) -> Any:
    """A circle as points (73, 2)."""
    t = np.linspace(0, 2 * np.pi, 73)
    return np.asarray(centre) + r * np.column_stack([np.cos(t), np.sin(t)])


def sketch(q: Any) -> Sketch:
    bore = q.d_i / q.d_e
    gap, roller = 0.06, 0.13
    shapes = [Shape(style="body", points=arc(1.0)), Shape(style="hole", points=arc(bore))]
    for k in range(ROLLERS):
        angle = 2 * np.pi * k / ROLLERS + np.pi / 6
        at = (1 + gap + roller) * np.array([np.cos(angle), np.sin(angle)])
        shapes.append(Shape(style="faint", points=arc(roller, (at[0], at[1]))))
    for angle in np.radians([0, 60, 120, 180, 240, 300]):
        way = np.outer([bore - 0.22, bore], [np.cos(angle), np.sin(angle)])
        shapes.append(Shape(style="load", points=way, label="p" if angle == 0 else ""))
    shapes.append(Shape(style="faint", points=arc(1 + gap + 2 * roller)))
    leader = np.array([[-1.25, 0.92], [-0.5 * (1 + bore) * 0.766, 0.5 * (1 + bore) * 0.643]])
    shapes.append(Shape(style="leader", points=leader, label=f"wall {q.delta_1 / mm:.4g} mm"))
    shapes.append(
        Shape(style="leader", points=np.array([[1.2, -1.1], [0.72, -0.72]]),
              label=f"d_e = {q.d_e / mm:.4g} mm")
    )  # fmt: skip
    title = (
        f"a round ring of {q.d_e / mm:.4g} mm under pressure in its bore, {q.j_D / mm:.3g} mm of "
        "clearance on the diameter to its rollers (drawn much larger)"
    )
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    d_i, d_e, d_m = (tex(x / mm) for x in (q.d_i, q.d_e, q.d_m))
    return (
        Equation(
            tex=r"d_m = \frac{d_i + d_e}{2}",
            numbers=rf"= \frac{{{d_i} + {d_e}}}{{2}} = {d_m}\ \mathrm{{mm}}",
            place="Eq. 6",
        ),
        Equation(
            tex=r"\sigma_t = \frac{E j_D}{d_m}",
            numbers=rf"= \frac{{{tex(q.E / MPa)}\cdot {tex(q.j_D / mm)}}}{{{d_m}}} "
            rf"= {tex(v['sigma_t'] / MPa)}\ \mathrm{{MPa}}",
            place="Eqs. 8 and 9",
        ),
        Equation(
            tex=r"p_1 = \frac{2 \delta_1 \sigma_t}{d_i}",
            numbers=rf"= \frac{{2\cdot {tex(q.delta_1 / mm)}\cdot "
            rf"{factor(v['sigma_t'] / MPa)}}}{{{d_i}}} = {tex(v['p_1'] / MPa)}\ \mathrm{{MPa}}",
            place="Eq. 10",
        ),
        Equation(
            tex=r"p = \frac{E j_D (d_e^2 - d_i^2)}{2 d_i^2 d_e} = \frac{d_m^2}{d_i d_e}\, p_1",
            numbers=rf"= {tex(v['K'])}\cdot {factor(v['p_1'] / MPa)} "
            rf"= {tex(v['Lamé, plane stress'] / MPa)}\ \mathrm{{MPa}}",
            place="Lamé, plane stress; K of a polygon with ever more corners",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    """Pressure over the wall: the thin ring, Lamé, finite elements."""
    q = context.inputs
    share = np.linspace(WALLS[0], min(max(0.2, 1.2 * q.delta_1 / q.d_m), SOLID), 60)
    walls = {"d_i": q.d_m * (1 - share), "d_e": q.d_m * (1 + share)}
    p_1 = expansion.touching_pressure(j_D=q.j_D, **walls, E=q.E)
    thick = p_1 * expansion.many_corners_factor(**walls)
    curves = [
        Curve(name="thin ring, Eq. 10", x=share, y=p_1 / MPa, colour=0),
        Curve(name="Lamé, plane stress", x=share, y=thick / MPa, style="dashes", colour=1),
    ]
    if context.fem:
        curves.append(
            Curve(name="FE", x=np.array(WALLS), y=context.fem[-1].arrays["swept"] / MPa,
                  style="dots", colour=2)
        )  # fmt: skip
    note = (
        f"A ring of {q.d_m / mm:.4g} mm mean diameter that takes up {q.j_D / mm:.3g} mm; the thin "
        "ring's error grows with the square of the wall."
    )
    return (
        Curves(title="Pressure that takes up the clearance", x_label="wall δ_1/d_m",
               y_label="p [MPa]", curves=tuple(curves), note=note),
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="ring", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                caption="Von Mises stress where the clearance is taken up, plane stress",
                mirror=("x", "y")),
    )  # fmt: skip

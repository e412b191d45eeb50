"""What the report shows of the wedged roller: its forces, formulas, the limit, the stick zone."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.polyhedral.wedge.fem import ACROSS
from verify.cases.polyhedral.wedge.limit import ANY
from verify.cases.polyhedral.wedge.stick import GROWTH
from verify.core.case import Context, Values
from verify.core.figures import (
    Curve,
    Curves,
    Dots,
    Equation,
    Figure,
    Picture,
    Profile,
    Shape,
    Sketch,
)
from verify.core.tex import tex
from verify.judging.profiles import along

DRAWN = math.radians(12)  # half of the wedge angle in the sketch, at least


def sketch(q: Any) -> Sketch:
    """The free body of a roller: both contact forces on the line through both contacts."""
    half = max(q.half, DRAWN)
    turn = np.linspace(0.0, 2 * np.pi, 121)
    upper = _flat(half, 1)
    shapes = (
        Shape(style="body", points=np.column_stack([np.cos(turn), np.sin(turn)])),
        Shape(style="axis", points=np.array([[-1.9, 0.0], [3.0, 0.0]])),
        *upper, *_flat(half, -1),
        Shape(style="faint", points=np.array([[math.sin(half), -1.9], [math.sin(half), 1.9]])),
        Shape(style="leader", points=np.array([[2.1, 1.55], [math.sin(half), 1.35]]),
              label="line through both contacts"),
        Shape(style="leader", points=np.array([[-1.5, -0.45], [-0.86, -0.5]]),
              label=f"d = {q.d * 1e3:.4g} mm"),
        Shape(style="leader", points=np.array([[2.2, 0.32], [1.7, 0.0]]),
              label=f"bisector, α = {math.degrees(q.alpha):.4g}°"),
        Shape(style="text", points=np.array([[4.6, 0.0]])),
        Shape(style="text", points=np.array([[-3.0, 0.0]])),
    )  # fmt: skip
    return Sketch(
        title="free body of a roller, wedge drawn wider than it is: normal forces push it out, "
        "friction pulls it in; finite elements take the half above the bisector",
        shapes=shapes,
    )


def _flat(half: float, side: int) -> tuple[Shape, ...]:
    """One flat with what it does to the roller; `side` 1 above the bisector, -1 below."""
    mirror = np.array([1, side])
    n = np.array([math.sin(half), math.cos(half)]) * mirror
    t = np.array([math.cos(half), -math.sin(half)]) * mirror
    wall = np.array([n - 1.7 * t, n + 1.9 * t])[::side]  # hatched outside, on its left
    inside = 0.8 * n
    return (
        Shape(style="clamp", points=wall),
        Shape(style="load", points=np.array([1.75 * n, n]), label="N"),
        Shape(style="load", points=np.array([inside, inside + 0.62 * t]), label="T"),
    )


def equations(q: Any, v: Values) -> Sequence[Equation]:
    half, mu, N = tex(math.degrees(q.half)), tex(q.mu), tex(q.N)
    lever = rf"{q.z}\cdot\frac{{{tex(q.D_i * 1e3)}\ \mathrm{{mm}}}}{{2}}"
    tan = math.tan(q.half)
    holds = "M_free" in v
    sign = "<" if holds else r"\ge"
    free = "" if not holds else (
        rf"= {N}\cdot{tex(tan)}\cdot{lever} = {tex(v['M_free'])}\ \mathrm{{N\,m}}"
    )  # fmt: skip
    return (
        Equation(
            tex=r"C = 2N\left(\mu\cos\frac{\alpha}{2} - \sin\frac{\alpha}{2}\right) > 0",
            numbers=rf"= 2\cdot{N}\,({mu}\cos{half}° - \sin{half}°) = {tex(v['C'])}\ \mathrm{{N}}",
            place="Eq. 1; C is what pulls the roller out against all of its friction",
        ),
        Equation(
            tex=r"\tan\frac{\alpha}{2} < \mu",
            numbers=f"{tex(tan)} {sign} {mu}",
            place="Eq. 2" if holds else "Eq. 2: a free roller is squeezed out",
        ),
        Equation(tex=r"M_t = N\tan\frac{\alpha}{2}\, z\,\frac{D_i}{2}", numbers=free,
                 place="free rollers, Eqs. 3 and 5 corrected"),
        Equation(
            tex=r"M_t = \mu N z\,\frac{D_i}{2}",
            numbers=rf"= {mu}\cdot{N}\cdot{lever} = {tex(v['M_caged'])}\ \mathrm{{N\,m}}",
            place="Eq. 3 as printed: caged rollers, at the limit",
        ),
        Equation(tex=r"N = \frac{2M_t}{\mu z D_i}, \quad N < \frac{2M_t}{z D_i\tan(\alpha/2)}",
                 place="Eqs. 4 and 5 as printed; the bound is met with =, and 4 is the least N"),
        Equation(tex=r"\frac{c}{a} = \sqrt{1 - \frac{T}{\mu N}}",
                 place="Cattaneo, a roller pressed first and let go then"),
    )  # fmt: skip


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    return (_limit(context), _torques(context), _growth(context), _grown(context))


def _limit(context: Context) -> Curves:
    share, left, ratio = context.fem[-1].arrays["over angles"]
    stays, unit = left > ANY, np.array([0.0, 1.0])
    return Curves(
        title="How much of its friction a roller uses", x_label="tan(α/2)/μ", y_label="T/(μN)",
        curves=(
            Curve(name="free roller, T = N tan(α/2)", x=unit, y=unit),
            Curve(name="caged, at the limit; Eq. 3 as printed", x=1.5 * unit, y=unit**0,
                  style="dashes", colour=1),
            Curve(name="FE, free", x=share[stays], y=ratio[stays], style="dots"),
            Curve(name="FE, squeezed out: nothing of N is left", x=share[~stays], y=ratio[~stays],
                  style="dots", colour=2),
        ),
        note="One wedge after the other, at the friction given; beyond 1 a free roller leaves.",
    )  # fmt: skip


def _torques(context: Context) -> Dots:
    v, fe = context.analytic, context.fem[-1].values
    return Dots(
        title="Torque of all rollers", label="M_t [N m]",
        items=(
            ("Eq. 3, friction's limit", v["M_caged"], None, "formula"),
            ("FE, caged, slipping", fe["M_caged"], None, "fe"),
            ("free, N tan(α/2)", v["M_free"], None, "formula"),
            ("FE, free", fe["M_free"], None, "fe"),
        ),
        note="Under the same normal force.",
    )  # fmt: skip


def _growth(context: Context) -> Profile:
    values, u = along(context, "profile, growth", formal=1.0, scale=1.0)
    k = np.linspace(0.0, 1.0, 201)
    return Profile(
        title="Where a roller sticks that was pressed first and let go then", x_label="T/(μN)",
        y_label="c/a", x=k, y=np.sqrt(1 - k), x_fem=GROWTH, y_fem=values, y_ref=np.sqrt(1 - GROWTH),
        u=u, scale=1.0, neglects=True,
        note=f"Let go, it comes to rest at T/(μN) = tan(α/2)/μ = {context.inputs.wedged:.3f}.",
    )  # fmt: skip


def _grown(context: Context) -> Profile:
    q = context.inputs
    scale = math.tan(q.half) * q.p_0
    values, u = along(context, "profile, grown", formal=1.0, scale=scale)
    x = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))
    return Profile(
        title="Traction of a roller that is wedged in: N and T grow together", x_label="x/a",
        y_label="q/(p_0 tan(α/2))", x=x, y=np.sqrt(1 - x**2), x_fem=ACROSS, y_fem=values / scale,
        y_ref=np.sqrt(1 - ACROSS**2), u=u / scale, scale=1.0, neglects=True,
        note="All of it sticks: q is tan(α/2) p everywhere, but for an odd part of the order a/R "
        "from the roller's curvature and for the steps in which the load grows.",
    )  # fmt: skip


def pictures(q: Any) -> Sequence[Picture]:
    x, y = q.R * math.sin(q.half), q.R * math.cos(q.half)
    w = 3.0 * q.a
    return (
        Picture(field="roller", data="log_shear", symbol="τ_max/p_0", unit="1", factor=1.0,
                decades=True,
                caption="Largest shear stress in the roller, as a power of ten of p_0: it runs "
                "from contact to contact", displacement="", mirror=("y",)),
        Picture(field="roller", data="shear", symbol="τ_max/p_0", unit="1", factor=1.0,
                caption="The same about the upper contact", displacement="",
                window=(x - w, y - 1.5 * w, x + w, y + 0.5 * w)),
    )  # fmt: skip

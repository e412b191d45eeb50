"""What the report shows of a finite line contact: sketch, equations, curves, pressure maps."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact.crown import slice_centres
from analytic.contact.strips import Strips
from verify.cases.contact.roller.formulas import MODELS, by_strips, sliced
from verify.cases.contact.roller.inputs import STRETCH, Crown, Roller, TiltedInputs
from verify.core.case import Context, Values
from verify.core.figures import Array, Curve, Curves, Equation, Figure, Picture, Shape, Sketch
from verify.core.tex import tex

MPa, mm, um = 1e6, 1e-3, 1e-6
NAMES = {"strips": "strips", "slices": "slices, Eqs. 2-5", "lamina": "uncoupled slices"}
STYLES = {"strips": ("line", 0), "slices": ("dashes", 1), "lamina": ("dashes", 3)}
DOTS = 60  # of the half-space along the roller
OVER = 1.35  # of the strips' largest pressure beyond the ends, where the plot is cut


def line(*points: tuple[float, float]) -> Array:
    return np.array(points)


def sketch(q: Roller) -> Sketch:
    """Side view: the race below, the roller with its crown and tilt exaggerated."""
    end, h = 2.0, 1.4
    y = np.linspace(-end, end, 81)
    drop = q.gap(y * q.L / (2 * end))
    z = 0.35 * drop / drop.max() if drop.max() > 0 else 0 * y
    tilted = isinstance(q, TiltedInputs) and q.theta > 0
    top = h + (z if tilted else 0 * y)
    roller = np.vstack([np.column_stack([y, z]), np.column_stack([y, top])[::-1]])
    d = 2 * end * q.d / q.L
    shapes = [
        Shape(style="text", points=line((-5.0, 0.0))),
        Shape(style="text", points=line((5.0, 0.0))),
        Shape(style="body", points=line((-3.0, -0.8), (3.0, -0.8), (3.0, 0.0), (-3.0, 0.0))),
        Shape(style="body", points=roller),
        Shape(style="axis", points=line((-2.4, (z[0] + top[0]) / 2), (2.4, (z[-1] + top[-1]) / 2))),
        Shape(style="load", points=line((0.0, h + 0.9), (0.0, h + 0.25)), label=f"F = {q.F:.4g} N"),
        Shape(style="dimension", points=line((-end, -1.35), (end, -1.35)),
              label=f"l = {q.L / mm:.4g} mm"),
        Shape(style="dimension", points=line((end - d, h + 0.45), (end, h + 0.45)),
              label=f"d = {q.d / mm:.4g} mm"),
        Shape(style="leader", points=line((-3.2, 1.2), (-end + 0.1, 1.0)),
              label=f"R_1 = {q.R_1 / mm:.4g} mm"),
        Shape(style="leader", points=line((-3.3, -0.5), (-2.6, -0.4)), label=_race(q)),
    ]  # fmt: skip
    if isinstance(q, Crown):
        label = f"z_m = {q.z_m / um:.4g} µm"
        shapes.append(Shape(style="leader", points=line((3.2, 0.75), (end, z[-1] / 2)),
                            label=label))  # fmt: skip
    crown = " with its crown" if isinstance(q, Crown) else " without crown"
    lean = f", tilted by {np.degrees(q.theta):.3g}°" if isinstance(q, TiltedInputs) else ""
    return Sketch(title=f"roller{crown}{lean} on a longer race, heights exaggerated",
                  shapes=tuple(shapes))  # fmt: skip


def _race(q: Roller) -> str:
    return f"R_2 = {q.R_2 / mm:.4g} mm" if abs(q.R_2) < 1e4 else "flat"


def equations(q: Any, v: Values) -> Sequence[Equation]:
    """The models with their numbers; the crown where there is one."""
    E = q.E_star / MPa
    found = [
        Equation(tex=r"\frac{1}{R} = \frac{1}{R_1} + \frac{1}{R_2}",
                 numbers=rf"\Rightarrow\ R = {tex(q.R / mm)}\ \mathrm{{mm}}"),
        Equation(tex=r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}",
                 numbers=rf"\Rightarrow\ E^* = {tex(E)}\ \mathrm{{MPa}}",
                 place="E' of Eq. 1 is 2 E*"),
    ]  # fmt: skip
    if isinstance(q, Crown):
        A = q.K_1 * q.Q / (np.pi * q.L * q.E_star)
        found += [
            Equation(tex=r"A = \frac{2 K_1 Q}{\pi l E'} = \frac{K_1 Q}{\pi l E^*}",
                     numbers=rf"= {tex(A / um)}\ \mathrm{{\mu m}}", place="Eq. 1"),
            Equation(
                tex=r"z = -A \ln\left\{1 - \left[1 - e^{-z_m/A}\right] t^2\right\},\quad "
                r"t = \max\left(0, \frac{|y| - l/2}{K_2 l/2} + 1\right)",
                numbers=rf"z(l/2) = {tex(q.z_m / um)}\ \mathrm{{\mu m}}", place="Eq. 1, corrected",
            ),
        ]  # fmt: skip
    s = v["Palmgren"] ** (10 / 9) / q.F * q.slices
    return (
        *found,
        Equation(
            tex=r"\sum_k S_{jk} q_k = (\delta - z_j)^{10/9},\quad "
            r"S = s\, \frac{n_s\, w}{\sum w}",
            numbers=rf"s = {tex(s * 1e3 ** (10 / 9))}\ \mathrm{{mm^{{10/9}}/N}}",
            place="Eqs. 2 to 5",
        ),
        Equation(
            tex=r"\sum_k C_{jk}(b_k)\, q_k = \delta - z_j,\quad b_k = \sqrt{\frac{4 q_k R}"
            r"{\pi E^*}},\quad p_k = \frac{2 q_k}{\pi b_k}",
            numbers=rf"p_{{max}} = {tex(v['strips peak'] / MPa)}\ \mathrm{{MPa}}",
            place="strips",
        ),
    )


def pressures(context: Context, of: Any = None, key: str = "", crown: str = "") -> Figure:
    """p(y) of all models and of the half-space; `of` another roller, its arrays led by `key`."""
    q = of or context.inputs
    curves, tops = [], []
    for name, words in NAMES.items():
        _, parts = by_strips(q, q.n) if name == "strips" else sliced(q, MODELS[name])
        style, colour = STYLES[name]
        curves.append(Curve(name=words, x=parts.y / mm, y=parts.p / MPa, style=style,
                            colour=colour))  # fmt: skip
        tops.append(parts.peak / MPa)
    if context.fem:
        curves.append(half_space(context, "half-space", key))
    return Curves(
        title=f"Pressure along the roller, at x = 0{crown}", x_label="y [mm]", y_label="p [MPa]",
        curves=tuple(curves), y_top=OVER * max(tops),
        note=f"{q.n} strips, {q.slices} slices; dots: boundary elements on a half-space, the "
        "finest grid. A loaded end has no highest pressure, and its curve ends where the plot "
        "does.",
    )  # fmt: skip


def half_space(context: Context, name: str, key: str = "", colour: int = 4) -> Curve:
    """Some of the half-space's pressures on the finest grid, of the solution `key`."""
    arrays = context.fem[-1].arrays
    y, p = arrays[f"{key}y"], arrays[f"{key}p"]
    some = np.unique(np.round(np.linspace(0, len(y) - 1, DOTS)).astype(int))
    return Curve(name=name, x=y[some] / mm, y=p[some] / MPa, style="dots", colour=colour)


def over(found: Sequence[Strips], x: Array, even: Sequence[float]) -> list[Curve]:
    """Peaks over `even` pressures: a line while the ends carry nothing, dots where one does."""
    p = np.array([float(f.peak) / e for f, e in zip(found, even, strict=True)])
    loaded = np.array([bool(f.carries[0] or f.carries[-1]) for f in found])
    parts = (("this crown, its ends free", ~loaded, "line"),
             ("this crown, an end loaded", loaded, "dots"))  # fmt: skip
    return [
        Curve(name=name, x=x[some], y=p[some], style=style)
        for name, some, style in parts if some.any()
    ]  # fmt: skip


def profile(q: Any) -> Figure:
    """The gap along the roller before loading."""
    y = np.linspace(-q.L / 2, q.L / 2, 401)
    return Curves(
        title="Gap before loading, at x = 0", x_label="y [mm]", y_label="z [µm]",
        curves=(Curve(name="crown" + (" and tilt" if isinstance(q, TiltedInputs) else ""),
                      x=y / mm, y=q.gap(y) / um),),
        note=f"The straight middle is (1 − K_2) l = {(1 - q.K_2) * q.L / mm:.4g} mm long.",
    )  # fmt: skip


def loads(context: Context) -> Figure:
    """Line load along the roller: what the models make of its ends."""
    q = context.inputs
    curves = []
    for name, words in NAMES.items():
        _, parts = by_strips(q, q.n) if name == "strips" else sliced(q, MODELS[name])
        style, colour = STYLES[name]
        curves.append(Curve(name=words, x=parts.y / mm, y=parts.line / 1e3, style=style,
                            colour=colour))  # fmt: skip
    return Curves(
        title="Line load along the roller", x_label="y [mm]", y_label="q [N/mm]",
        curves=tuple(curves), note=f"Its mean is {q.F / q.L / 1e3:.4g} N/mm.",
        y_top=OVER * max(float(np.sort(c.y)[-5]) for c in curves),
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="patch", data="pressure", symbol="p", unit="MPa", factor=MPa,
                caption=f"Pressure on the patch, along the roller (sideways) and across it, where "
                f"lengths are drawn {STRETCH:.0f} times as long", displacement=""),
    )  # fmt: skip


def centres(q: Roller, n: int) -> Array:
    return slice_centres(length=q.L, slices=n)

"""What the report shows of a line contact: sketches, formulas with numbers, profiles, pictures."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.contact import hertz_line
from verify.cases.contact.line.fem import VIEW
from verify.core.case import Context, Values
from verify.core.figures import (
    Array,
    Dots,
    Equation,
    Figure,
    Picture,
    Profile,
    Refinement,
    Shape,
    Sketch,
)
from verify.core.tex import tex
from verify.judging.profiles import along

MPa, mm, um, kN = 1e6, 1e-3, 1e-6, 1e3
Reference = Callable[[Context, Any], Any]
# x/a of the profile; the slope at the edge is infinite, and the last coarse cell errs most
STATIONS = np.linspace(0.0, 0.85, 18)
SHORT = {"p0": "p_0", "a": "a", "approach": "δ"}


def circle(x: float, y: float, r: float, start: float = 0.0, turn: float = 360.0) -> Array:
    """Points (m, 2) of an arc; angles in degrees from the x axis."""
    t = np.radians(np.linspace(start, start + turn, 73))
    return np.column_stack([x + r * np.cos(t), y + r * np.sin(t)])


def sector(y: float, r: float, *, below: bool = False) -> Array:
    """The quarter x >= 0 of a disc about (0, y) next to the origin, closed."""
    arc = circle(0.0, y, r, 0.0, 90.0) if below else circle(0.0, y, r, -90.0, 90.0)
    return np.vstack([arc, [[0.0, y]]])


def line(*points: tuple[float, float]) -> Array:
    return np.array(points)


def load(y: float, size: float, label: str) -> Shape:
    return Shape(style="load", points=line((0.0, y + size), (0.0, y)), label=label)


def leader(label: str, start: tuple[float, float], end: tuple[float, float]) -> Shape:
    return Shape(style="leader", points=line(start, end), label=label)


def flat_sketch(q: Any) -> Sketch:
    shapes = (
        Shape(style="text", points=line((-2.4, 0.0))),  # room for the labels
        Shape(style="text", points=line((2.6, 0.0))),
        Shape(style="body", points=circle(0.0, 1.0, 1.0)),
        Shape(style="modelled", points=sector(1.0, 1.0)),
        Shape(style="clamp", points=line((-1.4, 0.0), (1.4, 0.0))),
        Shape(style="clamp", points=line((1.4, 2.0), (-1.4, 2.0))),
        Shape(style="axis", points=line((0.0, -0.3), (0.0, 2.3))),
        load(2.15, 0.6, f"F = {q.F:.4g} N"),
        Shape(style="load", points=line((0.0, -0.75), (0.0, -0.15)), label=""),
        leader(f"R = {q.R / mm:.4g} mm", (-1.6, 1.5), (-0.87, 1.5)),
        leader("FE: a quarter", (1.7, 0.8), (0.6, 0.7)),
        leader("rigid flat", (1.8, -0.45), (1.1, 0.0)),
    )
    return Sketch(title=f"roller between rigid flats, {q.L / mm:.4g} mm long", shapes=shapes)


def pair_sketch(q: Any) -> Sketch:
    size = max(q.R_1, q.R_2)
    top, low = max(q.R_1 / size, 0.05), max(q.R_2 / size, 0.05)
    shapes = (
        Shape(style="text", points=line((-2.4, 0.0))),
        Shape(style="text", points=line((2.6, 0.0))),
        Shape(style="body", points=circle(0.0, top, top)),
        Shape(style="body", points=circle(0.0, -low, low)),
        Shape(style="modelled", points=sector(top, top)),
        Shape(style="modelled", points=sector(-low, low, below=True)),
        Shape(style="axis", points=line((0.0, -2 * low - 0.15), (0.0, 2 * top + 0.15))),
        load(2 * top + 0.1, 0.4, f"F = {q.F:.4g} N"),
        Shape(style="load", points=line((0.0, -2 * low - 0.5), (0.0, -2 * low - 0.1))),
        leader(f"R_1 = {q.R_1 / mm:.4g} mm", (-1.3, 1.5 * top + 0.1), (-0.87 * top, 1.5 * top)),
        leader(f"R_2 = {q.R_2 / mm:.4g} mm", (-1.4, -1.5 * low), (-0.87 * low, -1.5 * low)),
        leader("FE: two quarters", (1.5, 0.4), (0.4 * top, 0.8 * top)),
    )
    return Sketch(title=f"two rollers to scale, {q.L / mm:.4g} mm long", shapes=shapes)


def ring_sketch(q: Any) -> Sketch:
    r_i, R = q.r_i / q.r_o, q.R / q.r_o
    force = 2 * R + 0.38  # the upper end of its arrow, with its label above
    half = np.vstack([circle(0, r_i, 1.0, -90, 180), circle(0, r_i, r_i, 90, -180)])
    shapes = (
        Shape(style="text", points=line((-2.0, 0.0))),
        Shape(style="text", points=line((2.2, 0.0))),
        Shape(style="body", points=circle(0.0, r_i, 1.0)),
        Shape(style="hole", points=circle(0.0, r_i, r_i)),
        Shape(style="modelled", points=half),
        Shape(style="body", points=circle(0.0, R, R)),
        Shape(style="modelled", points=sector(R, R)),
        Shape(style="axis", points=line((0.0, r_i - 1.15), (0.0, force))),
        Shape(style="axis", points=line((0.0, force + 0.3), (0.0, r_i + 1.15))),
        load(2 * R + 0.03, 0.35, f"F = {q.F:.4g} N"),
        leader(f"R = {q.R / mm:.4g} mm", (-1.35, R), (-R, R)),
        leader(f"r_i = {q.r_i / mm:.4g} mm", (-1.3, 1.6 * r_i), (-0.78 * r_i, 1.63 * r_i)),
        leader(f"r_o = {q.r_o / mm:.4g} mm, held", (1.25, -0.1), (0.72, r_i - 0.7)),
        leader("FE: half, quarter", (1.25, 1.5), (0.7 * (r_i + 1) / 1.4, r_i + 0.5)),
    )
    return Sketch(title=f"roller in a race, to scale, {q.L / mm:.4g} mm long", shapes=shapes)


def hertz_equations(
    q: Any, v: Values, radius: str, modulus: str, *, symbol: str = "R"
) -> tuple[Equation, ...]:
    """Load per length, half-width, peak pressure, shear; `symbol` is the relative radius."""
    P, R = q.P / 1e3, 1 / q.curvature / mm
    E = 1 / q.softness / MPa
    a, p_0 = v["Hertz a"] / um, v["Hertz p0"] / MPa
    return (
        Equation(tex=radius, numbers=rf"= {tex(R)}\ \mathrm{{mm}}"),
        Equation(tex=modulus, numbers=rf"= {tex(E)}\ \mathrm{{MPa}}", place="plane strain"),
        Equation(
            tex=r"P = \frac{F}{L}",
            numbers=rf"= \frac{{{tex(q.F)}}}{{{tex(q.L / mm)}}} = {tex(P)}\ \mathrm{{N/mm}}",
        ),
        Equation(
            tex=rf"a = \sqrt{{\frac{{4 P {symbol}}}{{\pi E^*}}}}",
            numbers=rf"= \sqrt{{\frac{{4\cdot {tex(P)}\cdot {tex(R)}}}{{\pi\cdot {tex(E)}}}}} "
            rf"= {tex(a)}\ \mathrm{{\mu m}}",
            place="Hertz; behind Eqs. 2-5",
        ),
        Equation(
            tex=r"p_0 = \frac{2 P}{\pi a}",
            numbers=rf"= \frac{{2\cdot {tex(P)}\ \mathrm{{N/mm}}}}"
            rf"{{\pi\cdot {tex(a)}\ \mathrm{{\mu m}}}} "
            rf"= {tex(p_0)}\ \mathrm{{MPa}}",
        ),
        Equation(
            tex=r"\tau_{max} = 0.300\, p_0",
            numbers=rf"= {tex(v['Hertz shear'] / MPa)}\ \mathrm{{MPa}}",
            place="at the depth 0.786 a",
        ),
    )


def flat_equations(q: Any, v: Values) -> Sequence[Equation]:
    P, R, E = q.P / 1e3, q.R / mm, 1 / q.softness / MPa
    a = v["Hertz a"] / um
    return (
        *hertz_equations(q, v, "R", r"E^* = \frac{E}{1 - \nu^2}"),
        Equation(
            tex=r"\delta = \frac{P}{\pi E^*}\left[2 \ln\frac{4 R}{a} - 1\right]",
            numbers=rf"= \frac{{{tex(P)}}}{{\pi\cdot {tex(E)}}}\left[2 \ln\frac{{4\cdot {tex(R)}"
            rf"\ \mathrm{{mm}}}}{{{tex(a)}\ \mathrm{{\mu m}}}} - 1\right] "
            rf"= {tex(v['Hertz approach'] / um)}\ \mathrm{{\mu m}}",
            place="centre of the roller",
        ),
        Equation(
            tex=r"\frac{p_{0,\mathrm{disc}}}{p_0} - 1 = \frac{3}{16}\frac{a^2}{R^2} + \dots",
            numbers=rf"= {tex(3 / 16 * v['a/R'] ** 2, 4)}",
            place="derived",
        ),
    )


def pair_equations(q: Any, v: Values) -> Sequence[Equation]:
    return (
        *hertz_equations(
            q, v, r"\frac{1}{R} = \frac{1}{R_1} + \frac{1}{R_2}\ \Rightarrow\ R",
            r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}\ \Rightarrow\ E^*",
        ),
        Equation(
            tex=r"\delta = \sum_i \frac{P}{\pi E_i'}\left[2 \ln\frac{4 R_i}{a} - 1\right],\quad "
            r"E_i' = \frac{E_i}{1 - \nu_i^2}",
            numbers=rf"\Rightarrow\ \delta = {tex(v['Hertz approach'] / um)}\ \mathrm{{\mu m}}",
            place="centre to centre",
        ),
    )  # fmt: skip


def ring_equations(q: Any, v: Values) -> Sequence[Equation]:
    return (
        *hertz_equations(
            q, v, r"\frac{1}{R'} = \frac{1}{R} - \frac{1}{r_i}\ \Rightarrow\ R'",
            r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}\ \Rightarrow\ E^*",
            symbol="R'",
        ),
        Equation(
            tex=r"\delta = \frac{P}{\pi E_1'}\left[2 \ln\frac{4 R}{a} - 1\right] + "
            r"\frac{2P}{\pi E_2'}\left[\ln\frac{2 r_i}{a} + \frac{1}{2} + s\right],\quad "
            r"E_i' = \frac{E_i}{1 - \nu_i^2}",
            numbers=rf"\Rightarrow\ \delta = {tex(v['Hertz approach'] / um)}\ \mathrm{{\mu m}}",
            place="centre of the roller to the held rim",
        ),
        Equation(
            tex=r"s = \frac{E_2' U_0}{4 r_i} + \sum_{n=1}^{\infty}"
            r"\left(\frac{E_2' U_n}{2 r_i} - \frac{1}{n}\right)",
            place="a pressure cos nθ widens the bore by U_n cos nθ",
        ),
    )  # fmt: skip


def pressure_figure(context: Context, reference: Reference, name: str, note: str) -> Profile:
    """Pressure along the contact with `reference` as its line, over x in micrometres."""
    a, p_0 = context.analytic["Hertz a"], context.analytic["Hertz p0"]
    at = STATIONS * a
    fem = [
        replace(
            r, arrays={"p": np.interp(at, r.arrays["x at vertices"], r.arrays["p at vertices"])}
        )
        for r in context.fem
    ]
    values, u = along(replace(context, fem=fem), "p", formal=1.0, scale=p_0)
    x = np.linspace(0.0, 1.15 * a, 461)
    return Profile(
        title=f"Pressure in the contact beside {name}", x_label="x [µm]", y_label="p [MPa]",
        x=x / um, y=reference(context, x) / MPa, x_fem=at / um, y_fem=values / MPa,
        y_ref=reference(context, at) / MPa, u=u / MPa, scale=p_0 / MPa,
        scale_name="p_0", note=note,
    )  # fmt: skip


def hertz_pressure(context: Context, x: Any) -> Any:
    """Hertz's pressure at x [Pa]."""
    v = context.analytic
    return hertz_line.pressure(x, a=v["Hertz a"], p_0=v["Hertz p0"])


def extrapolated(h: Sequence[float], v: Sequence[float]) -> float:
    """Limit of values that go there with order 2, from the last two meshes."""
    return v[-1] + (v[-1] - v[-2]) / ((h[-2] / h[-1]) ** 2 - 1)


def refinement(context: Context, limits: Mapping[str, float], note: str) -> Refinement:
    """How p_0, a and the approach go to their `limits`, each beside a line of order 2."""
    levels = {key: context.series(key) for key in SHORT}
    return Refinement(
        title="Convergence of p_0, a and δ, each for itself", x_label="cells on the half-width",
        y_label="|FE/limit − 1|", cells=4 / np.array(levels["a"][0]),
        errors=tuple(
            (SHORT[key], np.abs(np.array(v) / limits[key] - 1)) for key, (_, v) in levels.items()
        ),
        order=2.0, note=f"Lines: order 2 through the finest mesh; {note}.",
    )  # fmt: skip


def flat_figures(
    context: Context,
    exact_pressure: Reference,
    neglected: Mapping[str, tuple[list[float], list[float], list[float]]],
) -> Sequence[Figure]:
    """Profiles beside the disc and Hertz, what he neglects over a/R, and convergence."""
    found: list[Figure] = [
        pressure_figure(context, exact_pressure, "the disc",
                        "Line: the disc on its own arc; dots: finest mesh. Below, the difference "
                        "in the band of the whole profile, which ends at 0.85 a."),
    ]  # fmt: skip
    for key, theory, words in (("p0", -3 / 16, "−3/16"), ("a", 1 / 4, "+1/4")):
        eps, d, u = map(np.array, neglected[key])
        x = np.linspace(0.0, eps[-1], 101)
        found.append(
            Profile(
                title=f"What Hertz neglects in {SHORT[key]}", x_label="a/R",
                y_label=f"{SHORT[key]}: Hertz/FE − 1", x=x, y=theory * x**2,
                x_fem=eps, y_fem=d, y_ref=theory * eps**2, u=u, scale=1.0,
                note=f"Line: {words} (a/R)², derived; what is left below is of (a/R)⁴ and of the "
                "meshes, whose band is drawn.",
            )
        )  # fmt: skip
    limits = {key: context.analytic[f"disc {key}"] for key in SHORT}
    return (*found, refinement(context, limits, "the limit is the exact disc"))


def two_body_figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    v = context.analytic
    shown = tuple(
        (f"{symbol}", (v[f"Hertz {key}"] / context.series(key)[1][-1] - 1) * 1e3, None, "formula")
        for key, symbol in SHORT.items()
    )
    limits = {key: extrapolated(*context.series(key)) for key in SHORT}
    return (
        pressure_figure(context, hertz_pressure, "Hertz",
                        "Line: Hertz; dots: finest mesh, in the band of the whole profile, which "
                        "ends at 0.85 a."),
        Dots(title="Hertz against finite elements", label="Hertz/FE − 1 [1/1000]",
             items=(*shown, ("finite elements", 0.0, None, "fe")),
             note="The rows above judge these against what is derived."),
        refinement(context, limits, "the limit extrapolates the last two meshes with it, so that "
                   "the coarser ones tell"),
    )  # fmt: skip


def pictures(q: Any) -> Sequence[Picture]:
    reach = 0.75 * VIEW * q.guess
    below = -reach if hasattr(q, "E_2") else -reach / 20  # a rigid flat has nothing to show
    window = (-reach, below, reach, reach)
    return (
        Picture(field="contact", data="shear", symbol="τ/p_0", unit="1", factor=1.0,
                caption="Largest shear stress in the plane over p_0, cell means: 0.30 at 0.79 a "
                "below the surface", mirror=("x",), displacement="", window=window),
        Picture(field="contact", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                caption="Von Mises stress about the contact, cell means", mirror=("x",),
                displacement="", window=window),
    )  # fmt: skip

"""What the report shows of a ring: sketch, formulas with numbers, profiles, pictures."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.ring import lame
from verify.core.case import Context, Values
from verify.core.figures import Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import factor, tex
from verify.judging.profiles import along

MPa, mm, um = 1e6, 1e-3, 1e-6
ACROSS = 13  # stations over the wall
ASKEW = np.radians(30.0)  # their direction: on no line of the mesh's symmetry


def stations(q: Any) -> Any:
    """Radii (m,) of the profiles [m], both walls included."""
    return np.linspace(q.r_i, q.r_o, ACROSS)


def sketch(q: Any) -> Sketch:
    inner = q.r_i / q.r_o

    def arc(r: float, start: float = 0.0, end: float = 2 * np.pi) -> Any:
        t = np.linspace(start, end, 73)
        return r * np.column_stack([np.cos(t), np.sin(t)])

    def ray(angle: float, r0: float, r1: float) -> Any:
        return np.outer([r0, r1], [np.cos(angle), np.sin(angle)])

    quarter = np.vstack([arc(1.0, 0, np.pi / 2), arc(inner, np.pi / 2, 0)])
    shapes = [
        Shape(style="body", points=arc(1.0)),
        Shape(style="hole", points=arc(inner)),
        Shape(style="modelled", points=quarter),
        Shape(style="axis", points=np.array([[-1.12, 0.0], [1.12, 0.0]])),
        Shape(style="axis", points=np.array([[0.0, -1.12], [0.0, 1.12]])),
    ]
    for angle in np.radians([22.5, 67.5, 112.5, 157.5, 202.5, 247.5, 292.5, 337.5]):
        first = angle == np.radians(22.5)
        inside = ray(angle, inner - 0.2, inner)
        outside = ray(angle, 1.2, 1.0)
        if q.p_i:
            at = inside if q.p_i > 0 else inside[::-1]
            shapes.append(Shape(style="load", points=at, label="p_i" if first else ""))
        if q.p_o:
            at = outside if q.p_o > 0 else outside[::-1]
            shapes.append(Shape(style="load", points=at, label="p_o" if first else ""))
    for name, r, angle, at in (("r_o", q.r_o, 140, 1.0), ("r_i", q.r_i, 217, inner)):
        start, end = ray(np.radians(angle), 1.32, at)
        label = f"{name} = {r / mm:.4g} mm"
        shapes.append(Shape(style="leader", points=np.array([start, end]), label=label))
    shapes.append(
        Shape(style="leader", points=np.array([[1.18, 0.98], [0.75, 0.52]]), label="FE: a quarter")
    )
    pushed = [f"{p / MPa:.4g} MPa {where}" for p, where in
              ((q.p_i, "in the bore"), (q.p_o, "on the rim")) if p]  # fmt: skip
    title = f"ring under {' and '.join(pushed)}; symmetry on both cuts of the quarter"
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    r_i, r_o = tex(q.r_i / mm), tex(q.r_o / mm)
    p_i, p_o = factor(q.p_i / MPa), factor(q.p_o / MPa)
    A = (q.p_i * q.r_i**2 - q.p_o * q.r_o**2) / (q.r_o**2 - q.r_i**2) / MPa
    B = (q.p_i - q.p_o) * q.r_i**2 * q.r_o**2 / (q.r_o**2 - q.r_i**2) / MPa / mm**2
    walls = rf"{r_o}^2 - {r_i}^2"
    ring, bore = B / (q.r_i / mm) ** 2, q.r_i / mm
    stress, moved = v["bore hoop stress"] / MPa, v["bore displacement, plane stress"] / mm
    return (
        Equation(
            tex=r"A = \frac{p_i r_i^2 - p_o r_o^2}{r_o^2 - r_i^2}",
            numbers=rf"= \frac{{{p_i}\cdot {r_i}^2 - {p_o}\cdot {r_o}^2}}{{{walls}}} "
            rf"= {tex(A)}\ \mathrm{{MPa}}",
            place="Lamé; behind Eq. 6",
        ),
        Equation(
            tex=r"B = \frac{(p_i - p_o)\, r_i^2 r_o^2}{r_o^2 - r_i^2}",
            numbers=rf"= \frac{{({p_i} - {p_o})\cdot {r_i}^2\cdot {r_o}^2}}{{{walls}}} "
            rf"= {tex(B)}\ \mathrm{{N}}",
        ),
        Equation(
            tex=r"\sigma_\theta(r_i) = A + \frac{B}{r_i^2}",
            numbers=rf"= {tex(A)} + {factor(ring)} = {tex(stress)}\ \mathrm{{MPa}}",
        ),
        Equation(
            tex=r"u_r(r_i) = \frac{1}{E}\left[(1-\nu) A r_i + (1+\nu)\frac{B}{r_i}\right]",
            numbers=rf"= \frac{{1}}{{{tex(q.E / MPa)}}}\left[{tex(1 - q.nu)}\cdot {factor(A)}\cdot "
            rf"{tex(bore)} + {tex(1 + q.nu)}\cdot\frac{{{tex(B)}}}{{{tex(bore)}}}\right] "
            rf"= {tex(moved)}\ \mathrm{{mm}}",
            place="plane stress",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    """Lamé's stresses and displacement over the wall, with finite elements on them."""
    if not context.converging:
        return ()
    q = context.inputs
    loads = {"r_i": q.r_i, "r_o": q.r_o, "p_i": q.p_i, "p_o": q.p_o}
    fine, at = np.linspace(q.r_i, q.r_o, 81), stations(q)
    radial, hoop = lame.stresses(fine, **loads)
    radial_at, hoop_at = lame.stresses(at, **loads)
    plain = {"E": q.E, "nu": q.nu, "ends": "plane strain", **loads}
    u, u_at = (lame.radial_displacement(r, **plain) for r in (fine, at))
    shown = (
        ("hoop stress", "σ_θ [MPa]", hoop, hoop_at, MPa, context.analytic["stress scale"], 2.0),
        ("radial stress", "σ_r [MPa]", radial, radial_at, MPa, context.analytic["stress scale"], 2),
        ("radial displacement", "u_r [µm]", u, u_at, um,
         context.analytic["displacement scale, plane strain"], 3.0),
    )  # fmt: skip
    return tuple(
        _profile(context, name, label, fine, curve, at, reference, factor, scale, formal)
        for name, label, curve, reference, factor, scale, formal in shown
    )


def _profile(
    context: Context, name: str, label: str, fine: Any, curve: Any, at: Any, reference: Any,
    factor: float, scale: float, formal: float,
) -> Profile:  # fmt: skip
    values, u = along(context, f"profile, {name}", formal=formal, scale=scale)
    return Profile(
        title=f"{name.capitalize()} across the wall, plane strain", x_label="r [mm]",
        y_label=label, x=fine / mm, y=curve / factor, x_fem=at / mm, y_fem=values / factor,
        y_ref=reference / factor, u=u / factor, scale=scale / factor,
        note="Points on a radius at 30°; below, what is left when the formula is taken away, in "
        "the band of the profile's own tolerance.",
    )  # fmt: skip


def pictures(_: Any) -> Sequence[Picture]:
    return (
        Picture(field="plane strain", data="hoop_stress", symbol="σ_θ", unit="MPa", factor=MPa,
                caption="Hoop stress, plane strain, cell means", mirror=("x", "y")),
        Picture(field="plane strain", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                caption="Von Mises stress, plane strain, cell means", mirror=("x", "y")),
    )  # fmt: skip

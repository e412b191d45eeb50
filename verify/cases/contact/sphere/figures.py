"""What the report shows of spheres in contact: sketch, formulas with numbers, profiles."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.contact import hertz_point
from verify.cases.contact.sphere.fem import ACROSS, DEEP, VIEW
from verify.core.case import Context, Values
from verify.core.figures import Dots, Equation, Figure, Picture, Profile, Shape, Sketch
from verify.core.tex import tex
from verify.judging.profiles import along

MPa, mm, um, GPa = 1e6, 1e-3, 1e-6, 1e9


def sketch(q: Any) -> Sketch:
    """Both spheres to scale; where one is far larger, the part of it next to the contact."""
    r, R = 1.0, q.R_2 / q.R_1
    t = np.linspace(0, 2 * np.pi, 145)
    ball = np.column_stack([r * np.sin(t), r + r * np.cos(t)])
    arc = t[36:73]
    quarter = np.vstack([[[0.0, r]], np.column_stack([r * np.sin(arc), r + r * np.cos(arc)])])
    turn = np.arcsin(min(1.0, 1.6 / R))
    cap = np.linspace(-turn, turn, 61)
    deep = min(R, 1.7)
    lower = np.column_stack([R * np.sin(cap), R * (np.cos(cap) - 1)])
    lower = np.vstack([lower, [[lower[-1, 0], -deep], [lower[0, 0], -deep]]])
    right = max(float(lower[:, 0].max()), r)
    shapes = [
        Shape(style="body", points=lower),
        Shape(style="body", points=ball),
        Shape(style="modelled", points=quarter),
        Shape(style="axis", points=np.array([[0.0, -deep - 0.2], [0.0, 2 * r + 0.6]])),
        Shape(style="axis", points=np.array([[-1.2, r], [1.2, r]])),
        Shape(style="load", label="P", points=np.array([[0.0, 2 * r + 0.55], [0.0, 2 * r]])),
        Shape(style="leader", label=f"R_1 = {q.R_1 / mm:.4g} mm",
              points=np.array([[-1.7, 1.9], [-0.8, 1.6]])),
        Shape(style="leader", label=f"R_2 = {q.R_2 / mm:.4g} mm",
              points=np.array([[-right - 0.5, -deep - 0.25], [-0.6 * right, -0.7 * deep]])),
        Shape(style="leader", label="FE: quarters, turned",
              points=np.array([[1.7, 1.9], [0.45, 0.6]])),
        Shape(style="leader", label=f"a = {q.a('sphere') / mm:.4g} mm",
              points=np.array([[1.7, 0.45], [0.03, 0.01]])),
    ]  # fmt: skip
    title = (
        f"spheres under {q.P:.4g} N, to scale; in a second problem the lower one is a rigid flat"
    )
    return Sketch(title=title, shapes=tuple(shapes))


def equations(q: Any, v: Values) -> Sequence[Equation]:
    hertz = q.hertz("sphere")
    R, E, P = tex(hertz["R"] / mm), tex(hertz["E_star"] / MPa), tex(q.P)
    a, p_0, delta = (v[f"sphere: {key}"] for key in ("a", "p_0", "approach"))
    return (
        Equation(
            tex=r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}",
            numbers=rf"\Rightarrow\ E^* = {E}\ \mathrm{{MPa}},\quad"
            rf" \frac{{1}}{{R}} = \frac{{1}}{{{tex(q.R_1 / mm)}}} + \frac{{1}}{{{tex(q.R_2 / mm)}}}"
            rf"\ \Rightarrow\ R = {R}\ \mathrm{{mm}}",
            place="Hertz",
        ),
        Equation(
            tex=r"a = \left(\frac{3 P R}{4 E^*}\right)^{1/3}",
            numbers=rf"= \left(\frac{{3\cdot {P}\cdot {R}}}{{4\cdot {E}}}\right)^{{1/3}}"
            rf" = {tex(a / mm)}\ \mathrm{{mm}}",
        ),
        Equation(
            tex=r"p_0 = \frac{3 P}{2\pi a^2}",
            numbers=rf"= \frac{{3\cdot {P}}}{{2\pi\cdot {tex(a / mm)}^2}} = {tex(p_0 / MPa)}"
            r"\ \mathrm{MPa}",
        ),
        Equation(
            tex=r"\delta = \frac{a^2}{R}",
            numbers=rf"= \frac{{{tex(a / mm)}^2}}{{{R}}} = {tex(delta / um)}\ \mathrm{{\mu m}}",
        ),
        Equation(
            tex=r"\frac{p_{0,H}}{p_0} - 1 = \frac{\pi\varepsilon}{8},\quad"
            r" \frac{a_H}{a} - 1 = -\frac{\varepsilon}{2\pi},\quad"
            r" \varepsilon = a \sum \frac{(1-2\nu_i)^2}{2(1-\nu_i)}\frac{E^*}{E_i' R_i}",
            numbers=rf"\Rightarrow\ \varepsilon = "
            rf"{tex(2 * np.pi * (v['sphere: a, finite'] / a - 1), 3)}",
            place="first correction for finite spheres",
        ),
    )


def figures(context: Context) -> Sequence[Figure]:
    if not context.converging:
        return ()
    q, v = context.inputs, context.analytic
    return (
        _pressure(context, "flat", "a rigid flat"),
        _pressure(context, "sphere", "the lower sphere"),
        *(
            _stress(context, body, nu, i)
            for body, nu in (("upper", q.nu_1), ("lower", q.nu_2))
            for i in (0, 1)
        ),
        *(_errors(context, pair, v) for pair in ("flat", "sphere")),
    )


def _pressure(context: Context, pair: str, words: str) -> Profile:
    v = context.analytic
    a, p_0 = v[f"{pair}: a"], v[f"{pair}: p_0"]
    fine = np.linspace(0, 1.05 * a, 211)
    values, u = along(context, f"{pair}: p", formal=2.0, scale=p_0)
    return Profile(
        title=f"Contact pressure, the upper sphere on {words}", x_label="r [µm]",
        y_label="p [MPa]", x=fine / um, y=hertz_point.pressure(fine, a=a, p_0=p_0) / MPa,
        x_fem=a * ACROSS / um, y_fem=values / MPa,
        y_ref=hertz_point.pressure(a * ACROSS, a=a, p_0=p_0) / MPa, u=u / MPa, scale=p_0 / MPa,
        scale_name="p_0",
        note="Line: Hertz; dots: finite elements. Near the edge a small change of a is a large one "
        "of p.",
    )  # fmt: skip


def _stress(context: Context, body: str, nu: float, i: int) -> Profile:
    v = context.analytic
    a, p_0 = v["sphere: a"], v["sphere: p_0"]
    fine = np.linspace(0, DEEP[-1] * a, 201)
    name, label = (("Radial", "σ_r [MPa]"), ("Axial", "σ_z [MPa]"))[i]
    values, u = along(context, f"sphere: {body} axis", formal=2.0, scale=p_0)
    own = slice(i * DEEP.size, (i + 1) * DEEP.size)
    curve, at = (hertz_point.axis_stresses(z, a=a, p_0=p_0, nu=nu)[i] for z in (fine, a * DEEP))
    return Profile(
        title=f"{name} stress on the axis of the {body} sphere, on each other",
        x_label="depth [µm]", y_label=label, x=fine / um, y=curve / MPa, x_fem=a * DEEP / um,
        y_fem=values[own] / MPa, y_ref=at / MPa, u=u[own] / MPa, scale=p_0 / MPa,
        scale_name="p_0", neglects=True,
        note="Line: half space under Hertz's pressure; the band is that of finite elements alone.",
    )  # fmt: skip


def _errors(context: Context, pair: str, v: Values) -> Dots:
    """Hertz and the first correction against finite elements."""
    items: list[tuple[str, float, float | None, str]] = []
    for key, words in (("a", "a"), ("p_0", "p_0"), ("approach", "δ")):
        fe = context.series(f"{pair}: {key}")[1][-1]
        for label, suffix in (("Hertz", ""), ("first correction", ", finite")):
            error = (v[f"{pair}: {key}{suffix}"] / fe - 1) * 1e4
            items.append((f"{words}, {label}", error, None, "formula"))
    items.append(("finite elements", 0.0, None, "fe"))
    where = "on a rigid flat" if pair == "flat" else "on the lower sphere"
    return Dots(
        title=f"What Hertz neglects, the upper sphere {where}",
        label="formula / FE − 1 [1/10 000]",
        items=tuple(items),
        note="The correction is of first order in a/R; what is left is mesh and second order.",
    )


def pictures(q: Any) -> Sequence[Picture]:
    reach = VIEW * q.a("sphere") * 0.65
    window = (-reach, -reach, reach, reach)
    return tuple(
        Picture(field="sphere", data=data, symbol=symbol, unit="MPa", factor=MPa, mirror=("x",),
                displacement="", window=window,
                caption=f"{words} about the contact of both spheres, cell means")
        for data, symbol, words in (
            ("von_mises", "σ_v", "Von Mises stress"), ("axial_stress", "σ_z", "Axial stress")
        )
    )  # fmt: skip

"""What the report shows of a race under n sprags: formulas, curves around it, pictures."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from verify.cases.ring.loads import consequence, formulas
from verify.cases.ring.loads.fem import wall_angles
from verify.cases.ring.loads.inputs import LoadsInputs
from verify.core.case import Context, Values
from verify.core.figures import Array, Curve, Curves, Equation, Figure, Picture, Profile, Table
from verify.core.tex import tex
from verify.judging.profiles import along

MPa, mm, um = 1e6, 1e-3, 1e-6
COUNTS = (6, 12, 24)
EDGE = 1.5  # formal order of the largest error, beside the patch
DOTS = 40  # nodes of finite elements in a curve


def equations(q: LoadsInputs, v: Values) -> Sequence[Equation]:
    low, high = q.names
    r_i, r_o, nu = tex(q.r_i / mm), tex(q.r_o / mm), tex(q.nu)
    delta, sign = (r"\delta_{BE}", "+") if q.loaded == "bore" else (r"\delta_{BI}", "-")
    P, E = tex(q.P / 1e3), tex(q.E / MPa)
    wall, a = tex((q.r_o - q.r_i) / mm), tex(v["a"] / um)
    return (
        Equation(
            tex=rf"{delta} = \frac{{N n}}{{2\pi l E}}\left[\frac{{{high[0]}_{{{high[2:]}}}^2 + "
            rf"{low[0]}_{{{low[2:]}}}^2}}{{{high[0]}_{{{high[2:]}}}^2 - {low[0]}_{{{low[2:]}}}^2}}"
            rf" {sign} \nu\right]",
            numbers=rf"= \frac{{{tex(q.F)}\cdot {q.n}}}{{2\pi\cdot {tex(q.L / mm)}\cdot {E}}}"
            rf"\left[\frac{{{r_o}^2 + {r_i}^2}}{{{r_o}^2 - {r_i}^2}} {sign} {nu}\right] "
            rf"= {tex(v['smeared'] / um)}\ \mathrm{{\mu m}}",
            place="Eq. 6",
        ),
        Equation(
            tex=r"p_m = \frac{n P}{\pi r}\,\frac{2 J_1(m a/r)}{m a/r},\quad m = n, 2n, \ldots",
            numbers=rf"P = {P}\ \mathrm{{N/mm}},\ a = {a}\ \mathrm{{\mu m}}",
            place="Fourier ring",
        ),
        Equation(
            tex=r"\delta_H = \frac{2 P}{\pi E}\left[\operatorname{arsinh}\frac{d}{a} - \nu\,"
            r"\frac{d}{d + \sqrt{a^2 + d^2}}\right]",
            numbers=rf"= {tex(v['dent, wall'] / um)}\ \mathrm{{\mu m}}\quad (d = {wall}"
            r"\ \mathrm{mm})",
            place="Hertz's dent, plane stress",
        ),
    )


def around(q: LoadsInputs) -> Array:
    """Angles over half a pitch (m,), dense about the patch and its end."""
    alpha = q.half_width / q.radius * q.n / np.pi
    near = np.linspace(0, min(3 * alpha, 0.9), 40)
    return np.asarray(np.concatenate([near, np.linspace(near[-1], 1, 60)[1:]]))


def figures(context: Context) -> Sequence[Figure]:
    profiles = (_displacement(context), _stresses(context)) if context.converging else ()
    return (_ripple(context), *profiles)


def _ripple(context: Context) -> Curves:
    q = context.inputs
    shares = around(q)
    curves = []
    for k, n in enumerate(sorted({*COUNTS, q.n})):
        if not consequence.fits(q, n):
            continue
        ring = formulas.race(q, n=n)
        u = formulas.outward(q) * ring.at(ring.r, shares * np.pi / n).u_r
        curves.append(
            Curve(name=f"n = {n}", x=shares, y=u / formulas.by_smearing(q, n=n), colour=k)
        )
        if n == q.n and context.fem:
            theta, u_r, _ = _thinned(context, q.loaded)
            curves.append(
                Curve(name=f"FE, n = {n}", x=theta * n / np.pi, style="dots", colour=k,
                      y=formulas.outward(q) * u_r / context.analytic["smeared"])
            )  # fmt: skip
    curves.append(
        Curve(name="smeared, Eq. 6", x=np.array([0.0, 1.0]), y=np.ones(2), style="dashes", colour=5)
    )
    return Curves(
        title=f"Displacement of the {q.loaded} around the race", y_bottom=None,
        x_label="θ n/π, from a load to half-way to the next", y_label="δ over Eq. 6",
        curves=tuple(curves),
        note="Every load as large as here, Eq. 6 with its n. The peak at the left is the dent; "
        "the curves' means over θ are Eq. 6 exactly.",
    )  # fmt: skip


def _thinned(context: Context, wall: str) -> Array:
    """Some nodes (3, m) of a wall on the finest mesh, the first and last among them."""
    nodes = context.fem[-1].arrays[f"{wall} nodes"]
    n = context.inputs.n / np.pi
    wanted = np.linspace(0, 1, DOTS)
    chosen = np.unique(np.searchsorted(nodes[0] * n, wanted).clip(0, nodes.shape[1] - 1))
    return np.asarray(nodes[:, chosen])


def _displacement(context: Context) -> Profile:
    """The loaded wall beyond the patch, with the uncertainty of its finite elements."""
    q, scale = context.inputs, context.analytic["load"]
    ring, sign = formulas.race(q), formulas.outward(q)
    theta = np.linspace(0, np.pi / q.n, 200)
    at = wall_angles(q)
    values, u = along(context, f"{q.loaded} displacement", formal=EDGE, scale=scale)
    return Profile(
        title=f"Displacement of the {q.loaded}, finite elements and Fourier ring",
        x_label="θ n/π", y_label="δ [µm]", x=theta * q.n / np.pi,
        y=sign * ring.at(ring.r, theta).u_r / um, x_fem=at * q.n / np.pi, y_fem=sign * values / um,
        y_ref=sign * ring.at(ring.r, at).u_r / um, u=u / um, scale=scale / um,
        scale_name="the displacement at a load",
    )  # fmt: skip


def _stresses(context: Context) -> Curves:
    """Hoop stress of both walls; of the loaded one beyond the patch."""
    q, ring, fem = context.inputs, formulas.race(context.inputs), context.fem[-1].arrays
    theta, at = around(q) * np.pi / q.n, wall_angles(q)
    curves = []
    for k, (name, r) in enumerate((("bore", q.r_i), ("rim", q.r_o))):
        shown = theta[theta > ring.alpha] if name == q.loaded else theta
        hoop = ring.at(r, shown).sigma_theta
        curves += [
            Curve(name=name, x=shown * q.n / np.pi, y=hoop / MPa, colour=k),
            Curve(name=f"FE, {name}", x=at * q.n / np.pi, y=fem[f"{name} hoop stress"] / MPa,
                  style="dots", colour=k),
        ]  # fmt: skip
    return Curves(
        title="Hoop stress on the walls", x_label="θ n/π", y_label="σ_θ [MPa]",
        curves=tuple(curves), note=f"Lines by the Fourier ring; of the {q.loaded} beyond the "
        "patch, under which the hoop stress is about the pressure.",
    )  # fmt: skip


def tables(context: Context) -> Sequence[Table]:
    return (consequence.table(context),)


def pictures(q: Any) -> Sequence[Picture]:
    view = 12 * q.half_width
    window = (q.radius - view, -view, q.radius + view, view)
    return (
        Picture(field="half a pitch", data="radial_displacement", symbol="u_r", unit="µm",
                factor=um, caption="Radial displacement over a pitch", mirror=("y",)),
        Picture(field="half a pitch", data="von_mises", symbol="σ_v", unit="MPa", factor=MPa,
                caption="Von Mises stress about a load, cell means", mirror=("y",),
                window=window),
    )  # fmt: skip
